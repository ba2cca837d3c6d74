#!/bin/sh
# own_math.sh LIBFOLDER: the libraries take no function from the C library whose bits differ between C libraries.
#
# Read from the symbols that the shared libraries need: of libm only functions whose result IEEE 754 or C fixes, and no
# qsort. Sine to logarithm and the sort are lib/base/elementary.c's and lib/base/sort.c's.
set -eu
lib=$(cd "$1" && pwd)
cd "$(dirname "$0")/../.."
status=0
free='acosh?|asinh?|atan2?|atanh|cbrt|cosh?|erfc?|exp(2|10|m1)?|hypot|log(10|1p|2|b)?|lgamma|pow|sincos|sinh?|tanh?|tgamma'
for library in libmuslin libmuslin-print libmuslin-exchange libmuslin-catalogue; do
    found=$(nm -D --undefined-only "$lib/$library.so" | grep -oE " (($free)[fl]?|qsort(_r)?|rand|random)(@|$)" | tr -d ' @' || true)
    [ -z "$found" ] || { echo "$library takes from the C library:" $found "(use mus__ of base/elementary.h, base/sort.h)"; status=1; }
done
exit $status
