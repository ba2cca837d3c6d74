/*
 * worn_axes.c: the axes of the limbs, and the linking numbers of loops with them.
 *
 * An axis runs from the middle of the chest through the centres of contours of its limb, and then straight to a place
 * 20 m away. Three ways lead there: on in the direction of the limb, to the side, and the same again; from the face
 * forwards, and forwards and down. A sleeve that covers the fingers leaves the first way open, a wide skirt beside the
 * hand the second, a hood the others.
 *
 * The disc of a loop is the cone over it from its mean place. The sign of an axis segment against a triangle of the
 * cone is that of five volumes of tetrahedra, each exact (geom/predicate.h). Where a volume is 0 the apex of the cone
 * is moved, or the axis, by a micrometre, until none is: the number is that of places in general position.
 */
#include <math.h>
#include <string.h>

#include "fit/worn_internal.h"
#include "geom/predicate.h"
#include "geom/vec.h"

#define AXIS_FAR 20.0    /* [m] length of the way outside; chosen: beyond any cloth */
#define AXIS_DOTS 8      /* points of a contour whose mean is its centre */
#define AXIS_NUDGE 1e-6  /* [m] a way out of a special position; chosen: far above rounding */
#define AXIS_NUDGES 16   /* tries */


static int32_t axis_limb(const mus_body *body, const char *name)
{
    for (int32_t l = 0; l < mus_body_limb_count(body); l++)
        if (strcmp(mus_body_limb_name(body, l), name) == 0) return mus_body_contour_count(body, l) > 1 ? l : MUS_NONE;
    return MUS_NONE;
}


/* centre (3) of a contour */
static void axis_centre(const mus_body *body, int32_t limb, int32_t contour, double *out)
{
    double dot[3 * AXIS_DOTS] = {0.0};
    mus_body_contour_points(body, limb, contour, AXIS_DOTS, dot);
    for (int32_t d = 0; d < 3; d++) {
        out[d] = 0.0;
        for (int32_t i = 0; i < AXIS_DOTS; i++) out[d] += dot[3 * i + d] / AXIS_DOTS;
    }
}


static double axis_distance(const double *a, const double *b)
{
    const double d[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
    return mus__norm3(d);
}


/* add the centres of contours first, first + step ... before `end`, from `least` [m] of the first point on */
static void axis_add(const mus_body *body, int32_t limb, int32_t first, int32_t end, int32_t step, double least,
                     int32_t axis, mus__worn_axes *out)
{
    for (int32_t k = first; k != end && out->count[axis] < MUS__WORN_POINTS; k += step) {
        double centre[3];
        axis_centre(body, limb, k, centre);
        if (axis_distance(out->point[axis][0], centre) < least) continue;
        memcpy(out->point[axis][out->count[axis]++], centre, sizeof centre);
    }
}


/* the ways outside: from the end on along the limb; and from point `leave` along `side` (3) */
static void axis_end(int32_t axis, const double *side, int32_t leave, mus__worn_axes *out)
{
    const double *tip = out->point[axis][out->count[axis] - 1], *before = out->point[axis][out->count[axis] - 2];
    double on[3] = {tip[0] - before[0], tip[1] - before[1], tip[2] - before[2]};
    mus__unit3(on);
    out->leave[axis][0] = out->count[axis] - 1, out->leave[axis][1] = out->leave[axis][2] = leave;
    for (int32_t d = 0; d < 3; d++) {
        out->far[axis][0][d] = tip[d] + AXIS_FAR * on[d];
        const double way = side != NULL ? side[d] : on[d], bow = axis == MUS_WORN_NECK ? out->up[d] : 0.0;
        out->far[axis][1][d] = out->point[axis][leave][d] + AXIS_FAR * way;
        out->far[axis][2][d] = out->point[axis][leave][d] + AXIS_FAR * (way - bow);
    }
}


/* the point of the head's axis in the middle of the face: the first above half way from the shoulders to the crown */
static int32_t axis_face(const mus__worn_axes *axes)
{
    const int32_t last = axes->count[MUS_WORN_NECK] - 1;
    const double low = mus__dot3(axes->up, axes->shoulders);
    const double half = 0.5 * (low + mus__dot3(axes->up, axes->point[MUS_WORN_NECK][last]));
    int32_t k = 0;
    while (k < last && mus__dot3(axes->up, axes->point[MUS_WORN_NECK][k]) < half) k++;
    return k;
}


/* directions of the trunk from shoulders, chest and waist; the middle of the chest (3). False without them */
static bool axis_trunk(const mus_body *body, double *chest, mus__worn_axes *out)
{
    double waist[3], left[3], right[3];
    if (mus_body_landmark(body, MUS_LANDMARK_BUST, chest) != MUS_OK ||
        mus_body_landmark(body, MUS_LANDMARK_WAIST, waist) != MUS_OK ||
        mus_body_landmark(body, MUS_LANDMARK_SHOULDER_LEFT, left) != MUS_OK ||
        mus_body_landmark(body, MUS_LANDMARK_SHOULDER_RIGHT, right) != MUS_OK)
        return false;
    for (int32_t d = 0; d < 3; d++) {
        out->up[d] = chest[d] - waist[d], out->left[d] = left[d] - right[d];
        out->shoulders[d] = 0.5 * (left[d] + right[d]);
    }
    mus__unit3(out->up);
    mus__cross3(out->left, out->up, out->front);
    mus__unit3(out->front);
    mus__cross3(out->up, out->front, out->left);
    return true;
}


bool mus__worn_axes_make(const mus_body *body, mus__worn_axes *out)
{
    static const char *const names[MUS_WORN_LIMBS] = {"torso", "arm_left", "arm_right", "leg_left", "leg_right"};
    double chest[3], low[3], centre[3];
    memset(out, 0, sizeof *out);
    const int32_t torso = axis_limb(body, names[0]);
    if (torso == MUS_NONE || !axis_trunk(body, chest, out)) return false;
    const int32_t contours = mus_body_contour_count(body, torso);
    int32_t middle = 0;
    for (int32_t k = 0; k < contours; k++) {
        axis_centre(body, torso, k, centre);
        for (int32_t d = 0; d < 3; d++) centre[d] -= chest[d];
        if (mus__dot3(centre, out->up) <= 0.0) middle = k;
    }
    axis_centre(body, torso, middle < 1 ? middle : 1, low);
    for (int32_t axis = 0; axis < MUS_WORN_LIMBS; axis++) {
        const int32_t limb = axis_limb(body, names[axis]);
        if (limb == MUS_NONE) continue;
        const int32_t own = mus_body_contour_count(body, limb);
        double side[3];
        memcpy(out->point[axis][0], chest, sizeof chest);
        out->count[axis] = out->own[axis] = 1, out->limb[axis] = limb;
        if (axis == MUS_WORN_NECK) {
            axis_add(body, torso, middle + 1, contours, 1, 0.0, axis, out);
            if (out->count[axis] > 1) axis_end(axis, out->front, axis_face(out), out);
        } else if (axis <= MUS_WORN_ARM_RIGHT) {
            axis_add(body, limb, 0, own, 1, 0.0, axis, out);
            for (int32_t d = 0; d < 3; d++) side[d] = axis == MUS_WORN_ARM_LEFT ? out->left[d] : -out->left[d];
            if (out->count[axis] > 1) axis_end(axis, side, out->count[axis] - 1, out);
        } else {
            axis_add(body, torso, middle, 0, -1, 0.0, axis, out);
            out->own[axis] = out->count[axis];
            axis_add(body, limb, own - 1, -1, -1, axis_distance(chest, low), axis, out);
            if (out->count[axis] > 1) axis_end(axis, NULL, out->count[axis] - 1, out);
        }
        if (out->count[axis] < 2) out->count[axis] = 0; /* no contour of its own: the body lacks the limb */
    }
    return true;
}


/* +1 or -1 where the segment p q passes the triangle a b c from one side or the other, 0 where it does not; *flat is
 * set where a volume is 0 */
static int32_t axis_pass(const double *p, const double *q, const double *a, const double *b, const double *c,
                         int32_t *flat)
{
    const double from = mus__orient3d(a, b, c, p), to = mus__orient3d(a, b, c, q);
    if ((from > 0.0 && to > 0.0) || (from < 0.0 && to < 0.0)) return 0;
    const double ab = mus__orient3d(p, q, a, b), bc = mus__orient3d(p, q, b, c), ca = mus__orient3d(p, q, c, a);
    const int32_t left = (ab > 0.0) + (bc > 0.0) + (ca > 0.0), right = (ab < 0.0) + (bc < 0.0) + (ca < 0.0);
    if (left > 0 && right > 0) return 0;
    if (left + right < 3 || from == 0.0 || to == 0.0) {
        *flat = 1;
        return 0;
    }
    return from > 0.0 ? -1 : 1;
}


/* the cone over a loop, and how far the axes are moved */
typedef struct axis_cone {
    double apex[3], by[3];    /* [m] */
    double low[3], high[3];   /* box of the loop and the apex [m] */
    const int32_t *node;      /* (count) of the loop */
    int32_t count;
    const double *x;          /* places of the nodes [m] */
} axis_cone;


/* takes the box of the loop and the apex */
static void axis_box(axis_cone *cone)
{
    memcpy(cone->low, cone->apex, sizeof cone->low);
    memcpy(cone->high, cone->apex, sizeof cone->high);
    for (int32_t i = 0; i < cone->count; i++)
        for (int32_t d = 0; d < 3; d++) {
            const double at = cone->x[3 * (ptrdiff_t)cone->node[i] + d];
            cone->low[d] = fmin(cone->low[d], at), cone->high[d] = fmax(cone->high[d], at);
        }
}


/* signed passes of the segment from one place to another through a cone; none where their boxes have no point in
 * common */
static int32_t axis_passes(const double *from, const double *to, const axis_cone *cone, int32_t *flat)
{
    double p[3], q[3];
    int32_t sum = 0;
    for (int32_t d = 0; d < 3; d++) {
        p[d] = from[d] + cone->by[d], q[d] = to[d] + cone->by[d];
        if ((p[d] < cone->low[d] && q[d] < cone->low[d]) || (p[d] > cone->high[d] && q[d] > cone->high[d])) return 0;
    }
    for (int32_t i = 0; i < cone->count; i++) {
        const int32_t a = cone->node[i], b = cone->node[(i + 1) % cone->count];
        sum += axis_pass(p, q, cone->apex, cone->x + 3 * (ptrdiff_t)a, cone->x + 3 * (ptrdiff_t)b, flat);
    }
    return sum;
}


/* signed passes of an axis through a cone, on each way: that inside the body up to the point of leaving, and the way
 * outside */
static void axis_ways(const mus__worn_axes *axes, int32_t axis, const axis_cone *cone, int32_t *out, int32_t *flat)
{
    int32_t sum = 0;
    for (int32_t way = 0; way < MUS__WORN_WAYS; way++) out[way] = 0;
    for (int32_t k = 0; k < axes->count[axis]; k++) {
        for (int32_t way = 0; way < MUS__WORN_WAYS; way++)
            if (axes->leave[axis][way] == k)
                out[way] = sum + axis_passes(axes->point[axis][k], axes->far[axis][way], cone, flat);
        if (k + 1 < axes->count[axis])
            sum += axis_passes(axes->point[axis][k], axes->point[axis][k + 1], cone, flat);
    }
}


void mus__worn_link(const mus__worn_axes *axes, const mus__worn_loops *loops, int32_t loop, const double *x,
                    int32_t out[MUS_WORN_LIMBS][MUS__WORN_WAYS])
{
    const mus__worn_loop *own = &loops->loop[loop];
    axis_cone cone = {.node = loops->node + own->first, .count = own->count, .x = x};
    for (int32_t i = 0; i < own->count; i++)
        for (int32_t d = 0; d < 3; d++) cone.apex[d] += x[3 * (ptrdiff_t)cone.node[i] + d] / own->count;
    int32_t flat = 1;
    for (int32_t try = 0; try < AXIS_NUDGES && flat; try++) {
        flat = 0;
        axis_box(&cone);
        for (int32_t axis = 0; axis < MUS_WORN_LIMBS; axis++) axis_ways(axes, axis, &cone, out[axis], &flat);

        /* steps of different size and direction */
        const double apex[3] = {1.0 + try, -0.7, 0.6 + 0.3 * try}, by[3] = {0.6, 2.0 + try, -0.8};
        for (int32_t d = 0; d < 3; d++) cone.apex[d] += AXIS_NUDGE * apex[d], cone.by[d] += AXIS_NUDGE * by[d];
    }
}


double mus__worn_distance(const mus__worn_axes *axes, int32_t axis, const double *place)
{
    double least = INFINITY;
    for (int32_t k = axes->own[axis]; k < axes->count[axis]; k++) {
        const double *a = axes->point[axis][k > axes->own[axis] ? k - 1 : k], *b = axes->point[axis][k];
        const double along[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
        const double to[3] = {place[0] - a[0], place[1] - a[1], place[2] - a[2]}, size = mus__dot3(along, along);
        const double t = size > 0.0 ? fmax(0.0, fmin(1.0, mus__dot3(along, to) / size)) : 0.0;
        const double off[3] = {to[0] - t * along[0], to[1] - t * along[1], to[2] - t * along[2]};
        least = fmin(least, mus__norm3(off));
    }
    return least;
}
