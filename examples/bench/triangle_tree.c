/* triangle_tree.c: closest points on triangles by a tree of boxes. */
#include "triangle_tree.h"

#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#define LEAF 4
#define STACK 128


static double part_dot(const double *a, const double *b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}


/* Returns the squared distance of p from the triangle c (9) [m2]. */
static double triangle_distance2(const double *c, const double *p)
{
    double ab[3], ac[3], ap[3], q[3], v = 0.0, w = 0.0;
    for (int i = 0; i < 3; i++) ab[i] = c[3 + i] - c[i], ac[i] = c[6 + i] - c[i], ap[i] = p[i] - c[i];
    const double d1 = part_dot(ab, ap), d2 = part_dot(ac, ap), bb = part_dot(ab, ab), bc = part_dot(ab, ac),
                 cc = part_dot(ac, ac);
    const double d3 = d1 - bb, d4 = d2 - bc, d5 = d1 - bc, d6 = d2 - cc;
    const double va = d3 * d6 - d5 * d4, vb = d5 * d2 - d1 * d6, vc = d1 * d4 - d3 * d2;

    /* find whether a corner, an edge or the face is nearest */
    if (d1 <= 0.0 && d2 <= 0.0)
        v = w = 0.0;
    else if (d3 >= 0.0 && d4 <= d3)
        v = 1.0;
    else if (d6 >= 0.0 && d5 <= d6)
        w = 1.0;
    else if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0)
        v = d1 / (d1 - d3);
    else if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0)
        w = d2 / (d2 - d6);
    else if (va <= 0.0 && d4 >= d3 && d5 >= d6)
        w = (d4 - d3) / (d4 - d3 + d5 - d6), v = 1.0 - w;
    else
        v = vb / (va + vb + vc), w = vc / (va + vb + vc);
    for (int i = 0; i < 3; i++) q[i] = ap[i] - v * ab[i] - w * ac[i];
    return part_dot(q, q);
}


static double box_distance2(const tree_node *n, const double *p)
{
    double sum = 0.0;
    for (int i = 0; i < 3; i++) {
        const double out = p[i] < n->low[i] ? n->low[i] - p[i] : p[i] > n->high[i] ? p[i] - n->high[i] : 0.0;
        sum += out * out;
    }
    return sum;
}


/* ---- building ---- */

typedef struct order {
    double key;
    int32_t triangle;
} order;


static int compare(const void *a, const void *b)
{
    const order *p = a, *q = b;
    if (p->key != q->key) return p->key < q->key ? -1 : 1;
    return p->triangle < q->triangle ? -1 : 1;
}


/* Builds node `n` over the triangles first .. first+count-1 of `list`, whose corners are in `from`. */
static void split(tree *t, int32_t n, const double *from, order *list, int32_t first, int32_t count)
{
    tree_node *node = &t->node[n];
    for (int i = 0; i < 3; i++) node->low[i] = INFINITY, node->high[i] = -INFINITY;
    for (int32_t k = first; k < first + count; k++)
        for (int i = 0; i < 9; i++) {
            const double x = from[9 * (ptrdiff_t)list[k].triangle + i];
            node->low[i % 3] = fmin(node->low[i % 3], x);
            node->high[i % 3] = fmax(node->high[i % 3], x);
        }
    node->first = first;
    node->count = count;
    if (count <= LEAF) {
        for (int32_t k = first; k < first + count; k++)
            memcpy(t->corner + 9 * (ptrdiff_t)k, from + 9 * (ptrdiff_t)list[k].triangle, 9 * sizeof *from);
        return;
    }

    int axis = 0;
    for (int i = 1; i < 3; i++)
        if (node->high[i] - node->low[i] > node->high[axis] - node->low[axis]) axis = i;
    for (int32_t k = first; k < first + count; k++) {
        const double *c = from + 9 * (ptrdiff_t)list[k].triangle + axis;
        list[k].key = c[0] + c[3] + c[6];
    }
    qsort(list + first, (size_t)count, sizeof *list, compare);
    node->first = t->nodes;
    node->count = 0;
    t->nodes += 2;
    const int32_t child = node->first, half = count / 2;
    split(t, child, from, list, first, half);
    split(t, child + 1, from, list, first + half, count - half);
}


int tree_make(const double *vertices, int32_t triangles, const int32_t *triangle, tree *out)
{
    memset(out, 0, sizeof *out);
    const size_t count = (size_t)triangles;
    double *from = malloc(9 * count * sizeof *from);
    order *list = malloc(count * sizeof *list);
    out->node = malloc(2 * count * sizeof *out->node);
    out->corner = malloc(9 * count * sizeof *out->corner);
    if (from != NULL && list != NULL && out->node != NULL && out->corner != NULL) {
        for (int32_t k = 0; k < triangles; k++) {
            list[k].triangle = k;
            for (int i = 0; i < 9; i++)
                from[9 * (ptrdiff_t)k + i] = vertices[3 * (ptrdiff_t)triangle[3 * (ptrdiff_t)k + i / 3] + i % 3];
        }
        out->triangles = triangles;
        out->nodes = 1;
        split(out, 0, from, list, 0, triangles);
    }
    free(from);
    free(list);
    if (out->nodes > 0) return 1;
    tree_free(out);
    return 0;
}


void tree_free(tree *t)
{
    free(t->node);
    free(t->corner);
    memset(t, 0, sizeof *t);
}


/* ---- queries ---- */

double tree_nearest(tree *t, const double *p, int32_t *nearest)
{
    struct {
        int32_t node;
        double distance2;
    } stack[STACK];
    int32_t top = 0;
    double best = *nearest >= 0 ? triangle_distance2(t->corner + 9 * (ptrdiff_t)*nearest, p) : INFINITY;
    t->visits += *nearest >= 0;
    stack[top].node = 0, stack[top++].distance2 = box_distance2(&t->node[0], p);
    while (top > 0) {
        const tree_node *node = &t->node[stack[--top].node];
        if (stack[top].distance2 >= best) continue;
        if (node->count > 0) {
            for (int32_t k = node->first; k < node->first + node->count; k++) {
                const double distance2 = triangle_distance2(t->corner + 9 * (ptrdiff_t)k, p);
                if (distance2 < best) best = distance2, *nearest = k;
            }
            t->visits += node->count;
            continue;
        }

        /* visit the nearer child first */
        const double a = box_distance2(&t->node[node->first], p), b = box_distance2(&t->node[node->first + 1], p);
        const int32_t near = node->first + (b < a), far = node->first + !(b < a);
        if (fmax(a, b) < best) stack[top].node = far, stack[top++].distance2 = fmax(a, b);
        if (fmin(a, b) < best) stack[top].node = near, stack[top++].distance2 = fmin(a, b);
    }
    return sqrt(best);
}


double tree_distance(tree *t, const double *p)
{
    int32_t nearest = -1;
    return tree_nearest(t, p, &nearest);
}
