/*
 * coarse_drape.h: the drape of the next coarser cut, on which sew and settle run first.
 *
 * It is made at the first sew or settle of a cloth that has a coarser cut, and kept until the drape is destroyed. It
 * borrows the collider and the threads of its parent, and has a coarse drape of its own, down to the coarsest cut.
 * Restrict and prolong carry places from cut to cut (the terms are those of multigrid methods).
 */
#ifndef MUS_DRAPE_COARSE_DRAPE_H
#define MUS_DRAPE_COARSE_DRAPE_H

#include "drape/barycentric_transfer.h"
#include "muslin/drape.h"

typedef struct mus__coarse {
    mus_drape *parent;                 /* of a coarse drape; NULL for the drape of the caller */
    mus_drape *drape;                  /* NULL until the first sew or settle */
    void (*destroy)(mus_drape *drape); /* of `drape`, set with it */
    mus__transfer up, down;            /* coarse to fine, fine to coarse */
    double *pinned_x;                  /* (n x 3) places of the fixed nodes while prolonging; made with `drape` */
    int32_t as_sewn;                   /* nonzero, with self-contact: the coarse drape lies as the last sew left it */
} mus__coarse;

/* make the coarse drape if need be, with room for the tacks of `drape`. *out: NULL when the cloth has no coarser cut.
 * Errors: MUS_ERR_MEMORY */
mus_status mus__coarse_create(mus_drape *drape, mus_drape **out);
/* put the coarse drape where the drape is: places, welding, tacks, pins (the nearest node stands for a fixed node) */
void mus__coarse_restrict(mus_drape *drape);
/* put the drape where its coarse drape is, with its velocities and welding; fixed nodes stay. Takes over the counters
 * of the coarse drape */
void mus__coarse_prolong(mus_drape *drape);
/* give the coarse drape the tacks of `drape`, before its program is made of them (tack.c) */
void mus__tack_restrict(mus_drape *drape);

#endif
