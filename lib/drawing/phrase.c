/*
 * phrase.c: rows of the table of words with their places filled.
 */
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "drawing/phrase.h"


mus_status mus__language_read(mus_context *context, const char *tag, const char *what, int32_t *out)
{
    char list[128] = "";
    *out = mus_language_find(tag);
    if (*out != MUS_NONE) return MUS_OK;
    *out = MUS_LANGUAGE_ENGLISH;
    for (int32_t i = 0; i < mus_language_count(); i++) {
        const size_t n = strlen(list);
        snprintf(list + n, sizeof list - n, "%s%s", i > 0 ? ", " : "", mus_language_tag(i));
    }
    return mus__file_fail(context, MUS_ERR_ARG, "%s: language \"%.40s\" is unknown; expected one of %s", what, tag,
                          list);
}


mus__phrase mus__phrase_in(int32_t language)
{
    mus__phrase phrase = {.language = language};
    return phrase;
}


void mus__phrase_text(mus__phrase *phrase, int32_t place, const char *text)
{
    phrase->texts[place] = text;
}


void mus__phrase_number(mus__phrase *phrase, int32_t place, long number)
{
    phrase->texts[place] = NULL;
    snprintf(phrase->numbers[place], sizeof phrase->numbers[place], "%ld", number);
}


/* the next part of a row: a text between places, or what goes into a place. Returns its bytes, 0 at the end */
static size_t phrase_next(const mus__phrase *phrase, const char **row, const char **part)
{
    const char *at = *row;
    if (at[0] == '{' && at[1] >= '0' && at[1] < '0' + MUS__PHRASE_MOST && at[2] == '}') {
        const int32_t place = at[1] - '0';
        *row = at + 3;
        *part = phrase->texts[place] != NULL ? phrase->texts[place] : phrase->numbers[place];
        /* an empty text is passed over */
        return **part != '\0' ? strlen(*part) : phrase_next(phrase, row, part);
    }
    *part = at;
    const size_t n = *at != '\0' ? 1 + strcspn(at + 1, "{") : 0;
    *row = at + n;
    return n;
}


static const char *phrase_row(const mus__phrase *phrase, const char *key)
{
    const char *row = mus_language_text(phrase->language, key);
    return row != NULL ? row : key;
}


void mus__phrase_write(const mus__phrase *phrase, const char *key, char *out, size_t size)
{
    const char *row = phrase_row(phrase, key), *part;
    size_t at = 0;
    bool whole = true;
    for (size_t n; whole && (n = phrase_next(phrase, &row, &part)) > 0; at += n) {
        whole = n < size - at;
        if (!whole) n = size - at - 1;
        while (!whole && n > 0 && ((unsigned char)part[n] & 0xC0) == 0x80) n--;
        memcpy(out + at, part, n);
    }
    out[at] = '\0';
}


void mus__phrase_add(const mus__phrase *phrase, const char *key, mus__sink *sink)
{
    const char *row = phrase_row(phrase, key), *part;
    for (size_t n; (n = phrase_next(phrase, &row, &part)) > 0;) mus__sink_add(sink, part, n);
}


void mus__phrase_count(mus__phrase *phrase, const char *key, long count, char *out, size_t size)
{
    char full[64];
    snprintf(full, sizeof full, "%s.%s", key, count == 1 ? "one" : "many");
    mus__phrase_number(phrase, 0, count);
    mus__phrase_write(phrase, full, out, size);
}
