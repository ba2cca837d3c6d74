/*
 * glb_write.c: write meshes as one binary glTF 2.0 file: a header, a JSON chunk, a chunk of little-endian floats and
 * indices.
 *
 *     | "glTF" 2 length | length "JSON" {...} spaces | length "BIN\0" numbers, mesh by mesh, then the animation |
 *
 * The numbers of a mesh are positions, normals, texture coordinates and indices, then for each key the differences of
 * its positions and normals from those. A mesh in motion has one morph target for each key. One animation sets the
 * weights: at a key its own weight is 1 and the others are 0; between two keys they blend (glTF 3.7.2.2, 3.11).
 *
 * Each mesh has one node, one material and up to four buffer views. Every part is a multiple of 4 bytes long, as the
 * format's alignment demands. Positions have the min and max of the floats that are written. Normals are scaled to unit
 * length; a zero normal becomes (0, 1, 0). Texture coordinates run down in glTF, so v becomes 1 - v.
 * Source: Khronos, glTF 2.0 specification, sections 3.6, 3.7 and 4.4.
 */
#include <math.h>
#include <string.h>

#include "exchange/file_read.h"
#include "exchange/mesh_check.h"
#include "file/sink.h"

#define GLB_JSON UINT32_C(0x4E4F534A) /* type of the chunk: "JSON" */
#define GLB_BIN UINT32_C(0x004E4942)  /* type of the chunk: "BIN\0" */
#define GLB_ARRAY 34962    /* buffer view target of vertex data (glTF 5.11.5) */
#define GLB_ELEMENTS 34963 /* buffer view target of indices */


static void put_u32(mus__sink *sink, uint32_t value)
{
    const unsigned char bytes[4] = {(unsigned char)value, (unsigned char)(value >> 8), (unsigned char)(value >> 16),
                                    (unsigned char)(value >> 24)};
    mus__sink_add(sink, bytes, 4);
}


static void put_f32(mus__sink *sink, double value)
{
    float narrow = (float)value;
    uint32_t bits;
    memcpy(&bits, &narrow, sizeof bits);
    put_u32(sink, bits);
}


/* motion of all meshes: the keys, their times [s], one motion for each mesh; NULL when nothing moves */
struct glb_motion {
    int32_t keys;
    const double *times;
    const mus_mesh_motion *of;
};


/* scale a normal to unit length; a zero normal becomes (0, 1, 0) */
static void glb_unit(const double *v, double *out)
{
    double length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    for (size_t k = 0; k < 3; k++) out[k] = length > 1e-30 ? v[k] / length : k == 1 ? 1.0 : 0.0;
}


/* differences of key `key` from the mesh at rest: positions, then normals */
static void put_key_bytes(mus__sink *sink, const mus_mesh_view *mesh, const mus_mesh_motion *motion, int32_t key)
{
    const size_t n = (size_t)mesh->vertex_count, at = 3 * n * (size_t)key;
    for (size_t i = 0; i < 3 * n; i++) put_f32(sink, motion->positions[at + i] - mesh->positions[i]);
    for (size_t i = 0; motion->normals != NULL && i < 3 * n; i += 3) {
        double rest[3], moved[3];
        glb_unit(mesh->normals + i, rest);
        glb_unit(motion->normals + at + i, moved);
        for (size_t k = 0; k < 3; k++) put_f32(sink, moved[k] - rest[k]);
    }
}


/* all numbers of a mesh: positions, normals, texture coordinates, indices, keys */
static void put_mesh_bytes(mus__sink *sink, const mus_mesh_view *mesh, const struct glb_motion *motion, int32_t index)
{
    size_t n = (size_t)mesh->vertex_count;
    for (size_t i = 0; i < 3 * n; i++) put_f32(sink, mesh->positions[i]);
    for (size_t i = 0; mesh->normals != NULL && i < 3 * n; i += 3) {
        double unit[3];
        glb_unit(mesh->normals + i, unit);
        for (size_t k = 0; k < 3; k++) put_f32(sink, unit[k]);
    }
    for (size_t i = 0; mesh->texcoords != NULL && i < n; i++) {
        put_f32(sink, mesh->texcoords[2 * i]);
        put_f32(sink, 1.0 - mesh->texcoords[2 * i + 1]);
    }
    for (size_t i = 0; i < 3 * (size_t)mesh->triangle_count; i++) put_u32(sink, (uint32_t)mesh->triangles[i]);
    if (motion == NULL || motion->of[index].positions == NULL) return;
    for (int32_t k = 0; k < motion->keys; k++) put_key_bytes(sink, mesh, &motion->of[index], k);
}


/* numbers of the animation: times of the keys, then at each key the weights of all keys */
static void put_motion_bytes(mus__sink *sink, const struct glb_motion *motion)
{
    for (int32_t k = 0; k < motion->keys; k++) put_f32(sink, motion->times[k]);
    for (int32_t k = 0; k < motion->keys; k++)
        for (int32_t i = 0; i < motion->keys; i++) put_f32(sink, i == k ? 1.0 : 0.0);
}


/* the JSON chunk, in lists that grow side by side */
struct glb_lists {
    mus__sink views;
    mus__sink accessors;
    int32_t count; /* length of both lists */
    uint64_t offset;
};


/* add a buffer view and its accessor: `n` elements of `width` numbers of 4 bytes; returns the index of both */
static int32_t put_accessor(struct glb_lists *lists, int64_t n, int32_t width, int32_t target)
{
    static const char *const types[] = {"", "SCALAR", "VEC2", "VEC3"};
    uint64_t bytes = (uint64_t)n * (uint64_t)width * 4;
    const char *comma = lists->count > 0 ? "," : "";
    mus__sink_print(&lists->views, "%s{\"buffer\":0,\"byteOffset\":%llu,\"byteLength\":%llu", comma,
                    (unsigned long long)lists->offset, (unsigned long long)bytes);
    if (target != 0) mus__sink_print(&lists->views, ",\"target\":%d", (int)target);
    mus__sink_print(&lists->views, "}");
    mus__sink_print(&lists->accessors, "%s{\"bufferView\":%d,\"componentType\":%d,\"count\":%lld,\"type\":\"%s\"",
                    comma, (int)lists->count, target == GLB_ELEMENTS ? 5125 : 5126, (long long)n, types[width]);
    lists->offset += bytes;
    return lists->count++;
}


/* "min" or "max" of positions (n x 3), less `off` unless that is NULL, as the floats that are written */
static void put_bound(mus__sink *sink, const char *key, int32_t n, const double *places, const double *off, double sign)
{
    mus__sink_print(sink, ",\"%s\":[", key);
    for (size_t k = 0; k < 3; k++) {
        double best = 0.0;
        for (size_t i = 0; i < (size_t)n; i++) {
            double value = (double)(float)(places[3 * i + k] - (off != NULL ? off[3 * i + k] : 0.0));
            if (i == 0 || sign * value > sign * best) best = value;
        }
        if (k > 0) mus__sink_print(sink, ",");
        mus__sink_number(sink, best);
    }
    mus__sink_print(sink, "]");
}


/* add the accessor of positions, with its bounds */
static int32_t put_places(struct glb_lists *lists, int32_t n, const double *places, const double *off)
{
    int32_t at = put_accessor(lists, n, 3, GLB_ARRAY);
    put_bound(&lists->accessors, "min", n, places, off, -1.0);
    put_bound(&lists->accessors, "max", n, places, off, 1.0);
    mus__sink_print(&lists->accessors, "}");
    return at;
}


/* add an accessor without bounds */
static int32_t put_plain(struct glb_lists *lists, int64_t n, int32_t width, int32_t target)
{
    int32_t at = put_accessor(lists, n, width, target);
    mus__sink_print(&lists->accessors, "}");
    return at;
}


/* morph targets of a mesh, and its weights at the first key */
static void put_targets(mus__sink *sink, struct glb_lists *lists, const mus_mesh_view *mesh,
                        const struct glb_motion *motion, int32_t index)
{
    const mus_mesh_motion *of = &motion->of[index];
    const size_t width = 3 * (size_t)mesh->vertex_count;
    mus__sink_print(sink, ",\"targets\":[");
    for (int32_t k = 0; k < motion->keys; k++) {
        int32_t at = put_places(lists, mesh->vertex_count, of->positions + (size_t)k * width, mesh->positions);
        mus__sink_print(sink, "%s{\"POSITION\":%d", k > 0 ? "," : "", (int)at);
        if (of->normals != NULL)
            mus__sink_print(sink, ",\"NORMAL\":%d", (int)put_plain(lists, mesh->vertex_count, 3, GLB_ARRAY));
        mus__sink_print(sink, "}");
    }
    mus__sink_print(sink, "]}],\"weights\":[");
    for (int32_t k = 0; k < motion->keys; k++) mus__sink_print(sink, k > 0 ? ",0" : "1");
    mus__sink_print(sink, "]}");
}


/* accessors of a mesh, and the mesh that refers to them */
static void put_mesh(mus__sink *sink, struct glb_lists *lists, const mus_mesh_view *mesh,
                     const struct glb_motion *motion, int32_t index)
{
    int32_t n = mesh->vertex_count;
    mus__sink_print(sink, "{\"primitives\":[{\"attributes\":{\"POSITION\":%d",
                    (int)put_places(lists, n, mesh->positions, NULL));
    if (mesh->normals != NULL)
        mus__sink_print(sink, ",\"NORMAL\":%d", (int)put_plain(lists, n, 3, GLB_ARRAY));
    if (mesh->texcoords != NULL)
        mus__sink_print(sink, ",\"TEXCOORD_0\":%d", (int)put_plain(lists, n, 2, GLB_ARRAY));
    int32_t at = put_plain(lists, 3 * (int64_t)mesh->triangle_count, 1, GLB_ELEMENTS);
    mus__sink_print(sink, "},\"indices\":%d,\"material\":%d", (int)at, (int)index);
    if (motion != NULL && motion->of[index].positions != NULL)
        put_targets(sink, lists, mesh, motion, index);
    else
        mus__sink_print(sink, "}]}");
}


/* the animation: one channel for each mesh that moves, all with one sampler */
static void put_animation(mus__sink *sink, struct glb_lists *lists, int32_t n, const struct glb_motion *motion)
{
    int32_t moving = 0;
    for (int32_t i = 0; i < n; i++) moving += motion->of[i].positions != NULL;
    if (moving == 0) return;
    int32_t at = put_accessor(lists, motion->keys, 1, 0);
    for (int end = 0; end < 2; end++) {
        mus__sink_print(&lists->accessors, ",\"%s\":[", end == 0 ? "min" : "max");
        mus__sink_number(&lists->accessors, (double)(float)motion->times[end == 0 ? 0 : motion->keys - 1]);
        mus__sink_print(&lists->accessors, "]");
    }
    mus__sink_print(&lists->accessors, "}");
    int32_t weights = put_plain(lists, (int64_t)motion->keys * motion->keys, 1, 0);
    mus__sink_print(sink, "],\"animations\":[{\"samplers\":[{\"input\":%d,\"output\":%d}],\"channels\":[", (int)at,
                    (int)weights);
    for (int32_t i = 0, put = 0; i < n; i++) {
        if (motion->of[i].positions == NULL) continue;
        mus__sink_print(sink, "%s{\"sampler\":0,\"target\":{\"node\":%d,\"path\":\"weights\"}}", put++ > 0 ? "," : "",
                        (int)i);
    }
    mus__sink_print(sink, "]}");
}


static void put_material(mus__sink *sink, const mus_mesh_view *mesh)
{
    mus__sink_print(sink, "{\"pbrMetallicRoughness\":{\"baseColorFactor\":[");
    for (int32_t k = 0; k < 4; k++) {
        if (k > 0) mus__sink_print(sink, ",");
        mus__sink_number(sink, mesh->colour[k]);
    }
    mus__sink_print(sink, "],\"metallicFactor\":0,\"roughnessFactor\":0.9}%s%s}",
                    mesh->colour[3] < 1.0 ? ",\"alphaMode\":\"BLEND\"" : "",
                    mesh->two_sided != 0 ? ",\"doubleSided\":true" : "");
}


/* the whole JSON document; the lists of views and accessors follow the meshes that fill them */
static void put_document(mus__sink *sink, struct glb_lists *lists, int32_t n, const mus_mesh_view *meshes,
                         const struct glb_motion *motion)
{
    mus__sink_print(
        sink, "{\"asset\":{\"version\":\"2.0\",\"generator\":\"muslin %d.%d.%d\"},\"scene\":0,\"scenes\":[{\"nodes\":[",
        MUS_VERSION_MAJOR, MUS_VERSION_MINOR, MUS_VERSION_PATCH);
    for (int32_t i = 0; i < n; i++) mus__sink_print(sink, "%s%d", i > 0 ? "," : "", (int)i);
    mus__sink_print(sink, "]}],\"nodes\":[");
    for (int32_t i = 0; i < n; i++) {
        mus__sink_print(sink, "%s{\"mesh\":%d", i > 0 ? "," : "", (int)i);
        if (meshes[i].name != NULL && meshes[i].name[0] != '\0') {
            mus__sink_print(sink, ",\"name\":");
            mus__sink_quote(sink, meshes[i].name);
        }
        mus__sink_print(sink, "}");
    }
    mus__sink_print(sink, "],\"materials\":[");
    for (int32_t i = 0; i < n; i++) {
        if (i > 0) mus__sink_print(sink, ",");
        put_material(sink, &meshes[i]);
    }
    mus__sink_print(sink, "],\"meshes\":[");
    for (int32_t i = 0; i < n; i++) {
        if (i > 0) mus__sink_print(sink, ",");
        put_mesh(sink, lists, &meshes[i], motion, i);
    }
    if (motion != NULL) put_animation(sink, lists, n, motion);
    mus__sink_print(sink, "],\"accessors\":[");
    mus__sink_add(sink, lists->accessors.bytes, lists->accessors.size);
    mus__sink_print(sink, "],\"bufferViews\":[");
    mus__sink_add(sink, lists->views.bytes, lists->views.size);
    mus__sink_print(sink, "],\"buffers\":[{\"byteLength\":%llu}]}", (unsigned long long)lists->offset);
}


static mus_status glb_build(mus_context *context, mus__sink *file, mus__sink *json, struct glb_lists *lists, int32_t n,
                            const mus_mesh_view *meshes, const struct glb_motion *motion)
{
    put_document(json, lists, n, meshes, motion);
    while (json->status == MUS_OK && json->size % 4 != 0) mus__sink_add(json, " ", 1);
    if (lists->views.status != MUS_OK) return lists->views.status;
    if (lists->accessors.status != MUS_OK) return lists->accessors.status;
    if (json->status != MUS_OK) return json->status;
    uint64_t length = 12 + 8 + (uint64_t)json->size + 8 + lists->offset;
    if (length > UINT32_MAX)
        return mus__file_fail(context, MUS_ERR_LIMIT, "a .glb of %llu bytes is above the limit of 4 GiB",
                              (unsigned long long)length);

    mus__sink_add(file, "glTF", 4);
    put_u32(file, 2);
    put_u32(file, (uint32_t)length);
    put_u32(file, (uint32_t)json->size);
    put_u32(file, GLB_JSON);
    mus__sink_add(file, json->bytes, json->size);
    put_u32(file, (uint32_t)lists->offset);
    put_u32(file, GLB_BIN);
    for (int32_t i = 0; i < n; i++) put_mesh_bytes(file, &meshes[i], motion, i);
    for (int32_t i = 0; motion != NULL && i < n; i++)
        if (motion->of[i].positions != NULL) {
            put_motion_bytes(file, motion);
            break;
        }
    return file->status;
}


static mus_status glb_write(mus_context *context, const mus__target *target, int32_t n, const mus_mesh_view *meshes,
                            const struct glb_motion *motion)
{
    mus__locale locale;
    mus_status status = mus__locale_enter(context, &locale);
    if (status != MUS_OK) return status;

    mus__sink file, json;
    struct glb_lists lists = {.count = 0};
    mus__sink_init(&file, context);
    mus__sink_init(&json, context);
    mus__sink_init(&lists.views, context);
    mus__sink_init(&lists.accessors, context);
    status = glb_build(context, &file, &json, &lists, n, meshes, motion);
    if (status == MUS_OK) status = mus__sink_give(&file, target);
    mus__sink_free(&lists.accessors);
    mus__sink_free(&lists.views);
    mus__sink_free(&json);
    mus__sink_free(&file);
    mus__locale_leave(&locale);
    return status;
}


static mus_status glb_meshes(mus_context *context, const mus__target *target, int32_t n, const mus_mesh_view *meshes,
                             const char *what)
{
    if (context == NULL) return MUS_ERR_ARG;
    mus_status status = mus__target_check(context, target, what);
    if (status == MUS_OK) status = mus__mesh_check(context, n, meshes);
    return status == MUS_OK ? glb_write(context, target, n, meshes, NULL) : status;
}


static mus_status glb_motion(mus_context *context, const mus__target *target, int32_t n, const mus_mesh_view *meshes,
                             const struct glb_motion *motion, const char *what)
{
    if (context == NULL) return MUS_ERR_ARG;
    mus_status status = mus__target_check(context, target, what);
    if (status == MUS_OK) status = mus__mesh_check(context, n, meshes);
    if (status == MUS_OK)
        status = mus__mesh_check_motion(context, n, meshes, motion->keys, motion->times, motion->of);
    return status == MUS_OK ? glb_write(context, target, n, meshes, motion) : status;
}


mus_status mus_mesh_write_glb(mus_context *context, const char *path, int32_t n, const mus_mesh_view *meshes)
{
    return glb_meshes(context, &(mus__target){path, NULL, NULL}, n, meshes, "mus_mesh_write_glb");
}


mus_status mus_mesh_write_glb_bytes(mus_context *context, int32_t n, const mus_mesh_view *meshes, char **bytes,
                                    size_t *size)
{
    return glb_meshes(context, &(mus__target){NULL, bytes, size}, n, meshes, "mus_mesh_write_glb_bytes");
}


mus_status mus_mesh_write_glb_motion(mus_context *context, const char *path, int32_t n, const mus_mesh_view *meshes,
                                     int32_t keys, const double *times, const mus_mesh_motion *motion)
{
    const struct glb_motion all = {keys, times, motion};
    return glb_motion(context, &(mus__target){path, NULL, NULL}, n, meshes, &all, "mus_mesh_write_glb_motion");
}


mus_status mus_mesh_write_glb_motion_bytes(mus_context *context, int32_t n, const mus_mesh_view *meshes, int32_t keys,
                                           const double *times, const mus_mesh_motion *motion, char **bytes,
                                           size_t *size)
{
    const struct glb_motion all = {keys, times, motion};
    return glb_motion(context, &(mus__target){NULL, bytes, size}, n, meshes, &all, "mus_mesh_write_glb_motion_bytes");
}
