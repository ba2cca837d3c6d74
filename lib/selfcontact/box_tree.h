/*
 * box_tree.h: which things of a moving cloth may come near each other: a tree of boxes, sixteen to a tree node. Broad
 * phase of the neighbour list.
 *
 * A thing (a corner, an edge, a triangle) moves straight from where it is to where it will be, and has a box at the
 * start and one at the end. Two boxes that are further apart than a reach along one axis, on the same side at both
 * times, are so all the time between: the least coordinate of straight movements is concave in time, the greatest
 * convex.
 *
 * Things are in the order of the pattern, near ones together. A tree node holds the boxes of sixteen things plane by
 * plane, so that a box is tested against a node in a few vectors; the node above holds the boxes of sixteen nodes. Two
 * trees of as many tiers are searched from the top down, and pairs come in the order of the things, whatever the width
 * of a vector.
 */
#ifndef MUS_SELFCONTACT_BOX_TREE_H
#define MUS_SELFCONTACT_BOX_TREE_H

#include "base/base_internal.h"

#define MUS__TREE_LANES 16
#define MUS__TREE_PLANES 12 /* of a tree node: low (3) and high (3) at the start, low and high at the end */
#define MUS__TREE_TIERS 8

typedef struct mus__box_tree {
    int32_t each;     /* nodes (of the cloth) of a thing: 1, 2 or 3 */
    int32_t capacity; /* things */
    int32_t count, tiers;
    int32_t first[MUS__TREE_TIERS + 1]; /* block of each tier; the last: how many blocks there are */
    int32_t *node;                      /* (tree nodes of the lowest tier x each x 16) of the cloth */
    int32_t *class_of;                  /* the same: their classes; negative where there is no thing */
    float *box;                         /* (tree nodes x 12 x 16) */
    uint16_t *stale;                    /* (tree nodes) a bit for each stale thing or tree node */
} mus__box_tree;

/* place of the lowest bit (Leiserson, Prokop, Randall, Using de Bruijn sequences to index a 1 in a computer word, 1998)
 */
static inline int32_t mus__box_tree_lowest(uint32_t bits)
{
    static const uint8_t place[32] = {0,  1,  28, 2,  29, 14, 24, 3, 30, 22, 20, 15, 25, 17, 4,  8,
                                      31, 27, 13, 23, 21, 19, 16, 7, 26, 12, 18, 6,  11, 5,  10, 9};
    return place[(bits & (~bits + 1)) * 0x077CB531u >> 27];
}


/* called with thing a of one tree, and the things of tree node b of the other that have their bit in `mask` */
typedef void (*mus__box_tree_fn)(void *user, int32_t a, int32_t b, uint32_t mask);

/* memory for `capacity` things of `each` nodes; what is made is destroyed also after a failure */
mus_status mus__box_tree_create(mus_context *context, int32_t each, int32_t capacity, mus__box_tree *tree);
void mus__box_tree_destroy(mus_context *context, mus__box_tree *tree);

/* a tree without things; one thing more; the tiers above the things, at least as many as `tiers` */
void mus__box_tree_clear(mus__box_tree *tree);
void mus__box_tree_add(mus__box_tree *tree, const int32_t *node, const int32_t *class_of);
void mus__box_tree_raise(mus__box_tree *tree, int32_t tiers);

/* nonzero when thing i has a node that is marked (nodes) */
static inline int32_t mus__box_tree_stale(const mus__box_tree *tree, int64_t i, const uint8_t *marked)
{
    const int32_t *node = tree->node + i / MUS__TREE_LANES * tree->each * MUS__TREE_LANES + i % MUS__TREE_LANES;
    int32_t any = 0;
    for (int32_t k = 0; k < tree->each; k++) any |= marked[node[k * MUS__TREE_LANES]];
    return any;
}


/* boxes of tree nodes from those of the things. stale (nodes) not NULL: only things with such a node have new boxes,
 * and are searched for by mus__box_tree_stale_pairs() */
void mus__box_tree_fit(mus__box_tree *tree, const uint8_t *stale);

/* pairs of things of both that may come nearer than `reach` and have no class in common. The same tree twice: each pair
 * once */
void mus__box_tree_pairs(const mus__box_tree *a, const mus__box_tree *b, float reach, mus__box_tree_fn fn, void *user);

/* of these the pairs with a stale thing, each searched for on its way down the other tree: cheaper when a few in a
 * hundred are stale. `back` is called the other way round, with a thing of b and a node of a, where only that of b is
 * stale; the same tree twice: never */
void mus__box_tree_stale_pairs(const mus__box_tree *a, const mus__box_tree *b, float reach, mus__box_tree_fn fn,
                               mus__box_tree_fn back, void *user);

#endif
