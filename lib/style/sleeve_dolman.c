/*
 * sleeve_dolman.c: the dolman sleeve, which is cut in one piece with the front and the back.
 *
 * The shoulder line continues along the top of the arm, bent down by the angle of the arm. The underarm is a curve that
 * begins below the armhole on the side seam; a bust dart that opens there is first rotated further down. Front and back
 * have congruent top edges, and undersides of equal length.
 *
 *        neck ___ shoulder
 *            |   \___
 *            |       \___ over
 *     centre |           \___
 *            |      _         \
 *            |     | \___      / cuff
 *            |     |     \___ /
 *            |side |     under
 */
#include <math.h>
#include <string.h>

#include "base/elementary.h"
#include "geom/vec.h"
#include "style/sleeve.h"


/* the sleeve's front or back half: points [m] and unit vectors in the frame of its panel */
typedef struct dolman_half {
    int32_t side, arm;         /* half-edges that are replaced: uppermost part of the side seam, armhole */
    double outward;            /* sign of x towards the side: +1 in front, -1 behind */
    double slope;              /* angle of the shoulder line below the horizontal [rad] */
    double under[2], tip[2];   /* upper end of the side seam; shoulder point */
    double up[2];              /* unit vector along the side seam, upwards */
    double bend[2];            /* unit vector along the shoulder line, outwards */
    double along[2], below[2]; /* unit vectors along the top of the arm and along its underside, outwards */
    double low[2], high[2];    /* lower and upper end of the cuff line */
    double rise, reach;        /* [m] from `under` along `up` to the corner C with the underside; from C to `low` */
} dolman_half;


/* Computes the points of one half from its side, shoulder and the angle [rad] of the arm below the horizontal. The top
 * runs from the shoulder point 4 cm along the shoulder line, then along the arm; the cuff line is square to the arm.
 * The underside passes the point that gives front and back together 1.08 of the arm's girth + 2 cm near the body (loose
 * 0), up to 1.18 + 4 cm (loose 1). */
static void dolman_draft(const mus__half *garment, const mus__sleeve_plan *plan, double angle, double loose,
                         dolman_half *half)
{
    const double k = mus__measures_scale(&garment->measures), arm = garment->measures.v[MUS_MEASURE_UPPER_ARM];
    const double length = plan->block.length, cuff = 0.5 * plan->block.hem, first = 4.0 * k * MUS__CM;
    const double room = (0.54 + 0.05 * loose) * arm + (1.0 + loose) * k * MUS__CM, out = half->outward;
    const double down[2] = {-out * mus__sin(angle), -mus__cos(angle)};
    double near[2];
    half->along[0] = out * mus__cos(angle), half->along[1] = -mus__sin(angle);
    for (int32_t i = 0; i < 2; i++) {
        half->high[i] = half->tip[i] + first * half->bend[i] + (length - first) * half->along[i];
        half->low[i] = half->high[i] + cuff * down[i];
        near[i] = half->tip[i] + 10.0 * k * MUS__CM * half->along[i] + room * down[i];
    }
    const double d = mus__dist2(near, half->low);
    for (int32_t i = 0; i < 2; i++) half->below[i] = (half->low[i] - near[i]) / d;

    /* corner C of side seam and underside: under + rise up = low - reach below */
    const double w[2] = {half->low[0] - half->under[0], half->low[1] - half->under[1]};
    const double cross = half->up[0] * half->below[1] - half->up[1] * half->below[0];
    half->rise = (w[0] * half->below[1] - w[1] * half->below[0]) / cross;
    half->reach = (half->up[0] * w[1] - half->up[1] * w[0]) / cross;
}


/* Writes the underside to *out: the cubic [U, U + h rise up, Q - h r below, Q] from the side seam's end U to Q, which
 * lies r = 1.2 rise beyond the corner, then a line to the cuff. h (`hold`, 0 to 1) is the length of the handles as a
 * share of their tangents: with a larger h the curve lies nearer to the corner. */
static void dolman_under(const dolman_half *half, double hold, mus__chain *out)
{
    const double r = fmin(1.2 * half->rise, 0.6 * half->reach), *u = half->under;
    double q[2];
    for (int32_t i = 0; i < 2; i++) q[i] = half->low[i] - (half->reach - r) * half->below[i];
    out->npiece = 0;
    mus__chain_add_cubic(out, u, u[0] + hold * half->rise * half->up[0], u[1] + hold * half->rise * half->up[1],
                         q[0] - hold * r * half->below[0], q[1] - hold * r * half->below[1], q);
    mus__chain_add_line(out, q, half->low);
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


/* Replaces the curve of a half-edge that is in no seam. */
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


/* Draws underside, cuff line and top of one half in the place of its armhole and of the side seam's end. Writes the
 * three half-edges to sides (3). */
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

    /* side end and armhole are merged and split in three; the front's outline runs from the underarm, the back's to it
     */
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
        board->side[side].attr.allowance = i == 1 ? MUS__HEM_ALLOWANCE : MUS__SEAM_ALLOWANCE;
        sides[i] = side;
    }
    for (int32_t i = 0; i < 3; i++) mus__board_follow(board, order[i], board->side[order[i]].next);
}


/* Rotates a bust dart that opens in the side seam just below the armhole `arm` to a place 14 cm lower, and merges the
 * side above it into one half-edge. */
static void dolman_free_side(mus__half *garment, int32_t arm)
{
    mus__board *board = &garment->board;
    const double k = mus__measures_scale(&garment->measures);
    const int32_t after = board->side[board->side[arm].prev].prev, leg = board->side[after].prev;
    if (mus__board_partner(board, after) == leg) {
        const int32_t target = board->side[leg].prev, keep = board->side[arm].next;
        const double length = board->side[target].length;
        mus__board_dart_rotate(board, leg, target, fmax(0.3 * length, length - 14.0 * k * MUS__CM), keep, 1.0);
    }
    for (int32_t i = 0; i < board->nside && board->status == MUS_OK; i++) {
        const int32_t before = board->side[board->side[arm].prev].prev;
        if (strcmp(board->side[before].attr.label, "side") != 0 || !mus__board_mergeable(board, before)) break;
        mus__board_merge(board, before);
    }
}


/* Returns the length [m] to take off the side seam's upper end, so that the underarm begins 4.5 cm (loose 0) to 6.5 cm
 * (loose 1) below the corner of side and underside. */
static double dolman_drop(const mus__half *garment, const dolman_half *half, double loose)
{
    const double k = mus__measures_scale(&garment->measures);
    return fmax((4.5 + 2.0 * loose) * k * MUS__CM - half->rise, 3.0 * k * MUS__CM);
}


/* Reads the ends and directions of side seam and shoulder line of the front [0] and the back [1]. */
static void dolman_read(const mus__half *garment, const mus__boundary *arm, dolman_half *dolman)
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
        own->slope = mus__atan2(-own->bend[1], own->outward * own->bend[0]);
    }
}


/* Drafts both halves along the arm at its own angle, first loose, then closer, then with the arm raised by steps of
 * 4 degrees, until the length to take off the side seam is below 0.8 of it. Returns that length [m], the bend of the
 * shoulder line [rad] and the looseness; NaN when the side seam is too short for all of them. */
static double dolman_fit(const mus__half *garment, const mus__sleeve_plan *plan, dolman_half *dolman, double *bent,
                         double *loose)
{
    const mus__board *board = &garment->board;
    const double arm = garment->measures.v[MUS_MEASURE_ARM_ANGLE] - 2.0 * MUS__DEGREE;
    const double room = 0.8 * fmin(board->side[dolman[0].side].length, board->side[dolman[1].side].length);
    for (int32_t flatter = 0; flatter < 7; flatter++) {
        for (*loose = 1.0; *loose >= 0.0; *loose -= 0.5) {
            double drop = 0.0;
            *bent = arm - 4.0 * MUS__DEGREE * flatter - 0.5 * (dolman[0].slope + dolman[1].slope);
            for (int32_t i = 0; i < 2; i++) {
                dolman_draft(garment, plan, dolman[i].slope + *bent, *loose, &dolman[i]);
                drop += 0.5 * dolman_drop(garment, &dolman[i], *loose);
            }
            if (drop < room) return drop;
        }
    }
    return (double)NAN;
}


void mus__sleeve_dolman(mus__half *half, mus__sleeve_plan *plan)
{
    mus__board *board = &half->board;
    const mus__boundary *arm = &plan->arm;
    if (arm->n != 2 || plan->shoulder != 1) {
        mus__board_fail(board, MUS_ERR_DESIGN,
                        "dolman: the armhole is in %d parts, it has to be one before and one behind", (int)arm->n);
        return;
    }

    dolman_half dolman[2];
    double bent, loose;
    dolman_free_side(half, arm->side[0]);
    if (board->status != MUS_OK) return;
    dolman_read(half, arm, dolman);
    const double drop = dolman_fit(half, plan, dolman, &bent, &loose);

    /* shorten the side seam; the underarm begins at its new end */
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
        dolman_draft(half, plan, own->slope + bent, loose, own);
        fits = own->rise > 1.0 * MUS__CM && own->reach > own->rise;
    }
    if (!fits) {
        mus__board_fail(board, MUS_ERR_DESIGN,
                        "dolman: the side seam, %d mm up to the armhole, leaves no place for the underarm",
                        mus__millimetres(board->side[dolman[0].side].length));
        return;
    }

    /* undersides of equal length: the handles of the front's are 0.6, those of the back's are solved for */
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

    /* flatter start positions: the arm needs room between front and back */
    for (int32_t i = 0; i < 2; i++) board->panel[board->side[sides[i][0]].panel].attr.placement.bend *= 3.0;
    if (plan->cuff_depth > 0.0)
        mus__cuff_attach(half, plan->cuff_length, plan->cuff_depth, plan->block.length);
}
