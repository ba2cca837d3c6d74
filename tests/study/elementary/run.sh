#!/bin/sh
# run.sh OUT [COUNT]: builds elementary.c with the library of OUT and runs it. Without MPFR it says so and does nothing.
set -eu
out=$(cd "$1" && pwd)
shift
cd "$(dirname "$0")/../../.."
CC=${CC:-cc}
echo '#include <mpfr.h>' | $CC -fsyntax-only -x c - 2>/dev/null || { echo "skipped: there is no mpfr.h (Debian: libmpfr-dev)"; exit 0; }
mkdir -p "$out/bin"
$CC -std=c11 -O2 -ffp-contract=off -Iinclude -Ilib tests/study/elementary/elementary.c "$out/lib/libmuslin.a" -lmpfr -lgmp -lm \
    -o "$out/bin/elementary"
"$out/bin/elementary" "$@"
