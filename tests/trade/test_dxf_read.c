/*
 * test_dxf_read.c: DXF files of the trade as patterns: what a sheet wrote comes back; the dialects of Gerber and
 * Valentina; faults are told with their line.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "muslin/exchange.h"
#include "muslin/print.h"
#include "print/sample_patterns.h"
#include "support.h"
#include "trade/dxf_texts.h"

static mus_status read_text(mus_context *context, const char *text, const char *rules, const char *size,
                            mus_pattern **out)
{
    mus_pattern_dxf from;
    mus_pattern_dxf_init(&from, sizeof from);
    from.path = "a.dxf";
    from.text = text;
    from.text_size = strlen(text);
    from.rules_path = rules != NULL ? "a.rul" : NULL;
    from.rules = rules;
    from.rules_size = rules != NULL ? strlen(rules) : 0;
    from.size_name = size;
    return mus_pattern_read_dxf(context, &from, out);
}


/* the shirt through a dialect; the caller frees both */
static mus_pattern *shirt_again(mus_context *context, int32_t dialect, mus_pattern **shirt)
{
    mus_sheet *sheet;
    mus_sheet_dxf def;
    mus_pattern *again;
    char *bytes;
    size_t size;
    *shirt = sample_shirt(context);
    mus_sheet_dxf_init(&def, sizeof def);
    def.dialect = dialect;
    ck_assert_int_eq(mus_sheet_create(context, *shirt, NULL, &sheet), MUS_OK);
    ck_assert_int_eq(mus_sheet_write_dxf_bytes(sheet, &def, &bytes, &size), MUS_OK);
    ck_assert_int_eq(mus_pattern_read_from(context, bytes, size, "s.dxf", &again), MUS_OK);
    mus_context_alloc(context, bytes, 0);
    mus_sheet_destroy(sheet);
    return again;
}


START_TEST(a_sheet_written_in_either_dialect_comes_back)
{
    mus_context *context = support_context();
    mus_pattern *shirt, *again = shirt_again(context, _i, &shirt);
    ck_assert_str_eq(mus_pattern_name(again), "Shirt für Åsa");
    ck_assert_int_eq(mus_pattern_panel_count(again), mus_pattern_panel_count(shirt));
    ck_assert_int_eq(mus_pattern_edge_count(again), mus_pattern_edge_count(shirt));
    ck_assert_int_eq(mus_pattern_notch_count(again), mus_pattern_notch_count(shirt));
    ck_assert_int_eq(mus_pattern_mark_count(again), mus_pattern_mark_count(shirt));
    ck_assert_int_eq(mus_pattern_seam_count(again), 0);
    for (int32_t p = 0; p < mus_pattern_panel_count(again); p++) {
        const char *name = mus_pattern_panel_name(again, p);
        const int32_t old = mus_pattern_find_panel(shirt, name);
        int32_t n, of;
        double grain[2];
        ck_assert_msg(old != MUS_NONE, "%s", name);
        ck_assert_double_eq_tol(mus_pattern_panel_area(again, p), mus_pattern_panel_area(shirt, old), 1e-5);
        ck_assert_int_eq(mus_pattern_grain(again, p, grain), MUS_OK);
        ck_assert_double_eq_tol(grain[0], 0.0, 1e-12);
        ck_assert_int_eq(mus_pattern_cut(again, p, &n, &of), MUS_OK);
        ck_assert_int_eq(of != MUS_NONE, strcmp(name, "sleeve_right") == 0);
        if (strcmp(name, "sleeve_left") == 0) ck_assert_int_eq(n, 2);
    }
    /* the front: hem 25 mm, neck 7 mm, else the sheet's 10 mm; its notch stands where it stood */
    int32_t hems = 0, necks = 0, tens = 0;
    for (int32_t e = 0; e < 8; e++) {
        const double allowance = mus_pattern_edge_allowance(again, e);
        hems += fabs(allowance - 0.025) < 1e-5;
        necks += fabs(allowance - 0.007) < 1e-5;
        tens += fabs(allowance - 0.01) < 1e-5;
    }
    ck_assert_int_eq(hems, 1);
    ck_assert_int_eq(necks, 1);
    ck_assert_int_eq(tens, 6);
    mus_pattern_destroy(shirt);
    mus_pattern_destroy(again);
    support_context_end(context);
}
END_TEST


START_TEST(notches_and_marks_come_back_with_kind_place_and_name)
{
    mus_context *context = support_context();
    mus_pattern *shirt, *again = shirt_again(context, _i, &shirt);
    for (int32_t i = 0; i < mus_pattern_notch_count(again); i++) {
        int32_t edge, kind, found = 0;
        double s;
        ck_assert_int_eq(mus_pattern_notch(again, i, &edge, &s, &kind), MUS_OK);
        for (int32_t k = 0; k < mus_pattern_notch_count(shirt); k++) {
            int32_t old_edge, old_kind;
            double old, length = mus_pattern_edge_length(again, edge);
            ck_assert_int_eq(mus_pattern_notch(shirt, k, &old_edge, &old, &old_kind), MUS_OK);
            found += kind == old_kind && (fabs(s - old) < 2e-4 || fabs(length - s - old) < 2e-4);
        }
        ck_assert_msg(found > 0, "notch %d of kind %d at %.4f", (int)i, (int)kind, s);
    }
    int32_t named = 0, n;
    for (int32_t i = 0; i < mus_pattern_mark_count(again); i++) {
        const char *name;
        ck_assert_int_eq(mus_pattern_mark(again, i, NULL, &name, &n, NULL), MUS_OK);
        named += (strcmp(name, "centre") == 0 && n == 2) || (strcmp(name, "fold") == 0 && n == 1);
    }
    ck_assert_int_eq(named, mus_pattern_mark_count(again));
    mus_pattern_destroy(shirt);
    mus_pattern_destroy(again);
    support_context_end(context);
}
END_TEST


START_TEST(gerber_s_open_chains_inches_and_mirror_line)
{
    mus_context *context = support_context();
    mus_pattern *pattern;
    int32_t n, edge, kind;
    double grain[2], s;
    const double inch = 0.0254;
    ck_assert_int_eq(read_text(context, dxf_gerber, NULL, NULL, &pattern), MUS_OK);
    ck_assert_str_eq(mus_pattern_name(pattern), "VEST");
    ck_assert_int_eq(mus_pattern_panel_count(pattern), 1);
    ck_assert_str_eq(mus_pattern_panel_name(pattern, 0), "front");
    /* unfolded: a rectangle of 10 x 10 inches, its hem and neck whole edges over the fold */
    ck_assert_double_eq_tol(mus_pattern_panel_area(pattern, 0), 100.0 * inch * inch, 1e-9);
    ck_assert_int_eq(mus_pattern_outline(pattern, 0, &n, NULL, NULL), MUS_OK);
    ck_assert_int_eq(n, 4);
    for (int32_t e = 0; e < n; e++) ck_assert_double_eq_tol(mus_pattern_edge_length(pattern, e), 10.0 * inch, 1e-9);
    ck_assert_double_eq(mus_pattern_edge_allowance(pattern, 0), 0.0);
    ck_assert_int_eq(mus_pattern_grain(pattern, 0, grain), MUS_OK);
    ck_assert_double_eq_tol(grain[1], 1.0, 1e-12);

    /* with the images of its notch and its drill point */
    ck_assert_int_eq(mus_pattern_notch_count(pattern), 2);
    ck_assert_int_eq(mus_pattern_mark_count(pattern), 2);
    for (int32_t k = 0, first = MUS_NONE; k < 2; k++) {
        ck_assert_int_eq(mus_pattern_notch(pattern, k, &edge, &s, &kind), MUS_OK);
        ck_assert_int_ne(edge, first);
        ck_assert(fabs(s - 4.0 * inch) < 1e-9 || fabs(s - 6.0 * inch) < 1e-9); /* from either end of a side */
        first = edge;
    }
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


START_TEST(a_size_comes_from_its_own_blocks_or_from_the_rules)
{
    static const struct {
        const char *size, *rules;
        double width; /* [inch] of the half */
    } rows[] = {{"42", NULL, 6.0}, {"38", rul_gerber, 4.5}, {"40", rul_gerber, 5.0}};
    mus_context *context = support_context();
    mus_pattern *pattern;
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        ck_assert_int_eq(read_text(context, dxf_gerber, rows[i].rules, rows[i].size, &pattern), MUS_OK);
        ck_assert_double_eq_tol(mus_pattern_panel_area(pattern, 0), 20.0 * rows[i].width * 0.0254 * 0.0254, 1e-9);
        mus_pattern_destroy(pattern);
    }
    ck_assert_int_eq(read_text(context, dxf_gerber, NULL, "50", &pattern), MUS_ERR_ARG);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "40, 42"));
    ck_assert_ptr_null(pattern);
    support_context_end(context);
}
END_TEST


START_TEST(a_fault_is_told_with_its_line)
{
    static const struct {
        const char *text, *word;
        mus_status status;
    } rows[] = {
        {"0\nSECTION\nx\nBLOCKS\n", "a.dxf:3: expected a group code", MUS_ERR_FORMAT},
        {"0\nSECTION\n2\nBLOCKS\n", "the file ends", MUS_ERR_FORMAT},
        {"0\nBLOCK\n2\nA\n0\nEOF\n", "no ENDBLK", MUS_ERR_FORMAT},
        {"0\nSECTION\n0\nEOF\n", "no piece", MUS_ERR_FORMAT},
        {"0\nBLOCK\n2\nA\n0\nLINE\n8\n1\n10\n0\n20\n0\n11\nsix\n21\n0\n0\nENDBLK\n0\nEOF\n", "a.dxf:14: group code 11",
         MUS_ERR_FORMAT},
        {"0\nBLOCK\n2\nA\n0\nLINE\n8\n1\n10\n0\n20\n0\n11\n9\n21\n0\n0\nENDBLK\n0\nEOF\n", "open by 9.00 mm",
         MUS_ERR_FORMAT},
        {"0\nBLOCK\n2\nA\n0\nPOLYLINE\n8\n1\n0\nVERTEX\n8\n1\n10\n0\n20\n0\n0\nSEQEND\n0\nENDBLK\n0\nEOF\n",
         "fewer than three points", MUS_ERR_FORMAT},
        {"0\nBLOCK\n2\nA\n0\nARC\n8\n1\n40\n5\n0\nENDBLK\n0\nEOF\n", "ARC on layer 1; expected POLYLINE",
         MUS_ERR_UNSUPPORTED},
        {"0\nBLOCK\n2\nA\n0\nPOLYLINE\n8\n1\n0\nLINE\n0\nEOF\n", "expected VERTEX or SEQEND, got \"LINE\"",
         MUS_ERR_FORMAT},
    };
    mus_context *context = support_context();
    mus_pattern *pattern;
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        ck_assert_int_eq(read_text(context, rows[i].text, NULL, NULL, &pattern), rows[i].status);
        ck_assert_msg(strstr(mus_context_error(context), rows[i].word) != NULL, "%s", mus_context_error(context));
        ck_assert_ptr_null(pattern);
    }
    mus_pattern_dxf from;
    mus_pattern_dxf_init(&from, sizeof from);
    ck_assert_int_eq(mus_pattern_read_dxf(context, &from, &pattern), MUS_ERR_ARG);
    from.size = 3;
    ck_assert_int_eq(mus_pattern_read_dxf(context, &from, &pattern), MUS_ERR_VERSION);
    ck_assert_int_eq(mus_pattern_read_dxf(context, NULL, &pattern), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_read_dxf(NULL, &from, &pattern), MUS_ERR_ARG);
    support_context_end(context);
}
END_TEST


START_TEST(rules_have_one_list_of_sizes)
{
    char rules[2048] = "ASTM/D13Proposal 1\nUNITS: METRIC\nSAMPLE SIZE: a\nSIZE LIST: a\n"
                       "RULE: DELTA 1\n0,0\nSIZE LIST:";
    mus_context *context = support_context();
    mus_pattern *pattern;
    for (int i = 0; i < 64; i++) snprintf(rules + strlen(rules), sizeof rules - strlen(rules), " s%d", i);
    strcat(rules, "\nEND\n");
    ck_assert_int_eq(read_text(context, dxf_gerber, rules, "s9", &pattern), MUS_ERR_FORMAT);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "second line \"SIZE LIST:\""));
    support_context_end(context);
}
END_TEST


START_TEST(no_memory_is_a_status)
{
    for (int64_t n = 0;; n++) {
        mus_context *context = support_context();
        mus_pattern *pattern;
        support_fail_after(n, false);
        const mus_status status = read_text(context, dxf_gerber, rul_gerber, "38", &pattern);
        support_fail_never();
        mus_pattern_destroy(pattern);
        support_context_end(context);
        if (status == MUS_OK) break;
        ck_assert_int_eq(status, MUS_ERR_MEMORY);
    }
}
END_TEST


START_TEST(valentina_s_sew_line_and_lost_names)
{
    char path[512];
    mus_context *context = support_context();
    mus_pattern *pattern;
    if (support_data("valentina/blusa.aama.dxf", path, sizeof path) == NULL) return;
    ck_assert_int_eq(mus_pattern_read(context, path, &pattern), MUS_OK);
    ck_assert_int_eq(mus_pattern_panel_count(pattern), 2);
    ck_assert_str_eq(mus_pattern_panel_name(pattern, 0), "piece_1"); /* "??????" in the file */
    ck_assert_str_eq(mus_pattern_panel_name(pattern, 1), "detalle");
    ck_assert_double_eq_tol(1e6 * mus_pattern_panel_area(pattern, 1), 61036.03, 0.01);
    ck_assert_double_eq_tol(mus_pattern_edge_allowance(pattern, 0), 0.01, 1e-3);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_dxf_read(void);

Suite *mus_suite_dxf_read(void)
{
    Suite *suite = suite_create("dxf_read");
    TCase *tests = tcase_create("dxf_read");
    tcase_add_loop_test(tests, a_sheet_written_in_either_dialect_comes_back, 0, 2);
    tcase_add_loop_test(tests, notches_and_marks_come_back_with_kind_place_and_name, 0, 2);
    tcase_add_test(tests, gerber_s_open_chains_inches_and_mirror_line);
    tcase_add_test(tests, a_size_comes_from_its_own_blocks_or_from_the_rules);
    tcase_add_test(tests, rules_have_one_list_of_sizes);
    tcase_add_test(tests, a_fault_is_told_with_its_line);
    tcase_add_test(tests, no_memory_is_a_status);
    tcase_add_test(tests, valentina_s_sew_line_and_lost_names);
    suite_add_tcase(suite, tests);
    return suite;
}
