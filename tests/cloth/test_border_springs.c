/*
 * test_border_springs.c: springs and hinges of the triangles at the border: at rest when flat, as stiff as the fabric,
 * and never much stiffer against their mass than the lattice.
 */
#include "cut.h"

#include "cloth/fabric.h"
#include "cloth/mesh.h"


static void near(double got, double want, double tolerance)
{
    ck_assert_msg(fabs(got - want) <= tolerance, "%.17g, expected %.17g within %g", got, want, tolerance);
}


static mus_cloth *cut_piece(mus_context *context, double spacing, const mus_fabric *fabric)
{
    mus_pattern *pattern = cut_begin(context);
    int32_t edges[5];
    cut_skirt(pattern);
    cut_sleeve(pattern, edges);
    const double strap[] = {0, 0, 0.3, 0.1, 0.293675, 0.118974, -0.006325, 0.018974};
    cut_panel(pattern, "strap", 4, strap, NULL);
    mus_cloth *cloth = cut_cloth(context, pattern, spacing, fabric);
    mus_pattern_destroy(pattern);
    return cloth;
}


/* Writes the nodes' positions: those in the plane, turned and moved in space; or on a cylinder of curvature `bow` [1/m]
 */
static double *flat(const mus_cloth *cloth)
{
    double *x = malloc(3 * (size_t)cloth->nnode * sizeof *x);
    for (int32_t i = 0; i < cloth->nnode; i++) {
        double u = cloth->rest[2 * i], v = cloth->rest[2 * i + 1];
        x[3 * i] = 0.36 * u - 0.8 * v + 3.0;
        x[3 * i + 1] = 0.48 * u + 0.6 * v - 1.0;
        x[3 * i + 2] = 0.8 * u;
    }
    return x;
}


START_TEST(a_flat_cloth_is_at_rest)
{
    mus_context *context = support_context();
    mus_cloth *cloth = cut_piece(context, 0.01, NULL);
    double *x = flat(cloth);
    ck_assert_double_le(cut_stretch_energy(cloth, x), 1e-24);
    ck_assert_double_le(cut_bend_energy(cloth, x), 1e-24);
    ck_assert_int_gt(cloth->nhinge, 100);
    free(x);
    mus_cloth_destroy(cloth);
    support_context_end(context);
}
END_TEST


START_TEST(hinges_push_and_pull_alike)
{
    /* the forces of a hinge sum to 0, as its coefficients do */
    mus_context *context = support_context();
    mus_cloth *cloth = cut_piece(context, 0.01, NULL);
    for (int32_t h = 0; h < cloth->nhinge + cloth->nseam_hinge; h++) {
        const mus__hinge *hinge = h < cloth->nhinge ? &cloth->hinge[h] : &cloth->seam_hinge[h - cloth->nhinge];
        double sum = 0.0, size = 0.0;
        for (int k = 0; k < 4; k++) sum += hinge->coef[k], size += fabs(hinge->coef[k]);
        near(sum, 0.0, 1e-14 * size);
        ck_assert(hinge->k > 0.0 && size < 100.0);
        for (int k = 1; k < 4; k++) ck_assert_int_ne(hinge->node[k], hinge->node[0]);
    }
    mus_cloth_destroy(cloth);
    support_context_end(context);
}
END_TEST


START_TEST(equilateral_triangles_bend_with_the_rigidity)
{
    /* Seung and Nelson 1988: a sheet of equilateral triangles with E = 1/2 k angle^2 a hinge has B = k sqrt(3) / 2 */
    mus_cloth cloth = {.spacing = 0.01};
    mus__mesh mesh = {.cloth = &cloth};
    mus__hinge hinge;
    const double l = 0.01, s = l / 2.0, h = l * sqrt(0.75), rigidity = 3e-6, angle = 1e-4;
    const int32_t node[4] = {0, 1, 2, 3};
    ck_assert(mus__mesh_hinge(&mesh, node, l, (const double[]){s, s}, (const double[]){h, h}, rigidity, &hinge));
    const double x[] = {0, 0, 0, l, 0, 0, s, h, 0, s, -h * cos(angle), h * sin(angle)};
    near(cut_hinge_energy(&hinge, x), 0.5 * rigidity * 2.0 / sqrt(3.0) * angle * angle, 1e-20);

    /* triangles of no area, and cloth without bending rigidity, have no hinge */
    ck_assert(!mus__mesh_hinge(&mesh, node, l, (const double[]){s, s}, (const double[]){h, 1e-12}, rigidity, &hinge));
    ck_assert(!mus__mesh_hinge(&mesh, node, l, (const double[]){s, s}, (const double[]){h, h}, 0.0, &hinge));
}
END_TEST


START_TEST(the_strip_bends_by_the_springs_of_the_paper_too)
{
    /* at the curvature they are fitted at, near the hinges; at a tenth of it, a hundredth */
    mus_context *context = support_context();
    mus_pattern *pattern = cut_begin(context);
    cut_rectangle(pattern, "sheet", 0.1, 0.08, NULL);
    mus_cloth_def def;
    mus_fabric fabric;
    mus_cloth *cloth;
    mus_cloth_def_init(&def, sizeof def);
    mus_fabric_init(&fabric, sizeof fabric);
    def.fabric = &fabric;
    def.bending = MUS_BEND_PAPER, def.paper_curvature = 10.0;
    CUT(mus_cloth_create(context, pattern, &def, &cloth));
    ck_assert_int_eq(cloth->nhinge + cloth->nbend, 0);
    double *x = malloc(3 * (size_t)cloth->nnode * sizeof *x), energy[2][3];
    for (int k = 0; k < 3; k++) {
        const double bow = k == 2 ? 1.0 : k == 1 ? 10.01 : 9.99;
        for (int way = 0; way < 2; way++) {
            for (int32_t i = 0; i < cloth->nnode; i++) {
                double u = cloth->rest[2 * i + way], v = cloth->rest[2 * i + 1 - way];
                x[3 * i] = sin(u * bow) / bow, x[3 * i + 1] = v, x[3 * i + 2] = (1.0 - cos(u * bow)) / bow;
            }
            energy[way][k] = 0.0;
            for (int32_t s = 0; s < cloth->nspring; s++) {
                const mus__spring *spring = &cloth->spring[s];
                if (spring->kind != MUS__SPRING_SKIP) continue;
                const double *p = x + 3 * spring->a, *q = x + 3 * spring->b;
                const double stretch = sqrt((q[0] - p[0]) * (q[0] - p[0]) + (q[1] - p[1]) * (q[1] - p[1]) +
                                            (q[2] - p[2]) * (q[2] - p[2])) - spring->rest;
                energy[way][k] += 0.5 * spring->k * stretch * stretch;
            }
        }
    }
    mus_cloth *plate = cut_cloth(context, pattern, 0.01, &fabric);
    for (int way = 0; way < 2; way++) {
        const double moment = (energy[way][1] - energy[way][0]) / 0.02;
        double hinges = 0.0;
        for (int32_t i = 0; i < cloth->nnode; i++) {
            double u = cloth->rest[2 * i + way], v = cloth->rest[2 * i + 1 - way];
            x[3 * i] = sin(u), x[3 * i + 1] = v, x[3 * i + 2] = 1.0 - cos(u);
        }
        for (int32_t h = 0; h < plate->nhinge; h++) hinges += 2.0 * cut_hinge_energy(&plate->hinge[h], x);

        /* a spring over a diagonal depends on the curvature along it, a hinge on the fold only: within 0.8 to 2 */
        ck_assert_double_lt(energy[way][2], 0.00011 * energy[way][0]);
        ck_assert_msg(moment > 0.8 * 10.0 * hinges && moment < 2.0 * 10.0 * hinges, "%g of %g", moment, 10 * hinges);
    }
    free(x);
    mus_cloth_destroy(plate);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


START_TEST(the_strip_bends_about_as_the_lattice_does)
{
    /* a whole panel on a cylinder: 1/2 B bow^2 area in every direction, less at the free rim, more on the bias of half
     * squares (quadratic hinges alone: 1.5 there); nearly half of this panel is strip */
    mus_context *context = support_context();
    mus_pattern *pattern = cut_begin(context);
    mus_fabric fabric;
    mus_fabric_init(&fabric, sizeof fabric);
    cut_rectangle(pattern, "sheet", 0.1, 0.08, NULL);
    mus_cloth *cloth = cut_cloth(context, pattern, 0.01, &fabric);
    double *x = malloc(3 * (size_t)cloth->nnode * sizeof *x), bow = 1.0;
    for (double angle = 0.0; angle < 3.1; angle += 0.25) {
        for (int32_t i = 0; i < cloth->nnode; i++) {
            double u = cloth->rest[2 * i], v = cloth->rest[2 * i + 1], t = u * cos(angle) + v * sin(angle);
            x[3 * i] = sin(t * bow) / bow, x[3 * i + 1] = v * cos(angle) - u * sin(angle);
            x[3 * i + 2] = (1.0 - cos(t * bow)) / bow;
        }
        double ratio = cut_bend_energy(cloth, x) / (0.5 * 5e-6 * bow * bow * 0.1 * 0.08);
        ck_assert_msg(ratio > 0.75 && ratio < 1.3, "%g at %g", ratio, angle);
    }
    free(x);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


/* Returns the largest row sum of the stiffness matrix over mass, as a multiple of that of an inner lattice node, and
 * counts the nodes above `level`. */
static double worst_node(const mus_cloth *cloth, double level, int32_t *above)
{
    mus__fabric_lattice c;
    mus__fabric_on_lattice(&cloth->fabric, cloth->spacing, &c);
    double inner = 4.0 * (c.k[0] + c.k[1]) + 8.0 * c.shear + 16.0 * (c.bend[0] + c.bend[1] + 2.0 * c.cross),
           worst = 0.0;
    inner /= cloth->fabric.weight * cloth->spacing * cloth->spacing;
    double *sum = calloc((size_t)cloth->nnode, sizeof *sum);
    for (int32_t r = 0; r < cloth->nrun; r++)
        for (int32_t i = 0; i < cloth->run[r].count; i++)
            sum[cloth->run[r].a + i] += 2.0 * cloth->run[r].k, sum[cloth->run[r].b + i] += 2.0 * cloth->run[r].k;
    for (int32_t r = 0; r < cloth->nbend; r++)
        for (int32_t i = 0; i < cloth->bend[r].count; i++) {
            sum[cloth->bend[r].a + i] += 4.0 * cloth->bend[r].k, sum[cloth->bend[r].c + i] += 4.0 * cloth->bend[r].k;
            sum[cloth->bend[r].b + i] += 8.0 * cloth->bend[r].k;
        }
    for (int32_t s = 0; s < cloth->nspring; s++)
        sum[cloth->spring[s].a] += 2.0 * cloth->spring[s].k, sum[cloth->spring[s].b] += 2.0 * cloth->spring[s].k;
    for (int32_t h = 0; h < cloth->nhinge; h++) {
        double size = 0.0;
        for (int k = 0; k < 4; k++) size += fabs(cloth->hinge[h].coef[k]);
        for (int k = 0; k < 4; k++)
            sum[cloth->hinge[h].node[k]] += cloth->hinge[h].k * size * fabs(cloth->hinge[h].coef[k]);
    }
    *above = 0;
    for (int32_t i = 0; i < cloth->nnode; i++) {
        double ratio = sum[i] / cloth->mass[i] / inner;
        worst = fmax(worst, ratio);
        *above += ratio > level;
    }
    free(sum);
    return worst;
}


START_TEST(the_strip_costs_less_than_half_a_step_more)
{
    mus_context *context = support_context();
    mus_fabric fabric;
    mus_fabric_init(&fabric, sizeof fabric);
    const double spacing[] = {0.004, 0.01, 0.015};
    for (int32_t f = 0; f < mus_fabric_count(); f++)
        for (int k = 0; k < 3; k++) {
            int32_t above;
            mus_fabric_find(mus_fabric_name(f), &fabric);
            mus_cloth *cloth = cut_piece(context, spacing[k], &fabric);
            ck_assert_double_le(sqrt(worst_node(cloth, 2.24, &above)), 1.5 + 1e-12);

            /* no node of a well shaped panel reaches the limit */
            ck_assert_msg(above <= cloth->nnode / 1000, "%d of %d nodes", above, cloth->nnode);
            mus_cloth_destroy(cloth);
        }
    support_context_end(context);
}
END_TEST


START_TEST(a_splinter_does_not_rule_the_step)
{
    /* a gathered side with 4 mm intervals and a corner of 3 degrees */
    mus_context *context = support_context();
    mus_pattern *pattern = cut_begin(context);
    int32_t flounce[4], band[3], above;
    cut_rectangle(pattern, "flounce", 0.5, 0.1, flounce);
    const double sharp[] = {0, 0, 0.2, 0, 0.2, 0.01};
    cut_panel(pattern, "band", 3, sharp, band);
    cut_seam(pattern, flounce[2], band[0], MUS_SEAM_REVERSED);
    mus_cloth *cloth = cut_cloth(context, pattern, 0.01, NULL);
    ck_assert_double_le(sqrt(worst_node(cloth, 0.0, &above)), 1.5 + 1e-12);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_border_springs(void);
Suite *mus_suite_border_springs(void)
{
    Suite *suite = suite_create("border_springs");
    TCase *tests = tcase_create("strip");
    tcase_set_timeout(tests, 30.0);
    tcase_add_test(tests, a_flat_cloth_is_at_rest);
    tcase_add_test(tests, hinges_push_and_pull_alike);
    tcase_add_test(tests, equilateral_triangles_bend_with_the_rigidity);
    tcase_add_test(tests, the_strip_bends_by_the_springs_of_the_paper_too);
    tcase_add_test(tests, the_strip_bends_about_as_the_lattice_does);
    tcase_add_test(tests, the_strip_costs_less_than_half_a_step_more);
    tcase_add_test(tests, a_splinter_does_not_rule_the_step);
    suite_add_tcase(suite, tests);
    return suite;
}
