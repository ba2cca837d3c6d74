/*
 * board_dart.h: darts: two sides one after the other that are sewn together.
 */
#ifndef MUS_BOARD_DART_H
#define MUS_BOARD_DART_H

#include "board/board_curve.h"

/* [m] two places within this are one: points of two darts, a cut and the end of a side; chosen: above rounding */
#define MUS__DART_SAME 1e-6

/* a dart as it lies on the board */
typedef struct mus__dart {
    int32_t leg, back, panel;    /* back: the leg from the point to the mouth */
    double point[2], a[2], b[2]; /* b: end of the other leg */
    double angle;                /* [rad] from a to b about the point, > 0 when the word runs counter-clockwise */
} mus__dart;

/* In this header `leg` is the side of a dart that runs from its mouth to its point; the other leg is the next side. */

/* angle between the legs of a dart [rad]; 0 when `leg` is not the leg of a dart */
double mus__board_dart_angle(const mus__board *board, int32_t leg);
/* is `leg` sewn to the side that follows it, point to point? */
bool mus__board_dart_is(const mus__board *board, int32_t leg);
/* read a dart from the board. Returns false, and the board fails, when `leg` is not the leg of a dart */
bool mus__board_dart_read(mus__board *board, int32_t leg, mus__dart *dart);

/* ---- board_dart_rotate.c ---- */

/**
 * Rotate a dart about its point to arc length s [m] of side `target`.
 *
 * The panel is cut from the point to the target. The part that does not hold side `keep` is turned so that `fraction`
 * (above 0, at most 1) of the dart's angle closes; the same angle opens at the target as a new dart, whose legs are
 * named after the target with "_d1" and "_d2". When the dart closes whole, its legs are removed, and the sides beside
 * its mouth are merged if they were one side before. Returns the leg of the new dart.
 */
int32_t mus__board_dart_rotate(mus__board *board, int32_t leg, int32_t target, double s, int32_t keep, double fraction);
/* ---- board_dart.c ---- */

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

/* ---- steps that rotating shares ---- */

/* add the two sewn legs of a dart after side `before`, whose end and whose next side's start are its mouth; `allowance`
 * [m] is that of the legs. Returns the leg from the mouth */
int32_t mus__board_dart_legs(mus__board *board, int32_t before, const double *point, const char *name,
                             double allowance);
/* remove both legs and link the sides beside the dart. Returns the side before it */
int32_t mus__board_dart_remove(mus__board *board, const mus__dart *dart);
/* merge `before` with the side that follows it after a dart between them has closed, if they were one side */
void mus__board_dart_close(mus__board *board, int32_t before);

#endif
