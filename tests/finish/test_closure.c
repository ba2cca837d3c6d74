/*
 * test_closure.c: skirts and trousers open where their closure crosses the waist: the zip below and the ends of the
 * band above it meet in one point of the sewn garment, and one end is longer by the underlap. A law over all designs.
 * Fronts that button have their marks, fronts that wrap their ties.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "block/drafts.h"

#define RIM_MOST 64

/* the edges of a panel's rim as they are walked */
typedef struct rim {
    int32_t n, edge[RIM_MOST], direction[RIM_MOST];
} rim;


static rim rim_of(const mus_pattern *pattern, int32_t panel)
{
    rim out;
    ck_assert_int_eq(mus_pattern_rim(pattern, panel, out.edge, out.direction, RIM_MOST, &out.n), MUS_OK);
    ck_assert_int_le(out.n, RIM_MOST);
    return out;
}


/* the edge beside `edge` in its rim that has the label: before it (*before set) or after it; MUS_NONE without one */
static int32_t beside(const mus_pattern *pattern, int32_t edge, const char *label)
{
    const rim own = rim_of(pattern, mus_pattern_edge_panel(pattern, edge));
    for (int32_t i = 0; i < own.n; i++)
        for (int32_t k = own.edge[i] == edge ? 0 : 2; k < 2; k++) {
            const int32_t other = own.edge[(i + (k == 0 ? 1 : own.n - 1)) % own.n];
            if (strcmp(mus_pattern_edge_label(pattern, other), label) == 0) return other;
        }
    return MUS_NONE;
}


static bool on_band(const mus_pattern *pattern, int32_t edge)
{
    return strcmp(mus_pattern_panel_label(pattern, mus_pattern_edge_panel(pattern, edge)), "band") == 0;
}


/* seam i of a pattern */
static mus_seam_def seam_at(const mus_pattern *pattern, int32_t i)
{
    mus_seam_def seam;
    mus_seam_def_init(&seam, sizeof seam);
    ck_assert_int_eq(mus_pattern_seam(pattern, i, &seam), MUS_OK);
    return seam;
}


/* the only closure of the kind on a band or off it; MUS_NONE without one, *count of them */
static int32_t closure_of(const mus_pattern *pattern, int32_t kind, bool band, int32_t *count, mus_seam_def *out)
{
    int32_t found = MUS_NONE;
    *count = 0;
    for (int32_t i = 0; i < mus_pattern_seam_count(pattern); i++) {
        const mus_seam_def seam = seam_at(pattern, i);
        if (seam.closure != kind || on_band(pattern, seam.edge_a) != band) continue;
        *out = seam;
        found = i;
        ++*count;
    }
    return found;
}


static int32_t partner(const mus_pattern *pattern, int32_t edge)
{
    const mus_seam_def seam = seam_at(pattern, mus_pattern_edge_seam(pattern, edge));
    return seam.edge_a == edge ? seam.edge_b : seam.edge_a;
}


static double length_of(const mus_pattern *pattern, const char *label, bool band)
{
    double length = 0.0;
    for (int32_t i = 0; i < mus_pattern_edge_count(pattern); i++)
        if (strcmp(mus_pattern_edge_label(pattern, i), label) == 0 && on_band(pattern, i) == band)
            length += mus_pattern_edge_length(pattern, i);
    return length;
}


/* what the seams of the waist line ease in [m] */
static double eased(const mus_pattern *pattern)
{
    double ease = 0.0;
    for (int32_t i = 0; i < mus_pattern_seam_count(pattern); i++) {
        const mus_seam_def seam = seam_at(pattern, i);
        if (strcmp(mus_pattern_edge_label(pattern, seam.edge_a), "band") != 0) continue;
        ease += on_band(pattern, seam.edge_a) ? seam.ease : -seam.ease;
    }
    return ease;
}


/* each end of the band's opening stands on the seam of the zip: the zip's edge, the waist edge beside it, the band's
 * edge sewn to that, and the end beside this one */
static void meets(const char *name, const mus_pattern *pattern, const mus_seam_def *zip, const mus_seam_def *band)
{
    for (int32_t k = 0; k < 2; k++) {
        const int32_t edge = k == 0 ? zip->edge_a : zip->edge_b, waist = beside(pattern, edge, "band");
        ck_assert_msg(waist != MUS_NONE, "%s: the zip ends below the waist", name);
        const int32_t low = partner(pattern, waist), panel = mus_pattern_edge_panel(pattern, low);
        const int32_t end = mus_pattern_edge_panel(pattern, band->edge_a) == panel ? band->edge_a : band->edge_b;
        ck_assert_msg(mus_pattern_edge_panel(pattern, end) == panel, "%s: the band does not open at the zip", name);
        const rim own = rim_of(pattern, panel);
        bool side_by_side = false;
        for (int32_t i = 0; i < own.n; i++) {
            const int32_t a = own.edge[i], b = own.edge[(i + 1) % own.n];
            side_by_side = side_by_side || (a == low && b == end) || (a == end && b == low);
        }
        ck_assert_msg(side_by_side, "%s: the band's end is not over the zip", name);
    }
}


/* a band's two ends differ by the underlap, 3 to 4 cm on an adult; the rest of the band is as long as the waist line */
static void laps(const char *name, const mus_pattern *pattern, const mus_seam_def *band)
{
    const double a = mus_pattern_edge_allowance(pattern, band->edge_a);
    const double b = mus_pattern_edge_allowance(pattern, band->edge_b), lap = fabs(a - b);
    ck_assert_msg(lap > 0.015 && lap < 0.04, "%s: underlap of %.1f mm", name, 1e3 * lap);
    ck_assert_double_eq_tol(fmin(a, b), 0.01, 1e-9);
    const double waist = length_of(pattern, "band", false) - eased(pattern);
    ck_assert_msg(fabs(length_of(pattern, "band", true) - waist) < 2e-3, "%s: band %.1f mm, waist line %.1f mm", name,
                  1e3 * length_of(pattern, "band", true), 1e3 * waist);
    int32_t lines = 0;
    for (int32_t i = 0; i < mus_pattern_mark_count(pattern); i++) {
        const char *mark;
        ck_assert_int_eq(mus_pattern_mark(pattern, i, NULL, &mark, NULL, NULL), MUS_OK);
        lines += strcmp(mark, "underlap") == 0;
    }
    ck_assert_int_eq(lines, 1);
}


START_TEST(a_band_opens_where_the_closure_crosses_the_waist)
{
    mus_context *context = support_context();
    int32_t opened = 0, closed = 0;
    for (int32_t d = 0; d < mus_design_count(); d++) {
        const char *name = mus_design_name(d), *words = mus_design_words(d);
        char full[512];
        if (strncmp(words, "skirt", 5) != 0 && strncmp(words, "trousers", 8) != 0) continue;
        ck_assert_int_eq(mus_design_spell(context, words, full, sizeof full), MUS_OK);
        mus_pattern *pattern = drafts_pattern(context, name, (mus_design_groups(d) & 1) != 0 ? "W40" : "M50");
        mus_seam_def zip, band;
        int32_t zips, ends;
        closure_of(pattern, MUS_CLOSURE_ZIP, false, &zips, &zip);
        closure_of(pattern, MUS_CLOSURE_BUTTONS, true, &ends, &band);
        const bool opens = strstr(full, "closure=none") == NULL && strstr(full, "band=elastic") == NULL;
        const bool banded = length_of(pattern, "band", true) > 0.0;
        ck_assert_msg(zips == (opens ? 1 : 0), "%s: %d zips", name, (int)zips);
        ck_assert_msg(ends == (opens && banded ? 1 : 0), "%s: the band opens %d times", name, (int)ends);
        if (ends == 1) meets(name, pattern, &zip, &band);
        if (ends == 1) laps(name, pattern, &band);
        opened += ends;
        closed += ends == 0;
        mus_pattern_destroy(pattern);
    }
    ck_assert_int_gt(opened, 100);
    ck_assert_int_gt(closed, 20);
    support_context_end(context);
}
END_TEST


/* the shield of a fly reaches as far as the underlap of the band above it, and is as long as the zip */
START_TEST(a_shield_lies_below_the_underlap)
{
    static const char *const sizes[] = {"W40", "W52", "M50"};
    mus_context *context = support_context();
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        mus_pattern *pattern = drafts_pattern(context, "jeans", sizes[i]);
        const mus_pattern *made = mus_pattern_cut_only(pattern);
        const double lap = mus_pattern_edge_allowance(pattern, drafts_edge(pattern, "band_front_right", "open")) -
                           mus_pattern_edge_allowance(pattern, drafts_edge(pattern, "band_front_left", "open"));
        const double zip = drafts_length(pattern, "leg_front_left", "zip");
        ck_assert_double_eq_tol(drafts_length(made, "fly_shield", "end"), lap, 1e-9);
        ck_assert_double_eq_tol(drafts_length(made, "fly_shield", "low"), zip, 1e-9);
        ck_assert_double_eq_tol(drafts_length(made, "fly_facing", "zip"), zip, 1e-3);
        mus_pattern_destroy(pattern);
    }
    support_context_end(context);
}
END_TEST


/* a front laps left over right, a back too, and the side front over back; a fold opens at the side */
START_TEST(the_word_of_the_closure_says_where)
{
    static const char *const rows[][4] = {
        {"trousers", "band_front_left", "band_front_right", "leg_front_left"},
        {"trousers closure=back", "band_back_left", "band_back_right", "leg_back_left"},
        {"trousers closure=side", "band_front", "band_back", "leg_front_left"},
        {"skirt skirt=pencil", "band_back_left", "band_back_right", "skirt_back_left"},
        {"skirt skirt=gathered", "band_front", "band_back", "skirt_front"},
        {"skirt skirt=gored6 closure=back", "band_front", "band_back", "gore2_left"},
    };
    mus_context *context = support_context();
    mus_tape *tape = drafts_tape(context, "W40");
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        mus_pattern *pattern;
        mus_seam_def band, zip;
        int32_t count;
        ck_assert_int_eq(mus_design_draft_words(context, rows[i][0], tape, NULL, &pattern), MUS_OK);
        closure_of(pattern, MUS_CLOSURE_BUTTONS, true, &count, &band);
        ck_assert_int_eq(count, 1);
        const bool swap = mus_pattern_edge_allowance(pattern, band.edge_a) > 0.02;
        const int32_t over = swap ? band.edge_b : band.edge_a, under = swap ? band.edge_a : band.edge_b;
        ck_assert_str_eq(mus_pattern_panel_name(pattern, mus_pattern_edge_panel(pattern, over)), rows[i][1]);
        ck_assert_str_eq(mus_pattern_panel_name(pattern, mus_pattern_edge_panel(pattern, under)), rows[i][2]);
        closure_of(pattern, MUS_CLOSURE_ZIP, false, &count, &zip);
        ck_assert_int_eq(mus_pattern_find_edge(pattern, mus_pattern_find_panel(pattern, rows[i][3]), "zip") ==
                             zip.edge_a ||
                         mus_pattern_find_edge(pattern, mus_pattern_find_panel(pattern, rows[i][3]), "zip") ==
                             zip.edge_b, true);
        ck_assert_double_eq_tol(mus_pattern_edge_length(pattern, zip.edge_a), 0.18, 2e-3);
        mus_pattern_destroy(pattern);
    }
    mus_tape_destroy(tape);
    support_context_end(context);
}
END_TEST


/* the number of marks of a panel called `name` with n points; of the last of them the points */
static int32_t marks_of(const mus_pattern *pattern, int32_t panel, const char *name, int32_t n, const double **xy)
{
    int32_t count = 0;
    for (int32_t i = 0; i < mus_pattern_mark_count(pattern); i++) {
        int32_t own, points;
        const char *mark;
        const double *at;
        ck_assert_int_eq(mus_pattern_mark(pattern, i, &own, &mark, &points, &at), MUS_OK);
        if (own != panel || points != n || strcmp(mark, name) != 0) continue;
        *xy = at;
        count++;
    }
    return count;
}


/* each button of a front has the buttonhole of the other one about it, along the centre: as long as the stand is wide,
 * from above the button. The interfacing ends as far beyond the fold as that is beyond the centre. The facing of a
 * front does not repeat the stand */
START_TEST(a_front_that_buttons_has_buttonholes_and_one_stand)
{
    static const char *const names[] = {"shirt", "coat", "pyjama_jacket", "shirt_dress", "waistcoat"};
    mus_context *context = support_context();
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        mus_pattern *pattern = drafts_pattern(context, names[i], i == 3 ? "W40" : "M50");
        const mus_pattern *made = mus_pattern_cut_only(pattern);
        const int32_t front = mus_pattern_find_panel(pattern, "front_left");
        const double *button, *hole, *fold, *strip;
        const int32_t buttons = marks_of(pattern, front, "button", 1, &button);
        ck_assert_msg(buttons > 2, "%s: %d buttons", names[i], (int)buttons);
        ck_assert_int_eq(marks_of(pattern, front, "buttonhole", 2, &hole), buttons);
        ck_assert_double_eq_tol(hypot(hole[2] - hole[0], hole[3] - hole[1]), 0.0175, 1e-6);
        ck_assert_double_eq_tol(hole[0], button[0], 1e-9);
        ck_assert_double_eq_tol(hole[2], button[0], 1e-9);
        ck_assert_double_eq_tol(hole[1] - button[1], 0.003, 1e-9);
        ck_assert_double_lt(hole[3], button[1]);
        ck_assert_int_eq(marks_of(pattern, front, "fold", 2, &fold), 1);
        ck_assert_int_eq(marks_of(pattern, front, "interfacing", 2, &strip), 1);
        ck_assert_double_eq_tol(strip[0] - fold[0], fold[0] - button[0], 1e-9);
        for (int32_t e = 0; made != NULL && e < mus_pattern_edge_count(made); e++) {
            const int32_t panel = mus_pattern_edge_panel(made, e);
            if (strcmp(mus_pattern_panel_label(made, panel), "facing") != 0) continue;
            ck_assert_msg(mus_pattern_edge_allowance(made, e) < 0.0101, "%s: %s.%s", names[i],
                          mus_pattern_panel_name(made, panel), mus_pattern_edge_name(made, e));
        }
        mus_pattern_destroy(pattern);
    }
    support_context_end(context);
}
END_TEST


/* below a bodice that opens behind the zip goes on in the centre back, which is a seam there: 18 k, or 0.6 of the seam.
 * Where the bodice opens elsewhere a back that is cut on the fold stays whole */
START_TEST(a_zip_behind_goes_on_below_the_waist)
{
    static const struct {
        const char *words, *panel;
        bool zip;
    } rows[] = {
        {"dress skirt=gathered closure=back", "skirt_back_left", true},
        {"dress skirt=knife closure=back", "skirt_back_left", true},
        {"dress skirt=tiered length=midi closure=back", "skirt_back_left", true},
        {"dress skirt=pencil closure=back", "skirt_back_left", true},
        {"dress skirt=half neck=halter closure=back", "skirt_back_left", true},
        {"jumpsuit closure=back", "leg_back_left", true},
        {"dress skirt=gathered closure=side", "skirt_back", false},
        {"dress skirt=gathered closure=front", "skirt_back", false},
        {"dress skirt=gathered cloth=knit neck=scoop", "skirt_back", false},
    };
    static const char *const sizes[] = {"W40", "W52", "M50", "C92", "C152"};
    mus_context *context = support_context();
    mus_tape *tape = drafts_tape(context, sizes[_i]);
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        mus_pattern *pattern;
        const mus_status status = mus_design_draft_words(context, rows[i].words, tape, NULL, &pattern);
        ck_assert_msg(status == MUS_OK, "%s of %s: %s", rows[i].words, sizes[_i], mus_context_error(context));
        const int32_t panel = mus_pattern_find_panel(pattern, rows[i].panel);
        ck_assert_msg(panel != MUS_NONE, "%s has no %s", rows[i].words, rows[i].panel);
        const int32_t zip = mus_pattern_find_edge(pattern, panel, "zip");
        ck_assert_msg((zip != MUS_NONE) == rows[i].zip, "%s of %s", rows[i].words, sizes[_i]);
        if (zip != MUS_NONE) {
            mus_seam_def seam;
            mus_seam_def_init(&seam, sizeof seam);
            ck_assert_int_eq(mus_pattern_seam(pattern, mus_pattern_edge_seam(pattern, zip), &seam), MUS_OK);
            ck_assert_int_eq(seam.closure, MUS_CLOSURE_ZIP);
            ck_assert_double_eq(mus_pattern_edge_length(pattern, seam.edge_a),
                                mus_pattern_edge_length(pattern, seam.edge_b));
            ck_assert_double_le(mus_pattern_edge_length(pattern, zip), 0.18 + 1e-9);
            ck_assert_double_gt(mus_pattern_edge_length(pattern, zip), 0.05);
        }
        mus_pattern_destroy(pattern);
    }
    mus_tape_destroy(tape);
    support_context_end(context);
}
END_TEST


/* the two ties of a dress that wraps: each holds an end on the other front's side seam, as high as it is */
static void ties_of(const mus_pattern *pattern)
{
    int32_t ties = 0;
    for (int32_t i = 0; i < mus_pattern_seam_count(pattern); i++) {
        const mus_seam_def seam = seam_at(pattern, i);
        ck_assert_int_ne(seam.closure, MUS_CLOSURE_ZIP);
        if (seam.closure != MUS_CLOSURE_TIES) continue;
        const int32_t of = mus_pattern_edge_panel(pattern, seam.edge_a);
        const int32_t to = mus_pattern_edge_panel(pattern, seam.edge_b);
        ck_assert_str_eq(mus_pattern_edge_name(pattern, seam.edge_a), "tie");
        ck_assert_str_eq(mus_pattern_edge_label(pattern, seam.edge_b), "side");
        ck_assert_int_ne(of, to);
        ck_assert_str_eq(mus_pattern_panel_label(pattern, of), mus_pattern_panel_label(pattern, to));
        ck_assert_double_eq_tol(mus_pattern_edge_length(pattern, seam.edge_a),
                                mus_pattern_edge_length(pattern, seam.edge_b), 1e-9);
        ck_assert(seam.laid && seam.direction == MUS_SEAM_DIRECT);
        ties++;
    }
    ck_assert_int_eq(ties, 2);
}


/* fronts that wrap: the part beyond the centre is as long as the other front and a little longer, so is that of the
 * skirt; neck, edges and hem are one opening */
START_TEST(a_front_that_wraps_is_tied_to_the_other_side)
{
    static const char *const sizes[] = {"W34", "W40", "W52", "M50", "C116"};
    mus_context *context = support_context();
    mus_tape *tape = drafts_tape(context, sizes[_i]);
    mus_pattern *pattern;
    mus_topology topology;
    ck_assert_int_eq(
        mus_design_draft_words(context, "dress sleeve=long neck=deep_v skirt=wrap closure=wrap", tape, NULL, &pattern),
        MUS_OK);
    ties_of(pattern);
    const int32_t right = mus_pattern_find_panel(pattern, "front_right");
    double waist = 0.0;
    for (int32_t i = 0; i < mus_pattern_edge_count(pattern); i++)
        if (mus_pattern_edge_panel(pattern, i) == right && strcmp(mus_pattern_edge_label(pattern, i), "waist") == 0)
            waist += mus_pattern_edge_length(pattern, i);
    const double lap = drafts_length(pattern, "front_left", "lap");
    ck_assert_double_eq_tol(lap, 1.17 * waist, 1e-6);
    ck_assert_double_eq_tol(drafts_length(pattern, "skirt_front_left", "lap"), lap, 1e-6);
    ck_assert_int_eq(mus_pattern_opening_count(pattern), 3);
    for (int32_t i = 0; i < 3; i++) ck_assert_str_ne(mus_pattern_opening(pattern, i), "neck");
    mus_topology_init(&topology, sizeof topology);
    ck_assert_int_eq(mus_pattern_topology(pattern, &topology), MUS_OK);
    ck_assert(topology.orientable && !topology.manifold);
    mus_pattern_destroy(pattern);
    mus_tape_destroy(tape);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_closure(void);


Suite *mus_suite_closure(void)
{
    Suite *suite = suite_create("closure");
    TCase *tcase = tcase_create("waist");
    tcase_set_timeout(tcase, 120);
    tcase_add_test(tcase, a_band_opens_where_the_closure_crosses_the_waist);
    tcase_add_test(tcase, a_shield_lies_below_the_underlap);
    tcase_add_test(tcase, the_word_of_the_closure_says_where);
    tcase_add_test(tcase, a_front_that_buttons_has_buttonholes_and_one_stand);
    tcase_add_loop_test(tcase, a_zip_behind_goes_on_below_the_waist, 0, 5);
    tcase_add_loop_test(tcase, a_front_that_wraps_is_tied_to_the_other_side, 0, 5);
    suite_add_tcase(suite, tcase);
    return suite;
}
