/* spline.h: natural and periodic cubic splines through points. */
#ifndef MUS_GEOM_SPLINE_H
#define MUS_GEOM_SPLINE_H

#include <stdbool.h>
#include <stdint.h>

/* second derivatives m (n) of the natural cubic spline through (x, y), x strictly ascending, n >= 2; work (2n).
 * false when x does not ascend. Two points give the straight line. */
bool mus__spline_natural(int32_t n, const double *x, const double *y, double *m, double *work);
/* the same for a periodic spline: y[0] follows y[n-1] at x[n-1] + last, n >= 3, work (4n) */
bool mus__spline_periodic(int32_t n, const double *x, double last, const double *y, double *m, double *work);
/* value and (derivative may be NULL) at t; outside x[0]..x[n-1] the tangent line at the end */
double mus__spline_at(int32_t n, const double *x, const double *y, const double *m, double t, double *derivative);

#endif
