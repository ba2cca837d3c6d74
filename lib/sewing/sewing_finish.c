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
    bool folded; /* the panel is a strip, turned along its line "fold" */
} finish_edge;

/* edges with the same words: the edges from `first` on */
typedef struct finish_group {
    int32_t first, count;
    bool faced;    /* a panel is sewn on */
    double length; /* [m] of all */
    const char *words;
} finish_group;

/* what is sewn on by the label of the panel, and by a mark that the pattern has where one label serves several; `last`
 * after the edges */
static const struct {
    const char *label, *mark, *key;
    bool last;
} finish_parts[] = {
    {"fly", NULL, "step.fly", false},
    {"loop", NULL, "step.loop", true},
    {"tie", NULL, "step.tie_make", false}, /* of a front that is tied, whose ends are told with its seams */
    {"placket", NULL, "step.sleeve_placket", false},
    {"bag", "pocket opening", "step.front_pocket", false},
    {"bag", "flap", "step.flap", false},
    {"pocket part", "flap", "step.flap", false},
    {"bag", "welt", "step.welt", false},
    {"pocket part", "welt", "step.welt", false},
    {"", NULL, "step.part", false},
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
    for (int32_t i = 0; i < job->sewing.n; i++) { /* the opening of a patch is hemmed before it is laid on */
        const mus__sewn *seam = &job->sewing.sewn[i];
        for (int32_t k = 0; k < mus_pattern_edge_count(pattern) && seam->kind == MUS__SEWING_PATCH; k++)
            if (mus_pattern_edge_panel(pattern, k) == seam->panel[0]) job->free[k] = false;
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
    if (s->folded != t->folded) return s->folded ? 1 : -1;
    if (s->allowance < t->allowance || s->allowance > t->allowance) return s->allowance < t->allowance ? -1 : 1;
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
        const int32_t panel = mus_pattern_edge_panel(job->pattern, i);
        /* a rib is told with its seam, which both its edges are in */
        const bool rib = job->free[i] && mus__tell_copies(job->pattern, panel, MUS_MATERIAL_RIB) > 0;
        if (!job->free[i] || (rib && mus__tell_folded(job->pattern, i))) continue;
        finish_edge *edge = &edges[n++];
        mus__plain_edge_words(job->pattern, i, edge->words);
        mus__plain_words(mus_pattern_panel_name(job->pattern, panel), true, edge->panel);
        edge->length = mus_pattern_edge_length(job->pattern, i);
        edge->allowance = mus_pattern_edge_allowance(job->pattern, i);
        edge->elastic = finish_elastic(job->pattern, i);
        edge->folded = mus__tell_folded(job->pattern, i);
    }
    mus__sort(edges, (size_t)n, sizeof *edges, edge_compare);
    return n;
}


static int32_t finish_groups(const mus__instructions *job, const finish_edge *edges, int32_t n, finish_group *groups)
{
    int32_t count = 0;
    for (int32_t i = 0; i < n; i++) {
        bool faced = false;
        for (int32_t k = 0; k < mus_pattern_panel_count(job->extra) && !faced; k++)
            faced = finish_with(job, k, edges[i].words);
        const finish_edge *last = i > 0 ? &edges[i - 1] : NULL;
        if (last == NULL || strcmp(edges[i].words, last->words) != 0 ||
            (!faced && (edges[i].folded != last->folded || edges[i].allowance > last->allowance ||
                        edges[i].allowance < last->allowance)))
            groups[count++] = (finish_group){i, 0, faced, 0.0, edges[i].words};
        finish_group *group = &groups[count - 1];
        group->count++;
        group->length += edges[i].length;
    }
    mus__sort(groups, (size_t)count, sizeof *groups, group_compare);
    return count;
}


/* the words of a group: those of its edges' label, or their own name where they are turned less than others of that
 * label, as a slit above a hem */
static void group_words(const mus__instructions *job, const finish_edge *edges, const finish_group *group, char *out)
{
    const finish_edge *first = &edges[group->first];
    const bool bare = strcmp(first->words, first->panel) == 0;
    bool named = false, less = false;
    char name[MUS__PLAIN] = "", words[MUS__PLAIN];
    for (int32_t i = 0; i < mus_pattern_edge_count(job->pattern); i++) {
        if (!job->free[i]) continue;
        mus__plain_edge_words(job->pattern, i, words);
        if (strcmp(words, first->words) != 0) continue;
        const double allowance = mus_pattern_edge_allowance(job->pattern, i);
        less = less || allowance > first->allowance;
        if (allowance < first->allowance || allowance > first->allowance) continue;
        mus__plain_edge_name(job->pattern, i, words);
        named = name[0] == '\0' || strcmp(name, words) == 0;
        if (!named) break;
        memcpy(name, words, sizeof name);
    }
    mus__tell_words(job, "edge", less && named && name[0] != '\0' ? name : bare ? "free edge" : first->words, out);
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
        if (mus__tell_copies(job->extra, i, MUS_MATERIAL_RIB) > 0) rib = fmax(rib, mus__tell_edge(job->extra, i, true));
    }
    const bool several = job->list.n > 1;
    char *list = mus__list_take(job, "panel");
    if (list == NULL) return;
    mus__phrase_text(phrase, place, list);
    mus__phrase_text(phrase, place + 1, mus__tell_length(job, rib, length));
    snprintf(full, sizeof full, "%s%s", key, rib > 0.0 ? "_rib" : several ? "_joined" : "");
    mus__tell_step(job, phrase, full);
    mus__print_free(job->sink.context, list);
}


/* write how deep free edges are turned; "" where the sheet sets the depth, or where it is 0 */
static void tell_depth(const mus__instructions *job, const finish_edge *edge, char *out)
{
    mus__phrase phrase = mus__phrase_in(job->language);
    out[0] = '\0';
    if (!(edge->allowance > 0.0)) return;
    mus__phrase_number(&phrase, 0, lround(1e3 * edge->allowance));
    mus__phrase_write(&phrase, "depth", out, MUS__LENGTH);
}


static void tell_group_step(mus__instructions *job, const finish_edge *edges, const finish_group *group)
{
    const finish_edge *first = &edges[group->first];
    const char *comma = mus_language_text(job->language, "list.comma");
    char told[MUS__PLAIN], words[MUS__PLAIN], depth[MUS__LENGTH], length[MUS__LENGTH];
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
    group_words(job, edges, group, words);
    mus__phrase_text(&phrase, 0, words);
    mus__phrase_text(&phrase, 1, panels.bytes);
    mus__phrase_text(&phrase, 2, mus__tell_length(job, group->length, length));
    tell_depth(job, first, depth);
    mus__phrase_text(&phrase, 3, first->folded ? mus_language_text(job->language, "mark.fold") : depth);
    if (group->faced) tell_facings(job, first->words, &phrase, "step.faced", 3);
    else if (first->folded)
        mus__tell_step(job, &phrase, elastic ? "step.fold_elastic" : "step.fold");
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


/* is a label that of row k of finish_parts? */
static bool part_is(const mus__instructions *job, int32_t k, const char *label)
{
    int32_t i = 0;
    if (strcmp(finish_parts[k].label, label) != 0) return false;
    if (strcmp(label, "tie") == 0) return part_tied(job);
    if (finish_parts[k].mark == NULL) return true;
    while (i < mus_pattern_panel_count(job->pattern) && !mus__tell_has_mark(job->pattern, i, finish_parts[k].mark)) i++;
    return i < mus_pattern_panel_count(job->pattern);
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
    int32_t k = 0;
    while (k < parts - 1 && !part_is(job, k, label)) k++;
    for (int32_t first = 0; first < k; first++) /* parts of one step */
        if (strcmp(finish_parts[first].key, finish_parts[k].key) == 0) return first;
    return k;
}


void mus__tell_parts(mus__instructions *job, bool last)
{
    mus__phrase phrase = mus__phrase_in(job->language);
    mus__phrase_text(&phrase, 1, mus_language_text(job->language, "mark.pocket opening"));
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


/* the step that joins a panel to its mirror image, and is sewn in each layer; MUS_NONE without one */
static int32_t layer_own(const mus__instructions *job, int32_t panel, bool *before)
{
    int32_t line = MUS_NONE, image = MUS_NONE, own = MUS_NONE, step = MUS_NONE;
    *before = true;
    mus_pattern_cut(job->pattern, panel, NULL, &image);
    for (int32_t i = 0; i < job->sewing.n; i++) {
        const mus__sewn *seam = job->sewing.by_words[i];
        if (seam->kind != MUS__SEWING_SEAM || (seam->panel[0] != panel && seam->panel[1] != panel)) continue;
        const int32_t other = seam->panel[seam->panel[0] == panel];
        mus_pattern_cut(job->pattern, other, NULL, &own);
        if (image == other || own == panel) {
            step = seam->step > step ? seam->step : step;
            continue;
        }
        *before = *before && (line == MUS_NONE || line == seam->line);
        line = seam->line;
    }
    return step;
}


/* how the second layer of a panel is sewn, NULL without one: before the seam where one line of stitching holds the
 * panel, with or without its mirror image, as a collar; else after the seams, a lining to what is finished too */
static const char *layer_step(const mus__instructions *job, int32_t panel)
{
    bool before;
    if (!mus__tell_double(job->pattern, panel)) return NULL;
    layer_own(job, panel, &before);
    if (before) return "step.layers_first";
    if (mus__tell_has_mark(job->pattern, panel, "stand end")) return "step.stand";
    return mus__tell_copies(job->pattern, panel, MUS_MATERIAL_LINING) > 0 ? "step.linings" : "step.layers";
}


/* is the second layer of a panel sewn by the row of a key, and after a step? */
static bool layer_is(const mus__instructions *job, int32_t panel, const char *key, int32_t step)
{
    bool before;
    const char *own = panel != MUS_NONE ? layer_step(job, panel) : NULL;
    return own != NULL && strcmp(own, key) == 0 && (layer_own(job, panel, &before) == step || !before);
}


void mus__tell_layers(mus__instructions *job, const char *key, int32_t step)
{
    mus__phrase phrase = mus__phrase_in(job->language);
    const int32_t edges = mus_pattern_edge_count(job->pattern);
    for (int32_t i = 0; i < edges; i++) {
        const int32_t panel = mus_pattern_edge_panel(job->pattern, i), seam = mus_pattern_edge_seam(job->pattern, i);
        mus_seam_def def;
        mus_seam_def_init(&def, sizeof def);
        if (!layer_is(job, panel, key, step)) continue;
        const bool free = seam == MUS_NONE ||
                          (mus_pattern_seam(job->pattern, seam, &def) == MUS_OK && def.closure == MUS_CLOSURE_BUTTONS);
        if (free && !finish_hem(job->pattern, i)) mus__list_add_edge(job, i);
    }
    char *along = mus__list_take(job, "edge");
    if (along == NULL) return;
    for (int32_t i = 0; i < mus_pattern_panel_count(job->pattern); i++) {
        const int32_t layer = mus__tell_layer(job->pattern, i);
        if (!layer_is(job, i, key, step)) continue;
        mus__list_add(job, job->pattern, i);
        if (layer != MUS_NONE) mus__list_add(job, job->extra, layer);
    }
    mus__phrase_text(&phrase, 1, along);
    mus__phrase_text(&phrase, 2, mus_language_text(job->language, "mark.stand end"));
    mus__list_step(job, &phrase, key);
    mus__print_free(job->sink.context, along);
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
        tell_over_seams(job);
        mus__tell_layers(job, "step.stand", MUS_NONE);
        mus__tell_layers(job, "step.layers", MUS_NONE);
        for (int32_t i = 0; i < n; i++) tell_group_step(job, edges, &groups[i]);
        mus__tell_layers(job, "step.linings", MUS_NONE);
        tell_elastic(job);
        mus__tell_parts(job, true);
    }
    mus__print_free(context, groups);
    mus__print_free(context, edges);
    return status;
}
