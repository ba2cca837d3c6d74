/* test_tape.c: setting, reading, copying and completing a tape. */
#include <locale.h>
#include <math.h>
#include <string.h>

#include "muslin/tape.h"
#include "support.h"


static mus_tape *new_tape(mus_context *context, const char *size)
{
    mus_tape *tape = NULL;
    ck_assert_int_eq(mus_tape_create(context, &tape), MUS_OK);
    if (size != NULL) ck_assert_int_eq(mus_tape_set_size(tape, size), MUS_OK);
    return tape;
}


START_TEST(measures_are_found_by_name_and_alias)
{
    ck_assert_int_eq(mus_measure_count(), MUS_MEASURE_COUNT);
    for (int32_t m = 0; m < mus_measure_count(); m++) {
        ck_assert_int_eq(mus_measure_find(mus_measure_name(m)), m);
        ck_assert(mus_measure_unit(m) == 'm' || mus_measure_unit(m) == 'r');
    }
    ck_assert_int_eq(mus_measure_find("chest"), MUS_MEASURE_BUST);
    ck_assert_int_eq(mus_measure_find("seat"), MUS_MEASURE_HIP);
    ck_assert_int_eq(mus_measure_find("height"), MUS_MEASURE_STATURE);
    ck_assert_int_eq(mus_measure_find("inseam"), MUS_MEASURE_INLEG);
    ck_assert_int_eq(mus_measure_find("hips"), MUS_NONE); /* two programs mean two measures */
    ck_assert_int_eq(mus_measure_find(""), MUS_NONE);
    ck_assert_int_eq(mus_measure_find(NULL), MUS_NONE);
    ck_assert_ptr_null(mus_measure_name(-1));
    ck_assert_ptr_null(mus_measure_name(MUS_MEASURE_COUNT));
    ck_assert_int_eq(mus_measure_unit(MUS_MEASURE_COUNT), 0);
    ck_assert_int_eq(mus_measure_unit(MUS_MEASURE_SHOULDER_SLOPE), 'r');
}
END_TEST


START_TEST(a_bad_value_leaves_the_tape_as_it_was)
{
    mus_context *context = support_context();
    mus_tape *tape = new_tape(context, "W40");
    ck_assert_int_eq(mus_tape_complete(tape), MUS_OK);
    const double bad[] = {0.0, -0.76, 0.18, 3.81, 76.0, INFINITY, -INFINITY};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        mus_status status = mus_tape_set(tape, MUS_MEASURE_WAIST, bad[i], MUS_SOURCE_GIVEN);
        ck_assert_int_eq(status, isinf(bad[i]) ? MUS_ERR_ARG : MUS_ERR_TAPE);
        ck_assert_ptr_nonnull(strstr(mus_context_error(context), "waist"));
        ck_assert(mus_tape_value(tape, MUS_MEASURE_WAIST) == 0.76);
        ck_assert_int_ne(mus_tape_is_complete(tape), 0);
    }
    ck_assert_int_eq(mus_tape_set(tape, MUS_MEASURE_COUNT, 1.0, MUS_SOURCE_GIVEN), MUS_ERR_ARG);
    ck_assert_int_eq(mus_tape_set(tape, -1, 1.0, MUS_SOURCE_GIVEN), MUS_ERR_ARG);
    ck_assert_int_eq(mus_tape_set(tape, MUS_MEASURE_WAIST, 0.8, MUS_SOURCE_NONE), MUS_ERR_ARG);
    ck_assert_int_eq(mus_tape_set(NULL, MUS_MEASURE_WAIST, 0.8, MUS_SOURCE_GIVEN), MUS_ERR_ARG);
    ck_assert_int_eq(mus_tape_set_sex(tape, 4), MUS_ERR_ARG);
    ck_assert_int_eq(mus_tape_sex(tape), MUS_SEX_FEMALE);
    mus_tape_destroy(tape);
    support_context_end(context);
}
END_TEST


START_TEST(nan_unsets_and_what_is_missing_is_named)
{
    mus_context *context = support_context();
    mus_tape *tape = new_tape(context, "W40");
    ck_assert_int_eq(mus_tape_complete(tape), MUS_OK);
    ck_assert_int_eq(mus_tape_set(tape, MUS_MEASURE_HIP, NAN, MUS_SOURCE_GIVEN), MUS_OK);
    ck_assert_int_eq(mus_tape_is_complete(tape), 0);
    ck_assert(isnan(mus_tape_value(tape, MUS_MEASURE_HIP)));
    ck_assert_int_eq(mus_tape_source(tape, MUS_MEASURE_HIP), MUS_SOURCE_NONE);
    ck_assert_int_eq(mus_tape_complete(tape), MUS_ERR_TAPE);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "hip"));
    mus_tape_destroy(tape);
    support_context_end(context);
}
END_TEST


START_TEST(derived_values_are_derived_anew)
{
    mus_context *context = support_context();
    mus_tape *tape = new_tape(context, "W40");
    ck_assert_int_eq(mus_tape_complete(tape), MUS_OK);
    double before = mus_tape_value(tape, MUS_MEASURE_UPPER_ARM);
    ck_assert_int_eq(mus_tape_source(tape, MUS_MEASURE_UPPER_ARM), MUS_SOURCE_DERIVED);
    ck_assert_int_eq(mus_tape_set(tape, MUS_MEASURE_BUST, 1.02, MUS_SOURCE_GIVEN), MUS_OK);
    ck_assert_int_eq(mus_tape_is_complete(tape), 0);
    ck_assert_int_eq(mus_tape_complete(tape), MUS_OK);
    ck_assert_double_eq_tol(mus_tape_value(tape, MUS_MEASURE_UPPER_ARM) - before, 0.03, 1e-12);

    /* a given value is kept, and a value that the caller derived is kept with its source */
    ck_assert_int_eq(mus_tape_set(tape, MUS_MEASURE_UPPER_ARM, 0.31, MUS_SOURCE_GIVEN), MUS_OK);
    ck_assert_int_eq(mus_tape_set(tape, MUS_MEASURE_STATURE, 1.70, MUS_SOURCE_DERIVED), MUS_OK);
    ck_assert_int_eq(mus_tape_complete(tape), MUS_OK);
    ck_assert_int_eq(mus_tape_complete(tape), MUS_OK);
    ck_assert(mus_tape_value(tape, MUS_MEASURE_UPPER_ARM) == 0.31);
    ck_assert(mus_tape_value(tape, MUS_MEASURE_STATURE) == 1.70);
    ck_assert_int_eq(mus_tape_source(tape, MUS_MEASURE_STATURE), MUS_SOURCE_DERIVED);
    mus_tape_destroy(tape);
    support_context_end(context);
}
END_TEST


START_TEST(an_unset_sex_is_the_mean_of_women_and_men)
{
    mus_context *context = support_context();
    mus_tape *tape[3];
    for (int sex = 0; sex < 3; sex++) {
        tape[sex] = new_tape(context, "W44");
        ck_assert_int_eq(mus_tape_set_sex(tape[sex], sex), MUS_OK);
        ck_assert_int_eq(mus_tape_complete(tape[sex]), MUS_OK);
    }
    const int32_t linear[] = {MUS_MEASURE_NECK,         MUS_MEASURE_SHOULDER, MUS_MEASURE_THIGH,     MUS_MEASURE_HEAD,
                              MUS_MEASURE_WAIST_HEIGHT, MUS_MEASURE_INLEG,    MUS_MEASURE_UNDERBUST, MUS_MEASURE_FOOT};
    for (size_t i = 0; i < sizeof linear / sizeof *linear; i++) {
        double mean = 0.5 * (mus_tape_value(tape[1], linear[i]) + mus_tape_value(tape[2], linear[i]));
        ck_assert_double_eq_tol(mus_tape_value(tape[0], linear[i]), mean, 1e-12);
    }
    for (int sex = 0; sex < 3; sex++) mus_tape_destroy(tape[sex]);
    support_context_end(context);
}
END_TEST


START_TEST(two_of_rise_inside_leg_and_waist_height_give_the_third)
{
    mus_context *context = support_context();
    const int32_t r = MUS_MEASURE_RISE, l = MUS_MEASURE_INLEG, w = MUS_MEASURE_WAIST_HEIGHT;
    const struct {
        int32_t x, y, third;
        double vx, vy, expect;
    } row[] = {{r, l, w, 0.27, 0.79, 1.06}, {r, w, l, 0.27, 1.06, 0.79}, {l, w, r, 0.79, 1.06, 0.27}};
    for (int i = 0; i < 3; i++) {
        mus_tape *tape = new_tape(context, "W40");
        ck_assert_int_eq(mus_tape_set(tape, row[i].x, row[i].vx, MUS_SOURCE_GIVEN), MUS_OK);
        ck_assert_int_eq(mus_tape_set(tape, row[i].y, row[i].vy, MUS_SOURCE_GIVEN), MUS_OK);
        ck_assert_int_eq(mus_tape_complete(tape), MUS_OK);
        ck_assert_double_eq_tol(mus_tape_value(tape, row[i].third), row[i].expect, 1e-12);
        ck_assert_int_eq(mus_tape_source(tape, row[i].third), MUS_SOURCE_DERIVED);
        mus_tape_destroy(tape);
    }

    /* one of them alone: the sum holds all the same */
    const int32_t alone[] = {r, l, w};
    const double value[] = {0.28, 0.80, 1.08};
    for (int i = 0; i < 3; i++) {
        mus_tape *tape = new_tape(context, "W40");
        ck_assert_int_eq(mus_tape_set(tape, alone[i], value[i], MUS_SOURCE_GIVEN), MUS_OK);
        ck_assert_int_eq(mus_tape_complete(tape), MUS_OK);
        ck_assert_double_eq_tol(mus_tape_value(tape, r) + mus_tape_value(tape, l), mus_tape_value(tape, w), 1e-12);
        mus_tape_destroy(tape);
    }
    support_context_end(context);
}
END_TEST


START_TEST(heights_of_nape_and_bust_follow_the_tape)
{
    mus_context *context = support_context();
    mus_tape *tape = new_tape(context, "W40");
    ck_assert_int_eq(mus_tape_complete(tape), MUS_OK);
    double nape = 1.04496 + 0.97 * 0.41496;
    ck_assert_double_eq_tol(mus_tape_value(tape, MUS_MEASURE_NAPE_HEIGHT), nape, 1e-9);
    ck_assert_double_eq_tol(mus_tape_value(tape, MUS_MEASURE_BUST_HEIGHT), nape + 0.01 - 0.88 * 0.272, 1e-9);
    ck_assert_double_eq_tol(mus_tape_value(tape, MUS_MEASURE_ARM_ANGLE), 0.785398163397448, 1e-12);
    ck_assert(isnan(mus_tape_value(tape, MUS_MEASURE_FRONT_WAIST))); /* a block derives it from its dart */
    mus_tape_destroy(tape);
    support_context_end(context);
}
END_TEST


/* the arms of all sizes hang at 45 degrees; those of a stouter person stand farther off */
START_TEST(arms_stand_off_the_side_of_a_stout_person)
{
    mus_context *context = support_context();
    const double degree = 3.14159265358979323846 / 180.0;
    const char *const sizes[] = {"W34", "W52", "M46", "M60", "C56", "C80", "C164"};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        mus_tape *tape = new_tape(context, sizes[i]);
        ck_assert_int_eq(mus_tape_complete(tape), MUS_OK);
        ck_assert_double_eq_tol(mus_tape_value(tape, MUS_MEASURE_ARM_ANGLE), 45.0 * degree, 1e-12);
        mus_tape_destroy(tape);
    }
    double last = 45.0 * degree;
    for (double bust = 0.8; bust < 1.8; bust += 0.05) {
        mus_tape *tape = new_tape(context, "W40");
        ck_assert_int_eq(mus_tape_set(tape, MUS_MEASURE_STATURE, 1.5, MUS_SOURCE_GIVEN), MUS_OK);
        ck_assert_int_eq(mus_tape_set(tape, MUS_MEASURE_BUST, bust, MUS_SOURCE_GIVEN), MUS_OK);
        ck_assert_int_eq(mus_tape_complete(tape), MUS_OK);
        const double angle = mus_tape_value(tape, MUS_MEASURE_ARM_ANGLE);
        ck_assert_double_le(angle, last);
        ck_assert_double_ge(angle, 0.175); /* the least that mus_tape_set() takes */
        mus_tape_destroy(tape);
        last = angle;
    }
    ck_assert_double_lt(last, 25.0 * degree);
    support_context_end(context);
}
END_TEST


START_TEST(a_copy_is_alike_and_apart)
{
    mus_context *context = support_context();
    mus_tape *tape = new_tape(context, "M54"), *copy = NULL;
    ck_assert_int_eq(mus_tape_complete(tape), MUS_OK);
    ck_assert_int_eq(mus_tape_copy(tape, &copy), MUS_OK);
    ck_assert_ptr_eq(mus_tape_context(copy), context);
    ck_assert_int_eq(mus_tape_set(tape, MUS_MEASURE_BUST, 1.2, MUS_SOURCE_GIVEN), MUS_OK);
    ck_assert(mus_tape_value(copy, MUS_MEASURE_BUST) == 1.08);
    ck_assert_int_ne(mus_tape_is_complete(copy), 0);
    ck_assert_str_eq(mus_tape_name(copy), "M54");
    mus_tape_destroy(tape);
    mus_tape_destroy(copy);

    ck_assert_int_eq(mus_tape_copy(NULL, &copy), MUS_ERR_ARG);
    ck_assert_ptr_null(copy);
    ck_assert_int_eq(mus_tape_create(NULL, &copy), MUS_ERR_ARG);
    ck_assert_int_eq(mus_tape_create(context, NULL), MUS_ERR_ARG);
    mus_tape_destroy(NULL);
    support_context_end(context);
}
END_TEST


START_TEST(names_are_kept_up_to_63_bytes)
{
    mus_context *context = support_context();
    mus_tape *tape = new_tape(context, NULL);
    char name[80];
    memset(name, 'a', sizeof name);
    name[64] = '\0';
    ck_assert_str_eq(mus_tape_name(tape), "");
    ck_assert_int_eq(mus_tape_set_name(tape, name), MUS_ERR_ARG);
    name[63] = '\0';
    ck_assert_int_eq(mus_tape_set_name(tape, name), MUS_OK);
    ck_assert_str_eq(mus_tape_name(tape), name);
    ck_assert_int_eq(mus_tape_set_name(tape, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_tape_set_name(tape, "Ad\xff"), MUS_ERR_ARG);
    ck_assert_str_eq(mus_context_error(context), "the name of a tape is not UTF-8 at byte 2");
    mus_tape_destroy(tape);
    support_context_end(context);
}
END_TEST


START_TEST(sentences_do_not_follow_the_locale)
{
    /* where that locale is not installed the test still holds */
    setlocale(LC_ALL, "de_DE.UTF-8");
    mus_context *context = support_context();
    mus_tape *tape = new_tape(context, NULL);
    ck_assert_int_eq(mus_tape_set(tape, MUS_MEASURE_WAIST, 7.65, MUS_SOURCE_GIVEN), MUS_ERR_TAPE);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "765.0 cm"));
    mus_tape_destroy(tape);
    support_context_end(context);
}
END_TEST


START_TEST(without_memory_a_tape_stays_as_it_was)
{
    for (int64_t n = 0;; n++) {
        mus_context *context = support_context();
        mus_tape *tape = NULL, *copy = NULL;
        support_fail_after(n, false);
        mus_status status = mus_tape_create(context, &tape);
        if (status == MUS_OK) status = mus_tape_set_size(tape, "W40");
        if (status == MUS_OK) status = mus_tape_complete(tape);
        if (status == MUS_OK) status = mus_tape_copy(tape, &copy);
        support_fail_never();
        mus_tape_destroy(tape);
        mus_tape_destroy(copy);
        support_context_end(context);
        if (status == MUS_OK) break;
        ck_assert_int_eq(status, MUS_ERR_MEMORY);
        ck_assert_int_lt(n, 20);
    }
}
END_TEST


Suite *mus_suite_tape(void);
Suite *mus_suite_tape(void)
{
    Suite *suite = suite_create("tape");
    TCase *tests = tcase_create("tape");
    tcase_add_test(tests, measures_are_found_by_name_and_alias);
    tcase_add_test(tests, a_bad_value_leaves_the_tape_as_it_was);
    tcase_add_test(tests, nan_unsets_and_what_is_missing_is_named);
    tcase_add_test(tests, derived_values_are_derived_anew);
    tcase_add_test(tests, an_unset_sex_is_the_mean_of_women_and_men);
    tcase_add_test(tests, two_of_rise_inside_leg_and_waist_height_give_the_third);
    tcase_add_test(tests, heights_of_nape_and_bust_follow_the_tape);
    tcase_add_test(tests, arms_stand_off_the_side_of_a_stout_person);
    tcase_add_test(tests, a_copy_is_alike_and_apart);
    tcase_add_test(tests, names_are_kept_up_to_63_bytes);
    tcase_add_test(tests, sentences_do_not_follow_the_locale);
    tcase_add_test(tests, without_memory_a_tape_stays_as_it_was);
    suite_add_tcase(suite, tests);
    return suite;
}
