/*
 * body_volume.c: the volume of a body in its rest pose, from the radius fields.
 *
 * The volume of a part is a sum over the rings of its field: the squared radius is linear between rings, and so is the
 * area of the section. The round caps at joints lie within the limb and do not count; the caps at the ends of a limb
 * are quarters of ellipses, in closed form. The region that a limb shares with earlier limbs is subtracted, by a
 * quadrature over the rings that come near those limbs.
 *
 *     V = sum of  integral A(s) ds - (part of it within earlier limbs),   A = 1/2 integral R^2 dt
 *
 * Cost: 3 ms for a body of a tape, most of it at the shoulders. Error of the overlaps: 0.02 % of the body's volume.
 */
#include <math.h>

#include "base/elementary.h"
#include "body/body_internal.h"
#include "geom/vec.h"

/* the quadrature of an overlap; chosen for the error and the cost named above */
#define VOLUME_SKIP 4    /* it takes one of so many directions of the field, */
#define VOLUME_DEEP 4    /* points at so many radii, which divide the section in equal areas, */
#define VOLUME_STEP 2    /* and one of so many rings */
#define VOLUME_SOFT 0.01 /* [m] a point counts in part while its depth is within half of this: the size of its cell */


/* weight (n) of each squared radius in the area: a quarter of the angle between the two neighbouring directions */
static void volume_weights(int32_t n, const double *turn, double *weight)
{
    for (int32_t k = 0; k < n; k++) weight[k] = 0.0;
    for (int32_t k = 0; k < n; k++) {
        const double *p = turn + 2 * (ptrdiff_t)k, *q = turn + 2 * (ptrdiff_t)((k + 1) % n);
        const double angle = mus__atan2(p[0] * q[1] - p[1] * q[0], p[0] * q[0] + p[1] * q[1]);
        weight[k] += 0.25 * angle;
        weight[(k + 1) % n] += 0.25 * angle;
    }
}


/* area of a ring [m2] */
static double volume_area(const mus__field *field, int32_t ring, const double *weight)
{
    const double *radius = field->radius + (ptrdiff_t)ring * field->nangle;
    double area = 0.0;
    for (int32_t k = 0; k < field->nangle; k++) area += weight[k] * radius[k] * radius[k];
    return area;
}


/* volume [m3] of the cap that ends a limb: integral of A (1 - u^2) / (1 - v^2) from the last ring, u = v, to the
 * pole */
static double volume_cap(const mus__field *field, int end, const double *weight)
{
    const double s = end == 0 ? field->s0 : field->s0 + field->ds * (field->nring - 1);
    const double axis = field->half[end], v = (end == 0 ? field->middle[end] - s : s - field->middle[end]) / axis;
    const double area = volume_area(field, end == 0 ? 0 : field->nring - 1, weight);
    return area * axis * (2.0 / 3.0 - v + v * v * v / 3.0) / (1.0 - v * v);
}


/* volume [m3] of a part between its ends, and of the caps that end the limb */
static double volume_part(const mus__field *field, const mus__part *part, const double *weight)
{
    double volume = 0.0, low = volume_area(field, 0, weight);
    for (int32_t j = 0; j + 1 < field->nring; j++) {
        const double high = volume_area(field, j + 1, weight), s = field->s0 + j * field->ds;
        const double from = part->deep ? 0.0 : fmax((part->end[0] - s) / field->ds, 0.0);
        const double to = fmin((part->end[1] - s) / field->ds, 1.0);
        if (to > from) volume += field->ds * (to - from) * (low + 0.5 * (from + to) * (high - low));
        low = high;
    }
    for (int end = 0; end < 2; end++)
        if (part->round[end] <= 0.0) volume += volume_cap(field, end, weight);
    return volume;
}


/* whether a ball may touch the body of a field; `axis` is that of the part the ball belongs to: for parallel axes the
 * bound is that of the ring at its height, else that of the whole field */
static bool volume_near(const mus__field *field, const double *middle, double radius, const double *axis)
{
    double d[3];
    for (int i = 0; i < 3; i++) d[i] = middle[i] - field->origin[i];
    const double s = mus__dot3(d, field->axis), a = mus__dot3(d, field->side), b = mus__dot3(d, field->front);
    if (s + radius < field->pole[0] || s - radius > field->pole[1]) return false;
    double ca = 0.0, cb = 0.0, reach = field->reach;
    if (mus__dot3(axis, field->axis) > 0.9999) {
        const double u = (s - field->s0) / field->ds;
        const int32_t k = u < 0.0 ? 0 : u < field->nring - 1 ? (int32_t)u : field->nring - 1;
        ca = field->centre[2 * k], cb = field->centre[2 * k + 1], reach = field->largest[k];
    }
    reach += radius;
    return (a - ca) * (a - ca) + (b - cb) * (b - cb) < reach * reach;
}


/* the share of a point's cell that lies within the listed fields, 0 to 1 */
static double volume_within(const mus__field *const *near, int32_t count, const double *x)
{
    double most = 0.0, normal[3];
    for (int32_t i = 0; i < count && most < 1.0; i++) {
        const double part = 0.5 + mus__field_depth(near[i], x, normal) / VOLUME_SOFT;
        if (part > most) most = part;
    }
    return most < 1.0 ? most : 1.0;
}


/* area [m2] of a ring of part p that lies within earlier limbs */
static double volume_shared(const mus_body *body, int32_t p, int32_t ring, const double *turn, const double *weight)
{
    const mus__field *field = &body->field[p], *near[MUS__PARTS_MOST];
    const double *c = field->centre + 2 * (ptrdiff_t)ring, s = field->s0 + ring * field->ds;
    const double *radius = field->radius + (ptrdiff_t)ring * field->nangle;
    double middle[3], area = 0.0;
    int32_t count = 0;
    for (int i = 0; i < 3; i++)
        middle[i] = field->origin[i] + s * field->axis[i] + c[0] * field->side[i] + c[1] * field->front[i];
    for (int32_t q = 0; q < p && body->rig.part[q].limb != body->rig.part[p].limb; q++)
        if (volume_near(&body->field[q], middle, field->largest[ring], field->axis)) near[count++] = &body->field[q];

    for (int32_t k = 0; k < field->nangle && count > 0; k += VOLUME_SKIP) {
        double within = 0.0, sector = 0.0;
        for (int32_t i = 0; i < VOLUME_SKIP; i++) sector += weight[k + i] * radius[k + i] * radius[k + i];
        const int32_t m = k + VOLUME_SKIP / 2;
        for (int32_t i = 0; i < VOLUME_DEEP; i++) {
            const double r = radius[m] * sqrt((i + 0.5) / VOLUME_DEEP);
            const double a = r * turn[2 * m], b = r * turn[2 * m + 1];
            double x[3];
            for (int j = 0; j < 3; j++) x[j] = middle[j] + a * field->side[j] + b * field->front[j];
            within += volume_within(near, count, x);
        }
        area += sector * within / VOLUME_DEEP;
    }
    return area;
}


/* volume [m3] of part p within earlier limbs; a cap shares as much as the ring it stands on */
static double volume_overlap(const mus_body *body, int32_t p, const double *turn, const double *weight)
{
    const mus__field *field = &body->field[p];
    const mus__part *part = &body->rig.part[p];
    double volume = 0.0;
    for (int32_t j = 0; j < field->nring; j += VOLUME_STEP) {
        const double s = field->s0 + j * field->ds, half = 0.5 * VOLUME_STEP * field->ds;
        double low = s - half, high = s + half, more = 0.0;
        for (int end = 0; end < 2; end++) {
            const bool last = end == 0 ? j == 0 : j + VOLUME_STEP >= field->nring;
            if (last && part->round[end] <= 0.0) more += volume_cap(field, end, weight);
        }
        low = fmax(low, part->deep ? field->s0 : part->end[0]), high = fmin(high, part->end[1]);
        if (high <= low && more <= 0.0) continue;
        const double shared = volume_shared(body, p, j, turn, weight);
        if (shared <= 0.0) continue;
        volume += shared * fmax(high - low, 0.0);
        if (more > 0.0) volume += more * shared / volume_area(field, j, weight);
    }
    return volume;
}


/* volume of a posed body: that of its fields in the rest pose, with borrowed tables */
static double volume_at_rest(const mus_body *body)
{
    mus_body rest = *body;
    mus__field field[MUS__PARTS_MOST];
    for (int32_t p = 0; p < body->nfield; p++) {
        const mus__limb *limb = &body->limb[body->rig.part[p].limb];
        field[p] = body->field[p];
        for (int i = 0; i < 3; i++) {
            field[p].origin[i] = limb->origin[i], field[p].axis[i] = limb->axis[i];
            field[p].side[i] = limb->side[i], field[p].front[i] = limb->front[i];
        }
    }
    rest.field = field;
    rest.frame = NULL;
    return mus_body_volume(&rest);
}


double mus_body_volume(const mus_body *body)
{
    if (body == NULL) return NAN;
    if (body->frame != NULL) return volume_at_rest(body);
    double turn[2 * MUS__FIELD_MOST], weight[MUS__FIELD_MOST], volume = 0.0;
    for (int32_t p = 0; p < body->nfield; p++) {
        const int32_t n = body->field[p].nangle;
        if (p == 0 || n != body->field[p - 1].nangle) {
            mus__field_turns(n, turn);
            volume_weights(n, turn, weight);
        }
        volume += volume_part(&body->field[p], &body->rig.part[p], weight);
        if (body->rig.part[p].limb > 0) volume -= volume_overlap(body, p, turn, weight);
    }
    return volume;
}
