/*
 * gather.c: the irregular items of a plan, sorted by the node that they act on.
 *
 * A spring stands at both of its ends, as a half spring. A hinge k (sum c x)^2 / 2 is linear and its c sum to 0, so
 * its force on node i is  sum over j of  -k c_i c_j (x_j - x_i):  all hinges at a node become one weight for each
 * neighbour, which a half spring to the same neighbour takes over. Everything is computed at the node that it acts on,
 * twice, and nothing is scattered. The kernels read it by groups of nodes (lists.c).
 *
 * The lists are made twice: first of what acts between lattice nodes, of which the blocks take what they have slots
 * for, then of all the rest. Welding renames border nodes alone, and leaves out a hinge only if two of its nodes have
 * become one; so a hinge with one border node, and every spring between lattice nodes, stands in a block for good.
 */
#include <stdlib.h>
#include <string.h>

#include "drape/plan.h"


mus_status mus__plan_gather_new(mus_context *context, const mus_cloth *cloth, mus__plan *plan)
{
    const int64_t weights = 12 * (int64_t)plan->hinge_capacity;
    plan->gather_node = mus__new(context, cloth->nnode, sizeof *plan->gather_node);
    plan->half_start = mus__new(context, (int64_t)cloth->nnode + 1, sizeof *plan->half_start);
    plan->linear_start = mus__new(context, (int64_t)cloth->nnode + 1, sizeof *plan->linear_start);
    plan->linear_other = mus__new(context, weights, sizeof *plan->linear_other);
    plan->linear_weight = mus__new(context, weights, plan->real);
    plan->pair_end = mus__new(context, 2 * (int64_t)cloth->npair, sizeof *plan->pair_end);
    if (plan->gather_node == NULL || plan->half_start == NULL || plan->linear_start == NULL ||
        plan->linear_other == NULL || plan->linear_weight == NULL || plan->pair_end == NULL)
        return mus__fail_memory(context, "the irregular part of a drape");
    return mus__plan_halves_new(context, plan);
}


mus_status mus__plan_halves_new(mus_context *context, mus__plan *plan)
{
    const int64_t halves = 2 * (int64_t)plan->spring_capacity;
    plan->half_other = mus__new(context, halves, sizeof *plan->half_other);
    plan->half_constant = mus__new(context, 3 * halves, plan->real);
    if (plan->half_other == NULL || plan->half_constant == NULL)
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


/* does a spring's pull on `node` belong in the lists: of the lattice alone, or of all but what blocks hold? Tacks come
 * when blocks are long made */
static int32_t gather_wants_spring(const mus__plan *plan, int32_t lattice, int32_t kind, int32_t node, int32_t other)
{
    if (kind == MUS__SPRING_TACK) return !lattice;
    const int32_t between = plan->lattice[node] && plan->lattice[other];
    if (lattice || !between) return lattice == between;
    const int32_t slot = mus__plan_slot(plan, node, other);
    return slot == MUS_NONE || slot >= MUS_NEAR_MOST;
}


static int32_t gather_wants_hinge(const mus__plan *plan, int32_t lattice, const mus__hinge *hinge, int32_t i, int32_t j)
{
    int32_t border = 0;
    for (int32_t k = 0; k < 4; k++) border += !plan->lattice[hinge->node[k]];
    const int32_t node = hinge->node[i], other = hinge->node[j];
    const int32_t between = border < 2 && plan->lattice[node] && plan->lattice[other];
    if (node == other) return 0;
    if (lattice || !between) return lattice == between;
    return mus__plan_slot(plan, node, other) == MUS_NONE;
}


static void gather_springs(mus__plan *plan, int32_t nnode, int32_t lattice)
{
    int32_t *start = plan->half_start;
    memset(start, 0, ((size_t)nnode + 1) * sizeof *start);
    for (int32_t s = 0; s < 2 * plan->nspring; s++) {
        const mus__spring *spring = &plan->spring[s / 2];
        const int32_t node = s % 2 ? spring->b : spring->a, other = s % 2 ? spring->a : spring->b;
        start[node + 1] += gather_wants_spring(plan, lattice, spring->kind, node, other);
    }
    gather_open(start, nnode);
    for (int32_t s = 0; s < 2 * plan->nspring; s++) {
        const mus__spring *spring = &plan->spring[s / 2];
        const int32_t node = s % 2 ? spring->b : spring->a, other = s % 2 ? spring->a : spring->b;
        if (!gather_wants_spring(plan, lattice, spring->kind, node, other)) continue;
        const int32_t at = gather_next(start, node);
        plan->half_other[at] = other;
        mus__plan_put(plan, plan->half_constant, 3 * (int64_t)at, spring->k);
        mus__plan_put(plan, plan->half_constant, 3 * (int64_t)at + 1, spring->k * spring->rest);
        mus__plan_put(plan, plan->half_constant, 3 * (int64_t)at + 2, plan->spring_dashpot[s / 2]);
    }
}


static void gather_hinges(mus__plan *plan, int32_t nnode, int32_t lattice)
{
    int32_t *start = plan->linear_start;
    memset(start, 0, ((size_t)nnode + 1) * sizeof *start);
    for (int32_t h = 0; h < plan->nhinge; h++)
        for (int32_t k = 0; k < 16; k++)
            start[plan->hinge[h].node[k / 4] + 1] +=
                gather_wants_hinge(plan, lattice, &plan->hinge[h], k / 4, k % 4);
    gather_open(start, nnode);
    for (int32_t h = 0; h < plan->nhinge; h++) {
        const mus__hinge *hinge = &plan->hinge[h];
        for (int32_t k = 0; k < 16; k++) {
            if (!gather_wants_hinge(plan, lattice, hinge, k / 4, k % 4)) continue;
            const int32_t at = gather_next(start, hinge->node[k / 4]);
            plan->linear_other[at] = hinge->node[k % 4];
            mus__plan_put(plan, plan->linear_weight, at, -hinge->k * hinge->coef[k / 4] * hinge->coef[k % 4]);
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
 * Sorted weights first .. last-1 of a node: one for each neighbour, to the half spring that goes there if there is one
 * (not for the lattice, where blocks take springs and weights apart), else written at `out`. Returns one past the last
 * written.
 */
static int32_t gather_merge(mus__plan *plan, int32_t lattice, int32_t node, int32_t first, int32_t last, int32_t out)
{
    for (int32_t i = first; i < last;) {
        const int32_t other = plan->linear_other[i];
        double sum = 0.0;
        for (; i < last && plan->linear_other[i] == other; i++)
            sum += mus__plan_number(plan, plan->linear_weight, i);
        int32_t half = lattice ? plan->half_start[node + 1] : plan->half_start[node];
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


/* both lists by node, and which nodes have any */
static void gather_lists(const mus_cloth *cloth, mus__plan *plan, int32_t lattice)
{
    gather_springs(plan, cloth->nnode, lattice);
    gather_hinges(plan, cloth->nnode, lattice);
    plan->ngather = 0;
    int32_t first = 0, out = 0;
    for (int32_t i = 0; i < cloth->nnode; i++) {
        const int32_t last = plan->linear_start[i + 1], springs = plan->half_start[i + 1] > plan->half_start[i];
        if (springs || last > first) plan->gather_node[plan->ngather++] = i;
        gather_sort(plan, first, last);
        out = gather_merge(plan, lattice, i, first, last, out);
        first = last;
        plan->linear_start[i + 1] = out;
    }
}


void mus__plan_gather_lattice(const mus_cloth *cloth, mus__plan *plan)
{
    gather_lists(cloth, plan, 1);
}


void mus__plan_gather(const mus_cloth *cloth, mus__plan *plan)
{
    gather_lists(cloth, plan, 0);
    gather_pairs(plan);

    mus__plan_lists(plan);

    /* pair ends and held nodes of each chunk */
    for (int32_t c = 0, e = 0, h = 0; c < plan->nchunk; c++) {
        mus__chunk *chunk = &plan->chunk[c];
        chunk->end = e;
        while (e < 2 * plan->npair && plan->pair_end[e].node < chunk->first + chunk->count) e++;
        chunk->nend = e - chunk->end;
        chunk->held = h;
        while (h < plan->nheld && plan->held[h].node < chunk->first + chunk->count) h++;
        chunk->nheld = h - chunk->held;
    }
}
