/*
 * run.c: what sew, settle and step share: progress calls and the guard on the state.
 */
#define _POSIX_C_SOURCE 200809L /* clock_gettime */
#include <math.h>
#include <string.h>
#include <time.h>

#include "drape/drape_internal.h"

#define CALL_SECONDS 0.1 /* of wall time between progress calls */
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
    run->stop = run->slid = run->sleeved = 0;
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


mus_status mus__drape_check_motion(mus_drape *drape)
{
    mus__sim *sim = &drape->sim;
    sim->ops->flush(sim);
    const double speed2 = sim->ops->speed2(sim);
    drape->speed = sqrt(speed2);
    if (speed2 <= MOST_SPEED * MOST_SPEED) return MUS_OK;
    sim->ops->restore(sim);
    mus__drape_stale(drape);
    return mus__fail(drape->context, MUS_ERR_DIVERGED,
                     "drape: the motion diverged before %.6f s (speed %g m/s, limit %g); the last good state is kept",
                     mus_drape_time(drape), sqrt(speed2), MOST_SPEED);
}


mus_status mus__drape_guard(mus_drape *drape)
{
    const mus_status status = mus__drape_check_motion(drape);
    if (status == MUS_OK) drape->sim.ops->snapshot(&drape->sim);
    return status;
}


mus_status mus__drape_near(mus_drape *drape)
{
    mus__sim *sim = &drape->sim;
    const int64_t n = sim->n;
    if (drape->collider == NULL) return MUS_OK;
    if (drape->skin == NULL) drape->skin = mus__new(drape->context, MUS__CACHE_PLANES * n, sim->ops->real);
    if (drape->skin == NULL) return mus__fail_memory(drape->context, "what nodes know of the skin");
    for (int64_t i = 7 * n; i < 8 * n; i++) mus__plan_put(&drape->plan, drape->skin, i, -1.0);
    sim->near = drape->skin;
    return MUS_OK;
}
