#!/bin/sh
# install.sh OUT DESTDIR PREFIX LIBDIR VERSION ABI: lay out an installation of what was built in OUT.
#
# Called by `make install`. LIBDIR is relative to PREFIX, or absolute. The pkg-config files and the CMake package are
# written here, not at build time, so that they always name the PREFIX of this installation; DESTDIR stands before
# every path that is written and in none that is written down.
set -eu
out=$1 destdir=$2 prefix=$3 libdir=$4 version=$5 abi=$6
case $libdir in /*) ;; *) libdir=$prefix/$libdir ;; esac
cd "$(dirname "$0")/.."

lib=$destdir$libdir
mkdir -p "$destdir$prefix/bin" "$destdir$prefix/include/muslin" "$lib/pkgconfig" "$lib/cmake/muslin"

# ---- files ----

for program in muslin muslin-render; do
    [ ! -e "$out/bin/$program" ] || install -m 755 "$out/bin/$program" "$destdir$prefix/bin"
done
install -m 644 include/muslin/*.h bindings/cpp/muslin.hpp "$destdir$prefix/include/muslin"
for name in muslin muslin-print muslin-exchange muslin-catalogue; do
    [ -e "$out/lib/lib$name.a" ] || continue
    install -m 644 "$out/lib/lib$name.a" "$lib"
    install -m 755 "$out/lib/lib$name.so.$version" "$lib"
    ln -sf "lib$name.so.$version" "$lib/lib$name.so.$abi"
    ln -sf "lib$name.so.$abi" "$lib/lib$name.so"
done
mkdir -p "$destdir$prefix/share/muslin"
install -m 644 bindings/abi/muslin_flat.h bindings/abi/muslin_abi.json "$destdir$prefix/share/muslin"
for page in man/*.[0-9]; do
    [ -e "$page" ] || continue
    mkdir -p "$destdir$prefix/share/man/man${page##*.}"
    install -m 644 "$page" "$destdir$prefix/share/man/man${page##*.}"
done

# ---- pkg-config ----

pc() # NAME DESCRIPTION REQUIRES REQUIRES.PRIVATE LIBS.PRIVATE
{
    [ -e "$out/lib/lib$1.a" ] || return 0
    cat >"$lib/pkgconfig/$1.pc" <<END
prefix=$prefix
libdir=$libdir
includedir=\${prefix}/include

Name: $1
Description: $2
Version: $version
Requires: $3
Requires.private: $4
Cflags: -I\${includedir}
Libs: -L\${libdir} -l$1
Libs.private: $5
END
}

# make PANGO=0 builds libmuslin-print without it
pango=pango
if [ "${PANGO:-1}" = 0 ]; then pango=; fi
pc muslin "from the tape measure to the sewn and draped garment" "" "" "-lm -pthread"
pc muslin-print "ready-to-cut paper of a muslin pattern" "muslin = $version" "cairo${pango:+ pangocairo}" "-lm"
pc muslin-exchange "readers and writers of tapes, patterns and meshes" "muslin = $version" "jansson yaml-0.1 expat" "-lm"
pc muslin-catalogue "patterns on disk, found by how they are sewn" "muslin = $version" "sqlite3" "-lm"

# ---- CMake: find_package(muslin) ----

up=$(realpath -m --relative-to="$libdir/cmake/muslin" "$prefix")
inside=$(realpath -m --relative-to="$prefix" "$libdir")
cat >"$lib/cmake/muslin/muslinConfig.cmake" <<END
# Targets: muslin::muslin, muslin::print, muslin::exchange, muslin::catalogue (shared) and muslin::muslin_static,
# muslin::print_static, muslin::exchange_static, muslin::catalogue_static. The static print needs cairo and Pango to link, the
# static exchange jansson, libyaml and expat, the static catalogue SQLite.
include(CMakeFindDependencyMacro)
find_dependency(Threads)
get_filename_component(muslin_prefix "\${CMAKE_CURRENT_LIST_DIR}/$up" ABSOLUTE)

function(muslin_target name library static_needs)
    if(TARGET muslin::\${name} OR NOT EXISTS "\${muslin_prefix}/$inside/lib\${library}.a")
        return()
    endif()
    add_library(muslin::\${name} SHARED IMPORTED)
    add_library(muslin::\${name}_static STATIC IMPORTED)
    set_target_properties(muslin::\${name} PROPERTIES
        IMPORTED_LOCATION "\${muslin_prefix}/$inside/lib\${library}.so.$version"
        IMPORTED_SONAME "lib\${library}.so.$abi"
        INTERFACE_INCLUDE_DIRECTORIES "\${muslin_prefix}/include")
    set_target_properties(muslin::\${name}_static PROPERTIES
        IMPORTED_LOCATION "\${muslin_prefix}/$inside/lib\${library}.a"
        INTERFACE_INCLUDE_DIRECTORIES "\${muslin_prefix}/include"
        INTERFACE_LINK_LIBRARIES "\${static_needs}")
    if(NOT name STREQUAL "muslin")
        set_target_properties(muslin::\${name} PROPERTIES INTERFACE_LINK_LIBRARIES muslin::muslin)
    endif()
endfunction()

muslin_target(muslin muslin "m;Threads::Threads")
muslin_target(print muslin-print "muslin::muslin_static;${pango:+pangocairo-1.0;pango-1.0;gobject-2.0;}cairo;m")
muslin_target(exchange muslin-exchange "muslin::muslin_static;jansson;yaml;expat;m")
muslin_target(catalogue muslin-catalogue "muslin::muslin_static;sqlite3;m")
END
cat >"$lib/cmake/muslin/muslinConfigVersion.cmake" <<END
# before 1.0 a program is built against one minor release: any lower patch of it will do
set(PACKAGE_VERSION "$version")
set(PACKAGE_VERSION_COMPATIBLE FALSE)
if(NOT PACKAGE_FIND_VERSION)
    set(PACKAGE_VERSION_COMPATIBLE TRUE)
elseif(PACKAGE_FIND_VERSION VERSION_EQUAL PACKAGE_VERSION)
    set(PACKAGE_VERSION_COMPATIBLE TRUE)
    set(PACKAGE_VERSION_EXACT TRUE)
elseif(PACKAGE_FIND_VERSION VERSION_LESS PACKAGE_VERSION AND NOT PACKAGE_FIND_VERSION VERSION_LESS "${version%.*}")
    set(PACKAGE_VERSION_COMPATIBLE TRUE)
endif()
END
