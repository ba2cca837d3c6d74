/*
 * words.h: words to a style and back, and the rules of which words go together.
 */
#ifndef MUS_WORDS_H
#define MUS_WORDS_H

#include "base/base_internal.h"
#include "half/style_axes.h"

/* Reads words such as "dress neck=v sleeve=puff": a garment, and options with their axes, or as they are spoken:
 * "pencil skirt", "v neck", "short sleeve", where an option of several axes needs the name of one beside it. An axis
 * that is not named takes its first option, except closure, shape and neck, which take the first option that goes with
 * the named words (a knit top tries boxy first). Axes that the garment does not have are 0. Errors: MUS_ERR_DESIGN
 * (unknown word: the options are named; two words that exclude one another: both named, and why) */
mus_status mus__style_read(mus_context *context, const char *words, mus__style *out);
/* Reads the n bytes of "length=knee": an axis of any garment and its option. Errors: MUS_ERR_DESIGN (the axes, or the
 * options of the axis are named) */
mus_status mus__style_read_option(mus_context *context, const char *word, size_t n, int32_t *axis, int32_t *option);
/* MUS_OK, or MUS_ERR_DESIGN with the two words that exclude one another, and why */
mus_status mus__style_check(mus_context *context, const mus__style *style);
/* Index of the first rule on the axes in the bits of `axes` that the style breaks; MUS_NONE: it breaks none. */
int32_t mus__style_broken(const mus__style *style, uint32_t axes);
/* Sets the reason of a rule as the error of the context and returns MUS_ERR_DESIGN; MUS_OK for MUS_NONE. */
mus_status mus__style_explain(mus_context *context, const mus__style *style, int32_t rule);
/* Spells the options that are not the first of their axis, and those of neck, shape and closure; at most `size` bytes
 * with the end. */
void mus__style_spell(const mus__style *style, char *text, size_t size);

#endif
