/*
 * test_tape_yaml.c: GarmentCode body files: the heights that follow from their lengths, by hand; the three real
 * bodies complete; what is refused and in which words.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "muslin/exchange.h"
#include "support.h"

#define DEGREE (3.14159265358979323846 / 180.0)


static mus_status read_text(mus_context *context, const char *text, mus_tape **out)
{
    char path[512];
    support_spill(support_scratch("body.yaml", path, sizeof path), text, strlen(text));
    return mus_tape_read(context, path, NULL, out);
}


START_TEST(heights_follow_from_the_lengths_of_the_file)
{
    mus_context *context = support_context();
    mus_tape *tape;
    mus_status status = read_text(context,
                                  "body:\n  height: 170 # crown\n  head_l: 25\n  waist_line: 40\n  hips_line: 20.5\n"
                                  "  crotch_hip_diff: 9.5\n  vert_bust_line: 22\n  hips: 100\n  leg_circ: 60\n"
                                  "  shoulder_w: 37\n  neck_w: 17\n  shoulder_incl: 20\n  bust_points: 17\n"
                                  "  arm_pose_angle: 45\n  back_width: 47\n",
                                  &tape);
    ck_assert_msg(status == MUS_OK, "%s", mus_context_error(context));
    static const struct {
        int32_t measure;
        double value;
    } hand[] = {
        {MUS_MEASURE_STATURE, 1.70},
        {MUS_MEASURE_NAPE_HEIGHT, 1.45 + 0.0165 * 1.70},
        {MUS_MEASURE_WAIST_HEIGHT, 1.05},
        {MUS_MEASURE_WAIST_TO_HIP, .205},
        {MUS_MEASURE_RISE, .30},
        {MUS_MEASURE_INLEG, .75},
        {MUS_MEASURE_BUST_HEIGHT, 1.23},
        {MUS_MEASURE_HIP, 1.0},
        {MUS_MEASURE_THIGH, .60},
        {MUS_MEASURE_BUST_SPAN, .17},
        {MUS_MEASURE_ARM_ANGLE, 45 * DEGREE},
        {MUS_MEASURE_SHOULDER_SLOPE, 20 * DEGREE},
    };
    for (size_t i = 0; i < sizeof hand / sizeof hand[0]; i++)
        ck_assert_double_eq_tol(mus_tape_value(tape, hand[i].measure), hand[i].value, 1e-12);
    ck_assert_int_eq(mus_tape_source(tape, MUS_MEASURE_ACROSS_BACK), MUS_SOURCE_NONE);
    ck_assert_int_eq(mus_tape_source(tape, MUS_MEASURE_BUST), MUS_SOURCE_NONE);
    ck_assert_str_eq(mus_tape_name(tape), "body");
    ck_assert_ptr_nonnull(strstr(support_log(), "not used: back_width"));

    /* without bust and waist there is no neck, so no shoulder; the nape is as much above the level as the side of the
     * neck base is below the nape */
    ck_assert_int_eq(mus_tape_source(tape, MUS_MEASURE_SHOULDER), MUS_SOURCE_NONE);
    mus_tape_destroy(tape);
    support_context_end(context);
}
END_TEST


START_TEST(the_shoulder_ends_where_the_file_has_the_shoulder_point)
{
    /* neck of stature 170, bust 92: 36.420 for women, 39.386 for men, mean 37.903; its side 6.0325 from the middle;
     * (18.5 - 6.0325) / cos 20 = 13.2676 */
    mus_context *context = support_context();
    mus_tape *tape;
    mus_status status = read_text(context,
                                  "body:\n  height: 170\n  bust: 92\n  waist: 76\n  hips: 100\n  shoulder_w: 37\n"
                                  "  shoulder_incl: 20\n",
                                  &tape);
    ck_assert_msg(status == MUS_OK, "%s", mus_context_error(context));
    ck_assert_double_eq_tol(mus_tape_value(tape, MUS_MEASURE_SHOULDER), 0.132676, 1e-6);
    ck_assert_int_eq(mus_tape_source(tape, MUS_MEASURE_SHOULDER), MUS_SOURCE_GIVEN);
    ck_assert_int_eq(mus_tape_source(tape, MUS_MEASURE_NECK), MUS_SOURCE_NONE);
    mus_tape_destroy(tape);
    support_context_end(context);
}
END_TEST


START_TEST(the_shoulder_line_is_at_the_level_of_the_file)
{
    /* side of the neck 6.0325 from the middle as above; nape 145 + (8.5 - 6.0325) tan 20 + 2.805 = 148.7031;
     * shoulder point 145 - (18.5 - 8.5) tan 20 = 141.3603, armpit 128.3603, scye depth (148.7031 - 128.3603) / 0.9 */
    mus_context *context = support_context();
    mus_tape *tape;
    mus_status status = read_text(context,
                                  "body:\n  height: 170\n  bust: 92\n  waist: 76\n  hips: 100\n  shoulder_w: 37\n"
                                  "  shoulder_incl: 20\n  head_l: 25\n  neck_w: 17\n  armscye_depth: 13\n",
                                  &tape);
    ck_assert_msg(status == MUS_OK, "%s", mus_context_error(context));
    ck_assert_double_eq_tol(mus_tape_value(tape, MUS_MEASURE_NAPE_HEIGHT), 1.487031, 1e-6);
    ck_assert_double_eq_tol(mus_tape_value(tape, MUS_MEASURE_SCYE_DEPTH), 0.226031, 1e-6);
    ck_assert_int_eq(mus_tape_source(tape, MUS_MEASURE_BACK_WAIST), MUS_SOURCE_NONE);
    mus_tape_destroy(tape);
    support_context_end(context);
}
END_TEST


START_TEST(an_arm_to_the_fingertips_loses_its_hand)
{
    /* 80 of 178 is more than 0.43 of the height: less a hand of 0.108 * 178 = 19.224; 62 is not */
    static const struct {
        const char *text;
        double arm;
    } rows[] = {{"body:\n  height: 178\n  arm_length: 80\n", 0.60776},
                {"body:\n  height: 178\n  arm_length: 62\n", 0.62}};
    mus_context *context = support_context();
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        mus_tape *tape;
        mus_status status = read_text(context, rows[i].text, &tape);
        ck_assert_msg(status == MUS_OK, "%s", mus_context_error(context));
        ck_assert_double_eq_tol(mus_tape_value(tape, MUS_MEASURE_ARM), rows[i].arm, 1e-12);
        mus_tape_destroy(tape);
    }
    ck_assert_ptr_nonnull(strstr(support_log(), "body.yaml: arm_length 80 of a height of 178 is to the fingertips"));
    support_context_end(context);
}
END_TEST


static const char *const bodies[] = {"mean_all", "mean_female", "m_smpl_average_A40"};


START_TEST(real_bodies_complete_and_build)
{
    char relative[128], path[512];
    snprintf(relative, sizeof relative, "garmentcode/bodies/%s.yaml", bodies[_i]);
    if (support_data(relative, path, sizeof path) == NULL) return;
    mus_context *context = support_context();
    mus_tape *tape;
    mus_body *body;
    mus_status status = mus_tape_read(context, path, NULL, &tape);
    ck_assert_msg(status == MUS_OK, "%s", mus_context_error(context));
    ck_assert_str_eq(mus_tape_name(tape), bodies[_i]);
    status = mus_tape_complete(tape);
    ck_assert_msg(status == MUS_OK, "%s", mus_context_error(context));
    status = mus_body_create(context, tape, NULL, &body);
    ck_assert_msg(status == MUS_OK, "%s", mus_context_error(context));
    mus_body_destroy(body);
    mus_tape_destroy(tape);
    support_context_end(context);
}
END_TEST


/* the highest place of a mesh on the plane x, above its lowest */
static double mesh_top(const mus_mesh *mesh, double x)
{
    const double *at = mus_mesh_vertices(mesh);
    const int32_t *corner = mus_mesh_triangles(mesh);
    double floor = HUGE_VAL, top = -HUGE_VAL;
    for (int32_t i = 0; i < mus_mesh_vertex_count(mesh); i++) floor = fmin(floor, at[3 * i + 1]);
    for (int32_t e = 0; e < 3 * mus_mesh_triangle_count(mesh); e++) {
        const double *a = at + 3 * corner[e], *b = at + 3 * corner[e % 3 == 2 ? e - 2 : e + 1];
        if ((a[0] < x) != (b[0] < x)) top = fmax(top, a[1] + (x - a[0]) / (b[0] - a[0]) * (b[1] - a[1]));
    }
    return top - floor;
}


/* of a body, to a tenth of a millimetre */
static double body_top(const mus_body *body, double x)
{
    double top = 0.0;
    for (double z = -0.08; z < 0.08; z += 0.004)
        for (double y = 1.6; y > fmax(top, 1.2); y -= 1e-4) {
            double depth;
            ck_assert_int_eq(mus_body_depth(body, 1, (double[]){x, y, z}, &depth, NULL), MUS_OK);
            if (depth > 0.0) top = y;
            else if (depth > -1e29) y += depth > -0.002 ? 0.0 : 0.5 * depth;
        }
    return top;
}


/* m_smpl's tape is not of its mesh */
START_TEST(shoulders_are_as_high_as_those_of_the_mesh)
{
    char tape_name[128], mesh_name[128], tape_path[512], mesh_path[512];
    snprintf(tape_name, sizeof tape_name, "garmentcode/bodies/%s.yaml", bodies[_i]);
    snprintf(mesh_name, sizeof mesh_name, "garmentcode/bodies/%s.obj", bodies[_i]);
    if (support_data(tape_name, tape_path, sizeof tape_path) == NULL) return;
    if (support_data(mesh_name, mesh_path, sizeof mesh_path) == NULL) return;
    mus_context *context = support_context();
    mus_tape *tape;
    mus_body *body;
    mus_mesh *mesh;
    ck_assert_int_eq(mus_tape_read(context, tape_path, NULL, &tape), MUS_OK);
    ck_assert_int_eq(mus_tape_complete(tape), MUS_OK);
    ck_assert_int_eq(mus_body_create(context, tape, NULL, &body), MUS_OK);
    ck_assert_int_eq(mus_mesh_read_obj(context, mesh_path, &mesh), MUS_OK);
    for (double x = 0.10; x < 0.175; x += 0.02)
        ck_assert_msg(fabs(body_top(body, x) - mesh_top(mesh, x)) < 0.006, "%s, %.2f m off the middle: %.4f, not %.4f",
                      bodies[_i], x, body_top(body, x), mesh_top(mesh, x));
    mus_mesh_destroy(mesh);
    mus_body_destroy(body);
    mus_tape_destroy(tape);
    support_context_end(context);
}
END_TEST


static const struct {
    const char *text;
    mus_status status;
    const char *words;
} refusals[] = {
    {"", MUS_ERR_FORMAT, "expected a map \"body:\""},
    {"person:\n  height: 170\n", MUS_ERR_FORMAT, "body.yaml:2: expected a number, got a map"},
    {"height: 170\n", MUS_ERR_FORMAT, "found none"},
    {"body: 3\n", MUS_ERR_FORMAT, "body.yaml:1: body: expected a map"},
    {"body:\n  height: 1,705\n", MUS_ERR_FORMAT, "body.yaml:2: height: expected a number"},
    {"body:\n  height: .nan\n", MUS_ERR_FORMAT, "body.yaml:2: height: expected a number"},
    {"body:\n  height: tall\n", MUS_ERR_FORMAT, "\"tall\" is not a number"},
    {"body:\n  height: 1e999\n", MUS_ERR_FORMAT, "too large"},
    {"body:\n  height:\n", MUS_ERR_FORMAT, "height"},
    {"body:\n  height: 170\n  height: 171\n", MUS_ERR_FORMAT, "body.yaml:3: height: given a second time"},
    {"body:\n  height: [1, 2]\n", MUS_ERR_FORMAT, "body.yaml:2: expected a map of measures, got a list"},
    {"body:\n  height: &a 170\n  waist: *a\n", MUS_ERR_FORMAT, "alias"},
    {"body:\n  height: {a: 1}\n", MUS_ERR_FORMAT, "got a map"},
    {"- 1\n", MUS_ERR_FORMAT, "got a list"},
    {"body\n", MUS_ERR_FORMAT, "body.yaml:1: expected a map"},
    {"body:\n  height: 170\n waist: 3\n", MUS_ERR_FORMAT, "body.yaml:3: expected yaml"},
    {"body:\n  height: \"170\n", MUS_ERR_FORMAT, "expected yaml"},
    {"body:\n  height: \xff\n", MUS_ERR_FORMAT, "expected yaml"},
    {"body:\n  height: 1e9\n", MUS_ERR_TAPE, "body.yaml: stature"},
    {"body:\n  height: -5\n", MUS_ERR_TAPE, "body.yaml: stature"},
    {"body:\n  height: 170\n  head_l: 169\n", MUS_ERR_TAPE, "body.yaml: nape_height"},
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


Suite *mus_suite_tape_yaml(void);

Suite *mus_suite_tape_yaml(void)
{
    Suite *suite = suite_create("tape_yaml");
    TCase *tests = tcase_create("tape_yaml");
    tcase_add_test(tests, heights_follow_from_the_lengths_of_the_file);
    tcase_add_test(tests, the_shoulder_ends_where_the_file_has_the_shoulder_point);
    tcase_add_test(tests, the_shoulder_line_is_at_the_level_of_the_file);
    tcase_add_test(tests, an_arm_to_the_fingertips_loses_its_hand);
    tcase_add_loop_test(tests, real_bodies_complete_and_build, 0, sizeof bodies / sizeof bodies[0]);
    tcase_add_loop_test(tests, shoulders_are_as_high_as_those_of_the_mesh, 0, 2);
    tcase_add_loop_test(tests, a_fault_is_named_with_its_line, 0, sizeof refusals / sizeof refusals[0]);
    suite_add_tcase(suite, tests);
    return suite;
}
