/*
 * test_fit.c: what a fit says: strain of a cloth stretched by hand, pressure of a tube on a cylinder (Laplace), lengths
 * round a body.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "drape/drape_state.h"
#include "geom/vec.h"
#include "drape/scenes.h"


/* a cloth drawn out by 3 % along the weft and let in by 2 % along the warp, wherever the grain runs */
START_TEST(strain_is_along_warp_and_weft)
{
    mus_context *context = support_context();
    mus_pattern *pattern = scene_square(context, 0.2);
    const double turn = _i == 0 ? 0.0 : 0.5, warp[2] = {sin(turn), cos(turn)}, weft[2] = {cos(turn), -sin(turn)};
    mus_fit *fit;
    ck_assert_int_eq(mus_pattern_set_grain(pattern, 0, 2.0 * warp[0], 2.0 * warp[1]), MUS_OK);
    mus_cloth *cloth = scene_cut(context, pattern, 0.02, 0.0);
    mus_drape *drape = scene_drape(context, cloth, 64, 1);
    const int32_t n = mus_drape_node_count(drape);
    double *x = malloc(3 * (size_t)n * sizeof *x);
    for (int32_t i = 0; i < n; i++) {
        const double *p = mus_cloth_rest(cloth) + 2 * (ptrdiff_t)i;
        const double s = 0.98 * (p[0] * warp[0] + p[1] * warp[1]), t = 1.03 * (p[0] * weft[0] + p[1] * weft[1]);
        x[3 * i] = s * warp[0] + t * weft[0];
        x[3 * i + 1] = 0.6 * (s * warp[1] + t * weft[1]);
        x[3 * i + 2] = 0.8 * (s * warp[1] + t * weft[1]);
    }
    ck_assert_int_eq(mus_drape_set_state(drape, x, NULL), MUS_OK);
    ck_assert_int_eq(mus_fit_create(drape, NULL, &fit), MUS_OK);
    ck_assert_int_eq(mus_fit_node_count(fit), n);
    ck_assert_int_eq(mus_fit_level_count(fit), 0);
    for (int32_t i = 0; i < n; i++) {
        ck_assert_double_eq_tol(mus_fit_warp(fit)[i], -0.02, 1e-9);
        ck_assert_double_eq_tol(mus_fit_weft(fit)[i], 0.03, 1e-9);
        ck_assert(mus_fit_pressure(fit)[i] == 0.0 && isnan(mus_fit_gap(fit)[i]));
    }
    mus_fit_spread spread;
    mus_fit_spread_init(&spread, sizeof spread);
    ck_assert_int_eq(mus_fit_spread_get(fit, MUS_FIT_STRAIN, &spread), MUS_OK);
    ck_assert_double_eq_tol(spread.p50, 0.03, 1e-9);
    ck_assert_double_eq_tol(spread.mean, 0.03, 1e-9);
    ck_assert_double_eq_tol(spread.area, 0.2 * 0.2, 1e-9);
    ck_assert_int_eq(mus_fit_spread_get(fit, MUS_FIT_GAP, &spread), MUS_OK);
    ck_assert(isnan(spread.p50) && spread.node == MUS_NONE && spread.area == 0.0);
    ck_assert_int_eq(mus_fit_spread_get(fit, 5, &spread), MUS_ERR_ARG);
    spread.size = 8;
    ck_assert_int_eq(mus_fit_spread_get(fit, MUS_FIT_WARP, &spread), MUS_ERR_VERSION);
    free(x);
    mus_fit_destroy(fit);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


/* a strain that grows evenly from 0 to 10 % along a square: percentiles by area are those parts of 10 %, on each mesh;
 * the largest is that of the last row of nodes */
START_TEST(percentiles_are_by_area)
{
    mus_context *context = support_context();
    mus_pattern *pattern = scene_square(context, 0.2);
    mus_cloth *cloth = scene_cut(context, pattern, _i == 0 ? 0.02 : 0.008, 0.0);
    mus_drape *drape = scene_drape(context, cloth, 64, 1);
    const int32_t n = mus_drape_node_count(drape);
    double *x = calloc(3 * (size_t)n, sizeof *x), low = 1e9;
    mus_fit *fit;
    mus_fit_spread spread;
    for (int32_t i = 0; i < n; i++) low = fmin(low, mus_cloth_rest(cloth)[2 * i]);
    for (int32_t i = 0; i < n; i++) {
        const double s = mus_cloth_rest(cloth)[2 * i] - low;
        x[3 * i] = s + 0.25 * s * s, x[3 * i + 1] = mus_cloth_rest(cloth)[2 * i + 1];
    }
    ck_assert_int_eq(mus_drape_set_state(drape, x, NULL), MUS_OK);
    ck_assert_int_eq(mus_fit_create(drape, NULL, &fit), MUS_OK);
    mus_fit_spread_init(&spread, sizeof spread);
    ck_assert_int_eq(mus_fit_spread_get(fit, MUS_FIT_WEFT, &spread), MUS_OK);
    ck_assert_double_eq_tol(spread.p50, 0.05, 0.006);
    ck_assert_double_eq_tol(spread.p95, 0.095, 0.006);
    ck_assert_double_eq_tol(spread.mean, 0.05, 0.002);
    ck_assert_double_le(spread.p99, spread.largest);
    ck_assert_double_eq(spread.largest, mus_fit_weft(fit)[spread.node]);
    free(x);
    mus_fit_destroy(fit);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


#define TUBE_RADIUS 0.1
#define TUBE_CLEAR 0.002
#define TUBE_STRAIN 0.1

/* a cylinder of radius 0.1 m, 0.6 m high */
static mus_body *cylinder(mus_context *context)
{
    double contour[7 * 6];
    for (int i = 0; i < 7; i++)
        memcpy(contour + 6 * i, (double[]){0.1 * i, 0.0, 0.0, TUBE_RADIUS, TUBE_RADIUS, 2.0}, 6 * sizeof *contour);
    mus_limb limb;
    mus_body *body;
    mus_limb_init(&limb, sizeof limb);
    limb.contours = 7, limb.contour = contour;
    limb.pole[0] = -0.02, limb.pole[1] = 0.62;
    ck_assert_int_eq(mus_body_create_limbs(context, 1, &limb, NULL, &body), MUS_OK);
    return body;
}


/* two halves of a tube that is 10 % too narrow for it, rolled round it with room */
static mus_cloth *narrow_tube(mus_context *context, double *tension)
{
    const double girth = 2.0 * MUS_PI * (TUBE_RADIUS + TUBE_CLEAR) / (1.0 + TUBE_STRAIN);
    mus_pattern *pattern;
    mus_cloth_def cut;
    mus_cloth *cloth;
    int32_t edge[2][4];
    ck_assert_int_eq(mus_pattern_create(context, "tube", &pattern), MUS_OK);
    for (int i = 0; i < 2; i++) {
        mus_placement place;
        const double roll = 1.2 * TUBE_RADIUS;
        const int32_t panel = scene_rectangle(pattern, i == 0 ? "front" : "back", -0.25 * girth, 0.0, 0.5 * girth, 0.3,
                                              edge[i]);
        mus_placement_init(&place, sizeof place);
        place.origin[1] = 0.15, place.origin[2] = i == 0 ? roll : -roll;
        place.bend = roll;
        if (i == 1) place.rotation[0] = place.rotation[8] = -1.0;
        ck_assert_int_eq(mus_pattern_set_placement(pattern, panel, &place), MUS_OK);
    }
    scene_sew(pattern, edge[0][1], edge[1][3], 0.0);
    scene_sew(pattern, edge[0][3], edge[1][1], 0.0);
    mus_cloth_def_init(&cut, sizeof cut);
    mus_fabric fabric;
    mus_fabric_init(&fabric, sizeof fabric);
    cut.fabric = &fabric;
    cut.spacing = 0.015;
    fabric.shear = 0.0; /* without diagonals there is no contraction across: tension is stiffness times strain */
    *tension = fabric.stretch[1] * TUBE_STRAIN;
    ck_assert_msg(mus_cloth_create(context, pattern, &cut, &cloth) == MUS_OK, "%s", mus_context_error(context));
    mus_pattern_destroy(pattern);
    return cloth;
}


/* the pressure of a tube is its tension over its radius, p = T / r, within 3 % */
START_TEST(a_tube_on_a_cylinder_presses_by_laplace)
{
    mus_context *context = support_context();
    const double nothing[3] = {0.0, 0.0, 0.0}, r = TUBE_RADIUS + TUBE_CLEAR;
    double tension, sum = 0.0, strain = 0.0;
    int32_t count = 0;
    mus_body *body = cylinder(context);
    mus_cloth *cloth = narrow_tube(context, &tension);
    mus_drape_def def;
    mus_drape *drape;
    mus_fit *fit;
    mus_drape_def_init(&def, sizeof def);
    def.friction = 0.0, def.clearance = TUBE_CLEAR, def.precision = 64, def.settle_seconds = 0.5;
    ck_assert_int_eq(mus_drape_create(context, cloth, body, &def, &drape), MUS_OK);
    ck_assert_int_eq(mus_drape_place(drape), MUS_OK);
    ck_assert_msg(mus_drape_sew(drape, NULL, NULL) == MUS_OK, "%s", mus_context_error(context));
    ck_assert_int_eq(mus_drape_set_gravity(drape, nothing), MUS_OK);

    /* without friction it may still turn and slide as a whole: half a second of drag is rest enough */
    const mus_status status = mus_drape_settle(drape, NULL, NULL);
    ck_assert_msg(status == MUS_OK || status == MUS_ERR_UNSETTLED, "%s", mus_context_error(context));
    ck_assert_int_eq(mus_fit_create(drape, body, &fit), MUS_OK);
    ck_assert_int_eq(mus_fit_level_count(fit), 0);

    /* away from rims and seams every node presses so; over the whole the mean is the same */
    for (int32_t i = 0; i < drape->n; i++) {
        const double *rest = mus_cloth_rest(cloth) + 2 * (ptrdiff_t)i;
        ck_assert_double_eq_tol(mus_fit_gap(fit)[i], TUBE_CLEAR, 2e-4);
        if (rest[1] < 0.03 || rest[1] > 0.27 || fabs(rest[0]) > 0.11) continue;
        ck_assert_double_eq_tol(mus_fit_pressure(fit)[i], tension / r, 0.03 * tension / r);
        sum += mus_fit_pressure(fit)[i];
        strain += mus_fit_weft(fit)[i];
        count++;
    }
    printf("tube: %.1f Pa over %d nodes, T / r %.1f Pa; weft strain %.4f of %.4f\n", sum / count, (int)count,
           tension / r, strain / count, TUBE_STRAIN);
    /* chords of a circle are a little shorter than its arc */
    ck_assert_double_eq_tol(strain / count, TUBE_STRAIN, 0.002);
    mus_fit_destroy(fit);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    mus_body_destroy(body);
    support_context_end(context);
}
END_TEST


/* a tube 1.2 m round, held 5 cm above the waist: its ease at waist and hip, and at no thigh: it goes round both */
START_TEST(ease_is_cloth_less_body_at_each_level)
{
    mus_context *context = support_context();
    mus_body *body = scene_body(context);
    double waist[3];
    mus_body_landmark(body, MUS_LANDMARK_WAIST, waist);
    mus_pattern *pattern = scene_tube(context, waist[1] + 0.05, MUS_HOLD_WAIST, -0.05);
    mus_cloth *cloth = scene_cut(context, pattern, 0.02, 0.0);
    mus_drape *drape;
    mus_fit *fit;
    ck_assert_int_eq(mus_drape_create(context, cloth, body, NULL, &drape), MUS_OK);
    ck_assert_int_eq(mus_drape_place(drape), MUS_OK);
    ck_assert_int_eq(mus_drape_sew(drape, NULL, NULL), MUS_OK);
    ck_assert_int_eq(mus_drape_settle(drape, NULL, NULL), MUS_OK);
    ck_assert_int_eq(mus_fit_create(drape, body, &fit), MUS_OK);
    ck_assert_int_eq(mus_fit_level_count(fit), 2);
    for (int32_t k = 0; k < 2; k++) {
        mus_fit_level level;
        mus_fit_level_init(&level, sizeof level);
        ck_assert_int_eq(mus_fit_level_get(fit, k, &level), MUS_OK);
        ck_assert_int_eq(level.level, k == 0 ? MUS_HOLD_WAIST : MUS_HOLD_HIP);
        ck_assert_int_eq(level.right, MUS_NONE);
        const double girth = mus_body_made(body, k == 0 ? MUS_MEASURE_WAIST : MUS_MEASURE_HIP);
        ck_assert_double_eq(level.body, girth);
        ck_assert_double_eq_tol(level.garment, 1.2, 0.03);
        ck_assert_double_eq_tol(level.worn, level.garment, 0.03);
        ck_assert_double_eq_tol(level.ease, level.garment - girth, 1e-12);
        ck_assert_double_gt(level.gap, 0.001);
    }
    mus_fit_level wrong;
    mus_fit_level_init(&wrong, sizeof wrong);
    ck_assert_int_eq(mus_fit_level_get(fit, 2, &wrong), MUS_ERR_ARG);
    wrong.size = 4;
    ck_assert_int_eq(mus_fit_level_get(fit, 0, &wrong), MUS_ERR_VERSION);
    mus_fit_destroy(fit);
    ck_assert_int_eq(mus_fit_create(NULL, body, &fit), MUS_ERR_ARG);
    ck_assert_ptr_null(fit);
    ck_assert_int_eq(mus_fit_create(drape, body, NULL), MUS_ERR_ARG);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    mus_body_destroy(body);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_fit(void);


Suite *mus_suite_fit(void)
{
    Suite *suite = suite_create("fit");
    TCase *tests = tcase_create("fit");
    tcase_set_timeout(tests, 60.0);
    tcase_add_loop_test(tests, strain_is_along_warp_and_weft, 0, 2);
    tcase_add_loop_test(tests, percentiles_are_by_area, 0, 2);
    tcase_add_test(tests, a_tube_on_a_cylinder_presses_by_laplace);
    tcase_add_test(tests, ease_is_cloth_less_body_at_each_level);
    suite_add_tcase(suite, tests);
    return suite;
}
