/*
 * test_language.c: the table of words is whole in every language, and everything that a design says is made of it.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "block/drafts.h"
#include "language/language.h"
#include "muslin/print.h"
#include "drawing/phrase.h"
#include "sewing/sewing.h"

static const char *const sizes[] = {"W40", "M50", "C116"};

#define LISTS(tag) {&mus__sentences_##tag, &mus__names_##tag},
static const mus__language_list *const lists[][2] = {MUS__LANGUAGES(LISTS)};


/* how often each of {0} .. {9} stands in a text */
static void count_places(const char *text, int32_t *out)
{
    memset(out, 0, 10 * sizeof *out);
    for (; *text != '\0'; text++) {
        if (text[0] != '{') continue;
        ck_assert(text[1] >= '0' && text[1] <= '9' && text[2] == '}');
        out[text[1] - '0']++;
    }
}


/* rows that must not be empty hold a text; of English, keys are sorted and stand once */
START_TEST(every_language_has_every_row_with_its_places)
{
    ck_assert_int_eq(mus_language_count(), (int32_t)(sizeof lists / sizeof lists[0]));
    for (int32_t l = 0; l < mus_language_count(); l++)
        for (int32_t k = 0; k < 2; k++) {
            const mus__language_list *list = lists[l][k], *english = lists[0][k];
            ck_assert_int_eq(list->count, english->count);
            for (int32_t i = 0; i < list->count; i++) {
                const mus__language_row *row = &list->rows[i];
                int32_t places[10], wanted[10];
                ck_assert_str_eq(row->key, english->rows[i].key);
                ck_assert_msg(i == 0 || strcmp(list->rows[i - 1].key, row->key) < 0, "%s is not sorted", row->key);
                ck_assert_msg(row->text[0] != '\0', "%s: %s is empty", mus_language_tag(l), row->key);
                count_places(row->text, places);
                count_places(english->rows[i].text, wanted);
                for (int32_t p = 0; p < 10; p++)
                    ck_assert_msg((places[p] > 0) == (wanted[p] > 0), "%s: %s has {%d} %d times, English %d times",
                                  mus_language_tag(l), row->key, (int)p, (int)places[p], (int)wanted[p]);
            }
        }
}
END_TEST


START_TEST(rows_are_numbered_in_the_order_of_their_keys)
{
    const int32_t n = mus_language_row_count();
    ck_assert_int_eq(n, mus__sentences_en.count + mus__names_en.count);
    for (int32_t i = 0; i < n; i++) {
        const char *key = mus_language_row_key(i);
        ck_assert(i == 0 || strcmp(mus_language_row_key(i - 1), key) < 0);
        ck_assert_ptr_nonnull(mus_language_text(MUS_LANGUAGE_ENGLISH, key));
    }
    ck_assert_ptr_null(mus_language_row_key(-1));
    ck_assert_ptr_null(mus_language_row_key(n));
    ck_assert_ptr_null(mus_language_text(0, "no.row"));
    ck_assert_ptr_null(mus_language_text(0, NULL));
    ck_assert_ptr_null(mus_language_text(-1, "list.comma"));
    ck_assert_ptr_null(mus_language_text(mus_language_count(), "list.comma"));
}
END_TEST


START_TEST(tags_of_both_kinds_are_read)
{
    static const struct {
        const char *tag, *language;
    } tags[] = {{NULL, "en"},    {"", "en"},           {"C", "en"},     {"C.UTF-8", "en"}, {"POSIX", "en"},
                {"en_GB", "en"}, {"de", "de"},         {"de-AT", "de"}, {"DE", "de"},      {"de_DE.UTF-8@euro", "de"},
                {"pt-BR", "pt"}, {"pt_BR.UTF-8", "pt"}, {"ja", "ja"},    {"ar_EG", "ar"},   {"th_TH", "th"},
                {"fr", "fr"},    {"es-419", "es"},     {"it", NULL},    {"deu", NULL},     {"d", NULL},
                {"-de", NULL},   {"german", NULL},     {"c", NULL}};
    for (size_t i = 0; i < sizeof tags / sizeof tags[0]; i++) {
        const int32_t language = mus_language_find(tags[i].tag);
        if (tags[i].language == NULL) ck_assert_msg(language == MUS_NONE, "%s", tags[i].tag);
        else ck_assert_str_eq(mus_language_tag(language), tags[i].language);
    }
    for (int32_t l = 0; l < mus_language_count(); l++) {
        ck_assert_int_eq(mus_language_find(mus_language_tag(l)), l);
        ck_assert_int_eq(mus_language_is_right_to_left(l), strcmp(mus_language_tag(l), "ar") == 0);
        ck_assert_ptr_nonnull(mus_language_name(l));
    }
    ck_assert_ptr_null(mus_language_tag(-1));
    ck_assert_ptr_null(mus_language_name(mus_language_count()));
    ck_assert_int_eq(mus_language_is_right_to_left(99), 0);
}
END_TEST


/* is a language written in another script than English? */
static bool foreign(int32_t language)
{
    return strstr("ja ar th", mus_language_tag(language)) != NULL;
}


/* the first word of small Latin letters, of two letters or more; "" without one */
static const char *latin_word(const char *text)
{
    static char word[64];
    for (; *text != '\0'; text++) {
        const size_t n = strspn(text, "abcdefghijklmnopqrstuvwxyz");
        if (n > 1 && strncmp(text, "cm", n) != 0 && strncmp(text, "mm", n) != 0) {
            snprintf(word, sizeof word, "%.*s", (int)n, text);
            return word;
        }
    }
    return "";
}


START_TEST(every_named_design_has_a_title_in_every_language)
{
    char title[256], other[256];
    for (int32_t d = 0; d < mus_design_count(); d++)
        for (int32_t l = 1; l < mus_language_count(); l++) {
            const char *english = mus_design_title(d);
            ck_assert_msg(mus_language_compose(l, "title", english, title, sizeof title) != 0, "%s: %s: %s",
                          mus_language_tag(l), english, title);
            if (foreign(l)) ck_assert_msg(latin_word(title)[0] == '\0', "%s: %s", english, title);
            /* designs that are told apart in English are told apart */
            if (d == 0 || strcmp(mus_design_title(d - 1), english) == 0) continue;
            mus_language_compose(l, "title", mus_design_title(d - 1), other, sizeof other);
            ck_assert_msg(strcmp(title, other) != 0, "%s and %s: %s", english, mus_design_title(d - 1), title);
        }
    for (int32_t m = 0; m < mus_measure_count(); m++)
        for (int32_t l = 1; l < mus_language_count(); l++)
            ck_assert_msg(mus_language_compose(l, "measure", mus_measure_name(m), title, sizeof title) != 0, "%s: %s",
                          mus_language_tag(l), mus_measure_name(m));
}
END_TEST


static void check_name(const char *kind, const char *name, const char *design)
{
    char text[256];
    for (int32_t l = 1; l < mus_language_count(); l++) {
        ck_assert_msg(mus_language_compose(l, kind, name, text, sizeof text) != 0, "%s: %s %s of %s",
                      mus_language_tag(l), kind, name, design);
        if (foreign(l)) ck_assert_msg(latin_word(text)[0] == '\0', "%s %s: %s", kind, name, text);
    }
}


/* names of panels and the words of edges of a pattern, and the captions of its marks */
static void check_names(const mus_pattern *pattern, const char *design)
{
    char words[MUS__PLAIN];
    for (int32_t i = 0; i < mus_pattern_panel_count(pattern); i++) {
        check_name("panel", mus_pattern_panel_name(pattern, i), design);
        mus__plain_words(mus_pattern_panel_name(pattern, i), true, words);
        check_name("panel", words, design);
    }
    for (int32_t i = 0; i < mus_pattern_edge_count(pattern); i++) {
        mus__plain_edge_words(pattern, i, words);
        check_name("edge", words, design);
    }
    for (int32_t i = 0; i < mus_pattern_mark_count(pattern); i++) {
        const char *name = "";
        char key[64];
        mus_pattern_mark(pattern, i, NULL, &name, NULL, NULL);
        snprintf(key, sizeof key, "mark.%s", name);
        ck_assert_msg(mus_language_text(0, key) != NULL, "%s of %s", key, design);
    }
}


static mus_pattern *draft(mus_context *context, int32_t design)
{
    mus_pattern *pattern = NULL;
    for (int32_t s = 0; s < 3 && pattern == NULL; s++) {
        mus_tape *tape = drafts_tape(context, sizes[s]);
        mus_design_draft(context, design, tape, NULL, &pattern);
        mus_tape_destroy(tape);
    }
    ck_assert_ptr_nonnull(pattern);
    return pattern;
}


START_TEST(every_panel_and_edge_of_every_design_has_a_name_in_every_language)
{
    mus_context *context = support_context();
    for (int32_t d = 0; d < mus_design_count(); d += SUPPORT_SLOW ? 11 : 1) {
        mus_pattern *pattern = draft(context, d);
        check_names(pattern, mus_design_name(d));
        if (mus_pattern_cut_only(pattern) != NULL) check_names(mus_pattern_cut_only(pattern), mus_design_name(d));
        mus_pattern_destroy(pattern);
    }
    support_context_end(context);
}
END_TEST


static int32_t line_count(const char *text, size_t size)
{
    int32_t n = 0;
    for (size_t i = 0; i < size; i++) n += text[i] == '\n';
    return n;
}


START_TEST(instructions_say_the_same_in_every_language)
{
    mus_context *context = support_context();
    for (int32_t d = 0; d < mus_design_count(); d += SUPPORT_SLOW ? 400 : 60) {
        mus_pattern *pattern = draft(context, d);
        char *english, *bytes, title[256];
        size_t size, n;
        ck_assert_int_eq(mus_pattern_write_instructions_bytes(pattern, mus_design_title(d), &english, &size), MUS_OK);
        for (int32_t l = 0; l < mus_language_count(); l++) {
            mus_language_compose(l, "title", mus_design_title(d), title, sizeof title);
            ck_assert_int_eq(
                mus_pattern_write_instructions_in_bytes(pattern, mus_language_tag(l), title, &bytes, &n), MUS_OK);
            char *text = calloc(n + 1, 1);
            memcpy(text, bytes, n);
            if (l == 0) ck_assert(n == size && memcmp(bytes, english, n) == 0);
            ck_assert_int_eq(line_count(bytes, n), line_count(english, size));
            ck_assert_msg(strchr(text, '{') == NULL && strchr(text, '}') == NULL, "%s: %s", mus_design_name(d), text);
            if (foreign(l))
                ck_assert_msg(latin_word(text)[0] == '\0', "%s: \"%s\" of %s", mus_language_tag(l), latin_word(text),
                              mus_design_name(d));
            free(text);
            mus_context_alloc(context, bytes, 0);
        }
        mus_context_alloc(context, english, 0);
        mus_pattern_destroy(pattern);
    }
    support_context_end(context);
}
END_TEST


/* words of pieces that designs do not have today are rows already, alone and of another piece */
START_TEST(pieces_to_come_have_words)
{
    static const char *const names[] = {
        "pocket_bag", "pocket_bag_left", "welt", "pocket_welt", "flap", "pocket_flap", "placket", "sleeve_placket",
        "tie", "tie_left", "lining", "front_lining", "back_left_lining", "sleeve_lining", "skirt_back_lining",
        "underlap", "overlap", "waistband", "collar_stand", "top_collar", "under_collar", "hood_lining",
        "front_interfacing", "leg_front_left_pocket_bag", "hem_facing", "zip_guard", "belt", "cuff_lining",
        "back_neck_facing", "under_collar_leaf", "under_collar_left", "tie_long", "welt_bag", "pocket_facing_right"};
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) check_name("panel", names[i], "none");
    for (int32_t l = 0; l < mus_language_count(); l++) {
        ck_assert_ptr_nonnull(mus_language_text(l, "layout.title"));
        ck_assert_ptr_nonnull(mus_language_text(l, "layout.fold"));
        ck_assert_ptr_nonnull(mus_language_text(l, "layout.selvedge"));
    }
}
END_TEST


START_TEST(names_are_composed_by_the_language)
{
    static const struct {
        const char *tag, *kind, *words, *text;
        int32_t whole;
    } names[] = {
        {"de", "panel", "sleeve_left", "Ärmel links", 1},
        {"de", "panel", "front armhole facing", "Armausschnittbeleg Vorderteil", 1},
        {"ja", "panel", "front_left_facing", "左前身頃見返し", 1},
        {"de", "panel", "gore2_right", "Rockbahn 2 rechts", 1},
        {"fr", "title", "Blouse, V neck, short sleeves", "Chemisier, encolure en V, manches courtes", 1},
        {"ja", "title", "Blouse, V neck, short sleeves", "ブラウス、Vネック、半袖", 1},
        {"de", "title", "Blouse, a wonder", "Bluse, a wonder", 0},
        {"de", "panel", "my_own_piece", "my own piece", 0},
        {"de", "panel", "left", "left", 0},
        {"en", "panel", "sleeve_left", "sleeve left", 1},
        {"en", "title", "Blouse, V neck", "Blouse, V neck", 1},
        {"es", "measure", "back_waist", "largo de talle espalda", 1},
        {"es", "measure", "unknown", "unknown", 0},
        {"th", "nothing", "front", "front", 0},
    };
    char text[256];
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        const int32_t l = mus_language_find(names[i].tag);
        ck_assert_int_eq(mus_language_compose(l, names[i].kind, names[i].words, text, sizeof text), names[i].whole);
        ck_assert_str_eq(text, names[i].text);
    }
    ck_assert_int_eq(mus_language_compose(99, "panel", "front", text, sizeof text), 0);
    ck_assert_str_eq(text, "");
    ck_assert_int_eq(mus_language_compose(1, NULL, "front", text, sizeof text), 0);
    ck_assert_int_eq(mus_language_compose(1, "panel", NULL, text, sizeof text), 0);
    ck_assert_int_eq(mus_language_compose(1, "panel", "front", NULL, 0), 0);
    ck_assert_int_eq(mus_language_compose(1, "panel", "front", text, 0), 0);
}
END_TEST


/* a text that is cut stays UTF-8, at every length, and no byte beyond its room is written */
START_TEST(what_is_too_long_is_cut_between_letters)
{
    char whole[256], text[256];
    for (int32_t l = 0; l < mus_language_count(); l++) {
        const char *title = "Three-quarter circle skirt with elastic, midi";
        mus_language_compose(l, "title", title, whole, sizeof whole);
        for (size_t size = 1; size < sizeof text; size++) {
            memset(text, 'x', sizeof text);
            mus_language_compose(l, "title", title, text, size);
            const size_t n = strlen(text);
            ck_assert(n < size && strncmp(text, whole, n) == 0 && ((unsigned char)whole[n] & 0xC0) != 0x80);
            ck_assert(size + 3 > strlen(whole) || n + 4 >= size);
            ck_assert(text[size] == 'x');
            mus__phrase phrase = mus__phrase_in(l);
            mus__phrase_text(&phrase, 0, whole);
            mus__phrase_write(&phrase, "paper.person", text, size);
            ck_assert(strlen(text) < size && ((unsigned char)text[strlen(text)] & 0xC0) != 0x80);
        }
    }
    memset(whole, 'a', sizeof whole - 1);
    whole[sizeof whole - 1] = '\0';
    for (size_t i = 7; i < sizeof whole - 1; i += 8) whole[i] = '_';
    ck_assert_int_eq(mus_language_compose(1, "panel", whole, text, sizeof text), 0); /* more words than a name has */
}
END_TEST


START_TEST(an_unknown_language_is_refused_by_name)
{
    mus_context *context = support_context();
    mus_pattern *pattern = draft(context, mus_design_find("skirt"));
    mus_sheet *sheet;
    mus_sheet_def def;
    char *bytes;
    size_t size;
    mus_sheet_def_init(&def, sizeof def);
    ck_assert_ptr_null(def.language);
    def.language = "tlh";
    ck_assert_int_eq(mus_sheet_create(context, pattern, &def, &sheet), MUS_ERR_ARG);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "\"tlh\" is unknown; expected one of en, de, fr"));
    ck_assert_int_eq(mus_pattern_write_instructions_in_bytes(pattern, "tlh", NULL, &bytes, &size), MUS_ERR_ARG);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "mus_pattern_write_instructions_in_bytes"));
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_language(void);
Suite *mus_suite_language(void)
{
    Suite *suite = suite_create("language");
    TCase *tcase = tcase_create("language");
    tcase_set_timeout(tcase, 120.0);
    tcase_add_test(tcase, every_language_has_every_row_with_its_places);
    tcase_add_test(tcase, rows_are_numbered_in_the_order_of_their_keys);
    tcase_add_test(tcase, tags_of_both_kinds_are_read);
    tcase_add_test(tcase, every_named_design_has_a_title_in_every_language);
    tcase_add_test(tcase, every_panel_and_edge_of_every_design_has_a_name_in_every_language);
    tcase_add_test(tcase, instructions_say_the_same_in_every_language);
    tcase_add_test(tcase, pieces_to_come_have_words);
    tcase_add_test(tcase, names_are_composed_by_the_language);
    tcase_add_test(tcase, what_is_too_long_is_cut_between_letters);
    tcase_add_test(tcase, an_unknown_language_is_refused_by_name);
    suite_add_tcase(suite, tcase);
    return suite;
}
