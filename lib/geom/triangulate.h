/*
 * triangulate.h: constrained Delaunay triangulation of a simple polygon with interior points.
 */
#ifndef MUS_GEOM_TRIANGULATE_H
#define MUS_GEOM_TRIANGULATE_H

#include "base/base_internal.h"

/*
 * Points 0 .. nborder-1 are a simple closed polygon in order (either orientation), the others lie strictly inside it.
 * Every point becomes a vertex; every side of the polygon and each of the segments `sides` becomes an edge; the inside
 * is covered exactly once. Segments must not cross each other or the polygon, or pass through a point.
 *
 * Shapes:  xy (n x 2); sides (nside x 2) pairs of points, NULL when nside is 0; *triangles (*count x 3),
 *          counter-clockwise, from mus__new (the caller frees)
 * Errors:  MUS_ERR_MESH (two equal points, a polygon that crosses itself, a point outside), MUS_ERR_MEMORY
 * Cost:    O(n log n) typical
 */
mus_status mus__triangulate(mus_context *context, int32_t n, const double *xy, int32_t nborder, int32_t nside,
                            const int32_t *sides, int32_t **triangles, int32_t *count);

#endif
