#!/bin/sh
# flags.sh: the user's CFLAGS do not undo the flags that speed and equal results rest on.
#
# Asked of `make -n` with CFLAGS=-O2, as a distribution passes them: each file with arithmetic kernels is still compiled
# with -O3 -fno-math-errno (an -O2 that came last made a drape 2.3 times slower), and every file with -ffp-contract=off,
# which stands last.
set -eu
cd "$(dirname "$0")/../.."
status=0
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
MAKEFLAGS= make -n V=1 OUT="$scratch" CFLAGS='-O2 -ffp-contract=fast' lib >"$scratch/lines"

option_of() # SOURCE PATTERN: the last option like PATTERN on the line that compiles SOURCE
{
    grep -F -- " -c $1 " "$scratch/lines" | tr ' ' '\n' | grep -E -- "$2" | tail -n 1
}

for source in lib/*/*_f32.c lib/*/*_f64.c; do
    level=$(option_of "$source" '^-O')
    errno=$(option_of "$source" '^-f(no-)?math-errno')
    [ "$level $errno" = "-O3 -fno-math-errno" ] || { echo "$source is compiled with: $level $errno"; status=1; }
    contract=$(option_of "$source" '^-ffp-contract')
    [ "$contract" = "-ffp-contract=off" ] || { echo "$source is compiled with: $contract"; status=1; }
done
for flag in -fstack-protector-strong -D_FORTIFY_SOURCE; do
    [ -n "$(option_of lib/base/context.c "^$flag")" ] || { echo "lib/base/context.c is compiled without $flag"; status=1; }
done
exit $status
