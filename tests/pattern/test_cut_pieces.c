/*
 * test_cut_pieces.c: materials of a panel, and panels that are cut and not draped.
 */
#include "muslin/edit.h"
#include "pattern/same.h"


START_TEST(a_panel_is_cut_of_materials)
{
    mus_context *context = support_context();
    sample s = sample_make(context);
    int32_t count, mirrored;
    ck_assert_int_eq(mus_pattern_material(s.pattern, s.front, MUS_MATERIAL_MAIN, &count, &mirrored), MUS_OK);
    ck_assert(count == 1 && mirrored == 0);
    ck_assert_int_eq(mus_pattern_set_material(s.pattern, s.front, MUS_MATERIAL_INTERFACING, 2), MUS_OK);
    ck_assert_int_eq(mus_pattern_set_cut(s.pattern, s.front, 4, MUS_NONE), MUS_OK);
    ck_assert_int_eq(mus_pattern_set_cut(s.pattern, s.sleeve, 1, s.front), MUS_OK);
    ck_assert_int_eq(mus_pattern_material(s.pattern, s.front, MUS_MATERIAL_INTERFACING, &count, &mirrored), MUS_OK);
    ck_assert(count == 2 && mirrored == 1);
    ck_assert_int_eq(mus_pattern_material(s.pattern, s.front, MUS_MATERIAL_MAIN, &count, NULL), MUS_OK);
    ck_assert_int_eq(count, 4);
    ck_assert_int_eq(mus_pattern_material(s.pattern, s.sleeve, MUS_MATERIAL_MAIN, NULL, &mirrored), MUS_OK);
    ck_assert_int_eq(mirrored, 0);
    ck_assert_int_eq(mus_pattern_set_material(s.pattern, s.front, MUS_MATERIAL_COUNT, 1), MUS_ERR_ARG);
    ck_assert_str_eq(mus_context_error(context), "panel front: material 5, expected 0 to 4");
    ck_assert_int_eq(mus_pattern_set_material(s.pattern, s.front, MUS_MATERIAL_RIB, 1001), MUS_ERR_ARG);
    ck_assert_str_eq(mus_context_error(context), "panel front: 1001 pieces of rib to cut is outside 0 to 1000");
    ck_assert_int_eq(mus_pattern_set_material(s.pattern, 9, MUS_MATERIAL_RIB, 1), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_set_material(NULL, 0, MUS_MATERIAL_RIB, 1), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_material(s.pattern, 0, -1, &count, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_material(NULL, 0, 0, &count, &mirrored), MUS_ERR_ARG);
    for (int32_t i = 0; i < MUS_MATERIAL_COUNT; i++) ck_assert_int_eq(mus_material_find(mus_material_name(i)), i);
    ck_assert(mus_material_name(-1) == NULL && mus_material_name(MUS_MATERIAL_COUNT) == NULL);
    ck_assert(mus_material_find("denim") == MUS_NONE && mus_material_find(NULL) == MUS_NONE);
    mus_pattern_destroy(s.pattern);
    support_context_end(context);
}
END_TEST


START_TEST(panels_that_are_cut_alone_follow_their_pattern)
{
    mus_context *context = support_context();
    sample s = sample_make(context), other = sample_make(context), more = sample_make(context);
    mus_pattern *copy;
    ck_assert(mus_pattern_cut_only(s.pattern) == NULL && mus_pattern_cut_only(NULL) == NULL);
    ck_assert_int_eq(mus_pattern_set_cut_only(other.pattern, more.pattern), MUS_OK);
    ck_assert_int_eq(mus_pattern_set_cut_only(s.pattern, other.pattern), MUS_OK);
    mus_pattern_destroy(other.pattern);
    same_panels(mus_pattern_cut_only(s.pattern), more.pattern);
    ck_assert(mus_pattern_cut_only(mus_pattern_cut_only(s.pattern)) == NULL);
    ck_assert_int_eq(mus_pattern_panel_count(s.pattern), 2);

    /* a copy has its own; a garment worn over it brings its own */
    ck_assert_int_eq(mus_pattern_copy(s.pattern, &copy), MUS_OK);
    ck_assert(mus_pattern_cut_only(copy) != mus_pattern_cut_only(s.pattern));
    same_panels(mus_pattern_cut_only(copy), mus_pattern_cut_only(s.pattern));
    ck_assert_int_eq(mus_pattern_join(s.pattern, copy, 1), MUS_OK);
    ck_assert_int_eq(mus_pattern_panel_count(mus_pattern_cut_only(s.pattern)), 4);
    ck_assert_int_eq(mus_pattern_set_cut_only(more.pattern, NULL), MUS_OK);
    ck_assert_int_eq(mus_pattern_join(more.pattern, copy, 1), MUS_OK);
    ck_assert_int_eq(mus_pattern_panel_count(mus_pattern_cut_only(more.pattern)), 2);

    /* an edit leaves them, and so does its undoing */
    ck_assert_int_eq(mus_pattern_keep_history(copy, 4), MUS_OK);
    ck_assert_int_eq(mus_pattern_move_point(copy, 0, 0.001, 0.001), MUS_OK);
    ck_assert_int_eq(mus_pattern_panel_count(mus_pattern_cut_only(copy)), 2);
    ck_assert_int_eq(mus_pattern_undo(copy), MUS_OK);
    ck_assert_int_eq(mus_pattern_panel_count(mus_pattern_cut_only(copy)), 2);

    ck_assert_int_eq(mus_pattern_set_cut_only(copy, copy), MUS_ERR_ARG);
    ck_assert_str_eq(mus_context_error(context), "cut-only panels: the pattern itself");
    ck_assert_int_eq(mus_pattern_set_cut_only(NULL, copy), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_set_cut_only(copy, NULL), MUS_OK);
    ck_assert(mus_pattern_cut_only(copy) == NULL);
    mus_pattern_destroy(copy);
    mus_pattern_destroy(more.pattern);
    mus_pattern_destroy(s.pattern);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_cut_pieces(void);


Suite *mus_suite_cut_pieces(void)
{
    Suite *suite = suite_create("cut_pieces");
    TCase *tcase = tcase_create("pieces");
    tcase_add_test(tcase, a_panel_is_cut_of_materials);
    tcase_add_test(tcase, panels_that_are_cut_alone_follow_their_pattern);
    suite_add_tcase(suite, tcase);
    return suite;
}
