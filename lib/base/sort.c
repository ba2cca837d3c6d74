/*
 * sort.c: a stable merge sort in place. Two runs of which one fits into a buffer on the stack are merged through it;
 * longer runs are cut in two pairs by a rotation and each pair is merged. Source: Dudzinski and Dydek, On a Stable
 * Minimum Storage Merging Algorithm, 1981 (cut and rotation).
 */
#include "base/sort.h"

#include <string.h>

#define SORT_SPARE 4096 /* bytes on the stack; chosen: merges of 256 elements of 16 bytes need no rotation */
#define SORT_RUN 8      /* elements of the runs that are sorted by insertion; chosen */

typedef unsigned char sort_byte;

typedef struct sort_job {
    size_t size; /* of an element [bytes] */
    int (*compare)(const void *, const void *);
    sort_byte spare[SORT_SPARE];
} sort_job;


static void sort_swap(sort_job *job, sort_byte *a, sort_byte *b, size_t bytes)
{
    while (bytes > 0) {
        const size_t n = bytes < SORT_SPARE ? bytes : SORT_SPARE;
        memcpy(job->spare, a, n);
        memcpy(a, b, n);
        memcpy(b, job->spare, n);
        a += n;
        b += n;
        bytes -= n;
    }
}


/* Exchanges two blocks that lie one after the other. Source: Gries and Mills, Swapping Sections, 1981. */
static void sort_rotate(sort_job *job, sort_byte *at, size_t left, size_t right)
{
    while (left > 0 && right > 0) {
        if (left <= right) {
            sort_swap(job, at, at + left, left);
            at += left;
            right -= left;
        } else {
            sort_swap(job, at + left - right, at + left, right);
            left -= right;
        }
    }
}


/* Number of the n sorted elements that go before `key`; of equal ones all when `after`, else none. */
static size_t sort_rank(const sort_job *job, const sort_byte *at, size_t n, const sort_byte *key, int after)
{
    size_t low = 0, high = n;
    while (low < high) {
        const size_t middle = low + (high - low) / 2;
        const int order = job->compare(at + middle * job->size, key);
        if (order < 0 || (order == 0 && after))
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}


/* Merges through the buffer, into which the left run (from the front) or the right one (from the back) fits. */
static void sort_merge_spare(sort_job *job, sort_byte *at, size_t left, size_t right)
{
    const size_t size = job->size;
    if (left <= right) {
        const sort_byte *l = job->spare, *l_end = l + left * size, *r = at + left * size, *r_end = r + right * size;
        memcpy(job->spare, at, left * size);
        for (; l < l_end; at += size) {
            const int take = r < r_end && job->compare(r, l) < 0;
            memcpy(at, take ? r : l, size);
            if (take)
                r += size;
            else
                l += size;
        }
    } else {
        sort_byte *to = at + (left + right) * size, *l = at + left * size;
        const sort_byte *r = job->spare + right * size;
        memcpy(job->spare, l, right * size);
        while (r > job->spare) {
            const int take = l > at && job->compare(r - size, l - size) < 0;
            to -= size;
            memcpy(to, take ? l - size : r - size, size);
            if (take)
                l -= size;
            else
                r -= size;
        }
    }
}


/* Merges two sorted runs that lie one after the other. */
static void sort_merge(sort_job *job, sort_byte *at, size_t left, size_t right)
{
    const size_t size = job->size;
    while (left > 0 && right > 0) {
        sort_byte *middle = at + left * size;
        if (job->compare(middle - size, middle) <= 0) return;
        if ((left < right ? left : right) <= SORT_SPARE / size) {
            sort_merge_spare(job, at, left, right);
            return;
        }
        size_t l, r;
        if (left > right) {
            l = left / 2;
            r = sort_rank(job, middle, right, at + l * size, 0);
        } else {
            r = right / 2;
            l = sort_rank(job, at, left, middle + r * size, 1);
        }
        if (left == 1 && right == 1) l = 0, r = 1;
        sort_rotate(job, at + l * size, (left - l) * size, r * size);
        sort_merge(job, at, l, r);
        at += (l + r) * size;
        left -= l;
        right -= r;
    }
}


void mus__sort(void *base, size_t count, size_t size, int (*compare)(const void *, const void *))
{
    sort_job job = {.size = size, .compare = compare};
    sort_byte *at = base;
    for (size_t first = 0; first < count; first += SORT_RUN) {
        const size_t n = count - first < SORT_RUN ? count - first : SORT_RUN;
        sort_byte *run = at + first * size;
        for (size_t i = 1; i < n; i++) {
            const size_t to = sort_rank(&job, run, i, run + i * size, 1);
            sort_rotate(&job, run + to * size, (i - to) * size, size);
        }
    }
    for (size_t run = SORT_RUN; run < count; run *= 2)
        for (size_t first = 0; first + run < count; first += 2 * run) {
            const size_t rest = count - first - run;
            sort_merge(&job, at + first * size, run, rest < run ? rest : run);
        }
}
