/*
 * test_tape_csv.c: rows of csv tables: the twelve of FreeSewing's models, the general form, quotes, and what is
 * refused.
 */
#include <string.h>

#include "muslin/exchange.h"
#include "support.h"


static mus_status read_text(mus_context *context, const char *text, const char *row, mus_tape **out)
{
    char path[512];
    support_spill(support_scratch("people.csv", path, sizeof path), text, strlen(text));
    return mus_tape_read(context, path, row, out);
}


START_TEST(the_general_form_has_measures_with_units)
{
    mus_context *context = support_context();
    mus_tape *tape;
    const char *text = "who,sex,bust_cm,\"waist_mm\",hip_m,notes,shoulder_slope_deg,arm_angle_rad\r\n"
                       "Ada,female,92.5,760,1.0,\"likes \"\"red\"\", not\nblue\",20,0.7\r\n"
                       "\r\n"
                       "\"Bo, jr\",male,,1e3,,,,\r\n";
    mus_status status = read_text(context, text, "Ada", &tape);
    ck_assert_msg(status == MUS_OK, "%s", mus_context_error(context));
    ck_assert_str_eq(mus_tape_name(tape), "Ada");
    ck_assert_int_eq(mus_tape_sex(tape), MUS_SEX_FEMALE);
    ck_assert_double_eq(mus_tape_value(tape, MUS_MEASURE_BUST), 0.925);
    ck_assert_double_eq(mus_tape_value(tape, MUS_MEASURE_WAIST), 0.76);
    ck_assert_double_eq(mus_tape_value(tape, MUS_MEASURE_HIP), 1.0);
    ck_assert_double_eq(mus_tape_value(tape, MUS_MEASURE_ARM_ANGLE), 0.7);
    ck_assert_double_eq_tol(mus_tape_value(tape, MUS_MEASURE_SHOULDER_SLOPE), 0.34906585039886592, 1e-15);
    ck_assert_ptr_nonnull(strstr(support_log(), "not used: notes"));
    mus_tape_destroy(tape);

    ck_assert_int_eq(read_text(context, text, "Bo, jr", &tape), MUS_OK);
    ck_assert_int_eq(mus_tape_sex(tape), MUS_SEX_MALE);
    ck_assert_double_eq(mus_tape_value(tape, MUS_MEASURE_WAIST), 1.0);
    ck_assert_int_eq(mus_tape_source(tape, MUS_MEASURE_BUST), MUS_SOURCE_NONE);
    mus_tape_destroy(tape);
    support_context_end(context);
}
END_TEST


static const struct {
    const char *text;
    mus_status status;
    const char *words;
} refusals[] = {
    {"name,bust_cm\nBo,92\n", MUS_ERR_ARG, "no row \"Ada\"; there are Bo"},
    {"name,bust_cm\nAda,92\nAda,93\n", MUS_ERR_FORMAT, "people.csv:3: row \"Ada\" stands in line 2"},
    {"name,bust_cm\nAda,92,93\n", MUS_ERR_FORMAT, "people.csv:2: expected 2 fields, got 3"},
    {"name;bust_cm\nAda;92\n", MUS_ERR_FORMAT, "people.csv:1: expected a line of column names with commas"},
    {"name,bust_mm\nAda,\"1,234\"\n", MUS_ERR_FORMAT, "people.csv:2: bust_mm: expected a number, \"1,234\" has a"},
    {"name,remark\nAda,none\n", MUS_ERR_FORMAT, "people.csv: no measure that muslin knows was found; there are remark"},
    {"name,bust_cm\nAda,nan\n", MUS_ERR_FORMAT, "\"nan\" is not a number"},
    {"name,bust_cm\nAda,1e9\n", MUS_ERR_TAPE, "people.csv:2: bust"},
    {"name,bust_cm\nAda,\"92\n", MUS_ERR_FORMAT, "people.csv:2: a field whose quotes do not end"},
    {"name,bust_cm\nAda,\"92\"x\n", MUS_ERR_FORMAT, "behind the quotes"},
    {"name,bist_cm\nAda,92\n", MUS_ERR_FORMAT, "people.csv:1: unknown measure \"bist\", near \"bust\""},
    {"name,bust_deg\nAda,92\n", MUS_ERR_FORMAT, "unknown measure \"bust\""},
    {"name,bust_cm,chest_cm\nAda,92,93\n", MUS_ERR_FORMAT, "two columns hold the measure bust"},
    {"name,sex,bust_cm\nAda,lady,93\n", MUS_ERR_FORMAT, "people.csv:2: sex: expected female, male or child"},
    {"model,waist\nAda,930\n", MUS_ERR_FORMAT, "expected a model named cisFemale"},
    {"", MUS_ERR_FORMAT, "people.csv:1: expected a line of column names"},
};


START_TEST(a_fault_is_named_with_its_line)
{
    mus_context *context = support_context();
    mus_tape *tape = (mus_tape *)&context;
    mus_status status = read_text(context, refusals[_i].text, "Ada", &tape);
    const char *error = mus_context_error(context);
    ck_assert_msg(status == refusals[_i].status, "%d for %s: %s", (int)status, refusals[_i].text, error);
    ck_assert_ptr_null(tape);
    ck_assert_msg(strstr(error, refusals[_i].words) != NULL, "no \"%s\" in: %s", refusals[_i].words, error);
    support_context_end(context);
}
END_TEST


/* else the tape would be written with a name that the reader refuses */
START_TEST(a_row_whose_name_is_not_utf8_is_refused)
{
    mus_context *context = support_context();
    mus_tape *tape;
    ck_assert_int_eq(read_text(context, "name,bust_cm\nAd\xd3,92\n", "Ad\xd3", &tape), MUS_ERR_FORMAT);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "not UTF-8 at byte 2"));
    ck_assert_ptr_null(tape);
    support_context_end(context);
}
END_TEST


/* the table's own figures (mm) of each row, read off it by eye */
static const struct {
    const char *row;
    double chest, hips, seat, waist_to_floor;
    bool adult, male;
} models[] = {
    {"cisFemaleAdult30", 816, 794, 939, 1001, true, false},
    {"cisFemaleAdult36", 979, 953, 1046, 1075, true, false},
    {"cisFemaleAdult38", 1034, 1006, 1081, 1099, true, false},
    {"cisFemaleAdult44", 1197, 1165, 1188, 1174, true, false},
    {"cisFemaleAdult46", 1251, 1218, 1224, 1198, true, false},
    {"cisMaleAdult34", 895, 752, 956, 1111, true, true},
    {"cisMaleAdult36", 947, 796, 988, 1136, true, true},
    {"cisMaleAdult40", 1053, 884, 1052, 1184, true, true},
    {"cisMaleAdult44", 1158, 973, 1117, 1233, true, true},
    {"cisMaleAdult48", 1263, 1061, 1181, 1282, true, true},
    {"cisFemaleDoll30", 277.5, 270, 303, 315, false, false},
    {"cisMaleGiant150", 1500, 1260, 1530, 1740, false, true},
};


START_TEST(freesewing_models_are_read_and_adults_build)
{
    char path[512];
    if (support_data("freesewing/models.csv", path, sizeof path) == NULL) return;
    mus_context *context = support_context();
    mus_tape *tape;
    mus_body *body = NULL;
    mus_status status = mus_tape_read(context, path, models[_i].row, &tape);

    /* the doll's head is below what any tape takes */
    if (!models[_i].adult && status == MUS_ERR_TAPE) {
        ck_assert_ptr_nonnull(strstr(mus_context_error(context), "models.csv:12: head of"));
        support_context_end(context);
        return;
    }
    ck_assert_msg(status == MUS_OK, "%s", mus_context_error(context));
    ck_assert_int_eq(mus_tape_sex(tape), models[_i].male ? MUS_SEX_MALE : MUS_SEX_FEMALE);
    ck_assert_double_eq_tol(mus_tape_value(tape, MUS_MEASURE_BUST), models[_i].chest / 1e3, 1e-12);
    ck_assert_double_eq_tol(mus_tape_value(tape, MUS_MEASURE_HIGH_HIP), models[_i].hips / 1e3, 1e-12);
    ck_assert_double_eq_tol(mus_tape_value(tape, MUS_MEASURE_HIP), models[_i].seat / 1e3, 1e-12);
    double stature = models[_i].waist_to_floor / 1e3 / (models[_i].male ? 0.615 : 0.622);
    ck_assert_double_eq_tol(mus_tape_value(tape, MUS_MEASURE_STATURE), stature, 1e-12);
    ck_assert_int_eq(mus_tape_source(tape, MUS_MEASURE_STATURE), MUS_SOURCE_DERIVED);

    /* the doll and the giant build too, or are refused by name */
    status = mus_tape_complete(tape);
    if (status == MUS_OK) {
        ck_assert_int_eq(mus_tape_source(tape, MUS_MEASURE_STATURE), MUS_SOURCE_DERIVED);
        ck_assert_double_eq_tol(mus_tape_value(tape, MUS_MEASURE_STATURE), stature, 1e-12);
        status = mus_body_create(context, tape, NULL, &body);
    }
    if (models[_i].adult) ck_assert_msg(status == MUS_OK, "%s: %s", models[_i].row, mus_context_error(context));
    ck_assert(status == MUS_OK || status == MUS_ERR_TAPE || status == MUS_ERR_BODY);
    if (status != MUS_OK) ck_assert_int_gt((int)strlen(mus_context_error(context)), 10);
    mus_body_destroy(body);
    mus_tape_destroy(tape);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_tape_csv(void);

Suite *mus_suite_tape_csv(void)
{
    Suite *suite = suite_create("tape_csv");
    TCase *tests = tcase_create("tape_table");
    tcase_add_test(tests, the_general_form_has_measures_with_units);
    tcase_add_loop_test(tests, a_fault_is_named_with_its_line, 0, sizeof refusals / sizeof refusals[0]);
    tcase_add_test(tests, a_row_whose_name_is_not_utf8_is_refused);
    tcase_add_loop_test(tests, freesewing_models_are_read_and_adults_build, 0, sizeof models / sizeof models[0]);
    suite_add_tcase(suite, tests);
    return suite;
}
