/*
 * closure.c: the centre lines of a top: a fold, a closure drawn done up, or a plain seam; and what goes on beyond a
 * seam line.
 *
 * A front that buttons and a back that zips are drawn closed, as they are worn: their centre is a seam with a closure,
 * which a cloth can leave open. The part beyond the centre is allowance: a button stand of 1.75 cm, turned under by as
 * much and 1 cm more, with a mark where it is folded. Buttons and the ends of a side zip are marked. Where a fold meets
 * an edge that is sewn or faced, a notch shows the centre. Method: FreeSewing 4 (simon).
 */
#include <math.h>
#include <string.h>

#include "base/elementary.h"
#include "closure/closure.h"

#define CLOSURE_BUTTONS (8.5 * MUS__CM) /* largest distance between buttons */
/* [m] a buttonhole begins beyond the middle of the button, where its shank comes to rest; dressmaking has 3 mm */
#define CLOSURE_SHANK 0.003


/* marks a button at `at` on a line, and about it the buttonhole of the other layer: as long as the button is wide, from
 * beyond the line, on the side of `out` (a unit vector), to within the panel. Both layers are cut of one piece, so each
 * has both marks */
static void closure_fasten(mus__board *board, int32_t panel, const double *at, const double *out)
{
    const double within = MUS__BUTTON_STAND - CLOSURE_SHANK;
    const double line[4] = {at[0] + CLOSURE_SHANK * out[0], at[1] + CLOSURE_SHANK * out[1], at[0] - within * out[0],
                            at[1] - within * out[1]};
    if (board->status != MUS_OK) return;
    mus__board_mark_add(board, panel, "button", 1, at);
    mus__board_mark_add(board, panel, "buttonhole", 2, line);
}


/* marks buttons on the centre line at even distances from 1.5 cm below the neck to 4 cm above the hem, on a coat half
 * as many, for they are larger. Their buttonholes run along that line: the stand is folded back no further than they
 * would reach across it */
static void closure_buttons(mus__half *half, int32_t side)
{
    mus__board *board = &half->board;
    const double *top = mus__board_start(board, side), *foot = mus__board_end(board, side);
    if (top == NULL || foot == NULL) return;
    const double length = top[1] - foot[1] - 5.5 * MUS__CM, up[2] = {0.0, 1.0};
    const bool coat = mus__style_is(half, MUS__AXIS_EASE, MUS__EASE_COAT);
    const int32_t n = (int32_t)ceil(fmax(length, 0.0) / (coat ? 2.0 * CLOSURE_BUTTONS : CLOSURE_BUTTONS));
    for (int32_t i = 0; i <= n; i++) {
        const double part = n > 0 ? (double)i / n : 0.0;
        const double xy[2] = {top[0], top[1] - 1.5 * MUS__CM - part * fmax(length, 0.0)};
        closure_fasten(board, board->side[side].panel, xy, up);
    }
}


/* the line that lies `out` beyond a side: xy (4) */
static void closure_beyond(const mus__board *board, int32_t side, double out, double *xy)
{
    const double *p = mus__board_start(board, side), *q = mus__board_end(board, side);
    const double part = out / mus__hypot(q[0] - p[0], q[1] - p[1]);
    const double x = part * (q[1] - p[1]), y = part * (p[0] - q[0]);
    xy[0] = p[0] + x, xy[1] = p[1] + y, xy[2] = q[0] + x, xy[3] = q[1] + y;
}


/* marks the line `out` beyond a side [m] by its name */
static void closure_line(mus__board *board, int32_t side, double out, const char *name)
{
    double line[4];
    if (board->status != MUS_OK) return;
    closure_beyond(board, side, out, line);
    mus__board_mark_add(board, board->side[side].panel, name, 2, line);
}


void mus__closure_fold(mus__board *board, int32_t side, double out)
{
    closure_line(board, side, out, "fold");
}


void mus__closure_set(mus__half *half)
{
    mus__board *board = &half->board;
    if (board->status != MUS_OK) return;
    for (int32_t i = 0; i < board->nside; i++) {
        mus__board_side *side = &board->side[i];
        if (side->panel == MUS_NONE || strcmp(side->attr.label, "centre") != 0) continue;
        const bool front = strncmp(board->panel[side->panel].name, "front", 5) == 0;
        const bool opens = mus__style_is(half, MUS__AXIS_CLOSURE, front ? MUS__CLOSURE_FRONT : MUS__CLOSURE_BACK);
        const bool seam = mus__style_is(half, MUS__AXIS_CLOSURE, MUS__CLOSURE_SEAMS);
        side->centre = opens || seam ? MUS__CENTRE_SEAM : MUS__CENTRE_FOLD;
        side->attr.allowance = !opens ? 0.0 : front ? 2.0 * MUS__BUTTON_STAND + 1.0 * MUS__CM : MUS__ZIP_SEAM;
        if (seam) side->attr.allowance = MUS__SEAM_ALLOWANCE;
        if (!opens || !front) continue;
        closure_buttons(half, i);
        /* the interfacing is as wide as the stand and what is folded behind it, which ends on the centre too */
        mus__closure_fold(board, i, MUS__BUTTON_STAND);
        closure_line(board, i, 2.0 * MUS__BUTTON_STAND, "interfacing");
    }
}


/* whether a side meets the fold beside it square enough to need a notch there: a corner, as of a V, shows itself */
static bool closure_square(const mus__board *board, int32_t fold, int32_t side, bool ends)
{
    double along[2];
    const double *p = mus__board_start(board, fold), *q = mus__board_end(board, fold);
    mus__board_at(board, side, ends ? board->side[side].length : 0.0, NULL, along);
    const double x = q[0] - p[0], y = q[1] - p[1], dot = along[0] * x + along[1] * y;
    return dot * dot < 0.25 * (x * x + y * y);
}


/* whether a side that ends at a fold (else begins there) is sewn to one that does too, or gets a facing or a band of
 * rib */
static bool closure_met(const mus__board *board, int32_t side, bool ends)
{
    const char *label = board->side[side].attr.label, *part = board->panel[board->side[side].panel].attr.label;
    const int32_t partner = mus__board_partner(board, side);
    if (partner != MUS_NONE) {
        const int32_t beside = ends ? board->side[partner].prev : board->side[partner].next;
        return board->side[beside].centre == MUS__CENTRE_FOLD;
    }
    if (strcmp(part, "collar") == 0 || strcmp(part, "hood") == 0 || strcmp(part, "band") == 0) return false;
    return strcmp(label, "neck") == 0 || (strcmp(label, "waist") == 0 && strcmp(part, "elastic") != 0);
}


void mus__closure_folds(mus__half *half)
{
    mus__board *board = &half->board;
    const int32_t nside = board->nside;
    for (int32_t i = 0; i < nside && board->status == MUS_OK; i++) {
        const mus__board_side *side = &board->side[i];
        if (side->panel == MUS_NONE || side->centre != MUS__CENTRE_FOLD) continue;
        const int32_t before = side->prev, after = side->next;
        const int32_t kind = strstr(board->panel[side->panel].name, "back") != NULL ? MUS_NOTCH_DOUBLE
                                                                                     : MUS_NOTCH_SINGLE;
        if (closure_met(board, before, true) && closure_square(board, i, before, true))
            mus__board_notch_add(board, before, board->side[before].length, kind);
        if (closure_met(board, after, false) && closure_square(board, i, after, false))
            mus__board_notch_add(board, after, 0.0, kind);
    }
}


/* whether a name has the ending `end` */
static bool closure_ends(const char *name, const char *end)
{
    const size_t n = strlen(name), m = strlen(end);
    return n >= m && strcmp(name + n - m, end) == 0;
}


/* puts a notch at height y on a half-edge of the front */
static void closure_notch(mus__board *board, int32_t side, double y)
{
    double lo = 0.0, hi = board->side[side].length, at[2];
    mus__board_at(board, side, lo, at, NULL);
    const bool above = at[1] > y;
    mus__board_at(board, side, hi, at, NULL);
    if ((at[1] > y) == above) return;
    for (int i = 0; i < 40; i++) {
        const double s = 0.5 * (lo + hi);
        mus__board_at(board, side, s, at, NULL);
        if ((at[1] > y) == above) lo = s;
        else hi = s;
    }
    mus__board_notch_add(board, side, lo, MUS_NOTCH_TRIPLE);
}


/* sets the closures of the centre seams: buttons in front, a zip behind */
static void closure_seams(mus__half *half)
{
    mus__board *board = &half->board;
    for (int32_t i = 0; i < board->nseam; i++) {
        mus__board_seam *seam = &board->seam[i];
        if (seam->a == MUS_NONE || strcmp(board->side[seam->a].attr.label, "centre") != 0 ||
            strcmp(board->side[seam->b].attr.label, "centre") != 0)
            continue;
        const char *panel = board->panel[board->side[seam->a].panel].name;
        if (strncmp(panel, "front", 5) == 0 && mus__style_is(half, MUS__AXIS_CLOSURE, MUS__CLOSURE_FRONT))
            seam->closure = MUS_CLOSURE_BUTTONS;
        if (strncmp(panel, "back", 4) == 0 && mus__style_is(half, MUS__AXIS_CLOSURE, MUS__CLOSURE_BACK))
            seam->closure = MUS_CLOSURE_ZIP;
    }
}


void mus__closure_button(mus__board *board, int32_t side, double out, const char *mark)
{
    const double *p = mus__board_start(board, side), *q = mus__board_end(board, side);
    const double part = out / mus__hypot(q[0] - p[0], q[1] - p[1]);
    const double xy[2] = {0.5 * (p[0] + q[0]) + part * (q[1] - p[1]), 0.5 * (p[1] + q[1]) + part * (p[0] - q[0])};
    if (board->status == MUS_OK) mus__board_mark_add(board, board->side[side].panel, mark, 1, xy);
}


void mus__closure_fasten(mus__board *board, int32_t side)
{
    if (board->status != MUS_OK) return;
    const double *p = mus__board_start(board, side), *q = mus__board_end(board, side);
    const double length = mus__hypot(q[0] - p[0], q[1] - p[1]);
    const double out[2] = {(q[1] - p[1]) / length, (p[0] - q[0]) / length};
    const double at[2] = {0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1])};
    closure_fasten(board, board->side[side].panel, at, out);
}


void mus__closure_lap(mus__board *board, int32_t side, double lap, const char *mark)
{
    double line[4];
    if (board->status != MUS_OK) return;
    closure_beyond(board, side, lap, line);
    board->side[side].attr.allowance += lap;
    mus__board_mark_add(board, board->side[side].panel, mark, 2, line);
}


void mus__closure_finish(mus__half *half)
{
    if (half->board.status == MUS_OK) closure_seams(half);
    mus__wrap_finish(half);

    /* marks the ends of a zip of 18 cm about the waist in the left side seam */
    mus__board *board = &half->board;
    const bool lower = !mus__style_has(half->style.option[MUS__AXIS_GARMENT], MUS__AXIS_NECK);
    if (board->status != MUS_OK || lower || !mus__style_is(half, MUS__AXIS_CLOSURE, MUS__CLOSURE_SIDE)) return;
    const double reach = 0.5 * MUS__ZIP * mus__measures_scale(&half->measures);
    const int32_t nside = board->nside;
    for (int32_t i = 0; i < nside; i++) {
        const mus__board_side *side = &board->side[i];
        const bool other = strcmp(side->attr.label, "side") != 0;
        if (side->panel == MUS_NONE || other || closure_ends(side->name, "_r")) continue;
        const char *panel = board->panel[side->panel].name;
        if (strncmp(panel, "front", 5) != 0 || closure_ends(panel, "_right")) continue;
        closure_notch(board, i, reach);
        closure_notch(board, i, -reach);
    }
}
