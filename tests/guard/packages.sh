#!/bin/sh
# packages.sh GROUP...: install the Debian packages of the groups that are missing, and say which.
#
# build: what `make` and `make dress` need; test: what `make check` needs besides; ci: what .ci/run needs besides;
# fuzz: clang with the runtime of its sanitizers and of libFuzzer;
# ports: the cross compilers and the emulator of `make check-ports`, and MPFR for `make elementary`; report: what draws
# the pictures of `make report`.
# Nothing is asked of the network when nothing is missing. A machine without apt is told the names.
set -eu

build="gcc libc6-dev make pkgconf libpng-dev libegl-dev libgl-dev libegl1 libegl-mesa0 libgl1-mesa-dri libcairo2-dev
       libpango1.0-dev libjansson-dev libyaml-dev libexpat1-dev libsqlite3-dev"
test="check poppler-utils mandoc python3 python3-pytest python3-numpy python3-scipy python3-cffi luajit g++ locales
      abigail-tools fonts-dejavu-core fonts-tlwg-loma-otf fonts-vlgothic"
ci="clang libclang-rt-dev cmake"
fuzz="clang libclang-rt-dev"
ports="clang qemu-user gcc-i686-linux-gnu libc6-dev-i386-cross gcc-s390x-linux-gnu libc6-dev-s390x-cross
       gcc-mips-linux-gnu libc6-dev-mips-cross gcc-aarch64-linux-gnu libc6-dev-arm64-cross musl-tools wasi-libc
       libclang-rt-dev-wasm32 lld nodejs libmpfr-dev libgmp-dev"
report="python3 python3-numpy python3-scipy python3-matplotlib"

wanted=""
for group in "$@"; do
    case $group in
    build) wanted="$wanted $build" ;;
    test) wanted="$wanted $test" ;;
    ci) wanted="$wanted $ci" ;;
    fuzz) wanted="$wanted $fuzz" ;;
    ports) wanted="$wanted $ports" ;;
    report) wanted="$wanted $report" ;;
    *) echo "packages.sh: group $group is unknown: build, test, ci, fuzz, ports or report" >&2; exit 2 ;;
    esac
done

# without dpkg nobody can say what is missing: trust the machine, and let the compiler speak
command -v dpkg-query >/dev/null 2>&1 || exit 0

missing=""
for package in $wanted; do
    dpkg-query -W -f '${Status}\n' "$package" 2>/dev/null | grep -q 'ok installed' || missing="$missing $package"
done
[ -n "$missing" ] || exit 0

sudo=""
if [ "$(id -u)" != 0 ]; then
    command -v sudo >/dev/null 2>&1 || {
        echo "muslin: missing packages, and neither root nor sudo to install them; as root: apt-get install$missing" >&2
        exit 1
    }
    sudo=sudo
fi
echo "muslin: installing missing packages:$missing"
export DEBIAN_FRONTEND=noninteractive
log=$(mktemp)
trap 'rm -f "$log"' EXIT
{ $sudo apt-get -o DPkg::Lock::Timeout=600 update &&
    $sudo env DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=600 install -y --no-install-recommends $missing; } >"$log" 2>&1 || {
    tail -n 5 "$log" >&2
    echo "muslin: apt could not install:$missing (its last lines are above); install them by hand and run make again" >&2
    exit 1
}
