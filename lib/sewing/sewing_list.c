/*
 * sewing_list.c: what the sentences of the instructions share: lengths, lists of words, and facts of panels.
 */
#include <math.h>
#include <string.h>

#include "base/sort.h"
#include "sewing/sewing_text.h"


void mus__tell_length(mus__sink *sink, double length)
{
    const long tenths = lround(1e3 * length);
    mus__sink_print(sink, "%ld.%ld cm", tenths / 10, tenths % 10);
}


/* ---- lists ---- */

void mus__list_add(mus__instructions *job, const mus_pattern *pattern, int32_t panel)
{
    mus__sewing_words(mus_pattern_panel_name(pattern, panel), true, job->list.words[job->list.n++]);
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


void mus__list_tell(mus__instructions *job)
{
    char(*words)[MUS__WORDS] = job->list.words;
    mus__sort(words, (size_t)job->list.n, sizeof *words, list_compare);
    for (int32_t i = 0, last = 0; i < job->list.n; i++) {
        const size_t size = list_stem(words[i]);
        if (i > 0 && size == list_stem(words[last]) && strncmp(words[i], words[last], size) == 0) continue;
        mus__sink_print(&job->sink, "%s%.*s", i > 0 ? ", " : "", (int)size, words[i]);
        last = i;
    }
    job->list.n = 0;
}


void mus__list_step(mus__instructions *job, const char *head, const char *tail)
{
    if (job->list.n == 0) return;
    mus__sink_print(&job->sink, "%d. %s: ", (int)++job->number, head);
    mus__list_tell(job);
    mus__sink_print(&job->sink, ".%s\n", tail);
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


double mus__tell_longest(const mus_pattern *pattern, int32_t panel)
{
    double longest = 0.0;
    for (int32_t i = 0; i < mus_pattern_edge_count(pattern); i++)
        if (mus_pattern_edge_panel(pattern, i) == panel) longest = fmax(longest, mus_pattern_edge_length(pattern, i));
    return longest;
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
