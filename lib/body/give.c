/*
 * give.c: contours give way, so that the finished surface has the girths of the tape.
 *
 * A fillet or a detail that reaches a contour changes its girth. The rings about the contour are scaled by
 *
 *     1 + e phi(s),   phi = 1 - 3 u^2 + 2 u^3,   u = |s - s_i| / (distance of the next contour on that side)
 *
 * in the fields, and the contour itself by 1 + e, until the tape round its section is that of the tape.
 */
#include <math.h>

#include "body/body_make.h"
#include "geom/polygon.h"
#include "geom/vec.h"

#define GIVE_ROUNDS 12   /* most rounds; four are usual */
#define GIVE_CLOSE 1e-13 /* [m] a girth that near is reached */
#define GIVE_GAIN 2.0    /* largest factor of the secant: above it the difference is not the legs'; chosen */
#define GIVE_MOST 0.1    /* largest part of a girth that a contour gives; chosen */


void mus__give_scale(mus_body *body, int32_t l, int32_t i, double more, const double *turn)
{
    mus__limb *limb = &body->limb[l];
    mus__contour *c = &limb->contour[i];
    const double low = i > 0 ? limb->contour[i - 1].s : limb->pole[0];
    const double high = i + 1 < limb->count ? limb->contour[i + 1].s : limb->pole[1];
    for (int32_t p = 0; p < body->nfield; p++) {
        mus__field *field = &body->field[p];
        if (body->rig.part[p].limb != l) continue;
        const int32_t first = (int32_t)fmax(ceil((low - field->s0) / field->ds), 0.0);
        for (int32_t j = first; j < field->nring; j++) {
            const double s = field->s0 + j * field->ds,
                         u = s < c->s ? (c->s - s) / (c->s - low) : (s - c->s) / (high - c->s);
            if (s >= high) break;
            const double scale = 1.0 + more * (1.0 - u * u * (3.0 - 2.0 * u));
            double *radius = field->radius + (ptrdiff_t)j * field->nangle;
            const double room = field->centre[2 * j] * limb->wall_side - limb->wall;
            for (int32_t k = 0; k < field->nangle; k++) radius[k] *= scale;
            for (int32_t k = 0; k < field->nangle && limb->wall_side != 0.0;
                 k++) { /* a leg keeps off the middle plane */
                const double inward = -turn[2 * k] * limb->wall_side;
                if (radius[k] * inward > room) radius[k] = room / inward;
            }
        }
    }
    c->a *= 1.0 + more, c->b *= 1.0 + more;
    c->bump[0] *= 1.0 + more, c->bump[1] *= 1.0 + more;
}


double mus__give_tape(int32_t n, const double *turn, const double *radius, double *xy, int32_t *work)
{
    for (int32_t k = 0; k < n; k++) xy[2 * k] = radius[k] * turn[2 * k], xy[2 * k + 1] = radius[k] * turn[2 * k + 1];
    return mus__polygon_tape(n, xy, work, work + n);
}


/* directions of the surface in the tables, scratch for a tape round torso and legs, and what scaling a contour did to
 * its girth the last time */
typedef struct give {
    double turn[2 * MUS__CONTOUR_SAMPLES], step[2 * MUS__FIELD_MOST]; /* directions of the surface and of the tables */
    int32_t n, angles, entry[MUS__CONTOUR_SAMPLES], work[6 * MUS__CONTOUR_SAMPLES];
    double share[MUS__CONTOUR_SAMPLES], radius[MUS__CONTOUR_SAMPLES], xy[6 * MUS__CONTOUR_SAMPLES];
    bool even;                                         /* the left half alone */
    double made[MUS__LIMB_COUNT][MUS__LIMB_CONTOURS];  /* girths of the round before [m] */
    double scale[MUS__LIMB_COUNT][MUS__LIMB_CONTOURS]; /* and by how much they were scaled then */
} give;


/* take the directions of limb l */
static void give_turn(const mus_body *body, int32_t l, give *at)
{
    const int32_t n = body->limb[l].samples, angles = mus__body_angles(body, l);
    if (at->n == n && at->angles == angles) return;
    at->n = n, at->angles = angles;
    mus__field_turns(n, at->turn);
    mus__field_turns(angles, at->step);
    mus__field_steps(angles, n, at->turn, at->entry, at->share);
}


/* append the section of limb l at s to at->xy, which has `count` points; returns their number. `mirrored`: that of the
 * limb on the other side */
static int32_t give_section(const mus_body *body, int32_t l, double s, bool mirrored, give *at, int32_t count)
{
    double centre[2];
    if (body->limb[l].gone || s <= body->limb[l].pole[0] || s >= body->limb[l].pole[1]) return count;
    give_turn(body, l, at);
    mus__body_section(body, l, s, at->n, at->entry, at->share, centre, at->radius);
    for (int32_t k = 0; k < at->n; k++, count++) {
        const double a = centre[0] + at->radius[k] * at->turn[2 * k];
        at->xy[2 * count] = mirrored ? -a : a;
        at->xy[2 * count + 1] = centre[1] + at->radius[k] * at->turn[2 * k + 1];
    }
    return count;
}


/* girth [m] of contour i of limb l on the finished surface; the legs stand out of the hip */
static double give_made(const mus_body *body, int32_t l, int32_t i, give *at)
{
    const mus__contour *c = &body->limb[l].contour[i];
    int32_t count = give_section(body, l, c->s, false, at, 0);
    for (int32_t right = 0; right < 2 && mus__girth_has_legs(c->girth); right++) {
        const bool mirrored = at->even && right == 1;
        count = give_section(body, MUS__LIMB_LEG_LEFT + (mirrored ? 0 : right), c->s, mirrored, at, count);
    }
    return mus__polygon_tape(count, at->xy, at->work, at->work + count);
}


bool mus__girth_has_legs(int32_t girth)
{
    return girth == MUS_MEASURE_HIP || girth == MUS_MEASURE_HIGH_HIP;
}


/* the contour of a limb that is nearest to s */
static int32_t give_nearest(const mus__limb *limb, double s)
{
    int32_t best = 0;
    for (int32_t i = 1; i < limb->count; i++)
        if (fabs(limb->contour[i].s - s) < fabs(limb->contour[best].s - s)) best = i;
    return best;
}


/* scale the rings of limb l about contour i by 1 + more */
static void give_limb(mus_body *body, int32_t l, int32_t i, double more, give *at)
{
    if (body->limb[l].gone || (at->even && mus__limb_is_right(l))) return;
    give_turn(body, l, at);
    mus__give_scale(body, l, i, more, at->step);
}


/* the scale that gives a contour its girth. Where the legs share a girth the contour alone leaves a third of the
 * difference, and the step is that of the secant through this round and the one before */
static double give_step(give *at, int32_t l, int32_t i, bool shared, double made, double asked)
{
    const double before = at->made[l][i], last = at->scale[l][i], part = asked / made - 1.0;
    double gain = shared && last != 0.0 && made != before ? last * made / (made - before) : 1.0;
    if (!(gain > 1.0 && gain < GIVE_GAIN)) gain = 1.0;
    at->made[l][i] = made, at->scale[l][i] = gain * part;
    return gain * part;
}


/* scale the rings about each contour once; true: a girth was not reached. At the hip the tops of the legs give way too
 */
static bool give_round(mus_body *body, give *at)
{
    bool more = false;
    for (int32_t l = 0; l < MUS__LIMB_COUNT; l++)
        for (int32_t i = 0; i < body->limb[l].count && !body->limb[l].gone; i++) {
            const mus__contour *c = &body->limb[l].contour[i];
            if (c->girth == MUS_NONE || (at->even && mus__limb_is_right(l))) continue;
            const double made = give_made(body, l, i, at), asked = body->asked[c->girth];
            if (fabs(made - asked) < GIVE_CLOSE || fabs(asked / made - 1.0) > GIVE_MOST) continue;
            more = true;
            const double part = give_step(at, l, i, mus__girth_has_legs(c->girth), made, asked);
            give_limb(body, l, i, part, at);
            for (int32_t leg = MUS__LIMB_LEG_LEFT; leg <= MUS__LIMB_LEG_RIGHT && mus__girth_has_legs(c->girth); leg++)
                give_limb(body, leg, give_nearest(&body->limb[leg], c->s), part, at);
        }
    return more;
}


mus_status mus__body_give(mus_body *body)
{
    give *at = mus__new(body->context, 1, sizeof *at);
    if (at == NULL) return mus__fail_memory(body->context, "measuring a body");
    at->even = mus__body_is_even(body);
    for (int round = 0; round < GIVE_ROUNDS && give_round(body, at); round++) continue;
    for (int32_t p = 0; p < body->nfield; p++)
        if (!at->even || !mus__limb_is_right(body->rig.part[p].limb)) mus__field_bounds(&body->field[p]);
    mus__free(body->context, at);
    return MUS_OK;
}
