/*
 * bones.h: which limb of a body is which, and where along them its joints lie.
 *
 * A body of a tape has them from its skeleton, a scanned one from its limbs' contours; a body of given limbs has none.
 * With them it has a rig: it can be posed and moved. Index 0 is the left side, 1 the right.
 */
#ifndef MUS_BODY_BONES_H
#define MUS_BODY_BONES_H

#include "limb/skeleton.h"
#include "muslin/body.h"

#define MUS__LIMB_COUNT 7 /* of a body made from a tape */

/* which limb is which in mus_body.limb of a body made from a tape, and in mus__bones.limb of any */
enum {
    MUS__LIMB_TORSO,
    MUS__LIMB_ARM_LEFT,
    MUS__LIMB_ARM_RIGHT,
    MUS__LIMB_LEG_LEFT,
    MUS__LIMB_LEG_RIGHT,
    MUS__LIMB_FOOT_LEFT,
    MUS__LIMB_FOOT_RIGHT
};

typedef struct mus__bones {
    int32_t limb[MUS__LIMB_COUNT];           /* its number in the body; MUS_NONE: it has no such limb */
    double lumbar, neck;                    /* s along the torso */
    double shoulder[2], elbow[2], wrist[2]; /* s along the arms */
    double hip[2], knee[2], ankle[2];       /* s along the legs */
    mus__skeleton skeleton; /* of a scanned body: crown, shoulder joints and the arms' axes; the levels of its torso */
} mus__bones;

#define MUS__BONES_HIP 0.04   /* hip joints above the crotch, in parts of the stature */
#define MUS__BONES_ANKLE 0.30 /* ankle joints above the floor, in parts of the foot's length */

/* those of a body of a tape with feet of that length */
void mus__bones_measured(const mus__skeleton *skeleton, double foot, mus__bones *out);

/* a body of given limbs, as mus_body_create_limbs(); of a scan with bones (NULL: it is none), by which it can be posed
 * when it has a torso among them */
mus_status mus__body_create_jointed(mus_context *context, int32_t limbs, const mus_limb *limb, const mus__bones *bones,
                                    const mus_body_def *def, mus_body **out);

/* the levels of a scan's torso, once they are measured; NaN: there is none */
void mus__body_levels(mus_body *body, double bust, double waist, double hip);

#endif
