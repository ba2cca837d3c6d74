/*
 * test_notches_marks.c: notches, marks, grain, cut and placement.
 */
#include <math.h>
#include <stdio.h>

#include "pattern/same.h"


START_TEST(notches_stand_on_their_edge)
{
    mus_context *context = support_context();
    sample s = sample_make(context);
    int32_t notch, edge, kind;
    double at, length = mus_pattern_edge_length(s.pattern, s.edge[2]);
    ck_assert_int_eq(mus_pattern_add_notch(s.pattern, s.edge[2], length + 5e-10, MUS_NOTCH_DOUBLE, &notch), MUS_OK);
    ck_assert_int_eq(mus_pattern_notch(s.pattern, notch, &edge, &at, &kind), MUS_OK);
    ck_assert(edge == s.edge[2] && at == length && kind == MUS_NOTCH_DOUBLE);
    ck_assert_int_eq(mus_pattern_add_notch(s.pattern, s.edge[2], 0.0, MUS_NOTCH_SINGLE, &notch), MUS_OK);

    ck_assert_int_eq(mus_pattern_add_notch(s.pattern, s.edge[0], 0.41, 1, &notch), MUS_ERR_ARG);
    ck_assert_str_eq(mus_context_error(context), "notch on front.hem: 0.41 m is outside the edge, which is 0.4 m long");
    ck_assert_int_eq(notch, MUS_NONE);
    ck_assert_int_eq(mus_pattern_add_notch(s.pattern, s.edge[0], -0.01, 1, &notch), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_add_notch(s.pattern, s.edge[0], (double)NAN, 1, &notch), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_add_notch(s.pattern, s.edge[0], 0.1, 0, &notch), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_add_notch(s.pattern, s.edge[0], 0.1, 4, &notch), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_add_notch(s.pattern, 8, 0.1, 1, &notch), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_add_notch(NULL, 0, 0.1, 1, &notch), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_notch(s.pattern, 4, &edge, NULL, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_notch(NULL, 0, &edge, NULL, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_notch_count(s.pattern), 4);
    mus_pattern_destroy(s.pattern);
    support_context_end(context);
}
END_TEST


START_TEST(marks_keep_their_points)
{
    mus_context *context = support_context();
    sample s = sample_make(context);
    double xy[6] = {0.1, 0.2, 0.3, 0.4, 0.5, (double)INFINITY};
    int32_t mark, panel, n;
    const char *name;
    const double *got;
    ck_assert_int_eq(mus_pattern_add_mark(s.pattern, s.front, NULL, 2, xy, &mark), MUS_OK);
    ck_assert_int_eq(mus_pattern_mark(s.pattern, mark, &panel, &name, &n, &got), MUS_OK);
    ck_assert(panel == s.front && n == 2 && name[0] == '\0');
    ck_assert_mem_eq(got, xy, 4 * sizeof *xy);
    ck_assert_int_eq(mus_pattern_add_mark(s.pattern, s.front, "fold", 3, xy, &mark), MUS_ERR_ARG);
    ck_assert_str_eq(mus_context_error(context), "mark fold: point 2: y is inf m, expected -1e+07 to 1e+07 m");
    ck_assert_int_eq(mark, MUS_NONE);
    ck_assert_int_eq(mus_pattern_add_mark(s.pattern, s.front, "fold", 0, xy, &mark), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_add_mark(s.pattern, s.front, "fold", 2, NULL, &mark), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_add_mark(s.pattern, 7, "fold", 2, xy, &mark), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_add_mark(NULL, 0, "fold", 2, xy, &mark), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_mark(s.pattern, 3, &panel, &name, &n, &got), MUS_ERR_ARG);
    ck_assert(panel == MUS_NONE && name == NULL && n == 0 && got == NULL);
    ck_assert_int_eq(mus_pattern_mark(NULL, 0, NULL, NULL, NULL, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_mark(s.pattern, 0, NULL, NULL, NULL, NULL), MUS_OK);
    mus_pattern_destroy(s.pattern);
    support_context_end(context);
}
END_TEST


START_TEST(grain_is_a_unit_vector_that_survives_writing_and_reading)
{
    mus_context *context = support_context();
    sample s = sample_make(context);
    uint64_t state = 5;
    for (int32_t i = 0; i < 10000; i++) {
        double angle = support_uniform(&state, -4.0, 4.0), scale = exp(support_uniform(&state, -30.0, 30.0)), g[2],
               h[2];
        ck_assert_int_eq(mus_pattern_set_grain(s.pattern, 0, scale * cos(angle), scale * sin(angle)), MUS_OK);
        ck_assert_int_eq(mus_pattern_grain(s.pattern, 0, g), MUS_OK);
        ck_assert_double_eq_tol(hypot(g[0], g[1]), 1.0, 4e-16);
        ck_assert_int_eq(mus_pattern_set_grain(s.pattern, 0, g[0], g[1]), MUS_OK);
        ck_assert_int_eq(mus_pattern_grain(s.pattern, 0, h), MUS_OK);
        ck_assert_mem_eq(g, h, sizeof g);
    }
    double bad[4][2] = {{0.0, 0.0}, {(double)NAN, 1.0}, {1.0, (double)INFINITY}, {1e308, 1.7e308}};
    for (int32_t i = 0; i < 4; i++)
        ck_assert_int_eq(mus_pattern_set_grain(s.pattern, 0, bad[i][0], bad[i][1]), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_set_grain(s.pattern, 2, 0.0, 1.0), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_set_grain(NULL, 0, 0.0, 1.0), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_grain(s.pattern, 2, bad[0]), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_grain(s.pattern, 0, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_grain(NULL, 0, bad[0]), MUS_ERR_ARG);
    mus_pattern_destroy(s.pattern);
    support_context_end(context);
}
END_TEST


START_TEST(no_two_panels_mirror_each_other)
{
    /* a panel that mirrors another is not printed: a ring of mirrors would lose both */
    mus_context *context = support_context();
    sample s = sample_make(context);
    int32_t count, mirror;
    ck_assert_int_eq(mus_pattern_set_cut(s.pattern, s.sleeve, 1, s.front), MUS_OK);
    ck_assert_int_eq(mus_pattern_set_cut(s.pattern, s.front, 2, s.sleeve), MUS_ERR_ARG);
    ck_assert_str_eq(mus_context_error(context), "panel front: it cannot mirror panel sleeve, which mirrors another");
    ck_assert_int_eq(mus_pattern_set_cut(s.pattern, s.front, 2, s.front), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_set_cut(s.pattern, s.front, -1, MUS_NONE), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_set_cut(s.pattern, s.front, 1001, MUS_NONE), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_set_cut(s.pattern, s.front, 1, 2), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_set_cut(s.pattern, 2, 1, MUS_NONE), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_set_cut(NULL, 0, 1, MUS_NONE), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_cut(s.pattern, s.sleeve, &count, &mirror), MUS_OK);
    ck_assert(count == 1 && mirror == s.front);
    ck_assert_int_eq(mus_pattern_cut(s.pattern, s.front, &count, &mirror), MUS_OK);
    ck_assert(count == 1 && mirror == MUS_NONE);
    ck_assert_int_eq(mus_pattern_cut(s.pattern, 2, &count, &mirror), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_cut(NULL, 0, NULL, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_set_panel_label(s.pattern, 2, "x"), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_set_panel_label(NULL, 0, "x"), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_set_panel_label(s.pattern, s.sleeve, NULL), MUS_OK);
    ck_assert_str_eq(mus_pattern_panel_label(s.pattern, s.sleeve), "");
    mus_pattern_destroy(s.pattern);
    support_context_end(context);
}
END_TEST


/* the table of names holds, too, when there are enough panels that it is used */
START_TEST(a_panel_gets_another_name)
{
    mus_context *context = support_context();
    mus_pattern *pattern;
    char name[16];
    int32_t panel = MUS_NONE;
    ck_assert_int_eq(mus_pattern_create(context, "many", &pattern), MUS_OK);
    for (int32_t i = 0; i < 200; i++) {
        snprintf(name, sizeof name, "p%d", (int)i);
        ck_assert_int_eq(mus_pattern_add_panel(pattern, name, NULL), MUS_OK);
    }
    ck_assert_int_eq(mus_pattern_set_panel_name(pattern, 7, "back_left"), MUS_OK);
    ck_assert_int_eq(mus_pattern_set_panel_name(pattern, 7, "back_left"), MUS_OK);
    ck_assert_int_eq(mus_pattern_panel_sides(pattern, 7, NULL), MUS_SIDE_BACK | MUS_SIDE_LEFT);
    ck_assert_int_eq(mus_pattern_find_panel(pattern, "p7"), MUS_NONE);
    ck_assert_int_eq(mus_pattern_find_panel(pattern, "back_left"), 7);
    ck_assert_int_eq(mus_pattern_set_panel_name(pattern, 8, "back_left"), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_set_panel_name(pattern, 8, ""), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_set_panel_name(pattern, 8, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_set_panel_name(pattern, 200, "x"), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_set_panel_name(NULL, 0, "x"), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_add_panel(pattern, "p7", &panel), MUS_OK);
    ck_assert_int_eq(mus_pattern_find_panel(pattern, "p7"), panel);
    for (int32_t i = 8; i < 200; i++) {
        snprintf(name, sizeof name, "p%d", (int)i);
        ck_assert_int_eq(mus_pattern_find_panel(pattern, name), i);
    }
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


START_TEST(a_placement_is_a_rotation)
{
    mus_context *context = support_context();
    sample s = sample_make(context);
    mus_placement good, bad, got;
    mus_placement_init(&good, sizeof good);
    double c = cos(0.7), d = sin(0.7), turn[9] = {c, 0.0, d, 0.0, 1.0, 0.0, -d, 0.0, c};
    memcpy(good.rotation, turn, sizeof turn);
    good.origin[1] = 1.25, good.bend = 0.18, good.bend_x = 0.05;
    ck_assert_int_eq(mus_pattern_set_placement(s.pattern, s.sleeve, &good), MUS_OK);
    mus_placement_init(&got, sizeof got);
    ck_assert_int_eq(mus_pattern_placement(s.pattern, s.sleeve, &got), MUS_OK);
    ck_assert_mem_eq(&got, &good, sizeof got);

    for (int32_t i = 0; i < 7; i++) {
        bad = good;
        if (i == 0) bad.rotation[0] = -c;        /* not orthogonal */
        if (i == 1) bad.rotation[4] = -1.0;      /* a mirror */
        if (i == 2) bad.rotation[8] = c * 1.001; /* scaled */
        if (i == 3) bad.origin[2] = (double)NAN;
        if (i == 4) bad.rotation[3] = (double)INFINITY;
        if (i == 5) bad.bend = 1e-9;
        if (i == 6) bad.bend_x = (double)NAN;
        ck_assert_int_eq(mus_pattern_set_placement(s.pattern, s.sleeve, &bad), MUS_ERR_ARG);
        ck_assert_ptr_nonnull(strstr(mus_context_error(context), "placement of panel sleeve"));
        ck_assert_int_eq(mus_pattern_placement(s.pattern, s.sleeve, &got), MUS_OK);
        ck_assert_mem_eq(&got, &good, sizeof got);
    }
    bad = good;
    bad.size = 0;
    ck_assert_int_eq(mus_pattern_set_placement(s.pattern, s.sleeve, &bad), MUS_ERR_VERSION);
    ck_assert_int_eq(mus_pattern_placement(s.pattern, s.sleeve, &bad), MUS_ERR_VERSION);
    ck_assert_int_eq(mus_pattern_set_placement(s.pattern, s.sleeve, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_set_placement(s.pattern, 2, &good), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_set_placement(NULL, 0, &good), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_placement(s.pattern, 2, &got), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_placement(s.pattern, 0, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_placement(NULL, 0, &got), MUS_ERR_ARG);
    mus_placement_init(NULL, sizeof got);
    mus_pattern_destroy(s.pattern);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_notches_marks(void);


Suite *mus_suite_notches_marks(void)
{
    Suite *suite = suite_create("notches_marks");
    TCase *tcase = tcase_create("marks");
    tcase_add_test(tcase, notches_stand_on_their_edge);
    tcase_add_test(tcase, marks_keep_their_points);
    tcase_add_test(tcase, grain_is_a_unit_vector_that_survives_writing_and_reading);
    tcase_add_test(tcase, no_two_panels_mirror_each_other);
    tcase_add_test(tcase, a_panel_gets_another_name);
    tcase_add_test(tcase, a_placement_is_a_rotation);
    suite_add_tcase(suite, tcase);
    return suite;
}
