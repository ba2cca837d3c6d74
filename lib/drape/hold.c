/*
 * hold.c: the levels of the body that edges are held at, as planes that move with its parts.
 *
 * A held node below its level is pulled up towards the root of its limb and nowhere else, so it slides along the skin
 * as it likes and never far down. Levels are found once, on the body as made (body/body_level.h); wherever the body is
 * put, the planes of the plan follow. Coarser doubles ask the drape that they belong to.
 */
#include <string.h>

#include "drape/drape_internal.h"
#include "geom/vec.h"


void mus__drape_levels(mus_drape *drape, const mus_body *body)
{
    for (int32_t level = MUS_HOLD_NONE + 1; level < MUS_HOLD_COUNT; level++)
        for (int32_t right = 0; right < 2; right++)
            mus__body_level_find(body, level, right, &drape->stance->level[level][right]);
    drape->stance->shoulder = mus__body_shoulder(body, &drape->stance->neck);
    mus__drape_frames(drape, 0, drape->dt);
}


void mus__drape_level(const mus_drape *drape, int32_t level, int32_t right, mus__held_level *out)
{
    while (drape->parent != NULL) drape = drape->parent;
    const mus__drape_stance *stance = drape->stance;
    memset(out, 0, sizeof *out);
    if (stance == NULL) return;
    const mus__body_level *made = &stance->level[level][right];
    double point[3];
    memcpy(point, made->point, sizeof point);
    memcpy(out->up, made->up, sizeof out->up);
    memcpy(out->side, made->side, sizeof out->side);
    out->there = made->there;
    if (made->there && stance->posed) {
        mus__frame_point(&stance->frame[made->part], point, point);
        mus__frame_turn(&stance->frame[made->part], out->up, out->up);
        mus__frame_turn(&stance->frame[made->part], out->side, out->side);
    }
    for (int32_t d = 0; d < 3; d++) out->point[d] = point[d] + drape->collider->shift[d];
    out->at = mus__dot3(out->up, out->point);
}


double mus__drape_shoulder(const mus_drape *drape, double *neck)
{
    while (drape->parent != NULL) drape = drape->parent;
    *neck = drape->stance != NULL ? drape->stance->neck : 0.0;
    return drape->stance != NULL ? drape->stance->shoulder : 0.0;
}


void mus__drape_hold(mus_drape *drape)
{
    if (drape->cloth->nhold == 0) return;
    for (int32_t level = MUS_HOLD_NONE + 1; level < MUS_HOLD_COUNT; level++)
        for (int32_t right = 0; right < 2; right++)
            mus__drape_level(drape, level, right, &drape->plan.level[level][right]);
}
