#!/bin/sh
# threads.sh OUT FLAGS...: two bodies are dressed at once, each with several threads (threads.c): the same bits. With
# `make config=tsan check-threads` under the thread sanitizer, which must see no race.
set -eu
out=$1
shift
cd "$(dirname "$0")/../.."
mkdir -p "$out/bin"
${CC:-cc} -std=c11 -Iinclude -pthread "$@" tests/guard/threads.c "$out/lib/libmuslin.a" -lm -o "$out/bin/threads"
TSAN_OPTIONS=halt_on_error=1 "$out/bin/threads"
