/*
 * pose_frame.h: where a pose puts the parts of a body.
 *
 * A pose becomes one mus__joint_local a joint once, with sines and cosines; blending two of them and the frames of the
 * parts take only + - * / and sqrt, so a step may ask for them.
 *
 *     turn_j = turn_parent * R(quaternion_j),   x = turn_j (x_rest - pivot_j) + the place of pivot_j + shift_j
 */
#ifndef MUS_POSE_POSE_FRAME_H
#define MUS_POSE_POSE_FRAME_H

#include "base/base_internal.h"
#include "body/rig.h"
#include "muslin/pose.h"

/* of one joint, in the directions of the rest pose: the rotation about its pivot (w, x, y, z), and how far the pivot
 * moved with its parent (the scapula; of the root: the place) */
typedef struct mus__joint_local {
    double quaternion[4], shift[3];
} mus__joint_local;

/* out (MUS_JOINT_COUNT). Errors: MUS_ERR_ARG, MUS_ERR_VERSION; limits are not looked at */
mus_status mus__pose_locals(mus_context *context, const mus__rig *rig, const mus_pose *pose, mus__joint_local *out);
/* t of the way from a to b, joint by joint; out may be a or b */
void mus__pose_blend(const mus__joint_local *a, const mus__joint_local *b, double t, mus__joint_local *out);
/* out (parts) */
void mus__pose_frames(const mus__rig *rig, const mus__joint_local *local, mus__frame *out);

#endif
