"""scene_garments.py: a skirt on a standing body with friction, and a T-shirt sewn and settled on one.

Both start at rest; then gravity tilts by 10 degrees, so that they sway and slip a little (time error). The skirt's
motion is also run without its body, held at the waist: the same cloth without contact. Mesh error: what a garment maker
reads off, the height of the hem, from several starts a spacing: a garment has several shapes at rest.
"""
import numpy as np

import garment
import measure
import muslin


def at_rest(cloth, body):
    """The garment sewn and settled on its body."""
    still = muslin.Drape(cloth, body, settle_seconds=20.0)
    still.place()
    still.sew()
    garment.settle(still)
    return still


def maker(cloth, body, still, contact):
    """make(precision=, integrator=): a drape that starts from the shape at rest, with gravity tilted. Without contact
    it is held where it lies on the waist or the shoulders."""
    heights = np.array(still.positions)[:, 1]
    upper = np.flatnonzero(heights > heights.max() - 0.02)

    def make(**options):
        drape = muslin.Drape(cloth, body if contact == "on" else None, **options)
        drape.place()
        drape.warm(still)
        drape.set_gravity(garment.TILTED)
        if contact == "off":
            for node in upper:
                drape.pin(int(node))
        return drape

    return make


def time_error(design, spacing=0.02, halvings=6, span=0.1, contact="on", samples=50, finer=64,
               damping=0.0, fabric=None):
    """Swaying garment; contact="off": without a body, held where it lies on the waist or the shoulders. damping is that
    of the fabric: dashpots are forces of velocity, which velocity Verlet takes with its first order alone."""
    tape = muslin.Tape.read(garment.TAPE)
    pattern, body = muslin.draft(design, tape), muslin.Body(tape)
    values = muslin.Fabric(fabric, damping=damping) if fabric else muslin.Fabric(damping=damping)
    cloth = muslin.Cloth(pattern, values, spacing=spacing)
    make = maker(cloth, body, at_rest(cloth, body), contact)

    def hem(places):
        return float(1e3 * places[:, 1].min())

    return garment.time_error(f"{design}, {fabric}" if fabric else design, make, span, halvings, samples, finer,
                              scalar=hem, spacing_mm=1e3 * spacing, contact=contact, dashpots=damping > 0.0)


def mesh_error(design, plan=((0.02, 9), (0.01, 5), (0.005, 1))):
    """Height of the hem at rest; for each seed but the first the sewn garment is put up to 1 mm elsewhere."""
    rows = []
    for spacing, seeds in plan:
        for seed in range(seeds):
            drape, _, _ = garment.dressed(design, spacing, settle_seconds=15.0)
            sewn = garment.settle(drape, "sew")
            if seed:
                drape.set_state(np.array(drape.positions) + 1e-3 * (2 * np.random.default_rng(seed).random(3) - 1))
            before = drape.report
            found = garment.settle(drape)
            if sewn["status"] != "ok":
                found.update(status=sewn["status"], note=sewn["note"])
            rows.append(measure.row(scene=design, error="mesh", variant=f"seed {seed}", precision=32, contact="on",
                                    threads=1, spacing_mm=1e3 * spacing, nodes=len(drape),
                                    quantity="hem above the floor [mm]", value=1e3 * lowest(drape.positions),
                                    **found, **measure.counts(drape, before, "euler")))
    return rows


def lowest(places):
    """Mean height of the lowest fiftieth of the nodes: the hem, without one node's chance [m]."""
    heights = np.sort(np.array(places)[:, 1])
    return float(heights[: max(1, len(heights) // 50)].mean())
