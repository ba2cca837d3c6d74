/*
 * test_rectangle_cloth.c: rectangles without a pattern: mass, stretch, shear and bending against the fabric's moduli;
 * the smallest rectangles.
 */
#include "cut.h"

#include "cloth/fabric.h"
#include "muslin/drape.h"


static void grid_near(double got, double want, double tolerance)
{
    ck_assert_msg(fabs(got - want) <= tolerance * fabs(want), "%.17g, expected %.17g within %g", got, want, tolerance);
}


static mus_cloth *grid_cloth(mus_context *context, int32_t rows, int32_t columns, double x, double y,
                             const mus_fabric *fabric)
{
    const double cell[2] = {x, y};
    mus_cloth_def def;
    mus_cloth *cloth;
    mus_cloth_def_init(&def, sizeof def);
    def.fabric = fabric;
    ck_assert_msg(mus_cloth_create_grid(context, rows, columns, cell, &def, &cloth) == MUS_OK, "%s",
                  mus_context_error(context));
    return cloth;
}


/* energy of the springs under x -> (1 + e) x with e = (weft, warp, shear), over the area; exact second order */
static double grid_strained(const mus_cloth *cloth, double area, double weft, double warp, double shear)
{
    double energy = 0.0;
    for (int32_t n = 0; n < cloth->nrun; n++) {
        const mus__spring_run *run = &cloth->run[n];
        for (int32_t i = 0; i < run->count; i++) {
            const double *p = cloth->rest + 2 * (run->a + i), *q = cloth->rest + 2 * (run->b + i);
            const double x = q[0] - p[0], y = q[1] - p[1];
            grid_near(hypot(x, y), run->rest, 1e-14);
            const double stretch = (weft * x * x + warp * y * y + shear * x * y) / run->rest;
            energy += 0.5 * run->k * stretch * stretch;
        }
    }
    return energy / area;
}


/* energy of the stencils on the surface z = (p x^2 + q y^2) / 2 + r x y; `inside` counts whole stencils by area */
static double grid_bent(const mus_cloth *cloth, double p, double q, double r)
{
    double energy = 0.0;
    for (int32_t n = 0; n < cloth->nbend; n++) {
        const mus__bend_run *bend = &cloth->bend[n];
        for (int32_t i = 0; i < bend->count; i++) {
            double z[3];
            const int32_t node[3] = {bend->a + i, bend->b + i, bend->c + i};
            for (int k = 0; k < 3; k++) {
                const double x = cloth->rest[2 * node[k]], y = cloth->rest[2 * node[k] + 1];
                z[k] = 0.5 * (p * x * x + q * y * y) + r * x * y;
            }
            const double e = z[0] - 2.0 * z[1] + z[2];
            energy += 0.5 * bend->k * e * e;
        }
    }
    return energy;
}


START_TEST(a_grid_weighs_its_area)
{
    mus_context *context = support_context();
    mus_cloth *cloth = grid_cloth(context, 5, 7, 0.02, 0.01, NULL);
    const double weight = cloth->fabric.weight, *mass = mus_cloth_masses(cloth);
    double sum = 0.0;
    for (int32_t i = 0; i < mus_cloth_node_count(cloth); i++) sum += mass[i];
    ck_assert_int_eq(mus_cloth_node_count(cloth), 35);
    grid_near(sum, weight * 0.12 * 0.04, 1e-14);
    grid_near(mus_cloth_mass(cloth), weight * 0.12 * 0.04, 1e-15);
    grid_near(mass[0], 0.25 * mass[8], 1e-15);
    grid_near(mass[3], 0.5 * mass[8], 1e-15);
    grid_near(mass[34], mass[0], 1e-15);

    /* node r * columns + c at (c x, r y) */
    grid_near(mus_cloth_rest(cloth)[2 * (3 * 7 + 5)], 0.1, 1e-15);
    grid_near(mus_cloth_rest(cloth)[2 * (3 * 7 + 5) + 1], 0.03, 1e-15);
    ck_assert_double_eq(mus_cloth_spacing(cloth), 0.01);
    mus_cloth_destroy(cloth);
    support_context_end(context);
}
END_TEST


START_TEST(a_grid_is_the_measured_membrane_in_any_cell)
{
    static const double cell[4][2] = {{0.01, 0.01}, {0.02, 0.01}, {0.007, 0.013}, {0.001, 0.001}};
    mus_context *context = support_context();
    mus_fabric fabric;
    mus_fabric_init(&fabric, sizeof fabric);
    fabric.stretch[0] = 900.0, fabric.stretch[1] = 500.0, fabric.shear = 40.0;
    for (int k = 0; k < 4; k++) {
        const double area = 9 * cell[k][0] * 6 * cell[k][1];
        mus_cloth *cloth = grid_cloth(context, 7, 10, cell[k][0], cell[k][1], &fabric);
        grid_near(2.0 * grid_strained(cloth, area, 0.0, 1.0, 0.0), 900.0, 1e-12);
        grid_near(2.0 * grid_strained(cloth, area, 1.0, 0.0, 0.0), 500.0, 1e-12);
        grid_near(2.0 * grid_strained(cloth, area, 0.0, 0.0, 1.0), 40.0, 1e-12);

        /* C12 = G: the law of central springs */
        grid_near(2.0 * grid_strained(cloth, area, 1.0, 1.0, 0.0), 900.0 + 500.0 + 2 * 40.0, 1e-12);
        mus_cloth_destroy(cloth);
    }
    support_context_end(context);
}
END_TEST


START_TEST(a_grid_bends_as_its_fabric_in_any_cell)
{
    static const double cell[3][2] = {{0.01, 0.01}, {0.02, 0.015}, {0.007, 0.006}};
    mus_context *context = support_context();
    mus_fabric fabric;
    mus_fabric_init(&fabric, sizeof fabric);
    fabric.bend[0] = 9e-6, fabric.bend[1] = 6e-6, fabric.bend[2] = 7e-6;
    const int32_t rows = 41, columns = 51;
    for (int k = 0; k < 3; k++) {
        const double x = cell[k][0], y = cell[k][1];
        mus_cloth *cloth = grid_cloth(context, rows, columns, x, y, &fabric);

        /* a line of stencils along the warp covers rows - 2 cells; diagonals are missing on the whole border */
        mus__fabric_lattice c;
        mus__fabric_on_cell(&fabric, cell[k], &c);
        const double inner = (rows - 2) * (columns - 2) * x * y;
        const double warp = (rows - 2) * (columns - 1) * x * y, weft = (rows - 1) * (columns - 2) * x * y;
        const double line[2] = {c.bend[0] * y * y * y / x, c.bend[1] * x * x * x / y};
        const double d12 = 2.0 * c.cross * x * y, d11 = 2.0 * c.cross * y * y * y / x;
        const double d22 = 2.0 * c.cross * x * x * x / y;
        grid_near(line[0] + d11, 9e-6, 1e-12);
        grid_near(line[1] + d22, 6e-6, 1e-12);
        grid_near(0.25 * (line[0] + d11 + line[1] + d22) + 1.5 * d12, 7e-6, 1e-12);
        grid_near(2.0 * grid_bent(cloth, 0.0, 1.0, 0.0), line[0] * warp + d11 * inner, 1e-9);
        grid_near(2.0 * grid_bent(cloth, 1.0, 0.0, 0.0), line[1] * weft + d22 * inner, 1e-9);

        /* bent along 45 degrees: p = q = r = 1/2 */
        grid_near(2.0 * grid_bent(cloth, 0.5, 0.5, 0.5),
                  0.25 * (line[0] * warp + line[1] * weft) + (0.25 * (d11 + d22) + 1.5 * d12) * inner, 1e-9);
        mus_cloth_destroy(cloth);
    }
    support_context_end(context);
}
END_TEST


static mus_cloth *grid_paper(mus_context *context, const double *cell, double stretch, double curvature)
{
    mus_cloth_def def;
    mus_cloth *cloth;
    mus_cloth_def_init(&def, sizeof def);
    mus_fabric fabric;
    mus_fabric_init(&fabric, sizeof fabric);
    def.fabric = &fabric;
    ck_assert_int_eq(def.bending, MUS_BEND_PLATE);
    ck_assert_double_eq(def.paper_curvature, 30.0);
    def.bending = MUS_BEND_PAPER;
    def.paper_curvature = curvature;
    fabric.stretch[0] = stretch, fabric.stretch[1] = 0.8 * stretch;
    ck_assert_msg(mus_cloth_create_grid(context, 9, 31, cell, &def, &cloth) == MUS_OK, "%s",
                  mus_context_error(context));
    return cloth;
}


/* moment of the springs over one node a width of cloth, by differences of the energy on a cylinder round the warp */
static double grid_moment(const mus_cloth *cloth, double curvature)
{
    double energy[2] = {0.0, 0.0};
    const double width = mus_cloth_rest(cloth)[2 * (31 * 8) + 1], length = mus_cloth_rest(cloth)[2 * 30];
    for (int side = 0; side < 2; side++) {
        const double at = curvature * (side ? 1.001 : 0.999);
        for (int32_t n = 0; n < cloth->nrun; n++) {
            const mus__spring_run *run = &cloth->run[n];
            if (run->kind != MUS__SPRING_SKIP || run->b != run->a + 2) continue;

            /* two chords of a cell each */
            const double cell = 0.5 * run->rest, half = asin(0.5 * at * cell);
            const double stretch = 2.0 * cell * cos(half) - run->rest;
            energy[side] += run->count * 0.5 * run->k * stretch * stretch;
        }
    }
    return (energy[1] - energy[0]) / (0.002 * curvature) / (width * length * 29.0 / 30.0);
}


/* bending springs have the fabric's moment at the curvature that they are fitted at, and less below it */
START_TEST(the_springs_of_the_paper_are_right_at_one_curvature)
{
    static const double cell[2][2] = {{0.01, 0.01}, {0.005, 0.02}};
    mus_context *context = support_context();
    for (int k = 0; k < 2; k++) {
        mus_cloth *cloth = grid_paper(context, cell[k], 3000.0, 20.0);
        ck_assert_int_eq(cloth->nbend, 0);

        /* chords of a cell: the fold is (K a)^2 / 12 away from an arc's */
        grid_near(grid_moment(cloth, 20.0), 5e-6 * 20.0, 0.02);
        grid_near(grid_moment(cloth, 2.0) / (5e-6 * 2.0), 0.01, 0.02);

        /* the springs along the lines are softer by the stretch stiffness of the bending springs */
        const double area = 30 * cell[k][0] * 8 * cell[k][1], *skip = cell[k];
        mus__fabric_lattice c;
        mus__fabric_on_cell(&cloth->fabric, skip, &c);
        mus__fabric_on_paper(&cloth->fabric, skip, 20.0, &c);
        const double missing = 4.0 * c.skip[1] * skip[0] / skip[1] / 30.0;
        grid_near(2.0 * grid_strained(cloth, area, 1.0, 0.0, 0.0), 2400.0 - missing, 1e-12);
        mus_cloth_destroy(cloth);
    }

    /* a knit on a fine lattice has less stretch than these springs take: the lines keep a tenth */
    const double fine[2] = {0.002, 0.002};
    mus_cloth *cloth = grid_paper(context, fine, 300.0, 30.0);
    double least = INFINITY;
    for (int32_t r = 0; r < cloth->nrun; r++)
        if (cloth->run[r].kind == MUS__SPRING_WARP && cloth->run[r].count > 1) least = fmin(least, cloth->run[r].k);
    grid_near(least, 30.0, 1e-12);
    mus_cloth_destroy(cloth);
    support_context_end(context);
}
END_TEST


START_TEST(a_square_grid_is_the_lattice_of_a_panel)
{
    mus_context *context = support_context();
    mus_fabric fabric;
    mus_fabric_init(&fabric, sizeof fabric);
    mus_pattern *pattern = cut_begin(context);
    cut_rectangle(pattern, "sheet", 0.2, 0.15, NULL);
    mus_cloth *cut = cut_cloth(context, pattern, 0.01, &fabric), *grid = grid_cloth(context, 14, 19, 0.01, 0.01, NULL);
    mus_pattern_destroy(pattern);

    /* 19 x 14 lattice nodes: the inner runs have the same stiffness, to the bit */
    double inner[4] = {0.0}, other[4] = {0.0};
    for (int32_t r = 0; r < grid->nrun; r++) inner[grid->run[r].kind] = fmax(inner[grid->run[r].kind], grid->run[r].k);
    for (int32_t r = 0; r < cut->nrun; r++) other[cut->run[r].kind] = fmax(other[cut->run[r].kind], cut->run[r].k);
    for (int k = 0; k < 3; k++) ck_assert_double_eq(inner[k], other[k]);
    ck_assert_int_eq(cut->panel[0].lattice_count, grid->nnode);
    mus_cloth_destroy(cut);
    mus_cloth_destroy(grid);
    support_context_end(context);
}
END_TEST


START_TEST(springs_of_a_grid_are_counted)
{
    /* rows x columns: structural and shear springs, stencils along lines and diagonals, triangles, border */
    static const int32_t table[][7] = {{1, 1, 0, 0, 0, 0, 1},  {1, 2, 1, 0, 0, 0, 2},     {2, 2, 4, 2, 0, 2, 4},
                                       {1, 6, 5, 0, 4, 0, 6},  {6, 1, 5, 0, 4, 0, 6},     {2, 3, 7, 4, 2, 4, 6},
                                       {3, 3, 12, 8, 8, 8, 8}, {4, 5, 31, 24, 34, 24, 14}};
    mus_context *context = support_context();
    for (size_t t = 0; t < sizeof table / sizeof *table; t++) {
        const int32_t *want = table[t];
        mus_cloth *cloth = grid_cloth(context, want[0], want[1], 0.01, 0.01, NULL);
        int32_t line = 0, shear = 0, bend = 0, n, range[4];
        const int32_t *border;
        for (int32_t r = 0; r < cloth->nrun; r++)
            *(cloth->run[r].kind == MUS__SPRING_SHEAR ? &shear : &line) += cloth->run[r].count;
        for (int32_t r = 0; r < cloth->nbend; r++) bend += cloth->bend[r].count;
        ck_assert_int_eq(line, want[2]);
        ck_assert_int_eq(shear, want[3]);
        ck_assert_int_eq(bend, want[4]);
        ck_assert_int_eq(mus_cloth_triangle_count(cloth), want[5]);
        ck_assert_int_eq(mus_cloth_spring_count(cloth), line + shear + bend);
        ck_assert_int_eq(mus_cloth_panel_border(cloth, 0, &n, &border), MUS_OK);
        ck_assert_int_eq(n, want[6]);
        ck_assert_int_eq(mus_cloth_panel_range(cloth, 0, range), MUS_OK);
        ck_assert_int_eq(range[1], want[0] * want[1]);

        /* the border runs round, each node once, a cell apart */
        for (int32_t i = 1; i < n; i++) {
            const double *p = cloth->rest + 2 * border[i - 1], *q = cloth->rest + 2 * border[i];
            grid_near(hypot(q[0] - p[0], q[1] - p[1]), 0.01, 1e-12);
        }
        for (int32_t i = 0; i < cloth->ntriangle; i++) {
            const int32_t *v = cloth->triangle + 3 * i;
            const double *p = cloth->rest + 2 * v[0], *q = cloth->rest + 2 * v[1], *r = cloth->rest + 2 * v[2];
            grid_near((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]), 1e-4, 1e-12);
        }
        mus_cloth_destroy(cloth);
    }
    support_context_end(context);
}
END_TEST


START_TEST(what_a_fabric_lacks_makes_no_items)
{
    mus_context *context = support_context();
    mus_fabric fabric;
    mus_fabric_init(&fabric, sizeof fabric);
    fabric.shear = 0.0;
    for (int k = 0; k < 3; k++) fabric.bend[k] = 0.0;
    mus_cloth *cloth = grid_cloth(context, 5, 5, 0.01, 0.01, &fabric);
    ck_assert_int_eq(cloth->nbend, 0);
    ck_assert_int_eq(mus_cloth_spring_count(cloth), 40);
    mus_cloth_destroy(cloth);

    /* a single line of nodes carries the whole modulus on one cell of width */
    cloth = grid_cloth(context, 4, 1, 0.02, 0.01, NULL);
    grid_near(cloth->run[0].k, cloth->fabric.stretch[0] * 2.0, 1e-14);
    grid_near(mus_cloth_mass(cloth), cloth->fabric.weight * 0.02 * 0.03, 1e-14);
    mus_cloth_destroy(cloth);
    support_context_end(context);
}
END_TEST


/* the smallest grids fall as a stone does and keep their shape, in both precisions */
START_TEST(the_smallest_grids_fall_freely)
{
    static const int32_t size[5][2] = {{1, 1}, {1, 2}, {2, 2}, {1, 9}, {9, 1}};
    for (int k = 0; k < 10; k++) {
        mus_context *context = support_context();
        const int32_t *n = size[k / 2];
        mus_cloth *cloth = grid_cloth(context, n[0], n[1], 0.01, 0.02, NULL);
        mus_drape_def def;
        mus_drape *drape;
        mus_drape_def_init(&def, sizeof def);
        def.precision = k % 2 ? 64 : 32;
        def.drag = 0.0;
        ck_assert_int_eq(mus_drape_create(context, cloth, NULL, &def, &drape), MUS_OK);
        ck_assert_int_eq(mus_drape_place(drape), MUS_OK);
        const double bound = mus_drape_step_bound(drape), h = fmin(0.5 * bound, 1e-3);
        ck_assert_double_gt(bound, 0.0);
        const int32_t steps = (int32_t)(0.05 / h);
        ck_assert_int_eq(mus_drape_step(drape, steps, h), MUS_OK);
        const double t = steps * h, *x = mus_drape_positions(drape), *rest = mus_cloth_rest(cloth);
        for (int32_t i = 0; i < n[0] * n[1]; i++) {
            ck_assert_double_eq_tol(x[3 * i], rest[2 * i], k % 2 ? 1e-14 : 1e-7);
            ck_assert_double_eq_tol(x[3 * i + 1], rest[2 * i + 1] - 0.5 * 9.81 * t * t, k % 2 ? 1e-13 : 2e-6);
            ck_assert_double_eq_tol(x[3 * i + 2], 0.0, 1e-15);
        }
        mus_drape_destroy(drape);
        mus_cloth_destroy(cloth);
        support_context_end(context);
    }
}
END_TEST


/* a hanging strip stretches by weight L^2 / (2 Y) for every number of cells, and for a single line of nodes */
START_TEST(a_hanging_strip_stretches_exactly)
{
    static const int32_t size[4][2] = {{5, 2}, {9, 4}, {5, 1}, {17, 2}};
    mus_context *context = support_context();
    mus_fabric fabric;
    mus_fabric_init(&fabric, sizeof fabric);
    fabric.weight = 0.15, fabric.stretch[0] = fabric.stretch[1] = 1000.0, fabric.shear = 0.0, fabric.damping = 0.3;
    for (int k = 0; k < 3; k++) fabric.bend[k] = 0.0;
    for (int k = 0; k < 4; k++) {
        const int32_t rows = size[k][0], columns = size[k][1];
        mus_cloth *cloth = grid_cloth(context, rows, columns, 0.01, 1.0 / (rows - 1), &fabric);
        mus_drape_def def;
        mus_drape *drape;
        mus_drape_def_init(&def, sizeof def);
        def.precision = 64, def.drag = 60.0;
        ck_assert_int_eq(mus_drape_create(context, cloth, NULL, &def, &drape), MUS_OK);
        for (int32_t c = 0; c < columns; c++)
            ck_assert_int_eq(mus_drape_pin(drape, (rows - 1) * columns + c, 1), MUS_OK);
        const double h = 0.9 * mus_drape_step_bound(drape);
        ck_assert_int_eq(mus_drape_step(drape, (int32_t)(1.5 / h), h), MUS_OK);
        const double sag = -mus_drape_positions(drape)[1];
        grid_near(sag, 0.15 * 9.81 / (2.0 * 1000.0), 1e-9);
        mus_drape_destroy(drape);
        mus_cloth_destroy(cloth);
    }
    support_context_end(context);
}
END_TEST


/* a lattice of springs cannot have every C11 and G: a value that is clamped is logged once, with its name */
START_TEST(what_a_grid_cannot_be_is_said)
{
    mus_context *context = support_context();
    mus_fabric good, fabric;
    mus_fabric_init(&good, sizeof good);
    mus_cloth_destroy(grid_cloth(context, 40, 40, 0.01, 0.01, &good));
    ck_assert_str_eq(support_log(), "");
    const struct {
        double shear, bias;
        const char *word;
    } row[] = {{190.0, 5e-6, "shear 190 N/m is too near to weft stretch 200"},
               {40.0, 1.1e-5, "bias bend 1.1e-05 N m is too far above weft bend 5e-06"},
               {40.0, 2e-6, "bias bend 2e-06 N m is below"}};
    for (int k = 0; k < 3; k++) {
        fabric = good;
        fabric.shear = row[k].shear, fabric.bend[2] = row[k].bias;
        mus_cloth_destroy(grid_cloth(context, 40, 40, 0.01, 0.01, &fabric));
        ck_assert_msg(strstr(support_log(), row[k].word) != NULL, "%s", support_log());
    }
    support_context_end(context);
}
END_TEST


static void grid_refused(mus_context *context, int32_t rows, int32_t columns, double x, double y,
                         const mus_cloth_def *def, mus_status want, const char *word)
{
    const double cell[2] = {x, y};
    const size_t bytes = mus_context_bytes(context);
    mus_cloth *cloth = (mus_cloth *)&bytes;
    ck_assert_int_eq(mus_cloth_create_grid(context, rows, columns, cell, def, &cloth), want);
    ck_assert_ptr_null(cloth);
    ck_assert_uint_eq(mus_context_bytes(context), bytes);
    ck_assert_msg(strstr(mus_context_error(context), word) != NULL, "%s", mus_context_error(context));
}


START_TEST(a_grid_that_cannot_be_is_refused)
{
    mus_context *context = support_context();
    mus_cloth_def def;
    mus_cloth_def_init(&def, sizeof def);
    mus_fabric fabric;
    mus_fabric_init(&fabric, sizeof fabric);
    def.fabric = &fabric;
    def.spacing = (double)NAN; /* not read */
    grid_refused(context, 0, 3, 0.01, 0.01, &def, MUS_ERR_ARG, "0 rows");
    grid_refused(context, 3, -1, 0.01, 0.01, &def, MUS_ERR_ARG, "-1 columns");
    grid_refused(context, 3, 3, 0.0, 0.01, &def, MUS_ERR_ARG, "weft");
    grid_refused(context, 3, 3, 0.01, (double)NAN, &def, MUS_ERR_ARG, "warp");
    grid_refused(context, 3, 3, 0.01, 11.0, NULL, MUS_ERR_ARG, "11 m");
    grid_refused(context, 4097, 4097, 0.01, 0.01, &def, MUS_ERR_LIMIT, "2^24");
    grid_refused(context, INT32_MAX, INT32_MAX, 0.01, 0.01, &def, MUS_ERR_LIMIT, "2^24");
    fabric.shear = (double)INFINITY;
    grid_refused(context, 3, 3, 0.01, 0.01, &def, MUS_ERR_ARG, "shear");
    mus_cloth_def_init(&def, sizeof def);
    def.bending = 2;
    grid_refused(context, 3, 3, 0.01, 0.01, &def, MUS_ERR_ARG, "bending 2");
    def.bending = MUS_BEND_PAPER, def.paper_curvature = 0.0;
    grid_refused(context, 3, 3, 0.01, 0.01, &def, MUS_ERR_ARG, "paper_curvature 0");
    def.size = 3;
    grid_refused(context, 3, 3, 0.01, 0.01, &def, MUS_ERR_VERSION, "mus_cloth_def");
    mus_cloth *cloth;
    const double cell[2] = {0.01, 0.01};
    ck_assert_int_eq(mus_cloth_create_grid(NULL, 3, 3, cell, NULL, &cloth), MUS_ERR_ARG);
    ck_assert_int_eq(mus_cloth_create_grid(context, 3, 3, NULL, NULL, &cloth), MUS_ERR_ARG);
    ck_assert_int_eq(mus_cloth_create_grid(context, 3, 3, cell, NULL, NULL), MUS_ERR_ARG);
    support_context_end(context);
}
END_TEST


START_TEST(a_grid_without_memory_leaves_nothing_behind)
{
    const double cell[2] = {0.01, 0.01};
    for (int64_t n = 0;; n++) {
        mus_context *context = support_context();
        mus_cloth *cloth;
        support_fail_after(n, false);
        mus_status status = mus_cloth_create_grid(context, 4, 5, cell, NULL, &cloth);
        support_fail_never();
        ck_assert_int_eq(status == MUS_OK, cloth != NULL);
        mus_cloth_destroy(cloth);
        support_context_end(context);
        if (status == MUS_OK) break;
        ck_assert_int_eq(status, MUS_ERR_MEMORY);
    }
}
END_TEST


Suite *mus_suite_rectangle_cloth(void);
Suite *mus_suite_rectangle_cloth(void)
{
    Suite *suite = suite_create("rectangle_cloth");
    TCase *tests = tcase_create("grid");
    tcase_set_timeout(tests, 30.0);
    tcase_add_test(tests, a_grid_weighs_its_area);
    tcase_add_test(tests, a_grid_is_the_measured_membrane_in_any_cell);
    tcase_add_test(tests, a_grid_bends_as_its_fabric_in_any_cell);
    tcase_add_test(tests, the_springs_of_the_paper_are_right_at_one_curvature);
    tcase_add_test(tests, a_square_grid_is_the_lattice_of_a_panel);
    tcase_add_test(tests, springs_of_a_grid_are_counted);
    tcase_add_test(tests, what_a_fabric_lacks_makes_no_items);
    tcase_add_test(tests, the_smallest_grids_fall_freely);
    tcase_add_test(tests, a_hanging_strip_stretches_exactly);
    tcase_add_test(tests, what_a_grid_cannot_be_is_said);
    tcase_add_test(tests, a_grid_that_cannot_be_is_refused);
    tcase_add_test(tests, a_grid_without_memory_leaves_nothing_behind);
    suite_add_tcase(suite, tests);
    return suite;
}
