/*
 * sewing_list.c: what the sentences of the instructions share: lengths, lists of words, and facts of panels.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/sort.h"
#include "sewing/sewing_text.h"


const char *mus__tell_length(const mus__instructions *job, double length, char *out)
{
    const long tenths = lround(1e3 * length);
    mus__phrase phrase = mus__phrase_in(job->language);
    mus__phrase_number(&phrase, 0, tenths / 10);
    mus__phrase_number(&phrase, 1, tenths % 10);
    mus__phrase_write(&phrase, "length", out, MUS__LENGTH);
    return out;
}


const char *mus__tell_words(const mus__instructions *job, const char *kind, const char *words, char *out)
{
    mus__plain_words_in(job->language, kind, words, out);
    return out;
}


void mus__tell_step(mus__instructions *job, const mus__phrase *phrase, const char *key)
{
    mus__sink_print(&job->sink, "%d. ", (int)++job->number);
    mus__phrase_add(phrase, key, &job->sink);
    mus__sink_print(&job->sink, "\n");
}


/* ---- lists ---- */

void mus__list_add(mus__instructions *job, const mus_pattern *pattern, int32_t panel)
{
    mus__plain_words(mus_pattern_panel_name(pattern, panel), true, job->list.words[job->list.n++]);
}


static int list_compare(const void *a, const void *b)
{
    return strcmp(a, b);
}


/* length of words without a number at their end */
static size_t list_stem(const char *words)
{
    size_t n = strlen(words);
    while (n > 0 && ((words[n - 1] >= '0' && words[n - 1] <= '9') || words[n - 1] == ' ')) n--;
    return n > 0 ? n : strlen(words);
}


void mus__list_add_edge(mus__instructions *job, int32_t edge)
{
    char words[MUS__PLAIN];
    mus__plain_edge_words(job->pattern, edge, words);
    for (int32_t i = 0; i < job->list.n; i++)
        if (strcmp(job->list.words[i], words) == 0) return;
    memcpy(job->list.words[job->list.n++], words, sizeof words);
}


char *mus__list_take(mus__instructions *job, const char *kind)
{
    char(*words)[MUS__PLAIN] = job->list.words, stem[MUS__PLAIN], told[MUS__PLAIN];
    const char *comma = mus_language_text(job->language, "list.comma");
    mus__sink text;
    mus__sink_init(&text, job->sink.context);
    mus__sort(words, (size_t)job->list.n, sizeof *words, list_compare);
    for (int32_t i = 0, last = 0; i < job->list.n; i++) {
        const size_t size = list_stem(words[i]);
        if (i > 0 && size == list_stem(words[last]) && strncmp(words[i], words[last], size) == 0) continue;
        snprintf(stem, sizeof stem, "%.*s", (int)size, words[i]);
        mus__sink_print(&text, "%s%s", i > 0 ? comma : "", mus__tell_words(job, kind, stem, told));
        last = i;
    }
    job->list.n = 0;
    mus__sink_add(&text, "", 1);
    if (text.status == MUS_OK) return text.bytes;
    if (job->sink.status == MUS_OK) job->sink.status = text.status;
    mus__sink_free(&text);
    return NULL;
}


void mus__list_step(mus__instructions *job, mus__phrase *phrase, const char *key)
{
    if (job->list.n == 0) return;
    char *list = mus__list_take(job, "panel");
    if (list == NULL) return;
    mus__phrase_text(phrase, 0, list);
    mus__tell_step(job, phrase, key);
    mus__print_free(job->sink.context, list);
}


/* ---- panels ---- */

int32_t mus__tell_copies(const mus_pattern *pattern, int32_t panel, int32_t material)
{
    int32_t image = MUS_NONE, copies = 0;
    mus_pattern_cut(pattern, panel, NULL, &image);
    mus_pattern_material(pattern, image != MUS_NONE ? image : panel, material, &copies, NULL);
    return copies;
}


bool mus__tell_printed(const mus_pattern *pattern, int32_t panel)
{
    int32_t image = MUS_NONE;
    mus_pattern_cut(pattern, panel, NULL, &image);
    return image == MUS_NONE;
}


bool mus__tell_mirrored(const mus_pattern *pattern, int32_t panel)
{
    int32_t mirrored = 0;
    mus_pattern_material(pattern, panel, MUS_MATERIAL_MAIN, NULL, &mirrored);
    return mirrored != 0 || !mus__tell_printed(pattern, panel);
}


int32_t mus__tell_layer(const mus_pattern *pattern, int32_t panel)
{
    const mus_pattern *extra = mus_pattern_cut_only(pattern);
    const char *own = mus_pattern_panel_name(pattern, panel);
    for (int32_t i = 0; i < mus_pattern_panel_count(extra); i++) {
        const char *name = mus_pattern_panel_name(extra, i);
        const size_t n = strlen(name), m = strlen(own);
        const bool layer = strcmp(mus_pattern_panel_label(extra, i), "layer") == 0;
        if (layer && n > m && strcmp(name + n - m, own) == 0) return i;
    }
    return MUS_NONE;
}


bool mus__tell_double(const mus_pattern *pattern, int32_t panel)
{
    return mus__tell_copies(pattern, panel, MUS_MATERIAL_MAIN) > (mus__tell_mirrored(pattern, panel) ? 2 : 1) ||
           mus__tell_copies(pattern, panel, MUS_MATERIAL_LINING) > 0 || mus__tell_layer(pattern, panel) != MUS_NONE;
}


double mus__tell_edge(const mus_pattern *pattern, int32_t panel, bool longest)
{
    double found = longest ? 0.0 : HUGE_VAL;
    for (int32_t i = 0; i < mus_pattern_edge_count(pattern); i++) {
        if (mus_pattern_edge_panel(pattern, i) != panel) continue;
        const double length = mus_pattern_edge_length(pattern, i);
        found = longest ? fmax(found, length) : fmin(found, length);
    }
    return found;
}


bool mus__tell_has_mark(const mus_pattern *pattern, int32_t panel, const char *mark)
{
    for (int32_t i = 0; i < mus_pattern_mark_count(pattern); i++) {
        int32_t own;
        const char *name;
        if (mus_pattern_mark(pattern, i, &own, &name, NULL, NULL) == MUS_OK && own == panel && strcmp(name, mark) == 0)
            return true;
    }
    return false;
}


/* is an edge of a strip turned by more than a hem as high as the strip could be? */
static bool list_strip(const mus_pattern *pattern, int32_t edge)
{
    int32_t n = 0, side = MUS_NONE;
    const int32_t *edges;
    if (mus_pattern_outline(pattern, mus_pattern_edge_panel(pattern, edge), &n, &edges, NULL) != MUS_OK) return false;
    for (int32_t i = 0; i < n; i++)
        if (edges[i] == edge) side = edges[(i + 1) % n];
    return side != MUS_NONE && mus_pattern_edge_allowance(pattern, edge) > mus_pattern_edge_length(pattern, side);
}


bool mus__tell_folded(const mus_pattern *pattern, int32_t edge)
{
    return mus__tell_has_mark(pattern, mus_pattern_edge_panel(pattern, edge), "fold") && list_strip(pattern, edge);
}


bool mus__tell_rib_folds(const mus__instructions *job, int32_t panel, int32_t other)
{
    int32_t n = 0;
    const int32_t *edges;
    if (mus__tell_copies(job->pattern, panel, MUS_MATERIAL_RIB) == 0 ||
        mus__tell_copies(job->pattern, other, MUS_MATERIAL_RIB) > 0 ||
        mus_pattern_outline(job->pattern, panel, &n, &edges, NULL) != MUS_OK)
        return false;
    for (int32_t i = 0; i < n; i++)
        if (job->free[edges[i]] && mus__tell_folded(job->pattern, edges[i])) return true;
    return false;
}
