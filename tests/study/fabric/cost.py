"""cost.py: what friction of bending, contraction and clamps cost a node and step, measured in turn in one run."""
import time

import numpy as np

import muslin

SIDE, STEPS, ROUNDS = 64, 400, 5


def sheet(loop=0.0, held=1, contraction=0.0):
    """A square sheet of broadcloth, `loop` its 2HB; its first two rows held, or its first alone."""
    fabric = muslin.Fabric("broadcloth", damping=0.0, bend_hysteresis=loop, contraction=contraction)
    cloth = muslin.Cloth.grid(SIDE, SIDE, (0.005, 0.005), fabric, coarser=0)
    drape = muslin.Drape(cloth, integrator=muslin._abi.MUS_METHOD_VERLET)
    places = np.zeros((len(drape), 3))
    places[:, 0], places[:, 2] = cloth.rest[:, 0], cloth.rest[:, 1]
    drape.set_state(places)
    for node in range(held * SIDE):
        drape.pin(node)
    return drape


def rows():
    """[(what, ns a node and step)], the least of the rounds of each."""
    drapes = {"none of them": sheet(), "clamp of 64 nodes": sheet(held=2), "friction of bending": sheet(1.216e-3),
              "contraction": sheet(contraction=0.24), "contraction that the springs have": sheet(contraction=1e-3)}
    step = 0.5 * min(drape.step_bound for drape in drapes.values())
    least = dict.fromkeys(drapes, float("inf"))
    for _ in range(ROUNDS):
        for name, drape in drapes.items():
            start = time.process_time()
            drape.step(STEPS, step)
            least[name] = min(least[name], (time.process_time() - start) / (STEPS * len(drape)))
    return [(name, 1e9 * seconds) for name, seconds in least.items()]
