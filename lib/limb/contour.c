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

#include "limb/limb.h"
#include "geom/polygon.h"
#include "geom/vec.h"

/* half width of a bump [rad]; breasts of the mean body of GarmentCode */
#define CONTOUR_BUMP_WIDTH 0.35

/* exponent of the rounding of a hosted contour towards its wall: larger is a sharper corner */
#define CONTOUR_ROUND 2.6


void mus__contour_turns(int32_t n, double *turn)
{
    for (int32_t k = 0; k < n; k++) {
        /* cosines and sines of angles below 45 degrees, so that the quarters mirror each other to the last bit */
        int32_t step = k % (n / 4), quarter = k / (n / 4);
        int32_t least = step < n / 4 - step ? step : n / 4 - step;
        double angle = 2.0 * MUS_PI * least / n, more = cos(angle), less = 2 * least == n / 4 ? more : sin(angle);
        double c = least == step ? more : less, s = least == step ? less : more;
        turn[2 * k] = quarter == 0 ? c : quarter == 1 ? -s : quarter == 2 ? -c : s;
        turn[2 * k + 1] = quarter == 0 ? s : quarter == 1 ? c : quarter == 2 ? -s : -c;
    }
}


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

    /* 6.5 widths off it is 4e-19 of h */
    return h * ((l < 6.5 ? exp(-l * l) : 0.0) + (r < 6.5 ? exp(-r * r) : 0.0));
}


static double contour_cross(const double *p, const double *q)
{
    return p[0] * q[1] - p[1] * q[0];
}


/* radius of an outline in a direction d: along the ray to the chord between two corners p and q,
 * R = (p x q) / (d x (q - p)) */
static double contour_outline(const mus__contour *contour, double cosine, double sine)
{
    /* the last corner at or before the angle; before the first it is the last one, a turn earlier */
    const double angle = atan2(sine, cosine);
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
    return n == 2.0 ? 1.0 / sqrt(x * x + y * y) : pow(pow(x, n) + pow(y, n), -1.0 / n);
}


/* the bumps in a direction; the front is towards -b: the frame of the torso is (X, -Z, Y) */
static double contour_bumps(const mus__contour *contour, double cosine, double sine)
{
    double t = atan2(sine, cosine), sum = 0.0;
    if (contour->bump[0] != 0.0) sum += contour_bump(contour->bump[0], contour->bump_angle[0], -0.5 * MUS_PI, t);
    if (contour->bump[1] != 0.0) sum += contour_bump(contour->bump[1], contour->bump_angle[1], 0.5 * MUS_PI, t);
    return sum;
}


/* from the contour's own centre to the shape of its host: |p(R)| = radius of the host in the direction of p(R), by the
 * secant rule; rounded off towards the wall: 1/R^n = 1/host^n + (cos/way to the wall)^n */
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
    return inward > 0.0 ? pow(pow(radius, -round) + pow(inward, round), -1.0 / round) : radius;
}


/* a radius held at the wall: (ca + R cos) * side >= wall */
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


/* radii without the wall: powers of a quarter of the directions, exponentials of a half, since both are symmetric; an
 * outline and a hosted contour are not */
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
        /* quarter by quarter from the front: n - quarter, and on both its sides */
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


/* girth with the free radii times `scale` */
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


double mus__contour_tape(const mus__contour *contour, int32_t n, const double *turn, double *xy, int32_t *work)
{
    double radius[MUS__CONTOUR_SAMPLES];
    contour_free(contour, n, turn, radius);
    return contour_girth(contour, 1.0, radius, n, turn, xy, work);
}


void mus__contour_fit(mus__contour *contour, double girth, int32_t n, const double *turn, double *xy, int32_t *work)
{
    /* the girth is in proportion to the scale: one round; where the wall cuts it grows slower, so a few are needed */
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
