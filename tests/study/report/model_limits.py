"""model_limits.py: what no step and no spacing cures: the model against figures of measured cloth.

Gaps that follow from the fabric's own numbers. A lattice of central springs ties the lateral contraction to shear, nu =
G / C11. Measured cloth keeps a curvature of 2HB / (2 B) after a fold, and so does the model where 2HB is given; the
drape coefficient of the same fabrics is in scene_disc.py.
"""
import measure
import muslin

# least and greatest measured Poisson ratio of four woven fabrics (Penava 2014); residual curvatures 2HB / 2B of three
# fabrics (Matsudaira et al. 2015) from B [N m] and 2HB [N]
POISSON = (0.071, 0.381)
HYSTERESIS = {"broadcloth": (11.57e-6, 1.216e-3), "tropical": (6.57e-6, 0.324e-3), "polyester": (1.86e-6, 0.069e-3)}


def gaps(woven=("cotton", "denim", "wool", "silk", "polyester", "broadcloth", "tropical", "shirting")):
    rows = []
    for name in woven:
        values = muslin.Fabric(name).values()
        rows.append(measure.row(scene="fabric", error="model", quantity="lateral contraction G / C11", variant=name,
                                value=values["shear"] / values["stretch"][0], exact=sum(POISSON) / 2,
                                note=f"measured on four woven fabrics: {POISSON[0]} to {POISSON[1]}"))
    for name, (bend, loss) in HYSTERESIS.items():
        values = muslin.Fabric(name).values()
        rows.append(measure.row(scene="fabric", error="model", quantity="curvature kept after a fold [1/m]",
                                variant=name, value=values["bend_hysteresis"] / (2 * values["bend"][0]),
                                exact=loss / (2 * bend), note="2HB / 2B of the fabric; suite bend_slider bends it"))
    return rows
