/*
 * manifold_internal.h: the steps from the lattice of manifold_lattice.h to the closed surface of a body.
 */
#ifndef MUS_MANIFOLD_MANIFOLD_INTERNAL_H
#define MUS_MANIFOLD_MANIFOLD_INTERNAL_H

#include "manifold/manifold_lattice.h"
#include "muslin/manifold.h"

/* the edge of a point in direction d, as the index of its crossing */
int32_t mus__bcc_crossing(const mus__bcc *lattice, int32_t point, int32_t d);

/* ---- manifold_cell.c ---- */

/* the grid, and the cells near the surface with their solids. Errors: MUS_ERR_MEMORY, MUS_ERR_ARG */
mus_status mus__bcc_make(mus_context *context, mus__pool *pool, const mus__solids *solids, double spacing,
                         mus__bcc *out);
void mus__bcc_free(mus__bcc *lattice);
/* give points of its own to the place of a shared cell in the table, and its solids where `listed`. Errors:
 * MUS_ERR_MEMORY, MUS_ERR_ARG */
mus_status mus__bcc_open(mus__bcc *lattice, int32_t place, bool listed);
/* the point at doubled coordinates (3) from the corner of a cell, -4 at least */
mus__step mus__bcc_at(const mus__bcc *lattice, const int32_t *at);
/* vertices, edges and triangles between the neighbours of a mask; returns the vertices */
int32_t mus__bcc_link(const mus__bcc *lattice, uint32_t mask, int32_t *edges, int32_t *triangles);

/* ---- manifold_lattice.c ---- */

/* room for depth, label and `differ` of the points of all cells. Errors: MUS_ERR_MEMORY */
mus_status mus__bcc_room(mus__bcc *lattice);
/* depth and label of the points that have none yet. Errors: MUS_ERR_MEMORY */
mus_status mus__bcc_sample(mus__bcc *lattice);
/* `differ` of the points from a cell on */
void mus__bcc_compare(mus__bcc *lattice, int32_t from);
/* points of their own for cells beside the surface, which passes the cells `from` on. Errors: MUS_ERR_MEMORY,
 * MUS_ERR_ARG */
mus_status mus__bcc_beside(mus__bcc *lattice, int32_t from);
/* turn the label of a point over, and `differ` with it */
void mus__bcc_flip(mus__bcc *lattice, int32_t point);
/* Euler characteristic of the surface of the points inside, from `differ` */
int32_t mus__bcc_euler(const mus__bcc *lattice);
/* the edges whose ends have different labels, and about where they cross the surface. Errors: MUS_ERR_MEMORY */
mus_status mus__bcc_cross(mus__bcc *lattice);
/* find the crossing of the edge of a point in direction d */
void mus__bcc_search(mus__bcc *lattice, int32_t point, int32_t d);
/* the crossings that are vertices: found, and those nearly at a point of the lattice moved a little away from it */
void mus__bcc_polish(mus__bcc *lattice);

/* ---- manifold_grow.c, manifold_snap.c ---- */

/* label as inside what the solid encloses; then, where its surface is not one sphere or `always`, the largest part of
 * each piece that is a topological ball. Errors: MUS_ERR_MEMORY, MUS_ERR_ARG */
mus_status mus__bcc_grow(mus__bcc *lattice, bool always);
/* move points that are near the surface onto it, where the surface stays a manifold. Errors: MUS_ERR_MEMORY,
 * MUS_ERR_ARG */
mus_status mus__bcc_snap(mus__bcc *lattice);

/* ---- manifold_mesh.c ---- */

struct mus_manifold {
    mus_context *context;
    int32_t vertices, triangles, pieces, cuts;
    double *vertex, *normal; /* (vertices x 3) */
    int32_t *triangle;       /* (triangles x 3) */
    double volume;           /* [m3] */
};

/* vertices, triangles and normals of the lattice's surface; the number of pieces and the sum of their Euler
 * characteristics. Errors: MUS_ERR_MEMORY, MUS_ERR_ARG */
mus_status mus__bcc_mesh(mus__bcc *lattice, mus_manifold *out, int32_t *euler);

#endif
