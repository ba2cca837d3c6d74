/*
 * test_panel_attributes.c: the sides of the wearer that a panel is on: told by its name until they are set, and kept by
 * copies, joins and edits.
 */
#include "muslin/edit.h"
#include "pattern/same.h"

#define FRONT MUS_SIDE_FRONT
#define BACK MUS_SIDE_BACK
#define LEFT MUS_SIDE_LEFT
#define RIGHT MUS_SIDE_RIGHT

static const struct {
    const char *name;
    int32_t sides;
} names[] = {{"front", FRONT},
             {"skirt_front_left", FRONT | LEFT},
             {"backSideRight", BACK | RIGHT},
             {"Back 2", BACK},
             {"RIGHT", RIGHT},
             {"aaron.front", FRONT},
             {"front_back", 0},
             {"left_right_front", FRONT},
             {"bright", 0},
             {"backless", 0},
             {"upfront", 0},
             {"f_l", 0},
             {"sleeve", 0}};


START_TEST(words_in_a_name_tell_sides_until_they_are_set)
{
    mus_context *context = support_context();
    mus_pattern *p;
    int32_t given;
    ck_assert_int_eq(mus_pattern_create(context, "names", &p), MUS_OK);
    for (int32_t i = 0; i < (int32_t)(sizeof names / sizeof *names); i++) {
        ck_assert_int_eq(mus_pattern_add_panel(p, names[i].name, NULL), MUS_OK);
        ck_assert_msg(mus_pattern_panel_sides(p, i, &given) == names[i].sides && !given, "%s: %d", names[i].name,
                      (int)mus_pattern_panel_sides(p, i, NULL));
    }

    /* set to others, to none, to opposites, and back to those of the name */
    static const int32_t set[][2] = {{BACK | LEFT, BACK | LEFT}, {0, 0}, {FRONT | BACK | LEFT, LEFT}, {FRONT, FRONT}};
    for (int i = 0; i < 4; i++) {
        ck_assert_int_eq(mus_pattern_set_panel_sides(p, 0, set[i][0]), MUS_OK);
        ck_assert_int_eq(mus_pattern_panel_sides(p, 0, &given), set[i][1]);
        ck_assert_int_eq(given, 1);
    }
    ck_assert_int_eq(mus_pattern_set_panel_sides(p, 0, 16), MUS_ERR_ARG);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "panel front: sides are 16, expected 0 to 15"));
    ck_assert_int_eq(mus_pattern_set_panel_sides(p, 0, -1), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_set_panel_sides(p, 99, 0), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_set_panel_sides(NULL, 0, 0), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_panel_sides(p, 0, NULL), FRONT);
    ck_assert_int_eq(mus_pattern_panel_sides(p, 99, &given), 0);
    ck_assert_int_eq(mus_pattern_panel_sides(NULL, 0, NULL), 0);
    mus_pattern_destroy(p);
    support_context_end(context);
}
END_TEST


START_TEST(copies_joins_and_images_keep_sides)
{
    mus_context *context = support_context();
    const sample s = sample_make(context), other = sample_make(context);
    mus_pattern *copy;
    int32_t image;
    const int32_t n = mus_pattern_panel_count(s.pattern), plain = mus_pattern_panel_sides(s.pattern, 1, NULL);
    ck_assert_int_eq(mus_pattern_set_panel_sides(s.pattern, 0, BACK | LEFT), MUS_OK);
    ck_assert_int_eq(mus_pattern_copy(s.pattern, &copy), MUS_OK);
    ck_assert_int_eq(mus_pattern_panel_sides(copy, 0, NULL), BACK | LEFT);

    /* a joined panel gets another name, and stays on its sides */
    ck_assert_int_eq(mus_pattern_set_name(s.pattern, "right coat"), MUS_OK);
    ck_assert_int_eq(mus_pattern_join(other.pattern, s.pattern, 1), MUS_OK);
    ck_assert_int_eq(mus_pattern_panel_sides(other.pattern, n, NULL), BACK | LEFT);
    ck_assert_int_eq(mus_pattern_panel_sides(other.pattern, n + 1, NULL), plain);

    /* the image of the back, left, is on the back, right; an edit changes no other panel */
    ck_assert_int_eq(mus_pattern_mirror_panel(copy, 0, "image", &image), MUS_OK);
    ck_assert_int_eq(mus_pattern_panel_sides(copy, image, NULL), BACK | RIGHT);
    ck_assert_int_eq(mus_pattern_panel_sides(copy, 0, NULL), BACK | LEFT);
    ck_assert_int_eq(mus_pattern_panel_sides(copy, 1, NULL), plain);
    mus_pattern_destroy(copy);
    mus_pattern_destroy(other.pattern);
    mus_pattern_destroy(s.pattern);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_panel_attributes(void);


Suite *mus_suite_panel_attributes(void)
{
    Suite *suite = suite_create("panel_attributes");
    TCase *tests = tcase_create("sides");
    tcase_add_test(tests, words_in_a_name_tell_sides_until_they_are_set);
    tcase_add_test(tests, copies_joins_and_images_keep_sides);
    suite_add_tcase(suite, tests);
    return suite;
}
