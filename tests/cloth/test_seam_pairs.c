/*
 * test_seam_pairs.c: partners along seams at equal relative arc length, whatever runs against what; hinges across
 * seams.
 */
#include "cut.h"


static void near(double got, double want, double tolerance)
{
    ck_assert_msg(fabs(got - want) <= tolerance, "%.17g, expected %.17g within %g", got, want, tolerance);
}


/* relative arc length of a place along an edge whose points at 0, 1/POINTS .. 1 are known */
#define POINTS 4000


static double arc_of(const double *points, const double *at)
{
    double best = 0.0, least = 1e9;
    for (int i = 0; i <= POINTS; i++) {
        double d = hypot(points[2 * i] - at[0], points[2 * i + 1] - at[1]);
        if (d < least) least = d, best = (double)i / POINTS;
    }
    ck_assert_double_le(least, 1e-4);
    return best;
}


static double *points_of(const mus_pattern *pattern, int32_t edge)
{
    double *t = malloc((POINTS + 1) * sizeof *t), *points = malloc(2 * (POINTS + 1) * sizeof *points);
    for (int i = 0; i <= POINTS; i++) t[i] = (double)i / POINTS;
    CUT(mus_pattern_edge_at(pattern, edge, POINTS + 1, t, points));
    free(t);
    return points;
}


START_TEST(partners_stand_at_equal_relative_arc_length)
{
    /* a curved side of 1.5 times the length of a straight one: gathered, reversed and direct */
    mus_context *context = support_context();
    for (int32_t direction = 0; direction < 2; direction++) {
        mus_pattern *pattern = cut_begin(context);
        int32_t skirt[4], band[4];
        cut_skirt_panel(pattern, "skirt", skirt);
        cut_rectangle(pattern, "band", 0.42, 0.1, band);
        cut_seam(pattern, skirt[1], band[0], direction);
        mus_cloth *cloth = cut_cloth(context, pattern, 0.01, NULL);

        /* both sides take the greater number: 62 intervals of about 10 mm against 42 */
        int32_t n = (int32_t)floor(mus_pattern_edge_length(pattern, skirt[1]) / 0.01 + 0.5);
        ck_assert_int_eq(mus_cloth_pair_count(cloth), n + 1);
        double sum = 0.0, *side = points_of(pattern, skirt[1]), *top = points_of(pattern, band[0]);
        for (int32_t p = 0; p < cloth->npair; p++) {
            int32_t a = cloth->pair[2 * p], b = cloth->pair[2 * p + 1];
            ck_assert(cloth->node_panel[a] == 0 && cloth->node_panel[b] == 1 && cloth->pair_seam[p] == 0);
            double s = arc_of(side, cloth->rest + 2 * a), t = arc_of(top, cloth->rest + 2 * b);
            near(direction == MUS_SEAM_DIRECT ? t : 1.0 - t, s, 4e-4);
            near(s, (double)p / n, 3e-4);
            sum += cloth->pair_length[p];
        }
        free(side);
        free(top);
        near(sum, 0.5 * (mus_pattern_edge_length(pattern, skirt[1]) + 0.42), 1e-9);
        mus_cloth_destroy(cloth);
        mus_pattern_destroy(pattern);
    }
    support_context_end(context);
}
END_TEST


START_TEST(an_outline_that_runs_against_its_edges_pairs_the_same)
{
    /* the same two squares, the second with its edges drawn backwards: the seam is then direct */
    mus_context *context = support_context();
    mus_pattern *pattern = cut_begin(context);
    int32_t first[4], panel, point[4], edge[4], against[4] = {-1, -1, -1, -1};
    const double at[4][2] = {{0, 0}, {0, 0.1}, {0.1, 0.1}, {0.1, 0}};
    cut_rectangle(pattern, "left", 0.1, 0.1, first);
    CUT(mus_pattern_add_panel(pattern, "right", &panel));
    for (int i = 0; i < 4; i++) CUT(mus_pattern_add_point(pattern, panel, at[i][0], at[i][1], &point[i]));
    for (int i = 0; i < 4; i++)
        CUT(mus_pattern_add_edge(pattern, &(mus_edge_def){.size = sizeof(mus_edge_def), .start = point[i],
                                                          .end = point[(i + 1) % 4]}, &edge[3 - i]));
    CUT(mus_pattern_set_outline(pattern, panel, 4, edge, against));
    cut_seam(pattern, first[1], edge[3], MUS_SEAM_DIRECT);
    mus_cloth *cloth = cut_cloth(context, pattern, 0.01, NULL);
    ck_assert_int_eq(cloth->npair, 11);
    for (int32_t p = 0; p < cloth->npair; p++) {
        const double *a = cloth->rest + 2 * cloth->pair[2 * p], *b = cloth->rest + 2 * cloth->pair[2 * p + 1];
        near(a[0], 0.1, 1e-15);
        near(b[0], 0.0, 1e-15);
        near(a[1], b[1], 1e-15);
    }

    /* sewn, the two squares are one sheet: a cylinder bends the seam as the fabric does */
    ck_assert_int_eq(cloth->nseam_hinge, 10);
    for (int32_t h = 0; h < cloth->nseam_hinge; h++) {
        const mus__hinge *hinge = &cloth->seam_hinge[h];
        double sum[2] = {0.0, 0.0};
        for (int k = 0; k < 4; k++)
            for (int m = 0; m < 2; m++) {
                double shift = m == 0 && cloth->node_panel[hinge->node[k]] == 1 ? 0.1 : 0.0;
                sum[m] += hinge->coef[k] * (cloth->rest[2 * hinge->node[k] + m] + shift);
            }
        near(sum[0], 0.0, 1e-15);
        near(sum[1], 0.0, 1e-15);
        ck_assert_int_eq(cloth->node_panel[hinge->node[0]], 0);
        ck_assert_int_eq(cloth->node_panel[hinge->node[1]], 0);
        ck_assert_int_eq(cloth->node_panel[hinge->node[3]], 1);
    }
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


START_TEST(a_reversed_seam_makes_one_sheet_of_two)
{
    /* a slanted side, so that the two corners opposite stand at different feet */
    mus_context *context = support_context();
    mus_pattern *pattern = cut_begin(context);
    int32_t left[4], right[4];
    const double a[] = {0, 0, 0.1, 0, 0.13, 0.1, 0, 0.1}, b[] = {0.1, 0, 0.2, 0, 0.2, 0.1, 0.13, 0.1};
    cut_panel(pattern, "left", 4, a, left);
    cut_panel(pattern, "right", 4, b, right);
    cut_seam(pattern, left[1], right[3], MUS_SEAM_REVERSED);
    mus_cloth *cloth = cut_cloth(context, pattern, 0.01, NULL);
    ck_assert_int_eq(cloth->nseam_hinge, 10);
    for (int32_t h = 0; h < cloth->nseam_hinge; h++)
        for (int m = 0; m < 2; m++) {
            const mus__hinge *hinge = &cloth->seam_hinge[h];
            double sum = 0.0;
            for (int k = 0; k < 4; k++) sum += hinge->coef[k] * cloth->rest[2 * hinge->node[k] + m];
            near(sum, 0.0, 1e-15);
        }
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


START_TEST(legs_of_a_dart_share_their_tip)
{
    mus_context *context = support_context();
    mus_pattern *pattern = cut_begin(context);
    int32_t edges[7];
    const double dart[] = {0, 0, 0.2, 0, 0.2, 0.2, 0.11, 0.2, 0.1, 0.08, 0.09, 0.2, 0, 0.2};
    cut_panel(pattern, "dart", 7, dart, edges);
    cut_seam(pattern, edges[3], edges[4], MUS_SEAM_REVERSED);
    mus_cloth *cloth = cut_cloth(context, pattern, 0.01, NULL);

    /* 12 intervals have 13 partners, but the tip is its own */
    ck_assert_int_eq(cloth->npair, 12);
    for (int32_t p = 0; p < cloth->npair; p++) {
        const double *a = cloth->rest + 2 * cloth->pair[2 * p], *b = cloth->rest + 2 * cloth->pair[2 * p + 1];
        near(a[1], b[1], 1e-15);
        near(a[0] - 0.1, 0.1 - b[0], 1e-15);
        ck_assert_int_ne(cloth->pair[2 * p], cloth->pair[2 * p + 1]);
    }
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


START_TEST(the_longer_side_of_each_seam_decides)
{
    /* short to middle, and the middle's other side to long */
    mus_context *context = support_context();
    mus_pattern *pattern = cut_begin(context);
    int32_t a[4], b[4], c[4];
    cut_rectangle(pattern, "a", 0.1, 0.1, a);
    cut_rectangle(pattern, "b", 0.2, 0.1, b);
    cut_rectangle(pattern, "c", 0.4, 0.1, c);
    cut_seam(pattern, a[2], b[0], MUS_SEAM_REVERSED);
    cut_seam(pattern, b[2], c[0], MUS_SEAM_REVERSED);
    mus_cloth *cloth = cut_cloth(context, pattern, 0.01, NULL);
    ck_assert_int_eq(cloth->npair, 21 + 41);
    ck_assert_int_eq(cloth->panel[0].border_count, 10 + 10 + 20 + 10);
    ck_assert_int_eq(cloth->panel[1].border_count, 20 + 10 + 40 + 10);
    ck_assert_int_eq(cloth->pair_seam[20], 0);
    ck_assert_int_eq(cloth->pair_seam[21], 1);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_seam_pairs(void);
Suite *mus_suite_seam_pairs(void)
{
    Suite *suite = suite_create("seam_pairs");
    TCase *tests = tcase_create("pairs");
    tcase_add_test(tests, partners_stand_at_equal_relative_arc_length);
    tcase_add_test(tests, an_outline_that_runs_against_its_edges_pairs_the_same);
    tcase_add_test(tests, a_reversed_seam_makes_one_sheet_of_two);
    tcase_add_test(tests, legs_of_a_dart_share_their_tip);
    tcase_add_test(tests, the_longer_side_of_each_seam_decides);
    suite_add_tcase(suite, tests);
    return suite;
}
