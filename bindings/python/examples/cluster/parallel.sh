#!/bin/sh
# parallel.sh LIST FOLDER [N]: a list of garments in N parts by GNU parallel, on this machine or on those that the file
# PARALLEL_HOSTS names (--sshloginfile)
set -eu
parts=${3:-8}
mkdir -p "$2"
seq "$parts" | parallel -q ${PARALLEL_HOSTS:+--sshloginfile "$PARALLEL_HOSTS"} --halt soon,fail=1 \
    muslin dress --batch "$1" --part "{}/$parts" -o "$2/task-{}" --quiet
# every result starts with {"line": NUMBER,
cat "$2"/task-*/results.jsonl | sort -t: -k2,2n >"$2/results.jsonl"
