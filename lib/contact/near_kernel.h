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
#define NEAR_MOST 8 /* surfaces that a node touches at once; more are left out */

typedef struct MUS_FIELD(near_rule) {
    MUS_REAL clearance, friction, push, deep, time, slip, ball;
} MUS_FIELD(near_rule);


/* how far something that is `lift` inside comes out in a call */
static MUS_INLINE MUS_REAL MUS_FIELD(near_push)(MUS_FIELD(near_rule) rule, MUS_REAL lift)
{
    const MUS_REAL over = lift - (MUS_REAL)MUS_NEAR_DEEP;
    return rule.push + rule.deep * (over > 0 ? over : 0);
}


/*
 * What a touch makes of place and velocity, `touch` 1 or 0. Put back by `lift`, whole if the last step brought it in,
 * else by `push`; the velocity into the skin is lost, the sliding shrinks by mu |v_n|, and the way slid is taken back.
 */
static MUS_INLINE void MUS_FIELD(near_respond)(MUS_FIELD(near_rule) rule, MUS_REAL touch, MUS_REAL lift,
                                               const MUS_REAL *normal, MUS_REAL *x, MUS_REAL *v)
{
    const MUS_REAL vn = v[0] * normal[0] + v[1] * normal[1] + v[2] * normal[2];
    const MUS_REAL inward = vn < 0 ? -vn : 0;
    const MUS_REAL push = MUS_FIELD(near_push)(rule, lift), partly = push + inward * rule.slip;
    const MUS_REAL out = lift <= push + inward * rule.time ? lift : partly;
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


/* one node against the several surfaces that it touches, in place: as respond_all of contact_kernel.h, the way slid
 * being taken from the velocity as near_respond() takes it */
static void MUS_FIELD(near_respond_all)(MUS_FIELD(near_rule) rule, const MUS_FIELD(meeting) * list, int32_t count,
                                        MUS_REAL *x, MUS_REAL *v)
{
    MUS_REAL wish[NEAR_MOST], share[NEAR_MOST], move[3], deepest = 0;
    for (int32_t i = 0; i < count; i++) wish[i] = list[i].lift, deepest = wish[i] > deepest ? wish[i] : deepest;
    const MUS_REAL fast = (MUS_REAL)MUS_SQRT(MUS_FIELD(dot)(v, v)), push = MUS_FIELD(near_push)(rule, deepest);
    const MUS_REAL most = push + fast * rule.slip;
    MUS_FIELD(out_of_all)(list, count, wish, most, move, share);
    const MUS_REAL far = (MUS_REAL)MUS_SQRT(MUS_FIELD(dot)(move, move));
    const MUS_REAL scale = far <= push + fast * rule.time ? 1 : most / far;
    for (int32_t d = 0; d < 3; d++) x[d] += scale * move[d];

    for (int32_t i = 0; i < count; i++) wish[i] = -MUS_FIELD(dot)(v, list[i].normal);
    MUS_FIELD(out_of_all)(list, count, wish, fast, move, share);
    for (int32_t d = 0; d < 3; d++) v[d] += move[d];
    for (int32_t i = 0; i < count; i++) {
        if (!(share[i] > 0)) continue;
        const MUS_REAL out = MUS_FIELD(dot)(v, list[i].normal);
        MUS_REAL t[3];
        for (int32_t d = 0; d < 3; d++) t[d] = v[d] - out * list[i].normal[d];
        const MUS_REAL speed = (MUS_REAL)MUS_SQRT(MUS_FIELD(dot)(t, t)), loss = list[i].friction * share[i];
        const MUS_REAL lost = speed > loss ? loss / speed : 1;
        for (int32_t d = 0; d < 3; d++) v[d] -= lost * t[d], x[d] -= rule.slip * lost * t[d];
    }
}


/* what asks a node of the surfaces finds: those that it touches, and the two nearest of all */
typedef struct MUS_FIELD(near_found) {
    MUS_FIELD(meeting) list[NEAR_MOST];
    int32_t count, strange; /* strange: it touches a plane with a friction of its own */
    MUS_REAL first, second, normal[3];
} MUS_FIELD(near_found);


static inline void MUS_FIELD(near_note)(MUS_FIELD(near_found) * found, MUS_REAL lift, MUS_REAL friction, MUS_REAL depth,
                                        const MUS_REAL *normal)
{
    if (depth > found->first) {
        found->second = found->first, found->first = depth;
        for (int32_t d = 0; d < 3; d++) found->normal[d] = normal[d];
    } else if (depth > found->second) {
        found->second = depth;
    }
    if (!(lift > -(MUS_REAL)NEAR_BAND) || found->count == NEAR_MOST) return;
    MUS_FIELD(meeting) *m = &found->list[found->count++];
    m->lift = lift, m->friction = friction;
    for (int32_t d = 0; d < 3; d++) m->normal[d] = normal[d];
}


/* one node asked of all surfaces, in place; what it is to remember goes to plane (8, a stride of n) */
static void MUS_FIELD(near_ask)(const mus__collider *collider, MUS_FIELD(near_rule) rule,
                                const MUS_FIELD(scene) * scene, int64_t n, MUS_REAL *plane, MUS_REAL *p, MUS_REAL *w,
                                int64_t *queries)
{
    const MUS_REAL ball = rule.ball, margin = scene->margin, *box = scene->box;
    MUS_FIELD(near_found) found;
    int32_t near;
    found.count = found.strange = 0;
    found.first = found.second = -margin;
    for (int32_t d = 0; d < 3; d++) found.normal[d] = 0, plane[(4 + d) * n] = p[d];
    for (int32_t l = 0; l < collider->nlimb; l++, box += 6) {
        if (p[0] < box[0] || p[0] > box[3] || p[1] < box[1] || p[1] > box[4] || p[2] < box[2] || p[2] > box[5])
            continue;
        MUS_REAL normal[3];
        const MUS_REAL depth = MUS_FIELD(query)(&collider->MUS_FIELDS[l], p, margin, normal, &near);
        (*queries)++;
        if (near) MUS_FIELD(near_note)(&found, depth + rule.clearance, rule.friction, depth, normal);
    }
    for (int32_t k = 0; k < scene->nplane; k++) {
        const MUS_FIELD(flat) *flat = &scene->flat[k];
        const MUS_REAL depth = MUS_FIELD(flat_depth)(flat, p, margin, &near);
        (*queries)++;
        MUS_FIELD(near_note)(&found, near ? depth + rule.clearance : -1, flat->friction, depth, flat->normal);
        if (depth > -4 * ball && flat->friction != rule.friction) found.strange = 1;
    }
    if (found.count == 1) {
        MUS_FIELD(near_rule) own = rule;
        own.friction = found.list[0].friction;
        MUS_FIELD(near_respond)(own, 1, found.list[0].lift, found.list[0].normal, p, w);
    } else if (found.count > 1) {
        MUS_FIELD(near_respond_all)(rule, found.list, found.count, p, w);
    }

    /* far off: no plane, half the distance. Near one surface: its plane. Near two, or deep inside: asked every time */
    const MUS_REAL off = -found.first - rule.clearance, other = -found.second - rule.clearance, half = off / 2;
    const int32_t far = off > 2 * ball, plain = off > -4 * ball && other > 2 * ball && !found.strange;
    for (int32_t d = 0; d < 3; d++) plane[d * n] = far ? 0 : found.normal[d];
    plane[3 * n] = far ? -1 : found.first;
    plane[7 * n] = far ? half * half : plain ? ball * ball : -1;
}


void MUS_NEAR(const mus__collider *collider, const mus__contact_rule *rule, int32_t n, int32_t first, int32_t last,
              const MUS_REAL *inverse, MUS_REAL *near, MUS_REAL *x, MUS_REAL *v, mus__contact_tally *tally)
{
    const MUS_FIELD(near_rule) own = {(MUS_REAL)(rule->clearance - collider->skin),
                                      (MUS_REAL)rule->friction,
                                      (MUS_REAL)rule->push,
                                      (MUS_REAL)(rule->deep * rule->step),
                                      (MUS_REAL)rule->step,
                                      (MUS_REAL)rule->slip,
                                      (MUS_REAL)rule->ball};
    MUS_FIELD(scene) scene;
    MUS_REAL stale[NEAR_BLOCK];
    MUS_FIELD(fill_scene)(collider, rule, own.clearance + (MUS_REAL)NEAR_MARGIN, &scene);

    if (MUS_RUSH(collider, rule, n, first, last, v)) tally->swift = 1;
    for (int32_t start = first; start < last; start += NEAR_BLOCK) {
        const int32_t count = last - start < NEAR_BLOCK ? last - start : NEAR_BLOCK;
        MUS_FIELD(near_planes)(own, n, count, inverse + start, near + start, x + start, v + start, stale);
        for (int32_t i = start; i < start + count; i++) {
            if (stale[i - start] == 0) continue;
            MUS_REAL p[3], w[3];
            for (int64_t d = 0; d < 3; d++) p[d] = x[d * n + i], w[d] = v[d * n + i];
            MUS_FIELD(near_ask)(collider, own, &scene, n, near + i, p, w, &tally->queries);
            for (int64_t d = 0; d < 3; d++) x[d * n + i] = p[d], v[d * n + i] = w[d];
        }
    }
}
