/*
 * test_arrange_nodes.c: where panels are put before they are sewn: layers and folds lie on a panel's right side, which
 * is that of its plane's normal or, where the outline runs clockwise (as GarmentCode draws), the other one.
 */
#include <math.h>

#include "drape/scenes.h"

Suite *mus_suite_arrange_nodes(void);


/* a rectangle w x h from the origin whose outline runs clockwise; edge (4) gets left, top, right, bottom */
static int32_t clockwise(mus_pattern *pattern, double w, double h, int32_t *edge)
{
    const double corner[4][2] = {{0.0, 0.0}, {0.0, h}, {w, h}, {w, 0.0}};
    const int32_t forward[4] = {1, 1, 1, 1};
    int32_t panel, point[4];
    ck_assert_int_eq(mus_pattern_add_panel(pattern, "back to front", &panel), MUS_OK);
    for (int i = 0; i < 4; i++)
        ck_assert_int_eq(mus_pattern_add_point(pattern, panel, corner[i][0], corner[i][1], &point[i]), MUS_OK);
    for (int i = 0; i < 4; i++)
        mus_pattern_add_edge(
            pattern, &(mus_edge_def){.size = sizeof(mus_edge_def), .start = point[i], .end = point[(i + 1) % 4]},
            &edge[i]);
    ck_assert_int_eq(mus_pattern_set_outline(pattern, panel, 4, edge, forward), MUS_OK);
    return panel;
}


/* a panel in layer 1 begins 2 cm off its place on its right side; one that is rolled round what is behind it stays a
 * part of a cylinder about the same axis, one that is rolled the other way keeps its radius */
START_TEST(a_layer_begins_on_the_right_side)
{
    static const double bends[] = {0.0, 0.1, -0.1};
    const bool other = _i % 2 == 1;
    const double bend = bends[_i / 2], side = other ? -1.0 : 1.0;
    mus_context *context = support_context();
    mus_pattern *pattern;
    mus_placement place;
    mus_drape *drape;
    int32_t edge[4];
    ck_assert_int_eq(mus_pattern_create(context, "panel", &pattern), MUS_OK);
    const int32_t panel =
        other ? clockwise(pattern, 0.2, 0.1, edge) : scene_rectangle(pattern, "as drawn", 0.0, 0.0, 0.2, 0.1, edge);
    mus_placement_init(&place, sizeof place);
    place.bend = bend, place.bend_x = 0.1;
    ck_assert_int_eq(mus_pattern_set_placement(pattern, panel, &place), MUS_OK);
    ck_assert_int_eq(mus_pattern_set_layer(pattern, panel, 1), MUS_OK);
    mus_cloth *cloth = scene_cut(context, pattern, 0.02, 0.0);
    ck_assert_int_eq(mus_drape_create(context, cloth, NULL, NULL, &drape), MUS_OK);
    ck_assert_int_eq(mus_drape_place(drape), MUS_OK);
    const double *x = mus_drape_positions(drape), *rest = mus_cloth_rest(cloth);
    for (int32_t i = 0; i < mus_drape_node_count(drape); i++) {
        const double radius = fabs(bend) + (side * bend > 0.0 ? 0.02 : 0.0);
        ck_assert_double_eq_tol(x[3 * i + 1], rest[2 * i + 1], 1e-7);
        if (bend == 0.0)
            ck_assert_double_eq_tol(x[3 * i + 2], side * 0.02, 1e-7);
        else
            ck_assert_double_eq_tol(hypot(x[3 * i] - 0.1, x[3 * i + 2] - side * 0.02 + copysign(radius, bend)), radius,
                                    1e-7);
    }
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


/* a pleat's inner fold lies behind its outer one */
START_TEST(a_pleat_begins_with_its_fold_behind)
{
    const double outer = 0.12, deep = 0.05;
    mus_context *context = support_context();
    mus_pattern *pattern;
    mus_placement place;
    mus_drape *drape;
    int32_t edge[4], band[4];
    ck_assert_int_eq(mus_pattern_create(context, "pleat", &pattern), MUS_OK);
    const int32_t panel =
        _i == 1 ? clockwise(pattern, 0.4, 0.1, edge) : scene_rectangle(pattern, "as drawn", 0.0, 0.0, 0.4, 0.1, edge);
    const int32_t above = scene_rectangle(pattern, "band", 0.0, 0.0, 0.3, 0.04, band);
    scene_move(pattern, above, 0.0, 0.2, 0.0);
    scene_sew(pattern, band[0], edge[_i == 1 ? 1 : 2], 0.1);
    ck_assert_msg(mus_pattern_lay_pleats(pattern, edge[_i == 1 ? 1 : 2], 1, &outer, &deep) == MUS_OK, "%s",
                  mus_context_error(context));
    mus_placement_init(&place, sizeof place);
    place.fold = 1.0;
    ck_assert_int_eq(mus_pattern_set_placement(pattern, panel, &place), MUS_OK);
    mus_cloth *cloth = scene_cut(context, pattern, 0.0125, 0.0);
    ck_assert_int_eq(mus_drape_create(context, cloth, NULL, NULL, &drape), MUS_OK);
    ck_assert_int_eq(mus_drape_place(drape), MUS_OK);

    /* heights over the plane: from -12 mm at the inner fold to 0 at the outer one, on the right side */
    const double *x = mus_drape_positions(drape);
    double low = 0.0, high = 0.0;
    for (int32_t i = 0; i < mus_drape_node_count(drape); i++) {
        if (mus_cloth_node_panels(cloth)[i] != panel) continue;
        low = fmin(low, x[3 * i + 2]), high = fmax(high, x[3 * i + 2]);
    }
    ck_assert_double_eq_tol(_i == 1 ? low : -high, 0.0, 1e-7);
    ck_assert_double_gt(_i == 1 ? high : -low, 0.010);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_arrange_nodes(void)
{
    Suite *suite = suite_create("arrange_nodes");
    TCase *tests = tcase_create("arrange_nodes");
    tcase_add_loop_test(tests, a_layer_begins_on_the_right_side, 0, 6);
    tcase_add_loop_test(tests, a_pleat_begins_with_its_fold_behind, 0, 2);
    suite_add_tcase(suite, tests);
    return suite;
}
