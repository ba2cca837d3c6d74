/*
 * plane_cache_kernel.h: cache.h as a template on the floating type (MUS__REAL, MUS__NAME, MUS__PART_FIELDS, MUS_NEAR,
 * MUS_RUSH, MUS_SQRT).
 *
 * A block of nodes is first taken as planes, all alike and without a branch; those that left their ball are marked and
 * then asked one by one.
 */

#define MUS__CACHE_BAND 2e-6   /* [m] a node this cache to the clearance is still on the skin: float rounds by as much \
                                */
#define MUS__CACHE_MARGIN 0.04 /* [m]: how far off the body a distance is still taken */
#define MUS__CACHE_CHUNK 256
#define MUS__CACHE_MANIFOLD_MAX 8 /* surfaces that a node touches at once; more are left out */

typedef struct MUS__NAME(cache_rule) {
    MUS__REAL clearance, friction, push, deep, time, slip, ball;
} MUS__NAME(cache_rule);


/* how far something that is `overlap` inside comes out in a call */
static MUS_INLINE MUS__REAL MUS__NAME(cache_push)(MUS__NAME(cache_rule) rule, MUS__REAL overlap)
{
    const MUS__REAL over = overlap - (MUS__REAL)MUS__CACHE_DEEP;
    return rule.push + rule.deep * (over > 0 ? over : 0);
}


/*
 * What a touch makes of place and velocity, `touch` 1 or 0. Put back by `overlap`, whole if the last step brought it
 * in, else by `push`; the velocity into the skin is lost, the sliding shrinks by mu |v_n|, and the way slid is taken
 * back.
 */
static MUS_INLINE void MUS__NAME(cache_respond)(MUS__NAME(cache_rule) rule, MUS__REAL touch, MUS__REAL overlap,
                                                const MUS__REAL *normal, MUS__REAL *x, MUS__REAL *v)
{
    const MUS__REAL vn = v[0] * normal[0] + v[1] * normal[1] + v[2] * normal[2];
    const MUS__REAL inward = vn < 0 ? -vn : 0;
    const MUS__REAL push = MUS__NAME(cache_push)(rule, overlap), partly = push + inward * rule.slip;
    const MUS__REAL out = overlap <= push + inward * rule.time ? overlap : partly;
    const MUS__REAL move = touch * (overlap > 0 ? out : 0);

    const MUS__REAL t0 = v[0] + inward * normal[0], t1 = v[1] + inward * normal[1], t2 = v[2] + inward * normal[2];
    const MUS__REAL speed = (MUS__REAL)MUS__NAME(sqrt)(t0 * t0 + t1 * t1 + t2 * t2 + (MUS__REAL)1e-30);
    const MUS__REAL less = speed - rule.friction * inward;
    const MUS__REAL stop = touch * (vn < 0 ? 1 : 0), keep = less > 0 ? less / speed : 0;
    const MUS__REAL lost = stop * (1 - keep), back = rule.slip * lost;
    x[0] += move * normal[0] - back * t0, x[1] += move * normal[1] - back * t1, x[2] += move * normal[2] - back * t2;
    const MUS__REAL into = stop * inward;
    v[0] += into * normal[0] - lost * t0, v[1] += into * normal[1] - lost * t1, v[2] += into * normal[2] - lost * t2;
}


/* a block as planes; stale (count) gets 1 where a node left its ball */
MUS_CLONES
static void MUS__NAME(cache_chunk)(MUS__NAME(cache_rule) rule, int64_t n, int32_t count,
                                   const MUS__REAL *restrict inverse, const MUS__REAL *restrict cache,
                                   MUS__REAL *restrict x, MUS__REAL *restrict v, MUS__REAL *restrict stale)
{
    const MUS__REAL band = rule.clearance + (MUS__REAL)MUS__CACHE_BAND;
    MUS_IVDEP
    for (int32_t i = 0; i < count; i++) {
        const MUS__REAL normal[3] = {cache[i], cache[n + i], cache[2 * n + i]};
        const MUS__REAL d0 = x[i] - cache[4 * n + i], d1 = x[n + i] - cache[5 * n + i],
                        d2 = x[2 * n + i] - cache[6 * n + i];
        const MUS__REAL depth = cache[3 * n + i] - (normal[0] * d0 + normal[1] * d1 + normal[2] * d2);
        const MUS__REAL moves = inverse[i] > 0 ? 1 : 0, away = d0 * d0 + d1 * d1 + d2 * d2 <= cache[7 * n + i] ? 0 : 1;
        const MUS__REAL touch = moves * (1 - away) * (depth > -band ? 1 : 0);
        MUS__REAL p[3] = {x[i], x[n + i], x[2 * n + i]}, w[3] = {v[i], v[n + i], v[2 * n + i]};
        MUS__NAME(cache_respond)(rule, touch, depth + rule.clearance, normal, p, w);
        x[i] = p[0], x[n + i] = p[1], x[2 * n + i] = p[2];
        v[i] = w[0], v[n + i] = w[1], v[2 * n + i] = w[2];
        stale[i] = moves * away;
    }
}


/* one node against the several surfaces that it touches, in place: as respond_all of contact_kernel.h, the way slid
 * being taken from the velocity as cache_respond() takes it */
static void MUS__NAME(cache_respond_manifold)(MUS__NAME(cache_rule) rule, const MUS__NAME(contact) * list,
                                              int32_t count, MUS__REAL *x, MUS__REAL *v)
{
    MUS__REAL target[MUS__CACHE_MANIFOLD_MAX], multiplier[MUS__CACHE_MANIFOLD_MAX], move[3], deepest = 0;
    for (int32_t i = 0; i < count; i++)
        target[i] = list[i].overlap, deepest = target[i] > deepest ? target[i] : deepest;
    const MUS__REAL fast = (MUS__REAL)MUS__NAME(sqrt)(MUS__NAME(dot)(v, v)),
                    push = MUS__NAME(cache_push)(rule, deepest);
    const MUS__REAL most = push + fast * rule.slip;
    MUS__NAME(manifold_solve)(list, count, target, most, move, multiplier);
    const MUS__REAL far = (MUS__REAL)MUS__NAME(sqrt)(MUS__NAME(dot)(move, move));
    const MUS__REAL scale = far <= push + fast * rule.time ? 1 : most / far;
    for (int32_t d = 0; d < 3; d++) x[d] += scale * move[d];

    for (int32_t i = 0; i < count; i++) target[i] = -MUS__NAME(dot)(v, list[i].normal);
    MUS__NAME(manifold_solve)(list, count, target, fast, move, multiplier);
    for (int32_t d = 0; d < 3; d++) v[d] += move[d];
    for (int32_t i = 0; i < count; i++) {
        if (!(multiplier[i] > 0)) continue;
        const MUS__REAL out = MUS__NAME(dot)(v, list[i].normal);
        MUS__REAL t[3];
        for (int32_t d = 0; d < 3; d++) t[d] = v[d] - out * list[i].normal[d];
        const MUS__REAL speed = (MUS__REAL)MUS__NAME(sqrt)(MUS__NAME(dot)(t, t)),
                        loss = list[i].friction * multiplier[i];
        const MUS__REAL lost = speed > loss ? loss / speed : 1;
        for (int32_t d = 0; d < 3; d++) v[d] -= lost * t[d], x[d] -= rule.slip * lost * t[d];
    }
}


/* what asks a node of the surfaces finds: those that it touches, and the two nearest of all */
typedef struct MUS__NAME(cache_found) {
    MUS__NAME(contact) list[MUS__CACHE_MANIFOLD_MAX];
    int32_t count, strange; /* strange: it touches a cache with a friction of its own */
    MUS__REAL first, second, normal[3];
} MUS__NAME(cache_found);


static inline void MUS__NAME(cache_note)(MUS__NAME(cache_found) * found, MUS__REAL overlap, MUS__REAL friction,
                                         MUS__REAL depth, const MUS__REAL *normal)
{
    if (depth > found->first) {
        found->second = found->first, found->first = depth;
        for (int32_t d = 0; d < 3; d++) found->normal[d] = normal[d];
    } else if (depth > found->second) {
        found->second = depth;
    }
    if (!(overlap > -(MUS__REAL)MUS__CACHE_BAND) || found->count == MUS__CACHE_MANIFOLD_MAX) return;
    MUS__NAME(contact) *m = &found->list[found->count++];
    m->overlap = overlap, m->friction = friction;
    for (int32_t d = 0; d < 3; d++) m->normal[d] = normal[d];
}


/* one node asked of all surfaces, in place; what it is to remember goes to cache (8, a stride of n) */
static void MUS__NAME(cache_renew)(const mus__collider *collider, MUS__NAME(cache_rule) rule,
                                   const MUS__NAME(surfaces) * surfaces, int64_t n, MUS__REAL *cache, MUS__REAL *p,
                                   MUS__REAL *w, int64_t *queries)
{
    const MUS__REAL ball = rule.ball, margin = surfaces->margin, *box = surfaces->box;
    MUS__NAME(cache_found) found;
    int32_t near;
    found.count = found.strange = 0;
    found.first = found.second = -margin;
    for (int32_t d = 0; d < 3; d++) found.normal[d] = 0, cache[(4 + d) * n] = p[d];
    for (int32_t l = 0; l < collider->nparts; l++, box += 6) {
        if (p[0] < box[0] || p[0] > box[3] || p[1] < box[1] || p[1] > box[4] || p[2] < box[2] || p[2] > box[5])
            continue;
        MUS__REAL normal[3];
        const MUS__REAL depth = MUS__NAME(field_query)(&collider->MUS__PART_FIELDS[l], p, margin, normal, &near);
        (*queries)++;
        if (near) MUS__NAME(cache_note)(&found, depth + rule.clearance, rule.friction, depth, normal);
    }
    for (int32_t k = 0; k < surfaces->nplane; k++) {
        const MUS__NAME(plane) *plane = &surfaces->plane[k];
        const MUS__REAL depth = MUS__NAME(plane_depth)(plane, p, margin, &near);
        (*queries)++;
        MUS__NAME(cache_note)(&found, near ? depth + rule.clearance : -1, plane->friction, depth, plane->normal);
        if (depth > -4 * ball && plane->friction != rule.friction) found.strange = 1;
    }
    if (found.count == 1) {
        MUS__NAME(cache_rule) own = rule;
        own.friction = found.list[0].friction;
        MUS__NAME(cache_respond)(own, 1, found.list[0].overlap, found.list[0].normal, p, w);
    } else if (found.count > 1) {
        MUS__NAME(cache_respond_manifold)(rule, found.list, found.count, p, w);
    }

    /* far off: no cache, half the distance. Near one surface: its cache. Near two, or deep inside: asked every time */
    const MUS__REAL off = -found.first - rule.clearance, other = -found.second - rule.clearance, half = off / 2;
    const int32_t far = off > 2 * ball, plain = off > -4 * ball && other > 2 * ball && !found.strange;
    for (int32_t d = 0; d < 3; d++) cache[d * n] = far ? 0 : found.normal[d];
    cache[3 * n] = far ? -1 : found.first;
    cache[7 * n] = far ? half * half : plain ? ball * ball : -1;
}


void MUS__NAME(plane_cache_pass)(const mus__collider *collider, const mus__contact_rule *rule, int32_t n, int32_t first,
                                 int32_t last, const MUS__REAL *inverse, MUS__REAL *cache, MUS__REAL *x, MUS__REAL *v,
                                 mus__contact_tally *tally)
{
    const MUS__NAME(cache_rule) own = {(MUS__REAL)(rule->clearance - collider->offset),
                                       (MUS__REAL)rule->friction,
                                       (MUS__REAL)rule->push,
                                       (MUS__REAL)(rule->deep * rule->step),
                                       (MUS__REAL)rule->step,
                                       (MUS__REAL)rule->slip,
                                       (MUS__REAL)rule->cache_radius};
    MUS__NAME(surfaces) surfaces;
    MUS__REAL stale[MUS__CACHE_CHUNK];
    MUS__NAME(fill_surfaces)(collider, rule, own.clearance + (MUS__REAL)MUS__CACHE_MARGIN, &surfaces);

    if (MUS__NAME(contact_any_fast)(collider, rule, n, first, last, v)) tally->fast = 1;
    for (int32_t start = first; start < last; start += MUS__CACHE_CHUNK) {
        const int32_t count = last - start < MUS__CACHE_CHUNK ? last - start : MUS__CACHE_CHUNK;
        MUS__NAME(cache_chunk)(own, n, count, inverse + start, cache + start, x + start, v + start, stale);
        for (int32_t i = start; i < start + count; i++) {
            if (stale[i - start] == 0) continue;
            MUS__REAL p[3], w[3];
            for (int64_t d = 0; d < 3; d++) p[d] = x[d * n + i], w[d] = v[d * n + i];
            MUS__NAME(cache_renew)(collider, own, &surfaces, n, cache + i, p, w, &tally->queries);
            for (int64_t d = 0; d < 3; d++) x[d * n + i] = p[d], v[d * n + i] = w[d];
        }
    }
}
