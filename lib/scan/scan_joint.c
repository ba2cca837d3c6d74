/*
 * scan_joint.c: the joints of a scanned body, found from its limbs' contours.
 *
 * A limb is thin beside a joint and thick beyond: the upper arm is thinnest just above the elbow, whose bones and the
 * forearm's muscles follow; the leg is thinnest below the knee, before the calf; the forearm above the hand. Of each
 * the narrowest contour is taken that has thicker ones on both sides, or a fraction of the limb's length where there is
 * none. The shoulder joint lies on the arm's axis (scan_limb.c). The lumbar joint is at the waist, the narrowest level,
 * the neck's a little below the narrowest of the neck; hips and ankles as of a body of a tape.
 *
 * The pose that a scan stands in is its rest pose: arms at the angle of their axes, all other angles 0.
 */
#include <math.h>
#include <string.h>

#include "geom/vec.h"
#include "scan/scan_internal.h"

#define JOINT_ELBOW 0.012      /* beyond the narrowest of the upper arm, in parts of the stature */
#define JOINT_ELBOW_PART 0.55  /* of the arm from shoulder to wrist, where it has no narrowest */
#define JOINT_KNEE 0.015       /* above the narrowest below it, in parts of the stature */
#define JOINT_KNEE_PART 0.585  /* of the height of the crotch, where the leg has no narrowest */
#define JOINT_NECK 0.02        /* below the narrowest of the neck, in parts of the stature */
#define JOINT_WAIST 0.62       /* of the stature, where the torso has no narrowest */
#define JOINT_ANKLE 0.045      /* of the stature, of legs without feet */


/* radius of a circle as large as contour i */
static double joint_radius(const mus_limb *limb, int32_t i)
{
    double centre[2];
    const double *outline = limb->outline + 2 * (ptrdiff_t)i * limb->corners;
    return sqrt(fabs(mus__polygon_centre(limb->corners, outline, centre)) / MUS_PI);
}


/* s of the narrowest contour between low and high, if it is not the first or the last of them; else `other` */
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
