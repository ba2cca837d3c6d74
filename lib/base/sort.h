/*
 * sort.h: a sort by a source of our own: what qsort does with equal elements differs between C libraries.
 */
#ifndef MUS_BASE_SORT_H
#define MUS_BASE_SORT_H

#include <stddef.h>

/* Sorts `count` elements of `size` bytes by `compare`, as qsort does. Elements that compare equal keep their order.
 * Allocates nothing; uses 4 kB of stack. Cost: count log(count) comparisons, and moves of count log(count)^2 elements
 * at most */
void mus__sort(void *base, size_t count, size_t size, int (*compare)(const void *, const void *));

#endif
