/*
 * self_contact.h: self-contact: cloth against cloth, node against triangle and edge against edge, with thickness and
 * friction. Start here to read the self_* part of lib/contact.
 *
 * A call after each step. It never asks whether two things met within a step, because none can: every node has a
 * displacement bound, a ball round the place where distances were last measured, and is held in it until they are
 * measured again (per-vertex displacement bounds; Chen and others, Offset Geometric Contact, 2025):
 *
 *   Take two things (node and triangle, or edge and edge, without a common node) at distance D, and bounds of less than
 *   D/2 for each of their nodes. A point of either is a mean of its nodes, so it moves by less than D/2 too, and the
 * two never touch. Two triangles that do not cross can begin to cross only where such a pair touches. So where no
 *   triangles cross, none ever will: at any speed, in any step, whatever forces and other contact do to the nodes.
 *
 * The bounds may drift: a node's ball moves with the velocity that the node had of late. Each pair's clearance is
 * reduced by the distance that the drift velocities can close before the bounds are made anew. Seen from a frame that
 * drifts with the pair nothing else has changed. Cloth that falls or walks at any speed is therefore measured as often
 * as cloth that ripples.
 *
 * A call does, in this order:
 *
 *   neighbour list   pairs nearer than thickness + 2 margins, from trees of boxes (Verlet, Computer "experiments" on
 *   (_list_)         classical fluids, 1967): made anew when it is older than it was made for, or in part, for the
 * nodes that have used up their margin bounds           distances of the pairs in the list, and from them the
 * displacement bounds; made anew when a node
 *   (_bound_)        comes to the end of its bound
 *   response         pairs that may be nearer than the thickness are active and answer every call: impulses that end
 *   (_pair_)         their approach, friction of up to mu times these, and a push apart. Each starts from the impulse
 * of the last call (warm start; Catto 2006), so that a steady load is carried after some calls however many pairs share
 * it
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
#ifndef MUS_CONTACT_SELF_CONTACT_H
#define MUS_CONTACT_SELF_CONTACT_H

#include "contact/crossing_count.h"
#include "contact/box_tree.h"

typedef struct mus__self_pair { /* a node and a triangle, or two edges */
    int32_t node[4];
    float thickness; /* [m] */
    float impulse;   /* along the normal in the last call [N s] */
    float idle2;     /* while no node has travelled this far (squared), its things do not touch [m2] */
} mus__self_pair;

/* the mesh at rest */
typedef struct mus__self_mesh {
    int32_t nodes, ntriangle, npair;
    const int32_t *triangle; /* (ntriangle x 3) */
    const double *rest;      /* (nodes x 2) in the planes of the panels; borrowed for the life of the self-contact */
    const int32_t *panel;    /* (nodes) borrowed likewise */
    const int32_t *pair;     /* (npair x 2) nodes that seams join */
} mus__self_mesh;

#define MUS__RANK_NONE 254 /* rank of a node that nothing supports */
#define MUS__RANK_MAX 8    /* layers on each other that know what supports them; chosen: more is never worn */

typedef struct mus__self_contact {
    mus_context *context;
    size_t real;                  /* bytes of a number of the state */
    int32_t n, nodes;             /* numbers from plane to plane of the state; nodes */
    int32_t ntriangle;            /* with corners of three classes */
    double thickness, friction;   /* [m], coefficient */
    double mean_edge;             /* mean edge length of the triangles [m] */
    double margin_max;            /* margin of the list where there is memory for all pairs [m] */
    double margin;                /* a node may travel so far from its list home until it is listed anew [m] */
    double list_age, list_span;   /* age of the list, and the age that it was made for [s] */
    double bound_age, bound_span; /* the same of the bounds [s] */
    double travel2_max;           /* largest of travel2 [m2] */
    double mean[3];               /* mean drift [m/s] */
    int32_t drifts;               /* nonzero: any node has a drift */
    int32_t invalid;              /* nonzero: places were changed from outside; list and bounds are made anew */
    int32_t boxed;                /* nonzero: the boxes of the trees are those of the list, but for stale nodes */
    int32_t full;                 /* nonzero: there is no memory for the pairs, and nothing moves until there is */
    int32_t *class_of;            /* (nodes) one class for nodes that seams join */
    int32_t *triangle;            /* (ntriangle x 3) nodes that stand for the corners */
    mus__self_mesh flat;
    int32_t *order; /* (flat.ntriangle) its triangles, near ones together */
    uint8_t *own;   /* (flat.ntriangle) in that order: corners (bits 0..2) and edges (3..5) it has first */
    mus__box_tree corners, edges, faces;
    int32_t *group;            /* (nodes) one for what hangs together by triangles and seams */
    float *seam_thick;         /* (nodes) at seams half the least height of a triangle; else the thickness [m] */
    float *thick_max;          /* (nodes) bound of its pairs' thickness: that of the drape, less after a yield [m] */
    void *bound;               /* (4 n) place of the last measurement (3 planes), squared bound */
    void *travel2;             /* (n) squared distance from there, in a call [m2] */
    void *list_home;           /* (3 n) place when the list was made */
    void *drift;               /* (3 n) velocities with which bounds and homes move [m/s] */
    void *force;               /* (3 n) impulses since the caller cleared them [N s] */
    void *at;                  /* (8 n) of a search: homes now and at the list's end, node by node */
    uint8_t *stale;            /* (nodes) nonzero: listed anew now; free as a mark between calls */
    int32_t ncrossed;          /* nodes that are part of a crossing */
    uint8_t *crossed;          /* (nodes) nonzero for these: no bound keeps them apart */
    uint8_t *pass;             /* (nodes) nonzero: counts as crossed, until the caller clears it */
    void *before_body;         /* (3 n) velocities before the body answered in this step, written by the stepper */
    uint8_t *active_node;      /* (nodes) nonzero: of an active pair */
    uint8_t *rank, *last_rank; /* (nodes) layers between it and the body, in this call and in the last (shock
                                * propagation); MUS__RANK_NONE: nothing supports it */
    void *support;             /* (3 n) unit vector from what supports it */
    int32_t nnode_pair, npair, nactive;
    int32_t pair_capacity;
    mus__self_pair
        *pair;       /* (pair_capacity) nnode_pair of a node and a triangle from the front, of two edges from the end */
    int32_t *active; /* (pair_capacity) numbers of the active pairs */
    mus__box_grid grid;

    /* counts since create */
    int64_t lists_made, bounds_made, held; /* held: nodes put back into their bounds */
    int64_t responses, measured;           /* pairs asked in calls, and measured for bounds */
    int32_t close;                         /* pairs closer than the thickness in the last call */
    int32_t pairs_max;
} mus__self_contact;

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
