/*
 * test_tape_size.c: the 28 sizes against the printed tables.
 *
 * Golden numbers: stature and girths in the steps of EN 13402-3, the other rows by the formulas of mus_tape(3), in cm
 * to one decimal, computed by another program.
 */
#include <math.h>
#include <string.h>

#include "muslin/tape.h"
#include "support.h"

typedef struct gold_row {
    int32_t measure;
    double cm[10];
} gold_row;

static const gold_row women[] = {
    {MUS_MEASURE_STATURE, {168, 168, 168, 168, 168, 168, 168, 168, 168, 168}},
    {MUS_MEASURE_BUST, {80, 84, 88, 92, 96, 100, 104, 110, 116, 122}},
    {MUS_MEASURE_WAIST, {64, 68, 72, 76, 80, 84, 88, 94, 100, 106}},
    {MUS_MEASURE_HIP, {90, 94, 97, 100, 103, 106, 109, 114, 119, 124}},
    {MUS_MEASURE_NECK, {34.6, 35.2, 35.7, 36.3, 36.8, 37.4, 38, 38.8, 39.6, 40.5}},
    {MUS_MEASURE_SHOULDER, {11.9, 12.1, 12.2, 12.4, 12.5, 12.7, 12.9, 13.1, 13.3, 13.6}},
    {MUS_MEASURE_BACK_WAIST, {41.1, 41.3, 41.4, 41.5, 41.6, 41.7, 41.9, 42, 42.2, 42.4}},
    {MUS_MEASURE_SCYE_DEPTH, {18.5, 18.9, 19.3, 19.7, 20.1, 20.5, 20.9, 21.5, 22.1, 22.7}},
    {MUS_MEASURE_ACROSS_BACK, {33.4, 34.3, 35.2, 36, 36.9, 37.8, 38.7, 40, 41.3, 42.6}},
    {MUS_MEASURE_ACROSS_FRONT, {31, 32.1, 33.2, 34.2, 35.3, 36.4, 37.5, 39.1, 40.7, 42.3}},
    {MUS_MEASURE_BUST_SPAN, {16, 16.8, 17.6, 18.4, 19.2, 20, 20.8, 22, 23.2, 24.4}},
    {MUS_MEASURE_BUST_DEPTH, {24.2, 25.2, 26.2, 27.2, 28.2, 29.2, 30.2, 31.7, 33.2, 34.7}},
    {MUS_MEASURE_UNDERBUST, {67, 71, 75, 79, 83, 87, 91, 97, 103, 109}},
    {MUS_MEASURE_ARM, {59.3, 59.3, 59.3, 59.3, 59.3, 59.3, 59.3, 59.3, 59.3, 59.3}},
    {MUS_MEASURE_UPPER_ARM, {25.6, 26.8, 28, 29.2, 30.4, 31.6, 32.8, 34.6, 36.4, 38.2}},
    {MUS_MEASURE_WRIST, {15.5, 15.7, 15.8, 16, 16.1, 16.3, 16.5, 16.7, 17, 17.2}},
    {MUS_MEASURE_HAND, {18.2, 18.3, 18.5, 18.6, 18.8, 18.9, 19, 19.3, 19.5, 19.7}},
    {MUS_MEASURE_WAIST_HEIGHT, {104.5, 104.5, 104.5, 104.5, 104.5, 104.5, 104.5, 104.5, 104.5, 104.5}},
    {MUS_MEASURE_WAIST_TO_HIP, {20.2, 20.2, 20.2, 20.2, 20.2, 20.2, 20.2, 20.2, 20.2, 20.2}},
    {MUS_MEASURE_RISE, {24.5, 25.2, 25.8, 26.3, 26.8, 27.4, 27.9, 28.8, 29.7, 30.6}},
    {MUS_MEASURE_INLEG, {80, 79.3, 78.7, 78.2, 77.7, 77.1, 76.6, 75.7, 74.8, 73.9}},
    {MUS_MEASURE_THIGH, {53.4, 56.1, 58.2, 60.3, 62.3, 64.4, 66.5, 69.9, 73.4, 76.8}},
    {MUS_MEASURE_KNEE, {33.7, 35, 36, 37, 38, 39, 40, 41.6, 43.3, 44.9}},
    {MUS_MEASURE_CALF, {34.2, 35.4, 36.2, 37, 37.9, 38.7, 39.6, 41, 42.4, 43.8}},
    {MUS_MEASURE_ANKLE, {20.9, 21.3, 21.6, 21.9, 22.2, 22.5, 22.7, 23.2, 23.7, 24.2}},
    {MUS_MEASURE_HEAD, {55.9, 56.1, 56.3, 56.4, 56.6, 56.7, 56.9, 57.1, 57.4, 57.6}},
};

static const gold_row men[] = {
    {MUS_MEASURE_STATURE, {171, 174, 177, 179, 181, 183, 184, 185}},
    {MUS_MEASURE_BUST, {92, 96, 100, 104, 108, 112, 116, 120}},
    {MUS_MEASURE_WAIST, {80, 84, 88, 92, 97, 102, 107, 112}},
    {MUS_MEASURE_HIP, {95, 98.5, 102, 105.5, 109.5, 113.5, 117.5, 121.5}},
    {MUS_MEASURE_NECK, {39.4, 40.4, 41.3, 42.3, 43.2, 44.1, 45, 45.9}},
    {MUS_MEASURE_SHOULDER, {14.9, 15.1, 15.4, 15.6, 15.8, 16, 16.2, 16.3}},
    {MUS_MEASURE_BACK_WAIST, {43, 43.9, 44.8, 45.4, 46, 46.7, 47, 47.4}},
    {MUS_MEASURE_SCYE_DEPTH, {20.7, 21.1, 21.5, 21.9, 22.3, 22.7, 23.1, 23.5}},
    {MUS_MEASURE_ACROSS_BACK, {38.5, 39.5, 40.5, 41.5, 42.5, 43.5, 44.5, 45.5}},
    {MUS_MEASURE_ACROSS_FRONT, {36.3, 37.3, 38.3, 39.3, 40.3, 41.3, 42.3, 43.3}},
    {MUS_MEASURE_ARM, {60.4, 61.4, 62.5, 63.2, 63.9, 64.6, 65, 65.3}},
    {MUS_MEASURE_UPPER_ARM, {29.3, 30.5, 31.7, 32.9, 34.1, 35.3, 36.5, 37.7}},
    {MUS_MEASURE_WRIST, {16.7, 17, 17.4, 17.7, 18, 18.4, 18.7, 19}},
    {MUS_MEASURE_HAND, {20.3, 20.7, 21.1, 21.4, 21.7, 22.1, 22.4, 22.6}},
    {MUS_MEASURE_WAIST_HEIGHT, {105.2, 107, 108.9, 110.1, 111.3, 112.5, 113.2, 113.8}},
    {MUS_MEASURE_WAIST_TO_HIP, {20.5, 20.9, 21.2, 21.5, 21.7, 22, 22.1, 22.2}},
    {MUS_MEASURE_RISE, {24.6, 25.2, 25.9, 26.5, 27.2, 27.9, 28.6, 29.4}},
    {MUS_MEASURE_INLEG, {80.6, 81.8, 83, 83.6, 84.1, 84.6, 84.5, 84.4}},
    {MUS_MEASURE_THIGH, {57.5, 59.9, 62.4, 64.9, 67.7, 70.6, 73.5, 76.4}},
    {MUS_MEASURE_KNEE, {36.4, 37.5, 38.6, 39.8, 41, 42.3, 43.6, 44.9}},
    {MUS_MEASURE_CALF, {36.4, 37.5, 38.6, 39.8, 41, 42.3, 43.6, 44.9}},
    {MUS_MEASURE_ANKLE, {21.7, 22.2, 22.8, 23.3, 23.9, 24.4, 25, 25.5}},
    {MUS_MEASURE_HEAD, {56.2, 56.7, 57.1, 57.5, 58, 58.4, 58.8, 59.2}},
};

static const gold_row children[] = {
    {MUS_MEASURE_BUST, {42.5, 46.5, 50, 53.5, 56.5, 60.5, 65, 71, 77, 83.5}},
    {MUS_MEASURE_WAIST, {42, 46, 48.5, 51, 53, 55.5, 58, 62, 65.5, 69}},
    {MUS_MEASURE_HIP, {42.5, 47, 51, 55, 58.5, 63.5, 68.5, 75, 82, 89}},
    {MUS_MEASURE_NECK, {22.4, 23.7, 25.1, 26.4, 27.7, 29.1, 30.4, 31.7, 33.1, 34.4}},
    {MUS_MEASURE_SHOULDER, {5.5, 6.3, 7, 7.8, 8.6, 9.3, 10.1, 10.9, 11.6, 12.4}},
    {MUS_MEASURE_BACK_WAIST, {14.5, 17.2, 19.8, 22.2, 24.3, 26.6, 29.2, 32.2, 35.4, 38.6}},
    {MUS_MEASURE_SCYE_DEPTH, {10.6, 11.5, 12.2, 13, 13.7, 14.6, 15.6, 17, 18.3, 19.8}},
    {MUS_MEASURE_ACROSS_BACK, {17.8, 19.4, 20.8, 22.1, 23.3, 24.9, 26.7, 29, 31.4, 34}},
    {MUS_MEASURE_ACROSS_FRONT, {17.3, 18.8, 20.1, 21.5, 22.6, 24.2, 25.9, 28.2, 30.5, 33}},
    {MUS_MEASURE_ARM, {17.1, 21.7, 26.3, 30.9, 35.5, 40.2, 44.8, 49.4, 54, 58.6}},
    {MUS_MEASURE_UPPER_ARM, {13.9, 15, 16, 17, 17.8, 18.9, 20.2, 21.9, 23.6, 25.4}},
    {MUS_MEASURE_WRIST, {10.2, 10.8, 11.4, 12.1, 12.7, 13.3, 14, 14.6, 15.3, 15.9}},
    {MUS_MEASURE_HAND, {9.6, 10.6, 11.6, 12.5, 13.5, 14.5, 15.5, 16.5, 17.5, 18.4}},
    {MUS_MEASURE_WAIST_HEIGHT, {30.3, 38.4, 46.5, 54.6, 62.7, 70.8, 78.9, 87, 95.1, 103.2}},
    {MUS_MEASURE_WAIST_TO_HIP, {5.4, 6.8, 8.2, 9.6, 11, 12.3, 13.7, 15.1, 16.5, 17.9}},
    {MUS_MEASURE_RISE, {14.6, 15.8, 17, 18.2, 19.4, 20.6, 21.8, 23, 24.2, 25.4}},
    {MUS_MEASURE_INLEG, {15.7, 22.6, 29.5, 36.4, 43.3, 50.2, 57.1, 64, 70.9, 77.8}},
    {MUS_MEASURE_THIGH, {24.9, 27.5, 29.8, 32.2, 34.2, 37.1, 40.1, 43.9, 48, 52.1}},
    {MUS_MEASURE_KNEE, {20.2, 21.7, 23.1, 24.5, 25.7, 27.4, 29.1, 31.4, 33.8, 36.2}},
    {MUS_MEASURE_CALF, {18.5, 19.7, 20.8, 21.9, 22.8, 24.1, 25.5, 27.2, 29.1, 31}},
    {MUS_MEASURE_ANKLE, {14.5, 15.1, 15.6, 16.1, 16.6, 17.3, 17.9, 18.8, 19.7, 20.6}},
    {MUS_MEASURE_HEAD, {38.5, 43, 46.5, 49, 50.8, 52, 53, 54, 55, 56}},
};


/* every printed value of the sizes first .. first + count - 1 within half of its last digit */
static void check_rows(mus_context *context, int32_t first, int count, const gold_row *rows, size_t nrow)
{
    for (int c = 0; c < count; c++) {
        mus_tape *tape = NULL;
        const char *name = mus_tape_size_name(first + c);
        ck_assert_int_eq(mus_tape_create(context, &tape), MUS_OK);
        ck_assert_int_eq(mus_tape_set_size(tape, name), MUS_OK);
        ck_assert_msg(mus_tape_complete(tape) == MUS_OK, "%s: %s", name, mus_context_error(context));
        for (size_t r = 0; r < nrow; r++) {
            double got = 100.0 * mus_tape_value(tape, rows[r].measure);
            ck_assert_msg(fabs(got - rows[r].cm[c]) <= 0.05 + 1e-9, "%s %s is %.3f, the table has %.1f", name,
                          mus_measure_name(rows[r].measure), got, rows[r].cm[c]);
        }
        mus_tape_destroy(tape);
    }
}


START_TEST(all_sizes_are_the_printed_tables)
{
    mus_context *context = support_context();
    ck_assert_int_eq(mus_tape_size_count(), 28);
    check_rows(context, 0, 10, women, sizeof women / sizeof *women);
    check_rows(context, 10, 8, men, sizeof men / sizeof *men);
    check_rows(context, 18, 10, children, sizeof children / sizeof *children);
    support_context_end(context);
}
END_TEST


START_TEST(sizes_set_sex_name_and_clear_what_was_there)
{
    mus_context *context = support_context();
    mus_tape *tape = NULL;
    ck_assert_int_eq(mus_tape_create(context, &tape), MUS_OK);
    ck_assert_int_eq(mus_tape_set(tape, MUS_MEASURE_KNEE, 0.5, MUS_SOURCE_GIVEN), MUS_OK);
    ck_assert_int_eq(mus_tape_set_size(tape, "M50"), MUS_OK);
    ck_assert_int_eq(mus_tape_sex(tape), MUS_SEX_MALE);
    ck_assert_str_eq(mus_tape_name(tape), "M50");
    ck_assert_int_eq(mus_tape_source(tape, MUS_MEASURE_KNEE), MUS_SOURCE_NONE);
    ck_assert_int_eq(mus_tape_source(tape, MUS_MEASURE_BUST), MUS_SOURCE_GIVEN);
    ck_assert_int_eq(mus_tape_set_size(tape, "C104"), MUS_OK);
    ck_assert_int_eq(mus_tape_sex(tape), MUS_SEX_CHILD);
    mus_tape_destroy(tape);
    support_context_end(context);
}
END_TEST


START_TEST(no_size_has_a_warning)
{
    mus_context *context = support_context();
    for (int32_t i = 0; i < mus_tape_size_count(); i++) {
        mus_tape *tape = NULL;
        ck_assert_int_eq(mus_tape_create(context, &tape), MUS_OK);
        ck_assert_int_eq(mus_tape_set_size(tape, mus_tape_size_name(i)), MUS_OK);
        ck_assert_int_eq(mus_tape_complete(tape), MUS_OK);
        ck_assert_msg(mus_tape_warning_count(tape) == 0, "%s: %s", mus_tape_name(tape), mus_tape_warning(tape, 0));
        mus_tape_destroy(tape);
    }
    support_context_end(context);
}
END_TEST


START_TEST(an_unknown_size_is_refused_with_the_list)
{
    mus_context *context = support_context();
    mus_tape *tape = NULL;
    ck_assert_int_eq(mus_tape_create(context, &tape), MUS_OK);
    ck_assert_int_eq(mus_tape_set_size(tape, "W41"), MUS_ERR_ARG);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "W41"));
    for (int32_t i = 0; i < mus_tape_size_count(); i++)
        ck_assert_ptr_nonnull(strstr(mus_context_error(context), mus_tape_size_name(i)));
    ck_assert_int_eq(mus_tape_set_size(tape, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_tape_set_size(NULL, "W40"), MUS_ERR_ARG);
    ck_assert_ptr_null(mus_tape_size_name(-1));
    ck_assert_ptr_null(mus_tape_size_name(28));
    mus_tape_destroy(tape);
    support_context_end(context);
}
END_TEST


START_TEST(a_child_needs_only_its_stature)
{
    mus_context *context = support_context();
    mus_tape *tape = NULL, *row = NULL;
    ck_assert_int_eq(mus_tape_create(context, &tape), MUS_OK);
    ck_assert_int_eq(mus_tape_create(context, &row), MUS_OK);
    ck_assert_int_eq(mus_tape_set_sex(tape, MUS_SEX_CHILD), MUS_OK);
    ck_assert_int_eq(mus_tape_set(tape, MUS_MEASURE_STATURE, 1.16, MUS_SOURCE_GIVEN), MUS_OK);
    ck_assert_int_eq(mus_tape_complete(tape), MUS_OK);
    ck_assert_int_eq(mus_tape_set_size(row, "C116"), MUS_OK);
    ck_assert_int_eq(mus_tape_complete(row), MUS_OK);
    for (int32_t m = 0; m < MUS_MEASURE_COUNT; m++) {
        double a = mus_tape_value(tape, m), b = mus_tape_value(row, m);
        ck_assert_msg(fabs(a - b) < 1e-12 || (isnan(a) && isnan(b)), "%s %g %g", mus_measure_name(m), a, b);
    }
    mus_tape_destroy(tape);
    mus_tape_destroy(row);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_tape_size(void);
Suite *mus_suite_tape_size(void)
{
    Suite *suite = suite_create("tape_size");
    TCase *tests = tcase_create("tape_size");
    tcase_add_test(tests, all_sizes_are_the_printed_tables);
    tcase_add_test(tests, sizes_set_sex_name_and_clear_what_was_there);
    tcase_add_test(tests, no_size_has_a_warning);
    tcase_add_test(tests, an_unknown_size_is_refused_with_the_list);
    tcase_add_test(tests, a_child_needs_only_its_stature);
    suite_add_tcase(suite, tests);
    return suite;
}
