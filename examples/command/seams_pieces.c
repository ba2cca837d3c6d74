/*
 * seams_pieces.c: --split and --piece of muslin seams: halves on the fold become whole, pairs get their second piece.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "muslin/edit.h"
#include "seams_pieces.h"

#define PIECE_TEXT 128 /* longest text of a --piece */
#define CUTS 8         /* most places of one --split */
#define NEARBY 1e-9    /* [m] two places that are nearer are one; points are kept to the last bit */
#define STRAIGHT 1e-6  /* [m] a straight edge is longer than its chord by no more: what mus_pattern_unfold() takes */

/* An edge by its place, which stays when edits of the pattern number its edges anew; panel MUS_NONE: none. */
typedef struct edge_place {
    int32_t panel;
    double length, start[2], end[2]; /* [m] */
} edge_place;

/* One --split, read. */
typedef struct cut {
    edge_place edge;
    int32_t n;
    double at[CUTS]; /* [m] from the start of the edge, ascending */
} cut;

/* One --piece, read. */
typedef struct piece {
    char text[PIECE_TEXT];
    const char *other, *label; /* NULL where not given */
    int32_t panel;
    bool leave, fold, pair;
    edge_place edge; /* that is on the fold; none: to be found */
} piece;


static edge_place place_of(const mus_pattern *pattern, int32_t edge)
{
    edge_place place = {.panel = mus_pattern_edge_panel(pattern, edge)};
    int32_t start = 0, end = 0;
    place.length = mus_pattern_edge_length(pattern, edge);
    if (mus_pattern_edge_ends(pattern, edge, &start, &end) != MUS_OK) place.panel = MUS_NONE;
    (void)mus_pattern_point(pattern, start, NULL, place.start);
    (void)mus_pattern_point(pattern, end, NULL, place.end);
    return place;
}


static double apart(const double *p, const double *q)
{
    return hypot(p[0] - q[0], p[1] - q[1]);
}


static int32_t edge_at(const mus_pattern *pattern, const edge_place *place)
{
    for (int32_t edge = 0; edge < mus_pattern_edge_count(pattern); edge++) {
        const edge_place own = place_of(pattern, edge);
        if (own.panel == place->panel && fabs(own.length - place->length) < NEARBY &&
            apart(own.start, place->start) < NEARBY && apart(own.end, place->end) < NEARBY)
            return edge;
    }
    return MUS_NONE;
}


/* the edge whose number stands at the start of a text; none for another text */
static edge_place read_edge(const mus_pattern *pattern, const char *text, char **end)
{
    const edge_place none = {.panel = MUS_NONE};
    const long edge = strtol(text, end, 10);
    return *end == text || edge < 0 || edge >= mus_pattern_edge_count(pattern) ? none
                                                                               : place_of(pattern, (int32_t)edge);
}


static mus_status refuse(const char *which, const char *text, const char *what)
{
    fprintf(stderr, "muslin seams: %s ", which);
    print_shown(stderr, text);
    fprintf(stderr, ": %s\n", what);
    return MUS_ERR_ARG;
}


static mus_status read_split(const mus_pattern *pattern, const char *text, cut *out)
{
    char *end = NULL;
    out->n = 0;
    out->edge = read_edge(pattern, text, &end);
    if (out->edge.panel == MUS_NONE) return refuse("--split", text, "no edge of this number; expected EDGE:MM,MM ...");
    for (char separator = ':'; *end == separator && out->n < CUTS; separator = ',') {
        const char *from = end + 1;
        const double at = 1e-3 * strtod(from, &end);
        const bool good = end > from && isfinite(at) && (out->n == 0 || at > out->at[out->n - 1]);
        out->n = good ? out->n + 1 : CUTS + 1;
        if (good) out->at[out->n - 1] = at;
    }
    if (out->n > 0 && out->n <= CUTS && *end == '\0') return MUS_OK;
    return refuse("--split", text, "expected EDGE:MM,MM ...: millimetres along the edge, ascending, 8 at most");
}


static mus_status split(mus_pattern *pattern, const cut *c)
{
    int32_t edge = edge_at(pattern, &c->edge);
    mus_status status = MUS_OK;
    for (int32_t i = 0; i < c->n && status == MUS_OK; i++)
        status = mus_pattern_split_edge(pattern, edge, c->at[i] - (i > 0 ? c->at[i - 1] : 0.0), NULL, &edge);
    return status;
}


static mus_status read_piece(const mus_pattern *pattern, const char *text, piece *out)
{
    const piece none = {.edge.panel = MUS_NONE};
    char *word, *rest = NULL;
    *out = none;
    if (snprintf(out->text, sizeof out->text, "%s", text) >= (int)sizeof out->text)
        return refuse("--piece", text, "longer than 127 bytes");
    char *name = strtok_r(out->text, " ", &rest), *equals = name != NULL ? strchr(name, '=') : NULL;
    if (equals != NULL) {
        *equals = '\0';
        out->other = equals + 1;
    }
    out->panel = mus_pattern_find_panel(pattern, name);
    if (out->panel == MUS_NONE) return refuse("--piece", text, "no panel of this name");
    while ((word = strtok_r(NULL, " ", &rest)) != NULL) {
        char *end = word + strlen(word);
        if (strcmp(word, "leave") == 0)
            out->leave = true;
        else if (strcmp(word, "pair") == 0)
            out->pair = true;
        else if (strcmp(word, "fold") == 0)
            out->fold = true;
        else if (strncmp(word, "fold:", 5) == 0)
            out->edge = read_edge(pattern, word + 5, &end);
        else if (out->label == NULL)
            out->label = word;
        else
            return refuse("--piece", text, "expected NAME[=NEW] [leave|fold|fold:EDGE|pair] [LABEL]");
        if (strncmp(word, "fold:", 5) != 0) continue;
        if (*end != '\0' || out->edge.panel != out->panel)
            return refuse("--piece", text, "the panel has no edge of the number after fold:");
        out->fold = true;
    }
    if (out->leave + out->fold + out->pair > 1) return refuse("--piece", text, "leave, fold, pair: one of them");
    return MUS_OK;
}


/* the longest straight edge of a panel; MUS_NONE without one */
static int32_t longest_straight(const mus_pattern *pattern, int32_t panel)
{
    int32_t found = MUS_NONE;
    double longest = 0.0;
    for (int32_t edge = 0; edge < mus_pattern_edge_count(pattern); edge++) {
        const edge_place own = place_of(pattern, edge);
        if (own.panel != panel || own.length - apart(own.start, own.end) > STRAIGHT || own.length <= longest) continue;
        longest = own.length;
        found = edge;
    }
    return found;
}


/* the name of the second piece of a pair: left and right exchanged, else with _mirror; `out`: 2 * PIECE_TEXT bytes */
static void image_name(const char *name, char *out)
{
    const char *left = strstr(name, "left"), *right = strstr(name, "right");
    const char *at = left != NULL ? left : right;
    if (at == NULL)
        snprintf(out, 2 * PIECE_TEXT, "%s_mirror", name);
    else
        snprintf(out, 2 * PIECE_TEXT, "%.*s%s%s", (int)(at - name), name, at == left ? "right" : "left",
                 at + (at == left ? 4 : 5));
}


static mus_status complete(mus_pattern *pattern, const piece *p)
{
    char image[2 * PIECE_TEXT];
    mus_status status = MUS_OK;
    if (p->other != NULL) status = mus_pattern_set_panel_name(pattern, p->panel, p->other);
    if (p->label != NULL && status == MUS_OK) status = mus_pattern_set_panel_label(pattern, p->panel, p->label);
    if (status != MUS_OK) return status;
    if (p->pair) {
        image_name(mus_pattern_panel_name(pattern, p->panel), image);
        return mus_pattern_mirror_panel(pattern, p->panel, image, NULL);
    }
    if (!p->fold) return MUS_OK;
    const bool told = p->edge.panel != MUS_NONE;
    return mus_pattern_unfold(pattern, told ? edge_at(pattern, &p->edge) : longest_straight(pattern, p->panel));
}


mus_status seams_pieces(mus_pattern *pattern, const texts *splits, const texts *pieces)
{
    cut cuts[sizeof splits->at / sizeof *splits->at];
    piece p[sizeof pieces->at / sizeof *pieces->at];
    const mus_context *context = mus_pattern_context(pattern);
    mus_status status = MUS_OK;
    for (int32_t i = 0; i < splits->count && status == MUS_OK; i++)
        status = read_split(pattern, splits->at[i], &cuts[i]);
    for (int32_t i = 0; i < pieces->count && status == MUS_OK; i++)
        status = read_piece(pattern, pieces->at[i], &p[i]);
    for (int32_t i = 0; i < splits->count && status == MUS_OK; i++) {
        status = split(pattern, &cuts[i]);
        if (status != MUS_OK) return refuse("--split", splits->at[i], mus_context_error(context));
    }
    for (int32_t i = 0; i < pieces->count && status == MUS_OK; i++) {
        status = p[i].leave ? MUS_OK : complete(pattern, &p[i]);
        if (status != MUS_OK) return refuse("--piece", pieces->at[i], mus_context_error(context));
    }
    /* from the last panel to the first: the numbers of those before a panel that is taken out stay */
    for (int32_t panel = mus_pattern_panel_count(pattern) - 1; panel >= 0 && status == MUS_OK; panel--)
        for (int32_t i = 0; i < pieces->count; i++)
            if (p[i].leave && p[i].panel == panel) status = mus_pattern_remove_panel(pattern, panel);
    return status;
}
