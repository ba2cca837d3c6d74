/*
 * design_search.c: finds named designs by a phrase that a person types ("long sleeve tee").
 *
 * A design is a document of fields: title, name, family, words and groups, each with its weight. The phrase is read
 * to concepts: the longest rows of search_synonyms.c, else single words; unknown words are split ("pencilskirt") or
 * corrected ("litle"). A concept has senses, itself and those of its row. Its match with a design, 0 to 1, is that of
 * its best sense: the least over the words of the sense of field weight times likeness.
 *
 * The head of the phrase is the last concept before a preposition that names the noun of some title or a garment
 * ("shirt dress": dress). Designs of another noun and garment, and designs for others than the phrase says ("kids"),
 * keep the share OTHER_SHARE of their score.
 *
 * Score: with idf(c) = ln((N + 1) / (1 + sum over designs of match(c))),
 *
 *     recall = sum over c of idf(c) match(c) / sum over c of idf(c)
 *     score  = recall (1 - PRECISION_SHARE (1 - precision))
 *
 * Precision is the share of the title, in idf of its words, that the phrase names: of "Hoodie" and "Zip hoodie" the
 * phrase "hoodie" means the first. Two neighbours of the phrase that are neighbours in a field ("short sleeve") make a
 * concept more, of weight PAIR_SHARE.
 *
 * Sources: K. Sparck Jones, A statistical interpretation of term specificity, Journal of Documentation 28, 1972 (idf);
 * S. Robertson and H. Zaragoza, The probabilistic relevance framework, 2009 (weights of fields).
 */
#include <string.h>

#include "base/sort.h"
#include "design/search_index.h"
#include "design/words.h"

#define SENSE_WORTH 0.9      /* of a row's first sense, its square of the second ... Chosen: below the word itself */
#define APART_SHARE 0.5      /* of a sense whose words do not stand side by side. Chosen: "knit" and "top" apart */
#define PAIR_SHARE 0.3       /* of the idf of two neighbours. Chosen: an order of words is a hint, a word is a wish */
#define PRECISION_SHARE 0.2  /* chosen: a title without more words never beats one concept more of three */
#define OTHER_SHARE 0.5      /* of a design of another kind or group. Chosen: who wants a dress does not take a top */
#define SHOWN_SHARE 0.5      /* a design matches with this share of the best score or more. Chosen */

/* a search under way */
typedef struct search {
    mus__search_index index;
    mus__phrase phrase;   /* corrected */
    int32_t ends;         /* number of its words before the first preposition */
    double *sum, *match;  /* (designs) sum of idf times match; match of the concept at hand */
    double *kind, *group; /* (designs) 1, or OTHER_SHARE: of another kind, for others */
    double *like;         /* (MUS__PHRASE_WORDS x words) likeness of the sense at hand to the vocabulary */
    double *covered;      /* (words) largest likeness to any sense of the phrase */
    double all;           /* sum of idf */
    int32_t asked, met;   /* concepts that tell no group; those of them that some design has */
    int32_t condition[MUS__AXIS_COUNT]; /* option that an axis shall have, or MUS_NONE */
    bool conditions;
} search;


/* ---- one concept ---- */

/* Raises the match of each design to that of a sense; `beside`: only where its words stand side by side. */
static void search_sense(search *s, const mus__phrase *sense, double worth, bool beside)
{
    const mus__search_index *index = &s->index;
    for (int32_t k = 0; k < sense->count; k++) {
        double *like = &s->like[(int64_t)k * index->words];
        mus__search_like(index, sense->word[k], like);
        for (int32_t w = 0; w < index->words && !beside; w++)
            if (like[w] > s->covered[w]) s->covered[w] = like[w];
    }
    for (int32_t d = 0; d < index->designs; d++) {
        double together = 0.0, value = mus__search_match(index, d, s->like, sense->count, &together);
        const double apart = APART_SHARE * value;
        if (sense->count > 1 && together < value) value = together > apart ? together : apart;
        if (beside) value = together;
        if (worth * value > s->match[d]) s->match[d] = worth * value;
    }
}


/* Adds the concept whose senses were matched, and clears the match. Returns whether any design has it. */
static bool search_add(search *s, double share)
{
    double frequency = 1.0;
    for (int32_t d = 0; d < s->index.designs; d++) frequency += s->match[d];
    const double idf = share * mus__ln((s->index.designs + 1.0) / frequency);
    for (int32_t d = 0; d < s->index.designs; d++) s->sum[d] += idf * s->match[d];
    if (frequency > 1.0) s->all += idf;
    memset(s->match, 0, (size_t)s->index.designs * sizeof *s->match);
    return frequency > 1.0;
}


/* Whether a row tells whom a garment is for. */
static bool search_row_groups(const mus__synonym *row)
{
    static const char *const group[] = {"child", "men", "women"};
    for (size_t i = 0; row != NULL && i < sizeof group / sizeof group[0]; i++)
        if (strcmp(row->mean, group[i]) == 0) return true;
    return false;
}


/* Marks the designs of another kind if a word of a sense is the noun of any design; leaves the marks else. */
static void search_head(search *s, const char *word, bool *met)
{
    bool any = *met;
    for (int32_t d = 0; d < s->index.designs && !any; d++) any = mus__search_is_head(&s->index, d, word);
    for (int32_t d = 0; d < s->index.designs && any; d++) {
        const bool is = mus__search_is_head(&s->index, d, word);
        if (is || !*met) s->kind[d] = is ? 1.0 : OTHER_SHARE;
    }
    *met = any;
}


/* the n words of the phrase from the i-th, as they are or joined to one */
static mus__phrase search_part(const search *s, int32_t i, int32_t n)
{
    mus__phrase part = {0};
    for (int32_t k = 0; k < n; k++) memcpy(part.word[part.count++], s->phrase.word[i + k], MUS__WORD_BYTES);
    return part;
}


static mus__phrase search_joined(const search *s, int32_t i)
{
    mus__phrase part = {0};
    const size_t n = strlen(s->phrase.word[i]), m = strlen(s->phrase.word[i + 1]);
    if (n + m >= MUS__WORD_BYTES) return part;
    memcpy(part.word[0], s->phrase.word[i], n);
    memcpy(part.word[0] + n, s->phrase.word[i + 1], m);
    part.count = 1;
    return part;
}


/* The concept that begins with the i-th word. Returns the number of its words. */
static int32_t search_concept(search *s, int32_t i)
{
    int32_t n = 1;
    bool head = false;
    const mus__synonym *row = mus__search_row(&s->phrase, i, &n);
    if (row != NULL && row->mean[0] == '\0') return n;
    mus__phrase sense = search_part(s, i, n);
    if (n == 1 && i + 1 < s->phrase.count) {
        const mus__phrase joined = search_joined(s, i);
        if (joined.count == 1 && mus__search_find(&s->index, joined.word[0]) != MUS_NONE) {
            search_sense(s, &joined, 1.0, false);
            sense = search_part(s, i, n = 2);
        }
    }
    double worth = 1.0;
    for (const char *mean = row != NULL ? row->mean : "";; ) {
        search_sense(s, &sense, worth, false);
        if (i < s->ends || s->ends == 0) search_head(s, sense.word[sense.count - 1], &head);
        if (*mean == '\0') break;
        const size_t length = strcspn(mean, "|");
        mus__phrase_read(mean, length, &sense);
        worth *= SENSE_WORTH;
        mean += length + (mean[length] == '|');
    }
    const bool groups = search_row_groups(row);
    for (int32_t d = 0; d < s->index.designs && groups; d++)
        if (s->match[d] <= 0.0) s->group[d] = OTHER_SHARE;
    const bool met = search_add(s, 1.0);
    s->asked += !groups;
    s->met += met && !groups;
    return n;
}


static void search_pairs(search *s)
{
    for (int32_t i = 0; i + 1 < s->phrase.count; i++) {
        mus__phrase pair = search_part(s, i, 2);
        search_sense(s, &pair, 1.0, true);
        memcpy(pair.word[0], s->phrase.word[i + 1], MUS__WORD_BYTES);
        memcpy(pair.word[1], s->phrase.word[i], MUS__WORD_BYTES);
        search_sense(s, &pair, 1.0, true);
        search_add(s, PAIR_SHARE);
    }
}


/* ---- the phrase ---- */

/* Reads "length=knee": the option that an axis shall have. */
static mus_status search_condition(search *s, const char *text, size_t n)
{
    int32_t axis, option;
    const mus_status status = mus__style_read_option(s->index.context, text, n, &axis, &option);
    if (status != MUS_OK) return status;
    s->condition[axis] = option;
    s->conditions = true;
    return MUS_OK;
}


/* Appends a word as it is typed to the phrase. */
static void search_word(search *s, const char *typed)
{
    char joined[MUS__WORD_BYTES];
    mus__phrase *phrase = &s->phrase;
    if (mus__word_is_function(typed)) {
        if (s->ends == 0 && mus__word_is_preposition(typed)) s->ends = phrase->count;
    } else if (phrase->count > 0 && mus__search_join(&s->index, phrase->word[phrase->count - 1], typed, joined)) {
        memcpy(phrase->word[phrase->count - 1], joined, sizeof joined);
    } else {
        mus__search_correct(&s->index, typed, phrase);
    }
}


/* Splits the phrase into words and conditions, and corrects the words. */
static mus_status search_read(search *s, const char *phrase)
{
    mus_status status = MUS_OK;
    mus__phrase some;
    for (int32_t a = 0; a < MUS__AXIS_COUNT; a++) s->condition[a] = MUS_NONE;
    for (const char *word = phrase; status == MUS_OK && *word != '\0'; ) {
        const size_t n = strcspn(word, " \t\n");
        if (memchr(word, '=', n) != NULL) {
            status = search_condition(s, word, n);
        } else {
            mus__phrase_read(word, n, &some);
            for (int32_t i = 0; i < some.count; i++) search_word(s, some.word[i]);
        }
        word += n + strspn(word + n, " \t\n");
    }
    return status;
}


/* Whether a design has the options of the conditions. */
static mus_status search_meets(const search *s, int32_t design, bool *meets)
{
    mus__style style;
    const mus_status status = mus__style_read(s->index.context, mus_design_words(design), &style);
    *meets = status == MUS_OK;
    for (int32_t a = 0; a < MUS__AXIS_COUNT && *meets; a++)
        *meets = s->condition[a] == MUS_NONE ||
                 (mus__style_has(style.option[0], a) && style.option[a] == s->condition[a]);
    return status;
}


/* ---- ranks ---- */

typedef struct search_rank {
    double score;
    int32_t design;
} search_rank;


static int search_compare(const void *a, const void *b)
{
    const search_rank *x = a, *y = b;
    if (x->score != y->score) return x->score < y->score ? 1 : -1;
    return x->design - y->design;
}


static double search_score(const search *s, int32_t design, int32_t exact)
{
    if (design == exact) return 1.0;
    if (s->phrase.count == 0) return s->conditions ? 1.0 : 0.0;
    if (s->all <= 0.0 || (s->asked > 0 && s->met == 0)) return 0.0;
    const double precision = mus__search_precision(&s->index, design, s->covered);
    return s->kind[design] * s->group[design] * s->sum[design] / s->all * (1.0 - PRECISION_SHARE * (1.0 - precision));
}


static mus_status search_rank_all(const search *s, int32_t exact, search_rank *rank, int32_t *count)
{
    mus_status status = MUS_OK;
    int32_t n = 0;
    for (int32_t d = 0; status == MUS_OK && d < s->index.designs; d++) {
        bool meets = true;
        const double score = search_score(s, d, exact);
        if (score > 0.0 && s->conditions) status = search_meets(s, d, &meets);
        if (score > 0.0 && meets) rank[n].score = score, rank[n++].design = d;
    }
    mus__sort(rank, (size_t)n, sizeof *rank, search_compare);
    for (*count = 0; *count < n && rank[*count].score >= SHOWN_SHARE * rank[0].score; ) ++*count;
    return status;
}


static mus_status search_run(search *s, const char *phrase, search_rank *rank, int32_t *count)
{
    mus_status status = search_read(s, phrase);
    if (status != MUS_OK) return status;
    for (int32_t d = 0; d < s->index.designs; d++) s->kind[d] = s->group[d] = 1.0;
    for (int32_t i = 0; i < s->phrase.count; ) i += search_concept(s, i);
    search_pairs(s);
    return search_rank_all(s, mus_design_find(phrase), rank, count);
}


mus_status mus_design_search(mus_context *context, const char *phrase, int32_t room, int32_t *designs, double *scores,
                             int32_t *count)
{
    search s = {0};
    int32_t found = 0;
    if (context == NULL) return MUS_ERR_ARG;
    if (count != NULL) *count = 0;
    if (phrase == NULL || count == NULL || room < 0 || (room > 0 && designs == NULL))
        return mus__fail(context, MUS_ERR_ARG, "search: phrase, designs or count is NULL, or room is negative");
    mus_status status = mus__search_index_make(context, &s.index);
    const int32_t n = s.index.designs, words = s.index.words;
    s.sum = mus__new(context, n, sizeof *s.sum);
    s.match = mus__new(context, n, sizeof *s.match);
    s.kind = mus__new(context, n, sizeof *s.kind);
    s.group = mus__new(context, n, sizeof *s.group);
    s.like = mus__new(context, (int64_t)MUS__PHRASE_WORDS * words, sizeof *s.like);
    s.covered = mus__new(context, words, sizeof *s.covered);
    search_rank *rank = mus__new(context, n, sizeof *rank);
    if (status == MUS_OK && (s.sum == NULL || s.match == NULL || s.kind == NULL || s.group == NULL || s.like == NULL ||
                             s.covered == NULL || rank == NULL))
        status = mus__fail_memory(context, "a search");
    if (status == MUS_OK) status = search_run(&s, phrase, rank, &found);
    if (status == MUS_OK) *count = found;
    for (int32_t i = 0; status == MUS_OK && i < found && i < room; i++) {
        designs[i] = rank[i].design;
        if (scores != NULL) scores[i] = rank[i].score;
    }
    mus__free(context, rank);
    mus__free(context, s.covered);
    mus__free(context, s.like);
    mus__free(context, s.group);
    mus__free(context, s.kind);
    mus__free(context, s.match);
    mus__free(context, s.sum);
    mus__search_index_free(&s.index);
    return status;
}
