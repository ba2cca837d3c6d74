/*
 * polygon_offset.h: a closed polygon moved outwards, each side by its own width.
 */
#ifndef MUS_PATTERN_POLYGON_OFFSET_H
#define MUS_PATTERN_POLYGON_OFFSET_H

#include "base/base_internal.h"

/* closed polygons: the outer one first (counter-clockwise), then holes (clockwise) */
typedef struct mus__cut_loops {
    int32_t nloop, n;
    int32_t *start; /* (nloop + 1) */
    double *xy;     /* (n x 2) [m] */
} mus__cut_loops;

void mus__cut_loops_free(mus_context *context, mus__cut_loops *loops);
/* offset a simple counter-clockwise polygon outwards: side i (from point i to the next) by width[i] >= 0 [m]. given (n)
 * tells the sides that are part of the result as they are, of width 0, or is NULL. With all widths 0 the result is the
 * polygon itself. Errors: MUS_ERR_MEMORY */
mus_status mus__offset(mus_context *context, int32_t n, const double *xy, const double *width,
                       const unsigned char *given, mus__cut_loops *out);

#endif
