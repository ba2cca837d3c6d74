/*
 * contour_stack.c: the in-between contours of a limb, by splines along its axis.
 *
 * All contours of a limb are sampled in the same directions. Sample k is centre(s) + R_k(s) (cos t_k, sin t_k); centre
 * and R_k are natural cubic splines of s through the contours (Metaaphanon and Kanongchaiyos 2005, eq. 7 to 11, whose
 * closest-point map is the identity on k here).
 *
 * A natural spline overshoots where girths jump (neck to shoulder, armpit to bust). Where an in-between girth leaves
 * the interval of its two neighbours by more than 3 %, the contours on both sides are marked, and the slope of every
 * sample there is limited to that of a monotone curve: 0 at an extremum, else at most three times the smaller of the
 * neighbouring slopes (Fritsch and Carlson, Monotone Piecewise Cubic Interpolation, 1980). Elsewhere the curve is the
 * natural spline to the last bit.
 *
 * Beyond the end contours a cap closes the limb: a quarter of an ellipse in s whose slope continues that of the stack,
 * R(s) = R_end sqrt(1 - ((s - m) / L)^2) / sqrt(1 - ((s_end - m) / L)^2).
 */
#include <math.h>
#include <string.h>

#include "limb/contour_stack.h"
#include "tape/tape_internal.h"
#include "geom/polygon.h"

/* overshoot: girths are compared at PROBES - 1 heights between two contours, and may leave the interval of the two
 * girths by 2.6 %; the girths between these heights then keep to 3 % on all table sizes
 * (tests/limb/test_contour_stack.c) */
#define STACK_PROBES 6
#define STACK_LEAST 0.974
#define STACK_MOST 1.026

/* fall of the radius over a cap, -R' length / R: at 1/2 the quarter of an ellipse becomes a cone. Chosen: from
 * FALL_MOST on, the end contour lies at CAP_MOST of the half axis */
#define STACK_FALL_MOST 0.49
#define STACK_CAP_MOST 0.96


/* name of a contour in a message: the measure that sets its place or its girth, or its own name */
static const char *stack_word(const mus__contour *contour)
{
    const char *name = mus_measure_name(contour->height);
    if (name == NULL) name = mus_measure_name(contour->girth);
    return name != NULL ? name : contour->name;
}


/* remove contour i */
static void stack_leave_out(mus__limb *limb, int32_t i)
{
    limb->count--;
    memmove(&limb->contour[i], &limb->contour[i + 1], (size_t)(limb->count - i) * sizeof limb->contour[0]);
}


mus_status mus__limb_check(mus_context *context, mus__limb *limb, double gap)
{
    char low[MUS__TAPE_TEXT_BYTES], high[MUS__TAPE_TEXT_BYTES], least[MUS__TAPE_TEXT_BYTES];
    for (int32_t i = 0; i + 1 < limb->count;) {
        mus__contour *p = &limb->contour[i], *q = p + 1;
        if (q->s - p->s >= gap) {
            i++;
        } else if (!q->hard && (p->hard || p->girth != MUS_NONE || q->girth == MUS_NONE)) {
            stack_leave_out(limb, i + 1);
        } else if (!p->hard) {
            stack_leave_out(limb, i);
            if (i > 0) i--;
        } else {
            return mus__fail(context, MUS_ERR_BODY, "contours cross: %s (%s at %s) and %s (%s at %s) are not %s apart",
                             q->name, stack_word(q), mus__tape_text(0, q->s, high), p->name, stack_word(p),
                             mus__tape_text(0, p->s, low), mus__tape_text(0, gap, least));
        }
    }

    for (int32_t i = 0; i < limb->count; i++) limb->limited[i] = limb->contour[i].flat;

    /* a cap needs room between the end contour and the pole */
    for (int end = 0; end < 2; end++) {
        const mus__contour *last = &limb->contour[end == 0 ? 0 : limb->count - 1];
        double room = end == 0 ? last->s - limb->pole[0] : limb->pole[1] - last->s;
        if (room >= 0.25 * gap) continue;
        const char *name = mus_measure_name(limb->end[end]);
        return mus__fail(context, MUS_ERR_BODY,
                         "contours cross: no room between %s (%s at %s) and the end of %s (%s at %s)", last->name,
                         stack_word(last), mus__tape_text(0, last->s, low), limb->name,
                         name != NULL ? name : limb->name, mus__tape_text(0, limb->pole[end], high));
    }
    return MUS_OK;
}


/* `slope` limited to that of a monotone curve with the chord slopes `before` and `after` */
static double stack_monotone(double before, double after, double slope)
{
    if (before * after <= 0.0) return 0.0;
    double most = 3.0 * fmin(fabs(before), fabs(after)), sign = before > 0.0 ? 1.0 : -1.0;
    double along = slope * sign;
    return sign * (along < 0.0 ? 0.0 : along > most ? most : along);
}


/* second derivatives m (count x width) of `width` natural splines through the values (count x width), by the Thomas
 * algorithm; the last row, which is 0, is not written. Scratch: ratio (count) */
static void stack_second(const mus__limb *limb, const double *values, int32_t width, double *ratio, double *m)
{
    const int32_t n = limb->count;
    ratio[0] = 0.0;
    for (int32_t k = 0; k < width; k++) m[k] = 0.0;
    for (int32_t i = 1; i + 1 < n; i++) {
        const double h0 = limb->contour[i].s - limb->contour[i - 1].s;
        const double h1 = limb->contour[i + 1].s - limb->contour[i].s, pivot = 2.0 * (h0 + h1) - h0 * ratio[i - 1];
        const double *y = values + (ptrdiff_t)i * width;
        double *right = m + (ptrdiff_t)i * width;
        ratio[i] = h1 / pivot;
        for (int32_t k = 0; k < width; k++)
            right[k] =
                (6.0 * ((y[k + width] - y[k]) / h1 - (y[k] - y[k - width]) / h0) - h0 * right[k - width]) / pivot;
    }
    for (int32_t i = n - 3; i > 0; i--) {
        double *row = m + (ptrdiff_t)i * width;
        for (int32_t k = 0; k < width; k++) row[k] -= ratio[i] * row[k + width];
    }
}


/* slopes (count x width) of the natural splines through the values (count x width), limited at the marked contours */
static void stack_slopes(const mus__stack *stack, const double *values, int32_t width, double *slopes)
{
    const mus__limb *limb = stack->limb;
    const int32_t n = limb->count;
    stack_second(limb, values, width, stack->work, slopes);

    /* in place of the second derivatives m: slope = dy/h - h (2 m_i + m_{i+1}) / 6; the last row first, whose m is 0 */
    double h = limb->contour[n - 1].s - limb->contour[n - 2].s;
    double *d = slopes + (ptrdiff_t)(n - 1) * width;
    const double *y = values + (ptrdiff_t)(n - 1) * width;
    for (int32_t k = 0; k < width; k++) d[k] = (y[k] - y[k - width]) / h + h * d[k - width] / 6.0;
    for (int32_t i = 0; i + 1 < n; i++) {
        h = limb->contour[i + 1].s - limb->contour[i].s;
        d = slopes + (ptrdiff_t)i * width, y = values + (ptrdiff_t)i * width;
        for (int32_t k = 0; k < width; k++) {
            const double after = i + 2 < n ? d[k + width] : 0.0;
            d[k] = (y[k + width] - y[k]) / h - h * (2.0 * d[k] + after) / 6.0;
        }
    }

    for (int32_t i = 0; i < n; i++) {
        if (!limb->limited[i]) continue;
        const double low = i > 0 ? limb->contour[i].s - limb->contour[i - 1].s : 0.0;
        const double high = i + 1 < n ? limb->contour[i + 1].s - limb->contour[i].s : 0.0;
        d = slopes + (ptrdiff_t)i * width, y = values + (ptrdiff_t)i * width;
        for (int32_t k = 0; k < width; k++) {
            const double before = i > 0 ? (y[k] - y[k - width]) / low : (y[k + width] - y[k]) / high;
            const double after = i + 1 < n ? (y[k + width] - y[k]) / high : before;
            d[k] = stack_monotone(before, after, d[k]);
        }
    }
}


/* ellipse of the cap at an end whose slope continues the mean slope of the stack: with k = -R' length / R the end
 * contour lies at u = k / (1 - k) of the half axis L, and L = length / (1 - u) */
static void stack_cap(mus__stack *stack, int end)
{
    const mus__limb *limb = stack->limb;
    int32_t i = end == 0 ? 0 : limb->count - 1;
    double radius = 0.0, slope = 0.0, length = fabs(limb->pole[end] - limb->contour[i].s);
    for (int32_t k = 0; k < stack->n; k++) {
        radius += stack->radius[(ptrdiff_t)i * stack->n + k];
        slope += stack->slope[(ptrdiff_t)i * stack->n + k];
    }
    double fall = (end == 0 ? slope : -slope) * length / radius;
    double u = fall <= 0.0 ? 0.0 : fall >= STACK_FALL_MOST ? STACK_CAP_MOST : fall / (1.0 - fall);
    double axis = length / (1.0 - u);
    stack->cap[end][0] = end == 0 ? limb->pole[0] + axis : limb->pole[1] - axis;
    stack->cap[end][1] = axis;
}


static void stack_all_slopes(mus__stack *stack)
{
    stack_slopes(stack, stack->radius, stack->n, stack->slope);
    stack_slopes(stack, stack->centre, 2, stack->drift);
    stack_cap(stack, 0);
    stack_cap(stack, 1);
}


mus_status mus__stack_make(mus_context *context, const mus__limb *limb, int32_t n, const double *turn, mus__stack *out)
{
    memset(out, 0, sizeof *out);
    int64_t count = limb->count;
    out->limb = limb;
    out->n = n;
    out->turn = turn;
    out->radius = mus__room(context, count * n, sizeof(double));
    out->slope = mus__room(context, count * n, sizeof(double));
    out->centre = mus__new(context, count * 2, sizeof(double));
    out->drift = mus__new(context, count * 2, sizeof(double));
    out->work = mus__room(context, count + (int64_t)n * 3, sizeof(double));
    if (!out->radius || !out->slope || !out->centre || !out->drift || !out->work) {
        mus__stack_free(context, out);
        return mus__fail_memory(context, "the contours of a limb");
    }

    for (int32_t i = 0; i < limb->count; i++) {
        const mus__contour *contour = &limb->contour[i];
        out->centre[2 * i] = contour->ca, out->centre[2 * i + 1] = contour->cb;
        mus__contour_radii(contour, n, turn, out->radius + (ptrdiff_t)i * n);
    }
    stack_all_slopes(out);
    return MUS_OK;
}


void mus__stack_free(mus_context *context, mus__stack *stack)
{
    mus__free(context, stack->radius);
    mus__free(context, stack->slope);
    mus__free(context, stack->centre);
    mus__free(context, stack->drift);
    mus__free(context, stack->work);
    memset(stack, 0, sizeof *stack);
}


/* perimeter [m] of the in-between contour at s. Scratch: radius (n), xy (2n) */
static double stack_girth(const mus__stack *stack, double s, double *radius, double *xy)
{
    double centre[2];
    mus__stack_ring(stack, s, centre, radius);
    for (int32_t k = 0; k < stack->n; k++) {
        xy[2 * k] = radius[k] * stack->turn[2 * k];
        xy[2 * k + 1] = radius[k] * stack->turn[2 * k + 1];
    }
    return mus__polygon_perimeter(stack->n, xy);
}


/* whether a girth between contours i and i + 1, whose girths are `low` and `high`, leaves their interval. Scratch: work
 * (3n) */
static bool stack_overshoots(const mus__stack *stack, int32_t i, double low, double high, double *work)
{
    const mus__contour *p = &stack->limb->contour[i];
    const double least = STACK_LEAST * fmin(low, high), most = STACK_MOST * fmax(low, high);
    for (int32_t j = 1; j < STACK_PROBES; j++) {
        double girth = stack_girth(stack, p[0].s + (p[1].s - p[0].s) * j / STACK_PROBES, work, work + stack->n);
        if (girth < least || girth > most) return true;
    }
    return false;
}


void mus__stack_limit(mus__stack *stack, mus__limb *limb)
{
    double girth[MUS__LIMB_CONTOURS], *work = stack->work + limb->count;
    bool fresh[MUS__LIMB_CONTOURS]; /* the curve between this contour and the next changed since it was checked */
    for (int32_t i = 0; i < limb->count; i++) {
        girth[i] = stack_girth(stack, limb->contour[i].s, work, work + stack->n);
        fresh[i] = true;
    }

    /* a mark changes the curve on both sides of its contour, so those intervals are checked again */
    for (int32_t round = 0; round < limb->count; round++) {
        bool more = false, next[MUS__LIMB_CONTOURS] = {false};
        for (int32_t i = 0; i + 1 < limb->count; i++) {
            if (!fresh[i] || (limb->limited[i] && limb->limited[i + 1])) continue;
            if (!stack_overshoots(stack, i, girth[i], girth[i + 1], work)) continue;
            limb->limited[i] = limb->limited[i + 1] = true;
            next[i > 0 ? i - 1 : 0] = next[i + 1] = true;
            more = true;
        }
        if (!more) break;
        memcpy(fresh, next, sizeof fresh);
        stack_all_slopes(stack);
    }
}


/* cubic Hermite basis (4) at t in 0..1 of an interval h: factors of value and slope at its start, then at its end */
static void stack_basis(double t, double h, double *basis)
{
    double t2 = t * t, t3 = t2 * t;
    basis[0] = 2.0 * t3 - 3.0 * t2 + 1.0;
    basis[1] = h * (t3 - 2.0 * t2 + t);
    basis[2] = 3.0 * t2 - 2.0 * t3;
    basis[3] = h * (t3 - t2);
}


/* the contour at s of a cap: the end contour, scaled about its centre */
static void stack_cap_ring(const mus__stack *stack, int end, double s, double *centre, double *radius)
{
    const mus__limb *limb = stack->limb;
    int32_t i = end == 0 ? 0 : limb->count - 1;
    double middle = stack->cap[end][0], axis = stack->cap[end][1];
    double u = (s - middle) / axis, v = (limb->contour[i].s - middle) / axis;
    double shrink = u * u >= 1.0 ? 0.0 : sqrt((1.0 - u * u) / (1.0 - v * v));
    for (int32_t k = 0; k < 2; k++) centre[k] = stack->centre[2 * i + k];
    for (int32_t k = 0; k < stack->n; k++) radius[k] = shrink * stack->radius[(ptrdiff_t)i * stack->n + k];
}


void mus__stack_ring(const mus__stack *stack, double s, double *centre, double *radius)
{
    const mus__limb *limb = stack->limb;
    int32_t n = stack->n, last = limb->count - 1;
    if (s < limb->contour[0].s || s > limb->contour[last].s) {
        stack_cap_ring(stack, s < limb->contour[0].s ? 0 : 1, s, centre, radius);
        return;
    }

    int32_t i = 0;
    while (i + 1 < last && s >= limb->contour[i + 1].s) i++;
    double h = limb->contour[i + 1].s - limb->contour[i].s, basis[4];
    stack_basis((s - limb->contour[i].s) / h, h, basis);
    const double *c = stack->centre + 2 * i, *dc = stack->drift + 2 * i;
    for (int32_t k = 0; k < 2; k++)
        centre[k] = basis[0] * c[k] + basis[1] * dc[k] + basis[2] * c[k + 2] + basis[3] * dc[k + 2];
    const double *r = stack->radius + (ptrdiff_t)i * n, *dr = stack->slope + (ptrdiff_t)i * n;
    const double p0 = basis[0], d0 = basis[1], p1 = basis[2], d1 = basis[3];
    for (int32_t k = 0; k < n; k++) radius[k] = p0 * r[k] + d0 * dr[k] + p1 * r[k + n] + d1 * dr[k + n];

    /* the wall cuts in-between contours too */
    if (limb->wall_side == 0.0) return;
    for (int32_t k = 0; k < n; k++) {
        double inward = -stack->turn[2 * k] * limb->wall_side;
        if (inward <= 0.0) continue;
        double most = (centre[0] * limb->wall_side - limb->wall) / inward;
        if (radius[k] > most) radius[k] = most;
    }
}
