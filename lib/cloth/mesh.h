/*
 * mesh.h: a cloth while it is built: the records that pass from panel to panel, and the steps in their order.
 */
#ifndef MUS_CLOTH_MESH_H
#define MUS_CLOTH_MESH_H

#include "cloth/cloth_internal.h"
#include "cloth/fabric.h"
#include "cloth/lattice.h"

/* where an edge of the pattern lies in cloth->border */
typedef struct mus__edge_nodes {
    int32_t count;        /* intervals */
    int32_t panel, start; /* panel; place in the border of the first node met, MUS_NONE while in no outline */
    int32_t direction;    /* +1 when the outline runs along the edge, -1 against it */
    int32_t inner;        /* of a line inside the panel: place of its first node in mesh->inner, else MUS_NONE */
} mus__edge_nodes;

typedef struct mus__mesh {
    mus_context *context;
    const mus_pattern *pattern;
    mus_cloth *cloth; /* its arrays grow; capacities here */
    int32_t cap_rest, cap_mass, cap_node_panel, cap_triangle, cap_border, cap_row, cap_run, cap_bend, cap_spring,
        cap_hinge, cap_hold, cap_seam_hinge, cap_partner, cap_pair, cap_pair_seam, cap_pair_length, cap_wing, cap_inner,
        cap_inner_wing, cap_pleat, cap_cell;
    mus__edge_nodes *edge; /* (pattern's edges) */
    int32_t *wing;         /* (nborder) corner opposite to the border side that starts at this place */
    /* rims and lines of the panels, parts of one block */
    int32_t *first_rim;    /* (panels + 1) where the rim of each begins in the next two */
    int32_t *first_line;   /* (panels + 1) and where its lines do in `line` */
    int32_t *rim, *turn;   /* edges as what is cut passes them, and directions */
    int32_t *line;         /* edges inside that something is sewn to */
    int32_t *point;        /* (points) node of the panel at hand, without its lattice, or MUS_NONE */
    int32_t *inner;        /* (ninner) nodes of lines, count + 1 for each */
    int32_t *inner_wing;   /* (ninner x 2) corners to the left and right of the side that starts there */
    int32_t ninner;
    int32_t *partner;      /* (hinges across seams x 2) what is sewn to their two edge nodes */
    double *seam_bend;     /* (panels x 4) what hinges across seams give each panel, by mus__mesh_curvature */
    mus__fabric_lattice constant;
    int32_t nodes_most;
    double paper; /* curvature that the paper's springs are fitted at [1/m]; 0: plate */
    double lying_share; /* factor on the bending of panels that are placed lying; 1: as of all others */
} mus__mesh;

/* mesh.c: intervals of all edges; then one panel after the other: nodes, triangles, lattice (the caller frees);
 * triangles first_triangle .. + *nstrip are the strip, two for each full cell follow */
mus_status mus__mesh_edges(mus__mesh *mesh);
mus_status mus__mesh_panel(mus__mesh *mesh, int32_t panel, mus__lattice *lattice, int32_t *nstrip);
/* panel_lines.c: the rims and lines of all panels; of one panel, the border known: nodes of its lines, *count of them
 * with those of the border, xy (*count x 2) theirs; how many at most; the sides of its lines as pairs of them (NULL
 * counts); then, with lattice and triangles, nodes of the cloth, and wings */
mus_status mus__mesh_rims(mus__mesh *mesh);
mus_status mus__mesh_lines(mus__mesh *mesh, int32_t panel, int32_t *count, double *xy);
int64_t mus__mesh_line_room(const mus__mesh *mesh, int32_t panel);
int32_t mus__mesh_line_sides(const mus__mesh *mesh, int32_t panel, int32_t *side);
void mus__mesh_lines_done(mus__mesh *mesh, int32_t panel, int32_t nstrip);
/* node at step k, 0 .. count, along an edge in its own direction */
int32_t mus__mesh_edge_node(const mus__mesh *mesh, int32_t edge, int32_t k);

/* lattice_springs.c: springs and stencils of the full cells of the panel last meshed */
mus_status mus__mesh_runs(mus__mesh *mesh, const mus__lattice *lattice, int32_t first_node);
/* border_springs.c: springs, hinges and wings of the rest of it */
mus_status mus__mesh_strip(mus__mesh *mesh, const mus__lattice *lattice, const mus__panel_mesh *panel, int32_t nstrip);
/* border_springs.c: a hinge over edge a b of length l in the flat: foot and height of both wings; false for slivers */
bool mus__mesh_hinge(const mus__mesh *mesh, const int32_t *node, double length, const double *foot,
                     const double *height, double rigidity, mus__hinge *out);
/* calibrate_bending.c: the hinges of each panel, so that it bends as its fabric */
mus_status mus__mesh_calibrate(mus__mesh *mesh);
/* calibrate_bending.c: (sum coef_i z_i)^2 on cylinders of curvature 1 along weft, warp, both bias (4); axis is warp */
void mus__mesh_curvature(const double *axis, int32_t n, const double *coef, const double *xy, double *out);
/* edge_facing.c: the facings of free edges that are attached; after mus__mesh_calibrate(), before mus__mesh_limit() */
mus_status mus__mesh_facings(mus__mesh *mesh);
/* border_springs.c: soften springs and hinges that would ask for a much smaller step than the lattice does */
mus_status mus__mesh_limit(mus__mesh *mesh);
/* cloth.c: the defaults, then the caller's options, with its fabric in *fabric; all are checked but the spacing.
 * `otherwise`: the fabric of who gives none; NULL: that of mus_fabric_init() */
mus_status mus__cloth_def_read(mus_context *context, const mus_cloth_def *def, const mus_fabric *otherwise,
                               mus_cloth_def *own, mus_fabric *fabric);
/* coarse_cut.c: whether a cloth of these options has a coarser cut, and the spacing of that [m] */
bool mus__cloth_coarser(const mus_cloth *cloth, const mus_cloth_def *def, double *spacing);
/* coarse_cut.c: stiffens a fabric until its bending length is two cells of a coarser cut of that spacing [m]. Returns
 * its bending rigidity before over that after */
double mus__cloth_stiffen(double spacing, mus_fabric *fabric);
/* coarse_cut.c: the same for a grid: nodes of both directions and cell (2) [m] of the coarser one */
bool mus__grid_coarser(const mus_cloth *cloth, const mus_cloth_def *def, int32_t *rows, int32_t *columns,
                       const double *cell, double *coarse_cell);
/* seam_pairs.c: seam pairs and hinges across seams of all panels */
mus_status mus__mesh_seams(mus__mesh *mesh);
/* seam_turns.c: bending across seams while they are open; after mus__mesh_limit() */
mus_status mus__mesh_turns(mus__mesh *mesh);
/* pleat_folds.c: the folds of pleats that are laid */
mus_status mus__mesh_pleats(mus__mesh *mesh);
/* edge_elements.c: gathered sides, elastics and attachments. It comes after mus__mesh_limit(), which must not soften
 * elastics */
mus_status mus__mesh_held(mus__mesh *mesh);

#endif
