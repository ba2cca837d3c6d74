/*
 * shaping_cut.c: panels of a bodice cut apart: princess lines from shoulder or armhole, empire line, yoke.
 *
 * A princess seam takes up bust dart and waist dart. In front the bust dart is rotated to the seam's upper end
 * (shoulder or armhole), and the panel is cut from its point to the lower edge. The edges of both panels are then drawn
 * again as one curve above the bust point and one below it, with one tangent there. Their lengths differ by
 * millimetres, which is the ease of the seam. Behind, the seam runs through the waist dart.
 */
#include <math.h>
#include <string.h>

#include "base/elementary.h"
#include "board/board_spread.h"
#include "geom/curve.h"
#include "geom/vec.h"
#include "style/bodice.h"

/* the edge of one panel at a princess seam, from the upper end over the bust point to the lower edge */
typedef struct princess_line {
    double head[2], point[2]; /* upper end; bust point, behind the upper point of the waist dart */
    double axis;              /* x of the waist dart's axis [m] */
    double wide;              /* half the width of the waist dart [m]; < 0: the edge on the side of the centre */
} princess_line;


/* Writes the unit tangent at the bust point: the mean of the direction from the upper end and of straight down. */
static void princess_tangent(const princess_line *line, double *out)
{
    const double length = mus__dist2(line->head, line->point);
    out[0] = 0.5 * (line->point[0] - line->head[0]) / length;
    out[1] = 0.5 * ((line->point[1] - line->head[1]) / length - 1.0);
    const double norm = sqrt(out[0] * out[0] + out[1] * out[1]);
    out[0] /= norm, out[1] /= norm;
}


/* Writes the part of the edge from the upper end to the bust point. */
static void princess_high(const princess_line *line, mus__chain *out)
{
    double along[2];
    const double *h = line->head, *p = line->point, reach = 0.33 * mus__dist2(h, p);
    princess_tangent(line, along);
    out->npiece = 0;
    mus__chain_add_cubic(out, h, h[0] + 0.33 * (p[0] - h[0]), h[1] + 0.33 * (p[1] - h[1]), p[0] - reach * along[0],
               p[1] - reach * along[1], p);
}


/* Writes the part of the edge from the bust point to the lower edge: to the waist, then as the leg of a waist dart
 * closes towards the hip, then straight down. */
static void princess_low(const mus__top *top, const princess_line *line, mus__chain *out)
{
    double along[2];
    const double *p = line->point, narrow = line->wide < 0.0 ? fmax(line->wide, -1.5e-3) : fmin(line->wide, 1.5e-3);
    const double waist[2] = {line->axis + line->wide, 0.0}, reach = 0.33 * p[1];
    princess_tangent(line, along);
    out->npiece = 0;
    if (top->hem > 0.0) {
        const double part = 1.0 - top->hem / p[1], end[2] = {line->axis + line->wide * part, top->hem};
        mus__chain_add_cubic(out, p, p[0] + reach * part * along[0], p[1] + reach * part * along[1], end[0],
                   end[1] + reach * part, end);
        return;
    }
    mus__chain_add_cubic(out, p, p[0] + reach * along[0], p[1] + reach * along[1], waist[0], reach, waist);
    if (!(top->hem < 0.0)) return;

    const double level = fmax(top->hem, 0.8 * top->hip), part = level / (0.8 * top->hip);
    const double hip[2] = {line->axis + line->wide + part * (narrow - line->wide), level};
    mus__chain_add_cubic(out, waist, waist[0], 0.4 * level, hip[0], 0.6 * level, hip);
    if (!(top->hem < level - 0.01)) return;
    const double end[2] = {hip[0], top->hem};
    mus__chain_add_line(out, hip, end);
}


static void princess_whole(const mus__top *top, const princess_line *line, mus__chain *out)
{
    mus__chain low;
    princess_high(line, out);
    princess_low(top, line, &low);
    mus__chain_append(out, &low);
}


/* Replaces the curve of a half-edge by `chain`, which runs downwards, in the direction of the half-edge. */
static void princess_redraw(mus__board *board, int32_t side, const mus__chain *chain)
{
    if (board->status != MUS_OK || side == MUS_NONE) return;
    mus__chain own = *chain;
    const double *start = mus__board_start(board, side), *end = mus__board_end(board, side);
    if (start[1] < end[1]) mus__chain_reverse(&own);
    mus__board_redraw(board, side, own.npiece, own.kinds, own.nxy, own.xy);
}


/* Sets the ease of a half-edge's seam to the present difference of length. */
static void princess_ease(mus__board *board, int32_t side)
{
    if (board->status != MUS_OK || side == MUS_NONE) return;
    const int32_t seam = mus__board_seam_of(board, side);
    if (seam == MUS_NONE) return;
    mus__board_seam *own = &board->seam[seam];
    own->ease = board->side[own->b].length - board->side[own->a].length;
}


/* Draws both sides of a princess seam again: `centre` of the panel at the centre line, and its partner. */
static void princess_pair(mus__board *board, int32_t centre, const mus__chain *chain, const mus__chain *other)
{
    if (board->status != MUS_OK || centre == MUS_NONE) return;
    const int32_t partner = mus__board_partner(board, centre);
    princess_redraw(board, centre, chain);
    princess_redraw(board, partner, other);
    princess_ease(board, centre);
}


/* If panel `panel` has half-edge `side`, names it `name`, and the panel that has had this name `rest`. */
static void princess_names(mus__board *board, int32_t side, int32_t panel, const char *name, const char *rest)
{
    if (board->status != MUS_OK || panel == MUS_NONE || board->side[side].panel != panel) return;
    for (int32_t p = 0; p < board->npanel; p++)
        if (strcmp(board->panel[p].name, name) == 0) memcpy(board->panel[p].name, rest, strlen(rest) + 1);
    memcpy(board->panel[panel].name, name, strlen(name) + 1);
}


/* ---- princess ---- */

/* Cuts a panel from the start of half-edge `from` over `point` to the start of `to`: the back, and a front without a
 * bust dart. Returns the new panel, called `name`. */
static int32_t princess_through(mus__board *board, int32_t from, int32_t to, const double *point, const char *name)
{
    if (board->status != MUS_OK || from == MUS_NONE || to == MUS_NONE) return MUS_NONE;
    const double *a = mus__board_start(board, from), *b = mus__board_start(board, to);
    const double xy[6] = {a[0], a[1], point[0], point[1], b[0], b[1]};
    const int32_t kinds[2] = {MUS__LINE, MUS__LINE};
    const int32_t panel = mus__board_cut(board, from, to, &(mus__board_path){2, kinds, 3, xy}, name, "princess");
    return panel;
}


/* The princess seam of the back: from the middle of the shoulder, or the pitch point of the armhole, over the upper
 * point of the waist dart to the lower edge. x <= 0 on the back's panel. */
static void princess_back(mus__half *half, mus__top *top, bool armhole)
{
    mus__board *board = &half->board;
    const mus__bodice_half *back = &half->bodice.back;
    const double axis = half->measures.v[MUS_MEASURE_ACROSS_BACK] / 4.0 + 0.5 * MUS__CM;
    const double wide = top->darts ? 0.5 * half->bodice.dart_width : 0.0;
    const int32_t upper = mus__shaping_side(half, top, MUS__TOP_BACK, armhole ? "arm" : "sh");
    const int32_t low = mus__shaping_side(half, top, MUS__TOP_BACK, "low");
    if (board->status != MUS_OK || upper == MUS_NONE || low == MUS_NONE) return;

    /* upper and lower end of the seam; the lower edge runs from the side to the centre */
    const double s = armhole ? back->arm_length - back->arm_low_length : 0.5 * board->side[upper].length;
    const int32_t from = mus__board_split(board, upper, s, NULL);
    const int32_t to = mus__board_split(board, low, board->side[low].length - axis, NULL);
    const double under = half->bodice.underarm, high = under - 2.0 * top->scale * MUS__CM;
    const double point[2] = {-axis, fmax(high, 0.5 * (under + top->hem))};
    const int32_t side = mus__board_find(board, top->panel[MUS__TOP_BACK], "cb");
    const int32_t panel = princess_through(board, from, to, point, "back_side");
    princess_names(board, side, panel, "back", "back_side");
    if (board->status != MUS_OK) return;
    top->panel[MUS__TOP_BACK] = board->side[side].panel;

    /* draw both edges: that of the centre panel lies half a dart towards the centre (x > axis), the other half a dart
     * towards the side */
    const int32_t seam = mus__board_find(board, top->panel[MUS__TOP_BACK], "princess");
    if (seam == MUS_NONE) return;
    mus__chain chain[2];
    for (int i = 0; i < 2; i++) {
        princess_line line = {.axis = -axis, .wide = i == 0 ? wide : -wide};
        memcpy(line.head, mus__board_start(board, from), sizeof line.head);
        memcpy(line.point, point, sizeof point);
        princess_whole(top, &line, &chain[i]);
    }
    princess_pair(board, seam, &chain[0], &chain[1]);
}


/* The princess seam of a front without a bust dart, cut as that of the back. */
static void princess_front_flat(mus__half *half, mus__top *top, int32_t upper, int32_t low, bool armhole)
{
    mus__board *board = &half->board;
    const mus__bodice_half *front = &half->bodice.front;
    const double s = armhole ? front->arm_low_length : 0.5 * board->side[upper].length;
    const double wide = top->darts ? 0.5 * half->bodice.dart_width : 0.0;
    const double axis = fmax(front->bust[0], fmin(front->snp[0] + 1.5 * top->scale * MUS__CM, 0.6 * front->under[0]));
    const double point[2] = {axis, front->bust[1]};
    const int32_t from = mus__board_split(board, low, axis, NULL);
    const int32_t to = mus__board_split(board, upper, s, NULL);
    const int32_t side = mus__board_find(board, top->panel[MUS__TOP_FRONT], "cf");
    const int32_t panel = princess_through(board, from, to, point, "front_side");
    princess_names(board, side, panel, "front", "front_side");
    if (board->status != MUS_OK) return;
    top->panel[MUS__TOP_FRONT] = board->side[side].panel;
    const int32_t seam = mus__board_find(board, top->panel[MUS__TOP_FRONT], "princess");
    if (seam == MUS_NONE) return;
    mus__chain chain[2];
    for (int i = 0; i < 2; i++) {
        princess_line line = {.axis = axis, .wide = i == 0 ? -wide : wide};
        memcpy(line.head, mus__board_start(board, to), sizeof line.head);
        memcpy(line.point, point, sizeof point);
        princess_whole(top, &line, &chain[i]);
    }
    princess_pair(board, seam, &chain[0], &chain[1]);
}


/* The princess seam of the front: the bust dart is rotated to the seam's upper end, and its point is joined to the
 * lower edge. */
static void princess_front(mus__half *half, mus__top *top, bool armhole)
{
    mus__board *board = &half->board;
    const mus__bodice_half *front = &half->bodice.front;
    const int32_t upper = mus__shaping_side(half, top, MUS__TOP_FRONT, armhole ? "arm" : "sh");
    const int32_t low = mus__shaping_side(half, top, MUS__TOP_FRONT, "low");
    const int32_t cf = mus__shaping_side(half, top, MUS__TOP_FRONT, "cf");
    if (board->status != MUS_OK || upper == MUS_NONE || low == MUS_NONE) return;
    const double s = armhole ? fmin(front->arm_low_length, 0.6 * board->side[upper].length)
                             : 0.5 * board->side[upper].length;
    const int32_t leg = mus__shaping_turn(half, top, upper, s, 1.0, cf);
    if (leg == MUS_NONE) {
        princess_front_flat(half, top, upper, low, armhole);
        return;
    }
    const double wide = top->darts ? 0.5 * half->bodice.dart_width : 0.0;
    const int32_t to = mus__board_split(board, low, front->bust[0], NULL);
    if (board->status != MUS_OK) return;
    const double *foot = mus__board_start(board, to);
    const double down[4] = {front->bust[0], front->bust[1], foot[0], foot[1]};
    const int32_t kind = MUS__LINE;
    const int32_t panel = mus__board_dart_to_seam(board, leg, to, &(mus__board_path){1, &kind, 2, down},
                                                  "front_side", "princess");
    princess_names(board, cf, panel, "front", "front_side");
    if (board->status != MUS_OK) return;
    top->panel[MUS__TOP_FRONT] = board->side[cf].panel;

    /* draw both edges, each from its own upper end: the dart has opened between the two */
    const int32_t seam = mus__board_find(board, top->panel[MUS__TOP_FRONT], "princess");
    if (seam == MUS_NONE) return;
    mus__chain chain[2];
    for (int i = 0; i < 2; i++) {
        const int32_t own = i == 0 ? seam : mus__board_partner(board, seam);
        const double *a = mus__board_start(board, own), *b = mus__board_end(board, own);
        princess_line line = {.axis = front->bust[0], .wide = i == 0 ? -wide : wide};
        memcpy(line.head, a[1] > b[1] ? a : b, sizeof line.head);
        memcpy(line.point, front->bust, sizeof line.point);
        princess_whole(top, &line, &chain[i]);
    }
    princess_pair(board, seam, &chain[0], &chain[1]);
}


void mus__shaping_princess(mus__half *half, mus__top *top, bool armhole)
{
    princess_front(half, top, armhole);
    princess_back(half, top, armhole);
}


/* ---- empire ---- */

/* Closes the waist dart of the panel below an empire line at height `level` [m]: the panel is cut along the dart's
 * axis, both edges are drawn as the dart's legs, and the two parts are joined again. */
static void princess_midriff(mus__half *half, mus__top *top, int32_t panel, double level)
{
    mus__board *board = &half->board;
    const double axis = half->bodice.front.bust[0], bust = half->bodice.front.bust[1];
    const double wide = 0.5 * half->bodice.dart_width;
    const bool alone = mus__style_is(half, MUS__AXIS_GARMENT, MUS__GARMENT_TOP);
    const int32_t low = mus__board_find(board, panel, alone ? "hem" : "waist");
    const int32_t high = mus__board_find(board, panel, "empire");
    if (board->status != MUS_OK || low == MUS_NONE || high == MUS_NONE) return;

    /* the upper edge runs from the side to the centre, the lower edge from the centre to the side */
    const int32_t from = mus__board_split(board, low, axis, NULL);
    const int32_t to = mus__board_split(board, high, board->side[high].length - axis, NULL);
    if (board->status != MUS_OK) return;
    const double *a = mus__board_start(board, from), *b = mus__board_start(board, to);
    const double xy[4] = {a[0], a[1], b[0], b[1]};
    const int32_t kind = MUS__LINE;
    mus__board_cut(board, from, to, &(mus__board_path){1, &kind, 2, xy}, "front_low_side", "closed");
    const int32_t inner = mus__board_find(board, panel, "closed");
    if (board->status != MUS_OK || inner == MUS_NONE) return;
    const int32_t outer = mus__board_partner(board, inner);
    mus__chain chain[2];
    for (int i = 0; i < 2; i++) {
        const double turn = i == 0 ? -wide : wide, above = 1.0 - level / bust, below = 1.0 - top->hem / bust;
        const double head[2] = {axis + turn * above, level}, foot[2] = {axis + turn * below, top->hem};
        mus__chain_line(&chain[i], head, foot);
    }
    princess_redraw(board, inner, &chain[0]);
    princess_redraw(board, outer, &chain[1]);
    mus__board_join(board, inner);
}


void mus__shaping_empire(mus__half *half, mus__top *top)
{
    /* height of the line: 0.06 of the stature below the bust point, at least 3 cm above the lower edge, at most 1 cm
     * below the bust dart's mouth */
    mus__board *board = &half->board;
    const mus__bodice_half *front = &half->bodice.front;
    const double cm = top->scale * MUS__CM;
    double level = front->bust[1] - 0.06 * half->measures.v[MUS_MEASURE_STATURE];
    level = fmax(level, top->hem + 3.0 * cm);
    const int32_t dart = mus__shaping_side(half, top, MUS__TOP_FRONT, "bd1");
    const int32_t side = mus__shaping_side(half, top, MUS__TOP_FRONT, dart != MUS_NONE ? "side1" : "side");
    const int32_t cf = mus__shaping_side(half, top, MUS__TOP_FRONT, "cf");
    if (board->status != MUS_OK || side == MUS_NONE || cf == MUS_NONE) return;
    const double *end = mus__board_end(board, side), *neck = mus__board_start(board, cf);
    level = fmin(level, end[1] - 1.0 * cm);
    const double steep = 1.0 / mus__cos(mus__atan2(top->side_in, half->bodice.underarm));
    const double at = board->side[side].length - (end[1] - level) * steep;
    const int32_t upper = mus__board_split(board, side, at, NULL);
    const int32_t from = mus__board_split(board, cf, neck[1] - level, NULL);
    if (board->status != MUS_OK) return;
    const double *a = mus__board_start(board, from), *b = mus__board_start(board, upper);
    const double xy[4] = {a[0], a[1], b[0], b[1]};
    const int32_t kind = MUS__LINE;
    const int32_t low = mus__board_cut(board, from, upper, &(mus__board_path){1, &kind, 2, xy}, "front_low",
                                       "empire");
    const int32_t edge = mus__board_find(board, top->panel[MUS__TOP_FRONT], "empire");
    const int32_t under = mus__board_find(board, low, "empire");
    if (board->status != MUS_OK || edge == MUS_NONE || under == MUS_NONE) return;

    /* the waist dart: above the line it becomes a dart of its own; below it is closed when the top ends at the waist or
     * above, and else left as ease */
    const double wide = half->bodice.dart_width * (1.0 - level / front->bust[1]);
    if (!top->darts || !(wide > 2e-3)) return;
    mus__board_rename(board, edge, "empire", "empire");
    mus__board_rename(board, under, "empire", "empire");
    mus__board_seam_drop(board, edge);
    const double point[2] = {front->bust[0], fmax(front->bust[1] - 2.0 * MUS__CM, level + 1.0 * MUS__CM)};
    mus__board_dart_add(board, edge, front->bust[0], wide, point);
    if (top->hem >= 0.0) princess_midriff(half, top, low, level);
    int32_t above[MUS__TOP_RUN], below[MUS__TOP_RUN];
    const int32_t nabove = mus__board_run(board, top->panel[MUS__TOP_FRONT], "empire", above, MUS__TOP_RUN);
    const int32_t nbelow = mus__board_run(board, low, "empire", below, MUS__TOP_RUN);
    if (nabove > 0 && nbelow > 0) mus__board_sew(board, nabove, above, nbelow, below);
}
