#!/usr/bin/env python3
"""circles.py OUT [--list]: which files of lib/ need each other, read from the object files.

An object file that takes a symbol which another defines needs it. Files that need each other, directly or by way of
others, are a circle: none of them can be understood, tested or left out alone. Circles are allowed only when they stand
in circles.allow with a reason, at most MOST of them; rooms (folders of lib/) may not form any.
"""
import collections
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
MOST = 3


def symbols(objects):
    """For each object file: the names that it defines for others, and the names that it takes from others."""
    text = subprocess.run(["nm", "-A", *map(str, objects)], capture_output=True, text=True, check=True).stdout
    defined, taken = collections.defaultdict(set), collections.defaultdict(set)
    for line in text.splitlines():
        file, rest = line.split(":", 1)
        kind, name = rest.split()[-2:]
        if kind in "TDRBVWi":
            defined[file].add(name)
        elif kind == "U":
            taken[file].add(name)
    return defined, taken


def graph(objects):
    """For each object file the object files that it needs."""
    defined, taken = symbols(objects)
    home = {name: file for file, names in defined.items() for name in names}
    return {file: {home[name] for name in taken[file] if home.get(name, file) != file} for file in map(str, objects)}


def circles(edges):
    """The strongly connected components with more than one member (Tarjan 1972), without recursion."""
    index, low, on_stack, stack, found = {}, {}, set(), [], []
    for root in sorted(edges):
        if root in index:
            continue
        work = [(root, iter(sorted(edges[root])))]
        index[root] = low[root] = len(index)
        stack.append(root)
        on_stack.add(root)
        while work:
            node, targets = work[-1]
            target = next(targets, None)
            if target is None:
                work.pop()
                if work:
                    low[work[-1][0]] = min(low[work[-1][0]], low[node])
                if low[node] == index[node]:
                    members = []
                    while not members or members[-1] != node:
                        members.append(stack.pop())
                        on_stack.discard(members[-1])
                    if len(members) > 1:
                        found.append(sorted(members))
            elif target not in index:
                index[target] = low[target] = len(index)
                stack.append(target)
                on_stack.add(target)
                work.append((target, iter(sorted(edges[target]))))
            elif target in on_stack:
                low[node] = min(low[node], index[target])
    return found


def measure(out):
    """Circles of files, and circles of rooms, of the objects of the sources that there are."""
    out = pathlib.Path(out)
    folder = out / "obj"
    sources = sorted((ROOT / "lib").rglob("*.c"))
    objects = [folder / source.relative_to(ROOT).with_suffix(".o") for source in sources]
    edges = graph([o for o in objects if o.exists()])
    short = {file: pathlib.Path(file).relative_to(folder / "lib").with_suffix(".c").as_posix() for file in edges}
    edges = {short[file]: {short[t] for t in targets} for file, targets in edges.items()}
    rooms = collections.defaultdict(set)
    for file, targets in edges.items():
        rooms[file.split("/")[0]] |= {t.split("/")[0] for t in targets} - {file.split("/")[0]}
    return circles(edges), circles(rooms)


def read_allowed():
    path = pathlib.Path(__file__).with_name("circles.allow")
    rows = [line.split("|") for line in path.read_text().splitlines() if line.strip() and not line.startswith("#")]
    return [sorted(files.split()) for files, _reason in rows]


def main():
    files, rooms = measure(sys.argv[1])
    if "--list" in sys.argv:
        for circle in files + rooms:
            print(" ".join(circle))
        return 0
    allowed = read_allowed()
    faults = [f"files that need each other: {' '.join(circle)}" for circle in files if circle not in allowed]
    faults += [f"rooms that need each other: {' '.join(circle)}" for circle in rooms]
    faults += [f"circles.allow: these need each other no more: {' '.join(row)}" for row in allowed if row not in files]
    if len(allowed) > MOST:
        faults.append(f"circles.allow: {len(allowed)} rows, at most {MOST}")
    print("\n".join(faults), end="\n" if faults else "")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
