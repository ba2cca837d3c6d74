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

#define GIVE_ROUNDS 3    /* most rounds: each leaves a hundredth of the difference or less */
#define GIVE_CLOSE 1e-6  /* [m] a girth that near is reached */
#define GIVE_MOST 0.1    /* largest part of a girth that a contour gives; chosen */


void mus__give_scale(mus_body *body, int32_t l, int32_t i, double more)
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
            const double s = field->s0 + j * field->ds, u = s < c->s ? (c->s - s) / (c->s - low) : (s - c->s) / (high - c->s);
            if (s >= high) break;
            const double scale = 1.0 + more * (1.0 - u * u * (3.0 - 2.0 * u));
            double *radius = field->radius + (ptrdiff_t)j * field->nangle;
            for (int32_t k = 0; k < field->nangle; k++) radius[k] *= scale;
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


/* the part of limb l that contains s */
static const mus__field *give_field(const mus_body *body, int32_t l, double s)
{
    int32_t found = 0;
    for (int32_t p = 0; p < body->nfield; p++)
        if (body->rig.part[p].limb == l && (body->rig.part[found].limb != l || s >= body->rig.part[p].end[0])) found = p;
    return &body->field[found];
}


void mus__body_give(mus_body *body, const double *turn, double *xy, int32_t *work)
{
    const int32_t n = body->def.samples;
    int32_t entry[MUS__CONTOUR_SAMPLES];
    double share[MUS__CONTOUR_SAMPLES], radius[MUS__CONTOUR_SAMPLES], centre[2];
    mus__field_steps(MUS__FIELD_ANGLES, n, turn, entry, share);
    for (int32_t l = 0; l < MUS__LIMB_COUNT; l++)
        for (int32_t i = 0; i < body->limb[l].count && !body->limb[l].gone; i++) {
            const mus__contour *c = &body->limb[l].contour[i];
            for (int round = 0; round < GIVE_ROUNDS && c->girth != MUS_NONE; round++) {
                mus__field_ring(give_field(body, l, c->s), c->s, n, entry, share, centre, radius);
                const double made = mus__give_tape(n, turn, radius, xy, work), asked = body->asked[c->girth];
                if (fabs(made - asked) < GIVE_CLOSE || fabs(made - asked) > GIVE_MOST * asked) break;
                mus__give_scale(body, l, i, asked / made - 1.0);
            }
        }
    for (int32_t p = 0; p < body->nfield; p++) mus__field_bounds(&body->field[p]);
}
