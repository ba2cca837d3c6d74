/*
 * nest_run.h: a packing problem, and the state of one run.
 */
#ifndef MUS_NEST_NEST_RUN_H
#define MUS_NEST_NEST_RUN_H

#include "nest/nest_shape.h"

typedef struct mus__nest_problem {
    const mus__nest_def *def;
    int32_t n;
    int32_t nshape, most;    /* number of shapes; most points of one */
    mus__nest_shape *shapes; /* (nshape) */
    int32_t *first;          /* (n) shape of the first way of each item */
    int32_t *nway;           /* (n) */
    bool *edge;              /* (n) */
    double *area;            /* (n) of the hull of the first way */
    double shortest;         /* no layout is shorter: the widest item, and the area */
} mus__nest_problem;

/* a layout that is kept: `at` (n) */
typedef struct mus__nest_kept {
    double length, loss;
    mus__nest_at *at;
} mus__nest_kept;

#define MUS__NEST_POOL 12 /* layouts with overlaps that are kept to go on from; chosen */

/* the state of one run; made before it starts, so that a run allocates nothing */
typedef struct mus__nest_run {
    const mus__nest_problem *problem;
    uint64_t random;
    int64_t steps, limit;  /* done, and allowed */
    int64_t told;          /* steps at the last call of progress */
    bool tells;            /* runs on the caller's thread */
    _Atomic int32_t *stop; /* shared by all runs: nonzero when progress asked to stop */
    int32_t index;         /* number of the run */
    double length;         /* of the strip now */
    mus__nest_at *at;      /* (n) */
    double *box;           /* (n x 4) low x, high x, low y, high y */
    double *loss;          /* (n x n) of each pair, 0 without overlap; symmetric */
    double *weight;        /* (n x n) symmetric */
    int32_t *order;        /* (n) */
    int32_t *near;         /* (most) sides of a shape near another */
    double *corners;       /* (2 x most x 2) outlines of two items as they lie */
    mus__nest_kept best;   /* the shortest layout without overlaps */
    mus__nest_kept least;  /* the layout of least loss of a separation */
    int32_t npool;
    mus__nest_kept pool[MUS__NEST_POOL]; /* the least loss first */
} mus__nest_run;

/* ---- a run (nest_run.c) ---- */

static inline const mus__nest_shape *mus__nest_shape_of(const mus__nest_run *run, int32_t i, int32_t way)
{
    return &run->problem->shapes[run->problem->first[i] + way];
}

/* whether a shape is within a strip of that length */
static inline bool mus__nest_fits(const mus__nest_problem *problem, const mus__nest_shape *shape, double length)
{
    return shape->high[0] - shape->low[0] <= length && shape->high[1] - shape->low[1] <= problem->def->height;
}

/* next random number; Steele, Lea, Flood, Fast splittable pseudorandom number generators, 2014 */
static inline uint64_t mus__nest_random(mus__nest_run *run)
{
    uint64_t z = run->random += UINT64_C(0x9e3779b97f4a7c15);
    z = (z ^ (z >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94d049bb133111eb);
    return z ^ (z >> 31);
}

/* from 0 to below 1 */
static inline double mus__nest_uniform(mus__nest_run *run)
{
    return (double)(mus__nest_random(run) >> 11) * (1.0 / 9007199254740992.0);
}

static inline int32_t mus__nest_below(mus__nest_run *run, int32_t n)
{
    return (int32_t)(mus__nest_uniform(run) * n);
}

/* whether the run is to end: no steps left, or stopped */
bool mus__nest_over(mus__nest_run *run);
/* the place nearest to `at` that is within the strip, on a stripe, on the edge */
void mus__nest_clamp(const mus__nest_run *run, int32_t i, mus__nest_at *at);
/* lay item i there: its box and the loss of its pairs */
void mus__nest_put(mus__nest_run *run, int32_t i, const mus__nest_at *at);
/* weighted loss of item i at a place, or at least `bound` */
double mus__nest_weigh(mus__nest_run *run, int32_t i, const mus__nest_at *at, double bound);
/* move item i to a place of less weighted loss, if one is found (nest_search.c) */
void mus__nest_search(mus__nest_run *run, int32_t i);
/* move items until none overlap; false when that was given up after `strikes` times `patience` rounds without progress
 * (nest_separate.c) */
bool mus__nest_separate(mus__nest_run *run, int32_t strikes, int32_t patience);
void mus__nest_keep(const mus__nest_run *run, double loss, mus__nest_kept *kept);
void mus__nest_restore(mus__nest_run *run, const mus__nest_kept *kept);
/* the search of one run: run->best gets its layout (nest_explore.c) */
void mus__nest_explore(mus__nest_run *run);

#endif
