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
 * Each mesh has one node, one material and up to four buffer views. A mesh of a cloth has a node for the garment, under
 * it one node, mesh and material for each panel, whose accessors are ranges of the same buffer views, and one of lines
 * for the seams; its texture coordinates are the packed islands first, then the flat panels in metres. Every view is a
 * multiple of 4 bytes long, as the format's alignment demands. Positions have the min and max of the floats that are
 * written. Normals are scaled to unit length; a zero normal becomes (0, 1, 0). Texture coordinates run down in glTF, so
 * v becomes 1 - v.
 * Source: Khronos, glTF 2.0 specification, sections 3.6, 3.7 and 4.4.
 */
#include <math.h>
#include <string.h>

#include "meshfile/mesh_file.h"

#define GLB_JSON UINT32_C(0x4E4F534A) /* type of the chunk: "JSON" */
#define GLB_BIN UINT32_C(0x004E4942)  /* type of the chunk: "BIN\0" */
#define GLB_ARRAY 34962    /* buffer view target of vertex data (glTF 5.11.5) */
#define GLB_ELEMENTS 34963 /* buffer view target of indices */


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
    for (size_t i = 0; i < 3 * n; i++) mus__sink_f32(sink, motion->positions[at + i] - mesh->positions[i]);
    for (size_t i = 0; motion->normals != NULL && i < 3 * n; i += 3) {
        double rest[3], moved[3];
        glb_unit(mesh->normals + i, rest);
        glb_unit(motion->normals + at + i, moved);
        for (size_t k = 0; k < 3; k++) mus__sink_f32(sink, moved[k] - rest[k]);
    }
}


/* texture coordinates run down in glTF */
static void put_uv_bytes(mus__sink *sink, int32_t n, const double *uv)
{
    for (size_t i = 0; uv != NULL && i < (size_t)n; i++) {
        mus__sink_f32(sink, uv[2 * i]);
        mus__sink_f32(sink, 1.0 - uv[2 * i + 1]);
    }
}


/* all numbers of a mesh: positions, normals, texture coordinates, indices, seams, keys */
static void put_mesh_bytes(mus__sink *sink, const mus__mesh_set *set, const mus__mesh_parts *mesh)
{
    const mus_mesh_view *view = mesh->view;
    size_t n = (size_t)view->vertex_count;
    for (size_t i = 0; i < 3 * n; i++) mus__sink_f32(sink, view->positions[i]);
    for (size_t i = 0; view->normals != NULL && i < 3 * n; i += 3) {
        double unit[3];
        glb_unit(view->normals + i, unit);
        for (size_t k = 0; k < 3; k++) mus__sink_f32(sink, unit[k]);
    }
    put_uv_bytes(sink, view->vertex_count, mesh->islands);
    put_uv_bytes(sink, view->vertex_count, view->texcoords);
    for (int32_t p = 0; p < mesh->count; p++) {
        const mus__mesh_part *part = &mesh->part[p];
        const size_t first = 3 * (size_t)part->first_triangle;
        for (size_t i = first; i < first + 3 * (size_t)part->triangles; i++)
            mus__sink_u32(sink, (uint32_t)(view->triangles[i] - part->first_vertex));
    }
    for (size_t i = 0; i < 2 * (size_t)mesh->nline; i++) mus__sink_u32(sink, (uint32_t)mesh->lines[i]);
    for (int32_t k = 0; mesh->motion != NULL && k < set->keys; k++) put_key_bytes(sink, view, mesh->motion, k);
}


/* numbers of the animation: times of the keys, then at each key the weights of all keys */
static void put_motion_bytes(mus__sink *sink, const mus__mesh_set *set)
{
    for (int32_t k = 0; k < set->keys; k++) mus__sink_f32(sink, set->times[k]);
    for (int32_t k = 0; k < set->keys; k++)
        for (int32_t i = 0; i < set->keys; i++) mus__sink_f32(sink, i == k ? 1.0 : 0.0);
}


/* the JSON chunk, in lists that grow side by side */
struct glb_lists {
    mus__sink views;
    mus__sink accessors;
    mus__sink nodes; /* of the panels and seams, which follow those of the meshes */
    int32_t nview, naccessor, nnode, nmesh, nmaterial;
    uint64_t offset; /* of the next view in the numbers [bytes] */
};

/* buffer views of one mesh; MUS_NONE: it has none */
struct glb_views {
    int32_t position, normal, uv[2], index, line;
    int32_t key; /* of the first key; each has one view, or two with normals */
};


/* add a buffer view: `n` elements of `width` numbers of 4 bytes, with a stride when it has several accessors of
 * vertices. Returns its index */
static int32_t put_view(struct glb_lists *lists, int64_t n, int32_t width, int32_t target, bool shared)
{
    uint64_t bytes = (uint64_t)n * (uint64_t)width * 4;
    mus__sink_print(&lists->views, "%s{\"buffer\":0,\"byteOffset\":%llu,\"byteLength\":%llu",
                    lists->nview > 0 ? "," : "", (unsigned long long)lists->offset, (unsigned long long)bytes);
    if (shared && target == GLB_ARRAY) mus__sink_print(&lists->views, ",\"byteStride\":%d", 4 * (int)width);
    if (target != 0) mus__sink_print(&lists->views, ",\"target\":%d", (int)target);
    mus__sink_print(&lists->views, "}");
    lists->offset += bytes;
    return lists->nview++;
}


/* begin an accessor: the elements from `first` on of a buffer view, `n` of `width` numbers; returns its index */
static int32_t put_accessor(struct glb_lists *lists, int32_t view, int64_t first, int64_t n, int32_t width, bool index)
{
    static const char *const types[] = {"", "SCALAR", "VEC2", "VEC3"};
    mus__sink_print(&lists->accessors, "%s{\"bufferView\":%d", lists->naccessor > 0 ? "," : "", (int)view);
    if (first > 0) mus__sink_print(&lists->accessors, ",\"byteOffset\":%lld", 4LL * width * (long long)first);
    mus__sink_print(&lists->accessors, ",\"componentType\":%d,\"count\":%lld,\"type\":\"%s\"", index ? 5125 : 5126,
                    (long long)n, types[width]);
    return lists->naccessor++;
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


/* add the accessor of a part's positions, with its bounds */
static int32_t put_places(struct glb_lists *lists, int32_t view, const mus__mesh_part *part, const double *places,
                          const double *off)
{
    const ptrdiff_t first = 3 * (ptrdiff_t)part->first_vertex;
    int32_t at = put_accessor(lists, view, part->first_vertex, part->vertices, 3, false);
    for (int end = 0; end < 2; end++)
        put_bound(&lists->accessors, end == 0 ? "min" : "max", part->vertices, places + first,
                  off != NULL ? off + first : NULL, end == 0 ? -1.0 : 1.0);
    mus__sink_print(&lists->accessors, "}");
    return at;
}


/* add an accessor without bounds */
static int32_t put_plain(struct glb_lists *lists, int32_t view, int64_t first, int64_t n, int32_t width, bool index)
{
    int32_t at = put_accessor(lists, view, first, n, width, index);
    mus__sink_print(&lists->accessors, "}");
    return at;
}


/* the buffer views of a mesh, in the order of its bytes */
static struct glb_views put_views(struct glb_lists *lists, const mus__mesh_set *set, const mus__mesh_parts *mesh)
{
    const mus_mesh_view *view = mesh->view;
    const int32_t n = view->vertex_count;
    const bool shared = mesh->cloth != NULL;
    struct glb_views at = {MUS_NONE, MUS_NONE, {MUS_NONE, MUS_NONE}, MUS_NONE, MUS_NONE, MUS_NONE};
    int32_t nuv = 0;
    at.position = put_view(lists, n, 3, GLB_ARRAY, shared);
    if (view->normals != NULL) at.normal = put_view(lists, n, 3, GLB_ARRAY, shared);
    if (mesh->islands != NULL) at.uv[nuv++] = put_view(lists, n, 2, GLB_ARRAY, shared);
    if (view->texcoords != NULL) at.uv[nuv++] = put_view(lists, n, 2, GLB_ARRAY, shared);
    at.index = put_view(lists, 3 * (int64_t)view->triangle_count, 1, GLB_ELEMENTS, shared);
    if (mesh->nline > 0) at.line = put_view(lists, 2 * (int64_t)mesh->nline, 1, GLB_ELEMENTS, shared);
    if (mesh->motion == NULL) return at;
    at.key = lists->nview;
    for (int32_t k = 0; k < set->keys * (mesh->motion->normals != NULL ? 2 : 1); k++)
        put_view(lists, n, 3, GLB_ARRAY, shared);
    return at;
}


/* the end of a primitive and its mesh; of a mesh in motion with its morph targets, and its weights at the first key */
static void put_targets(mus__sink *sink, struct glb_lists *lists, const mus__mesh_set *set, const mus__mesh_parts *mesh,
                        const mus__mesh_part *part, const struct glb_views *views, bool lit)
{
    if (mesh->motion == NULL) {
        mus__sink_print(sink, "}]}");
        return;
    }
    const mus_mesh_motion *of = mesh->motion;
    const size_t width = 3 * (size_t)mesh->view->vertex_count;
    int32_t view = views->key;
    mus__sink_print(sink, ",\"targets\":[");
    for (int32_t k = 0; k < set->keys; k++) {
        int32_t at = put_places(lists, view++, part, of->positions + (size_t)k * width, mesh->view->positions);
        mus__sink_print(sink, "%s{\"POSITION\":%d", k > 0 ? "," : "", (int)at);
        if (of->normals != NULL && lit)
            mus__sink_print(sink, ",\"NORMAL\":%d",
                            (int)put_plain(lists, view, part->first_vertex, part->vertices, 3, false));
        if (of->normals != NULL) view++;
        mus__sink_print(sink, "}");
    }
    mus__sink_print(sink, "]}],\"weights\":[");
    for (int32_t k = 0; k < set->keys; k++) mus__sink_print(sink, k > 0 ? ",0" : "1");
    mus__sink_print(sink, "]}");
}


/* accessors of a part, and the mesh that refers to them */
static void put_part(mus__sink *sink, struct glb_lists *lists, const mus__mesh_set *set, const mus__mesh_parts *mesh,
                     int32_t index, const struct glb_views *views)
{
    const mus__mesh_part *part = &mesh->part[index];
    const int32_t first = part->first_vertex, n = part->vertices;
    mus__sink_print(sink, "%s{\"primitives\":[{\"attributes\":{\"POSITION\":%d", lists->nmesh++ > 0 ? "," : "",
                    (int)put_places(lists, views->position, part, mesh->view->positions, NULL));
    if (views->normal != MUS_NONE)
        mus__sink_print(sink, ",\"NORMAL\":%d", (int)put_plain(lists, views->normal, first, n, 3, false));
    for (int32_t k = 0; k < 2; k++)
        if (views->uv[k] != MUS_NONE)
            mus__sink_print(sink, ",\"TEXCOORD_%d\":%d", (int)k,
                            (int)put_plain(lists, views->uv[k], first, n, 2, false));
    int32_t at =
        put_plain(lists, views->index, 3 * (int64_t)part->first_triangle, 3 * (int64_t)part->triangles, 1, true);
    mus__sink_print(sink, "},\"indices\":%d,\"material\":%d", (int)at, (int)lists->nmaterial++);
    put_targets(sink, lists, set, mesh, part, views, true);
}


/* the seams of a mesh as lines */
static void put_lines(mus__sink *sink, struct glb_lists *lists, const mus__mesh_set *set, const mus__mesh_parts *mesh,
                      const struct glb_views *views)
{
    const mus__mesh_part whole = {NULL, 0, mesh->view->vertex_count, 0, 0};
    int32_t place = put_places(lists, views->position, &whole, mesh->view->positions, NULL);
    int32_t at = put_plain(lists, views->line, 0, 2 * (int64_t)mesh->nline, 1, true);
    mus__sink_print(sink, ",{\"primitives\":[{\"attributes\":{\"POSITION\":%d},\"indices\":%d,\"mode\":1", (int)place,
                    (int)at);
    lists->nmesh++;
    put_targets(sink, lists, set, mesh, &whole, views, false);
}


static void put_mesh(mus__sink *sink, struct glb_lists *lists, const mus__mesh_set *set, const mus__mesh_parts *mesh)
{
    const struct glb_views views = put_views(lists, set, mesh);
    for (int32_t p = 0; p < mesh->count; p++) put_part(sink, lists, set, mesh, p, &views);
    if (mesh->nline > 0) put_lines(sink, lists, set, mesh, &views);
}


/* nodes of a mesh: itself, or its panels and seams */
static int32_t glb_nodes(const mus__mesh_parts *mesh)
{
    return mesh->cloth == NULL ? 1 : mesh->count + (mesh->nline > 0);
}


/* the animation: one channel for each node that moves, all with one sampler */
static void put_animation(mus__sink *sink, struct glb_lists *lists, const mus__mesh_set *set)
{
    int32_t moving = 0;
    for (int32_t i = 0; i < set->n; i++) moving += set->mesh[i].motion != NULL;
    if (moving == 0) return;
    int32_t at = put_accessor(lists, put_view(lists, set->keys, 1, 0, false), 0, set->keys, 1, false);
    for (int end = 0; end < 2; end++) {
        mus__sink_print(&lists->accessors, ",\"%s\":[", end == 0 ? "min" : "max");
        mus__sink_number(&lists->accessors, (double)(float)set->times[end == 0 ? 0 : set->keys - 1]);
        mus__sink_print(&lists->accessors, "]");
    }
    mus__sink_print(&lists->accessors, "}");
    const int64_t count = (int64_t)set->keys * set->keys;
    int32_t weights = put_plain(lists, put_view(lists, count, 1, 0, false), 0, count, 1, false);
    mus__sink_print(sink, "],\"animations\":[{\"samplers\":[{\"input\":%d,\"output\":%d}],\"channels\":[", (int)at,
                    (int)weights);
    for (int32_t i = 0, put = 0, child = set->n; i < set->n; i++) {
        const mus__mesh_parts *mesh = &set->mesh[i];
        const int32_t nodes = glb_nodes(mesh), first = mesh->cloth == NULL ? i : child;
        for (int32_t k = 0; k < nodes && mesh->motion != NULL; k++)
            mus__sink_print(sink, "%s{\"sampler\":0,\"target\":{\"node\":%d,\"path\":\"weights\"}}",
                            put++ > 0 ? "," : "", (int)(first + k));
        if (mesh->cloth != NULL) child += nodes;
    }
    mus__sink_print(sink, "]}");
}


static void put_material(mus__sink *sink, struct glb_lists *lists, const mus__mesh_parts *mesh, int32_t part)
{
    char name[256];
    mus__mesh_material(mesh, part, name, sizeof name);
    mus__sink_print(sink, "%s{", lists->nmaterial++ > 0 ? "," : "");
    if (mesh->material != NULL || mesh->cloth != NULL) {
        mus__sink_print(sink, "\"name\":");
        mus__sink_quote(sink, name);
        mus__sink_print(sink, ",");
    }
    mus__sink_print(sink, "\"pbrMetallicRoughness\":{\"baseColorFactor\":[");
    for (int32_t k = 0; k < 4; k++) {
        if (k > 0) mus__sink_print(sink, ",");
        mus__sink_number(sink, mesh->view->colour[k]);
    }
    mus__sink_print(sink, "],\"metallicFactor\":0,\"roughnessFactor\":0.9}%s%s}",
                    mesh->view->colour[3] < 1.0 ? ",\"alphaMode\":\"BLEND\"" : "",
                    mesh->view->two_sided != 0 ? ",\"doubleSided\":true" : "");
}


/* the end of a node: its name, if it has one */
static void put_name(mus__sink *sink, const char *name)
{
    if (name != NULL && name[0] != '\0') {
        mus__sink_print(sink, ",\"name\":");
        mus__sink_quote(sink, name);
    }
    mus__sink_print(sink, "}");
}


/* the node of a mesh; with a cloth its panels and seams are nodes under it, in lists->nodes */
static void put_node(mus__sink *sink, struct glb_lists *lists, const mus__mesh_parts *mesh)
{
    if (mesh->cloth == NULL) {
        mus__sink_print(sink, "{\"mesh\":%d", (int)lists->nmesh++);
        put_name(sink, mesh->view->name);
        return;
    }
    mus__sink_print(sink, "{\"children\":[");
    for (int32_t k = 0; k < glb_nodes(mesh); k++) {
        mus__sink_print(sink, "%s%d", k > 0 ? "," : "", (int)lists->nnode++);
        mus__sink_print(&lists->nodes, ",{\"mesh\":%d", (int)lists->nmesh++);
        put_name(&lists->nodes, k < mesh->count ? mesh->part[k].name : "seams");
    }
    mus__sink_print(sink, "]");
    put_name(sink, mesh->view->name);
}


/* the whole JSON document; the lists of views and accessors follow the meshes that fill them */
static void put_document(mus__sink *sink, struct glb_lists *lists, const mus__mesh_set *set)
{
    mus__sink_print(
        sink, "{\"asset\":{\"version\":\"2.0\",\"generator\":\"muslin %d.%d.%d\"},\"scene\":0,\"scenes\":[{\"nodes\":[",
        MUS_VERSION_MAJOR, MUS_VERSION_MINOR, MUS_VERSION_PATCH);
    for (int32_t i = 0; i < set->n; i++) mus__sink_print(sink, "%s%d", i > 0 ? "," : "", (int)i);
    mus__sink_print(sink, "]}],\"nodes\":[");
    lists->nnode = set->n;
    for (int32_t i = 0; i < set->n; i++) {
        if (i > 0) mus__sink_print(sink, ",");
        put_node(sink, lists, &set->mesh[i]);
    }
    mus__sink_add(sink, lists->nodes.bytes, lists->nodes.size);
    mus__sink_print(sink, "],\"materials\":[");
    for (int32_t i = 0; i < set->n; i++)
        for (int32_t p = 0; p < set->mesh[i].count; p++) put_material(sink, lists, &set->mesh[i], p);
    mus__sink_print(sink, "],\"meshes\":[");
    lists->nmesh = lists->nmaterial = 0;
    for (int32_t i = 0; i < set->n; i++) put_mesh(sink, lists, set, &set->mesh[i]);
    put_animation(sink, lists, set);
    mus__sink_print(sink, "],\"accessors\":[");
    mus__sink_add(sink, lists->accessors.bytes, lists->accessors.size);
    mus__sink_print(sink, "],\"bufferViews\":[");
    mus__sink_add(sink, lists->views.bytes, lists->views.size);
    mus__sink_print(sink, "],\"buffers\":[{\"byteLength\":%llu}]}", (unsigned long long)lists->offset);
}


static mus_status glb_build(mus__sink *file, mus__sink *json, struct glb_lists *lists, const mus__mesh_set *set)
{
    put_document(json, lists, set);
    while (json->status == MUS_OK && json->size % 4 != 0) mus__sink_add(json, " ", 1);
    const mus__sink *const sinks[] = {&lists->views, &lists->accessors, &lists->nodes, json};
    for (size_t i = 0; i < sizeof sinks / sizeof *sinks; i++)
        if (sinks[i]->status != MUS_OK) return sinks[i]->status;
    uint64_t length = 12 + 8 + (uint64_t)json->size + 8 + lists->offset;
    if (length > UINT32_MAX)
        return mus__file_fail(set->context, MUS_ERR_LIMIT, "a .glb of %llu bytes is above the limit of 4 GiB",
                              (unsigned long long)length);

    mus__sink_add(file, "glTF", 4);
    mus__sink_u32(file, 2);
    mus__sink_u32(file, (uint32_t)length);
    mus__sink_u32(file, (uint32_t)json->size);
    mus__sink_u32(file, GLB_JSON);
    mus__sink_add(file, json->bytes, json->size);
    mus__sink_u32(file, (uint32_t)lists->offset);
    mus__sink_u32(file, GLB_BIN);
    bool moves = false;
    for (int32_t i = 0; i < set->n; i++) {
        put_mesh_bytes(file, set, &set->mesh[i]);
        moves = moves || set->mesh[i].motion != NULL;
    }
    if (moves) put_motion_bytes(file, set);
    return file->status;
}


mus_status mus__glb_put(mus__sink *sink, const mus__mesh_set *set)
{
    mus__sink json;
    struct glb_lists lists = {.offset = 0};
    mus__sink_init(&json, set->context);
    mus__sink_init(&lists.views, set->context);
    mus__sink_init(&lists.accessors, set->context);
    mus__sink_init(&lists.nodes, set->context);
    mus_status status = glb_build(sink, &json, &lists, set);
    mus__sink_free(&lists.nodes);
    mus__sink_free(&lists.accessors);
    mus__sink_free(&lists.views);
    mus__sink_free(&json);
    return status;
}
