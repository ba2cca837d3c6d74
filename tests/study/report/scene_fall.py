"""scene_fall.py: a square of jersey, held at two corners and let go level: it falls, swings and folds.

The motion is chaotic: two runs that differ in anything part. Nothing damps it, so that its energy stays, and only
energy and means over time say something of a step after the runs have parted.
"""
import numpy as np

import model
import muslin
import runs

SIDE, NODES, INTERVAL, SAMPLES = 0.24, 13, 4e-3, 50


def trial(fabric="jersey", nodes=NODES):
    values = muslin.Fabric(fabric).values()
    plain = {name: values[name] for name in ("weight", "stretch", "shear", "bend")}
    held = np.zeros(nodes * nodes, bool)
    held[[0, nodes - 1]] = True
    cell = (SIDE / (nodes - 1),) * 2
    lattice = model.Lattice(nodes, nodes, cell, plain, held, (0.0, -9.81, 0.0))
    places = np.zeros((nodes * nodes, 3))
    places[:, [0, 2]] = lattice.rest.reshape(-1, 3)[:, :2]
    return runs.Trial("fall", lattice, cell, plain, (places, np.zeros_like(places)), INTERVAL, SAMPLES,
                      (0.0, -9.81, 0.0))
