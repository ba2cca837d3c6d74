"""rest.py: how long until cloth hangs within 10 mm and within 1 mm of its shape at rest.

A settle that is given a short time is the beginning of a longer one, so fresh drapes with growing budgets tell the
path, its CPU time and its distance from rest. The shape at rest is what the longest of them comes to by another method,
Newton's (newton.py), to a residual of 1e-6 of a node's weight. A draped body has several shapes at rest; the distance
of other starts, run to their own end, is the spread.
"""
import time

import numpy as np

import garment
import measure
import muslin
import newton

BUDGETS = (0.1, 0.2, 0.3, 0.5, 0.7, 1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 8.0, 12.0)


def far(places, reference):
    """{error_mm, error_rms_mm} of one shape."""
    return measure.distance(np.asarray(places)[None], np.asarray(reference)[None])


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


def reached(rows, variant, scene, nodes, limit_mm):
    """(CPU seconds of the settle, with sewing) of the first point from which on all are within limit_mm, or None."""
    path = [r for r in rows if r["quantity"] == "distance from rest" and r["variant"] == variant
            and r["scene"] == scene and r["nodes"] == nodes]
    for i, r in enumerate(path):
        if all(later["error_mm"] <= limit_mm for later in path[i:]):
            return r["cpu_s"], r["value"]
    return None


# ---- the T-shirt ----

def tshirt(spacing=0.0087, spans=BUDGETS, seconds=15.0, more=0.01):
    """Rows of: budgets on fine and coarser cuts, plain RK4 with drag, other starts, a refit after 10 mm more girth."""
    tape = muslin.Tape.read(garment.TAPE)
    body, pattern = muslin.Body(tape), muslin.draft("tshirt", tape)
    cloth = muslin.Cloth(pattern, muslin.Fabric(), spacing=spacing)

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
    reference, how = still(placed, cloth, body, long)
    line = dict(scene="tshirt", error="rest", precision=32, contact="on", threads=1, spacing_mm=1e3 * spacing,
                nodes=len(cloth))
    rows = [measure.row(**{**line, "precision": 64}, quantity="shape at rest", variant="where settle ended", **how)]
    rows += budgets(placed, reference, dict(line, quantity="distance from rest", variant="settle"), spans)
    rows += others(cloth, pattern, body, spacing, reference, line, placed, ended, seconds)
    rows += refit(tape, long, line, placed, seconds, more, spans)
    return rows


def still(placed, cloth, body, ended):
    """(places, columns) of the shape that the garment of the drape `ended` comes to by Newton's method."""
    drape = placed(of=cloth, on=body, precision=64)
    drape.warm(ended)
    return newton.rest(drape, cloth, np.array(drape.positions), body=body, friction=muslin.Fabric().values()["friction"])


def others(cloth, pattern, body, spacing, reference, line, placed, ended, seconds):
    """Other starts, each run to its own end: their distance from the first shape is the spread."""
    rows = []

    def keep(name, drape, found):
        rows.append(measure.row(**line, quantity="spread", variant=name, **found, **far(drape.positions, reference)))

    flat = muslin.Cloth(pattern, muslin.Fabric(), spacing=spacing, coarser=0)
    keep("no coarser cuts", *ended(placed(of=flat, settle_seconds=seconds, settle_residual=1e-3)))
    wide, _ = ended(placed(of=muslin.Cloth(pattern, muslin.Fabric(), spacing=1.5 * spacing), settle_seconds=seconds))
    drape = placed(settle_seconds=seconds, settle_residual=1e-3)
    drape.warm(wide)
    keep("from the shape of a cloth of 1.5 times the spacing", *ended(drape, sew=False))
    drape = placed(settle_seconds=seconds, settle_residual=1e-3)
    drape.set_state(np.array(drape.positions) + [0.002, 0.003, -0.002])
    keep("placed 4 mm elsewhere", *ended(drape))
    return rows


def refit(tape, long, line, placed, seconds, more, spans):
    """10 mm more round the bust: body and pattern anew, the cloth starts where the old one lies."""
    wider = muslin.Tape.read(garment.TAPE)
    wider["bust"] = wider["bust"] + more
    start = time.process_time()
    body, pattern = muslin.Body(wider), muslin.draft("tshirt", wider)
    anew = muslin.Cloth(pattern, muslin.Fabric(), spacing=line["spacing_mm"] / 1e3)
    made = time.process_time() - start

    def warm(**options):
        drape = placed(of=anew, on=body, **options)
        drape.warm(long)
        return drape

    last = warm(settle_seconds=seconds, settle_residual=1e-3)
    garment.settle(last)
    reference, how = still(placed, anew, body, last)
    line = dict(line, nodes=len(anew))
    rows = [measure.row(**{**line, "precision": 64}, quantity="shape at rest", variant="where the refit ended", **how),
            measure.row(**line, quantity="refit: body, pattern and cloth anew", variant="refit", cpu_s=made),
            measure.row(**line, quantity="distance from rest", variant="refit", cpu_s=0.0, simulated_s=0.0, value=0.0,
                        note="where the old garment lies", **far(warm().positions, reference))]
    line = dict(line, quantity="distance from rest", variant="refit")
    return rows + budgets(warm, reference, line, spans, sewn=False)
