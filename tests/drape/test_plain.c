/*
 * test_plain.c: the plain form that muslin bench measures against has the library's springs and bending: forces and
 * steps agree on a lattice. A ratio of two speeds is one only for the same work.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench/edge_list.h"
#include "scenes.h"

Suite *mus_suite_plain(void);

#define SIDE 23
#define N (SIDE * SIDE)


/* G 300, C11 1300, one rigidity in every direction; as examples/bench/steps.c has them */
static plain_lattice plain_of(mus_context *context, int32_t precision, mus_cloth **cloth, mus_drape **drape)
{
    const double cell[2] = {0.01, 0.01}, rigidity = 2e-3;
    mus_cloth_def cut;
    mus_drape_def def;
    mus_cloth_def_init(&cut, sizeof cut);
    mus_fabric fabric;
    mus_fabric_init(&fabric, sizeof fabric);
    cut.fabric = &fabric;
    fabric.weight = 0.2;
    fabric.stretch[0] = fabric.stretch[1] = 1300.0;
    fabric.shear = 300.0;
    fabric.damping = 0.0;
    for (int d = 0; d < 3; d++) fabric.bend[d] = rigidity;
    mus_drape_def_init(&def, sizeof def);
    def.precision = precision;
    def.drag = 3.0;
    ck_assert_int_eq(mus_cloth_create_grid(context, SIDE, SIDE, cell, &cut, cloth), MUS_OK);
    ck_assert_int_eq(mus_drape_create(context, *cloth, NULL, &def, drape), MUS_OK);
    const double bend = rigidity / (cell[0] * cell[0]);
    return (plain_lattice){.rows = SIDE,
                           .columns = SIDE,
                           .cell = {cell[0], cell[1]},
                           .k = {1000.0, 1000.0},
                           .shear = 300.0,
                           .bend = {2.0 / 3.0 * bend, 2.0 / 3.0 * bend},
                           .cross = bend / 6.0,
                           .weight = 0.2,
                           .drag = def.drag};
}


START_TEST(plain_lists_count_as_the_cloth_does)
{
    mus_context *context = support_context();
    mus_cloth *cloth;
    mus_drape *drape;
    plain64_list list;
    const plain_lattice lattice = plain_of(context, 64, &cloth, &drape);
    ck_assert_int_eq(plain64_make(&lattice, &list), 0);
    ck_assert_int_eq(list.springs + list.stencils, mus_cloth_spring_count(cloth));
    for (int32_t i = 0; i < N; i++) ck_assert_double_eq_tol(list.mass[i], mus_cloth_masses(cloth)[i], 1e-18);
    plain64_free(&list);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    support_context_end(context);
}
END_TEST


/* a shaken lattice, forces with gravity; then a hundred steps of RK4 */
START_TEST(plain_forces_and_steps_are_the_librarys)
{
    static double x[3 * N], force[3 * N];
    mus_context *context = support_context();
    mus_cloth *cloth;
    mus_drape *drape;
    plain64_list list;
    const plain_lattice lattice = plain_of(context, 64, &cloth, &drape);
    uint64_t random = 17;
    double size = 0.0;
    ck_assert_int_eq(plain64_make(&lattice, &list), 0);
    for (int32_t i = 0; i < 3 * N; i++) list.y[i] = x[i] = list.y[i] + support_uniform(&random, -1e-3, 1e-3);
    ck_assert_int_eq(mus_drape_set_state(drape, x, NULL), MUS_OK);
    ck_assert_int_eq(mus_drape_forces(drape, force), MUS_OK);
    plain64_force(&list, list.y);
    for (int32_t i = 0; i < 3 * N; i++) size = fmax(size, fabs(force[i]));
    for (int32_t i = 0; i < 3 * N; i++) {
        const double weight = i % 3 == 1 ? -9.81 * list.mass[i / 3] : 0.0;
        ck_assert_double_eq_tol(list.f[i] + weight, force[i], 1e-13 * size);
    }

    const double h = 0.9 * mus_drape_step_bound(drape);
    for (int32_t i = 0; i < 100; i++) plain64_rk4(&list, h);
    ck_assert_int_eq(mus_drape_step(drape, 100, h), MUS_OK);
    for (int32_t i = 0; i < 3 * N; i++) ck_assert_double_eq_tol(list.y[i], mus_drape_positions(drape)[i], 1e-9);
    plain64_free(&list);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    support_context_end(context);
}
END_TEST


START_TEST(plain_in_float_follows_double)
{
    mus_context *context = support_context();
    mus_cloth *cloth;
    mus_drape *drape;
    plain32_list list;
    const plain_lattice lattice = plain_of(context, 32, &cloth, &drape);
    ck_assert_int_eq(plain32_make(&lattice, &list), 0);
    const double h = 0.5 * mus_drape_step_bound(drape);
    for (int32_t i = 0; i < 50; i++) plain32_rk4(&list, (float)h);
    ck_assert_int_eq(mus_drape_step(drape, 50, h), MUS_OK);
    for (int32_t i = 0; i < 3 * N; i++)
        ck_assert_double_eq_tol((double)list.y[i], mus_drape_positions(drape)[i], 1e-6);
    plain32_free(&list);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    support_context_end(context);
}
END_TEST


/* evaluations leave state, clock and the run that follows as they were */
START_TEST(evaluations_change_nothing)
{
    uint64_t hash[2];
    mus_context *context = support_context();
    for (int k = 0; k < 2; k++) {
        mus_cloth *cloth;
        mus_drape *drape;
        mus_drape_def def;
        const double cell[2] = {0.01, 0.01};
        mus_drape_def_init(&def, sizeof def);
        def.integrator = MUS_METHOD_VERLET;
        ck_assert_int_eq(mus_cloth_create_grid(context, 9, 9, cell, NULL, &cloth), MUS_OK);
        ck_assert_int_eq(mus_drape_create(context, cloth, NULL, &def, &drape), MUS_OK);
        ck_assert_int_eq(mus_drape_pin(drape, 4, 1), MUS_OK);
        const double h = 0.5 * mus_drape_step_bound(drape);
        ck_assert_int_eq(mus_drape_step(drape, 20, h), MUS_OK);
        if (k == 1) ck_assert_int_eq(mus_drape_evaluate(drape, 3), MUS_OK);
        ck_assert_int_eq(mus_drape_step(drape, 20, h), MUS_OK);
        ck_assert_int_eq(mus_drape_evaluate(drape, -1), MUS_ERR_ARG);
        hash[k] = mus_drape_hash(drape);
        mus_drape_destroy(drape);
        mus_cloth_destroy(cloth);
    }
    ck_assert_int_eq(mus_drape_evaluate(NULL, 1), MUS_ERR_ARG);
    ck_assert_uint_eq(hash[0], hash[1]);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_plain(void)
{
    Suite *suite = suite_create("plain");
    TCase *tests = tcase_create("plain");
    tcase_add_test(tests, plain_lists_count_as_the_cloth_does);
    tcase_add_test(tests, plain_forces_and_steps_are_the_librarys);
    tcase_add_test(tests, plain_in_float_follows_double);
    tcase_add_test(tests, evaluations_change_nothing);
    suite_add_tcase(suite, tests);
    return suite;
}
