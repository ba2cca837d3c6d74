/*
 * test_refused_pattern.c: numbers that are not finite at every door of a pattern and of a draft:
 * refused with a sentence, and the pattern is as it was, to the bit.
 */
#include "muslin/design.h"
#include "pattern/same.h"
#include "refused.h"

/* mus_design_grade_apply: any number of any rule */
START_TEST(an_infinite_rule_of_a_grade_is_refused_with_its_panel)
{
    static const double bad[3] = {NAN, INFINITY, -INFINITY};
    mus_context *context = support_context();
    mus_tape *tape;
    mus_pattern *pattern, *out;
    ck_assert_int_eq(mus_tape_create(context, &tape), MUS_OK);
    ck_assert_int_eq(mus_tape_set_size(tape, "W40"), MUS_OK);
    ck_assert_int_eq(mus_design_draft(context, mus_design_find("skirt_plain"), tape, NULL, &pattern), MUS_OK);
    const int32_t n = 2 * mus_pattern_point_count(pattern);
    for (int32_t i = 0; i < n; i++) {
        double rules[64] = {0.0};
        ck_assert_int_le(n, 64);
        rules[i] = bad[i % 3];
        ck_assert_int_eq(mus_design_grade_apply(pattern, rules, &out), MUS_ERR_ARG);
        ck_assert_ptr_null(out);
        ck_assert(strstr(mus_context_error(context), "front") != NULL || strstr(mus_context_error(context), "back"));
    }
    mus_pattern_destroy(pattern);
    mus_tape_destroy(tape);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_refused_pattern(void);

/* one call on the sample with `bad` in place number `k`; MUS_NONE when there is no such place */
typedef mus_status (*pattern_call)(const sample *s, int32_t k, double bad);


static mus_status call_add_point(const sample *s, int32_t k, double bad)
{
    int32_t out;
    if (k >= 2) return MUS_NONE;
    return mus_pattern_add_point(s->pattern, s->front, k == 0 ? bad : 0.1, k == 1 ? bad : 0.1, &out);
}


/* mus_edge_def.xy */
static mus_status call_add_edge(const sample *s, int32_t k, double bad)
{
    static const int32_t kinds[3] = {MUS_PIECE_LINE, MUS_PIECE_QUADRATIC, MUS_PIECE_ARC};
    double xy[8] = {0.1, 0.01, 0.2, 0.05, 0.3, 0.01, 0.35, 0.02}; /* joint, control, joint, middle of the arc */
    if (k >= 8) return MUS_NONE;
    xy[k] = bad;
    int32_t out;
    return mus_pattern_add_edge(s->pattern, &(mus_edge_def){.size = sizeof(mus_edge_def), .name = "new",
                                                            .start = s->point[0], .end = s->point[1], .npiece = 3,
                                                            .kinds = kinds, .nxy = 4, .xy = xy}, &out);
}


static mus_status call_set_edge_allowance(const sample *s, int32_t k, double bad)
{
    /* NaN leaves the allowance to the sheet */
    if (k >= 1) return MUS_NONE;
    return isnan(bad) ? MUS_ERR_ARG : mus_pattern_set_edge_allowance(s->pattern, s->edge[0], bad);
}


static mus_status call_cut_line(const sample *s, int32_t k, double bad)
{
    mus_cut_line *out;
    return k >= 1 ? MUS_NONE : mus_pattern_cut_line(s->pattern, 0, bad, &out);
}


static mus_status call_add_notch(const sample *s, int32_t k, double bad)
{
    int32_t out;
    return k < 1 ? mus_pattern_add_notch(s->pattern, s->edge[0], bad, MUS_NOTCH_SINGLE, &out) : MUS_NONE;
}


static mus_status call_set_edge_hold(const sample *s, int32_t k, double bad)
{
    return k >= 1 ? MUS_NONE : mus_pattern_set_edge_hold(s->pattern, s->edge[0], MUS_HOLD_WAIST, bad);
}


static mus_status call_hold_label(const sample *s, int32_t k, double bad)
{
    int32_t count;
    return k >= 1 ? MUS_NONE : mus_pattern_hold_label(s->pattern, "hem", MUS_HOLD_WAIST, bad, &count);
}


static mus_status call_set_edge_elastic(const sample *s, int32_t k, double bad)
{
    if (k >= 2) return MUS_NONE;
    return mus_pattern_set_edge_elastic(s->pattern, s->edge[0], k == 0 ? bad : 0.8, k == 1 ? bad : 20.0);
}


static mus_status call_add_mark(const sample *s, int32_t k, double bad)
{
    double xy[6] = {0.1, 0.1, 0.2, 0.2, 0.3, 0.1};
    if (k >= 6) return MUS_NONE;
    xy[k] = bad;
    int32_t out;
    return mus_pattern_add_mark(s->pattern, s->front, "dart", 3, xy, &out);
}


static mus_status call_set_grain(const sample *s, int32_t k, double bad)
{
    return k < 2 ? mus_pattern_set_grain(s->pattern, s->front, k == 0 ? bad : 1.0, k == 1 ? bad : 1.0) : MUS_NONE;
}


/* mus_placement.origin mus_placement.rotation mus_placement.bend mus_placement.bend_x mus_placement.fold */
static mus_status call_set_placement(const sample *s, int32_t k, double bad)
{
    mus_placement place;
    mus_placement_init(&place, sizeof place);
    place.bend = 0.2;
    if (k < 3)
        place.origin[k] = bad;
    else if (k < 12)
        place.rotation[k - 3] = bad;
    else if (k == 12)
        place.bend = bad;
    else if (k == 13)
        place.bend_x = bad;
    else if (k == 14)
        place.fold = bad;
    else
        return MUS_NONE;
    return mus_pattern_set_placement(s->pattern, s->front, &place);
}


/* mus_seam_def.ease mus_seam_def.tolerance */
static mus_status call_add_seam(const sample *s, int32_t k, double bad)
{
    mus_seam_def def;
    mus_seam_def_init(&def, sizeof def);
    def.edge_a = s->edge[0], def.edge_b = s->edge[4];
    if (k == 0)
        def.ease = bad;
    else if (k == 1)
        def.tolerance = bad;
    else
        return MUS_NONE;
    int32_t out;
    return mus_pattern_add_seam(s->pattern, &def, &out);
}


/* a question: nothing is written */
static mus_status call_edge_at(const sample *s, int32_t k, double bad)
{
    double t[3] = {0.0, 0.5, 1.0}, out[6];
    if (k >= 3) return MUS_NONE;
    t[k] = bad;
    return mus_pattern_edge_at(s->pattern, s->edge[0], 3, t, out);
}


static const struct {
    const char *name;
    pattern_call call;
} pattern_calls[] = {
    {"mus_pattern_add_point", call_add_point},
    {"mus_pattern_add_edge", call_add_edge},
    {"mus_pattern_add_notch", call_add_notch},
    {"mus_pattern_set_edge_allowance", call_set_edge_allowance},
    {"mus_pattern_cut_line", call_cut_line},
    {"mus_pattern_set_edge_hold", call_set_edge_hold},
    {"mus_pattern_hold_label", call_hold_label},
    {"mus_pattern_set_edge_elastic", call_set_edge_elastic},
    {"mus_pattern_add_mark", call_add_mark},
    {"mus_pattern_set_grain", call_set_grain},
    {"mus_pattern_set_placement", call_set_placement},
    {"mus_pattern_add_seam", call_add_seam},
    {"mus_pattern_edge_at", call_edge_at},
};


START_TEST(a_number_that_is_not_finite_leaves_the_pattern_as_it_was)
{
    mus_context *context = support_context();
    const sample s = sample_make(context);
    mus_pattern *before;
    ck_assert_int_eq(mus_pattern_copy(s.pattern, &before), MUS_OK);
    for (int32_t v = 0; v < 3; v++)
        for (int32_t k = 0;; k++) {
            const mus_status status = pattern_calls[_i].call(&s, k, refused_values[v]);
            if (status == MUS_NONE) {
                ck_assert_int_gt(k, 0);
                break;
            }
            ck_assert_msg(status == MUS_ERR_ARG, "%s with %g as number %d: %d", pattern_calls[_i].name,
                          refused_values[v], (int)k, (int)status);
            if (!isnan(refused_values[v])) ck_assert_str_ne(mus_context_error(context), "");
        }
    same_pattern(before, s.pattern);
    mus_pattern_destroy(before);
    mus_pattern_destroy(s.pattern);
    support_context_end(context);
}
END_TEST


static mus_status try_draft(mus_context *context, const void *def, void *user)
{
    mus_tape *tape;
    mus_pattern *pattern;
    ck_assert_int_eq(mus_tape_create(context, &tape), MUS_OK);
    ck_assert_int_eq(mus_tape_set_size(tape, "W40"), MUS_OK);
    const mus_status status = mus_design_draft(context, mus_design_find(user), tape, def, &pattern);
    ck_assert_int_eq(status == MUS_OK, pattern != NULL);
    mus_pattern_destroy(pattern);
    mus_tape_destroy(tape);
    return status;
}


/* NaN takes the design's own value, infinity is refused */
START_TEST(an_infinite_option_of_a_draft_is_refused_by_name)
{
    static const refused_field fields[] = {
        REFUSED(mus_draft_def, ease, 1, true, "ease"),
        REFUSED(mus_draft_def, length, 1, true, "length"),
        REFUSED(mus_draft_def, sleeve, 1, true, "sleeve"),
    };
    mus_draft_def def;
    mus_draft_def_init(&def, sizeof def);
    refused_fields(fields, sizeof fields / sizeof *fields, &def, sizeof def, try_draft, "tshirt");
}
END_TEST


Suite *mus_suite_refused_pattern(void)
{
    Suite *suite = suite_create("refused_pattern");
    TCase *tests = tcase_create("refused_pattern");
    tcase_add_loop_test(tests, a_number_that_is_not_finite_leaves_the_pattern_as_it_was, 0,
                        sizeof pattern_calls / sizeof *pattern_calls);
    tcase_add_test(tests, an_infinite_option_of_a_draft_is_refused_by_name);
    tcase_add_test(tests, an_infinite_rule_of_a_grade_is_refused_with_its_panel);
    suite_add_tcase(suite, tests);
    return suite;
}
