/*
 * search_index.h: the named designs as sequences of words of one vocabulary, for design_search.c.
 */
#ifndef MUS_SEARCH_INDEX_H
#define MUS_SEARCH_INDEX_H

#include "base/base_internal.h"
#include "base/elementary.h"
#include "design/search_text.h"
#include "muslin/design.h"

#define MUS__SEARCH_SLOTS 4096 /* of the hash table; above twice the words of the catalogue (about 250) many times */

typedef struct mus__search_index {
    mus_context *context;
    int32_t designs, words, tokens;
    char (*word)[MUS__WORD_BYTES]; /* (words) the vocabulary */
    int32_t *frequency;            /* (words) designs that have the word in their title */
    int32_t *slot;                 /* (MUS__SEARCH_SLOTS) word + 1 by hash; 0: free */
    int32_t *token;                /* (tokens) word, or -1 - field where a field begins */
    int32_t *first;                /* (designs + 1) first token of a design */
    int32_t *head;                 /* (designs) word: the noun that the title is about, or MUS_NONE */
    int32_t word_room, frequency_room, token_room;
} mus__search_index;

/* Reads the catalogue to an index; it must be freed whatever is returned. Errors: MUS_ERR_MEMORY */
mus_status mus__search_index_make(mus_context *context, mus__search_index *out);
void mus__search_index_free(mus__search_index *index);

/* Number of a word in the vocabulary; MUS_NONE: it is not there. */
int32_t mus__search_find(const mus__search_index *index, const char *word);

/* Likeness of a word to each of the vocabulary, like (words); when none is like it, to those that begin with it. */
void mus__search_like(const mus__search_index *index, const char *word, double *like);

/* Match of a design with n words, whose likeness to the vocabulary is `like` (n x words): the least over the n words
 * of the largest weight of a field times likeness. *together: the same where they stand side by side in a field,
 * 0 where they do not. */
double mus__search_match(const mus__search_index *index, int32_t design, const double *like, int32_t n,
                         double *together);

/* Whether a word is the noun that a design's title is about ("Shirt dress": dress), or its garment. */
bool mus__search_is_head(const mus__search_index *index, int32_t design, const char *word);

/* Share of a design's title, in idf of its words, that is covered (words: 0 to 1). */
double mus__search_precision(const mus__search_index *index, int32_t design, const double *covered);

/* The row of synonyms with the longest phrase that the words from the i-th begin with; *n: its number of words. NULL:
 * there is none, *n is not changed. */
const mus__synonym *mus__search_row(const mus__phrase *phrase, int32_t i, int32_t *n);

/* Whether two words, at least one of them unknown, are a known word when joined ("cheong sam"); writes it to `joined`
 * (MUS__WORD_BYTES). */
bool mus__search_join(const mus__search_index *index, const char *a, const char *b, char *joined);

/* Appends a word to a phrase: itself if catalogue or synonyms know it or a word that begins so; else the two known
 * words that it is joined of; else the known word at the smallest distance, one letter for words of 4 to 7, two for
 * longer ones; else itself. */
void mus__search_correct(const mus__search_index *index, const char *word, mus__phrase *out);

#endif
