/*
 * stance.c: a body that changes its pose while the cloth steps.
 *
 * A pose becomes rotations of joints at the door, with sines and cosines. Between two poses a step blends these, and
 * frames of the parts follow, by + - * / and sqrt alone (pose_frame.h). The body comes to stand exactly as asked: at the
 * end of a movement, and ever after, the frames are those of the pose itself.
 */
#include <math.h>
#include <string.h>

#include "drape/drape_internal.h"

#define STANCE_LONGEST 1e6 /* [s] */


mus_status mus__drape_stance_create(mus_drape *drape, const mus_body *body)
{
    mus__drape_stance *stance = mus__new(drape->context, 1, sizeof *stance);
    drape->stance = stance;
    if (stance == NULL) return mus__fail_memory(drape->context, "how the body stands");
    stance->rig = *mus__body_rig(body);
    stance->carried = mus__body_frames(body) != NULL;
    mus_status status = mus_body_stance(body, &stance->made);
    if (status == MUS_OK) status = mus__pose_locals(drape->context, &stance->rig, &stance->made, stance->as_made);
    if (status == MUS_OK) mus__drape_stance_back(drape);
    return status;
}


void mus__drape_stance_back(mus_drape *drape)
{
    mus__drape_stance *stance = drape->stance;
    if (stance == NULL) return;
    stance->from = stance->to = stance->made;
    memcpy(stance->start, stance->as_made, sizeof stance->start);
    memcpy(stance->end, stance->as_made, sizeof stance->end);
    stance->posed = stance->carried;
    stance->time = mus_drape_time(drape);
    stance->duration = 0.0;
}


/* part of the way to the pose, `steps` steps of h from now */
static double stance_part(const mus_drape *drape, int64_t steps, double h)
{
    const mus__drape_stance *stance = drape->stance;
    const double since = mus__drape_since(drape, stance->time, steps, h);
    return since < stance->duration ? fmax(since / stance->duration, 0.0) : 1.0;
}


int32_t mus__drape_poses(const mus_drape *drape, int64_t steps, double h)
{
    return drape->stance != NULL && stance_part(drape, steps, h) < 1.0;
}


const mus__frame *mus__drape_frames(mus_drape *drape, int64_t steps, double h)
{
    mus__drape_stance *stance = drape->stance;
    if (stance == NULL || !stance->posed) return NULL;
    mus__joint_local now[MUS_JOINT_COUNT];
    const double part = stance_part(drape, steps, h);
    if (part < 1.0) mus__pose_blend(stance->start, stance->end, part, now);
    mus__pose_frames(&stance->rig, part < 1.0 ? now : stance->end, stance->frame);
    return stance->frame;
}


/* the pose now, between the two poses angle by angle, without what the body has glided */
static void stance_now(const mus_drape *drape, mus_pose *out)
{
    const mus__drape_stance *stance = drape->stance;
    const double part = stance_part(drape, 0, drape->dt), *from = &stance->from.angle[0][0];
    const double *to = &stance->to.angle[0][0];
    *out = stance->to;
    if (!(part < 1.0)) return;
    for (int32_t i = 0; i < 3 * MUS_JOINT_COUNT; i++) (&out->angle[0][0])[i] = from[i] + part * (to[i] - from[i]);
    for (int32_t i = 0; i < 3; i++)
        out->place[i] = stance->from.place[i] + part * (stance->to.place[i] - stance->from.place[i]);
}


mus_status mus_drape_pose_body(mus_drape *drape, const mus_pose *pose, double duration)
{
    if (drape == NULL) return MUS_ERR_ARG;
    mus_context *context = drape->context;
    mus__drape_stance *stance = drape->stance;
    if (stance == NULL) return mus__fail(context, MUS_ERR_STATE, "drape: there is no body to pose");
    if (!(duration >= 0.0 && duration <= STANCE_LONGEST))
        return mus__fail(context, MUS_ERR_ARG, "drape: duration of a movement is %g s, expected 0 to %g", duration,
                         STANCE_LONGEST);
    mus__joint_local end[MUS_JOINT_COUNT];
    mus_status status = mus_pose_check(context, pose);
    if (status == MUS_OK) status = mus__pose_locals(context, &stance->rig, pose, end);
    if (status != MUS_OK) return status;

    /* from how it stands now */
    const double part = stance_part(drape, 0, drape->dt);
    mus_pose now;
    stance_now(drape, &now);
    mus__pose_blend(stance->start, stance->end, part, stance->start);
    if (!(part < 1.0)) memcpy(stance->start, stance->end, sizeof stance->start);
    stance->from = now;
    stance->to = *pose;
    memcpy(stance->end, end, sizeof end);
    stance->posed = 1;
    stance->time = mus_drape_time(drape);
    stance->duration = duration;
    if (duration > 0.0) return MUS_OK;
    mus__drape_stand(drape, 0, drape->dt, 0.0);
    drape->moved = 1;
    drape->settled = 0;
    drape->residual = NAN;
    memset(drape->sim.aside, 0, (size_t)drape->n * sizeof *drape->sim.aside);
    return MUS_OK;
}


mus_status mus_drape_body_pose(const mus_drape *drape, mus_pose *out)
{
    if (drape == NULL) return MUS_ERR_ARG;
    if (out == NULL) return mus__fail(drape->context, MUS_ERR_ARG, "drape: out is NULL");
    if (drape->stance == NULL) return mus__fail(drape->context, MUS_ERR_STATE, "drape: there is no body");
    stance_now(drape, out);
    for (int32_t i = 0; i < 3; i++) out->place[i] += drape->collider->shift[i];
    return MUS_OK;
}
