"""cusick.py: the drape coefficient of a fabric as BS 5058 and ISO 9073-9 measure it: a disc of 30 cm on one of 18 cm.

The mesh fits both circles: the part on the support is one panel, the ring around it two halves, sewn together. The
cloth is held on the support, between its two plates, and level at its edge. The weight comes on in steps, as the
plate that carries the ring is lowered: let go at once the cloth would swing, and friction between threads would hold it
lower. The coefficient is the part of the ring that the shadow of the cloth still covers.
"""
import math
import pathlib
import sys

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "bindings" / "python"))

import muslin  # noqa: E402
from muslin import _abi  # noqa: E402

DISC, SUPPORT = 0.15, 0.09  # radii [m]
GRAVITY, LOADS = 9.81, (0.25, 0.5, 0.75, 1.0)
RAYS = 3600


def _arc(pattern, panel, radius, start, over):
    """Points and edge of a half circle from angle `start` over (0, over * radius)."""
    ends = [pattern.add_point(panel, s * radius, 0.0) for s in ((1.0, -1.0) if start == 0 else (-1.0, 1.0))]
    return ends, pattern.add_edge(*ends, ("arc",), [(0.0, over * radius)])


def pattern():
    """The disc, level: a panel on the support and two half rings."""
    disc = muslin.Pattern("disc")
    support = disc.add_panel("support")
    right, left = disc.add_point(support, SUPPORT, 0.0), disc.add_point(support, -SUPPORT, 0.0)
    edges = [disc.add_edge(right, left, ("arc",), [(0.0, SUPPORT)]),
             disc.add_edge(left, right, ("arc",), [(0.0, -SUPPORT)])]
    disc.set_outline(support, edges)
    panels, cuts = [support], []
    for half in range(2):
        ring = disc.add_panel(f"ring {half + 1}")
        over = 1.0 if half == 0 else -1.0
        outer, rim = _arc(disc, ring, DISC, half, over)
        inner, edge = _arc(disc, ring, SUPPORT, half, over)
        cuts.append([disc.add_edge(i, o) for i, o in zip(inner, outer)])
        disc.set_outline(ring, [cuts[half][0], rim, cuts[half][1], edge], [1, 1, -1, -1])
        disc.add_seam(edges[half], edge, direction=_abi.MUS_SEAM_DIRECT)
        panels.append(ring)
    for k in range(2):
        disc.add_seam(cuts[0][k], cuts[1][1 - k], direction=_abi.MUS_SEAM_DIRECT)
    for panel in panels:
        disc.set_placement(panel, rotation=(1, 0, 0, 0, 0, 1, 0, -1, 0))
    return disc


def cut(spacing, fabric):
    return muslin.Cloth(pattern(), fabric, spacing=spacing, coarser=0)


def lay(cloth, start=0, residual=0.005, seconds=6.0, **options):
    """Sewn, held on the support, the ring level but for a wave of a millimetre: of 6 folds, or (start > 0) a sum of 2
    to 11 folds with sizes and phases of that seed."""
    drape = muslin.Drape(cloth, settle_residual=residual, settle_seconds=seconds, gravity=(0.0, 0.0, 0.0), **options)
    drape.place()
    level = np.array(drape.positions)
    drape.sew()
    r = np.hypot(cloth.rest[:, 0], cloth.rest[:, 1])
    angle = np.arctan2(level[:, 2], level[:, 0])
    s = np.maximum(0.0, (r - SUPPORT) / (DISC - SUPPORT))
    wave = np.cos(6 * angle)  # as in muslin verify
    if start:
        folds, random = np.arange(2, 12), np.random.default_rng(start)
        size, phase = random.normal(size=len(folds)), 2 * np.pi * random.random(len(folds))
        wave = (size * np.cos(np.outer(angle, folds) + phase)).sum(1) / math.sqrt(len(folds))
    level[:, 1] += 1e-3 * s * s * wave
    drape.set_state(level)
    for node in np.flatnonzero(r <= SUPPORT + 1e-6):
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
    first, wide = np.arctan2(a[:, 1], a[:, 0]), np.arctan2(np.abs(cross), (a * b).sum(1))
    unit = 2 * np.pi / RAYS
    reach = np.zeros(RAYS)
    for i in range(len(a)):
        k = np.arange(np.ceil(first[i] / unit), np.floor((first[i] + wide[i]) / unit) + 1)
        along = (b[i, 0] - a[i, 0]) * np.sin(k * unit) - (b[i, 1] - a[i, 1]) * np.cos(k * unit)
        far = np.where(np.abs(along) > 1e-15, np.abs(cross[i] / np.where(along == 0, 1, along)), 0.0)
        np.maximum.at(reach, k.astype(int) % RAYS, far)
    area, support = 0.5 * unit * (reach ** 2).sum(), np.pi * SUPPORT ** 2
    return 100 * (area - support) / (np.pi * DISC ** 2 - support)


def measure(fabric, spacing, start=0, **options):
    """(drape coefficient [%], whether it was at rest) of a muslin.Fabric."""
    cloth = cut(spacing, fabric)
    drape = lay(cloth, start, **options)
    rest = True
    for load in LOADS:
        drape.set_gravity((0.0, -load * GRAVITY, 0.0))
        try:
            drape.settle()
        except muslin.MuslinError as error:
            if error.name != "MUS_ERR_UNSETTLED":
                raise
            rest = False
    return coefficient(np.array(drape.positions), np.array(cloth.triangles)), rest
