/*
 * edit_seam.c: seams walked, trued and notched (muslin/edit.h).
 *
 * Walking compares two sides at their notches: with lengths a and b, place s of one lies on s b / a of the other
 * (counted from its end when the seam is reversed); ease is spread evenly. Truing moves one end of a side along the
 * tangent there by d until its length is the wanted one. Moving an end by d changes the length by about d, so the step
 * d += wanted - length(d) converges fast.
 */
#include <math.h>

#include "base/elementary.h"
#include "board/board_notch.h"
#include "board/board_rigid_part.h"
#include "edit/edit_internal.h"
#include "geom/vec.h"

#define TRUE_STEPS 100
#define TRUE_ENOUGH 1e-12 /* [m] error of a trued length at which the iteration ends: rounding */
#define WALK_END 1e-6     /* [m] a notch this near to the end of its side is at the end; above rounding */
#define WALK_NOTCHES 64


void mus_seam_walk_init(mus_seam_walk *walk, size_t size)
{
    mus_seam_walk own = {0};
    mus__def_init(walk, size, &own, sizeof own);
}


/* the angle of the cloth at the start of a side [rad] */
static double walk_corner(const mus__board *board, int32_t side)
{
    const int32_t before = board->side[side].prev;
    double p[2], u[2], v[2], turn = mus__board_area(board, board->side[side].panel) < 0.0 ? -1.0 : 1.0;
    mus__board_at(board, before, board->side[before].length, p, u);
    mus__board_at(board, side, 0.0, p, v);
    return MUS_PI - turn * mus__atan2(u[0] * v[1] - u[1] * v[0], u[0] * v[0] + u[1] * v[1]);
}


/* arc lengths of the notches on a side, ascending, from its end when `turned`, without those at an end, which stand for
 * a joint of the sides that are sewn to it. Returns their number, at most WALK_NOTCHES */
static int32_t walk_notches(const mus__board *board, int32_t side, bool turned, double *s)
{
    int32_t n = 0;
    for (int32_t i = 0; i < board->nnotch && n < WALK_NOTCHES; i++) {
        if (board->notch[i].side != side || board->notch[i].s < WALK_END ||
            board->notch[i].s > board->side[side].length - WALK_END)
            continue;
        const double at = turned ? board->side[side].length - board->notch[i].s : board->notch[i].s;
        int32_t j = n++;
        for (; j > 0 && s[j - 1] > at; j--) s[j] = s[j - 1];
        s[j] = at;
    }
    return n;
}


mus_status mus_pattern_walk_seam(const mus_pattern *pattern, int32_t seam, mus_seam_walk *out)
{
    if (pattern == NULL) return MUS_ERR_ARG;
    if (out == NULL) return mus__fail(pattern->context, MUS_ERR_ARG, "walk of a seam: out is NULL");
    mus_status status = mus__pattern_known(pattern, "seam", seam, pattern->nseam);
    if (status != MUS_OK) return status;
    mus__board board;
    mus__board_read(&board, pattern);
    mus_seam_walk own = {.size = sizeof own};
    if (board.status == MUS_OK) {
        const mus__board_seam *s = &board.seam[seam];
        const mus__board_side *a = &board.side[s->a], *b = &board.side[s->b];
        const bool reversed = s->direction == MUS_SEAM_REVERSED;
        double at[2][WALK_NOTCHES];
        own.length_a = a->length, own.length_b = b->length;
        own.excess = b->length - a->length - s->ease;
        own.notches_a = walk_notches(&board, s->a, false, at[0]);
        own.notches_b = walk_notches(&board, s->b, reversed, at[1]);
        own.notch_off = own.notches_a == own.notches_b ? 0.0 : (double)NAN;
        for (int32_t i = 0; i < own.notches_a && own.notches_a == own.notches_b; i++)
            own.notch_off = fmax(own.notch_off, fabs(at[1][i] - at[0][i] * (b->length / a->length)));
        own.corner_start = walk_corner(&board, s->a) + walk_corner(&board, reversed ? b->next : s->b);
        own.corner_end = walk_corner(&board, a->next) + walk_corner(&board, reversed ? s->b : b->next);
        if (a->backward) {
            const double swap = own.corner_start;
            own.corner_start = own.corner_end, own.corner_end = swap;
        }
    }
    status = board.status;
    mus__board_free(&board);
    return status == MUS_OK ? mus__pattern_give(pattern, out, &own, sizeof own, "seam walk") : status;
}


/* move the end (or the start) of a side along its tangent until the side is `wanted` [m] long; the neighbour follows */
static void edit_true(mus__board *board, int32_t side, bool end, double wanted)
{
    if (board->status != MUS_OK) return;
    const int32_t other = end ? board->side[side].next : board->side[side].prev;
    double from[2], along[2], at[2];
    mus__board_at(board, side, end ? board->side[side].length : 0.0, from, along);
    double d = 0.0, sign = end ? 1.0 : -1.0;
    for (int32_t i = 0; i < TRUE_STEPS && board->status == MUS_OK; i++) {
        const double miss = wanted - board->side[side].length;
        if (fabs(miss) <= TRUE_ENOUGH) break;
        d += miss;
        for (int k = 0; k < 2; k++) at[k] = from[k] + sign * d * along[k];
        if (!mus__near(2, at)) break;
        mus__board_part_move_end(board, side, end, at);
    }
    if (board->status == MUS_OK && !(fabs(wanted - board->side[side].length) <= 1e3 * TRUE_ENOUGH))
        mus__board_fail(board, MUS_ERR_PATTERN, "side %s: no place of its end makes it %g m long, it is %g m",
                        board->side[side].name, wanted, board->side[side].length);
    if (d != 0.0 && board->status == MUS_OK && other != side) mus__board_part_move_end(board, other, !end, at);
}


mus_status mus_pattern_true_seam(mus_pattern *pattern, int32_t seam, int32_t edge, int32_t at_end)
{
    mus__editing e;
    mus_status status = mus__edit_begin(&e, pattern);
    if (status != MUS_OK) return status;
    mus__board *board = &e.board;
    board->status = mus__pattern_known(pattern, "seam", seam, pattern->nseam);
    const int32_t side = mus__edit_side(&e, edge);
    if (board->status == MUS_OK) {
        const mus__board_seam *s = &board->seam[seam];
        const bool first = s->a == side;
        if ((!first && s->b != side) || (at_end != 0 && at_end != 1)) {
            mus__board_fail(board, MUS_ERR_ARG, "true seam %d: side %s is none of it, or its end %d neither 0 nor 1",
                            (int)seam, board->side[side].name, (int)at_end);
        } else {
            const double other = board->side[first ? s->b : s->a].length,
                         wanted = first ? other - s->ease : other + s->ease;
            mus__board_part_twins(board, board->side[side].panel);
            if (!(wanted > 1e-6))
                mus__board_fail(board, MUS_ERR_PATTERN, "true seam %d: side %s would be %g m long", (int)seam,
                                board->side[side].name, wanted);
            edit_true(board, side, (at_end == 1) != board->side[side].backward, wanted);
        }
    }
    return mus__edit_end(&e, 0, NULL, NULL);
}


mus_status mus_pattern_notch_seam(mus_pattern *pattern, int32_t edge, double s, int32_t kind)
{
    mus__editing e;
    double at;
    const mus_status status = mus__edit_begin(&e, pattern);
    if (status != MUS_OK) return status;
    const int32_t side = mus__edit_place(&e, edge, s, &at);
    mus__board_notch_seam(&e.board, side, at, kind, 0.0);
    return mus__edit_end(&e, 0, NULL, NULL);
}
