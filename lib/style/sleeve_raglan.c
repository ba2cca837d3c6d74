/*
 * sleeve_raglan.c: the raglan sleeve. Front and back are cut along a bowed line from the neckline, 3.5 cm from the
 * shoulder seam, to the pitch point of the armhole. The corners that are cut off become part of the sleeve: each is
 * moved with its pitch point onto that of the cap, and turned until its shoulder point lies above the crown. The gap
 * between the two shoulder lines is the shoulder dart, whose point lies 6 cm below the shoulder points.
 *
 *          neckB  /\  neckF
 *                /  \
 *          rag  / || \  rag
 *              /  \/  \
 *    capB_low /  dart  \ capF_low
 *             |________|
 */
#include <math.h>
#include <string.h>

#include "base/elementary.h"
#include "geom/curve.h"
#include "geom/vec.h"
#include "style/sleeve.h"


/* Copies the curve of a half-edge to *out. Fails when it has more pieces than a mus__chain holds. */
static void raglan_chain(mus__board *board, int32_t side, mus__chain *out)
{
    memset(out, 0, sizeof *out);
    if (board->status != MUS_OK) return;
    const mus__board_chain *from = &board->side[side].chain;
    if (from->npiece > MUS__CHAIN_PIECES) {
        mus__board_fail(board, MUS_ERR_LIMIT, "side %s has %d pieces, %d can be moved to a sleeve",
                        board->side[side].name, (int)from->npiece, MUS__CHAIN_PIECES);
        return;
    }
    out->npiece = from->npiece, out->nxy = from->nxy;
    memcpy(out->kinds, from->kinds, (size_t)from->npiece * sizeof *from->kinds);
    memcpy(out->xy, from->xy, 2 * (size_t)from->nxy * sizeof *from->xy);
}


/* a corner that is cut off a front or back; its curves run counter-clockwise round it */
typedef struct raglan_corner {
    int32_t panel;       /* panel that it was cut from */
    int32_t rag;         /* half-edge of that panel along the cut */
    mus__chain neck, shoulder, cut;
    double pitch[2], tip[2];
} raglan_corner;


/* Writes a cubic (4 x 2) from `from` to `to` whose middle lies `bow` [m] to the left of the chord. */
static void raglan_line(const double *from, const double *to, double bow, double *out)
{
    const double dx = (to[0] - from[0]) / 3.0, dy = (to[1] - from[1]) / 3.0, d = mus__hypot(dx, dy);
    const double nx = -dy / d * bow / 0.75, ny = dx / d * bow / 0.75;
    mus__cubic_set(out, from, from[0] + dx + nx, from[1] + dy + ny, to[0] - dx + nx, to[1] - dy + ny, to);
}


/* Cuts a corner off between the starts of half-edges `first` and `last`, along a line bowed by `bow` [m], copies its
 * curves to *out and removes it. The corner has a part of the neckline, the shoulder and the upper armhole; it fails
 * when it has anything else. */
static void raglan_cut(mus__board *board, bool front, int32_t first, int32_t last, double bow, raglan_corner *out)
{
    memset(out, 0, sizeof *out);
    if (board->status != MUS_OK) return;
    const int32_t panel = board->side[first].panel;
    double line[8];
    const int32_t kind = MUS__CUBIC;
    raglan_line(mus__board_start(board, first), mus__board_start(board, last), bow, line);
    const int32_t corner = mus__board_cut(board, first, last, &(mus__board_path){1, &kind, 4, line},
                                          "raglan_corner", "rag");
    if (board->status != MUS_OK) return;
    int32_t rag = board->panel[corner].first;
    for (int32_t i = 0; i < 4 && strcmp(board->side[rag].name, "rag") != 0; i++) rag = board->side[rag].next;
    const int32_t a = board->side[rag].next, b = board->side[a].next, c = board->side[b].next;
    if (board->side[c].next != rag || strcmp(board->side[b].attr.label, "shoulder") != 0) {
        mus__board_fail(board, MUS_ERR_DESIGN, "raglan: the corner at the shoulder of %s is shaped, it has to be plain",
                        board->panel[panel].name);
        return;
    }
    out->panel = panel;
    out->rag = mus__board_partner(board, rag);
    raglan_chain(board, front ? c : a, &out->neck);
    raglan_chain(board, b, &out->shoulder);
    raglan_chain(board, rag, &out->cut);
    memcpy(out->pitch, mus__board_start(board, front ? a : rag), sizeof out->pitch);
    memcpy(out->tip, mus__board_start(board, front ? b : c), sizeof out->tip);
    mus__board_seam_drop(board, rag);
    if (mus__board_partner(board, b) != MUS_NONE) mus__board_seam_drop(board, b);
    mus__board_remove_panel(board, corner);
}


static void raglan_move(mus__chain *chain, const double *from, double angle, const double *to)
{
    const double c = mus__cos(angle), s = mus__sin(angle);
    for (int32_t i = 0; i < chain->nxy; i++) {
        const double x = chain->xy[2 * i] - from[0], y = chain->xy[2 * i + 1] - from[1];
        chain->xy[2 * i] = to[0] + c * x - s * y, chain->xy[2 * i + 1] = to[1] + s * x + c * y;
    }
}


/* Moves a corner: its pitch point comes to `at`, and it is turned until its shoulder point has the given x [m]. */
static void raglan_set(mus__half *half, raglan_corner *corner, const double *at, double x)
{
    const double reach = mus__dist2(corner->pitch, corner->tip), dx = x - at[0];
    if (!(fabs(dx) < 0.98 * reach)) {
        mus__board_fail(&half->board, MUS_ERR_DESIGN,
                        "raglan: a shoulder %d mm above the pitch does not reach the crown, %d mm beside it",
                        mus__millimetres(reach), mus__millimetres(fabs(dx)));
        return;
    }
    const double tip[2] = {x, at[1] + sqrt(reach * reach - dx * dx)};
    const double angle = mus__atan2(tip[1] - at[1], dx) -
                         mus__atan2(corner->tip[1] - corner->pitch[1], corner->tip[0] - corner->pitch[0]);
    raglan_move(&corner->neck, corner->pitch, angle, at);
    raglan_move(&corner->shoulder, corner->pitch, angle, at);
    raglan_move(&corner->cut, corner->pitch, angle, at);
    memcpy(corner->tip, tip, sizeof tip);
    memcpy(corner->pitch, at, 2 * sizeof *at);
}


/* Writes one leg of the shoulder dart from the shoulder point T (tip) to the dart's point P, as the cubic
 * [T, T + 0.6 |dx| u, P + 0.45 (0.5 dx, dy), P] with (dx, dy) = T - P and u the direction of the shoulder line. */
static void raglan_dart(const double *snp, const double *tip, const double *point, double *out)
{
    const double d = mus__dist2(snp, tip), dx = tip[0] - point[0], dy = tip[1] - point[1], hold = 0.6 * fabs(dx);
    mus__cubic_set(out, tip, tip[0] + hold * (tip[0] - snp[0]) / d, tip[1] + hold * (tip[1] - snp[1]) / d,
                   point[0] + 0.225 * dx, point[1] + 0.45 * dy, point);
}


typedef struct raglan_problem {
    const double *snp[2], *tip[2];
    double y;
} raglan_problem;


/* Returns the length of the front leg less that of the back leg [m] for a dart point at x. */
static double raglan_excess(const void *data, double x)
{
    const raglan_problem *problem = data;
    const double point[2] = {x, problem->y};
    double leg[2][8];
    for (int k = 0; k < 2; k++) raglan_dart(problem->snp[k], problem->tip[k], point, leg[k]);
    return mus__cubic_length(leg[0]) - mus__cubic_length(leg[1]);
}


/* Writes the legs of the shoulder dart: each the shoulder line and the curve down to the dart's point, which lies
 * `depth` [m] below the lower shoulder point, at the x at which both are equally long. The back leg runs to the point,
 * the front leg from it. */
static void raglan_legs(const raglan_corner *front, const raglan_corner *back, double depth, mus__chain *leg_front,
                        mus__chain *leg_back)
{
    const double *snp_front = front->shoulder.xy + 2 * (front->shoulder.nxy - 1), *snp_back = back->shoulder.xy;
    const double y = fmin(front->tip[1], back->tip[1]) - depth;
    const raglan_problem problem = {{snp_front, snp_back}, {front->tip, back->tip}, y};
    double point[2] = {0.5 * (front->tip[0] + back->tip[0]), y}, cubic[8];
    mus__solve(raglan_excess, &problem, point[0] - 0.1 * depth, point[0] + 0.1 * depth, &point[0]);
    mus__chain rest;
    *leg_back = back->shoulder;
    raglan_dart(snp_back, back->tip, point, cubic);
    mus__chain_cubic(&rest, cubic);
    mus__chain_append(leg_back, &rest);
    raglan_dart(snp_front, front->tip, point, cubic);
    mus__chain_cubic(leg_front, cubic);
    mus__chain_reverse(leg_front);
    mus__chain_append(leg_front, &front->shoulder);
}


/* Splits the neckline of front and back `along` [m] from the shoulder seam. Writes the half-edges at which the cuts
 * begin. Returns false, and the board fails, where the neckline is shaped or shorter than 1.3 `along`. */
static bool raglan_necks(mus__half *half, const mus__sleeve_plan *plan, double along, int32_t *front, int32_t *back)
{
    mus__board *board = &half->board;
    const int32_t shoulder = plan->arm.over[plan->shoulder];
    const int32_t before = board->side[shoulder].next;
    const int32_t behind = board->side[mus__board_partner(board, shoulder)].prev;
    const bool plain = strcmp(board->side[before].attr.label, "neck") == 0 &&
                       strcmp(board->side[behind].attr.label, "neck") == 0;
    if (!plain || board->side[before].length < 1.3 * along || board->side[behind].length < 1.3 * along) {
        mus__board_fail(board, MUS_ERR_DESIGN,
                        "raglan: the neckline beside the shoulder is shaped or shorter than %d mm",
                        mus__millimetres(1.3 * along));
        return false;
    }
    *front = mus__board_split(board, before, along, NULL);
    *back = mus__board_split(board, behind, board->side[behind].length - along, NULL);
    return board->status == MUS_OK;
}


void mus__sleeve_raglan(mus__half *half, mus__sleeve_plan *plan)
{
    mus__board *board = &half->board;
    mus__boundary *arm = &plan->arm;
    const double k = mus__measures_scale(&half->measures), behind = arm->s[arm->n] - plan->back_low;
    int32_t neck_front, neck_back;
    if (!raglan_necks(half, plan, 3.5 * k * MUS__CM, &neck_front, &neck_back)) return;
    const int32_t n = arm->n, low = mus__boundary_split(board, arm, plan->front_low);
    const int32_t shoulder = plan->shoulder + arm->n - n, high = mus__boundary_split(board, arm, behind);
    if (board->status != MUS_OK) return;
    if (low != shoulder - 1 || high != shoulder + 1) {
        mus__board_fail(board, MUS_ERR_DESIGN, "raglan: the armhole is cut above its pitch");
        return;
    }

    /* cut the corners off and move them to the cap, the shoulder points 2 cm apart above the crown */
    raglan_corner front, back;
    mus__sleeve_cut cut;
    mus__sleeve_plain(&plan->block, plan->front_low, plan->back_low, &cut);
    raglan_cut(board, true, arm->side[low], neck_front, 0.8 * k * MUS__CM, &front);
    raglan_cut(board, false, neck_back, arm->side[high], 0.8 * k * MUS__CM, &back);
    if (board->status != MUS_OK) return;
    raglan_set(half, &front, cut.cap[MUS__CAP_FRONT_LOW].xy, cut.crown[0] - 1.0 * k * MUS__CM);
    raglan_set(half, &back, cut.cap[MUS__CAP_BACK_HIGH].xy, cut.crown[0] + 1.0 * k * MUS__CM);
    if (board->status != MUS_OK) return;
    mus__chain leg_front, leg_back;
    raglan_legs(&front, &back, 6.0 * k * MUS__CM, &leg_front, &leg_back);

    /* draw the sleeve, counter-clockwise from the front of its hem */
    const int32_t panel = mus__board_panel_add(board, "sleeve", "arm");
    mus__chain_side(board, panel, "hem", "cuff", MUS__HEM_ALLOWANCE, &cut.hem);
    const int32_t under_back = mus__chain_side(board, panel, "underB", NULL, MUS__SEAM_ALLOWANCE, &cut.under_back);
    const int32_t cap_back =
        mus__chain_side(board, panel, "capB_low", NULL, MUS__SEAM_ALLOWANCE, &cut.cap[MUS__CAP_BACK_LOW]);
    const int32_t rag_back = mus__chain_side(board, panel, "ragB", NULL, MUS__SEAM_ALLOWANCE, &back.cut);
    mus__chain_side(board, panel, "neckB", "neck", MUS__SEAM_ALLOWANCE, &back.neck);
    const int32_t dart_back = mus__chain_side(board, panel, "shB", NULL, MUS__SEAM_ALLOWANCE, &leg_back);
    const int32_t dart_front = mus__chain_side(board, panel, "shF", NULL, MUS__SEAM_ALLOWANCE, &leg_front);
    mus__chain_side(board, panel, "neckF", "neck", MUS__SEAM_ALLOWANCE, &front.neck);
    const int32_t rag_front = mus__chain_side(board, panel, "ragF", NULL, MUS__SEAM_ALLOWANCE, &front.cut);
    const int32_t cap_front =
        mus__chain_side(board, panel, "capF_low", NULL, MUS__SEAM_ALLOWANCE, &cut.cap[MUS__CAP_FRONT_LOW]);
    const int32_t under_front = mus__chain_side(board, panel, "underF", NULL, MUS__SEAM_ALLOWANCE, &cut.under_front);
    mus__board_panel_close(board, panel);
    if (board->status != MUS_OK) return;
    mus__board_seam_add(board, under_front, under_back, MUS_SEAM_REVERSED, 0.0);
    mus__board_notch_add(board, cap_front, 0.0, MUS_NOTCH_SINGLE);
    mus__board_notch_add(board, cap_back, board->side[cap_back].length, MUS_NOTCH_DOUBLE);
    mus__board_sew(board, 1, &dart_front, 1, &dart_back);
    mus__board_sew(board, 1, &rag_front, 1, &front.rag);
    mus__board_sew(board, 1, &rag_back, 1, &back.rag);
    mus__board_sew(board, 1, &cap_front, low, arm->side);
    mus__board_sew(board, 1, &cap_back, arm->n - high, arm->side + high);
    mus__panel_place_arm(half, panel, cut.crown[0], cut.crown[1], cut.width);
    if (plan->cuff_depth > 0.0)
        mus__cuff_attach(half, plan->cuff_length, plan->cuff_depth, plan->block.length);
}
