/*
 * test_refused_dress.c: numbers that are not finite in the options of mus_dress() are refused by name.
 */
#include "drape/scenes.h"
#include "refused.h"

Suite *mus_suite_refused_dress(void);


static mus_status try_dress(mus_context *context, const void *def, void *user)
{
    (void)user;
    mus_pattern *pattern = scene_square(context, 0.1);
    mus_drape *drape;
    const mus_status status = mus_dress(context, pattern, NULL, def, NULL, NULL, NULL, &drape);
    mus_drape_destroy(drape);
    mus_pattern_destroy(pattern);
    return status;
}


/* mus_dress_def.friction: NaN is the fabric's friction, infinity lets cloth stick, as in mus_drape_def */
START_TEST(dress_options_that_are_not_finite_are_refused_by_name)
{
    static const refused_field fields[] = {
        REFUSED(mus_dress_def, spacing, 1, false, "spacing"),
        REFUSED(mus_dress_def, seconds_most, 1, false, "seconds_most"),
    };
    mus_dress_def def;
    mus_drape_def still;
    mus_dress_def_init(&def, sizeof def);
    mus_drape_def_init(&still, sizeof still);
    still.gravity[1] = 0.0;
    def.spacing = 0.05;
    def.drape = &still;
    refused_fields(fields, sizeof fields / sizeof *fields, &def, sizeof def, try_dress, NULL);

    mus_context *context = support_context();
    def.drape = NULL;
    def.progress_seconds = NAN; /* mus_dress_def.progress_seconds */
    ck_assert_int_eq(try_dress(context, &def, NULL), MUS_ERR_ARG);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "progress_seconds"));
    def.progress_seconds = 0.1;
    def.friction = -INFINITY;
    ck_assert_int_eq(try_dress(context, &def, NULL), MUS_ERR_ARG);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "friction"));
    support_context_end(context);
}
END_TEST


Suite *mus_suite_refused_dress(void)
{
    Suite *suite = suite_create("refused_dress");
    TCase *tests = tcase_create("refused_dress");
    tcase_add_test(tests, dress_options_that_are_not_finite_are_refused_by_name);
    suite_add_tcase(suite, tests);
    return suite;
}
