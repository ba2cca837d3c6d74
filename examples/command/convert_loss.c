/*
 * convert_loss.c: what a form of a file cannot hold of a pattern, one line a thing on standard error.
 */
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "convert_loss.h"
#include "muslin/pattern.h"

/* The things of a pattern that forms do not hold, counted. */
typedef struct losses {
    int32_t seams, laid, closures, holds, elastics, names, labels, curves, inner;
    int32_t placements, bends, layers, openings, notches, marks, allowances, small;
} losses;


static void count_edges(const mus_pattern *pattern, losses *l)
{
    for (int32_t e = 0; e < mus_pattern_edge_count(pattern); e++) {
        int32_t level = MUS_HOLD_NONE, n = 0;
        double stiffness = 0.0;
        const int32_t *kinds = NULL;
        mus_pattern_edge_hold(pattern, e, &level, NULL);
        mus_pattern_edge_elastic(pattern, e, NULL, &stiffness);
        mus_pattern_edge_pieces(pattern, e, &n, &kinds, NULL, NULL);
        bool curved = false;
        for (int32_t i = 0; i < n; i++) curved = curved || kinds[i] != MUS_PIECE_LINE;
        l->holds += level != MUS_HOLD_NONE;
        l->elastics += stiffness > 0.0;
        l->names += mus_pattern_edge_name(pattern, e)[0] != '\0';
        l->labels += mus_pattern_edge_label(pattern, e)[0] != '\0';
        l->curves += curved;
        l->allowances += mus_pattern_edge_allowance(pattern, e) >= 0.0;
    }
}


/* True for a name of at most 20 small letters, digits and "_": the names that come back as they were. */
static bool name_is_kept(const char *name)
{
    const size_t n = strspn(name, "abcdefghijklmnopqrstuvwxyz0123456789_");
    return name[n] == '\0' && n <= 20;
}


static void count_panels(const mus_pattern *pattern, losses *l)
{
    for (int32_t p = 0; p < mus_pattern_panel_count(pattern); p++) {
        int32_t outline = 0, rim = 0;
        mus_placement at, none;
        mus_placement_init(&at, sizeof at);
        mus_placement_init(&none, sizeof none);
        mus_pattern_outline(pattern, p, &outline, NULL, NULL);
        mus_pattern_rim(pattern, p, NULL, NULL, 0, &rim);
        mus_pattern_placement(pattern, p, &at);
        l->inner += (outline - rim) / 2;
        l->bends += at.bend != 0.0;
        l->placements += memcmp(at.origin, none.origin, sizeof at.origin) != 0;
        l->layers += mus_pattern_layer(pattern, p) > 0;
        l->small += !name_is_kept(mus_pattern_panel_name(pattern, p));
    }
}


static void count_seams(const mus_pattern *pattern, losses *l)
{
    l->seams = mus_pattern_seam_count(pattern);
    for (int32_t i = 0; i < l->seams; i++) {
        mus_seam_def seam;
        mus_seam_def_init(&seam, sizeof seam);
        if (mus_pattern_seam(pattern, i, &seam) != MUS_OK) continue;
        l->closures += seam.closure != MUS_CLOSURE_NONE;
        l->laid += mus_pattern_edge_seam(pattern, seam.edge_a) != i || mus_pattern_edge_seam(pattern, seam.edge_b) != i;
    }
    l->notches = mus_pattern_notch_count(pattern);
    l->marks = mus_pattern_mark_count(pattern);
    l->openings = mus_pattern_opening_count(pattern);
}


void convert_tell_losses(const mus_pattern *pattern, const char *form)
{
    losses l = {0};
    count_edges(pattern, &l);
    count_panels(pattern, &l);
    count_seams(pattern, &l);
    const bool dxf = strcmp(form, "dxf") == 0, code = strcmp(form, "garmentcode") == 0;
    const bool panels = strcmp(form, "panels") == 0, paper = !code && !panels;
    const struct {
        int32_t count;
        const char *what;
    } rows[] = {{paper ? l.seams : 0, "seams: which edges are sewn together is not in the file"},
                {panels ? 0 : l.closures, "closures (zips, buttons)"},
                {code ? l.laid : 0, "second seams of edges (pleats, pockets)"},
                {code ? l.bends : 0, "bends of panels round the body"},
                {code ? l.notches : 0, "notches"},
                {code ? l.marks : 0, "marks inside panels"},
                {code ? l.allowances : 0, "seam allowances of edges"},
                {code ? 0 : l.placements, "places of panels round the body"},
                {panels ? 0 : l.layers, "layers of panels"},
                {l.holds, "attachments of edges to a level of the body"},
                {l.elastics, "elastics along edges"},
                {panels ? 0 : l.inner, "sewn lines inside panels"},
                {l.openings, "declared openings"},
                {paper ? l.labels : 0, "labels of edges (hem, neck, ...)"},
                {panels ? 0 : l.names, "names of edges"},
                {dxf ? l.curves : 0, "curved edges: they become chords within 0.01 mm"},
                {dxf ? l.small : 0, "names of panels: they become 20 capitals, digits and \"_\""}};
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++)
        if (rows[i].count > 0)
            fprintf(stderr, "muslin convert: %s does not keep %d %s\n", form, (int)rows[i].count, rows[i].what);
}
