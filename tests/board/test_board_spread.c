/*
 * test_board_spread.c: slash and spread, lengthen, redraw and fair on the cutting table. The gap of a slash of length L
 * is a trapezoid between two legs of length L, so the area grows by L cos(d / 2) (w0 + w1) / 2 with 2 sin(d / 2) =
 * (w1 - w0) / L; all else is rigid.
 */
#include <string.h>

#include "board/darts.h"
#include "muslin/topology.h"


/* a skirt of 25 x 60 cm, counter-clockwise from the hem at the centre */
static int32_t skirt_draw(mus__board *board)
{
    static const char *const names[4] = {"hem", "side", "waist", "centre"};
    const double p[4][2] = {{0.0, 0.0}, {0.25, 0.0}, {0.25, 0.6}, {0.0, 0.6}};
    const int32_t panel = mus__board_panel_add(board, "front", "skirt");
    for (int32_t i = 0; i < 4; i++) mus__board_line_add(board, panel, names[i], names[i], p[i], p[(i + 1) % 4]);
    mus__board_panel_close(board, panel);
    return panel;
}


/* a random slash, and the figures of the panel before it */
typedef struct slash {
    mus__board board;
    int32_t panel, from, to, sides;
    double s0, s1, w0, w1, p[2], q[2], area, lengths[64];
} slash;


static void slash_make(slash *v, mus_context *context, uint64_t *state)
{
    mus__board *board = &v->board;
    mus__board_begin(board, context, "random");
    const int32_t n = 3 + (int32_t)(support_random(state) % 6);
    v->panel = dart_panel_random(board, state, "a", n, support_uniform(state, -1.0, 1.0), 0.5);
    const int32_t other = dart_panel_random(board, state, "b", 4, 2.5, 0.0);
    mus__board_seam_add(board, 0, dart_nth(board, other, 1), MUS_SEAM_REVERSED, 0.01);
    mus__board_seam_add(board, dart_nth(board, other, 2), 1, MUS_SEAM_REVERSED, 0.02);
    v->from = dart_nth(board, v->panel, (int32_t)(support_random(state) % (uint64_t)n));
    v->to = dart_nth(board, v->panel, (int32_t)(support_random(state) % (uint64_t)n));

    /* one in four at an end of a side, one in four a hinge, one in four parallel */
    const uint64_t kind = support_random(state) % 4, end = support_random(state) % 8;
    v->s0 = board->side[v->from].length * (end == 0 ? 0.0 : end == 1 ? 1.0 : support_uniform(state, 0.05, 0.95));
    v->s1 = board->side[v->to].length * (end == 2 ? 0.0 : end == 3 ? 1.0 : support_uniform(state, 0.05, 0.95));
    v->w0 = kind == 0 ? 0.0 : support_uniform(state, 0.001, 0.02);
    v->w1 = kind == 1 ? v->w0 : support_uniform(state, 0.001, 0.02);
    mus__board_at(board, v->from, v->s0, v->p, NULL);
    mus__board_at(board, v->to, v->s1, v->q, NULL);
    mus__board_notch_add(board, v->from, 0.5 * (v->s0 + board->side[v->from].length), MUS_NOTCH_SINGLE);
    mus__board_notch_add(board, v->to, 0.5 * v->s1, MUS_NOTCH_SINGLE);
    table_well(board);
    v->area = mus__board_area(board, v->panel), v->sides = board->nside;
    for (int32_t i = 0; i < v->sides; i++) v->lengths[i] = board->side[i].length;
}


static void slash_claims(const slash *v)
{
    const mus__board *board = &v->board;
    dart_ring_whole(board, v->panel);
    const double length = mus__dist2(v->p, v->q), half = 0.5 * (v->w1 - v->w0) / length;
    const double grown = length * sqrt(1.0 - half * half) * 0.5 * (v->w0 + v->w1);
    ck_assert_double_eq_tol(mus__board_area(board, v->panel), v->area + grown, 1e-12);

    /* the slashed sides are longer by what they opened, all others as they were to the bit */
    for (int32_t i = 0; i < v->sides; i++) {
        const double more = (i == v->from ? v->w0 : 0.0) + (i == v->to ? v->w1 : 0.0);
        if (i == v->from || i == v->to)
            ck_assert_double_eq_tol(board->side[i].length, v->lengths[i] + more, 1e-12);
        else
            ck_assert(board->side[i].length == v->lengths[i]);
        ck_assert_int_ne(board->side[i].panel, MUS_NONE);
    }
    for (int32_t i = v->sides; i < board->nside; i++) ck_assert_int_eq(board->side[i].panel, MUS_NONE);

    /* seams mean it: what they differ from their ease is what they differed before */
    for (int32_t i = 0; i < board->nseam; i++) {
        const mus__board_seam *s = &board->seam[i];
        const double was = v->lengths[s->b] - v->lengths[s->a] - (i == 0 ? 0.01 : 0.02);
        ck_assert_double_eq_tol(board->side[s->b].length - board->side[s->a].length - s->ease, was, 1e-12);
    }
    for (int32_t i = 0; i < board->nnotch; i++)
        ck_assert(board->notch[i].s >= 0.0 && board->notch[i].s <= board->side[board->notch[i].side].length);
}


START_TEST(random_slashes_open_trapezoids)
{
    mus_context *context = support_context();
    uint64_t state = 99;
    int32_t done = 0, one_side = 0;
    for (int32_t round = 0; round < 1000; round++) {
        slash v;
        slash_make(&v, context, &state);
        const mus_topology before = dart_topology(&v.board);
        mus__board_spread(&v.board, v.from, v.s0, v.to, v.s1, v.w0, v.w1);
        if (v.board.status != MUS_ERR_ARG) {
            table_well(&v.board);
            slash_claims(&v);
            const mus_topology after = dart_topology(&v.board);
            dart_same_topology(&before, &after, 0, 0, 0);
            done++, one_side += v.from == v.to;
        }
        mus__board_free(&v.board);
    }
    ck_assert_int_ge(done, 400);
    ck_assert_int_ge(one_side, 20);
    support_context_end(context);
}
END_TEST


START_TEST(a_flare_is_hinged_and_gathers_are_parallel)
{
    mus_context *context = support_context();
    mus__board board;
    mus__board_begin(&board, context, "skirt");
    const int32_t panel = skirt_draw(&board);
    const int32_t hem = mus__board_find(&board, panel, "hem"), waist = mus__board_find(&board, panel, "waist");
    const double mark[4] = {0.05, 0.3, 0.2, 0.3};
    mus__board_mark_add(&board, panel, "hip", 2, mark);
    mus__board_notch_add(&board, hem, 0.2, MUS_NOTCH_SINGLE);
    mus__board_notch_add(&board, hem, 0.05, MUS_NOTCH_SINGLE);

    /* from the hem at 10 cm to the waist at 15 cm (10 cm from the centre), hinged there: the side is what moves */
    mus__board_spread(&board, hem, 0.1, waist, 0.15, 0.06, 0.0);
    table_well(&board);
    ck_assert_double_eq_tol(board.side[hem].length, 0.31, 1e-15);
    ck_assert_double_eq_tol(board.side[waist].length, 0.25, 1e-15);
    const double angle = 2.0 * asin(0.5 * 0.06 / 0.6);
    ck_assert_double_eq_tol(mus__board_area(&board, panel), 0.15 + 0.5 * 0.36 * sin(angle), 1e-15);
    const double *corner = mus__board_end(&board, hem);
    ck_assert_double_eq_tol(corner[0], 0.1 + 0.15 * cos(angle) + 0.6 * sin(angle), 1e-15);
    ck_assert_double_eq_tol(corner[1], 0.6 + 0.15 * sin(angle) - 0.6 * cos(angle), 1e-15);
    ck_assert(board.mark[0].xy[0] == 0.05 && board.mark[0].xy[1] == 0.3);
    ck_assert_double_eq_tol(board.mark[0].xy[2], 0.1 + 0.1 * cos(angle) + 0.3 * sin(angle), 1e-15);
    ck_assert_double_eq_tol(board.notch[0].s, 0.26, 1e-15);
    ck_assert_double_eq_tol(board.notch[1].s, 0.05, 1e-15);

    /* opened by as much at both ends, all is a shift, and the waist has 6 cm to gather */
    mus__board_free(&board);
    mus__board_begin(&board, context, "skirt");
    const int32_t again = skirt_draw(&board);
    mus__board_spread(&board, hem, 0.1, waist, 0.15, 0.06, 0.06);
    table_well(&board);
    ck_assert_double_eq_tol(mus__board_area(&board, again), 0.31 * 0.6, 1e-15);
    ck_assert_int_eq(board.side[hem].chain.npiece, 1);
    ck_assert_int_eq(board.side[waist].chain.npiece, 1);
    mus__board_free(&board);
    support_context_end(context);
}
END_TEST


START_TEST(lengthening_is_undone_by_shortening)
{
    mus_context *context = support_context();
    mus__board board;
    mus__board_begin(&board, context, "skirt");
    const int32_t panel = skirt_draw(&board);
    const double point[2] = {0.1, 0.3}, along[2] = {2.0, 0.0}, mark[4] = {0.1, 0.1, 0.1, 0.5};
    mus__board_mark_add(&board, panel, "grain", 2, mark);
    const int32_t side = mus__board_find(&board, panel, "side");
    mus__board_notch_add(&board, side, 0.15, MUS_NOTCH_SINGLE);
    mus__board_lengthen(&board, panel, point, along, 0.05);
    table_well(&board);
    dart_ring_whole(&board, panel);
    ck_assert_double_eq_tol(mus__board_area(&board, panel), 0.25 * 0.65, 1e-15);
    ck_assert_double_eq_tol(board.side[side].length, 0.65, 1e-15);
    ck_assert_double_eq_tol(board.mark[0].xy[3], 0.55, 1e-15);
    ck_assert(board.mark[0].xy[1] == 0.1);
    mus__board_lengthen(&board, panel, point, along, -0.05);
    ck_assert_double_eq_tol(mus__board_area(&board, panel), 0.15, 1e-15);
    ck_assert_double_eq_tol(board.notch[0].s, 0.15, 1e-15);

    /* an arc keeps its angle, curves their tangents at the ends: the crown of an ellipse of lines and arcs */
    const int32_t kinds[2] = {MUS_PIECE_ARC, MUS_PIECE_CUBIC};
    const double xy[12] = {0.0, 0.0, -0.05, 0.3, 0.0, 0.6, 0.05, 0.7, 0.2, 0.7, 0.25, 0.6};
    const int32_t round = mus__board_panel_add(&board, "round", ""), kind = MUS_PIECE_LINE;
    mus__board_side_add(&board, round, "rim", "", 2, kinds, 6, xy);
    const double chord[4] = {0.25, 0.6, 0.0, 0.0};
    mus__board_side_add(&board, round, "chord", "", 1, &kind, 2, chord);
    mus__board_panel_close(&board, round);
    mus__board_lengthen(&board, round, point, along, 0.1);
    table_well(&board);
    const double *p = board.side[mus__board_find(&board, round, "rim")].chain.xy;
    ck_assert_double_eq_tol(mus__dist2(p, p + 2), mus__dist2(p + 2, p + 4), 1e-15);
    ck_assert_double_eq_tol((p[0] - p[2]) / (p[5] - p[1]), 0.05 / 0.6, 1e-15);
    ck_assert_double_eq_tol(p[7] - p[5], 0.1, 1e-15);

    /* more than there is cannot be taken away */
    mus__board_lengthen(&board, panel, point, along, -0.7);
    ck_assert_int_eq(board.status, MUS_ERR_ARG);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "leave nothing of it"));
    mus__board_free(&board);
    support_context_end(context);
}
END_TEST


START_TEST(neighbours_follow_a_side_that_is_drawn_again)
{
    mus_context *context = support_context();
    mus__board board;
    mus__board_begin(&board, context, "random");
    uint64_t state = 5;
    const int32_t panel = dart_panel_random(&board, &state, "a", 5, 0.0, 0.0);
    for (int32_t round = 0; round < 200; round++) {
        const int32_t side = dart_nth(&board, panel, (int32_t)(support_random(&state) % 5));
        const int32_t prev = board.side[side].prev, next = board.side[side].next, kind = MUS_PIECE_CUBIC;
        const double *p = mus__board_start(&board, side), *q = mus__board_end(&board, side);
        const double d[2] = {support_uniform(&state, -0.01, 0.01), support_uniform(&state, -0.01, 0.01)};
        const double xy[8] = {p[0] + d[0],
                              p[1] + d[1],
                              0.7 * p[0] + 0.3 * q[0],
                              0.7 * p[1] + 0.3 * q[1],
                              0.3 * p[0] + 0.7 * q[0],
                              0.3 * p[1] + 0.7 * q[1],
                              q[0] + d[1],
                              q[1] + d[0]};
        double u[2][2], v[2][2];
        mus__board_at(&board, prev, 0.0, u[0], u[1]);
        mus__board_notch_add(&board, next, 0.4 * board.side[next].length, MUS_NOTCH_SINGLE);
        mus__board_redraw(&board, side, 1, &kind, 4, xy);
        table_well(&board);
        dart_ring_whole(&board, panel);
        ck_assert_mem_eq(board.side[side].chain.xy, xy, sizeof xy);
        ck_assert_double_eq_tol(board.notch[board.nnotch - 1].s, 0.4 * board.side[next].length, 1e-15);

        /* the far end of a neighbour stays with its tangent, when it is a curve */
        mus__board_at(&board, prev, 0.0, v[0], v[1]);
        ck_assert_mem_eq(u[0], v[0], sizeof u[0]);
        if (board.side[prev].chain.kinds[0] == MUS_PIECE_CUBIC)
            ck_assert_double_eq_tol(u[1][0] * v[1][1] - u[1][1] * v[1][0], 0.0, 1e-12);
        board.nnotch = 0;
    }
    mus__board_free(&board);
    support_context_end(context);
}
END_TEST


START_TEST(a_fair_hem_has_no_corner)
{
    mus_context *context = support_context();
    mus__board board;
    mus__board_begin(&board, context, "skirt");
    const int32_t panel = skirt_draw(&board);
    const int32_t hem = mus__board_find(&board, panel, "hem"), waist = mus__board_find(&board, panel, "waist");
    for (int32_t i = 0; i < 4; i++) mus__board_spread(&board, hem, 0.05 + 0.09 * i, waist, 0.2 - 0.05 * i, 0.04, 0.0);
    table_well(&board);
    ck_assert_double_eq_tol(board.side[hem].length, 0.41, 1e-12);
    const double area = mus__board_area(&board, panel);
    double start[2], end[2], u[2], v[2], p[2], q[2];
    mus__board_at(&board, hem, 0.0, start, u);
    mus__board_at(&board, hem, 0.41, end, v);
    double places[65][2];
    for (int32_t i = 0; i < 65; i++) mus__board_at(&board, hem, board.side[hem].length * i / 64.0, places[i], NULL);
    mus__board_fair(&board, hem, 0.008);
    table_well(&board);
    dart_ring_whole(&board, panel);

    /* ends and tangents there stay */
    const mus__board_side *side = &board.side[hem];
    mus__board_at(&board, hem, 0.0, p, q);
    ck_assert_mem_eq(p, start, sizeof p);
    ck_assert_double_eq_tol(q[0] * u[1] - q[1] * u[0], 0.0, 1e-12);
    mus__board_at(&board, hem, side->length, p, q);
    ck_assert_mem_eq(p, end, sizeof p);
    ck_assert_double_eq_tol(q[0] * v[1] - q[1] * v[0], 0.0, 1e-12);

    /* one curve that bends one way, within 8 mm of the slashed hem, as long within 2 mm, the area within 1 % */
    ck_assert_int_eq(side->chain.npiece, 1);
    const double *x = side->chain.xy;
    for (int32_t i = 0; i < 2; i++) {
        const double *a = x + 2 * i;
        ck_assert_double_gt((a[2] - a[0]) * (a[5] - a[3]) - (a[3] - a[1]) * (a[4] - a[2]), 0.0);
    }
    for (int32_t i = 0; i < 65; i++) {
        double nearest = 1.0;
        for (int32_t k = 0; k <= 2000; k++) {
            mus__board_at(&board, hem, side->length * k / 2000.0, p, NULL);
            nearest = fmin(nearest, mus__dist2(p, places[i]));
        }
        ck_assert_double_le(nearest, 0.008 + 1e-4);
    }
    ck_assert_double_eq_tol(side->length, 0.41, 2e-3);
    ck_assert_double_eq_tol(mus__board_area(&board, panel), area, 1e-2 * area);

    /* drawn closer it has more pieces and still no corner; a side without one stays to the bit */
    const mus__board_chain was = board.side[waist].chain;
    mus__board_spread(&board, hem, 0.2, waist, 0.1, 0.1, 0.0);
    mus__board_fair(&board, hem, 0.0005);
    ck_assert_int_gt(board.side[hem].chain.npiece, 1);
    x = board.side[hem].chain.xy;
    for (int32_t i = 0; i + 1 < board.side[hem].chain.npiece; i++) {
        const double *j = x + 6 * (i + 1), a[2] = {j[0] - j[-2], j[1] - j[-1]}, b[2] = {j[2] - j[0], j[3] - j[1]};
        ck_assert_double_eq_tol(a[0] * b[1] - a[1] * b[0], 0.0, 1e-12);
        ck_assert_double_gt(a[0] * b[0] + a[1] * b[1], 0.0);
    }
    const int32_t centre = mus__board_find(&board, panel, "centre");
    const double *line = board.side[centre].chain.xy;
    mus__board_fair(&board, centre, 0.01);
    ck_assert_ptr_eq(board.side[centre].chain.xy, line);
    ck_assert_int_eq(was.npiece, 4 + 1);
    mus__board_fair(&board, centre, 0.0);
    ck_assert_int_eq(board.status, MUS_ERR_ARG);
    mus__board_free(&board);
    support_context_end(context);
}
END_TEST


START_TEST(what_is_no_slash_is_refused_with_its_numbers)
{
    mus_context *context = support_context();
    static const char *const says[6] = {"0.3 m is outside side hem", "at least one must be above 0", "at least one",
                                        "slash longer than",         "is not on the board",          "lies outside"};
    for (int32_t i = 0; i < 6; i++) {
        mus__board board;
        mus__board_begin(&board, context, "skirt");
        const int32_t panel = skirt_draw(&board);
        const int32_t hem = mus__board_find(&board, panel, "hem"), waist = mus__board_find(&board, panel, "waist");
        const double s0[6] = {0.3, 0.1, 0.1, 0.1, 0.1, 0.1}, w0[6] = {0.1, 0.0, -0.1, 0.7, 0.1, 0.1};
        mus__board_spread(&board, hem, s0[i], i == 4 ? 17 : i == 5 ? hem : waist, i == 5 ? 0.2 : 0.15, w0[i], 0.0);
        ck_assert_int_eq(board.status, MUS_ERR_ARG);
        ck_assert_msg(strstr(mus_context_error(context), says[i]) != NULL, "%d: %s", i, mus_context_error(context));
        mus__board_free(&board);
    }
    support_context_end(context);
}
END_TEST


START_TEST(spreading_survives_failing_memory)
{
    for (int64_t n = 0;; n++) {
        mus_context *context = support_context();
        mus__board board;
        support_fail_after(n, false);
        mus__board_begin(&board, context, "skirt");
        const int32_t panel = skirt_draw(&board), hem = 0, waist = 2;
        const double point[2] = {0.1, 0.3}, along[2] = {2.0, 0.0};
        mus__board_mark_add(&board, panel, "point", 1, point);
        mus__board_spread(&board, hem, 0.1, waist, 0.15, 0.06, 0.0);
        mus__board_spread(&board, waist, 0.1, hem, 0.04, 0.06, 0.01);
        mus__board_lengthen(&board, panel, point, along, 0.05);
        mus__board_fair(&board, hem, 0.002);
        support_fail_never();
        const mus_status status = board.status;
        mus__board_free(&board);
        support_context_end(context);
        if (status == MUS_OK) break;
        ck_assert_int_eq(status, MUS_ERR_MEMORY);
    }
}
END_TEST


Suite *mus_suite_board_spread(void);


Suite *mus_suite_board_spread(void)
{
    Suite *suite = suite_create("board_spread");
    TCase *tcase = tcase_create("spread");
    tcase_add_test(tcase, random_slashes_open_trapezoids);
    tcase_add_test(tcase, a_flare_is_hinged_and_gathers_are_parallel);
    tcase_add_test(tcase, lengthening_is_undone_by_shortening);
    tcase_add_test(tcase, neighbours_follow_a_side_that_is_drawn_again);
    tcase_add_test(tcase, a_fair_hem_has_no_corner);
    tcase_add_test(tcase, what_is_no_slash_is_refused_with_its_numbers);
    tcase_add_test(tcase, spreading_survives_failing_memory);
    suite_add_tcase(suite, tcase);
    return suite;
}
