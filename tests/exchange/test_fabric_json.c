/*
 * test_fabric_json.c: fabric files: what was written comes back bit for bit under any locale; the example is a named
 * fabric; what is wrong is refused with file, line and name.
 */
#define _POSIX_C_SOURCE 200809L
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "comma_locale.h"
#include "muslin/exchange.h"
#include "support.h"

/* a good file, a value a line from line 3 on, with room to spoil one */
static const char *const lines[] = {
    "{\"muslin_fabric\": 1,",
    " \"name\": \"gauze\",",
    " \"weight_kg_per_m2\": {\"value\": 0.05, \"source\": \"scale\"},",
    " \"stretch_warp_N_per_m\": {\"value\": 2e3, \"source\": \"assumed\"},",
    " \"stretch_weft_N_per_m\": {\"value\": 1000, \"source\": \"assumed\"},",
    " \"shear_N_per_m\": {\"value\": 20, \"source\": \"assumed\"},",
    " \"bend_warp_N_m\": {\"value\": 1e-6, \"source\": \"\\\"a, {board}\\\"\"},",
    " \"bend_weft_N_m\": {\"value\": 1.5e-6, \"source\": \"board\"},",
    " \"bend_bias_N_m\": {\"value\": 1.25e-6, \"source\": \"board\"},",
    " \"damping_ratio\": {\"value\": 0.1, \"source\": \"assumed\"},",
    " \"friction_coefficient\": {\"value\": 0.3, \"source\": \"assumed\"},",
    " \"thickness_m\": {\"value\": 0.0002, \"source\": \"gauge\"}",
    "}",
};

enum { LINES = sizeof lines / sizeof *lines };


/* read the good file with line `number` (from 1) replaced, `end` between lines */
static mus_status load_with(mus_context *context, int number, const char *line, const char *end, mus_fabric *out)
{
    char path[512], *text = malloc(3000000);
    size_t size = 0;
    for (int i = 0; i < LINES; i++)
        size += (size_t)sprintf(text + size, "%s%s", i + 1 == number ? line : lines[i], end);
    support_spill(support_scratch("gauze.json", path, sizeof path), text, size);
    free(text);
    mus_fabric_init(out, sizeof *out);
    return mus_fabric_load(context, path, out);
}


static void check_gauze(const mus_fabric *fabric)
{
    ck_assert_double_eq(fabric->weight, 0.05);
    ck_assert_double_eq(fabric->stretch[0], 2000.0);
    ck_assert_double_eq(fabric->stretch[1], 1000.0);
    ck_assert_double_eq(fabric->shear, 20.0);
    ck_assert_double_eq(fabric->bend[0], 1e-6);
    ck_assert_double_eq(fabric->bend[1], 1.5e-6);
    ck_assert_double_eq(fabric->bend[2], 1.25e-6);
    ck_assert_double_eq(fabric->damping, 0.1);
    ck_assert_double_eq(fabric->friction, 0.3);
    ck_assert_double_eq(fabric->thickness, 0.0002);
}


START_TEST(a_fabric_file_is_read_with_any_line_end_and_mark)
{
    static const char *const ends[] = {"\n", "\r\n", " ", "\n\n"};
    mus_context *context = support_context();
    mus_fabric fabric;
    for (int i = 0; i < 4; i++) {
        ck_assert_msg(load_with(context, 0, "", ends[i], &fabric) == MUS_OK, "%s", mus_context_error(context));
        check_gauze(&fabric);
    }
    ck_assert_int_eq(load_with(context, 1, "\xEF\xBB\xBF{\"muslin_fabric\": 1,", "\n", &fabric), MUS_OK);
    check_gauze(&fabric);

    /* the order of members means nothing */
    ck_assert_int_eq(load_with(context, 6, " \"shear_N_per_m\": {\"source\": \"x\", \"value\": 20},", "\n", &fabric),
                     MUS_OK);
    check_gauze(&fabric);
    support_context_end(context);
}
END_TEST


START_TEST(every_named_fabric_comes_back_bit_for_bit)
{
    comma_locale();
    mus_context *context = support_context();
    char path[512];
    support_scratch("named.json", path, sizeof path);
    for (int32_t i = 0; i < mus_fabric_count(); i++) {
        mus_fabric named, read;
        mus_fabric_init(&named, sizeof named);
        mus_fabric_init(&read, sizeof read);
        ck_assert_int_eq(mus_fabric_find(mus_fabric_name(i), &named), MUS_OK);
        named.bend[2] = 1.0 / 3.0 * 1e-5;
        ck_assert_int_eq(mus_fabric_save(context, &named, mus_fabric_name(i), NULL, path), MUS_OK);
        ck_assert_msg(mus_fabric_load(context, path, &read) == MUS_OK, "%s", mus_context_error(context));
        ck_assert_int_eq(memcmp(&named, &read, sizeof named), 0);
    }
    support_context_end(context);
}
END_TEST


START_TEST(the_example_is_denim_as_it_is_saved)
{
    mus_context *context = support_context();
    char path[512];
    size_t size, other;
    mus_fabric fabric;
    mus_fabric_init(&fabric, sizeof fabric);
    ck_assert_int_eq(mus_fabric_find("denim", &fabric), MUS_OK);
    ck_assert_int_eq(mus_fabric_save(context, &fabric, "denim", NULL, support_scratch("d.json", path, sizeof path)),
                     MUS_OK);
    char *saved = support_slurp(path, &size), *example = support_slurp("examples/fabrics/denim.json", &other);
    ck_assert_ptr_nonnull(example);
    ck_assert_str_eq(saved, example);
    free(saved);
    free(example);
    support_context_end(context);
}
END_TEST


START_TEST(what_is_wrong_is_refused_with_line_and_name)
{
    static const struct {
        int line;
        const char *text, *at, *word;
    } row[] = {
        {1, "{\"muslin_fabric\": 2,", ":1:", "\"muslin_fabric\": 1"},
        {1, "{\"muslin_pattern\": 1,", ":1:", "\"muslin_fabric\": 1"},
        {2, " \"nome\": \"gauze\",", ":2:", "\"nome\" is unknown"},
        {2, " \"name\": \"\",", ":2:", "0 bytes"},
        {2, " \"name\": 3,", ":2:", "no text \"name\""},
        {3, " ", ":13:", "no \"weight_kg_per_m2\""},
        {3, " \"weight_g_per_m2\": {\"value\": 50, \"source\": \"scale\"},", ":3:", "\"weight_g_per_m2\" is unknown"},
        {3, " \"weight_kg_per_m2\": 0.05,", ":3:", "expected {"},
        {3, " \"weight_kg_per_m2\": {\"value\": 50, \"source\": \"scale\"},",
         ":3:", "weight 50 is outside 0.001 to 10"},
        {3, " \"weight_kg_per_m2\": {\"value\": 0, \"source\": \"scale\"},", ":3:", "weight 0"},
        {3, " \"weight_kg_per_m2\": {\"value\": 1e-310, \"source\": \"scale\"},", ":3:", "weight"},
        {4, " \"stretch_warp_N_per_m\": {\"value\": 1000000000, \"source\": \"x\"},", ":4:", "warp stretch 1e+09"},
        {4, " \"stretch_warp_N_per_m\": {\"value\": 1e400, \"source\": \"x\"},", ":4:", "expected JSON"},
        {4, " \"stretch_warp_N_per_m\": {\"value\": NaN, \"source\": \"x\"},", ":4:", "expected JSON"},
        {5, " \"stretch_weft_N_per_m\": {\"value\": 1000,5, \"source\": \"x\"},", ":5:", "expected JSON"},
        {6, " \"shear_N_per_m\": {\"value\": \"20\", \"source\": \"x\"},", ":6:", "shear_N_per_m has no number"},
        {6, " \"shear_N_per_m\": {\"value\": 20},", ":6:", "shear_N_per_m has no text \"source\""},
        {6, " \"shear_N_per_m\": {\"value\": 20, \"source\": \"\"},", ":6:", "0 bytes"},
        {6, " \"shear_N_per_m\": {\"value\": 20, \"source\": \"x\", \"unit\": \"N/m\"},",
         ":6:", "shear_N_per_m: the key \"unit\" is unknown"},
        {7, " \"bend_warp_N_m\": {\n\n\"value\": -1, \"source\": \"x\"},", ":9:", "warp bend -1"},
        {8, " \"bend_warp_N_m\": {\"value\": 1, \"source\": \"x\"},", ":8:", "duplicate"},
        {10, " \"damping_ratio\": {\"value\": 1.5, \"source\": \"x\"},", ":10:", "damping 1.5"},
        {12, " \"thickness_m\": {\"value\": 0.0002, \"source\": \"gauge\"},", ":13:", "expected JSON"},
        {13, "", ":1", "expected JSON"},
        {13, "}}", ":13:", "expected JSON"},
        {1, "", ":2:", "expected JSON"},
        {1, "\xFF\xFE{", ":1:", "expected JSON"},
    };
    mus_context *context = support_context();
    mus_fabric fabric, before;
    mus_fabric_init(&before, sizeof before);
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        ck_assert_msg(load_with(context, row[i].line, row[i].text, "\n", &fabric) == MUS_ERR_FORMAT, "%s", row[i].text);
        const char *text = mus_context_error(context);
        char where[40];
        snprintf(where, sizeof where, "gauze.json%s", row[i].at);
        ck_assert_msg(strstr(text, where) != NULL && strstr(text, row[i].word) != NULL, "%s: %s", row[i].text, text);
        ck_assert_int_eq(memcmp(&fabric, &before, sizeof fabric), 0);
    }
    support_context_end(context);
}
END_TEST


START_TEST(a_line_of_a_megabyte_is_refused_in_a_sentence)
{
    mus_context *context = support_context();
    mus_fabric fabric;
    char *line = malloc(1100000);
    memset(line, 'x', 1000000);
    memcpy(line, " \"name\": \"", 10);
    strcpy(line + 1000000, "\",");
    ck_assert_int_eq(load_with(context, 2, line, "\n", &fabric), MUS_ERR_FORMAT);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), ":2: the fabric: \"name\" has 999990 bytes"));
    memcpy(line, " \"xxxxxxxx", 10);
    strcpy(line + 1000000, "\": 1,");
    ck_assert_int_eq(load_with(context, 2, line, "\n", &fabric), MUS_ERR_FORMAT);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), ":2: the key \"xxx"));
    ck_assert_uint_lt(strlen(mus_context_error(context)), 512);
    free(line);
    support_context_end(context);
}
END_TEST


START_TEST(what_cannot_be_saved_is_refused)
{
    mus_context *context = support_context();
    mus_fabric fabric;
    char path[512], huge[1200];
    const char *sources[11];
    mus_fabric_init(&fabric, sizeof fabric);
    support_scratch("none.json", path, sizeof path);
    memset(huge, 'y', sizeof huge);
    huge[sizeof huge - 1] = '\0';
    for (int i = 0; i < 11; i++) sources[i] = "assumed";
    ck_assert_int_eq(mus_fabric_save(context, &fabric, "mine", NULL, path), MUS_ERR_ARG);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "no fabric is named mine"));
    ck_assert_int_eq(mus_fabric_save(context, &fabric, "", sources, path), MUS_ERR_ARG);
    ck_assert_int_eq(mus_fabric_save(context, &fabric, "\xFFx", sources, path), MUS_ERR_ARG);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "UTF-8"));
    sources[3] = huge;
    ck_assert_int_eq(mus_fabric_save(context, &fabric, "mine", sources, path), MUS_ERR_ARG);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "shear_N_per_m has 1199 bytes"));
    sources[3] = NULL;
    ck_assert_int_eq(mus_fabric_save(context, &fabric, "mine", sources, path), MUS_ERR_ARG);
    sources[3] = "x";
    fabric.shear = (double)NAN;
    ck_assert_int_eq(mus_fabric_save(context, &fabric, "mine", sources, path), MUS_ERR_ARG);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "shear"));
    ck_assert_int_eq(mus_fabric_save(context, NULL, "mine", sources, path), MUS_ERR_ARG);
    ck_assert_int_eq(mus_fabric_save(NULL, &fabric, "mine", sources, path), MUS_ERR_ARG);
    ck_assert_int_eq(mus_fabric_load(context, NULL, &fabric), MUS_ERR_ARG);
    ck_assert_int_eq(mus_fabric_load(context, path, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_fabric_load(context, path, &fabric), MUS_ERR_FILE);
    fabric.size = 16;
    ck_assert_int_eq(mus_fabric_load(context, path, &fabric), MUS_ERR_VERSION);
    support_context_end(context);
}
END_TEST


START_TEST(without_memory_nothing_is_left)
{
    char path[512];
    support_scratch("jersey.json", path, sizeof path);
    for (int64_t n = 0;; n++) {
        mus_context *context = support_context();
        mus_fabric fabric;
        mus_fabric_init(&fabric, sizeof fabric);
        support_fail_after(n, false);
        mus_status status = mus_fabric_save(context, &fabric, "jersey", NULL, path);
        if (status == MUS_OK) status = mus_fabric_load(context, path, &fabric);
        support_fail_never();
        support_context_end(context);
        if (status == MUS_OK) break;
        ck_assert_int_eq(status, MUS_ERR_MEMORY);
    }
}
END_TEST


Suite *mus_suite_fabric_json(void);
Suite *mus_suite_fabric_json(void)
{
    Suite *suite = suite_create("fabric_json");
    TCase *tests = tcase_create("fabric_json");
    tcase_set_timeout(tests, 30.0);
    tcase_add_test(tests, a_fabric_file_is_read_with_any_line_end_and_mark);
    tcase_add_test(tests, every_named_fabric_comes_back_bit_for_bit);
    tcase_add_test(tests, the_example_is_denim_as_it_is_saved);
    tcase_add_test(tests, what_is_wrong_is_refused_with_line_and_name);
    tcase_add_test(tests, a_line_of_a_megabyte_is_refused_in_a_sentence);
    tcase_add_test(tests, what_cannot_be_saved_is_refused);
    tcase_add_test(tests, without_memory_nothing_is_left);
    suite_add_tcase(suite, tests);
    return suite;
}
