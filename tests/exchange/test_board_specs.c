/*
 * test_board_specs.c: all 139 GarmentCode specifications laid on the cutting table (pattern/board.h) and written again.
 */
#include <stdio.h>

#include "muslin/exchange.h"
#include "board/table.h"


START_TEST(all_real_specifications_read_and_written_are_the_same)
{
    char path[512], relative[256], file[128];
    if (support_data("garmentcode/facts.csv", path, sizeof path) == NULL) return;
    mus_context *context = support_context();
    char *text = support_slurp(path, NULL);
    int files = 0;
    for (char *line = strchr(text, '\n') + 1; *line != '\0'; line = strchr(line, '\n') + 1, files++) {
        ck_assert_int_eq(sscanf(line, "%127[^,]", file), 1);
        const bool sampled = file[0] == 'd' && file[1] >= '0' && file[1] <= '9';
        snprintf(relative, sizeof relative, "garmentcode/%s/%s", sampled ? "specs" : "originals", file);
        ck_assert_ptr_nonnull(support_data(relative, path, sizeof path));
        mus_pattern *pattern;
        ck_assert_int_eq(mus_pattern_read(context, path, &pattern), MUS_OK);
        table_there_and_back(pattern, file);
        mus_pattern_destroy(pattern);
    }
    ck_assert_int_eq(files, 139);
    free(text);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_board_specs(void);
Suite *mus_suite_board_specs(void)
{
    Suite *suite = suite_create("board_specs");
    TCase *tcase = tcase_create("board_specs");
    tcase_set_timeout(tcase, 60);
    tcase_add_test(tcase, all_real_specifications_read_and_written_are_the_same);
    suite_add_tcase(suite, tcase);
    return suite;
}
