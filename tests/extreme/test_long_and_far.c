/*
 * test_long_and_far.c: cloth whose bending is far softer than its threads, long runs, steps that are none, scenes far
 * from the origin and of other units.
 */
#include "bare.h"

Suite *mus_suite_long_and_far(void);

static const double weightless[3] = {0.0, 0.0, 0.0}, down[3] = {0.0, -9.81, 0.0};


/* ---- stiff threads, soft bending ---- */

/* three nodes in a row, two held, threads of `ratio` N/m and bending of 1 N/m on them: the third swings across with
 * omega = 1 exactly, while a push along the row would swing with sqrt(ratio) */
static mus_drape *reed(mus_context *context, double ratio, double across)
{
    const double place[9] = {0, 0, 0, 1, 0, 0, 2, 0, 0}, mass[3] = {1, 1, 1}, length[2] = {1, 1};
    const double stiffness[2] = {ratio, ratio}, bend_stiffness = 1.0;
    const int32_t spring[4] = {0, 1, 1, 2}, bend[3] = {0, 1, 2}, pin[2] = {0, 1};
    mus_bare bare;
    mus_cloth *cloth = NULL;
    mus_bare_init(&bare, sizeof bare);
    bare.nodes = 3, bare.place = place, bare.mass = mass;
    bare.springs = 2, bare.spring = spring, bare.length = length, bare.stiffness = stiffness;
    bare.bends = 1, bare.bend = bend, bare.bend_stiffness = &bend_stiffness;
    bare.pins = 2, bare.pin = pin;
    ck_assert_int_eq(mus_cloth_create_bare(context, &bare, &cloth), MUS_OK);
    mus_drape *drape = extreme_drape(context, cloth, 64, weightless);
    double x[9];
    memcpy(x, place, sizeof x);
    x[7] = across;
    ck_assert_int_eq(mus_drape_set_state(drape, x, NULL), MUS_OK);
    return drape;
}


/* at 0.9 of the bound the slow motion is right to 1e-6 (and to the z^4/120 of RK4 where all is slow), and the steps
 * that it takes grow as the root of the ratio, which the bound says before the run */
START_TEST(soft_bending_on_stiff_threads_swings_right)
{
    const double ratio[] = {1e0, 1e2, 1e4, 1e6, 1e8};
    mus_context *context = support_context();
    for (int i = 0; i < 5; i++) {
        /* so small that the thread, which is longer by a part y^2/2, is not felt */
        const double y0 = 1e-9, end = 1.0;
        mus_drape *drape = reed(context, ratio[i], y0);
        const double bound = mus_drape_step_bound(drape), steps = ceil(end / (0.9 * bound)), h = end / steps;
        ck_assert_int_eq(mus_drape_step(drape, (int32_t)steps, h), MUS_OK);
        const double y = mus_drape_positions(drape)[7] / y0, v = mus_drape_velocities(drape)[7] / y0;
        const double tolerance = 1e-6 + pow(h, 4.0) / 60.0;
        ck_assert_double_eq_tol(y, cos(end), tolerance);
        ck_assert_double_eq_tol(v, -sin(end), tolerance);
        /* T of the third node: 2 ratio of the spring, 4 of the bend */
        ck_assert_double_eq_tol(bound, 2.62 / sqrt(2.0 * ratio[i] + 4.0), 1e-12);
        mus_drape_destroy(drape);
    }
    support_context_end(context);
}
END_TEST


/* ---- steps that are none ---- */

START_TEST(no_step_and_steps_of_zero_change_nothing_and_others_are_refused)
{
    const double bad[] = {-1e-3, NAN, INFINITY, -INFINITY, 1e-320};
    mus_context *context = support_context();
    for (int32_t precision = 32; precision <= 64; precision += 32) {
        mus_drape *drape = extreme_drape(context, extreme_grid(context, 4, 4, 0.01, NULL), precision, down);
        const double h = 0.5 * mus_drape_step_bound(drape);
        ck_assert_int_eq(mus_drape_step(drape, 10, h), MUS_OK);
        const uint64_t hash = mus_drape_hash(drape);
        ck_assert_int_eq(mus_drape_step(drape, 0, h), MUS_OK);
        ck_assert_int_eq(mus_drape_step(drape, 10, 0.0), MUS_OK);
        ck_assert_int_eq(mus_drape_step(drape, -1, h), MUS_ERR_ARG);
        ck_assert_int_eq(mus_drape_step(drape, INT32_MIN, h), MUS_ERR_ARG);
        for (int i = 0; i < 5; i++) {
            ck_assert_int_eq(mus_drape_step(drape, 10, bad[i]), MUS_ERR_ARG);
            ck_assert_ptr_nonnull(strstr(mus_context_error(context), "step is"));
        }
        ck_assert_uint_eq(mus_drape_hash(drape), hash);
        mus_drape_destroy(drape);
    }
    support_context_end(context);
}
END_TEST


/* ---- long runs ---- */

#define LINKS 5

/* a chain of soft springs that hangs at rest, each spring carrying what is below it; place (LINKS x 3) is filled */
static mus_drape *hanging_chain(mus_context *context, int32_t precision, int32_t method, double *place)
{
    const double k = 2.5e-4, weight = 1e-3 * 9.81e-3;
    double mass[LINKS], length[LINKS], stiffness[LINKS], dashpot[LINKS];
    int32_t spring[2 * LINKS];
    const int32_t pin = 0;
    memset(place, 0, 3 * LINKS * sizeof *place);
    for (int32_t i = 0; i < LINKS; i++) {
        mass[i] = 1e-3, stiffness[i] = k, length[i] = 1.0, dashpot[i] = 1e-4;
        spring[2 * i] = i, spring[2 * i + 1] = i + 1;
        if (i > 0) place[3 * i + 1] = place[3 * i - 2] - 1.0 - (LINKS - i) * weight / k;
    }
    mus_bare bare;
    mus_cloth *cloth = NULL;
    mus_drape *drape = NULL;
    mus_drape_def def;
    mus_bare_init(&bare, sizeof bare);
    bare.nodes = LINKS, bare.springs = LINKS - 1, bare.pins = 1, bare.pin = &pin;
    bare.place = place, bare.mass = mass, bare.spring = spring, bare.length = length;
    bare.stiffness = stiffness, bare.dashpot = dashpot;
    mus_drape_def_init(&def, sizeof def);
    def.precision = precision;
    def.integrator = method;
    def.gravity[1] = -9.81e-3;
    def.drag = 0.0;
    ck_assert_int_eq(mus_cloth_create_bare(context, &bare, &cloth), MUS_OK);
    ck_assert_int_eq(mus_drape_create(context, cloth, NULL, &def, &drape), MUS_OK);
    mus_cloth_destroy(cloth);
    return drape;
}


/* 1e6 steps of a second: nothing creeps, and time is what it should be to the last bit, in float too */
START_TEST(a_cloth_at_rest_is_at_rest_after_a_million_seconds)
{
    mus_context *context = support_context();
    for (int32_t precision = 32; precision <= 64; precision += 32) {
        double place[3 * LINKS];
        const int32_t method = precision == 32 ? MUS_METHOD_RK4 : MUS_METHOD_VERLET;
        mus_drape *drape = hanging_chain(context, precision, method, place);
        for (int32_t part = 0; part < 10; part++) ck_assert_int_eq(mus_drape_step(drape, 100000, 1.0), MUS_OK);
        ck_assert(mus_drape_time(drape) == 1e6);
        for (int32_t i = 0; i < 3 * LINKS; i++)
            ck_assert_double_le(fabs(mus_drape_positions(drape)[i] - place[i]), 1e-6);
        mus_drape_destroy(drape);
    }
    support_context_end(context);
}
END_TEST


/* time of steps of 1 ms: a float sum would double its rate at 16384 s and stop at 32768 s */
START_TEST(time_is_no_running_sum_of_steps)
{
    mus_context *context = support_context();
    const double place = 0.0, mass = 1.0;
    mus_drape *drape = extreme_drape(context, extreme_chain(context, 1, &place, &mass, 0.0, 0.0, true), 32, weightless);
    for (int32_t call = 1; call <= 10; call++) {
        ck_assert_int_eq(mus_drape_step(drape, 100000, 1e-3), MUS_OK);
        ck_assert(mus_drape_time(drape) == call * 1e5 * 1e-3);
    }
    mus_drape_destroy(drape);
    support_context_end(context);
}
END_TEST


/* ---- far away, and in other units ---- */

/* a chain of eight nodes let go level, `far` from the origin, all lengths `scale` times as long */
static void let_go(mus_context *context, int32_t precision, double far, double scale, double *out)
{
    enum { N = 8 };
    double place[N], mass[N], gravity[3] = {0.0, -9.81 * scale, 0.0};
    for (int32_t i = 0; i < N; i++) place[i] = far + 0.05 * scale * i, mass[i] = 0.01;
    mus_cloth *cloth = extreme_chain(context, N, place, mass, 0.05 * scale, 50.0, true);
    mus_drape *drape = extreme_drape(context, cloth, precision, gravity);
    ck_assert_int_eq(mus_drape_step(drape, 500, 1e-3), MUS_OK);
    for (int32_t i = 0; i < 3 * N; i++)
        out[i] = (mus_drape_positions(drape)[i] - (i % 3 == 0 ? far : 0.0)) / scale;
    mus_drape_destroy(drape);
}


/* 1e6 m away a double holds 1.2e-10 m, and the shape after half a second is that of the origin to 1e-8 m. Float
 * keeps its places from the middle of the cloth, and is as good there as anywhere */
START_TEST(cloth_a_thousand_kilometres_away_moves_as_here)
{
    mus_context *context = support_context();
    for (int32_t precision = 32; precision <= 64; precision += 32) {
        double near[24], there[24];
        let_go(context, precision, 0.0, 1.0, near);
        let_go(context, precision, 1048576.0, 1.0, there);
        for (int i = 0; i < 24; i++) ck_assert_double_eq_tol(there[i], near[i], precision == 64 ? 1e-8 : 2e-5);
    }
    support_context_end(context);
}
END_TEST


/* what float cannot hold is refused by name */
START_TEST(places_that_float_cannot_hold_are_refused)
{
    mus_context *context = support_context();
    const double place[2] = {0.0, 1e6}, mass[2] = {1.0, 1.0}, x[6] = {1e6, 0, 0, 1e6 + 1, 0, 0};
    for (int32_t precision = 32; precision <= 64; precision += 32) {
        const mus_status want = precision == 32 ? MUS_ERR_ARG : MUS_OK;
        mus_drape_def def;
        mus_drape *drape = NULL;
        mus_drape_def_init(&def, sizeof def);
        def.precision = precision;
        mus_cloth *cloth = extreme_chain(context, 2, place, mass, 1.0, 1.0, false);
        ck_assert_int_eq(mus_drape_create(context, cloth, NULL, &def, &drape), want);
        ck_assert((drape != NULL) == (want == MUS_OK));
        mus_drape_destroy(drape);
        mus_cloth_destroy(cloth);

        drape = extreme_drape(context, extreme_grid(context, 1, 2, 1.0, NULL), precision, down);
        const uint64_t before = mus_drape_hash(drape);
        ck_assert_int_eq(mus_drape_set_state(drape, x, NULL), want);
        if (want != MUS_OK) ck_assert_ptr_nonnull(strstr(mus_context_error(context), "node 0 is"));
        ck_assert_int_eq(mus_drape_hash(drape) == before, want != MUS_OK);
        mus_drape_destroy(drape);
    }
    support_context_end(context);
}
END_TEST


/* lengths in millimetres or kilometres (gravity with them) give the same shape: forces of springs are k times a
 * length, so nothing else changes */
START_TEST(lengths_in_other_units_give_the_same_shape)
{
    const double scale[] = {1e-3, 1e3, 0.0254, 512.0};
    mus_context *context = support_context();
    double metre[24], other[24];
    let_go(context, 64, 0.0, 1.0, metre);
    for (int k = 0; k < 4; k++) {
        let_go(context, 64, 0.0, scale[k], other);
        for (int i = 0; i < 24; i++) ck_assert_double_eq_tol(other[i], metre[i], 1e-12);
    }
    /* a power of two does not even round otherwise */
    for (int i = 0; i < 24; i++) ck_assert(other[i] == metre[i]);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_long_and_far(void)
{
    Suite *suite = suite_create("long_and_far");
    TCase *tests = tcase_create("long_and_far");
    tcase_set_timeout(tests, 60);
    tcase_add_test(tests, soft_bending_on_stiff_threads_swings_right);
    tcase_add_test(tests, no_step_and_steps_of_zero_change_nothing_and_others_are_refused);
    tcase_add_test(tests, a_cloth_at_rest_is_at_rest_after_a_million_seconds);
    tcase_add_test(tests, time_is_no_running_sum_of_steps);
    tcase_add_test(tests, cloth_a_thousand_kilometres_away_moves_as_here);
    tcase_add_test(tests, places_that_float_cannot_hold_are_refused);
    tcase_add_test(tests, lengths_in_other_units_give_the_same_shape);
    suite_add_tcase(suite, tests);
    return suite;
}
