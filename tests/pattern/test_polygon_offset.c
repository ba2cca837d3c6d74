/*
 * test_polygon_offset.c: the cut line: exact answers on polygons that a hand can offset, laws on random stars.
 */
#include <math.h>
#include <string.h>

#include "pattern/polygon_offset.h"
#include "support.h"

#define STARS 60
#define STAR_POINTS 40

static mus_context *context;
static mus__cut_loops loops;


static void setup(void)
{
    context = support_context();
}


static void teardown(void)
{
    mus__cut_loops_free(context, &loops);
    support_context_end(context);
}


static void offset(int32_t n, const double *xy, const double *width, const unsigned char *given)
{
    mus__cut_loops_free(context, &loops);
    ck_assert_int_eq(mus__offset(context, n, xy, width, given, &loops), MUS_OK);
    ck_assert_int_ge(loops.nloop, 1);
    ck_assert_int_eq(loops.start[loops.nloop], loops.n);
}


static double area_of(int32_t n, const double *xy)
{
    double area = 0.0;
    for (int32_t i = 0; i < n; i++) {
        const double *a = xy + 2 * i, *b = xy + 2 * ((i + 1) % n);
        area += 0.5 * (a[0] * b[1] - a[1] * b[0]);
    }
    return area;
}


static double perimeter_of(int32_t n, const double *xy)
{
    double length = 0.0;
    for (int32_t i = 0; i < n; i++) {
        const double *a = xy + 2 * i, *b = xy + 2 * ((i + 1) % n);
        length += hypot(b[0] - a[0], b[1] - a[1]);
    }
    return length;
}


static double segment_distance(const double *p, const double *a, const double *b)
{
    double dx = b[0] - a[0], dy = b[1] - a[1], t = ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / (dx * dx + dy * dy);
    t = t < 0.0 ? 0.0 : t > 1.0 ? 1.0 : t;
    return hypot(p[0] - a[0] - t * dx, p[1] - a[1] - t * dy);
}


static double distance(int32_t n, const double *xy, const double *p)
{
    double best = HUGE_VAL;
    for (int32_t i = 0; i < n; i++) best = fmin(best, segment_distance(p, xy + 2 * i, xy + 2 * ((i + 1) % n)));
    return best;
}


static bool inside(int32_t n, const double *xy, const double *p)
{
    bool in = false;
    for (int32_t i = 0; i < n; i++) {
        const double *a = xy + 2 * i, *b = xy + 2 * ((i + 1) % n);
        if ((a[1] > p[1]) != (b[1] > p[1]) && p[0] < a[0] + (b[0] - a[0]) * (p[1] - a[1]) / (b[1] - a[1])) in = !in;
    }
    return in;
}


/* sides that cross each other, by brute force */
static int32_t crossings(int32_t n, const double *xy)
{
    int32_t count = 0;
    for (int32_t i = 0; i < n; i++) {
        for (int32_t j = i + 2; j < n; j++) {
            const double *p = xy + 2 * i, *q = xy + 2 * (i + 1), *r = xy + 2 * j, *s = xy + 2 * ((j + 1) % n);
            if ((j + 1) % n == i) continue;
            double a = (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
            double b = (q[0] - p[0]) * (s[1] - p[1]) - (q[1] - p[1]) * (s[0] - p[0]);
            double c = (s[0] - r[0]) * (p[1] - r[1]) - (s[1] - r[1]) * (p[0] - r[0]);
            double d = (s[0] - r[0]) * (q[1] - r[1]) - (s[1] - r[1]) * (q[0] - r[0]);
            if (a * b < 0.0 && c * d < 0.0) count++;
        }
    }
    return count;
}


/* points at growing angles and random distances: simple, counter-clockwise, with deep and shallow corners */
static void star(uint64_t *seed, int32_t n, double *xy)
{
    for (int32_t i = 0; i < n; i++) {
        double angle = 2.0 * 3.14159265358979323846 * (i + support_uniform(seed, 0.0, 0.9)) / n;
        double r = support_uniform(seed, 0.1, 0.4);
        xy[2 * i] = r * cos(angle);
        xy[2 * i + 1] = r * sin(angle);
    }
}


/* the least distance of the outer cut line from the seam line, at its corners and between them */
static double least_distance(int32_t n, const double *xy)
{
    double least = HUGE_VAL;
    int32_t m = loops.start[1];
    for (int32_t i = 0; i < m; i++) {
        const double *a = loops.xy + 2 * i, *b = loops.xy + 2 * ((i + 1) % m);
        for (int32_t k = 0; k < 4; k++) {
            const double p[2] = {a[0] + 0.25 * k * (b[0] - a[0]), a[1] + 0.25 * k * (b[1] - a[1])};
            least = fmin(least, distance(n, xy, p));
        }
    }
    return least;
}


START_TEST(no_allowance_is_the_seam_line_to_the_bit)
{
    uint64_t seed = 1;
    double xy[2 * STAR_POINTS];
    const double width[STAR_POINTS] = {0};
    star(&seed, STAR_POINTS, xy);
    offset(STAR_POINTS, xy, width, NULL);
    ck_assert_int_eq(loops.nloop, 1);
    ck_assert_int_eq(loops.n, STAR_POINTS);
    ck_assert_int_eq(memcmp(loops.xy, xy, sizeof xy), 0);
}
END_TEST


START_TEST(a_star_keeps_its_distance_and_its_cut_line_is_simple)
{
    uint64_t seed = 2;
    for (int32_t k = 0; k < STARS; k++) {
        double xy[2 * STAR_POINTS], width[STAR_POINTS], w = support_uniform(&seed, 0.001, 0.06);
        star(&seed, STAR_POINTS, xy);
        for (int32_t i = 0; i < STAR_POINTS; i++) width[i] = w;
        offset(STAR_POINTS, xy, width, NULL);
        ck_assert_double_ge(least_distance(STAR_POINTS, xy), w - 1e-6);
        ck_assert_int_eq(crossings(loops.start[1], loops.xy), 0);
        ck_assert_double_gt(area_of(loops.start[1], loops.xy), area_of(STAR_POINTS, xy));
        for (int32_t i = 0; i < STAR_POINTS; i++) ck_assert(inside(loops.start[1], loops.xy, xy + 2 * i));
    }
}
END_TEST


START_TEST(sides_of_their_own_width_keep_the_least_of_them)
{
    uint64_t seed = 3;
    for (int32_t k = 0; k < STARS; k++) {
        double xy[2 * STAR_POINTS], width[STAR_POINTS];
        star(&seed, STAR_POINTS, xy);
        for (int32_t i = 0; i < STAR_POINTS; i++) width[i] = support_uniform(&seed, 0.005, 0.04);
        offset(STAR_POINTS, xy, width, NULL);
        ck_assert_double_ge(least_distance(STAR_POINTS, xy), 0.005 - 1e-6);
        ck_assert_int_eq(crossings(loops.start[1], loops.xy), 0);

        /* the strip beside each side is cloth: a point just inside its width is within the cut line */
        for (int32_t i = 0; i < STAR_POINTS; i++) {
            const double *a = xy + 2 * i, *b = xy + 2 * ((i + 1) % STAR_POINTS);
            double dx = b[0] - a[0], dy = b[1] - a[1], d = hypot(dx, dy), s = support_uniform(&seed, 0.05, 0.95);
            double w = width[i] - 1e-6;
            const double p[2] = {a[0] + s * dx + w * dy / d, a[1] + s * dy - w * dx / d};
            ck_assert(inside(loops.start[1], loops.xy, p));
        }
    }
}
END_TEST


START_TEST(area_grows_by_width_times_length_and_a_square_term)
{
    /* regular polygon: A(w) = A + w L + w^2 sum tan(turn / 2), exactly */
    double xy[2 * 12], width[12];
    for (int32_t i = 0; i < 12; i++) {
        xy[2 * i] = 0.3 * cos(3.14159265358979323846 * i / 6.0);
        xy[2 * i + 1] = 0.3 * sin(3.14159265358979323846 * i / 6.0);
    }
    for (int32_t k = 1; k <= 8; k++) {
        double w = 0.005 * k;
        for (int32_t i = 0; i < 12; i++) width[i] = w;
        offset(12, xy, width, NULL);
        double exact = area_of(12, xy) + w * perimeter_of(12, xy) + w * w * 12.0 * tan(3.14159265358979323846 / 12.0);
        ck_assert_double_eq_tol(area_of(loops.n, loops.xy), exact, 1e-7);
    }

    /* each side its own width, on a star: what is left beyond A + sum w l falls with the square of w. Inner corners
     * overlap and outer ones add, so the sign is free */
    uint64_t seed = 4;
    for (int32_t k = 0; k < 20; k++) {
        double s[2 * 9], w[9], sum = 0.0, left[2];
        star(&seed, 9, s);
        for (int32_t i = 0; i < 9; i++) w[i] = support_uniform(&seed, 2e-4, 4e-4);
        for (int32_t half = 0; half < 2; half++) {
            sum = 0.0;
            for (int32_t i = 0; i < 9; i++) {
                const double *a = s + 2 * i, *b = s + 2 * ((i + 1) % 9);
                if (half == 1) w[i] *= 0.5;
                sum += w[i] * hypot(b[0] - a[0], b[1] - a[1]);
            }
            offset(9, s, w, NULL);
            left[half] = area_of(loops.n, loops.xy) - area_of(9, s) - sum;
        }
        ck_assert_double_eq_tol(left[1], 0.25 * left[0], 2e-8 + 0.02 * fabs(left[0]));
    }
}
END_TEST


START_TEST(a_rectangle_has_its_four_mitres)
{
    const double xy[] = {0, 0, 0.4, 0, 0.4, 0.3, 0, 0.3}, width[] = {0.025, 0.01, 0.007, 0.0};
    const double exact[] = {0, -0.025, 0.41, -0.025, 0.41, 0.307, 0, 0.307};
    offset(4, xy, width, NULL);
    ck_assert_int_eq(loops.n, 4);
    for (int32_t i = 0; i < 4; i++) {
        double nearest = HUGE_VAL;
        for (int32_t k = 0; k < 4; k++)
            nearest = fmin(nearest, hypot(loops.xy[2 * k] - exact[2 * i], loops.xy[2 * k + 1] - exact[2 * i + 1]));
        ck_assert_double_lt(nearest, 3e-8);
    }
}
END_TEST


START_TEST(a_sharp_point_is_cut_off_one_width_beyond)
{
    /* a dart-like point of 11 degrees at (0.5, 0): its mitre would stand 10 widths away */
    const double xy[] = {0, -0.05, 0.5, 0, 0, 0.05}, width[] = {0.01, 0.01, 0.01};
    double most = 0.0;
    offset(3, xy, width, NULL);
    for (int32_t i = 0; i < loops.n; i++) most = fmax(most, loops.xy[2 * i]);
    ck_assert_double_eq_tol(most, 0.51, 1e-6);
    ck_assert_double_ge(least_distance(3, xy), 0.01 - 1e-6);
}
END_TEST


START_TEST(a_slot_narrower_than_its_allowances_closes)
{
    /* a slot 15 mm wide, 200 deep, from above; at exactly 20 mm its two cut lines are one */
    for (int32_t k = 0; k < 2; k++) {
        double half = k == 0 ? 0.0075 : 0.01, left = 0.15 - half, right = 0.15 + half;
        const double xy[] = {0, 0, 0.3, 0, 0.3, 0.3, right, 0.3, right, 0.1, left, 0.1, left, 0.3, 0, 0.3};
        double width[8], highest = 0.0;
        for (int32_t i = 0; i < 8; i++) width[i] = 0.01;
        offset(8, xy, width, NULL);
        for (int32_t i = 0; i < loops.n; i++) highest = fmax(highest, loops.xy[2 * i + 1]);
        ck_assert_double_eq_tol(highest, 0.31, 1e-6);
        if (k == 0) ck_assert_double_eq_tol(area_of(loops.n, loops.xy), 0.32 * 0.32, 1e-6);
        else ck_assert_double_eq_tol(area_of(loops.start[1], loops.xy), 0.32 * 0.32, 1e-6);
    }
}
END_TEST


START_TEST(a_closed_mouth_leaves_a_hole)
{
    /* a ring, open by 10 mm on its right: the allowances close the gap, the middle stays a hole that runs clockwise */
    double xy[2 * 82], width[82];
    for (int32_t i = 0; i < 41; i++) {
        double angle = 0.035 + (2.0 * 3.14159265358979323846 - 0.07) * i / 40.0;
        xy[2 * i] = 0.4 * cos(angle);
        xy[2 * i + 1] = 0.4 * sin(angle);
        xy[2 * (81 - i)] = 0.15 * cos(angle);
        xy[2 * (81 - i) + 1] = 0.15 * sin(angle);
    }
    for (int32_t i = 0; i < 82; i++) width[i] = 0.015;
    offset(82, xy, width, NULL);
    ck_assert_int_eq(loops.nloop, 2);
    int32_t outer = loops.start[1];
    ck_assert_double_gt(area_of(outer, loops.xy), 0.0);
    double hole = area_of(loops.n - outer, loops.xy + 2 * outer);
    ck_assert_double_lt(hole, 0.0);
    ck_assert_double_eq_tol(hole, -3.14159265358979323846 * 0.135 * 0.135, 1e-3);
}
END_TEST


START_TEST(each_failing_allocation_is_reported)
{
    uint64_t seed = 5;
    double xy[2 * STAR_POINTS], width[STAR_POINTS];
    star(&seed, STAR_POINTS, xy);
    for (int32_t i = 0; i < STAR_POINTS; i++) width[i] = 0.02;
    int64_t n = 0;
    for (;; n++) {
        mus__cut_loops out;
        support_fail_after(n, false);
        mus_status status = mus__offset(context, STAR_POINTS, xy, width, NULL, &out);
        support_fail_never();
        if (status == MUS_OK) {
            mus__cut_loops_free(context, &out);
            break;
        }
        ck_assert_int_eq(status, MUS_ERR_MEMORY);
        ck_assert_ptr_null(out.xy);
        ck_assert_uint_eq(mus_context_bytes(context), 0);
    }
    ck_assert_int_gt(n, 5);
}
END_TEST


Suite *mus_suite_polygon_offset(void);
Suite *mus_suite_polygon_offset(void)
{
    Suite *suite = suite_create("polygon_offset");
    TCase *test = tcase_create("offset");
    tcase_add_checked_fixture(test, setup, teardown);
    tcase_add_test(test, no_allowance_is_the_seam_line_to_the_bit);
    tcase_add_test(test, a_star_keeps_its_distance_and_its_cut_line_is_simple);
    tcase_add_test(test, sides_of_their_own_width_keep_the_least_of_them);
    tcase_add_test(test, area_grows_by_width_times_length_and_a_square_term);
    tcase_add_test(test, a_rectangle_has_its_four_mitres);
    tcase_add_test(test, a_sharp_point_is_cut_off_one_width_beyond);
    tcase_add_test(test, a_slot_narrower_than_its_allowances_closes);
    tcase_add_test(test, a_closed_mouth_leaves_a_hole);
    tcase_add_test(test, each_failing_allocation_is_reported);
    suite_add_tcase(suite, test);
    return suite;
}
