/*
 * pose_table.c: the limits of each joint, and the named poses.
 *
 * Limits are the normal ranges of motion of the American Academy of Orthopaedic Surgeons, Joint Motion, 1965, in
 * degrees; the root has none.
 */
#include <math.h>
#include <string.h>

#include "base/base_internal.h"
#include "geom/vec.h"
#include "muslin/pose.h"
#include "pose/pose_table.h"

#define POSE_DEGREE (MUS_PI / 180.0)
/* [m] largest distance of a pose's root from its place in the rest pose; chosen: a larger one loses digits of float
 * states */
#define POSE_FAR 1e3
#define POSE_ROUNDING 1e-9 /* [rad] an angle may exceed its limit by this: rounding of degrees to radian */

/* least and greatest flexion, abduction, rotation [degrees] */
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


/* flexion, abduction, rotation of a joint in a named pose [degrees]; with `both` also of the right joint of a left
 * one */
typedef struct pose_row {
    int32_t joint;
    bool both;
    double angle[3];
} pose_row;

#define POSE_BOTH (MUS_FOOT_LEFT | MUS_FOOT_RIGHT)
#define POSE_ROWS 12 /* most rows of a pose; joints without a row have the angles 0 */

/* Hanging arms are abducted so far that hips and two layers of cloth fit between; in poses that bend the trunk the arms
 * hang vertically. The feet of standing legs are flat: dorsiflexion = knee - (hip - root). */
static const struct {
    const char *name;
    int32_t feet; /* that stand */
    pose_row row[POSE_ROWS];
} pose_named[] = {
    {"a", POSE_BOTH, {{MUS_JOINT_SHOULDER_LEFT, true, {5, 42, 0}}}},
    {"t", POSE_BOTH, {{MUS_JOINT_SHOULDER_LEFT, true, {0, 90, 0}}}},
    {"arms_down", POSE_BOTH, {{MUS_JOINT_SHOULDER_LEFT, true, {4, 15, 0}}, {MUS_JOINT_ELBOW_LEFT, true, {12, 0, 0}}}},
    {"arms_raised", POSE_BOTH, {{MUS_JOINT_SHOULDER_LEFT, true, {0, 170, 0}}}},
    {"arms_forward", POSE_BOTH, {{MUS_JOINT_SHOULDER_LEFT, true, {85, 8, 0}}, {MUS_JOINT_ELBOW_LEFT, true, {5, 0, 0}}}},
    {"hands_on_hips", POSE_BOTH,
     {{MUS_JOINT_SHOULDER_LEFT, true, {-25, 46, 66}},
      {MUS_JOINT_ELBOW_LEFT, true, {98, 0, 0}},
      {MUS_JOINT_WRIST_LEFT, true, {-60, 0, 0}}}},
    {"step", POSE_BOTH,
     {{MUS_JOINT_HIP_LEFT, false, {26, 2, 0}},
      {MUS_JOINT_HIP_RIGHT, false, {-16, 2, 0}},
      {MUS_JOINT_KNEE_LEFT, false, {8, 0, 0}},
      {MUS_JOINT_KNEE_RIGHT, false, {14, 0, 0}},
      {MUS_JOINT_ANKLE_LEFT, false, {2, 0, 0}},
      {MUS_JOINT_ANKLE_RIGHT, false, {8, 0, 0}},
      {MUS_JOINT_SHOULDER_LEFT, false, {-16, 18, 0}},
      {MUS_JOINT_SHOULDER_RIGHT, false, {20, 18, 0}},
      {MUS_JOINT_ELBOW_LEFT, true, {20, 0, 0}}}},
    {"lunge", POSE_BOTH,
     {{MUS_JOINT_HIP_LEFT, false, {78, 4, 0}},
      {MUS_JOINT_KNEE_LEFT, false, {82, 0, 0}},
      {MUS_JOINT_ANKLE_LEFT, false, {4, 0, 0}},
      {MUS_JOINT_HIP_RIGHT, false, {-22, 4, 0}},
      {MUS_JOINT_KNEE_RIGHT, false, {30, 0, 0}},
      {MUS_JOINT_ANKLE_RIGHT, false, {10, 0, 0}},
      {MUS_JOINT_SHOULDER_LEFT, true, {5, 20, 0}},
      {MUS_JOINT_ELBOW_LEFT, true, {25, 0, 0}}}},
    {"sit", POSE_BOTH,
     {{MUS_JOINT_HIP_LEFT, true, {90, 7, 0}},
      {MUS_JOINT_KNEE_LEFT, true, {90, 0, 0}},
      {MUS_JOINT_LUMBAR, false, {10, 0, 0}},
      {MUS_JOINT_NECK, false, {-8, 0, 0}},
      {MUS_JOINT_SHOULDER_LEFT, true, {18, 14, 0}},
      {MUS_JOINT_ELBOW_LEFT, true, {72, 0, 0}}}},
    {"squat", POSE_BOTH,
     {{MUS_JOINT_ROOT, false, {20, 0, 0}},
      {MUS_JOINT_HIP_LEFT, true, {118, 15, 0}},
      {MUS_JOINT_KNEE_LEFT, true, {116, 0, 0}},
      {MUS_JOINT_ANKLE_LEFT, true, {18, 0, 0}},
      {MUS_JOINT_LUMBAR, false, {22, 0, 0}},
      {MUS_JOINT_NECK, false, {-25, 0, 0}},
      {MUS_JOINT_SHOULDER_LEFT, true, {110, 10, 0}},
      {MUS_JOINT_ELBOW_LEFT, true, {10, 0, 0}}}},
    {"kneel", 0,
     {{MUS_JOINT_HIP_LEFT, true, {0, 5, 0}},
      {MUS_JOINT_KNEE_LEFT, true, {90, 0, 0}},
      {MUS_JOINT_ANKLE_LEFT, true, {-50, 0, 0}},
      {MUS_JOINT_SHOULDER_LEFT, true, {4, 18, 0}},
      {MUS_JOINT_ELBOW_LEFT, true, {12, 0, 0}}}},
    {"bend", POSE_BOTH,
     {{MUS_JOINT_ROOT, false, {45, 0, 0}},
      {MUS_JOINT_HIP_LEFT, true, {45, 3, 0}},
      {MUS_JOINT_LUMBAR, false, {40, 0, 0}},
      {MUS_JOINT_NECK, false, {10, 0, 0}},
      {MUS_JOINT_SHOULDER_LEFT, true, {85, 6, 0}},
      {MUS_JOINT_ELBOW_LEFT, true, {8, 0, 0}}}},
    {"side_bend", POSE_BOTH,
     {{MUS_JOINT_LUMBAR, false, {0, 24, 0}},
      {MUS_JOINT_NECK, false, {0, 12, 0}},
      {MUS_JOINT_SHOULDER_LEFT, false, {4, 30, 0}},
      {MUS_JOINT_SHOULDER_RIGHT, false, {0, 150, 0}}}},
    {"twist", POSE_BOTH,
     {{MUS_JOINT_LUMBAR, false, {0, 0, 30}},
      {MUS_JOINT_NECK, false, {0, 0, 30}},
      {MUS_JOINT_SHOULDER_LEFT, true, {5, 42, 0}},
      {MUS_JOINT_ELBOW_LEFT, true, {20, 0, 0}}}},
    {"reach", POSE_BOTH,
     {{MUS_JOINT_LUMBAR, false, {-4, 6, 0}},
      {MUS_JOINT_NECK, false, {-20, 0, 0}},
      {MUS_JOINT_SHOULDER_RIGHT, false, {155, 5, 0}},
      {MUS_JOINT_SHOULDER_LEFT, false, {4, 18, 0}},
      {MUS_JOINT_ELBOW_LEFT, false, {12, 0, 0}}}},
    {"knee_up", MUS_FOOT_RIGHT,
     {{MUS_JOINT_HIP_LEFT, false, {95, 3, 0}},
      {MUS_JOINT_KNEE_LEFT, false, {95, 0, 0}},
      {MUS_JOINT_SHOULDER_LEFT, true, {4, 30, 0}},
      {MUS_JOINT_ELBOW_LEFT, true, {12, 0, 0}}}},
};

#define POSE_COUNT ((int32_t)(sizeof pose_named / sizeof *pose_named))


int32_t mus_pose_count(void)
{
    return POSE_COUNT;
}


const char *mus_pose_name(int32_t pose)
{
    return pose >= 0 && pose < POSE_COUNT ? pose_named[pose].name : NULL;
}


/* index of a named pose; POSE_COUNT: the name is unknown */
static int32_t pose_index(const char *name)
{
    int32_t i = 0;
    while (i < POSE_COUNT && strcmp(pose_named[i].name, name) != 0) i++;
    return i;
}


int32_t mus_pose_feet(const char *name)
{
    const int32_t i = name != NULL ? pose_index(name) : POSE_COUNT;
    return i < POSE_COUNT ? pose_named[i].feet : 0;
}


bool mus__pose_find(const char *name, mus_pose *out)
{
    const int32_t i = pose_index(name);
    if (i == POSE_COUNT) return false;
    mus_pose_init(out, sizeof *out);
    for (const pose_row *row = pose_named[i].row; row < pose_named[i].row + POSE_ROWS; row++)
        for (int32_t side = 0; side < (row->both ? 2 : 1); side++)
            for (int k = 0; k < 3; k++) out->angle[row->joint + side][k] += POSE_DEGREE * row->angle[k];
    return true;
}


mus_status mus_pose_named(mus_context *context, const char *name, mus_pose *out)
{
    if (context == NULL) return MUS_ERR_ARG;
    if (name == NULL || out == NULL) return mus__fail(context, MUS_ERR_ARG, "mus_pose_named: name or out is NULL");
    if (mus__pose_find(name, out)) return MUS_OK;
    return mus__fail(context, MUS_ERR_ARG, "no pose is called \"%.60s\"", name);
}


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
