/*
 * test_design.c: the list of designs, options of a draft and their refusal, drafts twice the same, every failing
 * allocation.
 */
#include <string.h>

#include "block/drafts.h"
#include "muslin/topology.h"


START_TEST(designs_have_names_and_are_found)
{
    ck_assert_int_ge(mus_design_count(), 5);
    for (int32_t d = 0; d < mus_design_count(); d++) {
        ck_assert_ptr_nonnull(mus_design_name(d));
        ck_assert_ptr_nonnull(mus_design_family(d));
        ck_assert_ptr_nonnull(mus_design_title(d));
        ck_assert_int_eq(mus_design_find(mus_design_name(d)), d);
    }
    const int32_t outside[] = {-1, INT32_MIN, INT32_MAX, mus_design_count()};
    for (int i = 0; i < 4; i++) {
        ck_assert_ptr_null(mus_design_name(outside[i]));
        ck_assert_ptr_null(mus_design_family(outside[i]));
        ck_assert_ptr_null(mus_design_title(outside[i]));
    }
    ck_assert_int_eq(mus_design_find("toga"), MUS_NONE);
    ck_assert_int_eq(mus_design_find(""), MUS_NONE);
    ck_assert_int_eq(mus_design_find(NULL), MUS_NONE);
}
END_TEST


static mus_status design_with(mus_context *context, const char *design, const char *size, const mus_draft_def *def,
                              mus_pattern **out)
{
    mus_tape *tape = drafts_tape(context, size);
    const mus_status status = mus_design_draft(context, mus_design_find(design), tape, def, out);
    mus_tape_destroy(tape);
    return status;
}


START_TEST(options_take_effect)
{
    mus_context *context = support_context();
    mus_draft_def def;
    mus_pattern *own, *plain, *wide;
    mus_draft_def_init(&def, sizeof def);
    ck_assert_int_eq(design_with(context, "tshirt", "W40", NULL, &own), MUS_OK);
    ck_assert_int_eq(design_with(context, "tshirt", "W40", &def, &plain), MUS_OK);
    ck_assert_double_eq(drafts_length(own, "front", "side"), drafts_length(plain, "front", "side"));

    /* an ease of 24 cm on the bust is 16 cm more than the design's own, so that of the hip is 20 cm; the hem clears
     * both. The length is that of the caller */
    def.ease = 0.24, def.length = 0.35, def.sleeve = 0.30;
    ck_assert_int_eq(design_with(context, "tshirt", "W40", &def, &wide), MUS_OK);
    const mus__measures measures = drafts_measures(context, "W40");
    ck_assert_double_eq_tol(drafts_length(wide, "front", "hem") + drafts_length(wide, "back", "hem"),
                            fmax(measures.v[MUS_MEASURE_BUST] + 0.24, measures.v[MUS_MEASURE_HIP] + 0.20), 1e-9);
    ck_assert_double_gt(drafts_length(wide, "sleeve_left", "underF"),
                        drafts_length(own, "sleeve_left", "underF") + 0.05);
    double xy[2];
    int32_t start, panel;
    ck_assert_int_eq(mus_pattern_edge_ends(wide, drafts_edge(wide, "front", "hem"), &start, NULL), MUS_OK);
    ck_assert_int_eq(mus_pattern_point(wide, start, &panel, xy), MUS_OK);
    ck_assert_double_eq(xy[1], -0.35);
    mus_pattern_destroy(own);
    mus_pattern_destroy(plain);
    mus_pattern_destroy(wide);
    support_context_end(context);
}
END_TEST


START_TEST(refused_options_name_item_value_and_limit)
{
    static const struct {
        double ease, length, sleeve;
        const char *words[2];
    } list[] = {
        {-0.6, NAN, NAN, {"ease", "-0.5"}},      {1.1, NAN, NAN, {"ease", "1.1"}},
        {INFINITY, NAN, NAN, {"ease", "inf"}},   {NAN, 0.0, NAN, {"length", "0.02"}},
        {NAN, 1e9, NAN, {"length", "2.5"}},      {NAN, -INFINITY, NAN, {"length", "inf"}},
        {NAN, NAN, -0.1, {"sleeve", "-0.1"}},    {NAN, NAN, 1.3, {"sleeve", "1.2"}},
    };
    mus_context *context = support_context();
    for (size_t i = 0; i < sizeof list / sizeof list[0]; i++) {
        mus_draft_def def;
        mus_pattern *pattern = (mus_pattern *)&def;
        mus_draft_def_init(&def, sizeof def);
        def.ease = list[i].ease, def.length = list[i].length, def.sleeve = list[i].sleeve;
        ck_assert_int_eq(design_with(context, "tshirt", "M50", &def, &pattern), MUS_ERR_ARG);
        ck_assert_ptr_null(pattern);
        for (int w = 0; w < 2; w++)
            ck_assert_msg(strstr(mus_context_error(context), list[i].words[w]) != NULL, "case %zu: %s", i,
                          mus_context_error(context));
    }
    support_context_end(context);
}
END_TEST


/* options within their ranges that give no garment: MUS_ERR_DESIGN with the measures, or a fit pattern, never else */
START_TEST(any_allowed_option_drafts_or_is_refused_with_reason)
{
    mus_context *context = support_context();
    uint64_t state = 11;
    int32_t drafted = 0, refused = 0;
    for (int i = 0; i < 400; i++) {
        mus_draft_def def;
        mus_pattern *pattern;
        mus_draft_def_init(&def, sizeof def);
        def.ease = support_uniform(&state, -0.5, 1.0);
        def.length = support_uniform(&state, 0.02, 2.5);
        def.sleeve = support_uniform(&state, 0.02, 1.2);
        const int32_t design = (int32_t)(support_random(&state) % (uint64_t)FIRST);
        const char *size = mus_tape_size_name((int32_t)(support_random(&state) % 28));
        const mus_status status = design_with(context, mus_design_name(design), size, &def, &pattern);
        if (status == MUS_OK) {
            int32_t faults;
            ck_assert_int_eq(mus_pattern_check(pattern, &faults, NULL), MUS_OK);
            ck_assert_int_eq(faults, 0);
            drafted++;
        } else {
            ck_assert_msg(status == MUS_ERR_DESIGN, "%s of %s, ease %g length %g sleeve %g: status %d %s",
                          mus_design_name(design), size, def.ease, def.length, def.sleeve, status,
                          mus_context_error(context));
            ck_assert_uint_gt(strlen(mus_context_error(context)), 10);
            ck_assert_ptr_null(pattern);
            refused++;
        }
        mus_pattern_destroy(pattern);
    }
    ck_assert_int_gt(drafted, 100);
    ck_assert_int_gt(refused, 20);
    support_context_end(context);
}
END_TEST


/* a head that no neckline passes is named, with the neck */
START_TEST(a_head_that_does_not_pass_is_refused)
{
    mus_context *context = support_context();
    mus_tape *tape = drafts_tape(context, "C104");
    mus_pattern *pattern;
    ck_assert_int_eq(mus_tape_set(tape, MUS_MEASURE_HEAD, 0.90, MUS_SOURCE_GIVEN), MUS_OK);
    ck_assert_int_eq(mus_design_draft(context, mus_design_find("tshirt"), tape, NULL, &pattern), MUS_ERR_DESIGN);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "head"));
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "neck"));
    ck_assert_ptr_null(pattern);
    mus_tape_destroy(tape);
    support_context_end(context);
}
END_TEST


START_TEST(bad_arguments_are_refused)
{
    mus_context *context = support_context();
    mus_tape *tape = drafts_tape(context, "W40");
    mus_pattern *pattern;
    mus_draft_def def;
    mus_draft_def_init(&def, sizeof def);
    ck_assert_int_eq(mus_design_draft(NULL, 0, tape, NULL, &pattern), MUS_ERR_ARG);
    ck_assert_int_eq(mus_design_draft(context, 0, NULL, NULL, &pattern), MUS_ERR_ARG);
    ck_assert_int_eq(mus_design_draft(context, 0, tape, NULL, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_design_draft(context, -1, tape, NULL, &pattern), MUS_ERR_ARG);
    ck_assert_int_eq(mus_design_draft(context, mus_design_count(), tape, NULL, &pattern), MUS_ERR_ARG);
    ck_assert_ptr_null(pattern);
    def.size = 0;
    ck_assert_int_eq(mus_design_draft(context, 0, tape, &def, &pattern), MUS_ERR_VERSION);
    ck_assert_ptr_null(pattern);
    mus_draft_def_init(NULL, sizeof def);
    mus_tape_destroy(tape);
    support_context_end(context);
}
END_TEST


/* the tape is completed on a copy; one that cannot be completed says why, also through a context of its own */
START_TEST(an_incomplete_tape_is_completed_on_a_copy)
{
    mus_context *context = support_context(), *other = support_context();
    mus_tape *tape;
    mus_pattern *pattern;
    ck_assert_int_eq(mus_tape_create(other, &tape), MUS_OK);
    ck_assert_int_eq(mus_design_draft(context, 0, tape, NULL, &pattern), MUS_ERR_TAPE);
    ck_assert_uint_gt(strlen(mus_context_error(context)), 10);
    ck_assert_int_eq(mus_tape_set_size(tape, "W40"), MUS_OK);
    ck_assert_int_eq(mus_design_draft(context, 0, tape, NULL, &pattern), MUS_OK);
    ck_assert_int_eq(mus_tape_is_complete(tape), 0);
    ck_assert_int_eq(mus_tape_source(tape, MUS_MEASURE_NECK), MUS_SOURCE_NONE);
    ck_assert_ptr_eq(mus_pattern_context(pattern), context);
    mus_tape_destroy(tape);
    mus_pattern_destroy(pattern);
    support_context_end(other);
    support_context_end(context);
}
END_TEST


static void design_same_edges(const mus_pattern *a, const mus_pattern *b)
{
    ck_assert_int_eq(mus_pattern_edge_count(a), mus_pattern_edge_count(b));
    for (int32_t e = 0; e < mus_pattern_edge_count(a); e++) {
        int32_t na, nb, xa, xb;
        const int32_t *ka, *kb;
        const double *pa, *pb;
        ck_assert_int_eq(mus_pattern_edge_pieces(a, e, &na, &ka, &xa, &pa), MUS_OK);
        ck_assert_int_eq(mus_pattern_edge_pieces(b, e, &nb, &kb, &xb, &pb), MUS_OK);
        ck_assert_int_eq(na, nb);
        ck_assert_int_eq(xa, xb);
        ck_assert_mem_eq(ka, kb, (size_t)na * sizeof *ka);
        ck_assert_mem_eq(pa, pb, 2 * (size_t)xa * sizeof *pa);
        ck_assert_str_eq(mus_pattern_edge_name(a, e), mus_pattern_edge_name(b, e));
        ck_assert_str_eq(mus_pattern_edge_label(a, e), mus_pattern_edge_label(b, e));
        const double wa = mus_pattern_edge_allowance(a, e), wb = mus_pattern_edge_allowance(b, e);
        ck_assert_mem_eq(&wa, &wb, sizeof wa);
    }
}


static void design_same_rest(const mus_pattern *a, const mus_pattern *b)
{
    ck_assert_int_eq(mus_pattern_panel_count(a), mus_pattern_panel_count(b));
    for (int32_t p = 0; p < mus_pattern_panel_count(a); p++) {
        mus_placement pa, pb;
        mus_placement_init(&pa, sizeof pa);
        mus_placement_init(&pb, sizeof pb);
        ck_assert_str_eq(mus_pattern_panel_name(a, p), mus_pattern_panel_name(b, p));
        ck_assert_int_eq(mus_pattern_placement(a, p, &pa), MUS_OK);
        ck_assert_int_eq(mus_pattern_placement(b, p, &pb), MUS_OK);
        ck_assert_mem_eq(&pa, &pb, sizeof pa);
    }
    ck_assert_int_eq(mus_pattern_seam_count(a), mus_pattern_seam_count(b));
    for (int32_t s = 0; s < mus_pattern_seam_count(a); s++) {
        mus_seam_def sa, sb;
        mus_seam_def_init(&sa, sizeof sa);
        mus_seam_def_init(&sb, sizeof sb);
        ck_assert_int_eq(mus_pattern_seam(a, s, &sa), MUS_OK);
        ck_assert_int_eq(mus_pattern_seam(b, s, &sb), MUS_OK);
        ck_assert_int_eq(sa.edge_a, sb.edge_a);
        ck_assert_int_eq(sa.edge_b, sb.edge_b);
    }
    ck_assert_int_eq(mus_pattern_notch_count(a), mus_pattern_notch_count(b));
    for (int32_t n = 0; n < mus_pattern_notch_count(a); n++) {
        int32_t ea, eb, ka, kb;
        double sa, sb;
        ck_assert_int_eq(mus_pattern_notch(a, n, &ea, &sa, &ka), MUS_OK);
        ck_assert_int_eq(mus_pattern_notch(b, n, &eb, &sb, &kb), MUS_OK);
        ck_assert_int_eq(ea, eb);
        ck_assert_int_eq(ka, kb);
        ck_assert_mem_eq(&sa, &sb, sizeof sa);
    }
}


START_TEST(a_draft_made_twice_is_the_same_to_the_bit)
{
    mus_context *context = support_context();
    for (int32_t d = 0; d < mus_design_count(); d += d < FIRST ? 1 : 7) {
        if ((mus_design_groups(d) & MUS_GROUP_WOMEN) == 0) continue;
        mus_pattern *a = drafts_pattern(context, mus_design_name(d), "W44");
        mus_pattern *b = drafts_pattern(context, mus_design_name(d), "W44");
        design_same_edges(a, b);
        design_same_rest(a, b);
        mus_pattern_destroy(a);
        mus_pattern_destroy(b);
    }
    support_context_end(context);
}
END_TEST


START_TEST(each_failing_allocation_leaves_nothing)
{
    static const char *const named[] = {"oxford_shirt", "jeans_flare", "wrap_dress", "jumpsuit_halter_wide"};
    const int32_t design = _i < FIRST ? _i : mus_design_find(named[_i - FIRST]);
    for (int64_t n = 0;; n++) {
        mus_context *context = support_context();
        mus_tape *tape;
        mus_pattern *pattern;
        ck_assert_int_eq(mus_tape_create(context, &tape), MUS_OK);
        ck_assert_int_eq(mus_tape_set_size(tape, "W40"), MUS_OK);
        support_fail_after(n, false);
        const mus_status status = mus_design_draft(context, design, tape, NULL, &pattern);
        support_fail_never();
        if (status != MUS_OK) ck_assert_ptr_null(pattern);
        mus_pattern_destroy(pattern);
        mus_tape_destroy(tape);
        support_context_end(context);
        if (status == MUS_OK) break;
        ck_assert_int_eq(status, MUS_ERR_MEMORY);
        ck_assert_int_lt(n, 100000);
    }
    ck_assert_int_gt(support_refused(), 5);
}
END_TEST


Suite *mus_suite_design(void)
{
    Suite *suite = suite_create("design");
    TCase *tcase = tcase_create("design");
    tcase_set_timeout(tcase, 60.0);
    tcase_add_test(tcase, designs_have_names_and_are_found);
    tcase_add_test(tcase, options_take_effect);
    tcase_add_test(tcase, refused_options_name_item_value_and_limit);
    tcase_add_test(tcase, any_allowed_option_drafts_or_is_refused_with_reason);
    tcase_add_test(tcase, a_head_that_does_not_pass_is_refused);
    tcase_add_test(tcase, bad_arguments_are_refused);
    tcase_add_test(tcase, an_incomplete_tape_is_completed_on_a_copy);
    tcase_add_test(tcase, a_draft_made_twice_is_the_same_to_the_bit);
    tcase_add_loop_test(tcase, each_failing_allocation_leaves_nothing, 0, FIRST + 4);
    suite_add_tcase(suite, tcase);
    return suite;
}
