/*
 * piece.c: from a drawing to a panel: edges in order, unfolded or mirrored, with seams, notches and marks.
 *
 * A drawing is a list of chains that run counter-clockwise as seen from outside. A mirrored panel has every chain
 * mirrored and the order reversed, so it runs counter-clockwise too. After a failure nothing more is done: the draft's
 * status stays.
 */
#include <math.h>
#include <string.h>

#include "design/recipe.h"


void mus__piece_begin(mus__piece *piece, mus__draft *draft)
{
    memset(piece, 0, sizeof *piece);
    piece->draft = draft;
    piece->panel = MUS_NONE;
}


void mus__piece_edge_add(mus__piece *piece, const char *name, const char *label, double allowance,
                         const mus__chain *chain)
{
    MUS_ASSERT(piece->n < MUS__PIECE_EDGES);
    mus__piece_edge *edge = &piece->edges[piece->n++];
    memset(edge->name, 0, sizeof edge->name);
    memcpy(edge->name, name, strlen(name) < MUS__EDGE_NAME_BYTES ? strlen(name) : MUS__EDGE_NAME_BYTES - 1);
    edge->label = label;
    edge->allowance = allowance;
    edge->chain = *chain;
    edge->edge = MUS_NONE;
}


void mus__piece_unfold(mus__piece *piece, int32_t first, int32_t last)
{
    for (int32_t i = last; i >= first; i--) {
        const mus__piece_edge *from = &piece->edges[i];
        char name[MUS__EDGE_NAME_BYTES];
        memcpy(name, from->name, sizeof name);
        char *side = name + strlen(name) - 1;
        if (*side == 'L') *side = 'R';
        else if (*side == 'R') *side = 'L';
        mus__chain chain = from->chain;
        mus__chain_mirror(&chain);
        mus__piece_edge_add(piece, name, from->label, from->allowance, &chain);
    }
}


/* one edge between two points of the panel */
static mus_status piece_panel_edge(mus_pattern *pattern, mus__piece_edge *edge, const mus__chain *chain, int32_t start,
                                  int32_t end)
{
    mus_status status = mus_pattern_add_edge(pattern, &(mus_edge_def){.size = sizeof(mus_edge_def),
                                                                      .name = edge->name, .start = start,
                                                                      .end = end, .npiece = chain->npiece,
                                                                      .kinds = chain->kinds, .nxy = chain->nxy - 2,
                                                                      .xy = chain->nxy > 2 ? chain->xy + 2 : NULL},
                                             &edge->edge);
    if (status == MUS_OK && edge->label != NULL)
        status = mus_pattern_set_edge_label(pattern, edge->edge, edge->label);
    if (status == MUS_OK) status = mus_pattern_set_edge_allowance(pattern, edge->edge, edge->allowance);
    return status;
}


void mus__piece_panel(mus__piece *piece, const char *name, const char *label, bool mirror)
{
    mus__draft *draft = piece->draft;
    if (draft->status != MUS_OK) return;
    mus_pattern *pattern = draft->pattern;
    const int32_t n = piece->n;
    int32_t point[MUS__PIECE_EDGES], edges[MUS__PIECE_EDGES], forward[MUS__PIECE_EDGES];
    mus__chain chain[MUS__PIECE_EDGES];
    mus__piece_edge *order[MUS__PIECE_EDGES];
    piece->mirror = mirror;
    for (int32_t i = 0; i < n; i++) {
        order[i] = &piece->edges[mirror ? n - 1 - i : i];
        chain[i] = order[i]->chain;
        if (mirror) mus__chain_mirror(&chain[i]);
    }

    mus_status status = mus_pattern_add_panel(pattern, name, &piece->panel);
    for (int32_t i = 0; i < n && status == MUS_OK; i++)
        status = mus_pattern_add_point(pattern, piece->panel, chain[i].xy[0], chain[i].xy[1], &point[i]);
    for (int32_t i = 0; i < n && status == MUS_OK; i++) {
        status = piece_panel_edge(pattern, order[i], &chain[i], point[i], point[(i + 1) % n]);
        edges[i] = order[i]->edge;
        forward[i] = 1;
    }
    if (status == MUS_OK) status = mus_pattern_set_outline(pattern, piece->panel, n, edges, forward);
    if (status == MUS_OK) status = mus_pattern_set_panel_label(pattern, piece->panel, label);
    if (status == MUS_OK) status = mus_pattern_set_cut(pattern, piece->panel, 1, MUS_NONE);
    draft->status = status;
}


int32_t mus__piece_edge_find(const mus__piece *piece, const char *name)
{
    for (int32_t i = 0; i < piece->n; i++)
        if (strcmp(piece->edges[i].name, name) == 0) return piece->edges[i].edge;
    return MUS_NONE;
}


void mus__piece_notch(mus__piece *piece, const char *edge, double s, int32_t kind)
{
    mus__draft *draft = piece->draft;
    if (draft->status != MUS_OK) return;
    const int32_t index = mus__piece_edge_find(piece, edge);
    const double length = mus_pattern_edge_length(draft->pattern, index);
    int32_t notch;
    if (!(s > 0.0 && s < length)) return; /* it would fall on a corner, which marks itself */
    draft->status = mus_pattern_add_notch(draft->pattern, index, piece->mirror ? length - s : s, kind, &notch);
}


void mus__piece_mark(mus__piece *piece, const char *name, const double *start, const double *end)
{
    mus__draft *draft = piece->draft;
    if (draft->status != MUS_OK) return;
    const double turn = piece->mirror ? -1.0 : 1.0;
    const double xy[4] = {turn * start[0], start[1], turn * end[0], end[1]};
    int32_t mark;
    draft->status = mus_pattern_add_mark(draft->pattern, piece->panel, name, 2, xy, &mark);
}


void mus__piece_seam(const mus__piece *a, const char *edge_a, const mus__piece *b, const char *edge_b, double ease)
{
    mus__draft *draft = a->draft;
    if (draft->status != MUS_OK) return;
    mus_seam_def seam;
    int32_t index;
    mus_seam_def_init(&seam, sizeof seam);
    seam.edge_a = mus__piece_edge_find(a, edge_a);
    seam.edge_b = mus__piece_edge_find(b, edge_b);
    seam.ease = ease;
    draft->status = mus_pattern_add_seam(draft->pattern, &seam, &index);
}


void mus__piece_pair(const mus__piece *piece, const mus__piece *twin)
{
    mus__draft *draft = piece->draft;
    if (draft->status != MUS_OK) return;
    draft->status = mus_pattern_set_cut(draft->pattern, piece->panel, 2, MUS_NONE);
    if (draft->status == MUS_OK) draft->status = mus_pattern_set_cut(draft->pattern, twin->panel, 1, piece->panel);
}
