/*
 * crossing_count.c: edges against triangles with exact signs.
 *
 * The segment p q meets the triangle a b c off its plane when p and q are not on the same side of it, and the line p q
 * has a b, b c and c a on one side:  orient(p,q,a,b), orient(p,q,b,c), orient(p,q,c,a)  of one sign, or 0. In the
 * plane it is a question of two dimensions, asked of the projection in which the triangle has an area.
 */
#include <math.h>

#include "selfcontact/crossing_count.h"
#include "geom/predicate.h"

#define CROSSING_ROUND 1.2e-7 /* of a coordinate: rounding a double to float changes it by less */


/* nonzero when c, on the line a b, is between a and b */
static int32_t crossing_between(const double *a, const double *b, const double *c)
{
    const int32_t d = a[0] != b[0] ? 0 : 1;
    return (a[d] <= c[d] && c[d] <= b[d]) || (b[d] <= c[d] && c[d] <= a[d]);
}


/* two segments of the plane have a point in common */
static int32_t crossing_flat(const double *p, const double *q, const double *a, const double *b)
{
    const double sa = mus__orient2d(p, q, a), sb = mus__orient2d(p, q, b);
    const double sp = mus__orient2d(a, b, p), sq = mus__orient2d(a, b, q);
    if (((sa > 0.0 && sb < 0.0) || (sa < 0.0 && sb > 0.0)) && ((sp > 0.0 && sq < 0.0) || (sp < 0.0 && sq > 0.0)))
        return 1;
    return (sa == 0.0 && crossing_between(p, q, a)) || (sb == 0.0 && crossing_between(p, q, b)) ||
           (sp == 0.0 && crossing_between(a, b, p)) || (sq == 0.0 && crossing_between(a, b, q));
}


/* nonzero when the segment p q, in the plane of the triangle `corner` (3), meets it */
static int32_t crossing_in_plane(const double *p, const double *q, const double *const *corner)
{
    double flat[5][2];
    for (int32_t drop = 0; drop < 3; drop++) {
        const int32_t u = drop == 0 ? 1 : 0, v = drop == 2 ? 1 : 2;
        for (int32_t k = 0; k < 5; k++) {
            const double *x = k < 3 ? corner[k] : k == 3 ? p : q;
            flat[k][0] = x[u], flat[k][1] = x[v];
        }
        if (mus__orient2d(flat[0], flat[1], flat[2]) == 0.0) continue;
        int32_t left = 0, right = 0;
        for (int32_t k = 0; k < 3; k++) {
            const double side = mus__orient2d(flat[k], flat[(k + 1) % 3], flat[3]);
            left += side >= 0.0;
            right += side <= 0.0;
            if (crossing_flat(flat[3], flat[4], flat[k], flat[(k + 1) % 3])) return 1;
        }
        return left == 3 || right == 3;
    }
    return 0;
}


int32_t mus__segment_meets_triangle(const double *p, const double *q, const double *a, const double *b, const double *c)
{
    const double above = mus__orient3d(a, b, c, p), below = mus__orient3d(a, b, c, q);
    if ((above > 0.0 && below > 0.0) || (above < 0.0 && below < 0.0)) return 0;
    if (above == 0.0 && below == 0.0) {
        const double *const corner[3] = {a, b, c};
        return crossing_in_plane(p, q, corner);
    }
    const double ab = mus__orient3d(p, q, a, b), bc = mus__orient3d(p, q, b, c), ca = mus__orient3d(p, q, c, a);
    return (ab >= 0.0 && bc >= 0.0 && ca >= 0.0) || (ab <= 0.0 && bc <= 0.0 && ca <= 0.0);
}


typedef struct crossing_search {
    const int32_t *triangle, *class_of;
    const double *x;
    mus__crossing_fn fn;
    void *user;
    int64_t count;
} crossing_search;


static int32_t crossing_class(const crossing_search *s, int32_t node)
{
    return s->class_of != NULL ? s->class_of[node] : node;
}


/* nonzero when the node is no corner of the triangle */
static int32_t crossing_apart(const crossing_search *s, int32_t node, const int32_t *corner)
{
    const int32_t c = crossing_class(s, node);
    return c != crossing_class(s, corner[0]) && c != crossing_class(s, corner[1]) && c != crossing_class(s, corner[2]);
}


static int32_t crossing_degenerate(const crossing_search *s, const int32_t *corner)
{
    const int32_t a = crossing_class(s, corner[0]), b = crossing_class(s, corner[1]), c = crossing_class(s, corner[2]);
    return a == b || b == c || c == a;
}


/* edges of triangle `of` that meet triangle `met` */
static int32_t crossing_edges(const crossing_search *s, int32_t of, int32_t met)
{
    const int32_t *corner = s->triangle + 3 * (int64_t)met;
    const double *a = s->x + 3 * (int64_t)corner[0], *b = s->x + 3 * (int64_t)corner[1];
    const double *c = s->x + 3 * (int64_t)corner[2];
    int32_t found = 0;
    for (int32_t k = 0; k < 3; k++) {
        const int32_t p = s->triangle[3 * (int64_t)of + k], q = s->triangle[3 * (int64_t)of + (k + 1) % 3];
        if (!crossing_apart(s, p, corner) || !crossing_apart(s, q, corner)) continue;
        if (!mus__segment_meets_triangle(s->x + 3 * (int64_t)p, s->x + 3 * (int64_t)q, a, b, c)) continue;
        found++;
        if (s->fn != NULL) s->fn(s->user, p, q, of, met);
    }
    return found;
}


static void crossing_pair(void *user, int32_t a, int32_t b)
{
    crossing_search *s = user;
    if (crossing_degenerate(s, s->triangle + 3 * (int64_t)a) || crossing_degenerate(s, s->triangle + 3 * (int64_t)b))
        return;
    const int32_t found = crossing_edges(s, a, b) + crossing_edges(s, b, a);
    s->count += found > 0;
}


int64_t mus__crossing_count(mus__box_grid *grid, int32_t n, const int32_t *triangle, const int32_t *class_of,
                            const double *x, mus__crossing_fn fn, void *user)
{
    /* boxes in float, widened by more than the rounding */
    for (int64_t t = 0; t < n; t++)
        for (int32_t d = 0; d < 3; d++) {
            const double *a = x + 3 * (int64_t)triangle[3 * t], *b = x + 3 * (int64_t)triangle[3 * t + 1];
            const double *c = x + 3 * (int64_t)triangle[3 * t + 2];
            const double low = fmin(a[d], fmin(b[d], c[d])), high = fmax(a[d], fmax(b[d], c[d]));
            grid->box[6 * t + d] = (float)(low - CROSSING_ROUND * fabs(low));
            grid->box[6 * t + 3 + d] = (float)(high + CROSSING_ROUND * fabs(high));
        }
    crossing_search search = {triangle, class_of, x, fn, user, 0};
    mus__box_grid_pairs(grid, n, 0.0f, crossing_pair, &search);
    return search.count;
}
