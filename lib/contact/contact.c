/*
 * contact.c: the collider: the body's radius fields copied for float and double, with a box round each limb.
 *
 * Boxes are of the capsule-like hull of the axis: the span of the axis widened by the reach of the contours. A node
 * outside every box pays six comparisons a limb and nothing else.
 */
#include <string.h>

#include "body/body_internal.h"
#include "contact/contact.h"

#define BIG 1e30
#define STEEP_MARGIN 0.02 /* [m]: near a cap the radius is far from the surface that is close */


/* largest radius of rings k and k+1, into out (nring) */
static double ring_largest(const mus__field *field, int32_t k)
{
    double largest = 0.0;
    const int32_t end = k + 1 < field->nring ? k + 2 : k + 1;
    for (int32_t r = k; r < end; r++)
        for (int32_t j = 0; j < field->nangle; j++) {
            const double radius = field->radius[(int64_t)r * field->nangle + j];
            if (radius > largest) largest = radius;
        }
    return largest;
}


/* table of one limb in double: centre, radius, largest, in this order */
static void fill_double(const mus__field *from, const double *origin, mus__f64_field *to, double *table)
{
    const int64_t nring = from->nring, nradius = nring * from->nangle;
    for (int32_t i = 0; i < 3; i++) to->origin[i] = from->origin[i] - origin[i];
    memcpy(to->axis, from->axis, sizeof to->axis);
    memcpy(to->side, from->side, sizeof to->side);
    memcpy(to->front, from->front, sizeof to->front);
    to->s0 = from->s0;
    to->ds_inverse = 1.0 / from->ds;
    to->ring_last = (double)(from->nring - 1);
    to->angle_scale = from->nangle / 4.0;
    to->nring = from->nring;
    to->nangle = from->nangle;
    memcpy(table, from->centre, (size_t)(2 * nring) * sizeof *table);
    memcpy(table + 2 * nring, from->radius, (size_t)nradius * sizeof *table);
    for (int32_t k = 0; k < from->nring; k++) table[2 * nring + nradius + k] = ring_largest(from, k);
    to->centre = table;
    to->radius = table + 2 * nring;
    to->largest = table + 2 * nring + nradius;
}


/* the float form of a double field; `table` holds its rounded rings */
static void fill_float(const mus__f64_field *from, mus__f32_field *to, float *table)
{
    const int64_t nring = from->nring, nradius = nring * from->nangle, total = 3 * nring + nradius;
    for (int32_t i = 0; i < 3; i++) {
        to->origin[i] = (float)from->origin[i];
        to->axis[i] = (float)from->axis[i];
        to->side[i] = (float)from->side[i];
        to->front[i] = (float)from->front[i];
    }
    to->s0 = (float)from->s0;
    to->ds_inverse = (float)from->ds_inverse;
    to->ring_last = (float)from->ring_last;
    to->angle_scale = (float)from->angle_scale;
    to->nring = from->nring;
    to->nangle = from->nangle;
    for (int64_t i = 0; i < total; i++) table[i] = (float)from->centre[i];
    to->centre = table;
    to->radius = table + 2 * nring;
    to->largest = table + 2 * nring + nradius;
}


/* box of the axis from end to end, widened by the reach in the contour's plane */
static void limb_box(const mus__field *field, const double *origin, double *box)
{
    const double s1 = field->s0 + field->ds * (field->nring - 1);
    for (int32_t i = 0; i < 3; i++) {
        const double start = field->origin[i] - origin[i];
        const double e0 = start + field->s0 * field->axis[i], e1 = start + s1 * field->axis[i];
        const double across = sqrt(field->side[i] * field->side[i] + field->front[i] * field->front[i]);
        box[i] = (e0 < e1 ? e0 : e1) - across * field->reach;
        box[i + 3] = (e0 < e1 ? e1 : e0) + across * field->reach;
    }
}


mus_status mus__collider_create(mus_context *context, const mus_body *body, const double *origin, mus__collider **out)
{
    *out = NULL;
    if (body->nfield > MUS_LIMBS_MOST)
        return mus__fail(context, MUS_ERR_LIMIT, "body: %d limbs, at most %d can be collided with", (int)body->nfield,
                         MUS_LIMBS_MOST);
    mus__collider *collider = mus__new(context, 1, sizeof *collider);
    if (collider == NULL) return mus__fail_memory(context, "a collider");
    collider->context = context;
    memcpy(collider->origin, origin, sizeof collider->origin);
    const int32_t n = collider->nlimb = body->nfield;

    int64_t total = 0;
    for (int32_t l = 0; l < n; l++) total += (int64_t)body->field[l].nring * (body->field[l].nangle + 3);
    collider->field32 = mus__new(context, n, sizeof *collider->field32);
    collider->field64 = mus__new(context, n, sizeof *collider->field64);
    collider->box = mus__new(context, 6 * (int64_t)n, sizeof *collider->box);
    collider->table32 = mus__new(context, total, sizeof *collider->table32);
    collider->table64 = mus__new(context, total, sizeof *collider->table64);
    if (collider->field32 == NULL || collider->field64 == NULL || collider->box == NULL ||
        collider->table32 == NULL || collider->table64 == NULL) {
        mus__collider_destroy(collider);
        return mus__fail_memory(context, "the radius fields of a collider");
    }

    int64_t at = 0;
    for (int32_t l = 0; l < n; l++) {
        fill_double(&body->field[l], origin, &collider->field64[l], collider->table64 + at);
        fill_float(&collider->field64[l], &collider->field32[l], collider->table32 + at);
        limb_box(&body->field[l], origin, collider->box + 6 * l);
        at += (int64_t)body->field[l].nring * (body->field[l].nangle + 3);
    }
    *out = collider;
    return MUS_OK;
}


void mus__collider_destroy(mus__collider *collider)
{
    if (collider == NULL) return;
    mus_context *context = collider->context;
    mus__free(context, collider->field32);
    mus__free(context, collider->field64);
    mus__free(context, collider->box);
    mus__free(context, collider->table32);
    mus__free(context, collider->table64);
    mus__free(context, collider);
}


double mus__collider_depth(const mus__collider *collider, const double *point, double margin, double *normal)
{
    const double p[3] = {point[0] - collider->origin[0], point[1] - collider->origin[1],
                         point[2] - collider->origin[2]};
    double deepest = -BIG;
    for (int32_t l = 0; l < collider->nlimb; l++) {
        double n[3];
        int32_t near;
        const double depth = mus__f64_query(&collider->field64[l], p, margin, n, &near);
        if (near != 1 || depth <= deepest) continue;
        deepest = depth;
        if (normal != NULL) memcpy(normal, n, sizeof n);
    }
    return deepest;
}


int32_t mus__collider_touching(const mus__collider *collider, const double *point, double reach, double *normals)
{
    const double p[3] = {point[0] - collider->origin[0], point[1] - collider->origin[1],
                         point[2] - collider->origin[2]};
    int32_t count = 0;
    for (int32_t l = 0; l < collider->nlimb && count < MUS_TOUCH_MOST; l++) {
        int32_t near;
        const double depth =
            mus__f64_query(&collider->field64[l], p, reach + STEEP_MARGIN, normals + 3 * (int64_t)count, &near);
        if (near == 1 && depth > -reach) count++;
    }
    return count;
}
