/*
 * predicate.c: orientation and in-circle tests whose signs are exact.
 *
 * The determinant is first computed in double arithmetic, and its sign is taken when its size exceeds the proven error
 * bound. Otherwise it is computed exactly as an expansion: a list of doubles that do not overlap, of ascending size,
 * whose last one has the sign of the sum. Zeros are dropped, so points of a lattice, whose differences are exact, cost
 * a few products only. The results are exact unless a product overflows or underflows, which coordinates in metres do
 * not. Source: Shewchuk, Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates, 1997 (error
 * bounds: figures 21 and 23; expansions: figures 8 and 13).
 */
#include <math.h>

#include "base/exact.h"
#include "geom/predicate.h"

/* half the distance from 1 to the next double, and the error bounds A of Shewchuk */
#define PREDICATE_EPSILON (1.0 / 9007199254740992.0)
#define PREDICATE_ORIENT ((3.0 + 16.0 * PREDICATE_EPSILON) * PREDICATE_EPSILON)
#define PREDICATE_PLANE ((7.0 + 56.0 * PREDICATE_EPSILON) * PREDICATE_EPSILON)
#define PREDICATE_CIRCLE ((10.0 + 96.0 * PREDICATE_EPSILON) * PREDICATE_EPSILON)


/* Writes a - b as an expansion of at most 2 terms; returns their number. */
static int predicate_difference(double a, double b, double *out)
{
    double low, high = mus__exact_sum(a, -b, &low);
    int n = 0;
    if (low != 0.0) out[n++] = low;
    if (high != 0.0) out[n++] = high;
    return n;
}


/* Adds a double to an expansion of n terms in place; returns the new number of terms. */
static int predicate_grow(int n, double *e, double b)
{
    int kept = 0;
    double carry = b;
    for (int i = 0; i < n; i++) {
        double low;
        carry = mus__exact_sum(carry, e[i], &low);
        if (low != 0.0) e[kept++] = low;
    }
    if (carry != 0.0) e[kept++] = carry;
    return kept;
}


/* Writes the product of two expansions to out (2 ne nf); returns its number of terms. */
static int predicate_times(int ne, const double *e, int nf, const double *f, double *out)
{
    int n = 0;
    for (int j = 0; j < nf; j++)
        for (int i = 0; i < ne; i++) {
            double low, high = mus__exact_product(e[i], f[j], &low);
            if (low != 0.0) n = predicate_grow(n, out, low);
            n = predicate_grow(n, out, high);
        }
    return n;
}


/* Adds factor (1 or -1) times the expansion f to e in place; returns the new number of terms. */
static int predicate_add(int ne, double *e, int nf, const double *f, double factor)
{
    for (int i = 0; i < nf; i++) ne = predicate_grow(ne, e, factor * f[i]);
    return ne;
}


/* Writes ax by - ay bx to out (16); the coordinates of both vectors are expansions of at most 2 terms. */
static int predicate_cross(const int *na, double (*a)[2], const int *nb, double (*b)[2], double *out)
{
    double part[8];
    int n = predicate_times(na[0], a[0], nb[1], b[1], out);
    int m = predicate_times(na[1], a[1], nb[0], b[0], part);
    return predicate_add(n, out, m, part, -1.0);
}


static double predicate_orient_exact(const double *a, const double *b, const double *c)
{
    int na[2], nb[2];
    double p[2][2], q[2][2], out[16];
    for (int k = 0; k < 2; k++) {
        na[k] = predicate_difference(a[k], c[k], p[k]);
        nb[k] = predicate_difference(b[k], c[k], q[k]);
    }
    int n = predicate_cross(na, p, nb, q, out);
    return n > 0 ? out[n - 1] : 0.0;
}


static double predicate_circle_exact(const double *const *point, const double *d)
{
    int length[3][2], n = 0;
    double delta[3][2][2], sum[1536];
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 2; k++) length[i][k] = predicate_difference(point[i][k], d[k], delta[i][k]);

    /* cyclic sum of |p_i - d|^2 times the cross product of the other two differences */
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        double cross[16], lift[16], square[8], part[512];
        int ncross = predicate_cross(length[j], delta[j], length[k], delta[k], cross);
        int nlift = predicate_times(length[i][0], delta[i][0], length[i][0], delta[i][0], lift);
        int nsquare = predicate_times(length[i][1], delta[i][1], length[i][1], delta[i][1], square);
        nlift = predicate_add(nlift, lift, nsquare, square, 1.0);
        int npart = predicate_times(ncross, cross, nlift, lift, part);
        n = predicate_add(n, sum, npart, part, 1.0);
    }
    return n > 0 ? sum[n - 1] : 0.0;
}


static double predicate_plane_exact(const double *const *point, const double *d)
{
    int length[3][3], n = 0;
    double delta[3][3][2], sum[192];
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++) length[i][k] = predicate_difference(point[i][k], d[k], delta[i][k]);

    /* cyclic sum of one point's z times the cross product of the other two in x and y */
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        double cross[16], part[64];
        int ncross = predicate_cross(length[j], delta[j], length[k], delta[k], cross);
        int npart = predicate_times(ncross, cross, length[i][2], delta[i][2], part);
        n = predicate_add(n, sum, npart, part, 1.0);
    }
    return n > 0 ? sum[n - 1] : 0.0;
}


double mus__orient2d(const double *a, const double *b, const double *c)
{
    double left = (a[0] - c[0]) * (b[1] - c[1]), right = (a[1] - c[1]) * (b[0] - c[0]);
    double value = left - right, bound = PREDICATE_ORIENT * (fabs(left) + fabs(right));
    if (value > bound || -value > bound) return value;
    return predicate_orient_exact(a, b, c);
}


double mus__incircle(const double *a, const double *b, const double *c, const double *d)
{
    double ax = a[0] - d[0], ay = a[1] - d[1], bx = b[0] - d[0], by = b[1] - d[1], cx = c[0] - d[0], cy = c[1] - d[1];
    double a2 = ax * ax + ay * ay, b2 = bx * bx + by * by, c2 = cx * cx + cy * cy;
    double value = a2 * (bx * cy - by * cx) + b2 * (cx * ay - cy * ax) + c2 * (ax * by - ay * bx);
    double size = a2 * (fabs(bx * cy) + fabs(by * cx)) + b2 * (fabs(cx * ay) + fabs(cy * ax)) +
                  c2 * (fabs(ax * by) + fabs(ay * bx));
    double bound = PREDICATE_CIRCLE * size;
    if (value > bound || -value > bound) return value;

    const double *point[3] = {a, b, c};
    return predicate_circle_exact(point, d);
}


double mus__orient3d(const double *a, const double *b, const double *c, const double *d)
{
    double ax = a[0] - d[0], ay = a[1] - d[1], az = a[2] - d[2];
    double bx = b[0] - d[0], by = b[1] - d[1], bz = b[2] - d[2];
    double cx = c[0] - d[0], cy = c[1] - d[1], cz = c[2] - d[2];
    double value = az * (bx * cy - by * cx) + bz * (cx * ay - cy * ax) + cz * (ax * by - ay * bx);
    double size = fabs(az) * (fabs(bx * cy) + fabs(by * cx)) + fabs(bz) * (fabs(cx * ay) + fabs(cy * ax)) +
                  fabs(cz) * (fabs(ax * by) + fabs(ay * bx));
    double bound = PREDICATE_PLANE * size;
    if (value > bound || -value > bound) return value;

    const double *point[3] = {a, b, c};
    return predicate_plane_exact(point, d);
}
