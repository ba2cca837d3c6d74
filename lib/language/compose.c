/*
 * compose.c: titles and names that are made of rows.
 *
 * A title is translated part by part between its commas. A name of a panel or an edge is looked up as a whole; else
 * its last words are what it is, and the words before them what it is of ("front armhole facing": a facing of a front
 * armhole), which the row "KIND:of" puts together. A side and a number are taken out first and put back by the rows
 * "KIND:left", "KIND:right" and "KIND:number".
 */
#include <stdio.h>
#include <string.h>

#include "language/language.h"

#define COMPOSE_WORDS 16  /* most words of a name; chosen: twice the longest */
#define COMPOSE_TEXT 256  /* [bytes] of a name or a part of a title; chosen: twice the longest */

/* a name in work */
typedef struct compose_name {
    const char *kind;
    int32_t language;
    int32_t nword;
    char words[COMPOSE_WORDS][COMPOSE_TEXT / 4];
    char number[12];
    bool left, right;
} compose_name;


/* write at most `size` bytes (1 or more) with the zero byte, whole letters; false when the text is longer */
static bool compose_put(char *out, size_t size, const char *text)
{
    size_t n = strlen(text);
    const bool whole = n < size;
    if (!whole) n = size - 1;
    while (!whole && n > 0 && ((unsigned char)text[n] & 0xC0) == 0x80) n--;
    memmove(out, text, n);
    out[n] = '\0';
    return whole;
}


/* write the row with {0} and {1} replaced */
static void compose_fill(const char *row, const char *zero, const char *one, char *out)
{
    char text[2 * COMPOSE_TEXT];
    size_t n = 0;
    for (; *row != '\0' && n + 1 < sizeof text; row++) {
        const bool place = row[0] == '{' && (row[1] == '0' || row[1] == '1') && row[2] == '}';
        if (!place) {
            text[n++] = *row;
            continue;
        }
        compose_put(text + n, sizeof text - n, row[1] == '0' ? zero : one);
        n += strlen(text + n);
        row += 2;
    }
    text[n] = '\0';
    compose_put(out, COMPOSE_TEXT, text);
}


/* the row "KIND.WORDS", or "KIND:WORDS" of a rule */
static const char *compose_row(const compose_name *name, bool rule, const char *words)
{
    char key[COMPOSE_TEXT + 16];
    snprintf(key, sizeof key, "%s%c%s", name->kind, rule ? ':' : '.', words);
    return mus__language_own(name->language, key);
}


/* the words from `first` to `last` with blanks between */
static void compose_join(const compose_name *name, int32_t first, int32_t last, char *out)
{
    out[0] = '\0';
    for (int32_t i = first; i < last; i++) {
        const size_t n = strlen(out);
        snprintf(out + n, COMPOSE_TEXT - n, "%s%s", i > first ? " " : "", name->words[i]);
    }
}


/* split a name into words; sides and the first number are taken out, except from a name that is nothing else */
static void compose_split(const char *words, compose_name *out)
{
    while (*words != '\0') {
        const size_t n = strcspn(words, " _-");
        char word[COMPOSE_TEXT / 4] = "";
        size_t at = 0, digits = strlen(out->number);
        for (size_t i = 0; i < n && at + 1 < sizeof word; i++) {
            const bool digit = words[i] >= '0' && words[i] <= '9';
            if (!digit) word[at++] = words[i];
            else if (digits + 1 < sizeof out->number) out->number[digits++] = words[i];
        }
        word[at] = out->number[digits] = '\0';
        const bool left = strcmp(word, "left") == 0, right = strcmp(word, "right") == 0;
        out->left = out->left || left;
        out->right = out->right || right;
        if (at > 0 && !left && !right && out->nword < COMPOSE_WORDS)
            memcpy(out->words[out->nword++], word, sizeof word);
        words += n + (words[n] != '\0');
    }
}


/* write the first `last` words; false when the table lacks some */
static bool compose_words(const compose_name *name, int32_t last, char *out)
{
    char part[COMPOSE_TEXT], rest[COMPOSE_TEXT];
    compose_join(name, 0, last, part);
    const char *row = compose_row(name, false, part);
    if (row != NULL) {
        compose_put(out, COMPOSE_TEXT, row);
        return true;
    }
    /* the longest row at the end, of what the words before it say */
    for (int32_t i = 1; i < last; i++) {
        compose_join(name, i, last, part);
        row = compose_row(name, false, part);
        const char *of = compose_row(name, true, "of");
        if (row == NULL || of == NULL || !compose_words(name, i, rest)) continue;
        compose_fill(of, row, rest, out);
        return true;
    }
    return false;
}


static bool compose_parts(compose_name *name, char *out)
{
    if (name->nword == 0 && (name->left || name->right)) {
        snprintf(name->words[name->nword++], sizeof name->words[0], "%s", name->left ? "left" : "right");
        name->left = name->right = false;
    }
    if (name->nword == 0 || !compose_words(name, name->nword, out)) return false;
    const char *const keys[3] = {name->number[0] != '\0' ? "number" : NULL, name->left ? "left" : NULL,
                                 name->right ? "right" : NULL};
    for (int32_t i = 0; i < 3; i++) {
        const char *row = keys[i] != NULL ? compose_row(name, true, keys[i]) : NULL;
        if (row != NULL) compose_fill(row, out, name->number, out);
    }
    return true;
}


/* a title, part by part */
static bool compose_title(int32_t language, const char *title, char *text, size_t size)
{
    compose_name name = {.kind = "title", .language = language};
    const char *comma = mus_language_text(language, "list.comma");
    size_t n = 0;
    bool all = true;
    for (bool more = true; more;) {
        char part[COMPOSE_TEXT];
        const char *end = strstr(title, ", ");
        const size_t length = end != NULL ? (size_t)(end - title) : strlen(title);
        snprintf(part, sizeof part, "%.*s", (int)(length < sizeof part ? length : sizeof part - 1), title);
        const char *row = compose_row(&name, false, part);
        all = all && row != NULL;
        more = compose_put(text + n, size - n, row != NULL ? row : part) && end != NULL;
        n += strlen(text + n);
        more = more && compose_put(text + n, size - n, comma);
        n += strlen(text + n);
        if (more) title += length + 2;
    }
    return all;
}


int32_t mus_language_compose(int32_t language, const char *kind, const char *words, char *text, size_t size)
{
    char made[COMPOSE_TEXT];
    if (text != NULL && size > 0) text[0] = '\0';
    if (mus_language_tag(language) == NULL || kind == NULL || words == NULL || text == NULL || size == 0) return 0;
    if (language == MUS_LANGUAGE_ENGLISH) {
        compose_put(text, size, words);
        for (char *c = text; *c != '\0'; c++) *c = *c == '_' ? ' ' : *c;
        return 1;
    }
    if (strcmp(kind, "measure") == 0) {
        compose_name name = {.kind = kind, .language = language};
        const char *row = compose_row(&name, false, words);
        compose_put(text, size, row != NULL ? row : words);
        return row != NULL;
    }
    if (strcmp(kind, "title") == 0) return compose_title(language, words, text, size);
    compose_name name = {.kind = kind, .language = language};
    compose_split(words, &name);
    if (compose_parts(&name, made)) {
        compose_put(text, size, made);
        return 1;
    }
    compose_put(text, size, words);
    for (char *c = text; *c != '\0'; c++) *c = *c == '_' ? ' ' : *c;
    return 0;
}
