/*
 * bones.h: the names of a body's limbs, and the places of its joints along them.
 *
 * The bones of a body of a tape come from its skeleton, those of a scanned body from its contours; a body of given
 * limbs has none. A body with bones has a rig and can be posed. Index 0 is the left side, 1 the right.
 */
#ifndef MUS_BODY_BONES_H
#define MUS_BODY_BONES_H

#include "limb/skeleton.h"
#include "muslin/body.h"

#define MUS__LIMB_COUNT 7 /* limbs of a body made from a tape */

/* index of a limb in mus_body.limb of a body made from a tape, and in mus__bones.limb of every body */
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
    int32_t limb[MUS__LIMB_COUNT];          /* index of the limb in mus_body.limb; MUS_NONE: the body does not have it
                                               */
    double lumbar, neck;                    /* s along the torso [m] */
    double shoulder[2], elbow[2], wrist[2]; /* s along the arms [m] */
    double hip[2], knee[2], ankle[2];       /* s along the legs [m] */
    mus__skeleton skeleton; /* of a scanned body only crown, shoulder joints, arm axes and the levels of the torso */
} mus__bones;

/* heights of joints, means of ANSUR II and of GarmentCode's mean bodies */
#define MUS__BONES_HIP 0.04   /* hip joints above the crotch, in parts of the stature */
#define MUS__BONES_ANKLE 0.30 /* ankle joints above the floor, in parts of the foot's length */

/* bones of a body of a tape, from its skeleton and the length of its feet [m] */
void mus__bones_measured(const mus__skeleton *skeleton, double foot, mus__bones *out);

/* make a body of given limbs as mus_body_create_limbs() does; with the bones of a scan (NULL: not a scan) it can be
 * posed if they have a torso */
mus_status mus__body_create_jointed(mus_context *context, int32_t limbs, const mus_limb *limb, const mus__bones *bones,
                                    const mus_body_def *def, mus_body **out);

/* set the heights [m] of bust, waist and hip of a scan, once they are measured; NaN: it has none */
void mus__body_levels(mus_body *body, double bust, double waist, double hip);

#endif
