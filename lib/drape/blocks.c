/*
 * blocks.c: the lattice rows of a plan as blocks of a fixed number of neighbouring nodes, one to a lane of the kernels.
 *
 * Blocks are made greedily along the numbering of the nodes, over the ends of rows too: a block takes the next node as
 * long as all its nodes' neighbours stand at no more than 8 near and 8 far index differences. A pure lattice has the
 * same differences everywhere, so that no lane is lost; a panel whose rows differ in length loses some at their ends.
 * Equal shapes and equal tables are kept once: inside a panel every block of a row shares both.
 *
 * Walked twice: to count (and to see how many slots any block needs), then to write.
 */
#include <stdlib.h>
#include <string.h>

#include "drape/plan.h"

#define ITEMS_MOST 40 /* half springs, and index differences of bending, at one node */

typedef struct blocks_items { /* of one node */
    int32_t nspring, nlinear;
    int32_t spring_at[ITEMS_MOST], linear_at[ITEMS_MOST]; /* index differences */
    double k[ITEMS_MOST], krest[ITEMS_MOST], c[ITEMS_MOST], w[ITEMS_MOST];
} blocks_items;

typedef struct blocks_set { /* index differences of a block's nodes, ascending */
    int32_t most, nnear, nlinear; /* most: near ones */
    int32_t near[MUS_NEAR_MOST], linear[2 * MUS_SLOTS];
} blocks_set;

typedef struct blocks_store { /* equal things once: open addressing over hashes */
    int32_t slots;            /* a power of two */
    int32_t *shape, *table;   /* (slots) index + 1, 0 for free */
} blocks_store;

typedef struct blocks_walk {
    mus_context *context;
    mus__plan *plan;
    const blocks_store *store; /* NULL: count */
    int32_t most;              /* near slots */
} blocks_walk;


/* ---- one node ---- */

static void blocks_linear(blocks_items *items, int32_t at, double w)
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


/* all items of a node of a row; returns 0 when there are more than a block can take */
static int32_t blocks_collect(const mus__plan *plan, const mus__plan_row *row, int32_t node, blocks_items *items)
{
    items->nspring = items->nlinear = 0;
    for (int32_t h = row->run; h < row->run + row->nrun; h++) {
        const mus__half_run *run = &plan->half_run[h];
        if (node < run->a || node >= run->a + run->count) continue;
        const int32_t i = items->nspring++;
        if (i == ITEMS_MOST) return 0;
        items->spring_at[i] = run->b - run->a;
        items->k[i] = run->k, items->krest[i] = run->k * run->rest, items->c[i] = run->dashpot;
    }
    for (int32_t h = row->bend; h < row->bend + row->nbend; h++) {
        const mus__half_bend *bend = &plan->half_bend[h];
        if (node < bend->o || node >= bend->o + bend->count) continue;
        if (items->nlinear + 3 > ITEMS_MOST) return 0;
        blocks_linear(items, bend->a - bend->o, bend->w);
        blocks_linear(items, bend->b - bend->o, -2.0 * bend->w);
        blocks_linear(items, bend->c - bend->o, bend->w);
    }
    return 1;
}


/* ---- one block ---- */

/* a value into an ascending set of at most `most`; returns 0 when there is no room */
static int32_t blocks_insert(int32_t *set, int32_t *n, int32_t most, int32_t value)
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


static int32_t blocks_find(const int32_t *set, int32_t n, int32_t value)
{
    for (int32_t i = 0; i < n; i++)
        if (set[i] == value) return i;
    return MUS_NONE;
}


/* what the near slots do not hold already, into far; returns how many, more than MUS_SLOTS if they do not fit */
static int32_t blocks_far(const blocks_set *set, int32_t *far)
{
    int32_t n = 0;
    for (int32_t i = 0; i < set->nlinear; i++) {
        if (blocks_find(set->near, set->nnear, set->linear[i]) != MUS_NONE) continue;
        if (n < MUS_SLOTS) far[n] = set->linear[i];
        n++;
    }
    return n;
}


/* the least distant index difference that no near slot holds, into one: its spring is one of stiffness 0 */
static int32_t blocks_promote(blocks_set *set)
{
    int32_t least = 0;
    for (int32_t i = 0; i < set->nlinear; i++) {
        const int32_t at = set->linear[i];
        if (blocks_find(set->near, set->nnear, at) == MUS_NONE && (least == 0 || abs(at) < abs(least))) least = at;
    }
    return blocks_insert(set->near, &set->nnear, set->most, least);
}


/* one more node's items into the set; returns 0, and leaves the set as it was, if they do not fit */
static int32_t blocks_grow(blocks_set *set, const blocks_items *items)
{
    blocks_set grown = *set;
    int32_t far[MUS_SLOTS];
    for (int32_t i = 0; i < items->nspring; i++)
        if (!blocks_insert(grown.near, &grown.nnear, set->most, items->spring_at[i])) return 0;
    for (int32_t i = 0; i < items->nlinear; i++)
        if (!blocks_insert(grown.linear, &grown.nlinear, 2 * MUS_SLOTS, items->linear_at[i])) return 0;
    while (blocks_far(&grown, far) > MUS_SLOTS)
        if (!blocks_promote(&grown)) return 0;
    *set = grown;
    return 1;
}


/* free slots for what springs and hinges make of `node`; what finds none stays in the lists */
static void blocks_invite(const mus__plan *plan, blocks_set *set, int32_t node)
{
    for (int32_t h = plan->half_start[node]; h < plan->half_start[node + 1]; h++) {
        blocks_set grown = *set;
        if (blocks_insert(grown.near, &grown.nnear, set->most, plan->half_other[h] - node)) *set = grown;
    }
    for (int32_t h = plan->linear_start[node]; h < plan->linear_start[node + 1]; h++) {
        blocks_set grown = *set;
        int32_t far[MUS_SLOTS];
        if (blocks_insert(grown.linear, &grown.nlinear, 2 * MUS_SLOTS, plan->linear_other[h] - node) &&
            blocks_far(&grown, far) <= MUS_SLOTS)
            *set = grown;
    }
}


/* what springs and hinges add to the lane of `node`, where there is a slot */
static void blocks_irregular(const mus__plan *plan, const mus__shape *shape, int32_t nnear, int32_t nfar, int32_t node,
                             double *table)
{
    const int32_t lanes = MUS_LANES;
    double *krest = table + plan->near * lanes, *w = krest + plan->near * lanes, *c = w + plan->far * lanes;
    for (int32_t h = plan->half_start[node]; h < plan->half_start[node + 1]; h++) {
        const int32_t slot = blocks_find(shape->near, nnear, plan->half_other[h] - node);
        if (slot == MUS_NONE) continue;
        table[slot * lanes] += mus__plan_number(plan, plan->half_constant, 3 * (int64_t)h);
        krest[slot * lanes] += mus__plan_number(plan, plan->half_constant, 3 * (int64_t)h + 1);
        if (plan->dashpots) c[slot * lanes] += mus__plan_number(plan, plan->half_constant, 3 * (int64_t)h + 2);
    }
    for (int32_t h = plan->linear_start[node]; h < plan->linear_start[node + 1]; h++) {
        const int32_t at = plan->linear_other[h] - node;
        const int32_t near = blocks_find(shape->near, nnear, at), far = blocks_find(shape->far, nfar, at);
        const double weight = mus__plan_number(plan, plan->linear_weight, h);
        if (near != MUS_NONE) table[near * lanes] += weight;
        else if (far != MUS_NONE) w[far * lanes] += weight;
    }
}


/* the constants of one lane of a table */
static void blocks_lane(const mus__plan *plan, const mus__shape *shape, int32_t nnear, int32_t nfar,
                        const blocks_items *items, double *table)
{
    const int32_t lanes = MUS_LANES;
    double *krest = table + plan->near * lanes, *w = krest + plan->near * lanes, *c = w + plan->far * lanes;
    for (int32_t i = 0; i < items->nspring; i++) {
        const int32_t at = lanes * blocks_find(shape->near, nnear, items->spring_at[i]);
        table[at] += items->k[i];
        krest[at] += items->krest[i];
        if (plan->dashpots) c[at] += items->c[i];
    }
    for (int32_t i = 0; i < items->nlinear; i++) {
        const int32_t near = blocks_find(shape->near, nnear, items->linear_at[i]);
        if (near != MUS_NONE) table[near * lanes] += items->w[i];
        else w[blocks_find(shape->far, nfar, items->linear_at[i]) * lanes] += items->w[i];
    }
}


/* ---- equal things once ---- */

/* index in *array of `size` bytes equal to `bytes`, appended if there are none; MUS_NONE without memory */
static int32_t blocks_intern(mus_context *context, const blocks_store *store, int32_t *slot, void *array, int32_t *n,
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


/* the block of nodes first .. first+count-1 */
static mus_status blocks_write(const blocks_walk *walk, const blocks_set *set, int32_t first, int32_t count,
                               const blocks_items *items)
{
    mus__plan *plan = walk->plan;
    mus__shape shape = {{0}, {0}};
    double value[(3 * MUS_NEAR_MOST + MUS_SLOTS) * MUS_LANES] = {0.0};
    double table[(3 * MUS_NEAR_MOST + MUS_SLOTS) * MUS_LANES]; /* the same numbers in the plan's precision */
    memcpy(shape.near, set->near, (size_t)set->nnear * sizeof *shape.near);
    const int32_t nfar = blocks_far(set, shape.far), size = mus__plan_table_size(plan);
    for (int32_t i = 0; i < count; i++) {
        blocks_lane(plan, &shape, set->nnear, nfar, &items[i], value + i);
        blocks_irregular(plan, &shape, set->nnear, nfar, first + i, value + i);
    }
    const int32_t krest = plan->near * MUS_LANES;
    for (int32_t i = 0; i < krest; i++) value[krest + i] *= mus__plan_share(plan);
    for (int32_t i = 0; i < size; i++) mus__plan_put(plan, table, i, value[i]);

    const int32_t s = blocks_intern(walk->context, walk->store, walk->store->shape, &plan->shape, &plan->nshape,
                                    &plan->shape_capacity, &shape, sizeof shape);
    const int32_t t = blocks_intern(walk->context, walk->store, walk->store->table, &plan->table, &plan->ntable,
                                    &plan->table_capacity, table, (size_t)size * plan->real);
    if (s == MUS_NONE || t == MUS_NONE) return mus__fail_memory(walk->context, "the blocks of a drape");
    plan->block[plan->nblock] = (mus__block){first, s, t};
    return MUS_OK;
}


/* ---- the walk ---- */

/* nodes first .. first+count-1 and the last nblock blocks, to the chunk before if it has room, or to a new one */
static void blocks_chunk(const blocks_walk *walk, int32_t first, int32_t count, int32_t nblock, int32_t *open)
{
    mus__plan *plan = walk->plan;
    if (*open < count) {
        plan->nchunk++;
        *open = MUS_CHUNK;
        if (walk->store != NULL)
            plan->chunk[plan->nchunk - 1] = (mus__chunk){.first = first, .block = plan->nblock - nblock};
    }
    *open -= count;
    if (walk->store == NULL) return;
    plan->chunk[plan->nchunk - 1].count += count;
    plan->chunk[plan->nchunk - 1].nblock += nblock;
}


/* one block from lattice node `first` of row *row on; moves *row on; returns how many nodes it has, 0 on failure */
static int32_t blocks_step(const blocks_walk *walk, int32_t first, int32_t *row, mus_status *status)
{
    mus__plan *plan = walk->plan;
    blocks_items items[MUS_LANES];
    blocks_set set = {.most = walk->most};
    int32_t count = 0, r = *row;
    while (count < MUS_LANES) {
        while (r < plan->nrow && plan->row[r].first + plan->row[r].count <= first + count) r++;
        if (r == plan->nrow || plan->row[r].first > first + count) break;
        if (!blocks_collect(plan, &plan->row[r], first + count, &items[count]) || !blocks_grow(&set, &items[count])) {
            if (count > 0) break;
            *status = mus__fail(walk->context, MUS_ERR_LIMIT, "drape: node %d has more than %d lattice neighbours",
                                (int)first, walk->most + MUS_SLOTS);
            return 0;
        }
        count++;
        *row = r;
    }

    for (int32_t i = 0; i < count; i++) blocks_invite(plan, &set, first + i);
    int32_t far[MUS_SLOTS];
    const int32_t nfar = blocks_far(&set, far);
    if (walk->store != NULL) *status = blocks_write(walk, &set, first, count, items);
    else if (set.nnear > plan->near) plan->near = set.nnear;
    if (walk->store == NULL && nfar > plan->far) plan->far = nfar;
    plan->nblock++;
    return *status == MUS_OK ? count : 0;
}


/* all nodes of the cloth, in order */
static mus_status blocks_all(const blocks_walk *walk, int32_t nnode)
{
    mus__plan *plan = walk->plan;
    mus_status status = MUS_OK;
    plan->nblock = plan->nchunk = 0;
    int32_t open = 0, lattice = 0;
    for (int32_t i = 0, r = 0; i < nnode && status == MUS_OK;) {
        while (r < plan->nrow && plan->row[r].first + plan->row[r].count <= i) r++;
        const int32_t inside = r < plan->nrow && plan->row[r].first <= i;
        if (inside != lattice) open = 0;
        lattice = inside;
        if (inside) {
            const int32_t count = blocks_step(walk, i, &r, &status);
            if (status == MUS_OK) blocks_chunk(walk, i, count, 1, &open);
            i += count;
            continue;
        }
        const int32_t until = r < plan->nrow ? plan->row[r].first : nnode;
        const int32_t count = until - i < MUS_CHUNK ? until - i : MUS_CHUNK;
        blocks_chunk(walk, i, count, 0, &open);
        i += count;
    }
    return status;
}


mus_status mus__plan_blocks(mus_context *context, const mus_cloth *cloth, mus__plan *plan)
{
    blocks_store store = {.slots = 16};
    blocks_walk walk = {context, plan, NULL, MUS_SLOTS};
    plan->near = plan->far = 0;
    mus_status status = blocks_all(&walk, cloth->nnode);
    if (status == MUS_ERR_LIMIT) {
        walk.most = MUS_NEAR_MOST;
        status = blocks_all(&walk, cloth->nnode);
    }
    if (status != MUS_OK) return status;

    /* the slots that the kernels have loops for */
    const int32_t paper = plan->near > MUS_SLOTS;
    plan->near = paper ? MUS_NEAR_MOST : plan->near > 4 || plan->far > 4 ? MUS_SLOTS : 4;
    plan->far = paper || plan->far > 4 ? MUS_SLOTS : plan->far > 0 ? 4 : 0;

    plan->block = mus__new(context, plan->nblock, sizeof *plan->block);
    plan->chunk = mus__new(context, plan->nchunk, sizeof *plan->chunk);
    while (store.slots < 2 * (int64_t)plan->nblock) store.slots *= 2;
    store.shape = mus__new(context, store.slots, sizeof *store.shape);
    store.table = mus__new(context, store.slots, sizeof *store.table);
    walk.store = &store;
    if (plan->block == NULL || plan->chunk == NULL || store.shape == NULL || store.table == NULL)
        status = mus__fail_memory(context, "the blocks of a drape");
    if (status == MUS_OK) status = blocks_all(&walk, cloth->nnode);
    mus__free(context, store.shape);
    mus__free(context, store.table);
    return status;
}


int32_t mus__plan_slot(const mus__plan *plan, int32_t node, int32_t other)
{
    int32_t low = 0, high = plan->nblock - 1;
    while (low < high) {
        const int32_t middle = (low + high + 1) / 2;
        if (plan->block[middle].first <= node) low = middle;
        else high = middle - 1;
    }
    const mus__shape *shape = &plan->shape[plan->block[low].shape];
    const int32_t near = blocks_find(shape->near, MUS_NEAR_MOST, other - node);
    if (near != MUS_NONE) return near;
    const int32_t far = blocks_find(shape->far, MUS_SLOTS, other - node);
    return far != MUS_NONE ? MUS_NEAR_MOST + far : MUS_NONE;
}
