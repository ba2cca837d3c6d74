#!/usr/bin/env python3
"""house.py [OUT] [--check]: the house in figures: rooms, headers, functions, docstrings, comments, circles.

Prints a row for each room (folder of lib/) and the figures of the whole. With --check it prints only what is beyond a
limit, and exits 1 then; an aim that is missed is printed and is no failure. OUT is the build folder, whose object files
tell the circles; without it they are not counted.
"""
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import circles
import size

ROOT = size.ROOT
AIMS = {"lines of lib": 55000}
LIMITS = {
    "lines of a room": 5000,
    "files of a room": 30,
    "lines of an internal header": 120,
    "lines of a function": 60,
    "parameters": 8,
    "public functions without a docstring": 0,
    "circles": circles.MOST,
    "lines of the Makefile": 240,
    "lines of README.md": 150,
}
# the limit of a header holds for what a room shows; the template of a kernel is code
KERNEL = "_kernel.h"


def strip_comments(text):
    """The text without comments; line breaks stay."""
    return re.sub(r"/\*.*?\*/", lambda m: re.sub(r"[^\n]", "", m[0]), text, flags=re.S)


def split_lines(text):
    """Lines of code, lines of comment alone, empty lines."""
    lines, bare = text.splitlines(), strip_comments(text).splitlines()
    code = sum(1 for line in bare if line.strip())
    empty = sum(1 for line in lines if not line.strip())
    return code, len(lines) - code - empty, empty


def parameters(signature):
    """How many parameters a signature has: the commas of its outermost brackets."""
    depth, count, text = 0, 0, ""
    for c in signature[signature.find("("):]:
        depth += (c == "(") - (c == ")")
        count += c == "," and depth == 1
        text += c
        if depth == 0:
            break
    return 0 if text.strip("() \n") in ("", "void") else count + 1


def functions(path):
    """(line, signature, lines of the body) of each function of a C file or kernel header."""
    lines = strip_comments(path.read_text()).split("\n")
    for start, _name, length, _body in size.functions(lines):
        first = start - 2
        while first > 0 and lines[first - 1].strip() and lines[first - 1][-1] not in ";}\\" and lines[first - 1][0] != "#":
            first -= 1
        yield start, " ".join(lines[first:start - 1]), length


def prototypes(path):
    """(line, name, whether a docstring ends on the line above, parameters) of each MUS_API function of a header."""
    text = path.read_text()
    lines = text.split("\n")
    for number, line in enumerate(lines):
        if line.startswith("MUS_API "):
            whole = text.split("\n", number)[-1]
            whole = whole[:whole.index(";")]
            name = re.search(r"(\w+)\s*\(", whole)[1]
            yield number + 1, name, lines[number - 1].rstrip().endswith("*/"), parameters(whole[whole.index(name):])


def measure(out):
    """(rows of the table of rooms, figures of the whole, places that are beyond a limit)."""
    rooms, faults, missed, figures = [], [], [], {}

    def hold(what, value, place):
        most = LIMITS.get(what, AIMS.get(what))
        if value > most:
            (faults if what in LIMITS else missed).append(f"{place}: {value} {what}, at most {most}")

    code = comment = total = functions_all = functions_long = widest = longest = 0
    for room in sorted(p for p in (ROOT / "lib").iterdir() if p.is_dir()):
        files = sorted(room.glob("*.[ch]"))
        lines = {f: len(f.read_text().splitlines()) for f in files}
        parts = [split_lines(f.read_text()) for f in files]
        headers = {f.name: n for f, n in lines.items() if f.suffix == ".h" and not f.name.endswith(KERNEL)}
        tallest = max(headers.items(), key=lambda item: item[1], default=("-", 0))
        rooms.append((room.name, len(files), sum(lines.values()), tallest[1], tallest[0],
                      sum(p[1] for p in parts) / max(1, sum(p[0] for p in parts))))
        hold("files of a room", len(files), f"lib/{room.name}")
        hold("lines of a room", sum(lines.values()), f"lib/{room.name}")
        for name, n in headers.items():
            hold("lines of an internal header", n, f"lib/{room.name}/{name}")
        code, comment = code + sum(p[0] for p in parts), comment + sum(p[1] for p in parts)
        total += sum(lines.values())
        for file in files:
            for line, signature, length in functions(file):
                place = f"{file.relative_to(ROOT)}:{line}"
                functions_all += 1
                longest, widest = max(longest, length), max(widest, parameters(signature))
                hold("lines of a function", length, place)
                hold("parameters", parameters(signature), place)
    hold("lines of lib", total, "lib")

    public = undocumented = 0
    for header in sorted((ROOT / "include/muslin").glob("*.h")):
        for line, name, documented, count in prototypes(header):
            place = f"{header.relative_to(ROOT)}:{line}: {name}"
            public, undocumented = public + 1, undocumented + (not documented)
            hold("parameters", count, place)
            widest = max(widest, count)
            hold("public functions without a docstring", int(not documented), place)

    makefile, readme = (len((ROOT / f).read_text().splitlines()) for f in ("Makefile", "README.md"))
    hold("lines of the Makefile", makefile, "Makefile")
    hold("lines of README.md", readme, "README.md")
    figures = {"lib: lines": total, "lib: rooms": len(rooms), "lib: files": sum(r[1] for r in rooms),
               "lib: comment lines to code lines": f"{100 * comment / code:.1f} %", "functions": functions_all,
               "longest function": longest, "most parameters": widest, "public functions": public,
               "public functions without a docstring": undocumented,
               "lines of the Makefile": makefile, "lines of README.md": readme}
    if out:
        files, floors = circles.measure(out)
        figures["circles of files"], figures["circles of rooms"] = len(files), len(floors)
        hold("circles", len(files) + len(floors), "lib")
    return rooms, figures, faults, missed


def main():
    out = next((a for a in sys.argv[1:] if not a.startswith("-")), None)
    rooms, figures, faults, missed = measure(out)
    if "--check" in sys.argv:
        print("\n".join(faults + [f"aim: {line}" for line in missed]))
        return 1 if faults else 0
    print(f"{'room':<12} {'files':>5} {'lines':>6} {'tallest header':>28} {'comment/code':>12}")
    for name, files, lines, tall, header, share in sorted(rooms, key=lambda r: -r[2]):
        print(f"{name:<12} {files:5} {lines:6} {header + ' ' + str(tall):>28} {100 * share:10.1f} %")
    for what, value in figures.items():
        print(f"{what}: {value}")
    print(f"{len(faults)} beyond a limit, {len(missed)} beyond an aim (house.py --check lists them)")
    return 0


if __name__ == "__main__":
    sys.exit(main())
