/* test_tape_check.c: a tape that no body has is an error that names both measures; a doubtful one gives a warning. */
#include <math.h>
#include <string.h>

#include "muslin/tape.h"
#include "support.h"


/* W40 with some measures set (cm, or degrees); completes it */
static mus_status complete_with(mus_context *context, const int32_t *measures, const double *values, int n,
                                mus_tape **tape)
{
    ck_assert_int_eq(mus_tape_create(context, tape), MUS_OK);
    ck_assert_int_eq(mus_tape_set_size(*tape, "W40"), MUS_OK);
    for (int i = 0; i < n; i++)
        ck_assert_int_eq(mus_tape_set(*tape, measures[i], 0.01 * values[i], MUS_SOURCE_GIVEN), MUS_OK);
    return mus_tape_complete(*tape);
}


static bool warns_of(const mus_tape *tape, const char *x, const char *y)
{
    for (int32_t i = 0; i < mus_tape_warning_count(tape); i++)
        if (strstr(mus_tape_warning(tape, i), x) != NULL && strstr(mus_tape_warning(tape, i), y) != NULL) return true;
    return false;
}


START_TEST(a_contradiction_is_refused_with_both_names)
{
    static const struct {
        int32_t measure;
        double cm;
        const char *x, *y;
    } row[] = {
        {MUS_MEASURE_UNDERBUST, 92.1, "underbust", "bust"},
        {MUS_MEASURE_BUST_SPAN, 46.1, "bust_span", "bust"},
        {MUS_MEASURE_SHOULDER, 28.1, "shoulder", "stature"},
        {MUS_MEASURE_WAIST_HEIGHT, 169.0, "waist_height", "stature"},
        {MUS_MEASURE_WAIST_TO_HIP, 30.4, "waist_to_hip", "rise"},
        {MUS_MEASURE_WRIST, 30.0, "wrist", "upper_arm"},
        {MUS_MEASURE_INLEG, 95.0, "inleg", "stature"},
        {MUS_MEASURE_NAPE_HEIGHT, 170.0, "nape_height", "stature"},
        {MUS_MEASURE_BUST_HEIGHT, 100.0, "waist_height", "bust_height"},
        {MUS_MEASURE_HIP, 220.0, "hip", "stature"},
        {MUS_MEASURE_BUST, 33.0, "bust", "stature"},
    };
    mus_context *context = support_context();
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        mus_tape *tape = NULL;
        /* wrist and waist-to-hip change derived measures: these are given too */
        int32_t measure[2] = {row[i].measure, MUS_MEASURE_UPPER_ARM};
        double value[2] = {row[i].cm, 29.2};
        mus_status status = complete_with(context, measure, value, 2, &tape);
        ck_assert_msg(status == MUS_ERR_TAPE, "%s is taken", row[i].x);
        ck_assert_msg(strstr(mus_context_error(context), row[i].x) && strstr(mus_context_error(context), row[i].y),
                      "%s", mus_context_error(context));
        ck_assert_int_eq(mus_tape_is_complete(tape), 0);
        ck_assert_int_eq(mus_tape_source(tape, MUS_MEASURE_CALF), MUS_SOURCE_NONE);
        mus_tape_destroy(tape);
    }
    support_context_end(context);
}
END_TEST


START_TEST(rise_and_inside_leg_may_miss_the_waist_by_4_cm_and_never_by_8)
{
    mus_context *context = support_context();
    const int32_t measure[] = {MUS_MEASURE_RISE, MUS_MEASURE_INLEG, MUS_MEASURE_WAIST_HEIGHT};
    const struct {
        double height;
        mus_status status;
        bool warns;
    } row[] = {{109.0, MUS_OK, false}, {109.2, MUS_OK, true}, {113.0, MUS_OK, true},      {113.2, MUS_ERR_TAPE, false},
               {101.0, MUS_OK, false}, {100.8, MUS_OK, true}, {96.8, MUS_ERR_TAPE, false}};
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        mus_tape *tape = NULL;
        double value[] = {26.0, 79.0, row[i].height};
        ck_assert_int_eq(complete_with(context, measure, value, 3, &tape), row[i].status);
        ck_assert_msg(warns_of(tape, "rise", "waist_height") == row[i].warns, "at %g", row[i].height);
        if (row[i].status != MUS_OK) {
            ck_assert_ptr_nonnull(strstr(mus_context_error(context), "rise"));
            ck_assert_ptr_nonnull(strstr(mus_context_error(context), "inleg"));
            ck_assert_ptr_nonnull(strstr(mus_context_error(context), "waist_height"));
        }
        mus_tape_destroy(tape);
    }
    support_context_end(context);
}
END_TEST


START_TEST(doubtful_pairs_are_warned_of)
{
    static const struct {
        int32_t measure;
        double cm;
        const char *x, *y;
    } row[] = {
        {MUS_MEASURE_HIGH_BUST, 95.5, "high_bust", "bust"},
        {MUS_MEASURE_UNDERBUST, 61.0, "bust", "underbust"},
        {MUS_MEASURE_NECK, 51.0, "neck", "36.9 cm"},
        {MUS_MEASURE_THIGH, 76.0, "thigh", "59.8 cm"},
        {MUS_MEASURE_THIGH, 44.0, "thigh", "59.8 cm"},
        {MUS_MEASURE_KNEE, 30.0, "calf", "knee"},
        {MUS_MEASURE_BACK_WAIST, 58.0, "back_waist", "waist_to_hip"},
        {MUS_MEASURE_ACROSS_BACK, 56.0, "across_back", "across_front"},
        {MUS_MEASURE_CROTCH_LENGTH, 86.0, "crotch_length", "rise"},
    };
    mus_context *context = support_context();
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        mus_tape *tape = NULL;
        ck_assert_int_eq(complete_with(context, &row[i].measure, &row[i].cm, 1, &tape), MUS_OK);
        ck_assert_msg(warns_of(tape, row[i].x, row[i].y), "%s %g", row[i].x, row[i].cm);
        mus_tape_destroy(tape);
    }
    support_context_end(context);
}
END_TEST


START_TEST(inches_and_half_girths_are_guessed)
{
    mus_context *context = support_context();
    const int32_t measure[] = {MUS_MEASURE_HEAD, MUS_MEASURE_THIGH};
    const double value[] = {56.4 / 2.54, 60.3 / 2.0};
    mus_tape *tape = NULL;
    ck_assert_int_eq(complete_with(context, measure, value, 2, &tape), MUS_OK);
    ck_assert(warns_of(tape, "head", "inches"));
    ck_assert(warns_of(tape, "thigh", "half"));
    ck_assert_ptr_null(mus_tape_warning(tape, -1));
    ck_assert_ptr_null(mus_tape_warning(tape, mus_tape_warning_count(tape)));
    mus_tape_destroy(tape);
    support_context_end(context);
}
END_TEST


START_TEST(derived_values_give_way_to_given_ones)
{
    /* each would be an error if the derived measure did not change with it */
    static const struct {
        int32_t measure;
        double cm;
    } row[] = {{MUS_MEASURE_WRIST, 31.0}, {MUS_MEASURE_UPPER_ARM, 15.0}, {MUS_MEASURE_ANKLE, 39.0},
               {MUS_MEASURE_CALF, 20.0},  {MUS_MEASURE_RISE, 17.0},      {MUS_MEASURE_KNEE, 60.0}};
    mus_context *context = support_context();
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        mus_tape *tape = NULL;
        mus_status status = complete_with(context, &row[i].measure, &row[i].cm, 1, &tape);
        ck_assert_msg(status == MUS_OK, "%s: %s", mus_measure_name(row[i].measure), mus_context_error(context));
        ck_assert(mus_tape_value(tape, row[i].measure) == 0.01 * row[i].cm);
        mus_tape_destroy(tape);
    }
    support_context_end(context);
}
END_TEST


START_TEST(random_sheets_end_complete_or_refused)
{
    mus_context *context = support_context();
    uint64_t seed = 7;
    int taken = 0;
    for (int round = 0; round < 2000; round++) {
        mus_tape *tape = NULL;
        ck_assert_int_eq(mus_tape_create(context, &tape), MUS_OK);
        ck_assert_int_eq(mus_tape_set_sex(tape, (int32_t)(support_random(&seed) % 4)), MUS_OK);
        double h = support_uniform(&seed, 1.3, 2.1);
        ck_assert_int_eq(mus_tape_set(tape, MUS_MEASURE_STATURE, h, MUS_SOURCE_GIVEN), MUS_OK);
        for (int32_t m = MUS_MEASURE_BUST; m <= MUS_MEASURE_HIP; m++)
            mus_tape_set(tape, m, support_uniform(&seed, 0.35, 0.9) * h, MUS_SOURCE_GIVEN);
        int32_t extra = (int32_t)(support_random(&seed) % MUS_MEASURE_COUNT);
        if (mus_measure_unit(extra) == 'm')
            mus_tape_set(tape, extra, support_uniform(&seed, 0.05, 1.2), MUS_SOURCE_GIVEN);
        mus_status status = mus_tape_complete(tape);
        ck_assert(status == MUS_OK || status == MUS_ERR_TAPE);
        taken += status == MUS_OK;
        for (int32_t m = 0; m < MUS_MEASURE_COUNT && status == MUS_OK; m++)
            ck_assert(m == MUS_MEASURE_FRONT_WAIST || mus_tape_value(tape, m) > 0.0);
        mus_tape_destroy(tape);
    }
    ck_assert_int_gt(taken, 500);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_tape_check(void);
Suite *mus_suite_tape_check(void)
{
    Suite *suite = suite_create("tape_check");
    TCase *tests = tcase_create("tape_check");
    tcase_add_test(tests, a_contradiction_is_refused_with_both_names);
    tcase_add_test(tests, rise_and_inside_leg_may_miss_the_waist_by_4_cm_and_never_by_8);
    tcase_add_test(tests, doubtful_pairs_are_warned_of);
    tcase_add_test(tests, inches_and_half_girths_are_guessed);
    tcase_add_test(tests, derived_values_give_way_to_given_ones);
    tcase_add_test(tests, random_sheets_end_complete_or_refused);
    suite_add_tcase(suite, tests);
    return suite;
}
