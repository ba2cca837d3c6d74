/*
 * edit_point.c: the edits of points and edges (muslin/edit.h): moved, drawn again, split, merged. A program in which a
 * point is dragged on a screen makes one of these calls for each place of the pointer.
 */
#include "board/board_rigid_part.h"
#include "board/board_seam.h"
#include "board/board_smooth.h"
#include "board/board_spread.h"
#include "edit/edit_internal.h"
#include "geom/curve.h"


/* the board fails when (x, y) is not within MUS__FARTHEST */
static bool edit_near(mus__board *board, const char *what, int32_t index, double x, double y)
{
    const double to[2] = {x, y};
    if (board->status == MUS_OK)
        board->status = mus__check_near(board->context, 1, 2, to, "move %s %d", what, (int)index);
    return board->status == MUS_OK;
}


mus_status mus_pattern_move_point(mus_pattern *pattern, int32_t point, double x, double y)
{
    mus__editing e;
    mus_status status = mus__edit_begin(&e, pattern);
    if (status != MUS_OK) return status;
    mus__board *board = &e.board;
    const double to[2] = {x, y};
    board->status = mus__pattern_known(pattern, "point", point, pattern->npoint);
    bool found = false;
    const int32_t n = board->nside;
    for (int32_t i = 0; i < n && edit_near(board, "point", point, x, y); i++) {
        if (board->side[i].knot != point) continue;
        const int32_t before = board->side[i].prev;
        if (!found) mus__board_part_twins(board, board->side[i].panel);
        found = true;
        mus__board_part_move_end(board, i, false, to);
        mus__board_part_move_end(board, before, true, to);
    }
    if (board->status == MUS_OK && !found)
        mus__board_fail(board, MUS_ERR_ARG, "move point %d: it is on no outline", (int)point);
    return mus__edit_end(&e, 0, NULL, NULL);
}


/* the point nearest to (x, y) on the bisector of the chord of an arc p (3 x 2): equally far from both ends */
static void edit_arc_middle(const double *p, double x, double y, double *out)
{
    const double middle[2] = {0.5 * (p[0] + p[4]), 0.5 * (p[1] + p[5])};
    const double n[2] = {p[1] - p[5], p[4] - p[0]}, n2 = n[0] * n[0] + n[1] * n[1];
    const double t = n2 > 0.0 ? ((x - middle[0]) * n[0] + (y - middle[1]) * n[1]) / n2 : 0.0;
    out[0] = n2 > 0.0 ? middle[0] + t * n[0] : x;
    out[1] = n2 > 0.0 ? middle[1] + t * n[1] : y;
}


/* move point `index` of a chain to (x, y); a joint moves the control points on both sides along */
static void edit_move_inner(mus__board_chain *chain, int32_t index, double x, double y)
{
    double *p = chain->xy, *at = chain->xy + 2 * (size_t)index;
    const double step[2] = {x - at[0], y - at[1]};
    for (int32_t i = 0, first = 0; i < chain->npiece; i++) {
        const int32_t kind = chain->kinds[i], last = first + mus__curve_points(kind) - 1;
        const bool starts = index == first, ends = index == last;
        if (index > first && index < last && kind == MUS__ARC) {
            edit_arc_middle(p, x, y, at);
        } else if (index > first && index < last) {
            at[0] = x, at[1] = y;
        } else if (starts || ends) {
            double *end = p + 2 * (size_t)(last - first), chord[2] = {end[0] - p[0], end[1] - p[1]};
            const double moved[2] = {chord[0] + (ends ? step[0] : -step[0]), chord[1] + (ends ? step[1] : -step[1])};
            double *hold = ends ? end - 2 : p + 2;
            for (int k = 0; k < 2 && kind != MUS__LINE && kind != MUS__ARC; k++)
                hold[k] += (kind == MUS__CUBIC ? 1.0 : 0.5) * step[k];
            if (kind == MUS__ARC) {
                /* its start is where it was still when it ends here, and where it goes when it starts here */
                const double start[2] = {p[0] + (starts ? step[0] : 0.0), p[1] + (starts ? step[1] : 0.0)};
                double from[2] = {p[2] - p[0], p[3] - p[1]};
                mus__board_arc_follow(chord, from, moved);
                p[2] = start[0] + from[0], p[3] = start[1] + from[1];
            }
        }
        p += 2 * (size_t)(last - first);
        first = last;
    }
    at = chain->xy + 2 * (size_t)index;
    bool joint = false;
    for (int32_t i = 0, first = 0; i < chain->npiece; i++) {
        joint = joint || index == first;
        first += mus__curve_points(chain->kinds[i]) - 1;
    }
    if (joint) at[0] = x, at[1] = y;
}


mus_status mus_pattern_move_control(mus_pattern *pattern, int32_t edge, int32_t index, double x, double y)
{
    mus__editing e;
    mus_status status = mus__edit_begin(&e, pattern);
    if (status != MUS_OK) return status;
    mus__board *board = &e.board;
    const int32_t at = mus__edit_side(&e, edge);
    if (at != MUS_NONE && edit_near(board, "control", index, x, y)) {
        mus__board_side *side = &board->side[at];
        const int32_t n = side->chain.nxy;
        if (index < 1 || index > n - 2) {
            mus__board_fail(board, MUS_ERR_ARG, "move control %d of side %s: it has 1 to %d", (int)index, side->name,
                            (int)n - 2);
        } else {
            mus__board_part_twins(board, side->panel);
            edit_move_inner(&side->chain, side->backward ? n - 1 - index : index, x, y);
            mus__board_part_changed(board, at);
        }
    }
    return mus__edit_end(&e, 0, NULL, NULL);
}


mus_status mus_pattern_redraw_edge(mus_pattern *pattern, int32_t edge, int32_t npiece, const int32_t *kinds,
                                   int32_t nxy, const double *xy)
{
    mus__editing e;
    mus_status status = mus__edit_begin(&e, pattern);
    if (status != MUS_OK) return status;
    mus__board *board = &e.board;
    const int32_t side = mus__edit_side(&e, edge);
    if (side != MUS_NONE) {
        /* in the direction of the edge, then of the outline */
        const bool backward = board->side[side].backward;
        const double *start = mus__board_start(board, side), *end = mus__board_end(board, side);
        double *all = mus__edit_chain(&e, backward ? end : start, backward ? start : end, npiece, kinds, nxy, xy);
        const int32_t line = MUS_PIECE_LINE;
        mus__board_chain chain = {0};
        if (all != NULL)
            mus__board_chain_make(board, npiece > 0 ? npiece : 1, npiece > 0 ? kinds : &line, nxy + 2, all, &chain);
        mus__free(board->context, all);
        if (board->status == MUS_OK && backward) mus__board_chain_reverse(&chain);
        if (board->status == MUS_OK) mus__board_redraw(board, side, chain.npiece, chain.kinds, chain.nxy, chain.xy);
        mus__free(board->context, chain.xy);
    }
    return mus__edit_end(&e, 0, NULL, NULL);
}


mus_status mus_pattern_fair_edge(mus_pattern *pattern, int32_t edge, double within)
{
    mus__editing e;
    mus_status status = mus__edit_begin(&e, pattern);
    if (status != MUS_OK) return status;
    mus__board_fair(&e.board, mus__edit_side(&e, edge), within);
    return mus__edit_end(&e, 0, NULL, NULL);
}


mus_status mus_pattern_split_edge(mus_pattern *pattern, int32_t edge, double s, const char *name, int32_t *out)
{
    if (out != NULL) *out = MUS_NONE;
    mus__editing e;
    double at;
    mus_status status = mus__edit_begin(&e, pattern);
    if (status != MUS_OK) return status;
    const int32_t side = mus__edit_place(&e, edge, s, &at), made = mus__board_split(&e.board, side, at, name);
    return mus__edit_end(&e, 1, &made, &out);
}


mus_status mus_pattern_merge_edges(mus_pattern *pattern, int32_t edge, int32_t *out)
{
    if (out != NULL) *out = MUS_NONE;
    mus__editing e;
    mus_status status = mus__edit_begin(&e, pattern);
    if (status != MUS_OK) return status;
    const int32_t side = mus__edit_side(&e, edge);
    if (side != MUS_NONE && e.board.side[side].next == side)
        mus__board_fail(&e.board, MUS_ERR_ARG, "side %s is the whole outline", e.board.side[side].name);
    mus__board_merge(&e.board, side);
    return mus__edit_end(&e, 1, &side, &out);
}
