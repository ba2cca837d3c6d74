/*
 * limb.h: a limb: a stack of closed contours on a straight axis.
 *
 * The room's way, from the tape to the table that contact queries:
 *
 *     skeleton.[ch]          heights and joints of a person, from a completed tape alone
 *     limb.h                 contour and limb (this file)
 *     contour.c              radius of a contour by direction, its girth, and scaling it to the tape
 *     torso.c                the contours of torso, neck and head
 *     arms_legs.c            the contours of arms, legs and feet
 *     contour_stack.[ch]     the limb sampled in fixed directions, with splines between the contours
 *     radius_field.[ch]      a part of a limb as a table of radii: depth and normal at a point
 *     across.[ch]            bumps of the torso beside the arms: the tape's breadth of back and chest
 *     radius_field_kernel.h  the query of that table, one text for float and double
 *
 * Callers: lib/body puts limbs together into a body; lib/contact copies the fields; the drafting blocks read the
 * skeleton.
 *
 * A limb has a right-handed frame (side, front, axis): point = origin + a*side + b*front + s*axis. The torso's and the
 * legs' is (X, -Z, Y), the frame of Metaaphanon and Kanongchaiyos 2005: angles run from +X. Contours ascend in s; each
 * is a star-shaped closed curve about its centre (ca, cb), given by a radius for every angle.
 */
#ifndef MUS_LIMB_LIMB_H
#define MUS_LIMB_LIMB_H

#include "base/base_internal.h"
#include "limb/skeleton.h"

#define MUS__LIMB_CONTOURS 128    /* most contours of a limb; a torso from a tape has 20 */
#define MUS__LIMB_NAME_BYTES 32   /* of a limb's own name, the closing 0 included */
#define MUS__CONTOUR_SAMPLES 512  /* most samples round a contour; 128 is the default of mus_body_def */

/* half width of a bump of a contour at 1/e of its height [rad]; fitted to the mean body of GarmentCode */
#define MUS__CONTOUR_BUMP 0.35

typedef struct mus__contour {
    const char *name;
    int32_t girth;        /* measure that is its girth, or MUS_NONE */
    int32_t height;       /* measure that sets its place on the axis, or MUS_NONE */
    bool hard;            /* its girth was given: the contour may not be left out */
    bool flat;            /* narrower or wider than both neighbours: the slope d radius / ds is set to 0 here */
    bool fine;            /* the surface has rings at half the distance above it */
    double target;        /* girth that mus__contour_fit() gives it [m], 0: a and b are not changed */
    double s;             /* place on the axis [m] */
    double ca, cb;        /* centre in the contour's plane [m] */
    double a, b, n;       /* half breadth along side, half depth along front [m], superellipse exponent */
    double bump[2];       /* height of the pair of bumps towards the front, and towards the back [m] */
    double bump_angle[2]; /* angle of the bumps off the front (off the back) [rad] */
    double wall;          /* distance from the middle plane that the contour keeps [m] */
    double wall_side;     /* +1: a >= wall, -1: a <= -wall, 0: no wall */
    int32_t corners;      /* corners of an outline that replaces the superellipse, 0: none */
    const double *corner; /* (corners x 3) angle -pi..pi ascending, a and b from the centre [m]; owned by the body */
    double host[7];       /* shape of another contour of this plane that replaces its own: centre a and b, half breadth,
                             half depth, exponent, height and angle of the bumps at the back; host[2] = 0: its own */
    int32_t ring;         /* index of its ring in the surface */
} mus__contour;

typedef struct mus__limb {
    const char *name;
    char own_name[MUS__LIMB_NAME_BYTES]; /* `name` of a given limb */
    double origin[3], side[3], front[3], axis[3];
    int32_t count;
    mus__contour contour[MUS__LIMB_CONTOURS];
    bool limited[MUS__LIMB_CONTOURS]; /* slopes are held monotone here: the natural spline would overshoot */
    double pole[2];                   /* s of the points that close it below and above [m] */
    int32_t end[2];                   /* measures that set the poles, or MUS_NONE */
    double wall, wall_side;           /* as the contours', for all in-between contours */
    bool gone;                        /* the body was made without it: no part and no surface; its contours are kept,
                                         since joints are found from them */
    int32_t cuts;                     /* number of joints that cut it: one less than its parts */
    int32_t joint;                    /* joint (MUS_JOINT_*) that carries a limb added to a body of a tape */
    int32_t samples;                  /* directions of its rings in the surface, those of mus__field_turns() */
    int32_t first_vertex, vertices, first_triangle, triangles, first_ring, rings; /* its ranges in the body's surface */
} mus__limb;

/* ---- contour.c ---- */

/* n directions (n x 2) at equal angles from +side on, mirrored in both axes to the last bit; n a multiple of 4 */
void mus__contour_turns(int32_t n, double *turn);
/* half breadth [m] of a superellipse of a girth [m], a ratio of depth to breadth and an exponent n: Ramanujan's formula
 * for n = 2, to 1 % up to n = 3 */
double mus__contour_half_breadth(double girth, double ratio, double n);
/* ratio of depth to breadth of a thigh of a girth [m], 1.03 to 1.40: its breadth is about 0.51 of the hip's half
 * breadth `hip` [m] on either side of its middle */
double mus__contour_thigh_ratio(double girth, double hip);
/* radius of a contour from its centre in the direction (cosine, sine) [m] */
double mus__contour_radius(const mus__contour *contour, double cosine, double sine);
/* the same in n directions `turn` (n x 2) that mirror each other in both axes: radius (n); n a multiple of 4, at most
 * MUS__CONTOUR_SAMPLES */
void mus__contour_radii(const mus__contour *contour, int32_t n, const double *turn, double *radius);
/* scale a contour until the convex hull of its n samples in the directions `turn` (n x 2) has the perimeter `girth`
 * [m], as a tape lies; n at most MUS__CONTOUR_SAMPLES. Scratch: xy (2n), work (2n) */
void mus__contour_fit(mus__contour *contour, double girth, int32_t n, const double *turn, double *xy, int32_t *work);

/* ---- torso.c, arms_legs.c: the contours of each limb from a completed tape, before their girths are fitted ---- */

/* torso, neck and head */
void mus__limb_torso(const mus_tape *tape, const mus__skeleton *skeleton, mus__limb *limb);
/* left (right 0) or right arm with the hand */
void mus__limb_arm(const mus_tape *tape, const mus__skeleton *skeleton, int32_t right, mus__limb *limb);
/* left or right leg; hip: the fitted hip contour of the torso, from which the root of the leg takes its shape */
void mus__limb_leg(const mus_tape *tape, const mus__skeleton *skeleton, int32_t right, const mus__contour *hip,
                   mus__limb *limb);
/* left or right foot, under its leg */
void mus__limb_foot(const mus_tape *tape, const mus__skeleton *skeleton, int32_t right, const mus__limb *leg,
                    mus__limb *limb);

#endif
