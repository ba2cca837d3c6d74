/*
 * test_scene.c: cloth in free motion by both steppers (cases I2, I8-I10, D1-D3): what falls, swings,
 * spins and is damped does so as the formula says.
 */
#include <math.h>
#include <string.h>

#include <check.h>

#include "muslin/drape.h"
#include "support.h"

#define PI 3.14159265358979323846
#define GRAVITY 9.81
#define MOST 64

Suite *mus_suite_scene(void);

static const int32_t steppers[] = {MUS_METHOD_RK4, MUS_METHOD_VERLET};


/* bare nodes in a row or ring, springs from each to the next */
typedef struct row {
    int32_t nodes, springs, pins;
    double place[3 * MOST], mass[MOST], length[MOST], stiffness[MOST], dashpot[MOST];
    int32_t spring[2 * MOST], pin[2];
} row;


static mus_drape *make(mus_context *context, mus_cloth *cloth, int32_t stepper, int32_t precision, double gravity,
                       double drag)
{
    mus_drape_def def;
    mus_drape *drape = NULL;
    mus_drape_def_init(&def, sizeof def);
    def.integrator = stepper;
    def.precision = precision;
    def.gravity[1] = -gravity;
    def.drag = drag;
    ck_assert_msg(mus_drape_create(context, cloth, NULL, &def, &drape) == MUS_OK, "%s", mus_context_error(context));
    mus_cloth_destroy(cloth);
    return drape;
}


static mus_drape *make_row(mus_context *context, const row *r, int32_t stepper, double gravity, double drag)
{
    mus_bare bare;
    mus_cloth *cloth = NULL;
    mus_bare_init(&bare, sizeof bare);
    bare.nodes = r->nodes, bare.springs = r->springs, bare.pins = r->pins;
    bare.place = r->place, bare.mass = r->mass, bare.spring = r->spring, bare.length = r->length;
    bare.stiffness = r->stiffness, bare.dashpot = r->dashpot, bare.pin = r->pin;
    ck_assert_msg(mus_cloth_create_bare(context, &bare, &cloth) == MUS_OK, "%s", mus_context_error(context));
    return make(context, cloth, stepper, 64, gravity, drag);
}


/* n nodes of mass 1 along x, 1 m apart, springs of k and dashpots of c; the ends held */
static row chain(int32_t n, double k, double c)
{
    row r = {.nodes = n, .springs = n - 1, .pins = 2, .pin = {0, n - 1}};
    for (int32_t i = 0; i < n; i++) {
        r.place[3 * i] = i, r.mass[i] = r.length[i] = 1.0, r.stiffness[i] = k, r.dashpot[i] = c;
        r.spring[2 * i] = i, r.spring[2 * i + 1] = i + 1;
    }
    return r;
}


static mus_drape *make_grid(mus_context *context, int32_t n, double damping, int32_t stepper, int32_t precision,
                            double gravity)
{
    const double cell[2] = {0.05, 0.05};
    mus_cloth_def def;
    mus_cloth *cloth = NULL;
    mus_cloth_def_init(&def, sizeof def);
    mus_fabric fabric;
    mus_fabric_init(&fabric, sizeof fabric);
    def.fabric = &fabric;
    fabric.damping = damping;
    ck_assert_int_eq(mus_cloth_create_grid(context, n, n, cell, &def, &cloth), MUS_OK);
    return make(context, cloth, stepper, precision, gravity, 0.0);
}


/* ---- I2, D1 ---- */

START_TEST(a_node_falls_exactly_at_any_step)
{
    const double steps[] = {1e-3, 0.01, 0.1, 1.0};
    mus_context *context = support_context();
    for (int m = 0; m < 2; m++)
        for (int i = 0; i < 4; i++) {
            row r = chain(1, 0.0, 0.0);
            r.springs = r.pins = 0;
            mus_drape *drape = make_row(context, &r, steppers[m], GRAVITY, 0.0);
            ck_assert_int_eq(mus_drape_step(drape, (int32_t)lround(2.0 / steps[i]), steps[i]), MUS_OK);
            ck_assert_double_eq_tol(mus_drape_positions(drape)[1], -2.0 * GRAVITY, 1e-11);
            ck_assert_double_eq_tol(mus_drape_velocities(drape)[1], -2.0 * GRAVITY, 1e-11);
            mus_drape_destroy(drape);
        }
    support_context_end(context);
}
END_TEST


/* v = g/c (1 - exp(-c t)): order 4 by RK4 */
START_TEST(drag_brings_the_terminal_speed)
{
    mus_context *context = support_context();
    double error[2];
    for (int i = 0; i < 2; i++) {
        row r = chain(1, 0.0, 0.0);
        r.springs = r.pins = 0;
        mus_drape *drape = make_row(context, &r, MUS_METHOD_RK4, GRAVITY, 1.0);
        ck_assert_int_eq(mus_drape_step(drape, 100 << i, 0.05 / (1 << i)), MUS_OK);
        error[i] = fabs(mus_drape_velocities(drape)[1] + GRAVITY * (1.0 - exp(-5.0)));
        mus_drape_destroy(drape);
    }
    ck_assert_double_le(error[1], 1e-8);
    ck_assert_double_eq_tol(log2(error[0] / error[1]), 4.0, 0.1);
    support_context_end(context);
}
END_TEST


/* ---- I8 ---- */

/* phase of mode j of `masses` between fixed ends after `steps` steps of h, in turns away from whole ones */
static double mode_phase(mus_context *context, int32_t stepper, int32_t masses, int32_t j, int32_t steps, double h,
                         double omega)
{
    const row r = chain(masses + 2, 40.0, 0.0);
    double x[3 * MOST] = {0}, q = 0.0, p = 0.0;
    mus_drape *drape = make_row(context, &r, stepper, 0.0, 0.0);
    for (int32_t i = 0; i < r.nodes; i++) x[3 * i] = i + 0.01 * sin(i * j * PI / (masses + 1));
    ck_assert_int_eq(mus_drape_set_state(drape, x, NULL), MUS_OK);
    ck_assert_int_eq(mus_drape_step(drape, steps, h), MUS_OK);
    for (int32_t i = 1; i <= masses; i++) {
        q += sin(i * j * PI / (masses + 1)) * (mus_drape_positions(drape)[3 * i] - i);
        p += sin(i * j * PI / (masses + 1)) * mus_drape_velocities(drape)[3 * i];
    }
    mus_drape_destroy(drape);
    return atan2(-p / omega, q) / (2.0 * PI);
}


/* omega_j = 2 sqrt(k/m) sin(j pi / (2 (N + 1))); Verlet swings with (2/h) asin(omega h / 2) instead, exactly */
START_TEST(chains_swing_with_their_frequencies)
{
    const int32_t count[] = {2, 5, 50};
    mus_context *context = support_context();
    for (int m = 0; m < 2; m++)
        for (int c = 0; c < 3; c++)
            for (int32_t j = 1; j <= count[c]; j += count[c] > 5 ? 7 : 1) {
                const double omega = 2.0 * sqrt(40.0) * sin(j * PI / (2.0 * (count[c] + 1)));
                const double h = m == 0 ? 2.0 * PI / (800.0 * omega) : 2.0 * sin(PI / 800.0) / omega;
                const double turns = mode_phase(context, steppers[m], count[c], j, 800, h, omega);
                ck_assert_double_eq_tol(turns, 0.0, 1e-9);
            }
    support_context_end(context);
}
END_TEST


/* ---- I9, I10, D3 ---- */

/* momentum and angular momentum of a 20 x 20 grid; returns sum of m |v| */
static double momenta(const mus_drape *drape, double *p, double *l)
{
    const double *x = mus_drape_positions(drape), *v = mus_drape_velocities(drape);
    double size = 0.0;
    memset(p, 0, 3 * sizeof *p);
    memset(l, 0, 3 * sizeof *l);
    for (int32_t i = 0; i < 400; i++, x += 3, v += 3) {
        const int32_t a = i / 20, b = i % 20, border = (a == 0 || a == 19) + (b == 0 || b == 19);
        const double m = 1.0 / (1 << border);
        for (int d = 0; d < 3; d++) {
            p[d] += m * v[d];
            l[d] += m * (x[(d + 1) % 3] * v[(d + 2) % 3] - x[(d + 2) % 3] * v[(d + 1) % 3]);
        }
        size += m * sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    }
    return size;
}


/* drift of both over a tenth of a second of a shaken free cloth, with dashpots too: internal forces are balanced */
static void shake(mus_context *context, int32_t stepper, double damping, double finer, double *linear, double *angular)
{
    uint64_t random = 3;
    double x[1200], v[1200], p[2][3], l[2][3];
    mus_drape *drape = make_grid(context, 20, damping, stepper, 64, 0.0);
    for (int i = 0; i < 1200; i++) {
        x[i] = mus_drape_positions(drape)[i] + support_uniform(&random, -0.005, 0.005);
        v[i] = support_uniform(&random, -1.0, 1.0);
    }
    ck_assert_int_eq(mus_drape_set_state(drape, x, v), MUS_OK);
    const double steps = ceil(0.1 * finer / mus_drape_step_bound(drape)), size = momenta(drape, p[0], l[0]);
    ck_assert_int_eq(mus_drape_step(drape, (int32_t)steps, 0.1 / steps), MUS_OK);
    momenta(drape, p[1], l[1]);
    *linear = *angular = 0.0;
    for (int d = 0; d < 3; d++) {
        *linear = fmax(*linear, fabs(p[1][d] - p[0][d]) / size);
        *angular = fmax(*angular, fabs(l[1][d] - l[0][d]) / size);
    }
    mus_drape_destroy(drape);
}


/* Verlet keeps both to rounding, RK4 angular momentum to order 4 at least */
START_TEST(free_cloth_keeps_its_momenta)
{
    mus_context *context = support_context();
    double linear, coarse, fine;
    for (int damped = 0; damped < 2; damped++) {
        shake(context, MUS_METHOD_RK4, 0.1 * damped, 4.0, &linear, &coarse);
        ck_assert_double_le(linear, 1e-13);
        shake(context, MUS_METHOD_RK4, 0.1 * damped, 8.0, &linear, &fine);
        ck_assert_double_le(linear, 1e-13);
        ck_assert_double_ge(log2(coarse / fine), 3.9);
        shake(context, MUS_METHOD_VERLET, 0.1 * damped, 2.0, &linear, &fine);
        ck_assert_double_le(linear, 1e-13);
        ck_assert_double_le(fine, 1e-13);
    }
    support_context_end(context);
}
END_TEST


/* a flat cloth in any plane falls flat and unstretched, and dashpots do not hold it up */
START_TEST(flat_cloth_falls_flat)
{
    mus_context *context = support_context();
    const double ca = cos(0.7), sa = sin(0.7), cb = cos(1.9), sb = sin(1.9);
    for (int m = 0; m < 2; m++)
        for (int damped = 0; damped < 2; damped++) {
            double x[1200];
            mus_drape *drape = make_grid(context, 20, damped, steppers[m], 64, GRAVITY);
            for (int32_t i = 0; i < 400; i++) {
                const double a = 0.05 * (i % 20), b = 0.05 * (i / 20), up = sa * a + ca * b;
                x[3 * i] = ca * a - sa * b, x[3 * i + 1] = cb * up, x[3 * i + 2] = sb * up;
            }
            ck_assert_int_eq(mus_drape_set_state(drape, x, NULL), MUS_OK);
            const double steps = ceil(0.5 / (0.9 * mus_drape_step_bound(drape)));
            ck_assert_int_eq(mus_drape_step(drape, (int32_t)steps, 0.5 / steps), MUS_OK);
            for (int32_t i = 0; i < 400; i++) {
                const double *now = mus_drape_positions(drape) + 3 * i;
                ck_assert_double_eq_tol(now[0], x[3 * i], 1e-13);
                ck_assert_double_eq_tol(now[1], x[3 * i + 1] - 0.125 * GRAVITY, 1e-13);
                ck_assert_double_eq_tol(now[2], x[3 * i + 2], 1e-13);
                ck_assert_double_eq_tol(mus_drape_velocities(drape)[3 * i + 1], -0.5 * GRAVITY, 2e-12);
            }
            mus_drape_destroy(drape);
        }
    support_context_end(context);
}
END_TEST


/* a ring of twelve nodes in balance turns for ever, critical dashpots or not */
START_TEST(a_ring_with_dashpots_spins_on)
{
    mus_context *context = support_context();
    const double turn = 2.0 * PI, k = 1e4, side = 2.0 * sin(PI / 12.0);
    double v[36] = {0};
    row r = {.nodes = 12, .springs = 12};
    for (int32_t i = 0; i < 12; i++) {
        const double a = 2.0 * PI * i / 12.0;
        r.place[3 * i] = cos(a), r.place[3 * i + 1] = sin(a);
        v[3 * i] = -turn * sin(a), v[3 * i + 1] = turn * cos(a);
        /* k (side - length) 2 sin(pi/12) = m turn^2 */
        r.mass[i] = 0.1, r.stiffness[i] = k, r.length[i] = side - 0.1 * turn * turn / (k * 2.0 * sin(PI / 12.0));
        r.dashpot[i] = 2.0 * sqrt(0.5 * k * 0.1);
        r.spring[2 * i] = i, r.spring[2 * i + 1] = (i + 1) % 12;
    }
    mus_drape *drape = make_row(context, &r, MUS_METHOD_RK4, 0.0, 0.0);
    ck_assert_int_eq(mus_drape_set_state(drape, r.place, v), MUS_OK);
    ck_assert_int_eq(mus_drape_step(drape, 40000, 2.5e-5), MUS_OK);
    for (int32_t i = 0; i < 36; i++) {
        ck_assert_double_eq_tol(mus_drape_positions(drape)[i], r.place[i], 1e-12);
        ck_assert_double_eq_tol(mus_drape_velocities(drape)[i], v[i], 1e-11);
    }
    mus_drape_destroy(drape);
    support_context_end(context);
}
END_TEST


/* ---- D2 ---- */

/* log decrement 2 pi zeta / sqrt(1 - zeta^2) of the middle node of three */
START_TEST(dashpots_damp_by_their_ratio)
{
    const double zeta[] = {0.01, 0.1, 0.5};
    mus_context *context = support_context();
    for (int i = 0; i < 3; i++) {
        const double omega = 5.0, damped = omega * sqrt(1.0 - zeta[i] * zeta[i]), decay = zeta[i] * omega;
        const row r = chain(3, 0.5 * omega * omega, zeta[i] * omega);
        const double steps = ceil(2.0 * PI / damped / (0.05 / omega)), start[9] = {0, 0, 0, 1.1, 0, 0, 2, 0, 0};
        mus_drape *drape = make_row(context, &r, MUS_METHOD_RK4, 0.0, 0.0);
        ck_assert_int_eq(mus_drape_set_state(drape, start, NULL), MUS_OK);
        ck_assert_int_eq(mus_drape_step(drape, (int32_t)steps, 2.0 * PI / damped / steps), MUS_OK);
        const double x = mus_drape_positions(drape)[3] - 1.0, v = mus_drape_velocities(drape)[3];
        const double before = hypot(0.1, decay * 0.1 / damped), after = hypot(x, (v + decay * x) / damped);
        const double exact = 2.0 * PI * zeta[i] / sqrt(1.0 - zeta[i] * zeta[i]);
        ck_assert_double_eq_tol(log(before / after) / exact, 1.0, 1e-6);
        mus_drape_destroy(drape);
    }
    support_context_end(context);
}
END_TEST


Suite *mus_suite_scene(void)
{
    Suite *suite = suite_create("scene");
    TCase *tests = tcase_create("scene");
    tcase_set_timeout(tests, 60);
    tcase_add_test(tests, a_node_falls_exactly_at_any_step);
    tcase_add_test(tests, drag_brings_the_terminal_speed);
    tcase_add_test(tests, chains_swing_with_their_frequencies);
    tcase_add_test(tests, free_cloth_keeps_its_momenta);
    tcase_add_test(tests, flat_cloth_falls_flat);
    tcase_add_test(tests, a_ring_with_dashpots_spins_on);
    tcase_add_test(tests, dashpots_damp_by_their_ratio);
    suite_add_tcase(suite, tests);
    return suite;
}
