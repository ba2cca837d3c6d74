/*
 * board_cut.h: panels cut apart, joined, moved, mirrored; a half garment doubled.
 */
#ifndef MUS_BOARD_CUT_H
#define MUS_BOARD_CUT_H

#include "board/board_chain.h"

/* ---- board_cut.c ---- */

/**
 * Cut a panel in two along a path from the start of side `from` to the start of side `to`; the ends of the path are
 * taken from the board. What is walked from `from` to just before `to` goes to a new
 * panel `name`; the rest stays. The two new sides are called `seam_name` in both panels and are sewn together. Marks go
 * to the panel that they lie in. Returns the new panel.
 */
int32_t mus__board_cut(mus__board *board, int32_t from, int32_t to, const mus__board_path *path, const char *name,
                       const char *seam_name);
/* undo of a cut: the panels of a seam between two panels become one: the other is moved so that its side lies on this
 * one (they must be congruent within 1e-6 m), its sides taken in, the seam gone. Where sides next to it are sewn to one
 * another and lie on each other too, their seams go as well */
void mus__board_join(mus__board *board, int32_t side);
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
