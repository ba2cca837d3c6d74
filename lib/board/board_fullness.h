/*
 * board_fullness.h: length and width added to panels, pleats, smooth lines, patches.
 */
#ifndef MUS_BOARD_FULLNESS_H
#define MUS_BOARD_FULLNESS_H

#include "board/board_chain.h"

/* ---- board_spread.c ---- */

/* slash from side `from` at s0 to side `to` at s1 and spread: the part walked from `from` to `to` is moved so that the
 * slash opens by w0 at `from` and w1 at `to` (0: hinged there); the gap is filled, its ends are parts of those sides,
 * whose eases grow */
void mus__board_spread(mus__board *board, int32_t from, double s0, int32_t to, double s1, double w0, double w1);
/* lengthen (or shorten, amount < 0) across the line through `point` along `direction`: what lies to the left of it
 * moves by `amount` square to it; sides that cross are drawn again between their parts */
void mus__board_lengthen(mus__board *board, int32_t panel, const double *point, const double *direction, double amount);
/* a side drawn again: xy as in mus__board_side_add(), between other ends too: neighbours follow (their nearest control
 * point goes along). Notches keep their relative place */
void mus__board_redraw(mus__board *board, int32_t side, int32_t npiece, const int32_t *kinds, int32_t nxy,
                       const double *xy);

/* ---- board_fair.c ---- */

/* a side drawn again as one smooth line: as few cubics as stay `within` [m] of what it is, its ends and its tangents
 * there kept; what a curved ruler makes of a slashed hem or of a neck whose darts were released. A side without corners
 * stays as it is. Its seam's ease follows its length */
void mus__board_fair(mus__board *board, int32_t side, double within);

/* ---- board_pleat.c ---- */

/* lay n pleats on a side: at arc length s[i] an outer fold, the pleat |depth[i]| deep, under what comes before it along
 * the walk (depth > 0) or after it. The side becomes parts; of what it was sewn to the parts that show take the place.
 * Pleats do not overlap: each takes from s - d to s + 2 d, or from s - 2 d to s + d. In order */
void mus__board_lay(mus__board *board, int32_t side, int32_t n, const double *s, const double *depth);

/* ---- board_patch.c ---- */

/* a piece `name` laid on a panel and sewn to the line through n points (n x 2) inside it, which is drawn into the panel
 * from its nearest corner; between its ends the piece is open. It starts a little outside the panel. Returns its panel
 */
int32_t mus__board_patch(mus__board *board, int32_t panel, int32_t n, const double *xy, const char *name);
/* does a line lie so far inside a panel that a patch can be sewn there? Asks only */
bool mus__board_patch_fits(mus__board *board, int32_t panel, int32_t n, const double *xy);

#endif
