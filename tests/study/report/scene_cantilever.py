"""scene_cantilever.py: cantilever (B1): a strip held level in its middle, so that each half is clamped by the other.

Its tip at rest is known from the elastica (w L^3 / B = 10, L = 100 mm, shot here by Runge-Kutta), which gives mesh
errors for the plate and for the paper's springs over one node. Let go level, it swings down: the time error.
"""
import numpy as np

import implicit
import measure
import model
import muslin
import runs
from muslin.cloth import PAPER, PLATE

LENGTH, WIDTH, GAMMA, WEIGHT, G, INTERVAL, SAMPLES = 0.1, 0.01, 10.0, 0.15, 9.81, 2e-3, 50
BEND = WEIGHT * G * LENGTH ** 3 / GAMMA


def fabric(stretch):
    return {"weight": WEIGHT, "stretch": (stretch, stretch), "shear": 0.0, "bend": (BEND, BEND, BEND)}


def trial(cells):
    """Both halves, level and at rest, which swing down when let go."""
    n = 2 * cells + 1
    held = np.arange(n) == cells
    cell = (LENGTH / cells, WIDTH)
    lattice = model.Lattice(1, n, cell, fabric(1000.0), held, (0.0, -G, 0.0))
    places = np.array(lattice.rest).reshape(-1, 3)
    return runs.Trial("cantilever", lattice, cell, fabric(1000.0), (places, np.zeros_like(places)), INTERVAL, SAMPLES,
                      (0.0, -G, 0.0))


def time_error(cells=10, halvings=8, implicit_steps=(1, 2, 4, 8, 16)):
    """Time error of both halves, which swing down for 0.1 s."""
    scene = trial(cells)
    reference, floor = runs.references(scene)
    rows = runs.steppers(scene, reference, floor, halvings=halvings, stop_mm=20 * floor)
    rows += implicit.steps(scene, reference, floor, per_sample=implicit_steps)
    return [{**r, "spacing_mm": 1e3 * scene.cell[0]} for r in rows]


def rest(cells, bending, precision, exact):
    """Tip at rest by mus_drape_settle."""
    n = 2 * cells + 1
    cloth = muslin.Cloth.grid(1, n, (LENGTH / cells, WIDTH), muslin.Fabric(damping=0.0, **fabric(10000.0)), coarser=0,
                              bending=bending)
    drape = muslin.Drape(cloth, precision=precision, settle_residual=1e-6 if precision == 64 else 1e-3,
                         settle_seconds=20.0)
    drape.pin(cells)
    status, note = "ok", ""

    def settle():
        nonlocal status, note
        try:
            drape.settle()
        except muslin.MuslinError as error:
            status, note = error.name, error.text

    before = drape.report
    taken = measure.seconds_of(settle, most=1)
    tip = drape.positions[-1] - [LENGTH, 0.0, 0.0]
    wrong = 1e3 * float(np.hypot(tip[0] - LENGTH * exact[0], tip[1] + LENGTH * exact[1]))
    return measure.row(scene="cantilever", error="mesh", quantity="tip at rest", variant="mus_drape_settle",
                       precision=precision, bending="plate" if bending == PLATE else "paper", contact="off", threads=1,
                       spacing_mm=1e3 * LENGTH / cells, nodes=n, value=float(tip[0] / LENGTH), exact=exact[0],
                       error_mm=wrong, status=status, note=note, simulated_s=drape.report["settle_time"],
                       **taken, **measure.counts(drape, before, "euler"))


def mesh_error(cells=(5, 10, 20, 40)):
    exact = model.elastica(GAMMA, 1000)
    return ([rest(n, PLATE, 64, exact) for n in cells] + [rest(n, PLATE, 32, exact) for n in cells]
            + [rest(n, PAPER, 64, exact) for n in cells])
