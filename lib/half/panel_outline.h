/*
 * panel_outline.h: the outline of a panel as it is drawn: edges counter-clockwise in the frame of the blocks (x
 * from the centre line to the side). It becomes a panel of the half as it is, or as its mirror image for a back.
 */
#ifndef MUS_PANEL_OUTLINE_H
#define MUS_PANEL_OUTLINE_H

#include "half/half_garment.h"

#define MUS__OUTLINE_EDGES 16      /* of one outline: a straight skirt with two darts and a slit has 11 */
#define MUS__OUTLINE_NAME_BYTES 16 /* of an edge's name, with the end */

typedef struct mus__outline_edge {
    char name[MUS__OUTLINE_NAME_BYTES];
    const char *label; /* "" for none; lives as long as the outline */
    double allowance;  /* [m] */
    mus__chain chain;
} mus__outline_edge;

typedef struct mus__outline {
    int32_t n;
    mus__outline_edge edge[MUS__OUTLINE_EDGES];
} mus__outline;

void mus__outline_begin(mus__outline *outline);
/* adds the next edge */
void mus__outline_add(mus__outline *outline, const char *name, const char *label, double allowance,
                      const mus__chain *chain);
/* adds a straight edge */
void mus__outline_line(mus__outline *outline, const char *name, const char *label, double allowance,
                       const double *start, const double *end);
/* adds the edges of another outline */
void mus__outline_append(mus__outline *outline, const mus__outline *more);
/* length of its edges with a label [m] */
double mus__outline_length(const mus__outline *outline, const char *label);
/* makes the outline, or with `mirror` its image in x = 0 in reverse order, a panel of the half. Returns its index */
int32_t mus__outline_panel(mus__half *half, const mus__outline *outline, const char *name, const char *label,
                           bool mirror);

#endif
