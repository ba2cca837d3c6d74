/*
 * triangle_tree.h: the plain reference for contact: closest points on triangles by a tree of boxes.
 *
 * A binary tree of axis-aligned boxes, split at the median along the longest side, a few triangles a leaf; a query goes
 * down the nearer child first and leaves out what is farther than the best so far (Ericson, Real-Time Collision
 * Detection, 2005, 5.1.5 for the triangle).
 */
#ifndef BENCH_TRIANGLE_TREE_H
#define BENCH_TRIANGLE_TREE_H

#include <stdint.h>

typedef struct tree_node {
    double low[3], high[3];
    int32_t first, count; /* triangles of a leaf; count 0: children at first and first + 1 */
} tree_node;

typedef struct tree {
    int32_t triangles, nodes;
    tree_node *node;
    double *corner; /* (triangles x 9), leaf by leaf */
    int64_t visits; /* triangles asked so far */
} tree;

/* 0 when there is no memory. vertices (n x 3), triangle (triangles x 3) */
int tree_make(const double *vertices, int32_t triangles, const int32_t *triangle, tree *out);
void tree_free(tree *t);

/* distance of p (3) to the triangles; *nearest in: a triangle, in the order of the leaves, from which the search
 * starts, -1 for none; out: the nearest */
double tree_nearest(tree *t, const double *p, int32_t *nearest);
/* the same from nothing */
double tree_distance(tree *t, const double *p);

#endif
