/*
 * board_cut.c: panels cut apart along a chain, joined at a seam, removed.
 *
 * Cutting and joining change rings only. A cut from corner P to corner Q adds the chain to the ring that stays and, in
 * reverse, to the ring that goes,
 *
 *          from ... to                      stays: to ... from, chain P to Q
 *        P -------------- Q                 goes:  from ... to, chain Q to P
 *          \____chain____/
 *
 * so the two new sides are the same points, and joining them takes both out again.
 */
#include <math.h>
#include <string.h>

#include "board/board_cut.h"
#include "base/elementary.h"
#include "board/board_seam.h"
#include "geom/curve.h"
#include "geom/polygon.h"
#include "geom/vec.h"

#define CUT_CONGRUENT 1e-6 /* [m] largest distance between two sides that are joined; chosen: above rounding */
#define CUT_CHORDS 16      /* a curved piece, when a mark is looked for inside a panel */
#define CUT_SAMPLES 8      /* intervals along a side at whose ends congruence is tested */


/* every side of a ring belongs to `panel` */
static void cut_claim(mus__board *board, int32_t first, int32_t panel)
{
    int32_t side = first;
    do {
        board->side[side].panel = panel;
        side = board->side[side].next;
    } while (side != first);
}


/* is a point inside a panel, with its curves taken as chords? False when the board fails */
static bool cut_inside(mus__board *board, int32_t panel, const double *p)
{
    int64_t n = 0;
    const int32_t first = board->panel[panel].first;
    int32_t side = first;
    do {
        n += (int64_t)board->side[side].chain.npiece * CUT_CHORDS;
        side = board->side[side].next;
    } while (side != first);
    double *xy = mus__room(board->context, 2 * n, sizeof *xy);
    if (xy == NULL) {
        mus__board_fail(board, MUS_ERR_MEMORY, "no memory for the outline of a panel");
        return false;
    }

    int32_t at = 0;
    do {
        const mus__board_chain *chain = &board->side[side].chain;
        const double *q = chain->xy;
        for (int32_t i = 0; i < chain->npiece; i++) {
            const int32_t kind = chain->kinds[i], chords = kind == MUS_PIECE_LINE ? 1 : CUT_CHORDS;
            for (int32_t k = 0; k < chords; k++, at++) mus__curve_at(kind, q, (double)k / chords, xy + 2 * (size_t)at);
            q += 2 * (mus__curve_points(kind) - 1);
        }
        side = board->side[side].next;
    } while (side != first);
    const bool inside = mus__polygon_winding(at, xy, p) != 0;
    mus__free(board->context, xy);
    return inside;
}


/* give the marks whose mean point lies in the new panel to it */
static void cut_marks(mus__board *board, int32_t panel, int32_t made)
{
    for (int32_t i = 0; i < board->nmark && board->status == MUS_OK; i++) {
        mus__board_mark *mark = &board->mark[i];
        if (mark->panel != panel) continue;
        double middle[2] = {0.0, 0.0};
        for (int32_t k = 0; k < mark->n; k++)
            middle[0] += mark->xy[2 * k] / mark->n, middle[1] += mark->xy[2 * k + 1] / mark->n;
        if (cut_inside(board, made, middle)) mark->panel = made;
    }
}


/* the two new sides: *stays along the chain, *goes against it */
static void cut_sides(mus__board *board, int32_t panel, int32_t made, const int32_t *ends, mus__board_chain *chain,
                      const char *name, int32_t *stays, int32_t *goes)
{
    mus__board_chain turned;
    memcpy(chain->xy, mus__board_start(board, ends[0]), 2 * sizeof(double));
    memcpy(chain->xy + 2 * ((size_t)chain->nxy - 1), mus__board_start(board, ends[1]), 2 * sizeof(double));
    mus__board_chain_make(board, chain->npiece, chain->kinds, chain->nxy, chain->xy, &turned);
    if (turned.xy != NULL) mus__board_chain_reverse(&turned);
    *stays = mus__board_side_new(board, panel, chain);
    *goes = mus__board_side_new(board, made, &turned);
    if (board->status != MUS_OK) return;
    mus__board_rename(board, *stays, name, NULL);
    mus__board_rename(board, *goes, name, NULL);
    board->side[*stays].knot = board->side[ends[0]].knot;
    board->side[*goes].knot = board->side[ends[1]].knot;
}


int32_t mus__board_cut(mus__board *board, int32_t from, int32_t to, const mus__board_path *path, const char *name,
                       const char *seam_name)
{
    if (!mus__board_has_side(board, from) || !mus__board_has_side(board, to)) return MUS_NONE;
    const int32_t panel = board->side[from].panel, ends[2] = {from, to};
    if (board->side[to].panel != panel || from == to || board->side[from].next == MUS_NONE) {
        mus__board_fail(board, MUS_ERR_ARG, "cut of panel %s: sides %s and %s %s", board->panel[panel].name,
                        board->side[from].name, board->side[to].name,
                        from == to ? "are one" : "are not of one closed panel");
        return MUS_NONE;
    }
    mus__board_chain chain;
    mus__board_chain_make(board, path->npiece, path->kinds, path->nxy, path->xy, &chain);
    const int32_t made = mus__board_panel_add(board, name, board->panel[panel].attr.label);
    if (made == MUS_NONE) {
        mus__free(board->context, chain.xy);
        return MUS_NONE;
    }
    int32_t stays, goes;
    cut_sides(board, panel, made, ends, &chain, seam_name, &stays, &goes);
    if (board->status != MUS_OK) return MUS_NONE;
    if (!(board->side[stays].length > 0.0)) {
        mus__board_fail(board, MUS_ERR_ARG, "cut of panel %s: its length is 0 m", board->panel[panel].name);
        return MUS_NONE;
    }

    /* the new panel has the attributes of the old one */
    mus__board_part_twins(board, panel);
    mus__board_panel *own = &board->panel[panel], *other = &board->panel[made];
    other->attr = own->attr;
    other->single = own->single;
    other->first = from;

    /* two rings */
    const int32_t before_from = board->side[from].prev, before_to = board->side[to].prev;
    mus__board_follow(board, before_to, goes);
    mus__board_follow(board, goes, from);
    mus__board_follow(board, before_from, stays);
    mus__board_follow(board, stays, to);
    cut_claim(board, goes, made);
    if (board->side[own->first].panel != panel) own->first = to;
    mus__board_seam_add(board, stays, goes, MUS_SEAM_REVERSED, 0.0);
    cut_marks(board, panel, made);
    return board->status == MUS_OK ? made : MUS_NONE;
}


/* ---- moving ---- */

/* all points of a panel: its sides, its marks and the direction of its grain */
static void cut_move(mus__board *board, int32_t panel, const double *map)
{
    for (int32_t i = 0; i < board->nside; i++)
        if (board->side[i].panel == panel) mus__board_chain_move(&board->side[i].chain, map);
    for (int32_t i = 0; i < board->nmark; i++) {
        const mus__board_mark *mark = &board->mark[i];
        if (mark->panel != panel) continue;
        mus__board_chain points = {.nxy = mark->n, .xy = mark->xy};
        mus__board_chain_move(&points, map);
    }
    double *grain = board->panel[panel].attr.grain;
    const double x = grain[0], y = grain[1], gx = map[0] * x + map[1] * y, gy = map[3] * x + map[4] * y;
    const double norm = mus__hypot(gx, gy);
    grain[0] = gx / norm, grain[1] = gy / norm;
}


/* p' = centre + R (p - centre) + shift, as a map of the plane */
static void cut_map(const double *centre, double c, double s, const double *shift, double *map)
{
    const double own[6] = {c, -s, shift[0] + (centre[0] - (c * centre[0] - s * centre[1])),
                           s, c,  shift[1] + (centre[1] - (s * centre[0] + c * centre[1]))};
    memcpy(map, own, sizeof own);
}


/* ---- together ---- */

/* does side b, walked backwards, lie on side a? */
static bool cut_lies_on(const mus__board *board, int32_t a, int32_t b)
{
    const double la = board->side[a].length, lb = board->side[b].length;
    if (fabs(la - lb) > CUT_CONGRUENT) return false;
    for (int32_t i = 0; i <= CUT_SAMPLES; i++) {
        const double t = (double)i / CUT_SAMPLES;
        double p[2], q[2];
        mus__board_at(board, a, t * la, p, NULL);
        mus__board_at(board, b, i == 0 ? lb : (1.0 - t) * lb, q, NULL);
        if (mus__dist2(p, q) > CUT_CONGRUENT) return false;
    }
    return true;
}


/* the motion that takes side b, walked backwards, onto side a: chords u = a, v = -b; c, s of the angle from v to u */
static bool cut_onto(const mus__board *board, int32_t a, int32_t b, double *map)
{
    const double *p = mus__board_start(board, a), *p1 = mus__board_end(board, a);
    const double *q = mus__board_end(board, b), *q1 = mus__board_start(board, b);
    const double u[2] = {p1[0] - p[0], p1[1] - p[1]}, v[2] = {q1[0] - q[0], q1[1] - q[1]};
    const double dot = u[0] * v[0] + u[1] * v[1], cross = v[0] * u[1] - v[1] * u[0], norm = mus__hypot(dot, cross);
    if (!(norm > 0.0)) return false;
    const double shift[2] = {p[0] - q[0], p[1] - q[1]};
    cut_map(q, dot / norm, cross / norm, shift, map);
    return true;
}


/* remove both sides of a seam and link the rings: prev(a) to next(b), prev(b) to next(a) */
static void cut_tie(mus__board *board, int32_t a, int32_t b)
{
    const int32_t before_a = board->side[a].prev, after_a = board->side[a].next;
    const int32_t before_b = board->side[b].prev, after_b = board->side[b].next;
    double corner[2][2];
    memcpy(corner[0], mus__board_start(board, a), sizeof corner[0]);
    memcpy(corner[1], mus__board_end(board, a), sizeof corner[1]);
    mus__board_side *side = board->side;

    /* corners are those of a */
    if (before_a != b) {
        side[before_a].next = after_b;
        side[after_b].prev = before_a;
        memcpy(side[after_b].chain.xy, corner[0], sizeof corner[0]);
        side[after_b].knot = side[a].knot;
    }
    if (before_b != a) {
        side[before_b].next = after_a;
        side[after_a].prev = before_b;
        memcpy(side[before_b].chain.xy + 2 * ((size_t)side[before_b].chain.nxy - 1), corner[1], sizeof corner[1]);
    }
    mus__board_side_remove(board, a);
    mus__board_side_remove(board, b);
}


/* remove pairs of consecutive sides that are sewn to one another and lie on each other: there the cloth is whole */
static void cut_zip(mus__board *board, int32_t side)
{
    while (side != MUS_NONE) {
        const int32_t next = board->side[side].next, seam = mus__board_seam_of(board, side);
        if (seam == MUS_NONE || next == side || board->side[next].next == side) return;
        if (mus__board_partner(board, side) != next || board->seam[seam].direction != MUS_SEAM_REVERSED) return;
        if (!cut_lies_on(board, side, next)) return;
        const int32_t before = board->side[side].prev;
        cut_tie(board, side, next);
        side = before;
    }
}


void mus__board_join(mus__board *board, int32_t side)
{
    if (!mus__board_has_side(board, side)) return;
    const int32_t seam = mus__board_seam_of(board, side), other = mus__board_partner(board, side);
    const int32_t panel = board->side[side].panel, from = other != MUS_NONE ? board->side[other].panel : panel;
    double map[6];
    if (from == panel || board->seam[seam].direction != MUS_SEAM_REVERSED || !cut_onto(board, side, other, map)) {
        mus__board_fail(board, MUS_ERR_PATTERN, "side %s of panel %s is not sewn to another panel, right sides out",
                        board->side[side].name, board->panel[panel].name);
        return;
    }
    const bool moved = map[0] != 1.0 || map[1] != 0.0 || map[2] != 0.0 || map[5] != 0.0;
    if (moved) cut_move(board, from, map);
    if (!cut_lies_on(board, side, other)) {
        mus__board_fail(board, MUS_ERR_PATTERN, "side %s of panel %s and side %s of panel %s are not congruent",
                        board->side[side].name, board->panel[panel].name, board->side[other].name,
                        board->panel[from].name);
        return;
    }

    /* one ring, one panel */
    mus__board_part_twins(board, panel);
    mus__board_part_twins(board, from);
    const int32_t before[2] = {board->side[side].prev, board->side[other].prev};
    cut_claim(board, other, panel);
    for (int32_t i = 0; i < board->nmark; i++)
        if (board->mark[i].panel == from) board->mark[i].panel = panel;
    board->panel[from].first = MUS_NONE;
    board->panel[from].name[0] = '\0';
    cut_tie(board, side, other);
    for (int32_t i = 0; i < 2; i++)
        if (board->side[before[i]].panel == panel) cut_zip(board, before[i]);
    /* the word begins at the same side as before, if it is still there */
    for (int32_t i = 0; i < board->nside && board->side[board->panel[panel].first].panel != panel; i++)
        if (board->side[i].panel == panel) board->panel[panel].first = i;
}


void mus__board_remove_panel(mus__board *board, int32_t panel)
{
    if (!mus__board_has_panel(board, panel)) return;
    mus__board_part_twins(board, panel);
    for (int32_t i = 0; i < board->nside; i++)
        if (board->side[i].panel == panel) mus__board_side_remove(board, i);
    for (int32_t i = 0; i < board->nmark; i++)
        if (board->mark[i].panel == panel) board->mark[i].panel = MUS_NONE;
    board->panel[panel].first = MUS_NONE;
    board->panel[panel].name[0] = '\0';
}
