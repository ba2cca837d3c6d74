/*
 * test_spline.c: the natural and the periodic spline against hand values, straight lines, and their orders.
 */
#include "support.h"

#include <math.h>

#include "geom/spline.h"
#include "geom/vec.h"


static void near(double got, double want, double tolerance)
{
    ck_assert_msg(fabs(got - want) <= tolerance, "%.17g, expected %.17g within %g", got, want, tolerance);
}


START_TEST(three_points_by_hand)
{
    /* one inner knot: 2 (1 + 1) m = 6 (-1 - 1), m = -3; S(1/2) = 1/2 + (1/8 - 1/2) (-3) / 6 = 0.6875 */
    const double x[] = {0, 1, 2}, y[] = {0, 1, 0};
    double m[3], work[6], slope;
    ck_assert(mus__spline_natural(3, x, y, m, work));
    near(m[0], 0.0, 0.0);
    near(m[1], -3.0, 1e-15);
    near(m[2], 0.0, 0.0);
    near(mus__spline_at(3, x, y, m, 0.5, NULL), 0.6875, 1e-15);

    /* the end slope 1 + 1/2 goes on outside */
    near(mus__spline_at(3, x, y, m, -2.0, &slope), -3.0, 1e-15);
    near(slope, 1.5, 1e-15);
    near(mus__spline_at(3, x, y, m, 4.0, &slope), -3.0, 1e-15);
    near(slope, -1.5, 1e-15);
}
END_TEST


START_TEST(straight_lines_are_reproduced)
{
    uint64_t state = 1;
    for (int32_t n = 2; n < 30; n++) {
        double x[30], y[30], m[30], work[60], slope;
        x[0] = support_uniform(&state, -1, 1);
        for (int32_t i = 1; i < n; i++) x[i] = x[i - 1] + support_uniform(&state, 0.01, 1.0);
        for (int32_t i = 0; i < n; i++) y[i] = 3.0 - 2.0 * x[i];
        ck_assert(mus__spline_natural(n, x, y, m, work));
        for (int k = 0; k < 20; k++) {
            double t = support_uniform(&state, x[0] - 1.0, x[n - 1] + 1.0);
            near(mus__spline_at(n, x, y, m, t, &slope), 3.0 - 2.0 * t, 1e-12);
            near(slope, -2.0, 1e-11);
        }
    }
}
END_TEST


START_TEST(the_spline_passes_its_points_and_bends_without_a_jump)
{
    uint64_t state = 2;
    double x[20], y[20], m[20], work[40], left, right;
    x[0] = 0.0;
    for (int i = 1; i < 20; i++) x[i] = x[i - 1] + support_uniform(&state, 0.1, 1.0);
    for (int i = 0; i < 20; i++) y[i] = support_uniform(&state, -1, 1);
    ck_assert(mus__spline_natural(20, x, y, m, work));
    for (int i = 0; i < 20; i++) near(mus__spline_at(20, x, y, m, x[i], NULL), y[i], 1e-14);

    /* slopes and second derivatives from both sides of each inner knot */
    for (int i = 1; i < 19; i++) {
        mus__spline_at(20, x, y, m, nextafter(x[i], 0.0), &left);
        mus__spline_at(20, x, y, m, x[i], &right);
        near(left, right, 1e-12);
        double before, after, h = 1e-4;
        mus__spline_at(20, x, y, m, x[i] - h, &before);
        mus__spline_at(20, x, y, m, x[i] + h, &after);
        near((right - before) / h + (m[i] - m[i - 1]) / (x[i] - x[i - 1]) * 0.5 * h, m[i], 1e-8);
        near((after - right) / h - (m[i + 1] - m[i]) / (x[i + 1] - x[i]) * 0.5 * h, m[i], 1e-8);
    }
}
END_TEST


/* largest error against sin over one period, n intervals */
static double sine_error(int32_t n, bool periodic)
{
    double x[130], y[130], m[130], work[520], most = 0.0;
    for (int32_t i = 0; i <= n; i++) x[i] = 2.0 * MUS_PI * i / n, y[i] = sin(x[i] + (periodic ? 0.3 : 0.0));
    if (periodic) {
        ck_assert(mus__spline_periodic(n, x, x[n] - x[n - 1], y, m, work));
        m[n] = m[0];
    } else {
        ck_assert(mus__spline_natural(n + 1, x, y, m, work));
    }
    for (int k = 0; k < 1000; k++) {
        double t = 2.0 * MUS_PI * k / 1000.0;
        most = fmax(most, fabs(mus__spline_at(n + 1, x, y, m, t, NULL) - sin(t + (periodic ? 0.3 : 0.0))));
    }
    return most;
}


START_TEST(the_order_is_four)
{
    /* a natural spline where the second derivative ends at 0, a periodic one everywhere */
    for (int k = 0; k < 2; k++) {
        double order = log2(sine_error(32, k == 1) / sine_error(64, k == 1));
        near(order, 4.0, 0.1);
    }
}
END_TEST


START_TEST(a_periodic_spline_solves_its_cycle)
{
    uint64_t state = 3;
    for (int32_t n = 3; n < 20; n++) {
        double x[20], y[20], m[20], work[80], last = support_uniform(&state, 0.1, 1.0);
        x[0] = 0.0;
        for (int32_t i = 1; i < n; i++) x[i] = x[i - 1] + support_uniform(&state, 0.1, 1.0);
        for (int32_t i = 0; i < n; i++) y[i] = support_uniform(&state, -1, 1);
        ck_assert(mus__spline_periodic(n, x, last, y, m, work));
        for (int32_t i = 0; i < n; i++) {
            int32_t b = (i + n - 1) % n, a = (i + 1) % n;
            double h0 = i > 0 ? x[i] - x[b] : last, h1 = i < n - 1 ? x[a] - x[i] : last;
            near(h0 * m[b] + 2.0 * (h0 + h1) * m[i] + h1 * m[a], 6.0 * ((y[a] - y[i]) / h1 - (y[i] - y[b]) / h0),
                 1e-11);
        }
    }
}
END_TEST


START_TEST(heights_that_do_not_ascend_are_refused)
{
    const double equal[] = {0, 1, 1}, down[] = {0, 2, 1}, bad[] = {0, (double)NAN, 2}, good[] = {0, 1, 2},
                 y[] = {0, 1, 0};
    double m[3], work[12];
    ck_assert(!mus__spline_natural(3, equal, y, m, work));
    ck_assert(!mus__spline_natural(3, down, y, m, work));
    ck_assert(!mus__spline_natural(3, bad, y, m, work));
    ck_assert(!mus__spline_natural(1, good, y, m, work));
    ck_assert(!mus__spline_periodic(3, down, 1.0, y, m, work));
    ck_assert(!mus__spline_periodic(3, good, 0.0, y, m, work));
    ck_assert(!mus__spline_periodic(2, good, 1.0, y, m, work));
}
END_TEST


Suite *mus_suite_spline(void);
Suite *mus_suite_spline(void)
{
    Suite *suite = suite_create("spline");
    TCase *tests = tcase_create("spline");
    tcase_add_test(tests, three_points_by_hand);
    tcase_add_test(tests, straight_lines_are_reproduced);
    tcase_add_test(tests, the_spline_passes_its_points_and_bends_without_a_jump);
    tcase_add_test(tests, the_order_is_four);
    tcase_add_test(tests, a_periodic_spline_solves_its_cycle);
    tcase_add_test(tests, heights_that_do_not_ascend_are_refused);
    suite_add_tcase(suite, tests);
    return suite;
}
