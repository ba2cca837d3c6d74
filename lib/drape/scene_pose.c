/*
 * scene_pose.c: takes the body to another pose while the cloth steps.
 *
 * A pose becomes rotations of joints once, with sines and cosines. Between two poses a step blends these rotations, and
 * the frames of the parts follow, by + - * / and sqrt alone (pose/pose_frame.h). The body stands exactly as asked at
 * the end of a movement: from there on the frames are those of the pose itself.
 *
 * The scene calls this file through a function that the first movement leaves in it (mus__scene_body.carry). A program
 * that never poses a body during a drape links nothing of lib/pose for it.
 */
#include <math.h>
#include <string.h>

#include "drape/drape_state.h"

#define MOVEMENT_MAX 1e6 /* [s] longest movement from one pose to another */


/* put the parts where they are when `part` (0 to 1) of the movement is done */
static void carry_parts(mus__scene_body *stance, double part)
{
    mus__joint_local now[MUS_JOINT_COUNT];
    if (part < 1.0) mus__pose_blend(stance->start, stance->end, part, now);
    mus__pose_frames(&stance->rig, part < 1.0 ? now : stance->end, stance->frame);
}


/* before the first movement: the joints as the body came. Errors: those of mus__pose_locals() */
static mus_status start_from_made(mus_drape *drape)
{
    mus__scene_body *stance = drape->scene.body;
    const mus_status status = mus__pose_locals(drape->context, &stance->rig, &stance->made, stance->as_made);
    if (status != MUS_OK) return status;
    memcpy(stance->start, stance->as_made, sizeof stance->start);
    memcpy(stance->end, stance->as_made, sizeof stance->end);
    stance->carry = carry_parts;
    return MUS_OK;
}


mus_status mus_drape_pose_body(mus_drape *drape, const mus_pose *pose, double duration)
{
    if (drape == NULL) return MUS_ERR_ARG;
    mus_context *context = drape->context;
    mus__scene_body *stance = drape->scene.body;
    if (stance == NULL) return mus__fail(context, MUS_ERR_STATE, "drape: there is no body to pose");
    if (!(duration >= 0.0 && duration <= MOVEMENT_MAX))
        return mus__fail(context, MUS_ERR_ARG, "drape: duration of a movement is %g s, expected 0 to %g", duration,
                         MOVEMENT_MAX);
    mus__joint_local end[MUS_JOINT_COUNT];
    mus_status status = mus_pose_check(context, pose);
    if (status == MUS_OK) status = mus__pose_locals(context, &stance->rig, pose, end);
    if (status == MUS_OK && stance->carry == NULL) status = start_from_made(drape);
    if (status != MUS_OK) return status;

    /* the movement starts from the pose as it is now */
    const double part = mus__scene_body_part(drape, 0, drape->clock.dt);
    mus_pose now;
    mus__scene_body_pose(drape, &now);
    mus__pose_blend(stance->start, stance->end, part, stance->start);
    if (!(part < 1.0)) memcpy(stance->start, stance->end, sizeof stance->start);
    stance->from = now;
    stance->to = *pose;
    memcpy(stance->end, end, sizeof end);
    stance->posed = 1;
    stance->time = mus_drape_time(drape);
    stance->duration = duration;
    if (duration > 0.0) return MUS_OK;
    mus__scene_update(drape, 0, drape->clock.dt, 0.0);
    drape->scene.moved = 1;
    drape->relax.settled = 0;
    drape->relax.residual = NAN;
    memset(drape->sim.distance_cache, 0, (size_t)drape->n * sizeof *drape->sim.distance_cache);
    return MUS_OK;
}
