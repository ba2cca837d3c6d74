#!/bin/sh
# hardened.sh OUT: what protects the libraries and the programs against faults of memory, read from their files by
# readelf, one line each: read-only relocations, binding at the start, a stack that is not executable, functions with a
# stack guard, checked calls of the C library (FORTIFY), position-independent code, no run path. Fails where one is
# missing; guards and checked calls are those of config=release alone (flags.sh holds that it asks for them).
set -eu
out=$(cd "$1" && pwd)
status=0
case $(basename "$out") in debug | sanitize | tsan | coverage) release=no ;; *) release=yes ;; esac

fault() { echo "$1: $2"; status=1; }

printf '%-24s %-6s %-6s %-8s %-7s %-8s %-5s\n' file relro now stack guarded checked pie
for file in "$out"/lib/libmuslin.so "$out"/lib/libmuslin-print.so "$out"/lib/libmuslin-exchange.so \
    "$out"/lib/libmuslin-catalogue.so "$out"/bin/muslin "$out"/bin/muslin-render; do
    name=$(basename "$file")
    has() { readelf -W "$1" "$file" | grep -qE "$2" && echo yes || echo no; }
    relro=$(has -l GNU_RELRO)
    now=$(has -d 'BIND_NOW|FLAGS.*NOW')
    stack=$(readelf -Wl "$file" | grep GNU_STACK | grep -q 'RWE' && echo runs || echo data)
    guarded=$(objdump -d --no-show-raw-insn "$file" | grep -c '\(call\|bl\).*<__stack_chk_fail' || true)
    checked=$(readelf -W --dyn-syms "$file" | grep -c '_chk@' || true)
    pie=$(has -h 'Type: *DYN')
    printf '%-24s %-6s %-6s %-8s %-7s %-8s %-5s\n' "$name" "$relro" "$now" "$stack" "$guarded" "$checked" "$pie"
    [ "$relro $now $stack $pie" = "yes yes data yes" ] || fault "$name" "relro, now, stack or pie is missing"
    [ "$release" = no ] || [ "$guarded" -gt 0 ] || fault "$name" "no function has a stack guard"
    [ "$release" = no ] || [ "$checked" -gt 1 ] || fault "$name" "no call is a checked one of FORTIFY"
    if readelf -d "$file" | grep -qE 'RPATH|RUNPATH|TEXTREL'; then fault "$name" "a run path or text relocations"; fi
done
exit $status
