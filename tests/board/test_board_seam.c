/*
 * test_board_seam.c: sides divided and made one again keep length, area, notches and seams; runs with different joints
 * are matched at equal relative length.
 */
#include "board/table.h"
#include "muslin/topology.h"
#include "pattern/same.h"
#include "topology/gluing.h"


/* a panel of n straight sides: w metre wide, the lower edge in parts given as relative joints, rings counter-clockwise;
 * names a0 a1 ... along the lower edge */
static int32_t strip(mus__board *board, const char *name, double w, int32_t njoint, const double *joint, int32_t *run)
{
    const int32_t panel = mus__board_panel_add(board, name, NULL);
    double at[2] = {0.0, 0.0};
    char side[16];
    for (int32_t i = 0; i <= njoint; i++) {
        const double end[2] = {i < njoint ? w * joint[i] : w, 0.0};
        snprintf(side, sizeof side, "a%d", (int)i);
        run[i] = mus__board_line_add(board, panel, side, "run", at, end);
        memcpy(at, end, sizeof at);
    }
    const double corner[4][2] = {{w, 0.0}, {w, 0.3}, {0.0, 0.3}, {0.0, 0.0}};
    for (int32_t i = 0; i < 3; i++) mus__board_line_add(board, panel, "rest", "", corner[i], corner[i + 1]);
    mus__board_panel_close(board, panel);
    table_well(board);
    return panel;
}


START_TEST(runs_with_other_joints_are_matched_at_equal_relative_length)
{
    mus_context *context = support_context();
    uint64_t random = 11;
    for (int32_t round = 0; round < 200; round++) {
        mus__board board;
        mus__board_begin(&board, context, "runs");
        double joint[2][4], length[2] = {support_uniform(&random, 0.3, 1.0), support_uniform(&random, 0.3, 1.0)};
        int32_t n[2], run[2][16];
        for (int32_t k = 0; k < 2; k++) {
            n[k] = (int32_t)(support_random(&random) % 5);
            double at = 0.0;
            for (int32_t i = 0; i < n[k]; i++) joint[k][i] = at += support_uniform(&random, 0.05, 0.2);
            strip(&board, k == 0 ? "a" : "b", length[k], n[k], joint[k], run[k]);
        }
        /* a joint of a at t is one of b at 1 - t: sometimes the very same, sometimes 0.4 mm off */
        mus__board_sew(&board, n[0] + 1, run[0], n[1] + 1, run[1]);
        table_whole(&board);

        int32_t side[2][16], count[2];
        for (int32_t k = 0; k < 2; k++) count[k] = mus__board_run(&board, k, "run", side[k], 16);
        ck_assert_int_eq(count[0], count[1]);
        ck_assert_int_le(count[0], n[0] + n[1] + 1);
        double sum[2] = {0.0, 0.0}, ease = 0.0;
        for (int32_t i = 0; i < count[0]; i++) {
            const int32_t a = side[0][i], b = side[1][count[1] - 1 - i], seam = mus__board_seam_of(&board, a);
            ck_assert_int_eq(mus__board_partner(&board, a), b);
            ck_assert_int_eq(board.seam[seam].direction, MUS_SEAM_REVERSED);
            ck_assert_double_eq_tol(board.seam[seam].ease, board.side[b].length - board.side[a].length, 1e-12);
            sum[0] += board.side[a].length, sum[1] += board.side[b].length, ease += board.seam[seam].ease;
            ck_assert_double_eq_tol(sum[0] / length[0], sum[1] / length[1], 0.001 / fmax(length[0], length[1]));
        }
        for (int32_t k = 0; k < 2; k++) ck_assert_double_eq_tol(sum[k], length[k], 1e-12);
        ck_assert_double_eq_tol(ease, length[1] - length[0], 1e-12);
        mus__board_free(&board);
    }
    support_context_end(context);
}
END_TEST


START_TEST(joints_nearer_than_a_millimetre_are_one)
{
    mus_context *context = support_context();
    mus__board board;
    int32_t a[8], b[8];
    const double at[1] = {0.5}, near[1] = {0.4991}, far[1] = {0.4989};
    for (int32_t i = 0; i < 2; i++) {
        mus__board_begin(&board, context, "near");
        strip(&board, "a", 1.0, 1, at, a);
        strip(&board, "b", 1.0, 1, i == 0 ? near : far, b);
        mus__board_sew(&board, 2, a, 2, b);
        table_whole(&board);
        ck_assert_int_eq(mus__board_run(&board, 0, "run", a, 8), i == 0 ? 2 : 3);
        ck_assert_int_eq(mus__board_run(&board, 1, "run", b, 8), i == 0 ? 2 : 3);
        mus__board_free(&board);
    }
    support_context_end(context);
}
END_TEST


/* total length of the ring of a panel */
static double ring_length(const mus__board *board, int32_t panel)
{
    double sum = 0.0;
    for (int32_t i = 0; i < board->nside; i++) sum += board->side[i].panel == panel ? board->side[i].length : 0.0;
    return sum;
}


START_TEST(a_split_keeps_length_area_and_points_and_merging_undoes_it)
{
    mus_context *context = support_context();
    sample s = sample_make(context);
    uint64_t random = 5;
    for (int32_t round = 0; round < 300; round++) {
        mus__board board;
        mus__board_read(&board, s.pattern);
        const int32_t side = (int32_t)(support_random(&random) % (uint64_t)board.nside);
        const int32_t panel = board.side[side].panel, nside = board.nside;
        const double length = board.side[side].length, at = support_uniform(&random, 0.01, 0.99) * length;
        const double area = table_area(&board, panel), ring = ring_length(&board, panel);
        double p[6], q[6];
        for (int32_t k = 0; k < 3; k++) mus__board_at(&board, side, 0.2 * (k + 1) * length, p + 2 * k, NULL);
        const int32_t partner = mus__board_partner(&board, side);
        const int32_t made = mus__board_split(&board, side, at, NULL);
        table_whole(&board);
        ck_assert_int_eq(board.nside, nside + (partner == MUS_NONE ? 1 : 2));
        ck_assert_double_eq_tol(board.side[side].length, at, 1e-12);
        ck_assert_double_eq_tol(table_area(&board, panel), area, 1e-14);
        ck_assert_double_eq_tol(ring_length(&board, panel), ring, 1e-12);
        ck_assert(mus__edge_attributes_equal(&board.side[made].attr, &board.side[side].attr));
        for (int32_t k = 0; k < 3; k++) {
            const double t = 0.2 * (k + 1) * length;
            mus__board_at(&board, t < at ? side : made, t < at ? t : t - at, q + 2 * k, NULL);
        }
        for (int32_t k = 0; k < 6; k++) ck_assert_double_eq_tol(p[k], q[k], 1e-12);
        if (partner != MUS_NONE) {
            ck_assert_int_eq(mus__board_partner(&board, made), partner);
            ck_assert_int_eq(board.side[mus__board_partner(&board, side)].prev, partner);
        }

        /* twice more, then all one again */
        mus__board_split(&board, made, 0.5 * board.side[made].length, "named");
        ck_assert_int_ne(mus__board_find(&board, panel, "named"), MUS_NONE);
        ck_assert(mus__board_mergeable(&board, side));
        mus__board_merge(&board, side);
        mus__board_merge(&board, side);
        table_whole(&board);
        /* a curve stays in parts; the pattern is the same in all that counts */
        mus_pattern *after;
        mus__board_write(&board, &after);
        table_well(&board);
        table_same(s.pattern, after, "merged");
        mus_pattern_destroy(after);
        mus__board_free(&board);
    }
    mus_pattern_destroy(s.pattern);
    support_context_end(context);
}
END_TEST


START_TEST(a_split_at_a_joint_of_pieces_divides_none)
{
    mus_context *context = support_context();
    sample s = sample_make(context);
    for (int32_t i = -1; i <= 1; i++) {
        mus__board board;
        mus__board_read(&board, s.pattern);
        const int32_t side = s.edge[2];
        const int32_t made = mus__board_split(&board, side, 0.1 + 1e-12 * i, NULL);
        ck_assert(board.side[side].chain.npiece == 1 && board.side[made].chain.npiece == 1);
        ck_assert(board.side[side].chain.kinds[0] == MUS_PIECE_LINE && board.side[made].chain.nxy == 4);
        mus__board_merge(&board, side);
        table_whole(&board);
        ck_assert(board.side[side].chain.npiece == 2);
        mus__board_free(&board);
    }
    mus_pattern_destroy(s.pattern);
    support_context_end(context);
}
END_TEST


START_TEST(a_split_goes_through_all_sheets_and_bridges)
{
    mus_context *context = support_context();
    static const char *const rows[][3] = {
        /* panels, seams, the side to split */
        {"A: a b c d; B: a b c d; C: a b c d", "A.a B.a; C.a B.a direct", "A.a"},
        {"A: a h b h- c", "", "A.h"},
        {"A: a b a- b-", "", "A.a"},
        {"A: b e1 t e2", "A.e1 A.e2 direct", "A.e1"},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        mus_pattern *pattern = gluing_make(context, rows[i][0], rows[i][1], 0);
        mus__board board;
        mus_topology before, after;
        mus__board_read(&board, pattern);
        table_topology(&board, &before);
        const int32_t side = table_side(&board, rows[i][2]);
        const double length = board.side[side].length;
        mus__board_split(&board, side, 0.3 * length, NULL);
        table_whole(&board);
        table_topology(&board, &after);
        ck_assert_int_eq(after.vertices, before.vertices + 1);
        ck_assert_int_eq(after.edges, before.edges + 1);
        ck_assert(after.loops == before.loops && after.euler == before.euler && after.orientable == before.orientable);

        /* a bridge is still one edge of the pattern, in two parts */
        mus_pattern *again;
        mus__board_write(&board, &again);
        ck_assert_int_eq(mus_pattern_seam_count(again), 2 * mus_pattern_seam_count(pattern));
        ck_assert_int_eq(mus_pattern_edge_count(again), mus_pattern_edge_count(pattern) + (i == 0   ? 3
                                                                                           : i == 3 ? 2
                                                                                                    : 1));
        mus_pattern_destroy(again);
        mus__board_merge(&board, side);
        table_whole(&board);
        table_topology(&board, &after);
        ck_assert(after.vertices == before.vertices && after.edges == before.edges);
        mus__board_free(&board);
        mus_pattern_destroy(pattern);
    }
    support_context_end(context);
}
END_TEST


START_TEST(ease_is_divided_and_added_in_proportion)
{
    mus_context *context = support_context();
    mus__board board;
    int32_t a[8], b[8];
    mus__board_begin(&board, context, "ease");
    strip(&board, "a", 1.0, 0, NULL, a);
    strip(&board, "b", 1.2, 0, NULL, b);
    mus__board_sew(&board, 1, a, 1, b);
    mus__board_split(&board, b[0], 0.3, NULL);
    table_whole(&board);
    const int32_t seam = mus__board_seam_of(&board, b[0]);
    ck_assert_double_eq_tol(board.seam[seam].ease, 0.05, 1e-12);
    ck_assert_double_eq_tol(board.side[a[0]].length, 0.75, 1e-12);
    mus__board_merge(&board, a[0]);
    ck_assert_double_eq_tol(board.seam[mus__board_seam_of(&board, a[0])].ease, 0.2, 1e-12);
    ck_assert_int_eq(board.side[a[0]].chain.npiece, 1);
    mus__board_seam_drop(&board, a[0]);
    ck_assert_int_eq(mus__board_partner(&board, b[0]), MUS_NONE);
    table_well(&board);

    /* one side sewn, the next not: they part, and merging says so */
    strip(&board, "c", 1.0, 1, (double[]){0.5}, a);
    mus__board_seam_add(&board, a[0], b[0], MUS_SEAM_REVERSED, 0.0);
    ck_assert(!mus__board_mergeable(&board, a[0]));
    mus__board_merge(&board, a[0]);
    ck_assert_int_eq(board.status, MUS_ERR_PATTERN);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "seams part"));
    mus__board_free(&board);
    support_context_end(context);
}
END_TEST


START_TEST(what_cannot_be_split_or_sewn_is_refused)
{
    mus_context *context = support_context();
    for (int32_t i = 0; i < 7; i++) {
        mus__board board;
        int32_t a[8], none = MUS_NONE;
        mus__board_begin(&board, context, "no");
        strip(&board, "a", 1.0, 0, NULL, a);
        switch (i) {
        case 0: mus__board_split(&board, a[0], 5e-7, NULL); break;
        case 1: mus__board_split(&board, a[0], 1.0, NULL); break;
        case 2: mus__board_split(&board, a[0], (double)NAN, NULL); break;
        case 3: mus__board_split(&board, 99, 0.5, NULL); break;
        case 4: mus__board_seam_add(&board, a[0], a[0], MUS_SEAM_REVERSED, 0.0); break;
        case 5: mus__board_sew(&board, 1, a, 1, &none); break;
        default: mus__board_sew(&board, 0, a, 1, a); break;
        }
        ck_assert_int_ne(board.status, MUS_OK);
        mus_pattern *pattern;
        mus__board_write(&board, &pattern);
        ck_assert_ptr_null(pattern);
        mus__board_free(&board);
    }
    support_context_end(context);
}
END_TEST


START_TEST(sewing_without_memory_fails_and_leaves_nothing)
{
    const double joint[3] = {0.2, 0.5, 0.9};
    for (int64_t n = 0;; n++) {
        mus_context *context = support_context();
        mus__board board;
        int32_t a[8], b[8];
        mus__board_begin(&board, context, "memory");
        strip(&board, "a", 1.0, 3, joint, a);
        strip(&board, "b", 1.1, 2, joint, b);
        support_fail_after(n, false);
        mus__board_sew(&board, 4, a, 3, b);
        mus__board_seam_drop(&board, a[0]);
        mus__board_merge(&board, board.side[board.side[a[3]].next].next);
        support_fail_never();
        const mus_status status = board.status;
        mus__board_free(&board);
        support_context_end(context);
        if (status == MUS_OK) break;
        ck_assert_int_eq(status, MUS_ERR_MEMORY);
    }
}
END_TEST


Suite *mus_suite_board_seam(void);
Suite *mus_suite_board_seam(void)
{
    Suite *suite = suite_create("board_seam");
    TCase *tcase = tcase_create("board_sew");
    tcase_add_test(tcase, runs_with_other_joints_are_matched_at_equal_relative_length);
    tcase_add_test(tcase, joints_nearer_than_a_millimetre_are_one);
    tcase_add_test(tcase, a_split_keeps_length_area_and_points_and_merging_undoes_it);
    tcase_add_test(tcase, a_split_at_a_joint_of_pieces_divides_none);
    tcase_add_test(tcase, a_split_goes_through_all_sheets_and_bridges);
    tcase_add_test(tcase, ease_is_divided_and_added_in_proportion);
    tcase_add_test(tcase, what_cannot_be_split_or_sewn_is_refused);
    tcase_add_test(tcase, sewing_without_memory_fails_and_leaves_nothing);
    suite_add_tcase(suite, tcase);
    return suite;
}
