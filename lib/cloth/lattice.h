/*
 * lattice.h: the nodes of a panel that stand on a square lattice along warp and weft, and which cells are full.
 */
#ifndef MUS_CLOTH_LATTICE_H
#define MUS_CLOTH_LATTICE_H

#include "base/base_internal.h"

/*
 * Place (i, j) is column i along the weft and row j along the warp; it stands at origin + spacing (i weft + j warp).
 * Cell (i, j) has the corners (i, j), (i+1, j), (i+1, j+1), (i, j+1). The first and last row and column are always
 * empty, so neighbours need no bounds check. Index of place and cell: j * columns + i.
 */
typedef struct mus__lattice {
    double spacing, origin[2], warp[2], weft[2];
    int32_t columns, rows, count; /* count: nodes */
    int32_t *node;                /* (rows x columns) number of the node, row by row, or MUS_NONE */
    unsigned char *full;          /* (rows x columns) 1 when all corners are nodes: the border is half a spacing off */
} mus__lattice;

/* lattice of the polygon of `n` border points (xy) with warp direction `grain`, which keeps off `nside` sides inside as
 * well (side: pairs of points of xy); free it even after a failure */
mus_status mus__lattice_build(mus_context *context, int32_t n, const double *xy, int32_t nside, const int32_t *side,
                              const double *grain, double spacing, mus__lattice *lattice);
void mus__lattice_free(mus_context *context, mus__lattice *lattice);

/* where a place stands in the panel's plane */
void mus__lattice_point(const mus__lattice *lattice, int32_t i, int32_t j, double *out);
/* full cells among the four round a place: 0..4 */
int32_t mus__lattice_around(const mus__lattice *lattice, int64_t place);
/* true when the cell that holds a point is full */
bool mus__lattice_covers(const mus__lattice *lattice, const double *point);

#endif
