/*
 * waistband.c: the finish of the waist of a skirt or trousers: a straight band, a shaped band, a facing, elastic, or
 * none.
 *
 * A band is a ring on the waist. A straight or elastic band is a strip. A shaped band is a strip of a cone whose lower
 * and upper edges l0, l1 have the girth of the body and its ease at their heights, h apart:
 *
 *   angle = (l1 - l0) / h, radii l0 / angle and l1 / angle of lower and upper edge
 *
 * A band is on the fold at both centres, but for the place where the garment opens (closure/waist_opening.c): there it
 * has two ends. A high rise is a higher band, shaped unless it is elastic. A waist that is longer than the band is
 * eased, gathered or pleated into it. A facing lies inside and is not draped: lib/finish traces it from the waist. A
 * waist that is gathered, or that rises above the waist line, gets a narrow band in place of a facing. Formulas: man
 * page mus_design(3).
 *
 * The grain runs along a straight band, which keeps its length. A shaped band is cut on the fold at the centre, with
 * the grain along the fold.
 *
 * A band is cut twice, an outer and an inner layer, and once of interfacing. The casing of an elastic is cut once and
 * turned in along its upper edge, whose allowance is the inner layer. It passes the hip, if need be by the stretch of
 * a knit; the elastic in it has a length of its own.
 */
#include <math.h>
#include <string.h>

#include "base/elementary.h"
#include "closure/closure.h"
#include "style/waist_edge.h"

#define BAND_SETTLES (1.0 * MUS__CM) /* [m] depth to which a waist may sink before its attachment pulls; chosen */
#define BAND_ELASTIC_EASE (2.0 * MUS__CM) /* of the casing of a knit */
#define BAND_ELASTIC_RATIO 0.9            /* of that, the elastic in any casing; chosen */
#define BAND_ELASTIC_STIFFNESS 60.0 /* [N] */
#define BAND_STRAIGHT 1e-4          /* angle of a shaped band that counts as a straight one; below what is drawn */

typedef struct band_plan {
    double height;
    double low[2], high[2]; /* lengths of the lower and upper edge, front and back */
    double ratio;           /* of an elastic to its casing */
    const char *label;
} band_plan;


/* part of the waist, from centre back to centre front, at which front and back meet: the joint nearest to `expected`,
 * else `expected` */
static double band_joint(const mus__half *half, int32_t n, const int32_t *waist, double expected)
{
    double length = 0.0, at = 0.0, best = expected, distance = 0.03;
    for (int32_t i = 0; i < n; i++) length += half->board.side[waist[i]].length;
    for (int32_t i = 0; i + 1 < n; i++) {
        at += half->board.side[waist[i]].length;
        if (fabs(at / length - expected) >= distance) continue;
        best = at / length;
        distance = fabs(best - expected);
    }
    return best;
}


/* sets the height of the band and the lengths of its edges: girth of the body at their heights and ease of the waist */
static void band_plan_make(const mus__half *half, bool full, double part, band_plan *plan)
{
    /* straight, contour, facing, elastic: as high as that for a natural or low rise, and for a high one */
    static const double height[4][2] = {{3.5, 6.0}, {4.0, 6.0}, {2.5, 4.0}, {3.0, 5.0}};
    const int32_t band = half->style.option[MUS__AXIS_BAND], rise = half->style.option[MUS__AXIS_RISE];
    const double scale = mus__lower_scale(half), level = mus__lower_level(half);
    const bool high = rise == MUS__RISE_HIGH;
    memset(plan, 0, sizeof *plan);
    plan->label = band == MUS__BAND_ELASTIC ? "elastic" : "band";
    if (band == MUS__BAND_FACING && !full && !high) return;
    plan->height = height[band][high ? 1 : 0] * scale * MUS__CM;
    const double ease = mus__lower_waist_ease(half);
    double low = 0.5 * (mus__lower_girth(half, level) + ease);
    double top = 0.5 * (mus__lower_girth(half, level + plan->height) + ease);
    if (band == MUS__BAND_ELASTIC) {
        const double knit = 0.5 * (mus__lower_girth(half, level) + BAND_ELASTIC_EASE);
        const bool gives = mus__style_is(half, MUS__AXIS_CLOTH, MUS__CLOTH_KNIT);
        top = low = gives ? knit : fmax(knit, mus__lower_pulled(half));
        plan->ratio = BAND_ELASTIC_RATIO * knit / low;
    } else if (band != MUS__BAND_CONTOUR && !high)
        top = low;
    plan->low[1] = part * low, plan->low[0] = low - plan->low[1];
    plan->high[1] = part * top, plan->high[0] = top - plan->high[1];
}


/* half a band of the front or back: lower edge from the centre outwards, end up, upper edge back, centre down. The end
 * at which the band opens is called "open" */
static int32_t band_draw(mus__half *half, const band_plan *plan, bool front, int32_t opens)
{
    const double l0 = plan->low[front ? 0 : 1], l1 = plan->high[front ? 0 : 1], h = plan->height;
    const double angle = (l1 - l0) / h;
    mus__chain low, high;
    double p[6][2] = {{0.0, 0.0}, {0.5 * l0, 0.0}, {l0, 0.0}, {l1, h}, {0.5 * l1, h}, {0.0, h}};
    if (fabs(angle) > BAND_STRAIGHT) {
        /* centre of the cone at (0, c): below when the band widens upwards */
        const double c = -l0 / angle;
        for (int i = 0; i < 6; i++) {
            const double turn = angle * (i % 3 == 1 ? 0.5 : i == 2 || i == 3 ? 1.0 : 0.0);
            const double radius = (i < 3 ? l0 : l1) / angle;
            p[i][0] = radius * mus__sin(turn);
            p[i][1] = c + radius * mus__cos(turn);
        }
        p[5][0] = 0.0;
        mus__chain_arc(&low, p[0], p[1], p[2]);
        mus__chain_arc(&high, p[3], p[4], p[5]);
    } else {
        mus__chain_line(&low, p[0], p[2]);
        mus__chain_line(&high, p[3], p[5]);
    }
    const bool elastic = mus__style_is(half, MUS__AXIS_BAND, MUS__BAND_ELASTIC);
    mus__outline outline;
    mus__outline_begin(&outline);
    mus__outline_add(&outline, "low", "band", MUS__SEAM_ALLOWANCE, &low);
    const bool parts = opens == (front ? MUS__CLOSURE_FRONT : MUS__CLOSURE_BACK);
    mus__outline_line(&outline, opens == MUS__CLOSURE_SIDE ? "open" : "end", "side", MUS__SEAM_ALLOWANCE, p[2], p[3]);
    mus__outline_add(&outline, "top", "waist", (elastic ? h : 0.0) + MUS__SEAM_ALLOWANCE, &high);
    mus__outline_line(&outline, parts ? "open" : "centre", "centre", MUS__SEAM_ALLOWANCE, p[5], p[0]);
    const int32_t panel = mus__outline_panel(half, &outline, front ? "band_front" : "band_back", plan->label, !front);
    mus__half_cut(half, panel, elastic ? 1 : 2, MUS_MATERIAL_INTERFACING, elastic ? 0 : 1);
    if (fabs(angle) <= BAND_STRAIGHT) mus__half_band_grain(half, panel);
    if (elastic) mus__closure_fold(&half->board, mus__board_find(&half->board, panel, "top"), 0.0);
    mus__half_centre(half, panel, parts ? "open" : "centre", parts ? MUS__CENTRE_SEAM : MUS__CENTRE_FOLD);
    mus__lower_place_waist(half, panel, front, 2.0 * (plan->low[0] + plan->low[1]),
                          half->waist_level + mus__lower_level(half));
    return panel;
}


/* attaches the edge to the height `level` of the body; an elastic band gets its elastic */
static void band_stay(mus__half *half, int32_t side, double ratio, double level)
{
    mus__edge_attributes *stay = &half->board.side[side].attr;
    stay->hold = MUS_HOLD_WAIST;
    stay->below = BAND_SETTLES - level;
    if (!(ratio > 0.0)) return;
    stay->ratio = ratio;
    stay->stiffness = BAND_ELASTIC_STIFFNESS;
}


void mus__band_attach(mus__half *half)
{
    mus__board *board = &half->board;
    int32_t waist[MUS__WAIST_SIDES];
    if (board->status != MUS_OK || mus__lower_has_top(half)) return;
    if (half->style.option[MUS__AXIS_BAND] == MUS__BAND_NONE) return;
    const int32_t n = mus__lower_waist(half, 0, board->npanel, waist);
    if (board->status == MUS_OK && n == 0)
        mus__board_fail(board, MUS_ERR_DESIGN, "band: no waist to sew it to");
    mus__waist_zip(half, n, waist);
    if (board->status != MUS_OK) return;

    /* gathered or not */
    const int32_t skirt = half->style.option[MUS__AXIS_SKIRT];
    const bool full = half->style.option[MUS__AXIS_GARMENT] == MUS__GARMENT_SKIRT &&
                      (skirt == MUS__SKIRT_GATHERED || skirt == MUS__SKIRT_KNIFE || skirt == MUS__SKIRT_BOX ||
                       skirt == MUS__SKIRT_TIERED);
    band_plan plan;
    band_plan_make(half, full, band_joint(half, n, waist, 0.5), &plan);
    if (!(plan.height > 0.0)) {
        for (int32_t i = 0; i < n; i++) band_stay(half, waist[i], plan.ratio, mus__lower_level(half));
        return;
    }
    const int32_t opens = mus__waist_opens(half, n, waist);
    const char *end = opens == MUS__CLOSURE_SIDE ? "open" : "end";
    const int32_t front = band_draw(half, &plan, true, opens), back = band_draw(half, &plan, false, opens);
    mus__half_sew(half, front, end, back, end, 0.0);
    if (board->status != MUS_OK) return;
    for (int32_t i = 0; i < n; i++) {
        char name[MUS__NAME_BYTES];
        memcpy(name, board->side[waist[i]].name, sizeof name);
        mus__board_rename(board, waist[i], name, "band");
    }
    const int32_t low[2] = {mus__board_find(board, front, "low"), mus__board_find(board, back, "low")};
    mus__board_sew(board, 2, low, n, waist);
    if (board->status != MUS_OK) return;
    const double level = mus__lower_level(half) + plan.height;
    band_stay(half, mus__board_find(board, front, "top"), plan.ratio, level);
    band_stay(half, mus__board_find(board, back, "top"), plan.ratio, level);
}
