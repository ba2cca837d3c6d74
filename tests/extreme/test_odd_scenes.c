/*
 * test_odd_scenes.c: cloth folded, flattened and turned inside out; gravity from every side; cloths of one node, of
 * none, all held and not held at all.
 */
#include "drape/drape_state.h"
#include "muslin/topology.h"

#include "bare.h"
#include "drape/scenes.h"
#include "sim/force_reference.h"

Suite *mus_suite_odd_scenes(void);

static const double weightless[3] = {0.0, 0.0, 0.0}, down[3] = {0.0, -9.81, 0.0};


/* ---- folded, flat, inverted ---- */

/* node i of an n x n grid of cell a, on its face: 0 mirrored, 1 folded flat along the middle column, 2 all on one line,
 * 3 rolled into the upright plane and crumpled */
static void fold(int32_t how, int32_t n, double a, const double *rest, double *x)
{
    uint64_t random = 17;
    const double middle = 0.5 * (n - 1) * a;
    for (int32_t i = 0; i < n * n; i++, rest += 2, x += 3) {
        x[0] = how == 0 ? -rest[0] : how == 1 ? middle - fabs(rest[0] - middle) : how == 2 ? rest[0] : 0.0;
        x[1] = how == 2 ? 0.0 : rest[1];
        x[2] = how == 3 ? rest[0] : 0.0;
        for (int d = 0; d < 3 && how == 3; d++) x[d] += support_uniform(&random, -a, a);
    }
}


/* the energy is finite and the force is its gradient, by central differences, and the kernel's force is the same
 */
START_TEST(force_is_the_gradient_of_the_energy_however_cloth_is_folded)
{
    enum { SIDE = 5, N = SIDE * SIDE };
    mus_context *context = support_context();
    mus_cloth *cloth = extreme_grid(context, SIDE, SIDE, 0.01, NULL);
    double x[3 * N], f[3 * N], kernel[3 * N];
    fold(_i, SIDE, 0.01, mus_cloth_rest(cloth), x);
    mus_drape *drape = extreme_drape(context, cloth, 64, weightless);
    ck_assert_int_eq(mus_drape_set_state(drape, x, NULL), MUS_OK);
    const double energy = mus__program_force(&drape->program, N, x, f);
    ck_assert_double_eq_tol(extreme_report(drape).energy, energy, 1e-12 * energy + 1e-25);

    drape->sim.ops->force(&drape->sim);
    drape->sim.ops->get_force(&drape->sim, kernel);
    double most = 1e-3;
    for (int32_t i = 0; i < 3 * N; i++) most = fmax(most, fabs(f[i]));
    for (int32_t i = 0; i < 3 * N; i++) {
        const double was = x[i], d = 1e-7;
        x[i] = was + d;
        const double above = mus__program_force(&drape->program, N, x, NULL);
        x[i] = was - d;
        const double below = mus__program_force(&drape->program, N, x, NULL);
        x[i] = was;
        ck_assert(isfinite(f[i]));
        ck_assert_double_eq_tol(f[i], (below - above) / (2.0 * d), 2e-6 * most);
        ck_assert_double_eq_tol(kernel[i], f[i], 1e-12 * most);
    }
    mus_drape_destroy(drape);
    support_context_end(context);
}
END_TEST


/* and let go, it moves without gaining energy */
START_TEST(folded_cloth_let_go_gains_no_energy)
{
    enum { SIDE = 5, N = SIDE * SIDE };
    mus_context *context = support_context();
    mus_fabric fabric;
    mus_fabric_init(&fabric, sizeof fabric);
    fabric.damping = 0.0;
    mus_cloth *cloth = extreme_grid(context, SIDE, SIDE, 0.01, &fabric);
    double x[3 * N];
    fold(_i, SIDE, 0.01, mus_cloth_rest(cloth), x);
    mus_drape *drape = extreme_drape(context, cloth, 64, weightless);
    ck_assert_int_eq(mus_drape_set_state(drape, x, NULL), MUS_OK);
    const double before = extreme_report(drape).energy;
    const double h = 0.5 * mus_drape_step_bound(drape);
    for (int k = 0; k < 20; k++) {
        ck_assert_msg(mus_drape_step(drape, 50, h) == MUS_OK, "%s", mus_context_error(context));
        ck_assert_double_le(extreme_report(drape).energy, before * (1.0 + 1e-6) + 1e-20);
    }
    extreme_finite(drape);
    mus_drape_destroy(drape);
    support_context_end(context);
}
END_TEST


/* ---- gravity ---- */

/* a chain of 16 springs hangs in g times gravity, in any direction, with the first node held: set where the
 * closed form says, it stays; the end is g times as far from its place as at 1 */
START_TEST(a_chain_at_rest_stays_at_rest_in_any_gravity)
{
    enum { N = 17 };
    static const double gravity[][3] = {{0, 0, 0},      {9.81, 0, 0},  {981, 0, 0}, {-9.81, 0, 0},
                                        {-0.981, 0, 0}, {0, -9.81, 0}, {0, 981, 0}, {0, 0, 9.81}};
    mus_context *context = support_context();
    const double length = 1.0 / (N - 1), stiffness = 1000.0 * (N - 1), m = 0.15 / (N - 1);
    for (size_t k = 0; k < sizeof gravity / sizeof *gravity; k++) {
        const double g = gravity[k][0] + gravity[k][1] + gravity[k][2];
        const int axis = gravity[k][0] != 0.0 ? 0 : gravity[k][1] != 0.0 ? 1 : 2;
        double place[N], mass[N], x[3 * N] = {0};
        for (int i = 0; i < N; i++) place[i] = i * length, mass[i] = i == N - 1 ? 0.5 * m : m;
        mus_drape *drape =
            extreme_drape(context, extreme_chain(context, N, place, mass, length, stiffness, true), 64, gravity[k]);

        /* spring i carries all below it; it points with gravity */
        for (int i = 1; i < N; i++)
            x[3 * i + axis] = x[3 * i - 3 + axis] + (g < 0.0 ? -1.0 : 1.0) * length + (N - 0.5 - i) * m * g / stiffness;
        ck_assert_double_eq_tol(fabs(x[3 * N - 3 + axis]) - 1.0, 0.15 * fabs(g) / (2.0 * 1000.0), 1e-12);
        ck_assert_int_eq(mus_drape_set_state(drape, x, NULL), MUS_OK);
        ck_assert_int_eq(mus_drape_step(drape, 2000, 0.9 * mus_drape_step_bound(drape)), MUS_OK);
        for (int i = 0; i < 3 * N; i++) ck_assert_double_eq_tol(mus_drape_positions(drape)[i], x[i], 1e-11);
        mus_drape_destroy(drape);
    }
    support_context_end(context);
}
END_TEST


/* 1e6 times gravity: refused with value and limit; at the limit of 1e4 m/s2 everything is finite and the report
 * shows the strain */
START_TEST(gravity_beyond_reason_is_refused_and_at_its_limit_is_finite)
{
    mus_context *context = support_context();
    mus_cloth *cloth = extreme_grid(context, 9, 9, 0.02, NULL);
    mus_drape_def def;
    mus_drape *drape;
    mus_drape_def_init(&def, sizeof def);
    def.precision = _i ? 64 : 32;
    def.gravity[1] = -9.81e6;
    ck_assert_int_eq(mus_drape_create(context, cloth, NULL, &def, &drape), MUS_ERR_ARG);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "gravity is -9.81e+06, expected -10000 to 10000"));

    def.gravity[1] = -1e4;
    ck_assert_int_eq(mus_drape_create(context, cloth, NULL, &def, &drape), MUS_OK);
    for (int32_t c = 0; c < 9; c++) ck_assert_int_eq(mus_drape_pin(drape, 72 + c, 1), MUS_OK);
    const double h = 0.9 * mus_drape_step_bound(drape);
    ck_assert_int_eq(mus_drape_step(drape, (int32_t)(0.05 / h), h), MUS_OK);
    extreme_finite(drape);
    ck_assert_double_gt(extreme_report(drape).max_strain, 0.5);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    support_context_end(context);
}
END_TEST


/* ---- few nodes, none, none held ---- */

/* cloths of a few nodes, free: each node falls as a point does, at any step that the bound allows, and
 * nothing is made that the shape has no room for */
START_TEST(a_cloth_of_a_few_nodes_falls_as_a_point)
{
    static const int32_t shape[][3] = {{1, 1, 0}, {1, 2, 1}, {2, 1, 1}, {2, 2, 6}, {1, 7, 11}, {7, 1, 11}};
    for (size_t k = 0; k < sizeof shape / sizeof *shape; k++) {
        mus_context *context = support_context();
        mus_cloth *cloth = extreme_grid(context, shape[k][0], shape[k][1], 0.01, NULL);
        const int32_t n = mus_cloth_node_count(cloth);
        ck_assert_int_eq(mus_cloth_spring_count(cloth), shape[k][2]);
        double start[21];
        mus_drape *drape = extreme_drape(context, cloth, _i ? 64 : 32, down);
        memcpy(start, mus_drape_positions(drape), 3 * (size_t)n * sizeof *start);
        const double h = fmin(0.01, 0.99 * mus_drape_step_bound(drape));
        ck_assert_int_eq(mus_drape_step(drape, (int32_t)(0.3 / h), h), MUS_OK);
        const double t = mus_drape_time(drape), fall = 0.5 * 9.81 * t * t;
        for (int32_t i = 0; i < 3 * n; i++)
            ck_assert_double_eq_tol(mus_drape_positions(drape)[i], start[i] - (i % 3 == 1 ? fall : 0.0),
                                    _i ? 1e-12 : 3e-5);
        ck_assert_double_eq_tol(mus_drape_velocities(drape)[1], -9.81 * t, _i ? 1e-11 : 1e-4);

        /* calls for garments work on these cloths too */
        ck_assert_int_eq(mus_drape_sew(drape, NULL, NULL), MUS_OK);
        const mus_status status = mus_drape_settle(drape, NULL, NULL);
        ck_assert(status == MUS_OK || status == MUS_ERR_UNSETTLED);
        extreme_finite(drape);
        mus_drape_destroy(drape);
        support_context_end(context);
    }
}
END_TEST


/* no node at all: every call is a no-op that succeeds, nothing is divided by the count */
START_TEST(a_cloth_without_nodes_does_nothing_well)
{
    mus_context *context = support_context();
    mus_bare bare;
    mus_cloth *cloth;
    mus_bare_init(&bare, sizeof bare);
    ck_assert_int_eq(mus_cloth_create_bare(context, &bare, &cloth), MUS_OK);
    ck_assert_double_eq(mus_cloth_mass(cloth), 0.0);
    mus_drape *drape = extreme_drape(context, cloth, _i ? 64 : 32, down);
    const uint64_t start = mus_drape_hash(drape);
    ck_assert_int_eq(mus_drape_node_count(drape), 0);
    ck_assert(isfinite(mus_drape_step_bound(drape)));
    ck_assert_int_eq(mus_drape_place(drape), MUS_OK);
    ck_assert_int_eq(mus_drape_step(drape, 10, 0.01), MUS_OK);
    ck_assert_int_eq(mus_drape_sew(drape, NULL, NULL), MUS_OK);
    ck_assert_int_eq(mus_drape_settle(drape, NULL, NULL), MUS_OK);
    ck_assert_int_eq(mus_drape_pin(drape, 0, 1), MUS_ERR_ARG);
    const mus_drape_report report = extreme_report(drape);
    ck_assert(report.energy == 0.0 && report.residual == 0.0 && report.max_strain == 0.0 && report.max_speed == 0.0);
    ck_assert_int_eq(report.springs, 0);
    ck_assert_uint_ne(mus_drape_hash(drape), start); /* time went on */
    mus_drape_destroy(drape);
    support_context_end(context);
}
END_TEST


/* nodes without a spring: any step is stable */
START_TEST(nodes_without_springs_have_no_bound)
{
    mus_context *context = support_context();
    const double place[6] = {0, 0, 0, 1, 2, 3}, mass[2] = {1.0, 2.0};
    mus_bare bare;
    mus_cloth *cloth;
    mus_bare_init(&bare, sizeof bare);
    bare.nodes = 2, bare.place = place, bare.mass = mass;
    ck_assert_int_eq(mus_cloth_create_bare(context, &bare, &cloth), MUS_OK);
    mus_drape *drape = extreme_drape(context, cloth, 64, down);
    ck_assert_double_ge(mus_drape_step_bound(drape), 1e6);
    ck_assert_int_eq(mus_drape_step(drape, 1, 10.0), MUS_OK);
    ck_assert_double_eq_tol(mus_drape_positions(drape)[4], 2.0 - 490.5, 1e-10);
    mus_drape_destroy(drape);
    support_context_end(context);
}
END_TEST


/* no panel, a panel without an outline, no place in the field of a body: a status or nothing, no division by 0 */
START_TEST(a_pattern_without_panels_cannot_be_cut)
{
    mus_context *context = support_context();
    mus_pattern *pattern;
    mus_cloth *cloth;
    int32_t panel, count = -1;
    ck_assert_int_eq(mus_pattern_create(context, "empty", &pattern), MUS_OK);
    ck_assert_int_eq(mus_pattern_check(pattern, &count, NULL), MUS_OK);
    ck_assert_int_eq(count, 0);
    ck_assert_int_eq(mus_cloth_create(context, pattern, NULL, &cloth), MUS_ERR_PATTERN);
    ck_assert_ptr_null(cloth);
    ck_assert_int_eq(mus_pattern_add_panel(pattern, "front", &panel), MUS_OK);
    ck_assert_int_eq(mus_cloth_create(context, pattern, NULL, &cloth), MUS_ERR_PATTERN);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "front"));
    ck_assert_ptr_null(cloth);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


/* ---- all held ---- */

/* every node held in a pose under tension: not a bit moves, and time goes on */
START_TEST(a_cloth_that_is_held_everywhere_does_not_move_a_bit)
{
    enum { SIDE = 7, N = SIDE * SIDE };
    mus_context *context = support_context();
    mus_drape *drape = extreme_drape(context, extreme_grid(context, SIDE, SIDE, 0.01, NULL), _i ? 64 : 32, down);
    double x[3 * N], v[3 * N];
    uint64_t random = 3;
    for (int32_t i = 0; i < 3 * N; i++) {
        x[i] = 2.0 * mus_drape_positions(drape)[i] + support_uniform(&random, -0.002, 0.002);
        v[i] = support_uniform(&random, -1.0, 1.0);
    }
    ck_assert_int_eq(mus_drape_set_state(drape, x, v), MUS_OK);
    for (int32_t i = 0; i < N; i++) ck_assert_int_eq(mus_drape_pin(drape, i, 1), MUS_OK);
    memcpy(x, mus_drape_positions(drape), sizeof x);
    memset(v, 0, sizeof v);

    /* no node moves, so no step is too long */
    ck_assert_double_ge(mus_drape_step_bound(drape), 1.0);
    ck_assert_int_eq(mus_drape_step(drape, 100, 0.01), MUS_OK);
    ck_assert_int_eq(mus_drape_settle(drape, NULL, NULL), MUS_OK);
    ck_assert_mem_eq(mus_drape_positions(drape), x, sizeof x);
    for (int32_t i = 0; i < 3 * N; i++) ck_assert_double_eq(mus_drape_velocities(drape)[i], 0.0);
    ck_assert_double_ge(mus_drape_time(drape), 1.0);
    mus_drape_destroy(drape);
    support_context_end(context);
}
END_TEST


/* what holds a flat cloth that is held everywhere carries each node's own weight */
START_TEST(reactions_of_held_nodes_are_their_weight)
{
    enum { SIDE = 7, N = SIDE * SIDE };
    mus_context *context = support_context();
    mus_cloth *cloth = extreme_grid(context, SIDE, SIDE, 0.01, NULL);
    double mass[N], force[3 * N], sum = 0.0;
    memcpy(mass, mus_cloth_masses(cloth), sizeof mass);
    const double weight = mus_cloth_mass(cloth) * 9.81;
    mus_drape *drape = extreme_drape(context, cloth, _i ? 64 : 32, down);
    for (int32_t i = 0; i < N; i++) ck_assert_int_eq(mus_drape_pin(drape, i, 1), MUS_OK);
    ck_assert_int_eq(mus_drape_step(drape, 10, 0.01), MUS_OK);
    ck_assert_int_eq(mus_drape_forces(drape, force), MUS_OK);
    const double noise = _i ? 1e-12 * weight : 2e-6; /* springs at rest to the rounding of their ends */
    for (int32_t i = 0; i < N; i++) {
        ck_assert_double_eq_tol(force[3 * i], 0.0, noise);
        ck_assert_double_eq_tol(force[3 * i + 1], -9.81 * mass[i], noise);
        ck_assert_double_eq_tol(force[3 * i + 2], 0.0, noise);
        sum += force[3 * i + 1];
    }
    ck_assert_double_eq_tol(-sum / weight, 1.0, 1e-12);
    mus_drape_destroy(drape);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_odd_scenes(void)
{
    Suite *suite = suite_create("odd_scenes");
    TCase *tests = tcase_create("odd_scenes");
    tcase_add_loop_test(tests, force_is_the_gradient_of_the_energy_however_cloth_is_folded, 0, 4);
    tcase_add_loop_test(tests, folded_cloth_let_go_gains_no_energy, 0, 4);
    tcase_add_test(tests, a_chain_at_rest_stays_at_rest_in_any_gravity);
    tcase_add_loop_test(tests, gravity_beyond_reason_is_refused_and_at_its_limit_is_finite, 0, 2);
    tcase_add_loop_test(tests, a_cloth_of_a_few_nodes_falls_as_a_point, 0, 2);
    tcase_add_loop_test(tests, a_cloth_without_nodes_does_nothing_well, 0, 2);
    tcase_add_test(tests, nodes_without_springs_have_no_bound);
    tcase_add_test(tests, a_pattern_without_panels_cannot_be_cut);
    tcase_add_loop_test(tests, a_cloth_that_is_held_everywhere_does_not_move_a_bit, 0, 2);
    tcase_add_loop_test(tests, reactions_of_held_nodes_are_their_weight, 0, 2);
    suite_add_tcase(suite, tests);
    return suite;
}
