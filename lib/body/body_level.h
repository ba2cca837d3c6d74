/*
 * body_level.h: the levels of a body that a garment is held at and its ease is told at: planes across a limb.
 */
#ifndef MUS_BODY_BODY_LEVEL_H
#define MUS_BODY_BODY_LEVEL_H

#include "muslin/body.h"

enum {
    MUS__LEVEL_NECK = 1, /* as MUS_HOLD_* of muslin/pattern.h */
    MUS__LEVEL_ARMPIT,
    MUS__LEVEL_BUST,
    MUS__LEVEL_WAIST,
    MUS__LEVEL_HIP,
    MUS__LEVEL_CROTCH,
    MUS__LEVEL_BICEPS,
    MUS__LEVEL_WRIST,
    MUS__LEVEL_THIGH,
    MUS__LEVEL_KNEE,
    MUS__LEVEL_ANKLE,
    MUS__LEVEL_COUNT
};

/* where a level lies as the body was made: a point on it, the unit directions towards the root of the limb and to the
 * limb's left, the part of the rig that it moves with */
typedef struct mus__body_level {
    int32_t there; /* 0: the body has it not */
    int32_t limb, part;
    double point[3], up[3], side[3];
} mus__body_level;

/* right: 0 the left limb, 1 the right one, of levels on limbs */
void mus__body_level_find(const mus_body *body, int32_t level, int32_t right, mus__body_level *out);

/* half the breadth over the ends of the shoulder lines, and at the neck where they begin; 0: a body without measures */
double mus__body_shoulder(const mus_body *body, double *neck);

#endif
