/*
 * chord_lift.h: how far nodes stay off the skin so that the flat triangles between them do (chord_lift.c).
 */
#ifndef MUS_DRESS_CHORD_LIFT_H
#define MUS_DRESS_CHORD_LIFT_H

#include <stdbool.h>

#include "muslin/drape.h"

/* [m] that triangles stay off the field of a limb; chosen: the drawn skin is farther than 0.5 mm from its fields on a
 * thousandth of its area (`make outside`) */
#define MUS__LIFT_CLEAR 3e-4

/* its memory, with lifts of 0, for a drape round a body. Errors: MUS_ERR_MEMORY */
mus_status mus__chord_lift_create(mus_drape *drape);
/* the same with the lifts of a cloth that lies already, so that no node comes nearer to the skin than its triangles
 * allow */
mus_status mus__chord_lift_begin(mus_drape *drape);
/* takes the lifts anew at places x (n x 3, of representatives); thin: from parts with free ends alone, hands and feet;
 * rest: the cloth lies at rest, and no lift falls, so that it comes to rest again. Returns the largest rise [m] */
double mus__chord_lift(mus_drape *drape, const double *x, bool thin, bool rest);

#endif
