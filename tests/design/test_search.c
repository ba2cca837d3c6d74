/*
 * test_search.c: named designs found by what people type: plurals, slips, joined words, synonyms, groups, conditions;
 * refusals; every allocation that fails. Shares of long lists of phrases: tests/design/phrases.py.
 */
#include <string.h>

#include "design/search_text.h"
#include "muslin/muslin.h"
#include "support.h"

#define ROOM 8


/* the first design that a phrase finds, "" for none */
static const char *first_of(const char *phrase)
{
    int32_t found[ROOM], count = -1;
    double score[ROOM];
    mus_context *context = support_context();
    ck_assert_msg(mus_design_search(context, phrase, ROOM, found, score, &count) == MUS_OK, "%s: %s", phrase,
                  mus_context_error(context));
    ck_assert_int_ge(count, 0);
    for (int32_t i = 0; i < count && i < ROOM; i++) {
        ck_assert(score[i] > 0.0 && score[i] <= 1.0);
        ck_assert(i == 0 || score[i] <= score[i - 1]);
    }
    support_context_end(context);
    return count > 0 ? mus_design_name(found[0]) : "";
}


START_TEST(a_name_finds_itself)
{
    for (int32_t d = 0; d < mus_design_count(); d += 17)
        ck_assert_str_eq(first_of(mus_design_name(d)), mus_design_name(d));
}
END_TEST


START_TEST(what_people_type_finds_its_design)
{
    static const char *const list[][2] = {
        {"pencil skirts", "pencil_skirt_knee"}, /* plural */
        {"PENCIL-SKIRT, mini", "pencil_skirt_mini"},
        {"pencilskirt mini", "pencil_skirt_mini"}, /* joined */
        {"boot cut jeans", "jeans_bootcut"}, /* split */
        {"pecnil skrit mini", "pencil_skirt_mini"}, /* slips of the keys */
        {"sweatpants", "joggers"}, /* another word */
        {"v neck tee", "tee_v"},
        {"men's jeans bootcut", "jeans_bootcut"},
        {"black sheath dress", "sheath"}, /* a colour chooses nothing */
        {"hoodie with zip", "hoodie_zip"}, /* the head stands before the preposition */
        {"kil", "kilt"}, /* a beginning */
        {"xyzzy", ""},
        {"", ""},
        {"kids xyzzy", ""}, /* whom it is for alone finds nothing when there is more */
    };
    for (size_t i = 0; i < sizeof list / sizeof *list; i++)
        ck_assert_msg(strcmp(first_of(list[i][0]), list[i][1]) == 0, "\"%s\" finds \"%s\"", list[i][0],
                      first_of(list[i][0]));
}
END_TEST


START_TEST(conditions_hold_for_all_that_is_found)
{
    int32_t found[ROOM], count;
    mus_context *context = support_context();
    ck_assert_int_eq(mus_design_search(context, "skirt length=maxi skirt=half", ROOM, found, NULL, &count), MUS_OK);
    ck_assert_int_gt(count, 0);
    for (int32_t i = 0; i < count && i < ROOM; i++) {
        ck_assert_ptr_nonnull(strstr(mus_design_words(found[i]), "length=maxi"));
        ck_assert_ptr_nonnull(strstr(mus_design_words(found[i]), "skirt=half"));
    }

    /* a first option is left out of the words, and conditions alone find all that meet them */
    ck_assert_int_eq(mus_design_search(context, "garment=skirt length=knee", ROOM, found, NULL, &count), MUS_OK);
    ck_assert_int_gt(count, ROOM);
    ck_assert_int_eq(mus_design_search(context, "skirt length=wide", ROOM, found, NULL, &count), MUS_ERR_DESIGN);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "knee mini midi"));
    ck_assert_int_eq(mus_design_search(context, "skirt colour=red", ROOM, found, NULL, &count), MUS_ERR_DESIGN);
    ck_assert_int_eq(count, 0);
    support_context_end(context);
}
END_TEST


START_TEST(bad_arguments_and_long_phrases_do_no_harm)
{
    char phrase[4000];
    int32_t found[ROOM], count;
    mus_context *context = support_context();
    ck_assert_int_eq(mus_design_search(NULL, "skirt", 0, NULL, NULL, &count), MUS_ERR_ARG);
    ck_assert_int_eq(mus_design_search(context, NULL, 0, NULL, NULL, &count), MUS_ERR_ARG);
    ck_assert_int_eq(mus_design_search(context, "skirt", 1, NULL, NULL, &count), MUS_ERR_ARG);
    ck_assert_int_eq(mus_design_search(context, "skirt", -1, found, NULL, &count), MUS_ERR_ARG);
    ck_assert_int_eq(mus_design_search(context, "skirt", 0, NULL, NULL, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_design_search(context, "skirt", 0, NULL, NULL, &count), MUS_OK);
    ck_assert_int_gt(count, ROOM);
    memset(phrase, 'x', sizeof phrase);
    phrase[sizeof phrase - 1] = '\0';
    ck_assert_int_eq(mus_design_search(context, phrase, ROOM, found, NULL, &count), MUS_OK);
    for (size_t i = 0; i + 7 < sizeof phrase; i += 6) memcpy(phrase + i, "skirt ", 6);
    ck_assert_int_eq(mus_design_search(context, phrase, ROOM, found, NULL, &count), MUS_OK);
    ck_assert_int_gt(count, 0);
    ck_assert_int_eq(mus_design_search(context, "\xff\xfe \xc3\xa9t\xc3\xa9 '", ROOM, found, NULL, &count), MUS_OK);
    support_context_end(context);
}
END_TEST


START_TEST(each_failing_allocation_is_a_status)
{
    int32_t found[ROOM], count;
    mus_status status = MUS_ERR_MEMORY;
    for (int64_t n = 0; status != MUS_OK; n++) {
        mus_context *context = support_context();
        support_fail_after(n, false);
        status = mus_design_search(context, "pencil skirt", ROOM, found, NULL, &count);
        support_fail_never();
        ck_assert(status == MUS_OK || status == MUS_ERR_MEMORY);
        ck_assert(status == MUS_OK || count == 0);
        support_context_end(context);
    }
}
END_TEST


START_TEST(words_are_compared_by_plural_ending_and_letters)
{
    ck_assert_double_eq(mus__word_like("skirt", "skirt"), 1.0);
    ck_assert(mus__word_like("skirts", "skirt") > mus__word_like("pleated", "pleat"));
    ck_assert(mus__word_like("flared", "flare") > 0.0 && mus__word_like("flaring", "flare") > 0.0);
    ck_assert_double_eq(mus__word_like("sleeve", "sleeveless"), 0.0);
    ck_assert_double_eq(mus__word_like("cap", "cape"), 0.0);
    ck_assert_double_eq(mus__word_like("dres", "dress"), 0.0);
    ck_assert_int_eq(mus__word_distance("", "abc"), 3);
    ck_assert_int_eq(mus__word_distance("little", "litle"), 1);
    ck_assert_int_eq(mus__word_distance("pecnil", "pencil"), 1);
    ck_assert_int_eq(mus__word_distance("kitten", "sitting"), 3);
}
END_TEST


Suite *mus_suite_search(void);
Suite *mus_suite_search(void)
{
    Suite *suite = suite_create("search");
    TCase *search = tcase_create("search");
    tcase_add_test(search, a_name_finds_itself);
    tcase_add_test(search, what_people_type_finds_its_design);
    tcase_add_test(search, conditions_hold_for_all_that_is_found);
    tcase_add_test(search, bad_arguments_and_long_phrases_do_no_harm);
    tcase_add_test(search, each_failing_allocation_is_a_status);
    tcase_add_test(search, words_are_compared_by_plural_ending_and_letters);
    tcase_set_timeout(search, 60);
    suite_add_tcase(suite, search);
    return suite;
}
