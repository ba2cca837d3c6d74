/*
 * test_board_dart.c: darts on the cutting table added, shortened, released and made part of a seam: what each keeps of
 * area, lengths, the ring and the topology of the sewn panel.
 */
#include <string.h>

#include "board/darts.h"
#include "muslin/topology.h"

#define DEGREE 0.017453292519943295


START_TEST(a_dart_added_to_an_edge_adds_two_vertices_and_two_edges)
{
    mus_context *context = support_context();
    mus__board board;
    mus__board_begin(&board, context, "skirt");
    const int32_t panel = mus__board_panel_add(&board, "front", "");
    const double p[4][2] = {{0.0, -0.6}, {0.25, -0.6}, {0.25, 0.0}, {0.0, 0.0}};
    for (int32_t i = 0; i < 4; i++) {
        static const char *const names[4] = {"hem", "side", "waist", "centre"};
        mus__board_line_add(&board, panel, names[i], names[i], p[i], p[(i + 1) % 4]);
    }
    mus__board_panel_close(&board, panel);
    const int32_t band = mus__board_panel_add(&board, "band", "");
    const double q[4][2] = {{0.0, 1.0}, {0.22, 1.0}, {0.22, 1.04}, {0.0, 1.04}};
    for (int32_t i = 0; i < 4; i++) {
        static const char *const names[4] = {"low", "end1", "top", "end2"};
        mus__board_line_add(&board, band, names[i], "", q[i], q[(i + 1) % 4]);
    }
    mus__board_panel_close(&board, band);
    const int32_t waist = mus__board_find(&board, panel, "waist"), low = mus__board_find(&board, band, "low");
    const int32_t seam = mus__board_seam_add(&board, waist, low, MUS_SEAM_REVERSED, -0.03);
    mus__board_notch_add(&board, waist, 0.02, MUS_NOTCH_SINGLE);
    mus__board_notch_add(&board, waist, 0.2, MUS_NOTCH_DOUBLE);
    const mus_topology before = dart_topology(&board);

    /* 10 cm from the side, 3 cm wide, 10 cm deep: a quarter of 12 cm2 is cut out */
    const double point[2] = {0.15, -0.1};
    const int32_t leg = mus__board_dart_add(&board, waist, 0.1, 0.03, point);
    table_well(&board);
    dart_ring_whole(&board, panel);
    ck_assert_double_eq_tol(mus__board_area(&board, panel), 0.25 * 0.6 - 0.5 * 0.03 * 0.1, 1e-15);
    ck_assert_double_eq_tol(mus__board_dart_angle(&board, leg), 2.0 * atan(0.015 / 0.1), 1e-15);
    ck_assert_str_eq(board.side[leg].name, "waist_d1");
    ck_assert_double_eq_tol(board.side[leg].length, hypot(0.1, 0.015), 1e-15);

    /* the band is split where the mouth closes: both parts have their own seam */
    const mus_topology after = dart_topology(&board);
    dart_same_topology(&before, &after, 2, 2, 0);
    double ease = 0.0;
    for (int32_t i = 0; i < board.nseam; i++) {
        const mus__board_seam *s = &board.seam[i];
        if (s->a == leg) continue;
        ck_assert_double_eq_tol(board.side[s->b].length - board.side[s->a].length - s->ease, 0.0, 1e-15);
        ease += s->ease;
    }
    ck_assert_double_eq_tol(ease, 0.0, 1e-15);
    ck_assert_int_eq(board.seam[seam].a, waist);

    /* notches have kept their places; each is on the part that contains it */
    ck_assert_int_eq(board.notch[0].side, waist);
    ck_assert_double_eq_tol(board.notch[0].s, 0.02, 1e-15);
    ck_assert_int_eq(board.notch[1].side, board.side[board.side[leg].next].next);
    ck_assert_double_eq_tol(board.notch[1].s, 0.2 - 0.115, 1e-15);

    /* released to gathers, the edge is one again, with its former ease and two notches at the gathers */
    ck_assert_int_eq(mus__board_dart_release(&board, leg), waist);
    table_well(&board);
    const mus_topology released = dart_topology(&board);
    dart_same_topology(&before, &released, 0, 0, 0);
    ck_assert_double_eq_tol(board.side[waist].length, 0.25, 1e-15);
    ck_assert_double_eq_tol(board.seam[mus__board_seam_of(&board, waist)].ease, -0.03, 1e-15);
    ck_assert_double_eq_tol(mus__board_area(&board, panel), 0.15, 1e-15);
    ck_assert_int_eq(board.side[waist].chain.npiece, 1);
    double places[2] = {0.085, 0.115};
    for (int32_t i = 2; i < 4; i++) {
        ck_assert_int_eq(board.notch[i].side, waist);
        ck_assert_double_eq_tol(board.notch[i].s, places[i - 2], 1e-15);
    }
    mus__board_free(&board);
    support_context_end(context);
}
END_TEST


START_TEST(a_shortened_dart_keeps_its_mouth)
{
    mus_context *context = support_context();
    const mus__bodice bodice = drafts_bodice(context, "W40");
    mus__board board;
    mus__board_begin(&board, context, "front");
    const dart_front f = dart_front_draw(&board, &bodice.front);
    const double width = mus__dist2(bodice.front.mouth, bodice.front.mouth + 2);
    mus__board_dart_shorten(&board, f.bust_leg, 0.02);
    table_well(&board);

    /* the point is the sewn point of the draft */
    ck_assert_double_eq_tol(mus__dist2(mus__board_end(&board, f.bust_leg), bodice.front.apex), 0.0, 1e-12);
    const int32_t back = board.side[f.bust_leg].next;
    ck_assert_double_eq_tol(board.side[f.bust_leg].length, board.side[back].length, 1e-12);
    const double *mouth[2] = {mus__board_start(&board, f.bust_leg), mus__board_end(&board, back)};
    ck_assert_double_eq_tol(mus__dist2(mouth[0], mouth[1]), width, 1e-15);
    dart_ring_whole(&board, f.panel);

    /* both points backed off the panel has the golden area of the printed draft, 878 cm2, and nothing crosses */
    mus__board_dart_shorten(&board, f.waist_leg, 0.02);
    CK_GOLDEN("W40", "area", mus__board_area(&board, f.panel), CM * CM, 878.0, 1.0);
    mus_pattern *pattern;
    int32_t faults;
    mus__board_write(&board, &pattern);
    table_well(&board);
    ck_assert_int_eq(mus_pattern_check(pattern, &faults, NULL), MUS_OK);
    ck_assert_int_eq(faults, 0);
    mus_pattern_destroy(pattern);

    /* lengthened by the same amount, the dart is as before */
    mus__board_dart_shorten(&board, f.bust_leg, -0.02);
    table_well(&board);
    ck_assert_double_eq_tol(mus__dist2(mus__board_end(&board, f.bust_leg), bodice.front.bust), 0.0, 1e-12);
    mus__board_dart_shorten(&board, f.bust_leg, 0.2);
    ck_assert_int_eq(board.status, MUS_ERR_ARG);
    mus__board_free(&board);
    support_context_end(context);
}
END_TEST


START_TEST(princess_seams_take_both_darts)
{
    /* the bust dart rotated to mid shoulder ends at the point of the waist dart, so that no cut is needed */
    mus_context *context = support_context();
    const mus__bodice bodice = drafts_bodice(context, "W40");
    mus__board board;
    mus__board_begin(&board, context, "front");
    const dart_front f = dart_front_draw(&board, &bodice.front);
    const double area = mus__board_area(&board, f.panel);
    const int32_t leg =
        mus__board_dart_rotate(&board, f.bust_leg, f.shoulder, 0.5 * board.side[f.shoulder].length, f.cf, 1.0);
    const mus_topology before = dart_topology(&board);
    const int32_t to = board.side[leg].next;
    const double lengths[2] = {board.side[leg].length, board.side[f.waist_leg].length};
    const int32_t made = mus__board_dart_to_seam(&board, f.waist_leg, to, NULL, "front_side", "princess");
    table_well(&board);
    dart_ring_whole(&board, f.panel);
    dart_ring_whole(&board, made);
    ck_assert_double_eq_tol(mus__board_area(&board, f.panel) + mus__board_area(&board, made), area, 1e-15);
    ck_assert_double_gt(mus__board_area(&board, made), 0.2 * area);

    /* both darts are one seam, equally long on both panels; the centre panel has not moved */
    const int32_t a = mus__board_find(&board, f.panel, "princess"), b = mus__board_find(&board, made, "princess");
    ck_assert_int_ne(a, MUS_NONE);
    ck_assert_int_eq(mus__board_partner(&board, a), b);
    ck_assert_double_eq_tol(board.side[a].length, lengths[0] + lengths[1], 1e-12);
    ck_assert_double_eq_tol(board.side[b].length, lengths[0] + lengths[1], 1e-12);
    ck_assert_int_ne(mus__board_find(&board, f.panel, "cf"), MUS_NONE);
    ck_assert_int_ne(mus__board_find(&board, made, "side1"), MUS_NONE);
    ck_assert_int_eq(board.mark[0].panel, f.panel);

    /* two darts fewer (2 vertices and 2 edges each), one separation more (2, 3, and a face), and the bust point is no
     * vertex any more: a disc of two faces and one seam */
    const mus_topology after = dart_topology(&board);
    ck_assert_int_eq(after.faces, 2);
    ck_assert_int_eq(after.edges - before.edges, -1);
    ck_assert_int_eq(after.vertices - before.vertices, -2);
    ck_assert_int_eq(after.euler, before.euler);
    ck_assert_int_eq(after.loops, before.loops);
    mus__board_free(&board);
    support_context_end(context);
}
END_TEST


START_TEST(a_dart_goes_on_as_a_seam_along_a_curve)
{
    mus_context *context = support_context();
    const mus__bodice bodice = drafts_bodice(context, "W40");
    mus__board board;
    mus__board_begin(&board, context, "front");
    const dart_front f = dart_front_draw(&board, &bodice.front);
    mus__board_dart_shorten(&board, f.waist_leg, 0.02);
    const mus_topology before = dart_topology(&board);
    const double area = mus__board_area(&board, f.panel);

    /* from the bust point on to the centre front */
    const int32_t to = mus__board_split(&board, f.cf, 0.1, "cf_low");
    const int32_t kind = MUS_PIECE_CUBIC;
    const double *p = bodice.front.bust, *q = mus__board_start(&board, to);
    const double xy[8] = {p[0], p[1], p[0] - 0.03, p[1] + 0.01, q[0] + 0.03, q[1] - 0.01, q[0], q[1]};
    const int32_t made = mus__board_dart_to_seam(&board, f.bust_leg, to, &(mus__board_path){1, &kind, 4, xy},
                                                 "yoke", "yoke_seam");
    table_well(&board);
    ck_assert_double_eq_tol(mus__board_area(&board, f.panel) + mus__board_area(&board, made), area, 1e-15);
    const int32_t a = mus__board_find(&board, f.panel, "yoke_seam");
    ck_assert_int_eq(mus__board_partner(&board, a), mus__board_find(&board, made, "yoke_seam"));
    ck_assert_int_eq(board.side[a].chain.npiece, 2);

    /* a dart (2, 2, 0) less and a separation (2, 3, 1) more */
    const mus_topology after = dart_topology(&board);
    dart_same_topology(&before, &after, 0, 1, 1);
    mus__board_free(&board);
    support_context_end(context);
}
END_TEST


START_TEST(what_is_no_dart_move_is_refused_with_its_numbers)
{
    mus_context *context = support_context();
    const mus__bodice bodice = drafts_bodice(context, "W40");
    for (int32_t i = 0; i < 11; i++) {
        mus__board board;
        mus__board_begin(&board, context, "front");
        const dart_front f = dart_front_draw(&board, &bodice.front);
        const double point[2] = {0.5, 0.0}, inside[2] = {0.1, 0.2};
        const char *says = "";
        if (i == 0) mus__board_dart_rotate(&board, f.shoulder, f.neck, 0.01, f.cf, 1.0), says = "not the leg of a dart";
        if (i == 1) mus__board_dart_rotate(&board, f.bust_leg, f.neck, 0.5, f.cf, 1.0), says = "0.5 m is outside side";
        if (i == 2) mus__board_dart_rotate(&board, f.bust_leg, f.neck, 0.05, f.cf, 1.5), says = "fraction of 1.5";
        if (i == 3) mus__board_dart_rotate(&board, f.bust_leg, f.bust_leg, 0.05, f.cf, 1.0), says = "its own leg";
        if (i == 4) mus__board_dart_rotate(&board, f.bust_leg, 99, 0.05, f.cf, 1.0), says = "side 99";
        if (i == 5)
            mus__board_dart_rotate(&board, f.bust_leg, f.side_low, board.side[f.side_low].length, f.cf, 1.0),
                says = "its own mouth";
        if (i == 6) mus__board_dart_add(&board, f.neck, 0.05, 0.02, point), says = "crosses side";
        if (i == 7) mus__board_dart_add(&board, f.neck, 0.005, 0.02, inside), says = "a mouth of 0.02 m about 0.005 m";
        if (i == 8) mus__board_dart_rotate(&board, f.bust_leg, f.neck, (double)NAN, f.cf, 1.0), says = "nan";
        if (i == 9) mus__board_dart_to_seam(&board, f.bust_leg, f.cf, NULL, "x", "y"), says = "its point";
        if (i == 10) mus__board_dart_release(&board, f.neck), says = "not the leg";
        ck_assert_int_eq(board.status, MUS_ERR_ARG);
        ck_assert_msg(strstr(mus_context_error(context), says) != NULL, "%d: %s", (int)i, mus_context_error(context));
        mus__board_free(&board);
    }
    support_context_end(context);
}
END_TEST


START_TEST(dart_moves_survive_failing_memory)
{
    for (int64_t n = 0;; n++) {
        mus_context *context = support_context();
        const mus__bodice bodice = drafts_bodice(context, "W40");
        mus__board board;
        support_fail_after(n, false);
        mus__board_begin(&board, context, "front");
        const dart_front f = dart_front_draw(&board, &bodice.front);
        int32_t leg = mus__board_dart_rotate(&board, f.bust_leg, f.shoulder, 0.05, f.cf, 0.5);
        const double point[2] = {0.05, 0.2};
        mus__board_dart_add(&board, f.waist_in, 0.04, 0.01, point);
        mus__board_dart_release(&board, f.bust_leg);
        const int32_t to = board.status == MUS_OK ? board.side[f.waist_leg].next : MUS_NONE;
        leg = mus__board_dart_to_seam(&board, leg, to, NULL, "side", "princess");
        support_fail_never();
        const mus_status status = board.status;
        mus__board_free(&board);
        support_context_end(context);
        if (status == MUS_OK) break;
        ck_assert_int_eq(status, MUS_ERR_MEMORY);
    }
}
END_TEST


Suite *mus_suite_board_dart(void);


Suite *mus_suite_board_dart(void)
{
    Suite *suite = suite_create("board_dart");
    TCase *tcase = tcase_create("dart");
    tcase_add_test(tcase, a_dart_added_to_an_edge_adds_two_vertices_and_two_edges);
    tcase_add_test(tcase, a_shortened_dart_keeps_its_mouth);
    tcase_add_test(tcase, princess_seams_take_both_darts);
    tcase_add_test(tcase, a_dart_goes_on_as_a_seam_along_a_curve);
    tcase_add_test(tcase, what_is_no_dart_move_is_refused_with_its_numbers);
    tcase_add_test(tcase, dart_moves_survive_failing_memory);
    suite_add_tcase(suite, tcase);
    return suite;
}
