/* test_body_outline.c: contours given by corners: exact at the corners, the superellipse in the limit, refusals. */
#include <math.h>
#include <string.h>

#include "body/body_internal.h"
#include "geom/vec.h"
#include "support.h"

Suite *mus_suite_body_outline(void);

#define OUTLINE_MOST 512


/* an upright limb of two equal contours of n corners, `of` (2n), about (ca, cb) */
static mus_limb outline_limb(int32_t n, const double *of, double ca, double cb, double *rows, double *outline)
{
    mus_limb limb;
    mus_limb_init(&limb, sizeof limb);
    for (int i = 0; i < 2; i++) {
        const double row[6] = {0.5 * i, ca, cb, 0.0, 0.0, 0.0};
        memcpy(rows + 6 * i, row, sizeof row);
        memcpy(outline + 2 * (ptrdiff_t)n * i, of, 2 * (size_t)n * sizeof *of);
    }
    limb.pole[0] = -0.05, limb.pole[1] = 0.55;
    limb.contours = 2, limb.contour = rows;
    limb.corners = n, limb.outline = outline;
    return limb;
}


/* an ellipse as n corners is the ellipse to its chords: depths and volume fall short by O(1/n^2) */
START_TEST(corners_of_an_ellipse_are_the_ellipse_in_the_limit)
{
    double before = 0.0;
    for (int32_t n = 32; n <= OUTLINE_MOST; n *= 2) {
        mus_context *context = support_context();
        double rows[12], outline[4 * OUTLINE_MOST], of[2 * OUTLINE_MOST], volume[2];
        for (int32_t k = 0; k < n; k++) {
            of[2 * k] = 0.02 + 0.15 * cos(2.0 * MUS_PI * (k + 0.3) / n);
            of[2 * k + 1] = -0.01 + 0.10 * sin(2.0 * MUS_PI * (k + 0.3) / n);
        }
        mus_limb limb = outline_limb(n, of, 0.02, -0.01, rows, outline);
        mus_body_def def;
        mus_body_def_init(&def, sizeof def);
        def.samples = 512;
        for (int round = 0; round < 2; round++) {
            mus_body *body;
            for (int i = 0; i < 2; i++) rows[6 * i + 3] = 0.15, rows[6 * i + 4] = 0.10, rows[6 * i + 5] = 2.0;
            limb.corners = round == 0 ? n : 0;
            ck_assert_int_eq(mus_body_create_limbs(context, 1, &limb, &def, &body), MUS_OK);
            volume[round] = mus_body_volume(body);
            mus_body_destroy(body);
        }
        const double off = 1.0 - volume[0] / volume[1];
        ck_assert_double_gt(off, -1e-6);
        if (n > 32 && n <= 128) ck_assert_double_eq_tol(off / before, 0.25, 0.02);
        before = off;
        support_context_end(context);
    }
    ck_assert_double_lt(before, 6e-5);
}
END_TEST


/* random star-shaped polygons: the ray to each corner, and to each middle of a side, ends there */
START_TEST(the_radius_ends_on_the_sides)
{
    uint64_t seed = 5;
    for (int round = 0; round < 200; round++) {
        mus_context *context = support_context();
        const int32_t n = 3 + (int32_t)support_uniform(&seed, 0.0, 60.0);
        double rows[12], outline[4 * OUTLINE_MOST], of[2 * OUTLINE_MOST];
        const double ca = support_uniform(&seed, -1.0, 1.0), cb = support_uniform(&seed, -1.0, 1.0);
        const double start = support_uniform(&seed, 0.0, 2.0 * MUS_PI);
        for (int32_t k = 0; k < n; k++) {
            const double t = start + 2.0 * MUS_PI * (k + support_uniform(&seed, 0.0, n > 3 ? 0.9 : 0.4)) / n;
            const double r = support_uniform(&seed, 0.02, 0.3);
            of[2 * k] = ca + r * cos(t), of[2 * k + 1] = cb + r * sin(t);
        }
        const mus_limb limb = outline_limb(n, of, ca, cb, rows, outline);
        mus_body *body;
        if (mus_body_create_limbs(context, 1, &limb, NULL, &body) != MUS_OK) {
            /* of few corners two may stand half a turn apart */
            ck_assert_int_lt(n, 5);
            support_context_end(context);
            continue;
        }
        for (int32_t k = 0; k < n; k++)
            for (int half = 0; half < 2; half++) {
                const double *p = of + 2 * k, *q = of + 2 * ((k + half) % n);
                const double a = 0.5 * (p[0] + q[0]) - ca, b = 0.5 * (p[1] + q[1]) - cb, r = hypot(a, b);
                ck_assert_double_eq_tol(mus__contour_radius(&body->limb[0].contour[1], a / r, b / r), r, 1e-9);
            }
        mus_body_destroy(body);
        support_context_end(context);
    }
}
END_TEST


START_TEST(an_outline_that_is_not_star_shaped_is_refused_with_its_angle)
{
    mus_context *context = support_context();
    double rows[12], outline[16];
    /* a square with a corner that lies behind its neighbour at 135 degrees */
    static const double hook[8] = {0.1, -0.1, 0.1, 0.1, -0.1, 0.1, 0.05, 0.15};
    mus_limb limb = outline_limb(4, hook, 0.0, 0.0, rows, outline);
    limb.name = "leg_left";
    mus_body *body = (mus_body *)rows;
    ck_assert_int_eq(mus_body_create_limbs(context, 1, &limb, NULL, &body), MUS_ERR_BODY);
    ck_assert_ptr_null(body);
    const char *text = mus_context_error(context);
    ck_assert_msg(strstr(text, "limb 0 (leg_left)") && strstr(text, "contour 0") && strstr(text, "135.0 degrees"), "%s",
                  text);

    /* clockwise, twice round, the centre outside, too few corners, none given, a corner on the centre */
    static const double back[8] = {0.1, -0.1, -0.1, -0.1, -0.1, 0.1, 0.1, 0.1};
    static const double twice[12] = {0.1, 0.0, -0.05, 0.09, -0.05, -0.09, 0.11, 0.0, -0.06, 0.1, -0.06, -0.1};
    static const double square[8] = {0.1, -0.1, 0.1, 0.1, -0.1, 0.1, -0.1, -0.1};
    double more[24];
    limb = outline_limb(4, back, 0.0, 0.0, rows, more);
    ck_assert_int_eq(mus_body_create_limbs(context, 1, &limb, NULL, &body), MUS_ERR_BODY);
    limb = outline_limb(6, twice, 0.0, 0.0, rows, more);
    ck_assert_int_eq(mus_body_create_limbs(context, 1, &limb, NULL, &body), MUS_ERR_BODY);
    limb = outline_limb(4, square, 0.15, 0.0, rows, more);
    ck_assert_int_eq(mus_body_create_limbs(context, 1, &limb, NULL, &body), MUS_ERR_BODY);
    limb = outline_limb(4, square, 0.0, 0.0, rows, more);
    ck_assert_int_eq(mus_body_create_limbs(context, 1, &limb, NULL, &body), MUS_OK);
    mus_body_destroy(body);
    limb.corners = 2;
    ck_assert_int_eq(mus_body_create_limbs(context, 1, &limb, NULL, &body), MUS_ERR_ARG);
    limb.corners = -4;
    ck_assert_int_eq(mus_body_create_limbs(context, 1, &limb, NULL, &body), MUS_ERR_ARG);
    limb.corners = 4, limb.outline = NULL;
    ck_assert_int_eq(mus_body_create_limbs(context, 1, &limb, NULL, &body), MUS_ERR_ARG);
    limb = outline_limb(4, square, 0.1, 0.1, rows, more);
    ck_assert_int_eq(mus_body_create_limbs(context, 1, &limb, NULL, &body), MUS_ERR_ARG);
    support_context_end(context);
}
END_TEST


START_TEST(each_failing_allocation_of_outlines_is_a_status)
{
    double rows[12], outline[16];
    static const double square[8] = {0.1, -0.1, 0.1, 0.1, -0.1, 0.1, -0.1, -0.1};
    const mus_limb limb = outline_limb(4, square, 0.0, 0.0, rows, outline);
    for (int64_t n = 0;; n++) {
        mus_context *context = support_context();
        mus_body *body;
        support_fail_after(n, false);
        const mus_status status = mus_body_create_limbs(context, 1, &limb, NULL, &body);
        support_fail_never();
        mus_body_destroy(body);
        support_context_end(context);
        if (status == MUS_OK) break;
        ck_assert_int_eq(status, MUS_ERR_MEMORY);
    }
}
END_TEST


Suite *mus_suite_body_outline(void)
{
    Suite *suite = suite_create("body_outline");
    TCase *tests = tcase_create("body_outline");
    tcase_add_test(tests, corners_of_an_ellipse_are_the_ellipse_in_the_limit);
    tcase_add_test(tests, the_radius_ends_on_the_sides);
    tcase_add_test(tests, an_outline_that_is_not_star_shaped_is_refused_with_its_angle);
    tcase_add_test(tests, each_failing_allocation_of_outlines_is_a_status);
    suite_add_tcase(suite, tests);
    return suite;
}
