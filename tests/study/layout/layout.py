#!/usr/bin/env python3
"""layout.py: markers of the nesting data by the library, judged by code that shares nothing with it: `make layout`.

For each instance: the part of the strip that is covered, CPU seconds, steps, pairs that overlap, pieces that are not
those asked for or lie outside the strip, and the best layout known. Then jeans and shirt on folded cloth of 1.40 m with
nap, in metres, beside figures that others published. With --spyrrow the optional solver of that name runs on the same
instances (PyPI, in an environment of its own: --spyrrow=PATH/bin/python); its layouts go through the same judge, and
where it is absent a line says so.

The judge works on integers: every double is a multiple of a power of two, so crossings of sides have exact signs. Two
outlines overlap when sides of them cross or touch, or when one holds a point of the other. What touches without
overlap counts as well, which is stricter than needed.
    --effort N     billions of steps of each run (50: about 60 CPU seconds)
    --runs N       seeds; the shortest layout counts (2); they share --threads N (2)
    --least NAME=PERCENT[,...]   fail below (trousers=86,shirts=82)
"""
import argparse
import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile
from fractions import Fraction

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "bindings" / "python"))
NAMES = ["trousers", "shirts", "dagli", "mao", "blaz1", "shapes0", "jakobs1", "gardeyn0", "gardeyn4"]

# metres of cloth that others give, and for what: width [m], length [m]
PUBLISHED = {
    "jeans": [(1.47, 1.16, "outseam 42 in, hip 40 in, marker 57 in: N. A. Raaz, textilecalculations.com, formula")],
    "shirt": [(1.42, 1.46, "full sleeve, chest 110 cm: definetextile.com 2014, sum of boxes"),
              (1.50, 1.60, "full sleeve, custom made: P. Sarkar, onlineclothingstudy.com 2017")],
}


# ---- the judge ----

def integers(outlines):
    """The same outlines as integers: all coordinates times one power of two."""
    exact = [[(Fraction(x), Fraction(y)) for x, y in outline] for outline in outlines]
    scale = max(c.denominator for outline in exact for p in outline for c in p)
    return [[(int(x * scale), int(y * scale)) for x, y in outline] for outline in exact], scale


def turn(a, b, c):
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def box(points):
    xs, ys = [p[0] for p in points], [p[1] for p in points]
    return min(xs), min(ys), max(xs), max(ys)


def apart(a, b):
    return a[0] > b[2] or b[0] > a[2] or a[1] > b[3] or b[1] > a[3]


def sides(polygon):
    return [(polygon[i - 1], polygon[i]) for i in range(len(polygon))]


def cross(s, t):
    """Whether two sides share a point."""
    if apart(box(s), box(t)):
        return False
    one, two = turn(*s, t[0]), turn(*s, t[1])
    if (one > 0 and two > 0) or (one < 0 and two < 0):
        return False
    one, two = turn(*t, s[0]), turn(*t, s[1])
    return not ((one > 0 and two > 0) or (one < 0 and two < 0))


def holds(polygon, p):
    inside = False
    for a, b in sides(polygon):
        if (a[1] > p[1]) != (b[1] > p[1]) and (turn(a, b, p) > 0) == (b[1] > a[1]):
            inside = not inside
    return inside


def overlaps(outlines):
    """Pairs that share a point."""
    polygons, _ = integers(outlines)
    boxes = [box(p) for p in polygons]
    count = 0
    for i, a in enumerate(polygons):
        for j in range(i):
            b = polygons[j]
            if apart(boxes[i], boxes[j]):
                continue
            near_a = [s for s in sides(a) if not apart(box(s), boxes[j])]
            near_b = [s for s in sides(b) if not apart(box(s), boxes[i])]
            count += any(cross(s, t) for s in near_a for t in near_b) or holds(a, b[0]) or holds(b, a[0])
    return count


def wrong(instance, placed, length):
    """Pieces that are not the item in a turn allowed, or stick out of the strip; and items too few or too many.
    `placed`: (item, degrees, outline)."""
    height = instance["strip_height"]
    near = 1e-9 * max(height, length)
    bad = 0
    for item, degrees, outline in placed:
        shape = instance["items"][item]["shape"]["data"][:-1]
        allowed = instance["items"][item]["allowed_orientations"]
        angle = math.radians(degrees)
        c, s = math.cos(angle), math.sin(angle)
        moved = [(c * x - s * y, s * x + c * y) for x, y in shape]
        if len(outline) != len(moved):
            bad += 1
            continue
        dx, dy = outline[0][0] - moved[0][0], outline[0][1] - moved[0][1]
        same = all(abs(x + dx - u) < near and abs(y + dy - v) < near for (x, y), (u, v) in zip(moved, outline))
        low_x, low_y, high_x, high_y = box(outline)
        inside = low_x > -near and low_y > -near and high_x < length + near and high_y < height + near
        turned = any(abs((degrees - a + 180.0) % 360.0 - 180.0) < 1e-6 for a in allowed)
        bad += not (same and inside and turned)
    for number, item in enumerate(instance["items"]):
        bad += abs(sum(1 for p in placed if p[0] == number) - item["demand"])
    return bad


def area(polygon):
    return abs(sum(a[0] * b[1] - a[1] * b[0] for a, b in sides(polygon))) / 2


def density(instance, length):
    covered = sum(item["demand"] * area(item["shape"]["data"][:-1]) for item in instance["items"])
    return 100.0 * covered / (instance["strip_height"] * length)


# ---- solvers ----

def cpu():
    own = os.times()
    return own.user + own.system


def by_muslin(instance, options):
    import muslin
    outlines = [{"xy": item["shape"]["data"][:-1], "count": item["demand"],
                 "turns": [math.radians(a) for a in item["allowed_orientations"]]} for item in instance["items"]]
    start = cpu()
    layout = muslin.Layout.of_outlines(outlines, width=instance["strip_height"], gap=0.0,
                                       steps=int(1e9 * options.effort), runs=options.runs, threads=options.threads,
                                       seed=options.seed)
    seconds = cpu() - start
    placed = []
    for piece, outline in zip(layout.pieces, layout.outlines):
        degrees = math.degrees(math.atan2(piece.turn[2], piece.turn[0])) % 360.0
        points = [tuple(p) for p in outline.tolist()]
        shape = instance["items"][piece.panel]["shape"]["data"]
        if sum(a[0] * b[1] - a[1] * b[0] for a, b in sides(shape[:-1])) < 0:
            points = points[::-1]  # the library gives outlines counter-clockwise
        placed.append((piece.panel, degrees, points))
    return placed, layout.length, seconds, layout.steps


SPYRROW = """
import json, sys, resource, spyrrow
instance, seconds = json.load(open(sys.argv[1])), int(sys.argv[2])
items = [spyrrow.Item(str(n), [tuple(p) for p in i["shape"]["data"]], i["demand"], i["allowed_orientations"])
         for n, i in enumerate(instance["items"])]
config = spyrrow.StripPackingConfig(early_termination=False, total_computation_time=seconds, num_workers=2, seed=1)
solution = spyrrow.StripPackingInstance(instance["name"], instance["strip_height"], items).solve(config)
used = resource.getrusage(resource.RUSAGE_SELF)
print(json.dumps({"width": solution.width, "cpu": used.ru_utime + used.ru_stime,
                  "placed": [[int(p.id), p.rotation, p.translation] for p in solution.placed_items]}))
"""


def by_spyrrow(path, instance, python, seconds):
    """Its layout, quarter turns exact, and CPU seconds. None when it is not installed."""
    with tempfile.NamedTemporaryFile("w", suffix=".py") as program:
        program.write(SPYRROW)
        program.flush()
        try:
            done = subprocess.run([python, program.name, path, str(seconds)], capture_output=True, text=True)
        except OSError:
            return None
    if "No module named 'spyrrow'" in done.stderr:
        return None
    if done.returncode != 0:
        sys.exit(f"spyrrow: {done.stderr.strip()}")
    told = json.loads(done.stdout)
    placed = []
    for item, degrees, (dx, dy) in told["placed"]:
        angle = math.radians(degrees)
        c, s = math.cos(angle), math.sin(angle)
        if abs(degrees / 90.0 - round(degrees / 90.0)) < 1e-6:
            c, s = round(c), round(s)
        shape = instance["items"][item]["shape"]["data"][:-1]
        placed.append((item, degrees, [(c * x - s * y + dx, s * x + c * y + dy) for x, y in shape]))
    return placed, told["width"], told["cpu"]


# ---- the tables ----

def show(name, solver, instance, placed, length, seconds, note):
    """Print a row; returns (density, overlaps and wrong pieces)."""
    covered, bad = density(instance, length), wrong(instance, placed, length)
    pairs = overlaps([outline for _, _, outline in placed])
    print(f"{name:<10} {solver:<8} {covered:7.2f} {length:12.3f} {seconds:8.1f} {pairs:9} {bad:6}  {note}", flush=True)
    return covered, pairs + bad


def markers(options):
    """The instances; returns the number of failures."""
    known = {row.split(",")[0]: row.split(",")[6] for row in
             (options.data / "nesting" / "best_densities.csv").read_text().splitlines()[1:]}
    least = dict(part.split("=") for part in options.least.split(",") if part)
    failures = 0
    print(f"{'instance':<10} {'solver':<8} {'covered':>7} {'length':>12} {'CPU s':>8} {'overlaps':>9} {'wrong':>6}")
    for name in options.instances:
        path = options.data / "nesting" / f"{name}.json"
        instance = json.loads(path.read_text())
        placed, length, seconds, steps = by_muslin(instance, options)
        covered, faults = show(name, "muslin", instance, placed, length, seconds,
                               f"{steps / 1e9:.1f}e9 steps; best known {float(known[name]):.2f}")
        failures += faults + (covered < float(least.get(name, 0)))
        if options.spyrrow:
            got = by_spyrrow(str(path), instance, options.spyrrow, options.seconds)
            if got is None:
                print(f"{name:<10} spyrrow  is not installed in {options.spyrrow}: skipped")
            else:
                show(name, "spyrrow", instance, *got, f"{options.seconds} s of wall time, 2 workers")
    return failures


def garments(options):
    import muslin
    print("\ngarment on 1.40 m      length   covered   pieces  folded and with nap; then what others publish, and the "
          "same area on 1.40 m")
    failures = 0
    for design, size in (("jeans", "W40"), ("shirt", "M50")):
        pattern = muslin.draft(design, muslin.Tape.size(size))
        for fold, nap in ((1, 1), (0, 0)):
            layout = muslin.Layout(pattern, width=1.4, fold=fold, nap=nap, steps=int(1e9 * min(options.effort, 3.0)))
            pairs = overlaps([[tuple(p) for p in outline.tolist()] for outline in layout.outlines])
            print(f"{design + ' ' + size:<14} {'fold, nap' if fold else 'open':<9} {layout.length:6.2f} m "
                  f"{100 * layout.utilisation:6.1f} % {len(layout.pieces):6}  {pairs} overlaps", flush=True)
            failures += pairs
        for width, length, source in PUBLISHED[design]:
            print(f"  {length:.2f} m of {width:.2f} m = {length * width / 1.4:.2f} m of 1.40 m: {source}")
    return failures


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("instances", nargs="*", default=[], metavar="NAME")
    parser.add_argument("--data", type=pathlib.Path, required=True)
    parser.add_argument("--effort", type=float, default=50.0)
    parser.add_argument("--runs", type=int, default=2)
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--least", default="trousers=86,shirts=82")
    parser.add_argument("--spyrrow", metavar="PYTHON", nargs="?", const=sys.executable, help="a Python that has spyrrow")
    parser.add_argument("--seconds", type=int, default=60, help="wall time of spyrrow")
    parser.add_argument("--garments", action="store_true", help="jeans and shirt alone")
    options = parser.parse_args()
    options.instances = options.instances or NAMES
    if not (options.data / "nesting").is_dir():
        print(f"{options.data}/nesting: no such folder; the data is not here")
        return 0
    failures = 0 if options.garments else markers(options)
    failures += garments(options)
    print(f"{failures} failures")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
