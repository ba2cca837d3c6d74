/*
 * sleeve.h: what the files of sleeves and cuffs share.
 */
#ifndef MUS_SLEEVE_H
#define MUS_SLEEVE_H

#include "block/block_fullness.h"
#include "half/boundary_loop.h"
#include "half/half_placement.h"
#include "style/style_parts.h"

/* figures of a sleeve by its style and its armhole */
typedef struct mus__sleeve_plan {
    mus__boundary arm;               /* the armhole, from the front underarm round */
    int32_t shoulder;           /* number of its first half-edge behind the shoulder */
    double front, back;         /* lengths of its front and back [m] */
    double front_low, back_low; /* arc lengths from the underarm to the pitch [m] */
    double ease;                /* ease of the cap, as a part of the armhole */
    double reach;               /* end of the sleeve along the arm, from 0 at the biceps line to 1 at the wrist */
    double cuff_length, cuff_depth; /* [m]; 0: no cuff */
    mus__sleeve block;              /* without its cuff */
} mus__sleeve_plan;


/* ---- sleeve_raglan.c, sleeve_dolman.c: sleeves that recut front and back ---- */

void mus__sleeve_raglan(mus__half *half, mus__sleeve_plan *plan);
void mus__sleeve_dolman(mus__half *half, mus__sleeve_plan *plan);

/* ---- cuff.c ---- */

/* Sews a band of `length` and `depth` to the end of the sleeve, placed `down` below the crown along the arm [m]. */
void mus__cuff_attach(mus__half *half, double length, double depth, double down);

#endif
