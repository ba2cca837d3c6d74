/*
 * board_spread.h: a panel slashed and spread, lengthened; a half-edge drawn again.
 */
#ifndef MUS_BOARD_SPREAD_H
#define MUS_BOARD_SPREAD_H

#include "board/board_curve.h"

/* slash from arc length s0 of side `from` to arc length s1 of side `to`, and spread: the part walked from `from` to
 * `to` moves as a rigid piece, so that the slash opens by w0 at `from` and by w1 at `to` [m] (0: hinged there). Lines
 * across the gap become parts of both sides; the ease of their seams grows by w0 and w1 */
void mus__board_spread(mus__board *board, int32_t from, double s0, int32_t to, double s1, double w0, double w1);
/* lengthen a panel (shorten it when amount < 0) across the line through point (2) along direction (2): the part to the
 * left of the line moves by `amount` [m] square to it. Sides that cross the line are drawn again between their ends */
void mus__board_lengthen(mus__board *board, int32_t panel, const double *point, const double *direction, double amount);
/* draw a side again: kinds (npiece), xy (nxy x 2) with both ends, which may be other ends than before. The neighbours'
 * ends move along with their nearest control point. Notches keep their relative arc length */
void mus__board_redraw(mus__board *board, int32_t side, int32_t npiece, const int32_t *kinds, int32_t nxy,
                       const double *xy);

#endif
