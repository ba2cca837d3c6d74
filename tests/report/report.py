#!/usr/bin/env python3
"""report.py: the error-against-run-time report: measures, checks, draws, and writes one readable page.

Each job is one function of a scene, run in a process of its own. Its rows are kept in OUT/rows, so that --only measures
some jobs anew and takes the others from there. Written to OUT: report.csv (all numbers), *.png, REPORT.md. --quick takes
small scenes, under a minute, and is a test: exit 1 when a claim of `claims` does not hold or a row lacks a number.
"""
import argparse
import json
import pathlib
import sys
import time

import measure
import page
import runs

# name: (module, function, arguments of the full report, of the quick one or None where it is left out)
JOBS = {
    "strip": ("scene_strip", "time_error", {}, {"halvings": 5}),
    "strip_mesh": ("scene_strip", "mesh_error", {}, {"cells": [50, 100]}),
    "sheet": ("scene_sheet", "time_error", {}, {"n": 20, "halvings": 4, "samples": 25}),
    "sheet_integrate": ("scene_sheet", "integrator_error", {}, {"n": 10, "halvings": 2, "samples": 10}),
    "sheet_mesh": ("scene_sheet", "mesh_error", {}, {"cells": [20, 40]}),
}


def measured(name, quick, out, anew):
    """Rows of a job, from the process that measures it or from an earlier one."""
    module, function, full, small = JOBS[name]
    kept = out / "rows" / f"{name}.json"
    if not anew and kept.exists():
        return json.loads(kept.read_text())
    start = time.perf_counter()
    rows = measure.apart(module, function, **(small if quick else full))
    print(f"{name}: {len(rows)} rows, {time.perf_counter() - start:.0f} s", flush=True)
    kept.parent.mkdir(parents=True, exist_ok=True)
    kept.write_text(json.dumps(rows))
    return rows


# ---- what must hold ----

def claims(jobs):
    """[(sentence, whether it holds)]."""
    found = []
    for scene in ("strip", "sheet"):
        rows = jobs[scene]
        floor = max(r["floor_mm"] for r in rows)
        found.append((f"{scene}: two references agree to {floor:.1e} mm, 10 times below 1e-6 mm", floor < 1e-7))
        for integrator, order in (("rk4", 4), ("verlet", 2)):
            slope, points = runs.order_of(rows, floor, integrator)
            found.append((f"{scene}: {integrator} has order {slope:.2f} over {points} points, {order} +- 0.2",
                          points >= 2 and abs(slope - order) <= 0.2))
        refused = [r for r in rows if r["variant"] == "mus_drape_step" and r["step_of_bound"] > 1]
        found.append((f"{scene}: all {len(refused)} steps above the bound are refused",
                      bool(refused) and all(r["status"] == "refused" for r in refused)))
    for name in ("strip", "sheet_integrate"):
        forced = [r for r in jobs[name] if r["variant"] == "mus_integrate" and r["step_of_bound"] >= 1.5]
        found.append((f"{name}: all {len(forced)} forced steps at 1.5 and 2 of the bound are caught by the energy guard",
                      bool(forced) and all(r["status"] == "diverged" for r in forced)))
    rest = [r for r in jobs["strip_mesh"] if r["quantity"] == "lengthening at rest"]
    worst = max(r["error_mm"] / r["exact"] for r in rest)
    found.append((f"strip: lengthening at rest is exact to {worst:.1e} on every mesh, 1e-4 allowed", worst < 1e-4))
    for name in ("strip_mesh", "sheet_mesh"):
        rows = [r for r in jobs[name] if r["quantity"] != "lengthening at rest"]
        fall = rows[0]["error_mm"] / rows[1]["error_mm"]
        found.append((f"{name}: halving the spacing divides the error by {fall:.2f}, 3.6 to 4.4", 3.6 < fall < 4.4))
    return found


def incomplete(rows):
    """Rows without what every row must have."""
    def lacks(r):
        number = r.get("error_mm") is not None or r.get("value") is not None or r.get("cpu_s") is not None
        return not r.get("scene") or not r.get("error") or not (number or r["status"] != "ok")

    return [r for r in rows if lacks(r)]


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--out", type=pathlib.Path, required=True)
    parser.add_argument("--quick", action="store_true", help="small scenes")
    parser.add_argument("--only", nargs="*", metavar="JOB", help="measure these anew, take the others as they were")
    parser.add_argument("--page", type=pathlib.Path, help="folder of the page, pictures and table (default: OUT)")
    options = parser.parse_args()
    into = options.page or options.out
    into.mkdir(parents=True, exist_ok=True)

    names = [name for name, job in JOBS.items() if not options.quick or job[3] is not None]
    before = measure.calibration()
    jobs = {name: measured(name, options.quick, options.out, options.only is None or name in options.only)
            for name in names}
    swing = abs(measure.calibration() / before - 1)

    rows = [r for name in names for r in jobs[name]]
    measure.write_csv(into / "report.csv", rows)
    found = claims(jobs)
    page.write(into, jobs, found, measure.machine(), swing, options.quick)

    for sentence, holds in found:
        print(("holds: " if holds else "FAILS: ") + sentence)
    lacking = incomplete(rows)
    for r in lacking[:5]:
        print(f"FAILS: a row lacks its number: {r}")
    print(f"{len(rows)} rows in {into / 'report.csv'}, read {into / 'REPORT.md'}")
    return 1 if lacking or not all(holds for _, holds in found) else 0


if __name__ == "__main__":
    sys.exit(main())
