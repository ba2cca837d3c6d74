/*
 * test_block_sleeve.c: the set-in sleeve against the golden numbers of an independent drafting script, and
 * its laws: each cap half as long as the armhole half it meets, whatever the width.
 */
#include <string.h>

#include "block/drafts.h"

/* output of the script, lines "sleeve:", cm. Width 1.15 upper arm; cap ease 3 % (women) or 1.5 %; length of the arm;
 * hem the larger of 1.2 wrist and hand + 1.5 */
static const struct {
    const char *size;
    double width, height, crown, front, back, under;
} golden[] = {
    {"W34", 29.44, 13.04, 1.06, 21.54, 19.84, 46.52},  {"W40", 33.58, 13.93, 0.77, 23.56, 22.25, 45.87},
    {"W52", 43.93, 18.39, 0.79, 30.78, 29.40, 42.46},  {"M46", 33.69, 15.44, 0.85, 24.76, 23.35, 45.32},
    {"M50", 36.45, 15.92, 0.87, 26.18, 24.71, 47.08},  {"M60", 43.35, 17.30, 0.91, 29.89, 28.31, 48.95},
    {"C56", 15.98, 9.46, 0.73, 13.62, 12.56, 7.83},    {"C104", 20.49, 12.03, 0.59, 17.13, 16.23, 23.66},
    {"C152", 27.09, 15.99, 0.63, 22.61, 21.64, 38.24},
};


START_TEST(sleeves_are_the_golden_numbers)
{
    mus_context *context = support_context();
    const char *size = golden[_i].size;
    const mus__measures measures = drafts_measures(context, size);
    const mus__bodice bodice = drafts_bodice(context, size);
    const double *m = measures.v, ease = measures.sex == MUS_SEX_FEMALE ? 1.03 : 1.015;
    const mus__sleeve_def def = {.front = bodice.front.arm_length * ease,
                                 .back = bodice.back.arm_length * ease,
                                 .width = 1.15 * m[MUS_MEASURE_UPPER_ARM],
                                 .length = m[MUS_MEASURE_ARM],
                                 .hem = fmax(1.2 * m[MUS_MEASURE_WRIST], m[MUS_MEASURE_HAND] + 1.5 * CM)};
    mus__sleeve sleeve;
    ck_assert_int_eq(mus__sleeve_draft(context, &def, &sleeve), MUS_OK);
    CK_GOLDEN(size, "biceps", sleeve.width, CM, golden[_i].width, GOLDEN);
    CK_GOLDEN(size, "cap height", sleeve.height, CM, golden[_i].height, GOLDEN);
    CK_GOLDEN(size, "crown shift", sleeve.crown, CM, golden[_i].crown, GOLDEN);
    CK_GOLDEN(size, "front cap", sleeve.front_length, CM, golden[_i].front, GOLDEN);
    CK_GOLDEN(size, "back cap", sleeve.back_length, CM, golden[_i].back, GOLDEN);
    const double under = hypot(0.5 * (sleeve.width - sleeve.hem), sleeve.length - sleeve.height);
    CK_GOLDEN(size, "underarm", under, CM, golden[_i].under, GOLDEN);
    support_context_end(context);
}
END_TEST


START_TEST(cap_halves_are_as_long_as_asked)
{
    mus_context *context = support_context();
    uint64_t state = 8;
    for (int i = 0; i < 300; i++) {
        const double front = support_uniform(&state, 0.12, 0.32), back = front * support_uniform(&state, 0.85, 1.1);
        const mus__sleeve_def def = {.front = front,
                                     .back = back,
                                     .width = (front + back) * support_uniform(&state, 0.6, 0.95),
                                     .length = 0.6,
                                     .hem = support_uniform(&state, 0.1, 0.3)};
        mus__sleeve sleeve;
        ck_assert_msg(mus__sleeve_draft(context, &def, &sleeve) == MUS_OK, "%s", mus_context_error(context));
        ck_assert_double_eq_tol(sleeve.front_length, front, 1e-7);
        ck_assert_double_eq_tol(sleeve.back_length, back, 1e-7);
        ck_assert_double_eq(sleeve.cap_front[0], -0.5 * def.width);
        ck_assert_double_eq(sleeve.cap_back[6], 0.5 * def.width);
        ck_assert_double_eq(sleeve.cap_front[6], sleeve.cap_back[0]);
        ck_assert_double_eq(sleeve.cap_front[7], sleeve.height);
    }
    support_context_end(context);
}
END_TEST


/* a cap drawn to the width that mus__sleeve_width names is as high as was asked */
START_TEST(width_for_a_cap_height)
{
    mus_context *context = support_context();
    for (double ratio = 0.15; ratio < 0.36; ratio += 0.05) {
        const double width = mus__sleeve_width(0.45, ratio);
        const mus__sleeve_def def = {.front = 0.225, .back = 0.225, .width = width, .length = 0.6, .hem = 0.2};
        mus__sleeve sleeve;
        ck_assert_int_eq(mus__sleeve_draft(context, &def, &sleeve), MUS_OK);
        ck_assert_double_eq_tol(sleeve.height, ratio * 0.45, 1e-5);
        ck_assert_double_eq_tol(sleeve.crown, 0.0, 0.002);
    }
    support_context_end(context);
}
END_TEST


START_TEST(a_sleeve_that_cannot_be_is_refused)
{
    static const struct {
        mus__sleeve_def def;
        const char *word;
    } list[] = {
        {{.front = 0.15, .back = 0.15, .width = 0.30, .length = 0.6, .hem = 0.2}, "upper_arm"},
        {{.front = 0.23, .back = 0.22, .width = 0.34, .length = 0.14, .hem = 0.2}, "length"},
        {{.front = 0.40, .back = 0.10, .width = 0.48, .length = 0.6, .hem = 0.2}, "crown"},
    };
    mus_context *context = support_context();
    for (size_t i = 0; i < sizeof list / sizeof list[0]; i++) {
        mus__sleeve sleeve;
        ck_assert_int_eq(mus__sleeve_draft(context, &list[i].def, &sleeve), MUS_ERR_DESIGN);
        ck_assert_msg(strstr(mus_context_error(context), list[i].word) != NULL, "%s", mus_context_error(context));
    }
    support_context_end(context);
}
END_TEST


Suite *mus_suite_block_sleeve(void)
{
    Suite *suite = suite_create("block_sleeve");
    TCase *tcase = tcase_create("block_sleeve");
    tcase_add_loop_test(tcase, sleeves_are_the_golden_numbers, 0, (int)(sizeof golden / sizeof golden[0]));
    tcase_add_test(tcase, cap_halves_are_as_long_as_asked);
    tcase_add_test(tcase, width_for_a_cap_height);
    tcase_add_test(tcase, a_sleeve_that_cannot_be_is_refused);
    suite_add_tcase(suite, tcase);
    return suite;
}
