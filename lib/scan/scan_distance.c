/*
 * scan_distance.c: distances of the mesh from the body that was made of it, and of the body from the mesh.
 *
 * Distances from points to triangles are exact. Triangles are sorted into the cells of a grid; the search for a point
 * goes through the cells round its own, shell by shell, until no nearer triangle can lie further out. The surface of
 * the body is that of the union: triangles and vertices inside another limb are left out. The distance of a vertex of
 * the mesh deep in the body (a mouth, overlapping shells) is its depth there, as contact has it.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/sort.h"
#include "geom/vec.h"
#include "scan/scan_internal.h"

#define DISTANCE_CELL 0.008   /* [m] edge of a cell for a mesh of 1.7 m; chosen: about that of the triangles of a scan
                                 */
#define DISTANCE_CELLS 400.0  /* most cells along a side of the grid: bounds the memory */
/* [m] a vertex of the mesh deeper in the body has its depth as distance; chosen: such a vertex is of an inner
 * surface, not of the skin */
#define DISTANCE_DEEP 0.02
/* [m] a vertex of the body deeper in another limb is not on the surface; chosen: above the error of the depth */
#define DISTANCE_BURIED 0.001

/* triangles sorted into the cells that their boxes overlap */
typedef struct distance_grid {
    const double *x;
    const int32_t *triangle;
    double low[3], cell;
    int32_t size[3];
    int32_t *start, *list;
} distance_grid;


/* distance of point p from the segment a b */
static double distance_segment(const double *p, const double *a, const double *b)
{
    double ab[3], ap[3];
    for (int i = 0; i < 3; i++) ab[i] = b[i] - a[i], ap[i] = p[i] - a[i];
    const double length = mus__dot3(ab, ab), t = length > 0.0 ? fmin(fmax(mus__dot3(ap, ab) / length, 0.0), 1.0) : 0.0;
    for (int i = 0; i < 3; i++) ap[i] -= t * ab[i];
    return mus__norm3(ap);
}


/* distance of point p from a triangle: to its plane where p projects into it, else to the nearest side */
static double distance_triangle(const double *p, const double *a, const double *b, const double *c)
{
    const double *corner[4] = {a, b, c, a};
    double u[3], v[3], n[3], d[3];
    for (int i = 0; i < 3; i++) u[i] = b[i] - a[i], v[i] = c[i] - a[i], d[i] = p[i] - a[i];
    mus__cross3(u, v, n);
    const double area = mus__norm3(n);
    bool over = area > 0.0;
    for (int k = 0; k < 3 && over; k++) {
        double side[3], to[3], turn[3];
        for (int i = 0; i < 3; i++) side[i] = corner[k + 1][i] - corner[k][i], to[i] = p[i] - corner[k][i];
        mus__cross3(side, to, turn);
        over = mus__dot3(turn, n) >= 0.0;
    }
    if (over) return fabs(mus__dot3(d, n)) / area;
    return fmin(distance_segment(p, a, b), fmin(distance_segment(p, b, c), distance_segment(p, c, a)));
}


/* range low (3) to high (3) of the cells that the box of triangle t overlaps */
static void distance_cells(const distance_grid *grid, int32_t t, int32_t *low, int32_t *high)
{
    for (int i = 0; i < 3; i++) {
        double least = INFINITY, most = -INFINITY;
        for (int c = 0; c < 3; c++) {
            const double x = grid->x[3 * (ptrdiff_t)grid->triangle[3 * (ptrdiff_t)t + c] + i];
            least = fmin(least, x), most = fmax(most, x);
        }
        low[i] = (int32_t)((least - grid->low[i]) / grid->cell);
        high[i] = (int32_t)((most - grid->low[i]) / grid->cell);
        if (low[i] < 0) low[i] = 0;
        if (high[i] >= grid->size[i]) high[i] = grid->size[i] - 1;
    }
}


/* sort triangles, but those with skip (triangles), into a grid for a person of height `size` [m] */
static mus_status distance_grid_make(mus_context *context, const double *x, int32_t triangles, const int32_t *triangle,
                                     const bool *skip, double size, distance_grid *out)
{
    double high[3] = {-INFINITY, -INFINITY, -INFINITY};
    *out = (distance_grid){.x = x, .triangle = triangle, .low = {INFINITY, INFINITY, INFINITY}};
    out->cell = DISTANCE_CELL * size / 1.7;
    for (int64_t k = 0; k < 3 * (int64_t)triangles; k++)
        for (int i = 0; i < 3; i++) {
            out->low[i] = fmin(out->low[i], x[3 * (ptrdiff_t)triangle[k] + i]);
            high[i] = fmax(high[i], x[3 * (ptrdiff_t)triangle[k] + i]);
        }
    for (int i = 0; i < 3; i++) out->cell = fmax(out->cell, (high[i] - out->low[i]) / DISTANCE_CELLS);
    for (int i = 0; i < 3; i++) out->size[i] = (int32_t)((high[i] - out->low[i]) / out->cell) + 1;
    const int64_t cells = (int64_t)out->size[0] * out->size[1] * out->size[2];
    out->start = mus__new(context, cells + 2, sizeof *out->start);
    if (out->start == NULL) return mus__fail_memory(context, "the distances of a mesh");

    for (int pass = 0; pass < 2; pass++) {
        for (int32_t t = 0; t < triangles; t++) {
            int32_t from[3], to[3];
            if (skip != NULL && skip[t]) continue;
            distance_cells(out, t, from, to);
            for (int32_t i = from[0]; i <= to[0]; i++)
                for (int32_t j = from[1]; j <= to[1]; j++)
                    for (int32_t k = from[2]; k <= to[2]; k++) {
                        const int64_t cell = ((int64_t)i * out->size[1] + j) * out->size[2] + k;
                        if (pass == 0)
                            out->start[cell + 2]++;
                        else
                            out->list[out->start[cell + 1]++] = t;
                    }
        }
        if (pass == 1) break;
        for (int64_t c = 1; c <= cells; c++) out->start[c + 1] += out->start[c];
        out->list = mus__new(context, out->start[cells + 1], sizeof *out->list);
        if (out->list == NULL) return mus__fail_memory(context, "the distances of a mesh");
    }
    return MUS_OK;
}


static void distance_grid_free(mus_context *context, distance_grid *grid)
{
    mus__free(context, grid->start);
    mus__free(context, grid->list);
}


/* the smaller of `best` and the distance of p from the triangles of a cell */
static double distance_cell(const distance_grid *grid, const double *p, const int32_t *at, double best)
{
    const int64_t cell = ((int64_t)at[0] * grid->size[1] + at[1]) * grid->size[2] + at[2];
    for (int32_t n = grid->start[cell]; n < grid->start[cell + 1]; n++) {
        const int32_t *v = grid->triangle + 3 * (ptrdiff_t)grid->list[n];
        best = fmin(best, distance_triangle(p, grid->x + 3 * (ptrdiff_t)v[0], grid->x + 3 * (ptrdiff_t)v[1],
                                            grid->x + 3 * (ptrdiff_t)v[2]));
    }
    return best;
}


/* distance of point p from the grid's triangles. Triangles in shell r are at least r - 1 cells plus the distance of p
 * from the side of its own cell away */
static double distance_point(const distance_grid *grid, const double *p)
{
    int32_t own[3], most = 0;
    double best = INFINITY, out = grid->cell;
    for (int i = 0; i < 3; i++) {
        const double u = (p[i] - grid->low[i]) / grid->cell;
        own[i] = (int32_t)fmin(fmax(floor(u), 0.0), grid->size[i] - 1.0);
        out = fmax(fmin(out, grid->cell * fmin(u - own[i], own[i] + 1.0 - u)), 0.0);
        most = most > grid->size[i] ? most : grid->size[i];
    }
    for (int32_t r = 0; r <= most && (r == 0 || best > (r - 1) * grid->cell + out); r++)
        for (int32_t i = own[0] - r; i <= own[0] + r; i++)
            for (int32_t j = own[1] - r; j <= own[1] + r; j++) {
                const bool side = abs(i - own[0]) == r || abs(j - own[1]) == r;
                for (int32_t k = own[2] - r; k <= own[2] + r; k += side || r == 0 ? 1 : 2 * r) {
                    const int32_t at[3] = {i, j, k};
                    if (i < 0 || j < 0 || k < 0 || i >= grid->size[0] || j >= grid->size[1] || k >= grid->size[2])
                        continue;
                    best = distance_cell(grid, p, at, best);
                }
            }
    return best;
}


/* the part of a person (MUS_SCAN_TORSO ...) that a point belongs to */
static int32_t distance_part(const mus__scan_found *found, const double *x)
{
    for (int i = 0; i < 2; i++) {
        const mus__scan_arm *arm = &found->arm[i];
        if (!arm->there || arm->side * (x[0] - found->middle) < 0.0) continue;
        double d[3], s, square;
        for (int k = 0; k < 3; k++) d[k] = x[k] - arm->origin[k];
        s = mus__dot3(d, arm->axis), square = mus__dot3(d, d) - s * s;
        const double reach = 0.15 * found->stature;
        if (mus__dot3(arm->wall, x) < arm->wall[3] || square > reach * reach || s < arm->root - reach) continue;
        if (s < arm->root && x[1] < arm->armpit[1]) continue;
        return s > arm->wrist ? MUS_SCAN_HANDS : MUS_SCAN_ARMS;
    }
    if (found->legs && x[1] < found->foot) return MUS_SCAN_FEET;
    if (found->legs && x[1] < found->crotch) return MUS_SCAN_LEGS;
    return found->legs && x[1] > found->neck ? MUS_SCAN_HEAD : MUS_SCAN_TORSO;
}


static int distance_order(const void *a, const void *b)
{
    const double p = *(const double *)a, q = *(const double *)b;
    return p < q ? -1 : p > q;
}


/* median, 95th percentile and maximum of the distances of n points x, by part; without those of skip (n), or NULL.
 * distance (n) holds depths in the body, which are kept where they exceed DISTANCE_DEEP. Scratch: work (n) */
static void distance_tell(const distance_grid *grid, int32_t n, const double *x, const bool *skip, const int32_t *part,
                          double *distance, double *work, double (*out)[3])
{
    for (int32_t v = 0; v < n; v++)
        if ((skip == NULL || !skip[v]) && !(distance[v] > DISTANCE_DEEP))
            distance[v] = distance_point(grid, x + 3 * (ptrdiff_t)v);
    for (int32_t p = 0; p < MUS_SCAN_PART_COUNT; p++) {
        int32_t count = 0;
        for (int32_t v = 0; v < n; v++)
            if (part[v] == p && (skip == NULL || !skip[v])) work[count++] = distance[v];
        if (count == 0) continue;
        mus__sort(work, (size_t)count, sizeof *work, distance_order);
        out[p][0] = work[(count - 1) / 2];
        out[p][1] = work[(int32_t)(0.95 * (count - 1))];
        out[p][2] = work[count - 1];
    }
}


/* mark vertices and triangles of the body that lie inside another limb. Scratch: depth (vertices) */
static mus_status distance_buried(const mus_body *body, double *depth, bool *vertex, bool *triangle)
{
    const int32_t n = mus_body_vertex_count(body), *v = mus_body_triangles(body);
    mus_status status = mus_body_depth(body, n, mus_body_vertices(body), depth, NULL);
    for (int32_t i = 0; i < n; i++) vertex[i] = depth[i] > DISTANCE_BURIED;
    for (int32_t t = 0; t < mus_body_triangle_count(body); t++, v += 3)
        triangle[t] = vertex[v[0]] && vertex[v[1]] && vertex[v[2]];
    return status;
}


mus_status mus__scan_distances(const mus__scan_mesh *mesh, const mus_body *body, const mus__scan_found *found,
                               mus_scan_report *report)
{
    mus_context *context = mesh->context;
    const int32_t n = mus_body_vertex_count(body), nt = mus_body_triangle_count(body), m = mesh->vertices;
    const int32_t most = n > m ? n : m;
    const double *x = mus_body_vertices(body);
    distance_grid of_body = {0}, of_mesh = {0};
    double *work = mus__new(context, 2 * (int64_t)most, sizeof *work);
    int32_t *part = mus__new(context, most, sizeof *part);
    bool *buried = mus__new(context, (int64_t)n + nt, sizeof *buried);
    mus_status status = MUS_OK;
    if (work == NULL || part == NULL || buried == NULL) {
        status = mus__fail_memory(context, "the distances of a mesh");
        goto end;
    }
    status = distance_buried(body, work, buried, buried + n);
    if (status == MUS_OK)
        status = distance_grid_make(context, x, nt, mus_body_triangles(body), buried + n, found->stature, &of_body);
    if (status == MUS_OK)
        status = distance_grid_make(context, mesh->x, mesh->triangles, mesh->triangle, NULL, found->stature, &of_mesh);
    if (status != MUS_OK) goto end;
    status = mus_body_depth(body, m, mesh->x, work, NULL);
    if (status != MUS_OK) goto end;
    for (int32_t v = 0; v < m; v++) part[v] = distance_part(found, mesh->x + 3 * (ptrdiff_t)v);
    distance_tell(&of_body, m, mesh->x, NULL, part, work, work + most, report->mesh_to_body);
    for (int32_t v = 0; v < n; v++) part[v] = distance_part(found, x + 3 * (ptrdiff_t)v), work[v] = 0.0;
    distance_tell(&of_mesh, n, x, buried, part, work, work + most, report->body_to_mesh);

end:
    distance_grid_free(context, &of_body);
    distance_grid_free(context, &of_mesh);
    mus__free(context, work);
    mus__free(context, part);
    mus__free(context, buried);
    return status;
}
