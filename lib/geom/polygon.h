/* polygon.h: closed polygons of n points (x, y), last edge implied. */
#ifndef MUS_GEOM_POLYGON_H
#define MUS_GEOM_POLYGON_H

#include <stdbool.h>
#include <stdint.h>

double mus__polygon_area(int32_t n, const double *xy); /* signed, ccw > 0 */
double mus__polygon_perimeter(int32_t n, const double *xy);
/* winding number of point p; 0 outside */
int32_t mus__polygon_winding(int32_t n, const double *xy, const double *p);
/* distance of p to the outline */
double mus__polygon_distance(int32_t n, const double *xy, const double *p);
/* convex hull, ccw: indices into xy, out (n); returns their number. work (n) of int32_t. */
int32_t mus__polygon_hull(int32_t n, const double *xy, int32_t *out, int32_t *work);
/* perimeter of the convex hull, as a tape measure lies; work_a, work_b (n) */
double mus__polygon_tape(int32_t n, const double *xy, int32_t *work_a, int32_t *work_b);
/* true when two non-neighbouring sides cross or touch: *i and *j get the sides. Sweep over x, O(n log n) typical;
 * work (n) */
bool mus__polygon_crosses(int32_t n, const double *xy, int32_t *i, int32_t *j, int32_t *work);

#endif
