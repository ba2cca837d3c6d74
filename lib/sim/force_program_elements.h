/*
 * force_program_elements.h: the elements of a force program in plain form: half springs, half bends, seam pairs, tacks,
 * attachments.
 *
 * Reports, energies, residuals and step bounds read them (force_reference.c, step_bound.c). The kernels read the packed
 * form that is made of them (force_program_kernel_data.h).
 */
#ifndef MUS_SIM_FORCE_PROGRAM_ELEMENTS_H
#define MUS_SIM_FORCE_PROGRAM_ELEMENTS_H

#include "cloth/cloth_internal.h"

/* one end of a run of lattice springs: node a+i is pulled towards node b+i, for i = 0 .. count-1 */
typedef struct mus__half_run {
    int32_t a, b, count;
    double k, rest, dashpot; /* [N/m], [m], [N s/m] */
} mus__half_run;

/* the bending force on one node of each stencil of a run: node o+i feels w (x[a+i] - 2 x[b+i] + x[c+i]) */
typedef struct mus__half_bend {
    int32_t o, a, b, c, count;
    double w; /* [N/m] */
} mus__half_bend;

/* a lattice row with the half runs and half bends that act on its nodes */
typedef struct mus__program_row {
    int32_t first, count; /* nodes */
    int32_t run, nrun;    /* in mus__program.half_run */
    int32_t bend, nbend;  /* in mus__program.half_bend */
} mus__program_row;

/*
 * The slider of a bending stencil or hinge with e = sum coef_i x_i: it resists with k (e - slip), and slips where |e -
 * slip| would exceed `most`. The element's own stiffness has k in it, so the slider adds the force  k coef_i slip.
 */
typedef struct mus__slider {
    int32_t node[4];
    double coef[4], k, most; /* [N/m]; of e [m], or for a hinge [m2] as its coefficients have it */
    double slip[3];
    int32_t clamped; /* nonzero: k is doubled, as the element is at a clamp (bend_clamp.h) */
} mus__slider;

/* how a seam closes, known from where its edges point at the start (seam_route.c) */
enum { MUS__WAY_UNDER_ARM = -1, MUS__WAY_ANY = 0, MUS__WAY_OVER_SHOULDER = 1, MUS__WAY_STRAP = 2 };

/* two nodes that a seam draws together */
typedef struct mus__seam_pair {
    int32_t a, b; /* nodes */
    int32_t seam;
    int32_t stitched;  /* nonzero: the two nodes were within the collision distance, and move as one since */
    double k;          /* stiffness near the end [N/m] */
    double length;     /* arc length of seam that the pair stands for [m] */
    double detour[3];  /* added to the vector from either node to the other, so that the pull goes round a limb [m] */
    double pull_share; /* factor on the tension limit, 1, or less while other pairs come first */
    double strap_k;    /* stiffness of the pull of a stitched pair along `detour`, 0 without [N/m] */
    int32_t way;       /* MUS__WAY_* */
    double lateral;    /* of a strap: largest distance to the left of the body's middle plane [m] */
} mus__seam_pair;

/* a spring of no length between two nodes of the cloth as it was cut; welding does not change the numbers */
typedef struct mus__tack {
    int32_t a, b; /* MUS_NONE: taken out, the number is free */
    double k;     /* [N/m] */
} mus__tack;

/* an attachment: a node that is pulled up to `below` under its level plane by a spring of k, at most by a force `most`
 */
typedef struct mus__attachment {
    int32_t node, level, right;
    double below, k, most; /* [m], [N/m], [N] */
    double share;          /* factor on `most`: 1, less while sewing */
} mus__attachment;

/* a level plane of the body as it stands now: places x with up . x = at; side points to the left */
typedef struct mus__level_plane {
    int32_t there; /* 0: the body has no such level */
    double up[3], side[3], at, point[3];
} mus__level_plane;

#endif
