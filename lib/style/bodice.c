/*
 * bodice.c: the body of a top, dress or jumpsuit as a half garment: bodice block, neckline, shaping, closure, sewn.
 *
 * The bodice block of the person (darted for women, and for men where a woven top is shaped) is drawn down to the hem
 * with the neckline of the style; the bust dart opens at the side and is then moved, split, eased or turned into a
 * seam (shaping.c). Below the waist the side curves to the hip, or runs straight in a boxy top. Front and back sides
 * are congruent when the darts are closed, so side seams match by construction. Formulas: man page mus_design(3).
 */
#include <math.h>
#include <string.h>

#include "base/elementary.h"
#include "closure/closure.h"
#include "geom/curve.h"
#include "geom/vec.h"
#include "style/bodice.h"

/* [m] extra length of the bodice of a jumpsuit, which ties crotch and shoulder; chosen: room for bending and sitting */
#define TORSO_BLOUSE (2.5 * MUS__CM)


/* ---- blocks ---- */

/* Adapts the shoulder in `measures`: its seam ends at the shoulder point, where the arm turns down, but is at most 0.15
 * shorter than measured. The shoulder line of a loose top, or of one without sleeves, is 0.08 rad (4.6 degrees) flatter
 * than the tape's; chosen: a steeper one lifts off where the arms stand off the body. */
static void torso_shoulder(const mus__half *half, bool loose, mus__measures *measures)
{
    double *m = measures->v;
    if (loose) m[MUS_MEASURE_SHOULDER_SLOPE] -= 0.08;
    const double neck = m[MUS_MEASURE_NECK] / 6.0 + 0.85 * MUS__CM, along = mus__cos(m[MUS_MEASURE_SHOULDER_SLOPE]);
    const double reach = (half->skeleton.shoulder_x - neck) / along;
    m[MUS_MEASURE_SHOULDER] = fmax(0.85 * m[MUS_MEASURE_SHOULDER], fmin(m[MUS_MEASURE_SHOULDER], reach));
}


/* y of the lower edge [m]: 0 for a dress, a jumpsuit or a block, else the length given by the caller or by the word */
static double torso_hem(const mus__half *half, double scale)
{
    const double hip = half->measures.v[MUS_MEASURE_WAIST_TO_HIP], rib = mus__hem_rib_above(half, scale);
    if (!mus__top_hem(half)) return 0.0;
    if (!isnan(half->def.length)) return fmin(rib - half->def.length, 0.5 * half->bodice.underarm);
    switch (half->style.option[MUS__AXIS_TOP_LENGTH]) {
    case MUS__TOP_LENGTH_CROP: return fmin(4.0 * scale * MUS__CM + rib, 0.25 * half->bodice.underarm);
    case MUS__TOP_LENGTH_WAIST: return fmin(rib, 0.25 * half->bodice.underarm);
    case MUS__TOP_LENGTH_TUNIC: return rib - (hip + 20.0 * scale * MUS__CM);
    default: return rib - (hip + 6.0 * scale * MUS__CM);
    }
}


/* drafts the bodice block with the eases of the style; darted for women, except for boxy knits, and for men where a
 * woven top is shaped: cloth that must not stretch stands away from the chest below it else */
static void torso_blocks(mus__half *half, mus__top *top)
{
    mus__measures measures = half->measures;
    mus__bodice_def def;
    const double k = mus__measures_scale(&measures);
    const bool boxy = mus__style_is(half, MUS__AXIS_SHAPE, MUS__SHAPE_BOXY);
    const bool bare = mus__style_is(half, MUS__AXIS_SLEEVE, MUS__SLEEVE_NONE);
    const bool block = mus__style_is(half, MUS__AXIS_EASE, MUS__EASE_BLOCK);
    mus__bodice_def_init(&def, &measures);
    if (!block) torso_shoulder(half, boxy || bare, &measures);
    if (mus__style_is(half, MUS__AXIS_GARMENT, MUS__GARMENT_JUMPSUIT)) {
        measures.v[MUS_MEASURE_BACK_WAIST] += TORSO_BLOUSE * k;
        measures.v[MUS_MEASURE_FRONT_WAIST] += TORSO_BLOUSE * k;
    }
    def.bust_ease = half->bust_ease;
    def.waist_ease = half->waist_ease;
    if (boxy) {
        def.scye_ease = 1.5 * k * MUS__CM;
        def.balance = 0.4 * MUS__CM;
        def.darts = def.darts && mus__style_is(half, MUS__AXIS_CLOTH, MUS__CLOTH_WOVEN);
    } else if (bare && !block) {
        def.scye_ease -= 1.0 * k * MUS__CM;
    }
    if (measures.sex == MUS_SEX_MALE && k >= 1.0 && mus__style_is(half, MUS__AXIS_GARMENT, MUS__GARMENT_TOP))
        def.darts = !boxy && !block && mus__style_is(half, MUS__AXIS_CLOTH, MUS__CLOTH_WOVEN);
    if (mus__style_is(half, MUS__AXIS_EASE, MUS__EASE_COAT)) {
        def.scye_ease += 2.0 * k * MUS__CM;
        def.neck_ease += 3.0 * k * MUS__CM;
    }
    if (mus__style_is(half, MUS__AXIS_NECK, MUS__NECK_STRAPLESS)) def.bust_ease = fmin(def.bust_ease, 1.0 * MUS__CM);
    const mus_status status = mus__bodice_draft(half->context, &measures, &def, &half->bodice);
    if (status != MUS_OK) half->board.status = status;

    top->scale = k;
    top->darts = def.darts && !boxy;
    top->hem = torso_hem(half, k);
    half->waist_level = half->skeleton.waist;
}


/* shaping of the side seam at waist and hip. The side of a top without darts is taken in by 0.35 of the difference of
 * bust and waist, that of a dress or jumpsuit by all of it, but with a slope of at most 0.18; the rest is waist ease */
static void torso_sides(mus__half *half, mus__top *top)
{
    const mus__bodice *bodice = &half->bodice;
    const double *m = half->measures.v;
    const bool boxy = mus__style_is(half, MUS__AXIS_SHAPE, MUS__SHAPE_BOXY);
    const bool top_alone = mus__style_is(half, MUS__AXIS_GARMENT, MUS__GARMENT_TOP);
    const double girth = 2.0 * (bodice->front.side[0] + bodice->back.side[0] + 2.0 * bodice->side_in);
    const double t = (girth - m[MUS_MEASURE_WAIST] - half->waist_ease) / 4.0;

    top->side_in = bodice->side_in;
    if (boxy) {
        top->side_in = 0.0;
    } else if (!top->darts && !mus__style_is(half, MUS__AXIS_EASE, MUS__EASE_BLOCK)) {
        top->side_in = top_alone ? fmax(0.0, fmin(0.35 * t, 2.5 * MUS__CM)) : fmin(t, 0.18 * bodice->underarm);
    }

    /* hip level; a boxy hem clears the hip, in proportion above it */
    top->hip = -m[MUS_MEASURE_WAIST_TO_HIP];
    const double hip = (m[MUS_MEASURE_HIP] + half->hip_ease - girth) / 4.0;
    top->hip_out = fmax(0.0, hip + top->side_in);
    if (boxy) top->hip_out = fmax(0.0, fmin(1.0, -top->hem / m[MUS_MEASURE_WAIST_TO_HIP])) * fmax(0.0, hip);
}


/* ---- edges ---- */


/* sews the darts that were drawn */
static void torso_sew_darts(mus__half *half, int32_t panel)
{
    static const char *const legs[][2] = {{"wd1", "wd2"}, {"wd3", "wd4"}, {"bd1", "bd2"}};
    for (int i = 0; i < 3; i++) {
        const int32_t a = mus__board_find(&half->board, panel, legs[i][0]);
        const int32_t b = mus__board_find(&half->board, panel, legs[i][1]);
        if (a != MUS_NONE && b != MUS_NONE) mus__board_seam_add(&half->board, a, b, MUS_SEAM_REVERSED, 0.0);
    }
}


static void torso_draw(mus__half *half, mus__top *top, int32_t which)
{
    const bool front = which == MUS__TOP_FRONT;
    mus__outline outline, side, waist;
    mus__chain chain;

    /* centre down, hem out, side up */
    mus__outline_begin(&outline);
    mus__outline_begin(&side);
    mus__top_side(half, top, front, &side);
    const mus__chain *neck = &top->neck[which], *low = &side.edge[0].chain;
    const double *head = neck->xy + 2 * (neck->nxy - 1), foot[2] = {0.0, top->hem};
    mus__outline_begin(&waist);
    mus__top_low(half, top, which, low->xy, &waist);
    if (front && mus__wraps(half))
        mus__wrap_outline(half, mus__outline_length(&waist, "waist"), low, &top->neck[which], &outline);
    else
        mus__outline_line(&outline, front ? "cf" : "cb", "centre", MUS__SEAM_ALLOWANCE, head, foot);
    mus__outline_append(&outline, &waist);
    mus__outline_append(&outline, &side);

    /* armhole, shoulder, neck */
    if (top->arm[which].npiece > 0)
        mus__outline_add(&outline, "arm", "armhole", MUS__SEAM_ALLOWANCE, &top->arm[which]);
    if (top->shoulder[which]) {
        mus__chain_line(&chain, top->arm[which].xy + 2 * (top->arm[which].nxy - 1), neck->xy);
        mus__outline_add(&outline, "sh", "shoulder", MUS__SEAM_ALLOWANCE, &chain);
    }
    mus__outline_add(&outline, "neck", top->neck_label[which], MUS__TOP_NECK_SEAM, neck);

    top->panel[which] = mus__outline_panel(half, &outline, front ? "front" : "back", "body", !front);
    torso_sew_darts(half, top->panel[which]);
    const int32_t arm = mus__board_find(&half->board, top->panel[which], "arm");
    const mus__bodice_half *block = front ? &half->bodice.front : &half->bodice.back;
    const double pitch = front ? block->arm_low_length : block->arm_length - block->arm_low_length;
    if (arm != MUS_NONE && top->shoulder[MUS__TOP_BACK])
        mus__board_notch_add(&half->board, arm, pitch, front ? MUS_NOTCH_SINGLE : MUS_NOTCH_DOUBLE);
}


/* sews the runs of one label of fronts and backs */
static void torso_sew(mus__half *half, const char *label)
{
    int32_t front[MUS__TOP_RUN], back[MUS__TOP_RUN];
    const int32_t nfront = mus__half_boundary(half, "front", label, front, MUS__TOP_RUN);
    const int32_t nback = mus__half_boundary(half, "back", label, back, MUS__TOP_RUN);
    if (nfront > 0 && nback > 0) mus__board_sew(&half->board, nfront, front, nback, back);
}


static void torso_place(mus__half *half, const mus__top *top)
{
    const double width = half->bodice.front.under[0] + top->hip_out;
    for (int32_t p = 0; p < half->board.npanel; p++) {
        const mus__board_panel *panel = &half->board.panel[p];
        if (panel->first == MUS_NONE) continue;
        if (strncmp(panel->name, "front", 5) == 0) mus__panel_place_torso(half, p, true, width, half->waist_level);
        if (strncmp(panel->name, "back", 4) == 0) mus__panel_place_torso(half, p, false, width, half->waist_level);
    }
}


/* sets the waist ease to that of the waist line as drawn, which is wider without darts or with flare */
static void torso_waist(mus__half *half)
{
    int32_t sides[MUS__TOP_RUN];
    const int32_t n = mus__half_boundary(half, "", "waist", sides, MUS__TOP_RUN);
    if (half->board.status != MUS_OK || n < 1 || n > MUS__TOP_RUN) return;
    double length = 0.0;
    for (int32_t i = 0; i < n; i++) length += half->board.side[sides[i]].length;
    half->waist_ease = 2.0 * length - half->measures.v[MUS_MEASURE_WAIST];
}


void mus__top_draft(mus__half *half)
{
    mus__top top;
    memset(&top, 0, sizeof top);
    if (half->board.status != MUS_OK) return;
    torso_blocks(half, &top);
    if (half->board.status != MUS_OK) return;
    torso_sides(half, &top);
    mus__neckline_draw(half, &top);
    if (half->board.status != MUS_OK) return;
    mus__shaping_plan(half, &top);
    for (int32_t which = 0; which < 2; which++) torso_draw(half, &top, which);
    mus__shaping_work(half, &top);
    if (mus__style_is(half, MUS__AXIS_YOKE, MUS__YOKE_YOKE)) mus__shaping_yoke(half, &top);
    mus__closure_set(half);
    torso_sew(half, "shoulder");
    torso_sew(half, "side");
    if (mus__wraps(half)) mus__wrap_hold(half, top.panel[MUS__TOP_FRONT]);
    if (!top.shoulder[MUS__TOP_BACK] && top.shoulder[MUS__TOP_FRONT]) mus__neckline_strap(half);
    mus__neckline_hold(half);
    torso_place(half, &top);
    mus__hem_rib_attach(half, &top);
    torso_waist(half);

    /* a step that finds no room reports an argument out of range: the design is infeasible */
    if (half->board.status == MUS_ERR_ARG) half->board.status = MUS_ERR_DESIGN;
}
