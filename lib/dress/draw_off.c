/*
 * draw_off.c: hands and feet come into the clothes once these are sewn.
 *
 * Seams are closed with fingers held together and without feet (mus__collider_spread()): a foot that stands in a
 * trouser leg while that is drawn shut comes through its cloth. Then a foot comes in from above, as one steps into
 * trousers: a node that lies in it, or under it, is lifted over it. One that stayed under the sole would hook the hem.
 * What hangs lower than the floor beside the foot is lifted to it, or long cloth would be torn open there.
 *
 * Nodes alone meet the body, so a triangle can come to lie with a thumb through its middle; its nodes, outside of the
 * thumb on all sides, then hold it there. Such a triangle meets the axis of the thumb. No surface that is worn meets
 * the axis of a finger, whatever the garment: where it covers the tip it lies beyond it, else the axis goes through an
 * opening. So the triangle is moved along the axis until it lies beyond the tip.
 */
#include <math.h>
#include <string.h>

#include "contact/hands_feet.h"
#include "drape/drape_self.h"
#include "drape/drape_state.h"
#include "dress/dynamic_relaxation.h"
#include "geom/vec.h"
#include "selfcontact/crossing_count.h"

#define OFF_ENDS 16 /* free ends of a body: two hands with five fingers each have 12 */
/* times the clearance, that a triangle is drawn beyond a tip; one that meets the axis less deep is lifted
 * (chord_lift.c); chosen: at 1 a cape stays on a thumb */
#define OFF_BEYOND 2.0
#define OFF_ROUNDS 8 /* a triangle that is drawn off may take its neighbour with it; chosen */
/* of its height over the floor, or over the lowest node under that, that a node keeps over the foot so that nodes keep
 * their order; chosen: small, for a hem that is lifted is folded by it */
#define STEP_ORDER 0.1
#define STEP_TALLEST 1.0 /* [m] no foot is so high */
#define STEP_LEAST 1e-3  /* [m] on the way up over a foot; chosen: a thinner part of one may be missed */
#define STEP_HALVINGS 12 /* of the height of a foot: to 0.04 mm */


/* share of the way from a to b (3) at which it meets the triangle p q r */
static double off_share(const double *a, const double *b, const double *p, const double *q, const double *r)
{
    double pq[3], pr[3], normal[3], to_a[3], to_b[3];
    for (int32_t d = 0; d < 3; d++) {
        pq[d] = q[d] - p[d], pr[d] = r[d] - p[d];
        to_a[d] = a[d] - p[d], to_b[d] = b[d] - p[d];
    }
    mus__cross3(pq, pr, normal);
    const double before = mus__dot3(to_a, normal), after = mus__dot3(to_b, normal);
    return before != after ? fmin(fmax(before / (before - after), 0.0), 1.0) : 1.0;
}


/* moves the corners of triangle k off over the tip of the end (6) where its axis meets it: move (n x 3) gets the
 * farthest such move of each node. Nonzero when it does */
static int32_t off_triangle(const mus_drape *drape, const double *end, int32_t k, double *move)
{
    const int32_t *v = drape->cloth->triangle + 3 * (int64_t)k;
    const double *p = drape->x + 3 * (int64_t)v[0], *q = drape->x + 3 * (int64_t)v[1];
    const double *r = drape->x + 3 * (int64_t)v[2];
    double way[3];
    for (int32_t d = 0; d < 3; d++) {
        const double low = fmin(end[d], end[3 + d]), high = fmax(end[d], end[3 + d]);
        if ((p[d] < low && q[d] < low && r[d] < low) || (p[d] > high && q[d] > high && r[d] > high)) return 0;
        way[d] = end[3 + d] - end[d];
    }
    if (!mus__segment_meets_triangle(end, end + 3, p, q, r)) return 0;
    const double left = 1.0 - off_share(end, end + 3, p, q, r), length = mus__norm3(way);
    const double beyond = OFF_BEYOND * drape->def.clearance, go = left + beyond / length;
    if (left * length < beyond) return 0;
    for (int32_t c = 0; c < 3; c++) {
        double *own = move + 3 * (int64_t)drape->rep[v[c]];
        if (mus__dot3(own, own) >= go * go * length * length) continue;
        for (int32_t d = 0; d < 3; d++) own[d] = go * way[d];
    }
    return 1;
}


/* height of the world that all feet are below, with what cloth keeps off them [m] */
static double step_top(const mus__collider *collider, uint64_t feet)
{
    double top = -INFINITY;
    for (int32_t l = 0; l < collider->nparts; l++)
        if ((feet >> l & 1) != 0) top = fmax(top, collider->box[6 * (ptrdiff_t)l + 4] + collider->origin[1]);
    return top;
}


/* moves a place below `top` that is nearer to a foot than `off`, or has one over it, up until nothing nearer than that
 * is over it; true when it was. Each step of the way is as long as the way to the foot, the last ones STEP_LEAST */
static bool step_up(const mus__collider *collider, uint64_t feet, double top, double off, double *place)
{
    double low = -INFINITY, high = top;
    for (double at[3] = {place[0], fmax(place[1], top - STEP_TALLEST), place[2]}; at[1] < top;) {
        const double reach = top - at[1] + off, gap = -mus__collider_parts_depth(collider, feet, at, reach, NULL);
        if (gap < off) low = at[1];
        at[1] += fmax(gap - off, STEP_LEAST);
    }
    if (!(low >= place[1])) return false;
    for (int32_t k = 0; k < STEP_HALVINGS; k++) {
        const double half = 0.5 * (low + high), at[3] = {place[0], half, place[2]};
        const bool in = mus__collider_parts_depth(collider, feet, at, off, NULL) > -off;
        low = in ? half : low, high = in ? high : half;
    }
    place[1] = high;
    return true;
}


/* lifts the nodes that lie in a foot, or under it, or nearer to it than they keep off, over it, and with them all that
 * are lower than the floor (Y = 0) to that; returns the number of those over a foot. Cloth that came to rest lies on
 * feet that are in already */
static int32_t step_in(mus_drape *drape)
{
    const mus__collider *collider = drape->scene.collider;
    const uint64_t feet = collider != NULL && drape->relax.far ? mus__collider_feet(collider) : 0;
    const double top = feet != 0 ? step_top(collider, feet) : 0.0, off = drape->def.clearance;
    double lowest = 0.0;
    int32_t found = 0;
    for (int32_t i = 0; i < drape->n && feet != 0; i++) lowest = fmin(lowest, drape->x[3 * (int64_t)i + 1]);
    for (int32_t i = 0; i < drape->n && feet != 0; i++) {
        double *x = drape->x + 3 * (int64_t)i;
        const double was = x[1];
        if (drape->pinned[drape->rep[i]] || !step_up(collider, feet, top, off, x)) continue;
        x[1] += STEP_ORDER * (was - lowest);
        found++;
    }
    for (int32_t i = 0; i < drape->n && found > 0; i++) {
        double *y = drape->x + 3 * (int64_t)i + 1;
        if (!drape->pinned[drape->rep[i]]) *y = fmax(*y, STEP_ORDER * (*y - lowest));
    }
    return found;
}


int32_t mus__draw_off(mus_drape *drape)
{
    double end[6 * OFF_ENDS], *move = drape->relax.mean;
    const mus__collider *collider = drape->scene.collider;
    const int32_t ends = collider != NULL ? mus__collider_ends(collider, OFF_ENDS, end) : 0;
    int32_t found = step_in(drape);
    for (int32_t round = 0, met = ends; round < OFF_ROUNDS && met > 0; round++) {
        met = 0;
        memset(move, 0, 3 * (size_t)drape->n * sizeof *move);
        for (int32_t e = 0; e < ends; e++)
            for (int32_t k = 0; k < drape->cloth->ntriangle; k++)
                met += off_triangle(drape, end + 6 * (ptrdiff_t)e, k, move);
        for (int32_t i = 0; i < drape->n && met > 0; i++)
            for (int32_t d = 0; d < 3 && !drape->pinned[drape->rep[i]]; d++)
                drape->x[3 * (int64_t)i + d] += move[3 * (int64_t)drape->rep[i] + d];
        found += met;
    }
    if (found == 0) return 0;
    mus__drape_push(drape);
    if (drape->self != NULL) drape->self->invalid = 1;
    return found;
}
