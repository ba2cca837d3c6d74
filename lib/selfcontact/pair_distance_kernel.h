/*
 * pair_distance_kernel.h: distance of a pair (a node and a triangle, or two edges), a part of self_response_kernel.h.
 *
 * Of one pair at a time, and of a packet of MUS__TREE_LANES pairs at once: the same operations in the same order
 * without a branch, so the same bits; the loop over a packet becomes vectors (the two texts differ, since one skips
 * what the other selects away). A packet also gets the speed at which the drifts of its nodes close each gap.
 *
 * The weights of a pair's nodes are their shares in the vector from its second thing to its first at their nearest
 * points: sum weight x.
 */

#define MUS__SELF_LANES MUS__TREE_LANES /* pairs of a packet: one or two vectors of floats */
/* [m] bound of the rounding of the vector between two things: float, some metres from the origin */
#define MUS__NORMAL_ROUND 1e-5

/* a packet of pairs. Numbers of four nodes stand plane by plane: x, y, z of the first, then of the next */
typedef struct MUS__NAME(self_packet) {
    MUS__REAL p[12 * MUS__SELF_LANES], w[12 * MUS__SELF_LANES]; /* places and drifts of the nodes */
    MUS__REAL weight[4 * MUS__SELF_LANES], apart[MUS__SELF_LANES], closing[MUS__SELF_LANES];
} MUS__NAME(self_packet);


/* squared distance of p from the triangle a b c, and the weights (3) of its corners in the nearest point
 * (Ericson, Real-Time Collision Detection, 2005, section 5.1.5) */
static MUS__REAL MUS__NAME(self_point_triangle)(const MUS__REAL *p, const MUS__REAL *a, const MUS__REAL *b,
                                                const MUS__REAL *c, MUS__REAL *weight)
{
    MUS__REAL ab[3], ac[3], ap[3], d2 = 0, v = 0, w = 0;
    for (int32_t d = 0; d < 3; d++) ab[d] = b[d] - a[d], ac[d] = c[d] - a[d], ap[d] = p[d] - a[d];
    const MUS__REAL bb = MUS__NAME(dot)(ab, ab), cc = MUS__NAME(dot)(ac, ac), bc = MUS__NAME(dot)(ab, ac);
    const MUS__REAL d1 = MUS__NAME(dot)(ab, ap), e1 = MUS__NAME(dot)(ac, ap);
    const MUS__REAL d3 = d1 - bb, e3 = e1 - bc, d5 = d1 - bc, e5 = e1 - cc;
    const MUS__REAL vc = d1 * e3 - d3 * e1, vb = d5 * e1 - d1 * e5, va = d3 * e5 - d5 * e3;
    if (d1 <= 0 && e1 <= 0) {
        v = 0, w = 0;
    } else if (d3 >= 0 && e3 <= d3) {
        v = 1;
    } else if (e5 >= 0 && d5 <= e5) {
        w = 1;
    } else if (vc <= 0 && d1 >= 0 && d3 <= 0) {
        v = d1 / (d1 - d3);
    } else if (vb <= 0 && e1 >= 0 && e5 <= 0) {
        w = e1 / (e1 - e5);
    } else if (va <= 0 && e3 - d3 >= 0 && d5 - e5 >= 0) {
        w = (e3 - d3) / ((e3 - d3) + (d5 - e5));
        v = 1 - w;
    } else {
        const MUS__REAL all = va + vb + vc;
        v = vb / all, w = vc / all;
    }
    weight[0] = 1 - v - w, weight[1] = v, weight[2] = w;
    for (int32_t d = 0; d < 3; d++) {
        const MUS__REAL r = ap[d] - v * ab[d] - w * ac[d];
        d2 += r * r;
    }
    return d2;
}


static inline MUS__REAL MUS__NAME(self_clamp)(MUS__REAL s)
{
    return s > 0 ? s < 1 ? s : 1 : 0;
}


/* squared distance of the edges a b and c e, and the weights (2) of b and e in the nearest points (the same, 5.1.9).
 * For edges that are all but parallel the points may be off; then an end, as a node against a triangle, is as near */
static MUS__REAL MUS__NAME(self_edge_edge)(const MUS__REAL *a, const MUS__REAL *b, const MUS__REAL *c,
                                           const MUS__REAL *e, MUS__REAL *weight)
{
    MUS__REAL u[3], v[3], r[3], d2 = 0;
    for (int32_t d = 0; d < 3; d++) u[d] = b[d] - a[d], v[d] = e[d] - c[d], r[d] = a[d] - c[d];
    const MUS__REAL uu = MUS__NAME(dot)(u, u), vv = MUS__NAME(dot)(v, v), uv = MUS__NAME(dot)(u, v);
    const MUS__REAL ur = MUS__NAME(dot)(u, r), vr = MUS__NAME(dot)(v, r), turn = uu * vv - uv * uv;
    MUS__REAL s = turn > 0 ? MUS__NAME(self_clamp)((uv * vr - ur * vv) / turn) : 0;
    MUS__REAL t = vv > 0 ? MUS__NAME(self_clamp)((uv * s + vr) / vv) : 0;
    s = uu > 0 ? MUS__NAME(self_clamp)((uv * t - ur) / uu) : 0;
    weight[0] = s, weight[1] = t;
    for (int32_t d = 0; d < 3; d++) {
        const MUS__REAL q = r[d] + s * u[d] - t * v[d];
        d2 += q * q;
    }
    return d2;
}


/* weights (4) of the nodes of a pair of edges or of a node and a triangle, at places p; returns the squared distance of
 * its things */
static inline MUS__REAL MUS__NAME(self_pair_measure)(int32_t edges, MUS__REAL p[4][3], MUS__REAL *weight)
{
    MUS__REAL s[3], d2;
    if (!edges) {
        d2 = MUS__NAME(self_point_triangle)(p[0], p[1], p[2], p[3], s);
        weight[0] = 1, weight[1] = -s[0], weight[2] = -s[1], weight[3] = -s[2];
    } else {
        d2 = MUS__NAME(self_edge_edge)(p[0], p[1], p[2], p[3], s);
        weight[0] = 1 - s[0], weight[1] = s[0], weight[2] = s[1] - 1, weight[3] = -s[1];
    }
    return d2;
}


static inline void MUS__NAME(self_pair_places)(const MUS__REAL *x, int64_t n, const int32_t *node, MUS__REAL p[4][3])
{
    for (int32_t i = 0; i < 4; i++)
        for (int32_t d = 0; d < 3; d++) p[i][d] = x[d * n + node[i]];
}


/* ---- a packet of pairs ---- */

/* as self_point_triangle(): the first of the regions of corners and edges that holds, else the inside */
MUS_CLONES
static void MUS__NAME(self_packet_point_triangle)(const MUS__REAL *restrict p, MUS__REAL *restrict weight,
                                                  MUS__REAL *restrict apart)
{
    enum { N = MUS__SELF_LANES };
    MUS_ROLLED
    for (int32_t i = 0; i < N; i++) {
        const MUS__REAL *a = p + 3 * N + i, *b = p + 6 * N + i, *c = p + 9 * N + i;
        const MUS__REAL ab0 = b[0] - a[0], ab1 = b[N] - a[N], ab2 = b[2 * N] - a[2 * N];
        const MUS__REAL ac0 = c[0] - a[0], ac1 = c[N] - a[N], ac2 = c[2 * N] - a[2 * N];
        const MUS__REAL ap0 = p[i] - a[0], ap1 = p[N + i] - a[N], ap2 = p[2 * N + i] - a[2 * N];
        const MUS__REAL bb = ab0 * ab0 + ab1 * ab1 + ab2 * ab2, cc = ac0 * ac0 + ac1 * ac1 + ac2 * ac2;
        const MUS__REAL bc = ab0 * ac0 + ab1 * ac1 + ab2 * ac2;
        const MUS__REAL d1 = ab0 * ap0 + ab1 * ap1 + ab2 * ap2, e1 = ac0 * ap0 + ac1 * ap1 + ac2 * ap2;
        const MUS__REAL d3 = d1 - bb, e3 = e1 - bc, d5 = d1 - bc, e5 = e1 - cc;
        const MUS__REAL vc = d1 * e3 - d3 * e1, vb = d5 * e1 - d1 * e5, va = d3 * e5 - d5 * e3;
        const MUS__REAL all = va + vb + vc, f3 = e3 - d3, f5 = d5 - e5;
        const MUS__REAL on_bc = f3 / (f3 + f5), on_ac = e1 / (e1 - e5), on_ab = d1 / (d1 - d3);
        const int32_t in_bc = (va <= 0) & (f3 >= 0) & (f5 >= 0), in_ac = (vb <= 0) & (e1 >= 0) & (e5 <= 0);
        const int32_t in_ab = (vc <= 0) & (d1 >= 0) & (d3 <= 0), at_c = (e5 >= 0) & (d5 <= e5);
        const int32_t at_b = (d3 >= 0) & (e3 <= d3), at_a = (d1 <= 0) & (e1 <= 0);
        MUS__REAL v = vb / all, w = vc / all;
        v = in_bc ? 1 - on_bc : v, w = in_bc ? on_bc : w;
        v = in_ac ? 0 : v, w = in_ac ? on_ac : w;
        v = in_ab ? on_ab : v, w = in_ab ? 0 : w;
        v = at_c ? 0 : v, w = at_c ? 1 : w;
        v = at_b ? 1 : v, w = at_b ? 0 : w;
        v = at_a ? 0 : v, w = at_a ? 0 : w;
        const MUS__REAL r0 = ap0 - v * ab0 - w * ac0, r1 = ap1 - v * ab1 - w * ac1, r2 = ap2 - v * ab2 - w * ac2;
        weight[i] = 1, weight[N + i] = -(1 - v - w), weight[2 * N + i] = -v, weight[3 * N + i] = -w;
        apart[i] = (MUS__REAL)MUS__NAME(sqrt)(r0 * r0 + r1 * r1 + r2 * r2);
    }
}


/* as self_edge_edge() */
MUS_CLONES
static void MUS__NAME(self_packet_edge_edge)(const MUS__REAL *restrict p, MUS__REAL *restrict weight,
                                             MUS__REAL *restrict apart)
{
    enum { N = MUS__SELF_LANES };
    MUS_ROLLED
    for (int32_t i = 0; i < N; i++) {
        const MUS__REAL u0 = p[3 * N + i] - p[i], u1 = p[4 * N + i] - p[N + i], u2 = p[5 * N + i] - p[2 * N + i];
        const MUS__REAL v0 = p[9 * N + i] - p[6 * N + i], v1 = p[10 * N + i] - p[7 * N + i];
        const MUS__REAL v2 = p[11 * N + i] - p[8 * N + i], r0 = p[i] - p[6 * N + i], r1 = p[N + i] - p[7 * N + i];
        const MUS__REAL r2 = p[2 * N + i] - p[8 * N + i];
        const MUS__REAL uu = u0 * u0 + u1 * u1 + u2 * u2, vv = v0 * v0 + v1 * v1 + v2 * v2;
        const MUS__REAL uv = u0 * v0 + u1 * v1 + u2 * v2, ur = u0 * r0 + u1 * r1 + u2 * r2;
        const MUS__REAL vr = v0 * r0 + v1 * r1 + v2 * r2, turn = uu * vv - uv * uv;
        MUS__REAL s = (uv * vr - ur * vv) / (turn > 0 ? turn : 1);
        s = s > 0 ? s : 0, s = s < 1 ? s : 1, s = turn > 0 ? s : 0;
        MUS__REAL t = (uv * s + vr) / (vv > 0 ? vv : 1);
        t = t > 0 ? t : 0, t = t < 1 ? t : 1, t = vv > 0 ? t : 0;
        s = (uv * t - ur) / (uu > 0 ? uu : 1);
        s = s > 0 ? s : 0, s = s < 1 ? s : 1, s = uu > 0 ? s : 0;
        const MUS__REAL q0 = r0 + s * u0 - t * v0, q1 = r1 + s * u1 - t * v1, q2 = r2 + s * u2 - t * v2;
        weight[i] = 1 - s, weight[N + i] = s, weight[2 * N + i] = t - 1, weight[3 * N + i] = -t;
        apart[i] = (MUS__REAL)MUS__NAME(sqrt)(q0 * q0 + q1 * q1 + q2 * q2);
    }
}


/*
 * Half of the speed [m/s] at which drifts may close the gap of a pair. Two convex things that move straight come nearer
 * no faster than along the direction that separates them now. Rounding may have turned that direction by
 * MUS__NORMAL_ROUND / apart, which the spread of the drifts multiplies; the result is no more than half of that spread.
 */
MUS_CLONES
static void MUS__NAME(self_packet_closing)(int32_t edges, const MUS__REAL *restrict p, const MUS__REAL *restrict w,
                                           const MUS__REAL *restrict weight, const MUS__REAL *restrict apart,
                                           MUS__REAL *restrict closing)
{
    enum { N = MUS__SELF_LANES };
    const MUS__REAL two = edges ? 1 : 0;
    MUS_ROLLED
    for (int32_t i = 0; i < N; i++) {
        MUS__REAL along[4] = {0, 0, 0, 0}, wide2 = 0;
        for (int32_t d = 0; d < 3; d++) {
            const MUS__REAL *q = p + d * N + i, *v = w + d * N + i;
            const MUS__REAL a = v[0], b = v[3 * N], c = v[6 * N], e = v[9 * N];
            const MUS__REAL low = a < b ? a : b, high = a < b ? b : a, under = c < e ? c : e, over = c < e ? e : c;
            const MUS__REAL wide = (high > over ? high : over) - (low < under ? low : under);
            const MUS__REAL way = weight[i] * q[0] + weight[N + i] * q[3 * N] + weight[2 * N + i] * q[6 * N] +
                                  weight[3 * N + i] * q[9 * N];
            wide2 += wide * wide;
            along[0] += a * way, along[1] += b * way, along[2] += c * way, along[3] += e * way;
        }
        const MUS__REAL spread = (MUS__REAL)0.5 * (MUS__REAL)MUS__NAME(sqrt)(wide2),
                        turn = (MUS__REAL)MUS__NORMAL_ROUND / apart[i];
        const MUS__REAL a = along[0], b = along[1], c = along[2] > along[3] ? along[2] : along[3];
        const MUS__REAL gap = two > 0 ? (a < b ? a : b) - c : a - (b > c ? b : c), rate = -gap / apart[i];
        const MUS__REAL half = (MUS__REAL)0.5 * (rate > 0 ? rate : 0) + turn * spread;
        const int32_t less = (turn < 1) & (spread > 0) & (half < spread);
        closing[i] = less ? half : spread;
    }
}


/* the places of the nodes of a pair, in lane i of a packet */
static inline void MUS__NAME(self_packet_places)(const MUS__REAL *x, int64_t n, const int32_t *node, int32_t i,
                                                 MUS__REAL *p)
{
    enum { N = MUS__SELF_LANES };
    for (int32_t j = 0; j < 4; j++)
        for (int32_t d = 0; d < 3; d++) p[(3 * j + d) * N + i] = x[d * n + node[j]];
}


/* measures pairs k .. k+count-1 of the list, all of one kind */
static void MUS__NAME(self_packet_measure)(const mus__self_contact *self, int32_t k, int32_t count, const MUS__REAL *x,
                                           MUS__NAME(self_packet) * row)
{
    enum { N = MUS__SELF_LANES };
    const int64_t n = self->n;
    const MUS__REAL *drift = self->drift;
    for (int32_t i = 0; i < N; i++) {
        const int32_t *node = self->pair[k + (i < count ? i : 0)].node;
        MUS__NAME(self_packet_places)(x, n, node, i, row->p);
        for (int32_t j = 0; j < 4 && self->drifts; j++)
            for (int32_t d = 0; d < 3; d++) row->w[(3 * j + d) * N + i] = drift[d * n + node[j]];
    }
    const int32_t edges = k >= self->nnode_pair;
    if (edges)
        MUS__NAME(self_packet_edge_edge)(row->p, row->weight, row->apart);
    else
        MUS__NAME(self_packet_point_triangle)(row->p, row->weight, row->apart);
    if (self->drifts)
        MUS__NAME(self_packet_closing)(edges, row->p, row->w, row->weight, row->apart, row->closing);
    else
        memset(row->closing, 0, sizeof row->closing);
}
