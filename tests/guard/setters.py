#!/usr/bin/env python3
"""setters.py: every number that a public header takes is tried with NaN and infinity by a test.

Takes from include/muslin/*.h the double members of structs that a caller fills, and the functions with a double or an
array of doubles among their arguments; each must be named in tests/extreme/test_refused_*.c ("mus_x_def.member",
"mus_x_set_y"). Structs that only come out, and questions that take no number, are not doors.
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
# filled by the library for the caller to read
OUT = {"mus_seam_walk", "mus_drape_report", "mus_scan_report", "mus_topology", "mus_estimate", "mus_reason",
       "mus_fit_level", "mus_fit_spread", "mus_worn", "mus_dress_report", "mus_progress",
       "mus_sheet_piece", "mus_sheet_line", "mus_layout_piece"}


def plain(text):
    """A header without its remarks and without the values of its macros."""
    return re.sub(r"^#.*?(?<!\\)$", "", re.sub(r"/\*.*?\*/", "", text, flags=re.S), flags=re.M | re.S)


def members(text):
    """Names of the double members of each struct, and of members that are such a struct themselves."""
    for body, name in re.findall(r"typedef struct \w+ \{([^}]*)\} (\w+);", text):
        for line in re.findall(r"(?:const )?double ([^;]*);", body):
            for member in line.split(","):
                yield name, re.sub(r"[*\s]|\[.*", "", member)


def functions(text):
    """Functions with a double, or const doubles, among their arguments; what fills `double *out` takes none."""
    for name, arguments in re.findall(r"MUS_API [^;(]*?\b(mus_\w+)\(([^;]*)\);", text):
        if any(re.search(r"\bdouble\b", a) and ("*" not in a or "const double *" in a and "**" not in a)
               for a in arguments.split(",")):
            yield name


def main():
    tests = "\n".join(file.read_text() for file in sorted((ROOT / "tests/extreme").glob("test_refused_*.c")))
    named = set(re.findall(r"mus_\w+(?:\.\w+)*", tests))
    named |= {f"{a}.{b}" for a, b in re.findall(r"REFUSED\((\w+), ([\w.]+),", tests)}
    faults = []
    for header in sorted((ROOT / "include/muslin").glob("*.h")):
        text = plain(header.read_text())
        doors = [f"{struct}.{member}" for struct, member in members(text) if struct not in OUT]
        doors += [name for name in functions(text) if not name.endswith("_report")]
        faults += [f"{header.name}: {door} is tried with NaN and infinity by no test of tests/extreme/test_refused_*.c"
                   for door in doors if door not in named]
    print("\n".join(faults), end="\n" if faults else "")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
