/*
 * arrange_nodes.h: the nodes of a cloth where the placement of their panels puts them (arrange_nodes.c).
 */
#ifndef MUS_ARRANGE_ARRANGE_NODES_H
#define MUS_ARRANGE_ARRANGE_NODES_H

#include "cloth/cloth_internal.h"

/* distance between the starts of two successive layers of panels [m]; chosen: more than the depth of a pleat */
#define MUS__LAYER_OUT 0.02

/* places of all nodes before sewing: x (nnode x 3) [m] */
void mus__arrange_nodes(const mus_cloth *cloth, double *x);
/* places of the nodes of one panel, `out` [m] farther off on its right side (below 0: on its wrong side); x (nnode x 3)
 * is written for these nodes alone */
void mus__arrange_panel(const mus_cloth *cloth, int32_t panel, double out, double *x);

#endif
