/*
 * cost_estimate.c: mus_drape_estimate(): the cost of stepping, told before a run: the step under the bound, steps of a
 * frame, CPU seconds, and the node that sets the bound.
 *
 * The seconds are those of a trial: some steps on the present state, which is then put back as it was.
 * mus_drape_evaluate() only evaluates forces, by the kernels of a step, which benchmarks time.
 */
#define _POSIX_C_SOURCE 200809L /* clock_gettime */
#include <math.h>
#include <string.h>
#include <time.h>

#include "drape/drape_state.h"
#include "drape/scene.h"
#include "sim/step_bound.h"

#define TRIAL_STEPS 8       /* timed; chosen: some milliseconds for 10,000 nodes */
#define ESTIMATE_SAFETY 0.9 /* the step, as a share of the bound: the pose may lower the bound a little */
#define FRAME_MOST 1e4      /* [s] longest frame */


void mus_estimate_init(mus_estimate *estimate, size_t size)
{
    mus_estimate own = {0};
    mus__def_init(estimate, size, &own, sizeof own);
}


static double cpu_seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}


/* copies of the sliders of bending and of their forces, which putting places back starts anew */
typedef struct sliders {
    mus__slider *slider;
    char *force;
} sliders;


static mus_status keep_sliders(const mus_drape *drape, sliders *kept)
{
    const mus__sim *sim = &drape->sim;
    const int64_t count = sim->program->nslider, bytes = count > 0 ? 3 * (int64_t)sim->n * (int64_t)sim->ops->real : 0;
    *kept = (sliders){0};
    if (count == 0) return MUS_OK;
    kept->slider = mus__new(drape->context, count, sizeof *kept->slider);
    kept->force = mus__new(drape->context, bytes, 1);
    if (kept->slider == NULL || kept->force == NULL) {
        mus__free(drape->context, kept->slider);
        mus__free(drape->context, kept->force);
        return mus__fail_memory(drape->context, "an estimate");
    }
    memcpy(kept->slider, sim->program->slider, (size_t)count * sizeof *kept->slider);
    memcpy(kept->force, sim->slide_force, (size_t)bytes);
    return MUS_OK;
}


/* puts the sliders back, moved `age` steps ago, and frees their copies */
static void put_sliders(mus_drape *drape, const sliders *kept, int32_t age)
{
    mus__sim *sim = &drape->sim;
    sim->slide_age = age;
    if (kept->slider == NULL) return;
    memcpy(drape->program.slider, kept->slider, (size_t)drape->program.nslider * sizeof *kept->slider);
    memcpy(sim->slide_force, kept->force, 3 * (size_t)sim->n * sim->ops->real);
    mus__free(drape->context, kept->slider);
    mus__free(drape->context, kept->force);
}


/* CPU seconds of a step of h [s]; state, clock and counters are as before */
static double time_steps(mus_drape *drape, double h, const sliders *kept)
{
    mus__sim *sim = &drape->sim;
    const int32_t age = sim->slide_age;
    const int64_t steps = drape->counters.steps, springs = drape->counters.spring_evaluations,
                  evaluations = sim->force_evaluations;
    mus__contact_tally tally[64];
    memcpy(tally, sim->part_tally, sizeof tally);
    mus__drape_prepare(drape, h);
    sim->ops->snapshot(sim);
    mus__drape_advance(drape, 0, 1, h); /* warms the caches */
    const double start = cpu_seconds();
    mus__drape_advance(drape, 1, TRIAL_STEPS, h);
    const double seconds = (cpu_seconds() - start) / TRIAL_STEPS;
    sim->ops->restore(sim);
    put_sliders(drape, kept, age);
    if (sim->plane_cache != NULL) mus__drape_plane_cache(drape); /* has its memory; forgets the queries of the trial */
    sim->plane_cache = NULL;
    memcpy(sim->part_tally, tally, sizeof tally);
    mus__scene_update(drape, 0, drape->clock.dt, 0.0);
    sim->force_evaluations = evaluations;
    drape->counters.steps = steps;
    drape->counters.spring_evaluations = springs;
    return seconds;
}


/* share of a node's stiffness at this pose that bending, seams, tacks and attachments give; the rest is springs */
static mus_status bend_share(const mus_drape *drape, int32_t node, double *share)
{
    const double all = drape->stepping.stiffness[node];
    double *bending = mus__new(drape->context, drape->n, sizeof *bending);
    if (bending == NULL) return mus__fail_memory(drape->context, "an estimate");
    mus__program_stiffness_bending(&drape->program, drape->n, bending);
    *share = all > 0.0 ? bending[node] / all : 0.0;
    mus__free(drape->context, bending);
    return MUS_OK;
}


mus_status mus_drape_estimate(mus_drape *drape, double frame, mus_estimate *out)
{
    if (drape == NULL) return MUS_ERR_ARG;
    mus_context *context = drape->context;
    if (out == NULL || out->size != sizeof *out)
        return mus__fail(context, MUS_ERR_VERSION, "drape estimate: size unknown; use mus_estimate_init");
    if (!(frame > 0.0 && frame <= FRAME_MOST))
        return mus__fail(context, MUS_ERR_ARG, "drape: a frame of %g s, expected above 0 and at most %g", frame,
                         FRAME_MOST);

    mus_estimate own;
    mus_estimate_init(&own, sizeof own);
    own.node = MUS_NONE;
    own.step_bound = mus__drape_bound(drape, &own.node);
    if (own.node != MUS_NONE) {
        own.node_mass = drape->mass[own.node];
        own.node_stiffness = drape->stepping.stiffness[own.node];
        const mus_status shared = bend_share(drape, own.node, &own.bend_share);
        if (shared != MUS_OK) return shared;
    }
    const double steps = ceil(frame / (ESTIMATE_SAFETY * own.step_bound));
    if (!(steps <= INT32_MAX))
        return mus__fail(context, MUS_ERR_LIMIT, "drape: a frame of %g s needs %g steps, at most %d", frame, steps,
                         INT32_MAX);
    own.steps_per_frame = (int32_t)steps;
    own.step = frame / steps;
    own.node_evaluations = (int64_t)own.steps_per_frame * drape->n * mus__drape_evaluations(drape);
    mus_status status = mus_drape_step(drape, 0, own.step); /* takes masses and bound */
    sliders kept;
    if (status == MUS_OK) status = keep_sliders(drape, &kept);
    if (status != MUS_OK) return status;
    own.seconds = own.steps_per_frame * time_steps(drape, own.step, &kept);
    *out = own;
    return MUS_OK;
}


mus_status mus_drape_evaluate(mus_drape *drape, int32_t times)
{
    if (drape == NULL) return MUS_ERR_ARG;
    if (times < 0) return mus__fail(drape->context, MUS_ERR_ARG, "drape: times is %d, expected 0 or more", (int)times);

    /* the forces that Verlet keeps for its next step are saved in `second`, which no step uses between steps */
    mus__sim *sim = &drape->sim;
    const size_t bytes = 3 * (size_t)sim->n * sim->ops->real;
    const int32_t fresh = sim->fresh;
    memcpy(sim->second, sim->f, bytes);
    sim->dashpots = drape->program.dashpots;
    for (int32_t i = 0; i < times; i++) sim->ops->force(sim);
    memcpy(sim->f, sim->second, bytes);
    sim->fresh = fresh;
    return MUS_OK;
}
