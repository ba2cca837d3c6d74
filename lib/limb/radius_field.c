/*
 * radius_field.c: a part of a limb's stack sampled into a radius field, and the depth of a point in it.
 *
 * The table has rings a few millimetres apart and `nangle` equal steps of the diamond angle, whose directions go to
 * evenly spaced points of the square |x| + |y| = 1. It is sampled from the splines that the surface is made from, so
 * the two differ only by the interpolation in the table: below 0.1 mm outside the caps, for 4 mm and 128 steps. The
 * query is radius_field_kernel.h in double.
 */
#include <math.h>
#include <string.h>

#include "limb/radius_field_double.h"

/* share of a cap's length that has rings; chosen: beyond it R(s) is steep, and the query uses the form that is smooth
 * through the pole */
#define FIELD_CAP 0.7


void mus__field_turns(int32_t n, double *turn)
{
    for (int32_t k = 0; k < n; k++) {
        /* corner floor(q) of the square, and the part t of the way to the next one */
        double q = 4.0 * k / n, t = q - floor(q);
        static const double corner[5][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 0}};
        const double *p = corner[(int)floor(q)], *r = corner[(int)floor(q) + 1];
        double x = p[0] + t * (r[0] - p[0]), y = p[1] + t * (r[1] - p[1]), length = sqrt(x * x + y * y);
        turn[2 * k] = x / length, turn[2 * k + 1] = y / length;
    }
}


/* centre (2) and radii (n) of the ring at s: the limb's own; in a round cap, at the part u of its length beyond the
 * joint, min(R(s), R(joint)) sqrt(1 - u^2), which lies within the limb in the rest pose and is a ball where the joint
 * is bent. joint (2 x n): radii at the two ends of the part */
static void field_ring(const mus__stack *stack, const mus__part *part, double s, const double *joint, double *centre,
                       double *radius)
{
    mus__stack_ring(stack, s, centre, radius);
    for (int end = 0; end < 2; end++) {
        double beyond = end == 0 ? part->end[0] - s : s - part->end[1];
        if (part->round[end] <= 0.0 || beyond <= 0.0) continue;
        double u = beyond / part->round[end], shrink = sqrt(fmax(1.0 - u * u, 0.0));
        const double *most = joint + (ptrdiff_t)end * stack->n;
        for (int32_t k = 0; k < stack->n; k++) radius[k] = shrink * fmin(radius[k], most[k]);
    }
}


/* place of a limb into a field, and room for its rings and directions. Errors: MUS_ERR_MEMORY */
static mus_status field_begin(mus_context *context, const mus__limb *limb, mus__field *out)
{
    memcpy(out->origin, limb->origin, sizeof out->origin);
    memcpy(out->axis, limb->axis, sizeof out->axis);
    memcpy(out->side, limb->side, sizeof out->side);
    memcpy(out->front, limb->front, sizeof out->front);
    out->centre = mus__new(context, 2 * (int64_t)out->nring, sizeof(double));
    out->radius = mus__room(context, (int64_t)out->nring * out->nangle, sizeof(double));
    out->largest = mus__new(context, out->nring, sizeof(double));
    if (out->centre && out->radius && out->largest) return MUS_OK;
    mus__field_free(context, out);
    return mus__fail_memory(context, "a contact field");
}


mus_status mus__field_like(mus_context *context, const mus__limb *limb, const mus__field *from, mus__field *out)
{
    *out = *from;
    mus_status status = field_begin(context, limb, out);
    if (status != MUS_OK) return status;
    for (int32_t j = 0; j < from->nring; j++) {
        out->centre[2 * j] = -from->centre[2 * j], out->centre[2 * j + 1] = from->centre[2 * j + 1];
        out->largest[j] = from->largest[j];
    }
    return MUS_OK;
}


mus_status mus__field_make(mus_context *context, const mus__stack *stack, const mus__part *part, double spacing,
                           mus__field *out)
{
    const mus__limb *limb = stack->limb;
    const double cap = part->deep ? part->end[0] - limb->pole[0] : part->round[0];
    const double length = part->end[1] - part->end[0], steps = fmin(ceil(length / spacing), 4000.0);
    const double ds = length / steps, low = floor(FIELD_CAP * cap / ds), high = floor(FIELD_CAP * part->round[1] / ds);
    memset(out, 0, sizeof *out);
    out->nring = (int32_t)(low + steps + high) + 1;
    out->nangle = stack->n;
    out->s0 = part->end[0] - low * ds;
    out->ds = ds;
    mus_status status = field_begin(context, limb, out);
    if (status != MUS_OK) return status;

    /* radii at the joints */
    double *joint = stack->work + limb->count, middle[2];
    for (int end = 0; end < 2; end++) mus__stack_ring(stack, part->end[end], middle, joint + (ptrdiff_t)end * stack->n);

    for (int32_t j = 0; j < out->nring; j++) {
        double s = j + 1 < out->nring || high > 0.0 ? out->s0 + j * out->ds : part->end[1];
        field_ring(stack, part, s, joint, out->centre + 2 * j, out->radius + (ptrdiff_t)j * out->nangle);
    }
    mus__field_bounds(out);
    out->fine[0] = out->nring, out->fine[1] = -1;

    /* ellipses of the caps: that of the round cap, or the limb's own */
    for (int end = 0; end < 2; end++) {
        bool round = part->round[end] > 0.0;
        double outward = end == 0 ? -1.0 : 1.0;
        out->pole[end] = round ? part->end[end] + outward * part->round[end] : limb->pole[end];
        out->middle[end] = round ? part->end[end] : stack->cap[end][0];
        out->half[end] = round ? part->round[end] : stack->cap[end][1];
    }
    return MUS_OK;
}


void mus__field_bounds(mus__field *field)
{
    field->reach = 0.0;
    for (int32_t j = 0; j < field->nring; j++) {
        const double *centre = field->centre + 2 * j, *radius = field->radius + (ptrdiff_t)j * field->nangle;
        double four[4] = {0.0}; /* a maximum of each quarter, so that they do not wait for each other */
        for (int32_t k = 0; k < field->nangle; k += 4)
            for (int32_t i = 0; i < 4; i++) four[i] = radius[k + i] > four[i] ? radius[k + i] : four[i];
        const double most = fmax(fmax(four[0], four[1]), fmax(four[2], four[3]));
        field->reach = fmax(field->reach, most + sqrt(centre[0] * centre[0] + centre[1] * centre[1]));
        field->largest[j] = most;
        if (j > 0) field->largest[j - 1] = fmax(field->largest[j - 1], most);
    }
}


void mus__field_steps(int32_t nangle, int32_t n, const double *turn, int32_t *entry, double *share)
{
    for (int32_t k = 0; k < n; k++) {
        const double a = turn[2 * k], b = turn[2 * k + 1], part = fabs(b) / (fabs(a) + fabs(b));
        const double q = b >= 0.0 ? (a >= 0.0 ? part : 2.0 - part) : (a < 0.0 ? 2.0 + part : 4.0 - part);
        const double step = n == nangle ? k : 0.25 * q * nangle, low = floor(step);
        entry[k] = (int32_t)low % nangle;
        share[k] = step - low;
    }
}


/* directions other than those of the table, and points between its rings: the square of the radius is linear, as in
 * field_kernel.h */
void mus__field_ring(const mus__field *field, double s, int32_t n, const int32_t *entry, const double *share,
                     double *centre, double *radius)
{
    const double u = (s - field->s0) / field->ds, last = field->nring - 1, in = fmin(fmax(u, 0.0), last);
    const int32_t j = (int32_t)fmin(in, last - 1.0), m = field->nangle;
    const double t = in - j, *low = field->radius + (ptrdiff_t)j * m, *high = low + m;
    double shrink = 1.0;
    if (u < -1e-9 || u > last + 1e-9) {
        const int end = u > 0.0;
        const double at = (s - field->middle[end]) / field->half[end];
        const double edge = (field->s0 + in * field->ds - field->middle[end]) / field->half[end];
        shrink = at * at >= 1.0 ? 0.0 : (1.0 - at * at) / (1.0 - edge * edge);
    }
    const double *c0 = field->centre + 2 * (ptrdiff_t)j;
    for (int i = 0; i < 2; i++) centre[i] = c0[i] + t * (c0[i + 2] - c0[i]);
    if (n == m && shrink == 1.0) { /* the directions are those of the table */
        for (int32_t k = 0; k < n && t == 0.0; k++) radius[k] = low[k];
        for (int32_t k = 0; k < n && t != 0.0; k++) {
            const double from = low[k] * low[k], to = high[k] * high[k];
            radius[k] = sqrt(from + t * (to - from));
        }
        return;
    }
    for (int32_t k = 0; k < n; k++) {
        const int32_t p = entry[k], q = p + 1 < m ? p + 1 : 0;
        const double w = share[k];
        if (w == 0.0 && t == 0.0) { /* an entry of the table */
            radius[k] = shrink == 1.0 ? low[p] : sqrt(shrink) * low[p];
            continue;
        }
        const double a = low[p] * low[p], b = high[p] * high[p];
        const double c = a + w * (low[q] * low[q] - a), d = b + w * (high[q] * high[q] - b);
        radius[k] = sqrt(shrink * (c + t * (d - c)));
    }
}


void mus__field_free(mus_context *context, mus__field *field)
{
    mus__free(context, field->centre);
    mus__free(context, field->radius);
    mus__free(context, field->largest);
    memset(field, 0, sizeof *field);
}


void mus__field_prepare(const mus__field *field, mus__body_field *out)
{
    memcpy(out->origin, field->origin, sizeof out->origin);
    memcpy(out->axis, field->axis, sizeof out->axis);
    memcpy(out->side, field->side, sizeof out->side);
    memcpy(out->front, field->front, sizeof out->front);
    out->s0 = field->s0, out->ds_inverse = 1.0 / field->ds;
    out->angle_scale = 0.25 * field->nangle;
    out->nring = field->nring, out->nangle = field->nangle;
    out->centre = field->centre, out->radius = field->radius, out->largest = field->largest;
    out->ring_last = field->nring - 1;
    for (int end = 0; end < 2; end++) {
        const double s = end == 0 ? 0.0 : field->ds * (field->nring - 1);
        out->pole[end] = field->pole[end] - out->s0;
        out->middle[end] = field->middle[end] - out->s0;
        out->axis_inverse[end] = 1.0 / field->half[end];
        out->share[end] = mus__body_field_share(s - out->middle[end], out->axis_inverse[end]);
    }
}


double mus__field_depth(const mus__field *field, const double *p, double *normal)
{
    mus__body_field f;
    mus__field_prepare(field, &f);
    return mus__field_depth_of(&f, p, normal);
}
