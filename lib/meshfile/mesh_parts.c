/*
 * mesh_parts.c: divide the mesh of a cloth into its panels, pack their texture coordinates, list its seams as lines.
 *
 * The nodes and triangles of a panel are one range of the cloth's, so a part copies nothing. The flat panels keep
 * their shape and their relative size as islands of the texture: their boxes are packed on the smallest square on
 * which they fit, tallest first, and the square becomes the unit square.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "file/message.h"
#include "file/pack.h"
#include "meshfile/mesh_file.h"

/* distance of islands, as a share of the root of their boxes' area. Chosen: 2 texels of a texture of 512; more wastes
 * the texture, less lets the colours of neighbours run into each other where it is shown small */
#define ISLAND_GAP (2.0 / 512.0)
#define ISLAND_GROWTH 1.01 /* of the square from try to try. Chosen: 1 % of its side is at most wasted */


void mus__mesh_set_free(mus__mesh_set *set)
{
    for (int32_t i = 0; set->mesh != NULL && i < set->n; i++) {
        mus_context_alloc(set->context, set->mesh[i].part, 0);
        mus_context_alloc(set->context, set->mesh[i].islands, 0);
        mus_context_alloc(set->context, set->mesh[i].lines, 0);
    }
    mus_context_alloc(set->context, set->mesh, 0);
    set->mesh = NULL;
}


const double *mus__mesh_uv(const mus__mesh_parts *mesh)
{
    return mesh->islands != NULL ? mesh->islands : mesh->view->texcoords;
}


void mus__mesh_material(const mus__mesh_parts *mesh, int32_t part, char *hold, size_t bytes)
{
    const char *name = mesh->part[part].name != NULL ? mesh->part[part].name : "";
    if (mesh->material == NULL) snprintf(hold, bytes, "%s", name);
    else if (mesh->cloth == NULL) snprintf(hold, bytes, "%s", mesh->material);
    else snprintf(hold, bytes, "%s.%s", mesh->material, name);
}


/* an array of `n` elements, 1 at least; *status gets MUS_ERR_MEMORY without room */
static void *parts_room(mus_context *context, int64_t n, size_t size, mus_status *status)
{
    void *room = *status == MUS_OK ? mus_context_alloc(context, NULL, (size_t)(n > 0 ? n : 1) * size) : NULL;
    if (room == NULL && *status == MUS_OK)
        *status = mus__file_fail(context, MUS_ERR_MEMORY, "no memory for the parts of a mesh");
    return room;
}


/* one part for each panel that has triangles; they must be the cloth's */
static mus_status parts_panels(mus_context *context, int32_t index, mus__mesh_parts *mesh)
{
    const mus_mesh_view *view = mesh->view;
    const mus_cloth *cloth = mesh->cloth;
    const int32_t panels = mus_cloth_panel_count(cloth);
    if (view->vertex_count != mus_cloth_node_count(cloth) || view->triangle_count != mus_cloth_triangle_count(cloth) ||
        memcmp(view->triangles, mus_cloth_triangles(cloth), 3 * (size_t)view->triangle_count * sizeof(int32_t)) != 0)
        return mus__file_fail(context, MUS_ERR_ARG, "mesh %d: %d vertices and %d triangles, its cloth has others: %d "
                              "nodes and %d triangles", (int)index, (int)view->vertex_count, (int)view->triangle_count,
                              (int)mus_cloth_node_count(cloth), (int)mus_cloth_triangle_count(cloth));
    mus_status status = MUS_OK;
    mesh->part = parts_room(context, panels, sizeof *mesh->part, &status);
    for (int32_t p = 0; status == MUS_OK && p < panels; p++) {
        int32_t range[4];
        status = mus_cloth_panel_range(cloth, p, range);
        const char *name = mus_cloth_panel_name(cloth, p);
        if (status != MUS_OK || range[3] == 0) continue;
        if (name == NULL || name[0] == '\0') name = view->name != NULL ? view->name : "panel";
        mesh->part[mesh->count++] = (mus__mesh_part){name, range[0], range[1], range[2], range[3]};
    }
    return status;
}


/* the seams of a cloth: a line between the first nodes of two pairs that follow each other along one seam */
static mus_status parts_lines(mus_context *context, mus__mesh_parts *mesh)
{
    const int32_t npair = mus_cloth_pair_count(mesh->cloth);
    const int32_t *pair = mus_cloth_pairs(mesh->cloth), *seam = mus_cloth_pair_seams(mesh->cloth);
    mus_status status = MUS_OK;
    mesh->lines = parts_room(context, 2 * (int64_t)npair, sizeof *mesh->lines, &status);
    for (int32_t k = 1; status == MUS_OK && k < npair; k++) {
        if (seam[k] != seam[k - 1]) continue;
        mesh->lines[2 * (ptrdiff_t)mesh->nline] = pair[2 * (ptrdiff_t)k - 2];
        mesh->lines[2 * (ptrdiff_t)mesh->nline++ + 1] = pair[2 * (ptrdiff_t)k];
    }
    return status;
}


/* low corner and size of the box of each panel; returns the sum of the boxes' areas, and the longest side */
static double parts_boxes(const mus__mesh_parts *mesh, double *low, double *size, double *longest)
{
    const double *rest = mus_cloth_rest(mesh->cloth);
    double area = 0.0;
    *longest = 0.0;
    for (int32_t p = 0; p < mesh->count; p++) {
        double high[2] = {-INFINITY, -INFINITY};
        low[2 * p] = low[2 * p + 1] = INFINITY;
        for (ptrdiff_t i = 0; i < 2 * (ptrdiff_t)mesh->part[p].vertices; i++) {
            const double x = rest[2 * (ptrdiff_t)mesh->part[p].first_vertex + i];
            low[2 * p + i % 2] = fmin(low[2 * p + i % 2], x);
            high[i % 2] = fmax(high[i % 2], x);
        }
        for (int32_t k = 0; k < 2; k++) {
            size[2 * p + k] = high[k] - low[2 * p + k];
            *longest = fmax(*longest, size[2 * p + k]);
        }
        area += size[2 * p] * size[2 * p + 1];
    }
    return area;
}


/* pack the boxes on the smallest square of the tries; at (count x 2) gets their corners. Returns the square's side */
static double parts_pack(const mus__mesh_parts *mesh, double *low, double *size, double *at, int32_t *work, double *sky)
{
    double longest;
    const double area = parts_boxes(mesh, low, size, &longest), gap = ISLAND_GAP * sqrt(area);
    double side = fmax(longest, sqrt(area)), high = -1.0;
    for (;; side *= ISLAND_GROWTH) {
        high = mus__pack(mesh->count, size, side, gap, at, work, sky);
        if (high >= 0.0 && high <= side) return side;
    }
}


static mus_status parts_islands(mus_context *context, mus__mesh_parts *mesh)
{
    const int64_t n = mesh->count;
    const double *rest = mus_cloth_rest(mesh->cloth);
    mus_status status = MUS_OK;
    mesh->islands = parts_room(context, 2 * (int64_t)mesh->view->vertex_count, sizeof *mesh->islands, &status);
    double *numbers = parts_room(context, 6 * n + 3 * (2 * n + 2), sizeof *numbers, &status);
    int32_t *work = parts_room(context, n, sizeof *work, &status);
    if (status == MUS_OK) {
        double *low = numbers, *at = low + 4 * n;
        const double side = parts_pack(mesh, low, low + 2 * n, at, work, at + 2 * n);
        memset(mesh->islands, 0, 2 * (size_t)mesh->view->vertex_count * sizeof *mesh->islands);
        for (int32_t p = 0; p < mesh->count; p++)
            for (ptrdiff_t i = 0; i < 2 * (ptrdiff_t)mesh->part[p].vertices; i++) {
                const ptrdiff_t v = 2 * (ptrdiff_t)mesh->part[p].first_vertex + i, k = 2 * p + i % 2;
                mesh->islands[v] = (rest[v] - low[k] + at[k]) / side;
            }
    }
    mus_context_alloc(context, numbers, 0);
    mus_context_alloc(context, work, 0);
    return status;
}


static mus_status parts_make(mus_context *context, const mus_mesh_file *file, int32_t i, mus__mesh_parts *mesh)
{
    mus_status status = MUS_OK;
    mesh->view = &file->meshes[i];
    mesh->cloth = file->cloths != NULL ? file->cloths[i] : NULL;
    mesh->material = file->materials != NULL ? file->materials[i] : NULL;
    if (file->keys > 0 && file->motion[i].positions != NULL) mesh->motion = &file->motion[i];
    if (mesh->cloth != NULL) {
        status = parts_panels(context, i, mesh);
        if (status == MUS_OK) status = parts_lines(context, mesh);
        return status == MUS_OK ? parts_islands(context, mesh) : status;
    }
    mesh->part = parts_room(context, 1, sizeof *mesh->part, &status);
    if (status != MUS_OK) return status;
    mesh->count = 1;
    mesh->part[0] = (mus__mesh_part){mesh->view->name, 0, mesh->view->vertex_count, 0, mesh->view->triangle_count};
    return MUS_OK;
}


mus_status mus__mesh_set_make(mus_context *context, const mus_mesh_file *file, mus__mesh_set *set)
{
    mus_status status = MUS_OK;
    *set = (mus__mesh_set){.context = context, .n = file->count, .keys = file->keys, .times = file->times};
    set->mesh = parts_room(context, set->n, sizeof *set->mesh, &status);
    if (status != MUS_OK) return status;
    memset(set->mesh, 0, (size_t)set->n * sizeof *set->mesh);
    for (int32_t i = 0; i < set->n && status == MUS_OK; i++) status = parts_make(context, file, i, &set->mesh[i]);
    return status;
}
