/* predicate.h: orientation and in-circle tests with exact signs, for triangulations and crossings. */
#ifndef MUS_GEOM_PREDICATE_H
#define MUS_GEOM_PREDICATE_H

/* > 0 when a, b, c turn left, < 0 when they turn right, 0 when they lie on a line */
double mus__orient2d(const double *a, const double *b, const double *c);
/* > 0 when d lies inside the circle through a, b, c, which are counter-clockwise */
double mus__incircle(const double *a, const double *b, const double *c, const double *d);
/* > 0 when d lies below the plane of a, b, c, which are counter-clockwise seen from above; 0 when it lies on it */
double mus__orient3d(const double *a, const double *b, const double *c, const double *d);

#endif
