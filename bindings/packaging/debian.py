#!/usr/bin/env python3
"""debian.py [chroot]: the Debian packages of the committed tree, built, checked by lintian, and tried.

One line a claim; exit 1 when one does not hold. The packages stay in MUSLIN_OUT/debian. Needs debhelper, dh-python and
lintian. The test of the packages runs on their files, unpacked into one folder; with `chroot` they are installed in a
fresh system of this machine's release as well, where autopkgtest runs it (needs root, mmdebstrap and autopkgtest).
"""
import os
import pathlib
import resource
import shutil
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
OUT = pathlib.Path(os.environ.get("MUSLIN_OUT", ROOT / "build")).resolve() / "debian"


def told(*command, **options):
    done = subprocess.run(list(map(str, command)), capture_output=True, text=True, **options)
    return done.returncode, (done.stdout + done.stderr).strip()


def build():
    """The packages of the tree that git has."""
    shutil.rmtree(OUT, ignore_errors=True)
    tree = OUT / "muslin-0.2.0"
    tree.mkdir(parents=True)
    archive = OUT / "muslin_0.2.0.orig.tar.gz"
    subprocess.run(["git", "-C", ROOT, "archive", "--prefix=muslin-0.2.0/", "-o", archive, "HEAD"], check=True)
    subprocess.run(["tar", "xf", archive, "-C", OUT], check=True)
    shutil.copytree(HERE / "debian", tree / "debian")
    environment = {**os.environ, "DEB_BUILD_OPTIONS": f"parallel={os.cpu_count()}", "PYTHONPATH": ""}
    code, said = told("dpkg-buildpackage", "-us", "-uc", "-d", cwd=tree, env=environment)
    (OUT / "build.log").write_text(said)
    if code != 0:
        last = "\n".join(said.splitlines()[-8:])
        sys.exit(f"debian.py: dpkg-buildpackage ended with {code}; {OUT / 'build.log'}\n{last}")


def claim(holds, text):
    print(f"{'ok  ' if holds else 'FAIL'} {text}", flush=True)
    return holds


def lintian():
    """No error, and no warning but that the first upload closes no bug: Debian has none yet."""
    changes, = OUT.glob("*.changes")
    _, said = told("lintian", "--allow-root", changes)
    found = [line for line in said.splitlines() if line[:2] in ("E:", "W:")]
    rest = [line for line in found if "initial-upload-closes-no-bugs" not in line]
    print("\n".join(rest), end="\n" if rest else "")
    errors, warnings = (sum(line.startswith(letter) for line in rest) for letter in "EW")
    return claim(not rest, f"lintian: {errors} errors, {warnings} warnings, and {len(found) - len(rest)} of the bug's "
                 "number")


def unpacked(packages):
    """The folder of their files, and the environment in which programs find them there."""
    root = OUT / "root"
    for package in packages:
        subprocess.run(["dpkg-deb", "-x", package, root], check=True)
    folder = next(root.glob("usr/lib/*/libmuslin.so.1")).parent
    return root, {**os.environ, "LD_LIBRARY_PATH": str(folder), "MUSLIN_LIB": str(folder / "libmuslin.so.1"),
                  "PYTHONPATH": str(root / "usr/lib/python3/dist-packages"), "AUTOPKGTEST_TMP": str(OUT),
                  "PATH": f"{root / 'usr/bin'}:{os.environ['PATH']}", "CPATH": str(root / "usr/include"),
                  "LIBRARY_PATH": str(folder), "PKG_CONFIG_PATH": str(folder / "pkgconfig"),
                  "PKG_CONFIG_SYSROOT_DIR": str(root)}


def seconds(command, environment):
    """CPU seconds of one run."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    subprocess.run([command, "dress", "--design", "tshirt", "--size", "W40", "--spacing", "15"], env=environment,
                   stdout=subprocess.DEVNULL, check=True)
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before


def speed(root, environment):
    """The least CPU time of seven runs of the packaged command and of the tree's, in turn."""
    own = OUT.parent / "bin/muslin"
    if not own.exists():
        print("     speed: the tree is not built")
        return True
    pairs = [(seconds(root / "usr/bin/muslin", environment), seconds(own, os.environ)) for _ in range(7)]
    packaged, tree = (min(column) for column in zip(*pairs))
    return claim(packaged < 1.1 * tree, f"a T-shirt takes {packaged / tree:.2f} of the time of the tree's command, at "
                 "most 1.10 allowed")


def installed(packages):
    """In a fresh system of this release, by Debian's own test program."""
    system = OUT / "chroot"
    lines = pathlib.Path("/etc/os-release").read_text().splitlines()
    release = dict(line.split("=", 1) for line in lines if "=" in line)
    code, said = told("mmdebstrap", "--variant=apt", "--include=apt-utils,ca-certificates", "--skip=cleanup/apt/lists",
                      release["VERSION_CODENAME"], system)
    if code == 0:
        code, said = told("autopkgtest", "-B", *packages, OUT / "muslin-0.2.0/", "--", "chroot", system)
    (OUT / "chroot.log").write_text(said)
    shutil.rmtree(system, ignore_errors=True)
    return claim(code == 0, f"installed in a fresh {release['VERSION_CODENAME']}, autopkgtest ended with {code}")


def main():
    fresh = "chroot" in sys.argv[1:]
    for program in ["dpkg-buildpackage", "dh", "lintian"] + fresh * ["mmdebstrap", "autopkgtest"]:
        if shutil.which(program) is None:
            sys.exit(f"debian.py: {program} is not installed; apt-get install debhelper dh-python lintian mmdebstrap "
                     "autopkgtest")
    build()
    packages = [package for package in sorted(OUT.glob("*.deb")) if "dbgsym" not in package.name]
    for package in packages:
        print(f"     {package.name} {package.stat().st_size / 1e6:.2f} MB")
    held = [lintian()]
    root, environment = unpacked(packages)
    code, said = told("sh", HERE / "debian/tests/dress", env=environment)
    first = said.splitlines()[0] if said else ""
    held.append(claim(code == 0, f"debian/tests/dress on the unpacked files: {first}"))
    held.append(speed(root, environment))
    if fresh:
        held.append(installed(packages))
    return not all(held)


if __name__ == "__main__":
    sys.exit(main())
