/*
 * test_sheet_file.c: PDF and SVG as files: the same bytes twice, whole or not at all, groups by name.
 */
#define _POSIX_C_SOURCE 200809L
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "print/page.h"
#include "print/sample_patterns.h"
#include "support.h"

static mus_context *context;
static mus_pattern *pattern;
static mus_sheet *sheet;
static char pdf[512], svg[512];


static void setup(void)
{
    context = support_context();
    pattern = sample_shirt(context);
    ck_assert_ptr_nonnull(pattern);
    ck_assert_int_eq(mus_sheet_create(context, pattern, NULL, &sheet), MUS_OK);
    support_scratch("out.pdf", pdf, sizeof pdf);
    support_scratch("out.svg", svg, sizeof svg);
}


static void teardown(void)
{
    mus_sheet_destroy(sheet);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}


/* the file holds exactly these bytes */
static void assert_same(const char *path, const char *bytes, size_t size)
{
    size_t now;
    char *text = support_slurp(path, &now);
    ck_assert_ptr_nonnull(text);
    ck_assert_uint_eq(now, size);
    ck_assert_int_eq(memcmp(text, bytes, size), 0);
    free(text);
}


START_TEST(the_same_sheet_gives_the_same_bytes)
{
    size_t size[2];
    ck_assert_int_eq(mus_sheet_write_pdf(sheet, pdf), MUS_OK);
    ck_assert_int_eq(mus_sheet_write_svg(sheet, svg), MUS_OK);
    char *first[2] = {support_slurp(pdf, &size[0]), support_slurp(svg, &size[1])};

    /* again from a sheet made anew, in another time zone */
    setenv("TZ", "Asia/Tokyo", 1);
    mus_sheet_destroy(sheet);
    ck_assert_int_eq(mus_sheet_create(context, pattern, NULL, &sheet), MUS_OK);
    ck_assert_int_eq(mus_sheet_write_pdf(sheet, pdf), MUS_OK);
    ck_assert_int_eq(mus_sheet_write_svg(sheet, svg), MUS_OK);
    assert_same(pdf, first[0], size[0]);
    assert_same(svg, first[1], size[1]);
    ck_assert_int_eq(memcmp(first[0], "%PDF-", 5), 0);
    free(first[0]);
    free(first[1]);
}
END_TEST


START_TEST(what_cannot_be_written_leaves_a_sentence_and_no_file)
{
    char path[600];
    snprintf(path, sizeof path, "%s.missing/out.pdf", pdf);
    ck_assert_int_eq(mus_sheet_write_pdf(sheet, path), MUS_ERR_FILE);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "out.pdf"));
    ck_assert_int_eq(mus_sheet_write_svg(sheet, path), MUS_ERR_FILE);
    ck_assert_int_eq(mus_sheet_write_svg(sheet, ""), MUS_ERR_FILE);

    /* a folder in the way stays a folder, and no part is left beside it */
    ck_assert_int_eq(mkdir(pdf, 0700), 0);
    ck_assert_int_eq(mus_sheet_write_pdf(sheet, pdf), MUS_ERR_FILE);
    snprintf(path, sizeof path, "%s.part0", pdf);
    ck_assert_int_ne(access(path, F_OK), 0);
    ck_assert_int_eq(rmdir(pdf), 0);
}
END_TEST


START_TEST(a_full_device_is_a_failure_and_stays_a_device)
{
    struct stat info;
    if (stat("/dev/full", &info) != 0) return;
    ck_assert_int_eq(mus_sheet_write_svg(sheet, "/dev/full"), MUS_ERR_FILE);
    ck_assert_int_eq(mus_sheet_write_pdf(sheet, "/dev/full"), MUS_ERR_FILE);
    ck_assert_int_eq(stat("/dev/full", &info), 0);
    ck_assert(S_ISCHR(info.st_mode));
}
END_TEST


START_TEST(an_old_file_is_replaced_and_a_part_of_another_run_left_alone)
{
    char part[600], link[600];
    struct stat info;
    support_spill(svg, "old", 3);
    snprintf(part, sizeof part, "%s.part0", svg);
    support_spill(part, "another", 7);
    ck_assert_int_eq(mus_sheet_write_svg(sheet, svg), MUS_OK);
    assert_same(part, "another", 7);
    size_t size;
    char *text = support_slurp(svg, &size);
    ck_assert_uint_gt(size, 10000);

    /* through a link: the link stays, the file behind it is new */
    snprintf(link, sizeof link, "%s.link", svg);
    support_spill(svg, "old", 3);
    ck_assert_int_eq(symlink(svg, link), 0);
    ck_assert_int_eq(mus_sheet_write_svg(sheet, link), MUS_OK);
    ck_assert_int_eq(lstat(link, &info), 0);
    ck_assert(S_ISLNK(info.st_mode));
    assert_same(svg, text, size);
    free(text);
    remove(link);
    remove(part);
}
END_TEST


START_TEST(groups_carry_the_names_of_the_panels)
{
    static const char *const wanted[] = {
        "<g id=\"front\">", "<g id=\"front.cut\">", "<g id=\"front.seam\">", "<g id=\"front.notches\">",
        "<g id=\"front.grain\">", "<g id=\"front.marks\">", "<g id=\"front.label\">", "<g id=\"sleeve_left.cut\">",
        "<g id=\"neck_rib\">", "<g id=\"scale\">", "<title>Shirt für Åsa</title>"};
    size_t size;
    ck_assert_int_eq(mus_sheet_write_svg(sheet, svg), MUS_OK);
    char *text = support_slurp(svg, &size);
    for (size_t i = 0; i < sizeof wanted / sizeof wanted[0]; i++)
        ck_assert_msg(strstr(text, wanted[i]) != NULL, "%s is missing", wanted[i]);
    ck_assert_ptr_null(strstr(text, "sleeve_right"));

    /* true scale: as many millimetres as units */
    double width, height, box[4];
    const char *head = strstr(text, "width=");
    ck_assert_int_eq(sscanf(head, "width=\"%lfmm\" height=\"%lfmm\" viewBox=\"%lf %lf %lf %lf\"", &width, &height, box,
                            box + 1, box + 2, box + 3), 6);
    ck_assert_double_eq(width, box[2]);
    ck_assert_double_eq(height, box[3]);
    double extent[2];
    mus_sheet_extent(sheet, extent);
    ck_assert_double_ge(width, 1e3 * extent[0] - 1e-3);
    ck_assert_double_ge(height, 1e3 * extent[1] - 1e-3);
    free(text);
}
END_TEST


START_TEST(odd_names_stay_good_xml)
{
    static const char *const names[] = {"a<b>&\"c\"", "a_b___c_", "1 front", "scale", "Ärmel"};
    const double xy[] = {0, 0, 0.1, 0, 0.1, 0.1, 0, 0.1};
    int32_t panel, point[4], edge[4];
    const int32_t along[4] = {1, 1, 1, 1};
    mus_sheet_def def;
    mus_sheet_def_init(&def, sizeof def);
    def.title = "x < y & \x01 \xff z";
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        ck_assert_int_eq(mus_pattern_add_panel(pattern, names[i], &panel), MUS_OK);
        for (int32_t k = 0; k < 4; k++) mus_pattern_add_point(pattern, panel, xy[2 * k], xy[2 * k + 1], &point[k]);
        for (int32_t k = 0; k < 4; k++)
            mus_pattern_add_edge(pattern, &(mus_edge_def){.size = sizeof(mus_edge_def), .start = point[k],
                                                          .end = point[(k + 1) % 4]}, &edge[k]);
        ck_assert_int_eq(mus_pattern_set_outline(pattern, panel, 4, edge, along), MUS_OK);
    }
    mus_sheet_destroy(sheet);
    ck_assert_int_eq(mus_sheet_create(context, pattern, &def, &sheet), MUS_OK);
    ck_assert_int_eq(mus_sheet_write_svg(sheet, svg), MUS_OK);
    size_t size;
    char *text = support_slurp(svg, &size);
    static const char *const wanted[] = {"id=\"a_b___c_\"", "id=\"a_b___c__6\"", "id=\"_1_front\"", "id=\"scale_8\"",
                                         "id=\"___rmel\"", "<title>a&lt;b&gt;&amp;\"c\"</title>",
                                         "<title>x &lt; y &amp; ? ? z</title>"};
    for (size_t i = 0; i < sizeof wanted / sizeof wanted[0]; i++)
        ck_assert_msg(strstr(text, wanted[i]) != NULL, "%s is missing", wanted[i]);
    free(text);
}
END_TEST


Suite *mus_suite_sheet_file(void);
Suite *mus_suite_sheet_file(void)
{
    Suite *suite = suite_create("sheet_file");
    TCase *test = tcase_create("sheet_file");
    tcase_add_checked_fixture(test, setup, teardown);
    tcase_add_test(test, the_same_sheet_gives_the_same_bytes);
    tcase_add_test(test, what_cannot_be_written_leaves_a_sentence_and_no_file);
    tcase_add_test(test, a_full_device_is_a_failure_and_stays_a_device);
    tcase_add_test(test, an_old_file_is_replaced_and_a_part_of_another_run_left_alone);
    tcase_add_test(test, groups_carry_the_names_of_the_panels);
    tcase_add_test(test, odd_names_stay_good_xml);
    suite_add_tcase(suite, test);
    return suite;
}
