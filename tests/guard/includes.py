#!/usr/bin/env python3
"""includes.py: every #include of lib, include and examples against includes.allow; file base names unique in lib."""
import collections
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.M)


def read_table():
    rows = {}
    for line in (pathlib.Path(__file__).parent / "includes.allow").read_text().splitlines():
        if line.strip() and not line.startswith("#"):
            what, folders, public, outside = (part.split() for part in line.split("|"))
            rows[what[0]] = (set(folders), set(public), set(outside))
    return rows


def row_of(path, rows):
    """The row with the longest name that the path starts with."""
    names = [name for name in rows if path == name or path.startswith(name + "/")]
    return rows[max(names, key=len)] if names else None


def allowed(path, kind, target, row, common):
    folders, public, outside = row
    head = target.split("/")[0]
    if target.startswith("muslin/"):
        return target[len("muslin/"):-len(".h")] in public
    if kind == "<":
        return head.removesuffix(".h") in outside | common or re.split(r"[-/.]", target)[0] in outside
    if "examples" in folders:
        return True
    if "/" not in target:  # beside the file itself
        return (ROOT / path).with_name(target).exists()
    return head in folders or target in folders


def main():
    rows = read_table()
    common = rows.pop("*")[2]
    faults = []
    seen = collections.defaultdict(list)
    files = [p for folder in ("lib", "include", "examples") for p in sorted((ROOT / folder).rglob("*.[ch]"))]
    for file in files:
        path = file.relative_to(ROOT).as_posix()
        if path.startswith("lib/"):
            seen[file.name].append(path)
        row = row_of(path, rows)
        if row is None:
            faults.append(f"{path}: its folder has no row in tests/guard/includes.allow")
            continue
        text = file.read_text()
        for match in INCLUDE.finditer(text):
            if not allowed(path, match[1], match[2], row, common):
                line = text.count("\n", 0, match.start(2)) + 1
                faults.append(f"{path}:{line}: may not include {match[2]} (tests/guard/includes.allow)")
    faults += [f"one base name, {len(paths)} files: {' '.join(paths)}" for paths in seen.values() if len(paths) > 1]
    print("\n".join(faults), end="\n" if faults else "")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
