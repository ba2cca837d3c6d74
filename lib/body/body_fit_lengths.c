/*
 * body_fit_lengths.c: bust span and crotch length of the finished torso made those of the tape, where the tape gives
 * them.
 *
 * Girths and heights belong to one contour; these two lengths depend on shapes that no girth fixes, and those are
 * varied. The breasts of the bust contour move outwards or inwards, and rise where that is not enough. The contour
 * above the crotch, which has no girth of the tape, becomes deeper or flatter, and then the hip, which is fitted to its
 * girth again. The shapes stay within limits of real bodies; a tape beyond them gets the nearest length, which
 * body->made has.
 *
 *     bust_span(angle, height)   = twice the X of the foremost point of the contour, by a parabola through its samples
 *     crotch_length(depth)       = tape along the torso's middle line from waist to waist, on a stack of 16 directions
 *
 * Both are monotone; the root is found by false position (Illinois) to 0.2 mm. A tape without them costs nothing.
 */
#include <math.h>
#include <string.h>

#include "body/body_make.h"
#include "geom/polygon.h"

#define FOLLOW_ROUNDS 24       /* most rounds of a root: bounds the time */
#define FOLLOW_CLOSE 2e-4      /* [m] a length that near its target is reached */
#define FOLLOW_ANGLE_LOW 0.15  /* [rad] angle of the breasts off the front, least ... */
#define FOLLOW_ANGLE_HIGH 0.85 /* ... and most; chosen */
#define FOLLOW_RISE 1.8        /* most factor of the breasts' height; chosen */
#define FOLLOW_SEAT_LOW 0.50   /* depth of the contour above the crotch, in parts of the hip's, least ... */
#define FOLLOW_SEAT_HIGH 0.90  /* ... and most; chosen */
#define FOLLOW_HIP_LOW 0.84    /* factor of the hip's depth to breadth, least ... */
#define FOLLOW_HIP_HIGH 1.18   /* ... and most: two standard deviations of ANSUR II */
#define FOLLOW_ANGLES 16       /* directions of the stack of the middle line */
#define FOLLOW_STEPS 40        /* points of the middle line, front and back each */

/* the state of the search for one length */
typedef struct follow {
    mus_body *body;
    const double *turn;          /* (samples x 2) directions of the contours */
    double *xy;                  /* scratch of mus__contour_fit() */
    int32_t *work;
    mus__contour base, *contour; /* the contour as it was fitted, and the one that is varied */
    mus__contour seat, *hip;     /* the hip as it was fitted, and the one that is varied */
    double waist, rise, depth;   /* height [m]; factor of the breasts' height; depth over the hip's */
    mus_status status;
} follow;

/* a length [m] as a function of the varied shape x */
typedef double follow_length(follow *at, double x);


double mus__span_side(const double *before, const double *at, const double *after)
{
    const double bend = before[1] - 2.0 * at[1] + after[1];
    const double t = bend < 0.0 ? fmin(fmax(0.5 * (before[1] - after[1]) / bend, -0.5), 0.5) : 0.0;
    return at[0] + 0.5 * t * (after[0] - before[0]) + 0.5 * t * t * (before[0] - 2.0 * at[0] + after[0]);
}


/* the x from low to high at which a length that grows with x is `target` [m]; an end, where it is not reached */
static double follow_root(follow *at, follow_length *length, double target, double low, double high)
{
    double f = length(at, low) - target, g = length(at, high) - target, x = low;
    if (f >= 0.0) return low;
    if (g <= 0.0) return high;
    for (int round = 0, side = 0; round < FOLLOW_ROUNDS && at->status == MUS_OK; round++) {
        x = (f * high - g * low) / (f - g);
        const double h = length(at, x) - target;
        if (fabs(h) < FOLLOW_CLOSE) break;
        if (h < 0.0) {
            low = x, f = h;
            if (side == -1) g *= 0.5;
            side = -1;
        } else {
            high = x, g = h;
            if (side == 1) f *= 0.5;
            side = 1;
        }
    }
    return x;
}


/* ---- bust span ---- */

/* half the bust span [m] with the breasts at `angle` [rad] off the front */
static double follow_span(follow *at, double angle)
{
    const int32_t n = at->body->def.samples, first = 3 * n / 4;
    mus__contour *c = at->contour;
    double radius[MUS__CONTOUR_SAMPLES], place[MUS__CONTOUR_SAMPLES / 4 + 2][2];
    *c = at->base;
    c->bump_angle[0] = angle;
    c->bump[0] *= at->rise;
    mus__contour_fit(c, c->target, n, at->turn, at->xy, at->work);

    /* samples from one before the front to the side: X and Z */
    mus__contour_radii(c, n, at->turn, radius);
    int32_t best = 1;
    for (int32_t k = 0; k <= n / 4; k++) {
        const int32_t i = (first - 1 + k) % n;
        place[k][0] = radius[i] * at->turn[2 * i], place[k][1] = -radius[i] * at->turn[2 * i + 1];
        if (k > 1 && k < n / 4 && place[k][1] > place[best][1]) best = k;
    }
    return mus__span_side(place[best - 1], place[best], place[best + 1]);
}


/* largest angle of the breasts at which the span still grows: beyond it the middle of the chest is foremost */
static double follow_outmost(follow *at)
{
    double high = FOLLOW_ANGLE_HIGH;
    while (high > FOLLOW_ANGLE_LOW + 0.1 && follow_span(at, high) < follow_span(at, high - 0.05)) high -= 0.05;
    return high;
}


/* vary the breasts until the bust span is `span` [m] */
static void follow_bust(follow *at, double span)
{
    mus__limb *torso = &at->body->limb[MUS__LIMB_TORSO];
    for (int32_t i = 0; i < torso->count; i++) {
        mus__contour *c = &torso->contour[i];
        if (c->girth != MUS_MEASURE_BUST || c->bump[0] <= 0.0) continue;
        at->base = *c, at->contour = c, at->rise = 1.0;
        double high = follow_outmost(at);
        while (at->rise < FOLLOW_RISE && follow_span(at, high) < 0.5 * span) {
            at->rise += 0.1;
            high = follow_outmost(at);
        }
        follow_span(at, follow_root(at, follow_span, 0.5 * span, FOLLOW_ANGLE_LOW, high));
    }
}


/* ---- crotch length ---- */

/* length [m] of a tape along the torso's middle line, from the contours as they are */
static double follow_middle(follow *at)
{
    mus_body *body = at->body;
    mus__limb *torso = &body->limb[MUS__LIMB_TORSO];
    mus__stack stack;
    double turn[2 * FOLLOW_ANGLES], radius[FOLLOW_ANGLES], centre[2], line[2 * FOLLOW_STEPS + 1][2];
    int32_t work[2 * (2 * FOLLOW_STEPS + 1)];
    bool limited[MUS__LIMB_CONTOURS];
    if (at->status != MUS_OK) return 0.0;
    memcpy(limited, torso->limited, sizeof limited);
    mus__contour_turns(FOLLOW_ANGLES, turn);
    at->status = mus__stack_make(body->context, torso, FOLLOW_ANGLES, turn, &stack);
    if (at->status != MUS_OK) return 0.0;
    mus__stack_limit(&stack, torso);
    memcpy(torso->limited, limited, sizeof limited);

    /* points are closer near the pole, where the line turns */
    for (int32_t j = 0; j <= FOLLOW_STEPS; j++) {
        const double u = (double)j / FOLLOW_STEPS, s = torso->pole[0] + u * u * (at->waist - torso->pole[0]);
        mus__stack_ring(&stack, s, centre, radius);
        const int32_t front = FOLLOW_STEPS - j, back = FOLLOW_STEPS + j;
        line[front][0] = centre[1] - radius[3 * FOLLOW_ANGLES / 4], line[front][1] = s;
        const double seat = centre[1] + (j > 0 ? radius[FOLLOW_ANGLES / 4] : 0.0);
        line[back][0] = seat - mus__relief_cleft(body, s, -seat), line[back][1] = s;
    }
    mus__stack_free(body->context, &stack);
    const double *a = line[0], *b = line[2 * FOLLOW_STEPS];
    const double chord = sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]));
    return mus__polygon_tape(2 * FOLLOW_STEPS + 1, line[0], work, work + 2 * FOLLOW_STEPS + 1) - chord;
}


/* crotch length with the contour above the crotch `part` of the hip deep */
static double follow_crotch(follow *at, double part)
{
    at->contour->b = part * at->hip->b;
    return follow_middle(at);
}


/* crotch length with the hip `part` of its depth, and the contour above the crotch in proportion */
static double follow_hip(follow *at, double part)
{
    mus__contour *hip = at->hip;
    *hip = at->seat;
    hip->b *= part;
    mus__contour_fit(hip, hip->target, at->body->def.samples, at->turn, at->xy, at->work);
    return follow_crotch(at, at->depth);
}


/* vary the contour above the crotch, then the hip, until the crotch length is `length` [m] */
static void follow_rise(follow *at, double length)
{
    mus__limb *torso = &at->body->limb[MUS__LIMB_TORSO];
    if (torso->count < 2 || torso->contour[1].girth != MUS_MEASURE_HIP) return;
    at->contour = &torso->contour[0], at->hip = &torso->contour[1];
    at->seat = *at->hip;
    at->waist = at->body->skeleton.waist;
    at->depth = follow_root(at, follow_crotch, length, FOLLOW_SEAT_LOW, FOLLOW_SEAT_HIGH);
    const double got = follow_crotch(at, at->depth);
    if (at->status != MUS_OK || fabs(got - length) < 2.0 * FOLLOW_CLOSE) return;
    const double part = got > length ? follow_root(at, follow_hip, length, FOLLOW_HIP_LOW, 1.0)
                                     : follow_root(at, follow_hip, length, 1.0, FOLLOW_HIP_HIGH);
    follow_hip(at, part);
}


mus_status mus__body_follow(mus_body *body, const mus_tape *tape, double more, const double *turn, double *xy,
                            int32_t *work)
{
    follow at = {.body = body, .turn = turn, .xy = xy, .work = work, .status = MUS_OK};
    if (body->def.ellipse) return MUS_OK;
    if (mus_tape_source(tape, MUS_MEASURE_BUST_SPAN) == MUS_SOURCE_GIVEN)
        follow_bust(&at, mus_tape_value(tape, MUS_MEASURE_BUST_SPAN));
    if (mus_tape_source(tape, MUS_MEASURE_CROTCH_LENGTH) == MUS_SOURCE_GIVEN)
        follow_rise(&at, mus_tape_value(tape, MUS_MEASURE_CROTCH_LENGTH) + more);
    return at.status;
}
