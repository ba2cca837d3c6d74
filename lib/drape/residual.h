/*
 * residual.h: the force left at each node (residual.c).
 */
#ifndef MUS_DRAPE_RESIDUAL_H
#define MUS_DRAPE_RESIDUAL_H

#include "muslin/drape.h"

/* rms over free nodes of the force that contact and friction leave at places x (n x 3), over the node's weight; the
 * forces go to relax.force. At relax.mean, a node that touches anything has no more left than moved it (relax.moving)
 */
double mus__residual(const mus_drape *drape, const double *x);
/* the residual that the rounding of a float state leaves in the mean place of many steps, by stepping.stiffness; and
 * whether a drape that lies flat has more of it than a settle allows (float_rounding.c) */
double mus__residual_rounding(const mus_drape *drape);
int32_t mus__float_too_coarse(mus_drape *drape);

/* how much farther than the clearance node i stays off the skin (dress/chord_lift.c) [m] */
double mus__drape_lift(const mus_drape *drape, int32_t i);
/* forgets the lifts, those of coarser cuts too, and gives their memory back */
void mus__drape_lift_clear(mus_drape *drape);

#endif
