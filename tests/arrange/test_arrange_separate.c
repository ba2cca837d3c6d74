/*
 * test_arrange_separate.c: panels that begin over each other in one plane are told apart before they are sewn with
 * self_contact; the last pairs of a seam are welded where cloth holds them apart, not where they are held.
 */
#include <math.h>

#include "drape/scenes.h"

Suite *mus_suite_arrange_separate(void);


/* a tube of two panels 0.3 m wide, its left side at x, before and behind */
static void apart_tube(mus_pattern *pattern, const char *front, const char *back, double x, double y)
{
    int32_t edge[2][4];
    for (int i = 0; i < 2; i++) {
        const int32_t panel = scene_rectangle(pattern, i == 0 ? front : back, -0.15, 0, 0.3, 0.2, edge[i]);
        mus_placement place;
        mus_placement_init(&place, sizeof place);
        place.origin[0] = x + 0.15, place.origin[1] = y, place.origin[2] = i == 0 ? 0.1 : -0.1;
        if (i == 1) place.rotation[0] = place.rotation[8] = -1.0;
        ck_assert_int_eq(mus_pattern_set_placement(pattern, panel, &place), MUS_OK);
    }
    scene_sew(pattern, edge[0][1], edge[1][3], 0.0);
    scene_sew(pattern, edge[0][3], edge[1][1], 0.0);
}


/* middle of a panel's nodes */
static void apart_middle(const mus_drape *drape, const mus_cloth *cloth, int32_t panel, double *middle)
{
    const int32_t *of = mus_cloth_node_panels(cloth);
    const double *x = mus_drape_positions(drape);
    int32_t count = 0;
    middle[0] = middle[1] = middle[2] = 0.0;
    for (int32_t i = 0; i < mus_drape_node_count(drape); i++) {
        if (of[i] != panel) continue;
        for (int32_t d = 0; d < 3; d++) middle[d] += x[3 * i + d];
        count++;
    }
    for (int32_t d = 0; d < 3; d++) middle[d] /= count;
}


/*
 * Two tubes a third of whose fronts and backs are one sheet through another, beside each other (_i 0) or one over the
 * other (1): sewn, they do not cross; side by side each went half of the way, else the upper one stayed where it was.
 * Without self_contact (2, 3) none moves.
 */
START_TEST(panels_in_one_place_are_parted)
{
    mus_context *context = support_context();
    mus_pattern *pattern;
    mus_drape_def def;
    mus_drape *drape;
    const bool over = _i % 2, meets = _i < 2;
    ck_assert_int_eq(mus_pattern_create(context, "two", &pattern), MUS_OK);
    apart_tube(pattern, "a", "a_behind", 0.0, 1.0);
    apart_tube(pattern, "b", "b_behind", over ? 0.013 : 0.2, over ? 0.87 : 1.007);
    mus_cloth *cloth = scene_cut(context, pattern, 0.03, 0.0);
    mus_drape_def_init(&def, sizeof def);
    def.self_contact = meets;
    ck_assert_int_eq(mus_drape_create(context, cloth, NULL, &def, &drape), MUS_OK);
    ck_assert_int_eq(mus_drape_place(drape), MUS_OK);
    ck_assert_msg(mus_drape_sew(drape, NULL, NULL) == MUS_OK, "%s", mus_context_error(context));
    int64_t count = -1;
    double a[3], b[3];
    ck_assert_int_eq(mus_drape_crossings(drape, 0, NULL, &count), MUS_OK);
    apart_middle(drape, cloth, 0, a);
    apart_middle(drape, cloth, 2, b);
    if (!meets) {
        ck_assert_msg(fabs(a[0] - 0.15) < 0.02 && fabs(b[1] - (over ? 0.97 : 1.107)) < 0.02, "%g %g", a[0], b[1]);
    } else {
        ck_assert_int_eq(count, 0);
        if (over)
            ck_assert_msg(fabs(a[1] - 1.1) < 0.03 && b[1] < 0.93, "%g %g", a[1], b[1]);
        else
            ck_assert_msg(a[0] < 0.13 && b[0] > 0.37 && fabs(a[0] + b[0] - 0.5) < 0.03, "%g %g", a[0], b[0]);
    }
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


/* a seam whose sides are held 6 mm apart is open, and they stay where they are: five sheets of cloth would be 10 mm */
START_TEST(what_is_held_apart_is_not_welded)
{
    mus_context *context = support_context();
    mus_pattern *pattern;
    int32_t low[4], high[4];
    mus_drape_def def;
    mus_drape *drape;
    ck_assert_int_eq(mus_pattern_create(context, "held", &pattern), MUS_OK);
    scene_move(pattern, scene_rectangle(pattern, "low", 0, 0, 0.2, 0.1, low), 0, 1, 0);
    scene_move(pattern, scene_rectangle(pattern, "high", 0, 0, 0.2, 0.1, high), 0, 1.106, 0);
    scene_sew(pattern, low[2], high[0], 0.0);
    mus_cloth *cloth = scene_cut(context, pattern, 0.02, 0.0);
    mus_drape_def_init(&def, sizeof def);
    def.self_contact = 1;
    def.sew_seconds = 3.0;
    ck_assert_int_eq(mus_drape_create(context, cloth, NULL, &def, &drape), MUS_OK);
    ck_assert_int_eq(mus_drape_place(drape), MUS_OK);
    const int32_t n = mus_drape_node_count(drape);
    const double *x = mus_drape_positions(drape);
    int32_t held[2] = {MUS_NONE, MUS_NONE};
    for (int32_t i = 0; i < n; i++) {
        if (fabs(x[3 * i]) > 1e-6) continue;
        if (fabs(x[3 * i + 1] - 1.1) < 1e-6) held[0] = i;
        if (fabs(x[3 * i + 1] - 1.106) < 1e-6) held[1] = i;
    }
    ck_assert(held[0] != MUS_NONE && held[1] != MUS_NONE);
    for (int32_t k = 0; k < 2; k++) ck_assert_int_eq(mus_drape_pin(drape, held[k], 1), MUS_OK);
    ck_assert_int_eq(mus_drape_sew(drape, NULL, NULL), MUS_ERR_SEW);
    x = mus_drape_positions(drape);
    ck_assert_double_eq_tol(x[3 * held[0] + 1], 1.1, 1e-6);
    ck_assert_double_eq_tol(x[3 * held[1] + 1], 1.106, 1e-6);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_arrange_separate(void)
{
    Suite *suite = suite_create("arrange_separate");
    TCase *tests = tcase_create("arrange_separate");
    tcase_set_timeout(tests, 60);
    tcase_add_loop_test(tests, panels_in_one_place_are_parted, 0, 4);
    tcase_add_test(tests, what_is_held_apart_is_not_welded);
    suite_add_tcase(suite, tests);
    return suite;
}
