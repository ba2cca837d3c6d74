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


/* a word of a line of words */
typedef struct words_token {
    const char *at;
    size_t n; /* 0 at the end of the line */
} words_token;


static words_token words_next(const char *text)
{
    words_token token = {text + strspn(text, " \t\n"), 0};
    token.n = strcspn(token.at, " \t\n");
    return token;
}


static int words_show(words_token token)
{
    return token.n > 40 ? 40 : (int)token.n;
}


/* the garment: the first word that names one */
static mus_status words_read_garment(mus_context *context, const char *words, mus__style *out, words_token *garment)
{
    char list[256];
    const words_token first = words_next(words);
    for (*garment = first; garment->n > 0; *garment = words_next(garment->at + garment->n)) {
        out->option[MUS__AXIS_GARMENT] = words_find_option(MUS__AXIS_GARMENT, garment->at, garment->n);
        if (out->option[MUS__AXIS_GARMENT] != MUS_NONE) return MUS_OK;
    }
    words_list_options(MUS__AXIS_GARMENT, list, sizeof list);
    return mus__fail(context, MUS_ERR_DESIGN, "words begin with \"%.*s\", expected one of: %s", words_show(first),
                     first.at, list);
}


/* Sets an option of an axis, unless another one was named. */
static mus_status words_set(mus_context *context, int32_t axis, int32_t option, mus__style *out, uint32_t *named)
{
    if ((*named & WORDS_BIT(axis)) != 0 && option != out->option[axis])
        return mus__fail(context, MUS_ERR_DESIGN, "%s=%s and %s=%s, expected one of the two", mus__style_axis(axis),
                         mus__style_word(axis, out->option[axis]), mus__style_axis(axis),
                         mus__style_word(axis, option));
    out->option[axis] = option;
    *named |= WORDS_BIT(axis);
    return MUS_OK;
}


static int32_t words_find_axis(const char *text, size_t n)
{
    for (int32_t a = 1; a < MUS__AXIS_COUNT; a++)
        if (words_same(mus__style_axis(a), text, n)) return a;
    return MUS_NONE;
}


static mus_status words_refuse(mus_context *context, words_token word, int32_t garment)
{
    char list[256];
    words_list_axes(garment, list, sizeof list);
    return mus__fail(context, MUS_ERR_DESIGN, "word \"%.*s\" of a %s, expected one of these, = and an option: %s",
                     words_show(word), word.at, mus__style_word(MUS__AXIS_GARMENT, garment), list);
}


/* "sleeve=puff" */
static mus_status words_read_pair(mus_context *context, words_token word, mus__style *out, uint32_t *named)
{
    char list[256];
    const size_t key = (size_t)((const char *)memchr(word.at, '=', word.n) - word.at);
    const int32_t axis = words_find_axis(word.at, key);
    if (axis == MUS_NONE || !mus__style_has(out->option[0], axis)) return words_refuse(context, word, out->option[0]);
    const int32_t option = words_find_option(axis, word.at + key + 1, word.n - key - 1);
    if (option != MUS_NONE) return words_set(context, axis, option, out, named);
    words_list_options(axis, list, sizeof list);
    return mus__fail(context, MUS_ERR_DESIGN, "word \"%.*s\", expected one of: %s", words_show(word), word.at, list);
}


/* Whether a word, or a word and the next one, are an option as a person writes it: "a-line" and "peter pan" are a_line
 * and peter_pan. Returns the number of words, 0 when they are another option. */
static int32_t words_spoken(const char *option, words_token word, words_token next)
{
    const words_token part[2] = {word, next};
    size_t at = 0;
    for (int32_t p = 0; p < 2; p++) {
        for (size_t i = 0; i < part[p].n; i++, at++) {
            const char c = part[p].at[i] == '-' ? '_' : part[p].at[i];
            if (option[at] != c) return 0;
        }
        if (option[at] == '\0') return p + 1;
        if (option[at++] != '_') return 0;
    }
    return 0;
}


/* An option without its axis: "pencil", "short sleeve", "neck v", "peter pan collar". The axis is that with this
 * option, among several the one whose name stands beside it. *next is the word after those that were read. */
static mus_status words_read_bare(mus_context *context, words_token word, words_token before, words_token *next,
                                  mus__style *out, uint32_t *named)
{
    char list[128] = "";
    int32_t axis = MUS_NONE, option = MUS_NONE, choices = 0, used = 1;
    bool beside = false;
    for (int32_t a = 1; a < MUS__AXIS_COUNT && !beside; a++)
        for (int32_t o = 0; mus__style_has(out->option[0], a) && mus__style_word(a, o) != NULL && !beside; o++) {
            const int32_t n = words_spoken(mus__style_word(a, o), word, *next);
            if (n == 0) continue;
            const words_token after = n == 2 ? words_next(next->at + next->n) : *next;
            beside = words_same(mus__style_axis(a), after.at, after.n) ||
                     words_same(mus__style_axis(a), before.at, before.n);
            axis = a, option = o, used = n, choices++;
            words_append(list, sizeof list, choices > 1 ? " or " : "");
            words_append(list, sizeof list, mus__style_axis(a));
            words_append(list, sizeof list, "=");
            words_append(list, sizeof list, mus__style_word(a, o));
        }
    if (choices == 0) return words_refuse(context, word, out->option[0]);
    if (choices > 1 && !beside)
        return mus__fail(context, MUS_ERR_DESIGN, "word \"%.*s\" of a %s, expected %s", words_show(word), word.at,
                         mus__style_word(MUS__AXIS_GARMENT, out->option[0]), list);
    if (used == 2) *next = words_next(next->at + next->n);
    return words_set(context, axis, option, out, named);
}


mus_status mus__style_read_option(mus_context *context, const char *word, size_t n, int32_t *axis, int32_t *option)
{
    char list[256] = "";
    const char *equals = memchr(word, '=', n);
    const size_t key = equals != NULL ? (size_t)(equals - word) : n;
    const bool garment = words_same(mus__style_axis(MUS__AXIS_GARMENT), word, key);
    *axis = garment ? MUS__AXIS_GARMENT : words_find_axis(word, key);
    *option = *axis != MUS_NONE && key < n ? words_find_option(*axis, equals + 1, n - key - 1) : MUS_NONE;
    if (*option != MUS_NONE) return MUS_OK;
    if (*axis != MUS_NONE) words_list_options(*axis, list, sizeof list);
    for (int32_t a = 0; *axis == MUS_NONE && a < MUS__AXIS_COUNT; a++) {
        words_append(list, sizeof list, a > 0 ? " " : "");
        words_append(list, sizeof list, mus__style_axis(a));
    }
    return mus__fail(context, MUS_ERR_DESIGN, "\"%.*s\", expected %s: %s", n > 40 ? 40 : (int)n, word,
                     *axis != MUS_NONE ? "one of" : "one of these, = and an option", list);
}


/* the i-th choice of an axis that was not named; MUS_NONE after the last. Trousers open in front, all else behind */
static int32_t words_choice(const mus__style *style, int32_t axis, int32_t i)
{
    if (mus__style_word(axis, i) == NULL) return MUS_NONE;
    const bool opens = axis == MUS__AXIS_CLOSURE && (i == MUS__CLOSURE_FRONT || i == MUS__CLOSURE_BACK);
    if (opens && style->option[0] != MUS__GARMENT_TROUSERS) return MUS__CLOSURE_FRONT + MUS__CLOSURE_BACK - i;
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
    uint32_t named = WORDS_BIT(MUS__AXIS_GARMENT), alone = 0; /* axes with an option; axes whose name stands alone */
    mus__style style;
    words_token garment, before = {"", 0}, last = {"", 0};
    memset(&style, 0, sizeof style);
    memset(out, 0, sizeof *out);
    mus_status status = words_read_garment(context, words, &style, &garment);
    for (words_token word = words_next(words); status == MUS_OK && word.n > 0; ) {
        words_token next = words_next(word.at + word.n);
        const int32_t axis = words_find_axis(word.at, word.n);
        if (memchr(word.at, '=', word.n) != NULL) status = words_read_pair(context, word, &style, &named);
        else if (word.at != garment.at && axis != MUS_NONE && mus__style_has(style.option[0], axis))
            alone |= WORDS_BIT(axis), last = word;
        else if (word.at != garment.at)
            status = words_read_bare(context, word, before, &next, &style, &named);
        before = word;
        word = next;
    }
    if (status == MUS_OK && (alone & ~named) != 0) status = words_refuse(context, last, style.option[0]);
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
