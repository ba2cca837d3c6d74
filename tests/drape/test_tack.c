/*
 * test_tack.c: tacks put in and taken out of a running drape: exact motion, exact
 * bound, no byte of what they do not touch, no energy beyond what they bring.
 */
#include <stdio.h>

#include "drape/weld.h"
#include "sim/force_reference.h"
#include "tacked.h"

Suite *mus_suite_tack(void);

static const double weightless[3] = {0.0, 0.0, 0.0};


/* S1: two nodes that fly side by side; from the tack on they meet after pi / (2 sqrt(2 k / m)) at d sqrt(2 k / m),
 * while their middle flies on as before */
START_TEST(two_nodes_tacked_in_flight_meet_when_they_must)
{
    const double d = 0.02, k = 10.0, mass[2] = {1e-3, 1e-3};
    const double omega = sqrt(2.0 * k / mass[0]), quarter = 1.5707963267948966 / omega;
    const int32_t precision = _i % 2 ? 64 : 32, verlet = _i / 2;
    const double start[6] = {0, 0, 0, d, 0, 0}, fly[6] = {0, 0.5, 0, 0, 0.5, 0};
    const double rough = verlet ? 2e-6 * d : precision == 64 ? 1e-11 : 1e-7;
    mus_context *context = support_context();
    mus_drape_def def;
    mus_drape_def_init(&def, sizeof def);
    def.precision = precision, def.integrator = verlet ? MUS_METHOD_VERLET : MUS_METHOD_RK4, def.drag = 0.0;
    memcpy(def.gravity, weightless, sizeof weightless);
    mus_drape *drape = two_nodes(context, mass, d, 0, &def);
    ck_assert_int_eq(mus_drape_set_state(drape, start, fly), MUS_OK);
    run(drape, 100, 1e-3);
    ck_assert_double_eq_tol(gap_of(drape, 0, 1), d, precision == 64 ? 1e-15 : 1e-9);

    ck_assert_int_eq(tack(drape, 0, 1, k), 0);
    run(drape, 400, quarter / 400);
    const double *x = mus_drape_positions(drape), *v = mus_drape_velocities(drape);
    ck_assert_double_eq_tol(x[3] - x[0], 0.0, rough);
    ck_assert_double_eq_tol(v[0] - v[3], d * omega, 100.0 * omega * rough);
    for (int i = 0; i < 2; i++) {
        ck_assert_double_eq_tol(x[3 * i + 1], 0.5 * (0.1 + quarter), precision == 64 ? 1e-13 : 1e-6);
        ck_assert_double_eq_tol(v[3 * i + 1], 0.5, precision == 64 ? 1e-14 : 1e-6);
    }
    run(drape, 400, quarter / 400);
    ck_assert_double_eq_tol(x[3] - x[0], -d, 2.0 * rough);

    /* let go where they meet: they part as fast as they met */
    run(drape, 400, quarter / 400);
    ck_assert_int_eq(mus_drape_untack(drape, 0), MUS_OK);
    run(drape, 100, 1e-3);
    ck_assert_double_eq_tol(x[3] - x[0], 0.1 * d * omega, 50.0 * omega * rough);
    mus_drape_destroy(drape);
    support_context_end(context);
}
END_TEST


/* alone the bound is 2.62 / sqrt(2 k / m), or sqrt(3) / sqrt(2 k / m); in cloth 2 k comes to what holds the node; it
 * is told at once, the step that was allowed is refused with both numbers, and nothing has moved */
START_TEST(the_bound_is_that_with_the_tack_at_once)
{
    const double mass[2] = {1e-3, 5e-3}, k = 40.0;
    const int32_t verlet = _i;
    mus_context *context = support_context();
    mus_drape_def def;
    mus_drape_def_init(&def, sizeof def);
    def.precision = 64, def.integrator = verlet ? MUS_METHOD_VERLET : MUS_METHOD_RK4, def.drag = 0.0;
    const double alone = (verlet ? sqrt(3.0) : 2.62) * sqrt(mass[0] / (2.0 * k));
    for (int32_t a = 0; a < 2; a++) { /* the light node is the one, whichever end it is */
        mus_drape *pair = two_nodes(context, mass, 0.02, 0, &def);
        ck_assert_double_eq(mus_drape_step_bound(pair), 1e9);
        tack(pair, a, 1 - a, k);
        ck_assert_double_eq_tol(mus_drape_step_bound(pair) / alone, 1.0, 1e-14);
        mus_drape_destroy(pair);
    }

    mus_drape *drape = swung_grid(context, 64, def.integrator, 1, 0.0);
    const double before = mus_drape_step_bound(drape), stiff = 3e4;
    mus_estimate was, is;
    mus_estimate_init(&was, sizeof was);
    mus_estimate_init(&is, sizeof is);
    ck_assert_int_eq(mus_drape_estimate(drape, 0.02, &was), MUS_OK);
    run(drape, 1, 0.9 * before);
    ck_assert_int_eq(mus_drape_estimate(drape, 0.02, &was), MUS_OK);
    const uint64_t hash = mus_drape_hash(drape);
    const int32_t index = tack(drape, was.node, was.node < 300 ? 420 : 150, stiff);
    ck_assert_int_eq(mus_drape_estimate(drape, 0.02, &is), MUS_OK);
    ck_assert_int_eq(is.node, was.node);
    ck_assert_double_eq_tol(is.node_stiffness - was.node_stiffness, 2.0 * stiff, 1e-9 * stiff);
    const double bound = mus_drape_step_bound(drape);
    ck_assert_double_eq_tol(bound * sqrt(is.node_stiffness / is.node_mass) / (verlet ? sqrt(3.0) : 2.62), 1.0, 1e-14);
    ck_assert_double_lt(bound, 0.9 * before);
    ck_assert_int_gt(is.steps_per_frame, was.steps_per_frame);

    char said[120];
    ck_assert_int_eq(mus_drape_step(drape, 1, 0.9 * before), MUS_ERR_STEP);
    snprintf(said, sizeof said, "step %.9g s is above the stability bound %.9g s", 0.9 * before, bound);
    ck_assert_msg(strstr(mus_context_error(context), said) != NULL, "%s", mus_context_error(context));
    ck_assert_uint_eq(mus_drape_hash(drape), hash);

    ck_assert_int_eq(mus_drape_untack(drape, index), MUS_OK);
    ck_assert_double_eq(mus_drape_step_bound(drape), was.step_bound);
    run(drape, 1, 0.9 * was.step_bound);
    mus_drape_destroy(drape);
    support_context_end(context);
}
END_TEST


/* put in and taken out again, or slack: the run is that of a drape that never had one, bit for bit */
START_TEST(a_tack_that_does_not_pull_changes_no_byte)
{
    const int32_t precision = _i % 2 ? 64 : 32, stepper = _i / 2 % 2 ? MUS_METHOD_VERLET : MUS_METHOD_RK4;
    mus_context *context = support_context();
    uint64_t hash[3];
    double bound[3];
    for (int with = 0; with < 3; with++) {
        mus_drape *drape = swung_grid(context, precision, stepper, 1, stepper == MUS_METHOD_RK4 ? 0.1 : 0.0);
        uint64_t random = 3;
        for (int k = 0; k < 40; k++) {
            const int32_t a = (int32_t)(support_random(&random) % NODES), b = (a + 1 + k * k) % NODES;
            if (with == 1) tack(drape, a, b, 500.0);
            if (with == 2) tack(drape, a, b, 0.0);
        }
        for (int k = 0; k < 40 && with == 1; k++) ck_assert_int_eq(mus_drape_untack(drape, (7 * k) % 40), MUS_OK);
        bound[with] = mus_drape_step_bound(drape);
        run(drape, 300, 0.5 * bound[with]);
        hash[with] = mus_drape_hash(drape);
        mus_drape_destroy(drape);
    }
    ck_assert(bound[1] == bound[0] && bound[2] == bound[0]);
    ck_assert_uint_eq(hash[1], hash[0]);
    ck_assert_uint_eq(hash[2], hash[0]);
    support_context_end(context);
}
END_TEST


/* k (x_b - x_a) comes to the two nodes, and no bit changes at any other: nodes of the lattice and of the border, side
 * by side and far apart, open and welded */
START_TEST(a_tack_pulls_its_two_nodes_and_no_other)
{
    const int32_t precision = _i % 2 ? 64 : 32, welded = _i / 2;
    const double k = 200.0;
    mus_context *context = support_context();
    mus_pattern *pattern = scene_strips(context, 1.2);
    mus_cloth *cloth = scene_cut(context, pattern, 0.01, 0.1);
    mus_drape *drape = scene_drape(context, cloth, precision, 1);
    if (welded) mus__weld(drape);
    const int32_t n = mus_drape_node_count(drape);
    double *f = kernel_forces(drape), most = 0.0;
    const double *x = mus_drape_positions(drape);
    uint64_t random = 5;
    for (int trial = 0; trial < 60; trial++) {
        const int32_t a = (int32_t)(support_random(&random) % (uint64_t)n);
        const int32_t b = trial % 3 == 0 ? (a + 1) % n : trial % 3 == 1 ? (a + 29) % n : (a * 7 + 5) % n;
        if (a == b) continue;
        const int32_t p = drape->rep[a], q = drape->rep[b], index = tack(drape, a, b, k);
        double *with = kernel_forces(drape);
        for (int32_t i = 0; i < n; i++)
            for (int32_t d = 0; d < 3 && drape->rep[i] == i; d++) {
                const double own = with[3 * i + d] - f[3 * i + d], way = x[3 * q + d] - x[3 * p + d];
                const double expected = i == p ? k * way : i == q ? -k * way : 0.0;
                if (i != p && i != q) ck_assert_double_eq(own, 0.0);
                else ck_assert_double_eq_tol(own, expected, precision == 64 ? 1e-12 : 1e-4);
                most = fmax(most, fabs(own));
            }
        free(with);
        ck_assert_int_eq(mus_drape_untack(drape, index), MUS_OK);
    }
    ck_assert_double_gt(most, 10.0);
    free(f);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


/* the energy gains k d^2 / 2 by the call, and nothing by the steps that follow; taken out it loses what it has */
START_TEST(a_tack_brings_half_k_d2_and_no_more)
{
    const int32_t precision = _i % 2 ? 64 : 32;
    mus_context *context = support_context();
    mus_drape *drape = swung_grid(context, precision, MUS_METHOD_RK4, 1, _i / 2 ? 0.4 : 0.0);
    const int32_t pairs[4][2] = {{0, SIDE - 1}, {5 * SIDE + 5, 6 * SIDE + 9}, {100, 101}, {3, NODES - 1}};
    double expected = 0.0;
    for (int t = 0; t < 4; t++) {
        const double k = 30.0 * (t + 1), gap = gap_of(drape, pairs[t][0], pairs[t][1]);
        const double before = extreme_report(drape).energy;
        tack(drape, pairs[t][0], pairs[t][1], k);
        const double after = extreme_report(drape).energy;
        ck_assert_double_eq_tol(after - before, 0.5 * k * gap * gap, 1e-12 * (fabs(after) + fabs(before)));
        expected += 0.5 * k * gap * gap;
    }
    ck_assert_double_gt(expected, 1.0);
    const double start = extreme_report(drape).energy;
    double least = start;
    for (int i = 0; i < 40; i++) {
        run(drape, 50, 0.9 * mus_drape_step_bound(drape));
        extreme_finite(drape);
        const double now = extreme_report(drape).energy;
        ck_assert_double_le(now, least + (precision == 64 ? 1e-9 : 1e-4) * (fabs(least) + 1e-3));
        least = fmin(least, now);
    }
    const double gap = gap_of(drape, 3, NODES - 1), last = extreme_report(drape).energy;
    ck_assert_int_eq(mus_drape_untack(drape, 3), MUS_OK);
    ck_assert_double_eq_tol(last - extreme_report(drape).energy, 0.5 * 120.0 * gap * gap, 1e-12 * (fabs(last) + 1.0));
    mus_drape_destroy(drape);
    support_context_end(context);
}
END_TEST


START_TEST(threads_do_not_matter_to_tacks)
{
    const int32_t threads[4] = {1, 2, 3, 7}, stepper = _i ? MUS_METHOD_VERLET : MUS_METHOD_RK4;
    mus_context *context = support_context();
    uint64_t hash[4];
    for (int t = 0; t < 4; t++) {
        mus_drape *drape = swung_grid(context, 32, stepper, threads[t], 0.1);
        uint64_t random = 9;
        for (int k = 0; k < 50; k++) {
            const int32_t a = (int32_t)(support_random(&random) % NODES);
            const int32_t b = (int32_t)(support_random(&random) % NODES);
            if (a != b) tack(drape, a, b, 20.0);
        }
        run(drape, 200, 0.5 * mus_drape_step_bound(drape));
        hash[t] = mus_drape_hash(drape);
        ck_assert_uint_eq(hash[t], hash[0]);
        mus_drape_destroy(drape);
    }
    support_context_end(context);
}
END_TEST


/* tacks in and out at random, hundreds at one node among them: numbers are the lowest free, the kernels agree with the
 * plain form, and the forces are bit for bit those of a drape that got the same list at once */
START_TEST(any_order_in_and_out_gives_the_same_plan)
{
    enum { MOST = 400 };
    mus_context *context = support_context();
    mus_drape *drape = swung_grid(context, 64, MUS_METHOD_RK4, 1, 0.1);
    int32_t a[MOST], b[MOST], last = 0;
    double k[MOST];
    uint64_t random = 13;
    for (int i = 0; i < MOST; i++) a[i] = MUS_NONE;
    for (int i = 0; i < 900; i++) {
        const int32_t at = (int32_t)(support_random(&random) % MOST);
        int32_t low = 0;
        while (low < MOST && a[low] != MUS_NONE) low++;
        if (a[at] != MUS_NONE && i % 5 == 0) {
            ck_assert_int_eq(mus_drape_untack(drape, at), MUS_OK);
            a[at] = MUS_NONE;
        } else if (low < MOST) {
            a[low] = i % 2 ? 77 : (int32_t)(support_random(&random) % NODES);
            b[low] = (a[low] + 1 + (int32_t)(support_random(&random) % (NODES - 1))) % NODES;
            k[low] = support_uniform(&random, 0.0, 5.0);
            ck_assert_int_eq(tack(drape, a[low], b[low], k[low]), low);
        }
    }
    mus_drape *other = swung_grid(context, 64, MUS_METHOD_RK4, 1, 0.1);
    for (int i = 0; i < MOST; i++)
        if (a[i] != MUS_NONE) tack(other, a[i], b[i], k[i]), last++;
    ck_assert_int_gt(last, 300);
    double *f = kernel_forces(drape), *g = kernel_forces(other), *plain = malloc(3 * NODES * sizeof *plain);
    ck_assert_mem_eq(f, g, 3 * NODES * sizeof *f);
    free(f);
    drape->sim.dashpots = 0;
    f = kernel_forces(drape);
    mus__program_force(&drape->program, NODES, mus_drape_positions(drape), plain);
    for (int i = 0; i < 3 * NODES; i++) ck_assert_double_eq_tol(f[i], plain[i], 1e-11);
    free(f);
    free(g);
    free(plain);
    mus_drape_destroy(other);
    mus_drape_destroy(drape);
    support_context_end(context);
}
END_TEST


/* calls that make no tack are refused: one sentence with item, value and limit, and the drape as it was */
START_TEST(what_is_no_tack_is_refused_by_name)
{
    mus_context *context = support_context();
    mus_drape *drape = swung_grid(context, 64, MUS_METHOD_RK4, 1, 0.0);
    const struct {
        int32_t a, b;
        double k;
        mus_status status;
        const char *says;
    } bad[] = {
        {3, 4, NAN, MUS_ERR_ARG, "drape: stiffness of a tack is nan N/m, expected 0 to 1e+09"},
        {3, 4, INFINITY, MUS_ERR_ARG, "drape: stiffness of a tack is inf N/m, expected 0 to 1e+09"},
        {-1, 3, 1.0, MUS_ERR_ARG, "drape: node -1 of a tack, expected 0 to 575"},
        {3, NODES, 1.0, MUS_ERR_ARG, "drape: node 576 of a tack, expected 0 to 575"},
        {3, 3, 1.0, MUS_ERR_ARG, "drape: a tack of node 3 with itself"},
        {3, 4, -1.0, MUS_ERR_ARG, "drape: stiffness of a tack is -1 N/m, expected 0 to 1e+09"},
        {3, 4, 2e9, MUS_ERR_ARG, "drape: stiffness of a tack is 2e+09 N/m, expected 0 to 1e+09"},
        {NODES - SIDE, NODES - 1, 1.0, MUS_ERR_STATE,
         "drape: a tack of nodes 552 and 575 cannot close: gap 0.46 m, both held"},
    };
    const uint64_t hash = mus_drape_hash(drape);
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        ck_assert_int_eq(mus_drape_tack(drape, bad[i].a, bad[i].b, bad[i].k, NULL), bad[i].status);
        ck_assert_str_eq(mus_context_error(context), bad[i].says);
    }
    ck_assert_int_eq(mus_drape_untack(drape, 0), MUS_ERR_ARG);
    ck_assert_str_eq(mus_context_error(context), "drape: there is no tack 0");
    tack(drape, 3, 4, 1.0);
    ck_assert_int_eq(mus_drape_tack(drape, 3, NODES - 1, 1.0, NULL), MUS_OK);
    ck_assert_int_eq(mus_drape_untack(drape, 0), MUS_OK);
    ck_assert_int_eq(mus_drape_untack(drape, 0), MUS_ERR_ARG);
    ck_assert_int_eq(mus_drape_untack(drape, 2), MUS_ERR_ARG);
    ck_assert_int_eq(mus_drape_untack(drape, -1), MUS_ERR_ARG);
    ck_assert_int_eq(mus_drape_tack(NULL, 0, 1, 1.0, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_drape_untack(NULL, 0), MUS_ERR_ARG);
    ck_assert_uint_eq(mus_drape_hash(drape), hash);

    /* a node without mass is held too; where both ends are in one place there is nothing to close */
    const double mass[2] = {0.0, 1.0};
    mus_drape_def def;
    mus_drape_def_init(&def, sizeof def);
    mus_drape *pair = two_nodes(context, mass, 1.0, 1, &def);
    ck_assert_int_eq(mus_drape_pin(pair, 1, 1), MUS_OK);
    ck_assert_int_eq(mus_drape_pin(pair, 0, 0), MUS_OK);
    ck_assert_int_eq(mus_drape_tack(pair, 1, 0, 5.0, NULL), MUS_ERR_STATE);
    ck_assert_str_eq(mus_context_error(context), "drape: a tack of nodes 1 and 0 cannot close: gap 1 m, both held");
    const double together[6] = {0};
    ck_assert_int_eq(mus_drape_set_state(pair, together, NULL), MUS_OK);
    ck_assert_int_eq(mus_drape_tack(pair, 1, 0, 5.0, NULL), MUS_OK);
    mus_drape_destroy(pair);
    mus_drape_destroy(drape);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_tack(void)
{
    Suite *suite = suite_create("tack");
    TCase *tests = tcase_create("tack");
    tcase_set_timeout(tests, 60);
    tcase_add_loop_test(tests, two_nodes_tacked_in_flight_meet_when_they_must, 0, 4);
    tcase_add_loop_test(tests, the_bound_is_that_with_the_tack_at_once, 0, 2);
    tcase_add_loop_test(tests, a_tack_that_does_not_pull_changes_no_byte, 0, 4);
    tcase_add_loop_test(tests, a_tack_pulls_its_two_nodes_and_no_other, 0, 4);
    tcase_add_loop_test(tests, a_tack_brings_half_k_d2_and_no_more, 0, 4);
    tcase_add_loop_test(tests, threads_do_not_matter_to_tacks, 0, 2);
    tcase_add_test(tests, any_order_in_and_out_gives_the_same_plan);
    tcase_add_test(tests, what_is_no_tack_is_refused_by_name);
    suite_add_tcase(suite, tests);
    return suite;
}
