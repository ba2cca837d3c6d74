/*
 * test_piece_fold.c: a symmetric piece as its half: unfolded it is the whole; what is not symmetric stays whole.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "muslin/design.h"
#include "print/page.h"
#include "print/sample_patterns.h"
#include "support.h"

static mus_context *context;


static void setup(void)
{
    context = support_context();
}


static void teardown(void)
{
    support_context_end(context);
}


/* distance [m] of a point from a closed line */
static double away(const double *p, int32_t n, const double *xy)
{
    double best = HUGE_VAL;
    for (int32_t i = 0; i < n; i++) {
        const double *a = xy + 2 * i, *b = xy + 2 * ((i + 1) % n), dx = b[0] - a[0], dy = b[1] - a[1];
        double t = ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / (dx * dx + dy * dy);
        t = t < 0.0 ? 0.0 : t > 1.0 ? 1.0 : t;
        best = fmin(best, hypot(p[0] - a[0] - t * dx, p[1] - a[1] - t * dy));
    }
    return best;
}


/* the half at the place of the whole: its right side is the whole's */
static void unfolds(const mus__piece *whole, mus__piece *half)
{
    mus__piece_move(half, whole->box[2] - half->box[2], whole->box[3] - half->box[3]);
    for (int32_t i = 0; i < whole->cut.n; i++) {
        const double p[2] = {half->axis + fabs(whole->cut.xy[2 * i] - half->axis), whole->cut.xy[2 * i + 1]};
        ck_assert_double_lt(away(p, half->cut.n, half->cut.xy), 1e-4);
    }
    for (int32_t i = 0; i < half->nspan; i++) {
        double p[2];
        mus__cubic_at(half->spans[i].p, 0.4, p);
        ck_assert_double_ge(p[0], half->axis - 1e-9);
        ck_assert_double_lt(away(p, whole->nflat, whole->flat), 1e-4);
    }
}


START_TEST(halves_of_named_designs_unfold_to_the_whole)
{
    static const char *const names[] = {"tshirt", "pencil_skirt_knee", "oxford_shirt", "skirt", "jeans"};
    int32_t halves = 0, wholes = 0;
    mus_tape *tape;
    ck_assert_int_eq(mus_tape_create(context, &tape), MUS_OK);
    ck_assert_int_eq(mus_tape_set_size(tape, "W40"), MUS_OK);
    for (size_t d = 0; d < sizeof names / sizeof *names; d++) {
        mus_pattern *pattern;
        ck_assert_int_eq(mus_design_draft(context, mus_design_find(names[d]), tape, NULL, &pattern), MUS_OK);
        for (int32_t p = 0; p < mus_pattern_panel_count(pattern); p++) {
            mus__piece whole, half;
            memset(&whole, 0, sizeof whole);
            memset(&half, 0, sizeof half);
            ck_assert_int_eq(mus__piece_make(context, pattern, p, 0.01, &whole), MUS_OK);
            ck_assert_int_eq(mus__piece_make(context, pattern, p, 0.01, &half), MUS_OK);
            ck_assert_int_eq(mus__piece_fold(context, pattern, &half), MUS_OK);
            if (half.fold) unfolds(&whole, &half);
            halves += half.fold;
            wholes += !half.fold;
            mus__piece_free(context, &whole);
            mus__piece_free(context, &half);
        }
        mus_pattern_destroy(pattern);
    }
    mus_tape_destroy(tape);
    ck_assert_int_ge(halves, 8);
    ck_assert_int_ge(wholes, 8);
}
END_TEST


/* makes the first piece of a pattern, and tells whether it is printed as its half */
static bool piece_folds(const mus_pattern *pattern, mus__piece *piece)
{
    memset(piece, 0, sizeof *piece);
    ck_assert_int_eq(mus__piece_make(context, pattern, 0, 0.01, piece), MUS_OK);
    ck_assert_int_eq(mus__piece_fold(context, pattern, piece), MUS_OK);
    return piece->fold;
}


START_TEST(what_is_not_symmetric_stays_whole)
{
    /* a square; with a notch on one side; with a mark beside the middle; with a wider allowance on one side */
    const double xy[] = {0, 0, 0.4, 0, 0.4, 0.6, 0, 0.6};
    for (int32_t k = 0; k < 4; k++) {
        mus_pattern *pattern = sample_polygon(context, 4, xy);
        mus__piece piece;
        const double at[] = {0.1, 0.3};
        if (k == 1) ck_assert_int_eq(mus_pattern_add_notch(pattern, 1, 0.2, MUS_NOTCH_SINGLE, NULL), MUS_OK);
        if (k == 2) ck_assert_int_eq(mus_pattern_add_mark(pattern, 0, "pocket", 1, at, NULL), MUS_OK);
        if (k == 3) ck_assert_int_eq(mus_pattern_set_edge_allowance(pattern, 1, 0.02), MUS_OK);
        ck_assert(piece_folds(pattern, &piece) == (k == 0));
        if (k == 0) ck_assert_double_eq_tol(piece.box[2], 0.21, 1e-6);
        mus__piece_free(context, &piece);
        mus_pattern_destroy(pattern);
    }
}
END_TEST


START_TEST(a_sheet_of_halves_says_so_and_is_no_dxf)
{
    const double xy[] = {0, 0, 0.4, 0, 0.4, 0.6, 0, 0.6};
    mus_pattern *pattern = sample_polygon(context, 4, xy);
    mus_sheet_def def;
    mus_sheet *sheet;
    mus_sheet_piece told;
    mus_sheet_def_init(&def, sizeof def);
    mus_sheet_piece_init(&told, sizeof told);
    def.fold = 1;
    ck_assert_int_eq(mus_sheet_create(context, pattern, &def, &sheet), MUS_OK);
    ck_assert_int_eq(mus_sheet_piece_get(sheet, 0, &told), MUS_OK);
    ck_assert_int_eq(abs(told.fold), 1 + sheet->pieces[0].across);
    const double *box = told.box, line = told.fold == 1 ? box[0] : told.fold == 2 ? box[1] : box[1 - told.fold];
    ck_assert_double_eq_tol(line, sheet->pieces[0].axis, 1e-9);
    char text[64], *bytes;
    size_t size;
    mus__piece_cut_text(&sheet->pieces[0], 0, text, sizeof text);
    ck_assert_str_eq(text, "Cut 1 on fold");
    ck_assert_int_eq(mus_sheet_write_dxf_bytes(sheet, NULL, &bytes, &size), MUS_ERR_ARG);
    mus_sheet_destroy(sheet);
    mus_pattern_destroy(pattern);
}
END_TEST


/* a strip with its grain along it is no half where its long edges differ: one is sewn, or the labels are others */
START_TEST(a_band_is_folded_across_its_length_alone)
{
    const double xy[] = {0, 0, 0.4, 0, 0.4, 0.05, 0, 0.05};
    for (int32_t k = 0; k < 4; k++) {
        mus_pattern *pattern = sample_polygon(context, 4, xy);
        mus__piece piece;
        if (k % 2 == 1) ck_assert_int_eq(mus_pattern_set_edge_label(pattern, 2, "top"), MUS_OK);
        if (k >= 2) ck_assert_int_eq(mus_pattern_set_grain(pattern, 0, 1.0, 0.0), MUS_OK);
        ck_assert(piece_folds(pattern, &piece) == (k != 3));
        mus__piece_free(context, &piece);
        mus_pattern_destroy(pattern);
    }
}
END_TEST


/* each quarter: points of the panel come to lie on the outline, the fold line on the cut line; four are none */
START_TEST(a_piece_is_turned_by_quarters)
{
    const double xy[] = {0, 0, 0.4, 0, 0.3, 0.6, 0.1, 0.6};
    mus_pattern *pattern = sample_polygon(context, 4, xy);
    mus__piece piece;
    double first[4];
    ck_assert(piece_folds(pattern, &piece));
    memcpy(first, piece.box, sizeof first);
    for (int32_t k = 1; k <= 4; k++) {
        const double top[2] = {0.3, 0.6};
        double p[2], line[2] = {HUGE_VAL, -HUGE_VAL};
        mus__piece_quarter(&piece);
        ck_assert_int_eq(piece.grain, k % 2 == 0);
        ck_assert_int_eq(piece.across, k % 2);
        mus__piece_point(&piece, top, p);
        ck_assert_double_lt(away(p, piece.nflat, piece.flat), 1e-9);
        for (int32_t i = 0; i < piece.cut.n; i++) {
            const double *at = piece.cut.xy + 2 * i;
            ck_assert_double_ge(piece.inward * (at[piece.across] - piece.axis), -1e-9);
            if (fabs(at[piece.across] - piece.axis) > 1e-9) continue;
            line[0] = fmin(line[0], at[1 - piece.across]);
            line[1] = fmax(line[1], at[1 - piece.across]);
        }
        ck_assert_double_eq_tol(line[1] - line[0], 0.62, 1e-6);
    }
    for (int32_t i = 0; i < 4; i++) ck_assert_double_eq_tol(piece.box[i], first[i], 1e-12);
    mus__piece_free(context, &piece);
    mus_pattern_destroy(pattern);
}
END_TEST


Suite *mus_suite_piece_fold(void);
Suite *mus_suite_piece_fold(void)
{
    Suite *suite = suite_create("piece_fold");
    TCase *test = tcase_create("fold");
    tcase_add_checked_fixture(test, setup, teardown);
    tcase_add_test(test, halves_of_named_designs_unfold_to_the_whole);
    tcase_add_test(test, what_is_not_symmetric_stays_whole);
    tcase_add_test(test, a_sheet_of_halves_says_so_and_is_no_dxf);
    tcase_add_test(test, a_band_is_folded_across_its_length_alone);
    tcase_add_test(test, a_piece_is_turned_by_quarters);
    suite_add_tcase(suite, test);
    return suite;
}
