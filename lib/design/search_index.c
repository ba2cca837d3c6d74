/*
 * search_index.c: the words of each named design by field, words known to the search, and their correction.
 */
#include "design/search_index.h"

#include <string.h>

/* fields of a design and their weights. Chosen: title and name are made for people; the garment and the options of the
 * words are what is drafted; axes, families and groups say little of one design */
enum { FIELD_TITLE, FIELD_NAME, FIELD_FAMILY, FIELD_GARMENT, FIELD_OPTION, FIELD_AXIS, FIELD_GROUPS, FIELD_COUNT };

static const double index_weight[FIELD_COUNT] = {1.0, 0.9, 0.5, 0.8, 1.0, 0.5, 0.5};

#define KNOWN_LIKE 0.85 /* likeness from which a typed word is the known one: an ending, a plural or the same */
#define BEGUN_LIKE 0.8  /* of a word that a typed one begins. Chosen: below an ending */
#define CORRECTED 4     /* [letters] shorter words are not corrected: "red" is no "bed" */
#define CORRECTED_TWO 8 /* [letters] from here two slips are corrected */
#define HASH_START UINT32_C(2166136261)
#define HASH_PRIME UINT32_C(16777619) /* Fowler, Noll, Vo: FNV-1a, 32 bits */


/* ---- the vocabulary ---- */

/* slot of a word: that which holds it, or the free one where it belongs */
static int32_t *index_slot(const mus__search_index *index, const char *word)
{
    uint32_t hash = HASH_START;
    for (const char *c = word; *c != '\0'; c++) hash = (hash ^ (unsigned char)*c) * HASH_PRIME;
    for (uint32_t i = hash;; i++) {
        int32_t *slot = &index->slot[i % MUS__SEARCH_SLOTS];
        if (*slot == 0 || strcmp(index->word[*slot - 1], word) == 0) return slot;
    }
}


int32_t mus__search_find(const mus__search_index *index, const char *word)
{
    return *index_slot(index, word) - 1; /* MUS_NONE is -1 */
}


/* number of a word, which is added when it is new; MUS_NONE: no memory, or the table is half full */
static int32_t index_add_word(mus__search_index *index, const char *word)
{
    int32_t *slot = index_slot(index, word);
    if (*slot != 0) return *slot - 1;
    if (index->words >= MUS__SEARCH_SLOTS / 2 ||
        mus__reserve(index->context, &index->word, &index->word_room, index->words + 1, sizeof *index->word) ||
        mus__reserve(index->context, &index->frequency, &index->frequency_room, index->words + 1,
                     sizeof *index->frequency))
        return MUS_NONE;
    memcpy(index->word[index->words], word, strlen(word) + 1);
    return (*slot = ++index->words) - 1;
}


/* ---- the designs ---- */

static mus_status index_add_token(mus__search_index *index, int32_t token)
{
    const mus_status status =
        mus__reserve(index->context, &index->token, &index->token_room, index->tokens + 1, sizeof *index->token);
    if (status == MUS_OK) index->token[index->tokens++] = token;
    return status;
}


/* a field: its mark and its words */
static mus_status index_add_field(mus__search_index *index, int32_t field, const char *text, size_t n)
{
    mus__phrase words;
    mus__phrase_read(text, n, &words);
    mus_status status = index_add_token(index, -1 - field);
    for (int32_t i = 0; status == MUS_OK && i < words.count; i++) {
        const int32_t word = index_add_word(index, words.word[i]);
        status = word == MUS_NONE ? MUS_ERR_MEMORY : index_add_token(index, word);
    }
    return status;
}


/* "sleeve=short" as it is spoken, "short sleeve"; the garment alone; nothing for "none" */
static mus_status index_add_option(mus__search_index *index, const char *text, size_t n)
{
    const size_t key = strcspn(text, " =");
    if (key >= n) return index_add_field(index, FIELD_GARMENT, text, n);
    if (n - key == 5 && memcmp(text + key + 1, "none", 4) == 0) return MUS_OK;
    const mus_status status = index_add_field(index, FIELD_OPTION, text + key + 1, n - key - 1);
    return status == MUS_OK ? index_add_field(index, FIELD_AXIS, text, key) : status;
}


/* the noun that a title is about: the last word before a comma, a bracket or a preposition ("Shirt with a yoke") */
static int32_t index_head(const mus__search_index *index, const char *title)
{
    mus__phrase words;
    mus__phrase_read(title, strcspn(title, ",("), &words);
    int32_t n = 0;
    while (n < words.count && !mus__word_is_preposition(words.word[n])) n++;
    return n > 0 ? mus__search_find(index, words.word[n - 1]) : MUS_NONE;
}


static mus_status index_add_design(mus__search_index *index, int32_t design)
{
    static const char *const group[] = {"women", "men", "child"};
    const char *text[] = {mus_design_title(design), mus_design_name(design), mus_design_family(design)};
    mus_status status = MUS_OK;
    const int32_t title = index->tokens;
    for (int32_t f = 0; status == MUS_OK && f < 3; f++) {
        status = index_add_field(index, f, text[f], strlen(text[f]));
        if (f > FIELD_TITLE || status != MUS_OK) continue;
        for (int32_t t = title + 1; t < index->tokens; t++) index->frequency[index->token[t]]++;
        index->head[design] = index_head(index, text[f]);
    }
    for (const char *word = mus_design_words(design); status == MUS_OK && *word != '\0'; ) {
        const size_t n = strcspn(word, " ");
        status = index_add_option(index, word, n);
        word += n + strspn(word + n, " ");
    }
    for (int32_t g = 0; status == MUS_OK && g < 3; g++)
        if ((mus_design_groups(design) >> g & 1) != 0)
            status = index_add_field(index, FIELD_GROUPS, group[g], strlen(group[g]));
    return status;
}


mus_status mus__search_index_make(mus_context *context, mus__search_index *out)
{
    memset(out, 0, sizeof *out);
    out->context = context;
    out->designs = mus_design_count();
    out->slot = mus__new(context, MUS__SEARCH_SLOTS, sizeof *out->slot);
    out->first = mus__new(context, out->designs + 1, sizeof *out->first);
    out->head = mus__new(context, out->designs, sizeof *out->head);
    mus_status status = out->slot != NULL && out->first != NULL && out->head != NULL ? MUS_OK : MUS_ERR_MEMORY;
    for (int32_t d = 0; status == MUS_OK && d < out->designs; d++) {
        status = index_add_design(out, d);
        out->first[d + 1] = out->tokens;
    }
    return status == MUS_OK ? MUS_OK : mus__fail_memory(context, "an index of the designs");
}


void mus__search_index_free(mus__search_index *index)
{
    mus__free(index->context, index->word);
    mus__free(index->context, index->frequency);
    mus__free(index->context, index->slot);
    mus__free(index->context, index->token);
    mus__free(index->context, index->first);
    mus__free(index->context, index->head);
}


/* ---- match ---- */

void mus__search_like(const mus__search_index *index, const char *word, double *like)
{
    double most = 0.0;
    for (int32_t w = 0; w < index->words; w++) {
        like[w] = mus__word_like(word, index->word[w]);
        if (like[w] > most) most = like[w];
    }
    const size_t n = strlen(word);
    for (int32_t w = 0; w < index->words && most == 0.0 && n > 1; w++)
        if (strncmp(word, index->word[w], n) == 0) like[w] = BEGUN_LIKE;
}


double mus__search_match(const mus__search_index *index, int32_t design, const double *like, int32_t n,
                         double *together)
{
    double best[MUS__PHRASE_WORDS] = {0.0}, run[MUS__PHRASE_WORDS] = {0.0}, weight = 0.0, least = 1.0;
    *together = 0.0;
    for (int32_t t = index->first[design]; t < index->first[design + 1]; t++) {
        const int32_t word = index->token[t];
        if (word < 0) weight = index_weight[-1 - word];
        if (word == -1 - FIELD_AXIS) continue; /* it follows its option: "short" "sleeve" */

        /* run[k]: least match of words 0 to k that end here side by side */
        for (int32_t k = n - 1; k >= 0; k--) {
            const double value = word < 0 ? 0.0 : weight * like[(int64_t)k * index->words + word];
            const double before = k > 0 ? run[k - 1] : 1.0;
            if (value > best[k]) best[k] = value;
            run[k] = value < before ? value : before;
        }
        if (run[n - 1] > *together) *together = run[n - 1];
    }
    for (int32_t k = 0; k < n; k++)
        if (best[k] < least) least = best[k];
    return least;
}


bool mus__search_is_head(const mus__search_index *index, int32_t design, const char *word)
{
    const int32_t head = index->head[design];
    const char *garment = mus_design_words(design);
    const size_t n = strcspn(garment, " ");
    if (strlen(word) == n && memcmp(word, garment, n) == 0) return true;

    /* "skirts" are a skirt, but "short" is no shorts */
    return head != MUS_NONE && mus__word_like(word, index->word[head]) > KNOWN_LIKE &&
           strlen(word) >= strlen(index->word[head]);
}


double mus__search_precision(const mus__search_index *index, int32_t design, const double *covered)
{
    double named = 0.0, all = 0.0;
    for (int32_t t = index->first[design] + 1; t < index->first[design + 1] && index->token[t] >= 0; t++) {
        const int32_t word = index->token[t];
        if (mus__word_is_function(index->word[word])) continue;
        const double idf = mus__ln((index->designs + 1.0) / index->frequency[word]);
        named += idf * covered[word];
        all += idf;
    }
    return all > 0.0 ? named / all : 0.0;
}


/* ---- words that are known ---- */

/* the next phrase of a list between "|", without words that carry no meaning; false after the last */
static bool index_next_phrase(const char **list, mus__phrase *out)
{
    if (**list == '\0') return false;
    const size_t n = strcspn(*list, "|");
    int32_t kept = 0;
    mus__phrase_read(*list, n, out);
    for (int32_t i = 0; i < out->count; i++) {
        if (mus__word_is_function(out->word[i])) continue;
        if (kept < i) memcpy(out->word[kept], out->word[i], MUS__WORD_BYTES);
        kept++;
    }
    out->count = kept;
    *list += n + ((*list)[n] == '|');
    return true;
}


const mus__synonym *mus__search_row(const mus__phrase *phrase, int32_t i, int32_t *n)
{
    const mus__synonym *found = NULL;
    mus__phrase say;
    int32_t longest = 0;
    for (int32_t r = 0; r < mus__synonym_count; r++)
        for (const char *list = mus__synonyms[r].say; index_next_phrase(&list, &say); ) {
            if (say.count <= longest || i + say.count > phrase->count) continue;
            int32_t same = 0;
            while (same < say.count && mus__word_like(say.word[same], phrase->word[i + same]) > KNOWN_LIKE) same++;
            if (same < say.count) continue;
            *n = longest = say.count;
            found = &mus__synonyms[r];
        }
    return found;
}


/* the nearest of the known words so far */
typedef struct index_near {
    char word[MUS__WORD_BYTES];
    int32_t distance;
    bool known, begun; /* the word is known; a known word begins with it */
} index_near;


static void index_consider(const char *typed, const char *word, index_near *near)
{
    const size_t n = strlen(typed);
    near->known = near->known || mus__word_like(typed, word) >= KNOWN_LIKE;
    near->begun = near->begun || (n > 1 && strncmp(typed, word, n) == 0);
    if (near->known || n < CORRECTED) return;
    const int32_t distance = mus__word_distance(typed, word);
    if (distance >= near->distance) return;
    near->distance = distance;
    memcpy(near->word, word, MUS__WORD_BYTES);
}


/* compares a typed word with those of the catalogue and of the synonyms */
static index_near index_compare(const mus__search_index *index, const char *typed)
{
    index_near near = {.distance = strlen(typed) >= CORRECTED_TWO ? 3 : 2};
    mus__phrase say;
    for (int32_t w = 0; w < index->words && !near.known; w++) index_consider(typed, index->word[w], &near);
    for (int32_t r = 0; r < mus__synonym_count && !near.known; r++)
        for (const char *list = mus__synonyms[r].say; !near.known && index_next_phrase(&list, &say); )
            for (int32_t i = 0; i < say.count; i++) index_consider(typed, say.word[i], &near);
    return near;
}


static void index_append(mus__phrase *out, const char *word)
{
    if (out->count < MUS__PHRASE_WORDS) memcpy(out->word[out->count++], word, strlen(word) + 1);
}


bool mus__search_join(const mus__search_index *index, const char *a, const char *b, char *joined)
{
    const size_t n = strlen(a), m = strlen(b);
    if (n + m >= MUS__WORD_BYTES) return false;
    memcpy(joined, a, n);
    memcpy(joined + n, b, m + 1);
    return index_compare(index, joined).known && (!index_compare(index, a).known || !index_compare(index, b).known);
}


void mus__search_correct(const mus__search_index *index, const char *word, mus__phrase *out)
{
    char first[MUS__WORD_BYTES], second[MUS__WORD_BYTES];
    const index_near near = index_compare(index, word);
    const size_t n = strlen(word);
    for (size_t i = 1; !near.known && i + 2 < n; i++) {
        memcpy(first, word, i);
        first[i] = '\0';
        memcpy(second, word + i, n - i + 1);
        if (!index_compare(index, first).known || !index_compare(index, second).known) continue;
        index_append(out, first);
        index_append(out, second);
        return;
    }
    const bool corrected = !near.known && !near.begun && near.word[0] != '\0';
    index_append(out, corrected ? near.word : word);
}
