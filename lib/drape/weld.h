/*
 * weld.h: seams opened and welded (weld.c).
 */
#ifndef MUS_DRAPE_WELD_H
#define MUS_DRAPE_WELD_H

#include "muslin/drape.h"

/* open all seams */
void mus__weld_open(mus_drape *drape);
/* weld the seams of the layers that do not wait */
void mus__weld(mus_drape *drape);
/* mus__weld_open and mus__weld in one, with the nodes where they were put */
void mus__weld_anew(mus_drape *drape);
/* open the seams again that were open when the sewing of this layer began, with the nodes at x (n x 3) */
void mus__weld_reopen(mus_drape *drape, const double *x);
/* stiffness of a seam pair near the end [N/m]: more than the cloth that it joins, so that a tight seam closes */
double mus__weld_pair_stiffness(const mus_drape *drape);
/* largest gap [m] of the seam pairs of layers that do not wait, and its seam (may be NULL); 0 without seams */
double mus__weld_gap(const mus_drape *drape, int32_t *seam);

#endif
