/*
 * panel_outline.c: the outline of a panel as it is drawn, edge by edge, and the panel of the half made of it.
 */
#include "half/panel_outline.h"

#include <string.h>


void mus__outline_begin(mus__outline *outline)
{
    outline->n = 0;
}


void mus__outline_add(mus__outline *outline, const char *name, const char *label, double allowance,
                      const mus__chain *chain)
{
    MUS_ASSERT(outline->n < MUS__OUTLINE_EDGES && strlen(name) < MUS__OUTLINE_NAME_BYTES);
    mus__outline_edge *edge = &outline->edge[outline->n++];
    memset(edge->name, 0, sizeof edge->name);
    memcpy(edge->name, name, strlen(name));
    edge->label = label;
    edge->allowance = allowance;
    edge->chain = *chain;
}


void mus__outline_line(mus__outline *outline, const char *name, const char *label, double allowance,
                       const double *start, const double *end)
{
    mus__chain chain;
    mus__chain_line(&chain, start, end);
    mus__outline_add(outline, name, label, allowance, &chain);
}


void mus__outline_append(mus__outline *outline, const mus__outline *more)
{
    for (int32_t i = 0; i < more->n; i++) {
        const mus__outline_edge *edge = &more->edge[i];
        mus__outline_add(outline, edge->name, edge->label, edge->allowance, &edge->chain);
    }
}


double mus__outline_length(const mus__outline *outline, const char *label)
{
    double length = 0.0;
    for (int32_t i = 0; i < outline->n; i++)
        if (strcmp(outline->edge[i].label, label) == 0) length += mus__chain_length(&outline->edge[i].chain);
    return length;
}


int32_t mus__outline_panel(mus__half *half, const mus__outline *outline, const char *name, const char *label,
                           bool mirror)
{
    mus__board *board = &half->board;
    const int32_t panel = mus__board_panel_add(board, name, label);
    for (int32_t i = 0; i < outline->n; i++) {
        const mus__outline_edge *edge = &outline->edge[mirror ? outline->n - 1 - i : i];
        mus__chain chain = edge->chain;
        if (mirror) mus__chain_mirror(&chain);
        const int32_t side = mus__board_side_add(board, panel, edge->name, edge->label, chain.npiece, chain.kinds,
                                                 chain.nxy, chain.xy);
        if (side != MUS_NONE) board->side[side].attr.allowance = edge->allowance;
    }
    mus__board_panel_close(board, panel);
    return panel;
}
