"""setup.py: build the shared libraries by the Makefile of the repository, and put them beside the package's modules.

All else stands in pyproject.toml. The wheel serves every Python 3 of its platform.
"""
import pathlib
import shutil
import subprocess

from setuptools import Distribution, setup
from setuptools.command.bdist_wheel import bdist_wheel
from setuptools.command.build_py import build_py

ROOT = pathlib.Path(__file__).resolve().parents[2]
NAMES = ("libmuslin", "libmuslin-print", "libmuslin-exchange", "libmuslin-catalogue")


class BuildWithLibraries(build_py):
    def run(self):
        super().run()
        if not (ROOT / "Makefile").exists():
            return  # an editable or relocated tree: MUSLIN_LIB or an installed libmuslin is used
        abi = next(line.split()[2] for line in (ROOT / "include/muslin/base.h").read_text().splitlines()
                   if line.startswith("#define MUS_ABI"))
        files = [f"{name}.so.{abi}" for name in NAMES]
        subprocess.run(["make", "-C", str(ROOT), "all"], check=True)
        for file in files:
            shutil.copy(ROOT / "build" / "lib" / file, pathlib.Path(self.build_lib, "muslin", file))


class WithLibraries(Distribution):
    def has_ext_modules(self):
        return True


class WheelOfAnyPython(bdist_wheel):
    def get_tag(self):
        return "py3", "none", super().get_tag()[2]


setup(cmdclass={"build_py": BuildWithLibraries, "bdist_wheel": WheelOfAnyPython}, distclass=WithLibraries)
