/*
 * board_dart.h: darts: two sides one after the other that are sewn together.
 */
#ifndef MUS_BOARD_DART_H
#define MUS_BOARD_DART_H

#include "board/board_chain.h"

/* `leg` of a dart is the side that runs from the mouth to the point; its partner is next. Fails when it is none */
double mus__board_dart_angle(const mus__board *board, int32_t leg);
/**
 * Move a dart: pivot about its point. The panel is cut from the point to `target` at arc length s, and the part that
 * does not hold the side `keep` is turned so that `fraction` (0..1] of the dart's angle is taken up; the same angle
 * opens at the target as a new dart, whose legs are named target name + "_d1", "_d2". A dart taken up whole is gone:
 * its mouth sides are one again when they were one. Returns the leg of the new dart that runs from mouth to point.
 */
int32_t mus__board_dart_rotate(mus__board *board, int32_t leg, int32_t target, double s, int32_t keep, double fraction);
/* a dart on `side` about arc length s: mouth of `width`, point at `point`; returns the leg from the mouth */
int32_t mus__board_dart_add(mus__board *board, int32_t side, double s, double width, const double *point);
/* sewn point `back` nearer to the mouth, along the bisector */
void mus__board_dart_shorten(mus__board *board, int32_t leg, double back);
/* forget the dart: its mouth becomes one side with its neighbours (straight across); the cloth of it is gathered or
 * eased. Returns that side; the seam's ease grows by the width of the mouth */
int32_t mus__board_dart_release(mus__board *board, int32_t leg);
/* go on from the point of a dart to the start of side `to` along a path: two panels, the dart part of their seam. path
 * NULL: `to` starts at the point of the dart already. Returns the new panel (walked from the mouth's outer end to `to`) */
int32_t mus__board_dart_to_seam(mus__board *board, int32_t leg, int32_t to, const mus__board_path *path,
                                const char *name, const char *seam_name);

#endif
