/*
 * collider.c: the collider: the body's radius fields copied for float and double, with a box round each part; planes.
 *
 * Boxes are of the capsule-like hull of the axis: the span of the axis widened by the reach of the contours. A node
 * outside every box pays six comparisons a part and nothing else.
 */
#include <math.h>
#include <string.h>

#include "body/body_internal.h"
#include "contact/contact_template.h"

#define COLLIDER_FAR 1e30
#define COLLIDER_CAP_FALL 0.4999  /* most of k of a cap, which is below 1/2 */
#define COLLIDER_OFFSET_NEAR 1e-3 /* [rings] that is near enough */
#define COLLIDER_OFFSET_ROUNDS 8  /* towards the point that a point of the wider surface lies off */
#define COLLIDER_SAFE_SHARE 0.5 /* of the least radius: so deep in a limb the nearest skin is the one that was passed  \
                                 */
#define COLLIDER_STEEP_MARGIN 0.02 /* [m]: near a cap the radius is far from the surface that is close */


/* largest radius of rings k and k+1 of a table (nring x nangle) */
static double ring_largest(const mus__field *field, const double *radius, int32_t k)
{
    double largest = 0.0;
    const int32_t end = k + 1 < field->nring ? k + 2 : k + 1;
    for (int64_t i = (int64_t)k * field->nangle; i < (int64_t)end * field->nangle; i++)
        if (radius[i] > largest) largest = radius[i];
    return largest;
}


/* radius of a field at ring k and angle step j, and the gradient of F = rho - R(s, q) there: its part in the contour's
 * plane squared (at least 1), and its part along the axis, by central differences of the square of the radius */
static double field_slopes(const mus__field *field, int32_t k, int32_t j, double *plane2, double *along)
{
    const int32_t n = field->nangle, low = k > 0 ? k - 1 : k, high = k + 1 < field->nring ? k + 1 : k;
    const double *ring = field->radius + (int64_t)k * n, radius = ring[j],
                 span = field->ds * (high > low ? high - low : 1);
    const double before = field->radius[(int64_t)low * n + j], after = field->radius[(int64_t)high * n + j];
    const double slope_s = (after * after - before * before) / (2.0 * radius * span);

    /* dR/dq turns into the plane by |dq| = (a^2 + b^2) / rho at the diamond angle's point (a, b), |a| + |b| = 1 */
    const double q = 4.0 * j / n, b = q - floor(q), slope_q = (ring[(j + 1) % n] - ring[(j + n - 1) % n]) * n / 8.0;
    const double turn = slope_q / radius * (b * b + (1.0 - b) * (1.0 - b));
    const double x = (int32_t)q % 2 == 0 ? 1.0 - b : b, y = 1.0 - x, length = sqrt(x * x + y * y);
    const double ua = (q < 1.0 || q >= 3.0 ? x : -x) / length, ub = (q < 2.0 ? y : -y) / length;
    const double *c0 = field->centre + 2 * (int64_t)low, *c1 = field->centre + 2 * (int64_t)high;
    *plane2 = 1.0 + turn * turn;
    *along = -slope_s - ((ua + turn * ub) * (c1[0] - c0[0]) + (ub - turn * ua) * (c1[1] - c0[1])) / span;
    return radius;
}


/*
 * Radius of the surface `skin` off the field's, at ring k and angle step j. The point of it at height s lies off the
 * point of the field's surface at s' = s - skin g_s / |g|, with g = grad F there; in the contour's plane it is
 * skin |g_plane| / |g| off, which is |g_plane| times that along the ray.
 */
static double offset_radius(const mus__field *field, int32_t k, int32_t j, double skin)
{
    if (skin == 0.0) return field->radius[(int64_t)k * field->nangle + j];
    const double angle = 4.0 * j / field->nangle, b = angle - floor(angle);
    const double x = (int32_t)angle % 2 == 0 ? 1.0 - b : b, y = 1.0 - x, length = sqrt(x * x + y * y);
    const double ua = (angle < 1.0 || angle >= 3.0 ? x : -x) / length, ub = (angle < 2.0 ? y : -y) / length;
    double u = k, radius = 0.0;
    for (int32_t round = 0; round < COLLIDER_OFFSET_ROUNDS; round++) {
        /* between the two rings round u */
        const int32_t at = u >= field->nring - 1 ? field->nring - 2 : (int32_t)u;
        const double t = u - at;
        double plane2[2], along[2];
        const double r0 = field_slopes(field, at, j, &plane2[0], &along[0]);
        const double r1 = field_slopes(field, at + 1, j, &plane2[1], &along[1]);
        const double plane = plane2[0] + t * (plane2[1] - plane2[0]), up = along[0] + t * (along[1] - along[0]);
        const double length_g = sqrt(plane + up * up);
        const double *c0 = field->centre + 2 * (int64_t)at, *c = field->centre + 2 * (int64_t)k;
        const double back = (c[0] - c0[0] - t * (c0[2] - c0[0])) * ua + (c[1] - c0[1] - t * (c0[3] - c0[1])) * ub;
        radius = sqrt(r0 * r0 + t * (r1 * r1 - r0 * r0)) + skin * plane / length_g - back;
        const double next = fmin(fmax(k - skin * up / (length_g * field->ds), 0.0), field->nring - 1);
        if (fabs(next - u) < COLLIDER_OFFSET_NEAR) break;
        u = next;
    }
    return radius;
}


/* the cap of an end of the surface `skin` off a field, from the rings of that surface. The quarter of an ellipse leaves
 * the last ring with the mean slope of the stack, taken of the squares, and ends at the pole: with k = -R' length / R
 * the last ring lies at v = k / (1 - k) of the half axis L, and L = length / (1 - v) */
static void fit_cap(const mus__field *from, double skin, int32_t end, mus__field_f64 *to)
{
    const int32_t last = from->nring - 1, n = from->nangle;
    const double *ring = to->radius + (end == 0 ? 0 : (int64_t)last * n), *next = end == 0 ? ring + n : ring - n;
    const double s = end == 0 ? 0.0 : from->ds * last, outward = end == 0 ? -1.0 : 1.0;
    to->pole[end] = from->pole[end] - from->s0 + outward * skin;
    double half = from->half[end], v = (s - (from->middle[end] - from->s0)) * outward / half;
    if (skin > 0.0) {
        double squares = 0.0, rise = 0.0;
        for (int32_t j = 0; j < n; j++) {
            squares += ring[j] * ring[j];
            rise += next[j] * next[j] - ring[j] * ring[j];
        }
        const double length = fabs(to->pole[end] - s), fall = 0.5 * rise / from->ds * length / squares;
        v = fall <= 0.0                 ? 0.0
            : fall >= COLLIDER_CAP_FALL ? COLLIDER_CAP_FALL / (1.0 - COLLIDER_CAP_FALL)
                                        : fall / (1.0 - fall);
        half = length / (1.0 - v);
    }
    to->middle[end] = s - outward * v * half;
    to->axis_inverse[end] = 1.0 / half;
    to->share[end] = 1.0 - v * v;
}


/* table of one limb in double: centre, radius, largest, in this order */
static void fill_double(const mus__field *from, const double *origin, double skin, mus__field_f64 *to, double *table)
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
    double *radius = table + 2 * nring;
    for (int32_t k = 0; k < from->nring; k++)
        for (int32_t j = 0; j < from->nangle; j++)
            radius[(int64_t)k * from->nangle + j] = offset_radius(from, k, j, skin);
    for (int32_t k = 0; k < from->nring; k++) table[2 * nring + nradius + k] = ring_largest(from, radius, k);
    to->centre = table;
    to->radius = table + 2 * nring;
    to->largest = table + 2 * nring + nradius;
    for (int32_t end = 0; end < 2; end++) fit_cap(from, skin, end, to);
}


/* the float form of a double field; `table` holds its rounded rings */
static void fill_float(const mus__field_f64 *from, mus__field_f32 *to, float *table)
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


/* where a part was made: the field of a posed body is carried by a frame, its limb is not */
static void fill_home(const mus__field *from, const mus__limb *limb, const double *origin, mus__collider_part *home)
{
    for (int32_t i = 0; i < 3; i++) home->origin[i] = limb->origin[i] - origin[i];
    memcpy(home->axis, limb->axis, sizeof home->axis);
    memcpy(home->side, limb->side, sizeof home->side);
    memcpy(home->front, limb->front, sizeof home->front);
    memcpy(home->end, from->pole, sizeof home->end);
    home->reach = from->reach;
}


/* least radius of a part */
static double thinnest(const mus__field *field)
{
    double least = COLLIDER_FAR;
    for (int64_t i = 0; i < (int64_t)field->nring * field->nangle; i++) least = fmin(least, field->radius[i]);
    return least;
}


/* fields of all parts of the body, in its rest */
static mus_status fill_parts(mus__collider *collider, const mus_body *body)
{
    mus_context *context = collider->context;
    const int32_t n = collider->nparts = body->nfield;
    int64_t total = 0;
    for (int32_t l = 0; l < n; l++) total += (int64_t)body->field[l].nring * (body->field[l].nangle + 3);
    collider->field32 = mus__new(context, n, sizeof *collider->field32);
    collider->field64 = mus__new(context, n, sizeof *collider->field64);
    collider->box = mus__new(context, 6 * (int64_t)n, sizeof *collider->box);
    collider->part = mus__new(context, n, sizeof *collider->part);
    collider->motion = mus__new(context, n, sizeof *collider->motion);
    collider->frame = mus__new(context, n, sizeof *collider->frame);
    collider->table32 = mus__new(context, total, sizeof *collider->table32);
    collider->table64 = mus__new(context, total, sizeof *collider->table64);
    if (collider->field32 == NULL || collider->field64 == NULL || collider->box == NULL || collider->part == NULL ||
        collider->motion == NULL || collider->frame == NULL || collider->table32 == NULL || collider->table64 == NULL)
        return mus__fail_memory(context, "the radius fields of a collider");

    int64_t at = 0;
    for (int32_t l = 0; l < n; l++) {
        fill_double(&body->field[l], collider->origin, collider->offset, &collider->field64[l], collider->table64 + at);
        fill_float(&collider->field64[l], &collider->field32[l], collider->table32 + at);
        fill_home(&body->field[l], &body->limb[body->rig.part[l].limb], collider->origin, &collider->part[l]);
        collider->part[l].safe = COLLIDER_SAFE_SHARE * thinnest(&body->field[l]);
        collider->safe = fmin(collider->safe, collider->part[l].safe);
        at += (int64_t)body->field[l].nring * (body->field[l].nangle + 3);
    }
    return MUS_OK;
}


mus_status mus__collider_create(mus_context *context, const mus_body *body, const double *origin, double skin,
                                mus__collider **out)
{
    *out = NULL;
    if (body != NULL && body->nfield > MUS__PARTS_MAX)
        return mus__fail(context, MUS_ERR_LIMIT, "body: %d limbs, at most %d can be collided with", (int)body->nfield,
                         MUS__PARTS_MAX);
    mus__collider *collider = mus__new(context, 1, sizeof *collider);
    if (collider == NULL) return mus__fail_memory(context, "a collider");
    collider->context = context;
    collider->offset = skin;
    collider->safe = COLLIDER_FAR;
    memcpy(collider->origin, origin, sizeof collider->origin);
    const mus_status status = body != NULL ? fill_parts(collider, body) : MUS_OK;
    if (status != MUS_OK) {
        mus__collider_destroy(collider);
        return status;
    }
    const mus__frame *frame = body != NULL ? mus__body_frames(body) : NULL;
    mus__collider_move(collider, frame, collider->shift, collider->drift, 0.0);
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
    mus__free(context, collider->part);
    mus__free(context, collider->motion);
    mus__free(context, collider->frame);
    mus__free(context, collider->plane);
    mus__free(context, collider->table32);
    mus__free(context, collider->table64);
    mus__free(context, collider);
}


/* a point of the world in the state's coordinates */
static void to_state(const mus__collider *collider, const double *point, double *p)
{
    for (int32_t i = 0; i < 3; i++) p[i] = point[i] - collider->origin[i];
}


/* depth of a point of the world below plane k; -COLLIDER_FAR beside and far below a disc */
static double plane_depth(const mus__collider *collider, int32_t k, const double *point)
{
    const mus__collider_plane *plane = &collider->plane[k];
    double up = 0.0, across2 = 0.0;
    for (int32_t i = 0; i < 3; i++) up += (point[i] - plane->point[i]) * plane->normal[i];
    for (int32_t i = 0; i < 3; i++) across2 += pow(point[i] - plane->point[i] - up * plane->normal[i], 2.0);
    if (plane->reach > 0.0 && (up < -MUS__DISC_THICKNESS || across2 > plane->reach * plane->reach))
        return -COLLIDER_FAR;
    return -up;
}


double mus__collider_depth(const mus__collider *collider, const double *point, double margin, double *normal)
{
    double p[3], deepest = -COLLIDER_FAR;
    to_state(collider, point, p);
    for (int32_t l = 0; l < collider->nparts; l++) {
        double n[3];
        int32_t near;
        const double depth = mus__field_query_f64(&collider->field64[l], p, margin, n, &near) - collider->offset;
        if (near != 1 || depth <= deepest) continue;
        deepest = depth;
        if (normal != NULL) memcpy(normal, n, sizeof n);
    }
    for (int32_t k = 0; k < collider->nplane; k++) {
        const double depth = plane_depth(collider, k, point);
        if (depth <= deepest || depth < -margin) continue;
        deepest = depth;
        if (normal != NULL) memcpy(normal, collider->plane[k].normal, 3 * sizeof *normal);
    }
    return deepest;
}


int32_t mus__collider_touching(const mus__collider *collider, const double *point, double reach, double *normals,
                               double *friction)
{
    double p[3];
    to_state(collider, point, p);
    int32_t count = 0;
    for (int32_t l = 0; l < collider->nparts && count < MUS__TOUCHING_MAX; l++) {
        int32_t near;
        const double depth = mus__field_query_f64(&collider->field64[l], p, reach + COLLIDER_STEEP_MARGIN,
                                                  normals + 3 * (int64_t)count, &near);
        if (near == 1 && depth > collider->offset - reach) friction[count++] = -1.0;
    }
    for (int32_t k = 0; k < collider->nplane && count < MUS__TOUCHING_MAX; k++) {
        const mus__collider_plane *plane = &collider->plane[k];
        if (!(plane_depth(collider, k, point) > -reach)) continue;
        memcpy(normals + 3 * (int64_t)count, plane->normal, 3 * sizeof *normals);
        friction[count++] = plane->friction;
    }
    return count;
}
