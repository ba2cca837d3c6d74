/*
 * muslin/manifold.h: the body as one closed surface, for printing in 3D, Boolean operations and games.
 *
 * The skin of a body (mus_body_vertices()) is a shell for each limb, finger and toe, and the shells overlap. A manifold
 * is the surface of their union: each edge joins two triangles, the triangles wind outwards and none crosses another,
 * and each connected piece is a topological sphere (Euler characteristic 2). A body of a tape with all its limbs is one
 * piece.
 *
 * Units:   metre. Frame: that of the body, where it stands
 * Source:  Labelle and Shewchuk, Isosurface Stuffing, 2007 (the lattice and its snapping)
 */
#ifndef MUSLIN_MANIFOLD_H
#define MUSLIN_MANIFOLD_H

#include "muslin/base.h"
#include "muslin/body.h"

#ifdef __cplusplus
extern "C" {
#endif

/** One closed surface of a body. It does not change once it is made, and it does not need the body any more. */
typedef struct mus_manifold mus_manifold;

/** Options of a manifold. */
typedef struct mus_manifold_def {
    size_t size;
    double spacing;  /* distance of the lattice's points [m], 0.001 to 0.03, default 0.004: about the longest edge of a
                        triangle. Details below it are lost; memory and time grow with its inverse cube */
    int32_t threads; /* 1 to 64, default 1; the result has the same bytes for any number */
} mus_manifold_def;

/** Write the defaults of a manifold's options; `size` is sizeof(mus_manifold_def). */
MUS_API void mus_manifold_def_init(mus_manifold_def *def, size_t size);

/**
 * Make the manifold of a body where it stands, posed or not.
 *
 * Every vertex lies on the surface of the union of the limbs within a thousandth of the spacing, except where the union
 * has a handle or a bridge (a hand that touches the hip): there the surface is cut open by a gap about one spacing
 * wide, and mus_manifold_cut_count() tells how many vertices lie on such a cut. Fingers nearer to each other than 1.2
 * spacings are joined by a web. Pieces of fewer than 32 lattice points are left out. `def` may be NULL: the defaults.
 *
 * Errors:  MUS_ERR_ARG, MUS_ERR_VERSION, MUS_ERR_MEMORY; MUS_ERR_BODY (no limb is as large as the lattice's spacing).
 *          *out is then NULL
 * Memory:  16 MB for an adult at the default spacing (220,000 vertices), 70 MB while it is made
 * Cost:    about 0.5 s of CPU for an adult at the default spacing
 */
MUS_API mus_status mus_manifold_create(const mus_body *body, const mus_manifold_def *def, mus_manifold **out);

/** Free a manifold; NULL is accepted. Before its body's context. */
MUS_API void mus_manifold_destroy(mus_manifold *manifold);

/** Number of vertices. */
MUS_API int32_t mus_manifold_vertex_count(const mus_manifold *manifold);

/** Number of triangles. */
MUS_API int32_t mus_manifold_triangle_count(const mus_manifold *manifold);

/** Number of connected pieces: 1 for a body of a tape with all its limbs. */
MUS_API int32_t mus_manifold_piece_count(const mus_manifold *manifold);

/** Number of vertices that lie on a cut through the body, where a handle was opened. */
MUS_API int32_t mus_manifold_cut_count(const mus_manifold *manifold);

/** Volume within the triangles [m3]. */
MUS_API double mus_manifold_volume(const mus_manifold *manifold);

/** Vertices (vertex_count x 3) [m], borrowed until the manifold is destroyed. */
MUS_API const double *mus_manifold_vertices(const mus_manifold *manifold);

/** Outward unit normals at the vertices (vertex_count x 3), the means of the triangles about each by area; borrowed
 * until the manifold is destroyed. */
MUS_API const double *mus_manifold_normals(const mus_manifold *manifold);

/** Triangles (triangle_count x 3) as vertex indices, winding outwards; borrowed until the manifold is destroyed. */
MUS_API const int32_t *mus_manifold_triangles(const mus_manifold *manifold);

#ifdef __cplusplus
}
#endif

#endif
