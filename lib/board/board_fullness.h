/*
 * board_fullness.h: length and width added to panels, pleats, smooth lines, patches.
 */
#ifndef MUS_BOARD_FULLNESS_H
#define MUS_BOARD_FULLNESS_H

#include "board/board_chain.h"

/* ---- board_spread.c ---- */

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

/* ---- board_smooth.c ---- */

/* draw a side with corners again as one smooth line: the fewest cubics that stay `within` [m] of it and keep its ends
 * and the tangents there. A cutter does so with a curved ruler, for a slashed hem or a neck whose darts were released.
 * A side without corners stays as it is. The ease of its seam changes with its length */
void mus__board_fair(mus__board *board, int32_t side, double within);

/* ---- board_pleat.c ---- */

/* lay n pleats on a side: pleat i has its outer fold at arc length s[i] and is |depth[i]| [m] deep; it lies under the
 * part before the fold along the walk (depth > 0) or under the part after it. The side is split at the folds; the parts
 * that show take its place in its seam. Pleats are in order and do not overlap: each takes from s - d to s + 2 d, or
 * from s - 2 d to s + d */
void mus__board_lay(mus__board *board, int32_t side, int32_t n, const double *s, const double *depth);

/* ---- board_patch.c ---- */

/* add a patch: panel `name`, sewn to the line through n points xy (n x 2) inside a panel and open between the ends of
 * the line. The line is drawn into the panel from the nearest corner that sees it. The patch is placed PATCH_LIFT
 * outside the panel. Returns the patch */
int32_t mus__board_patch(mus__board *board, int32_t panel, int32_t n, const double *xy, const char *name);
/* would mus__board_patch() succeed on this line? The board does not fail */
bool mus__board_patch_fits(mus__board *board, int32_t panel, int32_t n, const double *xy);

#endif
