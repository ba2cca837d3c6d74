/*
 * dress_start.h: one start of mus_dress(): cut, placed, sewn, looked at, settled (dress_start.c).
 */
#ifndef MUS_DRESS_DRESS_START_H
#define MUS_DRESS_DRESS_START_H

#include "base/base_internal.h"
#include "muslin/dress.h"

/* the call: what it was given, and its report */
typedef struct mus__dress {
    mus_context *context;
    const mus_body *body;
    mus_dress_def def;
    mus_drape_def drape;
    mus_dress_report report;
    double start;    /* wall time at which the call began [s] */
    int32_t stopped; /* nonzero: the run was stopped, by the progress function or because its time is over */
    int32_t late;    /* nonzero: its time is over */
} mus__dress;

/* one start and how it ended */
typedef struct mus__dress_start {
    const mus_pattern *pattern; /* with the placement of this start, borrowed */
    int32_t index;              /* in the report; MUS_NONE before it is sewn */
    int32_t waits;              /* nonzero: sewn, but something speaks against settling it: that is its reason */
    mus_cloth *cloth;
    mus_drape *drape;
    mus_body *raised; /* the body with its arms out of the way; NULL for other starts */
    mus_status status;
    mus_reason reason;
    int32_t refused; /* nonzero: mus_drape_start() found a fault, and nothing was sewn */
    char text[MUS_ERROR_BYTES];
} mus__dress_start;

/* the body with its arms horizontal, all else as it stands: *pose and *out. Errors: those of mus_body_pose() */
mus_status mus__dress_raise(const mus_body *body, mus_pose *pose, mus_body **out);
/* cut the cloth, put it where `pattern` has it and sew it. start->status is MUS_OK when it may be settled. A start that
 * is not patient and whose limbs are not in their openings, or whose cloth crosses cloth, waits: it has failed, but can
 * be settled all the same. `raised`: start->raised is set, and the arms are as there */
void mus__dress_sew(mus__dress *call, const mus_pattern *pattern, int32_t place, bool patient, mus__dress_start *start);
/* settle a start that is sewn, with its arms back where the body has them; and say whether it is worn */
void mus__dress_settle(mus__dress *call, mus__dress_start *start);
void mus__dress_start_free(mus__dress_start *start);

#endif
