/*
 * val_points.c: the tools that place one point, from points, lines, circles and curves before it.
 *
 * Where two places fit, the choice is Valentina's (0.7), told at each tool.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/elementary.h"
#include "valentina/val_draw.h"

#define POINTS_PIXEL (25.4 / 96.0) /* [mm] the unit in which Valentina draws */
#define POINTS_STEPS 4000 /* most steps of a search for a place; chosen: a grazing circle of 100 m takes as many */
#define POINTS_NEAR 1e-6 /* [mm] places that are one; chosen: far below what a formula rounds */


static double points_distance(const double *a, const double *b)
{
    return mus__hypot(b[0] - a[0], b[1] - a[1]);
}


/* where the lines a b and c d meet; false for parallel ones */
static bool points_lines(const double *a, const double *b, const double *c, const double *d, double *out)
{
    const double u[2] = {b[0] - a[0], b[1] - a[1]}, v[2] = {d[0] - c[0], d[1] - c[1]};
    const double cross = u[0] * v[1] - u[1] * v[0];
    if (!(fabs(cross) > 1e-12 * (mus__hypot(u[0], u[1]) * mus__hypot(v[0], v[1])))) return false;
    const double t = ((c[0] - a[0]) * v[1] - (c[1] - a[1]) * v[0]) / cross;
    out[0] = a[0] + t * u[0], out[1] = a[1] + t * u[1];
    return true;
}


/* the foot of the perpendicular from p on the line a b */
static void points_foot(const double *a, const double *b, const double *p, double *out)
{
    const double d[2] = {b[0] - a[0], b[1] - a[1]}, dd = d[0] * d[0] + d[1] * d[1];
    const double t = dd > 0.0 ? ((p[0] - a[0]) * d[0] + (p[1] - a[1]) * d[1]) / dd : 0.0;
    out[0] = a[0] + t * d[0], out[1] = a[1] + t * d[1];
}


int32_t mus__val_circle_line(const double *centre, double radius, const double *a, const double *b, double *out)
{
    double foot[2];
    const double length = points_distance(a, b);
    points_foot(a, b, centre, foot);
    const double off = points_distance(centre, foot);
    if (!(length > 0.0) || off > radius + POINTS_NEAR) return 0;
    const double half = sqrt(fmax(radius * radius - off * off, 0.0));
    for (int32_t k = 0; k < 2; k++) {
        out[k] = foot[k] - half * (b[k] - a[k]) / length;
        out[2 + k] = foot[k] + half * (b[k] - a[k]) / length;
    }
    return half > POINTS_NEAR ? 2 : 1;
}


int32_t mus__val_circles(const double *c1, double r1, const double *c2, double r2, double *out)
{
    const double d = points_distance(c1, c2);
    if (!(d > POINTS_NEAR) || d > r1 + r2 + POINTS_NEAR || d < fabs(r1 - r2) - POINTS_NEAR) return 0;
    const double a = (r1 * r1 - r2 * r2 + d * d) / (2.0 * d), h = sqrt(fmax(r1 * r1 - a * a, 0.0));
    const double u[2] = {(c2[0] - c1[0]) / d, (c2[1] - c1[1]) / d};
    out[0] = c1[0] + a * u[0] + h * u[1], out[1] = c1[1] + a * u[1] - h * u[0];
    out[2] = c1[0] + a * u[0] - h * u[1], out[3] = c1[1] + a * u[1] + h * u[0];
    return h > POINTS_NEAR ? 2 : 1;
}


/* the places of several points that attributes name */
static bool points_take(mus__val_job *job, int32_t e, int32_t n, const char *const *attributes, double (*xy)[2],
                        mus_status *status)
{
    for (int32_t i = 0; i < n; i++) {
        const mus__val_object *o = mus__val_object_of(job, e, attributes[i], MUS__VAL_POINT, status);
        if (o == NULL) return false;
        memcpy(xy[i], o->xy, sizeof xy[i]);
    }
    return true;
}


/* a tool finds no place: Valentina goes on, since a piece may not need the point, and so does the reader */
static void points_none(mus__val_job *job, int32_t e, const char *what, double *out)
{
    const char *name = mus__val_attribute(&job->xml, e, "name");
    out[0] = out[1] = NAN;
    if (job->missing[0] == '\0')
        snprintf(job->missing, sizeof job->missing, "point %.60s of line %lld has no place: %s",
                 name != NULL ? name : "", (long long)job->xml.elements[e].line, what);
}


/* tools on one line: along it, square to it, the half of an angle */
static bool points_on_line(mus__val_job *job, int32_t e, const char *type, double *out, mus_status *status)
{
    static const char *const ends[] = {"firstPoint", "secondPoint", "thirdPoint"};
    double p[3][2];
    if (strcmp(type, "alongLine") == 0 || strcmp(type, "normal") == 0) {
        if (!points_take(job, e, 2, ends, p, status)) return true;
        const bool along = type[0] == 'a';
        job->current = points_distance(p[0], p[1]) / job->unit;
        const double length = mus__val_length(job, e, "length", status), angle = mus__val_angle(p[0], p[1]);
        mus__val_polar(p[0], length, along ? angle : angle + 90.0 + mus__val_number(job, e, "angle", status), out);
    } else if (strcmp(type, "bisector") == 0) {
        if (!points_take(job, e, 3, ends, p, status)) return true;
        const double from = mus__val_angle(p[1], p[0]);
        double turn = mus__val_angle(p[1], p[2]) - from;
        turn += turn > 180.0 ? -360.0 : turn <= -180.0 ? 360.0 : 0.0;
        mus__val_polar(p[1], mus__val_length(job, e, "length", status), from + 0.5 * turn, out);
    } else if (strcmp(type, "endLine") == 0) {
        static const char *const base[] = {"basePoint"};
        if (!points_take(job, e, 1, base, p, status)) return true;
        mus__val_polar(p[0], mus__val_length(job, e, "length", status), mus__val_number(job, e, "angle", status), out);
    } else if (strcmp(type, "pointOfIntersection") == 0) {
        if (!points_take(job, e, 2, ends, p, status)) return true;
        out[0] = p[0][0], out[1] = p[1][1];
    } else {
        return false;
    }
    job->current = NAN;
    return true;
}


/*
 * The apex of a right angle over the points p[2] and p[3], beyond their line in the direction of the axis from p[0] to
 * p[1]; false when the two lines are parallel. Valentina does not compute the place, it searches: from the place where
 * the lines cross in steps of a pixel of 1/96 inch, from the second on, to the first place at which the legs a and b
 * and the hypotenuse c, each cut to whole pixels, have a a + b b >= c c. This is up to a pixel from the right angle,
 * and drawings have the place that was found. Places where a and b are too short even uncut are passed over.
 */
static bool points_right_angle(double (*p)[2], double *out)
{
    const double c = points_distance(p[2], p[3]) / POINTS_PIXEL, axis = points_distance(p[0], p[1]);
    double start[2], middle[2], behind[2], u[2], places[4];
    if (!points_lines(p[0], p[1], p[2], p[3], start)) return false;
    for (int32_t k = 0; k < 2; k++) {
        u[k] = POINTS_PIXEL * (p[1][k] - p[0][k]) / axis;
        behind[k] = start[k] + u[k];
        middle[k] = 0.5 * (p[2][k] + p[3][k]);
    }
    /* a a + b b = 2 r r + c c / 2 at the distance r from the middle of the hypotenuse */
    const double least = 0.5 * c * c - 2.0 * c, radius = POINTS_PIXEL * sqrt(0.5 * fmax(least, 0.0));
    const int32_t n = mus__val_circle_line(middle, radius, start, behind, places);
    double step = 2.0;
    if (n > 0) {
        const double *x = places + 2 * (n - 1);
        const double ahead = ((x[0] - start[0]) * u[0] + (x[1] - start[1]) * u[1]) / (POINTS_PIXEL * POINTS_PIXEL);
        step = fmax(step, floor(ahead));
    }
    for (int32_t i = 0; i < POINTS_STEPS; i++, step += 1.0) {
        for (int32_t k = 0; k < 2; k++) out[k] = start[k] + step * u[k];
        const double a = floor(points_distance(out, p[2]) / POINTS_PIXEL);
        const double b = floor(points_distance(out, p[3]) / POINTS_PIXEL);
        if (floor(c) * floor(c) <= a * a + b * b) return true;
    }
    return false;
}


/* tools that cross lines */
static bool points_crossed(mus__val_job *job, int32_t e, const char *type, double *out, mus_status *status)
{
    static const char *const lines[] = {"p1Line1", "p2Line1", "p1Line2", "p2Line2"};
    static const char *const axis[] = {"p1Line", "p2Line", "basePoint"};
    static const char *const shoulder[] = {"p1Line", "p2Line", "pShoulder"};
    static const char *const triangle[] = {"axisP1", "axisP2", "firstPoint", "secondPoint"};
    double p[4][2], places[4];
    if (strcmp(type, "lineIntersect") == 0) {
        if (points_take(job, e, 4, lines, p, status) && !points_lines(p[0], p[1], p[2], p[3], out))
            points_none(job, e, "its lines are parallel", out);
    } else if (strcmp(type, "lineIntersectAxis") == 0) {
        if (!points_take(job, e, 3, axis, p, status)) return true;
        mus__val_polar(p[2], 100.0, mus__val_number(job, e, "angle", status), p[3]);
        if (!points_lines(p[0], p[1], p[2], p[3], out)) points_none(job, e, "its lines are parallel", out);
    } else if (strcmp(type, "height") == 0) {
        if (points_take(job, e, 3, axis, p, status)) points_foot(p[0], p[1], p[2], out);
    } else if (strcmp(type, "shoulder") == 0) {
        /* beyond the second end of the line, where the distance from the shoulder is reached */
        if (!points_take(job, e, 3, shoulder, p, status)) return true;
        const double length = mus__val_length(job, e, "length", status);
        const int32_t n = mus__val_circle_line(p[2], length, p[0], p[1], places);
        memcpy(out, n == 0 ? p[1] : places + 2 * (n - 1), 2 * sizeof *out);
        if (points_distance(p[2], p[1]) > length) memcpy(out, p[1], 2 * sizeof *out);
    } else if (strcmp(type, "triangle") == 0) {
        if (points_take(job, e, 4, triangle, p, status) && !points_right_angle(p, out))
            points_none(job, e, "no right angle on its axis", out);
    } else {
        return false;
    }
    return true;
}


/* of the two places of a circle on the line a b the one between a and b; with both or neither the one nearer to a */
static void points_contact(double (*p)[2], const double *places, int32_t n, double *out)
{
    bool on[2] = {true, true};
    for (int32_t k = 0; k < n; k++) {
        const double whole = points_distance(p[1], p[2]);
        const double *x = places + 2 * k;
        on[k] = points_distance(p[1], x) <= whole + 1e-3 && points_distance(p[2], x) <= whole + 1e-3;
    }
    const bool first = n == 1 || (on[0] != on[1] ? on[0]
                                  : points_distance(p[1], places) <= points_distance(p[1], places + 2));
    memcpy(out, places + (first ? 0 : 2), 2 * sizeof *out);
}


/* true when an angle lies on an arc */
static bool points_on_arc(const mus__val_curve *arc, const double *p)
{
    const double from = fmin(arc->angle[0], arc->angle[1]), to = fmax(arc->angle[0], arc->angle[1]);
    double angle = mus__val_angle(arc->centre, p);
    while (angle < from - 1e-6) angle += 360.0;
    while (angle - 360.0 >= from - 1e-6) angle -= 360.0;
    return angle <= to + 1e-6;
}


/* the first or second of the places, as crossPoint asks; with arcs the other one when only that lies on them */
static void points_choose(mus__val_job *job, int32_t e, int32_t n, const double *places,
                          const mus__val_curve *const *arcs, double *out)
{
    const char *cross = mus__val_attribute(&job->xml, e, "crossPoint");
    int32_t k = cross != NULL && strcmp(cross, "2") == 0 && n > 1;
    bool on[2] = {true, true};
    for (int32_t i = 0; i < n; i++)
        for (int32_t a = 0; a < 2; a++)
            on[i] = on[i] && (arcs[a] == NULL || points_on_arc(arcs[a], places + 2 * i));
    if (n > 1 && !on[k] && on[1 - k]) k = 1 - k;
    if (n == 0 || !on[k]) points_none(job, e, "its circles do not meet", out);
    else memcpy(out, places + 2 * k, 2 * sizeof *out);
}


/* tools on circles and curves */
static bool points_round(mus__val_job *job, int32_t e, const char *type, double *out, mus_status *status)
{
    static const char *const contact[] = {"center", "firstPoint", "secondPoint"};
    static const char *const centres[] = {"c1Center", "c2Center"};
    static const char *const base[] = {"basePoint"};
    static const char *const tangent[] = {"tangent", "cCenter"};
    const mus__val_curve *arcs[2] = {NULL, NULL};
    double p[3][2], places[4];
    if (strcmp(type, "pointOfContact") == 0) {
        if (!points_take(job, e, 3, contact, p, status)) return true;
        const int32_t n = mus__val_circle_line(p[0], mus__val_length(job, e, "radius", status), p[1], p[2], places);
        if (n == 0) points_none(job, e, "its circle does not meet its line", out);
        else points_contact(p, places, n, out);
    } else if (strcmp(type, "pointOfIntersectionCircles") == 0) {
        if (!points_take(job, e, 2, centres, p, status)) return true;
        const double r1 = mus__val_length(job, e, "c1Radius", status), r2 = mus__val_length(job, e, "c2Radius", status);
        points_choose(job, e, mus__val_circles(p[0], r1, p[1], r2, places), places, arcs, out);
    } else if (strcmp(type, "pointOfIntersectionArcs") == 0 || strcmp(type, "pointFromArcAndTangent") == 0) {
        const bool two = type[7] == 'I' || type[5] == 'O';
        const mus__val_object *a = mus__val_object_of(job, e, two ? "firstArc" : "arc", MUS__VAL_CURVE, status);
        const mus__val_object *b = two ? mus__val_object_of(job, e, "secondArc", MUS__VAL_CURVE, status) : a;
        if (a == NULL || b == NULL || (!two && !points_take(job, e, 1, tangent, p, status))) return true;
        arcs[0] = &a->curve, arcs[1] = two ? &b->curve : NULL;
        double r = b->curve.radius, middle[2] = {b->curve.centre[0], b->curve.centre[1]};
        if (!two) { /* the tangent's places lie on the circle over centre and point */
            for (int32_t k = 0; k < 2; k++) middle[k] = 0.5 * (p[0][k] + a->curve.centre[k]);
            r = points_distance(middle, p[0]);
        }
        points_choose(job, e, mus__val_circles(a->curve.centre, a->curve.radius, middle, r, places), places, arcs, out);
    } else if (strcmp(type, "pointFromCircleAndTangent") == 0) {
        if (!points_take(job, e, 2, tangent, p, status)) return true;
        const double middle[2] = {0.5 * (p[0][0] + p[1][0]), 0.5 * (p[0][1] + p[1][1])};
        const double r = mus__val_length(job, e, "cRadius", status);
        points_choose(job, e, mus__val_circles(p[1], r, middle, points_distance(middle, p[0]), places), places, arcs,
                      out);
    } else if (strcmp(type, "curveIntersectAxis") == 0) {
        const mus__val_object *curve = mus__val_object_of(job, e, "curve", MUS__VAL_CURVE, status);
        if (curve == NULL || !points_take(job, e, 1, base, p, status)) return true;
        if (!mus__val_curve_meet(&curve->curve, p[0], mus__val_number(job, e, "angle", status), out))
            points_none(job, e, "its line does not meet its curve", out);
    } else {
        return false;
    }
    return true;
}


bool mus__val_point(mus__val_job *job, int32_t element, const char *type, double *out, mus_status *status)
{
    return points_on_line(job, element, type, out, status) || points_crossed(job, element, type, out, status) ||
           points_round(job, element, type, out, status);
}
