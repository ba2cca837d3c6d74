/*
 * nest_pair.c: whether two shapes overlap, and how much.
 */
#include <math.h>

#include "geom/predicate.h"
#include "nest/nest_shape.h"

#define PAIR_EPSILON 0.01 /* of the larger diameter: the depth below which overlap decays; Gardeyn and others, 2025 */
#define PAIR_MANY 300.0   /* pairs of sides above which circles are looked at first; chosen: changes the time alone */
#define PAIR_CIRCLES 4    /* of each shape; chosen: changes the time alone */
#define PAIR_SURE 0.999   /* of the radii: circles that overlap so do overlap, beyond the rounding of float */


/* twice the area of the triangle a, b, c, positive when it turns left; rounded */
static inline double pair_turn(const double *a, const double *b, double cx, double cy)
{
    return (b[0] - a[0]) * (cy - a[1]) - (b[1] - a[1]) * (cx - a[0]);
}


/* whether two boxes (low x, low y, high x, high y) are apart, the second moved by x, y */
static inline bool pair_apart(const double *a, const double *b, double x, double y)
{
    return b[2] + x < a[0] || b[0] + x > a[2] || b[3] + y < a[1] || b[1] + y > a[3];
}


/* whether the side p, q misses the box */
static inline bool pair_misses(const double *box, const double *p, const double *q)
{
    return (p[0] < box[0] && q[0] < box[0]) || (p[0] > box[2] && q[0] > box[2]) || (p[1] < box[1] && q[1] < box[1]) ||
           (p[1] > box[3] && q[1] > box[3]);
}


/* the point after point i of a shape */
static inline const double *pair_next(const mus__nest_shape *a, int32_t i)
{
    return a->xy + 2 * (i + 1 < a->n ? i + 1 : 0);
}


/* one past the last side of run k */
static inline int32_t pair_end(const mus__nest_shape *a, int32_t k)
{
    return (k + 1) * MUS__NEST_RUN_SIDES < a->n ? (k + 1) * MUS__NEST_RUN_SIDES : a->n;
}


/* whether the point is inside the shape, by the crossings of a ray to the right */
static bool pair_inside(const mus__nest_shape *a, double x, double y)
{
    bool inside = false;
    for (int32_t k = 0; k < mus__nest_runs(a->n); k++) {
        const double *run = a->runs + 4 * k;
        if (run[1] > y || run[3] < y) continue;
        for (int32_t i = k * MUS__NEST_RUN_SIDES; i < pair_end(a, k); i++) {
            const double *p = a->xy + 2 * i, *q = pair_next(a, i);
            if ((p[1] > y) == (q[1] > y)) continue;
            if ((pair_turn(p, q, x, y) > 0.0) == (q[1] > p[1])) inside = !inside;
        }
    }
    return inside;
}


/* write the sides of a shape that come near the box to near; returns their number */
static int32_t pair_near(const mus__nest_shape *a, const double *box, int32_t *near)
{
    int32_t count = 0;
    for (int32_t k = 0; k < mus__nest_runs(a->n); k++) {
        if (pair_apart(box, a->runs + 4 * k, 0.0, 0.0)) continue;
        for (int32_t i = k * MUS__NEST_RUN_SIDES; i < pair_end(a, k); i++)
            if (!pair_misses(box, a->xy + 2 * i, pair_next(a, i))) near[count++] = i;
    }
    return count;
}


/* whether the side p, q shares a point with one of the sides of a that are listed */
static bool pair_crosses(const mus__nest_shape *a, const int32_t *near, int32_t count, const double *p, const double *q)
{
    for (int32_t k = 0; k < count; k++) {
        const double *r = a->xy + 2 * near[k], *s = pair_next(a, near[k]);
        const double one = pair_turn(r, s, p[0], p[1]), two = pair_turn(r, s, q[0], q[1]);
        if ((one > 0.0 && two > 0.0) || (one < 0.0 && two < 0.0)) continue;
        const double three = pair_turn(p, q, r[0], r[1]), four = pair_turn(p, q, s[0], s[1]);
        if ((three > 0.0 && four > 0.0) || (three < 0.0 && four < 0.0)) continue;
        return true;
    }
    return false;
}


bool mus__nest_meets(const mus__nest_shape *a, const mus__nest_shape *b, const double *shift, int32_t *near,
                     int64_t *steps)
{
    double box[4];
    for (int32_t d = 0; d < 2; d++) {
        const double low = shift[d] - b->half[d], high = shift[d] + b->half[d];
        box[d] = low > -a->half[d] ? low : -a->half[d];
        box[2 + d] = high < a->half[d] ? high : a->half[d];
        if (box[d] > box[2 + d]) return false;
    }
    const int32_t count = pair_near(a, box, near), runs = mus__nest_runs(b->n);
    *steps += 20 + mus__nest_runs(a->n) + runs + 2 * count;
    for (int32_t k = 0; k < runs && count > 0; k++) {
        if (pair_apart(box, b->runs + 4 * k, shift[0], shift[1])) continue;
        for (int32_t j = k * MUS__NEST_RUN_SIDES; j < pair_end(b, k); j++) {
            const double *u = b->xy + 2 * j, *v = pair_next(b, j);
            const double p[2] = {u[0] + shift[0], u[1] + shift[1]}, q[2] = {v[0] + shift[0], v[1] + shift[1]};
            if (pair_misses(box, p, q)) continue;
            *steps += 2 * count;
            if (pair_crosses(a, near, count, p, q)) return true;
        }
    }
    /* no sides cross: one is in the other, or they are apart */
    return pair_inside(a, b->xy[0] + shift[0], b->xy[1] + shift[1]) ||
           pair_inside(b, a->xy[0] - shift[0], a->xy[1] - shift[1]);
}


/* whether some of the largest circles overlap, for shapes of many sides: then the sides need not be looked at */
static bool pair_deep(const mus__nest_shape *a, const mus__nest_shape *b, const double *shift)
{
    if (a->n * (double)b->n < PAIR_MANY) return false;
    for (int32_t i = 0; i < PAIR_CIRCLES && i < a->poles.n; i++) {
        for (int32_t j = 0; j < PAIR_CIRCLES && j < b->poles.n; j++) {
            const double x = shift[0] + (double)(b->poles.x[j] - a->poles.x[i]);
            const double y = shift[1] + (double)(b->poles.y[j] - a->poles.y[i]);
            const double reach = PAIR_SURE * (double)(a->poles.r[i] + b->poles.r[j]);
            if (x * x + y * y < reach * reach) return true;
        }
    }
    return false;
}


double mus__nest_loss(const mus__nest_shape *a, const mus__nest_shape *b, const double *shift, int32_t *near,
                      int64_t *steps)
{
    *steps += PAIR_CIRCLES;
    if (!pair_deep(a, b, shift) && !mus__nest_meets(a, b, shift, near, steps)) return 0.0;
    const double epsilon = PAIR_EPSILON * (a->diameter > b->diameter ? a->diameter : b->diameter);
    *steps += 20 + 4 * a->poles.n;
    const double sum =
        (double)mus__nest_poles_f32(&a->poles, &b->poles, (float)shift[0], (float)shift[1], (float)epsilon);
    /* a square root makes a length of the area, and the sizes make large shapes heavier */
    return sqrt(sum + epsilon * epsilon) * sqrt(a->size * b->size);
}


/* ---- exact ---- */

/* whether the point is inside the polygon or on it, exactly */
static bool exact_inside(int32_t n, const double *xy, const double *p)
{
    bool inside = false;
    for (int32_t i = 0, j = n - 1; i < n; j = i++) {
        const double *a = xy + 2 * j, *b = xy + 2 * i;
        if ((a[1] > p[1]) == (b[1] > p[1])) continue;
        if ((mus__orient2d(a, b, p) > 0.0) == (b[1] > a[1])) inside = !inside;
    }
    return inside;
}


/* whether two segments share a point, exactly */
static bool exact_cross(const double *p, const double *q, const double *r, const double *s)
{
    for (int32_t d = 0; d < 2; d++)
        if (fmax(p[d], q[d]) < fmin(r[d], s[d]) || fmax(r[d], s[d]) < fmin(p[d], q[d])) return false;
    const double one = mus__orient2d(r, s, p), two = mus__orient2d(r, s, q);
    if ((one > 0.0 && two > 0.0) || (one < 0.0 && two < 0.0)) return false;
    const double three = mus__orient2d(p, q, r), four = mus__orient2d(p, q, s);
    /* on one line, the boxes overlap: a point is shared */
    return !((three > 0.0 && four > 0.0) || (three < 0.0 && four < 0.0));
}


bool mus__nest_exact_meets(int32_t na, const double *a, int32_t nb, const double *b)
{
    double low[2] = {b[0], b[1]}, high[2] = {b[0], b[1]};
    for (int32_t j = 1; j < nb; j++) {
        for (int32_t d = 0; d < 2; d++) {
            low[d] = fmin(low[d], b[2 * j + d]);
            high[d] = fmax(high[d], b[2 * j + d]);
        }
    }
    for (int32_t i = 0; i < na; i++) {
        const double *p = a + 2 * i, *q = a + 2 * (i + 1 < na ? i + 1 : 0);
        if (fmax(p[0], q[0]) < low[0] || fmin(p[0], q[0]) > high[0] || fmax(p[1], q[1]) < low[1] ||
            fmin(p[1], q[1]) > high[1])
            continue;
        for (int32_t j = 0; j < nb; j++)
            if (exact_cross(p, q, b + 2 * j, b + 2 * (j + 1 < nb ? j + 1 : 0))) return true;
    }
    return exact_inside(na, a, b) || exact_inside(nb, b, a);
}
