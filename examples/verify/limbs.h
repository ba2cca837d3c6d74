/*
 * limbs.h: limbs and drapes for the cases of contact (contact.c, collide.c).
 *
 * Limbs are made by mus_body_create_limbs(); cloth is of bare nodes or a grid, and all is in double without drag. What
 * is made belongs to the caller, also after a failure.
 */
#ifndef VERIFY_LIMBS_H
#define VERIFY_LIMBS_H

#include "verify.h"

#define PI 3.14159265358979323846
#define GRAVITY 9.81
#define MU 0.3
#define MOST_CONTOURS 64

/* an elliptic (superelliptic: n) cylinder of half breadth a and half depth b about a line through (x, y) along z */
mus_limb limb_roller(double x, double y, double a, double b, double n, double *rows);

mus_status limb_make_roller(verify *v, double a, double b, double n, mus_body **out);

/* a sphere about the origin with poles on the y axis, of n contours at equal angles */
mus_status limb_make_sphere(verify *v, double r, int32_t n, mus_body **out);

/* a drape of `cloth`, which is freed: double, no drag */
mus_status limb_meet(verify *v, mus_cloth *cloth, const mus_body *body, double friction, double clearance,
                     double gravity, mus_drape **out);

/* one node of mass 1 at `place`, moving */
mus_status limb_meet_point(verify *v, const mus_body *body, double friction, double gravity, const double *place,
                           const double *velocity, mus_drape **out);

/* a level grid of n x n nodes, its middle at (0, height, 0), moving up at `speed` */
mus_status limb_meet_sheet(verify *v, const mus_body *body, int32_t n, double cell, double height, double speed,
                           mus_drape **out);

/* contours side by side (C4, contour.c) */
void verify_contours(verify *v);

/* next of a row of numbers in 0 .. 1 */
double limb_random(uint64_t *state);

/* a row, or the sentence of what went wrong */
void limb_row(verify *v, mus_status status, const char *id, const char *text, double exact, double got,
              double tolerance);

#endif
