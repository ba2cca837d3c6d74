#!/usr/bin/env python3
"""Girths of the three GarmentCode bodies: their yaml, sections of the mesh itself, and muslin's body of it.

Sections of the triangles are taken here, with numpy alone: the tape is the convex hull of the loop. For each girth: the
yaml's; the mesh at the yaml's height; its narrowest and fullest section within 3 cm of that; the girth that muslin
finds, and the mesh's own section at that very place. A row says "none" where neither the narrowest nor the fullest
section of the mesh within 3 cm has the yaml's girth to 5 mm, so that no slicer can find it there. It fails where muslin
is 2 mm from the mesh, or where a girth of the mesh is the yaml's so and what muslin finds is not. Heights are those of
the yaml (the wrist has none: the narrowest section square to the forearm); limbs are the right ones.
"""
import argparse
import json
import pathlib
import subprocess
import sys

import numpy as np

NEAR_CM, WITHIN_CM, SLICER_CM = 3.0, 0.5, 0.2


def load(path):
    """Vertices in cm above the floor, and triangles."""
    vertices, faces = [], []
    for line in path.read_text().splitlines():
        if line.startswith("v "):
            vertices.append([float(t) for t in line.split()[1:4]])
        elif line.startswith("f "):
            corner = [int(t.split("/")[0]) - 1 for t in line.split()[1:]]
            faces += [(corner[0], corner[k], corner[k + 1]) for k in range(1, len(corner) - 1)]
    vertices = 100.0 * np.array(vertices)
    vertices[:, 1] -= vertices[:, 1].min()
    return vertices, np.array(faces)


def tape(points):
    """Perimeter of the convex hull (Andrew's monotone chain)."""
    def turn(a, b, c):
        return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])

    def half(ordered):
        chain = []
        for p in ordered:
            while len(chain) > 1 and turn(chain[-2], chain[-1], p) <= 0.0:
                chain.pop()
            chain.append(p)
        return chain[:-1]
    ordered = points[np.lexsort((points[:, 1], points[:, 0]))]
    hull = np.array(half(ordered) + half(ordered[::-1]))
    return np.linalg.norm(hull - np.roll(hull, -1, 0), axis=1).sum()


def loops(mesh, point, normal):
    """Points of each loop in which a plane cuts the mesh."""
    vertices, faces = mesh
    height = (vertices - point) @ normal
    height = np.where(height == 0.0, 1e-9, height)
    up = height[faces] > 0.0
    cut, parent = {}, {}

    def root(key):
        while parent[key] != key:
            parent[key] = key = parent[parent[key]]
        return key
    for a, b, c in faces[up.any(1) & ~up.all(1)]:
        keys = []
        for p, q in ((a, b), (b, c), (c, a)):
            if (height[p] > 0.0) != (height[q] > 0.0):
                key = (min(p, q), max(p, q))
                if key not in cut:
                    part = height[p] / (height[p] - height[q])
                    cut[key], parent[key] = vertices[p] + part * (vertices[q] - vertices[p]), key
                keys.append(key)
        parent[root(keys[0])] = root(keys[1])
    found = {}
    for key, place in cut.items():
        found.setdefault(root(key), []).append(place)
    return [np.array(points) for points in found.values() if len(points) > 2]


def level(mesh, height, side):
    """Tape of the trunk (side 0) or of the right leg (-1) at a height."""
    own = [p for p in loops(mesh, np.array([0.0, height, 0.0]), np.array([0.0, 1.0, 0.0]))
           if (abs(p[:, 0].mean()) < 7.0 if side == 0 else -25.0 < p[:, 0].mean() < -3.0 and p[:, 0].max() < 0.5)]
    return max((tape(p[:, [0, 2]]) for p in own), default=float("nan"))


def wrist(mesh, down):
    """Narrowest tape square to the right forearm, whose axis is that of its middles, `down` degrees down at first."""
    angle = np.radians(down)
    axis, tip = np.array([-np.cos(angle), -np.sin(angle), 0.0]), mesh[0][mesh[0][:, 0].argmin()]

    def near(point, normal):
        own = [p for p in loops(mesh, point, normal) if np.linalg.norm(p.mean(0) - point) < 9.0]
        return min(own, key=lambda p: np.linalg.norm(p.mean(0) - point), default=None)
    middles = [p.mean(0) for p in (near(tip - t * axis, axis) for t in np.arange(22.0, 34.0, 1.0)) if p is not None]
    base = np.mean(middles, 0)
    own = np.linalg.svd(middles - base)[2][0]
    own *= np.sign(own @ axis)
    least = float("inf")
    for t in np.arange(0.0, 16.0, 0.25):
        p = near(base + t * own, own)
        if p is not None:
            flat = np.linalg.svd(p - p.mean(0), full_matrices=False)[2][:2]
            least = min(least, tape((p - p.mean(0)) @ flat.T))
    return least


def rows(name, mesh, yaml, found):
    nape = yaml["height"] - yaml["head_l"]
    waist = nape - yaml["waist_line"]
    hips = waist - yaml["hips_line"]
    crotch = hips - yaml["crotch_hip_diff"]
    asked = [("waist", "waist", waist, 0), ("hip", "hips", hips, 0), ("thigh", "leg_circ", crotch, -1)]
    if "vert_bust_line" in yaml:
        asked.insert(0, ("bust", "bust", nape - yaml["vert_bust_line"], 0))
    worst = 0
    for ours, key, height, side in asked:
        # above the crotch of the yaml the leg's section is partly the other leg's
        high = NEAR_CM if side == 0 else 0.0
        near = [level(mesh, height + t, side) for t in np.arange(-NEAR_CM, high + 0.01, 0.25)]
        own, at = 100.0 * found[ours]["tape_m"], 100.0 * found[ours]["at_m"]
        there = level(mesh, at, side)
        yes = min(abs(min(near) - yaml[key]), abs(max(near) - yaml[key])) <= WITHIN_CM
        bad = abs(own - there) > SLICER_CM or (yes and abs(own - yaml[key]) > WITHIN_CM)
        print(f"{name:20} {key:9} yaml {yaml[key]:6.2f}  mesh there {level(mesh, height, side):6.2f}  within 3 cm "
              f"{min(near):6.2f} to {max(near):6.2f} {'yes ' if yes else 'none'}  muslin {own:6.2f} at {at:6.1f} cm, "
              f"mesh {there:6.2f}  {'NO' if bad else 'ok'}")
        worst += bad
    own, least = 100.0 * found["wrist"]["tape_m"], wrist(mesh, yaml["arm_pose_angle"])
    yes = abs(least - yaml["wrist"]) <= WITHIN_CM
    bad = abs(own - least) > SLICER_CM
    print(f"{name:20} {'wrist':9} yaml {yaml['wrist']:6.2f}  mesh, narrowest {least:6.2f} {'yes ' if yes else 'none'}  "
          f"muslin {own:6.2f}  {'NO' if bad else 'ok'}")
    return worst + bad


def main():
    parse = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parse.add_argument("--command", required=True)
    parse.add_argument("--data", required=True, type=pathlib.Path)
    own = parse.parse_args()
    worst = 0
    for path in sorted((own.data / "garmentcode" / "bodies").glob("*.obj")):
        text = subprocess.run([own.command, "body", "--mesh", path, "--json"], capture_output=True, check=True).stdout
        lines = (line.split("#")[0].split(":") for line in path.with_suffix(".yaml").read_text().splitlines())
        yaml = {line[0].strip(): float(line[1]) for line in lines if len(line) == 2 and line[1].strip()}
        worst += rows(path.stem, load(path), yaml, json.loads(text)["girths"])
    print(f"{worst} rows fail")
    return 1 if worst else 0


if __name__ == "__main__":
    sys.exit(main())
