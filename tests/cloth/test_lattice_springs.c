/*
 * test_lattice_springs.c: springs and stencils of full cells: each once, and the moduli of the sheet that they make.
 */
#include "cut.h"

#include "cloth/fabric.h"

#define A 0.01


static void near(double got, double want, double tolerance)
{
    ck_assert_msg(fabs(got - want) <= tolerance * fabs(want), "%.17g, expected %.17g within %g", got, want, tolerance);
}


/* a rectangle of whole spacings: the strip is one cell wide and of half cells, so the sheet is the same throughout */
static mus_cloth *cut_sheet(mus_context *context, const mus_fabric *fabric)
{
    mus_pattern *pattern = cut_begin(context);
    cut_rectangle(pattern, "sheet", 20 * A, 15 * A, NULL);
    mus_cloth *cloth = cut_cloth(context, pattern, A, fabric);
    mus_pattern_destroy(pattern);
    return cloth;
}


/* energy a square metre of the sheet under small strains along weft and warp and a shear */
static double strained(const mus_cloth *cloth, double weft, double warp, double shear)
{
    double *x = malloc(3 * (size_t)cloth->nnode * sizeof *x);
    for (int32_t i = 0; i < cloth->nnode; i++) {
        double u = cloth->rest[2 * i], v = cloth->rest[2 * i + 1];
        x[3 * i] = u * (1.0 + weft) + 0.5 * shear * v;
        x[3 * i + 1] = v * (1.0 + warp) + 0.5 * shear * u;
        x[3 * i + 2] = 0.0;
    }
    double energy = cut_stretch_energy(cloth, x) / (20 * A * 15 * A);
    free(x);
    return energy;
}


START_TEST(a_sheet_has_the_moduli_of_its_fabric)
{
    /* C11 = k_s + k_d, C12 = k_d, G = k_d; W = 1/2 C11 e^2, and C12 e f more with strain in both directions */
    mus_context *context = support_context();
    mus_fabric fabric;
    mus_fabric_init(&fabric, sizeof fabric);
    const double shears[] = {0.0, 0.05, 0.5}, e = 1e-6;
    for (int k = 0; k < 3; k++) {
        fabric.stretch[0] = 1000.0, fabric.stretch[1] = 700.0;
        fabric.shear = shears[k] * 700.0;
        mus_cloth *cloth = cut_sheet(context, &fabric);

        /* without shear the strip keeps a little (1e-3 of the stretch) */
        double tolerance = k == 0 ? 1e-3 : 1e-5;
        double warp = strained(cloth, 0, e, 0), weft = strained(cloth, e, 0, 0);
        near(2.0 * warp / (e * e), 1000.0, tolerance);
        near(2.0 * weft / (e * e), 700.0, tolerance);
        if (k > 0) {
            near((strained(cloth, e, e, 0) - warp - weft) / (e * e), fabric.shear, tolerance);
            near(2.0 * strained(cloth, 0, 0, e) / (e * e), fabric.shear, tolerance);
        }
        mus_cloth_destroy(cloth);
    }
    support_context_end(context);
}
END_TEST


START_TEST(every_pair_of_neighbours_has_one_spring)
{
    mus_context *context = support_context();
    mus_cloth *cloth = cut_sheet(context, NULL);
    int32_t n = cloth->nnode, kinds[4] = {0}, total = 0;
    unsigned char *seen = calloc((size_t)n * (size_t)n, 1);
    for (int32_t r = 0; r < cloth->nrun; r++)
        for (int32_t i = 0; i < cloth->run[r].count; i++) {
            const mus__spring_run *run = &cloth->run[r];
            int32_t a = run->a + i, b = run->b + i;
            const double *p = cloth->rest + 2 * a, *q = cloth->rest + 2 * b;
            ck_assert_double_le(fabs(hypot(p[0] - q[0], p[1] - q[1]) - run->rest), 1e-15);
            ck_assert(a < cloth->panel[0].lattice_count && b < cloth->panel[0].lattice_count);
            ck_assert_int_eq(seen[(a < b ? a : b) * n + (a < b ? b : a)]++, 0);
            kinds[run->kind]++;
        }
    for (int32_t s = 0; s < cloth->nspring; s++) {
        int32_t a = cloth->spring[s].a, b = cloth->spring[s].b;
        ck_assert_int_eq(seen[(a < b ? a : b) * n + (a < b ? b : a)]++, 0);
        kinds[cloth->spring[s].kind]++;
    }

    /* 19 x 14 nodes make 18 x 13 full cells: 13 * 19 warp springs of which 2 * 13 lie on the rim, and so on */
    ck_assert_int_eq(kinds[MUS__SPRING_WARP], 13 * 19);
    ck_assert_int_eq(kinds[MUS__SPRING_WEFT], 18 * 14);
    ck_assert_int_eq(kinds[MUS__SPRING_SHEAR], 2 * 18 * 13);

    /* all edges of triangles, and the second diagonal of each full cell */
    int32_t edges = cloth->nnode + cloth->ntriangle - 1;
    for (int k = 0; k < 4; k++) total += kinds[k];
    ck_assert_int_eq(total, edges + 18 * 13);
    free(seen);
    mus_cloth_destroy(cloth);
    support_context_end(context);
}
END_TEST


START_TEST(runs_are_long)
{
    mus_context *context = support_context();
    mus_cloth *cloth = cut_sheet(context, NULL);

    /* one for each row and kind at most: 14 rows, 4 kinds of spring and 4 of stencil with their rims */
    ck_assert_int_le(cloth->nrun, 14 * 4);
    ck_assert_int_le(cloth->nbend, 14 * 4 * 3);
    mus_cloth_destroy(cloth);
    support_context_end(context);
}
END_TEST


/* energy of all stencils about one inner node on a cylinder of curvature `bow` along the direction `angle` */
static double bent(const mus_cloth *cloth, double angle, double bow)
{
    double *x = malloc(3 * (size_t)cloth->nnode * sizeof *x), sum = 0.0;
    for (int32_t i = 0; i < cloth->nnode; i++) {
        double u = cloth->rest[2 * i], v = cloth->rest[2 * i + 1];
        double along = (u * cos(angle) + v * sin(angle)) * bow;
        x[3 * i] = sin(along) / bow;
        x[3 * i + 1] = -u * sin(angle) + v * cos(angle);
        x[3 * i + 2] = (1.0 - cos(along)) / bow;
    }
    int32_t middle = cloth->panel[0].lattice_count / 2 + 9;
    for (int32_t r = 0; r < cloth->nbend; r++) {
        int32_t at = middle - cloth->bend[r].b;
        if (at >= 0 && at < cloth->bend[r].count) sum += cut_stencil_energy(&cloth->bend[r], at, x);
    }
    free(x);
    return sum;
}


START_TEST(stencils_bend_with_the_rigidity_of_the_fabric)
{
    /* energy on a cylinder of curvature `bow`: 1/2 B bow^2 per area along warp, weft and bias */
    mus_context *context = support_context();
    mus_fabric fabric;
    mus_fabric_init(&fabric, sizeof fabric);
    const double sets[3][3] = {{5e-6, 5e-6, 5e-6}, {6e-6, 4e-6, 4e-6}, {6e-6, 4e-6, 7e-6}};
    for (int k = 0; k < 3; k++) {
        memcpy(fabric.bend, sets[k], sizeof fabric.bend);
        mus_cloth *cloth = cut_sheet(context, &fabric);
        const double quarter = 0.785398163397448310, bow = 1.0;
        near(bent(cloth, 2.0 * quarter, bow), 0.5 * sets[k][0] * bow * bow * A * A, 1e-4);
        near(bent(cloth, 0.0, bow), 0.5 * sets[k][1] * bow * bow * A * A, 1e-4);
        near(bent(cloth, quarter, bow), 0.5 * sets[k][2] * bow * bow * A * A, 1e-4);

        /* a second difference along the lines sees 2 (1 - cos(t)) / t^2 of the curvature, t = bow * spacing */
        double seen = 2.0 * (1.0 - cos(0.2)) / (0.2 * 0.2);
        near(bent(cloth, 0.0, 20.0), 0.5 * sets[k][1] * 400.0 * A * A * seen * seen, 1e-4);
        mus_cloth_destroy(cloth);
    }
    support_context_end(context);
}
END_TEST


START_TEST(what_the_fabric_lacks_makes_no_springs)
{
    mus_context *context = support_context();
    mus_fabric fabric;
    mus_fabric_init(&fabric, sizeof fabric);
    fabric.shear = 0.0;
    memset(fabric.bend, 0, sizeof fabric.bend);
    mus_cloth *cloth = cut_sheet(context, &fabric);
    for (int32_t r = 0; r < cloth->nrun; r++) ck_assert_int_ne(cloth->run[r].kind, MUS__SPRING_SHEAR);
    ck_assert_int_eq(cloth->nbend, 0);
    ck_assert_int_eq(cloth->nhinge, 0);
    ck_assert_ptr_null(cloth->bend);
    ck_assert_ptr_null(cloth->hinge);
    mus_cloth_destroy(cloth);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_lattice_springs(void);
Suite *mus_suite_lattice_springs(void)
{
    Suite *suite = suite_create("lattice_springs");
    TCase *tests = tcase_create("spring");
    tcase_add_test(tests, a_sheet_has_the_moduli_of_its_fabric);
    tcase_add_test(tests, every_pair_of_neighbours_has_one_spring);
    tcase_add_test(tests, runs_are_long);
    tcase_add_test(tests, stencils_bend_with_the_rigidity_of_the_fabric);
    tcase_add_test(tests, what_the_fabric_lacks_makes_no_springs);
    suite_add_tcase(suite, tests);
    return suite;
}
