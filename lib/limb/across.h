/*
 * across.h: back and chest as broad from arm to arm as the tape says (across.c).
 */
#ifndef MUS_LIMB_ACROSS_H
#define MUS_LIMB_ACROSS_H

#include "limb/radius_field.h"

/* torso and one arm of a body in the rest pose, and what their parts (fields) are made of */
typedef struct mus__across {
    mus__limb *torso;
    const mus__limb *arm;
    int32_t torso_index, arm_index, fields;
    const mus__part *part; /* (fields) */
    mus__field *field;     /* (fields); without fillets */
    double side;           /* 1: a left arm, -1: a right one */
    double back, front;    /* the tape's across_back and across_front [m] */
    double range[2];       /* heights at which the torso is as it was [m] */
} mus__across;

/* give the torso bumps half way down the armhole, in its fields and contours, so that both lengths are the tape's; the
 * nearest, where one cannot be reached */
void mus__limb_across(const mus__across *in);

#endif
