/*
 * test_dxf_allowance.c: allowances of edges, found again from the sew line and the cut line of a DXF: legs of darts,
 * narrow cuts, edges shorter than the gaps that a file may have; notches at corners.
 */
#include <math.h>

#include "muslin/exchange.h"
#include "muslin/print.h"
#include "print/sample_patterns.h"
#include "support.h"

/* a skirt panel with a dart in its waist and a last edge of 0.4 mm, and a strip with a slit that
 * its allowances fill but for its mouth */
static mus_pattern *panels(mus_context *context)
{
    static const sample_step skirt[] = {
        {0, 0.2997, MUS_PIECE_LINE, {0}, NULL, NAN},  {0, 0, MUS_PIECE_LINE, {0}, "hem", 0.025},
        {0.2, 0, MUS_PIECE_LINE, {0}, NULL, NAN},     {0.2, 0.3, MUS_PIECE_LINE, {0}, "waist", NAN},
        {0.11, 0.3, MUS_PIECE_LINE, {0}, NULL, 0.0},  {0.1, 0.2, MUS_PIECE_LINE, {0}, NULL, 0.0},
        {0.09, 0.3, MUS_PIECE_LINE, {0}, "waist", NAN}, {3e-4, 0.3, MUS_PIECE_LINE, {0}, NULL, NAN}};
    static const sample_step strip[] = {
        {0, 0, MUS_PIECE_LINE, {0}, "hem", 0.025},   {0.1, 0, MUS_PIECE_LINE, {0}, NULL, NAN},
        {0.1, 0.3, MUS_PIECE_LINE, {0}, NULL, NAN},  {0.058, 0.3, MUS_PIECE_LINE, {0}, "neck", 0.007},
        {0.05, 0.1, MUS_PIECE_LINE, {0}, "neck", 0.007}, {0.042, 0.3, MUS_PIECE_LINE, {0}, NULL, NAN},
        {0, 0.3, MUS_PIECE_LINE, {0}, NULL, NAN}};
    mus_pattern *pattern;
    mus_seam_def seam;
    int32_t panel, first, legs;
    ck_assert_int_eq(mus_pattern_create(context, "darts", &pattern), MUS_OK);
    ck_assert(sample_add_piece(pattern, "skirt", 8, skirt, &panel, &legs));
    mus_seam_def_init(&seam, sizeof seam);
    seam.edge_a = legs + 4;
    seam.edge_b = legs + 5;
    seam.direction = MUS_SEAM_REVERSED;
    ck_assert_int_eq(mus_pattern_add_seam(pattern, &seam, NULL), MUS_OK);
    ck_assert_int_eq(mus_pattern_add_notch(pattern, legs + 2, 0.3, MUS_NOTCH_SINGLE, NULL), MUS_OK);
    ck_assert(sample_add_piece(pattern, "strip", 7, strip, &panel, &first));
    return pattern;
}


START_TEST(every_edge_comes_back_with_the_allowance_it_was_cut_with)
{
    static const double want[15] = {10, 25, 10, 10, 0, 0, 10, 10, 25, 10, 10, 7, 7, 10, 10};
    mus_context *context = support_context();
    mus_pattern *pattern = panels(context), *again;
    mus_sheet *sheet;
    mus_sheet_dxf def;
    char *bytes;
    size_t size;
    double s;
    int32_t edge, kind;
    mus_sheet_dxf_init(&def, sizeof def);
    def.dialect = _i;
    ck_assert_int_eq(mus_sheet_create(context, pattern, NULL, &sheet), MUS_OK);
    ck_assert_int_eq(mus_sheet_write_dxf_bytes(sheet, &def, &bytes, &size), MUS_OK);
    ck_assert_int_eq(mus_pattern_read_from(context, bytes, size, "darts.dxf", &again), MUS_OK);
    ck_assert_int_eq(mus_pattern_edge_count(again), 15);
    for (int32_t e = 0; e < 15; e++) {
        ck_assert_double_eq_tol(mus_pattern_edge_length(again, e), mus_pattern_edge_length(pattern, e), 1e-6);
        ck_assert_msg(fabs(1e3 * mus_pattern_edge_allowance(again, e) - want[e]) < 1e-2, "edge %d has %g mm", (int)e,
                      1e3 * mus_pattern_edge_allowance(again, e));
    }
    /* the slit at the end of the side runs along the waist; it is a notch of the side, at its end */
    ck_assert_int_eq(mus_pattern_notch_count(again), 1);
    ck_assert_int_eq(mus_pattern_notch(again, 0, &edge, &s, &kind), MUS_OK);
    ck_assert_int_eq(edge, 2);
    ck_assert_double_eq_tol(s, 0.3, 1e-6);
    mus_context_alloc(context, bytes, 0);
    mus_sheet_destroy(sheet);
    mus_pattern_destroy(pattern);
    mus_pattern_destroy(again);
    support_context_end(context);
}
END_TEST


/* Valentina's cut line of this piece goes 50 to 89 mm away from one of three edges and back: that is no allowance */
START_TEST(a_cut_line_that_is_nowhere_parallel_gives_no_allowance)
{
    char path[512];
    mus_context *context = support_context();
    mus_pattern *pattern;
    if (support_data("valentina/issue646_notches.astm.dxf", path, sizeof path) == NULL) return;
    ck_assert_int_eq(mus_pattern_read(context, path, &pattern), MUS_OK);
    for (int32_t e = 0; e < 3; e++)
        ck_assert_double_eq_tol(mus_pattern_edge_allowance(pattern, e), e == 1 ? 0.0 : 0.01, 1e-5);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_dxf_allowance(void);

Suite *mus_suite_dxf_allowance(void)
{
    Suite *suite = suite_create("dxf_allowance");
    TCase *tests = tcase_create("dxf_allowance");
    tcase_add_loop_test(tests, every_edge_comes_back_with_the_allowance_it_was_cut_with, 0, 2);
    tcase_add_test(tests, a_cut_line_that_is_nowhere_parallel_gives_no_allowance);
    suite_add_tcase(suite, tests);
    return suite;
}
