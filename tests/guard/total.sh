#!/bin/sh
# total.sh OUT PYTHON: every test of the house: C tests, Python tests, guards. The last line counts them all.
#
# A check of a C suite, a Python test and a guard count one each. Skipped Python tests are counted apart, and each test
# that skips says why. Exit 0 only when nothing failed.
set -u
out=$(cd "$1" && pwd)
python=$2
cd "$(dirname "$0")/../.."
log=$out/check
mkdir -p "$log"
passed=0
failed=0

case ${MUSLIN_DATA:=../shared/data} in /*) ;; *) MUSLIN_DATA=$PWD/$MUSLIN_DATA ;; esac
export MUSLIN_DATA
export MUSLIN_BIN="$out/bin" MUSLIN_LIB="$out/lib/libmuslin.so" PYTHONPATH="$PWD/bindings/python" PYTHONDONTWRITEBYTECODE=1

# a locale whose decimal point is a comma: no file may change under it
if [ ! -d "$out/locale/de_DE.UTF-8" ] && command -v localedef >/dev/null 2>&1; then
    mkdir -p "$out/locale"
    localedef -i de_DE -f UTF-8 "$out/locale/de_DE.UTF-8"
fi
[ -d "$out/locale/de_DE.UTF-8" ] && export LOCPATH="$out/locale"

# ---- Python begins beside the C tests, on what they leave of the cores ----

"$python" -m pytest -q -rs -p no:cacheprovider tests >"$log/python.log" 2>&1 &
python_tests=$!

# ---- C: "97%: Checks: 100, Failures: 2, Errors: 1"; the exit code is the judge ----

CK_TIMEOUT_MULTIPLIER=4 sh tests/guard/shards.sh "$out/bin/tests" "$log" >"$log/c.log" 2>&1
code=$?
cat "$log/c.log"
counts=$(sed -n 's/^[0-9]*%: Checks: \([0-9]*\), Failures: \([0-9]*\), Errors: \([0-9]*\)$/\1 \2 \3/p' "$log/c.log" | tail -n 1)
set -- ${counts:-0 0 0}
passed=$((passed + $1 - $2 - $3))
failed=$((failed + $2 + $3))
if [ "$code" -ne 0 ] && [ $(($2 + $3)) -eq 0 ]; then
    echo "the C tests ended with $code"
    failed=$((failed + 1))
fi

# ---- Python: "3 failed, 20 passed, 1 skipped in 4.2s" ----

wait "$python_tests"
code=$?
cat "$log/python.log"
last=$(tail -n 1 "$log/python.log")
count() { n=$(printf '%s\n' "$last" | sed -n "s/.*\b\([0-9][0-9]*\) $1.*/\1/p"); echo "${n:-0}"; }
passed=$((passed + $(count passed)))
bad=$(($(count failed) + $(count error)))
[ "$code" -ne 0 ] && [ "$bad" -eq 0 ] && bad=1
failed=$((failed + bad))

# ---- guards ----

guard() # NAME COMMAND...
{
    name=$1
    shift
    if "$@" >"$log/$name.log" 2>&1; then
        passed=$((passed + 1))
        grep '^skipped' "$log/$name.log"
        echo "guard $name: passed"
    else
        failed=$((failed + 1))
        head -n 40 "$log/$name.log"
        echo "guard $name: failed"
    fi
}

guard includes "$python" tests/guard/includes.py
guard size "$python" tests/guard/size.py
guard house "$python" tests/guard/house.py "$out" --check
guard panel_names "$python" tests/guard/panel_names.py
guard circles "$python" tests/guard/circles.py "$out"
guard carried sh tests/guard/carried.sh "$out/lib"
guard headers sh tests/guard/headers.sh
guard symbols sh tests/guard/symbols.sh "$out/lib"
guard own_math sh tests/guard/own_math.sh "$out/lib"
guard sizes sh tests/guard/sizes.sh "$out"
guard linked sh tests/guard/linked.sh "$out/lib"
guard names sh tests/guard/names.sh
guard fastmath sh tests/guard/fastmath.sh
guard flags sh tests/guard/flags.sh
guard hardened sh tests/guard/hardened.sh "$out"
guard setters "$python" tests/guard/setters.py
guard calls "$python" tests/guard/calls.py
guard attack "$python" tests/guard/attack.py
guard man "$python" tests/guard/man.py "$out/lib"
guard embed sh tests/embed/run.sh "$out"

echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
