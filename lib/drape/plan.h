/*
 * plan.h: what a force evaluation does, worked out once.
 *
 * The cloth's items stand here twice. Plainly, for reports, energies and bounds: runs as half springs, bend terms, and
 * the irregular rest as springs, hinges and seam pairs. And as the kernels want them (blocks.c): every node is written
 * by one place only, in an order fixed here, so that any split over threads gives the same bits.
 *
 *   block:   16 neighbouring lattice nodes, one a lane, whose neighbours stand at the same offsets (a shape).
 *            What a lane does not have is a zero in its table: rows need not be of one length, and no lane is special.
 *
 *               F . F . F      near (N): f += (kk - krest / l - ...) (x[N] - x),  kk = k + w  of spring and bending
 *               . N N N .      far  (F): f += w (x[F] - x)
 *               F N o N F      A stencil k |a - 2 b + c|^2 / 2 is linear, and its weights sum to 0: all of a node's
 *               . N N N .      bending is a sum of w times differences that springs need anyhow, but for the far ones.
 *               F . F . F
 *
 *   gather:  a node with irregular items adds half springs and w (x[other] - x) over listed nodes; what goes from
 *            lattice node to lattice node where its block has a slot anyhow stands in the block's table instead
 *   pair:    a seam's pull, on either end
 *   chunk:   some hundred nodes in a row with their blocks, groups and pair ends: what a thread takes at a time.
 *            Forces live in its scratch until the step has used them
 */
#ifndef MUS_DRAPE_PLAN_H
#define MUS_DRAPE_PLAN_H

#include "cloth/cloth_internal.h"

#define MUS_LANES 16     /* nodes of a block: a vector of floats, two of doubles */
#define MUS_SLOTS 8       /* near and far neighbours of a block, each */
#define MUS_NEAR_MOST 12  /* near ones with the paper's springs over one node */
#define MUS_CHUNK 512     /* nodes of a chunk at most: its forces and a stage stay in the first cache */

typedef struct mus__half_run { /* node a+i is pulled towards b+i */
    int32_t a, b, count;
    double k, rest, dashpot;
} mus__half_run;

/* node o+i feels w (x[a+i] - 2 x[b+i] + x[c+i]) */
typedef struct mus__half_bend {
    int32_t o, a, b, c, count;
    double w;
} mus__half_bend;

typedef struct mus__plan_row {
    int32_t first, count;
    int32_t run, nrun;   /* in half_run */
    int32_t bend, nbend; /* in half_bend */
} mus__plan_row;

typedef struct mus__pair {
    int32_t a, b;    /* nodes */
    int32_t seam;
    int32_t locked;  /* stitched: the two move as one */
    double k;        /* [N/m] near the end */
    double length;   /* of seam that the pair stands for [m] */
    double lift[3];  /* added to the way from end to end, of both: round what is between them [m] */
    double share;    /* of the pull far from the end: less than 1 while others come first */
    double keep;     /* [N/m] of what draws a stitched pair by `lift` */
    int32_t over;    /* how its seam points at the start: -1 closes under the arms, 1 over the shoulders, 2 a strap */
    double aside;    /* [m] to the left of the middle: no farther, when it closes over the shoulders */
} mus__pair;

/* a tack: a spring without length between two nodes of the cloth as it was cut, whatever welds make of them */
typedef struct mus__tack {
    int32_t a, b; /* MUS_NONE: taken out, its number free */
    double k;     /* [N/m] */
} mus__tack;

/* a held node: pulled up to the plane of its level, k of the way, at most by `most` */
typedef struct mus__held {
    int32_t node, level, right;
    double below, k, most; /* [m], [N/m], [N] */
    double share;          /* of `most` that pulls now: 1, less while sewing */
} mus__held;

/* where a level lies now: places x with up . x = at, side to the left; there 0: the body has it not */
typedef struct mus__held_level {
    int32_t there;
    double up[3], side[3], at, point[3];
} mus__held_level;

typedef struct mus__shape { /* index differences, ascending; 0 past the last */
    int32_t near[MUS_NEAR_MOST], far[MUS_SLOTS];
} mus__shape;

typedef struct mus__block {
    int32_t first, shape, table;
} mus__block;

typedef struct mus__chunk {
    int32_t first, count;
    int32_t block, nblock;   /* 0: no lattice node among them */
    int32_t group, ngroup;   /* in list.group */
    int32_t end, nend;       /* in pair_end */
    int32_t held, nheld;     /* in held */
} mus__chunk;

typedef struct mus__list_entry {
    int32_t node, part;     /* the node's part-th handful of items of each kind */
    int32_t nhalf, nlinear;
} mus__list_entry;

typedef struct mus__group { /* items of a lane */
    int32_t half, nhalf, linear, nlinear;
} mus__group;

typedef struct mus__list { /* a node to a lane: what gather nodes have, lane by lane; zeros where one has fewer */
    int32_t ngroup;
    mus__group *group;      /* (ngroup) */
    int32_t *node;          /* (ngroup x lanes) */
    int32_t *half_other;    /* (half x lanes) */
    void *half_constant;    /* (half x 2, with dashpots 3, x lanes) kk, krest (times mus__plan_share), c */
    int32_t *linear_other;  /* (linear x lanes) */
    void *linear_weight;    /* (linear x lanes) */
    mus__list_entry *entry; /* scratch of a chunk's nodes */
} mus__list;

typedef struct mus__pair_end {
    int32_t node, other, pair;
} mus__pair_end;

typedef struct mus__plan {
    int32_t nrow, nhalf_run, nhalf_bend;
    mus__plan_row *row;
    mus__half_run *half_run;
    mus__half_bend *half_bend;
    uint8_t *lattice;       /* (nnode) 1: in a row */

    int32_t nspring, nhinge, npair;
    mus__spring *spring;
    double *spring_dashpot; /* (nspring) those of the cloth, then tacks */
    mus__hinge *hinge;
    mus__pair *pair;

    int32_t ntack, tack_capacity;
    mus__tack *tack;         /* (tack_capacity) the first ntack may be in; NULL before the first */

    int32_t nheld;
    mus__held *held;         /* (nheld) ascending by node */
    mus__held_level level[MUS_HOLD_COUNT][2]; /* left, right; the torso's are the same twice */

    /* for the kernels; constants (void *) are float or double by `real` */
    size_t real;
    int32_t near, far;    /* slots that any block has: 4 or 8, and 0, 4 or 8; (4, 8) is not made */
    int32_t nblock, nshape, ntable, nchunk;
    mus__block *block;    /* (nblock) */
    mus__shape *shape;    /* (nshape) */
    void *table;          /* (ntable x slots x lanes): kk, krest of near (times mus__plan_share), w of far, then with
                           * dashpots c of near */
    mus__chunk *chunk;    /* (nchunk) ascending, every node in one */

    mus__list list;
    mus__pair_end *pair_end; /* (2 npair) ascending by node */

    /* what blocks and list are made of, by node */
    int32_t ngather;
    int32_t *gather_node;  /* (ngather) ascending: the nodes that have any */
    int32_t *half_start;   /* (nnode + 1) */
    int32_t *half_other;   /* (half_start[nnode]) */
    void *half_constant;   /* (half_start[nnode] x 3) kk, krest, c */
    int32_t *linear_start; /* (nnode + 1) */
    int32_t *linear_other; /* (linear_start[nnode]) */
    void *linear_weight;   /* (linear_start[nnode]) */

    int32_t spring_capacity, hinge_capacity;
    int32_t shape_capacity, table_capacity;
    int64_t spring_evaluations; /* a force evaluation makes, each spring counted once */
    int32_t dashpots;           /* nonzero: any dashpot constant is */
    int32_t open_from;          /* panels from this layer on are open where others are welded; 0: all are welded */
    int32_t wait_from;          /* panels from this layer on wait, their seams do not pull; 0: none wait */
    double seam_pull;           /* tension that the pairs pull with now [N per m] */
} mus__plan;

/* make the plan of a cloth with open seams for numbers of `real` bytes; frees nothing on failure (call
 * mus__plan_clear) */
mus_status mus__plan_build(mus_context *context, const mus_cloth *cloth, size_t real, mus__plan *plan);
void mus__plan_clear(mus_context *context, mus__plan *plan);
/* room for `need` tacks; what there is stays. Errors: MUS_ERR_MEMORY, and the plan is as it was */
mus_status mus__plan_tack_room(mus_context *context, const mus_cloth *cloth, int32_t need, mus__plan *plan);
/* the list of tacks has changed; rep as last given to mus__plan_weld. All else stays as it is */
void mus__plan_tacked(const mus_cloth *cloth, const int32_t *rep, mus__plan *plan);
/* open seams again (rep NULL) or weld: rep (nnode) is the node that stands for each, but for what open_from leaves
 * open; within the memory of build */
void mus__plan_weld(const mus_cloth *cloth, const int32_t *rep, mus__plan *plan);

/* ---- parts of the above (blocks.c, gather.c, lists.c) ---- */

/* memory of the gather lists; of what springs take in it, by spring_capacity */
mus_status mus__plan_gather_new(mus_context *context, const mus_cloth *cloth, mus__plan *plan);
mus_status mus__plan_halves_new(mus_context *context, mus__plan *plan);
/* memory of springs, by the cloth's and tack_capacity */
mus_status mus__plan_springs_new(mus_context *context, const mus_cloth *cloth, mus__plan *plan);
/* the lists, of what springs and hinges act from lattice node to lattice node and no weld will change */
void mus__plan_gather_lattice(const mus_cloth *cloth, mus__plan *plan);
/* blocks and chunks of the lattice rows, taking in what they can of these lists */
mus_status mus__plan_blocks(mus_context *context, const mus_cloth *cloth, mus__plan *plan);
/* the lists, of all that is in no block, and the pairs */
void mus__plan_gather(const mus_cloth *cloth, mus__plan *plan);
/* memory of the groups of lanes, the groups of what the lists have now, and the end of them */
mus_status mus__plan_lists_new(mus_context *context, const mus_cloth *cloth, mus__plan *plan);
void mus__plan_lists(mus__plan *plan);
void mus__plan_lists_clear(mus_context *context, mus__plan *plan);
/* slot of a lattice node's block for a neighbour: below MUS_NEAR_MOST near, from there on far; MUS_NONE without */
int32_t mus__plan_slot(const mus__plan *plan, int32_t node, int32_t other);

/* write or read number i of an array of the plan's precision */
static inline void mus__plan_put(const mus__plan *plan, void *array, int64_t i, double value)
{
    if (plan->real == sizeof(float)) ((float *)array)[i] = (float)value;
    else ((double *)array)[i] = value;
}


static inline double mus__plan_number(const mus__plan *plan, const void *array, int64_t i)
{
    return plan->real == sizeof(float) ? (double)((const float *)array)[i] : ((const double *)array)[i];
}


/* what the kernels want krest times: in doubles 3/8, a factor of their root (kernel_f64.c) */
static inline double mus__plan_share(const mus__plan *plan)
{
    return plan->real == sizeof(float) ? 1.0 : 0.375;
}


/* numbers in one table */
static inline int32_t mus__plan_table_size(const mus__plan *plan)
{
    return ((plan->dashpots ? 3 : 2) * plan->near + plan->far) * MUS_LANES;
}

/* ---- bounds (stiffness.c) ---- */

/* diagonal bound of the stiffness: t (nnode) gets T_i = sum k S |w|, identity in place of n n^T [N/m] */
void mus__plan_stiffness(const mus__plan *plan, int32_t nnode, double *t);
/* what bending, hinges, pairs and tacks give of it */
void mus__plan_bending(const mus__plan *plan, int32_t nnode, double *t);
/* the same at the pose x (nnode x 3): t (nnode) gets a bound of the largest eigenvalue of the 3 x 3 T_i, with n n^T for
 * what pulls along the spring and (1 - rest/l) (1 - n n^T) for a stretched one; work (6 nnode) */
void mus__plan_stiffness_at(const mus__plan *plan, int32_t nnode, const double *x, double *t, double *work);
/* diagonal bound of the damping: t (nnode) gets sum 2 c [N s/m]; ratio the largest dashpot over its spring's k [s],
 * infinite without a spring */
void mus__plan_dashpots(const mus__plan *plan, int32_t nnode, double *t, double *ratio);
/* largest step [s] that RK4 is stable with: omega^2 <= rate2, damping per mass <= gamma, drag included */
double mus__plan_step(double rate2, double gamma, double ratio, double drag);
/* the same for velocity Verlet; gamma without drag */
double mus__plan_step_verlet(double rate2, double gamma);

#endif
