/*
 * obj_write.c: write meshes as one Wavefront OBJ: an `o` for each; positions, texture coordinates and normals in 9
 * digits, which a float needs to be read back exactly; faces with indices that count through the file from 1. Metres, Y
 * up. Each panel of a cloth is a group with a material of its own; the seams are lines in a group at the end.
 */
#include "meshfile/mesh_file.h"


/* write one line for each row of `width` numbers: "v x y z" */
static void put_rows(mus__sink *sink, const char *key, int32_t n, int32_t width, const double *values)
{
    if (values == NULL) return;
    for (int32_t i = 0; i < n; i++) {
        const double *row = values + (size_t)i * (size_t)width;
        if (width == 3)
            mus__sink_print(sink, "%s %.9g %.9g %.9g\n", key, row[0], row[1], row[2]);
        else
            mus__sink_print(sink, "%s %.9g %.9g\n", key, row[0], row[1]);
    }
}


/* write a line of a key and a name; control characters and blanks become "_" */
static void put_named(mus__sink *sink, const char *key, const char *name)
{
    mus__sink_print(sink, "%s ", key);
    for (; *name != '\0'; name++) mus__sink_add(sink, (unsigned char)*name <= 0x20 ? "_" : name, 1);
    mus__sink_print(sink, "\n");
}


static void put_object(mus__sink *sink, const char *name, int32_t index)
{
    if (name == NULL || name[0] == '\0') mus__sink_print(sink, "o mesh_%d\n", (int)index);
    else put_named(sink, "o", name);
}


/* "f p/t/n p/t/n p/t/n": first (3) counts the positions, texture coordinates and normals before this mesh */
static void put_faces(mus__sink *sink, const mus__mesh_parts *mesh, const mus__mesh_part *part, const int64_t *first)
{
    const mus_mesh_view *view = mesh->view;
    const bool textured = mus__mesh_uv(mesh) != NULL;
    for (int32_t i = part->first_triangle; i < part->first_triangle + part->triangles; i++) {
        mus__sink_print(sink, "f");
        for (int32_t k = 0; k < 3; k++) {
            int64_t v = view->triangles[3 * (size_t)i + (size_t)k];
            long long p = (long long)(first[0] + v + 1), t = (long long)(first[1] + v + 1),
                      normal = (long long)(first[2] + v + 1);
            if (textured && view->normals != NULL)
                mus__sink_print(sink, " %lld/%lld/%lld", p, t, normal);
            else if (view->normals != NULL)
                mus__sink_print(sink, " %lld//%lld", p, normal);
            else if (textured)
                mus__sink_print(sink, " %lld/%lld", p, t);
            else
                mus__sink_print(sink, " %lld", p);
        }
        mus__sink_print(sink, "\n");
    }
}


/* the faces of a mesh, part by part, and its seams */
static void put_parts(mus__sink *sink, const mus__mesh_parts *mesh, const int64_t *first)
{
    char material[256];
    for (int32_t p = 0; p < mesh->count; p++) {
        mus__mesh_material(mesh, p, material, sizeof material);
        if (mesh->cloth != NULL) put_named(sink, "g", mesh->part[p].name);
        if (mesh->cloth != NULL || mesh->material != NULL) put_named(sink, "usemtl", material);
        put_faces(sink, mesh, &mesh->part[p], first);
    }
    if (mesh->nline > 0) mus__sink_print(sink, "g seams\n");
    for (size_t i = 0; i < 2 * (size_t)mesh->nline; i += 2)
        mus__sink_print(sink, "l %lld %lld\n", (long long)(first[0] + mesh->lines[i] + 1),
                        (long long)(first[0] + mesh->lines[i + 1] + 1));
}


void mus__obj_put(mus__sink *sink, const mus__mesh_set *set, const char *library)
{
    mus__sink_print(sink, "# muslin: metres, Y up\n");
    if (library != NULL) mus__sink_print(sink, "mtllib %s\n", library);
    int64_t first[3] = {0, 0, 0};
    for (int32_t i = 0; i < set->n && sink->status == MUS_OK; i++) {
        const mus__mesh_parts *mesh = &set->mesh[i];
        const mus_mesh_view *view = mesh->view;
        put_object(sink, view->name, i);
        put_rows(sink, "v", view->vertex_count, 3, view->positions);
        put_rows(sink, "vt", view->vertex_count, 2, mus__mesh_uv(mesh));
        put_rows(sink, "vn", view->vertex_count, 3, view->normals);
        put_parts(sink, mesh, first);
        first[0] += view->vertex_count;
        first[1] += mus__mesh_uv(mesh) != NULL ? view->vertex_count : 0;
        first[2] += view->normals != NULL ? view->vertex_count : 0;
    }
}


void mus__mtl_put(mus__sink *sink, const mus__mesh_set *set)
{
    char name[256];
    mus__sink_print(sink, "# muslin: linear colours\n");
    for (int32_t i = 0; i < set->n; i++) {
        const mus__mesh_parts *mesh = &set->mesh[i];
        const double *colour = mesh->view->colour;
        for (int32_t p = 0; p < mesh->count && (mesh->cloth != NULL || mesh->material != NULL); p++) {
            mus__mesh_material(mesh, p, name, sizeof name);
            put_named(sink, "newmtl", name);
            mus__sink_print(sink, "Kd %.9g %.9g %.9g\nKs 0 0 0\nd %.9g\nillum 1\n", colour[0], colour[1], colour[2],
                            colour[3]);
        }
    }
}
