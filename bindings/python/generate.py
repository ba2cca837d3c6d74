#!/usr/bin/env python3
"""generate.py: write what other languages read of the public headers.

    bindings/python/muslin/_abi.py   the prototypes and structs for ctypes
    bindings/abi/muslin_flat.h       all declarations without include, macro or attribute: cffi, LuaJIT, bindgen, koffi
    bindings/abi/muslin_abi.json     functions, layout of structs, constants: for whoever has no C parser
    tests/abi/baseline.txt           the ABI as it was recorded, with --record only (tests/abi/test_baseline.py)

The headers keep to a small part of C (no struct by value, no enum-typed field, no macro that does work), so that a
page of regular expressions reads them whole; what it cannot read it refuses by name. tests/python/test_abi.py runs
it again and compares, and compares the layout of each struct with what a C compiler says.

    python3 bindings/python/generate.py           writes the first three
    python3 bindings/python/generate.py --check   exit 1 when one of them is not up to date
    python3 bindings/python/generate.py --record  writes the baseline too: the ABI changes on purpose
"""
import json
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
BASELINE = ROOT / "tests" / "abi" / "baseline.txt"
ORDER = ["base", "language", "tape", "body", "pose", "scan", "manifold", "pattern", "topology", "edit", "layout", "design",
         "cloth", "integrate", "arrange", "drape", "dress", "fit", "print", "exchange", "catalogue"]
LIBRARY = {"print": "print", "exchange": "exchange", "catalogue": "catalogue"}  # all else is libmuslin
SCALAR = {"mus_status": "c_int32", "int32_t": "c_int32", "int64_t": "c_int64", "uint64_t": "c_uint64",
          "uint8_t": "c_uint8",
          "size_t": "c_size_t", "double": "c_double", "float": "c_float", "char": "c_char", "int": "c_int"}
# bytes of a scalar, and of a pointer, where a pointer has 8 bytes; each is aligned to its size
BYTES = {"mus_status": 4, "int32_t": 4, "int64_t": 8, "uint64_t": 8, "uint8_t": 1, "size_t": 8, "double": 8, "float": 4,
         "char": 1, "int": 4}
POINTER = 8


class Headers:
    """What the headers declare, in their order."""

    def __init__(self, folder):
        self.constants = {}  # name -> int
        self.names = {}      # "STATUS" / "MEASURE" -> list of names
        self.handles = []    # opaque types
        self.structs = {}    # name -> [(field, C type, [array lengths])]
        self.callbacks = {}  # name -> (result, [(type, argument)])
        self.functions = {}  # name -> (library, result, [(type, argument)])
        for header in ORDER:
            self.read(header, (folder / f"{header}.h").read_text())

    def read(self, header, text):
        text = re.sub(r"/\*.*?\*/", " ", text, flags=re.S).replace("\\\n", " ")
        for name, value in re.findall(r"^#define (MUS_\w+) \(?(-?\d+|0x[0-9a-f]+)\)?[ \t]*$", text, re.M):
            self.constants[name] = int(value, 0)
        unread = set(re.findall(r"^#define (MUS_\w+)[ \t]+\S", text, re.M)) - {"MUS_API"} - set(self.constants)
        assert not unread, f"{header}.h: cannot read the value of {', '.join(sorted(unread))}"
        self.read_lists(text)
        text = re.sub(r"^\s*#.*$", "", text, flags=re.M)
        for name in re.findall(r"typedef struct (mus_\w+) \1;", text):
            self.handles.append(name)
        for result, name, arguments in re.findall(r"typedef (\w[\w ]*?[ *])\(\*(mus_\w+)\)\(([^)]*)\);", text):
            self.callbacks[name] = (result.strip(), self.arguments(name, arguments))
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
            match = re.fullmatch(r"\s*(.*?[ *])(\w+)\s*", argument)
            assert match, f"{where}: cannot read the argument {argument!r}"
            types.append((" ".join(match[1].split()), match[2]))
        return types

    def field(self, where, text):
        match = re.fullmatch(r"(.*?[ *])(\w+)((?:\[\w+\])*)", " ".join(text.split()))
        assert match, f"{where}: cannot read the field {text!r}"
        sizes = [int(self.constants.get(size, size)) for size in re.findall(r"\w+", match[3])]
        return match[2], match[1].strip(), sizes

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


    def place(self, struct):
        """(bytes, [offset of each field]) of a struct where a pointer has 8 bytes."""
        at, widest, offsets = 0, 1, []
        for field, kind, sizes in self.structs[struct]:
            pointer = kind.endswith("*") or kind in self.callbacks
            assert pointer or kind in BYTES, f"{struct}.{field}: a {kind} by value"
            one = POINTER if pointer else BYTES[kind]
            at, widest = (at + one - 1) // one * one, max(widest, one)
            offsets.append(at)
            for size in sizes:
                one *= size
            at += one
        return (at + widest - 1) // widest * widest, offsets


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


def array(sizes):
    return "".join(f"[{size}]" for size in sizes)


def declared(kind, name):
    """A C type and a name: "double x", "double *x"."""
    return f"{kind}{'' if kind.endswith('*') else ' '}{name}"


def signature(result, name, arguments):
    return f"{declared(result, name)}({', '.join(declared(kind, argument) for kind, argument in arguments) or 'void'});"


def version(headers):
    return ".".join(str(headers.constants[f"MUS_VERSION_{part}"]) for part in ("MAJOR", "MINOR", "PATCH"))


def render_flat(headers):
    """All declarations, for parsers that have no preprocessor."""
    out = [f"/* muslin_flat.h: muslin {version(headers)} as plain declarations, for foreign-function interfaces.",
           " *", " * No include, no macro, no attribute: cffi and LuaJIT read it as it is; a C compiler wants <stddef.h> and",
           " * <stdint.h> before it. Written by bindings/python/generate.py from include/muslin/; do not edit. The contract",
           " * of each function stands in those headers and in the manual. */", "", "enum {"]
    names = list(headers.constants.items())
    out += [f"    {name} = {value}{',' if i + 1 < len(names) else ''}" for i, (name, value) in enumerate(names)]
    out += ["};", "", "typedef int32_t mus_status;"]
    out += [f"typedef struct {name} {name};" for name in [*headers.handles, *headers.structs]]
    for name, (result, arguments) in headers.callbacks.items():
        out += [f"typedef {signature(result, f'(*{name})', arguments)}"]
    for name, fields in headers.structs.items():
        out += ["", f"struct {name} {{"]
        out += [f"    {declared(kind, field)}{array(sizes)};" for field, kind, sizes in fields] + ["};"]
    library = None
    for name, (part, result, arguments) in headers.functions.items():
        if part != library:
            library = part
            out += ["", f"/* libmuslin{'' if part == 'core' else f'-{part}'} */"]
        out.append(signature(result, name, arguments))
    return "\n".join(out + [""])


def rows(items):
    """A JSON object with one line for each member."""
    return "{\n" + ",\n".join(f"  {json.dumps(name)}: {json.dumps(value)}" for name, value in items) + "\n }"


def render_json(headers):
    """Functions, structs with offsets, constants, as JSON."""
    def named(arguments):
        return [{"name": argument, "type": kind} for kind, argument in arguments]
    structs = {}
    for name, fields in headers.structs.items():
        size, offsets = headers.place(name)
        structs[name] = {"size": size, "fields": [
            {"name": field, "type": kind, "offset": offset, **({"array": sizes} if sizes else {})}
            for (field, kind, sizes), offset in zip(fields, offsets)]}
    parts = [("version", json.dumps(version(headers))), ("abi", json.dumps(headers.constants["MUS_ABI"])),
             ("pointer_bytes", json.dumps(POINTER)),
             ("handles", json.dumps(headers.handles)),
             ("constants", rows(headers.constants.items())),
             ("names", rows(headers.names.items())),
             ("callbacks", rows((name, {"result": result, "arguments": named(arguments)})
                                for name, (result, arguments) in headers.callbacks.items())),
             ("structs", rows(structs.items())),
             ("functions", rows((name, {"library": "libmuslin" if part == "core" else f"libmuslin-{part}",
                                        "result": result, "arguments": named(arguments)})
                                for name, (part, result, arguments) in headers.functions.items()))]
    return "{\n" + ",\n".join(f" {json.dumps(name)}: {text}" for name, text in parts) + "\n}\n"


def render_baseline(headers):
    """What a program that is linked against this ABI relies on, a sorted line each. The size of a struct is not in it:
    fields may be added at its end. The number of entries of a list, which may grow, has its name alone."""
    lines = [f"handle {name}" for name in headers.handles]
    lines += [f"constant {name}" if name.endswith("_COUNT") else f"constant {name} {value}"
              for name, value in headers.constants.items() if not name.startswith("MUS_VERSION_")]
    lines += [f"callback {name} {result} ({', '.join(kind for kind, _ in arguments)})"
              for name, (result, arguments) in headers.callbacks.items()]
    for name, fields in headers.structs.items():
        lines += [f"field {name}.{field} at {offset} {kind}{array(sizes)}"
                  for (field, kind, sizes), offset in zip(fields, headers.place(name)[1])]
    lines += [f"function {name} {part} {result} ({', '.join(kind for kind, _ in arguments)})"
              for name, (part, result, arguments) in headers.functions.items()]
    return "\n".join(sorted(lines)) + "\n"


def render(headers):
    out = ['"""_abi.py: the C interface as ctypes sees it, and nothing else.',
           "", "Written by bindings/python/generate.py from include/muslin/*.h; do not edit.", '"""',
           "from ctypes import (CFUNCTYPE, POINTER, Structure, c_char, c_char_p, c_double, c_float, c_int32, c_int64,",
           "                    c_size_t, c_uint64, c_uint8, c_void_p)", "", f'VERSION = "{version(headers)}"', "", "# constants"]
    out += [f"{name} = {value}" for name, value in headers.constants.items()]
    out += ["", "# names of the lists, by number"]
    for kind, names in headers.names.items():
        out.append(wrap(f"{kind}_NAMES = (", [f'"{name}"' for name in names], ")"))
    out += ["", "", "# opaque handles, and structs, whose fields stand below"]
    for name in [*headers.handles, *headers.structs]:
        out += ["", "", f"class {name}(Structure):", "    pass"]
    out += ["", "", "# callbacks"]
    for name, (result, arguments) in headers.callbacks.items():
        kinds = [result, *(kind for kind, _ in arguments)]
        out.append(f"{name} = CFUNCTYPE({', '.join(headers.ctype(kind) for kind in kinds)})")
    out += ["", "# fields of the structs"]
    for name, fields in headers.structs.items():
        out += [wrap(f"{name}._fields_ = [", [f'("{field}", {" * ".join([headers.ctype(kind), *map(str, reversed(sizes))])})'
                                        for field, kind, sizes in fields], "]")]
    out += ["", "", "# functions: name -> (library, result, arguments)", "FUNCTIONS = {"]
    for name, (library, result, arguments) in headers.functions.items():
        kinds = [headers.ctype(kind) for kind, _ in arguments]
        out.append(wrap(f'    "{name}": ("{library}", {headers.ctype(result)}, [', kinds, "]),"))
    return "\n".join(out + ["}", ""])


def main():
    headers = Headers(ROOT / "include" / "muslin")
    files = {ROOT / "bindings" / "python" / "muslin" / "_abi.py": render(headers),
             ROOT / "bindings" / "abi" / "muslin_flat.h": render_flat(headers),
             ROOT / "bindings" / "abi" / "muslin_abi.json": render_json(headers)}
    if "--record" in sys.argv[1:]:
        files[BASELINE] = render_baseline(headers)
    stale = [file for file, text in files.items() if not file.exists() or file.read_text() != text]
    if "--check" in sys.argv[1:]:
        for file in stale:
            print(f"{file.relative_to(ROOT)} is not that of the headers: run bindings/python/generate.py")
        return 1 if stale else 0
    for file in stale:
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(files[file])
    return 0


if __name__ == "__main__":
    sys.exit(main())
