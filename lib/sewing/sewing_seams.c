/*
 * sewing_seams.c: the seams of a pattern with their kinds and words, sorted by the words.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/sort.h"
#include "drawing/phrase.h"
#include "sewing/sewing.h"


static mus__sewing_kind seam_kind(const mus__sewing *sewing, const mus_seam_def *def)
{
    const mus_pattern *pattern = sewing->pattern;
    int32_t a[2], b[2];
    if (def->closure == MUS_CLOSURE_BUTTONS) return MUS__SEWING_BUTTONS;
    if (def->closure == MUS_CLOSURE_TIES) return MUS__SEWING_TIES;
    if (def->laid) return MUS__SEWING_DART;
    if (sewing->passes[def->edge_a] > 1 || sewing->passes[def->edge_b] > 1) return MUS__SEWING_PATCH;
    if (def->closure != MUS_CLOSURE_NONE ||
        mus_pattern_edge_panel(pattern, def->edge_a) != mus_pattern_edge_panel(pattern, def->edge_b))
        return MUS__SEWING_SEAM;
    /* the legs of a dart meet at its point */
    mus_pattern_edge_ends(pattern, def->edge_a, &a[0], &a[1]);
    mus_pattern_edge_ends(pattern, def->edge_b, &b[0], &b[1]);
    return a[0] == b[0] || a[0] == b[1] || a[1] == b[0] || a[1] == b[1] ? MUS__SEWING_DART : MUS__SEWING_SEAM;
}


static int32_t seam_button_marks(const mus_pattern *pattern, int32_t panel)
{
    int32_t count = 0, own;
    const char *name;
    for (int32_t i = 0; i < mus_pattern_mark_count(pattern); i++)
        count += mus_pattern_mark(pattern, i, &own, &name, NULL, NULL) == MUS_OK && own == panel &&
                 strcmp(name, "button") == 0;
    return count;
}


/* number of buttons of a closure: of the seam, else the marks on the side that has more */
static int32_t seam_buttons(const mus_pattern *pattern, const mus_seam_def *def)
{
    if (def->closure != MUS_CLOSURE_BUTTONS || def->buttons > 0) return def->buttons;
    const int32_t a = seam_button_marks(pattern, mus_pattern_edge_panel(pattern, def->edge_a));
    const int32_t b = seam_button_marks(pattern, mus_pattern_edge_panel(pattern, def->edge_b));
    return a > b ? a : b;
}


/* write the words of panel and edge, by which seams are sorted */
static void seam_words(const mus_pattern *pattern, int32_t edge, bool sideless, char *out)
{
    char panel[MUS__PLAIN], own[MUS__PLAIN];
    mus__plain_words(mus_pattern_panel_name(pattern, mus_pattern_edge_panel(pattern, edge)), sideless, panel);
    mus__plain_words(mus_pattern_edge_name(pattern, edge), sideless, own);
    snprintf(out, 2 * MUS__PLAIN, "%s/%s", panel, own);
}


/* do the words of edge a come after those of edge b? Left and right decide last, so that twins have their sides alike
 */
static bool seam_after(const mus_pattern *pattern, int32_t a, int32_t b)
{
    int order = 0;
    for (int32_t sideless = 1; sideless >= 0 && order == 0; sideless--) {
        char first[2 * MUS__PLAIN], second[2 * MUS__PLAIN];
        seam_words(pattern, a, sideless, first);
        seam_words(pattern, b, sideless, second);
        order = strcmp(first, second);
    }
    return order > 0;
}


static void seam_swap(int32_t *pair)
{
    const int32_t held = pair[0];
    pair[0] = pair[1];
    pair[1] = held;
}


static void seam_read(const mus__sewing *sewing, int32_t seam, mus__sewn *out)
{
    const mus_pattern *pattern = sewing->pattern;
    int32_t ends[2][2];
    mus_seam_def def;
    mus_seam_def_init(&def, sizeof def);
    if (mus_pattern_seam(pattern, seam, &def) != MUS_OK) return;
    out->seam = seam;
    out->kind = seam_kind(sewing, &def);
    out->edge[0] = def.edge_a;
    out->edge[1] = def.edge_b;
    const bool after = seam_after(pattern, def.edge_a, def.edge_b); /* of a tie the end that it holds is first */
    if (out->kind == MUS__SEWING_PATCH ? sewing->passes[def.edge_a] > 1 : after && out->kind != MUS__SEWING_TIES)
        seam_swap(out->edge);
    for (int32_t k = 0; k < 2; k++) {
        out->panel[k] = mus_pattern_edge_panel(pattern, out->edge[k]);
        out->length[k] = mus_pattern_edge_length(pattern, out->edge[k]);
        mus_pattern_edge_ends(pattern, out->edge[k], &ends[k][0], &ends[k][1]);
        seam_words(pattern, out->edge[k], true, out->words[k][0]);
        seam_words(pattern, out->edge[k], false, out->words[k][1]);
    }
    if (def.direction == MUS_SEAM_REVERSED) seam_swap(ends[1]);
    for (int32_t k = 0; k < 2; k++)
        for (int32_t side = 0; side < 2; side++) out->point[k][side] = ends[side][k];
    const int32_t a = sewing->notches[out->edge[0]], b = sewing->notches[out->edge[1]];
    out->notches = a < b ? a : b;
    out->tolerance = def.tolerance;
    out->buttons = seam_buttons(pattern, &def);
    out->zip = def.closure == MUS_CLOSURE_ZIP;
    out->laid = def.laid != 0 && out->kind == MUS__SEWING_DART;
}


static int seam_number(long a, long b)
{
    return (a > b) - (a < b);
}


/* compare all but left and right, lengths to the millimetre */
static int seam_compare_sideless(const mus__sewn *s, const mus__sewn *t)
{
    int order = strcmp(s->words[0][0], t->words[0][0]);
    if (order == 0) order = strcmp(s->words[1][0], t->words[1][0]);
    if (order == 0) order = seam_number(s->kind, t->kind);
    if (order == 0) order = seam_number(s->zip, t->zip);
    if (order == 0) order = seam_number(s->laid, t->laid);
    if (order == 0) order = seam_number(s->buttons, t->buttons);
    if (order == 0) order = seam_number(s->notches, t->notches);
    for (int32_t k = 0; k < 2 && order == 0; k++)
        order = seam_number(lround(1e3 * s->length[k]), lround(1e3 * t->length[k]));
    return order;
}


static int seam_compare(const void *a, const void *b)
{
    const mus__sewn *s = *(mus__sewn *const *)a, *t = *(mus__sewn *const *)b;
    int order = seam_compare_sideless(s, t);
    for (int32_t k = 0; k < 2 && order == 0; k++) order = strcmp(s->words[k][1], t->words[k][1]);
    for (int32_t k = 0; k < 2 && order == 0; k++) order = (s->length[k] > t->length[k]) - (s->length[k] < t->length[k]);
    return order;
}


/* are two seams that follow each other by words the same but for left and right? */
static bool seam_twins(const mus__sewn *s, const mus__sewn *t)
{
    return seam_compare_sideless(s, t) == 0 &&
           (strcmp(s->words[0][1], t->words[0][1]) != 0 || strcmp(s->words[1][1], t->words[1][1]) != 0);
}


void mus__sewing_phrase(const mus_pattern *pattern, const mus__sewn *sewn, int32_t language, char *out)
{
    char panel[2][MUS__PLAIN], edge[2][MUS__PLAIN], told[2][2][MUS__PLAIN];
    for (int32_t k = 0; k < 2; k++) {
        mus__plain_words(mus_pattern_panel_name(pattern, sewn->panel[k]), sewn->twins > 1, panel[k]);
        mus__plain_edge_words(pattern, sewn->edge[k], edge[k]);
        mus__plain_words_in(language, "panel", panel[k], told[k][0]);
        mus__plain_words_in(language, "edge", edge[k], told[k][1]);
    }
    mus__phrase phrase = mus__phrase_in(language);
    const char *key = "line.edges";
    const bool bare = strcmp(edge[0], "edge") == 0 && strcmp(edge[1], "edge") == 0; /* without name and label */
    const bool one_panel = sewn->kind != MUS__SEWING_PATCH && strcmp(panel[0], panel[1]) == 0;
    const char *const texts[4] = {told[0][0], one_panel ? told[0][1] : told[1][0], told[1][1], NULL};
    if (sewn->kind == MUS__SEWING_DART) {
        snprintf(out, MUS__PHRASE, "%s", told[0][0]);
        return;
    }
    if (sewn->kind == MUS__SEWING_PATCH) key = "line.onto";
    else if (one_panel) key = "line.same_panel";
    else if (bare) key = "line.panels";
    else if (strcmp(edge[0], edge[1]) == 0) key = "line.at";
    for (int32_t i = 0; i < 3; i++) mus__phrase_text(&phrase, i, texts[i]);
    if (strcmp(key, "line.edges") == 0) {
        mus__phrase_text(&phrase, 1, told[0][1]);
        mus__phrase_text(&phrase, 2, told[1][0]);
        mus__phrase_text(&phrase, 3, told[1][1]);
    }
    mus__phrase_write(&phrase, key, out, MUS__PHRASE);
}


/* families: seams that are equal but for left and right stand together, by their words */
static void seam_families(mus__sewing *sewing)
{
    mus__sewn **seams = sewing->by_words;
    for (int32_t i = 0; i < sewing->n; i++) {
        const bool twin = i > 0 && seam_twins(seams[i - 1], seams[i]);
        seams[i]->family = twin ? seams[i - 1]->family : i;
        seams[seams[i]->family]->twins++;
    }
    for (int32_t i = 0; i < sewing->n; i++) {
        seams[i]->twins = seams[seams[i]->family]->twins;
        seams[i]->millimetres = lround(1e3 * seams[seams[i]->family]->length[0]);
        mus__sewing_phrase(sewing->pattern, seams[i], MUS_LANGUAGE_ENGLISH, seams[i]->phrase);
    }
}


/* count what stands on each edge */
static void sewing_count(mus__sewing *sewing)
{
    const mus_pattern *pattern = sewing->pattern;
    for (int32_t i = 0; i < mus_pattern_panel_count(pattern); i++) {
        int32_t n = 0;
        const int32_t *edges;
        if (mus_pattern_outline(pattern, i, &n, &edges, NULL) != MUS_OK) continue;
        for (int32_t k = 0; k < n; k++) sewing->passes[edges[k]]++;
    }
    for (int32_t i = 0; i < mus_pattern_notch_count(pattern); i++) {
        int32_t edge = MUS_NONE;
        if (mus_pattern_notch(pattern, i, &edge, NULL, NULL) == MUS_OK && edge != MUS_NONE) sewing->notches[edge]++;
    }
}


mus_status mus__sewing_make(mus_context *context, const mus_pattern *pattern, mus__sewing *out)
{
    const int32_t n = mus_pattern_seam_count(pattern);
    *out = (mus__sewing){.context = context, .pattern = pattern, .n = n};
    out->sewn = mus__print_new(context, n, sizeof *out->sewn);
    out->by_words = mus__print_new(context, n, sizeof *out->by_words);
    out->steps = mus__print_new(context, n, sizeof *out->steps);
    out->passes = mus__print_new(context, mus_pattern_edge_count(pattern), sizeof *out->passes);
    out->notches = mus__print_new(context, mus_pattern_edge_count(pattern), sizeof *out->notches);
    if (out->sewn == NULL || out->by_words == NULL || out->steps == NULL || out->passes == NULL || out->notches == NULL)
        return mus__print_memory(context, "the order of sewing");
    sewing_count(out);
    for (int32_t i = 0; i < n; i++) {
        seam_read(out, i, &out->sewn[i]);
        out->by_words[i] = &out->sewn[i];
    }
    mus__sort(out->by_words, (size_t)n, sizeof *out->by_words, seam_compare);
    seam_families(out);
    return MUS_OK;
}


void mus__sewing_free(mus__sewing *sewing)
{
    mus__print_free(sewing->context, sewing->notches);
    mus__print_free(sewing->context, sewing->passes);
    mus__print_free(sewing->context, sewing->steps);
    mus__print_free(sewing->context, sewing->by_words);
    mus__print_free(sewing->context, sewing->sewn);
}
