/*
 * integrate.c: fixed-step integrators on a flat state: classical Runge-Kutta, velocity Verlet, symplectic Euler.
 *
 * Called with states of a few to some million numbers; all the time of a run is the caller's rate function and the
 * plain loops of integrate_kernel.h, which is compiled here for double and for float. A run is cut in blocks of
 * guard_every steps; after each the state is looked at (finite, energy) and kept, so that a run that blows up ends with
 * the last good one. Time of step k is start + k h: a running sum of 1 ms in float stops at 32768 s.
 *
 * No implicit method stands here, by measurement (sheets of 32 x 32 and 64 x 64 nodes, threads of 1000 to 20000 N/m,
 * held along an edge or stretched all round, against Runge-Kutta in double, right to 1e-6 mm; CPU seconds of a float
 * drape by Verlet / of linearly implicit Euler with PCG in double):
 *
 *   32 x 32, 20000 N/m, damping 0.1 of critical: 0.006 mm in 0.04 s  /  1.1 mm in 0.18 s, 17 mm in 0.06 s
 *   the same, damping 1, the most that a fabric may have:  0.2 mm in 0.19 s  /  1.1 mm in 0.19 s, 18 mm in 0.06 s
 *   64 x 64, 20000 N/m, damping 1:               0.2 mm in 0.51 s  /  0.4 mm in 0.56 s, 3.5 mm in 0.16 s
 *   32 x 32, 1000 N/m, stretched, damping 1:     below 0.03 mm in 0.08 s  /  12 mm in 0.11 s
 *
 * It is cheaper only where errors of several millimetres are allowed on the stiffest and most damped sheets. A linearly
 * implicit step of order 2 (ROS2) was dearer in all of these and blew up at long steps. With dashpots ten times as
 * strong as a fabric may have there is a place for one (0.3 mm in 0.2 s against 0.45 s), also for dashpots alone taken
 * implicitly (0.2 mm in 0.19 s).
 *
 * Source: Metaaphanon and Kanongchaiyos 2005, eq. 5; Hairer, Norsett, Wanner, Solving ODEs I, 1993, II.1; Hairer,
 * Lubich, Wanner, Geometric Numerical Integration, 2006, I.1.
 */
#include <float.h>
#include <math.h>
#include <stddef.h>
#include <string.h>

#include "base/base_internal.h"
#include "muslin/integrate.h"

#define INTEGRATE_NUMBERS (INT64_C(1) << 40)
#define INTEGRATE_STEPS (INT64_C(1) << 53) /* above it a step number is no double */
#define INTEGRATE_GUARD 1000000


/* time of step k, which may be a half one */
static double integrate_time(const mus_integrate_def *def, double k)
{
    return def->start + k * def->step;
}


#define MUS_REAL double
#define MUS_RATE mus_rate_fn
#define MUS_ENERGY mus_energy_fn
#define MUS_FN(name) integrate_f64_##name
#include "integrate/integrate_kernel.h"
#undef MUS_REAL
#undef MUS_RATE
#undef MUS_ENERGY
#undef MUS_FN


#define MUS_REAL float
#define MUS_RATE mus_rate32_fn
#define MUS_ENERGY mus_energy32_fn
#define MUS_FN(name) integrate_f32_##name
#include "integrate/integrate_kernel.h"
#undef MUS_REAL
#undef MUS_RATE
#undef MUS_ENERGY
#undef MUS_FN


void mus_integrate_def_init(mus_integrate_def *def, size_t size)
{
    mus_integrate_def own = {0};
    own.guard_every = 32;
    own.energy_growth = 1.5;
    mus__def_init(def, size, &own, sizeof own);
}


int64_t mus_integrate_work(int32_t method, int64_t n)
{
    if (n < 0 || n > INTEGRATE_NUMBERS) return 0;
    if (method == MUS_METHOD_RK4) return 4 * n;
    return method == MUS_METHOD_VERLET || method == MUS_METHOD_EULER ? 2 * n : 0;
}


/* the numbers of a def; `least`: the smallest normal number of the precision */
static mus_status integrate_check_def(mus_context *context, const mus_integrate_def *def, double least, double most)
{
    if (def->method < MUS_METHOD_RK4 || def->method > MUS_METHOD_EULER)
        return mus__fail(context, MUS_ERR_ARG, "integrate: method is %d, expected 0 to 2", (int)def->method);
    if (def->guard_every < 1 || def->guard_every > INTEGRATE_GUARD)
        return mus__fail(context, MUS_ERR_ARG, "integrate: guard_every is %d, expected 1 to %d", (int)def->guard_every,
                         INTEGRATE_GUARD);
    if (!mus__finite(def->start))
        return mus__fail(context, MUS_ERR_ARG, "integrate: start is %g, expected a finite time", def->start);
    if (!(def->step == 0.0 || (def->step >= least && def->step <= most)))
        return mus__fail(context, MUS_ERR_ARG, "integrate: step is %g, expected 0 or %g to %g", def->step, least, most);
    if (!(def->energy_growth >= 1.0 && mus__finite(def->energy_growth)))
        return mus__fail(context, MUS_ERR_ARG, "integrate: energy_growth is %g, expected at least 1",
                         def->energy_growth);
    if (!(def->energy_floor >= 0.0 && mus__finite(def->energy_floor)))
        return mus__fail(context, MUS_ERR_ARG, "integrate: energy_floor is %g, expected at least 0", def->energy_floor);
    return MUS_OK;
}


/* the def as of this release in `own`, and the sizes of the run */
static mus_status integrate_check(mus_context *context, const mus_integrate_def *def, mus_integrate_def *own,
                                  int64_t n, int64_t steps, bool single)
{
    mus_integrate_def_init(own, sizeof *own);
    mus_status status = mus__def_read(context, own, sizeof *own, sizeof *own, def, "mus_integrate_def");
    if (status == MUS_OK)
        status = integrate_check_def(context, own, single ? (double)FLT_MIN : DBL_MIN,
                                     single ? (double)FLT_MAX : DBL_MAX);
    if (status != MUS_OK) return status;
    if (single ? own->rate32 == NULL : own->rate == NULL)
        return mus__fail(context, MUS_ERR_ARG, "integrate: %s is NULL", single ? "rate32" : "rate");
    if (n < 0 || (n % 2 != 0 && own->method != MUS_METHOD_RK4))
        return mus__fail(context, MUS_ERR_ARG, "integrate: n is %lld, expected %s", (long long)n,
                         n < 0 ? "at least 0" : "an even number: places, then velocities");
    if (n > INTEGRATE_NUMBERS)
        return mus__fail(context, MUS_ERR_LIMIT, "integrate: n is %lld, at most %lld", (long long)n,
                         (long long)INTEGRATE_NUMBERS);
    if (steps < 0) return mus__fail(context, MUS_ERR_ARG, "integrate: steps is %lld", (long long)steps);
    if (steps > INTEGRATE_STEPS)
        return mus__fail(context, MUS_ERR_LIMIT, "integrate: steps is %lld, times are exact up to %lld",
                         (long long)steps, (long long)INTEGRATE_STEPS);
    return MUS_OK;
}


mus_status mus_integrate(mus_context *context, const mus_integrate_def *def, int64_t n, double *y, int64_t steps,
                         double *work, int64_t *done)
{
    mus_integrate_def own;
    int64_t unused, *reached = done != NULL ? done : &unused;
    *reached = 0;
    if (context == NULL) return MUS_ERR_ARG;
    if (def == NULL || (n != 0 && (y == NULL || work == NULL)))
        return mus__fail(context, MUS_ERR_ARG, "mus_integrate: %s is NULL", !def ? "def" : !y ? "y" : "work");
    mus_status status = integrate_check(context, def, &own, n, steps, false);
    if (status != MUS_OK) return status;
    if (n > 0 && steps > 0 && own.step > 0.0)
        return integrate_f64_run(context, &own, own.rate, own.energy, n, y, steps, work, reached);
    *reached = steps;
    return MUS_OK;
}


mus_status mus_integrate_f32(mus_context *context, const mus_integrate_def *def, int64_t n, float *y, int64_t steps,
                             float *work, int64_t *done)
{
    mus_integrate_def own;
    int64_t unused, *reached = done != NULL ? done : &unused;
    *reached = 0;
    if (context == NULL) return MUS_ERR_ARG;
    if (def == NULL || (n != 0 && (y == NULL || work == NULL)))
        return mus__fail(context, MUS_ERR_ARG, "mus_integrate_f32: %s is NULL", !def ? "def" : !y ? "y" : "work");
    mus_status status = integrate_check(context, def, &own, n, steps, true);
    if (status != MUS_OK) return status;
    if (n > 0 && steps > 0 && own.step > 0.0)
        return integrate_f32_run(context, &own, own.rate32, own.energy32, n, y, steps, work, reached);
    *reached = steps;
    return MUS_OK;
}
