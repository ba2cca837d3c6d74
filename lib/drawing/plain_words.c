/*
 * plain_words.c: names of panels and edges as the words that a sewer reads.
 */
#include <stdio.h>
#include <string.h>

#include "muslin/language.h"
#include "drawing/plain_words.h"


static bool words_small(char c)
{
    return c >= 'a' && c <= 'z';
}


static bool words_capital(char c)
{
    return c >= 'A' && c <= 'Z';
}


static bool words_digit(char c)
{
    return c >= '0' && c <= '9';
}


/* bytes of the word that `name` starts with: letters of any script and digits, up to a capital after a small letter */
static size_t words_length(const char *name)
{
    size_t n = 0;
    while ((unsigned char)name[n] >= 0x80 || words_small(name[n]) || words_capital(name[n]) || words_digit(name[n])) {
        if (n > 0 && words_capital(name[n]) && words_small(name[n - 1])) break;
        n++;
    }
    return n;
}


void mus__plain_words(const char *name, bool sideless, char *out)
{
    const char *full = name;
    size_t n = 0, k = 0;
    for (; *name != '\0'; name += k > 0 ? k : 1) {
        k = words_length(name);
        const bool side = (k == 4 && strncmp(name, "left", k) == 0) || (k == 5 && strncmp(name, "right", k) == 0) ||
                          (k == 1 && *name == 'r');
        /* a single letter is a word of its own only where it stands beside others */
        const bool letter = k == 1 && full[1] != '\0';
        const char *word = letter && *name == 'F' ? "front" : letter && *name == 'B' ? "back" : name;
        if (k == 0 || (sideless && side)) continue;
        size_t size = word == name ? k : strlen(word);
        const size_t room = n + 2 < MUS__PLAIN ? MUS__PLAIN - n - 2 : 0;
        if (size > room) size = room;
        while (size > 0 && size < k && ((unsigned char)word[size] & 0xC0) == 0x80) size--; /* letters stay whole */
        if (size == 0) break;
        if (n > 0) out[n++] = ' ';
        memcpy(out + n, word, size);
        n += size;
    }
    out[n] = '\0';
    if (n > 0) return;
    if (sideless)
        mus__plain_words(full, false, out); /* a name of nothing but a side */
    else
        snprintf(out, MUS__PLAIN, "%s", full);
}


/* write a name without sides and digits; "edge" when nothing is left */
static void words_bare(const char *name, char *out)
{
    char words[MUS__PLAIN];
    size_t n = 0;
    mus__plain_words(name, true, words);
    for (const char *c = words; *c != '\0'; c++)
        if (!words_digit(*c)) out[n++] = *c;
    while (n > 0 && out[n - 1] == ' ') n--;
    out[n] = '\0';
    if (n == 0) snprintf(out, MUS__PLAIN, "edge");
}


void mus__plain_edge_words(const mus_pattern *pattern, int32_t edge, char *out)
{
    const char *label = mus_pattern_edge_label(pattern, edge);
    const char *part = mus_pattern_panel_label(pattern, mus_pattern_edge_panel(pattern, edge));
    /* the label of a free edge of a collar or hood says what it opens; a sewer looks for "end" or "face" */
    const bool named = strcmp(part, "collar") == 0 || strcmp(part, "hood") == 0 || strcmp(part, "layer") == 0 ||
                       label[0] == '\0';
    /* a sleeve that no cuff is sewn to has a hem there */
    const bool hem = strcmp(label, "cuff") == 0 && strcmp(mus_pattern_edge_name(pattern, edge), "hem") == 0 &&
                     mus_pattern_edge_seam(pattern, edge) == MUS_NONE;
    words_bare(named ? mus_pattern_edge_name(pattern, edge) : hem ? "hem" : label, out);
}


void mus__plain_edge_name(const mus_pattern *pattern, int32_t edge, char *out)
{
    words_bare(mus_pattern_edge_name(pattern, edge), out);
}


void mus__plain_words_in(int32_t language, const char *kind, const char *words, char *out)
{
    if (language == MUS_LANGUAGE_ENGLISH)
        snprintf(out, MUS__PLAIN, "%s", words);
    else
        mus_language_compose(language, kind, words, out, MUS__PLAIN);
}
