/*
 * cloth_list_kernel.h: distances of the things of a cloth, and the list of the pairs that are near: the first part of
 * cloth_kernel.h, with its macros.
 *
 * A node's drift is its mean velocity since the last list, or since balls were last taken when it was listed anew. Two
 * things whose nodes go no farther than the skin from their drifting homes stay farther apart than the thickness as
 * long as those of their homes stay thickness + 2 skins apart, which move straight until the list's end: those that do
 * not are in the list. What falls, turns or swings by makes no pairs of neighbours that go along.
 */

#define SELF_FLAT_PART 0.5 /* of the distance in the flat: flat cloth does not touch itself */
#define SELF_SWEEP 1.0     /* mean edges: nodes drift so far, beside what all do, in a list's time */
#define SELF_SPAN 0.02     /* [s] at most */
#define SELF_STILL 0.5     /* skins in that time: slower cloth does not drift */
#define SELF_LONGER 2.0    /* times as old as the last list became this one may become */
#define SELF_WIDEN 2.0     /* a skin that was halved for want of room grows so much when there is four times the room */
#define SELF_ROUND 4e-7    /* of a coordinate: what differences of floats may be off by */
#define SELF_FRESH 0.7     /* of the skin: what has less left is listed anew with what is worn */
#define SELF_SOME 0.15     /* of the nodes: when more of them are, all are */
#define SELF_REACH_MOST 16 /* halvings of the skin until the pairs fit */


/* squared distance of p and the triangle a b c, and the shares of its corners in the nearest place
 * (Ericson, Real-Time Collision Detection, 2005, 5.1.5) */
static MUS_REAL MUS_FIELD(self_triangle)(const MUS_REAL *p, const MUS_REAL *a, const MUS_REAL *b, const MUS_REAL *c,
                                         MUS_REAL *share)
{
    MUS_REAL ab[3], ac[3], ap[3], d2 = 0, v = 0, w = 0;
    for (int32_t d = 0; d < 3; d++) ab[d] = b[d] - a[d], ac[d] = c[d] - a[d], ap[d] = p[d] - a[d];
    const MUS_REAL bb = MUS_FIELD(dot)(ab, ab), cc = MUS_FIELD(dot)(ac, ac), bc = MUS_FIELD(dot)(ab, ac);
    const MUS_REAL d1 = MUS_FIELD(dot)(ab, ap), e1 = MUS_FIELD(dot)(ac, ap);
    const MUS_REAL d3 = d1 - bb, e3 = e1 - bc, d5 = d1 - bc, e5 = e1 - cc;
    const MUS_REAL vc = d1 * e3 - d3 * e1, vb = d5 * e1 - d1 * e5, va = d3 * e5 - d5 * e3;
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
        const MUS_REAL all = va + vb + vc;
        v = vb / all, w = vc / all;
    }
    share[0] = 1 - v - w, share[1] = v, share[2] = w;
    for (int32_t d = 0; d < 3; d++) {
        const MUS_REAL r = ap[d] - v * ab[d] - w * ac[d];
        d2 += r * r;
    }
    return d2;
}


static inline MUS_REAL MUS_FIELD(self_clamp)(MUS_REAL s)
{
    return s > 0 ? s < 1 ? s : 1 : 0;
}


/* squared distance of the edges a b and c d, and the shares of b and d (the same, 5.1.9). Where they are as good as
 * parallel the places may be off; the distance of ends, which are nodes against triangles, is then as small */
static MUS_REAL MUS_FIELD(self_edges)(const MUS_REAL *a, const MUS_REAL *b, const MUS_REAL *c, const MUS_REAL *e,
                                      MUS_REAL *share)
{
    MUS_REAL u[3], v[3], r[3], d2 = 0;
    for (int32_t d = 0; d < 3; d++) u[d] = b[d] - a[d], v[d] = e[d] - c[d], r[d] = a[d] - c[d];
    const MUS_REAL uu = MUS_FIELD(dot)(u, u), vv = MUS_FIELD(dot)(v, v), uv = MUS_FIELD(dot)(u, v);
    const MUS_REAL ur = MUS_FIELD(dot)(u, r), vr = MUS_FIELD(dot)(v, r), turn = uu * vv - uv * uv;
    MUS_REAL s = turn > 0 ? MUS_FIELD(self_clamp)((uv * vr - ur * vv) / turn) : 0;
    MUS_REAL t = vv > 0 ? MUS_FIELD(self_clamp)((uv * s + vr) / vv) : 0;
    s = uu > 0 ? MUS_FIELD(self_clamp)((uv * t - ur) / uu) : 0;
    share[0] = s, share[1] = t;
    for (int32_t d = 0; d < 3; d++) {
        const MUS_REAL q = r[d] + s * u[d] - t * v[d];
        d2 += q * q;
    }
    return d2;
}


/* shares of the nodes of pair k in the way from its second thing to its first, at their nearest; squared distance */
static inline MUS_REAL MUS_FIELD(self_measure)(const mus__cloth_self *self, int32_t k, MUS_REAL p[4][3],
                                               MUS_REAL *share)
{
    MUS_REAL s[3], d2;
    if (k < self->nnode_pair) {
        d2 = MUS_FIELD(self_triangle)(p[0], p[1], p[2], p[3], s);
        share[0] = 1, share[1] = -s[0], share[2] = -s[1], share[3] = -s[2];
    } else {
        d2 = MUS_FIELD(self_edges)(p[0], p[1], p[2], p[3], s);
        share[0] = 1 - s[0], share[1] = s[0], share[2] = s[1] - 1, share[3] = -s[1];
    }
    return d2;
}


static inline void MUS_FIELD(self_take)(const MUS_REAL *x, int64_t n, const int32_t *node, MUS_REAL p[4][3])
{
    for (int32_t i = 0; i < 4; i++)
        for (int32_t d = 0; d < 3; d++) p[i][d] = x[d * n + node[i]];
}


/* ---- look: the list of near pairs ---- */

typedef struct MUS_FIELD(self_search) {
    mus__cloth_self *self;
    MUS_REAL reach;
    int32_t first, last; /* of the list: filled from both ends */
    int32_t waiting;     /* pairs of edges that are looked at together */
    int32_t node[4 * MUS_TREE_LANES];
} MUS_FIELD(self_search);


/* homes at `age` and at `end`, a node's numbers together, as seen by who goes along with the mean drift */
static void MUS_FIELD(self_places)(mus__cloth_self *self, MUS_REAL age, MUS_REAL end)
{
    const int64_t n = self->n;
    const MUS_REAL *home = self->home, *w = self->drift;
    for (int64_t d = 0; d < 3; d++) {
        const MUS_REAL mean = (MUS_REAL)self->mean[d];
        MUS_REAL *at = (MUS_REAL *)self->at + d;
        for (int64_t i = 0; i < self->nodes; i++) {
            const MUS_REAL x = home[d * n + i], v = w[d * n + i] - mean;
            at[8 * i] = x + age * v;
            at[8 * i + 4] = x + end * v;
        }
    }
}


/* the thickness of a pair */
static float MUS_FIELD(self_thickness)(const mus__cloth_self *self, int32_t edges, const int32_t *node)
{
    const mus__cloth_flat *flat = &self->flat;
    const float *thick = self->thick, most = (float)self->thickness;
    const int32_t of = flat->panel[node[0]];
    if (self->group[node[0]] != self->group[node[3]]) return most;

    /* in one panel: half the distance in the flat */
    if (flat->panel[node[1]] == of && flat->panel[node[2]] == of && flat->panel[node[3]] == of) {
        MUS_REAL p[4][3], share[3];
        const double *zero = flat->rest + 2 * (int64_t)node[0];
        for (int32_t i = 0; i < 4; i++) {
            for (int32_t d = 0; d < 2; d++) p[i][d] = (MUS_REAL)(flat->rest[2 * (int64_t)node[i] + d] - zero[d]);
            p[i][2] = 0;
        }
        const MUS_REAL d2 = edges ? MUS_FIELD(self_edges)(p[0], p[1], p[2], p[3], share)
                                  : MUS_FIELD(self_triangle)(p[0], p[1], p[2], p[3], share);
        const float half = (float)((MUS_REAL)SELF_FLAT_PART * (MUS_REAL)MUS_SQRT(d2));
        return half < most ? half : most;
    }

    /* across a seam: by what is there on both sides */
    float side[2] = {0, 0};
    const int32_t split = edges ? 2 : 1;
    for (int32_t s = 0; s < 2; s++) {
        side[s] = most;
        for (int32_t i = s ? split : 0; i < (s ? 4 : split); i++)
            if (thick[node[i]] < side[s]) side[s] = thick[node[i]];
    }
    return side[0] < most && side[1] < most ? side[0] < side[1] ? side[0] : side[1] : most;
}


/* the way from the second thing of a pair to its first, at their nearest, of nodes at p with these shares */
static inline void MUS_FIELD(self_way)(int32_t edges, MUS_REAL p[4][3], const MUS_REAL *share, MUS_REAL *way)
{
    for (int32_t d = 0; d < 3; d++)
        way[d] = edges ? p[0][d] - p[2][d] + share[0] * (p[1][d] - p[0][d]) - share[1] * (p[3][d] - p[2][d])
                       : p[0][d] - share[0] * p[1][d] - share[1] * p[2][d] - share[2] * p[3][d];
}


/* how far the things of a pair are apart along a way, times its length */
static inline MUS_REAL MUS_FIELD(self_along)(int32_t edges, MUS_REAL p[4][3], const MUS_REAL *way)
{
    const MUS_REAL a = MUS_FIELD(dot)(p[0], way), b = MUS_FIELD(dot)(p[1], way), c = MUS_FIELD(dot)(p[2], way);
    const MUS_REAL e = MUS_FIELD(dot)(p[3], way), two = c > e ? c : e;
    return edges ? (a < b ? a : b) - two : a - (b > two ? b : two);
}


/*
 * Nonzero when the things of a pair stay farther apart than the reach all the way from p to q. Along a fixed direction
 * the least of straight movements less the greatest of others is concave in time: not less between two times than at
 * both. Asked of the directions that part them now and at the end.
 */
static int32_t MUS_FIELD(self_passes)(MUS_REAL reach2, int32_t edges, MUS_REAL p[4][3], MUS_REAL q[4][3])
{
    MUS_REAL way[3], share[3];
    for (int32_t k = 0; k < 2; k++) {
        MUS_REAL(*at)[3] = k ? q : p;
        const MUS_REAL d2 = edges ? MUS_FIELD(self_edges)(at[0], at[1], at[2], at[3], share)
                                  : MUS_FIELD(self_triangle)(at[0], at[1], at[2], at[3], share);
        if (!(d2 > reach2)) return 0;
        MUS_FIELD(self_way)(edges, at, share, way);
        const MUS_REAL now = MUS_FIELD(self_along)(edges, p, way), then = MUS_FIELD(self_along)(edges, q, way);
        const MUS_REAL least = now < then ? now : then;
        if (least > 0 && least * least > reach2 * MUS_FIELD(dot)(way, way)) return 1;
    }
    return 0;
}


/* the pair, if it comes near enough */
static inline void MUS_FIELD(self_add)(MUS_FIELD(self_search) * search, int32_t edges, const int32_t *node)
{
    mus__cloth_self *self = search->self;
    MUS_REAL p[4][3], q[4][3];
    for (int32_t i = 0; i < 4; i++) {
        const MUS_REAL *at = (const MUS_REAL *)self->at + 8 * (int64_t)node[i];
        memcpy(p[i], at, sizeof p[i]);
        memcpy(q[i], at + 4, sizeof q[i]);
    }
    if (MUS_FIELD(self_passes)(search->reach * search->reach, edges, p, q)) return;
    if (search->first >= search->last) {
        self->full = 1;
        return;
    }
    float thickness = MUS_FIELD(self_thickness)(self, edges, node);
    for (int32_t i = 0; i < 4; i++) thickness = self->most[node[i]] < thickness ? self->most[node[i]] : thickness;
    const mus__cloth_near pair = {{node[0], node[1], node[2], node[3]}, thickness, 0, 0};
    self->pair[edges ? --search->last : search->first++] = pair;
}


/* corner number a and the triangles of a block; triangle number a and corners; edge number a and edges */
static void MUS_FIELD(self_faces)(void *user, int32_t a, int32_t b, uint32_t mask)
{
    MUS_FIELD(self_search) *search = user;
    const int32_t *face = search->self->faces.node + 3 * MUS_TREE_LANES * (int64_t)b;
    int32_t node[4] = {search->self->corners.node[a]};
    for (; mask != 0; mask &= mask - 1) {
        const int32_t k = mus__cloth_tree_lowest(mask);
        for (int32_t i = 0; i < 3; i++) node[1 + i] = face[i * MUS_TREE_LANES + k];
        MUS_FIELD(self_add)(search, 0, node);
    }
}


static void MUS_FIELD(self_corners)(void *user, int32_t a, int32_t b, uint32_t mask)
{
    MUS_FIELD(self_search) *search = user;
    const int32_t lane = a % MUS_TREE_LANES, *corner = search->self->corners.node + MUS_TREE_LANES * (int64_t)b;
    const int32_t *face = search->self->faces.node + a / MUS_TREE_LANES * 3 * (int64_t)MUS_TREE_LANES + lane;
    int32_t node[4] = {0, face[0], face[MUS_TREE_LANES], face[2 * MUS_TREE_LANES]};
    for (; mask != 0; mask &= mask - 1) {
        node[0] = corner[mus__cloth_tree_lowest(mask)];
        MUS_FIELD(self_add)(search, 0, node);
    }
}


/*
 * As self_passes() of the edges' nearest places at p, of MUS_TREE_LANES pairs at once: x, y, z of the four nodes plane
 * by plane, now and at the end. near[i]: 0 when they pass
 */
MUS_CLONES
static void MUS_FIELD(self_part)(const MUS_REAL *restrict p, const MUS_REAL *restrict q, MUS_REAL reach2,
                                 int32_t *restrict near)
{
    enum { N = MUS_TREE_LANES };
    MUS_ROLLED
    for (int32_t i = 0; i < N; i++) {
        const MUS_REAL u0 = p[3 * N + i] - p[i], u1 = p[4 * N + i] - p[N + i], u2 = p[5 * N + i] - p[2 * N + i];
        const MUS_REAL v0 = p[9 * N + i] - p[6 * N + i], v1 = p[10 * N + i] - p[7 * N + i];
        const MUS_REAL v2 = p[11 * N + i] - p[8 * N + i], r0 = p[i] - p[6 * N + i], r1 = p[N + i] - p[7 * N + i];
        const MUS_REAL r2 = p[2 * N + i] - p[8 * N + i];
        const MUS_REAL uu = u0 * u0 + u1 * u1 + u2 * u2, vv = v0 * v0 + v1 * v1 + v2 * v2;
        const MUS_REAL uv = u0 * v0 + u1 * v1 + u2 * v2, ur = u0 * r0 + u1 * r1 + u2 * r2;
        const MUS_REAL vr = v0 * r0 + v1 * r1 + v2 * r2, turn = uu * vv - uv * uv;

        /* shares as in self_edges() */
        MUS_REAL s = (uv * vr - ur * vv) / (turn > 0 ? turn : 1);
        s = s > 0 ? s : 0, s = s < 1 ? s : 1;
        MUS_REAL t = (uv * s + vr) / (vv > 0 ? vv : 1);
        t = t > 0 ? t : 0, t = t < 1 ? t : 1;
        s = (uv * t - ur) / (uu > 0 ? uu : 1);
        s = s > 0 ? s : 0, s = s < 1 ? s : 1;
        const MUS_REAL w0 = r0 + s * u0 - t * v0, w1 = r1 + s * u1 - t * v1, w2 = r2 + s * u2 - t * v2;
        const MUS_REAL far2 = w0 * w0 + w1 * w1 + w2 * w2;

        /* the least of the first less the greatest of the second along that way, now and at the end */
        const MUS_REAL ru = r0 * w0 + r1 * w1 + r2 * w2, uw = u0 * w0 + u1 * w1 + u2 * w2;
        const MUS_REAL vw = v0 * w0 + v1 * w1 + v2 * w2;
        const MUS_REAL now = ru + (uw < 0 ? uw : 0) - (vw > 0 ? vw : 0);
        const MUS_REAL a = q[i] * w0 + q[N + i] * w1 + q[2 * N + i] * w2;
        const MUS_REAL b = q[3 * N + i] * w0 + q[4 * N + i] * w1 + q[5 * N + i] * w2;
        const MUS_REAL c = q[6 * N + i] * w0 + q[7 * N + i] * w1 + q[8 * N + i] * w2;
        const MUS_REAL e = q[9 * N + i] * w0 + q[10 * N + i] * w1 + q[11 * N + i] * w2;
        const MUS_REAL then = (a < b ? a : b) - (c > e ? c : e), least = now < then ? now : then;
        near[i] = !((least > 0) & (least * least > reach2 * far2));
    }
}


/* the pairs that wait: most pass, which is seen together */
static void MUS_FIELD(self_sift)(MUS_FIELD(self_search) * search)
{
    enum { N = MUS_TREE_LANES };
    const MUS_REAL *at = search->self->at;
    MUS_REAL p[12 * N] = {0}, q[12 * N] = {0};
    int32_t near[N];
    for (int32_t i = 0; i < search->waiting; i++)
        for (int32_t k = 0; k < 4; k++)
            for (int32_t d = 0; d < 3; d++) {
                p[(3 * k + d) * N + i] = at[8 * (int64_t)search->node[4 * i + k] + d];
                q[(3 * k + d) * N + i] = at[8 * (int64_t)search->node[4 * i + k] + 4 + d];
            }
    MUS_FIELD(self_part)(p, q, search->reach * search->reach, near);
    for (int32_t i = 0; i < search->waiting; i++)
        if (near[i]) MUS_FIELD(self_add)(search, 1, search->node + 4 * i);
    search->waiting = 0;
}


static void MUS_FIELD(self_crosses)(void *user, int32_t a, int32_t b, uint32_t mask)
{
    MUS_FIELD(self_search) *search = user;
    const int32_t *edge = search->self->edges.node, *own = edge + a / MUS_TREE_LANES * 2 * (int64_t)MUS_TREE_LANES;
    const int32_t *other = edge + 2 * MUS_TREE_LANES * (int64_t)b, lane = a % MUS_TREE_LANES;
    for (; mask != 0; mask &= mask - 1) {
        const int32_t k = mus__cloth_tree_lowest(mask);
        int32_t *node = search->node + 4 * search->waiting++;
        node[0] = own[lane], node[1] = own[MUS_TREE_LANES + lane];
        node[2] = other[k], node[3] = other[MUS_TREE_LANES + k];
        if (search->waiting == MUS_TREE_LANES) MUS_FIELD(self_sift)(search);
    }
}


/* drifts: how fast nodes went since the last list, 0 where places were changed from outside. For how long the list is
 * to hold [s]: 0 where nothing drifts */
static MUS_REAL MUS_FIELD(self_drift)(mus__cloth_self *self, const MUS_REAL *x)
{
    const int64_t n = self->n;
    MUS_REAL *drift = self->drift, *home = self->home, most2 = 0, speed2 = 0, mean[3];
    const MUS_REAL rate = (MUS_REAL)(self->age > 0.0 ? 1.0 / self->age : 0.0);
    memset(self->mean, 0, sizeof self->mean);
    if (self->stale || self->full || !(rate > 0)) {
        memset(drift, 0, 3 * (size_t)n * sizeof *drift);
        return 0;
    }
    for (int64_t d = 0; d < 3; d++) {
        double sum = 0.0;
        for (int64_t i = d * n; i < d * n + self->nodes; i++) {
            drift[i] = rate * (x[i] - home[i]);
            sum += (double)drift[i];
        }
        self->mean[d] = sum / self->nodes;
        mean[d] = (MUS_REAL)self->mean[d];
    }
    for (int64_t i = 0; i < self->nodes; i++) {
        MUS_REAL apart2 = 0, all2 = 0;
        for (int64_t d = 0; d < 3; d++) {
            const MUS_REAL all = drift[d * n + i], apart = all - mean[d];
            apart2 += apart * apart;
            all2 += all * all;
        }
        most2 = apart2 > most2 ? apart2 : most2;
        speed2 = all2 > speed2 ? all2 : speed2;
    }

    /* what hardly moves stands still, and its list holds until it is worn */
    const MUS_REAL slow = (MUS_REAL)(SELF_STILL * self->skin / SELF_SPAN);
    if (!(speed2 > slow * slow)) {
        memset(self->mean, 0, sizeof self->mean);
        memset(drift, 0, 3 * (size_t)n * sizeof *drift);
        return 0;
    }
    const MUS_REAL way = (MUS_REAL)(SELF_SWEEP * self->edge), most = (MUS_REAL)MUS_SQRT(most2);
    const MUS_REAL span = (MUS_REAL)fmin(SELF_SPAN, SELF_LONGER * self->age);
    return way < span * most ? way / most : span;
}


/* boxes of the things of a tree, now and at the end; worn (nodes): of those with such a node */
static void MUS_FIELD(self_box)(const mus__cloth_self *self, mus__cloth_tree *tree, const uint8_t *worn)
{
    const int32_t each = tree->each;
    for (int64_t t = 0; t < tree->count; t++) {
        const int64_t block = t / MUS_TREE_LANES, lane = t % MUS_TREE_LANES;
        const int32_t *node = tree->node + block * each * MUS_TREE_LANES + lane;
        float *box = tree->box + block * MUS_TREE_PLANES * MUS_TREE_LANES + lane;
        if (worn != NULL && !mus__cloth_tree_worn(tree, t, worn)) continue;
        for (int32_t time = 0; time < 2; time++)
            for (int32_t d = 0; d < 3; d++) {
                const MUS_REAL *at = (const MUS_REAL *)self->at + 4 * time + d;
                MUS_REAL low = at[8 * (int64_t)node[0]], high = low;
                for (int32_t k = 1; k < each; k++) {
                    const MUS_REAL x = at[8 * (int64_t)node[k * MUS_TREE_LANES]];
                    low = x < low ? x : low;
                    high = x > high ? x : high;
                }
                box[(6 * time + d) * MUS_TREE_LANES] = (float)low;
                box[(6 * time + 3 + d) * MUS_TREE_LANES] = (float)high;
            }
    }
}


/*
 * All pairs of the search from `age` on; worn (nodes): those with such a node, NULL: all. Boxes are of the whole time
 * of the list, so that those of what is not worn are still right.
 */
static void MUS_FIELD(self_pairs)(mus__cloth_self *self, MUS_FIELD(self_search) * search, MUS_REAL age, MUS_REAL span,
                                  const uint8_t *worn)
{
    mus__cloth_tree *tree[3] = {&self->corners, &self->edges, &self->faces};
    MUS_REAL far = 0;
    MUS_FIELD(self_places)(self, 0, span);
    for (int64_t i = 0; i < 8 * (int64_t)self->nodes; i++) {
        const MUS_REAL x = ((const MUS_REAL *)self->at)[i];
        far = x > far ? x : -x > far ? -x : far;
    }
    const float reach = (float)(search->reach + (MUS_REAL)SELF_ROUND * far);
    for (int32_t k = 0; k < 3; k++) {
        MUS_FIELD(self_box)(self, tree[k], self->boxed ? worn : NULL);
        if (!self->boxed) mus__cloth_tree_fit(tree[k], NULL);
        if (worn != NULL) mus__cloth_tree_fit(tree[k], worn);
    }
    self->boxed = 1;
    if (age > 0) MUS_FIELD(self_places)(self, age, span);
    if (worn == NULL) {
        mus__cloth_tree_pairs(tree[0], tree[2], reach, MUS_FIELD(self_faces), search);
        mus__cloth_tree_pairs(tree[1], tree[1], reach, MUS_FIELD(self_crosses), search);
    } else {
        mus__cloth_tree_asked(tree[0], tree[2], reach, MUS_FIELD(self_faces), MUS_FIELD(self_corners), search);
        mus__cloth_tree_asked(tree[1], tree[1], reach, MUS_FIELD(self_crosses), NULL, search);
    }
    if (search->waiting > 0) MUS_FIELD(self_sift)(search);
}


static void MUS_FIELD(self_found)(mus__cloth_self *self, const MUS_FIELD(self_search) * search)
{
    self->nnode_pair = search->first;
    self->npair = search->first + self->pair_capacity - search->last;
    if (self->npair > self->most_pairs) self->most_pairs = self->npair;
}


/*
 * The list of the pairs that come nearer than thickness + 2 skins when all nodes drift for `span`; where they do not
 * fit, of a smaller skin and a shorter one.
 */
static void MUS_FIELD(self_list)(mus__cloth_self *self, const MUS_REAL *x)
{
    MUS_REAL *home = self->home, span = MUS_FIELD(self_drift)(self, x);
    if (4 * (int64_t)self->npair < self->pair_capacity) self->skin = fmin(self->widest, SELF_WIDEN * self->skin);
    memcpy(home, x, 3 * (size_t)self->n * sizeof *home);
    for (int32_t k = 0; k < SELF_REACH_MOST; k++) {
        const MUS_REAL reach = (MUS_REAL)(self->thickness + 2.0 * self->skin);
        MUS_FIELD(self_search) search = {self, reach, 0, self->pair_capacity, 0, {0}};
        self->full = self->boxed = 0;
        MUS_FIELD(self_pairs)(self, &search, 0, span, NULL);
        MUS_FIELD(self_found)(self, &search);
        self->looks++;
        if (!self->full) break;
        self->skin *= 0.5;
        span *= (MUS_REAL)0.5;
    }
    self->drifts = span > 0;
    self->span = span > 0 ? (double)span : INFINITY;
    self->age = 0.0;
}


/* pairs with a node that is worn leave the list */
static void MUS_FIELD(self_drop)(mus__cloth_self *self, MUS_FIELD(self_search) * search)
{
    const uint8_t *worn = self->worn;
    mus__cloth_near *pair = self->pair;
    const int32_t edges = self->pair_capacity - (self->npair - self->nnode_pair);
    for (int32_t k = 0; k < self->nnode_pair; k++) {
        const int32_t *node = pair[k].node;
        if (!(worn[node[0]] | worn[node[1]] | worn[node[2]] | worn[node[3]])) pair[search->first++] = pair[k];
    }
    for (int32_t k = self->pair_capacity - 1; k >= edges; k--) {
        const int32_t *node = pair[k].node;
        if (!(worn[node[0]] | worn[node[1]] | worn[node[2]] | worn[node[3]])) pair[--search->last] = pair[k];
    }
}


/*
 * Nodes that are far from their homes get new ones, where they are, and their pairs are listed anew. Nonzero when that
 * did; else the whole list is to be made.
 */
static int32_t MUS_FIELD(self_renew)(mus__cloth_self *self, const MUS_REAL *x)
{
    const int64_t n = self->n;
    const MUS_REAL *left = (const MUS_REAL *)self->ball + 3 * n, age = (MUS_REAL)self->age;
    MUS_REAL *w = self->drift;
    const MUS_REAL least = (MUS_REAL)(SELF_FRESH * self->skin);
    const MUS_REAL span = (MUS_REAL)(self->drifts ? self->span : self->age);
    MUS_REAL *home = self->home;
    int32_t count = 0;
    if (self->full || (self->drifts && !(self->age <= (1.0 - SELF_WORN) * self->span))) return 0;
    for (int64_t i = 0; i < self->nodes; i++) count += self->worn[i] = !(left[i] >= least);
    if (count > SELF_SOME * self->nodes) return 0;
    const MUS_REAL *centre = self->ball, rate = (MUS_REAL)(self->drifts && self->since > 0.0 ? 1.0 / self->since : 0.0);
    for (int64_t i = 0; i < self->nodes; i++)
        for (int64_t d = 0; d < 3 && self->worn[i]; d++) {
            if (rate > 0) w[d * n + i] = rate * (x[d * n + i] - centre[d * n + i]);
            home[d * n + i] = x[d * n + i] - age * w[d * n + i];
        }
    const MUS_REAL reach = (MUS_REAL)(self->thickness + 2.0 * self->skin);
    MUS_FIELD(self_search) search = {self, reach, 0, self->pair_capacity, 0, {0}};
    MUS_FIELD(self_drop)(self, &search);
    MUS_FIELD(self_pairs)(self, &search, age, span, self->worn);
    MUS_FIELD(self_found)(self, &search);
    return !self->full;
}


/* nodes that drift stand still from now on: what the list says of them stays true */
static void MUS_FIELD(self_rest)(mus__cloth_self *self)
{
    const int64_t n3 = 3 * (int64_t)self->n;
    MUS_REAL *home = self->home, *drift = self->drift, age = (MUS_REAL)self->age;
    for (int64_t i = 0; i < n3; i++) home[i] += age * drift[i];
    memset(drift, 0, (size_t)n3 * sizeof *drift);
    memset(self->mean, 0, sizeof self->mean);
    self->drifts = self->boxed = 0;
    self->span = INFINITY;
    self->age = 0.0;
}
