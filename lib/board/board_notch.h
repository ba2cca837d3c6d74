/*
 * board_notch.h: notches on the cutting table.
 */
#ifndef MUS_BOARD_NOTCH_H
#define MUS_BOARD_NOTCH_H

#include "board/board.h"

/* put a notch on a side and on every side that is sewn to it there, at the same relative arc length. apart [m]: nothing
 * is put where another notch lies nearer along one of the outlines; 0: put in any case */
void mus__board_notch_seam(mus__board *board, int32_t side, double s, int32_t kind, double apart);
/* give each notch of the board to every side that is sewn to its place. Of two notches within 12 mm on one outline the
 * one of the higher kind stays, of one kind the one that was put first; the other goes from all its sides */
void mus__board_match_notches(mus__board *board);
/* put a single notch on each long edge, of several sides without a corner between them, where two edges meet that it is
 * sewn to: at the end of one of its sides, and on nothing else. None within 12 mm of another notch */
void mus__board_notch_joints(mus__board *board);

#endif
