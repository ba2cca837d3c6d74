/*
 * scan_section.h: the welded mesh, its sections by parallel planes, and polygons of sections.
 *
 * A section holds closed polygons (loops) in the plane's coordinates (a, b) along side and front.
 */
#ifndef MUS_SCAN_SCAN_SECTION_H
#define MUS_SCAN_SCAN_SECTION_H

#include "base/base_internal.h"

/* ---- scan_mesh.c ---- */

/* a welded mesh: no two vertices have one place, no triangle is degenerate or repeated, edges are numbered */
typedef struct mus__scan_mesh {
    mus_context *context;
    int32_t vertices, triangles, edges;
    double *x;         /* (vertices x 3) */
    int32_t *triangle; /* (triangles x 3) */
    int32_t *edge;     /* (triangles x 3) edge k joins the corners k and k + 1 of its triangle */
} mus__scan_mesh;

/* check and weld the caller's triangles. Errors: as mus_body_create_scan() */
mus_status mus__scan_weld(mus_context *context, int32_t nv, const double *x, int32_t nt, const int32_t *triangle,
                          mus__scan_mesh *out);
void mus__scan_mesh_free(mus__scan_mesh *mesh);

/* ---- scan_slice.c: sections of a mesh by parallel planes ---- */

/* a closed polygon of a section, counter-clockwise; while a section is made, a chain of segments */
typedef struct mus__loop {
    int32_t first, count;           /* range of its points in the section's xy */
    double area, centre[2], box[4]; /* area, centroid; box: least and greatest a, then b [units of the mesh] */
    int32_t group;                  /* loops that overlap have one number (limbs that are closed meshes of their own) */
    bool open;                      /* a chain that is not closed yet */
} mus__loop;

/* the line in which a plane cuts a triangle, from edge to edge */
typedef struct mus__segment {
    int32_t edge[2]; /* edges of the mesh at its two ends */
    bool walked;     /* it is part of a chain already */
    double xy[4];    /* its two ends */
} mus__segment;

typedef struct mus__section {
    double *xy; /* (points x 2) in (side, front) */
    int32_t points, room;     /* number of points, capacity */
    mus__loop *loop;          /* (loops) the outermost loops, the largest first */
    int32_t loops, loop_room; /* number of loops, capacity */
} mus__section;

/* cuts a mesh by planes square to an axis: point = origin + a side + b front + s axis */
typedef struct mus__slicer {
    mus_context *context;
    const mus__scan_mesh *mesh;
    double origin[3], side[3], front[3], axis[3];
    double low, high;               /* range of s of the mesh */
    double gap;                     /* holes up to this width are closed */
    double *sab;                    /* (vertices x 3) s, a, b */
    double scale;                   /* bins for a unit of s */
    int32_t *start, *list;          /* triangles of bin i: list[start[i]] to list[start[i + 1] - 1] */
    int32_t *slot;                  /* (edges x 2) segments that end on an edge, -1: none */
    mus__segment *segment;          /* (segments) of the last cut */
    int32_t segments, segment_room; /* number of segments, capacity */
    mus__section section;           /* of the last cut */
    int32_t holes;                  /* gaps that were closed since mus__slicer_make() */
    double widest;                  /* width of the widest of them */
} mus__slicer;

/* prepare cuts of a mesh, which is borrowed; holes up to `gap` are closed. Errors: MUS_ERR_MEMORY */
mus_status mus__slicer_make(const mus__scan_mesh *mesh, const double *origin, const double *axis, const double *side,
                            double gap, mus__slicer *out);
void mus__slicer_free(mus__slicer *slicer);
/* cut at s into slicer->section; `what` names the section in messages. Errors: MUS_ERR_MEMORY, MUS_ERR_BODY (a wider
 * hole)
 */
mus_status mus__slice(mus__slicer *slicer, double s, const char *what);

/* ---- scan_outline.c: polygons ---- */

/* area of a polygon (n x 2), positive when it is counter-clockwise, and its centroid (2) */
double mus__polygon_centre(int32_t n, const double *xy, double *centre);
/* copy the loops of a group (-1: of all) to `out`, cut by half planes (planes x 3): a p0 + b p1 >= p2. Errors:
 * MUS_ERR_MEMORY */
mus_status mus__section_take(mus_context *context, const mus__section *from, int32_t group, int32_t planes,
                             const double *plane, mus__section *out);
/* replace all loops of a section by their convex hull. Errors: MUS_ERR_MEMORY */
mus_status mus__section_hull(mus_context *context, mus__section *section);
/* distance of a loop from the slicer's axis, 0 where the axis passes through it */
double mus__loop_distance(const mus__section *section, int32_t loop);
/* the group that is nearest to the axis, within the distance `spread`; -1: none */
int32_t mus__section_near(const mus__section *section, double spread);
void mus__section_free(mus_context *context, mus__section *section);
/*
 * A star-shaped outline (corners x 2) of the union of a section's loops, with corners at equal angles about its
 * centroid `centre` (2); false: there is no area, or the centroid lies outside all loops. A ray ends at its farthest
 * intersection.
 * *fill: depth of the deepest hollow of a single loop that is closed by this, 0: none.
 */
bool mus__star(const mus__section *section, int32_t corners, double *centre, double *out, double *fill);

#endif
