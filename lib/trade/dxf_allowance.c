/*
 * dxf_allowance.c: the seam allowance of an edge, from the sew line and the cut line of a file.
 *
 * The cut line is the sew line moved out by the allowance of each edge, so it runs parallel to an edge at a distance of
 * its allowance. It does not do so everywhere: corners and the allowances of other edges cover a part of the edge. Nor
 * does it anywhere along the leg of a dart, since the cut line crosses the mouth of a dart that is folded shut:
 *
 *      ________cut___________
 *      ____A          B______       the distance of the leg A O from the cut line, square to the leg, grows from A
 *           \        /              on, and soon another part of the sew line is nearer
 *            \      /
 *             \    /
 *              \  /
 *               O
 *
 * The distance is measured at places of the edge, square to the edge. A place counts where the cut line is that of the
 * edge: no other part of the sew line is nearer to it. Most of these at one distance, two of them neighbours, show that
 * the lines are parallel.
 */
#include <math.h>

#include "base/elementary.h"
#include "base/sort.h"
#include "trade/dxf_ring.h"

#define REACH_PLACES 12   /* places of an edge; chosen: a stretch of a sixth of the edge has two */
/* as many more are shared out by length to the edges that show none; chosen: they are 5 mm apart on a skirt */
#define REACH_ROUND 1000
#define REACH_SPREAD 5e-5 /* [m] distances that agree; chosen: five times the chords of a file */
#define REACH_NEAR 1e-4   /* [m] a line this near to a place runs through it; chosen: ten last digits of a file */
#define REACH_STEP 1e-5   /* [m] allowances are rounded to this: the last digit of the files is finer */


/*
 * Distance [m] of the cut line from a place, `part` of the way along the side behind point `side` of the sew line,
 * square to that side. NAN without a cut line there, and where another part of the sew line is nearer to it
 */
static double reach_place(const mus__ring *sew, int32_t side, double part, const mus__ring *cut)
{
    const double *a = sew->points[side].xy, *b = sew->points[(side + 1) % sew->n].xy;
    const double dx = b[0] - a[0], dy = b[1] - a[1], length = mus__hypot(dx, dy);
    const double at[2] = {a[0] + part * dx, a[1] + part * dy}, range[2] = {REACH_NEAR, MUS__ALLOWANCE_MOST};
    const double outward[2] = {length > 0.0 ? dy / length : 0.0, length > 0.0 ? -dx / length : 0.0};
    if (!mus__ring_meet(cut, at, outward, range, &side, &part)) return NAN;
    const double away = mus__ring_away(cut, side, part, at);
    const double met[2] = {at[0] + away * outward[0], at[1] + away * outward[1]};
    return mus__ring_nearest(sew, met, &side, &part) < away - REACH_NEAR ? NAN : away;
}


static double reach_length(const mus__ring *sew, int32_t first, int32_t n)
{
    double length = 0.0;
    for (int32_t i = first; i < first + n; i++)
        length += mus__ring_away(sew, i % sew->n, 1.0, sew->points[i % sew->n].xy);
    return length;
}


/* distances [m] at `places` places that are equally far apart along the edge */
static void reach_edge(const mus__ring *sew, int32_t first, int32_t n, const mus__ring *cut, int32_t places,
                       double *out)
{
    const double length = reach_length(sew, first, n);
    double behind = 0.0;
    int32_t place = 0;
    for (int32_t i = 0; i < n; i++) {
        const int32_t side = (first + i) % sew->n;
        const double own = reach_length(sew, side, 1);
        for (; place < places; place++) {
            const double s = (place + 0.5) / places * length - behind;
            if (s > own && i + 1 < n) break;
            out[place] = reach_place(sew, side, own > 0.0 ? s / own : 0.0, cut);
        }
        behind += own;
    }
}


static int by_distance(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return x < y ? -1 : x > y;
}


/* the distance at which most of the places lie that count, and two neighbours among them; NAN without one */
static double reach_common(const double *d, int32_t places)
{
    double sorted[REACH_PLACES + REACH_ROUND];
    int32_t count = 0, same = 0, beside = 0;
    for (int32_t i = 0; i < places; i++)
        if (!isnan(d[i])) sorted[count++] = d[i];
    if (count < 2) return NAN;
    mus__sort(sorted, (size_t)count, sizeof *sorted, by_distance);
    const double middle = sorted[count / 2];
    for (int32_t i = 0; i < places; i++) {
        if (!(fabs(d[i] - middle) < REACH_SPREAD)) continue;
        same++;
        beside += i > 0 && fabs(d[i - 1] - middle) < REACH_SPREAD;
    }
    return 2 * same > count && beside > 0 ? middle : NAN;
}


double mus__ring_allowance(const mus__ring *sew, int32_t first, int32_t n, const mus__ring *cut)
{
    const double share = reach_length(sew, first, n) / reach_length(sew, 0, sew->n);
    const int32_t more = share > 0.0 && share <= 1.0 ? (int32_t)(share * REACH_ROUND) : 0;
    const int32_t places[2] = {REACH_PLACES, REACH_PLACES + more};
    double d[REACH_PLACES + REACH_ROUND], allowance = NAN;
    for (int32_t k = 0; k < 2 && !(allowance >= 0.0); k++) {
        reach_edge(sew, first, n, cut, places[k], d);
        allowance = reach_common(d, places[k]);
    }
    return allowance >= 0.0 ? REACH_STEP * floor(allowance / REACH_STEP + 0.5) : 0.0;
}
