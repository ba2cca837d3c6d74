/*
 * language.h: the table of words. A language is two lists of rows, each sorted by key: what it says (sentences_XX.c)
 * and what things are called (names_XX.c). The English lists name all keys.
 *
 * To add a language, write its two lists and a row in language.c; tests/language/test_language.c holds that each list
 * has each key, with the placeholders of English.
 */
#ifndef MUS_LANGUAGE_INTERNAL_H
#define MUS_LANGUAGE_INTERNAL_H

#include <stdbool.h>

#include "muslin/language.h"

typedef struct mus__language_row {
    const char *key, *text;
} mus__language_row;

typedef struct mus__language_list {
    const mus__language_row *rows; /* (count) sorted by key */
    int32_t count;
} mus__language_list;

#define MUS__LANGUAGES(X) X(en) X(de) X(fr) X(es) X(pt) X(ja) X(ar) X(th)

#define MUS__LANGUAGE_LISTS(tag) extern const mus__language_list mus__sentences_##tag, mus__names_##tag;
MUS__LANGUAGES(MUS__LANGUAGE_LISTS)
#undef MUS__LANGUAGE_LISTS

/* text of a row of the language itself; NULL where it lacks it */
const char *mus__language_own(int32_t language, const char *key);

#endif
