/*
 * limbs_left_out.c: limbs of a body of a tape left out, or cut at a joint.
 *
 * A limb that is left out keeps its place in the list and its contours, from which joints are found; it has no part and
 * no surface. A limb that is cut at a joint loses the contours beyond it and closes there with a round stump. Called
 * once when a body is made, after the girths are fitted.
 */
#include <string.h>

#include "body/body_make.h"

/* length of a stump beyond the joint, in parts of its radius; chosen */
#define WITHOUT_ROUND 0.7


/* length of the stump beyond a contour [m] */
static double without_stump(const mus__contour *last)
{
    return WITHOUT_ROUND * 0.5 * (last->a + last->b);
}


/* end an arm at s, with `cuts` joints left: its contours ascend towards the hand */
static void without_above(mus__limb *limb, double s, int32_t cuts)
{
    while (limb->count > 2 && limb->contour[limb->count - 1].s > s + 1e-9) limb->count--;
    const mus__contour *last = &limb->contour[limb->count - 1];
    limb->pole[1] = last->s + without_stump(last);
    limb->cuts = cuts;
}


/* end a leg at s, with `cuts` joints left: its contours ascend from the foot */
static void without_below(mus__limb *limb, double s, int32_t cuts)
{
    int32_t first = 0;
    while (limb->count - first > 2 && limb->contour[first].s < s - 1e-9) first++;
    limb->count -= first;
    memmove(limb->contour, limb->contour + first, (size_t)limb->count * sizeof *limb->contour);
    memmove(limb->limited, limb->limited + first, (size_t)limb->count * sizeof *limb->limited);
    limb->pole[0] = limb->contour[0].s - without_stump(&limb->contour[0]);
    limb->cuts = cuts;
}


void mus__body_without(mus_body *body)
{
    const mus__skeleton *bone = &body->skeleton;
    body->limb[MUS__LIMB_TORSO].cuts = 2;
    for (int32_t right = 0; right < 2; right++) {
        const int32_t gone = body->def.without >> right;
        mus__limb *arm = &body->limb[MUS__LIMB_ARM_LEFT + right], *leg = &body->limb[MUS__LIMB_LEG_LEFT + right];
        arm->cuts = 2, leg->cuts = 1;
        arm->gone = (gone & MUS_WITHOUT_ARM_LEFT) != 0;
        leg->gone = (gone & MUS_WITHOUT_LEG_LEFT) != 0;
        if ((gone & MUS_WITHOUT_FOREARM_LEFT) != 0)
            without_above(arm, bone->elbow, 0);
        else if ((gone & MUS_WITHOUT_HAND_LEFT) != 0)
            without_above(arm, bone->arm_length, 1);
        if ((gone & MUS_WITHOUT_SHANK_LEFT) != 0)
            without_below(leg, bone->knee, 0);
        else if ((gone & MUS_WITHOUT_FOOT_LEFT) != 0)
            without_below(leg, bone->ankle, 1);
        const int32_t footless = MUS_WITHOUT_LEG_LEFT | MUS_WITHOUT_SHANK_LEFT | MUS_WITHOUT_FOOT_LEFT;
        body->limb[MUS__LIMB_FOOT_LEFT + right].gone = (gone & footless) != 0;
    }
}
