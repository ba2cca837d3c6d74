/*
 * muslin/integrate.h: fixed-step integrators on one flat state, with the caller's own rate function.
 *
 * They know nothing of cloth and have no step bound of their own: the bound belongs to what is integrated
 * (mus_drape_step_bound for cloth). What they do look after is time, which is start + k step and never a running sum,
 * and the end of a run that blows up: the last good state comes back instead of numbers that mean nothing.
 *
 *   y' = f(t, y)                    MUS_METHOD_RK4: any y
 *   y = [x | v], x' = v, v' = a     MUS_METHOD_VERLET, MUS_METHOD_EULER: n even, places first, then velocities
 */
#ifndef MUSLIN_INTEGRATE_H
#define MUSLIN_INTEGRATE_H

#include "muslin/base.h"

#ifdef __cplusplus
extern "C" {
#endif

#define MUS_METHOD_RK4 0    /* classical Runge-Kutta, order 4, 4 evaluations a step; stable for omega h < 2.828 */
#define MUS_METHOD_VERLET 1 /* velocity Verlet, order 2, 1 evaluation a step; stable for omega h < 2 */
#define MUS_METHOD_EULER 2  /* symplectic Euler (kick, then drift), order 1, 1 evaluation a step; omega h < 2 */

/** Write the rate dy (n) of the state y (n) at time t: all of dy, nothing else. */
typedef void (*mus_rate_fn)(void *user, double t, const double *y, double *dy);

/** The same for a state in float. */
typedef void (*mus_rate32_fn)(void *user, double t, const float *y, float *dy);

/** Energy of the state y (n) at time t, for the guard. It may fall or stay; where it grows the run ends. */
typedef double (*mus_energy_fn)(void *user, double t, const double *y);

/** The same for a state in float. */
typedef double (*mus_energy32_fn)(void *user, double t, const float *y);

/** What to integrate, and how. */
typedef struct mus_integrate_def {
    size_t size;
    int32_t method;           /* MUS_METHOD_*, default MUS_METHOD_RK4 */
    int32_t guard_every;      /* look for a blow-up every so many steps, default 32, 1 .. 1000000 */
    double start;             /* time of the first state, default 0 */
    double step;              /* h, default 0; 0 changes nothing; else at least 2.3e-308 (float: 1.2e-38) */
    mus_rate_fn rate;         /* of mus_integrate */
    mus_energy_fn energy;     /* of mus_integrate; NULL (default): only numbers that are not finite end a run */
    mus_rate32_fn rate32;     /* of mus_integrate_f32 */
    mus_energy32_fn energy32; /* of mus_integrate_f32 */
    double energy_growth;     /* a run ends above this times max(|energy at its start|, energy_floor), default 1.5 */
    double energy_floor;      /* energy that rounding and a start from rest may reach, default 0 */
    void *user;               /* handed to the functions */
} mus_integrate_def;

/** Zero `def`, write the defaults and its size. `size` is sizeof(mus_integrate_def) of the caller. */
MUS_API void mus_integrate_def_init(mus_integrate_def *def, size_t size);

/** Numbers of work space that a state of n numbers needs (double or float, as the state): the stages of the method and
 * the last good state. 0 for an unknown method or n outside 0 .. 2^40. */
MUS_API int64_t mus_integrate_work(int32_t method, int64_t n);

/**
 * Take `steps` steps from y, in place.
 *
 * Verlet and Euler do not read the first half of dy: x' is v. Verlet evaluates the rate at the new places with the
 * velocity of the half step: order 2 for forces that do not depend on velocity, order 1 in those that do, and then
 * stable for omega h < 2 (sqrt(1 + zeta^2) - zeta), as Euler. Verlet's first step in a call takes one evaluation more.
 *
 * Shapes:  y (n); work (mus_integrate_work(method, n)); done: steps that y is from the start, may be NULL
 * Errors:  MUS_ERR_ARG (NULL, n < 0 or odd, steps < 0, step negative, not finite or denormal, y not finite, ...);
 *          MUS_ERR_VERSION; MUS_ERR_LIMIT (n above 2^40, steps above 2^53, where times stop being exact);
 *          MUS_ERR_DIVERGED: y is the last state that a look found good, *done its step; the message says what was
 *          seen. After any other error y is as it was
 * Memory:  allocates nothing
 * Cost:    steps * 4 (RK4) or 1 evaluations, and one copy of the state each guard_every steps
 * Source:  Hairer, Norsett, Wanner, Solving ODEs I, 1993, II.1; Hairer, Lubich, Wanner, Geometric Numerical
 *          Integration, 2006, I.1
 */
MUS_API mus_status mus_integrate(mus_context *context, const mus_integrate_def *def, int64_t n, double *y,
                                 int64_t steps, double *work, int64_t *done);

/** The same in float; time stays double. */
MUS_API mus_status mus_integrate_f32(mus_context *context, const mus_integrate_def *def, int64_t n, float *y,
                                     int64_t steps, float *work, int64_t *done);

#ifdef __cplusplus
}
#endif

#endif
