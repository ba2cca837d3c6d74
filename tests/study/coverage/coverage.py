#!/usr/bin/env python3
"""coverage.py --out FOLDER [--suites NAME ...] [--files] [ROOM ...]: lines that C tests reach, room by room.

FOLDER is a build of `make config=coverage tests`. Its counters are emptied, the suites run (fuzz, if none is named:
the fuzz targets on their seeds and on damaged copies of them), and gcov counts the lines of each file. ROOM: a folder of
lib/, or examples/command; if none is named, those that read files: exchange, trade, valentina, meshfile, catalogue.
--files tells each file too.
"""
import argparse
import os
import pathlib
import re
import subprocess
import sys

READERS = ["exchange", "trade", "valentina", "meshfile", "catalogue"]
REPORT = re.compile(r"File '(.*)'\nLines executed:([0-9.]+)% of (\d+)")


def lines_of(out, source):
    """(lines reached, lines) of a source file; gcov is asked in the folder of its object."""
    counters = out / "obj" / source.with_suffix(".gcda")
    if not counters.exists():
        notes = counters.with_suffix(".gcno")
        if not notes.exists():  # no test is linked with it
            return 0, 0
        counters = notes
    told = subprocess.run(["gcov", "-n", counters], check=True, capture_output=True, text=True).stdout
    for name, share, count in REPORT.findall(told):
        if pathlib.Path(name) == source:
            return round(float(share) * int(count) / 100.0), int(count)
    return 0, 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--out", required=True, type=pathlib.Path)
    parser.add_argument("--suites", nargs="+", default=["fuzz"])
    parser.add_argument("--files", action="store_true")
    parser.add_argument("rooms", nargs="*", metavar="ROOM")
    options = parser.parse_args()
    for counters in (options.out / "obj").rglob("*.gcda"):
        counters.unlink()
    for suite in options.suites:
        done = subprocess.run([options.out / "bin/tests"], stdout=subprocess.DEVNULL,
                              env={**os.environ, "CK_RUN_SUITE": suite, "CK_TIMEOUT_MULTIPLIER": "10"})
        if done.returncode:
            sys.exit(f"coverage.py: the suite {suite} failed")
    all_reached, all_lines = 0, 0
    for room in options.rooms or READERS:
        folder = pathlib.Path(room if "/" in room else f"lib/{room}")
        rows = [(source, *lines_of(options.out, source)) for source in sorted(folder.glob("*.c"))]
        reached, lines = sum(row[1] for row in rows), sum(row[2] for row in rows)
        if lines == 0:
            sys.exit(f"coverage.py: {options.out} has no counted lines of {folder}: make config=coverage tests")
        all_reached, all_lines = all_reached + reached, all_lines + lines
        print(f"{room}: {reached} of {lines} lines, {100.0 * reached / max(lines, 1):.1f} %")
        for source, one, of in rows if options.files else []:
            print(f"    {source.name}: {one} of {of}, {100.0 * one / max(of, 1):.1f} %")
    print(f"all: {all_reached} of {all_lines} lines, {100.0 * all_reached / max(all_lines, 1):.1f} %")


if __name__ == "__main__":
    main()
