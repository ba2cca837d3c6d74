/*
 * drape_positions.c: where the nodes of a drape are put: at the pattern's placement, where another drape lies, where
 * the caller says, or pinned.
 */
#include <string.h>

#include "arrange/arrange_nodes.h"
#include "drape/drape_state.h"
#include "drape/residual.h"
#include "sim/bend_clamp.h"
#include "drape/weld.h"


/* Sets the clock to 0 and the scene to its beginning, after all nodes were moved. far: whether the cloth is far from
 * its shape at rest. */
static void positions_begin(mus_drape *drape, int32_t far)
{
    drape->clock.time0 = 0.0;
    drape->clock.count = 0;
    drape->relax.settled = 0;
    drape->relax.far = far;
    drape->coarse.as_sewn = 0;
    mus__drape_lift_clear(drape);
    mus__scene_reset(drape);
}


mus_status mus_drape_place(mus_drape *drape)
{
    if (drape == NULL) return MUS_ERR_ARG;
    mus__arrange_nodes(drape->cloth, drape->x);
    memset(drape->v, 0, 3 * (size_t)drape->n * sizeof *drape->v);
    drape->program.open_from = 0;
    mus__weld_open(drape);
    mus__drape_push(drape);
    mus__drape_publish(drape);
    positions_begin(drape, 1);
    return MUS_OK;
}


/* places x (n x 3) of the nodes of `drape` in the cloth of `from`; bare nodes have no panels and correspond by index */
static mus_status find_places(const mus_drape *drape, const mus_drape *from, double *x)
{
    const mus_cloth *cloth = drape->cloth;
    if (cloth->npanel != from->cloth->npanel)
        return mus__fail(drape->context, MUS_ERR_ARG, "drape: %d panels cannot start where a cloth of %d panels lies",
                         (int)cloth->npanel, (int)from->cloth->npanel);
    if (cloth->npanel == 0 && drape->n != from->n)
        return mus__fail(drape->context, MUS_ERR_ARG, "drape: %d bare nodes cannot start where %d lie", (int)drape->n,
                         (int)from->n);
    mus__transfer transfer;
    const mus_status status = mus__transfer_build(drape->context, from->cloth, cloth, &transfer);
    if (status == MUS_OK) mus__transfer_apply(&transfer, from->x, x);
    mus__transfer_clear(drape->context, &transfer);
    if (cloth->npanel == 0) memcpy(x, from->x, 3 * (size_t)drape->n * sizeof *x);
    return status;
}


mus_status mus_drape_warm(mus_drape *drape, const mus_drape *from)
{
    if (drape == NULL) return MUS_ERR_ARG;
    if (from == NULL) return mus__fail(drape->context, MUS_ERR_ARG, "drape: the drape to start from is NULL");
    double *x = mus__new(drape->context, 3 * (int64_t)drape->n, sizeof *x);
    if (x == NULL) return mus__fail_memory(drape->context, "the places of another drape");
    const mus_status status = find_places(drape, from, x);
    if (status != MUS_OK) {
        mus__free(drape->context, x);
        return status;
    }
    drape->program.open_from = 0;
    memcpy(drape->x, x, 3 * (size_t)drape->n * sizeof *drape->x);
    mus__free(drape->context, x);
    memset(drape->v, 0, 3 * (size_t)drape->n * sizeof *drape->v);
    mus__drape_push(drape);
    if (from->welded)
        mus__weld_anew(drape);
    else
        mus__weld_open(drape);
    mus__drape_publish(drape);
    positions_begin(drape, 0);
    return MUS_OK;
}


mus_status mus_drape_set_state(mus_drape *drape, const double *positions, const double *velocities)
{
    if (drape == NULL) return MUS_ERR_ARG;
    if (positions == NULL) return mus__fail(drape->context, MUS_ERR_ARG, "drape: positions is NULL");
    mus_status status = mus__check_near(drape->context, drape->n, 3, positions, "drape: node");
    if (status != MUS_OK) return status;
    for (int64_t i = 0; i < 3 * (int64_t)drape->n; i++)
        if (velocities != NULL && !mus__finite(velocities[i]))
            return mus__fail(drape->context, MUS_ERR_ARG,
                             "drape: the velocity of node %d is %g m/s, which is not finite", (int)(i / 3),
                             velocities[i]);
    status = mus__drape_check_reach(drape, positions);
    if (status != MUS_OK) return status;

    const size_t bytes = 3 * (size_t)drape->n * sizeof *drape->x;
    memcpy(drape->x, positions, bytes);
    if (velocities != NULL)
        memcpy(drape->v, velocities, bytes);
    else
        memset(drape->v, 0, bytes);
    for (int32_t i = 0; i < drape->n; i++)
        if (drape->pinned[i]) memset(drape->v + 3 * i, 0, 3 * sizeof *drape->v);
    mus__drape_push(drape);
    mus__drape_publish(drape);
    mus__drape_lift_clear(drape);
    drape->relax.far = 1;
    drape->coarse.as_sewn = 0;
    return MUS_OK;
}


mus_status mus_drape_pin(mus_drape *drape, int32_t node, int32_t fixed)
{
    if (drape == NULL) return MUS_ERR_ARG;
    if (node < 0 || node >= drape->n)
        return mus__fail(drape->context, MUS_ERR_ARG, "drape: node %d, expected 0 to %d", (int)node, (int)drape->n - 1);
    const int32_t r = drape->rep[node], was = drape->pinned[r];
    drape->pinned[r] = fixed != 0 ? MUS__PINNED : 0;
    const mus_status status =
        mus__clamps_room(drape->context, drape->cloth, drape->pinned, MUS__PINNED, &drape->program);
    if (status != MUS_OK) drape->pinned[r] = was;
    if (status != MUS_OK) return status;
    mus__clamps_update(drape->cloth, drape->pinned, MUS__PINNED, &drape->program);
    drape->coarse.as_sewn = 0;
    if (fixed) {
        memset(drape->v + 3 * (int64_t)drape->rep[node], 0, 3 * sizeof *drape->v);
        mus__drape_push(drape);
        mus__drape_publish(drape);
    }
    mus__drape_stale(drape);
    return MUS_OK;
}
