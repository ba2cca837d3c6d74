/* test_step.c: stepping by hand: bound at the pose, divided steps, guard on energy, forecast, forces, gravity. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "drape/drape_state.h"
#include "scenes.h"


/* a grid of 12 x 12 in double, its first row held */
static mus_drape *grid_scene(mus_context *context, mus_cloth **cloth, int32_t precision)
{
    const double cell[2] = {0.02, 0.02};
    mus_cloth_def cut;
    mus_cloth_def_init(&cut, sizeof cut);
    mus_fabric fabric;
    mus_fabric_init(&fabric, sizeof fabric);
    cut.fabric = &fabric;
    fabric.damping = 0.0;
    ck_assert_int_eq(mus_cloth_create_grid(context, 12, 12, cell, &cut, cloth), MUS_OK);
    mus_drape *drape = scene_drape(context, *cloth, precision, 1);
    for (int32_t i = 0; i < 12; i++) ck_assert_int_eq(mus_drape_pin(drape, i, 1), MUS_OK);
    return drape;
}


/* by hand, flat square cells: inside, lambda_max = 4 k + 4 k_d (all threads of one kind, half of each diagonal). A
 * corner has a quarter of the mass, half threads and one whole diagonal: [k + k_d, k_d; k_d, k + k_d], so k + 2 k_d.
 * The identity in place of n n^T would give 8 k + 8 k_d inside */
START_TEST(bound_is_that_of_the_three_by_three_matrix)
{
    mus_context *context = support_context();
    const double cell[2] = {0.02, 0.02};
    mus_cloth_def cut;
    mus_cloth *cloth;
    mus_cloth_def_init(&cut, sizeof cut);
    mus_fabric fabric;
    mus_fabric_init(&fabric, sizeof fabric);
    cut.fabric = &fabric;
    fabric.damping = 0.0;
    fabric.stretch[0] = fabric.stretch[1] = 540.0;
    fabric.shear = 40.0;
    fabric.bend[0] = fabric.bend[1] = fabric.bend[2] = 0.0;
    ck_assert_int_eq(mus_cloth_create_grid(context, 9, 9, cell, &cut, &cloth), MUS_OK);
    mus_drape *drape = scene_drape(context, cloth, 64, 1);
    const double mass = fabric.weight * 4e-4, stiffness = 4.0 * (500.0 + 2.0 * 40.0);
    ck_assert_double_eq_tol(mus_drape_step_bound(drape), 2.62 / sqrt(stiffness / mass), 1e-12);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    support_context_end(context);
}
END_TEST


/* sheared flat until threads and one diagonal line up, the same cloth asks for smaller steps: a step that was allowed
 * before is refused at the door now, and one that meets such a pose on its way is divided and says so */
START_TEST(strong_shear_lowers_the_bound)
{
    mus_context *context = support_context();
    mus_cloth *cloth;
    mus_drape *drape = grid_scene(context, &cloth, 64);
    const int32_t n = mus_drape_node_count(drape);
    double *x = malloc(3 * (size_t)n * sizeof *x), *v = calloc(3 * (size_t)n, sizeof *v);
    memcpy(x, mus_drape_positions(drape), 3 * (size_t)n * sizeof *x);
    const double flat = mus_drape_step_bound(drape);
    for (int32_t i = 0; i < n; i++) x[3 * i] += 2.0 * (x[3 * i + 1] - 1.0), x[3 * i + 1] *= 0.5;
    ck_assert_int_eq(mus_drape_set_state(drape, x, v), MUS_OK);
    const double sheared = mus_drape_step_bound(drape);
    ck_assert_double_lt(sheared, 0.9 * flat);
    const uint64_t hash = mus_drape_hash(drape);
    ck_assert_int_eq(mus_drape_step(drape, 10, 0.99 * flat), MUS_ERR_STEP);
    ck_assert(mus_drape_hash(drape) == hash);

    drape->stepping.bound = 0.0; /* as if the pose had come about within a run */
    ck_assert_int_eq(mus_drape_step(drape, 0, 0.5 * sheared), MUS_OK);
    drape->stepping.bound = flat;
    drape->stepping.since_look = 512;
    ck_assert_int_eq(mus_drape_step(drape, 200, 0.99 * flat), MUS_OK);
    mus_drape_report report;
    mus_drape_report_init(&report, sizeof report);
    ck_assert_int_eq(mus_drape_report_get(drape, &report), MUS_OK);
    ck_assert_int_eq(report.step_parts, 2);
    ck_assert_double_eq_tol(mus_drape_time(drape), 200 * 0.99 * flat, 1e-12);
    free(x);
    free(v);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    support_context_end(context);
}
END_TEST


/* what gets through is caught. The bound is falsified, a shaken cloth stepped far above it: the state that comes
 * back is one that was good, with its time */
START_TEST(energy_that_rises_ends_the_run_at_the_last_good_state)
{
    mus_context *context = support_context();
    mus_cloth *cloth;
    mus_drape *drape = grid_scene(context, &cloth, _i ? 64 : 32);
    const double h = 1.15 * mus_drape_step_bound(drape);
    ck_assert_int_eq(mus_drape_step(drape, 0, 0.0), MUS_OK);
    mus_drape_report report;
    mus_drape_report_init(&report, sizeof report);
    ck_assert_int_eq(mus_drape_report_get(drape, &report), MUS_OK);
    const double start = report.energy;
    drape->stepping.bound = 2.0 * h;
    ck_assert_int_eq(mus_drape_step(drape, 5000, h), MUS_ERR_DIVERGED);
    ck_assert_int_eq(mus_drape_report_get(drape, &report), MUS_OK);
    ck_assert(isfinite(report.energy));
    ck_assert_double_lt(report.energy, start + 1e-2);
    ck_assert_double_lt(mus_drape_time(drape), 5000 * h);
    const double rest = fmod(mus_drape_time(drape) + 1e-9, h);
    ck_assert_double_lt(rest, 1e-6);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    support_context_end(context);
}
END_TEST


/* a program changes nothing: the run after it is the run without it, bit for bit */
START_TEST(a_plan_says_what_a_frame_costs_and_changes_nothing)
{
    mus_context *context = support_context();
    mus_cloth *cloth;
    mus_drape *drape = grid_scene(context, &cloth, 32), *twin = scene_drape(context, cloth, 32, 1);
    for (int32_t i = 0; i < 12; i++) ck_assert_int_eq(mus_drape_pin(twin, i, 1), MUS_OK);
    mus_estimate program;
    mus_estimate_init(&program, sizeof program);
    ck_assert_int_eq(mus_drape_estimate(drape, 0.02, &program), MUS_OK);
    ck_assert_double_le(program.step, 0.9 * program.step_bound * (1 + 1e-12));
    ck_assert_double_eq_tol(program.step * program.steps_per_frame, 0.02, 1e-15);
    ck_assert_int_eq(program.node_evaluations, (int64_t)program.steps_per_frame * 144 * 4);
    ck_assert_double_eq_tol(program.step_bound, 2.62 / sqrt(program.node_stiffness / program.node_mass), 1e-9);
    ck_assert(program.node >= 12 && program.node < 144 && program.bend_share >= 0.0 && program.bend_share < 0.2);
    ck_assert(program.seconds >= 0.0);
    for (int32_t k = 0; k < 2; k++) {
        ck_assert_int_eq(mus_drape_step(drape, program.steps_per_frame, program.step), MUS_OK);
        ck_assert_int_eq(mus_drape_step(twin, program.steps_per_frame, program.step), MUS_OK);
        ck_assert(mus_drape_hash(drape) == mus_drape_hash(twin));
        ck_assert_int_eq(mus_drape_estimate(drape, 0.01, &program), MUS_OK);
        ck_assert_int_eq(mus_drape_estimate(drape, 0.02, &program), MUS_OK);
    }
    ck_assert_int_eq(mus_drape_estimate(drape, 0.0, &program), MUS_ERR_ARG);
    ck_assert_int_eq(mus_drape_estimate(drape, NAN, &program), MUS_ERR_ARG);
    program.size--;
    ck_assert_int_eq(mus_drape_estimate(drape, 0.02, &program), MUS_ERR_VERSION);
    mus_drape_destroy(drape);
    mus_drape_destroy(twin);
    mus_cloth_destroy(cloth);
    support_context_end(context);
}
END_TEST


/* all held: the reactions carry the weight. Gravity changed on the way changes the forces by m dg exactly */
START_TEST(forces_of_held_nodes_are_their_weight)
{
    mus_context *context = support_context();
    mus_cloth *cloth;
    mus_drape *drape = grid_scene(context, &cloth, 64);
    for (int32_t i = 0; i < 144; i++) ck_assert_int_eq(mus_drape_pin(drape, i, 1), MUS_OK);
    double force[3 * 144], sum[3] = {0, 0, 0};
    ck_assert_int_eq(mus_drape_forces(drape, force), MUS_OK);
    for (int32_t i = 0; i < 3 * 144; i++) sum[i % 3] += force[i];
    ck_assert_double_eq_tol(sum[0], 0.0, 1e-12);
    ck_assert_double_eq_tol(sum[1], -9.81 * mus_cloth_mass(cloth), 1e-12);
    const double gravity[3] = {1.0, 2.0, -3.0}, bad[3] = {0.0, NAN, 0.0};
    ck_assert_int_eq(mus_drape_set_gravity(drape, bad), MUS_ERR_ARG);
    ck_assert_int_eq(mus_drape_set_gravity(drape, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_drape_set_gravity(drape, gravity), MUS_OK);
    ck_assert_int_eq(mus_drape_forces(drape, force), MUS_OK);
    for (int32_t i = 0; i < 3 * 144; i++)
        ck_assert_double_eq_tol(force[i], mus_cloth_masses(cloth)[i / 3] * gravity[i % 3], 1e-12);
    ck_assert_int_eq(mus_drape_forces(drape, NULL), MUS_ERR_ARG);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    support_context_end(context);
}
END_TEST


/* the same cloth on the same roller, with and without planes: after a second of rest within 0.02 mm, and planes ask the
 * limb far less often */
START_TEST(planes_of_the_skin_change_micrometres_and_save_queries)
{
    mus_context *context = support_context();
    double rows[2][6];
    mus_limb limb;
    mus_body *body;
    for (int i = 0; i < 2; i++) {
        const double row[6] = {0.3 * (2 * i - 1), 0.0, 0.0, 0.08, 0.08, 2.0};
        memcpy(rows[i], row, sizeof row);
    }
    mus_limb_init(&limb, sizeof limb);
    limb.contours = 2;
    limb.contour = rows[0];
    limb.axis[0] = 1.0, limb.axis[1] = 0.0, limb.axis[2] = 0.0;
    limb.side[0] = 0.0, limb.side[1] = 0.0, limb.side[2] = -1.0;
    limb.pole[0] = -0.31, limb.pole[1] = 0.31;
    ck_assert_int_eq(mus_body_create_limbs(context, 1, &limb, NULL, &body), MUS_OK);
    const double cell[2] = {0.02, 0.02};
    mus_cloth *cloth;
    ck_assert_int_eq(mus_cloth_create_grid(context, 9, 9, cell, NULL, &cloth), MUS_OK);
    double end[2][3 * 81];
    int64_t queries[2];
    for (int k = 0; k < 2; k++) {
        mus_drape_def def;
        mus_drape *drape;
        mus_drape_report report;
        mus_drape_def_init(&def, sizeof def);
        def.precision = 64;
        def.drag = 5.0;
        def.contact_ball = k ? 0.00025 : 0.0;
        ck_assert_int_eq(mus_drape_create(context, cloth, body, &def, &drape), MUS_OK);
        double x[3 * 81];
        for (int i = 0; i < 81; i++)
            x[3 * i] = 0.02 * (i % 9 - 4), x[3 * i + 1] = 0.085, x[3 * i + 2] = 0.02 * (i / 9 - 4);
        ck_assert_int_eq(mus_drape_set_state(drape, x, NULL), MUS_OK);
        const double h = 0.5 * mus_drape_step_bound(drape);
        ck_assert_int_eq(mus_drape_step(drape, (int32_t)(1.0 / h), h), MUS_OK);
        memcpy(end[k], mus_drape_positions(drape), sizeof end[k]);
        mus_drape_report_init(&report, sizeof report);
        ck_assert_int_eq(mus_drape_report_get(drape, &report), MUS_OK);
        queries[k] = report.contact_queries;
        ck_assert_double_eq(report.max_penetration, 0.0);
        mus_drape_destroy(drape);
    }
    for (int i = 0; i < 3 * 81; i++) ck_assert_double_eq_tol(end[0][i], end[1][i], 2e-5);
    ck_assert(queries[1] * 5 < queries[0]);
    mus_cloth_destroy(cloth);
    mus_body_destroy(body);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_step(void)
{
    Suite *suite = suite_create("step");
    TCase *tests = tcase_create("step");
    tcase_add_test(tests, bound_is_that_of_the_three_by_three_matrix);
    tcase_add_test(tests, strong_shear_lowers_the_bound);
    tcase_add_loop_test(tests, energy_that_rises_ends_the_run_at_the_last_good_state, 0, 2);
    tcase_add_test(tests, a_plan_says_what_a_frame_costs_and_changes_nothing);
    tcase_add_test(tests, planes_of_the_skin_change_micrometres_and_save_queries);
    tcase_add_test(tests, forces_of_held_nodes_are_their_weight);
    suite_add_tcase(suite, tests);
    return suite;
}
