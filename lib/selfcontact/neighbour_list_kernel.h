/*
 * neighbour_list_kernel.h: the list of the pairs that may come near, a part of self_response_kernel.h (neighbour list
 * with a margin; Verlet 1967).
 *
 * A node's home is its place when it was listed; homes drift with the node's mean velocity since the last list (or
 * since the last bounds, when the node alone was listed anew). Two things whose nodes stay within the margin of their
 * drifting homes are further apart than the thickness as long as their homes are thickness + 2 margins apart. Homes
 * move straight until the list's end; the pairs of homes that come nearer are the list. So cloth that falls, turns or
 * swings by makes no pairs of neighbours that move along with it.
 */

#define MUS__FLAT_SHARE 0.5 /* thickness over the distance in the flat: flat cloth does not touch itself */
/* mean edges that a node drifts beyond the mean drift in a list's time; chosen: boxes stay small */
#define MUS__DRIFT_WAY_MAX 1.0
#define MUS__LIST_SPAN_MAX 0.02 /* [s] longest time of a drifting list; chosen: longer ones have more pairs */
#define MUS__DRIFT_MIN 0.5      /* [margins] least way in that time with which homes drift; chosen: cost only */
#define MUS__LIST_LONGER 2.0    /* time of a list over the age of the last one; chosen: it doubles at most */
#define MUS__MARGIN_WIDEN 2.0   /* a margin that was halved for want of memory grows by this when a quarter is used */
#define MUS__PLACE_ROUND 4e-7   /* of a coordinate: bound of the rounding of a difference of floats (3 ulp) */
/* [margins] a node with less left is listed anew together with stale ones; chosen: a larger value lists more nodes, a
 * smaller one lists more often */
#define MUS__LIST_FRESH 0.7
/* of the nodes: when more are stale the whole list is made, which is cheaper then */
#define MUS__LIST_PARTIAL_MAX 0.15
#define MUS__LIST_TRIES_MAX 16 /* halvings of the margin until the pairs fit: to below a thousandth of a millimetre */


/* ---- thickness and passing of a pair ---- */

typedef struct MUS__NAME(self_search) {
    mus__self_contact *self;
    MUS__REAL reach;
    int32_t first, last; /* first free place from the front, and from the end, of the list */
    int32_t waiting;     /* pairs of edges in `node`, to be tested as a packet */
    int32_t node[4 * MUS__TREE_LANES];
} MUS__NAME(self_search);


/* homes at `age` and at `end` [s], the numbers of a node together, less the mean drift */
static void MUS__NAME(self_list_places)(mus__self_contact *self, MUS__REAL age, MUS__REAL end)
{
    const int64_t n = self->n;
    const MUS__REAL *home = self->list_home, *w = self->drift;
    for (int64_t d = 0; d < 3; d++) {
        const MUS__REAL mean = (MUS__REAL)self->mean[d];
        MUS__REAL *at = (MUS__REAL *)self->at + d;
        for (int64_t i = 0; i < self->nodes; i++) {
            const MUS__REAL x = home[d * n + i], v = w[d * n + i] - mean;
            at[8 * i] = x + age * v;
            at[8 * i + 4] = x + end * v;
        }
    }
}


/* the thickness of a pair */
static float MUS__NAME(self_pair_thickness)(const mus__self_contact *self, int32_t edges, const int32_t *node)
{
    const mus__self_mesh *flat = &self->flat;
    const float *thick = self->seam_thick, most = (float)self->thickness;
    const int32_t of = flat->panel[node[0]];
    if (self->group[node[0]] != self->group[node[3]]) return most;

    /* in one panel: half the distance in the flat */
    if (flat->panel[node[1]] == of && flat->panel[node[2]] == of && flat->panel[node[3]] == of) {
        MUS__REAL p[4][3], weight[3];
        const double *zero = flat->rest + 2 * (int64_t)node[0];
        for (int32_t i = 0; i < 4; i++) {
            for (int32_t d = 0; d < 2; d++) p[i][d] = (MUS__REAL)(flat->rest[2 * (int64_t)node[i] + d] - zero[d]);
            p[i][2] = 0;
        }
        const MUS__REAL d2 = edges ? MUS__NAME(self_edge_edge)(p[0], p[1], p[2], p[3], weight)
                                   : MUS__NAME(self_point_triangle)(p[0], p[1], p[2], p[3], weight);
        const float half = (float)((MUS__REAL)MUS__FLAT_SHARE * (MUS__REAL)MUS__NAME(sqrt)(d2));
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


/* vector from the second thing of a pair to its first at their nearest points, of nodes at p with these weights */
static inline void MUS__NAME(self_pair_way)(int32_t edges, MUS__REAL p[4][3], const MUS__REAL *weight, MUS__REAL *way)
{
    for (int32_t d = 0; d < 3; d++)
        way[d] = edges ? p[0][d] - p[2][d] + weight[0] * (p[1][d] - p[0][d]) - weight[1] * (p[3][d] - p[2][d])
                       : p[0][d] - weight[0] * p[1][d] - weight[1] * p[2][d] - weight[2] * p[3][d];
}


/* distance of the things of a pair along a direction `way`, times its length; negative when they overlap in it */
static inline MUS__REAL MUS__NAME(self_pair_along)(int32_t edges, MUS__REAL p[4][3], const MUS__REAL *way)
{
    const MUS__REAL a = MUS__NAME(dot)(p[0], way), b = MUS__NAME(dot)(p[1], way), c = MUS__NAME(dot)(p[2], way);
    const MUS__REAL e = MUS__NAME(dot)(p[3], way), two = c > e ? c : e;
    return edges ? (a < b ? a : b) - two : a - (b > two ? b : two);
}


/*
 * Nonzero when the things of a pair stay further apart than the reach while their nodes move straight from p to q.
 * Along a fixed direction the least coordinate of one thing less the greatest of the other is concave in time, so
 * between two times it is not less than at both. Tested for the directions that separate them at the start and at the
 * end.
 */
static int32_t MUS__NAME(self_pair_passes)(MUS__REAL reach2, int32_t edges, MUS__REAL p[4][3], MUS__REAL q[4][3])
{
    MUS__REAL way[3], weight[3];
    for (int32_t k = 0; k < 2; k++) {
        MUS__REAL(*at)[3] = k ? q : p;
        const MUS__REAL d2 = edges ? MUS__NAME(self_edge_edge)(at[0], at[1], at[2], at[3], weight)
                                   : MUS__NAME(self_point_triangle)(at[0], at[1], at[2], at[3], weight);
        if (!(d2 > reach2)) return 0;
        MUS__NAME(self_pair_way)(edges, at, weight, way);
        const MUS__REAL now = MUS__NAME(self_pair_along)(edges, p, way),
                        then = MUS__NAME(self_pair_along)(edges, q, way);
        const MUS__REAL least = now < then ? now : then;
        if (least > 0 && least * least > reach2 * MUS__NAME(dot)(way, way)) return 1;
    }
    return 0;
}


/* lists the pair of these nodes unless it passes */
static inline void MUS__NAME(self_list_add)(MUS__NAME(self_search) * search, int32_t edges, const int32_t *node)
{
    mus__self_contact *self = search->self;
    MUS__REAL p[4][3], q[4][3];
    for (int32_t i = 0; i < 4; i++) {
        const MUS__REAL *at = (const MUS__REAL *)self->at + 8 * (int64_t)node[i];
        memcpy(p[i], at, sizeof p[i]);
        memcpy(q[i], at + 4, sizeof q[i]);
    }
    if (MUS__NAME(self_pair_passes)(search->reach * search->reach, edges, p, q)) return;
    if (search->first >= search->last) {
        self->full = 1;
        return;
    }
    float thickness = MUS__NAME(self_pair_thickness)(self, edges, node);
    for (int32_t i = 0; i < 4; i++)
        thickness = self->thick_max[node[i]] < thickness ? self->thick_max[node[i]] : thickness;
    const mus__self_pair pair = {{node[0], node[1], node[2], node[3]}, thickness, 0, {0, 0, 0}};
    self->pair[edges ? --search->last : search->first++] = pair;
}


/* callbacks of the trees: corner a and triangles of tree node b; triangle a and corners; edge a and edges */
static void MUS__NAME(self_list_corner_faces)(void *user, int32_t a, int32_t b, uint32_t mask)
{
    MUS__NAME(self_search) *search = user;
    const int32_t *face = search->self->faces.node + 3 * MUS__TREE_LANES * (int64_t)b;
    int32_t node[4] = {search->self->corners.node[a]};
    for (; mask != 0; mask &= mask - 1) {
        const int32_t k = mus__box_tree_lowest(mask);
        for (int32_t i = 0; i < 3; i++) node[1 + i] = face[i * MUS__TREE_LANES + k];
        MUS__NAME(self_list_add)(search, 0, node);
    }
}


static void MUS__NAME(self_list_face_corners)(void *user, int32_t a, int32_t b, uint32_t mask)
{
    MUS__NAME(self_search) *search = user;
    const int32_t lane = a % MUS__TREE_LANES, *corner = search->self->corners.node + MUS__TREE_LANES * (int64_t)b;
    const int32_t *face = search->self->faces.node + a / MUS__TREE_LANES * 3 * (int64_t)MUS__TREE_LANES + lane;
    int32_t node[4] = {0, face[0], face[MUS__TREE_LANES], face[2 * MUS__TREE_LANES]};
    for (; mask != 0; mask &= mask - 1) {
        node[0] = corner[mus__box_tree_lowest(mask)];
        MUS__NAME(self_list_add)(search, 0, node);
    }
}


/*
 * self_pair_passes(), by the direction of the nearest points at p alone, of a packet of pairs of edges: x, y, z of the
 * four nodes plane by plane, at the start (p) and at the end (q). near[i]: 0 when pair i passes
 */
MUS_CLONES
static void MUS__NAME(self_packet_passes)(const MUS__REAL *restrict p, const MUS__REAL *restrict q, MUS__REAL reach2,
                                          int32_t *restrict near)
{
    enum { N = MUS__TREE_LANES };
    MUS_ROLLED
    for (int32_t i = 0; i < N; i++) {
        const MUS__REAL u0 = p[3 * N + i] - p[i], u1 = p[4 * N + i] - p[N + i], u2 = p[5 * N + i] - p[2 * N + i];
        const MUS__REAL v0 = p[9 * N + i] - p[6 * N + i], v1 = p[10 * N + i] - p[7 * N + i];
        const MUS__REAL v2 = p[11 * N + i] - p[8 * N + i], r0 = p[i] - p[6 * N + i], r1 = p[N + i] - p[7 * N + i];
        const MUS__REAL r2 = p[2 * N + i] - p[8 * N + i];
        const MUS__REAL uu = u0 * u0 + u1 * u1 + u2 * u2, vv = v0 * v0 + v1 * v1 + v2 * v2;
        const MUS__REAL uv = u0 * v0 + u1 * v1 + u2 * v2, ur = u0 * r0 + u1 * r1 + u2 * r2;
        const MUS__REAL vr = v0 * r0 + v1 * r1 + v2 * r2, turn = uu * vv - uv * uv;

        /* weights as in self_edge_edge() */
        MUS__REAL s = (uv * vr - ur * vv) / (turn > 0 ? turn : 1);
        s = s > 0 ? s : 0, s = s < 1 ? s : 1;
        MUS__REAL t = (uv * s + vr) / (vv > 0 ? vv : 1);
        t = t > 0 ? t : 0, t = t < 1 ? t : 1;
        s = (uv * t - ur) / (uu > 0 ? uu : 1);
        s = s > 0 ? s : 0, s = s < 1 ? s : 1;
        const MUS__REAL w0 = r0 + s * u0 - t * v0, w1 = r1 + s * u1 - t * v1, w2 = r2 + s * u2 - t * v2;
        const MUS__REAL far2 = w0 * w0 + w1 * w1 + w2 * w2;

        /* distance along that direction, at the start and at the end */
        const MUS__REAL ru = r0 * w0 + r1 * w1 + r2 * w2, uw = u0 * w0 + u1 * w1 + u2 * w2;
        const MUS__REAL vw = v0 * w0 + v1 * w1 + v2 * w2;
        const MUS__REAL now = ru + (uw < 0 ? uw : 0) - (vw > 0 ? vw : 0);
        const MUS__REAL a = q[i] * w0 + q[N + i] * w1 + q[2 * N + i] * w2;
        const MUS__REAL b = q[3 * N + i] * w0 + q[4 * N + i] * w1 + q[5 * N + i] * w2;
        const MUS__REAL c = q[6 * N + i] * w0 + q[7 * N + i] * w1 + q[8 * N + i] * w2;
        const MUS__REAL e = q[9 * N + i] * w0 + q[10 * N + i] * w1 + q[11 * N + i] * w2;
        const MUS__REAL then = (a < b ? a : b) - (c > e ? c : e), least = now < then ? now : then;
        near[i] = !((least > 0) & (least * least > reach2 * far2));
    }
}


/* tests the waiting pairs of edges; most pass */
static void MUS__NAME(self_list_waiting)(MUS__NAME(self_search) * search)
{
    enum { N = MUS__TREE_LANES };
    const MUS__REAL *at = search->self->at;
    MUS__REAL p[12 * N], q[12 * N];
    int32_t near[N];
    for (int32_t i = 0; i < N; i++) {
        const int32_t *node = search->node + 4 * (i < search->waiting ? i : 0);
        for (int32_t k = 0; k < 4; k++) {
            const MUS__REAL *of = at + 8 * (int64_t)node[k];
            for (int32_t d = 0; d < 3; d++) p[(3 * k + d) * N + i] = of[d], q[(3 * k + d) * N + i] = of[4 + d];
        }
    }
    MUS__NAME(self_packet_passes)(p, q, search->reach * search->reach, near);
    for (int32_t i = 0; i < search->waiting; i++)
        if (near[i]) MUS__NAME(self_list_add)(search, 1, search->node + 4 * i);
    search->waiting = 0;
}


static void MUS__NAME(self_list_edges)(void *user, int32_t a, int32_t b, uint32_t mask)
{
    MUS__NAME(self_search) *search = user;
    const int32_t *edge = search->self->edges.node, *own = edge + a / MUS__TREE_LANES * 2 * (int64_t)MUS__TREE_LANES;
    const int32_t *other = edge + 2 * MUS__TREE_LANES * (int64_t)b, lane = a % MUS__TREE_LANES;
    for (; mask != 0; mask &= mask - 1) {
        const int32_t k = mus__box_tree_lowest(mask);
        int32_t *node = search->node + 4 * search->waiting++;
        node[0] = own[lane], node[1] = own[MUS__TREE_LANES + lane];
        node[2] = other[k], node[3] = other[MUS__TREE_LANES + k];
        if (search->waiting == MUS__TREE_LANES) MUS__NAME(self_list_waiting)(search);
    }
}


/* sets the drifts: mean velocities since the last list, 0 where places were changed from outside. Returns how long the
 * list is to hold [s]; 0 where nothing drifts */
static MUS__REAL MUS__NAME(self_drift_set)(mus__self_contact *self, const MUS__REAL *x)
{
    const int64_t n = self->n;
    MUS__REAL *drift = self->drift, *home = self->list_home, most2 = 0, speed2 = 0, mean[3];
    const MUS__REAL rate = (MUS__REAL)(self->list_age > 0.0 ? 1.0 / self->list_age : 0.0);
    memset(self->mean, 0, sizeof self->mean);
    if (self->invalid || self->full || !(rate > 0)) {
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
        mean[d] = (MUS__REAL)self->mean[d];
    }
    for (int64_t i = 0; i < self->nodes; i++) {
        MUS__REAL apart2 = 0, all2 = 0;
        for (int64_t d = 0; d < 3; d++) {
            const MUS__REAL all = drift[d * n + i], apart = all - mean[d];
            apart2 += apart * apart;
            all2 += all * all;
        }
        most2 = apart2 > most2 ? apart2 : most2;
        speed2 = all2 > speed2 ? all2 : speed2;
    }

    /* slow cloth does not drift: its list holds until a node has used up its margin */
    const MUS__REAL slow = (MUS__REAL)(MUS__DRIFT_MIN * self->margin / MUS__LIST_SPAN_MAX);
    if (!(speed2 > slow * slow)) {
        memset(self->mean, 0, sizeof self->mean);
        memset(drift, 0, 3 * (size_t)n * sizeof *drift);
        return 0;
    }
    const MUS__REAL way = (MUS__REAL)(MUS__DRIFT_WAY_MAX * self->mean_edge), most = (MUS__REAL)MUS__NAME(sqrt)(most2);
    const MUS__REAL span = (MUS__REAL)fmin(MUS__LIST_SPAN_MAX, MUS__LIST_LONGER * self->list_age);
    return way < span * most ? way / most : span;
}


/* boxes of the things of a tree, at the start and at the end; stale (nodes) not NULL: of things with such a node */
static void MUS__NAME(self_list_boxes)(const mus__self_contact *self, mus__box_tree *tree, const uint8_t *stale)
{
    const int32_t each = tree->each;
    for (int64_t t = 0; t < tree->count; t++) {
        const int64_t block = t / MUS__TREE_LANES, lane = t % MUS__TREE_LANES;
        const int32_t *node = tree->node + block * each * MUS__TREE_LANES + lane;
        float *box = tree->box + block * MUS__TREE_PLANES * MUS__TREE_LANES + lane;
        if (stale != NULL && !mus__box_tree_stale(tree, t, stale)) continue;
        for (int32_t time = 0; time < 2; time++)
            for (int32_t d = 0; d < 3; d++) {
                const MUS__REAL *at = (const MUS__REAL *)self->at + 4 * time + d;
                MUS__REAL low = at[8 * (int64_t)node[0]], high = low;
                for (int32_t k = 1; k < each; k++) {
                    const MUS__REAL x = at[8 * (int64_t)node[k * MUS__TREE_LANES]];
                    low = x < low ? x : low;
                    high = x > high ? x : high;
                }
                box[(6 * time + d) * MUS__TREE_LANES] = (float)low;
                box[(6 * time + 3 + d) * MUS__TREE_LANES] = (float)high;
            }
    }
}


/*
 * Searches all pairs from `age` on; stale (nodes) not NULL: those with such a node. Boxes are of the whole time of the
 * list, so that those of things that are not stale are still right.
 */
static void MUS__NAME(self_list_search)(mus__self_contact *self, MUS__NAME(self_search) * search, MUS__REAL age,
                                        MUS__REAL span, const uint8_t *stale)
{
    mus__box_tree *tree[3] = {&self->corners, &self->edges, &self->faces};
    MUS__REAL far = 0;
    MUS__NAME(self_list_places)(self, 0, span);
    for (int64_t i = 0; i < 8 * (int64_t)self->nodes; i++) {
        const MUS__REAL x = ((const MUS__REAL *)self->at)[i];
        far = x > far ? x : -x > far ? -x : far;
    }
    const float reach = (float)(search->reach + (MUS__REAL)MUS__PLACE_ROUND * far);
    for (int32_t k = 0; k < 3; k++) {
        MUS__NAME(self_list_boxes)(self, tree[k], self->boxed ? stale : NULL);
        if (!self->boxed) mus__box_tree_fit(tree[k], NULL);
        if (stale != NULL) mus__box_tree_fit(tree[k], stale);
    }
    self->boxed = 1;
    if (age > 0) MUS__NAME(self_list_places)(self, age, span);
    if (stale == NULL) {
        mus__box_tree_pairs(tree[0], tree[2], reach, MUS__NAME(self_list_corner_faces), search);
        mus__box_tree_pairs(tree[1], tree[1], reach, MUS__NAME(self_list_edges), search);
    } else {
        mus__box_tree_stale_pairs(tree[0], tree[2], reach, MUS__NAME(self_list_corner_faces),
                                  MUS__NAME(self_list_face_corners), search);
        mus__box_tree_stale_pairs(tree[1], tree[1], reach, MUS__NAME(self_list_edges), NULL, search);
    }
    if (search->waiting > 0) MUS__NAME(self_list_waiting)(search);
}


static void MUS__NAME(self_list_count)(mus__self_contact *self, const MUS__NAME(self_search) * search)
{
    self->nnode_pair = search->first;
    self->npair = search->first + self->pair_capacity - search->last;
    if (self->npair > self->pairs_max) self->pairs_max = self->npair;
}


/*
 * Makes the list: the pairs that come nearer than thickness + 2 margins while all nodes drift for `span`. When they do
 * not fit into memory, with half the margin and half the time.
 */
static void MUS__NAME(self_list_make)(mus__self_contact *self, const MUS__REAL *x)
{
    MUS__REAL *home = self->list_home, span = MUS__NAME(self_drift_set)(self, x);
    if (4 * (int64_t)self->npair < self->pair_capacity)
        self->margin = fmin(self->margin_max, MUS__MARGIN_WIDEN * self->margin);
    memcpy(home, x, 3 * (size_t)self->n * sizeof *home);
    for (int32_t k = 0; k < MUS__LIST_TRIES_MAX; k++) {
        const MUS__REAL reach = (MUS__REAL)(self->thickness + 2.0 * self->margin);
        MUS__NAME(self_search) search = {self, reach, 0, self->pair_capacity, 0, {0}};
        self->full = self->boxed = 0;
        MUS__NAME(self_list_search)(self, &search, 0, span, NULL);
        MUS__NAME(self_list_count)(self, &search);
        self->lists_made++;
        if (!self->full) break;
        self->margin *= 0.5;
        span *= (MUS__REAL)0.5;
    }
    self->drifts = span > 0;
    self->list_span = span > 0 ? (double)span : INFINITY;
    self->list_age = 0.0;
}


/* takes the pairs with a stale node out of the list */
static void MUS__NAME(self_list_drop_stale)(mus__self_contact *self, MUS__NAME(self_search) * search)
{
    const uint8_t *stale = self->stale;
    mus__self_pair *pair = self->pair;
    const int32_t edges = self->pair_capacity - (self->npair - self->nnode_pair);
    for (int32_t k = 0; k < self->nnode_pair; k++) {
        const int32_t *node = pair[k].node;
        if (!(stale[node[0]] | stale[node[1]] | stale[node[2]] | stale[node[3]])) pair[search->first++] = pair[k];
    }
    for (int32_t k = self->pair_capacity - 1; k >= edges; k--) {
        const int32_t *node = pair[k].node;
        if (!(stale[node[0]] | stale[node[1]] | stale[node[2]] | stale[node[3]])) pair[--search->last] = pair[k];
    }
}


/*
 * Gives the nodes that are far from their homes new ones, where they are, and lists their pairs anew. Nonzero when that
 * was done; else the whole list is to be made.
 */
static int32_t MUS__NAME(self_list_renew)(mus__self_contact *self, const MUS__REAL *x)
{
    const int64_t n = self->n;
    const MUS__REAL *left = (const MUS__REAL *)self->bound + 3 * n, age = (MUS__REAL)self->list_age;
    MUS__REAL *w = self->drift;
    const MUS__REAL least = (MUS__REAL)(MUS__LIST_FRESH * self->margin);
    const MUS__REAL span = (MUS__REAL)(self->drifts ? self->list_span : self->list_age);
    MUS__REAL *home = self->list_home;
    int32_t count = 0;
    if (self->full || (self->drifts && !(self->list_age <= (1.0 - MUS__LIST_RENEW) * self->list_span))) return 0;
    for (int64_t i = 0; i < self->nodes; i++) count += self->stale[i] = (uint8_t)!(left[i] >= least);
    if (count > MUS__LIST_PARTIAL_MAX * self->nodes) return 0;
    const MUS__REAL *centre = self->bound,
                    rate = (MUS__REAL)(self->drifts && self->bound_age > 0.0 ? 1.0 / self->bound_age : 0.0);
    for (int64_t i = 0; i < self->nodes; i++)
        for (int64_t d = 0; d < 3 && self->stale[i]; d++) {
            if (rate > 0) w[d * n + i] = rate * (x[d * n + i] - centre[d * n + i]);
            home[d * n + i] = x[d * n + i] - age * w[d * n + i];
        }
    const MUS__REAL reach = (MUS__REAL)(self->thickness + 2.0 * self->margin);
    MUS__NAME(self_search) search = {self, reach, 0, self->pair_capacity, 0, {0}};
    MUS__NAME(self_list_drop_stale)(self, &search);
    MUS__NAME(self_list_search)(self, &search, age, span, self->stale);
    MUS__NAME(self_list_count)(self, &search);
    return !self->full;
}


/* ends all drifts; the list stays right */
static void MUS__NAME(self_drift_stop)(mus__self_contact *self)
{
    const int64_t n3 = 3 * (int64_t)self->n;
    MUS__REAL *home = self->list_home, *drift = self->drift, age = (MUS__REAL)self->list_age;
    for (int64_t i = 0; i < n3; i++) home[i] += age * drift[i];
    memset(drift, 0, (size_t)n3 * sizeof *drift);
    memset(self->mean, 0, sizeof self->mean);
    self->drifts = self->boxed = 0;
    self->list_span = INFINITY;
    self->list_age = 0.0;
}
