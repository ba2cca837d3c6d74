/*
 * cloth_room_kernel.h: distances of pairs and how fast drifts close them, MUS_TREE_LANES pairs at once: a part of
 * cloth_kernel.h, with its macros.
 *
 * The same operations in the same order as self_measure() and self_closing() of one pair, without a branch: the same
 * bits. Numbers of four nodes stand plane by plane, x, y, z of the first, then of the next.
 */

#define SELF_LANES MUS_TREE_LANES

/* pairs that are measured together: squared distances, shares of the nodes in the way between the nearest places, and
 * half of how fast they close */
typedef struct MUS_FIELD(self_row) {
    MUS_REAL p[12 * SELF_LANES], w[12 * SELF_LANES]; /* places and drifts */
    MUS_REAL share[4 * SELF_LANES], apart[SELF_LANES], closing[SELF_LANES];
} MUS_FIELD(self_row);


/* as self_triangle(): the regions of corners and edges, the first that holds, else within */
MUS_CLONES
static void MUS_FIELD(self_row_faces)(const MUS_REAL *restrict p, MUS_REAL *restrict share, MUS_REAL *restrict apart)
{
    enum { N = SELF_LANES };
    MUS_ROLLED
    for (int32_t i = 0; i < N; i++) {
        const MUS_REAL *a = p + 3 * N + i, *b = p + 6 * N + i, *c = p + 9 * N + i;
        const MUS_REAL ab0 = b[0] - a[0], ab1 = b[N] - a[N], ab2 = b[2 * N] - a[2 * N];
        const MUS_REAL ac0 = c[0] - a[0], ac1 = c[N] - a[N], ac2 = c[2 * N] - a[2 * N];
        const MUS_REAL ap0 = p[i] - a[0], ap1 = p[N + i] - a[N], ap2 = p[2 * N + i] - a[2 * N];
        const MUS_REAL bb = ab0 * ab0 + ab1 * ab1 + ab2 * ab2, cc = ac0 * ac0 + ac1 * ac1 + ac2 * ac2;
        const MUS_REAL bc = ab0 * ac0 + ab1 * ac1 + ab2 * ac2;
        const MUS_REAL d1 = ab0 * ap0 + ab1 * ap1 + ab2 * ap2, e1 = ac0 * ap0 + ac1 * ap1 + ac2 * ap2;
        const MUS_REAL d3 = d1 - bb, e3 = e1 - bc, d5 = d1 - bc, e5 = e1 - cc;
        const MUS_REAL vc = d1 * e3 - d3 * e1, vb = d5 * e1 - d1 * e5, va = d3 * e5 - d5 * e3;
        const MUS_REAL all = va + vb + vc, f3 = e3 - d3, f5 = d5 - e5;
        const MUS_REAL on_bc = f3 / (f3 + f5), on_ac = e1 / (e1 - e5), on_ab = d1 / (d1 - d3);
        const int32_t in_bc = (va <= 0) & (f3 >= 0) & (f5 >= 0), in_ac = (vb <= 0) & (e1 >= 0) & (e5 <= 0);
        const int32_t in_ab = (vc <= 0) & (d1 >= 0) & (d3 <= 0), at_c = (e5 >= 0) & (d5 <= e5);
        const int32_t at_b = (d3 >= 0) & (e3 <= d3), at_a = (d1 <= 0) & (e1 <= 0);
        MUS_REAL v = vb / all, w = vc / all;
        v = in_bc ? 1 - on_bc : v, w = in_bc ? on_bc : w;
        v = in_ac ? 0 : v, w = in_ac ? on_ac : w;
        v = in_ab ? on_ab : v, w = in_ab ? 0 : w;
        v = at_c ? 0 : v, w = at_c ? 1 : w;
        v = at_b ? 1 : v, w = at_b ? 0 : w;
        v = at_a ? 0 : v, w = at_a ? 0 : w;
        const MUS_REAL r0 = ap0 - v * ab0 - w * ac0, r1 = ap1 - v * ab1 - w * ac1, r2 = ap2 - v * ab2 - w * ac2;
        share[i] = 1, share[N + i] = -(1 - v - w), share[2 * N + i] = -v, share[3 * N + i] = -w;
        apart[i] = (MUS_REAL)MUS_SQRT(r0 * r0 + r1 * r1 + r2 * r2);
    }
}


/* as self_edges() */
MUS_CLONES
static void MUS_FIELD(self_row_edges)(const MUS_REAL *restrict p, MUS_REAL *restrict share, MUS_REAL *restrict apart)
{
    enum { N = SELF_LANES };
    MUS_ROLLED
    for (int32_t i = 0; i < N; i++) {
        const MUS_REAL u0 = p[3 * N + i] - p[i], u1 = p[4 * N + i] - p[N + i], u2 = p[5 * N + i] - p[2 * N + i];
        const MUS_REAL v0 = p[9 * N + i] - p[6 * N + i], v1 = p[10 * N + i] - p[7 * N + i];
        const MUS_REAL v2 = p[11 * N + i] - p[8 * N + i], r0 = p[i] - p[6 * N + i], r1 = p[N + i] - p[7 * N + i];
        const MUS_REAL r2 = p[2 * N + i] - p[8 * N + i];
        const MUS_REAL uu = u0 * u0 + u1 * u1 + u2 * u2, vv = v0 * v0 + v1 * v1 + v2 * v2;
        const MUS_REAL uv = u0 * v0 + u1 * v1 + u2 * v2, ur = u0 * r0 + u1 * r1 + u2 * r2;
        const MUS_REAL vr = v0 * r0 + v1 * r1 + v2 * r2, turn = uu * vv - uv * uv;
        MUS_REAL s = (uv * vr - ur * vv) / (turn > 0 ? turn : 1);
        s = s > 0 ? s : 0, s = s < 1 ? s : 1, s = turn > 0 ? s : 0;
        MUS_REAL t = (uv * s + vr) / (vv > 0 ? vv : 1);
        t = t > 0 ? t : 0, t = t < 1 ? t : 1, t = vv > 0 ? t : 0;
        s = (uv * t - ur) / (uu > 0 ? uu : 1);
        s = s > 0 ? s : 0, s = s < 1 ? s : 1, s = uu > 0 ? s : 0;
        const MUS_REAL q0 = r0 + s * u0 - t * v0, q1 = r1 + s * u1 - t * v1, q2 = r2 + s * u2 - t * v2;
        share[i] = 1 - s, share[N + i] = s, share[2 * N + i] = t - 1, share[3 * N + i] = -t;
        apart[i] = (MUS_REAL)MUS_SQRT(q0 * q0 + q1 * q1 + q2 * q2);
    }
}


/*
 * Half of how fast [m/s] drifts may close the gap of a pair: of two convex things that move straight, no faster than
 * along the direction that parts them now. Rounding may have turned that a little, by which drifts that differ count
 * too; nor is it more than half of how much drifts differ.
 */
MUS_CLONES
static void MUS_FIELD(self_row_closing)(int32_t edges, const MUS_REAL *restrict p, const MUS_REAL *restrict w,
                                        const MUS_REAL *restrict share, const MUS_REAL *restrict apart,
                                        MUS_REAL *restrict closing)
{
    enum { N = SELF_LANES };
    const MUS_REAL two = edges ? 1 : 0;
    MUS_ROLLED
    for (int32_t i = 0; i < N; i++) {
        MUS_REAL along[4] = {0, 0, 0, 0}, wide2 = 0;
        for (int32_t d = 0; d < 3; d++) {
            const MUS_REAL *q = p + d * N + i, *v = w + d * N + i;
            const MUS_REAL a = v[0], b = v[3 * N], c = v[6 * N], e = v[9 * N];
            const MUS_REAL low = a < b ? a : b, high = a < b ? b : a, under = c < e ? c : e, over = c < e ? e : c;
            const MUS_REAL wide = (high > over ? high : over) - (low < under ? low : under);
            const MUS_REAL way =
                share[i] * q[0] + share[N + i] * q[3 * N] + share[2 * N + i] * q[6 * N] + share[3 * N + i] * q[9 * N];
            wide2 += wide * wide;
            along[0] += a * way, along[1] += b * way, along[2] += c * way, along[3] += e * way;
        }
        const MUS_REAL spread = (MUS_REAL)0.5 * (MUS_REAL)MUS_SQRT(wide2), turn = (MUS_REAL)SELF_TURNED / apart[i];
        const MUS_REAL a = along[0], b = along[1], c = along[2] > along[3] ? along[2] : along[3];
        const MUS_REAL gap = two > 0 ? (a < b ? a : b) - c : a - (b > c ? b : c), rate = -gap / apart[i];
        const MUS_REAL half = (MUS_REAL)0.5 * (rate > 0 ? rate : 0) + turn * spread;
        const int32_t less = (turn < 1) & (spread > 0) & (half < spread);
        closing[i] = less ? half : spread;
    }
}


/* pairs k .. k+count-1 of a list, all of one kind, measured */
static void MUS_FIELD(self_row_measure)(const mus__cloth_self *self, int32_t k, int32_t count, const MUS_REAL *x,
                                        MUS_FIELD(self_row) * row)
{
    enum { N = SELF_LANES };
    const int64_t n = self->n;
    const MUS_REAL *drift = self->drift;
    for (int32_t i = 0; i < N; i++) {
        const int32_t *node = self->pair[k + (i < count ? i : 0)].node;
        for (int32_t j = 0; j < 4; j++)
            for (int32_t d = 0; d < 3; d++) row->p[(3 * j + d) * N + i] = x[d * n + node[j]];
        for (int32_t j = 0; j < 4 && self->drifts; j++)
            for (int32_t d = 0; d < 3; d++) row->w[(3 * j + d) * N + i] = drift[d * n + node[j]];
    }
    const int32_t edges = k >= self->nnode_pair;
    if (edges) MUS_FIELD(self_row_edges)(row->p, row->share, row->apart);
    else MUS_FIELD(self_row_faces)(row->p, row->share, row->apart);
    if (self->drifts)
        MUS_FIELD(self_row_closing)(edges, row->p, row->w, row->share, row->apart, row->closing);
    else
        memset(row->closing, 0, sizeof row->closing);
}
