/*
 * test_stiff.c: the integrators on stiff problems with known answers (cases I5, I7).
 *
 * The beam is problem BEAM of the IVP test set (Mazzia, Magherini, release 2.4; Hairer, Wanner, Solving ODEs II, 1996,
 * IV.1); its reference values at t = 5 are from there, computed by RADAU in quadruple precision.
 */
#include <math.h>
#include <string.h>

#include <check.h>

#include "integrate/motions.h"
#include "support.h"

#define PI 3.14159265358979323846

Suite *mus_suite_stiff(void);


/* ---- I5: the limit of a damped spring ---- */

/* largest stable omega h: 0.99 of it decays, 1.01 grows; least at zeta = 0.5, where the bound of a drape has 2.62 */
START_TEST(damped_springs_are_stable_up_to_the_known_step)
{
    const double zeta[] = {0, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.8, 1, 1.5, 2, 3, 5, 10};
    const double known[] = {2.828, 2.910, 2.951, 2.940, 2.835, 2.701, 2.623, 2.629, 2.792, 2.785};
    for (int i = 0; i < 15; i++)
        for (int side = 0; side < 2; side++) {
            const double z = i < 10 ? known[i] : 2.78529 / (zeta[i] + sqrt(zeta[i] * zeta[i] - 1.0));
            motion_spring spring = {.omega = 1.0, .zeta = zeta[i]};
            double y[2] = {1.0, 0.7};
            const double start = motion_spring_energy(&spring, 0.0, y);
            const double h = z * (side ? 1.01 : 0.99);
            const mus_integrate_def def = motion_def(MUS_METHOD_RK4, h, motion_spring_rate, &spring);
            motion_run(&def, 2, y, 2000);
            ck_assert_int_eq(motion_spring_energy(&spring, 0.0, y) > start, side);
        }
}
END_TEST


/* ---- I7: a pendulum on a stiff spring ---- */

/* slow period by the passages of x = 0 from the first to the one after `swings` more, and the energy of the fast motion
 * (r' and r - its balance) at their ends. A passage is found by cutting its step */
typedef struct swinging {
    double period, fast[2];
    int64_t steps;
} swinging;


static double fast_energy(double k, const double *y)
{
    const double r = hypot(y[0], y[1]), speed = (y[0] * y[2] + y[1] * y[3]) / r;
    const double around = (y[0] * y[3] - y[1] * y[2]) / r;
    const double balance = 1.0 + (around * around / r - GRAVITY * y[1] / r) / k;
    return 0.5 * speed * speed + 0.5 * k * (r - balance) * (r - balance);
}


static double passage(const mus_integrate_def *def, const double *before, const double *after)
{
    double part = def->step, y[4];
    memcpy(y, after, sizeof y);
    for (int i = 0; i < 6; i++) {
        mus_integrate_def cut = *def;
        part -= y[0] / y[2];
        cut.step = fmax(part, 1e-12 * def->step);
        memcpy(y, before, sizeof y);
        motion_run(&cut, 4, y, 1);
    }
    return part;
}


/* from `angle`, the spring stretched by `push` more than its balance; steps of z = fast omega times h */
static swinging swing(double angle, double push, double ratio, double z, int32_t swings)
{
    /* small slow omega^2 = g / l, fast omega^2 = k */
    motion_pendulum pendulum = {.k = GRAVITY * ratio * ratio};
    const double r = 1.0 + GRAVITY * cos(angle) / pendulum.k + push;
    const mus_integrate_def def = motion_def(MUS_METHOD_RK4, z / sqrt(pendulum.k), motion_pendulum_rate, &pendulum);
    double y[4] = {r * sin(angle), -r * cos(angle), 0.0, 0.0}, before[4], first = 0.0;
    swinging s = {.fast = {fast_energy(pendulum.k, y), 0.0}};
    for (int32_t seen = 0; seen <= swings; s.steps++) {
        memcpy(before, y, sizeof y);
        motion_run(&def, 4, y, 1);
        if ((before[0] > 0.0) == (y[0] > 0.0)) continue;
        const double at = (double)s.steps * def.step + passage(&def, before, y);
        if (seen == 0) first = at;
        s.period = 2.0 * (at - first) / (seen > 0 ? seen : 1);
        seen++;
    }
    s.fast[1] = fast_energy(pendulum.k, y);
    return s;
}


/* T/T0 = 1/agm(1, cos(angle/2)), and the spring adds a part of m g/(k l) = 1/ratio^2 to first order */
START_TEST(a_pendulum_on_a_stiff_spring_keeps_time)
{
    const double t0 = 2.0 * PI / sqrt(GRAVITY), exact[] = {1.0174088, 1.0731820, 1.1803406, 1.3728805};
    for (int i = 0; i < 4; i++) {
        const double angle = (30.0 + 30.0 * i) * PI / 180.0;
        const swinging soft = swing(angle, 0.0, 100.0, 0.5, 1), stiff = swing(angle, 0.0, 1000.0, 0.5, 1);
        ck_assert_double_eq_tol(stiff.period / t0, exact[i], 3e-6);
        ck_assert_double_eq_tol((100.0 * stiff.period - soft.period) / (99.0 * t0), exact[i], 1e-7);
    }
}
END_TEST


/* at 0.9 of the stable step, ratios of the frequencies from 10 to 10000 over many swings: the slow period is right
 * and what swings fast dies away as (1 - z^6/72 + z^8/576)^N, never grows */
START_TEST(a_stiff_spring_loses_its_fast_motion_and_keeps_the_slow_one)
{
    const double ratio[] = {10, 100, 1000, 10000};
    const int32_t swings[] = {40, 400, 100, 10};
    for (int i = 0; i < 4; i++) {
        const double angle = 0.01, t0 = 2.0 * PI / sqrt(GRAVITY) * (1.0 + angle * angle / 16.0);
        const swinging s = swing(angle, 1e-4 / ratio[i], ratio[i], 0.9 * 2.62, swings[i]);
        /* the spring hangs g/k lower: a part 1/(2 ratio^2) of the period; the phase of RK4 lags by z^4/120 a radian */
        const double z = 0.9 * 2.62 / ratio[i], part = 0.5 / (ratio[i] * ratio[i]) + pow(z, 4.0) / 120.0;
        ck_assert_double_le(fabs(s.period / t0 - 1.0 - part), 0.1 * part + 1e-8);
        ck_assert_double_le(s.fast[1], 0.01 * s.fast[0]);
    }
    /* a slower step lets one see it go: z = 1 over one swing at a ratio of 100 */
    const swinging s = swing(1e-4, 1e-4, 100.0, 1.0, 1);
    const double exact = (double)s.steps * log(1.0 - 1.0 / 72.0 + 1.0 / 576.0);
    ck_assert_double_eq_tol(log(s.fast[1] / s.fast[0]) / exact, 1.0, 0.01);
}
END_TEST


/* 100000 slow periods of a spring pendulum that moves along one line: two masses in a row */
static void two_masses(void *user, double t, const double *y, double *dy)
{
    const double k = *(const double *)user, pull = k * (y[1] - y[0]);
    (void)t;
    dy[0] = y[2], dy[1] = y[3];
    dy[2] = pull - y[0], dy[3] = -pull;
}


/* wall - 1 N/m - mass - k - mass; slow omega^2 = 1/2 to first order in 1/k: 1/2 - 1/(8 k) ... */
START_TEST(a_hundred_thousand_slow_periods)
{
    double k = 5000.0;
    const double trace = 1.0 + 2.0 * k, slow2 = 0.5 * (trace - sqrt(trace * trace - 4.0 * k)), slow = sqrt(slow2);
    const double fast = sqrt(trace - slow2), h = 0.9 * 2.62 / fast, ends[2] = {1.0 - slow2 / k, 1.0};
    double y[4] = {ends[0], ends[1], 0.0, 0.0};
    const mus_integrate_def def = motion_def(MUS_METHOD_RK4, h, two_masses, &k);
    const int64_t steps = (int64_t)(1e5 * 2.0 * PI / (slow * h));
    motion_run(&def, 4, y, steps);
    /* the slow mode changes by RK4's own error only: R = exp(i z) (1 - z^6/144 - i z^5/120 ...) in each step */
    const double z = slow * h, size = pow(1.0 - pow(z, 6.0) / 72.0 + pow(z, 8.0) / 576.0, 0.5 * (double)steps);
    const double turn = (double)steps * atan2(z - z * z * z / 6.0, 1.0 - z * z / 2.0 + pow(z, 4.0) / 24.0);
    ck_assert_double_eq_tol(y[1], size * cos(turn), 1e-6);
    ck_assert_double_eq_tol(y[3], -slow * size * sin(turn), 1e-6);
    ck_assert_double_eq_tol(y[0] / y[1], ends[0], 1e-6);
}
END_TEST


/* ---- Prothero-Robinson ---- */

/* y' = lambda (y - sin t) + cos t; answer sin t */
static void prothero_robinson(void *user, double t, const double *y, double *dy)
{
    dy[0] = *(const double *)user * (y[0] - sin(t)) + cos(t);
}


static double distance_from_sine(void *user, double t, const double *y)
{
    (void)user;
    return fabs(y[0] - sin(t));
}


/* error after about one second in steps of z / |lambda| */
static double sine_error(double lambda, double z)
{
    double y = 0.0, h = z / -lambda;
    const int64_t steps = llround(1.0 / h);
    const mus_integrate_def def = motion_def(MUS_METHOD_RK4, h, prothero_robinson, &lambda);
    motion_run(&def, 1, &y, steps);
    return fabs(y - sin((double)steps * h));
}


START_TEST(a_stiff_decay_is_followed_below_the_limit)
{
    for (double lambda = -1e2; lambda >= -1e6; lambda *= 10.0)
        ck_assert_double_le(sine_error(lambda, 2.5), 5.0 / (lambda * lambda));
    /* order 4 where steps are short against 1/lambda; with z held the order is that of the stages: 2 */
    ck_assert_double_eq_tol(log2(sine_error(-1.0, 0.02) / sine_error(-1.0, 0.01)), 4.0, 0.1);
    ck_assert_double_eq_tol(log10(sine_error(-1e3, 2.0) / sine_error(-1e4, 2.0)), 2.0, 0.1);
}
END_TEST


START_TEST(a_stiff_decay_above_the_limit_is_seen)
{
    mus_context *context = support_context();
    for (double lambda = -1.0; lambda >= -1e6; lambda *= 10.0) {
        double y = 1e-3, work[4];
        int64_t done = -1;
        mus_integrate_def def = motion_def(MUS_METHOD_RK4, 1.05 * 2.785 / -lambda, prothero_robinson, &lambda);
        def.energy = distance_from_sine;
        def.energy_floor = 1.0;
        ck_assert_int_eq(mus_integrate(context, &def, 1, &y, 1000, work, &done), MUS_ERR_DIVERGED);
        ck_assert_double_le(distance_from_sine(NULL, (double)done * def.step, &y), 1.5);
    }
    support_context_end(context);
}
END_TEST


/* ---- the beam ---- */

#define BEAM 40

/* right side of the beam: C v + D u, where C u = D v + theta'^2 */
static void beam(void *user, double t, const double *y, double *dy)
{
    const double *angle = y, *turn = y + BEAM, n2 = BEAM * BEAM, n4 = n2 * n2;
    const double force = t <= PI ? 1.5 * sin(t) * sin(t) : 0.0;
    double s[BEAM + 1] = {0}, c[BEAM + 1] = {0}, v[BEAM], w[BEAM], diagonal[BEAM];
    (void)user;
    for (int i = 1; i < BEAM; i++) s[i] = sin(angle[i] - angle[i - 1]), c[i] = cos(angle[i] - angle[i - 1]);
    for (int i = 0; i < BEAM; i++) {
        const double before = i > 0 ? angle[i - 1] : -angle[0], after = i + 1 < BEAM ? angle[i + 1] : angle[i];
        v[i] = n4 * (before - 2.0 * angle[i] + after) + n2 * force * (cos(angle[i]) + sin(angle[i]));
    }
    for (int i = 0; i < BEAM; i++) {
        w[i] = turn[i] * turn[i] - (i > 0 ? s[i] * v[i - 1] : 0.0) + (i + 1 < BEAM ? s[i + 1] * v[i + 1] : 0.0);
        diagonal[i] = i == 0 ? 1.0 : i + 1 < BEAM ? 2.0 : 3.0;
    }
    /* C is tridiagonal: -c beside the diagonal */
    for (int i = BEAM - 2; i >= 0; i--) {
        const double q = -c[i + 1] / diagonal[i + 1];
        w[i] -= q * w[i + 1];
        diagonal[i] += q * c[i + 1];
    }
    w[0] /= diagonal[0];
    for (int i = 1; i < BEAM; i++) w[i] = (w[i] + c[i] * w[i - 1]) / diagonal[i];
    for (int i = 0; i < BEAM; i++) {
        const double own = i == 0 ? 1.0 : i + 1 < BEAM ? 2.0 : 3.0;
        dy[i] = turn[i];
        dy[BEAM + i] = own * v[i] - (i > 0 ? c[i] * v[i - 1] + s[i] * w[i - 1] : 0.0) +
                       (i + 1 < BEAM ? s[i + 1] * w[i + 1] - c[i + 1] * v[i + 1] : 0.0);
    }
}


START_TEST(the_beam_of_the_test_set_below_its_limit)
{
    const int index[] = {0, 9, 19, 39, 40};
    const double exact[] = {-0.5792366591285007e-2, -0.9119134654647947e-1, -0.1483595472463012, -0.1767201761075488,
                            0.3747362681329794e-1};
    double y[2 * BEAM] = {0.0};
    /* fastest angular frequency 4 n^2 = 6400: stable up to 4.4e-4 s */
    const mus_integrate_def def = motion_def(MUS_METHOD_RK4, 5.0 / 16000, beam, NULL);
    motion_run(&def, 2 * BEAM, y, 16000);
    for (int i = 0; i < 5; i++) ck_assert_double_eq_tol(y[index[i]], exact[i], i < 4 ? 2e-8 : 1e-6);
}
END_TEST


START_TEST(the_beam_above_its_limit_is_seen)
{
    mus_context *context = support_context();
    double y[2 * BEAM] = {0.0}, work[8 * BEAM];
    int64_t done = -1;
    const mus_integrate_def def = motion_def(MUS_METHOD_RK4, 5.0 / 10000, beam, NULL);
    ck_assert_int_eq(mus_integrate(context, &def, 2 * BEAM, y, 10000, work, &done), MUS_ERR_DIVERGED);
    for (int i = 0; i < 2 * BEAM; i++) ck_assert(isfinite(y[i]));
    ck_assert_int_lt(done, 10000);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_stiff(void)
{
    Suite *suite = suite_create("stiff");
    TCase *tests = tcase_create("stiff");
    tcase_set_timeout(tests, 60);
    tcase_add_test(tests, damped_springs_are_stable_up_to_the_known_step);
    tcase_add_test(tests, a_pendulum_on_a_stiff_spring_keeps_time);
    tcase_add_test(tests, a_stiff_spring_loses_its_fast_motion_and_keeps_the_slow_one);
    if (!SUPPORT_SLOW) tcase_add_test(tests, a_hundred_thousand_slow_periods);
    tcase_add_test(tests, a_stiff_decay_is_followed_below_the_limit);
    tcase_add_test(tests, a_stiff_decay_above_the_limit_is_seen);
    tcase_add_test(tests, the_beam_of_the_test_set_below_its_limit);
    tcase_add_test(tests, the_beam_above_its_limit_is_seen);
    suite_add_tcase(suite, tests);
    return suite;
}
