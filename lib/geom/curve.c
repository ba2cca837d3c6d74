/*
 * curve.c: points, tangents, lengths, areas and splits of one planar piece.
 *
 * An arc is kept as its chord and sagitta, never as centre and radius: with half chord k and sagitta s
 *
 *     tan(angle / 4) = s / k,    radius = (k^2 + s^2) / (2 s),
 *
 * which stays sharp from a full circle (k = 0) down to a straight line (s = 0). Lengths of Bezier pieces are integrals
 * of the speed by Gauss-Legendre with 16 nodes, halved until two halves agree with the whole; areas are closed forms.
 * Source: de Casteljau's scheme; Abramowitz and Stegun, Handbook of Mathematical Functions, 1964, table 25.4.
 */
#include <math.h>
#include <stdbool.h>
#include <string.h>

#include "geom/curve.h"
#include "base/elementary.h"
#include "geom/vec.h"

/* agreement of two halves with the whole, of the control polygon's length: the sum over all parts stays below 1e-12 */
#define CURVE_TOLERANCE 1e-15
/* most halvings of a piece: the error at a cusp at least halves each time, and 48 end below rounding */
#define CURVE_DEPTH 48

/* an arc in its own frame: points are middle + u * along + n * across */
typedef struct curve_arc {
    double middle[2], u[2], n[2];
    double half, sagitta, angle; /* half chord, signed along n; angle of the whole arc, >= 0 */
} curve_arc;


static void curve_arc_read(const double *p, curve_arc *arc)
{
    double chord[2] = {p[4] - p[0], p[5] - p[1]};
    double bulge[2] = {p[2] - 0.5 * (p[0] + p[4]), p[3] - 0.5 * (p[1] + p[5])};
    double half = 0.5 * mus__hypot(chord[0], chord[1]), height = mus__hypot(bulge[0], bulge[1]);
    arc->middle[0] = 0.5 * (p[0] + p[4]), arc->middle[1] = 0.5 * (p[1] + p[5]);
    arc->half = half;

    if (height > half) {
        /* more than half a circle: the bulge is the longer and gives the frame */
        arc->n[0] = bulge[0] / height, arc->n[1] = bulge[1] / height;
        double side = arc->n[1] * chord[0] - arc->n[0] * chord[1] >= 0.0 ? 1.0 : -1.0;
        arc->u[0] = side * arc->n[1], arc->u[1] = -side * arc->n[0];
        arc->sagitta = height;
    } else {
        double scale = half > 0.0 ? 0.5 / half : 0.0;
        arc->u[0] = chord[0] * scale, arc->u[1] = chord[1] * scale;
        arc->n[0] = -arc->u[1], arc->n[1] = arc->u[0];
        arc->sagitta = bulge[0] * arc->n[0] + bulge[1] * arc->n[1];
        if (fabs(arc->sagitta) <= 1e-20 * half) arc->sagitta = 0.0;
    }
    arc->angle = 4.0 * mus__atan2(fabs(arc->sagitta), half);
}


static double curve_arc_length(const curve_arc *arc)
{
    double k = arc->half, s = fabs(arc->sagitta);
    return s > 0.0 ? (k * k + s * s) / (2.0 * s) * arc->angle : 2.0 * k;
}


static void curve_arc_at(const double *p, double t, double *out, double *tangent)
{
    curve_arc arc;
    curve_arc_read(p, &arc);
    double k = arc.half, s = arc.sagitta, along, across = 0.0, along_d, across_d = 0.0;
    if (s == 0.0) {
        along = k * (2.0 * t - 1.0), along_d = 2.0 * k;
    } else {
        /* phi from the top of the arc: along = R sin phi, across = s - 2 R sin^2(phi / 2) */
        double radius = (k * k + s * s) / (2.0 * s), angle = s > 0.0 ? arc.angle : -arc.angle;
        double phi = angle * (t - 0.5), sine = mus__sin(0.5 * phi);
        along = radius * mus__sin(phi), across = s - 2.0 * radius * sine * sine;
        along_d = radius * angle * mus__cos(phi), across_d = -radius * angle * mus__sin(phi);
    }
    for (int i = 0; i < 2; i++) {
        if (out != NULL) out[i] = arc.middle[i] + along * arc.u[i] + across * arc.n[i];
        if (tangent != NULL) tangent[i] = along_d * arc.u[i] + across_d * arc.n[i];
    }
}


/* twice the signed area between chord and arc: R^2 (angle - sin angle), positive when the arc runs counter-clockwise */
static double curve_arc_segment(const curve_arc *arc)
{
    double k = arc->half, s = arc->sagitta, x = arc->angle;
    if (s == 0.0) return 0.0;
    double radius = (k * k + s * s) / (2.0 * s), x2 = x * x;
    double gap = x - mus__sin(x);
    if (x < 0.5) gap = x * x2 / 6.0 * (1 - x2 / 20 * (1 - x2 / 42 * (1 - x2 / 72 * (1 - x2 / 110 * (1 - x2 / 156)))));

    /* an arc that bulges to the left of its chord runs clockwise */
    double left = arc->u[0] * arc->n[1] - arc->u[1] * arc->n[0];
    return (left * s > 0.0 ? -1.0 : 1.0) * radius * radius * gap;
}


/* derivative of a Bezier piece by t as a polynomial of its control polygon's sides a, b, c:
 * quadratic 2 (s a + t b), cubic 3 (s^2 a + 2 s t b + t^2 c) with s = 1 - t */
typedef struct curve_pace {
    bool cubic;
    double a[2], b[2], c[2];
} curve_pace;


static void curve_pace_read(int32_t kind, const double *p, curve_pace *pace)
{
    pace->cubic = kind == MUS__CUBIC;
    for (int i = 0; i < 2; i++) {
        pace->a[i] = p[2 + i] - p[i];
        pace->b[i] = p[4 + i] - p[2 + i];
        pace->c[i] = pace->cubic ? p[6 + i] - p[4 + i] : 0.0;
    }
}


static inline double curve_speed(const curve_pace *pace, double t)
{
    const double s = 1.0 - t, *a = pace->a, *b = pace->b, *c = pace->c;
    double x, y;
    if (pace->cubic) {
        const double ss = s * s, st = 2.0 * s * t, tt = t * t;
        x = 3.0 * (ss * a[0] + st * b[0] + tt * c[0]);
        y = 3.0 * (ss * a[1] + st * b[1] + tt * c[1]);
    } else {
        x = 2.0 * (s * a[0] + t * b[0]);
        y = 2.0 * (s * a[1] + t * b[1]);
    }
    return sqrt(x * x + y * y);
}


/* Gauss-Legendre with 16 nodes over a .. b */
static double curve_gauss(const curve_pace *pace, double a, double b)
{
    static const double node[8] = {0.0950125098376374402, 0.2816035507792589132, 0.4580167776572273863,
                                   0.6178762444026437484, 0.7554044083550030339, 0.8656312023878317439,
                                   0.9445750230732325761, 0.9894009349916499326};
    static const double weight[8] = {0.1894506104550684963, 0.1826034150449235889, 0.1691565193950025382,
                                     0.1495959888165767321, 0.1246289712555338720, 0.0951585116824927848,
                                     0.0622535239386478929, 0.0271524594117540949};
    double middle = 0.5 * (a + b), half = 0.5 * (b - a), sum = 0.0;
    for (int i = 0; i < 8; i++)
        sum += weight[i] * (curve_speed(pace, middle - half * node[i]) + curve_speed(pace, middle + half * node[i]));
    return sum * half;
}


/* length over a .. b whose one-part estimate is `whole` */
static double curve_refine(const curve_pace *pace, double a, double b, double whole, double tolerance, int depth)
{
    double middle = 0.5 * (a + b);
    double left = curve_gauss(pace, a, middle), right = curve_gauss(pace, middle, b);
    if (fabs(left + right - whole) <= tolerance || depth == 0) return left + right;
    return curve_refine(pace, a, middle, left, tolerance, depth - 1) +
           curve_refine(pace, middle, b, right, tolerance, depth - 1);
}


/* length from parameter a to b of a Bezier piece, negative when b < a */
static double curve_between(int32_t kind, const double *p, double a, double b)
{
    curve_pace pace;
    curve_pace_read(kind, p, &pace);
    double polygon = 0.0;
    for (int32_t i = 0; i + 1 < mus__curve_points(kind); i++) polygon += mus__dist2(p + 2 * i, p + 2 * i + 2);
    return curve_refine(&pace, a, b, curve_gauss(&pace, a, b), CURVE_TOLERANCE * polygon, CURVE_DEPTH);
}


int32_t mus__curve_points(int32_t kind)
{
    switch (kind) {
    case MUS__LINE: return 2;
    case MUS__QUADRATIC: return 3;
    case MUS__CUBIC: return 4;
    case MUS__ARC: return 3;
    default: return 0;
    }
}


void mus__curve_at(int32_t kind, const double *p, double t, double *out)
{
    double s = 1.0 - t;
    if (kind == MUS__ARC) {
        /* the ends are met to the bit */
        if (t == 0.0)
            out[0] = p[0], out[1] = p[1];
        else if (t == 1.0)
            out[0] = p[4], out[1] = p[5];
        else
            curve_arc_at(p, t, out, NULL);
        return;
    }
    for (int i = 0; i < 2; i++) {
        if (kind == MUS__LINE)
            out[i] = s * p[i] + t * p[2 + i];
        else if (kind == MUS__QUADRATIC)
            out[i] = s * s * p[i] + 2.0 * s * t * p[2 + i] + t * t * p[4 + i];
        else
            out[i] = s * s * s * p[i] + 3.0 * s * t * (s * p[2 + i] + t * p[4 + i]) + t * t * t * p[6 + i];
    }
}


void mus__curve_tangent(int32_t kind, const double *p, double t, double *out)
{
    double s = 1.0 - t;
    if (kind == MUS__ARC) {
        curve_arc_at(p, t, NULL, out);
        return;
    }
    for (int i = 0; i < 2; i++) {
        double a = p[2 + i] - p[i];
        if (kind == MUS__LINE) {
            out[i] = a;
            continue;
        }
        double b = p[4 + i] - p[2 + i];
        if (kind == MUS__QUADRATIC)
            out[i] = 2.0 * (s * a + t * b);
        else
            out[i] = 3.0 * (s * s * a + 2.0 * s * t * b + t * t * (p[6 + i] - p[4 + i]));
    }
}


double mus__curve_length_to(int32_t kind, const double *p, double t)
{
    if (kind == MUS__LINE) return t * mus__dist2(p, p + 2);
    if (kind == MUS__ARC) {
        curve_arc arc;
        curve_arc_read(p, &arc);
        return t * curve_arc_length(&arc);
    }
    return curve_between(kind, p, 0.0, t);
}


double mus__curve_length(int32_t kind, const double *p)
{
    return mus__curve_length_to(kind, p, 1.0);
}


double mus__curve_param(int32_t kind, const double *p, double s)
{
    double length = mus__curve_length(kind, p);
    if (s <= 0.0 || !(length > 0.0)) return 0.0;
    if (s >= length) return 1.0;
    double t = s / length;
    if (kind == MUS__LINE || kind == MUS__ARC) return t;

    /* Newton on length(t) = s within a bracket that shrinks at every turn */
    curve_pace pace;
    curve_pace_read(kind, p, &pace);
    double low = 0.0, high = 1.0, at = curve_between(kind, p, 0.0, t);
    for (int i = 0; i < 100 && fabs(at - s) > 1e-14 * length; i++) {
        if (at > s)
            high = t;
        else
            low = t;
        double speed = curve_speed(&pace, t), next = speed > 0.0 ? t - (at - s) / speed : low;
        if (!(next > low && next < high)) next = 0.5 * (low + high);
        if (next == t) break;
        at += curve_between(kind, p, t, next);
        t = next;
    }
    return t;
}


double mus__curve_area(int32_t kind, const double *p)
{
#define CROSS(i, j) (p[2 * (i)] * p[2 * (j) + 1] - p[2 * (i) + 1] * p[2 * (j)])
    switch (kind) {
    case MUS__LINE: return 0.5 * CROSS(0, 1);
    case MUS__QUADRATIC: return (2.0 * CROSS(0, 1) + CROSS(0, 2) + 2.0 * CROSS(1, 2)) / 6.0;
    case MUS__CUBIC:
        return (6.0 * CROSS(0, 1) + 3.0 * CROSS(0, 2) + CROSS(0, 3) + 3.0 * CROSS(1, 2) + 3.0 * CROSS(1, 3) +
                6.0 * CROSS(2, 3)) /
               20.0;
    default: {
        curve_arc arc;
        curve_arc_read(p, &arc);
        return 0.5 * (CROSS(0, 2) + curve_arc_segment(&arc));
    }
    }
#undef CROSS
}


void mus__curve_split(int32_t kind, const double *p, double t, double *left, double *right)
{
    int32_t n = mus__curve_points(kind);
    if (kind == MUS__ARC) {
        memcpy(left, p, 2 * sizeof *p);
        mus__curve_at(kind, p, 0.5 * t, left + 2);
        mus__curve_at(kind, p, t, left + 4);
        memcpy(right, left + 4, 2 * sizeof *p);
        mus__curve_at(kind, p, 0.5 * (1.0 + t), right + 2);
        memcpy(right + 4, p + 4, 2 * sizeof *p);
        return;
    }

    /* de Casteljau: the right part is the last column of the triangle, built in place */
    memcpy(right, p, 2 * (size_t)n * sizeof *p);
    for (int32_t level = 0; level < n; level++) {
        left[2 * level] = right[0], left[2 * level + 1] = right[1];
        for (int32_t i = 0; i < 2 * (n - 1 - level); i++) right[i] = (1.0 - t) * right[i] + t * right[i + 2];
    }
}
