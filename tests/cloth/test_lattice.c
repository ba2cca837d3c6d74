/*
 * test_lattice.c: nodes and full cells of random polygons against distance and winding.
 */
#include "cut.h"

#include "cloth/lattice.h"
#include "geom/polygon.h"

#define CLEAR 0.75
#define MARGIN 0.55 /* sqrt(0.75^2 - 0.5^2) from the middle of a cell's side */


START_TEST(nodes_are_the_places_inside_and_clear_of_the_border)
{
    mus_context *context = support_context();
    uint64_t state = 1;
    for (int turn = 0; turn < 60; turn++) {
        double xy[80], a = 0.01, grain[2] = {sin(0.1 * turn), cos(0.1 * turn)}, p[2];
        int32_t n = 5 + turn % 35, count = 0;
        for (int32_t i = 0; i < n; i++) {
            double angle = (turn % 2 ? -1 : 1) * 6.283185307179586 * i / n, r = support_uniform(&state, 0.02, 0.15);
            xy[2 * i] = 0.5 + r * cos(angle), xy[2 * i + 1] = r * sin(angle);
        }
        mus__lattice lattice;
        ck_assert_int_eq(mus__lattice_build(context, n, xy, 0, NULL, grain, a, &lattice), MUS_OK);
        for (int32_t j = 0; j < lattice.rows; j++)
            for (int32_t i = 0; i < lattice.columns; i++) {
                int64_t place = (int64_t)j * lattice.columns + i;
                mus__lattice_point(&lattice, i, j, p);
                bool inside = mus__polygon_winding(n, xy, p) != 0;
                double distance = mus__polygon_distance(n, xy, p);
                if (fabs(distance - CLEAR * a) > 1e-12)
                    ck_assert_int_eq(lattice.node[place] != MUS_NONE, inside && distance > CLEAR * a);
                if (lattice.node[place] != MUS_NONE) ck_assert_int_eq(lattice.node[place], count++);
                if (!lattice.full[place]) continue;

                /* a full cell: corners are nodes, and no point of it is nearer to the border than the margin */
                ck_assert(lattice.node[place + lattice.columns + 1] != MUS_NONE);
                for (int k = 0; k < 9; k++) {
                    double q[2], u = 0.5 * (k % 3), v = 0.5 * (k / 3);
                    for (int m = 0; m < 2; m++) q[m] = p[m] + a * (u * lattice.weft[m] + v * lattice.warp[m]);
                    ck_assert(mus__polygon_distance(n, xy, q) > 0.99 * MARGIN * a);
                    if (u == 0.5 && v == 0.5) ck_assert(mus__lattice_covers(&lattice, q));
                }
            }
        ck_assert_int_eq(count, lattice.count);
        mus__lattice_free(context, &lattice);
    }
    support_context_end(context);
}
END_TEST


START_TEST(rows_run_along_the_weft_and_stack_along_the_warp)
{
    mus_context *context = support_context();
    const double xy[] = {0, 0, 0.3, 0, 0.3, 0.2, 0, 0.2}, grain[2] = {0.6, 0.8};
    mus__lattice lattice;
    double p[2], q[2], r[2];
    ck_assert_int_eq(mus__lattice_build(context, 4, xy, 0, NULL, grain, 0.01, &lattice), MUS_OK);
    mus__lattice_point(&lattice, 3, 4, p);
    mus__lattice_point(&lattice, 4, 4, q);
    mus__lattice_point(&lattice, 3, 5, r);
    ck_assert_double_eq_tol(r[0] - p[0], 0.006, 1e-15);
    ck_assert_double_eq_tol(r[1] - p[1], 0.008, 1e-15);
    ck_assert_double_eq_tol(q[0] - p[0], 0.008, 1e-15);
    ck_assert_double_eq_tol(q[1] - p[1], -0.006, 1e-15);
    mus__lattice_free(context, &lattice);
    support_context_end(context);
}
END_TEST


START_TEST(a_rectangle_of_whole_spacings_leaves_a_rim_of_one)
{
    mus_context *context = support_context();
    for (int32_t m = 3; m < 12; m++) {
        const double xy[] = {0, 0, 0.01 * m, 0, 0.01 * m, 0.05, 0, 0.05}, grain[2] = {0, 1};
        mus__lattice lattice;
        ck_assert_int_eq(mus__lattice_build(context, 4, xy, 0, NULL, grain, 0.01, &lattice), MUS_OK);
        ck_assert_int_eq(lattice.count, (m - 1) * 4);
        mus__lattice_free(context, &lattice);
    }
    support_context_end(context);
}
END_TEST


START_TEST(too_many_places_are_refused)
{
    mus_context *context = support_context();
    const double xy[] = {0, 0, 100, 0, 100, 100, 0, 100}, grain[2] = {0, 1};
    mus__lattice lattice;
    ck_assert_int_eq(mus__lattice_build(context, 4, xy, 0, NULL, grain, 0.001, &lattice), MUS_ERR_LIMIT);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "2^27"));
    mus__lattice_free(context, &lattice);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_lattice(void);
Suite *mus_suite_lattice(void)
{
    Suite *suite = suite_create("lattice");
    TCase *tests = tcase_create("lattice");
    tcase_add_test(tests, nodes_are_the_places_inside_and_clear_of_the_border);
    tcase_add_test(tests, rows_run_along_the_weft_and_stack_along_the_warp);
    tcase_add_test(tests, a_rectangle_of_whole_spacings_leaves_a_rim_of_one);
    tcase_add_test(tests, too_many_places_are_refused);
    suite_add_tcase(suite, tests);
    return suite;
}
