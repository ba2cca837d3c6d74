/*
 * test_scene_attachment.c: held edges do not slide down: a wide tube stays at the waist, carried by it, and follows the
 * body; the same tube without a hold falls. Where nothing is held nothing changes.
 */
#include <math.h>
#include <stdlib.h>

#include "drape/drape_state.h"
#include "scenes.h"

#define SPACING 0.025


/* lowest and highest of the tube's waist nodes */
static void waist_span(const mus_drape *drape, double *low, double *high)
{
    const mus_cloth *cloth = drape->cloth;
    *low = 1e9, *high = -1e9;
    for (int32_t i = 0; i < drape->n; i++) {
        if (cloth->rest[2 * i + 1] < -1e-9) continue;
        *low = fmin(*low, drape->x[3 * i + 1]);
        *high = fmax(*high, drape->x[3 * i + 1]);
    }
}


static mus_drape *make_drape(mus_context *context, const mus_body *body, double waist, int32_t level, double below,
                             mus_cloth **cloth)
{
    mus_pattern *pattern = scene_tube(context, waist, level, below);
    mus_drape *drape;
    mus_drape_def def;
    *cloth = scene_cut(context, pattern, SPACING, 0.0);
    mus_drape_def_init(&def, sizeof def);
    ck_assert_int_eq(mus_drape_create(context, *cloth, body, &def, &drape), MUS_OK);
    ck_assert_int_eq(mus_drape_place(drape), MUS_OK);
    mus_pattern_destroy(pattern);
    return drape;
}


START_TEST(a_held_waist_stays_and_carries_the_garment)
{
    mus_context *context = support_context();
    mus_body *body = scene_body(context);
    mus_cloth *cloth;
    double waist[3], low, high;
    ck_assert_int_eq(mus_body_landmark(body, MUS_LANDMARK_WAIST, waist), MUS_OK);

    /* started 3 cm below what holds it, 2 cm below the waist: sewing lifts it there */
    mus_drape *drape = make_drape(context, body, waist[1] - 0.05, MUS_HOLD_WAIST, 0.02, &cloth);
    ck_assert_int_eq(mus_drape_sew(drape, NULL, NULL), MUS_OK);

    /* of nine starts a millimetre apart one drifts by 2.1 mm/s still when its time is over: it goes on */
    if (mus_drape_settle(drape, NULL, NULL) != MUS_OK)
        ck_assert_msg(mus_drape_settle(drape, NULL, NULL) == MUS_OK, "%s", mus_context_error(context));
    waist_span(drape, &low, &high);
    ck_assert_double_gt(low, waist[1] - 0.02 - 0.003);
    ck_assert_double_lt(low, waist[1] - 0.02 + 0.003);

    /* the attachments carry the part of the weight that the skin does not: more than 0, at most all of it */
    const double weight = 9.81 * mus_cloth_mass(cloth);
    double pull = 0.0;
    for (int32_t i = 0; i < drape->program.nattachment; i++) {
        const mus__attachment *held = &drape->program.attachment[i];
        pull += held->k * fmax(0.0, waist[1] - held->below - drape->x[3 * held->node + 1]);
    }
    ck_assert_double_gt(pull, 0.2 * weight);
    ck_assert_double_lt(pull, 1.05 * weight);

    /* it is at rest for a step by hand too */
    double before = low;
    ck_assert_int_eq(mus_drape_step(drape, 200, 0.9 * mus_drape_step_bound(drape)), MUS_OK);
    waist_span(drape, &low, &high);
    ck_assert_double_eq_tol(low, before, 0.002);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    mus_body_destroy(body);
    support_context_end(context);
}
END_TEST


START_TEST(without_a_hold_the_same_tube_slides_down)
{
    mus_context *context = support_context();
    mus_body *body = scene_body(context);
    mus_cloth *cloth;
    double waist[3], low, high;
    mus_body_landmark(body, MUS_LANDMARK_WAIST, waist);
    mus_drape *drape = make_drape(context, body, waist[1], MUS_HOLD_NONE, 0.0, &cloth);
    ck_assert_int_eq(drape->program.nattachment, 0);
    ck_assert_int_eq(mus_drape_sew(drape, NULL, NULL), MUS_OK);
    mus_drape_settle(drape, NULL, NULL);
    waist_span(drape, &low, &high);
    ck_assert_double_lt(low, waist[1] - 0.1);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    mus_body_destroy(body);
    support_context_end(context);
}
END_TEST


START_TEST(a_hold_moves_with_the_body)
{
    mus_context *context = support_context();
    mus_body *body = scene_body(context);
    mus_cloth *cloth;
    mus_pose pose;
    double waist[3], low, high;
    mus_body_landmark(body, MUS_LANDMARK_WAIST, waist);
    mus_drape *drape = make_drape(context, body, waist[1], MUS_HOLD_WAIST, 0.0, &cloth);
    const double at = drape->program.level[MUS_HOLD_WAIST][0].at;
    ck_assert_double_eq_tol(at, waist[1], 1e-9);
    ck_assert_int_eq(mus_drape_sew(drape, NULL, NULL), MUS_OK);
    ck_assert_int_eq(mus_drape_settle(drape, NULL, NULL), MUS_OK);

    /* lifted by 3 cm in half a second: the tube goes along */
    mus_pose_init(&pose, sizeof pose);
    ck_assert_int_eq(mus_drape_body_pose(drape, &pose), MUS_OK);
    pose.place[1] += 0.03;
    ck_assert_int_eq(mus_drape_pose_body(drape, &pose, 0.5), MUS_OK);
    const double h = 0.9 * mus_drape_step_bound(drape);
    ck_assert_int_eq(mus_drape_step(drape, (int32_t)(0.6 / h), h), MUS_OK);
    ck_assert_double_eq_tol(drape->program.level[MUS_HOLD_WAIST][0].at, at + 0.03, 1e-6);
    ck_assert_int_eq(mus_drape_settle(drape, NULL, NULL), MUS_OK);
    waist_span(drape, &low, &high);
    ck_assert_double_gt(low, waist[1] + 0.03 - 0.003);

    /* back as it was */
    ck_assert_int_eq(mus_drape_place(drape), MUS_OK);
    ck_assert_double_eq_tol(drape->program.level[MUS_HOLD_WAIST][0].at, at, 1e-12);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    mus_body_destroy(body);
    support_context_end(context);
}
END_TEST


/* the kernels' force is the plain one, in both precisions, below and above the cap */
START_TEST(kernels_pull_as_the_plain_form_does)
{
    mus_context *context = support_context();
    mus_body *body = scene_body(context);
    mus_cloth *cloth;
    double waist[3];
    mus_body_landmark(body, MUS_LANDMARK_WAIST, waist);
    mus_drape *drape = make_drape(context, body, waist[1] - (_i == 0 ? 0.002 : 0.05), MUS_HOLD_WAIST, 0.0, &cloth);
    double *plain = malloc(6 * (size_t)drape->n * sizeof *plain), *made = plain + 3 * (size_t)drape->n, most = 0.0;
    mus_drape_forces(drape, plain);
    drape->program.seam_pull = 0.0;
    drape->sim.ops->force(&drape->sim);
    drape->sim.ops->get_force(&drape->sim, made);
    for (int32_t i = 0; i < drape->program.nattachment; i++) {
        const int32_t node = drape->program.attachment[i].node;
        for (int32_t d = 0; d < 3; d++) {
            const double gravity = d == 1 ? -9.81 * drape->mass[node] : 0.0;
            ck_assert_double_eq_tol(plain[3 * node + d] - gravity, made[3 * node + d], 2e-3);
        }
        most = fmax(most, made[3 * node + 1]);
    }
    ck_assert_double_eq_tol(most, _i == 0 ? 2e4 * SPACING * 0.002 : 100.0 * SPACING, 0.1);
    free(plain);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    mus_body_destroy(body);
    support_context_end(context);
}
END_TEST


/* without a body nothing is held, whatever level is named: bit for bit. (The cloth has a facing at the edge all the
 * same, which a hold asks for.) */
START_TEST(a_hold_that_finds_no_level_holds_nothing)
{
    mus_context *context = support_context();
    uint64_t hash[2];
    for (int32_t k = 0; k < 2; k++) {
        mus_cloth *cloth;
        mus_drape *drape = make_drape(context, NULL, 1.0, k == 0 ? MUS_HOLD_HIP : MUS_HOLD_WAIST, 0.0, &cloth);
        ck_assert_int_eq(drape->program.nattachment, 0);
        ck_assert_int_eq(mus_drape_step(drape, 50, 0.5 * mus_drape_step_bound(drape)), MUS_OK);
        hash[k] = mus_drape_hash(drape);
        mus_drape_destroy(drape);
        mus_cloth_destroy(cloth);
    }
    ck_assert(hash[0] == hash[1]);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_scene_attachment(void);


Suite *mus_suite_scene_attachment(void)
{
    Suite *suite = suite_create("scene_attachment");
    TCase *tests = tcase_create("scene_attachment");
    tcase_set_timeout(tests, 60.0);
    tcase_add_test(tests, a_held_waist_stays_and_carries_the_garment);
    tcase_add_test(tests, without_a_hold_the_same_tube_slides_down);
    tcase_add_test(tests, a_hold_moves_with_the_body);
    tcase_add_loop_test(tests, kernels_pull_as_the_plain_form_does, 0, 2);
    tcase_add_test(tests, a_hold_that_finds_no_level_holds_nothing);
    suite_add_tcase(suite, tests);
    return suite;
}
