/*
 * quotient.h: a pattern with its seams glued: classes of edges and points. All of lib/topology stands on it.
 *
 * The words of all panels stand one after another: position k of them is a sheet of cloth that ends at an edge.
 */
#ifndef MUS_TOPOLOGY_QUOTIENT_H
#define MUS_TOPOLOGY_QUOTIENT_H

#include "muslin/topology.h"
#include "pattern/pattern_internal.h"

typedef struct mus__quotient {
    int32_t nword;
    int32_t *first;  /* (npanel + 1) where the word of each panel starts */
    int32_t *edge;   /* (nword) */
    int32_t *turn;   /* (nword) direction of the word along its edge, +1 or -1 */
    int32_t *panel;  /* (nword) */
    int32_t *place;  /* (nedge) first position of the edge in the words, MUS_NONE for an edge of no outline */
    int32_t *root;   /* (nedge) class of each edge */
    int32_t *sign;   /* (nedge) +1 the edge runs as the root of its class does, -1 against it */
    int32_t *sheets; /* (nedge) by class: how many positions */
    int32_t *sheet;  /* (nedge x 2) by class: the first two positions */
    int32_t *point;  /* (npoint) class of each point */
    int32_t *link;   /* (the most of npoint, nword, npanel) scratch: classes of a union-find, and their signs: */
    int32_t *bias;
    bool folded;    /* an edge is glued to itself end over end */
    int32_t *block; /* holds all arrays above; owned */
} mus__quotient;

/* glue all seams; free with mus__free(context, out->block). With `partial` panels without outline are left out.
 * Errors: MUS_ERR_PATTERN (a panel without outline, and not `partial`), MUS_ERR_LIMIT, MUS_ERR_MEMORY */
mus_status mus__quotient_make(const mus_pattern *pattern, bool partial, mus__quotient *out);
/* the same with `sewn`; without it no seam is glued: the panels as cut */
mus_status mus__quotient_make_cells(const mus_pattern *pattern, bool partial, bool sewn, mus__quotient *out);
/* next position in the word of the same panel, along it (step +1) or against it (-1) */
int32_t mus__quotient_next(const mus__quotient *q, int32_t k, int32_t step);
/* two sheets at one edge, positions j and k of one class: do both panels have the same side of the cloth out? */
bool mus__quotient_same_side(const mus__quotient *q, int32_t j, int32_t k);
/* give each panel a side (q->bias) and a component (q->link). Returns how many seams contradict the others: 0 for a
 * garment with an inside and an outside. twisted (nseam, zeroed, may be NULL) gets 1 for each of those; *bridge an edge
 * at which a panel meets itself with the wrong side out, or MUS_NONE */
int32_t mus__quotient_sides(const mus_pattern *pattern, mus__quotient *q, int32_t *twisted, int32_t *bridge);
/* is an edge a line inside its panel: passed once each way by its word? */
bool mus__edge_inner(const mus__quotient *q, int32_t edge);

#endif
