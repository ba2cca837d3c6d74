/*
 * test_bend_slider.c: friction of bending: the moment of a strip bent once is the upper line of KES's loop; let go, it
 * keeps a curvature below 2HB over 2B; turned as a whole it feels nothing; without friction nothing is made.
 */
#include <math.h>
#include <string.h>

#include <check.h>

#include "cloth/fabric.h"
#include "drape/drape_state.h"
#include "muslin/dress.h"
#include "support.h"

#define RIGIDITY 1e-5 /* [N m] */
#define LOOP 6e-4     /* 2HB [N]: a strip keeps 30 /m */
#define SIDE 0.005    /* [m] of a cell */

enum { NODES = 21 };

Suite *mus_suite_bend_slider(void);


/* a strip one cell wide, without gravity */
static mus_drape *strip(mus_context *context, double loop, int32_t precision)
{
    const double cell[2] = {SIDE, SIDE};
    mus_cloth_def def;
    mus_drape_def scene;
    mus_fabric fabric;
    mus_cloth *cloth = NULL;
    mus_drape *drape = NULL;
    mus_fabric_init(&fabric, sizeof fabric);
    mus_cloth_def_init(&def, sizeof def);
    mus_drape_def_init(&scene, sizeof scene);
    fabric.weight = 0.15, fabric.damping = 0.0, fabric.bend_hysteresis = loop;
    fabric.stretch[0] = fabric.stretch[1] = 1e3;
    for (int k = 0; k < 3; k++) fabric.bend[k] = RIGIDITY;
    def.fabric = &fabric;
    scene.precision = precision;
    scene.gravity[1] = 0.0;
    scene.settle_residual = 1e-4;
    scene.drag = 60.0; /* three times critical for a strip held in its middle: it comes back and does not swing */
    scene.integrator = MUS_METHOD_VERLET;
    ck_assert_int_eq(mus_cloth_create_grid(context, 1, NODES, cell, &def, &cloth), MUS_OK);
    ck_assert_int_eq(mus_drape_create(context, cloth, NULL, &scene, &drape), MUS_OK);
    mus_cloth_destroy(cloth);
    return drape;
}


/* the nodes on a circle of curvature K, chords as long as the cells; level at node 10, turned by `turn` about z */
static void bend(mus_drape *drape, double curvature, double turn)
{
    double x[3 * NODES] = {0};
    const double step = 2.0 * asin(0.5 * curvature * SIDE);
    for (int i = 0; i < NODES; i++) {
        const double at = step * (i - 10), p = sin(at) / curvature, q = (1.0 - cos(at)) / curvature;
        x[3 * i] = cos(turn) * p - sin(turn) * q, x[3 * i + 1] = sin(turn) * p + cos(turn) * q;
    }
    ck_assert_int_eq(mus_drape_set_state(drape, x, NULL), MUS_OK);
}


/* moment over width [N]: the force on the last node, a cell from the node before; its stencil has the middle there */
static double moment(const mus_drape *drape)
{
    double f[3 * NODES];
    ck_assert_int_eq(mus_drape_forces(drape, f), MUS_OK);
    return hypot(f[3 * (NODES - 1)], f[3 * (NODES - 1) + 1]) * SIDE / SIDE;
}


START_TEST(bent_once_the_moment_is_the_upper_line_of_the_loop)
{
    mus_context *context = support_context();
    mus_drape *drape = strip(context, LOOP, 64);
    bend(drape, 40.0, 0.3);
    ck_assert_double_eq_tol(moment(drape), RIGIDITY * 40.0 + 0.5 * LOOP, 1e-3 * LOOP);
    bend(drape, 1.0, 0.3);
    ck_assert_double_eq_tol(moment(drape), RIGIDITY + 0.5 * LOOP / MUS__SLIDE_CURVATURE, 1e-3 * LOOP);
    mus_drape_destroy(drape);
    support_context_end(context);
}
END_TEST


/* mean curvature of the middle cells */
static double curvature(const mus_drape *drape)
{
    const double *x = mus_drape_positions(drape);
    double sum = 0.0;
    for (int i = 8; i <= 12; i++) {
        const double *p = x + 3 * i;
        const double e[2] = {p[-3] - 2.0 * p[0] + p[3], p[-2] - 2.0 * p[1] + p[4]};
        sum += hypot(e[0], e[1]) / (SIDE * SIDE) / 5.0;
    }
    return sum;
}


START_TEST(let_go_a_strip_keeps_a_curvature)
{
    mus_context *context = support_context();
    for (int k = 0; k < 2; k++) {
        mus_drape *drape = strip(context, k == 0 ? LOOP : 0.0, k == 0 ? 32 : 64);
        bend(drape, 80.0, 0.0);
        const double h = 0.9 * mus_drape_step_bound(drape), seconds = 3.0;
        ck_assert_msg(mus_drape_step(drape, (int32_t)(seconds / h), h) == MUS_OK, "%s", mus_context_error(context));
        const double left = curvature(drape), most = 0.5 * LOOP / RIGIDITY;
        ck_assert_msg(k == 0 ? left > 0.9 * most && left < 1.1 * most : left < 0.1 * most, "%g /m of %g", left, most);
        mus_drape_destroy(drape);
    }
    support_context_end(context);
}
END_TEST


START_TEST(without_friction_there_are_no_sliders)
{
    mus_context *context = support_context();
    mus_drape *with = strip(context, LOOP, 32), *without = strip(context, 0.0, 32);
    ck_assert_int_eq(with->program.nslider, NODES - 2);
    ck_assert_int_eq(without->program.nslider, 0);
    ck_assert_ptr_null(without->program.slider);

    /* the bound has room for what sticks */
    ck_assert(mus_drape_step_bound(with) <= mus_drape_step_bound(without));
    mus_drape_destroy(with);
    mus_drape_destroy(without);
    support_context_end(context);
}
END_TEST


/* a bent strip that spins as a whole goes on doing so: no slider moves, and none gives energy */
START_TEST(turning_a_bent_strip_moves_no_slider)
{
    mus_context *context = support_context();
    mus_drape *drape = strip(context, LOOP, 64);
    bend(drape, 30.0, 0.0);
    ck_assert_int_eq(mus_drape_settle(drape, NULL, NULL), MUS_OK);
    double x[3 * NODES];
    memcpy(x, mus_drape_positions(drape), sizeof x);
    mus_drape_report report;
    mus_drape_report_init(&report, sizeof report);
    ck_assert_int_eq(mus_drape_report_get(drape, &report), MUS_OK);
    const double before = report.energy, kept = curvature(drape);
    for (int turn = 0; turn < 1000; turn++) {
        const double c = cos(0.001), s = sin(0.001);
        for (int i = 0; i < NODES; i++) {
            const double p = x[3 * i], q = x[3 * i + 1];
            x[3 * i] = c * p - s * q, x[3 * i + 1] = s * p + c * q;
        }
        memcpy(drape->x, x, sizeof x);
        for (int64_t d = 0; d < 3; d++)
            for (int i = 0; i < NODES; i++) ((double *)drape->sim.y)[d * drape->sim.n + i] = x[3 * i + d];
        for (int step = 0; step < 8; step++) ck_assert_int_eq(mus_drape_step(drape, 1, 1e-9), MUS_OK);
    }
    ck_assert_int_eq(mus_drape_report_get(drape, &report), MUS_OK);
    ck_assert_msg(fabs(report.energy - before) < 1e-3 * (before + 1e-9), "%g J, then %g", before, report.energy);
    ck_assert_double_eq_tol(curvature(drape), kept, 1e-3 * kept);
    mus_drape_destroy(drape);
    support_context_end(context);
}
END_TEST


/* the cost of steps is measured on the state itself, which has to be put back with its sliders */
START_TEST(an_estimate_leaves_the_sliders_where_they_are)
{
    mus_context *context = support_context();
    mus_drape *drape[2];
    mus_estimate estimate;
    mus_estimate_init(&estimate, sizeof estimate);
    for (int k = 0; k < 2; k++) {
        drape[k] = strip(context, LOOP, 64);
        bend(drape[k], 80.0, 0.0);
        const double h = 0.5 * mus_drape_step_bound(drape[k]);
        ck_assert_int_eq(mus_drape_step(drape[k], 101, h), MUS_OK);
        if (k == 1) ck_assert_int_eq(mus_drape_estimate(drape[k], 0.02, &estimate), MUS_OK);
        ck_assert_int_eq(mus_drape_step(drape[k], 101, h), MUS_OK);
    }
    ck_assert(mus_drape_hash(drape[0]) == mus_drape_hash(drape[1]));
    for (int k = 0; k < 2; k++) mus_drape_destroy(drape[k]);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_bend_slider(void)
{
    Suite *suite = suite_create("bend_slider");
    TCase *tests = tcase_create("bend_slider");
    tcase_add_test(tests, bent_once_the_moment_is_the_upper_line_of_the_loop);
    tcase_add_test(tests, let_go_a_strip_keeps_a_curvature);
    tcase_add_test(tests, without_friction_there_are_no_sliders);
    tcase_add_test(tests, an_estimate_leaves_the_sliders_where_they_are);
    tcase_add_test(tests, turning_a_bent_strip_moves_no_slider);
    suite_add_tcase(suite, tests);
    return suite;
}
