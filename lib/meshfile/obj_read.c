/*
 * obj_read.c: read a Wavefront OBJ as one triangle mesh: positions and faces, all objects of the file together.
 *
 * A corner of a face is "v", "v/t", "v//n" or "v/t/n". Indices count from 1, negative ones back from the last vertex. A
 * face of more than three corners becomes a fan from its first corner. Normals, texture coordinates, names, materials
 * and lines are ignored. The numbers are unchanged: an OBJ has no unit and no upward axis, and comments that state them
 * have been wrong.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "exchange/file_read.h"

#define OBJ_TRIANGLES 16000000 /* most triangles, and most vertices; chosen: far above a scan of a person */

struct mus_mesh {
    mus_context *context;
    int32_t vertex_count, triangle_count, vertex_room, triangle_room;
    double *vertices;   /* (vertex_count x 3) */
    int32_t *triangles; /* (triangle_count x 3) */
};

/* state while a file is read */
typedef struct obj_text {
    const mus__source *source;
    mus_mesh *mesh;
    int64_t line;
} obj_text;


/* grow *array to hold one more row of elements of `size` bytes; the capacity *room grows by half */
static mus_status obj_room(obj_text *obj, void *array, int32_t *room, int32_t count, size_t size)
{
    void **slot = array;
    if (count < *room) return MUS_OK;
    const int32_t grown = *room + *room / 2 + 4096;
    void *bigger = mus_context_alloc(obj->mesh->context, *slot, (size_t)grown * 3 * size);
    if (bigger == NULL) return mus__source_fail(obj->source, obj->line, MUS_ERR_MEMORY, "no memory for the mesh");
    *slot = bigger;
    *room = grown;
    return MUS_OK;
}


static const char *obj_blank(const char *at)
{
    while (*at == ' ' || *at == '\t' || *at == '\r') at++;
    return at;
}


/* read "v x y z"; a weight or a colour behind it is ignored */
static mus_status obj_vertex(obj_text *obj, const char *at)
{
    mus_mesh *mesh = obj->mesh;
    mus_status status = obj_room(obj, &mesh->vertices, &mesh->vertex_room, mesh->vertex_count, sizeof *mesh->vertices);
    for (int i = 0; i < 3 && status == MUS_OK; i++) {
        at = obj_blank(at);
        const size_t span = mus__number_span(at);
        double *x = mesh->vertices + 3 * (size_t)mesh->vertex_count + i;
        *x = span > 0 ? strtod(at, NULL) : NAN;
        if (!isfinite(*x))
            return mus__source_fail(obj->source, obj->line, MUS_ERR_FORMAT,
                                    "vertex %d: expected three numbers, got \"%.40s\"", (int)mesh->vertex_count + 1,
                                    at);
        at += span;
    }
    if (status == MUS_OK && mesh->vertex_count == OBJ_TRIANGLES)
        return mus__source_fail(obj->source, obj->line, MUS_ERR_LIMIT, "more than %d vertices", OBJ_TRIANGLES);
    mesh->vertex_count += status == MUS_OK;
    return status;
}


/* read one corner "v/t/n": its vertex, from 0; *at moves behind it */
static mus_status obj_corner(obj_text *obj, const char **at, int32_t *out)
{
    char *end;
    const long number = strtol(*at, &end, 10);
    const long vertex = number < 0 ? obj->mesh->vertex_count + number : number - 1;
    if (end == *at || strchr(" \t\r/", *end) == NULL)
        return mus__source_fail(obj->source, obj->line, MUS_ERR_FORMAT,
                                "a face: expected a vertex's number, got \"%.40s\"", *at);
    if (vertex < 0 || vertex >= obj->mesh->vertex_count)
        return mus__source_fail(obj->source, obj->line, MUS_ERR_FORMAT, "a face: there is no vertex %ld yet, of %d",
                                number, (int)obj->mesh->vertex_count);
    *out = (int32_t)vertex;
    *at = end + strcspn(end, " \t\r");
    return MUS_OK;
}


/* read "f a b c d ..." as the triangles a b c, a c d, ... */
static mus_status obj_face(obj_text *obj, const char *at)
{
    mus_mesh *mesh = obj->mesh;
    int32_t corner[3], count = 0;
    for (at = obj_blank(at); *at != '\0'; at = obj_blank(at), count++) {
        mus_status status = obj_corner(obj, &at, &corner[count < 2 ? count : 2]);
        if (status != MUS_OK) return status;
        if (count < 2) continue;
        if (mesh->triangle_count == OBJ_TRIANGLES)
            return mus__source_fail(obj->source, obj->line, MUS_ERR_LIMIT, "more than %d triangles", OBJ_TRIANGLES);
        status = obj_room(obj, &mesh->triangles, &mesh->triangle_room, mesh->triangle_count, sizeof *mesh->triangles);
        if (status != MUS_OK) return status;
        memcpy(mesh->triangles + 3 * (size_t)mesh->triangle_count++, corner, sizeof corner);
        corner[1] = corner[2];
    }
    if (count >= 3) return MUS_OK;
    return mus__source_fail(obj->source, obj->line, MUS_ERR_FORMAT, "a face: %d corners, expected 3 or more",
                            (int)count);
}


/* read all lines; a backslash at the end of a line joins the next */
static mus_status obj_read(obj_text *obj, char *text)
{
    mus_status status = MUS_OK;
    while (status == MUS_OK && *text != '\0') {
        char *line = text;
        obj->line++;
        text += strcspn(text, "\n");
        while (*text == '\n' && text > line &&
               (text[-1] == '\\' || (text[-1] == '\r' && text - 1 > line && text[-2] == '\\'))) {
            for (char *back = text; *back != '\\'; back--) *back = ' ';
            text[text[-1] == '\\' ? -1 : -2] = ' ';
            text += strcspn(text, "\n");
            obj->line++;
        }
        if (*text == '\n') *text++ = '\0';
        line[strcspn(line, "#")] = '\0';
        const char *at = obj_blank(line);
        const char *rest = at + strcspn(at, " \t\r");
        if (rest - at != 1) continue;
        if (*at == 'v') status = obj_vertex(obj, rest);
        if (*at == 'f') status = obj_face(obj, rest);
    }
    if (status == MUS_OK && obj->mesh->triangle_count == 0)
        status = mus__source_fail(obj->source, 0, MUS_ERR_FORMAT,
                                  "no face; expected lines such as \"v x y z\" and \"f a b c\" "
                                  "of a Wavefront OBJ");
    return status;
}


static mus_status obj_load(mus_context *context, const mus__input *input, mus_mesh **out, const char *what)
{
    if (out != NULL) *out = NULL;
    if (context == NULL) return MUS_ERR_ARG;
    mus_status status = mus__input_check(context, input, out, what);
    if (status != MUS_OK) return status;
    mus__source source;
    status = mus__source_open(context, input, &source);
    if (status == MUS_OK) {
        mus_mesh *mesh = mus_context_alloc(context, NULL, sizeof *mesh);
        if (mesh == NULL) {
            status = mus__source_fail(&source, 0, MUS_ERR_MEMORY, "no memory for the mesh");
        } else {
            mesh->context = context;
            obj_text obj = {&source, mesh, 0};
            status = obj_read(&obj, source.text);
        }
        if (status == MUS_OK)
            *out = mesh;
        else
            mus_mesh_destroy(mesh);
    }
    mus__source_close(&source);
    return status;
}


mus_status mus_mesh_read_obj(mus_context *context, const char *path, mus_mesh **out)
{
    return obj_load(context, &(mus__input){path, NULL, 0}, out, "mus_mesh_read_obj");
}


mus_status mus_mesh_read_obj_from(mus_context *context, const char *text, size_t size, const char *name, mus_mesh **out)
{
    return obj_load(context, &(mus__input){name, text != NULL ? text : "", size}, out, "mus_mesh_read_obj_from");
}


void mus_mesh_destroy(mus_mesh *mesh)
{
    if (mesh == NULL) return;
    mus_context *context = mesh->context;
    mus_context_alloc(context, mesh->vertices, 0);
    mus_context_alloc(context, mesh->triangles, 0);
    mus_context_alloc(context, mesh, 0);
}


int32_t mus_mesh_vertex_count(const mus_mesh *mesh)
{
    return mesh != NULL ? mesh->vertex_count : 0;
}


int32_t mus_mesh_triangle_count(const mus_mesh *mesh)
{
    return mesh != NULL ? mesh->triangle_count : 0;
}


const double *mus_mesh_vertices(const mus_mesh *mesh)
{
    return mesh != NULL ? mesh->vertices : NULL;
}


const int32_t *mus_mesh_triangles(const mus_mesh *mesh)
{
    return mesh != NULL ? mesh->triangles : NULL;
}
