/*
 * body_level.h: levels of a body: planes across a limb, at which girths are taken and edges of a garment are attached.
 *
 * They are data of a body (body_internal.h), found once by body_level.c: who reads them links no code of lib/body.
 */
#ifndef MUS_BODY_BODY_LEVEL_H
#define MUS_BODY_BODY_LEVEL_H

#include <stdint.h>

enum {
    MUS__LEVEL_NECK = 1, /* the numbers of MUS_HOLD_* of muslin/pattern.h */
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

/* a level in the rest pose: a point of it, the unit directions towards the root of the limb (up) and to the limb's left
 * (side), and the part of the rig that carries it */
typedef struct mus__body_level {
    int32_t there; /* 0: the body does not have the level */
    int32_t limb, part;
    double point[3], up[3], side[3];
} mus__body_level;

#endif
