"""The flat header and the ABI as JSON: cffi dresses a T-shirt with the header, to the command's state; the layout in the
JSON is that of ctypes. tests/hosts tries the other hosts."""
import ctypes
import json
import os
import pathlib
import subprocess
import sys

import pytest

from muslin import _abi

SCENE = ("tshirt", "W40")
SPACING_MM = 30


@pytest.fixture(scope="module")
def want(command):
    design, size = SCENE
    done = command("dress", "--design", design, "--size", size, "--spacing", SPACING_MM, "--json")
    return json.loads(done.stdout)["state_hash"]


def dressed(root, *program):
    library = str(pathlib.Path(os.environ["MUSLIN_LIB"]).resolve())
    return subprocess.run([*program, root / "bindings/abi/muslin_flat.h", library, *SCENE, str(0.001 * SPACING_MM)],
                          check=True, capture_output=True, text=True).stdout.strip()


def test_cffi_reads_the_flat_header_and_dresses_as_the_command(root, want):
    pytest.importorskip("cffi", reason="python3-cffi is not installed")
    assert dressed(root, sys.executable, root / "tests/abi/dress_cffi.py") == want


def test_a_c_compiler_reads_the_flat_header(root, tmp_path):
    source = tmp_path / "flat.c"
    source.write_text(f'#include <stddef.h>\n#include <stdint.h>\n#include "{root}/bindings/abi/muslin_flat.h"\n')
    compiler = os.environ.get("CC", "cc").split()
    subprocess.run([*compiler, "-std=c99", "-Wall", "-Wextra", "-Werror", "-fsyntax-only", source], check=True)


def test_the_json_has_the_layout_that_ctypes_has(root):
    abi = json.loads((root / "bindings/abi/muslin_abi.json").read_text())
    assert abi["pointer_bytes"] == ctypes.sizeof(ctypes.c_void_p)
    assert set(abi["functions"]) == set(_abi.FUNCTIONS)
    for name, struct in abi["structs"].items():
        kind = getattr(_abi, name)
        assert struct["size"] == ctypes.sizeof(kind), name
        assert {field["name"]: field["offset"] for field in struct["fields"]} == \
               {field: getattr(kind, field).offset for field, _ in kind._fields_}, name
    for name, value in abi["constants"].items():
        assert getattr(_abi, name) == value
