/*
 * rig.c: parts and joints of a body from its bones and contours; the frame of a ring near a joint.
 *
 * A pivot is the middle of the contour at the joint (bones.c, for a scan scan/scan_joint.c); shoulder pivots are those
 * of the skeleton. The angles of hips, knees and ankles are 0 in the rest pose.
 */
#include <math.h>
#include <string.h>

#include "base/elementary.h"
#include "body/body_internal.h"

#define RIG_HORIZONTAL 0.3 /* an arm whose axis falls by less than this part of its length counts as horizontal; chosen
                              */
#define RIG_SCAPULA 0.02   /* rise of the shoulder joint with the arm, in parts of the stature; chosen */
/* least length of a part, in parts of its limb: the joints of a scan may lie beyond its contours */
#define RIG_LEAST 0.01
#define RIG_CAP_MOST 0.8   /* a round cap is at most this part of the next part's length, so that it ends within it */


/* each joint: its parent, and axis (0 X, 1 Y, 2 Z) and sign of flexion, abduction and rotation on the left side; on the
 * right side turns about Y and Z have the opposite sign */
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


void mus__joint_turn(int32_t joint, const double *angle, double *out)
{
    double q[4] = {1.0, 0.0, 0.0, 0.0};
    for (int k = 0; k < 3; k++) {
        int32_t axis = rig_joints[joint].axis[k];
        double sense = rig_joints[joint].sense[k] * (rig_joints[joint].right && axis != 0 ? -1.0 : 1.0);
        double one[4] = {mus__cos(0.5 * angle[k]), 0.0, 0.0, 0.0};
        one[1 + axis] = sense * mus__sin(0.5 * angle[k]);
        mus__quaternion_product(q, one, q);
    }
    memcpy(out, q, sizeof q);
}


/* ---- making ---- */

/* centre and half axes of a limb at s [m], linear between its contours: out (4) ca, cb, a, b */
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


/* cut limb l at `cuts` joints s (cuts) [m], ascending, into parts that move with joint (cuts + 1), and append them; a
 * limb that was left out has no parts */
static void rig_cut(const mus_body *body, int32_t l, int32_t cuts, const double *s, const int32_t *joint, mus__rig *out)
{
    const mus__limb *limb = &body->limb[l];
    mus__part *part = &out->part[out->parts];
    if (limb->gone) return;
    const double low = limb->contour[0].s, high = limb->contour[limb->count - 1].s, least = RIG_LEAST * (high - low);
    for (int32_t k = 0; k <= cuts; k++) {
        part[k] = (mus__part){.limb = l, .joint = joint[k]};
        part[k].end[0] = k == 0 ? low : part[k - 1].end[1];
        part[k].end[1] = k == cuts ? high : fmin(fmax(s[k], part[k].end[0] + least), high - (cuts - k) * least);
    }

    /* a cap is one radius long; of the torso the radius is the half depth, across which it bends */
    for (int32_t k = 0; k < cuts; k++) {
        double at[4];
        rig_section(limb, part[k].end[1], at);
        double radius = l == body->bones.limb[MUS__LIMB_TORSO] ? at[3] : 0.5 * (at[2] + at[3]);
        part[k].round[1] = fmin(radius, RIG_CAP_MOST * (part[k + 1].end[1] - part[k].end[1]));
        part[k + 1].round[0] = fmin(radius, RIG_CAP_MOST * (part[k].end[1] - part[k].end[0]));
    }
    part[0].deep = body->measured && l == MUS__LIMB_TORSO;
    out->parts += cuts + 1;
}


/* limb MUS__LIMB_... of a body; NULL: the body does not have it */
static const mus__limb *rig_limb(const mus_body *body, int32_t which)
{
    const int32_t l = body->bones.limb[which];
    return l != MUS_NONE ? &body->limb[l] : NULL;
}


/* pivots of an arm, and the angles of its shoulder in the rest pose */
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

    /* the flexion of a nearly horizontal arm is not determined and set to 0 */
    const bool horizontal = down < RIG_HORIZONTAL;
    rest[MUS__FLEXION] = horizontal ? 0.0 : mus__atan2(axis[2], -axis[1]);
    rest[MUS__ABDUCTION] = mus__atan2(out_by, horizontal ? -axis[1] : down);
}


/* pivots of a leg */
static void rig_leg(const mus_body *body, const mus__limb *leg, int32_t right, mus__rig *out)
{
    mus__rig_middle(leg, body->bones.hip[right], out->pivot[MUS_JOINT_HIP_LEFT + right]);
    mus__rig_middle(leg, body->bones.knee[right], out->pivot[MUS_JOINT_KNEE_LEFT + right]);
    mus__rig_middle(leg, body->bones.ankle[right], out->pivot[MUS_JOINT_ANKLE_LEFT + right]);
}


/* mark the joints of limbs that a scanned body lacks, and those of the limbs that they carry */
static void rig_missing(const mus_body *body, mus__rig *out)
{
    static const int32_t joint[MUS__LIMB_COUNT][3] = {
        [MUS__LIMB_ARM_LEFT] = {MUS_JOINT_SHOULDER_LEFT, MUS_JOINT_ELBOW_LEFT, MUS_JOINT_WRIST_LEFT},
        [MUS__LIMB_ARM_RIGHT] = {MUS_JOINT_SHOULDER_RIGHT, MUS_JOINT_ELBOW_RIGHT, MUS_JOINT_WRIST_RIGHT},
        [MUS__LIMB_LEG_LEFT] = {MUS_JOINT_HIP_LEFT, MUS_JOINT_KNEE_LEFT, MUS_JOINT_ANKLE_LEFT},
        [MUS__LIMB_LEG_RIGHT] = {MUS_JOINT_HIP_RIGHT, MUS_JOINT_KNEE_RIGHT, MUS_JOINT_ANKLE_RIGHT},
        [MUS__LIMB_FOOT_LEFT] = {MUS_JOINT_ANKLE_LEFT, MUS_JOINT_ANKLE_LEFT, MUS_JOINT_ANKLE_LEFT},
        [MUS__LIMB_FOOT_RIGHT] = {MUS_JOINT_ANKLE_RIGHT, MUS_JOINT_ANKLE_RIGHT, MUS_JOINT_ANKLE_RIGHT}};
    for (int32_t l = MUS__LIMB_ARM_LEFT; l < MUS__LIMB_COUNT; l++)
        for (int k = 0; k < 3 && rig_limb(body, l) == NULL; k++) out->missing[joint[l][k]] = true;
}


/* cut all limbs into parts */
static void rig_parts(const mus_body *body, mus__rig *out)
{
    const mus__bones *bones = &body->bones;
    const int32_t *limb = bones->limb;
    rig_cut(body, limb[MUS__LIMB_TORSO], 2, (double[]){bones->lumbar, bones->neck},
            (int32_t[]){MUS_JOINT_ROOT, MUS_JOINT_LUMBAR, MUS_JOINT_NECK}, out);
    for (int32_t r = 0; r < 2; r++) {
        const mus__limb *arm = rig_limb(body, MUS__LIMB_ARM_LEFT + r);
        if (arm == NULL) continue;

        /* the part of a scanned arm before the shoulder joint moves with the chest; its round cap covers the ball */
        const int32_t behind = body->scanned ? 0 : 1;
        const double at[3] = {bones->shoulder[r], bones->elbow[r], bones->wrist[r]};
        const int32_t joint[4] = {MUS_JOINT_LUMBAR, MUS_JOINT_SHOULDER_LEFT + r, MUS_JOINT_ELBOW_LEFT + r,
                                  MUS_JOINT_WRIST_LEFT + r};
        rig_cut(body, limb[MUS__LIMB_ARM_LEFT + r], arm->cuts, at + behind, joint + behind, out);
    }
    for (int32_t r = 0; r < 2; r++) {
        const mus__limb *leg = rig_limb(body, MUS__LIMB_LEG_LEFT + r);
        if (leg == NULL) continue;

        /* the part of a scanned leg above the hip joint moves with the pelvis; a leg of a tape cut at the knee is a
         * thigh alone */
        const int32_t first = !body->scanned && leg->cuts == 0;
        const int32_t joint[3] = {MUS_JOINT_KNEE_LEFT + r, MUS_JOINT_HIP_LEFT + r, MUS_JOINT_ROOT};
        rig_cut(body, limb[MUS__LIMB_LEG_LEFT + r], leg->cuts, (double[]){bones->knee[r], bones->hip[r]}, joint + first,
                out);
    }
    for (int32_t r = 0; r < 2; r++)
        if (rig_limb(body, MUS__LIMB_FOOT_LEFT + r) != NULL)
            rig_cut(body, limb[MUS__LIMB_FOOT_LEFT + r], 0, NULL, (int32_t[]){MUS_JOINT_ANKLE_LEFT + r}, out);
    if (!body->measured) return;
    for (int32_t l = MUS__LIMB_COUNT; l < body->limb_count; l++) rig_cut(body, l, 0, NULL, &body->limb[l].joint, out);
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

    const mus__limb *torso = rig_limb(body, MUS__LIMB_TORSO);
    mus__rig_middle(torso, body->bones.lumbar, out->pivot[MUS_JOINT_LUMBAR]);
    mus__rig_middle(torso, body->bones.neck, out->pivot[MUS_JOINT_NECK]);
    for (int32_t right = 0; right < 2; right++) {
        const mus__limb *arm = rig_limb(body, MUS__LIMB_ARM_LEFT + right);
        const mus__limb *leg = rig_limb(body, MUS__LIMB_LEG_LEFT + right);
        if (arm != NULL) rig_arm(body, arm, right, out);
        if (leg != NULL) rig_leg(body, leg, right, out);
    }
    rig_missing(body, out);
    for (int i = 0; i < 3; i++)
        out->pivot[MUS_JOINT_ROOT][i] =
            0.5 * (out->pivot[MUS_JOINT_HIP_LEFT][i] + out->pivot[MUS_JOINT_HIP_RIGHT][i]);
    out->scapula = RIG_SCAPULA * body->skeleton.crown;
    rig_parts(body, out);

    /* rotations of the rest pose, parents first */
    double stand[MUS_JOINT_COUNT][4];
    for (int32_t j = 0; j < MUS_JOINT_COUNT; j++) {
        if (out->parent[j] != MUS_NONE) memcpy(out->parent_stand[j], stand[out->parent[j]], sizeof stand[j]);
        mus__joint_turn(j, out->rest[j], stand[j]);
        mus__quaternion_product(out->parent_stand[j], stand[j], stand[j]);
    }
}


void mus__part_carry(const mus__limb *limb, const mus__frame *frame, mus__field *field)
{
    mus__frame_point(frame, limb->origin, field->origin);
    mus__frame_turn(frame, limb->axis, field->axis);
    mus__frame_turn(frame, limb->side, field->side);
    mus__frame_turn(frame, limb->front, field->front);
}


/* the part u of the way from frame a to frame b, which agree at the point `at` (3) */
static void rig_between(const mus__frame *a, const mus__frame *b, double u, const double *at, mus__frame *out)
{
    double back[9], rest[3], q[4], from[3], to[3];
    for (int i = 0; i < 9; i++) back[i] = a->turn[3 * (i % 3) + i / 3];
    double relative[9];
    mus__matrix_product(back, b->turn, relative);
    mus__quaternion_of(relative, q);
    if (q[0] < 0.0)
        for (int i = 0; i < 4; i++) q[i] = -q[i];
    q[0] = 1.0 - u + u * q[0];
    for (int i = 1; i < 4; i++) q[i] *= u;
    mus__quaternion_normalise(q);
    mus__quaternion_matrix(q, relative);
    mus__matrix_product(a->turn, relative, out->turn);

    mus__frame_point(a, at, from);
    mus__frame_point(b, at, to);
    mus__matrix_point(out->turn, at, rest);
    for (int i = 0; i < 3; i++) out->place[i] = (1.0 - u) * from[i] + u * to[i] - rest[i];
}


void mus__rig_ring(const mus__rig *rig, const mus__frame *frames, int32_t limb, double s, mus__frame *out)
{
    /* the last part of the limb that begins below s */
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
