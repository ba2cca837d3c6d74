/*
 * mesh_file.h: files of triangle meshes: meshes to write, each with its parts, the panels of a cloth.
 *
 * mesh_file.c holds the public calls: it has mesh_check.c check what the caller gave and mesh_parts.c divide each mesh
 * into the panels of its cloth, pack their texture coordinates in a square and list the seams as lines, then calls one
 * writer: obj_write.c, glb_write.c, usda_write.c or ply_write.c. A mesh without a cloth is one part. obj_read.c reads.
 */
#ifndef MUS_MESHFILE_MESH_FILE_H
#define MUS_MESHFILE_MESH_FILE_H

#include <stdbool.h>

#include "file/sink.h"
#include "muslin/exchange.h"

/* a range of the vertices and triangles of a mesh: a panel, or the whole mesh */
typedef struct mus__mesh_part {
    const char *name; /* NULL: it has none */
    int32_t first_vertex, vertices;
    int32_t first_triangle, triangles;
} mus__mesh_part;

typedef struct mus__mesh_parts {
    const mus_mesh_view *view;
    const mus_mesh_motion *motion; /* NULL: the mesh stands still */
    const mus_cloth *cloth;        /* NULL: the mesh is one part */
    const char *material;          /* NULL: it has no name */
    int32_t count;
    mus__mesh_part *part; /* (count) */
    double *islands;      /* (vertices x 2) coordinates in the unit square, no two panels over each other; NULL: none */
    int32_t nline;
    int32_t *lines;       /* (nline x 2) vertices of the lines along seams */
} mus__mesh_parts;

typedef struct mus__mesh_set {
    mus_context *context;
    int32_t n;
    mus__mesh_parts *mesh; /* (n) */
    int32_t keys;
    const double *times;   /* (keys) [s] */
} mus__mesh_set;

/* divide the meshes of a checked file into parts; the caller frees `set`, after a failure too */
mus_status mus__mesh_set_make(mus_context *context, const mus_mesh_file *file, mus__mesh_set *set);
void mus__mesh_set_free(mus__mesh_set *set);
/* the texture coordinates that come first: packed ones, else those of the view; NULL without any */
const double *mus__mesh_uv(const mus__mesh_parts *mesh);
/* write the name of a part's material, "jersey.front", without quotes; `hold` gets at most `bytes` */
void mus__mesh_material(const mus__mesh_parts *mesh, int32_t part, char *hold, size_t bytes);

/* ---- writers; each fills the sink, whose status says whether it could ---- */

/* library is the name of the .mtl file beside the OBJ, NULL: none */
void mus__obj_put(mus__sink *sink, const mus__mesh_set *set, const char *library);
/* the materials of an OBJ */
void mus__mtl_put(mus__sink *sink, const mus__mesh_set *set);
mus_status mus__glb_put(mus__sink *sink, const mus__mesh_set *set);
void mus__ply_put(mus__sink *sink, const mus__mesh_set *set);
void mus__usda_put(mus__sink *sink, const mus__mesh_set *set);
/* a point cache of the one mesh of the set */
void mus__pc2_put(mus__sink *sink, const mus__mesh_set *set);

#endif
