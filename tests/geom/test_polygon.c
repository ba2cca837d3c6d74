/*
 * test_polygon.c: polygons by hand, and random ones against slow plain references.
 */
#include "support.h"

#include <math.h>

#include "geom/polygon.h"
#include "geom/predicate.h"
#include "geom/vec.h"


static void near(double got, double want, double tolerance)
{
    ck_assert_msg(fabs(got - want) <= tolerance, "%.17g, expected %.17g within %g", got, want, tolerance);
}


/* an L of area 3, perimeter 8 */
static const double ell[] = {0, 0, 2, 0, 2, 1, 1, 1, 1, 2, 0, 2};


START_TEST(an_ell_by_hand)
{
    int32_t a[6], b[6], i, j;
    near(mus__polygon_area(6, ell), 3.0, 0.0);
    near(mus__polygon_perimeter(6, ell), 8.0, 0.0);
    ck_assert_int_eq(mus__polygon_winding(6, ell, (const double[]){0.5, 1.5}), 1);
    ck_assert_int_eq(mus__polygon_winding(6, ell, (const double[]){1.5, 1.5}), 0);
    near(mus__polygon_distance(6, ell, (const double[]){1.5, 1.5}), 0.5, 0.0);
    near(mus__polygon_distance(6, ell, (const double[]){-3.0, -4.0}), 5.0, 0.0);
    ck_assert_int_eq(mus__polygon_hull(6, ell, a, b), 5);

    /* a tape goes over the inner corner */
    near(mus__polygon_tape(6, ell, a, b), 6.0 + sqrt(2.0), 1e-15);
    ck_assert(!mus__polygon_crosses(6, ell, &i, &j, a));
}
END_TEST


START_TEST(a_far_polygon_keeps_its_area)
{
    double far[12];
    for (int k = 0; k < 12; k++) far[k] = ell[k] + 1e6;
    near(mus__polygon_area(6, far), 3.0, 1e-9);
}
END_TEST


START_TEST(winding_is_the_sum_of_angles)
{
    uint64_t state = 1;
    for (int turn = 0; turn < 100; turn++) {
        double xy[40];
        for (int k = 0; k < 40; k++) xy[k] = support_uniform(&state, -1, 1);
        for (int q = 0; q < 20; q++) {
            double p[2] = {support_uniform(&state, -1, 1), support_uniform(&state, -1, 1)}, sum = 0.0;
            for (int i = 0; i < 20; i++) {
                const double *a = xy + 2 * i, *b = xy + 2 * ((i + 1) % 20);
                double ax = a[0] - p[0], ay = a[1] - p[1], bx = b[0] - p[0], by = b[1] - p[1];
                sum += atan2(ax * by - ay * bx, ax * bx + ay * by);
            }
            ck_assert_int_eq(mus__polygon_winding(20, xy, p), (int)lround(sum / (2.0 * MUS_PI)));
        }
    }
}
END_TEST


START_TEST(the_hull_holds_every_point_and_turns_left)
{
    uint64_t state = 2;
    for (int turn = 0; turn < 300; turn++) {
        /* few different coordinates: many equal and collinear points */
        double xy[60];
        int32_t out[30], work[30], n = 3 + turn % 28;
        uint64_t grid = turn % 2 ? 4 : 1000;
        for (int k = 0; k < 2 * n; k++) xy[k] = (double)(support_random(&state) % grid);
        int32_t count = mus__polygon_hull(n, xy, out, work);
        ck_assert_int_le(count, n);
        for (int32_t i = 0; count > 2 && i < count; i++) {
            const double *a = xy + 2 * out[i], *b = xy + 2 * out[(i + 1) % count], *c = xy + 2 * out[(i + 2) % count];
            ck_assert(mus__orient2d(a, b, c) > 0.0);
            for (int32_t k = 0; k < n; k++) ck_assert(mus__orient2d(a, b, xy + 2 * k) >= 0.0);
        }
        for (int32_t k = 0; count == 2 && k < n; k++)
            ck_assert(mus__orient2d(xy + 2 * out[0], xy + 2 * out[1], xy + 2 * k) == 0.0);
    }

    /* all points on the hull, and all in one place */
    double circle[64], same[8] = {1, 2, 1, 2, 1, 2, 1, 2};
    int32_t out[32], work[32];
    for (int k = 0; k < 32; k++) circle[2 * k] = cos(k * 0.19634954), circle[2 * k + 1] = sin(k * 0.19634954);
    ck_assert_int_eq(mus__polygon_hull(32, circle, out, work), 32);
    ck_assert_int_eq(mus__polygon_hull(4, same, out, work), 1);
    ck_assert_int_eq(mus__polygon_hull(0, same, out, work), 0);
    near(mus__polygon_tape(4, same, out, work), 0.0, 0.0);
}
END_TEST


/* sides i and j share a point, by solving for their crossing in integers */
static bool sides_touch(const double *a, const double *b, const double *c, const double *d)
{
    double ux = b[0] - a[0], uy = b[1] - a[1], vx = d[0] - c[0], vy = d[1] - c[1], wx = c[0] - a[0], wy = c[1] - a[1];
    double det = ux * vy - uy * vx;
    if (det != 0.0) {
        double s = wx * vy - wy * vx, t = wx * uy - wy * ux;
        if (det < 0.0) det = -det, s = -s, t = -t;
        return s >= 0.0 && s <= det && t >= 0.0 && t <= det;
    }
    if (ux * wy - uy * wx != 0.0 || vx * wy - vy * wx != 0.0) return false;
    return fmax(fmin(a[0], b[0]), fmin(c[0], d[0])) <= fmin(fmax(a[0], b[0]), fmax(c[0], d[0])) &&
           fmax(fmin(a[1], b[1]), fmin(c[1], d[1])) <= fmin(fmax(a[1], b[1]), fmax(c[1], d[1]));
}


START_TEST(crossings_are_those_of_all_pairs)
{
    uint64_t state = 3;
    int crossed = 0;
    for (int turn = 0; turn < 3000; turn++) {
        double xy[20];
        int32_t n = 4 + turn % 7, work[10], i, j;
        for (int k = 0; k < 2 * n; k++) xy[k] = (double)(support_random(&state) % 12);
        bool want = false;
        for (int32_t a = 0; a < n; a++)
            for (int32_t b = a + 2; b < n; b++)
                if (!(a == 0 && b == n - 1) &&
                    sides_touch(xy + 2 * a, xy + 2 * (a + 1), xy + 2 * b, xy + 2 * ((b + 1) % n)))
                    want = true;
        bool got = mus__polygon_crosses(n, xy, &i, &j, work);
        ck_assert_int_eq(got, want);
        crossed += got;
        if (got) ck_assert(i < j && sides_touch(xy + 2 * i, xy + 2 * (i + 1), xy + 2 * j, xy + 2 * ((j + 1) % n)));
    }
    ck_assert_int_gt(crossed, 300);
    ck_assert_int_lt(crossed, 2900);
}
END_TEST


Suite *mus_suite_polygon(void);
Suite *mus_suite_polygon(void)
{
    Suite *suite = suite_create("polygon");
    TCase *tests = tcase_create("polygon");
    tcase_add_test(tests, an_ell_by_hand);
    tcase_add_test(tests, a_far_polygon_keeps_its_area);
    tcase_add_test(tests, winding_is_the_sum_of_angles);
    tcase_add_test(tests, the_hull_holds_every_point_and_turns_left);
    tcase_add_test(tests, crossings_are_those_of_all_pairs);
    suite_add_tcase(suite, tests);
    return suite;
}
