/*
 * arrange_check.h: what is wrong with an arrangement of panels before it is sewn, and what is changed in it.
 */
#ifndef MUS_ARRANGE_ARRANGE_CHECK_H
#define MUS_ARRANGE_ARRANGE_CHECK_H

#include "arrange/placed_cloth.h"
#include "muslin/arrange.h"

/* ---- arrange_check.c, arrange_check_layers.c ---- */

/* panels inside the body, twisted seams, panels exchanged or turned round: the first fault found, or kind
 * MUS_REASON_NONE */
void mus__arrange_check(const mus__placed_cloth *placed, mus_reason *out);
/* panels through one another, layers whose order is not the same all round. Errors: MUS_ERR_MEMORY */
mus_status mus__arrange_check_layers(const mus__placed_cloth *placed, mus_reason *out);

/* ---- arrange_prefold.c, arrange_separate.c: both return or set whether any node was moved ---- */

/* fold panels that fan out wide, in place */
bool mus__arrange_fans(const mus__placed_cloth *placed);
/* move panels apart that lie over each other in one plane. Errors: MUS_ERR_MEMORY */
mus_status mus__arrange_separate(const mus__placed_cloth *placed, bool *moved);

#endif
