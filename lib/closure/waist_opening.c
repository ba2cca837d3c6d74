/*
 * waist_opening.c: where skirts and trousers with a fitted waist open: a zip in one seam of the panels below, and the
 * band open above it.
 *
 * The word of the closure names a line: centre front, centre back, or the left side. A centre line that is a fold has
 * no seam to open; then it is the left side seam. The zip begins at the waist and ends at the hips, and what is above
 * it must open too: the band has two ends there, drawn done up as all closures are, a seam with a button. One end goes
 * on under the other: that underlap is its allowance, and a line marks where the allowance of a seam begins in it.
 *
 *      right front        |        left front            as worn, seen from outside
 *      --- band --------- | ------------ o | ...         o buttonhole; the band of the right goes on under
 *                         zip                            the left one by the underlap
 *
 * Under a bodice that opens behind the zip goes on below the waist: else shoulders and hips would not pass it. A centre
 * back that is a fold becomes a seam there.
 *
 * The left front laps over the right, for which the fly is drawn; the left back over the right; the front over the
 * back at the side (dressmaking practice, for back and side). Sides are split at the end of the zip on both sides of
 * the wearer, so that what is cut mirrored stays so; the right side seam is sewn.
 */
#include <math.h>
#include <string.h>

#include "closure/closure.h"

#define WAIST_ZIP_MOST 0.6 /* of the seam that the zip takes at most; chosen: the seam below still holds its end */
#define WAIST_SIDE_OFF 0.05 /* distance of the side seam from the middle of half a waist, as a part of it, at most */


/* the joint of the waist between front and back: the first side behind it, from centre back to centre front */
static int32_t opening_side(const mus__half *half, int32_t n, const int32_t *waist)
{
    const mus__board *board = &half->board;
    double length = 0.0, at = 0.0, off = WAIST_SIDE_OFF;
    int32_t found = MUS_NONE;
    for (int32_t i = 0; i < n; i++) length += board->side[waist[i]].length;
    for (int32_t i = 1; i < n; i++) {
        at += board->side[waist[i - 1]].length;
        const int32_t seam = board->side[waist[i - 1]].next;
        if (strcmp(board->side[seam].attr.label, "side") != 0 || fabs(at / length - 0.5) >= off) continue;
        off = fabs(at / length - 0.5);
        found = i;
    }
    return found;
}


static bool opening_seam(const mus__half *half, int32_t side)
{
    return half->board.side[side].centre == MUS__CENTRE_SEAM;
}


int32_t mus__waist_opens(const mus__half *half, int32_t n, const int32_t *waist)
{
    const mus__board *board = &half->board;
    const int32_t closure = half->style.option[MUS__AXIS_CLOSURE];
    if (board->status != MUS_OK || n == 0 || half->style.option[MUS__AXIS_BAND] == MUS__BAND_ELASTIC)
        return MUS__CLOSURE_NONE;
    if (closure == MUS__CLOSURE_FRONT && opening_seam(half, board->side[waist[n - 1]].next)) return closure;
    if (closure == MUS__CLOSURE_BACK && opening_seam(half, board->side[waist[0]].prev)) return closure;
    return closure == MUS__CLOSURE_NONE || mus__wraps(half) ? MUS__CLOSURE_NONE : MUS__CLOSURE_SIDE;
}


void mus__waist_zip(mus__half *half, int32_t n, const int32_t *waist)
{
    mus__board *board = &half->board;
    const int32_t opens = mus__waist_opens(half, n, waist);
    const int32_t joint = opens == MUS__CLOSURE_SIDE ? opening_side(half, n, waist) : n;
    if (opens == MUS__CLOSURE_NONE || joint == MUS_NONE) return;
    const bool up = opens == MUS__CLOSURE_BACK; /* the side is walked up to the waist, else down from it */
    const int32_t seam = up ? board->side[waist[0]].prev : board->side[waist[joint - 1]].next;
    const double length = board->side[seam].length;
    const double zip = fmin(MUS__ZIP * mus__measures_scale(&half->measures), WAIST_ZIP_MOST * length);
    const int32_t partner = mus__board_partner(board, seam), centre = board->side[seam].centre;
    const int32_t low = mus__board_split(board, seam, up ? length - zip : zip, up ? "zip" : NULL);
    if (low == MUS_NONE) return;
    board->side[low].centre = centre;
    mus__board_notch_add(board, low, 0.0, MUS_NOTCH_TRIPLE);
    if (up) return;

    /* the first part keeps the name: it is the zip's, and the rest gets the name back */
    char name[MUS__NAME_BYTES];
    memcpy(name, board->side[seam].name, sizeof name);
    mus__board_rename(board, seam, "zip", NULL);
    mus__board_rename(board, low, name, NULL);
    if (partner != MUS_NONE) mus__board_rename(board, board->side[partner].next, "zip", NULL);
}


void mus__waist_zip_below(mus__half *half, int32_t n, const int32_t *waist)
{
    mus__board *board = &half->board;
    if (board->status != MUS_OK || n == 0 || !mus__style_is(half, MUS__AXIS_CLOSURE, MUS__CLOSURE_BACK)) return;
    mus__board_side *centre = &board->side[board->side[waist[0]].prev];
    if (centre->centre == MUS__CENTRE_FOLD) centre->centre = MUS__CENTRE_SEAM;
    if (centre->centre != MUS__CENTRE_SEAM) return;
    centre->attr.allowance = MUS__ZIP_SEAM; /* down to the hem: no step of the cut line at the zip's end */
    mus__waist_zip(half, n, waist);
}


/* ---- the whole garment ---- */

/* whether a side is the wearer's right one */
static bool opening_right(const mus__board *board, int32_t side)
{
    const char *names[2] = {board->side[side].name, board->panel[board->side[side].panel].name};
    static const char *const ends[2] = {"_r", "_right"};
    for (int32_t i = 0; i < 2; i++) {
        const size_t n = strlen(names[i]), m = strlen(ends[i]);
        if (n > m && strcmp(names[i] + n - m, ends[i]) == 0) return true;
    }
    return false;
}


/* the ends of the band above the zip: `under` goes on under `over` */
static void opening_band(mus__half *half, int32_t over, int32_t under)
{
    mus__board *board = &half->board;
    const double lap = MUS__UNDERLAP * mus__measures_scale(&half->measures);
    mus__board_part_twins(board, board->side[over].panel);
    mus__board_part_twins(board, board->side[under].panel);
    mus__closure_lap(board, under, lap, "underlap");
    mus__closure_button(board, under, 0.5 * lap, "button");
    mus__closure_button(board, over, -0.5 * lap, "buttonhole");
}


void mus__waist_close(mus__half *half)
{
    mus__board *board = &half->board;
    const int32_t nseam = board->nseam;
    for (int32_t i = 0; i < nseam && board->status == MUS_OK; i++) {
        mus__board_seam *seam = &board->seam[i];
        if (seam->a == MUS_NONE || (opening_right(board, seam->a) && opening_right(board, seam->b))) continue;
        const char *name = board->side[seam->a].name;
        if (strcmp(name, "zip") == 0) seam->closure = MUS_CLOSURE_ZIP;
        if (strcmp(name, "open") != 0) continue;
        seam->closure = MUS_CLOSURE_BUTTONS;
        const bool behind = strcmp(board->panel[board->side[seam->a].panel].name, "band_back") == 0;
        const bool under = behind || opening_right(board, seam->a);
        opening_band(half, under ? seam->b : seam->a, under ? seam->a : seam->b);
    }
}
