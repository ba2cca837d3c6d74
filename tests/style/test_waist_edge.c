/*
 * test_waist_edge.c: skirts and trousers by words: every kind, length, band and rise that the rules allow drafts on
 * five sizes as a garment without a fault: outlines simple, seams as long as each other or as their gathers mean, one
 * waist and the hems open. Topologies are counted by hand; circles have the radii and areas of an independent
 * drafting script.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "block/drafts.h"
#include "design/draft.h"
#include "design/words.h"
#include "muslin/topology.h"

static const char *const sizes[] = {"W34", "W40", "W52", "M50", "C116"};

#define SIZES ((int)(sizeof sizes / sizeof sizes[0]))




/* all kinds of `kind`, lengths, bands and rises of a garment: how many drafts */
static int lower_all(mus_context *context, const char *size, int32_t garment, int32_t kind, int32_t length)
{
    mus_tape *tape = drafts_tape(context, size);
    int count = 0;
    for (int32_t k = 0; mus__style_word(kind, k) != NULL; k++)
        for (int32_t i = 0; i < 5 * 4 * 3; i++) {
            mus__style style;
            memset(&style, 0, sizeof style);
            style.option[MUS__AXIS_GARMENT] = garment;
            style.option[kind] = k;
            style.option[length] = i / 12;
            style.option[MUS__AXIS_BAND] = i / 3 % 4;
            style.option[MUS__AXIS_RISE] = i % 3;
            if (i / 3 % 4 != MUS__BAND_ELASTIC) style.option[MUS__AXIS_CLOSURE] = MUS__CLOSURE_SIDE;
            if (mus__style_check(context, &style) != MUS_OK) continue;
            char words[256];
            mus_pattern *pattern;
            mus__style_spell(&style, words, sizeof words);
            const mus_status status = mus__style_draft(context, words, &style, tape, NULL, &pattern);
            ck_assert_msg(status == MUS_OK, "%s of %s: %s", words, size, mus_context_error(context));
            mus_pattern_destroy(pattern);
            count++;
        }
    mus_tape_destroy(tape);
    return count;
}


START_TEST(every_skirt_drafts)
{
    mus_context *context = support_context();
    ck_assert_int_eq(lower_all(context, sizes[_i], MUS__GARMENT_SKIRT, MUS__AXIS_SKIRT, MUS__AXIS_LENGTH), 3 * 234);
    support_context_end(context);
}
END_TEST


START_TEST(every_leg_drafts)
{
    mus_context *context = support_context();
    ck_assert_int_eq(lower_all(context, sizes[_i], MUS__GARMENT_TROUSERS, MUS__AXIS_LEG, MUS__AXIS_LEG_LENGTH),
                     3 * 95);
    support_context_end(context);
}
END_TEST


/* the words' pattern, which mus_design_draft_words() has checked */
static mus_pattern *lower_pattern(mus_context *context, const char *words, const char *size)
{
    mus_tape *tape = drafts_tape(context, size);
    mus_pattern *pattern;
    const mus_status status = mus_design_draft_words(context, words, tape, NULL, &pattern);
    ck_assert_msg(status == MUS_OK, "%s of %s: %s", words, size, mus_context_error(context));
    mus_tape_destroy(tape);
    return pattern;
}


/* characteristic, openings, genus of garments, counted by hand. Bands and cuts do not change them */
static const struct {
    const char *words;
    int32_t faces, euler, loops;
} topologies[] = {
    {"skirt closure=side band=facing skirt=a_line", 3, 0, 2},
    {"skirt closure=side skirt=straight", 5, 0, 2},
    {"skirt closure=side band=facing skirt=gored4", 4, 0, 2},
    {"skirt closure=side band=facing skirt=gored6", 6, 0, 2},
    {"skirt closure=side band=facing skirt=gored8", 8, 0, 2},
    {"skirt closure=side band=facing skirt=full", 4, 0, 2},
    {"skirt closure=side band=contour skirt=godet", 10, 0, 2},
    {"skirt closure=side skirt=tiered", 8, 0, 2},
    {"skirt closure=side skirt=wrap", 7, 0, 2},
    {"trousers closure=front band=facing", 4, -1, 3},
    {"trousers closure=front", 7, -1, 3},
    {"trousers closure=front leg=jogger", 9, -1, 3},
    {"dress closure=back skirt=straight", 0, -2, 4},
    {"dress closure=back skirt=full shape=princess_armhole", 0, -2, 4},
    {"jumpsuit closure=front", 0, -3, 5},
};


START_TEST(topology_is_that_of_the_garment)
{
    mus_context *context = support_context();
    for (int s = 0; s < SIZES; s++) {
        mus_pattern *pattern = lower_pattern(context, topologies[_i].words, sizes[s]);
        mus_topology t;
        mus_topology_init(&t, sizeof t);
        ck_assert_int_eq(mus_pattern_topology(pattern, &t), MUS_OK);
        if (topologies[_i].faces > 0) ck_assert_int_eq(t.faces, topologies[_i].faces);
        ck_assert_int_eq(t.euler, topologies[_i].euler);
        ck_assert_int_eq(t.loops, topologies[_i].loops);
        ck_assert_int_eq(t.components, 1);
        ck_assert_int_eq(t.genus, 0);
        ck_assert_int_eq(t.orientable, 1);
        ck_assert_int_eq(t.manifold, 1);
        mus_pattern_destroy(pattern);
    }
    support_context_end(context);
}
END_TEST


/* the whole of a label's sides in the panels whose names begin with `panels` */
static double lower_length(const mus_pattern *pattern, const char *panels, const char *label)
{
    double length = 0.0;
    for (int32_t e = 0; e < mus_pattern_edge_count(pattern); e++) {
        const char *panel = mus_pattern_panel_name(pattern, mus_pattern_edge_panel(pattern, e));
        if (strncmp(panel, panels, strlen(panels)) == 0 && strcmp(mus_pattern_edge_label(pattern, e), label) == 0)
            length += mus_pattern_edge_length(pattern, e);
    }
    return length;
}


/* hem and area of a circle skirt are those of an independent drafting script, which are for a waist with its ease of
 * 77 and a length of 60, carried to the waist W of W40 here: hem W + 2 pi f L, area L (W + pi f L) */
START_TEST(circles_have_their_radii)
{
    static const struct {
        const char *words;
        double part, hem, area; /* [cm], [cm2] for a waist of 77 */
    } golden[] = {{"skirt closure=side band=facing skirt=half", 0.5, 265.50, 10274.9},
                  {"skirt closure=side band=facing skirt=full", 1.0, 453.99, 15929.7}};
    mus_context *context = support_context();
    mus_tape *tape = drafts_tape(context, "W40");
    mus_draft_def def;
    mus_draft_def_init(&def, sizeof def);
    def.length = 0.60;
    for (int i = 0; i < 2; i++) {
        mus_pattern *pattern;
        ck_assert_int_eq(mus_design_draft_words(context, golden[i].words, tape, &def, &pattern), MUS_OK);
        double area = 0.0;
        for (int32_t p = 0; p < mus_pattern_panel_count(pattern); p++) area += mus_pattern_panel_area(pattern, p);
        const double waist = lower_length(pattern, "skirt", "waist"), more = waist - 0.77;
        ck_assert_double_eq_tol(lower_length(pattern, "skirt", "hem"), golden[i].hem * CM + more, 1e-4);
        ck_assert_double_eq_tol(area, golden[i].area * CM * CM + 0.60 * more, 1e-5);
        mus_pattern_destroy(pattern);
    }
    mus_tape_destroy(tape);
    support_context_end(context);
}
END_TEST


/* gathers and tiers are as many times as long as what they are sewn to, as their words mean; a band is as long as the
 * waist and its ease, a shaped one longer below */
START_TEST(gathers_and_bands_have_their_lengths)
{
    mus_context *context = support_context();
    const double waist = 0.76 + 0.02;
    static const struct {
        const char *skirt;
        double ratio;
    } full[] = {{"gathered", 1.8}, {"box", 2.4}, {"knife", 3.0}, {"tiered", 1.4}};
    for (int i = 0; i < 4; i++) {
        char words[80];
        snprintf(words, sizeof words, "skirt closure=side skirt=%s", full[i].skirt);
        mus_pattern *pattern = lower_pattern(context, words, "W40");
        ck_assert_double_eq_tol(lower_length(pattern, "skirt", "band"), full[i].ratio * waist, 1e-9);
        ck_assert_double_eq_tol(lower_length(pattern, "band", "band"), waist, 1e-9);
        ck_assert_double_eq_tol(lower_length(pattern, "band", "waist"), waist, 1e-9);
        if (i == 3) ck_assert_double_eq_tol(lower_length(pattern, "tier3", "hem"), 1.4 * 2.25 * waist, 1e-9);
        mus_pattern_destroy(pattern);
    }
    mus_pattern *pattern = lower_pattern(context, "skirt closure=side band=contour", "W40");
    ck_assert_double_eq_tol(lower_length(pattern, "band", "waist"), waist, 1e-9);
    ck_assert_double_gt(lower_length(pattern, "band", "band"), waist + 0.03);
    ck_assert_double_eq_tol(lower_length(pattern, "band", "band"), lower_length(pattern, "skirt", "band"), 2e-3);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


/* under a bodice: every skirt and leg, of three shapes */
START_TEST(dresses_and_jumpsuits_draft)
{
    static const char *const shapes[] = {"side_waist", "princess_armhole", "empire"};
    mus_context *context = support_context();
    mus_tape *tape = drafts_tape(context, sizes[_i]);
    for (int s = 0; s < 3; s++)
        for (int32_t k = 0; k < 17 + 8; k++) {
            const int32_t leg = k - 17;
            char words[160];
            if (leg < 0)
                snprintf(words, sizeof words, "dress closure=back shape=%s skirt=%s", shapes[s],
                         mus__style_word(MUS__AXIS_SKIRT, k));
            else
                snprintf(words, sizeof words, "jumpsuit closure=front shape=%s leg=%s leg_length=%s", shapes[s],
                         mus__style_word(MUS__AXIS_LEG, leg), leg == MUS__LEG_CULOTTE ? "capri" : "full");
            mus__style style;
            mus_pattern *pattern;
            if (mus__style_read(context, words, &style) != MUS_OK) continue;
            const mus_status status = mus_design_draft_words(context, words, tape, NULL, &pattern);
            ck_assert_msg(status == MUS_OK, "%s of %s: %s", words, sizes[_i], mus_context_error(context));
            mus_pattern_destroy(pattern);
        }
    mus_tape_destroy(tape);
    support_context_end(context);
}
END_TEST


/* an edge of the front and that of the back of a leg together */
static double both_legs(const mus_pattern *pattern, const char *edge)
{
    const int32_t front = mus_pattern_find_panel(pattern, "leg_front_left");
    const int32_t back = mus_pattern_find_panel(pattern, "leg_back_left");
    return mus_pattern_edge_length(pattern, mus_pattern_find_edge(pattern, front, edge)) +
           mus_pattern_edge_length(pattern, mus_pattern_find_edge(pattern, back, edge));
}


/* leggings draft in every leg and length; above they are narrower than the hips, and a tapered leg ends narrower than
 * the ankle */
START_TEST(leggings_are_narrower_than_the_body)
{
    mus_context *context = support_context();
    mus_tape *tape = drafts_tape(context, sizes[_i]);
    const mus__measures measures = drafts_measures(context, sizes[_i]);
    const double hip = fmax(measures.v[MUS_MEASURE_HIP], measures.v[MUS_MEASURE_WAIST]);
    int32_t drafted = 0;
    for (int32_t leg = MUS__LEG_STRAIGHT; leg <= MUS__LEG_FLARE; leg++)
        for (int32_t length = 0; mus__style_word(MUS__AXIS_LEG_LENGTH, length) != NULL; length++) {
            char words[160];
            mus__style style;
            mus_pattern *pattern;
            snprintf(words, sizeof words, "trousers leg=%s leg_length=%s band=elastic cloth=knit ease=slim",
                     mus__style_word(MUS__AXIS_LEG, leg), mus__style_word(MUS__AXIS_LEG_LENGTH, length));
            if (mus__style_read(context, words, &style) != MUS_OK) continue;
            const mus_status status = mus_design_draft_words(context, words, tape, NULL, &pattern);
            ck_assert_msg(status == MUS_OK, "%s of %s: %s", words, sizes[_i], mus_context_error(context));
            ck_assert_double_lt(2.0 * both_legs(pattern, "w1"), 0.95 * hip);
            if (leg == MUS__LEG_TAPERED && length == MUS__LEG_LENGTH_FULL)
                ck_assert_double_lt(both_legs(pattern, "hem"), 0.95 * measures.v[MUS_MEASURE_ANKLE]);
            mus_pattern_destroy(pattern);
            drafted++;
        }
    ck_assert_int_ge(drafted, 15);
    mus_tape_destroy(tape);
    support_context_end(context);
}
END_TEST


/* trousers with a yoke have no dart; the yoke is sewn to the back and to the front's outseam, and pockets stay on the
 * back below it */
START_TEST(a_yoke_takes_the_place_of_the_darts)
{
    mus_context *context = support_context();
    mus_tape *tape = drafts_tape(context, sizes[_i]);
    static const char *const words[] = {"trousers yoke=yoke pocket=patch ease=slim",
                                        "trousers leg=flare rise=low band=contour yoke=yoke pocket=patch",
                                        "trousers leg=tapered band=elastic cloth=knit yoke=yoke pocket=patch"};
    for (int w = 0; w < 3; w++) {
        mus_pattern *pattern;
        const mus_status status = mus_design_draft_words(context, words[w], tape, NULL, &pattern);
        ck_assert_msg(status == MUS_OK, "%s of %s: %s", words[w], sizes[_i], mus_context_error(context));
        const int32_t back = mus_pattern_find_panel(pattern, "leg_back_left");
        const int32_t yoke = mus_pattern_find_panel(pattern, "back_yoke_left");
        ck_assert_int_ne(yoke, MUS_NONE);
        ck_assert_int_eq(mus_pattern_find_edge(pattern, mus_pattern_find_panel(pattern, "leg_front_left"), "d1"),
                         MUS_NONE);
        ck_assert_int_eq(mus_pattern_find_edge(pattern, back, "d1"), MUS_NONE);
        ck_assert_int_eq(mus_pattern_find_edge(pattern, back, "w1"), MUS_NONE);
        ck_assert_double_eq_tol(mus_pattern_edge_length(pattern, mus_pattern_find_edge(pattern, back, "yoke")),
                                mus_pattern_edge_length(pattern, mus_pattern_find_edge(pattern, yoke, "yoke")), 1e-9);
        int32_t pockets = 0;
        for (int32_t i = 0; i < mus_pattern_mark_count(pattern); i++) {
            const char *name;
            int32_t panel;
            ck_assert_int_eq(mus_pattern_mark(pattern, i, &panel, &name, NULL, NULL), MUS_OK);
            pockets += panel == back && strcmp(name, "pocket") == 0;
        }
        ck_assert_int_eq(pockets, 1);
        mus_pattern_destroy(pattern);
    }
    mus_tape_destroy(tape);
    support_context_end(context);
}
END_TEST


START_TEST(a_draft_without_memory_fails_and_leaves_nothing)
{
    static const char *const words[] = {"skirt closure=side skirt=godet", "skirt closure=side skirt=wrap",
                                        "trousers closure=front leg=jogger band=contour"};
    for (int64_t n = 0;; n += 1 + n / 8) {
        mus_context *context = support_context();
        mus_tape *tape = drafts_tape(context, "W40");
        mus_pattern *pattern;
        support_fail_after(n, n % 2 == 1);
        const mus_status status = mus_design_draft_words(context, words[_i], tape, NULL, &pattern);
        support_fail_never();
        ck_assert(status == MUS_OK || (status == MUS_ERR_MEMORY && pattern == NULL));
        mus_pattern_destroy(pattern);
        mus_tape_destroy(tape);
        support_context_end(context);
        if (status == MUS_OK) break;
    }
}
END_TEST


Suite *mus_suite_waist_edge(void)
{
    Suite *suite = suite_create("waist_edge");
    TCase *tcase = tcase_create("lower");
    tcase_set_timeout(tcase, 120);
    tcase_add_loop_test(tcase, every_skirt_drafts, 0, SIZES);
    tcase_add_loop_test(tcase, every_leg_drafts, 0, SIZES);
    tcase_add_loop_test(tcase, topology_is_that_of_the_garment, 0, (int)(sizeof topologies / sizeof topologies[0]));
    tcase_add_test(tcase, circles_have_their_radii);
    tcase_add_test(tcase, gathers_and_bands_have_their_lengths);
    tcase_add_loop_test(tcase, dresses_and_jumpsuits_draft, 0, SIZES);
    tcase_add_loop_test(tcase, leggings_are_narrower_than_the_body, 0, SIZES);
    tcase_add_loop_test(tcase, a_yoke_takes_the_place_of_the_darts, 0, SIZES);
    tcase_add_loop_test(tcase, a_draft_without_memory_fails_and_leaves_nothing, 0, 3);
    suite_add_tcase(suite, tcase);
    return suite;
}
