/*
 * polygon.c: area, winding number, distance, convex hull and self-crossing of closed polygons.
 *
 * Points are sorted by a heap sort over indices, without recursion and without the C library's qsort, so that equal
 * input gives equal output on every machine. On which side of a line a point lies is decided by the exact predicate
 * (predicate.h), so that inside, hull and crossing are consistent. The hull is Andrew's monotone chain (1979); the
 * winding number counts upward and downward crossings.
 */
#include <math.h>
#include <string.h>

#include "geom/polygon.h"
#include "base/elementary.h"
#include "geom/predicate.h"
#include "geom/vec.h"

/* the keys of a sort: points by (x, y), or sides of the polygon by their least x */
typedef struct polygon_order {
    int32_t n;
    const double *xy;
    bool sides;
} polygon_order;


static int32_t polygon_next(int32_t n, int32_t i)
{
    return i + 1 < n ? i + 1 : 0;
}


static double polygon_least_x(int32_t n, const double *xy, int32_t i)
{
    return fmin(xy[2 * i], xy[2 * polygon_next(n, i)]);
}


/* Returns whether item i comes before item j; equal keys are ordered by index. */
static bool polygon_before(const polygon_order *order, int32_t i, int32_t j)
{
    const double *xy = order->xy;
    if (order->sides) {
        double a = polygon_least_x(order->n, xy, i), b = polygon_least_x(order->n, xy, j);
        return a != b ? a < b : i < j;
    }
    if (xy[2 * i] != xy[2 * j]) return xy[2 * i] < xy[2 * j];
    if (xy[2 * i + 1] != xy[2 * j + 1]) return xy[2 * i + 1] < xy[2 * j + 1];
    return i < j;
}


static void polygon_sift(const polygon_order *order, int32_t *index, int32_t root, int32_t end)
{
    while (2 * root + 1 < end) {
        int32_t child = 2 * root + 1;
        if (child + 1 < end && polygon_before(order, index[child], index[child + 1])) child++;
        if (!polygon_before(order, index[root], index[child])) return;
        int32_t swap = index[root];
        index[root] = index[child], index[child] = swap;
        root = child;
    }
}


static void polygon_sort(const polygon_order *order, int32_t *index)
{
    for (int32_t i = 0; i < order->n; i++) index[i] = i;
    for (int32_t i = order->n / 2; i-- > 0;) polygon_sift(order, index, i, order->n);
    for (int32_t end = order->n; end-- > 1;) {
        int32_t swap = index[0];
        index[0] = index[end], index[end] = swap;
        polygon_sift(order, index, 0, end);
    }
}


/* Returns the end of the sorted run that begins at `from`. */
static int32_t polygon_run(const polygon_order *order, const int32_t *index, int32_t from)
{
    int32_t end = from + 1;
    while (end < order->n && !polygon_before(order, index[end], index[end - 1])) end++;
    return end;
}


/* Sorts as polygon_sort() does, by merging sorted runs, of which a closed contour has two or three.
 * Scratch: spare (n) */
static void polygon_merge(const polygon_order *order, int32_t *index, int32_t *spare)
{
    const int32_t n = order->n;
    int32_t *from = index, *to = spare;
    for (int32_t i = 0; i < n; i++) index[i] = i;
    for (int32_t i = 0, end; i < n; i = end) { /* falling runs are turned over */
        for (end = i + 1; end < n && polygon_before(order, end, end - 1);) end++;
        for (int32_t j = i; j < end; j++) index[j] = end - 1 - (j - i);
    }
    while (polygon_run(order, from, 0) < n) {
        for (int32_t at = 0; at < n;) {
            const int32_t middle = polygon_run(order, from, at);
            const int32_t end = middle < n ? polygon_run(order, from, middle) : n;
            for (int32_t i = at, j = middle; at < end; at++)
                to[at] = j == end || (i < middle && polygon_before(order, from[i], from[j])) ? from[i++] : from[j++];
        }
        int32_t *swap = from;
        from = to, to = swap;
    }
    if (from != index) memcpy(index, from, (size_t)n * sizeof *index);
}


/* Returns whether p, a point of the line through a and b, lies between them. */
static bool polygon_between(const double *a, const double *b, const double *p)
{
    return fmin(a[0], b[0]) <= p[0] && p[0] <= fmax(a[0], b[0]) && fmin(a[1], b[1]) <= p[1] && p[1] <= fmax(a[1], b[1]);
}


/* Returns whether segments a b and c d have a common point. */
static bool polygon_touch(const double *a, const double *b, const double *c, const double *d)
{
    double c_side = mus__orient2d(a, b, c), d_side = mus__orient2d(a, b, d);
    double a_side = mus__orient2d(c, d, a), b_side = mus__orient2d(c, d, b);
    if (((c_side > 0.0 && d_side < 0.0) || (c_side < 0.0 && d_side > 0.0)) &&
        ((a_side > 0.0 && b_side < 0.0) || (a_side < 0.0 && b_side > 0.0)))
        return true;
    return (c_side == 0.0 && polygon_between(a, b, c)) || (d_side == 0.0 && polygon_between(a, b, d)) ||
           (a_side == 0.0 && polygon_between(c, d, a)) || (b_side == 0.0 && polygon_between(c, d, b));
}


double mus__polygon_area(int32_t n, const double *xy)
{
    /* relative to the first point, so that a distant origin loses no digits */
    double twice = 0.0;
    for (int32_t i = 1; i + 1 < n; i++)
        twice += (xy[2 * i] - xy[0]) * (xy[2 * i + 3] - xy[1]) - (xy[2 * i + 1] - xy[1]) * (xy[2 * i + 2] - xy[0]);
    return 0.5 * twice;
}


double mus__polygon_perimeter(int32_t n, const double *xy)
{
    double sum = 0.0;
    for (int32_t i = 0; i < n; i++) sum += mus__dist2(xy + 2 * i, xy + 2 * polygon_next(n, i));
    return sum;
}


int32_t mus__polygon_winding(int32_t n, const double *xy, const double *p)
{
    int32_t winding = 0;
    for (int32_t i = 0; i < n; i++) {
        const double *a = xy + 2 * i, *b = xy + 2 * polygon_next(n, i);
        if (a[1] <= p[1] && b[1] > p[1] && mus__orient2d(a, b, p) > 0.0) winding++;
        if (a[1] > p[1] && b[1] <= p[1] && mus__orient2d(a, b, p) < 0.0) winding--;
    }
    return winding;
}


double mus__polygon_distance(int32_t n, const double *xy, const double *p)
{
    /* the nearest side by squares; one root */
    double least = INFINITY, x = INFINITY, y = 0.0;
    for (int32_t i = 0; i < n; i++) {
        const double *a = xy + 2 * i, *b = xy + 2 * polygon_next(n, i);
        double ux = b[0] - a[0], uy = b[1] - a[1], vx = p[0] - a[0], vy = p[1] - a[1];
        double square = ux * ux + uy * uy, t = square > 0.0 ? (ux * vx + uy * vy) / square : 0.0;
        t = t < 0.0 ? 0.0 : t > 1.0 ? 1.0 : t;
        const double dx = vx - t * ux, dy = vy - t * uy, own = dx * dx + dy * dy;
        if (own >= least) continue;
        least = own;
        x = dx;
        y = dy;
    }
    return mus__hypot(x, y);
}


int32_t mus__polygon_hull(int32_t n, const double *xy, int32_t *out, int32_t *work)
{
    if (n < 1) return 0;
    polygon_order order = {n, xy, false};
    polygon_merge(&order, work, out);

    /* lower chain from left to right, then upper chain from right to left over the remaining points */
    int32_t count = 0;
    for (int32_t i = 0; i < n; i++) {
        const double *p = xy + 2 * work[i];
        while (count >= 2 && mus__orient2d(xy + 2 * out[count - 2], xy + 2 * out[count - 1], p) <= 0.0) count--;
        if (count == 1 && xy[2 * out[0]] == p[0] && xy[2 * out[0] + 1] == p[1]) continue;
        out[count++] = work[i];
    }
    if (count == 1) return 1;
    int32_t lower = count, used = count - 2;
    for (int32_t i = n - 1; i >= 0; i--) {
        const double *p = xy + 2 * work[i];
        if (used > 0 && work[i] == out[used]) {
            used--;
            continue;
        }
        if (work[i] == out[lower - 1]) continue;
        while (count > lower && mus__orient2d(xy + 2 * out[count - 2], xy + 2 * out[count - 1], p) <= 0.0) count--;
        if (work[i] == out[0]) break;
        if (mus__orient2d(xy + 2 * out[count - 1], p, xy + 2 * out[0]) > 0.0) out[count++] = work[i];
    }
    return count;
}


/* Returns whether the polygon is convex and counter-clockwise, so that it is its own hull: it turns left at every
 * corner, and x changes direction at two corners only. */
static bool polygon_is_convex(int32_t n, const double *xy)
{
    const double *before = xy + 2 * (n - 1), *here = xy;
    double ux = here[0] - before[0], uy = here[1] - before[1];
    int32_t turns = 0;
    bool right = ux > 0.0;
    for (int32_t i = 0; i < n; i++) {
        const double *next = xy + 2 * polygon_next(n, i);
        const double vx = next[0] - here[0], vy = next[1] - here[1];
        if (!(ux * vy - uy * vx > 0.0)) return false;
        if ((vx > 0.0) != right) turns++, right = !right;
        ux = vx, uy = vy, here = next;
    }
    return turns <= 2;
}


double mus__polygon_tape(int32_t n, const double *xy, int32_t *work_a, int32_t *work_b)
{
    if (n >= 3 && polygon_is_convex(n, xy)) return mus__polygon_perimeter(n, xy);
    int32_t count = mus__polygon_hull(n, xy, work_a, work_b);
    double sum = 0.0;
    for (int32_t i = 0; i < count; i++) sum += mus__dist2(xy + 2 * work_a[i], xy + 2 * work_a[polygon_next(count, i)]);
    return sum;
}


bool mus__polygon_crosses(int32_t n, const double *xy, int32_t *i, int32_t *j, int32_t *work)
{
    polygon_order order = {n, xy, true};
    polygon_sort(&order, work);

    /* compare each side with those that start, in x, before it ends */
    for (int32_t s = 0; s < n; s++) {
        int32_t a = work[s], a2 = polygon_next(n, a);
        double right = fmax(xy[2 * a], xy[2 * a2]);
        double low = fmin(xy[2 * a + 1], xy[2 * a2 + 1]), high = fmax(xy[2 * a + 1], xy[2 * a2 + 1]);
        for (int32_t t = s + 1; t < n && polygon_least_x(n, xy, work[t]) <= right; t++) {
            int32_t b = work[t], b2 = polygon_next(n, b);
            if (a2 == b || b2 == a) continue;
            if (fmin(xy[2 * b + 1], xy[2 * b2 + 1]) > high || fmax(xy[2 * b + 1], xy[2 * b2 + 1]) < low) continue;
            if (!polygon_touch(xy + 2 * a, xy + 2 * a2, xy + 2 * b, xy + 2 * b2)) continue;
            *i = a < b ? a : b, *j = a < b ? b : a;
            return true;
        }
    }
    return false;
}
