/*
 * start.h: the parts of the look at a start (start.c, start_layer.c).
 */
#ifndef MUS_DRAPE_START_H
#define MUS_DRAPE_START_H

#include "muslin/drape.h"

/* where a panel would lie best among those that it is sewn to */
typedef struct mus__start {
    double length;           /* of its seams to other panels [m], 0 without: the rest is then 0 */
    double now, best;        /* mean distance of its seam nodes to their partners, as it lies and at best [m] */
    double turned;           /* cosine of the angle by which it would turn */
    double from[3], to[3];   /* its middle, as it lies and at best */
    double facing[3];        /* mean of its normals, at best */
} mus__start;

/* of one panel, seams to panel `except` (MUS_NONE: none) left out */
void mus__start_fit(const mus_drape *drape, int32_t panel, int32_t except, mus__start *out);

/* mean of a panel's normals, by area: 1 long when it is flat; and the middle of its nodes */
void mus__start_facing(const mus_drape *drape, int32_t panel, double *out);
void mus__start_middle(const mus_drape *drape, int32_t panel, double *out);

/* note a tangled start; panel and seam may be MUS_NONE */
void mus__start_tangled(mus_reason *out, int32_t panel, int32_t seam, const char *text);

/* panels through one another, layers whose order is not the same all round */
mus_status mus__start_layers(const mus_drape *drape, mus_reason *out);

#endif
