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
    double period;    /* wall time between two calls at least [s] */
    double next_call; /* wall time of the next call [s] */
    double share;     /* that was reported last */
    double *x, *v;    /* (n x 3) of the finest cut: positions that the function is told, scratch; NULL without one */
    int32_t stop;     /* nonzero: the caller's function asked to stop */
    int32_t slid;     /* nonzero: the garment slid off the body */
    int32_t sleeved;  /* nonzero: panels that close round limbs are sewn over worn layers, and pass through none */
} mus__progress;

/* wall time since an arbitrary start [s] */
double mus__progress_time(void);
/* begin a run of `drape`, which ends with mus__progress_end(). Errors: MUS_ERR_MEMORY */
mus_status mus__progress_start(mus__progress *run, const mus_drape *drape, const char *phase, mus_progress_fn progress,
                               void *user);
/* call the caller's function when its period is over; `drape` is the cut that moves, `share` is 0 to 1. run->stop gets
 * the answer */
void mus__progress_report(mus__progress *run, const mus_drape *drape, double share);
/* the same between two reports, with the share of the last one; not with a period of 0, which means each report */
void mus__progress_ask(mus__progress *run, const mus_drape *drape);
/* end a run that returns `status`; `done`: the run had reached its end. Returns `status`, or MUS_ERR_STOPPED */
mus_status mus__progress_end(mus__progress *run, const mus_drape *drape, mus_status status, bool done);

#endif
