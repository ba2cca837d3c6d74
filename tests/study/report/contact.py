"""contact.py: cloth on a limb, against answers that are not the library's.

A row of nodes lies over a level cylinder. Pinned on its top and without friction it comes to the least energy that
keeps every node outside: scipy finds that minimum by itself, from model.py's springs and the circle alone. Not held,
with friction, a heavy row that hangs down on both sides holds or slips by the capstan's law with its own weight: with
the radius R, the weight w a length and arms a and b,

    T' = R w cos t + mu (T + R w sin t),  T(0) = w a,  T(pi) = w b

which is linear: the longest arm b that friction can hold is known in closed form.
"""
import numpy as np
import scipy.optimize

import measure
import model
import muslin

RADIUS, CLEARANCE, WIDTH, WEIGHT, G = 0.05, 0.002, 0.01, 0.15, 9.81
FABRIC = {"weight": WEIGHT, "stretch": (2000.0, 2000.0), "shear": 0.0, "bend": (5e-6, 5e-6, 5e-6)}
REACH = RADIUS + CLEARANCE


def cylinder():
    """Axis along z."""
    rows = [(-0.2, 0.0, 0.0, RADIUS, RADIUS, 2.0), (0.2, 0.0, 0.0, RADIUS, RADIUS, 2.0)]
    return muslin.Body.of_limbs([{"contour": rows, "pole": (-0.25, 0.25), "origin": (0.0, 0.0, 0.0),
                                  "axis": (0.0, 0.0, 1.0), "side": (1.0, 0.0, 0.0)}])


def row_of(nodes, length, friction, **options):
    cell = (length / (nodes - 1), WIDTH)
    cloth = muslin.Cloth.grid(1, nodes, cell, muslin.Fabric(damping=0.0, friction=friction, **FABRIC), coarser=0)
    return muslin.Drape(cloth, cylinder(), precision=64, clearance=CLEARANCE, **options)


def over(s):
    """Places at lengths s along a path up the left side, over the top from s = 0 on, and down the right."""
    t = np.clip(s / REACH, 0.0, np.pi)
    places = np.zeros((len(s), 3))
    places[:, 0], places[:, 1] = -REACH * np.cos(t), REACH * np.sin(t)
    places[:, 1] += np.minimum(s, 0.0) - np.maximum(s - np.pi * REACH, 0.0)
    return places


# ---- without friction: a minimum with bounds ----

def least_energy(nodes, length):
    """Places (nodes x 2) of least energy outside of the circle, the first node held on its top, by SLSQP."""
    held = np.arange(nodes) == 0
    lattice = model.Lattice(1, nodes, (length / (nodes - 1), WIDTH), FABRIC, held, (0.0, -G, 0.0))
    scale = WEIGHT * G * WIDTH * length * length

    def full(flat):
        x = np.zeros((1, nodes, 3))
        x[0, 0, 1] = REACH
        x[0, 1:, :2] = flat.reshape(-1, 2)
        return x

    def energy(flat):
        x = full(flat)
        pull = lattice.acceleration(x) * lattice.mass[..., None]
        return lattice.energy(x, 0 * x) / scale, -pull[0, 1:, :2].reshape(-1) / scale

    def outside(flat):
        return (flat.reshape(-1, 2) ** 2).sum(1) / REACH ** 2 - 1

    def slope(flat):
        out = np.zeros((nodes - 1, flat.size))
        for i, point in enumerate(flat.reshape(-1, 2)):
            out[i, 2 * i:2 * i + 2] = 2 * point / REACH ** 2
        return out

    start = over(np.linspace(0.0, length, nodes) + 0.5 * np.pi * REACH)[1:, :2].reshape(-1)
    found = scipy.optimize.minimize(energy, start, jac=True, method="SLSQP", options={"maxiter": 5000, "ftol": 1e-15},
                                    constraints=[{"type": "ineq", "fun": outside, "jac": slope}])
    return full(found.x).reshape(-1, 3), found.message


def resting(cells=(15, 30, 60), length=0.3):
    rows = []
    for n in cells:
        drape = row_of(n + 1, length, 0.0, settle_residual=1e-6, settle_seconds=60.0)
        drape.set_state(over(np.linspace(0.0, length, n + 1) + 0.5 * np.pi * REACH))
        drape.pin(0)
        status, note = "ok", ""
        try:
            drape.settle()
        except muslin.MuslinError as error:
            status, note = error.name, error.text
        places, told = least_energy(n + 1, length)
        far = measure.distance(np.array(drape.positions)[None], places[None])
        rows.append(measure.row(scene="row on a limb", error="contact", quantity="places at rest, no friction",
                                variant="mus_drape_settle", precision=64, contact="on", threads=1, nodes=n + 1,
                                spacing_mm=1e3 * length / n, status=status, note=note or told, **far))
    return rows


# ---- with friction: the capstan's law with weight ----

def longest_arm(left, friction):
    """b / R from a / R."""
    m = friction
    a = -2 * m / (1 + m * m)
    return np.exp(np.pi * m) * (left - a) - a


def pulled(left, right, nodes):
    """Lengths along the path of a row that hangs still: stretched by the tension that the least friction which holds it
    leaves, so that nothing jerks when it is let go."""
    low, high = 0.0, 5.0
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if longest_arm(left, middle) < right else (low, middle)
    m = 0.5 * (low + high)
    a, b = -2 * m / (1 + m * m), (1 - m * m) / (1 + m * m)
    s = np.linspace(-left, np.pi + right, nodes)  # in radii
    t = np.clip(s, 0.0, np.pi)
    tension = WEIGHT * G * REACH * np.where(s < 0, s + left, np.where(
        s > np.pi, np.pi + right - s, np.exp(m * t) * (left - a) + a * np.cos(t) + b * np.sin(t)))
    strain = tension / FABRIC["stretch"][0]
    stretched = np.concatenate([[0.0], np.cumsum(REACH * np.diff(s) * (1 + 0.5 * (strain[1:] + strain[:-1])))])
    return stretched - np.interp(0.0, s, stretched)


def slips(friction, left, right, nodes, seconds=1.0):
    """Whether a row with arms of left and right radii slides by more than a tenth of the radius."""
    drape = row_of(nodes, REACH * (left + np.pi + right), friction, drag=0.5)
    places = over(pulled(left, right, nodes))
    drape.set_state(places)
    h = 0.9 * drape.step_bound
    for _ in range(10):
        drape.step(int(0.1 * seconds / h) + 1, h)
        if drape.positions[0, 1] - places[0, 1] > 0.1 * REACH:
            return True
    return False


def capstan(frictions=(0.1, 0.3, 0.5), left=1.0, meshes=(61, 121, 241), rounds=7):
    """The arm at which the row begins to slip, by halving, beside the law."""
    rows = []
    for friction in frictions:
        exact = longest_arm(left, friction)
        for nodes in meshes:
            low, high = 0.8 * exact, 1.2 * exact
            for _ in range(rounds):
                middle = 0.5 * (low + high)
                low, high = (low, middle) if slips(friction, left, middle, nodes) else (middle, high)
            found = 0.5 * (low + high)
            rows.append(measure.row(scene="row on a limb", error="contact", precision=64, contact="on", threads=1,
                                    quantity="longest arm that friction holds, radii", variant=f"friction {friction:g}",
                                    spacing_mm=1e3 * REACH * (left + np.pi + exact) / (nodes - 1), nodes=nodes,
                                    value=found, exact=exact, error_mm=1e3 * REACH * abs(found - exact)))
    return rows


def on_a_limb(cells=(15, 30, 60), **options):
    return resting(cells) + capstan(**options)
