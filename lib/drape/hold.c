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
    mus__drape_frames(drape, 0, drape->dt);
}


void mus__drape_hold(mus_drape *drape)
{
    const mus_drape *root = drape;
    while (root->parent != NULL) root = root->parent;
    const mus__drape_stance *stance = root->stance;
    if (stance == NULL || drape->cloth->nhold == 0) return;
    const double *shift = root->collider->shift;
    for (int32_t level = MUS_HOLD_NONE + 1; level < MUS_HOLD_COUNT; level++)
        for (int32_t right = 0; right < 2; right++) {
            const mus__body_level *made = &stance->level[level][right];
            mus__held_level *now = &drape->plan.level[level][right];
            double point[3];
            memcpy(point, made->point, sizeof point);
            memcpy(now->up, made->up, sizeof now->up);
            now->there = made->there;
            if (made->there && stance->posed) {
                mus__frame_point(&stance->frame[made->part], point, point);
                mus__frame_turn(&stance->frame[made->part], now->up, now->up);
            }
            now->at = mus__dot3(now->up, point) + mus__dot3(now->up, shift);
        }
}
