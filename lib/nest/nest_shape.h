/*
 * nest_shape.h: shapes as the search needs them, and how two of them overlap.
 */
#ifndef MUS_NEST_NEST_SHAPE_H
#define MUS_NEST_NEST_SHAPE_H

#include "nest/nest.h"

#define MUS__NEST_POLES 16 /* inscribed circles of a shape at most; a power of two: two vectors of AVX2 */

#define MUS__NEST_RUN_SIDES 8 /* sides whose box spares to look at them; chosen: changes the time alone */

/* disjoint circles inside a shape, the largest first; after the first n all have radius 0 */
typedef struct mus__nest_poles {
    int32_t n;
    float x[MUS__NEST_POLES], y[MUS__NEST_POLES], r[MUS__NEST_POLES];
} mus__nest_poles;

/* a way of an item, as the search needs it: coordinates count from the middle of the box */
typedef struct mus__nest_shape {
    int32_t n;
    double *xy;          /* (n x 2) */
    double *runs;        /* (runs x 4) low x, low y, high x, high y of each MUS__NEST_RUN_SIDES sides */
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

/* number of runs of n sides */
static inline int32_t mus__nest_runs(int32_t n)
{
    return (n + MUS__NEST_RUN_SIDES - 1) / MUS__NEST_RUN_SIDES;
}

/* make the shape of a way; xy has room for its points, runs for the boxes of its runs */
mus_status mus__nest_shape_make(mus_context *context, const mus__nest_way *way, double *xy, double *runs,
                                mus__nest_shape *shape);

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

#endif
