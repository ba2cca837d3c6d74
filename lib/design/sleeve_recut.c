/*
 * sleeve_recut.c: sleeves that take a part of the front and back along: raglan and dolman.
 *
 * Raglan: front and back are cut from the neck, 3.5 cm from the shoulder, in a bowed line to the pitch of the armhole.
 * What is cut off is moved to the cap, pitch on pitch, until its shoulder point lies over the crown; between the two
 * shoulder lines there is then a dart, which goes on over the ball of the shoulder.
 *
 *          neckB  /\  neckF                       Dolman: the sleeve is drawn on to front and back; the shoulder goes
 *                /  \                             on along the top of the arm, bent down as the arm is held, the
 *          rag  / || \  rag                       underarm is lower and round.
 *              /  \/  \
 *    capB_low /  dart  \ capF_low
 *             |________|
 */
#include <math.h>
#include <string.h>

#include "design/parts.h"
#include "geom/curve.h"
#include "geom/vec.h"

#define RECUT_SEAM 0.010
#define RECUT_HEM 0.025

/* a chain of the board as one of ours */
static void recut_chain(mus__board *board, int32_t side, mus__chain *out)
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


/* ---- raglan ---- */

/* one of the corners that are cut off: sides of it as chains, each as it is walked */
typedef struct raglan_corner {
    int32_t panel;       /* what it was cut from */
    int32_t rag;         /* its new side there */
    mus__chain neck, shoulder, cut;
    double pitch[2], tip[2];
} raglan_corner;


/* a line from `from` to `to` bowed by `bow` to its left */
static void raglan_line(const double *from, const double *to, double bow, double *out)
{
    const double dx = (to[0] - from[0]) / 3.0, dy = (to[1] - from[1]) / 3.0, d = hypot(dx, dy);
    const double nx = -dy / d * bow / 0.75, ny = dx / d * bow / 0.75;
    mus__cubic_set(out, from, from[0] + dx + nx, from[1] + dy + ny, to[0] - dx + nx, to[1] - dy + ny, to);
}


/* cut off between the starts of sides `first` and `last`; the corner holds neck, shoulder and the upper armhole */
static void raglan_cut(mus__board *board, bool front, int32_t first, int32_t last, double bow, raglan_corner *out)
{
    memset(out, 0, sizeof *out);
    if (board->status != MUS_OK) return;
    const int32_t panel = board->side[first].panel;
    double line[8];
    const int32_t kind = MUS__CUBIC;
    raglan_line(mus__board_start(board, first), mus__board_start(board, last), bow, line);
    const int32_t corner = mus__board_cut(board, first, last, 1, &kind, 4, line, "raglan_corner", "rag");
    if (board->status != MUS_OK) return;
    int32_t rag = board->panel[corner].first;
    for (int32_t i = 0; i < 4 && strcmp(board->side[rag].name, "rag") != 0; i++) rag = board->side[rag].next;
    const int32_t a = board->side[rag].next, b = board->side[a].next, c = board->side[b].next;
    if (board->side[c].next != rag || strcmp(board->side[b].label, "shoulder") != 0) {
        mus__board_fail(board, MUS_ERR_DESIGN, "raglan: the corner at the shoulder of %s is shaped, it has to be plain",
                        board->panel[panel].name);
        return;
    }
    out->panel = panel;
    out->rag = mus__board_partner(board, rag);
    recut_chain(board, front ? c : a, &out->neck);
    recut_chain(board, b, &out->shoulder);
    recut_chain(board, rag, &out->cut);
    memcpy(out->pitch, mus__board_start(board, front ? a : rag), sizeof out->pitch);
    memcpy(out->tip, mus__board_start(board, front ? b : c), sizeof out->tip);
    mus__board_seam_drop(board, rag);
    if (mus__board_partner(board, b) != MUS_NONE) mus__board_seam_drop(board, b);
    mus__board_remove_panel(board, corner);
}


static void raglan_move(mus__chain *chain, const double *from, double angle, const double *to)
{
    const double c = cos(angle), s = sin(angle);
    for (int32_t i = 0; i < chain->nxy; i++) {
        const double x = chain->xy[2 * i] - from[0], y = chain->xy[2 * i + 1] - from[1];
        chain->xy[2 * i] = to[0] + c * x - s * y, chain->xy[2 * i + 1] = to[1] + s * x + c * y;
    }
}


/* pitch on the cap's pitch `at`, turned until the shoulder point is at x */
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
    const double angle = atan2(tip[1] - at[1], dx) -
                         atan2(corner->tip[1] - corner->pitch[1], corner->tip[0] - corner->pitch[0]);
    raglan_move(&corner->neck, corner->pitch, angle, at);
    raglan_move(&corner->shoulder, corner->pitch, angle, at);
    raglan_move(&corner->cut, corner->pitch, angle, at);
    memcpy(corner->tip, tip, sizeof tip);
    memcpy(corner->pitch, at, 2 * sizeof *at);
}


/* from the shoulder point to the dart's: [T, T + .6 half gap along the shoulder, P + .45 (.5 dx, dy), P], (dx, dy) =
 * T - P: a little rounded, on its own side of the middle */
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


/* leg before less leg behind for a dart point at x */
static double raglan_excess(const void *data, double x)
{
    const raglan_problem *problem = data;
    const double point[2] = {x, problem->y};
    double leg[2][8];
    for (int k = 0; k < 2; k++) raglan_dart(problem->snp[k], problem->tip[k], point, leg[k]);
    return mus__cubic_length(leg[0]) - mus__cubic_length(leg[1]);
}


/* the dart's legs: shoulder line, then down to the point; back towards it, front away from it */
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


/* sides next to the shoulder: neck before and behind, cut `along` from it; each the side that the corner ends with */
static bool raglan_necks(mus__half *half, const mus__sleeve_plan *plan, double along, int32_t *front, int32_t *back)
{
    mus__board *board = &half->board;
    const int32_t shoulder = plan->arm.over[plan->shoulder];
    const int32_t before = board->side[shoulder].next;
    const int32_t behind = board->side[mus__board_partner(board, shoulder)].prev;
    const bool plain = strcmp(board->side[before].label, "neck") == 0 && strcmp(board->side[behind].label, "neck") == 0;
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
    mus__rim *arm = &plan->arm;
    const double k = mus__measures_scale(&half->measures), behind = arm->s[arm->n] - plan->back_low;
    int32_t neck_front, neck_back;
    if (!raglan_necks(half, plan, 3.5 * k * MUS__CM, &neck_front, &neck_back)) return;
    const int32_t n = arm->n, low = mus__rim_split(board, arm, plan->front_low);
    const int32_t shoulder = plan->shoulder + arm->n - n, high = mus__rim_split(board, arm, behind);
    if (board->status != MUS_OK) return;
    if (low != shoulder - 1 || high != shoulder + 1) {
        mus__board_fail(board, MUS_ERR_DESIGN, "raglan: the armhole is cut above its pitch");
        return;
    }

    /* corners off, and on to the cap: the shoulder points 2 cm apart over the crown */
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

    /* the sleeve, counter-clockwise from the front of its hem */
    const int32_t panel = mus__board_panel_add(board, "sleeve", "arm");
    mus__chain_side(board, panel, "hem", "cuff", RECUT_HEM, &cut.hem);
    const int32_t under_back = mus__chain_side(board, panel, "underB", NULL, RECUT_SEAM, &cut.under_back);
    const int32_t cap_back =
        mus__chain_side(board, panel, "capB_low", NULL, RECUT_SEAM, &cut.cap[MUS__CAP_BACK_LOW]);
    const int32_t rag_back = mus__chain_side(board, panel, "ragB", NULL, RECUT_SEAM, &back.cut);
    mus__chain_side(board, panel, "neckB", "neck", RECUT_SEAM, &back.neck);
    const int32_t dart_back = mus__chain_side(board, panel, "shB", NULL, RECUT_SEAM, &leg_back);
    const int32_t dart_front = mus__chain_side(board, panel, "shF", NULL, RECUT_SEAM, &leg_front);
    mus__chain_side(board, panel, "neckF", "neck", RECUT_SEAM, &front.neck);
    const int32_t rag_front = mus__chain_side(board, panel, "ragF", NULL, RECUT_SEAM, &front.cut);
    const int32_t cap_front =
        mus__chain_side(board, panel, "capF_low", NULL, RECUT_SEAM, &cut.cap[MUS__CAP_FRONT_LOW]);
    const int32_t under_front = mus__chain_side(board, panel, "underF", NULL, RECUT_SEAM, &cut.under_front);
    mus__board_panel_close(board, panel);
    if (board->status != MUS_OK) return;
    mus__board_seam_add(board, under_front, under_back, MUS_SEAM_REVERSED, 0.0);
    mus__board_sew(board, 1, &dart_front, 1, &dart_back);
    mus__board_sew(board, 1, &rag_front, 1, &front.rag);
    mus__board_sew(board, 1, &rag_back, 1, &back.rag);
    mus__board_sew(board, 1, &cap_front, low, arm->side);
    mus__board_sew(board, 1, &cap_back, arm->n - high, arm->side + high);
    mus__panel_place_arm(half, panel, cut.crown[0], cut.crown[1], cut.width);
    if (plan->cuff_depth > 0.0)
        mus__cuff_attach(half, plan->cuff_length, plan->cuff_depth, plan->block.length);
}


/* ---- dolman ---- */

/* one half of it; outward is +1 in front, where x grows to the side, and -1 behind */
typedef struct dolman_half {
    int32_t side, arm;         /* upper end of the side seam, and the armhole: each to be drawn again */
    double outward, slope;     /* slope of the shoulder below the horizontal */
    double under[2], tip[2];   /* where the side ends, and the shoulder point */
    double up[2];              /* unit vector along the side, to the underarm */
    double bend[2];            /* along the shoulder, outwards */
    double along[2], below[2]; /* along the top of the arm and along its underside, outwards */
    double low[2], high[2];    /* ends of the cuff: below, above */
    double rise, reach;        /* from where the side ends up to its corner with the underside; from there to `low` */
} dolman_half;


/* tip, along the shoulder for 4 cm, then along the arm; the cuff square to it; the underside from the cuff to a point
 * that leaves the arm its room near the body */
static void dolman_draft(const mus__half *garment, const mus__sleeve_plan *plan, double angle, dolman_half *half)
{
    const double k = mus__measures_scale(&garment->measures), arm = garment->measures.v[MUS_MEASURE_UPPER_ARM];
    const double length = plan->block.length, cuff = 0.5 * plan->block.hem, first = 4.0 * k * MUS__CM;
    const double room = 0.62 * arm + 2.0 * k * MUS__CM, out = half->outward;
    const double down[2] = {-out * sin(angle), -cos(angle)};
    double near[2];
    half->along[0] = out * cos(angle), half->along[1] = -sin(angle);
    for (int32_t i = 0; i < 2; i++) {
        half->high[i] = half->tip[i] + first * half->bend[i] + (length - first) * half->along[i];
        half->low[i] = half->high[i] + cuff * down[i];
        near[i] = half->tip[i] + 10.0 * k * MUS__CM * half->along[i] + room * down[i];
    }
    const double d = mus__dist2(near, half->low);
    for (int32_t i = 0; i < 2; i++) half->below[i] = (half->low[i] - near[i]) / d;

    /* corner: under + rise up = low - reach below */
    const double w[2] = {half->low[0] - half->under[0], half->low[1] - half->under[1]};
    const double cross = half->up[0] * half->below[1] - half->up[1] * half->below[0];
    half->rise = (w[0] * half->below[1] - w[1] * half->below[0]) / cross;
    half->reach = (half->up[0] * w[1] - half->up[1] * w[0]) / cross;
}


/* the underarm: [U, U + h rise up, Q - h r below, Q], Q beyond the corner by r = 1.2 rise; then straight to the cuff.
 * `hold` h < 1 is the roundness */
static void dolman_under(const dolman_half *half, double hold, mus__chain *out)
{
    const double r = fmin(1.2 * half->rise, 0.6 * half->reach), *u = half->under;
    double q[2], cubic[8];
    for (int32_t i = 0; i < 2; i++) q[i] = half->low[i] - (half->reach - r) * half->below[i];
    mus__cubic_set(cubic, u, u[0] + hold * half->rise * half->up[0], u[1] + hold * half->rise * half->up[1],
                   q[0] - hold * r * half->below[0], q[1] - hold * r * half->below[1], q);
    mus__chain straight;
    mus__chain_cubic(out, cubic);
    mus__chain_line(&straight, q, half->low);
    mus__chain_append(out, &straight);
}


typedef struct dolman_problem {
    const dolman_half *half;
    double length;
} dolman_problem;


static double dolman_excess(const void *data, double hold)
{
    const dolman_problem *problem = data;
    mus__chain under;
    dolman_under(problem->half, hold, &under);
    return mus__chain_length(&under) - problem->length;
}


/* another line for a side that is in no seam */
static void dolman_replace(mus__board *board, int32_t side, const mus__chain *chain)
{
    mus__board_chain made;
    if (board->status != MUS_OK) return;
    mus__board_chain_make(board, chain->npiece, chain->kinds, chain->nxy, chain->xy, &made);
    if (board->status != MUS_OK) return;
    mus__board_side *own = &board->side[side];
    mus__free(board->context, own->chain.xy);
    own->chain = made;
    own->length = mus__board_chain_length(&made);
    for (int32_t i = 0; i < board->nnotch; i++)
        if (board->notch[i].side == side) board->notch[i].side = MUS_NONE;
}


/* under, cuff and over in the place of the armhole and the end of the side; sides gets them */
static void dolman_draw(mus__half *garment, dolman_half *half, double hold, int32_t *sides)
{
    mus__board *board = &garment->board;
    const double k = mus__measures_scale(&garment->measures), first = 5.0 * k * MUS__CM;
    const bool front = half->outward > 0.0;
    mus__chain chain[3];
    double over[8];
    const double l = 0.6 * mus__dist2(half->tip, half->high);
    mus__cubic_set(over, half->tip, half->tip[0] + first * half->bend[0], half->tip[1] + first * half->bend[1],
                   half->high[0] - l * half->along[0], half->high[1] - l * half->along[1], half->high);
    dolman_under(half, hold, &chain[0]);
    mus__chain_line(&chain[1], half->low, half->high);
    mus__chain_cubic(&chain[2], over);
    mus__chain_reverse(&chain[2]);

    /* one side of both, then three of it: in front walked from the underarm, behind towards it */
    const int32_t whole = front ? half->side : half->arm;
    mus__board_merge(board, whole);
    if (board->status != MUS_OK) return;
    const double part = board->side[whole].length / 3.0;
    const int32_t second = mus__board_split(board, whole, part, NULL);
    const int32_t third = mus__board_split(board, second, part, NULL);
    const int32_t order[3] = {whole, second, third};
    static const char *const names[3] = {"under", "cuff", "over"};
    for (int32_t i = 0; i < 3; i++) {
        const int32_t side = order[front ? i : 2 - i];
        if (!front) mus__chain_reverse(&chain[i]);
        dolman_replace(board, side, &chain[i]);
        if (board->status != MUS_OK) return;
        mus__board_rename(board, side, names[i], i == 1 ? "cuff" : "");
        board->side[side].allowance = i == 1 ? RECUT_HEM : RECUT_SEAM;
        sides[i] = side;
    }
    for (int32_t i = 0; i < 3; i++) mus__board_follow(board, order[i], board->side[order[i]].next);
}


/* how far the underarm comes down the side: 7 cm below the corner of side and underside */
static double dolman_drop(const mus__half *garment, const dolman_half *half)
{
    const double k = mus__measures_scale(&garment->measures);
    return fmax(7.0 * k * MUS__CM - half->rise, 3.0 * k * MUS__CM);
}


/* ends and directions of side and shoulder before [0] and behind [1] */
static void dolman_read(const mus__half *garment, const mus__rim *arm, dolman_half *dolman)
{
    const mus__board *board = &garment->board;
    for (int32_t i = 0; i < 2; i++) {
        dolman_half *own = &dolman[i];
        memset(own, 0, sizeof *own);
        own->arm = arm->side[i];
        own->outward = i == 0 ? 1.0 : -1.0;
        own->side = i == 0 ? board->side[own->arm].prev : board->side[own->arm].next;
        const int32_t shoulder = i == 0 ? board->side[own->arm].next : board->side[own->arm].prev;
        mus__board_at(board, own->side, i == 0 ? board->side[own->side].length : 0.0, own->under, own->up);
        mus__board_at(board, shoulder, i == 0 ? 0.0 : board->side[shoulder].length, own->tip, own->bend);
        for (int32_t c = 0; c < 2; c++) own->up[c] *= own->outward, own->bend[c] *= -own->outward;
        own->slope = atan2(-own->bend[1], own->outward * own->bend[0]);
    }
}


/* both halves drafted along the arm as it is held, or flatter until the underarm is high enough for the side seam: how
 * far the side comes down; NaN: the seam is too short */
static double dolman_fit(const mus__half *garment, const mus__sleeve_plan *plan, dolman_half *dolman, double *bent)
{
    const mus__board *board = &garment->board;
    const double room = 0.8 * fmin(board->side[dolman[0].side].length, board->side[dolman[1].side].length);
    const double arm = garment->measures.v[MUS_MEASURE_ARM_ANGLE];
    for (double angle = arm - 2.0 * MUS__DEGREE; angle > arm - 30.0 * MUS__DEGREE; angle -= 4.0 * MUS__DEGREE) {
        double drop = 0.0;
        *bent = angle - 0.5 * (dolman[0].slope + dolman[1].slope);
        for (int32_t i = 0; i < 2; i++) {
            dolman_draft(garment, plan, dolman[i].slope + *bent, &dolman[i]);
            drop += 0.5 * dolman_drop(garment, &dolman[i]);
        }
        if (drop < room) return drop;
    }
    return (double)NAN;
}


void mus__sleeve_dolman(mus__half *half, mus__sleeve_plan *plan)
{
    mus__board *board = &half->board;
    const mus__rim *arm = &plan->arm;
    if (arm->n != 2 || plan->shoulder != 1) {
        mus__board_fail(board, MUS_ERR_DESIGN,
                        "dolman: the armhole is in %d parts, it has to be one before and one behind", (int)arm->n);
        return;
    }

    dolman_half dolman[2];
    double bent;
    dolman_read(half, arm, dolman);
    const double drop = dolman_fit(half, plan, dolman, &bent);

    /* the side seam ends lower, and the underarm begins there */
    if (drop > 0.0) {
        mus__board_split(board, dolman[0].side, board->side[dolman[0].side].length - drop, NULL);
        if (board->status != MUS_OK) return;
        dolman[0].side = board->side[dolman[0].arm].prev;
        mus__board_seam_drop(board, dolman[0].side);
    }
    bool fits = drop > 0.0;
    for (int32_t i = 0; i < 2 && fits; i++) {
        dolman_half *own = &dolman[i];
        mus__board_at(board, own->side, i == 0 ? 0.0 : board->side[own->side].length, own->under, NULL);
        dolman_draft(half, plan, own->slope + bent, own);
        fits = own->rise > 1.0 * MUS__CM && own->reach > own->rise;
    }
    if (!fits) {
        mus__board_fail(board, MUS_ERR_DESIGN,
                        "dolman: the side seam, %d mm up to the armhole, leaves no place for the underarm",
                        mus__millimetres(board->side[dolman[0].side].length));
        return;
    }

    /* both undersides alike long: one as round as it is meant, the other fitted to it */
    double hold[2] = {0.6, 0.6};
    mus__chain under;
    dolman_under(&dolman[0], hold[0], &under);
    const dolman_problem problem = {&dolman[1], mus__chain_length(&under)};
    mus__solve(dolman_excess, &problem, 0.05, 1.0, &hold[1]);
    int32_t sides[2][3];
    for (int32_t i = 0; i < 2; i++) dolman_draw(half, &dolman[i], hold[i], sides[i]);
    if (board->status != MUS_OK) return;
    mus__board_sew(board, 1, &sides[0][0], 1, &sides[1][0]);
    mus__board_sew(board, 1, &sides[0][2], 1, &sides[1][2]);

    /* arms lie between two flat panels */
    for (int32_t i = 0; i < 2; i++) board->panel[board->side[sides[i][0]].panel].placement.bend = 0.0;
    if (plan->cuff_depth > 0.0)
        mus__cuff_attach(half, plan->cuff_length, plan->cuff_depth, plan->block.length);
}
