/*
 * radius_field.h: a part of a limb as a radius field: a table of radii by height and direction, which contact queries.
 *
 * A limb has a straight axis: point = origin + s*axis + a*side + b*front, with s along the axis and (a, b) in the plane
 * of the contour. Rings have the distance `ds` in s; each holds the centre (ca, cb) of the in-between contour and its
 * radius at `nangle` equal steps of the diamond angle. The diamond angle q of (a, b), 0..4, takes one division and no
 * atan2: q = b/(|a|+|b|) in the first quadrant, and so on round.
 *
 * Query at a point: with k = floor((s-s0)/ds) the rings k and k+1 are blended, and the radius R is interpolated over
 * the angle. With F = rho - R(s, q), the signed distance is F/|grad F| to first order and the outward normal is grad
 * F/|grad F|. The first and the last ring are the limb's first and last contour, or lie in the round cap that closes a
 * part beyond a joint, or in the cap under the torso. Beyond them the query uses a form that is smooth through the pole
 * (radius_field_kernel.h).
 *
 * The table is the body: the published skin is drawn from it, and contact touches it. lib/body changes entries where
 * two limbs meet (fillets) and where a detail is cut (face, seat), and then calls mus__field_bounds().
 */
#ifndef MUS_LIMB_RADIUS_FIELD_H
#define MUS_LIMB_RADIUS_FIELD_H

#include "limb/contour_stack.h"

#define MUS__FIELD_ANGLES 128 /* least steps of the diamond angle: the table then follows a contour to 0.1 mm. Thin
                               * limbs (arms, legs, feet) have fewer */
#define MUS__FIELD_MOST 512   /* most steps: samples of a finer surface */
#define MUS__FIELD_MARGIN 0.05 /* [m] points farther outside are out of reach; chosen: the first-order distance has no
                                  meaning there */

/* a range of a limb's stack that moves rigidly with one joint */
typedef struct mus__part {
    int32_t limb, joint;
    double end[2];   /* s of its ends [m]: a joint, or the contour that ends the limb */
    double round[2]; /* length of the round cap beyond a joint [m], 0: the limb ends here with its own cap */
    bool deep;       /* its first end is that of the limb, and rings reach into the cap there, which a fillet changes */
} mus__part;

typedef struct mus__field {
    double origin[3];
    double axis[3];   /* unit, direction of s */
    double side[3];   /* unit, direction of a */
    double front[3];  /* unit, direction of b; (side, front, axis) is right-handed */
    double s0, ds;    /* s of the first ring, distance of rings [m] */
    int32_t nring;    /* at least 2 */
    int32_t nangle;   /* multiple of 4; a step of the diamond angle is 4/nangle */
    double *centre;   /* (nring x 2) ca, cb [m] */
    double *radius;   /* (nring x nangle) [m] */
    double reach;     /* largest radius + distance of the centre from the axis [m]: bound for a quick rejection */
    double *largest;  /* (nring) largest radius of rings k and k + 1 [m] */
    double pole[2];   /* s of the poles that close it [m] */
    double middle[2]; /* s of the middle of the ellipse of each cap [m] */
    double half[2];   /* half axis of that ellipse [m] */
    int32_t fine[2];  /* first and last ring that a fillet or a detail changed; first above last: none */
} mus__field;

/* directions (n x 2) of n equal steps of the diamond angle */
void mus__field_turns(int32_t n, double *turn);
/* sample a part of a stack, whose directions are those of mus__field_turns(), into a field with rings about `spacing`
 * [m] apart. Errors: MUS_ERR_MEMORY */
mus_status mus__field_make(mus_context *context, const mus__stack *stack, const mus__part *part, double spacing,
                           mus__field *out);
/* a field of the size of another one, on a limb that mirrors it; its radii are not set. Errors: MUS_ERR_MEMORY */
mus_status mus__field_like(mus_context *context, const mus__limb *limb, const mus__field *from, mus__field *out);
void mus__field_free(mus_context *context, mus__field *field);
/* `largest` and `reach` of a field whose radii were changed */
void mus__field_bounds(mus__field *field);

/* where n directions (n x 2) lie in a table of nangle steps: entry (n) before each, and the share (n) of the next one
 */
void mus__field_steps(int32_t nangle, int32_t n, const double *turn, int32_t *entry, double *share);
/* the surface of a field at s [m], beyond the rings that of its caps: centre (2), and radius (n) in the directions that
 * mus__field_steps() placed */
void mus__field_ring(const mus__field *field, double s, int32_t n, const int32_t *entry, const double *share,
                     double *centre, double *radius);

/* depth [m] of point p (3), positive inside, the distance to first order near the surface; normal (3) outward. -1e30
 * and a zero normal where p is more than 5 cm outside */
double mus__field_depth(const mus__field *field, const double *p, double *normal);

#endif
