#!/bin/sh
# names.sh: libmuslin also builds without its Makefile: by one compiler line over all files, and as one file made by
# cat. The second holds only while static names are unique across lib/.
set -eu
cd "$(dirname "$0")/../.."
CC=${CC:-cc}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
status=0

# libmuslin is all of lib/ but the rooms that are libraries of their own
files=$(ls lib/*/*.c | grep -vE '^lib/(file|drawing|print|cutter|paperfile|sewing|exchange|meshfile|trade|seam|valentina|catalogue)/')

$CC -Iinclude -Ilib $files -shared -fPIC -lm -pthread -o "$scratch/line.so" || {
    echo "libmuslin does not build by one compiler line"
    status=1
}
cat $files >"$scratch/muslin.c"
$CC -Iinclude -Ilib "$scratch/muslin.c" -shared -fPIC -lm -pthread -o "$scratch/cat.so" || {
    echo "libmuslin does not build as one file: a static name stands in two files of lib/"
    status=1
}
exit $status
