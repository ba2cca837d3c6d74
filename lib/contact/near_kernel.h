/*
 * near_kernel.h: near.h as a template on the floating type (MUS_REAL, MUS_FIELD, MUS_FIELDS, MUS_NEAR, MUS_RUSH,
 * MUS_SQRT).
 *
 * A block of nodes is first taken as planes, all alike and without a branch; those that left their ball are marked and
 * then asked one by one.
 */

#define NEAR_BAND 2e-6   /* [m] a node this near to the clearance is still on the skin: float rounds by as much */
#define NEAR_MARGIN 0.04 /* [m]: how far off the body a distance is still taken */
#define NEAR_BLOCK 256

typedef struct MUS_FIELD(near_rule) {
    MUS_REAL clearance, friction, push, time, slip, ball;
} MUS_FIELD(near_rule);


/*
 * What a touch makes of place and velocity, `touch` 1 or 0. Put back by `lift`, whole if the last step brought it in,
 * else by `push`; the velocity into the skin is lost, the sliding shrinks by mu |v_n|, and the way slid is taken back.
 */
static MUS_INLINE void MUS_FIELD(near_respond)(MUS_FIELD(near_rule) rule, MUS_REAL touch, MUS_REAL lift,
                                               const MUS_REAL *normal, MUS_REAL *x, MUS_REAL *v)
{
    const MUS_REAL vn = v[0] * normal[0] + v[1] * normal[1] + v[2] * normal[2];
    const MUS_REAL inward = vn < 0 ? -vn : 0;
    const MUS_REAL partly = rule.push + inward * rule.slip;
    const MUS_REAL out = lift <= rule.push + inward * rule.time ? lift : partly;
    const MUS_REAL move = touch * (lift > 0 ? out : 0);

    const MUS_REAL t0 = v[0] + inward * normal[0], t1 = v[1] + inward * normal[1], t2 = v[2] + inward * normal[2];
    const MUS_REAL speed = (MUS_REAL)MUS_SQRT(t0 * t0 + t1 * t1 + t2 * t2 + (MUS_REAL)1e-30);
    const MUS_REAL less = speed - rule.friction * inward;
    const MUS_REAL stop = touch * (vn < 0 ? 1 : 0), keep = less > 0 ? less / speed : 0;
    const MUS_REAL lost = stop * (1 - keep), back = rule.slip * lost;
    x[0] += move * normal[0] - back * t0, x[1] += move * normal[1] - back * t1, x[2] += move * normal[2] - back * t2;
    const MUS_REAL into = stop * inward;
    v[0] += into * normal[0] - lost * t0, v[1] += into * normal[1] - lost * t1, v[2] += into * normal[2] - lost * t2;
}


/* a block as planes; stale (count) gets 1 where a node left its ball */
MUS_CLONES
static void MUS_FIELD(near_planes)(MUS_FIELD(near_rule) rule, int64_t n, int32_t count,
                                   const MUS_REAL *restrict inverse, const MUS_REAL *restrict near,
                                   MUS_REAL *restrict x, MUS_REAL *restrict v, MUS_REAL *restrict stale)
{
    const MUS_REAL band = rule.clearance + (MUS_REAL)NEAR_BAND;
    MUS_IVDEP
    for (int32_t i = 0; i < count; i++) {
        const MUS_REAL normal[3] = {near[i], near[n + i], near[2 * n + i]};
        const MUS_REAL d0 = x[i] - near[4 * n + i], d1 = x[n + i] - near[5 * n + i],
                       d2 = x[2 * n + i] - near[6 * n + i];
        const MUS_REAL depth = near[3 * n + i] - (normal[0] * d0 + normal[1] * d1 + normal[2] * d2);
        const MUS_REAL moves = inverse[i] > 0 ? 1 : 0, away = d0 * d0 + d1 * d1 + d2 * d2 <= near[7 * n + i] ? 0 : 1;
        const MUS_REAL touch = moves * (1 - away) * (depth > -band ? 1 : 0);
        MUS_REAL p[3] = {x[i], x[n + i], x[2 * n + i]}, w[3] = {v[i], v[n + i], v[2 * n + i]};
        MUS_FIELD(near_respond)(rule, touch, depth + rule.clearance, normal, p, w);
        x[i] = p[0], x[n + i] = p[1], x[2 * n + i] = p[2];
        v[i] = w[0], v[n + i] = w[1], v[2 * n + i] = w[2];
        stale[i] = moves * away;
    }
}


/* one node asked of all limbs, in place; what it is to remember goes to plane (8, a stride of n) */
static void MUS_FIELD(near_ask)(const mus__collider *collider, MUS_FIELD(near_rule) rule, const MUS_REAL *box,
                                MUS_REAL margin, int64_t n, MUS_REAL *plane, MUS_REAL *p, MUS_REAL *w, int64_t *queries)
{
    const MUS_REAL band = rule.clearance + (MUS_REAL)NEAR_BAND, ball = rule.ball;
    MUS_REAL first = -margin, second = -margin, keep[3] = {0, 0, 0};
    for (int32_t d = 0; d < 3; d++) plane[(4 + d) * n] = p[d];
    for (int32_t l = 0; l < collider->nlimb; l++, box += 6) {
        if (p[0] < box[0] || p[0] > box[3] || p[1] < box[1] || p[1] > box[4] || p[2] < box[2] || p[2] > box[5])
            continue;
        MUS_REAL normal[3];
        int32_t near;
        const MUS_REAL depth = MUS_FIELD(query)(&collider->MUS_FIELDS[l], p, margin, normal, &near);
        (*queries)++;
        if (near == 0) continue;
        if (depth > first) {
            second = first, first = depth;
            for (int32_t d = 0; d < 3; d++) keep[d] = normal[d];
        } else if (depth > second) {
            second = depth;
        }
        if (depth > -band) MUS_FIELD(near_respond)(rule, 1, depth + rule.clearance, normal, p, w);
    }

    /* far off: no plane, half the distance. Near one limb: its plane. Near two, or deep inside: asked every time */
    const MUS_REAL off = -first - rule.clearance, other = -second - rule.clearance, half = off / 2;
    const int32_t far = off > 2 * ball, plain = off > -4 * ball && other > 2 * ball;
    for (int32_t d = 0; d < 3; d++) plane[d * n] = far ? 0 : keep[d];
    plane[3 * n] = far ? -1 : first;
    plane[7 * n] = far ? half * half : plain ? ball * ball : -1;
}


void MUS_NEAR(const mus__collider *collider, const mus__contact_rule *rule, int32_t n, int32_t first, int32_t last,
              const MUS_REAL *inverse, MUS_REAL *near, MUS_REAL *x, MUS_REAL *v, mus__contact_tally *tally)
{
    const MUS_FIELD(near_rule) own = {(MUS_REAL)(rule->clearance - collider->skin),
                                      (MUS_REAL)rule->friction,
                                      (MUS_REAL)rule->push,
                                      (MUS_REAL)rule->step,
                                      (MUS_REAL)rule->slip,
                                      (MUS_REAL)rule->ball};
    const MUS_REAL margin = own.clearance + (MUS_REAL)NEAR_MARGIN;
    MUS_REAL box[6 * MUS_LIMBS_MOST], stale[NEAR_BLOCK], shift[3];
    for (int32_t d = 0; d < 3; d++) shift[d] = (MUS_REAL)collider->shift[d];
    for (int32_t k = 0; k < 6 * collider->nlimb; k++)
        box[k] = (MUS_REAL)collider->box[k] + (k % 6 < 3 ? -margin : margin);

    if (MUS_RUSH(collider, rule, n, first, last, v)) tally->swift = 1;
    for (int32_t start = first; start < last; start += NEAR_BLOCK) {
        const int32_t count = last - start < NEAR_BLOCK ? last - start : NEAR_BLOCK;
        MUS_FIELD(near_planes)(own, n, count, inverse + start, near + start, x + start, v + start, stale);
        for (int32_t i = start; i < start + count; i++) {
            if (stale[i - start] == 0) continue;
            MUS_REAL p[3], w[3];
            for (int64_t d = 0; d < 3; d++) p[d] = x[d * n + i] - shift[d], w[d] = v[d * n + i];
            MUS_FIELD(near_ask)(collider, own, box, margin, n, near + i, p, w, &tally->queries);
            for (int64_t d = 0; d < 3; d++) {
                near[(4 + d) * n + i] += shift[d];
                x[d * n + i] = p[d] + shift[d], v[d * n + i] = w[d];
            }
        }
    }
}
