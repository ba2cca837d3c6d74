#!/bin/sh
# ports.sh OUT [NAME...]: libmuslin built for other machines and by other compilers, and the figures of figures.c held
# against those of this machine's. Programs of other machines run under qemu-user.
#
# NAME: O0, O3, clang, clang-O3, i686, x87 (which must be refused), s390x (big-endian, 64 bit), mips (big-endian, 32 bit); all if none
# is given. The last line counts them.
set -u
out=$1
shift
cd "$(dirname "$0")/../../.."
mkdir -p "$out/ports"
out=$(cd "$out/ports" && pwd)
PYTHON=${PYTHON:-/usr/bin/python3}
jobs=$(nproc 2>/dev/null || echo 1)
passed=0
failed=0

# NAME COMPILER "FLAGS": a folder of objects and a program without shared libraries
build()
{
    mkdir -p "$out/$1"
    ls lib/*/*.c tests/study/ports/figures.c | grep -vE '^lib/(file|print|exchange|trade|catalogue)/' |
        xargs -P "$jobs" -I{} sh -c "$2 -std=c11 -Iinclude -Ilib -pthread -ffp-contract=off $3 -c {} \
            -o $out/$1/\$(basename {} .c).o" &&
        $2 $3 -static -pthread "$out/$1"/*.o -lm -o "$out/$1.bin"
}

# by itself where the machine can, else under the emulator
run() # NAME EMULATOR
{
    "$out/$1.bin" >"$out/$1.txt" 2>"$out/$1.log" || { [ -n "$2" ] && "$2" "$out/$1.bin" >"$out/$1.txt"; }
}

# NAME COMPILER "FLAGS" EMULATOR
port()
{
    rm -rf "${out:?}/$1"
    if build "$1" "$2" "$3" && run "$1" "$4"; then
        if said=$("$PYTHON" tests/study/ports/compare.py "$out/reference.txt" "$out/$1.txt"); then
            passed=$((passed + 1))
        else
            failed=$((failed + 1))
            said="FAILED: $said"
        fi
    else
        failed=$((failed + 1))
        said="FAILED: it does not build or run"
    fi
    echo "$1 ($2 $3): $said"
}

# NAME COMPILER "FLAGS": a machine that rounds otherwise is told so at the first file
refused()
{
    said=$($2 -std=c11 -Iinclude -Ilib $3 -fsyntax-only lib/base/status.c 2>&1)
    if printf '%s\n' "$said" | grep -q 'IEEE 754'; then
        passed=$((passed + 1))
        echo "$1 ($2 $3): refused when compiled, as it must be"
    else
        failed=$((failed + 1))
        echo "$1 ($2 $3): FAILED: not refused: $said"
    fi
}

build reference "${CC:-cc}" -O2 && "$out/reference.bin" >"$out/reference.txt" || {
    echo "the reference does not build or run"
    exit 1
}

[ $# -gt 0 ] || set -- O0 O3 clang clang-O3 i686 x87 s390x mips
for name in "$@"; do
    case $name in
    O0) port O0 "${CC:-cc}" -O0 "" ;;
    O3) port O3 "${CC:-cc}" -O3 "" ;;
    clang) port clang clang -O2 "" ;;
    clang-O3) port clang-O3 clang -O3 "" ;;
    i686) port i686 i686-linux-gnu-gcc "-O2 -msse2 -mfpmath=sse" qemu-i386 ;;
    x87) refused x87 i686-linux-gnu-gcc "-O2 -mfpmath=387" ;;
    # its gcc keeps float sums in double unless told not to: the same in double, other last digits in float
    s390x) port s390x s390x-linux-gnu-gcc "-O2 -fexcess-precision=fast" qemu-s390x ;;
    mips) port mips mips-linux-gnu-gcc -O2 qemu-mips ;;
    *)
        echo "ports.sh: $name is unknown"
        failed=$((failed + 1))
        ;;
    esac
done
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
