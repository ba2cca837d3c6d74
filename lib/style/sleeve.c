/*
 * sleeve.c: sleeves of a half garment: the armhole on the cutting table is measured, a cap is drafted to it and sewn
 * in, the underarm is sewn, and the sleeve is rolled round the arm.
 *
 * The armhole is read as one line from the underarm over the front to the shoulder and down the back, over all its
 * panels. A cap with ease or gathers is parted at the pitches, where the armhole has its notches: below them cap and
 * armhole have one length, and the ease lies between the pitches and the crown. A cap without ease has one edge in
 * front and one behind. Formulas: man page mus_design(3).
 */
#include <math.h>
#include <string.h>

#include "style/sleeve.h"

/* pitch of an armhole without a notch, as part of its length from the underarm up: near that of the bodice block */
#define PITCH_FRONT 0.47
#define PITCH_BACK 0.48


/* ---- the plan ---- */

/* arc length of the pitch on half-edges first..last - 1: the notch, else the joint nearest to the usual place */
static double plan_pitch(const mus__half *half, const mus__boundary *arm, int32_t first, int32_t last, bool front)
{
    const double s0 = arm->s[first], s1 = arm->s[last], length = s1 - s0;
    const double usual = front ? s0 + PITCH_FRONT * length : s1 - PITCH_BACK * length;
    const double notch =
        mus__boundary_notch(&half->board, arm, first, last, front ? MUS_NOTCH_SINGLE : MUS_NOTCH_DOUBLE);
    double best = usual, off = 0.15 * length;
    if (notch > s0 + 0.2 * length && notch < s1 - 0.2 * length) return notch;
    for (int32_t i = first + 1; i < last; i++)
        if (fabs(arm->s[i] - usual) < off) best = arm->s[i], off = fabs(best - usual);
    return best;
}


/* whether the cap is flat and has no ease: of knit and loose tops */
static bool plan_flat(const mus__half *half)
{
    const int32_t *option = half->style.option, sleeve = option[MUS__AXIS_SLEEVE];
    return option[MUS__AXIS_CLOTH] == MUS__CLOTH_KNIT || option[MUS__AXIS_SHAPE] == MUS__SHAPE_BOXY ||
           sleeve == MUS__SLEEVE_RAGLAN || sleeve == MUS__SLEEVE_CAP || sleeve == MUS__SLEEVE_TEE;
}


/* breadth on the biceps line [m]: by the ease word 1.10 to 1.45 of the upper arm; of a flat cap 4 to 12 cm more than
 * it */
static double plan_width(const mus__half *half, double cap, bool flat)
{
    static const double room[] = {1.15, 1.10, 1.24, 1.45, 1.15}; /* regular, slim, loose, coat, block */
    const double arm = half->measures.v[MUS_MEASURE_UPPER_ARM], k = mus__measures_scale(&half->measures);
    const int32_t ease = half->style.option[MUS__AXIS_EASE];
    double width = room[ease] * arm;
    if (flat) {
        const double more = ease == MUS__EASE_SLIM ? 2.0 : ease == MUS__EASE_COAT ? 12.0 : 4.0;
        const double most = fmax(more, 12.0);
        width = fmax(arm + more * k * MUS__CM, fmin(arm + most * k * MUS__CM, mus__sleeve_width(cap, 0.25)));
    }
    return fmin(width, cap / 1.03);
}


/* length of each sleeve word from the crown, as part of the arm's length; chosen */
static double plan_part(int32_t sleeve)
{
    switch (sleeve) {
    case MUS__SLEEVE_TEE:
    case MUS__SLEEVE_SHORT: return 0.36;
    case MUS__SLEEVE_PUFF: return 0.34;
    case MUS__SLEEVE_ELBOW: return 0.56;
    case MUS__SLEEVE_THREE_QUARTER: return 0.75;
    case MUS__SLEEVE_DOLMAN: return 0.80;
    case MUS__SLEEVE_BELL: return 0.92;
    default: return 1.0;
    }
}


/* sets the cuff and the hem above it: a cuff is 5 cm longer than the girth of the arm and the hand passes it; a rib is
 * 0.8 of the hem that it draws in */
static void plan_cuff(mus__half *half, double part, double hand, mus__sleeve_plan *plan, double *hem)
{
    const double *m = half->measures.v, k = mus__measures_scale(&half->measures);
    const int32_t sleeve = half->style.option[MUS__AXIS_SLEEVE];
    int32_t cuff = half->style.option[MUS__AXIS_CUFF];
    if ((sleeve == MUS__SLEEVE_PUFF || sleeve == MUS__SLEEVE_BISHOP) && cuff == MUS__CUFF_NONE) cuff = MUS__CUFF_CUFF;
    if (sleeve == MUS__SLEEVE_BELL || sleeve == MUS__SLEEVE_CAP) cuff = MUS__CUFF_NONE;
    plan->cuff_length = plan->cuff_depth = 0.0;
    if (cuff == MUS__CUFF_NONE) return;

    const double arm = m[MUS_MEASURE_UPPER_ARM], wrist = m[MUS_MEASURE_WRIST];
    const double girth = arm + plan->reach * (wrist - arm);
    plan->cuff_depth = (part > 0.9 ? 6.0 : sleeve == MUS__SLEEVE_PUFF ? 2.5 : 4.0) * k * MUS__CM;
    plan->cuff_length = fmax(girth + (sleeve == MUS__SLEEVE_PUFF ? 3.0 : 5.0) * k * MUS__CM, hand);
    if (cuff == MUS__CUFF_RIB) {
        *hem = fmax(*hem, fmax(girth + 6.0 * k * MUS__CM, hand));
        plan->cuff_length = 0.8 * *hem;
    } else {
        *hem = plan->cuff_length * (1.0 + 0.2 * plan->reach);
    }
}


/* hem [m] of a T-shirt's sleeve that is `part` of the arm long: it narrows from the biceps line towards the hand by the
 * length, by 0.15 of the way at least */
static double plan_tee_hem(double width, double hand, double part)
{
    return width + fmax(0.15, fmin(1.0, part - 0.25)) * (fmin(hand, width) - width);
}


/* drafts the block of the sleeve; its hem narrows from the biceps towards the hand with the length */
static void plan_block(mus__half *half, mus__sleeve_plan *plan)
{
    const double *m = half->measures.v, k = mus__measures_scale(&half->measures), arm = m[MUS_MEASURE_ARM];
    const int32_t sleeve = half->style.option[MUS__AXIS_SLEEVE];
    mus__sleeve_def def = {.front = plan->front * (1.0 + plan->ease), .back = plan->back * (1.0 + plan->ease)};
    const double asked = half->def.sleeve, part = isnan(asked) ? plan_part(sleeve) : asked / arm;
    def.width = plan_width(half, def.front + def.back, plan_flat(half));
    def.length = 2.0 * arm;
    half->board.status = mus__sleeve_draft(half->context, &def, &plan->block);
    if (half->board.status != MUS_OK) return;

    /* 3 cm of underarm at least, which a small child's arm asks for; the block itself needs 2 */
    const double height = plan->block.height, least = height + fmax(3.0 * k, 2.2) * MUS__CM;
    def.length = fmax(part * arm, least);
    plan->reach = fmin(1.0, fmax(0.05, (def.length - height) / fmax(arm - height, 1.0 * MUS__CM)));
    const bool coat = half->style.option[MUS__AXIS_EASE] == MUS__EASE_COAT;
    const double over = coat ? 6.0 * k * MUS__CM : 0.0; /* room for the cuff of the shirt under it */
    const double hand = fmax(1.2 * m[MUS_MEASURE_WRIST], m[MUS_MEASURE_HAND] + 1.5 * MUS__CM) + over;
    const double taper = plan->reach < 0.6 ? 2.0 * k * MUS__CM : 0.0;
    def.hem = fmax(def.width + plan->reach * (fmin(hand, def.width) - def.width) - taper, hand);
    if (sleeve == MUS__SLEEVE_TEE) def.hem = plan_tee_hem(def.width, hand, def.length / arm);
    plan_cuff(half, part, hand, plan, &def.hem);
    const double blouse = sleeve == MUS__SLEEVE_BISHOP ? 3.0 * k * MUS__CM : 0.0;
    def.length = fmax(def.length - plan->cuff_depth + blouse, least);
    half->board.status = mus__sleeve_draft(half->context, &def, &plan->block);
}


static void sleeve_plan_read(mus__half *half, mus__sleeve_plan *out)
{
    mus__board *board = &half->board;
    mus__boundary *arm = &out->arm;
    memset(out, 0, sizeof *out);
    mus__boundary_read(half, "armhole", arm);
    if (board->status != MUS_OK) return;

    /* the shoulder is the joint of front and back; a yoke goes over it, with a joint near the middle of the armhole */
    out->shoulder = mus__boundary_over(board, arm, "shoulder");
    if (out->shoulder == MUS_NONE) out->shoulder = mus__boundary_near(arm, 0.51, 0.1);
    if (out->shoulder == MUS_NONE || out->shoulder == 0) {
        mus__board_fail(board, MUS_ERR_DESIGN, "sleeve: the armhole has no shoulder seam to put its crown to");
        return;
    }
    out->front = arm->s[out->shoulder];
    out->back = arm->s[arm->n] - out->front;
    out->front_low = plan_pitch(half, arm, 0, out->shoulder, true);
    out->back_low = arm->s[arm->n] - plan_pitch(half, arm, out->shoulder, arm->n, false);

    /* woven set-in sleeves are eased in: 3 % for women, half of it for men and children */
    const int32_t sleeve = half->style.option[MUS__AXIS_SLEEVE];
    const bool gathered = sleeve == MUS__SLEEVE_PUFF || sleeve == MUS__SLEEVE_GIGOT;
    out->ease = plan_flat(half) || gathered ? 0.0 : half->measures.sex == MUS_SEX_FEMALE ? 0.03 : 0.015;
    plan_block(half, out);
}


/* ---- sewing in ---- */

/* outline of the sleeve with the fullness of its word */
static void sleeve_cut(const mus__half *half, const mus__sleeve_plan *plan, mus__sleeve_cut *cut)
{
    const double k = mus__measures_scale(&half->measures), *m = half->measures.v;
    const mus__sleeve *block = &plan->block;
    const double front = plan->front_low, back = plan->back_low;
    switch (half->style.option[MUS__AXIS_SLEEVE]) {
    case MUS__SLEEVE_PUFF:
        mus__sleeve_puff(block, front, back, 0.24 * block->width, 4.0 * k * MUS__CM, 1.5 * k * MUS__CM, cut);
        break;
    case MUS__SLEEVE_BISHOP:
        mus__sleeve_fan(block, front, back, fmax(1.8 * block->hem, 1.1 * block->width), 3.0 * k * MUS__CM, cut);
        break;
    case MUS__SLEEVE_BELL: mus__sleeve_fan(block, front, back, 2.0 * block->hem, 0.0, cut); break;
    case MUS__SLEEVE_GIGOT: {
        const double elbow = block->height - 0.58 * m[MUS_MEASURE_ARM];
        mus__sleeve_gigot(block, front, back, fmin(elbow, -3.0 * k * MUS__CM), 0.34 * block->width,
                          9.0 * k * MUS__CM, cut);
        break;
    }
    default: mus__sleeve_plain(block, front, back, cut);
    }
}


/* adds the panel of a sleeve; `parted`: each half of the cap in two edges. cap (MUS__CAP_PARTS) gets the half-edges of
 * the cap, MUS_NONE for low parts that are not there. Returns the panel */
static int32_t sleeve_panel(mus__half *half, const mus__sleeve_cut *cut, bool parted, int32_t *cap)
{
    static const char *const names[MUS__CAP_PARTS] = {"capB_low", "capB", "capF", "capF_low"};
    mus__board *board = &half->board;
    const int32_t panel = mus__board_panel_add(board, "sleeve", "arm");
    mus__chain_side(board, panel, "hem", "cuff", MUS__HEM_ALLOWANCE, &cut->hem);
    const int32_t back = mus__chain_side(board, panel, "underB", NULL, MUS__SEAM_ALLOWANCE, &cut->under_back);
    for (int32_t i = 0; i < MUS__CAP_PARTS; i++) {
        mus__chain chain = cut->cap[i];
        cap[i] = MUS_NONE;
        if (!parted && (i == MUS__CAP_BACK_LOW || i == MUS__CAP_FRONT_LOW)) continue;
        if (!parted && i == MUS__CAP_BACK_HIGH) {
            chain = cut->cap[MUS__CAP_BACK_LOW];
            mus__chain_append(&chain, &cut->cap[i]);
        } else if (!parted) {
            mus__chain_append(&chain, &cut->cap[MUS__CAP_FRONT_LOW]);
        }
        cap[i] = mus__chain_side(board, panel, names[i], NULL, MUS__SEAM_ALLOWANCE, &chain);
    }
    const int32_t front = mus__chain_side(board, panel, "underF", NULL, MUS__SEAM_ALLOWANCE, &cut->under_front);
    mus__board_panel_close(board, panel);
    mus__board_seam_add(board, front, back, MUS_SEAM_REVERSED, 0.0);

    /* biceps line */
    if (board->status == MUS_OK) {
        const double *f = mus__board_start(board, front), *b = mus__board_end(board, back);
        const double line[4] = {f[0], f[1], b[0], b[1]};
        mus__board_mark_add(board, panel, "biceps", 2, line);
    }
    return panel;
}


/* sews the parts of the cap to the armhole, below and above the pitches */
static void sleeve_sew(mus__half *half, mus__sleeve_plan *plan, const int32_t *cap, bool parted)
{
    mus__board *board = &half->board;
    mus__boundary *arm = &plan->arm;
    int32_t shoulder = plan->shoulder;
    if (!parted) {
        mus__board_sew(board, 1, &cap[MUS__CAP_FRONT_HIGH], shoulder, arm->side);
        mus__board_sew(board, 1, &cap[MUS__CAP_BACK_HIGH], arm->n - shoulder, arm->side + shoulder);
        return;
    }
    const double behind = arm->s[arm->n] - plan->back_low;
    const int32_t n = arm->n, front = mus__boundary_split(board, arm, plan->front_low);
    shoulder += arm->n - n;
    const int32_t back = mus__boundary_split(board, arm, behind);
    if (board->status != MUS_OK) return;
    mus__board_sew(board, 1, &cap[MUS__CAP_FRONT_LOW], front, arm->side);
    mus__board_sew(board, 1, &cap[MUS__CAP_FRONT_HIGH], shoulder - front, arm->side + front);
    mus__board_sew(board, 1, &cap[MUS__CAP_BACK_HIGH], back - shoulder, arm->side + shoulder);
    mus__board_sew(board, 1, &cap[MUS__CAP_BACK_LOW], arm->n - back, arm->side + back);
}


/* a set-in sleeve, sewn all round the armhole */
static void sleeve_set_in(mus__half *half, mus__sleeve_plan *plan)
{
    mus__board *board = &half->board;
    const int32_t style = half->style.option[MUS__AXIS_SLEEVE];
    const bool full = style == MUS__SLEEVE_PUFF || style == MUS__SLEEVE_BISHOP || style == MUS__SLEEVE_BELL ||
                      style == MUS__SLEEVE_GIGOT;
    const bool parted = full || plan->ease > 0.0;
    mus__sleeve_cut cut;
    int32_t cap[MUS__CAP_PARTS];
    sleeve_cut(half, plan, &cut);
    const int32_t panel = sleeve_panel(half, &cut, parted, cap);
    if (board->status != MUS_OK) return;
    sleeve_sew(half, plan, cap, parted);

    /* the roll is close enough for the hem to reach more than half round the arm */
    const double arm = half->measures.v[MUS_MEASURE_UPPER_ARM] + 2.0 * MUS__CM;
    const double roll = fmin(cut.width, fmax(arm, 1.5 * mus__chain_length(&cut.hem)));
    mus__panel_place_arm(half, panel, cut.crown[0], cut.crown[1], roll);
    const double *hem = cut.hem.xy;
    if (plan->cuff_depth > 0.0)
        mus__cuff_attach(half, plan->cuff_length, plan->cuff_depth, plan->block.height - hem[1]);
}


/* a cap over the upper part of the armhole; the lower part stays open */
static void sleeve_cap_alone(mus__half *half, mus__sleeve_plan *plan)
{
    mus__board *board = &half->board;
    mus__boundary *arm = &plan->arm;
    mus__sleeve_cut cut;
    double front, back;
    mus__sleeve_short_cap(&plan->block, 0.3, &front, &back, &cut);
    const int32_t panel = mus__board_panel_add(board, "sleeve", "arm");
    mus__chain_side(board, panel, "hem", "armhole", MUS__HEM_ALLOWANCE, &cut.hem);
    const int32_t b =
        mus__chain_side(board, panel, "capB", NULL, MUS__SEAM_ALLOWANCE, &cut.cap[MUS__CAP_BACK_HIGH]);
    const int32_t f =
        mus__chain_side(board, panel, "capF", NULL, MUS__SEAM_ALLOWANCE, &cut.cap[MUS__CAP_FRONT_HIGH]);
    mus__board_panel_close(board, panel);

    const int32_t n = arm->n, first = mus__boundary_split(board, arm, front), shoulder = plan->shoulder + arm->n - n;
    const int32_t last = mus__boundary_split(board, arm, arm->s[arm->n] - back);
    if (board->status != MUS_OK) return;
    mus__board_sew(board, 1, &f, shoulder - first, arm->side + first);
    mus__board_sew(board, 1, &b, last - shoulder, arm->side + shoulder);
    mus__panel_place_arm(half, panel, cut.crown[0], cut.crown[1], cut.width);
}


/* openings of the sleeves: two cuffs, or the armholes, of which a halter has one and a strapless top none */
static void sleeve_openings(mus__half *half)
{
    const int32_t style = half->style.option[MUS__AXIS_SLEEVE], neck = half->style.option[MUS__AXIS_NECK];
    const bool bare = style == MUS__SLEEVE_NONE || style == MUS__SLEEVE_CAP;
    const int32_t n = neck == MUS__NECK_STRAPLESS ? 0 : neck == MUS__NECK_HALTER ? 1 : 2;
    for (int32_t i = 0; i < n; i++) mus__board_opening_add(&half->board, bare ? "armhole" : "cuff");
}


void mus__sleeve_attach(mus__half *half)
{
    mus__board *board = &half->board;
    const int32_t style = half->style.option[MUS__AXIS_SLEEVE];
    sleeve_openings(half);
    if (board->status != MUS_OK || style == MUS__SLEEVE_NONE) return;
    mus__sleeve_plan plan;
    sleeve_plan_read(half, &plan);
    if (board->status != MUS_OK) return;
    switch (style) {
    case MUS__SLEEVE_CAP: sleeve_cap_alone(half, &plan); break;
    case MUS__SLEEVE_RAGLAN: mus__sleeve_raglan(half, &plan); break;
    case MUS__SLEEVE_DOLMAN: mus__sleeve_dolman(half, &plan); break;
    default: sleeve_set_in(half, &plan);
    }
}
