/*
 * test_status.c: the list of statuses, the version, and the small helpers of status.c.
 */
#include "support.h"

#include <math.h>
#include <string.h>

#include "base/base_internal.h"


START_TEST(statuses_are_numbered_once_and_have_a_sentence)
{
#define ROW(number, name, text) {number, #name, text},
    static const struct { int32_t number; const char *name, *text; } row[] = {MUS_STATUS_LIST(ROW)};
#undef ROW
    int32_t count = (int32_t)(sizeof row / sizeof row[0]);
    ck_assert_int_eq(count, MUS_STATUS_COUNT);
    for (int32_t i = 0; i < count; i++) {
        ck_assert_int_eq(row[i].number, i);
        ck_assert_int_eq(strncmp(mus_status_name(i), "MUS_", 4), 0);
        ck_assert_str_eq(mus_status_name(i) + 4, row[i].name);
        ck_assert_str_eq(mus_status_text(i), row[i].text);
        for (int32_t k = 0; k < i; k++) {
            ck_assert_str_ne(row[i].name, row[k].name);
            ck_assert_str_ne(row[i].text, row[k].text);
        }
    }
    ck_assert_str_eq(mus_status_name(-1), "MUS_ERR_UNKNOWN");
    ck_assert_str_eq(mus_status_name(MUS_STATUS_COUNT), "MUS_ERR_UNKNOWN");
    ck_assert_ptr_nonnull(mus_status_text(INT32_MIN));
}
END_TEST


START_TEST(the_library_that_runs_is_the_one_of_the_header)
{
    int32_t version[3] = {-1, -1, -1};
    mus_version(version);
    ck_assert_int_eq(version[0], MUS_VERSION_MAJOR);
    ck_assert_int_eq(version[1], MUS_VERSION_MINOR);
    ck_assert_int_eq(version[2], MUS_VERSION_PATCH);
    mus_version(NULL);
}
END_TEST


START_TEST(only_numbers_are_finite)
{
    ck_assert(mus__finite(0.0) && mus__finite(-1e308) && mus__finite(5e-324));
    ck_assert(!mus__finite((double)NAN) && !mus__finite((double)INFINITY) && !mus__finite(-(double)INFINITY));
}
END_TEST


START_TEST(a_place_beyond_the_limit_is_refused_with_item_value_and_limit)
{
    mus_context *context = support_context();
    double x[6] = {0.0, MUS__FARTHEST, -MUS__FARTHEST, 1.0, 2.0, 3.0};
    ck_assert_int_eq(mus__check_near(context, 2, 3, x, "node"), MUS_OK);
    x[4] = 1e160;
    ck_assert_int_eq(mus__check_near(context, 2, 3, x, "drape: node"), MUS_ERR_ARG);
    ck_assert_str_eq(mus_context_error(context), "drape: node 1: y is 1e+160 m, expected -1e+07 to 1e+07 m");
    ck_assert_int_eq(mus__check_near(context, 1, 2, x + 3, "point of %s", "front"), MUS_ERR_ARG);
    ck_assert_str_eq(mus_context_error(context), "point of front: y is 1e+160 m, expected -1e+07 to 1e+07 m");
    x[4] = (double)NAN;
    ck_assert_int_eq(mus__check_near(context, 3, 2, x, "node"), MUS_ERR_ARG);
    ck_assert(mus__near(4, x) && !mus__near(5, x));
    support_context_end(context);
}
END_TEST


START_TEST(the_hash_is_fnv_1a)
{
    /* test vectors of draft-eastlake-fnv, 64 bit */
    ck_assert_uint_eq(mus__hash(MUS_HASH_START, "", 0), UINT64_C(0xcbf29ce484222325));
    ck_assert_uint_eq(mus__hash(MUS_HASH_START, "a", 1), UINT64_C(0xaf63dc4c8601ec8c));
    ck_assert_uint_eq(mus__hash(MUS_HASH_START, "foobar", 6), UINT64_C(0x85944171f73967e8));
    uint64_t half = mus__hash(MUS_HASH_START, "foo", 3);
    ck_assert_uint_eq(mus__hash(half, "bar", 3), UINT64_C(0x85944171f73967e8));
}
END_TEST


Suite *mus_suite_status(void);
Suite *mus_suite_status(void)
{
    Suite *suite = suite_create("status");
    TCase *tests = tcase_create("status");
    tcase_add_test(tests, statuses_are_numbered_once_and_have_a_sentence);
    tcase_add_test(tests, the_library_that_runs_is_the_one_of_the_header);
    tcase_add_test(tests, only_numbers_are_finite);
    tcase_add_test(tests, a_place_beyond_the_limit_is_refused_with_item_value_and_limit);
    tcase_add_test(tests, the_hash_is_fnv_1a);
    suite_add_tcase(suite, tests);
    return suite;
}
