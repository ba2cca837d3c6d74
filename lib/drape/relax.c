/*
 * relax.c: the memory of relaxation.
 */
#include "drape/drape_state.h"


mus_status mus__relax_create(mus_drape *drape)
{
    const int64_t n3 = 3 * (int64_t)drape->n;
    if (drape->relax.mean != NULL) return MUS_OK;
    drape->relax.mean = mus__new(drape->context, 4 * n3, sizeof *drape->relax.mean);
    if (drape->relax.mean == NULL) return mus__fail_memory(drape->context, "a sewing or a settle");
    drape->relax.before = drape->relax.mean + n3;
    drape->relax.left = drape->relax.before + n3;
    drape->relax.anchor = drape->relax.left + n3;
    return MUS_OK;
}


void mus__relax_clear(mus_drape *drape)
{
    mus__free(drape->context, drape->relax.mean);
    drape->relax.mean = drape->relax.before = drape->relax.left = drape->relax.anchor = NULL;
}
