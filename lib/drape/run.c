/*
 * run.c: what sew and settle share: progress calls, the guard on the state; and stepping by hand.
 */
#define _POSIX_C_SOURCE 200809L /* clock_gettime */
#include <math.h>
#include <string.h>
#include <time.h>

#include "drape/drape_internal.h"

#define CALL_SECONDS 0.1 /* of wall time between progress calls */
#define GUARD_STEPS 64   /* between looks at the state */
#define PUSH_SPEED 1.0   /* [m/s]: what starts inside the body leaves it no faster */
#define LEAST_STEP 1e-30 /* [s]: far below what moves a float */
#define MOST_SPEED 1e4   /* [m/s]: no cloth moves so fast; beyond it the motion has diverged */


static double wall_time(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}


void mus__run_start(mus__run *run, const char *phase, mus_progress_fn progress, void *user)
{
    run->progress = progress;
    run->user = user;
    run->phase = phase;
    run->stop = run->slid = 0;
    run->next_call = progress != NULL ? wall_time() : 0.0;
}


void mus__run_report(mus__run *run, double progress)
{
    if (run->progress == NULL) return;
    const double now = wall_time();
    if (now < run->next_call) return;
    run->next_call = now + CALL_SECONDS;
    run->stop = run->progress(run->user, run->phase, progress < 0.0 ? 0.0 : progress > 1.0 ? 1.0 : progress);
}


mus_status mus__drape_guard(mus_drape *drape)
{
    mus__sim *sim = &drape->sim;
    const double speed2 = sim->ops->speed2(sim);
    if (speed2 <= MOST_SPEED * MOST_SPEED) {
        sim->ops->snapshot(sim);
        return MUS_OK;
    }
    sim->ops->restore(sim);
    return mus__fail(drape->context, MUS_ERR_DIVERGED,
                     "drape: the motion diverged before %.6f s (speed %g m/s, limit %g); the last good state is kept",
                     mus_drape_time(drape), sqrt(speed2), MOST_SPEED);
}


/* ---- stepping by hand ---- */

double mus_drape_step_bound(const mus_drape *drape)
{
    if (drape == NULL) return 0.0;
    double rate2 = 0.0, gamma = 0.0, ratio = 0.0, *dashpots = drape->work;
    mus__plan_stiffness(&drape->plan, drape->n, drape->stiffness);
    if (drape->plan.dashpots) mus__plan_dashpots(&drape->plan, drape->n, dashpots, &ratio);
    for (int32_t i = 0; i < drape->n; i++) {
        if (drape->mass[i] <= 0.0 || drape->pinned[i]) continue;
        if (drape->stiffness[i] > rate2 * drape->mass[i]) rate2 = drape->stiffness[i] / drape->mass[i];
        if (drape->plan.dashpots && dashpots[i] > gamma * drape->mass[i]) gamma = dashpots[i] / drape->mass[i];
    }
    if (drape->def.integrator == MUS_METHOD_VERLET) return mus__plan_step_verlet(rate2, gamma);
    return mus__plan_step(rate2, gamma + drape->def.drag, ratio, drape->def.drag);
}


mus_status mus_drape_step(mus_drape *drape, int32_t steps, double dt)
{
    if (drape == NULL) return MUS_ERR_ARG;
    mus_context *context = drape->context;
    if (steps < 0) return mus__fail(context, MUS_ERR_ARG, "drape: steps is %d, expected 0 or more", (int)steps);
    if (!(dt == 0.0 || dt >= LEAST_STEP) || !mus__finite(dt))
        return mus__fail(context, MUS_ERR_ARG, "drape: step is %g s, expected 0 or at least %g", dt, LEAST_STEP);
    mus__drape_inertia(drape, 0);
    const double bound = mus_drape_step_bound(drape);
    if (dt > bound)
        return mus__fail(context, MUS_ERR_STEP, "drape: step %.9g s is above the stability bound %.9g s", dt, bound);
    if (steps == 0 || dt == 0.0) return MUS_OK;

    mus__sim *sim = &drape->sim;
    for (int32_t d = 0; d < 3; d++) sim->gravity[d] = drape->def.gravity[d];
    sim->drag = drape->def.drag;
    sim->dashpots = drape->plan.dashpots;
    const int32_t verlet = drape->def.integrator == MUS_METHOD_VERLET;
    sim->rule = (mus__contact_rule){drape->def.clearance,     drape->friction, PUSH_SPEED * dt, 0.0,
                                    verlet ? dt : 0.5 * dt, dt};
    memset(sim->rest, 0, (size_t)drape->n);
    mus__drape_meet_first(drape);
    mus_status status = MUS_OK;
    for (int32_t done = 0; done < steps && status == MUS_OK;) {
        const int32_t batch = steps - done < GUARD_STEPS ? steps - done : GUARD_STEPS;
        /* a body that glides is moved before each step */
        const int32_t alone = !verlet || mus__drape_glides(drape) ? 1 : batch;
        for (int32_t i = 0; i < batch; i += alone) {
            mus__drape_meet(drape, i + alone, dt);
            if (verlet) sim->ops->verlet(sim, dt, alone);
            else sim->ops->rk4(sim, dt);
        }
        done += batch;
        status = mus__drape_guard(drape);
        if (status == MUS_OK) mus__drape_tick(drape, batch, dt, verlet ? 1 : 4);
    }
    mus__drape_glide(drape, 0, dt);
    drape->settled = 0;
    mus__drape_publish(drape);
    return status;
}
