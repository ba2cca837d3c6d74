/*
 * sleeve.h: what the files of sleeves and cuffs share.
 */
#ifndef MUS_SLEEVE_H
#define MUS_SLEEVE_H

#include "block/block_fullness.h"
#include "half/boundary.h"
#include "half/panel_place.h"
#include "style/parts.h"

/* what the style and the armhole ask of a sleeve */
typedef struct mus__sleeve_plan {
    mus__boundary arm;               /* the armhole, from the front underarm round */
    int32_t shoulder;           /* number of its first side behind */
    double front, back;         /* its lengths before and behind */
    double front_low, back_low; /* underarm to pitch */
    double ease;                /* of the cap, as a part of it */
    double reach;               /* how far down the arm it goes, from the biceps line 0 to the wrist 1 */
    double cuff_length, cuff_depth; /* 0: none */
    mus__sleeve block;              /* without its cuff */
} mus__sleeve_plan;

void mus__sleeve_plan_read(mus__half *half, mus__sleeve_plan *out);

/* ---- sleeve_raglan.c, sleeve_dolman.c: sleeves that take part of the front and back along ---- */

void mus__sleeve_raglan(mus__half *half, mus__sleeve_plan *plan);
void mus__sleeve_dolman(mus__half *half, mus__sleeve_plan *plan);

/* ---- cuff_style.c ---- */

/* a band of `length` sewn to the cuff edge of the half, `down` below the crown along the arm */
void mus__cuff_attach(mus__half *half, double length, double depth, double down);

#endif
