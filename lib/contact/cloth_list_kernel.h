/*
 * cloth_list_kernel.h: distances of the things of a cloth, and the list of the pairs that are near: the first part of
 * cloth_kernel.h, with its macros.
 *
 * A node's drift is its mean velocity since the last list. Two things that drift apart or together by at most `spread`
 * from one between them, whose nodes go no farther than the skin from their drifting homes, stay farther apart than
 * the thickness for `span` seconds when they are thickness + 2 (skin + span spread) apart at its beginning: those that
 * are nearer are in the list. Boxes in the grid hold their triangles for all that time.
 */

#define SELF_FLAT_PART 0.5 /* of the distance in the flat: flat cloth does not touch itself */
#define SELF_SWEEP 1.0     /* mean edges: nodes drift so far, beside what all do, in a list's time */
#define SELF_SPAN 0.02     /* [s] at most */
#define SELF_STILL 0.5     /* skins in that time: slower cloth does not drift */
#define SELF_LONGER 2.0    /* times as old as the last list became this one may become */
#define SELF_WIDEN 2.0     /* a skin that was halved for want of room grows so much when there is four times the room */
#define SELF_ROUND 4e-7    /* of a coordinate: what differences of floats may be off by */
#define SELF_FRESH 0.5     /* of the skin: what has less left is listed anew with what is worn */
#define SELF_SOME 0.15     /* of the nodes: when more are, all are */
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

/* by how much [m/s] drifts of four nodes differ at most from one in the middle of them */
static inline MUS_REAL MUS_FIELD(self_spread)(const mus__cloth_self *self, const int32_t *node)
{
    const int64_t n = self->n;
    MUS_REAL wide2 = 0;
    for (int64_t d = 0; d < 3; d++) {
        const MUS_REAL *w = (const MUS_REAL *)self->drift + d * n;
        const MUS_REAL a = w[node[0]], b = w[node[1]], c = w[node[2]], e = w[node[3]];
        const MUS_REAL low = a < b ? a : b, high = a < b ? b : a, under = c < e ? c : e, over = c < e ? e : c;
        const MUS_REAL wide = (high > over ? high : over) - (low < under ? low : under);
        wide2 += wide * wide;
    }
    return (MUS_REAL)0.5 * (MUS_REAL)MUS_SQRT(wide2);
}


typedef struct MUS_FIELD(self_search) {
    mus__cloth_self *self;
    MUS_REAL reach, span; /* of pairs that go along; how much longer they drift apart */
    int32_t some;         /* nonzero: only pairs with a node that is worn */
    int32_t first, last;  /* of the list: filled from both ends */
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


/* the pair, if it has no node twice and is near enough */
static inline void MUS_FIELD(self_add)(MUS_FIELD(self_search) * search, int32_t edges, int32_t a, int32_t b, int32_t c,
                                       int32_t e)
{
    mus__cloth_self *self = search->self;
    const int32_t *of = self->class_of, node[4] = {a, b, c, e};
    const uint8_t *worn = self->worn;
    if (of[a] == of[c] || of[a] == of[e] || (edges ? of[b] == of[c] || of[b] == of[e] : of[a] == of[b])) return;
    if (search->some && !worn[a] && !worn[b] && !worn[c] && !worn[e]) return;
    MUS_REAL p[4][3], share[3], reach = search->reach;
    for (int32_t i = 0; i < 4; i++) memcpy(p[i], (const MUS_REAL *)self->at + 8 * (int64_t)node[i], sizeof p[i]);
    if (search->span > 0) reach += 2 * search->span * MUS_FIELD(self_spread)(self, node);
    const MUS_REAL d2 = edges ? MUS_FIELD(self_edges)(p[0], p[1], p[2], p[3], share)
                              : MUS_FIELD(self_triangle)(p[0], p[1], p[2], p[3], share);
    if (d2 > reach * reach) return;
    if (search->first >= search->last) {
        self->full = 1;
        return;
    }
    const mus__cloth_near pair = {{a, b, c, e}, MUS_FIELD(self_thickness)(self, edges, node), 0, 0};
    self->pair[edges ? --search->last : search->first++] = pair;
}


/* bits of those corners (0..2) and edges (3..5) of `own` that come within reach of a box */
static inline int32_t MUS_FIELD(self_reaches)(const MUS_FIELD(self_search) * search, int32_t own, const int32_t *corner,
                                              const float *box)
{
    const MUS_REAL reach = search->reach;
    int32_t out[3], in = 0;
    for (int32_t k = 0; k < 3; k++) {
        const MUS_REAL *now = (const MUS_REAL *)search->self->at + 8 * (int64_t)corner[k], *then = now + 4;
        out[k] = 0;
        for (int32_t d = 0; d < 3; d++) {
            const MUS_REAL low = box[d] - reach, high = box[3 + d] + reach;
            out[k] |= ((now[d] < low) & (then[d] < low)) << d | ((now[d] > high) & (then[d] > high)) << (3 + d);
        }
    }
    for (int32_t k = 0; k < 3; k++) in |= (out[k] == 0) << k | ((out[k] & out[(k + 1) % 3]) == 0) << (3 + k);
    return own & in;
}


/* what two triangles answer for */
static void MUS_FIELD(self_meet)(void *user, int32_t a, int32_t b)
{
    MUS_FIELD(self_search) *search = user;
    const mus__cloth_self *self = search->self;
    const int32_t *s = self->triangle + 3 * (int64_t)a, *t = self->triangle + 3 * (int64_t)b;
    const int32_t of = MUS_FIELD(self_reaches)(search, self->own[a], s, self->grid.box + 6 * (int64_t)b);
    const int32_t other = MUS_FIELD(self_reaches)(search, self->own[b], t, self->grid.box + 6 * (int64_t)a);
    for (int32_t k = 0; k < 3; k++) {
        if (of >> k & 1) MUS_FIELD(self_add)(search, 0, s[k], t[0], t[1], t[2]);
        if (other >> k & 1) MUS_FIELD(self_add)(search, 0, t[k], s[0], s[1], s[2]);
    }
    if (of < 8 || other < 8) return;
    for (int32_t k = 0; k < 3; k++)
        for (int32_t l = 0; l < 3; l++)
            if ((of >> (3 + k) & 1) && (other >> (3 + l) & 1))
                MUS_FIELD(self_add)(search, 1, s[k], s[(k + 1) % 3], t[l], t[(l + 1) % 3]);
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


/* boxes of the triangles for all that time; the largest coordinate */
static MUS_REAL MUS_FIELD(self_boxes)(mus__cloth_self *self)
{
    float *box = self->grid.box;
    const MUS_REAL *at = self->at;
    MUS_REAL far = 0;
    for (int64_t t = 0; t < self->ntriangle; t++) {
        const int32_t *corner = self->triangle + 3 * t;
        for (int64_t d = 0; d < 3; d++) {
            MUS_REAL low = at[8 * (int64_t)corner[0] + d], high = low;
            for (int32_t k = 0; k < 3; k++) {
                const MUS_REAL now = at[8 * (int64_t)corner[k] + d], then = at[8 * (int64_t)corner[k] + 4 + d];
                const MUS_REAL less = now < then ? now : then, more = now < then ? then : now;
                low = less < low ? less : low;
                high = more > high ? more : high;
            }
            if (-low > far) far = -low;
            if (high > far) far = high;
            box[6 * t + d] = (float)low;
            box[6 * t + 3 + d] = (float)high;
        }
    }
    return far;
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
        MUS_FIELD(self_places)(self, 0, span);
        const MUS_REAL far = MUS_FIELD(self_boxes)(self);
        const MUS_REAL reach = (MUS_REAL)(self->thickness + 2.0 * self->skin);
        MUS_FIELD(self_search) search = {self, reach, span, 0, 0, self->pair_capacity};
        self->full = 0;
        mus__cloth_grid_pairs(&self->grid, self->ntriangle, (float)(reach + (MUS_REAL)SELF_ROUND * far), NULL,
                              MUS_FIELD(self_meet), &search);
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
    const MUS_REAL *left = (const MUS_REAL *)self->ball + 3 * n, age = (MUS_REAL)self->age, *w = self->drift;
    const MUS_REAL least = (MUS_REAL)(SELF_FRESH * self->skin);
    const MUS_REAL span = (MUS_REAL)(self->drifts ? self->span : self->age);
    MUS_REAL *home = self->home;
    int32_t count = 0;
    if (self->full || (self->drifts && !(self->age <= (1.0 - SELF_WORN) * self->span))) return 0;
    for (int64_t i = 0; i < self->nodes; i++) count += self->worn[i] = !(left[i] >= least);
    if (count > SELF_SOME * self->nodes) return 0;
    for (int64_t i = 0; i < self->nodes; i++)
        for (int64_t d = 0; d < 3 && self->worn[i]; d++) home[d * n + i] = x[d * n + i] - age * w[d * n + i];
    for (int64_t t = 0; t < self->ntriangle; t++) {
        const int32_t *corner = self->triangle + 3 * t;
        self->some[t] = self->worn[corner[0]] | self->worn[corner[1]] | self->worn[corner[2]];
    }
    MUS_FIELD(self_places)(self, age, span);
    const MUS_REAL far = MUS_FIELD(self_boxes)(self);
    const MUS_REAL reach = (MUS_REAL)(self->thickness + 2.0 * self->skin);
    MUS_FIELD(self_search) search = {self, reach, span - age, 1, 0, self->pair_capacity};
    MUS_FIELD(self_drop)(self, &search);
    mus__cloth_grid_pairs(&self->grid, self->ntriangle, (float)(reach + (MUS_REAL)SELF_ROUND * far), self->some,
                          MUS_FIELD(self_meet), &search);
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
    self->drifts = 0;
    self->span = INFINITY;
    self->age = 0.0;
}
