#!/bin/sh
# fastmath.sh: a build that may reorder sums, forget NaN or fuse multiply-adds ends at the first file, with a sentence
# that says why.
set -eu
cd "$(dirname "$0")/../.."
CC=${CC:-cc}
status=0

compiles() { $CC -std=c11 -Iinclude -Ilib "$@" -fsyntax-only lib/base/status.c 2>&1; }

compiles -O2 || {
    echo "lib/base/status.c does not compile even without the flags"
    status=1
}
fused=""
case $($CC -dM -E -x c /dev/null) in *__clang__*) ;; *__x86_64__*) fused="-mfma -mfma4 -mavx512f" ;; esac
for flag in -ffast-math -ffinite-math-only "-O3 -ffast-math" $fused; do
    if said=$(compiles $flag) || ! printf '%s\n' "$said" | grep -q 'IEEE 754'; then
        echo "$flag is not refused by name: ${said:-it compiles}"
        status=1
    fi
done

# nor does the file that lives of exact rounding alone
if $CC -std=c11 -Iinclude -Ilib -ffast-math -fsyntax-only lib/geom/predicate.c >/dev/null 2>&1; then
    echo "lib/geom/predicate.c compiles with -ffast-math"
    status=1
fi
exit $status
