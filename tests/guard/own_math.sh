#!/bin/sh
# own_math.sh LIBFOLDER: the libraries take no function from the C library whose bits differ between C libraries, and
# have no fused multiply-add, which rounds once where other machines round twice.
#
# Read from the symbols that the shared libraries need: of libm only functions whose result IEEE 754 or C fixes, and no
# qsort. Sine to logarithm and the sort are lib/base/elementary.c's and lib/base/sort.c's. Instructions of x86-64 are read
# by objdump: gcc 12 makes vfmaddsub of neighbours also with -ffp-contract=off.
set -eu
lib=$(cd "$1" && pwd)
cd "$(dirname "$0")/../.."
status=0
free='acosh?|asinh?|atan2?|atanh|cbrt|cosh?|erfc?|exp(2|10|m1)?|hypot|log(10|1p|2|b)?|lgamma|pow|sincos|sinh?|tanh?|tgamma'
for library in libmuslin libmuslin-print libmuslin-exchange libmuslin-catalogue; do
    found=$(nm -D --undefined-only "$lib/$library.so" | grep -oE " (($free)[fl]?|qsort(_r)?|rand|random)(@|$)" | tr -d ' @' || true)
    [ -z "$found" ] || { echo "$library takes from the C library:" $found "(use mus__ of base/elementary.h, base/sort.h)"; status=1; }
    fused=$(objdump -d --no-show-raw-insn "$lib/$library.so" | grep -oE 'vfn?m(add|sub)[a-z0-9]*' | sort -u || true)
    [ -z "$fused" ] || { echo "$library has fused multiply-adds:" $fused; status=1; }
done
exit $status
