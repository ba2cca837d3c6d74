/*
 * force_program_irregular.c: the irregular part of a program: items off the lattice, sorted by the node that they act
 * on.
 *
 * A spring stands at both of its ends, as a half spring. A hinge k (sum c x)^2 / 2 is linear and its c sum to 0, so its
 * force on node i is  sum over j of  -k c_i c_j (x_j - x_i): all hinges at a node become one weight for each neighbour,
 * and a half spring to the same neighbour takes that weight over. All is computed at the node that it acts on, twice,
 * and nothing is scattered. The kernels read the part in the SELL-C-sigma form (force_program_lanes.c).
 *
 * The lists are made twice. Pass 1 lists the items between lattice nodes; packets take those that fit their slots. Pass
 * 2 lists all items that are left. Welding renames border nodes only, and drops a hinge only if two of its nodes become
 * one. So a hinge with one border node, and every spring between lattice nodes, stays in its packet for good.
 */
#include <stdlib.h>
#include <string.h>

#include "base/sort.h"
#include "sim/force_program_constants.h"
#include "sim/force_program_parts.h"


mus_status mus__program_irregular_create(mus_context *context, const mus_cloth *cloth, mus__program *program)
{
    const int64_t weights = 12 * (int64_t)program->hinge_capacity;
    program->irregular_node = mus__new(context, cloth->nnode, sizeof *program->irregular_node);
    program->half_start = mus__new(context, (int64_t)cloth->nnode + 1, sizeof *program->half_start);
    program->linear_start = mus__new(context, (int64_t)cloth->nnode + 1, sizeof *program->linear_start);
    program->linear_other = mus__new(context, weights, sizeof *program->linear_other);
    program->linear_weight = mus__new(context, weights, program->real);
    program->pair_end = mus__new(context, 2 * (int64_t)cloth->npair, sizeof *program->pair_end);
    if (program->irregular_node == NULL || program->half_start == NULL || program->linear_start == NULL ||
        program->linear_other == NULL || program->linear_weight == NULL || program->pair_end == NULL)
        return mus__fail_memory(context, "the irregular part of a drape");
    return mus__program_half_springs_create(context, program);
}


mus_status mus__program_half_springs_create(mus_context *context, mus__program *program)
{
    const int64_t halves = 2 * (int64_t)program->spring_capacity;
    program->half_other = mus__new(context, halves, sizeof *program->half_other);
    program->half_constant = mus__new(context, 3 * halves, program->real);
    if (program->half_other == NULL || program->half_constant == NULL)
        return mus__fail_memory(context, "the irregular part of a drape");
    return MUS_OK;
}


/* the next free index of a node's list: start[i + 1] is its cursor while lists are filled */
static int32_t irregular_next(int32_t *start, int32_t node)
{
    return start[node + 1]++;
}


/* turns counts of entries into starts: then start[i + 1] is where the list of node i begins */
static void irregular_open(int32_t *start, int32_t n)
{
    int32_t total = 0;
    for (int32_t i = 1; i <= n; i++) {
        const int32_t count = start[i];
        start[i] = total;
        total += count;
    }
}


/* nonzero for a node of a lattice row */
static int32_t irregular_inside(const mus__program *program, int32_t node)
{
    return program->packet_of[node] >= 0;
}


/* whether the pull of a spring on `node` belongs in the lists: of lattice items (pass 1), or of items that no packet
 * holds (pass 2). Tacks are put in after the packets were made */
static int32_t irregular_wants_spring(const mus__program *program, int32_t lattice, int32_t kind, int32_t node,
                                      int32_t other)
{
    if (kind == MUS__SPRING_TACK) return !lattice;
    const int32_t between = irregular_inside(program, node) && irregular_inside(program, other);
    if (lattice || !between) return lattice == between;
    const int32_t slot = mus__program_stencil_slot(program, node, other);
    return slot == MUS_NONE || slot >= MUS__NEAR_SLOTS_MAX;
}


/* the same for the 16 pairs of a hinge's nodes: bit 4 i + j for the pull of node j on node i */
static uint32_t irregular_wants_hinge(const mus__program *program, int32_t lattice, const mus__hinge *hinge)
{
    const int32_t *node = hinge->node;
    int32_t border = 0, outside = MUS_NONE; /* the border node, if it is one */
    uint32_t wanted = 0;
    for (int32_t k = 0; k < 4; k++)
        if (!irregular_inside(program, node[k])) border++, outside = node[k];
    if (lattice && border >= 2) return 0;
    for (int32_t k = 0; k < 16; k++) {
        const int32_t i = node[k / 4], j = node[k % 4];
        const int32_t between = border < 2 && i != outside && j != outside;
        if (i == j || (lattice && !between)) continue;
        if (lattice || !between || mus__program_stencil_slot(program, i, j) == MUS_NONE) wanted |= 1U << k;
    }
    return wanted;
}


static void irregular_springs(mus__program *program, int32_t nnode, int32_t lattice)
{
    int32_t *start = program->half_start;
    memset(start, 0, ((size_t)nnode + 1) * sizeof *start);
    for (int32_t s = 0; s < 2 * program->nspring; s++) {
        const mus__spring *spring = &program->spring[s / 2];
        const int32_t node = s % 2 ? spring->b : spring->a, other = s % 2 ? spring->a : spring->b;
        start[node + 1] += irregular_wants_spring(program, lattice, spring->kind, node, other);
    }
    irregular_open(start, nnode);
    for (int32_t s = 0; s < 2 * program->nspring; s++) {
        const mus__spring *spring = &program->spring[s / 2];
        const int32_t node = s % 2 ? spring->b : spring->a, other = s % 2 ? spring->a : spring->b;
        if (!irregular_wants_spring(program, lattice, spring->kind, node, other)) continue;
        const int32_t at = irregular_next(start, node);
        program->half_other[at] = other;
        mus__program_put(program, program->half_constant, 3 * (int64_t)at, spring->k);
        mus__program_put(program, program->half_constant, 3 * (int64_t)at + 1, spring->k * spring->rest);
        mus__program_put(program, program->half_constant, 3 * (int64_t)at + 2, program->spring_dashpot[s / 2]);
    }
}


static void irregular_hinges(mus__program *program, int32_t nnode, int32_t lattice)
{
    int32_t *start = program->linear_start;
    memset(start, 0, ((size_t)nnode + 1) * sizeof *start);
    for (int32_t h = 0; h < program->nhinge; h++) {
        const uint32_t wanted = irregular_wants_hinge(program, lattice, &program->hinge[h]);
        for (int32_t k = 0; k < 16; k++) start[program->hinge[h].node[k / 4] + 1] += (int32_t)(wanted >> k & 1);
    }
    irregular_open(start, nnode);
    for (int32_t h = 0; h < program->nhinge; h++) {
        const mus__hinge *hinge = &program->hinge[h];
        const uint32_t wanted = irregular_wants_hinge(program, lattice, hinge);
        for (int32_t k = 0; k < 16; k++) {
            if (!(wanted >> k & 1)) continue;
            const int32_t at = irregular_next(start, hinge->node[k / 4]);
            program->linear_other[at] = hinge->node[k % 4];
            mus__program_put(program, program->linear_weight, at, -hinge->k * hinge->coef[k / 4] * hinge->coef[k % 4]);
        }
    }
}


/* sorts entries first .. last-1 by neighbour, stably */
static void irregular_sort(mus__program *program, int32_t first, int32_t last)
{
    for (int32_t i = first + 1; i < last; i++) {
        const int32_t other = program->linear_other[i];
        const double w = mus__program_get(program, program->linear_weight, i);
        int32_t at = i;
        for (; at > first && program->linear_other[at - 1] > other; at--) {
            program->linear_other[at] = program->linear_other[at - 1];
            mus__program_put(program, program->linear_weight, at,
                             mus__program_get(program, program->linear_weight, at - 1));
        }
        program->linear_other[at] = other;
        mus__program_put(program, program->linear_weight, at, w);
    }
}


/*
 * Merges the sorted weights first .. last-1 of a node to one for each neighbour. It is added to the half spring to that
 * neighbour if there is one (not in pass 1, because packets take springs and weights apart), else written at `out`.
 * Returns one past the last written.
 */
static int32_t irregular_merge(mus__program *program, int32_t lattice, int32_t node, int32_t first, int32_t last,
                               int32_t out)
{
    for (int32_t i = first; i < last;) {
        const int32_t other = program->linear_other[i];
        double sum = 0.0;
        for (; i < last && program->linear_other[i] == other; i++)
            sum += mus__program_get(program, program->linear_weight, i);
        int32_t half = lattice ? program->half_start[node + 1] : program->half_start[node];
        while (half < program->half_start[node + 1] && program->half_other[half] != other) half++;
        if (half < program->half_start[node + 1]) {
            const double k = mus__program_get(program, program->half_constant, 3 * (int64_t)half);
            mus__program_put(program, program->half_constant, 3 * (int64_t)half, k + sum);
        } else {
            program->linear_other[out] = other;
            mus__program_put(program, program->linear_weight, out++, sum);
        }
    }
    return out;
}


static int irregular_by_node(const void *a, const void *b)
{
    const mus__pair_end *p = a, *q = b;
    if (p->node != q->node) return p->node < q->node ? -1 : 1;
    return p->pair < q->pair ? -1 : p->pair > q->pair;
}


static void irregular_pairs(mus__program *program)
{
    for (int32_t p = 0; p < program->npair; p++) {
        const mus__seam_pair *pair = &program->pair[p];
        program->pair_end[2 * p] = (mus__pair_end){pair->a, pair->b, p};
        program->pair_end[2 * p + 1] = (mus__pair_end){pair->b, pair->a, p};
    }
    mus__sort(program->pair_end, 2 * (size_t)program->npair, sizeof *program->pair_end, irregular_by_node);
}


/* makes both lists by node, and the list of nodes that have any item */
static void irregular_lists(const mus_cloth *cloth, mus__program *program, int32_t lattice)
{
    irregular_springs(program, cloth->nnode, lattice);
    irregular_hinges(program, cloth->nnode, lattice);
    program->nirregular = 0;
    int32_t first = 0, out = 0;
    for (int32_t i = 0; i < cloth->nnode; i++) {
        const int32_t last = program->linear_start[i + 1],
                      springs = program->half_start[i + 1] > program->half_start[i];
        if (springs || last > first) program->irregular_node[program->nirregular++] = i;
        irregular_sort(program, first, last);
        out = irregular_merge(program, lattice, i, first, last, out);
        first = last;
        program->linear_start[i + 1] = out;
    }
}


void mus__program_irregular_lattice(const mus_cloth *cloth, mus__program *program)
{
    irregular_lists(cloth, program, 1);
}


void mus__program_irregular(const mus_cloth *cloth, mus__program *program)
{
    irregular_lists(cloth, program, 0);
    irregular_pairs(program);

    mus__program_sell(program);

    /* the pair ends and the attachments of each chunk */
    for (int32_t c = 0, e = 0, h = 0; c < program->nchunk; c++) {
        mus__chunk *chunk = &program->chunk[c];
        chunk->end = e;
        while (e < 2 * program->npair && program->pair_end[e].node < chunk->first + chunk->count) e++;
        chunk->nend = e - chunk->end;
        chunk->attachment = h;
        while (h < program->nattachment && program->attachment[h].node < chunk->first + chunk->count) h++;
        chunk->nattachment = h - chunk->attachment;
    }
}
