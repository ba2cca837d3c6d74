/*
 * relief.c: face, ears, arch of the foot and cleft of the seat, cut into the radius fields.
 *
 * A detail is a small displacement V(x) in the rest pose, a sum of bell curves. A point x is on the new surface when x
 * - V(x) was on the old one: the radius of an entry is the root of that along its ray, by Newton's method. Torso and
 * legs get the same V at the cleft, so that their surfaces stay on each other. A small child's skull is lowered: its
 * radii are those of its contours further up.
 *
 * Hands are drawn up to the knuckles, and feet up to the ball, where fingers and toes begin (fingers_toes.c).
 *
 * Proportions of the face: Farkas, Anthropometry of the Head and Face, 1994, in lower relief.
 */
#include <math.h>
#include <string.h>

#include "base/elementary.h"
#include "body/body_make.h"
#include "geom/vec.h"
#include "limb/radius_field_double.h"

/* chosen: they shape the picture */
#define RELIEF_PALM 0.38   /* share of its length that the hand keeps beyond the knuckles */
#define RELIEF_BALL 0.45   /* share of its length that the foot keeps beyond the ball */
#define RELIEF_SKULL 0.018 /* lowering of a newborn's brow against its contour, in parts of its stature */
#define RELIEF_CHIN 0.032  /* lowering of its chin */
#define RELIEF_GROWN 1.28  /* [m] stature from which on a head keeps the heights of its contours */

/* the cleft of the seat, in parts of the stature; chosen */
#define RELIEF_DEPTH 0.011      /* depth: 18 mm at 1.68 m */
#define RELIEF_WIDE 0.0085      /* half width of its bell at 1/e */
#define RELIEF_BELOW 0.010      /* it begins so far below the crotch, and has its depth so far above */
#define RELIEF_UP 0.050         /* it ends so far above the hip level */
#define RELIEF_FADE 0.060       /* and loses its depth over this height */
#define RELIEF_BEHIND 0.035     /* it has its depth so far behind the middle of the hip; the groin so far before it */
#define RELIEF_GROIN 0.008      /* in front the torso is put so far behind the thighs */
#define RELIEF_GROIN_WIDE 0.028 /* half width of that bell at 1/e */

#define RELIEF_SLOPE 0.3 /* least slope of the depth along a ray; chosen: on steeper ones the root takes more steps */
#define RELIEF_FINE 3e-4 /* [m] each ring that changes by more is drawn; of feet, whose arch is flat, fewer are */
#define RELIEF_STEPS 3   /* Newton steps at most; they end where the depth is below RELIEF_NEAR [m] */
#define RELIEF_NEAR 1e-4
#define RELIEF_LEAST 1e-4 /* [m] a smaller displacement is none */

/* relief of a face: height and distance from the middle plane of a bell, its half widths in both at 1/e, its height
 * outwards; in parts of chin to brow, of the half breadth at the brow, and of the head's half depth */
static const struct {
    double high, aside, tall, wide, out;
} relief_face[] = {
    {0.78, 0.42, 0.10, 0.24, -0.036},                                    /* eyes */
    {0.98, 0.36, 0.09, 0.30, 0.012},                                     /* brows */
    {0.60, 0.72, 0.13, 0.24, 0.012},                                     /* cheeks */
    {0.26, 0.00, 0.050, 0.24, 0.024},                                    /* lips */
    {0.16, 0.00, 0.045, 0.26, -0.008}, {0.04, 0.00, 0.085, 0.30, 0.026}, /* chin */
    {0.46, 0.17, 0.045, 0.08, 0.018},                                    /* wings of the nose */
};

/* the levels and contours that the details refer to */
typedef struct relief {
    const mus_body *body;
    const mus__contour *chin, *brow;
    double h, crotch, hip, middle; /* stature and heights; Z of the hip's centre [m] */
    double groin;                  /* shift of the groin backwards [m]; at most 0: none */
    bool even;                     /* the left half alone */
} relief;


/* exp(-x^2), and 0 where that is below 1e-4 */
static double relief_bell(double x)
{
    return x * x < 9.2 ? mus__exp(-x * x) : 0.0;
}


/* contour of a limb by name; NULL: it has none */
static const mus__contour *relief_contour(const mus__limb *limb, const char *name)
{
    for (int32_t i = 0; i < limb->count; i++)
        if (strcmp(limb->contour[i].name, name) == 0) return &limb->contour[i];
    return NULL;
}


double mus__relief_short(const mus_body *body, int32_t l, double s)
{
    const mus__limb *limb = &body->limb[l];
    if (body->def.plain || !body->measured || l >= MUS__LIMB_COUNT) return 0.0;
    if (l == MUS__LIMB_FOOT_LEFT || l == MUS__LIMB_FOOT_RIGHT)
        return (1.0 - RELIEF_BALL) * fmax(s - limb->pole[0] - 0.70 * (limb->pole[1] - limb->pole[0]), 0.0);
    if (l != MUS__LIMB_ARM_LEFT && l != MUS__LIMB_ARM_RIGHT) return 0.0;
    const mus__contour *hand = relief_contour(limb, "hand");
    return hand != NULL ? (1.0 - RELIEF_PALM) * fmax(s - hand->s, 0.0) : 0.0;
}


/* ---- the head ---- */

/* the factors of the head's details that depend on the height alone: those of one ring */
typedef struct relief_height {
    double bell[sizeof relief_face / sizeof *relief_face], ridge, ridge_wide, ear;
    bool none; /* no detail is there */
} relief_height;


/* the factors at height q (chin 0, brow 1) */
static void relief_at_height(double q, relief_height *out)
{
    const size_t rows = sizeof relief_face / sizeof *relief_face;
    const bool face = q >= -0.3 && q <= 1.3;
    for (size_t i = 0; i < rows; i++)
        out->bell[i] = face ? relief_face[i].out * relief_bell((q - relief_face[i].high) / relief_face[i].tall) : 0.0;

    /* the nose rises from between the eyes to its tip and falls to the lip */
    out->ridge = face ? 0.085 * mus__cubic_step((0.86 - q) / 0.40) * mus__cubic_step((q - 0.38) / 0.09) : 0.0;
    out->ridge_wide = 0.10 + 0.05 * mus__cubic_step((0.62 - q) / 0.2);
    out->ear = relief_bell((q - 0.66) / 0.20);
    out->none = out->ridge == 0.0 && out->ear == 0.0;
    for (size_t i = 0; i < rows; i++) out->none = out->none && out->bell[i] == 0.0;
}


/* relief of a face x half breadths off the middle plane, in half depths */
static double relief_of_face(const relief_height *up, double x)
{
    double sum = 0.0;
    for (size_t i = 0; i < sizeof relief_face / sizeof *relief_face; i++)
        if (up->bell[i] != 0.0)
            sum += up->bell[i] * relief_bell((fabs(x) - relief_face[i].aside) / relief_face[i].wide);
    return up->ridge != 0.0 ? sum + up->ridge * relief_bell(x / up->ridge_wide) : sum;
}


/* V of the head at x: outwards along the radius, with less of it to the sides so that a nose points forwards; ears
 * behind the middle */
static void relief_head(const relief *at, const relief_height *up, const double *x, double *v)
{
    const double dz = x[2] + at->brow->cb, side = x[0] / at->brow->a, front = dz / at->brow->b;
    if (up->none) return;
    if (front > 0.0) {
        const double out = relief_of_face(up, side) * at->brow->b * mus__cubic_step(front / 0.5);
        const double length = sqrt(x[0] * x[0] + dz * dz);
        v[0] += 0.5 * out * x[0] / length;
        v[2] += out * dz / length;
    }
    const double ear = up->ear * relief_bell((front + 0.08) / 0.13) * mus__cubic_step(4.0 * fabs(side) - 2.4);
    v[0] += (x[0] > 0.0 ? 0.13 : -0.13) * ear * at->brow->a;
    v[2] -= 0.10 * ear * at->brow->a;
}


/* lowering [m] of a small child's head at height s, `front` from -1 at the back to 1 at the nose: of the brow all
 * round, so that the skull is as high above it as it is broad, of the chin in front only */
static double relief_child(const relief *at, double s, double front)
{
    const double h = at->h, young = h * mus__cubic_step((RELIEF_GROWN - h) / (RELIEF_GROWN - 0.56));
    const double low = RELIEF_CHIN * young * mus__cubic_step((front + 0.3) / 1.1), high = RELIEF_SKULL * young;
    const double chin = at->chin->s, brow = at->brow->s, nape = at->body->skeleton.nape;
    if (s < chin) return low * mus__cubic_step((s - nape) / (chin - nape));
    return s < brow ? low + mus__cubic_step((s - chin) / (brow - chin)) * (high - low)
                    : high * mus__cubic_step((h - s) / (h - brow));
}


/* lower the rings of a child's head above the nape: each takes its radii from further up. Rings ascend, so those above
 * are as they were */
static void relief_lower(const relief *at, mus__field *field, const double *turn)
{
    const int32_t n = field->nangle;
    if (at->h >= RELIEF_GROWN) return;
    for (int32_t j = 0; j + 1 < field->nring; j++) {
        const double s = field->s0 + j * field->ds, *c = field->centre + 2 * (ptrdiff_t)j;
        if (s < at->body->skeleton.nape) continue;
        for (int32_t k = 0; k < n; k++) {
            const double up = s + relief_child(at, s, -turn[2 * k + 1]);
            const double u = fmin((up - field->s0) / field->ds, field->nring - 1.0);
            const int32_t i = (int32_t)fmin(u, field->nring - 2.0);
            const double t = u - i, *low = field->radius + (ptrdiff_t)i * n + k, *d = field->centre + 2 * (ptrdiff_t)i;
            const double a = d[0] + t * (d[2] - d[0]) - c[0], b = d[1] + t * (d[3] - d[1]) - c[1];
            const double r = sqrt(low[0] * low[0] + t * (low[n] * low[n] - low[0] * low[0]));
            field->radius[(ptrdiff_t)j * n + k] = r + a * turn[2 * k] + b * turn[2 * k + 1];
        }
    }
}


/* ---- foot and seat ---- */

/* V of a foot: an arch on the inner side (`inward` -1 left, 1 right) */
static void relief_foot(const relief *at, int32_t l, const double *x, double *v)
{
    const mus__limb *limb = &at->body->limb[l];
    const double inward = l == MUS__LIMB_FOOT_LEFT ? -1.0 : 1.0, foot = at->body->asked[MUS_MEASURE_FOOT];
    const double f = (x[2] - limb->origin[2] - limb->pole[0]) / foot, middle = limb->contour[limb->count / 2].ca;
    const double in = mus__cubic_step(0.1 + inward * (x[0] - middle) / (0.16 * foot)), high = x[1] / (0.20 * foot);
    if (in <= 0.0 || high >= 1.0) return;
    const double arch = relief_bell((f - 0.43) / 0.17) * in * mus__cubic_step(1.0 - high);
    v[1] += 0.055 * foot * arch;
    v[0] -= inward * 0.035 * foot * arch;
}


/* V of torso and legs: forwards behind the hip (the cleft); backwards before it, of a body whose torso reaches as far
 * forwards as its thighs, as a child's does */
static void relief_seat(const relief *at, const double *x, double *v)
{
    const double h = at->h, u = x[0] / (RELIEF_WIDE * h), w = x[0] / (RELIEF_GROIN_WIDE * h);
    if (u * u > 9.2 && (at->groin <= 0.0 || w * w > 9.2)) return;
    const double low = mus__cubic_step((x[1] - at->crotch + RELIEF_BELOW * h) / (2.0 * RELIEF_BELOW * h));
    const double high = mus__cubic_step((at->hip + RELIEF_UP * h - x[1]) / (RELIEF_FADE * h));
    const double back = mus__cubic_step((at->middle - x[2]) / (RELIEF_BEHIND * h));
    v[2] += RELIEF_DEPTH * h * relief_bell(u) * low * high * back;
    if (at->groin <= 0.0) return;
    const double under = mus__cubic_step((at->hip - x[1]) / (0.7 * (at->hip - at->crotch)));
    v[2] -= at->groin * relief_bell(w) * under * mus__cubic_step((x[2] - at->middle) / (RELIEF_BEHIND * h));
}


double mus__relief_cleft(const mus_body *body, double y, double z)
{
    const mus__skeleton *bone = &body->skeleton;
    const mus__contour *hip = relief_contour(&body->limb[MUS__LIMB_TORSO], "hip");
    const relief at = {.body = body,
                       .h = bone->crown,
                       .crotch = bone->crotch,
                       .hip = bone->hip,
                       .middle = hip != NULL ? -hip->cb : 0.0};
    const double x[3] = {0.0, y, z};
    double v[3] = {0.0, 0.0, 0.0};
    relief_seat(&at, x, v);
    return v[2];
}


/* ---- all fields ---- */

/* s [m] of the rings of limb l that have a detail: range (2), empty for most */
static void relief_range(const relief *at, int32_t l, int32_t part, double *range)
{
    const mus__rig *rig = &at->body->rig;
    range[0] = INFINITY, range[1] = -INFINITY;
    if (l == MUS__LIMB_FOOT_LEFT || l == MUS__LIMB_FOOT_RIGHT) {
        range[0] = -INFINITY, range[1] = INFINITY;
    } else if (l == MUS__LIMB_TORSO && rig->part[part].joint == MUS_JOINT_NECK) {
        range[0] = at->body->skeleton.nape, range[1] = INFINITY;
    } else if (l == MUS__LIMB_TORSO || l == MUS__LIMB_LEG_LEFT || l == MUS__LIMB_LEG_RIGHT) {
        range[0] = at->crotch - RELIEF_BELOW * at->h, range[1] = at->hip + RELIEF_UP * at->h;
    }
}


/* V (3) at a point x of limb l; `up`: the factors of its ring on the head, NULL elsewhere. false: it is none */
static bool relief_way(const relief *at, int32_t l, const relief_height *up, const double *x, double *v)
{
    v[0] = v[1] = v[2] = 0.0;
    if (up != NULL)
        relief_head(at, up, x, v);
    else if (l >= MUS__LIMB_FOOT_LEFT)
        relief_foot(at, l, x, v);
    else
        relief_seat(at, x, v);
    return mus__dot3(v, v) > RELIEF_LEAST * RELIEF_LEAST;
}


/* the new radius of an entry whose ray is start + radius way, in the rest pose; `old` is the field as it was */
static double relief_radius(const relief *at, const mus__body_field *old, int32_t l, const relief_height *up,
                            const double *start, const double *way, double radius)
{
    const double least = 0.5 * radius;
    for (int step = 0; step < RELIEF_STEPS; step++) {
        double x[3], v[3], normal[3];
        for (int i = 0; i < 3; i++) x[i] = start[i] + radius * way[i];
        if (!relief_way(at, l, up, x, v)) break;
        for (int i = 0; i < 3; i++) x[i] -= v[i];
        const double depth = mus__field_depth_of(old, x, normal), slope = mus__dot3(normal, way);
        if (depth < -1e29 || fabs(depth) < RELIEF_NEAR) break;
        radius = fmax(radius + depth / fmax(slope, RELIEF_SLOPE), least);
    }
    return radius;
}


/* change the entries of ring j of part q; `old` is the field as it was */
static void relief_ring(const relief *at, const mus__body_field *old, mus__field *field, int32_t q, int32_t j,
                        const double *turn)
{
    const int32_t n = field->nangle, l = at->body->rig.part[q].limb;
    const bool head = at->body->rig.part[q].joint == MUS_JOINT_NECK, half = l == MUS__LIMB_TORSO && at->even;
    const double *c = field->centre + 2 * (ptrdiff_t)j, s = field->s0 + j * field->ds;
    const mus__limb *limb = &at->body->limb[l];
    double *radius = field->radius + (ptrdiff_t)j * n, most = 0.0;
    relief_height up;
    if (head) relief_at_height((s - at->chin->s) / (at->brow->s - at->chin->s), &up); /* the rays are horizontal */
    if (head && up.none) return;
    for (int32_t k = 0; k < n; k++) {
        double start[3], way[3];
        if (half && k > n / 4 && k < n - n / 4) continue;
        for (int i = 0; i < 3; i++) {
            start[i] = limb->origin[i] + c[0] * limb->side[i] + c[1] * limb->front[i] + s * limb->axis[i];
            way[i] = turn[2 * k] * limb->side[i] + turn[2 * k + 1] * limb->front[i];
        }
        const double fresh = relief_radius(at, old, l, head ? &up : NULL, start, way, radius[k]);
        if (fabs(fresh - radius[k]) > most) most = fabs(fresh - radius[k]);
        radius[k] = fresh;
    }
    if (most < RELIEF_FINE || l >= MUS__LIMB_FOOT_LEFT) return;
    if (j < field->fine[0]) field->fine[0] = j;
    if (j > field->fine[1]) field->fine[1] = j;
}


/* Z of the front of the contour that has a girth, or with MUS_NONE of the lowest contour [m] */
static double relief_front(const mus__limb *limb, int32_t girth)
{
    const mus__contour *c = &limb->contour[0];
    for (int32_t i = 0; i < limb->count && girth != MUS_NONE; i++)
        if (limb->contour[i].girth == girth) c = &limb->contour[i];
    return c->b - c->cb;
}


/* the details of part q. Errors: MUS_ERR_MEMORY */
static mus_status relief_part(const relief *at, mus_body *body, int32_t q)
{
    mus__field *field = &body->field[q], old = *field;
    mus__body_field query;
    const int32_t l = body->rig.part[q].limb;
    const bool head = l == MUS__LIMB_TORSO && body->rig.part[q].joint == MUS_JOINT_NECK;
    const int64_t size = (int64_t)field->nring * field->nangle;
    double range[2], turn[2 * MUS__FIELD_MOST];
    relief_range(at, l, q, range);
    if (range[0] > range[1] || (head && (at->chin == NULL || at->brow == NULL))) return MUS_OK;
    mus__field_turns(field->nangle, turn);
    if (head) relief_lower(at, field, turn);
    old.radius = mus__room(body->context, size, sizeof(double));
    if (old.radius == NULL) return mus__fail_memory(body->context, "the details of a body");
    memcpy(old.radius, field->radius, (size_t)size * sizeof(double));
    mus__field_prepare(&old, &query);
    for (int32_t j = 0; j < field->nring; j++) {
        const double s = field->s0 + j * field->ds;
        if (s >= range[0] && s <= range[1]) relief_ring(at, &query, field, q, j, turn);
    }
    mus__free(body->context, old.radius);
    return MUS_OK;
}


mus_status mus__body_relief(mus_body *body)
{
    mus__limb *torso = &body->limb[MUS__LIMB_TORSO];
    const mus__skeleton *bone = &body->skeleton;
    relief at = {.body = body,
                 .chin = relief_contour(torso, "chin"),
                 .brow = relief_contour(torso, "brow"),
                 .h = bone->crown,
                 .crotch = bone->crotch,
                 .hip = bone->hip,
                 .even = mus__body_is_even(body)};
    mus_status status = MUS_OK;
    if (!body->measured) return MUS_OK;
    for (int32_t i = 0; i < torso->count; i++)
        if (torso->contour[i].girth == MUS_MEASURE_HIP) at.middle = -torso->contour[i].cb;
    at.groin = relief_front(torso, MUS_NONE) + RELIEF_GROIN * at.h -
               relief_front(&body->limb[MUS__LIMB_LEG_LEFT], MUS_MEASURE_THIGH);
    for (int32_t q = 0; q < body->nfield && status == MUS_OK; q++) {
        const int32_t l = body->rig.part[q].limb;
        if (l < MUS__LIMB_COUNT && (!at.even || l == MUS__LIMB_TORSO || l % 2 == 1)) status = relief_part(&at, body, q);
    }
    return status;
}
