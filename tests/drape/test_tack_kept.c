/*
 * test_tack_kept.c: tacks stay through sewing, opening and settling, on coarser cuts too, and where memory fails.
 */
#include <stdio.h>

#include "tacked.h"

Suite *mus_suite_tack_kept(void);


/* the first, and one for which there is no room left; what was in stays in. Steps and taking out need no memory */
START_TEST(a_tack_without_memory_leaves_the_drape_as_it_was)
{
    const int32_t have = _i ? 16 : 0; /* there is room for 16 */
    mus_context *context = support_context();
    for (int64_t n = 0;; n++) {
        mus_drape *drape = swung_grid(context, 32, MUS_METHOD_RK4, 1, 0.1);
        for (int32_t i = 0; i < have; i++) tack(drape, i, 400 - i, 10.0);
        const uint64_t hash = mus_drape_hash(drape);
        const double bound = mus_drape_step_bound(drape);
        double *f = kernel_forces(drape);
        int32_t index = -7;
        support_fail_after(n, false);
        const mus_status status = mus_drape_tack(drape, 10, 200, 10.0, &index);
        support_fail_never();
        if (status == MUS_OK) {
            ck_assert_int_eq(index, have);
            ck_assert_int_ge((int)n, 10);
            const int64_t asked = support_allocations();
            for (int i = 0; i < 15 - have; i++) tack(drape, i, 300 + i, 1.0);
            run(drape, 100, 0.5 * mus_drape_step_bound(drape));
            ck_assert_int_eq(mus_drape_untack(drape, have), MUS_OK);
            ck_assert_int_eq((int)(support_allocations() - asked), 0);
            free(f);
            mus_drape_destroy(drape);
            break;
        }
        ck_assert_int_eq(status, MUS_ERR_MEMORY);
        ck_assert_int_eq(index, -7);
        ck_assert_uint_eq(mus_drape_hash(drape), hash);
        ck_assert_double_eq(mus_drape_step_bound(drape), bound);
        double *g = kernel_forces(drape);
        ck_assert_mem_eq(f, g, 3 * NODES * sizeof *f);
        free(f);
        free(g);
        run(drape, 10, 0.5 * bound);
        ck_assert_int_eq(tack(drape, 10, 200, 10.0), have);
        mus_drape_destroy(drape);
    }
    support_context_end(context);
}
END_TEST


/* a node that hangs on a tack rests m g / k below the one that is held */
START_TEST(a_node_hangs_m_g_over_k_below)
{
    const double mass[2] = {0.0, 0.02}, k = 50.0;
    mus_context *context = support_context();
    mus_drape_def def;
    mus_drape_def_init(&def, sizeof def);
    def.precision = 64, def.settle_residual = 1e-7;
    mus_drape *drape = two_nodes(context, mass, 0.1, 1, &def);
    tack(drape, 0, 1, k);
    ck_assert_msg(mus_drape_settle(drape, NULL, NULL) == MUS_OK, "%s", mus_context_error(context));
    const double *x = mus_drape_positions(drape);
    ck_assert_double_eq_tol(x[4], -mass[1] * 9.81 / k, 1e-8);
    ck_assert_double_eq_tol(x[3], 0.0, 1e-6);

    /* another one, and both are there; the settle that follows knows it */
    tack(drape, 1, 0, k);
    ck_assert(!extreme_report(drape).settled);
    ck_assert_msg(mus_drape_settle(drape, NULL, NULL) == MUS_OK, "%s", mus_context_error(context));
    ck_assert_double_eq_tol(x[4], -mass[1] * 9.81 / (2.0 * k), 1e-8);
    mus_drape_destroy(drape);
    support_context_end(context);
}
END_TEST


/* a square that leans a little and is held at its upper corners; corner (4): below left, then round */
static mus_drape *held_square(mus_context *context, const mus_cloth *cloth, const mus_drape_def *def, int32_t *corner)
{
    mus_drape *drape;
    int32_t count;
    const int32_t *border;
    ck_assert_int_eq(mus_drape_create(context, cloth, NULL, def, &drape), MUS_OK);
    ck_assert_int_eq(mus_drape_place(drape), MUS_OK);
    ck_assert_int_eq(mus_cloth_panel_border(cloth, 0, &count, &border), MUS_OK);
    for (int i = 0; i < 4; i++) corner[i] = border[i * count / 4];
    const int32_t n = mus_drape_node_count(drape);
    double *x = malloc(3 * (size_t)n * sizeof *x);
    memcpy(x, mus_drape_positions(drape), 3 * (size_t)n * sizeof *x);
    for (int32_t i = 0; i < n; i++) x[3 * i + 2] -= 0.02 * x[3 * i + 1] + 1e-3 * x[3 * i];
    ck_assert_int_eq(mus_drape_set_state(drape, x, NULL), MUS_OK);
    free(x);
    for (int i = 2; i < 4; i++) ck_assert_int_eq(mus_drape_pin(drape, corner[i], 1), MUS_OK);
    return drape;
}


/* a square that hangs by two corners, the two below tacked to them: on coarser cuts too, so that it comes to rest where
 * it does on the finest alone, with less work */
START_TEST(coarser_cuts_have_the_tacks_too)
{
    mus_context *context = support_context();
    mus_pattern *pattern = scene_square(context, 0.4);
    double low[2], gap[2] = {0.0, 0.0};
    for (int levels = 0; levels < 2; levels++) {
        mus_cloth_def cut;
        mus_cloth *cloth;
        mus_drape_def def;
        int32_t corner[4];
        mus_cloth_def_init(&cut, sizeof cut);
        cut.spacing = 0.01, cut.coarser = levels;
        ck_assert_int_eq(mus_cloth_create(context, pattern, &cut, &cloth), MUS_OK);
        ck_assert_int_eq(cloth->coarse != NULL, levels);
        mus_drape_def_init(&def, sizeof def);
        def.settle_seconds = 30.0;
        mus_drape *drape = held_square(context, cloth, &def, corner);
        tack(drape, corner[0], corner[3], 300.0);
        tack(drape, corner[1], corner[2], 300.0);
        const mus_status status = mus_drape_settle(drape, NULL, NULL);
        ck_assert_msg(status == MUS_OK, "%s", mus_context_error(context));
        if (levels) ck_assert_int_eq(drape->coarse.drape->program.ntack, 2);
        low[levels] = 1e9;
        for (int32_t i = 0; i < drape->n; i++) low[levels] = fmin(low[levels], drape->x[3 * i + 1]);
        for (int i = 0; i < 2; i++) gap[levels] = fmax(gap[levels], gap_of(drape, corner[i], corner[3 - i]));
        printf("tacked square, %d coarser: gaps %.3f mm, lowest %.4f m, %lld evaluations\n", levels, 1e3 * gap[levels],
               low[levels], (long long)extreme_report(drape).spring_evaluations);
        ck_assert_double_lt(gap[levels], 0.002);
        mus_drape_destroy(drape);
        mus_cloth_destroy(cloth);
    }
    ck_assert_double_eq_tol(low[0], low[1], 0.01);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


/* a square of 0.3 m at 2 cm that hangs by its upper corners, its lower ones tacked to them where cloth meets cloth:
 * they come to rest a thickness apart, and nothing crosses */
START_TEST(tacked_cloth_rests_on_cloth)
{
    mus_context *context = support_context();
    mus_pattern *pattern = scene_square(context, 0.3);
    mus_cloth *cloth = scene_cut(context, pattern, 0.02, 0.1);
    mus_drape_def def;
    int32_t corner[4];
    mus_drape_def_init(&def, sizeof def);
    def.self_contact = 1;
    mus_drape *drape = held_square(context, cloth, &def, corner);
    ck_assert_msg(mus_drape_settle(drape, NULL, NULL) == MUS_OK, "%s", mus_context_error(context));
    for (int i = 0; i < 2; i++) tack(drape, corner[i], corner[3 - i], 100.0);
    ck_assert_msg(mus_drape_settle(drape, NULL, NULL) == MUS_OK, "%s", mus_context_error(context));
    int64_t crossings;
    ck_assert_int_eq(mus_drape_crossings(drape, 0, NULL, &crossings), MUS_OK);
    ck_assert_int_eq((int)crossings, 0);
    for (int i = 0; i < 2; i++) {
        const double gap = gap_of(drape, corner[i], corner[3 - i]);
        printf("tacked cloth on cloth: %.2f mm\n", 1e3 * gap);
        ck_assert_double_ge(gap, 0.9 * def.thickness);
        ck_assert_double_le(gap, 2.0 * def.thickness);
    }
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


/* a tack between a worn layer and one that is not sewn yet exerts no force until that layer is sewn */
START_TEST(a_tack_to_a_layer_that_waits_is_slack)
{
    mus_context *context = support_context();
    mus_pattern *pattern = scene_strips(context, 1.0);
    ck_assert_int_eq(mus_pattern_set_layer(pattern, 1, 1), MUS_OK);
    mus_cloth *cloth = scene_cut(context, pattern, 0.02, 0.0);
    mus_drape *drape = scene_drape(context, cloth, 64, 1);
    const int32_t own = drape->program.nspring, *pair = mus_cloth_pairs(cloth);
    ck_assert_int_ne(mus__cloth_layer(cloth, pair[2]), mus__cloth_layer(cloth, pair[3]));
    tack(drape, pair[2], pair[3], 10.0);
    const int32_t inner = mus__cloth_layer(cloth, pair[2]) == 0 ? 2 : 3;
    tack(drape, pair[inner], pair[inner + 2], 10.0);
    ck_assert_int_eq(drape->program.nspring, own + 2);
    drape->program.wait_from = 1;
    mus__program_weld(cloth, NULL, &drape->program);
    ck_assert_int_eq(drape->program.nspring, own + 1);
    ck_assert_int_eq(drape->program.spring[own].a, pair[inner]);
    drape->program.wait_from = 0;
    mus__program_weld(cloth, NULL, &drape->program);
    ck_assert_int_eq(drape->program.nspring, own + 2);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


/* sewing and opening rename what a tack joins; one between the two nodes of a pair is slack while they are one, and
 * another drape does not get it */
START_TEST(a_tack_stays_through_sewing_and_placing)
{
    mus_context *context = support_context();
    mus_pattern *pattern = scene_strips(context, 1.0);
    mus_cloth *cloth = scene_cut(context, pattern, 0.02, 0.0);
    mus_drape *drape = scene_drape(context, cloth, 64, 1), *other = scene_drape(context, cloth, 64, 1);
    const int32_t *pair = mus_cloth_pairs(cloth);
    const int32_t own = drape->program.nspring, far = 0;
    const double open = extreme_report(drape).energy, k = 2.0;
    tack(drape, pair[0], pair[1], k);
    tack(drape, pair[2], far, k);
    const double first = gap_of(drape, pair[0], pair[1]), second = gap_of(drape, pair[2], far);
    ck_assert_int_eq(drape->program.nspring, own + 2);
    ck_assert_double_eq_tol(extreme_report(drape).energy - open, 0.5 * k * (first * first + second * second), 1e-13);
    ck_assert_msg(mus_drape_sew(drape, NULL, NULL) == MUS_OK, "%s", mus_context_error(context));
    ck_assert_int_eq(drape->program.nspring, own + 1);
    const mus__spring *last = &drape->program.spring[own];
    ck_assert(last->kind == MUS__SPRING_TACK && last->a == drape->rep[pair[2]] && last->b == drape->rep[far]);
    const double sewn = extreme_report(drape).energy, gap = gap_of(drape, pair[2], far);
    ck_assert_int_eq(mus_drape_untack(drape, 1), MUS_OK);
    ck_assert_double_eq_tol(sewn - extreme_report(drape).energy, 0.5 * k * gap * gap, 1e-13);
    ck_assert_int_eq(mus_drape_warm(other, drape), MUS_OK);
    ck_assert_int_eq(other->program.ntack, 0);

    /* opened, the first pulls again; the bound is that of a drape that has it from the start */
    ck_assert_int_eq(mus_drape_place(drape), MUS_OK);
    ck_assert_int_eq(mus_drape_place(other), MUS_OK);
    ck_assert_double_eq_tol(extreme_report(drape).energy - open, 0.5 * k * first * first, 1e-13);
    tack(other, pair[0], pair[1], k);
    ck_assert_double_eq(mus_drape_step_bound(drape), mus_drape_step_bound(other));
    run(drape, 20, 0.9 * mus_drape_step_bound(drape));
    run(other, 20, 0.9 * mus_drape_step_bound(other));
    ck_assert_mem_eq(mus_drape_positions(drape), mus_drape_positions(other), 3 * (size_t)drape->n * sizeof(double));
    ck_assert_int_eq(mus_drape_warm(drape, other), MUS_OK);
    ck_assert_int_eq(drape->program.ntack, 1);
    mus_drape_destroy(drape);
    mus_drape_destroy(other);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


/* open seams pull as they did when a tack comes or goes, those that are stitched stay so; the bound knows all of it */
START_TEST(open_seams_do_not_notice_a_tack)
{
    mus_context *context = support_context();
    mus_pattern *pattern = scene_strips(context, 1.0);
    mus_cloth *cloth = scene_cut(context, pattern, 0.02, 0.0);
    mus_drape *drape = scene_drape(context, cloth, 32, 1), *plain = scene_drape(context, cloth, 32, 1);
    const double bound = mus_drape_step_bound(plain);
    const int32_t index = tack(drape, 0, 9, 1e5);
    ck_assert_double_lt(mus_drape_step_bound(drape), bound);
    ck_assert_int_eq(mus_drape_untack(drape, index), MUS_OK);
    ck_assert_double_eq(mus_drape_step_bound(drape), bound);
    run(drape, 200, 0.9 * bound);
    run(plain, 200, 0.9 * bound);
    ck_assert_uint_eq(mus_drape_hash(drape), mus_drape_hash(plain));
    mus_drape_destroy(drape);
    mus_drape_destroy(plain);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


/* a settle that finds no memory for the tacks of its coarser double leaves all as it was, and can be called again */
START_TEST(settle_without_memory_for_tacks_leaves_the_drape_as_it_was)
{
    mus_context *context = support_context();
    mus_pattern *pattern = scene_square(context, 0.3);
    mus_cloth *cloth = scene_cut(context, pattern, 0.01, 0.1);
    mus_drape *drape = scene_drape(context, cloth, 32, 1);
    ck_assert_ptr_nonnull(cloth->coarse);
    ck_assert_int_eq(mus_drape_pin(drape, 0, 1), MUS_OK);
    tack(drape, 5, 700, 20.0);
    const uint64_t hash = mus_drape_hash(drape);
    int64_t refused = 0;
    for (int64_t n = 0;; n++, refused++) {
        support_fail_after(n, false);
        const mus_status status = mus_drape_settle(drape, NULL, NULL);
        support_fail_never();
        if (status != MUS_ERR_MEMORY) break;
        ck_assert_uint_eq(mus_drape_hash(drape), hash);
    }
    ck_assert_int_gt((int)refused, 20);
    ck_assert_int_eq(drape->coarse.drape->program.ntack, 1);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_tack_kept(void)
{
    Suite *suite = suite_create("tack_kept");
    TCase *tests = tcase_create("tack_kept");
    tcase_set_timeout(tests, 60);
    tcase_add_loop_test(tests, a_tack_without_memory_leaves_the_drape_as_it_was, 0, 2);
    tcase_add_test(tests, a_node_hangs_m_g_over_k_below);
    tcase_add_test(tests, coarser_cuts_have_the_tacks_too);
    tcase_add_test(tests, tacked_cloth_rests_on_cloth);
    tcase_add_test(tests, a_tack_to_a_layer_that_waits_is_slack);
    tcase_add_test(tests, a_tack_stays_through_sewing_and_placing);
    tcase_add_test(tests, open_seams_do_not_notice_a_tack);
    tcase_add_test(tests, settle_without_memory_for_tacks_leaves_the_drape_as_it_was);
    suite_add_tcase(suite, tests);
    return suite;
}
