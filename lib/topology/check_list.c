/*
 * check_list.c: the growing list of faults, and numbers for their sentences.
 *
 * Numbers are written by hand: they read the same in every locale.
 */
#include <math.h>
#include <stdio.h>

#include "topology/check_list.h"


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


mus__fault *mus__fault_add(mus_context *context, mus__fault_list *list, int32_t kind, int32_t panel, int32_t edge,
                           int32_t seam)
{
    if (mus__reserve(context, &list->fault, &list->room, (int64_t)list->count + 1, sizeof *list->fault) != MUS_OK)
        list->failed = true;
    if (list->failed) return NULL;
    mus__fault *fault = &list->fault[list->count++];
    *fault = (mus__fault){.kind = kind, .panel = panel, .edge = edge, .seam = seam};
    return fault;
}
