#!/usr/bin/env python3
"""debian.py: the Debian packages of the committed tree, built, checked by lintian, and tried where they are unpacked.

One line a claim; exit 1 when one does not hold. The packages stay in MUSLIN_OUT/debian. Needs debhelper, dh-python and
lintian. They are not installed: the test runs on their files, unpacked into one folder.
"""
import os
import pathlib
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


def main():
    for program in ("dpkg-buildpackage", "dh", "lintian"):
        if shutil.which(program) is None:
            sys.exit(f"debian.py: {program} is not installed; apt-get install debhelper dh-python lintian")
    build()
    packages = sorted(OUT.glob("*.deb"))
    for package in packages:
        print(f"     {package.name} {package.stat().st_size / 1e6:.2f} MB")
    changes, = OUT.glob("*.changes")
    _, said = told("lintian", "--allow-root", changes)
    found = [line for line in said.splitlines() if line[:2] in ("E:", "W:")]
    print("\n".join(found))
    errors, warnings = (sum(line.startswith(letter) for line in found) for letter in "EW")
    held = [errors == 0]
    print(f"{'ok  ' if held[-1] else 'FAIL'} lintian: {errors} errors, {warnings} warnings")
    root = OUT / "root"
    for package in packages:
        subprocess.run(["dpkg-deb", "-x", package, root], check=True)
    folder = next(root.glob("usr/lib/*/libmuslin.so.1")).parent
    tried = {**os.environ, "LD_LIBRARY_PATH": str(folder), "PYTHONPATH": str(root / "usr/lib/python3/dist-packages"),
             "PATH": f"{root / 'usr/bin'}:{os.environ['PATH']}", "MUSLIN_LIB": str(folder / "libmuslin.so.1"),
             "AUTOPKGTEST_TMP": str(OUT), "CPATH": str(root / "usr/include"), "LIBRARY_PATH": str(folder),
             "PKG_CONFIG_PATH": str(folder / "pkgconfig"), "PKG_CONFIG_SYSROOT_DIR": str(root)}
    code, said = told("sh", HERE / "debian/tests/dress", env=tried)
    held.append(code == 0)
    first = said.splitlines()[0] if said else ""
    print(f"{'ok  ' if held[-1] else 'FAIL'} debian/tests/dress on the unpacked files: {first}")
    return not all(held)


if __name__ == "__main__":
    sys.exit(main())
