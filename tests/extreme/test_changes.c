/*
 * test_changes.c: gravity and stiffness changed between steps: the energy jumps by exactly what the change is worth,
 * the state does not, and the run goes on below the new bound.
 */
#include <stdio.h>

#include "bare.h"
#include "drape/scenes.h"

Suite *mus_suite_changes(void);

static const double weightless[3] = {0.0, 0.0, 0.0}, down[3] = {0.0, -9.81, 0.0};


/* a sheet held at two corners, swung for a while; nothing damps it */
static mus_drape *swinging_sheet(mus_context *context, int32_t precision)
{
    mus_fabric fabric;
    mus_fabric_init(&fabric, sizeof fabric);
    fabric.damping = 0.0;
    mus_drape *drape = extreme_drape(context, extreme_grid(context, 8, 8, 0.02, &fabric), precision, down);
    ck_assert_int_eq(mus_drape_pin(drape, 56, 1), MUS_OK);
    ck_assert_int_eq(mus_drape_pin(drape, 63, 1), MUS_OK);
    ck_assert_int_eq(mus_drape_step(drape, 300, 0.5 * mus_drape_step_bound(drape)), MUS_OK);
    return drape;
}


/* sum of m (from - to) . x: what the energy in gravity gains when it is changed; m is 1 inside, less on the border */
static double worth(mus_context *context, const mus_drape *drape, const double *from, const double *to)
{
    mus_cloth *cloth = extreme_grid(context, 8, 8, 0.02, NULL);
    double sum = 0.0;
    for (int32_t i = 0; i < 64; i++)
        for (int d = 0; d < 3; d++)
            sum += mus_cloth_masses(cloth)[i] * (from[d] - to[d]) * mus_drape_positions(drape)[3 * i + d];
    mus_cloth_destroy(cloth);
    return sum;
}


START_TEST(gravity_changed_between_steps_moves_nothing_by_itself)
{
    const double other[4][3] = {{0, 9.81, 0}, {98.1, 0, 0}, {0, 0, 0}, {0, -981, 0}};
    mus_context *context = support_context();
    for (int32_t precision = 32; precision <= 64; precision += 32) {
        mus_drape *drape = swinging_sheet(context, precision);
        const double *now = down;
        for (int i = 0; i < 4; i++) {
            const double gain = worth(context, drape, now, other[i]), before = extreme_report(drape).energy;
            const uint64_t hash = mus_drape_hash(drape);
            ck_assert_int_eq(mus_drape_set_gravity(drape, other[i]), MUS_OK);
            const double after = extreme_report(drape).energy;
            ck_assert_double_eq_tol(after - before, gain, 1e-12 * (fabs(after) + fabs(before)));
            ck_assert_uint_eq(mus_drape_hash(drape), hash);

            /* and no energy comes from the steps that follow */
            ck_assert_msg(mus_drape_step(drape, 500, 0.5 * mus_drape_step_bound(drape)) == MUS_OK, "%s",
                          mus_context_error(context));
            const double end = extreme_report(drape).energy;
            ck_assert_double_le(end, after + (precision == 64 ? 1e-9 : 1e-4) * (fabs(after) + 1e-3));
            now = other[i];
        }
        mus_drape_destroy(drape);
    }
    support_context_end(context);
}
END_TEST


/* a stretched chain of stiffness k, and one of 10 k warmed from it: nodes as they were, elastic energy 10 times */
START_TEST(stiffness_changed_between_steps_costs_half_dk_x2)
{
    const double place[4] = {0.0, 1.2, 2.1, 3.4}, mass[4] = {0.1, 0.1, 0.1, 0.1};
    const double elastic = 0.5 * 20.0 * (0.2 * 0.2 + 0.1 * 0.1 + 0.3 * 0.3);
    mus_context *context = support_context();
    mus_drape *soft = extreme_drape(context, extreme_chain(context, 4, place, mass, 1.0, 20.0, true), 64, weightless);
    mus_drape *stiff = extreme_drape(context, extreme_chain(context, 4, place, mass, 1.0, 200.0, true), 64, weightless);
    ck_assert_double_eq_tol(extreme_report(soft).energy, elastic, 1e-14);
    ck_assert_int_eq(mus_drape_warm(stiff, soft), MUS_OK);
    ck_assert_mem_eq(mus_drape_positions(stiff), mus_drape_positions(soft), 12 * sizeof(double));
    ck_assert_double_eq_tol(extreme_report(stiff).energy - extreme_report(soft).energy, 9.0 * elastic, 1e-13);

    /* the bound is that of the new stiffness: the old step is refused, a new one keeps the energy */
    const double old = mus_drape_step_bound(soft), bound = mus_drape_step_bound(stiff);
    ck_assert_double_eq_tol(bound, old / sqrt(10.0), 1e-12);
    ck_assert_int_eq(mus_drape_step(stiff, 10, old), MUS_ERR_STEP);
    ck_assert_int_eq(mus_drape_step(stiff, 1000, 0.05 * bound), MUS_OK);
    ck_assert_double_le(extreme_report(stiff).energy, 10.0 * elastic * (1.0 + 1e-12));
    ck_assert_double_ge(extreme_report(stiff).energy, 10.0 * elastic * (1.0 - 1e-3));
    mus_drape_destroy(soft);
    mus_drape_destroy(stiff);
    support_context_end(context);
}
END_TEST


/*
 * what is met from now on. Contact acts by impulses: a plane that is put under a swinging sheet, a little of which
 * is below it, leaves the bound as it is; a step above it is refused with both numbers. Springs between nodes are tacks
 * (tests/drape/test_tack.c). mus_drape_place opens seams that were welded: the bound is that of a drape that never was
 * sewn.
 */
START_TEST(what_is_added_between_steps_has_its_own_bound)
{
    mus_context *context = support_context();
    mus_drape *drape = swinging_sheet(context, _i ? 32 : 64);
    const double *x = mus_drape_positions(drape), bound = mus_drape_step_bound(drape);
    mus_plane plane;
    mus_plane_init(&plane, sizeof plane);
    plane.point[1] = x[1];
    for (int32_t i = 1; i < 64; i++) plane.point[1] = fmin(plane.point[1], x[3 * i + 1]);
    plane.point[1] += 0.003;
    char said[80];
    ck_assert_int_eq(mus_drape_add_plane(drape, &plane, NULL), MUS_OK);
    ck_assert_double_eq(mus_drape_step_bound(drape), bound);
    ck_assert_int_eq(mus_drape_step(drape, 1, 1.01 * bound), MUS_ERR_STEP);
    snprintf(said, sizeof said, "%.9g s is above the stability bound", 1.01 * bound);
    ck_assert_msg(strstr(mus_context_error(context), said) != NULL, "%s", mus_context_error(context));
    for (int k = 0; k < 20; k++) {
        const mus_status status = mus_drape_step(drape, 50, 0.9 * mus_drape_step_bound(drape));
        ck_assert_msg(status == MUS_OK, "%s", mus_context_error(context));
        extreme_finite(drape);
        const mus_drape_report report = extreme_report(drape);
        ck_assert_double_ge(report.step_bound, 0.3 * bound);
        ck_assert_double_lt(report.max_speed, 20.0);
    }
    for (int32_t i = 0; i < 64; i++) /* but for what is held */
        if (i != 56 && i != 63) ck_assert_double_ge(x[3 * i + 1], plane.point[1] - 1e-6);
    mus_drape_destroy(drape);

    /* two strips with a seam of 0.1 m between them */
    mus_pattern *pattern = scene_strips(context, 1.0);
    mus_cloth *cloth = scene_cut(context, pattern, 0.02, 0.0);
    mus_drape *sewn = scene_drape(context, cloth, _i ? 32 : 64, 1);
    mus_drape *open = scene_drape(context, cloth, _i ? 32 : 64, 1);
    const double before = mus_drape_step_bound(open);
    ck_assert_int_eq(mus_drape_sew(sewn, NULL, NULL), MUS_OK);
    ck_assert_int_eq(mus_drape_step(sewn, 10, 0.9 * mus_drape_step_bound(sewn)), MUS_OK);
    ck_assert_int_eq(mus_drape_place(sewn), MUS_OK);
    ck_assert_double_eq(mus_drape_step_bound(sewn), before);
    ck_assert_int_eq(mus_drape_step(sewn, 1, 1.01 * before), MUS_ERR_STEP);
    ck_assert_int_eq(mus_drape_step(sewn, 10, 0.99 * before), MUS_OK);
    ck_assert_int_eq(mus_drape_step(open, 10, 0.99 * before), MUS_OK);
    ck_assert_mem_eq(mus_drape_positions(sewn), mus_drape_positions(open),
                     3 * (size_t)mus_drape_node_count(open) * sizeof(double));
    mus_drape_destroy(sewn);
    mus_drape_destroy(open);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_changes(void)
{
    Suite *suite = suite_create("changes");
    TCase *tests = tcase_create("changes");
    tcase_add_test(tests, gravity_changed_between_steps_moves_nothing_by_itself);
    tcase_add_test(tests, stiffness_changed_between_steps_costs_half_dk_x2);
    tcase_add_loop_test(tests, what_is_added_between_steps_has_its_own_bound, 0, 2);
    suite_add_tcase(suite, tests);
    return suite;
}
