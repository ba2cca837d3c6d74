/*
 * scan_frame.c: up, front and unit of a mesh, and the transformation into the body's frame.
 *
 * Up: the one of the mesh's six axis directions along which the lower third has two legs (two loops of similar area)
 *     and
 * the top one head. Front: seen from above the longest extent of the mesh is from left to right, since the arms are
 * spread; a direction within 6 degrees of an axis of the mesh is set to that axis; toes lie before ankles. Unit: the
 * one of metre, centimetre, millimetre and inch that makes the height 0.4 to 2.3 m, that of a person. Where two are
 * possible (60 units are 0.60 m or 1.52 m) the caller must say which.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/elementary.h"
#include "geom/vec.h"
#include "scan/scan_internal.h"

#define FRAME_LEGS 8     /* sections of the legs, from 0.10 of the height up; chosen: enough for a vote, FRAME_UP */
#define FRAME_HEADS 5    /* sections of the head, from 0.86 of the height up; chosen: enough for a vote, FRAME_UP */
/* least number of these 13 sections that must agree on up; chosen: fewer accept a wrong axis, more refuse scans with
 * holes */
#define FRAME_UP 10
/* [degrees] a direction this near to an axis of the mesh is set to it; chosen: above the error of a direction found */
#define FRAME_SNAP 6.0
/* least distance of toes before ankles, in parts of the height (1 cm); chosen: less does not tell front from back */
#define FRAME_TOES 0.006


/* a slicer of the whole mesh along axis `up`, 1 to 3, or against it, -1 to -3 */
static mus_status frame_slicer(const mus__scan_mesh *mesh, int32_t up, mus__slicer *out)
{
    const double origin[3] = {0.0, 0.0, 0.0};
    double axis[3] = {0.0, 0.0, 0.0}, side[3] = {0.0, 0.0, 0.0};
    const int32_t k = (up < 0 ? -up : up) - 1;
    axis[k] = up < 0 ? -1.0 : 1.0;
    side[(k + 1) % 3] = 1.0;
    return mus__slicer_make(mesh, origin, axis, side, 1e30, out);
}


/* number of sections with two legs below, and with one head above, as of a person upright along this slicer */
static mus_status frame_count(mus__slicer *slicer, int32_t *legs, int32_t *heads)
{
    const double height = slicer->high - slicer->low;
    const mus__section *section = &slicer->section;
    mus_status status = MUS_OK;
    *legs = *heads = 0;
    for (int32_t k = 0; k < FRAME_LEGS && status == MUS_OK; k++) {
        status = mus__slice(slicer, slicer->low + (0.10 + 0.04 * k) * height, "the mesh");
        if (section->loops < 2 || section->loop[1].area < 0.4 * section->loop[0].area) continue;
        if (section->loops == 2 || section->loop[2].area < 0.5 * section->loop[1].area) ++*legs;
    }
    for (int32_t k = 0; k < FRAME_HEADS && status == MUS_OK; k++) {
        status = mus__slice(slicer, slicer->low + (0.86 + 0.03 * k) * height, "the mesh");
        if (section->loops > 0 && (section->loops == 1 || section->loop[1].area < 0.4 * section->loop[0].area))
            ++*heads;
    }
    return status;
}


/* the axis that points up, unless *up says it; *legs: two legs are found along it. Errors: MUS_ERR_BODY */
static mus_status frame_up(const mus__scan_mesh *mesh, int32_t *up, bool *legs)
{
    int32_t best = 0, second = 0, found = 0, own = 0;
    for (int32_t k = -3; k <= 3; k++) {
        if (k == 0 || (*up != 0 && k != *up)) continue;
        mus__slicer slicer;
        int32_t two, one;
        mus_status status = frame_slicer(mesh, k, &slicer);
        if (status == MUS_OK) status = frame_count(&slicer, &two, &one);
        mus__slicer_free(&slicer);
        if (status != MUS_OK) return status;
        if (two + one > best)
            second = best, best = two + one, found = k, own = two;
        else if (two + one > second)
            second = two + one;
    }
    *legs = own > FRAME_LEGS / 2;
    if (*up != 0) return MUS_OK;
    *up = found;
    if (best >= FRAME_UP && best >= second + 3) return MUS_OK;
    return mus__fail(
        mesh->context, MUS_ERR_BODY,
        "mesh: up cannot be found: along no axis are two legs below and a head above (%d of %d sections); set up",
        (int)best, FRAME_LEGS + FRAME_HEADS);
}


/* direction of the longest extent of the mesh seen from above, as an angle in the slicer's (side, front), 0 to pi
 * [rad]: the principal axis of the second moments [aa, ab, bb] of its surface */
static double frame_lateral(const mus__slicer *slicer)
{
    const mus__scan_mesh *mesh = slicer->mesh;
    double sum = 0.0, first[2] = {0.0, 0.0}, second[3] = {0.0, 0.0, 0.0};
    const double *about = slicer->sab + 1;
    for (int32_t t = 0; t < mesh->triangles; t++) {
        const int32_t *v = mesh->triangle + 3 * (ptrdiff_t)t;
        double u[3], w[3], cross[3], at[2];
        for (int i = 0; i < 3; i++) {
            u[i] = mesh->x[3 * (ptrdiff_t)v[1] + i] - mesh->x[3 * (ptrdiff_t)v[0] + i];
            w[i] = mesh->x[3 * (ptrdiff_t)v[2] + i] - mesh->x[3 * (ptrdiff_t)v[0] + i];
        }
        mus__cross3(u, w, cross);
        const double area = mus__norm3(cross);
        for (int i = 0; i < 2; i++) {
            at[i] = -about[i];
            for (int c = 0; c < 3; c++) at[i] += slicer->sab[3 * (ptrdiff_t)v[c] + 1 + i] / 3.0;
            first[i] += area * at[i];
        }
        sum += area;
        second[0] += area * at[0] * at[0], second[1] += area * at[0] * at[1], second[2] += area * at[1] * at[1];
    }
    const double aa = second[0] - first[0] * first[0] / sum, ab = second[1] - first[0] * first[1] / sum;
    const double bb = second[2] - first[1] * first[1] / sum, angle = 0.5 * mus__atan2(2.0 * ab, aa - bb);
    return angle < 0.0 ? angle + MUS_PI : angle;
}


/* centroid (2) of all loops of the section at s */
static mus_status frame_centre(mus__slicer *slicer, double s, double *out)
{
    const mus__section *section = &slicer->section;
    double area = 0.0;
    mus_status status = mus__slice(slicer, s, "the mesh");
    out[0] = out[1] = 0.0;
    for (int32_t j = 0; j < section->loops; j++) {
        area += section->loop[j].area;
        for (int i = 0; i < 2; i++) out[i] += section->loop[j].area * section->loop[j].centre[i];
    }
    if (area > 0.0) out[0] /= area, out[1] /= area;
    return status;
}


/* the unit direction (2) that a person faces, in the slicer's (side, front): square to left and right, towards the
 * toes.
 * Errors: MUS_ERR_BODY */
static mus_status frame_front(mus__slicer *slicer, double *front)
{
    double angle = frame_lateral(slicer), ahead = 0.0;
    const double quarter = 0.5 * MUS_PI, near = quarter * floor(angle / quarter + 0.5);
    if (fabs(angle - near) * 180.0 / MUS_PI <= FRAME_SNAP) angle = near;
    front[0] = -mus__sin(angle), front[1] = mus__cos(angle);
    for (int i = 0; i < 2; i++)
        if (fabs(front[i]) < 1e-12) front[i] = 0.0;

    const double height = slicer->high - slicer->low;
    for (int k = 0; k < 4; k++) {
        double toes[2], ankles[2];
        mus_status status = frame_centre(slicer, slicer->low + (0.008 + 0.005 * k) * height, toes);
        if (status == MUS_OK) status = frame_centre(slicer, slicer->low + (0.07 + 0.01 * k) * height, ankles);
        if (status != MUS_OK) return status;
        for (int i = 0; i < 2; i++) ahead += 0.25 * (toes[i] - ankles[i]) * front[i];
    }
    if (!(fabs(ahead) >= FRAME_TOES * height))
        return mus__fail(slicer->context, MUS_ERR_BODY,
                         "mesh: front cannot be found: the feet do not reach farther to one side; set front");
    if (ahead < 0.0) front[0] = -front[0], front[1] = -front[1];
    return MUS_OK;
}


/* rows of the body's frame (3 x 3) in the axes of the mesh */
static mus_status frame_axes(mus__slicer *slicer, const mus_scan_def *def, int32_t up, bool legs, double *frame)
{
    double *left = frame, *y = frame + 3, *z = frame + 6, front[2];
    memcpy(y, slicer->axis, 3 * sizeof *y);
    z[0] = z[1] = z[2] = 0.0;
    if (def->front != 0) {
        if (abs(def->front) == abs(up))
            return mus__fail(slicer->context, MUS_ERR_ARG, "mesh: front %d and up %d are one axis", (int)def->front,
                             (int)up);
        z[abs(def->front) - 1] = def->front < 0 ? -1.0 : 1.0;
    } else if (!legs) {
        /* a form faces z, or -y where z is up, which is the habit of modelling programs */
        if (abs(up) == MUS_SCAN_Z)
            z[1] = up < 0 ? 1.0 : -1.0;
        else
            z[2] = 1.0;
    } else {
        mus_status status = frame_front(slicer, front);
        if (status != MUS_OK) return status;
        for (int i = 0; i < 3; i++) z[i] = front[0] * slicer->side[i] + front[1] * slicer->front[i];
    }
    mus__cross3(y, z, left);
    return MUS_OK;
}


/* the unit [m] that makes `height` units the height of a person. Errors: MUS_ERR_BODY */
static mus_status frame_unit(mus_context *context, double height, double *unit)
{
    static const struct {
        const char *name;
        double metre;
    } known[] = {{"m", 1.0}, {"cm", 0.01}, {"mm", 0.001}, {"inch", 0.0254}};
    const char *name[4];
    double size[4];
    int count = 0;
    for (size_t k = 0; k < sizeof known / sizeof *known; k++) {
        const double stature = height * known[k].metre;
        if (!(stature >= 0.4 && stature <= 2.3)) continue;
        name[count] = known[k].name, size[count++] = known[k].metre;
    }
    if (count == 1) {
        *unit = size[0];
        return MUS_OK;
    }
    if (count == 0)
        return mus__fail(context, MUS_ERR_BODY,
                         "mesh: a height of %g is that of a person in none of m, cm, mm and inch; set unit", height);
    return mus__fail(context, MUS_ERR_BODY, "mesh: a height of %g may be %.2f m (%s) or %.2f m (%s); set unit", height,
                     height * size[0], name[0], height * size[1], name[1]);
}


/* move the mesh into the body's frame: the floor at Y = 0, the middle of the trunk between hip and waist at X = Z =
 * 0 */
static mus_status frame_place(mus__slicer *slicer, mus__scan_mesh *mesh, mus_scan_report *report)
{
    const double height = slicer->high - slicer->low, *frame = report->frame;
    double middle[3] = {0.0, 0.0, 0.0};
    const int rows = 7;
    for (int k = 0; k < rows; k++) {
        double s = slicer->low + (0.50 + 0.02 * k) * height, ab[2] = {0.0, 0.0};
        mus_status status = mus__slice(slicer, s, "the mesh");
        if (status != MUS_OK) return status;
        if (slicer->section.loops > 0) memcpy(ab, slicer->section.loop[0].centre, sizeof ab);
        for (int i = 0; i < 3; i++) middle[i] += (ab[0] * slicer->side[i] + ab[1] * slicer->front[i]) / rows;
    }
    for (int i = 0; i < 3; i++) middle[i] += slicer->low * slicer->axis[i];
    for (int i = 0; i < 3; i++) report->place[i] = -report->unit * mus__dot3(frame + 3 * i, middle);
    for (int32_t v = 0; v < mesh->vertices; v++) {
        double *x = mesh->x + 3 * (ptrdiff_t)v, to[3];
        for (int i = 0; i < 3; i++) to[i] = report->unit * mus__dot3(frame + 3 * i, x) + report->place[i];
        memcpy(x, to, sizeof to);
    }
    return MUS_OK;
}


mus_status mus__scan_frame(mus__scan_mesh *mesh, const mus_scan_def *def, mus_scan_report *report, bool *legs)
{
    int32_t up = def->up;
    mus__slicer slicer;
    mus_status status = frame_up(mesh, &up, legs);
    if (status != MUS_OK) return status;
    status = frame_slicer(mesh, up, &slicer);
    if (status != MUS_OK) return status;
    report->unit = def->unit;
    status = frame_axes(&slicer, def, up, *legs, report->frame);
    if (status == MUS_OK && def->unit == 0.0)
        status = frame_unit(mesh->context, slicer.high - slicer.low, &report->unit);
    if (status == MUS_OK) {
        report->stature = report->unit * (slicer.high - slicer.low);
        if (!(report->stature >= 0.02 && report->stature <= 20.0))
            status = mus__fail(mesh->context, MUS_ERR_BODY,
                               "mesh: the height is %g m, expected 0.02 to 20 m; is unit %g right?", report->stature,
                               report->unit);
    }
    if (status == MUS_OK) status = frame_place(&slicer, mesh, report);
    mus__slicer_free(&slicer);
    return status;
}
