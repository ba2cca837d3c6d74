/*
 * contour.c: one contour: radius by direction, girth, and scaling to the tape.
 *
 * A contour is a superellipse |a/A|^n + |b/B|^n = 1 about its centre (n = 2 is the ellipse of Metaaphanon and
 * Kanongchaiyos 2005, eq. 6), with a pair of smooth bumps at the front (breasts) and at the back (buttocks), and cut by
 * a plane, the wall, where the other leg begins:
 *
 *     R(t) = (|cos t / A|^n + |sin t / B|^n)^(-1/n) + sum of h exp(-(angle to the bump / 0.35)^2)
 *
 * Two other forms: an outline (polygon given by its corners), and a hosted contour, which has the shape of another
 * contour of its plane seen from its own centre (the root of a leg has the shape of the hip).
 *
 * The sampled polygon is scaled to the tape's girth, not the smooth curve: with N samples the polygon is shorter by
 * pi^2 / 6N^2, which for N = 32 is 1.4 mm on 90 cm. Its girth is that of the convex hull, since a tape spans hollows.
 */
#include <math.h>

#include "limb/limb.h"
#include "base/elementary.h"
#include "geom/polygon.h"
#include "geom/vec.h"

/* exponent with which a hosted contour is rounded towards its wall; chosen: a larger one makes a sharper corner */
#define CONTOUR_ROUND 2.6


void mus__contour_turns(int32_t n, double *turn)
{
    for (int32_t k = 0; k < n; k++) {
        /* only cosines and sines of angles up to 45 degrees are computed, so that the quarters mirror each other */
        int32_t step = k % (n / 4), quarter = k / (n / 4);
        int32_t least = step < n / 4 - step ? step : n / 4 - step;
        double angle = 2.0 * MUS_PI * least / n, more = mus__cos(angle),
               less = 2 * least == n / 4 ? more : mus__sin(angle);
        double c = least == step ? more : less, s = least == step ? less : more;
        turn[2 * k] = quarter == 0 ? c : quarter == 1 ? -s : quarter == 2 ? -c : s;
        turn[2 * k + 1] = quarter == 0 ? s : quarter == 1 ? c : quarter == 2 ? -s : -c;
    }
}


/* Ramanujan's perimeter of an ellipse with b = q a is linear in a: p = pi a (3 (1 + q) - sqrt((1 + 3 q)(3 + q))). The
 * factor for n > 2 is fitted to perimeters by quadrature at q = 0.6 to 0.8 */
double mus__contour_half_breadth(double girth, double ratio, double n)
{
    double q = ratio, p = MUS_PI * (3.0 * (1.0 + q) - sqrt((1.0 + 3.0 * q) * (3.0 + q)));
    return girth / (p * (1.0 + 0.075 * (n - 2.0)));
}


/* from girth = pi (a + b) with a = 0.51 hip: a thicker thigh grows in depth alone */
double mus__contour_thigh_ratio(double girth, double hip)
{
    return fmin(fmax(girth / (MUS_PI * 0.51 * hip) - 1.0, 1.03), 1.40);
}


/* distance of two angles on the circle, 0 to pi [rad] */
static double contour_apart(double x, double y)
{
    double d = fabs(x - y);
    return d > MUS_PI ? 2.0 * MUS_PI - d : d;
}


/* height at angle t of a pair of bumps of height h that stand `angle` to both sides of the direction `middle` */
static double contour_bump(double h, double angle, double middle, double t)
{
    double l = contour_apart(t, middle - angle) / MUS__CONTOUR_BUMP;
    double r = contour_apart(t, middle + angle) / MUS__CONTOUR_BUMP;

    /* beyond 6.5 widths a bump is below 4e-19 of its height */
    return h * ((l < 6.5 ? mus__exp(-l * l) : 0.0) + (r < 6.5 ? mus__exp(-r * r) : 0.0));
}


static double contour_cross(const double *p, const double *q)
{
    return p[0] * q[1] - p[1] * q[0];
}


/* radius of an outline in a direction d: the ray meets the side from corner p to corner q at R = (p x q) / (d x (q -
 * p))
 */
static double contour_outline(const mus__contour *contour, double cosine, double sine)
{
    /* by bisection: the last corner at or before the angle, and the next one; the corners are cyclic */
    const double angle = mus__atan2(sine, cosine);
    const int32_t n = contour->corners;
    int32_t low = -1, high = n;
    while (high - low > 1) {
        const int32_t middle = low + (high - low) / 2;
        if (contour->corner[3 * (ptrdiff_t)middle] <= angle)
            low = middle;
        else
            high = middle;
    }
    const double *p = contour->corner + 3 * (ptrdiff_t)(low < 0 ? n - 1 : low) + 1;
    const double *q = contour->corner + 3 * (ptrdiff_t)(high == n ? 0 : high) + 1;
    const double d[2] = {cosine, sine}, side[2] = {q[0] - p[0], q[1] - p[1]};
    return contour_cross(p, q) / contour_cross(d, side);
}


/* the superellipse or the outline, without bumps and wall */
static double contour_oval(const mus__contour *contour, double cosine, double sine)
{
    if (contour->corners > 0) return contour_outline(contour, cosine, sine);
    double x = fabs(cosine) / contour->a, y = fabs(sine) / contour->b, n = contour->n;
    return n == 2.0 ? 1.0 / sqrt(x * x + y * y) : mus__pow(mus__pow(x, n) + mus__pow(y, n), -1.0 / n);
}


/* height of all bumps in a direction; the front is -b, since the frame of the torso is (X, -Z, Y) */
static double contour_bumps(const mus__contour *contour, double cosine, double sine)
{
    double t = mus__atan2(sine, cosine), sum = 0.0;
    if (contour->bump[0] != 0.0) sum += contour_bump(contour->bump[0], contour->bump_angle[0], -0.5 * MUS_PI, t);
    if (contour->bump[1] != 0.0) sum += contour_bump(contour->bump[1], contour->bump_angle[1], 0.5 * MUS_PI, t);
    return sum;
}


/* radius of a hosted contour: the R at which the point p(R) of the ray lies on the host's shape, by the secant method.
 * Towards the wall it is rounded with the distance w to the wall along the ray: 1/R^n = 1/R_host^n + 1/w^n */
static double contour_hosted(const mus__contour *contour, double cosine, double sine)
{
    const double *host = contour->host, round = CONTOUR_ROUND;
    const mus__contour shape = {
        .a = host[2], .b = host[3], .n = host[4], .bump = {0.0, host[5]}, .bump_angle = {0.0, host[6]}};
    double x0 = contour->ca - host[0], y0 = contour->cb - host[1];
    double radius = 0.5 * (shape.a + shape.b), last = 0.0, before = -1.0;
    for (int step = 0; step < 8; step++) {
        double x = x0 + radius * cosine, y = y0 + radius * sine, rho = sqrt(x * x + y * y) + 1e-12;
        double over = rho / (contour_oval(&shape, x / rho, y / rho) + contour_bumps(&shape, x / rho, y / rho)) - 1.0;
        if (fabs(over) < 1e-7 || over == before) break;
        double next = radius - over * (radius - last) / (over - before);
        last = radius, before = over;
        radius = fmax(next, 1e-6);
    }
    double inward = -cosine * contour->wall_side / (contour->ca * contour->wall_side - contour->wall);
    return inward > 0.0 ? mus__pow(mus__pow(radius, -round) + mus__pow(inward, round), -1.0 / round) : radius;
}


/* a radius cut by the wall: (ca + R cosine) * wall_side >= wall */
static double contour_walled(const mus__contour *contour, double cosine, double radius)
{
    double inward = -cosine * contour->wall_side;
    if (inward <= 0.0) return radius;
    double most = (contour->ca * contour->wall_side - contour->wall) / inward;
    return radius > most ? most : radius;
}


static bool contour_has_bumps(const mus__contour *contour)
{
    return contour->bump[0] != 0.0 || contour->bump[1] != 0.0;
}


double mus__contour_radius(const mus__contour *contour, double cosine, double sine)
{
    if (contour->host[2] > 0.0) return contour_hosted(contour, cosine, sine);
    double radius = contour_oval(contour, cosine, sine);
    if (contour_has_bumps(contour)) radius += contour_bumps(contour, cosine, sine);
    return contour_walled(contour, cosine, radius);
}


/* radii (n) without the wall. A superellipse is computed in a quarter of the directions and its bumps in a half, since
 * they are symmetric; outlines and hosted contours are not */
static void contour_free(const mus__contour *contour, int32_t n, const double *turn, double *radius)
{
    if (contour->corners > 0 || contour->host[2] > 0.0) {
        for (int32_t k = 0; k < n; k++) radius[k] = mus__contour_radius(contour, turn[2 * k], turn[2 * k + 1]);
        return;
    }
    const int32_t half = n / 2, quarter = n / 4;
    for (int32_t k = 0; k <= quarter; k++) {
        radius[k] = contour_oval(contour, turn[2 * k], turn[2 * k + 1]);
        radius[half - k] = radius[half + k] = radius[k];
        radius[k > 0 ? n - k : 0] = radius[k];
    }
    if (!contour_has_bumps(contour)) return;
    for (int32_t k = 0; k <= half; k++) {
        /* the direction of the front is n - quarter: k steps to its left and to its right */
        const int32_t left = (n - quarter + k) % n, right = (n - quarter - k + n) % n;
        const double bumps = contour_bumps(contour, turn[2 * left], turn[2 * left + 1]);
        radius[left] += bumps;
        if (right != left) radius[right] += bumps;
    }
}


void mus__contour_radii(const mus__contour *contour, int32_t n, const double *turn, double *radius)
{
    contour_free(contour, n, turn, radius);
    if (contour->wall_side == 0.0) return;
    for (int32_t k = 0; k < n; k++) radius[k] = contour_walled(contour, turn[2 * k], radius[k]);
}


/* girth [m] of the samples whose radii before the wall are `scale` times `radius` (n) */
static double contour_girth(const mus__contour *contour, double scale, const double *radius, int32_t n,
                            const double *turn, double *xy, int32_t *work)
{
    for (int32_t k = 0; k < n; k++) {
        double r = scale * radius[k];
        if (contour->wall_side != 0.0) r = contour_walled(contour, turn[2 * k], r);
        xy[2 * k] = r * turn[2 * k];
        xy[2 * k + 1] = r * turn[2 * k + 1];
    }
    return mus__polygon_tape(n, xy, work, work + n);
}


void mus__contour_fit(mus__contour *contour, double girth, int32_t n, const double *turn, double *xy, int32_t *work)
{
    /* without a wall the girth is proportional to the scale: one round; with one, the fixed point takes a few rounds */
    double radius[MUS__CONTOUR_SAMPLES], scale = 1.0;
    contour_free(contour, n, turn, radius);
    for (int round = 0; round < 60; round++) {
        double part = girth / contour_girth(contour, scale, radius, n, turn, xy, work);
        scale *= part;
        if (contour->wall_side == 0.0 || fabs(part - 1.0) < 1e-13) break;
    }
    contour->a *= scale;
    contour->b *= scale;
    contour->bump[0] *= scale;
    contour->bump[1] *= scale;
}
