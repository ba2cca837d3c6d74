/*
 * words.c: reads a line of words to a style and spells a style in words. Which words go together: word_rules.c.
 */
#include <stdio.h>
#include <string.h>

#include "design/words.h"

#define WORDS_BIT(x) (UINT32_C(1) << (x))


/* ---- texts ---- */


static void words_append(char *text, size_t size, const char *more)
{
    const size_t n = strlen(text);
    if (n + 1 < size) snprintf(text + n, size - n, "%s", more);
}


void mus__style_spell(const mus__style *style, char *text, size_t size)
{
    const int32_t garment = style->option[MUS__AXIS_GARMENT];
    if (size == 0) return;
    text[0] = '\0';
    words_append(text, size, mus__style_word(MUS__AXIS_GARMENT, garment));
    for (int32_t a = 1; a < MUS__AXIS_COUNT; a++) {
        /* axes whose option reading chooses are always spelled */
        const bool chosen = a == MUS__AXIS_NECK || a == MUS__AXIS_SHAPE || a == MUS__AXIS_CLOSURE;
        if (!mus__style_has(garment, a) || (style->option[a] == 0 && !chosen)) continue;
        words_append(text, size, " ");
        words_append(text, size, mus__style_axis(a));
        words_append(text, size, "=");
        words_append(text, size, mus__style_word(a, style->option[a]));
    }
}


/* ---- reading ---- */

static bool words_same(const char *word, const char *text, size_t n)
{
    return strlen(word) == n && memcmp(word, text, n) == 0;
}


/* the options of an axis, or the axes of a garment, for a message */
static void words_list_options(int32_t axis, char *text, size_t size)
{
    text[0] = '\0';
    for (int32_t i = 0; mus__style_word(axis, i) != NULL; i++) {
        if (i > 0) words_append(text, size, " ");
        words_append(text, size, mus__style_word(axis, i));
    }
}


static void words_list_axes(int32_t garment, char *text, size_t size)
{
    text[0] = '\0';
    for (int32_t a = 1; a < MUS__AXIS_COUNT; a++) {
        if (!mus__style_has(garment, a)) continue;
        if (text[0] != '\0') words_append(text, size, " ");
        words_append(text, size, mus__style_axis(a));
    }
}


static int32_t words_find_option(int32_t axis, const char *text, size_t n)
{
    for (int32_t i = 0; mus__style_word(axis, i) != NULL; i++)
        if (words_same(mus__style_word(axis, i), text, n)) return i;
    return MUS_NONE;
}


/* the garment, the first word */
static mus_status words_read_garment(mus_context *context, const char *word, size_t n, mus__style *out)
{
    char list[256];
    out->option[MUS__AXIS_GARMENT] = words_find_option(MUS__AXIS_GARMENT, word, n);
    if (out->option[MUS__AXIS_GARMENT] != MUS_NONE) return MUS_OK;
    words_list_options(MUS__AXIS_GARMENT, list, sizeof list);
    return mus__fail(context, MUS_ERR_DESIGN, "words begin with \"%.*s\", expected one of: %s", n > 40 ? 40 : (int)n,
                     word, list);
}


/* one word of the rest, "sleeve=puff" */
static mus_status words_read_word(mus_context *context, const char *word, size_t n, mus__style *out, uint32_t *named)
{
    char list[256];
    const char *equals = memchr(word, '=', n), *garment = mus__style_word(MUS__AXIS_GARMENT, out->option[0]);
    const size_t key = equals != NULL ? (size_t)(equals - word) : n;
    const int show = n > 40 ? 40 : (int)n;
    int32_t axis = 1;
    while (axis < MUS__AXIS_COUNT && !words_same(mus__style_axis(axis), word, key)) axis++;
    if (equals == NULL || axis == MUS__AXIS_COUNT || !mus__style_has(out->option[0], axis)) {
        words_list_axes(out->option[0], list, sizeof list);
        return mus__fail(context, MUS_ERR_DESIGN, "word \"%.*s\" of a %s, expected one of these, = and an option: %s",
                         show, word, garment, list);
    }
    const int32_t option = words_find_option(axis, equals + 1, n - key - 1);
    if (option == MUS_NONE) {
        words_list_options(axis, list, sizeof list);
        return mus__fail(context, MUS_ERR_DESIGN, "word \"%.*s\", expected one of: %s", show, word, list);
    }
    if ((*named & WORDS_BIT(axis)) != 0 && option != out->option[axis])
        return mus__fail(context, MUS_ERR_DESIGN, "%s=%s and %s=%s, expected one of the two", mus__style_axis(axis),
                         mus__style_word(axis, out->option[axis]), mus__style_axis(axis),
                         mus__style_word(axis, option));
    out->option[axis] = option;
    *named |= WORDS_BIT(axis);
    return MUS_OK;
}


/* the i-th choice of an axis that was not named; MUS_NONE after the last */
static int32_t words_choice(const mus__style *style, int32_t axis, int32_t i)
{
    static const int32_t closures[2][5] = {
        {MUS__CLOSURE_NONE, MUS__CLOSURE_BACK, MUS__CLOSURE_FRONT, MUS__CLOSURE_SIDE,
         MUS__CLOSURE_SEAMS},
        {MUS__CLOSURE_NONE, MUS__CLOSURE_FRONT, MUS__CLOSURE_BACK, MUS__CLOSURE_SIDE,
         MUS__CLOSURE_SEAMS},
    };
    if (mus__style_word(axis, i) == NULL) return MUS_NONE;
    if (axis == MUS__AXIS_CLOSURE) return closures[style->option[0] == MUS__GARMENT_TROUSERS][i];
    if (axis != MUS__AXIS_SHAPE || style->option[MUS__AXIS_CLOTH] != MUS__CLOTH_KNIT) return i;
    return i == 0 ? MUS__SHAPE_BOXY : i - 1; /* boxy is the last option */
}


/* chooses neck, shape and closure, unless they were named: the first options that break no rule; false if there are
 * none */
static bool words_choose(mus__style *style, uint32_t named)
{
    static const int32_t axes[3] = {MUS__AXIS_NECK, MUS__AXIS_SHAPE, MUS__AXIS_CLOSURE};
    const mus__style given = *style;
    int32_t n[3], i[3];
    for (int32_t k = 0; k < 3; k++) {
        const bool is_free = mus__style_has(given.option[0], axes[k]) && (named & WORDS_BIT(axes[k])) == 0;
        for (n[k] = 0; is_free && words_choice(&given, axes[k], n[k]) != MUS_NONE; n[k]++) continue;
        if (!is_free) n[k] = 1;
    }
    for (i[0] = 0; i[0] < n[0]; i[0]++)
        for (i[1] = 0; i[1] < n[1]; i[1]++)
            for (i[2] = 0; i[2] < n[2]; i[2]++) {
                for (int32_t k = 0; k < 3; k++)
                    style->option[axes[k]] =
                        n[k] == 1 ? given.option[axes[k]] : words_choice(&given, axes[k], i[k]);
                if (mus__style_broken(style, UINT32_MAX) == MUS_NONE) return true;
            }
    *style = given;
    return false;
}


mus_status mus__style_read(mus_context *context, const char *words, mus__style *out)
{
    uint32_t named = 0;
    mus_status status = MUS_OK;
    mus__style style;
    memset(&style, 0, sizeof style);
    memset(out, 0, sizeof *out);
    for (const char *word = words; status == MUS_OK; ) {
        word += strspn(word, " \t\n");
        const size_t n = strcspn(word, " \t\n");
        if (n == 0 && named != 0) break;
        if (named == 0) status = words_read_garment(context, word, n, &style);
        else status = words_read_word(context, word, n, &style, &named);
        named |= WORDS_BIT(MUS__AXIS_GARMENT);
        word += n;
    }
    if (status != MUS_OK) return status;

    /* check the named words among themselves, then choose the options that were left out */
    status = mus__style_explain(context, &style, mus__style_broken(&style, named));
    if (status == MUS_OK && !words_choose(&style, named)) status = mus__style_check(context, &style);
    if (status == MUS_OK) *out = style;
    return status;
}


mus_status mus__style_check(mus_context *context, const mus__style *style)
{
    return mus__style_explain(context, style, mus__style_broken(style, UINT32_MAX));
}
