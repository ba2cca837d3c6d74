/*
 * barycentric_transfer.h: where the nodes of one cloth lie in another cut of the same pattern.
 *
 * A node lies in the triangle of its panel that holds its place in the flat, or in the nearest one: three nodes and
 * their weights. The same carries a shape from a coarse mesh to a fine one and back, or, when a pattern was changed
 * a little, from the old panels to the new ones (places are then taken relative to the panels' boxes).
 */
#ifndef MUS_DRAPE_BARYCENTRIC_TRANSFER_H
#define MUS_DRAPE_BARYCENTRIC_TRANSFER_H

#include "cloth/cloth_internal.h"

typedef struct mus__transfer {
    int32_t n;
    int32_t *node; /* (n x 3) of the source */
    float *weight; /* (n x 3) not negative, sum 1 */
} mus__transfer;

/* for each node of `to`, its place in `from`; both have the same number of panels. Frees nothing on failure. */
mus_status mus__transfer_build(mus_context *context, const mus_cloth *from, const mus_cloth *to, mus__transfer *out);
void mus__transfer_clear(mus_context *context, mus__transfer *transfer);
/* to (n x 3) = the places of the nodes in the source's positions `from` */
void mus__transfer_apply(const mus__transfer *transfer, const double *from, double *to);
/* the source's node that has most of the weight at node i */
int32_t mus__transfer_nearest(const mus__transfer *transfer, int32_t i);

#endif
