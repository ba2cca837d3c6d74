/*
 * plane_cache_kernel.h: plane_cache.h as a template on the floating type (MUS__REAL, MUS__NAME, MUS__PART_FIELDS).
 *
 * A chunk of nodes is first answered by the cached planes, all alike and without a branch; nodes that left their ball
 * are marked and then asked one by one.
 */

#define MUS__CACHE_BAND 2e-6 /* [m] a node no further than this beyond the clearance touches: rounding of a float */
/* [m] a distance beyond the clearance is measured up to this; chosen: a node further off may move half of it until
 * the next query */
#define MUS__CACHE_MARGIN 0.04
#define MUS__CACHE_CHUNK 256  /* nodes; chosen, as in contact_kernel.h */
#define MUS__CACHE_CONTACTS 8 /* contacts of a node; more are left out */

/* the rule in the pass's precision; deep: share of the depth beyond MUS__CACHE_DEEP put back in this call */
typedef struct MUS__NAME(cache_rule) {
    MUS__REAL clearance, friction, push, deep, time, slip, radius;
} MUS__NAME(cache_rule);


/* how far a node that overlaps by `overlap` is put back in a call */
static MUS_INLINE MUS__REAL MUS__NAME(cache_push)(MUS__NAME(cache_rule) rule, MUS__REAL overlap)
{
    const MUS__REAL over = overlap - (MUS__REAL)MUS__CACHE_DEEP;
    return rule.push + rule.deep * (over > 0 ? over : 0);
}


/*
 * The response to one surface, `touch` 1 or 0: put back by `overlap`, whole if the last step brought the node in, else
 * by the push; the velocity into the surface is lost, friction takes of the sliding. The way slid is not known, since
 * the place before the step is not: it is taken from the velocity that friction took.
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
    const MUS__REAL stop = touch * (vn < 0 ? 1 : 0), keep = MUS__NAME(friction_keep)(speed, rule.friction * inward);
    const MUS__REAL lost = stop * (1 - keep), back = rule.slip * lost;
    x[0] += move * normal[0] - back * t0, x[1] += move * normal[1] - back * t1, x[2] += move * normal[2] - back * t2;
    const MUS__REAL into = stop * inward;
    v[0] += into * normal[0] - lost * t0, v[1] += into * normal[1] - lost * t1, v[2] += into * normal[2] - lost * t2;
}


/* a chunk answered by its planes; left (count) gets 1 where a node left its ball */
MUS_CLONES
static void MUS__NAME(cache_chunk)(MUS__NAME(cache_rule) rule, int64_t n, int32_t count,
                                   const MUS__REAL *restrict inverse, const MUS__REAL *restrict cache,
                                   MUS__REAL *restrict x, MUS__REAL *restrict v, MUS__REAL *restrict left)
{
    const MUS__REAL band = rule.clearance + (MUS__REAL)MUS__CACHE_BAND;
    MUS_IVDEP
    for (int32_t i = 0; i < count; i++) {
        const MUS__REAL normal[3] = {cache[i], cache[n + i], cache[2 * n + i]};
        const MUS__REAL d0 = x[i] - cache[4 * n + i], d1 = x[n + i] - cache[5 * n + i],
                        d2 = x[2 * n + i] - cache[6 * n + i];
        const MUS__REAL depth = cache[3 * n + i] - (normal[0] * d0 + normal[1] * d1 + normal[2] * d2);
        const MUS__REAL one = 1, none = 0, moves = inverse[i] > 0 ? one : none;
        const MUS__REAL away = d0 * d0 + d1 * d1 + d2 * d2 <= cache[7 * n + i] ? none : one;
        const MUS__REAL touch = moves * (1 - away) * (depth > -band ? 1 : 0);
        MUS__REAL p[3] = {x[i], x[n + i], x[2 * n + i]}, w[3] = {v[i], v[n + i], v[2 * n + i]};
        MUS__NAME(cache_respond)(rule, touch, depth + rule.clearance, normal, p, w);
        x[i] = p[0], x[n + i] = p[1], x[2 * n + i] = p[2];
        v[i] = w[0], v[n + i] = w[1], v[2 * n + i] = w[2];
        left[i] = moves * away;
    }
}


/* the response to several surfaces, as respond_manifold(), the way slid being taken as by cache_respond() */
static void MUS__NAME(cache_respond_manifold)(MUS__NAME(cache_rule) rule, const MUS__NAME(contact) * list,
                                              int32_t count, MUS__REAL *x, MUS__REAL *v)
{
    MUS__REAL target[MUS__CACHE_CONTACTS], multiplier[MUS__CACHE_CONTACTS], move[3], deepest = 0;
    for (int32_t i = 0; i < count; i++)
        target[i] = list[i].overlap, deepest = target[i] > deepest ? target[i] : deepest;
    const MUS__REAL fast = (MUS__REAL)MUS__NAME(sqrt)(MUS__NAME(dot)(v, v));
    const MUS__REAL push = MUS__NAME(cache_push)(rule, deepest), most = push + fast * rule.slip;
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
        const MUS__REAL speed = (MUS__REAL)MUS__NAME(sqrt)(MUS__NAME(dot)(t, t));
        const MUS__REAL lost = MUS__NAME(friction_take)(speed, list[i].friction * multiplier[i]);
        for (int32_t d = 0; d < 3; d++) v[d] -= lost * t[d], x[d] -= rule.slip * lost * t[d];
    }
}


/* surfaces near a node: contacts, and the depths of the two nearest surfaces with the normal of the nearest */
typedef struct MUS__NAME(cache_found) {
    MUS__NAME(contact) list[MUS__CACHE_CONTACTS];
    int32_t count, slippery; /* slippery: it is near a plane with a friction of its own */
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
    if (!(overlap > -(MUS__REAL)MUS__CACHE_BAND) || found->count == MUS__CACHE_CONTACTS) return;
    MUS__NAME(contact) *m = &found->list[found->count++];
    m->overlap = overlap, m->friction = friction;
    for (int32_t d = 0; d < 3; d++) m->normal[d] = normal[d];
}


/* all surfaces asked of a node at p; to it the parts are thicker by its lift */
static inline void MUS__NAME(cache_query)(const mus__collider *collider, const MUS__NAME(cache_rule) * rule,
                                          const MUS__NAME(surfaces) * surfaces, MUS__REAL lift, const MUS__REAL *p,
                                          MUS__NAME(cache_found) * found, int64_t *queries)
{
    const MUS__REAL margin = surfaces->margin, *box = surfaces->box;
    int32_t near;
    found->count = found->slippery = 0;
    found->first = found->second = lift - margin;
    for (int32_t d = 0; d < 3; d++) found->normal[d] = 0;
    for (int32_t l = 0; l < collider->nparts; l++, box += 6) {
        if (p[0] < box[0] || p[0] > box[3] || p[1] < box[1] || p[1] > box[4] || p[2] < box[2] || p[2] > box[5])
            continue;
        MUS__REAL normal[3];
        const MUS__REAL depth = MUS__NAME(field_query)(&collider->MUS__PART_FIELDS[l], p, margin, normal, &near) + lift;
        (*queries)++;
        if (near) MUS__NAME(cache_note)(found, depth + rule->clearance, rule->friction, depth, normal);
    }
    for (int32_t k = 0; k < surfaces->nplane; k++) {
        const MUS__NAME(plane) *plane = &surfaces->plane[k];
        const MUS__REAL depth = MUS__NAME(plane_depth)(plane, p, margin, &near);
        (*queries)++;
        MUS__NAME(cache_note)(found, near ? depth + rule->clearance : -1, plane->friction, depth, plane->normal);
        if (depth > -4 * rule->radius && plane->friction != rule->friction) found->slippery = 1;
    }
}


/* one node asked and answered, in place; its new cache (8, a stride of n) */
static void MUS__NAME(cache_renew)(const mus__collider *collider, const MUS__NAME(cache_rule) * rule,
                                   const MUS__NAME(surfaces) * surfaces, MUS__REAL lift, int64_t n, MUS__REAL *cache,
                                   MUS__REAL *p, MUS__REAL *w, int64_t *queries)
{
    const MUS__REAL radius = rule->radius;
    MUS__NAME(cache_found) found;
    for (int32_t d = 0; d < 3; d++) cache[(4 + d) * n] = p[d];
    MUS__NAME(cache_query)(collider, rule, surfaces, lift, p, &found, queries);
    if (found.count == 1) {
        MUS__NAME(cache_rule) own = *rule;
        own.friction = found.list[0].friction;
        MUS__NAME(cache_respond)(own, 1, found.list[0].overlap, found.list[0].normal, p, w);
    } else if (found.count > 1) {
        MUS__NAME(cache_respond_manifold)(*rule, found.list, found.count, p, w);
    }

    /* far off: no plane, a ball of half the distance. Near one surface: its plane. Near two, or deep inside: no ball,
     * so it is asked at every call */
    const MUS__REAL off = -found.first - rule->clearance, other = -found.second - rule->clearance, half = off / 2;
    const int32_t far = off > 2 * radius, plain = off > -4 * radius && other > 2 * radius && !found.slippery;
    for (int32_t d = 0; d < 3; d++) cache[d * n] = far ? 0 : found.normal[d];
    cache[3 * n] = far ? -1 : found.first;
    cache[7 * n] = far ? half * half : plain ? radius * radius : -1;
}


void MUS__NAME(plane_cache_pass)(const mus__collider *collider, const mus__contact_rule *rule,
                                 const mus__contact_nodes *nodes, void *planes, mus__contact_tally *tally)
{
    const MUS__NAME(cache_rule) own = {(MUS__REAL)(rule->clearance - collider->offset),
                                       (MUS__REAL)rule->friction,
                                       (MUS__REAL)rule->push,
                                       (MUS__REAL)(rule->deep * rule->step),
                                       (MUS__REAL)rule->step,
                                       (MUS__REAL)rule->slip,
                                       (MUS__REAL)rule->cache_radius};
    const int64_t n = nodes->n;
    const MUS__REAL *inverse = nodes->inverse;
    MUS__REAL *x = nodes->x, *v = nodes->v, *cache = planes, left[MUS__CACHE_CHUNK];
    MUS__NAME(surfaces) surfaces;
    MUS__NAME(fill_surfaces)(collider, rule, own.clearance + (MUS__REAL)MUS__CACHE_MARGIN, &surfaces);

    if (MUS__NAME(contact_any_fast)(collider, rule, nodes)) tally->fast = 1;
    for (int32_t start = nodes->first; start < nodes->last; start += MUS__CACHE_CHUNK) {
        const int32_t count = nodes->last - start < MUS__CACHE_CHUNK ? nodes->last - start : MUS__CACHE_CHUNK;
        MUS__NAME(cache_chunk)(own, n, count, inverse + start, cache + start, x + start, v + start, left);
        for (int32_t i = start; i < start + count; i++) {
            if (left[i - start] == 0) continue;
            const MUS__REAL lift = (MUS__REAL)mus__contact_lift(nodes, i);
            MUS__REAL p[3], w[3];
            for (int64_t d = 0; d < 3; d++) p[d] = x[d * n + i], w[d] = v[d * n + i];
            MUS__NAME(cache_renew)(collider, &own, &surfaces, lift, n, cache + i, p, w, &tally->queries);
            for (int64_t d = 0; d < 3; d++) x[d * n + i] = p[d], v[d * n + i] = w[d];
        }
    }
}
