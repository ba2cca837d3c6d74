/*
 * body_length.c: lengths along the finished surface, for mus_body_made().
 *
 * A length is that of a tape between two points along a row of vertices, in the plane of that row: the tape lies on
 * bulges and spans hollows, as the convex hull does. The rows, in the rest pose, on the rings of the limbs:
 *
 *     shoulder        ridge of the torso from the side neck point to the shoulder point, which lies inside the acromion
 *                     by the difference between surveys and tailors (skeleton.c)
 *     arm             outer line of the arm from the acromion to the wrist, plus 5 % for the bend
 *     elbow           the same to the elbow; all of the bend's 5 % of the arm lies above the tip of the elbow
 *     back_waist      middle line of the back from nape to waist
 *     crotch_length   middle line from the waist in front, under the crotch, to the waist behind
 *     across_back     half way down the armhole, between the places where the skins of arms and torso would meet
 *                     without their fillets
 *     across_front    the same in front
 *     bust_span       between the foremost points of both sides at the height of the bust
 *
 * Called once when a body is made, after its radius fields, which tell where an arm begins.
 */
#include <math.h>

#include "base/elementary.h"
#include "body/body_make.h"
#include "geom/polygon.h"
#include "geom/vec.h"

/* the tape of a bent arm is longer than that of the straight arm by this part; as in skeleton.c */
#define LENGTH_BEND 0.05

#define LENGTH_NEAR 0.6    /* nearer to each other, in widths of a fillet, torso and arm may carry one */
#define LENGTH_FAR 0.05  /* [m] off an arm that a point is too far from for a depth: where contact ends */
#define LENGTH_ROUNDS 16 /* halvings of a step between two samples: to 0.2 micrometres */

/* points of a row in a plane, and scratch for their hull */
typedef struct length_row {
    int32_t count;
    double *xy;        /* (count x 2) */
    int32_t *work;     /* (count x 2) */
    double u[3], v[3]; /* the directions of the plane's two axes */
} length_row;


/* append a point x (3) to a row */
static void length_put(length_row *row, const double *x)
{
    row->xy[2 * row->count] = mus__dot3(x, row->u);
    row->xy[2 * row->count + 1] = mus__dot3(x, row->v);
    row->count++;
}


/* length [m] of a tape from the first to the last point of a row whose skin faces to the left (side 1) or to the right
 * (-1) of that way: the hull of the points on that side of the chord. Changes the row */
static double length_tape(length_row *row, double side)
{
    double *xy = row->xy, end[2] = {xy[2 * row->count - 2], xy[2 * row->count - 1]};
    const double way[2] = {end[0] - xy[0], end[1] - xy[1]}, chord = sqrt(way[0] * way[0] + way[1] * way[1]);
    int32_t kept = 1;
    for (int32_t i = 1; i + 1 < row->count; i++) {
        const double off = way[0] * (xy[2 * i + 1] - xy[1]) - way[1] * (xy[2 * i] - xy[0]);
        if (side * off <= 0.0) continue;
        xy[2 * kept] = xy[2 * i], xy[2 * kept + 1] = xy[2 * i + 1];
        kept++;
    }
    if (kept == 1) return chord;
    xy[2 * kept] = end[0], xy[2 * kept + 1] = end[1];
    return mus__polygon_tape(kept + 1, xy, row->work, row->work + kept + 1) - chord;
}


/* vertex k (3) of a ring of a limb */
static const double *length_vertex(const mus_body *body, const mus__limb *limb, int32_t ring, int32_t k)
{
    return body->vertices + 3 * ((ptrdiff_t)limb->first_vertex + 1 + (ptrdiff_t)ring * limb->samples + k);
}


/* first ring of a limb at s or above; beyond all rings the last one */
static int32_t length_ring(const mus_body *body, const mus__limb *limb, double s)
{
    int32_t ring = 0;
    while (ring + 1 < limb->rings && body->ring[limb->first_ring + ring] < s - 1e-12) ring++;
    return ring;
}


/* the point (3) at s on line k of a limb, linear between two rings */
static void length_at(const mus_body *body, const mus__limb *limb, double s, int32_t k, double *out)
{
    const double *at = body->ring + limb->first_ring;
    int32_t ring = length_ring(body, limb, s);
    if (ring == 0) ring = 1;
    const double t = fmin(fmax((s - at[ring - 1]) / (at[ring] - at[ring - 1]), 0.0), 1.0);
    const double *p = length_vertex(body, limb, ring - 1, k), *q = length_vertex(body, limb, ring, k);
    for (int i = 0; i < 3; i++) out[i] = p[i] + t * (q[i] - p[i]);
}


/* append line k of a limb from s = low to s = high, or the other way round (down) */
static void length_line(const mus_body *body, const mus__limb *limb, int32_t k, double low, double high, bool down,
                        length_row *row)
{
    const double *at = body->ring + limb->first_ring;
    const int32_t first = length_ring(body, limb, low + 1e-9), last = length_ring(body, limb, high - 1e-9);
    double x[3];
    length_at(body, limb, down ? high : low, k, x);
    length_put(row, x);
    for (int32_t i = 0; i < last - first; i++) {
        const int32_t ring = down ? last - 1 - i : first + i;
        if (at[ring] > low + 1e-9 && at[ring] < high - 1e-9) length_put(row, length_vertex(body, limb, ring, k));
    }
    length_at(body, limb, down ? low : high, k, x);
    length_put(row, x);
}


/* begin a row in the plane of directions u and v */
static void length_begin(length_row *row, const double *u, const double *v)
{
    row->count = 0;
    for (int i = 0; i < 3; i++) row->u[i] = u[i], row->v[i] = v[i];
}


/* back_waist and crotch_length, on the middle line of the torso, in the plane (backwards, up) */
static void length_middle(mus_body *body, length_row *row)
{
    const mus__limb *torso = &body->limb[MUS__LIMB_TORSO];
    const mus__skeleton *bone = &body->skeleton;
    const int32_t back = body->def.samples / 4, front = 3 * back;
    const double behind[3] = {0.0, 0.0, -1.0}, up[3] = {0.0, 1.0, 0.0};

    length_begin(row, behind, up);
    length_line(body, torso, back, bone->waist, bone->nape, true, row);
    body->made[MUS_MEASURE_BACK_WAIST] = length_tape(row, 1.0);

    length_begin(row, behind, up);
    length_line(body, torso, front, body->ring[torso->first_ring], bone->waist, true, row);
    length_put(row, body->vertices + 3 * (ptrdiff_t)torso->first_vertex);
    length_line(body, torso, back, body->ring[torso->first_ring], bone->waist, false, row);
    body->made[MUS_MEASURE_CROTCH_LENGTH] = length_tape(row, -1.0);
}


/* height [m] at which the left ridge of the shoulder, down from the neck, is as far out as the shoulder point; where it
 * is nowhere, the height of the acromion */
static double length_shoulder_end(const mus_body *body)
{
    const mus__limb *torso = &body->limb[MUS__LIMB_TORSO];
    const mus__skeleton *bone = &body->skeleton;
    const int32_t first = length_ring(body, torso, bone->shoulder), last = length_ring(body, torso, bone->neck_side);
    for (int32_t ring = last; ring > first; ring--) {
        const double *p = length_vertex(body, torso, ring, 0), *q = length_vertex(body, torso, ring - 1, 0);
        if (q[0] < bone->shoulder_end) continue;
        const double part = (bone->shoulder_end - p[0]) / (q[0] - p[0]);
        return p[1] + fmin(fmax(part, 0.0), 1.0) * (q[1] - p[1]);
    }
    return bone->shoulder;
}


/* shoulder and shoulder_slope, in the vertical plane through side neck point and shoulder point */
static void length_shoulder(mus_body *body, length_row *row)
{
    const mus__limb *torso = &body->limb[MUS__LIMB_TORSO];
    const double high = body->skeleton.neck_side, low = length_shoulder_end(body), up[3] = {0.0, 1.0, 0.0};
    double neck[3], end[3];
    length_at(body, torso, high, 0, neck);
    length_at(body, torso, low, 0, end);
    double out[3] = {end[0] - neck[0], 0.0, end[2] - neck[2]};
    mus__unit3(out);
    length_begin(row, out, up);
    length_line(body, torso, 0, low, high, true, row);
    body->made[MUS_MEASURE_SHOULDER] = length_tape(row, 1.0);
    body->made[MUS_MEASURE_SHOULDER_SLOPE] = mus__atan2(neck[1] - end[1], end[0] - neck[0]);
}


/* arm and elbow, on the outer line of an arm from the height of the acromion */
static void length_arm(mus_body *body, const mus__limb *arm, length_row *row)
{
    const mus__skeleton *bone = &body->skeleton;
    const int32_t outer = arm->samples / 2;
    const double out[3] = {-arm->side[0], -arm->side[1], -arm->side[2]};
    double straight[2];
    for (int to = 0; to < 2; to++) {
        length_begin(row, arm->axis, out);
        length_line(body, arm, outer, -bone->arm_before, to == 0 ? bone->elbow : bone->arm_length, false, row);
        straight[to] = length_tape(row, 1.0);
    }
    body->made[MUS_MEASURE_ARM] = (1.0 + LENGTH_BEND) * straight[1];
    body->made[MUS_MEASURE_ELBOW] = straight[0] + LENGTH_BEND * straight[1];
}


/* depth [m] in the arms of a point x (3) or its mirror image, since the body may have one arm alone */
static double length_in_arms(const mus_body *body, const double *x)
{
    const double mirror[3] = {-x[0], x[1], x[2]};
    double deepest = -1e30, normal[3];
    for (int32_t p = 0; p < body->nfield; p++) {
        const int32_t l = body->rig.part[p].limb;
        if (l != MUS__LIMB_ARM_LEFT && l != MUS__LIMB_ARM_RIGHT) continue;
        deepest = fmax(deepest, mus__field_depth(&body->field[p], x, normal));
        deepest = fmax(deepest, mus__field_depth(&body->field[p], mirror, normal));
    }
    return deepest;
}


/* the polynomial through `count` places (x, y), at x = at (Lagrange) */
static double length_through(int count, const double *x, const double *y, double at)
{
    double sum = 0.0;
    for (int i = 0; i < count; i++) {
        double term = y[i];
        for (int j = 0; j < count; j++)
            if (j != i) term *= (at - x[j]) / (x[i] - x[j]);
        sum += term;
    }
    return sum;
}


/* its root between the second and the third place, by bisection */
static double length_root(const double *x, const double *y)
{
    double low = x[1], high = x[2];
    for (int round = 0; round < LENGTH_ROUNDS; round++) {
        const double at = 0.5 * (low + high);
        if (length_through(3, x, y, at) < 0.0)
            low = at;
        else
            high = at;
    }
    return 0.5 * (low + high);
}


/* the point (3) of the torso's ring at s, on the way from line `middle` to a side (1, -1), at which the ring would go
 * into the arm without the fillet between the two: where the parabolas through the two samples before the fillet and
 * the one behind it are on the arm's skin. Returns the steps from the middle line; -1: the ring does not meet an arm */
static double length_crease(const mus_body *body, int32_t middle, int32_t side, double s, double *out)
{
    const mus__limb *torso = &body->limb[MUS__LIMB_TORSO];
    const int32_t n = body->def.samples;
    const double near = LENGTH_NEAR * body->fillet;
    double x[3], place[3] = {0.0}, depth[3] = {0.0}, at[3][3] = {{0.0}};
    int32_t found = 0;
    for (int32_t k = 0; k < n / 2 && found < 3; k++) {
        length_at(body, torso, s, (middle + side * k + n) % n, x);
        const double here = length_in_arms(body, x);
        if (fabs(here) < near || (found < 2 && here > 0.0)) continue;
        if (found == 2 && here < 0.0) {
            place[0] = place[1], depth[0] = depth[1], found = 1;
            for (int i = 0; i < 3; i++) at[i][0] = at[i][1];
        }
        place[found] = k, depth[found] = here < -1e29 ? -LENGTH_FAR : here;
        for (int i = 0; i < 3; i++) at[i][found] = x[i];
        found++;
    }
    if (found < 3) return -1.0;
    const double crease = length_root(place, depth);
    for (int i = 0; i < 3; i++) out[i] = length_through(3, place, at[i], crease);
    return crease;
}


/* across_back or across_front [m]: from arm to arm over line `middle` of the ring half way down the armhole; NaN where
 * the torso does not meet an arm */
static double length_across(const mus_body *body, int32_t middle, length_row *row)
{
    const mus__limb *torso = &body->limb[MUS__LIMB_TORSO];
    const mus__skeleton *bone = &body->skeleton;
    const int32_t n = body->def.samples, quarter = n / 4;
    const double left[3] = {1.0, 0.0, 0.0}, front[3] = {0.0, 0.0, 1.0}, s = 0.5 * (bone->armpit + bone->shoulder);
    const bool left_arm = !body->limb[MUS__LIMB_ARM_LEFT].gone, back = middle == quarter;
    const int32_t side = left_arm == back ? -1 : 1; /* to the side that has an arm; the other is its mirror image */
    double x[3], end[3];
    const double crease = length_crease(body, middle, side, s, end);
    if (crease < 0.0) return NAN;
    const int32_t reach = (int32_t)crease;
    length_begin(row, left, front);
    for (int32_t k = -reach - 1; k <= reach + 1; k++) {
        const int32_t aside = k < 0 ? -k : k;
        length_at(body, torso, s, (middle + side * aside + n) % n, x);
        for (int i = 0; i < 3 && aside == reach + 1; i++) x[i] = end[i];
        if ((k < 0) == (x[0] > 0.0)) x[0] = -x[0];
        if (fabs(x[0]) <= fabs(end[0])) length_put(row, x);
    }
    return length_tape(row, back ? -1.0 : 1.0); /* the row goes to the left */
}


/* bust_span [m]: twice the X of the foremost point of the bust's ring, where the slopes of its sides about the foremost
 * vertex pass 0; NaN without breasts */
static double length_span(const mus_body *body)
{
    const mus__limb *torso = &body->limb[MUS__LIMB_TORSO];
    const int32_t n = body->def.samples;
    for (int32_t i = 0; i < torso->count; i++) {
        const mus__contour *c = &torso->contour[i];
        if (c->girth != MUS_MEASURE_BUST || c->bump[0] <= 0.0) continue;
        int32_t best = 3 * n / 4;
        for (int32_t k = best + 1; k < n; k++)
            if (length_vertex(body, torso, c->ring, k)[2] > length_vertex(body, torso, c->ring, best)[2]) best = k;
        if (best == 3 * n / 4) return NAN;
        double slope[4], middle[4];
        for (int32_t k = 0; k < 4; k++) {
            const double *p = length_vertex(body, torso, c->ring, (best - 2 + k) % n);
            const double *q = length_vertex(body, torso, c->ring, (best - 1 + k) % n);
            slope[k] = (q[2] - p[2]) / (q[0] - p[0]), middle[k] = 0.5 * (p[0] + q[0]);
        }
        return 2.0 * length_through(4, slope, middle, 0.0);
    }
    return NAN;
}


mus_status mus__body_lengths(mus_body *body)
{
    int32_t most = body->def.samples;
    for (int32_t l = 0; l < MUS__LIMB_COUNT; l++)
        if (body->limb[l].rings > most) most = body->limb[l].rings;
    length_row row = {0};
    row.xy = mus__new(body->context, 2 * (2 * (int64_t)most + 8), sizeof(double));
    row.work = mus__new(body->context, 2 * (2 * (int64_t)most + 8), sizeof(int32_t));
    mus_status status = MUS_OK;
    if (row.xy == NULL || row.work == NULL) {
        status = mus__fail_memory(body->context, "measuring a body");
    } else {
        length_middle(body, &row);
        length_shoulder(body, &row);
        for (int32_t l = MUS__LIMB_ARM_RIGHT; l >= MUS__LIMB_ARM_LEFT; l--)
            if (!body->limb[l].gone && body->limb[l].cuts > 0) length_arm(body, &body->limb[l], &row);
        if (!body->limb[MUS__LIMB_ARM_LEFT].gone || !body->limb[MUS__LIMB_ARM_RIGHT].gone) {
            const int32_t back = body->def.samples / 4;
            body->made[MUS_MEASURE_ACROSS_BACK] = length_across(body, back, &row);
            body->made[MUS_MEASURE_ACROSS_FRONT] = length_across(body, 3 * back, &row);
        }
        body->made[MUS_MEASURE_BUST_SPAN] = length_span(body);
    }
    mus__free(body->context, row.xy);
    mus__free(body->context, row.work);
    return status;
}
