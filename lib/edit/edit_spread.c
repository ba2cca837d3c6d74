/*
 * edit_spread.c: fullness and length (muslin/edit.h): slash and spread, flare, pleat, lengthen.
 *
 * A flare is n slashes at the places (i + 1) / (n + 1) of both edges, taken from the last to the first, so that arc
 * lengths from the start of the hem stay true. Each is hinged and opens by 1 / n of the amount. A pleat is a slash that
 * is opened by twice its depth.
 */
#include "board/board_pleat.h"
#include "board/board_smooth.h"
#include "board/board_spread.h"
#include "edit/edit_internal.h"
#include "geom/vec.h"

#define FLARE_MOST 64
#define PLEATS_MOST 256 /* most pleats on one edge; chosen: bounds the arrays on the stack */
#define FLARE_WITHIN                                                                                                   \
    0.008 /* [m]: a hem is drawn by eye; a slash a hand's breadth from the next leaves corners of 5 mm */


mus_status mus_pattern_spread(mus_pattern *pattern, int32_t edge_a, double s_a, int32_t edge_b, double s_b, double w_a,
                              double w_b)
{
    mus__editing e;
    double at_a, at_b;
    mus_status status = mus__edit_begin(&e, pattern);
    if (status != MUS_OK) return status;
    const int32_t a = mus__edit_place(&e, edge_a, s_a, &at_a), b = mus__edit_place(&e, edge_b, s_b, &at_b);
    mus__board_spread(&e.board, a, at_a, b, at_b, w_a, w_b);
    return mus__edit_end(&e, 0, NULL, NULL);
}


mus_status mus_pattern_flare(mus_pattern *pattern, int32_t hem, int32_t hinge, int32_t n, double amount)
{
    mus__editing e;
    mus_status status = mus__edit_begin(&e, pattern);
    if (status != MUS_OK) return status;
    mus__board *board = &e.board;
    const int32_t a = mus__edit_side(&e, hem), b = mus__edit_side(&e, hinge);
    if (board->status == MUS_OK && (n < 1 || n > FLARE_MOST || a == b))
        mus__board_fail(board, MUS_ERR_ARG, "flare of side %s: %d slashes are outside 1 to %d, to another edge",
                        board->side[a].name, (int)n, FLARE_MOST);
    if (board->status == MUS_OK) {
        const double along = board->side[a].length, hinged = board->side[b].length;
        for (int32_t i = n - 1; i >= 0; i--) {
            const double t = (double)(i + 1) / (n + 1);
            mus__board_spread(board, a, t * along, b, (1.0 - t) * hinged, amount / n, 0.0);
        }
        mus__board_fair(board, a, FLARE_WITHIN);
    }
    return mus__edit_end(&e, 0, NULL, NULL);
}


/* draw the marks of a pleat that was spread between places p and q of two sides: two lines "pleat" and a line "fold" */
static void edit_pleat_marks(mus__board *board, int32_t a, double s_a, int32_t b, double s_b, double w_a, double w_b)
{
    if (board->status != MUS_OK) return;
    const int32_t panel = board->side[a].panel;
    for (int32_t i = 0; i < 3; i++) {
        double line[4];
        mus__board_at(board, a, s_a + 0.5 * i * w_a, line, NULL);
        mus__board_at(board, b, s_b + (1.0 - 0.5 * i) * w_b, line + 2, NULL);
        mus__board_mark_add(board, panel, i == 1 ? "fold" : "pleat", 2, line);
    }
    for (int32_t i = 0; i < 2; i++) {
        if (w_a > 0.0) mus__board_notch_add(board, a, s_a + i * w_a, MUS_NOTCH_SINGLE);
        if (w_b > 0.0) mus__board_notch_add(board, b, s_b + i * w_b, MUS_NOTCH_SINGLE);
    }
}


mus_status mus_pattern_pleat(mus_pattern *pattern, int32_t edge_a, double s_a, int32_t edge_b, double s_b,
                             double depth_a, double depth_b)
{
    mus__editing e;
    double at_a, at_b;
    mus_status status = mus__edit_begin(&e, pattern);
    if (status != MUS_OK) return status;
    const int32_t a = mus__edit_place(&e, edge_a, s_a, &at_a), b = mus__edit_place(&e, edge_b, s_b, &at_b);
    if (e.board.status == MUS_OK && a == b)
        mus__board_fail(&e.board, MUS_ERR_ARG, "pleat on side %s: it has to go to another edge", e.board.side[a].name);
    mus__board_spread(&e.board, a, at_a, b, at_b, 2.0 * depth_a, 2.0 * depth_b);
    edit_pleat_marks(&e.board, a, at_a, b, at_b, 2.0 * depth_a, 2.0 * depth_b);
    return mus__edit_end(&e, 0, NULL, NULL);
}


mus_status mus_pattern_lay_pleats(mus_pattern *pattern, int32_t edge, int32_t n, const double *s, const double *depths)
{
    if (pattern != NULL && n > 0 && (s == NULL || depths == NULL))
        return mus__fail(pattern->context, MUS_ERR_ARG, "pleats: their places are NULL");
    double place[PLEATS_MOST], depth[PLEATS_MOST];
    mus__editing e;
    mus_status status = mus__edit_begin(&e, pattern);
    if (status != MUS_OK) return status;
    mus__board *board = &e.board;
    const int32_t side = mus__edit_side(&e, edge);
    if (board->status == MUS_OK && (n < 1 || n > PLEATS_MOST))
        mus__board_fail(board, MUS_ERR_ARG, "%d pleats on side %s are outside 1 to %d", (int)n, board->side[side].name,
                        PLEATS_MOST);

    /* an edge that runs against its outline is walked from its end */
    for (int32_t i = 0; i < n && board->status == MUS_OK; i++) {
        const bool back = board->side[side].backward;
        const int32_t k = back ? n - 1 - i : i;
        place[i] = back ? board->side[side].length - s[k] : s[k];
        depth[i] = back ? -depths[k] : depths[k];
    }
    if (board->status == MUS_OK) mus__board_lay(board, side, n, place, depth);
    return mus__edit_end(&e, 0, NULL, NULL);
}


mus_status mus_pattern_lengthen(mus_pattern *pattern, int32_t panel, const double *point, const double *direction,
                                double amount)
{
    if (pattern != NULL && (point == NULL || direction == NULL))
        return mus__fail(pattern->context, MUS_ERR_ARG, "lengthen: its line is NULL");
    mus__editing e;
    mus_status status = mus__edit_begin(&e, pattern);
    if (status != MUS_OK) return status;
    if (mus__edit_panel(&e, panel)) mus__board_lengthen(&e.board, panel, point, direction, amount);
    return mus__edit_end(&e, 0, NULL, NULL);
}
