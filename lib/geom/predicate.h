/* predicate.h: signs that decide a triangulation or a crossing, exact when the floating-point answer is in doubt. */
#ifndef MUS_GEOM_PREDICATE_H
#define MUS_GEOM_PREDICATE_H

/* > 0 when a, b, c turn left, < 0 right, 0 on a line; the sign is exact */
double mus__orient2d(const double *a, const double *b, const double *c);
/* > 0 when d lies inside the circle through ccw a, b, c; the sign is exact */
double mus__incircle(const double *a, const double *b, const double *c, const double *d);
/* > 0 when d lies below the plane of a, b, c, which look counter-clockwise from above, 0 on it; the sign is exact */
double mus__orient3d(const double *a, const double *b, const double *c, const double *d);

#endif
