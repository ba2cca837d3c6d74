/*
 * test_pattern.c: create, copy, destroy, names; every edit under every failing allocation; every bad argument.
 */
#include <math.h>

#include "muslin/topology.h"
#include "pattern/same.h"


START_TEST(a_copy_is_the_same_to_the_bit_and_apart_from_its_source)
{
    mus_context *context = support_context();
    sample s = sample_make(context);
    mus_pattern *copy, *again;
    ck_assert_int_eq(mus_pattern_copy(s.pattern, &copy), MUS_OK);
    same_pattern(s.pattern, copy);

    /* an edit of one does not show in the other; the source may go first */
    ck_assert_int_eq(mus_pattern_set_grain(copy, s.front, 1.0, 0.0), MUS_OK);
    ck_assert_int_eq(mus_pattern_add_point(copy, s.front, 9.0, 9.0, NULL), MUS_OK);
    double grain[2];
    ck_assert_int_eq(mus_pattern_grain(s.pattern, s.front, grain), MUS_OK);
    ck_assert(grain[0] == 0.0 && grain[1] == 1.0);
    ck_assert_int_eq(mus_pattern_copy(copy, &again), MUS_OK);
    mus_pattern_destroy(s.pattern);
    same_pattern(copy, again);
    mus_pattern_destroy(copy);
    mus_pattern_destroy(again);
    support_context_end(context);
}
END_TEST


START_TEST(a_copy_without_memory_leaves_nothing)
{
    mus_context *context = support_context();
    sample s = sample_make(context);
    size_t bytes = mus_context_bytes(context);
    for (int64_t n = 0;; n++) {
        mus_pattern *copy = s.pattern;
        support_fail_after(n, false);
        mus_status status = mus_pattern_copy(s.pattern, &copy);
        support_fail_never();
        if (status == MUS_OK) {
            same_pattern(s.pattern, copy);
            mus_pattern_destroy(copy);
            ck_assert_int_gt(n, 15);
            break;
        }
        ck_assert_int_eq(status, MUS_ERR_MEMORY);
        ck_assert_ptr_null(copy);
        ck_assert_uint_eq(mus_context_bytes(context), bytes);
    }
    mus_pattern_destroy(s.pattern);
    support_context_end(context);
}
END_TEST


/* ---- every edit, each allocation failing in turn ---- */

static mus_status edit_panel(const sample *s)
{
    return mus_pattern_add_panel(s->pattern, "cuff", NULL);
}
static mus_status edit_point(const sample *s)
{
    return mus_pattern_add_point(s->pattern, s->front, 1.0, 2.0, NULL);
}
static mus_status edit_name(const sample *s)
{
    return mus_pattern_set_name(s->pattern, "other");
}


static mus_status edit_edge(const sample *s)
{
    int32_t kind = MUS_PIECE_CUBIC;
    double xy[4] = {0.1, 0.2, 0.3, 0.4};
    return mus_pattern_add_edge(s->pattern, &(mus_edge_def){.size = sizeof(mus_edge_def), .name = "dart",
                                                            .start = s->point[0], .end = s->point[2], .npiece = 1,
                                                            .kinds = &kind, .nxy = 2, .xy = xy}, NULL);
}


static mus_status edit_outline(const sample *s)
{
    int32_t edges[4] = {s->edge[3], s->edge[2], s->edge[1], s->edge[0]}, back[4] = {-1, -1, -1, -1};
    return mus_pattern_set_outline(s->pattern, s->front, 4, edges, back);
}


static mus_status edit_seam(const sample *s)
{
    mus_seam_def def;
    mus_seam_def_init(&def, sizeof def);
    def.edge_a = s->edge[0], def.edge_b = s->edge[4];
    return mus_pattern_add_seam(s->pattern, &def, NULL);
}


static mus_status edit_notch(const sample *s)
{
    return mus_pattern_add_notch(s->pattern, s->edge[0], 0.2, MUS_NOTCH_TRIPLE, NULL);
}


static mus_status edit_mark(const sample *s)
{
    double xy[2] = {0.1, 0.1};
    return mus_pattern_add_mark(s->pattern, s->front, "button", 1, xy, NULL);
}


static mus_status edit_check(const sample *s)
{
    int32_t count;
    return mus_pattern_check(s->pattern, &count, NULL);
}


static mus_status edit_topology(const sample *s)
{
    mus_topology t;
    mus_topology_init(&t, sizeof t);
    return mus_pattern_topology(s->pattern, &t);
}


static mus_status edit_loop(const sample *s)
{
    return mus_pattern_loop(s->pattern, 0, NULL, 0, NULL, NULL);
}


static mus_status (*const edits[])(const sample *) = {
    edit_panel, edit_point, edit_name,  edit_edge,     edit_outline, edit_seam,
    edit_notch, edit_mark,  edit_check, edit_topology, edit_loop,
};


START_TEST(an_edit_without_memory_leaves_the_pattern_as_it_was)
{
    /* arrays double as they grow: repeat each edit until they have grown at least twice */
    mus_context *context = support_context();
    sample s = sample_make(context);
    int32_t failures = 0, rounds = edits[_i] == edit_panel ? 1 : 30;
    for (int32_t round = 0; round < rounds; round++) {
        mus_pattern *before;
        ck_assert_int_eq(mus_pattern_copy(s.pattern, &before), MUS_OK);
        for (int64_t n = 0;; n++) {
            size_t bytes = mus_context_bytes(context);
            support_fail_after(n, false);
            mus_status status = edits[_i](&s);
            support_fail_never();
            if (status == MUS_OK) break;
            ck_assert_int_eq(status, MUS_ERR_MEMORY);
            ck_assert_str_ne(mus_context_error(context), "");
            ck_assert_uint_eq(mus_context_bytes(context), bytes);
            same_pattern(s.pattern, before);
            failures++;
        }
        mus_pattern_destroy(before);
    }
    if (edits[_i] != edit_name && edits[_i] != edit_panel) ck_assert_int_gt(failures, 0);
    mus_pattern_destroy(s.pattern);
    support_context_end(context);
}
END_TEST


START_TEST(a_pattern_without_memory_is_not_made)
{
    mus_context *context = support_context();
    mus_pattern *pattern = (mus_pattern *)(void *)&context;
    support_fail_after(0, false);
    ck_assert_int_eq(mus_pattern_create(context, "x", &pattern), MUS_ERR_MEMORY);
    support_fail_never();
    ck_assert_ptr_null(pattern);
    support_context_end(context);
}
END_TEST


START_TEST(names_are_utf8_of_at_most_127_bytes)
{
    mus_context *context = support_context();
    mus_pattern *pattern = NULL;
    char longest[129];
    memset(longest, 'a', 128);
    longest[128] = '\0';
    ck_assert_int_eq(mus_pattern_create(context, longest, &pattern), MUS_ERR_ARG);
    ck_assert_ptr_null(pattern);
    longest[127] = '\0';
    ck_assert_int_eq(mus_pattern_create(context, longest, &pattern), MUS_OK);
    ck_assert_str_eq(mus_pattern_name(pattern), longest);

    /* two, three and four bytes; a name that would be cut inside its last letter is refused */
    static const char *good[] = {"\xC3\x84rmel", "\xE8\xA2\x96", "\xF0\x9F\x91\x95", "", NULL};
    static const char *bad[] = {"\xC3", "\xC0\x80", "\xE0\x80\x80", "\xED\xA0\x80", "\xF4\x90\x80\x80",
                                "\x80", "\xFF",     "a\xE8\xA2",    "\xC3\xC3"};
    for (int32_t i = 0; i < 5; i++) {
        ck_assert_int_eq(mus_pattern_set_name(pattern, good[i]), MUS_OK);
        ck_assert_str_eq(mus_pattern_name(pattern), good[i] != NULL ? good[i] : "");
    }
    ck_assert_int_eq(mus_pattern_set_name(pattern, "coat"), MUS_OK);
    for (int32_t i = 0; i < 9; i++) {
        ck_assert_int_eq(mus_pattern_set_name(pattern, bad[i]), MUS_ERR_ARG);
        ck_assert_str_eq(mus_pattern_name(pattern), "coat");
    }
    memset(longest, 'a', 126);
    memcpy(longest + 126, "\xC3\x84", 3);
    ck_assert_int_eq(mus_pattern_set_name(pattern, longest), MUS_ERR_ARG);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


START_TEST(cells_are_found_by_name)
{
    mus_context *context = support_context();
    sample s = sample_make(context);
    ck_assert_int_eq(mus_pattern_find_panel(s.pattern, "sleeve"), s.sleeve);
    ck_assert_int_eq(mus_pattern_find_panel(s.pattern, "slee"), MUS_NONE);
    ck_assert_int_eq(mus_pattern_find_panel(s.pattern, NULL), MUS_NONE);
    ck_assert_int_eq(mus_pattern_find_panel(NULL, "sleeve"), MUS_NONE);
    ck_assert_int_eq(mus_pattern_find_edge(s.pattern, s.front, "side"), s.edge[1]);
    ck_assert_int_eq(mus_pattern_find_edge(s.pattern, s.sleeve, "side"), s.edge[5]);
    ck_assert_int_eq(mus_pattern_find_edge(s.pattern, s.sleeve, "neck"), MUS_NONE);
    ck_assert_int_eq(mus_pattern_find_edge(s.pattern, s.sleeve, ""), MUS_NONE);
    ck_assert_int_eq(mus_pattern_find_edge(s.pattern, s.sleeve, NULL), MUS_NONE);
    ck_assert_int_eq(mus_pattern_find_edge(s.pattern, 5, "side"), MUS_NONE);
    mus_pattern_destroy(s.pattern);
    support_context_end(context);
}
END_TEST


START_TEST(no_pattern_is_an_answer_and_not_a_crash)
{
    mus_context *context = support_context();
    mus_pattern *pattern = NULL;
    mus_pattern_destroy(NULL);
    ck_assert_int_eq(mus_pattern_create(NULL, "x", &pattern), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_create(context, "x", NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_copy(NULL, &pattern), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_set_name(NULL, "x"), MUS_ERR_ARG);
    ck_assert_str_eq(mus_pattern_name(NULL), "");
    int32_t counts = mus_pattern_panel_count(NULL) + mus_pattern_point_count(NULL) + mus_pattern_edge_count(NULL) +
                     mus_pattern_seam_count(NULL) + mus_pattern_notch_count(NULL) + mus_pattern_mark_count(NULL);
    ck_assert_int_eq(counts, 0);
    ck_assert_int_eq(mus_pattern_create(context, "x", &pattern), MUS_OK);
    ck_assert_int_eq(mus_pattern_copy(pattern, NULL), MUS_ERR_ARG);
    ck_assert_ptr_eq(mus_pattern_context(pattern), context);
    ck_assert_ptr_null(mus_pattern_context(NULL));
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


START_TEST(a_thousand_cells_take_few_allocations)
{
    /* growth by half: adding n points moves the array O(log n) times */
    mus_context *context = support_context();
    mus_pattern *pattern;
    int32_t panel;
    ck_assert_int_eq(mus_pattern_create(context, "many", &pattern), MUS_OK);
    ck_assert_int_eq(mus_pattern_add_panel(pattern, "p", &panel), MUS_OK);
    uint64_t before = mus_context_allocations(context);
    for (int32_t i = 0; i < 100000; i++) ck_assert_int_eq(mus_pattern_add_point(pattern, panel, i, -i, NULL), MUS_OK);
    ck_assert_uint_lt(mus_context_allocations(context) - before, 30);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_pattern(void);


Suite *mus_suite_pattern(void)
{
    Suite *suite = suite_create("pattern");
    TCase *tcase = tcase_create("pattern");
    tcase_add_test(tcase, a_copy_is_the_same_to_the_bit_and_apart_from_its_source);
    tcase_add_test(tcase, a_copy_without_memory_leaves_nothing);
    tcase_add_loop_test(tcase, an_edit_without_memory_leaves_the_pattern_as_it_was, 0,
                        (int)(sizeof edits / sizeof edits[0]));
    tcase_add_test(tcase, a_pattern_without_memory_is_not_made);
    tcase_add_test(tcase, names_are_utf8_of_at_most_127_bytes);
    tcase_add_test(tcase, cells_are_found_by_name);
    tcase_add_test(tcase, no_pattern_is_an_answer_and_not_a_crash);
    tcase_add_test(tcase, a_thousand_cells_take_few_allocations);
    suite_add_tcase(suite, tcase);
    return suite;
}
