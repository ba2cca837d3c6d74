/*
 * body_pose.c: a posed copy of a body, and the poses that a body was made in and stands in.
 *
 * The angles become frames of the parts (pose_frame.c); body_copy.c of lib/body makes the copy that stands there. A
 * pose is always that of the body as made, so posing a posed body does not add up.
 */
#include <string.h>

#include "body/body_internal.h"
#include "pose/pose_frame.h"


mus_status mus_body_pose(const mus_body *body, const mus_pose *pose, mus_body **out)
{
    if (out == NULL) return MUS_ERR_ARG;
    *out = NULL;
    if (body == NULL) return MUS_ERR_ARG;
    mus__joint_local local[MUS_JOINT_COUNT];
    mus__frame frame[MUS__PARTS_MOST];
    mus__stance stance;
    mus_status status = mus_pose_check(body->context, pose);
    if (status == MUS_OK) status = mus__pose_locals(body->context, &body->rig, pose, local);
    if (status != MUS_OK) return status;
    mus__pose_frames(&body->rig, local, frame);
    memcpy(stance.place, pose->place, sizeof stance.place);
    memcpy(stance.angle, pose->angle, sizeof stance.angle);
    return mus__body_copy(body, frame, &stance, out);
}


mus_status mus_body_rest_pose(const mus_body *body, mus_pose *pose)
{
    if (body == NULL || pose == NULL) return MUS_ERR_ARG;
    mus_pose_init(pose, sizeof *pose);
    memcpy(pose->angle, body->rig.rest, sizeof pose->angle);
    return MUS_OK;
}


mus_status mus_body_stance(const mus_body *body, mus_pose *pose)
{
    if (body == NULL || pose == NULL) return MUS_ERR_ARG;
    if (body->frame == NULL) return mus_body_rest_pose(body, pose);
    mus_pose_init(pose, sizeof *pose);
    memcpy(pose->place, body->stance.place, sizeof pose->place);
    memcpy(pose->angle, body->stance.angle, sizeof pose->angle);
    return MUS_OK;
}
