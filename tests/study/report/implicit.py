"""implicit.py: implicit steps on the springs of model.py, the competitor of the library's explicit ones.

One step solves M (v1 - v0) = h f and x1 - x0 = h v with f and v at the end (backward Euler, order 1) or in the middle
of the step (midpoint, order 2): Newton's method with the true stiffness, sparse, its factors by SuperLU (scipy). The
seconds are those of numpy and scipy: the factors are compiled code, what stands around them is not, so that the seconds
of the factors are told apart.
"""
import time

import numpy as np
import scipy.sparse as sparse
import scipy.sparse.linalg as linalg

import measure

METHODS = {"implicit Euler": 1.0, "implicit midpoint": 0.5}  # where in the step the forces are taken
TIGHT, MOST = 1e-9, 30  # of a Newton's step [m]; rounds, then the step counts as failed


class Stiffness:
    """Minus the derivative of the forces of a lattice (3n x 3n), of free nodes alone."""

    def __init__(self, lattice):
        self.lattice, self.shape = lattice, lattice.rest.shape
        count = self.shape[0] * self.shape[1]
        node = np.arange(count).reshape(self.shape[:2])
        self.springs = [(node[a].reshape(-1), node[b].reshape(-1), np.broadcast_to(k, node[a].shape).reshape(-1),
                         length) for a, b, k, length in lattice.springs]
        held = sparse.csr_matrix((3 * count, 3 * count))
        for a, b, c, k in lattice.bends:
            held = held + self._stencil(node, (a, b, c), np.broadcast_to(k, node[b].shape).reshape(-1), count)
        self.bends, self.count = held, count
        self.free = np.repeat(lattice.free.reshape(-1), 3)

    @staticmethod
    def _stencil(node, slices, k, count):
        """Of k / 2 |x- - 2 x0 + x+|^2: constant."""
        rows, columns, values = [], [], []
        for one, weight in zip(slices, (1.0, -2.0, 1.0)):
            for other, by in zip(slices, (1.0, -2.0, 1.0)):
                for d in range(3):
                    rows.append(3 * node[one].reshape(-1) + d)
                    columns.append(3 * node[other].reshape(-1) + d)
                    values.append(k * weight * by)
        return sparse.coo_matrix((np.concatenate(values), (np.concatenate(rows), np.concatenate(columns))),
                                 (3 * count, 3 * count)).tocsr()

    def at(self, x):
        flat = x.reshape(-1, 3)
        rows, columns, values = [], [], []
        for i, j, k, length in self.springs:
            along = flat[j] - flat[i]
            size = np.linalg.norm(along, axis=1)
            unit = along / size[:, None]
            block = (k * (1 - length / size))[:, None, None] * np.eye(3) \
                + (k * length / size)[:, None, None] * unit[:, :, None] * unit[:, None, :]
            for first, second, sign in ((i, i, 1), (j, j, 1), (i, j, -1), (j, i, -1)):
                for p in range(3):
                    for q in range(3):
                        rows.append(3 * first + p)
                        columns.append(3 * second + q)
                        values.append(sign * block[:, p, q])
        stretch = sparse.coo_matrix((np.concatenate(values), (np.concatenate(rows), np.concatenate(columns))),
                                    (3 * self.count,) * 2).tocsr()
        return stretch + self.bends


def step(lattice, stiffness, mass, x, v, h, share, spent):
    """(places, speeds) after one step, or None where Newton's method does not come to an end."""
    new = x + h * v * lattice.free
    for _ in range(MOST):
        at = x + share * (new - x)
        push = lattice.acceleration(at) * lattice.mass[..., None]
        # with v1 = v0 + h a and x1 = x0 + h (v0 + share h a): what is left of M (x1 - x0 - h v0) = share h^2 f
        left = (mass * (new - x - h * v).reshape(-1) - share * h * h * push.reshape(-1)) * stiffness.free
        matrix = sparse.diags(mass) + (share * h) ** 2 * stiffness.at(at)
        inner = np.flatnonzero(stiffness.free)
        way, begin = np.zeros(mass.size), time.process_time()
        way[inner] = linalg.splu(matrix[inner][:, inner].tocsc(), permc_spec="MMD_AT_PLUS_A").solve(-left[inner])
        spent["factors"] += time.process_time() - begin
        spent["solves"] += 1
        new = new + way.reshape(x.shape)
        if np.abs(way).max() < TIGHT:
            moved = (new - x) / h
            return new, (2 * moved - v if share == 0.5 else moved) * lattice.free
        if not np.isfinite(new).all():
            break
    return None


def steps(trial, reference, floor, per_sample):
    """Rows of both methods; per_sample: steps between two samples, one row each."""
    lattice, rows = trial.lattice, []
    stiffness, mass = Stiffness(lattice), np.repeat(lattice.mass.reshape(-1), 3)
    bound = trial.drape().step_bound
    for method, share in METHODS.items():
        for count in per_sample:
            h = trial.interval / count
            x, v = (np.array(part, float).reshape(lattice.rest.shape) for part in trial.state)
            path, spent, status = [], {"factors": 0.0, "solves": 0}, "ok"
            begin = time.process_time()
            for _ in range(trial.samples):
                for _ in range(count):
                    found = step(lattice, stiffness, mass, x, v, h, share, spent)
                    if found is None:
                        status = "diverged"
                        break
                    x, v = found
                if status != "ok":
                    break
                path.append(x.reshape(-1, 3))
            cpu = time.process_time() - begin
            line = dict(integrator=method, precision=64, variant="implicit, scipy", step_s=h, step_of_bound=h / bound,
                        floor_mm=floor, status=status, cpu_s=cpu, repeats=1,
                        note=f"{spent['solves']} factors; exact: their seconds a simulated second")
            span = len(path) * trial.interval
            if status == "ok":
                line.update(measure.distance(path, reference), cpu_s_per_s=cpu / span, exact=spent["factors"] / span,
                            steps=len(path) * count)
            rows.append(trial.row(**line))
    return rows
