/*
 * nest.h: irregular strip packing: polygons on a strip of a given height, as short as can be found.
 *
 * This room knows polygons alone: no cloth, no paper. An item lies in one of the ways that the caller has made of it
 * (turned, mirrored); the solver chooses the way and moves it. Two pieces never share a point, which is held by exact
 * predicates at the end. The result depends on the items, the options and the seed, not on the number of threads nor on
 * time. Source of the method: nest_separate.c.
 */
#ifndef MUS_NEST_NEST_H
#define MUS_NEST_NEST_H

#include "base/base_internal.h"

/* one way that an item may lie: a simple polygon, either way round */
typedef struct mus__nest_way {
    int32_t n;
    const double *xy;  /* (n x 2) */
    const double *box; /* low x, low y, high x, high y that is kept within the strip; NULL: that of the polygon */
    double stripe;     /* x of the polygon that is laid on a stripe, when there are stripes */
} mus__nest_way;

typedef struct mus__nest_item {
    int32_t nway;
    const mus__nest_way *ways; /* (nway) */
    bool edge;                 /* lies on the low edge of the strip */
} mus__nest_item;

typedef struct mus__nest_def {
    double height;   /* of the strip; coordinates have any unit */
    double stripe;   /* distance of the stripes across the strip; 0: none */
    int64_t steps;   /* elementary steps of each run; mus__nest_solve counts them */
    int32_t runs;    /* searches from seeds of their own; the shortest layout is taken */
    int32_t threads; /* they share the runs */
    uint64_t seed;
    /* called now and then on the caller's thread with the part of the steps that is done (0 to 1) and the length;
     * nonzero ends the search with the best layout so far */
    int32_t (*progress)(void *user, double done, double length);
    void *user;
} mus__nest_def;

/* where an item lies: its polygon of way `way` moved by x, y */
typedef struct mus__nest_place {
    int32_t way;
    double x, y;
} mus__nest_place;

/* find places (n) for n items and the length that they need. steps gets the steps of all runs, unless NULL. Errors:
 * MUS_ERR_ARG (an item that no way of it is within the strip; *bad is its index), MUS_ERR_MEMORY */
mus_status mus__nest_solve(mus_context *context, int32_t n, const mus__nest_item *items, const mus__nest_def *def,
                           mus__nest_place *places, double *length, int64_t *steps, int32_t *bad);

/* whether two polygons share a point, by exact predicates; boxes (low x, low y, high x, high y) may be NULL */
bool mus__nest_exact_meets(int32_t na, const double *a, int32_t nb, const double *b);

#endif
