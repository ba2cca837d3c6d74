/*
 * test_outside.c: measures of the written OBJ file, taken by a ruler that reads the file alone (study/outside). Those
 * that are known to be beyond their limits are left to `make outside`, which counts them apart.
 */
#include <math.h>

#include "people.h"
#include "study/outside/measure.h"


START_TEST(the_written_file_has_the_girths_of_the_tape)
{
    static const char *const sizes[] = {"W36", "W46", "M50", "M60", "C68", "C128"};
    mus_context *context = support_context();
    char path[256];
    support_scratch("body.obj", path, sizeof path);
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        mus_body *body = people_body(context, sizes[i], NULL);
        double made[OUTSIDE_ROWS];
        ck_assert_int_eq(outside_write(context, body, path), MUS_OK);
        ck_assert(outside_measure(body, path, made));
        for (int k = 0; k < OUTSIDE_ROWS; k++) {
            const outside_row *row = &outside_rows[k];
            const double asked = mus_body_asked(body, row->measure);
            if (row->known || isnan(made[k])) continue;
            ck_assert_msg(fabs(made[k] - asked) <= row->most, "%s: %s asked %.4f, in the file %.4f", sizes[i],
                          mus_measure_name(row->measure), asked, made[k]);
        }
        mus_body_destroy(body);
    }
    support_context_end(context);
}
END_TEST


Suite *mus_suite_outside(void);
Suite *mus_suite_outside(void)
{
    Suite *suite = suite_create("outside");
    TCase *tests = tcase_create("outside");
    tcase_set_timeout(tests, 60);
    if (!SUPPORT_SLOW) tcase_add_test(tests, the_written_file_has_the_girths_of_the_tape);
    suite_add_tcase(suite, tests);
    return suite;
}
