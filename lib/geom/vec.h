/* vec.h: 2- and 3-vectors on plain arrays. */
#ifndef MUS_GEOM_VEC_H
#define MUS_GEOM_VEC_H

#include <math.h>

#include "base/elementary.h"

static inline double mus__dot3(const double *a, const double *b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

static inline void mus__cross3(const double *a, const double *b, double *out)
{
    double x = a[1] * b[2] - a[2] * b[1], y = a[2] * b[0] - a[0] * b[2], z = a[0] * b[1] - a[1] * b[0];
    out[0] = x, out[1] = y, out[2] = z;
}

static inline double mus__norm3(const double *a) { return sqrt(mus__dot3(a, a)); }

/* scale to length 1; a zero vector stays zero */
static inline void mus__unit3(double *a)
{
    double n = mus__norm3(a);
    if (n > 0.0) a[0] /= n, a[1] /= n, a[2] /= n;
}

static inline double mus__dist2(const double *a, const double *b)
{
    double x = b[0] - a[0], y = b[1] - a[1];
    return sqrt(x * x + y * y);
}

#endif
