/*
 * box_tree.c: two trees of boxes searched from the top down, a box against sixteen at a time.
 */
#include <string.h>

#include "base/target_clones.h"
#include "selfcontact/box_tree.h"

#define TREE_FAR 3e38f /* where there is no thing: a box that no other is near */


/* blocks of all tiers over so many things */
static int32_t tree_blocks(int32_t things)
{
    int32_t all = 0, blocks = things;
    for (int32_t l = 0; l < MUS__TREE_TIERS; l++) {
        blocks = blocks > MUS__TREE_LANES ? (blocks + MUS__TREE_LANES - 1) / MUS__TREE_LANES : 1;
        all += blocks;
    }
    return all;
}


mus_status mus__box_tree_create(mus_context *context, int32_t each, int32_t capacity, mus__box_tree *tree)
{
    const int64_t blocks = tree_blocks(capacity), below = (int64_t)capacity / MUS__TREE_LANES + 1;
    memset(tree, 0, sizeof *tree);
    tree->each = each;
    tree->capacity = capacity;
    tree->node = mus__new(context, below * each * MUS__TREE_LANES, sizeof *tree->node);
    tree->class_of = mus__new(context, below * each * MUS__TREE_LANES, sizeof *tree->class_of);
    tree->box = mus__new(context, blocks * MUS__TREE_PLANES * MUS__TREE_LANES, sizeof *tree->box);
    tree->stale = mus__new(context, blocks, sizeof *tree->stale);
    if (tree->node != NULL && tree->class_of != NULL && tree->box != NULL && tree->stale != NULL) return MUS_OK;
    return mus__fail_memory(context, "the boxes of a cloth");
}


void mus__box_tree_destroy(mus_context *context, mus__box_tree *tree)
{
    mus__free(context, tree->node);
    mus__free(context, tree->class_of);
    mus__free(context, tree->box);
    mus__free(context, tree->stale);
    memset(tree, 0, sizeof *tree);
}


void mus__box_tree_clear(mus__box_tree *tree)
{
    tree->count = 0;
}


void mus__box_tree_add(mus__box_tree *tree, const int32_t *node, const int32_t *class_of)
{
    const int64_t at =
        (int64_t)(tree->count / MUS__TREE_LANES) * tree->each * MUS__TREE_LANES + tree->count % MUS__TREE_LANES;
    for (int32_t k = 0; k < tree->each; k++) {
        tree->node[at + k * MUS__TREE_LANES] = node[k];
        tree->class_of[at + k * MUS__TREE_LANES] = class_of[node[k]];
    }
    tree->count++;
}


void mus__box_tree_raise(mus__box_tree *tree, int32_t tiers)
{
    int32_t blocks = (tree->count + MUS__TREE_LANES - 1) / MUS__TREE_LANES, all = 0;
    tree->tiers = 0;
    do {
        tree->first[tree->tiers++] = all;
        all += blocks > 0 ? blocks : 1;
        if (blocks <= 1 && tree->tiers >= tiers) break;
        blocks = (blocks + MUS__TREE_LANES - 1) / MUS__TREE_LANES;
    } while (tree->tiers < MUS__TREE_TIERS);
    tree->first[tree->tiers] = all;

    /* places without a thing or a tree node */
    for (int64_t b = 0; b < all; b++)
        for (int64_t p = 0; p < MUS__TREE_PLANES; p++)
            for (int64_t k = 0; k < MUS__TREE_LANES; k++)
                tree->box[(b * MUS__TREE_PLANES + p) * MUS__TREE_LANES + k] = p % 6 < 3 ? TREE_FAR : -TREE_FAR;
    for (int32_t i = tree->count; i < tree->first[1] * MUS__TREE_LANES; i++)
        for (int64_t k = 0; k < tree->each; k++)
            tree->class_of[((int64_t)(i / MUS__TREE_LANES) * tree->each + k) * MUS__TREE_LANES + i % MUS__TREE_LANES] =
                -1;
}


/* the box of a tree node as one of those of the node above */
MUS_CLONES
static void tree_around(const float *block, float *above)
{
    for (int32_t p = 0; p < MUS__TREE_PLANES; p++) {
        const float *plane = block + p * MUS__TREE_LANES;
        float low = plane[0], high = plane[0];
        for (int32_t k = 1; k < MUS__TREE_LANES; k++) {
            low = plane[k] < low ? plane[k] : low;
            high = plane[k] > high ? plane[k] : high;
        }
        above[p * MUS__TREE_LANES] = p % 6 < 3 ? low : high;
    }
}


void mus__box_tree_fit(mus__box_tree *tree, const uint8_t *stale)
{
    memset(tree->stale, stale == NULL ? 0xff : 0, (size_t)tree->first[tree->tiers] * sizeof *tree->stale);
    for (int64_t i = 0; stale != NULL && i < tree->count; i++)
        if (mus__box_tree_stale(tree, i, stale))
            tree->stale[i / MUS__TREE_LANES] |= (uint16_t)(1 << i % MUS__TREE_LANES);
    for (int32_t l = 0; l + 1 < tree->tiers; l++)
        for (int64_t b = tree->first[l]; b < tree->first[l + 1]; b++) {
            const int64_t i = b - tree->first[l], above = tree->first[l + 1] + i / MUS__TREE_LANES;
            const int64_t lane = i % MUS__TREE_LANES;
            if (!tree->stale[b]) continue;
            tree_around(tree->box + b * MUS__TREE_PLANES * MUS__TREE_LANES,
                        tree->box + above * MUS__TREE_PLANES * MUS__TREE_LANES + lane);
            tree->stale[above] |= (uint16_t)(1 << lane);
        }
}


/* lanes of tree node j of a tier that hold a thing or a tree node. Boxes of the other lanes are ignored whatever the
 * reach, which is infinite where a place overflowed */
static uint32_t tree_held(const mus__box_tree *tree, int32_t tier, int32_t j)
{
    const int32_t all = tier == 0 ? tree->count : tree->first[tier] - tree->first[tier - 1];
    const int32_t held = all - j * MUS__TREE_LANES;
    return held >= MUS__TREE_LANES ? 0xffffu : (1u << held) - 1;
}


/*
 * mask[r]: the boxes of tree node b that may come within reach of box r of tree node a. The gap along an axis is, for
 * each side, the lesser of those at the start and at the end; the gap of two boxes is the greatest of these.
 */
MUS_CLONES
static void tree_masks(const float *restrict a, const float *restrict b, float reach, uint32_t *restrict mask)
{
    enum { N = MUS__TREE_LANES };
    for (int32_t r = 0; r < N; r++) mask[r] = 0;
    for (int32_t k = 0; k < N; k++) {
        const uint32_t bit = (uint32_t)1 << k;
        float gap[N];
        MUS_ROLLED
        for (int32_t r = 0; r < N; r++) gap[r] = -TREE_FAR;
        for (int32_t d = 0; d < 3; d++) {
            const float low = b[d * N + k], high = b[(3 + d) * N + k];
            const float low2 = b[(6 + d) * N + k], high2 = b[(9 + d) * N + k];
            const float *al = a + d * N, *ah = a + (3 + d) * N, *al2 = a + (6 + d) * N, *ah2 = a + (9 + d) * N;
            MUS_ROLLED
            for (int32_t r = 0; r < N; r++) {
                const float up = al[r] - high, up2 = al2[r] - high2, down = low - ah[r], down2 = low2 - ah2[r];
                const float over = up < up2 ? up : up2, under = down < down2 ? down : down2;
                const float most = over > under ? over : under;
                gap[r] = most > gap[r] ? most : gap[r];
            }
        }
        MUS_ROLLED
        for (int32_t r = 0; r < N; r++) mask[r] |= gap[r] <= reach ? bit : 0;
    }
}


/* of `bits` those of things without a class in common with thing r of a tree node; classes plane by plane */
MUS_CLONES
static uint32_t tree_apart(const int32_t *restrict a, int32_t aeach, int32_t r, const int32_t *restrict b,
                           int32_t beach, uint32_t bits)
{
    enum { N = MUS__TREE_LANES };
    uint32_t joined[N] = {0}, out = 0;
    for (int32_t i = 0; i < aeach; i++)
        for (int32_t j = 0; j < beach; j++) {
            const int32_t own = a[i * N + r];
            MUS_ROLLED
            for (int32_t k = 0; k < N; k++) joined[k] |= own == b[j * N + k] ? 1 : 0;
        }
    for (int32_t k = 0; k < N; k++) out |= joined[k] << k;
    return bits & ~out;
}


typedef struct tree_search {
    const mus__box_tree *a, *b;
    float reach;
    mus__box_tree_fn fn;
    void *user;
} tree_search;


/* pairs below node i of a tier of one tree and node j of the same tier of the other */
static void tree_meet(const tree_search *s, int32_t tier, int32_t i, int32_t j)
{
    const mus__box_tree *a = s->a, *b = s->b;
    const int64_t of = a->first[tier] + (int64_t)i, met = b->first[tier] + (int64_t)j;
    uint32_t mask[MUS__TREE_LANES];
    tree_masks(a->box + of * MUS__TREE_PLANES * MUS__TREE_LANES, b->box + met * MUS__TREE_PLANES * MUS__TREE_LANES,
               s->reach, mask);
    const uint32_t held = tree_held(b, tier, j);
    const uint32_t rows = tree_held(a, tier, i);
    for (int32_t r = 0; r < MUS__TREE_LANES; r++) {
        uint32_t bits = rows >> r & 1 ? mask[r] & held : 0;
        if (a == b && i == j) bits &= tier > 0 ? ~0u << r : ~0u << r << 1;
        if (bits == 0) continue;
        if (tier == 0) {
            bits = tree_apart(a->class_of + (int64_t)i * a->each * MUS__TREE_LANES, a->each, r,
                              b->class_of + (int64_t)j * b->each * MUS__TREE_LANES, b->each, bits);
            if (bits != 0) s->fn(s->user, i * MUS__TREE_LANES + r, j, bits);
            continue;
        }
        for (; bits != 0; bits &= bits - 1)
            tree_meet(s, tier - 1, i * MUS__TREE_LANES + r, j * MUS__TREE_LANES + mus__box_tree_lowest(bits));
    }
}


void mus__box_tree_pairs(const mus__box_tree *a, const mus__box_tree *b, float reach, mus__box_tree_fn fn, void *user)
{
    const tree_search search = {a, b, reach, fn, user};
    if (a->count > 0 && b->count > 0) tree_meet(&search, a->tiers - 1, 0, 0);
}


/* the boxes of a tree node that may come within reach of one box, as tree_masks() */
MUS_CLONES
static uint32_t tree_mask(const float *restrict a, const float *restrict b, float reach)
{
    enum { N = MUS__TREE_LANES };
    uint32_t mask = 0;
    float gap[N];
    MUS_ROLLED
    for (int32_t r = 0; r < N; r++) gap[r] = -TREE_FAR;
    for (int32_t d = 0; d < 3; d++) {
        const float low = a[d * N], high = a[(3 + d) * N], low2 = a[(6 + d) * N], high2 = a[(9 + d) * N];
        const float *bl = b + d * N, *bh = b + (3 + d) * N, *bl2 = b + (6 + d) * N, *bh2 = b + (9 + d) * N;
        MUS_ROLLED
        for (int32_t r = 0; r < N; r++) {
            const float up = low - bh[r], up2 = low2 - bh2[r], down = bl[r] - high, down2 = bl2[r] - high2;
            const float over = up < up2 ? up : up2, under = down < down2 ? down : down2;
            const float most = over > under ? over : under;
            gap[r] = most > gap[r] ? most : gap[r];
        }
    }
    for (int32_t r = 0; r < N; r++) mask |= (uint32_t)(gap[r] <= reach) << r;
    return mask;
}


/* thing i of a tree and things below node j of a tier of the other; stale things there below `from` had their turn */
static void tree_ask(const tree_search *s, int32_t i, int32_t from, int32_t tier, int32_t j)
{
    enum { N = MUS__TREE_LANES };
    const mus__box_tree *a = s->a, *b = s->b;
    const int64_t block = i / N, lane = i % N, met = b->first[tier] + (int64_t)j;
    const float *box = a->box + block * MUS__TREE_PLANES * N + lane, *boxes = b->box + met * MUS__TREE_PLANES * N;
    uint32_t bits = tree_mask(box, boxes, s->reach) & tree_held(b, tier, j);
    if (tier > 0) {
        for (; bits != 0; bits &= bits - 1) tree_ask(s, i, from, tier - 1, j * N + mus__box_tree_lowest(bits));
        return;
    }
    const int32_t past = from - j * N;
    bits &= ~(uint32_t)b->stale[met] | (past <= 0 ? ~0u : past >= N ? 0u : ~0u << past);
    if (bits == 0) return;
    bits = tree_apart(a->class_of + block * a->each * N, a->each, (int32_t)lane, b->class_of + (int64_t)j * b->each * N,
                      b->each, bits);
    if (bits != 0) s->fn(s->user, i, j, bits);
}


/* the stale things of a tree against the other; where `turn`, not against that one's stale things */
static void tree_asks(const tree_search *s, int32_t turn)
{
    const mus__box_tree *a = s->a;
    for (int32_t block = 0; block < a->first[1]; block++)
        for (uint32_t left = a->stale[block]; left != 0; left &= left - 1) {
            const int32_t i = block * MUS__TREE_LANES + mus__box_tree_lowest(left);
            tree_ask(s, i, turn ? s->b->count : a == s->b ? i + 1 : 0, s->b->tiers - 1, 0);
        }
}


void mus__box_tree_stale_pairs(const mus__box_tree *a, const mus__box_tree *b, float reach, mus__box_tree_fn fn,
                               mus__box_tree_fn back, void *user)
{
    const tree_search there = {a, b, reach, fn, user}, again = {b, a, reach, back, user};
    if (a->count == 0 || b->count == 0) return;
    tree_asks(&there, 0);
    if (a != b) tree_asks(&again, 1);
}
