/*
 * lattice.h: the nodes of a panel that stand on a square lattice along warp and weft, and which cells are full.
 */
#ifndef MUS_CLOTH_LATTICE_H
#define MUS_CLOTH_LATTICE_H

#include "base/base_internal.h"

/*
 * Lattice point (i, j), column i along the weft and row j along the warp, lies at origin + spacing (i weft + j warp).
 * Cell (i, j) has the corners (i, j), (i+1, j), (i+1, j+1), (i, j+1). The first and last row and column have no nodes,
 * so reading neighbours needs no bounds check. Index of a point and of a cell: j * columns + i.
 */
typedef struct mus__lattice {
    double spacing, origin[2], warp[2], weft[2];
    int32_t columns, rows, count; /* count: nodes */
    int32_t *node;                /* (rows x columns) number of the node, row by row, or MUS_NONE */
    unsigned char *full;          /* (rows x columns) 1 when all corners are nodes: the border is half a spacing off */
} mus__lattice;

/* Builds the lattice of the polygon of `n` border points (xy) with warp direction `grain`. Its nodes also keep off the
 * `nside` lines inside the panel (side: pairs of indices of xy). Must be freed, after a failure too. */
mus_status mus__lattice_build(mus_context *context, int32_t n, const double *xy, int32_t nside, const int32_t *side,
                              const double *grain, double spacing, mus__lattice *lattice);
void mus__lattice_free(mus_context *context, mus__lattice *lattice);

/* Writes the point of the panel's plane [m] at lattice point (i, j). */
void mus__lattice_point(const mus__lattice *lattice, int32_t i, int32_t j, double *out);
/* Returns the number of full cells round a lattice point, 0 to 4. */
int32_t mus__lattice_around(const mus__lattice *lattice, int64_t place);
/* Returns whether the cell that contains `point` [m] is full. */
bool mus__lattice_covers(const mus__lattice *lattice, const double *point);

#endif
