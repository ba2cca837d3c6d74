/*
 * force_program_lanes.c: the irregular part of a program as SELL-C-sigma, the form that the kernels read (sources in
 * force_program_kernel_data.h): slices of 16 rows, one row to a lane, padded to the longest row.
 *
 * Within a chunk, rows are sorted by their numbers of half springs and weights, so that the lanes of a slice have about
 * as many. A node with more than ITEMS of either kind has several rows. The half springs of a chunk's slices then take
 * at most as many places as there are half springs and one longest slice more, and weights take ITEMS a node: the
 * memory is known before any welding. A tack adds one half spring at two nodes, each of which is in at most one slice
 * more by it.
 */
#include <stdlib.h>
#include <string.h>

#include "base/sort.h"
#include "sim/force_program_constants.h"
#include "sim/force_program_parts.h"

#define ITEMS 8 /* of one kind in one row; chosen: most border nodes need one row */


/* marks the nodes that springs and hinges name, to which welding adds none; returns their number */
static int64_t sell_named(const mus_cloth *cloth, unsigned char *named)
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


/* number of constants of a half spring */
static int32_t sell_constants(const mus__program *program)
{
    return program->dashpots ? 3 : 2;
}


mus_status mus__program_sell_create(mus_context *context, const mus_cloth *cloth, mus__program *program)
{
    unsigned char *named = mus__new(context, cloth->nnode, sizeof *named);
    if (named == NULL) return mus__fail_memory(context, "the irregular part of a drape");
    const int64_t nodes = sell_named(cloth, named);
    int64_t chunks = 0;
    for (int32_t c = 0; c < program->nchunk; c++)
        chunks += memchr(named + program->chunk[c].first, 1, (size_t)program->chunk[c].count) != NULL;
    mus__free(context, named);

    /* the cloth's own, then tacks */
    const int64_t own = 2 * (int64_t)cloth->nspring, tacked = 2 * (int64_t)program->tack_capacity,
                  halves = own + tacked;
    const int64_t weights = 12 * (int64_t)program->hinge_capacity;
    const int64_t entries = nodes + (own > weights ? own : weights) / ITEMS + tacked;
    chunks = chunks + tacked < program->nchunk ? chunks + tacked : program->nchunk;
    const int64_t groups = entries / MUS__LANES + chunks, spare = ITEMS * MUS__LANES * chunks;
    mus__sell *list = &program->sell;
    list->entry = mus__new(context, entries, sizeof *list->entry);
    list->slice = mus__new(context, groups, sizeof *list->slice);
    list->node = mus__new(context, groups * MUS__LANES, sizeof *list->node);
    list->half_other = mus__new(context, halves + spare, sizeof *list->half_other);
    list->half_constant = mus__new(context, (halves + spare) * sell_constants(program), program->real);
    list->linear_other = mus__new(context, groups * ITEMS * MUS__LANES, sizeof *list->linear_other);
    list->linear_weight = mus__new(context, groups * ITEMS * MUS__LANES, program->real);
    if (list->entry == NULL || list->slice == NULL || list->node == NULL || list->half_other == NULL ||
        list->half_constant == NULL || list->linear_other == NULL || list->linear_weight == NULL)
        return mus__fail_memory(context, "the irregular part of a drape");
    return MUS_OK;
}


void mus__program_sell_clear(mus_context *context, mus__program *program)
{
    mus__sell *list = &program->sell;
    void *blocks[] = {list->entry,         list->slice,        list->node,         list->half_other,
                      list->half_constant, list->linear_other, list->linear_weight};
    for (size_t i = 0; i < sizeof blocks / sizeof blocks[0]; i++) mus__free(context, blocks[i]);
}


static int sell_longest_first(const void *a, const void *b)
{
    const mus__sell_row *p = a, *q = b;
    if (p->nhalf != q->nhalf) return p->nhalf > q->nhalf ? -1 : 1;
    if (p->nlinear != q->nlinear) return p->nlinear > q->nlinear ? -1 : 1;
    if (p->node != q->node) return p->node < q->node ? -1 : 1;
    return p->part < q->part ? -1 : p->part > q->part;
}


/* writes lane i of the last slice from row e; a lane past the last row (has 0) names the last node again, without items
 */
static void sell_lane(const mus__program *program, mus__sell *list, int32_t i, const mus__sell_row *e, int32_t has)
{
    const mus__sell_slice *group = &list->slice[list->nslice];
    const int32_t constants = sell_constants(program);
    const double share[3] = {1.0, mus__program_rest_factor(program), 1.0};
    list->node[(int64_t)list->nslice * MUS__LANES + i] = e->node;
    for (int32_t k = 0; k < group->nhalf; k++) {
        const int64_t item = group->half + k, from = program->half_start[e->node] + ITEMS * e->part + k;
        const int32_t there = has && k < e->nhalf;
        list->half_other[item * MUS__LANES + i] = there ? program->half_other[from] : e->node;
        for (int32_t c = 0; c < constants; c++)
            mus__program_put(program, list->half_constant, (item * constants + c) * MUS__LANES + i,
                             there ? share[c] * mus__program_get(program, program->half_constant, 3 * from + c) : 0.0);
    }
    for (int32_t k = 0; k < group->nlinear; k++) {
        const int64_t item = group->linear + k, from = program->linear_start[e->node] + ITEMS * e->part + k;
        const int32_t there = has && k < e->nlinear;
        list->linear_other[item * MUS__LANES + i] = there ? program->linear_other[from] : e->node;
        mus__program_put(program, list->linear_weight, item * MUS__LANES + i,
                         there ? mus__program_get(program, program->linear_weight, from) : 0.0);
    }
}


/* number of items in part `part` of a list of `count` */
static int32_t sell_part(int32_t count, int32_t part)
{
    const int32_t left = count - ITEMS * part;
    return left < 0 ? 0 : left < ITEMS ? left : ITEMS;
}


/* the rows of a chunk's nodes, sorted; returns their number */
static int32_t sell_entries(const mus__program *program, const mus__chunk *chunk, mus__sell_row *entry)
{
    int32_t n = 0;
    for (int32_t i = chunk->first; i < chunk->first + chunk->count; i++) {
        const int32_t halves = program->half_start[i + 1] - program->half_start[i];
        const int32_t weights = program->linear_start[i + 1] - program->linear_start[i];
        for (int32_t part = 0; part * ITEMS < halves || part * ITEMS < weights; part++)
            entry[n++] = (mus__sell_row){i, part, sell_part(halves, part), sell_part(weights, part)};
    }
    mus__sort(entry, (size_t)n, sizeof *entry, sell_longest_first);
    return n;
}


void mus__program_sell(mus__program *program)
{
    mus__sell *list = &program->sell;
    list->nslice = 0;
    int32_t half = 0, linear = 0;
    for (int32_t c = 0; c < program->nchunk; c++) {
        mus__chunk *chunk = &program->chunk[c];
        const int32_t n = sell_entries(program, chunk, list->entry);
        chunk->slice = list->nslice;
        for (int32_t first = 0; first < n; first += MUS__LANES) {
            const mus__sell_row *e = list->entry + first;
            mus__sell_slice *group = &list->slice[list->nslice];
            *group = (mus__sell_slice){half, e->nhalf, linear, 0};
            for (int32_t i = 0; i < MUS__LANES && first + i < n; i++)
                if (e[i].nlinear > group->nlinear) group->nlinear = e[i].nlinear;
            for (int32_t i = 0; i < MUS__LANES; i++)
                sell_lane(program, list, i, &e[first + i < n ? i : n - 1 - first], first + i < n);
            half += group->nhalf;
            linear += group->nlinear;
            list->nslice++;
        }
        chunk->nslice = list->nslice - chunk->slice;
    }
}
