/*
 * union_find.c: union-find whose links may carry a sign: classes of items, and which items of a class run alike.
 *
 * Uses with a sign: edges (a seam says that two are one, running alike or against each other) and panels (a seam says
 * that the same sides of the cloth are out, or opposite ones). Uses without: points, nodes that are welded, panels that
 * hang together. The root is the smallest index of its class, so results do not depend on the order of the joins. Every
 * find compresses its whole path; a sequence of m finds costs O(m log n). Source: Galler and Fischer, An improved
 * equivalence algorithm, Communications of the ACM 7, 1964; Tarjan and van Leeuwen, Worst-case analysis of set union
 * algorithms, Journal of the ACM 31, 1984.
 */
#include <stddef.h>

#include "geom/union_find.h"


void mus__union_start(int32_t n, int32_t *parent, int32_t *sign)
{
    for (int32_t i = 0; i < n; i++) parent[i] = i;
    for (int32_t i = 0; i < n && sign != NULL; i++) sign[i] = 1;
}


int32_t mus__union_find(int32_t *parent, int32_t *sign, int32_t i)
{
    /* up: the root, and the sign of i relative to it */
    int32_t root = i, total = 1;
    for (; parent[root] != root; root = parent[root])
        if (sign != NULL) total *= sign[root];

    /* again: link every item of the path to the root */
    while (parent[i] != root) {
        const int32_t up = parent[i];
        parent[i] = root;
        if (sign != NULL) {
            const int32_t step = sign[i];
            sign[i] = total;
            total *= step;
        }
        i = up;
    }
    return root;
}


bool mus__union_join(int32_t *parent, int32_t *sign, int32_t i, int32_t j, int32_t relation)
{
    const int32_t a = mus__union_find(parent, sign, i), b = mus__union_find(parent, sign, j);
    const int32_t link = sign != NULL ? sign[i] * sign[j] * relation : 1;
    if (a == b) return link == 1;
    const int32_t low = a < b ? a : b, high = a < b ? b : a;
    parent[high] = low;
    if (sign != NULL) sign[high] = link;
    return true;
}
