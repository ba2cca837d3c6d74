/*
 * test_diagnosis.c: each reason of the list, made on purpose, with its panel, seam or place.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "drape/scenes.h"
#include "drape/worn.h"


static mus_reason why(const mus_drape *drape)
{
    mus_reason reason;
    mus_reason_init(&reason, sizeof reason);
    ck_assert_int_eq(mus_drape_reason(drape, &reason), MUS_OK);
    return reason;
}


START_TEST(the_list_is_closed_and_named)
{
    for (int32_t i = 0; i < MUS_REASON_COUNT; i++) {
        ck_assert_ptr_nonnull(mus_reason_name(i));
        for (int32_t k = 0; k < i; k++) ck_assert_str_ne(mus_reason_name(i), mus_reason_name(k));
    }
    ck_assert_ptr_null(mus_reason_name(-1));
    ck_assert_ptr_null(mus_reason_name(MUS_REASON_COUNT));
    ck_assert_str_eq(mus_reason_name(MUS_REASON_SLID_OFF), "slid off");
    mus_reason reason;
    memset(&reason, 0, sizeof reason);
    ck_assert_int_eq(mus_drape_reason(NULL, &reason), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_reason(NULL, &reason), MUS_ERR_ARG);
}
END_TEST


START_TEST(seams_that_stay_open_and_cloth_at_rest)
{
    mus_context *context = support_context();
    mus_pattern *pattern = scene_strips(context, 1.0);
    mus_cloth *cloth = scene_cut(context, pattern, 0.02, 0.0);
    mus_drape_def def;
    mus_drape *drape;
    mus_drape_def_init(&def, sizeof def);
    def.sew_seconds = _i == 0 ? 0.2 : 6.0;
    ck_assert_int_eq(mus_drape_create(context, cloth, NULL, &def, &drape), MUS_OK);
    ck_assert_int_eq(mus_drape_place(drape), MUS_OK);
    ck_assert_int_eq(why(drape).kind, MUS_REASON_NONE);
    const int32_t *pairs = mus_cloth_pairs(cloth);
    for (int32_t p = 0; p < mus_cloth_pair_count(cloth) && _i == 0; p++) {
        mus_drape_pin(drape, pairs[2 * p], 1);
        mus_drape_pin(drape, pairs[2 * p + 1], 1);
    }
    const mus_status status = mus_drape_sew(drape, NULL, NULL);
    mus_reason reason = why(drape);
    if (_i == 0) {
        ck_assert_int_eq(status, MUS_ERR_SEW);
        ck_assert_int_eq(reason.kind, MUS_REASON_SEAM_OPEN);
        ck_assert_int_eq(reason.seam, 0);
        ck_assert_double_eq_tol(reason.value, 0.1, 1e-6);
        ck_assert_double_eq_tol(reason.place[1], 1.1, 1e-6);
        ck_assert_ptr_nonnull(strstr(reason.text, "100.0 mm"));
    } else {
        ck_assert_int_eq(status, MUS_OK);
        ck_assert_int_eq(reason.kind, MUS_REASON_NONE);
        mus_drape_pin(drape, pairs[0], 1);
        ck_assert_int_eq(mus_drape_settle(drape, NULL, NULL), MUS_OK);
        ck_assert_int_eq(why(drape).kind, MUS_REASON_SETTLED);
    }
    reason.size = 3;
    ck_assert_int_eq(mus_drape_reason(drape, &reason), MUS_ERR_VERSION);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


/* a T-shirt that hangs below the armpits, or round the head, is not worn: put there, it is told so */
START_TEST(a_shirt_off_the_shoulders_is_told)
{
    const double by = _i == 0 ? -0.25 : 0.7;
    const char *text = _i == 0 ? "below armpit at " : "above armpit at ";
    mus_drape_def def;
    worn w = worn_body("W40");
    worn_put_on_design(&w, "tshirt", NULL);
    w.cloth = scene_cut(w.context, w.pattern, 0.06, 0.0);
    mus_drape_def_init(&def, sizeof def);
    worn_place(&w, &def);
    ck_assert_int_eq(mus_drape_sew(w.drape, NULL, NULL), MUS_OK);

    const int32_t n = mus_drape_node_count(w.drape);
    double *x = malloc(3 * (size_t)n * sizeof *x);
    ck_assert_ptr_nonnull(x);
    memcpy(x, mus_drape_positions(w.drape), 3 * (size_t)n * sizeof *x);
    for (int32_t i = 0; i < n; i++) x[3 * i + 1] += by;
    ck_assert_int_eq(mus_drape_set_state(w.drape, x, NULL), MUS_OK);
    ck_assert_int_eq(mus_drape_settle(w.drape, NULL, NULL), MUS_ERR_UNSETTLED);
    const mus_reason reason = why(w.drape);
    ck_assert_int_eq(reason.kind, MUS_REASON_SLID_OFF);
    ck_assert_msg(strstr(reason.text, text) != NULL, "%s", reason.text);

    free(x);
    worn_end(&w);
}
END_TEST


/* a tube without a hold slides below the hip; with one and no time it is not settled; begun inside, it is tangled */
START_TEST(a_tube_that_fails_says_how)
{
    mus_context *context = support_context();
    mus_body *body = scene_body(context);
    double waist[3];
    mus_body_landmark(body, MUS_LANDMARK_WAIST, waist);
    mus_pattern *pattern = scene_tube(context, waist[1], _i == 0 ? MUS_HOLD_NONE : MUS_HOLD_WAIST, 0.0);
    if (_i == 2) scene_move(pattern, 0, 0.0, waist[1], 0.0);
    mus_cloth *cloth = scene_cut(context, pattern, 0.025, 0.0);
    mus_drape_def def;
    mus_drape *drape;
    mus_drape_def_init(&def, sizeof def);
    if (_i == 1) def.settle_seconds = 0.05, def.settle_residual = 1e-9;
    if (_i == 2) def.sew_seconds = 0.01;
    ck_assert_int_eq(mus_drape_create(context, cloth, body, &def, &drape), MUS_OK);
    ck_assert_int_eq(mus_drape_place(drape), MUS_OK);
    mus_status status = mus_drape_sew(drape, NULL, NULL);
    if (_i < 2) ck_assert_int_eq(status, MUS_OK);
    if (_i < 2) status = mus_drape_settle(drape, NULL, NULL);
    const mus_reason reason = why(drape);
    ck_assert_int_eq(status, _i < 2 ? MUS_ERR_UNSETTLED : MUS_ERR_SEW);
    if (_i == 0) {
        ck_assert_int_eq(reason.kind, MUS_REASON_SLID_OFF);
        ck_assert_msg(strstr(reason.text, "slid off: tube below hip at ") != NULL, "%s", reason.text);
        ck_assert_double_gt(reason.value, 0.1);
        ck_assert_int_ne(reason.panel, MUS_NONE);
    } else if (_i == 1) {
        ck_assert_int_eq(reason.kind, MUS_REASON_NOT_SETTLED);
        ck_assert_int_ne(reason.node, MUS_NONE);
        ck_assert_double_gt(reason.value, 1e-9);
    } else {
        ck_assert_int_eq(reason.kind, MUS_REASON_START_TANGLED);
        ck_assert_int_eq(reason.panel, 0);
        ck_assert_msg(strstr(reason.text, "panel front begins inside the body") != NULL, "%s", reason.text);
    }
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    mus_body_destroy(body);
    support_context_end(context);
}
END_TEST


/* two sheets, one of them upright halfway through the other, both held: they lie still, and are tangled all the same */
static mus_drape *through(mus_context *context, const mus_drape_def *def, mus_cloth **cloth)
{
    mus_pattern *pattern;
    int32_t edge[4];
    mus_drape *drape;
    ck_assert_int_eq(mus_pattern_create(context, "through", &pattern), MUS_OK);
    scene_rectangle(pattern, "sheet", 0.0, 0.0, 0.2, 0.2, edge);
    const int32_t across = scene_rectangle(pattern, "across", -0.05, 0.0, 0.1, 0.1, edge);
    mus_placement place;
    mus_placement_init(&place, sizeof place);
    memset(place.rotation, 0, sizeof place.rotation);
    place.rotation[6] = -1.0, place.rotation[4] = 1.0, place.rotation[2] = 1.0; /* x goes to -z */
    place.origin[0] = 0.107, place.origin[1] = 0.053;
    ck_assert_int_eq(mus_pattern_set_placement(pattern, across, &place), MUS_OK);
    *cloth = scene_cut(context, pattern, 0.02, 0.0);
    ck_assert_msg(mus_drape_create(context, *cloth, NULL, def, &drape) == MUS_OK, "%s", mus_context_error(context));
    ck_assert_int_eq(mus_drape_place(drape), MUS_OK);
    const int32_t *panel = mus_cloth_node_panels(*cloth);
    const double *rest = mus_cloth_rest(*cloth);
    for (int32_t i = 0; i < mus_drape_node_count(drape); i++)
        if (rest[2 * i + 1] == (panel[i] == across ? 0.1 : 0.2)) ck_assert_int_eq(mus_drape_pin(drape, i, 1), MUS_OK);
    mus_pattern_destroy(pattern);
    return drape;
}


START_TEST(cloth_at_rest_through_cloth_is_tangled)
{
    mus_context *context = support_context();
    mus_cloth *cloth;
    mus_drape_def def;
    int64_t count = 0;
    char said[40];
    mus_drape_def_init(&def, sizeof def);
    def.self_contact = 1;
    mus_drape *drape = through(context, &def, &cloth);
    const mus_status status = mus_drape_settle(drape, NULL, NULL);
    ck_assert_msg(status == MUS_OK || status == MUS_ERR_UNSETTLED, "%s", mus_context_error(context));
    const mus_reason reason = why(drape);
    ck_assert_int_eq(mus_drape_crossings(drape, 0, NULL, &count), MUS_OK);
    ck_assert_int_gt(count, 0);
    snprintf(said, sizeof said, "tangled: %d crossings", (int)count);
    ck_assert_int_eq(reason.kind, MUS_REASON_TANGLED);
    ck_assert_int_eq(reason.count, count);
    ck_assert_msg(strncmp(reason.text, said, strlen(said)) == 0 && strstr(reason.text, "across") != NULL, "%s",
                  reason.text);
    ck_assert_int_ne(reason.node, MUS_NONE);
    ck_assert_int_eq(reason.panel, mus_cloth_node_panels(cloth)[reason.node]);
    for (int32_t d = 0; d < 3; d++)
        ck_assert_double_eq(reason.place[d], mus_drape_positions(drape)[3 * reason.node + d]);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    support_context_end(context);
}
END_TEST


/* without memory no garment is called settled, and no pattern well cut */
START_TEST(a_reason_that_finds_no_memory_says_so)
{
    mus_context *context = support_context();
    mus_cloth *cloth;
    mus_pattern *pattern = scene_strips(context, 1.0);
    mus_drape_def def;
    mus_reason reason;
    mus_drape_def_init(&def, sizeof def);
    def.self_contact = 1;
    def.settle_seconds = 0.001;
    mus_status status = MUS_ERR_MEMORY;
    for (int64_t k = 0; status == MUS_ERR_MEMORY; k++) {
        mus_drape *drape = through(context, &def, &cloth);
        support_fail_after(k, false);
        status = mus_drape_settle(drape, NULL, NULL);
        support_fail_never();
        reason = why(drape);
        ck_assert_msg(reason.kind == (status == MUS_ERR_MEMORY ? MUS_REASON_BAD_INPUT : MUS_REASON_TANGLED), "%d %s",
                      (int)k, reason.text);
        mus_drape_destroy(drape);
        mus_cloth_destroy(cloth);
    }
    ck_assert_int_ne(status, MUS_ERR_MEMORY);
    status = MUS_ERR_MEMORY;
    for (int64_t k = 0; status != MUS_OK; k++) {
        mus_reason_init(&reason, sizeof reason);
        reason.count = 77;
        const size_t before = support_live_bytes();
        support_fail_after(k, false);
        status = mus_pattern_reason(pattern, &reason);
        support_fail_never();
        ck_assert(status == MUS_OK || status == MUS_ERR_MEMORY);
        ck_assert_int_eq(reason.count, status == MUS_OK ? 0 : 77);
        ck_assert(support_live_bytes() == before);
    }
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


/* of the pattern alone: a band sewn with a twist, an outline that crosses itself, a seam of unequal sides */
START_TEST(a_pattern_says_why_it_cannot_be_cut)
{
    mus_context *context = support_context();
    mus_pattern *pattern;
    mus_reason reason;
    mus_seam_def seam;
    int32_t edge[4], index;
    ck_assert_int_eq(mus_pattern_create(context, "band", &pattern), MUS_OK);
    scene_rectangle(pattern, "band", 0, 0, 0.5, 0.1, edge);
    mus_reason_init(&reason, sizeof reason);
    ck_assert_int_eq(mus_pattern_reason(pattern, &reason), MUS_OK);
    ck_assert_int_eq(reason.kind, MUS_REASON_NONE);
    if (_i == 0) {
        mus_seam_def_init(&seam, sizeof seam);
        seam.edge_a = edge[1], seam.edge_b = edge[3], seam.direction = MUS_SEAM_DIRECT;
        ck_assert_int_eq(mus_pattern_add_seam(pattern, &seam, &index), MUS_OK);
    } else if (_i == 1) {
        const double at[4][2] = {{0, 0}, {0.2, 0.2}, {0.2, 0}, {0, 0.2}};
        const int32_t along[4] = {1, 1, 1, 1};
        int32_t panel, point[4];
        mus_pattern_add_panel(pattern, "bow", &panel);
        for (int i = 0; i < 4; i++) mus_pattern_add_point(pattern, panel, at[i][0], at[i][1], &point[i]);
        for (int i = 0; i < 4; i++)
            mus_pattern_add_edge(pattern, &(mus_edge_def){.size = sizeof(mus_edge_def), .start = point[i],
                                                          .end = point[(i + 1) % 4]}, &edge[i]);
        ck_assert_int_eq(mus_pattern_set_outline(pattern, panel, 4, edge, along), MUS_OK);
    } else {
        scene_sew(pattern, edge[0], edge[1], 0.0);
    }
    ck_assert_int_eq(mus_pattern_reason(pattern, &reason), MUS_OK);
    static const int32_t kinds[] = {MUS_REASON_TWISTED_SEAM, MUS_REASON_PANEL_CROSSES, MUS_REASON_BAD_INPUT};
    ck_assert_msg(reason.kind == kinds[_i], "%d: %s", (int)reason.kind, reason.text);
    if (_i == 0) ck_assert_int_eq(reason.seam, 0);
    if (_i == 1) ck_assert_int_eq(reason.panel, 1);
    ck_assert_str_ne(reason.text, "");
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_diagnosis(void);


Suite *mus_suite_diagnosis(void)
{
    Suite *suite = suite_create("diagnosis");
    TCase *tests = tcase_create("diagnosis");
    tcase_set_timeout(tests, 60.0);
    tcase_add_test(tests, the_list_is_closed_and_named);
    tcase_add_loop_test(tests, seams_that_stay_open_and_cloth_at_rest, 0, 2);
    tcase_add_loop_test(tests, a_shirt_off_the_shoulders_is_told, 0, 2);
    tcase_add_loop_test(tests, a_tube_that_fails_says_how, 0, 3);
    tcase_add_test(tests, cloth_at_rest_through_cloth_is_tangled);
    tcase_add_test(tests, a_reason_that_finds_no_memory_says_so);
    tcase_add_loop_test(tests, a_pattern_says_why_it_cannot_be_cut, 0, 3);
    suite_add_tcase(suite, tests);
    return suite;
}
