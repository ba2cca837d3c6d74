/*
 * test_sheet.c: the sheet through its public functions: options and their limits, faulty patterns, what is printed and
 * what not, failing memory.
 */
#include <math.h>
#include <string.h>

#include "print/page.h"
#include "print/sample_patterns.h"
#include "support.h"

static mus_context *context;
static mus_pattern *pattern;
static mus_sheet *sheet;
static mus_sheet_def def;


static void setup(void)
{
    context = support_context();
    pattern = sample_shirt(context);
    ck_assert_ptr_nonnull(pattern);
    mus_sheet_def_init(&def, sizeof def);
}


static void teardown(void)
{
    mus_sheet_destroy(sheet);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}


/* refused with `status` and a sentence that holds `word`; nothing is made */
static void assert_refused(mus_status status, const char *word)
{
    mus_sheet *none = (mus_sheet *)&def;
    size_t bytes = mus_context_bytes(context);
    ck_assert_int_eq(mus_sheet_create(context, pattern, &def, &none), status);
    ck_assert_ptr_null(none);
    ck_assert_msg(strstr(mus_context_error(context), word) != NULL, "no '%s' in: %s", word, mus_context_error(context));
    ck_assert_uint_eq(mus_context_bytes(context), bytes);
    mus_sheet_def_init(&def, sizeof def);
}


START_TEST(a_def_from_init_is_a_safe_sheet)
{
    ck_assert_int_eq(def.paper, MUS_PAPER_A4);
    ck_assert_double_eq(def.allowance, 0.01);
    ck_assert_double_eq(def.margin, 0.01);
    ck_assert_double_eq(def.overlap, 0.0);
    ck_assert_int_eq(mus_sheet_create(context, pattern, NULL, &sheet), MUS_OK);
    ck_assert_int_eq(mus_sheet_page_count(sheet), sheet->ntile + sheet->cover);
    ck_assert_int_ge(mus_sheet_columns(sheet) * mus_sheet_rows(sheet), sheet->ntile);
    double extent[2];
    ck_assert_int_eq(mus_sheet_extent(sheet, extent), MUS_OK);
    ck_assert_double_gt(extent[0] * extent[1], 0.7);
}
END_TEST


START_TEST(options_out_of_range_are_refused_by_name)
{
    const double bad[] = {NAN, INFINITY, -INFINITY, -1e-3, 0.101, 1e9};
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        def.allowance = bad[i];
        assert_refused(MUS_ERR_ARG, "allowance");
        def.margin = bad[i];
        assert_refused(MUS_ERR_ARG, "margin");
        def.overlap = bad[i];
        assert_refused(MUS_ERR_ARG, "overlap");
    }
    def.paper = -1;
    assert_refused(MUS_ERR_ARG, "paper -1");
    def.paper = 5;
    assert_refused(MUS_ERR_ARG, "paper 5");
    def.size = 8;
    assert_refused(MUS_ERR_VERSION, "size 8");
}
END_TEST


START_TEST(paper_smaller_than_its_margins_is_refused)
{
    def.margin = 0.1;
    assert_refused(MUS_ERR_ARG, "margin 100 mm");
    def.margin = 0.02;
    def.overlap = 0.09;
    assert_refused(MUS_ERR_ARG, "overlap of 90 mm");
    /* room to print on, but not for the test squares */
    def.margin = 0.06;
    def.overlap = 0.0;
    assert_refused(MUS_ERR_ARG, "test squares");
}
END_TEST


START_TEST(missing_arguments_are_refused)
{
    double out[4];
    ck_assert_int_eq(mus_sheet_create(NULL, pattern, NULL, &sheet), MUS_ERR_ARG);
    ck_assert_int_eq(mus_sheet_create(context, NULL, NULL, &sheet), MUS_ERR_ARG);
    ck_assert_int_eq(mus_sheet_create(context, pattern, NULL, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_sheet_extent(NULL, out), MUS_ERR_ARG);
    ck_assert_int_eq(mus_sheet_page(NULL, 0, out), MUS_ERR_ARG);
    ck_assert_int_eq(mus_sheet_page_count(NULL), 0);
    ck_assert_int_eq(mus_sheet_columns(NULL) + mus_sheet_rows(NULL), 0);
    ck_assert_int_eq(mus_sheet_write_pdf(NULL, "x"), MUS_ERR_ARG);
    ck_assert_int_eq(mus_sheet_write_svg(NULL, "x"), MUS_ERR_ARG);
    mus_sheet_destroy(NULL);

    ck_assert_int_eq(mus_sheet_create(context, pattern, NULL, &sheet), MUS_OK);
    ck_assert_int_eq(mus_sheet_write_pdf(sheet, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_sheet_extent(sheet, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_sheet_page(sheet, 1, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_sheet_page(sheet, -1, out), MUS_ERR_ARG);
    ck_assert_int_eq(mus_sheet_page(sheet, mus_sheet_page_count(sheet), out), MUS_ERR_ARG);
    for (int32_t i = 1; i < mus_sheet_page_count(sheet); i++) ck_assert_int_eq(mus_sheet_page(sheet, i, out), MUS_OK);
}
END_TEST


START_TEST(faulty_patterns_are_refused_by_panel)
{
    int32_t panel;
    ck_assert_int_eq(mus_pattern_add_panel(pattern, "unfinished", &panel), MUS_OK);
    assert_refused(MUS_ERR_PATTERN, "unfinished");

    const double bow_tie[] = {0, 0, 0.3, 0.3, 0.3, 0, 0, 0.3}, tiny[] = {0, 0, 1e-4, 0, 1e-4, 1e-4, 0, 1e-4};
    mus_pattern_destroy(pattern);
    pattern = sample_polygon(context, 4, bow_tie);
    assert_refused(MUS_ERR_PATTERN, "piece");
    mus_pattern_destroy(pattern);
    pattern = sample_polygon(context, 4, tiny);
    assert_refused(MUS_ERR_PATTERN, "piece");
    mus_pattern_destroy(pattern);
    ck_assert_int_eq(mus_pattern_create(context, "nothing", &pattern), MUS_OK);
    assert_refused(MUS_ERR_PATTERN, "nothing");
}
END_TEST


START_TEST(a_huge_pattern_is_tiled_or_refused)
{
    const double long_one[] = {0, 0, 1, 0, 1, 20, 0, 20}, vast[] = {0, 0, 900, 0, 900, 900, 0, 900};
    mus_pattern_destroy(pattern);
    pattern = sample_polygon(context, 4, long_one);
    ck_assert_int_eq(mus_sheet_create(context, pattern, &def, &sheet), MUS_OK);
    ck_assert_int_gt(mus_sheet_page_count(sheet), 250);
    mus_pattern_destroy(pattern);
    pattern = sample_polygon(context, 4, vast);
    assert_refused(MUS_ERR_LIMIT, "10000 pages");
}
END_TEST


START_TEST(mirror_images_are_not_printed)
{
    ck_assert_int_eq(mus_sheet_create(context, pattern, &def, &sheet), MUS_OK);
    ck_assert_int_eq(sheet->npiece, 4);
    ck_assert_int_eq(mus_pattern_panel_count(pattern), 5);
    for (int32_t i = 0; i < sheet->npiece; i++) ck_assert_str_ne(sheet->names[i], "sleeve_right");
}
END_TEST


START_TEST(pieces_lie_apart_inside_the_sheet)
{
    for (def.paper = MUS_PAPER_A4; def.paper <= MUS_PAPER_ROLL; def.paper++) {
        def.allowance = 0.005 * (def.paper + 1);
        mus_sheet_destroy(sheet);
        ck_assert_int_eq(mus_sheet_create(context, pattern, &def, &sheet), MUS_OK);
        for (int32_t i = 0; i < sheet->npiece; i++) {
            const double *a = sheet->pieces[i].box;
            ck_assert_double_gt(a[0], 0.0);
            ck_assert_double_gt(a[1], 0.0);
            ck_assert_double_lt(a[2], sheet->extent[0]);
            ck_assert_double_lt(a[3], sheet->extent[1]);
            /* boxes may overlap, cut lines not: each point of one is 4 mm from the other */
            for (int32_t k = 0; k < sheet->npiece; k++) {
                for (int32_t m = 0; m < sheet->pieces[i].cut.n && k != i; m++) {
                    const double *p = sheet->pieces[i].cut.xy + 2 * m;
                    const double near[4] = {p[0] - 0.0028, p[1] - 0.0028, p[0] + 0.0028, p[1] + 0.0028};
                    ck_assert(!mus__piece_meets(&sheet->pieces[k], NULL, near, NULL));
                }
            }
        }
    }
}
END_TEST


START_TEST(title_and_person_are_copied)
{
    char title[16] = "Tee", person[16] = "Ada";
    def.title = title;
    def.person = person;
    ck_assert_int_eq(mus_sheet_create(context, pattern, &def, &sheet), MUS_OK);
    title[0] = person[0] = 'X';
    ck_assert_str_eq(sheet->title, "Tee");
    ck_assert_str_eq(sheet->person, "Ada");
}
END_TEST


START_TEST(each_failing_allocation_is_reported)
{
    char pdf[512], svg[512];
    support_scratch("fail.pdf", pdf, sizeof pdf);
    support_scratch("fail.svg", svg, sizeof svg);
    size_t bytes = mus_context_bytes(context);
    int64_t n = 0;
    /* in larger steps from the 100th on: what follows are the page drawings, one like the other */
    for (;; n += n < 100 ? 1 : 41) {
        support_fail_after(n, n % 2 == 1);
        mus_status status = mus_sheet_create(context, pattern, &def, &sheet);
        if (status == MUS_OK) status = mus_sheet_write_svg(sheet, svg);
        if (status == MUS_OK) status = mus_sheet_write_pdf(sheet, pdf);
        support_fail_never();
        mus_sheet_destroy(sheet);
        sheet = NULL;
        ck_assert_uint_eq(mus_context_bytes(context), bytes);
        if (status == MUS_OK) break;
        ck_assert_int_eq(status, MUS_ERR_MEMORY);
        ck_assert_ptr_null(support_slurp(pdf, &(size_t){0}));
    }
    ck_assert_int_gt(n, 100);
}
END_TEST


Suite *mus_suite_sheet(void);
Suite *mus_suite_sheet(void)
{
    Suite *suite = suite_create("sheet");
    TCase *test = tcase_create("sheet");
    tcase_add_checked_fixture(test, setup, teardown);
    tcase_set_timeout(test, 120);
    tcase_add_test(test, a_def_from_init_is_a_safe_sheet);
    tcase_add_test(test, options_out_of_range_are_refused_by_name);
    tcase_add_test(test, paper_smaller_than_its_margins_is_refused);
    tcase_add_test(test, missing_arguments_are_refused);
    tcase_add_test(test, faulty_patterns_are_refused_by_panel);
    tcase_add_test(test, a_huge_pattern_is_tiled_or_refused);
    tcase_add_test(test, mirror_images_are_not_printed);
    tcase_add_test(test, pieces_lie_apart_inside_the_sheet);
    tcase_add_test(test, title_and_person_are_copied);
    tcase_add_test(test, each_failing_allocation_is_reported);
    suite_add_tcase(suite, test);
    return suite;
}
