/*
 * test_curve.c: lengths and areas against closed forms, splits against their whole, arcs from a straight line to a full
 * circle.
 */
#include "support.h"

#include <math.h>
#include <string.h>

#include "geom/curve.h"
#include "geom/vec.h"


static void near(double got, double want, double tolerance)
{
    ck_assert_msg(fabs(got - want) <= tolerance, "%.17g, expected %.17g within %g", got, want, tolerance);
}


/* an arc from start to end of a radius of half the chord or more, which bulges to the right of travel or to its
 * left: the
 * 3 points of the piece. Its sagitta is R - root, written without cancellation, or R + root for the larger arc */
static void arc_from_radius(const double *start, const double *end, double radius, int32_t large, int32_t right,
                            double *out)
{
    double dx = end[0] - start[0], dy = end[1] - start[1], half = 0.5 * hypot(dx, dy);
    if (!(radius > half)) radius = half;

    /* sagitta of the lesser arc R - root, written without cancellation; of the greater R + root */
    double root = sqrt((radius - half) * (radius + half));
    double sagitta = large ? radius + root : radius + root > 0.0 ? half * half / (radius + root) : 0.0;
    double scale = half > 0.0 ? sagitta / (2.0 * half) * (right ? 1.0 : -1.0) : 0.0;
    out[0] = start[0], out[1] = start[1];
    out[2] = 0.5 * (start[0] + end[0]) + scale * dy;
    out[3] = 0.5 * (start[1] + end[1]) - scale * dx;
    out[4] = end[0], out[5] = end[1];
}


/* points of a random piece of a kind; an arc's middle is put on the bisector */
static void random_piece(uint64_t *state, int32_t kind, double *p)
{
    for (int i = 0; i < 8; i++) p[i] = support_uniform(state, -1.0, 1.0);
    if (kind == MUS__ARC)
        arc_from_radius(p, p + 4, support_uniform(state, 0.1, 3.0), support_random(state) % 2,
                             support_random(state) % 2, p);
}


START_TEST(lengths_are_the_closed_forms)
{
    /* a parabola y = x^2 over 0 .. 1: sqrt(5)/2 + asinh(2)/4; a semicubical parabola (t^2, t^3): (13 sqrt(13) - 8)/27
     */
    const double line[] = {1, 1, 4, 5}, parabola[] = {0, 0, 0.5, 0, 1, 1};
    const double cubic[] = {0, 0, 0, 0, 1.0 / 3.0, 0, 1, 1};
    near(mus__curve_length(MUS__LINE, line), 5.0, 0.0);
    near(mus__curve_length(MUS__QUADRATIC, parabola), sqrt(5.0) / 2.0 + asinh(2.0) / 4.0, 1e-14);
    near(mus__curve_length(MUS__CUBIC, cubic), (13.0 * sqrt(13.0) - 8.0) / 27.0, 1e-14);

    /* half, three quarters and the whole of the unit circle */
    const double half[] = {1, 0, 0, 1, -1, 0}, most[] = {1, 0, -sqrt(0.5), sqrt(0.5), 0, -1},
                 whole[] = {1, 0, -1, 0, 1, 0};
    near(mus__curve_length(MUS__ARC, half), MUS_PI, 1e-15);
    near(mus__curve_length(MUS__ARC, most), 1.5 * MUS_PI, 4e-15);
    near(mus__curve_length(MUS__ARC, whole), 2.0 * MUS_PI, 1e-15);
}
END_TEST


START_TEST(a_cusp_and_a_spike_have_their_length)
{
    /* the cubic (0,0) (1,1) (0,1) (1,0) has a cusp at 1/2; a quadratic that runs 4/3 out and 1/3 back on one line */
    const double cusp[] = {0, 0, 1, 1, 0, 1, 1, 0}, spike[] = {0, 0, 2, 0, 1, 0};
    double sum = 0.0, a[2] = {0, 0}, b[2];
    for (int i = 1; i <= 100000; i++) {
        mus__curve_at(MUS__CUBIC, cusp, i / 100000.0, b);
        sum += mus__dist2(a, b);
        memcpy(a, b, sizeof a);
    }
    near(mus__curve_length(MUS__CUBIC, cusp), sum, 1e-9);
    near(mus__curve_length(MUS__QUADRATIC, spike), 4.0 / 3.0 + 1.0 / 3.0, 1e-12);
}
END_TEST


START_TEST(parts_of_a_split_are_the_whole)
{
    uint64_t state = 1;
    for (int i = 0; i < 400; i++) {
        int32_t kind = i % 4, n = mus__curve_points(kind);
        double p[8], left[8], right[8], t = support_uniform(&state, 0.05, 0.95), whole[2], part[2];
        random_piece(&state, kind, p);
        mus__curve_split(kind, p, t, left, right);
        double length = mus__curve_length(kind, p);
        near(mus__curve_length(kind, left) + mus__curve_length(kind, right), length, 2e-13 * length);
        near(mus__curve_length_to(kind, p, t), mus__curve_length(kind, left), 2e-13 * length);
        near(mus__curve_area(kind, left) + mus__curve_area(kind, right), mus__curve_area(kind, p), 1e-13);
        ck_assert_int_eq(memcmp(left, p, 2 * sizeof *p), 0);
        ck_assert_int_eq(memcmp(right + 2 * n - 2, p + 2 * n - 2, 2 * sizeof *p), 0);
        for (double s = 0.0; s <= 1.0; s += 0.125) {
            mus__curve_at(kind, p, t * s, whole);
            mus__curve_at(kind, left, s, part);
            near(mus__dist2(whole, part), 0.0, 1e-13);
        }
    }
}
END_TEST


START_TEST(the_parameter_at_a_length_has_that_length)
{
    uint64_t state = 2;
    for (int i = 0; i < 200; i++) {
        int32_t kind = i % 4;
        double p[8];
        random_piece(&state, kind, p);
        double length = mus__curve_length(kind, p);
        for (int k = 0; k <= 10; k++) {
            double t = mus__curve_param(kind, p, 0.1 * k * length);
            near(mus__curve_length_to(kind, p, t), 0.1 * k * length, 2e-13 * length);
        }
        near(mus__curve_param(kind, p, -1.0), 0.0, 0.0);
        near(mus__curve_param(kind, p, 2.0 * length), 1.0, 0.0);
    }
}
END_TEST


START_TEST(the_tangent_is_the_derivative)
{
    uint64_t state = 3;
    for (int i = 0; i < 200; i++) {
        int32_t kind = i % 4;
        double p[8], t = support_uniform(&state, 0.1, 0.9), before[2], after[2], tangent[2];
        random_piece(&state, kind, p);
        mus__curve_at(kind, p, t - 1e-5, before);
        mus__curve_at(kind, p, t + 1e-5, after);
        mus__curve_tangent(kind, p, t, tangent);
        for (int k = 0; k < 2; k++) near(tangent[k], (after[k] - before[k]) / 2e-5, 1e-6);
    }
}
END_TEST


START_TEST(areas_are_those_of_fine_polygons)
{
    uint64_t state = 4;
    for (int i = 0; i < 40; i++) {
        int32_t kind = i % 4;
        double p[8], a[2], b[2], sum = 0.0;
        random_piece(&state, kind, p);
        mus__curve_at(kind, p, 0.0, a);
        for (int k = 1; k <= 20000; k++) {
            mus__curve_at(kind, p, k / 20000.0, b);
            sum += 0.5 * (a[0] * b[1] - a[1] * b[0]);
            memcpy(a, b, sizeof a);
        }
        near(mus__curve_area(kind, p), sum, 1e-6);
    }
    const double half[] = {1, 0, 0, 1, -1, 0}, back[] = {-1, 0, 0, 1, 1, 0};
    near(mus__curve_area(MUS__ARC, half), 0.5 * MUS_PI, 1e-15);
    near(mus__curve_area(MUS__ARC, back), -0.5 * MUS_PI, 1e-15);
}
END_TEST


START_TEST(an_arc_goes_over_into_its_chord)
{
    /* length = chord (1 + 2/3 (2 s / chord)^2 + ...) as the sagitta s goes to nothing */
    for (double s = 1e-3; s > 1e-19; s *= 1e-3) {
        const double p[6] = {0, 0, 0.5, s, 1, 0};
        double at[2];
        near(mus__curve_length(MUS__ARC, p), 1.0 + 8.0 / 3.0 * s * s, 4.0 * s * s * s * s + 1e-15);
        near(mus__curve_area(MUS__ARC, p), -2.0 / 3.0 * s, 1e-5 * s);
        mus__curve_at(MUS__ARC, p, 0.25, at);
        near(at[0], 0.25, s);
        near(at[1], 0.75 * s, 1e-5 * s);
    }
}
END_TEST


START_TEST(unknown_kinds_have_no_points)
{
    ck_assert_int_eq(mus__curve_points(-1), 0);
    ck_assert_int_eq(mus__curve_points(4), 0);
}
END_TEST


Suite *mus_suite_curve(void);
Suite *mus_suite_curve(void)
{
    Suite *suite = suite_create("curve");
    TCase *tests = tcase_create("curve");
    tcase_add_test(tests, lengths_are_the_closed_forms);
    tcase_add_test(tests, a_cusp_and_a_spike_have_their_length);
    tcase_add_test(tests, parts_of_a_split_are_the_whole);
    tcase_add_test(tests, the_parameter_at_a_length_has_that_length);
    tcase_add_test(tests, the_tangent_is_the_derivative);
    tcase_add_test(tests, areas_are_those_of_fine_polygons);
    tcase_add_test(tests, an_arc_goes_over_into_its_chord);
    tcase_add_test(tests, unknown_kinds_have_no_points);
    suite_add_tcase(suite, tests);
    return suite;
}
