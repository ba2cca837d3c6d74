#!/bin/sh
# shards.sh PROGRAM LOGS: the C tests by as many processes as there are cores, each with every n-th suite.
#
# Prints what each said, without its list of suites, and as the last line "100%: Checks: N, Failures: N, Errors: N" of
# all. Suites share nothing but the temporary folder, where each test has names of its own. Exit 0 only when all passed.
set -u
program=$1
logs=$2
jobs=$(nproc 2>/dev/null || echo 2)
shards=$((16 * jobs))
mkdir -p "$logs"
rm -f "$logs"/shard-*

seq 0 $((shards - 1)) | xargs -P "$jobs" -I{} sh -c \
    'MUSLIN_SHARD=$1/$2 "$3" >"$4/shard-$1.log" 2>&1; echo $? >"$4/shard-$1.code"' shard {} "$shards" "$program" "$logs"
for log in "$logs"/shard-*.log; do cat "$log"; echo; done | grep -vE '^ |^Running|^[0-9]*%: Checks|^$'
sed -n 's/^[0-9]*%: Checks: \([0-9]*\), Failures: \([0-9]*\), Errors: \([0-9]*\)$/\1 \2 \3/p' "$logs"/shard-*.log |
    awk '{ n += $1; f += $2; e += $3 }
         END { p = n > 0 ? 100 * (n - f - e) / n : 0; printf "%d%%: Checks: %d, Failures: %d, Errors: %d\n", p, n, f, e }'
[ "$(cat "$logs"/shard-*.code | grep -c '^0$')" -eq "$shards" ]
