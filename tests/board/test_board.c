/*
 * test_board.c: the cutting table: read and written it is the pattern that it was; drawing, finding, failing.
 */
#include "board/table.h"
#include "pattern/same.h"
#include "topology/garments.h"
#include "topology/gluing.h"


START_TEST(a_pattern_read_and_written_is_the_same)
{
    mus_context *context = support_context();
    sample s = sample_make(context);
    table_there_and_back(s.pattern, "sample");
    mus_pattern_destroy(s.pattern);
    for (size_t i = 0; i < sizeof garments / sizeof garments[0]; i++) {
        for (uint64_t seed = 0; seed < 4; seed++) {
            mus_pattern *pattern = gluing_make(context, garments[i].panels, garments[i].seams, seed);
            for (int32_t e = 0; e < mus_pattern_edge_count(pattern); e += 3)
                ck_assert_int_eq(mus_pattern_add_notch(pattern, e, 0.01, MUS_NOTCH_DOUBLE, NULL), MUS_OK);
            table_there_and_back(pattern, garments[i].name);
            mus_pattern_destroy(pattern);
        }
    }
    support_context_end(context);
}
END_TEST


START_TEST(an_outline_that_comes_back_to_a_point_still_does)
{
    mus_context *context = support_context();
    static const double xy[5][2] = {{0, 0}, {0.3, 0}, {0.2, 0.2}, {0, 0.3}, {-0.2, 0.1}};
    static const int32_t walk[7] = {0, 1, 2, 0, 3, 4, 0}, along[6] = {1, 1, 1, 1, 1, 1};
    mus_pattern *pattern, *again;
    mus__board board;
    int32_t panel, point[5], edge[6];
    ck_assert_int_eq(mus_pattern_create(context, "eight", &pattern), MUS_OK);
    ck_assert_int_eq(mus_pattern_add_panel(pattern, "eight", &panel), MUS_OK);
    for (int32_t i = 0; i < 5; i++)
        ck_assert_int_eq(mus_pattern_add_point(pattern, panel, xy[i][0], xy[i][1], &point[i]), MUS_OK);
    for (int32_t i = 0; i < 6; i++)
        ck_assert_int_eq(
            mus_pattern_add_edge(pattern, &(mus_edge_def){.size = sizeof(mus_edge_def), .start = point[walk[i]],
                                                          .end = point[walk[i + 1]]}, &edge[i]),
            MUS_OK);
    ck_assert_int_eq(mus_pattern_set_outline(pattern, panel, 6, edge, along), MUS_OK);

    /* read and written as it is, mirrored, and the part of a cut whose outline passes the point twice */
    const int32_t arc = MUS_PIECE_ARC, points[3] = {5, 10, 12};
    const double cut[6] = {0.3, 0.0, 0.15, -0.05, 0.0, 0.0};
    mus__board_read(&board, pattern);
    for (int32_t i = 0; i < 3; i++) {
        if (i == 1) mus__board_mirror(&board, 0, "image");
        if (i == 2) mus__board_cut(&board, 1, 0, &(mus__board_path){1, &arc, 3, cut}, "part", "cut");
        table_whole(&board);
        mus__board_write(&board, &again);
        table_well(&board);
        ck_assert_int_eq(mus_pattern_point_count(again), points[i]);
        mus_pattern_destroy(again);
    }
    mus__board_free(&board);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


/* a square of 1 m whose sides are given as "name:label name:label ..." of equal length, from (0, 0) along x */
static int32_t square_draw(mus__board *board, const char *name, const char *text)
{
    const int32_t panel = mus__board_panel_add(board, name, NULL);
    char side[32], label[32];
    int used, n = 0;
    for (const char *at = text; sscanf(at, " %31[^:]:%31[^ ]%n", side, label, &used) == 2; at += used) n++;
    int k = 0;
    for (const char *at = text; sscanf(at, " %31[^:]:%31[^ ]%n", side, label, &used) == 2; at += used, k++) {
        const double a = 6.283185307179586 * k / n, b = 6.283185307179586 * (k + 1) / n;
        const double start[2] = {cos(a), sin(a)}, end[2] = {cos(b), sin(b)};
        mus__board_line_add(board, panel, side, strcmp(label, "-") == 0 ? "" : label, start, end);
    }
    mus__board_panel_close(board, panel);
    table_well(board);
    return panel;
}


START_TEST(runs_go_over_closed_darts_and_begin_where_they_begin)
{
    static const struct {
        const char *word, *darts, *run;
    } rows[] = {
        {"a:w b:w c:- d:-", "", "a b"},
        {"b:w c:- d:- a:w", "", "a b"},
        {"a:w b:w c:w", "", "a b c"},
        {"c:- a:w d:- e:- b:w f:-", "d e", "a b"},
        {"c:- a:w d:- e:- b:w f:-", "d f", "a"},
        {"c:- a:w d:- e:- b:w f:-", "", "a"},
        {"c:- a:w d:- x:- y:- e:- b:w f:-", "d e x y", "a b"},
        {"c:- a:w d:- e:- x:- y:- b:w f:-", "d e x y", "a b"},
        {"c:- a:w d:- e:- x:- y:- b:w f:-", "d x e y", "a b"},
        {"c:- a:w d:- e:- x:- b:w f:-", "d x", "a"},
        {"e:- b:w f:- a:w d:-", "d e", "a b"},
        {"a:w c:- b:w d:-", "", "a"},
        {"a:v b:- c:-", "", ""},
    };
    mus_context *context = support_context();
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        mus__board board;
        char a[32], b[32], got[128] = "";
        int used;
        mus__board_begin(&board, context, "runs");
        const int32_t panel = square_draw(&board, "p", rows[i].word);
        for (const char *at = rows[i].darts; sscanf(at, " %31s %31s%n", a, b, &used) == 2; at += used)
            mus__board_seam_add(&board, mus__board_find(&board, panel, a), mus__board_find(&board, panel, b),
                                MUS_SEAM_REVERSED, 0.0);
        int32_t sides[16];
        const int32_t n = mus__board_run(&board, panel, "w", sides, 16);
        for (int32_t k = 0; k < n; k++) {
            strcat(got, k == 0 ? "" : " ");
            strcat(got, board.side[sides[k]].name);
        }
        ck_assert_msg(strcmp(got, rows[i].run) == 0, "%s with darts %s: run %s, expected %s", rows[i].word,
                      rows[i].darts, got, rows[i].run);
        ck_assert_int_eq(mus__board_run(&board, panel, "w", sides, 0), n);
        mus__board_free(&board);
    }
    support_context_end(context);
}
END_TEST


START_TEST(places_along_a_side_are_met_and_tangents_are_units)
{
    mus_context *context = support_context();
    sample s = sample_make(context);
    mus__board board;
    mus__board_read(&board, s.pattern);
    const int32_t side = s.edge[2];
    double last[2], xy[2], tangent[2], length = 0.0;
    mus__board_at(&board, side, 0.0, last, tangent);
    ck_assert_mem_eq(last, mus__board_start(&board, side), sizeof last);
    ck_assert(tangent[0] == -1.0 && tangent[1] == 0.0);
    for (int32_t i = 1; i <= 1000; i++) {
        mus__board_at(&board, side, board.side[side].length * i / 1000.0, xy, tangent);
        ck_assert_double_eq_tol(hypot(tangent[0], tangent[1]), 1.0, 1e-12);
        const double step = hypot(xy[0] - last[0], xy[1] - last[1]);
        const double full = board.side[side].length / 1000.0;
        ck_assert(step <= full + 1e-12 && step > 0.99 * full);
        length += step;
        memcpy(last, xy, sizeof last);
    }
    ck_assert_mem_eq(last, mus__board_end(&board, side), sizeof last);
    ck_assert_double_eq_tol(length, board.side[side].length, 1e-6);
    mus__board_at(&board, MUS_NONE, 0.1, xy, tangent);
    ck_assert(xy[0] == 0.0 && tangent[1] == 0.0);
    mus__board_free(&board);
    mus_pattern_destroy(s.pattern);
    support_context_end(context);
}
END_TEST


START_TEST(the_first_failure_stays_and_nothing_is_done_after_it)
{
    mus_context *context = support_context();
    static const double a[2] = {0, 0}, b[2] = {1, 0}, c[2] = {1, 1}, off[2] = {1.0, 2e-6}, far[2] = {2e7, 0};
    static const char *const sentences[] = {"starts",  "length is 0", "x is 2e+07 m", "another",   "needs a name",
                                            "no side", "not closed",  "longer than",   "is closed", "notch on"};
    char long_name[200];
    memset(long_name, 'x', sizeof long_name);
    long_name[199] = '\0';
    for (int32_t i = 0; i < 10; i++) {
        mus__board board;
        mus_pattern *pattern;
        mus__board_begin(&board, context, "fail");
        const int32_t panel = mus__board_panel_add(&board, "p", NULL);
        if (i != 5) mus__board_line_add(&board, panel, "ab", NULL, a, b);
        switch (i) {
        case 0: mus__board_line_add(&board, panel, "bc", NULL, off, c); break;
        case 1: mus__board_line_add(&board, panel, "bb", NULL, b, b); break;
        case 2: mus__board_line_add(&board, panel, "bf", NULL, b, far); break;
        case 3: mus__board_panel_add(&board, "p", NULL); break;
        case 4: mus__board_panel_add(&board, "", NULL); break;
        case 5: mus__board_panel_close(&board, panel); break;
        case 6: mus__board_write(&board, &pattern); break;
        case 7: mus__board_line_add(&board, panel, long_name, NULL, b, c); break;
        case 8:
            mus__board_line_add(&board, panel, "bc", NULL, b, c);
            mus__board_line_add(&board, panel, "ca", NULL, c, a);
            mus__board_panel_close(&board, panel);
            mus__board_line_add(&board, panel, "more", NULL, a, b);
            break;
        default: mus__board_notch_add(&board, 0, 1.1, MUS_NOTCH_SINGLE); break;
        }
        ck_assert_msg(board.status != MUS_OK, "case %d is well", (int)i);
        ck_assert_msg(strstr(mus_context_error(context), sentences[i]) != NULL, "case %d: %s", (int)i,
                      mus_context_error(context));
        const mus_status status = board.status;
        const int32_t nside = board.nside;
        mus__board_fail(&board, MUS_ERR_LIMIT, "later");
        ck_assert_int_eq(mus__board_line_add(&board, panel, "late", NULL, b, c), MUS_NONE);
        ck_assert_int_eq(mus__board_panel_add(&board, "late", NULL), MUS_NONE);
        ck_assert_int_eq(mus__board_split(&board, 0, 0.5, NULL), MUS_NONE);
        mus__board_double(&board);
        mus__board_write(&board, &pattern);
        ck_assert_ptr_null(pattern);
        ck_assert(board.status == status && board.nside == nside);
        ck_assert(strstr(mus_context_error(context), sentences[i]) != NULL);
        mus__board_free(&board);
    }
    support_context_end(context);
}
END_TEST


START_TEST(a_pattern_with_loose_cells_is_refused)
{
    mus_context *context = support_context();
    for (int32_t i = 0; i < 2; i++) {
        sample s = sample_make(context);
        mus__board board;
        if (i == 0)
            ck_assert_int_eq(mus_pattern_add_panel(s.pattern, "empty", NULL), MUS_OK);
        else
            ck_assert_int_eq(mus_pattern_add_edge(s.pattern, &(mus_edge_def){.size = sizeof(mus_edge_def),
                                                                             .name = "loose", .start = s.point[0],
                                                                             .end = s.point[2]}, NULL),
                             MUS_OK);
        mus__board_read(&board, s.pattern);
        ck_assert_int_eq(board.status, MUS_ERR_PATTERN);
        ck_assert_ptr_nonnull(strstr(mus_context_error(context), i == 0 ? "empty" : "front.loose"));
        mus__board_free(&board);
        mus_pattern_destroy(s.pattern);
    }
    support_context_end(context);
}
END_TEST


START_TEST(reading_and_writing_without_memory_fails_and_leaves_nothing)
{
    for (int64_t n = 0;; n++) {
        mus_context *context = support_context();
        mus_pattern *pattern = gluing_make(context, "A: a h b h- c; B: a b", "A.a B.a", 1), *again;
        mus__board board;
        ck_assert_int_eq(mus_pattern_add_mark(pattern, 0, "m", 1, (double[]){0.1, 0.1}, NULL), MUS_OK);
        ck_assert_int_eq(mus_pattern_add_notch(pattern, 0, 0.1, MUS_NOTCH_SINGLE, NULL), MUS_OK);
        ck_assert_int_eq(mus_pattern_add_opening(pattern, "hem"), MUS_OK);
        support_fail_after(n, false);
        mus__board_read(&board, pattern);
        mus__board_write(&board, &again);
        support_fail_never();
        const mus_status status = board.status;
        ck_assert_int_eq(status == MUS_OK, again != NULL);
        mus__board_free(&board);
        mus_pattern_destroy(pattern);
        mus_pattern_destroy(again);
        support_context_end(context);
        if (status == MUS_OK) break;
        ck_assert_int_eq(status, MUS_ERR_MEMORY);
    }
}
END_TEST


Suite *mus_suite_board(void);
Suite *mus_suite_board(void)
{
    Suite *suite = suite_create("board");
    TCase *tcase = tcase_create("board");
    tcase_add_test(tcase, a_pattern_read_and_written_is_the_same);
    tcase_add_test(tcase, an_outline_that_comes_back_to_a_point_still_does);
    tcase_add_test(tcase, runs_go_over_closed_darts_and_begin_where_they_begin);
    tcase_add_test(tcase, places_along_a_side_are_met_and_tangents_are_units);
    tcase_add_test(tcase, the_first_failure_stays_and_nothing_is_done_after_it);
    tcase_add_test(tcase, a_pattern_with_loose_cells_is_refused);
    tcase_add_test(tcase, reading_and_writing_without_memory_fails_and_leaves_nothing);
    suite_add_tcase(suite, tcase);
    return suite;
}
