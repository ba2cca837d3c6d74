/* curve.c: the closed curve that contact asks at one height of a limb, and winding numbers about it. */
#include <math.h>
#include <string.h>

#include "curve.h"

#define PROBES 64 /* of an arc, where it is held against the outline */


/* point k of the square |a| + |b| = 1 */
static void square_point(int k, double *out)
{
    static const double corner[5][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 0}};
    const int quarter = k * 4 / CURVE_ARCS % 4;
    const double t = 4.0 * (k % CURVE_ARCS) / CURVE_ARCS - quarter;
    for (int i = 0; i < 2; i++) out[i] = corner[quarter][i] + t * (corner[quarter + 1][i] - corner[quarter][i]);
}


/* radius of a polygon about (0, 0) along the unit d: one side is met, at R d = p + t (q - p) */
static double polygon_radius(int corners, const double *outline, const double *d)
{
    double radius = 0.0;
    for (int i = 0; i < corners; i++) {
        const double *p = outline + 2 * i, *q = outline + 2 * ((i + 1) % corners);
        const double sx = q[0] - p[0], sy = q[1] - p[1], across = d[0] * sy - d[1] * sx;
        const double t = (p[0] * d[1] - p[1] * d[0]) / across;
        if (across > 0.0 && t >= -1e-12 && t <= 1.0 + 1e-12) radius = (p[0] * sy - p[1] * sx) / across;
    }
    return radius;
}


void curve_point(const curve *c, int k, double w, double off, double *out)
{
    double e[2], f[2];
    square_point(k, e);
    square_point(k + 1, f);
    const double a = e[0] + w * (f[0] - e[0]), b = e[1] + w * (f[1] - e[1]);
    const double radius = sqrt(c->square[k] + w * (c->square[k + 1] - c->square[k])) + off;
    const double scale = radius / sqrt(a * a + b * b);
    out[0] = c->centre[0] + scale * a, out[1] = c->centre[1] + scale * b;
}


/*
 * K = R u with u = d / |d|. With D = |e_k+1 - e_k| and |d| >= m:  |u'| <= D/m,  |u''| <= 3 (D/m)^2,
 * R' = S'/2R,  R'' = -S'^2/4R^3, all of R on the arc no less than its smaller end and no more than its larger.
 */
static double curve_bend(double square0, double square1)
{
    const double turn = sqrt(2.0) * 4.0 / CURVE_ARCS / sqrt(0.5), least = sqrt(fmin(square0, square1));
    const double rise = fabs(square1 - square0) / (2.0 * least);
    return rise * rise / least + 2.0 * rise * turn + 3.0 * sqrt(fmax(square0, square1)) * turn * turn;
}


void curve_make(int corners, const double *outline, const double *centre, curve *out)
{
    memcpy(out->centre, centre, sizeof out->centre);
    for (int k = 0; k <= CURVE_ARCS; k++) {
        double d[2];
        square_point(k, d);
        const double length = sqrt(d[0] * d[0] + d[1] * d[1]);
        d[0] /= length, d[1] /= length;
        const double radius = polygon_radius(corners, outline, d);
        out->square[k] = k < CURVE_ARCS ? radius * radius : out->square[0];
    }
    for (int k = 0; k <= CURVE_ARCS; k++) {
        if (k < CURVE_ARCS)
            curve_point(out, k, 0.0, 0.0, out->corner[k]);
        else
            memcpy(out->corner[k], out->corner[0], sizeof out->corner[k]);
    }

    /* boxes with what an arc bulges */
    for (int k = 0; k < CURVE_ARCS; k++) {
        out->bend[k] = curve_bend(out->square[k], out->square[k + 1]);
        for (int i = 0; i < 2; i++) {
            out->box[k][i] = fmin(out->corner[k][i], out->corner[k + 1][i]) - out->bend[k] / 8.0;
            out->box[k][2 + i] = fmax(out->corner[k][i], out->corner[k + 1][i]) + out->bend[k] / 8.0;
        }
    }
}


/* +1 where the way from f to g crosses the line from p to the right upwards, -1 downwards, and *square gets the square
 * of the distance of p from it */
static int side_winds(const double *f, const double *g, const double *p, double *square)
{
    const double px = f[0] - p[0], py = f[1] - p[1], dx = g[0] - f[0], dy = g[1] - f[1];
    const double length = dx * dx + dy * dy, left = px * dy - py * dx;
    const double t = length > 0.0 ? fmin(fmax(-(px * dx + py * dy) / length, 0.0), 1.0) : 0.0;
    const double x = px + t * dx, y = py + t * dy;
    *square = x * x + y * y;
    if (f[1] <= p[1] && g[1] > p[1] && left > 0.0) return 1;
    if (f[1] > p[1] && g[1] <= p[1] && left < 0.0) return -1;
    return 0;
}


/* the arc from w0, at f, to w1, at g: the sagitta of no chord is more than bend (w1 - w0)^2 / 8 */
static int arc_winds(const curve *c, int k, double w0, const double *f, double w1, const double *g, const double *p,
                     double band, bool *in_band)
{
    const double sagitta = c->bend[k] * (w1 - w0) * (w1 - w0) / 8.0;
    double square, middle[2];
    const int turns = side_winds(f, g, p, &square);
    const double most = sagitta + band;
    if (square > most * most) return turns;
    if (sagitta <= band) {
        *in_band = true;
        return turns;
    }
    const double w = 0.5 * (w0 + w1);
    curve_point(c, k, w, 0.0, middle);
    return arc_winds(c, k, w0, f, w, middle, p, band, in_band) + arc_winds(c, k, w, middle, w1, g, p, band, in_band);
}


int curve_winds(const curve *c, const double *p, double band, bool *in_band)
{
    int turns = 0;
    for (int k = 0; k < CURVE_ARCS; k++) {
        /* what is above, below or left of p neither crosses the line to the right nor is near */
        const double *box = c->box[k];
        if (p[1] < box[1] - band || p[1] > box[3] + band || p[0] > box[2] + band) continue;
        turns += arc_winds(c, k, 0.0, c->corner[k], 1.0, c->corner[k + 1], p, band, in_band);
    }
    return turns;
}


double curve_apart(const curve *c, int corners, const double *outline)
{
    double most = 0.0, nearest[CURVE_CORNERS], last[2], at[2], square;
    for (int k = 0; k < corners; k++) nearest[k] = INFINITY;
    curve_point(c, 0, 0.0, 0.0, last);
    for (int i = 0; i < 2; i++) last[i] -= c->centre[i];
    for (int i = 1; i <= CURVE_ARCS * PROBES; i++) {
        curve_point(c, (i - 1) / PROBES, (double)((i - 1) % PROBES + 1) / PROBES, 0.0, at);
        for (int k = 0; k < 2; k++) at[k] -= c->centre[k];

        /* this point from the nearest side, each corner from the nearest piece */
        double own = INFINITY;
        for (int k = 0; k < corners; k++) {
            const double *p = outline + 2 * k, *q = outline + 2 * ((k + 1) % corners);
            side_winds(p, q, at, &square);
            own = fmin(own, square);
            side_winds(last, at, p, &square);
            nearest[k] = fmin(nearest[k], square);
        }
        most = fmax(most, own);
        memcpy(last, at, sizeof last);
    }
    for (int k = 0; k < corners; k++) most = fmax(most, nearest[k]);
    return sqrt(most);
}
