"""sewing.py: the paper's own trade (4.3): sewing time and the gap that is left, against the collision distance.

A pair of nodes of a seam that is within the collision distance is stitched, and moves as one from then on; when all
are, they are welded, and no gap is left. The gap that was still open is shown by a second run, stopped one look (64
steps) before the end: the widest of its pairs. On coarser cuts first, the finest cut is welded where it is put down.
"""
import numpy as np

import garment
import measure

LOOK = 64  # steps of sewing between two looks at the seams


def trade(distances=(0.0005, 0.001, 0.002, 0.005, 0.01), spacing=0.01, design="tshirt"):
    rows = []
    for coarser in (0, 1):
        first = None
        for distance in distances:
            drape, cloth, _ = garment.dressed(design, spacing, coarser=coarser, collision_distance=distance,
                                              settle_seconds=6.0)
            before = drape.report
            found = garment.settle(drape, "sew")
            report, counted = drape.report, measure.counts(drape, before, "euler")
            after = 1e3 * float(np.max(drape.gaps(cloth)))
            last = None if coarser else gap_before(design, spacing, distance, report)
            common = dict(scene=design, error="sewing", precision=32, contact="on", threads=1, nodes=len(drape),
                          variant="coarser cuts first" if coarser else "one cut", spacing_mm=1e3 * spacing)
            rows.append(measure.row(**common, quantity="gap that welding closes", value=1e3 * distance, exact=after,
                                    error_mm=last, step_s=report["step"], **found, **counted))
            rows[-1]["note"] = f"gap after it {after:.2g} mm; largest strain then {100 * report['max_strain']:.0f} %"
            settled = garment.settle(drape)
            places = np.array(drape.positions)
            first = places if first is None else first
            rows.append(measure.row(**common, quantity="shape at rest against the smallest distance",
                                    value=1e3 * distance, **settled, **measure.distance(places[None], first[None])))
    return rows


def gap_before(design, spacing, distance, report):
    """Widest pair one look before the end of a run on one cut [mm]."""
    drape, cloth, _ = garment.dressed(design, spacing, coarser=0, collision_distance=distance,
                                      sew_seconds=report["sew_time"] - 1.5 * LOOK * report["step"])
    garment.settle(drape, "sew")
    return 1e3 * float(np.max(drape.gaps(cloth)))
