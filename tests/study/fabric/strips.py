"""strips.py: strips of a fabric in the laboratory: cantilever, tensile test and lateral contraction."""
import math

import numpy as np

import cusick
import muslin

WIDTH = 0.025             # [m] of a strip of ISO 9073-7
TENSILE = (0.20, 0.05)    # [m] width and length between the jaws of KES-FB1
LOAD = 490.33             # [N/m] of KES-FB1: 500 gf/cm
PULLED = (0.05, 0.20)     # [m] width and length of a strip whose width is watched
STRAIN = 0.01             # of that strip


def sheet(fabric, width, length, cells, extra=0, residual=1.0, gravity=0.0, seconds=10.0):
    """A drape of a strip of `cells` cells along its length (x, the weft of a grid) and `extra` held ones before it. The
    residual is of a node's weight, which is some 1e-5 of what a pulled strip carries."""
    side = length / cells
    across = max(2, round(width / side))
    cloth = muslin.Cloth.grid(across + 1, cells + extra + 1, (side, width / across), fabric, coarser=0)
    drape = muslin.Drape(cloth, precision=64, settle_residual=residual, settle_seconds=seconds,
                         gravity=(0.0, -gravity, 0.0))
    places = np.zeros((len(drape), 3))
    places[:, 0], places[:, 2] = cloth.rest[:, 0] - extra * side, cloth.rest[:, 1]
    return cloth, drape, places


def settle(drape):
    """Whether the drape came to rest."""
    try:
        drape.settle()
    except muslin.MuslinError as error:
        if error.name != "MUS_ERR_UNSETTLED":
            raise
        return False
    return True


def turned(values):
    """Stretch and contraction of the fabric turned by a quarter: its warp is then the weft of a grid, which is x."""
    warp, weft = values["stretch"]
    return {"stretch": (weft, warp), "contraction": values["contraction"] * weft / warp}


def bending(fabric, cells=16):
    """(rigidity [N m] that Peirce's cantilever gives, at rest): a strip of twice its bending length, held at two rows
    of nodes, without the friction, which KES reads apart from B."""
    values = fabric.values()
    weight = values["weight"] * cusick.GRAVITY
    plain = muslin.Fabric(**{**values, "bend_hysteresis": 0.0, "damping": 0.0})
    length = 2.0 * (values["bend"][1] / weight) ** (1 / 3)
    _, drape, places = sheet(plain, WIDTH, length, cells, extra=1, residual=2e-3, gravity=cusick.GRAVITY)
    drape.set_state(places)
    for node in np.flatnonzero(places[:, 0] < 1e-9):
        drape.pin(int(node))
    rest = settle(drape)
    tip = np.array(drape.positions)[places[:, 0] > length - 1e-9].mean(0)
    slope = math.atan2(-tip[1], tip[0])
    return weight * length ** 3 * math.cos(0.5 * slope) / (8.0 * math.tan(slope)), rest


def tensile(fabric, cells=10):
    """(strain at 490 N/m of KES-FB1's wide piece, along the stiffer way of the fabric, at rest)."""
    values = fabric.values()
    stretch = values["stretch"]
    along = muslin.Fabric(**{**values, **turned(values), "damping": 0.0})
    _, drape, places = sheet(along, TENSILE[0], TENSILE[1], cells, residual=10.0)
    far = places[:, 0] > TENSILE[1] - 1e-9
    strain = LOAD / stretch[0]
    places[:, 0] *= 1.0 + strain
    drape.set_state(places)
    for node in np.flatnonzero(far | (places[:, 0] < 1e-9)):
        drape.pin(int(node))
    rest = settle(drape)
    return strain * LOAD / abs(np.array(drape.forces)[far, 0].sum() / TENSILE[0]), rest


def contraction(fabric, cells=40):
    """(lateral over longitudinal strain in the middle of a strip that is pulled along its warp, at rest)."""
    values = fabric.values()
    along = muslin.Fabric(**{**values, **turned(values), "damping": 0.0})
    cloth, drape, places = sheet(along, PULLED[0], PULLED[1], cells)
    far = places[:, 0] > PULLED[1] - 1e-9
    flat = places.copy()
    places[:, 0] *= 1.0 + STRAIN
    drape.set_state(places)
    for node in np.flatnonzero(far | (flat[:, 0] < 1e-9)):
        drape.pin(int(node))
    rest = settle(drape)
    middle = np.abs(flat[:, 0] - 0.5 * PULLED[1]) < 0.26 * PULLED[1]
    now = np.array(drape.positions)
    low, high = middle & (flat[:, 2] < 1e-9), middle & (flat[:, 2] > PULLED[0] - 1e-9)
    wide = now[high, 2].mean() - now[low, 2].mean()
    columns = np.sort(now[low, 0])
    uncut = np.sort(flat[low, 0])
    pulled = (columns[-1] - columns[0]) / (uncut[-1] - uncut[0]) - 1.0
    return (1.0 - wide / PULLED[0]) / pulled, rest
