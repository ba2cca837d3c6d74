/*
 * sewing_finish.c: the steps after the seams: facings, ribs and hems at the free edges, elastic, and what else is cut
 * and not draped.
 *
 * A panel that is cut and not draped finishes the edges of one label: those that it copies (a facing), or those whose
 * label its own name starts with (a rib: "neckband" at the "neck"). Where those edges are free it is sewn to them;
 * where they are in a seam, as under a collar that lies flat, it is sewn over the seam.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/sort.h"
#include "sewing/sewing_text.h"

/* a free edge; its words say what is finished, those of its panel where */
typedef struct finish_edge {
    char words[MUS__PLAIN], panel[MUS__PLAIN];
    double length;    /* [m] */
    double allowance; /* [m], NaN where it is left to the sheet */
    bool elastic;
} finish_edge;

/* edges with the same words: the edges from `first` on */
typedef struct finish_group {
    int32_t first, count;
    bool faced;    /* a panel is sewn on */
    double length; /* [m] of all */
    const char *words;
} finish_group;

/* what is sewn on by the label of the panel; `last` after the edges */
static const struct {
    const char *label, *key;
    bool last;
} finish_parts[] = {
    {"fly", "step.fly", false},
    {"loop", "step.loop", true},
    {"tie", "step.tie_make", false}, /* of a front that is tied, whose ends are told with its seams */
    {"", "step.part", false},
};


/* does a panel of `extra` finish edges with the words? */
static bool finish_with(const mus__instructions *job, int32_t panel, const char *words)
{
    return words[0] != '\0' && strcmp(job->finishes[panel], words) == 0;
}


/* is an edge of a facing the copy of one of the pattern's, and not the part of one that is as long as it is wide? */
static bool facing_copies(const mus__instructions *job, int32_t edge)
{
    const char *label = mus_pattern_edge_label(job->extra, edge), *name = mus_pattern_edge_name(job->extra, edge);
    const double length = mus_pattern_edge_length(job->extra, edge);
    mus_seam_def seam;
    mus_seam_def_init(&seam, sizeof seam); /* a copy is as long as what a seam would take */
    for (int32_t i = 0; i < mus_pattern_edge_count(job->pattern) && label[0] != '\0'; i++)
        if (strcmp(mus_pattern_edge_label(job->pattern, i), label) == 0 &&
            strcmp(mus_pattern_edge_name(job->pattern, i), name) == 0 &&
            fabs(mus_pattern_edge_length(job->pattern, i) - length) <= seam.tolerance)
            return true;
    return false;
}


/* is an edge a hem of body or sleeve, which is turned up whether the panel is lined or not? */
static bool finish_hem(const mus_pattern *pattern, int32_t edge)
{
    const char *label = mus_pattern_edge_label(pattern, edge);
    return strcmp(label, "hem") == 0 || strcmp(label, "cuff") == 0;
}


void mus__finish_find(mus__instructions *job)
{
    const mus_pattern *extra = job->extra, *pattern = job->pattern;
    for (int32_t i = 0; i < mus_pattern_edge_count(pattern); i++) {
        const int32_t panel = mus_pattern_edge_panel(pattern, i);
        job->free[i] = panel != MUS_NONE && mus_pattern_edge_seam(pattern, i) == MUS_NONE &&
                       job->sewing.passes[i] < 2 && (finish_hem(pattern, i) || !mus__tell_double(pattern, panel));
    }
    for (int32_t i = 0; i < mus_pattern_edge_count(extra); i++) {
        const int32_t panel = mus_pattern_edge_panel(extra, i);
        if (panel == MUS_NONE || strcmp(mus_pattern_panel_label(extra, panel), "facing") != 0) continue;
        if (job->finishes[panel][0] == '\0' && facing_copies(job, i))
            mus__plain_edge_words(extra, i, job->finishes[panel]);
    }
    for (int32_t i = 0; i < mus_pattern_panel_count(extra); i++) {
        const char *name = mus_pattern_panel_name(extra, i);
        size_t longest = 0;
        if (strcmp(mus_pattern_panel_label(extra, i), "rib") != 0) continue;
        for (int32_t k = 0; k < mus_pattern_edge_count(pattern); k++) {
            const char *label = mus_pattern_edge_label(pattern, k);
            const size_t size = strlen(label);
            if (size <= longest || strncmp(name, label, size) != 0) continue;
            longest = size;
            mus__plain_edge_words(pattern, k, job->finishes[i]);
        }
    }
}


static bool finish_elastic(const mus_pattern *pattern, int32_t edge)
{
    double stiffness = 0.0;
    return mus_pattern_edge_elastic(pattern, edge, NULL, &stiffness) == MUS_OK && stiffness > 0.0;
}


/* ---- free edges ---- */

static int edge_compare(const void *a, const void *b)
{
    const finish_edge *s = a, *t = b;
    const int order = strcmp(s->words, t->words);
    if (order != 0) return order;
    const int panels = strcmp(s->panel, t->panel);
    return panels != 0 ? panels : (s->length > t->length) - (s->length < t->length);
}


/* panels are sewn on before edges are turned, and the shortest edges come first */
static int group_compare(const void *a, const void *b)
{
    const finish_group *s = a, *t = b;
    if (s->faced != t->faced) return t->faced - s->faced;
    const long shorter = lround(1e3 * s->length) - lround(1e3 * t->length);
    return shorter != 0 ? (shorter > 0) - (shorter < 0) : strcmp(s->words, t->words);
}


/* write all free edges, sorted, to `edges`; returns their number */
static int32_t finish_edges(const mus__instructions *job, finish_edge *edges)
{
    int32_t n = 0;
    for (int32_t i = 0; i < mus_pattern_edge_count(job->pattern); i++) {
        if (!job->free[i]) continue;
        finish_edge *edge = &edges[n++];
        const int32_t panel = mus_pattern_edge_panel(job->pattern, i);
        mus__plain_edge_words(job->pattern, i, edge->words);
        mus__plain_words(mus_pattern_panel_name(job->pattern, panel), true, edge->panel);
        edge->length = mus_pattern_edge_length(job->pattern, i);
        edge->allowance = mus_pattern_edge_allowance(job->pattern, i);
        edge->elastic = finish_elastic(job->pattern, i);
    }
    mus__sort(edges, (size_t)n, sizeof *edges, edge_compare);
    return n;
}


static int32_t finish_groups(const mus__instructions *job, const finish_edge *edges, int32_t n, finish_group *groups)
{
    int32_t count = 0;
    for (int32_t i = 0; i < n; i++) {
        if (i == 0 || strcmp(edges[i].words, edges[i - 1].words) != 0)
            groups[count++] = (finish_group){i, 0, false, 0.0, edges[i].words};
        finish_group *group = &groups[count - 1];
        group->count++;
        group->length += edges[i].length;
        for (int32_t k = 0; k < mus_pattern_panel_count(job->extra) && !group->faced; k++)
            group->faced = finish_with(job, k, edges[i].words);
    }
    mus__sort(groups, (size_t)count, sizeof *groups, group_compare);
    return count;
}


/* write the step of panels that are sewn to edges with the words: `key`, with the panels in `place`, and the length
 * of a rib in the next. Panels that are several are joined first */
static void tell_facings(mus__instructions *job, const char *words, mus__phrase *phrase, const char *key, int32_t place)
{
    double rib = 0.0;
    char full[64], length[MUS__LENGTH];
    for (int32_t i = 0; i < mus_pattern_panel_count(job->extra); i++) {
        if (!finish_with(job, i, words)) continue;
        mus__list_add(job, job->extra, i);
        if (mus__tell_copies(job->extra, i, MUS_MATERIAL_RIB) > 0) rib = fmax(rib, mus__tell_longest(job->extra, i));
    }
    const bool several = job->list.n > 1;
    char *list = mus__list_take(job);
    if (list == NULL) return;
    mus__phrase_text(phrase, place, list);
    mus__phrase_text(phrase, place + 1, mus__tell_length(job, rib, length));
    snprintf(full, sizeof full, "%s%s", key, rib > 0.0 ? "_rib" : several ? "_joined" : "");
    mus__tell_step(job, phrase, full);
    mus__print_free(job->sink.context, list);
}


/* write how deep free edges are turned; "" where the sheet sets the depth of one, or where it is 0 */
static void tell_depth(const mus__instructions *job, const finish_edge *edges, int32_t count, char *out)
{
    double least = HUGE_VAL, most = 0.0;
    bool known = true;
    for (int32_t i = 0; i < count; i++) {
        known = known && !isnan(edges[i].allowance);
        least = fmin(least, edges[i].allowance);
        most = fmax(most, edges[i].allowance);
    }
    const long low = lround(1e3 * least), high = lround(1e3 * most);
    mus__phrase phrase = mus__phrase_in(job->language);
    mus__phrase_number(&phrase, 0, low < high ? low : high);
    mus__phrase_number(&phrase, 1, high);
    out[0] = '\0';
    if (known && most > 0.0) mus__phrase_write(&phrase, low < high ? "depth.range" : "depth", out, 2 * MUS__LENGTH);
}


static void tell_group_step(mus__instructions *job, const finish_edge *edges, const finish_group *group)
{
    const finish_edge *first = &edges[group->first];
    const char *comma = mus_language_text(job->language, "list.comma");
    const bool bare = strcmp(first->words, first->panel) == 0;
    char told[MUS__PLAIN], words[MUS__PLAIN], depth[2 * MUS__LENGTH], length[MUS__LENGTH];
    bool elastic = false;
    mus__sink panels;
    mus__sink_init(&panels, job->sink.context);
    for (int32_t i = 0; i < group->count; i++) {
        if (i == 0 || strcmp(first[i].panel, first[i - 1].panel) != 0)
            mus__sink_print(&panels, "%s%s", i > 0 ? comma : "", mus__tell_words(job, "panel", first[i].panel, told));
        elastic = elastic || first[i].elastic;
    }
    mus__sink_add(&panels, "", 1);
    if (panels.status != MUS_OK) {
        if (job->sink.status == MUS_OK) job->sink.status = panels.status;
        mus__sink_free(&panels);
        return;
    }
    mus__phrase phrase = mus__phrase_in(job->language);
    mus__phrase_text(&phrase, 0, mus__tell_words(job, "edge", bare ? "free edge" : first->words, words));
    mus__phrase_text(&phrase, 1, panels.bytes);
    mus__phrase_text(&phrase, 2, mus__tell_length(job, group->length, length));
    tell_depth(job, first, group->count, depth);
    mus__phrase_text(&phrase, 3, depth);
    if (group->faced) tell_facings(job, first->words, &phrase, "step.faced", 3);
    else if (depth[0] != '\0') mus__tell_step(job, &phrase, elastic ? "step.hem_elastic" : "step.hem");
    else mus__tell_step(job, &phrase, elastic ? "step.turn_elastic" : "step.turn");
    mus__sink_free(&panels);
}


/* ---- other parts ---- */

/* has the pattern edges that a panel finishes, free or in a seam? */
static bool part_edges(const mus__instructions *job, int32_t panel, bool free)
{
    for (int32_t i = 0; i < mus_pattern_edge_count(job->pattern) && job->finishes[panel][0] != '\0'; i++) {
        char words[MUS__PLAIN];
        if (job->free[i] != free) continue;
        mus__plain_edge_words(job->pattern, i, words);
        if (finish_with(job, panel, words)) return true;
    }
    return false;
}


/* has the garment a front that is tied? */
static bool part_tied(const mus__instructions *job)
{
    int32_t i = 0;
    while (i < job->sewing.n && job->sewing.sewn[i].kind != MUS__SEWING_TIES) i++;
    return i < job->sewing.n;
}


/* place in finish_parts of a panel that no edge or mark asks for; MUS_NONE for all others */
static int32_t part_of(const mus__instructions *job, int32_t panel)
{
    const int32_t parts = (int32_t)(sizeof finish_parts / sizeof finish_parts[0]);
    const char *label = mus_pattern_panel_label(job->extra, panel), *name;
    int32_t worn = 0;
    for (int32_t m = 0; m < MUS_MATERIAL_COUNT; m++)
        if (m != MUS_MATERIAL_INTERFACING && m != MUS_MATERIAL_ELASTIC) worn += mus__tell_copies(job->extra, panel, m);
    if (strcmp(label, "layer") == 0) return MUS_NONE; /* told with the second layers */
    if (worn == 0 || part_edges(job, panel, true) || part_edges(job, panel, false)) return MUS_NONE;
    for (int32_t i = 0; i < mus_pattern_mark_count(job->pattern); i++)
        if (mus_pattern_mark(job->pattern, i, NULL, &name, NULL, NULL) == MUS_OK && strcmp(name, label) == 0)
            return MUS_NONE;
    for (int32_t k = 0; k < parts - 1; k++)
        if (strcmp(finish_parts[k].label, label) == 0 && (strcmp(label, "tie") != 0 || part_tied(job))) return k;
    return parts - 1;
}


void mus__tell_parts(mus__instructions *job, bool last)
{
    mus__phrase phrase = mus__phrase_in(job->language);
    for (int32_t k = 0; k < (int32_t)(sizeof finish_parts / sizeof finish_parts[0]); k++) {
        if (finish_parts[k].last != last) continue;
        for (int32_t i = 0; i < mus_pattern_panel_count(job->extra); i++)
            if (part_of(job, i) == k) mus__list_add(job, job->extra, i);
        mus__list_step(job, &phrase, finish_parts[k].key);
    }
}


/* facings over seams, each kind of edge once: the first of its panels tells them */
static void tell_over_seams(mus__instructions *job)
{
    for (int32_t i = 0; i < mus_pattern_panel_count(job->extra); i++) {
        int32_t first = 0;
        if (part_edges(job, i, true) || !part_edges(job, i, false)) continue;
        while (!finish_with(job, first, job->finishes[i])) first++;
        if (first < i) continue;
        char words[MUS__PLAIN];
        mus__phrase phrase = mus__phrase_in(job->language);
        mus__phrase_text(&phrase, 0, mus__tell_words(job, "edge", job->finishes[i], words));
        tell_facings(job, job->finishes[i], &phrase, "step.over", 1);
    }
}


/* an elastic that lies in no free edge: at the first of its edges by words */
static void tell_elastic(mus__instructions *job)
{
    char least[MUS__PLAIN] = "", words[MUS__PLAIN];
    for (int32_t i = 0; i < mus_pattern_edge_count(job->pattern); i++) {
        if (!finish_elastic(job->pattern, i)) continue;
        if (job->free[i]) return;
        mus__plain_edge_words(job->pattern, i, words);
        if (least[0] == '\0' || strcmp(words, least) < 0) memcpy(least, words, sizeof least);
    }
    if (least[0] == '\0') return;
    mus__phrase phrase = mus__phrase_in(job->language);
    mus__phrase_text(&phrase, 0, mus__tell_words(job, "edge", least, words));
    mus__tell_step(job, &phrase, "step.elastic");
}


/* pieces of two layers: the second ones go on when the first ones are sewn */
static void tell_layers(mus__instructions *job)
{
    for (int32_t i = 0; i < mus_pattern_panel_count(job->pattern); i++)
        if (mus__tell_double(job->pattern, i)) {
            const int32_t layer = mus__tell_layer(job->pattern, i);
            mus__list_add(job, layer != MUS_NONE ? job->extra : job->pattern, layer != MUS_NONE ? layer : i);
        }
    mus__phrase phrase = mus__phrase_in(job->language);
    mus__list_step(job, &phrase, "step.layers");
}


mus_status mus__tell_finish(mus__instructions *job)
{
    mus_context *context = job->sink.context;
    const int32_t most = mus_pattern_edge_count(job->pattern);
    finish_edge *edges = mus__print_new(context, most, sizeof *edges);
    finish_group *groups = mus__print_new(context, most, sizeof *groups);
    const mus_status status = edges != NULL && groups != NULL ? MUS_OK : mus__print_memory(context, "the instructions");
    if (status == MUS_OK) {
        const int32_t n = finish_groups(job, edges, finish_edges(job, edges), groups);
        tell_layers(job);
        tell_over_seams(job);
        for (int32_t i = 0; i < n; i++) tell_group_step(job, edges, &groups[i]);
        tell_elastic(job);
        mus__tell_parts(job, true);
    }
    mus__print_free(context, groups);
    mus__print_free(context, edges);
    return status;
}
