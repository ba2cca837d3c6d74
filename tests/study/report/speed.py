"""speed.py: nanoseconds a node and step against the number of nodes, what each part of a scene costs, and threads."""
import numpy as np

import garment
import measure
import muslin

CELL = 0.01
FULL = {"weight": 0.15, "stretch": (500.0, 500.0), "shear": 40.0, "bend": (5e-6, 5e-6, 5e-6), "damping": 0.0}


def sheet(side, fabric, precision, integrator, threads=1, drag=0.0, bending=0, held=False):
    """A lattice, a little stretched and in waves, so that every spring works; held at its edges, where it would crumple
    without shear."""
    cloth = muslin.Cloth.grid(side, side, (CELL, CELL), muslin.Fabric(**fabric), coarser=0, bending=bending)
    drape = muslin.Drape(cloth, precision=precision, integrator=integrator, threads=threads, drag=drag,
                         gravity=(0.0, 0.0, 0.0))
    places = np.zeros((side * side, 3))
    places[:, :2] = 1.01 * cloth.rest
    places[:, 2] = 1e-3 * np.sin(20.0 * places[:, 0]) * np.cos(17.0 * places[:, 1])
    drape.set_state(places)
    index = np.arange(side * side)
    edge = (index % side == 0) | (index % side == side - 1) | (index < side) | (index >= side * (side - 1))
    for node in index[edge] if held else ():
        drape.pin(int(node))
    return drape


def timed(drape, integrator, enough, **line):
    """ns a node and step, from steps at 0.9 of the bound."""
    h = 0.9 * drape.step_bound
    count = max(2, int(2e5 / len(drape)))
    before = drape.report
    drape.step(count, h)
    counted = measure.counts(drape, before, integrator)
    taken = measure.seconds_of(lambda: drape.step(count, h), enough=enough)
    each = 1e9 * taken["cpu_least_s"] / (count * len(drape))
    return measure.row(error="none", quantity="ns a node and step", nodes=len(drape), step_s=h, integrator=integrator,
                       value=each, simulated_s=count * h, cpu_s_per_s=taken["cpu_s"] / (count * h),
                       **{"scene": "lattice", "spacing_mm": 1e3 * CELL, **line}, **taken, **counted)


def size(sides=(10, 32, 100, 316, 1000), enough=0.4):
    rows = []
    for side in sides:
        for precision in (32, 64):
            for integrator in ("rk4", "verlet"):
                before = muslin.Context.of_thread().bytes
                drape = sheet(side, FULL, precision, integrator)
                each = (muslin.Context.of_thread().bytes - before) / len(drape)
                rows.append(timed(drape, integrator, enough, variant="all springs", precision=precision, contact="off",
                                  bending="plate", threads=1, exact=each, note="exact: bytes a node, cloth included"))
                drape.close()
    return rows


def threads(count, side=100, enough=0.4):
    """CPU and wall seconds on `count` threads; the state must not depend on them."""
    rows = []
    for precision in (32, 64):
        drape = sheet(side, FULL, precision, "rk4", threads=count)
        drape.step(50, 0.5 * drape.step_bound)
        state = drape.state_hash
        rows.append(timed(drape, "rk4", enough, variant="threads", precision=precision, contact="off", bending="plate",
                          threads=count, note=f"state {state}"))
    return rows


def parts(side=100, enough=0.4, spacing=0.01):
    """The same lattice with parts left out, and a T-shirt with and without its body."""
    rows = []
    cases = {"all springs": (FULL, 0.0, 0), "no bending": (dict(FULL, bend=(0.0, 0.0, 0.0)), 0.0, 0),
             "no bending, no shear": (dict(FULL, bend=(0.0, 0.0, 0.0), shear=0.0), 0.0, 0),
             "bending along lines alone": (dict(FULL, bend=(5e-6, 5e-6, 2.5e-6)), 0.0, 0),
             "bending by the paper's springs": (FULL, 0.0, 1),
             "air drag": (FULL, 0.5, 0), "dashpots": (dict(FULL, damping=0.1), 0.0, 0)}
    for name, (fabric, drag, bending) in cases.items():
        for precision in (32, 64):
            drape = sheet(side, fabric, precision, "rk4", drag=drag, bending=bending, held=True)
            rows.append(timed(drape, "rk4", enough, variant=name, precision=precision, contact="off", threads=1,
                              bending="paper" if bending else "plate" if fabric["bend"][0] else "none",
                              note="left out: " + ", ".join(drape.skipped)))
    tape = muslin.Tape.read(garment.TAPE)
    cloth = muslin.Cloth(muslin.draft("tshirt", tape), muslin.Fabric(damping=0.0), spacing=spacing)
    worn = muslin.Drape(cloth, muslin.Body(tape))
    worn.place()
    worn.sew()
    garment.settle(worn)
    for contact, body in (("on", muslin.Body(tape)), ("off", None)):
        for precision in (32, 64):
            drape = muslin.Drape(cloth, body, precision=precision, drag=0.0)
            drape.place()
            drape.warm(worn)
            rows.append(timed(drape, "rk4", enough, scene="tshirt", spacing_mm=1e3 * spacing, variant="worn",
                              precision=precision, contact=contact, bending="plate", threads=1,
                              note="left out: " + ", ".join(drape.skipped)))
    return rows
