/*
 * body_measure.c: girths and heights of the finished surface, from its vertices, for mus_body_made().
 *
 * A girth is the perimeter of the convex hull of the section of the triangles, as a tape lies: that of the contour's
 * ring, and about the hip also of the legs. Heights are those of rings and of end points.
 */
#include <math.h>

#include "body/body_make.h"
#include "geom/polygon.h"
#include "geom/vec.h"


/* the first vertex of a ring of a limb */
static const double *measure_ring(const mus_body *body, const mus__limb *limb, int32_t ring)
{
    return body->vertices + 3 * ((ptrdiff_t)limb->first_vertex + 1 + (ptrdiff_t)ring * limb->samples);
}


/* append to xy (count x 2) the points at which the plane at s meets the lines of limb l from ring to ring; returns
 * their number */
static int32_t measure_section(const mus_body *body, const mus__limb *limb, double s, double *xy, int32_t count)
{
    const double *at = body->ring + limb->first_ring;
    const int32_t n = limb->samples;
    int32_t ring = 0;
    while (ring + 2 < limb->rings && at[ring + 1] <= s + 1e-12) ring++;
    if (limb->rings < 2 || s < at[ring] - 1e-12 || s > at[ring + 1]) return count;
    const double t = fmax((s - at[ring]) / (at[ring + 1] - at[ring]), 0.0), *x = measure_ring(body, limb, ring);
    const double *y = x + 3 * (ptrdiff_t)n;
    for (int32_t k = 0; k < n; k++, count++) {
        double d[3];
        for (int i = 0; i < 3; i++) {
            const ptrdiff_t c = 3 * (ptrdiff_t)k + i;
            d[i] = x[c] + t * (y[c] - x[c]) - limb->origin[i];
        }
        xy[2 * count] = mus__dot3(d, limb->side);
        xy[2 * count + 1] = mus__dot3(d, limb->front);
    }
    return count;
}


/* girth [m] of contour i of a limb as a tape lies on the triangles: that of its ring, and about the hip of the legs.
 * Scratch: xy (6n), work (6n) */
static double measure_girth(const mus_body *body, int32_t l, int32_t i, double *xy, int32_t *work)
{
    const mus__contour *c = &body->limb[l].contour[i];
    int32_t count = measure_section(body, &body->limb[l], c->s, xy, 0);
    for (int32_t leg = MUS__LIMB_LEG_LEFT; leg <= MUS__LIMB_LEG_RIGHT && mus__girth_has_legs(c->girth); leg++)
        if (!body->limb[leg].gone) count = measure_section(body, &body->limb[leg], c->s, xy, count);
    return mus__polygon_tape(count, xy, work, work + count);
}


/* length [m] of a foot with its toes */
static double measure_foot(const mus_body *body, int32_t right)
{
    const mus__limb *foot = &body->limb[MUS__LIMB_FOOT_LEFT + right];
    double low = INFINITY, high = -INFINITY;
    for (int32_t v = 0; v < foot->vertices; v++) {
        const double z = body->vertices[3 * ((ptrdiff_t)foot->first_vertex + v) + 2];
        low = fmin(low, z), high = fmax(high, z);
    }
    for (int32_t v = 0; v < body->digit_vertices; v++) {
        const double *x = body->vertices + 3 * ((ptrdiff_t)body->vertex_count + v);
        if (x[1] < body->skeleton.ankle && (x[0] < 0.0) == (right != 0)) high = fmax(high, x[2]);
    }
    return high - low;
}


/* mean height [m] of the vertices of a named contour of the torso; NaN: it has none of that name */
static double measure_height(const mus_body *body, const char *name)
{
    const mus__limb *limb = &body->limb[MUS__LIMB_TORSO];
    int32_t n = limb->samples;
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
    double *xy = mus__room(body->context, 6 * (int64_t)n, sizeof(double));
    int32_t *work = mus__room(body->context, 6 * (int64_t)n, sizeof(int32_t));
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
            double girth = measure_girth(body, l, i, xy, work);
            double asked = body->asked[m];
            if (isnan(body->made[m]) || fabs(girth - asked) > fabs(body->made[m] - asked)) body->made[m] = girth;
        }
    mus__free(body->context, xy);
    mus__free(body->context, work);

    /* heights of end points and rings of the torso; length of the foot */
    const mus__limb *torso = &body->limb[MUS__LIMB_TORSO];
    const double *x = body->vertices + 3 * (ptrdiff_t)torso->first_vertex;
    double waist = measure_height(body, "waist");
    body->made[MUS_MEASURE_INLEG] = x[1];
    body->made[MUS_MEASURE_STATURE] = x[3 * ((ptrdiff_t)torso->vertices - 1) + 1];
    body->made[MUS_MEASURE_WAIST_HEIGHT] = waist;
    body->made[MUS_MEASURE_NAPE_HEIGHT] = measure_height(body, "nape");
    body->made[MUS_MEASURE_BUST_HEIGHT] = measure_height(body, "bust");
    body->made[MUS_MEASURE_WAIST_TO_HIP] = waist - measure_height(body, "hip");
    body->made[MUS_MEASURE_RISE] = waist - body->made[MUS_MEASURE_INLEG];
    for (int32_t right = 1; right >= 0; right--)
        if (!body->limb[MUS__LIMB_FOOT_LEFT + right].gone) body->made[MUS_MEASURE_FOOT] = measure_foot(body, right);
    return MUS_OK;
}
