/*
 * nest_internal.h: what the files of the solver share: shapes, the state of a run.
 */
#ifndef MUS_NEST_NEST_INTERNAL_H
#define MUS_NEST_NEST_INTERNAL_H

#include "nest/nest.h"

#define MUS__NEST_LANES 8  /* circles that are looked at together; a power of two */
#define MUS__NEST_POLES 16 /* most inscribed circles of a shape; a multiple of the lanes */

/* disjoint circles inside a shape, the largest first; the last lanes are filled with circles of radius 0 */
typedef struct mus__nest_poles {
    int32_t n; /* a multiple of the lanes */
    float x[MUS__NEST_POLES], y[MUS__NEST_POLES], r[MUS__NEST_POLES];
} mus__nest_poles;

/* a way of an item, as the search needs it: coordinates count from the middle of the box */
typedef struct mus__nest_shape {
    int32_t n;
    double *xy;          /* (n x 2) */
    const double *given; /* (n x 2) as the caller gave it */
    double middle[2];    /* of the box, in the caller's coordinates */
    double half[2];      /* half the width and the height of the box */
    double low[2];       /* what is kept within the strip, */
    double high[2];      /* counted from the middle */
    double diameter;     /* of the box */
    double size;         /* square root of the area of the convex hull */
    double least;        /* the shorter side of the box */
    double stripe;       /* x that is laid on a stripe */
    mus__nest_poles poles;
} mus__nest_shape;

/* where a piece lies: the middle of its box */
typedef struct mus__nest_at {
    int32_t way;
    double x, y;
} mus__nest_at;

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

/* ---- shapes (nest_shape.c) ---- */

/* make the shape of a way; xy has room for its points */
mus_status mus__nest_shape_make(mus_context *context, const mus__nest_way *way, double *xy, mus__nest_shape *shape);

/* the place of an item in the caller's coordinates, and its outline there: out (n x 2) */
void mus__nest_placed(const mus__nest_shape *shape, const mus__nest_at *at, mus__nest_place *out);
void mus__nest_outline(const mus__nest_shape *shape, const mus__nest_at *at, double *out);

/* ---- pairs (nest_pair.c, nest_poles_f32.c) ---- */

/* whether shape b, moved by `shift` against a, shares a point with it; near has room for the sides of a */
bool mus__nest_meets(const mus__nest_shape *a, const mus__nest_shape *b, const double *shift, int32_t *near,
                     int64_t *steps);
/* how much they overlap: 0 when they do not, else a smooth measure above 0 */
double mus__nest_loss(const mus__nest_shape *a, const mus__nest_shape *b, const double *shift, int32_t *near,
                      int64_t *steps);
/* sum over pairs of circles of depth times the lesser radius; b is moved by dx, dy */
float mus__nest_poles_f32(const mus__nest_poles *a, const mus__nest_poles *b, float dx, float dy, float epsilon);

/* ---- a run ---- */

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
