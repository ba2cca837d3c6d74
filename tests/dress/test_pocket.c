/*
 * test_pocket.c: a patch pocket on a hanging cloth: its seams close, three sheets are one there, and it lies on the
 * outside with nothing crossing.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "drape/scenes.h"
#include "muslin/edit.h"

#define SPACING 0.0125


/* 0.3 x 0.3 m with a pocket of 0.12 x 0.14 m; the patch is panel 1 */
static mus_pattern *pocketed(mus_context *context)
{
    const double line[8] = {0.09, 0.22, 0.09, 0.08, 0.21, 0.08, 0.21, 0.22};
    mus_pattern *pattern;
    int32_t edge[4], patch;
    ck_assert_int_eq(mus_pattern_create(context, "pocket", &pattern), MUS_OK);
    scene_move(pattern, scene_rectangle(pattern, "shell", 0, 0, 0.3, 0.3, edge), 0, 1, 0);
    ck_assert_msg(mus_pattern_add_patch(pattern, 0, "pocket", 4, line, &patch) == MUS_OK, "%s",
                  mus_context_error(context));
    ck_assert_int_eq(patch, 1);
    return pattern;
}


/* nodes of the line are inside the shell, one at each step; the whole weighs as much as both panels */
START_TEST(a_line_has_nodes_inside_its_panel)
{
    mus_context *context = support_context();
    mus_pattern *pattern = pocketed(context);
    mus_cloth *cloth = scene_cut(context, pattern, SPACING, 0.0);
    const int32_t *panel = mus_cloth_node_panels(cloth), *pair = mus_cloth_pairs(cloth);
    const double *rest = mus_cloth_rest(cloth);
    int32_t n;
    const int32_t *border;

    /* sides of 0.14 m in 11 steps, a bottom of 0.12 m in 10: one pair each, both ends of each */
    ck_assert_int_eq(mus_cloth_pair_count(cloth), 12 + 11 + 12);
    for (int32_t i = 0; i < mus_cloth_pair_count(cloth); i++) {
        const int32_t a = pair[2 * i], b = pair[2 * i + 1];
        ck_assert(panel[a] != panel[b]);
        ck_assert_double_eq_tol(rest[2 * a], rest[2 * b], 1e-12);
        ck_assert_double_eq_tol(rest[2 * a + 1], rest[2 * b + 1], 1e-12);
    }
    mus_cloth_panel_border(cloth, 0, &n, &border);
    ck_assert_int_eq(n, 4 * 24);
    mus_fabric jersey;
    mus_fabric_init(&jersey, sizeof jersey);
    ck_assert_double_eq_tol(mus_cloth_mass(cloth), jersey.weight * (0.09 + 0.12 * 0.14), 1e-12);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


/* held at the upper corners, sewn and at rest, with cloth on cloth: welded, uncrossed, and before the shell, to which
 * every node of it is nearer than 2 cm */
START_TEST(a_pocket_lies_on_its_shell)
{
    mus_context *context = support_context();
    mus_pattern *pattern = pocketed(context);
    mus_cloth *cloth = scene_cut(context, pattern, SPACING, 0.0);
    mus_drape_def def;
    mus_drape *drape;
    mus_drape_def_init(&def, sizeof def);
    def.self_contact = 1;
    ck_assert_int_eq(mus_drape_create(context, cloth, NULL, &def, &drape), MUS_OK);
    ck_assert_int_eq(mus_drape_place(drape), MUS_OK);
    const double *rest = mus_cloth_rest(cloth);
    const int32_t *panel = mus_cloth_node_panels(cloth), *pair = mus_cloth_pairs(cloth);
    const int32_t n = mus_cloth_node_count(cloth);
    for (int32_t i = 0; i < n; i++)
        if (panel[i] == 0 && fabs(rest[2 * i + 1] - 0.3) < 1e-12) mus_drape_pin(drape, i, 1);
    ck_assert_msg(mus_drape_sew(drape, NULL, NULL) == MUS_OK, "%s", mus_context_error(context));
    ck_assert_msg(mus_drape_settle(drape, NULL, NULL) == MUS_OK, "%s", mus_context_error(context));

    const double *x = mus_drape_positions(drape);
    int64_t crossings;
    ck_assert_int_eq(mus_drape_crossings(drape, 0, NULL, &crossings), MUS_OK);
    ck_assert_int_eq(crossings, 0);
    for (int32_t i = 0; i < mus_cloth_pair_count(cloth); i++)
        ck_assert_mem_eq(x + 3 * pair[2 * i], x + 3 * pair[2 * i + 1], 3 * sizeof *x);
    double inside = 0.0, far = 0.0;
    for (int32_t i = 0; i < n; i++) {
        if (panel[i] != 1) continue;
        int32_t below = 0;
        for (int32_t k = 0; k < n; k++)
            if (panel[k] == 0 && hypot(rest[2 * k] - rest[2 * i], rest[2 * k + 1] - rest[2 * i + 1]) <
                                     hypot(rest[2 * below] - rest[2 * i], rest[2 * below + 1] - rest[2 * i + 1]))
                below = k;
        const double off = x[3 * i + 2] - x[3 * below + 2];
        inside = fmin(inside, off), far = fmax(far, off);
    }
    printf("pocket: from %.2f mm behind to %.2f mm before the shell\n", 1e3 * inside, 1e3 * far);
    ck_assert_double_gt(inside, -0.001);
    ck_assert_double_lt(far, 0.02);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_pocket(void);


Suite *mus_suite_pocket(void)
{
    Suite *suite = suite_create("pocket");
    TCase *tests = tcase_create("pocket");
    tcase_set_timeout(tests, 60.0);
    tcase_add_test(tests, a_line_has_nodes_inside_its_panel);
    tcase_add_test(tests, a_pocket_lies_on_its_shell);
    suite_add_tcase(suite, tests);
    return suite;
}
