/*
 * test_seams.c: seams of every kind on small patterns: unequal, at a junction, over a dart, laid in pleats, left open,
 * buttoned, and those that cannot be.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "drape/scenes.h"
#include "muslin/exchange.h"
#include "muslin/topology.h"


/* Returns the number of pairs of each node: (nodes), to be freed. */
static int32_t *pair_counts(const mus_cloth *cloth)
{
    int32_t *count = calloc((size_t)mus_cloth_node_count(cloth), sizeof *count);
    const int32_t *pairs = mus_cloth_pairs(cloth);
    for (int32_t i = 0; i < 2 * mus_cloth_pair_count(cloth); i++) count[pairs[i]]++;
    return count;
}


/* sewn in empty space: every seam closed, its nodes in one place */
static mus_drape *sewn(mus_context *context, const mus_cloth *cloth)
{
    mus_drape *drape = scene_drape(context, cloth, 64, 1);
    double *gap = malloc((size_t)(mus_cloth_pair_count(cloth) + 1) * sizeof *gap);
    ck_assert_msg(mus_drape_sew(drape, NULL, NULL) == MUS_OK, "%s", mus_context_error(context));
    mus_drape_report report;
    mus_drape_report_init(&report, sizeof report);
    ck_assert_int_eq(mus_drape_report_get(drape, &report), MUS_OK);
    ck_assert_int_eq(report.seams_closed, report.seams);
    ck_assert_int_eq(mus_drape_gaps(drape, gap), MUS_OK);
    for (int32_t i = 0; i < mus_cloth_pair_count(cloth); i++) ck_assert_double_le(gap[i], 1e-12);
    free(gap);
    return drape;
}


/* a polygon with straight edges, n corners (n x 2), counter-clockwise */
static int32_t polygon(mus_pattern *pattern, const char *name, int32_t n, const double *corner, int32_t *edge)
{
    int32_t panel, point[16], along[16];
    ck_assert_int_eq(mus_pattern_add_panel(pattern, name, &panel), MUS_OK);
    for (int32_t i = 0; i < n; i++)
        ck_assert_int_eq(mus_pattern_add_point(pattern, panel, corner[2 * i], corner[2 * i + 1], &point[i]), MUS_OK);
    for (int32_t i = 0; i < n; i++) {
        along[i] = 1;
        mus_pattern_add_edge(pattern, &(mus_edge_def){.size = sizeof(mus_edge_def), .start = point[i],
                                                      .end = point[(i + 1) % n]}, &edge[i]);
    }
    ck_assert_int_eq(mus_pattern_set_outline(pattern, panel, n, edge, along), MUS_OK);
    return panel;
}


/* S4: 11 nodes would do for one side and 17 for the other: both get 17, each in one pair, at equal relative arc length
 */
START_TEST(unequal_sides_have_partners_all_along)
{
    mus_context *context = support_context();
    mus_pattern *pattern;
    int32_t low[4], high[4], n[2];
    const int32_t *border[2];
    ck_assert_int_eq(mus_pattern_create(context, "unequal", &pattern), MUS_OK);
    scene_move(pattern, scene_rectangle(pattern, "low", 0, 0, 0.10, 0.05, low), 0, 1, 0);
    scene_move(pattern, scene_rectangle(pattern, "high", 0, 0, 0.16, 0.05, high), -0.03, 1.08, 0);
    scene_sew(pattern, low[2], high[0], 0.06);
    mus_cloth *cloth = scene_cut(context, pattern, 0.01, 0.0);
    for (int32_t p = 0; p < 2; p++) mus_cloth_panel_border(cloth, p, &n[p], &border[p]);
    ck_assert_int_eq(n[0], 10 + 5 + 16 + 5);
    ck_assert_int_eq(n[1], 16 + 5 + 16 + 5);
    ck_assert_int_eq(mus_cloth_pair_count(cloth), 17);

    int32_t *count = pair_counts(cloth);
    const int32_t *pairs = mus_cloth_pairs(cloth);
    const double *rest = mus_cloth_rest(cloth);
    for (int32_t k = 0; k < 17; k++) {
        ck_assert_int_eq(count[border[0][15 + k]], 1);
        ck_assert_int_eq(count[border[1][k]], 1);
        const double *a = rest + 2 * pairs[2 * k], *b = rest + 2 * pairs[2 * k + 1];
        ck_assert_double_eq_tol(a[0] / 0.10, b[0] / 0.16, 1e-9);
    }
    free(count);
    mus_drape_destroy(sewn(context, cloth));
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


/*
 * S4: two panels side by side under a third (a T-junction, three panels in one point), and a band over that, whose seam
 * ends at the mouth of a dart of the third.
 */
START_TEST(a_junction_and_a_dart_leave_no_node)
{
    mus_context *context = support_context();
    mus_pattern *pattern;
    int32_t left[4], right[4], yoke[16], band[16];
    const double above[16] = {0.0,  0.0,  0.13, 0.0,  0.30, 0.0,  0.30, 0.10,
                              0.17, 0.10, 0.15, 0.04, 0.13, 0.10, 0.0,  0.10};
    const double strip[10] = {0.0, 0.0, 0.13, 0.0, 0.26, 0.0, 0.26, 0.03, 0.0, 0.03};
    ck_assert_int_eq(mus_pattern_create(context, "junction", &pattern), MUS_OK);
    scene_move(pattern, scene_rectangle(pattern, "left", 0, 0, 0.13, 0.1, left), -0.02, 1, 0);
    scene_move(pattern, scene_rectangle(pattern, "right", 0, 0, 0.17, 0.1, right), 0.15, 1, 0);
    scene_move(pattern, polygon(pattern, "yoke", 8, above, yoke), 0, 1.14, 0);
    scene_move(pattern, polygon(pattern, "band", 5, strip, band), 0.02, 1.28, 0);
    scene_sew(pattern, left[1], right[3], 0.0);
    scene_sew(pattern, left[2], yoke[0], 0.0);
    scene_sew(pattern, right[2], yoke[1], 0.0);
    scene_sew(pattern, yoke[4], yoke[5], 0.0);
    scene_sew(pattern, yoke[3], band[1], 0.0);
    scene_sew(pattern, yoke[6], band[0], 0.0);

    /* V: 4 + 4 + 8 + 5 = 21 points; the seams of the panels join them to 12; E: 21 - 6 seams; chi of a disc */
    mus_topology t;
    mus_topology_init(&t, sizeof t);
    int32_t faults;
    ck_assert_int_eq(mus_pattern_topology(pattern, &t), MUS_OK);
    ck_assert(t.vertices == 12 && t.edges == 15 && t.faces == 4 && t.euler == 1 && t.loops == 1 && t.manifold == 1);
    ck_assert_int_eq(mus_pattern_check(pattern, &faults, NULL), MUS_OK);
    ck_assert_int_eq(faults, 0);
    mus_cloth *cloth = scene_cut(context, pattern, 0.01, 0.0);

    /* a pair for each step of each seam, but for the point of the dart, which is one node */
    ck_assert_int_eq(mus_cloth_pair_count(cloth), 11 + 14 + 18 + 6 + 14 + 14);
    mus_drape *drape = sewn(context, cloth);
    const double *x = mus_drape_positions(drape), *rest = mus_cloth_rest(cloth);
    const int32_t *panel = mus_cloth_node_panels(cloth);

    /* left, right and yoke are one point at the junction; both ends of the mouth and the band at the dart */
    const double *at[3] = {NULL, NULL, NULL}, *mouth[3] = {NULL, NULL, NULL};
    for (int32_t i = 0; i < mus_cloth_node_count(cloth); i++) {
        const double u = rest[2 * i], v = rest[2 * i + 1];
        const int32_t p = panel[i];
        const bool corner = (p == 0 && u == 0.13 && v == 0.1) || (p == 1 && u == 0.0 && v == 0.1) ||
                            (p == 2 && u == 0.13 && v == 0.0);
        if (corner) at[p] = x + 3 * i;
        if (p == 2 && v == 0.1 && (u == 0.13 || u == 0.17)) mouth[u == 0.17] = x + 3 * i;
        if (p == 3 && u == 0.13 && v == 0.0) mouth[2] = x + 3 * i;
    }
    for (int i = 0; i < 3; i++) {
        ck_assert(at[i] != NULL && memcmp(at[i], at[0], 3 * sizeof *x) == 0);
        ck_assert(mouth[i] != NULL && memcmp(mouth[i], mouth[0], 3 * sizeof *x) == 0);
    }
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


/* ten times as long closes; an edge with itself, or one of another pattern, is no seam; a dart is */
START_TEST(odd_seams_close_or_are_refused)
{
    mus_context *context = support_context();
    mus_pattern *pattern;
    int32_t low[4], high[4];
    ck_assert_int_eq(mus_pattern_create(context, "odd", &pattern), MUS_OK);
    scene_move(pattern, scene_rectangle(pattern, "low", 0, 0, 0.06, 0.05, low), 0.27, 1, 0);
    scene_move(pattern, scene_rectangle(pattern, "high", 0, 0, 0.6, 0.06, high), 0, 1.1, 0);
    mus_seam_def seam;
    mus_seam_def_init(&seam, sizeof seam);
    seam.edge_a = seam.edge_b = low[2];
    ck_assert_int_eq(mus_pattern_add_seam(pattern, &seam, NULL), MUS_ERR_ARG);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "cannot be sewn to itself"));
    seam.edge_b = 8;
    ck_assert_int_eq(mus_pattern_add_seam(pattern, &seam, NULL), MUS_ERR_ARG);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "edge 8 is unknown, the pattern has 8"));

    scene_sew(pattern, low[2], high[0], 0.54);
    mus_cloth *cloth = scene_cut(context, pattern, 0.02, 0.0);
    mus_drape_destroy(sewn(context, cloth));
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


/* both edges held, a metre apart */
START_TEST(held_edges_apart_cannot_close)
{
    mus_context *context = support_context();
    mus_pattern *pattern;
    int32_t low[4], high[4];
    ck_assert_int_eq(mus_pattern_create(context, "apart", &pattern), MUS_OK);
    scene_move(pattern, scene_rectangle(pattern, "low", 0, 0, 0.1, 0.1, low), 0, 0.9, 0);
    scene_move(pattern, scene_rectangle(pattern, "high", 0, 0, 0.1, 0.1, high), 0, 2, 0);
    scene_sew(pattern, low[2], high[0], 0.0);
    mus_cloth *cloth = scene_cut(context, pattern, 0.02, 0.0);
    mus_drape *drape = scene_drape(context, cloth, 32, 1);
    const int32_t *pairs = mus_cloth_pairs(cloth);
    for (int32_t i = 0; i < 2 * mus_cloth_pair_count(cloth); i++)
        ck_assert_int_eq(mus_drape_pin(drape, pairs[i], 1), MUS_OK);
    ck_assert_int_eq(mus_drape_sew(drape, NULL, NULL), MUS_ERR_SEW);
    ck_assert_msg(strstr(mus_context_error(context), "cannot close: gap 1.000 m") != NULL, "%s",
                  mus_context_error(context));
    mus_reason why;
    mus_reason_init(&why, sizeof why);
    ck_assert_int_eq(mus_drape_reason(drape, &why), MUS_OK);
    ck_assert_int_eq(why.kind, MUS_REASON_SEAM_OPEN);
    ck_assert_double_eq_tol(why.value, 1.0, 1e-6);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


/* 0 and more than the cell are refused by name; at a thousandth of a millimetre a seam still closes */
START_TEST(collision_distances_have_limits)
{
    mus_context *context = support_context();
    mus_pattern *pattern = scene_strips(context, 1.0);
    mus_cloth *cloth = scene_cut(context, pattern, 0.02, 0.0);
    const double refused[4] = {0.0, 0.021, 0.5, 5.0};
    mus_drape_def def;
    mus_drape *drape;
    mus_drape_def_init(&def, sizeof def);
    for (int i = 0; i < 4; i++) {
        def.collision_distance = refused[i];
        ck_assert_int_eq(mus_drape_create(context, cloth, NULL, &def, &drape), MUS_ERR_ARG);
        ck_assert_ptr_null(drape);
        ck_assert_ptr_nonnull(strstr(mus_context_error(context), "collision_distance"));
    }
    for (int i = 0; i < 2; i++) {
        def.collision_distance = i == 0 ? 1e-6 : 0.02;
        ck_assert_int_eq(mus_drape_create(context, cloth, NULL, &def, &drape), MUS_OK);
        ck_assert_int_eq(mus_drape_place(drape), MUS_OK);
        ck_assert_msg(mus_drape_sew(drape, NULL, NULL) == MUS_OK, "%s", mus_context_error(context));
        mus_drape_destroy(drape);
    }
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


/* a skirt of 0.5 m pleated into a band of 0.3 m: two knife pleats of 0.05 m, or a box of two */
static mus_pattern *pleated(mus_context *context, bool box)
{
    mus_pattern *pattern;
    int32_t band[4], skirt[4], faults;
    const double knife[2] = {0.10, 0.30}, boxed[2] = {0.20, 0.30}, deep[2] = {0.05, 0.05}, facing[2] = {-0.05, 0.05};
    ck_assert_int_eq(mus_pattern_create(context, "pleats", &pattern), MUS_OK);
    scene_move(pattern, scene_rectangle(pattern, "band", 0, 0, 0.3, 0.04, band), 0.1, 1.3, 0);
    scene_move(pattern, scene_rectangle(pattern, "skirt", 0, 0, 0.5, 0.25, skirt), 0, 1, 0);
    scene_sew(pattern, band[0], skirt[2], 0.2);
    ck_assert_msg(mus_pattern_lay_pleats(pattern, skirt[2], 2, box ? boxed : knife, box ? facing : deep) == MUS_OK,
                  "%s", mus_context_error(context));
    ck_assert_int_eq(mus_pattern_check(pattern, &faults, NULL), MUS_OK);
    ck_assert_int_eq(faults, 0);
    mus_placement place;
    mus_placement_init(&place, sizeof place);
    ck_assert_int_eq(mus_pattern_placement(pattern, 1, &place), MUS_OK);
    place.fold = 0.8;
    ck_assert_int_eq(mus_pattern_set_placement(pattern, 1, &place), MUS_OK);
    return pattern;
}


/* a pleat takes twice its depth, to 1 %; the layers lie on one another without a gap */
START_TEST(laid_pleats_take_twice_their_depth)
{
    mus_context *context = support_context();
    mus_pattern *pattern = pleated(context, _i == 1);
    mus_homology h;
    mus_homology_init(&h, sizeof h);
    ck_assert_int_eq(mus_pattern_homology(pattern, 1, &h, NULL, 0), MUS_OK);
    ck_assert(h.betti[0] == 1 && h.betti[1] == 0 && h.betti[2] == 0);

    mus_cloth *cloth = scene_cut(context, pattern, 0.0125, 0.0);
    mus_drape *drape = sewn(context, cloth);
    const double nothing[3] = {0.0, 0.0, 0.0};
    ck_assert_int_eq(mus_drape_set_gravity(drape, nothing), MUS_OK);
    const mus_status status = mus_drape_settle(drape, NULL, NULL);
    ck_assert_msg(status == MUS_OK || status == MUS_ERR_UNSETTLED, "%s", mus_context_error(context));

    /* along the band's lower edge */
    int32_t n;
    const int32_t *border;
    const double *x = mus_drape_positions(drape), *rest = mus_cloth_rest(cloth);
    double length = 0.0;
    ck_assert_int_eq(mus_cloth_panel_border(cloth, 0, &n, &border), MUS_OK);
    for (int32_t i = 0; i < n; i++) {
        const int32_t a = border[i], b = border[(i + 1) % n];
        if (rest[2 * a + 1] == 0.0 && rest[2 * b + 1] == 0.0)
            length += hypot(hypot(x[3 * a] - x[3 * b], x[3 * a + 1] - x[3 * b + 1]), x[3 * a + 2] - x[3 * b + 2]);
    }
    printf("%s pleats: %.4f m of 0.3 m\n", _i == 1 ? "box" : "knife", length);
    ck_assert_double_eq_tol(length, 0.3, 0.003);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


/* a closure done up, left open, on three buttons, and tied */
START_TEST(closures_are_open_or_closed)
{
    mus_context *context = support_context();
    mus_pattern *pattern, *read;
    int32_t left[4], right[4], count;
    char path[512];
    ck_assert_int_eq(mus_pattern_create(context, "closure", &pattern), MUS_OK);
    scene_move(pattern, scene_rectangle(pattern, "left", 0, 0, 0.1, 0.3, left), 0, 1, 0);
    scene_move(pattern, scene_rectangle(pattern, "right", 0, 0, 0.1, 0.3, right), 0.14, 1, 0);
    mus_seam_def seam;
    mus_seam_def_init(&seam, sizeof seam);
    seam.edge_a = left[1], seam.edge_b = right[3];
    seam.open = 1;
    ck_assert_int_eq(mus_pattern_add_seam(pattern, &seam, NULL), MUS_ERR_ARG);
    seam.open = 0, seam.buttons = 3, seam.closure = MUS_CLOSURE_ZIP;
    ck_assert_int_eq(mus_pattern_add_seam(pattern, &seam, NULL), MUS_ERR_ARG);
    seam.closure = MUS_CLOSURE_TIES + 1;
    ck_assert_int_eq(mus_pattern_add_seam(pattern, &seam, NULL), MUS_ERR_ARG);
    static const int32_t kinds[4] = {MUS_CLOSURE_ZIP, MUS_CLOSURE_ZIP, MUS_CLOSURE_BUTTONS, MUS_CLOSURE_TIES};
    seam.closure = kinds[_i], seam.buttons = _i == 2 ? 3 : 0;
    ck_assert_int_eq(mus_pattern_add_seam(pattern, &seam, NULL), MUS_OK);
    ck_assert_int_eq(mus_pattern_open_closures(pattern, _i == 1, &count), MUS_OK);
    ck_assert_int_eq(count, 1);

    /* files keep it */
    support_scratch("closure.json", path, sizeof path);
    ck_assert_int_eq(mus_pattern_write(pattern, path), MUS_OK);
    ck_assert_int_eq(mus_pattern_read(context, path, &read), MUS_OK);
    ck_assert_int_eq(mus_pattern_seam(read, 0, &seam), MUS_OK);
    ck_assert(seam.open == (_i == 1) && seam.buttons == (_i == 2 ? 3 : 0) && seam.laid == 0);
    ck_assert_int_eq(seam.closure, kinds[_i]);

    static const int32_t pairs[4] = {16, 0, 3, 16};
    mus_cloth *cloth = scene_cut(context, read, 0.02, 0.0);
    ck_assert_int_eq(mus_cloth_pair_count(cloth), pairs[_i]);
    mus_drape *drape = sewn(context, cloth);
    const double *rest = mus_cloth_rest(cloth);
    const int32_t *pair = mus_cloth_pairs(cloth);
    static const double button[3] = {0.06, 0.16, 0.26};
    for (int32_t i = 0; i < pairs[_i] && _i == 2; i++)
        ck_assert_double_eq_tol(rest[2 * pair[2 * i] + 1], button[i], 0.011);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(read);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_seams(void);


Suite *mus_suite_seams(void)
{
    Suite *suite = suite_create("seams");
    TCase *tests = tcase_create("seams");
    tcase_set_timeout(tests, 60.0);
    tcase_add_test(tests, unequal_sides_have_partners_all_along);
    tcase_add_test(tests, a_junction_and_a_dart_leave_no_node);
    tcase_add_test(tests, odd_seams_close_or_are_refused);
    tcase_add_test(tests, held_edges_apart_cannot_close);
    tcase_add_test(tests, collision_distances_have_limits);
    tcase_add_loop_test(tests, laid_pleats_take_twice_their_depth, 0, SUPPORT_SLOW ? 1 : 2);
    tcase_add_loop_test(tests, closures_are_open_or_closed, 0, SUPPORT_SLOW ? 1 : 4);
    suite_add_tcase(suite, tests);
    return suite;
}
