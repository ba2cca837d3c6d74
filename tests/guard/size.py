#!/usr/bin/env python3
"""size.py: a file is one idea (at most 600 lines), a function one thing (at most 80 lines but for a switch or a table),
a line at most 120 columns; two blank lines between functions of lib and examples."""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
FILE_LINES, FUNCTION_LINES, COLUMNS = 600, 80, 120


def functions(lines):
    """(first line, name line, length, body) of each function: brace in column 0 to brace in column 0."""
    start = None
    for number, line in enumerate(lines, 1):
        if line == "{":
            start = number
        elif line == "}" and start is not None:
            yield start, lines[start - 2], number - start, lines[start:number]
            start = None


def check(path):
    lines = (ROOT / path).read_text().split("\n")
    if len(lines) - 1 > FILE_LINES:
        yield f"{path}: {len(lines) - 1} lines, at most {FILE_LINES}"
    for number, line in enumerate(lines, 1):
        if len(line) > COLUMNS and "http" not in line:
            yield f"{path}:{number}: {len(line)} columns, at most {COLUMNS}"
        if line != line.rstrip() or "\t" in line:
            yield f"{path}:{number}: a tab, or blanks at the end"
    if not path.endswith(".c"):
        return
    for start, name, length, body in functions(lines):
        if length > FUNCTION_LINES and not any(re.match(r"\s+switch ", line) for line in body):
            yield f"{path}:{start}: {length} lines, at most {FUNCTION_LINES}: {name[:70]}"


def main():
    files = [file for folder in ("lib", "include", "examples", "tests") for file in sorted((ROOT / folder).rglob("*"))]
    faults = [fault for file in files if file.suffix in (".c", ".h", ".cpp")
              for fault in check(file.relative_to(ROOT).as_posix())]
    print("\n".join(faults), end="\n" if faults else "")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
