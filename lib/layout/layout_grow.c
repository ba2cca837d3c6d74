/*
 * layout_grow.c: an outline grown by half the gap, with fewer points, and its halves.
 *
 * The search keeps grown outlines from sharing a point, so cut lines are a gap apart. A grown outline is simplified: it
 * is first grown by a little more, the tolerance, and then points are left out whose chord stays within the tolerance.
 * So it holds all that is nearer to the cut line than half the gap.
 * Source: Douglas and Peucker, Algorithms for the reduction of the number of points, 1973.
 */
#include <math.h>
#include <string.h>

#include "geom/polygon.h"
#include "layout/layout_internal.h"
#include "pattern/polygon_offset.h"


void mus__layout_polygon_free(mus_context *context, mus__layout_polygon *polygon)
{
    mus__free(context, polygon->xy);
    polygon->xy = NULL;
    polygon->n = 0;
}


mus_status mus__layout_polygon_make(mus_context *context, int32_t n, mus__layout_polygon *polygon)
{
    mus__layout_polygon_free(context, polygon);
    polygon->xy = mus__new(context, n, 2 * sizeof *polygon->xy);
    if (polygon->xy == NULL) return mus__fail_memory(context, "an outline of a layout");
    polygon->n = n;
    return MUS_OK;
}


/* square of the distance of p to the segment a, b */
static double grow_distance(const double *p, const double *a, const double *b)
{
    const double d[2] = {b[0] - a[0], b[1] - a[1]}, e[2] = {p[0] - a[0], p[1] - a[1]};
    const double square = d[0] * d[0] + d[1] * d[1];
    double t = square > 0.0 ? (e[0] * d[0] + e[1] * d[1]) / square : 0.0;
    t = t < 0.0 ? 0.0 : t > 1.0 ? 1.0 : t;
    const double x = e[0] - t * d[0], y = e[1] - t * d[1];
    return x * x + y * y;
}


/* mark the points of a closed polygon that stay: those at 0 and `far`, and between two that stay the farthest one while
 * it is beyond the tolerance. stack (n x 2) */
static void grow_mark(const mus__layout_polygon *from, int32_t far, unsigned char *stays, int32_t *stack)
{
    int32_t depth = 0;
    stays[0] = stays[far] = 1;
    stack[depth++] = 0, stack[depth++] = far;
    stack[depth++] = far, stack[depth++] = from->n;
    while (depth > 0) {
        const int32_t last = stack[--depth], first = stack[--depth];
        const double *a = from->xy + 2 * first, *b = from->xy + 2 * (last < from->n ? last : 0);
        double most = MUS__LAYOUT_TOLERANCE * MUS__LAYOUT_TOLERANCE;
        int32_t top = MUS_NONE;
        for (int32_t i = first + 1; i < last; i++) {
            const double d = grow_distance(from->xy + 2 * i, a, b);
            if (d > most) most = d, top = i;
        }
        if (top == MUS_NONE) continue;
        stays[top] = 1;
        stack[depth++] = first, stack[depth++] = top;
        stack[depth++] = top, stack[depth++] = last;
    }
}


/* leave points out of a polygon, unless its sides would cross then */
static mus_status grow_simplify(mus_context *context, mus__layout_polygon *polygon)
{
    mus__layout_polygon less = {0, NULL};
    unsigned char *stays = mus__new(context, polygon->n, 1);
    int32_t *stack = mus__new(context, polygon->n, 4 * sizeof *stack), i, j;
    mus_status status = mus__layout_polygon_make(context, polygon->n, &less);
    if (status == MUS_OK && (stays == NULL || stack == NULL))
        status = mus__fail_memory(context, "an outline of a layout");
    if (status == MUS_OK) {
        int32_t far = 1, n = 0;
        double most = 0.0;
        for (int32_t k = 1; k < polygon->n; k++) {
            const double x = polygon->xy[2 * k] - polygon->xy[0], y = polygon->xy[2 * k + 1] - polygon->xy[1];
            if (x * x + y * y > most) most = x * x + y * y, far = k;
        }
        grow_mark(polygon, far, stays, stack);
        for (int32_t k = 0; k < polygon->n; k++)
            if (stays[k]) memcpy(less.xy + 2 * (ptrdiff_t)n++, polygon->xy + 2 * (ptrdiff_t)k, 2 * sizeof *less.xy);
        less.n = n;
        if (n >= 3 && !mus__polygon_crosses(n, less.xy, &i, &j, stack)) {
            const mus__layout_polygon held = *polygon;
            *polygon = less;
            less = held;
        }
    }
    mus__free(context, stays);
    mus__free(context, stack);
    mus__layout_polygon_free(context, &less);
    return status;
}


/* make the part of a polygon with y at or above `low` */
static mus_status grow_clip(mus_context *context, const mus__layout_polygon *from, double low, mus__layout_polygon *out)
{
    const mus_status status = mus__layout_polygon_make(context, 2 * from->n, out);
    if (status != MUS_OK) return status;
    int32_t n = 0;
    for (int32_t i = 0; i < from->n; i++) {
        const double *a = from->xy + 2 * i, *b = from->xy + 2 * (i + 1 < from->n ? i + 1 : 0);
        if (a[1] >= low) {
            memcpy(out->xy + 2 * (ptrdiff_t)n, a, 2 * sizeof *a);
            n++;
        }
        if ((a[1] >= low) == (b[1] >= low)) continue;
        out->xy[2 * n] = a[0] + (b[0] - a[0]) * (low - a[1]) / (b[1] - a[1]);
        out->xy[2 * n + 1] = low;
        n++;
    }
    out->n = n;
    return MUS_OK;
}


mus_status mus__layout_outline_grow(const mus_layout *layout, mus__layout_outline *outline)
{
    mus_context *context = layout->context;
    const mus__layout_polygon *cut = &outline->cut;
    mus__layout_polygon *grown = &outline->grown;
    mus_status status = MUS_OK;
    if (layout->margin > 0.0) {
        mus__cut_loops loops;
        double *width = mus__new(context, cut->n, sizeof *width);
        memset(&loops, 0, sizeof loops);
        if (width == NULL) return mus__fail_memory(context, "an outline of a layout");
        for (int32_t i = 0; i < cut->n; i++) width[i] = layout->margin;
        status = mus__offset(context, cut->n, cut->xy, width, NULL, &loops);
        const int32_t n = status == MUS_OK ? (loops.nloop > 1 ? loops.start[1] : loops.n) : 0;
        if (status == MUS_OK) status = mus__layout_polygon_make(context, n, grown);
        if (status == MUS_OK) memcpy(grown->xy, loops.xy, 2 * (size_t)n * sizeof *grown->xy);
        mus__cut_loops_free(context, &loops);
        mus__free(context, width);
        if (status == MUS_OK) status = grow_simplify(context, grown);
    } else {
        status = mus__layout_polygon_make(context, cut->n, grown);
        if (status == MUS_OK) memcpy(grown->xy, cut->xy, 2 * (size_t)cut->n * sizeof *grown->xy);
    }
    if (status == MUS_OK && outline->symmetric) status = grow_clip(context, cut, 0.0, &outline->half);
    if (status == MUS_OK && outline->symmetric)
        status = grow_clip(context, grown, -layout->margin, &outline->grown_half);
    return status;
}
