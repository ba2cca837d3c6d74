"""scene_disc.py: drape of a disc (B8): 30 cm of cloth on a support of 18 cm, hung over by its weight alone.

The scalar is the drape coefficient: the part of the ring that the shadow of the cloth still covers. A disc has several
shapes at rest; nine starts tell how far they are apart. Fabric of the mesh error: 0.15 kg/m2, C11 = 500, G = 40 N/m,
isotropic, bending length c = 3 cm (and 2 cm).
"""
import numpy as np

import garment
import measure
import muslin
from muslin.cloth import PAPER, PLATE

DISC, SUPPORT, WEIGHT, G = 0.15, 0.09, 0.15, 9.81
RAYS = 3600


def plain(bending_length):
    bend = WEIGHT * G * bending_length ** 3
    return {"weight": WEIGHT, "stretch": (500.0, 500.0), "shear": 40.0, "bend": (bend,) * 3, "damping": 0.0}


def cut(spacing, fabric, bending=PLATE):
    """A disc as one panel, level, cut in a fabric (a name or values)."""
    pattern = muslin.Pattern("disc")
    panel = pattern.add_panel("disc")
    points = [pattern.add_point(panel, DISC, 0.0), pattern.add_point(panel, -DISC, 0.0)]
    edges = [pattern.add_edge(points[0], points[1], ("arc",), [(0.0, DISC)]),
             pattern.add_edge(points[1], points[0], ("arc",), [(0.0, -DISC)])]
    pattern.set_outline(panel, edges)
    pattern.set_placement(panel, rotation=(1, 0, 0, 0, 0, 1, 0, -1, 0))
    values = muslin.Fabric(**fabric) if isinstance(fabric, dict) else muslin.Fabric(fabric, damping=0.0)
    return muslin.Cloth(pattern, values, spacing=spacing, bending=bending, coarser=0)


def lay(cloth, lobes=6, seed=0, **options):
    """On its support, the ring in shallow folds, and (seed > 0) shaken by up to 1 mm. Nodes up to half a spacing beyond
    the support's edge are held: the rim of held nodes is then the circle, in the mean."""
    drape = muslin.Drape(cloth, **options)
    drape.place()
    places = np.array(drape.positions)
    r = np.hypot(places[:, 0], places[:, 2])
    s = np.maximum(0.0, (r - SUPPORT) / (DISC - SUPPORT))
    places[:, 1] += 0.01 * s * s * (np.cos(lobes * np.arctan2(places[:, 2], places[:, 0])) - 1.0)
    if seed:
        places[:, 1] += 1e-3 * s * (2.0 * np.random.default_rng(seed).random(len(places)) - 1.0)
    drape.set_state(places)
    for node in np.flatnonzero(r <= SUPPORT + 0.5 * cloth.spacing):
        drape.pin(int(node))
    return drape


def coefficient(places, triangles):
    """Shadow outside of the support over the ring of the flat cloth [%]."""
    flat = places[:, [0, 2]]
    sides = np.sort(np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]]), axis=1)
    sides = np.unique(sides, axis=0)
    a, b = flat[sides[:, 0]], flat[sides[:, 1]]
    cross = a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]
    a, b = np.where(cross[:, None] < 0, b, a), np.where(cross[:, None] < 0, a, b)
    start, wide = np.arctan2(a[:, 1], a[:, 0]), np.arctan2(np.abs(cross), (a * b).sum(1))
    unit = 2 * np.pi / RAYS
    reach = np.zeros(RAYS)
    for i in range(len(a)):
        k = np.arange(np.ceil(start[i] / unit), np.floor((start[i] + wide[i]) / unit) + 1)
        along = (b[i, 0] - a[i, 0]) * np.sin(k * unit) - (b[i, 1] - a[i, 1]) * np.cos(k * unit)
        far = np.where(np.abs(along) > 1e-15, np.abs(cross[i] / np.where(along == 0, 1, along)), 0.0)
        np.maximum.at(reach, k.astype(int) % RAYS, far)
    area, support = 0.5 * unit * (reach ** 2).sum(), np.pi * SUPPORT ** 2
    return 100 * (area - support) / (np.pi * DISC ** 2 - support)


def time_error(spacing=0.01, halvings=6, span=0.1, bending_length=0.03):
    """The disc at rest, gravity tilted by 10 degrees: it sways, without new folds."""
    cloth = cut(spacing, plain(bending_length))
    still = lay(cloth, precision=64, settle_residual=1e-4)
    garment.settle(still)
    places = np.array(still.positions)

    def make(**options):
        drape = lay(cloth, drag=0.5, gravity=garment.TILTED, **options)
        drape.set_state(places)
        return drape

    return garment.time_error("disc", make, span, halvings, spacing_mm=1e3 * spacing, contact="off")


def parting(spacing=0.01, span=0.2, samples=50):
    """Let go flat, the ring buckles: until when double and float, or two steps, stay within 1 mm of each other."""
    cloth = cut(spacing, plain(0.02))
    paths = {}
    for name, precision, share in (("double", 64, 0.95), ("float", 32, 0.95), ("double, half the step", 64, 0.475)):
        drape = lay(cloth, precision=precision)
        state = np.array(drape.positions), np.array(drape.velocities)
        steps, h = measure.steps_in(span / samples, drape.step_bound, share)
        paths[name] = measure.path_of(drape, state, steps, h, samples)
    rows = []
    for name in list(paths)[1:]:
        far = 1e3 * np.linalg.norm(paths[name] - paths["double"], axis=2).max(1)
        late = np.flatnonzero(far > 1.0)
        rows.append(measure.row(scene="disc", error="time", variant=name, integrator="rk4", precision=64, contact="off",
                                quantity="time until it is 1 mm from double [s]", spacing_mm=1e3 * spacing,
                                nodes=len(drape), threads=1, simulated_s=span, error_mm=float(far[-1]),
                                value=span / samples * float(late[0] + 1 if len(late) else np.inf)))
    return rows


def at_rest(spacing, fabric, lobes=6, seed=0, bending="plate", precision=32, error="mesh", exact=None, seconds=10.0):
    """Drape coefficient at rest."""
    cloth = cut(spacing, plain(fabric) if isinstance(fabric, float) else fabric, PAPER if bending == "paper" else PLATE)
    drape = lay(cloth, lobes, seed, precision=precision, settle_residual=0.005, settle_seconds=seconds)
    triangles = np.array(cloth.triangles)
    before = drape.report
    found = garment.settle(drape)
    percent = float(coefficient(drape.positions, triangles))
    name = f"c = {100 * fabric:g} cm" if isinstance(fabric, float) else fabric
    return measure.row(scene="disc", error=error, quantity=f"drape coefficient [%], {name}", bending=bending, threads=1,
                       variant=f"{lobes} folds at the start, seed {seed}", precision=precision, contact="off",
                       spacing_mm=1e3 * spacing, nodes=len(drape), value=percent, exact=exact, **found,
                       **measure.counts(drape, before, "euler"))


def mesh_error(lengths=(0.03, 0.02), spacings=(0.02, 0.01, 0.005, 0.0025), starts=9):
    rows = []
    for c in lengths:
        # the finest takes a minute: of the first fabric alone
        rows += [at_rest(a, c, seconds=6.0) for a in spacings if a > 0.004 or c == lengths[0]]
        rows += [at_rest(a, c, bending="paper") for a in spacings if a > 0.006]
        rows += [at_rest(0.01, c, lobes=4 + seed % 5, seed=seed) for seed in range(1, starts + 1)]
    rows.append(at_rest(0.01, lengths[0], precision=64))
    return rows


def model_error(spacings=(0.01, 0.005), seconds=4.0):
    """Fabrics whose bending and drape coefficient were both measured by the same people; the
    limper one needs the finer mesh for its folds."""
    return [at_rest(spacing, name, precision=64, error="model", exact=measured, seconds=seconds)
            for spacing, name, measured in ((spacings[0], "broadcloth", 82.9), (spacings[1], "polyester", 28.3))]
