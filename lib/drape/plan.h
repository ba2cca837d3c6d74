/*
 * plan.h: what a force evaluation does, worked out once: runs as half springs that each write to one row, and the
 * irregular rest as elements with a list of nodes that gather them.
 *
 * Every force is computed so that a node is written by one place only, in an order fixed here. So any split of rows,
 * elements and nodes over threads gives the same bits (design.md, Determinism).
 *
 *   rows:      f[o + i] = sum over half springs of  k (1 - rest/l) (x[b + i] - x[o + i])
 *                       + sum over bend terms of     w (x[a + i] - 2 x[b + i] + x[c + i])
 *   elements:  g[e] = the spring's pull, the hinge's k sum c x, or the seam pair's pull
 *   gather:    f[node] (+)= sum of coefficient * g[element]
 */
#ifndef MUS_DRAPE_PLAN_H
#define MUS_DRAPE_PLAN_H

#include "cloth/cloth_internal.h"

typedef struct mus__half_run { /* node a+i is pulled towards b+i */
    int32_t a, b, count;
    double k, rest, dashpot;
} mus__half_run;

/* node o+i feels w (x[a+i] - 2 x[b+i] + x[c+i]); or, whole, all three terms of a node between its neighbours in one:
 * -w (x[a+i] - 4 x[b+i] + 6 x[o+i] - 4 x[c+i] + x[d+i]) with a, b before and c, d behind it on the line */
typedef struct mus__half_bend {
    int32_t o, a, b, c, d, count;
    int32_t whole;
    double w;
} mus__half_bend;

typedef struct mus__plan_row {
    int32_t first, count;
    int32_t run, nrun;   /* in half_run */
    int32_t bend, nbend; /* in half_bend */
} mus__plan_row;

typedef struct mus__pair {
    int32_t a, b;    /* nodes */
    int32_t locked;  /* stitched: the two move as one */
    double k;        /* [N/m] near the end */
    double length;   /* of seam that the pair stands for [m] */
} mus__pair;

typedef struct mus__plan {
    int32_t nrow, nhalf_run, nhalf_bend;
    mus__plan_row *row;
    mus__half_run *half_run;
    mus__half_bend *half_bend;

    int32_t nspring, nhinge, npair; /* elements: springs, then hinges, then pairs */
    mus__spring *spring;
    double *spring_dashpot; /* (nspring) */
    mus__hinge *hinge;
    mus__pair *pair;

    int32_t ngather;
    int32_t *gather_node;    /* (ngather) ascending */
    int32_t *gather_lattice; /* (ngather) 1: the row pass wrote this node already */
    int32_t *gather_start;   /* (ngather + 1) */
    int32_t *gather_element; /* (gather_start[ngather]) */
    double *gather_coef;

    int32_t spring_capacity, hinge_capacity, gather_capacity;
    int64_t spring_evaluations; /* a force evaluation makes, each spring counted once */
    int32_t dashpots;           /* nonzero: any dashpot constant is */
    double seam_pull;           /* tension that the pairs pull with now [N per m] */
} mus__plan;

/* make the plan of a cloth with open seams; frees nothing on failure (call mus__plan_clear) */
mus_status mus__plan_build(mus_context *context, const mus_cloth *cloth, mus__plan *plan);
void mus__plan_clear(mus_context *context, mus__plan *plan);
/* open seams again (rep NULL) or weld: rep (nnode) is the node that stands for each; within the memory of build */
void mus__plan_weld(const mus_cloth *cloth, const int32_t *rep, mus__plan *plan);
/* diagonal bound of the stiffness: t (nnode) gets T_i = sum k S |w|, identity in place of n n^T [N/m] */
void mus__plan_stiffness(const mus__plan *plan, int32_t nnode, double *t);
/* the same at the pose x (nnode x 3): t (nnode) gets a bound of the largest eigenvalue of the 3 x 3 T_i, with n n^T for
 * what pulls along the spring and (1 - rest/l) (1 - n n^T) for a stretched one; work (6 nnode) */
void mus__plan_stiffness_at(const mus__plan *plan, int32_t nnode, const double *x, double *t, double *work);
/* diagonal bound of the damping: t (nnode) gets sum 2 c [N s/m]; ratio the largest dashpot over its spring's k [s],
 * infinite without a spring */
void mus__plan_dashpots(const mus__plan *plan, int32_t nnode, double *t, double *ratio);
/* largest step [s] that RK4 is stable with: omega^2 <= rate2, damping per mass <= gamma, drag included */
double mus__plan_step(double rate2, double gamma, double ratio, double drag);

#endif
