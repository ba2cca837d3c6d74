/*
 * shaping.c: where the shaping of a bodice goes: the ten shapes, by moving darts and cutting panels apart.
 *
 * Every shape begins as the block: a front whose bust dart opens at the side, its point on the bust point. The dart is
 * turned about that point to where the word says (waist, shoulder, neck, centre, a line low on the side), let out as
 * gathers or flare, or run on into a seam that cuts the panel (shaping_cut.c, shaping_gather.c). Waist darts that a
 * shape keeps are drawn with the panel. What a shape asks for and a body has not (a bust dart of a flat chest) is left
 * out. At the end points stop short of the bust point, where the cloth rounds itself. Founding paper, section 5
 * (designs by separating and rotating patterns); drafting reference 4.1 to 4.4, 5.2.
 */
#include <math.h>
#include <string.h>

#include "design/top.h"
#include "geom/curve.h"
#include "geom/vec.h"

#define SHAPING_BACK (2.0 * MUS__CM) /* sewn darts end so far from the bust point */



static bool shaping_darted(const mus__half *half)
{
    return half->bodice.front.theta > 0.0;
}


void mus__shaping_plan(const mus__half *half, mus__top *top)
{
    /* a waist dart that becomes part of a seam is not drawn, nor one from a hem that a French dart cannot take in */
    const int32_t shape = half->style.option[MUS__AXIS_SHAPE];
    const bool princess = shape == MUS__SHAPE_PRINCESS_SHOULDER || shape == MUS__SHAPE_PRINCESS_ARMHOLE;
    const bool merged = shaping_darted(half) && (shape == MUS__SHAPE_WAIST || shape == MUS__SHAPE_FRENCH);
    const bool cut = shape == MUS__SHAPE_EMPIRE && half->bodice.dart_width > 0.0;
    const bool long_french = shape == MUS__SHAPE_FRENCH && merged && top->hem < 0.0;
    top->waist_darts[MUS__TOP_FRONT] = top->darts && !princess && !cut && !long_french;
    top->waist_darts[MUS__TOP_BACK] = top->darts && !princess;

    /* darts that are to be one have one point */
    top->meet = merged;
    top->point_back = shape == MUS__SHAPE_SIDE_WAIST || shape == MUS__SHAPE_EMPIRE ? SHAPING_BACK : 0.0;
}


int32_t mus__shaping_turn(mus__half *half, mus__top *top, int32_t target, double s, double fraction, int32_t keep)
{
    mus__board *board = &half->board;
    const int32_t leg = mus__board_find(board, top->panel[MUS__TOP_FRONT], "bd1");
    if (leg == MUS_NONE) return MUS_NONE;
    return mus__board_dart_rotate(board, leg, target, s, keep, fraction);
}


int32_t mus__shaping_side(const mus__half *half, const mus__top *top, int32_t which, const char *name)
{
    const bool alone = mus__style_is(half, MUS__AXIS_GARMENT, MUS__GARMENT_TOP);
    return mus__board_find(&half->board, top->panel[which], strcmp(name, "low") == 0 ? alone ? "hem" : "waist" : name);
}


/* ---- darts ---- */

/* all into the waist: the bust dart is turned into the waist dart, or to the lower edge where there is none */
static void shaping_waist(mus__half *half, mus__top *top)
{
    mus__board *board = &half->board;
    const int32_t keep = mus__shaping_side(half, top, MUS__TOP_FRONT, "cf");
    const int32_t first = mus__shaping_side(half, top, MUS__TOP_FRONT, "w1");
    const int32_t low = first != MUS_NONE ? first : mus__shaping_side(half, top, MUS__TOP_FRONT, "low");
    if (board->status != MUS_OK || low == MUS_NONE) return;
    const double s = first != MUS_NONE ? board->side[low].length : half->bodice.front.bust[0];
    const int32_t leg = mus__shaping_turn(half, top, low, s, 1.0, keep);
    if (leg != MUS_NONE) mus__board_dart_shorten(board, leg, SHAPING_BACK);
}


/* bust and waist dart together low on the side, 5 cm above the waist */
static void shaping_french(mus__half *half, mus__top *top)
{
    mus__board *board = &half->board;
    const int32_t side = mus__shaping_side(half, top, MUS__TOP_FRONT, "side1");
    const int32_t keep = mus__shaping_side(half, top, MUS__TOP_FRONT, "cf");
    if (side == MUS_NONE || board->status != MUS_OK) return;
    const double *end = mus__board_end(board, side);
    const double steep = 1.0 / cos(atan2(top->side_in, half->bodice.underarm));
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


/* the bust dart to the middle of the shoulder */
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


/* sides of one label after `side` become one with it */
static void shaping_whole(mus__board *board, int32_t side)
{
    if (side == MUS_NONE) return;
    while (board->status == MUS_OK && strcmp(board->side[board->side[side].next].label, board->side[side].label) == 0)
        mus__board_merge(board, side);
}


void mus__shaping_smooth(mus__board *board, int32_t side)
{
    double start[2], end[2], along[2][2];
    shaping_whole(board, side);
    if (board->status != MUS_OK || side == MUS_NONE) return;
    const double length = board->side[side].length;
    mus__board_at(board, side, 0.0, start, along[0]);
    mus__board_at(board, side, length, end, along[1]);
    const double reach = 0.36 * length;
    const double xy[8] = {start[0], start[1], start[0] + reach * along[0][0], start[1] + reach * along[0][1],
                          end[0] - reach * along[1][0], end[1] - reach * along[1][1], end[0], end[1]};
    const int32_t kind = MUS__CUBIC;
    mus__board_redraw(board, side, 1, &kind, 4, xy);
}


/* an armhole of a curve, the line across a mouth and a curve: the curves meet in the middle of the line with one
 * tangent, their handles as long as they were */
static void shaping_smooth_arm(mus__board *board, int32_t side)
{
    shaping_whole(board, side);
    if (board->status != MUS_OK || side == MUS_NONE) return;
    const mus__board_chain *chain = &board->side[side].chain;
    if (chain->npiece != 3 || chain->kinds[0] != MUS__CUBIC || chain->kinds[1] != MUS__LINE ||
        chain->kinds[2] != MUS__CUBIC)
        return;
    const double *a = chain->xy, *b = chain->xy + 8;
    double xy[14], along[2], norm = 0.0;
    const double before = mus__dist2(a + 4, a + 6), after = mus__dist2(b, b + 2);
    memcpy(xy, a, 4 * sizeof *xy);
    memcpy(xy + 10, b + 4, 4 * sizeof *xy);
    for (int i = 0; i < 2; i++) {
        along[i] = (a[6 + i] - a[4 + i]) / before + (b[2 + i] - b[i]) / after;
        norm += along[i] * along[i];
    }
    for (int i = 0; i < 2; i++) {
        const double middle = 0.5 * (a[6 + i] + b[i]), unit = along[i] / sqrt(norm);
        xy[4 + i] = middle - before * unit;
        xy[6 + i] = middle;
        xy[8 + i] = middle + after * unit;
    }
    const int32_t kinds[2] = {MUS__CUBIC, MUS__CUBIC};
    mus__board_redraw(board, side, 2, kinds, 7, xy);
}


/* loose: 0.65 of the bust dart to the lower edge as flare, the rest eased into the armhole */
static void shaping_boxy(mus__half *half, mus__top *top)
{
    mus__board *board = &half->board;
    const mus__bodice_half *front = &half->bodice.front;
    const int32_t keep = mus__shaping_side(half, top, MUS__TOP_FRONT, "cf");
    const int32_t low = mus__shaping_side(half, top, MUS__TOP_FRONT, "low");
    int32_t leg = mus__shaping_turn(half, top, low, front->bust[0], 0.65, keep);
    if (leg == MUS_NONE) return;
    mus__shaping_smooth(board, mus__board_dart_release(board, leg));

    /* without an armhole all that is left goes into the lower edge too */
    const int32_t arm = mus__shaping_side(half, top, MUS__TOP_FRONT, "arm");
    if (arm == MUS_NONE || board->status != MUS_OK) return;
    const double s = fmin(front->arm_low_length, 0.7 * board->side[arm].length);
    leg = mus__shaping_turn(half, top, arm, s, 1.0, keep);
    if (leg != MUS_NONE) shaping_smooth_arm(board, mus__board_dart_release(board, leg));
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
