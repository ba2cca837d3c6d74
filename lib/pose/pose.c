/*
 * pose.c: the defaults of a pose and the names of joints. A stranger starts here.
 *
 * The room turns the joints of a body (lib/body/rig.h). Its files in the order of use:
 *
 *     pose.c            defaults, names of joints (this file)
 *     pose_table.c      limits of joints, named poses
 *     pose_frame.c      from the angles of a pose to the frames of a body's parts; used by lib/drape in each step
 *     body_pose.c       a posed copy of a body
 *     pose_stand.c      a pose put on the floor: legs bent so that the standing feet reach it
 *     pose_fit.c        arms off the sides; a movement fitted to a body
 *     movement.c        movements: splines through poses at times
 *     movement_table.c  named movements
 */
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
