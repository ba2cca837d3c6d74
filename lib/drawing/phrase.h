/*
 * phrase.h: rows of the table of words with their places filled.
 */
#ifndef MUS_DRAWING_PHRASE_H
#define MUS_DRAWING_PHRASE_H

#include "file/sink.h"
#include "muslin/language.h"

/* what goes into the places {0}, {1} ... of a row: texts, NULL for a number that is written with its digits */
#define MUS__PHRASE_MOST 5 /* most places of a row: a sentence has {0} to {3}, and {4} for the length of a rib */

typedef struct mus__phrase {
    int32_t language;
    const char *texts[MUS__PHRASE_MOST];
    char numbers[MUS__PHRASE_MOST][24];
} mus__phrase;

/* read the tag of a language; MUS_ERR_ARG, with the public call `what` and the list of tags, for an unknown one */
mus_status mus__language_read(mus_context *context, const char *tag, const char *what, int32_t *out);

/* begin a phrase without texts */
mus__phrase mus__phrase_in(int32_t language);
/* set what goes into a place; `text` is kept as it is until the phrase is written */
void mus__phrase_text(mus__phrase *phrase, int32_t place, const char *text);
void mus__phrase_number(mus__phrase *phrase, int32_t place, long number);
/* write the row of a key, with its places filled, to `out` (size), cut between letters where it is longer */
void mus__phrase_write(const mus__phrase *phrase, const char *key, char *out, size_t size);
/* add the row of a key, with its places filled, to a sink */
void mus__phrase_add(const mus__phrase *phrase, const char *key, mus__sink *sink);
/* write "KEY.one" when the count is 1, else "KEY.many"; place 0 gets the count */
void mus__phrase_count(mus__phrase *phrase, const char *key, long count, char *out, size_t size);

#endif
