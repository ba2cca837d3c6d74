#!/usr/bin/env python3
"""compare.py REFERENCE OTHER: two outputs of figures.c. `near` lines must be the same to 1e-12 of their size, all
others the same text. Prints what differs and the largest difference; exit 1 when something does."""
import math
import sys

NEAR = 1e-12


def read(path):
    with open(path) as file:
        return {name: (kind, value) for kind, name, value in map(str.split, file)}


def main():
    one, two = read(sys.argv[1]), read(sys.argv[2])
    faults = [f"{name}: only in one of the two" for name in one.keys() ^ two.keys()]
    worst = 0.0
    for name in one.keys() & two.keys():
        (kind, a), (_, b) = one[name], two[name]
        if a == b:
            continue
        if kind != "near":
            faults.append(f"{name}: {a} and {b}")
            continue
        away = abs(float(a) - float(b)) / max(abs(float(a)), 1e-3)
        worst = max(worst, away)
        if math.isnan(away) or away > NEAR:
            faults.append(f"{name}: {a} and {b}, {away:.1e} apart")
    print("\n".join(sorted(faults)[:20]), end="\n" if faults else "")
    same = sum(one[name] == two.get(name) for name in one)
    print(f"{same} of {len(one)} figures the same to the bit, the others at most {worst:.1e} apart, {len(faults)} faults")
    return 1 if faults or not one else 0


if __name__ == "__main__":
    sys.exit(main())
