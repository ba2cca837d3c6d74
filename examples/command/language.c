/*
 * language.c: the language of what the command prints for people.
 */
#include "language.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "muslin/language.h"


int32_t language_read(const char *command, const char *asked)
{
    static const char *const variables[] = {"LC_ALL", "LC_MESSAGES", "LANG"};
    int32_t language = mus_language_find(asked);
    if (asked != NULL) {
        char list[128] = "";
        for (int32_t i = 0; i < mus_language_count() && language == MUS_NONE; i++) {
            const size_t n = strlen(list);
            snprintf(list + n, sizeof list - n, "%s%s", i > 0 ? " " : "", mus_language_tag(i));
        }
        if (language == MUS_NONE) complain(EXIT_INPUT, command, "--language %s: expected one of %s", asked, list);
        return language;
    }
    /* the first that is set decides (POSIX.1-2017, 8.2) */
    for (size_t i = 0; i < sizeof variables / sizeof variables[0]; i++) {
        const char *value = getenv(variables[i]);
        if (value == NULL || value[0] == '\0') continue;
        language = mus_language_find(value);
        return language != MUS_NONE ? language : MUS_LANGUAGE_ENGLISH;
    }
    return MUS_LANGUAGE_ENGLISH;
}


/* columns of the character at `text`; *bytes gets its length */
static int32_t letter_columns(const unsigned char *text, size_t *bytes)
{
    const size_t n = text[0] < 0x80 ? 1 : text[0] < 0xe0 ? 2 : text[0] < 0xf0 ? 3 : 4;
    uint32_t code = n == 1 ? text[0] : text[0] & (0x7fu >> n);
    for (size_t i = 1; i < n && text[i] != '\0'; i++) code = code << 6 | (text[i] & 0x3f);
    *bytes = n;
    /* vowels and tones of Thai, signs of Arabic */
    if (code == 0xe31 || (code >= 0xe34 && code <= 0xe3a) || (code >= 0xe47 && code <= 0xe4e)) return 0;
    if (code >= 0x64b && code <= 0x65f) return 0;
    return (code >= 0x2e80 && code < 0xa4d0) || (code >= 0xac00 && code < 0xd7a4) || (code >= 0xff00 && code < 0xff61)
               ? 2
               : 1;
}


void language_pad(const char *text, int32_t columns)
{
    printf("%s", text);
    for (size_t n; *text != '\0' && columns > 0; text += n) columns -= letter_columns((const unsigned char *)text, &n);
    printf("%*s", (int)(columns > 0 ? columns : 0), "");
}
