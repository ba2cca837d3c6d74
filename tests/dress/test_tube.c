/*
 * test_tube.c: a tube that is sewn hangs as one that never was open: a skirt without flare, from a
 * waist that is held.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "drape/scenes.h"

Suite *mus_suite_tube(void);

#define TUBE_HALF 0.5
#define TUBE_LENGTH 0.4


/* two panels half a metre wide, rolled round the axis y before and behind, `apart` from where they meet */
static mus_pattern *tube_pattern(mus_context *context, double apart)
{
    const double radius = TUBE_HALF / acos(-1.0);
    mus_pattern *pattern;
    int32_t edge[2][4];
    ck_assert_int_eq(mus_pattern_create(context, "tube", &pattern), MUS_OK);
    for (int i = 0; i < 2; i++) {
        const double side = i == 0 ? 1.0 : -1.0;
        const int32_t panel =
            scene_rectangle(pattern, i == 0 ? "front" : "back", 0.0, 0.0, TUBE_HALF, TUBE_LENGTH, edge[i]);
        mus_placement place;
        mus_placement_init(&place, sizeof place);
        place.bend = radius, place.bend_x = 0.5 * TUBE_HALF;
        place.origin[0] = -0.5 * side * TUBE_HALF, place.origin[1] = 1.0, place.origin[2] = side * (radius + apart);
        place.rotation[0] = place.rotation[8] = side;
        ck_assert_int_eq(mus_pattern_set_placement(pattern, panel, &place), MUS_OK);
    }
    scene_sew(pattern, edge[0][1], edge[1][3], 0.0);
    scene_sew(pattern, edge[0][3], edge[1][1], 0.0);
    return pattern;
}


/* placed; a drape's own copy of its places */
static mus_drape *tube_drape(mus_context *context, double apart, mus_cloth **cloth)
{
    mus_pattern *pattern = tube_pattern(context, apart);
    mus_drape_def def;
    mus_drape *drape;
    *cloth = scene_cut(context, pattern, 0.025, 0.0);
    mus_drape_def_init(&def, sizeof def);
    def.precision = 64;
    def.settle_residual = 0.002;
    ck_assert_int_eq(mus_drape_create(context, *cloth, NULL, &def, &drape), MUS_OK);
    ck_assert_int_eq(mus_drape_place(drape), MUS_OK);
    mus_pattern_destroy(pattern);
    return drape;
}


START_TEST(a_sewn_tube_hangs_as_a_welded_one)
{
    mus_context *context = support_context();
    mus_cloth *cloth[2];
    mus_drape *welded = tube_drape(context, 0.0, &cloth[0]), *sewn = tube_drape(context, 0.03, &cloth[1]);
    const int32_t n = mus_drape_node_count(welded);
    const double *rest = mus_cloth_rest(cloth[0]);
    double *x = malloc(3 * (size_t)n * sizeof *x), most = 0.0, gap = 0.0;
    ck_assert_int_eq(mus_drape_node_count(sewn), n);

    /* the waist of both is the same circle */
    memcpy(x, mus_drape_positions(sewn), 3 * (size_t)n * sizeof *x);
    for (int32_t i = 0; i < n; i++)
        if (fabs(rest[2 * i + 1] - TUBE_LENGTH) < 1e-9)
            memcpy(x + 3 * i, mus_drape_positions(welded) + 3 * i, 3 * sizeof *x);
    ck_assert_int_eq(mus_drape_set_state(sewn, x, NULL), MUS_OK);
    for (int32_t i = 0; i < n; i++)
        if (fabs(rest[2 * i + 1] - TUBE_LENGTH) < 1e-9) {
            ck_assert_int_eq(mus_drape_pin(sewn, i, 1), MUS_OK);
            ck_assert_int_eq(mus_drape_pin(welded, i, 1), MUS_OK);
        }
    mus_drape *both[2] = {welded, sewn};
    for (int k = 0; k < 2; k++) {
        mus_drape_report report;
        mus_drape_report_init(&report, sizeof report);
        mus_drape_report_get(both[k], &report);
        if (k == 0) ck_assert_double_lt(report.max_seam_gap, 1e-12);
        else ck_assert_double_gt(gap = report.max_seam_gap, 0.05);
        ck_assert_msg(mus_drape_sew(both[k], NULL, NULL) == MUS_OK, "%s", mus_context_error(context));
        ck_assert_msg(mus_drape_settle(both[k], NULL, NULL) == MUS_OK, "%s", mus_context_error(context));
    }
    for (int32_t i = 0; i < n; i++) {
        const double *a = mus_drape_positions(welded) + 3 * i, *b = mus_drape_positions(sewn) + 3 * i;
        most = fmax(most, hypot(hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]));
    }
    printf("sewn from %.0f mm apart against welded: %.4f mm\n", 1e3 * gap, 1e3 * most);
    ck_assert_double_lt(most, 0.001);
    free(x);
    for (int k = 0; k < 2; k++) mus_drape_destroy(both[k]), mus_cloth_destroy(cloth[k]);
    support_context_end(context);
}
END_TEST


/* the step of sewing is that of the contact, whatever the fabric; the tube closes in the same way */
START_TEST(sewing_takes_as_many_steps_in_all_fabrics)
{
    mus_context *context = support_context();
    mus_pattern *pattern = tube_pattern(context, 0.03);
    int64_t least = INT64_MAX, most = 0;
    for (int32_t i = 0; i < mus_fabric_count(); i++) {
        mus_fabric fabric;
        mus_cloth_def cut;
        mus_drape_report report;
        mus_cloth *cloth;
        mus_drape *drape;
        mus_fabric_init(&fabric, sizeof fabric);
        ck_assert_int_eq(mus_fabric_find(mus_fabric_name(i), &fabric), MUS_OK);
        mus_cloth_def_init(&cut, sizeof cut);
        cut.fabric = &fabric;
        cut.spacing = 0.025;
        ck_assert_int_eq(mus_cloth_create(context, pattern, &cut, &cloth), MUS_OK);
        ck_assert_int_eq(mus_drape_create(context, cloth, NULL, NULL, &drape), MUS_OK);
        ck_assert_int_eq(mus_drape_place(drape), MUS_OK);
        ck_assert_msg(mus_drape_sew(drape, NULL, NULL) == MUS_OK, "%s", mus_context_error(context));
        mus_drape_report_init(&report, sizeof report);
        mus_drape_report_get(drape, &report);
        least = report.steps < least ? report.steps : least, most = report.steps > most ? report.steps : most;
        mus_drape_destroy(drape);
        mus_cloth_destroy(cloth);
    }
    printf("sewing a tube in %d fabrics: %lld to %lld steps\n", (int)mus_fabric_count(), (long long)least,
           (long long)most);
    ck_assert_int_le(most, 4 * least);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_tube(void)
{
    Suite *suite = suite_create("tube");
    TCase *tests = tcase_create("tube");
    tcase_set_timeout(tests, 60);
    tcase_add_test(tests, a_sewn_tube_hangs_as_a_welded_one);
    tcase_add_test(tests, sewing_takes_as_many_steps_in_all_fabrics);
    suite_add_tcase(suite, tests);
    return suite;
}
