/*
 * contact_kernel.h: the contact pass (contact.h) as a template on the floating type: MUS__REAL, MUS__NAME(name) and
 * MUS__PART_FIELDS, the collider's fields of that type.
 *
 * The radius fields are those of the surface `offset` off the skin (collider.c), so depths are counted from there and
 * are small where a node rests: a depth of first order jumps a little from ring to ring, but not at zero. Planes are
 * offset by as much.
 *
 * Nodes go through in chunks:
 *
 *   1. boxes    every node of a chunk against the boxes of the parts, and against the planes
 *   2. caches   a query's answer is a distance; until node and surfaces have travelled an eighth of it, that part is
 *               left out. An eighth, since the distance is of first order: beside the caps of parts it was measured up
 *               to five times too large
 *   3. queries  what is left is asked of its parts, many nodes of one part at once (query_batch_kernel.h)
 *   4. response nodes that touch one part many at once (response_batch_kernel.h), all others one by one
 *               (response_kernel.h)
 *
 * A chunk in which a node travelled further than the thinnest part allows is not batched: its fast nodes are swept
 * (sweep_kernel.h). Whether travel is measured at all is decided by the speeds after the step before (`fast` of the
 * tally).
 */

#define MUS__CHUNK 256 /* nodes looked at together; chosen */

#define MUS__MANIFOLD_MAX 8 /* contacts of a node, and query results; more are left out */
/* [m] a node no further than this beyond the clearance touches: a float state rounds by as much */
#define MUS__TOUCH_BAND 2e-6
/* [m] a sticking node whose height over the surface changed by no more goes back to its old place, to the last bit:
 * rounding */
#define MUS__STICK_BAND (sizeof(MUS__REAL) == sizeof(float) ? 1e-7 : 1e-15)

/* [m] a distance beyond the clearance is measured up to this; chosen: what is further off needs no query for a
 * while anyway */
#define MUS__QUERY_MARGIN 0.04
#define MUS__CACHE_GAP 2e-3 /* [m] a part this far beyond the clearance goes into the cache; chosen */
/* travel until the next query is the distance over this. The distance along a ray is too large where the surface is
 * steep, by a factor between 8 and 10 where bumps of the torso lie inside the arm: 8 fails its test there, 10 holds */
#define MUS__CACHE_DIVISOR 10
/* [m] a node that is pushed further than this may come to a part that its cache leaves out */
#define MUS__PUSH_FAR (MUS__CACHE_GAP * (MUS__CACHE_DIVISOR - 1) / MUS__CACHE_DIVISOR)
#define MUS__SAFE_FRACTION 0.999 /* of the safe travel, for the rounding of distances: more is swept */

/* a pass: what it works on, and the surfaces in its precision */
typedef struct MUS__NAME(pass) {
    const mus__collider *collider;
    const mus__contact_rule *rule;
    const mus__contact_nodes *nodes;
    const MUS__NAME(field) * field; /* of the parts */
    mus__distance_cache *cache;
    mus__contact_tally *tally;
    MUS__REAL clearance; /* from the offset surfaces [m] */
    MUS__NAME(surfaces) surfaces;
} MUS__NAME(pass);

/* a chunk of nodes: a bit for each part whose box the node is in; for each part that it is to be asked of; for each
 * plane near it. skip: nothing is to be done with it */
typedef struct MUS__NAME(chunk) {
    int32_t start, count;
    uint64_t boxes[MUS__CHUNK], parts[MUS__CHUNK];
    uint32_t planes[MUS__CHUNK];
    uint8_t skip[MUS__CHUNK];
} MUS__NAME(chunk);


/* nonzero when p is in the box (6) */
static inline int32_t MUS__NAME(in_box)(const MUS__REAL *box, const MUS__REAL *p)
{
    return !(p[0] < box[0] || p[0] > box[3] || p[1] < box[1] || p[1] > box[4] || p[2] < box[2] || p[2] > box[5]);
}


/* the parts whose box p is in, a bit each */
static uint64_t MUS__NAME(boxes_around)(const MUS__NAME(pass) * pass, const MUS__REAL *p)
{
    uint64_t in = 0;
    for (int32_t l = 0; l < pass->collider->nparts; l++)
        in |= (uint64_t)MUS__NAME(in_box)(pass->surfaces.box + 6 * l, p) << l;
    return in;
}


#include "contact/query_batch_kernel.h"
#include "contact/response_kernel.h"
#include "contact/sweep_kernel.h"
#include "contact/response_batch_kernel.h"


/* ---- boxes and travel of a chunk ---- */

/* a bit in in (count) for each of `parts` boxes (at most 32, x 6) that a node is in; far (count) becomes the largest of
 * travel (parts) of those, if that is larger; x planes (3 x n) from the chunk's first node on */
MUS_CLONES
static void MUS__NAME(chunk_boxes)(const MUS__REAL *boxes, const MUS__REAL *travel, int32_t parts, int64_t n,
                                   int32_t count, const MUS__REAL *restrict x, uint32_t *restrict in,
                                   MUS__REAL *restrict far)
{
    for (int32_t i = 0; i < count; i++) in[i] = 0;
    for (int32_t l = 0; l < parts; l++) {
        const MUS__REAL *b = boxes + 6 * l, b0 = b[0], b1 = b[1], b2 = b[2], b3 = b[3], b4 = b[4], b5 = b[5];
        const uint32_t bit = (uint32_t)1 << l;
        const MUS__REAL own = travel[l];
        MUS_IVDEP
        for (int32_t i = 0; i < count; i++) {
            const MUS__REAL p0 = x[i], p1 = x[n + i], p2 = x[2 * n + i];
            const uint32_t inside = (p0 >= b0) & (p0 <= b3) & (p1 >= b1) & (p1 <= b4) & (p2 >= b2) & (p2 <= b5);
            const MUS__REAL most = own > far[i] ? own : far[i];
            in[i] |= inside * bit;
            far[i] = inside != 0 ? most : far[i];
        }
    }
}


/* a bit in on (count) for each plane that a node is no further above than the margin */
MUS_CLONES
static void MUS__NAME(chunk_planes)(const MUS__NAME(surfaces) * surfaces, int64_t n, int32_t count,
                                    const MUS__REAL *restrict x, uint32_t *restrict on)
{
    for (int32_t i = 0; i < count; i++) on[i] = 0;
    for (int32_t k = 0; k < surfaces->nplane; k++) {
        const MUS__REAL *normal = surfaces->plane[k].normal, a = normal[0], b = normal[1], c = normal[2];
        const MUS__REAL top = surfaces->plane[k].start + surfaces->margin;
        const uint32_t bit = (uint32_t)1 << k;
        MUS_IVDEP
        for (int32_t i = 0; i < count; i++) {
            const uint32_t below = a * x[i] + b * x[n + i] + c * x[2 * n + i] <= top;
            on[i] |= below * bit;
        }
    }
}


/* nonzero when the square of a speed relative to drift (3) is above fast2 */
MUS_CLONES
static uint32_t MUS__NAME(chunk_fast)(const MUS__REAL *drift, MUS__REAL fast2, int64_t n, int32_t count,
                                      const MUS__REAL *restrict v)
{
    const MUS__REAL d0 = drift[0], d1 = drift[1], d2 = drift[2];
    uint32_t found = 0;
    for (int32_t i = 0; i < count; i++) {
        const MUS__REAL w0 = v[i] - d0, w1 = v[n + i] - d1, w2 = v[2 * n + i] - d2;
        found |= w0 * w0 + w1 * w1 + w2 * w2 > fast2;
    }
    return found;
}


int32_t MUS__NAME(contact_any_fast)(const mus__collider *collider, const mus__contact_rule *rule,
                                    const mus__contact_nodes *nodes)
{
    const MUS__REAL fast = (MUS__REAL)mus__contact_fast_speed(collider, rule), *v = nodes->v;
    MUS__REAL drift[3];
    for (int32_t d = 0; d < 3; d++) drift[d] = (MUS__REAL)collider->drift[d];
    return MUS__NAME(chunk_fast)(drift, fast * fast, nodes->n, nodes->last - nodes->first, v + nodes->first) != 0;
}


/* bounds of what surfaces have travelled since the last call [m]: the drift and the planes, and of a body that turns
 * each part beyond that. A node counts the parts in whose boxes it is: all others are further off than its slack */
typedef struct MUS__NAME(surface_travel) {
    MUS__REAL rest, part[MUS__PARTS_MAX], most;
} MUS__NAME(surface_travel);


static void MUS__NAME(fill_surface_travel)(const mus__collider *collider, const mus__contact_rule *rule,
                                           MUS__NAME(surface_travel) * to)
{
    const double rest = mus__contact_surface_travel(collider, rule, collider->plane_speed_max);
    to->rest = (MUS__REAL)rest;
    to->most = 0;
    for (int32_t l = 0; l < collider->nparts; l++) {
        const double part = mus__contact_surface_travel(collider, rule, collider->part[l].speed_max);
        to->part[l] = (MUS__REAL)fmax(part - rest, 0.0);
        if (to->part[l] > to->most) to->most = to->part[l];
    }
}


/* adds to gone (count), which has the travel of the nearby parts beyond the rest, that of the rest and of the node */
MUS_CLONES
static void MUS__NAME(chunk_travel)(MUS__REAL rest, int64_t n, int32_t count, const MUS__REAL *restrict before,
                                    const MUS__REAL *restrict x, MUS__REAL *restrict gone)
{
    MUS_IVDEP
    for (int32_t i = 0; i < count; i++) {
        const MUS__REAL d0 = x[i] - before[i], d1 = x[n + i] - before[n + i], d2 = x[2 * n + i] - before[2 * n + i];
        gone[i] = gone[i] + rest + (MUS__REAL)MUS__NAME(sqrt)(d0 * d0 + d1 * d1 + d2 * d2);
    }
}


/* ---- the pass ---- */

/* node i of a chunk, alone; batch: answers for it, or NULL: it may have to be swept */
static void MUS__NAME(pass_node)(const MUS__NAME(pass) * pass, const MUS__NAME(chunk) * chunk, int32_t i,
                                 const MUS__NAME(query_batch) * batch)
{
    const mus__contact_nodes *nodes = pass->nodes;
    const int64_t n = nodes->n, k = chunk->start + i, at[3] = {k, n + k, 2 * n + k};
    const MUS__REAL lift = (MUS__REAL)mus__contact_lift(nodes, k);
    const MUS__REAL gap = pass->surfaces.margin - pass->clearance - lift;
    const MUS__REAL *before = nodes->before, *inverse = nodes->inverse;
    MUS__REAL *x = nodes->x, *v = nodes->v, p[3], w[3], from[3], moved = 0;
    mus__distance_cache *cache = &pass->cache[k];
    const uint64_t boxes = chunk->boxes[i], parts = chunk->parts[i];
    const uint32_t planes = chunk->planes[i];
    MUS__NAME(query) query = {parts, boxes & ~parts, planes, lift, 0, batch, batch != NULL ? batch->head[i] : 0};
    int32_t touched = 0;
    for (int32_t d = 0; d < 3; d++) p[d] = x[at[d]], w[d] = v[at[d]], from[d] = before[at[d]];
    if (batch == NULL) touched = MUS__NAME(sweep_all)(pass, &query.parts, &query.planes, from, p, w);
    const int32_t swept = query.parts != parts || query.planes != planes;

    /* parts that were asked already and are not near are as far as a distance is measured */
    MUS__NAME(gaps) gaps = {gap, gap, boxes & ~query.parts & (((uint64_t)1 << MUS__CACHE_PARTS) - 1)};

    /* a sweep may have moved the node out of one part into another */
    if (swept && touched) query.parts = MUS__NAME(boxes_around)(pass, p);
    query.others = swept ? 0 : boxes & ~query.parts;
    if (query.parts != 0 || query.planes != 0) {
        const MUS__NAME(path) path = {from, (MUS__REAL)pass->rule->step, (MUS__REAL)(swept ? 0.0 : pass->rule->slip)};
        touched |= MUS__NAME(respond_node)(pass, &query, &path, &gaps, p, w);
    }
    for (int32_t d = 0; touched && d < 3; d++) moved += (p[d] - x[at[d]]) * (p[d] - x[at[d]]);
    if (cache->slack <= 0 && !swept) MUS__NAME(distance_cache_set)(&gaps, moved, cache);
    if (!touched) return;
    const double mass = 1.0 / (double)inverse[k];
    for (int32_t d = 0; d < 3; d++) {
        pass->tally->impulse[d] += ((double)w[d] - (double)v[at[d]]) * mass;
        x[at[d]] = p[d];
        v[at[d]] = w[d];
    }
}


/* a chunk of which no node is swept */
static void MUS__NAME(pass_chunk)(const MUS__NAME(pass) * pass, MUS__NAME(chunk) * chunk)
{
    MUS__NAME(query_batch) batch;
    MUS__NAME(single_contacts) single;
    MUS__NAME(query_batch_chunk)(pass, chunk, &batch);
    single.count = 0;
    for (int32_t i = 0; i < chunk->count; i++) {
        const uint32_t planes = chunk->planes[i];
        const int32_t idle = chunk->parts[i] == 0 && pass->cache[chunk->start + i].slack > 0;
        single.kind[i] = MUS__TOUCH_NONE;
        if (chunk->skip[i] || (planes == 0 && (chunk->boxes[i] == 0 || idle))) continue;
        single.kind[i] =
            planes != 0 ? MUS__TOUCH_OTHER : (uint8_t)MUS__NAME(classify_node)(pass, chunk, i, &batch, &single);
    }
    MUS__NAME(respond_batch)(pass->rule, &single);
    for (int32_t i = 0, m = 0; i < chunk->count; i++) {
        if (single.kind[i] == MUS__TOUCH_ONE_PART) MUS__NAME(store_single)(pass, &single, m++, chunk->start + i);
        if (single.kind[i] == MUS__TOUCH_OTHER) MUS__NAME(pass_node)(pass, chunk, i, &batch);
    }
}


/* boxes, planes and caches of a chunk that is started and counted; way: largest travel of a node relative to a surface.
 * Nonzero when a node is to be asked of any surface */
static int32_t MUS__NAME(chunk_fill)(const MUS__NAME(pass) * pass, const MUS__NAME(surface_travel) * travel,
                                     MUS__NAME(chunk) * chunk, MUS__REAL *way)
{
    const mus__contact_nodes *nodes = pass->nodes;
    const int32_t nparts = pass->collider->nparts, start = chunk->start, count = chunk->count;
    const int64_t n = nodes->n;
    const MUS__REAL *x = (const MUS__REAL *)nodes->x + start, *before = (const MUS__REAL *)nodes->before + start;
    const MUS__REAL *inverse = (const MUS__REAL *)nodes->inverse + start, *box = pass->surfaces.box;
    uint32_t low[MUS__CHUNK], high[MUS__CHUNK] = {0};
    MUS__REAL gone[MUS__CHUNK];
    uint64_t any = 0;
    for (int32_t i = 0; i < count; i++) gone[i] = 0;
    MUS__NAME(chunk_boxes)(box, travel->part, nparts < 32 ? nparts : 32, n, count, x, low, gone);
    if (nparts > 32) MUS__NAME(chunk_boxes)(box + 6 * 32, travel->part + 32, nparts - 32, n, count, x, high, gone);
    if (pass->surfaces.nplane > 0) MUS__NAME(chunk_planes)(&pass->surfaces, n, count, x, chunk->planes);
    MUS__NAME(chunk_travel)(travel->rest, n, count, before, x, gone);
    *way = 0;
    for (int32_t i = 0; i < count; i++) {
        mus__distance_cache *cache = &pass->cache[start + i];
        chunk->boxes[i] = chunk->parts[i] = low[i] | (uint64_t)high[i] << 32;
        cache->slack -= (float)gone[i];
        if (!(gone[i] <= *way)) *way = gone[i];
        chunk->skip[i] = inverse[i] == 0;
        if (cache->slack > 0 && cache->parts == MUS__CACHE_ALL)
            chunk->skip[i] = 1;
        else if (cache->slack > 0)
            chunk->parts[i] &= ~(uint64_t)cache->parts;
        if (chunk->skip[i]) chunk->parts[i] = 0;
        any |= chunk->parts[i] | (chunk->skip[i] ? 0 : chunk->planes[i]);
    }
    return any != 0;
}


void MUS__NAME(contact_pass)(const mus__collider *collider, const mus__contact_rule *rule,
                             const mus__contact_nodes *nodes, int32_t sweeps, mus__distance_cache *cache,
                             mus__contact_tally *tally)
{
    const MUS__REAL clearance = (MUS__REAL)(rule->clearance - collider->offset);
    MUS__NAME(pass) pass;
    pass.collider = collider, pass.rule = rule, pass.nodes = nodes, pass.field = collider->MUS__PART_FIELDS;
    pass.cache = cache, pass.tally = tally, pass.clearance = clearance;
    const MUS__REAL margin = clearance + (MUS__REAL)MUS__TOUCH_BAND + (MUS__REAL)MUS__QUERY_MARGIN;
    MUS__NAME(fill_surfaces)(collider, rule, margin, &pass.surfaces);

    if (MUS__NAME(contact_any_fast)(collider, rule, nodes)) tally->fast = 1;
    MUS__NAME(surface_travel) travel;
    MUS__NAME(chunk) chunk;
    MUS__NAME(fill_surface_travel)(collider, rule, &travel);
    memset(chunk.planes, 0, sizeof chunk.planes);
    for (int32_t start = nodes->first; start < nodes->last; start += MUS__CHUNK) {
        MUS__REAL way;
        chunk.start = start;
        chunk.count = nodes->last - start < MUS__CHUNK ? nodes->last - start : MUS__CHUNK;
        const int32_t any = MUS__NAME(chunk_fill)(&pass, &travel, &chunk, &way);

        /* a chunk of which no node went so far against any surface is not swept */
        const int32_t swept = sweeps != 0 && !(way + travel.most <= (MUS__REAL)(MUS__SAFE_FRACTION * collider->safe));
        if (swept) {
            for (int32_t i = 0; i < chunk.count; i++)
                if (!chunk.skip[i]) MUS__NAME(pass_node)(&pass, &chunk, i, NULL);
        } else if (any) {
            MUS__NAME(pass_chunk)(&pass, &chunk);
        }
    }
}
