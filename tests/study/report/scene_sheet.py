"""scene_sheet.py: stretched sheet (M6): smooth motion without contact, where the order of a method can be seen.

A square of 1 m, stretched by 2 % and held at all edges, is let go from a bump of 20 mm (time error: the motion is not
linear, so there is no closed form), or from 0.1 mm of its first mode (mesh error: the membrane's frequency is known).
"""
import numpy as np

import implicit
import measure
import model
import runs

SIDE, STRAIN, BUMP, INTERVAL, SAMPLES = 1.0, 0.02, 20e-3, 2e-3, 50
FABRIC = {"weight": 0.15, "stretch": (500.0, 500.0), "shear": 40.0, "bend": (0.0, 0.0, 0.0)}


def sheet(n, form, height, interval=INTERVAL, samples=SAMPLES):
    """n x n cells, stretched to 1 m; form(x, y) times height is how far it stands off its plane."""
    cell = SIDE / (n * (1 + STRAIN))
    index = np.arange(n + 1)
    edge = (index == 0) | (index == n)
    held = edge[:, None] | edge[None, :]
    lattice = model.Lattice(n + 1, n + 1, (cell, cell), FABRIC, held)
    places = np.array(lattice.rest) * (1 + STRAIN)
    places[..., 2] = np.where(held, 0.0, height * form(places[..., 0], places[..., 1]))
    places = places.reshape(-1, 3)
    return runs.Trial("sheet", lattice, (cell, cell), FABRIC, (places, np.zeros_like(places)), interval, samples,
                      (0.0, 0.0, 0.0))


def bump(x, y):
    """Smooth and narrower than the sheet: several modes, and the plane's own."""
    return (np.sin(np.pi * x) * np.sin(np.pi * y)) ** 4


def mode(x, y):
    return np.sin(np.pi * x) * np.sin(np.pi * y)


def time_error(n=50, halvings=8, samples=SAMPLES, implicit_steps=(1, 2)):
    scene = sheet(n, bump, BUMP, samples=samples)
    reference, floor = runs.references(scene)
    rows = runs.steppers(scene, reference, floor, halvings=halvings, stop_mm=20 * floor)
    return rows + implicit.steps(scene, reference, floor, per_sample=implicit_steps)


def integrator_error(n=20, halvings=4, samples=SAMPLES):
    """The public integrators on a coarser sheet: numpy's rate is slow."""
    scene = sheet(n, bump, BUMP, samples=samples)
    reference, floor = runs.references(scene)
    return runs.integrators(scene, reference, floor, halvings)


def mesh_error(cells=(50, 100, 200, 400), periods=0.5):
    """Middle of the sheet against the membrane without a mesh, over half a period of its first mode."""
    rows, height = [], 1e-4
    limit = model.membrane_limit(SIDE, STRAIN, FABRIC["weight"], FABRIC["stretch"][0], FABRIC["shear"])
    interval = periods * 2 * np.pi / limit / 10
    for n in cells:
        scene = sheet(n, mode, height, interval, 10)
        drape = scene.drape(64, "verlet")
        steps, h = measure.steps_in(interval, drape.step_bound, 0.95)
        path = measure.path_of(drape, scene.state, steps, h, 10)
        middle = path[:, (n + 1) * (n // 2) + n // 2, 2]
        wrong = np.abs(middle - height * np.cos(limit * interval * np.arange(1, 11)))
        # scaled from a swing of 0.1 mm, where the motion is linear, to the 20 mm of the other run
        rows.append(measure.row(scene="sheet", error="mesh", quantity="middle, scaled to a swing of 20 mm",
                                variant="mus_drape_step", integrator="verlet", precision=64, contact="off", threads=1,
                                spacing_mm=1e3 * SIDE / n, nodes=(n + 1) ** 2, step_s=h, simulated_s=10 * interval,
                                error_mm=1e3 * float(wrong.max()) * BUMP / height))
    return rows
