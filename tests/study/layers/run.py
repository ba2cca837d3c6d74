#!/usr/bin/env python3
"""run.py: garments worn over one another, dressed by `muslin dress --over`, a row each.

A row is good when all seams are closed to 1 mm, no triangle of cloth crosses another (an exact count), nothing is
deeper than 1 mm in the body, and the whole is at rest. CPU seconds are those of the whole process: reading, bodies,
cutting, sewing, settling. Written into OUT: a picture and a report of each row. Exit 1 when a row is not good.
"""
import argparse
import json
import pathlib
import resource
import subprocess
import sys

SLEEVELESS_COAT = "top neck=v shape=boxy closure=front top_length=tunic ease=coat"
LONG_COAT = SLEEVELESS_COAT.replace("neck=v", "neck=v sleeve=long")
# (body, spacing [mm], from inside to outside)
STACKS = [
    ("W40", 20, ["tshirt", "waistcoat"]),
    ("W40", 25, ["shirt_mandarin_long", "waistcoat"]),
    ("W40", 30, ["tshirt", "waistcoat", SLEEVELESS_COAT]),
    ("W40", 30, ["shirt_mandarin_long", LONG_COAT]),
    ("W40", 30, ["shirt_mandarin_long", "waistcoat", LONG_COAT]),
    ("W40", 25, ["shirt_mandarin_long", "waistcoat", "coat"]),
    ("M50", 25, ["shirt_mandarin_long", "waistcoat", "coat"]),
]
GAP_MM, DEPTH_MM = 1.0, 1.0


def short(garment):
    """A design's name; of words the first and the last."""
    words = garment.split()
    return garment if len(words) == 1 else f"{words[0]}_{words[-1].replace('=', '_')}"


def cpu():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def dress(command, body, spacing, garments, out):
    """(report, CPU seconds) of a stack; pictures beside it."""
    name = "-".join([body, *map(short, garments)])
    asked = [command, "dress", "--size", body, "--design", garments[0], "--spacing", str(spacing), "--quiet",
             "--report", out / f"{name}.json", "--png", out / f"{name}.png", "--view", "20,5,1", "--view", "200,5,1"]
    for garment in garments[1:]:
        asked += ["--over", garment]
    before = cpu()
    done = subprocess.run(asked, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    if done.returncode not in (0, 1):
        sys.exit(f"{name}: {done.stderr.decode().strip()}")
    return json.loads((out / f"{name}.json").read_text()), cpu() - before


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--command", required=True)
    parser.add_argument("--out", required=True, type=pathlib.Path)
    parser.add_argument("--spacing", type=float, help="[mm] of all rows")
    parser.add_argument("--only", type=int, nargs="*", help="numbers of rows, from 1 on")
    options = parser.parse_args()
    options.out.mkdir(parents=True, exist_ok=True)
    print(f"{'stack':44} {'mm':>4} {'nodes':>6} {'status':12} {'seams':>7} {'gap mm':>7} {'depth':>6} "
          f"{'crossings':>9} {'residual':>9} {'CPU s':>7}")
    bad = 0
    for k, (body, spacing, garments) in enumerate(STACKS):
        if options.only and k + 1 not in options.only:
            continue
        spacing = options.spacing or spacing
        report, used = dress(options.command, body, spacing, garments, options.out)
        good = (report["status"] == "settled" and report["seams_closed"] == report["seams"] and
                report["max_seam_gap_mm"] <= GAP_MM and report["max_penetration_mm"] <= DEPTH_MM and
                report["crossings"] == 0)
        bad += not good
        stack = body + " " + " < ".join(map(short, garments))
        print(f"{stack:44} {spacing:4g} {report['nodes']:6} {report['status']:12} "
              f"{report['seams_closed']:3}/{report['seams']:3} {report['max_seam_gap_mm']:7.2f} "
              f"{report['max_penetration_mm']:6.2f} {report['crossings']:9} {report['residual']:9.4f} {used:7.1f}"
              f"{'' if good else '  SHORT: ' + report.get('reason', '')}", flush=True)
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
