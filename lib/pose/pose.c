/*
 * pose.c: what a pose is: its defaults, the names of the joints.
 */
#include <string.h>

#include "base/base_internal.h"
#include "muslin/pose.h"


void mus_pose_init(mus_pose *pose, size_t size)
{
    mus_pose own = {0};
    mus__def_init(pose, size, &own, sizeof own);
}


const char *mus_joint_name(int32_t joint)
{
#define POSE_NAME(NAME, name) name,
    static const char *const names[] = {MUS_JOINT_LIST(POSE_NAME)};
#undef POSE_NAME
    return joint >= 0 && joint < MUS_JOINT_COUNT ? names[joint] : NULL;
}
