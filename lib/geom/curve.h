/*
 * curve.h: one planar piece: line, quadratic, cubic or arc, as 2, 3, 4 or 3 points (x, y). An arc is start, the point
 * half way along it, end. Kinds are MUS_PIECE_* of muslin/pattern.h, repeated here so that geom stands alone.
 */
#ifndef MUS_GEOM_CURVE_H
#define MUS_GEOM_CURVE_H

#include <stdint.h>

enum { MUS__LINE = 0, MUS__QUADRATIC = 1, MUS__CUBIC = 2, MUS__ARC = 3 };

/* number of points that define a piece of this kind (2, 3, 4, 3), 0 for an unknown kind */
int32_t mus__curve_points(int32_t kind);
/* point at parameter t in 0..1 (arc: equal angle) */
void mus__curve_at(int32_t kind, const double *p, double t, double *out);
/* derivative by t */
void mus__curve_tangent(int32_t kind, const double *p, double t, double *out);
/* length of the whole piece; relative error below 1e-12 for anything a pattern holds */
double mus__curve_length(int32_t kind, const double *p);
/* length from parameter 0 to t */
double mus__curve_length_to(int32_t kind, const double *p, double t);
/* parameter at arc length s (Newton with bisection guard, to 1e-13 of the length) */
double mus__curve_param(int32_t kind, const double *p, double s);
/* signed area between the piece and the origin, 1/2 integral of x dy - y dx; closed form */
double mus__curve_area(int32_t kind, const double *p);
/* split at t: both parts of the same kind, `left` and `right` may not alias p */
void mus__curve_split(int32_t kind, const double *p, double t, double *left, double *right);

#endif
