/*
 * seam_propose.c: the public call: seams for a pattern whose file has none, with a confidence and a second choice.
 *
 * The confidence is a logistic function of the margin: the score of the sewing less that of the best sewing without the
 * seam. Its two numbers stand with the weights, fitted to the same half of the data.
 */
#include <string.h>

#include "muslin/exchange.h"
#include "seam/seam_find.h"
#include "base/elementary.h"
#include "base/sort.h"

#define PROPOSE_ROUNDS 4 /* of annealing; chosen: the second to fourth find a better sewing for 1 garment in 10 */

typedef struct proposal {
    int32_t a, b, chosen;
    double confidence;
} proposal;


static int compare_proposals(const void *x, const void *y)
{
    const proposal *p = x, *q = y;
    if (p->chosen != q->chosen) return q->chosen - p->chosen;
    return (p->confidence < q->confidence) - (p->confidence > q->confidence);
}


/* the second choice of an edge, unless its other edge had the same one */
static void add_second(proposal *list, int32_t *count, int32_t a, int32_t b, double confidence)
{
    for (int32_t i = 0; i < *count; i++)
        if (!list[i].chosen && list[i].a == b && list[i].b == a) {
            if (confidence > list[i].confidence) list[i].confidence = confidence;
            return;
        }
    const proposal second = {a, b, 0, confidence};
    list[(*count)++] = second;
}


static int32_t list_proposals(mus__seam_search *search, proposal *list)
{
    const mus__seam_facts *facts = search->facts;
    int32_t count = 0;
    for (int32_t a = 0; a < facts->n; a++) {
        const int32_t b = search->mate[a];
        int32_t other;
        if (facts->fixed[a] != MUS_NONE) continue;
        const double margin = mus__seam_margin(search, a, &other);
        const double p = 1.0 / (1.0 + mus__exp(-mus__seam_confidence[0] * margin - mus__seam_confidence[1]));
        const proposal first = {a, b, 1, p};
        if (b > a) list[count++] = first;
        if (other != MUS_NONE && other != b) add_second(list, &count, a, other, 1.0 - p);
    }
    mus__sort(list, (size_t)count, sizeof *list, compare_proposals);
    return count;
}


static mus_status propose(const mus__seam_facts *facts, proposal **list, int32_t *count)
{
    mus__seam_search search;
    double weights[MUS__SEAM_FEATURES];
    for (int32_t k = 0; k < MUS__SEAM_FEATURES; k++) weights[k] = MUS__SEAM_WEIGHT_UNIT * mus__seam_weights[k];
    mus_status status = mus__seam_begin(facts, weights, &search);
    if (status != MUS_OK) return status;
    *list = mus_context_alloc(facts->context, NULL, sizeof **list * 2 * (size_t)(facts->n + 1));
    if (*list != NULL) {
        mus__seam_run(&search, PROPOSE_ROUNDS);
        *count = list_proposals(&search, *list);
    } else {
        status = mus_context_fail(facts->context, MUS_ERR_MEMORY, "no memory for the seams of a pattern");
    }
    mus__seam_end(&search);
    return status;
}


mus_status mus_pattern_propose_seams(const mus_pattern *pattern, int32_t *edges, int32_t *chosen, double *confidence,
                                     int32_t capacity, int32_t *count)
{
    mus__seam_facts facts;
    proposal *list = NULL;
    int32_t n = 0;
    if (count != NULL) *count = 0;
    if (pattern == NULL || count == NULL || capacity < 0) return MUS_ERR_ARG;
    mus_status status = mus__seam_read(pattern, &facts);
    if (status == MUS_OK) status = propose(&facts, &list, &n);
    for (int32_t i = 0; i < n && i < capacity && status == MUS_OK; i++) {
        if (edges != NULL) edges[2 * i] = facts.edges[list[i].a].edge;
        if (edges != NULL) edges[2 * i + 1] = facts.edges[list[i].b].edge;
        if (chosen != NULL) chosen[i] = list[i].chosen;
        if (confidence != NULL) confidence[i] = list[i].confidence;
    }
    if (status == MUS_OK) *count = n;
    mus_context_alloc(facts.context, list, 0);
    mus__seam_free(&facts);
    return status;
}
