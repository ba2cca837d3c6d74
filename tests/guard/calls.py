#!/usr/bin/env python3
"""calls.py: every public function has a row in tests/extreme/every_call.h; test_every_call.c makes it lack memory.

Prints functions of include/muslin/*.h without a row, and rows without a function; exit 1 when there are any.
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
# a row of its own in test_every_call.c: it has no status
BY_HAND = {"mus_context_alloc"}


def plain(text):
    """A header without its remarks and macros."""
    return re.sub(r"^#.*?(?<!\\)$", "", re.sub(r"/\*.*?\*/", "", text, flags=re.S), flags=re.M | re.S)


def main():
    headers = "\n".join(plain(file.read_text()) for file in sorted((ROOT / "include/muslin").glob("*.h")))
    functions = set(re.findall(r"MUS_API [^;(]*?\b(mus_\w+)\(", headers))
    table = (ROOT / "tests/extreme/every_call.h").read_text()
    rows = set(re.findall(r"^    X\((mus_\w+),", table, flags=re.M)) | BY_HAND
    faults = [f"{name}: no row in tests/extreme/every_call.h says what it does without memory"
              for name in functions - rows]
    faults += [f"{name}: a row in tests/extreme/every_call.h, and no such function" for name in rows - functions]
    print("\n".join(sorted(faults)), end="\n" if faults else "")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
