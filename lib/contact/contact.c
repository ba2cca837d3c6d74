/*
 * contact.c: the collider: the body's radius fields copied for float and double, with a box round each limb.
 *
 * Boxes are of the capsule-like hull of the axis: the span of the axis widened by the reach of the contours. A node
 * outside every box pays six comparisons a limb and nothing else.
 */
#include <math.h>
#include <string.h>

#include "body/body_internal.h"
#include "contact/contact.h"

#define BIG 1e30
#define STEEPEST 5.0 /* slope of a limb's end that the wider surface still follows */
#define SAFE_PART 0.5     /* of the least radius: so deep in a limb the nearest skin is the one that was passed */
#define STEEP_MARGIN 0.02 /* [m]: near a cap the radius is far from the surface that is close */


/* largest radius of rings k and k+1 of a table (nring x nangle) */
static double ring_largest(const mus__field *field, const double *radius, int32_t k)
{
    double largest = 0.0;
    const int32_t end = k + 1 < field->nring ? k + 2 : k + 1;
    for (int64_t i = (int64_t)k * field->nangle; i < (int64_t)end * field->nangle; i++)
        if (radius[i] > largest) largest = radius[i];
    return largest;
}


/*
 * Radius of the surface `skin` off the field's, at ring k and angle step j: R + skin |grad F| with F = rho - R(s, q),
 *     |grad F|^2 = 1 + (R_q / R (a^2 + b^2))^2 + (R_s + centre's drift)^2,
 * (a, b) the diamond angle's point, |a| + |b| = 1, by central differences. A steep end counts as no steeper than STEEPEST, where the ring would run away.
 */
static double offset_radius(const mus__field *field, int32_t k, int32_t j, double skin)
{
    const int32_t n = field->nangle, low = k > 0 ? k - 1 : k, high = k + 1 < field->nring ? k + 1 : k;
    const double *ring = field->radius + (int64_t)k * n, span = field->ds * (high > low ? high - low : 1);
    const double radius = ring[j], q = 4.0 * j / n, corner = q - floor(q);
    if (!(radius > 0.0) || skin == 0.0) return radius;
    const double slope_q = (ring[(j + 1) % n] - ring[(j + n - 1) % n]) * n / 8.0;
    const double turn = slope_q / radius * (corner * corner + (1.0 - corner) * (1.0 - corner));
    const double *c0 = field->centre + 2 * (int64_t)low, *c1 = field->centre + 2 * (int64_t)high;
    const double slope_s =
        (field->radius[(int64_t)high * n + j] - field->radius[(int64_t)low * n + j]) / span;

    /* direction of the ray, and the gradient in the contour's plane */
    const double a = q < 1.0 || q >= 3.0 ? 1.0 : -1.0, b = q < 2.0 ? 1.0 : -1.0;
    const double along = (int32_t)q % 2 == 0 ? 1.0 - corner : corner, across = 1.0 - along;
    const double length = sqrt(along * along + across * across);
    const double ua = a * along / length, ub = b * across / length;
    const double ga = ua + turn * ub, gb = ub - turn * ua;
    const double gs = -slope_s - (ga * (c1[0] - c0[0]) + gb * (c1[1] - c0[1])) / span;
    const double steep = sqrt(ga * ga + gb * gb + gs * gs);
    return radius + skin * (steep < STEEPEST ? steep : STEEPEST);
}


/* table of one limb in double: centre, radius, largest, in this order */
static void fill_double(const mus__field *from, const double *origin, double skin, mus__f64_field *to, double *table)
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

    /* caps: the same middle, the half axis longer by the skin */
    for (int32_t end = 0; end < 2; end++) {
        const double s = end == 0 ? 0.0 : from->ds * (from->nring - 1);
        to->pole[end] = from->pole[end] - from->s0 + (end == 0 ? -skin : skin);
        to->middle[end] = from->middle[end] - from->s0;
        to->axis_inverse[end] = 1.0 / (from->half[end] + skin);
        to->share[end] = mus__f64_share(s - to->middle[end], to->axis_inverse[end]);
    }

    memcpy(table, from->centre, (size_t)(2 * nring) * sizeof *table);
    double *radius = table + 2 * nring;
    for (int32_t k = 0; k < from->nring; k++)
        for (int32_t j = 0; j < from->nangle; j++)
            radius[(int64_t)k * from->nangle + j] = offset_radius(from, k, j, skin);
    for (int32_t k = 0; k < from->nring; k++) table[2 * nring + nradius + k] = ring_largest(from, radius, k);
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
    for (int32_t end = 0; end < 2; end++) {
        to->pole[end] = (float)from->pole[end];
        to->middle[end] = (float)from->middle[end];
        to->axis_inverse[end] = (float)from->axis_inverse[end];
        to->share[end] = (float)from->share[end];
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
    for (int32_t i = 0; i < 3; i++) {
        const double start = field->origin[i] - origin[i];
        const double e0 = start + field->pole[0] * field->axis[i], e1 = start + field->pole[1] * field->axis[i];
        const double across = sqrt(field->side[i] * field->side[i] + field->front[i] * field->front[i]);
        box[i] = (e0 < e1 ? e0 : e1) - across * field->reach;
        box[i + 3] = (e0 < e1 ? e1 : e0) + across * field->reach;
    }
}


/* least radius over all limbs */
static double thinnest(const mus_body *body)
{
    double least = BIG;
    for (int32_t l = 0; l < body->nfield; l++) {
        const mus__field *field = &body->field[l];
        for (int64_t i = 0; i < (int64_t)field->nring * field->nangle; i++) least = fmin(least, field->radius[i]);
    }
    return least;
}


mus_status mus__collider_create(mus_context *context, const mus_body *body, const double *origin, double skin,
                                mus__collider **out)
{
    *out = NULL;
    if (body->nfield > MUS_LIMBS_MOST)
        return mus__fail(context, MUS_ERR_LIMIT, "body: %d limbs, at most %d can be collided with", (int)body->nfield,
                         MUS_LIMBS_MOST);
    mus__collider *collider = mus__new(context, 1, sizeof *collider);
    if (collider == NULL) return mus__fail_memory(context, "a collider");
    collider->context = context;
    collider->skin = skin;
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
        fill_double(&body->field[l], origin, skin, &collider->field64[l], collider->table64 + at);
        fill_float(&collider->field64[l], &collider->field32[l], collider->table32 + at);
        limb_box(&body->field[l], origin, collider->box + 6 * l);
        at += (int64_t)body->field[l].nring * (body->field[l].nangle + 3);
    }
    collider->safe = SAFE_PART * thinnest(body);
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


void mus__collider_move(mus__collider *collider, const double *shift, const double *drift)
{
    memcpy(collider->shift, shift, sizeof collider->shift);
    memcpy(collider->drift, drift, sizeof collider->drift);
}


/* a point of the world in the frame of the fields */
static void to_fields(const mus__collider *collider, const double *point, double *p)
{
    for (int32_t i = 0; i < 3; i++) p[i] = point[i] - collider->origin[i] - collider->shift[i];
}


double mus__collider_depth(const mus__collider *collider, const double *point, double margin, double *normal)
{
    double p[3], deepest = -BIG;
    to_fields(collider, point, p);
    for (int32_t l = 0; l < collider->nlimb; l++) {
        double n[3];
        int32_t near;
        const double depth = mus__f64_query(&collider->field64[l], p, margin, n, &near) - collider->skin;
        if (near != 1 || depth <= deepest) continue;
        deepest = depth;
        if (normal != NULL) memcpy(normal, n, sizeof n);
    }
    return deepest;
}


int32_t mus__collider_touching(const mus__collider *collider, const double *point, double reach, double *normals)
{
    double p[3];
    to_fields(collider, point, p);
    int32_t count = 0;
    for (int32_t l = 0; l < collider->nlimb && count < MUS_TOUCH_MOST; l++) {
        int32_t near;
        const double depth =
            mus__f64_query(&collider->field64[l], p, reach + STEEP_MARGIN, normals + 3 * (int64_t)count, &near);
        if (near == 1 && depth > collider->skin - reach) count++;
    }
    return count;
}
