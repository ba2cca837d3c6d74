/*
 * motion.c: cloth in motion without a body: free fall, springs, chains, momentum, damping (cases I2, I3,
 * I6, I8-I10, I12, D1-D3).
 *
 * Everything is a cloth of bare nodes or a grid, stepped by mus_drape_step() in double with its own stepper, unless a
 * row says float.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "command/args.h"
#include "verify.h"

#define PI 3.14159265358979323846
#define GRAVITY 9.81
#define CHAIN 52 /* most nodes of a chain, its two ends included */


/* ---- scenes ---- */

/* a drape of `cloth`, which is freed; without drag, gravity down y */
static mus_status hang(verify *v, mus_cloth *cloth, int32_t precision, int32_t threads, double gravity,
                       mus_drape **out)
{
    mus_drape_def def;
    mus_drape_def_init(&def, sizeof def);
    def.precision = precision;
    def.threads = threads;
    def.drag = 0.0;
    def.gravity[1] = -gravity;
    *out = NULL;
    const mus_status status = cloth != NULL ? mus_drape_create(v->context, cloth, NULL, &def, out) : MUS_ERR_ARG;
    mus_cloth_destroy(cloth);
    return status;
}


/* n nodes of mass 1 in a row along x, 1 m apart, a spring of k and a dashpot from each to the next; the first is held,
 * and with `both` the last */
static mus_status chain(verify *v, int32_t precision, int32_t n, double k, double dashpot, bool both, mus_drape **out)
{
    double place[3 * CHAIN] = {0}, mass[CHAIN], length[CHAIN], stiffness[CHAIN], damping[CHAIN];
    int32_t spring[2 * CHAIN];
    const int32_t pin[2] = {0, n - 1};
    for (int32_t i = 0; i < n; i++) {
        place[3 * i] = i, mass[i] = 1.0, length[i] = 1.0, stiffness[i] = k, damping[i] = dashpot;
        spring[2 * i] = i, spring[2 * i + 1] = i + 1;
    }
    mus_bare bare;
    mus_bare_init(&bare, sizeof bare);
    bare.nodes = n, bare.place = place, bare.mass = mass;
    bare.springs = n - 1, bare.spring = spring, bare.length = length, bare.stiffness = stiffness;
    bare.dashpot = damping;
    bare.pins = both ? 2 : 1, bare.pin = pin;
    mus_cloth *cloth = NULL;
    const mus_status status = mus_cloth_create_bare(v->context, &bare, &cloth);
    return status == MUS_OK ? hang(v, cloth, precision, 1, 0.0, out) : status;
}


/* one node of mass 1 at (0, y, 0) */
static mus_status point(verify *v, double y, int32_t precision, double drag, mus_drape **out)
{
    const double place[3] = {0.0, y, 0.0}, mass = 1.0;
    mus_bare bare;
    mus_drape_def def;
    mus_cloth *cloth = NULL;
    mus_bare_init(&bare, sizeof bare);
    bare.nodes = 1, bare.place = place, bare.mass = &mass;
    mus_drape_def_init(&def, sizeof def);
    def.precision = precision;
    def.drag = drag;
    mus_status status = mus_cloth_create_bare(v->context, &bare, &cloth);
    if (status == MUS_OK) status = mus_drape_create(v->context, cloth, NULL, &def, out);
    mus_cloth_destroy(cloth);
    return status;
}


/* a grid of n x n nodes, 0.15 kg/m2 */
static mus_status grid(verify *v, int32_t n, double cell, double damping, int32_t precision, int32_t threads,
                       double gravity, mus_drape **out)
{
    const double cells[2] = {cell, cell};
    mus_cloth_def def;
    mus_cloth *cloth = NULL;
    mus_cloth_def_init(&def, sizeof def);
    mus_fabric fabric;
    mus_fabric_init(&fabric, sizeof fabric);
    def.fabric = &fabric;
    fabric.weight = 0.15;
    fabric.damping = damping;
    const mus_status status = mus_cloth_create_grid(v->context, n, n, cells, &def, &cloth);
    return status == MUS_OK ? hang(v, cloth, precision, threads, gravity, out) : status;
}


/* `seconds` in whole steps of at most `h` */
static mus_status step_for(mus_drape *drape, double seconds, double h)
{
    const double steps = ceil(seconds / h - 1e-9);
    return mus_drape_step(drape, (int32_t)steps, seconds / steps);
}


/* a row, or the sentence of what went wrong */
static void row(verify *v, mus_status status, const char *id, const char *text, double exact, double got,
                double tolerance)
{
    if (status == MUS_OK) verify_add(v, id, text, exact, got, tolerance);
    else verify_broken(v, id, text, status);
}


/* ---- I2, I3, I6 with the cloth's stepper ---- */

static void node_falls(verify *v)
{
    static const double steps[] = {1e-3, 0.01, 0.1, 1.0};
    char text[80];
    for (int i = 0; i < 4; i++)
        for (int32_t precision = 64; precision >= 32; precision -= 32) {
            const double start[3] = {0.0, 1.5, 0.0}, speed[3] = {0.0, 0.75, 0.0};
            mus_drape *drape = NULL;
            mus_status status = point(v, 1.5, precision, 0.0, &drape);
            if (status == MUS_OK) status = mus_drape_set_state(drape, start, speed);
            if (status == MUS_OK) status = step_for(drape, 2.0, steps[i]);
            snprintf(text, sizeof text, "free node of a cloth, height after 2 s [m], h = %g s%s", steps[i],
                     precision == 32 ? ", float" : "");
            /* in float a sum of 2000 steps rounds 2000 times */
            const double tolerance = precision == 64 ? 1e-13 : steps[i] < 0.01 ? 1e-4 : 1e-5;
            const double got = drape ? mus_drape_positions(drape)[1] : NAN;
            row(v, status, "I2", text, 1.5 + 1.5 - 2.0 * GRAVITY, got, tolerance);
            mus_drape_destroy(drape);
        }
}


/* E_N / E_0 = (1 - z^6/72 + z^8/576)^N of a node on a spring to a pin, up to the bound of the drape */
static void node_on_a_spring(verify *v)
{
    static const double zs[] = {0.1, 0.5, 1.0, 0.0};
    static const int32_t counts[] = {1000, 1000, 100, 20};
    for (int i = 0; i < 4; i++) {
        char text[80];
        const double omega = 7.0, start[6] = {0, 0, 0, 1.03, 0, 0}, speed[6] = {0, 0, 0, -0.11, 0, 0};
        mus_drape *drape = NULL;
        mus_status status = chain(v, 64, 2, omega * omega, 0.0, false, &drape);
        const double z = zs[i] > 0.0 ? zs[i] : status == MUS_OK ? omega * mus_drape_step_bound(drape) : 0.0;
        if (status == MUS_OK) status = mus_drape_set_state(drape, start, speed);
        if (status == MUS_OK) status = mus_drape_step(drape, counts[i], z / omega);
        const double x = drape ? mus_drape_positions(drape)[3] - 1.0 : NAN;
        const double s = drape ? mus_drape_velocities(drape)[3] : NAN, x0 = start[3] - 1.0;
        const double got = (s * s + omega * omega * x * x) / (speed[3] * speed[3] + omega * omega * x0 * x0);
        snprintf(text, sizeof text, "node on a spring, energy left after %d steps of z = %.3g%s", (int)counts[i], z,
                 zs[i] > 0.0 ? "" : ", the bound");
        row(v, status, "I3", text, pow(1.0 - pow(z, 6.0) / 72.0 + pow(z, 8.0) / 576.0, counts[i]), got, 1e-11);
        mus_drape_destroy(drape);
    }
}


/* place after a second of a node let go level on a spring of k = 100 */
static mus_status swing(verify *v, int32_t steps, double *x)
{
    const double place[6] = {0, 0, 0, 1, 0, 0}, mass[2] = {1, 1}, length = 1.0, stiffness = 100.0;
    const int32_t spring[2] = {0, 1}, pin = 0;
    mus_bare bare;
    mus_bare_init(&bare, sizeof bare);
    bare.nodes = 2, bare.place = place, bare.mass = mass;
    bare.springs = 1, bare.spring = spring, bare.length = &length, bare.stiffness = &stiffness;
    bare.pins = 1, bare.pin = &pin;
    mus_cloth *cloth = NULL;
    mus_drape *drape = NULL;
    mus_status status = mus_cloth_create_bare(v->context, &bare, &cloth);
    if (status == MUS_OK) status = hang(v, cloth, 64, 1, GRAVITY, &drape);
    if (status == MUS_OK) status = mus_drape_step(drape, steps, 1.0 / steps);
    if (status == MUS_OK) memcpy(x, mus_drape_positions(drape) + 3, 3 * sizeof *x);
    mus_drape_destroy(drape);
    return status;
}


static void swing_order(verify *v)
{
    double x[4][3];
    mus_status status = MUS_OK;
    for (int i = 0; i < 4 && status == MUS_OK; i++) status = swing(v, 256 << i, x[i]);
    for (int i = 0; i < 2; i++) {
        char text[80];
        const double coarse = hypot(x[i][0] - x[i + 1][0], x[i][1] - x[i + 1][1]);
        const double fine = hypot(x[i + 1][0] - x[i + 2][0], x[i + 1][1] - x[i + 2][1]);
        snprintf(text, sizeof text, "node that swings on a spring, order of the drape, h = 1/%d s", 256 << i);
        row(v, status, "I6", text, 4.0, log2(coarse / fine), 0.025);
    }
}


/* ---- I8 ---- */

/* frequency of mode j of N masses between fixed ends, from the phase after one period of 800 steps */
static mus_status chain_mode(verify *v, int32_t precision, int32_t masses, int32_t j, double *exact, double *got)
{
    double x[3 * CHAIN] = {0}, q = 0.0, p = 0.0;
    mus_drape *drape = NULL;
    const double k = 40.0;
    *exact = 2.0 * sqrt(k) * sin(j * PI / (2.0 * (masses + 1)));
    mus_status status = chain(v, precision, masses + 2, k, 0.0, true, &drape);
    for (int32_t i = 0; i < masses + 2; i++) x[3 * i] = i + 0.1 * sin(i * j * PI / (masses + 1));
    if (status == MUS_OK) status = mus_drape_set_state(drape, x, NULL);
    if (status == MUS_OK) status = mus_drape_step(drape, 800, 2.0 * PI / (*exact * 800.0));
    for (int32_t i = 1; i <= masses && status == MUS_OK; i++) {
        const double shape = sin(i * j * PI / (masses + 1));
        q += shape * (mus_drape_positions(drape)[3 * i] - i);
        p += shape * mus_drape_velocities(drape)[3 * i];
    }
    *got = *exact * (1.0 + atan2(-p / *exact, q) / (2.0 * PI));
    mus_drape_destroy(drape);
    return status;
}


static void chains(verify *v)
{
    static const int32_t counts[] = {2, 5, 50};
    char text[80];
    for (int c = 0; c < 3; c++) {
        const int32_t n = counts[c], shown[2] = {1, n};
        double exact = 0.0, got = 0.0, worst = 0.0;
        for (int i = 0; i < 2; i++) {
            const mus_status status = chain_mode(v, 64, n, shown[i], &exact, &got);
            snprintf(text, sizeof text, "chain of %d masses, frequency %d [rad/s]", (int)n, (int)shown[i]);
            row(v, status, "I8", text, exact, got, 1e-9);
        }
        mus_status status = MUS_OK;
        for (int32_t j = 1; j <= n && status == MUS_OK; j++) {
            status = chain_mode(v, 64, n, j, &exact, &got);
            worst = fmax(worst, fabs(got / exact - 1.0));
        }
        snprintf(text, sizeof text, "chain of %d masses, worst relative error of all frequencies", (int)n);
        row(v, status, "I8", text, 0.0, worst, 1e-9);
    }
    for (int32_t j = 1; j <= 5; j += 4) {
        double exact = 0.0, got = 0.0;
        const mus_status status = chain_mode(v, 32, 5, j, &exact, &got);
        snprintf(text, sizeof text, "chain of 5 masses, frequency %d [rad/s], float", (int)j);
        row(v, status, "I8", text, exact, got, 1e-5);
    }
}


/* ---- I9, I10, I12 ---- */

/* a random number in -1 .. 1, the same in every run */
static double noise(uint64_t *state)
{
    *state = *state * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
    return (double)(*state >> 11) * 0x1p-52 - 1.0;
}


/* places of the grid disturbed by `part` of a cell, speeds up to 1 m/s; x and s (400 x 3) */
static void disturb(const mus_drape *drape, double cell, double *x, double *s)
{
    uint64_t state = 1;
    const double *now = mus_drape_positions(drape);
    for (int32_t i = 0; i < 3 * mus_drape_node_count(drape); i++) {
        x[i] = now[i] + 0.1 * cell * noise(&state);
        s[i] = noise(&state);
    }
}


typedef struct totals {
    double p[3], l[3], energy, size; /* size: sum of m |v| */
} totals;


static mus_status sum_up(const mus_drape *drape, totals *t)
{
    const double cell = 0.05, *x = mus_drape_positions(drape), *s = mus_drape_velocities(drape);
    mus_drape_report report;
    memset(t, 0, sizeof *t);
    for (int32_t i = 0; i < 400; i++, x += 3, s += 3) {
        /* half the mass on the border, a quarter at a corner */
        const int32_t r = i / 20, c = i % 20, border = (r == 0 || r == 19) + (c == 0 || c == 19);
        const double m = 0.15 * cell * cell / (1 << border);
        for (int d = 0; d < 3; d++) {
            const int e = (d + 1) % 3, f = (d + 2) % 3;
            t->p[d] += m * s[d];
            t->l[d] += m * (x[e] * s[f] - x[f] * s[e]);
        }
        t->size += m * sqrt(s[0] * s[0] + s[1] * s[1] + s[2] * s[2]);
    }
    mus_drape_report_init(&report, sizeof report);
    const mus_status status = mus_drape_report_get(drape, &report);
    t->energy = report.energy;
    return status;
}


/* drift of momentum, angular momentum and energy of a shaken free cloth over `seconds` in steps of bound / `finer` */
static mus_status shake(verify *v, int32_t precision, double seconds, double finer, double *drift)
{
    double x[1200], s[1200];
    mus_drape *drape = NULL;
    totals before = {0}, after = {0};
    mus_status status = grid(v, 20, 0.05, 0.0, precision, 1, 0.0, &drape);
    if (status == MUS_OK) {
        disturb(drape, 0.05, x, s);
        status = mus_drape_set_state(drape, x, s);
    }
    if (status == MUS_OK) status = sum_up(drape, &before);
    if (status == MUS_OK) status = step_for(drape, seconds, mus_drape_step_bound(drape) / finer);
    if (status == MUS_OK) status = sum_up(drape, &after);
    drift[0] = drift[1] = 0.0;
    for (int d = 0; d < 3; d++) {
        drift[0] = fmax(drift[0], fabs(after.p[d] - before.p[d]) / before.size);
        drift[1] += pow(after.l[d] - before.l[d], 2.0);
    }
    drift[1] = sqrt(drift[1]);
    drift[2] = fabs(after.energy - before.energy);
    mus_drape_destroy(drape);
    return status;
}


/* a drift that falls as h^4 or faster: the row tells by how much it falls short */
static void drift_order(verify *v, mus_status status, const char *what, double coarse, double fine)
{
    char text[80];
    const double order = log2(coarse / fine);
    snprintf(text, sizeof text, "free cloth, drift of %s ~ h^%.2f, short of 4 by", what, order);
    row(v, status, "I9", text, 0.0, fmax(0.0, 4.0 - order), 0.1);
}


static void momentum(verify *v)
{
    double coarse[3] = {0}, fine[3] = {0}, second[3] = {0};
    mus_status status = shake(v, 64, 1.0, 1.25, second);
    row(v, status, "I9", "free cloth shaken for 1 s, drift of momentum / sum m|v|", 0.0, second[0], 1e-13);
    if (status == MUS_OK) status = shake(v, 64, 0.1, 4.0, coarse);
    if (status == MUS_OK) status = shake(v, 64, 0.1, 8.0, fine);
    drift_order(v, status, "angular momentum", coarse[1], fine[1]);
    drift_order(v, status, "energy", coarse[2], fine[2]);
    status = shake(v, 32, 1.0, 1.25, second);
    row(v, status, "I9", "free cloth shaken for 1 s, drift of momentum / sum m|v|, float", 0.0, second[0], 1e-5);
}


/* largest strain of the threads of a 20 x 20 grid that falls, its plane turned about two axes */
static mus_status falling_strain(verify *v, double damping, int32_t precision, double seconds, double *strain,
                                 double *speed)
{
    double x[1200];
    mus_drape *drape = NULL;
    mus_status status = grid(v, 20, 0.05, damping, precision, 1, GRAVITY, &drape);
    const double ca = cos(0.7), sa = sin(0.7), cb = cos(1.9), sb = sin(1.9);
    for (int32_t i = 0; i < 400; i++) {
        const double a = 0.05 * (i % 20 - 9.5), b = 0.05 * (i / 20 - 9.5);
        x[3 * i] = ca * a - sa * b, x[3 * i + 1] = cb * (sa * a + ca * b) + 0.6, x[3 * i + 2] = sb * (sa * a + ca * b);
    }
    if (status == MUS_OK) status = mus_drape_set_state(drape, x, NULL);
    if (status == MUS_OK) status = step_for(drape, seconds, 0.9 * mus_drape_step_bound(drape));
    *strain = *speed = 0.0;
    for (int32_t i = 0; i < 400 && status == MUS_OK; i++) {
        const double *a = mus_drape_positions(drape) + 3 * i, *s = mus_drape_velocities(drape) + 3 * i;
        for (int32_t k = 1; k <= 20; k += 19) {
            if (k == 1 ? i % 20 == 19 : i >= 380) continue;
            const double *b = a + 3 * k;
            const double l2 = pow(b[0] - a[0], 2.0) + pow(b[1] - a[1], 2.0) + pow(b[2] - a[2], 2.0);
            *strain = fmax(*strain, fabs(sqrt(l2) / 0.05 - 1.0));
        }
        *speed = fmax(*speed, fabs(s[1] / (-GRAVITY * seconds) - 1.0));
    }
    mus_drape_destroy(drape);
    return status;
}


static void flat_fall(verify *v)
{
    double strain, speed;
    mus_status status = falling_strain(v, 0.0, 64, 1.0, &strain, &speed);
    row(v, status, "I10", "flat cloth in free fall for 1 s, largest strain", 0.0, strain, 1e-13);
    status = falling_strain(v, 0.0, 32, 0.5, &strain, &speed);
    row(v, status, "I10", "flat cloth in free fall for 0.5 s, largest strain, float", 0.0, strain, 1e-5);
}


static mus_status hash_of_a_run(verify *v, int32_t precision, int32_t threads, uint64_t *hash)
{
    mus_drape *drape = NULL;
    mus_status status = grid(v, 50, 0.01, 0.1, precision, threads, GRAVITY, &drape);
    if (status == MUS_OK) status = mus_drape_pin(drape, 0, 1);
    if (status == MUS_OK) status = mus_drape_step(drape, 200, 0.9 * mus_drape_step_bound(drape));
    *hash = drape != NULL ? mus_drape_hash(drape) : 0;
    mus_drape_destroy(drape);
    return status;
}


static void same_bits(verify *v)
{
    static const int32_t threads[] = {1, 2, 4};
    for (int32_t precision = 64; precision >= 32; precision -= 32) {
        uint64_t first = 0, hash = 0;
        mus_status status = hash_of_a_run(v, precision, 1, &first);
        for (int i = 0; i < 3 && status == MUS_OK; i++) {
            char text[80];
            status = hash_of_a_run(v, precision, threads[i], &hash);
            snprintf(text, sizeof text, "hanging cloth, second run, %d threads, %d bit: 0 when equal", (int)threads[i],
                     (int)precision);
            row(v, status, "I12", text, 0.0, hash == first ? 0.0 : 1.0, 0.0);
        }
        if (status != MUS_OK) verify_broken(v, "I12", "hanging cloth", status);
    }
}


/* ---- D1, D2, D3 ---- */

/* v = g / c (1 - exp(-c t)) */
static void drag(verify *v)
{
    const double exact = -GRAVITY * (1.0 - exp(-5.0));
    double error[3] = {0};
    mus_status status = MUS_OK;
    for (int i = 0; i < 3 && status == MUS_OK; i++) {
        char text[80];
        mus_drape *drape = NULL;
        const double h = 0.1 / (1 << i);
        status = point(v, 0.0, 64, 1.0, &drape);
        if (status == MUS_OK) status = step_for(drape, 5.0, h);
        const double got = drape ? mus_drape_velocities(drape)[1] : NAN;
        error[i] = fabs(got - exact);
        snprintf(text, sizeof text, "fall with drag of 1 /s, speed after 5 s [m/s], h = %g s", h);
        row(v, status, "D1", text, exact, got, 1e-7);
        mus_drape_destroy(drape);
    }
    row(v, status, "D1", "fall with drag, order", 4.0, log2(error[1] / error[2]), 0.025);
    mus_drape *drape = NULL;
    if (status == MUS_OK) status = point(v, 0.0, 32, 1.0, &drape);
    if (status == MUS_OK) status = step_for(drape, 5.0, 0.05);
    const double got = drape ? mus_drape_velocities(drape)[1] : NAN;
    row(v, status, "D1", "fall with drag of 1 /s, speed after 5 s [m/s], float", exact, got, 1e-5);
    mus_drape_destroy(drape);
}


/* log decrement 2 pi zeta / sqrt(1 - zeta^2) of a node on a spring and dashpot, from one period in steps of z = 0.05 */
static void decrement(verify *v, int32_t precision)
{
    static const double zetas[] = {0.01, 0.1, 0.5};
    for (int i = 0; i < 3; i++) {
        char text[80];
        const double omega = 5.0, zeta = zetas[i], damped = omega * sqrt(1.0 - zeta * zeta), decay = zeta * omega;
        const double period = 2.0 * PI / damped, start[6] = {0, 0, 0, 1.1, 0, 0};
        mus_drape *drape = NULL;
        double amplitude[2] = {0};
        mus_status status = chain(v, precision, 2, omega * omega, 2.0 * zeta * omega, false, &drape);
        if (status == MUS_OK) status = mus_drape_set_state(drape, start, NULL);
        for (int k = 0; k < 2 && status == MUS_OK; k++) {
            /* x = A exp(-zeta omega t) cos(damped t + phase) */
            const double x = mus_drape_positions(drape)[3] - 1.0, s = mus_drape_velocities(drape)[3];
            amplitude[k] = hypot(x, (s + decay * x) / damped);
            if (k == 0) status = step_for(drape, period, 0.05 / omega);
        }
        snprintf(text, sizeof text, "spring and dashpot, log decrement, zeta = %g%s", zeta,
                 precision == 32 ? ", float" : "");
        row(v, status, "D2", text, 2.0 * PI * zeta / sqrt(1.0 - zeta * zeta), log(amplitude[0] / amplitude[1]),
            precision == 64 ? 1e-6 : 1e-5);
        mus_drape_destroy(drape);
    }
}


/* a ring of twelve nodes with dashpots that turns once: its radius and speed */
static mus_status spin(verify *v, double *radius, double *speed)
{
    enum { N = 12 };
    double place[3 * N] = {0}, velocity[3 * N] = {0}, mass[N], length[N], stiffness[N], dashpot[N];
    int32_t spring[2 * N];
    const double turn = 2.0 * PI, k = 1e4, side = 2.0 * sin(PI / N);
    for (int32_t i = 0; i < N; i++) {
        /* in balance: k (side - length) 2 sin(pi/N) = m turn^2 R, R = 1 */
        const double a = 2.0 * PI * i / N;
        place[3 * i] = cos(a), place[3 * i + 1] = sin(a);
        velocity[3 * i] = -turn * sin(a), velocity[3 * i + 1] = turn * cos(a);
        mass[i] = 0.1, stiffness[i] = k, length[i] = side - 0.1 * turn * turn / (k * 2.0 * sin(PI / N));
        dashpot[i] = 2.0 * sqrt(0.5 * k * 0.1);
        spring[2 * i] = i, spring[2 * i + 1] = (i + 1) % N;
    }
    mus_bare bare;
    mus_bare_init(&bare, sizeof bare);
    bare.nodes = bare.springs = N, bare.place = place, bare.mass = mass, bare.spring = spring, bare.length = length;
    bare.stiffness = stiffness, bare.dashpot = dashpot;
    mus_cloth *cloth = NULL;
    mus_drape *drape = NULL;
    mus_status status = mus_cloth_create_bare(v->context, &bare, &cloth);
    if (status == MUS_OK) status = hang(v, cloth, 64, 1, 0.0, &drape);
    if (status == MUS_OK) status = mus_drape_set_state(drape, place, velocity);
    if (status == MUS_OK) status = step_for(drape, 1.0, 2.5e-5);
    *radius = *speed = 0.0;
    for (int32_t i = 0; i < N && status == MUS_OK; i++) {
        const double *x = mus_drape_positions(drape) + 3 * i, *s = mus_drape_velocities(drape) + 3 * i;
        *radius = fmax(*radius, fabs(hypot(x[0], x[1]) - 1.0));
        *speed = fmax(*speed, fabs(hypot(s[0], s[1]) / turn - 1.0));
    }
    mus_drape_destroy(drape);
    return status;
}


static void galilean(verify *v)
{
    double strain = 0.0, speed = 0.0;
    mus_status status = falling_strain(v, 1.0, 64, 1.0, &strain, &speed);
    row(v, status, "D3", "fall of a cloth with dashpots, zeta = 1: largest strain", 0.0, strain, 1e-13);
    row(v, status, "D3", "fall of a cloth with dashpots, zeta = 1: speed, relative", 0.0, speed, 1e-12);
    status = falling_strain(v, 1.0, 32, 0.5, &strain, &speed);
    row(v, status, "D3", "fall of a cloth with dashpots, zeta = 1: largest strain, float", 0.0, strain, 1e-5);
    status = spin(v, &strain, &speed);
    row(v, status, "D3", "ring with dashpots after one turn: change of radius, relative", 0.0, strain, 1e-13);
    row(v, status, "D3", "ring with dashpots after one turn: change of speed, relative", 0.0, speed, 1e-13);
}


int verify_motion(verify *v)
{
    if (verify_wants(v, "I2")) node_falls(v);
    if (verify_wants(v, "I3")) node_on_a_spring(v);
    if (verify_wants(v, "I6")) swing_order(v);
    if (verify_wants(v, "I8")) chains(v);
    if (verify_wants(v, "I9")) momentum(v);
    if (verify_wants(v, "I10")) flat_fall(v);
    if (verify_wants(v, "I12")) same_bits(v);
    if (verify_wants(v, "D1")) drag(v);
    if (verify_wants(v, "D2")) decrement(v, 64), decrement(v, 32);
    if (verify_wants(v, "D3")) galilean(v);
    return EXIT_DONE;
}
