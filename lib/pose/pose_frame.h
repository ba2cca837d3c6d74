/*
 * pose_frame.h: where a pose puts the parts of a body.
 *
 * The angles of a pose become one mus__joint_local for each joint, with sines and cosines. Blending two sets of locals
 * and the frames of the parts take only + - * / and sqrt, so that a step of a drape may use them.
 *
 *     turn_j = turn_parent * R(quaternion_j),   x = turn_j (x_rest - pivot_j) + the place of pivot_j + shift_j
 */
#ifndef MUS_POSE_POSE_FRAME_H
#define MUS_POSE_POSE_FRAME_H

#include "base/base_internal.h"
#include "body/rig.h"
#include "muslin/pose.h"

/* the motion of one joint in the directions of the rest pose: the rotation about its pivot (w, x, y, z), and the shift
 * of the pivot (with the scapula; of the root: the place of the pose) [m] */
typedef struct mus__joint_local {
    double quaternion[4], shift[3];
} mus__joint_local;

/* locals (MUS_JOINT_COUNT) of a pose. Limits are not checked. Errors: MUS_ERR_ARG, MUS_ERR_VERSION; MUS_ERR_BODY (a
 * joint that a scan lacks is turned) */
mus_status mus__pose_locals(mus_context *context, const mus__rig *rig, const mus_pose *pose, mus__joint_local *out);
/* the part t (0 to 1) of the way from locals a to b, joint by joint; out may be a or b */
void mus__pose_blend(const mus__joint_local *a, const mus__joint_local *b, double t, mus__joint_local *out);
/* frames (parts) of the parts of a rig */
void mus__pose_frames(const mus__rig *rig, const mus__joint_local *local, mus__frame *out);

#endif
