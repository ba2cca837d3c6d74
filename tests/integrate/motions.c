/* motions.c: the rate functions of motions.h. */
#include "integrate/motions.h"

#include <math.h>
#include <stdlib.h>

#include "support.h"


void motion_spring_rate(void *user, double t, const double *y, double *dy)
{
    motion_spring *s = user;
    (void)t;
    dy[0] = y[1];
    dy[1] = -s->omega * s->omega * y[0] - 2.0 * s->zeta * s->omega * y[1];
    s->evaluations++;
}


void motion_spring_rate32(void *user, double t, const float *y, float *dy)
{
    motion_spring *s = user;
    const float omega = (float)s->omega, zeta = (float)s->zeta;
    (void)t;
    dy[0] = y[1];
    dy[1] = -omega * omega * y[0] - 2.0f * zeta * omega * y[1];
    s->evaluations++;
}


double motion_spring_energy(void *user, double t, const double *y)
{
    const motion_spring *s = user;
    (void)t;
    return 0.5 * (y[1] * y[1] + s->omega * s->omega * y[0] * y[0]);
}


double motion_spring_energy32(void *user, double t, const float *y)
{
    const double state[2] = {(double)y[0], (double)y[1]};
    return motion_spring_energy(user, t, state);
}


void motion_pendulum_rate(void *user, double t, const double *y, double *dy)
{
    const motion_pendulum *p = user;
    const double l = sqrt(y[0] * y[0] + y[1] * y[1]), pull = -p->k * (l - 1.0) / l;
    (void)t;
    dy[0] = y[2];
    dy[1] = y[3];
    dy[2] = pull * y[0];
    dy[3] = pull * y[1] - GRAVITY;
}


double motion_pendulum_energy(void *user, double t, const double *y)
{
    const motion_pendulum *p = user;
    const double stretch = sqrt(y[0] * y[0] + y[1] * y[1]) - 1.0;
    (void)t;
    return 0.5 * (y[2] * y[2] + y[3] * y[3]) + 0.5 * p->k * stretch * stretch + GRAVITY * (y[1] + 1.0);
}


void motion_fall_rate(void *user, double t, const double *y, double *dy)
{
    (void)user;
    (void)t;
    dy[0] = y[1];
    dy[1] = -GRAVITY;
}


void motion_run(const mus_integrate_def *def, int64_t n, double *y, int64_t steps)
{
    mus_context *context = support_context();
    double *work = malloc((size_t)mus_integrate_work(def->method, n) * sizeof *work);
    int64_t done = -1;
    ck_assert_ptr_nonnull(work);
    const mus_status status = mus_integrate(context, def, n, y, steps, work, &done);
    ck_assert_msg(status == MUS_OK, "%s", mus_context_error(context));
    ck_assert_int_eq(done, steps);
    ck_assert_uint_eq(mus_context_allocations(context), 0);
    free(work);
    support_context_end(context);
}


mus_integrate_def motion_def(int32_t method, double step, mus_rate_fn rate, void *user)
{
    mus_integrate_def def;
    mus_integrate_def_init(&def, sizeof def);
    def.method = method;
    def.step = step;
    def.rate = rate;
    def.user = user;
    return def;
}
