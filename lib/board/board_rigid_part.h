/*
 * board_rigid_part.h: parts of a panel that move as rigid pieces, and lines inside a panel that stop a cut.
 */
#ifndef MUS_BOARD_RIGID_PART_H
#define MUS_BOARD_RIGID_PART_H

#include "board/board_curve.h"

/* ---- board_rigid_part.c ---- */

/* a motion of the plane: a turn about `centre`, then a shift [m] */
typedef struct mus__board_motion {
    double centre[2], cosine, sine, shift[2];
} mus__board_motion;

/* the outline of a part of a panel as chords; begin with {0}, end with mus__board_part_end() */
typedef struct mus__board_part {
    int32_t n, room;
    double *xy; /* (n x 2) */
} mus__board_part;

/* area [m2] within the outline of a panel, > 0 when it runs counter-clockwise */
double mus__board_area(const mus__board *board, int32_t panel);
/* move the sides first..last, as walked; their lengths stay to the bit */
void mus__board_part_turn(mus__board *board, int32_t first, int32_t last, const mus__board_motion *motion);
void mus__board_part_run(mus__board *board, mus__board_part *part, int32_t first, int32_t last);
void mus__board_part_end(mus__board *board, mus__board_part *part);
/* move the points of marks that lie in `moving` rather than in `still`; and give the marks of which most points do to
 * panel `to` */
void mus__board_part_marks(mus__board *board, int32_t panel, const mus__board_part *moving,
                           const mus__board_part *still, const mus__board_motion *motion);
void mus__board_part_marks_to(mus__board *board, int32_t panel, const mus__board_part *moving,
                              const mus__board_part *still, int32_t to);
/* the line from a to b, two points on the outline or inside it, must lie in the panel and cross no side. Otherwise the
 * board fails with a sentence that begins with `what` */
void mus__board_part_clear(mus__board *board, int32_t panel, const char *what, const double *a, const double *b);
/* move the end (or the start) of a side to `to`, and the control point beside it by the same vector; an arc keeps its
 * angle. The caller moves the neighbour */
void mus__board_part_move_end(mus__board *board, int32_t side, bool end, const double *to);
/* scale and turn `from`, the vector from the start of an arc to its middle point, as its chord becomes `next`: the arc
 * keeps its angle */
void mus__board_arc_follow(const double *chord, double *from, const double *next);
/* a side became longer by `more` [m]: add it to the ease of its seam */
void mus__board_part_ease(mus__board *board, int32_t side, double more);
/* after a change of the chain of a side: measure its length again, and keep notches at their relative arc length */
void mus__board_part_changed(mus__board *board, int32_t side);

/* ---- board_inner_line.c ---- */

/* fail the board when a side is part of a line inside its panel, which the word passes both ways: no cut starts there.
 * The sentence begins with `what` */
void mus__board_rim_side(mus__board *board, int32_t side, const char *what);
/* a word may pass one point several times, with a corner each time. Of the corners at the start of `side`, the one
 * between whose sides the way to the point `towards` (2) leaves: the side that starts there */
int32_t mus__board_corner(const mus__board *board, int32_t side, const double *towards);
/* the same for a cut: MUS_NONE, and the board fails as above, when that corner belongs to a line inside the panel */
int32_t mus__board_rim_corner(mus__board *board, int32_t side, const double *towards, const char *what);

#endif
