/*
 * test_pocket_word.c: pocket=patch is two pieces sewn to lines of the garment, mirror images of one another, at any
 * size; pocket=kangaroo is one piece as it is marked, hem=ribbed a rib shorter than its hem; a front that closes is a
 * closure.
 */
#include <math.h>
#include <string.h>

#include "block/drafts.h"
#include "muslin/topology.h"


static mus_pattern *pocketed(mus_context *context, const char *design, const char *size)
{
    mus_tape *tape = drafts_tape(context, size);
    mus_pattern *pattern;
    const mus_status status = mus_design_draft(context, mus_design_find(design), tape, NULL, &pattern);
    ck_assert_msg(status == MUS_OK, "%s %s: %s", design, size, mus_context_error(context));
    mus_tape_destroy(tape);
    return pattern;
}


/* pockets of scrub_top at C92 have to move in from beyond their panels */
START_TEST(a_pocket_is_two_pieces)
{
    static const char *const rows[][2] = {{"pyjama_jacket", "W52"}, {"scrub_top", "C92"}, {"denim_skirt", "W40"},
                                          {"oxford_shirt", "M50"},  {"pinafore", "C116"}, {"apron_dress", "W50"}};
    mus_context *context = support_context();
    mus_pattern *pattern = pocketed(context, rows[_i][0], rows[_i][1]);
    const int32_t left = mus_pattern_find_panel(pattern, "pocket_left");
    const int32_t right = mus_pattern_find_panel(pattern, "pocket_right");
    ck_assert_int_ne(left, MUS_NONE);
    ck_assert_int_ne(right, MUS_NONE);
    ck_assert_double_eq_tol(mus_pattern_panel_area(pattern, left), mus_pattern_panel_area(pattern, right), 1e-9);
    int32_t count, mirror, sewn = 0;
    mus_pattern_cut(pattern, right, &count, &mirror);
    ck_assert_int_eq(mirror, left);
    for (int32_t i = 0; i < mus_pattern_seam_count(pattern); i++) {
        mus_seam_def seam;
        mus_seam_def_init(&seam, sizeof seam);
        mus_pattern_seam(pattern, i, &seam);
        sewn += mus_pattern_edge_panel(pattern, seam.edge_a) == left;
        sewn += mus_pattern_edge_panel(pattern, seam.edge_a) == right;
    }
    ck_assert_int_eq(sewn, 6);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


START_TEST(a_front_that_closes_is_a_closure)
{
    mus_context *context = support_context();
    mus_pattern *pattern = pocketed(context, _i == 0 ? "oxford_shirt" : "tshirt", "M50");
    int32_t count;
    ck_assert_int_eq(mus_pattern_open_closures(pattern, 1, &count), MUS_OK);
    ck_assert_int_eq(count, _i == 0 ? 3 : 0); /* the front and both cuffs */
    ck_assert_int_eq(mus_pattern_check(pattern, &count, NULL), MUS_OK);
    ck_assert_int_eq(count, 0);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


/* a kangaroo pocket is a mark on each half of the front and one piece, or a pair where the front opens. The piece has
 * the lengths of the mark, and two edges of it are open */
START_TEST(a_kangaroo_pocket_is_cut_as_it_is_marked)
{
    static const char *const sizes[] = {"W34", "W52", "M50", "M60", "C80", "C164"};
    static const char *const designs[] = {"hoodie", "hoodie_zip", "hoodie_raglan"};
    mus_context *context = support_context();
    for (int d = 0; d < 3; d++) {
        mus_pattern *pattern = pocketed(context, designs[d], sizes[_i]);
        const mus_pattern *made = mus_pattern_cut_only(pattern);
        const double *half = NULL;
        int32_t marks = 0, opened = 0;
        for (int32_t i = 0; i < mus_pattern_mark_count(pattern); i++) {
            const char *name;
            const double *xy;
            int32_t n;
            ck_assert_int_eq(mus_pattern_mark(pattern, i, NULL, &name, &n, &xy), MUS_OK);
            if (strcmp(name, "kangaroo pocket") != 0) continue;
            ck_assert_int_eq(n, 5);
            marks++;
            if (xy[2] > xy[0]) half = xy;
        }
        ck_assert_int_eq(marks, 2);
        ck_assert_ptr_nonnull(half);
        const double slant = hypot(half[4] - half[2], half[5] - half[3]);
        for (int32_t e = 0; e < mus_pattern_edge_count(made); e++) {
            if (strcmp(mus_pattern_edge_label(made, e), "opening") != 0) continue;
            ck_assert_double_eq_tol(mus_pattern_edge_length(made, e), slant, 1e-9);
            opened++;
        }
        ck_assert_int_eq(opened, 2);
        const int32_t piece = mus_pattern_find_panel(made, d == 1 ? "kangaroo_pocket_left" : "kangaroo_pocket");
        ck_assert_int_ne(piece, MUS_NONE);
        const double area =
            0.5 * (half[2] + half[4] - 2.0 * half[0]) * (half[3] - half[5]) + (half[4] - half[0]) * (half[5] - half[7]);
        ck_assert_double_eq_tol(mus_pattern_panel_area(made, piece), d == 1 ? area : 2.0 * area, 1e-9);
        mus_pattern_destroy(pattern);
    }
    support_context_end(context);
}
END_TEST


/* a ribbed hem: each rib is 0.87 of the edge that it is sewn to, its free edge is the hem, and what is cut of the cloth
 * is shorter by 4 cm than with a hem that is turned */
START_TEST(a_ribbed_hem_draws_the_body_in)
{
    static const char *const words[] = {"top cloth=knit sleeve=long hem=ribbed", "top cloth=knit sleeve=long",
                                        "top cloth=knit closure=front hem=ribbed shape=princess_armhole"};
    static const char *const sizes[] = {"W34", "W52", "M50", "M60", "C80", "C164"};
    mus_context *context = support_context();
    mus_tape *tape = drafts_tape(context, sizes[_i]);
    double height[3];
    for (int w = 0; w < 3; w++) {
        mus_pattern *pattern;
        const mus_status status = mus_design_draft_words(context, words[w], tape, NULL, &pattern);
        ck_assert_msg(status == MUS_OK, "%s of %s: %s", words[w], sizes[_i], mus_context_error(context));
        const int32_t front = mus_pattern_find_panel(pattern, w < 2 ? "front" : "front_left");
        double body = 0.0, rib = 0.0;
        for (int32_t e = 0; e < mus_pattern_edge_count(pattern); e++) {
            if (strcmp(mus_pattern_edge_label(pattern, e), "rib") != 0) continue;
            const char *label = mus_pattern_panel_label(pattern, mus_pattern_edge_panel(pattern, e));
            *(strcmp(label, "rib") == 0 ? &rib : &body) += mus_pattern_edge_length(pattern, e);
        }
        if (w != 1) ck_assert_double_eq_tol(rib, 0.87 * body, 1e-6);
        ck_assert(w != 1 || (rib == 0.0 && body == 0.0));
        double low = 1.0;
        for (int32_t e = 0; e < mus_pattern_edge_count(pattern); e++) {
            double t = 0.0, xy[2];
            if (mus_pattern_edge_panel(pattern, e) != front) continue;
            ck_assert_int_eq(mus_pattern_edge_at(pattern, e, 1, &t, xy), MUS_OK);
            low = fmin(low, xy[1]);
        }
        height[w] = -low;
        mus_pattern_destroy(pattern);
    }
    ck_assert_double_gt(height[1] - height[0], 0.02);
    ck_assert_double_lt(height[1] - height[0], 0.04 + 1e-9);
    mus_tape_destroy(tape);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_pocket_word(void);


Suite *mus_suite_pocket_word(void)
{
    Suite *suite = suite_create("pocket_word");
    TCase *tests = tcase_create("pocket_word");
    tcase_add_loop_test(tests, a_pocket_is_two_pieces, 0, 6);
    tcase_add_loop_test(tests, a_front_that_closes_is_a_closure, 0, 2);
    tcase_add_loop_test(tests, a_kangaroo_pocket_is_cut_as_it_is_marked, 0, 6);
    tcase_add_loop_test(tests, a_ribbed_hem_draws_the_body_in, 0, 6);
    suite_add_tcase(suite, tests);
    return suite;
}
