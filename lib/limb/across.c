/*
 * across.c: back and chest as broad from arm to arm as the tape says.
 *
 * across_back and across_front are taken half way down the armhole, from crease to crease, along the skin (ISO
 * 8559-1:2017; interscye breadth of ANSUR II). Where the crease lies depends on the corner of the torso beside the arm,
 * which no girth fixes: the shoulder blade and the muscles at the back of the armpit, the breast muscle in front. The
 * contour there gets a pair of bumps, or of hollows, at the creases.
 *
 *     crease(x)   the point of the arm's skin at the distance x from the middle plane, on the section of that height
 *     height(x)   distance of that point from the contour's centre, less the radius of the contour without its bump
 *     length(x)   tape over the contour with that bump, from crease to crease
 *
 * The length grows with x; x is the root, by false position on this one section. The rings of the torso from the bust
 * to the shoulder point get the bump times 1 - 3 u^2 + 2 u^3 (as in give.c), before fillets are made and girths kept.
 */
#include <math.h>
#include <string.h>

#include "base/elementary.h"
#include "geom/polygon.h"
#include "limb/across.h"

#define ACROSS_ROUNDS 12    /* most rounds of a root: bounds the time; five are usual */
#define ACROSS_CLOSE 5e-5   /* [m] a half length that near its target is reached */
#define ACROSS_STEPS 8      /* Newton steps to the arm's skin */
#define ACROSS_SLOPE 0.2    /* least slope of the arm's depth along the way; chosen: on a steeper skin more steps */
#define ACROSS_MOST 0.3     /* most height of a bump in parts of its distance from the centre; chosen */
#define ACROSS_INSIDE 0.15  /* [rad] a bump lies so far inside the crease, where the torso then goes steeply into the
                             * arm; chosen: somewhat less than half of a bump's half width */
#define ACROSS_BRACKET 4    /* most steps to a place below the root */

/* the section of the torso half way down the armhole */
typedef struct across {
    const mus__across *in;
    mus__contour *contour;
    int32_t n; /* directions */
    double turn[2 * MUS__FIELD_MOST];
    double way; /* 1 the back, -1 the front */
    int bump;   /* 1 the back, 0 the front: the contour's bump */
} across;


/* depth [m] of the point (x, b) of the section in the arm, and its normal (3) */
static double across_depth(const across *at, double x, double b, double *normal)
{
    const double p[3] = {at->in->side * x, at->contour->s, -b};
    double most = -1e30, n[3];
    for (int32_t q = 0; q < at->in->fields; q++) {
        if (at->in->part[q].limb != at->in->arm_index) continue;
        const double depth = mus__field_depth(&at->in->field[q], p, n);
        if (depth > most) most = depth, memcpy(normal, n, sizeof n);
    }
    return most;
}


/* b [m] of the arm's skin at x on the side asked for; false: the arm is not there */
static bool across_arm(const across *at, double x, double *b)
{
    const mus__limb *arm = at->in->arm;
    double most = 0.0, normal[3] = {0.0, 0.0, 0.0};
    for (int32_t i = 0; i < arm->count; i++) most = fmax(most, fmax(arm->contour[i].a, arm->contour[i].b));
    *b = -arm->origin[2] + at->way * most;
    for (int step = 0; step < ACROSS_STEPS; step++) {
        const double depth = across_depth(at, x, *b, normal), slope = -at->way * normal[2];
        if (depth < -1e29) return false;
        *b += at->way * depth / fmax(slope, ACROSS_SLOPE);
        if (fabs(depth) < ACROSS_CLOSE) return true;
    }
    return false;
}


/* half the tape [m] from crease to crease with the creases at x; sets the contour's bump. NaN: the arm is not there */
static double across_length(const across *at, double x)
{
    mus__contour *c = at->contour;
    double b, radius[MUS__FIELD_MOST], xy[2 * MUS__FIELD_MOST + 4];
    int32_t work[2 * MUS__FIELD_MOST + 4];
    if (!across_arm(at, x, &b)) return NAN;
    const double u = x, v = b - c->cb, rho = sqrt(u * u + v * v);
    c->bump[at->bump] = 0.0, c->bump_angle[at->bump] = mus__atan2(u, at->way * v) - ACROSS_INSIDE;
    const double radius_before = mus__contour_radius(c, u / rho, v / rho);
    c->bump[at->bump] = 1.0;
    const double h = (rho - radius_before) / (mus__contour_radius(c, u / rho, v / rho) - radius_before);
    c->bump[at->bump] = fmin(fmax(h, -ACROSS_MOST * rho), ACROSS_MOST * rho);

    /* the points between the creases; the hull without the chord */
    mus__contour_radii(c, at->n, at->turn, radius);
    int32_t count = 0;
    xy[count++] = -x, xy[count++] = b;
    for (int32_t k = 0; k < at->n; k++) {
        const double px = radius[k] * at->turn[2 * k], pb = c->cb + radius[k] * at->turn[2 * k + 1];
        if (fabs(px) < x && at->way * (pb - b) > 0.0) xy[count++] = px, xy[count++] = pb;
    }
    xy[count++] = x, xy[count++] = b;
    return 0.5 * mus__polygon_tape(count / 2, xy, work, work + count / 2) - x;
}


/* the bump of one side, so that the tape from arm to arm is `length` [m]; the nearest, where that is not reached */
static void across_solve(across *at, double length)
{
    const mus__contour before = *at->contour;
    double high = 0.5 * length, low = high, f = NAN, x = high, g = across_length(at, high) - 0.5 * length;

    /* the length grows faster than x, so x less what is too long is mostly below the root */
    for (int step = 0; step < ACROSS_BRACKET && g > 0.0 && !(f < 0.0); step++) {
        x = low - g;
        f = across_length(at, x) - 0.5 * length;
        if (isnan(f)) break;
        if (f >= 0.0) high = x, g = fmax(f, ACROSS_CLOSE);
        low = x;
    }
    for (int round = 0, last = 0; round < ACROSS_ROUNDS && f < 0.0 && g > 0.0; round++) {
        x = (f * high - g * low) / (f - g);
        const double h = across_length(at, x) - 0.5 * length;
        if (!(fabs(h) > ACROSS_CLOSE)) break;
        if (h < 0.0) {
            low = x, f = h;
            if (last == -1) g *= 0.5;
            last = -1;
        } else {
            high = x, g = h;
            if (last == 1) f *= 0.5;
            last = 1;
        }
    }
    if (isnan(across_length(at, x))) *at->contour = before;
}


/* share of the bumps at s: 1 at the section, and 0 at the ends of the range */
static double across_share(const across *at, double s)
{
    const double middle = at->contour->s, *range = at->in->range;
    const double u = s < middle ? (middle - s) / (middle - range[0]) : (s - middle) / (range[1] - middle);
    return u < 1.0 ? 1.0 - u * u * (3.0 - 2.0 * u) : 0.0;
}


/* add a share of the difference of the radii (n) to the rings of the torso, and of the bumps to its contours */
static void across_apply(const across *at, const double *more)
{
    for (int32_t p = 0; p < at->in->fields; p++) {
        mus__field *field = &at->in->field[p];
        if (at->in->part[p].limb != at->in->torso_index) continue;
        for (int32_t j = 0; j < field->nring; j++) {
            const double share = across_share(at, field->s0 + j * field->ds);
            double *radius = field->radius + (ptrdiff_t)j * field->nangle;
            for (int32_t k = 0; k < field->nangle && share > 0.0; k++) radius[k] += share * more[k];
        }
        mus__field_bounds(field);
    }
    for (int32_t i = 0; i < at->in->torso->count; i++) {
        mus__contour *c = &at->in->torso->contour[i];
        const double share = across_share(at, c->s);
        for (int side = 0; side < 2 && c != at->contour && share > 0.0; side++) {
            c->bump[side] = share * at->contour->bump[side];
            c->bump_angle[side] = at->contour->bump_angle[side];
        }
    }
}


void mus__limb_across(const mus__across *in)
{
    int32_t i = 0;
    while (i < in->torso->count && strcmp(in->torso->contour[i].name, "armhole") != 0) i++;
    if (i == in->torso->count) return;
    across at = {.in = in, .contour = &in->torso->contour[i]};
    for (int32_t p = 0; p < in->fields; p++)
        if (in->part[p].limb == in->torso_index) at.n = in->field[p].nangle;
    mus__field_turns(at.n, at.turn);
    double before[MUS__FIELD_MOST], more[MUS__FIELD_MOST];
    mus__contour_radii(at.contour, at.n, at.turn, before);

    /* the back last: a bump reaches a little round to the other side */
    for (at.bump = 0; at.bump < 2; at.bump++) {
        at.way = at.bump == 1 ? 1.0 : -1.0;
        across_solve(&at, at.bump == 1 ? in->back : in->front);
    }
    mus__contour_radii(at.contour, at.n, at.turn, more);
    for (int32_t k = 0; k < at.n; k++) more[k] -= before[k];
    across_apply(&at, more);
}
