/*
 * field.h: a part of a limb as a table of radii: what contact asks.
 *
 * A limb stands on a straight axis: point = origin + s*axis + a*side + b*front, with s along the axis and (a, b) in
 * the plane of the contour. Rings are `ds` apart in s; at each the spline between the limb's contours has been
 * sampled: its centre (ca, cb) and its radius at `nangle` equal steps of the diamond angle. The diamond angle of
 * (a, b), 0..4, needs one division and no atan2:  q = b/(|a|+|b|) in the first quadrant, and so on round.
 *
 * Query at a point: ring k = floor((s-s0)/ds), blend of rings k and k+1, radius R by linear blend over the angle:
 * F = rho - R(s, q), and to first order the signed distance is F/|grad F|, the outward normal grad F/|grad F|.
 * The first and the last ring are the limb's first and last contour, or lie in the round cap with which a part closes
 * beyond a joint; beyond them a form is asked that is smooth through the pole and beyond it (field_kernel.h).
 */
#ifndef MUS_LIMB_FIELD_H
#define MUS_LIMB_FIELD_H

#include "limb/stack.h"

#define MUS__FIELD_ANGLES 128 /* steps of the diamond angle: the table follows a contour to 0.1 mm */

/* a range of a limb's stack that moves rigidly with one joint */
typedef struct mus__part {
    int32_t limb, joint;
    double end[2];   /* s where it begins and ends: a joint, or the contour that ends the limb */
    double round[2]; /* length of the round cap beyond a joint, 0: the limb ends here with its own cap */
} mus__part;

typedef struct mus__field {
    double origin[3];
    double axis[3];  /* unit: s grows along it */
    double side[3];  /* unit: a */
    double front[3]; /* unit: b = axis x side or its opposite, right-handed (side, front, axis) */
    double s0, ds;
    int32_t nring;   /* >= 2 */
    int32_t nangle;  /* multiple of 4; angle step is 4/nangle in diamond angle */
    double *centre;  /* (nring x 2) ca, cb */
    double *radius;  /* (nring x nangle) */
    double reach;    /* largest radius + centre offset: quick reject */
    double *largest; /* (nring) largest radius of rings k and k + 1 */
    double pole[2];   /* s of the ends */
    double middle[2]; /* s of the middle of the caps' ellipse, and its half axis */
    double half[2];
} mus__field;

/* directions (n x 2) of n equal steps of the diamond angle */
void mus__field_turns(int32_t n, double *turn);
/* sample a part of a stack at those directions into a field, rings about `spacing` apart */
mus_status mus__field_make(mus_context *context, const mus__stack *stack, const mus__part *part, double spacing,
                           mus__field *out);
void mus__field_free(mus_context *context, mus__field *field);

/* depth of p (3) by that query: positive inside, the distance to first order near the surface; normal (3), outward.
 * -1e30 and a zero normal when p is further out than 5 cm */
double mus__field_depth(const mus__field *field, const double *p, double *normal);

#endif
