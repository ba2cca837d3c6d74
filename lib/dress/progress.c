/*
 * progress.c: calls of the caller's progress function during sew and settle.
 */
#define _POSIX_C_SOURCE 200809L /* clock_gettime */
#include <time.h>

#include "dress/progress.h"

#define CALL_SECONDS 0.1 /* [s] of wall time between progress calls; chosen: ten a second */


/* wall time [s] */
static double wall_time(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}


void mus__progress_start(mus__progress *run, const char *phase, mus_progress_fn progress, void *user)
{
    run->progress = progress;
    run->user = user;
    run->phase = phase;
    run->stop = run->slid = run->sleeved = 0;
    run->next_call = progress != NULL ? wall_time() : 0.0;
}


void mus__progress_report(mus__progress *run, double progress)
{
    if (run->progress == NULL) return;
    const double now = wall_time();
    if (now < run->next_call) return;
    run->next_call = now + CALL_SECONDS;
    run->stop = run->progress(run->user, run->phase, progress < 0.0 ? 0.0 : progress > 1.0 ? 1.0 : progress);
}
