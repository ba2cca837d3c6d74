#!/bin/sh
# omit.sh OUT [OPTION...]: the libraries without a module (OPTION: a name as OMIT takes it, or several with "+"), and the
# C tests of what is left.
#
# For each option `make OMIT=...` links the shared libraries without an open end, a call of what was left out does not
# link, and every test file runs that does not call it itself (with RUN="OPTION ..." those of the options named alone). Objects are those of OUT/obj: no file is compiled
# differently, so leaving a module out cannot change another. PARTS are the objects and archives that tests share. The
# last line counts the options.
set -u
out=$(cd "$1" && pwd)
shift
[ $# -gt 0 ] || set -- print exchange catalogue layout design integrate drape cloth scan manifold pattern body pattern+body+integrate \
    print+exchange+design
cd "$(dirname "$0")/../.."
CC=${CC:-cc}
PKG_CONFIG=${PKG_CONFIG:-pkg-config}
passed=0
failed=0

# one function of each module: a program that calls it must not link without the module
call_of()
{
    case $1 in
    print) echo "mus_sheet_create -lmuslin-print" ;;
    exchange) echo "mus_tape_read -lmuslin-exchange" ;;
    catalogue) echo "mus_catalogue_open -lmuslin-catalogue" ;;
    layout) echo "mus_layout_create" ;;
    design) echo "mus_design_draft" ;;
    integrate) echo "mus_integrate" ;;
    drape) echo "mus_drape_create" ;;
    cloth) echo "mus_cloth_create" ;;
    pattern) echo "mus_pattern_create" ;;
    scan) echo "mus_body_create_scan" ;;
    manifold) echo "mus_manifold_create" ;;
    body) echo "mus_body_create" ;;
    esac
}

symbols_needed() { nm -u "$@" 2>/dev/null | awk '$1 == "U" && $2 ~ /^mus_/ { print $2 }' | sort -u; }
symbols_given() { nm -g --defined-only "$@" 2>/dev/null | awk 'NF == 3 && $3 ~ /^mus_/ { print $3 }' | sort -u; }

# names that parts define which call, themselves or by another part, what no archive has
symbols_spoiled()
{
    nm -A $PARTS 2>/dev/null | awk -v given="$into/given" '
        BEGIN { while ((getline line < given) > 0) have[line] = 1 }
        {
            at = match($0, /:[^:]*$/)
            part = substr($0, 1, at - 1)
            n = split(substr($0, at + 1), field, " ")
            parts[part] = 1
            if (field[n - 1] == "U") needs[part] = needs[part] " " field[n]
            else if (n == 3 && field[2] ~ /[A-Z]/) owner[field[3]] = part
        }
        END {
            do {
                changed = 0
                for (part in parts) {
                    n = split(needs[part], name, " ")
                    for (i = 1; i <= n && !(part in bad); i++)
                        if ((name[i] ~ /^mus_/ && !(name[i] in have)) || owner[name[i]] in bad) bad[part] = changed = 1
                }
            } while (changed)
            for (symbol in owner) if (owner[symbol] in bad) print symbol
        }' | sort -u
}

# test objects that call nothing but what the archives have, to $into/objects; the others to $into/left
choose()
{
    symbols_given $archives $PARTS >"$into/given"
    symbols_spoiled >"$into/spoiled"
    : >"$into/objects"
    : >"$into/left"
    for source in tests/*/test_*.c; do
        object=$out/obj/${source%.c}.o
        missing=$(symbols_needed "$object" | comm -23 - "$into/given" | head -n 1)
        [ -n "$missing" ] || missing=$(nm -u "$object" | awk '{ print $2 }' | sort -u | comm -12 - "$into/spoiled" | head -n 1)
        if [ -z "$missing" ]; then echo "$object" >>"$into/objects"; else echo "$source: $missing" >>"$into/left"; fi
    done
    { echo '#define SUITES(X) \'; sed 's|.*/test_\(.*\)\.o$|    X(\1) \\|' "$into/objects"; echo; } >"$into/suites.h"
}

link_tests()
{
    # as archives, so that only what is called goes in
    parts=""
    for part in $PARTS; do
        archive=$into/$(basename "$part").a
        case $part in *.a) archive=$part ;; *) ar rcsD "$archive" "$part" ;; esac
        parts="$parts $archive"
    done
    # shellcheck disable=SC2046
    $CC -std=c11 -Iinclude -Itests -I"$into" $($PKG_CONFIG --cflags check) -c tests/main.c -o "$into/main.o" &&
        $CC -pthread "$into/main.o" "$out/obj/tests/support.o" $(cat "$into/objects") -Wl,--start-group $archives \
            $parts -Wl,--end-group \
            $($PKG_CONFIG --libs check cairo pangocairo jansson yaml-0.1 expat sqlite3 libpng) -ldl -lm -o "$into/tests"
}

refused() # MODULE: a call of it does not link
{
    set -- $(call_of "$1")
    printf 'extern void %s(void);\nint main(void) { %s(); return 0; }\n' "$1" "$1" >"$into/call.c"
    ! $CC "$into/call.c" -L"$into/lib" ${2:-} -lmuslin -o "$into/call" 2>/dev/null
}

one() # NAMES, with "+" between them
{
    modules=$(echo "$1" | tr + ' ')
    into=$out/omit-$(echo "$1" | tr + -)
    rm -rf "$into"
    $MAKE -s OUT="$out" OMIT="$modules" all || return 1
    archives=$(ls "$into"/lib/libmuslin-print.a "$into"/lib/libmuslin-exchange.a "$into"/lib/libmuslin-catalogue.a \
        "$into"/lib/libmuslin.a 2>/dev/null)
    for module in $modules; do
        refused "$module" || { echo "omit $1: a call of $module links all the same"; return 1; }
    done
    case " ${RUN-$1} " in
    *" $1 "*) ;;
    *) echo "omit $1: the libraries link"; return 0 ;;
    esac
    choose
    link_tests || return 1
    "$into/tests" >"$into/tests.log" 2>&1
    code=$?
    echo "omit $1: $(wc -l <"$into/objects") test files of $(ls tests/*/test_*.c | wc -l): $(sed -n '/^[0-9]*%: Checks/p' "$into/tests.log")," \
        "libmuslin.so $(size "$into/lib/libmuslin.so" | awk 'NR == 2 { print $1 + $2 }') bytes"
    [ $code -eq 0 ] || sed -n '/:[FE]:/p' "$into/tests.log" | head -n 20
    return $code
}

for option in "$@"; do
    if one "$option"; then passed=$((passed + 1)); else failed=$((failed + 1)); echo "FAILED: omit $option"; fi
done
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
