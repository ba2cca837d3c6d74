#!/usr/bin/env python3
"""Feet on the floor: the lowest vertex of each standing foot in every named pose, read from written OBJ files.

For each size `muslin body --obj` writes the body as made and in each pose. A vertex keeps its index from pose to pose,
so the vertices of a foot are those below the ankle in the body as made, to the left or the right of the middle. A row
gives for the left and the right foot the height of the lowest vertex above the floor (Y = 0) [mm]; a foot that does not
stand in the pose has its height in brackets. A row holds when each standing foot is within the tolerance of the floor
and no vertex of the body is below it by more than that.
"""
import argparse
import pathlib
import subprocess
import sys
import tempfile

SIZES = "W36,W46,W52,M46,M58,C116"
STANDING = {"kneel": (), "knee_up": (1,)}  # feet that stand, 0 left, 1 right; both in poses that are not listed
ANKLE = 0.04  # height of the vertices of a foot at most, in parts of the stature; chosen: below the ankle


def vertices(command, path, *arguments):
    """Vertices of the body that `muslin body` writes."""
    subprocess.run([command, "body", *arguments, "--obj", path], check=True, stdout=subprocess.DEVNULL)
    with open(path, encoding="ascii") as lines:
        return [tuple(map(float, line.split()[1:4])) for line in lines if line.startswith("v ")]


def feet_of(rest):
    """Indices of the vertices of the left and of the right foot of the body as made."""
    top = ANKLE * max(x[1] for x in rest)
    low = [i for i, x in enumerate(rest) if x[1] < top]
    return [i for i in low if rest[i][0] > 0.0], [i for i in low if rest[i][0] < 0.0]


def main():
    parse = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parse.add_argument("--command", required=True)
    parse.add_argument("--sizes", default=SIZES)
    parse.add_argument("--poses", help="names in place of all")
    parse.add_argument("--tolerance", type=float, default=1.0, help="[mm], 1 if not given")
    own = parse.parse_args()
    said = subprocess.run([own.command, "body", "--poses"], check=True, capture_output=True, text=True).stdout
    poses = own.poses.split(",") if own.poses else [row.split()[1] for row in said.splitlines() if row[:4] == "pose"]
    sizes = own.sizes.split(",")
    failed, worst, rows = 0, 0.0, {pose: [] for pose in poses}
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "body.obj"
        for size in sizes:
            feet = feet_of(vertices(own.command, path, "--size", size))
            for pose in poses:
                x = vertices(own.command, path, "--size", size, "--pose", pose)
                stand = STANDING.get(pose, (0, 1))
                low = [1e3 * min(x[i][1] for i in foot) for foot in feet]
                off = max([abs(low[f]) for f in stand] + [-1e3 * min(y for _, y, _ in x)])
                failed, worst = failed + (off > own.tolerance), max(worst, off)
                rows[pose].append(" ".join(f"{low[f]:7.2f} " if f in stand else f"({low[f]:6.1f})" for f in (0, 1))
                                  + ("!" if off > own.tolerance else " "))
    print(f"{'left, right [mm]':14}" + "".join(f"{size:^20}" for size in sizes))
    for pose in poses:
        print(f"{pose:16}" + "  ".join(rows[pose]))
    print(f"{len(poses)} poses of {len(sizes)} bodies: {failed} off the floor by more than {own.tolerance:g} mm, "
          f"the worst by {worst:.2f} mm")
    sys.exit(failed > 0)


if __name__ == "__main__":
    main()
