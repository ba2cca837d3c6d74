"""A program of the first release with ABI 1, linked with the library of today: it runs, and its states are the command's."""
import json
import os
import pathlib
import re
import subprocess


def test_a_program_of_the_first_release_runs(root, command, tmp_path):
    library = pathlib.Path(os.environ["MUSLIN_LIB"]).resolve().parent
    program = tmp_path / "first"
    subprocess.run(["cc", "-std=c11", "-Wall", "-Wextra", "-Werror", root / "tests/abi/first.c", f"-L{library}", "-lmuslin",
                    f"-Wl,-rpath,{library}", "-o", program], check=True)
    placed, dressed = subprocess.run([program], check=True, capture_output=True, text=True).stdout.split()
    want = json.loads(command("dress", "--design", "skirt", "--size", "W40", "--spacing", 60, "--json").stdout)
    assert (placed, dressed) == (want["state_hash"],) * 2


def test_each_symbol_has_the_version_of_its_library(root):
    """Versions as tests/abi/versions.txt has them since the release that it was written at (nm --with-symbol-versions);
    what came after it is in baseline.txt."""
    library = pathlib.Path(os.environ["MUSLIN_LIB"]).resolve().parent
    want = dict(line.split() for line in (root / "tests/abi/versions.txt").read_text().splitlines())
    have = {}
    for file in sorted(library.glob("libmuslin*.so")):
        text = subprocess.run(["nm", "-D", "--with-symbol-versions", "--defined-only", file], check=True, capture_output=True, text=True).stdout
        have.update(re.findall(r" [TDRBi] (\w+)@@(\w+)", text))
    gone = {name: version for name, version in want.items() if have.get(name) != version}
    assert not gone, "a linked program would not start"
