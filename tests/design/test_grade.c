/*
 * test_grade.c: grade rules against steps measured on drafts of an independent script, rules applied against the next
 * draft, ease against the eases that a draft was asked for.
 */
#include <string.h>

#include "block/drafts.h"
#include "muslin/topology.h"

#define MOST 400


/* the rule of the point that an edge begins at, in centimetres */
static void rule_of(const mus_pattern *pattern, const double *rules, const char *panel, const char *edge, double *out)
{
    int32_t start;
    ck_assert_int_eq(mus_pattern_edge_ends(pattern, drafts_edge(pattern, panel, edge), &start, NULL), MUS_OK);
    for (int k = 0; k < 2; k++) out[k] = rules[2 * start + k] / CM;
}


/* reference 4.10: sizes W38 to 40 to 42, (dx, dy) in cm */
static const struct {
    const char *design, *panel, *edge;
    double dx, dy;
} steps[] = {
    {"bodice", "front_left", "cf", 0.0, 0.14},      {"bodice", "front_left", "neck", 0.09, 0.29},
    {"bodice", "front_left", "sh", 0.24, 0.22},     {"bodice", "front_left", "arm", 0.90, -0.16},
    {"bodice", "front_left", "side1", 1.00, 0.0},   {"bodice", "front_left", "wd2", 0.40, -0.69},
    {"bodice", "back_right", "cb", 0.0, 0.12},      {"bodice", "back_right", "neck", 0.09, 0.15},
    {"bodice", "back_right", "sh", 0.24, 0.09},     {"bodice", "back_right", "arm", 1.00, -0.28},
};


START_TEST(rules_are_the_steps_of_the_reference)
{
    static const char *const sizes[3] = {"W38", "W40", "W42"};
    mus_context *context = support_context();
    mus_pattern *draft[3];
    double rules[2][2 * MOST];
    for (int i = 0; i < 3; i++) draft[i] = drafts_pattern(context, "bodice", sizes[i]);
    for (int i = 0; i < 2; i++) {
        int32_t count;
        ck_assert_int_le(mus_pattern_point_count(draft[i]), MOST);
        ck_assert_int_eq(mus_design_grade(draft[i], draft[i + 1], rules[i], &count), MUS_OK);
        ck_assert_int_eq(count, mus_pattern_point_count(draft[i]));
    }
    for (size_t k = 0; k < sizeof steps / sizeof *steps; k++)
        for (int i = 0; i < 2; i++) {
            double rule[2];
            rule_of(draft[i], rules[i], steps[k].panel, steps[k].edge, rule);
            ck_assert_msg(fabs(rule[0] - steps[k].dx) < GOLDEN && fabs(rule[1] - steps[k].dy) < GOLDEN,
                          "%s to %s, %s of %s: (%.3f, %.3f), expected (%.2f, %.2f)", sizes[i], sizes[i + 1],
                          steps[k].edge, steps[k].panel, rule[0], rule[1], steps[k].dx, steps[k].dy);
        }
    for (int i = 0; i < 3; i++) mus_pattern_destroy(draft[i]);
    support_context_end(context);
}
END_TEST


/* rules of 38 to 40 on 40 give 42: within 0.1 mm at the points of the reference, 2.5 mm at all others */
START_TEST(rules_of_one_step_make_the_next_size)
{
    mus_context *context = support_context();
    mus_pattern *small = drafts_pattern(context, "bodice", "W38"), *own = drafts_pattern(context, "bodice", "W40");
    mus_pattern *large = drafts_pattern(context, "bodice", "W42"), *graded;
    double rules[2 * MOST], off[2 * MOST];
    int32_t faults;
    ck_assert_int_eq(mus_design_grade(small, own, rules, NULL), MUS_OK);
    ck_assert_int_eq(mus_design_grade_apply(own, rules, &graded), MUS_OK);
    ck_assert_int_eq(mus_design_grade(graded, large, off, NULL), MUS_OK);
    for (size_t k = 0; k < sizeof steps / sizeof *steps; k++) {
        double rule[2];
        rule_of(graded, off, steps[k].panel, steps[k].edge, rule);
        ck_assert_double_lt(hypot(rule[0], rule[1]), 0.01);
    }
    for (int32_t p = 0; p < mus_pattern_point_count(graded); p++)
        ck_assert_double_lt(hypot(off[2 * p], off[2 * p + 1]), 0.25 * CM);
    ck_assert_int_eq(mus_pattern_check(graded, &faults, NULL), MUS_OK);
    ck_assert_int_eq(faults, 0);

    /* a rule of nothing leaves every length */
    mus_pattern *same;
    memset(rules, 0, sizeof rules);
    ck_assert_int_eq(mus_design_grade_apply(own, rules, &same), MUS_OK);
    for (int32_t e = 0; e < mus_pattern_edge_count(own); e++)
        ck_assert_double_eq(mus_pattern_edge_length(same, e), mus_pattern_edge_length(own, e));
    mus_pattern_destroy(small);
    mus_pattern_destroy(own);
    mus_pattern_destroy(large);
    mus_pattern_destroy(graded);
    mus_pattern_destroy(same);
    support_context_end(context);
}
END_TEST


/* the ease asked for is the ease of the draft, measured on its panels */
START_TEST(ease_is_what_was_asked)
{
    mus_context *context = support_context();
    mus_tape *tape = drafts_tape(context, "W40");
    mus_draft_def def;
    mus_draft_def_init(&def, sizeof def);
    for (int i = 0; i < 5; i++) {
        mus_pattern *skirt, *shirt;
        double ease[MUS_EASE_COUNT];
        def.ease = 0.02 + 0.03 * i;
        ck_assert_int_eq(mus_design_draft(context, mus_design_find("skirt"), tape, &def, &skirt), MUS_OK);
        ck_assert_int_eq(mus_design_ease(skirt, tape, ease), MUS_OK);
        ck_assert(isnan(ease[MUS_EASE_BUST]));
        ck_assert_double_eq_tol(ease[MUS_EASE_HIP], def.ease, 0.001);
        /* the top edge rises 1.2 cm to the sides: the level lies under it there */
        ck_assert(ease[MUS_EASE_WAIST] > 0.02 && ease[MUS_EASE_WAIST] < 0.06);
        ck_assert_int_eq(mus_design_draft(context, mus_design_find("tshirt"), tape, &def, &shirt), MUS_OK);
        ck_assert_int_eq(mus_design_ease(shirt, tape, ease), MUS_OK);
        /* a shirt that is closer on the bust than on the hip widens below it */
        ck_assert(ease[MUS_EASE_BUST] > def.ease - 0.001 && ease[MUS_EASE_BUST] < fmax(def.ease, 0.05) + 0.012);
        mus_pattern_destroy(skirt);
        mus_pattern_destroy(shirt);
    }
    mus_tape_destroy(tape);
    support_context_end(context);
}
END_TEST


START_TEST(bad_arguments_are_refused)
{
    mus_context *context = support_context();
    mus_tape *tape = drafts_tape(context, "W40");
    mus_pattern *pattern = drafts_pattern(context, "skirt", "W40"), *out = pattern;
    double rules[2 * MOST], ease[MUS_EASE_COUNT];
    memset(rules, 0, sizeof rules);
    ck_assert_int_eq(mus_design_grade(NULL, pattern, rules, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_design_grade(pattern, NULL, rules, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_design_grade(pattern, pattern, NULL, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_design_grade_apply(NULL, rules, &out), MUS_ERR_ARG);
    ck_assert_ptr_null(out);
    ck_assert_int_eq(mus_design_grade_apply(pattern, NULL, &out), MUS_ERR_ARG);
    ck_assert_int_eq(mus_design_grade_apply(pattern, rules, NULL), MUS_ERR_ARG);
    const double bad[3] = {NAN, INFINITY, -INFINITY};
    for (int i = 0; i < 3; i++) {
        rules[7] = bad[i];
        ck_assert_int_eq(mus_design_grade_apply(pattern, rules, &out), MUS_ERR_ARG);
        ck_assert_ptr_nonnull(strstr(mus_context_error(context), "front"));
    }
    ck_assert_int_eq(mus_design_ease(NULL, tape, ease), MUS_ERR_ARG);
    ck_assert_int_eq(mus_design_ease(pattern, NULL, ease), MUS_ERR_ARG);
    ck_assert_int_eq(mus_design_ease(pattern, tape, NULL), MUS_ERR_ARG);
    mus_pattern_destroy(pattern);
    mus_tape_destroy(tape);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_grade(void);
Suite *mus_suite_grade(void)
{
    Suite *suite = suite_create("grade");
    TCase *sizes = tcase_create("sizes");
    tcase_add_test(sizes, rules_are_the_steps_of_the_reference);
    tcase_add_test(sizes, rules_of_one_step_make_the_next_size);
    tcase_add_test(sizes, ease_is_what_was_asked);
    tcase_add_test(sizes, bad_arguments_are_refused);
    suite_add_tcase(suite, sizes);
    return suite;
}
