/*
 * block_skirt.h: the straight skirt block, front and back half.
 *
 * Frame: x from the centre line to the side, y up, y = 0 at the centre of the top edge; lengths in metre.
 */
#ifndef MUS_BLOCK_SKIRT_H
#define MUS_BLOCK_SKIRT_H

#include "block/block_bodice.h"

typedef struct mus__skirt_def {
    double waist, hip;  /* girths of the body at the top edge and at the hip */
    double depth;       /* top edge to hip level */
    double waist_ease, hip_ease;
    double length;      /* top edge to hem, at the centre */
    double flare;       /* hem wider than the hip by, a half */
    double rise;        /* top edge higher at the side by */
    double shift;       /* waist of the front wider by, of the back narrower: beyond the block's own 5 mm */
    double dart_at[2];  /* front, back: the first dart so far from the centre, darts closed; 0: the block's own place */
    bool darts;
} mus__skirt_def;

/* a front or back half of a skirt, y = 0 at the centre of its top edge */
typedef struct mus__skirt_half {
    double waist[8];     /* centre to side */
    double side_high[8]; /* waist to hip */
    double side_low[8];  /* hip to hem */
    double hem[8];       /* centre to side */
    double hip, hem_width;
    double dart_width; /* all darts */
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
