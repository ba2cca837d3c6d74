"""runs.py: error against run time of a grid cloth: the library's steps, its integrators on a numpy rate, and refusals.

A trial is one scene with one mesh: a lattice (model.py), a state, a span with equally spaced sample times. Two
references stand beside each other: the library's own RK4 in double at 1/64 of its largest step, and model.py's, another
program, at the same step. Their distance is the floor below which an error says nothing.
"""
import numpy as np

import measure
import muslin
from muslin.errors import MuslinError


class Trial:
    """A scene of a grid cloth in empty space. fabric: dict of mus_fabric's values; state: (places, speeds) (n x 3)."""

    def __init__(self, scene, lattice, cell, fabric, state, interval, samples, gravity):
        self.scene, self.lattice, self.cell, self.fabric = scene, lattice, cell, fabric
        self.state, self.interval, self.samples, self.gravity = state, interval, samples, gravity
        self.rows, self.columns = lattice.rest.shape[:2]

    def drape(self, precision=64, integrator="rk4", **options):
        """The scene as a drape, its held nodes pinned where the state has them."""
        cloth = muslin.Cloth.grid(self.rows, self.columns, self.cell,
                                  muslin.Fabric(damping=0.0, **self.fabric), coarser=0)
        drape = muslin.Drape(cloth, precision=precision, integrator=integrator, gravity=self.gravity, drag=0.0,
                             **options)
        drape.set_state(*self.state)
        for node in np.flatnonzero(~self.lattice.free.reshape(-1)):
            drape.pin(int(node))
        return drape

    def row(self, **values):
        return measure.row(scene=self.scene, error="time", nodes=self.rows * self.columns, contact="off", threads=1,
                           spacing_mm=1e3 * self.cell[1], simulated_s=self.interval * self.samples,
                           quantity="places at 50 times", **values)


def references(trial, exact=None, finer=64):
    """(reference path, floor [mm]): own RK4 in double and model.py's at 1/64 of the largest step, or the exact path."""
    drape = trial.drape()
    least, _ = measure.steps_in(trial.interval, drape.step_bound, 0.95)
    steps = finer * least
    own = measure.path_of(drape, trial.state, steps, trial.interval / steps, trial.samples)
    other = trial.lattice.path(*trial.state, trial.interval / steps, steps, trial.samples) if exact is None else exact
    return other, measure.distance(own, other)["error_mm"]


def steppers(trial, reference, floor, precisions=(64, 32), halvings=8, stop_mm=0.0):
    """mus_drape_step: RK4 and Verlet, float and double, from 0.95 of the bound down by halves."""
    rows = []
    for integrator in ("rk4", "verlet"):
        for precision in precisions:
            drape = trial.drape(precision, integrator)
            bound = drape.step_bound
            least, _ = measure.steps_in(trial.interval, bound, 0.95)
            common = dict(integrator=integrator, precision=precision, variant="mus_drape_step", floor_mm=floor)
            best, worse = np.inf, 0
            for halving in range(halvings + 1):
                steps = least * 2 ** halving
                h = trial.interval / steps
                found = measure.point(drape, integrator, trial.state, h, steps, trial.samples, reference)
                rows.append(trial.row(**common, step_s=h, step_of_bound=h / bound,
                                      **{k: v for k, v in found.items() if k != "simulated_s"}))
                # the floor of rounding is reached when halving no longer helps
                worse = worse + 1 if found["error_mm"] > 0.7 * best else 0
                best = min(best, found["error_mm"])
                if worse == 2 or found["error_mm"] < stop_mm:
                    break
            rows += refusals(trial, drape, bound, common)
    return rows


def refusals(trial, drape, bound, common):
    """Steps above the bound: mus_drape_step says no, and nothing has moved."""
    rows = []
    for share in (1.01, 2.0):
        try:
            drape.step(1, share * bound)
            status, note = "ok", "a step above the bound was made"
        except MuslinError as error:
            status, note = ("refused", error.text) if error.name == "MUS_ERR_STEP" else (error.name, error.text)
        rows.append(trial.row(**common, step_s=share * bound, step_of_bound=share, status=status, note=note))
    return rows


def integrators(trial, reference, floor, halvings=5):
    """mus_integrate on model.py's rate, with the energy guard, below and above the bound. Its seconds are those of
    numpy and stand in no plot; its evaluations do."""
    lattice, shape = trial.lattice, trial.lattice.rest.shape
    half, rows = lattice.rest.size, []

    def rate(_, y):
        x = np.array(y[:half]).reshape(shape)
        return np.concatenate([y[half:], lattice.acceleration(x).reshape(-1)]).tobytes()

    def energy(_, y):
        return lattice.energy(np.array(y[:half]).reshape(shape), np.array(y[half:]).reshape(shape))

    def run(method, steps, h):
        y = np.concatenate([np.asarray(part, float).reshape(-1) for part in trial.state])
        path = np.empty((trial.samples, half // 3, 3))
        for i in range(trial.samples):
            y = muslin.integrate(rate, y, h, steps, method=method, energy=energy, energy_growth=2.0)
            path[i] = y[:half].reshape(-1, 3)
        return measure.distance(path, reference)

    for method in ("rk4", "verlet", "euler"):
        bound = trial.drape(integrator="rk4" if method == "rk4" else "verlet").step_bound
        least, _ = measure.steps_in(trial.interval, bound, 0.95)
        plans = [(least * 2 ** k, None) for k in range(halvings + 1)] + [(None, 1.5), (None, 2.0)]
        for steps, share in plans:
            h = trial.interval / steps if steps else share * bound
            common = dict(integrator=method, precision=64, variant="mus_integrate", step_s=h, step_of_bound=h / bound,
                          floor_mm=floor)
            count = (steps or max(1, int(trial.interval / h))) * trial.samples
            try:
                found = run(method, steps or max(1, int(trial.interval / h)), h)
                evaluations = count * measure.EVALUATIONS[method] * trial.rows * trial.columns
                rows.append(trial.row(**common, **found, steps=count, node_evaluations=evaluations,
                                      spring_evaluations=evaluations // (trial.rows * trial.columns) * springs(lattice),
                                      note="time not plotted: the rate is numpy's"))
            except MuslinError as error:
                rows.append(trial.row(**common, status="diverged" if error.name == "MUS_ERR_DIVERGED" else error.name,
                                      note=error.text))
    return rows


def springs(lattice):
    """Springs and bending stencils, each counted once."""
    return int(sum(np.broadcast_to(s[2], lattice.rest[s[0]].shape[:2]).size for s in lattice.springs)
               + sum(lattice.rest[b[1]].shape[0] * lattice.rest[b[1]].shape[1] for b in lattice.bends))


def order_of(rows, integrator, precision=64, variant="mus_drape_step", above=30.0, most=4):
    """(slope, points) of log error against log h over the `most` smallest steps with an error above `above` floors."""
    floor = max(1e-12, *(r["floor_mm"] for r in rows))
    picked = [r for r in rows if r["status"] == "ok" and r["integrator"] == integrator and r["precision"] == precision
              and r["variant"] == variant and r["error_mm"] > above * floor]
    picked = sorted(picked, key=lambda r: r["step_s"])[:most]
    if len(picked) < 2:
        return float("nan"), len(picked)
    line = np.polyfit(np.log([r["step_s"] for r in picked]), np.log([r["error_mm"] for r in picked]), 1)
    return float(line[0]), len(picked)
