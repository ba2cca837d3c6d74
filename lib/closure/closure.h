/*
 * closure.h: where a garment opens: fronts that button, zips, bands and cuffs whose ends lap. A closure is drawn done
 * up, a seam that a cloth can leave open (half/half_garment.h).
 *
 * closure.c has the centre lines of a top and what all that lap share; waist_opening.c has skirts and trousers;
 * wrap_front.c has fronts that go round and are tied.
 */
#ifndef MUS_CLOSURE_H
#define MUS_CLOSURE_H

#include "half/panel_outline.h"

#define MUS__ZIP_SEAM (1.5 * MUS__CM) /* [m] allowance of a bodice's seam that a zip is set in; dressmaking practice   \
                                       */

/* ---- closure.c, on the half ---- */

/* Sets the centre lines of a top and marks the buttons. */
void mus__closure_set(mus__half *half);
/* Puts notches where a fold meets a seam or an edge that is faced, double behind, single in front. */
void mus__closure_folds(mus__half *half);
/* Lets a side go on by `lap` beyond its seam line [m]: it is added to the allowance, and a line `mark` shows where the
 * end is sewn. */
void mus__closure_lap(mus__board *board, int32_t side, double lap, const char *mark);
/* Marks the line `out` beyond a side [m], at which what lies beyond is folded. */
void mus__closure_fold(mus__board *board, int32_t side, double out);
/* Marks a button and its buttonhole on the middle of a side whose two ends are alike: one laps over the other. */
void mus__closure_fasten(mus__board *board, int32_t side);
/* Marks a button, or what `mark` names, `out` beyond the middle of a side, within the panel when negative [m]. */
void mus__closure_button(mus__board *board, int32_t side, double out, const char *mark);

/* ---- waist_opening.c, on the half: the waist from centre back to centre front, half-edges waist (n) ---- */

/* Where skirt or trousers open: MUS__CLOSURE_FRONT, BACK or SIDE, or NONE. A centre line that is a fold does not open:
 * SIDE instead. */
int32_t mus__waist_opens(const mus__half *half, int32_t n, const int32_t *waist);
/* Splits the seam that opens at the end of its zip; the part at the waist is called "zip". */
void mus__waist_zip(mus__half *half, int32_t n, const int32_t *waist);
/* Lets the zip of a bodice that opens behind go on below its waist; a centre back that is a fold becomes a seam. */
void mus__waist_zip_below(mus__half *half, int32_t n, const int32_t *waist);

/* ---- wrap_front.c, on the half ---- */

#define MUS__TIE (3.0 * MUS__CM) /* [m] width of a tie and of what it holds; chosen: the trade has 2.5 to 4 cm */

/* Whether the fronts wrap. */
bool mus__wraps(const mus__half *half);
/* Length of the waist beyond the centre, of a front whose own is `waist` long with its darts closed [m]. */
double mus__wrap_lap(double waist);
/* Begins the outline of a front that wraps with "tie" and "lap", in place of its centre; draws the neck from the side
 * neck to the tie. waist: its length to the side with the darts closed [m]; `side`: the side seam from the waist up. */
void mus__wrap_outline(const mus__half *half, double waist, const mus__chain *side, mus__chain *neck,
                       mus__outline *outline);
/* Splits the sewn side seam of the front where the other front is tied to it, and marks the slot. */
void mus__wrap_hold(mus__half *half, int32_t panel);

/* ---- after mus__board_double() ---- */

/* Ties both fronts; the left one lies over the right one. */
void mus__wrap_finish(mus__half *half);

/* Sets the closures of the centre seams of a top, and marks the ends of a zip in the left side seam. */
void mus__closure_finish(mus__half *half);
/* Sets the zip of skirts and trousers, sides "zip", and the ends of the band above it, sides "open", of which one gets
 * its underlap. */
void mus__waist_close(mus__half *half);

#endif
