#!/bin/sh
# symbols.sh LIBFOLDER: each shared library shows exactly the functions that its headers declare with MUS_API, and
# needs nothing but what the house allows.
set -eu
lib=$(cd "$1" && pwd)
cd "$(dirname "$0")/../.."
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
status=0

# names behind MUS_API in the headers given
declared()
{
    sed '/^#/d' "$@" | tr '\n' ' ' | grep -o 'MUS_API [^;(]*(' | sed 's/ *($//; s/.*[ *]//' | sort -u
}

compare() # NAME HEADER...
{
    name=$1
    shift
    declared "$@" >"$scratch/declared"
    nm -D --defined-only "$lib/$name.so" | awk '$2 != "A" { sub(/@.*/, "", $3); print $3 }' | sort -u >"$scratch/exported"
    comm -23 "$scratch/declared" "$scratch/exported" | sed "s/^/$name: declared, not exported: /" >"$scratch/report"
    comm -13 "$scratch/declared" "$scratch/exported" | sed "s/^/$name: exported, not declared: /" >>"$scratch/report"
    if [ -s "$scratch/report" ]; then
        cat "$scratch/report"
        status=1
    fi
}

needs() # NAME PATTERN
{
    extra=$(readelf -d "$lib/$1.so" | sed -n 's/.*NEEDED.*\[\(.*\)\]/\1/p' | grep -vE "^($2)\.so" || true)
    if [ -n "$extra" ]; then
        echo "$1 needs:" $extra
        status=1
    fi
}

core=$(ls include/muslin/*.h | grep -vE '/(print|exchange|catalogue)\.h$')
compare libmuslin $core
compare libmuslin-print include/muslin/print.h
compare libmuslin-exchange include/muslin/exchange.h
compare libmuslin-catalogue include/muslin/catalogue.h
system='libc|libm|libpthread|libgcc_s|ld-linux-x86-64'
needs libmuslin "$system"
needs libmuslin-print "$system|libmuslin|libcairo|libpango-1.0|libpangocairo-1.0|libgobject-2.0"
needs libmuslin-exchange "$system|libmuslin|libjansson|libyaml-0|libexpat"
needs libmuslin-catalogue "$system|libmuslin|libsqlite3"
exit $status
