/*
 * shaping_gather.c: the bust dart released as gathers at the neck or at the centre front, and the band or strip that
 * holds them.
 *
 * The dart is rotated to three points of the edge, a third each, and released, so that the edge becomes longer by the
 * three mouths. It is gathered to its former length: at the neck to a band 2.5 cm high, at the centre front to a
 * straight strip that is cut off the front first.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "geom/curve.h"
#include "geom/vec.h"
#include "style/bodice.h"

#define GATHER_PARTS 3


/* ---- neck ---- */

void mus__shaping_neck_gathers(mus__half *half, mus__top *top)
{
    mus__board *board = &half->board;
    const int32_t cf = mus__shaping_side(half, top, MUS__TOP_FRONT, "cf");
    int32_t neck = mus__shaping_side(half, top, MUS__TOP_FRONT, "neck");
    if (board->status != MUS_OK || neck == MUS_NONE) return;
    const double length = board->side[neck].length;

    /* the neck is walked from the side neck to the centre: thirds of the dart at 0.35, 0.55, 0.75 of it, the last
     * first; what is let out lies behind the next place */
    for (int i = GATHER_PARTS - 1; i >= 0; i--) {
        const double s = (0.35 + 0.2 * i) * length;
        const int32_t leg = mus__shaping_turn(half, top, neck, s, 1.0 / (i + 1), cf);
        if (leg == MUS_NONE) return;
        neck = mus__board_dart_release(board, leg);
    }
    neck = mus__shaping_side(half, top, MUS__TOP_FRONT, "neck");
    mus__shaping_smooth(board, neck);
    if (board->status == MUS_OK) half->neck_gathers = length / board->side[neck].length;
}


/* a piece of the band's lower edge for each side of the neck, as long as that side is to be */
static void gather_pieces(const mus__half *half, const int32_t *boundary, int32_t n, double *length)
{
    const mus__board *board = &half->board;
    for (int32_t i = 0; i < n; i++) {
        const mus__board_side *side = &board->side[boundary[n - 1 - i]];
        const bool front = strncmp(board->panel[side->panel].name, "front", 5) == 0;
        length[i] = side->length * (front ? half->neck_gathers : 1.0);
    }
}


/* x = 0 at the centre front, x > 0 over the left side to the centre back */
void mus__neck_band_attach(mus__half *half)
{
    mus__board *board = &half->board;
    int32_t boundary[MUS__TOP_RUN], lower[MUS__TOP_RUN];
    double length[MUS__TOP_RUN], at[2] = {0.0, 0.0};
    if (board->status != MUS_OK || !(half->neck_gathers > 0.0)) return;
    const int32_t n = mus__half_boundary(half, "", "neck", boundary, MUS__TOP_RUN);
    if (n < 1 || n > MUS__TOP_RUN) return;
    gather_pieces(half, boundary, n, length);

    /* the lower edge in pieces, back up, the upper edge, down at the front */
    const int32_t panel = mus__board_panel_add(board, "neck_band", "neck");
    for (int32_t i = 0; i < n; i++) {
        const double end[2] = {at[0] + length[i], 0.0};
        char name[16];
        snprintf(name, sizeof name, "low_%d", (int)i + 1);
        lower[i] = mus__board_line_add(board, panel, name, "", at, end);
        at[0] = end[0];
    }
    const double high = 2.5 * mus__measures_scale(&half->measures) * MUS__CM;
    const double corner[4][2] = {{at[0], 0.0}, {at[0], high}, {0.0, high}, {0.0, 0.0}};
    const int32_t cb = mus__board_line_add(board, panel, "cb", "centre", corner[0], corner[1]);
    const int32_t top = mus__board_line_add(board, panel, "top", "neck", corner[1], corner[2]);
    const int32_t cf = mus__board_line_add(board, panel, "cf", "centre", corner[2], corner[3]);
    mus__board_panel_close(board, panel);
    if (board->status != MUS_OK) return;

    /* one piece with a seam behind; with a closure in front, one behind on the fold */
    const bool opens = mus__style_is(half, MUS__AXIS_CLOSURE, MUS__CLOSURE_FRONT);
    board->side[top].attr.allowance = high + MUS__TOP_NECK_SEAM; /* the band is turned in along its upper edge */
    mus__half_cut(half, panel, 1, MUS_MATERIAL_INTERFACING, 1);
    mus__half_band_grain(half, panel);
    board->side[cb].centre = opens ? MUS__CENTRE_FOLD : MUS__CENTRE_SEAM;
    board->side[cf].centre = opens ? MUS__CENTRE_SEAM : MUS__CENTRE_FOLD;
    board->side[opens ? cf : cb].attr.allowance = MUS__TOP_NECK_SEAM;
    board->side[opens ? cb : cf].attr.allowance = 0.0;
    for (int32_t i = 0; i < n; i++) {
        const int32_t side = boundary[n - 1 - i];
        board->side[lower[i]].attr.allowance = MUS__TOP_NECK_SEAM;
        mus__board_seam_add(board, side, lower[i], MUS_SEAM_REVERSED, length[i] - board->side[side].length);
    }
    mus__panel_place_ring(half, panel, true, 2.0 * at[0] + 0.08, half->skeleton.neck_side);
}


/* ---- centre front ---- */

/* arc length of a side of the front where x falls below `x`, walked towards the centre */
static double gather_where(const mus__board *board, int32_t side, double x)
{
    double lo = 0.0, hi = board->side[side].length, at[2];
    for (int i = 0; i < 40; i++) {
        const double s = 0.5 * (lo + hi);
        mus__board_at(board, side, s, at, NULL);
        if (at[0] > x) lo = s;
        else hi = s;
    }
    return 0.5 * (lo + hi);
}


/* a strip 1.5 cm wide along the centre (2.5 beside a keyhole), cut off the front: its long side, or MUS_NONE */
static int32_t gather_strip(mus__half *half, mus__top *top)
{
    mus__board *board = &half->board;
    const bool keyhole = mus__style_is(half, MUS__AXIS_NECK, MUS__NECK_KEYHOLE);
    const double x = (keyhole ? 2.5 : 1.5) * top->scale * MUS__CM;
    const int32_t neck = mus__shaping_side(half, top, MUS__TOP_FRONT, "neck");
    const int32_t low = mus__shaping_side(half, top, MUS__TOP_FRONT, top->waist_darts[MUS__TOP_FRONT] ? "w1" : "low");
    if (board->status != MUS_OK || neck == MUS_NONE || low == MUS_NONE) return MUS_NONE;
    const int32_t from = mus__board_split(board, neck, gather_where(board, neck, x), NULL);
    const int32_t to = mus__board_split(board, low, x, NULL);
    if (board->status != MUS_OK) return MUS_NONE;
    const double *a = mus__board_start(board, from), *b = mus__board_start(board, to);
    const double xy[4] = {a[0], a[1], b[0], b[1]};
    const int32_t kind = MUS__LINE;
    const int32_t panel = mus__board_cut(board, from, to, &(mus__board_path){1, &kind, 2, xy}, "front_strip",
                                         "strip");
    const int32_t strip = mus__board_find(board, panel, "strip");
    if (strip != MUS_NONE) mus__board_seam_drop(board, strip);
    return strip;
}


void mus__shaping_centre_gathers(mus__half *half, mus__top *top)
{
    mus__board *board = &half->board;
    const mus__bodice_half *front = &half->bodice.front;
    const int32_t strip = gather_strip(half, top);
    int32_t edge = mus__board_find(board, top->panel[MUS__TOP_FRONT], "strip");
    if (board->status != MUS_OK || strip == MUS_NONE || edge == MUS_NONE) return;
    const double length = board->side[edge].length, *head = mus__board_start(board, edge);

    /* the edge is walked down. A third each at the bust level, 2 and 4 cm below: the lowest first; the waist keeps its
     * place, all above turns away from the centre */
    const double step = 2.0 * top->scale * MUS__CM, first = fmin(head[1] - front->bust[1], length - 3.5 * step);
    const int32_t keep = mus__board_find(board, top->panel[MUS__TOP_FRONT], top->waist_darts[0] ? "w2" : "side1");
    if (keep == MUS_NONE || !(first > 0.5 * step)) {
        mus__board_seam_add(board, edge, strip, MUS_SEAM_REVERSED, 0.0);
        return;
    }
    for (int i = GATHER_PARTS - 1; i >= 0; i--) {
        const int32_t leg = mus__shaping_turn(half, top, edge, first + step * i, 1.0 / (i + 1), keep);
        if (leg == MUS_NONE) break;
        edge = mus__board_dart_release(board, leg);
    }
    if (board->status != MUS_OK) return;

    /* the gathers lie from 1 cm above the first place to as much below the last; beyond them, length for length */
    const double above = first - 0.5 * step, below = length - first - 2.5 * step;
    const int32_t low = mus__board_split(board, edge, board->side[edge].length - below, NULL);
    const int32_t middle = mus__board_split(board, edge, above, NULL);
    const int32_t strip_middle = mus__board_split(board, strip, below, NULL);
    const int32_t strip_high = mus__board_split(board, strip_middle, length - below - above, NULL);
    if (board->status != MUS_OK) return;
    mus__board_sew(board, 1, &edge, 1, &strip_high);
    mus__board_sew(board, 1, &middle, 1, &strip_middle);
    mus__board_sew(board, 1, &low, 1, &strip);
}
