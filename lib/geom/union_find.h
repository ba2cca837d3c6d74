/*
 * union_find.h: classes of items that are said to be one pair by pair, with a sign on each item if wanted.
 */
#ifndef MUS_UNION_FIND_H
#define MUS_UNION_FIND_H

#include <stdbool.h>
#include <stdint.h>

/* each of n items is a class of its own: parent[i] = i, sign[i] = +1. parent (n); sign (n) or NULL, here and below:
 * then classes have no signs */
void mus__union_start(int32_t n, int32_t *parent, int32_t *sign);

/* the root of the class of item i, which is the smallest index of the class. parent[i] is that root afterwards, and
 * sign[i] the sign of i relative to it */
int32_t mus__union_find(int32_t *parent, int32_t *sign, int32_t i);

/* make one class of those of i and j, with sign[i] * sign[j] = relation (+1 or -1). Returns false, and changes no
 * class, when i and j are in one class already and their signs contradict the relation */
bool mus__union_join(int32_t *parent, int32_t *sign, int32_t i, int32_t j, int32_t relation);

#endif
