/* test_body_from_limbs.c: bodies of given limbs: known solids, missing measures, errors, failing allocations. */
#include <math.h>
#include <string.h>

#include "geom/vec.h"
#include "muslin/body.h"
#include "support.h"

Suite *mus_suite_body_from_limbs(void);


/* a limb of circles of radius r (n) at s (n) */
static mus_limb given_limb_of(int32_t n, const double *s, const double *r, double *rows)
{
    mus_limb limb;
    mus_limb_init(&limb, sizeof limb);
    for (int32_t i = 0; i < n; i++) {
        const double row[6] = {s[i], 0.0, 0.0, r[i], r[i], 2.0};
        memcpy(rows + 6 * i, row, sizeof row);
    }
    limb.contours = n;
    limb.contour = rows;
    limb.pole[0] = s[0] - 0.01, limb.pole[1] = s[n - 1] + 0.01;
    return limb;
}


START_TEST(a_cylinder_on_a_slanting_axis_has_its_depth)
{
    mus_context *context = support_context();
    const double s[] = {-0.3, 0.3}, r[] = {0.1, 0.1};
    double rows[12];
    mus_limb limb = given_limb_of(2, s, r, rows);
    const double origin[3] = {0.5, 1.0, -0.2}, axis[3] = {1.2, 0.0, 1.6}, side[3] = {0.0, 2.0, 1.0};
    memcpy(limb.origin, origin, sizeof origin);
    memcpy(limb.axis, axis, sizeof axis);
    memcpy(limb.side, side, sizeof side);
    mus_body *body;
    ck_assert_int_eq(mus_body_create_limbs(context, 1, &limb, NULL, &body), MUS_OK);

    uint64_t seed = 1;
    for (int i = 0; i < 3000; i++) {
        double p[3], off = support_uniform(&seed, -0.03, 0.03), turn = support_uniform(&seed, 0.0, 2.0 * MUS_PI);
        double along = support_uniform(&seed, -0.29, 0.29), depth, normal[3];
        /* the axis is (0.6, 0, 0.8); across it (0, 1, 0) and (0.8, 0, -0.6) */
        const double out[3] = {0.8 * sin(turn), cos(turn), -0.6 * sin(turn)};
        for (int k = 0; k < 3; k++)
            p[k] = origin[k] + along * (k == 0 ? 0.6 : k == 2 ? 0.8 : 0.0) + (0.1 + off) * out[k];
        ck_assert_int_eq(mus_body_depth(body, 1, p, &depth, normal), MUS_OK);
        ck_assert_double_eq_tol(depth, -off, 1e-8);
        ck_assert_double_eq_tol(mus__dot3(normal, out), 1.0, 1e-12);
    }
    mus_body_destroy(body);
    support_context_end(context);
}
END_TEST


START_TEST(two_limbs_have_names_ranges_and_volume)
{
    mus_context *context = support_context();
    const double s[] = {0.0, 0.5}, r[] = {0.1, 0.2};
    double rows[2][12];
    mus_limb limb[2] = {given_limb_of(2, s, r, rows[0]), given_limb_of(2, s, r, rows[1])};
    limb[0].name = "cone";
    limb[1].name = "a name of more than thirty-one bytes";
    limb[1].origin[0] = 1.0;
    mus_body_def def;
    mus_body *body;
    mus_body_def_init(&def, sizeof def);
    def.samples = 256;
    ck_assert_int_eq(mus_body_create_limbs(context, 2, limb, &def, &body), MUS_OK);
    ck_assert_int_eq(mus_body_limb_count(body), 2);
    ck_assert_str_eq(mus_body_limb_name(body, 0), "cone");
    ck_assert_str_eq(mus_body_limb_name(body, 1), "a name of more than thirty-one ");
    ck_assert_int_eq(mus_body_contour_count(body, 1), 2);
    ck_assert_int_eq(mus_body_contour_count(body, 2), 0);

    /* a frustum pi h (r0^2 + r0 r1 + r1^2) / 3 each, and caps of 1 cm: a third more than a cone, less than a slab */
    const double frustum = MUS_PI * 0.5 * (0.01 + 0.02 + 0.04) / 3.0, volume = mus_body_volume(body);
    ck_assert_double_gt(volume, 2.0 * (frustum + 0.3 * MUS_PI * 0.01 * (0.01 + 0.04)));
    ck_assert_double_lt(volume, 2.0 * (frustum + MUS_PI * 0.01 * (0.01 + 0.04)));

    int32_t range[4];
    ck_assert_int_eq(mus_body_limb_range(body, 1, range), MUS_OK);
    ck_assert_int_eq(range[0] + range[1], mus_body_vertex_count(body));
    ck_assert_int_eq(range[2] + range[3], mus_body_triangle_count(body));
    mus_body_destroy(body);
    support_context_end(context);
}
END_TEST


START_TEST(it_has_no_measures_and_no_landmarks)
{
    mus_context *context = support_context();
    const double s[] = {0.0, 0.5}, r[] = {0.1, 0.2};
    double rows[12], place[3];
    mus_limb limb = given_limb_of(2, s, r, rows);
    mus_body *body;
    ck_assert_int_eq(mus_body_create_limbs(context, 1, &limb, NULL, &body), MUS_OK);
    for (int32_t m = 0; m < MUS_MEASURE_COUNT; m++) {
        ck_assert(isnan(mus_body_asked(body, m)) && isnan(mus_body_made(body, m)));
        ck_assert_int_eq(mus_body_source(body, m), MUS_SOURCE_NONE);
    }
    for (int32_t k = 0; k < MUS_LANDMARK_COUNT; k++)
        ck_assert_int_eq(mus_body_landmark(body, k, place), MUS_ERR_ARG);
    mus_body_destroy(body);
    support_context_end(context);
}
END_TEST


START_TEST(each_refusal_names_limb_and_value)
{
    mus_context *context = support_context();
    const double s[] = {0.0, 0.1, 0.2}, r[] = {0.1, 0.2, 0.1};
    for (int c = 0; c < 16; c++) {
        double rows[18];
        mus_limb limb = given_limb_of(3, s, r, rows);
        mus_status expect = MUS_ERR_ARG;
        switch (c) {
        case 0: rows[6] = 0.0, expect = MUS_ERR_BODY; break; /* two at one height */
        case 1: rows[6] = 0.3, expect = MUS_ERR_BODY; break;
        case 2: limb.pole[0] = 0.0, expect = MUS_ERR_BODY; break;
        case 3: limb.pole[1] = NAN; break;
        case 4: rows[9] = 0.0; break; /* shrunk to a line */
        case 5: rows[10] = -0.1; break; /* turned inside out */
        case 6: rows[3] = NAN; break;
        case 7: rows[5] = 0.5; break;
        case 8: rows[7] = INFINITY; break;
        case 9: limb.contours = 1; break;
        case 10: limb.contours = 129; break;
        case 11: limb.contour = NULL; break;
        case 12: limb.axis[1] = 0.0; break;
        case 13: limb.side[0] = 0.0, limb.side[1] = 1.0; break; /* along the axis */
        case 14: limb.origin[2] = NAN; break;
        default: limb.size = 8, expect = MUS_ERR_VERSION; break;
        }
        mus_body *body = (mus_body *)rows;
        ck_assert_msg(mus_body_create_limbs(context, 1, &limb, NULL, &body) == expect, "case %d", c);
        ck_assert_ptr_null(body);
        ck_assert_ptr_nonnull(strstr(mus_context_error(context), "limb 0"));
    }
    double rows[12];
    mus_limb limb = given_limb_of(2, s, r, rows);
    mus_body *body;
    mus_body_def def;
    mus_body_def_init(&def, sizeof def);
    def.samples = 15;
    ck_assert_int_eq(mus_body_create_limbs(context, 1, &limb, &def, &body), MUS_ERR_ARG);
    ck_assert_int_eq(mus_body_create_limbs(context, 0, &limb, NULL, &body), MUS_ERR_ARG);
    ck_assert_int_eq(mus_body_create_limbs(context, 65, &limb, NULL, &body), MUS_ERR_ARG);
    ck_assert_int_eq(mus_body_create_limbs(context, 1, NULL, NULL, &body), MUS_ERR_ARG);
    ck_assert_int_eq(mus_body_create_limbs(context, 1, &limb, NULL, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_body_create_limbs(NULL, 1, &limb, NULL, &body), MUS_ERR_ARG);
    support_context_end(context);
}
END_TEST


START_TEST(each_failing_allocation_of_limbs_is_a_status)
{
    const double s[] = {0.0, 0.5}, r[] = {0.1, 0.2};
    double rows[2][12];
    const mus_limb limb[2] = {given_limb_of(2, s, r, rows[0]), given_limb_of(2, s, r, rows[1])};
    for (int64_t n = 0;; n++) {
        mus_context *context = support_context();
        mus_body *body;
        support_fail_after(n, false);
        const mus_status status = mus_body_create_limbs(context, 2, limb, NULL, &body);
        support_fail_never();
        mus_body_destroy(body);
        support_context_end(context);
        if (status == MUS_OK) break;
        ck_assert_int_eq(status, MUS_ERR_MEMORY);
    }
}
END_TEST


Suite *mus_suite_body_from_limbs(void)
{
    Suite *suite = suite_create("body_from_limbs");
    TCase *tests = tcase_create("body_given");
    tcase_add_test(tests, a_cylinder_on_a_slanting_axis_has_its_depth);
    tcase_add_test(tests, two_limbs_have_names_ranges_and_volume);
    tcase_add_test(tests, it_has_no_measures_and_no_landmarks);
    tcase_add_test(tests, each_refusal_names_limb_and_value);
    tcase_add_test(tests, each_failing_allocation_of_limbs_is_a_status);
    suite_add_tcase(suite, tests);
    return suite;
}
