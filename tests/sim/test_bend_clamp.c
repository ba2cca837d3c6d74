/*
 * test_bend_clamp.c: a strip that hangs from two fixed nodes side by side has the tip of the elastica, to second order;
 * freed, it has no clamp left.
 */
#include <math.h>

#include <check.h>

#include "muslin/dress.h"
#include "support.h"

#define RIGIDITY 1e-5 /* [N m] */
#define WEIGHT 0.15   /* [kg/m2] */

Suite *mus_suite_bend_clamp(void);


/* a strip of n cells and length L beyond two nodes that are held; damped to hang soon */
static mus_drape *strip(mus_context *context, int32_t n, double length)
{
    const double cell[2] = {length / n, 0.01};
    mus_cloth_def def;
    mus_drape_def scene;
    mus_fabric fabric;
    mus_cloth *cloth = NULL;
    mus_drape *drape = NULL;
    mus_fabric_init(&fabric, sizeof fabric);
    mus_cloth_def_init(&def, sizeof def);
    mus_drape_def_init(&scene, sizeof scene);
    fabric.weight = WEIGHT, fabric.damping = 0.0;
    fabric.stretch[0] = fabric.stretch[1] = 1e4;
    for (int k = 0; k < 3; k++) fabric.bend[k] = RIGIDITY;
    def.fabric = &fabric;
    scene.precision = 64;
    scene.settle_residual = 1e-6;
    scene.settle_seconds = 20.0;
    ck_assert_int_eq(mus_cloth_create_grid(context, 1, n + 2, cell, &def, &cloth), MUS_OK);
    ck_assert_int_eq(mus_drape_create(context, cloth, NULL, &scene, &drape), MUS_OK);
    mus_cloth_destroy(cloth);
    return drape;
}


START_TEST(a_strip_held_at_two_nodes_is_the_elastica)
{
    /* w L^3 / B = 10: tip at 0.656354 L forward, 0.700200 L down (shooting on the elastica's equation) */
    const double length = cbrt(10.0 * RIGIDITY / (WEIGHT * 9.81)), tip[2] = {0.656354, 0.700200};
    static const int32_t cells[] = {10, 20, 40};
    double off[3];
    mus_context *context = support_context();
    for (int i = 0; i < 3; i++) {
        mus_drape *drape = strip(context, cells[i], length);
        ck_assert_int_eq(mus_drape_pin(drape, 0, 1), MUS_OK);
        ck_assert_int_eq(mus_drape_pin(drape, 1, 1), MUS_OK);
        ck_assert_msg(mus_drape_settle(drape, NULL, NULL) == MUS_OK, "%s", mus_context_error(context));
        const double *x = mus_drape_positions(drape);
        const double forward = (x[3 * (cells[i] + 1)] - x[3]) / length, down = -x[3 * (cells[i] + 1) + 1] / length;
        off[i] = hypot(forward - tip[0], down - tip[1]);
        mus_drape_destroy(drape);
    }
    ck_assert_msg(off[1] < 0.006 && off[2] < 0.0016, "off by %g, %g", off[1], off[2]);
    ck_assert_msg(off[0] > 3.3 * off[1] && off[1] > 3.3 * off[2], "off by %g, %g, %g", off[0], off[1], off[2]);
    support_context_end(context);
}
END_TEST


START_TEST(a_node_freed_is_no_clamp)
{
    mus_context *context = support_context();
    mus_drape *drape = strip(context, 4, 0.04);
    mus_drape_report report;
    double x[18] = {0}, energy[3];
    for (int i = 0; i < 6; i++) x[3 * i] = 0.01 * i, x[3 * i + 1] = -1e-3 * i * i;
    for (int i = 0; i < 3; i++) {
        if (i > 0) ck_assert_int_eq(mus_drape_pin(drape, 1, i == 1), MUS_OK);
        if (i > 0) ck_assert_int_eq(mus_drape_pin(drape, 0, i == 1), MUS_OK);
        ck_assert_int_eq(mus_drape_set_state(drape, x, NULL), MUS_OK);
        mus_drape_report_init(&report, sizeof report);
        ck_assert_int_eq(mus_drape_report_get(drape, &report), MUS_OK);
        energy[i] = report.energy;
    }

    /* the stencil over node 1 once more: k/2 |x0 - 2 x1 + x2|^2, k = B / a^2 (a cell as wide as long) */
    ck_assert_double_eq_tol(energy[1] - energy[0], 0.5 * RIGIDITY / 1e-4 * 4e-6, 1e-12);
    ck_assert_double_eq(energy[2], energy[0]);
    mus_drape_destroy(drape);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_bend_clamp(void)
{
    Suite *suite = suite_create("bend_clamp");
    TCase *tests = tcase_create("bend_clamp");
    tcase_add_test(tests, a_strip_held_at_two_nodes_is_the_elastica);
    tcase_add_test(tests, a_node_freed_is_no_clamp);
    suite_add_tcase(suite, tests);
    return suite;
}
