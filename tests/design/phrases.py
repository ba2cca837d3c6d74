#!/usr/bin/env python3
"""phrases.py: how many of the phrases that people type find their design first.

    python3 tests/design/phrases.py [-v] [FILE...]      needs build/lib (make); default: the two lists beside this file

A line of a list is a phrase, "|", and the names of the designs that are right, with * for any letters. Each phrase
goes to mus_design_search(). Prints the share for each list, and the phrases whose first design is another; exit 1 when
a list has less than 55 of 60 right.
"""
import fnmatch
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "bindings" / "python"))
from muslin import design  # noqa: E402

SHARE = 55 / 60  # of the phrases of a list whose first design is right


def phrases(path):
    for line in path.read_text(encoding="utf-8").splitlines():
        if line and not line.startswith("#"):
            phrase, names = line.split("|")
            yield phrase.strip(), names.split()


def judge(path, verbose):
    right = total = 0
    for phrase, names in phrases(path):
        found = [row["name"] for row in design.designs(phrase, 5)]
        good = bool(found) and any(fnmatch.fnmatchcase(found[0], name) for name in names)
        right, total = right + good, total + 1
        if verbose or not good:
            print(f"{'ok  ' if good else 'miss'} {phrase}: {' '.join(found) or 'none'}")
    print(f"{path.name}: {right} of {total} phrases find their design first")
    return right >= SHARE * total


def main(arguments):
    verbose = "-v" in arguments
    paths = [pathlib.Path(a) for a in arguments if a != "-v"] or sorted(HERE.glob("phrases*.txt"))
    return 0 if all([judge(path, verbose) for path in paths]) else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
