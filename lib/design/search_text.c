/*
 * search_text.c: splits phrases into words; likeness of words: plurals, endings, slips of the keys.
 */
#include "design/search_text.h"

#include <string.h>

#define LIKE_PLURAL 0.95 /* chosen: below an equal word, so that "shorts" finds shorts before short sleeves */
#define LIKE_ENDING 0.85 /* chosen: below a plural */
#define ENDING_MOST 3    /* [letters] "-ped", "-ted", "-ies"; "-less" has four and turns the meaning round */
#define STEM_LEAST 4     /* [letters] shorter words take no ending: "cap" is no cape */


static char text_lower(char c)
{
    return c >= 'A' && c <= 'Z' ? (char)(c - 'A' + 'a') : c;
}


/* part of a word: letter, digit or a byte of a longer UTF-8 character */
static bool text_in_word(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || (unsigned char)c > 127;
}


void mus__phrase_read(const char *text, size_t n, mus__phrase *out)
{
    size_t used = 0;
    memset(out, 0, sizeof *out);
    for (size_t i = 0; i <= n; i++) {
        const char c = i < n ? text_lower(text[i]) : ' ';
        if (c == '\'') continue;
        if (text_in_word(c)) {
            if (out->count < MUS__PHRASE_WORDS && used + 1 < MUS__WORD_BYTES) out->word[out->count][used++] = c;
        } else if (used > 0) {
            out->count++;
            used = 0;
        }
    }
}


/* length of a word without the "s" of a plural */
static size_t text_singular(const char *word, size_t n)
{
    const bool plural = n > 3 && word[n - 1] == 's' && word[n - 2] != 's';
    return plural ? n - 1 : n;
}


double mus__word_like(const char *a, const char *b)
{
    if (strcmp(a, b) == 0) return 1.0;
    size_t na = text_singular(a, strlen(a)), nb = text_singular(b, strlen(b));
    if (na == nb && memcmp(a, b, na) == 0) return LIKE_PLURAL;

    /* the shorter one is the stem of the longer one; its last "e" or "y" may give way ("flaring", "babies") */
    const char *stem = na < nb ? a : b, *whole = na < nb ? b : a;
    size_t n = na < nb ? na : nb;
    const size_t longest = na < nb ? nb : na;
    if (n >= STEM_LEAST + 1 && (stem[n - 1] == 'e' || stem[n - 1] == 'y') && stem[n - 1] != whole[n - 1]) n--;
    if (n < STEM_LEAST || longest > n + ENDING_MOST || memcmp(stem, whole, n) != 0) return 0.0;
    return LIKE_ENDING;
}


int32_t mus__word_distance(const char *a, const char *b)
{
    int32_t row[3][MUS__WORD_BYTES];
    const int32_t na = (int32_t)strlen(a), nb = (int32_t)strlen(b);
    for (int32_t j = 0; j <= nb; j++) row[0][j] = j;
    for (int32_t i = 1; i <= na; i++) {
        int32_t *now = row[i % 3];
        const int32_t *before = row[(i + 2) % 3], *earlier = row[(i + 1) % 3];
        now[0] = i;
        for (int32_t j = 1; j <= nb; j++) {
            int32_t best = before[j - 1] + (a[i - 1] != b[j - 1]);
            if (before[j] + 1 < best) best = before[j] + 1;
            if (now[j - 1] + 1 < best) best = now[j - 1] + 1;
            const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
            if (swapped && earlier[j - 2] + 1 < best) best = earlier[j - 2] + 1;
            now[j] = best;
        }
    }
    return row[na % 3][nb];
}


static bool text_among(const char *word, const char *const *words, size_t n)
{
    for (size_t i = 0; i < n; i++)
        if (strcmp(word, words[i]) == 0) return true;
    return false;
}


bool mus__word_is_preposition(const char *word)
{
    static const char *const words[] = {"at", "by", "for", "from", "in", "of", "on", "to", "with", "without"};
    return text_among(word, words, sizeof words / sizeof words[0]);
}


bool mus__word_is_function(const char *word)
{
    static const char *const words[] = {"an", "and", "is", "or", "that", "the"};
    return mus__word_is_preposition(word) || text_among(word, words, sizeof words / sizeof words[0]);
}
