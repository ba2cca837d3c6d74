#!/bin/sh
# carried.sh LIBFOLDER: what five programs carry of muslin, linked static and stripped: bytes, and from which rooms.
#
# The programs stand in tests/guard/carried. The link map names the members of the archives that went in. Bytes are those
# of the stripped program (the C library and outside libraries stay shared). A program that steps a sheet of cloth alone
# may have at most SHEET_MOST bytes.
set -eu
lib=$(cd "$1" && pwd)
cd "$(dirname "$0")/../.."
CC=${CC:-cc}
SHEET_MOST=${SHEET_MOST:-307200}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
outside=$(pkg-config --libs cairo pangocairo jansson yaml-0.1 expat sqlite3)
status=0
printf '%-10s %10s  %s\n' program bytes rooms
for source in tests/guard/carried/*.c; do
    name=$(basename "$source" .c)
    # shellcheck disable=SC2086
    $CC -O2 -std=c11 -Iinclude -ffunction-sections -fdata-sections "$source" "$lib/libmuslin-print.a" "$lib/libmuslin-exchange.a" \
        "$lib/libmuslin-catalogue.a" "$lib/libmuslin.a" -Wl,--gc-sections -Wl,--as-needed -Wl,-Map="$scratch/$name.map" \
        -s $outside -lm -pthread -o "$scratch/$name"
    rooms=$(grep -oE 'libmuslin[a-z-]*\.a\([a-z0-9_]+\.o\)' "$scratch/$name.map" | sed 's/.*(\(.*\)\.o)/\1/' | sort -u |
        while read -r member; do ls lib/*/"$member".c; done | cut -d/ -f2 | sort | uniq -c | awk '{ printf "%s%s %d", sep, $2, $1; sep = ", " }')
    bytes=$(wc -c <"$scratch/$name")
    printf '%-10s %10d  %s\n' "$name" "$bytes" "$rooms"
    if [ "$name" = sheet ] && [ "$bytes" -gt "$SHEET_MOST" ]; then
        echo "a program that steps a sheet of cloth has $bytes bytes, at most $SHEET_MOST"
        status=1
    fi
done
exit $status
