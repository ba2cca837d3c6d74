/*
 * block_skirt.h: the straight skirt block, front and back half.
 *
 * Frame: x from the centre line to the side, y up, y = 0 at the centre of the top edge; lengths in metre.
 */
#ifndef MUS_BLOCK_SKIRT_H
#define MUS_BLOCK_SKIRT_H

#include "block/block_bodice.h"

typedef struct mus__skirt_def {
    double waist, hip;  /* girths of the body at the top edge and at the hip [m] */
    double depth;       /* from the top edge to the hip level */
    double waist_ease, hip_ease;
    double length;      /* from the top edge to the hem, at the centre */
    double flare;       /* width of the hem less that of the hip, in one half */
    double rise;        /* height of the top edge at the side above its centre */
    double shift;       /* moves waist from the back half to the front half, beside the 5 mm of the block */
    double dart_at[2];  /* front, back: first dart from the centre, darts closed; 0: as in the block */
    bool darts;
} mus__skirt_def;

/* a front or back half of a skirt, y = 0 at the centre of its top edge */
typedef struct mus__skirt_half {
    double waist[8];     /* centre to side */
    double side_high[8]; /* waist to hip */
    double side_low[8];  /* hip to hem */
    double hem[8];       /* centre to side */
    double hip, hem_width;
    double dart_width; /* of all darts of the half */
    int32_t ndart;
    double dart[MUS__DARTS][6];  /* inner mouth, point, outer mouth; from the centre outwards */
    double dart_s[MUS__DARTS][2]; /* arc lengths of the mouths along `waist` */
    double waist_length; /* darts closed */
    double side_length, side_high_length;
} mus__skirt_half;

typedef struct mus__skirt {
    mus__skirt_half front, back;
} mus__skirt;

mus_status mus__skirt_draft(mus_context *context, const mus__skirt_def *def, mus__skirt *out);

#endif
