/*
 * board_part.h: parts of a panel that move as rigid pieces, and lines inside a panel that stop a cut.
 */
#ifndef MUS_BOARD_PART_H
#define MUS_BOARD_PART_H

#include "board/board_chain.h"

/* ---- board_part.c ---- */

/* turned about `centre`, then shifted */
typedef struct mus__board_motion {
    double centre[2], cosine, sine, shift[2];
} mus__board_motion;

/* the outline of a part, as chords; begin with zeros, end with mus__board_part_end() */
typedef struct mus__board_part {
    int32_t n, room;
    double *xy; /* (n x 2) */
} mus__board_part;

/* area within the outline of a panel, > 0 when it runs counter-clockwise */
double mus__board_area(const mus__board *board, int32_t panel);
void mus__board_chain_turn(mus__board_chain *chain, const mus__board_motion *motion);
/* the sides first..last as walked; their lengths stay to the bit */
void mus__board_part_turn(mus__board *board, int32_t first, int32_t last, const mus__board_motion *motion);
void mus__board_part_add(mus__board *board, mus__board_part *part, const mus__board_chain *chain);
void mus__board_part_run(mus__board *board, mus__board_part *part, int32_t first, int32_t last);
void mus__board_part_end(mus__board *board, mus__board_part *part);
/* points of marks that lie in `moving` go along; whole marks that do so (most of their points) go to a panel */
void mus__board_part_marks(mus__board *board, int32_t panel, const mus__board_part *moving,
                           const mus__board_part *still, const mus__board_motion *motion);
void mus__board_part_marks_to(mus__board *board, int32_t panel, const mus__board_part *moving,
                              const mus__board_part *still, int32_t to);
/* the line from a to b, which are on the outline or within, must lie in the panel and cross no side: else the board
 * fails, the sentence beginning with `what` */
void mus__board_part_clear(mus__board *board, int32_t panel, const char *what, const double *a, const double *b);
/* the end (or the start) of a side comes to `to`, with the control point next to it; an arc keeps its angle. The
 * neighbour is the caller's matter */
void mus__board_part_move_end(mus__board *board, int32_t side, bool end, const double *to);
/* an arc whose chord becomes `next` keeps its angle: `from`, start to middle point, follows */
void mus__board_arc_follow(const double *chord, double *from, const double *next);
/* a side became longer by `more`: the ease that its seam means follows */
void mus__board_part_ease(mus__board *board, int32_t side, double more);
/* the chain of a side was changed: its length, and notches at the same part of it */
void mus__board_part_changed(mus__board *board, int32_t side);

/* ---- board_inner.c ---- */

/* fail the board where a side is part of a line inside its panel, which the word passes out and back: nothing is cut
 * from there. The sentence begins with `what` */
void mus__board_rim_side(mus__board *board, int32_t side, const char *what);
/* the corner where `side` starts may be one of several where the word passes that point: the side that starts at the
 * one from which the way goes towards a point */
int32_t mus__board_corner(const mus__board *board, int32_t side, const double *towards);
/* the same for a cut, sentence as above: MUS_NONE where that corner is of a line inside */
int32_t mus__board_rim_corner(mus__board *board, int32_t side, const double *towards, const char *what);

#endif
