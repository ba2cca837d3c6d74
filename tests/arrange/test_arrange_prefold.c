/*
 * test_arrange_prefold.c: panels that fan out wide start folded where cloth is to meet cloth: without strain, without a
 * crossing, their sides side by side below; other panels start where they were.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "arrange/arrange_check.h"
#include "drape/drape_state.h"
#include "drape/scenes.h"
#include "geom/vec.h"
#include "sim/force_reference.h"

Suite *mus_suite_arrange_prefold(void);

#define ARC 24

/* part of a ring round (0, 0), `angle` wide about the way down, from radius `inner` to `outer`, whose inner edge is an
 * arc or, with `straight`, its chord; edge (3) gets its sides, both outward, and a part of its hem */
static int32_t flare_ring(mus_pattern *pattern, const char *name, double angle, double inner, double outer,
                          bool straight, int32_t *edge)
{
    int32_t panel, point[2 * ARC + 2], all[2 * ARC + 2], forward[2 * ARC + 2];
    const int32_t n = 2 * ARC + 2;
    ck_assert_int_eq(mus_pattern_add_panel(pattern, name, &panel), MUS_OK);
    for (int32_t i = 0; i < n; i++) {
        const double part = (double)(i <= ARC ? i : n - 1 - i) / ARC - 0.5;
        const double chord = inner * cos(0.5 * angle) / cos(part * angle);
        const double r = i <= ARC ? outer : straight ? chord : inner;
        const double x = r * sin(part * angle), y = -r * cos(part * angle);
        ck_assert_int_eq(mus_pattern_add_point(pattern, panel, x, y, &point[i]), MUS_OK);
        forward[i] = 1;
    }
    for (int32_t i = 0; i < n; i++)
        ck_assert_int_eq(mus_pattern_add_edge(pattern, &(mus_edge_def){.size = sizeof(mus_edge_def),
                                                                       .start = point[i],
                                                                       .end = point[(i + 1) % n]}, &all[i]),
                         MUS_OK);
    ck_assert_int_eq(mus_pattern_set_outline(pattern, panel, n, all, forward), MUS_OK);
    edge[0] = all[ARC], edge[1] = all[n - 1], edge[2] = all[ARC / 2];
    return panel;
}


/* a skirt of a front and a back, flat, 0.4 m apart, its middle at x = `aside`, sewn at its sides, with `hem` at its hem
 * too; with self_contact */
static mus_drape *flare_skirt(mus_context *context, double angle, double inner, double outer, bool straight,
                              double aside, bool hem)
{
    mus_pattern *pattern;
    mus_drape_def def;
    mus_drape *drape;
    int32_t edge[2][3];
    ck_assert_int_eq(mus_pattern_create(context, "skirt", &pattern), MUS_OK);
    for (int32_t i = 0; i < 2; i++) {
        const int32_t panel = flare_ring(pattern, i == 0 ? "front" : "back", angle, inner, outer, straight, edge[i]);
        mus_placement place;
        mus_placement_init(&place, sizeof place);
        place.origin[0] = aside, place.origin[1] = 1.0, place.origin[2] = i == 0 ? 0.2 : -0.2;
        if (i == 1) place.rotation[0] = place.rotation[8] = -1.0;
        ck_assert_int_eq(mus_pattern_set_placement(pattern, panel, &place), MUS_OK);
    }
    scene_sew(pattern, edge[0][0], edge[1][1], 0.0);
    scene_sew(pattern, edge[0][1], edge[1][0], 0.0);
    if (hem) scene_sew(pattern, edge[0][2], edge[1][2], 0.0);
    mus_cloth *cloth = scene_cut(context, pattern, 0.015, 0.0);
    mus_pattern_destroy(pattern);
    mus_drape_def_init(&def, sizeof def);
    def.self_contact = 1;
    ck_assert_msg(mus_drape_create(context, cloth, NULL, &def, &drape) == MUS_OK, "%s", mus_context_error(context));
    mus_cloth_destroy(cloth);
    ck_assert_int_eq(mus_drape_place(drape), MUS_OK);
    return drape;
}


/* folds the fans of a skirt: no spring is longer or shorter by more than `strain`, no cloth goes through cloth */
static void fold_fans(mus_drape *drape, double strain)
{
    int64_t crossings = -1;
    const mus__placed_cloth placed = mus__drape_placed(drape);
    ck_assert(mus__arrange_fans(&placed));
    mus__drape_push(drape);
    mus__drape_publish(drape);
    ck_assert_double_le(mus__program_strain(&drape->program, drape->x), strain);
    ck_assert_int_eq(mus_drape_crossings(drape, 0, NULL, &crossings), MUS_OK);
    ck_assert_int_eq(crossings, 0);
}


/* half circles and more: no spring is 3 % longer or shorter (a fold's curve is 15 mm chords), all is below the middle
 * of the waist by 30 degrees at least, no cloth through cloth */
START_TEST(wide_fans_hang_folded)
{
    static const double angles[] = {2.0, MUS_PI, 4.5};
    mus_context *context = support_context();
    mus_drape *drape = flare_skirt(context, angles[_i], 0.12, 0.7, false, 0.0, false);
    fold_fans(drape, 0.03);
    for (int32_t i = 0; i < drape->n; i++) {
        const double *x = drape->x + 3 * i;
        ck_assert_double_le(x[1] - 1.0, -0.5 * fabs(x[0]));
        ck_assert_double_ge(fabs(x[2]), 0.2 - 1e-6);
    }
    mus_drape_destroy(drape);
    support_context_end(context);
}
END_TEST


/* flounces of one leg, with an arc or a straight edge along it: they hang on its side of the middle plane */
START_TEST(fans_of_a_leg_stay_on_its_side)
{
    mus_context *context = support_context();
    const double aside = _i % 2 == 0 ? 0.15 : -0.15;
    mus_drape *drape = flare_skirt(context, 2.5, 0.155, 0.42, _i > 1, aside, false);
    fold_fans(drape, 0.05);
    for (int32_t i = 0; i < drape->n; i++) ck_assert_double_ge(drape->x[3 * i] * aside, -1e-9);
    mus_drape_destroy(drape);
    support_context_end(context);
}
END_TEST


/* a fan that is not wide, a waistband of a full circle, a fan whose hem is sewn: they stay, to the bit */
START_TEST(others_start_flat)
{
    mus_context *context = support_context();
    static const double angle[] = {1.5, MUS_PI, MUS_PI}, inner[] = {0.12, 0.5, 0.12}, outer[] = {0.7, 0.55, 0.7};
    mus_drape *drape = flare_skirt(context, angle[_i], inner[_i], outer[_i], false, 0.0, _i == 2);
    double *was = malloc(3 * (size_t)drape->n * sizeof *was);
    memcpy(was, drape->x, 3 * (size_t)drape->n * sizeof *was);
    const mus__placed_cloth placed = mus__drape_placed(drape);
    ck_assert(!mus__arrange_fans(&placed));
    ck_assert_mem_eq(was, drape->x, 3 * (size_t)drape->n * sizeof *was);
    free(was);
    mus_drape_destroy(drape);
    support_context_end(context);
}
END_TEST


/* a seam whose edges lie on two sides of the body, with one way of sewing: it is reported open after half the time */
START_TEST(one_try_is_one)
{
    mus_context *context = support_context();
    double time[2];
    for (int32_t once = 0; once < 2; once++) {
        mus_drape *drape = flare_skirt(context, MUS_PI, 0.12, 0.7, false, 0.0, false), *own;
        mus_drape_def def;
        mus_drape_def_init(&def, sizeof def);
        def.sew_once = once;
        def.sew_seconds = 0.2;
        mus_body *body = scene_body(context);
        ck_assert_int_eq(mus_drape_create(context, drape->cloth, body, &def, &own), MUS_OK);
        mus_body_destroy(body);
        ck_assert_int_eq(mus_drape_place(own), MUS_OK);
        ck_assert_int_eq(mus_drape_sew(own, NULL, NULL), MUS_ERR_SEW);
        ck_assert_ptr_nonnull(strstr(mus_context_error(context), "cannot close"));
        time[once] = own->counters.sew_time;
        mus_drape_destroy(own);
        mus_drape_destroy(drape);
    }
    ck_assert_double_gt(time[0], 1.5 * time[1]);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_arrange_prefold(void)
{
    Suite *suite = suite_create("arrange_prefold");
    TCase *tests = tcase_create("arrange_fan");
    tcase_set_timeout(tests, 60);
    tcase_add_loop_test(tests, wide_fans_hang_folded, 0, 3);
    tcase_add_loop_test(tests, fans_of_a_leg_stay_on_its_side, 0, 4);
    tcase_add_loop_test(tests, others_start_flat, 0, 3);
    tcase_add_test(tests, one_try_is_one);
    suite_add_tcase(suite, tests);
    return suite;
}
