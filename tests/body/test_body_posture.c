/*
 * test_body_posture.c: a posture moves contours and nothing else: girths and heights stay the tape's, nape, head and
 * waist go as far as they are told, the arms go with the shoulders; no posture is the same body to the last bit, too
 * much of one is refused with its limits.
 */
#include <string.h>

#include "muslin/pose.h"
#include "people.h"

#define POSTURES (SUPPORT_SLOW ? 3 : 12)


static mus_body_def posture(double stature, double stoop, double head, double sway)
{
    mus_body_def def;
    mus_body_def_init(&def, sizeof def);
    def.plain = 1;
    def.stoop = stoop * stature, def.head_forward = head * stature, def.sway = sway * stature;
    return def;
}


static double landmark_z(const mus_body *body, int32_t landmark)
{
    double x[3];
    ck_assert_int_eq(mus_body_landmark(body, landmark, x), MUS_OK);
    return x[2];
}


/* random postures on random bodies: the finished surface has the girths and heights of the tape */
START_TEST(girths_and_heights_stay)
{
    static const char *const sizes[] = {"W34", "W40", "W52", "M50", "M60", "C56", "C116"};
    mus_context *context = support_context();
    uint64_t seed = 5;
    for (int i = 0; i < POSTURES; i++) {
        const char *size = sizes[i % 7];
        const mus_body_def upright = posture(1.0, 0.0, 0.0, 0.0);
        mus_body *straight = people_body(context, size, &upright);
        const double h = mus_body_made(straight, MUS_MEASURE_STATURE);
        const mus_body_def def = posture(h, support_uniform(&seed, -0.02, 0.04), support_uniform(&seed, -0.01, 0.03),
                                         support_uniform(&seed, -0.015, 0.03));
        mus_body *body = people_body(context, size, &def);
        for (int k = 0; k < PEOPLE_GIRTHS; k++) {
            const int32_t m = people_girths[k];
            ck_assert_double_eq_tol(mus_body_made(body, m), mus_body_made(straight, m), 1e-3);
        }
        static const int32_t heights[] = {MUS_MEASURE_STATURE,     MUS_MEASURE_WAIST_HEIGHT, MUS_MEASURE_INLEG,
                                          MUS_MEASURE_NAPE_HEIGHT, MUS_MEASURE_BUST_HEIGHT,  MUS_MEASURE_WAIST_TO_HIP};
        for (size_t k = 0; k < sizeof heights / sizeof *heights; k++)
            ck_assert_double_eq_tol(mus_body_made(body, heights[k]), mus_body_made(straight, heights[k]), 1e-12);

        /* the shifts of nape, head and waist */
        const double stoop = def.stoop, head = def.head_forward, sway = def.sway;
        ck_assert_double_eq_tol(landmark_z(body, MUS_LANDMARK_CROWN) - landmark_z(straight, MUS_LANDMARK_CROWN),
                                stoop + head, 1e-9);
        ck_assert_double_eq_tol(landmark_z(body, MUS_LANDMARK_WAIST) - landmark_z(straight, MUS_LANDMARK_WAIST), sway,
                                1e-9);
        ck_assert_double_eq_tol(landmark_z(body, MUS_LANDMARK_HIP) - landmark_z(straight, MUS_LANDMARK_HIP),
                                -0.3 * sway, 1e-9);
        const double nape = landmark_z(body, MUS_LANDMARK_NAPE) - landmark_z(straight, MUS_LANDMARK_NAPE);
        ck_assert(nape - stoop >= fmin(head, 0.0) - 1e-9 && nape - stoop <= fmax(head, 0.0) + 1e-9);
        ck_assert_double_eq_tol(
            landmark_z(body, MUS_LANDMARK_WRIST_LEFT) - landmark_z(straight, MUS_LANDMARK_WRIST_LEFT),
            landmark_z(body, MUS_LANDMARK_SHOULDER_LEFT) - landmark_z(straight, MUS_LANDMARK_SHOULDER_LEFT), 1e-9);
        ck_assert_double_eq_tol(mus_body_volume(body) / mus_body_volume(straight), 1.0, 0.01);
        mus_body_destroy(body);
        mus_body_destroy(straight);
    }
    support_context_end(context);
}
END_TEST


/* vertices of the limbs lie on the surface of the radius fields in every posture */
START_TEST(contact_goes_with_the_contours)
{
    mus_context *context = support_context();
    const mus_body_def def = posture(1.68, 0.04, 0.03, 0.03);
    mus_body *body = people_body(context, "W40", &def);
    int32_t range[4];
    ck_assert_int_eq(mus_body_limb_range(body, 0, range), MUS_OK);
    for (int32_t v = 0; v < range[1]; v += 7) {
        const double *x = mus_body_vertices(body) + 3 * (ptrdiff_t)(range[0] + v);
        double depth, normal[3];
        ck_assert_int_eq(mus_body_depth(body, 1, x, &depth, normal), MUS_OK);
        ck_assert_msg(depth > -0.001, "%g of (%g, %g, %g)", depth, x[0], x[1], x[2]);
    }
    mus_body_destroy(body);
    support_context_end(context);
}
END_TEST


START_TEST(no_posture_is_the_same_body)
{
    mus_context *context = support_context();
    const mus_body_def def = posture(1.0, -0.0, 0.0, -0.0), none = posture(0.0, 1.0, 1.0, 1.0);
    mus_body *body = people_body(context, "M50", &def), *other = people_body(context, "M50", &none);
    const size_t bytes = 3 * (size_t)mus_body_vertex_count(body) * sizeof(double);
    ck_assert_int_eq(mus_body_vertex_count(body), mus_body_vertex_count(other));
    ck_assert_mem_eq(mus_body_vertices(body), mus_body_vertices(other), bytes);
    mus_body_destroy(body);
    mus_body_destroy(other);
    support_context_end(context);
}
END_TEST


START_TEST(too_much_is_refused_with_its_limits)
{
    static const struct {
        double stoop, head, sway;
        const char *word;
    } row[] = {{0.041, 0, 0, "stoop"},         {-0.021, 0, 0, "stoop"},  {0, 0.031, 0, "head_forward"},
               {0, -0.011, 0, "head_forward"}, {0, 0, 0.031, "sway"},    {0, 0, -0.016, "sway"}};
    mus_context *context = support_context();
    mus_tape *tape = people_size(context, "C116");
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        const mus_body_def def = posture(1.16, row[i].stoop, row[i].head, row[i].sway);
        mus_body *body = (mus_body *)tape;
        ck_assert_int_eq(mus_body_create(context, tape, &def, &body), MUS_ERR_ARG);
        ck_assert_ptr_null(body);
        ck_assert_msg(strstr(mus_context_error(context), row[i].word) != NULL &&
                          strstr(mus_context_error(context), "1.160 m") != NULL,
                      "%s", mus_context_error(context));
    }

    /* given limbs have no back */
    const double rows[12] = {0.0, 0.0, 0.0, 0.1, 0.1, 2.0, 0.5, 0.0, 0.0, 0.1, 0.1, 2.0};
    mus_limb limb;
    mus_limb_init(&limb, sizeof limb);
    limb.pole[0] = -0.1, limb.pole[1] = 0.6;
    limb.contours = 2;
    limb.contour = rows;
    const mus_body_def def = posture(1.0, 0.01, 0.0, 0.0);
    mus_body *body;
    ck_assert_int_eq(mus_body_create_limbs(context, 1, &limb, &def, &body), MUS_ERR_ARG);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "posture"));
    mus_tape_destroy(tape);
    support_context_end(context);
}
END_TEST


/* a stooping body in a pose: parts meet at their joints as those of an upright one do */
START_TEST(it_can_be_posed)
{
    mus_context *context = support_context();
    const mus_body_def def = posture(1.77, 0.035, 0.02, 0.02);
    mus_body *body = people_body(context, "M50", &def), *posed = NULL;
    mus_pose pose;
    ck_assert_int_eq(mus_pose_named(context, "bend", &pose), MUS_OK);
    ck_assert_int_eq(mus_body_pose(body, &pose, &posed), MUS_OK);
    ck_assert_double_eq_tol(mus_body_made(posed, MUS_MEASURE_WAIST), 0.88, 1e-9);
    mus_body_destroy(posed);
    ck_assert_int_eq(mus_body_rest_pose(body, &pose), MUS_OK);
    ck_assert_int_eq(mus_body_pose(body, &pose, &posed), MUS_OK);
    const double *p = mus_body_vertices(body), *q = mus_body_vertices(posed);
    for (int32_t i = 0; i < 3 * mus_body_vertex_count(body); i++) ck_assert_double_eq_tol(p[i], q[i], 1e-12);
    mus_body_destroy(posed);
    mus_body_destroy(body);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_body_posture(void);
Suite *mus_suite_body_posture(void)
{
    Suite *suite = suite_create("body_posture");
    TCase *tests = tcase_create("body_posture");
    tcase_set_timeout(tests, 60);
    tcase_add_test(tests, girths_and_heights_stay);
    tcase_add_test(tests, contact_goes_with_the_contours);
    tcase_add_test(tests, no_posture_is_the_same_body);
    tcase_add_test(tests, too_much_is_refused_with_its_limits);
    tcase_add_test(tests, it_can_be_posed);
    suite_add_tcase(suite, tests);
    return suite;
}
