/*
 * self_contact.h: self-contact: cloth against cloth, node against triangle and edge against edge, with thickness and
 * friction. Start here to read lib/selfcontact.
 *
 * A call after each step. It never asks whether two things met within a step, because none can: every node has a
 * displacement bound, a ball round the place where distances were last measured, and is held in it until they are
 * measured again (per-vertex displacement bounds; Chen and others, Offset Geometric Contact, 2025).
 *
 * Why that suffices: take two things (node and triangle, or edge and edge, without a common node) at distance D, and
 * bounds of less than D/2 for each of their nodes. A point of either is a mean of its nodes, so it moves by less than
 * D/2 too, and the two never touch. Two triangles that do not cross can begin to cross only where such a pair touches.
 * So where no triangles cross, none ever will: at any speed, in any step, whatever forces and other contact do to the
 * nodes.
 *
 * The bounds may drift: a node's ball moves with the velocity that the node had of late. Each pair's clearance is
 * reduced by the distance that the drift velocities can close before the bounds are made anew. Seen from a frame that
 * drifts with the pair nothing else has changed. Cloth that falls or walks at any speed is therefore measured as often
 * as cloth that ripples.
 *
 * A call does, in this order:
 *
 * 1. neighbour_list_kernel.h: the pairs nearer than the thickness and two margins, from trees of boxes (box_tree.c; the
 *    list with a margin is that of Verlet, Computer "experiments" on classical fluids, 1967). The list is made anew
 *    when it is older than it was made for, or in part, for the nodes that have used up their margin.
 * 2. pair_distance_kernel.h, displacement_bound_kernel.h: the distances of the pairs in the list, and from them the
 *    displacement bounds; made anew when a node comes to the end of its bound.
 * 3. active_pairs_kernel.h, self_response_kernel.h: pairs that may be nearer than the thickness are active and answer
 *    every call: impulses that end their approach, friction of up to mu times these, and a push apart. Each starts from
 *    the impulses of the last call (warm start; Catto 2006), so that a steady load is carried after some calls however
 *    many pairs share it, and friction holds what it can.
 *
 * self_contact.c holds the memory and the mesh; crossing_count.c counts exactly what goes through what.
 *
 * Cloth may cross at the start. Nodes of triangles that cross are marked (`crossed`): two things that both have such a
 * node may pass through each other, until a count finds that they no longer cross. All else is as above.
 *
 * The bounds are applied after the response, which therefore may give nodes any place and velocity.
 *
 * A pair's thickness is that of the drape; within a panel at most half the distance of the two in the flat, and across
 * a seam half the least height of the triangles there, so that flat cloth never touches itself. Nodes that a seam joins
 * count as one, sewn or not yet. Where cloth presses a node into the body, the caller may thin its pairs (yield).
 */
#ifndef MUS_SELFCONTACT_SELF_CONTACT_H
#define MUS_SELFCONTACT_SELF_CONTACT_H

#include "selfcontact/self_contact_state.h"

typedef struct mus__self_rule {
    double step;  /* time since the last call [s] */
    double slip;  /* as in mus__contact_rule [s] */
    double push;  /* an overlap is put apart by at most this in one call [m] */
    int32_t body; /* nonzero: there is a body, and the velocities before its answer are known */
} mus__self_rule;

/* class_of (nodes): one class, its smallest node, for the nodes that pairs (npair x 2) join */
void mus__self_classes(int32_t nodes, int32_t npair, const int32_t *pair, int32_t *class_of);

/* self-contact of a cloth whose state has planes of n numbers of `real` bytes; allocates all that calls need */
mus_status mus__self_contact_create(mus_context *context, size_t real, int32_t n, const mus__self_mesh *flat,
                                    double thickness, double friction, mus__self_contact **out);
void mus__self_contact_destroy(mus__self_contact *self);
/* triangles are from now on those of the nodes that stand for each: rep (nodes), NULL: each for itself; without those
 * of nodes that have any of the bits of `absent` in flags (nodes) */
void mus__self_contact_weld(mus__self_contact *self, const int32_t *rep, const int32_t *flags, int32_t absent);
/* between steps: marks the nodes that are part of a crossing at x (nodes x 3); returns the number of pairs of triangles
 * that cross. fn as of mus__crossing_count(), may be NULL */
int64_t mus__self_contact_mark_crossings(mus__self_contact *self, const double *x, mus__crossing_fn fn, void *user);
/* between steps, with a list just made of x (nodes x 3): moves pairs nearer than `least` [m] to that distance, one
 * after the other, but not the nodes that are held (nodes). Returns their number; they may cross others then */
int32_t mus__self_contact_separate(const mus__self_contact *self, double least, const int32_t *held, double *x);
/* between steps: until the next weld no pair of the nodes that are marked (nodes) is thicker than 0.7 of what was
 * allowed before, down to a quarter of the thickness. Nonzero when that made any pair thinner */
int32_t mus__self_contact_yield(mus__self_contact *self, const uint8_t *marked);
/* between steps: memory for twice the pairs where it became narrow. MUS_ERR_MEMORY, MUS_ERR_LIMIT */
mus_status mus__self_contact_grow(mus__self_contact *self);

/* before steps of h [s]: nonzero when the bounds do not hold so long, and must be made anew first */
int32_t mus__self_contact_expires(const mus__self_contact *self, double h);

/* before a step, where places were changed from outside: list and bounds of x, planes (3 x n) */
void mus__self_contact_prepare_f32(mus__self_contact *self, const float *x);
void mus__self_contact_prepare_f64(mus__self_contact *self, const double *x);
/* after a step: x, v planes (3 x n) are changed in place; inverse (n) 1/mass, 0 for nodes that are held */
void mus__self_contact_pass_f32(mus__self_contact *self, const mus__self_rule *rule, const float *inverse, float *x,
                                float *v);
void mus__self_contact_pass_f64(mus__self_contact *self, const mus__self_rule *rule, const double *inverse, double *x,
                                double *v);

#endif
