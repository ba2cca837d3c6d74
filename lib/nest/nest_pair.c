/*
 * nest_pair.c: whether two shapes overlap, and how much.
 */
#include <math.h>

#include "geom/predicate.h"
#include "nest/nest_shape.h"

#define PAIR_EPSILON 0.01 /* of the larger diameter: the depth below which overlap decays; Gardeyn and others, 2025 */


/* twice the area of the triangle a, b, c, positive when it turns left; rounded */
static inline double pair_turn(const double *a, const double *b, double cx, double cy)
{
    return (b[0] - a[0]) * (cy - a[1]) - (b[1] - a[1]) * (cx - a[0]);
}


/* whether the point is inside the polygon, by the crossings of a ray to the right */
static bool pair_inside(int32_t n, const double *xy, double x, double y)
{
    bool inside = false;
    for (int32_t i = 0, j = n - 1; i < n; j = i++) {
        const double *a = xy + 2 * j, *b = xy + 2 * i;
        if ((a[1] > y) == (b[1] > y)) continue;
        if ((pair_turn(a, b, x, y) > 0.0) == (b[1] > a[1])) inside = !inside;
    }
    return inside;
}


/* write the sides of a shape that come near the box (low x, low y, high x, high y) to near; returns their number */
static int32_t pair_near(const mus__nest_shape *a, const double *box, int32_t *near)
{
    int32_t count = 0;
    const double *xy = a->xy;
    for (int32_t i = 0; i < a->n; i++) {
        const double *p = xy + 2 * i, *q = xy + 2 * (i + 1 < a->n ? i + 1 : 0);
        if ((p[0] < box[0] && q[0] < box[0]) || (p[0] > box[2] && q[0] > box[2]) || (p[1] < box[1] && q[1] < box[1]) ||
            (p[1] > box[3] && q[1] > box[3]))
            continue;
        near[count++] = i;
    }
    return count;
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
    const int32_t count = pair_near(a, box, near);
    *steps += 10 + a->n + b->n;
    for (int32_t j = 0; j < b->n && count > 0; j++) {
        const double *u = b->xy + 2 * j, *v = b->xy + 2 * (j + 1 < b->n ? j + 1 : 0);
        const double p[2] = {u[0] + shift[0], u[1] + shift[1]}, q[2] = {v[0] + shift[0], v[1] + shift[1]};
        if ((p[0] < box[0] && q[0] < box[0]) || (p[0] > box[2] && q[0] > box[2]) || (p[1] < box[1] && q[1] < box[1]) ||
            (p[1] > box[3] && q[1] > box[3]))
            continue;
        *steps += 2 * count;
        for (int32_t k = 0; k < count; k++) {
            const double *r = a->xy + 2 * near[k], *s = a->xy + 2 * (near[k] + 1 < a->n ? near[k] + 1 : 0);
            const double one = pair_turn(r, s, p[0], p[1]), two = pair_turn(r, s, q[0], q[1]);
            if ((one > 0.0 && two > 0.0) || (one < 0.0 && two < 0.0)) continue;
            const double three = pair_turn(p, q, r[0], r[1]), four = pair_turn(p, q, s[0], s[1]);
            if ((three > 0.0 && four > 0.0) || (three < 0.0 && four < 0.0)) continue;
            return true;
        }
    }
    /* no sides cross: one is in the other, or they are apart */
    return pair_inside(a->n, a->xy, b->xy[0] + shift[0], b->xy[1] + shift[1]) ||
           pair_inside(b->n, b->xy, a->xy[0] - shift[0], a->xy[1] - shift[1]);
}


double mus__nest_loss(const mus__nest_shape *a, const mus__nest_shape *b, const double *shift, int32_t *near,
                      int64_t *steps)
{
    if (!mus__nest_meets(a, b, shift, near, steps)) return 0.0;
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
