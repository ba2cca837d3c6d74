/*
 * test_board.c: the cutting table: read and written it is the pattern that it was; drawing, finding, failing.
 */
#include "pattern/garments.h"
#include "pattern/gluing.h"
#include "pattern/same.h"
#include "pattern/table.h"


START_TEST(a_pattern_read_and_written_is_the_same)
{
    mus_context *context = support_context();
    sample s = sample_make(context);
    table_there_and_back(s.pattern, "sample");
    mus_pattern_destroy(s.pattern);
    for (size_t i = 0; i < sizeof garments / sizeof garments[0]; i++) {
        for (uint64_t seed = 0; seed < 4; seed++) {
            mus_pattern *pattern = gluing_make(context, garments[i].panels, garments[i].seams, seed);
            table_there_and_back(pattern, garments[i].name);
            mus_pattern_destroy(pattern);
        }
    }
    support_context_end(context);
}
END_TEST


Suite *mus_suite_board(void);
Suite *mus_suite_board(void)
{
    Suite *suite = suite_create("board");
    TCase *tcase = tcase_create("board");
    tcase_add_test(tcase, a_pattern_read_and_written_is_the_same);
    suite_add_tcase(suite, tcase);
    return suite;
}
