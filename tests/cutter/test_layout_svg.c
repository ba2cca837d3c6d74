/* test_layout_svg.c: the drawing of a layout: a group for each piece, its outline at true scale. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "muslin/print.h"
#include "print/sample_patterns.h"
#include "support.h"

Suite *mus_suite_layout_svg(void);


static mus_layout *sample(mus_context *context, int32_t fold)
{
    mus_pattern *pattern = sample_shirt(context);
    mus_layout *layout = NULL;
    mus_layout_def def;
    mus_layout_def_init(&def, sizeof def);
    def.fold = fold, def.steps = 1000000;
    ck_assert_int_eq(mus_layout_create(context, pattern, &def, &layout), MUS_OK);
    mus_pattern_destroy(pattern);
    return layout;
}


static char *written(mus_context *context, const mus_layout *layout)
{
    char *bytes;
    size_t size;
    ck_assert_int_eq(mus_layout_write_svg_bytes(layout, &bytes, &size), MUS_OK);
    char *text = malloc(size + 1);
    memcpy(text, bytes, size);
    text[size] = '\0';
    mus_context_alloc(context, bytes, 0);
    return text;
}


START_TEST(each_piece_is_a_group_with_its_outline)
{
    mus_context *context = support_context();
    mus_layout *layout = sample(context, _i);
    char *text = written(context, layout), *at = text;
    int32_t groups = 0;
    double width = 0.0;
    ck_assert_int_eq(sscanf(strstr(text, "width=\""), "width=\"%lfmm", &width), 1);
    ck_assert(width > 1e3 * mus_layout_length(layout) && width < 1e3 * mus_layout_length(layout) + 100.0);
    ck_assert(_i == 0 || strstr(text, ">fold</text>") != NULL);
    while ((at = strstr(at + 1, "<g>\n<title>")) != NULL) {
        mus_layout_piece piece;
        mus_layout_piece_init(&piece, sizeof piece);
        ck_assert_int_eq(mus_layout_piece_get(layout, groups++, &piece), MUS_OK);
        ck_assert_int_eq(strncmp(at + 11, piece.name, strlen(piece.name)), 0);
        double x, y;
        int32_t lines = 0;
        const char *path = strstr(at, "d=\"M"), *end = strstr(path, "Z\"");
        ck_assert_int_eq(sscanf(path, "d=\"M%lf,%lf", &x, &y), 2);
        ck_assert(x - 40.0 > 1e3 * piece.xy[0] - 1e-3 && x - 40.0 < 1e3 * piece.xy[0] + 1e-3);
        for (const char *c = path; c < end; c++) lines += *c == 'L';
        ck_assert_int_eq(lines, piece.n - 1);
    }
    ck_assert_int_eq(groups, mus_layout_piece_count(layout));
    char *again = written(context, layout);
    ck_assert_str_eq(text, again);
    free(text);
    free(again);
    mus_layout_destroy(layout);
    support_context_end(context);
}
END_TEST


START_TEST(a_file_has_the_same_bytes)
{
    mus_context *context = support_context();
    mus_layout *layout = sample(context, 1);
    char path[1024], *text = written(context, layout);
    size_t size;
    support_scratch("cloth.svg", path, sizeof path);
    ck_assert_int_eq(mus_layout_write_svg(layout, path), MUS_OK);
    char *file = support_slurp(path, &size);
    ck_assert_str_eq(text, file);
    ck_assert_int_eq(mus_layout_write_svg(layout, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_layout_write_svg(NULL, path), MUS_ERR_ARG);
    ck_assert_int_eq(mus_layout_write_svg(layout, "/nowhere/cloth.svg"), MUS_ERR_FILE);
    free(text);
    free(file);
    mus_layout_destroy(layout);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_layout_svg(void)
{
    Suite *suite = suite_create("layout_svg");
    TCase *tests = tcase_create("layout_svg");
    tcase_add_loop_test(tests, each_piece_is_a_group_with_its_outline, 0, 2);
    tcase_add_test(tests, a_file_has_the_same_bytes);
    suite_add_tcase(suite, tests);
    return suite;
}
