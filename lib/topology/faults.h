/*
 * faults.h: the faults that a check finds, as the list that grows while it runs.
 */
#ifndef MUS_TOPOLOGY_FAULTS_H
#define MUS_TOPOLOGY_FAULTS_H

#include "topology/quotient.h"

#define MUS__FAULT_BYTES 768 /* [bytes] of a sentence: five names of MUS__NAME_BYTES and the words between them */

typedef struct mus__fault {
    int32_t kind, panel, edge, seam;
    char text[MUS__FAULT_BYTES];
} mus__fault;

struct mus_faults {
    mus_context *context;
    mus__fault *fault; /* (count) */
    int32_t count, room;
    bool failed; /* there was no memory for a fault */
};

/* ---- faults.c ---- */

/* append a fault without text; NULL without memory, and `failed` is set */
mus__fault *mus__fault_add(mus_faults *faults, int32_t kind, int32_t panel, int32_t edge, int32_t seam);
/* a number with `decimals` places behind a full stop, in every locale, into out (32) */
const char *mus__fault_number(double value, int32_t decimals, char *out);

/* ---- check_garment.c ---- */

/* append the faults of a pattern that declares openings, as a garment. Changes q */
mus_status mus__garment_faults(const mus_pattern *pattern, mus__quotient *q, mus_faults *faults);

#endif
