/*
 * val_curve.c: curves as chains of cubics: lengths, places, parts, crossings with a line.
 *
 * A parameter t has the cubic as its whole part. Places are sought on CURVE_CHORDS chords of each cubic.
 */
#include <math.h>
#include <string.h>

#include "base/elementary.h"
#include "exchange/file_read.h"
#include "valentina/val_file.h"

#define CURVE_CHORDS 128 /* of a cubic. Chosen: of an armhole of 500 mm the chords stray by 0.004 mm */
#define CURVE_STEP 30.0  /* [degrees] largest part of an arc in one cubic; its error is 2e-7 of the radius */
/* [mm] a part of a cubic this flat is two chords: a pixel at 96 to the inch. It is Valentina's, whose lengths stand in
 * formulas; finer chords make longer curves by up to 0.3 mm of 500 mm */
#define CURVE_FLAT (25.4 / 96.0)
#define CURVE_HALVINGS 16 /* deepest halving; the chords of a curve of 10 m are shorter than CURVE_FLAT then */


void mus__val_polar(const double *p, double length, double angle, double *out)
{
    const double x = p[0] + length * mus__cos(angle * MUS__DEGREE);
    out[1] = p[1] + length * mus__sin(angle * MUS__DEGREE);
    out[0] = x;
}


double mus__val_angle(const double *from, const double *to)
{
    const double angle = mus__atan2(to[1] - from[1], to[0] - from[0]) / MUS__DEGREE;
    return angle < 0.0 ? angle + 360.0 : angle;
}


mus_status mus__val_curve_add(const mus__source *source, mus__val_curve *curve, const double *cubic)
{
    mus_status status = mus__source_reserve(source, &curve->cubic, &curve->room, 8 * ((int64_t)curve->n + 1),
                                           sizeof *curve->cubic);
    if (status != MUS_OK) return status;
    memcpy(curve->cubic + 8 * (ptrdiff_t)curve->n++, cubic, 8 * sizeof *cubic);
    return MUS_OK;
}


mus_status mus__val_curve_arc(const mus__source *source, mus__val_curve *curve, const double *centre, double radius,
                              double from, double to)
{
    const double span = to - from;
    const int32_t n = (int32_t)fmin(ceil(fabs(span) / CURVE_STEP), 1000.0);
    const double step = n > 0 ? span / n : 0.0, reach = 4.0 / 3.0 * radius * mus__tan(0.25 * step * MUS__DEGREE);
    mus_status status = MUS_OK;
    curve->arc = true;
    memcpy(curve->centre, centre, sizeof curve->centre);
    curve->radius = radius, curve->angle[0] = from, curve->angle[1] = to;
    for (int32_t i = 0; i < n && status == MUS_OK; i++) {
        double cubic[8];
        for (int32_t end = 0; end < 2; end++) {
            const double a = (from + (i + end) * step) * MUS__DEGREE, c = mus__cos(a), s = mus__sin(a);
            const double back = end == 0 ? reach : -reach;
            double *p = cubic + 6 * end, *q = cubic + 2 + 2 * end;
            p[0] = centre[0] + radius * c, p[1] = centre[1] + radius * s;
            q[0] = p[0] - back * s, q[1] = p[1] + back * c;
        }
        status = mus__val_curve_add(source, curve, cubic);
    }
    return status;
}


void mus__val_curve_at(const mus__val_curve *curve, double t, double *out)
{
    out[0] = out[1] = NAN;
    if (curve->n == 0 || isnan(t)) return;
    const int32_t i = (int32_t)fmin(fmax(floor(t), 0.0), curve->n - 1);
    const double u = t - i, v = 1.0 - u, *p = curve->cubic + 8 * (ptrdiff_t)i;
    for (int32_t k = 0; k < 2; k++)
        out[k] = v * v * v * p[k] + 3.0 * v * v * u * p[2 + k] + 3.0 * v * u * u * p[4 + k] + u * u * u * p[6 + k];
}


/* the part of a cubic between two parameters, by its polar form */
static void curve_piece(const double *p, double from, double to, double *out)
{
    for (int32_t k = 0; k < 2; k++)
        for (int32_t j = 0; j < 4; j++) {
            const double u[3] = {j > 0 ? to : from, j > 1 ? to : from, j > 2 ? to : from};
            double c[4] = {p[k], p[2 + k], p[4 + k], p[6 + k]};
            for (int32_t level = 0; level < 3; level++)
                for (int32_t i = 0; i < 3 - level; i++) c[i] = (1.0 - u[level]) * c[i] + u[level] * c[i + 1];
            out[2 * j + k] = c[0];
        }
}


/* length of a cubic as Valentina's chords have it: halves until the controls lie within CURVE_FLAT of the chord, then
 * the middle of the controls stands for the part (Shemanarev, Adaptive Subdivision of Bezier Curves, 2005). *last is
 * the last place before */
static double curve_chords(const double *p, double *last, int32_t depth)
{
    double halves[16];
    const double dx = p[6] - p[0], dy = p[7] - p[1];
    const double off = fabs((p[2] - p[6]) * dy - (p[3] - p[7]) * dx) + fabs((p[4] - p[6]) * dy - (p[5] - p[7]) * dx);
    if (depth == 0 || off * off <= CURVE_FLAT * CURVE_FLAT * (dx * dx + dy * dy)) {
        const double middle[2] = {0.5 * (p[2] + p[4]), 0.5 * (p[3] + p[5])};
        const double chord = mus__hypot(middle[0] - last[0], middle[1] - last[1]);
        memcpy(last, middle, sizeof middle);
        return chord;
    }
    curve_piece(p, 0.0, 0.5, halves);
    curve_piece(p, 0.5, 1.0, halves + 8);
    const double first = curve_chords(halves, last, depth - 1);
    return first + curve_chords(halves + 8, last, depth - 1);
}


double mus__val_curve_length(const mus__val_curve *curve)
{
    double length = 0.0;
    if (curve->arc) return curve->radius * fabs(curve->angle[1] - curve->angle[0]) * MUS__DEGREE;
    for (int32_t i = 0; i < curve->n; i++) {
        const double *p = curve->cubic + 8 * (ptrdiff_t)i;
        double last[2] = {p[0], p[1]};
        length += curve_chords(p, last, CURVE_HALVINGS);
        length += mus__hypot(p[6] - last[0], p[7] - last[1]);
    }
    return length;
}


double mus__val_curve_along(const mus__val_curve *curve, double length)
{
    double so_far = 0.0, a[2], b[2];
    if (curve->n == 0 || !(length > 0.0)) return 0.0;
    mus__val_curve_at(curve, 0.0, a);
    for (int32_t i = 1; i <= curve->n * CURVE_CHORDS; i++, memcpy(a, b, sizeof a)) {
        mus__val_curve_at(curve, (double)i / CURVE_CHORDS, b);
        const double chord = mus__hypot(b[0] - a[0], b[1] - a[1]);
        if (so_far + chord >= length && chord > 0.0) return (i - 1 + (length - so_far) / chord) / CURVE_CHORDS;
        so_far += chord;
    }
    return curve->n;
}


double mus__val_curve_nearest(const mus__val_curve *curve, const double *p, double *away)
{
    double best = 0.0, a[2], b[2];
    *away = INFINITY;
    if (curve->n == 0) return 0.0;
    mus__val_curve_at(curve, 0.0, a);
    for (int32_t i = 1; i <= curve->n * CURVE_CHORDS; i++, memcpy(a, b, sizeof a)) {
        mus__val_curve_at(curve, (double)i / CURVE_CHORDS, b);
        const double d[2] = {b[0] - a[0], b[1] - a[1]}, dd = d[0] * d[0] + d[1] * d[1];
        double u = dd > 0.0 ? ((p[0] - a[0]) * d[0] + (p[1] - a[1]) * d[1]) / dd : 0.0;
        u = fmin(fmax(u, 0.0), 1.0);
        const double off = mus__hypot(a[0] + u * d[0] - p[0], a[1] + u * d[1] - p[1]);
        if (off < *away) *away = off, best = (i - 1 + u) / CURVE_CHORDS;
    }
    return best;
}


mus_status mus__val_curve_part(const mus__source *source, const mus__val_curve *curve, double from, double to,
                               mus__val_curve *out)
{
    mus_status status = MUS_OK;
    for (int32_t i = 0; i < curve->n && status == MUS_OK; i++) {
        const double low = fmax(from - i, 0.0), high = fmin(to - i, 1.0);
        double cubic[8];
        if (high - low < 1e-9) continue;
        curve_piece(curve->cubic + 8 * (ptrdiff_t)i, low, high, cubic);
        status = mus__val_curve_add(source, out, cubic);
    }
    if (!curve->arc) return status;
    const double span = curve->angle[1] - curve->angle[0];
    out->arc = true;
    out->radius = curve->radius;
    memcpy(out->centre, curve->centre, sizeof out->centre);
    out->angle[0] = curve->angle[0] + span * from / curve->n;
    out->angle[1] = curve->angle[0] + span * to / curve->n;
    return status;
}


void mus__val_curve_reverse(mus__val_curve *curve)
{
    const int32_t n = 4 * curve->n;
    for (int32_t i = 0; i < n / 2; i++)
        for (int32_t k = 0; k < 2; k++) {
            const double hold = curve->cubic[2 * i + k];
            curve->cubic[2 * i + k] = curve->cubic[2 * (n - 1 - i) + k];
            curve->cubic[2 * (n - 1 - i) + k] = hold;
        }
    const double hold = curve->angle[0];
    curve->angle[0] = curve->angle[1], curve->angle[1] = hold;
}


/* where the chord from t to t + 1 / CURVE_CHORDS crosses the line, bisected on the cubic */
static double curve_cross(const mus__val_curve *curve, double low, double high, const double *p, const double *d)
{
    double x[2];
    mus__val_curve_at(curve, low, x);
    const bool left = d[0] * (x[1] - p[1]) - d[1] * (x[0] - p[0]) >= 0.0;
    for (int32_t i = 0; i < 40; i++) {
        const double middle = 0.5 * (low + high);
        mus__val_curve_at(curve, middle, x);
        if ((d[0] * (x[1] - p[1]) - d[1] * (x[0] - p[0]) >= 0.0) == left) low = middle;
        else high = middle;
    }
    return 0.5 * (low + high);
}


bool mus__val_curve_meet(const mus__val_curve *curve, const double *p, double angle, double *out)
{
    const double d[2] = {mus__cos(angle * MUS__DEGREE), mus__sin(angle * MUS__DEGREE)};
    double ahead = INFINITY, behind = -INFINITY, a[2], b[2];
    if (curve->n == 0) return false;
    mus__val_curve_at(curve, 0.0, a);
    for (int32_t i = 1; i <= curve->n * CURVE_CHORDS; i++, memcpy(a, b, sizeof a)) {
        mus__val_curve_at(curve, (double)i / CURVE_CHORDS, b);
        const double sa = d[0] * (a[1] - p[1]) - d[1] * (a[0] - p[0]), sb = d[0] * (b[1] - p[1]) - d[1] * (b[0] - p[0]);
        const bool touch = fabs(sa) < 1e-9 || fabs(sb) < 1e-9;
        if (!touch && (sa >= 0.0) == (sb >= 0.0)) continue;
        double x[2] = {a[0], a[1]};
        const double low = (i - 1.0) / CURVE_CHORDS, high = (double)i / CURVE_CHORDS;
        if (!touch) mus__val_curve_at(curve, curve_cross(curve, low, high, p, d), x);
        else if (fabs(sb) < fabs(sa)) memcpy(x, b, sizeof x);
        const double s = d[0] * (x[0] - p[0]) + d[1] * (x[1] - p[1]);
        if (fabs(s) < 1e-6) continue; /* the point itself */
        if (s > 0.0) ahead = fmin(ahead, s);
        else behind = fmax(behind, s);
    }
    const double s = isfinite(ahead) ? ahead : behind;
    if (!isfinite(s)) return false;
    out[0] = p[0] + s * d[0], out[1] = p[1] + s * d[1];
    return true;
}
