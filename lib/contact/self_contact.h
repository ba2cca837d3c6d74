/*
 * self_contact.h: cloth against cloth: node against triangle, edge against edge, with thickness and friction.
 *
 * A call after each step. It never asks when two things meet within a step, because none can: every node has a ball
 * round the place where it was last looked at, and is held in it until it is looked at again.
 *
 *   Two things (node and triangle, or edge and edge, without a common node) at distance D: each of their nodes has a
 *   ball of less than D/2. A point of either is a mean of its nodes, so it moves by less than D/2 too, and the two
 *   never touch. Two triangles that do not cross can begin to only where such a pair touches. So where no triangles
 *   cross, none ever will: at any speed, in any step, whatever forces and other contact do to the nodes.
 *
 * All of this may go along: a node's ball drifts with the speed that the node had of late, and of each pair's room the
 * part is left out by which drifts can bring its things together until balls are taken anew. Seen by who drifts with
 * the pair, nothing else has changed. Cloth that falls or walks at any speed is looked at as often as cloth that
 * ripples.
 *
 *   look:   near pairs are taken anew from trees of boxes, when the list is older than it was made for; those of nodes
 *           that have gone farther from their way than the list reaches (`skin`) when there are such
 *   ball:   distances of the pairs in the list, and from them the balls, when a node comes to the end of its ball
 *   touch:  pairs that may be nearer than the thickness answer each call: impulses that end their approach, friction
 *           up to mu times these, and a push apart. Each starts from what it gave in the last call, so that what
 *           presses steadily is carried after some calls, however many pairs share it
 *
 * Cloth may cross at the start. Nodes of triangles that cross are told apart (`tangle`): two things that both have such
 * a node may go through each other as they like, until a count finds that they no longer do. All else is as above.
 *
 * The balls are of the state after the answer, which therefore is as free as the forces are.
 *
 * A pair's thickness is that of the drape; within a panel at most half the distance of the two in the flat, and across
 * a seam half the least height of the triangles there, so that flat cloth never touches itself. Nodes that a seam joins
 * count as one, sewn or not yet. Where cloth presses a node into the body, the caller may have its pairs give way.
 */
#ifndef MUS_CONTACT_SELF_CONTACT_H
#define MUS_CONTACT_SELF_CONTACT_H

#include "contact/crossing_count.h"
#include "contact/box_tree.h"

typedef struct mus__self_pair { /* a node and a triangle, or two edges */
    int32_t node[4];
    float thickness;
    float impulse; /* along the normal in the last call [N s] */
    float idle2;   /* squared: while no node is as far from its ball's middle, its things do not touch [m2] */
} mus__self_pair;

/* the mesh at rest */
typedef struct mus__self_mesh {
    int32_t nodes, ntriangle, npair;
    const int32_t *triangle; /* (ntriangle x 3) */
    const double *rest;      /* (nodes x 2) in the planes of the panels; must live as long as what is made of it */
    const int32_t *panel;    /* (nodes) the same */
    const int32_t *pair;     /* (npair x 2) nodes that seams join */
} mus__self_mesh;

typedef struct mus__self_contact {
    mus_context *context;
    size_t real;       /* bytes of a number of the state */
    int32_t n, nodes;  /* from plane to plane; nodes */
    int32_t ntriangle; /* with corners of three classes */
    double thickness, friction;
    double mean_edge;             /* mean of the triangles' [m] */
    double margin_max;            /* skin with room for all pairs [m] */
    double margin;                /* how far nodes may go until the list is made anew; as the memory allows [m] */
    double list_age, list_span;   /* [s] of the list; how old it may become */
    double bound_age, bound_span; /* [s] since the balls were taken; how long they hold */
    double travel2_max;           /* squared distance of the node that is farthest from the middle of its ball [m2] */
    double mean[3];               /* of the drifts */
    int32_t drifts;               /* nonzero: any node has a drift */
    int32_t invalid;              /* nonzero: places were changed from outside */
    int32_t boxed;     /* nonzero: the trees' boxes are those of the list's homes and drifts, but for worn nodes */
    int32_t full;      /* nonzero: there is no memory for the pairs, and nothing moves until there is */
    int32_t *class_of; /* (nodes) nodes that seams join have one */
    int32_t *triangle; /* (ntriangle x 3) nodes that stand for the corners */
    mus__self_mesh flat;
    int32_t *order; /* (flat.ntriangle) its triangles, near ones together */
    uint8_t *own;   /* (flat.ntriangle) in that order: corners (bits 0..2) and edges (3..5) that it has first */
    mus__box_tree corners, edges, faces;
    int32_t *group;       /* (nodes) one for what hangs together, by triangles and seams */
    float *seam_thick;    /* (nodes) where triangles of seams are: half the least height there; else the thickness */
    float *thick_max;     /* (nodes) no pair of it is thicker: the thickness, where it gave way less */
    void *bound;          /* (4 n) where each node was looked at (3 planes), squared radius */
    void *travel2;        /* (n) squared distance of each from there, in a call [m2] */
    void *list_home;      /* (3 n) where each was when the list was made */
    void *drift;          /* (3 n) velocities with which balls and homes go along [m/s] */
    void *force;          /* (3 n) impulses since the caller cleared them [N s] */
    void *at;             /* (8 n) of a search: where homes are now and at the end, node by node */
    uint8_t *stale;       /* (nodes) listed anew now */
    int32_t ncrossed;     /* nodes that are part of a crossing: 0, or what is said above does not hold for them */
    uint8_t *crossed;     /* (nodes) nonzero for these */
    uint8_t *pass;        /* (nodes) nonzero: counts as part of one, until the caller clears it */
    void *before_body;    /* (3 n) velocities before the body gave its answer in this step, written by the stepper */
    uint8_t *active_node; /* (nodes) nonzero: part of a pair that may touch */
    uint8_t *rank, *last_rank; /* (nodes) layers between it and the body that held it in this call, and in the last;
                                * MUS__RANK_NONE: nothing does */
    void *support;             /* (3 n) unit: from what holds it */
    int32_t nnode_pair, npair, nactive;
    int32_t pair_capacity;
    mus__self_pair *pair; /* (pair_capacity) near pairs: nnode_pair of a node and a triangle, then two edges each */
    int32_t *active;      /* (pair_capacity) numbers of those that may touch */
    mus__box_grid grid;

    /* since create */
    int64_t lists_made, bounds_made, held; /* lists made, balls taken, nodes that were held in their ball */
    int64_t responses, measured;           /* pairs asked in calls, and for balls */
    int32_t close;                         /* pairs closer than the thickness in the last call */
    int32_t pairs_max;
} mus__self_contact;

#define MUS__RANK_NONE 254
#define MUS__RANK_MAX 8 /* layers on each other that know what holds them */

typedef struct mus__self_rule {
    double step;  /* [s] since the last call */
    double slip;  /* [s] h for symplectic Euler, h/2 for RK4, as that of mus__contact_rule */
    double push;  /* [m] what overlaps is put apart by at most this in one call */
    int32_t body; /* nonzero: there is one, and velocities before its answer are known */
} mus__self_rule;

/* class_of (nodes): those that pairs (npair x 2) join have one, the smallest of them */
void mus__self_classes(int32_t nodes, int32_t npair, const int32_t *pair, int32_t *class_of);

/* of a cloth with a state in planes of n numbers of `real` bytes. Everything that calls need */
mus_status mus__self_contact_create(mus_context *context, size_t real, int32_t n, const mus__self_mesh *flat,
                                    double thickness, double friction, mus__self_contact **out);
void mus__self_contact_destroy(mus__self_contact *self);
/* triangles are now those of the nodes that stand for each: rep (nodes), NULL: each for itself; without those of nodes
 * that have any of the bits of `absent` in flags (nodes) */
void mus__self_contact_weld(mus__self_contact *self, const int32_t *rep, const int32_t *flags, int32_t absent);
/* between steps: which nodes are part of a crossing at x (nodes x 3); returns how many pairs of triangles cross. fn as
 * of mus__crossing_count, may be NULL */
int64_t mus__self_contact_mark_crossings(mus__self_contact *self, const double *x, mus__crossing_fn fn, void *user);
/* between steps, the list just made of x: pairs nearer than `least` to that distance, one after the other, but nodes
 * that are held (nodes) stay. How many there were; they may cross others then */
int32_t mus__self_contact_separate(const mus__self_contact *self, double least, const int32_t *held, double *x);
/* between steps: until seams are welded anew no pair of the nodes that are marked (nodes) is thicker than 0.7 of what
 * was allowed before, down to a quarter of the thickness. Nonzero when that made any thinner */
int32_t mus__self_contact_yield(mus__self_contact *self, const uint8_t *marked);
/* between steps: room for twice the pairs that there were, where it became narrow */
mus_status mus__self_contact_grow(mus__self_contact *self);

/* before steps of h: nonzero when balls do not hold so long, and are to be looked at first */
int32_t mus__self_contact_expires(const mus__self_contact *self, double h);

/* before a step, where places were changed from outside: x planes (3 x n) */
void mus__self_contact_prepare_f32(mus__self_contact *self, const float *x);
void mus__self_contact_prepare_f64(mus__self_contact *self, const double *x);
/* after a step: x, v planes (3 x n), inverse (n) 1/mass, 0 for nodes that are held */
void mus__self_contact_pass_f32(mus__self_contact *self, const mus__self_rule *rule, const float *inverse, float *x,
                                float *v);
void mus__self_contact_pass_f64(mus__self_contact *self, const mus__self_rule *rule, const double *inverse, double *x,
                                double *v);

#endif
