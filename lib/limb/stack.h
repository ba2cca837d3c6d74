/*
 * stack.h: a limb sampled in n fixed directions: radii and slopes at its contours, ready for the in-between contours.
 */
#ifndef MUS_LIMB_STACK_H
#define MUS_LIMB_STACK_H

#include "limb/limb.h"

typedef struct mus__stack {
    const mus__limb *limb;
    int32_t n;
    const double *turn; /* (n x 2) cos, sin of the directions */
    double *radius;     /* (count x n) */
    double *slope;      /* (count x n) d radius / d s */
    double *centre;     /* (count x 2) */
    double *drift;      /* (count x 2) d centre / d s */
    double cap[2][2];   /* of the closing caps below and above: s of the ellipse's middle, half axis */
    double *work;       /* (count + 3 n): of the slopes, then 3 n of who asks rings */
} mus__stack;

/* contours in order and far enough apart: soft ones in the way are left out, two hard ones are MUS_ERR_BODY */
mus_status mus__limb_check(mus_context *context, mus__limb *limb, double gap);
mus_status mus__stack_make(mus_context *context, const mus__limb *limb, int32_t n, const double *turn, mus__stack *out);
void mus__stack_free(mus_context *context, mus__stack *stack);
/* mark the contours of a limb where the natural spline overshoots, then take the stack's slopes anew */
void mus__stack_limit(mus__stack *stack, mus__limb *limb);
/* the in-between contour at s: centre (2), radius (n) */
void mus__stack_ring(const mus__stack *stack, double s, double *centre, double *radius);

#endif
