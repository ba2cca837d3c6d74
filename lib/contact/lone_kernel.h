/*
 * lone_kernel.h: the response of nodes that touch one part and nothing else, many at once, a part of contact_kernel.h.
 *
 * That is nearly every node that touches at all. The text of respond() and rub() for places in a row, without a branch,
 * so that it is made for as many nodes at once as the vector unit is wide; the same operations in the same order, so
 * the same bits. What touches several surfaces, or a plane, is left to touch().
 */

/* what contact is to do with a node of a block */
#define LONE_NOTHING 0
#define LONE_ONE 1
#define LONE_ODD 2

typedef struct MUS_FIELD(lone) {
    int32_t count;
    MUS_REAL lift[ASK_BLOCK], moved[ASK_BLOCK];
    MUS_REAL normal[3 * ASK_BLOCK], from[3 * ASK_BLOCK], speed[3 * ASK_BLOCK];
    MUS_REAL x[3 * ASK_BLOCK], v[3 * ASK_BLOCK]; /* v relative to the surface */
    MUS_FIELD(gaps) gaps[ASK_BLOCK];
    uint8_t kind[ASK_BLOCK]; /* of every node of the block */
} MUS_FIELD(lone);


/* respond() of contact_kernel.h for `count` nodes in place, and the square of how far each was moved */
MUS_CLONES
static void MUS_FIELD(respond_many)(MUS_REAL friction, MUS_REAL push, MUS_REAL time, MUS_REAL slip, int32_t count,
                                    const MUS_REAL *restrict lifts, const MUS_REAL *restrict normal,
                                    const MUS_REAL *restrict from, MUS_REAL *restrict x, MUS_REAL *restrict v,
                                    MUS_REAL *restrict moved)
{
    MUS_IVDEP
    for (int32_t i = 0; i < count; i++) {
        const MUS_REAL n0 = normal[i], n1 = normal[ASK_BLOCK + i], n2 = normal[2 * ASK_BLOCK + i], lift = lifts[i];
        const MUS_REAL v0 = v[i], v1 = v[ASK_BLOCK + i], v2 = v[2 * ASK_BLOCK + i];
        const MUS_REAL x0 = x[i], x1 = x[ASK_BLOCK + i], x2 = x[2 * ASK_BLOCK + i];
        const MUS_REAL vn = v0 * n0 + v1 * n1 + v2 * n2, inward = vn < 0 ? -vn : 0;
        const MUS_REAL go = time * (MUS_REAL)MUS_FIELD(sqrt)(v0 * v0 + v1 * v1 + v2 * v2);
        const MUS_REAL partly = push + inward * slip, whole = lift <= push + go ? lift : partly;
        const MUS_REAL move = lift < 0 ? 0 : whole;
        const MUS_REAL p0 = x0 + move * n0, p1 = x1 + move * n1, p2 = x2 + move * n2;

        /* friction */
        const MUS_REAL f0 = from[i], f1 = from[ASK_BLOCK + i], f2 = from[2 * ASK_BLOCK + i];
        const MUS_REAL t0 = v0 + inward * n0, t1 = v1 + inward * n1, t2 = v2 + inward * n2;
        const MUS_REAL d0 = p0 - f0, d1 = p1 - f1, d2 = p2 - f2, along = d0 * n0 + d1 * n1 + d2 * n2;
        const MUS_REAL w0 = d0 - along * n0, w1 = d1 - along * n1, w2 = d2 - along * n2;
        const MUS_REAL speed = (MUS_REAL)MUS_FIELD(sqrt)(t0 * t0 + t1 * t1 + t2 * t2);
        const MUS_REAL length = (MUS_REAL)MUS_FIELD(sqrt)(w0 * w0 + w1 * w1 + w2 * w2);
        const MUS_REAL loss = friction * inward, back = slip > 0 ? loss * slip : 0;
        const MUS_REAL by_speed = speed > loss ? speed : 1, by_length = length > back ? length : 1;
        const MUS_REAL kept = (speed - loss) / by_speed, taken = back / by_length;
        const MUS_REAL keep = speed > loss ? kept : 0, part = length > back ? taken : 1;
        const MUS_REAL off = along < 0 ? -along : along;
        const int32_t rubs = vn < 0, held = (part == 1) & (off <= (MUS_REAL)HELD_BAND);
        const MUS_REAL r0 = held ? f0 : p0 - part * w0, r1 = held ? f1 : p1 - part * w1,
                       r2 = held ? f2 : p2 - part * w2;
        const MUS_REAL q0 = rubs ? r0 : p0, q1 = rubs ? r1 : p1, q2 = rubs ? r2 : p2;
        x[i] = q0, x[ASK_BLOCK + i] = q1, x[2 * ASK_BLOCK + i] = q2;
        v[i] = rubs ? keep * t0 : v0;
        v[ASK_BLOCK + i] = rubs ? keep * t1 : v1;
        v[2 * ASK_BLOCK + i] = rubs ? keep * t2 : v2;
        moved[i] = (q0 - x0) * (q0 - x0) + (q1 - x1) * (q1 - x1) + (q2 - x2) * (q2 - x2);
    }
}


/* how far it may go until it is asked again: `aside` gets the gaps of a node that contact has moved */
static inline void MUS_FIELD(set_aside)(const MUS_FIELD(gaps) * gaps, MUS_REAL moved2, mus__aside *aside)
{
    const int32_t all = gaps->all > 0;
    aside->slack = (float)((all ? gaps->all : gaps->some) / ASIDE_SAFE - (MUS_REAL)MUS_FIELD(sqrt)(moved2));
    aside->parts = all ? ASIDE_ALL : (uint32_t)gaps->far & ~ASIDE_ALL;
}


/* node i of a block that starts at node `start`, in the boxes `boxes` and near the parts `in`: what is to be done with
 * it. One that touches one part goes on the list */
static int32_t MUS_FIELD(sort_node)(const mus__contact_rule *rule, const MUS_FIELD(scene) * scene, MUS_REAL clearance,
                                    int64_t n, int32_t start, int32_t i, uint64_t boxes, uint64_t in,
                                    const MUS_FIELD(asking) * asking, const MUS_REAL *before, const MUS_REAL *x,
                                    const MUS_REAL *v, mus__aside *aside, MUS_FIELD(lone) * lone)
{
    const MUS_REAL band = clearance + (MUS_REAL)TOUCH_BAND, gap = scene->margin - clearance;
    const int32_t m = lone->count;
    MUS_FIELD(gaps) *gaps = &lone->gaps[m];
    const MUS_FIELD(answer) *hit = NULL;
    int32_t hits = 0;
    *gaps = (MUS_FIELD(gaps)){gap, gap, boxes & ~in & (((uint64_t)1 << ASIDE_PARTS) - 1)};
    for (int32_t k = asking->head[i]; k > 0; k = asking->answer[k].next) {
        const MUS_FIELD(answer) *answer = &asking->answer[k];
        in &= ~((uint64_t)1 << answer->part);
        MUS_FIELD(gap)(gaps, answer->part, -answer->depth - clearance);
        if (!(answer->depth > -band)) continue;
        hit = answer;
        hits++;
    }
    if (in != 0 || hits > 1) return LONE_ODD;
    if (hits == 0) {
        if (aside->slack <= 0) MUS_FIELD(set_aside)(gaps, 0, aside);
        return LONE_NOTHING;
    }

    const MUS_FIELD(way) *way = MUS_FIELD(way_of)(scene, hit->part);
    const int64_t at = start + i;
    MUS_REAL p[3], w[3], old[3], from[3], speed[3], push = hit->depth + clearance;
    for (int32_t d = 0; d < 3; d++) p[d] = x[d * n + at], w[d] = v[d * n + at], old[d] = before[d * n + at];
    if (way != NULL) MUS_FIELD(carry)(way, old, p, from, speed);
    lone->lift[m] = push;
    for (int32_t d = 0; d < 3; d++) {
        const int32_t k = d * ASK_BLOCK + m;
        if (way != NULL) w[d] -= speed[d];
        lone->normal[k] = hit->normal[d];
        lone->x[k] = p[d];
        lone->from[k] = way != NULL ? from[d] : old[d];
        lone->v[k] = w[d];
        lone->speed[k] = way != NULL ? speed[d] : 0;
    }

    /* what it is pushed out of may push it into another surface */
    if (push > (MUS_REAL)PUSH_FAR) push = MUS_FIELD(push_far)(rule, push, w);
    if (push > (MUS_REAL)PUSH_FAR && boxes != (uint64_t)1 << hit->part) return LONE_ODD;
    for (int32_t k = asking->head[i]; k > 0; k = asking->answer[k].next) {
        const MUS_FIELD(answer) *answer = &asking->answer[k];
        if (answer->depth + clearance - push * MUS_FIELD(dot)(answer->normal, hit->normal) > 0 && answer != hit)
            return LONE_ODD;
    }
    lone->count++;
    return LONE_ONE;
}


/* the m-th of the list, which is node i: places and velocities (3 x n) as contact leaves them */
static inline void MUS_FIELD(put_lone)(const MUS_FIELD(lone) * lone, int32_t m, int32_t moving, int64_t n, int64_t i,
                                       MUS_REAL inverse, mus__aside *aside, MUS_REAL *x, MUS_REAL *v,
                                       mus__contact_tally *tally)
{
    const double mass = 1.0 / (double)inverse;
    if (aside->slack <= 0) MUS_FIELD(set_aside)(&lone->gaps[m], lone->moved[m], aside);
    for (int32_t d = 0; d < 3; d++) {
        const int32_t k = d * ASK_BLOCK + m;
        const MUS_REAL w = moving ? lone->v[k] + lone->speed[k] : lone->v[k];
        tally->impulse[d] += ((double)w - (double)v[d * n + i]) * mass;
        x[d * n + i] = lone->x[k];
        v[d * n + i] = w;
    }
}
