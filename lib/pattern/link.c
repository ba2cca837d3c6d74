/*
 * link.c: union-find whose links carry a sign: classes of items, and within a class which of them run alike.
 *
 * Three uses: edges (a seam says that two are one, running alike or against each other), panels (a seam says that the
 * same sides are out or opposite ones), points (all signs +1). The root is the smallest index of the class, so
 * results do not depend on the order of the joins. Paths are compressed fully: O(log n) a find in the long run.
 */
#include "pattern/pattern_internal.h"


void mus__link_start(int32_t n, int32_t *parent, int32_t *sign)
{
    for (int32_t i = 0; i < n; i++) {
        parent[i] = i;
        sign[i] = 1;
    }
}


int32_t mus__link_find(int32_t *parent, int32_t *sign, int32_t i)
{
    /* up: the root, and the sign of i against it */
    int32_t root = i, total = 1;
    for (; parent[root] != root; root = parent[root]) total *= sign[root];

    /* again: hang every item of the path under the root */
    while (parent[i] != root) {
        int32_t up = parent[i], step = sign[i];
        parent[i] = root;
        sign[i] = total;
        total *= step;
        i = up;
    }
    return root;
}


bool mus__link_join(int32_t *parent, int32_t *sign, int32_t i, int32_t j, int32_t relation)
{
    int32_t a = mus__link_find(parent, sign, i), b = mus__link_find(parent, sign, j);
    int32_t link = sign[i] * sign[j] * relation;
    if (a == b) return link == 1;
    int32_t low = a < b ? a : b, high = a < b ? b : a;
    parent[high] = low;
    sign[high] = link;
    return true;
}
