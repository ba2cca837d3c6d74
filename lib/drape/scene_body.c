/*
 * scene_body.c: the pose of a body that moves while the cloth steps.
 *
 * A pose becomes rotations of joints once, with sines and cosines. Between two poses a step blends these rotations, and
 * the frames of the parts follow, by + - * / and sqrt alone (pose/pose_frame.h). The body stands exactly as asked at
 * the end of a movement: from there on the frames are those of the pose itself.
 */
#include <math.h>
#include <string.h>

#include "drape/drape_state.h"


mus_status mus__scene_body_create(mus_drape *drape, const mus_body *body)
{
    mus__scene_body *stance = mus__new(drape->context, 1, sizeof *stance);
    drape->scene.body = stance;
    if (stance == NULL) return mus__fail_memory(drape->context, "how the body stands");
    stance->rig = *mus__body_rig(body);
    stance->came_posed = mus__body_frames(body) != NULL;
    mus_status status = mus_body_stance(body, &stance->made);
    if (status == MUS_OK) status = mus__pose_locals(drape->context, &stance->rig, &stance->made, stance->as_made);
    if (status == MUS_OK) mus__scene_body_reset(drape);
    return status;
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
    mus__joint_local now[MUS_JOINT_COUNT];
    const double part = mus__scene_body_part(drape, steps, h);
    if (part < 1.0) mus__pose_blend(stance->start, stance->end, part, now);
    mus__pose_frames(&stance->rig, part < 1.0 ? now : stance->end, stance->frame);
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
