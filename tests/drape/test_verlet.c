/*
 * test_verlet.c: velocity Verlet as the stepper of a drape: its order, its energy, its bound, and that no force is
 * kept that is no longer true.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "scenes.h"

Suite *mus_suite_verlet(void);

typedef struct verlet_scene {
    mus_context *context;
    mus_cloth *cloth;
    mus_drape *drape;
    int32_t n;
    double *x; /* (n x 3) the start */
} verlet_scene;


/* a square of 12 x 12 nodes, every node moved at random by up to `shake`; one corner is held */
static verlet_scene verlet_open(int32_t precision, int32_t threads, double damping, double drag, double shake)
{
    verlet_scene s;
    const double cell[2] = {0.01, 0.01};
    mus_cloth_def cut;
    mus_drape_def def;
    s.context = support_context();
    mus_cloth_def_init(&cut, sizeof cut);
    mus_fabric fabric;
    mus_fabric_init(&fabric, sizeof fabric);
    cut.fabric = &fabric;
    fabric.damping = damping;
    ck_assert_int_eq(mus_cloth_create_grid(s.context, 12, 12, cell, &cut, &s.cloth), MUS_OK);
    mus_drape_def_init(&def, sizeof def);
    def.precision = precision;
    def.threads = threads;
    def.drag = drag;
    def.integrator = MUS_METHOD_VERLET;
    ck_assert_int_eq(mus_drape_create(s.context, s.cloth, NULL, &def, &s.drape), MUS_OK);
    ck_assert_int_eq(mus_drape_pin(s.drape, 0, 1), MUS_OK);
    s.n = mus_drape_node_count(s.drape);
    s.x = malloc(3 * (size_t)s.n * sizeof *s.x);
    memcpy(s.x, mus_drape_positions(s.drape), 3 * (size_t)s.n * sizeof *s.x);
    uint64_t random = 3;
    for (int32_t i = 3; i < 3 * s.n; i++) s.x[i] += support_uniform(&random, -shake, shake);
    ck_assert_int_eq(mus_drape_set_state(s.drape, s.x, NULL), MUS_OK);
    return s;
}


static void verlet_close(verlet_scene *s)
{
    free(s->x);
    mus_drape_destroy(s->drape);
    mus_cloth_destroy(s->cloth);
    support_context_end(s->context);
}


static double verlet_energy(const mus_drape *drape)
{
    mus_drape_report report;
    mus_drape_report_init(&report, sizeof report);
    ck_assert_int_eq(mus_drape_report_get(drape, &report), MUS_OK);
    return report.energy;
}


/* places after the same time with `steps` steps */
static void verlet_run(double damping, double drag, int32_t steps, double *x)
{
    verlet_scene s = verlet_open(64, 1, damping, drag, 1e-4);
    const double time = 24.0 * mus_drape_step_bound(s.drape);
    ck_assert_int_eq(mus_drape_step(s.drape, steps, time / steps), MUS_OK);
    memcpy(x, mus_drape_positions(s.drape), 3 * (size_t)s.n * sizeof *x);
    verlet_close(&s);
}


/* the difference of two runs falls 4-fold when both steps are halved; 2-fold with dashpots, whose velocity is half a
 * step old; drag keeps order 2 */
START_TEST(order_is_two_and_one_with_dashpots)
{
    const double damping[] = {0.0, 0.0, 0.5}, drag[] = {0.0, 300.0, 0.0}, order[] = {2.0, 2.0, 1.0};
    double x[4][3 * 144];
    for (int k = 0; k < 4; k++) verlet_run(damping[_i], drag[_i], 1000 << k, x[k]);
    double difference[3] = {0.0};
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < 3 * 144; i++) difference[k] = fmax(difference[k], fabs(x[k][i] - x[k + 1][i]));
    ck_assert_double_eq_tol(log2(difference[1] / difference[2]), order[_i], 0.1);
}
END_TEST


/* 0.99 of the bound, with and without dashpots and drag: no growth over many steps */
START_TEST(below_its_bound_energy_does_not_grow)
{
    const double damping[] = {0.0, 0.2, 1.0, 0.0}, drag[] = {0.0, 0.0, 0.5, 9e3};
    verlet_scene s = verlet_open(64, 1, damping[_i], drag[_i], 1e-4);
    const double before = verlet_energy(s.drape), h = 0.99 * mus_drape_step_bound(s.drape);
    ck_assert_int_eq(mus_drape_step(s.drape, 3000, h), MUS_OK);
    /* the energy of the method, not the true one, is what it keeps: it swings, and does not grow */
    ck_assert_double_lt(verlet_energy(s.drape), 10.0 * fabs(before));
    verlet_close(&s);
}
END_TEST


/* without drag and damping the error of a long swing near the bound comes to 1 % of the energy of its motion: the run
 * ends with a sentence, at a state whose energy is within it. At half of the step it goes on */
START_TEST(a_run_whose_energy_rises_ends_with_a_sentence)
{
    for (int half = 0; half < 2; half++) {
        verlet_scene s = verlet_open(64, 1, 0.0, 0.0, 1e-4);
        for (int32_t i = 0; i < 12; i++) ck_assert_int_eq(mus_drape_pin(s.drape, i, 1), MUS_OK);
        const double before = verlet_energy(s.drape), fall = mus_cloth_mass(s.cloth) * 9.81 * 0.11;
        mus_status status = MUS_OK;
        while (status == MUS_OK && mus_drape_time(s.drape) < 20.0)
            status = mus_drape_step(s.drape, 512, (half ? 0.5 : 0.99) * mus_drape_step_bound(s.drape));
        ck_assert_int_eq(status, half ? MUS_OK : MUS_ERR_DIVERGED);
        ck_assert_double_le(verlet_energy(s.drape), before + 0.02 * fall);
        if (!half) ck_assert_ptr_nonnull(strstr(mus_context_error(s.context), "smaller step"));
        verlet_close(&s);
    }
}
END_TEST


START_TEST(the_bound_is_that_of_one_evaluation)
{
    verlet_scene s = verlet_open(64, 1, 0.0, 0.5, 0.0);
    mus_drape *other;
    mus_drape_def def;
    mus_drape_def_init(&def, sizeof def);
    def.precision = 64;
    ck_assert_int_eq(mus_drape_create(s.context, s.cloth, NULL, &def, &other), MUS_OK);
    ck_assert_int_eq(mus_drape_pin(other, 0, 1), MUS_OK);
    const double bound = mus_drape_step_bound(s.drape);
    ck_assert_double_eq_tol(bound, sqrt(3.0) / 2.62 * mus_drape_step_bound(other), 1e-12);
    ck_assert_int_eq(mus_drape_step(s.drape, 1, 1.01 * bound), MUS_ERR_STEP);
    def.integrator = MUS_METHOD_EULER;
    mus_drape_destroy(other);
    ck_assert_int_eq(mus_drape_create(s.context, s.cloth, NULL, &def, &other), MUS_ERR_ARG);
    ck_assert_ptr_null(other);
    verlet_close(&s);
}
END_TEST


/* a run in pieces, and one with other threads, is the same run to the last bit */
START_TEST(pieces_and_threads_make_the_same_run)
{
    uint64_t hash[3];
    for (int k = 0; k < 3; k++) {
        verlet_scene s = verlet_open(32, k == 2 ? 3 : 1, 0.05, 0.5, 1e-3);
        const double h = 0.5 * mus_drape_step_bound(s.drape);
        for (int32_t done = 0; done < 200; done += k == 1 ? 25 : 200)
            ck_assert_int_eq(mus_drape_step(s.drape, k == 1 ? 25 : 200, h), MUS_OK);
        hash[k] = mus_drape_hash(s.drape);
        verlet_close(&s);
    }
    ck_assert_uint_eq(hash[0], hash[1]);
    ck_assert_uint_eq(hash[0], hash[2]);
}
END_TEST


/* forces of the last step serve the next only while the places are those of the last step */
START_TEST(a_state_set_anew_starts_with_its_own_forces)
{
    verlet_scene s = verlet_open(64, 1, 0.0, 0.0, 1e-3);
    const double h = 0.5 * mus_drape_step_bound(s.drape);
    double first[3 * 144];
    ck_assert_int_eq(mus_drape_step(s.drape, 7, h), MUS_OK);
    memcpy(first, mus_drape_positions(s.drape), sizeof first);
    ck_assert_int_eq(mus_drape_step(s.drape, 5, h), MUS_OK);
    ck_assert_int_eq(mus_drape_set_state(s.drape, s.x, NULL), MUS_OK);
    ck_assert_int_eq(mus_drape_step(s.drape, 7, h), MUS_OK);
    ck_assert_mem_eq(first, mus_drape_positions(s.drape), sizeof first);
    verlet_close(&s);
}
END_TEST


/* free fall: x = -g t^2 / 2 exactly but for rounding, at any step */
START_TEST(free_fall_is_exact)
{
    verlet_scene s = verlet_open(64, 1, 0.02, 0.0, 0.0);
    ck_assert_int_eq(mus_drape_pin(s.drape, 0, 0), MUS_OK);
    const double h = 0.9 * mus_drape_step_bound(s.drape);
    ck_assert_int_eq(mus_drape_step(s.drape, 400, h), MUS_OK);
    const double t = mus_drape_time(s.drape);
    for (int32_t i = 0; i < s.n; i++) {
        ck_assert_double_eq_tol(mus_drape_positions(s.drape)[3 * i + 1], s.x[3 * i + 1] - 0.5 * 9.81 * t * t, 1e-12);
        ck_assert_double_eq_tol(mus_drape_velocities(s.drape)[3 * i + 1], -9.81 * t, 1e-11);
    }
    verlet_close(&s);
}
END_TEST


Suite *mus_suite_verlet(void)
{
    Suite *suite = suite_create("verlet");
    TCase *tests = tcase_create("verlet");
    tcase_set_timeout(tests, 60);
    tcase_add_loop_test(tests, order_is_two_and_one_with_dashpots, 0, 3);
    tcase_add_loop_test(tests, below_its_bound_energy_does_not_grow, 0, 4);
    tcase_add_test(tests, the_bound_is_that_of_one_evaluation);
    tcase_add_test(tests, a_run_whose_energy_rises_ends_with_a_sentence);
    tcase_add_test(tests, pieces_and_threads_make_the_same_run);
    tcase_add_test(tests, a_state_set_anew_starts_with_its_own_forces);
    tcase_add_test(tests, free_fall_is_exact);
    suite_add_tcase(suite, tests);
    return suite;
}
