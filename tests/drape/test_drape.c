/*
 * test_drape.c: a drape by its public calls: stepping, refusing, pinning, sewing, settling, threads, memory.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "drape/drape_state.h"
#include "drape/weld.h"
#include "scenes.h"

Suite *mus_suite_drape(void);


/* I10: a flat cloth in free fall stays exactly flat and falls as a point does */
START_TEST(flat_cloth_falls_free_and_unstretched)
{
    mus_context *context = support_context();
    mus_pattern *pattern = scene_square(context, 0.3);
    mus_cloth *cloth = scene_cut(context, pattern, 0.01, 0.02);
    mus_drape *drape = scene_drape(context, cloth, 64, 1);
    const double h = 0.5 * mus_drape_step_bound(drape);
    const int32_t steps = (int32_t)(0.5 / h), n = mus_drape_node_count(drape);
    double *start = malloc(3 * (size_t)n * sizeof *start);
    memcpy(start, mus_drape_positions(drape), 3 * (size_t)n * sizeof *start);
    ck_assert_int_eq(mus_drape_step(drape, steps, h), MUS_OK);
    const double t = mus_drape_time(drape), *x = mus_drape_positions(drape);
    ck_assert_double_eq_tol(t, steps * h, 1e-12);
    for (int32_t i = 0; i < n; i++) {
        ck_assert_double_eq_tol(x[3 * i], start[3 * i], 1e-12);
        ck_assert_double_eq_tol(x[3 * i + 1], start[3 * i + 1] - 0.5 * 9.81 * t * t, 1e-11);
        ck_assert_double_eq_tol(x[3 * i + 2], start[3 * i + 2], 1e-12);
    }
    mus_drape_report report;
    mus_drape_report_init(&report, sizeof report);
    ck_assert_int_eq(mus_drape_report_get(drape, &report), MUS_OK);
    ck_assert_double_le(report.max_strain, 1e-12);
    free(start);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


START_TEST(a_step_above_the_bound_is_refused_with_the_bound)
{
    mus_context *context = support_context();
    mus_pattern *pattern = scene_square(context, 0.1);
    mus_cloth *cloth = scene_cut(context, pattern, 0.01, 0.0);
    mus_drape *drape = scene_drape(context, cloth, 64, 1);
    const double bound = mus_drape_step_bound(drape);
    const uint64_t before = mus_drape_hash(drape);
    char number[32];
    snprintf(number, sizeof number, "%.9g", bound);
    ck_assert_int_eq(mus_drape_step(drape, 1, 1.01 * bound), MUS_ERR_STEP);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), number));
    ck_assert_uint_eq(mus_drape_hash(drape), before);
    ck_assert_int_eq(mus_drape_step(drape, 1, NAN), MUS_ERR_ARG);
    ck_assert_int_eq(mus_drape_step(drape, 1, -1e-5), MUS_ERR_ARG);
    ck_assert_int_eq(mus_drape_step(drape, -1, 1e-5), MUS_ERR_ARG);
    ck_assert_int_eq(mus_drape_step(drape, 0, 1e-5), MUS_OK);
    ck_assert_int_eq(mus_drape_step(drape, 3, 0.0), MUS_OK);
    ck_assert_uint_eq(mus_drape_hash(drape), before);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


/* 0.99 of the bound: a shaken cloth without damping keeps its energy for many steps */
START_TEST(below_the_bound_energy_does_not_grow)
{
    mus_context *context = support_context();
    mus_pattern *pattern = scene_square(context, 0.1);
    mus_cloth *cloth = scene_cut(context, pattern, 0.01, 0.0);
    mus_drape_def def;
    mus_drape *drape;
    mus_drape_def_init(&def, sizeof def);
    def.precision = 64;
    def.drag = def.gravity[1] = 0.0;
    ck_assert_int_eq(mus_drape_create(context, cloth, NULL, &def, &drape), MUS_OK);
    const int32_t n = mus_drape_node_count(drape);
    double *x = malloc(3 * (size_t)n * sizeof *x);
    memcpy(x, mus_drape_positions(drape), 3 * (size_t)n * sizeof *x);
    uint64_t random = 3;
    for (int32_t i = 0; i < 3 * n; i++) x[i] += support_uniform(&random, -1e-4, 1e-4);
    ck_assert_int_eq(mus_drape_set_state(drape, x, NULL), MUS_OK);
    mus_drape_report before, after;
    mus_drape_report_init(&before, sizeof before);
    mus_drape_report_init(&after, sizeof after);
    mus_drape_report_get(drape, &before);
    ck_assert_int_eq(mus_drape_step(drape, 2000, 0.99 * mus_drape_step_bound(drape)), MUS_OK);
    mus_drape_report_get(drape, &after);
    ck_assert_double_gt(before.energy, 0.0);
    ck_assert_double_le(after.energy, before.energy * (1 + 1e-9));
    free(x);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


START_TEST(a_pinned_node_does_not_move_and_the_rest_hangs_from_it)
{
    mus_context *context = support_context();
    mus_pattern *pattern = scene_square(context, 0.2);
    mus_cloth *cloth = scene_cut(context, pattern, 0.02, 0.0);
    mus_drape *drape = scene_drape(context, cloth, 64, 1);
    int32_t count;
    const int32_t *border;
    ck_assert_int_eq(mus_cloth_panel_border(cloth, 0, &count, &border), MUS_OK);
    double held[3];
    memcpy(held, mus_drape_positions(drape) + 3 * border[0], sizeof held);
    ck_assert_int_eq(mus_drape_pin(drape, border[0], 1), MUS_OK);
    ck_assert_int_eq(mus_drape_step(drape, 2000, 0.9 * mus_drape_step_bound(drape)), MUS_OK);
    ck_assert_mem_eq(held, mus_drape_positions(drape) + 3 * border[0], sizeof held);
    mus_drape_report report;
    mus_drape_report_init(&report, sizeof report);
    mus_drape_report_get(drape, &report);
    ck_assert_double_gt(report.max_speed, 0.1);
    ck_assert_double_lt(report.max_strain, 0.5);
    ck_assert_int_eq(mus_drape_pin(drape, -1, 1), MUS_ERR_ARG);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


/* sum of inertia times place: inertia is what sewing moves (raised at the border, where the mesh is stiffer) */
static void centre_of_inertia(const mus_drape *drape, double *out)
{
    const double *inverse = drape->sim.inverse;
    double total = 0.0;
    memset(out, 0, 3 * sizeof *out);
    for (int32_t i = 0; i < drape->n; i++) {
        total += 1.0 / inverse[i];
        for (int d = 0; d < 3; d++) out[d] += drape->x[3 * i + d] / inverse[i];
    }
    for (int d = 0; d < 3; d++) out[d] /= total;
}


/* S2: elastic pull and stitches are inner forces: two free strips, pulled and stitched, keep their centre */
START_TEST(sewing_moves_no_centre)
{
    mus_context *context = support_context();
    mus_pattern *pattern = scene_strips(context, 1.0 + 0.25 * _i);
    mus_cloth *cloth = scene_cut(context, pattern, 0.01, 0.0);
    mus_drape *drape = scene_drape(context, cloth, 64, 1);
    mus__sim *sim = &drape->sim;
    const double rate2 = mus__drape_rate(drape, 1), h = 0.5 * 2.62 / sqrt(rate2);
    mus__drape_inertia(drape, rate2);
    double before[3], after[3];
    memset(sim->gravity, 0, sizeof sim->gravity);
    sim->drag = 8.0;
    sim->speed_limit = 1e9; /* the limit is an outer force */
    centre_of_inertia(drape, before);
    for (int k = 0; k < 3000; k++) sim->ops->euler(sim, h);
    mus__drape_publish(drape);
    centre_of_inertia(drape, after);
    ck_assert_double_lt(mus__weld_gap(drape, NULL), 0.05);
    for (int d = 0; d < 3; d++) ck_assert_double_eq_tol(after[d], before[d], 1e-12);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


/* S3: seams of equal and unequal length close and are welded */
START_TEST(a_seam_closes_and_is_welded)
{
    mus_context *context = support_context();
    mus_pattern *pattern = scene_strips(context, 1.0 + 0.25 * _i);
    mus_cloth *cloth = scene_cut(context, pattern, 0.01, 0.0);
    mus_drape *drape = scene_drape(context, cloth, 64, 1);
    ck_assert_int_eq(mus_drape_sew(drape, NULL, NULL), MUS_OK);
    mus_drape_report report;
    mus_drape_report_init(&report, sizeof report);
    mus_drape_report_get(drape, &report);
    ck_assert_int_eq(report.seams_closed, 1);
    ck_assert_int_ne(report.welded, 0);
    ck_assert_double_eq(report.max_seam_gap, 0.0);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


START_TEST(a_seam_that_cannot_close_is_named_with_its_gap)
{
    mus_context *context = support_context();
    mus_pattern *pattern = scene_strips(context, 1.0);
    mus_cloth *cloth = scene_cut(context, pattern, 0.02, 0.0);
    mus_drape_def def;
    mus_drape *drape;
    mus_drape_def_init(&def, sizeof def);
    def.sew_seconds = 0.2;
    ck_assert_int_eq(mus_drape_create(context, cloth, NULL, &def, &drape), MUS_OK);
    ck_assert_int_eq(mus_drape_place(drape), MUS_OK);
    const int32_t *pairs = mus_cloth_pairs(cloth);
    for (int32_t p = 0; p < mus_cloth_pair_count(cloth); p++) {
        mus_drape_pin(drape, pairs[2 * p], 1);
        mus_drape_pin(drape, pairs[2 * p + 1], 1);
    }
    ck_assert_int_eq(mus_drape_sew(drape, NULL, NULL), MUS_ERR_SEW);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "seam 0"));
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "100.0 mm"));
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


/* the same scene, sewn and stepped, for several thread counts */
static uint64_t hash_with(int32_t precision, int32_t threads)
{
    mus_context *context = support_context();
    mus_pattern *pattern = scene_strips(context, 1.1);
    mus_cloth *cloth = scene_cut(context, pattern, 0.01, 0.05);
    mus_drape *drape = scene_drape(context, cloth, precision, threads);
    ck_assert_int_eq(mus_drape_sew(drape, NULL, NULL), MUS_OK);
    ck_assert_int_eq(mus_drape_step(drape, 50, 0.9 * mus_drape_step_bound(drape)), MUS_OK);
    const uint64_t hash = mus_drape_hash(drape);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    support_context_end(context);
    return hash;
}


START_TEST(the_state_is_the_same_for_any_number_of_threads)
{
    const int32_t precision = _i ? 64 : 32;
    const uint64_t one = hash_with(precision, 1);
    ck_assert_uint_eq(hash_with(precision, 1), one);
    ck_assert_uint_eq(hash_with(precision, 2), one);
    ck_assert_uint_eq(hash_with(precision, 3), one);
}
END_TEST


START_TEST(stepping_allocates_nothing_nor_does_a_second_settle)
{
    mus_context *context = support_context();
    mus_pattern *pattern = scene_strips(context, 1.0);
    mus_cloth *cloth = scene_cut(context, pattern, 0.02, 0.05);
    mus_drape *drape = scene_drape(context, cloth, 32, 1);
    uint64_t before = mus_context_allocations(context);
    ck_assert_int_eq(mus_drape_step(drape, 10, 0.5 * mus_drape_step_bound(drape)), MUS_OK);
    ck_assert_uint_eq(mus_context_allocations(context), before);

    /* the first sew and settle take what they need, the second find it */
    ck_assert_int_eq(mus_drape_sew(drape, NULL, NULL), MUS_OK);
    ck_assert_int_eq(mus_drape_settle(drape, NULL, NULL), MUS_ERR_UNSETTLED); /* it falls for ever */
    before = mus_context_allocations(context);
    ck_assert_int_eq(mus_drape_place(drape), MUS_OK);
    ck_assert_int_eq(mus_drape_sew(drape, NULL, NULL), MUS_OK);
    ck_assert_int_eq(mus_drape_step(drape, 10, 0.5 * mus_drape_step_bound(drape)), MUS_OK);
    ck_assert_int_eq(mus_drape_settle(drape, NULL, NULL), MUS_ERR_UNSETTLED);
    ck_assert_uint_eq(mus_context_allocations(context), before);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


/* M1: a strip held along its upper edge comes to rest stretched by sigma g L^2 / (2 Y) */
START_TEST(a_hanging_cloth_comes_to_rest)
{
    mus_context *context = support_context();
    mus_pattern *pattern = scene_square(context, 0.2);
    mus_cloth *cloth = scene_cut(context, pattern, 0.02, 0.0);
    mus_drape_def def;
    mus_drape *drape;
    mus_drape_def_init(&def, sizeof def);
    def.precision = 64;
    def.settle_residual = 2e-4;
    ck_assert_int_eq(mus_drape_create(context, cloth, NULL, &def, &drape), MUS_OK);
    ck_assert_int_eq(mus_drape_place(drape), MUS_OK);
    int32_t count;
    const int32_t *border;
    mus_cloth_panel_border(cloth, 0, &count, &border);
    const double *x = mus_drape_positions(drape);
    for (int32_t i = 0; i < count; i++)
        if (x[3 * border[i] + 1] > 1.1999) mus_drape_pin(drape, border[i], 1);
    ck_assert_int_eq(mus_drape_settle(drape, NULL, NULL), MUS_OK);
    mus_drape_report report;
    mus_drape_report_init(&report, sizeof report);
    mus_drape_report_get(drape, &report);
    ck_assert_int_eq(report.settled, 1);
    ck_assert_double_le(report.residual, 2e-4);

    mus_fabric fabric;
    mus_fabric_init(&fabric, sizeof fabric);
    double lowest = 2.0;
    for (int32_t i = 0; i < mus_drape_node_count(drape); i++) lowest = fmin(lowest, x[3 * i + 1]);
    const double sag = fabric.weight * 9.81 * 0.2 * 0.2 / (2.0 * fabric.stretch[0]);
    ck_assert_double_eq_tol(1.0 - lowest, sag, 0.08 * sag);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


/* a cloth let go beside the body touches nothing and is told so, long before its time is up */
START_TEST(a_cloth_beside_the_body_slides_off)
{
    mus_context *context = support_context();
    mus_tape *tape;
    mus_body *body;
    mus_drape *drape;
    mus_pattern *pattern = scene_square(context, 0.1);
    scene_move(pattern, 0, 1.5, 1.0, 0.0);
    mus_cloth *cloth = scene_cut(context, pattern, 0.02, 0.0);
    ck_assert_int_eq(mus_tape_create(context, &tape), MUS_OK);
    ck_assert_int_eq(mus_tape_set_size(tape, "W40"), MUS_OK);
    ck_assert_int_eq(mus_body_create(context, tape, NULL, &body), MUS_OK);
    ck_assert_int_eq(mus_drape_create(context, cloth, body, NULL, &drape), MUS_OK);
    ck_assert_int_eq(mus_drape_place(drape), MUS_OK);
    ck_assert_int_eq(mus_drape_settle(drape, NULL, NULL), MUS_ERR_UNSETTLED);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "slid off"));
    ck_assert_double_lt(mus_drape_time(drape), 2.0);
    mus_drape_destroy(drape);
    mus_body_destroy(body);
    mus_tape_destroy(tape);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


START_TEST(each_failing_allocation_is_a_status)
{
    for (int64_t n = 0;; n++) {
        mus_context *context = support_context();
        mus_pattern *pattern = scene_strips(context, 1.0);
        mus_cloth *cloth = scene_cut(context, pattern, 0.02, 0.0);
        mus_drape *drape = NULL;
        support_fail_after(n, false);
        const mus_status status = mus_drape_create(context, cloth, NULL, NULL, &drape);
        support_fail_never();
        ck_assert_int_eq(drape == NULL, status != MUS_OK);
        mus_drape_destroy(drape);
        mus_cloth_destroy(cloth);
        mus_pattern_destroy(pattern);
        support_context_end(context);
        if (status == MUS_OK) break;
        ck_assert_int_eq(status, MUS_ERR_MEMORY);
    }
}
END_TEST


START_TEST(the_cloth_may_go_before_the_drape)
{
    mus_context *context = support_context();
    mus_pattern *pattern = scene_square(context, 0.1);
    mus_cloth *cloth = scene_cut(context, pattern, 0.02, 0.0);
    mus_drape *drape = scene_drape(context, cloth, 32, 1);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    ck_assert_int_eq(mus_drape_step(drape, 10, 0.5 * mus_drape_step_bound(drape)), MUS_OK);
    mus_drape_destroy(drape);
    support_context_end(context);
}
END_TEST


START_TEST(bad_numbers_are_refused_at_the_door)
{
    mus_context *context = support_context();
    mus_pattern *pattern = scene_square(context, 0.1);
    mus_cloth *cloth = scene_cut(context, pattern, 0.02, 0.0);
    mus_drape_def def;
    mus_drape *drape;
    const struct {
        size_t offset;
        double value;
    } bad[] = {{offsetof(mus_drape_def, gravity), NAN},         {offsetof(mus_drape_def, clearance), -1.0},
               {offsetof(mus_drape_def, friction), -1.0},       {offsetof(mus_drape_def, collision_distance), 0.0},
               {offsetof(mus_drape_def, settle_residual), NAN}, {offsetof(mus_drape_def, drag), -0.1}};
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        mus_drape_def_init(&def, sizeof def);
        memcpy((char *)&def + bad[i].offset, &bad[i].value, sizeof(double));
        ck_assert_int_eq(mus_drape_create(context, cloth, NULL, &def, &drape), MUS_ERR_ARG);
        ck_assert_ptr_null(drape);
    }
    mus_drape_def_init(&def, sizeof def);
    def.size = 3;
    ck_assert_int_eq(mus_drape_create(context, cloth, NULL, &def, &drape), MUS_ERR_VERSION);
    ck_assert_int_eq(mus_drape_create(context, NULL, NULL, NULL, &drape), MUS_ERR_ARG);
    ck_assert_int_eq(mus_drape_create(context, cloth, NULL, NULL, &drape), MUS_OK);
    double *x = calloc(3 * (size_t)mus_drape_node_count(drape), sizeof *x);
    x[4] = NAN;
    const uint64_t before = mus_drape_hash(drape);
    ck_assert_int_eq(mus_drape_set_state(drape, x, NULL), MUS_ERR_ARG);
    ck_assert_uint_eq(mus_drape_hash(drape), before);
    free(x);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


/* one made without contact, self-contact and doubles takes the steps of one made with all, to the bit, and refuses them
 */
START_TEST(a_plain_drape_steps_as_any_other)
{
    mus_context *context = support_context();
    mus_pattern *pattern = scene_square(context, 0.3);
    mus_cloth *cloth = scene_cut(context, pattern, 0.02, 0.02);
    mus_drape *drape[2];
    mus_drape_def def;
    ck_assert_int_eq(mus_drape_create(context, cloth, NULL, NULL, &drape[0]), MUS_OK);
    ck_assert_int_eq(mus_drape_create_plain(context, cloth, NULL, &drape[1]), MUS_OK);
    for (int k = 0; k < 2; k++) {
        ck_assert_int_eq(mus_drape_place(drape[k]), MUS_OK);
        ck_assert_int_eq(mus_drape_pin(drape[k], 0, 1), MUS_OK);
        ck_assert_int_eq(mus_drape_add_plane(drape[k], NULL, NULL), MUS_OK);
        ck_assert_int_eq(mus_drape_step(drape[k], 2000, 0.9 * mus_drape_step_bound(drape[k])), MUS_OK);
    }
    ck_assert_uint_eq(mus_drape_hash(drape[0]), mus_drape_hash(drape[1]));
    for (int k = 0; k < 2; k++) mus_drape_destroy(drape[k]);
    mus_drape_def_init(&def, sizeof def);
    def.precision = 64;
    ck_assert_int_eq(mus_drape_create_plain(context, cloth, &def, &drape[0]), MUS_ERR_ARG);
    ck_assert_ptr_null(drape[0]);
    mus_drape_def_init(&def, sizeof def);
    def.self_contact = 1;
    ck_assert_int_eq(mus_drape_create_plain(context, cloth, &def, &drape[0]), MUS_ERR_ARG);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_drape(void)
{
    Suite *suite = suite_create("drape");
    TCase *tests = tcase_create("drape");
    tcase_set_timeout(tests, 120);
    tcase_add_test(tests, flat_cloth_falls_free_and_unstretched);
    tcase_add_test(tests, a_step_above_the_bound_is_refused_with_the_bound);
    tcase_add_test(tests, below_the_bound_energy_does_not_grow);
    tcase_add_test(tests, a_pinned_node_does_not_move_and_the_rest_hangs_from_it);
    tcase_add_loop_test(tests, sewing_moves_no_centre, 0, 3);
    tcase_add_loop_test(tests, a_seam_closes_and_is_welded, 0, 3);
    tcase_add_test(tests, a_seam_that_cannot_close_is_named_with_its_gap);
    tcase_add_loop_test(tests, the_state_is_the_same_for_any_number_of_threads, 0, 2);
    tcase_add_test(tests, stepping_allocates_nothing_nor_does_a_second_settle);
    tcase_add_test(tests, a_hanging_cloth_comes_to_rest);
    tcase_add_test(tests, a_cloth_beside_the_body_slides_off);
    tcase_add_test(tests, each_failing_allocation_is_a_status);
    tcase_add_test(tests, the_cloth_may_go_before_the_drape);
    tcase_add_test(tests, bad_numbers_are_refused_at_the_door);
    tcase_add_test(tests, a_plain_drape_steps_as_any_other);
    suite_add_tcase(suite, tests);
    return suite;
}
