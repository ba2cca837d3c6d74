/*
 * ply_write.c: write meshes as one binary PLY, and the motion of one mesh as a point cache (PC2).
 *
 * The PLY has the vertices of all meshes with the number of their part (a panel, or a whole mesh), the triangles with
 * theirs, and the seams as edges. Comments in its head name the parts. Normals are written when every mesh has them,
 * texture coordinates (s, t) when one has. Source: Turk, The PLY Polygon File Format, 1994.
 * The PC2 has a head of 32 bytes and the positions of each key as floats.
 */
#include "meshfile/mesh_file.h"


/* what the columns of the file are */
struct ply_shape {
    int64_t vertices, triangles, lines;
    bool normals, textured;
};


static struct ply_shape ply_measure(const mus__mesh_set *set)
{
    struct ply_shape shape = {.normals = true};
    for (int32_t i = 0; i < set->n; i++) {
        const mus__mesh_parts *mesh = &set->mesh[i];
        shape.vertices += mesh->view->vertex_count;
        shape.triangles += mesh->view->triangle_count;
        shape.lines += mesh->nline;
        shape.normals = shape.normals && mesh->view->normals != NULL;
        shape.textured = shape.textured || mus__mesh_uv(mesh) != NULL;
    }
    return shape;
}


static void put_head(mus__sink *sink, const mus__mesh_set *set, const struct ply_shape *shape)
{
    mus__sink_print(sink, "ply\nformat binary_little_endian 1.0\ncomment muslin: metres, Y up\n");
    for (int32_t i = 0, number = 0; i < set->n; i++)
        for (int32_t p = 0; p < set->mesh[i].count; p++, number++) {
            const char *name = set->mesh[i].part[p].name;
            mus__sink_print(sink, "comment part %d ", (int)number);
            for (; name != NULL && *name != '\0'; name++)
                mus__sink_add(sink, (unsigned char)*name < 0x20 ? "_" : name, 1);
            mus__sink_print(sink, "\n");
        }
    mus__sink_print(sink, "element vertex %lld\nproperty float x\nproperty float y\nproperty float z\n",
                    (long long)shape->vertices);
    if (shape->normals) mus__sink_print(sink, "property float nx\nproperty float ny\nproperty float nz\n");
    if (shape->textured) mus__sink_print(sink, "property float s\nproperty float t\n");
    mus__sink_print(sink, "property int part\nelement face %lld\nproperty list uchar int vertex_indices\n"
                    "property int part\n", (long long)shape->triangles);
    if (shape->lines > 0)
        mus__sink_print(sink, "element edge %lld\nproperty int vertex1\nproperty int vertex2\n",
                        (long long)shape->lines);
    mus__sink_print(sink, "end_header\n");
}


/* the vertices of a mesh; nodes of a cloth that no part has are of its first part */
static void put_vertices(mus__sink *sink, const mus__mesh_parts *mesh, const struct ply_shape *shape, int32_t number)
{
    const mus_mesh_view *view = mesh->view;
    const double *uv = mus__mesh_uv(mesh);
    for (int32_t v = 0, p = 0; v < view->vertex_count; v++) {
        const size_t i = (size_t)v;
        while (p + 1 < mesh->count && v >= mesh->part[p + 1].first_vertex) p++;
        for (size_t k = 0; k < 3; k++) mus__sink_f32(sink, view->positions[3 * i + k]);
        for (size_t k = 0; shape->normals && k < 3; k++) mus__sink_f32(sink, view->normals[3 * i + k]);
        for (size_t k = 0; shape->textured && k < 2; k++) mus__sink_f32(sink, uv != NULL ? uv[2 * i + k] : 0.0);
        mus__sink_u32(sink, (uint32_t)(number + p));
    }
}


void mus__ply_put(mus__sink *sink, const mus__mesh_set *set)
{
    const struct ply_shape shape = ply_measure(set);
    put_head(sink, set, &shape);
    for (int32_t i = 0, number = 0; i < set->n; number += set->mesh[i++].count)
        put_vertices(sink, &set->mesh[i], &shape, number);
    int64_t first = 0;
    for (int32_t i = 0, number = 0; i < set->n; first += set->mesh[i++].view->vertex_count)
        for (int32_t p = 0; p < set->mesh[i].count; p++, number++) {
            const mus__mesh_part *part = &set->mesh[i].part[p];
            const size_t end = 3 * ((size_t)part->first_triangle + (size_t)part->triangles);
            for (size_t t = 3 * (size_t)part->first_triangle; t < end; t += 3) {
                mus__sink_add(sink, "\3", 1);
                for (size_t k = 0; k < 3; k++)
                    mus__sink_u32(sink, (uint32_t)(first + set->mesh[i].view->triangles[t + k]));
                mus__sink_u32(sink, (uint32_t)number);
            }
        }
    first = 0;
    for (int32_t i = 0; i < set->n; first += set->mesh[i++].view->vertex_count)
        for (size_t k = 0; k < 2 * (size_t)set->mesh[i].nline; k++)
            mus__sink_u32(sink, (uint32_t)(first + set->mesh[i].lines[k]));
}


void mus__pc2_put(mus__sink *sink, const mus__mesh_set *set)
{
    const mus__mesh_parts *mesh = &set->mesh[0];
    const size_t numbers = 3 * (size_t)mesh->view->vertex_count * (size_t)set->keys;
    mus__sink_add(sink, "POINTCACHE2\0", 12);
    mus__sink_u32(sink, 1); /* version */
    mus__sink_u32(sink, (uint32_t)mesh->view->vertex_count);
    mus__sink_f32(sink, 1.0); /* first frame */
    mus__sink_f32(sink, 1.0); /* frames a key */
    mus__sink_u32(sink, (uint32_t)set->keys);
    for (size_t i = 0; i < numbers; i++) mus__sink_f32(sink, mesh->motion->positions[i]);
}
