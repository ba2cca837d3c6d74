/*
 * test_pack.c: boxes on a strip: inside, apart by the gap, none lost; a known packing.
 */
#include <math.h>

#include "file/pack.h"
#include "support.h"

#define BOXES 24

START_TEST(boxes_lie_inside_the_strip_and_apart)
{
    uint64_t seed = 7;
    for (int32_t round = 0; round < 200; round++) {
        int32_t n = 1 + (int32_t)(support_random(&seed) % BOXES), work[BOXES];
        double size[2 * BOXES], at[2 * BOXES], sky[3 * (2 * BOXES + 2)], area = 0.0;
        double gap = support_uniform(&seed, 0.0, 0.02);
        for (int32_t i = 0; i < n; i++) {
            /* round numbers too: equal heights and exact fits are the hard cases */
            for (int32_t k = 0; k < 2; k++)
                size[2 * i + k] = round % 2 ? 0.1 * (double)(1 + support_random(&seed) % 5)
                                            : support_uniform(&seed, 0.01, 0.6 + 0.3 * k);
            area += size[2 * i] * size[2 * i + 1];
        }
        double high = mus__pack(n, size, 1.0, gap, at, work, sky), most = 0.0;
        ck_assert_double_ge(high, area - 1e-9);
        for (int32_t i = 0; i < n; i++) {
            ck_assert_double_ge(at[2 * i], 0.0);
            ck_assert_double_ge(at[2 * i + 1], 0.0);
            ck_assert_double_le(at[2 * i] + size[2 * i], 1.0 + 1e-8);
            most = fmax(most, at[2 * i + 1] + size[2 * i + 1]);
            for (int32_t j = 0; j < i; j++) {
                double across = fmax(at[2 * i] - at[2 * j] - size[2 * j], at[2 * j] - at[2 * i] - size[2 * i]);
                double up = fmax(at[2 * i + 1] - at[2 * j + 1] - size[2 * j + 1],
                                 at[2 * j + 1] - at[2 * i + 1] - size[2 * i + 1]);
                ck_assert_double_ge(fmax(across, up), gap - 1e-8);
            }
        }
        ck_assert_double_eq_tol(most, high, 1e-9);
    }
}
END_TEST


START_TEST(a_low_box_goes_beside_a_tall_one)
{
    /* a tall box leaves room for two low ones beside it, one upon the other */
    const double size[] = {0.4, 0.3, 0.5, 1.0, 0.4, 0.3};
    double at[6], sky[3 * 8];
    int32_t work[3];
    ck_assert_double_eq_tol(mus__pack(3, size, 1.0, 0.0, at, work, sky), 1.0, 1e-12);
    ck_assert_double_eq_tol(at[2], 0.0, 1e-12);
    ck_assert_double_eq_tol(at[0], 0.5, 1e-12);
    ck_assert_double_eq_tol(at[4], 0.5, 1e-12);
    ck_assert_double_eq_tol(fmax(at[1], at[5]), 0.3, 1e-12);
}
END_TEST


START_TEST(a_box_wider_than_the_strip_is_refused)
{
    const double size[] = {0.2, 0.2, 1.01, 0.1};
    double at[4], sky[3 * 6];
    int32_t work[2];
    ck_assert_double_lt(mus__pack(2, size, 1.0, 0.0, at, work, sky), 0.0);
}
END_TEST


Suite *mus_suite_pack(void);
Suite *mus_suite_pack(void)
{
    Suite *suite = suite_create("pack");
    TCase *test = tcase_create("pack");
    tcase_add_test(test, boxes_lie_inside_the_strip_and_apart);
    tcase_add_test(test, a_low_box_goes_beside_a_tall_one);
    tcase_add_test(test, a_box_wider_than_the_strip_is_refused);
    suite_add_tcase(suite, test);
    return suite;
}
