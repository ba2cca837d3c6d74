/*
 * homology.c: the chain complex of a pattern, cut or sewn: cells, boundary operators over the integers, homology.
 *
 * Cells: classes of points that an outline passes, classes of edges that an outline passes, panels; each numbered in
 * the order of its lowest member. The boundary of an edge is its end less its start; that of a panel is its word,
 * each edge with the sign of its class. An edge that is sewn to itself end over end is half an edge: its middle is one
 * more point, and the word goes there and back.
 *
 *     0 --> Z^panels --d2--> Z^edges --d1--> Z^points --> 0        d1 d2 = 0
 *     b0 = V - rank d1,  b1 = E - rank d1 - rank d2,  b2 = F - rank d2;  torsion of H1: factors of d2 above 1
 *
 * Source: Munkres, Elements of Algebraic Topology, 1984, section 11; Metaaphanon and Kanongchaiyos 2005, section 5.1.
 */
#include <string.h>

#include "topology/homology.h"
#include "topology/quotient.h"

/* the cells of the complex; an operator is triples (n x 3): row, column, value */
typedef struct chain {
    int32_t cells[3];
    int32_t *point; /* (npoint) cell of the class whose root it is, MUS_NONE for no cell */
    int32_t *edge;  /* (nedge) */
    int32_t *fold;  /* (nedge) cell of the middle of a folded class, else MUS_NONE */
    int32_t *block;
} chain;


void mus_homology_init(mus_homology *homology, size_t size)
{
    mus_homology own = {0};
    mus__def_init(homology, size, &own, sizeof own);
}


/* set fold (nedge) to 1 for the classes whose edge is sewn to itself end over end */
static void chain_folds(const mus_pattern *pattern, const mus__quotient *q, int32_t *fold)
{
    for (int32_t i = 0; i < pattern->nseam; i++) {
        const mus_seam_def *seam = &pattern->seam[i];
        int32_t meant = seam->direction == MUS_SEAM_DIRECT ? 1 : -1;
        if (q->sign[seam->edge_a] * q->sign[seam->edge_b] != meant) fold[q->root[seam->edge_a]] = 1;
    }
}


/* number the cells */
static mus_status chain_make(const mus_pattern *pattern, const mus__quotient *q, chain *out)
{
    int64_t npoint = pattern->npoint, nedge = pattern->nedge;
    *out = (chain){.cells = {0, 0, pattern->npanel}};
    out->block = mus__new(pattern->context, npoint + 2 * nedge + 1, sizeof *out->block);
    if (out->block == NULL) return mus__fail_memory(pattern->context, "the homology of a pattern");
    out->point = out->block;
    out->edge = out->point + npoint;
    out->fold = out->edge + nedge;
    for (int64_t i = 0; i < npoint + nedge; i++) out->block[i] = MUS_NONE;
    if (q->folded) chain_folds(pattern, q, out->fold);

    /* which classes an outline passes; then their numbers in order */
    for (int32_t k = 0; k < q->nword; k++) {
        const mus__edge *edge = &pattern->edge[q->edge[k]];
        out->edge[q->root[q->edge[k]]] = 0;
        out->point[q->point[edge->start]] = out->point[q->point[edge->end]] = 0;
    }
    for (int32_t i = 0; i < pattern->npoint; i++)
        if (out->point[i] == 0) out->point[i] = out->cells[0]++;
    for (int32_t i = 0; i < pattern->nedge; i++) {
        bool folded = out->fold[i] != 0 && out->edge[i] != MUS_NONE;
        if (out->edge[i] != MUS_NONE) out->edge[i] = out->cells[1]++;
        out->fold[i] = folded ? out->cells[0]++ : MUS_NONE;
    }
    return MUS_OK;
}


/* d1: end less start of each class; at most 2 E triples */
static int32_t chain_ends(const mus_pattern *pattern, const mus__quotient *q, const chain *c, int32_t *triple)
{
    int32_t n = 0;
    for (int32_t i = 0; i < pattern->nedge; i++) {
        if (c->edge[i] == MUS_NONE || q->root[i] != i) continue;
        int32_t start = c->point[q->point[pattern->edge[i].start]], end = c->point[q->point[pattern->edge[i].end]];
        if (c->fold[i] != MUS_NONE) end = c->fold[i];
        if (start == end) continue;
        int32_t both[6] = {start, c->edge[i], -1, end, c->edge[i], 1};
        memcpy(triple + 3 * (size_t)n, both, sizeof both);
        n += 2;
    }
    return n;
}


/* d2: the words, each edge of a panel once; at most nword triples */
static int32_t chain_words(const mus_pattern *pattern, const mus__quotient *q, const chain *c, int32_t *triple)
{
    int32_t n = 0;
    for (int32_t i = 0; i < pattern->npanel; i++) {
        int32_t first = n;
        for (int32_t k = q->first[i]; k < q->first[i + 1]; k++) {
            int32_t edge = q->edge[k], root = q->root[edge];
            if (c->fold[root] != MUS_NONE) continue;
            int32_t j = first;
            while (j < n && triple[3 * (size_t)j] != c->edge[root]) j++;
            int32_t *own = triple + 3 * (size_t)j;
            if (j == n) own[0] = c->edge[root], own[1] = i, own[2] = 0, n++;
            own[2] += q->turn[k] * q->sign[edge];
        }

        /* a folded edge is passed there and back: its sum is 0 */
        int32_t kept = first;
        for (int32_t j = first; j < n; j++) {
            if (triple[3 * (size_t)j + 2] == 0) continue;
            memmove(triple + 3 * (size_t)kept, triple + 3 * (size_t)j, 3 * sizeof *triple);
            kept++;
        }
        n = kept;
    }
    return n;
}


/* cells and the triples of both operators: d1 in triple[0], d2 in triple[1]; n (2). One block: *block */
static mus_status chain_operators(const mus_pattern *pattern, int32_t sewn, int32_t *cells, int32_t **triple,
                                  int32_t *n, int32_t **block)
{
    mus__quotient q = {0};
    chain c = {0};
    *block = NULL;
    mus_status status = mus__quotient_make_cells(pattern, false, sewn != 0, &q);
    if (status == MUS_OK) status = chain_make(pattern, &q, &c);
    if (status == MUS_OK) {
        *block = mus__new(pattern->context, 6 * (int64_t)pattern->nedge + 3 * (int64_t)q.nword, sizeof **block);
        if (*block == NULL) status = mus__fail_memory(pattern->context, "the homology of a pattern");
    }
    if (status == MUS_OK) {
        triple[0] = *block;
        triple[1] = *block + 6 * (size_t)pattern->nedge;
        n[0] = chain_ends(pattern, &q, &c, triple[0]);
        n[1] = chain_words(pattern, &q, &c, triple[1]);
        memcpy(cells, c.cells, sizeof c.cells);
    }
    mus__free(pattern->context, c.block);
    mus__free(pattern->context, q.block);
    return status;
}


mus_status mus__homology(mus_context *context, const int32_t *cells, const int32_t *n, int32_t *const *triple,
                         mus_homology *out, int32_t *torsion, int32_t capacity)
{
    int32_t *factor = mus__new(context, (int64_t)(cells[1] > cells[2] ? cells[1] : cells[2]) + 1, sizeof *factor);
    if (factor == NULL) return mus__fail_memory(context, "the homology of a pattern");
    mus_status status = mus__smith(context, cells[0], n[0], triple[0], &out->rank[0], factor);
    if (status == MUS_OK) status = mus__smith(context, cells[1], n[1], triple[1], &out->rank[1], factor);
    if (status == MUS_OK) {
        for (int32_t d = 0; d < 3; d++)
            out->betti[d] = cells[d] - (d > 0 ? out->rank[d - 1] : 0) - (d < 2 ? out->rank[d] : 0);
        out->euler = cells[0] - cells[1] + cells[2];
        for (int32_t i = 0; i < out->rank[1]; i++) {
            if (factor[i] == 1) continue;
            if (torsion != NULL && out->torsion < capacity) torsion[out->torsion] = factor[i];
            out->torsion++;
        }
        memcpy(out->cells, cells, sizeof out->cells);
    }
    mus__free(context, factor);
    return status;
}


mus_status mus_pattern_homology(const mus_pattern *pattern, int32_t sewn, mus_homology *out, int32_t *torsion,
                                int32_t capacity)
{
    if (pattern == NULL) return MUS_ERR_ARG;
    mus_context *context = pattern->context;
    if (out == NULL) return mus__fail(context, MUS_ERR_ARG, "homology: out is NULL");
    if (torsion != NULL && capacity < 0)
        return mus__fail(context, MUS_ERR_ARG, "homology: room for %d coefficients", (int)capacity);
    int32_t cells[3] = {0}, n[2] = {0}, *triple[2] = {NULL, NULL}, *block;
    mus_homology own;
    mus_homology_init(&own, sizeof own);
    mus_status status = chain_operators(pattern, sewn, cells, triple, n, &block);
    if (status == MUS_OK) status = mus__homology(pattern->context, cells, n, triple, &own, torsion, capacity);
    mus__free(context, block);
    return status == MUS_OK ? mus__pattern_give(pattern, out, &own, sizeof own, "homology") : status;
}


mus_status mus_pattern_boundary(const mus_pattern *pattern, int32_t sewn, int32_t dimension, int32_t *triples,
                                int32_t capacity, int32_t *count)
{
    if (count != NULL) *count = 0;
    if (pattern == NULL) return MUS_ERR_ARG;
    if (dimension < 1 || dimension > 2)
        return mus__fail(pattern->context, MUS_ERR_ARG, "boundary: dimension %d is neither 1 nor 2", (int)dimension);
    if (triples != NULL && capacity < 0)
        return mus__fail(pattern->context, MUS_ERR_ARG, "boundary: room for %d triples", (int)capacity);
    int32_t cells[3] = {0}, n[2] = {0}, *triple[2] = {NULL, NULL}, *block;
    mus_status status = chain_operators(pattern, sewn, cells, triple, n, &block);
    if (status == MUS_OK) {
        int32_t all = n[dimension - 1], some = all < capacity ? all : capacity;
        if (triples != NULL && some > 0) memcpy(triples, triple[dimension - 1], 3 * (size_t)some * sizeof *triples);
        if (count != NULL) *count = all;
    }
    mus__free(pattern->context, block);
    return status;
}
