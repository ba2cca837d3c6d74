/*
 * arrange_ring.c: panels that seams join side by side make a ring; each gets its place along the girth.
 *
 * Seams between a right and a left side are taken from the top down, each once, if it joins a new panel. The highest
 * seam goes right round the trunk, a lower one may go round one leg only. The distance by which the closing seam misses
 * is the girth. A ring that nothing closes (an open front, half a circle skirt) is as wide as its panels.
 */
#include <math.h>

#include "arrange/arrange_internal.h"
#include "geom/union_find.h"

#define RING_DART 0.6 /* of the widest panel: a seam that misses by less is a dart's */
#define RING_LEG                                                                                                       \
    0.3 /* of the largest miss: a seam that misses by a share between this and 1 less this closes a leg                \
         */
#define RING_CLOSES 0.5 /* of the largest miss: a seam that misses by less does not close the ring */
/* over the panels to even their places; chosen: of a ring of 20 panels 1e-8 is left, cos(2 pi / 20) squared a sweep */
#define RING_SWEEPS 200


/* components: panels that hang together by any seam; sets ring->component of each ring */
static void ring_components(mus__arrangement *arrangement)
{
    int32_t *link = arrangement->work;
    mus__union_start(arrangement->npanel, link, NULL);
    for (int32_t i = 0; i < arrangement->nseam; i++)
        mus__union_join(link, NULL, arrangement->edge[arrangement->seam[i].a].panel,
                        arrangement->edge[arrangement->seam[i].b].panel, 1);
    for (int32_t p = 0; p < arrangement->npanel; p++)
        arrangement->ring[arrangement->panel[p].ring].component = mus__union_find(link, NULL, p);
}


/* the highest seam that joins a panel of the ring to a panel without a ring; NULL without any */
static const mus__arranged_seam *ring_next(const mus__arrangement *arrangement, int32_t ring)
{
    const mus__arranged_seam *best = NULL;
    for (int32_t i = 0; i < arrangement->nseam; i++) {
        const mus__arranged_seam *seam = &arrangement->seam[i];
        const int32_t a = arrangement->panel[arrangement->edge[seam->a].panel].ring;
        const int32_t b = arrangement->panel[arrangement->edge[seam->b].panel].ring;
        if (seam->beside == 0 || !((a == ring && b == MUS_NONE) || (b == ring && a == MUS_NONE))) continue;
        if (best == NULL || seam->high > best->high) best = seam;
    }
    return best;
}


/* adds panels to a ring until no seam joins another */
static void ring_grow(mus__arrangement *arrangement, int32_t ring)
{
    const mus__arranged_seam *seam;
    while ((seam = ring_next(arrangement, ring)) != NULL) {
        mus__arranged_panel *a = &arrangement->panel[arrangement->edge[seam->a].panel],
                            *b = &arrangement->panel[arrangement->edge[seam->b].panel];
        if (a->ring == ring)
            b->u = a->u + seam->step[0], b->v = a->v + seam->step[1], b->ring = ring;
        else
            a->u = b->u - seam->step[0], a->v = b->v - seam->step[1], a->ring = ring;
        arrangement->ring[ring].panels++;
    }
}


/* distance [m] by which a seam of two sides of ring t misses, its panels having their places; 0 for other seams */
static double ring_miss(const mus__arrangement *arrangement, int32_t t, const mus__arranged_seam *seam)
{
    const mus__arranged_panel *a = &arrangement->panel[arrangement->edge[seam->a].panel],
                              *b = &arrangement->panel[arrangement->edge[seam->b].panel];
    if (a->ring != t || b->ring != t) return 0.0;
    return seam->beside * (a->u - b->u + seam->step[0]);
}


/* whether a wider panel of its ring is sewn to a panel above or below: a yoke and what hangs from it */
static bool ring_stacked(const mus__arrangement *arrangement, int32_t p)
{
    for (int32_t i = 0; i < arrangement->nseam; i++) {
        const mus__arranged_edge *a = &arrangement->edge[arrangement->seam[i].a],
                                 *b = &arrangement->edge[arrangement->seam[i].b];
        const mus__arranged_panel *own = &arrangement->panel[p],
                                  *other = &arrangement->panel[a->panel == p ? b->panel : a->panel];
        if ((a->panel != p && b->panel != p) || other->ring != own->ring) continue;
        if (fmin(a->outward[1], b->outward[1]) > -MUS__EDGE_UP || fmax(a->outward[1], b->outward[1]) < MUS__EDGE_UP)
            continue;
        if (other->high[0] - other->low[0] > own->high[0] - own->low[0]) return true;
    }
    return false;
}


/*
 * Where rows of panels above one another close at different girths, a yoke and what hangs from it, the girth is that of
 * the highest row. The places that the first seams gave would put all of the difference to one side; these share it:
 * least squares over all seams that join side by side, weighted by length.
 */
static void ring_even(mus__arrangement *arrangement, int32_t t, double most)
{
    const double girth = arrangement->ring[t].girth;
    for (int32_t sweep = 0; sweep < RING_SWEEPS; sweep++) {
        for (int32_t p = 0; p < arrangement->npanel; p++) {
            double sum = 0.0, weight = 0.0;
            for (int32_t i = 0; i < arrangement->nseam; i++) {
                const mus__arranged_seam *seam = &arrangement->seam[i];
                const mus__arranged_panel *a = &arrangement->panel[arrangement->edge[seam->a].panel],
                                          *b = &arrangement->panel[arrangement->edge[seam->b].panel],
                                          *own = &arrangement->panel[p];
                if (seam->beside == 0 || a == b || a->ring != t || b->ring != t || (a != own && b != own)) continue;
                const double off = a->u - b->u + seam->step[0], turns = girth * floor(off / girth + 0.5);
                if (fabs(off - turns) > RING_LEG * most) continue;
                sum += seam->length * (own == a ? turns - off : off - turns);
                weight += seam->length;
            }
            if (weight > 0.0) arrangement->panel[p].u += sum / weight;
        }
    }
}


/* the girth of a ring: the miss of the highest seam that closes it; without one, the width from first to last side */
static void ring_girth(mus__arrangement *arrangement, int32_t t)
{
    mus__arranged_ring *ring = &arrangement->ring[t];
    double first = 1e30, last = -1e30, widest = 0.0, sum = 0.0, most = 0.0, high = -1e30;
    bool rows = false;
    for (int32_t p = 0; p < arrangement->npanel; p++) {
        const mus__arranged_panel *panel = &arrangement->panel[p];
        if (panel->ring != t) continue;
        const bool stacked = ring_stacked(arrangement, p);
        rows = rows || stacked;
        first = fmin(first, panel->u + panel->low[0]), last = fmax(last, panel->u + panel->high[0]);
        widest = fmax(widest, panel->high[0] - panel->low[0]);
        if (!stacked) sum += panel->high[0] - panel->low[0];
    }
    for (int32_t i = 0; i < arrangement->nseam; i++)
        most = fmax(most, ring_miss(arrangement, t, &arrangement->seam[i]));
    for (int32_t i = 0; i < arrangement->nseam && most > RING_DART * widest; i++) {
        const double miss = ring_miss(arrangement, t, &arrangement->seam[i]);
        if (miss > RING_CLOSES * most && arrangement->seam[i].high > high)
            high = arrangement->seam[i].high, ring->girth = miss, ring->closed = 1;
    }
    for (int32_t i = 0; i < arrangement->nseam && ring->closed; i++) {
        const double part = ring_miss(arrangement, t, &arrangement->seam[i]) / most;
        if (part > RING_LEG && part < 1.0 - RING_LEG) ring->fork = 1;
    }
    ring->wide = ring->closed ? fmax(sum, ring->girth) : last - first;
    if (!ring->closed) ring->girth = last - first;
    if (ring->closed && rows) ring_even(arrangement, t, most);
}


mus_status mus__arrange_rings(mus__arrangement *arrangement)
{
    for (int32_t p = 0; p < arrangement->npanel; p++) {
        mus__arranged_panel *panel = &arrangement->panel[p];
        if (panel->ring != MUS_NONE) continue;
        const int32_t t = arrangement->nring++;
        panel->ring = t;
        arrangement->ring[t].limb = panel->limb;
        arrangement->ring[t].panels = 1;
        arrangement->ring[t].fan = panel->fan;
        ring_grow(arrangement, t);
        ring_girth(arrangement, t);
    }
    ring_components(arrangement);
    return MUS_OK;
}
