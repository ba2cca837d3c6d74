/*
 * face_hands_feet.c: face, palms and feet of the published skin.
 *
 * Works on the rings of the skin in the rest pose; rings of a posed body are moved there and back by their frames. The
 * face is a relief along the radius of the head: a sum of bell curves over the distance from the middle plane and the
 * height between chin (0) and brow (1); its rings are sampled closer in front. Palm and ball of the foot are shortened,
 * since fingers and toes begin there (fingers_toes.c); the foot has an arch on its inner side. Girths, volume and
 * contact are not changed. Proportions of the face: Farkas, Anthropometry of the Head and Face, 1994, in lower relief.
 */
#include <math.h>
#include <string.h>

#include "base/elementary.h"
#include "body/body_make.h"
#include "geom/vec.h"

/* chosen: they shape the picture alone */
#define SHAPE_PALM 0.38   /* share of its length that the hand keeps beyond the knuckles */
#define SHAPE_BALL 0.45   /* share of its length that the foot keeps beyond the ball */
#define SHAPE_SKULL 0.018 /* lowering of a newborn's brow against its contour, in parts of its stature */
#define SHAPE_CHIN 0.032  /* lowering of its chin */
#define SHAPE_GROWN 1.28  /* [m] stature from which on a head keeps the heights of its contours */
#define SHAPE_FRONT 0.45  /* concentration of the samples at the nose: 0 none, below 1 */

/* relief of a face: height and distance from the middle plane of a bell, its half widths in both at 1/e, its height
 * outwards; in parts of chin to brow, of the half breadth at the brow, and of the head's half depth */
static const struct {
    double high, aside, tall, wide, out;
} shape_face[] = {
    {0.78, 0.42, 0.10, 0.24, -0.036}, /* eyes */
    {0.98, 0.36, 0.09, 0.30, 0.012},  /* brows */
    {0.60, 0.72, 0.13, 0.24, 0.012},  /* cheeks */
    {0.26, 0.00, 0.050, 0.24, 0.024}, /* lips */
    {0.16, 0.00, 0.045, 0.26, -0.008},
    {0.04, 0.00, 0.085, 0.30, 0.026}, /* chin */
    {0.46, 0.17, 0.045, 0.08, 0.018}, /* wings of the nose */
};


/* exp(-x^2), and 0 where that is below 1e-13 */
static double shape_bell(double x)
{
    return x * x < 30.0 ? mus__exp(-x * x) : 0.0;
}


/* contour of a limb by name; NULL: it has none */
static const mus__contour *shape_contour(const mus__limb *limb, const char *name)
{
    for (int32_t i = 0; i < limb->count; i++)
        if (strcmp(limb->contour[i].name, name) == 0) return &limb->contour[i];
    return NULL;
}


/* relief of the face at height q (chin 0, brow 1) and x half breadths off the middle plane, in half depths */
static double shape_relief(double q, double x)
{
    double sum = 0.0;
    for (size_t i = 0; i < sizeof shape_face / sizeof *shape_face; i++) {
        const double up = shape_bell((q - shape_face[i].high) / shape_face[i].tall);
        sum += shape_face[i].out * up * shape_bell((fabs(x) - shape_face[i].aside) / shape_face[i].wide);
    }

    /* the nose rises from between the eyes to its tip and falls to the lip */
    const double ridge = mus__cubic_step((0.86 - q) / 0.40) * mus__cubic_step((q - 0.38) / 0.09);
    return sum + 0.085 * ridge * shape_bell(x / (0.10 + 0.05 * mus__cubic_step((0.62 - q) / 0.2)));
}


/* concentrate the n samples of a ring at its front: sample k is taken at the index k - front n sin(2 pi (k - nose)/n) /
 * 2 pi of `ring`, by a cubic through its neighbours. out (n x 3) */
static void shape_gather(int32_t n, double front, const double *ring, double *out)
{
    for (int32_t k = 0; k < n; k++) {
        const double turn = 2.0 * MUS_PI * (k - 0.75 * n) / n, at = k - front * n * mus__sin(turn) / (2.0 * MUS_PI);
        const double low = floor(at), t = at - low;
        const int32_t i = (int32_t)(low + n) % n;
        const double *p = ring + 3 * (ptrdiff_t)((i + n - 1) % n), *q = ring + 3 * (ptrdiff_t)i;
        const double *r = ring + 3 * (ptrdiff_t)((i + 1) % n), *s = ring + 3 * (ptrdiff_t)((i + 2) % n);

        /* the cubic of Catmull and Rom 1974 through four samples */
        for (int c = 0; c < 3; c++)
            out[3 * (ptrdiff_t)k + c] =
                q[c] + 0.5 * t *
                           (r[c] - p[c] + t * (2.0 * p[c] - 5.0 * q[c] + 4.0 * r[c] - s[c] +
                                               t * (3.0 * (q[c] - r[c]) + s[c] - p[c])));
    }
}


/* lowering [m] of a point of a small child's head at height s, `front` from -1 at the back to 1 at the nose. The brow
 * is lowered all round, so that the skull is as high above it as it is broad, the chin in front only */
static double shape_child(const mus__skeleton *bone, double chin, double brow, double s, double front)
{
    const double h = bone->crown, young = h * mus__cubic_step((SHAPE_GROWN - h) / (SHAPE_GROWN - 0.56));
    const double low = SHAPE_CHIN * young * mus__cubic_step((front + 0.3) / 1.1), high = SHAPE_SKULL * young;
    if (s < chin) return low * mus__cubic_step((s - bone->nape) / (chin - bone->nape));
    return s < brow ? low + mus__cubic_step((s - chin) / (brow - chin)) * (high - low)
                    : high * mus__cubic_step((h - s) / (h - brow));
}


/* shape a ring of the head in the rest pose, n vertices at height s */
static void shape_head(const mus_body *body, double s, int32_t n, double *x)
{
    const mus__limb *torso = &body->limb[MUS__LIMB_TORSO];
    const mus__contour *chin = shape_contour(torso, "chin"), *brow = shape_contour(torso, "brow");
    if (chin == NULL || brow == NULL || n > MUS__CONTOUR_SAMPLES) return;
    const double q = (s - chin->s) / (brow->s - chin->s), z0 = -brow->cb;
    double ring[3 * MUS__CONTOUR_SAMPLES];
    memcpy(ring, x, 3 * (size_t)n * sizeof *x);
    shape_gather(n, SHAPE_FRONT * mus__cubic_step((q + 0.4) / 0.4) * mus__cubic_step((1.8 - q) / 0.5), ring, x);
    for (int32_t k = 0; k < n; k++) {
        double *p = x + 3 * (ptrdiff_t)k;
        const double side = p[0] / brow->a, front = (p[2] - z0) / brow->b;
        if (front > 0.0) {
            /* outwards along the radius, with less of it to the sides so that a nose points forwards */
            const double out = shape_relief(q, side) * brow->b * mus__cubic_step(front / 0.5);
            const double length = sqrt(p[0] * p[0] + (p[2] - z0) * (p[2] - z0));
            p[0] += 0.5 * out * p[0] / length;
            p[2] += out * (p[2] - z0) / length;
        }

        p[1] -= shape_child(&body->skeleton, chin->s, brow->s, s, front);

        /* ears, behind the middle */
        const double flank = shape_bell((front + 0.08) / 0.13) * mus__cubic_step(4.0 * fabs(side) - 2.4);
        const double ear = shape_bell((q - 0.66) / 0.20) * flank;
        p[0] += (p[0] > 0.0 ? 0.13 : -0.13) * ear * brow->a;
        p[2] -= 0.10 * ear * brow->a;
    }
}


/* shape a point of a foot in the rest pose: an arch on the inner side (`inward` -1 left, 1 right), a round heel, and
 * the shortened ball */
static void shape_foot(const mus__limb *limb, double inward, double *p)
{
    const double foot = limb->pole[1] - limb->pole[0], f = (p[2] - limb->origin[2] - limb->pole[0]) / foot;
    const double middle = limb->contour[limb->count / 2].ca;
    const double in = mus__cubic_step(0.1 + inward * (p[0] - middle) / (0.16 * foot)), high = p[1] / (0.20 * foot);
    const double arch = shape_bell((f - 0.43) / 0.17) * in * mus__cubic_step(1.0 - high);
    p[1] += 0.055 * foot * arch;
    p[0] -= inward * 0.035 * foot * arch;

    /* the back of the heel is rounded in height */
    const double heel = mus__cubic_step((0.10 - f) / 0.12);
    p[2] += 0.045 * foot * heel * (high - 0.45) * (high - 0.45) / 0.3;
    if (f > 0.70) p[2] -= (1.0 - SHAPE_BALL) * (f - 0.70) * foot;
}


/* s [m] from which on the rings of limb l are shaped; infinite: none */
static double shape_from(const mus_body *body, int32_t l)
{
    const mus__limb *limb = &body->limb[l];
    if (l == MUS__LIMB_FOOT_LEFT || l == MUS__LIMB_FOOT_RIGHT) return -INFINITY;
    const mus__contour *from = NULL;
    if (l == MUS__LIMB_TORSO) from = shape_contour(limb, "nape");
    if (l == MUS__LIMB_ARM_LEFT || l == MUS__LIMB_ARM_RIGHT) from = shape_contour(limb, "hand");
    return from != NULL ? from->s : INFINITY;
}


/* shape n vertices at s of limb l, in the rest pose */
static void shape_ring(const mus_body *body, int32_t l, double s, int32_t n, double *x)
{
    const mus__limb *limb = &body->limb[l];
    if (l == MUS__LIMB_TORSO && n > 1) shape_head(body, s, n, x);
    for (int32_t k = 0; k < n; k++, x += 3) {
        if (l == MUS__LIMB_FOOT_LEFT || l == MUS__LIMB_FOOT_RIGHT)
            shape_foot(limb, l == MUS__LIMB_FOOT_LEFT ? -1.0 : 1.0, x);
        if (l == MUS__LIMB_ARM_LEFT || l == MUS__LIMB_ARM_RIGHT) {
            const double beyond = (1.0 - SHAPE_PALM) * (s - shape_from(body, l));
            for (int i = 0; i < 3; i++) x[i] -= beyond * limb->axis[i];
        }
    }
}


/* shape n vertices at s of limb l in the body's pose: to the rest pose and back */
static void shape_posed(const mus_body *body, int32_t l, double s, int32_t n, double *x)
{
    if (body->frame == NULL) {
        shape_ring(body, l, s, n, x);
        return;
    }
    mus__frame frame;
    mus__rig_ring(&body->rig, body->frame, l, s, &frame);
    for (int32_t k = 0; k < n; k++) mus__frame_back(&frame, x + 3 * (ptrdiff_t)k, x + 3 * (ptrdiff_t)k);
    shape_ring(body, l, s, n, x);
    for (int32_t k = 0; k < n; k++) mus__frame_point(&frame, x + 3 * (ptrdiff_t)k, x + 3 * (ptrdiff_t)k);
}


void mus__skin_shape(mus_body *body)
{
    for (int32_t l = 0; l < body->limb_count; l++) {
        const mus__limb *limb = &body->limb[l];
        const int32_t n = body->def.samples;
        if (limb->gone || l >= MUS__LIMB_COUNT) continue;
        const double from = shape_from(body, l), *s = body->ring + limb->first_ring;
        double *x = body->skin + 3 * (ptrdiff_t)limb->first_vertex;
        int32_t first = 0;
        while (first < limb->rings && s[first] < from) first++;
        if (first == limb->rings) continue;
        if (first == 0) shape_posed(body, l, limb->pole[0], 1, x);
        for (int32_t j = first; j < limb->rings; j++) shape_posed(body, l, s[j], n, x + 3 * (1 + (ptrdiff_t)j * n));
        shape_posed(body, l, limb->pole[1], 1, x + 3 * (1 + (ptrdiff_t)limb->rings * n));
        mus__ring_normals(x, n, limb->rings, first > 0 ? first - 1 : 0,
                             body->skin_normals + 3 * (ptrdiff_t)limb->first_vertex);
    }
}
