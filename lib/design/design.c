/*
 * design.c: a design drafted: tape to measures and skeleton, eases, the parts that its words ask for (lib/style) on a
 * cutting table as a left half, doubled, written as a pattern, given the panels that are not draped (lib/finish) and
 * checked.
 *
 * The room: words.c and word_rules.c read words to a style; design_table_*.c hold the named designs, design_list.c
 * answers for them; draft_inputs.c checks options and reads the tape; grade.c compares and moves sizes.
 */
#include <math.h>
#include <string.h>

#include "board/board_notch.h"
#include "closure/closure.h"
#include "design/draft.h"
#include "design/words.h"
#include "finish/cut_only.h"
#include "pocket/pocket.h"
#include "style/style_parts.h"

#define NOTCH_NEAR 0.12 /* [m] a long seam has a notch nearer than this to its middle; chosen: two hands of cloth */

/* ease on bust, waist and hip [cm] by cloth and level: for women, and on the bust for men and children. A coat has 18
 * to 22 cm over the body: it goes over a shirt and a jacket */
static void design_eases(mus__half *half)
{
    static const struct {
        double bust, bust_plain, waist, hip;
    } ease[2][5] = {{{6.0, 12.0, 4.0, 4.0}, {4.0, 8.0, 2.0, 3.0}, {12.0, 20.0, 10.0, 10.0}, {22.0, 26.0, 20.0, 20.0},
                     {6.0, 12.0, 4.0, 4.0}},
                    {{8.0, 8.0, 4.0, 4.0}, {0.0, 0.0, 0.0, 0.0}, {16.0, 16.0, 10.0, 10.0}, {22.0, 22.0, 18.0, 18.0},
                     {8.0, 8.0, 4.0, 4.0}}};
    const int32_t *option = half->style.option, garment = option[MUS__AXIS_GARMENT];
    const int32_t cloth = option[MUS__AXIS_CLOTH], level = option[MUS__AXIS_EASE];
    const double *m = half->measures.v, k = mus__measures_scale(&half->measures) * MUS__CM;
    const bool women = half->measures.sex == MUS_SEX_FEMALE;
    half->bust_ease = k * (women ? ease[cloth][level].bust : ease[cloth][level].bust_plain);
    half->waist_ease = k * ease[cloth][level].waist;
    half->hip_ease = k * ease[cloth][level].hip;

    /* what has no shoulders holds by being close; a band too, and it is held up by the hips being wider */
    if (garment <= MUS__GARMENT_JUMPSUIT && option[MUS__AXIS_NECK] == MUS__NECK_STRAPLESS)
        half->bust_ease = fmin(half->bust_ease, k);
    if (garment == MUS__GARMENT_SKIRT || garment == MUS__GARMENT_TROUSERS)
        half->waist_ease = fmin(2.0 * MUS__CM, 0.1 * fmax(0.0, m[MUS_MEASURE_HIP] - m[MUS_MEASURE_WAIST]));
    if (mus__trousers_close(half)) half->hip_ease = (MUS__CLOSE_GIRTH - 1.0) * m[MUS_MEASURE_HIP];

    /* the caller's ease is that of the bust (skirts and trousers: hip); waist and hip keep their distance from it */
    if (isnan(half->def.ease)) return;
    if (garment == MUS__GARMENT_SKIRT || garment == MUS__GARMENT_TROUSERS) {
        half->hip_ease = half->def.ease;
        return;
    }
    half->waist_ease += half->def.ease - half->bust_ease;
    half->hip_ease += half->def.ease - half->bust_ease;
    half->bust_ease = half->def.ease;
}


/* one allowance for both edges of a seam, so that raw edges meet where they are sewn: the narrower of two, that of the
 * other where one has none. What laps over or lies on another keeps its own */
static void design_allowances(mus__board *board)
{
    for (int32_t i = 0; i < board->nseam && board->status == MUS_OK; i++) {
        const mus__board_seam *seam = &board->seam[i];
        if (seam->a == MUS_NONE || seam->laid || seam->closure != MUS_CLOSURE_NONE) continue;
        double *own[2] = {&board->side[seam->a].attr.allowance, &board->side[seam->b].attr.allowance};
        double width[2];
        for (int32_t k = 0; k < 2; k++) width[k] = *own[k] >= 0.0 ? *own[k] : MUS__SEAM_ALLOWANCE;
        const int32_t wide = width[0] > width[1] ? 0 : 1, kept = width[1 - wide] > 0.0 ? 1 - wide : wide;
        *own[1 - kept] = *own[kept];
    }
}


/* a notch at the middle of each long seam that has none near it: single, and double where both sides are of the back */
static void design_notches(mus__board *board)
{
    const int32_t nseam = board->nseam;
    for (int32_t i = 0; i < nseam && board->status == MUS_OK; i++) {
        const mus__board_seam *seam = &board->seam[i];
        if (seam->a == MUS_NONE || seam->laid || seam->bridge || seam->closure != MUS_CLOSURE_NONE) continue;
        const mus__board_side *side = &board->side[seam->a], *other = &board->side[seam->b];
        const bool back = strstr(board->panel[side->panel].name, "back") != NULL &&
                          strstr(board->panel[other->panel].name, "back") != NULL;
        const bool dart = side->next == seam->b || other->next == seam->a;
        if (!dart && fmin(side->length, other->length) > 2.0 * NOTCH_NEAR)
            mus__board_notch_seam(board, seam->a, 0.5 * side->length, back ? MUS_NOTCH_DOUBLE : MUS_NOTCH_SINGLE,
                                  NOTCH_NEAR);
    }
    for (int32_t i = 0; i < board->nside && board->status == MUS_OK; i++) { /* centre seams, not yet doubled */
        const mus__board_side *side = &board->side[i];
        if (side->panel == MUS_NONE || side->centre != MUS__CENTRE_SEAM || side->attr.allowance > MUS__SEAM_ALLOWANCE)
            continue;
        const bool back = strstr(board->panel[side->panel].name, "back") != NULL;
        if (side->length > 2.0 * NOTCH_NEAR)
            mus__board_notch_seam(board, i, 0.5 * side->length, back ? MUS_NOTCH_DOUBLE : MUS_NOTCH_SINGLE, NOTCH_NEAR);
    }
}


/* the parts that the words ask for, from the shoulders down */
static void design_make(mus__half *half)
{
    const int32_t garment = half->style.option[MUS__AXIS_GARMENT];
    const bool skirt = garment == MUS__GARMENT_SKIRT || garment == MUS__GARMENT_DRESS;
    const bool legs = garment == MUS__GARMENT_TROUSERS || garment == MUS__GARMENT_JUMPSUIT;
    const bool waist = garment == MUS__GARMENT_SKIRT || garment == MUS__GARMENT_TROUSERS;
    const bool cape = garment == MUS__GARMENT_CAPE;
    if (cape) mus__cape_draft(half);
    if (!waist && !cape) {
        mus__top_draft(half);
        mus__sleeve_attach(half);
        mus__neck_band_attach(half);
    }
    if (!waist) mus__collar_attach(half);
    if (skirt) mus__skirt_attach(half);
    if (legs) mus__trousers_attach(half);
    if (skirt || legs) mus__band_attach(half);
    mus__pocket_attach(half);
    if (waist) mus__board_opening_add(&half->board, "waist");
    const bool block = mus__style_is(half, MUS__AXIS_EASE, MUS__EASE_BLOCK);
    for (int32_t i = 0; i < (legs ? 2 : 1); i++) mus__board_opening_add(&half->board, block ? "waist" : "hem");
    if (!block) mus__closure_folds(half);
    mus__board_match_notches(&half->board);
    if (!block) design_notches(&half->board);
    mus__board_double(&half->board);
    mus__closure_finish(half);
    if (skirt || legs) mus__waist_close(half);
    mus__pocket_finish(half);
    design_allowances(&half->board);

    /* once more for the notches of the closure; those of the half were matched before, so that both sides are alike */
    mus__board_match_notches(&half->board);
    mus__board_notch_joints(&half->board);
}


mus_status mus__style_draft(mus_context *context, const char *name, const mus__style *style, const mus_tape *tape,
                            const mus_draft_def *def, mus_pattern **out)
{
    mus__half half;
    mus_pattern *pattern = NULL;
    memset(&half, 0, sizeof half);
    half.context = context;
    half.style = *style;
    mus_status status = mus__design_read(context, tape, def, &half.def, &half.measures, &half.skeleton);
    if (status != MUS_OK) return status;
    half.waist_level = half.skeleton.waist;
    design_eases(&half);
    mus__board_begin(&half.board, context, name);
    design_make(&half);
    mus__board_write(&half.board, &pattern);
    status = half.board.status;
    mus__board_free(&half.board);
    if (status == MUS_OK) status = mus__cut_only_make(style, mus__measures_scale(&half.measures), pattern);
    if (status == MUS_OK) status = mus__design_check(context, pattern);
    if (status == MUS_OK) *out = pattern;
    else mus_pattern_destroy(pattern);
    return status;
}


mus_status mus_design_draft_words(mus_context *context, const char *words, const mus_tape *tape,
                                  const mus_draft_def *def, mus_pattern **out)
{
    char name[MUS__NAME_BYTES];
    mus__style style;
    if (out != NULL) *out = NULL;
    if (context == NULL) return MUS_ERR_ARG;
    if (words == NULL || tape == NULL || out == NULL)
        return mus__fail(context, MUS_ERR_ARG, "draft: words, tape or out is NULL");
    const mus_status status = mus__style_read(context, words, &style);
    if (status != MUS_OK) return status;
    mus__style_spell(&style, name, sizeof name);
    return mus__style_draft(context, name, &style, tape, def, out);
}


mus_status mus_design_draft(mus_context *context, int32_t design, const mus_tape *tape, const mus_draft_def *def,
                            mus_pattern **out)
{
    mus__style style;
    if (out != NULL) *out = NULL;
    if (context == NULL) return MUS_ERR_ARG;
    if (tape == NULL || out == NULL) return mus__fail(context, MUS_ERR_ARG, "draft: tape or out is NULL");
    if (design < 0 || design >= mus_design_count())
        return mus__fail(context, MUS_ERR_ARG, "design %d, expected 0 to %d", (int)design,
                         (int)mus_design_count() - 1);
    const mus_status status = mus__style_read(context, mus_design_words(design), &style);
    if (status != MUS_OK) return status;
    return mus__style_draft(context, mus_design_name(design), &style, tape, def, out);
}
