"""setup.py: build the shared libraries by the Makefile of the repository, and put them beside the package's modules.

All else stands in pyproject.toml. The wheel serves every Python 3 of its platform. A source distribution carries the
sources of the libraries in source/. Where neither they nor the repository are there, MUSLIN_LIB names the folder of
built libraries; without it nothing is built, since a package without libraries would be of no use.

Paper is written in strokes alone: Pango, GLib and what they need would be as large as the rest of a wheel. PANGO=1 in
the environment builds with them.
"""
import os
import pathlib
import shutil
import subprocess

from setuptools import Distribution, setup
from setuptools.command.bdist_wheel import bdist_wheel
from setuptools.command.build_py import build_py
from setuptools.command.sdist import sdist

HERE = pathlib.Path(__file__).resolve().parent
NAMES = ("libmuslin", "libmuslin-print", "libmuslin-exchange", "libmuslin-catalogue")
SOURCES = ("Makefile", "LICENSE", "include", "lib")  # of the repository, in a source distribution


def sources():
    """The folder with the Makefile and the sources, or None."""
    folders = [folder for folder in (HERE / "source", HERE.parents[1])
               if all((folder / name).exists() for name in SOURCES)]
    return folders[0] if folders else None


def constant(root, name):
    """A number that include/muslin/base.h defines."""
    return next(line.split()[2] for line in (root / "include/muslin/base.h").read_text().splitlines()
                if line.startswith(f"#define {name} "))


def build(root, out):
    """Paths of the shared libraries, built in the folder `out`; they find each other where they lie."""
    version = ".".join(constant(root, f"MUS_VERSION_{part}") for part in ("MAJOR", "MINOR", "PATCH"))
    files = [out / "lib" / f"{name}.so.{version}" for name in NAMES]
    pango = os.environ.get("PANGO", "0")
    subprocess.run(["make", "-C", str(root), f"-j{os.cpu_count()}", "V=0", f"PANGO={pango}", f"OUT={out}",
                    "LDFLAGS=-Wl,-rpath,'$$ORIGIN'", *map(str, files)], check=True)
    return {f"{name}.so.{constant(root, 'MUS_ABI')}": file for name, file in zip(NAMES, files)}


def libraries(out):
    """{file name in the package: path of the library}."""
    root = sources()
    if root is not None:
        return build(root, out)
    named = pathlib.Path(os.environ.get("MUSLIN_LIB", ""))
    folder = named if named.is_dir() else named.parent
    found = [sorted(folder.glob(f"{name}.so.?")) for name in NAMES] if os.environ.get("MUSLIN_LIB") else [[]]
    if not all(found):
        raise SystemExit("muslin: neither the sources of the libraries (source/, or the repository with its Makefile) "
                         "are here, nor does MUSLIN_LIB name a folder with all four built libraries")
    return {files[0].name: files[0] for files in found}


class BuildWithLibraries(build_py):
    def run(self):
        super().run()
        out = pathlib.Path(self.get_finalized_command("build").build_temp).resolve() / "muslin"
        for name, path in libraries(out).items():
            placed = pathlib.Path(self.build_lib, "muslin", name)
            shutil.copy(path, placed)
            if shutil.which("strip"):
                subprocess.run(["strip", "--strip-unneeded", str(placed)], check=True)


class SourcesToo(sdist):
    def make_release_tree(self, base_dir, files):
        super().make_release_tree(base_dir, files)
        root = sources()
        if root is None:
            raise SystemExit("muslin: a source distribution is made in the repository, which has the sources")
        pathlib.Path(base_dir, "source").mkdir()
        for name in SOURCES:
            copy = shutil.copytree if (root / name).is_dir() else shutil.copy
            copy(root / name, pathlib.Path(base_dir, "source", name))


class WithLibraries(Distribution):
    def has_ext_modules(self):
        return True


class WheelOfAnyPython(bdist_wheel):
    def get_tag(self):
        return "py3", "none", super().get_tag()[2]


setup(cmdclass={"build_py": BuildWithLibraries, "bdist_wheel": WheelOfAnyPython, "sdist": SourcesToo},
      distclass=WithLibraries)
