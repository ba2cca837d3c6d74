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
 *     bust_span(angle, height)   = twice the X of the foremost point of the contour, where its depth is largest
 *     crotch_length(depth)       = tape along the torso's middle line from waist to waist, on a stack of 16 directions
 *
 * Both are monotone; the root is found by false position (Illinois) to 0.2 mm. A tape without them costs nothing.
 */
#include <math.h>
#include <string.h>

#include "base/elementary.h"
#include "body/body_make.h"
#include "geom/polygon.h"

#define FOLLOW_ROUNDS 24       /* most rounds of a root: bounds the time */
#define FOLLOW_CLOSE 2e-4      /* [m] a length that near its target is reached */
#define FOLLOW_HALVES 18       /* halvings of a range: to 4e-6 of it */
#define FOLLOW_SCALES 6        /* rounds of breasts and girth: each leaves a tenth of the difference */
#define FOLLOW_STEEPEST 0.6    /* distance of the foremost point from the middle of a bump, in widths: the steepest */
#define FOLLOW_ASIDE 0.98      /* largest angle of the foremost point off the front, in parts of the steepest; chosen */
#define FOLLOW_FRONT 0.01      /* breasts are further forward than the middle by this part of the depth; chosen */
#define FOLLOW_HIGH 0.5        /* most height of the breasts in parts of the half depth; chosen */
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

/* radius of a contour at an angle off the front [rad] */
static double follow_front(const mus__contour *c, double angle)
{
    return mus__contour_radius(c, mus__sin(angle), -mus__cos(angle));
}


/* breasts whose foremost point stands at the angle t off the front, `c` widths of a bump inside their middle. There the
 * depth (R + h e) cos t is largest over t, with e = exp(-c^2) and the width w:
 *
 *     h e (2 c / w - tan t) = R tan t - R'
 *
 * c is the largest one with which the breasts are at least `height` [m] high, and further forward than the middle
 * between them. Sets height and angle of the bumps; returns twice the distance from the middle plane [m] */
static double follow_breasts(mus__contour *shape, double t, double height)
{
    const double w = MUS__CONTOUR_BUMP, step = 1e-3, tangent = mus__tan(t), cosine = mus__cos(t);
    shape->bump[0] = 0.0;
    const double front = follow_front(shape, 0.0) * (1.0 + FOLLOW_FRONT), radius = follow_front(shape, t);
    const double slope = (follow_front(shape, t + step) - follow_front(shape, t - step)) / (2.0 * step);
    const double rise = radius * tangent - slope;
    double low = 0.5 * w * tangent, high = FOLLOW_STEEPEST; /* at `low` no height is enough */
    for (int round = 0; round < FOLLOW_HALVES; round++) {
        const double c = round == 0 ? high : 0.5 * (low + high), add = rise / (2.0 * c / w - tangent);
        const bool enough = add * mus__exp(c * c) >= height && (radius + add) * cosine >= front;
        if (round == 0 && enough) low = high;
        if (enough)
            low = c;
        else
            high = c;
    }
    const double add = rise / (2.0 * low / w - tangent);
    shape->bump[0] = add * mus__exp(low * low), shape->bump_angle[0] = t + low * w;
    return 2.0 * (radius + add) * mus__sin(t);
}


/* breasts of the bust contour with the foremost points `span` [m] apart, or as near to that as their greatest height
 * allows. Scaling the contour to its girth changes the span in proportion */
static void follow_bust(follow *at, double span)
{
    mus__limb *torso = &at->body->limb[MUS__LIMB_TORSO];
    for (int32_t i = 0; i < torso->count; i++) {
        mus__contour *c = &torso->contour[i], base = *c;
        if (c->girth != MUS_MEASURE_BUST || c->bump[0] <= 0.0) continue;
        double scale = 1.0;
        for (int round = 0; round < FOLLOW_SCALES; round++) {
            double low = 0.0, high = FOLLOW_ASIDE * mus__atan2(2.0 * FOLLOW_STEEPEST, MUS__CONTOUR_BUMP);
            *c = base;
            for (int step = 0; step < FOLLOW_HALVES; step++) {
                const double t = 0.5 * (low + high), got = scale * follow_breasts(c, t, base.bump[0]);
                if (got > span || c->bump[0] > FOLLOW_HIGH * base.b)
                    high = t;
                else
                    low = t;
            }
            follow_breasts(c, low, base.bump[0]);
            mus__contour_fit(c, c->target, at->body->def.samples, at->turn, at->xy, at->work);
            scale = c->a / base.a;
        }
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
    if (mus_tape_source(tape, MUS_MEASURE_BUST_SPAN) != MUS_SOURCE_NONE)
        follow_bust(&at, mus_tape_value(tape, MUS_MEASURE_BUST_SPAN));
    if (mus_tape_source(tape, MUS_MEASURE_CROTCH_LENGTH) == MUS_SOURCE_GIVEN)
        follow_rise(&at, mus_tape_value(tape, MUS_MEASURE_CROTCH_LENGTH) + more);
    return at.status;
}
