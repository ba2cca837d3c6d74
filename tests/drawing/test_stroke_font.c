/*
 * test_stroke_font.c: the alphabet: every printable character has a glyph inside its box, accents fall back to base
 * letters, broken UTF-8 ends.
 */
#include <string.h>

#include "print/page.h"
#include "support.h"

static mus_context *context;
static mus__drawing drawing;


static void setup(void)
{
    context = support_context();
    mus__draw_init(&drawing, context);
}


static void teardown(void)
{
    mus__draw_free(&drawing);
    support_context_end(context);
}


static const mus__path *draw(const char *text, double x, double y, const mus__text_style *style)
{
    mus__draw_path(&drawing, MUS_NONE, MUS__LAYER_LABEL, MUS__PEN_TEXT);
    mus__draw_text(&drawing, text, x, y, style);
    ck_assert_int_eq(drawing.status, MUS_OK);
    return &drawing.paths[drawing.npath - 1];
}


START_TEST(every_printable_character_is_drawn_within_its_width)
{
    const mus__text_style style = {0.01, 1.0, 0.0, 0.0};
    for (char c = '!'; c <= '~'; c++) {
        const char text[] = {c, '\0'};
        const mus__path *path = draw(text, 0.0, 0.0, &style);
        ck_assert_int_gt(path->nop, 1);
        ck_assert_double_ge(path->box[0], -1e-12);
        ck_assert_double_le(path->box[2], 0.01 * mus__text_width(text) + 1e-12);
        ck_assert_double_ge(path->box[1], -0.0041);
        ck_assert_double_le(path->box[3], 0.0111);
    }
}
END_TEST


START_TEST(capitals_are_as_high_as_asked_and_differ_from_each_other)
{
    const mus__text_style style = {0.02, 1.0, 0.0, 0.0};
    for (char c = 'A'; c <= 'Z'; c++) {
        const mus__path *path = draw((const char[]){c, '\0'}, 0.0, 0.0, &style);
        ck_assert_double_eq_tol(path->box[3], 0.02, 1e-12);
        for (int32_t k = 0; k + 1 < drawing.npath; k++) {
            const mus__path *other = &drawing.paths[k];
            bool same = other->nop == path->nop && memcmp(drawing.ops + other->op, drawing.ops + path->op,
                                                          (size_t)path->nop) == 0;
            size_t bytes = (size_t)(drawing.nxy - path->at) * sizeof(double);
            if (same) ck_assert(memcmp(drawing.xy + other->at, drawing.xy + path->at, bytes) != 0);
        }
    }
}
END_TEST


START_TEST(accents_fall_back_to_base_letters)
{
    static const char *const pairs[][2] = {
        {"für Åsa", "fur Asa"}, {"ÄÖÜäöüß", "AOUaous"}, {"Čeština", "Cestina"},
        {"Łódź", "Lodz"},       {"a–b", "a-b"},         {"日", "?"}};
    for (size_t i = 0; i < sizeof pairs / sizeof pairs[0]; i++)
        ck_assert_double_eq(mus__text_width(pairs[i][0]), mus__text_width(pairs[i][1]));
    const char *text = "ü";
    ck_assert_uint_eq(mus__text_character(&text), 0xfc);
    ck_assert_uint_eq(mus__text_character(&text), 0);
}
END_TEST


START_TEST(broken_text_ends_and_counts_as_unknown)
{
    static const char *const broken[] = {"\xff", "\xc3", "\xe2\x82", "\x80\x80", "a\xc0\x80", "\xf5\x80\x80\x80"};
    for (size_t i = 0; i < sizeof broken / sizeof broken[0]; i++) {
        const char *text = broken[i];
        int32_t unknown = 0, count = 0;
        for (uint32_t code; (code = mus__text_character(&text)) != 0; count++) unknown += code == 0xfffd;
        ck_assert_int_gt(unknown, 0);
        ck_assert_int_le(count, (int)strlen(broken[i]));
        ck_assert_ptr_eq(text, broken[i] + strlen(broken[i]));
    }
}
END_TEST


START_TEST(text_turns_and_aligns)
{
    const mus__text_style right = {0.01, 1.0, 0.0, 1.0}, up = {0.01, 0.0, 1.0, 0.5};
    const mus__path *path = draw("HH", 0.5, 0.2, &right);
    ck_assert_double_eq_tol(path->box[2], 0.5, 1e-12);
    ck_assert_double_eq_tol(path->box[1], 0.2, 1e-12);
    path = draw("HH", 0.5, 0.2, &up);
    ck_assert_double_eq_tol(0.5 * (path->box[1] + path->box[3]), 0.2, 1e-12);
    ck_assert_double_eq_tol(path->box[2], 0.5, 1e-12);
    ck_assert_double_eq_tol(path->box[0], 0.49, 1e-12);
}
END_TEST


Suite *mus_suite_stroke_font(void);
Suite *mus_suite_stroke_font(void)
{
    Suite *suite = suite_create("stroke_font");
    TCase *test = tcase_create("stroke");
    tcase_add_checked_fixture(test, setup, teardown);
    tcase_add_test(test, every_printable_character_is_drawn_within_its_width);
    tcase_add_test(test, capitals_are_as_high_as_asked_and_differ_from_each_other);
    tcase_add_test(test, accents_fall_back_to_base_letters);
    tcase_add_test(test, broken_text_ends_and_counts_as_unknown);
    tcase_add_test(test, text_turns_and_aligns);
    suite_add_tcase(suite, test);
    return suite;
}
