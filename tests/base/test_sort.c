/*
 * test_sort.c: the own sort gives ascending order, keeps equal elements in order, and moves whole elements.
 */
#include "support.h"

#include <stdlib.h>
#include <string.h>

#include "base/sort.h"


static int by_first(const void *a, const void *b)
{
    const int l = *(const int *)a, r = *(const int *)b;
    return (l > r) - (l < r);
}


/* elements of `wide` ints: key, place at the start, and copies of the place */
static void check(uint32_t *state, int count, int wide, uint32_t keys)
{
    int *list = malloc(sizeof *list * (size_t)wide * (size_t)(count + 1));
    for (int i = 0; i < count; i++) {
        *state = *state * 1664525u + 1013904223u;
        list[i * wide] = (int)((*state >> 8) % keys);
        for (int k = 1; k < wide; k++) list[i * wide + k] = i;
    }
    mus__sort(list, (size_t)count, sizeof *list * (size_t)wide, by_first);
    for (int i = 0; i < count; i++) {
        const int *at = list + i * wide;
        for (int k = 2; k < wide; k++) ck_assert_int_eq(at[k], at[1]);
        if (i == 0) continue;
        ck_assert_int_le(at[-wide], at[0]);
        if (at[-wide] == at[0]) ck_assert_int_lt(at[1 - wide], at[1]);
    }
    free(list);
}


START_TEST(sorts_and_keeps_the_order_of_equals)
{
    static const int counts[] = {0, 1, 2, 3, 7, 8, 9, 17, 64, 100, 257, 1000, 5000};
    static const int wides[] = {2, 3, 40};
    uint32_t state = 1;
    for (size_t n = 0; n < sizeof counts / sizeof counts[0]; n++)
        for (int w = 0; w < 3; w++)
            for (uint32_t keys = 1; keys <= 100000; keys *= 100) check(&state, counts[n], wides[w], keys);
}
END_TEST


/* an element that the buffer on the stack does not hold is moved in parts */
START_TEST(sorts_elements_of_any_size)
{
    uint32_t state = 7;
    check(&state, 300, 1500, 50);
}
END_TEST


Suite *mus_suite_sort(void);
Suite *mus_suite_sort(void)
{
    Suite *suite = suite_create("sort");
    TCase *tcase = tcase_create("sort");
    tcase_add_test(tcase, sorts_and_keeps_the_order_of_equals);
    tcase_add_test(tcase, sorts_elements_of_any_size);
    suite_add_tcase(suite, tcase);
    return suite;
}
