/*
 * scene_body.c: how the body of a drape stands, as it came or in a movement to another pose (scene_pose.c).
 */
#include <math.h>
#include <string.h>

#include "body/body_internal.h"
#include "drape/drape_state.h"


mus_status mus__scene_body_create(mus_drape *drape, const mus_body *body)
{
    mus__scene_body *stance = drape->scene.body = mus__new(drape->context, 1, sizeof *stance);
    if (stance == NULL) return mus__fail_memory(drape->context, "how the body stands");
    stance->rig = body->rig;
    stance->came_posed = body->frame != NULL;
    stance->made.size = sizeof stance->made;
    memcpy(stance->made.angle, stance->came_posed ? body->stance.angle : body->rig.rest, sizeof stance->made.angle);
    if (stance->came_posed) {
        memcpy(stance->made.place, body->stance.place, sizeof stance->made.place);
        memcpy(stance->frame, body->frame, (size_t)body->rig.parts * sizeof *body->frame);
    }
    memcpy(stance->level, body->level, sizeof stance->level);
    stance->neck = body->measured ? body->skeleton.neck_side_x : 0.0;
    stance->shoulder = body->measured ? body->skeleton.shoulder_end : 0.0;
    mus__scene_body_reset(drape);
    return MUS_OK;
}


void mus__scene_body_reset(mus_drape *drape)
{
    mus__scene_body *stance = drape->scene.body;
    if (stance == NULL) return;
    stance->from = stance->to = stance->made;
    memcpy(stance->start, stance->as_made, sizeof stance->start);
    memcpy(stance->end, stance->as_made, sizeof stance->end);
    stance->posed = stance->came_posed;
    stance->time = mus_drape_time(drape);
    stance->duration = 0.0;
}


double mus__scene_body_part(const mus_drape *drape, int64_t steps, double h)
{
    const mus__scene_body *stance = drape->scene.body;
    const double since = mus__clock_since(drape, stance->time, steps, h);
    return since < stance->duration ? fmax(since / stance->duration, 0.0) : 1.0;
}


int32_t mus__scene_body_poses(const mus_drape *drape, int64_t steps, double h)
{
    return drape->scene.body != NULL && mus__scene_body_part(drape, steps, h) < 1.0;
}


const mus__frame *mus__scene_body_frames(mus_drape *drape, int64_t steps, double h)
{
    mus__scene_body *stance = drape->scene.body;
    if (stance == NULL || !stance->posed) return NULL;
    if (stance->carry != NULL) stance->carry(stance, mus__scene_body_part(drape, steps, h));
    return stance->frame;
}


void mus__scene_body_pose(const mus_drape *drape, mus_pose *out)
{
    const mus__scene_body *stance = drape->scene.body;
    const double part = mus__scene_body_part(drape, 0, drape->clock.dt), *from = &stance->from.angle[0][0];
    const double *to = &stance->to.angle[0][0];
    *out = stance->to;
    if (!(part < 1.0)) return;
    for (int32_t i = 0; i < 3 * MUS_JOINT_COUNT; i++) (&out->angle[0][0])[i] = from[i] + part * (to[i] - from[i]);
    for (int32_t i = 0; i < 3; i++)
        out->place[i] = stance->from.place[i] + part * (stance->to.place[i] - stance->from.place[i]);
}


mus_status mus_drape_body_pose(const mus_drape *drape, mus_pose *out)
{
    if (drape == NULL) return MUS_ERR_ARG;
    if (out == NULL) return mus__fail(drape->context, MUS_ERR_ARG, "drape: out is NULL");
    if (drape->scene.body == NULL) return mus__fail(drape->context, MUS_ERR_STATE, "drape: there is no body");
    mus__scene_body_pose(drape, out);
    for (int32_t i = 0; i < 3; i++) out->place[i] += drape->scene.collider->shift[i];
    return MUS_OK;
}
