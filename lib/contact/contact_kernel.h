/*
 * contact_kernel.h: the contact pass, as a template on the floating type (MUS__REAL, MUS__NAME, MUS_CONTACT, MUS_RUSH).
 *
 * The fields stand `skin` off the body already (contact.c), so depths are taken from there and are small where a node
 * rests: a depth of first order jumps a little from ring to ring, but not at zero. Planes are taken as much off.
 *
 * A node nearer than the clearance is put back along the outward normal, loses its velocity into the skin, and its
 * sliding velocity shrinks by the friction impulse mu |v_n|. The step that led here moved the node along the skin with
 * the velocity it had before the impulse; friction takes back `slip` mu |v_n| of that way too, and no more than all of
 * it, so that what sticks does not creep, and in float not even by rounding. All is relative to the surface: places to
 * where it has carried the node from, velocities to its own there. What touches several surfaces is in meet_kernel.h.
 *
 * Nodes are first held against the boxes of the parts, a block at a time and many nodes at once; only what is in a box
 * is asked of its part. An answer is a distance: until a node has gone an eighth of it, or the surfaces have, that
 * part need not be asked again. An eighth, since the distance is of first order: beside the caps of parts it was found
 * up to five times too far. What a node goes is measured.
 *
 * What a node is pushed out of may push it into what it did not touch before, so that counts as touched too: between an
 * arm and a candidate a tight cloth would else be thrown from one to the other.
 *
 * What is fast is swept (sweep_kernel.h). Whether paths are measured at all is decided by the speeds after the step
 * before (`fast`).
 */

/* [m] a node this near to the clearance is still on the skin: a float state rounds by as much */
#define MUS__TOUCH_BAND 2e-6

#define MUS__STICK_BAND (sizeof(MUS__REAL) == sizeof(float) ? 1e-7 : 1e-15) /* [m]: as far off the skin as before */

#define MUS__QUERY_MARGIN 0.04 /* [m]: how far off the body a distance is still taken */
#define MUS__CACHE_GAP 2e-3    /* [m]: a part this far beyond the clearance is not asked for a while */
#define MUS__CACHE_DIVISOR 8   /* part of the distance that a node may go until then: one in so many */

/* [m]: a node that is pushed farther than this may come to a part that it is not asked of */
#define MUS__PUSH_FAR (MUS__CACHE_GAP * (MUS__CACHE_DIVISOR - 1) / MUS__CACHE_DIVISOR)

#define MUS__SAFE_FRACTION 0.999 /* part of the safe length: for the rounding of ways */

#define MUS__SQUEEZE_MAX 5.0   /* [m/s] out of a wedge that closes */
#define MUS__MANIFOLD_MAX 8    /* surfaces that a node touches at once; more are left out */
#define MUS__CANDIDATES_MAX 16 /* that it is near; of more, those that are farthest are left out */

/* nonzero when p is in the box (6) */
static inline int32_t MUS__NAME(in_box)(const MUS__REAL *box, const MUS__REAL *p)
{
    return !(p[0] < box[0] || p[0] > box[3] || p[1] < box[1] || p[1] > box[4] || p[2] < box[2] || p[2] > box[5]);
}


/* the parts whose box p is in, a bit each */
static uint64_t MUS__NAME(boxes_around)(int32_t nparts, const MUS__REAL *box, const MUS__REAL *p)
{
    uint64_t in = 0;
    for (int32_t l = 0; l < nparts; l++) in |= (uint64_t)MUS__NAME(in_box)(box + 6 * l, p) << l;
    return in;
}


#include "contact/friction_kernel.h"
#include "contact/query_batch_kernel.h"
#include "contact/response_kernel.h"
#include "contact/sweep_kernel.h"


/* ---- the pass ---- */

/* parts first .. last-1, at most 32: a bit in in (count) for each whose box a node is in; far (count) gets the largest
 * of carried (last) of those, if it is larger */
MUS_CLONES
static void MUS__NAME(chunk_boxes)(const MUS__NAME(surfaces) * surfaces, int32_t first, int32_t last,
                                   const MUS__REAL *carried, int64_t n, int32_t count, const MUS__REAL *restrict x,
                                   uint32_t *restrict in, MUS__REAL *restrict far)
{
    for (int32_t i = 0; i < count; i++) in[i] = 0;
    for (int32_t l = first; l < last; l++) {
        const MUS__REAL *b = surfaces->box + 6 * l, b0 = b[0], b1 = b[1], b2 = b[2], b3 = b[3], b4 = b[4], b5 = b[5];
        const uint32_t bit = (uint32_t)1 << (l - first);
        const MUS__REAL own = carried[l];
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


/* planes: a bit in on (count) for each that a node is not farther above than the margin */
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


/* nonzero when a speed relative to drift (3) is above the root of fast2 */
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


int32_t MUS__NAME(contact_any_fast)(const mus__collider *collider, const mus__contact_rule *rule, int32_t n,
                                    int32_t first, int32_t last, const MUS__REAL *v)
{
    const MUS__REAL fast = (MUS__REAL)mus__contact_fast_speed(collider, rule);
    MUS__REAL drift[3];
    for (int32_t d = 0; d < 3; d++) drift[d] = (MUS__REAL)collider->drift[d];
    return MUS__NAME(chunk_fast)(drift, fast * fast, n, last - first, v + first) != 0;
}


/* how far surfaces may have gone since the last call: all of them, and of a body that turns each part beyond that. Of
 * parts a node counts those in whose boxes it is: others are farther off than what it may go until it is asked again */
typedef struct MUS__NAME(surface_travel) {
    MUS__REAL rest, part[MUS__PARTS_MAX], most;
} MUS__NAME(surface_travel);


static void MUS__NAME(fill_surface_travel)(const mus__collider *collider, const mus__contact_rule *rule,
                                           MUS__NAME(surface_travel) * carries)
{
    const double rest = mus__contact_surface_travel(collider, rule, collider->plane_speed_max);
    carries->rest = (MUS__REAL)rest;
    carries->most = 0;
    for (int32_t l = 0; l < collider->nparts; l++) {
        carries->part[l] =
            (MUS__REAL)fmax(mus__contact_surface_travel(collider, rule, collider->part[l].speed_max) - rest, 0.0);
        if (carries->part[l] > carries->most) carries->most = carries->part[l];
    }
}


/* to gone (count), which has how far the part went that did farthest beyond the rest, how far the node and the rest
 * have gone since the last call */
MUS_CLONES
static void MUS__NAME(chunk_travel)(MUS__REAL carried, int64_t n, int32_t count, const MUS__REAL *restrict before,
                                    const MUS__REAL *restrict x, MUS__REAL *restrict gone)
{
    MUS_IVDEP
    for (int32_t i = 0; i < count; i++) {
        const MUS__REAL d0 = x[i] - before[i], d1 = x[n + i] - before[n + i], d2 = x[2 * n + i] - before[2 * n + i];
        gone[i] = gone[i] + carried + (MUS__REAL)MUS__NAME(sqrt)(d0 * d0 + d1 * d1 + d2 * d2);
    }
}


#include "contact/response_batch_kernel.h"


/* node i, which is in the boxes `boxes`, of which `in` are to be asked, and near the planes `on`, or may have to be
 * swept; `batch` and `head` as of touch */
static void MUS__NAME(pass_node)(const mus__collider *collider, const mus__contact_rule *rule,
                                 const MUS__NAME(surfaces) * surfaces, int32_t n, int32_t i, uint64_t boxes,
                                 uint64_t in, uint32_t on, int32_t sweeps, const MUS__NAME(query_batch) * batch,
                                 int32_t head, const MUS__REAL *inverse, const MUS__REAL *before,
                                 mus__distance_cache *cache, MUS__REAL *x, MUS__REAL *v, mus__contact_tally *tally)
{
    const int64_t at[3] = {i, n + i, 2 * (int64_t)n + i};
    const MUS__REAL gap = surfaces->margin - (MUS__REAL)(rule->clearance - collider->offset);
    MUS__REAL p[3], w[3], from[3], moved = 0;
    int32_t touched = 0;
    for (int32_t d = 0; d < 3; d++) p[d] = x[at[d]], w[d] = v[at[d]], from[d] = before[at[d]];
    const uint64_t parts = in;
    const uint32_t planes = on;
    if (sweeps) touched = MUS__NAME(sweep_all)(collider, rule, surfaces, &in, &on, from, p, w, &tally->queries);
    const int32_t swept = in != parts || on != planes;

    /* parts that were asked already and are not near are as far as a distance is taken */
    MUS__NAME(gaps) gaps = {gap, gap, boxes & ~in & (((uint64_t)1 << MUS__CACHE_PARTS) - 1)};

    /* what a sweep took out of one part may be in another */
    if (swept && touched) in = MUS__NAME(boxes_around)(collider->nparts, surfaces->box, p);
    if (in != 0 || on != 0) {
        const MUS__NAME(path) path = {from, (MUS__REAL)rule->step, (MUS__REAL)(swept ? 0.0 : rule->slip)};
        touched |= MUS__NAME(respond_node)(collider, rule, surfaces, in, swept ? 0 : boxes & ~in, on, 0, batch, head,
                                           &path, &gaps, p, w, &tally->queries);
    }
    for (int32_t d = 0; touched && d < 3; d++) moved += (p[d] - x[at[d]]) * (p[d] - x[at[d]]);
    if (cache->slack <= 0 && !swept) MUS__NAME(distance_cache_set)(&gaps, moved, cache);
    if (!touched) return;
    const double mass = 1.0 / (double)inverse[i];
    for (int32_t d = 0; d < 3; d++) {
        tally->impulse[d] += ((double)w[d] - (double)v[at[d]]) * mass;
        x[at[d]] = p[d];
        v[at[d]] = w[d];
    }
}


/* a block of nodes that are not swept: boxes (count) and in (count) a bit for each part whose box a node is in, and
 * that is to be asked; on (count) of the planes */
static void MUS__NAME(pass_chunk)(const mus__collider *collider, const mus__contact_rule *rule,
                                  const MUS__NAME(surfaces) * surfaces, int32_t n, int32_t start, int32_t count,
                                  const uint64_t *boxes, uint64_t *in, const uint32_t *on, const uint8_t *skip,
                                  const MUS__REAL *inverse, const MUS__REAL *before, mus__distance_cache *cache,
                                  MUS__REAL *x, MUS__REAL *v, mus__contact_tally *tally)
{
    const MUS__REAL clearance = (MUS__REAL)(rule->clearance - collider->offset);
    MUS__NAME(query_batch) batch;
    MUS__NAME(single_contacts) single;
    MUS__NAME(query_batch_chunk)(collider, surfaces->margin, n, count, x + start, in, &batch, &tally->queries);
    single.count = 0;
    for (int32_t i = 0; i < count; i++) {
        mus__distance_cache *own = &cache[start + i];
        single.kind[i] = MUS__TOUCH_NONE;
        if (skip[i] || (on[i] == 0 && (boxes[i] == 0 || (in[i] == 0 && own->slack > 0)))) continue;
        single.kind[i] = on[i] != 0
                             ? MUS__TOUCH_OTHER
                             : (uint8_t)MUS__NAME(classify_node)(rule, surfaces, clearance, n, start, i, boxes[i],
                                                                 in[i], &batch, before, x, v, own, &single);
    }
    MUS__NAME(respond_batch)
    ((MUS__REAL)rule->friction, (MUS__REAL)rule->push, (MUS__REAL)rule->step, (MUS__REAL)rule->slip, single.count,
     single.overlap, single.normal, single.from, single.x, single.v, single.moved);
    for (int32_t i = 0, m = 0; i < count; i++) {
        mus__distance_cache *own = &cache[start + i];
        if (single.kind[i] == MUS__TOUCH_ONE_PART)
            MUS__NAME(store_single)(&single, m++, surfaces->moving, n, start + i, inverse[start + i], own, x, v, tally);
        if (single.kind[i] == MUS__TOUCH_OTHER) MUS__NAME(pass_node)
        (collider, rule, surfaces, n, start + i, boxes[i], in[i], on[i], 0, &batch, batch.head[i], inverse, before, own,
         x, v, tally);
    }
}


void MUS__NAME(contact_pass)(const mus__collider *collider, const mus__contact_rule *rule, int32_t n, int32_t first,
                             int32_t last, const MUS__REAL *inverse, const MUS__REAL *before, int32_t sweeps,
                             mus__distance_cache *cache, MUS__REAL *x, MUS__REAL *v, mus__contact_tally *tally)
{
    MUS__NAME(surfaces) surfaces;
    const int32_t nparts = collider->nparts;
    const MUS__REAL margin =
        (MUS__REAL)(rule->clearance - collider->offset) + (MUS__REAL)MUS__TOUCH_BAND + (MUS__REAL)MUS__QUERY_MARGIN;
    MUS__NAME(fill_surfaces)(collider, rule, margin, &surfaces);

    if (MUS__NAME(contact_any_fast)(collider, rule, n, first, last, v)) tally->fast = 1;
    MUS__NAME(surface_travel) carries;
    MUS__NAME(fill_surface_travel)(collider, rule, &carries);
    uint32_t low[MUS__CHUNK], high[MUS__CHUNK] = {0}, on[MUS__CHUNK] = {0};
    uint64_t boxes[MUS__CHUNK], in[MUS__CHUNK];
    MUS__REAL gone[MUS__CHUNK];
    uint8_t skip[MUS__CHUNK];
    for (int32_t start = first; start < last; start += MUS__CHUNK) {
        const int32_t count = last - start < MUS__CHUNK ? last - start : MUS__CHUNK;
        uint64_t any = 0;
        MUS__REAL way = 0;
        for (int32_t i = 0; i < count; i++) gone[i] = 0;
        MUS__NAME(chunk_boxes)(&surfaces, 0, nparts < 32 ? nparts : 32, carries.part, n, count, x + start, low, gone);
        if (nparts > 32) MUS__NAME(chunk_boxes)(&surfaces, 32, nparts, carries.part, n, count, x + start, high, gone);
        if (surfaces.nplane > 0) MUS__NAME(chunk_planes)(&surfaces, n, count, x + start, on);
        MUS__NAME(chunk_travel)(carries.rest, n, count, before + start, x + start, gone);
        for (int32_t i = 0; i < count; i++) {
            mus__distance_cache *own = &cache[start + i];
            boxes[i] = in[i] = low[i] | (uint64_t)high[i] << 32;
            own->slack -= (float)gone[i];
            if (!(gone[i] <= way)) way = gone[i];
            skip[i] = inverse[start + i] == 0;

            /* what it is too far from to have come to is not asked */
            if (own->slack > 0 && own->parts == MUS__CACHE_ALL)
                skip[i] = 1;
            else if (own->slack > 0)
                in[i] &= ~(uint64_t)own->parts;
            if (skip[i]) in[i] = 0;
            any |= in[i] | (skip[i] ? 0 : on[i]);
        }

        /* a block of which no node went so far against any surface is not swept */
        const int32_t swept = sweeps != 0 && !(way + carries.most <= (MUS__REAL)(MUS__SAFE_FRACTION * collider->safe));
        if (any == 0 && !swept) continue;
        if (!swept) {
            MUS__NAME(pass_chunk)
            (collider, rule, &surfaces, n, start, count, boxes, in, on, skip, inverse, before, cache, x, v, tally);
            continue;
        }
        for (int32_t i = 0; i < count; i++)
            if (!skip[i]) MUS__NAME(pass_node)
        (collider, rule, &surfaces, n, start + i, boxes[i], in[i], on[i], sweeps, NULL, 0, inverse, before,
         &cache[start + i], x, v, tally);
    }
}
