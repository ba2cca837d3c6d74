/*
 * language.c: the languages, and the rows of their table by key.
 */
#include <string.h>

#include "language/language.h"

/* the languages in the order of their numbers; new ones come last. Each takes some 30 KB: a program that counts bytes
 * defines MUS_ENGLISH_ONLY, and the linker leaves the lists of the others out */
static const struct {
    const char *tag, *name;
    bool right_to_left;
    const mus__language_list *lists[2];
} languages[] = {
    {"en", "English", false, {&mus__sentences_en, &mus__names_en}},
#ifndef MUS_ENGLISH_ONLY
    {"de", "Deutsch", false, {&mus__sentences_de, &mus__names_de}},
    {"fr", "Français", false, {&mus__sentences_fr, &mus__names_fr}},
    {"es", "Español", false, {&mus__sentences_es, &mus__names_es}},
    {"pt", "Português", false, {&mus__sentences_pt, &mus__names_pt}},
    {"ja", "日本語", false, {&mus__sentences_ja, &mus__names_ja}},
    {"ar", "العربية", true, {&mus__sentences_ar, &mus__names_ar}},
    {"th", "ไทย", false, {&mus__sentences_th, &mus__names_th}},
#endif
};

#define LANGUAGES ((int32_t)(sizeof languages / sizeof languages[0]))


static bool language_known(int32_t language)
{
    return language >= 0 && language < LANGUAGES;
}


int32_t mus_language_count(void)
{
    return LANGUAGES;
}


const char *mus_language_tag(int32_t language)
{
    return language_known(language) ? languages[language].tag : NULL;
}


const char *mus_language_name(int32_t language)
{
    return language_known(language) ? languages[language].name : NULL;
}


int32_t mus_language_is_right_to_left(int32_t language)
{
    return language_known(language) && languages[language].right_to_left;
}


int32_t mus_language_find(const char *tag)
{
    if (tag == NULL) return MUS_LANGUAGE_ENGLISH;
    const size_t n = strcspn(tag, "-_.@");
    if (n == 0 || (n == 1 && tag[0] == 'C') || (n == 5 && memcmp(tag, "POSIX", n) == 0))
        return tag[n] == '\0' || n > 0 ? MUS_LANGUAGE_ENGLISH : MUS_NONE;
    for (int32_t i = 0; i < LANGUAGES; i++) {
        const char *own = languages[i].tag;
        bool same = strlen(own) == n;
        /* letters of a tag may be capitals */
        for (size_t k = 0; k < n && same; k++) same = own[k] == (tag[k] >= 'A' && tag[k] <= 'Z' ? tag[k] + 32 : tag[k]);
        if (same) return i;
    }
    return MUS_NONE;
}


int32_t mus_language_row_count(void)
{
    return mus__names_en.count + mus__sentences_en.count;
}


/* the two lists are merged: row k of the whole is found by counting what stands before it */
const char *mus_language_row_key(int32_t row)
{
    int32_t a = 0, b = 0;
    if (row < 0 || row >= mus_language_row_count()) return NULL;
    for (;;) {
        const char *s = a < mus__sentences_en.count ? mus__sentences_en.rows[a].key : NULL;
        const char *t = b < mus__names_en.count ? mus__names_en.rows[b].key : NULL;
        const bool first = t == NULL || (s != NULL && strcmp(s, t) < 0);
        if (a + b == row) return first ? s : t;
        if (first) a++;
        else b++;
    }
}


static const char *language_list_find(const mus__language_list *list, const char *key)
{
    int32_t low = 0, high = list->count;
    while (low < high) {
        const int32_t middle = (low + high) / 2;
        const int order = strcmp(list->rows[middle].key, key);
        if (order == 0) return list->rows[middle].text;
        if (order < 0) low = middle + 1;
        else high = middle;
    }
    return NULL;
}


const char *mus__language_own(int32_t language, const char *key)
{
    const char *text = language_list_find(languages[language].lists[0], key);
    return text != NULL ? text : language_list_find(languages[language].lists[1], key);
}


const char *mus_language_text(int32_t language, const char *key)
{
    if (!language_known(language) || key == NULL) return NULL;
    const char *text = mus__language_own(language, key);
    return text != NULL ? text : mus__language_own(MUS_LANGUAGE_ENGLISH, key);
}
