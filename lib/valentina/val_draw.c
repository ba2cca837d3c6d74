/*
 * val_draw.c: the drawing: increments and tools in the order of the file, each an object under its id, and the values
 * that formulas take of them: Line_A_B, AngleLine_A_B, Spl_A_B and their like.
 *
 * A tool that cuts a curve makes the two parts under the next two ids. A tool that muslin does not know is an error
 * that names it.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/elementary.h"
#include "exchange/file_read.h"
#include "valentina/val_draw.h"

#define DRAW_SHORT 1.0 /* [mm] Valentina cuts no shorter part off a curve */


static int64_t draw_id(const mus__val_job *job, int32_t e, const char *attribute)
{
    const char *text = mus__val_attribute(&job->xml, e, attribute);
    return text != NULL ? strtol(text, NULL, 10) : -1;
}


/* name a curve by its ends, or an arc by its centre and id */
static mus_status draw_name_curve(mus__val_job *job, mus__val_object *o, int32_t e, int64_t id)
{
    char name[MUS__VAL_NAME];
    const char *copy = mus__val_attribute(&job->xml, e, "duplicate");
    if (o->curve.arc)
        snprintf(name, sizeof name, "Arc_%.150s_%lld", o->ends[0], (long long)id);
    else
        snprintf(name, sizeof name, "%s_%.150s_%.150s%s%.20s", o->name, o->ends[0], o->ends[1], copy != NULL ? "_" : "",
                 copy != NULL ? copy : "");
    return mus__val_curve_name(job, o, name);
}


/* put length and angle of the way between two points under their names: Line_A_B, AngleLine_A_B, and back. Two drawings
 * may use one name for two points: a formula means the two that stood beside each other in a tool */
static mus_status draw_line(mus__val_job *job, const mus__val_object *a, const mus__val_object *b)
{
    mus_status status = MUS_OK;
    for (int32_t k = 0; k < 2 && status == MUS_OK; k++) {
        char name[MUS__VAL_NAME];
        const mus__val_object *from = k == 0 ? a : b, *to = k == 0 ? b : a;
        snprintf(name, sizeof name, "Line_%.200s_%.200s", from->name, to->name);
        const double way = mus__hypot(to->xy[0] - from->xy[0], to->xy[1] - from->xy[1]);
        status = mus__val_value(job, "", name, way / job->unit);
        if (status == MUS_OK) status = mus__val_value(job, "Angle", name, mus__val_angle(from->xy, to->xy));
    }
    return status;
}


/* the ways from a new point to the points that its tool names; with `point` NULL that of a line */
static mus_status draw_lines(mus__val_job *job, int32_t e, const mus__val_object *point)
{
    static const char *const ends[] = {"basePoint", "firstPoint", "secondPoint", "thirdPoint", "p1Line", "p2Line",
                                       "pShoulder", "center", "p1Line1", "p2Line1", "p1Line2", "p2Line2", "axisP1",
                                       "axisP2", "c1Center", "c2Center", "tangent"};
    mus_status status = MUS_OK;
    for (size_t i = 0; i < sizeof ends / sizeof *ends && status == MUS_OK; i++) {
        if (mus__val_attribute(&job->xml, e, ends[i]) == NULL || (point == NULL && i != 2)) continue;
        const mus__val_object *o = mus__val_object_of(job, e, ends[i], MUS__VAL_POINT, &status);
        const mus__val_object *other =
            point != NULL ? point : mus__val_object_of(job, e, "firstPoint", MUS__VAL_POINT, &status);
        if (o != NULL && other != NULL) status = draw_line(job, other, o);
    }
    return status;
}


/* ---- curves ---- */

/* a cubic from its ends, angles and lengths of the controls */
static mus_status draw_cubic(mus__val_job *job, mus__val_curve *curve, const double *from, const double *to,
                             const double *angles, const double *lengths)
{
    double c[8] = {from[0], from[1], 0, 0, 0, 0, to[0], to[1]};
    mus__val_polar(from, lengths[0], angles[0], c + 2);
    mus__val_polar(to, lengths[1], angles[1], c + 4);
    return mus__val_curve_add(job->source, curve, c);
}


/* the length of a control in the old forms, before its asymmetry: that of a quarter circle between the ends */
static double draw_reach(const double *from, const double *to, double curvature)
{
    const double radius = mus__hypot(to[0] - from[0], to[1] - from[1]) / sqrt(2.0);
    return curvature * radius * 4.0 / 3.0 * mus__tan(22.5 * MUS__DEGREE);
}


/* a spline of one cubic: with formulas, in the old form, or by its four points */
static mus_status draw_spline(mus__val_job *job, int32_t e, const char *type, mus__val_object *o)
{
    mus_status status = MUS_OK;
    const mus__val_object *p1 = mus__val_object_of(job, e, "point1", MUS__VAL_POINT, &status);
    const mus__val_object *p4 = mus__val_object_of(job, e, "point4", MUS__VAL_POINT, &status);
    if (p1 == NULL || p4 == NULL) return status;
    o->ends[0] = p1->name, o->ends[1] = p4->name;
    if (strcmp(type, "cubicBezier") == 0) {
        const mus__val_object *p2 = mus__val_object_of(job, e, "point2", MUS__VAL_POINT, &status);
        const mus__val_object *p3 = mus__val_object_of(job, e, "point3", MUS__VAL_POINT, &status);
        if (p2 == NULL || p3 == NULL) return status;
        const double c[8] = {p1->xy[0], p1->xy[1], p2->xy[0], p2->xy[1], p3->xy[0], p3->xy[1], p4->xy[0], p4->xy[1]};
        return mus__val_curve_add(job->source, &o->curve, c);
    }
    const double angles[2] = {mus__val_number(job, e, "angle1", &status), mus__val_number(job, e, "angle2", &status)};
    double lengths[2];
    if (strcmp(type, "simple") == 0) {
        const double reach = draw_reach(p1->xy, p4->xy, mus__val_number(job, e, "kCurve", &status));
        lengths[0] = reach * mus__val_number(job, e, "kAsm1", &status);
        lengths[1] = reach * mus__val_number(job, e, "kAsm2", &status);
    } else {
        lengths[0] = mus__val_length(job, e, "length1", &status);
        lengths[1] = mus__val_length(job, e, "length2", &status);
    }
    return status == MUS_OK ? draw_cubic(job, &o->curve, p1->xy, p4->xy, angles, lengths) : status;
}


/* angles and lengths of the controls of a spline path from the point `a` to the point `b` */
static void draw_controls(mus__val_job *job, const int32_t *points, double (*xy)[2], double curvature,
                          double *angles, double *lengths, mus_status *status)
{
    if (mus__val_attribute(&job->xml, points[0], "angle") != NULL) { /* the old form */
        const double reach = draw_reach(xy[0], xy[1], curvature);
        angles[0] = mus__val_number(job, points[0], "angle", status);
        angles[1] = mus__val_number(job, points[1], "angle", status) + 180.0;
        lengths[0] = reach * mus__val_number(job, points[0], "kAsm2", status);
        lengths[1] = reach * mus__val_number(job, points[1], "kAsm1", status);
        return;
    }
    angles[0] = mus__val_number(job, points[0], "angle2", status);
    angles[1] = mus__val_number(job, points[1], "angle1", status);
    lengths[0] = mus__val_length(job, points[0], "length2", status);
    lengths[1] = mus__val_length(job, points[1], "length1", status);
}


/* a path of splines */
static mus_status draw_path(mus__val_job *job, int32_t e, const char *type, mus__val_object *o)
{
    mus_status status = MUS_OK;
    const bool bezier = strcmp(type, "cubicBezierPath") == 0, old = strcmp(type, "path") == 0;
    const double curvature = old ? mus__val_number(job, e, "kCurve", &status) : 1.0;
    int32_t points[2] = {MUS_NONE, MUS_NONE}, n = 0;
    double xy[2][2], c[8];
    for (int32_t i = mus__val_child(&job->xml, e, "pathPoint", MUS_NONE); i != MUS_NONE && status == MUS_OK;
         i = mus__val_child(&job->xml, e, "pathPoint", i), n++) {
        const mus__val_object *p = mus__val_object_of(job, i, "pSpline", MUS__VAL_POINT, &status);
        if (p == NULL) return status;
        if (n == 0) o->ends[0] = p->name;
        o->ends[1] = p->name;
        points[1] = i;
        memcpy(xy[1], p->xy, sizeof xy[1]);
        if (bezier) {
            if (n > 0 && n % 3 == 0) {
                memcpy(c + 6, p->xy, sizeof p->xy);
                status = mus__val_curve_add(job->source, &o->curve, c);
            }
            memcpy(c + 2 * (n % 3), p->xy, sizeof p->xy);
        } else if (n > 0) {
            double angles[2], lengths[2];
            draw_controls(job, points, xy, curvature, angles, lengths, &status);
            if (status == MUS_OK) status = draw_cubic(job, &o->curve, xy[0], xy[1], angles, lengths);
        }
        points[0] = points[1];
        memcpy(xy[0], xy[1], sizeof xy[0]);
    }
    if (status == MUS_OK && o->curve.n == 0) return mus__val_fail(job, e, MUS_ERR_FORMAT, "has too few points", "");
    return status;
}


static mus_status draw_arc(mus__val_job *job, int32_t e, const char *type, mus__val_object *o)
{
    mus_status status = MUS_OK;
    const mus__val_object *centre = mus__val_object_of(job, e, "center", MUS__VAL_POINT, &status);
    if (centre == NULL) return status;
    const double radius = mus__val_length(job, e, "radius", &status), from = mus__val_number(job, e, "angle1", &status);
    double to;
    if (strcmp(type, "arcWithLength") == 0) {
        to = from + mus__val_length(job, e, "length", &status) / radius / MUS__DEGREE;
    } else {
        to = mus__val_number(job, e, "angle2", &status);
        to += 360.0 * ceil((from - to) / 360.0 + 1e-12); /* within one turn; equal angles are a whole circle */
    }
    o->ends[0] = o->ends[1] = centre->name;
    if (job->missing[0] != '\0' && isnan(radius + to)) return status;
    if (status == MUS_OK && (!(radius > 0.0) || !(fabs(to - from) <= 720.0)))
        return mus__val_fail(job, e, MUS_ERR_PATTERN, "radius or angle is out of range; centre", centre->name);
    return status == MUS_OK ? mus__val_curve_arc(job->source, &o->curve, centre->xy, radius, from, to) : status;
}


static mus_status draw_curve(mus__val_job *job, int32_t e, const char *type)
{
    mus_status status = MUS_OK;
    const bool arc = strcmp(job->xml.elements[e].tag, "arc") == 0;
    const bool path = strcmp(type, "path") == 0 || strcmp(type, "pathInteractive") == 0 ||
                      strcmp(type, "cubicBezierPath") == 0;
    const bool spline = strcmp(type, "simple") == 0 || strcmp(type, "simpleInteractive") == 0 ||
                        strcmp(type, "cubicBezier") == 0 || strcmp(type, "arcWithLength") == 0;
    if (!path && !spline) return mus__val_fail(job, e, MUS_ERR_UNSUPPORTED, "muslin does not know its type", type);
    const int64_t id = draw_id(job, e, "id");
    mus__val_object *o = mus__val_new(job, e, id, MUS__VAL_CURVE, arc ? "Arc" : path ? "SplPath" : "Spl", &status);
    if (o == NULL) return status;
    status = arc ? draw_arc(job, e, type, o) : path ? draw_path(job, e, type, o) : draw_spline(job, e, type, o);
    return status == MUS_OK ? draw_name_curve(job, o, e, id) : status;
}


/* ---- points ---- */

/* the two parts of a curve at the parameter t, under the ids behind that of the point unless the file uses those; their
 * values under their names in any case */
static mus_status draw_parts(mus__val_job *job, int32_t e, const mus__val_object *curve, double t, int64_t id,
                             const char *name)
{
    mus_status status = MUS_OK;
    for (int32_t k = 0; k < 2 && status == MUS_OK; k++) {
        mus__val_object none = {.name = curve->name}, *part = &none;
        const mus__val_object *at = id + 1 + k < job->nobject ? &job->objects[id + 1 + k] : NULL;
        if (at != NULL && !at->declared && at->kind == MUS__VAL_NOTHING)
            part = mus__val_new(job, e, id + 1 + k, MUS__VAL_CURVE, curve->name, &status);
        if (part == NULL) return status;
        part->ends[0] = k == 0 || curve->curve.arc ? curve->ends[0] : name;
        part->ends[1] = k == 1 || curve->curve.arc ? curve->ends[1] : name;
        status = mus__val_curve_part(job->source, &curve->curve, k == 0 ? 0.0 : t, k == 0 ? t : curve->curve.n,
                                     &part->curve);
        if (status == MUS_OK) status = draw_name_curve(job, part, e, id + 1 + k);
        mus_context_alloc(job->source->context, none.curve.cubic, 0);
    }
    return status;
}


static mus_status draw_cut(mus__val_job *job, int32_t e, const char *attribute)
{
    mus_status status = MUS_OK;
    const int64_t id = draw_id(job, e, "id");
    const char *name = mus__val_attribute(&job->xml, e, "name");
    const mus__val_object *curve = mus__val_object_of(job, e, attribute, MUS__VAL_CURVE, &status);
    if (curve == NULL) return status;
    const double whole = mus__val_curve_length(&curve->curve);
    job->current = whole / job->unit;
    double length = mus__val_length(job, e, "length", &status);
    job->current = NAN;
    mus__val_object *o = mus__val_new(job, e, id, MUS__VAL_POINT, name, &status);
    if (o == NULL) return status;
    length = fmin(fmax(length, DRAW_SHORT), whole - DRAW_SHORT);
    const double t = mus__val_curve_along(&curve->curve, length);
    mus__val_curve_at(&curve->curve, t, o->xy);
    return draw_parts(job, e, curve, t, id, name);
}


/* p turned round a centre */
static void draw_turn(const double *centre, double angle, const double *p, double *out)
{
    const double a = angle * MUS__DEGREE, c = mus__cos(a), s = mus__sin(a);
    const double d[2] = {p[0] - centre[0], p[1] - centre[1]};
    out[0] = centre[0] + c * d[0] - s * d[1], out[1] = centre[1] + s * d[0] + c * d[1];
}


/* a dart's two new ends on the base line: it is straight once the dart is closed */
static mus_status draw_darts(mus__val_job *job, int32_t e)
{
    static const char *const names[] = {"baseLineP1", "baseLineP2", "dartP1", "dartP2", "dartP3"};
    mus_status status = MUS_OK;
    const double *p[5];
    for (int32_t i = 0; i < 5; i++) {
        const mus__val_object *o = mus__val_object_of(job, e, names[i], MUS__VAL_POINT, &status);
        if (o == NULL) return status;
        p[i] = o->xy;
    }
    const double turn = mus__val_angle(p[3], p[4]) - mus__val_angle(p[3], p[2]);
    double closed[2], u[2], v[2];
    draw_turn(p[3], -turn, p[1], closed);
    for (int32_t k = 0; k < 2; k++) u[k] = closed[k] - p[0][k], v[k] = p[2][k] - p[3][k];
    const double cross = u[0] * v[1] - u[1] * v[0];
    if (fabs(cross) < 1e-12) return mus__val_fail(job, e, MUS_ERR_PATTERN, "its lines are parallel", "");
    const double t = ((p[3][0] - p[0][0]) * v[1] - (p[3][1] - p[0][1]) * v[0]) / cross;
    const double first[2] = {p[0][0] + t * u[0], p[0][1] + t * u[1]}, *tip = p[3];
    for (int32_t k = 0; k < 2; k++) {
        mus__val_object *o = mus__val_new(job, e, draw_id(job, e, k == 0 ? "point1" : "point2"), MUS__VAL_POINT,
                                          mus__val_attribute(&job->xml, e, k == 0 ? "name1" : "name2"), &status);
        if (o == NULL) return status;
        draw_turn(tip, k == 0 ? 0.0 : turn, first, o->xy);
    }
    return status;
}


static mus_status draw_point(mus__val_job *job, int32_t e, const char *type)
{
    mus_status status = MUS_OK;
    double xy[2] = {0.0, 0.0};
    if (strcmp(type, "cutSpline") == 0) return draw_cut(job, e, "spline");
    if (strcmp(type, "cutSplinePath") == 0) return draw_cut(job, e, "splinePath");
    if (strcmp(type, "cutArc") == 0) return draw_cut(job, e, "arc");
    if (strcmp(type, "trueDarts") == 0) return draw_darts(job, e);
    if (strcmp(type, "single") == 0) {
        xy[0] = mus__val_length(job, e, "x", &status);
        xy[1] = -mus__val_length(job, e, "y", &status);
    } else if (!mus__val_point(job, e, type, xy, &status)) {
        return mus__val_fail(job, e, MUS_ERR_UNSUPPORTED, "muslin does not know its type", type);
    }
    if (status == MUS_OK && job->missing[0] == '\0' && !(fabs(xy[0]) < 1e7 && fabs(xy[1]) < 1e7))
        return mus__val_fail(job, e, MUS_ERR_PATTERN, "lies beyond 10 km: point",
                             mus__val_attribute(&job->xml, e, "name"));
    const int64_t id = draw_id(job, e, "id");
    const char *name = mus__val_attribute(&job->xml, e, "name");
    mus__val_object *o = mus__val_new(job, e, id, MUS__VAL_POINT, name, &status);
    if (o == NULL) return status;
    memcpy(o->xy, xy, sizeof o->xy);
    status = draw_lines(job, e, o);
    if (status != MUS_OK || strcmp(type, "curveIntersectAxis") != 0) return status;
    const mus__val_object *curve = mus__val_object_of(job, e, "curve", MUS__VAL_CURVE, &status);
    double away;
    if (curve == NULL) return status;
    return draw_parts(job, e, curve, mus__val_curve_nearest(&curve->curve, xy, &away), id, name);
}


/* ---- operations ---- */

/* keep a copy of a name until the job ends; NULL without memory */
static const char *draw_keep(mus__val_job *job, const char *name, mus_status *status)
{
    const size_t n = strlen(name) + 1;
    mus__val_kept *kept = mus_context_alloc(job->source->context, NULL, sizeof *kept + n);
    if (kept == NULL) {
        *status = mus__source_fail(job->source, 0, MUS_ERR_MEMORY, "no memory for a name");
        return NULL;
    }
    kept->next = job->kept;
    job->kept = kept;
    return memcpy(kept->text, name, n);
}


/* how an operation moves a place: m (2 x 3) */
static mus_status draw_motion(mus__val_job *job, int32_t e, const char *type, double *m)
{
    mus_status status = MUS_OK;
    double from[2] = {0.0, 0.0}, axis = 0.0, turn = 0.0, shift[2] = {0.0, 0.0};
    bool flip = false;
    const mus__val_object *o = NULL;
    const bool rotation = strcmp(type, "rotation") == 0, moving = strcmp(type, "moving") == 0;
    if (rotation || strcmp(type, "flippingByAxis") == 0) {
        o = mus__val_object_of(job, e, "center", MUS__VAL_POINT, &status);
        if (o == NULL) return status;
        memcpy(from, o->xy, sizeof from);
        const char *kind = mus__val_attribute(&job->xml, e, "axisType");
        flip = !rotation;
        axis = kind != NULL && strcmp(kind, "1") == 0 ? 90.0 : 0.0;
        if (rotation) turn = mus__val_number(job, e, "angle", &status);
    } else if (strcmp(type, "flippingByLine") == 0) {
        o = mus__val_object_of(job, e, "p1Line", MUS__VAL_POINT, &status);
        const mus__val_object *other = mus__val_object_of(job, e, "p2Line", MUS__VAL_POINT, &status);
        if (o == NULL || other == NULL) return status;
        memcpy(from, o->xy, sizeof from);
        flip = true;
        axis = mus__val_angle(o->xy, other->xy);
    } else if (moving) {
        const double angle = mus__val_number(job, e, "angle", &status);
        mus__val_polar(shift, mus__val_length(job, e, "length", &status), angle, shift);
        if (mus__val_attribute(&job->xml, e, "rotationAngle") != NULL)
            turn = mus__val_number(job, e, "rotationAngle", &status);
        if (turn != 0.0) return mus__val_fail(job, e, MUS_ERR_UNSUPPORTED, "muslin does not know its rotation", type);
    } else {
        return mus__val_fail(job, e, MUS_ERR_UNSUPPORTED, "muslin does not know its type", type);
    }
    const double a = (flip ? 2.0 * axis : turn) * MUS__DEGREE, c = mus__cos(a), s = mus__sin(a);
    m[0] = c, m[1] = flip ? s : -s, m[3] = s, m[4] = flip ? -c : c;
    m[2] = from[0] + shift[0] - m[0] * from[0] - m[1] * from[1];
    m[5] = from[1] + shift[1] - m[3] * from[0] - m[4] * from[1];
    return status;
}


static void draw_apply(const double *m, const double *p, double *out)
{
    const double x = m[0] * p[0] + m[1] * p[1] + m[2];
    out[1] = m[3] * p[0] + m[4] * p[1] + m[5];
    out[0] = x;
}


/* the moved copy of an object under a new id */
static mus_status draw_copy(mus__val_job *job, int32_t e, const mus__val_object *source, int64_t id, const double *m,
                            const char *name)
{
    mus_status status = MUS_OK;
    mus__val_object *o = mus__val_new(job, e, id, source->kind, source->kind == MUS__VAL_POINT ? name : source->name,
                                      &status);
    if (o == NULL) return status;
    draw_apply(m, source->xy, o->xy);
    if (source->kind == MUS__VAL_POINT) return MUS_OK;
    memcpy(o->ends, source->ends, sizeof o->ends);
    o->title = name;
    status = mus__val_curve_part(job->source, &source->curve, 0.0, source->curve.n, &o->curve);
    for (int32_t i = 0; i < 4 * o->curve.n && status == MUS_OK; i++)
        draw_apply(m, o->curve.cubic + 2 * (ptrdiff_t)i, o->curve.cubic + 2 * (ptrdiff_t)i);
    if (o->curve.arc && status == MUS_OK) {
        draw_apply(m, source->curve.centre, o->curve.centre);
        const double span = source->curve.angle[1] - source->curve.angle[0];
        o->curve.angle[0] = mus__val_angle(o->curve.centre, o->curve.cubic);
        o->curve.angle[1] = o->curve.angle[0] + (m[0] * m[4] - m[1] * m[3] < 0.0 ? -span : span);
    }
    return status == MUS_OK ? mus__val_curve_name(job, o, name) : status;
}


static mus_status draw_operation(mus__val_job *job, int32_t e, const char *type)
{
    double m[6] = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0};
    mus_status status = draw_motion(job, e, type, m);
    const int32_t source = mus__val_child(&job->xml, e, "source", MUS_NONE);
    const int32_t made = mus__val_child(&job->xml, e, "destination", MUS_NONE);
    const char *suffix = mus__val_attribute(&job->xml, e, "suffix");
    if (status != MUS_OK) return status;
    if (source == MUS_NONE || made == MUS_NONE)
        return mus__val_fail(job, e, MUS_ERR_FORMAT, "lacks source or destination", type);
    int32_t a = mus__val_child(&job->xml, source, "item", MUS_NONE);
    int32_t b = mus__val_child(&job->xml, made, "item", MUS_NONE);
    for (; a != MUS_NONE && b != MUS_NONE && status == MUS_OK;
         a = mus__val_child(&job->xml, source, "item", a), b = mus__val_child(&job->xml, made, "item", b)) {
        const mus__val_object *o = mus__val_object_of(job, a, "idObject", MUS__VAL_NOTHING, &status);
        if (o == NULL) break;
        char name[MUS__VAL_NAME + 64];
        const int64_t id = draw_id(job, b, "idObject");
        const char *copy = suffix != NULL ? suffix : "";
        if (o->kind == MUS__VAL_POINT) snprintf(name, sizeof name, "%.300s%.60s", o->name, copy);
        else if (o->curve.arc) snprintf(name, sizeof name, "Arc_%.150s%.60s_%lld", o->ends[0], copy, (long long)id);
        else if (o->title != NULL) snprintf(name, sizeof name, "%.400s%.60s", o->title, copy);
        else snprintf(name, sizeof name, "%.20s_%.150s_%.150s%.60s", o->name, o->ends[0], o->ends[1], copy);
        const char *kept = draw_keep(job, name, &status);
        if (kept != NULL) status = draw_copy(job, e, o, id, m, kept);
    }
    return status;
}


mus_status mus__val_draw(mus__val_job *job, int32_t draw)
{
    mus_status status = MUS_OK;
    const int32_t list = mus__val_child(&job->xml, draw, "calculation", MUS_NONE);
    if (list == MUS_NONE) return MUS_OK;
    for (int32_t e = mus__val_child(&job->xml, list, NULL, MUS_NONE); e != MUS_NONE && status == MUS_OK;
         e = mus__val_child(&job->xml, list, NULL, e)) {
        const char *tag = job->xml.elements[e].tag, *type = mus__val_attribute(&job->xml, e, "type");
        job->current = NAN;
        if (type == NULL) type = "";
        if (strcmp(tag, "line") == 0) status = draw_lines(job, e, NULL);
        else if (strcmp(tag, "point") == 0) status = draw_point(job, e, type);
        else if (strcmp(tag, "spline") == 0 || strcmp(tag, "arc") == 0) status = draw_curve(job, e, type);
        else if (strcmp(tag, "operation") == 0) status = draw_operation(job, e, type);
        else status = mus__val_fail(job, e, MUS_ERR_UNSUPPORTED, "muslin does not know this tool, type", type);
    }
    return status;
}
