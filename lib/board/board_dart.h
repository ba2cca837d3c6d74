/*
 * board_dart.h: darts: two sides one after the other that are sewn together.
 */
#ifndef MUS_BOARD_DART_H
#define MUS_BOARD_DART_H

#include "board/board_chain.h"

/* In this header `leg` is the side of a dart that runs from its mouth to its point; the other leg is the next side. */

/* angle between the legs of a dart [rad]; 0 when `leg` is not the leg of a dart */
double mus__board_dart_angle(const mus__board *board, int32_t leg);
/**
 * Rotate a dart about its point to arc length s [m] of side `target`.
 *
 * The panel is cut from the point to the target. The part that does not hold side `keep` is turned so that `fraction`
 * (above 0, at most 1) of the dart's angle closes; the same angle opens at the target as a new dart, whose legs are
 * named after the target with "_d1" and "_d2". When the dart closes whole, its legs are removed, and the sides beside
 * its mouth are merged if they were one side before. Returns the leg of the new dart.
 */
int32_t mus__board_dart_rotate(mus__board *board, int32_t leg, int32_t target, double s, int32_t keep, double fraction);
/* add a dart to `side`: a mouth `width` [m] wide about arc length s, its point at point (2). Returns its leg */
int32_t mus__board_dart_add(mus__board *board, int32_t side, double s, double width, const double *point);
/* move the point of a dart `back` [m] towards the mouth along the bisector */
void mus__board_dart_shorten(mus__board *board, int32_t leg, double back);
/* release a dart: its legs are removed, a straight line across its mouth joins the sides beside it, and the ease of
 * their seam grows by the width of the mouth. Returns the side that has the mouth now */
int32_t mus__board_dart_release(mus__board *board, int32_t leg);
/* make a dart part of a seam: the panel is cut from the point of the dart to the start of side `to` along a path. path
 * NULL: `to` starts at the point of the dart already. Returns the new panel (walked from the mouth's outer end to
 * `to`) */
int32_t mus__board_dart_to_seam(mus__board *board, int32_t leg, int32_t to, const mus__board_path *path,
                                const char *name, const char *seam_name);

#endif
