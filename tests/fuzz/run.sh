#!/bin/sh
# run.sh OUT SECONDS [TARGET...]: the fuzz targets under libFuzzer, with ASan and UBSan, SECONDS of CPU time each (a busy
# machine takes longer; all targets if none is given). Each line: CPU seconds, executions, edges that were covered,
# findings. Memory is bounded to 2 GB, an input to 10 s of CPU time and 300 s by the clock. New inputs stay in
# OUT/fuzz/NAME, findings in OUT/fuzz/found; a finding is mended, and its input becomes a seed in tests/fuzz/seeds/NAME.
# Needs clang and its runtime; without them, it says so. SQLITE=sqlite3.c, the amalgamation (of sqlite.org, or of the
# crate libsqlite3-sys): SQLite is built of it with the same sanitizers and counters, in place of the system's library.
set -u
out=$1
seconds=$2
shift 2
cd "$(dirname "$0")/../.."
sh tests/guard/packages.sh fuzz || true
command -v clang >/dev/null 2>&1 || { echo "skipped: there is no clang (Debian: clang)"; exit 0; }
echo 'int LLVMFuzzerTestOneInput(const char *b, unsigned long n) { return b == 0 && n > 0; }' |
    clang -fsanitize=fuzzer,address -x c - -o /dev/null 2>/dev/null ||
    { echo "skipped: clang has no libFuzzer (Debian: libclang-rt-dev)"; exit 0; }
all=$(sed -n 's/^    X(\([a-z]*\), .*/\1/p' tests/fuzz/fuzz.h)
[ $# -gt 0 ] || set -- $all
mkdir -p "$out/fuzz/found"
build=$(cd "$out/fuzz" && pwd)
archives="$build/lib/libmuslin-print.a $build/lib/libmuslin-exchange.a $build/lib/libmuslin-catalogue.a $build/lib/libmuslin.a"
command=$(ls examples/command/*.c examples/render/*.c | grep -v '/main\.c$' | sed "s|\(.*\)c$|$build/obj/\1o|")
flags="-g -O1 -fno-omit-frame-pointer -fsanitize=address,undefined -fno-sanitize-recover=undefined"
MAKEFLAGS= make -s -j"${JOBS:-2}" V=0 config=sanitize CC="${FUZZ_CC:-clang}" OUT="$build" CFLAGS='-fsanitize=fuzzer-no-link -Wno-pass-failed' $archives $command || exit 1
rm -f "$build/command.a"
ar rcsD "$build/command.a" $command
sqlite=-lsqlite3
if [ -n "${SQLITE:-}" ]; then
    sqlite=$build/sqlite3.o
    [ "$sqlite" -nt "$SQLITE" ] || clang $flags -w -fsanitize=fuzzer-no-link -DSQLITE_THREADSAFE=1 -DSQLITE_DEFAULT_MEMSTATUS=0 \
        -DSQLITE_OMIT_LOAD_EXTENSION -c "$SQLITE" -o "$sqlite" || exit 1
fi
# what a target writes need not reach a disk: waiting for one is no CPU time
[ -n "${TMPDIR:-}" ] || [ ! -d /dev/shm ] || export TMPDIR=/dev/shm
failed=0
for target in "$@"; do
    case " $(echo $all) " in *" $target "*) ;; *) echo "run.sh: $target is no target: $all" >&2; exit 2 ;; esac
    clang -std=c11 $flags -fsanitize=fuzzer -DFUZZ_TARGET=fuzz_"$target" -Iinclude -Iexamples tests/fuzz/entry.c tests/fuzz/fuzz*.c \
        "$build/command.a" $archives $sqlite $(pkg-config --libs cairo pangocairo jansson yaml-0.1 expat libpng) -ldl -lm -pthread -o "$build/$target" || exit 1
    mkdir -p "$build/$target.corpus"
    log=$build/$target.log
    times >"$build/$target.before" # of the shell itself: in a pipeline its children are not counted
    cpu=0
    runs=0
    code=0
    # libFuzzer counts wall time: it is run again for what is left, from the inputs that it has kept
    while [ "$code" -eq 0 ] && [ "$cpu" -lt "$seconds" ]; do
        LSAN_OPTIONS=suppressions=tests/guard/leaks.supp:print_suppressions=0 "$build/$target" \
            -max_total_time=$((seconds - cpu)) -timeout=300 -rss_limit_mb=2048 -max_len=20000 -print_final_stats=1 \
            -artifact_prefix="$build/found/$target-" "$build/$target.corpus" tests/fuzz/seeds/"$target" >"$log" 2>&1
        code=$?
        times >"$build/$target.after"
        cpu=$(cat "$build/$target.before" "$build/$target.after" | tr 'ms' '  ' |
            awk 'NR == 2 { start = $1 * 60 + $2 } NR == 4 { print int($1 * 60 + $2 - start + 0.5) }')
        runs=$((runs + $(sed -n 's/^stat::number_of_executed_units: *//p' "$log" | grep . || echo 0)))
    done
    edges=$(sed -n 's/.* cov: \([0-9]*\) .*/\1/p' "$log" | tail -n 1)
    if [ "$code" -eq 0 ]; then found=none; else
        failed=1
        found=$(grep -m 1 -E 'broken promise|ERROR|runtime error|SUMMARY' "$log")
    fi
    echo "$target: $cpu CPU s, $runs executions, ${edges:-?} edges covered, findings: $found"
done
exit $failed
