/*
 * lift.c: the ways of seam pairs round what is between them, and what is hung on the shoulders first.
 *
 * Two ends of a seam on two sides of a limb cannot go straight. The middle between them is looked at: while it lies in
 * the body, both ends are drawn towards a place beside it, twice as far out as the body reaches there. Over a shoulder
 * or round a limb: the edges of panels know, by where they point.
 *
 * A short seam whose edges both point up is a strap's. Of garments that have one, what points up closes over the
 * shoulders and what points down or aside under the arms; the strap is put on so that its middle lies on that of the
 * shoulder: with gravity off and grip low a tight side seam would draw it down the arm. Where that does not bring the
 * straps over, the garment is hung by them first: until they are near, all else is pulled with less.
 */
#include <math.h>
#include <string.h>

#include "drape/drape_internal.h"
#include "geom/vec.h"

#define LIFT_FROM 0.02  /* [m]: nearer pairs go straight */
#define LIFT_STEP 0.02  /* [m] of the search for the way round what is between */
#define LIFT_STEPS 10
#define LIFT_BELOW 0.03 /* [m]: so much below the top of the shoulder a strap is not on it */
#define LIFT_CHECKS 4   /* between searches, without straps: a sleeve goes round its arm with what it was given */
#define LIFT_LEVEL 0.7  /* pairs that stand one above the other have neither over nor under */
#define LIFT_SURE 0.5   /* of 2: edges that point less the same way do not say which */
#define LIFT_POINTS 1.0 /* of 2: edges that point up close over the shoulders, down and out under the arms */
#define LIFT_STRAP 0.6  /* of the shoulder line: what closes on less of it is a strap */
#define LIFT_RIM 1.2    /* of the shoulders' half breadth: farther out begins no strap */
#define HANG_NEAR 0.05  /* [m]: then straps are home */
#define HANG_SHARE 0.25 /* of the pull that the others have until then */


/* how far from a point the body ends along a direction [m], twice as far as is looked when it does not */
static double way_out(const mus_drape *drape, const double *from, const double *along)
{
    for (int32_t i = 1; i <= LIFT_STEPS; i++) {
        double x[3];
        for (int32_t d = 0; d < 3; d++) x[d] = from[d] + LIFT_STEP * i * along[d];
        if (mus__collider_depth(drape->collider, x, 0.0, NULL) < 0.0) return LIFT_STEP * i;
    }
    return 2.0 * LIFT_STEP * LIFT_STEPS;
}


/* at each node the way out of its panel, away from the middle of its triangles: out (n x 3), units, about 0 inside */
static void ways_outward(const mus_drape *drape, double *out)
{
    const mus_cloth *cloth = drape->cloth;
    memset(out, 0, 3 * (size_t)drape->n * sizeof *out);
    for (int32_t t = 0; t < cloth->ntriangle; t++)
        for (int32_t c = 0; c < 3; c++) {
            const int32_t *v = cloth->triangle + 3 * (ptrdiff_t)t, i = v[c], j = v[(c + 1) % 3], k = v[(c + 2) % 3];
            for (int32_t d = 0; d < 3; d++)
                out[3 * (ptrdiff_t)i + d] += drape->x[3 * (ptrdiff_t)i + d] - 0.5 * (drape->x[3 * (ptrdiff_t)j + d] +
                                                                                     drape->x[3 * (ptrdiff_t)k + d]);
        }
    for (int32_t i = 0; i < drape->n; i++) mus__unit3(out + 3 * (ptrdiff_t)i);
}


/* over the shoulder: the shortest way out square to `along`, straight or aslant over it, or under it; at most *best */
static void lift_over(const mus_drape *drape, const double *middle, const double *along, const double *above,
                      int32_t over, double *best, double *out)
{
    static const double turns[4][2] = {{1.0, 0.0}, {0.7071, 0.7071}, {0.7071, -0.7071}, {-1.0, 0.0}};
    const int32_t first = over < 0 ? 3 : 0, last = over > 0 ? 3 : 4;
    double up[3], side[3], way[3];
    mus__cross3(along, above, side);
    if (mus__norm3(side) < LIFT_LEVEL) return;
    mus__unit3(side);
    mus__cross3(side, along, up);
    for (int32_t i = first; i < last; i++) {
        for (int32_t d = 0; d < 3; d++) way[d] = turns[i][0] * up[d] + turns[i][1] * side[d];
        const double far = way_out(drape, middle, way);
        if (!(far < *best)) continue;
        *best = far;
        memcpy(out, way, sizeof way);
    }
}


/* round a limb: where the edges of both panels point, square to `along`; they know which way is theirs */
static void lift_round(const mus_drape *drape, const double *middle, const double *along, const double *a,
                       const double *b, double *best, double *out)
{
    double way[3];
    for (int32_t d = 0; d < 3; d++) way[d] = a[d] + b[d];
    const double straight = mus__dot3(way, along);
    for (int32_t d = 0; d < 3; d++) way[d] -= straight * along[d];
    if (mus__norm3(way) < LIFT_SURE) return;
    mus__unit3(way);
    const double far = way_out(drape, middle, way);
    if (!(far < *best)) return;
    *best = far;
    memcpy(out, way, sizeof way);
}


/* from the middle of a pair that a part of the body keeps apart, the way out: lift (3) is twice that, 0 without */
static void lift_pair(const mus_drape *drape, const mus__held_level *armpit, const double *outward, mus__pair *pair)
{
    const double *a = drape->x + 3 * (int64_t)pair->a, *b = drape->x + 3 * (int64_t)pair->b;
    double middle[3], along[3], way[3] = {0.0}, best = LIFT_STEP * LIFT_STEPS;
    memset(pair->lift, 0, sizeof pair->lift);
    if (pair->locked) return;
    for (int32_t d = 0; d < 3; d++) middle[d] = 0.5 * (a[d] + b[d]), along[d] = b[d] - a[d];
    if (!(mus__norm3(along) > LIFT_FROM) || mus__collider_depth(drape->collider, middle, 0.0, NULL) < 0.0) return;
    mus__unit3(along);
    const double *out_a = outward + 3 * (int64_t)pair->a, *out_b = outward + 3 * (int64_t)pair->b, *up = armpit->up;
    if (armpit->there && mus__dot3(up, middle) > armpit->at)
        lift_over(drape, middle, along, up, pair->over, &best, way);
    else
        lift_round(drape, middle, along, out_a, out_b, &best, way);
    for (int32_t d = 0; d < 3; d++) pair->lift[d] = 2.0 * best * way[d];
}


/* how far from the middle of the torso a pair lies, to its left */
static double lift_aside(const mus_drape *drape, const mus__held_level *armpit, const mus__pair *pair)
{
    double aside = 0.0;
    for (int32_t d = 0; d < 3; d++)
        aside += armpit->side[d] * (0.5 * (drape->x[3 * (int64_t)pair->a + d] + drape->x[3 * (int64_t)pair->b + d]) -
                                    armpit->point[d]);
    return aside;
}


/* one past the last pair of the seam that pair p belongs to */
static int32_t lift_seam_end(const mus__plan *plan, int32_t p)
{
    int32_t next = p + 1;
    while (next < plan->npair && plan->pair[next].seam == plan->pair[p].seam) next++;
    return next;
}


/* whether a seam, its pairs first .. last-1, closes over the shoulders (1), under the arms (-1) or either way: both
 * edges as a whole point up, or down, or aside; at their corners they point elsewhere */
static int32_t lift_side(const mus_drape *drape, const mus__held_level *armpit, int32_t first, int32_t last)
{
    double up = 0.0, aside = 0.0, length = 0.0;
    for (int32_t p = first; p < last; p++) {
        const mus__pair *pair = &drape->plan.pair[p];
        const double *a = drape->work + 3 * (int64_t)pair->a, *b = drape->work + 3 * (int64_t)pair->b;
        up += pair->length * (mus__dot3(armpit->up, a) + mus__dot3(armpit->up, b));
        aside += pair->length * (mus__dot3(armpit->side, a) + mus__dot3(armpit->side, b));
        length += pair->length;
    }
    if (up > LIFT_POINTS * length) return 1;
    return fmax(-up, fabs(aside)) > LIFT_POINTS * length ? -1 : 0;
}


/* whether a seam over the shoulder is a strap's: short, to one side of the middle, above the armpits and not out on the
 * arm, as that of a cuff is; *inward how much nearer to the neck than it begins it is put on: its middle on that of the
 * shoulder, so that it does not lie at the rim, and nothing of it on the neck */
static bool lift_strap(const mus_drape *drape, const mus__held_level *armpit, int32_t first, int32_t last,
                       double *inward)
{
    double neck, least = INFINITY, middle = 0.0, length = 0.0;
    const double shoulder = mus__drape_shoulder(drape, &neck);
    for (int32_t p = first; p < last; p++) {
        const mus__pair *pair = &drape->plan.pair[p];
        if (!(pair->aside * drape->plan.pair[first].aside > 0.0)) return false;
        if (!(mus__dot3(armpit->up, drape->x + 3 * (int64_t)pair->a) > armpit->at)) return false;
        least = fmin(least, fabs(pair->aside));
        middle += pair->length * fabs(pair->aside);
        length += pair->length;
    }
    *inward = fmax(fmin(middle / length - 0.5 * (neck + shoulder), least - neck), 0.0);
    return length < LIFT_STRAP * (shoulder - neck) && middle < LIFT_RIM * shoulder * length;
}


void mus__drape_lift_start(mus_drape *drape)
{
    mus__held_level armpit;
    if (drape->collider == NULL) return;
    mus__drape_level(drape, MUS_HOLD_ARMPIT, 0, &armpit);
    if (!armpit.there) return;
    ways_outward(drape, drape->work);
    bool straps = false;
    for (int32_t p = 0, next; p < drape->plan.npair; p = next) {
        next = lift_seam_end(&drape->plan, p);
        mus__pair *pair = drape->plan.pair;
        const int32_t over = lift_side(drape, &armpit, p, next);
        double inward;
        for (int32_t i = p; i < next; i++) pair[i].over = over, pair[i].aside = lift_aside(drape, &armpit, &pair[i]);
        if (over < 1 || !lift_strap(drape, &armpit, p, next, &inward)) continue;
        for (int32_t i = p; i < next; i++) pair[i].over = 2, pair[i].aside -= copysign(inward, pair[i].aside);
        straps = true;
    }

    /* broad shoulders find their way, and long sleeves go round their arms by the shortest ones */
    for (int32_t p = 0; p < drape->plan.npair && !straps; p++) drape->plan.pair[p].over = 0;
}


/* whether a pair is under an arm, before or behind it: nearer to its root than to the neck, and the body reaches more
 * than a little higher there */
static bool lift_below(const mus_drape *drape, const mus__held_level *armpit, const mus__pair *pair)
{
    const double *from = drape->x + 3 * (int64_t)pair->a;
    double front[3], neck;
    const double shoulder = mus__drape_shoulder(drape, &neck);
    if (fabs(lift_aside(drape, armpit, pair)) < 0.5 * (neck + shoulder)) return false;
    mus__cross3(armpit->side, armpit->up, front);
    for (int32_t k = -LIFT_STEPS; k <= LIFT_STEPS; k++)
        for (int32_t i = 1; i <= LIFT_STEPS; i++) {
            double x[3];
            for (int32_t d = 0; d < 3; d++)
                x[d] = from[d] + (LIFT_BELOW + LIFT_STEP * i) * armpit->up[d] + 0.5 * LIFT_STEP * k * front[d];
            if (mus__collider_depth(drape->collider, x, 0.0, NULL) > 0.0) return true;
        }
    return false;
}


/* whether a pair is a strap's, and above the armpits; *far how wide it is open */
static bool lift_hangs(const mus_drape *drape, const mus__held_level *armpit, const mus__pair *pair, double *far)
{
    const double *a = drape->x + 3 * (int64_t)pair->a, *b = drape->x + 3 * (int64_t)pair->b;
    const double gap[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
    *far = pair->locked ? 0.0 : mus__norm3(gap);
    return pair->over == 2 && mus__dot3(armpit->up, a) > armpit->at;
}


/* straps come first, and do not go farther aside than they should */
static void lift_hang(mus_drape *drape, const mus__held_level *armpit, bool hang)
{
    double far, farthest = 0.0;
    for (int32_t p = 0; p < drape->plan.npair; p++)
        if (lift_hangs(drape, armpit, &drape->plan.pair[p], &far)) farthest = fmax(farthest, far);
    const bool wait = hang && farthest > HANG_NEAR;
    for (int32_t p = 0; p < drape->plan.npair; p++) {
        mus__pair *pair = &drape->plan.pair[p];
        const bool hangs = lift_hangs(drape, armpit, pair, &far);
        pair->share = wait && !hangs ? HANG_SHARE : 1.0;
        pair->keep = 0.0;
        if (!hangs) continue;
        const double aside = lift_aside(drape, armpit, pair), more = fabs(aside) - fabs(pair->aside);
        if (!(more > 0.0) || !(aside * pair->aside > 0.0)) continue;
        pair->keep = pair->k;
        for (int32_t d = 0; d < 3; d++) pair->lift[d] -= (aside > 0.0 ? more : -more) * armpit->side[d];
    }
}


mus__straps mus__drape_strapped(const mus_drape *drape, int32_t *off)
{
    mus__held_level armpit;
    mus__straps straps = MUS__STRAPS_NONE;
    double far;
    mus__drape_level(drape, MUS_HOLD_ARMPIT, 0, &armpit);
    for (int32_t p = 0; p < drape->plan.npair; p++) {
        if (drape->plan.pair[p].over != 2) continue;
        straps = MUS__STRAPS_ON;
        const bool hangs = lift_hangs(drape, &armpit, &drape->plan.pair[p], &far);
        if (hangs && (far > LIFT_FROM || !lift_below(drape, &armpit, &drape->plan.pair[p]))) continue;
        if (off != NULL) *off = drape->plan.pair[p].seam;
        return MUS__STRAPS_OFF;
    }
    return straps;
}


void mus__drape_lift(mus_drape *drape, bool hang, int32_t check)
{
    const bool straps = mus__drape_strapped(drape, NULL) != MUS__STRAPS_NONE;
    mus__held_level armpit;
    if (drape->collider == NULL || (!straps && check % LIFT_CHECKS != 0)) return;
    mus__drape_level(drape, MUS_HOLD_ARMPIT, 0, &armpit);
    ways_outward(drape, drape->work);
    for (int32_t p = 0; p < drape->plan.npair; p++)
        lift_pair(drape, &armpit, drape->work, &drape->plan.pair[p]);
    if (straps) lift_hang(drape, &armpit, hang);
}
