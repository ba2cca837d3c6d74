/*
 * pose_frame.c: from the angles of a pose to the frames of a body's parts.
 *
 * A joint turns by Q = R(flexion) R(abduction) R(rotation) from the anatomical pose. With the parent's rotation P from
 * the anatomical to the rest pose, and Q0 the rotation of the joint itself in the rest pose, its rotation from the rest
 * pose, in the directions of the rest pose, is  P Q Q0* P*,  the identity for Q = Q0.
 *
 * A shoulder joint moves up and inwards with the scapula while the arm rises from 30 to 170 degrees.
 *
 * The flexion of the trunk against the thighs is shared by hip joints and lumbar spine. A pose gives the two apart;
 * where the hips have more than their share, as in sitting, the pelvis tilts backwards under a chest that keeps its
 * direction, about the axis through the hip joints. Legs keep their places, so that standing feet stay.
 */
#include "pose/pose_frame.h"

#include <math.h>
#include <string.h>

#include "base/elementary.h"
#include "geom/vec.h"

/* shift of a shoulder joint inwards over its shift upwards; chosen: more narrows raised shoulders */
#define POSE_SCAPULA_IN 0.5

/* share of the lumbar spine in the flexion of the trunk against the thighs: 41.6 of 111 degrees. Source: Esola,
 * McClure, Fitzgerald and Siegler, Analysis of Lumbar Spine and Hip Motion during Forward Bending, 1996 */
#define POSE_SPINE 0.375

_Static_assert(MUS__FLEXION == MUS_POSE_FLEXION && MUS__ABDUCTION == MUS_POSE_ABDUCTION, "one order of the angles");


/* share of the scapula's rise for a shoulder turned by the quaternion `turn`: 0 up to 30 degrees off hanging, 1 at
 * 170 */
static double pose_lift(const double *turn)
{
    double down[3] = {0.0, -1.0, 0.0}, m[9];
    mus__quaternion_matrix(turn, m);
    mus__matrix_point(m, down, down);
    double lift = mus__acos(fmin(fmax(-down[1], -1.0), 1.0));
    return fmax(lift - MUS_PI / 6.0, 0.0) / (140.0 * MUS_PI / 180.0);
}


mus_status mus__pose_locals(mus_context *context, const mus__rig *rig, const mus_pose *pose, mus__joint_local *out)
{
    if (pose == NULL) return mus__fail(context, MUS_ERR_ARG, "the pose is NULL");
    if (pose->size != sizeof *pose)
        return mus__fail(context, MUS_ERR_VERSION, "mus_pose.size %zu is unknown; use mus_pose_init", pose->size);

    for (int32_t j = 0; j < MUS_JOINT_COUNT; j++) {
        double turn[4], rest[4], back[4];
        for (int k = 0; k < 3; k++)
            if (!mus__finite(pose->angle[j][k]))
                return mus__fail(context, MUS_ERR_ARG, "mus_pose.angle of %s is not finite", mus_joint_name(j));
        for (int k = 0; k < 3 && rig->missing[j]; k++)
            if (pose->angle[j][k] != 0.0)
                return mus__fail(context, MUS_ERR_BODY,
                                 "%s is asked to turn by %g degrees, and the scan has no such limb: set it to 0",
                                 mus_joint_name(j), pose->angle[j][k] * 180.0 / MUS_PI);
        mus__joint_turn(j, pose->angle[j], turn);
        mus__joint_turn(j, rig->rest[j], rest);
        memset(&out[j], 0, sizeof out[j]);
        if (j == MUS_JOINT_ROOT) memcpy(out[j].shift, pose->place, sizeof out[j].shift);
        if (j == MUS_JOINT_SHOULDER_LEFT || j == MUS_JOINT_SHOULDER_RIGHT) {
            double up = rig->scapula * (pose_lift(turn) - pose_lift(rest));
            out[j].shift[0] = (j == MUS_JOINT_SHOULDER_RIGHT ? POSE_SCAPULA_IN : -POSE_SCAPULA_IN) * up;
            out[j].shift[1] = up;
        }

        /* P Q Q0* P* */
        mus__quaternion_conjugate(rest, back);
        mus__quaternion_product(turn, back, turn);
        mus__quaternion_product(rig->parent_stand[j], turn, turn);
        mus__quaternion_conjugate(rig->parent_stand[j], back);
        mus__quaternion_product(turn, back, out[j].quaternion);
        mus__quaternion_normalise(out[j].quaternion);
    }
    return MUS_OK;
}


void mus__pose_blend(const mus__joint_local *a, const mus__joint_local *b, double t, mus__joint_local *out)
{
    for (int32_t j = 0; j < MUS_JOINT_COUNT; j++) {
        /* q and -q are one rotation: the nearer one is taken */
        const double *p = a[j].quaternion, *q = b[j].quaternion;
        double sign = p[0] * q[0] + p[1] * q[1] + p[2] * q[2] + p[3] * q[3] < 0.0 ? -1.0 : 1.0;
        for (int i = 0; i < 4; i++) out[j].quaternion[i] = (1.0 - t) * p[i] + t * sign * q[i];
        mus__quaternion_normalise(out[j].quaternion);
        for (int i = 0; i < 3; i++) out[j].shift[i] = (1.0 - t) * a[j].shift[i] + t * b[j].shift[i];
    }
}


/* the flexion in a local: cosine and sine (2) of half the angle about X */
static void pose_flexion(const mus__joint_local *local, double *out)
{
    const double w = local->quaternion[0], x = local->quaternion[1], length = sqrt(w * w + x * x + 1e-30);
    out[0] = fabs(w) / length, out[1] = (w < 0.0 ? -x : x) / length;
}


/* frame of the pelvis, from that of the root. Part u of a flexion is taken on the chord: the quaternion
 * (1 - u + u w, u x), scaled to length 1, is within 1.5 degrees of the angle's part */
static void pose_pelvis(const mus__rig *rig, const mus__joint_local *local, const mus__frame *root, mus__frame *out)
{
    double left[2], right[2], spine[2], middle[3], back[3], tilt[9];
    pose_flexion(&local[MUS_JOINT_HIP_LEFT], left);
    pose_flexion(&local[MUS_JOINT_HIP_RIGHT], right);
    pose_flexion(&local[MUS_JOINT_LUMBAR], spine);
    if (spine[1] < 0.0) spine[0] = 1.0, spine[1] = 0.0; /* a trunk bent backwards leaves the pelvis to the hips */
    const double both = sqrt((left[0] + right[0]) * (left[0] + right[0]) + (left[1] + right[1]) * (left[1] + right[1]));
    const double hip[2] = {1.0 - POSE_SPINE + POSE_SPINE * (left[0] + right[0]) / both,
                           POSE_SPINE * (left[1] + right[1]) / both};
    const double lumbar[2] = {POSE_SPINE + (1.0 - POSE_SPINE) * spine[0], (1.0 - POSE_SPINE) * spine[1]};
    double q[4] = {hip[0] * lumbar[0] - hip[1] * lumbar[1], hip[0] * lumbar[1] + hip[1] * lumbar[0], 0.0, 0.0};
    *out = *root;
    if (q[1] >= 0.0) return; /* the spine has its share */
    mus__quaternion_normalise(q);
    mus__quaternion_matrix(q, tilt);
    mus__matrix_product(root->turn, tilt, out->turn);
    mus__frame_point(root, rig->pivot[MUS_JOINT_ROOT], middle);
    mus__matrix_point(out->turn, rig->pivot[MUS_JOINT_ROOT], back);
    for (int i = 0; i < 3; i++) out->place[i] = middle[i] - back[i];
}


void mus__pose_frames(const mus__rig *rig, const mus__joint_local *local, mus__frame *out)
{
    mus__frame joint[MUS_JOINT_COUNT], own, pelvis;
    for (int32_t j = 0; j < MUS_JOINT_COUNT; j++) {
        const int32_t parent = rig->parent[j];
        double pivot[3], back[3];
        mus__quaternion_matrix(local[j].quaternion, own.turn);
        for (int i = 0; i < 3; i++) pivot[i] = rig->pivot[j][i] + local[j].shift[i];
        if (parent == MUS_NONE) {
            joint[j] = own;
        } else {
            mus__matrix_product(joint[parent].turn, own.turn, joint[j].turn);
            mus__frame_point(j == MUS_JOINT_LUMBAR ? &pelvis : &joint[parent], pivot, pivot);
        }

        /* the place follows from the pivot, which the parent's frame moves */
        mus__matrix_point(joint[j].turn, rig->pivot[j], back);
        for (int i = 0; i < 3; i++) joint[j].place[i] = pivot[i] - back[i];
        if (j == MUS_JOINT_ROOT) pose_pelvis(rig, local, &joint[j], &pelvis);
    }
    joint[MUS_JOINT_ROOT] = pelvis;
    for (int32_t p = 0; p < rig->parts; p++) out[p] = joint[rig->part[p].joint];
}
