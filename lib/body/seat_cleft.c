/*
 * seat_cleft.c: the cleft of the seat and a child's groin in the published skin.
 *
 * A contour is one star-shaped curve and cannot have them. They are one map of space in the rest pose, applied to the
 * finished skin of torso and legs, so that the sheets of two limbs stay on each other. A point behind the middle of the
 * hip, from the crotch up to the small of the back, moves forwards by
 *
 *     F(x, y, z) = depth exp(-(x / wide)^2) step(y) step(z)
 *
 * and a point before it, from the hip down, moves backwards by a wider bell, where the torso reaches as far forwards as
 * the thighs. Normals are transformed by the inverse transpose of the Jacobian. The skin moves inwards only: a tape
 * spans both hollows, and measures, volume and contact are not changed.
 */
#include <math.h>
#include <string.h>

#include "base/elementary.h"
#include "body/body_make.h"
#include "geom/vec.h"

/* in parts of the stature; chosen: they shape the picture alone */
#define SEAT_DEPTH 0.011      /* depth of the cleft: 18 mm at 1.68 m */
#define SEAT_WIDE 0.0085      /* half width of its bell at 1/e */
#define SEAT_BELOW 0.010      /* it begins so far below the crotch, and has its depth so far above */
#define SEAT_UP 0.050         /* it ends so far above the hip level */
#define SEAT_FADE 0.060       /* and loses its depth over this height */
#define SEAT_BEHIND 0.035     /* it has its depth so far behind the middle of the hip; the groin so far before it */
#define SEAT_GROIN 0.008      /* in front the torso is put so far behind the thighs */
#define SEAT_GROIN_WIDE 0.028 /* half width of that bell at 1/e */

#define SEAT_DIFFERENCE 1e-5 /* [m] step of the central differences of the Jacobian */

typedef struct seat_place {
    double h, crotch, hip; /* stature and heights [m] */
    double middle;         /* Z of the hip's centre [m] */
    double groin;          /* shift of the groin backwards [m]; at most 0: none */
} seat_place;


/* shift forwards of the point (x, y, z) by the cleft [m] */
static double seat_in(const seat_place *seat, double x, double y, double z)
{
    const double h = seat->h, u = x / (SEAT_WIDE * h);
    if (u * u > 30.0) return 0.0;
    const double low = mus__cubic_step((y - seat->crotch + SEAT_BELOW * h) / (2.0 * SEAT_BELOW * h));
    const double high = mus__cubic_step((seat->hip + SEAT_UP * h - y) / (SEAT_FADE * h));
    return SEAT_DEPTH * h * mus__exp(-u * u) * low * high * mus__cubic_step((seat->middle - z) / (SEAT_BEHIND * h));
}


/* shift backwards by the groin [m]: of a body whose torso reaches as far forwards as its thighs, as a child's does */
static double seat_groin(const seat_place *seat, double x, double y, double z)
{
    const double h = seat->h, u = x / (SEAT_GROIN_WIDE * h);
    if (u * u > 30.0 || seat->groin <= 0.0) return 0.0;
    const double high = mus__cubic_step((seat->hip - y) / (0.7 * (seat->hip - seat->crotch)));
    return seat->groin * mus__exp(-u * u) * high * mus__cubic_step((z - seat->middle) / (SEAT_BEHIND * h));
}


/* the sum of both, forwards [m] */
static double seat_way(const seat_place *seat, const double *x)
{
    return seat_in(seat, x[0], x[1], x[2]) - seat_groin(seat, x[0], x[1], x[2]);
}


/* move a point and its normal, in the rest pose */
static void seat_move(const seat_place *seat, double *x, double *normal)
{
    const double in = seat_way(seat, x), e = SEAT_DIFFERENCE;
    if (fabs(in) < 1e-9) return;
    double slope[3];
    for (int i = 0; i < 3; i++) {
        double low[3] = {x[0], x[1], x[2]}, high[3] = {x[0], x[1], x[2]};
        low[i] -= e, high[i] += e;
        slope[i] = (seat_way(seat, high) - seat_way(seat, low)) / (2.0 * e);
    }
    x[2] += in;
    const double along = normal[2];
    normal[0] = normal[0] * (1.0 + slope[2]) - slope[0] * along;
    normal[1] = normal[1] * (1.0 + slope[2]) - slope[1] * along;
    mus__unit3(normal);
}


/* move a point and its normal, in the body's pose */
static void seat_posed(const seat_place *seat, const mus__frame *frame, double *x, double *normal)
{
    double rest[3], n[3], before[3];
    mus__frame_back(frame, x, rest);
    mus__frame_turn_back(frame, normal, n);
    memcpy(before, rest, sizeof before);
    seat_move(seat, rest, n);
    if (memcmp(before, rest, sizeof before) == 0) return;
    mus__frame_point(frame, rest, x);
    mus__frame_turn(frame, n, normal);
}


/* Z of the front of the contour that has a girth, or with MUS_NONE of the lowest contour [m] */
static double seat_front(const mus__limb *limb, int32_t girth)
{
    const mus__contour *c = &limb->contour[0];
    for (int32_t i = 0; i < limb->count && girth != MUS_NONE; i++)
        if (limb->contour[i].girth == girth) c = &limb->contour[i];
    return c->b - c->cb;
}


void mus__skin_seat(mus_body *body)
{
    const mus__limb *torso = &body->limb[MUS__LIMB_TORSO];
    const int32_t limbs[] = {MUS__LIMB_TORSO, MUS__LIMB_LEG_LEFT, MUS__LIMB_LEG_RIGHT};
    seat_place seat = {body->skeleton.crown, body->skeleton.crotch, body->skeleton.hip, 0.0, 0.0};
    for (int32_t i = 0; i < torso->count; i++)
        if (torso->contour[i].girth == MUS_MEASURE_HIP) seat.middle = -torso->contour[i].cb;
    seat.groin = seat_front(torso, MUS_NONE) + SEAT_GROIN * seat.h -
                 seat_front(&body->limb[MUS__LIMB_LEG_LEFT], MUS_MEASURE_THIGH);

    const double low = seat.crotch - SEAT_BELOW * seat.h, high = seat.hip + SEAT_UP * seat.h;
    for (int k = 0; k < 3; k++) {
        const mus__limb *limb = &body->limb[limbs[k]];
        if (limb->gone) continue;
        for (int32_t ring = 0; ring < limb->rings; ring++) {
            const double s = body->ring[limb->first_ring + ring];
            if (s < low || s > high) continue;
            const ptrdiff_t first = 3 * ((ptrdiff_t)limb->first_vertex + 1 + (ptrdiff_t)ring * body->def.samples);
            double *x = body->skin + first, *normal = body->skin_normals + first;
            mus__frame frame;
            if (body->frame != NULL) mus__rig_ring(&body->rig, body->frame, limbs[k], s, &frame);
            for (int32_t v = 0; v < body->def.samples; v++, x += 3, normal += 3) {
                if (body->frame != NULL)
                    seat_posed(&seat, &frame, x, normal);
                else
                    seat_move(&seat, x, normal);
            }
        }
    }
}
