/*
 * cloth_internal.h: the data of a cloth: nodes, springs as runs, the irregular rest, seam pairs.
 *
 * Nodes of a panel are contiguous: first the lattice nodes inside, row by row (a row runs along the weft, rows stack
 * along the warp), then the border nodes in the order of the outline. A run is `count` springs whose nodes both
 * advance by one: (a, b), (a+1, b+1), ...: no index list. Only lattice nodes are in runs; only border nodes are in
 * seam pairs, so welding never touches a run.
 */
#ifndef MUS_CLOTH_INTERNAL_H
#define MUS_CLOTH_INTERNAL_H

#include "base/base_internal.h"
#include "muslin/cloth.h"

#define MUS__CLOTH_NAME 128 /* bytes: as long as names of patterns are */

enum {
    MUS__SPRING_WARP = 0,
    MUS__SPRING_WEFT = 1,
    MUS__SPRING_SHEAR = 2,
    MUS__SPRING_BORDER = 3,
    MUS__SPRING_SKIP = 4, /* the paper's bending: over one node */
    MUS__SPRING_ELASTIC = 5,
    MUS__SPRING_TACK = 6 /* of a drape, never of a cloth: between any two nodes */
};

typedef struct mus__spring_run { /* E = 1/2 k (|x_b - x_a| - rest)^2, each spring once */
    int32_t a, b, count, kind;
    double k, rest;
} mus__spring_run;

typedef struct mus__bend_run { /* E = 1/2 k |x_a - 2 x_b + x_c|^2 */
    int32_t a, b, c, count;
    double k;
} mus__bend_run;

typedef struct mus__spring {
    int32_t a, b, kind;
    double k, rest;
} mus__spring;

typedef struct mus__hinge { /* E = 1/2 k |sum coef_i x_i|^2, sum coef = 0: edge node[0]-node[1], wings node[2..3];
                             a bare bend has its middle as both ends of the edge, with -1 each */
    int32_t node[4];
    double coef[4];
    double k;
} mus__hinge;

/* a node that is held up (MUS_HOLD_*), `below` its level; the length of edge that it stands for */
typedef struct mus__hold {
    int32_t node, level, right;
    double below, length;
} mus__hold;

/* a pleat of a panel: its folds are lines square to `along` (a unit), so far along it from the panel's origin; pleats
 * of a panel come in order */
typedef struct mus__pleat {
    int32_t panel;
    double along[2], outer, inner;
} mus__pleat;

typedef struct mus__row { /* one maximal stretch of neighbouring lattice nodes in a lattice row */
    int32_t first, count;
} mus__row;

typedef struct mus__panel_mesh {
    int32_t first_node, node_count; /* lattice then border */
    int32_t lattice_count;
    int32_t first_triangle, triangle_count;
    int32_t first_border, border_count; /* in cloth->border */
    int32_t layer;
    mus_placement placement;
} mus__panel_mesh;

struct mus_cloth {
    mus_context *context;
    int32_t references;        /* a cloth does not change once built: drapes share it */
    mus_fabric fabric;
    double spacing;
    double mass_total;
    int32_t npanel, nnode, ntriangle, nrow, nrun, nbend, nspring, nhinge, nseam_hinge, npair, nborder, nseam;
    int32_t nhold, npleat;
    mus__panel_mesh *panel;    /* (npanel) */
    double *rest;              /* (nnode x 2) in the panel's plane */
    double *mass;              /* (nnode) */
    int32_t *node_panel;       /* (nnode) */
    int32_t *triangle;         /* (ntriangle x 3) */
    int32_t *border;           /* (nborder) nodes of the outlines, panel after panel */
    mus__row *row;             /* (nrow) ascending, covering every lattice node once */
    mus__spring_run *run;      /* (nrun) lattice springs with full stiffness on both sides */
    mus__bend_run *bend;       /* (nbend) */
    mus__spring *spring;       /* (nspring) strip, border, and lattice edges next to the strip */
    mus__hinge *hinge;         /* (nhinge) bending in the strip */
    mus__hinge *seam_hinge;    /* (nseam_hinge) bending across seams, acting once the seam is welded */
    int32_t *pair;             /* (npair x 2) */
    int32_t *pair_seam;        /* (npair) */
    double *pair_length;       /* (npair) arc length that the pair stands for [m] */
    mus__hold *hold;           /* (nhold) */
    mus__pleat *pleat;         /* (npleat) ascending panels */
    double *warp;              /* (npanel x 2) unit, in the flat; NULL without a pattern: along y */
    char *names;               /* (npanel + 1 x MUS__CLOTH_NAME) of the pattern, then of its panels; NULL without one */
    mus_cloth *coarse;         /* the same pattern cut coarser, owned; NULL without */

    /* of bare nodes only, else NULL: no panel places them and no fabric damps them */
    int32_t npin;
    double *place;             /* (nnode x 3) */
    double *dashpot;           /* (nspring) [N s/m] */
    int32_t *pin;              /* (npin) */
};

/* a cloth with one owner and nothing in it, and its own `spacing` and fabric left zero; NULL without memory */
mus_cloth *mus__cloth_new(mus_context *context);
/* defaults, then the caller's options, and those of its fabric in *fabric; all checked but the spacing */
mus_status mus__cloth_def_read(mus_context *context, const mus_cloth_def *def, mus_cloth_def *own, mus_fabric *fabric);

/* one more owner; mus_cloth_destroy() gives one up and frees at the last */
mus_cloth *mus__cloth_retain(const mus_cloth *cloth);

/* layer of a node's panel */
static inline int32_t mus__cloth_layer(const mus_cloth *cloth, int32_t node)
{
    return cloth->npanel > 0 ? cloth->panel[cloth->node_panel[node]].layer : 0;
}

#endif
