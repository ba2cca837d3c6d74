/*
 * body_landmark.c: named points of a body, in its pose.
 *
 * Of a body of a tape they are points of the contours of those names; of a scan they are at the levels and joints that
 * were found in it. A scan has no nape: its contours do not tell where the neck begins at the back.
 */
#include <string.h>

#include "body/body_internal.h"


/* move a point x (3) of the ring at s of a limb from the rest pose to the body's pose */
static void landmark_carry(const mus_body *body, int32_t limb, double s, double *x)
{
    mus__frame frame;
    if (body->frame == NULL) return;
    if (body->limb[limb].gone) limb = MUS__LIMB_TORSO, s = x[1];
    mus__rig_ring(&body->rig, body->frame, limb, s, &frame);
    mus__frame_point(&frame, x, x);
}


/* centre of a named contour of limb l, or with `skin` its point at the back; without such a contour the point `height`
 * [m] above the origin */
static void landmark_contour(const mus_body *body, int32_t l, const char *name, double height, bool skin, double *out)
{
    const mus__limb *limb = &body->limb[l];
    double s = height;
    out[0] = out[2] = 0.0, out[1] = height;
    for (int32_t i = 0; i < limb->count; i++) {
        const mus__contour *c = &limb->contour[i];
        if (strcmp(c->name, name) != 0) continue;
        double b = c->cb + (skin ? mus__contour_radius(c, 0.0, 1.0) : 0.0);
        for (int k = 0; k < 3; k++)
            out[k] = limb->origin[k] + c->ca * limb->side[k] + b * limb->front[k] + c->s * limb->axis[k];
        s = c->s;
    }
    landmark_carry(body, l, s, out);
}


/* whether limb l of the body exists and has a contour of that name */
static bool landmark_has(const mus_body *body, int32_t l, const char *name)
{
    for (int32_t i = 0; i < body->limb[l].count && !body->limb[l].gone; i++)
        if (strcmp(body->limb[l].contour[i].name, name) == 0) return true;
    return false;
}


/* a landmark of a body of a tape */
static mus_status landmark_measured(const mus_body *body, int32_t landmark, double *out)
{
    const mus__limb *torso = &body->limb[MUS__LIMB_TORSO];
    const mus__skeleton *bone = &body->skeleton;
    const int32_t right = landmark % 2;
    switch (landmark) {
    case MUS_LANDMARK_CROWN:
        memcpy(out, body->vertices + 3 * ((ptrdiff_t)torso->first_vertex + torso->vertices - 1), 3 * sizeof *out);
        return MUS_OK;
    case MUS_LANDMARK_NAPE:
        /* on the skin behind the centre of the neck */
        landmark_contour(body, MUS__LIMB_TORSO, "nape", bone->nape, true, out);
        return MUS_OK;
    case MUS_LANDMARK_BUST:
        landmark_contour(body, MUS__LIMB_TORSO, "bust", bone->bust, false, out);
        return MUS_OK;
    case MUS_LANDMARK_WAIST:
        landmark_contour(body, MUS__LIMB_TORSO, "waist", bone->waist, false, out);
        return MUS_OK;
    case MUS_LANDMARK_HIP:
        landmark_contour(body, MUS__LIMB_TORSO, "hip", bone->hip, false, out);
        return MUS_OK;
    case MUS_LANDMARK_CROTCH:
        memcpy(out, body->vertices + 3 * (ptrdiff_t)torso->first_vertex, 3 * sizeof *out);
        return MUS_OK;
    case MUS_LANDMARK_SHOULDER_LEFT:
    case MUS_LANDMARK_SHOULDER_RIGHT:
        memcpy(out, bone->joint[right], 3 * sizeof *out);
        landmark_carry(body, MUS__LIMB_ARM_LEFT + right, 0.0, out);
        return MUS_OK;
    case MUS_LANDMARK_WRIST_LEFT:
    case MUS_LANDMARK_WRIST_RIGHT:
        if (!landmark_has(body, MUS__LIMB_ARM_LEFT + right, "wrist")) break;
        landmark_contour(body, MUS__LIMB_ARM_LEFT + right, "wrist", 0.0, false, out);
        return MUS_OK;
    case MUS_LANDMARK_ANKLE_LEFT:
    case MUS_LANDMARK_ANKLE_RIGHT:
        if (!landmark_has(body, MUS__LIMB_LEG_LEFT + right, "ankle")) break;
        landmark_contour(body, MUS__LIMB_LEG_LEFT + right, "ankle", bone->ankle, false, out);
        return MUS_OK;
    default:
        break;
    }
    return mus__fail(body->context, MUS_ERR_ARG, "the body was made without landmark %d", (int)landmark);
}


/* a joint of limb `which`, at s; false: the scan does not have that limb */
static bool landmark_joint(const mus_body *body, int32_t which, int32_t joint, double s, double *out)
{
    const int32_t l = body->bones.limb[which];
    if (l == MUS_NONE) return false;
    memcpy(out, body->rig.pivot[joint], 3 * sizeof *out);
    landmark_carry(body, l, s, out);
    return true;
}


/* the middle of the torso at a height [m]; false: the scan does not have that level */
static bool landmark_level(const mus_body *body, double height, double *out)
{
    const int32_t l = body->bones.limb[MUS__LIMB_TORSO];
    if (!(height > 0.0)) return false;
    mus__rig_middle(&body->limb[l], height, out);
    landmark_carry(body, l, height, out);
    return true;
}


/* a landmark of a scan */
static mus_status landmark_scanned(const mus_body *body, int32_t landmark, double *out)
{
    const mus__bones *bones = &body->bones;
    const mus__limb *torso = &body->limb[bones->limb[MUS__LIMB_TORSO]];
    const int32_t right = landmark % 2;
    bool there = false;
    switch (landmark) {
    case MUS_LANDMARK_CROWN:
    case MUS_LANDMARK_CROTCH: {
        const int32_t last = landmark == MUS_LANDMARK_CROWN ? torso->vertices - 1 : 0;
        memcpy(out, body->vertices + 3 * ((ptrdiff_t)torso->first_vertex + last), 3 * sizeof *out);
        return MUS_OK;
    }
    case MUS_LANDMARK_BUST:
        there = landmark_level(body, body->skeleton.bust, out);
        break;
    case MUS_LANDMARK_WAIST:
        there = landmark_level(body, body->skeleton.waist, out);
        break;
    case MUS_LANDMARK_HIP:
        there = landmark_level(body, body->skeleton.hip, out);
        break;
    case MUS_LANDMARK_SHOULDER_LEFT:
    case MUS_LANDMARK_SHOULDER_RIGHT:
        there = landmark_joint(body, MUS__LIMB_ARM_LEFT + right, MUS_JOINT_SHOULDER_LEFT + right,
                               bones->shoulder[right], out);
        break;
    case MUS_LANDMARK_WRIST_LEFT:
    case MUS_LANDMARK_WRIST_RIGHT:
        there =
            landmark_joint(body, MUS__LIMB_ARM_LEFT + right, MUS_JOINT_WRIST_LEFT + right, bones->wrist[right], out);
        break;
    case MUS_LANDMARK_ANKLE_LEFT:
    case MUS_LANDMARK_ANKLE_RIGHT:
        there =
            landmark_joint(body, MUS__LIMB_LEG_LEFT + right, MUS_JOINT_ANKLE_LEFT + right, bones->ankle[right], out);
        break;
    default:
        break;
    }
    return there ? MUS_OK : mus__fail(body->context, MUS_ERR_ARG, "the scan has no landmark %d", (int)landmark);
}


mus_status mus_body_landmark(const mus_body *body, int32_t landmark, double *out)
{
    if (body == NULL || out == NULL) return MUS_ERR_ARG;
    if (landmark < 0 || landmark >= MUS_LANDMARK_COUNT)
        return mus__fail(body->context, MUS_ERR_ARG, "landmark %d is not one of 0 to %d", (int)landmark,
                         MUS_LANDMARK_COUNT - 1);
    if (body->measured) return landmark_measured(body, landmark, out);
    if (body->jointed) return landmark_scanned(body, landmark, out);
    return mus__fail(body->context, MUS_ERR_ARG, "a body made of given limbs has no landmark %d", (int)landmark);
}
