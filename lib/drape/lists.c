/*
 * lists.c: the irregular items of a plan in groups of lanes, as the kernels read them.
 *
 * Within a chunk, nodes are sorted by how many half springs and weights they have, so that the lanes of a group have
 * about as many; a node with more than ITEMS of either stands again for the rest. Half springs of a chunk's groups then
 * take at most as many places as there are and one longest group more, and weights ITEMS a node: the memory is known
 * before any welding. A tack puts one more half spring to two nodes, and each is in at most one group more by it.
 */
#include <stdlib.h>
#include <string.h>

#include "drape/plan.h"

#define ITEMS 8 /* of a kind, of a node in one group */


/* marks the nodes that springs and hinges name; welding names no others. Returns how many */
static int64_t lists_named(const mus_cloth *cloth, unsigned char *named)
{
    int64_t count = 0;
    for (int32_t s = 0; s < cloth->nspring; s++) named[cloth->spring[s].a] = named[cloth->spring[s].b] = 1;
    for (int32_t h = 0; h < cloth->nhinge; h++)
        for (int32_t k = 0; k < 4; k++) named[cloth->hinge[h].node[k]] = 1;
    for (int32_t h = 0; h < cloth->nseam_hinge; h++)
        for (int32_t k = 0; k < 4; k++) named[cloth->seam_hinge[h].node[k]] = 1;
    for (int32_t i = 0; i < cloth->nnode; i++) count += named[i];
    return count;
}


/* numbers of a half spring's constants */
static int32_t lists_constants(const mus__plan *plan)
{
    return plan->dashpots ? 3 : 2;
}


mus_status mus__plan_lists_new(mus_context *context, const mus_cloth *cloth, mus__plan *plan)
{
    unsigned char *named = mus__new(context, cloth->nnode, sizeof *named);
    if (named == NULL) return mus__fail_memory(context, "the irregular part of a drape");
    const int64_t nodes = lists_named(cloth, named);
    int64_t chunks = 0;
    for (int32_t c = 0; c < plan->nchunk; c++)
        chunks += memchr(named + plan->chunk[c].first, 1, (size_t)plan->chunk[c].count) != NULL;
    mus__free(context, named);

    /* the cloth's own, then tacks */
    const int64_t own = 2 * (int64_t)cloth->nspring, tacked = 2 * (int64_t)plan->tack_capacity, halves = own + tacked;
    const int64_t weights = 12 * (int64_t)plan->hinge_capacity;
    const int64_t entries = nodes + (own > weights ? own : weights) / ITEMS + tacked;
    chunks = chunks + tacked < plan->nchunk ? chunks + tacked : plan->nchunk;
    const int64_t groups = entries / MUS_LANES + chunks, spare = ITEMS * MUS_LANES * chunks;
    mus__list *list = &plan->list;
    list->entry = mus__new(context, entries, sizeof *list->entry);
    list->group = mus__new(context, groups, sizeof *list->group);
    list->node = mus__new(context, groups * MUS_LANES, sizeof *list->node);
    list->half_other = mus__new(context, halves + spare, sizeof *list->half_other);
    list->half_constant = mus__new(context, (halves + spare) * lists_constants(plan), plan->real);
    list->linear_other = mus__new(context, groups * ITEMS * MUS_LANES, sizeof *list->linear_other);
    list->linear_weight = mus__new(context, groups * ITEMS * MUS_LANES, plan->real);
    if (list->entry == NULL || list->group == NULL || list->node == NULL || list->half_other == NULL ||
        list->half_constant == NULL || list->linear_other == NULL || list->linear_weight == NULL)
        return mus__fail_memory(context, "the irregular part of a drape");
    return MUS_OK;
}


void mus__plan_lists_clear(mus_context *context, mus__plan *plan)
{
    mus__list *list = &plan->list;
    void *blocks[] = {list->entry,         list->group,        list->node,         list->half_other,
                      list->half_constant, list->linear_other, list->linear_weight};
    for (size_t i = 0; i < sizeof blocks / sizeof blocks[0]; i++) mus__free(context, blocks[i]);
}


static int lists_longest_first(const void *a, const void *b)
{
    const mus__list_entry *p = a, *q = b;
    if (p->nhalf != q->nhalf) return p->nhalf > q->nhalf ? -1 : 1;
    if (p->nlinear != q->nlinear) return p->nlinear > q->nlinear ? -1 : 1;
    if (p->node != q->node) return p->node < q->node ? -1 : 1;
    return p->part < q->part ? -1 : p->part > q->part;
}


/* lane i of the group being made, of entry e; a lane past the last has the last node again, with no items */
static void lists_lane(const mus__plan *plan, mus__list *list, int32_t i, const mus__list_entry *e, int32_t has)
{
    const mus__group *group = &list->group[list->ngroup];
    const int32_t constants = lists_constants(plan);
    const double share[3] = {1.0, mus__plan_share(plan), 1.0};
    list->node[(int64_t)list->ngroup * MUS_LANES + i] = e->node;
    for (int32_t k = 0; k < group->nhalf; k++) {
        const int64_t item = group->half + k, from = plan->half_start[e->node] + ITEMS * e->part + k;
        const int32_t there = has && k < e->nhalf;
        list->half_other[item * MUS_LANES + i] = there ? plan->half_other[from] : e->node;
        for (int32_t c = 0; c < constants; c++)
            mus__plan_put(plan, list->half_constant, (item * constants + c) * MUS_LANES + i,
                          there ? share[c] * mus__plan_number(plan, plan->half_constant, 3 * from + c) : 0.0);
    }
    for (int32_t k = 0; k < group->nlinear; k++) {
        const int64_t item = group->linear + k, from = plan->linear_start[e->node] + ITEMS * e->part + k;
        const int32_t there = has && k < e->nlinear;
        list->linear_other[item * MUS_LANES + i] = there ? plan->linear_other[from] : e->node;
        mus__plan_put(plan, list->linear_weight, item * MUS_LANES + i,
                      there ? mus__plan_number(plan, plan->linear_weight, from) : 0.0);
    }
}


/* items of part `part` of a list of `count` */
static int32_t lists_part(int32_t count, int32_t part)
{
    const int32_t left = count - ITEMS * part;
    return left < 0 ? 0 : left < ITEMS ? left : ITEMS;
}


/* the entries of a chunk's nodes, sorted; returns how many */
static int32_t lists_entries(const mus__plan *plan, const mus__chunk *chunk, mus__list_entry *entry)
{
    int32_t n = 0;
    for (int32_t i = chunk->first; i < chunk->first + chunk->count; i++) {
        const int32_t halves = plan->half_start[i + 1] - plan->half_start[i];
        const int32_t weights = plan->linear_start[i + 1] - plan->linear_start[i];
        for (int32_t part = 0; part * ITEMS < halves || part * ITEMS < weights; part++)
            entry[n++] = (mus__list_entry){i, part, lists_part(halves, part), lists_part(weights, part)};
    }
    qsort(entry, (size_t)n, sizeof *entry, lists_longest_first);
    return n;
}


void mus__plan_lists(mus__plan *plan)
{
    mus__list *list = &plan->list;
    list->ngroup = 0;
    int32_t half = 0, linear = 0;
    for (int32_t c = 0; c < plan->nchunk; c++) {
        mus__chunk *chunk = &plan->chunk[c];
        const int32_t n = lists_entries(plan, chunk, list->entry);
        chunk->group = list->ngroup;
        for (int32_t first = 0; first < n; first += MUS_LANES) {
            const mus__list_entry *e = list->entry + first;
            mus__group *group = &list->group[list->ngroup];
            *group = (mus__group){half, e->nhalf, linear, 0};
            for (int32_t i = 0; i < MUS_LANES && first + i < n; i++)
                if (e[i].nlinear > group->nlinear) group->nlinear = e[i].nlinear;
            for (int32_t i = 0; i < MUS_LANES; i++)
                lists_lane(plan, list, i, &e[first + i < n ? i : n - 1 - first], first + i < n);
            half += group->nhalf;
            linear += group->nlinear;
            list->ngroup++;
        }
        chunk->ngroup = list->ngroup - chunk->group;
    }
}
