/*
 * test_rk4.c: the bare integrator on scenes with exact answers (reference/numerics.md I2, I3, I4, I6).
 */
#include <math.h>
#include <string.h>

#include <check.h>

#include "drape/rk4.h"

Suite *mus_suite_rk4(void);


/* y = (x, v): x'' = -9.81 */
static void rk4_fall(void *user, const double *y, double *dy)
{
    (void)user;
    dy[0] = y[1];
    dy[1] = -9.81;
}


/* x'' = -omega^2 x */
static void rk4_spring(void *user, const double *y, double *dy)
{
    const double omega = *(const double *)user;
    dy[0] = y[1];
    dy[1] = -omega * omega * y[0];
}


/* a mass on a spring that swings: y = (x, y, vx, vy), k = 100, m = 1, l = 1, hung at the origin */
static void rk4_pendulum(void *user, const double *y, double *dy)
{
    (void)user;
    const double l = sqrt(y[0] * y[0] + y[1] * y[1]), pull = -100.0 * (l - 1.0) / l;
    dy[0] = y[2];
    dy[1] = y[3];
    dy[2] = pull * y[0];
    dy[3] = pull * y[1] - 9.81;
}


START_TEST(free_fall_is_exact_at_any_step)
{
    const double steps[] = {1e-3, 0.01, 0.1, 1.0};
    for (int i = 0; i < 4; i++) {
        double y[2] = {1.5, 0.75}, work[6];
        const int n = (int)lround(2.0 / steps[i]);
        for (int k = 0; k < n; k++) mus__rk4_f64(2, y, steps[i], rk4_fall, NULL, work);
        const double t = n * steps[i], x = 1.5 + 0.75 * t - 0.5 * 9.81 * t * t, v = 0.75 - 9.81 * t;
        ck_assert_double_le(fabs(y[0] - x), 1e-13 * fabs(x) * 10);
        ck_assert_double_le(fabs(y[1] - v), 1e-13 * fabs(v) * 10);
    }
}
END_TEST


/* E_N / E_0 = (1 - z^6/72 + z^8/576)^N exactly */
START_TEST(energy_of_a_spring_decays_as_the_formula_says)
{
    const double z[] = {0.1, 0.5, 1.0, 2.0, 2.82};
    for (int i = 0; i < 5; i++) {
        const double omega = 7.0, h = z[i] / omega, z2 = z[i] * z[i];
        double y[2] = {0.3, -1.1}, work[6];
        const double start = omega * omega * y[0] * y[0] + y[1] * y[1];
        for (int k = 0; k < 1000; k++) mus__rk4_f64(2, y, h, rk4_spring, (void *)&omega, work);
        const double ratio = (omega * omega * y[0] * y[0] + y[1] * y[1]) / start;
        const double exact = pow(1.0 - z2 * z2 * z2 / 72.0 + z2 * z2 * z2 * z2 / 576.0, 1000.0);
        ck_assert_double_le(fabs(ratio - exact), 1e-11 * exact);
    }
}
END_TEST


/* |R(iz)| <= 1 up to 2 sqrt 2: energy after 1000 steps on both sides of it */
START_TEST(stability_ends_at_two_root_two)
{
    const double z[] = {2.8284, 2.83}, expected[] = {0.8725, 2714.0};
    for (int i = 0; i < 2; i++) {
        const double omega = 1.0;
        double y[2] = {1.0, 0.0}, work[6];
        for (int k = 0; k < 1000; k++) mus__rk4_f64(2, y, z[i], rk4_spring, (void *)&omega, work);
        ck_assert_double_le(fabs((y[0] * y[0] + y[1] * y[1]) / expected[i] - 1.0), 1e-3);
    }
}
END_TEST


static void rk4_swing(int steps, double *y)
{
    double work[12];
    const double start[4] = {1.0, 0.0, 0.0, 0.0};
    memcpy(y, start, sizeof start);
    for (int k = 0; k < steps; k++) mus__rk4_f64(4, y, 1.0 / steps, rk4_pendulum, NULL, work);
}


/* self-convergence: the difference of two steps falls 16-fold when both are halved */
START_TEST(order_is_four_on_a_spring_pendulum)
{
    double before = 0.0, slope = 0.0;
    for (int p = 7; p <= 11; p++) {
        double coarse[4], fine[4];
        rk4_swing(1 << p, coarse);
        rk4_swing(2 << p, fine);
        const double error = hypot(coarse[0] - fine[0], coarse[1] - fine[1]);
        if (before > 0.0) slope = log2(before / error);
        before = error;
    }
    ck_assert_double_eq_tol(slope, 4.0, 0.1);
}
END_TEST


static void rk4_spring_float(void *user, const float *y, float *dy)
{
    (void)user;
    dy[0] = y[1];
    dy[1] = -y[0];
}


START_TEST(float_follows_double_to_its_rounding)
{
    double y[2] = {1.0, 0.0}, work[6];
    const double omega = 1.0;
    float yf[2] = {1.0f, 0.0f}, workf[6];
    for (int k = 0; k < 1000; k++) {
        mus__rk4_f64(2, y, 0.01, rk4_spring, (void *)&omega, work);
        mus__rk4_f32(2, yf, 0.01f, rk4_spring_float, NULL, workf);
    }
    ck_assert_double_le(fabs(y[0] - (double)yf[0]), 1e-4);
    ck_assert_double_le(fabs(y[0] - cos(10.0)), 1e-8);
}
END_TEST


Suite *mus_suite_rk4(void)
{
    Suite *suite = suite_create("rk4");
    TCase *tests = tcase_create("rk4");
    tcase_add_test(tests, free_fall_is_exact_at_any_step);
    tcase_add_test(tests, energy_of_a_spring_decays_as_the_formula_says);
    tcase_add_test(tests, stability_ends_at_two_root_two);
    tcase_add_test(tests, order_is_four_on_a_spring_pendulum);
    tcase_add_test(tests, float_follows_double_to_its_rounding);
    suite_add_tcase(suite, tests);
    return suite;
}
