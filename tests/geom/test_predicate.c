/*
 * test_predicate.c: signs against integer arithmetic that cannot round, and signs that may not depend on the order.
 *
 * Points are integers times a power of two, so that the determinants are integers of at most 127 bits.
 */
#include "support.h"

#include <math.h>

#include "geom/predicate.h"

__extension__ typedef __int128 wide;


static int sign(double x)
{
    return (x > 0.0) - (x < 0.0);
}


static int wide_sign(wide x)
{
    return (x > 0) - (x < 0);
}


static int orient_by_integers(const int64_t *a, const int64_t *b, const int64_t *c)
{
    wide left = (wide)(a[0] - c[0]) * (b[1] - c[1]), right = (wide)(a[1] - c[1]) * (b[0] - c[0]);
    return wide_sign(left - right);
}


static int circle_by_integers(const int64_t (*p)[2])
{
    wide sum = 0;
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        wide x = p[i][0] - p[3][0], y = p[i][1] - p[3][1];
        wide jx = p[j][0] - p[3][0], jy = p[j][1] - p[3][1], kx = p[k][0] - p[3][0], ky = p[k][1] - p[3][1];
        sum += (x * x + y * y) * (jx * ky - jy * kx);
    }
    return wide_sign(sum);
}


static int plane_by_integers(const int64_t (*p)[3])
{
    wide sum = 0;
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        wide jx = p[j][0] - p[3][0], jy = p[j][1] - p[3][1], kx = p[k][0] - p[3][0], ky = p[k][1] - p[3][1];
        sum += (p[i][2] - p[3][2]) * (jx * ky - jy * kx);
    }
    return wide_sign(sum);
}


START_TEST(the_plane_has_the_sign_of_integers)
{
    /* four points of one far plane, then one unit beside it */
    uint64_t state = 4;
    int zeros = 0;
    for (int i = 0; i < 20000; i++) {
        int64_t u[3], v[3], p[4][3];
        for (int k = 0; k < 3; k++) {
            u[k] = (int64_t)(support_random(&state) % 100000);
            v[k] = (int64_t)(support_random(&state) % 100000) - 50000;
        }
        for (int c = 0; c < 4; c++) {
            int64_t s = (int64_t)(support_random(&state) % 1000000), t = (int64_t)(support_random(&state) % 1000000);
            for (int k = 0; k < 3; k++) p[c][k] = 7 + s * u[k] + t * v[k];
        }
        p[i % 4][i % 3] += (int64_t)(support_random(&state) % 3) - 1;
        double x[4][3];
        for (int k = 0; k < 12; k++) x[k / 3][k % 3] = ldexp((double)p[k / 3][k % 3], -37);
        int want = plane_by_integers((const int64_t(*)[3])p);
        zeros += want == 0;
        ck_assert_int_eq(sign(mus__orient3d(x[0], x[1], x[2], x[3])), want);
    }
    ck_assert_int_gt(zeros, 1000);
}
END_TEST


START_TEST(orientation_has_the_sign_of_integers)
{
    /* collinear points of a far line, then one unit beside it: differences of 2^52 that no double product holds */
    uint64_t state = 1;
    int zeros = 0;
    for (int i = 0; i < 20000; i++) {
        int64_t ux = (int64_t)(support_random(&state) % 1000000) + 1,
                uy = (int64_t)(support_random(&state) % 1000000) + 1;
        int64_t s = (int64_t)(support_random(&state) % 1000000000), t = (int64_t)(support_random(&state) % 1000000000);
        int64_t p[3][2] = {{0, 0}, {s * ux, s * uy}, {t * ux, t * uy}};
        p[2][i % 2] += (int64_t)(support_random(&state) % 3) - 1;
        double x[3][2];
        for (int k = 0; k < 6; k++) x[k / 2][k % 2] = ldexp((double)p[k / 2][k % 2], -40);
        int want = orient_by_integers(p[0], p[1], p[2]);
        zeros += want == 0;
        ck_assert_int_eq(sign(mus__orient2d(x[0], x[1], x[2])), want);
    }
    ck_assert_int_gt(zeros, 1000);
}
END_TEST


START_TEST(the_circle_has_the_sign_of_integers)
{
    /* four points of one circle about a far centre (5, 12, 13 and 3, 4, 5 triangles), and one unit beside it */
    static const int64_t on[8][2] = {{65, 0}, {39, 52}, {52, 39}, {25, 60}, {-33, 56}, {-65, 0}, {-16, -63}, {63, -16}};
    uint64_t state = 2;
    int zeros = 0;
    for (int i = 0; i < 20000; i++) {
        int64_t scale = (int64_t)(support_random(&state) % 1000000) + 1, p[4][2];
        int64_t far[2] = {(int64_t)(support_random(&state) % 1000000000),
                          (int64_t)(support_random(&state) % 1000000000)};
        int first = (int)(support_random(&state) % 8);
        for (int k = 0; k < 8; k++) p[k / 2][k % 2] = far[k % 2] + scale * on[(first + k / 2 * 3) % 8][k % 2];
        p[3][i % 2] += (int64_t)(support_random(&state) % 3) - 1;
        double x[4][2];
        for (int k = 0; k < 8; k++) x[k / 2][k % 2] = ldexp((double)p[k / 2][k % 2], -30);
        int want = circle_by_integers((const int64_t(*)[2])p);
        zeros += want == 0;
        ck_assert_int_eq(sign(mus__incircle(x[0], x[1], x[2], x[3])), want);
    }
    ck_assert_int_gt(zeros, 1000);
}
END_TEST


START_TEST(signs_do_not_depend_on_the_order)
{
    /* points that a few last bits part, far from the origin: differences that are not exact */
    uint64_t state = 3;
    for (int i = 0; i < 5000; i++) {
        double p[4][2], angle = support_uniform(&state, 0.0, 6.28);
        for (int k = 0; k < 4; k++) {
            double turn = angle + 1.5 * k, size = i % 2 ? 1.0 : 1e-3 * (k + 1);
            p[k][0] = (k == 0 ? 1e-9 : 0.7) + size * cos(turn);
            p[k][1] = (k == 1 ? 1e-12 : 0.3) + size * sin(turn);
        }
        if (i % 3 == 0)
            for (int k = 0; k < 2; k++) p[2][k] = 0.5 * (p[0][k] + p[1][k]);
        int turn = sign(mus__orient2d(p[0], p[1], p[2]));
        ck_assert_int_eq(sign(mus__orient2d(p[1], p[2], p[0])), turn);
        ck_assert_int_eq(sign(mus__orient2d(p[1], p[0], p[2])), -turn);

        int inside = sign(mus__incircle(p[0], p[1], p[2], p[3]));
        ck_assert_int_eq(sign(mus__incircle(p[1], p[2], p[0], p[3])), inside);
        ck_assert_int_eq(sign(mus__incircle(p[1], p[0], p[2], p[3])), -inside);
        ck_assert_int_eq(sign(mus__incircle(p[0], p[1], p[3], p[2])), -inside);
        ck_assert_int_eq(sign(mus__incircle(p[2], p[3], p[0], p[1])), inside);
    }
}
END_TEST


START_TEST(corners_of_a_rectangle_lie_on_one_circle)
{
    uint64_t state = 4;
    for (int i = 0; i < 5000; i++) {
        double x0 = support_uniform(&state, -1, 1), x1 = x0 + support_uniform(&state, 0, 1);
        double y0 = support_uniform(&state, -1, 1), y1 = y0 + support_uniform(&state, 0, 1);
        const double p[4][2] = {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
        ck_assert(mus__incircle(p[0], p[1], p[2], p[3]) == 0.0);
    }
}
END_TEST


Suite *mus_suite_predicate(void);
Suite *mus_suite_predicate(void)
{
    Suite *suite = suite_create("predicate");
    TCase *tests = tcase_create("predicate");
    tcase_add_test(tests, orientation_has_the_sign_of_integers);
    tcase_add_test(tests, the_circle_has_the_sign_of_integers);
    tcase_add_test(tests, the_plane_has_the_sign_of_integers);
    tcase_add_test(tests, signs_do_not_depend_on_the_order);
    tcase_add_test(tests, corners_of_a_rectangle_lie_on_one_circle);
    suite_add_tcase(suite, tests);
    return suite;
}
