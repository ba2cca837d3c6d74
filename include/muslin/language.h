/*
 * muslin/language.h: the words that a sewer reads, in several languages: titles of designs, names of measures, panels
 * and edges, what stands on paper, and the sentences of the instructions.
 *
 * A language is a small number; 0 is English. Rows have a key that does not change ("measure.waist", "step.darts").
 */
#ifndef MUSLIN_LANGUAGE_H
#define MUSLIN_LANGUAGE_H

#include "muslin/base.h"

#ifdef __cplusplus
extern "C" {
#endif

#define MUS_LANGUAGE_ENGLISH 0

/** Number of languages: English, German, French, Spanish, Portuguese, Japanese, Arabic, Thai. */
MUS_API int32_t mus_language_count(void);

/** Tag of a language ("de", BCP 47); NULL for an unknown number. Static text. */
MUS_API const char *mus_language_tag(int32_t language);

/** What its speakers call a language ("Deutsch"); NULL for an unknown number. Static text. */
MUS_API const char *mus_language_name(int32_t language);

/** Nonzero for a language that is written from right to left. */
MUS_API int32_t mus_language_is_right_to_left(int32_t language);

/** Number of a language by a tag: of BCP 47 ("pt-BR") or POSIX ("pt_BR.UTF-8"), of which the first part decides; NULL,
 * "", "C" and "POSIX" are English. MUS_NONE for a language that is not in the table. */
MUS_API int32_t mus_language_find(const char *tag);

/** Number of rows of the table. */
MUS_API int32_t mus_language_row_count(void);

/** Key of row `row` ("measure.waist"), in the order of strcmp(); NULL for an unknown row. Static text. */
MUS_API const char *mus_language_row_key(int32_t row);

/** Text of the row with the key, UTF-8; {0}, {1} ... stand where a number or a word goes. English where the language
 * lacks the row; NULL for an unknown key or language. Static text. */
MUS_API const char *mus_language_text(int32_t language, const char *key);

/**
 * Write a title or a name in a language, made of the words that the table has.
 *
 * Kind "title": an English title of a design, part by part between commas ("Blouse, V neck, short sleeves"). Kinds
 * "panel" and "edge": a name of a panel or an edge, or its words ("sleeve_left", "front armhole facing"); a side and a
 * number come where the language has them, and a name that is no row is made of its parts. Kind "measure": the name of
 * a measure. English is left as it is, but for "_", which becomes a blank.
 * Returns: nonzero when the table has all of it; 0: what it lacks is written in English (or a pointer is NULL)
 * Shapes:  text (size) with its zero byte; what is longer is cut between letters
 */
MUS_API int32_t mus_language_compose(int32_t language, const char *kind, const char *words, char *text, size_t size);

#ifdef __cplusplus
}
#endif

#endif
