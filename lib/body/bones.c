/*
 * bones.c: the joints of a body of a tape, from its skeleton.
 *
 * The lumbar joint is at the waist, the neck joint at the base of the neck; the hip joints lie 0.04 of the stature
 * above the crotch, at most at the hip level; the ankles 0.3 foot lengths above the floor. Shoulders, elbows, wrists
 * and knees are those of the skeleton. Source: ANSUR II and the mean bodies of GarmentCode.
 */
#include <math.h>
#include <string.h>

#include "body/body_internal.h"


void mus__bones_measured(const mus__skeleton *skeleton, double foot, mus__bones *out)
{
    memset(out, 0, sizeof *out);
    for (int32_t l = 0; l < MUS__LIMB_COUNT; l++) out->limb[l] = l;
    out->lumbar = skeleton->waist, out->neck = skeleton->neck_side;
    for (int r = 0; r < 2; r++) {
        out->elbow[r] = skeleton->elbow, out->wrist[r] = skeleton->arm_length;
        out->hip[r] = fmin(skeleton->crotch + MUS__BONES_HIP * skeleton->crown, skeleton->hip);
        out->knee[r] = skeleton->knee;
        out->ankle[r] = fmin(MUS__BONES_ANKLE * foot, skeleton->ankle);
    }
    out->skeleton = *skeleton;
}


void mus__body_levels(mus_body *body, double bust, double waist, double hip)
{
    body->skeleton.bust = bust, body->skeleton.waist = waist, body->skeleton.hip = hip;
}
