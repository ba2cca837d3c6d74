/*
 * test_force_program_irregular.c: seams of unequal length, pleats and elastics end as long as the pattern says (to 1
 * %), with no gap.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "drape/scenes.h"

#define SPACING 0.01


/* length of the seam's (or the edge's) chain of nodes in the drape: nodes first .. last of a panel's border */
static double chain_length(const mus_drape *drape, const mus_cloth *cloth, int32_t panel, int32_t first, int32_t last)
{
    int32_t n;
    const int32_t *border;
    const double *x = mus_drape_positions(drape);
    double length = 0.0;
    ck_assert_int_eq(mus_cloth_panel_border(cloth, panel, &n, &border), MUS_OK);
    for (int32_t i = first; i < last; i++) {
        const double *a = x + 3 * (ptrdiff_t)border[i % n], *b = x + 3 * (ptrdiff_t)border[(i + 1) % n];
        length += sqrt((b[0] - a[0]) * (b[0] - a[0]) + (b[1] - a[1]) * (b[1] - a[1]) + (b[2] - a[2]) * (b[2] - a[2]));
    }
    return length;
}


/* sewn and at rest in empty space; a cloth that is flat to the last bit would not know which way to fold */
static mus_drape *rest_in_space(mus_context *context, const mus_cloth *cloth)
{
    mus_drape *drape = scene_drape(context, cloth, 64, 1);
    const double nothing[3] = {0.0, 0.0, 0.0};
    const int32_t n = mus_drape_node_count(drape);
    double *x = malloc(3 * (size_t)n * sizeof *x);
    uint64_t seed = 7;
    memcpy(x, mus_drape_positions(drape), 3 * (size_t)n * sizeof *x);
    for (int32_t i = 0; i < n; i++) x[3 * i + 2] += support_uniform(&seed, -1e-3, 1e-3);
    ck_assert_int_eq(mus_drape_set_state(drape, x, NULL), MUS_OK);
    free(x);
    ck_assert_int_eq(mus_drape_set_gravity(drape, nothing), MUS_OK);
    ck_assert_msg(mus_drape_sew(drape, NULL, NULL) == MUS_OK, "%s", mus_context_error(context));
    const mus_status status = mus_drape_settle(drape, NULL, NULL);
    ck_assert_msg(status == MUS_OK || status == MUS_ERR_UNSETTLED, "%s", mus_context_error(context));
    mus_drape_report report;
    mus_drape_report_init(&report, sizeof report);
    mus_drape_report_get(drape, &report);
    ck_assert_int_eq(report.seams_closed, report.seams);
    ck_assert_double_lt(report.max_seam_gap, 0.0005);
    return drape;
}


/* gathered 1.5 : 1 and 3 : 1, seams end at the length of the shorter side, to 1 % */
START_TEST(a_gathered_seam_is_as_long_as_its_shorter_side)
{
    const double ratio = _i == 0 ? 1.05 : _i == 1 ? 1.5 : 3.0;
    mus_context *context = support_context();
    mus_pattern *pattern = scene_strips(context, ratio);
    mus_cloth *cloth = scene_cut(context, pattern, SPACING, 0.0);
    mus_drape *drape = rest_in_space(context, cloth);
    int32_t n;
    const int32_t *border;
    mus_cloth_panel_border(cloth, 0, &n, &border);

    /* bottom, right, top, left of the low strip: the top is what is sewn, as finely as the gathered side */
    const int32_t top = n - 30 - 10 - 10, first = 30 + 10;
    printf("gather %.2f : 1: %.4f m of 0.3 m\n", ratio, chain_length(drape, cloth, 0, first, first + top));
    ck_assert_double_eq_tol(chain_length(drape, cloth, 0, first, first + top), 0.3, 0.003);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


/* an elastic of 60 N draws a hem in to its own length */
START_TEST(an_elastic_ends_at_its_ratio)
{
    const double ratio = _i == 0 ? 0.8 : 0.5;
    mus_context *context = support_context();
    mus_pattern *pattern;
    int32_t edge[4];
    ck_assert_int_eq(mus_pattern_create(context, "casing", &pattern), MUS_OK);
    scene_move(pattern, scene_rectangle(pattern, "casing", 0, 0, 0.3, 0.15, edge), 0, 1, 0);
    ck_assert_int_eq(mus_pattern_set_edge_elastic(pattern, edge[0], ratio, 60.0), MUS_OK);
    mus_cloth *cloth = scene_cut(context, pattern, SPACING, 0.0);
    mus_drape *drape = rest_in_space(context, cloth);
    printf("elastic %.2f: %.4f m of %.4f m\n", ratio, chain_length(drape, cloth, 0, 0, 30), 0.3 * ratio);
    ck_assert_double_eq_tol(chain_length(drape, cloth, 0, 0, 30), 0.3 * ratio, 0.01 * 0.3 * ratio);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


/* a pleat: the fold's two halves sewn to each other, what is left of the edge to a band */
START_TEST(a_pleat_takes_its_depth_out_of_the_edge)
{
    mus_context *context = support_context();
    mus_pattern *pattern;
    int32_t panel, point[7], edge[7], low[2][4], b[2];
    ck_assert_int_eq(mus_pattern_create(context, "pleat", &pattern), MUS_OK);

    /* a band in two, 0.15 m each */
    for (int i = 0; i < 2; i++) {
        b[i] = scene_rectangle(pattern, i == 0 ? "band_left" : "band_right", 0.15 * i, 0, 0.15, 0.04, low[i]);
        scene_move(pattern, b[i], 0.0, 1.35, 0);
    }
    scene_sew(pattern, low[0][1], low[1][3], 0.0);

    /* 0.4 m wide; its upper edge, from right to left: 0.15 visible, 0.05 and 0.05 of the fold, 0.15 visible */
    const double corner[7][2] = {{0, 0}, {0.4, 0}, {0.4, 0.3}, {0.25, 0.3}, {0.2, 0.3}, {0.15, 0.3}, {0, 0.3}};
    const int32_t along[7] = {1, 1, 1, 1, 1, 1, 1};
    ck_assert_int_eq(mus_pattern_add_panel(pattern, "skirt", &panel), MUS_OK);
    for (int i = 0; i < 7; i++)
        ck_assert_int_eq(mus_pattern_add_point(pattern, panel, corner[i][0], corner[i][1], &point[i]), MUS_OK);
    for (int i = 0; i < 7; i++)
        ck_assert_int_eq(mus_pattern_add_edge(pattern, &(mus_edge_def){.size = sizeof(mus_edge_def),
                                                                       .start = point[i],
                                                                       .end = point[(i + 1) % 7]}, &edge[i]),
                         MUS_OK);
    ck_assert_int_eq(mus_pattern_set_outline(pattern, panel, 7, edge, along), MUS_OK);
    scene_move(pattern, panel, -0.05, 1, 0);
    scene_sew(pattern, edge[3], edge[4], 0.0);
    scene_sew(pattern, low[1][0], edge[2], 0.0);
    scene_sew(pattern, low[0][0], edge[5], 0.0);
    mus_cloth *cloth = scene_cut(context, pattern, SPACING, 0.0);
    mus_drape *drape = rest_in_space(context, cloth);
    const double length = chain_length(drape, cloth, b[0], 0, 15) + chain_length(drape, cloth, b[1], 0, 15);
    printf("pleat: %.4f m of 0.3 m\n", length);
    ck_assert_double_eq_tol(length, 0.3, 0.003);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_force_program_irregular(void);


Suite *mus_suite_force_program_irregular(void)
{
    Suite *suite = suite_create("force_program_irregular");
    TCase *tests = tcase_create("force_program_irregular");
    tcase_set_timeout(tests, 60.0);
    tcase_add_loop_test(tests, a_gathered_seam_is_as_long_as_its_shorter_side, 0, SUPPORT_SLOW ? 1 : 3);
    tcase_add_loop_test(tests, an_elastic_ends_at_its_ratio, 0, SUPPORT_SLOW ? 1 : 2);
    tcase_add_test(tests, a_pleat_takes_its_depth_out_of_the_edge);
    suite_add_tcase(suite, tests);
    return suite;
}
