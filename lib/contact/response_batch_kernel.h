/*
 * response_batch_kernel.h: the response of nodes that touch one part and nothing else, many at once, a part of
 * contact_kernel.h.
 *
 * That is nearly every node that touches at all. The text of respond() and rub() for places in a row, without a branch,
 * so that it is made for as many nodes at once as the vector unit is wide; the same operations in the same order, so
 * the same bits. What touches several surfaces, or a plane, is left to touch().
 */

/* what contact is to do with a node of a block */
#define MUS__TOUCH_NONE 0
#define MUS__TOUCH_ONE_PART 1
#define MUS__TOUCH_OTHER 2

typedef struct MUS__NAME(single_contacts) {
    int32_t count;
    MUS__REAL overlap[MUS__CHUNK], moved[MUS__CHUNK];
    MUS__REAL normal[3 * MUS__CHUNK], from[3 * MUS__CHUNK], speed[3 * MUS__CHUNK];
    MUS__REAL x[3 * MUS__CHUNK], v[3 * MUS__CHUNK]; /* v relative to the surface */
    MUS__NAME(gaps) gaps[MUS__CHUNK];
    uint8_t kind[MUS__CHUNK]; /* of every node of the block */
} MUS__NAME(single_contacts);


/* respond() of contact_kernel.h for `count` nodes in place, and the square of how far each was moved */
MUS_CLONES
static void MUS__NAME(respond_batch)(MUS__REAL friction, MUS__REAL push, MUS__REAL time, MUS__REAL slip, int32_t count,
                                     const MUS__REAL *restrict lifts, const MUS__REAL *restrict normal,
                                     const MUS__REAL *restrict from, MUS__REAL *restrict x, MUS__REAL *restrict v,
                                     MUS__REAL *restrict moved)
{
    MUS_IVDEP
    for (int32_t i = 0; i < count; i++) {
        const MUS__REAL n0 = normal[i], n1 = normal[MUS__CHUNK + i], n2 = normal[2 * MUS__CHUNK + i],
                        overlap = lifts[i];
        const MUS__REAL v0 = v[i], v1 = v[MUS__CHUNK + i], v2 = v[2 * MUS__CHUNK + i];
        const MUS__REAL x0 = x[i], x1 = x[MUS__CHUNK + i], x2 = x[2 * MUS__CHUNK + i];
        const MUS__REAL vn = v0 * n0 + v1 * n1 + v2 * n2, inward = vn < 0 ? -vn : 0;
        const MUS__REAL go = time * (MUS__REAL)MUS__NAME(sqrt)(v0 * v0 + v1 * v1 + v2 * v2);
        const MUS__REAL partly = push + inward * slip, whole = overlap <= push + go ? overlap : partly;
        const MUS__REAL move = overlap < 0 ? 0 : whole;
        const MUS__REAL p0 = x0 + move * n0, p1 = x1 + move * n1, p2 = x2 + move * n2;

        /* friction */
        const MUS__REAL f0 = from[i], f1 = from[MUS__CHUNK + i], f2 = from[2 * MUS__CHUNK + i];
        const MUS__REAL t0 = v0 + inward * n0, t1 = v1 + inward * n1, t2 = v2 + inward * n2;
        const MUS__REAL d0 = p0 - f0, d1 = p1 - f1, d2 = p2 - f2, along = d0 * n0 + d1 * n1 + d2 * n2;
        const MUS__REAL w0 = d0 - along * n0, w1 = d1 - along * n1, w2 = d2 - along * n2;
        const MUS__REAL speed = (MUS__REAL)MUS__NAME(sqrt)(t0 * t0 + t1 * t1 + t2 * t2);
        const MUS__REAL length = (MUS__REAL)MUS__NAME(sqrt)(w0 * w0 + w1 * w1 + w2 * w2);
        const MUS__REAL loss = friction * inward, back = slip > 0 ? loss * slip : 0;
        const MUS__REAL by_speed = speed > loss ? speed : 1, by_length = length > back ? length : 1;
        const MUS__REAL kept = (speed - loss) / by_speed, taken = back / by_length;
        const MUS__REAL keep = speed > loss ? kept : 0, part = length > back ? taken : 1;
        const MUS__REAL off = along < 0 ? -along : along;
        const int32_t rubs = vn < 0, held = (part == 1) & (off <= (MUS__REAL)MUS__STICK_BAND);
        const MUS__REAL r0 = held ? f0 : p0 - part * w0, r1 = held ? f1 : p1 - part * w1,
                        r2 = held ? f2 : p2 - part * w2;
        const MUS__REAL q0 = rubs ? r0 : p0, q1 = rubs ? r1 : p1, q2 = rubs ? r2 : p2;
        x[i] = q0, x[MUS__CHUNK + i] = q1, x[2 * MUS__CHUNK + i] = q2;
        v[i] = rubs ? keep * t0 : v0;
        v[MUS__CHUNK + i] = rubs ? keep * t1 : v1;
        v[2 * MUS__CHUNK + i] = rubs ? keep * t2 : v2;
        moved[i] = (q0 - x0) * (q0 - x0) + (q1 - x1) * (q1 - x1) + (q2 - x2) * (q2 - x2);
    }
}


/* how far it may go until it is asked again: `cache` gets the gaps of a node that contact has moved */
static inline void MUS__NAME(distance_cache_set)(const MUS__NAME(gaps) * gaps, MUS__REAL moved2,
                                                 mus__distance_cache *cache)
{
    const int32_t all = gaps->all > 0;
    cache->slack = (float)((all ? gaps->all : gaps->some) / MUS__CACHE_DIVISOR - (MUS__REAL)MUS__NAME(sqrt)(moved2));
    cache->parts = all ? MUS__CACHE_ALL : (uint32_t)gaps->far & ~MUS__CACHE_ALL;
}


/* node i of a block that starts at node `start`, in the boxes `boxes` and near the parts `in`: what is to be done with
 * it. One that touches one part goes on the list */
static int32_t MUS__NAME(classify_node)(const mus__contact_rule *rule, const MUS__NAME(surfaces) * surfaces,
                                        MUS__REAL clearance, int64_t n, int32_t start, int32_t i, uint64_t boxes,
                                        uint64_t in, const MUS__NAME(query_batch) * batch, const MUS__REAL *before,
                                        const MUS__REAL *x, const MUS__REAL *v, mus__distance_cache *cache,
                                        MUS__NAME(single_contacts) * single)
{
    const MUS__REAL band = clearance + (MUS__REAL)MUS__TOUCH_BAND, gap = surfaces->margin - clearance;
    const int32_t m = single->count;
    MUS__NAME(gaps) *gaps = &single->gaps[m];
    const MUS__NAME(query_result) *hit = NULL;
    int32_t hits = 0;
    *gaps = (MUS__NAME(gaps)){gap, gap, boxes & ~in & (((uint64_t)1 << MUS__CACHE_PARTS) - 1)};
    for (int32_t k = batch->head[i]; k > 0; k = batch->answer[k].next) {
        const MUS__NAME(query_result) *answer = &batch->answer[k];
        in &= ~((uint64_t)1 << answer->part);
        MUS__NAME(gaps_note)(gaps, answer->part, -answer->depth - clearance);
        if (!(answer->depth > -band)) continue;
        hit = answer;
        hits++;
    }
    if (in != 0 || hits > 1) return MUS__TOUCH_OTHER;
    if (hits == 0) {
        if (cache->slack <= 0) MUS__NAME(distance_cache_set)(gaps, 0, cache);
        return MUS__TOUCH_NONE;
    }

    const MUS__NAME(motion) *way = MUS__NAME(motion_of)(surfaces, hit->part);
    const int64_t at = start + i;
    MUS__REAL p[3], w[3], old[3], from[3], speed[3], push = hit->depth + clearance;
    for (int32_t d = 0; d < 3; d++) p[d] = x[d * n + at], w[d] = v[d * n + at], old[d] = before[d * n + at];
    if (way != NULL) MUS__NAME(carry_node)(way, old, p, from, speed);
    single->overlap[m] = push;
    for (int32_t d = 0; d < 3; d++) {
        const int32_t k = d * MUS__CHUNK + m;
        if (way != NULL) w[d] -= speed[d];
        single->normal[k] = hit->normal[d];
        single->x[k] = p[d];
        single->from[k] = way != NULL ? from[d] : old[d];
        single->v[k] = w[d];
        single->speed[k] = way != NULL ? speed[d] : 0;
    }

    /* what it is pushed out of may push it into another surface */
    if (push > (MUS__REAL)MUS__PUSH_FAR) push = MUS__NAME(push_length)(rule, push, w);
    if (push > (MUS__REAL)MUS__PUSH_FAR && boxes != (uint64_t)1 << hit->part) return MUS__TOUCH_OTHER;
    for (int32_t k = batch->head[i]; k > 0; k = batch->answer[k].next) {
        const MUS__NAME(query_result) *answer = &batch->answer[k];
        if (answer->depth + clearance - push * MUS__NAME(dot)(answer->normal, hit->normal) > 0 && answer != hit)
            return MUS__TOUCH_OTHER;
    }
    single->count++;
    return MUS__TOUCH_ONE_PART;
}


/* the m-th of the list, which is node i: places and velocities (3 x n) as contact leaves them */
static inline void MUS__NAME(store_single)(const MUS__NAME(single_contacts) * single, int32_t m, int32_t moving,
                                           int64_t n, int64_t i, MUS__REAL inverse, mus__distance_cache *cache,
                                           MUS__REAL *x, MUS__REAL *v, mus__contact_tally *tally)
{
    const double mass = 1.0 / (double)inverse;
    if (cache->slack <= 0) MUS__NAME(distance_cache_set)(&single->gaps[m], single->moved[m], cache);
    for (int32_t d = 0; d < 3; d++) {
        const int32_t k = d * MUS__CHUNK + m;
        const MUS__REAL w = moving ? single->v[k] + single->speed[k] : single->v[k];
        tally->impulse[d] += ((double)w - (double)v[d * n + i]) * mass;
        x[d * n + i] = single->x[k];
        v[d * n + i] = w;
    }
}
