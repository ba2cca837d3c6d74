/*
 * search_text.h: words of a phrase that a person types, compared with words of the catalogue.
 */
#ifndef MUS_SEARCH_TEXT_H
#define MUS_SEARCH_TEXT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define MUS__WORD_BYTES 24   /* longest word of a phrase with its end; the rest of a longer one is cut off */
#define MUS__PHRASE_WORDS 24 /* most words of a phrase; the rest is left out */

typedef struct mus__phrase {
    int32_t count;
    char word[MUS__PHRASE_WORDS][MUS__WORD_BYTES];
} mus__phrase;

/* Splits the first n bytes of a text into words: runs of letters and digits in lower case. An apostrophe is left out
 * ("men's" is "mens"); bytes above 127 count as letters. */
void mus__phrase_read(const char *text, size_t n, mus__phrase *out);

/* Likeness of two words: 1 the same; 0.95 the same but for a plural; 0.85 one is the other with an ending of at most
 * three letters ("pleat", "pleated"); 0 otherwise. */
double mus__word_like(const char *a, const char *b);

/* Number of letters inserted, left out, replaced or swapped with the next one between two words (optimal string
 * alignment; Damerau, A technique for computer detection and correction of spelling errors, 1964). */
int32_t mus__word_distance(const char *a, const char *b);

/* Whether a word is a preposition ("with"): the noun that a phrase is about stands before the first one. */
bool mus__word_is_preposition(const char *word);
/* Whether a word carries no meaning of its own: a preposition, an article ("the"). "a" is no such word: "a line". */
bool mus__word_is_function(const char *word);

/* Words of the trade: who types a phrase of `say` means the words of `mean`. Both list phrases with "|" between them;
 * those of `mean` stand in the order of their likeness. An empty `mean`: the words choose no design (colours, cloths,
 * praise). */
typedef struct mus__synonym {
    const char *say, *mean;
} mus__synonym;

extern const mus__synonym mus__synonyms[];
extern const int32_t mus__synonym_count;

#endif
