/*
 * test_pocket_word.c: pocket=patch is two pieces sewn to lines of the garment, mirror images of one another, at any
 * size; a front that closes is a closure.
 */
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


/* hoodie_zip at W52 and scrub_top at C92 have to move them in from beyond their panels */
START_TEST(a_pocket_is_two_pieces)
{
    static const char *const rows[][2] = {{"hoodie_zip", "W52"}, {"scrub_top", "C92"},   {"denim_skirt", "W40"},
                                          {"oxford_shirt", "M50"}, {"pinafore", "C116"}, {"apron_dress", "W50"}};
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


Suite *mus_suite_pocket_word(void);


Suite *mus_suite_pocket_word(void)
{
    Suite *suite = suite_create("pocket_word");
    TCase *tests = tcase_create("pocket_word");
    tcase_add_loop_test(tests, a_pocket_is_two_pieces, 0, 6);
    tcase_add_loop_test(tests, a_front_that_closes_is_a_closure, 0, 2);
    suite_add_tcase(suite, tests);
    return suite;
}
