"""newton.py: cloth at rest by another method: Newton's, with the true stiffness, and what it says of a shape.

It shares with settle the forces (mus_drape_forces, in double) and nothing else: no time, no mass, no damping. The
stiffness is their derivative, by central differences of all nodes of a colour at once, where no two of a colour reach
the same node. Its Cholesky factors (banded, reverse Cuthill-McKee) exist only where every small motion costs energy; a
shift is added until they do. A step is cut by halves until the energy falls, and at its rounding until forces do.

A shape whose forces vanish and whose stiffness has factors without a shift is a rest shape in its own right: the
energy has a minimum there. Nodes on a body are held where they stick, which is judged at the end: the skin must push,
and friction must suffice. A node that is pulled off is let go; one that friction cannot hold slides, in its tangent
plane, against the friction that its push allows; a free one that has come under the skin is put on it.
"""
import time

import numpy as np
import scipy.linalg
import scipy.sparse as sparse
from scipy.sparse import csgraph
from scipy.spatial import cKDTree

STEP = 2e-7       # of differences [m]
TIGHT = 1e-6      # of a node's weight
SPARE = 0.9       # of the friction that a push allows is what a sliding node is given, for the push may change
NEAR, REACHED = 2e-5, 5e-5  # of the skin [m]
LIFT = 0.01  # [m] the largest lift of a node beyond the clearance (lib/dress/chord_lift.c)
EARNEST = 0.05    # of a node's weight
REACH = 2.95      # spacings: second differences along diagonals reach 2.83
FREE, STUCK, SLIDING = 0, 1, 2


class Band:
    """A sparse symmetric matrix as a band, and the factors of it and a shift."""

    def __init__(self, matrix):
        self.order = csgraph.reverse_cuthill_mckee(matrix, symmetric_mode=True)
        entries = matrix[self.order][:, self.order].tocoo()
        low = entries.row >= entries.col
        wide = int((entries.row - entries.col).max())
        self.band = np.zeros((wide + 1, matrix.shape[0]))
        self.band[(entries.row - entries.col)[low], entries.col[low]] = entries.data[low]

    def factors(self, shift):
        """(solve, shift): the least of `shift`, and of powers of four above, that leaves the matrix positive."""
        while True:
            shifted = self.band.copy()
            shifted[0] += shift
            try:
                found = scipy.linalg.cholesky_banded(shifted, overwrite_ab=True, lower=True, check_finite=False)
                break
            except scipy.linalg.LinAlgError:
                shift = max(4 * shift, 1e-4)

        def solve(right):
            out = np.empty_like(right)
            out[self.order] = scipy.linalg.cho_solve_banded((found, True), right[self.order], check_finite=False)
            return out

        return solve, shift


class Statics:
    """A drape in double and its cloth; `pins` are nodes that it holds."""

    def __init__(self, drape, cloth, pins=(), body=None, clearance=0.002, friction=0.0, gravity=9.81):
        self.drape, self.body, self.clearance, self.friction = drape, body, clearance, friction
        # what is welded is one node
        pairs = np.asarray(cloth.pairs) if drape.report["welded"] else np.zeros((0, 2), int)
        n = len(drape)
        joined = sparse.coo_matrix((np.ones(len(pairs)), (pairs[:, 0], pairs[:, 1])) if len(pairs) else (n, n), (n, n))
        self.count, self.node = csgraph.connected_components(joined, directed=False)
        self.first = np.full(self.count, n)
        np.minimum.at(self.first, self.node, np.arange(n))
        self.weight = gravity * np.bincount(self.node, np.asarray(cloth.masses), self.count)
        self.state = np.full(self.count, FREE)
        self.normal = np.zeros((self.count, 3))
        self.rub = np.zeros((self.count, 3))
        self.steps, self.rounds, self.softest, self.rms, self.lifted = 0, 0, 0.0, 0.0, 0
        self.pinned = np.zeros(self.count, bool)
        self.pinned[self.node[list(pins)]] = True
        self.support = self._support(cloth)
        self.colours = self._colours()

    # ---- which node reaches which ----

    def _support(self, cloth):
        """Nodes (both ways) whose force a node may change: near ones of its panel, and across a triangle's edge."""
        rest, panel = np.asarray(cloth.rest), np.asarray(cloth.node_panels)
        apart = np.column_stack([rest, 1e3 * panel])
        near = cKDTree(apart).query_pairs(REACH * cloth.spacing, output_type="ndarray")
        near = self._graph(near[:, 0], near[:, 1])
        corner = np.asarray(cloth.triangles)
        if len(corner) == 0:
            return near
        edge = self._graph(corner.reshape(-1), np.roll(corner, 1, axis=1).reshape(-1))
        return ((near + edge @ edge) != 0).tocsr()

    def _graph(self, a, b):
        a, b = self.node[a], self.node[b]
        all_a, all_b = np.concatenate([a, b, np.arange(self.count)]), np.concatenate([b, a, np.arange(self.count)])
        return (sparse.coo_matrix((np.ones(len(all_a)), (all_a, all_b)), (self.count,) * 2).tocsr() != 0).astype(float)

    def _colours(self):
        """[(rows, columns)] of the entries of the stiffness that a colour finds."""
        reach = self.support.astype(float)
        clash = (reach @ reach).tocsr()
        colour = np.full(self.count, -1)
        for i in range(self.count):
            taken = set(colour[clash.indices[clash.indptr[i]:clash.indptr[i + 1]]])
            mine = 0
            while mine in taken:
                mine += 1
            colour[i] = mine
        entries = self.support.tocoo()
        by = colour[entries.col]
        return [(entries.row[by == c], entries.col[by == c]) for c in range(colour.max() + 1)]

    # ---- forces ----

    def force(self, x):
        """On the nodes (count x 3) [N], friction of sliding ones too."""
        self.drape.set_state(x[self.node])
        return self.drape.forces[self.first] + self.rub

    def energy(self, x):
        """[J]; after force(x)."""
        return self.drape.report["energy"] - float((self.rub * x).sum())

    def stiffness(self, x):
        """Minus the derivative of the forces: symmetric, (3 count x 3 count)."""
        rows, columns, values = [], [], []
        for i, j in self.colours:
            for d in range(3):
                moved = np.array(x)
                moved[np.unique(j), d] += STEP
                change = self.force(moved)
                moved[np.unique(j), d] -= 2 * STEP
                change -= self.force(moved)
                for k in range(3):
                    rows.append(3 * i + k)
                    columns.append(3 * j + d)
                    values.append(-change[i, k] / (2 * STEP))
        shape = (3 * self.count,) * 2
        matrix = sparse.coo_matrix((np.concatenate(values), (np.concatenate(rows), np.concatenate(columns))), shape)
        return 0.5 * (matrix + matrix.T).tocsr()

    # ---- Newton ----

    def basis(self):
        """(3 count x unknowns): free nodes have three, sliding ones two in their tangent plane."""
        rows, columns, values, at = [], [], [], 0
        for i in np.flatnonzero(~self.pinned & (self.state != STUCK)):
            if self.state[i] == FREE:
                axes = np.eye(3)
            else:
                axes = np.linalg.svd(self.normal[i][None])[2][1:]
            for axis in axes:
                rows.extend(range(3 * i, 3 * i + 3))
                columns.extend([at] * 3)
                values.extend(axis)
                at += 1
        return sparse.coo_matrix((values, (rows, columns)), (3 * self.count, at)).tocsr()

    def left(self, force, basis):
        """Greatest and rms force that is left, over the node's weight."""
        over = (basis @ (basis.T @ force.reshape(-1))).reshape(-1, 3) / self.weight[:, None]
        size = np.linalg.norm(over, axis=1)
        return float(size.max()), float(np.sqrt(np.mean(size ** 2)))

    def descend(self, x, prove=True, most=80):
        """x at rest with what is held. Steps are counted; to prove that x is a minimum the softest motion [N/m] is
        noted: not above 0 where the stiffness there has no factors."""
        basis, shift = self.basis(), 0.0
        f = self.force(x)
        energy, left = self.energy(x), self.left(f, basis)
        for _ in range(most):
            if not prove and left[0] <= TIGHT and shift == 0.0:
                return x
            solve, shift = Band((basis.T @ self.stiffness(x) @ basis).tocsr()).factors(shift)
            if left[0] <= TIGHT and shift == 0.0:
                break
            way = (basis @ solve(basis.T @ f.reshape(-1))).reshape(-1, 3)
            x, f, energy, left, share = self.search(x, way, f, energy, left, basis)
            self.steps += 1
            shift = shift if share < 1.0 else shift / 8 if shift > 1e-3 else 0.0
        self.softest = softest(solve, basis.shape[1]) if shift == 0.0 else -shift
        self.rms = left[1]
        return x

    def search(self, x, way, f, energy, left, basis):
        """The first of the whole way and its halves where the energy falls, or forces do at the energy's rounding."""
        gain, share = float((f * way).sum()), min(1.0, 0.02 / np.abs(way).max())
        for _ in range(30):
            new = x + share * way
            f_new = self.force(new)
            e_new, left_new = self.energy(new), self.left(f_new, basis)
            if e_new <= energy - 1e-4 * share * gain:
                break
            if abs(e_new - energy) <= 1e-12 * abs(energy) and left_new[1] < left[1]:
                break
            share *= 0.5
        return new, f_new, e_new, left_new, share

    def skin(self, points):
        """(depth, outward normals) of points (n x 3), as contact has them."""
        depth, normal = self.drape.depth(np.ascontiguousarray(points, float))
        return np.array(depth), np.array(normal)

    # ---- on a body ----

    def touch(self, x):
        """Nodes that the skin pushes stick: those that lie on it, and those a little off that are pushed in earnest."""
        depth, self.normal = self.skin(x)
        push = -(self.force(x) * self.normal).sum(axis=1) / self.weight
        gap = -depth - self.clearance
        held = ((gap < NEAR) & (push > 0.0) | (gap < REACHED) & (push > EARNEST)) & ~self.pinned
        self.state[:] = np.where(held, STUCK, FREE)
        self.rub[:] = 0.0

    def judge(self, x):
        """Change how nodes are held where they cannot be so; (x, how many were let go, slid, were put on the skin)."""
        bare = self.force(x) - self.rub
        depth, normal = self.skin(x)
        stuck, sliding = self.state == STUCK, self.state == SLIDING
        self.normal[stuck] = normal[stuck]
        push = -(bare * self.normal).sum(axis=1)
        along = bare + push[:, None] * self.normal
        pull, grip, much = np.linalg.norm(along, axis=1), self.friction * push, TIGHT * self.weight
        off = (stuck | sliding) & (push < -much)
        slid = ~off & (stuck & (pull > grip + much) | sliding & (np.linalg.norm(self.rub, axis=1) > grip + much))
        under = (self.state == FREE) & ~self.pinned & (depth > -self.clearance + REACHED)
        self.state[off], self.state[slid], self.state[under] = FREE, SLIDING, STUCK
        self.rub[off] = 0.0
        self.rub[slid] = -along[slid] * (SPARE * np.maximum(grip[slid], 0.0) / pull[slid])[:, None]
        x = np.array(x)
        x[under] += (depth + self.clearance)[under, None] * normal[under]
        return x, (int(off.sum()), int(slid.sum()), int(under.sum()))

    def settle(self, x, most=60):
        """x at rest on the body: what is pushed against it at first is held, and judged when the rest lies still. Nodes
        that the library lifted off the skin, for their triangles to be off it, lie on their lift."""
        depth, normal = self.skin(x)
        push = -(self.force(x) * normal).sum(axis=1) / self.weight
        lifted = (-depth > self.clearance) & (-depth < self.clearance + LIFT) & (push > EARNEST)
        self.clearance = np.where(lifted, -depth, self.clearance)
        self.lifted = int(lifted.sum())
        self.touch(x)
        for _ in range(most):
            x, changed = self.judge(self.descend(x, prove=False))
            self.rounds += 1
            if not any(changed):
                break
        return self.descend(x)


def softest(solve, n, rounds=30):
    """The least eigenvalue of a matrix whose inverse is `solve`, by inverse iteration."""
    v = np.random.default_rng(0).normal(size=n)
    for _ in range(rounds):
        v /= np.linalg.norm(v)
        w = solve(v)
        v, least = w, 1.0 / float(v @ w)
    return least


def rest(drape, cloth, start, **held):
    """(places, columns) of the shape at rest that `start` (nodes x 3) comes to. `value` is the residual that the
    library finds there, or where nodes are lifted, which places alone do not tell it, that of Newton; error_mm how far
    the farthest node went."""
    statics = Statics(drape, cloth, **held)
    begin = time.process_time()
    x = np.array(start, float)[statics.first]
    x = statics.settle(x) if statics.body is not None else statics.descend(x)
    took = time.process_time() - begin
    places = x[statics.node]
    drape.set_state(places)
    report, count = drape.report, np.bincount(statics.state, minlength=3)
    moved = 1e3 * np.linalg.norm(places - start, axis=1)
    value = statics.rms if statics.lifted else report["residual"]
    skin = f", {count[STUCK]} nodes stick and {count[SLIDING]} slid, judged {statics.rounds} times" if count[1:].any() \
        else ""
    return places, {"status": "ok" if statics.softest > 0.0 else "saddle", "cpu_s": took, "value": value,
                    "exact": 0.0, "steps": statics.steps, "error_mm": float(moved.max()),
                    "error_rms_mm": float(np.sqrt(np.mean(moved ** 2))),
                    "note": f"{statics.steps} steps of Newton; residual {value:.1e} of a weight; every "
                            f"motion costs energy, the softest {statics.softest:.1e} N/m{skin}; energy "
                            f"{report['energy']:.9g} J; the farthest node went {moved.max():.2g} mm"}
