/*
 * contour_stack.h: a limb sampled in n fixed directions: radii and slopes at its contours, ready for the in-between
 * contours.
 */
#ifndef MUS_LIMB_CONTOUR_STACK_H
#define MUS_LIMB_CONTOUR_STACK_H

#include "limb/limb.h"

typedef struct mus__stack {
    const mus__limb *limb;
    int32_t n;          /* number of directions */
    const double *turn; /* (n x 2) cosine and sine of the directions; borrowed */
    double *radius;     /* (count x n) [m] */
    double *slope;      /* (count x n) d radius / d s */
    double *centre;     /* (count x 2) [m] */
    double *drift;      /* (count x 2) d centre / d s */
    double cap[2][2];   /* of the caps below and above: s of the middle of the ellipse, and its half axis [m] */
    double *work;       /* scratch: (count) for the slopes, then (3 n) for callers of mus__stack_ring() */
} mus__stack;

/* leave out contours that are nearer than `gap` [m] to a neighbour and whose girth was not given. Errors: MUS_ERR_BODY
 * (two given ones, or no room for a cap; the message names both measures) */
mus_status mus__limb_check(mus_context *context, mus__limb *limb, double gap);
/* sample a limb in n directions `turn` (n x 2), which are borrowed. Errors: MUS_ERR_MEMORY */
mus_status mus__stack_make(mus_context *context, const mus__limb *limb, int32_t n, const double *turn, mus__stack *out);
void mus__stack_free(mus_context *context, mus__stack *stack);
/* mark the contours of a limb beside which the natural spline overshoots, and compute the slopes anew */
void mus__stack_limit(mus__stack *stack, mus__limb *limb);
/* the in-between contour at s [m], also in the caps: centre (2), radius (n) */
void mus__stack_ring(const mus__stack *stack, double s, double *centre, double *radius);

#endif
