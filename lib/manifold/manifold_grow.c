/*
 * manifold_grow.c: a solid without handles: the labels of the largest part of each piece that is a topological ball.
 *
 * From a seed on, what is inside is added, deep layers first, as long as it is simple: its neighbours that belong to
 * the solid are connected among themselves, and so are those that do not, and there are some of both. What grows
 * remains a ball. Where two of its arms meet (a hand on the hip), the last points are left out.
 *
 * It grows twice. First by whole cells that are inside. The cells that are neighbours by
 * their points are the 14 of a lattice whose neighbourhood is that of the points under a linear map (Conway and Sloane,
 * Sphere Packings, Lattices and Groups, 1999, chapter 4: both are the lattice A3*), so the same test says which cell is
 * simple. Then, from the cells that were added, by points.
 */
#include <math.h>
#include <string.h>

#include "manifold/manifold_internal.h"

#define GROW_LEAST 32  /* points of a piece: a smaller one is below the lattice's resolution; chosen */
#define GROW_LAYERS 64 /* most layers: the deeper ones count as one. Chosen: a trunk has 20 cells at 4 mm */

/* layers of points in one spacing of depth; chosen: a point's neighbours lie in another layer than it does */
#define GROW_STEPS 4.0

/* lists by layer of what waits to be added: first in, first out, so that what grows stays compact */
typedef struct growth {
    mus__bcc *lattice;
    int32_t *next;              /* the item after each in its layer's list */
    int32_t first[GROW_LAYERS]; /* first item of each layer's list, MUS_NONE: none */
    int32_t last[GROW_LAYERS];  /* its last one */
    int32_t top;
} growth;


static void grow_begin(growth *grow, mus__bcc *lattice, int32_t *next)
{
    *grow = (growth){.lattice = lattice, .next = next, .top = -1};
    for (int32_t i = 0; i < GROW_LAYERS; i++) grow->first[i] = MUS_NONE;
}


static void grow_queue(growth *grow, int32_t item, int32_t layer)
{
    grow->next[item] = MUS_NONE;
    if (grow->first[layer] == MUS_NONE) grow->first[layer] = item;
    else grow->next[grow->last[layer]] = item;
    grow->last[layer] = item;
    if (layer > grow->top) grow->top = layer;
}


/* the first item of the deepest layer, which is taken out; MUS_NONE: none is left */
static int32_t grow_take(growth *grow)
{
    while (grow->top >= 0 && grow->first[grow->top] == MUS_NONE) grow->top--;
    if (grow->top < 0) return MUS_NONE;
    const int32_t item = grow->first[grow->top];
    grow->first[grow->top] = grow->next[item];
    return item;
}


/* ---- cells ---- */

/* cells that are inside, by their places in the table */
typedef struct grow_cells {
    mus__bcc *lattice;
    uint8_t *layer; /* (grid) cells from the surface, 0: the cell is not inside */
    uint8_t *mark;  /* (grid) MUS__POINT_* */
    int32_t *queue; /* (grid) */
    int32_t step[MUS__LINKS];
} grow_cells;


/* steps in the table to the neighbours of a cell, in the order of the points' */
static void cells_steps(grow_cells *cells)
{
    const int32_t *grid = cells->lattice->grid;
    for (int32_t d = 0; d < MUS__LINKS; d++) {
        const int8_t *step = mus__bcc_step[d];
        const int32_t i = -(step[1] + step[2]) / 2, j = -(step[0] + step[2]) / 2, k = -(step[0] + step[1]) / 2;
        cells->step[d] = (k * grid[1] + j) * grid[0] + i;
    }
}


/* layers by a breadth-first search from outside; returns the number of cells inside */
static int32_t cells_layers(grow_cells *cells, int32_t count)
{
    const int32_t *table = cells->lattice->table;
    int32_t from = 0, to = 0;
    for (int32_t at = 0; at < count; at++) {
        if (table[at] != MUS__CELL_IN) continue;
        bool edge = false;
        for (int32_t d = 0; d < MUS__LINKS && !edge; d++) edge = table[at + cells->step[d]] != MUS__CELL_IN;
        if (edge) cells->layer[at] = 1, cells->queue[to++] = at;
    }
    while (from < to) {
        const int32_t at = cells->queue[from++], deeper = cells->layer[at] + 1;
        for (int32_t d = 0; d < MUS__LINKS; d++) {
            const int32_t next = at + cells->step[d];
            if (table[next] != MUS__CELL_IN || cells->layer[next] != 0) continue;
            cells->layer[next] = (uint8_t)(deeper < GROW_LAYERS ? deeper : GROW_LAYERS - 1);
            cells->queue[to++] = next;
        }
    }
    return to;
}


/* the deepest cell of the largest piece of the n cells in the queue, MUS_NONE: there is none; `stack` is scratch */
static int32_t cells_seed(grow_cells *cells, int32_t n, int32_t *stack)
{
    int32_t most = 0, found = MUS_NONE;
    for (int32_t i = 0; i < n; i++) {
        int32_t waiting = 0, size = 0, deepest = cells->queue[i];
        if (cells->mark[deepest] != 0) continue;
        stack[waiting++] = deepest;
        cells->mark[deepest] = MUS__POINT_SEEN;
        while (waiting > 0) {
            const int32_t at = stack[--waiting];
            size++;
            if (cells->layer[at] > cells->layer[deepest]) deepest = at;
            for (int32_t d = 0; d < MUS__LINKS; d++) {
                const int32_t next = at + cells->step[d];
                if (cells->layer[next] == 0 || cells->mark[next] != 0) continue;
                cells->mark[next] = MUS__POINT_SEEN;
                stack[waiting++] = next;
            }
        }
        if (size > most) most = size, found = deepest;
    }
    return found;
}


/* grow a ball of cells from a seed, then give points to those that were left out. Errors: MUS_ERR_MEMORY, MUS_ERR_ARG
 */
static mus_status cells_ball(grow_cells *cells, growth *grow, int32_t seed, int32_t n)
{
    grow_queue(grow, seed, cells->layer[seed]);
    for (int32_t at = grow_take(grow); at != MUS_NONE; at = grow_take(grow)) {
        uint32_t in = 0;
        cells->mark[at] &= (uint8_t)~MUS__POINT_QUEUED;
        for (int32_t d = 0; d < MUS__LINKS; d++)
            in |= (uint32_t)((cells->mark[at + cells->step[d]] & MUS__POINT_GROWN) != 0) << d;
        if (at != seed && !mus__bcc_simple(grow->lattice, in)) continue;
        cells->mark[at] |= MUS__POINT_GROWN;
        for (int32_t d = 0; d < MUS__LINKS; d++) {
            const int32_t next = at + cells->step[d];
            if (cells->layer[next] == 0 || (cells->mark[next] & (MUS__POINT_GROWN | MUS__POINT_QUEUED)) != 0) continue;
            cells->mark[next] |= MUS__POINT_QUEUED;
            grow_queue(grow, next, cells->layer[next]);
        }
    }
    mus__bcc *lattice = grow->lattice;
    mus_status status = MUS_OK;
    for (int32_t i = 0; i < n && status == MUS_OK; i++)
        if ((cells->mark[cells->queue[i]] & MUS__POINT_GROWN) == 0)
            status = mus__bcc_open(lattice, cells->queue[i], true);
    return status == MUS_OK ? mus__bcc_sample(lattice) : status;
}


/* whole cells. Errors: MUS_ERR_MEMORY, MUS_ERR_ARG */
static mus_status grow_whole(mus__bcc *lattice)
{
    mus_context *context = lattice->context;
    const int32_t count = lattice->grid[0] * lattice->grid[1] * lattice->grid[2];
    int32_t inside = 0;
    for (int32_t at = 0; at < count; at++) inside += lattice->table[at] == MUS__CELL_IN;
    if (inside == 0) return MUS_OK;
    growth grow;
    grow_cells cells = {.lattice = lattice};
    cells.layer = mus__new(context, count, sizeof *cells.layer);
    cells.mark = mus__new(context, count, sizeof *cells.mark);
    cells.queue = mus__room(context, inside, sizeof *cells.queue);
    int32_t *next = mus__room(context, count, sizeof *next);
    mus_status status = MUS_ERR_MEMORY;
    if (cells.layer != NULL && cells.mark != NULL && cells.queue != NULL && next != NULL) {
        cells_steps(&cells);
        cells_layers(&cells, count);
        grow_begin(&grow, lattice, next);
        status = cells_ball(&cells, &grow, cells_seed(&cells, inside, next), inside);
    } else {
        status = mus__fail_memory(context, "the lattice of a manifold");
    }
    mus__free(context, cells.layer);
    mus__free(context, cells.mark);
    mus__free(context, cells.queue);
    mus__free(context, next);
    return status;
}


/* ---- points ---- */

static int32_t points_layer(const mus__bcc *lattice, int32_t point)
{
    return (int32_t)fmin(GROW_STEPS * (double)lattice->depth[point] / lattice->spacing, GROW_LAYERS - 1.0);
}


/* queue the neighbours of a point that are inside and not in the solid */
static void points_beside(growth *grow, int32_t point)
{
    mus__bcc *lattice = grow->lattice;
    for (int32_t d = 0; d < MUS__LINKS; d++) {
        const int32_t next = mus__bcc_next(lattice, point, d);
        const uint8_t label = lattice->label[next];
        if ((label & (MUS__POINT_IN | MUS__POINT_GROWN | MUS__POINT_QUEUED)) != MUS__POINT_IN) continue;
        lattice->label[next] |= MUS__POINT_QUEUED;
        grow_queue(grow, next, points_layer(lattice, next));
    }
}


/* the bits of a point's neighbours that are in the solid */
static uint32_t points_grown(const mus__bcc *lattice, int32_t point)
{
    uint32_t in = 0;
    for (int32_t d = 0; d < MUS__LINKS; d++)
        in |= (uint32_t)((lattice->label[mus__bcc_next(lattice, point, d)] & MUS__POINT_GROWN) != 0) << d;
    return in;
}


/* add points from those that wait on; `seed` is added in any case, MUS_NONE: there is none */
static void points_ball(growth *grow, int32_t seed)
{
    mus__bcc *lattice = grow->lattice;
    for (int32_t point = grow_take(grow); point != MUS_NONE; point = grow_take(grow)) {
        const uint32_t in = points_grown(lattice, point);
        lattice->label[point] = (uint8_t)((lattice->label[point] & ~MUS__POINT_QUEUED) | MUS__POINT_SEEN);
        if (point != seed && !mus__bcc_simple(lattice, in)) continue;
        lattice->label[point] |= MUS__POINT_GROWN;
        points_beside(grow, point);
    }
}


/* the number of points of the piece that holds a point, all of them marked as seen, and its deepest one */
static int32_t points_flood(mus__bcc *lattice, int32_t point, int32_t *stack, int32_t *deepest)
{
    int32_t count = 0, waiting = 0;
    stack[waiting++] = point;
    lattice->label[point] |= MUS__POINT_SEEN;
    *deepest = point;
    while (waiting > 0) {
        const int32_t here = stack[--waiting];
        count++;
        if (lattice->depth[here] > lattice->depth[*deepest]) *deepest = here;
        for (int32_t d = 0; d < MUS__LINKS; d++) {
            const int32_t next = mus__bcc_next(lattice, here, d);
            const uint8_t mask = MUS__POINT_IN | MUS__POINT_SEEN | MUS__POINT_GROWN;
            if ((lattice->label[next] & mask) != MUS__POINT_IN) continue;
            lattice->label[next] |= MUS__POINT_SEEN;
            stack[waiting++] = next;
        }
    }
    return count;
}


/* label as inside what is outside but not connected with the outside: gaps between solids, below the resolution. A
 * shared cell that is outside belongs to the outside. stack: (points) */
static void grow_fill(mus__bcc *lattice, int32_t *stack)
{
    const int32_t points = lattice->cells * MUS__CELL_POINTS, own = MUS__CELLS_SHARED * MUS__CELL_POINTS;
    for (int32_t i = own; i < points; i++) {
        if (lattice->label[i] != 0) continue;
        int32_t count = 1;
        bool open = false;
        stack[0] = i;
        lattice->label[i] = MUS__POINT_SEEN;
        for (int32_t k = 0; k < count; k++)
            for (int32_t d = 0; d < MUS__LINKS; d++) {
                const int32_t next = mus__bcc_next(lattice, stack[k], d);
                open = open || next / MUS__CELL_POINTS == MUS__CELL_OUT;
                if (mus__bcc_shared(next) || lattice->label[next] != 0) continue;
                lattice->label[next] = MUS__POINT_SEEN;
                stack[count++] = next;
            }
        for (int32_t k = 0; k < count && !open; k++) mus__bcc_flip(lattice, stack[k]);
    }
    for (int32_t i = own; i < points; i++) lattice->label[i] &= MUS__POINT_IN;
}


/* add a cluster of points that were left out back to the solid, where that changes neither pieces nor handles: the
 * order in which points are added may leave some that are in nobody's way */
static void points_return(mus__bcc *lattice, int32_t point, int32_t *stack)
{
    int32_t count = 1, change = 0;
    stack[0] = point;
    for (int32_t i = 0; i < count; i++) {
        const uint32_t in = points_grown(lattice, stack[i]);
        int32_t edges, triangles;
        const int32_t vertices = mus__bcc_link(lattice, in, &edges, &triangles);
        change += 1 - vertices + edges - triangles;
        lattice->label[stack[i]] |= MUS__POINT_GROWN;
        for (int32_t d = 0; d < MUS__LINKS; d++) {
            const int32_t next = mus__bcc_next(lattice, stack[i], d);
            const uint8_t mask = MUS__POINT_IN | MUS__POINT_QUEUED | MUS__POINT_GROWN;
            if ((lattice->label[next] & mask) != MUS__POINT_IN) continue;
            lattice->label[next] |= MUS__POINT_QUEUED;
            stack[count++] = next;
        }
    }
    if (change == 0) return;
    for (int32_t i = 0; i < count; i++) {
        lattice->label[stack[i]] &= (uint8_t)~MUS__POINT_GROWN;
        lattice->label[stack[i]] |= MUS__POINT_QUEUED;
    }
}


/* grow from the cells that were grown, then in pieces without such a cell; next and stack: (points) */
static void grow_points(mus__bcc *lattice, int32_t *next, int32_t *stack)
{
    const int32_t points = lattice->cells * MUS__CELL_POINTS, own = MUS__CELLS_SHARED * MUS__CELL_POINTS;
    growth grow;
    grow_begin(&grow, lattice, next);
    memset(lattice->label + MUS__CELL_IN * MUS__CELL_POINTS, MUS__POINT_IN | MUS__POINT_GROWN, MUS__CELL_POINTS);
    for (int32_t i = own; i < points; i++) {
        if ((lattice->label[i] & MUS__POINT_IN) == 0 || points_grown(lattice, i) == 0) continue;
        lattice->label[i] |= MUS__POINT_QUEUED;
        grow_queue(&grow, i, points_layer(lattice, i));
    }
    points_ball(&grow, MUS_NONE);
    for (int32_t i = own; i < points; i++) {
        int32_t deepest;
        if ((lattice->label[i] & (MUS__POINT_IN | MUS__POINT_SEEN)) != MUS__POINT_IN) continue;
        if (points_flood(lattice, i, stack, &deepest) < GROW_LEAST) continue;
        grow_queue(&grow, deepest, points_layer(lattice, deepest));
        points_ball(&grow, deepest);
    }
    for (int32_t i = own; i < points; i++) {
        const uint8_t mask = MUS__POINT_IN | MUS__POINT_QUEUED | MUS__POINT_GROWN;
        if ((lattice->label[i] & mask) == MUS__POINT_IN) points_return(lattice, i, stack);
    }
    memset(lattice->label + MUS__CELL_IN * MUS__CELL_POINTS, MUS__POINT_IN, MUS__CELL_POINTS);
    for (int32_t i = own; i < points; i++) {
        const bool gone = (lattice->label[i] & (MUS__POINT_IN | MUS__POINT_GROWN)) == MUS__POINT_IN;
        lattice->label[i] &= MUS__POINT_IN;
        if (gone) mus__bcc_flip(lattice, i);
    }
}


mus_status mus__bcc_grow(mus__bcc *lattice, bool always)
{
    mus_status status = MUS_OK;
    int64_t points = (int64_t)lattice->cells * MUS__CELL_POINTS;
    int32_t *next = NULL, *stack = mus__room(lattice->context, points, sizeof *stack);
    if (stack == NULL) return mus__fail_memory(lattice->context, "the lattice of a manifold");
    grow_fill(lattice, stack);
    if (!always && mus__bcc_euler(lattice) == 2) goto end;
    status = grow_whole(lattice);
    if (status != MUS_OK) goto end;
    mus__free(lattice->context, stack);
    points = (int64_t)lattice->cells * MUS__CELL_POINTS;
    stack = mus__room(lattice->context, points, sizeof *stack);
    next = mus__room(lattice->context, points, sizeof *next);
    if (next == NULL || stack == NULL) {
        status = mus__fail_memory(lattice->context, "the lattice of a manifold");
        goto end;
    }
    grow_points(lattice, next, stack);
    status = mus__bcc_beside(lattice, MUS__CELLS_SHARED);

end:
    mus__free(lattice->context, next);
    mus__free(lattice->context, stack);
    return status;
}
