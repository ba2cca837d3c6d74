/*
 * test_contour.c: one contour.
 *
 * Golden numbers: Ramanujan's perimeter inverted (p = 0.9, q = 0.7: a = 0.167212626, b = 0.117048838, computed outside
 * the library), perimeters of superellipses by quadrature, deficit of a polygon pi^2 / 6 N^2.
 */
#include <math.h>

#include "geom/polygon.h"
#include "geom/vec.h"
#include "limb/radius_field.h"
#include "support.h"

#define SAMPLES 512

static double turn[2 * SAMPLES], xy[2 * SAMPLES];
static int32_t work[2 * SAMPLES];


static void set_turns(int32_t n)
{
    for (int32_t k = 0; k < n; k++) {
        turn[2 * k] = cos(2.0 * MUS_PI * k / n);
        turn[2 * k + 1] = sin(2.0 * MUS_PI * k / n);
    }
}


/* girth of the sampled contour as a tape lies: the perimeter of the hull */
static double tape_girth(const mus__contour *contour, int32_t n)
{
    double radius[SAMPLES];
    mus__contour_radii(contour, n, turn, radius);
    for (int32_t k = 0; k < n; k++) xy[2 * k] = radius[k] * turn[2 * k], xy[2 * k + 1] = radius[k] * turn[2 * k + 1];
    return mus__polygon_tape(n, xy, work, work + n);
}


START_TEST(eq_6_gives_the_half_axes_of_a_girth)
{
    double a = mus__contour_half_breadth(0.9, 0.7, 2.0);
    ck_assert_double_eq_tol(a, 0.167212626, 1e-9);
    ck_assert_double_eq_tol(0.7 * a, 0.117048838, 1e-9);
    ck_assert_double_eq_tol(mus__contour_half_breadth(2.0 * MUS_PI, 1.0, 2.0), 1.0, 1e-15);

    /* the perimeter of these half axes by Ramanujan's formula */
    double b = 0.7 * a;
    ck_assert_double_eq_tol(MUS_PI * (3.0 * (a + b) - sqrt((a + 3.0 * b) * (3.0 * a + b))), 0.9, 1e-14);
}
END_TEST


START_TEST(perimeters_are_those_of_the_quadrature)
{
    static const struct {
        double ratio, n, perimeter;
    } row[] = {{0.6, 2, 5.1054}, {0.6, 2.25, 5.2093}, {0.6, 2.5, 5.2999}, {0.6, 3, 5.4478},
               {0.7, 2, 5.3824}, {0.7, 2.25, 5.4976}, {0.7, 2.5, 5.5977}, {0.7, 3, 5.7605},
               {0.8, 2, 5.6723}, {0.8, 2.25, 5.7975}, {0.8, 2.5, 5.9059}, {0.8, 3, 6.0819},
               {1, 2, 6.2832},   {1, 2.25, 6.4245},   {1, 2.5, 6.5467},   {1, 3, 6.7450}};
    set_turns(SAMPLES);
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        mus__contour contour = {.a = 1.0, .b = row[i].ratio, .n = row[i].n};
        double got = tape_girth(&contour, SAMPLES);
        ck_assert_msg(fabs(got - row[i].perimeter) < 1.5e-4, "%g %g: %g", row[i].ratio, row[i].n, got);
        double guess = mus__contour_half_breadth(row[i].perimeter, row[i].ratio, row[i].n);
        ck_assert_msg(fabs(guess - 1.0) < 0.01, "%g %g: %g", row[i].ratio, row[i].n, guess);
    }
}
END_TEST


START_TEST(the_fitted_polygon_has_the_girth_not_the_curve)
{
    for (int32_t n = 16; n <= SAMPLES; n *= 2) {
        set_turns(n);
        mus__contour contour = {.a = 0.15, .b = 0.15, .n = 2.0};
        mus__contour_fit(&contour, 0.9, n, turn, xy, work);
        ck_assert_double_eq_tol(tape_girth(&contour, n), 0.9, 1e-12);

        /* the circle through the corners is longer by pi^2 / 6 n^2 */
        double more = 2.0 * MUS_PI * contour.a / 0.9 - 1.0, deficit = MUS_PI * MUS_PI / (6.0 * n * n);
        ck_assert_double_eq_tol(more / deficit, 1.0, 0.02);
    }
}
END_TEST


START_TEST(bumps_lie_where_they_are_told_and_the_tape_spans_between)
{
    set_turns(SAMPLES);
    mus__contour contour = {.a = 0.15, .b = 0.11, .n = 2.3, .bump = {0.03, 0.0}, .bump_angle = {0.65, 0.0}};
    mus__contour_fit(&contour, 0.92, SAMPLES, turn, xy, work);
    ck_assert_double_eq_tol(tape_girth(&contour, SAMPLES), 0.92, 1e-12);

    /* both sides alike; the front (-b) is further out than the back; the hull is shorter than the outline */
    double perimeter = 0.0;
    for (int32_t k = 0; k < SAMPLES; k++) {
        perimeter += mus__dist2(xy + 2 * k, xy + 2 * ((k + 1) % SAMPLES));
        double left = mus__contour_radius(&contour, turn[2 * k], turn[2 * k + 1]);
        ck_assert_double_eq_tol(mus__contour_radius(&contour, -turn[2 * k], turn[2 * k + 1]), left, 1e-14);
    }
    ck_assert_double_gt(perimeter, 0.9201);
    double c = cos(-0.5 * MUS_PI + 0.65), s = sin(-0.5 * MUS_PI + 0.65);
    ck_assert_double_gt(mus__contour_radius(&contour, c, s), mus__contour_radius(&contour, c, -s) + 0.02);
}
END_TEST


START_TEST(a_wall_cuts_and_the_girth_still_holds)
{
    set_turns(128);
    for (int side = -1; side <= 1; side += 2) {
        mus__contour contour = {.ca = 0.08 * side, .a = 0.1, .b = 0.1, .n = 2.05, .wall = 0.002, .wall_side = side};
        mus__contour_fit(&contour, 0.62, 128, turn, xy, work);
        ck_assert_double_eq_tol(tape_girth(&contour, 128), 0.62, 1e-11);
        double nearest = 1.0;
        for (int32_t k = 0; k < 128; k++) nearest = fmin(nearest, side * (contour.ca + xy[2 * k]));
        ck_assert_double_eq_tol(nearest, 0.002, 1e-15);
    }
}
END_TEST


/* radii in all directions, computed by symmetry, equal those of each direction: ovals, bumps, walls, an outline */
START_TEST(radii_of_all_directions_are_those_of_each)
{
    const double corner[] = {-2.5, -0.08, -0.06, -0.5, 0.09, -0.049, 0.3, 0.12, 0.037, 2.0, -0.02, 0.0437};
    const mus__contour row[] = {
        {.a = 0.15, .b = 0.11, .n = 2.0},
        {.a = 0.15, .b = 0.11, .n = 2.6, .ca = 0.02, .cb = -0.01},
        {.a = 0.15, .b = 0.11, .n = 2.3, .bump = {0.03, 0.01}, .bump_angle = {0.65, 0.4}},
        {.a = 0.10, .b = 0.12, .n = 2.05, .ca = -0.08, .wall = 0.002, .wall_side = -1.0},
        {.a = 0.12, .b = 0.06, .n = 2.0, .corners = 4, .corner = corner},
    };
    for (size_t i = 0; i < sizeof row / sizeof *row; i++)
        for (int form = 0; form < 2; form++) {
            double radius[SAMPLES];
            if (form == 0) mus__contour_turns(96, turn);
            if (form == 1) mus__field_turns(96, turn);
            mus__contour_radii(&row[i], 96, turn, radius);
            for (int32_t k = 0; k < 96; k++)
                ck_assert_double_eq_tol(radius[k], mus__contour_radius(&row[i], turn[2 * k], turn[2 * k + 1]), 1e-15);
        }
}
END_TEST


START_TEST(a_full_thigh_grows_deep)
{
    ck_assert_double_eq_tol(mus__contour_thigh_ratio(0.3, 0.2), 1.03, 1e-12);
    ck_assert_double_eq_tol(mus__contour_thigh_ratio(0.75, 0.2), 0.75 / (MUS_PI * 0.102) - 1.0, 1e-12);
    ck_assert_double_eq_tol(mus__contour_thigh_ratio(2.0, 0.2), 1.4, 1e-12);
}
END_TEST


Suite *mus_suite_contour(void);
Suite *mus_suite_contour(void)
{
    Suite *suite = suite_create("contour");
    TCase *tests = tcase_create("contour");
    tcase_add_test(tests, eq_6_gives_the_half_axes_of_a_girth);
    tcase_add_test(tests, perimeters_are_those_of_the_quadrature);
    tcase_add_test(tests, the_fitted_polygon_has_the_girth_not_the_curve);
    tcase_add_test(tests, bumps_lie_where_they_are_told_and_the_tape_spans_between);
    tcase_add_test(tests, a_wall_cuts_and_the_girth_still_holds);
    tcase_add_test(tests, radii_of_all_directions_are_those_of_each);
    tcase_add_test(tests, a_full_thigh_grows_deep);
    suite_add_tcase(suite, tests);
    return suite;
}
