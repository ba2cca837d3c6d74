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
#include "sewing/sewing.h"

/* a free edge; its words say what is finished, those of its panel where */
typedef struct finish_edge {
    char words[MUS__WORDS], panel[MUS__WORDS];
    const char *label; /* of the pattern */
    double length;     /* [m] */
    double allowance;  /* [m], NaN where it is left to the sheet */
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
    const char *label, *text;
    bool last;
} finish_parts[] = {
    {"fly", "Sew the parts of the fly to the edges of its opening", false},
    {"loop", "Fold the strip lengthwise, stitch it, cut it in equal loops, and sew them over the band", true},
    {"", "Make up and sew on", false},
};


/* does a panel of `extra` finish edges with the label? */
static bool finish_with(const mus__instructions *job, int32_t panel, const char *label)
{
    return label[0] != '\0' && strcmp(job->finishes[panel], label) == 0;
}


/* is an edge of a facing the copy of one of the pattern's, and not the part of one that is as long as it is wide? */
static bool facing_copies(const mus__instructions *job, int32_t edge)
{
    const char *label = mus_pattern_edge_label(job->extra, edge), *name = mus_pattern_edge_name(job->extra, edge);
    const long length = lround(1e4 * mus_pattern_edge_length(job->extra, edge));
    for (int32_t i = 0; i < mus_pattern_edge_count(job->pattern) && label[0] != '\0'; i++)
        if (strcmp(mus_pattern_edge_label(job->pattern, i), label) == 0 &&
            strcmp(mus_pattern_edge_name(job->pattern, i), name) == 0 &&
            lround(1e4 * mus_pattern_edge_length(job->pattern, i)) == length)
            return true;
    return false;
}


void mus__finish_find(mus__instructions *job)
{
    const mus_pattern *extra = job->extra;
    for (int32_t i = 0; i < mus_pattern_panel_count(extra); i++) job->finishes[i] = "";
    for (int32_t i = 0; i < mus_pattern_edge_count(extra); i++) {
        const int32_t panel = mus_pattern_edge_panel(extra, i);
        if (panel == MUS_NONE || strcmp(mus_pattern_panel_label(extra, panel), "facing") != 0) continue;
        if (job->finishes[panel][0] == '\0' && facing_copies(job, i))
            job->finishes[panel] = mus_pattern_edge_label(extra, i);
    }
    for (int32_t i = 0; i < mus_pattern_panel_count(extra); i++) {
        const char *name = mus_pattern_panel_name(extra, i);
        if (strcmp(mus_pattern_panel_label(extra, i), "rib") != 0) continue;
        for (int32_t k = 0; k < mus_pattern_edge_count(job->pattern); k++) {
            const char *label = mus_pattern_edge_label(job->pattern, k);
            if (strlen(label) > strlen(job->finishes[i]) && strncmp(name, label, strlen(label)) == 0)
                job->finishes[i] = label;
        }
    }
}


/* is an edge one that is finished for itself: cut, in no seam, and of one layer? */
static bool finish_free(const mus_pattern *pattern, int32_t edge)
{
    return mus_pattern_edge_panel(pattern, edge) != MUS_NONE && mus_pattern_edge_seam(pattern, edge) == MUS_NONE &&
           !mus__sewing_inner(pattern, edge) && !mus__tell_double(pattern, mus_pattern_edge_panel(pattern, edge));
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
        if (!finish_free(job->pattern, i)) continue;
        finish_edge *edge = &edges[n++];
        const int32_t panel = mus_pattern_edge_panel(job->pattern, i);
        mus__sewing_edge_words(job->pattern, i, edge->words);
        mus__sewing_words(mus_pattern_panel_name(job->pattern, panel), true, edge->panel);
        edge->label = mus_pattern_edge_label(job->pattern, i);
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
            group->faced = finish_with(job, k, edges[i].label);
    }
    mus__sort(groups, (size_t)count, sizeof *groups, group_compare);
    return count;
}


/* write the panels that are sewn to edges with the label; of a rib also its length */
static void tell_facings(mus__instructions *job, const char *label)
{
    double rib = 0.0;
    for (int32_t i = 0; i < mus_pattern_panel_count(job->extra); i++) {
        if (!finish_with(job, i, label)) continue;
        mus__list_add(job, job->extra, i);
        if (mus__tell_copies(job->extra, i, MUS_MATERIAL_RIB) > 0) rib = mus__tell_longest(job->extra, i);
    }
    mus__list_tell(job);
    if (rib == 0.0) return;
    mus__sink_print(&job->sink, ", ");
    mus__tell_length(&job->sink, rib);
    mus__sink_print(&job->sink, " long, closed to a ring, folded and stretched");
}


static void tell_group_step(mus__instructions *job, const finish_edge *edges, const finish_group *group)
{
    const finish_edge *first = &edges[group->first];
    mus__sink *sink = &job->sink;
    double least = HUGE_VAL, most = 0.0;
    bool elastic = false;
    mus__sink_print(sink, "%d. Finish the %s of ", (int)++job->number,
                    strcmp(first->words, first->panel) == 0 ? "free edge" : first->words);
    for (int32_t i = 0; i < group->count; i++) {
        if (i == 0 || strcmp(first[i].panel, first[i - 1].panel) != 0)
            mus__sink_print(sink, "%s%s", i > 0 ? ", " : "", first[i].panel);
        least = fmin(least, first[i].allowance);
        most = fmax(most, first[i].allowance);
        elastic = elastic || first[i].elastic;
    }
    mus__sink_print(sink, ", ");
    mus__tell_length(sink, group->length);
    mus__sink_print(sink, " in all");
    if (group->faced) {
        mus__sink_print(sink, ", with: ");
        tell_facings(job, first->label);
    } else {
        mus__sink_print(sink, ": turn ");
        if (most > 0.0 && lround(1e3 * least) < lround(1e3 * most))
            mus__sink_print(sink, "%ld to ", lround(1e3 * least));
        if (most > 0.0) mus__sink_print(sink, "%ld mm ", lround(1e3 * most));
        mus__sink_print(sink, "to the wrong side and stitch%s",
                        elastic ? ", with a gap; draw the elastic in and close it" : "");
    }
    mus__sink_print(sink, ".\n");
}


/* ---- other parts ---- */

/* first edge of the pattern with a label that a panel finishes, free or in a seam; MUS_NONE without one */
static int32_t part_edge(const mus__instructions *job, int32_t panel, bool free)
{
    for (int32_t i = 0; i < mus_pattern_edge_count(job->pattern); i++)
        if (finish_free(job->pattern, i) == free && finish_with(job, panel, mus_pattern_edge_label(job->pattern, i)))
            return i;
    return MUS_NONE;
}


/* place in finish_parts of a panel that no edge or mark asks for; MUS_NONE for all others */
static int32_t part_of(const mus__instructions *job, int32_t panel)
{
    const int32_t parts = (int32_t)(sizeof finish_parts / sizeof finish_parts[0]);
    const char *label = mus_pattern_panel_label(job->extra, panel), *name;
    int32_t worn = 0;
    for (int32_t m = 0; m < MUS_MATERIAL_COUNT; m++)
        if (m != MUS_MATERIAL_INTERFACING && m != MUS_MATERIAL_ELASTIC) worn += mus__tell_copies(job->extra, panel, m);
    if (worn == 0 || part_edge(job, panel, true) != MUS_NONE || part_edge(job, panel, false) != MUS_NONE)
        return MUS_NONE;
    for (int32_t i = 0; i < mus_pattern_mark_count(job->pattern); i++)
        if (mus_pattern_mark(job->pattern, i, NULL, &name, NULL, NULL) == MUS_OK && strcmp(name, label) == 0)
            return MUS_NONE;
    for (int32_t k = 0; k < parts - 1; k++)
        if (strcmp(finish_parts[k].label, label) == 0) return k;
    return parts - 1;
}


void mus__tell_parts(mus__instructions *job, bool last)
{
    for (int32_t k = 0; k < (int32_t)(sizeof finish_parts / sizeof finish_parts[0]); k++) {
        if (finish_parts[k].last != last) continue;
        for (int32_t i = 0; i < mus_pattern_panel_count(job->extra); i++)
            if (part_of(job, i) == k) mus__list_add(job, job->extra, i);
        mus__list_step(job, finish_parts[k].text, "");
    }
}


/* facings over seams, each label once: the first of its panels tells them */
static void tell_over_seams(mus__instructions *job)
{
    for (int32_t i = 0; i < mus_pattern_panel_count(job->extra); i++) {
        const int32_t edge = part_edge(job, i, false);
        int32_t first = 0;
        if (edge == MUS_NONE || part_edge(job, i, true) != MUS_NONE) continue;
        const char *label = mus_pattern_edge_label(job->pattern, edge);
        while (!finish_with(job, first, label)) first++;
        if (first < i) continue;
        mus__sink_print(&job->sink, "%d. Sew over the seam of the %s and turn inside: ", (int)++job->number, label);
        tell_facings(job, label);
        mus__sink_print(&job->sink, ".\n");
    }
}


/* an elastic that lies in no free edge */
static void tell_elastic(mus__instructions *job)
{
    const mus_pattern *pattern = job->pattern;
    int32_t held = 0;
    for (int32_t i = 0; i < mus_pattern_edge_count(pattern); i++) {
        if (!finish_elastic(pattern, i)) continue;
        if (finish_free(pattern, i)) return;
        if (held++ == 0)
            mus__sink_print(&job->sink, "%d. Stretch the elastic and sew it inside along the ", (int)++job->number);
        if (held > 1) continue;
        char words[MUS__WORDS];
        mus__sewing_edge_words(pattern, i, words);
        mus__sink_print(&job->sink, "%s.\n", words);
    }
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
        for (int32_t i = 0; i < n; i++) tell_group_step(job, edges, &groups[i]);
        tell_elastic(job);
        mus__tell_parts(job, true);
    }
    mus__print_free(context, groups);
    mus__print_free(context, edges);
    return status;
}
