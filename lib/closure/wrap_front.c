/*
 * wrap_front.c: fronts that wrap: each goes on beyond the centre to the other side seam and is tied there.
 *
 * Both fronts are the same but for left and right. Beyond the centre a front has no dart: what is there lies on the
 * other front, which has. Its waist is as long as that of the other front with the darts closed, and a little longer,
 * so it ends on the side seam, and there, as high as the tie is wide, it is held. From the side neck to the tie runs
 * one edge, the neckline:
 *
 *         S __
 *        /    \           S  side neck          E  upper end of the tie
 *    .--'      |          O  centre of the waist
 *   E          |
 *   |__ lap __ O __ waist __.   (lap: sewn to the same part of the skirt's front)
 *
 * The left front lies over the right one, as where a front buttons; the tie of the right front passes a slot in the
 * left side seam. A tie is a layer on a sewn seam, as those of pleats: the openings are those of the garment with its
 * fronts untied, and neck, edges and hem are one.
 */
#include <math.h>
#include <string.h>

#include "base/elementary.h"
#include "closure/closure.h"

/* the part beyond the centre is longer than the front below it by this part. Chosen: on cloth that hardly gives the
 * upper front must come to the seam over the lower one; with 1 cm it does not */
#define WRAP_EASE 0.17
#define WRAP_HOLLOW 0.03 /* depth of the neckline below a straight line, as part of it; chosen: it lies closer so */
#define WRAP_HEIGHT 0.5  /* of the side seam up to the bust dart that the tie takes at most; chosen */
#define WRAP_LIFT 0.02   /* [m] the left front starts before the right one by; chosen: ten thicknesses of cloth */


bool mus__wraps(const mus__half *half)
{
    return mus__style_is(half, MUS__AXIS_CLOSURE, MUS__CLOSURE_WRAP);
}


double mus__wrap_lap(double waist)
{
    return (1.0 + WRAP_EASE) * waist;
}


void mus__wrap_outline(const mus__half *half, double waist, const mus__chain *side, mus__chain *neck,
                       mus__outline *outline)
{
    const double width = mus__wrap_lap(waist), *top = side->xy + 2 * (side->nxy - 1);
    const double up[2] = {top[0] - side->xy[0], top[1] - side->xy[1]}, length = mus__hypot(up[0], up[1]);
    const double part = fmin(MUS__TIE * mus__measures_scale(&half->measures) / length, WRAP_HEIGHT);
    const double low[2] = {-width, side->xy[1]}, high[2] = {-width - part * up[0], side->xy[1] + part * up[1]};
    const double centre[2] = {0.0, side->xy[1]};
    const double x = high[0] - neck->xy[0], y = high[1] - neck->xy[1];
    const double start[2] = {neck->xy[0], neck->xy[1]};
    neck->npiece = 0;
    mus__chain_add_cubic(neck, start, start[0] + x / 3.0 - WRAP_HOLLOW * y, start[1] + y / 3.0 + WRAP_HOLLOW * x,
                         start[0] + 2.0 * x / 3.0 - WRAP_HOLLOW * y, start[1] + 2.0 * y / 3.0 + WRAP_HOLLOW * x, high);
    mus__outline_line(outline, "tie", "tie", MUS__SEAM_ALLOWANCE, high, low);
    mus__outline_line(outline, "lap", "lap", MUS__SEAM_ALLOWANCE, low, centre);
}


/* the side seam of a front where the tie of the other one is held: its lowest edge, which begins at the waist */
static int32_t wrap_place(const mus__board *board, int32_t panel)
{
    const int32_t side = mus__board_find(board, panel, "side1");
    return side != MUS_NONE ? side : mus__board_find(board, panel, "side");
}


void mus__wrap_hold(mus__half *half, int32_t panel)
{
    mus__board *board = &half->board;
    if (board->status != MUS_OK) return;
    const int32_t tie = mus__board_find(board, panel, "tie"), side = wrap_place(board, panel);
    if (tie == MUS_NONE || side == MUS_NONE) return;
    mus__board_notch_add(board, mus__board_split(board, side, board->side[tie].length, NULL), 0.0, MUS_NOTCH_TRIPLE);
    mus__board_mark_add(board, panel, "slot", 2,
                        (double[4]){mus__board_start(board, side)[0], mus__board_start(board, side)[1],
                                    mus__board_end(board, side)[0], mus__board_end(board, side)[1]});
}


/* ---- the whole garment ---- */

/* ties the front `of` to the side seam of the front `to` */
static void wrap_tie(mus__board *board, const char *of, const char *to)
{
    const int32_t tie = mus__board_find(board, mus__board_find_panel(board, of), "tie");
    const int32_t side = wrap_place(board, mus__board_find_panel(board, to));
    if (tie == MUS_NONE || side == MUS_NONE) return;
    const int32_t seam = mus__board_seam_add(board, tie, side, MUS_SEAM_DIRECT, 0.0);
    if (seam == MUS_NONE) return;
    board->seam[seam].laid = 1, board->seam[seam].closure = MUS_CLOSURE_TIES;
}


static void wrap_lift(mus__board *board, const char *name)
{
    const int32_t panel = mus__board_find_panel(board, name);
    if (panel == MUS_NONE) return;
    board->panel[panel].attr.placement.origin[2] += WRAP_LIFT;
    board->panel[panel].attr.placement.bend += WRAP_LIFT;
}


void mus__wrap_finish(mus__half *half)
{
    mus__board *board = &half->board;
    if (board->status != MUS_OK || !mus__wraps(half)) return;
    wrap_tie(board, "front_left", "front_right");
    wrap_tie(board, "front_right", "front_left");
    wrap_lift(board, "front_left");
    wrap_lift(board, "skirt_front_left");
}
