/*
 * box_grid.c: boxes to cells, cells to pairs.
 *
 * Two passes sort the boxes by cell; then each cell meets itself and 13 of its neighbours, the other 13 having met it.
 */
#include <string.h>

#include "selfcontact/box_grid.h"

#define GRID_BITS 18     /* bits of a cell's number along an axis: what is further off is in the last cell */
#define GRID_ROUND 4e-7f /* of a coordinate: bound of the rounding of a sum of floats */
#define GRID_LEAST 1e-6f /* [m] least width of a cell: above rounding */


mus_status mus__box_grid_create(mus_context *context, int32_t capacity, mus__box_grid *grid)
{
    memset(grid, 0, sizeof *grid);
    grid->capacity = capacity;
    for (grid->slots = 16; grid->slots < 2 * (int64_t)capacity;) grid->slots *= 2;
    grid->box = mus__new(context, 12 * (int64_t)capacity, sizeof *grid->box);
    grid->item = mus__new(context, capacity, sizeof *grid->item);
    grid->of = mus__new(context, capacity, sizeof *grid->of);
    grid->start = mus__new(context, (int64_t)capacity + 1, sizeof *grid->start);
    grid->key = mus__new(context, capacity, sizeof *grid->key);
    grid->slot = mus__new(context, grid->slots, sizeof *grid->slot);
    if (grid->box != NULL) grid->sorted = grid->box + 6 * (int64_t)capacity;
    if (grid->box != NULL && grid->item != NULL && grid->of != NULL && grid->start != NULL && grid->key != NULL &&
        grid->slot != NULL)
        return MUS_OK;
    mus__box_grid_destroy(context, grid);
    return mus__fail_memory(context, "the grid of a cloth");
}


void mus__box_grid_destroy(mus_context *context, mus__box_grid *grid)
{
    void *blocks[] = {grid->box, grid->item, grid->of, grid->start, grid->key, grid->slot};
    for (size_t i = 0; i < sizeof blocks / sizeof blocks[0]; i++) mus__free(context, blocks[i]);
    memset(grid, 0, sizeof *grid);
}


/* number of the cell of a place along an axis; what is no number is in the first */
static int64_t grid_number(float x, float low, float size)
{
    const float at = (x - low) / size, last = (float)(1 << GRID_BITS);
    return at > 0.0f ? at < last ? (int64_t)at + 1 : (1 << GRID_BITS) : 1;
}


static int64_t grid_key(int64_t x, int64_t y, int64_t z)
{
    return (x * (1 << (GRID_BITS + 2)) + y) * (1 << (GRID_BITS + 2)) + z;
}


/* the slot that has the key, or the free one where it belongs */
static mus__box_slot *grid_find(const mus__box_grid *grid, int64_t key)
{
    uint64_t at = (uint64_t)key * UINT64_C(0x9E3779B97F4A7C15) >> 32;
    for (;; at++) {
        mus__box_slot *slot = &grid->slot[at & (uint64_t)(grid->slots - 1)];
        if (slot->cell == MUS_NONE || slot->key == key) return slot;
    }
}


/* the first n boxes sorted by cells of `reach` and the largest box: centres of boxes that meet are no farther apart.
 * Returns the number of cells */
static int32_t grid_sort(mus__box_grid *grid, int32_t n, float reach)
{
    float low[3] = {3e38f, 3e38f, 3e38f}, widest = GRID_LEAST, far = 0.0f;
    for (int32_t i = 0; i < n; i++)
        for (int32_t d = 0; d < 3; d++) {
            const float a = grid->box[6 * (int64_t)i + d], b = grid->box[6 * (int64_t)i + 3 + d];
            if (a < low[d]) low[d] = a;
            if (b - a > widest) widest = b - a;
            if (b > far) far = b;
            if (-a > far) far = -a;
        }
    const float size = widest + reach + GRID_ROUND * far;

    /* which cell each box is in, how many there are in each */
    int32_t cells = 0;
    memset(grid->start, 0, ((size_t)n + 1) * sizeof *grid->start);
    for (int32_t s = 0; s < grid->slots; s++) grid->slot[s].cell = MUS_NONE;
    for (int32_t i = 0; i < n; i++) {
        const float *b = grid->box + 6 * (int64_t)i;
        int64_t at[3];
        for (int32_t d = 0; d < 3; d++) at[d] = grid_number(0.5f * (b[d] + b[d + 3]), low[d], size);
        const int64_t key = grid_key(at[0], at[1], at[2]);
        mus__box_slot *slot = grid_find(grid, key);
        if (slot->cell == MUS_NONE) {
            slot->key = grid->key[cells] = key;
            slot->cell = cells++;
        }
        grid->of[i] = slot->cell;
        grid->start[slot->cell + 1]++;
    }

    /* where each cell starts; boxes to their places, which moves the starts on by one cell */
    for (int32_t c = 0; c < cells; c++) grid->start[c + 1] += grid->start[c];
    for (int32_t i = 0; i < n; i++) {
        const int32_t to = grid->start[grid->of[i]]++;
        grid->item[to] = i;
        memcpy(grid->sorted + 6 * (int64_t)to, grid->box + 6 * (int64_t)i, 6 * sizeof *grid->box);
    }
    memmove(grid->start + 1, grid->start, (size_t)cells * sizeof *grid->start);
    grid->start[0] = 0;
    return cells;
}


/* box i of the sorted ones with those from j to end */
static void grid_meet(const mus__box_grid *grid, int32_t i, int32_t j, int32_t end, float reach, mus__box_pair_fn fn,
                      void *user)
{
    const float *a = grid->sorted + 6 * (int64_t)i;
    const float l0 = a[0] - reach, l1 = a[1] - reach, l2 = a[2] - reach;
    const float h0 = a[3] + reach, h1 = a[4] + reach, h2 = a[5] + reach;
    const int32_t s = grid->item[i];
    for (; j < end; j++) {
        const float *b = grid->sorted + 6 * (int64_t)j;
        if (b[3] < l0 || b[0] > h0 || b[4] < l1 || b[1] > h1 || b[5] < l2 || b[2] > h2) continue;
        const int32_t t = grid->item[j];
        fn(user, s < t ? s : t, s < t ? t : s);
    }
}


/* the cell at k / 9 - 1, k / 3 % 3 - 1, k % 3 - 1 from cell c, or MUS_NONE */
static int32_t grid_beside(const mus__box_grid *grid, int32_t c, int32_t k)
{
    return grid_find(grid, grid->key[c] + grid_key(k / 9 - 1, k / 3 % 3 - 1, k % 3 - 1))->cell;
}


void mus__box_grid_pairs(mus__box_grid *grid, int32_t n, float reach, mus__box_pair_fn fn, void *user)
{
    const int32_t cells = n > 0 ? grid_sort(grid, n, reach) : 0;
    for (int32_t c = 0; c < cells; c++)
        for (int32_t k = 13; k < 27; k++) { /* itself, and those ahead of it in the order of x, y, z */
            const int32_t other = k > 13 ? grid_beside(grid, c, k) : c;
            if (other == MUS_NONE) continue;
            for (int32_t i = grid->start[c]; i < grid->start[c + 1]; i++)
                grid_meet(grid, i, other != c ? grid->start[other] : i + 1, grid->start[other + 1], reach, fn, user);
        }
}
