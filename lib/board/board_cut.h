/*
 * board_cut.h: panels cut apart, joined, moved, mirrored; a half garment doubled.
 */
#ifndef MUS_BOARD_CUT_H
#define MUS_BOARD_CUT_H

#include "board/board_curve.h"

/* ---- board_cut.c ---- */

/**
 * Cut a panel in two along a path from the start of side `from` to the start of side `to`; the ends of the path are
 * taken from the board. The sides walked from `from` to just before `to` go to a new panel `name`; the others stay.
 * Both new sides are called `seam_name` and are sewn together. Marks go to the panel that they lie in. Returns the new
 * panel.
 */
int32_t mus__board_cut(mus__board *board, int32_t from, int32_t to, const mus__board_path *path, const char *name,
                       const char *seam_name);
/* undo a cut: join the two panels of a seam. The other panel is moved so that its side lies on `side`; both must be
 * congruent within 1e-6 m. Its sides become sides of the panel of `side`, and the seam is removed. Seams of
 * neighbouring sides that then lie on each other are removed too */
void mus__board_join(mus__board *board, int32_t side);
/* add the mirror image (x to -x) of a panel; its word runs counter-clockwise again, its placement is mirrored in X.
 * Returns the new panel */
int32_t mus__board_mirror(mus__board *board, int32_t panel, const char *name);
/* unfold a panel: it and its mirror image in the straight side `side` become one panel, and the side is removed. Sides
 * of the image are named as the originals with a last "L" and "R" exchanged, or with "_r" added. Darts are mirrored
 * with their seams */
void mus__board_unfold(mus__board *board, int32_t side);
/* remove a panel with its sides, seams, notches and marks */
void mus__board_remove_panel(mus__board *board, int32_t panel);

/* ---- board_mirror.c ---- */

/**
 * Make a whole garment of a half garment (the wearer's left half).
 *
 * A panel with a side CENTRE_FOLD is unfolded in it. Every other panel is mirrored: "front" becomes "front_left" and
 * "front_right", and mirror_of of the image is set. Seams within the half are repeated on the other half. Sides of
 * CENTRE_SEAM are sewn to their image, sides of CENTRE_OPEN are not. A seam between an unfolded panel and a mirrored
 * one holds on both sides of the body. Openings stay as declared.
 */
void mus__board_double(mus__board *board);

#endif
