/*
 * box_grid.h: which boxes of many are near each other: a grid of cells in a hash table. Broad phase of the exact count
 * of crossings (crossing_count.h), at some tens of nanoseconds a triangle.
 *
 * Boxes are floats, rounded outward by the caller. A cell is as wide as the largest box and the reach, a box is in the
 * cell of its centre, so partners are in the same cell or in one of the 26 around it. Cells are in the order in which
 * boxes, by number, first come to them: the order of pairs depends on places alone.
 */
#ifndef MUS_SELFCONTACT_BOX_GRID_H
#define MUS_SELFCONTACT_BOX_GRID_H

#include "base/base_internal.h"

typedef struct mus__box_slot {
    int64_t key;
    int32_t cell; /* MUS_NONE: no cell has the key */
} mus__box_slot;

typedef struct mus__box_grid {
    int32_t capacity, slots; /* boxes; slots of the table, a power of two */
    float *box;              /* (capacity x 6) low x, y, z, high x, y, z: the caller's */
    float *sorted;           /* (capacity x 6) the same, cell by cell; right behind box */
    int32_t *item;           /* (capacity) which box that is */
    int32_t *of;             /* (capacity) cell of each box; scratch once they are sorted */
    int32_t *start;          /* (capacity + 1) of each cell, in item */
    int64_t *key;            /* (capacity) of each cell */
    mus__box_slot *slot;     /* (slots) */
} mus__box_grid;

typedef void (*mus__box_pair_fn)(void *user, int32_t a, int32_t b);

mus_status mus__box_grid_create(mus_context *context, int32_t capacity, mus__box_grid *grid);
void mus__box_grid_destroy(mus_context *context, mus__box_grid *grid);
/* fn(user, a, b), a < b, for every two of the first n boxes that are at most `reach` apart along each axis */
void mus__box_grid_pairs(mus__box_grid *grid, int32_t n, float reach, mus__box_pair_fn fn, void *user);

#endif
