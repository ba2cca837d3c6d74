/*
 * body_contour.c: one contour: radius by direction, girth, and scaling to the tape.
 *
 * A contour is a superellipse |a/A|^n + |b/B|^n = 1 about its centre (n = 2: the ellipse of paper eq. 6), with a pair
 * of soft bumps towards the front (breasts) and the back (buttocks), cut by a wall where the other leg begins:
 *
 *     R(t) = (|cos t / A|^n + |sin t / B|^n)^(-1/n) + sum of h exp(-(angle to the bump / 0.35)^2)
 *
 * The sampled polygon, not the smooth curve, is scaled to the tape's girth: the polygon is short by pi^2 / 6N^2, which
 * at 32 samples is 1.4 mm on 90 cm. Its girth is that of the hull, as a tape lies over a hollow.
 */
#include <math.h>

#include "body/body_internal.h"
#include "geom/polygon.h"
#include "geom/vec.h"

/* half width of a bump [rad]; breasts of the mean body of GarmentCode */
#define CONTOUR_BUMP_WIDTH 0.35


/* eq. 6 with b = q a is linear in a: p = pi a (3 (1 + q) - sqrt((1 + 3 q)(3 + q))); the factor for n > 2 is fitted to
 * quadratures at q = 0.6 to 0.8 */
double mus__contour_half_breadth(double girth, double ratio, double n)
{
    double q = ratio, p = MUS_PI * (3.0 * (1.0 + q) - sqrt((1.0 + 3.0 * q) * (3.0 + q)));
    return girth / (p * (1.0 + 0.075 * (n - 2.0)));
}


/* a full thigh grows deep; p ~ pi (a + b) with a = 0.51 hip */
double mus__contour_thigh_ratio(double girth, double hip)
{
    return fmin(fmax(girth / (MUS_PI * 0.51 * hip) - 1.0, 1.03), 1.40);
}


/* distance of two angles on the circle */
static double contour_apart(double x, double y)
{
    double d = fabs(x - y);
    return d > MUS_PI ? 2.0 * MUS_PI - d : d;
}


/* pair of bumps of height h at +-angle off the direction `middle` */
static double contour_bump(double h, double angle, double middle, double t)
{
    double l = contour_apart(t, middle - angle) / CONTOUR_BUMP_WIDTH;
    double r = contour_apart(t, middle + angle) / CONTOUR_BUMP_WIDTH;
    return h * (exp(-l * l) + exp(-r * r));
}


double mus__contour_radius(const mus__contour *contour, double cosine, double sine)
{
    if (contour->corners > 0) return mus__outline_radius(contour, cosine, sine);
    double x = fabs(cosine) / contour->a, y = fabs(sine) / contour->b, n = contour->n;
    double radius = n == 2.0 ? 1.0 / sqrt(x * x + y * y) : pow(pow(x, n) + pow(y, n), -1.0 / n);

    /* the front is towards -b: the frame of the torso is (X, -Z, Y) */
    if (contour->bump[0] != 0.0 || contour->bump[1] != 0.0) {
        double t = atan2(sine, cosine);
        radius += contour_bump(contour->bump[0], contour->bump_angle[0], -0.5 * MUS_PI, t);
        radius += contour_bump(contour->bump[1], contour->bump_angle[1], 0.5 * MUS_PI, t);
    }

    /* the wall: (ca + R cos) * side >= wall */
    double inward = -cosine * contour->wall_side;
    if (inward > 0.0) {
        double most = (contour->ca * contour->wall_side - contour->wall) / inward;
        if (radius > most) radius = most;
    }
    return radius;
}


double mus__contour_tape(const mus__contour *contour, int32_t n, const double *turn, double *xy, int32_t *work)
{
    for (int32_t k = 0; k < n; k++) {
        double radius = mus__contour_radius(contour, turn[2 * k], turn[2 * k + 1]);
        xy[2 * k] = radius * turn[2 * k];
        xy[2 * k + 1] = radius * turn[2 * k + 1];
    }
    return mus__polygon_tape(n, xy, work, work + n);
}


void mus__contour_fit(mus__contour *contour, double girth, int32_t n, const double *turn, double *xy, int32_t *work)
{
    /* one round is exact without a wall; with one the girth grows slower than the scale, so a few are needed */
    for (int round = 0; round < 60; round++) {
        double scale = girth / mus__contour_tape(contour, n, turn, xy, work);
        contour->a *= scale;
        contour->b *= scale;
        contour->bump[0] *= scale;
        contour->bump[1] *= scale;
        if (fabs(scale - 1.0) < 1e-13) break;
    }
}
