/*
 * scene_attachment.c: the level planes of the body that edges are attached to, moved with the parts of the body.
 *
 * An attached node below its level plane is pulled along the plane's normal, towards the root of its limb; no other
 * direction is constrained, so the node slides along the skin. The planes are those of the body in its rest pose
 * (body/body_level.h). When the body moves, the planes in the force program are moved with its parts. Coarse drapes
 * copy the planes of their parent.
 */
#include <string.h>

#include "drape/drape_state.h"
#include "geom/vec.h"

_Static_assert((int)MUS_HOLD_COUNT == (int)MUS__LEVEL_COUNT, "the levels of a pattern and of a body");


void mus__scene_level(const mus_drape *drape, int32_t level, int32_t right, mus__level_plane *out)
{
    while (drape->coarse.parent != NULL) drape = drape->coarse.parent;
    const mus__scene_body *stance = drape->scene.body;
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
    for (int32_t d = 0; d < 3; d++) out->point[d] = point[d] + drape->scene.collider->shift[d];
    out->at = mus__dot3(out->up, out->point);
}


double mus__scene_shoulder(const mus_drape *drape, double *neck)
{
    while (drape->coarse.parent != NULL) drape = drape->coarse.parent;
    *neck = drape->scene.body != NULL ? drape->scene.body->neck : 0.0;
    return drape->scene.body != NULL ? drape->scene.body->shoulder : 0.0;
}


void mus__scene_levels_update(mus_drape *drape)
{
    if (drape->cloth->nhold == 0) return;
    for (int32_t level = MUS_HOLD_NONE + 1; level < MUS_HOLD_COUNT; level++)
        for (int32_t right = 0; right < 2; right++)
            mus__scene_level(drape, level, right, &drape->program.level[level][right]);
}
