/*
 * near.h: the contact pass for nodes that move little from call to call: each remembers the plane of the skin near it.
 *
 * A node is asked of the surfaces again only when it has left the ball round the place where it was last asked: for a
 * node near the skin a ball so small that the plane stands for the curved skin, for one farther off the ball of half
 * its distance. Between, a node costs a dozen multiplications, many nodes at once. The response is that of contact.h.
 */
#ifndef MUS_CONTACT_NEAR_H
#define MUS_CONTACT_NEAR_H

#include "contact/contact.h"

/* near (8 n): outward normal (3), depth, place asked at (3), squared radius of the ball, a plane each. A radius below 0
 * asks at the next call */
#define MUS_NEAR_PLANES 8

/* nodes first .. last-1 of n; x, v planes (3 x n); inverse (n) 0 for nodes that are held. All surfaces must be at rest
 */
void mus__near_f32(const mus__collider *collider, const mus__contact_rule *rule, int32_t n, int32_t first, int32_t last,
                   const float *inverse, float *near, float *x, float *v, mus__contact_tally *tally);
void mus__near_f64(const mus__collider *collider, const mus__contact_rule *rule, int32_t n, int32_t first, int32_t last,
                   const double *inverse, double *near, double *x, double *v, mus__contact_tally *tally);

#endif
