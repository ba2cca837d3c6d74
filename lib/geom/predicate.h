/* predicate.h: signs that decide a triangulation, exact when the floating-point answer is in doubt. */
#ifndef MUS_GEOM_PREDICATE_H
#define MUS_GEOM_PREDICATE_H

/* > 0 when a, b, c turn left, < 0 right, 0 on a line; the sign is exact */
double mus__orient2d(const double *a, const double *b, const double *c);
/* > 0 when d lies inside the circle through ccw a, b, c; the sign is exact */
double mus__incircle(const double *a, const double *b, const double *c, const double *d);

#endif
