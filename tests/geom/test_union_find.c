/*
 * test_union_find.c: union-find with and without signs against relabelling, and its roots.
 */
#include "geom/union_find.h"
#include "support.h"

#define N 40


START_TEST(classes_and_signs_agree_with_plain_relabelling)
{
    uint64_t state = 2;
    int32_t wrong = 0;
    for (int32_t sample = 0; sample < 500; sample++) {
        int32_t parent[N], sign[N], label[N], side[N];
        mus__union_start(N, parent, sign);
        for (int32_t i = 0; i < N; i++) label[i] = i, side[i] = 1;
        for (int32_t k = 0; k < 60; k++) {
            int32_t i = (int32_t)(support_random(&state) % N), j = (int32_t)(support_random(&state) % N);
            int32_t relation = support_random(&state) % 2 == 0 ? 1 : -1;
            bool fits = label[i] != label[j] || side[i] * side[j] == relation;
            ck_assert_int_eq(mus__union_join(parent, sign, i, j, relation), fits);
            if (label[i] == label[j]) continue;

            /* turn the class of j when its side does not fit, then give it the label of i */
            int32_t turn = side[i] * side[j] * relation, old = label[j];
            for (int32_t m = 0; m < N; m++) {
                if (label[m] != old) continue;
                label[m] = label[i];
                side[m] *= turn;
            }
        }
        for (int32_t i = 0; i < N; i++) {
            for (int32_t j = 0; j < N; j++) {
                int32_t a = mus__union_find(parent, sign, i), b = mus__union_find(parent, sign, j);
                wrong += (a == b) != (label[i] == label[j]) || a > i;
                wrong += a == b && sign[i] * sign[j] != side[i] * side[j];
            }
        }
        ck_assert_int_eq(wrong, 0);
    }
}
END_TEST


START_TEST(a_long_chain_is_flat_after_one_find)
{
    enum { LONG = 100000 };
    static int32_t parent[LONG], sign[LONG];
    int32_t wrong = 0;
    mus__union_start(LONG, parent, sign);
    for (int32_t i = LONG - 1; i > 0; i--) wrong += !mus__union_join(parent, sign, i, i - 1, -1);
    for (int32_t i = 0; i < LONG; i++)
        wrong += mus__union_find(parent, sign, i) != 0 || parent[i] != 0 || sign[i] != (i % 2 == 0 ? 1 : -1);
    ck_assert_int_eq(wrong, 0);
}
END_TEST


Suite *mus_suite_union_find(void);


Suite *mus_suite_union_find(void)
{
    Suite *suite = suite_create("union_find");
    TCase *tcase = tcase_create("union_find");
    tcase_add_test(tcase, classes_and_signs_agree_with_plain_relabelling);
    tcase_add_test(tcase, a_long_chain_is_flat_after_one_find);
    suite_add_tcase(suite, tcase);
    return suite;
}
