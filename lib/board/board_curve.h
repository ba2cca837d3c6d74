/*
 * board_curve.h: the line of a side: a chain of lines, arcs and Beziers, measured, moved, divided and joined.
 *
 * Calls that make a chain fail the board without memory, with *out empty.
 */
#ifndef MUS_BOARD_CURVE_H
#define MUS_BOARD_CURVE_H

#include "board/board.h"

/* kinds (npiece), xy (nxy x 2) with both ends. The board fails for a wrong kind, a wrong nxy, or a point beyond
 * MUS__FARTHEST */
void mus__board_chain_make(mus__board *board, int32_t npiece, const int32_t *kinds, int32_t nxy, const double *xy,
                           mus__board_chain *out);
/* arc length [m] */
double mus__board_chain_length(const mus__board_chain *chain);
/* point at arc length s (of `length`), and the unit tangent along the chain; either may be NULL */
void mus__board_chain_at(const mus__board_chain *chain, double length, double s, double *xy, double *tangent);
/* exchange both ends */
void mus__board_chain_reverse(mus__board_chain *chain);
/* map every point: x' = m0 x + m1 y + m2, y' = m3 x + m4 y + m5; map (6) */
void mus__board_chain_move(mus__board_chain *chain, const double *map);
/* the parts before and after arc length s, 0 < s < length; pieces are divided exactly */
void mus__board_chain_split(mus__board *board, const mus__board_chain *chain, double length, double s,
                            mus__board_chain *before, mus__board_chain *after);
/* a, then b, which starts where a ends; two lines that are one straight line become one */
void mus__board_chain_join(mus__board *board, const mus__board_chain *a, const mus__board_chain *b,
                           mus__board_chain *out);
/* are the points of b those of a, read from the other end when `reversed`, bit for bit? */
bool mus__board_chain_same(const mus__board_chain *a, const mus__board_chain *b, bool reversed);

#endif
