/*
 * test_contraction.c: lateral contraction: the forces are the gradient of an energy and cancel, in any pose; kernels
 * are the plain form on a pattern too; the bounds of stiffness hold and runs below the step bound keep their energy; a
 * strained sheet has the energy that its fabric says; without it, or below what the springs give, nothing is made.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <check.h>

#include "cloth/fabric.h"
#include "drape/drape_state.h"
#include "drape/scenes.h"
#include "sim/contraction.h"
#include "sim/force_reference.h"
#include "sim/step_bound.h"
#include "support.h"

#define CONTRACTION 0.38

enum { ROWS = 7, COLUMNS = 6, NODES = ROWS * COLUMNS };

Suite *mus_suite_contraction(void);


static mus_fabric woven(double contraction)
{
    mus_fabric fabric;
    mus_fabric_init(&fabric, sizeof fabric);
    fabric.weight = 0.15, fabric.damping = 0.0, fabric.contraction = contraction;
    fabric.stretch[0] = 3e3, fabric.stretch[1] = 2e3, fabric.shear = 30.0;
    for (int k = 0; k < 3; k++) fabric.bend[k] = 1e-5;
    return fabric;
}


/* a grid of cells 10 by 13 mm, without gravity */
static mus_drape *sheet(mus_context *context, double contraction, int32_t rows, int32_t columns, int32_t stepper)
{
    const double cell[2] = {0.010, 0.013};
    const mus_fabric fabric = woven(contraction);
    mus_cloth_def def;
    mus_drape_def scene;
    mus_cloth *cloth = NULL;
    mus_drape *drape = NULL;
    mus_cloth_def_init(&def, sizeof def);
    mus_drape_def_init(&scene, sizeof scene);
    def.fabric = &fabric;
    def.coarser = 0;
    scene.precision = 64;
    scene.gravity[1] = 0.0;
    scene.integrator = stepper;
    ck_assert_int_eq(mus_cloth_create_grid(context, rows, columns, cell, &def, &cloth), MUS_OK);
    ck_assert_int_eq(mus_drape_create(context, cloth, NULL, &scene, &drape), MUS_OK);
    mus_cloth_destroy(cloth);
    return drape;
}


/* the nodes of a sheet, stretched along weft and warp, turned, each moved by up to `shake` */
static void pose(const mus_drape *drape, double weft, double warp, double shake, uint64_t *random, double *x)
{
    for (int32_t i = 0; i < drape->n; i++) {
        const double *flat = drape->cloth->rest + 2 * (ptrdiff_t)i;
        x[3 * i] = 0.6 * weft * flat[0] + 0.8 * warp * flat[1] + support_uniform(random, -shake, shake);
        x[3 * i + 1] = 0.8 * weft * flat[0] - 0.6 * warp * flat[1] + support_uniform(random, -shake, shake);
        x[3 * i + 2] = 0.3 * weft * flat[0] + support_uniform(random, -shake, shake);
    }
}


START_TEST(forces_are_the_gradient_of_an_energy_and_cancel)
{
    mus_context *context = support_context();
    mus_drape *drape = sheet(context, CONTRACTION, ROWS, COLUMNS, MUS_METHOD_RK4);
    uint64_t random = 3;
    for (int round = 0; round < 20; round++) {
        double x[3 * NODES], f[3 * NODES] = {0.0}, sum[3] = {0.0}, moment[3] = {0.0}, size = 0.0;
        pose(drape, 0.8 + 0.02 * round, 1.2 - 0.02 * round, 1e-3 * round, &random, x);
        mus__contraction_force(&drape->program, x, f);
        for (int i = 0; i < NODES; i++)
            for (int d = 0; d < 3; d++) {
                const int e = (d + 1) % 3, g = (d + 2) % 3;
                sum[d] += f[3 * i + d], size += fabs(f[3 * i + d]);
                moment[d] += x[3 * i + e] * f[3 * i + g] - x[3 * i + g] * f[3 * i + e];
            }
        for (int d = 0; d < 3; d++) {
            ck_assert_double_eq_tol(sum[d], 0.0, 1e-13 * size);
            ck_assert_double_eq_tol(moment[d], 0.0, 1e-14 * size);
        }
        for (int k = 0; k < 3 * NODES; k += 5) {
            const double was = x[k], h = 1e-7;
            x[k] = was + h;
            const double up = mus__contraction_force(&drape->program, x, NULL);
            x[k] = was - h;
            const double down = mus__contraction_force(&drape->program, x, NULL);
            x[k] = was;
            ck_assert_double_eq_tol(f[k], (down - up) / (2.0 * h), 1e-7 * size);
        }
    }
    mus_drape_destroy(drape);
    support_context_end(context);
}
END_TEST


START_TEST(kernels_are_the_plain_form_on_a_pattern)
{
    mus_context *context = support_context();
    mus_pattern *pattern = scene_strips(context, 1.0);
    const mus_fabric fabric = woven(CONTRACTION);
    mus_cloth_def def;
    mus_cloth *cloth = NULL;
    mus_cloth_def_init(&def, sizeof def);
    def.fabric = &fabric, def.spacing = 0.006;
    ck_assert_int_eq(mus_cloth_create(context, pattern, &def, &cloth), MUS_OK);
    for (int32_t precision = 32; precision <= 64; precision += 32) {
        mus_drape *drape = scene_drape(context, cloth, precision, 2);
        const size_t bytes = 3 * (size_t)drape->n * sizeof(double);
        double *x = malloc(bytes), *f = malloc(bytes), *kernel = malloc(bytes), size = 0.0;
        uint64_t random = 9;
        memcpy(x, drape->x, bytes);
        for (int32_t i = 0; i < 3 * drape->n; i++) x[i] += support_uniform(&random, -0.002, 0.002);
        ck_assert_int_eq(mus_drape_set_state(drape, x, NULL), MUS_OK);
        drape->program.npair = 0;
        mus__program_force(&drape->program, drape->n, mus_drape_positions(drape), f);
        drape->program.npair = cloth->npair, drape->program.seam_pull = 0.0; /* it is no elastic force */
        drape->sim.ops->force(&drape->sim);
        drape->sim.ops->get_force(&drape->sim, kernel);
        ck_assert_int_gt(drape->program.nchunk, 3);
        for (int32_t i = 0; i < 3 * drape->n; i++) size = fmax(size, fabs(f[i]));
        for (int32_t i = 0; i < 3 * drape->n; i++)
            ck_assert_double_eq_tol(kernel[i], f[i], (precision == 64 ? 1e-13 : 2e-5) * size);
        free(x), free(f), free(kernel);
        mus_drape_destroy(drape);
    }
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


/* d.K.d of all forces at a pose, against the sum of T_i |d_i|^2, for changes d at random and smooth ones */
START_TEST(the_bounds_of_stiffness_hold)
{
    mus_context *context = support_context();
    mus_drape *drape = sheet(context, 0.9, ROWS, COLUMNS, MUS_METHOD_RK4);
    uint64_t random = 5;
    double t[2][NODES], work[6 * NODES], tight = 0.0;
    mus__program_stiffness(&drape->program, NODES, t[0]);
    for (int round = 0; round < 400; round++) {
        double x[3 * NODES], d[3 * NODES], f[2][3 * NODES];
        pose(drape, 0.7 + 0.06 * (round % 11), 0.7 + 0.06 * (round % 7), 1e-4 * (round % 13), &random, x);
        mus__program_stiffness_at(&drape->program, NODES, x, t[1], work);
        for (int i = 0; i < 3 * NODES; i++) d[i] = support_uniform(&random, -1.0, 1.0);

        /* a few rounds of power iteration find what is stiffest */
        double most = 0.0;
        for (int pass = 0; pass < 12; pass++) {
            double size = 0.0, along = 0.0, bound[2] = {0.0};
            for (int i = 0; i < 3 * NODES; i++) size += d[i] * d[i];
            for (int side = 0; side < 2; side++) {
                double y[3 * NODES];
                for (int i = 0; i < 3 * NODES; i++) y[i] = x[i] + (side ? 1e-8 : -1e-8) * d[i] / sqrt(size);
                mus__program_force(&drape->program, NODES, y, f[side]);
            }
            for (int i = 0; i < 3 * NODES; i++) {
                const double push = (f[0][i] - f[1][i]) / 2e-8;
                along += d[i] * push / sqrt(size);
                for (int k = 0; k < 2; k++) bound[k] += t[k][i / 3] * d[i] * d[i] / size;
                d[i] = push;
            }
            ck_assert_msg(along <= bound[0] * (1.0 + 1e-6) && along <= bound[1] * (1.0 + 1e-6),
                          "%g, bounds %g %g N/m", along, bound[0], bound[1]);
            most = fmax(most, along / bound[1]);
        }
        tight = fmax(tight, most);
    }
    ck_assert_double_gt(tight, 0.5);
    mus_drape_destroy(drape);
    support_context_end(context);
}
END_TEST


/* 4000 steps of a sheet pulled by 5 % and let go: RK4 at 0.99 of the bound; Verlet at 0.8, as so violent a motion gains
 * energy at 0.99 without contraction too, and its energy swings */
START_TEST(runs_below_the_step_bound_keep_their_energy)
{
    const double part = _i == MUS_METHOD_RK4 ? 0.99 : 0.8, most = _i == MUS_METHOD_RK4 ? 1.0 : 1.06;
    mus_context *context = support_context();
    mus_drape *drape = sheet(context, CONTRACTION, ROWS, COLUMNS, _i);
    uint64_t random = 8;
    double x[3 * NODES];
    pose(drape, 1.05, 1.0, 2e-4, &random, x);
    ck_assert_int_eq(mus_drape_set_state(drape, x, NULL), MUS_OK);
    mus_drape_report report;
    mus_drape_report_init(&report, sizeof report);
    ck_assert_int_eq(mus_drape_report_get(drape, &report), MUS_OK);
    const double start = report.energy;
    for (int k = 0; k < 40; k++)
        ck_assert_msg(mus_drape_step(drape, 100, part * mus_drape_step_bound(drape)) == MUS_OK, "%s",
                      mus_context_error(context));
    ck_assert_int_eq(mus_drape_report_get(drape, &report), MUS_OK);
    ck_assert_msg(report.energy <= most * start, "%g J of %g", report.energy, start);
    mus_drape_destroy(drape);
    support_context_end(context);
}
END_TEST


/* E = C p q psi psi at strains e along the weft and g along the warp of the whole sheet, C from the fabric */
START_TEST(a_strained_sheet_has_the_energy_of_its_contraction)
{
    mus_context *context = support_context();
    mus_drape *with = sheet(context, CONTRACTION, ROWS, COLUMNS, MUS_METHOD_RK4);
    mus_drape *without = sheet(context, 0.0, ROWS, COLUMNS, MUS_METHOD_RK4);
    const double e = 1e-3, g = -2e-3, couple = CONTRACTION * 2e3 - 30.0;
    double x[3 * NODES] = {0.0};
    for (int i = 0; i < NODES; i++)
        x[3 * i] = (1.0 + e) * with->cloth->rest[2 * i], x[3 * i + 2] = (1.0 + g) * with->cloth->rest[2 * i + 1];
    const double more = mus__program_force(&with->program, NODES, x, NULL) -
                        mus__program_force(&without->program, NODES, x, NULL);
    const double area = 0.010 * 0.013 * (ROWS - 1) * (COLUMNS - 1);
    ck_assert_double_eq_tol(more, couple * e * g * area, 5e-3 * fabs(couple * e * g * area));
    ck_assert_double_eq_tol(with->program.couple, couple, 1e-9);
    mus_drape_destroy(with);
    mus_drape_destroy(without);
    support_context_end(context);
}
END_TEST


/* folded along its diagonal, a cell keeps the lengths of its edges: it has no strain, and no energy */
START_TEST(a_folded_cell_has_no_strain)
{
    mus_context *context = support_context();
    mus_drape *drape = sheet(context, CONTRACTION, 2, 2, MUS_METHOD_RK4);
    const double p = 0.010, q = 0.013, angle = 0.5, size2 = p * p + q * q;
    double f[12] = {0.0}, x[12] = {0.0, 0.0, 0.0, p, 0.0, 0.0, 0.0, q, 0.0, p, q, 0.0};

    /* node 3 turns about the line from node 1 to node 2: along the line it stays, across it leaves the plane */
    const double along = q * q / size2, foot[2] = {p * (1.0 - along), q * along}, c = cos(angle), s = sin(angle);
    x[9] = foot[0] + c * (p - foot[0]), x[10] = foot[1] + c * (q - foot[1]);
    x[11] = s * hypot(p - foot[0], q - foot[1]);
    ck_assert_double_eq_tol(hypot(x[9] - p, hypot(x[10], x[11])), q, 1e-12);
    ck_assert_double_eq_tol(hypot(x[9], hypot(x[10] - q, x[11])), p, 1e-12);
    ck_assert_double_eq_tol(mus__contraction_force(&drape->program, x, f), 0.0, 1e-20);
    for (int i = 0; i < 12; i++) ck_assert_double_eq_tol(f[i], 0.0, 1e-10);
    mus_drape_destroy(drape);
    support_context_end(context);
}
END_TEST


/* a bare value below what the springs give makes nothing: the same bytes, the same memory, the same steps */
START_TEST(without_it_nothing_is_made)
{
    const double contraction[] = {0.0, 0.014};
    uint64_t hash[2];
    for (int k = 0; k < 2; k++) {
        mus_context *context = support_context();
        mus_drape *drape = sheet(context, contraction[k], ROWS, COLUMNS, MUS_METHOD_VERLET);
        uint64_t random = 8;
        double x[3 * NODES];
        pose(drape, 1.0, 1.0, 2e-4, &random, x);
        ck_assert_int_eq(mus_drape_set_state(drape, x, NULL), MUS_OK);
        ck_assert_int_eq(mus_drape_step(drape, 100, mus_drape_step_bound(drape)), MUS_OK);
        ck_assert_ptr_null(drape->program.cell);
        ck_assert_int_eq(drape->program.chunk[0].ncell, 0);
        hash[k] = mus_drape_hash(drape);
        if (k == 1) ck_assert_ptr_nonnull(strstr(support_log(), "contraction 0.014 is less than its shear gives"));
        mus_drape_destroy(drape);
        support_context_end(context);
    }
    ck_assert(hash[0] == hash[1]);
}
END_TEST


START_TEST(a_coupling_is_clamped_and_memory_may_fail)
{
    mus_fabric fabric = woven(1.0);
    fabric.stretch[0] = 500.0;
    const double cell[2] = {0.01, 0.01};
    mus__fabric_lattice lattice;
    mus__fabric_on_cell(&fabric, cell, &lattice);
    ck_assert_double_lt(lattice.couple, sqrt(lattice.k[0] * lattice.k[1]));
    ck_assert_double_lt(lattice.couple, 1970.0);
    for (int64_t n = 0;; n++) {
        mus_context *context = support_context();
        const double side[2] = {0.01, 0.01};
        mus_cloth_def def;
        mus_cloth *cloth = NULL;
        mus_drape *drape = NULL;
        mus_cloth_def_init(&def, sizeof def);
        def.fabric = &fabric;
        support_fail_after(n, false);
        mus_status status = mus_cloth_create_grid(context, 4, 4, side, &def, &cloth);
        if (status == MUS_OK) status = mus_drape_create(context, cloth, NULL, NULL, &drape);
        support_fail_never();
        mus_drape_destroy(drape);
        mus_cloth_destroy(cloth);
        support_context_end(context);
        if (status == MUS_OK) break;
        ck_assert_int_eq(status, MUS_ERR_MEMORY);
    }
}
END_TEST


Suite *mus_suite_contraction(void)
{
    Suite *suite = suite_create("contraction");
    TCase *tests = tcase_create("contraction");
    tcase_add_test(tests, forces_are_the_gradient_of_an_energy_and_cancel);
    tcase_add_test(tests, kernels_are_the_plain_form_on_a_pattern);
    tcase_add_test(tests, the_bounds_of_stiffness_hold);
    tcase_add_loop_test(tests, runs_below_the_step_bound_keep_their_energy, MUS_METHOD_RK4, MUS_METHOD_VERLET + 1);
    tcase_add_test(tests, a_strained_sheet_has_the_energy_of_its_contraction);
    tcase_add_test(tests, a_folded_cell_has_no_strain);
    tcase_add_test(tests, without_it_nothing_is_made);
    tcase_add_test(tests, a_coupling_is_clamped_and_memory_may_fail);
    suite_add_tcase(suite, tests);
    return suite;
}
