/*
 * scan_mesh.c: checks and welds the caller's triangles for the sections.
 *
 * Files repeat vertices (at seams of textures, or for every triangle), so vertices whose places agree to 1e-7 of the
 * mesh's size become one. Triangles that lose a corner by that, and repeated triangles, are left out. Edges are
 * numbered, so that a section can go from triangle to triangle over the edge that it crosses. The orientation of
 * triangles is not used.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/sort.h"
#include "scan/scan_internal.h"

#define WELD_TRIANGLES 16000000 /* most triangles: bounds the memory */
/* step of the grid on which equal places are one, in parts of the mesh's size; chosen: above the rounding of files
 * in float */
#define WELD_NEAR 1e-7
/* largest coordinate, in any unit; chosen: squares of it stay finite and keep their digits */
#define WELD_LARGEST 1e9

/* a vertex in that grid, for sorting */
typedef struct weld_key {
    int64_t at[3];
    int32_t index;
} weld_key;


static int weld_order(const void *a, const void *b)
{
    const weld_key *p = a, *q = b;
    for (int i = 0; i < 3; i++)
        if (p->at[i] != q->at[i]) return p->at[i] < q->at[i] ? -1 : 1;
    return p->index < q->index ? -1 : p->index > q->index;
}


/* check the caller's arrays. Errors: MUS_ERR_ARG, MUS_ERR_LIMIT */
static mus_status weld_check(mus_context *context, int32_t nv, const double *x, int32_t nt, const int32_t *triangle)
{
    if (nv < 4 || nt < 4 || x == NULL || triangle == NULL)
        return mus__fail(context, MUS_ERR_ARG, "mesh: %d vertices and %d triangles, expected 4 or more of each",
                         (int)nv, (int)nt);
    if (nt > WELD_TRIANGLES)
        return mus__fail(context, MUS_ERR_LIMIT, "mesh: %d triangles, expected at most %d", (int)nt, WELD_TRIANGLES);
    for (int64_t i = 0; i < 3 * (int64_t)nv; i++)
        if (!(fabs(x[i]) <= WELD_LARGEST))
            return mus__fail(context, MUS_ERR_ARG, "mesh: vertex %d has the coordinate %g, expected a number up to %g",
                             (int)(i / 3), x[i], WELD_LARGEST);
    for (int64_t i = 0; i < 3 * (int64_t)nt; i++)
        if (triangle[i] < 0 || triangle[i] >= nv)
            return mus__fail(context, MUS_ERR_ARG, "mesh: triangle %d has vertex %d of %d", (int)(i / 3),
                             (int)triangle[i], (int)nv);
    return MUS_OK;
}


/* merge equal vertices into out->x; names (nv) gets the new index of each */
static mus_status weld_vertices(mus_context *context, int32_t nv, const double *x, int32_t *names,
                                     mus__scan_mesh *out)
{
    double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY}, size = 0.0;
    for (int32_t v = 0; v < nv; v++)
        for (int i = 0; i < 3; i++) {
            low[i] = fmin(low[i], x[3 * (ptrdiff_t)v + i]);
            high[i] = fmax(high[i], x[3 * (ptrdiff_t)v + i]);
        }
    for (int i = 0; i < 3; i++) size = fmax(size, high[i] - low[i]);
    if (!(size > 0.0)) return mus__fail(context, MUS_ERR_BODY, "mesh: all vertices are at one place");

    weld_key *key = mus__new(context, nv, sizeof *key);
    if (key == NULL) return mus__fail_memory(context, "the vertices of a mesh");
    for (int32_t v = 0; v < nv; v++) {
        key[v].index = v;
        for (int i = 0; i < 3; i++)
            key[v].at[i] = (int64_t)floor((x[3 * (ptrdiff_t)v + i] - low[i]) / (WELD_NEAR * size) + 0.5);
    }
    mus__sort(key, (size_t)nv, sizeof *key, weld_order);
    for (int32_t k = 0; k < nv; k++) {
        const bool same = k > 0 && memcmp(key[k].at, key[k - 1].at, sizeof key[k].at) == 0;
        if (!same) memcpy(out->x + 3 * (ptrdiff_t)out->vertices++, x + 3 * (ptrdiff_t)key[k].index, 3 * sizeof *x);
        names[key[k].index] = out->vertices - 1;
    }
    mus__free(context, key);
    return MUS_OK;
}


/* number the edges of all triangles, by lists of the edges of each lower vertex */
static mus_status weld_edges(mus__scan_mesh *mesh)
{
    const int64_t most = 3 * (int64_t)mesh->triangles;
    int32_t *head = mus__new(mesh->context, mesh->vertices, sizeof *head);
    int32_t *next = mus__new(mesh->context, most, sizeof *next);
    int32_t *upper = mus__new(mesh->context, most, sizeof *upper);
    mus_status status = MUS_OK;
    if (head == NULL || next == NULL || upper == NULL) {
        status = mus__fail_memory(mesh->context, "the edges of a mesh");
    } else {
        for (int32_t v = 0; v < mesh->vertices; v++) head[v] = -1;
        for (int64_t i = 0; i < most; i++) {
            const int32_t *t = mesh->triangle + 3 * (i / 3), p = t[i % 3], q = t[(i + 1) % 3];
            const int32_t low = p < q ? p : q, high = p < q ? q : p;
            int32_t e = head[low];
            while (e >= 0 && upper[e] != high) e = next[e];
            if (e < 0) {
                e = mesh->edges++;
                upper[e] = high, next[e] = head[low], head[low] = e;
            }
            mesh->edge[i] = e;
        }
    }
    mus__free(mesh->context, head);
    mus__free(mesh->context, next);
    mus__free(mesh->context, upper);
    return status;
}


/* sort three edges */
static void weld_sorted(const int32_t *edge, int32_t *out)
{
    memcpy(out, edge, 3 * sizeof *out);
    for (int i = 0; i < 3; i++) {
        const int a = i % 2, b = a + 1;
        const int32_t low = out[a] < out[b] ? out[a] : out[b], high = out[a] < out[b] ? out[b] : out[a];
        out[a] = low, out[b] = high;
    }
}


/* keep the first of all triangles with the same edges, by lists of the triangles of each lowest edge */
static mus_status weld_drop_doubles(mus__scan_mesh *mesh)
{
    int32_t *head = mus__new(mesh->context, mesh->edges, sizeof *head);
    int32_t *next = mus__new(mesh->context, mesh->triangles, sizeof *next);
    int32_t kept = 0;
    if (head == NULL || next == NULL) {
        mus__free(mesh->context, head);
        mus__free(mesh->context, next);
        return mus__fail_memory(mesh->context, "the triangles of a mesh");
    }
    for (int32_t e = 0; e < mesh->edges; e++) head[e] = -1;
    for (int32_t t = 0; t < mesh->triangles; t++) {
        int32_t own[3], other[3];
        weld_sorted(mesh->edge + 3 * (ptrdiff_t)t, own);
        int32_t o = head[own[0]];
        for (; o >= 0; o = next[o]) {
            weld_sorted(mesh->edge + 3 * (ptrdiff_t)o, other);
            if (memcmp(own, other, sizeof own) == 0) break;
        }
        if (o >= 0) continue;
        memmove(mesh->edge + 3 * (ptrdiff_t)kept, mesh->edge + 3 * (ptrdiff_t)t, 3 * sizeof *mesh->edge);
        memmove(mesh->triangle + 3 * (ptrdiff_t)kept, mesh->triangle + 3 * (ptrdiff_t)t, 3 * sizeof *mesh->triangle);
        next[kept] = head[own[0]], head[own[0]] = kept++;
    }
    mesh->triangles = kept;
    mus__free(mesh->context, head);
    mus__free(mesh->context, next);
    return MUS_OK;
}


/* vertices, triangles and edges of the welded mesh */
static mus_status weld_fill(int32_t nv, const double *x, int32_t nt, const int32_t *triangle, mus__scan_mesh *out)
{
    int32_t *names = mus__new(out->context, nv, sizeof *names);
    out->x = mus__new(out->context, 3 * (int64_t)nv, sizeof *out->x);
    out->triangle = mus__new(out->context, 3 * (int64_t)nt, sizeof *out->triangle);
    out->edge = mus__new(out->context, 3 * (int64_t)nt, sizeof *out->edge);
    mus_status status = names != NULL && out->x != NULL && out->triangle != NULL && out->edge != NULL
                            ? weld_vertices(out->context, nv, x, names, out)
                            : mus__fail_memory(out->context, "a mesh");
    for (int32_t t = 0; t < nt && status == MUS_OK; t++) {
        const int32_t *from = triangle + 3 * (ptrdiff_t)t;
        const int32_t p = names[from[0]], q = names[from[1]], r = names[from[2]];
        if (p == q || q == r || r == p) continue;
        int32_t *to = out->triangle + 3 * (ptrdiff_t)out->triangles++;
        to[0] = p, to[1] = q, to[2] = r;
    }
    mus__free(out->context, names);
    if (status == MUS_OK && out->triangles < 4)
        status = mus__fail(out->context, MUS_ERR_BODY, "mesh: only %d of %d triangles have an area, expected 4 or more",
                           (int)out->triangles, (int)nt);
    if (status == MUS_OK) status = weld_edges(out);
    return status == MUS_OK ? weld_drop_doubles(out) : status;
}


mus_status mus__scan_weld(mus_context *context, int32_t nv, const double *x, int32_t nt, const int32_t *triangle,
                          mus__scan_mesh *out)
{
    memset(out, 0, sizeof *out);
    out->context = context;
    mus_status status = weld_check(context, nv, x, nt, triangle);
    if (status == MUS_OK) status = weld_fill(nv, x, nt, triangle, out);
    if (status != MUS_OK) mus__scan_mesh_free(out);
    return status;
}


void mus__scan_mesh_free(mus__scan_mesh *mesh)
{
    mus__free(mesh->context, mesh->x);
    mus__free(mesh->context, mesh->triangle);
    mus__free(mesh->context, mesh->edge);
    mus_context *context = mesh->context;
    memset(mesh, 0, sizeof *mesh);
    mesh->context = context;
}
