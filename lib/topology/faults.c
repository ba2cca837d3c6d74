/*
 * faults.c: the faults of a checked pattern as an object: what mus_pattern_check() found, apart from the pattern.
 *
 * Numbers in the sentences are written by hand: they read the same in every locale.
 */
#include <math.h>
#include <stdio.h>

#include "topology/faults.h"


const char *mus__fault_number(double value, int32_t decimals, char *out)
{
    long long scale = 1;
    for (int32_t i = 0; i < decimals; i++) scale *= 10;
    double scaled = floor(fabs(value) * (double)scale + 0.5);
    if (!(scaled < 1e15)) {
        snprintf(out, 32, "%s1e%d or more", value < 0.0 ? "-" : "", 15 - (int)decimals);
        return out;
    }
    long long whole = (long long)scaled;
    snprintf(out, 32, "%s%lld.%0*lld", value < 0.0 && whole > 0 ? "-" : "", whole / scale, (int)decimals,
             whole % scale);
    return out;
}


mus__fault *mus__fault_add(mus_faults *faults, int32_t kind, int32_t panel, int32_t edge, int32_t seam)
{
    if (mus__reserve(faults->context, &faults->fault, &faults->room, (int64_t)faults->count + 1,
                     sizeof *faults->fault) != MUS_OK)
        faults->failed = true;
    if (faults->failed) return NULL;
    mus__fault *fault = &faults->fault[faults->count++];
    *fault = (mus__fault){.kind = kind, .panel = panel, .edge = edge, .seam = seam};
    return fault;
}


void mus_faults_destroy(mus_faults *faults)
{
    if (faults == NULL) return;
    mus__free(faults->context, faults->fault);
    mus__free(faults->context, faults);
}


int32_t mus_faults_count(const mus_faults *faults)
{
    return faults != NULL ? faults->count : 0;
}


const char *mus_faults_text(const mus_faults *faults, int32_t index)
{
    return faults != NULL && index >= 0 && index < faults->count ? faults->fault[index].text : NULL;
}


mus_status mus_faults_item(const mus_faults *faults, int32_t index, int32_t *kind, int32_t *panel, int32_t *edge,
                           int32_t *seam)
{
    if (kind != NULL) *kind = 0;
    if (panel != NULL) *panel = MUS_NONE;
    if (edge != NULL) *edge = MUS_NONE;
    if (seam != NULL) *seam = MUS_NONE;
    if (faults == NULL) return MUS_ERR_ARG;
    if (index < 0 || index >= faults->count)
        return mus__fail(faults->context, MUS_ERR_ARG, "fault %d is unknown, the check found %d", (int)index,
                         (int)faults->count);

    const mus__fault *own = &faults->fault[index];
    if (kind != NULL) *kind = own->kind;
    if (panel != NULL) *panel = own->panel;
    if (edge != NULL) *edge = own->edge;
    if (seam != NULL) *seam = own->seam;
    return MUS_OK;
}
