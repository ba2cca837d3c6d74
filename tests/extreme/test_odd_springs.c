/*
 * test_odd_springs.c: nodes as light as 1e-12 kg and as heavy as 1e6 kg, springs without length, nodes in one place,
 * springs crushed and torn.
 */
#include "bare.h"

Suite *mus_suite_odd_springs(void);

static const double weightless[3] = {0.0, 0.0, 0.0};


/* a node of any mass on a spring: the bound is announced by formula, and RK4 loses what it loses (I3) */
START_TEST(a_node_of_any_mass_swings_under_its_announced_bound)
{
    static const double masses[] = {1e-12, 1e-6, 1.0, 1e6};
    for (int m = 0; m < 4; m++) {
        mus_context *context = support_context();
        const double place[2] = {0.0, 1.001}, mass[2] = {0.0, masses[m]}, k = 100.0;
        mus_drape *drape = extreme_drape(context, extreme_chain(context, 2, place, mass, 1.0, k, true), 64, weightless);
        const double bound = mus_drape_step_bound(drape), h = 0.9 * bound, z2 = h * h * k / masses[m];
        ck_assert_double_eq_tol(bound / (2.62 * sqrt(masses[m] / (2.0 * k))), 1.0, 1e-14);
        mus_estimate forecast;
        mus_estimate_init(&forecast, sizeof forecast);
        ck_assert_int_eq(mus_drape_estimate(drape, 0.02, &forecast), MUS_OK);
        ck_assert_int_eq(forecast.steps_per_frame, (int32_t)ceil(0.02 / (0.9 * bound)));
        ck_assert_int_eq(forecast.node, 1);
        ck_assert_double_eq(forecast.node_mass, masses[m]);
        const double before = extreme_report(drape).energy;
        ck_assert_double_eq_tol(before / (0.5 * k * 1e-6), 1.0, 1e-12);
        ck_assert_int_eq(mus_drape_step(drape, 30, h), MUS_OK);
        const double decay = pow(1.0 - z2 * z2 * z2 / 72.0 + z2 * z2 * z2 * z2 / 576.0, 30.0);
        ck_assert_double_eq_tol(extreme_report(drape).energy / before / decay, 1.0, 1e-8);
        ck_assert_double_eq_tol(mus_drape_time(drape), 30.0 * h, 1e-15 * 30.0 * h);
        mus_drape_destroy(drape);
        support_context_end(context);
    }
}
END_TEST


/* 1e12 between two masses of one cloth. The light end swings 1e6 times as fast and sets the bound; both the light
 * mode and the slow pull on the heavy node come out as in closed form. Float keeps its own digits of the same */
START_TEST(masses_of_1_to_1e12_live_in_one_cloth)
{
    mus_context *context = support_context();
    const double place[2] = {0.0, 1.01}, mass[2] = {1e6, 1e-6}, k = 100.0,
                 reduced = mass[0] * mass[1] / (mass[0] + mass[1]);
    mus_drape *drape =
        extreme_drape(context, extreme_chain(context, 2, place, mass, 1.0, k, false), _i ? 64 : 32, weightless);
    const double omega = sqrt(k / reduced), h = 0.01 / omega;
    ck_assert_double_lt(h, mus_drape_step_bound(drape));
    ck_assert_int_eq(mus_drape_step(drape, 5000, h), MUS_OK);
    extreme_finite(drape);

    /* about the centre of mass, stretch 10 mm cos(omega t) */
    const double *x = mus_drape_positions(drape);
    const double stretch = 0.01 * cos(omega * mus_drape_time(drape));
    ck_assert_double_eq_tol(x[3] - x[0], 1.0 + stretch, _i ? 1e-10 : 1e-4);
    ck_assert_double_eq_tol(x[0], 0.01 * mass[1] / mass[0], _i ? 1e-13 : 1e-6);
    mus_drape_destroy(drape);
    support_context_end(context);
}
END_TEST


/* a mass of 0 is allowed at a pin, and stays held when it is let go: nothing else can be done with it */
START_TEST(a_massless_node_is_held_whatever_is_asked)
{
    mus_context *context = support_context();
    const double place[2] = {0.0, 1.5}, mass[2] = {0.0, 0.1}, gravity[3] = {0.0, -9.81, 0.0};
    mus_drape *drape = extreme_drape(context, extreme_chain(context, 2, place, mass, 1.0, 10.0, true), 64, gravity);
    ck_assert_int_eq(mus_drape_pin(drape, 0, 0), MUS_OK);
    ck_assert_int_eq(mus_drape_step(drape, 200, 0.5 * mus_drape_step_bound(drape)), MUS_OK);
    extreme_finite(drape);
    for (int d = 0; d < 3; d++) ck_assert_double_eq(mus_drape_positions(drape)[d], 0.0);
    ck_assert_double_lt(mus_drape_positions(drape)[4], -0.01);
    ck_assert(isfinite(extreme_report(drape).energy));
    mus_drape_destroy(drape);
    support_context_end(context);
}
END_TEST


/* two free nodes on a spring of rest length 0 meet at pi / (2 sqrt(2 k / m)) at speed d sqrt(2 k / m), and go
 * through each other */
START_TEST(a_spring_without_length_is_a_linear_force)
{
    mus_context *context = support_context();
    const double d = 0.02, place[2] = {0.0, d}, mass[2] = {1e-3, 1e-3}, k = 10.0;
    mus_drape *drape =
        extreme_drape(context, extreme_chain(context, 2, place, mass, 0.0, k, false), _i ? 64 : 32, weightless);
    const double omega = sqrt(2.0 * k / mass[0]), quarter = 1.5707963267948966 / omega;
    ck_assert_double_eq_tol(quarter, 0.0111072, 1e-7);
    ck_assert_int_eq(mus_drape_step(drape, 400, quarter / 400), MUS_OK);
    const double *x = mus_drape_positions(drape), *v = mus_drape_velocities(drape);
    ck_assert_double_eq_tol(x[3] - x[0], 0.0, _i ? 1e-11 : 1e-7);
    ck_assert_double_eq_tol(v[0] - v[3], d * omega, _i ? 1e-9 : 1e-4);
    ck_assert_int_eq(mus_drape_step(drape, 400, quarter / 400), MUS_OK);
    ck_assert_double_eq_tol(x[3] - x[0], -d, _i ? 1e-11 : 1e-7);
    extreme_finite(drape);
    ck_assert(isfinite(extreme_report(drape).max_strain));
    mus_drape_destroy(drape);
    support_context_end(context);
}
END_TEST


/* two nodes in one place on a spring that wants 0.1 m: no direction, so no force, and no NaN; a third node on the
 * same chain is pulled as ever. Strain -1 stands in no report of the largest; the energy counts it */
START_TEST(nodes_in_one_place_feel_no_force_and_no_nan)
{
    mus_context *context = support_context();
    const double place[3] = {0.0, 0.0, 0.12}, mass[3] = {0.01, 0.01, 0.01};
    mus_drape *drape =
        extreme_drape(context, extreme_chain(context, 3, place, mass, 0.1, 50.0, false), _i ? 64 : 32, weightless);
    const double energy = 0.5 * 50.0 * (0.01 + 0.0004);
    ck_assert_double_eq_tol(extreme_report(drape).energy, energy, 1e-7);

    /* the first step: the pair is drawn towards the third node by its second half alone */
    ck_assert_int_eq(mus_drape_step(drape, 1, 1e-5), MUS_OK);
    extreme_finite(drape);
    ck_assert_double_gt(mus_drape_velocities(drape)[3], 0.0);
    ck_assert_double_lt(fabs(mus_drape_velocities(drape)[0]), mus_drape_velocities(drape)[3]);
    ck_assert_int_eq(mus_drape_step(drape, 5000, 0.5 * mus_drape_step_bound(drape)), MUS_OK);
    extreme_finite(drape);
    ck_assert_double_le(extreme_report(drape).energy, energy * 1.001);
    mus_drape_destroy(drape);
    support_context_end(context);
}
END_TEST


/* a whole cloth in one place */
START_TEST(a_cloth_heaped_in_one_place_stays_finite)
{
    mus_context *context = support_context();
    mus_drape *drape = extreme_drape(context, extreme_grid(context, 4, 4, 0.01, NULL), _i ? 64 : 32, weightless);
    double x[48];
    for (int i = 0; i < 48; i++) x[i] = 0.25;
    ck_assert_int_eq(mus_drape_set_state(drape, x, NULL), MUS_OK);
    memcpy(x, mus_drape_positions(drape), sizeof x); /* as float keeps them */
    ck_assert_int_eq(mus_drape_step(drape, 500, 0.9 * mus_drape_step_bound(drape)), MUS_OK);
    for (int i = 0; i < 48; i++) ck_assert_double_eq(mus_drape_positions(drape)[i], x[i]);
    const mus_drape_report report = extreme_report(drape);
    ck_assert(isfinite(report.energy) && isfinite(report.max_strain) && isfinite(report.residual));
    mus_drape_destroy(drape);
    support_context_end(context);
}
END_TEST


/* a spring at 1e-12 of its length, and one at 1000 times: the report says the strain, and nothing is clamped: the
 * stretched one flies through the middle and out to the other side with the energy that it had */
START_TEST(a_spring_is_crushed_and_torn_without_a_clamp)
{
    static const double factors[] = {1e-12, 1e3};
    for (int f = 0; f < 2; f++) {
        mus_context *context = support_context();
        const double rest = 0.1, place[2] = {0.0, rest * factors[f]}, mass[2] = {0.0, 0.01}, k = 100.0;
        mus_drape *drape =
            extreme_drape(context, extreme_chain(context, 2, place, mass, rest, k, true), _i ? 64 : 32, weightless);
        const mus_drape_report before = extreme_report(drape);
        const double stretch = place[1] - rest;
        ck_assert_double_eq_tol(before.energy / (0.5 * k * stretch * stretch), 1.0, 1e-6);
        ck_assert_double_eq_tol(before.max_strain, f ? factors[f] - 1.0 : 0.0, 1e-3);

        /* half a period from rest on: as far on the other side of the rest length, or of the held node */
        const double h = 1e-3 / sqrt(k / mass[1]);
        double out = 0.0, most = 0.0;
        for (int step = 0; step < 70; step++) {
            ck_assert_int_eq(mus_drape_step(drape, 100, h), MUS_OK);
            const double x = mus_drape_positions(drape)[3];
            out = f ? fmin(out, x) : fmax(out, x);
            most = fmax(most, extreme_report(drape).energy);
        }
        extreme_finite(drape);
        ck_assert_double_eq_tol(out / (f ? -place[1] : 2.0 * rest), 1.0, 1e-3);
        ck_assert_double_le(most, before.energy * (_i ? 1.001 : 1.003));
        mus_drape_destroy(drape);
        support_context_end(context);
    }
}
END_TEST


Suite *mus_suite_odd_springs(void)
{
    Suite *suite = suite_create("odd_springs");
    TCase *tests = tcase_create("odd_springs");
    tcase_add_test(tests, a_node_of_any_mass_swings_under_its_announced_bound);
    tcase_add_loop_test(tests, masses_of_1_to_1e12_live_in_one_cloth, 0, 2);
    tcase_add_test(tests, a_massless_node_is_held_whatever_is_asked);
    tcase_add_loop_test(tests, a_spring_without_length_is_a_linear_force, 0, 2);
    tcase_add_loop_test(tests, nodes_in_one_place_feel_no_force_and_no_nan, 0, 2);
    tcase_add_loop_test(tests, a_cloth_heaped_in_one_place_stays_finite, 0, 2);
    tcase_add_loop_test(tests, a_spring_is_crushed_and_torn_without_a_clamp, 0, 2);
    suite_add_tcase(suite, tests);
    return suite;
}
