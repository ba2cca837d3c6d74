/*
 * start.h: where a panel would lie best among those that it is sewn to (start.c).
 */
#ifndef MUS_DRAPE_START_H
#define MUS_DRAPE_START_H

#include "muslin/drape.h"

typedef struct mus__start {
    double length;           /* of its seams to other panels [m], 0 without: the rest is then 0 */
    double now, best;        /* mean distance of its seam nodes to their partners, as it lies and at best [m] */
    double turned;           /* cosine of the angle by which it would turn */
    double from[3], to[3];   /* its middle, as it lies and at best */
} mus__start;

/* of one panel, seams to panel `except` (MUS_NONE: none) left out */
void mus__start_fit(const mus_drape *drape, int32_t panel, int32_t except, mus__start *out);

#endif
