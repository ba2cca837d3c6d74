#!/bin/sh
# run.sh OUT: a C99 and a C++ program outside the tree, by pkg-config and by find_package(muslin), shared and static,
# from an installation in a fresh prefix; each must print the state hash that the command reports for the same scene.
#
# The installation is moved by DESTDIR, its pkg-config files read with that as the root: so a path of the build folder
# that slipped into an installed file would be seen.
set -eu
out=$(cd "$1" && pwd)
cd "$(dirname "$0")/../.."
root=$PWD
CC=${CC:-cc}
CXX=${CXX:-c++}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
fail() { echo "$*"; exit 1; }

# ---- install twice: into a prefix to use, and by DESTDIR with a library folder of Debian's kind ----

abi=$(sed -n 's/^.define MUS_ABI //p' include/muslin/base.h)
version=$(sed -n 's/^.define MUS_VERSION_\(MAJOR\|MINOR\|PATCH\) //p' include/muslin/base.h | paste -sd.)
sh lib/install.sh "$out" "" "$scratch/prefix" lib "$version" "$abi"
sh lib/install.sh "$out" "$scratch/stage" /opt/muslin lib/x86_64-linux-gnu "$version" "$abi"
grep -rlI "$scratch\|$out" "$scratch/stage" && fail "an installed file names a folder of the build"
[ -e "$scratch/stage/opt/muslin/lib/x86_64-linux-gnu/libmuslin.so.$abi" ] || fail "LIBDIR was not respected"

cmp "$scratch/prefix/share/muslin/muslin_flat.h" bindings/abi/muslin_flat.h || fail "muslin_flat.h is not installed"
cmp "$scratch/prefix/share/muslin/muslin_abi.json" bindings/abi/muslin_abi.json || fail "muslin_abi.json is not installed"

# ---- the scene, by the command ----

tape=$root/examples/tapes/w40.tape
pattern=$scratch/skirt.json
spacing=20
"$scratch/prefix/bin/muslin" draft --design skirt --tape "$tape" -o "$pattern"
"$scratch/prefix/bin/muslin" dress --pattern "$pattern" --tape "$tape" --spacing $spacing --report "$scratch/report.json"
want=$(sed -n 's/.*"state_hash": *"\(0x\)\{0,1\}\([0-9a-f]*\)".*/\2/p' "$scratch/report.json")
[ ${#want} -eq 16 ] || fail "the command's report has no state_hash of 16 hex digits"

# ---- programs ----

export PKG_CONFIG_PATH="$scratch/prefix/lib/pkgconfig"
[ "$(pkg-config --modversion muslin)" = "$version" ] || fail "pkg-config says another version"
mkdir "$scratch/bin"
flags=$(pkg-config --cflags muslin-exchange)
shared="$(pkg-config --libs muslin-exchange) -Wl,-rpath,$scratch/prefix/lib"
# the archives by name, since both kinds lie in one folder
static=$(pkg-config --static --libs muslin-exchange | sed 's/-l\(muslin[a-z-]*\)/-l:lib\1.a/g')
for kind in shared static; do
    eval "libs=\$$kind"
    $CC -std=c99 -Wall -Wextra -Wpedantic -Werror $flags examples/hello.c $libs -o "$scratch/bin/c_$kind"
    $CXX -std=c++17 -Wall -Wextra -Wpedantic -Werror $flags tests/embed/hello.cpp $libs -o "$scratch/bin/cpp_$kind"
done

if command -v cmake >/dev/null 2>&1; then
    cmake -S tests/embed -B "$scratch/cmake" -DCMAKE_PREFIX_PATH="$scratch/prefix" >"$scratch/cmake.log" 2>&1 &&
        cmake --build "$scratch/cmake" >>"$scratch/cmake.log" 2>&1 || { cat "$scratch/cmake.log"; fail "cmake failed"; }
    for name in c_shared c_static cpp_shared cpp_static; do
        cp "$scratch/cmake/$name" "$scratch/bin/cmake_$name"
    done
else
    echo "skipped: find_package(muslin), since cmake is not installed"
fi

# ---- run: same hash everywhere; what was linked statically needs no shared muslin ----

for program in "$scratch"/bin/*; do
    got=$("$program" "$tape" "$pattern" $spacing) || fail "$(basename "$program") failed"
    [ "$got" = "$want" ] || fail "$(basename "$program") prints $got, the command reports $want"
    case $program in
    *static) readelf -d "$program" | grep -q 'NEEDED.*libmuslin' && fail "$(basename "$program") needs a shared muslin" ;;
    *shared) readelf -d "$program" | grep -q "NEEDED.*libmuslin\.so\.$abi" || fail "$(basename "$program") is not linked with the shared muslin" ;;
    esac
done
exit 0
