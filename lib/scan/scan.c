/*
 * scan.c: a body from a triangle mesh: the order of the steps, the options and the report. A stranger starts here.
 *
 *     scan_mesh.c       check and weld the caller's triangles
 *     scan_frame.c      find up, front and unit; move the mesh into the body's frame
 *     scan_slice.c      cut the mesh by planes (used by all the following); scan_outline.c: polygons of sections
 *     scan_landmarks.c  find crotch, neck, armpits, and the axes of the arms
 *     scan_limb.c       cut each limb into outlines
 *     scan_joint.c      find the joints from the outlines
 *     (lib/body)        make a body of these limbs and joints
 *     scan_measure.c    girths of the body
 *     scan_distance.c   distances between mesh and body, most of the time; left out without a report
 */
#include <math.h>
#include <string.h>

#include "base/elementary.h"
#include "scan/scan_internal.h"


void mus_scan_def_init(mus_scan_def *def, size_t size)
{
    mus_scan_def own = {.spacing = 0.01, .corners = 192, .gap = 0.06, .samples = 128};
    own.ring_spacing = 0.01;
    own.distances = 1;
    mus__def_init(def, size, &own, sizeof own);
}


void mus_scan_report_init(mus_scan_report *report, size_t size)
{
    mus_scan_report own = {0};
    mus__def_init(report, size, &own, sizeof own);
}


/* check an axis of the options */
static mus_status scan_axis(mus_context *context, const char *name, int32_t axis)
{
    if (axis >= -MUS_SCAN_Z && axis <= MUS_SCAN_Z) return MUS_OK;
    return mus__fail(context, MUS_ERR_ARG, "%s %d is not one of -3 to 3", name, (int)axis);
}


/* check a number of the options */
static mus_status scan_number(mus_context *context, const char *name, double value, double low, double high)
{
    if (value >= low && value <= high) return MUS_OK;
    return mus__fail(context, MUS_ERR_ARG, "%s %g is outside %g to %g", name, value, low, high);
}


static mus_status scan_read_def(mus_context *context, const mus_scan_def *def, mus_scan_def *own)
{
    mus_scan_def_init(own, sizeof *own);
    mus_status status = MUS_OK;
    if (def != NULL) status = mus__def_read(context, own, sizeof *own, sizeof *own, def, "mus_scan_def");
    if (status == MUS_OK) status = scan_axis(context, "up", own->up);
    if (status == MUS_OK) status = scan_axis(context, "front", own->front);
    if (status == MUS_OK && own->unit != 0.0) status = scan_number(context, "unit", own->unit, 1e-6, 1e3);
    if (status == MUS_OK) status = scan_number(context, "spacing", own->spacing, 0.002, 0.05);
    if (status == MUS_OK) status = scan_number(context, "corners", own->corners, 16, 1024);
    if (status == MUS_OK) status = scan_number(context, "gap", own->gap, 0.0, 1.0);
    return status;
}


/* a report in which nothing is found yet: lengths are NaN, counts 0 */
static void scan_unknown(mus_scan_report *report)
{
    const size_t size = report->size;
    memset(report, 0, sizeof *report);
    report->size = size;
    report->crotch = NAN;
    for (int i = 0; i < 2; i++) report->armpit[i] = report->arm_angle[i] = NAN;
    for (int i = 0; i < MUS_SCAN_GIRTH_COUNT; i++) report->girth[i] = report->girth_height[i] = NAN;
    for (int i = 0; i < MUS_SCAN_PART_COUNT; i++)
        for (int k = 0; k < 3; k++) report->mesh_to_body[i][k] = report->body_to_mesh[i][k] = NAN;
}


/* heights and angles of what was found, into the report */
static void scan_tell(const mus__scan_found *found, mus_scan_report *report)
{
    if (found->legs) report->crotch = found->crotch;
    for (int i = 0; i < 2; i++) {
        const mus__scan_arm *arm = &found->arm[i];
        if (!arm->there) continue;
        report->armpit[i] = arm->armpit[1];
        report->arm_angle[i] = mus__atan2(-arm->axis[1], arm->side * arm->axis[0]);
    }
}


/* make a body of a mesh that is in the body's frame */
static mus_status scan_make(mus__scan_mesh *mesh, const mus_scan_def *def, mus__scan_found *found, bool distances,
                            mus_scan_report *report, mus_body **out)
{
    const double origin[3] = {0.0, 0.0, 0.0}, up[3] = {0.0, 1.0, 0.0}, side[3] = {1.0, 0.0, 0.0};
    mus__slicer upright, found_by;
    mus__scan_limbs limbs = {0};
    mus__bones bones = {.limb = {MUS_NONE}}; /* a form (no legs) has no joints */
    mus_status status = mus__slicer_make(mesh, origin, up, side, 1e30, &found_by);
    if (status != MUS_OK) return status;
    status = mus__scan_find(mesh, &found_by, found);
    mus__slicer_free(&found_by);
    if (status != MUS_OK) return status;
    scan_tell(found, report);

    status = mus__slicer_make(mesh, origin, up, side, def->gap, &upright);
    if (status != MUS_OK) return status;
    status = mus__scan_cut(mesh, def, &upright, found, report, &limbs);
    mus__slicer_free(&upright);
    if (status == MUS_OK) {
        mus_body_def surface;
        mus_body_def_init(&surface, sizeof surface);
        surface.samples = def->samples, surface.ring_spacing = def->ring_spacing;
        if (found->legs) mus__scan_joints(found, &limbs, &bones);
        status = mus__body_create_jointed(mesh->context, limbs.count, limbs.limb, &bones, &surface, out);
    }
    if (status == MUS_OK) status = mus__scan_measure(*out, found, &limbs, report);
    if (status == MUS_OK)
        mus__body_levels(*out, report->girth_height[MUS_SCAN_BUST], report->girth_height[MUS_SCAN_WAIST],
                         report->girth_height[MUS_SCAN_HIP]);
    if (status == MUS_OK && distances) status = mus__scan_distances(mesh, *out, found, report);
    mus__scan_limbs_free(mesh->context, &limbs);
    return status;
}


mus_status mus_body_create_scan(mus_context *context, int32_t vertex_count, const double *vertices,
                                int32_t triangle_count, const int32_t *triangles, const mus_scan_def *def,
                                mus_scan_report *report, mus_body **out)
{
    if (out == NULL) return MUS_ERR_ARG;
    *out = NULL;
    if (context == NULL) return MUS_ERR_ARG;
    mus_scan_def own;
    mus_scan_report told = {.size = sizeof told};
    mus_status status = scan_read_def(context, def, &own);
    if (status == MUS_OK && report != NULL && report->size != sizeof *report)
        status = mus__fail(context, MUS_ERR_VERSION, "mus_scan_report: size unknown; use mus_scan_report_init");
    if (status != MUS_OK) return status;

    mus__scan_mesh mesh;
    mus__scan_found found = {0};
    mus_body *body = NULL;
    scan_unknown(&told);
    status = mus__scan_weld(context, vertex_count, vertices, triangle_count, triangles, &mesh);
    told.vertices = mesh.vertices;
    if (status == MUS_OK) status = mus__scan_frame(&mesh, &own, &told, &found.legs);
    if (status == MUS_OK) status = scan_make(&mesh, &own, &found, report != NULL && own.distances != 0, &told, &body);
    mus__scan_mesh_free(&mesh);
    if (status != MUS_OK) {
        mus_body_destroy(body);
        return status;
    }
    if (report != NULL) *report = told;
    *out = body;
    return MUS_OK;
}
