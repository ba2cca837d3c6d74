/*
 * plane_cache.h: the contact pass for nodes that move little from call to call: each remembers the plane of the surface
 * near it. The response is that of contact.h.
 *
 * A node is queried again only when it has left a ball round the place of its last query: near a surface a ball so
 * small that the plane stands for the curved surface, further off a ball of half the distance. In between a node costs
 * a dozen multiplications, many nodes at once. Used by sew and settle, where nothing is fast.
 */
#ifndef MUS_CONTACT_PLANE_CACHE_H
#define MUS_CONTACT_PLANE_CACHE_H

#include "contact/contact.h"

/* [m] radius of the ball near a surface; chosen: at its edge the plane of a limb of 5 cm radius is off by 0.6 um
 * (r^2 / 2R) */
#define MUS__CACHE_RADIUS 2.5e-4
/* [m] deeper than this a node is put back faster, by rule.deep; chosen: half the default clearance */
#define MUS__CACHE_DEEP 1e-3

/* a node's cache, in planes of n: outward normal (3), depth, place of the query (3), squared radius of the ball. A
 * squared radius below 0: query at the next call */
#define MUS__CACHE_PLANES 8

/* answers the contacts of `nodes` (without `before`) with their planes (MUS__CACHE_PLANES x n, of the state's type).
 * All surfaces must be at rest */
void mus__plane_cache_pass_f32(const mus__collider *collider, const mus__contact_rule *rule,
                               const mus__contact_nodes *nodes, void *planes, mus__contact_tally *tally);
void mus__plane_cache_pass_f64(const mus__collider *collider, const mus__contact_rule *rule,
                               const mus__contact_nodes *nodes, void *planes, mus__contact_tally *tally);

#endif
