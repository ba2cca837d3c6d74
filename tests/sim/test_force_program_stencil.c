/*
 * test_force_program_stencil.c: the blocks of a program give the plain forces on lattices of every shape, and the
 * fused steps are the textbook's on those forces.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "drape/drape_state.h"
#include "drape/scenes.h"
#include "drape/weld.h"
#include "sim/force_reference.h"

Suite *mus_suite_force_program_stencil(void);

/* rows and columns: single lines, less than a block, whole blocks, blocks over the ends of rows, several chunks */
static const int32_t grids[][2] = {{1, 1},  {1, 9},   {13, 1},  {2, 2},   {3, 3},  {4, 5},
                                   {5, 17}, {16, 16}, {17, 33}, {40, 23}, {3, 700}};
/* features of a fabric: stretch only, with shear, with bending, with both, both with bending springs over one node,
 * shear and contraction */
static const double fabrics[][4] = {{0, 0, 0},         {250, 0, 0},     {0, 2e-5, 0},     {250, 2e-5, 0},
                                    {250, 2e-5, 3e-5}, {0, 2e-5, 3e-5}, {250, 2e-5, 3e-5}, {20, 0, 0, 0.4}};
#define PAPER 6
#define GRIDS ((int)(sizeof grids / sizeof grids[0]))
#define FABRICS ((int)(sizeof fabrics / sizeof fabrics[0]))


static mus_cloth *blocks_grid(mus_context *context, int32_t grid, int32_t fabric, double damping)
{
    const double cell[2] = {0.01, 0.013};
    mus_cloth_def cut;
    mus_cloth *cloth;
    mus_cloth_def_init(&cut, sizeof cut);
    mus_fabric cloth_fabric;
    mus_fabric_init(&cloth_fabric, sizeof cloth_fabric);
    cut.fabric = &cloth_fabric;
    cloth_fabric.shear = fabrics[fabric][0];
    for (int d = 0; d < 3; d++) cloth_fabric.bend[d] = fabrics[fabric][d < 2 ? 1 : 2];
    cloth_fabric.damping = damping;
    cloth_fabric.contraction = fabrics[fabric][3];
    if (fabric == PAPER) cut.bending = MUS_BEND_PAPER;
    ck_assert_int_eq(mus_cloth_create_grid(context, grids[grid][0], grids[grid][1], cell, &cut, &cloth), MUS_OK);
    return cloth;
}


/* every node moved at random, so that no two springs are alike */
static void blocks_shake(mus_drape *drape, double *x, double *v)
{
    uint64_t random = 7;
    memcpy(x, mus_drape_positions(drape), 3 * (size_t)drape->n * sizeof *x);
    for (int32_t i = 0; i < 3 * drape->n; i++) {
        x[i] += support_uniform(&random, -0.003, 0.003);
        v[i] = support_uniform(&random, -1.0, 1.0);
    }
    ck_assert_int_eq(mus_drape_set_state(drape, x, v), MUS_OK);
    memcpy(x, mus_drape_positions(drape), 3 * (size_t)drape->n * sizeof *x);
    memcpy(v, mus_drape_velocities(drape), 3 * (size_t)drape->n * sizeof *v);
}


/* c (n . (v_b - v_a)) n on a, and its opposite on b if both */
static void blocks_dashpot(const double *x, const double *v, int32_t a, int32_t b, double c, int both, double *f)
{
    double along = 0.0, l2 = 0.0;
    for (int d = 0; d < 3; d++) {
        const double e = x[3 * b + d] - x[3 * a + d];
        along += e * (v[3 * b + d] - v[3 * a + d]), l2 += e * e;
    }
    for (int d = 0; d < 3; d++) {
        const double pull = c * along / l2 * (x[3 * b + d] - x[3 * a + d]);
        f[3 * a + d] += pull;
        if (both) f[3 * b + d] -= pull;
    }
}


/* springs, bending and dashpots, plainly */
static void blocks_plain(const mus_drape *drape, const double *x, const double *v, double *f)
{
    const mus__program *program = &drape->program;
    mus__program_force(program, drape->n, x, f);
    for (int32_t r = 0; r < program->nhalf_run && program->dashpots; r++) {
        const mus__half_run *run = &program->half_run[r];
        for (int32_t i = 0; i < run->count; i++) blocks_dashpot(x, v, run->a + i, run->b + i, run->dashpot, 0, f);
    }
    for (int32_t s = 0; s < program->nspring && program->dashpots; s++)
        blocks_dashpot(x, v, program->spring[s].a, program->spring[s].b, program->spring_dashpot[s], 1, f);
}


static void blocks_against_plain(int32_t precision, double damping, double tolerance)
{
    mus_context *context = support_context();
    for (int k = 0; k < GRIDS * FABRICS; k++) {
        mus_cloth *cloth = blocks_grid(context, k % GRIDS, k / GRIDS, damping);
        mus_drape *drape = scene_drape(context, cloth, precision, 1);
        const size_t bytes = 3 * (size_t)drape->n * sizeof(double);
        double *x = malloc(bytes), *v = malloc(bytes), *f = malloc(bytes), *kernel = malloc(bytes), size = 1e-6;
        blocks_shake(drape, x, v);
        blocks_plain(drape, x, v, f);
        drape->sim.dashpots = drape->program.dashpots;
        drape->sim.ops->force(&drape->sim);
        drape->sim.ops->get_force(&drape->sim, kernel);
        for (int32_t i = 0; i < 3 * drape->n; i++) size = fmax(size, fabs(f[i]));
        for (int32_t i = 0; i < 3 * drape->n; i++) ck_assert_double_eq_tol(kernel[i], f[i], tolerance * size);
        free(x), free(v), free(f), free(kernel);
        mus_drape_destroy(drape);
        mus_cloth_destroy(cloth);
    }
    support_context_end(context);
}


START_TEST(blocks_in_double_give_the_plain_forces)
{
    blocks_against_plain(64, 0.0, 1e-13);
    blocks_against_plain(64, 0.05, 1e-13);
}
END_TEST


START_TEST(blocks_in_float_give_the_plain_forces_to_rounding)
{
    blocks_against_plain(32, 0.0, 2e-5);
    blocks_against_plain(32, 0.05, 2e-5);
}
END_TEST


/* every node in one chunk, every lattice node in one block or more */
START_TEST(chunks_and_blocks_cover_every_node)
{
    mus_context *context = support_context();
    mus_pattern *pattern = scene_strips(context, 1.3);
    mus_cloth *cloth = scene_cut(context, pattern, 0.007, 0.0);
    mus_drape *drape = scene_drape(context, cloth, 32, 1);
    const mus__program *program = &drape->program;
    int32_t next = 0, group = 0, blocks = 0;
    for (int32_t c = 0; c < program->nchunk; c++) {
        const mus__chunk *chunk = &program->chunk[c];
        ck_assert_int_eq(chunk->first, next);
        ck_assert_int_le(chunk->count, MUS__CHUNK_NODES);
        ck_assert_int_eq(chunk->slice, group);
        next += chunk->count, group += chunk->nslice, blocks += chunk->npacket;
    }
    ck_assert_int_eq(next, drape->n);
    ck_assert_int_eq(group, program->sell.nslice);
    ck_assert_int_eq(blocks, program->npacket);
    ck_assert_int_lt(program->ntable, program->npacket);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


/* ---- steps against the textbook's ---- */

typedef struct blocks_motion {
    const mus_drape *drape;
    double *f; /* (n x 3) */
} blocks_motion;


/* y = [x | v] as (n x 3) each: x' = v, v' = f/m + g - drag v */
static void blocks_rate(void *user, double t, const double *y, double *dy)
{
    const blocks_motion *motion = user;
    const mus_drape *drape = motion->drape;
    const int32_t n3 = 3 * drape->n;
    (void)t;
    memcpy(dy, y + n3, (size_t)n3 * sizeof *dy);
    blocks_plain(drape, y, y + n3, motion->f);
    for (int32_t i = 0; i < n3; i++) {
        const int32_t free = drape->mass[i / 3] > 0.0 && !drape->pinned[i / 3];
        dy[n3 + i] =
            free ? motion->f[i] / drape->mass[i / 3] + drape->def.gravity[i % 3] - drape->def.drag * y[n3 + i] : 0.0;
    }
}


/* two welded strips with dashpots, drag and a pin: `steps` of the drape and of mus_integrate */
static void blocks_steps(int32_t method, int32_t steps, double drag, double tolerance)
{
    mus_context *context = support_context();
    mus_pattern *pattern = scene_strips(context, 1.2);
    mus_cloth *cloth = scene_cut(context, pattern, 0.02, 0.03);
    mus_drape_def def;
    mus_drape *drape;
    mus_drape_def_init(&def, sizeof def);
    def.precision = 64;
    def.drag = drag;
    def.integrator = method;
    ck_assert_int_eq(mus_drape_create(context, cloth, NULL, &def, &drape), MUS_OK);
    ck_assert_int_eq(mus_drape_place(drape), MUS_OK);
    mus__weld(drape);
    ck_assert_int_eq(mus_drape_pin(drape, 11, 1), MUS_OK);

    const int64_t n3 = 3 * (int64_t)drape->n, bytes = n3 * (int64_t)sizeof(double);
    double *y = malloc(2 * (size_t)bytes), *f = malloc((size_t)bytes);
    double *work = malloc((size_t)mus_integrate_work(method, 2 * n3) * sizeof *work);
    blocks_shake(drape, y, y + n3);
    blocks_motion motion = {drape, f};
    mus_integrate_def integrate;
    mus_integrate_def_init(&integrate, sizeof integrate);
    integrate.method = method;
    integrate.step = 0.3 * mus_drape_step_bound(drape);
    integrate.rate = blocks_rate;
    integrate.user = &motion;
    ck_assert_int_eq(mus_integrate(context, &integrate, 2 * n3, y, steps, work, NULL), MUS_OK);
    ck_assert_int_eq(mus_drape_step(drape, steps, integrate.step), MUS_OK);
    for (int32_t i = 0; i < n3; i++) {
        if (drape->rep[i / 3] != i / 3) continue;
        ck_assert_double_eq_tol(mus_drape_positions(drape)[i], y[i], tolerance);
        ck_assert_double_eq_tol(mus_drape_velocities(drape)[i], y[n3 + i], 1e4 * tolerance);
    }
    free(y), free(f), free(work);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}


START_TEST(a_step_of_runge_kutta_is_the_textbook_step)
{
    blocks_steps(MUS_METHOD_RK4, 1, 0.5, 1e-15);
    blocks_steps(MUS_METHOD_RK4, 50, 40.0, 1e-13);
}
END_TEST


/* the textbook's Verlet, drag apart: the library takes half of it before and half after a force */
START_TEST(a_step_of_verlet_is_the_textbook_step)
{
    blocks_steps(MUS_METHOD_VERLET, 1, 0.0, 1e-15);
    blocks_steps(MUS_METHOD_VERLET, 50, 0.0, 1e-13);
}
END_TEST


Suite *mus_suite_force_program_stencil(void)
{
    Suite *suite = suite_create("force_program_stencil");
    TCase *tests = tcase_create("force_program_stencil");
    tcase_set_timeout(tests, 60);
    tcase_add_test(tests, blocks_in_double_give_the_plain_forces);
    tcase_add_test(tests, blocks_in_float_give_the_plain_forces_to_rounding);
    tcase_add_test(tests, chunks_and_blocks_cover_every_node);
    tcase_add_test(tests, a_step_of_runge_kutta_is_the_textbook_step);
    tcase_add_test(tests, a_step_of_verlet_is_the_textbook_step);
    suite_add_tcase(suite, tests);
    return suite;
}
