/*
 * test_tape_file.c: the text form of a tape: what a person may write, what is refused and in which words, and that
 * writing and reading give every bit back.
 */
#define _POSIX_C_SOURCE 200809L
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "comma_locale.h"
#include "muslin/exchange.h"
#include "support.h"


/* read a text as a tape */
static mus_status read_text(mus_context *context, const char *text, mus_tape **out)
{
    char path[512];
    support_spill(support_scratch("ada.tape", path, sizeof path), text, strlen(text));
    return mus_tape_read(context, path, NULL, out);
}


START_TEST(every_way_to_write_a_measure_is_read)
{
    mus_context *context = support_context();
    mus_tape *tape;
    const char *text = "\xEF\xBB\xBF# a remark\r\n"
                       "name   Ada # 2\r\n"
                       "sex    female\n"
                       "\n"
                       "bust   92 cm      # fullest\n"
                       "waist: 760mm\n"
                       "hip = 1.00 m\n"
                       "height 66 in\n"
                       "High Bust: 880 mm\n"
                       "shoulder slope 22 deg\n"
                       "arm-angle 0.75 rad\n"
                       "neck +3.6e1 cm";
    ck_assert_int_eq(read_text(context, text, &tape), MUS_OK);
    ck_assert_str_eq(mus_tape_name(tape), "Ada # 2");
    ck_assert_int_eq(mus_tape_sex(tape), MUS_SEX_FEMALE);
    ck_assert_double_eq(mus_tape_value(tape, MUS_MEASURE_BUST), 0.92);
    ck_assert_double_eq(mus_tape_value(tape, MUS_MEASURE_WAIST), 0.76);
    ck_assert_double_eq(mus_tape_value(tape, MUS_MEASURE_HIP), 1.0);
    ck_assert_double_eq_tol(mus_tape_value(tape, MUS_MEASURE_STATURE), 1.6764, 1e-15);
    ck_assert_double_eq(mus_tape_value(tape, MUS_MEASURE_HIGH_BUST), 0.88);
    ck_assert_double_eq_tol(mus_tape_value(tape, MUS_MEASURE_SHOULDER_SLOPE), 22 * 3.14159265358979 / 180, 1e-14);
    ck_assert_double_eq(mus_tape_value(tape, MUS_MEASURE_ARM_ANGLE), 0.75);
    ck_assert_double_eq(mus_tape_value(tape, MUS_MEASURE_NECK), 0.36);
    ck_assert_int_eq(mus_tape_source(tape, MUS_MEASURE_NECK), MUS_SOURCE_GIVEN);
    ck_assert_int_eq(mus_tape_source(tape, MUS_MEASURE_ARM), MUS_SOURCE_NONE);
    mus_tape_destroy(tape);
    support_context_end(context);
}
END_TEST


START_TEST(fractions_feet_and_a_decimal_comma_are_read)
{
    static const struct {
        const char *text;
        double inches, cm;
    } row[] = {
        {"bust 41 1/4 in", 41.25, 0},    {"bust: 41-1/4 inches", 41.25, 0}, {"bust 41¼ in", 41.25, 0},
        {"bust 41 ⅜\"", 41.375, 0},      {"bust 38\"", 38, 0},              {"bust = 38″", 38, 0},
        {"bust 38''", 38, 0},            {"bust 38.5 inch", 38.5, 0},       {"bust 3 ft", 36, 0},
        {"bust 3 ft 2 1/2 in", 38.5, 0}, {"bust 3'2\"", 38, 0},             {"bust 3' 2 1/2\" derived", 38.5, 0},
        {"bust 3 feet 2 inches", 38, 0}, {"bust 3′2″", 38, 0},              {"bust 92,5 cm", 0, 92.5},
        {"bust 0,925 m", 0, 92.5},       {"bust 0,92 m", 0, 92},            {"bust 925,0 mm # flat", 0, 92.5},
        {"bust 92,1250 cm", 0, 92.125},  {"bust 92 1/2 cm", 0, 92.5},
    };
    mus_context *context = support_context();
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        mus_tape *tape;
        mus_status status = read_text(context, row[i].text, &tape);
        ck_assert_msg(status == MUS_OK, "%s: %s", row[i].text, mus_context_error(context));
        const double bust = mus_tape_value(tape, MUS_MEASURE_BUST), wanted = row[i].cm / 100 + row[i].inches * 0.0254;
        ck_assert_msg(fabs(bust - wanted) < 1e-15, "%s: %.17g", row[i].text, bust);
        ck_assert_int_eq(mus_tape_source(tape, MUS_MEASURE_BUST),
                         strstr(row[i].text, "derived") != NULL ? MUS_SOURCE_DERIVED : MUS_SOURCE_GIVEN);
        mus_tape_destroy(tape);
    }
    support_context_end(context);
}
END_TEST


START_TEST(a_size_line_fills_the_tape_and_lines_below_overrule_it)
{
    mus_context *context = support_context();
    mus_tape *tape, *size;
    ck_assert_int_eq(read_text(context, "name Bo\nsize W40\nwaist 80 cm\n", &tape), MUS_OK);
    ck_assert_int_eq(mus_tape_create(context, &size), MUS_OK);
    ck_assert_int_eq(mus_tape_set_size(size, "W40"), MUS_OK);
    ck_assert_str_eq(mus_tape_name(tape), "Bo");
    ck_assert_int_eq(mus_tape_sex(tape), MUS_SEX_FEMALE);
    ck_assert_double_eq(mus_tape_value(tape, MUS_MEASURE_BUST), mus_tape_value(size, MUS_MEASURE_BUST));
    ck_assert_double_eq(mus_tape_value(tape, MUS_MEASURE_WAIST), 0.80);
    mus_tape_destroy(tape);
    mus_tape_destroy(size);
    support_context_end(context);
}
END_TEST


/* texts that are refused: text, status, a part of the message */
static const struct {
    const char *text;
    mus_status status;
    const char *line;
    const char *words;
} refusals[] = {
    {"bust 1,234 mm\n", MUS_ERR_FORMAT, "ada.tape:1:", "\"1,234 mm\" has a comma that may be one of thousands"},
    {"bust 1,234,5 mm\n", MUS_ERR_FORMAT, "ada.tape:1:", "no decimal comma"},
    {"bust 1.234,5 mm\n", MUS_ERR_FORMAT, "ada.tape:1:", "no decimal comma"},
    {"bust 92, cm\n", MUS_ERR_FORMAT, "ada.tape:1:", "no decimal comma"},
    {"bust 41 5/4 in\n", MUS_ERR_FORMAT, "ada.tape:1:", "a fraction that is not between 0 and 1"},
    {"bust 41 1/0 in\n", MUS_ERR_FORMAT, "ada.tape:1:", "a fraction that is not between 0 and 1"},
    {"bust 41 1/ in\n", MUS_ERR_FORMAT, "ada.tape:1:", "behind 41, got \"\""},
    {"bust 41.5 1/4 in\n", MUS_ERR_FORMAT, "ada.tape:1:", "behind 41.5, got \"\""},
    {"bust 41 1/4\n", MUS_ERR_FORMAT, "ada.tape:1:", "behind 41 1/4, got \"\""},
    {"height 5 ft 5\n", MUS_ERR_FORMAT, "ada.tape:1:", "expected a unit (in) behind 5, got \"\""},
    {"height 5 ft 5 cm\n", MUS_ERR_FORMAT, "ada.tape:1:", "expected a unit (in) behind 5, got \"cm\""},
    {"height 65 in 5 ft\n", MUS_ERR_FORMAT, "ada.tape:1:", "unexpected \"5 ft\" behind the unit"},
    {"height 5 ft 5 in 2 in\n", MUS_ERR_FORMAT, "ada.tape:1:", "unexpected \"2 in\" behind the unit"},
    {"shoulder_slope 20 ft\n", MUS_ERR_FORMAT, "ada.tape:1:", "expected a unit (deg or rad)"},
    {"\nbist 92 cm\n", MUS_ERR_FORMAT, "ada.tape:2:", "did you mean \"bust\""},
    {"colour of the eyes 92 cm\n", MUS_ERR_FORMAT, "ada.tape:1:", "unknown measure \"colour_of_the_eyes\""},
    {"bust 92\n", MUS_ERR_FORMAT, "ada.tape:1:", "expected a unit (mm, cm, m, in or ft)"},
    {"bust 92 deg\n", MUS_ERR_FORMAT, "ada.tape:1:", "expected a unit (mm, cm, m, in or ft)"},
    {"shoulder_slope 20 cm\n", MUS_ERR_FORMAT, "ada.tape:1:", "expected a unit (deg or rad)"},
    {"bust nan cm\n", MUS_ERR_FORMAT, "ada.tape:1:", "bust: expected a number"},
    {"bust inf cm\n", MUS_ERR_FORMAT, "ada.tape:1:", "bust: expected a number"},
    {"bust 0x5c cm\n", MUS_ERR_FORMAT, "ada.tape:1:", "expected a unit"},
    {"bust 1e999 cm\n", MUS_ERR_FORMAT, "ada.tape:1:", "too large"},
    {"bust\n", MUS_ERR_FORMAT, "ada.tape:1:", "bust: expected a number"},
    {"bust 92 cm 4\n", MUS_ERR_FORMAT, "ada.tape:1:", "unexpected \"4\""},
    {"bust 92 cm derived or so\n", MUS_ERR_FORMAT, "ada.tape:1:", "unexpected"},
    {"bust 92 cm\nchest 93 cm\n", MUS_ERR_FORMAT, "ada.tape:2:", "line 1"},
    {"bust 1e9 cm\n", MUS_ERR_TAPE, "ada.tape:1:", "bust"},
    {"bust 0 cm\n", MUS_ERR_TAPE, "ada.tape:1:", "bust"},
    {"bust -92 cm\n", MUS_ERR_TAPE, "ada.tape:1:", "bust"},
    {"bust 92 m\n", MUS_ERR_TAPE, "ada.tape:1:", "bust"},
    {"bust 920 cm\n", MUS_ERR_TAPE, "ada.tape:1:", "is the unit mm?"},
    {"sex lady\n", MUS_ERR_FORMAT, "ada.tape:1:", "female, male or child"},
    {"sex male\nsex male\n", MUS_ERR_FORMAT, "ada.tape:2:", "second time"},
    {"size W41\n", MUS_ERR_FORMAT, "ada.tape:1:", "W40"},
    {"bust 92 cm\nsize W40\n", MUS_ERR_FORMAT, "ada.tape:2:", "above the measures"},
    {"size W40\nsex male\n", MUS_ERR_FORMAT, "ada.tape:2:", "size above"},
    {"name 0123456789012345678901234567890123456789012345678901234567890123456789\n", MUS_ERR_FORMAT,
     "ada.tape:1:", "limit is 63"},
    {"bust \xff\xfe cm\n", MUS_ERR_FORMAT, "ada.tape:1:", "UTF-8"},
};


START_TEST(a_line_that_is_not_understood_is_named)
{
    mus_context *context = support_context();
    mus_tape *tape = (mus_tape *)&context;
    mus_status status = read_text(context, refusals[_i].text, &tape);
    const char *error = mus_context_error(context);
    ck_assert_msg(status == refusals[_i].status, "%d for %s: %s", (int)status, refusals[_i].text, error);
    ck_assert_ptr_null(tape);
    ck_assert_msg(strstr(error, refusals[_i].line) != NULL, "no %s in: %s", refusals[_i].line, error);
    ck_assert_msg(strstr(error, refusals[_i].words) != NULL, "no %s in: %s", refusals[_i].words, error);
    support_context_end(context);
}
END_TEST


START_TEST(a_zero_byte_is_refused_with_its_place)
{
    mus_context *context = support_context();
    mus_tape *tape;
    char path[512];
    support_spill(support_scratch("zero.tape", path, sizeof path), "bust 92 cm\n\0 waist", 18);
    ck_assert_int_eq(mus_tape_read(context, path, NULL, &tape), MUS_ERR_FORMAT);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "byte 11"));
    support_context_end(context);
}
END_TEST


START_TEST(a_file_that_cannot_be_read_is_named)
{
    mus_context *context = support_context();
    mus_tape *tape;
    char path[512];
    ck_assert_int_eq(mus_tape_read(context, support_scratch("none.tape", path, sizeof path), NULL, &tape),
                     MUS_ERR_FILE);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "none.tape: cannot be opened"));
    ck_assert_int_eq(mus_tape_read(context, support_scratch("a.doc", path, sizeof path), NULL, &tape), MUS_ERR_FORMAT);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), ".vit or .csv"));
    ck_assert_int_eq(mus_tape_read(context, "x.tape", "row", &tape), MUS_ERR_ARG);
    ck_assert_int_eq(mus_tape_read(context, "x.csv", NULL, &tape), MUS_ERR_ARG);
    ck_assert_int_eq(mus_tape_read(context, NULL, NULL, &tape), MUS_ERR_ARG);
    ck_assert_int_eq(mus_tape_read(context, "x.tape", NULL, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_tape_read(NULL, "x.tape", NULL, &tape), MUS_ERR_ARG);
    support_context_end(context);
}
END_TEST


START_TEST(a_tape_that_is_written_reads_back_bit_for_bit)
{
    mus_context *context = support_context();
    uint64_t seed = 1;
    char path[512];
    support_scratch("back.tape", path, sizeof path);
    for (int trial = 0; trial < 200; trial++) {
        mus_tape *tape, *back;
        ck_assert_int_eq(mus_tape_create(context, &tape), MUS_OK);
        ck_assert_int_eq(mus_tape_set_name(tape, "Zo\xC3\xAB # 1"), MUS_OK);
        ck_assert_int_eq(mus_tape_set_sex(tape, trial % 4), MUS_OK);
        for (int32_t i = 0; i < MUS_MEASURE_COUNT; i++) {
            double value = 0.3 + 0.7 * support_uniform(&seed, 0.0, 1.0);
            if (trial % 2 == 0) value = floor(value * 1000.0) / 1000.0;
            if (support_random(&seed) % 3 > 0) (void)mus_tape_set(tape, i, value, MUS_SOURCE_GIVEN);
        }
        ck_assert_int_eq(mus_tape_write(tape, path), MUS_OK);
        mus_status status = mus_tape_read(context, path, NULL, &back);
        ck_assert_msg(status == MUS_OK, "%s", mus_context_error(context));
        ck_assert_str_eq(mus_tape_name(back), mus_tape_name(tape));
        ck_assert_int_eq(mus_tape_sex(back), mus_tape_sex(tape));
        for (int32_t i = 0; i < MUS_MEASURE_COUNT; i++) {
            double a = mus_tape_value(tape, i), b = mus_tape_value(back, i);
            ck_assert_int_eq(memcmp(&a, &b, sizeof a), 0);
            ck_assert_int_eq(mus_tape_source(tape, i), mus_tape_source(back, i));
        }
        mus_tape_destroy(tape);
        mus_tape_destroy(back);
    }
    support_context_end(context);
}
END_TEST


START_TEST(derived_measures_are_remarks_and_come_back_by_completion)
{
    mus_context *context = support_context();
    mus_tape *tape, *back;
    char path[512];
    support_scratch("w40.tape", path, sizeof path);
    ck_assert_int_eq(mus_tape_create(context, &tape), MUS_OK);
    ck_assert_int_eq(mus_tape_set_size(tape, "W40"), MUS_OK);
    ck_assert_int_eq(mus_tape_complete(tape), MUS_OK);
    ck_assert_int_eq(mus_tape_write(tape, path), MUS_OK);
    ck_assert_int_eq(mus_tape_read(context, path, NULL, &back), MUS_OK);
    ck_assert_int_eq(mus_tape_complete(back), MUS_OK);
    for (int32_t i = 0; i < MUS_MEASURE_COUNT; i++) {
        double a = mus_tape_value(tape, i), b = mus_tape_value(back, i);
        ck_assert_int_eq(memcmp(&a, &b, sizeof a), 0);
        ck_assert_int_eq(mus_tape_source(tape, i), mus_tape_source(back, i));
    }

    /* the round figures of a table stay readable */
    char *text = support_slurp(path, NULL);
    ck_assert_ptr_nonnull(text);
    ck_assert_ptr_nonnull(strstr(text, "\nbust 92 cm\n"));
    ck_assert_ptr_nonnull(strstr(text, "\n# "));
    free(text);
    mus_tape_destroy(tape);
    mus_tape_destroy(back);
    support_context_end(context);
}
END_TEST


START_TEST(a_comma_locale_changes_nothing)
{
    if (!comma_locale()) return;
    mus_context *context = support_context();
    mus_tape *tape;
    char path[512];
    ck_assert_int_eq(read_text(context, "bust 92.5 cm\nsex female\nwaist 76.25 cm\n", &tape), MUS_OK);
    ck_assert_double_eq(mus_tape_value(tape, MUS_MEASURE_BUST), 0.925);
    ck_assert_int_eq(mus_tape_write(tape, support_scratch("comma.tape", path, sizeof path)), MUS_OK);
    char *text = support_slurp(path, NULL);
    ck_assert_ptr_nonnull(strstr(text, "bust 92.5 cm\nwaist 76.25 cm\n"));
    ck_assert_str_eq(localeconv()->decimal_point, ",");
    free(text);
    mus_tape_destroy(tape);
    support_context_end(context);
}
END_TEST


START_TEST(the_example_of_the_manual_page_is_read)
{
    char *page = support_slurp("man/muslin_tape.5", NULL);
    if (page == NULL) {
        printf("skipped: no man/muslin_tape.5 here\n");
        return;
    }
    char *text = strstr(page, "# measured on Tuesday"), *end = strstr(text, ".Ed");
    ck_assert_ptr_nonnull(end);
    *end = '\0';
    mus_context *context = support_context();
    mus_tape *tape;
    mus_status status = read_text(context, text, &tape);
    ck_assert_msg(status == MUS_OK, "%s", mus_context_error(context));
    ck_assert_int_eq(mus_tape_complete(tape), MUS_OK);
    mus_tape_destroy(tape);
    free(page);
    support_context_end(context);
}
END_TEST


START_TEST(each_allocation_that_fails_is_a_status_and_no_leak)
{
    char path[512];
    const char *text = "name Ada\nsize W40\nbust 92 cm\n";
    support_spill(support_scratch("fail.tape", path, sizeof path), text, strlen(text));
    int64_t failed = 0;
    for (int64_t n = 0;; n++) {
        mus_context *context = support_context();
        mus_tape *tape = NULL;
        support_fail_after(n, false);
        mus_status status = mus_tape_read(context, path, NULL, &tape);
        if (status == MUS_OK) status = mus_tape_write(tape, path);
        support_fail_never();
        mus_tape_destroy(tape);
        if (status != MUS_OK) ck_assert_int_gt((int)strlen(mus_context_error(context)), 10);
        support_context_end(context);
        if (status == MUS_OK) break;
        ck_assert_int_eq(status, MUS_ERR_MEMORY);
        failed++;
    }
    ck_assert_int_ge(failed, 4);
}
END_TEST


Suite *mus_suite_tape_file(void);

Suite *mus_suite_tape_file(void)
{
    Suite *suite = suite_create("tape_file");
    TCase *tests = tcase_create("tape_file");
    tcase_add_test(tests, every_way_to_write_a_measure_is_read);
    tcase_add_test(tests, fractions_feet_and_a_decimal_comma_are_read);
    tcase_add_test(tests, a_size_line_fills_the_tape_and_lines_below_overrule_it);
    tcase_add_loop_test(tests, a_line_that_is_not_understood_is_named, 0, sizeof refusals / sizeof refusals[0]);
    tcase_add_test(tests, a_zero_byte_is_refused_with_its_place);
    tcase_add_test(tests, a_file_that_cannot_be_read_is_named);
    tcase_add_test(tests, a_tape_that_is_written_reads_back_bit_for_bit);
    tcase_add_test(tests, derived_measures_are_remarks_and_come_back_by_completion);
    tcase_add_test(tests, a_comma_locale_changes_nothing);
    tcase_add_test(tests, the_example_of_the_manual_page_is_read);
    tcase_add_test(tests, each_allocation_that_fails_is_a_status_and_no_leak);
    suite_add_tcase(suite, tests);
    return suite;
}
