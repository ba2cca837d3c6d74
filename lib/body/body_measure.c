/*
 * body_measure.c: girths and heights of the finished surface, from its vertices, for mus_body_made().
 *
 * A girth is the perimeter of the convex hull of a ring, as a tape lies. Heights are those of rings and of end points.
 */
#include <math.h>

#include "body/body_make.h"
#include "geom/polygon.h"
#include "geom/vec.h"


/* the first vertex of a ring of a limb */
static const double *measure_ring(const mus_body *body, const mus__limb *limb, int32_t ring)
{
    return body->vertices + 3 * ((ptrdiff_t)limb->first_vertex + 1 + (ptrdiff_t)ring * body->def.samples);
}


/* girth of a ring as a tape lies [m], from its vertices in the plane of the ring. Scratch: xy (2n), work (2n) */
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


/* mean height [m] of the vertices of a named contour of the torso; NaN: it has none of that name */
static double measure_height(const mus_body *body, const char *name)
{
    const mus__limb *limb = &body->limb[MUS__LIMB_TORSO];
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

    /* girths: of left and right the one that differs more from the tape */
    for (int32_t m = 0; m < MUS_MEASURE_COUNT; m++) body->made[m] = NAN;
    for (int32_t l = 0; l < MUS__LIMB_COUNT; l++)
        for (int32_t i = 0; i < body->limb[l].count && !body->limb[l].gone; i++) {
            int32_t m = body->limb[l].contour[i].girth;
            if (m == MUS_NONE) continue;
            double girth = measure_girth(body, &body->limb[l], body->limb[l].contour[i].ring, xy, work);
            double asked = body->asked[m];
            if (isnan(body->made[m]) || fabs(girth - asked) > fabs(body->made[m] - asked)) body->made[m] = girth;
        }
    mus__free(body->context, xy);
    mus__free(body->context, work);

    /* heights of end points and rings of the torso; length of the foot */
    const mus__limb *torso = &body->limb[MUS__LIMB_TORSO], *foot = &body->limb[MUS__LIMB_FOOT_LEFT];
    const double *x = body->vertices + 3 * (ptrdiff_t)torso->first_vertex;
    double waist = measure_height(body, "waist");
    body->made[MUS_MEASURE_INLEG] = x[1];
    body->made[MUS_MEASURE_STATURE] = x[3 * ((ptrdiff_t)torso->vertices - 1) + 1];
    body->made[MUS_MEASURE_WAIST_HEIGHT] = waist;
    body->made[MUS_MEASURE_NAPE_HEIGHT] = measure_height(body, "nape");
    body->made[MUS_MEASURE_BUST_HEIGHT] = measure_height(body, "bust");
    body->made[MUS_MEASURE_WAIST_TO_HIP] = waist - measure_height(body, "hip");
    body->made[MUS_MEASURE_RISE] = waist - body->made[MUS_MEASURE_INLEG];
    if (foot->gone) foot = &body->limb[MUS__LIMB_FOOT_RIGHT];
    if (foot->gone) return MUS_OK;
    const double *y = body->vertices + 3 * (ptrdiff_t)foot->first_vertex;
    body->made[MUS_MEASURE_FOOT] = y[3 * ((ptrdiff_t)foot->vertices - 1) + 2] - y[2];
    return MUS_OK;
}
