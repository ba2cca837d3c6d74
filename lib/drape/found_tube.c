/*
 * found_tube.c: panels side by side make a tube; round it, each has its place.
 *
 * Seams between a right and a left side are taken from the top down, each once as long as it joins a new panel: what is
 * highest goes right round the trunk, what is lower down may go round one leg only. The seam that closes the ring
 * misses by the girth. A tube that nothing closes (an open front, half of a circle skirt) is as wide as its panels.
 */
#include <math.h>

#include "drape/found.h"

#define TUBE_DART 0.6   /* of the widest panel: what misses by less is a dart */
#define TUBE_LEG 0.3    /* of the most: what misses by a part between this and the rest closes a leg */
#define TUBE_CLOSES 0.5 /* of the most that a seam misses by: what misses by less does not close the ring */


static int32_t tube_root(int32_t *link, int32_t i)
{
    while (link[i] != i) i = link[i] = link[link[i]];
    return i;
}


/* what hangs together by any seam: tube->piece of each tube */
static void tube_pieces(mus__found *found)
{
    int32_t *link = found->work;
    for (int32_t p = 0; p < found->npanel; p++) link[p] = p;
    for (int32_t i = 0; i < found->nseam; i++) {
        const int32_t a = tube_root(link, found->edge[found->seam[i].a].panel);
        const int32_t b = tube_root(link, found->edge[found->seam[i].b].panel);
        link[a > b ? a : b] = a > b ? b : a;
    }
    for (int32_t p = 0; p < found->npanel; p++) found->tube[found->panel[p].tube].piece = tube_root(link, p);
}


/* the highest seam that joins a panel of the tube to one of none; NULL without */
static const found_seam *tube_next(const mus__found *found, int32_t tube)
{
    const found_seam *best = NULL;
    for (int32_t i = 0; i < found->nseam; i++) {
        const found_seam *seam = &found->seam[i];
        const int32_t a = found->panel[found->edge[seam->a].panel].tube;
        const int32_t b = found->panel[found->edge[seam->b].panel].tube;
        if (seam->beside == 0 || !((a == tube && b == MUS_NONE) || (b == tube && a == MUS_NONE))) continue;
        if (best == NULL || seam->high > best->high) best = seam;
    }
    return best;
}


static void tube_grow(mus__found *found, int32_t tube)
{
    const found_seam *seam;
    while ((seam = tube_next(found, tube)) != NULL) {
        found_panel *a = &found->panel[found->edge[seam->a].panel], *b = &found->panel[found->edge[seam->b].panel];
        if (a->tube == tube) b->u = a->u + seam->step[0], b->v = a->v + seam->step[1], b->tube = tube;
        else a->u = b->u - seam->step[0], a->v = b->v - seam->step[1], a->tube = tube;
        found->tube[tube].panels++;
    }
}


/* how much a seam of two sides of tube t misses by when its panels have their places; 0 for other seams */
static double tube_miss(const mus__found *found, int32_t t, const found_seam *seam)
{
    const found_panel *a = &found->panel[found->edge[seam->a].panel], *b = &found->panel[found->edge[seam->b].panel];
    if (a->tube != t || b->tube != t) return 0.0;
    return seam->beside * (a->u - b->u + seam->step[0]);
}


/* once round: what the highest of the seams misses by that close the ring; else from its first side to its last */
static void tube_girth(mus__found *found, int32_t t)
{
    found_tube *tube = &found->tube[t];
    double first = 1e30, last = -1e30, widest = 0.0, sum = 0.0, most = 0.0, high = -1e30;
    for (int32_t p = 0; p < found->npanel; p++) {
        const found_panel *panel = &found->panel[p];
        if (panel->tube != t) continue;
        first = fmin(first, panel->u + panel->low[0]), last = fmax(last, panel->u + panel->high[0]);
        widest = fmax(widest, panel->high[0] - panel->low[0]);
        sum += panel->high[0] - panel->low[0];
    }
    for (int32_t i = 0; i < found->nseam; i++) most = fmax(most, tube_miss(found, t, &found->seam[i]));
    for (int32_t i = 0; i < found->nseam && most > TUBE_DART * widest; i++) {
        const double miss = tube_miss(found, t, &found->seam[i]);
        if (miss > TUBE_CLOSES * most && found->seam[i].high > high)
            high = found->seam[i].high, tube->girth = miss, tube->ring = 1;
    }
    for (int32_t i = 0; i < found->nseam && tube->ring; i++) {
        const double part = tube_miss(found, t, &found->seam[i]) / most;
        if (part > TUBE_LEG && part < 1.0 - TUBE_LEG) tube->fork = 1;
    }
    tube->wide = tube->ring ? fmax(sum, tube->girth) : last - first;
    if (!tube->ring) tube->girth = last - first;
}


mus_status mus__found_tubes(mus__found *found)
{
    for (int32_t p = 0; p < found->npanel; p++) {
        found_panel *panel = &found->panel[p];
        if (panel->tube != MUS_NONE) continue;
        const int32_t t = found->ntube++;
        panel->tube = t;
        found->tube[t].site = panel->site;
        found->tube[t].panels = 1;
        found->tube[t].fan = panel->fan;
        tube_grow(found, t);
        tube_girth(found, t);
    }
    tube_pieces(found);
    return MUS_OK;
}
