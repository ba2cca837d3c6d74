/*
 * half_shirt.h: the left half of a plain shirt on a cutting table, drawn by hand: front and back with neck, shoulder,
 * armhole, side and hem, sewn at shoulder and side. What sleeves and collars are tested on without the tops.
 */
#ifndef MUS_TESTS_HALF_SHIRT_H
#define MUS_TESTS_HALF_SHIRT_H

#include <string.h>

#include "block/drafts.h"
#include "style/collar.h"
#include "style/sleeve.h"

static inline int32_t half_shirt_line(mus__board *board, int32_t panel, const char *name, const char *label, double ax,
                                      double ay, double bx, double by)
{
    const double a[2] = {ax, ay}, b[2] = {bx, by};
    return mus__board_line_add(board, panel, name, label, a, b);
}


/* the armhole from the underarm to the shoulder, mirrored and reversed for a back */
static inline void half_shirt_armhole(const mus__bodice_half *block, bool front, mus__chain *out)
{
    mus__chain low;
    mus__chain_cubic(out, block->arm_high);
    mus__chain_cubic(&low, block->arm_low);
    mus__chain_append(out, &low);
    mus__chain_reverse(out);
    if (!front) mus__chain_mirror(out);
}


static inline void half_shirt_panel(mus__half *half, bool front, int32_t *shoulder, int32_t *side)
{
    mus__board *board = &half->board;
    const mus__bodice_half *block = front ? &half->bodice.front : &half->bodice.back;
    const double out = front ? 1.0 : -1.0, hem = -0.2, x = out * (block->under[0] + 0.01);
    const double under[2] = {out * block->under[0], block->under[1]}, tip[2] = {out * block->tip[0], block->tip[1]};
    const double snp[2] = {out * block->snp[0], block->snp[1]}, centre = block->centre[1];
    const int32_t panel = mus__board_panel_add(board, front ? "front" : "back", "body");
    mus__chain arm, neck;
    half_shirt_armhole(block, front, &arm);
    mus__chain_cubic(&neck, block->neck);
    mus__chain_reverse(&neck);
    if (!front) mus__chain_mirror(&neck);
    int32_t armhole, middle;
    if (front) {
        half_shirt_line(board, panel, "hem", "hem", 0.0, hem, x, hem);
        *side = half_shirt_line(board, panel, "side", "side", x, hem, under[0], under[1]);
        armhole = mus__chain_side(board, panel, "arm", "armhole", 0.01, &arm);
        *shoulder = half_shirt_line(board, panel, "shoulder", "shoulder", tip[0], tip[1], snp[0], snp[1]);
        mus__chain_side(board, panel, "neck", "neck", 0.01, &neck);
        middle = half_shirt_line(board, panel, "cf", "centre", 0.0, centre, 0.0, hem);
    } else {
        half_shirt_line(board, panel, "hem", "hem", x, hem, 0.0, hem);
        middle = half_shirt_line(board, panel, "cb", "centre", 0.0, hem, 0.0, centre);
        mus__chain_side(board, panel, "neck", "neck", 0.01, &neck);
        *shoulder = half_shirt_line(board, panel, "shoulder", "shoulder", snp[0], snp[1], tip[0], tip[1]);
        armhole = mus__chain_side(board, panel, "arm", "armhole", 0.01, &arm);
        *side = half_shirt_line(board, panel, "side", "side", under[0], under[1], x, hem);
    }
    mus__board_panel_close(board, panel);
    const double low = block->arm_low_length, length = block->arm_length;
    mus__board_notch_add(board, armhole, front ? low : length - low, front ? MUS_NOTCH_SINGLE : MUS_NOTCH_DOUBLE);
    const int32_t closure = half->style.option[MUS__AXIS_CLOSURE];
    const bool seam = closure == (front ? MUS__CLOSURE_FRONT : MUS__CLOSURE_BACK);
    if (board->status == MUS_OK) board->side[middle].centre = seam ? MUS__CENTRE_SEAM : MUS__CENTRE_FOLD;
    mus__panel_place_torso(half, panel, front, fabs(x), half->skeleton.waist);
}


/* of a table size and words; `lower`: the neckline lower and wider. The caller frees half->board */
static inline void half_shirt(mus_context *context, const char *size, const mus__style *style, double lower,
                              mus__half *half)
{
    memset(half, 0, sizeof *half);
    mus_tape *tape = drafts_tape(context, size);
    half->context = context;
    mus__measures_read(tape, &half->measures);
    mus__skeleton_make(tape, &half->skeleton);
    mus_tape_destroy(tape);
    mus_draft_def_init(&half->def, sizeof half->def);
    half->style = *style;
    half->waist_level = half->skeleton.waist;
    mus__bodice_def def;
    mus__bodice_def_init(&def, &half->measures);
    def.darts = false;
    ck_assert_int_eq(mus__bodice_draft(context, &half->measures, &def, &half->bodice), MUS_OK);
    mus__bodice_lower_neck(&half->bodice.front, 0.3 * lower, lower);
    mus__bodice_lower_neck(&half->bodice.back, 0.3 * lower, 0.2 * lower);

    int32_t shoulder[2], side[2];
    mus__board_begin(&half->board, context, "half shirt");
    for (int i = 0; i < 2; i++) half_shirt_panel(half, i == 0, &shoulder[i], &side[i]);
    mus__board_sew(&half->board, 1, &shoulder[0], 1, &shoulder[1]);
    mus__board_sew(&half->board, 1, &side[0], 1, &side[1]);
    ck_assert_msg(half->board.status == MUS_OK, "%s", mus_context_error(context));
}

#endif
