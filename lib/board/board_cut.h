/*
 * board_cut.h: panels cut apart, joined, moved, mirrored; a half garment doubled.
 */
#ifndef MUS_BOARD_CUT_H
#define MUS_BOARD_CUT_H

#include "board/board_chain.h"

/* ---- board_cut.c ---- */

/**
 * Cut a panel in two along a chain from the start of side `from` to the start of side `to` (xy as in
 * mus__board_side_add(), its ends taken from the board). What is walked from `from` to just before `to` goes to a new
 * panel `name`; the rest stays. The two new sides are called `seam_name` in both panels and are sewn together. Marks go
 * to the panel that they lie in. Returns the new panel.
 */
int32_t mus__board_cut(mus__board *board, int32_t from, int32_t to, int32_t npiece, const int32_t *kinds, int32_t nxy,
                       const double *xy, const char *name, const char *seam_name);
/* undo of a cut: the panels of a seam between two panels become one: the other is moved so that its side lies on this
 * one (they must be congruent within 1e-6 m), its sides taken in, the seam gone. Where sides next to it are sewn to one
 * another and lie on each other too, their seams go as well */
void mus__board_join(mus__board *board, int32_t side);
/* move a whole panel in its plane: turned by `angle` about `centre`, then shifted; grain, marks and notches go along.
 * A flat placement is changed so that the panel stays where it was in space, a bent one so for a shift alone */
void mus__board_turn(mus__board *board, int32_t panel, const double *centre, double angle, const double *shift);
/* the mirror image (x to -x) of a panel as a new one: words run counter-clockwise again; placement mirrored in X */
int32_t mus__board_mirror(mus__board *board, int32_t panel, const char *name);
/* a panel and its mirror image in the straight side `side` become one panel; the side is gone. Sides of the image are
 * named as the originals with "L" and "R" at the end exchanged, or "_r" added; darts are mirrored with their seams */
void mus__board_unfold(mus__board *board, int32_t side);
void mus__board_remove_panel(mus__board *board, int32_t panel);

/* ---- board_double.c ---- */

/**
 * A half garment (the wearer's left) becomes a whole one.
 *
 * Panels with a side CENTRE_FOLD are unfolded in it; every other is mirrored: "front" becomes "front_left" and
 * "front_right" (a panel whose cut is 2 mirrored says so: mirror_of). Seams within the half are repeated on the other;
 * sides of CENTRE_SEAM are sewn to their image, those of CENTRE_OPEN are not. Seams of a whole panel with two halves
 * (a side of the fold panel sewn to a side of a mirrored one) hold on both sides. Openings are as declared.
 */
void mus__board_double(mus__board *board);

#endif
