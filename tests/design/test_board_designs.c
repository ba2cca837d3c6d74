/*
 * test_board_designs.c: the designs of the house laid on the cutting table and written again, in three sizes.
 */
#include "block/drafts.h"
#include "board/table.h"


START_TEST(every_design_read_and_written_is_the_same)
{
    static const char *const sizes[] = {"W34", "W40", "M50", "C116"};
    mus_context *context = support_context();
    int32_t made = 0;
    for (int32_t d = 0; d < mus_design_count(); d++) {
        for (int32_t s = 0; s < 4; s++) {
            mus_tape *tape = drafts_tape(context, sizes[s]);
            mus_pattern *pattern;
            if (mus_design_draft(context, d, tape, NULL, &pattern) == MUS_OK) {
                table_there_and_back(pattern, mus_design_name(d));
                made++;
            }
            mus_pattern_destroy(pattern);
            mus_tape_destroy(tape);
        }
    }
    ck_assert_int_ge(made, 12);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_board_designs(void);
Suite *mus_suite_board_designs(void)
{
    Suite *suite = suite_create("board_designs");
    TCase *tcase = tcase_create("board_designs");
    tcase_set_timeout(tcase, 60.0);
    tcase_add_test(tcase, every_design_read_and_written_is_the_same);
    suite_add_tcase(suite, tcase);
    return suite;
}
