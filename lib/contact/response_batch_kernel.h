/*
 * response_batch_kernel.h: the response of nodes that touch one part and nothing else, many at once, a part of
 * contact_kernel.h.
 *
 * Nearly every node that touches at all is one of these. respond_one() of response_kernel.h has no branch, so the loop
 * over them becomes vectors. A node that touches several surfaces or a plane is left to respond_node().
 */

/* what a node of a chunk touches */
#define MUS__TOUCH_NONE 0
#define MUS__TOUCH_ONE_PART 1
#define MUS__TOUCH_OTHER 2 /* several surfaces, or a plane */

typedef struct MUS__NAME(single_contacts) {
    int32_t count;
    MUS__REAL overlap[MUS__CHUNK], moved2[MUS__CHUNK]; /* moved2: squared distance that the response moved the node */
    MUS__REAL normal[3 * MUS__CHUNK], from[3 * MUS__CHUNK], velocity[3 * MUS__CHUNK]; /* velocity: of the surface */
    MUS__REAL x[3 * MUS__CHUNK], v[3 * MUS__CHUNK];                                   /* v relative to it */
    MUS__NAME(gaps) gaps[MUS__CHUNK];
    uint8_t kind[MUS__CHUNK]; /* MUS__TOUCH_..., of every node of the chunk */
} MUS__NAME(single_contacts);


/* the response of all of *list, in place */
MUS_CLONES
static void MUS__NAME(respond_batch)(const mus__contact_rule *rule, MUS__NAME(single_contacts) * list)
{
    enum { N = MUS__CHUNK };
    const MUS__NAME(response) response = {(MUS__REAL)rule->push, (MUS__REAL)rule->step, (MUS__REAL)rule->slip};
    const MUS__REAL coefficient = (MUS__REAL)rule->friction;
    const MUS__REAL *restrict overlap = list->overlap, *restrict n = list->normal, *restrict f = list->from;
    MUS__REAL *restrict x = list->x, *restrict v = list->v, *restrict moved2 = list->moved2;
    const int32_t count = list->count;
    MUS_IVDEP
    for (int32_t i = 0; i < count; i++) {
        const MUS__REAL normal[3] = {n[i], n[N + i], n[2 * N + i]}, from[3] = {f[i], f[N + i], f[2 * N + i]};
        const MUS__REAL x0 = x[i], x1 = x[N + i], x2 = x[2 * N + i];
        MUS__REAL p[3] = {x0, x1, x2}, w[3] = {v[i], v[N + i], v[2 * N + i]};
        MUS__NAME(respond_one)(overlap[i], coefficient, response, normal, from, p, w);
        x[i] = p[0], x[N + i] = p[1], x[2 * N + i] = p[2];
        v[i] = w[0], v[N + i] = w[1], v[2 * N + i] = w[2];
        moved2[i] = (p[0] - x0) * (p[0] - x0) + (p[1] - x1) * (p[1] - x1) + (p[2] - x2) * (p[2] - x2);
    }
}


/* the distance cache of a node with these gaps, after a response that moved it by the root of moved2 */
static inline void MUS__NAME(distance_cache_set)(const MUS__NAME(gaps) * gaps, MUS__REAL moved2,
                                                 mus__distance_cache *cache)
{
    const int32_t all = gaps->all > 0;
    const MUS__REAL moved = (MUS__REAL)MUS__NAME(sqrt)(moved2);
    cache->slack = (float)((all ? gaps->all : gaps->some) / MUS__CACHE_DIVISOR - moved);
    cache->parts = all ? MUS__CACHE_ALL : (uint32_t)gaps->far & ~MUS__CACHE_ALL;
}


/* node k, which touches with `hit`, as the next of the list; its velocity relative to the surface goes to w (3) */
static inline void MUS__NAME(fill_single)(const MUS__NAME(pass) * pass, const MUS__NAME(query_result) * hit, int64_t k,
                                          MUS__NAME(single_contacts) * list, MUS__REAL *w)
{
    const mus__contact_nodes *nodes = pass->nodes;
    const MUS__REAL *x = nodes->x, *v = nodes->v, *before = nodes->before;
    const MUS__NAME(motion) *motion = MUS__NAME(motion_of)(&pass->surfaces, hit->part);
    const int64_t n = nodes->n;
    const int32_t m = list->count;
    MUS__REAL p[3], old[3], from[3], velocity[3];
    for (int32_t d = 0; d < 3; d++) p[d] = x[d * n + k], w[d] = v[d * n + k], old[d] = before[d * n + k];
    MUS__NAME(carry_node)(motion, old, p, from, velocity);
    list->overlap[m] = hit->depth + pass->clearance;
    for (int32_t d = 0; d < 3; d++) {
        const int32_t at = d * MUS__CHUNK + m;
        if (motion != NULL) w[d] -= velocity[d];
        list->normal[at] = hit->normal[d];
        list->x[at] = p[d];
        list->from[at] = from[d];
        list->v[at] = w[d];
        list->velocity[at] = velocity[d];
    }
}


/* what node i of a chunk touches; one that touches one part alone goes on the list */
static int32_t MUS__NAME(classify_node)(const MUS__NAME(pass) * pass, const MUS__NAME(chunk) * chunk, int32_t i,
                                        const MUS__NAME(query_batch) * batch, MUS__NAME(single_contacts) * list)
{
    const MUS__REAL clearance = pass->clearance, band = clearance + (MUS__REAL)MUS__TOUCH_BAND;
    const MUS__REAL lift = (MUS__REAL)mus__contact_lift(pass->nodes, chunk->start + i);
    const MUS__REAL margin = pass->surfaces.margin - clearance - lift;
    const uint64_t boxes = chunk->boxes[i];
    mus__distance_cache *cache = &pass->cache[chunk->start + i];
    MUS__NAME(gaps) *gaps = &list->gaps[list->count];
    const MUS__NAME(query_result) *hit = NULL;
    uint64_t left = chunk->parts[i];
    int32_t hits = 0;
    *gaps = (MUS__NAME(gaps)){margin, margin, boxes & ~left & (((uint64_t)1 << MUS__CACHE_PARTS) - 1)};
    for (int32_t k = batch->head[i]; k > 0; k = batch->result[k].next) {
        const MUS__NAME(query_result) *result = &batch->result[k];
        left &= ~((uint64_t)1 << result->part);
        MUS__NAME(gaps_note)(gaps, result->part, -result->depth - clearance);
        if (!(result->depth > -band)) continue;
        hit = result;
        hits++;
    }
    if (left != 0 || hits > 1) return MUS__TOUCH_OTHER;
    if (hits == 0) {
        if (cache->slack <= 0) MUS__NAME(distance_cache_set)(gaps, 0, cache);
        return MUS__TOUCH_NONE;
    }

    /* a push out of this part may push it into another one */
    MUS__REAL w[3], push = hit->depth + clearance;
    MUS__NAME(fill_single)(pass, hit, chunk->start + i, list, w);
    if (push > (MUS__REAL)MUS__PUSH_FAR) push = MUS__NAME(push_length)(pass->rule, push, w);
    if (push > (MUS__REAL)MUS__PUSH_FAR && boxes != (uint64_t)1 << hit->part) return MUS__TOUCH_OTHER;
    for (int32_t k = batch->head[i]; k > 0; k = batch->result[k].next) {
        const MUS__NAME(query_result) *result = &batch->result[k];
        if (result->depth + clearance - push * MUS__NAME(dot)(result->normal, hit->normal) > 0 && result != hit)
            return MUS__TOUCH_OTHER;
    }
    list->count++;
    return MUS__TOUCH_ONE_PART;
}


/* the m-th of the list, node k, back to the state */
static inline void MUS__NAME(store_single)(const MUS__NAME(pass) * pass, const MUS__NAME(single_contacts) * list,
                                           int32_t m, int64_t k)
{
    MUS__REAL *x = pass->nodes->x, *v = pass->nodes->v;
    const double mass = 1.0 / (double)((const MUS__REAL *)pass->nodes->inverse)[k];
    const int64_t n = pass->nodes->n;
    mus__distance_cache *cache = &pass->cache[k];
    if (cache->slack <= 0) MUS__NAME(distance_cache_set)(&list->gaps[m], list->moved2[m], cache);
    for (int32_t d = 0; d < 3; d++) {
        const int32_t at = d * MUS__CHUNK + m;
        const MUS__REAL w = pass->surfaces.moving ? list->v[at] + list->velocity[at] : list->v[at];
        pass->tally->impulse[d] += ((double)w - (double)v[d * n + k]) * mass;
        x[d * n + k] = list->x[at];
        v[d * n + k] = w;
    }
}
