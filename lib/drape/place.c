/*
 * place.c: panels to where the pattern says they start: flat or rolled, turned, moved (mus_placement). Bare nodes know
 * their places themselves.
 */
#include <math.h>
#include <string.h>

#include "drape/drape_internal.h"


/* place of the panel's point (x, y) in the body frame */
static void place_point(const mus_placement *place, double x, double y, double *out)
{
    double p[3] = {x, y, 0.0};
    if (place->bend != 0.0) {
        const double angle = (x - place->bend_x) / place->bend;
        p[0] = place->bend_x + place->bend * sin(angle);
        p[2] = place->bend * (cos(angle) - 1.0);
    }
    for (int32_t i = 0; i < 3; i++)
        out[i] = place->origin[i] + place->rotation[3 * i] * p[0] + place->rotation[3 * i + 1] * p[1] +
                 place->rotation[3 * i + 2] * p[2];
}


/* a node's place when its panel starts `out` farther along its normal */
static void place_node(const mus_cloth *cloth, int32_t i, double out, double *x)
{
    mus_placement place = cloth->panel[cloth->node_panel[i]].placement;
    if (out > 0.0) {
        for (int32_t d = 0; d < 3; d++) place.origin[d] += out * place.rotation[3 * d + 2];
        if (place.bend > 0.0) place.bend += out;
    }
    place_point(&place, cloth->rest[2 * (int64_t)i], cloth->rest[2 * (int64_t)i + 1], x + 3 * (int64_t)i);
}


void mus__cloth_place_out(const mus_cloth *cloth, int32_t layer, double out, double *x)
{
    for (int32_t i = 0; i < cloth->nnode; i++)
        if (mus__cloth_layer(cloth, i) == layer) place_node(cloth, i, out, x);
}


void mus__cloth_place(const mus_cloth *cloth, double *x)
{
    if (cloth->place != NULL) {
        memcpy(x, cloth->place, 3 * (size_t)cloth->nnode * sizeof *x);
        return;
    }
    for (int32_t i = 0; i < cloth->nnode; i++)
        place_node(cloth, i, MUS__LAYER_OUT * mus__cloth_layer(cloth, i), x);
}


mus_status mus_drape_place(mus_drape *drape)
{
    if (drape == NULL) return MUS_ERR_ARG;
    mus__cloth_place(drape->cloth, drape->x);
    memset(drape->v, 0, 3 * (size_t)drape->n * sizeof *drape->v);
    drape->plan.open_from = 0;
    mus__drape_open(drape);
    mus__drape_push(drape);
    mus__drape_publish(drape);
    drape->time0 = 0.0;
    drape->count = 0;
    drape->settled = 0;
    drape->cold = 1;
    drape->sewn_so = 0;
    mus__drape_stand_back(drape);
    return MUS_OK;
}


/* where the nodes of `drape` lie in the cloth of `from`; bare nodes have no panels and correspond one by one */
static mus_status find_places(mus_drape *drape, const mus_drape *from)
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
    if (status == MUS_OK) mus__transfer_apply(&transfer, from->x, drape->force);
    mus__transfer_clear(drape->context, &transfer);
    if (cloth->npanel == 0) memcpy(drape->force, from->x, 3 * (size_t)drape->n * sizeof *drape->force);
    return status;
}


mus_status mus_drape_warm(mus_drape *drape, const mus_drape *from)
{
    if (drape == NULL) return MUS_ERR_ARG;
    if (from == NULL) return mus__fail(drape->context, MUS_ERR_ARG, "drape: the drape to start from is NULL");
    const mus_status status = find_places(drape, from);
    if (status != MUS_OK) return status;
    drape->plan.open_from = 0;
    mus__drape_open(drape);
    memcpy(drape->x, drape->force, 3 * (size_t)drape->n * sizeof *drape->x);
    memset(drape->v, 0, 3 * (size_t)drape->n * sizeof *drape->v);
    mus__drape_push(drape);
    if (from->welded) mus__drape_weld(drape);
    mus__drape_publish(drape);
    drape->time0 = 0.0;
    drape->count = 0;
    drape->settled = 0;
    drape->cold = 0;
    drape->sewn_so = 0;
    mus__drape_stand_back(drape);
    return MUS_OK;
}
