"""rest.py: how long until cloth hangs within 10 mm and within 1 mm of its shape at rest.

A settle that is given a short time is the beginning of a longer one, so fresh drapes with growing budgets tell the
path, its CPU time and its distance from rest. The shape at rest is what the longest of them comes to when it goes on in
double to a residual of 1e-6 of a node's weight, and Runge-Kutta with drag from there is the check by another method. A
draped body has several shapes at rest; the distance of other starts, run to their own end, is the spread.
"""
import time

import numpy as np

import garment
import measure
import muslin

BUDGETS = (0.1, 0.2, 0.3, 0.5, 0.7, 1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 8.0, 12.0)
TIGHT = 1e-6


def far(places, reference):
    """{error_mm, error_rms_mm} of one shape."""
    return measure.distance(np.asarray(places)[None], np.asarray(reference)[None])


def tight(make_double, warm, seconds=60.0):
    """(places, {what it took}) of the shape at rest: settled in double from `warm`, and stepped by RK4 from there."""
    drape = make_double(settle_residual=TIGHT, settle_seconds=seconds, drag=5.0)
    drape.warm(warm)
    before = np.array(drape.positions)
    found = garment.settle(drape)
    settled = np.array(drape.positions)
    residual, distance = drape.report["residual"], drape.report["rest_distance"]
    drape.step(max(1, int(0.2 / (0.9 * drape.step_bound))), 0.9 * drape.step_bound)
    moved = far(drape.positions, settled)
    return settled, {"status": found["status"], "cpu_s": found["cpu_s"], "note":
                     f"residual {residual:.2g} of a weight, {1e3 * distance:.2g} mm expected still to go; "
                     f"0.2 s of RK4 with drag moved it by {moved['error_mm']:.2g} mm; "
                     f"it lies {far(before, settled)['error_mm']:.2g} mm from where the float settle ended"}


def budgets(make, reference, line, spans=BUDGETS, sewn=True):
    """A fresh drape for each budget: cloth time, CPU seconds, distance from the shape at rest."""
    rows = []
    for span in spans:
        drape = make(settle_seconds=span)
        seam = garment.settle(drape, "sew") if sewn else {"cpu_s": 0.0}
        before = drape.report
        found = garment.settle(drape)
        if found["status"] == "unsettled":
            found["status"] = "ok"
        note = f"budget {span:g} s; sewing before it {seam['cpu_s']:.3g} s CPU; residual {drape.report['residual']:.2g}"
        rows.append(measure.row(**line, **{**found, "note": note}, **far(drape.positions, reference),
                                **measure.counts(drape, before, "euler"), value=seam["cpu_s"] + found["cpu_s"]))
        if drape.report["settled"] and found["simulated_s"] < span:
            break
    return rows


# ---- the T-shirt ----

def tshirt(spacing=0.0087, spans=BUDGETS, seconds=15.0, tight_seconds=40.0, more=0.01):
    """Rows of: budgets on fine and coarser cuts, plain RK4 with drag, other starts, a refit after 10 mm more girth."""
    tape = muslin.Tape.read(garment.TAPE)
    body, pattern = muslin.Body(tape), muslin.draft("tshirt", tape)
    cloth = muslin.Cloth(pattern, spacing=spacing)

    def placed(of=cloth, on=body, **options):
        drape = muslin.Drape(of, on, **options)
        drape.place()
        return drape

    def ended(drape, sew=True):
        if sew:
            drape.sew()
        found = garment.settle(drape)
        return drape, found

    long, found = ended(placed(settle_seconds=seconds, settle_residual=1e-3))
    reference, how = tight(lambda **o: placed(precision=64, **o), long, tight_seconds)
    line = dict(scene="tshirt", error="rest", precision=32, contact="on", threads=1, spacing_mm=1e3 * spacing,
                nodes=len(cloth))
    rows = [measure.row(**{**line, "precision": 64}, quantity="shape at rest", variant="double, from the float settle",
                        **how)]
    rows += budgets(placed, reference, dict(line, quantity="distance from rest", variant="settle"), spans)
    rows += others(cloth, pattern, body, spacing, reference, line, placed, ended, seconds)
    rows += refit(tape, cloth, long, line, placed, seconds, tight_seconds, more, spans)
    return rows


def others(cloth, pattern, body, spacing, reference, line, placed, ended, seconds):
    """Other starts, each run to its own end: their distance from the first shape is the spread."""
    rows = []

    def keep(name, drape, found):
        rows.append(measure.row(**line, quantity="spread", variant=name, **found, **far(drape.positions, reference)))

    flat = muslin.Cloth(pattern, spacing=spacing, coarser=0)
    keep("no coarser cuts", *ended(placed(of=flat, settle_seconds=seconds, settle_residual=1e-3)))
    wide, _ = ended(placed(of=muslin.Cloth(pattern, spacing=1.5 * spacing), settle_seconds=seconds))
    drape = placed(settle_seconds=seconds, settle_residual=1e-3)
    drape.warm(wide)
    keep("from the shape of a cloth of 1.5 times the spacing", *ended(drape, sew=False))
    drape = placed(settle_seconds=seconds, settle_residual=1e-3)
    drape.set_state(np.array(drape.positions) + [0.002, 0.003, -0.002])
    keep("placed 4 mm elsewhere", *ended(drape))
    return rows


def refit(tape, cloth, long, line, placed, seconds, tight_seconds, more, spans):
    """10 mm more round the bust: body and pattern anew, the cloth starts where the old one lies."""
    wider = muslin.Tape.read(garment.TAPE)
    wider["bust"] = wider["bust"] + more
    start = time.process_time()
    body, pattern = muslin.Body(wider), muslin.draft("tshirt", wider)
    anew = muslin.Cloth(pattern, spacing=line["spacing_mm"] / 1e3)
    made = time.process_time() - start

    def warm(**options):
        drape = placed(of=anew, on=body, **options)
        drape.warm(long)
        return drape

    last = warm(settle_seconds=seconds, settle_residual=1e-3)
    garment.settle(last)
    reference, how = tight(lambda **o: placed(of=anew, on=body, precision=64, **o), last, tight_seconds)
    line = dict(line, nodes=len(anew))
    rows = [measure.row(**{**line, "precision": 64}, quantity="shape at rest", variant="refit, double", **how),
            measure.row(**line, quantity="refit: body, pattern and cloth anew", variant="refit", cpu_s=made),
            measure.row(**line, quantity="distance from rest", variant="refit", cpu_s=0.0, simulated_s=0.0, value=0.0,
                        note="where the old garment lies", **far(warm().positions, reference))]
    line = dict(line, quantity="distance from rest", variant="refit")
    return rows + budgets(warm, reference, line, spans, sewn=False)


# ---- the hanging cloth ----

def hanging(side, seconds=20.0, tight_seconds=120.0, spans=BUDGETS, plain=20.0):
    """1 m square held at two corners, let go level (kernel.md D): settle beside RK4 and Verlet with drag 7."""
    cell = 1.0 / (side - 1)
    stencil = 20.0 * cell * cell
    fabric = muslin.Fabric(weight=0.2, stretch=(1300.0, 1300.0), shear=300.0, bend=(stencil, stencil, stencil / 2),
                           damping=0.0)
    cloth = muslin.Cloth.grid(side, side, (cell, cell), fabric)
    start = np.zeros((side * side, 3))
    start[:, [0, 2]] = cloth.rest

    def level(**options):
        drape = muslin.Drape(cloth, **options)
        drape.set_state(start)
        for node in (0, side - 1):
            drape.pin(node)
        return drape

    def fresh(**options):
        return level(settle_residual=1e-3, **options)

    long = fresh(settle_seconds=seconds)
    garment.settle(long)
    reference, how = tight(lambda **o: level(precision=64, **o), long, tight_seconds)
    line = dict(scene="hang", error="rest", precision=32, contact="off", threads=1, spacing_mm=1e3 * cell,
                nodes=side * side)
    rows = [measure.row(**{**line, "precision": 64}, quantity="shape at rest", variant="double, from the float settle",
                        **how)]
    rows += budgets(fresh, reference, dict(line, quantity="distance from rest", variant="settle"), spans, sewn=False)
    for integrator in ("rk4", "verlet"):
        rows += damped(level(integrator=integrator, drag=7.0), integrator, lambda **o: level(precision=64, **o),
                       reference, line, plain, tight_seconds)
    return rows


def damped(drape, integrator, double, reference, line, most_cpu, tight_seconds, every=0.2):
    """mus_drape_step with drag until nothing moves, or `most_cpu` CPU seconds are gone; its distance is from the shape
    at rest that it comes to itself, which may be another one."""
    shapes, spent, moving = [], 0.0, 3
    before = drape.report
    while spent < most_cpu and moving > 0:
        h = 0.9 * drape.step_bound
        last = np.array(drape.positions)
        start = time.process_time()
        drape.step(max(1, int(every / h)), h)
        spent += time.process_time() - start
        shapes.append((spent, drape.time, h, np.array(drape.positions), measure.counts(drape, before, integrator)))
        moving = moving - 1 if far(shapes[-1][3], last)["error_mm"] < 0.02 else 3
    own, how = tight(double, drape, tight_seconds)
    variant = f"{integrator}, drag 7"
    how["note"] += f"; {far(own, reference)['error_mm']:.2g} mm from the shape that settle comes to"
    rows = [measure.row(**{**line, "precision": 64}, quantity="shape at rest", variant=f"double, from {variant}",
                        **how)]
    return rows + [measure.row(**line, quantity="distance from rest", variant=variant, integrator=integrator, cpu_s=cpu,
                               value=cpu, simulated_s=t, step_s=h, **far(shape, own), **counted)
                   for cpu, t, h, shape, counted in shapes]


def reached(rows, variant, scene, nodes, limit_mm):
    """(CPU seconds of the settle, with sewing) of the first point from which on all are within limit_mm, or None."""
    path = [r for r in rows if r["quantity"] == "distance from rest" and r["variant"] == variant
            and r["scene"] == scene and r["nodes"] == nodes]
    for i, r in enumerate(path):
        if all(later["error_mm"] <= limit_mm for later in path[i:]):
            return r["cpu_s"], r["value"]
    return None
