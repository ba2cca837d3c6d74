#!/usr/bin/env python3
"""generate.py: write muslin/_abi.py from the public headers.

The headers keep to a small part of C (no struct by value, no enum-typed field, no macro that does work), so that a
page of regular expressions reads them whole; what it cannot read it refuses by name. tests/python/test_abi.py runs
it again and compares, and compares the layout of each struct with what a C compiler says.

    python3 bindings/python/generate.py          writes the file
    python3 bindings/python/generate.py --check  exit 1 when the file is not up to date
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
TARGET = pathlib.Path(__file__).parent / "muslin" / "_abi.py"
ORDER = ["base", "tape", "body", "pose", "scan", "pattern", "topology", "edit", "design", "cloth", "integrate", "arrange", "drape",
         "dress", "fit", "print", "exchange", "catalogue"]
LIBRARY = {"print": "print", "exchange": "exchange", "catalogue": "catalogue"}  # all else is libmuslin
SCALAR = {"mus_status": "c_int32", "int32_t": "c_int32", "int64_t": "c_int64", "uint64_t": "c_uint64",
          "uint8_t": "c_uint8",
          "size_t": "c_size_t", "double": "c_double", "float": "c_float", "char": "c_char", "int": "c_int"}


class Headers:
    """What the headers declare, in their order."""

    def __init__(self, folder):
        self.constants = {}  # name -> int
        self.names = {}      # "STATUS" / "MEASURE" -> list of names
        self.handles = []    # opaque types
        self.structs = {}    # name -> [(field, type)]
        self.callbacks = {}  # name -> (result, [type])
        self.functions = {}  # name -> (library, result, [type])
        for header in ORDER:
            self.read(header, (folder / f"{header}.h").read_text())

    def read(self, header, text):
        text = re.sub(r"/\*.*?\*/", " ", text, flags=re.S).replace("\\\n", " ")
        for name, value in re.findall(r"^#define (MUS_\w+) \(?(-?\d+)\)?[ \t]*$", text, re.M):
            self.constants[name] = int(value)
        self.read_lists(text)
        text = re.sub(r"^\s*#.*$", "", text, flags=re.M)
        for name in re.findall(r"typedef struct (mus_\w+) \1;", text):
            self.handles.append(name)
        for result, name, arguments in re.findall(r"typedef (\w[\w ]*?[ *])\(\*(mus_\w+)\)\(([^)]*)\);", text):
            self.callbacks[name] = (result, self.arguments(name, arguments))
        for name, body, again in re.findall(r"typedef struct (mus_\w+) \{(.*?)\} (\w+);", text, re.S):
            assert name == again, f"{name}: typedef of another name"
            self.structs[name] = [self.field(name, line) for line in body.split(";") if line.strip()]
        for declaration in re.findall(r"MUS_API\s+(.*?);", text, re.S):
            match = re.fullmatch(r"(.*?)(\w+)\s*\((.*)\)", " ".join(declaration.split()))
            assert match, f"cannot read: {declaration}"
            self.functions[match[2]] = (LIBRARY.get(header, "core"), match[1].strip(),
                                        self.arguments(match[2], match[3]))

    def read_lists(self, text):
        for kind, rows in re.findall(r"#define MUS_(\w+)_LIST\(X\)(.*)", text):
            if kind == "STATUS":
                entries = re.findall(r'X\((\d+), (\w+), "', rows)
                self.names[kind] = [name for _, name in entries]
                self.constants.update({f"MUS_{name}": int(number) for number, name in entries})
            else:
                self.names[kind] = re.findall(r"X\((\w+),", rows)
                self.constants.update({f"MUS_{kind}_{name}": i for i, name in enumerate(self.names[kind])})
            self.constants[f"MUS_{kind}_COUNT"] = len(self.names[kind])

    def arguments(self, where, text):
        if text.strip() == "void":
            return []
        types = []
        for argument in text.split(","):
            match = re.fullmatch(r"\s*(.*?[ *])\w+\s*", argument)
            assert match, f"{where}: cannot read the argument {argument!r}"
            types.append(match[1].strip())
        return types

    def field(self, where, text):
        match = re.fullmatch(r"(.*?[ *])(\w+)((?:\[\w+\])*)", " ".join(text.split()))
        assert match, f"{where}: cannot read the field {text!r}"
        sizes = [str(self.constants.get(size, size)) for size in re.findall(r"\w+", match[3])]
        return match[2], " * ".join([self.ctype(match[1].strip()), *reversed(sizes)])

    def ctype(self, text):
        """The ctypes expression of a C type."""
        base = text.replace("const", " ").replace("*", " ").strip()
        stars = text.count("*")
        if base == "void":
            return {0: "None", 1: "c_void_p", 2: "POINTER(c_void_p)"}[stars]
        if base == "char" and stars > 0:
            kind, stars = "c_char_p", stars - 1
        elif base in SCALAR:
            kind = SCALAR[base]
        else:
            assert base in self.handles or base in self.structs or base in self.callbacks, f"unknown type: {text}"
            kind = base
        return "POINTER(" * stars + kind + ")" * stars


def wrap(head, items, tail):
    """`head` items `tail` in lines of at most 120 columns, continued under the opening bracket."""
    lines, line = [], head
    for i, item in enumerate(items):
        piece = item + (", " if i + 1 < len(items) else "")
        if len((line + piece + tail).rstrip()) > 120:
            lines.append(line.rstrip())
            line = " " * (head.rindex(head.strip()[-1]) + 1)
        line += piece
    return "\n".join(lines + [line + tail])


def render(headers):
    version = ".".join(str(headers.constants[f"MUS_VERSION_{part}"]) for part in ("MAJOR", "MINOR", "PATCH"))
    out = ['"""_abi.py: the C interface as ctypes sees it, and nothing else.',
           "", "Written by bindings/python/generate.py from include/muslin/*.h; do not edit.", '"""',
           "from ctypes import (CFUNCTYPE, POINTER, Structure, c_char, c_char_p, c_double, c_float, c_int32, c_int64,",
           "                    c_size_t, c_uint64, c_uint8, c_void_p)", "", f'VERSION = "{version}"', "", "# constants"]
    out += [f"{name} = {value}" for name, value in headers.constants.items()]
    out += ["", "# names of the lists, by number"]
    for kind, names in headers.names.items():
        out.append(wrap(f"{kind}_NAMES = (", [f'"{name}"' for name in names], ")"))
    out += ["", "", "# opaque handles"]
    for name in headers.handles:
        out += ["", "", f"class {name}(Structure):", "    pass"]
    out += ["", "", "# callbacks"]
    for name, (result, arguments) in headers.callbacks.items():
        out.append(f"{name} = CFUNCTYPE({', '.join(headers.ctype(kind) for kind in [result, *arguments])})")
    out += ["", "# structs"]
    for name, fields in headers.structs.items():
        out += ["", "", f"class {name}(Structure):",
                wrap("    _fields_ = [", [f'("{field}", {kind})' for field, kind in fields], "]")]
    out += ["", "", "# functions: name -> (library, result, arguments)", "FUNCTIONS = {"]
    for name, (library, result, arguments) in headers.functions.items():
        kinds = [headers.ctype(kind) for kind in arguments]
        out.append(wrap(f'    "{name}": ("{library}", {headers.ctype(result)}, [', kinds, "]),"))
    return "\n".join(out + ["}", ""])


def main():
    text = render(Headers(ROOT / "include" / "muslin"))
    if "--check" in sys.argv[1:]:
        return 0 if TARGET.exists() and TARGET.read_text() == text else 1
    TARGET.write_text(text)
    return 0


if __name__ == "__main__":
    sys.exit(main())
