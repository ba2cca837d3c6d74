#!/bin/sh
# self_off.sh OUT [ROUNDS]: what cloth on cloth costs a drape that does not ask for it: nothing.
#
# The steps of lib/sim are compiled again with -DMUS_WITHOUT_SELF, which leaves every mention of it out of them, and
# tests/guard/self_off.c is linked to both libraries. The two run in turns, ROUNDS times (9): states must be the same
# to the bit, and the medians of CPU time within 1 %.
set -u
out=$(cd "$1" && pwd)
rounds=${2:-9}
cd "$(dirname "$0")/../.."
CC=${CC:-cc}
into=$out/self-off
mkdir -p "$into"
flags='-std=c11 -Iinclude -Ilib -fPIC -pthread -ffunction-sections -fdata-sections -O2 -ffp-contract=off'
for kernel in f32 f64; do
    $CC $flags -O3 -fno-math-errno -DMUS_WITHOUT_SELF -c "lib/sim/sim_$kernel.c" -o "$into/sim_$kernel.o" || exit 1
    $CC $flags -O3 -fno-math-errno -c "lib/sim/sim_$kernel.c" -o "$into/with_$kernel.o" || exit 1
done
$CC $flags -c tests/guard/self_off.c -o "$into/main.o" || exit 1
$CC -pthread "$into/main.o" "$into/with_f32.o" "$into/with_f64.o" "$out/lib/libmuslin.a" -lm -o "$into/with" || exit 1
$CC -pthread "$into/main.o" "$into/sim_f32.o" "$into/sim_f64.o" "$out/lib/libmuslin.a" -lm -o "$into/without" ||
    exit 1
: > "$into/with.txt"
: > "$into/without.txt"
i=0
while [ "$i" -lt "$rounds" ]; do
    "$into/with" >> "$into/with.txt" || exit 1
    "$into/without" >> "$into/without.txt" || exit 1
    i=$((i + 1))
done
hashes=$(cut -d' ' -f1-3 "$into/with.txt" "$into/without.txt" | sort -u | wc -l)
middle() { cut -d' ' -f4 "$1" | sort -n | sed -n "$((rounds / 2 + 1))p"; }
with=$(middle "$into/with.txt")
without=$(middle "$into/without.txt")
echo "$with $without $hashes" | awk '{
    printf "cloth on cloth, off: %s; steps %.2f ms with it in the build, %.2f ms without, ratio %.4f\n",
           $3 == 1 ? "the same bits" : "OTHER BITS", 1e3 * $1, 1e3 * $2, $1 / $2
    good = $3 == 1 && $1 <= 1.01 * $2
    print (good ? 1 : 0) " passed, " (good ? 0 : 1) " failed"
    exit good ? 0 : 1
}'
