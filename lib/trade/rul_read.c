/*
 * rul_read.c: a RUL file: the grade rules of a DXF.
 *
 * Lines "KEY: value": UNITS, SAMPLE SIZE, SIZE LIST, and for each rule "RULE: DELTA n" with a pair "dx, dy" a size. In
 * one dialect the pairs are differences from the sample size, in another steps from the size before; the pair of the
 * sample is 0, 0 in the first. A rule whose pair is not 0, 0 there is read as steps.
 */
#include <math.h>
#include <string.h>

#include "trade/dxf_ring.h"

#define RUL_SIZES 65     /* most sizes; chosen: as the writer's */
#define RUL_RULES 100000 /* most rules; chosen: far above a garment's points */

typedef struct rul_text {
    const mus__source *source;
    mus__rul *rul;
    const char *at;
    int64_t line;
    double unit;      /* [m] */
    mus__dxf_slice sample;
} rul_text;


void mus__rul_unload(mus_context *context, mus__rul *rul)
{
    mus_context_alloc(context, rul->sizes, 0);
    mus_context_alloc(context, rul->numbers, 0);
    mus_context_alloc(context, rul->moves, 0);
}


int32_t mus__rul_size(const mus__rul *rul, mus__dxf_slice name)
{
    for (int32_t i = 0; i < rul->nsize; i++)
        if (mus__dxf_same(rul->sizes[i], name)) return i;
    return MUS_NONE;
}


bool mus__rul_move(const mus__rul *rul, int32_t number, int32_t size, double *out)
{
    for (int32_t i = 0; i < rul->nrule; i++) {
        if (rul->numbers[i] != number) continue;
        memcpy(out, rul->moves + 2 * ((size_t)i * (size_t)rul->nsize + (size_t)size), 2 * sizeof *out);
        return true;
    }
    return false;
}


/* the next word of the line, between blanks and commas */
static mus__dxf_slice rul_word(rul_text *t)
{
    t->at += strspn(t->at, " \t,");
    mus__dxf_slice word = {t->at, (int32_t)strcspn(t->at, " \t,\r\n")};
    t->at += word.length;
    return word;
}


static void rul_line_end(rul_text *t)
{
    t->at += strcspn(t->at, "\r\n");
    if (*t->at == '\r') t->at++;
    if (*t->at == '\n') t->at++;
    t->line++;
}


static mus_status rul_sizes(rul_text *t)
{
    if (t->rul->nsize > 0)
        return mus__source_fail(t->source, t->line, MUS_ERR_FORMAT, "a second line \"SIZE LIST:\", expected one");
    for (mus__dxf_slice word = rul_word(t); word.length > 0; word = rul_word(t)) {
        mus_status status = mus__source_reserve(t->source, &t->rul->sizes, &t->rul->size_room,
                                               (int64_t)t->rul->nsize + 1, sizeof *t->rul->sizes);
        if (status != MUS_OK) return status;
        if (t->rul->nsize == RUL_SIZES)
            return mus__source_fail(t->source, t->line, MUS_ERR_LIMIT, "more than %d sizes", RUL_SIZES);
        t->rul->sizes[t->rul->nsize++] = word;
    }
    return MUS_OK;
}


/* the pairs of one rule, on this line and the next ones */
static mus_status rul_rule(rul_text *t)
{
    mus__rul *rul = t->rul;
    double number;
    if (rul->nrule == RUL_RULES)
        return mus__source_fail(t->source, t->line, MUS_ERR_LIMIT, "more than %d rules", RUL_RULES);
    mus__dxf_slice word = rul_word(t);
    if (word.length > 0 && (*word.at == 'D' || *word.at == 'd')) word = rul_word(t); /* DELTA */
    if (!mus__dxf_number(word, &number) || number != floor(number) || fabs(number) > 1e6)
        return mus__source_fail(t->source, t->line, MUS_ERR_FORMAT, "expected \"RULE: DELTA\" and a number");
    if (rul->nsize == 0)
        return mus__source_fail(t->source, t->line, MUS_ERR_FORMAT, "a rule before the line \"SIZE LIST:\"");
    mus_status status = mus__source_reserve(t->source, &rul->numbers, &rul->number_room, (int64_t)rul->nrule + 1,
                                           sizeof *rul->numbers);
    const int64_t at = 2 * (int64_t)rul->nrule * rul->nsize;
    if (status == MUS_OK)
        status = mus__source_reserve(t->source, &rul->moves, &rul->move_room, at + 2 * rul->nsize, sizeof *rul->moves);
    for (int32_t i = 0; i < 2 * rul->nsize && status == MUS_OK; i++) {
        for (word = rul_word(t); word.length == 0 && *t->at != '\0'; word = rul_word(t)) rul_line_end(t);
        if (!mus__dxf_number(word, &rul->moves[at + i]) || fabs(rul->moves[at + i]) > 1e6)
            return mus__source_fail(t->source, t->line, MUS_ERR_FORMAT, "rule %d: expected %d numbers, got %d",
                                    (int)number, (int)(2 * rul->nsize), (int)i);
        rul->moves[at + i] *= t->unit;
    }
    if (status == MUS_OK) rul->numbers[rul->nrule++] = (int32_t)number;
    return status;
}


/* sums of steps become differences from the sample */
static void rul_differences(mus__rul *rul)
{
    bool steps = false;
    for (int32_t i = 0; i < rul->nrule; i++) {
        const double *pair = rul->moves + 2 * ((size_t)i * (size_t)rul->nsize + (size_t)rul->sample);
        steps = steps || pair[0] != 0.0 || pair[1] != 0.0;
    }
    for (int32_t i = 0; i < rul->nrule && steps; i++) {
        double *pairs = rul->moves + 2 * (size_t)i * (size_t)rul->nsize;
        for (int32_t k = 2; k < 2 * rul->nsize; k++) pairs[k] += pairs[k - 2];
        const double own[2] = {pairs[2 * rul->sample], pairs[2 * rul->sample + 1]};
        for (int32_t k = 0; k < 2 * rul->nsize; k++) pairs[k] -= own[k % 2];
    }
}


static mus_status rul_row(rul_text *t)
{
    static const char *const keys[] = {"UNITS", "SAMPLE SIZE", "SIZE LIST", "RULE"};
    const size_t length = strcspn(t->at, ":\r\n");
    size_t key = 0;
    for (; key < 4 && t->at[length] == ':'; key++) {
        const size_t n = strlen(keys[key]);
        if (length == n && mus__dxf_same((mus__dxf_slice){t->at, (int32_t)n}, (mus__dxf_slice){keys[key], (int32_t)n}))
            break;
    }
    if (t->at[length] != ':') return MUS_OK;
    t->at += length + 1;
    if (key == 0) {
        const mus__dxf_slice word = rul_word(t);
        t->unit = word.length > 0 && (*word.at == 'E' || *word.at == 'e') ? 0.0254 : 1e-3;
    }
    if (key == 1) t->sample = rul_word(t);
    if (key == 2) return rul_sizes(t);
    return key == 3 ? rul_rule(t) : MUS_OK;
}


mus_status mus__rul_load(const mus__source *source, mus__rul *rul)
{
    rul_text t = {.source = source, .rul = rul, .at = source->text, .line = 1, .unit = 1e-3, .sample = {"", 0}};
    memset(rul, 0, sizeof *rul);
    mus_status status = MUS_OK;
    while (*t.at != '\0' && status == MUS_OK) {
        status = rul_row(&t);
        if (status == MUS_OK) rul_line_end(&t);
    }
    if (status != MUS_OK) return status;
    if (rul->nsize == 0 || rul->nrule == 0)
        return mus__source_fail(source, t.line, MUS_ERR_FORMAT,
                                "no rules; expected lines \"SIZE LIST: 36 38 40\" and \"RULE: DELTA 1\"");
    rul->sample = mus__rul_size(rul, t.sample);
    if (rul->sample == MUS_NONE)
        return mus__source_fail(source, 0, MUS_ERR_FORMAT, "the sample size \"%.*s\" is not in the size list",
                                t.sample.length > 40 ? 40 : (int)t.sample.length, t.sample.at);
    rul_differences(rul);
    return MUS_OK;
}
