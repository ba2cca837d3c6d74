/*
 * curve.h: the closed curve that contact asks at one height of a limb, and winding numbers about it.
 *
 * A contact field knows a contour in CURVE_ARCS directions, at equal steps of the diamond angle: they go to points e_k
 * at equal distances on the square |a| + |b| = 1. Between two of them the square of the radius is linear (mus_body(3)):
 *
 *     K(w) = sqrt((1 - w) r_k^2 + w r_k+1^2) d / |d|,   d = (1 - w) e_k + w e_k+1,   0 <= w <= 1
 *
 * Which side of K a point is on is told here without any radius at the point. The winding number of K is that of each
 * polygon of points of K which no point on the way from an arc to its chord is as near to as its sagitta, since the one
 * can then be drawn into the other without passing the point. An arc is halved until that holds, and where it would
 * have to be halved until the sagitta is below the band, the point lies in the band.
 */
#ifndef VERIFY_CURVE_H
#define VERIFY_CURVE_H

#include <stdbool.h>
#include <stdint.h>

#define CURVE_ARCS 128 /* directions of a contact field, as in mus_body(3) */
#define CURVE_CORNERS 256 /* most corners of an outline */

typedef struct curve {
    double centre[2];
    double square[CURVE_ARCS + 1];    /* r_k^2, the first again at the end */
    double corner[CURVE_ARCS + 1][2]; /* K at w = 0 */
    double bend[CURVE_ARCS];          /* no less than the second derivative of K by w on the arc [m] */
    double box[CURVE_ARCS][4];        /* low a, b, high a, b of the arc */
} curve;

/* the curve of an outline (corners x 2) about `centre` (2) */
void curve_make(int corners, const double *outline, const double *centre, curve *out);

/* a point of arc k, part w of the way, drawn out of the centre by `off` */
void curve_point(const curve *c, int k, double w, double off, double *out);

/* how often the curve goes round p; *in_band set when p is not farther than `band` from it */
int curve_winds(const curve *c, const double *p, double band, bool *in_band);

/* the farthest of the curve from the outline, and of the outline's corners from the curve [m] */
double curve_apart(const curve *c, int corners, const double *outline);

#endif
