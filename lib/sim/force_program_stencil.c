/*
 * force_program_stencil.c: the lattice rows of a program as packets of up to 16 neighbouring nodes, one to a lane of
 * the kernels.
 *
 * Packets are made greedily in the order of the nodes, across the ends of rows too: a packet takes the next node as
 * long as the neighbours of all its nodes stand at no more than 8 near and 8 far index differences. A pure lattice has
 * the same differences everywhere and loses no lane; a panel whose rows differ in length loses some at their ends.
 * Equal shapes and equal tables are kept once: inside a panel all packets of a row share both.
 *
 * All nodes are walked twice: to count (and to find the number of slots), then to write.
 */
#include <stdlib.h>
#include <string.h>

#include "sim/force_program_constants.h"
#include "sim/force_program_parts.h"

/* half springs, and index differences of bending, at one node; a lattice has at most 12 and 24 */
#define ITEMS_MOST 40

typedef struct stencil_items { /* of a node, and of those after it in its row up to `until` */
    int32_t nspring, nlinear, until;
    int32_t spring_at[ITEMS_MOST], linear_at[ITEMS_MOST]; /* index differences */
    double k[ITEMS_MOST], krest[ITEMS_MOST], c[ITEMS_MOST], w[ITEMS_MOST];
} stencil_items;

typedef struct stencil_set {      /* index differences of a packet's nodes, ascending */
    int32_t most, nnear, nlinear; /* most: near ones */
    int32_t near[MUS__NEAR_SLOTS_MAX], linear[2 * MUS__SLOTS];
} stencil_set;

typedef struct stencil_store { /* shapes and tables that are kept once: open addressing over hashes */
    int32_t slots;             /* a power of two */
    int32_t *shape, *table;    /* (slots) index + 1, 0 for free */
} stencil_store;

typedef struct stencil_walk {
    mus_context *context;
    mus__program *program;
    const stencil_store *store; /* NULL: count */
    int32_t most;               /* near slots */
} stencil_walk;


/* ---- one node ---- */

static void stencil_linear(stencil_items *items, int32_t at, double w)
{
    if (at == 0) return;
    int32_t i = 0;
    while (i < items->nlinear && items->linear_at[i] != at) i++;
    if (i == items->nlinear) {
        items->nlinear++;
        items->linear_at[i] = at;
        items->w[i] = 0.0;
    }
    items->w[i] += w;
}


/* whether nodes first .. first+count-1 of a run hold `node`; *until falls to the node at which that changes */
static int32_t stencil_inside(int32_t first, int32_t count, int32_t node, int32_t *until)
{
    const int32_t inside = node >= first, change = inside ? first + count : first;
    if (change <= node) return 0;
    if (change < *until) *until = change;
    return inside;
}


/* collects all items of a node of a row; returns 0 when there are more than a packet can take */
static int32_t stencil_collect(const mus__program *program, const mus__program_row *row, int32_t node,
                               stencil_items *items)
{
    items->nspring = items->nlinear = 0;
    items->until = row->first + row->count;
    for (int32_t h = row->run; h < row->run + row->nrun; h++) {
        const mus__half_run *run = &program->half_run[h];
        if (!stencil_inside(run->a, run->count, node, &items->until)) continue;
        const int32_t i = items->nspring++;
        if (i == ITEMS_MOST) return 0;
        items->spring_at[i] = run->b - run->a;
        items->k[i] = run->k, items->krest[i] = run->k * run->rest, items->c[i] = run->dashpot;
    }
    for (int32_t h = row->bend; h < row->bend + row->nbend; h++) {
        const mus__half_bend *bend = &program->half_bend[h];
        if (!stencil_inside(bend->o, bend->count, node, &items->until)) continue;
        if (items->nlinear + 3 > ITEMS_MOST) return 0;
        stencil_linear(items, bend->a - bend->o, bend->w);
        stencil_linear(items, bend->b - bend->o, -2.0 * bend->w);
        stencil_linear(items, bend->c - bend->o, bend->w);
    }
    return 1;
}


/* ---- one packet ---- */

/* inserts a value into an ascending set of at most `most`; returns 0 when the set is full */
static int32_t stencil_insert(int32_t *set, int32_t *n, int32_t most, int32_t value)
{
    int32_t at = 0;
    while (at < *n && set[at] < value) at++;
    if (at < *n && set[at] == value) return 1;
    if (*n == most) return 0;
    memmove(set + at + 1, set + at, (size_t)(*n - at) * sizeof *set);
    set[at] = value;
    (*n)++;
    return 1;
}


static int32_t stencil_find(const int32_t *set, int32_t n, int32_t value)
{
    for (int32_t i = 0; i < n; i++)
        if (set[i] == value) return i;
    return MUS_NONE;
}


/* far (MUS__SLOTS) gets the index differences that no near slot holds; returns their number, which may be larger */
static int32_t stencil_far(const stencil_set *set, int32_t *far)
{
    int32_t n = 0;
    for (int32_t i = 0; i < set->nlinear; i++) {
        if (stencil_find(set->near, set->nnear, set->linear[i]) != MUS_NONE) continue;
        if (n < MUS__SLOTS) far[n] = set->linear[i];
        n++;
    }
    return n;
}


/* gives a near slot to the smallest index difference that has none: its spring has stiffness 0 */
static int32_t stencil_promote(stencil_set *set)
{
    int32_t least = 0;
    for (int32_t i = 0; i < set->nlinear; i++) {
        const int32_t at = set->linear[i];
        if (stencil_find(set->near, set->nnear, at) == MUS_NONE && (least == 0 || abs(at) < abs(least))) least = at;
    }
    return stencil_insert(set->near, &set->nnear, set->most, least);
}


/* adds the items of one more node to the set; returns 0, with the set as it was, if they do not fit. Most nodes of a
 * row have the index differences of the node before them, and add none */
static int32_t stencil_grow(stencil_set *set, const stencil_items *items)
{
    int32_t known = 1;
    for (int32_t i = 0; known && i < items->nspring; i++)
        known = stencil_find(set->near, set->nnear, items->spring_at[i]) != MUS_NONE;
    for (int32_t i = 0; known && i < items->nlinear; i++)
        known = stencil_find(set->linear, set->nlinear, items->linear_at[i]) != MUS_NONE;
    if (known) return 1;
    stencil_set grown = *set;
    int32_t far[MUS__SLOTS];
    for (int32_t i = 0; i < items->nspring; i++)
        if (!stencil_insert(grown.near, &grown.nnear, set->most, items->spring_at[i])) return 0;
    for (int32_t i = 0; i < items->nlinear; i++)
        if (!stencil_insert(grown.linear, &grown.nlinear, 2 * MUS__SLOTS, items->linear_at[i])) return 0;
    while (stencil_far(&grown, far) > MUS__SLOTS)
        if (!stencil_promote(&grown)) return 0;
    *set = grown;
    return 1;
}


/* gives free slots to the irregular items of a node; items without a slot stay in the irregular part */
static void stencil_invite(const mus__program *program, stencil_set *set, int32_t node)
{
    for (int32_t h = program->half_start[node]; h < program->half_start[node + 1]; h++)
        stencil_insert(set->near, &set->nnear, set->most, program->half_other[h] - node);
    for (int32_t h = program->linear_start[node]; h < program->linear_start[node + 1]; h++) {
        if (stencil_find(set->linear, set->nlinear, program->linear_other[h] - node) != MUS_NONE) continue;
        stencil_set grown = *set;
        int32_t far[MUS__SLOTS];
        if (stencil_insert(grown.linear, &grown.nlinear, 2 * MUS__SLOTS, program->linear_other[h] - node) &&
            stencil_far(&grown, far) <= MUS__SLOTS)
            *set = grown;
    }
}


/* adds the irregular items of a node to its lane, where there is a slot */
static void stencil_irregular(const mus__program *program, const mus__packet_shape *shape, int32_t nnear, int32_t nfar,
                              int32_t node, double *table)
{
    const int32_t lanes = MUS__LANES;
    double *krest = table + program->near * lanes, *w = krest + program->near * lanes, *c = w + program->far * lanes;
    for (int32_t h = program->half_start[node]; h < program->half_start[node + 1]; h++) {
        const int32_t slot = stencil_find(shape->near, nnear, program->half_other[h] - node);
        if (slot == MUS_NONE) continue;
        table[slot * lanes] += mus__program_get(program, program->half_constant, 3 * (int64_t)h);
        krest[slot * lanes] += mus__program_get(program, program->half_constant, 3 * (int64_t)h + 1);
        if (program->dashpots) c[slot * lanes] += mus__program_get(program, program->half_constant, 3 * (int64_t)h + 2);
    }
    for (int32_t h = program->linear_start[node]; h < program->linear_start[node + 1]; h++) {
        const int32_t at = program->linear_other[h] - node;
        const int32_t near = stencil_find(shape->near, nnear, at), far = stencil_find(shape->far, nfar, at);
        const double weight = mus__program_get(program, program->linear_weight, h);
        if (near != MUS_NONE)
            table[near * lanes] += weight;
        else if (far != MUS_NONE)
            w[far * lanes] += weight;
    }
}


/* writes the constants of one lane of a table */
static void stencil_lane(const mus__program *program, const mus__packet_shape *shape, int32_t nnear, int32_t nfar,
                         const stencil_items *items, double *table)
{
    const int32_t lanes = MUS__LANES;
    double *krest = table + program->near * lanes, *w = krest + program->near * lanes, *c = w + program->far * lanes;
    for (int32_t i = 0; i < items->nspring; i++) {
        const int32_t at = lanes * stencil_find(shape->near, nnear, items->spring_at[i]);
        table[at] += items->k[i];
        krest[at] += items->krest[i];
        if (program->dashpots) c[at] += items->c[i];
    }
    for (int32_t i = 0; i < items->nlinear; i++) {
        const int32_t near = stencil_find(shape->near, nnear, items->linear_at[i]);
        if (near != MUS_NONE)
            table[near * lanes] += items->w[i];
        else
            w[stencil_find(shape->far, nfar, items->linear_at[i]) * lanes] += items->w[i];
    }
}


/* ---- shapes and tables kept once ---- */

/* index in *array of the element of `size` bytes that equals `bytes`, appended if there is none; MUS_NONE without
 * memory */
static int32_t stencil_intern(mus_context *context, const stencil_store *store, int32_t *slot, void *array, int32_t *n,
                              int32_t *capacity, const void *bytes, size_t size)
{
    char **items = array;
    const char *last = *n > 0 ? *items + (size_t)(*n - 1) * size : NULL;
    if (last != NULL && memcmp(last, bytes, size) == 0) return *n - 1;
    uint64_t at = mus__hash(MUS_HASH_START, bytes, size);
    for (;; at++) {
        at &= (uint64_t)store->slots - 1;
        if (slot[at] == 0) break;
        if (memcmp(*items + (size_t)(slot[at] - 1) * size, bytes, size) == 0) return slot[at] - 1;
    }
    if (mus__reserve(context, array, capacity, (int64_t)*n + 1, size) != MUS_OK) return MUS_NONE;
    memcpy(*items + (size_t)*n * size, bytes, size);
    slot[at] = ++*n;
    return *n - 1;
}


/* writes the packet of nodes first .. first+count-1, each with its items */
static mus_status stencil_write(const stencil_walk *walk, const stencil_set *set, int32_t first, int32_t count,
                                const stencil_items *const *items)
{
    mus__program *program = walk->program;
    mus__packet_shape shape = {{0}, {0}};
    double value[(3 * MUS__NEAR_SLOTS_MAX + MUS__SLOTS) * MUS__LANES] = {0.0};
    double table[(3 * MUS__NEAR_SLOTS_MAX + MUS__SLOTS) * MUS__LANES]; /* the same numbers in the program's precision */
    memcpy(shape.near, set->near, (size_t)set->nnear * sizeof *shape.near);
    const int32_t nfar = stencil_far(set, shape.far), size = mus__program_table_size(program);
    for (int32_t i = 0; i < count; i++) {
        stencil_lane(program, &shape, set->nnear, nfar, items[i], value + i);
        stencil_irregular(program, &shape, set->nnear, nfar, first + i, value + i);
        program->packet_of[first + i] = program->npacket;
    }
    const int32_t krest = program->near * MUS__LANES;
    for (int32_t i = 0; i < krest; i++) value[krest + i] *= mus__program_rest_factor(program);
    for (int32_t i = 0; i < size; i++) mus__program_put(program, table, i, value[i]);

    const int32_t s = stencil_intern(walk->context, walk->store, walk->store->shape, &program->shape, &program->nshape,
                                     &program->shape_capacity, &shape, sizeof shape);
    const int32_t t = stencil_intern(walk->context, walk->store, walk->store->table, &program->table, &program->ntable,
                                     &program->table_capacity, table, (size_t)size * program->real);
    if (s == MUS_NONE || t == MUS_NONE) return mus__fail_memory(walk->context, "the packets of a drape");
    program->packet[program->npacket] = (mus__packet){first, s, t};
    return MUS_OK;
}


/* ---- the walk ---- */

/* adds nodes first .. first+count-1 and the last npacket packets to the last chunk if it has room, else to a new one */
static void stencil_chunk(const stencil_walk *walk, int32_t first, int32_t count, int32_t npacket, int32_t *open)
{
    mus__program *program = walk->program;
    if (*open < count) {
        program->nchunk++;
        *open = MUS__CHUNK_NODES;
        if (walk->store != NULL)
            program->chunk[program->nchunk - 1] = (mus__chunk){.first = first, .packet = program->npacket - npacket};
    }
    *open -= count;
    if (walk->store == NULL) return;
    program->chunk[program->nchunk - 1].count += count;
    program->chunk[program->nchunk - 1].npacket += npacket;
}


/* makes one packet from lattice node `first` of row *row on, and moves *row on; returns its number of nodes, 0 on
 * failure */
static int32_t stencil_step(const stencil_walk *walk, int32_t first, int32_t *row, mus_status *status)
{
    mus__program *program = walk->program;
    stencil_items store[MUS__LANES], *last = store;
    const stencil_items *items[MUS__LANES];
    stencil_set set = {.most = walk->most};
    int32_t count = 0, r = *row;
    for (int32_t until = first; count < MUS__LANES; items[count++] = last) {
        if (first + count < until) continue;
        while (r < program->nrow && program->row[r].first + program->row[r].count <= first + count) r++;
        if (r == program->nrow || program->row[r].first > first + count) break;
        last = &store[count];
        if (!stencil_collect(program, &program->row[r], first + count, last) || !stencil_grow(&set, last)) {
            if (count > 0) break;
            *status = mus__fail(walk->context, MUS_ERR_LIMIT, "drape: node %d has more than %d lattice neighbours",
                                (int)first, walk->most + MUS__SLOTS);
            return 0;
        }
        until = last->until;
        *row = r;
    }

    for (int32_t i = 0; i < count; i++) stencil_invite(program, &set, first + i);
    int32_t far[MUS__SLOTS];
    const int32_t nfar = stencil_far(&set, far);
    if (walk->store != NULL)
        *status = stencil_write(walk, &set, first, count, items);
    else if (set.nnear > program->near)
        program->near = set.nnear;
    if (walk->store == NULL && nfar > program->far) program->far = nfar;
    program->npacket++;
    return *status == MUS_OK ? count : 0;
}


/* walks all nodes of the cloth in order */
static mus_status stencil_all(const stencil_walk *walk, int32_t nnode)
{
    mus__program *program = walk->program;
    mus_status status = MUS_OK;
    program->npacket = program->nchunk = 0;
    int32_t open = 0, lattice = 0;
    for (int32_t i = 0, r = 0; i < nnode && status == MUS_OK;) {
        while (r < program->nrow && program->row[r].first + program->row[r].count <= i) r++;
        const int32_t inside = r < program->nrow && program->row[r].first <= i;
        if (inside != lattice) open = 0;
        lattice = inside;
        if (inside) {
            const int32_t count = stencil_step(walk, i, &r, &status);
            if (status == MUS_OK) stencil_chunk(walk, i, count, 1, &open);
            i += count;
            continue;
        }
        const int32_t until = r < program->nrow ? program->row[r].first : nnode;
        const int32_t count = until - i < MUS__CHUNK_NODES ? until - i : MUS__CHUNK_NODES;
        stencil_chunk(walk, i, count, 0, &open);
        i += count;
    }
    return status;
}


mus_status mus__program_stencil(mus_context *context, const mus_cloth *cloth, mus__program *program)
{
    stencil_store store = {.slots = 16};
    stencil_walk walk = {context, program, NULL, MUS__SLOTS};
    program->near = program->far = 0;
    mus_status status = stencil_all(&walk, cloth->nnode);
    if (status == MUS_ERR_LIMIT) {
        walk.most = MUS__NEAR_SLOTS_MAX;
        status = stencil_all(&walk, cloth->nnode);
    }
    if (status != MUS_OK) return status;

    /* the next numbers of slots that the kernels have a loop for */
    const int32_t paper = program->near > MUS__SLOTS;
    program->near = paper ? MUS__NEAR_SLOTS_MAX : program->near > 4 || program->far > 4 ? MUS__SLOTS : 4;
    program->far = paper || program->far > 4 ? MUS__SLOTS : program->far > 0 ? 4 : 0;

    program->packet = mus__new(context, program->npacket, sizeof *program->packet);
    program->chunk = mus__new(context, program->nchunk, sizeof *program->chunk);
    while (store.slots < 2 * (int64_t)program->npacket) store.slots *= 2;
    store.shape = mus__new(context, store.slots, sizeof *store.shape);
    store.table = mus__new(context, store.slots, sizeof *store.table);
    walk.store = &store;
    if (program->packet == NULL || program->chunk == NULL || store.shape == NULL || store.table == NULL)
        status = mus__fail_memory(context, "the packets of a drape");
    if (status == MUS_OK) status = stencil_all(&walk, cloth->nnode);
    mus__free(context, store.shape);
    mus__free(context, store.table);
    return status;
}


int32_t mus__program_stencil_slot(const mus__program *program, int32_t node, int32_t other)
{
    const mus__packet_shape *shape = &program->shape[program->packet[program->packet_of[node]].shape];
    const int32_t near = stencil_find(shape->near, MUS__NEAR_SLOTS_MAX, other - node);
    if (near != MUS_NONE) return near;
    const int32_t far = stencil_find(shape->far, MUS__SLOTS, other - node);
    return far != MUS_NONE ? MUS__NEAR_SLOTS_MAX + far : MUS_NONE;
}
