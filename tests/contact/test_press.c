/*
 * test_press.c: how deep a node is where two parts of a body press on each other: flesh gives way, each part by up to
 * 15 mm, and the depth is that below the surface midway.
 */
#include <math.h>

#include "muslin/muslin.h"
#include "support.h"

Suite *mus_suite_press(void);

#define PRESS_MOST 0.015 /* [m] as in mus_drape(3) */


/* two rollers of radius 0.1 along z, their axes 0.2 - overlap apart in x, about x = 0 */
static mus_body *press_rollers(mus_context *context, double overlap)
{
    const double rows[12] = {-0.5, 0.0, 0.0, 0.1, 0.1, 2.0, 0.5, 0.0, 0.0, 0.1, 0.1, 2.0};
    mus_limb limb[2];
    for (int i = 0; i < 2; i++) {
        mus_limb_init(&limb[i], sizeof limb[i]);
        limb[i].origin[0] = (i ? 0.5 : -0.5) * (0.2 - overlap);
        limb[i].axis[1] = 0.0, limb[i].axis[2] = 1.0;
        limb[i].pole[0] = -0.6, limb[i].pole[1] = 0.6;
        limb[i].contours = 2, limb[i].contour = rows;
    }
    mus_body *body;
    ck_assert_int_eq(mus_body_create_limbs(context, 2, limb, NULL, &body), MUS_OK);
    return body;
}


/* the report of one node at x between the rollers */
static mus_drape_report press_at(mus_context *context, const mus_body *body, double x, double y)
{
    const double place[3] = {x, y, 0.0}, speed[3] = {0}, mass = 1.0;
    mus_cloth *cloth;
    mus_drape *drape;
    mus_bare bare;
    mus_bare_init(&bare, sizeof bare);
    bare.nodes = 1, bare.place = place, bare.mass = &mass;
    mus_drape_def def;
    mus_drape_def_init(&def, sizeof def);
    def.precision = 64;
    ck_assert_int_eq(mus_cloth_create_bare(context, &bare, &cloth), MUS_OK);
    ck_assert_int_eq(mus_drape_create(context, cloth, body, &def, &drape), MUS_OK);
    ck_assert_int_eq(mus_drape_set_state(drape, place, speed), MUS_OK);
    mus_drape_report report;
    mus_drape_report_init(&report, sizeof report);
    ck_assert_int_eq(mus_drape_report_get(drape, &report), MUS_OK);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    return report;
}


START_TEST(between_parts_that_press_depth_is_below_the_surface_midway)
{
    mus_context *context = support_context();
    const double overlap = 0.012;
    mus_body *body = press_rollers(context, overlap);
    for (int k = -4; k <= 4; k++) {
        const double x = 1e-3 * k;
        const mus_drape_report report = press_at(context, body, x, 0.0);
        ck_assert_double_eq_tol(report.max_penetration, fabs(x), 5e-5);
        ck_assert_double_eq_tol(report.max_press, 0.5 * overlap, 5e-5);
    }
    mus_body_destroy(body);
    support_context_end(context);
}
END_TEST


START_TEST(flesh_gives_way_by_a_limit)
{
    mus_context *context = support_context();
    mus_body *body = press_rollers(context, 0.05);
    const mus_drape_report report = press_at(context, body, 0.0, 0.0);
    ck_assert_double_eq_tol(report.max_press, PRESS_MOST, 1e-12);
    ck_assert_double_eq_tol(report.max_penetration, 0.025 - PRESS_MOST, 1e-4);
    mus_body_destroy(body);
    support_context_end(context);
}
END_TEST


/* a node in one part alone, and one where the faces stand across each other, is as deep as it is */
START_TEST(one_part_alone_does_not_give_way)
{
    mus_context *context = support_context();
    mus_body *body = press_rollers(context, 0.012);
    mus_drape_report report = press_at(context, body, 0.5 * 0.188 + 0.095, 0.0);
    ck_assert_double_eq_tol(report.max_penetration, 0.005, 5e-5);
    ck_assert_double_eq(report.max_press, 0.0);
    mus_body_destroy(body);

    body = press_rollers(context, 0.07);
    report = press_at(context, body, 0.0, 0.07);
    ck_assert_double_gt(report.max_penetration, 0.001);
    ck_assert_double_eq(report.max_press, 0.0);
    mus_body_destroy(body);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_press(void)
{
    Suite *suite = suite_create("press");
    TCase *tests = tcase_create("press");
    tcase_add_test(tests, between_parts_that_press_depth_is_below_the_surface_midway);
    tcase_add_test(tests, flesh_gives_way_by_a_limit);
    tcase_add_test(tests, one_part_alone_does_not_give_way);
    suite_add_tcase(suite, tests);
    return suite;
}
