/*
 * rig.c: joints of a body from its bones and contours, and where a pose puts the parts.
 *
 * Pivots stand in the middle of the contour at the joint (bones.c; of a scan scan/scan_joint.c); shoulders are the
 * skeleton's. Legs as they were made are the zero of hips, knees and ankles.
 *
 * A joint turns by Q = R(flexion) R(abduction) R(rotation) from the anatomical pose. With the parent's rotation P from
 * the anatomical to the rest pose, and Q0 the joint's own in the rest pose, the turn against the rest pose in its
 * directions is  P Q Q0* P*,  which is the identity where Q = Q0.
 *
 * The shoulder joint goes up and inwards with the scapula while the arm rises from 30 to 170 degrees.
 * Source of ranges: AAOS normal ranges of motion.
 */
#include <math.h>
#include <string.h>

#include "body/body_internal.h"
#include "geom/vec.h"

#define RIG_LEVEL 0.3          /* part of its length that an arm hangs: below this it is level */
#define RIG_SCAPULA 0.02       /* way of the shoulder joint, in parts of the stature */
#define RIG_SCAPULA_IN 0.5     /* of it inwards, for each part upwards */
#define RIG_CAP_ROOM 0.8       /* a cap is no longer than this part of the next part */


/* each joint: its parent, the axis (0 X, 1 Y, 2 Z) and sense of flexion, abduction and rotation on the left side;
 * turns about Y and Z have the other sense on the right */
static const struct {
    int32_t parent;
    int32_t axis[3];
    double sense[3];
    bool right;
} rig_joints[MUS_JOINT_COUNT] = {
    {MUS_NONE, {0, 2, 1}, {1.0, -1.0, 1.0}, false},                /* root */
    {MUS_JOINT_ROOT, {0, 2, 1}, {1.0, -1.0, 1.0}, false},          /* lumbar */
    {MUS_JOINT_LUMBAR, {0, 2, 1}, {1.0, -1.0, 1.0}, false},        /* neck */
    {MUS_JOINT_LUMBAR, {0, 2, 1}, {-1.0, 1.0, -1.0}, false},       /* shoulders */
    {MUS_JOINT_LUMBAR, {0, 2, 1}, {-1.0, 1.0, -1.0}, true},
    {MUS_JOINT_SHOULDER_LEFT, {0, 2, 1}, {-1.0, 1.0, -1.0}, false}, /* elbows */
    {MUS_JOINT_SHOULDER_RIGHT, {0, 2, 1}, {-1.0, 1.0, -1.0}, true},
    {MUS_JOINT_ELBOW_LEFT, {2, 0, 1}, {-1.0, -1.0, -1.0}, false}, /* wrists: the palm is towards the thigh */
    {MUS_JOINT_ELBOW_RIGHT, {2, 0, 1}, {-1.0, -1.0, -1.0}, true},
    {MUS_JOINT_ROOT, {0, 2, 1}, {-1.0, 1.0, -1.0}, false}, /* hips */
    {MUS_JOINT_ROOT, {0, 2, 1}, {-1.0, 1.0, -1.0}, true},
    {MUS_JOINT_HIP_LEFT, {0, 2, 1}, {1.0, 1.0, -1.0}, false}, /* knees */
    {MUS_JOINT_HIP_RIGHT, {0, 2, 1}, {1.0, 1.0, -1.0}, true},
    {MUS_JOINT_KNEE_LEFT, {0, 2, 1}, {-1.0, 1.0, -1.0}, false}, /* ankles */
    {MUS_JOINT_KNEE_RIGHT, {0, 2, 1}, {-1.0, 1.0, -1.0}, true},
};


/* ---- quaternions (w, x, y, z) ---- */

static void rig_product(const double *a, const double *b, double *out)
{
    double q[4] = {a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
                   a[0] * b[1] + a[1] * b[0] + (a[2] * b[3] - a[3] * b[2]),
                   a[0] * b[2] + a[2] * b[0] + (a[3] * b[1] - a[1] * b[3]),
                   a[0] * b[3] + a[3] * b[0] + (a[1] * b[2] - a[2] * b[1])};
    memcpy(out, q, sizeof q);
}


static void rig_conjugate(const double *a, double *out)
{
    out[0] = a[0], out[1] = -a[1], out[2] = -a[2], out[3] = -a[3];
}


static void rig_normalise(double *q)
{
    double length = sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    for (int i = 0; i < 4; i++) q[i] /= length;
}


/* rotation of a unit quaternion, row by row */
static void rig_matrix(const double *q, double *out)
{
    double w = q[0], x = q[1], y = q[2], z = q[3];
    out[0] = 1.0 - 2.0 * (y * y + z * z), out[1] = 2.0 * (x * y - w * z), out[2] = 2.0 * (x * z + w * y);
    out[3] = 2.0 * (x * y + w * z), out[4] = 1.0 - 2.0 * (x * x + z * z), out[5] = 2.0 * (y * z - w * x);
    out[6] = 2.0 * (x * z - w * y), out[7] = 2.0 * (y * z + w * x), out[8] = 1.0 - 2.0 * (x * x + y * y);
}


/* unit quaternion of a rotation: Shepperd 1978, the largest of the four first */
static void rig_quaternion(const double *m, double *q)
{
    double trace = m[0] + m[4] + m[8];
    double square[4] = {1.0 + trace, 1.0 + 2.0 * m[0] - trace, 1.0 + 2.0 * m[4] - trace, 1.0 + 2.0 * m[8] - trace};
    int most = 0;
    for (int i = 1; i < 4; i++)
        if (square[i] > square[most]) most = i;

    /* sums and differences of the mirror entries are 4 q_i q_j */
    double wx = m[7] - m[5], wy = m[2] - m[6], wz = m[3] - m[1];
    double xy = m[3] + m[1], xz = m[2] + m[6], yz = m[7] + m[5];
    double row[4][4] = {
        {square[0], wx, wy, wz}, {wx, square[1], xy, xz}, {wy, xy, square[2], yz}, {wz, xz, yz, square[3]}};
    memcpy(q, row[most], sizeof row[most]);
    rig_normalise(q);
}


static void rig_turn_point(const double *turn, const double *x, double *out)
{
    double y[3];
    for (int i = 0; i < 3; i++) y[i] = turn[3 * i] * x[0] + turn[3 * i + 1] * x[1] + turn[3 * i + 2] * x[2];
    memcpy(out, y, sizeof y);
}


void mus__frame_point(const mus__frame *frame, const double *x, double *out)
{
    rig_turn_point(frame->turn, x, out);
    for (int i = 0; i < 3; i++) out[i] += frame->place[i];
}


void mus__frame_turn(const mus__frame *frame, const double *x, double *out)
{
    rig_turn_point(frame->turn, x, out);
}


static void rig_matrix_product(const double *a, const double *b, double *out)
{
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            out[3 * i + k] = a[3 * i] * b[k] + a[3 * i + 1] * b[3 + k] + a[3 * i + 2] * b[6 + k];
}


/* Q of a joint from the anatomical pose */
static void rig_joint_turn(int32_t joint, const double *angle, double *out)
{
    double q[4] = {1.0, 0.0, 0.0, 0.0};
    for (int k = 0; k < 3; k++) {
        int32_t axis = rig_joints[joint].axis[k];
        double sense = rig_joints[joint].sense[k] * (rig_joints[joint].right && axis != 0 ? -1.0 : 1.0);
        double one[4] = {cos(0.5 * angle[k]), 0.0, 0.0, 0.0};
        one[1 + axis] = sense * sin(0.5 * angle[k]);
        rig_product(q, one, q);
    }
    memcpy(out, q, sizeof q);
}


/* ---- making ---- */

/* centre and half axes of a limb at s, linear between its contours: out (4) ca, cb, a, b */
static void rig_section(const mus__limb *limb, double s, double *out)
{
    int32_t i = 0;
    while (i + 2 < limb->count && limb->contour[i + 1].s <= s) i++;
    const mus__contour *p = &limb->contour[i], *q = p + 1;
    double t = fmin(fmax((s - p->s) / (q->s - p->s), 0.0), 1.0);
    out[0] = p->ca + t * (q->ca - p->ca), out[1] = p->cb + t * (q->cb - p->cb);
    out[2] = p->a + t * (q->a - p->a), out[3] = p->b + t * (q->b - p->b);
}


void mus__rig_middle(const mus__limb *limb, double s, double *out)
{
    double at[4];
    rig_section(limb, s, at);
    for (int i = 0; i < 3; i++)
        out[i] = limb->origin[i] + at[0] * limb->side[i] + at[1] * limb->front[i] + s * limb->axis[i];
}


/* cut a limb at `cuts` joints (s ascending) into parts that move with joint[0 .. cuts]; nothing of one left out */
static void rig_cut(const mus_body *body, int32_t l, int32_t cuts, const double *s, const int32_t *joint, mus__rig *out)
{
    const mus__limb *limb = &body->limb[l];
    mus__part *part = &out->part[out->parts];
    if (limb->gone) return;
    for (int32_t k = 0; k <= cuts; k++) {
        part[k] = (mus__part){.limb = l, .joint = joint[k]};
        part[k].end[0] = k == 0 ? limb->contour[0].s : s[k - 1];
        part[k].end[1] = k == cuts ? limb->contour[limb->count - 1].s : s[k];
    }

    /* a cap is a radius long: of the torso its half depth, about which it bends */
    for (int32_t k = 0; k < cuts; k++) {
        double at[4];
        rig_section(limb, s[k], at);
        double radius = l == body->bones.limb[MUS_LIMB_TORSO] ? at[3] : 0.5 * (at[2] + at[3]);
        part[k].round[1] = fmin(radius, RIG_CAP_ROOM * (part[k + 1].end[1] - s[k]));
        part[k + 1].round[0] = fmin(radius, RIG_CAP_ROOM * (s[k] - part[k].end[0]));
    }
    out->parts += cuts + 1;
}


/* the limb that a name stands for, NULL: the body has none, also not for the joints' sake */
static const mus__limb *rig_limb(const mus_body *body, int32_t which)
{
    const int32_t l = body->bones.limb[which];
    return l != MUS_NONE ? &body->limb[l] : NULL;
}


/* pivots of an arm, right or left, and how it hangs at rest */
static void rig_arm(const mus_body *body, const mus__limb *arm, int32_t right, mus__rig *out)
{
    const mus__skeleton *bone = &body->skeleton;
    memcpy(out->pivot[MUS_JOINT_SHOULDER_LEFT + right], bone->joint[right], 3 * sizeof(double));
    mus__rig_middle(arm, body->bones.elbow[right], out->pivot[MUS_JOINT_ELBOW_LEFT + right]);
    mus__rig_middle(arm, body->bones.wrist[right], out->pivot[MUS_JOINT_WRIST_LEFT + right]);

    /* the axis (0, -1, 0) of a hanging arm, abducted a and flexed f: (sin a, -cos a cos f, cos a sin f) */
    const double *axis = bone->arm_axis[right];
    double *rest = out->rest[MUS_JOINT_SHOULDER_LEFT + right];
    const double down = sqrt(axis[1] * axis[1] + axis[2] * axis[2]), out_by = right ? -axis[0] : axis[0];

    /* of an arm that is all but level the flexion says nothing */
    const bool level = down < RIG_LEVEL;
    rest[MUS_POSE_FLEXION] = level ? 0.0 : atan2(axis[2], -axis[1]);
    rest[MUS_POSE_ABDUCTION] = atan2(out_by, level ? -axis[1] : down);
}


static void rig_leg(const mus_body *body, const mus__limb *leg, int32_t right, mus__rig *out)
{
    mus__rig_middle(leg, body->bones.hip[right], out->pivot[MUS_JOINT_HIP_LEFT + right]);
    mus__rig_middle(leg, body->bones.knee[right], out->pivot[MUS_JOINT_KNEE_LEFT + right]);
    mus__rig_middle(leg, body->bones.ankle[right], out->pivot[MUS_JOINT_ANKLE_LEFT + right]);
}


/* joints of a scanned body that move nothing, since it has no such limb: of the limb, and of what hangs on it */
static void rig_missing(const mus_body *body, mus__rig *out)
{
    static const int32_t joint[MUS_LIMB_COUNT][3] = {
        [MUS_LIMB_ARM_LEFT] = {MUS_JOINT_SHOULDER_LEFT, MUS_JOINT_ELBOW_LEFT, MUS_JOINT_WRIST_LEFT},
        [MUS_LIMB_ARM_RIGHT] = {MUS_JOINT_SHOULDER_RIGHT, MUS_JOINT_ELBOW_RIGHT, MUS_JOINT_WRIST_RIGHT},
        [MUS_LIMB_LEG_LEFT] = {MUS_JOINT_HIP_LEFT, MUS_JOINT_KNEE_LEFT, MUS_JOINT_ANKLE_LEFT},
        [MUS_LIMB_LEG_RIGHT] = {MUS_JOINT_HIP_RIGHT, MUS_JOINT_KNEE_RIGHT, MUS_JOINT_ANKLE_RIGHT},
        [MUS_LIMB_FOOT_LEFT] = {MUS_JOINT_ANKLE_LEFT, MUS_JOINT_ANKLE_LEFT, MUS_JOINT_ANKLE_LEFT},
        [MUS_LIMB_FOOT_RIGHT] = {MUS_JOINT_ANKLE_RIGHT, MUS_JOINT_ANKLE_RIGHT, MUS_JOINT_ANKLE_RIGHT}};
    for (int32_t l = MUS_LIMB_ARM_LEFT; l < MUS_LIMB_COUNT; l++)
        for (int k = 0; k < 3 && rig_limb(body, l) == NULL; k++) out->missing[joint[l][k]] = true;
}


static void rig_parts(const mus_body *body, mus__rig *out)
{
    const mus__bones *bones = &body->bones;
    const int32_t *limb = bones->limb;
    rig_cut(body, limb[MUS_LIMB_TORSO], 2, (double[]){bones->lumbar, bones->neck},
            (int32_t[]){MUS_JOINT_ROOT, MUS_JOINT_LUMBAR, MUS_JOINT_NECK}, out);
    for (int32_t r = 0; r < 2; r++) {
        const mus__limb *arm = rig_limb(body, MUS_LIMB_ARM_LEFT + r);
        if (arm == NULL) continue;

        /* what a scanned arm has behind the shoulder joint is the chest's: its round end covers the ball of the arm */
        const int32_t behind = body->scanned ? 0 : 1;
        const double at[3] = {bones->shoulder[r], bones->elbow[r], bones->wrist[r]};
        const int32_t joint[4] = {MUS_JOINT_LUMBAR, MUS_JOINT_SHOULDER_LEFT + r, MUS_JOINT_ELBOW_LEFT + r,
                                  MUS_JOINT_WRIST_LEFT + r};
        rig_cut(body, limb[MUS_LIMB_ARM_LEFT + r], arm->cuts, at + behind, joint + behind, out);
    }
    for (int32_t r = 0; r < 2; r++) {
        const mus__limb *leg = rig_limb(body, MUS_LIMB_LEG_LEFT + r);
        if (leg == NULL) continue;

        /* what a scanned leg has above the hip is the pelvis's; one of a tape that ends at the knee is a thigh alone */
        const int32_t first = !body->scanned && leg->cuts == 0;
        const int32_t joint[3] = {MUS_JOINT_KNEE_LEFT + r, MUS_JOINT_HIP_LEFT + r, MUS_JOINT_ROOT};
        rig_cut(body, limb[MUS_LIMB_LEG_LEFT + r], leg->cuts, (double[]){bones->knee[r], bones->hip[r]}, joint + first,
                out);
    }
    for (int32_t r = 0; r < 2; r++)
        if (rig_limb(body, MUS_LIMB_FOOT_LEFT + r) != NULL)
            rig_cut(body, limb[MUS_LIMB_FOOT_LEFT + r], 0, NULL, (int32_t[]){MUS_JOINT_ANKLE_LEFT + r}, out);
    if (!body->measured) return;
    for (int32_t l = MUS_LIMB_COUNT; l < body->limb_count; l++) rig_cut(body, l, 0, NULL, &body->limb[l].joint, out);
}


void mus__rig_make(const mus_body *body, mus__rig *out)
{
    memset(out, 0, sizeof *out);
    for (int32_t j = 0; j < MUS_JOINT_COUNT; j++) {
        out->parent[j] = rig_joints[j].parent;
        out->parent_stand[j][0] = 1.0;
    }
    if (!body->jointed) {
        for (int32_t l = 0; l < body->limb_count; l++) rig_cut(body, l, 0, NULL, (int32_t[]){MUS_JOINT_ROOT}, out);
        for (int32_t j = 1; j < MUS_JOINT_COUNT; j++) out->missing[j] = body->scanned;
        return;
    }

    const mus__limb *torso = rig_limb(body, MUS_LIMB_TORSO);
    mus__rig_middle(torso, body->bones.lumbar, out->pivot[MUS_JOINT_LUMBAR]);
    mus__rig_middle(torso, body->bones.neck, out->pivot[MUS_JOINT_NECK]);
    for (int32_t right = 0; right < 2; right++) {
        const mus__limb *arm = rig_limb(body, MUS_LIMB_ARM_LEFT + right);
        const mus__limb *leg = rig_limb(body, MUS_LIMB_LEG_LEFT + right);
        if (arm != NULL) rig_arm(body, arm, right, out);
        if (leg != NULL) rig_leg(body, leg, right, out);
    }
    rig_missing(body, out);
    for (int i = 0; i < 3; i++)
        out->pivot[MUS_JOINT_ROOT][i] =
            0.5 * (out->pivot[MUS_JOINT_HIP_LEFT][i] + out->pivot[MUS_JOINT_HIP_RIGHT][i]);
    out->scapula = RIG_SCAPULA * body->skeleton.crown;
    rig_parts(body, out);

    /* rotations of the rest pose, down the tree */
    double stand[MUS_JOINT_COUNT][4];
    for (int32_t j = 0; j < MUS_JOINT_COUNT; j++) {
        if (out->parent[j] != MUS_NONE) memcpy(out->parent_stand[j], stand[out->parent[j]], sizeof stand[j]);
        rig_joint_turn(j, out->rest[j], stand[j]);
        rig_product(out->parent_stand[j], stand[j], stand[j]);
    }
}


const mus__rig *mus__body_rig(const mus_body *body)
{
    return &body->rig;
}


const mus__frame *mus__body_frames(const mus_body *body)
{
    return body->frame;
}


/* ---- posing ---- */

/* how high the arm is lifted, as a part of the way of the scapula: 0 at 30 degrees off hanging, 1 at 170 */
static double rig_lift(const double *turn)
{
    double down[3] = {0.0, -1.0, 0.0}, m[9];
    rig_matrix(turn, m);
    rig_turn_point(m, down, down);
    double lift = acos(fmin(fmax(-down[1], -1.0), 1.0));
    return fmax(lift - MUS_PI / 6.0, 0.0) / (140.0 * MUS_PI / 180.0);
}


mus_status mus__rig_locals(mus_context *context, const mus__rig *rig, const mus_pose *pose, mus__local *out)
{
    if (pose == NULL) return mus__fail(context, MUS_ERR_ARG, "the pose is NULL");
    if (pose->size != sizeof *pose)
        return mus__fail(context, MUS_ERR_VERSION, "mus_pose.size %zu is unknown; use mus_pose_init", pose->size);
    for (int i = 0; i < 3; i++)
        if (!mus__finite(pose->place[i]))
            return mus__fail(context, MUS_ERR_ARG, "mus_pose.place %g is not finite", pose->place[i]);

    for (int32_t j = 0; j < MUS_JOINT_COUNT; j++) {
        double turn[4], rest[4], back[4];
        for (int k = 0; k < 3; k++)
            if (!mus__finite(pose->angle[j][k]))
                return mus__fail(context, MUS_ERR_ARG, "mus_pose.angle of %s is not finite", mus_joint_name(j));
        for (int k = 0; k < 3 && rig->missing[j]; k++)
            if (pose->angle[j][k] != 0.0)
                return mus__fail(context, MUS_ERR_BODY,
                                 "%s is asked to turn by %.1f degrees, and the scan has no such limb: set it to 0",
                                 mus_joint_name(j), pose->angle[j][k] * 180.0 / MUS_PI);
        rig_joint_turn(j, pose->angle[j], turn);
        rig_joint_turn(j, rig->rest[j], rest);
        memset(&out[j], 0, sizeof out[j]);
        if (j == MUS_JOINT_ROOT) memcpy(out[j].shift, pose->place, sizeof out[j].shift);
        if (j == MUS_JOINT_SHOULDER_LEFT || j == MUS_JOINT_SHOULDER_RIGHT) {
            double up = rig->scapula * (rig_lift(turn) - rig_lift(rest));
            out[j].shift[0] = (rig_joints[j].right ? RIG_SCAPULA_IN : -RIG_SCAPULA_IN) * up;
            out[j].shift[1] = up;
        }

        /* P Q Q0* P* */
        rig_conjugate(rest, back);
        rig_product(turn, back, turn);
        rig_product(rig->parent_stand[j], turn, turn);
        rig_conjugate(rig->parent_stand[j], back);
        rig_product(turn, back, out[j].quaternion);
        rig_normalise(out[j].quaternion);
    }
    return MUS_OK;
}


void mus__rig_blend(const mus__local *a, const mus__local *b, double t, mus__local *out)
{
    for (int32_t j = 0; j < MUS_JOINT_COUNT; j++) {
        /* the nearer of q and -q */
        const double *p = a[j].quaternion, *q = b[j].quaternion;
        double sign = p[0] * q[0] + p[1] * q[1] + p[2] * q[2] + p[3] * q[3] < 0.0 ? -1.0 : 1.0;
        for (int i = 0; i < 4; i++) out[j].quaternion[i] = (1.0 - t) * p[i] + t * sign * q[i];
        rig_normalise(out[j].quaternion);
        for (int i = 0; i < 3; i++) out[j].shift[i] = (1.0 - t) * a[j].shift[i] + t * b[j].shift[i];
    }
}


void mus__rig_frames(const mus__rig *rig, const mus__local *local, mus__frame *out)
{
    mus__frame joint[MUS_JOINT_COUNT], own;
    for (int32_t j = 0; j < MUS_JOINT_COUNT; j++) {
        const int32_t parent = rig->parent[j];
        double pivot[3], back[3];
        rig_matrix(local[j].quaternion, own.turn);
        for (int i = 0; i < 3; i++) pivot[i] = rig->pivot[j][i] + local[j].shift[i];
        if (parent == MUS_NONE) {
            joint[j] = own;
        } else {
            rig_matrix_product(joint[parent].turn, own.turn, joint[j].turn);
            mus__frame_point(&joint[parent], pivot, pivot);
        }

        /* place: the pivot goes where its parent carries it */
        rig_turn_point(joint[j].turn, rig->pivot[j], back);
        for (int i = 0; i < 3; i++) joint[j].place[i] = pivot[i] - back[i];
    }
    for (int32_t p = 0; p < rig->parts; p++) out[p] = joint[rig->part[p].joint];
}


/* u of the way from frame a to frame b, which meet at the point `at` */
static void rig_between(const mus__frame *a, const mus__frame *b, double u, const double *at, mus__frame *out)
{
    double back[9], rest[3], q[4], from[3], to[3];
    for (int i = 0; i < 9; i++) back[i] = a->turn[3 * (i % 3) + i / 3];
    double relative[9];
    rig_matrix_product(back, b->turn, relative);
    rig_quaternion(relative, q);
    if (q[0] < 0.0)
        for (int i = 0; i < 4; i++) q[i] = -q[i];
    q[0] = 1.0 - u + u * q[0];
    for (int i = 1; i < 4; i++) q[i] *= u;
    rig_normalise(q);
    rig_matrix(q, relative);
    rig_matrix_product(a->turn, relative, out->turn);

    mus__frame_point(a, at, from);
    mus__frame_point(b, at, to);
    rig_turn_point(out->turn, at, rest);
    for (int i = 0; i < 3; i++) out->place[i] = (1.0 - u) * from[i] + u * to[i] - rest[i];
}


void mus__rig_ring(const mus__rig *rig, const mus__frame *frames, int32_t limb, double s, mus__frame *out)
{
    /* the parts of the limb ascend: the last that begins below s */
    int32_t p = 0;
    while (p < rig->parts && rig->part[p].limb != limb) p++;
    while (p + 1 < rig->parts && rig->part[p + 1].limb == limb && s >= rig->part[p + 1].end[0]) p++;
    *out = frames[p];
    for (int32_t low = p > 0 ? p - 1 : 0; low <= p && low + 1 < rig->parts; low++) {
        const mus__part *below = &rig->part[low], *above = below + 1;
        if (below->limb != limb || above->limb != limb) continue;
        double start = below->end[1] - above->round[0], span = below->round[1] + above->round[0];
        double u = (s - start) / span;
        if (u <= 0.0 || u >= 1.0) continue;
        int32_t child = rig->parent[above->joint] == below->joint ? above->joint : below->joint;
        rig_between(&frames[low], &frames[low + 1], u * u * (3.0 - 2.0 * u), rig->pivot[child], out);
    }
}
