/*
 * test_step_bound.c: the step bound with dashpots and drag: runs at 0.99 of it lose
 * energy, runs above it are refused with both numbers, and it is not far below the true limit.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include <check.h>

#include "muslin/drape.h"
#include "sim/step_bound.h"
#include "support.h"

Suite *mus_suite_step_bound(void);


/* a drape of a small grid without gravity, its threads damped by zeta at their own frequency, shaken */
static mus_drape *shaken_grid(mus_context *context, int32_t stepper, double zeta, double drag)
{
    const double cell[2] = {0.02, 0.02};
    mus_cloth_def def;
    mus_drape_def scene;
    mus_cloth *cloth = NULL;
    mus_drape *drape = NULL;
    uint64_t random = 7;
    double x[108], v[108];
    mus_cloth_def_init(&def, sizeof def);
    mus_fabric fabric;
    mus_fabric_init(&fabric, sizeof fabric);
    def.fabric = &fabric;
    fabric.damping = zeta;
    mus_drape_def_init(&scene, sizeof scene);
    scene.precision = 64;
    scene.integrator = stepper;
    scene.drag = drag;
    scene.gravity[1] = 0.0;
    ck_assert_int_eq(mus_cloth_create_grid(context, 6, 6, cell, &def, &cloth), MUS_OK);
    ck_assert_int_eq(mus_drape_create(context, cloth, NULL, &scene, &drape), MUS_OK);
    mus_cloth_destroy(cloth);
    for (int i = 0; i < 108; i++) {
        x[i] = mus_drape_positions(drape)[i] + support_uniform(&random, -1e-5, 1e-5);
        v[i] = support_uniform(&random, -1e-2, 1e-2);
    }
    ck_assert_int_eq(mus_drape_set_state(drape, x, v), MUS_OK);
    return drape;
}


static double energy(const mus_drape *drape)
{
    mus_drape_report report;
    mus_drape_report_init(&report, sizeof report);
    ck_assert_int_eq(mus_drape_report_get(drape, &report), MUS_OK);
    return report.energy;
}


/* 1e4 steps at 0.5 and 0.99 of the bound; Verlet's energy swings, by less than 2: the bound is below the limit */
START_TEST(steps_below_the_bound_never_gain_energy)
{
    const double zeta[] = {0.0, 0.3, 0.5, 0.7, 1.0}, part[] = {0.5, 0.99};
    const int32_t stepper = _i;
    mus_context *context = support_context();
    for (int i = 0; i < 5; i++)
        for (int j = 0; j < 2; j++) {
            mus_drape *drape = shaken_grid(context, stepper, zeta[i], 0.0);
            const double start = energy(drape);
            for (int k = 0; k < 10; k++)
                ck_assert_int_eq(mus_drape_step(drape, 1000, part[j] * mus_drape_step_bound(drape)), MUS_OK);
            ck_assert_double_le(energy(drape), stepper == MUS_METHOD_RK4 ? start : 2.0 * start);
            mus_drape_destroy(drape);
        }
    support_context_end(context);
}
END_TEST


/* drag alone is a decay that a step can overshoot too */
START_TEST(strong_drag_limits_the_step)
{
    mus_context *context = support_context();
    mus_drape *drape = shaken_grid(context, MUS_METHOD_RK4, 0.1, 1e4);
    const double bound = mus_drape_step_bound(drape), start = energy(drape);
    ck_assert_double_le(bound, 2.785 / 1e4);
    ck_assert_double_ge(bound, 0.85 * 2.785 / 1e4);
    ck_assert_int_eq(mus_drape_step(drape, 1000, 0.99 * bound), MUS_OK);
    ck_assert_double_le(energy(drape), start);
    mus_drape_destroy(drape);
    support_context_end(context);
}
END_TEST


/* one spring between two free nodes: the bound is the true limit, from no damping to overdamped */
START_TEST(the_bound_of_a_pair_is_its_limit)
{
    const double zeta[] = {0.0, 0.2, 0.5, 1.0, 1.5, 2.0, 5.0, 10.0};
    for (int i = 0; i < 8; i++) {
        const double omega = 30.0, z = zeta[i];
        const double limit = z <= 1.0 ? 2.62 : 2.785 / (z + sqrt(z * z - 1.0));
        const double h = mus__step_bound_rk4(omega * omega, 2.0 * z * omega, 2.0 * z / omega, 0.0);
        ck_assert_double_eq_tol(h * omega, limit, 1e-9);
    }
    /* a dashpot without a spring is a decay of its own rate */
    ck_assert_double_eq_tol(mus__step_bound_rk4(0.0, 50.0, INFINITY, 0.0), 2.785 / 50.0, 1e-12);
    ck_assert_double_eq(mus__step_bound_rk4(0.0, 0.0, 0.0, 0.0), 1e9);
}
END_TEST


/* above the bound the step is refused up front, with both numbers, and nothing has moved */
START_TEST(steps_above_the_bound_are_refused)
{
    const double zeta[] = {0.0, 0.5, 1.0}, part[] = {1.01, 2.0};
    mus_context *context = support_context();
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 2; j++) {
            char number[32];
            mus_drape *drape = shaken_grid(context, MUS_METHOD_RK4, zeta[i], 0.5);
            const double bound = mus_drape_step_bound(drape);
            const uint64_t before = mus_drape_hash(drape);
            ck_assert_int_eq(mus_drape_step(drape, 10, part[j] * bound), MUS_ERR_STEP);
            snprintf(number, sizeof number, "%.9g", bound);
            ck_assert_ptr_nonnull(strstr(mus_context_error(context), number));
            ck_assert_uint_eq(mus_drape_hash(drape), before);
            mus_drape_destroy(drape);
        }
    support_context_end(context);
}
END_TEST


Suite *mus_suite_step_bound(void)
{
    Suite *suite = suite_create("step_bound");
    TCase *tests = tcase_create("step_bound");
    tcase_add_loop_test(tests, steps_below_the_bound_never_gain_energy, MUS_METHOD_RK4, MUS_METHOD_VERLET + 1);
    tcase_add_test(tests, strong_drag_limits_the_step);
    tcase_add_test(tests, the_bound_of_a_pair_is_its_limit);
    tcase_add_test(tests, steps_above_the_bound_are_refused);
    suite_add_tcase(suite, tests);
    return suite;
}
