/*
 * board_smooth.h: a half-edge with corners drawn again as one smooth line.
 */
#ifndef MUS_BOARD_SMOOTH_H
#define MUS_BOARD_SMOOTH_H

#include "board/board_curve.h"

/* draw a side with corners again as one smooth line: the fewest cubics that stay `within` [m] of it and keep its ends
 * and the tangents there. A cutter does so with a curved ruler, for a slashed hem or a neck whose darts were released.
 * A side without corners stays as it is. The ease of its seam changes with its length */
void mus__board_fair(mus__board *board, int32_t side, double within);

#endif
