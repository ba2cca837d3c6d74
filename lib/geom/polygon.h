/* polygon.h: closed polygons of n points (x, y), last edge implied. */
#ifndef MUS_GEOM_POLYGON_H
#define MUS_GEOM_POLYGON_H

#include <stdbool.h>
#include <stdint.h>

double mus__polygon_area(int32_t n, const double *xy); /* signed: > 0 when counter-clockwise */
double mus__polygon_perimeter(int32_t n, const double *xy);
/* winding number of point p; 0 outside */
int32_t mus__polygon_winding(int32_t n, const double *xy, const double *p);
/* distance of p to the outline */
double mus__polygon_distance(int32_t n, const double *xy, const double *p);
/* convex hull, counter-clockwise: writes indices of xy to out (n) and returns their number; work (n) */
int32_t mus__polygon_hull(int32_t n, const double *xy, int32_t *out, int32_t *work);
/* perimeter of the convex hull: the length of a tape round the polygon; work_a, work_b (n) */
double mus__polygon_tape(int32_t n, const double *xy, int32_t *work_a, int32_t *work_b);
/* whether two sides that are not neighbours cross or touch; *i and *j get these sides. Sweep over x, typically
 * O(n log n); work (n) */
bool mus__polygon_crosses(int32_t n, const double *xy, int32_t *i, int32_t *j, int32_t *work);

#endif
