/*
 * sewing_text.c: the sheet of sewing instructions of a pattern, as text: pieces, notions, what is prepared, the steps.
 *
 * No garment is known here: names are the words of panels, edges and labels, and every sentence stands for a kind of
 * step. Seams of a step that read alike (left and right, the parts between two darts) share a line, which adds up their
 * lengths.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/sort.h"
#include "print/piece.h"
#include "sewing/sewing_text.h"

/* longest edge that a knit is stretched to, over its own length; chosen: a knit that gives half its length is the
 * stretchiest that the gauges on pattern envelopes ask for */
#define KNIT_STRETCH 1.5


/* longest edge that is eased in, over the other: a longer one is gathered. Chosen: sleeve caps have up to a tenth more
 */
#define GATHERED 1.15


/* write a head, after an empty line */
static void tell_head_of(mus__instructions *job, const char *key)
{
    mus__sink_print(&job->sink, "\n%s\n", mus_language_text(job->language, key));
}


static void tell_item(mus__instructions *job, const mus__phrase *phrase, const char *key)
{
    mus__sink_print(&job->sink, "- ");
    mus__phrase_add(phrase, key, &job->sink);
    mus__sink_print(&job->sink, "\n");
}


/* ---- pieces ---- */

static void tell_pieces(mus__instructions *job)
{
    tell_head_of(job, "head.pieces");
    for (int32_t k = 0; k < 2; k++) {
        const mus_pattern *pattern = k == 0 ? job->pattern : job->extra;
        for (int32_t i = 0; i < mus_pattern_panel_count(pattern); i++) {
            char words[MUS__PLAIN], told[MUS__PLAIN], cut[256];
            mus__piece piece;
            if (!mus__tell_printed(pattern, i)) continue;
            memset(&piece, 0, sizeof piece);
            for (int32_t m = 0; m < MUS_MATERIAL_COUNT; m++) piece.copies[m] = mus__tell_copies(pattern, i, m);
            piece.mirrored = mus__tell_mirrored(pattern, i);
            mus__plain_words(mus_pattern_panel_name(pattern, i), piece.mirrored, words);
            mus__piece_cut_text(&piece, job->language, cut, sizeof cut);
            if (cut[0] >= 'A' && cut[0] <= 'Z') cut[0] = (char)(cut[0] - 'A' + 'a'); /* after a colon */
            mus__phrase phrase = mus__phrase_in(job->language);
            mus__phrase_text(&phrase, 0, mus__tell_words(job, "panel", words, told));
            mus__phrase_text(&phrase, 1, cut);
            tell_item(job, &phrase, "list.colon");
        }
    }
}


/* ---- notions ---- */

/* write a notion; the head before the first one */
static void tell_notion(mus__instructions *job, const mus__phrase *phrase, const char *key, bool *any)
{
    if (!*any) tell_head_of(job, "head.notions");
    *any = true;
    tell_item(job, phrase, key);
}


static void tell_zip(mus__instructions *job, double length, const char *key, bool *any)
{
    char text[MUS__LENGTH];
    mus__phrase phrase = mus__phrase_in(job->language);
    mus__phrase_text(&phrase, 0, mus__tell_length(job, length, text));
    tell_notion(job, &phrase, key, any);
}


/* buttons that are marked on a panel without a closure, as on the stand of a collar: both ends of it have the mark */
static int32_t loose_buttons(const mus__instructions *job, int32_t *of)
{
    int32_t marks = 0;
    for (int32_t i = 0; i < mus_pattern_mark_count(job->pattern); i++) {
        int32_t panel = MUS_NONE, k = 0;
        const char *name = "";
        mus_pattern_mark(job->pattern, i, &panel, &name, NULL, NULL);
        if (strcmp(name, "button") != 0) continue;
        while (k < job->sewing.n && (job->sewing.sewn[k].kind != MUS__SEWING_BUTTONS ||
                                     (job->sewing.sewn[k].panel[0] != panel && job->sewing.sewn[k].panel[1] != panel)))
            k++;
        if (k == job->sewing.n) *of = panel, marks++;
    }
    return marks / 2;
}


/* are two seams with a zip parts of one? Those of one centre line are, as of a bodice and the skirt below it */
static bool zip_one(const mus__instructions *job, const mus__sewn *a, const mus__sewn *b)
{
    const mus_pattern *pattern = job->pattern;
    const int32_t centre = MUS_SIDE_FRONT | MUS_SIDE_BACK;
    const int32_t sides = mus_pattern_panel_sides(pattern, a->panel[0], NULL) & centre;
    return a == b || (a->zip && b->zip && strcmp(mus_pattern_edge_label(pattern, a->edge[0]), "centre") == 0 &&
                      strcmp(mus_pattern_edge_label(pattern, b->edge[0]), "centre") == 0 &&
                      sides == (mus_pattern_panel_sides(pattern, b->panel[0], NULL) & centre));
}


/* is seam i the first by words of its zip? */
static bool zip_first(const mus__instructions *job, int32_t i)
{
    for (int32_t k = 0; k < i; k++)
        if (zip_one(job, job->sewing.by_words[k], job->sewing.by_words[i])) return false;
    return true;
}


/* [m] of a zip over all its seams */
static double zip_length(const mus__instructions *job, const mus__sewn *seam)
{
    double length = 0.0;
    for (int32_t k = 0; k < job->sewing.n; k++)
        if (zip_one(job, job->sewing.by_words[k], seam)) length += job->sewing.by_words[k]->length[0];
    return length;
}


static void tell_notions(mus__instructions *job)
{
    bool any = false;
    int32_t of = MUS_NONE, buttons = loose_buttons(job, &of);
    for (int32_t i = 0; i < job->sewing.n; i++) buttons += job->sewing.sewn[i].buttons;
    mus__phrase loose = mus__phrase_in(job->language);
    mus__phrase_number(&loose, 0, buttons);
    if (buttons > 0) tell_notion(job, &loose, buttons == 1 ? "buttons.one" : "buttons.many", &any);
    for (int32_t i = 0; i < job->sewing.n; i++) {
        const mus__sewn *seam = job->sewing.by_words[i];
        if (seam->zip && zip_first(job, i)) tell_zip(job, zip_length(job, seam), "notion.zip", &any);
    }
    for (int32_t i = 0; i < mus_pattern_panel_count(job->extra); i++) {
        const int32_t count = mus__tell_copies(job->extra, i, MUS_MATERIAL_ELASTIC);
        char text[MUS__LENGTH], wide[MUS__LENGTH];
        if (count == 0 || !mus__tell_printed(job->extra, i)) continue;
        mus__phrase phrase = mus__phrase_in(job->language);
        mus__phrase_number(&phrase, 0, count);
        mus__phrase_text(&phrase, 1, mus__tell_length(job, mus__tell_edge(job->extra, i, true), text));
        mus__phrase_text(&phrase, 2, mus__tell_length(job, mus__tell_edge(job->extra, i, false), wide));
        tell_notion(job, &phrase, "notion.elastic", &any);
    }
}


/* ---- preparation ---- */

/* the longer of two ends lies under the other: what a seam needs at both is not the underlap */
static void tell_underlap(mus__instructions *job, const mus__sewn *seam, int32_t side, double underlap)
{
    char words[MUS__PLAIN], told[MUS__PLAIN], depth[MUS__LENGTH];
    mus__plain_words(mus_pattern_panel_name(job->pattern, seam->panel[side]), seam->twins > 1, words);
    mus__phrase phrase = mus__phrase_in(job->language);
    mus__phrase_number(&phrase, 0, lround(1e3 * underlap));
    mus__phrase_write(&phrase, "depth", depth, sizeof depth);
    mus__phrase_text(&phrase, 0, mus__tell_words(job, "panel", words, told));
    mus__phrase_text(&phrase, 1, depth);
    mus__tell_step(job, &phrase, "step.underlap");
}


/* how far the line "fold" of an edge's panel lies beyond the edge [m]: within its allowance, and beside its middle; 0
 * without one */
static double placket_line(const mus_pattern *pattern, int32_t edge, double allowance)
{
    const double t[3] = {0.0, 0.5, 1.0};
    double xy[6];
    if (mus_pattern_edge_at(pattern, edge, 3, t, xy) != MUS_OK) return 0.0;
    const double dx = xy[4] - xy[0], dy = xy[5] - xy[1], length = sqrt(dx * dx + dy * dy);
    for (int32_t i = 0; i < mus_pattern_mark_count(pattern) && length > 0.0; i++) {
        int32_t panel, n;
        const char *name;
        const double *line;
        if (mus_pattern_mark(pattern, i, &panel, &name, &n, &line) != MUS_OK || n != 2) continue;
        if (panel != mus_pattern_edge_panel(pattern, edge) || strcmp(name, "fold") != 0) continue;
        const double x = 0.5 * (line[0] + line[2]) - xy[2], y = 0.5 * (line[1] + line[3]) - xy[3];
        const double away = fabs(x * dy - y * dx) / length, along = fabs(x * dx + y * dy) / length;
        if (away > 0.0 && away < allowance && along < 0.5 * length) return away;
    }
    return 0.0;
}


/* fold what the allowance of a closure with buttons is to the wrong side: both sides of a seam in one step */
static void tell_plackets(mus__instructions *job)
{
    for (int32_t i = 0; i < 2 * job->sewing.n; i++) {
        const mus__sewn *seam = job->sewing.by_words[i / 2];
        const double allowance = mus_pattern_edge_allowance(job->pattern, seam->edge[i % 2]);
        const double other = mus_pattern_edge_allowance(job->pattern, seam->edge[1 - i % 2]);
        if (seam->kind != MUS__SEWING_BUTTONS || !(allowance > 0.0) || other > allowance + 1e-6) continue;
        if (allowance > other + 1e-6) {
            if (seam->family == i / 2) tell_underlap(job, seam, i % 2, allowance - other); /* left and right alike */
            continue;
        }
        char words[MUS__PLAIN], told[MUS__PLAIN], depth[MUS__LENGTH];
        mus__plain_edge_words(job->pattern, seam->edge[i % 2], words);
        mus__list_add(job, job->pattern, seam->panel[i % 2]);
        if (i % 2 == 0 && seam->panel[0] != seam->panel[1]) continue;
        const double line = placket_line(job->pattern, seam->edge[i % 2], allowance);
        const char *fold = mus_language_text(job->language, "mark.fold");
        char number[24];
        mus__print_millimetres(number, sizeof number, allowance - line);
        mus__phrase phrase = mus__phrase_in(job->language);
        mus__phrase_text(&phrase, 0, number);
        mus__phrase_write(&phrase, "depth", depth, sizeof depth);
        mus__phrase_text(&phrase, 1, depth);
        mus__phrase_text(&phrase, 2, mus__tell_words(job, "edge", words, told));
        mus__phrase_text(&phrase, 3, fold);
        mus__list_step(job, &phrase, line > 0.0 ? "step.placket_line" : "step.placket");
    }
}


/* has a patch edges of its own to put a hand in, in place of its upper one? */
static bool patch_opens(const mus_pattern *extra, int32_t panel)
{
    for (int32_t i = 0; i < mus_pattern_edge_count(extra); i++)
        if (mus_pattern_edge_panel(extra, i) == panel && strcmp(mus_pattern_edge_label(extra, i), "opening") == 0)
            return true;
    return false;
}


/* patches whose place is marked, each below its name */
static void tell_patches(mus__instructions *job)
{
    for (int32_t k = 0; k < mus_pattern_panel_count(job->extra); k++) {
        const char *mark = mus_pattern_panel_label(job->extra, k);
        char words[MUS__PLAIN], told[MUS__PLAIN];
        if (!mus__tell_printed(job->extra, k)) continue;
        for (int32_t i = 0; i < mus_pattern_panel_count(job->pattern); i++)
            if (mark[0] != '\0' && mus__tell_has_mark(job->pattern, i, mark)) mus__list_add(job, job->pattern, i);
        mus__plain_words(mus_pattern_panel_name(job->extra, k), true, words);
        mus__phrase phrase = mus__phrase_in(job->language);
        mus__phrase_text(&phrase, 1, mus__tell_words(job, "panel", words, told));
        mus__list_step(job, &phrase, patch_opens(job->extra, k) ? "step.pouch" : "step.patch");
    }
}


/* is a panel that is not draped the interfacing of the panels on which its place is a line of that name? */
static bool fuses(const mus__instructions *job, int32_t extra)
{
    int32_t k = 0;
    while (k < mus_pattern_panel_count(job->pattern) && !mus__tell_has_mark(job->pattern, k, "interfacing")) k++;
    return k < mus_pattern_panel_count(job->pattern) &&
           mus__tell_copies(job->extra, extra, MUS_MATERIAL_INTERFACING) > 0 &&
           mus__tell_copies(job->extra, extra, MUS_MATERIAL_MAIN) == 0 && mus__tell_has_mark(job->extra, extra, "fold");
}


/* interfacing that is a panel of its own, and the panels that it is fused to: fold line on fold line */
static void tell_fused(mus__instructions *job)
{
    char words[MUS__PLAIN], told[MUS__PLAIN];
    for (int32_t k = 0; k < mus_pattern_panel_count(job->extra); k++) {
        if (!fuses(job, k)) continue;
        for (int32_t i = 0; i < mus_pattern_panel_count(job->pattern); i++)
            if (mus__tell_has_mark(job->pattern, i, "interfacing")) mus__list_add(job, job->pattern, i);
        mus__plain_words(mus_pattern_panel_name(job->extra, k), true, words);
        mus__phrase phrase = mus__phrase_in(job->language);
        mus__phrase_text(&phrase, 1, mus__tell_words(job, "panel", words, told));
        mus__phrase_text(&phrase, 2, mus_language_text(job->language, "mark.fold"));
        mus__list_step(job, &phrase, "step.fuse_line");
    }
}


static void tell_preparation(mus__instructions *job)
{
    const int32_t panels = mus_pattern_panel_count(job->pattern), extras = mus_pattern_panel_count(job->extra);
    mus__phrase phrase = mus__phrase_in(job->language);
    tell_head_of(job, "head.sewing");
    mus__sink_print(&job->sink, "%s\n", mus_language_text(job->language, "sewing.general"));
    for (int32_t i = 0; i < panels; i++)
        if (mus__tell_copies(job->pattern, i, MUS_MATERIAL_INTERFACING) > 0) mus__list_add(job, job->pattern, i);
    for (int32_t i = 0; i < extras; i++)
        if (mus__tell_copies(job->extra, i, MUS_MATERIAL_INTERFACING) > 0 && !fuses(job, i))
            mus__list_add(job, job->extra, i);
    mus__list_step(job, &phrase, "step.fuse");
    tell_fused(job);

    for (int32_t i = 0; i < panels; i++)
        if (mus__tell_has_mark(job->pattern, i, "pleat")) mus__list_add(job, job->pattern, i);
    mus__list_step(job, &phrase, "step.pleats");
    tell_plackets(job);
    tell_patches(job);
    mus__tell_parts(job, false);
    mus__tell_layers(job, "step.layers_first", MUS_NONE);
}


/* ---- steps ---- */

/* seams of a step that read alike */
typedef struct tell_group {
    double length[2]; /* [m] of one side of the wearer */
    int32_t count, notches;
    bool twins; /* the same left and right */
} tell_group;


static bool group_same(const mus__sewn *a, const mus__sewn *b)
{
    return strcmp(a->phrase, b->phrase) == 0 && a->zip == b->zip && a->laid == b->laid && a->buttons == b->buttons &&
           (a->kind != MUS__SEWING_DART || a->millimetres == b->millimetres);
}


/* by step, zips last, then by what is told; a family stands together */
static int group_compare(const void *a, const void *b)
{
    const mus__sewn *s = *(mus__sewn *const *)a, *t = *(mus__sewn *const *)b;
    const long keys[6][2] = {{s->step, t->step},
                             {s->zip, t->zip},
                             {s->laid, t->laid},
                             {s->buttons, t->buttons},
                             {s->millimetres, t->millimetres},
                             {s->family, t->family}};
    for (int32_t i = 0; i < 6; i++) {
        const int order = i == 3 ? strcmp(s->phrase, t->phrase) : 0;
        if (order != 0) return order;
        /* darts of one length stand together; of other seams all that read alike do */
        if (i == 4 && s->kind != MUS__SEWING_DART) continue;
        if (keys[i][0] != keys[i][1]) return keys[i][0] < keys[i][1] ? -1 : 1;
    }
    return 0;
}


/* add up seams that read alike; halved when each of them is there left and right */
static tell_group group_add(mus__sewn *const *seams, int32_t count)
{
    tell_group group = {{0.0, 0.0}, count, 0, count % 2 == 0};
    for (int32_t i = 0; i < count; i++) {
        for (int32_t k = 0; k < 2; k++) group.length[k] += seams[i]->length[k];
        group.notches += seams[i]->notches;
        group.twins = group.twins && seams[i]->twins == 2 && seams[i]->family == seams[i - i % 2]->family;
    }
    if (!group.twins) return group;
    for (int32_t k = 0; k < 2; k++) group.length[k] /= 2.0;
    group.notches /= 2;
    group.count /= 2;
    return group;
}


/* is side k of a seam stretched to the other, longer one? A rib is, and so is a casing whose grain runs across its
 * edge, as that of a knit does, unless the other side is longer than it stretches */
static bool side_gives(const mus__instructions *job, const mus__sewn *seam, int32_t k, double longer)
{
    const double t[2] = {0.0, 1.0};
    double grain[2], xy[4];
    if (mus__tell_copies(job->pattern, seam->panel[k], MUS_MATERIAL_RIB) > 0) return true;
    if (strcmp(mus_pattern_panel_label(job->pattern, seam->panel[k]), "elastic") != 0 ||
        mus_pattern_grain(job->pattern, seam->panel[k], grain) != MUS_OK ||
        mus_pattern_edge_at(job->pattern, seam->edge[k], 2, t, xy) != MUS_OK)
        return false;
    const double x = xy[2] - xy[0], y = xy[3] - xy[1];
    return fabs(x * grain[0] + y * grain[1]) < fabs(x * grain[1] - y * grain[0]) &&
           longer <= KNIT_STRETCH * seam->length[k];
}


/* write the length of a seam, and how the other side is brought to it: a rib or a knitted casing is stretched to the
 * longer side, else the longer side is eased in, or its pleats shorten it */
static void tell_sewn_length(mus__instructions *job, const mus__sewn *seam, const tell_group *group)
{
    const int32_t longer = group->length[0] > group->length[1] ? 0 : 1, shorter = 1 - longer;
    const double ease = group->length[longer] - group->length[shorter];
    const bool gives = side_gives(job, seam, shorter, seam->length[longer]);
    const int32_t moved = gives ? shorter : longer;
    char text[MUS__PHRASE], words[MUS__PLAIN], told[MUS__PLAIN], length[MUS__LENGTH], own[MUS__LENGTH];
    mus__phrase phrase = mus__phrase_in(job->language);
    mus__sink_print(&job->sink, "%s", mus__tell_length(job, group->length[1 - moved], length));
    if (group->notches > 0) {
        mus__phrase_count(&phrase, "notches", group->notches, text, sizeof text);
        mus__sink_print(&job->sink, "%s%s", mus_language_text(job->language, "list.comma"), text);
    }
    if (ease <= group->count * seam->tolerance || lround(1e3 * ease) == 0) return;
    const bool pleats = mus__tell_has_mark(job->pattern, seam->panel[longer], "pleat");
    mus__plain_words(mus_pattern_panel_name(job->pattern, seam->panel[moved]), true, words);
    mus__phrase_text(&phrase, 0, mus__tell_words(job, "panel", words, told));
    mus__phrase_text(&phrase, 1, mus__tell_length(job, group->length[moved], own));
    mus__phrase_text(&phrase, 2, length);
    mus__sink_print(&job->sink, "%s", mus_language_text(job->language, "list.semicolon"));
    const bool gathers = group->length[longer] > GATHERED * group->length[shorter];
    mus__phrase_add(&phrase,
                    gives     ? "ease.rib"
                    : pleats  ? "ease.pleats"
                    : gathers ? "ease.gather"
                              : "ease.ease",
                    &job->sink);
}


/* go on with a note on a line */
static void tell_note(mus__instructions *job, const char *key)
{
    mus__sink_print(&job->sink, "%s%s", mus_language_text(job->language, "list.semicolon"),
                    mus_language_text(job->language, key));
}


/* write one line, of `count` seams that read alike */
static void tell_line(mus__instructions *job, mus__sewn *const *seams, int32_t count)
{
    const mus__sewn *seam = seams[0];
    const tell_group group = group_add(seams, count);
    const char *comma = mus_language_text(job->language, "list.comma");
    const bool dart = seam->kind == MUS__SEWING_DART, one = group.count == 1;
    char words[MUS__PHRASE], text[MUS__PHRASE], length[MUS__LENGTH];
    mus__phrase phrase = mus__phrase_in(job->language);
    mus__sewing_phrase(job->pattern, seam, job->language, words);
    mus__phrase_text(&phrase, 0, words);
    mus__phrase_number(&phrase, 1, group.count);
    mus__phrase_text(&phrase, 2, mus__tell_length(job, seam->length[0], length));
    mus__sink_print(&job->sink, "   - ");
    if (dart && seam->laid) mus__phrase_add(&phrase, one ? "line.pleat.one" : "line.pleat.many", &job->sink);
    else if (dart) mus__phrase_add(&phrase, one ? "line.dart.one" : "line.dart.many", &job->sink);
    else if (seam->zip) mus__phrase_add(&phrase, "line.zip", &job->sink);
    else mus__sink_print(&job->sink, "%s", words);
    if (!dart) {
        mus__sink_print(&job->sink, "%s", comma);
        tell_sewn_length(job, seam, &group);
    }
    if (!dart && seam->buttons > 0) {
        mus__phrase_count(&phrase, "buttons", seam->buttons, text, sizeof text);
        mus__sink_print(&job->sink, "%s%s", comma, text);
    }
    if (group.twins) tell_note(job, "line.alike");
    for (int32_t k = 0; k < 2 && seam->kind == MUS__SEWING_SEAM; k++) {
        const char *label = mus_pattern_edge_label(job->pattern, seam->edge[k]);
        if (strcmp(label, "side") == 0 && mus__tell_has_mark(job->pattern, seam->panel[k], "slot"))
            tell_note(job, "line.slot");
        if (strcmp(label, "cuff") == 0 && mus__tell_has_mark(job->pattern, seam->panel[k], "slit"))
            tell_note(job, "line.slit");
        if (mus__tell_rib_folds(job, seam->panel[k], seam->panel[1 - k])) tell_note(job, "line.folded");
    }
    mus__sink_print(&job->sink, "\n");
}


/* write what a step is called, by what it does to the work */
static void tell_head(mus__instructions *job, const mus__sewing_step *step, bool pleats, bool several)
{
    static const char *const keys[] = {"step.darts", "step.lay_on", NULL, "step.buttons", "step.ties"};
    const bool closes = step->rings > 0 && step->joins <= 0;
    const mus__phrase phrase = mus__phrase_in(job->language);
    const char *key = keys[step->kind];
    if (step->kind == MUS__SEWING_DART && pleats) key = "step.darts_pleats";
    if (key == NULL && closes) key = several ? "step.close_in_one" : "step.close";
    if (key == NULL) key = several ? "step.sew_in_one" : "step.sew";
    mus__tell_step(job, &phrase, key);
}


/* write buttons that are marked on a panel without a closure */
static void tell_loose(mus__instructions *job)
{
    char words[MUS__PLAIN], told[MUS__PLAIN], text[MUS__PHRASE];
    int32_t panel = MUS_NONE;
    const int32_t buttons = loose_buttons(job, &panel);
    mus__phrase phrase = mus__phrase_in(job->language);
    if (buttons == 0) return;
    mus__plain_words(mus_pattern_panel_name(job->pattern, panel), true, words);
    mus__phrase_count(&phrase, "buttons", buttons, text, sizeof text);
    mus__sink_print(&job->sink, "   - %s%s%s\n", mus__tell_words(job, "panel", words, told),
                    mus_language_text(job->language, "list.comma"), text);
}


/* write the steps of `seams`, sorted by step and phrase: those of what fastens, or all others */
static void tell_steps(mus__instructions *job, mus__sewn *const *seams, bool fastens)
{
    const int32_t n = job->sewing.n;
    for (int32_t i = 0, end; i < n; i = end) {
        bool pleats = false;
        for (end = i; end < n && seams[end]->step == seams[i]->step; end++) pleats = pleats || seams[end]->laid;
        const mus__sewing_step *step = &job->sewing.steps[seams[i]->step];
        if ((step->kind == MUS__SEWING_BUTTONS) != fastens) continue;
        tell_head(job, step, pleats, !group_same(seams[i], seams[end - 1]));
        for (int32_t k = i, next; k < end; k = next) {
            for (next = k + 1; next < end && group_same(seams[k], seams[next]);) next++;
            tell_line(job, seams + k, next - k);
        }
        if (fastens && end == n) tell_loose(job);
        if (!fastens) mus__tell_layers(job, "step.layers_first", seams[i]->step);
    }
}


/* ---- public ---- */

static mus_status instructions_tell(mus__instructions *job, const char *title)
{
    mus_context *context = job->sink.context;
    const int32_t n = job->sewing.n;
    mus__sewn **seams = mus__print_new(context, n, sizeof *seams);
    if (seams == NULL) return mus__print_memory(context, "the instructions");
    if (n > 0) memcpy(seams, job->sewing.by_words, (size_t)n * sizeof *seams);
    mus__sort(seams, (size_t)n, sizeof *seams, group_compare);
    mus__finish_find(job);
    mus__sink_print(&job->sink, "%s\n", title != NULL ? title : mus_pattern_name(job->pattern));
    tell_pieces(job);
    mus_status status = mus__tell_cloth(job);
    tell_notions(job);
    tell_preparation(job);
    tell_steps(job, seams, false);
    if (status == MUS_OK) status = mus__tell_finish(job);
    tell_steps(job, seams, true);
    mus__print_free(context, seams);
    return status;
}


static mus_status instructions_write(const mus_pattern *pattern, const char *language, const char *title,
                                     const mus__target *target, const char *what)
{
    if (pattern == NULL) return MUS_ERR_ARG;
    mus_context *context = mus_pattern_context(pattern);
    mus__instructions job = {.pattern = pattern, .extra = mus_pattern_cut_only(pattern)};
    mus_status status = mus__target_check(context, target, what);
    if (status == MUS_OK) status = mus__language_read(context, language, what, &job.language);
    if (status != MUS_OK) return status;
    const int64_t most = (int64_t)mus_pattern_panel_count(pattern) + mus_pattern_panel_count(job.extra);
    mus__sink_init(&job.sink, context);
    status = mus__sewing_make(context, pattern, &job.sewing);
    if (status == MUS_OK) status = mus__sewing_order(&job.sewing);
    job.list.words = mus__print_new(context, most + mus_pattern_edge_count(pattern), sizeof *job.list.words);
    job.finishes = mus__print_new(context, most, sizeof *job.finishes);
    job.free = mus__print_new(context, mus_pattern_edge_count(pattern), sizeof *job.free);
    if (status == MUS_OK && (job.list.words == NULL || job.finishes == NULL || job.free == NULL))
        status = mus__print_memory(context, "the instructions");
    if (status == MUS_OK) status = instructions_tell(&job, title);
    if (status == MUS_OK) status = mus__sink_give(&job.sink, target);
    mus__print_free(context, job.free);
    mus__print_free(context, job.finishes);
    mus__print_free(context, job.list.words);
    mus__sewing_free(&job.sewing);
    mus__sink_free(&job.sink);
    return status;
}


mus_status mus_pattern_write_instructions(const mus_pattern *pattern, const char *title, const char *path)
{
    return instructions_write(pattern, NULL, title, &(mus__target){path, NULL, NULL}, "mus_pattern_write_instructions");
}


mus_status mus_pattern_write_instructions_bytes(const mus_pattern *pattern, const char *title, char **bytes,
                                                size_t *size)
{
    return instructions_write(pattern, NULL, title, &(mus__target){NULL, bytes, size},
                              "mus_pattern_write_instructions_bytes");
}


mus_status mus_pattern_write_instructions_in(const mus_pattern *pattern, const char *language, const char *title,
                                             const char *path)
{
    return instructions_write(pattern, language, title, &(mus__target){path, NULL, NULL},
                              "mus_pattern_write_instructions_in");
}


mus_status mus_pattern_write_instructions_in_bytes(const mus_pattern *pattern, const char *language, const char *title,
                                                   char **bytes, size_t *size)
{
    return instructions_write(pattern, language, title, &(mus__target){NULL, bytes, size},
                              "mus_pattern_write_instructions_in_bytes");
}
