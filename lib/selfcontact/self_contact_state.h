/*
 * self_contact_state.h: the arrays of self-contact (self_contact.h), their shapes and units.
 */
#ifndef MUS_SELFCONTACT_SELF_CONTACT_STATE_H
#define MUS_SELFCONTACT_SELF_CONTACT_STATE_H

#include "selfcontact/box_tree.h"
#include "selfcontact/crossing_count.h"

typedef struct mus__self_pair { /* a node and a triangle, or two edges */
    int32_t node[4];
    float thickness;     /* [m] */
    float impulse;       /* along the normal in the last call [N s]; of an active pair, when it became active */
    float tangential[3]; /* that of friction likewise, on its first thing [N s] */
} mus__self_pair;

typedef struct mus__self_active { /* a pair that answers calls, from bounds to bounds: what they ask for stands together
                                   */
    int32_t node[4];
    int32_t pair;        /* its number */
    float thickness;     /* [m] */
    float impulse;       /* along the normal in the last call [N s] */
    float tangential[3]; /* that of friction, on its first thing [N s] */
} mus__self_active;

/* the mesh at rest */
typedef struct mus__self_mesh {
    int32_t nodes, ntriangle, npair;
    const int32_t *triangle; /* (ntriangle x 3) */
    const double *rest;      /* (nodes x 2) in the planes of the panels; borrowed for the life of the self-contact */
    const int32_t *panel;    /* (nodes) borrowed likewise */
    const int32_t *pair;     /* (npair x 2) nodes that seams join */
} mus__self_mesh;

#define MUS__RANK_NONE 254 /* rank of a node that nothing supports */
#define MUS__RANK_MAX 8    /* highest rank: layers above the eighth have the same; chosen */

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
    void *travel2;             /* (n) squared distance from there, where the bound has drifted to [m2] */
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
    int32_t nnode_active; /* active pairs of a node and a triangle, which stand first */
    int32_t pair_capacity;
    mus__self_pair
        *pair;       /* (pair_capacity) nnode_pair of a node and a triangle from the front, of two edges from the end */
    mus__self_active *active; /* (pair_capacity) the active pairs, in the order of the list */
    uint32_t *pressed;        /* (pair_capacity bits) of the active pairs: gave an impulse in the last call */
    int32_t *idle_node;       /* (4 pair_capacity) their nodes, of 32 pairs the first ones, the second ones, ... */
    float *idle2; /* (pair_capacity) their things do not touch while no node has moved this far, squared [m2] */
    mus__box_grid grid;

    /* counts since create */
    int64_t lists_made, bounds_made, held; /* held: nodes put back into their bounds */
    int64_t responses, measured;           /* pairs asked in calls, and measured for bounds */
    int32_t close;                         /* pairs closer than the thickness in the last call */
    int32_t pairs_max;
} mus__self_contact;

#endif
