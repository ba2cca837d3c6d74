/*
 * muslin/cloth.h: a pattern cut in a fabric: nodes, springs, seam pairs.
 *
 * Each panel is meshed by a lattice along warp and weft, boundary nodes spaced so that the two sides of a seam have
 * partners at equal relative arc length, and a triangulated strip between. Springs are structural, shear and bend
 * (Metaaphanon and Kanongchaiyos 2005, section 2.1); bending is by second differences, which keep a rigidity on a
 * flat cloth, or on request by the paper's own springs over one node. A cloth knows nothing of time or body.
 *
 * Two more ways lead to a cloth, for experiments and verification: a rectangle that is one pure lattice, and bare nodes
 * with springs, bends and pins of the caller.
 */
#ifndef MUSLIN_CLOTH_H
#define MUSLIN_CLOTH_H

#include "muslin/base.h"
#include "muslin/pattern.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A fabric, measured. */
typedef struct mus_fabric {
    size_t size;
    double weight;      /* kg/m2 */
    double stretch[2];  /* membrane stiffness C11 along warp and weft [N/m] */
    double shear;       /* shear stiffness G [N/m] */
    double bend[3];     /* bending rigidity along warp, weft, bias [N m] */
    double damping;     /* damping ratio of the stretch springs at their own frequency, 0..1 */
    double friction;    /* on skin, Coulomb */
    double thickness;   /* [m] */
    double bend_hysteresis; /* 2HB of KES, width of the loop of moment over curvature [N]; 0: no friction in bending */
    double contraction; /* lateral over longitudinal strain of a strip pulled along its warp (Poisson's ratio); 0, and
                         * any value below shear / stretch[1]: as its springs contract */
} mus_fabric;

/** Zero `fabric`, write size and the values of the default fabric: "jersey" without friction of bending, with which a
 * step takes 1.8 times as long. mus_fabric_find() gives it with. */
MUS_API void mus_fabric_init(mus_fabric *fabric, size_t size);

/** Number of named fabrics. */
MUS_API int32_t mus_fabric_count(void);

/** Name of fabric `index` ("jersey"); NULL outside 0 .. count - 1. Static text. */
MUS_API const char *mus_fabric_name(int32_t index);

/** Where the values of fabric `index` come from, in one paragraph; NULL outside 0 .. count - 1. Static text. */
MUS_API const char *mus_fabric_source(int32_t index);

/** Fill a fabric (its size set by mus_fabric_init) by name. Errors: MUS_ERR_ARG (NULL or unknown name). */
MUS_API mus_status mus_fabric_find(const char *name, mus_fabric *out);

/** Number of values of a fabric: the numbers of mus_fabric one by one, as fabric files hold them. */
MUS_API int32_t mus_fabric_value_count(void);

/** Key of a value with its unit ("weight_kg_per_m2"); NULL outside the range. Static text. */
MUS_API const char *mus_fabric_value_key(int32_t value);

/** Where a value of a named fabric comes from ("assumed": it was chosen, not measured); NULL outside the ranges. Static
 * text. */
MUS_API const char *mus_fabric_value_source(int32_t index, int32_t value);

/** Read one value of a fabric. Errors: MUS_ERR_ARG (no such value); MUS_ERR_VERSION. */
MUS_API mus_status mus_fabric_get(const mus_fabric *fabric, int32_t value, double *out);

/** Set one value of a fabric. Errors: MUS_ERR_ARG (no such value; a number outside the range that the message names);
 * MUS_ERR_VERSION. After a failure the fabric is as before. */
MUS_API mus_status mus_fabric_set(mus_context *context, mus_fabric *fabric, int32_t value, double number);

/** Check that all values of a fabric are in their ranges. Errors: MUS_ERR_ARG naming value and range;
 * MUS_ERR_VERSION. */
MUS_API mus_status mus_fabric_check(mus_context *context, const mus_fabric *fabric);

/* A pattern cut in a fabric. It does not change once it is made; drapes share it. */
typedef struct mus_cloth mus_cloth;

/** Models of bending. */
#define MUS_BEND_PLATE 0 /* second differences, and hinges off the lattice: the fabric's rigidity at any curvature */
#define MUS_BEND_PAPER 1 /* springs over one node (Metaaphanon and Kanongchaiyos 2005): right at one curvature only */

/* Default of nodes_most: 9.4 m2 at a spacing of 3 mm, a lined coat. A drape of so many nodes holds about 0.4 GB, with
 * self_contact 1.7 GB. */
#define MUS_CLOTH_NODES 1048576

/** Options of a cloth. */
typedef struct mus_cloth_def {
    size_t size;
    double spacing;         /* of the lattice [m], default 0.01, 0.001..0.1 */
    const mus_fabric *fabric; /* NULL (default): of a pattern "jersey", of a grid that of mus_fabric_init(); read during
                               * the call and not kept */
    int32_t bending;        /* MUS_BEND_PLATE (default) or MUS_BEND_PAPER */
    double paper_curvature; /* at which the paper's springs resist as the fabric [1/m], default 30, 0.1..1000 */
    int32_t coarser;        /* nonzero (default): keep coarser cuts too, from which sew and settle start; those of a
                             * pattern are of stiffer cloth, with a bending length of at least two cells */
    int32_t nodes_most;     /* a pattern that takes more nodes is refused, default MUS_CLOTH_NODES, 1..2^24 */
} mus_cloth_def;

/** Zero `def`, write the defaults and its size. `size` is sizeof(mus_cloth_def) of the caller. */
MUS_API void mus_cloth_def_init(mus_cloth_def *def, size_t size);

/**
 * Cut a pattern in cloth.
 *
 * The pattern is checked first and read, not kept.
 * Errors:  MUS_ERR_ARG; MUS_ERR_PATTERN (text of the first fault); MUS_ERR_MESH (panel and reason);
 *          MUS_ERR_LIMIT (more than nodes_most nodes: told from areas and lengths, before the memory is taken);
 *          MUS_ERR_MEMORY
 * Cost:    about 10 ms for 10,000 nodes
 */
MUS_API mus_status mus_cloth_create(mus_context *context, const mus_pattern *pattern, const mus_cloth_def *def,
                                    mus_cloth **out);

/**
 * Make a rectangle that is one pure lattice: rows x columns nodes, node r * columns + c at (c * cell[0], r * cell[1]).
 *
 * cell (2) is the spacing along weft (x) and warp (y) [m]; def->spacing is not read, and nodes_most is no bound.
 * Springs and masses on the border carry half, corners a quarter. A direction with one node stands for a strip one cell
 * wide and has no diagonals. There is one panel, without seams, in the plane z = 0. `def` may be NULL.
 * Errors:  MUS_ERR_ARG (rows or columns below 1, cell outside 1e-6 to 10 m, fabric); MUS_ERR_VERSION;
 *          MUS_ERR_LIMIT (more than 2^24 nodes); MUS_ERR_MEMORY
 * Cost:    proportional to the nodes
 */
MUS_API mus_status mus_cloth_create_grid(mus_context *context, int32_t rows, int32_t columns, const double *cell,
                                         const mus_cloth_def *def, mus_cloth **out);

/** A cloth made of bare nodes: no fabric, no panels, no triangles. */
typedef struct mus_bare {
    size_t size;
    int32_t nodes;
    int32_t springs;
    int32_t bends;
    int32_t pins;
    const double *place;          /* (nodes x 3) where a drape starts [m], within 1e7 */
    const double *mass;           /* (nodes) 1e-15 to 1e15 kg; 0 is allowed at a pin */
    const int32_t *spring;        /* (springs x 2) nodes a b: E = k/2 (|x_b - x_a| - length)^2 */
    const double *length;         /* (springs) at rest, 0 or more [m] */
    const double *stiffness;      /* (springs) k, 0 to 1e15 [N/m] */
    const double *dashpot;        /* (springs) 0 to 1e15 [N s/m], along the spring; NULL: none */
    const int32_t *bend;          /* (bends x 3) nodes a b c: E = k/2 |x_a - 2 x_b + x_c|^2 */
    const double *bend_stiffness; /* (bends) k, 0 to 1e15 [N/m] */
    const int32_t *pin;           /* (pins) nodes that a drape holds from the start */
} mus_bare;

/** Zero `bare` and write its size: no nodes. */
MUS_API void mus_bare_init(mus_bare *bare, size_t size);

/**
 * Make a cloth of bare nodes. The arrays are copied; those whose count is 0 may be NULL.
 *
 * A drape of it starts at `place`, with the pins held, and returns there by mus_drape_place(). mus_cloth_rest() is
 * `place` without z; node panels are MUS_NONE.
 * Errors:  MUS_ERR_ARG (a count, node, number: which, with value and limit); MUS_ERR_VERSION;
 *          MUS_ERR_LIMIT (more than 2^24 nodes, 2^28 springs or 2^26 bends); MUS_ERR_MEMORY
 */
MUS_API mus_status mus_cloth_create_bare(mus_context *context, const mus_bare *bare, mus_cloth **out);

/** Free a cloth. A drape made of it lives on. NULL is accepted. */
MUS_API void mus_cloth_destroy(mus_cloth *cloth);

/** Number of nodes; 0 for NULL, as all counts. */
MUS_API int32_t mus_cloth_node_count(const mus_cloth *cloth);

/** Number of triangles. */
MUS_API int32_t mus_cloth_triangle_count(const mus_cloth *cloth);

/** Number of panels: 1 of a grid, 0 of bare nodes. */
MUS_API int32_t mus_cloth_panel_count(const mus_cloth *cloth);

/** Name of the pattern that was cut, "" without one. Borrowed until the cloth is destroyed. */
MUS_API const char *mus_cloth_name(const mus_cloth *cloth);

/** Name of a panel, "" without a pattern; NULL outside 0 .. panels - 1. Borrowed until the cloth is destroyed. */
MUS_API const char *mus_cloth_panel_name(const mus_cloth *cloth, int32_t panel);

/** Number of springs of all kinds, each counted once; a bending stencil and a hinge count as one. */
MUS_API int32_t mus_cloth_spring_count(const mus_cloth *cloth);

/** Number of pairs of nodes that seams bring together. */
MUS_API int32_t mus_cloth_pair_count(const mus_cloth *cloth);

/** Spacing of the lattice [m]: that of the def; of a grid the smaller side of its cell; 0 of bare nodes. */
MUS_API double mus_cloth_spacing(const mus_cloth *cloth);

/** Mass of the whole cloth [kg]: weight times area; of bare nodes the sum of their masses. */
MUS_API double mus_cloth_mass(const mus_cloth *cloth);

/** Positions of the nodes in the planes of their panels, unstrained (nodes x 2) [m]. Borrowed until the cloth is
 * destroyed, as the five arrays below. */
MUS_API const double *mus_cloth_rest(const mus_cloth *cloth);

/** Panel of each node (nodes); MUS_NONE for bare nodes. */
MUS_API const int32_t *mus_cloth_node_panels(const mus_cloth *cloth);

/** Mass of each node (nodes) [kg]. */
MUS_API const double *mus_cloth_masses(const mus_cloth *cloth);

/** Corners of the triangles (triangles x 3). They wind as the panel's outline does: the right side is out. */
MUS_API const int32_t *mus_cloth_triangles(const mus_cloth *cloth);

/** The two nodes of each seam pair (pairs x 2). */
MUS_API const int32_t *mus_cloth_pairs(const mus_cloth *cloth);

/** Seam of the pattern that each pair belongs to (pairs). */
MUS_API const int32_t *mus_cloth_pair_seams(const mus_cloth *cloth);

/** Ranges of a panel in the arrays above: range (4) gets first node, number of nodes, first triangle, number of
 * triangles. Errors: MUS_ERR_ARG (NULL, no such panel). */
MUS_API mus_status mus_cloth_panel_range(const mus_cloth *cloth, int32_t panel, int32_t *range);

/** Boundary nodes of a panel in the order of its outline: *n of them, *nodes borrowed until the cloth is destroyed.
 * Errors: MUS_ERR_ARG (no such panel). */
MUS_API mus_status mus_cloth_panel_border(const mus_cloth *cloth, int32_t panel, int32_t *n, const int32_t **nodes);

#ifdef __cplusplus
}
#endif

#endif
