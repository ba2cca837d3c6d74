/*
 * test_smith_normal_form.c: invariant factors of random integer matrices against their definition: the product of the
 * first k is the greatest common divisor of all k x k minors.
 */
#include <string.h>

#include "support.h"
#include "topology/homology.h"

#define MOST 5


static int64_t gcd(int64_t a, int64_t b)
{
    a = a < 0 ? -a : a, b = b < 0 ? -b : b;
    while (b != 0) {
        int64_t rest = a % b;
        a = b, b = rest;
    }
    return a;
}


/* determinant of the rows and columns picked by bits, by expansion along the first row */
static int64_t minor_of(int32_t m[MOST][MOST], uint32_t rows, uint32_t columns)
{
    if (rows == 0) return 1;
    int32_t r = 0;
    while (!(rows >> r & 1)) r++;
    int64_t sum = 0, sign = 1;
    for (int32_t c = 0; c < MOST; c++) {
        if (!(columns >> c & 1)) continue;
        if (m[r][c] != 0) sum += sign * m[r][c] * minor_of(m, rows & ~(1u << r), columns & ~(1u << c));
        sign = -sign;
    }
    return sum;
}


static int32_t bits(uint32_t set)
{
    int32_t n = 0;
    for (; set != 0; set &= set - 1) n++;
    return n;
}


START_TEST(products_of_factors_are_gcds_of_minors)
{
    uint64_t state = 1861;
    for (int32_t sample = 0; sample < 2000; sample++) {
        int32_t rows = 1 + (int32_t)(support_random(&state) % MOST),
                columns = 1 + (int32_t)(support_random(&state) % MOST);
        int32_t most = sample % 3 == 0 ? 1 : sample % 3 == 1 ? 3 : 12, m[MOST][MOST] = {{0}};
        int32_t entry[2 * MOST * MOST][3], n = 0;
        for (int32_t i = 0; i < rows; i++)
            for (int32_t j = 0; j < columns; j++) {
                if (support_random(&state) % 3 == 0) continue;
                m[i][j] = (int32_t)(support_random(&state) % (uint64_t)(2 * most + 1)) - most;

                /* in one entry or two that are summed */
                int32_t part = support_random(&state) % 2 == 0 ? 0 : 5;
                int32_t both[2][3] = {{i, j, m[i][j] - part}, {i, j, part}};
                memcpy(entry[n], both, sizeof both);
                n += part == 0 ? 1 : 2;
            }

        mus_context *context = support_context();
        int32_t rank, factor[MOST];
        ck_assert_int_eq(mus__smith(context, rows, n, entry[0], &rank, factor), MUS_OK);
        int64_t product = 1;
        for (int32_t k = 1; k <= MOST; k++) {
            int64_t divisor = 0;
            for (uint32_t r = 0; r < 1u << rows; r++)
                for (uint32_t c = 0; c < 1u << columns && bits(r) == k; c++)
                    if (bits(c) == k) divisor = gcd(divisor, minor_of(m, r, c));
            if (k <= rank) product *= factor[k - 1];
            ck_assert_int_eq(divisor, k <= rank ? product : 0);
            if (k < rank) ck_assert_int_eq(factor[k] % factor[k - 1], 0);
        }
        support_context_end(context);
    }
}
END_TEST


START_TEST(factors_beyond_32_bits_are_refused)
{
    /* diag(2^31 - 1, 2^31 - 2) has the factors 1 and their product */
    mus_context *context = support_context();
    int32_t entry[2][3] = {{0, 0, 2147483647}, {1, 1, 2147483646}}, rank, factor[2];
    ck_assert_int_eq(mus__smith(context, 2, 2, entry[0], &rank, factor), MUS_ERR_LIMIT);
    ck_assert_str_eq(mus_context_error(context),
                     "homology: a torsion coefficient of 4611686011984936962 is beyond 2^31");
    ck_assert_int_eq(mus__smith(context, 2, 1, entry[0], &rank, factor), MUS_OK);
    ck_assert(rank == 1 && factor[0] == 2147483647);
    support_context_end(context);
}
END_TEST


START_TEST(failing_allocations_leave_nothing)
{
    int32_t entry[6][3] = {{0, 0, 2}, {0, 1, 4}, {1, 0, 6}, {1, 1, 3}, {2, 1, 1}, {2, 2, 5}}, rank, factor[3];
    for (int64_t n = 0;; n++) {
        mus_context *context = support_context();
        support_fail_after(n, false);
        mus_status status = mus__smith(context, 3, 6, entry[0], &rank, factor);
        support_fail_never();
        support_context_end(context);
        if (status == MUS_OK) break;
        ck_assert_int_eq(status, MUS_ERR_MEMORY);
    }
    ck_assert(rank == 3 && factor[0] == 1);
}
END_TEST


Suite *mus_suite_smith_normal_form(void);


Suite *mus_suite_smith_normal_form(void)
{
    Suite *suite = suite_create("smith_normal_form");
    TCase *tcase = tcase_create("smith_normal_form");
    tcase_set_timeout(tcase, 60);
    tcase_add_test(tcase, products_of_factors_are_gcds_of_minors);
    tcase_add_test(tcase, factors_beyond_32_bits_are_refused);
    tcase_add_test(tcase, failing_allocations_leave_nothing);
    suite_add_tcase(suite, tcase);
    return suite;
}
