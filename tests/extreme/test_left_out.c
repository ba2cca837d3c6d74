/*
 * test_left_out.c: what a scene does not need costs nothing and changes nothing: counters are
 * the integers that the scene predicts, a feature that is there and unused leaves every bit as it was, and no step
 * allocates.
 */
#include <stdio.h>

#include "drape/drape_state.h"

#include "bare.h"
#include "drape/scenes.h"
#include "muslin/integrate.h"

Suite *mus_suite_left_out(void);

static const double down[3] = {0.0, -9.81, 0.0};


static mus_body *a_body(mus_context *context)
{
    mus_tape *tape;
    mus_body *body;
    mus_body_def def;
    mus_body_def_init(&def, sizeof def);
    def.samples = 16;
    def.ring_spacing = 0.1;
    ck_assert_int_eq(mus_tape_create(context, &tape), MUS_OK);
    ck_assert_int_eq(mus_tape_set_size(tape, "W40"), MUS_OK);
    ck_assert_int_eq(mus_body_create(context, tape, &def, &body), MUS_OK);
    mus_tape_destroy(tape);
    return body;
}


/* ---- counters ---- */

/* scene x module: shear, bending, dashpots, drag on and off, both integrators, a body out of reach or none */
START_TEST(counters_are_what_the_scene_predicts)
{
    enum { ROWS = 9, COLUMNS = 7, STEPS = 20 };
    const bool shear = _i & 1, bend = _i & 2, dashpots = _i & 4, drag = _i & 8, verlet = _i & 16, body = _i & 32;
    mus_context *context = support_context();
    mus_fabric fabric;
    mus_fabric_init(&fabric, sizeof fabric);
    fabric.shear = shear ? fabric.shear : 0.0;
    fabric.damping = dashpots ? 0.1 : 0.0;
    for (int k = 0; k < 3; k++) fabric.bend[k] = bend ? 1e-5 : 0.0;
    mus_cloth *cloth = extreme_grid(context, ROWS, COLUMNS, 0.01, &fabric);
    mus_body *who = body ? a_body(context) : NULL;
    mus_drape_def def;
    mus_drape *drape;
    mus_drape_def_init(&def, sizeof def);
    def.drag = drag ? 0.5 : 0.0;
    def.integrator = verlet ? MUS_METHOD_VERLET : MUS_METHOD_RK4;
    ck_assert_int_eq(mus_drape_create(context, cloth, who, &def, &drape), MUS_OK);

    /* ten metres to the left of whoever is there */
    double x[3 * ROWS * COLUMNS];
    memcpy(x, mus_drape_positions(drape), sizeof x);
    for (int32_t i = 0; i < ROWS * COLUMNS; i++) x[3 * i] += 10.0, x[3 * i + 1] += 1.0;
    ck_assert_int_eq(mus_drape_set_state(drape, x, NULL), MUS_OK);
    ck_assert_int_eq(mus_drape_step(drape, STEPS, 0.5 * mus_drape_step_bound(drape)), MUS_OK);

    int64_t springs = ROWS * (COLUMNS - 1) + COLUMNS * (ROWS - 1);
    if (shear) springs += 2 * (ROWS - 1) * (COLUMNS - 1);
    if (bend) springs += ROWS * (COLUMNS - 2) + COLUMNS * (ROWS - 2) + 2 * (ROWS - 2) * (COLUMNS - 2);
    const mus_drape_report report = extreme_report(drape);
    ck_assert_int_eq(report.springs, springs);
    ck_assert_int_eq(report.steps, STEPS);
    ck_assert_int_eq(report.spring_evaluations, (verlet ? 1 : 4) * STEPS * springs);
    ck_assert_int_eq(drape->sim.force_evaluations, verlet ? STEPS + 1 : 4 * STEPS);
    ck_assert_int_eq(report.contact_queries, 0);

    char skipped[128];
    snprintf(skipped, sizeof skipped, "%sseams%s%s%s%s,threads,layers", body ? "" : "contact,friction,",
             shear ? "" : ",shear", bend ? "" : ",bending", dashpots ? "" : ",dashpots", drag ? "" : ",drag");
    ck_assert_str_eq(mus_drape_skipped(drape), skipped);
    mus_drape_destroy(drape);
    mus_body_destroy(who);
    mus_cloth_destroy(cloth);
    support_context_end(context);
}
END_TEST


/* held everywhere: time goes on and no spring is asked */
START_TEST(a_cloth_that_is_held_everywhere_costs_no_evaluation)
{
    mus_context *context = support_context();
    mus_drape *drape = extreme_drape(context, extreme_grid(context, 5, 5, 0.01, NULL), 32, down);
    for (int32_t i = 0; i < 25; i++) ck_assert_int_eq(mus_drape_pin(drape, i, 1), MUS_OK);
    ck_assert_int_eq(mus_drape_step(drape, 1000, 0.01), MUS_OK);
    ck_assert_int_eq(extreme_report(drape).spring_evaluations, 0);
    ck_assert_int_eq(extreme_report(drape).steps, 1000);
    ck_assert_double_eq_tol(mus_drape_time(drape), 10.0, 1e-12);
    ck_assert_int_eq(mus_drape_pin(drape, 24, 0), MUS_OK);
    ck_assert_int_eq(mus_drape_step(drape, 1, 1e-4), MUS_OK);
    ck_assert_int_gt(extreme_report(drape).spring_evaluations, 0);
    mus_drape_destroy(drape);
    support_context_end(context);
}
END_TEST


/* ---- results: with an unused feature as without, bit for bit ---- */

typedef enum feature {
    NOTHING,
    BODY_AFAR,    /* C5: ten metres away */
    BODY_LEAVING, /* and gliding off */
    THREADS,
    SKIN,           /* friction, thickness and clearance, where there is no skin */
    SEAM_OPTIONS,   /* what sewing would read, without a seam */
    SETTLE_OPTIONS, /* what settling would read */
    PIN_AND_LET_GO,
    SAME_GRAVITY,
    QUESTIONS, /* plan, report, normals, forces, gaps before the run */
    FEATURES
} feature;


/* options and drape of the scene with a feature; 1 s of a sheet held by a corner; its hash */
static uint64_t hash_with(feature f, int32_t precision, int32_t integrator)
{
    enum { SIDE = 8, N = SIDE * SIDE };
    mus_context *context = support_context();
    mus_fabric fabric;
    mus_fabric_init(&fabric, sizeof fabric);
    if (f == SKIN) fabric.friction *= 2.0, fabric.thickness *= 2.0;
    mus_cloth *cloth = extreme_grid(context, SIDE, SIDE, 0.03, &fabric);
    mus_body *body = f == BODY_AFAR || f == BODY_LEAVING ? a_body(context) : NULL;
    mus_drape_def def;
    mus_drape *drape;
    mus_drape_def_init(&def, sizeof def);
    def.precision = precision;
    def.integrator = integrator;
    if (f == THREADS) def.threads = 3;
    if (f == SKIN) def.clearance = 0.01;
    if (f == SEAM_OPTIONS) def.collision_distance = 0.01, def.seam_pull = 500.0, def.sew_seconds = 1.0;
    if (f == SETTLE_OPTIONS) def.settle_seconds = 1.0, def.settle_residual = 0.5;
    ck_assert_int_eq(mus_drape_create(context, cloth, body, &def, &drape), MUS_OK);

    double x[3 * N], out[3 * N];
    memcpy(x, mus_drape_positions(drape), sizeof x);
    for (int32_t i = 0; i < N; i++) x[3 * i] += 10.0, x[3 * i + 1] += 1.0, x[3 * i + 2] = 0.001 * (i % 5);
    ck_assert_int_eq(mus_drape_set_state(drape, x, NULL), MUS_OK);
    ck_assert_int_eq(mus_drape_pin(drape, N - 1, 1), MUS_OK);
    const double leaving[3] = {-1.0, 0.0, 0.0};
    if (f == BODY_LEAVING) ck_assert_int_eq(mus_drape_move_body(drape, leaving), MUS_OK);
    if (f == PIN_AND_LET_GO)
        for (int32_t fixed = 1; fixed >= 0; fixed--) ck_assert_int_eq(mus_drape_pin(drape, 3, fixed), MUS_OK);
    if (f == SAME_GRAVITY) ck_assert_int_eq(mus_drape_set_gravity(drape, down), MUS_OK);
    if (f == QUESTIONS) {
        mus_estimate forecast;
        mus_estimate_init(&forecast, sizeof forecast);
        ck_assert_int_eq(mus_drape_estimate(drape, 0.02, &forecast), MUS_OK);
        ck_assert_int_eq(mus_drape_forces(drape, out), MUS_OK);
        ck_assert_int_eq(mus_drape_normals(drape, out), MUS_OK);
        ck_assert_int_eq(mus_drape_gaps(drape, out), MUS_OK);
        (void)extreme_report(drape);
    }
    const double h = 0.0004;
    ck_assert_double_lt(h, mus_drape_step_bound(drape));
    ck_assert_int_eq(mus_drape_step(drape, 2500, h), MUS_OK);
    ck_assert_double_gt(extreme_report(drape).max_speed, 0.01);
    const uint64_t hash = mus_drape_hash(drape);
    mus_drape_destroy(drape);
    mus_body_destroy(body);
    mus_cloth_destroy(cloth);
    support_context_end(context);
    return hash;
}


START_TEST(a_feature_that_is_not_used_changes_no_bit)
{
    const int32_t precision = _i & 1 ? 64 : 32, integrator = _i & 2 ? MUS_METHOD_VERLET : MUS_METHOD_RK4;
    const uint64_t without = hash_with(NOTHING, precision, integrator);
    for (int f = NOTHING + 1; f < FEATURES; f++)
        ck_assert_msg(hash_with((feature)f, precision, integrator) == without,
                      "feature %d, precision %d, integrator %d", f, (int)precision, (int)integrator);
}
END_TEST


/* a second panel that nothing joins to the first: the nodes of the first go where they go without it */
START_TEST(a_panel_that_nothing_joins_changes_no_bit_of_the_other)
{
    double *place[2];
    int32_t count[2];
    for (int more = 0; more < 2; more++) {
        mus_context *context = support_context();
        mus_pattern *pattern = scene_square(context, 0.2);
        int32_t edge[4];
        if (more) scene_move(pattern, scene_rectangle(pattern, "other", 0, 0, 0.1, 0.15, edge), 3, 1, 0);
        mus_cloth *cloth = scene_cut(context, pattern, 0.02, 0.05);
        int32_t range[4];
        ck_assert_int_eq(mus_cloth_panel_range(cloth, 0, range), MUS_OK);
        mus_drape *drape = scene_drape(context, cloth, 64, 1);
        ck_assert_int_eq(mus_drape_pin(drape, range[0], 1), MUS_OK);
        ck_assert_int_eq(mus_drape_step(drape, 2000, 5e-5), MUS_OK);
        count[more] = range[1];
        place[more] = malloc(3 * (size_t)range[1] * sizeof(double));
        memcpy(place[more], mus_drape_positions(drape) + 3 * range[0], 3 * (size_t)range[1] * sizeof(double));
        mus_drape_destroy(drape);
        mus_cloth_destroy(cloth);
        mus_pattern_destroy(pattern);
        support_context_end(context);
    }
    ck_assert_int_eq(count[0], count[1]);
    ck_assert_mem_eq(place[0], place[1], 3 * (size_t)count[0] * sizeof(double));
    free(place[0]);
    free(place[1]);
}
END_TEST


/* ---- memory ---- */

/* no step allocates: precisions, integrators, a body that glides, threads */
START_TEST(no_step_allocates)
{
    mus_context *context = support_context();
    mus_cloth *cloth = extreme_grid(context, 9, 9, 0.01, NULL);
    mus_body *body = a_body(context);
    mus_drape_def def;
    mus_drape *drape;
    mus_drape_def_init(&def, sizeof def);
    def.precision = _i & 1 ? 64 : 32;
    def.integrator = _i & 2 ? MUS_METHOD_VERLET : MUS_METHOD_RK4;
    def.threads = _i & 4 ? 3 : 1;
    ck_assert_int_eq(mus_drape_create(context, cloth, body, &def, &drape), MUS_OK);
    const double velocity[3] = {0.1, 0.0, 0.0};
    double out[3 * 81];
    const uint64_t made = mus_context_allocations(context);
    const size_t bytes = mus_context_bytes(context);
    ck_assert_int_eq(mus_drape_move_body(drape, velocity), MUS_OK);
    ck_assert_int_eq(mus_drape_pin(drape, 80, 1), MUS_OK);
    for (int k = 0; k < 5; k++) {
        ck_assert_int_eq(mus_drape_step(drape, 200, 0.5 * mus_drape_step_bound(drape)), MUS_OK);
        ck_assert_int_eq(mus_drape_forces(drape, out), MUS_OK);
        (void)extreme_report(drape);
    }
    ck_assert_uint_eq(mus_context_allocations(context), made);
    ck_assert_uint_eq(mus_context_bytes(context), bytes);
    mus_drape_destroy(drape);
    mus_body_destroy(body);
    mus_cloth_destroy(cloth);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_left_out(void)
{
    Suite *suite = suite_create("left_out");
    TCase *tests = tcase_create("left_out");
    tcase_set_timeout(tests, 60);
    tcase_add_loop_test(tests, counters_are_what_the_scene_predicts, 0, 64);
    tcase_add_test(tests, a_cloth_that_is_held_everywhere_costs_no_evaluation);
    tcase_add_loop_test(tests, a_feature_that_is_not_used_changes_no_bit, 0, 4);
    tcase_add_test(tests, a_panel_that_nothing_joins_changes_no_bit_of_the_other);
    tcase_add_loop_test(tests, no_step_allocates, 0, 8);
    suite_add_tcase(suite, tests);
    return suite;
}
