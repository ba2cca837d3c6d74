/*
 * test_calibrate_bending.c: cut panels bend as their fabric, whatever their outline, grain and seams (case B7).
 */
#include "cut.h"

#include "cloth/mesh.h"

#define PI 3.14159265358979323846


/* rigidity of a cloth rolled along `angle`, by its energy at a small curvature; seams count when they are given */
static double calibrate_rigidity(const mus_cloth *cloth, double angle, double area)
{
    const double bow = 0.05;
    double *x = malloc(3 * (size_t)cloth->nnode * sizeof *x), energy;
    for (int32_t i = 0; i < cloth->nnode; i++) {
        const double u = cloth->rest[2 * i], v = cloth->rest[2 * i + 1], t = u * cos(angle) + v * sin(angle);
        x[3 * i] = sin(t * bow) / bow, x[3 * i + 1] = v * cos(angle) - u * sin(angle);
        x[3 * i + 2] = (1.0 - cos(t * bow)) / bow;
    }
    energy = cut_bend_energy(cloth, x);
    for (int32_t h = 0; h < cloth->nseam_hinge; h++) energy += cut_hinge_energy(&cloth->seam_hinge[h], x);
    free(x);
    return energy / (0.5 * bow * bow * area);
}


static void calibrate_near(double got, double want, double tolerance)
{
    ck_assert_msg(fabs(got - want) <= tolerance * want, "%.9g, expected %.9g within %g", got, want, tolerance);
}


START_TEST(a_cut_panel_bends_as_its_fabric)
{
    static const double outline[] = {0, 0, 0.2, 0.01, 0.23, 0.15, 0.12, 0.22, 0.02, 0.16};
    static const double grain[4][2] = {{0, 1}, {1, 2}, {1, 1}, {-3, 1}}, spacing[3] = {0.02, 0.01, 0.006};
    mus_context *context = support_context();
    mus_fabric fabric;
    mus_fabric_init(&fabric, sizeof fabric);
    fabric.bend[0] = 6e-6, fabric.bend[1] = 4e-6, fabric.bend[2] = 4.5e-6;
    for (int g = 0; g < 4; g++) {
        mus_pattern *pattern = cut_begin(context);
        const int32_t panel = cut_panel(pattern, "piece", 5, outline, NULL);
        CUT(mus_pattern_set_grain(pattern, panel, grain[g][0], grain[g][1]));
        for (int s = 0; s < 3; s++) {
            mus_cloth *cloth = cut_cloth(context, pattern, spacing[s], &fabric);
            const double area = mus_pattern_panel_area(pattern, panel), warp = atan2(grain[g][1], grain[g][0]);

            const double tolerance = 1e-5;
            calibrate_near(calibrate_rigidity(cloth, warp, area), 6e-6, tolerance);
            calibrate_near(calibrate_rigidity(cloth, warp + PI / 2, area), 4e-6, tolerance);
            calibrate_near(calibrate_rigidity(cloth, warp + PI / 4, area), 4.5e-6, tolerance);
            calibrate_near(calibrate_rigidity(cloth, warp - PI / 4, area), 4.5e-6, tolerance);
            mus_cloth_destroy(cloth);
        }
        mus_pattern_destroy(pattern);
    }
    support_context_end(context);
}
END_TEST


/* a rectangle cut along a slanting line: the hinges across the seam take their share from both panels */
START_TEST(panels_sewn_together_bend_as_one)
{
    static const double left[] = {0, 0, 0.12, 0, 0.08, 0.18, 0, 0.18};
    static const double right[] = {0.12, 0, 0.2, 0, 0.2, 0.18, 0.08, 0.18};
    mus_context *context = support_context();
    mus_fabric fabric;
    mus_fabric_init(&fabric, sizeof fabric);
    mus_pattern *pattern = cut_begin(context);
    int32_t a[4], b[4];
    cut_panel(pattern, "left", 4, left, a);
    cut_panel(pattern, "right", 4, right, b);
    cut_seam(pattern, a[1], b[3], MUS_SEAM_REVERSED);
    for (int s = 0; s < 2; s++) {
        mus_cloth *cloth = cut_cloth(context, pattern, s == 0 ? 0.01 : 0.005, &fabric);
        ck_assert_int_gt(cloth->nseam_hinge, 15);
        for (int d = 0; d < 4; d++) calibrate_near(calibrate_rigidity(cloth, d * PI / 4, 0.2 * 0.18), 5e-6, 1e-5);
        mus_cloth_destroy(cloth);
    }
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


START_TEST(no_hinge_leaves_half_to_double_its_first_value)
{
    /* against the value that its triangles alone give it: B / (A0 + A1) */
    mus_context *context = support_context();
    mus_pattern *pattern = cut_begin(context);
    mus_fabric fabric;
    mus_fabric_init(&fabric, sizeof fabric);
    int32_t edges[5];
    cut_skirt(pattern);
    cut_sleeve(pattern, edges);
    mus_cloth *cloth = cut_cloth(context, pattern, 0.01, &fabric);
    int32_t changed = 0;
    for (int32_t h = 0; h < cloth->nhinge; h++) {
        const mus__hinge *hinge = &cloth->hinge[h];
        double area = 0.0;
        for (int w = 2; w < 4; w++) {
            const double *p = cloth->rest + 2 * hinge->node[0], *q = cloth->rest + 2 * hinge->node[1];
            const double *r = cloth->rest + 2 * hinge->node[w];
            area += 0.5 * fabs((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]));
        }
        const double ratio = hinge->k / (5e-6 / area);
        ck_assert_msg(ratio < 2.0 * (1 + 1e-12), "%g", ratio);
        changed += fabs(ratio - 1.0) > 1e-6;
    }
    ck_assert_int_gt(changed, cloth->nhinge / 2);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_calibrate_bending(void);
Suite *mus_suite_calibrate_bending(void)
{
    Suite *suite = suite_create("calibrate_bending");
    TCase *tests = tcase_create("calibrate");
    tcase_set_timeout(tests, 30.0);
    tcase_add_test(tests, a_cut_panel_bends_as_its_fabric);
    tcase_add_test(tests, panels_sewn_together_bend_as_one);
    tcase_add_test(tests, no_hinge_leaves_half_to_double_its_first_value);
    suite_add_tcase(suite, tests);
    return suite;
}
