/*
 * test_tape_vit.c: Valentina's measurement files: units, zeros, formulas, names of the user's own, and the real files.
 */
#include <stdio.h>
#include <string.h>

#include "muslin/exchange.h"
#include "support.h"

#define VIT(unit, measures)                                                                                            \
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<vit><version>0.3.3</version>\n<unit>" unit                           \
    "</unit>\n<personal><given-name>Ada</given-name><gender>female</gender></personal>\n"                              \
    "<body-measurements>\n" measures "\n</body-measurements></vit>\n"


static mus_status read_text(mus_context *context, const char *text, mus_tape **out)
{
    char path[512];
    support_spill(support_scratch("ada.vit", path, sizeof path), text, strlen(text));
    return mus_tape_read(context, path, NULL, out);
}


START_TEST(values_are_in_the_unit_of_the_file)
{
    static const struct {
        const char *text;
        double bust;
    } units[] = {
        {VIT("cm", "<m name=\"bust_circ\" value=\"92\"/><m name=\"shoulder_slope_neck_side_angle\" value=\"20\"/>"),
         .92},
        {VIT("mm", "<m name=\"bust_circ\" value=\"920\"/><m name=\"shoulder_slope_neck_side_angle\" value=\"20\"/>"),
         .92},
        {VIT("inch", "<m name=\"bust_circ\" value=\"36\"/><m name=\"shoulder_slope_neck_side_angle\" value=\"20\"/>"),
         .9144},
    };
    mus_context *context = support_context();
    for (size_t i = 0; i < 3; i++) {
        mus_tape *tape;
        mus_status status = read_text(context, units[i].text, &tape);
        ck_assert_msg(status == MUS_OK, "%s", mus_context_error(context));
        ck_assert_double_eq_tol(mus_tape_value(tape, MUS_MEASURE_BUST), units[i].bust, 1e-14);
        ck_assert_double_eq_tol(mus_tape_value(tape, MUS_MEASURE_SHOULDER_SLOPE), 0.34906585039886592, 1e-15);
        ck_assert_int_eq(mus_tape_sex(tape), MUS_SEX_FEMALE);
        mus_tape_destroy(tape);
    }
    support_context_end(context);
}
END_TEST


START_TEST(zero_is_not_measured_and_own_names_are_left_out)
{
    mus_context *context = support_context();
    mus_tape *tape;
    mus_status status =
        read_text(context,
                  VIT("cm", "<m name=\"waist_circ\" value=\" 76&#10;\"/><m name=\"hip_circ\" value=\"0\"/>"
                            "<m name=\"@skirt\" value=\"@waist*2\"/><m name=\"neck_circ\" value=\"\"/>"
                            "<m name=\"waist_natural_circ\" value=\"82\"/>"),
                  &tape);
    ck_assert_msg(status == MUS_OK, "%s", mus_context_error(context));
    ck_assert_double_eq(mus_tape_value(tape, MUS_MEASURE_WAIST), 0.76);
    ck_assert_int_eq(mus_tape_source(tape, MUS_MEASURE_HIP), MUS_SOURCE_NONE);
    ck_assert_int_eq(mus_tape_source(tape, MUS_MEASURE_NECK), MUS_SOURCE_NONE);
    ck_assert_ptr_nonnull(strstr(support_log(), "ada.vit: not used: @skirt"));
    mus_tape_destroy(tape);
    support_context_end(context);
}
END_TEST


static const struct {
    const char *text;
    mus_status status;
    const char *words;
} refusals[] = {
    {VIT("cm", "<m name=\"hip_circ\" value=\"waist_circ+20\"/>"), MUS_ERR_UNSUPPORTED,
     "ada.vit:6: hip_circ: expected a number, \"waist_circ+20\" is a formula"},
    {VIT("cm", "\n<m name=\"hip_circ\" value=\"@x\"/>"), MUS_ERR_UNSUPPORTED, "ada.vit:7: hip_circ"},
    {VIT("cm", "<m name=\"hip_circ\" value=\"nan\"/>"), MUS_ERR_UNSUPPORTED, "hip_circ"},
    {VIT("mm", "<m name=\"hip_circ\" value=\"1,234\"/>"), MUS_ERR_FORMAT, "ada.vit:6: hip_circ"},
    {VIT("mm", "<m name=\"@a\" value=\"92\"/><m name=\"@b\" value=\"0\"/><m name=\"@М_2\" value=\"3\"/>"),
     MUS_ERR_FORMAT, "ada.vit: no measure that muslin knows was found; there are @a, @М_2"},
    {VIT("cm", "<m name=\"@Сг\" value=\"hip_circ/2\"/>"), MUS_ERR_UNSUPPORTED, "@Сг: expected a number"},
    {VIT("cm", "<m name=\"hip_circ\" value=\"0\"/>"), MUS_ERR_FORMAT, "no measure that muslin knows was found"},
    {VIT("cm", "<m name=\"hip_circ\" value=\"90+2\"/>"), MUS_ERR_FORMAT, "hip_circ"},
    {VIT("cm", "<m name=\"hip_circ\" value=\"92-1/2\"/>"), MUS_ERR_UNSUPPORTED, "\"92-1/2\" is a formula"},
    {VIT("cm", "<m name=\"hip_circ\" value=\"1e9\"/>"), MUS_ERR_TAPE, "ada.vit:6: hip"},
    {VIT("cm", "<m name=\"hip_circ\" value=\"-92\"/>"), MUS_ERR_TAPE, "ada.vit:6: hip"},
    {VIT("cm", "<m name=\"hip_circ\"/>"), MUS_ERR_FORMAT, "hip_circ: expected a value"},
    {VIT("cm", "<m value=\"3\"/>"), MUS_ERR_FORMAT, "<m> without a name"},
    {VIT("cm", "<m name=\"hip_circ\" value=\"92\"/><m name=\"hip_circ\" value=\"93\"/>"), MUS_ERR_FORMAT, "already"},
    {VIT("ell", "<m name=\"hip_circ\" value=\"92\"/>"), MUS_ERR_FORMAT, "expected mm, cm or inch, got \"ell\""},
    {"<vst><unit>mm</unit></vst>", MUS_ERR_FORMAT, "ada.vit:1: expected <vit>, got <vst>"},
    {"<vit><unit>mm</unit>", MUS_ERR_FORMAT, "expected XML"},
    {"", MUS_ERR_FORMAT, "expected XML"},
    {"bust 92 cm\n", MUS_ERR_FORMAT, "expected XML"},
    {"<!DOCTYPE vit [<!ENTITY a \"aaaa\">]><vit><unit>cm</unit></vit>", MUS_ERR_FORMAT, "document type"},
};


START_TEST(a_fault_is_named_with_its_line)
{
    mus_context *context = support_context();
    mus_tape *tape = (mus_tape *)&context;
    mus_status status = read_text(context, refusals[_i].text, &tape);
    const char *error = mus_context_error(context);
    ck_assert_msg(status == refusals[_i].status, "%d for %s: %s", (int)status, refusals[_i].text, error);
    ck_assert_ptr_null(tape);
    ck_assert_msg(strstr(error, refusals[_i].words) != NULL, "no \"%s\" in: %s", refusals[_i].words, error);
    support_context_end(context);
}
END_TEST


START_TEST(a_stature_that_is_missing_follows_from_the_nape_or_else_from_the_waist)
{
    static const struct {
        const char *text;
        double stature;
        int32_t source;
    } row[] = {
        {VIT("cm", "<m name=\"height_neck_back\" value=\"144\"/><m name=\"height_waist_side\" value=\"110\"/>"),
         1.44 / 0.857, MUS_SOURCE_DERIVED},
        {VIT("cm", "<m name=\"height_waist_side\" value=\"104.5\"/>"), 1.045 / 0.622, MUS_SOURCE_DERIVED},
        {VIT("cm", "<m name=\"height\" value=\"170\"/><m name=\"height_waist_side\" value=\"104.5\"/>"), 1.70,
         MUS_SOURCE_GIVEN},
        {"<vit><unit>cm</unit><body-measurements><m name=\"height_waist_side\" value=\"104.5\"/></body-measurements>"
         "</vit>",
         1.045 / 0.6185, MUS_SOURCE_DERIVED},
    };
    mus_context *context = support_context();
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        mus_tape *tape;
        ck_assert_msg(read_text(context, row[i].text, &tape) == MUS_OK, "%s", mus_context_error(context));
        ck_assert_double_eq_tol(mus_tape_value(tape, MUS_MEASURE_STATURE), row[i].stature, 1e-12);
        ck_assert_int_eq(mus_tape_source(tape, MUS_MEASURE_STATURE), row[i].source);
        mus_tape_destroy(tape);
    }
    support_context_end(context);
}
END_TEST


START_TEST(letters_of_the_russian_standards_are_read_halves_doubled)
{
    mus_context *context = support_context();
    mus_tape *tape;
    mus_status status = read_text(context,
                                  VIT("cm", "<m name=\"@Сг\" value=\"46\"/><m name=\"@Ст\" value=\"37,5\"/>"
                                            "<m name=\"@Сб\" value=\"51\"/><m name=\"@Р\" value=\"164\"/>"
                                            "<m name=\"@Шп\" value=\"12 1/2\"/>"
                                            "<m name=\"hip_circ\" value=\"100\"/>"
                                            "<m name=\"@Ди\" value=\"80\"/>"),
                                  &tape);
    ck_assert_msg(status == MUS_OK, "%s", mus_context_error(context));
    ck_assert_double_eq(mus_tape_value(tape, MUS_MEASURE_BUST), 0.92);
    ck_assert_double_eq(mus_tape_value(tape, MUS_MEASURE_WAIST), 0.75);
    ck_assert_double_eq(mus_tape_value(tape, MUS_MEASURE_HIP), 1.0);
    ck_assert_double_eq(mus_tape_value(tape, MUS_MEASURE_STATURE), 1.64);
    ck_assert_double_eq(mus_tape_value(tape, MUS_MEASURE_SHOULDER), 0.125);
    ck_assert_ptr_nonnull(strstr(support_log(), "not used: @Ди"));
    mus_tape_destroy(tape);
    support_context_end(context);
}
END_TEST


START_TEST(real_files_are_read)
{
    /* name, and the waist that measurements say (m, 0: not measured, -1: no measure at all, which is refused) */
    static const struct {
        const char *name;
        double waist;
    } files[] = {{"gost_man_440_1640", .66}, {"gost_man_500_1760", .78}, {"gost_man_560_1880", .90}, {"person_01", 0},
                 {"person_03", .64},         {"person_05", .95},         {"person_07", -1},          {"person_09", -1},
                 {"person_11", 0},           {"person_13", 0},           {"person_15", .5334}, {"person_17", .516},
                 {"person_19", .45},         {"person_21", .76},         {"person_23", .79}};
    mus_context *context = support_context();
    int32_t complete = 0;
    for (size_t i = 0; i < sizeof files / sizeof files[0]; i++) {
        char relative[128], path[512];
        snprintf(relative, sizeof relative, "valentina/measurements/%s.vit", files[i].name);
        if (support_data(relative, path, sizeof path) == NULL) break;
        mus_tape *tape;
        mus_status status = mus_tape_read(context, path, NULL, &tape);
        if (files[i].waist < 0) {
            ck_assert_int_eq(status, MUS_ERR_FORMAT);
            continue;
        }
        ck_assert_msg(status == MUS_OK, "%s", mus_context_error(context));
        if (files[i].waist > 0)
            ck_assert_double_eq_tol(mus_tape_value(tape, MUS_MEASURE_WAIST), files[i].waist, 1e-12);
        else
            ck_assert_int_eq(mus_tape_source(tape, MUS_MEASURE_WAIST), MUS_SOURCE_NONE);

        /* the tables of GOST are whole; of the persons one has stature, bust, waist and hip */
        status = mus_tape_complete(tape);
        ck_assert_msg(status == MUS_OK || status == MUS_ERR_TAPE, "%s", mus_context_error(context));
        if (i < 3) ck_assert_msg(status == MUS_OK, "%s: %s", files[i].name, mus_context_error(context));
        complete += status == MUS_OK;
        mus_tape_destroy(tape);
    }
    if (complete > 0) ck_assert_int_eq(complete, 4);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_tape_vit(void);

Suite *mus_suite_tape_vit(void)
{
    Suite *suite = suite_create("tape_vit");
    TCase *tests = tcase_create("tape_vit");
    tcase_add_test(tests, values_are_in_the_unit_of_the_file);
    tcase_add_test(tests, zero_is_not_measured_and_own_names_are_left_out);
    tcase_add_loop_test(tests, a_fault_is_named_with_its_line, 0, sizeof refusals / sizeof refusals[0]);
    tcase_add_test(tests, a_stature_that_is_missing_follows_from_the_nape_or_else_from_the_waist);
    tcase_add_test(tests, letters_of_the_russian_standards_are_read_halves_doubled);
    tcase_add_test(tests, real_files_are_read);
    suite_add_tcase(suite, tests);
    return suite;
}
