/*
 * waist_edge.c: what skirts, trousers and bands share: the girth of the body at a level, and the waist as a run of
 * half-edges over several panels.
 *
 * The waist is walked as the boundary loop is: from a half-edge to the next of its panel, and where that is sewn, to
 * the one after its partner. So it passes side seams, cuts and darts, and stops at the centre line. The waist of
 * a bodice runs from centre front over the side to centre back, that of the skirt or trousers below the other way.
 */
#include <math.h>
#include <string.h>

#include "closure/closure.h"
#include "style/waist_edge.h"

#define PULLED_EASE (2.0 * MUS__CM) /* of a woven waist over the hip; chosen: what one hand needs */
#define PULLED_KNIT 0.95            /* of the hip, which a knit gives; chosen */
#define WALK_LONGEST 400 /* half-edges after which a walk along a boundary loop gives up; drafts have below 60 */


void mus__lower_top(mus__outline *outline, int32_t n, const double (*dart)[6], const mus__chain *part)
{
    char name[] = "w1", leg[] = "d1";
    for (int32_t d = n; d >= 0; d--) {
        mus__chain chain = part[d];
        mus__chain_reverse(&chain);
        mus__outline_add(outline, name, "waist", 1.0 * MUS__CM, &chain);
        name[1]++;
        if (d == 0) break;
        mus__outline_line(outline, leg, "", 0.0, dart[d - 1] + 4, dart[d - 1] + 2);
        leg[1]++;
        mus__outline_line(outline, leg, "", 0.0, dart[d - 1] + 2, dart[d - 1]);
        leg[1]++;
    }
}


/* ---- the person ---- */

double mus__lower_girth(const mus__half *half, double level)
{
    /* straight from underbust to waist, high hip half way down, hip */
    const double *m = half->measures.v, depth = m[MUS_MEASURE_WAIST_TO_HIP];
    const double ribs = fmax(0.04, half->skeleton.underbust - half->skeleton.waist);
    const double waist = m[MUS_MEASURE_WAIST], high = m[MUS_MEASURE_HIGH_HIP], hip = m[MUS_MEASURE_HIP];
    if (level >= 0.0) return waist + fmin(1.0, level / ribs) * (m[MUS_MEASURE_UNDERBUST] - waist);
    if (level >= -0.5 * depth) return waist + 2.0 * (-level / depth) * (high - waist);
    return high + fmin(1.0, 2.0 * (-level / depth) - 1.0) * (hip - high);
}


bool mus__lower_has_top(const mus__half *half)
{
    const int32_t garment = half->style.option[MUS__AXIS_GARMENT];
    return garment == MUS__GARMENT_DRESS || garment == MUS__GARMENT_JUMPSUIT;
}


double mus__lower_level(const mus__half *half)
{
    if (mus__lower_has_top(half)) return 0.0;
    const int32_t rise = half->style.option[MUS__AXIS_RISE], band = half->style.option[MUS__AXIS_BAND];
    double level = rise == MUS__RISE_LOW ? -6.0 * MUS__CM : 0.0;
    if (band == MUS__BAND_CONTOUR && rise != MUS__RISE_HIGH) level -= 4.0 * MUS__CM;
    return mus__lower_scale(half) * level;
}


double mus__lower_waist_ease(const mus__half *half)
{
    if (mus__lower_has_top(half)) return half->waist_ease;
    const double *m = half->measures.v, curve = fmax(0.0, m[MUS_MEASURE_HIP] - m[MUS_MEASURE_WAIST]);
    return fmin(half->waist_ease, 0.1 * curve);
}


double mus__lower_pulled(const mus__half *half)
{
    const double hip = fmax(half->measures.v[MUS_MEASURE_HIP], half->measures.v[MUS_MEASURE_WAIST]);
    return 0.5 * (mus__style_is(half, MUS__AXIS_CLOTH, MUS__CLOTH_KNIT) ? PULLED_KNIT * hip : hip + PULLED_EASE);
}


/* ---- the waist ---- */

static bool lower_is_waist(const mus__half *half, int32_t side, int32_t first, int32_t last)
{
    const mus__board_side *s = &half->board.side[side];
    return s->panel >= first && s->panel < last && strcmp(s->attr.label, "waist") == 0 &&
           mus__board_seam_of(&half->board, side) == MUS_NONE;
}


/* next open half-edge of the boundary loop, forward or back, over every seam in between */
static int32_t lower_step(const mus__half *half, int32_t side, bool forward)
{
    const mus__board *board = &half->board;
    int32_t k = forward ? board->side[side].next : board->side[side].prev;
    for (int32_t i = 0; i < WALK_LONGEST; i++) {
        const int32_t partner = mus__board_partner(board, k);
        if (partner == MUS_NONE) return k;
        k = forward ? board->side[partner].next : board->side[partner].prev;
    }
    return MUS_NONE;
}


int32_t mus__lower_waist(const mus__half *half, int32_t first, int32_t last, int32_t *sides)
{
    const mus__board *board = &half->board;
    int32_t start = MUS_NONE, n = 0;
    if (board->status != MUS_OK) return 0;
    for (int32_t i = 0; i < board->nside && start == MUS_NONE; i++)
        if (board->side[i].panel != MUS_NONE && lower_is_waist(half, i, first, last)) start = i;
    if (start == MUS_NONE) return 0;

    /* back to where the run begins, then along it */
    const int32_t any = start;
    for (int32_t i = 0; i < WALK_LONGEST; i++) {
        const int32_t k = lower_step(half, start, false);
        if (k == MUS_NONE || k == any || !lower_is_waist(half, k, first, last)) break;
        start = k;
    }
    for (int32_t k = start; n < MUS__WAIST_SIDES; ) {
        sides[n++] = k;
        k = lower_step(half, k, true);
        if (k == MUS_NONE || k == start || !lower_is_waist(half, k, first, last)) break;
    }
    return n;
}


/* whether a half-edge of the waist of the bodice belongs to the front, which has x > 0 */
static bool lower_is_front(const mus__half *half, int32_t side)
{
    const double *a = mus__board_start(&half->board, side), *b = mus__board_end(&half->board, side);
    return a[0] + b[0] > 0.0;
}


/* the waist of the bodice, which is on the board before anything is sewn to it */
static int32_t lower_bodice_waist(const mus__half *half, int32_t *sides)
{
    return mus__lower_waist(half, 0, half->board.npanel, sides);
}


double mus__lower_net(const mus__half *half, bool front, double level, double more)
{
    if (!mus__lower_has_top(half))
        return 0.25 * (mus__lower_girth(half, level) + mus__lower_waist_ease(half)) + (front ? more : -more);
    int32_t sides[MUS__WAIST_SIDES];
    const int32_t n = lower_bodice_waist(half, sides);
    double length = 0.0;
    for (int32_t i = 0; i < n; i++)
        if (lower_is_front(half, sides[i]) == front) length += half->board.side[sides[i]].length;
    return length;
}


double mus__lower_snap(const mus__half *half, bool front, double s, double reach)
{
    if (!mus__lower_has_top(half)) return s;
    int32_t sides[MUS__WAIST_SIDES];
    const int32_t n = lower_bodice_waist(half, sides);
    const double net = mus__lower_net(half, front, 0.0, 0.0);
    double at = 0.0, best = s, distance = reach;
    for (int32_t i = 0; i + 1 < n; i++) {
        if (lower_is_front(half, sides[i]) != front) continue;
        at += half->board.side[sides[i]].length;

        /* the front is walked from the centre, the back to it */
        const double from_centre = front ? at : net - at;
        if (from_centre < 0.02 || from_centre > net - 0.02 || fabs(from_centre - s) >= distance) continue;
        best = from_centre;
        distance = fabs(from_centre - s);
    }
    return best;
}


void mus__lower_waist_sew(mus__half *half, int32_t first)
{
    int32_t top[MUS__WAIST_SIDES], below[MUS__WAIST_SIDES];
    if (!mus__lower_has_top(half)) return;
    const int32_t na = mus__lower_waist(half, 0, first, top);
    const int32_t nb = mus__lower_waist(half, first, half->board.npanel, below);
    if (half->board.status == MUS_OK && (na == 0 || nb == 0))
        mus__board_fail(&half->board, MUS_ERR_DESIGN, "waist: nothing to sew: %d sides above, %d below", (int)na,
                        (int)nb);
    mus__waist_zip_below(half, nb, below);
    mus__board_sew(&half->board, na, top, nb, below);
}


double mus__skirt_length(const mus__half *half)
{
    /* lengths from the waist as parts of the stature: knee, mini, midi, maxi, and the middle of a high-low hem;
     * chosen */
    static const double part[] = {0.34, 0.24, 0.46, 0.59, 0.40};
    const double *m = half->measures.v;
    const double length = isnan(half->def.length) ? part[half->style.option[MUS__AXIS_LENGTH]] * m[MUS_MEASURE_STATURE]
                                                  : half->def.length;
    const double level = mus__lower_level(half);
    return fmax(length, m[MUS_MEASURE_WAIST_TO_HIP] + 5.0 * MUS__CM) + level;
}
