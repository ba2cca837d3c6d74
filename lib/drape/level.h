/*
 * level.h: a drape's coarser double, on which sew and settle run first.
 *
 * Made at the first sew or settle of a cloth that has a coarser cut, kept until the drape is destroyed. It shares the
 * body's fields and the threads, and has a coarser double of its own, down to the coarsest cut.
 */
#ifndef MUS_DRAPE_LEVEL_H
#define MUS_DRAPE_LEVEL_H

#include "drape/drape_internal.h"

/* the coarser double, made if need be, with room for the drape's tacks; *out NULL when the cloth has no coarser cut.
 * Errors: MUS_ERR_MEMORY */
mus_status mus__drape_coarse(mus_drape *drape, mus_drape **out);
void mus__drape_coarse_destroy(mus_drape *drape);
/* the double starts where the drape is: positions, welding, tacks, pins (the nearest node takes a held node's place) */
void mus__drape_restrict(mus_drape *drape);
/* its tacks (tack.c), before its plan is made of them */
void mus__drape_restrict_tacks(mus_drape *drape);
/* the drape goes where its double is, velocities and welding too; held nodes stay. Takes over the double's counts. */
void mus__drape_prolong(mus_drape *drape);

#endif
