/*
 * hands_feet.h: the hands and feet of a collider, how they come into clothes, and where they end (hands_feet.c).
 */
#ifndef MUS_CONTACT_HANDS_FEET_H
#define MUS_CONTACT_HANDS_FEET_H

#include "contact/collider.h"

/* spread: hands and feet as they are made. Else as they are put into clothes: fingers held together, and no feet, which
 * come later, from above */
void mus__collider_spread(mus__collider *collider, bool spread);
/* the parts, a bit each, that are feet */
uint64_t mus__collider_feet(const mus__collider *collider);
/* the parts, a bit each, that are hands or feet */
uint64_t mus__collider_thin_parts(const mus__collider *collider);
/* free ends of the body in the world, of hands and their fingers: axes from root to tip (at most `most` x 6). Returns
 * their number */
int32_t mus__collider_ends(const mus__collider *collider, int32_t most, double *end);

#endif
