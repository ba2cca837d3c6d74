"""scene_disc.py: drape of a disc (B8): 30 cm of cloth on a support of 18 cm, hung over by its weight alone.

The scalar is the drape coefficient: the part of the ring that the shadow of the cloth still covers. A disc has several
shapes at rest; further starts tell how far they are apart. Fabric of the mesh error: 0.15 kg/m2, C11 = 500, G = 40 N/m,
isotropic, bending length c = 3 cm (and 2 cm). At rest the disc is that of the study fabric, whose mesh fits both
circles; what sways is a plain disc of one panel.
"""
import pathlib
import sys

import numpy as np

import garment
import measure
import muslin
from muslin.cloth import PAPER, PLATE

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "fabric"))
import cusick  # noqa: E402  (of the study fabric)

DISC, SUPPORT, WEIGHT, G = 0.15, 0.09, 0.15, 9.81


def plain(bending_length):
    bend = WEIGHT * G * bending_length ** 3
    return {"weight": WEIGHT, "stretch": (500.0, 500.0), "shear": 40.0, "bend": (bend,) * 3, "damping": 0.0}


def cut(spacing, fabric):
    """A disc as one panel, level, cut in a fabric of these values."""
    pattern = muslin.Pattern("disc")
    panel = pattern.add_panel("disc")
    points = [pattern.add_point(panel, DISC, 0.0), pattern.add_point(panel, -DISC, 0.0)]
    edges = [pattern.add_edge(points[0], points[1], ("arc",), [(0.0, DISC)]),
             pattern.add_edge(points[1], points[0], ("arc",), [(0.0, -DISC)])]
    pattern.set_outline(panel, edges)
    pattern.set_placement(panel, rotation=(1, 0, 0, 0, 0, 1, 0, -1, 0))
    return muslin.Cloth(pattern, muslin.Fabric(**fabric), spacing=spacing, coarser=0)


def lay(cloth, lobes=6, **options):
    """On its support, the ring in shallow folds. Nodes up to half a spacing beyond the support's edge are held: the rim of
    held nodes is then the circle, in the mean."""
    drape = muslin.Drape(cloth, **options)
    drape.place()
    places = np.array(drape.positions)
    r = np.hypot(places[:, 0], places[:, 2])
    s = np.maximum(0.0, (r - SUPPORT) / (DISC - SUPPORT))
    places[:, 1] += 0.01 * s * s * (np.cos(lobes * np.arctan2(places[:, 2], places[:, 0])) - 1.0)
    drape.set_state(places)
    for node in np.flatnonzero(r <= SUPPORT + 0.5 * cloth.spacing):
        drape.pin(int(node))
    return drape


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


def at_rest(spacing, fabric, seed=0, bending="plate", precision=32, error="mesh", exact=None, seconds=6.0):
    """Drape coefficient at rest, as the laboratory's: mesh, support and loading are those of tests/study/fabric."""
    values = muslin.Fabric(**plain(fabric)) if isinstance(fabric, float) else muslin.Fabric(fabric)
    cloth = muslin.Cloth(cusick.pattern(), values, spacing=spacing, coarser=0,
                         bending=PAPER if bending == "paper" else PLATE)
    drape = cusick.lay(cloth, seed, seconds=seconds, precision=precision)
    before, found = drape.report, {"cpu_s": 0.0, "simulated_s": 0.0, "repeats": 1, "status": "ok", "note": ""}
    for load in cusick.LOADS:
        drape.set_gravity((0.0, -load * cusick.GRAVITY, 0.0))
        part = garment.settle(drape)
        found["cpu_s"] += part["cpu_s"]
        found["simulated_s"] += part["simulated_s"]
        if part["status"] != "ok":
            found.update(status=part["status"], note=part["note"])
    percent = float(cusick.coefficient(np.array(drape.positions), np.array(cloth.triangles)))
    name = f"c = {100 * fabric:g} cm" if isinstance(fabric, float) else fabric
    return measure.row(scene="disc", error=error, quantity=f"drape coefficient [%], {name}", bending=bending, threads=1,
                       variant=f"seed {seed}", precision=precision, contact="off", spacing_mm=1e3 * spacing,
                       nodes=len(drape), value=percent, exact=exact, **found,
                       **measure.counts(drape, before, "euler"))


def mesh_error(lengths=(0.03, 0.02), spacings=(0.02, 0.01, 0.005), starts=5):
    rows = []
    for c in lengths:
        rows += [at_rest(a, c) for a in spacings]
        rows += [at_rest(a, c, bending="paper") for a in spacings if a > 0.006]
        rows += [at_rest(0.01, c, seed=seed) for seed in range(1, starts + 1)]
    rows.append(at_rest(0.01, lengths[0], precision=64))
    return rows


def model_error(spacings=(0.01, 0.005), seconds=6.0):
    """Fabrics whose bending, friction of bending and drape coefficient were measured by the same people."""
    return [at_rest(spacing, name, error="model", exact=measured, seconds=seconds)
            for name, measured in (("broadcloth", 82.9), ("polyester", 28.3)) for spacing in spacings]
