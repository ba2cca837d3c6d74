/*
 * test_edge_facing.c: free edges that are attached get a facing, and nothing else does.
 */
#include "cut.h"

#include "cloth/mesh.h"

#define WIDTH 0.05 /* [m] of a facing, as edge_facing.c has it */
#define BOW 0.05   /* [1/m] curvature of the cylinder */


/* rigidity times area of a cloth that is rolled along the width of its panel */
static double faced_bending(const mus_cloth *cloth)
{
    double *x = malloc(3 * (size_t)cloth->nnode * sizeof *x);
    for (int32_t i = 0; i < cloth->nnode; i++) {
        const double u = cloth->rest[2 * i];
        x[3 * i] = sin(u * BOW) / BOW, x[3 * i + 1] = cloth->rest[2 * i + 1], x[3 * i + 2] = (1.0 - cos(u * BOW)) / BOW;
    }
    double energy = cut_bend_energy(cloth, x);
    for (int32_t h = 0; h < cloth->nseam_hinge; h++) energy += cut_hinge_energy(&cloth->seam_hinge[h], x);
    free(x);
    return energy / (0.5 * BOW * BOW);
}


static mus_cloth *faced_cloth(mus_context *context, const mus_pattern *pattern, double spacing, int32_t bending)
{
    mus_cloth_def def;
    mus_fabric fabric;
    mus_cloth_def_init(&def, sizeof def);
    mus_fabric_init(&fabric, sizeof fabric);
    def.fabric = &fabric;
    def.spacing = spacing, def.bending = bending, def.coarser = 0;
    mus_cloth *cloth;
    ck_assert_msg(mus_cloth_create(context, pattern, &def, &cloth) == MUS_OK, "%s", mus_context_error(context));
    return cloth;
}


/* a facing of bending length w has the rigidity weight g w^3; the rest of the panel has the fabric's */
START_TEST(a_facing_stands_over_its_own_width)
{
    const double wide = 0.3, high = 0.4, spacing[2] = {0.01, 0.005};
    mus_context *context = support_context();
    mus_fabric fabric;
    mus_fabric_init(&fabric, sizeof fabric);
    int32_t edge[4];
    mus_pattern *pattern = cut_begin(context);
    cut_rectangle(pattern, "piece", wide, high, edge);
    CUT(mus_pattern_set_edge_hold(pattern, edge[2], MUS_HOLD_WAIST, 0.0));
    for (int s = 0; s < 2; s++) {
        mus_cloth *cloth = faced_cloth(context, pattern, spacing[s], MUS_BEND_PLATE);
        const double plain = fabric.bend[1] * wide * high, gained = faced_bending(cloth) - plain;
        const double want = (fabric.weight * 9.81 * WIDTH * WIDTH * WIDTH - fabric.bend[1]) * wide * WIDTH;

        /* the nodes within the width stand for half a spacing more or less of it */
        const double tolerance = 0.5 * spacing[s] / WIDTH;
        ck_assert_msg(fabs(gained / want - 1.0) < tolerance, "%g of %g at %g m", gained, want, spacing[s]);
        mus_cloth_destroy(cloth);
    }
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


/* what is sewn hangs from its seam, an elastic needs soft cloth, the paper's method has bending of its own */
START_TEST(only_a_free_edge_without_an_elastic_is_faced)
{
    enum { FREE, SEWN, ELASTIC, LOOSE, PAPER, CASES };
    mus_context *context = support_context();
    int32_t count[CASES];
    for (int k = 0; k < CASES; k++) {
        int32_t upper[4], lower[4];
        mus_pattern *pattern = cut_begin(context);
        cut_rectangle(pattern, "lower", 0.3, 0.2, lower);
        cut_rectangle(pattern, "upper", 0.3, 0.2, upper);
        if (k != LOOSE) CUT(mus_pattern_set_edge_hold(pattern, lower[2], MUS_HOLD_WAIST, 0.0));
        if (k == SEWN) cut_seam(pattern, lower[2], upper[0], MUS_SEAM_REVERSED);
        if (k == ELASTIC) CUT(mus_pattern_set_edge_elastic(pattern, lower[2], 0.9, 60.0));
        mus_cloth *cloth = faced_cloth(context, pattern, 0.01, k == PAPER ? MUS_BEND_PAPER : MUS_BEND_PLATE);
        count[k] = 0; /* stencils of a facing have their middle twice */
        for (int32_t h = 0; h < cloth->nhinge; h++) count[k] += cloth->hinge[h].node[0] == cloth->hinge[h].node[1];
        mus_cloth_destroy(cloth);
        mus_pattern_destroy(pattern);
    }
    ck_assert_int_gt(count[FREE], 100);
    for (int k = FREE + 1; k < CASES; k++) ck_assert_msg(count[k] == 0, "case %d: %d", k, (int)count[k]);
    support_context_end(context);
}
END_TEST


/* a coarse cut is stiffer than a facing already */
START_TEST(a_stiff_cloth_gains_nothing)
{
    mus_context *context = support_context();
    mus_fabric fabric;
    mus_fabric_init(&fabric, sizeof fabric);
    fabric.bend[0] = fabric.bend[1] = fabric.bend[2] = 1.001 * fabric.weight * 9.81 * WIDTH * WIDTH * WIDTH;
    int32_t edge[4];
    mus_pattern *pattern = cut_begin(context);
    cut_rectangle(pattern, "piece", 0.3, 0.2, edge);
    mus_cloth *plain = cut_cloth(context, pattern, 0.01, &fabric);
    CUT(mus_pattern_set_edge_hold(pattern, edge[2], MUS_HOLD_WAIST, 0.0));
    mus_cloth *held = cut_cloth(context, pattern, 0.01, &fabric);
    ck_assert_double_eq(faced_bending(held), faced_bending(plain));
    ck_assert_int_eq(mus_cloth_spring_count(held), mus_cloth_spring_count(plain));
    mus_cloth_destroy(plain);
    mus_cloth_destroy(held);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_edge_facing(void);
Suite *mus_suite_edge_facing(void)
{
    Suite *suite = suite_create("edge_facing");
    TCase *tests = tcase_create("facing");
    tcase_add_test(tests, a_facing_stands_over_its_own_width);
    tcase_add_test(tests, only_a_free_edge_without_an_elastic_is_faced);
    tcase_add_test(tests, a_stiff_cloth_gains_nothing);
    suite_add_tcase(suite, tests);
    return suite;
}
