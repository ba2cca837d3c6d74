/*
 * forecast.c: what stepping will cost, told before a run: the step under the bound, steps a frame, CPU seconds, and the
 * node that is the reason.
 *
 * The seconds are those of a trial: a few steps on the present state, which is then put back as it was.
 */
#define _POSIX_C_SOURCE 200809L /* clock_gettime */
#include <math.h>
#include <string.h>
#include <time.h>

#include "drape/drape_internal.h"

#define TRIAL_STEPS 8
#define PLAN_SAFETY 0.9
#define FRAME_MOST 1e4 /* [s] */


void mus_drape_forecast_init(mus_drape_forecast *forecast, size_t size)
{
    if (forecast == NULL || size < sizeof forecast->size) return;
    memset(forecast, 0, size);
    forecast->size = size;
}


static double cpu_seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}


/* CPU seconds of a step of h; state, clock and counters are as before */
static double time_steps(mus_drape *drape, double h)
{
    mus__sim *sim = &drape->sim;
    const int64_t steps = drape->steps, springs = drape->spring_evaluations, evaluations = sim->force_evaluations;
    mus__contact_tally tally[64];
    memcpy(tally, sim->part_tally, sizeof tally);
    mus__drape_prepare(drape, h);
    sim->ops->snapshot(sim);
    mus__drape_advance(drape, 0, 1, h); /* warms the caches */
    const double start = cpu_seconds();
    mus__drape_advance(drape, 1, TRIAL_STEPS, h);
    const double seconds = (cpu_seconds() - start) / TRIAL_STEPS;
    sim->ops->restore(sim);
    if (sim->near != NULL) mus__drape_near(drape); /* has its memory; forgets what the trial asked */
    sim->near = NULL;
    memcpy(sim->part_tally, tally, sizeof tally);
    mus__drape_stand(drape, 0, drape->dt, 0.0);
    sim->force_evaluations = evaluations;
    drape->steps = steps;
    drape->spring_evaluations = springs;
    return seconds;
}


/* what of a node's stiffness is bending, seams and tacks: all less what springs give at this pose */
static double bend_share(const mus_drape *drape, int32_t node)
{
    const double all = drape->stiffness[node];
    mus__plan_bending(&drape->plan, drape->n, drape->stiffness);
    return all > 0.0 ? drape->stiffness[node] / all : 0.0;
}


mus_status mus_drape_plan(mus_drape *drape, double frame, mus_drape_forecast *out)
{
    if (drape == NULL) return MUS_ERR_ARG;
    mus_context *context = drape->context;
    if (out == NULL || out->size != sizeof *out)
        return mus__fail(context, MUS_ERR_VERSION, "drape forecast: size unknown; use mus_drape_forecast_init");
    if (!(frame > 0.0 && frame <= FRAME_MOST))
        return mus__fail(context, MUS_ERR_ARG, "drape: a frame of %g s, expected above 0 and at most %g", frame,
                         FRAME_MOST);

    mus_drape_forecast own;
    mus_drape_forecast_init(&own, sizeof own);
    own.node = MUS_NONE;
    own.step_bound = mus__drape_bound(drape, &own.node);
    if (own.node != MUS_NONE) {
        own.node_mass = drape->mass[own.node];
        own.node_stiffness = drape->stiffness[own.node];
        own.bend_share = bend_share(drape, own.node);
    }
    const double steps = ceil(frame / (PLAN_SAFETY * own.step_bound));
    if (!(steps <= INT32_MAX))
        return mus__fail(context, MUS_ERR_LIMIT, "drape: a frame of %g s needs %g steps, at most %d", frame, steps,
                         INT32_MAX);
    own.steps_per_frame = (int32_t)steps;
    own.step = frame / steps;
    own.node_evaluations = (int64_t)own.steps_per_frame * drape->n * mus__drape_evaluations(drape);
    mus_status status = mus_drape_step(drape, 0, own.step); /* takes masses and bound */
    if (status != MUS_OK) return status;
    own.seconds = own.steps_per_frame * time_steps(drape, own.step);
    *out = own;
    return MUS_OK;
}
