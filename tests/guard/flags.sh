#!/bin/sh
# flags.sh: the user's CFLAGS do not undo the flags that speed and equal results rest on.
#
# Asked of `make -n` with CFLAGS=-O2, as a distribution passes them: each file with arithmetic kernels is still compiled
# with -O3 -fno-math-errno (an -O2 that came last made a drape 2.3 times slower), and every file with -ffp-contract=off,
# which stands last. With -march=x86-64-v4, which has AVX-512, no instruction multiplies and adds with one rounding. The
# loops over packets of pairs and chunks of nodes are vectors in their avx2 clones: without -fno-trapping-math gcc 12 left
# them scalar, and a drape with self-contact took half as long again.
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

# the files in which gcc 12 made vfmaddsub of AVX-512 when -mno-fma alone forbade it
fused="block_skirt block_trousers block_waist"
if ${CC:-cc} -march=x86-64-v4 -E -x c /dev/null >/dev/null 2>&1 && command -v objdump >/dev/null; then
    MAKEFLAGS= make -s OUT="$scratch" CFLAGS='-O3 -march=x86-64-v4' $(printf "$scratch/obj/lib/block/%s.o " $fused)
    count=$(for f in $fused; do objdump -d "$scratch/obj/lib/block/$f.o"; done | grep -cE '\bvfn?m(add|sub)' || true)
    [ "$count" = 0 ] || { echo "lib/block with -march=x86-64-v4: $count instructions multiply and add at once"; status=1; }
fi

# the loops that must be vectors: each does a dozen packed operations on 32 bytes in its avx2 clone
if command -v objdump >/dev/null; then
    loops="selfcontact/self_contact_f32 contact/plane_cache_f32"
    MAKEFLAGS= make -s OUT="$scratch/own" $(printf "$scratch/own/obj/lib/%s.o " $loops)
    for f in $loops; do objdump -d --no-show-raw-insn "$scratch/own/obj/lib/$f.o"; done | awk '
        /^[0-9a-f]+ <.*>:$/ {
            name = $2 ~ /(packet_(edge_edge|point_triangle|closing|passes)|rank_body|cache_chunk)_f32\.avx2/ ? $2 : ""
        }
        name != "" { all[name] += 0 }
        name != "" && $2 ~ /^v(add|sub|mul|div|min|max|sqrt|cmp[a-z]*)ps$/ && /ymm/ { all[name]++ }
        END { for (name in all) if (all[name] < 12) { print name " is scalar: " all[name] " vectors"; bad = 1 }
              exit bad }' || status=1
fi
exit $status
