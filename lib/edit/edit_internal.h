/*
 * edit_internal.h: shared by the edits of muslin/edit.h: a pattern on the table, places of its outline as sides, new
 * cells as indices of the new pattern, and the history.
 *
 * Every edit reads straight down: begin, look up sides, work on the board, end. Errors stay in the board (board.h), so
 * no status is tested in between; mus__edit_end() returns it, and leaves the pattern as it is after a failure.
 */
#ifndef MUS_EDIT_EDIT_INTERNAL_H
#define MUS_EDIT_EDIT_INTERNAL_H

#include "board/board.h"
#include "muslin/edit.h"

typedef struct mus__editing {
    mus_pattern *pattern;
    mus__board board;
    int32_t *side; /* (nedge) the first side of each edge */
    bool crossed;  /* does the outline of the panel that is cut cross itself? */
    double area;   /* [m2] of that panel before the cut, with its sign */
    int32_t nwatch;
    int32_t watch[2]; /* (nwatch) panels of the board whose outlines must not cross themselves in the end */
} mus__editing;

/* ---- undo_history.c ---- */

/* exchange the contents of two patterns of one context; histories stay */
void mus__pattern_swap(mus_pattern *a, mus_pattern *b);
/* take over `before`, the state of the pattern before an edit: it is kept in the history or destroyed */
void mus__history_done(mus_pattern *pattern, mus_pattern *before);

/* ---- edit.c ---- */

/* read a pattern onto the table. Errors: MUS_ERR_ARG (pattern NULL) and those of mus__board_read(); mus__edit_end() is
 * not called then */
mus_status mus__edit_begin(mus__editing *e, mus_pattern *pattern);
/* write the board as the new contents of the pattern; edges[i] (may be NULL) gets the edge of sides[i] */
mus_status mus__edit_end(mus__editing *e, int32_t n, const int32_t *sides, int32_t *const *edges);
/* the same; *panel gets the index of panel `made` of the board in the new pattern, *seam that of the seam of `side`;
 * either may be NULL */
mus_status mus__edit_end_panel(mus__editing *e, int32_t made, int32_t *panel, int32_t side, int32_t *seam);

/* the side of an edge; MUS_NONE, and the board fails, when there is none */
int32_t mus__edit_side(mus__editing *e, int32_t edge);
/* the same; *at gets arc length s of the edge as an arc length of the side. s within EDIT_END beyond an end is the
 * end */
int32_t mus__edit_place(mus__editing *e, int32_t edge, double s, double *at);
/* the leg, from mouth to point, of the dart that an edge is a leg of */
int32_t mus__edit_leg(mus__editing *e, int32_t edge);
/* two places of one panel as corners: the sides that start there, after a split where a place is within a side */
void mus__edit_corners(mus__editing *e, int32_t edge_a, double s_a, int32_t edge_b, double s_b, int32_t *a,
                       int32_t *b);
/* is `panel` a panel of the pattern? the board fails otherwise */
bool mus__edit_panel(mus__editing *e, int32_t panel);
/* called before and after a panel is cut in two; `made` is the new panel. A line outside the panel fails at once, a
 * line across its outline fails in mus__edit_end() */
void mus__edit_cut_begin(mus__editing *e, int32_t panel);
void mus__edit_cut_check(mus__editing *e, int32_t panel, int32_t made);
/* the points of a chain from `start` to `end` with nxy inner points xy between them: a block to free, NULL when the
 * board fails. npiece 0 is a straight line */
double *mus__edit_chain(mus__editing *e, const double *start, const double *end, int32_t npiece, const int32_t *kinds,
                        int32_t nxy, const double *xy);
/* begin the edit of a cut: set *panel and *seam (may be NULL) to MUS_NONE, read the caller's def to `own`, and
 * mus__edit_begin(). Errors: MUS_ERR_ARG (pattern or def NULL), MUS_ERR_VERSION */
mus_status mus__edit_begin_cut(mus__editing *e, mus_pattern *pattern, const mus_cut_def *def, mus_cut_def *own,
                               int32_t *panel, int32_t *seam);
/* the path of a cut from `start` to `end`: the block that it points into, to be freed; NULL when the board fails */
double *mus__edit_path(mus__editing *e, const double *start, const double *end, const mus_cut_def *cut,
                       mus__board_path *path);

#endif
