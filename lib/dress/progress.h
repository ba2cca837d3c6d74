/*
 * progress.h: a run of sew or settle: the caller's progress function, and how the run ends.
 */
#ifndef MUS_DRESS_PROGRESS_H
#define MUS_DRESS_PROGRESS_H

#include "base/base_internal.h"
#include "muslin/drape.h"

typedef struct mus__progress {
    mus_progress_fn progress;
    void *user;
    const char *phase;
    double next_call; /* wall time of the next progress call [s] */
    int32_t stop;     /* nonzero: the caller's function asked to stop */
    int32_t slid;     /* nonzero: the garment slid off the body */
    int32_t sleeved;  /* nonzero: panels that close round limbs are sewn over worn layers, and pass through none */
} mus__progress;

void mus__progress_start(mus__progress *run, const char *phase, mus_progress_fn progress, void *user);
/* calls the caller's function if 0.1 s have passed since the last call; run->stop gets its answer */
void mus__progress_report(mus__progress *run, double progress);

#endif
