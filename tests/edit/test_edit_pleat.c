/*
 * test_edit_pleat.c: pleats laid on an edge: what shows is sewn, what lies under it is sewn to it.
 */
#include <string.h>

#include "edit/edits.h"


/* Counts the edges of a panel whose names begin so; *length gets the sum of their lengths [m]. */
static int32_t parts(const mus_pattern *pattern, int32_t panel, const char *name, double *length)
{
    int32_t n, count = 0;
    const int32_t *edges;
    mus_pattern_outline(pattern, panel, &n, &edges, NULL);
    *length = 0.0;
    for (int32_t i = 0; i < n; i++) {
        if (strncmp(mus_pattern_edge_name(pattern, edges[i]), name, strlen(name)) != 0) continue;
        *length += mus_pattern_edge_length(pattern, edges[i]);
        count++;
    }
    return count;
}


/* the centre of the sample's front, 0.4 m, sewn to a sleeve's: four places to a pleat, two seams that lay it */
START_TEST(a_pleat_parts_its_edge_in_four)
{
    mus_context *context = support_context();
    sample s = sample_make(context);
    mus_pattern *pattern = s.pattern;
    const double at[2] = {0.1, 0.2}, depth[2] = {0.03, -0.02};
    const int32_t edge = s.edge[3], seams = mus_pattern_seam_count(pattern), faults = edit_faults(pattern);
    const int32_t n = _i + 1, made = n == 1 ? 5 : 8;
    double length;
    edit_well(mus_pattern_lay_pleats(pattern, edge, n, at, depth));
    ck_assert_int_eq(edit_faults(pattern), faults);
    ck_assert_int_eq(parts(pattern, 0, "centre", &length), made);
    ck_assert_double_eq_tol(length, 0.4, 1e-12);

    /* 2 n parts lie under others; each of the rest has a part of the seam */
    ck_assert_int_eq(mus_pattern_seam_count(pattern), seams - 1 + 2 * n + made - 2 * n);

    /* under what comes before: the fold is at the end of what shows */
    int32_t laid = 0, closed = 0;
    for (int32_t i = 0; i < mus_pattern_seam_count(pattern); i++) {
        mus_seam_def seam;
        mus_seam_def_init(&seam, sizeof seam);
        mus_pattern_seam(pattern, i, &seam);
        laid += seam.laid;
        closed += seam.closure != MUS_CLOSURE_NONE || seam.open || seam.buttons;
        if (!seam.laid) continue;
        ck_assert_int_eq(seam.direction, MUS_SEAM_REVERSED);
        ck_assert_double_eq_tol(mus_pattern_edge_length(pattern, seam.edge_a),
                                mus_pattern_edge_length(pattern, seam.edge_b), 1e-12);
    }
    ck_assert_int_eq(laid, 2 * n);
    ck_assert_int_eq(closed, 0);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


START_TEST(pleats_that_do_not_fit_are_refused)
{
    mus_context *context = support_context();
    mus_pattern *pattern = edit_skirt(context);
    const int32_t hem = edit_edge(pattern, "skirt_front", "hem");
    const double early[1] = {0.01}, late[1] = {10.0}, close[2] = {0.1, 0.15}, deep[2] = {0.05, 0.05}, none[1] = {0.0};
    const uint64_t before = edit_bytes(pattern);
    ck_assert_int_eq(mus_pattern_lay_pleats(pattern, hem, 1, early, deep), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_lay_pleats(pattern, hem, 1, late, deep), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_lay_pleats(pattern, hem, 2, close, deep), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_lay_pleats(pattern, hem, 1, close, none), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_lay_pleats(pattern, hem, 0, close, deep), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_lay_pleats(pattern, hem, 257, close, deep), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_lay_pleats(pattern, hem, 1, NULL, deep), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_lay_pleats(pattern, -1, 1, close, deep), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_lay_pleats(NULL, hem, 1, close, deep), MUS_ERR_ARG);
    ck_assert(edit_bytes(pattern) == before);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_edit_pleat(void);


Suite *mus_suite_edit_pleat(void)
{
    Suite *suite = suite_create("edit_pleat");
    TCase *tests = tcase_create("pleat");
    tcase_add_loop_test(tests, a_pleat_parts_its_edge_in_four, 0, 2);
    tcase_add_test(tests, pleats_that_do_not_fit_are_refused);
    suite_add_tcase(suite, tests);
    return suite;
}
