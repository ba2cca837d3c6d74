/* slice.c: chords of triangles with a plane, and their convex hull (Andrew 1979: monotone chain) */
#include "slice.h"

#include <math.h>
#include <stdlib.h>


static int slice_order(const void *left, const void *right)
{
    const double *p = left, *q = right;
    if (p[0] != q[0]) return p[0] < q[0] ? -1 : 1;
    return p[1] < q[1] ? -1 : p[1] > q[1];
}


static double slice_turn(const double *o, const double *p, const double *q)
{
    return (p[0] - o[0]) * (q[1] - o[1]) - (p[1] - o[1]) * (q[0] - o[0]);
}


/* hull of n sorted points into hull (2n); the number of its corners */
static int slice_hull(const double *xz, int n, double *hull)
{
    int count = 0;
    for (int pass = 0, least = 2; pass < 2; pass++, least = count + 1)
        for (int i = 0; i < n; i++) {
            const double *p = xz + 2 * (pass == 0 ? i : n - 1 - i);
            while (count >= least && slice_turn(hull + 2 * (count - 2), hull + 2 * (count - 1), p) <= 0.0) count--;
            hull[2 * count] = p[0], hull[2 * count + 1] = p[1];
            count++;
        }
    return count - 1;
}


/* ends of the chords of a limb's triangles with the plane; room for 4 numbers a triangle */
static int slice_chords(const mus_body *body, const int32_t *range, double y, double *out)
{
    const double *x = mus_body_vertices(body);
    const int32_t *triangles = mus_body_triangles(body) + 3 * (size_t)range[2];
    int count = 0;
    for (int32_t t = 0; t < range[3]; t++)
        for (int c = 0; c < 3; c++) {
            const double *p = x + 3 * (size_t)triangles[3 * t + c], *q = x + 3 * (size_t)triangles[3 * t + (c + 1) % 3];
            if ((p[1] < y) == (q[1] < y)) continue;
            const double u = (y - p[1]) / (q[1] - p[1]);
            out[2 * count] = p[0] + u * (q[0] - p[0]);
            out[2 * count + 1] = p[2] + u * (q[2] - p[2]);
            count++;
        }
    return count;
}


/* the hull of what the plane cuts of the limbs whose bits are set */
static bool slice_of(const mus_body *body, unsigned limbs, double y, slice *out)
{
    const size_t room = (size_t)mus_body_triangle_count(body);
    *out = (slice){NAN, NAN, NAN, NAN};
    double *xz = malloc(sizeof *xz * 4 * room), *hull = malloc(sizeof *hull * 8 * room);
    int count = 0;
    for (int limb = 0; limb < mus_body_limb_count(body) && xz != NULL && hull != NULL; limb++) {
        int32_t range[4];
        if ((limbs >> limb & 1u) == 0 || mus_body_limb_range(body, limb, range) != MUS_OK) continue;
        count += slice_chords(body, range, y, xz + 2 * count);
    }
    if (count >= 3) {
        qsort(xz, (size_t)count, 2 * sizeof *xz, slice_order);
        const int n = slice_hull(xz, count, hull);
        double low = 1e30, high = -1e30;
        out->girth = out->area = 0.0;
        for (int i = 0; i < n; i++) {
            const double *p = hull + 2 * i, *q = hull + 2 * ((i + 1) % n);
            out->girth += hypot(q[0] - p[0], q[1] - p[1]);
            out->area += 0.5 * (p[0] * q[1] - q[0] * p[1]);
            if (p[1] < low) low = p[1];
            if (p[1] > high) high = p[1];
        }
        out->breadth = xz[2 * (count - 1)] - xz[0];
        out->depth = high - low;
    }
    free(xz);
    free(hull);
    return count >= 3;
}


bool slice_limb(const mus_body *body, int limb, double y, slice *out)
{
    return slice_of(body, 1u << limb, y, out);
}


bool slice_trunk(const mus_body *body, double y, slice *out)
{
    return slice_of(body, 1u | 1u << 3 | 1u << 4, y, out);
}
