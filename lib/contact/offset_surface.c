/*
 * offset_surface.c: radius fields of the surface at a distance off the skin, for float and double.
 *
 * The point of the offset surface at height s lies off the point of the skin at s' = s - offset g_s / |g|, with
 * g = grad F there and F = rho - R(s, q). That is an equation for s', solved by iteration at each ring and each angle.
 * The gradients along 16 columns of the table (all rings, 16 angles) are worked out once, before their rings are
 * solved.
 */
#include <math.h>
#include <string.h>

#include "body/body_internal.h"
#include "contact/offset_surface.h"

#define OFFSET_CAP_FALL 0.4999 /* bound of k of a cap, which must be below 1/2 for its half axis to be finite */
#define OFFSET_CLOSE 1e-3      /* [rings] the iteration ends when s' moves by less: micrometres */
#define OFFSET_ROUNDS 8        /* iterations at most; it converges by a factor of the surface's slope */
#define OFFSET_LANES 16        /* columns side by side: two lines of the cache */
#define OFFSET_SAFE                                                                                                    \
    0.5 /* of the least radius: the skin that is nearest to a node no deeper than this is the one it passed */
/* heights of its first ring over the floor that a stump is long; chosen: at the floor it is nine tenths as wide */
#define OFFSET_STUMP 2.3
#define OFFSET_FAR 1e30 /* [m] beyond every radius */

/* columns of a table that are worked out side by side, a lane each: their directions in the contour's plane, and the
 * gradients of F at their rings. The last lanes repeat the last column where the table has no more */
typedef struct offset_columns {
    const mus__field *field;
    double offset;
    int32_t column[OFFSET_LANES];
    double ua[OFFSET_LANES], ub[OFFSET_LANES];
    double bend[OFFSET_LANES]; /* square of the distance from the axis of the diamond angle's point */
    double *radius;            /* (nring x OFFSET_LANES) */
    double *plane2;            /* (same) square of the gradient's part in the contour's plane, at least 1 */
    double *along;             /* (same) its part along the axis */
} offset_columns;


/* largest radius of rings k and k+1 of a table (nring x nangle) */
static double ring_largest(const mus__field *field, const double *radius, int32_t k)
{
    double largest = 0.0;
    const int32_t end = k + 1 < field->nring ? k + 2 : k + 1;
    for (int64_t i = (int64_t)k * field->nangle; i < (int64_t)end * field->nangle; i++)
        if (radius[i] > largest) largest = radius[i];
    return largest;
}


/* sets the columns from `first` on: a + b = 1 at the diamond angle's point (a, b), which gives their directions */
static void offset_columns_at(offset_columns *at, int32_t first)
{
    const int32_t n = at->field->nangle;
    for (int32_t i = 0; i < OFFSET_LANES; i++) {
        const int32_t j = at->column[i] = first + i < n ? first + i : n - 1;
        const double q = 4.0 * j / n, b = q - floor(q), length = mus__diamond_point(j, n, &at->ua[i], &at->ub[i]);
        at->ua[i] /= length, at->ub[i] /= length;
        at->bend[i] = b * b + (1.0 - b) * (1.0 - b);
    }
}


/* gradients at ring k of the columns, by central differences of the square of the radius */
static void offset_slopes(const offset_columns *at, int32_t k)
{
    const mus__field *field = at->field;
    const int32_t n = field->nangle, low = k > 0 ? k - 1 : k, high = k + 1 < field->nring ? k + 1 : k;
    const double *ring = field->radius + (int64_t)k * n, span = field->ds * (high > low ? high - low : 1);
    const double *ring0 = field->radius + (int64_t)low * n, *ring1 = field->radius + (int64_t)high * n;
    const double *c0 = field->centre + 2 * (int64_t)low, *c1 = field->centre + 2 * (int64_t)high;
    const double lean_a = c1[0] - c0[0], lean_b = c1[1] - c0[1];
    double *radius = at->radius + (int64_t)k * OFFSET_LANES;
    double *plane2 = at->plane2 + (int64_t)k * OFFSET_LANES, *along = at->along + (int64_t)k * OFFSET_LANES;
    double before[OFFSET_LANES], after[OFFSET_LANES], step[OFFSET_LANES];
    for (int32_t i = 0; i < OFFSET_LANES; i++) {
        const int32_t j = at->column[i];
        radius[i] = ring[j];
        before[i] = ring0[j], after[i] = ring1[j];
        step[i] = ring[j + 1 < n ? j + 1 : 0] - ring[j > 0 ? j - 1 : n - 1];
    }
    for (int32_t i = 0; i < OFFSET_LANES; i++) {
        const double slope_s = (after[i] * after[i] - before[i] * before[i]) / (2.0 * radius[i] * span);
        /* dR/dq turns into the plane by |dq| = (a^2 + b^2) / rho */
        const double turn = step[i] * n / 8.0 / radius[i] * at->bend[i], ua = at->ua[i], ub = at->ub[i];
        plane2[i] = 1.0 + turn * turn;
        along[i] = -slope_s - ((ua + turn * ub) * lean_a + (ub - turn * ua) * lean_b) / span;
    }
}


/* radii of the offset surface at ring k of the columns: the point found there is offset |g_plane| / |g| off in the
 * contour's plane, which is |g_plane| times that along the ray. A lane that has converged finds the same again */
static void offset_ring(const offset_columns *all, int32_t k, double *radius)
{
    const mus__field *field = all->field;
    const double offset = all->offset, ds = field->ds, last = field->nring - 1;
    double u[OFFSET_LANES], t[OFFSET_LANES], plane[OFFSET_LANES], up[OFFSET_LANES], length_g[OFFSET_LANES];
    int32_t at[OFFSET_LANES];
    for (int32_t i = 0; i < OFFSET_LANES; i++) u[i] = k;
    for (int32_t round = 0, moving = 1; round < OFFSET_ROUNDS && moving > 0; round++) {
        for (int32_t i = 0; i < OFFSET_LANES; i++) {
            at[i] = u[i] >= last ? field->nring - 2 : (int32_t)u[i]; /* between the two rings round u */
            t[i] = u[i] - at[i];
            const int64_t low = (int64_t)at[i] * OFFSET_LANES + i, high = low + OFFSET_LANES;
            plane[i] = all->plane2[low] + t[i] * (all->plane2[high] - all->plane2[low]);
            up[i] = all->along[low] + t[i] * (all->along[high] - all->along[low]);
        }
        double next[OFFSET_LANES];
        for (int32_t i = 0; i < OFFSET_LANES; i++) {
            length_g[i] = sqrt(plane[i] + up[i] * up[i]);
            const double to = k - offset * up[i] / (length_g[i] * ds), above = to > 0.0 ? to : 0.0;
            next[i] = above < last ? above : last;
        }
        moving = 0;
        for (int32_t i = 0; i < OFFSET_LANES; i++) {
            const int32_t far = !(fabs(next[i] - u[i]) < OFFSET_CLOSE);
            u[i] = far ? next[i] : u[i];
            moving += far;
        }
    }
    const double *c = field->centre + 2 * (int64_t)k;
    double squared[OFFSET_LANES], back[OFFSET_LANES], found[OFFSET_LANES];
    for (int32_t i = 0; i < OFFSET_LANES; i++) {
        const int64_t low = (int64_t)at[i] * OFFSET_LANES + i;
        const double *c0 = field->centre + 2 * (int64_t)at[i];
        const double r0 = all->radius[low], r1 = all->radius[low + OFFSET_LANES];
        squared[i] = r0 * r0 + t[i] * (r1 * r1 - r0 * r0);
        back[i] =
            (c[0] - c0[0] - t[i] * (c0[2] - c0[0])) * all->ua[i] + (c[1] - c0[1] - t[i] * (c0[3] - c0[1])) * all->ub[i];
    }
    for (int32_t i = 0; i < OFFSET_LANES; i++) found[i] = sqrt(squared[i]) + offset * plane[i] / length_g[i] - back[i];
    for (int32_t i = 0; i < OFFSET_LANES; i++) radius[all->column[i]] = found[i];
}


/* radii (nring x nangle) of the offset surface; scratch (3 nring x OFFSET_LANES) */
static void offset_radii(const mus__field *field, double offset, double *scratch, double *radius)
{
    const int32_t n = field->nangle;
    const int64_t rings = (int64_t)field->nring * OFFSET_LANES;
    if (offset == 0.0) {
        memcpy(radius, field->radius, (size_t)field->nring * (size_t)n * sizeof *radius);
        return;
    }
    offset_columns at = {
        .field = field, .offset = offset, .radius = scratch, .plane2 = scratch + rings, .along = scratch + 2 * rings};
    for (int32_t first = 0; first < n; first += OFFSET_LANES) {
        offset_columns_at(&at, first);
        for (int32_t k = 0; k < field->nring; k++) offset_slopes(&at, k);
        for (int32_t k = 0; k < field->nring; k++) offset_ring(&at, k, radius + (int64_t)k * n);
    }
}


/* the cap at an end of the offset surface, from its rings. The quarter of an ellipse leaves the last ring with the mean
 * slope of the stack, taken of the squares, and ends at the pole: with k = -R' length / R the last ring lies at
 * v = k / (1 - k) of the half axis L, and L = length / (1 - v) */
static void fit_cap(const mus__field *from, double offset, int32_t end, mus__field_f64 *to)
{
    const int32_t last = from->nring - 1, n = from->nangle;
    const double *ring = to->radius + (end == 0 ? 0 : (int64_t)last * n), *next = end == 0 ? ring + n : ring - n;
    const double s = end == 0 ? 0.0 : from->ds * last, outward = end == 0 ? -1.0 : 1.0;
    to->pole[end] = from->pole[end] - from->s0 + outward * offset;
    double half = from->half[end], v = (s - (from->middle[end] - from->s0)) * outward / half;
    if (offset > 0.0) {
        double squares = 0.0, rise = 0.0;
        for (int32_t j = 0; j < n; j++) {
            squares += ring[j] * ring[j];
            rise += next[j] * next[j] - ring[j] * ring[j];
        }
        const double length = fabs(to->pole[end] - s), fall = 0.5 * rise / from->ds * length / squares;
        const double k = fall >= OFFSET_CAP_FALL ? OFFSET_CAP_FALL : fall;
        v = fall <= 0.0 ? 0.0 : k / (1.0 - k);
        half = length / (1.0 - v);
    }
    to->middle[end] = s - outward * v * half;
    to->axis_inverse[end] = 1.0 / half;
    to->share[end] = 1.0 - v * v;
}


/* the field of one part in double; table: its centres, radii and maxima, in this order */
static void fill_double(const mus__field *from, double offset, double *scratch, mus__field_f64 *to, double *table)
{
    const int64_t nring = from->nring, nradius = nring * from->nangle;
    to->s0 = from->s0;
    to->ds_inverse = 1.0 / from->ds;
    to->ring_last = (double)(from->nring - 1);
    to->angle_scale = from->nangle / 4.0;
    to->nring = from->nring;
    to->nangle = from->nangle;

    memcpy(table, from->centre, (size_t)(2 * nring) * sizeof *table);
    double *radius = table + 2 * nring;
    offset_radii(from, offset, scratch, radius);
    for (int32_t k = 0; k < from->nring; k++) table[2 * nring + nradius + k] = ring_largest(from, radius, k);
    to->centre = table;
    to->radius = table + 2 * nring;
    to->largest = table + 2 * nring + nradius;
    for (int32_t end = 0; end < 2; end++) fit_cap(from, offset, end, to);
}


/* the caps rounded to float */
static void fill_caps(const mus__field_f64 *from, mus__field_f32 *to)
{
    for (int32_t end = 0; end < 2; end++) {
        to->pole[end] = (float)from->pole[end];
        to->middle[end] = (float)from->middle[end];
        to->axis_inverse[end] = (float)from->axis_inverse[end];
        to->share[end] = (float)from->share[end];
    }
}


/* the same rounded to float */
static void fill_float(const mus__field_f64 *from, mus__field_f32 *to, float *table)
{
    const int64_t nring = from->nring, nradius = nring * from->nangle, total = 3 * nring + nradius;
    fill_caps(from, to);
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


/* where the tables of the next field go */
typedef struct offset_tables {
    double *table64;
    float *table32;
} offset_tables;


/* a field in both precisions */
static void fill_field(const mus__offset_surface *surface, const mus__field *from, double *scratch,
                       offset_tables *tables, mus__field_f64 *to64, mus__field_f32 *to32)
{
    const int64_t size = (int64_t)from->nring * (from->nangle + 3);
    fill_double(from, surface->offset, scratch, to64, tables->table64);
    fill_float(to64, to32, tables->table32);
    tables->table64 += size;
    tables->table32 += size;
}


/* a part as it was made: the field of a posed body is carried by a frame, its limb is not */
static void fill_part(const mus__field *from, const mus__limb *limb, mus__offset_part *part)
{
    double least = OFFSET_FAR;
    memcpy(part->origin, limb->origin, sizeof part->origin);
    memcpy(part->axis, limb->axis, sizeof part->axis);
    memcpy(part->side, limb->side, sizeof part->side);
    memcpy(part->front, limb->front, sizeof part->front);
    memcpy(part->end, from->pole, sizeof part->end);
    part->reach = from->reach;
    for (int64_t i = 0; i < (int64_t)from->nring * from->nangle; i++)
        if (from->radius[i] < least) least = from->radius[i];
    part->safe = OFFSET_SAFE * least;
}


/* the stump of a leg that a foot is on, as the field has it while garments are put on: the leg goes on through the
 * floor, so that a trouser leg stays open below the ankle, and the foot comes into it from above */
static void fill_stump(const mus_body *body, int32_t l, mus__offset_surface *surface)
{
    const mus__part *part = &body->rig.part[l];
    const int32_t foot = part->limb + MUS__LIMB_FOOT_LEFT - MUS__LIMB_LEG_LEFT;
    const bool leg = part->limb >= MUS__LIMB_LEG_LEFT && part->limb < MUS__LIMB_FOOT_LEFT;
    if (!body->measured || !leg || body->limb[foot].gone || (l > 0 && body->rig.part[l - 1].limb == part->limb)) return;
    const double length = surface->part[l].stump = OFFSET_STUMP * body->field[l].s0;
    mus__field_f64 *to = &surface->slim64[l];
    to->pole[0] = -length;
    to->middle[0] = 0.0;
    to->axis_inverse[0] = 1.0 / length;
    to->share[0] = 1.0;
    fill_caps(to, &surface->slim32[l]);
}


/* everything of a surface whose context and offset are set */
static mus_status offset_make(mus__offset_surface *surface, const mus_body *body)
{
    mus_context *context = surface->context;
    const int32_t n = surface->nparts = body->nfield;
    int64_t total = 0, rings = 0, most = 0;
    for (int32_t l = 0; l < n; l++) {
        const int64_t own = (int64_t)body->field[l].nring * body->field[l].nangle;
        total += (int64_t)body->field[l].nring * (body->field[l].nangle + 3);
        rings = body->field[l].nring > rings ? body->field[l].nring : rings;
        most = own > most ? own : most;
    }
    surface->field32 = mus__new(context, 2 * (int64_t)n, sizeof *surface->field32);
    surface->field64 = mus__new(context, 2 * (int64_t)n, sizeof *surface->field64);
    surface->part = mus__new(context, n, sizeof *surface->part);
    surface->table32 = mus__room(context, 2 * total, sizeof *surface->table32);
    surface->table64 = mus__room(context, 2 * total, sizeof *surface->table64);
    double *scratch = mus__room(context, 3 * OFFSET_LANES * rings + most, sizeof *scratch);
    if (surface->field32 == NULL || surface->field64 == NULL || surface->part == NULL || surface->table32 == NULL ||
        surface->table64 == NULL || scratch == NULL) {
        mus__free(context, scratch);
        return mus__fail_memory(context, "the radius fields of a collider");
    }
    surface->slim32 = surface->field32 + n, surface->slim64 = surface->field64 + n;
    mus_status status = MUS_OK;
    offset_tables tables = {surface->table64, surface->table32};
    for (int32_t l = 0; l < n && status == MUS_OK; l++) {
        mus__field field = body->field[l];
        fill_field(surface, &field, scratch, &tables, &surface->slim64[l], &surface->slim32[l]);
        status = mus__digit_cover(body, l, scratch + 3 * OFFSET_LANES * rings, &field, &surface->part[l]);
        if (surface->part[l].digits) {
            fill_field(surface, &field, scratch, &tables, &surface->field64[l], &surface->field32[l]);
        } else {
            surface->field64[l] = surface->slim64[l];
            surface->field32[l] = surface->slim32[l];
        }
        fill_part(&field, &body->limb[body->rig.part[l].limb], &surface->part[l]);
        fill_stump(body, l, surface);
    }
    mus__free(context, scratch);
    return status;
}


void mus__offset_surface_leave(mus__offset_surface *surface)
{
    if (surface == NULL || --surface->users > 0) return;
    mus_context *context = surface->context;
    if (surface->kept != NULL) surface->kept->data = NULL;
    mus__free(context, surface->field32);
    mus__free(context, surface->field64);
    mus__free(context, surface->part);
    mus__free(context, surface->table32);
    mus__free(context, surface->table64);
    mus__free(context, surface);
}


/* the body that named the surface is gone, or names another one */
static void offset_forget(void *data)
{
    ((mus__offset_surface *)data)->kept = NULL;
}


mus_status mus__offset_surface_take(mus_context *context, const mus_body *body, double offset,
                                    mus__offset_surface **out)
{
    /* a body of another context may be in use by another thread: it names no surface */
    mus__body_kept *kept = body->context == context ? body->kept : NULL;
    mus__offset_surface *surface = kept != NULL ? kept->data : NULL;
    *out = NULL;
    if (surface != NULL && memcmp(&surface->offset, &offset, sizeof offset) == 0) {
        surface->users++;
        *out = surface;
        return MUS_OK;
    }
    surface = mus__new(context, 1, sizeof *surface);
    if (surface == NULL) return mus__fail_memory(context, "the radius fields of a collider");
    surface->context = context;
    surface->offset = offset;
    surface->users = 1;
    const mus_status status = offset_make(surface, body);
    if (status != MUS_OK) {
        mus__offset_surface_leave(surface);
        return status;
    }
    if (kept != NULL) {
        if (kept->data != NULL) kept->destroy(kept->data);
        *kept = (mus__body_kept){kept->users, surface, offset_forget};
        surface->kept = kept;
    }
    *out = surface;
    return MUS_OK;
}
