#!/usr/bin/env python3
"""report.py: the error-against-run-time report: measures, checks, draws, and writes one readable page.

Each job is one function of a scene, run in a process of its own. Its rows are kept in OUT/rows, so that --only
measures some jobs anew and takes the others from there. Written to OUT: report.csv (all numbers), *.png, REPORT.md.
--quick takes small scenes, under a minute, and is a test: exit 1 when a claim of `claims` does not hold or a row lacks
a number.
"""
import argparse
import json
import pathlib
import sys
import time

import measure
import page
import runs

# name: (module, function, arguments of the full report, of the quick one); "threads" is how many cores it may use
JOBS = {
    "strip": ("scene_strip", "time_error", {}, {"halvings": 5}),
    "strip_mesh": ("scene_strip", "mesh_error", {}, {"cells": [50, 100]}),
    "sheet": ("scene_sheet", "time_error", {"halvings": 6}, {"n": 20, "halvings": 4, "samples": 25,
                                                           "implicit_steps": [1]}),
    "sheet_integrate": ("scene_sheet", "integrator_error", {}, {"n": 10, "halvings": 2, "samples": 10}),
    "sheet_mesh": ("scene_sheet", "mesh_error", {}, {"cells": [20, 40]}),
    "cantilever": ("scene_cantilever", "time_error", {},
                   {"cells": 5, "halvings": 4, "implicit_steps": [2, 4]}),
    "cantilever_mesh": ("scene_cantilever", "mesh_error", {}, {"cells": [5, 10]}),
    "disc": ("scene_disc", "time_error", {"halvings": 5},
             {"spacing": 0.02, "halvings": 5, "span": 0.05}),
    "disc_parting": ("scene_disc", "parting", {}, {"spacing": 0.02}),
    "disc_mesh": ("scene_disc", "mesh_error", {}, {"lengths": [0.03], "spacings": [0.02, 0.01], "starts": 2}),
    "disc_model": ("scene_disc", "model_error", {}, {"spacings": [0.02], "seconds": 1.0}),
    "limits": ("model_limits", "gaps", {}, {}),
    "skirt": ("scene_garments", "time_error", {"design": "skirt", "halvings": 5},
              {"design": "skirt", "spacing": 0.04, "halvings": 3, "span": 0.05, "samples": 25, "finer": 16}),
    "skirt_off": ("scene_garments", "time_error", {"design": "skirt", "contact": "off", "halvings": 5},
                  {"design": "skirt", "contact": "off", "spacing": 0.04, "halvings": 3, "span": 0.05, "samples": 25,
                   "finer": 16}),
    "skirt_damped": ("scene_garments", "time_error",
                     {"design": "skirt", "contact": "off", "damping": 0.1, "halvings": 5},
                     {"design": "skirt", "contact": "off", "damping": 0.1, "spacing": 0.04, "halvings": 2, "span": 0.05,
                      "samples": 25, "finer": 16}),
    "skirt_cotton": ("scene_garments", "time_error", {"design": "skirt", "fabric": "cotton", "halvings": 3},
                     {"design": "skirt", "fabric": "cotton", "spacing": 0.04, "halvings": 1, "span": 0.02,
                      "samples": 10, "finer": 8}),
    "parting_fall": ("parting", "apart", {"scene": "fall"}, {"scene": "fall", "seconds": 1.0, "looks": 50, "seeds": 2}),
    **{f"parting_{name}": ("parting", "apart", dict(how, scene=title), dict(how, scene=title, spacing=0.05, seconds=0.5,
                                                                            looks=50, seeds=1))
       for name, title, how in (
           ("skirt_off", "skirt, held, no body", {"design": "skirt", "contact": "off"}),
           ("skirt", "skirt on its body", {"design": "skirt", "contact": "on"}),
           ("skirt_cotton", "skirt of cotton on its body", {"design": "skirt", "contact": "on", "fabric": "cotton"}),
           ("tshirt", "T-shirt on its body", {"design": "tshirt", "contact": "on"}))},
    "energy": ("energy", "drift", {}, {"seconds": 0.5, "looks": 20, "sheet_cells": 8}),
    "contact": ("contact", "on_a_limb", {}, {"cells": [15, 30], "frictions": [0.3], "meshes": [61, 121], "rounds": 4}),
    "command": ("command", "dressed", {}, {"plan": [["skirt", "jersey"]], "spacing": 0.04}),
    "skirt_mesh": ("scene_garments", "mesh_error", {"design": "skirt"}, {"design": "skirt", "plan": [[0.03, 2]]}),
    "tshirt": ("scene_garments", "time_error", {"design": "tshirt", "halvings": 4},
               {"design": "tshirt", "spacing": 0.03, "halvings": 1, "span": 0.02, "samples": 10, "finer": 8}),
    "tshirt_mesh": ("scene_garments", "mesh_error", {"design": "tshirt"}, {"design": "tshirt", "plan": [[0.03, 2]]}),
    "speed": ("speed", "size", {}, {"sides": [10, 32, 100], "enough": 0.05}),
    "parts": ("speed", "parts", {}, {"side": 50, "enough": 0.05, "spacing": 0.02}),
    "threads_1": ("speed", "threads", {"count": 1}, {"count": 1, "side": 50, "enough": 0.05}),
    "threads_2": ("speed", "threads", {"count": 2, "threads": 2},
                  {"count": 2, "threads": 2, "side": 50, "enough": 0.05}),
    "sewing": ("sewing", "trade", {}, {"distances": [0.001, 0.01], "spacing": 0.02}),
    "rest_tshirt": ("rest", "tshirt", {}, {"spacing": 0.025, "spans": [0.1, 0.3, 1.0], "seconds": 5.0}),
    "rest_hang_1k": ("scene_hang", "hanging", {"side": 32}, {"side": 16, "spans": [0.1, 1.0, 3.0], "plain": 0.2}),
    "rest_hang_4k": ("scene_hang", "hanging", {"side": 64, "plain": 25.0},
                     {"side": 24, "spans": [0.1, 1.0, 3.0], "plain": 0.2}),
    "rest_hang_16k": ("scene_hang", "hanging", {"side": 128, "plain": 40.0},
                      {"side": 32, "spans": [0.1, 1.0, 3.0], "plain": 0.2}),
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
    for scene in ("strip", "sheet", "cantilever"):
        rows = jobs[scene]
        floor = max(r["floor_mm"] for r in rows)
        found.append((f"{scene}: two references agree to {floor:.1e} mm, 10 times below 1e-6 mm", floor < 1e-7))
        for integrator, order in (("rk4", 4), ("verlet", 2)):
            slope, points = runs.order_of(rows, integrator)
            found.append((f"{scene}: {integrator} has order {slope:.2f} over {points} points, {order} +- 0.2",
                          points >= 2 and abs(slope - order) <= 0.2))
        refused = [r for r in rows if r["variant"] == "mus_drape_step" and r["step_of_bound"] > 1]
        found.append((f"{scene}: all {len(refused)} steps above the bound are refused",
                      bool(refused) and all(r["status"] == "refused" for r in refused)))
    for name in ("strip", "sheet_integrate"):
        forced = [r for r in jobs[name] if r["variant"] == "mus_integrate" and r["step_of_bound"] >= 1.5]
        found.append((f"{name}: all {len(forced)} steps forced at 1.5 and 2 of the bound are caught by the guard",
                      bool(forced) and all(r["status"] == "diverged" for r in forced)))
    rest = [r for r in jobs["strip_mesh"] if r["quantity"] == "lengthening at rest"]
    worst = max(r["error_mm"] / r["exact"] for r in rest)
    found.append((f"strip: lengthening at rest is exact to {worst:.1e} on every mesh, 1e-4 allowed", worst < 1e-4))
    for name in ("strip_mesh", "sheet_mesh"):
        rows = [r for r in jobs[name] if r["quantity"] != "lengthening at rest"]
        fall = rows[0]["error_mm"] / rows[1]["error_mm"]
        found.append((f"{name}: halving the spacing divides the error by {fall:.2f}, 3.6 to 4.4", 3.6 < fall < 4.4))
    held, _ = runs.order_of(jobs["disc"], "rk4", above=0.0, most=3)
    found.append((f"disc: RK4 has order {held:.2f} on a cut piece without contact, 4 +- 0.5", abs(held - 4) <= 0.5))
    for method, asked in (("implicit Euler", 1), ("implicit midpoint", 2)):
        slope, points = runs.order_of(jobs["cantilever"], method, variant="implicit, scipy")
        found.append((f"cantilever: {method}, another program's, comes to the same path with order {slope:.2f} over "
                      f"{points} points, {asked} +- 0.2", abs(slope - asked) <= 0.2))
    energy = [r for r in jobs["energy"] if r["quantity"].startswith("energy")]
    gained = max(r["exact"] for r in energy if r["status"] == "ok")
    found.append((f"energy: no run of {len(energy)} that came to its end gained more than {100 * gained:.2g} % of its "
                  "largest kinetic energy on the way, 1 %", gained <= 0.01))
    still = max(max(r["value"], r["exact"]) for r in jobs["energy"] if r["quantity"].startswith("momentum"))
    found.append((f"a sheet that nothing holds keeps its momentum to {still:.1e} of m |v|, 1e-4", still <= 1e-4))
    lying = [r for r in jobs["contact"] if r["quantity"].startswith("places")]
    worst = max(r["error_mm"] for r in lying)
    found.append((f"contact: a row on a limb lies within {worst:.1e} mm of scipy's least energy, 0.01 mm, on "
                  f"{len(lying)} meshes", worst <= 0.01 and all(r["status"] == "ok" for r in lying)))
    falls = [abs(r["value"] / r["exact"] - 1) for r in finest(jobs["contact"])]
    found.append((f"contact: friction holds a row over a limb as the capstan's law says, to {100 * max(falls):.2g} % "
                  "on the finest mesh, 4 %", max(falls) <= 0.04))
    paper = sorted((r for r in jobs["cantilever_mesh"] if r["bending"] == "paper"), key=lambda r: -r["spacing_mm"])
    found.append((f"cantilever: the paper's springs are {paper[0]['error_mm']:.0f} and {paper[-1]['error_mm']:.0f} mm "
                  "wrong, worse on the finer mesh (B6)", paper[-1]["error_mm"] > paper[0]["error_mm"] > 5.0))
    state = {count: {r["precision"]: r["note"] for r in jobs[f"threads_{count}"]} for count in (1, 2)}
    found.append(("the state on two threads is that on one, bit for bit", state[1] == state[2]))
    rest_rows = shapes_at_rest(jobs)
    worst = max(r["value"] for r in rest_rows)
    found.append((f"all {len(rest_rows)} shapes at rest have a residual of at most {worst:.1e} of a weight, 1e-6, and "
                  "are minima of the energy", worst <= 1e-6 and all(r["status"] == "ok" for r in rest_rows)))
    found += [(f"hang, {r['nodes']} nodes: {r['quantity']} {r['value']:.5f}, by the static solver {r['exact']:.5f}; 1 %",
               abs(r["value"] / r["exact"] - 1) <= 0.01)
              for name in jobs for r in jobs[name] if r["quantity"] in ("largest strain at rest",
                                                                        "pins carry of the weight")]
    return found


def finest(rows):
    """Of the capstan's rows those with the most nodes, one a friction."""
    rows = [r for r in rows if r["quantity"].startswith("longest")]
    return [r for r in rows if r["nodes"] == max(other["nodes"] for other in rows)]


def shapes_at_rest(jobs):
    """Rows of the shapes that the static solver found."""
    return [r for name in jobs if name.startswith("rest_") for r in jobs[name] if r["quantity"] == "shape at rest"]


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
