/*
 * board.h: the cutting table as an object, drawing on it, and its way from and to a pattern.
 *
 * A pattern (mus_pattern) never loses a cell; on a board cells come and go. It is read from a pattern or begun empty,
 * worked on, and written back as a new pattern. All edits of muslin/edit.h and all designs are sequences of the calls
 * of this room.
 *
 * Failing: the first call that fails sets board->status (and the error text in the context); every later call does
 * nothing and returns MUS_NONE, so a recipe reads straight down and asks once at its end. A failed board is thrown
 * away: the pattern that it was read from is as it was.
 */
#ifndef MUS_BOARD_H
#define MUS_BOARD_H

#include "board/board_data.h"

/* ---- board.c ---- */

/* an empty board; end with mus__board_free(), after a failure too. A name that is too long fails the board */
void mus__board_begin(mus__board *board, mus_context *context, const char *name);
void mus__board_free(mus__board *board);
/* set the status and the sentence, unless the board has failed already */
void mus__board_fail(mus__board *board, mus_status status, const char *format, ...) MUS_PRINTF(3, 4);

/* is a side, or a panel, on the board? The board fails when it is not */
bool mus__board_has_side(mus__board *board, int32_t side);
bool mus__board_has_panel(mus__board *board, int32_t panel);

/* find by name: MUS_NONE, without failing the board, when there is none */
int32_t mus__board_find_panel(const mus__board *board, const char *name);
int32_t mus__board_find(const mus__board *board, int32_t panel, const char *name);
/* both ends (2) of a side [m]; (0, 0) for a side that is not there */
const double *mus__board_start(const mus__board *board, int32_t side);
const double *mus__board_end(const mus__board *board, int32_t side);
/* the first seam that a side is in, and the side on the other end of it, or MUS_NONE */
int32_t mus__board_seam_of(const mus__board *board, int32_t side);
int32_t mus__board_partner(const mus__board *board, int32_t side);

/* a free name in a panel: `name` without a number at its end, then "_2" or the next number that is free; out
 * (MUS__NAME_BYTES) */
void mus__board_free_name(const mus__board *board, int32_t panel, const char *name, char *out);
/* remove a side with its seams, notches and chain; the caller mends the ring */
void mus__board_side_remove(mus__board *board, int32_t side);
/* a panel is about to change its shape: it is no longer the mirror image of another panel, nor another of it */
void mus__board_part_twins(mus__board *board, int32_t panel);
/* Adds the pieces of each material, cut (MUS_MATERIAL_COUNT), to those of a panel (sign 1), or takes them off (-1); of
 * a panel without pieces one of the main cloth stays. */
void mus__board_add_cut(mus__board *board, int32_t panel, const int32_t *cut, int32_t sign);

/* ---- board_draw.c ---- */

/* add a panel without sides; returns its index */
int32_t mus__board_panel_add(mus__board *board, const char *name, const char *label);
/* append a side to a panel that is being drawn: its first point must lie where the last side ended. The board fails
 * when the gap is above 1e-6 m. kinds (npiece), xy (nxy x 2) with both ends. Returns the side */
int32_t mus__board_side_add(mus__board *board, int32_t panel, const char *name, const char *label, int32_t npiece,
                            const int32_t *kinds, int32_t nxy, const double *xy);
/* close the ring of a drawn panel: the last side ends where the first starts, set bit for bit */
void mus__board_panel_close(mus__board *board, int32_t panel);
/* append a straight side */
int32_t mus__board_line_add(mus__board *board, int32_t panel, const char *name, const char *label, const double *start,
                            const double *end);
/* set the name and the label of a side; NULL leaves either */
void mus__board_rename(mus__board *board, int32_t side, const char *name, const char *label);

/* find the run of sides of a panel that carry `label`, in walking order from the first whose predecessor does not carry
 * it. Returns their number; at most `room` are written. A closed dart between two of them is skipped */
int32_t mus__board_run(const mus__board *board, int32_t panel, const char *label, int32_t *sides, int32_t room);
/* point and unit tangent at arc length s of a side as walked; either may be NULL */
void mus__board_at(const mus__board *board, int32_t side, double s, double *xy, double *tangent);

int32_t mus__board_mark_add(mus__board *board, int32_t panel, const char *name, int32_t n, const double *xy);
void mus__board_opening_add(mus__board *board, const char *label);

/* add a side of `chain` without name, neighbours, seam and notches. The chain is taken over even when this fails */
int32_t mus__board_side_new(mus__board *board, int32_t panel, mus__board_chain *chain);
/* link `next` after `side` in the ring; its start is set to the end of `side`, bit for bit */
void mus__board_follow(mus__board *board, int32_t side, int32_t next);

/* ---- board_read_write.c ---- */

/* begin the board with the cells of a pattern. A panel without outline or an edge of no outline fails the board */
void mus__board_read(mus__board *board, const mus_pattern *pattern);
/* the board as a new pattern; board->status tells how it went, *out is NULL after a failure */
void mus__board_write(mus__board *board, mus_pattern **out);

/* ---- board_notch.c ---- */

/* put a notch on one side at arc length s; returns its index */
int32_t mus__board_notch_add(mus__board *board, int32_t side, double s, int32_t kind);

#endif
