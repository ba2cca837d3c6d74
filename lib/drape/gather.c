/*
 * gather.c: the irregular items of a plan, sorted by the node that they act on.
 *
 * A spring stands at both of its ends, as a half spring. A hinge k (sum c x)^2 / 2 is linear and its c sum to 0, so
 * its force on node i is  sum over j of  -k c_i c_j (x_j - x_i):  all hinges at a node become one weight for each
 * neighbour, which a half spring to the same neighbour takes over. Everything is computed at the node that it acts on,
 * twice, and nothing is scattered.
 */
#include <stdlib.h>
#include <string.h>

#include "drape/plan.h"


mus_status mus__plan_gather_new(mus_context *context, const mus_cloth *cloth, mus__plan *plan)
{
    const int64_t halves = 2 * (int64_t)plan->spring_capacity, weights = 12 * (int64_t)plan->hinge_capacity;
    plan->gather_node = mus__new(context, cloth->nnode, sizeof *plan->gather_node);
    plan->half_start = mus__new(context, (int64_t)cloth->nnode + 1, sizeof *plan->half_start);
    plan->linear_start = mus__new(context, (int64_t)cloth->nnode + 1, sizeof *plan->linear_start);
    plan->half_other = mus__new(context, halves, sizeof *plan->half_other);
    plan->half_constant = mus__new(context, 3 * halves, plan->real);
    plan->linear_other = mus__new(context, weights, sizeof *plan->linear_other);
    plan->linear_weight = mus__new(context, weights, plan->real);
    plan->pair_end = mus__new(context, 2 * (int64_t)cloth->npair, sizeof *plan->pair_end);
    if (plan->gather_node == NULL || plan->half_start == NULL || plan->linear_start == NULL ||
        plan->half_other == NULL || plan->half_constant == NULL || plan->linear_other == NULL ||
        plan->linear_weight == NULL || plan->pair_end == NULL)
        return mus__fail_memory(context, "the irregular part of a drape");
    return MUS_OK;
}


/* the next free place of a node's list: start[i + 1] is its cursor while lists are filled */
static int32_t gather_next(int32_t *start, int32_t node)
{
    return start[node + 1]++;
}


/* counts of each node's entries to starts: after this start[i + 1] is where node i's list begins */
static void gather_open(int32_t *start, int32_t n)
{
    int32_t total = 0;
    for (int32_t i = 1; i <= n; i++) {
        const int32_t count = start[i];
        start[i] = total;
        total += count;
    }
}


static void gather_springs(mus__plan *plan, int32_t nnode)
{
    int32_t *start = plan->half_start;
    memset(start, 0, ((size_t)nnode + 1) * sizeof *start);
    for (int32_t s = 0; s < plan->nspring; s++) start[plan->spring[s].a + 1]++, start[plan->spring[s].b + 1]++;
    gather_open(start, nnode);
    for (int32_t s = 0; s < plan->nspring; s++) {
        const mus__spring *spring = &plan->spring[s];
        for (int32_t side = 0; side < 2; side++) {
            const int32_t at = gather_next(start, side ? spring->b : spring->a);
            plan->half_other[at] = side ? spring->a : spring->b;
            mus__plan_put(plan, plan->half_constant, 3 * (int64_t)at, spring->k);
            mus__plan_put(plan, plan->half_constant, 3 * (int64_t)at + 1, spring->k * spring->rest);
            mus__plan_put(plan, plan->half_constant, 3 * (int64_t)at + 2, plan->spring_dashpot[s]);
        }
    }
}


static void gather_hinges(mus__plan *plan, int32_t nnode)
{
    int32_t *start = plan->linear_start;
    memset(start, 0, ((size_t)nnode + 1) * sizeof *start);
    for (int32_t h = 0; h < plan->nhinge; h++)
        for (int32_t i = 0; i < 4; i++) start[plan->hinge[h].node[i] + 1] += 3;
    gather_open(start, nnode);
    for (int32_t h = 0; h < plan->nhinge; h++) {
        const mus__hinge *hinge = &plan->hinge[h];
        for (int32_t i = 0; i < 4; i++)
            for (int32_t j = 0; j < 4; j++) {
                if (i == j) continue;
                const int32_t at = gather_next(start, hinge->node[i]);
                plan->linear_other[at] = hinge->node[j];
                mus__plan_put(plan, plan->linear_weight, at, -hinge->k * hinge->coef[i] * hinge->coef[j]);
            }
    }
}


/* entries first .. last-1 by neighbour, those of one neighbour in their old order */
static void gather_sort(mus__plan *plan, int32_t first, int32_t last)
{
    for (int32_t i = first + 1; i < last; i++) {
        const int32_t other = plan->linear_other[i];
        const double w = mus__plan_number(plan, plan->linear_weight, i);
        int32_t at = i;
        for (; at > first && plan->linear_other[at - 1] > other; at--) {
            plan->linear_other[at] = plan->linear_other[at - 1];
            mus__plan_put(plan, plan->linear_weight, at, mus__plan_number(plan, plan->linear_weight, at - 1));
        }
        plan->linear_other[at] = other;
        mus__plan_put(plan, plan->linear_weight, at, w);
    }
}


/*
 * Sorted weights first .. last-1 of a node: one for each neighbour, to the half spring that goes there if there is one,
 * else written at `out`. Returns one past the last written.
 */
static int32_t gather_merge(mus__plan *plan, int32_t node, int32_t first, int32_t last, int32_t out)
{
    for (int32_t i = first; i < last;) {
        const int32_t other = plan->linear_other[i];
        double sum = 0.0;
        for (; i < last && plan->linear_other[i] == other; i++)
            sum += mus__plan_number(plan, plan->linear_weight, i);
        if (other == node) continue;

        int32_t half = plan->half_start[node];
        while (half < plan->half_start[node + 1] && plan->half_other[half] != other) half++;
        if (half < plan->half_start[node + 1]) {
            const double k = mus__plan_number(plan, plan->half_constant, 3 * (int64_t)half);
            mus__plan_put(plan, plan->half_constant, 3 * (int64_t)half, k + sum);
        } else {
            plan->linear_other[out] = other;
            mus__plan_put(plan, plan->linear_weight, out++, sum);
        }
    }
    return out;
}


static int gather_by_node(const void *a, const void *b)
{
    const mus__pair_end *p = a, *q = b;
    if (p->node != q->node) return p->node < q->node ? -1 : 1;
    return p->pair < q->pair ? -1 : p->pair > q->pair;
}


static void gather_pairs(mus__plan *plan)
{
    for (int32_t p = 0; p < plan->npair; p++) {
        const mus__pair *pair = &plan->pair[p];
        plan->pair_end[2 * p] = (mus__pair_end){pair->a, pair->b, p};
        plan->pair_end[2 * p + 1] = (mus__pair_end){pair->b, pair->a, p};
    }
    qsort(plan->pair_end, 2 * (size_t)plan->npair, sizeof *plan->pair_end, gather_by_node);
}


void mus__plan_gather(const mus_cloth *cloth, mus__plan *plan)
{
    gather_springs(plan, cloth->nnode);
    gather_hinges(plan, cloth->nnode);
    gather_pairs(plan);

    plan->ngather = 0;
    int32_t out = 0;
    for (int32_t i = 0, first = 0; i < cloth->nnode; i++) {
        const int32_t last = plan->linear_start[i + 1], named = plan->half_start[i + 1] > plan->half_start[i];
        if (named || last > first) plan->gather_node[plan->ngather++] = i;
        gather_sort(plan, first, last);
        out = gather_merge(plan, i, first, last, out);
        first = last;
        plan->linear_start[i + 1] = out;
    }

    /* what falls into each chunk */
    int32_t g = 0, e = 0;
    for (int32_t c = 0; c < plan->nchunk; c++) {
        mus__chunk *chunk = &plan->chunk[c];
        const int32_t until = chunk->first + chunk->count;
        chunk->gather = g, chunk->end = e;
        while (g < plan->ngather && plan->gather_node[g] < until) g++;
        while (e < 2 * plan->npair && plan->pair_end[e].node < until) e++;
        chunk->ngather = g - chunk->gather, chunk->nend = e - chunk->end;
    }
}
