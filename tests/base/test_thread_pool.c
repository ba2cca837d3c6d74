/*
 * test_thread_pool.c: each part runs once a phase, the phases do not overlap, and what cannot be made is a status.
 */
#include "support.h"

#include <string.h>

#include "base/thread_pool.h"

#define ITEMS 1000

typedef struct work {
    int32_t phase;          /* written by the caller between phases */
    int32_t part_seen[64];  /* phase in which a part ran last */
    int32_t parts_seen[64]; /* how many parts it was told there are */
    int32_t touched[ITEMS]; /* how often an item was visited */
} work;


static void visit(void *user, int32_t part, int32_t parts)
{
    work *w = user;
    /* each part writes only what is its own: no two threads meet in a word */
    w->part_seen[part] = w->phase;
    w->parts_seen[part] = parts;
    for (int32_t i = mus__share(ITEMS, part, parts); i < mus__share(ITEMS, part + 1, parts); i++) w->touched[i]++;
}


START_TEST(every_part_runs_once_in_every_phase)
{
    static const int32_t counts[] = {1, 2, 3, 8, 64};
    mus_context *context = support_context();
    mus__pool *pool;
    work w;
    ck_assert_int_eq(mus__pool_create(context, counts[_i], &pool), MUS_OK);
    memset(&w, 0, sizeof w);
    for (w.phase = 1; w.phase <= 200; w.phase++) {
        mus__pool_run(pool, visit, &w);
        for (int32_t part = 0; part < counts[_i]; part++) {
            ck_assert_int_eq(w.part_seen[part], w.phase);
            ck_assert_int_eq(w.parts_seen[part], counts[_i]);
        }
        for (int32_t i = 0; i < ITEMS; i++) ck_assert_int_eq(w.touched[i], w.phase);
    }
    mus__pool_destroy(pool);
    support_context_end(context);
}
END_TEST


START_TEST(shares_cover_everything_once)
{
    for (int32_t parts = 1; parts <= 64; parts++) {
        ck_assert_int_eq(mus__share(INT32_MAX, 0, parts), 0);
        ck_assert_int_eq(mus__share(INT32_MAX, parts, parts), INT32_MAX);
        for (int32_t part = 0; part < parts; part++) {
            int32_t size = mus__share(ITEMS, part + 1, parts) - mus__share(ITEMS, part, parts);
            ck_assert_int_ge(size, ITEMS / parts);
            ck_assert_int_le(size, ITEMS / parts + 1);
        }
    }
}
END_TEST


START_TEST(a_running_pool_allocates_nothing)
{
    mus_context *context = support_context();
    mus__pool *pool;
    work w;
    memset(&w, 0, sizeof w);
    ck_assert_int_eq(mus__pool_create(context, 4, &pool), MUS_OK);
    int64_t before = support_allocations();
    mus__pool_run(pool, visit, &w);
    ck_assert_int_eq(support_allocations(), before);
    mus__pool_destroy(pool);
    support_context_end(context);
}
END_TEST


START_TEST(a_pool_that_was_never_run_ends)
{
    mus_context *context = support_context();
    mus__pool *pool;
    ck_assert_int_eq(mus__pool_create(context, 8, &pool), MUS_OK);
    mus__pool_destroy(pool);
    mus__pool_destroy(NULL);
    support_context_end(context);
}
END_TEST


START_TEST(what_cannot_be_made_is_a_status)
{
    mus_context *context = support_context();
    mus__pool *pool = NULL;
    ck_assert_int_eq(mus__pool_create(context, 0, &pool), MUS_ERR_ARG);
    ck_assert_int_eq(mus__pool_create(context, 65, &pool), MUS_ERR_ARG);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "65"));
    support_fail_after(0, false);
    ck_assert_int_eq(mus__pool_create(context, 2, &pool), MUS_ERR_MEMORY);
    ck_assert_ptr_null(pool);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_thread_pool(void);
Suite *mus_suite_thread_pool(void)
{
    Suite *suite = suite_create("thread_pool");
    TCase *tests = tcase_create("pool");
    tcase_add_loop_test(tests, every_part_runs_once_in_every_phase, 0, 5);
    tcase_add_test(tests, shares_cover_everything_once);
    tcase_add_test(tests, a_running_pool_allocates_nothing);
    tcase_add_test(tests, a_pool_that_was_never_run_ends);
    tcase_add_test(tests, what_cannot_be_made_is_a_status);
    suite_add_tcase(suite, tests);
    return suite;
}
