/*
 * dxf_allowance.c: the seam allowance of an edge, from the sew line and the cut line of a file.
 *
 * The cut line is the sew line moved out by the allowance of each edge, so it runs parallel to an edge at a distance of
 * its allowance. It does not do so everywhere: corners and the allowances of other edges cover a part of the edge. Nor
 * does it anywhere along the leg of a dart, since the cut line crosses the mouth of a dart that is folded shut:
 *
 *      ________cut___________
 *      ____A          B______       the distance of the leg A O from the cut line, square to the leg, grows from A
 *           \        /              on, and near O the other leg lies between
 *            \      /
 *             \    /
 *              \  /
 *               O
 *
 * The distance is measured at places of the edge, square to the edge. A place counts where no other part of the sew
 * line lies between. Two neighbouring places at one distance show a parallel stretch.
 */
#include <math.h>

#include "base/elementary.h"
#include "trade/dxf_ring.h"

#define REACH_PLACES 12   /* places of an edge; chosen: a stretch of a sixth of the edge is found */
#define REACH_SPREAD 5e-5 /* [m] distances that agree; chosen: five times the chords of a file */
#define REACH_NEAR 1e-4   /* [m] a line this near to a place runs through it; chosen: ten last digits of a file */
#define REACH_STEP 1e-5   /* [m] allowances are rounded to this: the last digit of the files is finer */


/* Distance [m] of the cut line from a place, `part` of the way along the side behind point `side` of the sew line. NAN
 * without a cut line there, and where the sew line lies between */
static double reach_place(const mus__ring *sew, int32_t side, double part, const mus__ring *cut)
{
    const double *a = sew->points[side].xy, *b = sew->points[(side + 1) % sew->n].xy;
    const double dx = b[0] - a[0], dy = b[1] - a[1], length = mus__hypot(dx, dy);
    const double at[2] = {a[0] + part * dx, a[1] + part * dy}, range[2] = {REACH_NEAR, MUS__ALLOWANCE_MOST};
    const double outward[2] = {length > 0.0 ? dy / length : 0.0, length > 0.0 ? -dx / length : 0.0};
    if (!mus__ring_meet(cut, at, outward, range, &side, &part)) return NAN;
    const double away = mus__ring_away(cut, side, part, at), between[2] = {-REACH_NEAR, away};
    return mus__ring_meet(sew, at, outward, between, &side, &part) ? NAN : away;
}


/* distances (REACH_PLACES) [m] at places that are equally far apart along the edge */
static void reach_edge(const mus__ring *sew, int32_t first, int32_t n, const mus__ring *cut, double *out)
{
    double length = 0.0, behind = 0.0;
    int32_t place = 0;
    for (int32_t i = 0; i < n; i++)
        length += mus__ring_away(sew, (first + i) % sew->n, 1.0, sew->points[(first + i) % sew->n].xy);
    for (int32_t i = 0; i < n; i++) {
        const int32_t side = (first + i) % sew->n;
        const double own = mus__ring_away(sew, side, 1.0, sew->points[side].xy);
        for (; place < REACH_PLACES; place++) {
            const double s = (place + 0.5) / REACH_PLACES * length - behind;
            if (s > own && i + 1 < n) break;
            out[place] = reach_place(sew, side, own > 0.0 ? s / own : 0.0, cut);
        }
        behind += own;
    }
}


double mus__ring_allowance(const mus__ring *sew, int32_t first, int32_t n, const mus__ring *cut)
{
    double d[REACH_PLACES], best = 0.0, least = 0.0;
    int32_t most = 0;
    reach_edge(sew, first, n, cut, d);
    /* of the distances of two neighbours, the one in the middle of the most places */
    for (int32_t i = 0; i + 1 < REACH_PLACES; i++) {
        int32_t same = 0;
        double sum = 0.0;
        if (!(fabs(d[i + 1] - d[i]) < REACH_SPREAD)) continue;
        for (int32_t j = 0; j < REACH_PLACES; j++) {
            if (!(fabs(d[j] - d[i]) < REACH_SPREAD)) continue;
            same++;
            sum += fabs(d[j] - d[i]);
        }
        if (same > most || (same == most && sum < least)) most = same, least = sum, best = d[i];
    }
    return REACH_STEP * floor(best / REACH_STEP + 0.5);
}
