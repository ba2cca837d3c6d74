/*
 * fingers_toes.c: fingers, thumbs and toes of the published skin.
 *
 * For contact, girths and volume a hand is a mitten and a foot is one closed shape. In the skin, palm and ball of the
 * foot are shorter (face_hands_feet.c), and digits are tubes that bend along an arc towards the palm and close round.
 * They are described in a frame of their hand or foot,
 *
 *     u along the limb, v towards the thumb or the big toe, w towards the palm or the floor,
 *
 * and move with its part. Each is a closed surface of an end point, rings, and an end point, after those of the limbs.
 * Lengths are in parts of the hand (wrist to tip) or of the foot; proportions of hands are those of Garrett, The Adult
 * Human Hand, 1971.
 */
#include <math.h>
#include <string.h>

#include "base/elementary.h"
#include "body/body_make.h"
#include "geom/vec.h"

#define DIGIT_ROUND MUS__DIGIT_ROUND
#define DIGIT_RINGS MUS__DIGIT_RINGS

/* a digit: root, direction (way), length, radii at root and tip (thick), bend from root to tip [rad] */
typedef struct digit_row {
    double root[3], way[3], length, thick[2], bend;
} digit_row;

/* u and lengths in hands, v and radii in half breadths of the hand, w in its half thicknesses */
static const digit_row digit_fingers[] = {
    {{0.12, 0.46, 0.30}, {0.78, 0.58, 0.28}, 0.40, {0.38, 0.21}, -0.30}, /* thumb */
    {{0.42, 0.67, -0.10}, {1.0, 0.05, 0.06}, 0.52, {0.285, 0.185}, 0.35},
    {{0.43, 0.22, -0.12}, {1.0, 0.015, 0.05}, 0.56, {0.285, 0.19}, 0.38},
    {{0.42, -0.24, -0.10}, {1.0, -0.02, 0.06}, 0.53, {0.275, 0.18}, 0.42},
    {{0.40, -0.66, -0.05}, {1.0, -0.06, 0.08}, 0.43, {0.25, 0.16}, 0.45},
};

/* in lengths of the foot: u from the heel, v from the middle of the ball; w is set so that the tip lies on the floor */
static const digit_row digit_toes[] = {
    {{0.70, 0.110, 0.0}, {1.0, -0.05, 0.16}, 0.288, {0.056, 0.042}, -0.10},
    {{0.72, 0.040, 0.0}, {1.0, 0.00, 0.19}, 0.262, {0.037, 0.029}, -0.10},
    {{0.71, -0.015, 0.0}, {1.0, 0.02, 0.18}, 0.240, {0.036, 0.028}, -0.10},
    {{0.69, -0.067, 0.0}, {1.0, 0.05, 0.16}, 0.220, {0.034, 0.027}, -0.10},
    {{0.66, -0.114, 0.0}, {1.0, 0.10, 0.14}, 0.195, {0.033, 0.027}, -0.10},
};

/* the frame of a hand or foot: origin, directions u, v, w, the unit of the rows along each, the unit of radii, the part
 */
typedef struct digit_base {
    double origin[3], u[3], v[3], w[3], unit[3], thick;
    int32_t part;
} digit_base;

enum { DIGIT_LIMBS = 4 };


bool mus__digit_has(const mus_body *body, int32_t which)
{
    const mus__limb *limb = &body->limb[(which < 2 ? MUS__LIMB_ARM_LEFT : MUS__LIMB_FOOT_LEFT - 2) + which];
    bool hand = false;
    for (int32_t i = 0; i < limb->count; i++) hand |= limb->contour[i].girth == MUS_MEASURE_HAND;
    return !limb->gone && (which >= 2 || hand);
}


void mus__digit_counts(const mus_body *body, int32_t *vertices, int32_t *triangles)
{
    int32_t digits = 0;
    for (int32_t which = 0; which < DIGIT_LIMBS && body->measured; which++)
        if (mus__digit_has(body, which)) digits += MUS__DIGITS;
    *vertices = digits * MUS__DIGIT_VERTICES;
    *triangles = digits * 2 * DIGIT_ROUND * DIGIT_RINGS;
}


/* the last part of a limb */
static int32_t digit_part(const mus_body *body, int32_t l)
{
    int32_t found = 0;
    for (int32_t p = 0; p < body->rig.parts; p++)
        if (body->rig.part[p].limb == l) found = p;
    return found;
}


/* frame of a hand */
static void digit_hand(const mus_body *body, int32_t right, digit_base *out)
{
    const int32_t l = MUS__LIMB_ARM_LEFT + right;
    const mus__limb *limb = &body->limb[l];
    const mus__contour *hand = &limb->contour[0], *wrist = hand;
    while (hand->girth != MUS_MEASURE_HAND) hand++;
    while (wrist->girth != MUS_MEASURE_WRIST) wrist++;
    for (int i = 0; i < 3; i++) {
        out->origin[i] = limb->origin[i] + wrist->s * limb->axis[i];
        out->u[i] = limb->axis[i], out->v[i] = -limb->front[i];
        out->w[i] = right ? -limb->side[i] : limb->side[i];
    }
    out->unit[0] = limb->pole[1] - wrist->s, out->unit[1] = out->thick = hand->b, out->unit[2] = hand->a;
    out->part = digit_part(body, l);
}


/* frame of a foot */
static void digit_foot(const mus_body *body, int32_t right, digit_base *out)
{
    const int32_t l = MUS__LIMB_FOOT_LEFT + right;
    const mus__limb *limb = &body->limb[l];
    const double foot = limb->pole[1] - limb->pole[0], inward = right ? 1.0 : -1.0;
    double middle = 0.0;
    for (int32_t i = 0; i < limb->count; i++)
        if (limb->contour[i].s < limb->pole[0] + 0.71 * foot) middle = limb->contour[i].ca;
    for (int i = 0; i < 3; i++) {
        out->origin[i] = limb->origin[i] + limb->pole[0] * limb->axis[i] + middle * limb->side[i];
        out->u[i] = limb->axis[i], out->v[i] = inward * limb->side[i], out->w[i] = -limb->front[i];
        out->unit[i] = foot;
    }
    out->thick = foot;
    out->part = digit_part(body, l);
}


/* vertices of one digit in the rest pose: rings across an arc, closed round at the tip */
static void digit_tube(const digit_base *base, const digit_row *row, bool toe, double *x)
{
    double root[3], way[3], palm[3], across[3];
    const double thick[2] = {row->thick[0] * base->thick, row->thick[1] * base->thick};
    for (int i = 0; i < 3; i++) {
        root[i] = base->origin[i] + row->root[0] * base->unit[0] * base->u[i] +
                  row->root[1] * base->unit[1] * base->v[i] + row->root[2] * base->unit[2] * base->w[i];
        way[i] = row->way[0] * base->u[i] + row->way[1] * base->v[i] + row->way[2] * base->w[i];
        palm[i] = base->w[i];
    }
    mus__unit3(way);

    /* a toe ends on the floor, where it is flattened: the height of its root is its fall plus 0.75 of its radius */
    const double length = row->length * base->unit[0];
    if (toe)
        for (int i = 0; i < 3; i++) root[i] -= (0.75 * thick[1] + length * mus__dot3(way, palm)) * palm[i];
    const double along = mus__dot3(palm, way);
    for (int i = 0; i < 3; i++) palm[i] -= along * way[i];
    mus__unit3(palm);
    mus__cross3(way, palm, across);

    for (int32_t j = -1; j <= DIGIT_RINGS; j++) {
        /* rings are closer towards the tip; the last 1.3 radii are a round cap */
        const double t = j < 0 ? 0.0 : 1.0 - mus__pow(1.0 - (double)j / DIGIT_RINGS, 1.6), angle = row->bend * t;
        const double bend = row->bend, go = length * mus__sin(angle) / bend,
                     aside = length * (1.0 - mus__cos(angle)) / bend;
        const double rest = (1.0 - t) * length / (1.3 * thick[1]), cap = rest < 1.0 ? sqrt(rest * (2.0 - rest)) : 1.0;
        const double swell = 1.0 + 0.06 * mus__exp(-mus__pow((t - 0.5) / 0.12, 2.0));
        const double r = j < 0 || j == DIGIT_RINGS ? 0.0 : cap * swell * (thick[0] + t * (thick[1] - thick[0]));
        const int32_t n = j < 0 || j == DIGIT_RINGS ? 1 : DIGIT_ROUND;
        for (int32_t k = 0; k < n; k++, x += 3) {
            const double c = mus__cos(2.0 * MUS_PI * k / DIGIT_ROUND), s = mus__sin(2.0 * MUS_PI * k / DIGIT_ROUND);
            for (int i = 0; i < 3; i++)
                x[i] = root[i] + go * way[i] + aside * palm[i] +
                       r * (c * across[i] + 0.94 * s * (-mus__cos(angle) * palm[i] + mus__sin(angle) * way[i]));
            if (toe) x[1] = fmax(x[1], 0.0);
        }
    }
}


/* stretch the toes of a foot beyond the ball until the longest ends where the foot does: n vertices */
static void digit_stretch(const digit_base *base, int32_t n, double *x)
{
    const double ball = 0.75 * base->unit[0];
    double most = 0.0;
    for (int pass = 0; pass < 2; pass++)
        for (int32_t i = 0; i < n; i++) {
            double *p = x + 3 * (ptrdiff_t)i, u = 0.0;
            for (int c = 0; c < 3; c++) u += (p[c] - base->origin[c]) * base->u[c];
            if (pass == 0) most = fmax(most, u);
            if (pass == 0 || u <= ball) continue;
            const double more = (u - ball) * ((base->unit[0] - ball) / (most - ball) - 1.0);
            for (int c = 0; c < 3; c++) p[c] += more * base->u[c];
        }
}


/* vertices (MUS__DIGITS_VERTICES x 3) of the digits of a hand or foot in the rest pose; returns the part that carries
 * them */
static int32_t digit_side(const mus_body *body, int32_t which, double *x)
{
    digit_base base;
    const bool toe = which >= 2;
    if (toe)
        digit_foot(body, which % 2, &base);
    else
        digit_hand(body, which % 2, &base);
    for (int32_t d = 0; d < MUS__DIGITS; d++)
        digit_tube(&base, toe ? &digit_toes[d] : &digit_fingers[d], toe, x + 3 * (ptrdiff_t)d * MUS__DIGIT_VERTICES);
    if (toe) digit_stretch(&base, MUS__DIGITS_VERTICES, x);
    return base.part;
}


/* mus_body.digits_of */
static bool digits_of(const mus_body *body, int32_t part, double *x)
{
    for (int32_t which = 0; which < DIGIT_LIMBS && body->digit_vertices > 0; which++)
        if (mus__digit_has(body, which) && digit_side(body, which, x) == part) return true;
    return false;
}


void mus__digit_make(mus_body *body)
{
    body->digits_of = digits_of;
    const int32_t each = MUS__DIGIT_VERTICES;
    int32_t vertex = body->vertex_count, *triangle = body->triangles + 3 * (ptrdiff_t)body->triangle_count;
    for (int32_t limb = 0; limb < DIGIT_LIMBS; limb++) {
        if (!mus__digit_has(body, limb)) continue;
        const int32_t part = digit_side(body, limb, body->vertices + 3 * (ptrdiff_t)vertex);
        for (int32_t d = 0; d < MUS__DIGITS; d++) {
            double *x = body->vertices + 3 * (ptrdiff_t)vertex;
            for (int32_t i = 0; i < each && body->frame != NULL; i++)
                mus__frame_point(&body->frame[part], x + 3 * (ptrdiff_t)i, x + 3 * (ptrdiff_t)i);
            mus__ring_normals(x, DIGIT_ROUND, DIGIT_RINGS, 0, body->normals + 3 * (ptrdiff_t)vertex);
            mus__ring_triangles(vertex, DIGIT_RINGS, DIGIT_ROUND, triangle);
            vertex += each;
            triangle += 3 * 2 * DIGIT_ROUND * DIGIT_RINGS;
        }
    }
}
