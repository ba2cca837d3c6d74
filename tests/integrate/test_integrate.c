/*
 * test_integrate.c: the laws of the integrators on scenes with exact answers (cases I1-I4, I6), their
 * orders, and what they refuse.
 */
#include <float.h>
#include <math.h>
#include <string.h>

#include <check.h>

#include "integrate/motions.h"
#include "support.h"

Suite *mus_suite_integrate(void);

static const int32_t methods[] = {MUS_METHOD_RK4, MUS_METHOD_VERLET, MUS_METHOD_EULER};


/* ---- I1: the conditions of order 4, each as what one step of h = 1 makes of a system of powers of time ---- */

/* sum b c^(q-1) = 1/q; b c (a c) = 1/8; b a c = 1/6; b a c^2 = 1/12; b a a c = 1/24 */
static void powers(void *user, double t, const double *y, double *dy)
{
    (void)user;
    dy[0] = 1.0;      /* 1 */
    dy[1] = t;        /* 1/2 */
    dy[2] = t * t;    /* 1/3 */
    dy[3] = t * t * t; /* 1/4 */
    dy[4] = y[1];     /* 1/6 */
    dy[5] = t * y[1]; /* 1/8 */
    dy[6] = y[2];     /* 1/12 */
    dy[7] = y[4];     /* 1/24 */
}


START_TEST(runge_kutta_meets_the_eight_conditions_of_order_four)
{
    const double inverse[8] = {1, 2, 3, 4, 6, 8, 12, 24};
    double y[8] = {0};
    const mus_integrate_def def = motion_def(MUS_METHOD_RK4, 1.0, powers, NULL);
    motion_run(&def, 8, y, 1);
    for (int i = 0; i < 8; i++) ck_assert_double_le(fabs(y[i] * inverse[i] - 1.0), DBL_EPSILON);
}
END_TEST


/* ---- I2, I3, I4 ---- */

START_TEST(free_fall_is_exact_at_any_step)
{
    const double steps[] = {1e-3, 0.01, 0.1, 1.0};
    for (int i = 0; i < 4; i++)
        for (int m = 0; m < 2; m++) {
            double y[2] = {1.5, 0.75};
            const int n = (int)lround(2.0 / steps[i]);
            const mus_integrate_def def = motion_def(methods[m], steps[i], motion_fall_rate, NULL);
            motion_run(&def, 2, y, n);
            const double t = n * steps[i], x = 1.5 + 0.75 * t - 0.5 * GRAVITY * t * t, v = 0.75 - GRAVITY * t;
            ck_assert_double_le(fabs(y[0] - x), 1e-12 * fabs(x));
            ck_assert_double_le(fabs(y[1] - v), 1e-12 * fabs(v));
        }
}
END_TEST


/* E_N / E_0 = (1 - z^6/72 + z^8/576)^N exactly */
START_TEST(energy_of_a_spring_decays_as_the_formula_says)
{
    const double z[] = {0.1, 0.5, 1.0, 2.0, 2.82};
    for (int i = 0; i < 5; i++) {
        motion_spring spring = {.omega = 7.0};
        const double z2 = z[i] * z[i], exact = pow(1.0 - z2 * z2 * z2 / 72.0 + z2 * z2 * z2 * z2 / 576.0, 1000.0);
        double y[2] = {0.3, -1.1};
        const double start = motion_spring_energy(&spring, 0.0, y);
        const mus_integrate_def def = motion_def(MUS_METHOD_RK4, z[i] / spring.omega, motion_spring_rate, &spring);
        motion_run(&def, 2, y, 1000);
        ck_assert_double_le(fabs(motion_spring_energy(&spring, 0.0, y) / start - exact), 1e-11 * exact);
        ck_assert_int_eq(spring.evaluations, 4000);
    }
}
END_TEST


/* |R(iz)| <= 1 up to 2 sqrt 2: energy after 1000 steps on both sides of it */
START_TEST(stability_ends_at_two_root_two)
{
    const double z[] = {2.8284, 2.83}, expected[] = {0.8725, 2714.0};
    for (int i = 0; i < 2; i++) {
        motion_spring spring = {.omega = 1.0};
        double y[2] = {1.0, 0.0};
        const mus_integrate_def def = motion_def(MUS_METHOD_RK4, z[i], motion_spring_rate, &spring);
        motion_run(&def, 2, y, 1000);
        ck_assert_double_le(fabs((y[0] * y[0] + y[1] * y[1]) / expected[i] - 1.0), 1e-3);
    }
}
END_TEST


/* Verlet keeps v^2 + omega^2 x^2 (1 - z^2/4), Euler v^2 + omega^2 (x^2 - h x v), both for ever below z = 2 */
START_TEST(verlet_and_euler_keep_their_own_energy)
{
    const double z[] = {0.01, 0.5, 1.9, 1.999};
    for (int i = 0; i < 4; i++)
        for (int m = 1; m < 3; m++) {
            motion_spring spring = {.omega = 3.0};
            const double h = z[i] / spring.omega;
            double y[2] = {0.3, -1.1}, energy[2];
            for (int k = 0; k < 2; k++) {
                energy[k] = y[1] * y[1] + 9.0 * (m == 1 ? y[0] * y[0] * (1.0 - z[i] * z[i] / 4.0)
                                                        : y[0] * y[0] - h * y[0] * y[1]);
                const mus_integrate_def def = motion_def(methods[m], h, motion_spring_rate, &spring);
                if (k == 0) motion_run(&def, 2, y, 100000);
            }
            ck_assert_double_le(fabs(energy[1] / energy[0] - 1.0), 1e-9);
            ck_assert_int_eq(spring.evaluations, m == 1 ? 100001 : 100000);
        }
}
END_TEST


/* ---- orders ---- */

static double pendulum_error(int32_t method, int steps)
{
    motion_pendulum pendulum = {.k = 100.0};
    double coarse[4] = {1.0, 0.0, 0.0, 0.0}, fine[4] = {1.0, 0.0, 0.0, 0.0};
    mus_integrate_def def = motion_def(method, 1.0 / steps, motion_pendulum_rate, &pendulum);
    motion_run(&def, 4, coarse, steps);
    def.step = 0.5 / steps;
    motion_run(&def, 4, fine, 2 * steps);
    return hypot(coarse[0] - fine[0], coarse[1] - fine[1]);
}


/* I6, self-convergence: the difference of two steps falls 2^order-fold when both are halved */
START_TEST(orders_on_a_spring_pendulum_are_four_two_and_one)
{
    const double order[] = {4.0, 2.0, 1.0};
    for (int m = 0; m < 3; m++) {
        const double slope = log2(pendulum_error(methods[m], 1 << 10) / pendulum_error(methods[m], 1 << 11));
        ck_assert_double_eq_tol(slope, order[m], 0.05);
    }
}
END_TEST


/* x'' = 6 t + 2 x' - 2 v(t), whose answer from 0 at t0 = 2 is x = t^3 - 8 - 12 (t - 2), x' = 3 t^2 - 12 */
static void cubic(void *user, double t, const double *y, double *dy)
{
    (void)user;
    dy[0] = y[1];
    dy[1] = 6.0 * t + 2.0 * y[1] - 2.0 * (3.0 * t * t - 12.0);
}


/* time counts from `start`, at the stages too: a force that depends on time is followed */
START_TEST(time_starts_where_the_def_says)
{
    for (int m = 0; m < 3; m++) {
        double y[2] = {0.0, 0.0};
        mus_integrate_def def = motion_def(methods[m], 1e-3, cubic, NULL);
        def.start = 2.0;
        motion_run(&def, 2, y, 1000);
        ck_assert_double_eq_tol(y[0], 27.0 - 8.0 - 12.0, m == 0 ? 1e-10 : 0.1);
        ck_assert_double_eq_tol(y[1], 15.0, m == 0 ? 1e-10 : 0.2);
    }
}
END_TEST


static void note_time(void *user, double t, const double *y, double *dy)
{
    double *latest = user;
    (void)y;
    dy[0] = dy[1] = 0.0;
    latest[0] = t > latest[0] ? t : latest[0];
}


/* the time of step k is start + k h to the last bit, in float runs too, where a sum of 1 ms stops at 32768 s */
START_TEST(time_is_no_running_sum)
{
    double latest = 0.0, y[2] = {0.0, 0.0};
    mus_integrate_def def = motion_def(MUS_METHOD_RK4, 1e-3, note_time, &latest);
    def.start = 1e6;
    motion_run(&def, 2, y, 1000000);
    ck_assert(latest == 1e6 + 1e6 * 1e-3);
}
END_TEST


/* one run of 100 steps is 100 runs of one, bit for bit, where forces do not depend on velocity */
START_TEST(a_run_cut_in_pieces_is_the_same_run)
{
    for (int m = 0; m < 3; m++) {
        motion_pendulum pendulum = {.k = 100.0};
        double whole[4] = {1.0, 0.0, 0.0, 0.0}, pieces[4] = {1.0, 0.0, 0.0, 0.0};
        mus_integrate_def def = motion_def(methods[m], 0.01, motion_pendulum_rate, &pendulum);
        motion_run(&def, 4, whole, 100);
        for (int k = 0; k < 100; k++) motion_run(&def, 4, pieces, 1);
        ck_assert_mem_eq(whole, pieces, sizeof whole);
    }
}
END_TEST


START_TEST(float_follows_double_to_its_rounding)
{
    mus_context *context = support_context();
    for (int m = 0; m < 3; m++) {
        motion_spring spring = {.omega = 1.0};
        double y[2] = {1.0, 0.0};
        float yf[2] = {1.0f, 0.0f}, work[8];
        mus_integrate_def def = motion_def(methods[m], 0.01, motion_spring_rate, &spring);
        def.rate32 = motion_spring_rate32;
        motion_run(&def, 2, y, 1000);
        ck_assert_int_eq(mus_integrate_f32(context, &def, 2, yf, 1000, work, NULL), MUS_OK);
        ck_assert_double_le(fabs(y[0] - (double)yf[0]), 2e-5);
        ck_assert_double_le(fabs(y[0] - cos(10.0)), m == 0 ? 1e-8 : m == 1 ? 1e-4 : 1e-2);
    }
    support_context_end(context);
}
END_TEST


/* ---- the guard ---- */

/* above the limit the energy guard ends the run, at a state that was good; RK4 within 100 steps, the others
 * within 400, since at rest they hardly hold the part that grows */
START_TEST(a_step_above_the_limit_ends_with_the_last_good_state)
{
    mus_context *context = support_context();
    const double zeta[] = {0.0, 0.5, 1.0, 2.0}, reach[] = {2.8284271, 2.6231, 2.78529, 0.7463}, over[] = {1.01, 2.0};
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 2; j++)
            for (int m = 0; m < 3; m++) {
                motion_spring spring = {.omega = 5.0, .zeta = zeta[i]};
                const double limit = m == 0 ? reach[i] : 2.0 * (sqrt(1.0 + zeta[i] * zeta[i]) - zeta[i]);
                double y[2] = {1.0, 0.0}, again[2] = {1.0, 0.0}, work[8];
                int64_t done = -1;
                mus_integrate_def def = motion_def(methods[m], over[j] * limit / 5.0, motion_spring_rate, &spring);
                def.energy = motion_spring_energy;
                const int64_t steps = m == 0 ? 100 : 400;
                ck_assert_int_eq(mus_integrate(context, &def, 2, y, steps, work, &done), MUS_ERR_DIVERGED);
                ck_assert_int_lt(done, steps);
                ck_assert(strstr(mus_context_error(context), "energy") != NULL);
                ck_assert_double_le(motion_spring_energy(&spring, 0.0, y), 1.5 * 12.5);
                def.energy = NULL;
                motion_run(&def, 2, again, done);
                ck_assert_mem_eq(y, again, sizeof y);
            }
    support_context_end(context);
}
END_TEST


/* below the limit nothing is refused and nothing grows; the energy of Euler swings by (1 + z/2) / (1 - z/2) */
START_TEST(a_step_below_the_limit_runs_on)
{
    const double zeta[] = {0.0, 0.5, 1.0, 2.0}, reach[] = {2.8284271, 2.6231, 2.78529, 0.7463}, under[] = {0.5, 0.99};
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 2; j++)
            for (int m = 0; m < 3; m++) {
                motion_spring spring = {.omega = 5.0, .zeta = zeta[i]};
                const double limit = m == 0 ? reach[i] : 2.0 * (sqrt(1.0 + zeta[i] * zeta[i]) - zeta[i]);
                double y[2] = {1.0, 0.0};
                mus_integrate_def def = motion_def(methods[m], under[j] * limit / 5.0, motion_spring_rate, &spring);
                motion_run(&def, 2, y, 100000);
                ck_assert_double_le(motion_spring_energy(&spring, 0.0, y), (m == 0 ? 1.0 : 200.0) * 12.5);
            }
}
END_TEST


/* y' = y^2 from 1 leaves every bound at t = 1 */
static void burst(void *user, double t, const double *y, double *dy)
{
    (void)user;
    (void)t;
    dy[0] = y[0] * y[0];
}


START_TEST(numbers_that_are_not_finite_end_a_run_without_an_energy)
{
    mus_context *context = support_context();
    double y = 1.0, work[4];
    int64_t done = -1;
    mus_integrate_def def = motion_def(MUS_METHOD_RK4, 0.01, burst, NULL);
    def.guard_every = 1;
    ck_assert_int_eq(mus_integrate(context, &def, 1, &y, 1000, work, &done), MUS_ERR_DIVERGED);
    ck_assert(isfinite(y));
    ck_assert(done > 95 && done < 120);
    ck_assert(strstr(mus_context_error(context), "y[0]") != NULL);
    support_context_end(context);
}
END_TEST


START_TEST(float_runs_are_guarded_too)
{
    mus_context *context = support_context();
    for (int guarded = 0; guarded < 2; guarded++) {
        motion_spring spring = {.omega = 5.0};
        float y[2] = {1.0f, 0.0f}, work[8];
        int64_t done = -1;
        mus_integrate_def def = motion_def(MUS_METHOD_RK4, 2.0 * 2.83 / 5.0, NULL, &spring);
        def.rate32 = motion_spring_rate32;
        if (guarded) def.energy32 = motion_spring_energy32;
        def.guard_every = 1;
        ck_assert_int_eq(mus_integrate_f32(context, &def, 2, y, 100, work, &done), MUS_ERR_DIVERGED);
        ck_assert(strstr(mus_context_error(context), guarded ? "energy" : "y[") != NULL);
        ck_assert(isfinite(y[0]) && isfinite(y[1]) && done < 100 && (done == 0) == guarded);
    }
    support_context_end(context);
}
END_TEST


START_TEST(a_start_at_energy_zero_needs_the_floor)
{
    mus_context *context = support_context();
    motion_pendulum pendulum = {.k = 100.0};
    for (int floor = 0; floor < 2; floor++) {
        double y[4] = {0.0, -1.0, 0.0, 0.0}, work[16];
        mus_integrate_def def = motion_def(MUS_METHOD_EULER, 0.01, motion_pendulum_rate, &pendulum);
        def.energy = motion_pendulum_energy;
        def.energy_floor = floor ? 1.0 : 0.0;
        const mus_status status = mus_integrate(context, &def, 4, y, 1000, work, NULL);
        ck_assert_int_eq(status, floor ? MUS_OK : MUS_ERR_DIVERGED);
    }
    support_context_end(context);
}
END_TEST


/* ---- refused calls ---- */

START_TEST(steps_and_counts_outside_their_range_are_refused)
{
    mus_context *context = support_context();
    motion_spring spring = {.omega = 1.0};
    const double bad[] = {-0.01, NAN, INFINITY, -INFINITY, 1e-320};
    const int64_t wrong[] = {-1, INT64_MAX, INT64_MIN};
    double y[2] = {1.0, 0.5}, work[8];
    int64_t done = -1;
    for (int i = 0; i < 5; i++) {
        const mus_integrate_def def = motion_def(MUS_METHOD_RK4, bad[i], motion_spring_rate, &spring);
        ck_assert_int_eq(mus_integrate(context, &def, 2, y, 10, work, &done), MUS_ERR_ARG);
        ck_assert(strstr(mus_context_error(context), "step is") != NULL);
    }
    mus_integrate_def def = motion_def(MUS_METHOD_RK4, 0.01, motion_spring_rate, &spring);
    for (int i = 0; i < 3; i++) {
        const mus_status want = wrong[i] > 0 ? MUS_ERR_LIMIT : MUS_ERR_ARG;
        ck_assert_int_eq(mus_integrate(context, &def, 2, y, wrong[i], work, &done), want);
        ck_assert_int_eq(mus_integrate(context, &def, wrong[i], y, 1, work, &done), want);
    }
    def.method = MUS_METHOD_VERLET;
    ck_assert_int_eq(mus_integrate(context, &def, 1, y, 10, work, &done), MUS_ERR_ARG);
    def.rate32 = motion_spring_rate32;
    def.step = 1e-40;
    float yf[2] = {1.0f, 0.5f}, workf[8];
    ck_assert_int_eq(mus_integrate_f32(context, &def, 2, yf, 10, workf, &done), MUS_ERR_ARG);
    ck_assert(y[0] == 1.0 && y[1] == 0.5 && yf[0] == 1.0f && done == 0 && spring.evaluations == 0);
    support_context_end(context);
}
END_TEST


START_TEST(no_steps_a_step_of_zero_and_no_numbers_change_nothing)
{
    motion_spring spring = {.omega = 1.0};
    double y[2] = {1.0, 0.5};
    mus_integrate_def def = motion_def(MUS_METHOD_RK4, 0.01, motion_spring_rate, &spring);
    motion_run(&def, 2, y, 0);
    motion_run(&def, 0, y, 10);
    def.step = 0.0;
    motion_run(&def, 2, y, 10);
    ck_assert(y[0] == 1.0 && y[1] == 0.5 && spring.evaluations == 0);
}
END_TEST


START_TEST(defs_and_arguments_are_checked)
{
    mus_context *context = support_context();
    motion_spring spring = {.omega = 1.0};
    double y[2] = {1.0, NAN}, work[8];
    const mus_integrate_def good = motion_def(MUS_METHOD_RK4, 0.01, motion_spring_rate, &spring);
    ck_assert_int_eq(mus_integrate(context, &good, 2, y, 10, work, NULL), MUS_ERR_ARG);
    ck_assert(strstr(mus_context_error(context), "y[1] is") != NULL);
    y[1] = 0.5;
    ck_assert_int_eq(mus_integrate(NULL, &good, 2, y, 10, work, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_integrate(context, NULL, 2, y, 10, work, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_integrate(context, &good, 2, NULL, 10, work, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_integrate(context, &good, 2, y, 10, NULL, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_integrate_f32(context, &good, 2, (float[2]){0}, 10, (float[8]){0}, NULL), MUS_ERR_ARG);
    ck_assert(strstr(mus_context_error(context), "rate32") != NULL);
    for (int i = 0; i < 7; i++) {
        mus_integrate_def def = good;
        if (i == 0) def.method = 3;
        if (i == 1) def.rate = NULL;
        if (i == 2) def.guard_every = 0;
        if (i == 3) def.start = NAN;
        if (i == 4) def.energy_growth = 0.9;
        if (i == 5) def.energy_floor = -1.0;
        if (i == 6) def.size = 8;
        ck_assert_int_eq(mus_integrate(context, &def, 2, y, 10, work, NULL), i == 6 ? MUS_ERR_VERSION : MUS_ERR_ARG);
    }
    ck_assert(y[0] == 1.0 && y[1] == 0.5 && spring.evaluations == 0);
    support_context_end(context);
}
END_TEST


START_TEST(work_space_is_that_of_the_method)
{
    ck_assert_int_eq(mus_integrate_work(MUS_METHOD_RK4, 10), 40);
    ck_assert_int_eq(mus_integrate_work(MUS_METHOD_VERLET, 10), 20);
    ck_assert_int_eq(mus_integrate_work(MUS_METHOD_EULER, 10), 20);
    ck_assert_int_eq(mus_integrate_work(3, 10), 0);
    ck_assert_int_eq(mus_integrate_work(MUS_METHOD_RK4, -1), 0);
    ck_assert_int_eq(mus_integrate_work(MUS_METHOD_RK4, INT64_MAX), 0);
}
END_TEST


Suite *mus_suite_integrate(void)
{
    Suite *suite = suite_create("integrate");
    TCase *tests = tcase_create("integrate");
    tcase_add_test(tests, runge_kutta_meets_the_eight_conditions_of_order_four);
    tcase_add_test(tests, free_fall_is_exact_at_any_step);
    tcase_add_test(tests, energy_of_a_spring_decays_as_the_formula_says);
    tcase_add_test(tests, stability_ends_at_two_root_two);
    tcase_add_test(tests, verlet_and_euler_keep_their_own_energy);
    tcase_add_test(tests, orders_on_a_spring_pendulum_are_four_two_and_one);
    tcase_add_test(tests, time_starts_where_the_def_says);
    tcase_add_test(tests, time_is_no_running_sum);
    tcase_add_test(tests, a_run_cut_in_pieces_is_the_same_run);
    tcase_add_test(tests, float_follows_double_to_its_rounding);
    tcase_add_test(tests, a_step_above_the_limit_ends_with_the_last_good_state);
    tcase_add_test(tests, a_step_below_the_limit_runs_on);
    tcase_add_test(tests, numbers_that_are_not_finite_end_a_run_without_an_energy);
    tcase_add_test(tests, float_runs_are_guarded_too);
    tcase_add_test(tests, a_start_at_energy_zero_needs_the_floor);
    tcase_add_test(tests, steps_and_counts_outside_their_range_are_refused);
    tcase_add_test(tests, no_steps_a_step_of_zero_and_no_numbers_change_nothing);
    tcase_add_test(tests, defs_and_arguments_are_checked);
    tcase_add_test(tests, work_space_is_that_of_the_method);
    suite_add_tcase(suite, tests);
    return suite;
}
