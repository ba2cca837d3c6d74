/*
 * shaping.c: the ten shapes of a bodice, made by rotating darts and cutting panels apart.
 *
 * Every shape begins as the block: a front whose bust dart opens at the side, with its point on the bust point. The
 * dart is rotated about that point (shaping_dart.c) to the waist, shoulder, neck, centre or low side, released as
 * gathers or flare (shaping_gather.c), or continued as a seam that cuts the panel (shaping_cut.c). Waist darts that a
 * shape keeps are drawn with the panel. A dart that the body does not have, such as the bust dart of a flat chest, is
 * left out. Sewn darts end short of the bust point, where the cloth is rounded. Method: pivoting darts, as in Aldrich,
 * Metric Pattern Cutting.
 */
#include <math.h>

#include "base/elementary.h"
#include "geom/curve.h"
#include "geom/vec.h"
#include "style/bodice.h"

#define SHAPING_BACK (2.0 * MUS__CM) /* [m] sewn dart points from the bust point; practice is 2 to 3 cm */


static bool shaping_darted(const mus__half *half)
{
    return half->bodice.front.theta > 0.0;
}


/* is the bust point so far above the lower edge of the bodice that a dart from there, SHAPING_BACK short of the point,
 * keeps half of its length? On a short heavy woman it may not be; the bust dart then stays at the side */
static bool shaping_has_room(const mus__half *half, const mus__top *top)
{
    return half->bodice.front.bust[1] - fmax(top->hem, 0.0) > 2.0 * SHAPING_BACK;
}


void mus__shaping_plan(const mus__half *half, mus__top *top)
{
    /* a waist dart that becomes part of a seam is not drawn, nor a long one from the hem beside a French dart */
    const int32_t shape = half->style.option[MUS__AXIS_SHAPE];
    const bool princess = shape == MUS__SHAPE_PRINCESS_SHOULDER || shape == MUS__SHAPE_PRINCESS_ARMHOLE;
    const bool merged = shaping_darted(half) && ((shape == MUS__SHAPE_WAIST && shaping_has_room(half, top)) ||
                                                 shape == MUS__SHAPE_FRENCH);
    const bool cut = shape == MUS__SHAPE_EMPIRE && half->bodice.dart_width > 0.0;
    const bool long_french = shape == MUS__SHAPE_FRENCH && merged && top->hem < 0.0;
    top->waist_darts[MUS__TOP_FRONT] = top->darts && !princess && !cut && !long_french;
    top->waist_darts[MUS__TOP_BACK] = top->darts && !princess;

    /* darts that will be merged share their point */
    top->meet = merged;
    const bool side = shape == MUS__SHAPE_SIDE_WAIST || shape == MUS__SHAPE_EMPIRE ||
                      (shape == MUS__SHAPE_WAIST && !merged);
    top->point_back = side ? SHAPING_BACK : 0.0;
}


/* ---- darts ---- */

/* waist: the bust dart is rotated into the waist dart, or to the lower edge when there is none */
static void shaping_waist(mus__half *half, mus__top *top)
{
    mus__board *board = &half->board;
    if (!top->meet) return;
    const int32_t keep = mus__shaping_side(half, top, MUS__TOP_FRONT, "cf");
    const int32_t first = mus__shaping_side(half, top, MUS__TOP_FRONT, "w1");
    const int32_t low = first != MUS_NONE ? first : mus__shaping_side(half, top, MUS__TOP_FRONT, "low");
    if (board->status != MUS_OK || low == MUS_NONE) return;
    const double s = first != MUS_NONE ? board->side[low].length : half->bodice.front.bust[0];
    const int32_t leg = mus__shaping_turn(half, top, low, s, 1.0, keep);
    if (leg != MUS_NONE) mus__board_dart_shorten(board, leg, SHAPING_BACK);
}


/* french: bust and waist dart are merged low on the side, 5 cm above the waist */
static void shaping_french(mus__half *half, mus__top *top)
{
    mus__board *board = &half->board;
    const int32_t side = mus__shaping_side(half, top, MUS__TOP_FRONT, "side1");
    const int32_t keep = mus__shaping_side(half, top, MUS__TOP_FRONT, "cf");
    if (side == MUS_NONE || board->status != MUS_OK) return;
    const double *end = mus__board_end(board, side);
    const double steep = 1.0 / mus__cos(mus__atan2(top->side_in, half->bodice.underarm));
    const double y = fmax(5.0 * top->scale * MUS__CM, top->hem + 2.5 * MUS__CM);
    const double down = fmax((end[1] - y) * steep, 0.01), s = board->side[side].length - down;
    int32_t leg = mus__shaping_turn(half, top, side, s, 1.0, keep);
    const int32_t waist = mus__shaping_side(half, top, MUS__TOP_FRONT, "wd1");
    if (leg != MUS_NONE && waist != MUS_NONE) {
        leg = mus__board_dart_rotate(board, waist, side, board->side[side].length, keep, 1.0);
        mus__shaping_smooth(board, mus__shaping_side(half, top, MUS__TOP_FRONT, "w1"));
    }
    if (leg != MUS_NONE) mus__board_dart_shorten(board, leg, SHAPING_BACK);
}


/* shoulder_waist: the bust dart is rotated to the middle of the shoulder */
static void shaping_shoulder(mus__half *half, mus__top *top)
{
    mus__board *board = &half->board;
    const int32_t shoulder = mus__shaping_side(half, top, MUS__TOP_FRONT, "sh");
    const int32_t keep = mus__shaping_side(half, top, MUS__TOP_FRONT, "cf");
    if (shoulder == MUS_NONE || board->status != MUS_OK) return;
    const double s = 0.5 * board->side[shoulder].length;
    const int32_t leg = mus__shaping_turn(half, top, shoulder, s, 1.0, keep);
    if (leg != MUS_NONE) mus__board_dart_shorten(board, leg, SHAPING_BACK);
}


/* boxy: 0.65 of the bust dart becomes flare at the lower edge, the rest is eased into the armhole; chosen */
static void shaping_boxy(mus__half *half, mus__top *top)
{
    mus__board *board = &half->board;
    const mus__bodice_half *front = &half->bodice.front;
    const int32_t keep = mus__shaping_side(half, top, MUS__TOP_FRONT, "cf");
    const int32_t low = mus__shaping_side(half, top, MUS__TOP_FRONT, "low");
    int32_t leg = mus__shaping_turn(half, top, low, front->bust[0], 0.65, keep);
    if (leg == MUS_NONE) return;
    mus__shaping_smooth(board, mus__board_dart_release(board, leg));

    /* without an armhole, the rest becomes flare too */
    const int32_t arm = mus__shaping_side(half, top, MUS__TOP_FRONT, "arm");
    if (arm == MUS_NONE || board->status != MUS_OK) return;
    const double s = fmin(front->arm_low_length, 0.7 * board->side[arm].length);
    leg = mus__shaping_turn(half, top, arm, s, 1.0, keep);
    if (leg != MUS_NONE) mus__shaping_smooth_arm(board, mus__board_dart_release(board, leg));
}


void mus__shaping_work(mus__half *half, mus__top *top)
{
    const int32_t shape = half->style.option[MUS__AXIS_SHAPE];
    if (half->board.status != MUS_OK) return;
    switch (shape) {
    case MUS__SHAPE_WAIST: shaping_waist(half, top); break;
    case MUS__SHAPE_SHOULDER_WAIST: shaping_shoulder(half, top); break;
    case MUS__SHAPE_FRENCH: shaping_french(half, top); break;
    case MUS__SHAPE_PRINCESS_SHOULDER:
    case MUS__SHAPE_PRINCESS_ARMHOLE: mus__shaping_princess(half, top, shape == MUS__SHAPE_PRINCESS_ARMHOLE); break;
    case MUS__SHAPE_NECK_GATHERS: mus__shaping_neck_gathers(half, top); break;
    case MUS__SHAPE_CF_GATHERS: mus__shaping_centre_gathers(half, top); break;
    case MUS__SHAPE_EMPIRE: mus__shaping_empire(half, top); break;
    case MUS__SHAPE_BOXY: shaping_boxy(half, top); break;
    default: break;
    }
}
