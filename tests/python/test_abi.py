"""The package's prototypes and structs are those of the headers and of a C compiler."""
import ctypes
import os
import re
import subprocess
import sys

from muslin import _abi
from muslin._library import lib

DECLARED = re.compile(r"\bMUS_API\s[^;(#]*?\b(mus_\w+)\s*\(")


def headers(root):
    return sorted((root / "include" / "muslin").glob("*.h"))


def structs():
    """The structs with fields: defs, results, views."""
    return {name: kind for name, kind in vars(_abi).items()
            if isinstance(kind, type) and issubclass(kind, ctypes.Structure) and hasattr(kind, "_fields_")}


def test_the_generated_file_is_that_of_the_headers(root):
    done = subprocess.run([sys.executable, root / "bindings/python/generate.py", "--check"])
    assert done.returncode == 0, "run bindings/python/generate.py"


def test_every_declared_function_has_a_prototype_and_no_other(root):
    declared = {name for header in headers(root) for name in DECLARED.findall(header.read_text())}
    assert len(declared) > 150
    assert declared == set(_abi.FUNCTIONS)


def test_every_prototype_is_exported():
    for name in _abi.FUNCTIONS:
        assert getattr(lib, name) is not None


def c_output(tmp_path, root, lines):
    source = tmp_path / "ask.c"
    includes = "".join(f'#include "muslin/{header.name}"\n' for header in headers(root))
    source.write_text(f'#include <stddef.h>\n#include <stdio.h>\n{includes}int main(void)\n{{\n{lines}return 0;\n}}\n')
    compiler = os.environ.get("CC", "cc").split()
    subprocess.run([*compiler, "-I", root / "include", source, "-o", tmp_path / "ask"], check=True)
    return subprocess.run([tmp_path / "ask"], check=True, capture_output=True, text=True).stdout.split()


def test_structs_lie_in_memory_as_in_c(root, tmp_path):
    want, lines = [], ""
    for name, kind in structs().items():
        want.append(ctypes.sizeof(kind))
        lines += f'printf("%zu\\n", sizeof({name}));\n'
        for field, _ in kind._fields_:
            want.append(getattr(kind, field).offset)
            lines += f'printf("%zu\\n", offsetof({name}, {field}));\n'
    assert len(structs()) >= 12
    assert [int(word) for word in c_output(tmp_path, root, lines)] == want


def test_constants_are_those_of_c(root, tmp_path):
    names = [name for name in vars(_abi) if name.startswith("MUS_")]
    lines = "".join(f'printf("%d\\n", (int){name});\n' for name in names)
    assert [int(word) for word in c_output(tmp_path, root, lines)] == [getattr(_abi, name) for name in names]


def test_no_struct_or_enum_passes_by_value():
    for name, (_, result, arguments) in _abi.FUNCTIONS.items():
        for kind in [result, *arguments]:
            assert kind is None or not issubclass(kind, (ctypes.Structure, ctypes.Array)), name


def test_every_def_init_writes_its_size_and_stays_inside():
    for name in _abi.FUNCTIONS:
        if not name.endswith("_init"):
            continue
        kind = getattr(_abi, name[:-len("_init")])
        block = (ctypes.c_ubyte * (ctypes.sizeof(kind) + 16))(*[0xa5] * (ctypes.sizeof(kind) + 16))
        getattr(lib, name)(ctypes.cast(block, ctypes.POINTER(kind)), ctypes.sizeof(kind))
        assert kind.from_buffer(block).size == ctypes.sizeof(kind), name
        assert bytes(block[-16:]) == b"\xa5" * 16, name
        getattr(lib, name)(None, ctypes.sizeof(kind))
