/*
 * sew.h: sewing: the pull on seam pairs, welding, layers one after the other.
 *
 * Files, in the order of use: sew.c (mus_drape_sew), layers.c (several layers), seam_route.c (the way of a pair's pull
 * round a limb), weld.c (nodes of closed pairs become one).
 */
#ifndef MUS_DRESS_SEW_H
#define MUS_DRESS_SEW_H

#include "dress/progress.h"
#include "drape/weld.h"

/* take the memory of sewing, if need be; it is kept until the drape is destroyed. Errors: MUS_ERR_MEMORY */
mus_status mus__sew_create(mus_drape *drape);

/* the step [s] of sewing at this pose, and *steps of them, without gravity: *steps gets the number that was taken, and
 * the clock is told. Errors: those of mus__relax_run(), MUS_ERR_MEMORY */
double mus__sew_step(mus_drape *drape);
mus_status mus__sew_run(mus_drape *drape, mus__progress *run, double h, int32_t *steps);

/* ---- seam_route.c ---- */

typedef enum mus__straps { MUS__STRAPS_NONE, MUS__STRAPS_ON, MUS__STRAPS_OFF } mus__straps;

/* find which pairs close over the shoulders, which under the arms, and which are straps'. Needs sewing.outward */
void mus__seam_route_start(mus_drape *drape);
/* set the detours of open pairs round the body; `check` counts the calls. hang: straps pull in full, all else less.
 * early: the pull still rises, and tubes close first */
void mus__seam_route(mus_drape *drape, bool hang, bool early, int32_t check);
/* before welding: whether all straps are on the shoulders; *off (may be NULL) gets the seam of one that is not */
mus__straps mus__seam_route_straps(const mus_drape *drape, int32_t *off);

/* ---- layers.c ---- */

typedef mus_status (*mus__sew_fn)(mus_drape *drape, mus__progress *run);

/* nonzero: panels are in several layers, and the drape has self-contact */
int32_t mus__layers_needed(const mus_drape *drape);
/* sew layer after layer and let each down; `all` sews on every cut, `here` on this one */
mus_status mus__layers_sew(mus_drape *drape, mus__progress *run, mus__sew_fn all, mus__sew_fn here);
/* nonzero: the straight line between two nodes ends on the other side of a worn layer. A line that goes into a fold and
 * out of it again does not count, nor do triangles with either node. Cost: a box test a worn triangle */
int32_t mus__layers_between(const mus_drape *drape, int32_t i, int32_t k);
/* crossings of a layer's triangles with those of the layers below it */
int64_t mus__layers_crossings(const mus_drape *drape, int32_t layer);

#endif
