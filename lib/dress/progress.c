/*
 * progress.c: calls of the caller's progress function during sew and settle.
 *
 * The function is told the positions of the cut that moves. They are copied to arrays of the run, because the drape's
 * own arrays of positions are read by the step bound: the result must not depend on the calls.
 */
#define _POSIX_C_SOURCE 200809L /* clock_gettime */
#include <time.h>

#include "drape/drape_state.h"
#include "dress/progress.h"


double mus__progress_time(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}


mus_status mus__progress_start(mus__progress *run, const mus_drape *drape, const char *phase, mus_progress_fn progress,
                               void *user)
{
    *run = (mus__progress){
        .progress = progress, .user = user, .phase = phase, .period = drape->def.progress_seconds};
    if (progress == NULL) return MUS_OK;
    run->x = mus__new(drape->context, 6 * (int64_t)drape->n, sizeof *run->x);
    if (run->x == NULL) return mus__fail_memory(drape->context, "the positions of a progress function");
    run->v = run->x + 3 * (ptrdiff_t)drape->n;
    run->next_call = mus__progress_time();
    return MUS_OK;
}


void mus__progress_report(mus__progress *run, const mus_drape *drape, double share)
{
    run->share = share;
    if (run->progress == NULL) return;
    const double now = mus__progress_time();
    if (now < run->next_call) return;
    run->next_call = now + run->period;
    mus__drape_read(drape, run->x, run->v);
    const mus_progress told = {.size = sizeof told,
                               .phase = run->phase,
                               .progress = share < 0.0 ? 0.0 : share > 1.0 ? 1.0 : share,
                               .coarse = drape->coarse.parent != NULL,
                               .nodes = drape->n,
                               .triangles = drape->cloth->ntriangle,
                               .positions = run->x,
                               .triangle = drape->cloth->triangle};
    run->stop = run->progress(run->user, &told);
}


void mus__progress_ask(mus__progress *run, const mus_drape *drape)
{
    if (run->period > 0.0) mus__progress_report(run, drape, run->share);
}


mus_status mus__progress_end(mus__progress *run, const mus_drape *drape, mus_status status, bool done)
{
    mus__free(drape->context, run->x);
    if (status != MUS_OK || !run->stop || done) return status;
    return mus__fail(drape->context, MUS_ERR_STOPPED, "%s: the progress function stopped the run", run->phase);
}
