/*
 * board_patch_panel.h: a patch laid on a panel and sewn to it.
 */
#ifndef MUS_BOARD_PATCH_PANEL_H
#define MUS_BOARD_PATCH_PANEL_H

#include "board/board_curve.h"

/* add a patch: panel `name`, sewn to the line through n points xy (n x 2) inside a panel and open between the ends of
 * the line. The line is drawn into the panel from the nearest corner that sees it. The patch is placed PATCH_LIFT
 * outside the panel. Returns the patch */
int32_t mus__board_patch(mus__board *board, int32_t panel, int32_t n, const double *xy, const char *name);
/* would mus__board_patch() succeed on this line? The board does not fail */
bool mus__board_patch_fits(mus__board *board, int32_t panel, int32_t n, const double *xy);

#endif
