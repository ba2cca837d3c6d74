/*
 * obj_write.c: write meshes as one Wavefront OBJ: an `o` for each; positions, texture coordinates and normals in 9
 * digits, which a float needs to be read back exactly; faces with indices that count through the file from 1. Metres, Y
 * up.
 */
#include "exchange/file_read.h"
#include "exchange/mesh_check.h"
#include "file/sink.h"


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


/* write the object line of a mesh; control characters of the name become blanks */
static void put_object(mus__sink *sink, const char *name, int32_t index)
{
    mus__sink_print(sink, "o ");
    if (name == NULL || name[0] == '\0')
        mus__sink_print(sink, "mesh_%d", (int)index);
    else
        for (; *name != '\0'; name++) mus__sink_add(sink, (unsigned char)*name <= 0x20 ? "_" : name, 1);
    mus__sink_print(sink, "\n");
}


/* "f p/t/n p/t/n p/t/n": first (3) counts the positions, texture coordinates and normals before this mesh */
static void put_faces(mus__sink *sink, const mus_mesh_view *mesh, const int64_t *first)
{
    for (int32_t i = 0; i < mesh->triangle_count; i++) {
        mus__sink_print(sink, "f");
        for (int32_t k = 0; k < 3; k++) {
            int64_t v = mesh->triangles[3 * (size_t)i + (size_t)k];
            long long p = (long long)(first[0] + v + 1), t = (long long)(first[1] + v + 1),
                      normal = (long long)(first[2] + v + 1);
            if (mesh->texcoords != NULL && mesh->normals != NULL)
                mus__sink_print(sink, " %lld/%lld/%lld", p, t, normal);
            else if (mesh->normals != NULL)
                mus__sink_print(sink, " %lld//%lld", p, normal);
            else if (mesh->texcoords != NULL)
                mus__sink_print(sink, " %lld/%lld", p, t);
            else
                mus__sink_print(sink, " %lld", p);
        }
        mus__sink_print(sink, "\n");
    }
}


static mus_status obj_write(mus_context *context, const mus__target *target, int32_t n, const mus_mesh_view *meshes,
                            const char *what)
{
    if (context == NULL) return MUS_ERR_ARG;
    mus_status status = mus__target_check(context, target, what);
    if (status == MUS_OK) status = mus__mesh_check(context, n, meshes);
    if (status != MUS_OK) return status;
    mus__locale locale;
    status = mus__locale_enter(context, &locale);
    if (status != MUS_OK) return status;

    mus__sink sink;
    mus__sink_init(&sink, context);
    mus__sink_print(&sink, "# muslin: metres, Y up\n");
    int64_t first[3] = {0, 0, 0};
    for (int32_t i = 0; i < n && sink.status == MUS_OK; i++) {
        const mus_mesh_view *mesh = &meshes[i];
        put_object(&sink, mesh->name, i);
        put_rows(&sink, "v", mesh->vertex_count, 3, mesh->positions);
        put_rows(&sink, "vt", mesh->vertex_count, 2, mesh->texcoords);
        put_rows(&sink, "vn", mesh->vertex_count, 3, mesh->normals);
        put_faces(&sink, mesh, first);
        first[0] += mesh->vertex_count;
        first[1] += mesh->texcoords != NULL ? mesh->vertex_count : 0;
        first[2] += mesh->normals != NULL ? mesh->vertex_count : 0;
    }
    status = mus__sink_give(&sink, target);
    mus__sink_free(&sink);
    mus__locale_leave(&locale);
    return status;
}


mus_status mus_mesh_write_obj(mus_context *context, const char *path, int32_t n, const mus_mesh_view *meshes)
{
    return obj_write(context, &(mus__target){path, NULL, NULL}, n, meshes, "mus_mesh_write_obj");
}


mus_status mus_mesh_write_obj_bytes(mus_context *context, int32_t n, const mus_mesh_view *meshes, char **bytes,
                                    size_t *size)
{
    return obj_write(context, &(mus__target){NULL, bytes, size}, n, meshes, "mus_mesh_write_obj_bytes");
}
