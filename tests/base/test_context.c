/*
 * test_context.c: the context's claims: every byte goes through the hook and comes back, a refused byte is a status,
 * the error text is the last one, objects of the library find what they need when memory ends.
 */
#include "support.h"

#include <string.h>

#include "base/base_internal.h"


START_TEST(every_byte_comes_back)
{
    mus_context *context = support_context();
    void *a = mus__new(context, 10, 8);
    void *b = mus__new(context, 0, 8);
    void *c = mus__new(context, 14, 1);
    ck_assert_ptr_nonnull(a);
    ck_assert_ptr_nonnull(b);
    ck_assert_ptr_nonnull(c);
    ck_assert_uint_ge(mus_context_bytes(context), 80 + 14);
    ck_assert_uint_eq(mus_context_allocations(context), 3);
    mus__free(context, b);
    mus__free(context, a);
    mus__free(context, c);
    mus__free(context, NULL);
    ck_assert_uint_eq(mus_context_bytes(context), 0);
    support_context_end(context);
    ck_assert_uint_eq(support_live_bytes(), 0);
}
END_TEST


START_TEST(new_memory_is_zero_and_aligned)
{
    mus_context *context = support_context();
    for (int64_t n = 1; n < 200; n += 13) {
        unsigned char *block = mus__new(context, n, 3);
        ck_assert_uint_eq((uintptr_t)block % 16, 0);
        for (int64_t i = 0; i < 3 * n; i++) ck_assert_uint_eq(block[i], 0);
        memset(block, 0xff, (size_t)(3 * n));
        mus__free(context, block);
    }
    support_context_end(context);
}
END_TEST


START_TEST(sizes_that_overflow_are_refused)
{
    mus_context *context = support_context();
    ck_assert_ptr_null(mus__new(context, INT64_MAX, 8));
    ck_assert_ptr_null(mus__new(context, -1, 8));
    ck_assert_ptr_null(mus__new(context, 1, SIZE_MAX));
    ck_assert_ptr_null(mus__new(context, 1, SIZE_MAX / 2));
    ck_assert_ptr_null(mus__new(context, 4, 0));
    ck_assert_ptr_null(mus_context_alloc(context, NULL, SIZE_MAX));
    ck_assert_uint_eq(mus_context_bytes(context), 0);

    int32_t capacity = 0;
    void *array = NULL;
    ck_assert_int_eq(mus__reserve(context, &array, &capacity, (int64_t)INT32_MAX + 1, 4), MUS_ERR_LIMIT);
    ck_assert_ptr_null(array);
    ck_assert_int_eq(capacity, 0);
    support_context_end(context);
}
END_TEST


START_TEST(growing_keeps_what_was_there)
{
    mus_context *context = support_context();
    int32_t *array = NULL, capacity = 0;
    for (int32_t i = 0; i < 1000; i++) {
        ck_assert_int_eq(mus__reserve(context, &array, &capacity, i + 1, sizeof *array), MUS_OK);
        ck_assert_int_eq(array[i], 0);
        array[i] = i;
    }
    for (int32_t i = 0; i < 1000; i++) ck_assert_int_eq(array[i], i);

    /* memory ends: the old array is whole, and the text says so */
    support_fail_after(0, true);
    int32_t before = capacity;
    ck_assert_int_eq(mus__reserve(context, &array, &capacity, capacity + 1, sizeof *array), MUS_ERR_MEMORY);
    support_fail_never();
    ck_assert_int_eq(capacity, before);
    ck_assert_int_eq(array[999], 999);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "memory"));
    mus__free(context, array);
    support_context_end(context);
}
END_TEST


START_TEST(public_memory_behaves_like_realloc)
{
    mus_context *context = support_context();
    char *text = mus_context_alloc(context, NULL, 4);
    memcpy(text, "hem", 4);
    text = mus_context_alloc(context, text, 4000);
    ck_assert_str_eq(text, "hem");
    for (size_t i = 4; i < 4000; i++) ck_assert_int_eq(text[i], 0);
    text = mus_context_alloc(context, text, 3);
    ck_assert_int_eq(memcmp(text, "hem", 3), 0);

    support_fail_after(0, false);
    ck_assert_ptr_null(mus_context_alloc(context, text, 100));
    ck_assert_int_eq(memcmp(text, "hem", 3), 0);
    ck_assert_ptr_null(mus_context_alloc(context, text, 0));
    ck_assert_ptr_null(mus_context_alloc(NULL, NULL, 8));
    ck_assert_uint_eq(mus_context_bytes(context), 0);
    support_context_end(context);
}
END_TEST


START_TEST(no_memory_for_the_context_is_a_status)
{
    mus_context_def def;
    mus_context_def_init(&def, sizeof def);
    mus_context *usual = support_context();
    support_fail_after(0, false);

    /* the hook of the usual context, borrowed: the first thing it is asked for is the context itself */
    def.alloc = usual->def.alloc;
    mus_context *context = usual;
    ck_assert_int_eq(mus_context_create(&def, &context), MUS_ERR_MEMORY);
    ck_assert_ptr_null(context);
    ck_assert_int_eq(support_refused(), 1);
    support_context_end(usual);
    ck_assert_uint_eq(support_live_bytes(), 0);
}
END_TEST


START_TEST(a_def_of_an_unknown_size_is_refused)
{
    mus_context_def def;
    mus_context *context = (mus_context *)&def;
    mus_context_def_init(&def, sizeof def);
    def.size = 0;
    ck_assert_int_eq(mus_context_create(&def, &context), MUS_ERR_VERSION);
    ck_assert_ptr_null(context);
    def.size = sizeof def + 8;
    ck_assert_int_eq(mus_context_create(&def, &context), MUS_ERR_VERSION);
    ck_assert_int_eq(mus_context_create(&def, NULL), MUS_ERR_ARG);

    /* the default context needs no def, and its functions take NULL */
    ck_assert_int_eq(mus_context_create(NULL, &context), MUS_OK);
    mus_context_destroy(context);
    mus_context_destroy(NULL);
    ck_assert_str_eq(mus_context_error(NULL), "");
    ck_assert_uint_eq(mus_context_bytes(NULL), 0);
    ck_assert_uint_eq(mus_context_allocations(NULL), 0);
    mus_context_log(NULL, MUS_LOG_INFO, "nobody hears");
}
END_TEST


START_TEST(shorter_defs_of_older_releases_keep_the_defaults)
{
    mus_context *context = support_context();
    struct { size_t size; double a, b; } own = {sizeof own, 1, 2}, given = {sizeof own - sizeof(double), 7, 8};
    ck_assert_int_eq(mus__def_read(context, &own, sizeof own, 16, &given, "thing"), MUS_OK);
    ck_assert_uint_eq(own.size, sizeof own);
    ck_assert_double_eq(own.a, 7);
    ck_assert_double_eq(own.b, 2);

    given.size = sizeof own + 1;
    ck_assert_int_eq(mus__def_read(context, &own, sizeof own, 16, &given, "thing"), MUS_ERR_VERSION);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "thing"));
    given.size = 15;
    ck_assert_int_eq(mus__def_read(context, &own, sizeof own, 16, &given, "thing"), MUS_ERR_VERSION);
    ck_assert_double_eq(own.a, 7);
    ck_assert_int_eq(mus__def_read(context, &own, sizeof own, 16, NULL, "thing"), MUS_OK);
    support_context_end(context);
}
END_TEST


START_TEST(the_error_text_is_the_last_failure)
{
    mus_context *context = support_context();
    ck_assert_str_eq(mus_context_error(context), "");
    ck_assert_int_eq(mus__fail(context, MUS_ERR_TAPE, "%s %g cm", "waist", 76.5), MUS_ERR_TAPE);
    ck_assert_str_eq(mus_context_error(context), "waist 76.5 cm");

    /* the old text may be an argument of the new one */
    mus__fail(context, MUS_ERR_BODY, "body: %s", mus_context_error(context));
    ck_assert_str_eq(mus_context_error(context), "body: waist 76.5 cm");
    ck_assert_int_eq(mus_context_fail(context, MUS_ERR_FILE, NULL), MUS_ERR_FILE);
    ck_assert_str_eq(mus_context_error(context), mus_status_text(MUS_ERR_FILE));
    ck_assert_int_eq(mus_context_fail(NULL, MUS_ERR_FILE, "x"), MUS_ERR_FILE);

    /* a long text is cut, never run over */
    char text[2 * MUS_ERROR_BYTES];
    memset(text, 'x', sizeof text);
    text[sizeof text - 1] = '\0';
    mus_context_fail(context, MUS_ERR_ARG, text);
    ck_assert_uint_eq(strlen(mus_context_error(context)), MUS_ERROR_BYTES - 1);
    support_context_end(context);
}
END_TEST


START_TEST(log_lines_reach_the_hook)
{
    mus_context *context = support_context();
    mus__log(context, MUS_LOG_INFO, "%d panels", 4);
    ck_assert_str_eq(support_log(), "4 panels");
    mus_context_log(context, MUS_LOG_WARNING, "100% cotton %s");
    ck_assert_str_eq(support_log(), "100% cotton %s");
    support_context_end(context);

    mus_context *silent;
    ck_assert_int_eq(mus_context_create(NULL, &silent), MUS_OK);
    mus__log(silent, MUS_LOG_INFO, "nobody hears");
    mus_context_destroy(silent);
    ck_assert_str_eq(support_log(), "100% cotton %s");
}
END_TEST


Suite *mus_suite_context(void);
Suite *mus_suite_context(void)
{
    Suite *suite = suite_create("context");
    TCase *tests = tcase_create("context");
    tcase_add_test(tests, every_byte_comes_back);
    tcase_add_test(tests, new_memory_is_zero_and_aligned);
    tcase_add_test(tests, sizes_that_overflow_are_refused);
    tcase_add_test(tests, growing_keeps_what_was_there);
    tcase_add_test(tests, public_memory_behaves_like_realloc);
    tcase_add_test(tests, no_memory_for_the_context_is_a_status);
    tcase_add_test(tests, a_def_of_an_unknown_size_is_refused);
    tcase_add_test(tests, shorter_defs_of_older_releases_keep_the_defaults);
    tcase_add_test(tests, the_error_text_is_the_last_failure);
    tcase_add_test(tests, log_lines_reach_the_hook);
    suite_add_tcase(suite, tests);
    return suite;
}
