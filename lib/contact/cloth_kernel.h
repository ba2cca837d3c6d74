/*
 * cloth_kernel.h: cloth_self.h as a template on the floating type (MUS_REAL, MUS_FIELD, MUS_SELF, MUS_SELF_LOOK,
 * MUS_SQRT).
 *
 * All loops over pairs are in the order of the list, on one thread: what a pair gives its nodes the next one sees, and
 * the bytes do not depend on how many threads there are.
 */

#define SELF_FLAT_PART 0.5 /* of the distance in the flat: flat cloth does not touch itself */
#define SELF_BALL 0.45     /* of the distance of a pair; below a half */
#define SELF_TURN 0.64     /* of the squared radius: from there on balls are taken anew */
#define SELF_ACTIVE 2.0    /* thicknesses: pairs that are nearer answer until balls are taken anew */
#define SELF_APPROACH 0.45 /* of what others are farther apart than the thickness: they do not come to it unseen */
#define SELF_BAND 0.002    /* of the thickness: cloth this little farther off still rests on cloth. Small, for
                            * beside an edge it is that far off at an angle of the root of twice this */
#define SELF_PUSH 0.05     /* of the overlap, in one call */
#define SELF_AGAIN 0.9     /* of what a pair gave in the last call it gives at once */
#define SELF_WORN 0.3      /* of the skin: with less left for a node the list is made anew */
#define SELF_ROUND 4e-7    /* of a coordinate: what differences of floats may be off by */
#define SELF_REACH_MOST 16 /* halvings of the skin until the pairs fit */
#define SELF_BEARS 0.05    /* a node with less of a share in a pair does not bear on it */
#define SELF_AGAINST 0.5   /* cosine of what holds a node and what pushes it */


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
    const MUS_REAL *x;
    MUS_REAL reach;
    int32_t first, last; /* of the list: filled from both ends */
} MUS_FIELD(self_search);


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
static void MUS_FIELD(self_add)(MUS_FIELD(self_search) * search, int32_t edges, int32_t a, int32_t b, int32_t c,
                                int32_t e)
{
    mus__cloth_self *self = search->self;
    const int32_t *of = self->class_of, node[4] = {a, b, c, e};
    if (of[a] == of[c] || of[a] == of[e] || (edges ? of[b] == of[c] || of[b] == of[e] : of[a] == of[b])) return;
    MUS_REAL p[4][3], share[3];
    MUS_FIELD(self_take)(search->x, self->n, node, p);

    /* apart along an axis, or truly */
    for (int32_t d = 0; d < 3; d++) {
        MUS_REAL low = p[0][d], high = low, under = p[2][d], over = under;
        const MUS_REAL more = p[1][d], other = p[3][d];
        if (edges) {
            if (more < low) low = more;
            if (more > high) high = more;
        } else {
            if (more < under) under = more;
            if (more > over) over = more;
        }
        if (other < under) under = other;
        if (other > over) over = other;
        if (under - high > search->reach || low - over > search->reach) return;
    }
    const MUS_REAL d2 = edges ? MUS_FIELD(self_edges)(p[0], p[1], p[2], p[3], share)
                              : MUS_FIELD(self_triangle)(p[0], p[1], p[2], p[3], share);
    if (d2 > search->reach * search->reach) return;
    if (search->first >= search->last) {
        self->full = 1;
        return;
    }
    const mus__cloth_near pair = {{a, b, c, e}, MUS_FIELD(self_thickness)(self, edges, node), 0};
    self->pair[edges ? --search->last : search->first++] = pair;
}


/* what two triangles answer for */
static void MUS_FIELD(self_meet)(void *user, int32_t a, int32_t b)
{
    MUS_FIELD(self_search) *search = user;
    const mus__cloth_self *self = search->self;
    const int32_t *s = self->triangle + 3 * (int64_t)a, *t = self->triangle + 3 * (int64_t)b;
    const int32_t of = self->own[a], other = self->own[b];
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


/* the list of the pairs nearer than thickness + 2 skins; where they do not fit, of a smaller skin */
static void MUS_FIELD(self_list)(mus__cloth_self *self, const MUS_REAL *x)
{
    const int64_t n = self->n;
    mus__cloth_grid *grid = &self->grid;
    MUS_REAL far = 0;
    for (int64_t t = 0; t < self->ntriangle; t++) {
        const int32_t *corner = self->triangle + 3 * t;
        for (int64_t d = 0; d < 3; d++) {
            const MUS_REAL a = x[d * n + corner[0]], b = x[d * n + corner[1]], c = x[d * n + corner[2]];
            const MUS_REAL low = a < b ? a < c ? a : c : b < c ? b : c, high = a > b ? a > c ? a : c : b > c ? b : c;
            if (-low > far) far = -low;
            if (high > far) far = high;
            grid->box[6 * t + d] = (float)low;
            grid->box[6 * t + 3 + d] = (float)high;
        }
    }
    for (int32_t k = 0; k < SELF_REACH_MOST; k++) {
        const MUS_REAL reach = (MUS_REAL)(self->thickness + 2.0 * self->skin);
        MUS_FIELD(self_search) search = {self, x, reach, 0, self->pair_capacity};
        self->full = 0;
        mus__cloth_grid_pairs(grid, self->ntriangle, (float)(reach + (MUS_REAL)SELF_ROUND * far), MUS_FIELD(self_meet),
                              &search);
        self->nnode_pair = search.first;
        self->npair = search.first + self->pair_capacity - search.last;
        self->looks++;
        if (!self->full) break;
        self->skin *= 0.5;
    }
    if (self->npair > self->most_pairs) self->most_pairs = self->npair;
    MUS_REAL *home = self->home;
    memcpy(home, x, 3 * (size_t)n * sizeof *home);
}


/* ---- ball: how far nodes may go ---- */

/* how far node i is from home */
static inline MUS_REAL MUS_FIELD(self_gone)(const mus__cloth_self *self, const MUS_REAL *x, int64_t i)
{
    const MUS_REAL *home = self->home;
    const int64_t n = self->n;
    const MUS_REAL d0 = x[i] - home[i], d1 = x[n + i] - home[n + i], d2 = x[2 * n + i] - home[2 * n + i];
    return (MUS_REAL)MUS_SQRT(d0 * d0 + d1 * d1 + d2 * d2);
}


/* balls of what is left of the skin; nonzero when that is little for a node */
static int32_t MUS_FIELD(self_left)(mus__cloth_self *self, const MUS_REAL *x)
{
    const MUS_REAL skin = (MUS_REAL)self->skin, least = (MUS_REAL)SELF_WORN * skin;
    MUS_REAL *ball = (MUS_REAL *)self->ball + 3 * (int64_t)self->n;
    int32_t worn = 0;
    for (int64_t i = 0; i < self->nodes; i++) {
        ball[i] = skin - MUS_FIELD(self_gone)(self, x, i);
        worn |= !(ball[i] >= least);
    }
    return worn;
}


/* nonzero when both things of a pair have a node that is part of a crossing */
static inline int32_t MUS_FIELD(self_loose)(const mus__cloth_self *self, const int32_t *node, int32_t split)
{
    const uint8_t *tangle = self->tangle;
    const int32_t second = tangle[node[1]] != 0;
    return (tangle[node[0]] || (split == 2 && second)) &&
           (tangle[node[2]] || tangle[node[3]] || (split == 1 && second));
}


/* balls round where the nodes are now, and which pairs answer from now on */
static void MUS_FIELD(self_balls)(mus__cloth_self *self, const MUS_REAL *x)
{
    const int64_t n = self->n;
    MUS_REAL *centre = self->ball, *ball = centre + 3 * n;
    if (self->stale || MUS_FIELD(self_left)(self, x)) {
        MUS_FIELD(self_list)(self, x);
        MUS_FIELD(self_left)(self, x);
    }
    self->stale = 0;
    self->balls++;
    self->measured += self->npair;
    self->ntouch = 0;
    const int32_t edges = self->pair_capacity - (self->npair - self->nnode_pair);
    for (int32_t k = 0; k < self->pair_capacity; k++) {
        if (k == self->nnode_pair) k = edges;
        if (k == self->pair_capacity) break;
        const int32_t *node = self->pair[k].node;
        MUS_REAL p[4][3], share[4];
        if (self->tangled > 0 && MUS_FIELD(self_loose)(self, node, k < self->nnode_pair ? 1 : 2)) continue;
        MUS_FIELD(self_take)(x, n, node, p);
        const MUS_REAL t = (MUS_REAL)self->pair[k].thickness;
        const MUS_REAL apart = (MUS_REAL)MUS_SQRT(MUS_FIELD(self_measure)(self, k, p, share));
        MUS_REAL room = (MUS_REAL)SELF_BALL * apart;
        if (apart < (MUS_REAL)SELF_ACTIVE * t) self->touch[self->ntouch++] = k;
        else room = (MUS_REAL)SELF_APPROACH * (apart - t);
        for (int32_t i = 0; i < 4; i++) ball[node[i]] = room < ball[node[i]] ? room : ball[node[i]];
    }
    for (int64_t i = 0; i < self->nodes; i++) {
        const MUS_REAL far = x[i] * x[i] + x[n + i] * x[n + i] + x[2 * n + i] * x[2 * n + i];
        const MUS_REAL room = ball[i] - (MUS_REAL)SELF_ROUND * (MUS_REAL)MUS_SQRT(far);
        ball[i] = room > 0 && !self->full ? room * room : 0;
    }
    memcpy(centre, x, 3 * (size_t)n * sizeof *centre);
}


/* how many of the nodes are beyond `part` of their squared balls */
MUS_CLONES
static int32_t MUS_FIELD(self_beyond)(int64_t n, int32_t count, MUS_REAL part, const MUS_REAL *restrict ball,
                                      const MUS_REAL *restrict x)
{
    int32_t beyond = 0;
    for (int32_t i = 0; i < count; i++) {
        const MUS_REAL d0 = x[i] - ball[i], d1 = x[n + i] - ball[n + i], d2 = x[2 * n + i] - ball[2 * n + i];
        beyond += d0 * d0 + d1 * d1 + d2 * d2 <= part * ball[3 * n + i] ? 0 : 1;
    }
    return beyond;
}


/* nodes that left their balls back to them, to where they came out. Nonzero when any is near the end of its ball */
static int32_t MUS_FIELD(self_hold)(mus__cloth_self *self, MUS_REAL *x)
{
    const int64_t n = self->n;
    const MUS_REAL *ball = self->ball;
    if (MUS_FIELD(self_beyond)(n, self->nodes, (MUS_REAL)SELF_TURN, ball, x) == 0) return 0;
    for (int64_t i = 0; i < self->nodes; i++) {
        MUS_REAL way[3], d2 = 0;
        for (int64_t d = 0; d < 3; d++) way[d] = x[d * n + i] - ball[d * n + i], d2 += way[d] * way[d];
        if (d2 <= ball[3 * n + i]) continue;
        const MUS_REAL part = (MUS_REAL)0.999 * (MUS_REAL)MUS_SQRT(ball[3 * n + i] / d2);
        for (int64_t d = 0; d < 3; d++) x[d * n + i] = part > 0 ? ball[d * n + i] + part * way[d] : ball[d * n + i];
        self->held++;
    }
    return 1;
}


/* ---- touch: what near pairs answer ---- */

/*
 * A layer that lies on the body hands on what it gets from the layers on it: the body takes it before the next call. In
 * a pair such a layer is as good as held, and the other gets all of the answer; else a pile would sink by half of the
 * answer in each step. It is held when the body pushed its nodes in this step, or a layer that is held did in the last
 * call, against the way in which this pair pushes them.
 */

/* the level of the nodes first .. last-1 that bear on the pair, which pushes them along `sign` times the normal */
static inline int32_t MUS_FIELD(self_level)(const mus__cloth_self *self, const int32_t *node, const MUS_REAL *share,
                                            int32_t first, int32_t last, MUS_REAL sign, const MUS_REAL *normal)
{
    const int64_t n = self->n;
    const MUS_REAL *ground = self->ground;
    int32_t level = 0;
    for (int32_t i = first; i < last; i++) {
        const int32_t k = node[i], now = self->last[k] < self->level[k] ? self->last[k] : self->level[k];
        if (share[i] < (MUS_REAL)SELF_BEARS && share[i] > -(MUS_REAL)SELF_BEARS) continue;
        if (now == MUS_SELF_LOOSE) return now;
        const MUS_REAL along = ground[k] * normal[0] + ground[n + k] * normal[1] + ground[2 * n + k] * normal[2];
        if (!(sign * along < -(MUS_REAL)SELF_AGAINST)) return MUS_SELF_LOOSE;
        level = now > level ? now : level;
    }
    return level;
}


/* the nodes first .. last-1 are pushed along `sign` times the normal by something of `level` */
static inline void MUS_FIELD(self_stand)(mus__cloth_self *self, const int32_t *node, int32_t first, int32_t last,
                                         int32_t level, MUS_REAL sign, const MUS_REAL *normal)
{
    const int64_t n = self->n;
    MUS_REAL *ground = self->ground;
    for (int32_t i = first; i < last && level < MUS_SELF_LEVELS; i++) {
        const int32_t k = node[i];
        if (self->level[k] <= level + 1) continue;
        self->level[k] = (uint8_t)(level + 1);
        for (int32_t d = 0; d < 3; d++) ground[d * n + k] = sign * normal[d];
    }
}


/* which nodes that may touch the body pushed in this step, and whither */
static void MUS_FIELD(self_grounds)(mus__cloth_self *self, const mus__cloth_rule *rule, const MUS_REAL *v)
{
    const int64_t n = self->n;
    const MUS_REAL *before = self->before;
    MUS_REAL *ground = self->ground;
    uint8_t *const was = self->last;
    self->last = self->level;
    self->level = was;
    memset(self->level, MUS_SELF_LOOSE, (size_t)self->nodes);
    if (!rule->body) return;
    for (int32_t k = 0; k < self->ntouch; k++)
        for (int32_t i = 0; i < 4; i++) {
            const int32_t node = self->pair[self->touch[k]].node[i];
            MUS_REAL push[3], push2 = 0;
            if (self->level[node] == 0) continue;
            for (int64_t d = 0; d < 3; d++) {
                push[d] = v[d * n + node] - before[d * n + node];
                push2 += push[d] * push[d];
            }
            if (!(push2 > 0)) continue;
            self->level[node] = 0;
            const MUS_REAL length = (MUS_REAL)MUS_SQRT(push2);
            for (int64_t d = 0; d < 3; d++) ground[d * n + node] = push[d] / length;
        }
}


/* a pair that answers: shares of its nodes, unit normal from its second thing to its first, how much too near they
 * are */
typedef struct MUS_FIELD(self_pair) {
    const int32_t *node;
    int32_t split; /* nodes of the first thing */
    MUS_REAL share[4], normal[3], lift;
} MUS_FIELD(self_pair);


/* pair number k as it lies now; nonzero when its things are nearer than the thickness, or hardly more */
static inline int32_t MUS_FIELD(self_lies)(const mus__cloth_self *self, int32_t k, const MUS_REAL *x,
                                           MUS_FIELD(self_pair) * pair)
{
    const MUS_REAL t = (MUS_REAL)self->pair[k].thickness, reach = (MUS_REAL)(1.0 + SELF_BAND) * t;
    MUS_REAL p[4][3], *share = pair->share;
    pair->node = self->pair[k].node;
    pair->split = k < self->nnode_pair ? 1 : 2;
    MUS_FIELD(self_take)(x, self->n, pair->node, p);
    const MUS_REAL d2 = MUS_FIELD(self_measure)(self, k, p, share);
    if (!(d2 < reach * reach) || !(d2 > 0)) return 0;
    const MUS_REAL apart = (MUS_REAL)MUS_SQRT(d2);
    pair->lift = t - apart;
    for (int32_t d = 0; d < 3; d++)
        pair->normal[d] =
            (share[0] * p[0][d] + share[1] * p[1][d] + share[2] * p[2][d] + share[3] * p[3][d]) / apart;
    return 1;
}


/* an impulse and a move per mass (3 each) to the nodes of a pair */
static inline void MUS_FIELD(self_give)(mus__cloth_self *self, const MUS_FIELD(self_pair) * pair,
                                        const MUS_REAL *inverse, const MUS_REAL *impulse, const MUS_REAL *move,
                                        MUS_REAL *x, MUS_REAL *v)
{
    const int64_t n = self->n;
    MUS_REAL *force = self->force;
    for (int32_t i = 0; i < 4; i++) {
        const MUS_REAL share = pair->share[i], moved = share * inverse[pair->node[i]];
        for (int32_t d = 0; d < 3; d++) {
            const int64_t at = d * n + pair->node[i];
            v[at] += moved * impulse[d];
            x[at] += moved * move[d];
            force[at] += share * impulse[d];
        }
    }
}


/* what a pair gave in the last call, along its normal of now */
static void MUS_FIELD(self_again)(mus__cloth_self *self, const mus__cloth_rule *rule, const MUS_REAL *inverse,
                                  int32_t k, MUS_REAL *x, MUS_REAL *v)
{
    MUS_FIELD(self_pair) pair;
    if (!MUS_FIELD(self_lies)(self, k, x, &pair)) {
        self->pair[k].impulse = 0;
        return;
    }
    self->pair[k].impulse *= (float)SELF_AGAIN;
    MUS_REAL impulse[3], move[3];
    for (int32_t d = 0; d < 3; d++) {
        impulse[d] = (MUS_REAL)self->pair[k].impulse * pair.normal[d];
        move[d] = pair.lift > 0 ? (MUS_REAL)rule->slip * impulse[d] : 0;
    }
    MUS_FIELD(self_give)(self, &pair, inverse, impulse, move, x, v);
}


/* what it gives beside that, or less, and friction of what it gives in all */
static void MUS_FIELD(self_answer)(mus__cloth_self *self, const mus__cloth_rule *rule, const MUS_REAL *inverse,
                                   int32_t k, MUS_REAL *x, MUS_REAL *v)
{
    const int64_t n = self->n;
    MUS_FIELD(self_pair) pair;
    MUS_REAL w[3] = {0, 0, 0}, give = 0, speed2 = 0, rub = 0, slide[3], impulse[3], move[3];
    if (!MUS_FIELD(self_lies)(self, k, x, &pair)) {
        self->pair[k].impulse = 0;
        return;
    }
    self->close++;
    const int32_t *node = pair.node, split = pair.split;
    const int32_t one = MUS_FIELD(self_level)(self, node, pair.share, 0, split, 1, pair.normal);
    const int32_t two = MUS_FIELD(self_level)(self, node, pair.share, split, 4, -1, pair.normal);
    for (int32_t i = 0; i < 4; i++) {
        for (int32_t d = 0; d < 3; d++) w[d] += pair.share[i] * v[d * n + node[i]];
        if (i < split ? one >= two || one == MUS_SELF_LOOSE : two >= one || two == MUS_SELF_LOOSE)
            give += pair.share[i] * pair.share[i] * inverse[node[i]];
    }
    if (!(give > 0)) return;

    /* the approach ends, or what was given too much is taken back; friction against the sliding */
    const MUS_REAL out = MUS_FIELD(dot)(w, pair.normal), last = (MUS_REAL)self->pair[k].impulse;
    const MUS_REAL all = last - out / give > 0 ? last - out / give : 0, more = all - last;
    for (int32_t d = 0; d < 3; d++) slide[d] = w[d] - out * pair.normal[d], speed2 += slide[d] * slide[d];
    if (all > 0 && speed2 > 0) {
        const MUS_REAL speed = (MUS_REAL)MUS_SQRT(speed2), grip = (MUS_REAL)self->friction * all * give;
        rub = (grip < speed ? grip / speed : 1) / give;
    }
    if (all > 0 && one < two) MUS_FIELD(self_stand)(self, node, split, 4, one, -1, pair.normal);
    if (all > 0 && two < one) MUS_FIELD(self_stand)(self, node, 0, split, two, 1, pair.normal);
    self->pair[k].impulse = (float)all;

    /* what moved with the old velocity moves back; but in the band it sinks on, so that it rests below its edge */
    const MUS_REAL slip = (MUS_REAL)rule->slip, sink = pair.lift > 0 ? slip : 0, most = (MUS_REAL)rule->push;
    MUS_REAL push = (MUS_REAL)SELF_PUSH * pair.lift;
    push = (push > most ? most : push > 0 ? push : 0) / give;
    for (int32_t d = 0; d < 3; d++) {
        impulse[d] = more * pair.normal[d] - rub * slide[d];
        move[d] = (sink * more + push) * pair.normal[d] - slip * rub * slide[d];
    }
    MUS_FIELD(self_give)(self, &pair, inverse, impulse, move, x, v);
}


static void MUS_FIELD(self_touch)(mus__cloth_self *self, const mus__cloth_rule *rule, const MUS_REAL *inverse,
                                  MUS_REAL *x, MUS_REAL *v)
{
    self->close = 0;
    for (int32_t k = 0; k < self->ntouch; k++)
        if (self->pair[self->touch[k]].impulse > 0) MUS_FIELD(self_again)(self, rule, inverse, self->touch[k], x, v);
    for (int32_t k = 0; k < self->ntouch; k++) MUS_FIELD(self_answer)(self, rule, inverse, self->touch[k], x, v);
    self->answers += self->ntouch;
}


/* ---- the calls ---- */

void MUS_SELF_LOOK(mus__cloth_self *self, const MUS_REAL *x)
{
    if (self->stale) MUS_FIELD(self_balls)(self, x);
}


void MUS_SELF(mus__cloth_self *self, const mus__cloth_rule *rule, const MUS_REAL *inverse, MUS_REAL *x, MUS_REAL *v)
{
    int32_t turn = MUS_FIELD(self_hold)(self, x);
    if (self->ntouch > 0) {
        MUS_FIELD(self_grounds)(self, rule, v);
        MUS_FIELD(self_touch)(self, rule, inverse, x, v);
        turn |= MUS_FIELD(self_hold)(self, x);
    }
    if (turn) MUS_FIELD(self_balls)(self, x);
}
