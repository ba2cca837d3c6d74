#!/bin/sh
# sizes.sh OUT [write]: bytes of code and constants of each folder of lib/ against tests/guard/sizes.table: at most 2 %
# more than there; and no folder has a byte that can be written (no mutable global).
#
# `make sizes` writes the table anew: a commit that makes a module larger shows by how much. The table holds for one
# major version of one compiler on one machine, which its first line names; elsewhere only the second claim is checked.
set -eu
out=$(cd "$1" && pwd)
mode=${2:-check}
cd "$(dirname "$0")/../.."
table=tests/guard/sizes.table
status=0

# what made the objects: "GNU C11 12 -O2 x86_64"
producer=$(readelf --debug-dump=info "$out/obj/lib/base/status.o" 2>/dev/null | sed -n 's/.*DW_AT_producer.*: //p' | head -n 1)
compiler=$(printf '%s\n' "$producer" | sed -n 's/^\(GNU C11 [0-9]*\)\..*/\1/p')
level=$(printf '%s\n' "$producer" | grep -oE -- '-O[0-3sg]|-fsanitize|--coverage|-fprofile-arcs' | sort -u | tr '\n' ' ')
made="${compiler:-another compiler} ${level}$(uname -m)"

case $level in
*sanitize* | *coverage* | *profile*)
    echo "skipped: sizes of modules: the objects carry the counters of $level"
    exit 0
    ;;
esac

# objects of the sources that there are (a build folder may hold older ones)
objects() # FOLDER
{
    for source in lib/"$1"/*.c; do
        [ ! -e "$out/obj/${source%.c}.o" ] || echo "$out/obj/${source%.c}.o"
    done
}

# folder, bytes
measure()
{
    for folder in $(ls -d lib/*/ | cut -d/ -f2); do
        present=$(objects "$folder")
        [ -z "$present" ] || echo "$folder $(size -A $present |
            awk '/^\.(text|rodata|data\.rel\.ro)/ { sum += $2 } END { print sum + 0 }')"
    done
}

writable=$(for folder in $(ls -d lib/*/ | cut -d/ -f2); do
    for object in $(objects "$folder"); do
        size -A "$object" | awk -v file="${object#"$out"/obj/}" \
            '($1 ~ /^\.t?(bss|data)/ && $1 !~ /^\.data\.rel\.ro/) && $2 > 0 { print file, $1, $2 }'
    done
done)
if [ -n "$writable" ]; then
    echo "data that can be written:"
    echo "$writable"
    status=1
fi

if [ "$mode" = write ]; then
    { echo "# $made: bytes of code and constants of each folder of lib/; made by \`make sizes\`"; measure; } >$table
    cat $table
    exit $status
fi

known=$(sed -n '1s/^# \(.*\): bytes.*/\1/p' $table)
if [ "$made" != "$known" ]; then
    echo "skipped: sizes of modules: the objects are of $made, the table is of $known"
    exit $status
fi
measure >"$out/check/sizes.now"
awk 'NR == FNR { if ($1 !~ /^#/) known[$1] = $2; next }
     !($1 in known) { printf "lib/%s has no row in tests/guard/sizes.table: run make sizes\n", $1; bad = 1; next }
     $2 > 1.02 * known[$1] {
         printf "lib/%s: %d bytes, %.1f %% more than the %d of the table; if it is worth it, run make sizes\n",
                $1, $2, 100 * ($2 / known[$1] - 1), known[$1]
         bad = 1
     }
     END { exit bad }' $table "$out/check/sizes.now" || status=1
exit $status
