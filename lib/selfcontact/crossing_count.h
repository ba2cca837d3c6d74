/*
 * crossing_count.h: whether cloth goes through cloth: an exact count, as a certificate.
 *
 * Two triangles cross when an edge of one that has no corner in common with the other meets that other. All signs are
 * exact (geom/predicate.h), so the count is that of the places as given, to the last bit; a touch counts. Triangles
 * that share an edge never cross: they may lie flat on each other, but neither goes through the other.
 */
#ifndef MUS_SELFCONTACT_CROSSING_COUNT_H
#define MUS_SELFCONTACT_CROSSING_COUNT_H

#include "selfcontact/box_grid.h"

/* nonzero when the segment p q meets the triangle a b c, its border and the ends of the segment included */
int32_t mus__segment_meets_triangle(const double *p, const double *q, const double *a, const double *b,
                                    const double *c);

/* called for every edge p q (nodes) of triangle `of` that meets triangle `met` */
typedef void (*mus__crossing_fn)(void *user, int32_t p, int32_t q, int32_t of, int32_t met);

/* pairs of the n triangles (n x 3, nodes) that cross at x (nodes x 3); nodes of the same class (NULL: each its own)
 * count as one, and triangles with two corners of one class are left out. fn may be NULL; it is called in a fixed
 * order */
int64_t mus__crossing_count(mus__box_grid *grid, int32_t n, const int32_t *triangle, const int32_t *class_of,
                            const double *x, mus__crossing_fn fn, void *user);

#endif
