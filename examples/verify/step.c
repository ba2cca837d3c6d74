/*
 * step.c: the integrators alone, on motions with exact answers (cases I1-I7).
 *
 * Everything runs through mus_integrate(); a float row through mus_integrate_f32().
 */
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "command/args.h"
#include "verify.h"

#define PI 3.14159265358979323846
#define GRAVITY 9.81
#define MAX_STATE 8


/* a def with its rate */
static mus_integrate_def motion(int32_t method, double step, mus_rate_fn rate, void *user)
{
    mus_integrate_def def;
    mus_integrate_def_init(&def, sizeof def);
    def.method = method;
    def.step = step;
    def.rate = rate;
    def.user = user;
    return def;
}


static mus_status run(verify *v, const mus_integrate_def *def, int64_t n, double *y, int64_t steps)
{
    double work[4 * MAX_STATE];
    return mus_integrate(v->context, def, n, y, steps, work, NULL);
}


/* ---- I1: the conditions of order four, as what one step of h = 1 makes of powers of time ---- */

static void powers(void *user, double t, const double *y, double *dy)
{
    (void)user;
    dy[0] = 1.0;
    dy[1] = t;
    dy[2] = t * t;
    dy[3] = t * t * t;
    dy[4] = y[1];
    dy[5] = t * y[1];
    dy[6] = y[2];
    dy[7] = y[4];
}


static void order_conditions(verify *v)
{
    static const char *const names[8] = {"sum b",       "sum b c",     "sum b c^2",   "sum b c^3",
                                         "sum b a c",   "sum b c a c", "sum b a c^2", "sum b a a c"};
    static const double inverse[8] = {1, 2, 3, 4, 6, 8, 12, 24};
    double y[8] = {0};
    const mus_integrate_def def = motion(MUS_METHOD_RK4, 1.0, powers, NULL);
    const mus_status status = run(v, &def, 8, y, 1);
    if (status != MUS_OK) verify_broken(v, "I1", "order conditions", status);
    for (int i = 0; i < 8 && status == MUS_OK; i++) {
        char text[64];
        snprintf(text, sizeof text, "condition of order 4: %s", names[i]);
        verify_add(v, "I1", text, 1.0 / inverse[i], y[i], 2.0 * DBL_EPSILON);
    }
}


/* ---- I2: free fall ---- */

static void fall(void *user, double t, const double *y, double *dy)
{
    (void)user;
    (void)t;
    dy[0] = y[1];
    dy[1] = -GRAVITY;
}


static void fall32(void *user, double t, const float *y, float *dy)
{
    (void)user;
    (void)t;
    dy[0] = y[1];
    dy[1] = (float)-GRAVITY;
}


/* x = x0 + v0 t - g t^2 / 2 for two seconds, at any step */
static void free_fall(verify *v)
{
    static const double steps[] = {1e-3, 0.01, 0.1, 1.0};
    const double exact = 1.5 + 0.75 * 2.0 - 0.5 * GRAVITY * 4.0;
    char text[64];
    for (int i = 0; i < 4; i++) {
        double y[2] = {1.5, 0.75};
        const mus_integrate_def def = motion(MUS_METHOD_RK4, steps[i], fall, NULL);
        const mus_status status = run(v, &def, 2, y, lround(2.0 / steps[i]));
        snprintf(text, sizeof text, "free fall, place after 2 s [m], h = %g s", steps[i]);
        if (status != MUS_OK) verify_broken(v, "I2", text, status);
        if (status == MUS_OK) verify_add(v, "I2", text, exact, y[0], 1e-13);
    }
    for (int i = 1; i < 4; i++) {
        float y[2] = {1.5f, 0.75f}, work[8];
        mus_integrate_def def = motion(MUS_METHOD_RK4, steps[i], NULL, NULL);
        def.rate32 = fall32;
        const mus_status status = mus_integrate_f32(v->context, &def, 2, y, lround(2.0 / steps[i]), work, NULL);
        snprintf(text, sizeof text, "free fall, place after 2 s [m], h = %g s, float", steps[i]);
        if (status != MUS_OK) verify_broken(v, "I2", text, status);
        if (status == MUS_OK) verify_add(v, "I2", text, exact, (double)y[0], 1e-5);
    }
}


/* ---- I3, I4, I5: one spring ---- */

typedef struct spring {
    double omega, zeta;
} spring;


static void spring_rate(void *user, double t, const double *y, double *dy)
{
    const spring *s = user;
    (void)t;
    dy[0] = y[1];
    dy[1] = -s->omega * s->omega * y[0] - 2.0 * s->zeta * s->omega * y[1];
}


static void spring_rate32(void *user, double t, const float *y, float *dy)
{
    const float omega = (float)((const spring *)user)->omega;
    (void)t;
    dy[0] = y[1];
    dy[1] = -omega * omega * y[0];
}


static double spring_energy(const spring *s, double x, double speed)
{
    return speed * speed + s->omega * s->omega * x * x;
}


/* E_N / E_0 = (1 - z^6/72 + z^8/576)^N: a row for z */
static void spring_decay(verify *v, const char *id, double z, double tolerance)
{
    char text[64];
    spring s = {.omega = 7.0};
    double y[2] = {0.3, -1.1};
    const double start = spring_energy(&s, y[0], y[1]);
    const double exact = pow(1.0 - pow(z, 6.0) / 72.0 + pow(z, 8.0) / 576.0, 1000.0);
    const mus_integrate_def def = motion(MUS_METHOD_RK4, z / s.omega, spring_rate, &s);
    const mus_status status = run(v, &def, 2, y, 1000);
    snprintf(text, sizeof text, "spring, energy left after 1000 steps of z = %g", z);
    if (status != MUS_OK) verify_broken(v, id, text, status);
    if (status == MUS_OK) verify_add(v, id, text, exact, spring_energy(&s, y[0], y[1]) / start, tolerance);
}


static void spring_decay32(verify *v, double z)
{
    char text[64];
    spring s = {.omega = 7.0};
    float y[2] = {0.3f, -1.1f}, work[8];
    const double start = spring_energy(&s, (double)y[0], (double)y[1]);
    const double exact = pow(1.0 - pow(z, 6.0) / 72.0 + pow(z, 8.0) / 576.0, 100.0);
    mus_integrate_def def = motion(MUS_METHOD_RK4, z / s.omega, NULL, &s);
    def.rate32 = spring_rate32;
    const mus_status status = mus_integrate_f32(v->context, &def, 2, y, 100, work, NULL);
    snprintf(text, sizeof text, "spring, energy left after 100 steps of z = %g, float", z);
    if (status != MUS_OK) verify_broken(v, "I3", text, status);
    if (status == MUS_OK)
        verify_add(v, "I3", text, exact, spring_energy(&s, (double)y[0], (double)y[1]) / start, 1e-5);
}


/* the phase lags by z^4/120 of each radian: from 1000 steps of z = 0.1 */
static void spring_phase(verify *v)
{
    spring s = {.omega = 1.0};
    const double z = 0.1, steps = 1000.0;
    double y[2] = {1.0, 0.0};
    const mus_integrate_def def = motion(MUS_METHOD_RK4, z, spring_rate, &s);
    const mus_status status = run(v, &def, 2, y, (int64_t)steps);
    if (status != MUS_OK) {
        verify_broken(v, "I3", "spring, phase", status);
        return;
    }
    /* angle of (x, -v) from where it should be */
    const double lag = remainder(z * steps - atan2(-y[1], y[0]), 2.0 * PI);
    verify_add(v, "I3", "spring, phase lag a radian of z = 0.1", pow(z, 4.0) / 120.0, lag / (z * steps), 0.01);
}


/* does the energy grow in 4000 steps? */
static bool grows(verify *v, double z, double zeta, mus_status *status)
{
    spring s = {1.0, zeta};
    double y[2] = {1.0, 0.7};
    const double start = spring_energy(&s, y[0], y[1]);
    const mus_integrate_def def = motion(MUS_METHOD_RK4, z, spring_rate, &s);
    const mus_status now = run(v, &def, 2, y, 4000);
    if (now != MUS_OK && now != MUS_ERR_DIVERGED) *status = now;
    return now != MUS_OK || spring_energy(&s, y[0], y[1]) > start;
}


/* the largest stable z of a damped spring, by halving; the least, 2.62 at zeta = 0.5, is that of a drape's bound */
static void spring_limit(verify *v)
{
    static const double zeta[] = {0, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.8, 1, 1.5, 2, 3, 5, 10};
    static const double known[] = {2.8284271, 2.910, 2.951, 2.940, 2.835, 2.701, 2.623, 2.629, 2.792, 2.785};
    for (size_t i = 0; i < sizeof zeta / sizeof zeta[0]; i++) {
        char text[64];
        mus_status status = MUS_OK;
        double low = 0.05, high = 4.0;
        while (high - low > 1e-5 && status == MUS_OK) {
            const double middle = 0.5 * (low + high);
            if (grows(v, middle, zeta[i], &status)) high = middle;
            else low = middle;
        }
        /* above zeta = 1 the faster of two decays alone counts: -2.78529 is the end of the real axis */
        const double exact = i < 10 ? known[i] : 2.78529 / (zeta[i] + sqrt(zeta[i] * zeta[i] - 1.0));
        snprintf(text, sizeof text, "spring and dashpot, largest stable z, zeta = %g", zeta[i]);
        if (status != MUS_OK) verify_broken(v, "I5", text, status);
        if (status == MUS_OK) verify_add(v, "I5", text, exact, low, 1e-3);
    }
}


/* ---- I6, I7: a mass on a spring that swings ---- */

typedef struct pendulum {
    double k; /* m = 1, l = 1 */
} pendulum;


static void pendulum_rate(void *user, double t, const double *y, double *dy)
{
    const double l = sqrt(y[0] * y[0] + y[1] * y[1]), pull = -((const pendulum *)user)->k * (l - 1.0) / l;
    (void)t;
    dy[0] = y[2];
    dy[1] = y[3];
    dy[2] = pull * y[0];
    dy[3] = pull * y[1] - GRAVITY;
}


/* distance of the places after one second with steps 1/n and 1/2n */
static mus_status pendulum_difference(verify *v, int32_t method, int64_t n, double *out)
{
    pendulum p = {.k = 100.0};
    double coarse[4] = {1, 0, 0, 0}, fine[4] = {1, 0, 0, 0};
    mus_integrate_def def = motion(method, 1.0 / (double)n, pendulum_rate, &p);
    mus_status status = run(v, &def, 4, coarse, n);
    def.step *= 0.5;
    if (status == MUS_OK) status = run(v, &def, 4, fine, 2 * n);
    *out = hypot(coarse[0] - fine[0], coarse[1] - fine[1]);
    return status;
}


static void pendulum_orders(verify *v)
{
    static const struct {
        const char *name;
        int32_t method;
        double order;
    } methods[] = {
        {"Runge-Kutta", MUS_METHOD_RK4, 4}, {"Verlet", MUS_METHOD_VERLET, 2}, {"Euler", MUS_METHOD_EULER, 1}};
    for (int m = 0; m < 3; m++)
        for (int64_t n = 256; n <= 512; n *= 2) {
            char text[80];
            double coarse = 0.0, fine = 0.0;
            mus_status status = pendulum_difference(v, methods[m].method, n, &coarse);
            if (status == MUS_OK) status = pendulum_difference(v, methods[m].method, 2 * n, &fine);
            snprintf(text, sizeof text, "spring pendulum, order of %s, h = 1/%d s", methods[m].name, (int)n);
            if (status != MUS_OK) verify_broken(v, "I6", text, status);
            if (status == MUS_OK) verify_add(v, "I6", text, methods[m].order, log2(coarse / fine), 0.025);
        }
}


/* time from rest at `angle` to the lowest point of a pendulum with m g / (k l) = softness. The last step is cut where
 * x passes 0 */
static mus_status quarter_period(verify *v, double angle, double softness, double *out)
{
    pendulum p = {.k = GRAVITY / softness};
    const double l = 1.0 + softness * cos(angle), h = 0.5 / sqrt(p.k);
    double y[4] = {l * sin(angle), -l * cos(angle), 0.0, 0.0}, before[4];
    mus_integrate_def def = motion(MUS_METHOD_RK4, h, pendulum_rate, &p);
    mus_status status = MUS_OK;
    int64_t steps = 0;
    for (memcpy(before, y, sizeof y); y[0] > 0.0 && status == MUS_OK; steps++) {
        memcpy(before, y, sizeof y);
        status = run(v, &def, 4, y, 1);
    }
    /* Newton on the length of the last step: x' is the velocity there */
    double part = h;
    for (int i = 0; i < 8 && status == MUS_OK; i++) {
        part -= y[0] / y[2];
        def.step = part;
        memcpy(y, before, sizeof y);
        status = run(v, &def, 4, y, 1);
    }
    *out = (double)(steps - 1) * h + part;
    return status;
}


/* T / T0 = 2 K(sin(angle/2)) / pi = 1 / agm(1, cos(angle/2)) */
static double period_ratio(double angle)
{
    double a = 1.0, b = cos(0.5 * angle);
    for (int i = 0; i < 8; i++) {
        const double mean = 0.5 * (a + b);
        b = sqrt(a * b);
        a = mean;
    }
    return 1.0 / a;
}


/* the error falls as m g / (k l); carried on to a rod it is gone */
static void pendulum_period(verify *v)
{
    static const double degrees[] = {30, 60, 90, 120};
    const double t0 = 0.5 * PI / sqrt(GRAVITY);
    for (int i = 0; i < 4; i++) {
        char text[80];
        const double angle = degrees[i] * PI / 180.0, exact = period_ratio(angle);
        double quarter[5] = {0};
        mus_status status = MUS_OK;
        for (int s = 0; s < 5 && status == MUS_OK; s++) status = quarter_period(v, angle, pow(10, -2 - s), &quarter[s]);
        if (status != MUS_OK) {
            verify_broken(v, "I7", "pendulum on a stiff spring", status);
            return;
        }
        snprintf(text, sizeof text, "pendulum from %g deg, T/T0 carried on to a rigid rod", degrees[i]);
        verify_add(v, "I7", text, exact, (10.0 * quarter[4] - quarter[3]) / (9.0 * t0), 1e-9);
        snprintf(text, sizeof text, "pendulum from %g deg, order of the error in m g/(k l)", degrees[i]);
        verify_add(v, "I7", text, 1.0, log10((quarter[2] / t0 - exact) / (quarter[3] / t0 - exact)), 0.01);
    }
}


int verify_step(verify *v)
{
    static const double decay[] = {0.1, 0.5, 1.0, 2.0, 2.82}, limit[] = {2.82, 2.8284, 2.83};
    if (verify_wants(v, "I1")) order_conditions(v);
    if (verify_wants(v, "I2")) free_fall(v);
    if (verify_wants(v, "I3")) {
        for (int i = 0; i < 5; i++) spring_decay(v, "I3", decay[i], 1e-11);
        for (int i = 0; i < 3; i++) spring_decay32(v, decay[i]);
        spring_phase(v);
    }
    for (int i = 0; i < 3 && verify_wants(v, "I4"); i++) spring_decay(v, "I4", limit[i], 1e-11);
    if (verify_wants(v, "I5")) spring_limit(v);
    if (verify_wants(v, "I6")) pendulum_orders(v);
    if (verify_wants(v, "I7")) pendulum_period(v);
    return EXIT_DONE;
}
