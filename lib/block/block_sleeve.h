/*
 * block_sleeve.h: the sleeve block.
 *
 * Frame: y = 0 on the biceps line, y up; the left sleeve with its front at x < 0; lengths in metre.
 */
#ifndef MUS_BLOCK_SLEEVE_H
#define MUS_BLOCK_SLEEVE_H

#include "block/block_curve.h"
#include "block/measures.h"

typedef struct mus__sleeve_def {
    double front, back; /* lengths of the front and back halves of the cap [m] */
    double width;       /* width on the biceps line */
    double length;      /* from the crown to the hem */
    double hem;         /* width at the hem */
} mus__sleeve_def;

typedef struct mus__sleeve {
    double width, height, crown, length, hem; /* crown: x of the crown */
    double cap_front[8];                      /* front underarm to crown */
    double cap_back[8];                       /* crown to back underarm */
    double front_length, back_length;
} mus__sleeve;

mus_status mus__sleeve_draft(mus_context *context, const mus__sleeve_def *def, mus__sleeve *out);
/* biceps width at which a cap of length `cap` is `ratio` of that length high */
double mus__sleeve_width(double cap, double ratio);

#endif
