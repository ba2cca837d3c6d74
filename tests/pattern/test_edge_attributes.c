/*
 * test_edge_attributes.c: holds and elastics of edges: what is set is what is read, slips are refused, labels
 * reach their edges.
 */
#include "pattern/same.h"

/* a refused edit: the status, and a sentence that holds `words` */
#define REFUSED(call, words)                                                                                           \
    do {                                                                                                               \
        ck_assert_int_eq(call, MUS_ERR_ARG);                                                                           \
        ck_assert_msg(strstr(mus_context_error(context), words) != NULL, "'%s'", mus_context_error(context));          \
    } while (0)


START_TEST(an_edge_keeps_its_hold_and_its_elastic)
{
    mus_context *context = support_context();
    const sample s = sample_make(context);
    mus_pattern *p = s.pattern;
    int32_t level = 99;
    double below = 9.0, ratio = 9.0, stiffness = 9.0;
    ck_assert_int_eq(mus_pattern_edge_hold(p, s.edge[0], &level, &below), MUS_OK);
    ck_assert(level == MUS_HOLD_NONE && below == 0.0);
    ck_assert_int_eq(mus_pattern_edge_elastic(p, s.edge[0], &ratio, &stiffness), MUS_OK);
    ck_assert(ratio == 1.0 && stiffness == 0.0);

    ck_assert_int_eq(mus_pattern_set_edge_hold(p, s.edge[0], MUS_HOLD_WAIST, 0.03), MUS_OK);
    ck_assert_int_eq(mus_pattern_set_edge_elastic(p, s.edge[0], 0.75, 60.0), MUS_OK);
    mus_pattern_edge_hold(p, s.edge[0], &level, &below);
    mus_pattern_edge_elastic(p, s.edge[0], &ratio, &stiffness);
    ck_assert(level == MUS_HOLD_WAIST && below == 0.03 && ratio == 0.75 && stiffness == 60.0);

    /* let go: as it was */
    ck_assert_int_eq(mus_pattern_set_edge_hold(p, s.edge[0], MUS_HOLD_NONE, 0.03), MUS_OK);
    ck_assert_int_eq(mus_pattern_set_edge_elastic(p, s.edge[0], 0.75, 0.0), MUS_OK);
    mus_pattern_edge_hold(p, s.edge[0], &level, &below);
    mus_pattern_edge_elastic(p, s.edge[0], &ratio, &stiffness);
    ck_assert(level == MUS_HOLD_NONE && below == 0.0 && ratio == 1.0 && stiffness == 0.0);
    ck_assert_int_eq(mus_pattern_edge_hold(p, s.edge[0], NULL, NULL), MUS_OK);
    ck_assert_int_eq(mus_pattern_edge_elastic(p, s.edge[0], NULL, NULL), MUS_OK);
    mus_pattern_destroy(p);
    support_context_end(context);
}
END_TEST


START_TEST(slips_are_refused_and_change_nothing)
{
    mus_context *context = support_context();
    const sample s = sample_make(context);
    mus_pattern *p = s.pattern, *before;
    ck_assert_int_eq(mus_pattern_copy(p, &before), MUS_OK);
    REFUSED(mus_pattern_set_edge_hold(p, s.edge[0], MUS_HOLD_COUNT, 0.0), "front.hem: hold 12 is not one of 0 to 11");
    REFUSED(mus_pattern_set_edge_hold(p, s.edge[0], -1, 0.0), "hold -1");
    REFUSED(mus_pattern_set_edge_hold(p, s.edge[0], MUS_HOLD_WAIST, 3.0), "held 3 m below the waist");
    REFUSED(mus_pattern_set_edge_hold(p, 99, MUS_HOLD_WAIST, 0.0), "edge 99 is unknown");
    REFUSED(mus_pattern_hold_label(p, "", MUS_HOLD_WAIST, 0.0, NULL), "NULL or empty");
    REFUSED(mus_pattern_hold_label(p, "hem", 77, 0.0, NULL), "hem: hold 77");
    REFUSED(mus_pattern_set_edge_elastic(p, s.edge[0], 1.5, 20.0), "an elastic of 1.5 times its length");
    REFUSED(mus_pattern_set_edge_elastic(p, s.edge[0], 0.5, -1.0), "stiffness of its elastic is -1 N");
    REFUSED(mus_pattern_set_edge_elastic(p, 99, 0.5, 1.0), "edge 99 is unknown");
    REFUSED(mus_pattern_edge_hold(p, 99, NULL, NULL), "edge 99 is unknown");
    REFUSED(mus_pattern_edge_elastic(p, 99, NULL, NULL), "edge 99 is unknown");
    same_pattern(before, p);
    ck_assert_int_eq(mus_pattern_set_edge_hold(NULL, 0, 0, 0.0), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_set_edge_elastic(NULL, 0, 1.0, 0.0), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_hold_label(NULL, "hem", 0, 0.0, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_edge_hold(NULL, 0, NULL, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_edge_elastic(NULL, 0, NULL, NULL), MUS_ERR_ARG);
    mus_pattern_destroy(before);
    mus_pattern_destroy(p);
    support_context_end(context);
}
END_TEST


START_TEST(a_label_reaches_all_its_edges_and_names_are_found)
{
    mus_context *context = support_context();
    const sample s = sample_make(context);
    mus_pattern *p = s.pattern;
    int32_t count = -1, level;
    double below;
    ck_assert_int_eq(mus_pattern_set_edge_label(p, s.edge[5], "hem"), MUS_OK);
    ck_assert_int_eq(mus_pattern_hold_label(p, "hem", MUS_HOLD_KNEE, -0.05, &count), MUS_OK);
    ck_assert_int_eq(count, 2);
    for (int32_t i = 0; i < 8; i += 5) {
        mus_pattern_edge_hold(p, s.edge[i], &level, &below);
        ck_assert(level == MUS_HOLD_KNEE && below == -0.05);
    }
    ck_assert_int_eq(mus_pattern_hold_label(p, "no such label", MUS_HOLD_KNEE, 0.0, &count), MUS_OK);
    ck_assert_int_eq(count, 0);
    for (int32_t i = 0; i < MUS_HOLD_COUNT; i++) ck_assert_int_eq(mus_hold_find(mus_hold_name(i)), i);
    ck_assert_str_eq(mus_hold_name(MUS_HOLD_WAIST), "waist");
    ck_assert_ptr_null(mus_hold_name(-1));
    ck_assert_ptr_null(mus_hold_name(MUS_HOLD_COUNT));
    ck_assert_int_eq(mus_hold_find("moon"), MUS_NONE);
    ck_assert_int_eq(mus_hold_find(NULL), MUS_NONE);
    mus_pattern_destroy(p);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_edge_attributes(void);


Suite *mus_suite_edge_attributes(void)
{
    Suite *suite = suite_create("edge_attributes");
    TCase *tests = tcase_create("stay");
    tcase_add_test(tests, an_edge_keeps_its_hold_and_its_elastic);
    tcase_add_test(tests, slips_are_refused_and_change_nothing);
    tcase_add_test(tests, a_label_reaches_all_its_edges_and_names_are_found);
    suite_add_tcase(suite, tests);
    return suite;
}
