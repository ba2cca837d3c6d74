/*
 * manifold_label.c: labels of points whose surface is a manifold of spheres: a solid grown without handles, and points
 * moved onto the surface.
 *
 * Both rest on the link of a point: the sphere of triangles that its 14 neighbours span. A point is simple if those of
 * its neighbours that are inside are connected, and so are those that are outside, and there are some of both. To
 * change the label of a simple point does not change the topology of the solid (Bertrand and Malandain, 1994; on this
 * lattice the test is exact).
 *
 * Growing: the points inside get layers, by the number of edges from the outside. From a point of the deepest layer
 * of each piece on, points are added, deep layers first, as long as they are simple. What grows is a ball; where two of
 * its arms meet, the last points are left out.
 *
 * Snapping: a point with a crossing nearer than 0.25 of a long edge or 0.41 of a short one is moved onto that crossing
 * and counts as inside. The tetrahedra stay the right way round (Labelle and Shewchuk, 2007, section 3), so that the
 * surface, which has one piece in each, cannot cross itself. The surface shrinks onto the moved points; it remains a
 * manifold if three conditions hold about each of them: the point is simple or has no neighbour outside; on each edge
 * to another moved point the outside neighbours of both are connected; and of the two points opposite to a triangle of
 * moved points at most one is outside.
 */
#include <math.h>
#include <string.h>

#include "manifold/manifold_internal.h"

/* a crossing nearer to a point than this share of a long edge or a short one draws it to the surface; Labelle and
 * Shewchuk, 2007, table 1: the limits up to which no tetrahedron turns over */
#define LABEL_LONG 0.24999
#define LABEL_SHORT 0.41189

#define LABEL_LEAST 32    /* points of a piece: a smaller one is below the lattice's resolution; chosen */
#define LABEL_LAYERS 4096 /* most layers: the deeper ones count as one. Chosen: a trunk has 60 at 4 mm */

/* the surroundings of a point: bit d of a mask is its neighbour in direction d */
typedef struct link {
    uint32_t in, on, out;
    int32_t next[MUS__LINKS];
} link;


static void label_link(const mus__bcc *lattice, int32_t point, uint8_t inside, link *out)
{
    out->in = out->on = 0;
    for (int32_t d = 0; d < MUS__LINKS; d++) {
        const int32_t next = mus__bcc_next(lattice, point, d);
        const uint8_t label = next == MUS_NONE ? 0 : lattice->label[next];
        out->next[d] = next;
        if ((label & inside) != 0) out->in |= 1u << d;
        if ((label & MUS__POINT_ON) != 0) out->on |= 1u << d;
    }
    out->out = ~out->in & ((1u << MUS__LINKS) - 1);
}


/* whether the neighbours of a mask are connected in the link; true for none */
static bool label_connected(const mus__bcc *lattice, uint32_t mask)
{
    uint32_t reached = mask & (~mask + 1), before = 0;
    while (reached != before) {
        before = reached;
        for (int32_t d = 0; d < MUS__LINKS; d++)
            if ((reached >> d & 1) != 0) reached |= lattice->touch[d] & mask;
    }
    return reached == mask;
}


/* one bit for each set of neighbours inside: whether the point is simple */
static void label_table(mus__bcc *lattice)
{
    const uint32_t all = (1u << MUS__LINKS) - 1;
    for (uint32_t in = 1; in < all; in++)
        if (label_connected(lattice, in) && label_connected(lattice, all & ~in))
            lattice->simple[in / 8] |= (uint8_t)(1u << in % 8);
}


static bool label_simple(const mus__bcc *lattice, const link *at)
{
    return (lattice->simple[at->in / 8] >> at->in % 8 & 1) != 0;
}


/* ---- growing ---- */

typedef struct growth {
    mus__bcc *lattice;
    int32_t *queue, *next;       /* (points) work of the floods; the point after each in its layer's list */
    uint16_t *layer;             /* (points) edges from the outside, 0: outside */
    int32_t first[LABEL_LAYERS]; /* first point of each layer's list, MUS_NONE: none */
    int32_t last[LABEL_LAYERS];  /* its last one */
    int32_t top;
} growth;


/* layers of the points inside, by a breadth-first search from the outside */
static void label_layers(growth *grow)
{
    mus__bcc *lattice = grow->lattice;
    int32_t from = 0, to = 0;
    for (int32_t point = 0; point < lattice->blocks * MUS__BLOCK_POINTS; point++) {
        if ((lattice->label[point] & MUS__POINT_IN) == 0) continue;
        for (int32_t d = 0; d < MUS__LINKS && grow->layer[point] == 0; d++) {
            const int32_t next = mus__bcc_next(lattice, point, d);
            if (next == MUS_NONE || (lattice->label[next] & MUS__POINT_IN) == 0) grow->layer[point] = 1;
        }
        if (grow->layer[point] != 0) grow->queue[to++] = point;
    }
    while (from < to) {
        const int32_t point = grow->queue[from++], deeper = grow->layer[point] + 1;
        for (int32_t d = 0; d < MUS__LINKS; d++) {
            const int32_t next = mus__bcc_next(lattice, point, d);
            if (next == MUS_NONE || (lattice->label[next] & MUS__POINT_IN) == 0 || grow->layer[next] != 0) continue;
            grow->layer[next] = (uint16_t)(deeper < LABEL_LAYERS ? deeper : LABEL_LAYERS - 1);
            grow->queue[to++] = next;
        }
    }
}


/* mark the piece that holds a point; returns its number of points and its deepest one */
static int32_t label_flood(growth *grow, int32_t point, int32_t *deepest)
{
    mus__bcc *lattice = grow->lattice;
    int32_t count = 0, waiting = 0;
    grow->queue[waiting++] = point;
    lattice->label[point] |= MUS__POINT_SEEN;
    *deepest = point;
    while (waiting > 0) {
        const int32_t here = grow->queue[--waiting];
        count++;
        if (grow->layer[here] > grow->layer[*deepest]) *deepest = here;
        for (int32_t d = 0; d < MUS__LINKS; d++) {
            const int32_t next = mus__bcc_next(lattice, here, d);
            if (next == MUS_NONE || (lattice->label[next] & (MUS__POINT_IN | MUS__POINT_SEEN)) != MUS__POINT_IN)
                continue;
            lattice->label[next] |= MUS__POINT_SEEN;
            grow->queue[waiting++] = next;
        }
    }
    return count;
}


/* append a point to the list of its layer: first in, first out, so that the growing solid stays compact */
static void label_queue(growth *grow, int32_t point)
{
    const int32_t layer = grow->layer[point];
    grow->next[point] = MUS_NONE;
    if (grow->first[layer] == MUS_NONE) grow->first[layer] = point;
    else grow->next[grow->last[layer]] = point;
    grow->last[layer] = point;
    grow->lattice->label[point] |= MUS__POINT_QUEUED;
    if (layer > grow->top) grow->top = layer;
}


/* grow a ball from a point; its points get the mark MUS__POINT_ON */
static void label_ball(growth *grow, int32_t seed)
{
    mus__bcc *lattice = grow->lattice;
    label_queue(grow, seed);
    while (grow->top >= 0) {
        const int32_t point = grow->first[grow->top];
        if (point == MUS_NONE) {
            grow->top--;
            continue;
        }
        link at;
        grow->first[grow->top] = grow->next[point];
        lattice->label[point] &= (uint8_t)~MUS__POINT_QUEUED;
        label_link(lattice, point, MUS__POINT_ON, &at);
        if (point != seed && !label_simple(lattice, &at)) continue;
        lattice->label[point] |= MUS__POINT_ON;
        for (int32_t d = 0; d < MUS__LINKS; d++) {
            const int32_t next = at.next[d], mask = MUS__POINT_IN | MUS__POINT_ON | MUS__POINT_QUEUED;
            if (next != MUS_NONE && (lattice->label[next] & mask) == MUS__POINT_IN) label_queue(grow, next);
        }
    }
}


mus_status mus__bcc_grow(mus__bcc *lattice)
{
    const int32_t points = lattice->blocks * MUS__BLOCK_POINTS;
    growth grow = {.lattice = lattice, .top = -1};
    label_table(lattice);
    for (int32_t i = 0; i < LABEL_LAYERS; i++) grow.first[i] = MUS_NONE;
    grow.queue = mus__room(lattice->context, points, sizeof *grow.queue);
    grow.next = mus__room(lattice->context, points, sizeof *grow.next);
    grow.layer = mus__new(lattice->context, points, sizeof *grow.layer);
    mus_status status = MUS_OK;
    if (grow.queue == NULL || grow.next == NULL || grow.layer == NULL)
        status = mus__fail_memory(lattice->context, "the lattice of a manifold");
    else
        label_layers(&grow);
    for (int32_t i = 0; i < points && status == MUS_OK; i++) {
        int32_t deepest;
        if ((lattice->label[i] & (MUS__POINT_IN | MUS__POINT_SEEN)) != MUS__POINT_IN) continue;
        if (label_flood(&grow, i, &deepest) >= LABEL_LEAST) label_ball(&grow, deepest);
    }
    for (int32_t b = 0; b < lattice->blocks && status == MUS_OK; b++) {
        int32_t inside = 0;
        for (int32_t i = 0; i < MUS__BLOCK_POINTS; i++) {
            uint8_t *label = &lattice->label[b * MUS__BLOCK_POINTS + i];
            *label = (*label & MUS__POINT_ON) != 0 ? MUS__POINT_IN : 0;
            inside += *label;
        }
        lattice->kind[b] = inside == 0 ? 0 : inside == MUS__BLOCK_POINTS ? 1 : 2;
    }
    mus__free(lattice->context, grow.queue);
    mus__free(lattice->context, grow.next);
    mus__free(lattice->context, grow.layer);
    return status;
}


/* ---- snapping ---- */

/* whether the surface is a manifold about a point that was moved onto it */
static bool label_good(const mus__bcc *lattice, int32_t point)
{
    link at;
    label_link(lattice, point, MUS__POINT_IN, &at);
    if (at.out == 0) return true;
    if (!label_simple(lattice, &at)) return false;
    for (int32_t d = 0; d < MUS__LINKS; d++) {
        if ((at.on >> d & 1) == 0) continue;
        const uint32_t round = lattice->touch[d];
        if ((round & at.in) == 0 || !label_connected(lattice, round & at.out)) return false;
        for (int32_t e = 0; e < d; e++)
            if ((at.on & round) >> e & 1 && (round & lattice->touch[e] & at.in) == 0) return false;
    }
    return true;
}


/* the direction of the nearest crossing that draws a point to it; MUS_NONE: there is none */
static int32_t label_draw(const mus__bcc *lattice, int32_t point)
{
    const int32_t in = lattice->label[point] & MUS__POINT_IN;
    int32_t found = MUS_NONE;
    double nearest = 1.0;
    for (int32_t d = 0; d < MUS__LINKS; d++) {
        const int32_t next = mus__bcc_next(lattice, point, d);
        const uint8_t label = next == MUS_NONE ? 0 : lattice->label[next];
        if ((label & MUS__POINT_IN) == in || (label & MUS__POINT_ON) != 0) continue;
        const int32_t at = mus__bcc_crossing(lattice, point, d);
        const double t = d < MUS__OWNED ? (double)lattice->part[at] : 1.0 - (double)lattice->part[at];
        const bool is_long = d % MUS__OWNED < 3;
        const double most = is_long ? LABEL_LONG : LABEL_SHORT, length = is_long ? t : 0.5 * sqrt(3.0) * t;
        if (lattice->cut[at] || t >= most || length >= nearest) continue;
        nearest = length, found = d;
    }
    return found;
}


void mus__bcc_snap(mus__bcc *lattice)
{
    label_table(lattice);
    for (int32_t b = 0; b < lattice->blocks; b++) {
        if (mus__bcc_plain(lattice, b)) continue;
        for (int32_t point = b * MUS__BLOCK_POINTS; point < (b + 1) * MUS__BLOCK_POINTS; point++) {
            const uint8_t before = lattice->label[point];
            const int32_t d = label_draw(lattice, point);
            if (d == MUS_NONE) continue;
            lattice->label[point] = (uint8_t)(MUS__POINT_IN | MUS__POINT_ON | d << 4);

            /* a point that comes inside changes the surroundings of its neighbours */
            bool good = label_good(lattice, point);
            for (int32_t e = 0; e < MUS__LINKS && good && before == 0; e++) {
                const int32_t next = mus__bcc_next(lattice, point, e);
                if (next != MUS_NONE && (lattice->label[next] & MUS__POINT_ON) != 0) good = label_good(lattice, next);
            }
            if (!good) lattice->label[point] = before;
        }
    }
}
