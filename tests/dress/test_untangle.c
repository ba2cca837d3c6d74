/*
 * test_untangle.c: starts that cross are drawn apart, with a certificate or the number that is left; three garments
 * over each other are sewn and fall without a crossing.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "drape/scenes.h"

Suite *mus_suite_untangle(void);


static int64_t crossings(const mus_drape *drape)
{
    int64_t count = -1;
    ck_assert_int_eq(mus_drape_crossings(drape, 0, NULL, &count), MUS_OK);
    return count;
}


/* two free sheets, 4 mm apart */
static mus_drape *two_sheets(mus_context *context, int32_t precision, int32_t self_contact, mus_cloth **cloth)
{
    mus_pattern *pattern;
    int32_t edge[4];
    mus_drape_def def;
    mus_drape *drape;
    ck_assert_int_eq(mus_pattern_create(context, "two", &pattern), MUS_OK);
    scene_rectangle(pattern, "low", 0, 0, 0.4, 0.4, edge);
    scene_move(pattern, scene_rectangle(pattern, "high", 0, 0, 0.36, 0.32, edge), 0.013, 0.017, 0.004);
    *cloth = scene_cut(context, pattern, 0.02, 0.0);
    mus_drape_def_init(&def, sizeof def);
    def.precision = precision;
    def.self_contact = self_contact;
    ck_assert_int_eq(mus_drape_create(context, *cloth, NULL, &def, &drape), MUS_OK);
    ck_assert_int_eq(mus_drape_place(drape), MUS_OK);
    mus_pattern_destroy(pattern);
    return drape;
}


/* bumps of the upper sheet go through the lower one and come back; from then on nothing crosses */
START_TEST(shallow_crossings_are_drawn_apart)
{
    mus_context *context = support_context();
    mus_cloth *cloth;
    mus_drape *drape = two_sheets(context, _i ? 64 : 32, 1, &cloth);
    const int32_t n = mus_drape_node_count(drape), *panel = mus_cloth_node_panels(cloth);
    double *x = malloc(3 * (size_t)n * sizeof *x);
    memcpy(x, mus_drape_positions(drape), 3 * (size_t)n * sizeof *x);
    ck_assert_int_eq(crossings(drape), 0);
    for (int32_t i = 0; i < n; i++) {
        const double u = x[3 * i] - 0.1, v = x[3 * i + 1] - 0.15, w = x[3 * i] - 0.3;
        if (panel[i] == 0) continue;
        x[3 * i + 2] -= 0.007 * exp(-(u * u + v * v) / 0.0012) + 0.006 * exp(-(w * w + v * v) / 0.0009);
    }
    ck_assert_int_eq(mus_drape_set_state(drape, x, NULL), MUS_OK);
    ck_assert_int_gt(crossings(drape), 20);
    int64_t left = -1;
    ck_assert_msg(mus_drape_untangle(drape, &left) == MUS_OK, "%s", mus_context_error(context));
    ck_assert_int_eq(left, 0);
    ck_assert_int_eq(crossings(drape), 0);
    ck_assert_int_eq(mus_drape_step(drape, 500, 0.9 * mus_drape_step_bound(drape)), MUS_OK);
    ck_assert_int_eq(crossings(drape), 0);
    free(x);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    support_context_end(context);
}
END_TEST


/* a sheet halfway through another: the number that is left is that of the count, and is told */
START_TEST(what_stays_tangled_is_counted)
{
    mus_context *context = support_context();
    mus_cloth *cloth;
    mus_drape *drape = two_sheets(context, 32, 1, &cloth);
    const int32_t n = mus_drape_node_count(drape), *panel = mus_cloth_node_panels(cloth);
    double *x = malloc(3 * (size_t)n * sizeof *x);
    memcpy(x, mus_drape_positions(drape), 3 * (size_t)n * sizeof *x);
    for (int32_t i = 0; i < n; i++)
        if (panel[i] == 1) x[3 * i + 2] = x[3 * i] - 0.19, x[3 * i] = 0.2;
    ck_assert_int_eq(mus_drape_set_state(drape, x, NULL), MUS_OK);
    int64_t left = -1;
    const mus_status status = mus_drape_untangle(drape, &left);
    ck_assert_int_eq(left, crossings(drape));
    ck_assert_int_eq(status, left == 0 ? MUS_OK : MUS_ERR_TANGLED);
    if (left > 0) ck_assert_ptr_nonnull(strstr(mus_context_error(context), "cross"));
    ck_assert_int_eq(mus_drape_untangle(drape, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_drape_untangle(NULL, &left), MUS_ERR_ARG);
    free(x);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    drape = two_sheets(context, 32, 0, &cloth);
    ck_assert_int_eq(mus_drape_untangle(drape, &left), MUS_ERR_STATE);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    support_context_end(context);
}
END_TEST


/* another garment `out` farther from the body, in the same layer: all of it is sewn at the same time */
static void put_round(mus_pattern *all, const mus_pattern *garment, double out)
{
    const int32_t first = mus_pattern_panel_count(all);
    ck_assert_int_eq(mus_pattern_join(all, garment, 0), MUS_OK);
    for (int32_t p = first; p < mus_pattern_panel_count(all); p++) {
        mus_placement place;
        mus_placement_init(&place, sizeof place);
        ck_assert_int_eq(mus_pattern_placement(all, p, &place), MUS_OK);
        for (int32_t d = 0; d < 3; d++) place.origin[d] += out * place.rotation[3 * d + 2];
        if (place.bend > 0.0) place.bend += out;
        ck_assert_int_eq(mus_pattern_set_placement(all, p, &place), MUS_OK);
    }
}


/* a skirt under a skirt under a skirt, sewn at the same time, then on their way to rest */
START_TEST(three_garments_over_each_other_never_cross)
{
    mus_context *context = support_context();
    mus_tape *tape;
    mus_body *body;
    mus_pattern *all, *one;
    mus_cloth *cloth;
    mus_drape *drape;
    mus_drape_def def;
    ck_assert_int_eq(mus_tape_create(context, &tape), MUS_OK);
    ck_assert_int_eq(mus_tape_set_size(tape, "W40"), MUS_OK);
    ck_assert_int_eq(mus_body_create(context, tape, NULL, &body), MUS_OK);
    ck_assert_int_eq(mus_pattern_create(context, "layers", &all), MUS_OK);
    for (int32_t k = 0; k < 3; k++) {
        mus_draft_def draft;
        mus_draft_def_init(&draft, sizeof draft);
        draft.ease = 0.06 + 0.06 * k;
        ck_assert_int_eq(mus_design_draft(context, mus_design_find("skirt_plain"), tape, &draft, &one), MUS_OK);
        put_round(all, one, 0.02 * k);
        mus_pattern_destroy(one);
    }
    cloth = scene_cut(context, all, 0.025, 0.02);
    mus_drape_def_init(&def, sizeof def);
    def.self_contact = 1;
    ck_assert_int_eq(mus_drape_create(context, cloth, body, &def, &drape), MUS_OK);
    ck_assert_int_eq(mus_drape_place(drape), MUS_OK);
    ck_assert_int_eq(crossings(drape), 0);
    ck_assert_msg(mus_drape_sew(drape, NULL, NULL) == MUS_OK, "%s", mus_context_error(context));
    ck_assert_int_eq(crossings(drape), 0);
    for (int k = 0; k < 3; k++) {
        ck_assert_int_eq(mus_drape_step(drape, 100, 0.9 * mus_drape_step_bound(drape)), MUS_OK);
        ck_assert_int_eq(crossings(drape), 0);
    }
    mus_drape_report report;
    mus_drape_report_init(&report, sizeof report);
    ck_assert_int_eq(mus_drape_report_get(drape, &report), MUS_OK);
    ck_assert_int_eq(report.seams_closed, report.seams);
    ck_assert_int_gt(report.self_contacts, 100);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(all);
    mus_body_destroy(body);
    mus_tape_destroy(tape);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_untangle(void)
{
    Suite *suite = suite_create("untangle");
    TCase *tests = tcase_create("untangle");
    tcase_set_timeout(tests, 120);
    tcase_add_loop_test(tests, shallow_crossings_are_drawn_apart, 0, SUPPORT_SLOW ? 1 : 2);
    tcase_add_test(tests, what_stays_tangled_is_counted);
    if (!SUPPORT_SLOW) tcase_add_test(tests, three_garments_over_each_other_never_cross);
    suite_add_tcase(suite, tests);
    return suite;
}
