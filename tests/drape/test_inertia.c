/*
 * test_inertia.c: inertia tensors bear the stiffness of any cloth in any pose, end where the scalar ends, and a drape
 * whose precision is left open takes double where float cannot come to rest.
 */
#include <math.h>
#include <string.h>

#include <check.h>

#include "drape/drape_state.h"
#include "dress/dynamic_relaxation.h"
#include "sim/force_reference.h"
#include "support.h"

#define SIDE 8
#define N (SIDE * SIDE)

Suite *mus_suite_inertia(void);


/* a grid of a fabric without a body, crumpled at random by `crumple` [m] */
static mus_drape *crumpled(mus_context *context, const char *fabric_name, double crumple, uint64_t *random)
{
    const double cell[2] = {0.02, 0.02};
    mus_cloth_def def;
    mus_drape_def scene;
    mus_fabric fabric;
    mus_cloth *cloth = NULL;
    mus_drape *drape = NULL;
    double x[3 * N], v[3 * N] = {0.0};
    mus_cloth_def_init(&def, sizeof def);
    mus_fabric_init(&fabric, sizeof fabric);
    ck_assert_int_eq(mus_fabric_find(fabric_name, &fabric), MUS_OK);
    def.fabric = &fabric;
    mus_drape_def_init(&scene, sizeof scene);
    scene.precision = 64;
    ck_assert_int_eq(mus_cloth_create_grid(context, SIDE, SIDE, cell, &def, &cloth), MUS_OK);
    ck_assert_int_eq(mus_drape_create(context, cloth, NULL, &scene, &drape), MUS_OK);
    mus_cloth_destroy(cloth);
    for (int i = 0; i < 3 * N; i++) x[i] = mus_drape_positions(drape)[i] + support_uniform(random, -crumple, crumple);
    ck_assert_int_eq(mus_drape_set_state(drape, x, v), MUS_OK);
    return drape;
}


/* d.M d of all nodes, and of the stiffness: - d.(f(x + d) - f(x - d)) / 2 */
static void squares(const mus_drape *drape, const double *d, double *inertia, double *stiffness)
{
    double to[3 * N], from[3 * N], fore[3 * N], back[3 * N];
    *inertia = *stiffness = 0.0;
    for (int i = 0; i < 3 * N; i++) to[i] = drape->x[i] + d[i], from[i] = drape->x[i] - d[i];
    mus__program_force(&drape->program, N, to, fore);
    mus__program_force(&drape->program, N, from, back);
    for (int i = 0; i < N; i++) {
        const double *m = drape->relax.inertia + 6 * i, *u = d + 3 * i;
        *inertia += m[0] * u[0] * u[0] + m[1] * u[1] * u[1] + m[2] * u[2] * u[2] +
                    2.0 * (m[3] * u[0] * u[1] + m[4] * u[1] * u[2] + m[5] * u[2] * u[0]);
    }
    for (int i = 0; i < 3 * N; i++) *stiffness -= 0.5 * d[i] * (fore[i] - back[i]);
}


/* u K u <= rate2 u M u: the promise that makes one step suit all motions; the worst motion is sought by the power
 * method, whose quotient grows to the largest rate */
START_TEST(tensors_bear_the_stiffness)
{
    const char *const fabrics[] = {"jersey", "cotton", "silk", "denim"};
    uint64_t random = 11;
    mus_context *context = support_context();
    for (int k = 0; k < 4; k++) {
        mus_drape *drape = crumpled(context, fabrics[k], 0.002 * (k + 1), &random);
        double d[3 * N], fore[3 * N], back[3 * N], to[3 * N], from[3 * N], worst = 0.0;
        ck_assert_int_eq(mus__relax_create(drape), MUS_OK);
        drape->sim.tensor = drape->relax.tensor;
        mus__relax_step(drape, 1.0, 0.0);
        mus__drape_tensors(drape);
        for (int i = 0; i < 3 * N; i++) d[i] = support_uniform(&random, -1e-7, 1e-7);
        for (int round = 0; round < 60; round++) {
            double inertia, stiffness, size = 0.0;
            squares(drape, d, &inertia, &stiffness);
            worst = fmax(worst, stiffness / inertia / drape->relax.rate2);
            for (int i = 0; i < 3 * N; i++) to[i] = drape->x[i] + d[i], from[i] = drape->x[i] - d[i];
            mus__program_force(&drape->program, N, to, fore);
            mus__program_force(&drape->program, N, from, back);
            for (int i = 0; i < 3 * N; i++) back[i] -= fore[i], size += back[i] * back[i];
            for (int i = 0; i < 3 * N; i++) d[i] = 1e-6 * back[i] / sqrt(size);
        }
        ck_assert_double_le(worst, 1.0);
        ck_assert_double_ge(worst, 0.05);
        drape->sim.tensor = NULL;
        mus_drape_destroy(drape);
    }
    support_context_end(context);
}
END_TEST


/* 0 lets the cloth choose: float for jersey, double for cotton at 5 mm; what the caller says stands */
START_TEST(stiff_cloth_takes_double)
{
    const struct {
        const char *fabric;
        double cell;
        int32_t asked, given;
    } rows[] = {{"jersey", 0.01, 0, 32}, {"cotton", 0.005, 0, 64}, {"cotton", 0.005, 32, 32}, {"jersey", 0.01, 64, 64}};
    mus_context *context = support_context();
    for (int k = 0; k < 4; k++) {
        const double cell[2] = {rows[k].cell, rows[k].cell};
        mus_cloth_def def;
        mus_drape_def scene;
        mus_fabric fabric;
        mus_cloth *cloth = NULL;
        mus_drape *drape = NULL;
        mus_cloth_def_init(&def, sizeof def);
        mus_fabric_init(&fabric, sizeof fabric);
        ck_assert_int_eq(mus_fabric_find(rows[k].fabric, &fabric), MUS_OK);
        def.fabric = &fabric;
        mus_drape_def_init(&scene, sizeof scene);
        scene.precision = rows[k].asked;
        ck_assert_int_eq(mus_cloth_create_grid(context, SIDE, SIDE, cell, &def, &cloth), MUS_OK);
        ck_assert_int_eq(mus_drape_create(context, cloth, NULL, &scene, &drape), MUS_OK);
        ck_assert_int_eq(drape->def.precision, rows[k].given);
        mus_drape_destroy(drape);
        mus_cloth_destroy(cloth);
    }
    support_context_end(context);
}
END_TEST


Suite *mus_suite_inertia(void)
{
    Suite *suite = suite_create("inertia");
    TCase *tcase = tcase_create("inertia");
    tcase_add_test(tcase, tensors_bear_the_stiffness);
    tcase_add_test(tcase, stiff_cloth_takes_double);
    suite_add_tcase(suite, tcase);
    return suite;
}
