/*
 * halves.h: what the tests of half garments share: a half of a table size and some words, and the whole of it.
 */
#ifndef MUS_TESTS_HALVES_H
#define MUS_TESTS_HALVES_H

#include <string.h>

#include "block/drafts.h"
#include "design/draft.h"
#include "design/words.h"
#include "style/bodice.h"

/* the eases of the house: less for a knit and a slim one, more for a loose one */
static inline void halves_begin(mus_context *context, const mus_tape *tape, const mus__style *style, mus__half *half)
{
    memset(half, 0, sizeof *half);
    half->context = context;
    mus__measures_read(tape, &half->measures);
    mus__skeleton_make(tape, &half->skeleton);
    mus_draft_def_init(&half->def, sizeof half->def);
    half->style = *style;
    const double k = mus__measures_scale(&half->measures);
    const bool boxy = style->option[MUS__AXIS_SHAPE] == MUS__SHAPE_BOXY;
    half->bust_ease = (boxy ? 8.0 : half->measures.sex == MUS_SEX_FEMALE ? 6.0 : 12.0) * k * CM;
    half->waist_ease = half->hip_ease = 4.0 * k * CM;
    mus__board_begin(&half->board, context, "half");
}


/* the openings that a top without sleeves has */
static inline void halves_openings(mus__half *half)
{
    const bool halter = half->style.option[MUS__AXIS_NECK] == MUS__NECK_HALTER;
    const bool strapless = half->style.option[MUS__AXIS_NECK] == MUS__NECK_STRAPLESS;
    const bool top = half->style.option[MUS__AXIS_GARMENT] == MUS__GARMENT_TOP;
    mus__board_opening_add(&half->board, top ? "hem" : "waist");
    mus__board_opening_add(&half->board, "neck");
    for (int i = strapless ? 2 : halter ? 1 : 0; i < 2; i++) mus__board_opening_add(&half->board, "armhole");
}

#endif
