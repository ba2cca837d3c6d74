"""garment.py: what the scenes of cut and sewn cloth share: time errors of a drape, settling, a dressed body.

Springs of the boundary strip are not public, so that no second program can have the same ones: the second reference is
velocity Verlet in double at 1/64 of its largest step (without contact and dashpots extrapolated from that
and 1/32), beside RK4 at
1/64 of its own; they share the forces and the contact, and nothing of the stepping.
"""
import numpy as np

import measure
import muslin

G, TILT = 9.81, np.radians(10.0)
TILTED = (G * np.sin(TILT), -G * np.cos(TILT), 0.0)
TAPE = measure.ROOT / "examples" / "tapes" / "w40.tape"


def settle(drape, do="settle"):
    """Columns of a settle (or sew): seconds, status; a run that was not at rest in time says so."""
    found = {"status": "ok", "note": ""}
    start = drape.report["settle_time"] + drape.report["sew_time"]

    def run():
        try:
            getattr(drape, do)()
        except muslin.MuslinError as error:
            found.update(status="unsettled" if error.name == "MUS_ERR_UNSETTLED" else error.name, note=error.text)

    found.update(measure.seconds_of(run, most=1))
    found["simulated_s"] = drape.report["settle_time"] + drape.report["sew_time"] - start
    return found


def time_error(scene, make, span, halvings=6, samples=50, finer=64, precisions=(64, 32), scalar=None,
               dashpots=False, **common):
    """RK4 and Verlet, float and double, from 0.95 of the bound down by halves, and a step above the bound.

    make(precision=, integrator=) gives a drape in its first state. Samples are taken at equal times of `span`.
    """
    interval, paths = span / samples, {}
    for integrator in ("rk4", "verlet"):
        drape = make(precision=64, integrator=integrator)
        state = np.array(drape.positions), np.array(drape.velocities)
        least, _ = measure.steps_in(interval, drape.step_bound, 0.95)
        paths[integrator] = measure.path_of(drape, state, finer * least, interval / (finer * least), samples)
        if integrator == "verlet" and common["contact"] == "off" and not dashpots:
            half = finer * least // 2
            coarser = measure.path_of(drape, state, half, interval / half, samples)
            paths[integrator] = (4.0 * paths[integrator] - coarser) / 3.0
    reference = paths["rk4"]
    floor = measure.distance(paths["verlet"], reference)["error_mm"]
    rows = []
    for integrator in ("rk4", "verlet"):
        for precision in precisions:
            drape = make(precision=precision, integrator=integrator)
            bound = drape.step_bound
            least, _ = measure.steps_in(interval, bound, 0.95)
            line = dict(scene=scene, error="time", variant="mus_drape_step", integrator=integrator, threads=1,
                        precision=precision, nodes=len(drape), floor_mm=floor, **common)
            best, worse = np.inf, 0
            for halving in range(halvings + 1):
                steps = least * 2 ** halving
                h = interval / steps
                found = measure.point(drape, integrator, state, h, steps, samples, reference)
                value = scalar(drape.positions) if scalar else None
                rows.append(measure.row(**line, quantity=f"places at {samples} times", step_s=h,
                                        step_of_bound=h / bound, value=value, **found))
                worse = worse + 1 if found["error_mm"] > 0.7 * best else 0
                best = min(best, found["error_mm"])
                if worse == 2 and precision == 32:
                    break
            drape.set_state(*state)
            rows.append(refused(drape, 1.05 * bound, dict(line, quantity=f"places at {samples} times",
                                                          step_of_bound=1.05)))
    return rows


def refused(drape, h, line):
    try:
        drape.step(1, h)
        return measure.row(**line, step_s=h, status="ok", note="a step above the bound was made")
    except muslin.MuslinError as error:
        return measure.row(**line, step_s=h, status="refused" if error.name == "MUS_ERR_STEP" else error.name,
                           note=error.text)


def dressed(design, spacing, fabric=None, coarser=1, tape=None, **options):
    """(drape placed round its body, cloth, pattern)."""
    tape = tape or muslin.Tape.read(TAPE)
    pattern = muslin.draft(design, tape)
    cloth = muslin.Cloth(pattern, fabric or muslin.Fabric(), spacing=spacing, coarser=coarser)
    drape = muslin.Drape(cloth, muslin.Body(tape), **options)
    drape.place()
    return drape, cloth, pattern
