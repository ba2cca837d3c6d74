/*
 * triangle_tree.h: the plain reference for contact: closest points on triangles by a tree of boxes.
 *
 * A binary tree of axis-aligned boxes, split at the median along the longest side, with a few triangles in a leaf. A
 * query visits the nearer child first and skips boxes farther than the nearest triangle so far (Ericson, Real-Time
 * Collision Detection, 2005, 5.1.5 for the triangle).
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
    int64_t visits; /* triangles visited so far */
} tree;

/* Builds a tree; vertices (n x 3), triangle (triangles x 3). Returns 0 when there is no memory. */
int tree_make(const double *vertices, int32_t triangles, const int32_t *triangle, tree *out);
void tree_free(tree *t);

/* Returns the distance of p (3) from the triangles. *nearest is the triangle, in the order of the leaves, at which the
 * search starts, or -1; it becomes the nearest one. */
double tree_nearest(tree *t, const double *p, int32_t *nearest);
/* Returns the distance of p (3) from the triangles, searched from the root. */
double tree_distance(tree *t, const double *p);

#endif
