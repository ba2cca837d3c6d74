/*
 * spline.c: cubic splines through points, by the second derivatives at the knots.
 *
 * With h_i = x_{i+1} - x_i the second derivatives m solve, at every inner knot,
 *
 *     h_{i-1} m_{i-1} + 2 (h_{i-1} + h_i) m_i + h_i m_{i+1} = 6 ((y_{i+1} - y_i) / h_i - (y_i - y_{i-1}) / h_{i-1}),
 *
 * with m = 0 at both ends (natural) or with cyclic indices (periodic; the cyclic system is reduced to two
 * tridiagonal ones). The matrix dominates its diagonal, so elimination needs no pivoting.
 * Source: Metaaphanon and Kanongchaiyos 2005, eq. 7 to 11; de Boor, A Practical Guide to Splines, 1978; Sherman and
 *          Morrison 1950 for the cycle.
 */
#include <stddef.h>

#include "geom/spline.h"


/* is x strictly ascending? NaN never is */
static bool spline_ascends(int32_t n, const double *x)
{
    for (int32_t i = 0; i + 1 < n; i++)
        if (!(x[i + 1] > x[i])) return false;
    return true;
}


bool mus__spline_natural(int32_t n, const double *x, const double *y, double *m, double *work)
{
    if (n < 2 || !spline_ascends(n, x)) return false;

    /* forward elimination: m_i = right_i - ratio_i m_{i+1} */
    double *ratio = work, *right = work + n;
    ratio[0] = right[0] = 0.0;
    for (int32_t i = 1; i + 1 < n; i++) {
        double h0 = x[i] - x[i - 1], h1 = x[i + 1] - x[i];
        double pivot = 2.0 * (h0 + h1) - h0 * ratio[i - 1];
        ratio[i] = h1 / pivot;
        right[i] = (6.0 * ((y[i + 1] - y[i]) / h1 - (y[i] - y[i - 1]) / h0) - h0 * right[i - 1]) / pivot;
    }

    m[0] = m[n - 1] = 0.0;
    for (int32_t i = n - 2; i > 0; i--) m[i] = right[i] - ratio[i] * m[i + 1];
    return true;
}


bool mus__spline_periodic(int32_t n, const double *x, double last, const double *y, double *m, double *work)
{
    if (n < 3 || !spline_ascends(n, x) || !(last > 0.0)) return false;

    /* diagonal d, upper neighbours h; corner entries h_last couple knot n-1 with knot 0 */
    double *d = work, *h = work + n, *q = work + 2 * (ptrdiff_t)n, *ratio = work + 3 * (ptrdiff_t)n;
    for (int32_t i = 0; i < n; i++) h[i] = i + 1 < n ? x[i + 1] - x[i] : last;
    for (int32_t i = 0; i < n; i++) {
        int32_t before = i > 0 ? i - 1 : n - 1, after = i + 1 < n ? i + 1 : 0;
        d[i] = 2.0 * (h[before] + h[i]);
        m[i] = 6.0 * ((y[after] - y[i]) / h[i] - (y[i] - y[before]) / h[before]);
        q[i] = 0.0;
    }

    /* A = T + u v^T with u = (g, 0 .., h_last), v = (1, 0 .., h_last / g), g = -d_0 */
    double corner = h[n - 1], g = -d[0];
    d[0] -= g, d[n - 1] -= corner * corner / g;
    q[0] = g, q[n - 1] = corner;

    /* T m = right and T q = u in one sweep */
    ratio[0] = h[0] / d[0], m[0] /= d[0], q[0] /= d[0];
    for (int32_t i = 1; i < n; i++) {
        double pivot = d[i] - h[i - 1] * ratio[i - 1];
        ratio[i] = h[i] / pivot;
        m[i] = (m[i] - h[i - 1] * m[i - 1]) / pivot;
        q[i] = (q[i] - h[i - 1] * q[i - 1]) / pivot;
    }
    for (int32_t i = n - 2; i >= 0; i--) {
        m[i] -= ratio[i] * m[i + 1];
        q[i] -= ratio[i] * q[i + 1];
    }

    double factor = (m[0] + m[n - 1] * corner / g) / (1.0 + q[0] + q[n - 1] * corner / g);
    for (int32_t i = 0; i < n; i++) m[i] -= factor * q[i];
    return true;
}


double mus__spline_at(int32_t n, const double *x, const double *y, const double *m, double t, double *derivative)
{
    /* the piece low .. low + 1 that holds t; an outer t takes the end piece */
    int32_t low = 0, high = n - 1;
    while (high - low > 1) {
        int32_t middle = low + (high - low) / 2;
        if (x[middle] <= t)
            low = middle;
        else
            high = middle;
    }
    double h = x[low + 1] - x[low], slope = (y[low + 1] - y[low]) / h;

    /* before the first and after the last knot the spline is the tangent there */
    if (t < x[0] || t > x[n - 1]) {
        bool before = t < x[0];
        double tangent =
            before ? slope - h * (2.0 * m[low] + m[low + 1]) / 6.0 : slope + h * (m[low] + 2.0 * m[low + 1]) / 6.0;
        if (derivative != NULL) *derivative = tangent;
        return before ? y[0] + tangent * (t - x[0]) : y[n - 1] + tangent * (t - x[n - 1]);
    }

    /* S = a y0 + b y1 + ((a^3 - a) m0 + (b^3 - b) m1) h^2 / 6,  a = (x1 - t) / h, b = (t - x0) / h */
    double a = (x[low + 1] - t) / h, b = (t - x[low]) / h;
    if (derivative != NULL)
        *derivative = slope + h / 6.0 * ((3.0 * b * b - 1.0) * m[low + 1] - (3.0 * a * a - 1.0) * m[low]);
    return a * y[low] + b * y[low + 1] + ((a * a - 1.0) * a * m[low] + (b * b - 1.0) * b * m[low + 1]) * h * h / 6.0;
}
