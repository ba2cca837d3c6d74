"""scene_strip.py: hanging strip (M1, M6): exact at rest for every mesh, and exact while it bobs in its first mode.

1 m of cloth of 0.15 kg/m2 and C11 = 1000 N/m hangs from its top edge and bobs by 5 mm. Springs in a row on a line are
linear, so the discrete strip's motion is known in closed form (time error), and so is the strip's without a mesh (mesh
error). The time error has two references: the closed form, and the library in double at 1/64 of the largest step.
"""
import numpy as np

import measure
import model
import runs
import muslin

LENGTH, SWING, INTERVAL, SAMPLES, G = 1.0, 5e-3, 2e-3, 50, 9.81
FABRIC = {"weight": 0.15, "stretch": (1000.0, 1000.0), "shear": 0.0, "bend": (0.0, 0.0, 0.0)}
WEIGHT, STRETCH = FABRIC["weight"], FABRIC["stretch"][0]


def trial(n):
    """The strip of n cells at the lowest point of its swing; node 0 is the free end."""
    held = np.arange(n + 1) == n
    cell = (LENGTH / n, LENGTH / n)
    lattice = model.Lattice(n + 1, 1, cell, FABRIC, held, (0.0, -G, 0.0))
    shape, frequency = model.strip_mode(n, LENGTH, WEIGHT, STRETCH)
    rest = model.strip_at_rest(n, LENGTH, WEIGHT, STRETCH)
    places = np.zeros((n + 1, 3))
    places[::-1, 1] = -(rest + SWING * shape)
    times = INTERVAL * np.arange(1, SAMPLES + 1)
    exact = np.zeros((SAMPLES, n + 1, 3))
    exact[:, ::-1, 1] = -(rest + SWING * np.cos(frequency * times)[:, None] * shape)
    return runs.Trial("strip", lattice, cell, FABRIC, (places, np.zeros_like(places)), INTERVAL, SAMPLES,
                      (0.0, -G, 0.0)), exact


def time_error(n=16, halvings=10):
    scene, exact = trial(n)
    reference, floor = runs.references(scene, exact)
    return runs.steppers(scene, reference, floor, halvings=halvings) + runs.integrators(scene, reference, floor, 6)


def mesh_error(cells=(50, 100, 200, 400)):
    """Free end against the strip without a mesh: in motion (order 2), and at rest (none)."""
    rows = []
    times = INTERVAL * np.arange(1, SAMPLES + 1)
    limit = np.cos(model.strip_frequency(LENGTH, WEIGHT, STRETCH) * times)
    for n in cells:
        scene, _ = trial(n)
        drape = scene.drape(64, "rk4")
        steps, h = measure.steps_in(INTERVAL, drape.step_bound, 0.95)
        path = measure.path_of(drape, scene.state, steps, h, SAMPLES)
        rest = model.strip_at_rest(n, LENGTH, WEIGHT, STRETCH)[-1]
        wrong = np.abs(-path[:, 0, 1] - rest - SWING * limit)
        common = dict(scene="strip", error="mesh", variant="mus_drape_step", precision=64, contact="off", threads=1,
                      spacing_mm=1e3 * LENGTH / n, nodes=n + 1)
        rows.append(measure.row(**common, quantity="bobbing of the free end", integrator="rk4", step_s=h,
                                simulated_s=INTERVAL * SAMPLES, error_mm=1e3 * float(wrong.max())))
        rows.append(at_rest(n, common))
    return rows


def at_rest(n, common):
    """Lengthening at rest, found by mus_drape_settle: w L^2 / (2 Y) = 0.73575 mm."""
    cell = (LENGTH / n, LENGTH / n)
    cloth = muslin.Cloth.grid(n + 1, 1, cell, muslin.Fabric(damping=0.0, **FABRIC), coarser=0)
    drape = muslin.Drape(cloth, precision=64, settle_residual=1e-6, settle_seconds=20.0)
    places = np.zeros((n + 1, 3))
    places[:, 1] = LENGTH / n * (np.arange(n + 1) - n)
    drape.set_state(places)
    drape.pin(n)
    status, note = "ok", ""
    try:
        drape.settle()
    except muslin.MuslinError as error:
        status, note = error.name, error.text
    longer, exact = 1e3 * float(-drape.positions[0, 1] - LENGTH), 1e3 * WEIGHT * G * LENGTH ** 2 / (2 * STRETCH)
    return measure.row(**common, quantity="lengthening at rest", value=longer, exact=exact, status=status, note=note,
                       error_mm=abs(longer - exact))
