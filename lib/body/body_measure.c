/*
 * body_measure.c: the made body under the tape again: girths and heights from its vertices, and its volume.
 *
 * A girth is the perimeter of the convex hull of a ring of the surface, as the tape lies. Heights are those of the
 * rings and of the end points. The volume is one third of the sum of x . n over the triangles (divergence theorem),
 * each weighted by the part of it that lies outside all other limbs, so that what two limbs share at a joint counts
 * once.
 */
#include <math.h>

#include "body/body_internal.h"
#include "geom/polygon.h"
#include "geom/vec.h"


static const double *measure_ring(const mus_body *body, const mus__limb *limb, int32_t ring)
{
    return body->vertices + 3 * ((ptrdiff_t)limb->first_vertex + 1 + (ptrdiff_t)ring * body->def.samples);
}


/* girth of a ring as the tape lies, from its vertices in the plane of the ring */
static double measure_girth(const mus_body *body, const mus__limb *limb, int32_t ring, double *xy, int32_t *work)
{
    const double *x = measure_ring(body, limb, ring);
    int32_t n = body->def.samples;
    for (int32_t k = 0; k < n; k++) {
        double d[3];
        for (int i = 0; i < 3; i++) d[i] = x[3 * (ptrdiff_t)k + i] - limb->origin[i];
        xy[2 * k] = mus__dot3(d, limb->side);
        xy[2 * k + 1] = mus__dot3(d, limb->front);
    }
    return mus__polygon_tape(n, xy, work, work + n);
}


/* mean height of the vertices of a named contour of the torso; NaN without it */
static double measure_height(const mus_body *body, const char *name)
{
    const mus__limb *limb = &body->limb[MUS_LIMB_TORSO];
    int32_t n = body->def.samples;
    for (int32_t i = 0; i < limb->count; i++) {
        const char *p = limb->contour[i].name, *q = name;
        while (*p != '\0' && *p == *q) p++, q++;
        if (*p != *q) continue;
        const double *x = measure_ring(body, limb, limb->contour[i].ring);
        double sum = 0.0;
        for (int32_t k = 0; k < n; k++) sum += x[3 * (ptrdiff_t)k + 1];
        return sum / n;
    }
    return NAN;
}


mus_status mus__body_remeasure(mus_body *body)
{
    int32_t n = body->def.samples;
    double *xy = mus__new(body->context, 2 * (int64_t)n, sizeof(double));
    int32_t *work = mus__new(body->context, 2 * (int64_t)n, sizeof(int32_t));
    if (xy == NULL || work == NULL) {
        mus__free(body->context, xy);
        mus__free(body->context, work);
        return mus__fail_memory(body->context, "measuring a body");
    }

    /* girths: of two sides the one further from what was asked */
    for (int32_t m = 0; m < MUS_MEASURE_COUNT; m++) body->made[m] = NAN;
    for (int32_t l = 0; l < MUS_LIMB_COUNT; l++)
        for (int32_t i = 0; i < body->limb[l].count; i++) {
            int32_t m = body->limb[l].contour[i].girth;
            if (m == MUS_NONE) continue;
            double girth = measure_girth(body, &body->limb[l], body->limb[l].contour[i].ring, xy, work);
            double asked = body->asked[m];
            if (isnan(body->made[m]) || fabs(girth - asked) > fabs(body->made[m] - asked)) body->made[m] = girth;
        }
    mus__free(body->context, xy);
    mus__free(body->context, work);

    /* heights: end points and rings of the torso, length of the foot */
    const mus__limb *torso = &body->limb[MUS_LIMB_TORSO], *foot = &body->limb[MUS_LIMB_FOOT_LEFT];
    const double *x = body->vertices + 3 * (ptrdiff_t)torso->first_vertex;
    const double *y = body->vertices + 3 * (ptrdiff_t)foot->first_vertex;
    double waist = measure_height(body, "waist");
    body->made[MUS_MEASURE_INLEG] = x[1];
    body->made[MUS_MEASURE_STATURE] = x[3 * ((ptrdiff_t)torso->vertices - 1) + 1];
    body->made[MUS_MEASURE_WAIST_HEIGHT] = waist;
    body->made[MUS_MEASURE_NAPE_HEIGHT] = measure_height(body, "nape");
    body->made[MUS_MEASURE_BUST_HEIGHT] = measure_height(body, "bust");
    body->made[MUS_MEASURE_WAIST_TO_HIP] = waist - measure_height(body, "hip");
    body->made[MUS_MEASURE_RISE] = waist - body->made[MUS_MEASURE_INLEG];
    body->made[MUS_MEASURE_FOOT] = y[3 * ((ptrdiff_t)foot->vertices - 1) + 2] - y[2];
    return MUS_OK;
}


/* depth of point x in the parts of all limbs but `own` */
static double measure_other_depth(const mus_body *body, int32_t own, const double *x)
{
    double most = -1e30, normal[3];
    for (int32_t l = 0; l < body->nfield; l++) {
        if (body->rig.part[l].limb == own) continue;
        double depth = mus__field_depth(&body->field[l], x, normal);
        if (depth > most) most = depth;
    }
    return most;
}


/* part of a triangle outside, from the depths of its corners, taking depth as linear over it */
static double measure_outside(const double *depth)
{
    int inside = (depth[0] > 0.0) + (depth[1] > 0.0) + (depth[2] > 0.0);
    if (inside == 0) return 1.0;
    if (inside == 3) return 0.0;

    /* the corner that is alone: its share is the product of the two cut fractions; far corners are taken as near */
    int lone = 0;
    for (int c = 0; c < 3; c++)
        if ((depth[c] > 0.0) == (inside == 1)) lone = c;
    double d = fmax(depth[lone], -0.02), part = 1.0;
    for (int c = 1; c < 3; c++) part *= d / (d - fmax(depth[(lone + c) % 3], -0.02));
    return inside == 1 ? 1.0 - part : part;
}


/* depths in the other limbs of a ring of the surface */
static void measure_row(const mus_body *body, int32_t own, int32_t ring, double *depth)
{
    const double *x = measure_ring(body, &body->limb[own], ring);
    for (int32_t k = 0; k < body->def.samples; k++) depth[k] = measure_other_depth(body, own, x + 3 * (ptrdiff_t)k);
}


/* six times the volume under a triangle, the part outside the other limbs */
static double measure_wedge(const mus_body *body, const int32_t *v, const double *depth)
{
    double cross[3];
    mus__cross3(body->vertices + 3 * (ptrdiff_t)v[1], body->vertices + 3 * (ptrdiff_t)v[2], cross);
    return measure_outside(depth) * mus__dot3(body->vertices + 3 * (ptrdiff_t)v[0], cross);
}


/* the volume of a posed body is that of a copy in the rest pose */
static double measure_rest_volume(const mus_body *body)
{
    mus_pose rest;
    mus_body *copy = NULL;
    double volume = NAN;
    if (mus_body_rest_pose(body, &rest) == MUS_OK && mus_body_pose(body, &rest, &copy) == MUS_OK) {
        mus__free(copy->context, copy->frame);
        copy->frame = NULL;
        volume = mus_body_volume(copy);
    }
    mus_body_destroy(copy);
    return volume;
}


double mus_body_volume(const mus_body *body)
{
    if (body == NULL) return NAN;
    if (body->frame != NULL) return measure_rest_volume(body);
    double volume = 0.0, row[2][MUS_BODY_SAMPLES], pole[2];
    int32_t n = body->def.samples;
    for (int32_t l = 0; l < body->limb_count; l++) {
        const mus__limb *limb = &body->limb[l];
        const double *x = body->vertices + 3 * (ptrdiff_t)limb->first_vertex;
        pole[0] = measure_other_depth(body, l, x);
        pole[1] = measure_other_depth(body, l, x + 3 * ((ptrdiff_t)limb->vertices - 1));
        measure_row(body, l, 0, row[0]);

        /* triangles come ring by ring: a fan, strips, a fan; two rows of depths are enough */
        for (int32_t t = 0; t < limb->triangles; t++) {
            if (t % (2 * n) == n && t / (2 * n) + 1 < limb->rings)
                measure_row(body, l, t / (2 * n) + 1, row[(t / (2 * n) + 1) % 2]);
            const int32_t *v = body->triangles + 3 * ((ptrdiff_t)limb->first_triangle + t);
            double depth[3];
            for (int c = 0; c < 3; c++) {
                int32_t i = v[c] - limb->first_vertex - 1;
                depth[c] = i < 0 ? pole[0] : i == limb->rings * n ? pole[1] : row[i / n % 2][i % n];
            }
            volume += measure_wedge(body, v, depth);
        }
    }
    return volume / 6.0;
}
