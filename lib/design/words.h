/*
 * words.h: words to a style and back, and the rules of which words go together.
 */
#ifndef MUS_WORDS_H
#define MUS_WORDS_H

#include "base/base_internal.h"
#include "half/style.h"

/* "dress neck=v sleeve=puff": the first word is the garment. An axis that is not named takes its first option, but for
 * closure, shape and neck, which take the first that goes with what is named (a knit top asks for boxy first). Axes
 * that the garment does not have are 0. Errors: MUS_ERR_DESIGN (unknown word: the options are named; two words that
 * exclude one another: both named, and why) */
mus_status mus__style_read(mus_context *context, const char *words, mus__style *out);
/* MUS_OK, or MUS_ERR_DESIGN with the two words that exclude one another, and why */
mus_status mus__style_check(mus_context *context, const mus__style *style);
/* index of a rule that the style breaks, looking at the axes in the bits of `axes` alone; MUS_NONE if there is none */
int32_t mus__style_broken(const mus__style *style, uint32_t axes);
/* the rule as the context's error; MUS_OK for MUS_NONE */
mus_status mus__style_explain(mus_context *context, const mus__style *style, int32_t rule);
/* all that is not an axis' first option, in words; cut off at `size` bytes with the end */
void mus__style_spell(const mus__style *style, char *text, size_t size);

#endif
