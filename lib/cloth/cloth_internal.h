/*
 * cloth_internal.h: the data of a cloth: nodes, springs as runs, the irregular rest, seam pairs.
 *
 * Nodes of a panel are contiguous: first the lattice nodes inside, row by row (a row runs along the weft, rows stack
 * along the warp), then the border nodes in the order of the outline. A run is `count` springs, stencils or cells whose
 * nodes all advance by one: no index list. Only lattice nodes are in runs, only border nodes in seam pairs.
 */
#ifndef MUS_CLOTH_INTERNAL_H
#define MUS_CLOTH_INTERNAL_H

#include "base/base_internal.h"
#include "muslin/cloth.h"

#define MUS__CLOTH_NAME 128              /* bytes: as long as names of patterns are */
#define MUS__CLOTH_NODES_LIMIT (1 << 24) /* nodes of any cloth: the force program counts elements in 32 bits */

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

typedef struct mus__cell_run { int32_t a, b, count; } mus__cell_run; /* cells a, a+1, b+1, b; a to a+1 is weft */

typedef struct mus__spring {
    int32_t a, b, kind;
    double k, rest;
} mus__spring;

typedef struct mus__hinge { /* E = 1/2 k |sum coef_i x_i|^2, sum coef = 0: edge node[0..1], wings node[2..3]; a bend of
                             bare nodes or a facing has its middle node at both ends of the edge, coefficient -1 each */
    int32_t node[4];
    double coef[4];
    double k, area; /* area [m2]: half the edge times both triangles' heights; of a bend, its side's square or 0 */
} mus__hinge;

typedef struct mus__hold { /* attachment of a node to a level (MUS_HOLD_*) of the body */
    int32_t node, level, right; /* right: nonzero on the right limb of a pair */
    double below, length;       /* [m] distance below the level; length of edge that the node stands for */
} mus__hold;

typedef struct mus__pleat { /* its two folds are lines at right angles to `along` (a unit vector) */
    int32_t panel;
    double along[2], outer, inner; /* [m] distances of the folds along it from the panel's origin */
} mus__pleat;

typedef struct mus__row { int32_t first, count; } mus__row; /* nodes of a lattice row, without a gap */

typedef struct mus__panel_mesh {
    int32_t first_node, node_count; /* lattice then border */
    int32_t lattice_count;
    int32_t first_triangle, triangle_count;
    int32_t first_border, border_count; /* in cloth->border */
    int32_t layer, lies, sides; /* lies: 1 when sewn to a panel of a layer below; sides: MUS_SIDE_* */
    mus_placement placement;
} mus__panel_mesh;

struct mus_cloth {
    mus_context *context;
    int32_t references;        /* owners: a cloth does not change once built, so drapes share it */
    mus_fabric fabric;
    double spacing;
    double mass_total, bend_slide; /* [kg]; part of bending that goes through sliders (mus__fabric_slide) */
    int32_t npanel, nnode, ntriangle, nrow, nrun, nbend, nspring, nhinge, nseam_hinge, npair, nborder, nseam;
    int32_t nhold, npleat, ncell;
    double couple, couple_share, cell_side[2]; /* C [N/m] of a cell; over the root of its line springs' product; [m] */
    mus__panel_mesh *panel;    /* (npanel) */
    double *rest;              /* (nnode x 2) in the panel's plane */
    double *mass;              /* (nnode) */
    int32_t *node_panel;       /* (nnode) */
    int32_t *triangle;         /* (ntriangle x 3) */
    int32_t *border;           /* (nborder) nodes of the outlines, panel after panel */
    mus__row *row;             /* (nrow) ascending; each lattice node is in one of them */
    mus__spring_run *run;      /* (nrun) springs between two full cells, or diagonals of one */
    mus__bend_run *bend;       /* (nbend) */
    mus__cell_run *cell;       /* (ncell) all full cells; none without a coupling */
    mus__spring *spring;       /* (nspring) of the strip, the border, and lattice edges beside the strip */
    mus__hinge *hinge;         /* (nhinge) bending in the strip */
    mus__hinge *seam_hinge;    /* (nseam_hinge) bending across seams once both sides are welded */
    mus__hinge *seam_turn;     /* (nseam_hinge x 3) and while it is open; nodes 0, 1 of the first are sewn together */
    int32_t *pair, *pair_seam; /* (npair x 2), (npair) */
    double *pair_length;       /* (npair) arc length that the pair stands for [m] */
    mus__hold *hold;           /* (nhold) */
    mus__pleat *pleat;         /* (npleat) ascending panels */
    double *warp;              /* (npanel x 2) unit, in the flat; NULL without a pattern: along y */
    char *names;               /* (npanel + 1 x MUS__CLOTH_NAME) of the pattern, then of its panels; NULL without one */
    mus_cloth *coarse;         /* the same pattern cut coarser, owned; NULL without */

    int32_t npin; /* from here on, of bare nodes only, else NULL: they have neither panels nor a fabric */
    double *place;             /* (nnode x 3) */
    double *dashpot;           /* (nspring) [N s/m] */
    int32_t *pin;              /* (npin) */
};

/* an empty cloth with one owner; NULL without memory */
mus_cloth *mus__cloth_new(mus_context *context);
/* add an owner. mus_cloth_destroy() removes one, and frees the cloth with the last */
mus_cloth *mus__cloth_retain(const mus_cloth *cloth);

/* layer of a node's panel */
static inline int32_t mus__cloth_layer(const mus_cloth *cloth, int32_t node)
{
    return cloth->npanel > 0 ? cloth->panel[cloth->node_panel[node]].layer : 0;
}

#endif
