/*
 * level.c: between a drape and its coarser double.
 *
 * A cloth finds its place in few large steps on a coarse cut: at four times the spacing a second of cloth time costs a
 * sixty-fourth. What is left for the fine cut are folds of its own size.
 */
#include <string.h>

#include "drape/level.h"


static mus_status make_coarse(mus_drape *drape)
{
    mus_drape *coarse;
    mus_status status = mus__drape_make(drape->context, drape->cloth->coarse, NULL, drape, &drape->def, &coarse);
    if (status != MUS_OK) return status;
    status = mus__transfer_build(drape->context, coarse->cloth, drape->cloth, &drape->up);
    if (status == MUS_OK) status = mus__transfer_build(drape->context, drape->cloth, coarse->cloth, &drape->down);
    drape->coarse = coarse;
    if (status != MUS_OK) mus__drape_coarse_destroy(drape);
    return status;
}


mus_status mus__drape_coarse(mus_drape *drape, mus_drape **out)
{
    mus_status status = MUS_OK;
    if (drape->coarse == NULL && drape->cloth->coarse != NULL) status = make_coarse(drape);
    mus_drape *coarse = drape->coarse;
    if (coarse != NULL)
        status = mus__plan_tack_room(drape->context, coarse->cloth, drape->plan.ntack, &coarse->plan);
    *out = coarse;
    return status;
}


void mus__drape_coarse_destroy(mus_drape *drape)
{
    mus__transfer_clear(drape->context, &drape->up);
    mus__transfer_clear(drape->context, &drape->down);
    mus_drape_destroy(drape->coarse);
    drape->coarse = NULL;
}


/* each held node holds the nearest node of the coarse cut */
static void restrict_pins(mus_drape *drape)
{
    mus_drape *coarse = drape->coarse;
    for (int32_t i = 0; i < drape->n; i++) {
        if (!(drape->pinned[i] & MUS__PINNED)) continue;
        const int32_t held = coarse->rep[mus__transfer_nearest(&drape->up, i)];
        if (coarse->pinned[held]) continue;
        coarse->pinned[held] = MUS__PINNED;
        memcpy(coarse->x + 3 * (int64_t)held, drape->x + 3 * (int64_t)i, 3 * sizeof *coarse->x);
    }
}


void mus__drape_restrict(mus_drape *drape)
{
    mus_drape *coarse = drape->coarse;
    memcpy(coarse->def.gravity, drape->def.gravity, sizeof coarse->def.gravity); /* it may have changed since */
    mus__drape_hold(coarse);
    const int32_t waits = drape->plan.open_from > 0 ? drape->plan.open_from : drape->plan.wait_from;
    coarse->plan.open_from = 0;
    coarse->plan.wait_from = waits;
    for (int32_t i = 0; i < coarse->n; i++)
        coarse->pinned[i] = waits > 0 && mus__cloth_layer(coarse->cloth, i) >= waits ? MUS__WAITS : 0;
    mus__drape_restrict_tacks(drape);
    mus__drape_open(coarse);
    mus__transfer_apply(&drape->down, drape->x, coarse->x);
    mus__transfer_apply(&drape->down, drape->v, coarse->v);
    mus__drape_push(coarse);
    if (drape->welded) mus__drape_weld(coarse);
    restrict_pins(drape);
    mus__drape_push(coarse);
    mus__drape_publish(coarse);
}


void mus__drape_prolong(mus_drape *drape)
{
    mus_drape *coarse = drape->coarse;
    double *held = drape->force; /* scratch: the places of the held nodes */
    memcpy(held, drape->x, 3 * (size_t)drape->n * sizeof *held);
    mus__transfer_apply(&drape->up, coarse->x, drape->x);
    mus__transfer_apply(&drape->up, coarse->v, drape->v);
    for (int32_t i = 0; i < drape->n; i++) {
        if (!drape->pinned[drape->rep[i]]) continue;
        memcpy(drape->x + 3 * (int64_t)i, held + 3 * (int64_t)i, 3 * sizeof *held);
        memset(drape->v + 3 * (int64_t)i, 0, 3 * sizeof *held);
    }
    mus__drape_push(drape);
    if (coarse->welded && !drape->welded) mus__drape_weld(drape);
    else mus__drape_publish(drape);

    drape->steps += coarse->steps;
    drape->spring_evaluations += coarse->spring_evaluations;
    drape->contact_queries += coarse->contact_queries;
    for (int32_t part = 0; part < 64; part++) {
        drape->contact_queries += coarse->sim.part_tally[part].queries;
        coarse->sim.part_tally[part].queries = 0;
    }
    drape->sew_time += coarse->sew_time;
    drape->settle_time += coarse->settle_time;
    coarse->steps = coarse->spring_evaluations = coarse->contact_queries = 0;
    coarse->sew_time = coarse->settle_time = 0.0;
}
