/*
 * test_panels_edges_points.c: panels, points, edges and outlines: what is given comes back to the bit, what is wrong is
 * refused.
 */
#include <math.h>
#include <stdio.h>
#include <time.h>

#include "pattern/same.h"


START_TEST(a_chain_comes_back_to_the_bit)
{
    mus_context *context = support_context();
    mus_pattern *pattern;
    int32_t panel, a, b, edge;
    ck_assert_int_eq(mus_pattern_create(context, "chain", &pattern), MUS_OK);
    ck_assert_int_eq(mus_pattern_add_panel(pattern, "p", &panel), MUS_OK);
    ck_assert_int_eq(mus_pattern_add_point(pattern, panel, 0.1, -0.0, &a), MUS_OK);
    ck_assert_int_eq(mus_pattern_add_point(pattern, panel, 1.0 / 3.0, 5e-324, &b), MUS_OK);

    /* line, cubic, arc, quadratic: 0 + 1, 2 + 1, 1 + 1, 1 */
    int32_t kinds[4] = {MUS_PIECE_LINE, MUS_PIECE_CUBIC, MUS_PIECE_ARC, MUS_PIECE_QUADRATIC};
    double xy[14];
    for (int32_t i = 0; i < 14; i++) xy[i] = 0.1 * i + 1.0 / (3.0 + i);
    xy[10] = xy[6], xy[11] = xy[7] + 2.0, xy[8] = xy[6] - 0.3, xy[9] = xy[7] + 1.0;
    ck_assert_int_eq(mus_pattern_add_edge(pattern, &(mus_edge_def){.size = sizeof(mus_edge_def), .name = "long",
                                                                   .start = a, .end = b, .npiece = 4,
                                                                   .kinds = kinds, .nxy = 7, .xy = xy}, &edge), MUS_OK);

    int32_t npiece, nxy, start, end;
    const int32_t *got;
    const double *points;
    ck_assert_int_eq(mus_pattern_edge_pieces(pattern, edge, &npiece, &got, &nxy, &points), MUS_OK);
    ck_assert_int_eq(npiece, 4);
    ck_assert_int_eq(nxy, 9);
    double ends[4] = {0.1, -0.0, 1.0 / 3.0, 5e-324};
    ck_assert_mem_eq(got, kinds, sizeof kinds);
    ck_assert_mem_eq(points, ends, 2 * sizeof *ends);
    ck_assert_mem_eq(points + 2, xy, sizeof xy);
    ck_assert_mem_eq(points + 16, ends + 2, 2 * sizeof *ends);
    ck_assert_int_eq(mus_pattern_edge_ends(pattern, edge, &start, &end), MUS_OK);
    ck_assert(start == a && end == b);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


START_TEST(views_stay_put_while_other_cells_are_added)
{
    /* a chain read from the pattern may be written back to it: into the same plane, under the same name */
    mus_context *context = support_context();
    sample s = sample_make(context);
    int32_t npiece, nxy, edge, n;
    const int32_t *kinds, *edges, *directions;
    const double *xy;
    ck_assert_int_eq(mus_pattern_edge_pieces(s.pattern, s.edge[2], &npiece, &kinds, &nxy, &xy), MUS_OK);
    for (int32_t i = 0; i < 100; i++) {
        const char *name = mus_pattern_edge_name(s.pattern, s.edge[0]);
        ck_assert_int_eq(
            mus_pattern_add_edge(s.pattern, &(mus_edge_def){.size = sizeof(mus_edge_def), .name = name,
                                                            .start = s.point[2], .end = s.point[3],
                                                            .npiece = npiece, .kinds = kinds, .nxy = nxy - 2,
                                                            .xy = xy + 2}, &edge),
            MUS_OK);
        ck_assert_str_eq(mus_pattern_edge_name(s.pattern, edge), "hem");
    }
    double length = mus_pattern_edge_length(s.pattern, edge);
    ck_assert(length == mus_pattern_edge_length(s.pattern, s.edge[2]));
    ck_assert_int_eq(mus_pattern_outline(s.pattern, s.front, &n, &edges, &directions), MUS_OK);
    ck_assert_int_eq(mus_pattern_set_outline(s.pattern, s.front, n, edges, directions), MUS_OK);
    ck_assert_int_eq(mus_pattern_outline(s.pattern, s.front, &n, &edges, &directions), MUS_OK);
    ck_assert_mem_eq(edges, s.edge, 4 * sizeof *edges);
    mus_pattern_destroy(s.pattern);
    support_context_end(context);
}
END_TEST


START_TEST(defaults_are_those_of_the_header)
{
    mus_context *context = support_context();
    mus_pattern *pattern;
    int32_t panel, count, mirror, n;
    const int32_t *edges, *directions;
    double grain[2];
    ck_assert_int_eq(mus_pattern_create(context, NULL, &pattern), MUS_OK);
    ck_assert_str_eq(mus_pattern_name(pattern), "");
    ck_assert_int_eq(mus_pattern_add_panel(pattern, "p", &panel), MUS_OK);
    ck_assert_str_eq(mus_pattern_panel_label(pattern, panel), "");
    ck_assert_int_eq(mus_pattern_grain(pattern, panel, grain), MUS_OK);
    ck_assert(grain[0] == 0.0 && grain[1] == 1.0);
    ck_assert_int_eq(mus_pattern_cut(pattern, panel, &count, &mirror), MUS_OK);
    ck_assert(count == 1 && mirror == MUS_NONE);
    ck_assert_int_eq(mus_pattern_outline(pattern, panel, &n, &edges, &directions), MUS_OK);
    ck_assert(n == 0 && edges == NULL && directions == NULL);
    ck_assert(isnan(mus_pattern_panel_area(pattern, panel)) && isnan(mus_pattern_panel_perimeter(pattern, panel)));
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


/* a refused edit: the status, a sentence that holds `words`, and the pattern as it was */
#define REFUSED(call, words)                                                                                           \
    do {                                                                                                               \
        ck_assert_int_eq(call, MUS_ERR_ARG);                                                                           \
        ck_assert_msg(strstr(mus_context_error(context), words) != NULL, "'%s'", mus_context_error(context));          \
        same_pattern(s.pattern, before);                                                                               \
    } while (0)


START_TEST(wrong_panels_and_points_are_refused)
{
    mus_context *context = support_context();
    sample s = sample_make(context);
    mus_pattern *before;
    int32_t out = 5;
    ck_assert_int_eq(mus_pattern_copy(s.pattern, &before), MUS_OK);
    REFUSED(mus_pattern_add_panel(s.pattern, NULL, &out), "needs a name");
    ck_assert_int_eq(out, MUS_NONE);
    REFUSED(mus_pattern_add_panel(s.pattern, "", &out), "needs a name");
    REFUSED(mus_pattern_add_panel(s.pattern, "front", &out), "panel front: panel 0 has this name already");
    REFUSED(mus_pattern_add_point(s.pattern, 2, 0.0, 0.0, &out), "panel 2 is unknown, the pattern has 2");
    REFUSED(mus_pattern_add_point(s.pattern, -1, 0.0, 0.0, &out), "panel -1 is unknown");
    REFUSED(mus_pattern_add_point(s.pattern, 0, (double)NAN, 0.0, &out), "x is nan m, expected -1e+07 to 1e+07 m");
    REFUSED(mus_pattern_add_point(s.pattern, 0, 0.0, (double)-INFINITY, &out), "front: y is -inf m, expected");
    ck_assert_int_eq(mus_pattern_add_panel(NULL, "x", &out), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_add_point(NULL, 0, 0.0, 0.0, &out), MUS_ERR_ARG);
    mus_pattern_destroy(before);
    mus_pattern_destroy(s.pattern);
    support_context_end(context);
}
END_TEST


START_TEST(wrong_edges_are_refused)
{
    mus_context *context = support_context();
    sample s = sample_make(context);
    mus_pattern *before, *p = s.pattern;
    ck_assert_int_eq(mus_pattern_copy(p, &before), MUS_OK);
    int32_t line = MUS_PIECE_LINE, cubic = MUS_PIECE_CUBIC, wrong = 4, a = s.point[0], b = s.point[1], out;
    double xy[4] = {0.1, 0.1, (double)NAN, 0.3}, far[4] = {1e200, 1e308, -1e308, 1e308}, same[4] = {0.0};
    REFUSED(mus_pattern_add_edge(p, &(mus_edge_def){.size = sizeof(mus_edge_def), .name = "e", .start = 8,
                                                    .end = b}, &out), "point 8 is unknown, the pattern has 8");
    REFUSED(mus_pattern_add_edge(p, &(mus_edge_def){.size = sizeof(mus_edge_def), .name = "e", .start = a,
                                                    .end = -1}, &out), "point -1 is unknown");
    REFUSED(mus_pattern_add_edge(p, &(mus_edge_def){.size = sizeof(mus_edge_def), .name = "e", .start = a,
                                                    .end = s.point[4]}, &out), "panel 1");
    REFUSED(mus_pattern_add_edge(p, &(mus_edge_def){.size = sizeof(mus_edge_def), .name = "e", .start = a,
                                                    .end = b, .nxy = 1, .xy = xy}, &out), "take 0");
    REFUSED(mus_pattern_add_edge(p, NULL, &out), "its def is NULL");
    REFUSED(mus_pattern_add_edge(p, &(mus_edge_def){.size = sizeof(mus_edge_def), .name = "e", .start = a,
                                                    .end = b, .npiece = -3, .kinds = &line}, &out), "-3 pieces");
    REFUSED(mus_pattern_add_edge(p, &(mus_edge_def){.size = sizeof(mus_edge_def), .name = "e", .start = a,
                                                    .end = b, .npiece = 1, .kinds = NULL}, &out), "pieces");
    REFUSED(mus_pattern_add_edge(p, &(mus_edge_def){.size = sizeof(mus_edge_def), .name = "e", .start = a,
                                                    .end = b, .npiece = 1, .kinds = &wrong}, &out), "kind 4");
    REFUSED(mus_pattern_add_edge(p, &(mus_edge_def){.size = sizeof(mus_edge_def), .name = "e", .start = a,
                                                    .end = b, .npiece = 1, .kinds = &line, .nxy = 1, .xy = xy},
                                 &out), "1 points given, its 1 pieces take 0");
    REFUSED(mus_pattern_add_edge(p, &(mus_edge_def){.size = sizeof(mus_edge_def), .name = "e", .start = a,
                                                    .end = b, .npiece = 1, .kinds = &cubic, .nxy = 1, .xy = xy},
                                 &out), "take 2");
    REFUSED(mus_pattern_add_edge(p, &(mus_edge_def){.size = sizeof(mus_edge_def), .name = "e", .start = a,
                                                    .end = b, .npiece = 1, .kinds = &cubic, .nxy = 2}, &out), "take 2");
    REFUSED(mus_pattern_add_edge(p, &(mus_edge_def){.size = sizeof(mus_edge_def), .name = "e", .start = a,
                                                    .end = b, .npiece = 1, .kinds = &cubic, .nxy = 2, .xy = xy},
                                 &out), "point 1: x is nan m");
    REFUSED(mus_pattern_add_edge(p, &(mus_edge_def){.size = sizeof(mus_edge_def), .name = "e", .start = a,
                                                    .end = a}, &out), "its length is 0 m");
    REFUSED(mus_pattern_add_edge(p, &(mus_edge_def){.size = sizeof(mus_edge_def), .name = "e", .start = a,
                                                    .end = a, .npiece = 1, .kinds = &cubic, .nxy = 2, .xy = same},
                                 &out), "its length is 0 m");
    REFUSED(mus_pattern_add_edge(p, &(mus_edge_def){.size = sizeof(mus_edge_def), .name = "e", .start = a,
                                                    .end = b, .npiece = 1, .kinds = &cubic, .nxy = 2, .xy = far},
                                 &out), "point 0: x is 1e+200 m, expected");
    int32_t arc = MUS_PIECE_ARC;
    double middle[2] = {0.1, 0.2};
    REFUSED(mus_pattern_add_edge(p, &(mus_edge_def){.size = sizeof(mus_edge_def), .name = "e", .start = a,
                                                    .end = b, .npiece = 1, .kinds = &arc, .nxy = 1, .xy = middle},
                                 &out),
            "middle point of arc 0 is 0.223607 m from one");
    ck_assert_int_eq(out, MUS_NONE);
    ck_assert_int_eq(mus_pattern_add_edge(NULL, &(mus_edge_def){.size = sizeof(mus_edge_def), .name = "e",
                                                                .start = a, .end = b}, &out), MUS_ERR_ARG);

    REFUSED(mus_pattern_set_edge_allowance(p, s.edge[0], -0.001), "outside 0 to 0.2 m");
    REFUSED(mus_pattern_set_edge_allowance(p, s.edge[0], 0.201), "edge front.hem");
    REFUSED(mus_pattern_set_edge_allowance(p, 99, 0.01), "edge 99 is unknown");
    REFUSED(mus_pattern_set_edge_label(p, 99, "hem"), "edge 99 is unknown");
    REFUSED(mus_pattern_set_edge_label(p, 0, "\xFF"), "UTF-8");
    ck_assert_int_eq(mus_pattern_set_edge_allowance(p, s.edge[0], (double)NAN), MUS_OK);
    ck_assert(isnan(mus_pattern_edge_allowance(p, s.edge[0])));
    ck_assert_int_eq(mus_pattern_set_edge_label(p, s.edge[0], NULL), MUS_OK);
    ck_assert_str_eq(mus_pattern_edge_label(p, s.edge[0]), "");
    mus_pattern_destroy(before);
    mus_pattern_destroy(p);
    support_context_end(context);
}
END_TEST


START_TEST(an_outline_is_a_closed_word_of_its_own_edges)
{
    mus_context *context = support_context();
    sample s = sample_make(context);
    mus_pattern *before, *p = s.pattern;
    ck_assert_int_eq(mus_pattern_copy(p, &before), MUS_OK);
    int32_t along[4] = {1, 1, 1, 1}, mixed[4] = {1, -1, 1, 1}, wrong[4] = {1, 1, 0, 1}, *e = s.edge;
    int32_t gap[3] = {e[0], e[2], e[3]}, other[4] = {e[0], e[1], e[6], e[3]}, none[4] = {e[0], 99, e[2], e[3]};
    REFUSED(mus_pattern_set_outline(p, 2, 4, e, along), "panel 2 is unknown");
    REFUSED(mus_pattern_set_outline(p, 0, 0, e, along), "0 edges");
    REFUSED(mus_pattern_set_outline(p, 0, 4, NULL, along), "it needs 1 or more");
    REFUSED(mus_pattern_set_outline(p, 0, 4, e, NULL), "it needs 1 or more");
    REFUSED(mus_pattern_set_outline(p, 0, 4, none, along), "edge 99 is unknown");
    REFUSED(mus_pattern_set_outline(p, 0, 4, other, along), "edge sleeve.edge_6 is of another panel");
    REFUSED(mus_pattern_set_outline(p, 0, 4, e, wrong), "direction 0");
    REFUSED(mus_pattern_set_outline(p, 0, 4, e, mixed), "starts at point 2, the one before ends at point 1");
    REFUSED(mus_pattern_set_outline(p, 0, 3, gap, along),
            "outline of panel front: edge front.edge_2 starts at point 2");
    REFUSED(mus_pattern_set_outline(p, 0, 3, e, along),
            "edge front.hem starts at point 0, the one before ends at point 3");

    /* against all edges is a closed word as well, and half of it is not */
    int32_t turned[4] = {e[3], e[2], e[1], e[0]}, back[4] = {-1, -1, -1, -1};
    ck_assert_int_eq(mus_pattern_set_outline(p, 0, 4, turned, back), MUS_OK);
    mus_pattern_destroy(before);
    mus_pattern_destroy(p);
    support_context_end(context);
}
END_TEST


START_TEST(getters_refuse_what_is_not_there)
{
    mus_context *context = support_context();
    sample s = sample_make(context);
    const mus_pattern *p = s.pattern;
    int32_t n = 5, m = 5;
    const int32_t *list;
    const double *xy;
    ck_assert_ptr_null(mus_pattern_panel_name(p, 2));
    ck_assert_ptr_null(mus_pattern_panel_label(p, -1));
    ck_assert_ptr_null(mus_pattern_edge_name(p, 8));
    ck_assert_ptr_null(mus_pattern_edge_label(p, -1));
    ck_assert_ptr_null(mus_pattern_edge_label(NULL, 0));
    ck_assert(isnan(mus_pattern_edge_allowance(p, 8)) && isnan(mus_pattern_edge_length(p, 8)));
    ck_assert(isnan(mus_pattern_panel_area(p, 2)) && isnan(mus_pattern_panel_perimeter(NULL, 0)));
    ck_assert_int_eq(mus_pattern_edge_panel(p, 8), MUS_NONE);
    ck_assert_int_eq(mus_pattern_edge_seam(p, 8), MUS_NONE);
    ck_assert_int_eq(mus_pattern_edge_ends(p, 8, &n, &m), MUS_ERR_ARG);
    ck_assert(n == MUS_NONE && m == MUS_NONE);
    ck_assert_int_eq(mus_pattern_edge_ends(p, 1, NULL, NULL), MUS_OK);
    ck_assert_int_eq(mus_pattern_edge_pieces(p, 8, &n, &list, &m, &xy), MUS_ERR_ARG);
    ck_assert(n == 0 && m == 0 && list == NULL && xy == NULL);
    ck_assert_int_eq(mus_pattern_edge_pieces(p, 1, NULL, NULL, NULL, NULL), MUS_OK);
    ck_assert_int_eq(mus_pattern_point(p, 8, &n, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_point(p, 7, NULL, NULL), MUS_OK);
    ck_assert_int_eq(mus_pattern_outline(p, 2, &n, &list, &list), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_outline(p, 1, NULL, NULL, NULL), MUS_OK);
    ck_assert_int_eq(mus_pattern_outline(NULL, 0, &n, NULL, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_edge_ends(NULL, 0, NULL, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_edge_pieces(NULL, 0, NULL, NULL, NULL, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_point(NULL, 0, NULL, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_set_outline(NULL, 0, 0, NULL, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_set_edge_label(NULL, 0, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_set_edge_allowance(NULL, 0, 0.0), MUS_ERR_ARG);
    mus_pattern_destroy(s.pattern);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_panels_edges_points(void);


/* 100,000 panels: a walk over the names took 8 s for 30,000 of them under the address sanitizer */
START_TEST(many_panels_are_added_and_found_in_linear_time)
{
    enum { MANY = 100000 };
    mus_context *context = support_context();
    mus_pattern *pattern, *copy;
    char name[32];
    int32_t out;
    ck_assert_int_eq(mus_pattern_create(context, "many", &pattern), MUS_OK);
    const clock_t start = clock();
    for (int32_t i = 0; i < MANY; i++) {
        snprintf(name, sizeof name, "panel %d", (int)i);
        ck_assert_int_eq(mus_pattern_add_panel(pattern, name, &out), MUS_OK);
    }
    ck_assert_double_lt((double)(clock() - start) / CLOCKS_PER_SEC, SUPPORT_SLOW ? 10.0 : 1.0);
    ck_assert_int_eq(mus_pattern_add_panel(pattern, "panel 77777", &out), MUS_ERR_ARG);
    ck_assert_str_eq(mus_context_error(context), "panel panel 77777: panel 77777 has this name already");
    ck_assert_int_eq(mus_pattern_find_panel(pattern, "panel 99999"), MANY - 1);
    ck_assert_int_eq(mus_pattern_find_panel(pattern, "panel 100000"), MUS_NONE);

    /* a copy has no table until a panel is added to it; the memory for the table may be missing */
    ck_assert_int_eq(mus_pattern_copy(pattern, &copy), MUS_OK);
    ck_assert_int_eq(mus_pattern_find_panel(copy, "panel 5"), 5);
    support_fail_after(0, false);
    ck_assert_int_eq(mus_pattern_add_panel(copy, "new", &out), MUS_ERR_MEMORY);
    support_fail_never();
    ck_assert_int_eq(mus_pattern_panel_count(copy), MANY);
    ck_assert_int_eq(mus_pattern_add_panel(copy, "panel 5", &out), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_add_panel(copy, "new", &out), MUS_OK);
    ck_assert_int_eq(mus_pattern_find_panel(copy, "new"), MANY);
    mus_pattern_destroy(copy);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_panels_edges_points(void)
{
    Suite *suite = suite_create("panels_edges_points");
    TCase *tcase = tcase_create("cells");
    tcase_add_test(tcase, a_chain_comes_back_to_the_bit);
    tcase_add_test(tcase, views_stay_put_while_other_cells_are_added);
    tcase_add_test(tcase, defaults_are_those_of_the_header);
    tcase_add_test(tcase, wrong_panels_and_points_are_refused);
    tcase_add_test(tcase, wrong_edges_are_refused);
    tcase_add_test(tcase, an_outline_is_a_closed_word_of_its_own_edges);
    tcase_add_test(tcase, getters_refuse_what_is_not_there);
    tcase_add_test(tcase, many_panels_are_added_and_found_in_linear_time);
    suite_add_tcase(suite, tcase);
    return suite;
}
