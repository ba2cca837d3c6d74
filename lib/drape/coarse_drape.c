/*
 * coarse_drape.c: the coarse drape, and places carried between it and its drape.
 *
 * A cloth finds its place in few large steps on a coarse cut: at four times the spacing, a second of cloth time costs a
 * sixty-fourth. Only folds of its own size are left for the fine cut.
 */
#include <string.h>

#include "drape/coarse_drape.h"
#include "drape/drape_state.h"
#include "sim/bend_clamp.h"
#include "drape/weld.h"


/* frees the coarse drape; mus_drape_destroy reaches it through coarse.destroy */
static void coarse_destroy(mus_drape *drape)
{
    mus__transfer_clear(drape->context, &drape->coarse.up);
    mus__transfer_clear(drape->context, &drape->coarse.down);
    mus_drape_destroy(drape->coarse.drape);
    mus__free(drape->context, drape->coarse.pinned_x);
    drape->coarse.drape = NULL;
    drape->coarse.destroy = NULL;
    drape->coarse.pinned_x = NULL;
}


/* makes the coarse drape and the transfers between both. Errors: MUS_ERR_MEMORY */
static mus_status make_coarse(mus_drape *drape)
{
    mus_drape *coarse;
    mus_status status =
        mus__drape_make(drape->context, drape->cloth->coarse, NULL, drape, &drape->def, drape->kit, &coarse);
    if (status != MUS_OK) return status;
    status = mus__transfer_build(drape->context, coarse->cloth, drape->cloth, &drape->coarse.up);
    if (status == MUS_OK)
        status = mus__transfer_build(drape->context, drape->cloth, coarse->cloth, &drape->coarse.down);
    drape->coarse.drape = coarse;
    drape->coarse.destroy = coarse_destroy;
    drape->coarse.pinned_x = mus__new(drape->context, 3 * (int64_t)drape->n, sizeof *drape->coarse.pinned_x);
    if (status == MUS_OK && drape->coarse.pinned_x == NULL) status = mus__fail_memory(drape->context, "a coarse drape");
    if (status != MUS_OK) coarse_destroy(drape);
    return status;
}


mus_status mus__coarse_create(mus_drape *drape, mus_drape **out)
{
    mus_status status = MUS_OK;
    if (drape->coarse.drape == NULL && drape->cloth->coarse != NULL) status = make_coarse(drape);
    mus_drape *coarse = drape->coarse.drape;
    if (coarse != NULL)
        status = mus__program_tack_room(drape->context, coarse->cloth, drape->program.ntack, &coarse->program);
    if (status == MUS_OK && coarse != NULL && drape->program.nclamp > 0)
        status = mus__clamps_room(drape->context, coarse->cloth, NULL, 0, &coarse->program);
    *out = coarse;
    return status;
}


/* pins the coarse node that is nearest to each pinned node, at its place */
static void restrict_pins(mus_drape *drape)
{
    mus_drape *coarse = drape->coarse.drape;
    for (int32_t i = 0; i < drape->n; i++) {
        if (!(drape->pinned[i] & MUS__PINNED)) continue;
        const int32_t pinned = coarse->rep[mus__transfer_nearest(&drape->coarse.up, i)];
        if (coarse->pinned[pinned]) continue;
        coarse->pinned[pinned] = MUS__PINNED;
        memcpy(coarse->x + 3 * (int64_t)pinned, drape->x + 3 * (int64_t)i, 3 * sizeof *coarse->x);
    }
}


void mus__coarse_restrict(mus_drape *drape)
{
    mus_drape *coarse = drape->coarse.drape;
    memcpy(coarse->def.gravity, drape->def.gravity,
           sizeof coarse->def.gravity); /* it may have changed since the coarse drape was made */
    mus__scene_levels_update(coarse);
    const int32_t waits = drape->program.open_from > 0 ? drape->program.open_from : drape->program.wait_from;
    coarse->program.open_from = 0;
    coarse->program.wait_from = waits;
    for (int32_t i = 0; i < coarse->n; i++)
        coarse->pinned[i] = waits > 0 && mus__cloth_layer(coarse->cloth, i) >= waits ? MUS__WAITS : 0;
    mus__tack_restrict(drape);
    mus__weld_open(coarse);
    mus__transfer_apply(&drape->coarse.down, drape->x, coarse->x);
    mus__transfer_apply(&drape->coarse.down, drape->v, coarse->v);
    mus__drape_push(coarse);
    if (drape->welded) mus__weld(coarse);
    restrict_pins(drape);
    mus__clamps_update(coarse->cloth, coarse->pinned, MUS__PINNED, &coarse->program);
    mus__drape_push(coarse);
    mus__drape_publish(coarse);
}


void mus__coarse_prolong(mus_drape *drape)
{
    mus_drape *coarse = drape->coarse.drape;
    double *pinned = drape->coarse.pinned_x;
    memcpy(pinned, drape->x, 3 * (size_t)drape->n * sizeof *pinned);
    mus__transfer_apply(&drape->coarse.up, coarse->x, drape->x);
    mus__transfer_apply(&drape->coarse.up, coarse->v, drape->v);
    for (int32_t i = 0; i < drape->n; i++) {
        if (!drape->pinned[drape->rep[i]]) continue;
        memcpy(drape->x + 3 * (int64_t)i, pinned + 3 * (int64_t)i, 3 * sizeof *pinned);
        memset(drape->v + 3 * (int64_t)i, 0, 3 * sizeof *pinned);
    }
    mus__drape_push(drape);
    if (coarse->welded && !drape->welded)
        mus__weld(drape);
    else
        mus__drape_publish(drape);

    drape->counters.steps += coarse->counters.steps;
    drape->counters.spring_evaluations += coarse->counters.spring_evaluations;
    drape->counters.contact_queries += coarse->counters.contact_queries;
    for (int32_t part = 0; part < 64; part++) {
        drape->counters.contact_queries += coarse->sim.part_tally[part].queries;
        coarse->sim.part_tally[part].queries = 0;
    }
    drape->counters.sew_time += coarse->counters.sew_time;
    drape->counters.settle_time += coarse->counters.settle_time;
    coarse->counters.steps = coarse->counters.spring_evaluations = coarse->counters.contact_queries = 0;
    coarse->counters.sew_time = coarse->counters.settle_time = 0.0;
}
