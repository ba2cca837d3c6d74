/*
 * touch.c: how far the drawn skin lies off what cloth touches.
 *
 * Points are spread over the triangles of the skin; the depth of each in the radius fields, which colliders are made
 * of, is the distance. A point that another limb covers is not seen and does not count; nor do fingers and toes, and
 * hands and feet where they begin, which contact knows as mittens and as closed feet.
 */
#include <math.h>

#include "body/body_internal.h"
#include "measure.h"


/* depths [m] of a point in the parts of limb l, and in all other parts */
static void touch_depths(const mus_body *body, int32_t l, const double *x, double *own, double *other)
{
    double normal[3];
    *own = *other = -1e30;
    for (int32_t p = 0; p < body->nfield; p++) {
        double *to = body->rig.part[p].limb == l ? own : other;
        *to = fmax(*to, mus__field_depth(&body->field[p], x, normal));
    }
}


/* whether a point of limb l lies beyond the knuckles of a hand or beyond the ball of a foot */
static bool touch_digits(const mus_body *body, int32_t l, const double *x)
{
    const mus__limb *limb = &body->limb[l];
    const double d[3] = {x[0] - limb->origin[0], x[1] - limb->origin[1], x[2] - limb->origin[2]};
    const double s = d[0] * limb->axis[0] + d[1] * limb->axis[1] + d[2] * limb->axis[2];
    for (int32_t i = 0; i < limb->count; i++)
        if (limb->contour[i].girth == MUS_MEASURE_HAND) return s > limb->contour[i].s;
    if (l != MUS__LIMB_FOOT_LEFT && l != MUS__LIMB_FOOT_RIGHT) return false;
    return s > limb->pole[0] + 0.65 * (limb->pole[1] - limb->pole[0]);
}


/* limb of a triangle; fingers and toes, which follow all limbs, belong to no limb */
static int32_t touch_limb(const mus_body *body, int32_t triangle)
{
    for (int32_t l = 0; l < body->limb_count; l++) {
        const int32_t at = triangle - body->limb[l].first_triangle;
        if (at >= 0 && at < body->limb[l].triangles) return l;
    }
    return MUS_NONE;
}


void outside_touch(const mus_body *body, int32_t each, outside_gap *out)
{
    const double *x = mus_body_vertices(body);
    const int32_t *triangle = mus_body_triangles(body);
    *out = (outside_gap){0};
    for (int32_t t = 0; t < mus_body_triangle_count(body); t++) {
        const int32_t l = touch_limb(body, t);
        if (l == MUS_NONE) continue;
        for (int32_t i = 0; i < each; i++) {
            /* the points of an additive sequence over the triangle (Roberts 2018) */
            double u = fmod(0.5 + 0.7548776662466927 * (t + i), 1.0), v = fmod(0.5 + 0.5698402909980532 * (t + i), 1.0);
            double p[3], own, other;
            if (u + v > 1.0) u = 1.0 - u, v = 1.0 - v;
            for (int k = 0; k < 3; k++) {
                const double a = x[3 * (size_t)triangle[3 * t] + (size_t)k];
                const double b = x[3 * (size_t)triangle[3 * t + 1] + (size_t)k];
                const double c = x[3 * (size_t)triangle[3 * t + 2] + (size_t)k];
                p[k] = a + u * (b - a) + v * (c - a);
            }
            if (touch_digits(body, l, p)) continue;
            touch_depths(body, l, p, &own, &other);
            if (other > OUTSIDE_CLOSE) continue;
            const double off = fmax(own, other);
            out->points++;
            if (fabs(off) > OUTSIDE_CLOSE) out->far++;
            if (-off > out->outside) {
                out->outside = -off;
                for (int k = 0; k < 3; k++) out->at_outside[k] = p[k];
            }
            if (off > out->inside) {
                out->inside = off;
                for (int k = 0; k < 3; k++) out->at_inside[k] = p[k];
            }
        }
    }
}
