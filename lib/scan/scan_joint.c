/*
 * scan_joint.c: the joints of a scanned body, found from the contours of its limbs.
 *
 * A limb is narrow beside a joint: the upper arm just above the elbow, before the bones of the elbow and the muscles of
 * the forearm; the leg below the knee, before the calf; the forearm above the hand. The narrowest contour of a range is
 * taken, if it is not the first or the last one; else the joint is at a fraction of the limb's length. The shoulder
 * joint lies on the arm's axis (scan_limb.c), the lumbar joint at the waist, the neck joint below the narrowest contour
 * of the neck; hips and ankles are placed as those of a body of a tape.
 *
 * The pose of the scan is the rest pose of the body: arms at the angle of their axes, all other angles 0.
 */
#include <math.h>
#include <string.h>

#include "geom/vec.h"
#include "scan/scan_internal.h"

/* positions of joints; chosen: about those of a body of a tape; they move the joints, not the surface */
#define JOINT_ELBOW 0.012     /* elbow beyond the narrowest contour of the upper arm, in parts of the stature */
#define JOINT_ELBOW_PART 0.55 /* elbow of an arm without one, in parts of shoulder to wrist */
#define JOINT_KNEE 0.015      /* knee above the narrowest contour below it, in parts of the stature */
#define JOINT_KNEE_PART 0.585 /* knee of a leg without one, in parts of the height of the crotch */
#define JOINT_NECK 0.02       /* neck joint below the narrowest contour of the neck, in parts of the stature */
#define JOINT_WAIST 0.62      /* waist of a torso without a narrowest contour, in parts of the stature */
#define JOINT_ANKLE 0.045     /* ankle of a leg without a foot, in parts of the stature */


/* radius of the circle of the area of contour i [m] */
static double joint_radius(const mus_limb *limb, int32_t i)
{
    double centre[2];
    const double *outline = limb->outline + 2 * (ptrdiff_t)i * limb->corners;
    return sqrt(fabs(mus__polygon_centre(limb->corners, outline, centre)) / MUS_PI);
}


/* s of the narrowest contour between low and high [m]; `other`, where that is the first or the last of them */
static double joint_narrowest(const mus_limb *limb, double low, double high, double other)
{
    int32_t first = limb->contours, last = -1, best = -1;
    double least = INFINITY;
    for (int32_t i = 0; i < limb->contours; i++) {
        const double s = limb->contour[6 * (ptrdiff_t)i];
        if (s < low || s > high) continue;
        const double radius = joint_radius(limb, i);
        if (i < first) first = i;
        last = i;
        if (radius < least) least = radius, best = i;
    }
    return best > first && best < last ? limb->contour[6 * (ptrdiff_t)best] : other;
}


/* joints of an arm, and its part of the skeleton */
static void joint_arm(const mus__scan_found *found, const mus_limb *limb, double shoulder, int r, mus__bones *out)
{
    const mus__scan_arm *arm = &found->arm[r];
    const double length = arm->wrist - shoulder;
    const double narrow = joint_narrowest(limb, shoulder + 0.36 * length, shoulder + 0.64 * length, INFINITY);
    out->shoulder[r] = shoulder;
    out->wrist[r] = arm->wrist;
    out->elbow[r] =
        isfinite(narrow) ? narrow + JOINT_ELBOW * found->stature : shoulder + JOINT_ELBOW_PART * length;
    for (int i = 0; i < 3; i++) {
        out->skeleton.joint[r][i] = arm->origin[i] + shoulder * arm->axis[i];
        out->skeleton.arm_axis[r][i] = arm->axis[i];
    }
}


/* joints of a leg; foot: NULL, it has none */
static void joint_leg(const mus__scan_found *found, const mus_limb *leg, const mus_limb *foot, int r, mus__bones *out)
{
    const double h = found->stature;
    const double narrow = joint_narrowest(leg, 0.46 * found->crotch, 0.64 * found->crotch, INFINITY);
    out->hip[r] = found->crotch + MUS__BONES_HIP * h;
    out->knee[r] = isfinite(narrow) ? narrow + JOINT_KNEE * h : JOINT_KNEE_PART * found->crotch;
    out->ankle[r] = foot != NULL ? MUS__BONES_ANKLE * (foot->pole[1] - foot->pole[0]) : JOINT_ANKLE * h;
}


void mus__scan_joints(const mus__scan_found *found, const mus__scan_limbs *limbs, mus__bones *out)
{
    const mus_limb *limb[MUS__LIMB_COUNT] = {NULL};
    memset(out, 0, sizeof *out);
    for (int32_t l = 0; l < MUS__LIMB_COUNT; l++) {
        out->limb[l] = MUS_NONE;
        for (int32_t i = 0; i < limbs->count; i++)
            if (limbs->which[i] == l) out->limb[l] = i, limb[l] = &limbs->limb[i];
    }
    const double h = found->stature;
    out->skeleton.crown = h;
    out->lumbar = joint_narrowest(limb[MUS__LIMB_TORSO], 0.57 * h, 0.70 * h, JOINT_WAIST * h);
    out->neck = found->neck - JOINT_NECK * h;
    for (int r = 0; r < 2; r++) {
        const mus_limb *arm = limb[MUS__LIMB_ARM_LEFT + r], *leg = limb[MUS__LIMB_LEG_LEFT + r];
        if (arm != NULL) joint_arm(found, arm, limbs->shoulder[r], r, out);
        if (leg != NULL) joint_leg(found, leg, limb[MUS__LIMB_FOOT_LEFT + r], r, out);
    }
}
