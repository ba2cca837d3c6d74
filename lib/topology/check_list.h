/*
 * check_list.h: the faults of a check that is under way, and the sentences in them.
 */
#ifndef MUS_TOPOLOGY_CHECK_LIST_H
#define MUS_TOPOLOGY_CHECK_LIST_H

#include "topology/quotient.h"

typedef struct mus__fault_list {
    mus__fault *fault;
    int32_t count, room;
    bool failed; /* there was no memory for a fault */
} mus__fault_list;

/* ---- check_list.c ---- */

/* append a fault without text; NULL without memory */
mus__fault *mus__fault_add(mus_context *context, mus__fault_list *list, int32_t kind, int32_t panel, int32_t edge,
                           int32_t seam);
/* a number with `decimals` places behind a full stop, in every locale, into out (32) */
const char *mus__fault_number(double value, int32_t decimals, char *out);

/* ---- check_garment.c ---- */

/* the faults of a pattern that declares openings, as a garment. Changes q */
mus_status mus__garment_faults(const mus_pattern *pattern, mus__quotient *q, mus__fault_list *list);

#endif
