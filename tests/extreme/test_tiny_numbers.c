/*
 * test_tiny_numbers.c: motion that dies away to nothing leaves zeros and no denormal numbers, on which arithmetic is
 * ten times as slow. They are counted; no clock is asked.
 */
#include <float.h>

#include "drape/drape_state.h"

#include "bare.h"

Suite *mus_suite_tiny_numbers(void);

enum { SIDE = 12, N = SIDE * SIDE };


/* numbers of the moving state that are denormal, or whose squares are */
static int32_t denormals(const mus_drape *drape)
{
    int32_t count = 0;
    for (int32_t i = 0; i < 6 * N; i++) {
        if (drape->def.precision == 64) {
            const double y = fabs(((const double *)drape->sim.y)[i]);
            count += y > 0.0 && y * y < DBL_MIN;
        } else {
            const float y = fabsf(((const float *)drape->sim.y)[i]);
            count += y > 0.0f && y * y < FLT_MIN;
        }
    }
    return count;
}


static mus_drape *calm_sheet(mus_context *context, int32_t precision, int32_t integrator, double drag)
{
    mus_cloth *cloth = extreme_grid(context, SIDE, SIDE, 0.02, NULL);
    mus_drape_def def;
    mus_drape *drape;
    mus_drape_def_init(&def, sizeof def);
    def.precision = precision;
    def.integrator = integrator;
    def.gravity[1] = 0.0;
    def.drag = drag;
    ck_assert_int_eq(mus_drape_create(context, cloth, NULL, &def, &drape), MUS_OK);
    mus_cloth_destroy(cloth);
    return drape;
}


/* velocities of 1e-310 (1e-40 in float) at rest */
START_TEST(a_denormal_state_becomes_rest)
{
    mus_context *context = support_context();
    const int32_t precision = _i & 1 ? 64 : 32;
    mus_drape *drape = calm_sheet(context, precision, _i >> 1, 0.5);
    double x[3 * N], v[3 * N];
    uint64_t random = 5;
    memcpy(x, mus_drape_positions(drape), sizeof x);
    for (int32_t i = 0; i < 3 * N; i++) {
        x[i] += support_uniform(&random, -1, 1) * (i % 3 == 2 ? 1e-310 : 0.0);
        v[i] = support_uniform(&random, -1, 1) * (precision == 64 ? 1e-310 : 1e-40);
    }
    ck_assert_int_eq(mus_drape_set_state(drape, x, v), MUS_OK);
    ck_assert_int_eq(denormals(drape), 0);
    ck_assert_int_eq(mus_drape_step(drape, 200, 0.5 * mus_drape_step_bound(drape)), MUS_OK);
    ck_assert_int_eq(denormals(drape), 0);
    mus_drape_destroy(drape);
    support_context_end(context);
}
END_TEST


/* a sheet that glides as a whole, under a drag which takes 1 mm/s to 1e-200 of it: never a denormal at a look */
START_TEST(a_motion_that_dies_away_passes_no_denormal)
{
    mus_context *context = support_context();
    const int32_t precision = _i & 1 ? 64 : 32;
    mus_drape *drape = calm_sheet(context, precision, _i >> 1, 400.0);
    double x[3 * N], v[3 * N] = {0};
    memcpy(x, mus_drape_positions(drape), sizeof x);
    for (int32_t i = 0; i < N; i++) v[3 * i + 2] = 1e-3;
    ck_assert_int_eq(mus_drape_set_state(drape, x, v), MUS_OK);
    const double h = 0.9 * mus_drape_step_bound(drape);
    ck_assert_double_lt(h, 1e-3);
    for (int32_t k = 0; k < (int32_t)(1.2 / (64 * h)); k++) {
        ck_assert_int_eq(mus_drape_step(drape, 64, h), MUS_OK);
        ck_assert_int_eq(denormals(drape), 0);
    }
    mus_drape_destroy(drape);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_tiny_numbers(void)
{
    Suite *suite = suite_create("tiny_numbers");
    TCase *tests = tcase_create("tiny_numbers");
    tcase_add_loop_test(tests, a_denormal_state_becomes_rest, 0, 4);
    tcase_add_loop_test(tests, a_motion_that_dies_away_passes_no_denormal, 0, 4);
    suite_add_tcase(suite, tests);
    return suite;
}
