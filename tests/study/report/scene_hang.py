"""scene_hang.py: 1 m square, 0.2 kg/m2, held at two corners, let go level: settle beside RK4 and Verlet.

Its shapes at rest are found by Newton's method from where each of them ends, and from a sheet that no run of the
library has seen: hung straight down, with 0.1 mm of noise across. Shapes that lie more than 1 mm apart are shapes of
their own, and get letters. The largest strain of a line, the pins' forces and the balance of forces are those of the
solver, told by numpy alone (model.py's springs), beside the library's.
"""
import time

import numpy as np

import garment
import measure
import model
import muslin
import newton
import rest

PLAIN = dict(weight=0.2, stretch=(1300.0, 1300.0), shear=300.0)
APART_MM = 1.0


class Sheet:
    def __init__(self, side):
        self.side, self.cell = side, 1.0 / (side - 1)
        stencil = 20.0 * self.cell ** 2
        self.fabric = dict(PLAIN, bend=(stencil, stencil, stencil / 2))
        self.cloth = muslin.Cloth.grid(side, side, (self.cell, self.cell), muslin.Fabric(damping=0.0, **self.fabric))
        self.pins = (0, side - 1)
        self.start = np.zeros((side * side, 3))
        self.start[:, [0, 2]] = self.cloth.rest

    def level(self, **options):
        drape = muslin.Drape(self.cloth, **options)
        drape.set_state(self.start)
        for node in self.pins:
            drape.pin(node)
        return drape

    def straight_down(self):
        """Places of a sheet in the plane of its held edge."""
        places = np.array(self.start)
        places[:, [1, 2]] = np.column_stack([-self.start[:, 2], self.start[:, 1]])
        places[:, 2] += np.random.default_rng(1).normal(scale=1e-4, size=len(places))
        places[list(self.pins)] = self.start[list(self.pins)]
        return places

    def newton(self, places):
        """(places, columns) at rest by Newton's method, of a sheet held where the library holds it."""
        drape = self.level(precision=64)
        places = np.array(places)
        places[list(self.pins)] = drape.positions[list(self.pins)]
        return newton.rest(drape, self.cloth, places, pins=self.pins)

    def strain(self, places):
        """Largest of the lines along warp and weft."""
        x = np.asarray(places).reshape(self.side, self.side, 3)
        return max(float(np.linalg.norm(np.diff(x, axis=a), axis=-1).max()) for a in (0, 1)) / self.cell - 1

    def balance(self, places):
        """(greatest force left, over a node's weight, force of the pins over the weight), by model.py's springs."""
        held = np.zeros(self.side ** 2, bool)
        lattice = model.Lattice(self.side, self.side, (self.cell, self.cell), self.fabric, held, (0.0, -9.81, 0.0))
        over = lattice.acceleration(np.array(places).reshape(lattice.rest.shape)).reshape(-1, 3)
        mass = lattice.mass.reshape(-1)
        pins = -sum(mass[i] * over[i] for i in self.pins) / (9.81 * mass.sum())
        over[list(self.pins)] = 0.0
        return float(np.linalg.norm(over, axis=1).max()) / 9.81, float(pins[1])


def hanging(side, seconds=20.0, spans=rest.BUDGETS, plain=20.0):
    """Rows of: shapes at rest, the path of settle, those of RK4 and Verlet with drag 7, strain and pins at rest."""
    sheet = Sheet(side)

    def fresh(**options):
        return sheet.level(settle_residual=1e-3, **options)

    line = dict(scene="hang", error="rest", precision=32, contact="off", threads=1, spacing_mm=1e3 * sheet.cell,
                nodes=side * side)
    long = fresh(settle_seconds=seconds)
    garment.settle(long)
    shapes = [("where settle ended", *sheet.newton(long.positions))]
    rows = rest.budgets(fresh, shapes[0][1], dict(line, quantity="distance from rest", variant="settle"), spans,
                        sewn=False)
    for integrator in ("rk4", "verlet"):
        variant = f"{integrator}, drag 7"
        path = damped(sheet.level(integrator=integrator, drag=7.0), integrator, plain)
        shapes.append((f"where {variant} ended", *sheet.newton(path[-1][3])))
        rows += [measure.row(**line, quantity="distance from rest", variant=variant, integrator=integrator, cpu_s=cpu,
                             value=cpu, simulated_s=t, step_s=h, **rest.far(places, shapes[-1][1]), **counted)
                 for cpu, t, h, places, counted in path]
    shapes.append(("hung straight down, by hand", *sheet.newton(sheet.straight_down())))
    return named(shapes, line) + rows + statics(sheet, shapes, line)


def damped(drape, integrator, most_cpu, every=0.2):
    """[(CPU s, time, step, places, counts)] of mus_drape_step with drag until nothing moves, or `most_cpu` CPU seconds
    are gone."""
    path, spent, moving = [], 0.0, 3
    before = drape.report
    while spent < most_cpu and moving > 0:
        h = 0.9 * drape.step_bound
        last = np.array(drape.positions)
        start = time.process_time()
        drape.step(max(1, int(every / h)), h)
        spent += time.process_time() - start
        path.append((spent, drape.time, h, np.array(drape.positions), measure.counts(drape, before, integrator)))
        moving = moving - 1 if rest.far(path[-1][3], last)["error_mm"] < 0.02 else 3
    return path


def images(places):
    """Mirror images of a shape: in the plane of the pins, left to right, and both."""
    side = round(len(places) ** 0.5)
    behind = places * [1.0, 1.0, -1.0]
    swap = np.arange(side * side).reshape(side, side)[:, ::-1].reshape(-1)

    def turned(x):
        return x[swap] * [-1.0, 1.0, 1.0] + [1.0, 0.0, 0.0]

    return behind, turned(places), turned(behind)


def named(shapes, line):
    """Rows of the shapes at rest: A, B, ... where they differ."""
    found, rows = [], []
    for start, places, how in shapes:
        apart = [rest.far(places, other)["error_mm"] for other in found]
        letter = next((i for i, far in enumerate(apart) if far < APART_MM), len(found))
        if letter == len(found):
            found.append(places)
        told = f"; {apart[0]:.2g} mm from shape A" if apart else ""
        if letter > 0:
            image = min(rest.far(places, other)["error_mm"] for other in images(found[0]))
            told += f", {image:.2g} mm from a mirror image of it"
        rows.append(measure.row(**{**line, "precision": 64}, quantity="shape at rest",
                                variant=f"{start}: shape {'ABCD'[letter]}", **{**how, "note": how["note"] + told}))
    return rows


def statics(sheet, shapes, line):
    """The library's float settle with the def's own end, held against the solver of the same mesh."""
    drape = sheet.level()
    found = garment.settle(drape)
    # of the solver's shapes the one that the library's lies nearest to
    _, places, _ = min(shapes, key=lambda shape: rest.far(drape.positions, shape[1])["error_mm"])
    left, carried = sheet.balance(places)
    forces = sum(drape.forces[i] for i in sheet.pins) / (9.81 * float(np.sum(sheet.cloth.masses)))
    note = f"the solver's shape leaves {left:.1e} of a weight in model.py's springs"
    return [measure.row(**line, quantity="largest strain at rest", variant="settle", value=drape.report["max_strain"],
                        exact=sheet.strain(places), cpu_s=found["cpu_s"], status=found["status"], note=note),
            measure.row(**line, quantity="pins carry of the weight", variant="settle", value=-float(forces[1]),
                        exact=carried, cpu_s=found["cpu_s"], status=found["status"])]
