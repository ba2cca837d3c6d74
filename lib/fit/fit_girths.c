/*
 * fit_girths.c: the lengths of cloth round the body at its levels.
 *
 * A plane cuts each triangle in a segment or not at all. The cloth being oriented, the segments of a chain run one way.
 * A chain is connected over the edges of triangles (by the representatives of welded nodes). A chain that turns about
 * the middle of the limb by nine tenths of a round goes round it (a front may stand open a little), unless it goes
 * round the other limb of the pair too: a skirt is no trouser leg. Layers are averaged: all lengths over all rounds.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/elementary.h"
#include "base/sort.h"
#include "fit/fit_internal.h"
#include "geom/vec.h"

/* [rad] a chain of segments that turns by more about the axis goes round it; chosen: a turn, less a tenth */
#define FIT_ROUND (1.8 * MUS_PI)

/* which levels, by which measure the body has its girth there */
static const struct {
    int32_t level, measure, pair;
} fit_levels[] = {
    {MUS_HOLD_NECK, MUS_MEASURE_NECK, 0},        {MUS_HOLD_BUST, MUS_MEASURE_BUST, 0},
    {MUS_HOLD_WAIST, MUS_MEASURE_WAIST, 0},      {MUS_HOLD_HIP, MUS_MEASURE_HIP, 0},
    {MUS_HOLD_BICEPS, MUS_MEASURE_UPPER_ARM, 1}, {MUS_HOLD_THIGH, MUS_MEASURE_THIGH, 1},
    {MUS_HOLD_KNEE, MUS_MEASURE_KNEE, 1},
};

typedef struct fit_cut { /* of one triangle: where it starts and ends */
    int64_t edge[2];     /* lower node times nodes + higher node */
    double from[3], to[3], flat, gap;
    int32_t chain;
} fit_cut;

typedef struct fit_end {
    int64_t edge;
    int32_t cut;
} fit_end;


void mus_fit_level_init(mus_fit_level *level, size_t size)
{
    mus_fit_level own = {0};
    mus__def_init(level, size, &own, sizeof own);
}


/* the crossing of edge a b and the plane: place (3), place in the flat (2), part of the edge; false without one */
static bool fit_cross(const mus_drape *drape, const double *high, int32_t a, int32_t b, double *place, double *flat,
                      double *part)
{
    const double p = high[a], q = high[b];
    if ((p >= 0.0) == (q >= 0.0)) return false;
    const double t = p / (p - q), *rest = drape->cloth->rest;
    const double *from = drape->x + 3 * (ptrdiff_t)a, *to = drape->x + 3 * (ptrdiff_t)b;
    for (int32_t d = 0; d < 3; d++) place[d] = from[d] + t * (to[d] - from[d]);
    for (int32_t d = 0; d < 2; d++)
        flat[d] = rest[2 * (ptrdiff_t)a + d] + t * (rest[2 * (ptrdiff_t)b + d] - rest[2 * (ptrdiff_t)a + d]);
    *part = t;
    return true;
}


/* cuts all triangles; returns the number of segments, each from the edge that goes down through the plane to the one
 * that goes up */
static int32_t fit_cuts(const mus_fit *fit, const mus_drape *drape, const double *high, fit_cut *cut)
{
    const mus_cloth *cloth = drape->cloth;
    int32_t n = 0;
    for (int32_t k = 0; k < cloth->ntriangle; k++) {
        const int32_t *v = cloth->triangle + 3 * (ptrdiff_t)k;
        double flat[2][2], gap = 0.0, t, place[3], xy[2];
        int32_t found = 0;
        for (int32_t c = 0; c < 3; c++) {
            const int32_t a = v[c], b = v[(c + 1) % 3];
            if (!fit_cross(drape, high, a, b, place, xy, &t)) continue;
            const int32_t end = high[a] >= 0.0 ? 0 : 1, i = drape->rep[a], j = drape->rep[b];
            memcpy(end == 0 ? cut[n].from : cut[n].to, place, sizeof place);
            memcpy(flat[end], xy, sizeof xy);
            cut[n].edge[end] = i < j ? (int64_t)i * drape->n + j : (int64_t)j * drape->n + i;
            gap += 0.5 * (fit->gap[a] + t * (fit->gap[b] - fit->gap[a]));
            found++;
        }
        if (found != 2) continue;
        cut[n].flat = mus__hypot(flat[1][0] - flat[0][0], flat[1][1] - flat[0][1]);
        cut[n].gap = gap;
        cut[n].chain = n;
        n++;
    }
    return n;
}


static int fit_by_edge(const void *a, const void *b)
{
    const fit_end *p = a, *q = b;
    if (p->edge != q->edge) return p->edge < q->edge ? -1 : 1;
    return p->cut < q->cut ? -1 : p->cut > q->cut;
}


static int32_t fit_root(fit_cut *cut, int32_t i)
{
    while (cut[i].chain != i) i = cut[i].chain = cut[cut[i].chain].chain;
    return i;
}


/* joins segments that share an edge to chains, numbered by their lowest segment; end (2 n) is scratch */
static void fit_chains(fit_cut *cut, int32_t n, fit_end *end)
{
    for (int32_t i = 0; i < 2 * n; i++) end[i] = (fit_end){cut[i / 2].edge[i % 2], i / 2};
    mus__sort(end, 2 * (size_t)n, sizeof *end, fit_by_edge);
    for (int32_t i = 1; i < 2 * n; i++) {
        if (end[i].edge != end[i - 1].edge) continue;
        const int32_t a = fit_root(cut, end[i - 1].cut), b = fit_root(cut, end[i].cut);
        cut[a > b ? a : b].chain = a > b ? b : a;
    }
    for (int32_t i = 0; i < n; i++) cut[i].chain = fit_root(cut, i);
}


/* angle [rad] by which a segment turns about a point, in the plane square to `up` */
static double fit_turn(const fit_cut *cut, const double *about, const double *up)
{
    double p[3], q[3], cross[3];
    for (int32_t d = 0; d < 3; d++) p[d] = cut->from[d] - about[d], q[d] = cut->to[d] - about[d];
    mus__cross3(p, q, cross);
    return mus__atan2(mus__dot3(cross, up), mus__dot3(p, q));
}


/* lengths over rounds of the chains that go round `own` and not round `other` (NULL: none); false without any */
static bool fit_round(const fit_cut *cut, int32_t n, double *turn, const mus__level_plane *own,
                      const mus__level_plane *other, mus_fit_level *out)
{
    double rounds = 0.0, gaps = 0.0;
    memset(turn, 0, 2 * (size_t)n * sizeof *turn);
    for (int32_t i = 0; i < n; i++) {
        turn[2 * cut[i].chain] += fit_turn(&cut[i], own->point, own->up);
        if (other != NULL) turn[2 * cut[i].chain + 1] += fit_turn(&cut[i], other->point, own->up);
    }
    out->garment = out->worn = 0.0;
    for (int32_t i = 0; i < n; i++) {
        const double *around = turn + 2 * (ptrdiff_t)cut[i].chain;
        if (!(fabs(around[0]) > FIT_ROUND) || fabs(around[1]) > MUS_PI) continue;
        const double d[3] = {cut[i].to[0] - cut[i].from[0], cut[i].to[1] - cut[i].from[1],
                             cut[i].to[2] - cut[i].from[2]};
        const double length = mus__norm3(d);
        out->garment += cut[i].flat;
        out->worn += length;
        if (cut[i].gap == cut[i].gap) gaps += length * cut[i].gap;
        if (cut[i].chain == i) rounds += floor(fabs(around[0]) / (2.0 * MUS_PI) + 0.5);
    }
    if (!(rounds > 0.0) || !(out->worn > 0.0)) return false;
    out->gap = gaps / out->worn;
    out->garment /= rounds;
    out->worn /= rounds;
    return true;
}


mus_status mus__fit_levels(mus_fit *fit, const mus_drape *drape, const mus_body *body)
{
    const int64_t triangles = drape->cloth->ntriangle;
    fit_cut *cut = mus__new(drape->context, triangles, sizeof *cut);
    fit_end *end = mus__new(drape->context, 2 * triangles, sizeof *end);
    double *high = mus__new(drape->context, drape->n + 2 * triangles, sizeof *high);
    const bool done = cut != NULL && end != NULL && high != NULL;
    for (size_t k = 0; k < sizeof fit_levels / sizeof *fit_levels && done; k++)
        for (int32_t right = 0; right <= fit_levels[k].pair; right++) {
            mus_fit_level level;
            mus__level_plane own, other;
            mus__scene_level(drape, fit_levels[k].level, right, &own);
            mus__scene_level(drape, fit_levels[k].level, !right, &other);
            if (!own.there) continue;
            for (int32_t i = 0; i < drape->n; i++) high[i] = mus__dot3(own.up, drape->x + 3 * (ptrdiff_t)i) - own.at;
            const int32_t n = fit_cuts(fit, drape, high, cut);
            fit_chains(cut, n, end);
            mus_fit_level_init(&level, sizeof level);
            level.level = fit_levels[k].level;
            level.right = fit_levels[k].pair ? right : MUS_NONE;
            level.body = mus_body_made(body, fit_levels[k].measure);
            if (!(level.body > 0.0)) continue;
            const mus__level_plane *pair = fit_levels[k].pair && other.there ? &other : NULL;
            if (!fit_round(cut, n, high + drape->n, &own, pair, &level)) continue;
            level.ease = level.garment - level.body;
            fit->level[fit->nlevel++] = level;
        }
    mus__free(drape->context, cut);
    mus__free(drape->context, end);
    mus__free(drape->context, high);
    return done ? MUS_OK : mus__fail_memory(drape->context, "the levels of a fit");
}
