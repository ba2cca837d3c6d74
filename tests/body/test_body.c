/* test_body.c: making a body, its getters, errors, failing allocations, equal bytes each time. */
#include "body/body_internal.h"
#include "people.h"


START_TEST(defaults_are_safe_and_old_sizes_are_refused)
{
    mus_context *context = support_context();
    mus_tape *tape = people_size(context, "W40");
    mus_body_def def;
    mus_body *body = NULL;
    mus_body_def_init(&def, sizeof def);
    ck_assert_int_eq(def.samples, 128);
    ck_assert(def.ring_spacing == 0.015 && def.ellipse == 0 && def.size == sizeof def);
    ck_assert_int_eq(mus_body_create(context, tape, &def, &body), MUS_OK);
    mus_body_destroy(body);

    const struct {
        int32_t samples;
        double spacing;
    } bad[] = {{15, 0.01}, {18, 0.01}, {516, 0.01}, {0, 0.01}, {96, 0.0}, {96, NAN}, {96, INFINITY}, {96, 0.2}};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        mus_body_def_init(&def, sizeof def);
        def.samples = bad[i].samples, def.ring_spacing = bad[i].spacing;
        ck_assert_int_eq(mus_body_create(context, tape, &def, &body), MUS_ERR_ARG);
        ck_assert_ptr_null(body);
    }
    def.size = 3;
    ck_assert_int_eq(mus_body_create(context, tape, &def, &body), MUS_ERR_VERSION);
    ck_assert_int_eq(mus_body_create(context, NULL, NULL, &body), MUS_ERR_ARG);
    ck_assert_int_eq(mus_body_create(NULL, tape, NULL, &body), MUS_ERR_ARG);
    ck_assert_int_eq(mus_body_create(context, tape, NULL, NULL), MUS_ERR_ARG);
    mus_body_destroy(NULL);
    mus_tape_destroy(tape);
    support_context_end(context);
}
END_TEST


START_TEST(limbs_and_contours_have_names)
{
    static const char *const names[] = {"torso",     "arm_left",  "arm_right", "leg_left",
                                        "leg_right", "foot_left", "foot_right"};
    mus_context *context = support_context();
    mus_body *body = people_body(context, "W40", NULL);
    ck_assert_int_eq(mus_body_limb_count(body), 7);
    for (int32_t l = 0; l < 7; l++) {
        ck_assert_str_eq(mus_body_limb_name(body, l), names[l]);
        ck_assert_int_gt(mus_body_contour_count(body, l), 5);
        for (int32_t i = 0; i < mus_body_contour_count(body, l); i++) {
            double points[3 * 48], before = 0.0;
            ck_assert_ptr_nonnull(mus_body_contour_name(body, l, i));
            ck_assert_int_eq(mus_body_contour_points(body, l, i, 48, points), MUS_OK);

            /* on one plane, ascending along the limb */
            const mus__limb *limb = &body->limb[l];
            for (int k = 0; k < 48; k++) {
                double s = 0.0;
                for (int m = 0; m < 3; m++) s += (points[3 * k + m] - limb->origin[m]) * limb->axis[m];
                ck_assert_double_eq_tol(s, limb->contour[i].s, 1e-12);
            }
            if (i > 0) before = limb->contour[i - 1].s;
            ck_assert(i == 0 || limb->contour[i].s > before);
        }
    }
    ck_assert_ptr_null(mus_body_limb_name(body, 7));
    ck_assert_ptr_null(mus_body_contour_name(body, 0, -1));
    ck_assert_int_eq(mus_body_contour_count(body, -1), 0);
    double points[9];
    int32_t range[4];
    ck_assert_int_eq(mus_body_contour_points(body, 0, 99, 3, points), MUS_ERR_ARG);
    ck_assert_int_eq(mus_body_contour_points(body, 0, 0, 2, points), MUS_ERR_ARG);
    ck_assert_int_eq(mus_body_contour_points(body, 0, 0, 3, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_body_limb_range(body, 7, range), MUS_ERR_ARG);
    ck_assert_int_eq(mus_body_limb_range(body, 0, NULL), MUS_ERR_ARG);
    mus_body_destroy(body);
    support_context_end(context);
}
END_TEST


START_TEST(landmarks_stand_where_the_tape_says)
{
    mus_context *context = support_context();
    mus_body *body = people_body(context, "W40", NULL);
    const struct {
        int32_t landmark, measure;
    } row[] = {{MUS_LANDMARK_CROWN, MUS_MEASURE_STATURE},
               {MUS_LANDMARK_NAPE, MUS_MEASURE_NAPE_HEIGHT},
               {MUS_LANDMARK_BUST, MUS_MEASURE_BUST_HEIGHT},
               {MUS_LANDMARK_WAIST, MUS_MEASURE_WAIST_HEIGHT},
               {MUS_LANDMARK_CROTCH, MUS_MEASURE_INLEG}};
    double p[3], q[3], depth, normal[3];
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        ck_assert_int_eq(mus_body_landmark(body, row[i].landmark, p), MUS_OK);
        ck_assert_double_eq_tol(p[1], mus_body_asked(body, row[i].measure), 1e-9);
        ck_assert_double_eq_tol(p[0], 0.0, 1e-12);
    }

    /* the nape is on the skin at the back */
    ck_assert_int_eq(mus_body_landmark(body, MUS_LANDMARK_NAPE, p), MUS_OK);
    ck_assert_int_eq(mus_body_depth(body, 1, p, &depth, normal), MUS_OK);
    ck_assert_double_eq_tol(depth, 0.0, 5e-4);
    ck_assert_double_lt(normal[2], -0.5);

    /* pairs are mirror images, shoulders inside the body, and left is X > 0 */
    const int32_t left[] = {MUS_LANDMARK_SHOULDER_LEFT, MUS_LANDMARK_WRIST_LEFT, MUS_LANDMARK_ANKLE_LEFT};
    for (int i = 0; i < 3; i++) {
        ck_assert_int_eq(mus_body_landmark(body, left[i], p), MUS_OK);
        ck_assert_int_eq(mus_body_landmark(body, left[i] + 1, q), MUS_OK);
        ck_assert_double_gt(p[0], 0.05);
        ck_assert_double_eq_tol(p[0], -q[0], 1e-12);
        ck_assert_double_eq_tol(p[1], q[1], 1e-12);
        ck_assert_double_eq_tol(p[2], q[2], 1e-12);
        ck_assert_int_eq(mus_body_depth(body, 1, p, &depth, normal), MUS_OK);
        ck_assert_double_gt(depth, 0.0);
    }
    ck_assert_int_eq(mus_body_landmark(body, MUS_LANDMARK_COUNT, p), MUS_ERR_ARG);
    ck_assert_int_eq(mus_body_landmark(body, 0, NULL), MUS_ERR_ARG);
    mus_body_destroy(body);
    support_context_end(context);
}
END_TEST


START_TEST(left_and_right_are_mirror_images)
{
    mus_context *context = support_context();
    mus_body *body = people_body(context, "M54", NULL);
    uint64_t seed = 23;
    for (int i = 0; i < 5000; i++) {
        int32_t v = (int32_t)(support_random(&seed) % (uint64_t)body->vertex_count);
        double p[6], depth[2];
        for (int k = 0; k < 3; k++) p[k] = body->vertices[3 * (ptrdiff_t)v + k] + support_uniform(&seed, -0.01, 0.01);
        p[3] = -p[0], p[4] = p[1], p[5] = p[2];
        ck_assert_int_eq(mus_body_depth(body, 2, p, depth, NULL), MUS_OK);
        ck_assert_double_eq_tol(depth[0], depth[1], 1e-7);
    }
    mus_body_destroy(body);
    support_context_end(context);
}
END_TEST


START_TEST(the_arm_hangs_at_the_tapes_angle)
{
    mus_context *context = support_context();
    const double degrees[] = {30.0, 45.0, 75.0};
    for (int i = 0; i < 3; i++) {
        mus_tape *tape = people_size(context, "W40");
        double angle = degrees[i] * 3.14159265358979323846 / 180.0, p[3], q[3];
        mus_body *body = NULL;
        ck_assert_int_eq(mus_tape_set(tape, MUS_MEASURE_ARM_ANGLE, angle, MUS_SOURCE_GIVEN), MUS_OK);
        ck_assert_int_eq(mus_body_create(context, tape, NULL, &body), MUS_OK);
        ck_assert_int_eq(mus_body_landmark(body, MUS_LANDMARK_SHOULDER_RIGHT, p), MUS_OK);
        ck_assert_int_eq(mus_body_landmark(body, MUS_LANDMARK_WRIST_RIGHT, q), MUS_OK);
        ck_assert_double_eq_tol(atan2(p[1] - q[1], p[0] - q[0]), angle, 1e-9);
        mus_body_destroy(body);
        mus_tape_destroy(tape);
    }
    support_context_end(context);
}
END_TEST


START_TEST(a_contradictory_tape_is_refused_with_both_names)
{
    mus_context *context = support_context();
    mus_tape *tape = people_size(context, "W40");
    mus_body *body = NULL;
    ck_assert_int_eq(mus_tape_set(tape, MUS_MEASURE_UNDERBUST, 0.99, MUS_SOURCE_GIVEN), MUS_OK);
    ck_assert_int_eq(mus_body_create(context, tape, NULL, &body), MUS_ERR_TAPE);
    ck_assert_ptr_null(body);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "underbust"));
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "bust of 92.0 cm"));
    mus_tape_destroy(tape);

    /* the same when the tape lives in another context */
    mus_context *other = support_context();
    tape = people_size(other, "W40");
    ck_assert_int_eq(mus_tape_set(tape, MUS_MEASURE_UNDERBUST, 0.99, MUS_SOURCE_GIVEN), MUS_OK);
    ck_assert_int_eq(mus_body_create(context, tape, NULL, &body), MUS_ERR_TAPE);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "underbust"));
    mus_tape_destroy(tape);
    support_context_end(other);
    support_context_end(context);
}
END_TEST


START_TEST(contours_that_would_cross_are_refused_with_both_names)
{
    static const struct {
        int32_t measure[2];
        double cm[2];
        const char *x, *y;
    } row[] = {
        {{MUS_MEASURE_WAIST_TO_HIP, MUS_MEASURE_RISE}, {26.2, 26.3}, "waist_to_hip", "inleg"},
        {{MUS_MEASURE_BUST_HEIGHT, MUS_MEASURE_UNDERBUST}, {105.0, 79.0}, "bust_height", "waist_height"},
    };
    mus_context *context = support_context();
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        mus_tape *tape = people_size(context, "W40");
        mus_body *body = NULL;
        for (int k = 0; k < 2; k++)
            ck_assert_int_eq(mus_tape_set(tape, row[i].measure[k], 0.01 * row[i].cm[k], MUS_SOURCE_GIVEN), MUS_OK);
        ck_assert_int_eq(mus_tape_complete(tape), MUS_OK);
        ck_assert_int_eq(mus_body_create(context, tape, NULL, &body), MUS_ERR_BODY);
        ck_assert_ptr_null(body);
        ck_assert_msg(strstr(mus_context_error(context), row[i].x) && strstr(mus_context_error(context), row[i].y),
                      "%s", mus_context_error(context));
        mus_tape_destroy(tape);
    }
    support_context_end(context);
}
END_TEST


/* every tape that passes the checks makes a closed body, or is an error with a message */
START_TEST(random_people_build_or_are_refused_by_name)
{
    mus_context *context = support_context();
    mus_body_def def;
    mus_body_def_init(&def, sizeof def);
    def.samples = 32, def.ring_spacing = 0.05;
    uint64_t seed = 29;
    int built = 0;
    for (int round = 0; round < 300; round++) {
        mus_tape *tape = NULL;
        mus_body *body = NULL;
        ck_assert_int_eq(mus_tape_create(context, &tape), MUS_OK);
        ck_assert_int_eq(mus_tape_set_sex(tape, (int32_t)(support_random(&seed) % 4)), MUS_OK);
        double h = support_uniform(&seed, 0.9, 2.1);
        mus_tape_set(tape, MUS_MEASURE_STATURE, h, MUS_SOURCE_GIVEN);
        mus_tape_set(tape, MUS_MEASURE_BUST, h * support_uniform(&seed, 0.42, 0.80), MUS_SOURCE_GIVEN);
        mus_tape_set(tape, MUS_MEASURE_WAIST, h * support_uniform(&seed, 0.34, 0.80), MUS_SOURCE_GIVEN);
        mus_tape_set(tape, MUS_MEASURE_HIP, h * support_uniform(&seed, 0.45, 0.80), MUS_SOURCE_GIVEN);
        mus_status status = mus_body_create(context, tape, &def, &body);
        if (status != MUS_OK) {
            ck_assert(status == MUS_ERR_TAPE || status == MUS_ERR_BODY);
            ck_assert_int_gt((int)strlen(mus_context_error(context)), 10);
        } else {
            built++;
            for (int i = 0; i < PEOPLE_GIRTHS; i++) {
                double made = mus_body_made(body, people_girths[i]);
                ck_assert(isnan(made) || fabs(made - mus_body_asked(body, people_girths[i])) < 2e-3);
            }
            for (int32_t v = 0; v < 3 * body->vertex_count; v++) ck_assert(mus__finite(body->vertices[v]));
        }
        mus_body_destroy(body);
        mus_tape_destroy(tape);
    }
    ck_assert_int_gt(built, 250);
    support_context_end(context);
}
END_TEST


START_TEST(without_memory_nothing_is_left_behind)
{
    mus_body_def def;
    mus_body_def_init(&def, sizeof def);
    def.samples = 16, def.ring_spacing = 0.1;
    for (int64_t n = 0;; n++) {
        mus_context *context = support_context();
        mus_tape *tape = people_size(context, "W40");
        mus_body *body = NULL;
        ck_assert_int_eq(mus_tape_set(tape, MUS_MEASURE_CROTCH_LENGTH, 0.68, MUS_SOURCE_GIVEN), MUS_OK);
        support_fail_after(n, false);
        mus_status status = mus_body_create(context, tape, &def, &body);
        support_fail_never();
        ck_assert((status == MUS_OK) == (body != NULL));
        mus_body_destroy(body);
        mus_tape_destroy(tape);
        support_context_end(context);
        if (status == MUS_OK) {
            ck_assert_int_gt(n, 30);
            break;
        }
        ck_assert_int_eq(status, MUS_ERR_MEMORY);
        ck_assert_int_lt(n, 400);
    }
}
END_TEST


START_TEST(the_same_tape_makes_the_same_bytes)
{
    mus_context *context = support_context();
    uint64_t hash[2];
    for (int i = 0; i < 2; i++) {
        mus_body *body = people_body(context, "C128", NULL);
        size_t bytes = 3 * (size_t)body->vertex_count * sizeof(double);
        hash[i] = mus__hash(MUS_HASH_START, body->vertices, bytes);
        hash[i] = mus__hash(hash[i], body->normals, bytes);
        for (int32_t l = 0; l < body->nfield; l++)
            hash[i] = mus__hash(hash[i], body->field[l].radius,
                                (size_t)body->field[l].nring * (size_t)body->field[l].nangle * sizeof(double));
        mus_body_destroy(body);
    }
    ck_assert_uint_eq(hash[0], hash[1]);
    support_context_end(context);
}
END_TEST


START_TEST(creating_does_not_touch_the_tape)
{
    mus_context *context = support_context();
    mus_tape *tape = people_size(context, "W40");
    mus_body *body = NULL;
    ck_assert_int_eq(mus_body_create(context, tape, NULL, &body), MUS_OK);
    ck_assert_int_eq(mus_tape_is_complete(tape), 0);
    ck_assert(isnan(mus_tape_value(tape, MUS_MEASURE_CALF)));
    mus_tape_destroy(tape); /* the body does not keep it */
    ck_assert(mus_body_asked(body, MUS_MEASURE_CALF) > 0.3);
    mus_body_destroy(body);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_body(void);
Suite *mus_suite_body(void)
{
    Suite *suite = suite_create("body");
    TCase *tests = tcase_create("body");
    tcase_set_timeout(tests, 60);
    tcase_add_test(tests, defaults_are_safe_and_old_sizes_are_refused);
    tcase_add_test(tests, limbs_and_contours_have_names);
    tcase_add_test(tests, landmarks_stand_where_the_tape_says);
    tcase_add_test(tests, left_and_right_are_mirror_images);
    tcase_add_test(tests, the_arm_hangs_at_the_tapes_angle);
    tcase_add_test(tests, a_contradictory_tape_is_refused_with_both_names);
    tcase_add_test(tests, contours_that_would_cross_are_refused_with_both_names);
    tcase_add_test(tests, random_people_build_or_are_refused_by_name);
    tcase_add_test(tests, without_memory_nothing_is_left_behind);
    tcase_add_test(tests, the_same_tape_makes_the_same_bytes);
    tcase_add_test(tests, creating_does_not_touch_the_tape);
    suite_add_tcase(suite, tests);
    return suite;
}
