#!/bin/sh
# ports.sh OUT [NAME...]: libmuslin built for other machines, C libraries and compilers, all without shared libraries;
# each must print the bits of this machine's: the figures of figures.c (tapes, bodies, all designs, steps) and the state
# hashes of hashes.c (200 garments at rest, half of them with self-contact).
#
# NAME, all if none is given: gcc-O0, gcc-O3, clang-O0, clang-O2, clang-O3 (the -O3 with -march=native), musl, wasm32
# (WASI, run by wasmtime or node), aarch64, s390x (big-endian, 64 bit), mips (big-endian, 32 bit) and i686 under
# qemu-user, and x87, which must be refused. A port whose tools are missing is skipped in one line. GARMENTS: how many
# designs of garments.h are dressed (100). JOBS: processes at once. The last line counts the ports.
set -u
out=$1
shift
cd "$(dirname "$0")/../../.."
mkdir -p "$out/ports"
out=$(cd "$out/ports" && pwd)
jobs=${JOBS:-$(nproc 2>/dev/null || echo 1)}
garments=${GARMENTS:-100}
passed=0
failed=0
skipped=0

# NAME COMPILER "FLAGS": a folder of objects, and the programs NAME.figures and NAME.hashes
build()
{
    rm -rf "${out:?}/$1"
    mkdir -p "$out/$1"
    ls lib/*/*.c tests/study/ports/figures.c tests/study/ports/hashes.c | grep -vE '^lib/(file|print|paperfile|cutter|sewing|exchange|meshfile|trade|seam|valentina|catalogue)/' |
        xargs -P "$jobs" -I{} sh -c "$2 -std=c11 -Iinclude -Ilib -ffp-contract=off $3 -c {} \
            -o $out/$1/\$(basename {} .c).o" || return 1
    for program in figures hashes; do
        $2 $3 -static $(ls "$out/$1"/*.o | grep -vE '/(figures|hashes)\.o$') "$out/$1/$program.o" -lm \
            -o "$out/$1.$program" || return 1
    done
}

# NAME "RUNNER": both outputs, the garments shared out over processes, as NAME.txt
run()
{
    rm -f "$out/$1".hashes.[0-9]* "$out/$1.hashes.txt" # of an earlier run
    $2 "$out/$1.figures" >"$out/$1.txt" || return 1
    seq 0 $((4 * jobs - 1)) | xargs -P "$jobs" -I{} sh -c "$2 $out/$1.hashes $garments {} $((4 * jobs)) >$out/$1.hashes.{}" || return 1
    cat "$out/$1".hashes.* | sort >"$out/$1.hashes.txt"
    rm -f "$out/$1".hashes.[0-9]*
    cat "$out/$1.hashes.txt" >>"$out/$1.txt"
}

has() # TOOL...: the first that is missing, if any
{
    for tool in "$@"; do command -v "${tool%% *}" >/dev/null 2>&1 || { echo "$tool"; return; }; done
}

# NAME COMPILER "FLAGS" [RUNNER]
port()
{
    missing=$(has "$2" ${4:+"$4"})
    if [ -n "$missing" ]; then
        skipped=$((skipped + 1))
        echo "$1: skipped: there is no $missing"
    elif ! { build "$1" "$2" "$3" && run "$1" "${4:-}"; } 2>"$out/$1.log"; then
        failed=$((failed + 1))
        echo "$1 ($2 $3): FAILED: it does not build or run; $out/$1.log ends with: $(tail -n 1 "$out/$1.log")"
    else
        other=$(diff "$out/reference.txt" "$out/$1.txt" | grep -c '^>')
        if [ "$other" -eq 0 ]; then passed=$((passed + 1)); else failed=$((failed + 1)); fi
        echo "$1 ($2 $3): $(wc -l <"$out/$1.txt") lines, $(wc -l <"$out/$1.hashes.txt") of them hashes, $other differ"
    fi
}

# NAME COMPILER "FLAGS": a machine that rounds otherwise is told so at the first file
refused()
{
    said=$($2 -std=c11 -Iinclude -Ilib $3 -fsyntax-only lib/base/status.c 2>&1)
    if [ -n "$(has "$2")" ]; then
        skipped=$((skipped + 1))
        echo "$1: skipped: there is no $2"
    elif printf '%s\n' "$said" | grep -q 'IEEE 754'; then
        passed=$((passed + 1))
        echo "$1 ($2 $3): refused when compiled, as it must be"
    else
        failed=$((failed + 1))
        echo "$1 ($2 $3): FAILED: not refused: $said"
    fi
}

{ build reference "${CC:-cc}" "-O2 -pthread" && run reference ""; } || {
    echo "the reference does not build or run"
    exit 1
}

wasm=wasmtime
[ -z "$(has wasmtime)" ] || wasm="node --no-warnings tests/study/ports/wasi.mjs"
[ $# -gt 0 ] || set -- gcc-O0 gcc-O3 clang-O0 clang-O2 clang-O3 musl wasm32 aarch64 s390x mips i686 x87
for name in "$@"; do
    case $name in
    gcc-O0 | clang-O0 | clang-O2) port "$name" "${name%-*}" "-${name#*-} -pthread" ;;
    gcc-O3) port gcc-O3 gcc "-O3 -march=native -mno-fma -mno-fma4 -mno-avx512f -pthread" ;;
    clang-O3) port clang-O3 clang "-O3 -march=native -pthread" ;;
    musl) port musl musl-gcc "-O2" ;;
    wasm32) port wasm32 clang "--target=wasm32-wasi -O2 -Wl,-z,stack-size=4194304 -Itests/study/ports/wasi" "$wasm" ;;
    aarch64) port aarch64 aarch64-linux-gnu-gcc "-O2 -pthread" qemu-aarch64 ;;
    # its gcc keeps float sums in double unless told not to: the same in double, other last digits in float
    s390x) port s390x s390x-linux-gnu-gcc "-O2 -pthread -fexcess-precision=fast" qemu-s390x ;;
    mips) port mips mips-linux-gnu-gcc "-O2 -pthread" qemu-mips ;;
    i686) port i686 i686-linux-gnu-gcc "-O2 -pthread -msse2 -mfpmath=sse" qemu-i386 ;;
    x87) refused x87 i686-linux-gnu-gcc "-O2 -mfpmath=387" ;;
    *)
        echo "ports.sh: $name is unknown"
        failed=$((failed + 1))
        ;;
    esac
done
echo "$passed passed, $failed failed, $skipped skipped"
[ "$failed" -eq 0 ]
