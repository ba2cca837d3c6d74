/*
 * test_plt.c: the HPGL of a sheet: its lines are those of the sheet at 40 units a millimetre, in the wanted order.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "muslin/print.h"
#include "print/sample_patterns.h"
#include "support.h"

static mus_context *context;
static mus_pattern *pattern;
static mus_sheet *sheet;


static void setup(void)
{
    mus_sheet_def def;
    mus_sheet_def_init(&def, sizeof def);
    def.paper = MUS_PAPER_ROLL;
    context = support_context();
    pattern = sample_shirt(context);
    ck_assert_int_eq(mus_sheet_create(context, pattern, &def, &sheet), MUS_OK);
}


static void teardown(void)
{
    mus_sheet_destroy(sheet);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}


static char *written(const mus_sheet_plt *def)
{
    char *bytes;
    size_t size;
    ck_assert_int_eq(mus_sheet_write_plt_bytes(sheet, def, &bytes, &size), MUS_OK);
    char *text = malloc(size + 1);
    memcpy(text, bytes, size);
    text[size] = '\0';
    mus_context_alloc(context, bytes, 0);
    return text;
}


/* length drawn with the pen down [m], and the box of all places */
static double drawn(const char *text, long *box)
{
    double length = 0.0;
    long x = 0, y = 0, u, v;
    box[0] = box[1] = 1L << 40;
    box[2] = box[3] = -box[0];
    for (; *text != '\0'; text++) {
        if (text[0] != 'P' || (text[1] != 'U' && text[1] != 'D') || sscanf(text + 2, "%ld,%ld", &u, &v) != 2) continue;
        if (text[1] == 'D') length += 2.5e-5 * hypot((double)(u - x), (double)(v - y));
        x = u;
        y = v;
        box[0] = x < box[0] ? x : box[0];
        box[1] = y < box[1] ? y : box[1];
        box[2] = x > box[2] ? x : box[2];
        box[3] = y > box[3] ? y : box[3];
    }
    return length;
}


START_TEST(the_plot_has_the_size_of_the_pieces)
{
    mus_sheet_plt def;
    mus_sheet_plt_init(&def, sizeof def);
    def.by_piece = 1;
    char *text = written(&def);
    long box[4];
    drawn(text, box);
    double low[2] = {1e9, 1e9}, high[2] = {-1e9, -1e9};
    for (int32_t i = 0; i < mus_sheet_piece_count(sheet); i++) {
        mus_sheet_piece piece;
        mus_sheet_piece_init(&piece, sizeof piece);
        ck_assert_int_eq(mus_sheet_piece_get(sheet, i, &piece), MUS_OK);
        for (int32_t k = 0; k < 2; k++) {
            low[k] = fmin(low[k], piece.box[k]);
            high[k] = fmax(high[k], piece.box[2 + k]);
        }
    }
    /* x of the plot is y of the sheet; one unit is 0.025 mm */
    ck_assert_double_eq_tol(2.5e-5 * (double)(box[2] - box[0]), high[1] - low[1], 2.6e-5);
    ck_assert_double_eq_tol(2.5e-5 * (double)(box[3] - box[1]), high[0] - low[0], 2.6e-5);
    free(text);
}
END_TEST


START_TEST(a_cutter_gets_the_cut_line_of_each_piece_last_and_no_letters)
{
    mus_sheet_plt def;
    mus_sheet_plt_init(&def, sizeof def);
    def.by_piece = 1;
    def.hpgl2 = 0;
    char *cut = written(&def);
    def.by_piece = 0;
    char *plot = written(&def);
    long box[4];
    ck_assert_ptr_null(strstr(cut, "SP4;"));
    ck_assert_ptr_null(strstr(cut, "SP2;"));
    ck_assert_ptr_nonnull(strstr(plot, "SP4;"));
    ck_assert_ptr_null(strstr(plot, "PS"));
    ck_assert_double_gt(drawn(plot, box), drawn(cut, box));
    ck_assert_int_eq(strncmp(cut, "IN;\nSP3;", 8), 0); /* the marks of the first piece, inside it */
    free(cut);
    free(plot);
}
END_TEST


START_TEST(one_pen_and_refusals)
{
    mus_sheet_plt def;
    char *bytes;
    size_t size;
    mus_sheet_plt_init(&def, sizeof def);
    def.one_pen = 1;
    char *text = written(&def);
    ck_assert_ptr_nonnull(strstr(text, "SP1;"));
    ck_assert_ptr_null(strstr(text, "SP2;"));
    ck_assert_ptr_nonnull(strstr(text, "LT2;"));
    free(text);
    def.size = 1;
    ck_assert_int_eq(mus_sheet_write_plt_bytes(sheet, &def, &bytes, &size), MUS_ERR_VERSION);
    ck_assert_int_eq(mus_sheet_write_plt(sheet, NULL, "/no/such/folder/a.plt"), MUS_ERR_FILE);
    ck_assert_int_eq(mus_sheet_write_plt(NULL, NULL, "x"), MUS_ERR_ARG);
    support_fail_after(0, true);
    ck_assert_int_eq(mus_sheet_write_plt_bytes(sheet, NULL, &bytes, &size), MUS_ERR_MEMORY);
    support_fail_never();
    ck_assert_ptr_null(bytes);
}
END_TEST


Suite *mus_suite_plt(void);

Suite *mus_suite_plt(void)
{
    Suite *suite = suite_create("plt");
    TCase *tests = tcase_create("plt");
    tcase_add_checked_fixture(tests, setup, teardown);
    tcase_add_test(tests, the_plot_has_the_size_of_the_pieces);
    tcase_add_test(tests, a_cutter_gets_the_cut_line_of_each_piece_last_and_no_letters);
    tcase_add_test(tests, one_pen_and_refusals);
    suite_add_tcase(suite, tests);
    return suite;
}
