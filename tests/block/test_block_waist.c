/*
 * test_block_waist.c: a trued waist: smooth over each closed dart, legs equal, ends and their tangents kept.
 */
#include <math.h>
#include <string.h>

#include "block/block_waist.h"
#include "block/drafts.h"
#include "geom/curve.h"


/* the waist from (0, 0) to the side at x = 0.2 that rises by 1 cm, straight, with n darts of 2 cm by 10 cm */
static mus__waist sample(int32_t n)
{
    const double length = hypot(0.2, 0.01), x = 0.2 / length, y = 0.01 / length;
    mus__waist waist = {.end = {{0.0, 0.0}, {0.2, 0.01}}, .along = {{x, y}, {x, y}}, .ndart = n};
    for (int32_t d = 0; d < n; d++) {
        const double at = 0.2 * (d + 1) / (n + 1);
        const double dart[6] = {x * (at - 0.01), y * (at - 0.01), x * at + 0.1 * y, y * at - 0.1 * x,
                                x * (at + 0.01), y * (at + 0.01)};
        memcpy(waist.dart[d], dart, sizeof dart);
    }
    return waist;
}


/* angle from the direction of the leg, point to mouth, to that of the line at its end, taken along the line */
static double leg_angle(const double *point, const double *mouth, const double *part, double t)
{
    double along[2];
    mus__curve_tangent(MUS__CUBIC, part, t, along);
    const double x = mouth[0] - point[0], y = mouth[1] - point[1];
    return atan2(x * along[1] - y * along[0], x * along[0] + y * along[1]);
}


START_TEST(a_trued_waist_is_smooth_over_closed_darts)
{
    mus__waist waist = sample(_i);
    const mus__waist drawn = waist;
    const double length = mus__waist_true(&waist);
    double sum = 0.0, along[2];
    for (int32_t d = 0; d <= _i; d++) sum += mus__cubic_length(waist.part[d]);
    ck_assert_double_eq_tol(sum, length, 1e-12);
    for (int32_t d = 0; d < _i; d++) {
        const double *dart = waist.dart[d];
        ck_assert_double_eq_tol(hypot(dart[0] - dart[2], dart[1] - dart[3]),
                                hypot(dart[4] - dart[2], dart[5] - dart[3]), 1e-12);
        ck_assert_double_eq_tol(leg_angle(dart + 2, dart, waist.part[d], 1.0),
                                leg_angle(dart + 2, dart + 4, waist.part[d + 1], 0.0), 1e-9);
        /* the mouths rise: the drawn line dips to the closed dart */
        ck_assert_double_gt(hypot(dart[0] - dart[2], dart[1] - dart[3]), hypot(0.1, 0.01) + 1e-3);
        ck_assert_mem_eq(dart + 2, drawn.dart[d] + 2, 2 * sizeof *dart);
    }
    for (int e = 0; e < 2; e++) {
        const double *end = waist.part[e == 0 ? 0 : _i] + 6 * e;
        mus__curve_tangent(MUS__CUBIC, waist.part[e == 0 ? 0 : _i], e, along);
        ck_assert_double_eq_tol(hypot(end[0] - drawn.end[e][0], end[1] - drawn.end[e][1]), 0.0, 1e-12);
        ck_assert_double_eq_tol(along[0] * drawn.along[e][1] - along[1] * drawn.along[e][0], 0.0, 1e-12);
    }
    /* shorter than the corners, longer than the straight way */
    ck_assert_double_lt(length, _i == 0 ? hypot(0.2, 0.01) + 1e-12 : hypot(0.2, 0.01) - 0.02 * _i);
    ck_assert_double_gt(length, 0.97 * (hypot(0.2, 0.01) - 0.02 * _i));
}
END_TEST


START_TEST(a_line_that_misses_a_leg_is_refused)
{
    mus__waist waist = sample(1);
    for (int k = 0; k < 6; k += 2) waist.dart[0][k] += 1.0;
    ck_assert(isnan(mus__waist_true(&waist)));
}
END_TEST


Suite *mus_suite_block_waist(void);
Suite *mus_suite_block_waist(void)
{
    Suite *suite = suite_create("block_waist");
    TCase *tcase = tcase_create("block_waist");
    tcase_add_loop_test(tcase, a_trued_waist_is_smooth_over_closed_darts, 0, MUS__DARTS + 1);
    tcase_add_test(tcase, a_line_that_misses_a_leg_is_refused);
    suite_add_tcase(suite, tcase);
    return suite;
}
