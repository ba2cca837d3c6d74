/*
 * barycentric_transfer.c: for each node of one cut, its triangle and barycentric weights in another cut of the same
 * pattern.
 *
 * Points are located in the flat by buckets: squares of the source's spacing, each with the triangles whose box touches
 * it. A point asks its own bucket, then rings of buckets round it, until a triangle holds it or the nearest triangle is
 * nearer than the next ring. Cost: about ten triangles a node.
 */
#include <math.h>
#include <string.h>

#include "drape/barycentric_transfer.h"

#define HOLDS 1e-9           /* [m] a point this near to a triangle counts as inside */
#define BUCKETS_MOST 4194304 /* of a panel: bounds the memory at 16 MB; larger panels get larger buckets */

typedef struct bucket_grid {
    double low[2], size;
    int32_t columns, rows;
    int32_t *start; /* (columns x rows + 1) */
    int32_t *item;  /* triangles of the panel */
} bucket_grid;

typedef struct panel_box {
    double low[2], high[2];
} panel_box;


static panel_box box_of(const mus_cloth *cloth, const mus__panel_mesh *panel)
{
    panel_box box = {{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
    for (int32_t i = panel->first_node; i < panel->first_node + panel->node_count; i++)
        for (int32_t d = 0; d < 2; d++) {
            box.low[d] = fmin(box.low[d], cloth->rest[2 * (int64_t)i + d]);
            box.high[d] = fmax(box.high[d], cloth->rest[2 * (int64_t)i + d]);
        }
    return box;
}


static int32_t bucket_at(const bucket_grid *grid, int32_t d, double x)
{
    const int32_t last = (d ? grid->rows : grid->columns) - 1;
    const double at = floor((x - grid->low[d]) / grid->size);
    return at <= 0.0 ? 0 : at >= last ? last : (int32_t)at;
}


/* the buckets that triangle t touches: range (4) first column, last column, first row, last row */
static void bucket_range(const mus_cloth *cloth, const bucket_grid *grid, int32_t t, int32_t *range)
{
    const int32_t *corner = cloth->triangle + 3 * (int64_t)t;
    for (int32_t d = 0; d < 2; d++) {
        const double a = cloth->rest[2 * (int64_t)corner[0] + d], b = cloth->rest[2 * (int64_t)corner[1] + d];
        const double c = cloth->rest[2 * (int64_t)corner[2] + d];
        range[2 * d] = bucket_at(grid, d, fmin(a, fmin(b, c)));
        range[2 * d + 1] = bucket_at(grid, d, fmax(a, fmax(b, c)));
    }
}


static void buckets_clear(mus_context *context, bucket_grid *grid)
{
    mus__free(context, grid->start);
    mus__free(context, grid->item);
}


static mus_status buckets_build(mus_context *context, const mus_cloth *cloth, const mus__panel_mesh *panel,
                                bucket_grid *grid)
{
    const panel_box box = box_of(cloth, panel);
    memset(grid, 0, sizeof *grid);
    grid->size = cloth->spacing;
    for (int32_t d = 0; d < 2; d++) grid->low[d] = box.low[d];
    while ((box.high[0] - box.low[0]) / grid->size * ((box.high[1] - box.low[1]) / grid->size) > BUCKETS_MOST)
        grid->size *= 2.0;
    grid->columns = 1 + (int32_t)((box.high[0] - box.low[0]) / grid->size);
    grid->rows = 1 + (int32_t)((box.high[1] - box.low[1]) / grid->size);

    /* count, sum, fill */
    const int64_t buckets = (int64_t)grid->columns * grid->rows;
    grid->start = mus__new(context, buckets + 1, sizeof *grid->start);
    if (grid->start == NULL) return mus__fail_memory(context, "the buckets of a transfer");
    const int32_t first = panel->first_triangle, last = first + panel->triangle_count;
    for (int32_t pass = 0; pass < 2; pass++) {
        for (int32_t t = first; t < last; t++) {
            int32_t range[4];
            bucket_range(cloth, grid, t, range);
            for (int32_t r = range[2]; r <= range[3]; r++)
                for (int32_t c = range[0]; c <= range[1]; c++) {
                    int32_t *at = &grid->start[(int64_t)r * grid->columns + c];
                    if (pass == 0)
                        at[1]++;
                    else
                        grid->item[(*at)++] = t;
                }
        }
        if (pass == 1) break;
        for (int64_t b = 0; b < buckets; b++) grid->start[b + 1] += grid->start[b];
        grid->item = mus__new(context, grid->start[buckets], sizeof *grid->item);
        if (grid->item == NULL) return mus__fail_memory(context, "the buckets of a transfer");
    }
    memmove(grid->start + 1, grid->start, (size_t)buckets * sizeof *grid->start);
    grid->start[0] = 0;
    return MUS_OK;
}


/* nearest point of the segment a b to p, as weight of b; returns the squared distance */
static double to_segment(const double *a, const double *b, const double *p, double *weight)
{
    const double u[2] = {b[0] - a[0], b[1] - a[1]}, w[2] = {p[0] - a[0], p[1] - a[1]};
    const double uu = u[0] * u[0] + u[1] * u[1];
    const double along = uu > 0.0 ? fmin(fmax((u[0] * w[0] + u[1] * w[1]) / uu, 0.0), 1.0) : 0.0;
    const double d[2] = {w[0] - along * u[0], w[1] - along * u[1]};
    *weight = along;
    return d[0] * d[0] + d[1] * d[1];
}


/* weights (3) of the point of triangle t nearest to p; returns the squared distance */
static double to_triangle(const mus_cloth *cloth, int32_t t, const double *p, double *weight)
{
    const double *x[3];
    for (int32_t k = 0; k < 3; k++) x[k] = cloth->rest + 2 * (int64_t)cloth->triangle[3 * (int64_t)t + k];
    double area[3], sum = 0.0;
    for (int32_t k = 0; k < 3; k++) {
        const double *a = x[(k + 1) % 3], *b = x[(k + 2) % 3];
        area[k] = (a[0] - p[0]) * (b[1] - p[1]) - (a[1] - p[1]) * (b[0] - p[0]);
        sum += area[k];
    }
    if (sum != 0.0 && area[0] / sum >= 0.0 && area[1] / sum >= 0.0 && area[2] / sum >= 0.0) {
        for (int32_t k = 0; k < 3; k++) weight[k] = area[k] / sum;
        return 0.0;
    }
    double best = INFINITY;
    for (int32_t k = 0; k < 3; k++) {
        double along;
        const double distance = to_segment(x[k], x[(k + 1) % 3], p, &along);
        if (distance >= best) continue;
        best = distance;
        weight[k] = 1.0 - along, weight[(k + 1) % 3] = along, weight[(k + 2) % 3] = 0.0;
    }
    return best;
}


/* the triangle that holds p, or the nearest: its nodes and weights */
static void locate(const mus_cloth *cloth, const bucket_grid *grid, const double *p, int32_t *node, float *weight)
{
    const int32_t column = bucket_at(grid, 0, p[0]), row = bucket_at(grid, 1, p[1]);
    const int32_t reach = grid->columns > grid->rows ? grid->columns : grid->rows;
    double best = INFINITY;
    for (int32_t ring = 0; ring <= reach && best > HOLDS * HOLDS; ring++) {
        for (int32_t r = row - ring; r <= row + ring; r++) {
            if (r < 0 || r >= grid->rows) continue;
            const int32_t step = r == row - ring || r == row + ring || ring == 0 ? 1 : 2 * ring;
            for (int32_t c = column - ring; c <= column + ring; c += step) {
                if (c < 0 || c >= grid->columns) continue;
                const int64_t b = (int64_t)r * grid->columns + c;
                for (int32_t k = grid->start[b]; k < grid->start[b + 1]; k++) {
                    double w[3];
                    const double distance = to_triangle(cloth, grid->item[k], p, w);
                    if (distance >= best) continue;
                    best = distance;
                    for (int32_t i = 0; i < 3; i++) {
                        node[i] = cloth->triangle[3 * (int64_t)grid->item[k] + i];
                        weight[i] = (float)w[i];
                    }
                    if (best <= 0.0) return;
                }
            }
        }
        /* no triangle of a farther ring is nearer than the ring is wide */
        const double clear = ring * grid->size;
        if (best <= clear * clear) break;
    }
}


static mus_status transfer_panel(mus_context *context, const mus_cloth *from, const mus_cloth *to, int32_t p,
                                 mus__transfer *out)
{
    const mus__panel_mesh *panel = &to->panel[p];
    const panel_box old = box_of(from, &from->panel[p]), new = box_of(to, panel);
    bucket_grid grid;
    const mus_status status = buckets_build(context, from, &from->panel[p], &grid);
    for (int32_t i = panel->first_node; status == MUS_OK && i < panel->first_node + panel->node_count; i++) {
        double place[2];
        for (int32_t d = 0; d < 2; d++) {
            const double wide = new.high[d] - new.low[d], share = (to->rest[2 * (int64_t)i + d] - new.low[d]);
            place[d] = old.low[d] + (wide > 0.0 ? share / wide * (old.high[d] - old.low[d]) : share);
        }
        locate(from, &grid, place, out->node + 3 * (int64_t)i, out->weight + 3 * (int64_t)i);
    }
    buckets_clear(context, &grid);
    return status;
}


mus_status mus__transfer_build(mus_context *context, const mus_cloth *from, const mus_cloth *to, mus__transfer *out)
{
    memset(out, 0, sizeof *out);
    out->n = to->nnode;
    out->node = mus__new(context, 3 * (int64_t)to->nnode, sizeof *out->node);
    out->weight = mus__new(context, 3 * (int64_t)to->nnode, sizeof *out->weight);
    if (out->node == NULL || out->weight == NULL) return mus__fail_memory(context, "a transfer between cloths");
    mus_status status = MUS_OK;
    for (int32_t p = 0; p < to->npanel && status == MUS_OK; p++) status = transfer_panel(context, from, to, p, out);
    return status;
}


void mus__transfer_clear(mus_context *context, mus__transfer *transfer)
{
    mus__free(context, transfer->node);
    mus__free(context, transfer->weight);
    memset(transfer, 0, sizeof *transfer);
}


void mus__transfer_apply(const mus__transfer *transfer, const double *from, double *to)
{
    for (int32_t i = 0; i < transfer->n; i++) {
        const int32_t *node = transfer->node + 3 * (int64_t)i;
        const float *weight = transfer->weight + 3 * (int64_t)i;
        double x[3] = {0.0, 0.0, 0.0};
        for (int32_t k = 0; k < 3; k++)
            for (int32_t d = 0; d < 3; d++) x[d] += (double)weight[k] * from[3 * (int64_t)node[k] + d];
        memcpy(to + 3 * (int64_t)i, x, sizeof x);
    }
}


int32_t mus__transfer_nearest(const mus__transfer *transfer, int32_t i)
{
    const float *weight = transfer->weight + 3 * (int64_t)i;
    int32_t k = 0;
    if (weight[1] > weight[k]) k = 1;
    if (weight[2] > weight[k]) k = 2;
    return transfer->node[3 * (int64_t)i + k];
}
