"""model.py: the same physics written a second time, in numpy, from the formulas: what the library is held against.

Lattice: springs and second differences of a rectangle of cloth. With a along a line and b across it, C11 and G of the
fabric, B its rigidities, every constant is that of an interior cell, half on the border (a line carries all of C11
where the rectangle is one node wide):

    line  k = C11 b / a - G a / b,   diagonal k_d = G (a^2 + b^2) / (2 a b),   mass  sigma a b
    bending  E = K / 2 |x- - 2 x0 + x+|^2,  K = (B - beta a^2 / (2 b^2)) b / a^3 on lines,  beta / (4 a b) on diagonals,
    beta = (4 B_bias - B_warp - B_weft) / 3

and exact answers: a strip that bobs, the heavy elastica, a stretched membrane.
"""
import numpy as np


def _share(n):
    share = np.ones(n)
    if n > 1:
        share[[0, -1]] = 0.5
    return share


class Lattice:
    """Nodes (rows x columns x 3) of a grid cloth with held nodes, in a field of gravity."""

    def __init__(self, rows, columns, cell, fabric, held, gravity=(0.0, 0.0, 0.0)):
        (dx, dy), stretch, shear, bend = cell, fabric["stretch"], fabric["shear"], fabric["bend"]
        beta = max(0.0, (4 * bend[2] - bend[0] - bend[1]) / 3)
        row, column = _share(rows)[:, None], _share(columns)[None, :]
        self.rest = np.zeros((rows, columns, 3))
        self.rest[..., 0], self.rest[..., 1] = np.arange(columns)[None, :] * dx, np.arange(rows)[:, None] * dy
        self.mass = fabric["weight"] * dx * dy * row * column
        self.free = ~held.reshape(rows, columns, 1)
        self.gravity = np.asarray(gravity)
        narrow = rows == 1 or columns == 1
        g = 0.0 if narrow else shear
        warp = (stretch[0] * dx / dy - g * dy / dx) * column * np.ones((rows - 1, 1))
        weft = (stretch[1] * dy / dx - g * dx / dy) * row * np.ones((1, columns - 1))
        slant = g * (dx * dx + dy * dy) / (2 * dx * dy) * np.ones((rows - 1, columns - 1))
        diagonal = float(np.hypot(dx, dy))
        # each spring family: (from, to) as slices of the node array, stiffness, length
        low, high, every = slice(None, -1), slice(1, None), slice(None)
        self.springs = [((low, every), (high, every), warp, dy), ((every, low), (every, high), weft, dx),
                        ((low, low), (high, high), slant, diagonal), ((low, high), (high, low), slant, diagonal)]
        self.springs = [s for s in self.springs if s[2].size and s[2].any()]
        flat = 0.0 if narrow else beta
        k_warp = (bend[0] - flat * dy * dy / (2 * dx * dx)) * dx / dy ** 3
        k_weft = (bend[1] - flat * dx * dx / (2 * dy * dy)) * dy / dx ** 3
        cross = flat / (4 * dx * dy)
        first, middle, last = slice(None, -2), slice(1, -1), slice(2, None)
        self.bends = [((first, every), (middle, every), (last, every), k_warp * column),
                      ((every, first), (every, middle), (every, last), k_weft * row),
                      ((first, first), (middle, middle), (last, last), cross * np.ones((1, 1))),
                      ((first, last), (middle, middle), (last, first), cross * np.ones((1, 1)))]
        self.bends = [b for b in self.bends if b[3].any() and self.rest[b[1]].size]

    def acceleration(self, x):
        """Of places (rows x columns x 3), in their own precision."""
        force = np.zeros_like(x)
        for a, b, k, length in self.springs:
            along = x[b] - x[a]
            strain = 1 - x.dtype.type(length) / np.sqrt((along * along).sum(-1))
            pull = (k.astype(x.dtype) * strain)[..., None] * along
            force[a] += pull
            force[b] -= pull
        for a, b, c, k in self.bends:
            curl = k.astype(x.dtype)[..., None] * (x[a] - 2 * x[b] + x[c])
            force[a] -= curl
            force[b] += 2 * curl
            force[c] -= curl
        return (force / self.mass.astype(x.dtype)[..., None] + self.gravity.astype(x.dtype)) * self.free

    def energy(self, x, v):
        """Kinetic, elastic and of gravity [J]."""
        mass = self.mass[..., None]
        total = 0.5 * float((mass * v * v).sum()) - float((mass * self.gravity * x).sum())
        for a, b, k, length in self.springs:
            total += 0.5 * float((k * (np.linalg.norm(x[b] - x[a], axis=-1) - length) ** 2).sum())
        for a, b, c, k in self.bends:
            total += 0.5 * float((k[..., None] * (x[a] - 2 * x[b] + x[c]) ** 2).sum())
        return total

    def path(self, x, v, h, steps, samples):
        """Places (samples x nodes x 3) by classical Runge-Kutta, `steps` steps of h between samples."""
        shape = self.rest.shape
        x, v = np.array(x, float).reshape(shape), np.array(v, float).reshape(shape)
        out = np.empty((samples, x.shape[0] * x.shape[1], 3))
        for i in range(samples):
            for _ in range(steps):
                a1 = self.acceleration(x)
                a2 = self.acceleration(x + 0.5 * h * v)
                a3 = self.acceleration(x + 0.5 * h * v + 0.25 * h * h * a1)
                a4 = self.acceleration(x + h * v + 0.5 * h * h * a2)
                x = x + h * v + h * h / 6 * (a1 + a2 + a3)
                v = v + h / 6 * (a1 + 2 * a2 + 2 * a3 + a4)
            out[i] = x.reshape(-1, 3)
        return out


# ---- exact answers ----

def strip_at_rest(n, length, weight, stretch, g=9.81):
    """Depth below the held end of nodes 0 (held) .. n of a hanging strip: s + w (L s - s^2 / 2) / Y, for every n."""
    s = np.linspace(0.0, length, n + 1)
    return s + weight * g * (length * s - 0.5 * s * s) / stretch


def strip_mode(n, length, weight, stretch, order=1):
    """(shape, angular frequency) of a bobbing strip with half a mass at its free end: exact for the discrete chain."""
    q = (2 * order - 1) * np.pi / 2
    a = length / n
    return np.sin(q * np.linspace(0.0, 1.0, n + 1)), 2 * np.sqrt(stretch / weight) / a * np.sin(q / (2 * n))


def strip_frequency(length, weight, stretch, order=1):
    """Of the strip itself, without a mesh."""
    return (2 * order - 1) * np.pi / (2 * length) * np.sqrt(stretch / weight)


def membrane_frequency(n, rest_cell, cell, weight, stretch, shear):
    """Angular frequency of mode (1, 1) of a square of n x n cells stretched from rest_cell to cell, held at all edges:
    w^2 = 4 (K (1 - cos q) + D (1 - cos^2 q)) / m, q = pi / n, K and D the springs' transverse stiffness."""
    slack = 1 - rest_cell / cell
    line, slant, c = (stretch - shear) * slack, shear * slack, np.cos(np.pi / n)
    return np.sqrt(4 * (line * (1 - c) + slant * (1 - c * c)) / (weight * rest_cell ** 2))


def membrane_limit(side, strain, weight, stretch, shear):
    """The same without a mesh: w^2 = 2 pi^2 (K + 2 D) / (sigma L0^2), L0 the side before stretching."""
    slack = 1 - 1 / (1 + strain)
    return np.sqrt(2 * np.pi ** 2 * (stretch - shear + 2 * shear) * slack / weight) / (side / (1 + strain))


def elastica(gamma, points=4000):
    """(x, y) of the tip of a heavy cantilever, over its length; clamped level: theta'' = -Gamma (1 - s) cos theta,
    theta(0) = 0, theta'(1) = 0, shot from the tip by Runge-Kutta until the clamp is level (y counts downwards)."""
    def shoot(tip):
        h, state = -1.0 / points, np.array([tip, 0.0, 0.0, 0.0])

        def rate(s, u):
            return np.array([u[1], -gamma * (1 - s) * np.cos(u[0]), np.cos(u[0]), np.sin(u[0])])

        for i in range(points):
            s = 1 + i * h
            k1 = rate(s, state)
            k2 = rate(s + h / 2, state + h / 2 * k1)
            k3 = rate(s + h / 2, state + h / 2 * k2)
            k4 = rate(s + h, state + h * k3)
            state = state + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
        return state

    low, high = 0.0, np.pi / 2
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if shoot(middle)[0] < 0 else (low, middle)
    end = shoot(0.5 * (low + high))
    return -end[2], -end[3]
