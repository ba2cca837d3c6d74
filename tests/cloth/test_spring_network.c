/*
 * test_spring_network.c: bare nodes: pendulums, chains and rods of the caller's own springs, dashpots, bends and pins.
 */
#include "cut.h"

#include "muslin/drape.h"


/* three nodes in a row, 1 m apart, the first held, a bend over them */
typedef struct bare_scene {
    double place[9], mass[3], length[2], stiffness[2], dashpot[2], bend_stiffness[1];
    int32_t spring[4], bend[3], pin[1];
    mus_bare bare;
} bare_scene;


static void bare_rod(bare_scene *s)
{
    *s = (bare_scene){.place = {0, 0, 0, 1, 0, 0, 2, 0, 0},
                      .mass = {0, 1, 0.5},
                      .length = {1, 1},
                      .stiffness = {100, 100},
                      .dashpot = {0.5, 0.25},
                      .bend_stiffness = {3},
                      .spring = {0, 1, 1, 2},
                      .bend = {0, 1, 2}};
    mus_bare_init(&s->bare, sizeof s->bare);
    s->bare.nodes = 3, s->bare.springs = 2, s->bare.bends = 1, s->bare.pins = 1;
    s->bare.place = s->place, s->bare.mass = s->mass;
    s->bare.spring = s->spring, s->bare.length = s->length, s->bare.stiffness = s->stiffness;
    s->bare.dashpot = s->dashpot;
    s->bare.bend = s->bend, s->bare.bend_stiffness = s->bend_stiffness, s->bare.pin = s->pin;
}


static mus_drape *bare_drape(mus_context *context, const mus_bare *bare, int32_t precision, double gravity)
{
    mus_cloth *cloth;
    mus_drape *drape;
    mus_drape_def def;
    mus_drape_def_init(&def, sizeof def);
    def.precision = precision, def.drag = 0.0, def.gravity[1] = -gravity;
    ck_assert_msg(mus_cloth_create_bare(context, bare, &cloth) == MUS_OK, "%s", mus_context_error(context));
    ck_assert_int_eq(mus_drape_create(context, cloth, NULL, &def, &drape), MUS_OK);
    mus_cloth_destroy(cloth);
    return drape;
}


START_TEST(bare_nodes_are_what_was_given)
{
    mus_context *context = support_context();
    bare_scene s;
    mus_cloth *cloth;
    bare_rod(&s);
    ck_assert_int_eq(mus_cloth_create_bare(context, &s.bare, &cloth), MUS_OK);
    ck_assert_int_eq(mus_cloth_node_count(cloth), 3);
    ck_assert_int_eq(mus_cloth_spring_count(cloth), 3);
    ck_assert_int_eq(mus_cloth_panel_count(cloth), 0);
    ck_assert_int_eq(mus_cloth_triangle_count(cloth), 0);
    ck_assert_int_eq(mus_cloth_pair_count(cloth), 0);
    ck_assert_int_eq(mus_cloth_node_panels(cloth)[2], MUS_NONE);
    ck_assert_double_eq(mus_cloth_mass(cloth), 1.5);
    ck_assert_double_eq(mus_cloth_masses(cloth)[2], 0.5);
    ck_assert_double_eq(mus_cloth_rest(cloth)[4], 2.0);
    mus_cloth_destroy(cloth);
    support_context_end(context);
}
END_TEST


/* a node on one spring, stepped N times by RK4, keeps the energy E_N/E_0 = (1 - z^6/72 + z^8/576)^N, z = omega h */
START_TEST(an_oscillator_loses_what_runge_kutta_loses)
{
    mus_context *context = support_context();
    bare_scene s;
    bare_rod(&s);
    s.bare.nodes = 2, s.bare.springs = 1, s.bare.bends = 0, s.bare.dashpot = NULL;
    mus_drape *drape = bare_drape(context, &s.bare, 64, 0.0);
    const double x[6] = {0, 0, 0, 1.01, 0, 0}, z = 0.5, h = z / 10.0;
    ck_assert_int_eq(mus_drape_set_state(drape, x, NULL), MUS_OK);
    ck_assert_double_eq_tol(mus_drape_step_bound(drape), 2.62 / sqrt(200.0), 1e-12);
    ck_assert_int_eq(mus_drape_step(drape, 1000, h), MUS_OK);
    const double *p = mus_drape_positions(drape), *v = mus_drape_velocities(drape);
    const double energy = 50.0 * (p[3] - 1.0) * (p[3] - 1.0) + 0.5 * v[3] * v[3];
    const double want = 50.0 * 1e-4 * pow(1.0 - pow(z, 6) / 72.0 + pow(z, 8) / 576.0, 1000.0);
    ck_assert_msg(fabs(energy / want - 1.0) < 1e-9, "%.17g, expected %.17g", energy, want);
    ck_assert_double_eq(p[0], 0.0);
    mus_drape_destroy(drape);
    support_context_end(context);
}
END_TEST


/* the logarithm of a damped amplitude falls by 2 pi zeta / sqrt(1 - zeta^2) in each period */
START_TEST(a_dashpot_damps_by_its_own_constant)
{
    mus_context *context = support_context();
    bare_scene s;
    bare_rod(&s);
    s.bare.nodes = 2, s.bare.springs = 1, s.bare.bends = 0;
    const double zeta = 0.1, omega = 10.0, period = 2.0 * acos(-1.0) / (omega * sqrt(1.0 - zeta * zeta));
    s.dashpot[0] = 2.0 * zeta * omega;
    mus_drape *drape = bare_drape(context, &s.bare, 64, 0.0);
    const double x[6] = {0, 0, 0, 1.001, 0, 0};
    ck_assert_int_eq(mus_drape_set_state(drape, x, NULL), MUS_OK);
    ck_assert_int_eq(mus_drape_step(drape, 126, period / 126.0), MUS_OK);
    const double left = (mus_drape_positions(drape)[3] - 1.0) / 0.001;
    ck_assert_double_eq_tol(-log(left), 2.0 * acos(-1.0) * zeta / sqrt(1.0 - zeta * zeta), 1e-6);
    mus_drape_destroy(drape);
    support_context_end(context);
}
END_TEST


/* the bend alone, between a held node and a heavy one: f = -k (a - 2 b + c) (1, -2, 1) */
START_TEST(a_bend_pulls_by_second_differences)
{
    mus_context *context = support_context();
    for (int32_t precision = 32; precision <= 64; precision += 32) {
        bare_scene s;
        bare_rod(&s);
        s.bare.springs = 0, s.bare.dashpot = NULL;
        mus_drape *drape = bare_drape(context, &s.bare, precision, 0.0);

        /* the stiffness at nodes 1 and 2 is 8 k and 4 k */
        ck_assert_double_eq_tol(mus_drape_step_bound(drape), 2.62 / sqrt(24.0), 1e-12);
        const double x[9] = {0, 0, 0, 1, 0.25, 0, 2, 0, 0}, h = 1e-4;
        ck_assert_int_eq(mus_drape_set_state(drape, x, NULL), MUS_OK);
        ck_assert_int_eq(mus_drape_step(drape, 1, h), MUS_OK);
        const double *v = mus_drape_velocities(drape);
        ck_assert_double_eq_tol(v[4] / h, 2.0 * 3.0 * -0.5, 1e-5);
        ck_assert_double_eq_tol(v[7] / h, -3.0 * -0.5 / 0.5, 1e-5);
        ck_assert_double_eq(v[1], 0.0);
        mus_drape_destroy(drape);
    }
    support_context_end(context);
}
END_TEST


START_TEST(a_drape_of_bare_nodes_starts_at_their_place_with_the_pins_held)
{
    mus_context *context = support_context();
    for (int32_t precision = 32; precision <= 64; precision += 32) {
        bare_scene s;
        bare_rod(&s);
        s.place[2] = 0.25;
        mus_drape *drape = bare_drape(context, &s.bare, precision, 9.81);
        const double *x = mus_drape_positions(drape);
        ck_assert_int_eq(mus_drape_step(drape, 20, 1e-3), MUS_OK);
        const double rounding = precision == 64 ? 0.0 : 1e-7;
        for (int k = 0; k < 3; k++) ck_assert_double_le(fabs(x[k] - s.place[k]), rounding);
        ck_assert_double_lt(x[7], -1e-5);
        ck_assert_int_eq(mus_drape_place(drape), MUS_OK);
        for (int k = 0; k < 9; k++) ck_assert_double_le(fabs(x[k] - s.place[k]), rounding);
        ck_assert_int_eq(mus_drape_step(drape, 20, 1e-3), MUS_OK);
        for (int k = 0; k < 3; k++) ck_assert_double_le(fabs(x[k] - s.place[k]), rounding);
        mus_drape_destroy(drape);
    }
    support_context_end(context);
}
END_TEST


START_TEST(a_free_node_falls_and_no_node_is_no_work)
{
    mus_context *context = support_context();
    bare_scene s;
    bare_rod(&s);
    s.bare.nodes = 1, s.bare.springs = s.bare.bends = s.bare.pins = 0, s.mass[0] = 1e-12;
    mus_drape *drape = bare_drape(context, &s.bare, 64, 9.81);
    ck_assert_int_eq(mus_drape_step(drape, 2, 1.0), MUS_OK);
    ck_assert_double_eq_tol(mus_drape_positions(drape)[1], -0.5 * 9.81 * 4.0, 1e-13);
    mus_drape_destroy(drape);

    mus_bare none;
    mus_bare_init(&none, sizeof none);
    drape = bare_drape(context, &none, 64, 9.81);
    ck_assert_int_eq(mus_drape_node_count(drape), 0);
    ck_assert_int_eq(mus_drape_step(drape, 10, 1e-3), MUS_OK);
    mus_drape_destroy(drape);
    support_context_end(context);
}
END_TEST


static void bare_refused(mus_context *context, const bare_scene *s, mus_status want, const char *word)
{
    const size_t bytes = mus_context_bytes(context);
    mus_cloth *cloth = (mus_cloth *)&bytes;
    ck_assert_msg(mus_cloth_create_bare(context, &s->bare, &cloth) == want, "%s", word);
    ck_assert_ptr_null(cloth);
    ck_assert_uint_eq(mus_context_bytes(context), bytes);
    ck_assert_msg(strstr(mus_context_error(context), word) != NULL, "%s: %s", word, mus_context_error(context));
}


START_TEST(a_bare_cloth_that_cannot_be_is_refused_by_name)
{
    mus_context *context = support_context();
    bare_scene s;
#define REFUSED(change, status, word)                                                                                  \
    do {                                                                                                               \
        bare_rod(&s);                                                                                                  \
        change;                                                                                                        \
        bare_refused(context, &s, status, word);                                                                       \
    } while (0)
    REFUSED(s.bare.nodes = -1, MUS_ERR_ARG, "nodes is -1");
    REFUSED(s.bare.springs = -7, MUS_ERR_ARG, "springs is -7");
    REFUSED(s.bare.nodes = (1 << 24) + 1, MUS_ERR_LIMIT, "16777217 nodes");
    REFUSED(s.bare.springs = (1 << 28) + 1, MUS_ERR_LIMIT, "springs");
    REFUSED(s.bare.bends = (1 << 26) + 1, MUS_ERR_LIMIT, "bends");
    REFUSED(s.bare.mass = NULL, MUS_ERR_ARG, "nodes is NULL");
    REFUSED(s.bare.length = NULL, MUS_ERR_ARG, "springs is NULL");
    REFUSED(s.bare.bend = NULL, MUS_ERR_ARG, "bends is NULL");
    REFUSED(s.bare.pin = NULL, MUS_ERR_ARG, "pins is NULL");
    REFUSED(s.spring[3] = 3, MUS_ERR_ARG, "spring 1 names node 3, expected 0 to 2");
    REFUSED(s.spring[3] = 1, MUS_ERR_ARG, "spring 1 names node 1 twice");
    REFUSED(s.bend[2] = 0, MUS_ERR_ARG, "bend 0 names node 0 twice");
    REFUSED(s.pin[0] = -1, MUS_ERR_ARG, "pin 0 names node -1");
    REFUSED(s.place[5] = (double)NAN, MUS_ERR_ARG, "place[5]");
    REFUSED(s.place[0] = (double)INFINITY, MUS_ERR_ARG, "place[0]");
    REFUSED(s.mass[1] = 0.0, MUS_ERR_ARG, "mass[1] is 0 kg");
    REFUSED(s.mass[1] = -1.0, MUS_ERR_ARG, "mass[1] is -1");
    REFUSED(s.mass[2] = 1e-310, MUS_ERR_ARG, "mass[2]");
    REFUSED(s.mass[2] = (double)NAN, MUS_ERR_ARG, "mass[2]");
    REFUSED(s.length[0] = -1e-3, MUS_ERR_ARG, "length[0]");
    REFUSED(s.stiffness[1] = (double)INFINITY, MUS_ERR_ARG, "stiffness[1]");
    REFUSED(s.dashpot[1] = -1.0, MUS_ERR_ARG, "dashpot[1]");
    REFUSED(s.bend_stiffness[0] = (double)NAN, MUS_ERR_ARG, "bend_stiffness[0]");
    REFUSED(s.bare.size = 8, MUS_ERR_VERSION, "mus_bare");
#undef REFUSED
    mus_cloth *cloth;
    bare_rod(&s);
    ck_assert_int_eq(mus_cloth_create_bare(NULL, &s.bare, &cloth), MUS_ERR_ARG);
    ck_assert_int_eq(mus_cloth_create_bare(context, NULL, &cloth), MUS_ERR_ARG);
    ck_assert_int_eq(mus_cloth_create_bare(context, &s.bare, NULL), MUS_ERR_ARG);
    support_context_end(context);
}
END_TEST


START_TEST(a_bare_cloth_without_memory_leaves_nothing_behind)
{
    for (int64_t n = 0;; n++) {
        mus_context *context = support_context();
        bare_scene s;
        bare_rod(&s);
        mus_cloth *cloth;
        support_fail_after(n, false);
        mus_status status = mus_cloth_create_bare(context, &s.bare, &cloth);
        support_fail_never();
        ck_assert_int_eq(status == MUS_OK, cloth != NULL);
        mus_cloth_destroy(cloth);
        support_context_end(context);
        if (status == MUS_OK) break;
        ck_assert_int_eq(status, MUS_ERR_MEMORY);
    }
}
END_TEST


Suite *mus_suite_spring_network(void);
Suite *mus_suite_spring_network(void)
{
    Suite *suite = suite_create("spring_network");
    TCase *tests = tcase_create("spring_network");
    tcase_set_timeout(tests, 30.0);
    tcase_add_test(tests, bare_nodes_are_what_was_given);
    tcase_add_test(tests, an_oscillator_loses_what_runge_kutta_loses);
    tcase_add_test(tests, a_dashpot_damps_by_its_own_constant);
    tcase_add_test(tests, a_bend_pulls_by_second_differences);
    tcase_add_test(tests, a_drape_of_bare_nodes_starts_at_their_place_with_the_pins_held);
    tcase_add_test(tests, a_free_node_falls_and_no_node_is_no_work);
    tcase_add_test(tests, a_bare_cloth_that_cannot_be_is_refused_by_name);
    tcase_add_test(tests, a_bare_cloth_without_memory_leaves_nothing_behind);
    suite_add_tcase(suite, tests);
    return suite;
}
