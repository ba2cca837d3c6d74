/*
 * seam_route.c: the way of a seam pair's pull round the body, and straps that are pulled over the shoulders first.
 *
 * The two nodes of a pair on two sides of a limb cannot go straight to each other. While the midpoint between them lies
 * in the body, both are pulled towards a point beside it, twice as far out as the body reaches there: over the
 * shoulder, or round the limb. The edges of the panels tell which, by the direction in which they point.
 *
 * A short seam whose edges both point up is a strap's. In a garment that has one, edges that point up close over the
 * shoulders, and edges that point down or aside close under the arms. A strap is put on so that its middle lies on the
 * middle of the shoulder: with gravity off and little grip, a tight side seam would draw it down the arm. Where that
 * does not bring the straps over, the garment is hung by them first: until they are near, all other pairs are pulled
 * with less tension.
 *
 * A panel that is sewn to itself is a tube: a sleeve, a cuff, a band. While the pull rises it closes round the limb
 * that it was put round, and its other seams wait until it has: they would open it and draw it off to one side.
 */
#include <math.h>
#include <string.h>

#include "drape/drape_state.h"
#include "dress/dynamic_relaxation.h"
#include "dress/sew.h"
#include "geom/vec.h"

/* All numbers below are chosen; the corpus of GarmentCode patterns shows which seams close when they change. */

#define ROUTE_FROM 0.02  /* [m] nearer pairs go straight */
#define ROUTE_STEP 0.02  /* [m] of the search for the surface of the body */
#define ROUTE_STEPS 10   /* of that search */
#define ROUTE_BELOW 0.03 /* [m] a strap this far below the top of the shoulder is not on it */
#define ROUTE_CHECKS                                                                                                   \
    4 /* batches between two searches, without straps: a sleeve keeps its detours round the arm meanwhile */
#define ROUTE_LEVEL                                                                                                    \
    0.7 /* least sine of the angle between a pair and the vertical: a vertical pair has neither over nor under */
#define ROUTE_SURE 0.5   /* length of the sum of the two unit normals: edges that point apart do not tell the way */
#define ROUTE_POINTS 1.0 /* sum of the two vertical components: above it edges point up, below its negative down */
#define ROUTE_STRAP 0.6  /* of the shoulder line: a shorter seam over the shoulder is a strap's */
#define ROUTE_RIM 1.2    /* of the shoulders' half breadth: no strap begins farther out */
#define HANG_NEAR 0.05   /* [m] largest gap of a strap, or of a tube, that is near */
#define HANG_SHARE 0.25  /* of the tension, for the other pairs until straps are near */


/* distance [m] from a point to the surface of the body along a direction; twice the length of the search when the
 * surface is farther */
static double way_out(const mus_drape *drape, const double *from, const double *along)
{
    for (int32_t i = 1; i <= ROUTE_STEPS; i++) {
        double x[3];
        for (int32_t d = 0; d < 3; d++) x[d] = from[d] + ROUTE_STEP * i * along[d];
        if (mus__collider_depth(drape->scene.collider, x, 0.0, NULL) < 0.0) return ROUTE_STEP * i;
    }
    return 2.0 * ROUTE_STEP * ROUTE_STEPS;
}


/* at each node the direction out of its panel, away from its triangles: out (n x 3), units; about 0 inside a panel */
static void ways_outward(const mus_drape *drape, double *out)
{
    const mus_cloth *cloth = drape->cloth;
    memset(out, 0, 3 * (size_t)drape->n * sizeof *out);
    for (int32_t t = 0; t < cloth->ntriangle; t++)
        for (int32_t c = 0; c < 3; c++) {
            const int32_t *v = cloth->triangle + 3 * (ptrdiff_t)t, i = v[c], j = v[(c + 1) % 3], k = v[(c + 2) % 3];
            for (int32_t d = 0; d < 3; d++)
                out[3 * (ptrdiff_t)i + d] += drape->x[3 * (ptrdiff_t)i + d] -
                                             0.5 * (drape->x[3 * (ptrdiff_t)j + d] + drape->x[3 * (ptrdiff_t)k + d]);
        }
    for (int32_t i = 0; i < drape->n; i++) mus__unit3(out + 3 * (ptrdiff_t)i);
}


/* over the shoulder: of the directions square to the pair, up, aslant and down, the one with the shortest way out of
 * the body, if that is shorter than *best; `over` as mus__seam_pair.way */
static void route_over(const mus_drape *drape, const double *middle, const double *along, const double *above,
                       int32_t over, double *best, double *out)
{
    static const double turns[4][2] = {{1.0, 0.0}, {0.7071, 0.7071}, {0.7071, -0.7071}, {-1.0, 0.0}};
    const int32_t first = over < 0 ? 3 : 0, last = over > 0 ? 3 : 4;
    double up[3], side[3], way[3];
    mus__cross3(along, above, side);
    if (mus__norm3(side) < ROUTE_LEVEL) return;
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


/* round a limb: the direction in which the edges of both panels point, square to the pair, if the way out of the body
 * is shorter than *best there */
static void route_round(const mus_drape *drape, const double *middle, const double *along, const double *a,
                        const double *b, double *best, double *out)
{
    double way[3];
    for (int32_t d = 0; d < 3; d++) way[d] = a[d] + b[d];
    const double straight = mus__dot3(way, along);
    for (int32_t d = 0; d < 3; d++) way[d] -= straight * along[d];
    if (mus__norm3(way) < ROUTE_SURE) return;
    mus__unit3(way);
    const double far = way_out(drape, middle, way);
    if (!(far < *best)) return;
    *best = far;
    memcpy(out, way, sizeof way);
}


/* sets the detour of a pair that the body keeps apart: twice the way out of the body from its midpoint; 0 for others */
static void route_pair(const mus_drape *drape, const mus__level_plane *armpit, const double *outward,
                       mus__seam_pair *pair)
{
    const double *a = drape->x + 3 * (int64_t)pair->a, *b = drape->x + 3 * (int64_t)pair->b;
    double middle[3], along[3], way[3] = {0.0}, best = ROUTE_STEP * ROUTE_STEPS;
    memset(pair->detour, 0, sizeof pair->detour);
    if (pair->stitched) return;
    for (int32_t d = 0; d < 3; d++) middle[d] = 0.5 * (a[d] + b[d]), along[d] = b[d] - a[d];
    if (!(mus__norm3(along) > ROUTE_FROM) || mus__collider_depth(drape->scene.collider, middle, 0.0, NULL) < 0.0)
        return;
    mus__unit3(along);
    const double *out_a = outward + 3 * (int64_t)pair->a, *out_b = outward + 3 * (int64_t)pair->b, *up = armpit->up;
    if (armpit->there && mus__dot3(up, middle) > armpit->at)
        route_over(drape, middle, along, up, pair->way, &best, way);
    else
        route_round(drape, middle, along, out_a, out_b, &best, way);
    for (int32_t d = 0; d < 3; d++) pair->detour[d] = 2.0 * best * way[d];
}


/* distance [m] of the midpoint of a pair from the middle plane of the torso, positive on the left */
static double route_aside(const mus_drape *drape, const mus__level_plane *armpit, const mus__seam_pair *pair)
{
    double aside = 0.0;
    for (int32_t d = 0; d < 3; d++)
        aside += armpit->side[d] *
                 (0.5 * (drape->x[3 * (int64_t)pair->a + d] + drape->x[3 * (int64_t)pair->b + d]) - armpit->point[d]);
    return aside;
}


/* one past the last pair of the seam of pair p */
static int32_t route_seam_end(const mus__program *program, int32_t p)
{
    int32_t next = p + 1;
    while (next < program->npair && program->pair[next].seam == program->pair[p].seam) next++;
    return next;
}


/* the way of a seam, pairs first .. last-1: MUS__WAY_OVER_SHOULDER where both edges as a whole point up,
 * MUS__WAY_UNDER_ARM where they point down or aside, else MUS__WAY_ANY. Corners alone point elsewhere */
static int32_t route_side(const mus_drape *drape, const mus__level_plane *armpit, int32_t first, int32_t last)
{
    double up = 0.0, aside = 0.0, length = 0.0;
    for (int32_t p = first; p < last; p++) {
        const mus__seam_pair *pair = &drape->program.pair[p];
        const double *a = drape->sewing.outward + 3 * (int64_t)pair->a,
                     *b = drape->sewing.outward + 3 * (int64_t)pair->b;
        up += pair->length * (mus__dot3(armpit->up, a) + mus__dot3(armpit->up, b));
        aside += pair->length * (mus__dot3(armpit->side, a) + mus__dot3(armpit->side, b));
        length += pair->length;
    }
    if (up > ROUTE_POINTS * length) return 1;
    return fmax(-up, fabs(aside)) > ROUTE_POINTS * length ? -1 : 0;
}


/* whether a seam over the shoulder is a strap's: short, on one side of the middle plane, above the armpits, and not out
 * on the arm as that of a cuff. *inward gets the distance [m] to shift the strap towards the neck, so that it is
 * centred on the shoulder line without touching the neck */
static bool route_strap(const mus_drape *drape, const mus__level_plane *armpit, int32_t first, int32_t last,
                        double *inward)
{
    double neck, least = INFINITY, middle = 0.0, length = 0.0;
    const double shoulder = mus__scene_shoulder(drape, &neck);
    for (int32_t p = first; p < last; p++) {
        const mus__seam_pair *pair = &drape->program.pair[p];
        if (!(pair->lateral * drape->program.pair[first].lateral > 0.0)) return false;
        if (!(mus__dot3(armpit->up, drape->x + 3 * (int64_t)pair->a) > armpit->at)) return false;
        least = fmin(least, fabs(pair->lateral));
        middle += pair->length * fabs(pair->lateral);
        length += pair->length;
    }
    *inward = fmax(fmin(middle / length - 0.5 * (neck + shoulder), least - neck), 0.0);
    return length < ROUTE_STRAP * (shoulder - neck) && middle < ROUTE_RIM * shoulder * length;
}


void mus__seam_route_start(mus_drape *drape)
{
    mus__level_plane armpit;
    if (drape->scene.collider == NULL) return;
    mus__scene_level(drape, MUS_HOLD_ARMPIT, 0, &armpit);
    if (!armpit.there) return;
    ways_outward(drape, drape->sewing.outward);
    bool straps = false;
    for (int32_t p = 0, next; p < drape->program.npair; p = next) {
        next = route_seam_end(&drape->program, p);
        mus__seam_pair *pair = drape->program.pair;
        const int32_t over = route_side(drape, &armpit, p, next);
        double inward;
        for (int32_t i = p; i < next; i++) pair[i].way = over, pair[i].lateral = route_aside(drape, &armpit, &pair[i]);
        if (over < 1 || !route_strap(drape, &armpit, p, next, &inward)) continue;
        for (int32_t i = p; i < next; i++)
            pair[i].way = MUS__WAY_STRAP, pair[i].lateral -= copysign(inward, pair[i].lateral);
        straps = true;
    }

    /* without straps all pairs take the shortest way: seams of shoulders find it, and so do those of long sleeves */
    for (int32_t p = 0; p < drape->program.npair && !straps; p++) drape->program.pair[p].way = MUS__WAY_ANY;
}


/* whether a pair is under an arm, before or behind it: it lies in the outer half of the shoulder line, and the body
 * reaches more than ROUTE_BELOW higher there */
static bool route_below(const mus_drape *drape, const mus__level_plane *armpit, const mus__seam_pair *pair)
{
    const double *from = drape->x + 3 * (int64_t)pair->a;
    double front[3], neck;
    const double shoulder = mus__scene_shoulder(drape, &neck);
    if (fabs(route_aside(drape, armpit, pair)) < 0.5 * (neck + shoulder)) return false;
    mus__cross3(armpit->side, armpit->up, front);
    for (int32_t k = -ROUTE_STEPS; k <= ROUTE_STEPS; k++)
        for (int32_t i = 1; i <= ROUTE_STEPS; i++) {
            double x[3];
            for (int32_t d = 0; d < 3; d++)
                x[d] = from[d] + (ROUTE_BELOW + ROUTE_STEP * i) * armpit->up[d] + 0.5 * ROUTE_STEP * k * front[d];
            if (mus__collider_depth(drape->scene.collider, x, 0.0, NULL) > 0.0) return true;
        }
    return false;
}


/* whether a pair is a strap's and above the armpits; *far gets its gap [m] */
static bool route_hangs(const mus_drape *drape, const mus__level_plane *armpit, const mus__seam_pair *pair, double *far)
{
    const double *a = drape->x + 3 * (int64_t)pair->a, *b = drape->x + 3 * (int64_t)pair->b;
    const double gap[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
    *far = pair->stitched ? 0.0 : mus__norm3(gap);
    return pair->way == MUS__WAY_STRAP && mus__dot3(armpit->up, a) > armpit->at;
}


/* lets straps come first (hang), and draws a strap inward that lies farther from the middle plane than it should */
static void route_hang(mus_drape *drape, const mus__level_plane *armpit, bool hang)
{
    double far, farthest = 0.0;
    for (int32_t p = 0; p < drape->program.npair; p++)
        if (route_hangs(drape, armpit, &drape->program.pair[p], &far)) farthest = fmax(farthest, far);
    const bool wait = hang && farthest > HANG_NEAR;
    for (int32_t p = 0; p < drape->program.npair; p++) {
        mus__seam_pair *pair = &drape->program.pair[p];
        const bool hangs = route_hangs(drape, armpit, pair, &far);
        if (wait && !hangs) pair->pull_share *= HANG_SHARE;
        pair->strap_k = 0.0;
        if (!hangs) continue;
        const double aside = route_aside(drape, armpit, pair), more = fabs(aside) - fabs(pair->lateral);
        if (!(more > 0.0) || !(aside * pair->lateral > 0.0)) continue;
        pair->strap_k = pair->k;
        for (int32_t d = 0; d < 3; d++) pair->detour[d] -= (aside > 0.0 ? more : -more) * armpit->side[d];
    }
}


mus__straps mus__seam_route_straps(const mus_drape *drape, int32_t *off)
{
    mus__level_plane armpit;
    mus__straps straps = MUS__STRAPS_NONE;
    double far;
    mus__scene_level(drape, MUS_HOLD_ARMPIT, 0, &armpit);
    for (int32_t p = 0; p < drape->program.npair; p++) {
        if (drape->program.pair[p].way != MUS__WAY_STRAP) continue;
        straps = MUS__STRAPS_ON;
        const bool hangs = route_hangs(drape, &armpit, &drape->program.pair[p], &far);
        if (hangs && (far > ROUTE_FROM || !route_below(drape, &armpit, &drape->program.pair[p]))) continue;
        if (off != NULL) *off = drape->program.pair[p].seam;
        return MUS__STRAPS_OFF;
    }
    return straps;
}


/* lets the other seams of a tube wait until it is nearly closed; not any more when the pull has risen, nor on a cut
 * whose cells are wider than that */
static void route_tubes(mus_drape *drape, bool early)
{
    const int32_t *panel = drape->cloth->node_panel;
    const bool waits = early && drape->cloth->spacing <= HANG_NEAR;
    double *gap = drape->sewing.tube_gap;
    memset(gap, 0, (size_t)drape->cloth->npanel * sizeof *gap);
    for (int32_t p = 0; p < drape->program.npair; p++) {
        const mus__seam_pair *pair = &drape->program.pair[p];
        if (pair->stitched || panel[pair->a] != panel[pair->b]) continue;
        const double *a = drape->x + 3 * (int64_t)pair->a, *b = drape->x + 3 * (int64_t)pair->b;
        const double d[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
        gap[panel[pair->a]] = fmax(gap[panel[pair->a]], mus__norm3(d));
    }
    for (int32_t p = 0; p < drape->program.npair; p++) {
        mus__seam_pair *pair = &drape->program.pair[p];
        const int32_t a = panel[pair->a], b = panel[pair->b];
        pair->pull_share = waits && a != b && fmax(gap[a], gap[b]) > HANG_NEAR ? 0.0 : 1.0;
    }
}


void mus__seam_route(mus_drape *drape, bool hang, bool early, int32_t check)
{
    const bool straps = mus__seam_route_straps(drape, NULL) != MUS__STRAPS_NONE;
    mus__level_plane armpit;
    route_tubes(drape, early);
    if (drape->scene.collider == NULL || (!straps && check % ROUTE_CHECKS != 0)) return;
    mus__scene_level(drape, MUS_HOLD_ARMPIT, 0, &armpit);
    ways_outward(drape, drape->sewing.outward);
    for (int32_t p = 0; p < drape->program.npair; p++)
        route_pair(drape, &armpit, drape->sewing.outward, &drape->program.pair[p]);
    if (straps) route_hang(drape, &armpit, hang);
}
