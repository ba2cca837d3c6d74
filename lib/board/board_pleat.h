/*
 * board_pleat.h: pleats laid on a half-edge.
 */
#ifndef MUS_BOARD_PLEAT_H
#define MUS_BOARD_PLEAT_H

#include "board/board_curve.h"

/* lay n pleats on a side: pleat i has its outer fold at arc length s[i] and is |depth[i]| [m] deep; it lies under the
 * part before the fold along the walk (depth > 0) or under the part after it. The side is split at the folds; the parts
 * that show take its place in its seam. Pleats are in order and do not overlap: each takes from s - d to s + 2 d, or
 * from s - 2 d to s + d */
void mus__board_lay(mus__board *board, int32_t side, int32_t n, const double *s, const double *depth);

#endif
