/*
 * pose_table.c: how far each joint turns, and the poses that have a name.
 *
 * Limits are the normal ranges of motion of the American Academy of Orthopaedic Surgeons (Joint Motion, 1965), in
 * degrees; the root turns as it likes.
 */
#include <math.h>

#include "base/base_internal.h"
#include "geom/vec.h"
#include "muslin/pose.h"

#define POSE_DEGREE (MUS_PI / 180.0)
#define POSE_FAR 1e3          /* [m] */
#define POSE_ROUNDING 1e-9 /* [rad] beyond a limit that is still within it */

/* low and high of flexion, abduction, rotation [degrees] */
#define POSE_TRUNK_LIMITS {{-25, 60}, {-25, 25}, {-30, 30}}
#define POSE_NECK_LIMITS {{-45, 45}, {-45, 45}, {-60, 60}}
#define POSE_SHOULDER_LIMITS {{-60, 180}, {-50, 180}, {-90, 90}}
#define POSE_ELBOW_LIMITS {{0, 150}, {0, 0}, {-80, 80}}
#define POSE_WRIST_LIMITS {{-70, 80}, {-30, 20}, {0, 0}}
#define POSE_HIP_LIMITS {{-30, 120}, {-30, 45}, {-45, 45}}
#define POSE_KNEE_LIMITS {{0, 135}, {0, 0}, {0, 0}}
#define POSE_ANKLE_LIMITS {{-50, 20}, {-35, 20}, {-15, 15}}

static const double pose_limits[MUS_JOINT_COUNT][3][2] = {
    {{-180, 180}, {-180, 180}, {-180, 180}},
    POSE_TRUNK_LIMITS,
    POSE_NECK_LIMITS,
    POSE_SHOULDER_LIMITS,
    POSE_SHOULDER_LIMITS,
    POSE_ELBOW_LIMITS,
    POSE_ELBOW_LIMITS,
    POSE_WRIST_LIMITS,
    POSE_WRIST_LIMITS,
    POSE_HIP_LIMITS,
    POSE_HIP_LIMITS,
    POSE_KNEE_LIMITS,
    POSE_KNEE_LIMITS,
    POSE_ANKLE_LIMITS,
    POSE_ANKLE_LIMITS,
};


mus_status mus_joint_limits(int32_t joint, int32_t axis, double *low, double *high)
{
    if (joint < 0 || joint >= MUS_JOINT_COUNT || axis < 0 || axis > 2 || low == NULL || high == NULL)
        return MUS_ERR_ARG;
    *low = POSE_DEGREE * pose_limits[joint][axis][0];
    *high = POSE_DEGREE * pose_limits[joint][axis][1];
    return MUS_OK;
}


mus_status mus_pose_check(mus_context *context, const mus_pose *pose)
{
    static const char *const axes[] = {"flexion", "abduction", "rotation"};
    if (context == NULL) return MUS_ERR_ARG;
    if (pose == NULL) return mus__fail(context, MUS_ERR_ARG, "the pose is NULL");
    if (pose->size != sizeof *pose)
        return mus__fail(context, MUS_ERR_VERSION, "mus_pose.size %zu is unknown; use mus_pose_init", pose->size);
    for (int i = 0; i < 3; i++)
        if (!(fabs(pose->place[i]) <= POSE_FAR))
            return mus__fail(context, MUS_ERR_ARG, "mus_pose.place[%d] is %g m, expected %g to %g", i, pose->place[i],
                             -POSE_FAR, POSE_FAR);
    for (int32_t j = 0; j < MUS_JOINT_COUNT; j++)
        for (int k = 0; k < 3; k++) {
            const double angle = pose->angle[j][k] / POSE_DEGREE, low = pose_limits[j][k][0];
            const double high = pose_limits[j][k][1], slack = POSE_ROUNDING / POSE_DEGREE;
            if (angle >= low - slack && angle <= high + slack) continue;
            return mus__fail(context, mus__finite(angle) ? MUS_ERR_BODY : MUS_ERR_ARG,
                             "mus_pose.angle: %s %s is %.4g degrees, expected %g to %g", mus_joint_name(j), axes[k],
                             angle, low, high);
        }
    return MUS_OK;
}
