/*
 * test_dxf.c: the DXF and RUL of a sheet: layers of each dialect, names, the bytes of the file, what is refused.
 */
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
    context = support_context();
    pattern = sample_shirt(context);
    ck_assert_int_eq(mus_sheet_create(context, pattern, NULL, &sheet), MUS_OK);
}


static void teardown(void)
{
    mus_sheet_destroy(sheet);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}


/* how often an entity begins on a layer */
static int count(const char *text, const char *entity, int layer)
{
    char start[64];
    int n = 0;
    snprintf(start, sizeof start, "\n0\n%s\n8\n%d\n", entity, layer);
    for (; (text = strstr(text, start)) != NULL; text++) n++;
    return n;
}


/* the DXF as a text; the caller frees */
static char *written(const mus_sheet_dxf *def)
{
    char *bytes;
    size_t size;
    ck_assert_int_eq(mus_sheet_write_dxf_bytes(sheet, def, &bytes, &size), MUS_OK);
    char *text = malloc(size + 1);
    memcpy(text, bytes, size);
    text[size] = '\0';
    mus_context_alloc(context, bytes, 0);
    return text;
}


START_TEST(each_dialect_has_its_layers)
{
    mus_sheet_dxf def;
    mus_sheet_dxf_init(&def, sizeof def);
    def.dialect = _i;
    char *text = written(&def);
    const int astm = _i == MUS_DXF_ASTM;
    ck_assert_int_eq(count(text, "BLOCK", 1), 4); /* front, back, sleeve, rib */
    ck_assert_int_eq(count(text, "POLYLINE", 1), 4);
    ck_assert_int_eq(count(text, "POLYLINE", 84), astm ? 4 : 0);
    ck_assert_int_eq(count(text, "POLYLINE", 14), 8 + 8 + 6 + 4);
    ck_assert_int_eq(count(text, "POLYLINE", 87), astm ? 26 : 0);
    /* slits: front 1 + 1 + 3, back 2 + 2 + 3, sleeve 1 + 2 */
    ck_assert_int_eq(count(text, "LINE", 4), astm ? 0 : 15);
    ck_assert_int_eq(count(text, "POINT", 4), astm ? 15 : 0);
    ck_assert_int_eq(count(text, "LINE", 7), 4);
    ck_assert_int_eq(count(text, "POLYLINE", 8), 2);
    ck_assert_int_eq(count(text, "POINT", 13), 1);
    ck_assert_ptr_nonnull(strstr(text, "Style Name: Shirt f\\U+00FCr \\U+00C5sa"));
    ck_assert_ptr_nonnull(strstr(text, "Quantity: 1,1"));
    ck_assert_int_eq(strstr(text, "D 6673-04") != NULL, astm);
    ck_assert_ptr_null(strstr(text, "TABLES"));
    free(text);
}
END_TEST


START_TEST(the_sew_line_as_boundary_has_no_layer_14)
{
    mus_sheet_dxf def;
    mus_sheet_dxf_init(&def, sizeof def);
    def.boundary = MUS_DXF_SEW;
    char *text = written(&def);
    ck_assert_int_eq(count(text, "POLYLINE", 1), 4);
    ck_assert_int_eq(count(text, "POLYLINE", 14), 0);
    free(text);
}
END_TEST


START_TEST(sizes_are_blocks_and_rules)
{
    const mus_sheet *sheets[1] = {sheet};
    const char *names[1] = {"M 42"};
    char *bytes;
    size_t size;
    mus_sheet_dxf def;
    mus_sheet_dxf_init(&def, sizeof def);
    def.size_name = "S";
    def.nested = 1;
    def.size_count = 1;
    def.sheets = sheets;
    def.size_names = names;
    char *text = written(&def);
    ck_assert_int_eq(count(text, "BLOCK", 1), 8);
    ck_assert_ptr_nonnull(strstr(text, "FRONT_M_42"));
    ck_assert_ptr_nonnull(strstr(text, "\n# 1\n"));
    free(text);
    /* the same sheet: one rule, that nothing moves */
    ck_assert_int_eq(mus_sheet_write_rul_bytes(sheet, &def, &bytes, &size), MUS_OK);
    ck_assert_ptr_nonnull(strstr(bytes, "SAMPLE SIZE: S\r\nNUMBER OF SIZES: 2\r\nSIZE LIST: S M_42\r\n"
                                        "RULE: DELTA 1\r\n0, 0 0, 0\r\nEND\r\n"));
    mus_context_alloc(context, bytes, 0);
}
END_TEST


START_TEST(what_does_not_fit_is_refused)
{
    char *bytes;
    size_t size;
    mus_pattern *other = sample_polygon(context, 3, (const double[]){0, 0, 0.3, 0, 0, 0.3});
    mus_sheet *triangle;
    ck_assert_int_eq(mus_sheet_create(context, other, NULL, &triangle), MUS_OK);
    const mus_sheet *sheets[1] = {triangle};
    const char *names[1] = {"42"};
    mus_sheet_dxf def;
    mus_sheet_dxf_init(&def, sizeof def);
    def.size_count = 1;
    def.sheets = sheets;
    def.size_names = names;
    ck_assert_int_eq(mus_sheet_write_dxf_bytes(sheet, &def, &bytes, &size), MUS_ERR_ARG);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "size 42 has 1 pieces, the sample has 4"));
    ck_assert_ptr_null(bytes);
    def.size_count = 0;
    def.dialect = 7;
    ck_assert_int_eq(mus_sheet_write_rul_bytes(sheet, &def, &bytes, &size), MUS_ERR_ARG);
    def.size = 8;
    ck_assert_int_eq(mus_sheet_write_dxf_bytes(sheet, &def, &bytes, &size), MUS_ERR_VERSION);
    ck_assert_int_eq(mus_sheet_write_dxf(NULL, NULL, "x"), MUS_ERR_ARG);
    ck_assert_int_eq(mus_sheet_write_dxf(sheet, NULL, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_sheet_write_rul(sheet, NULL, "/no/such/folder/a.rul"), MUS_ERR_FILE);
    mus_sheet_destroy(triangle);
    mus_pattern_destroy(other);
}
END_TEST


START_TEST(no_memory_is_a_status)
{
    const mus_sheet *sheets[1] = {sheet};
    const char *names[1] = {"42"};
    mus_sheet_dxf def;
    mus_sheet_dxf_init(&def, sizeof def);
    def.size_count = 1;
    def.sheets = sheets;
    def.size_names = names;
    for (int64_t n = 0;; n++) {
        char *bytes;
        size_t size;
        support_fail_after(n, false);
        const mus_status status = mus_sheet_write_dxf_bytes(sheet, &def, &bytes, &size);
        support_fail_never();
        mus_context_alloc(context, bytes, 0);
        if (status == MUS_OK) break;
        ck_assert_int_eq(status, MUS_ERR_MEMORY);
    }
}
END_TEST


Suite *mus_suite_dxf(void);

Suite *mus_suite_dxf(void)
{
    Suite *suite = suite_create("dxf");
    TCase *tests = tcase_create("dxf");
    tcase_set_timeout(tests, 60);
    tcase_add_checked_fixture(tests, setup, teardown);
    tcase_add_loop_test(tests, each_dialect_has_its_layers, 0, 2);
    tcase_add_test(tests, the_sew_line_as_boundary_has_no_layer_14);
    tcase_add_test(tests, sizes_are_blocks_and_rules);
    tcase_add_test(tests, what_does_not_fit_is_refused);
    tcase_add_test(tests, no_memory_is_a_status);
    suite_add_tcase(suite, tests);
    return suite;
}
