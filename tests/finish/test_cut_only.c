/*
 * test_cut_only.c: the panels of a design that are cut and not draped: which there are by its words, and that they fit
 * the edges that they are traced from.
 */
#include <stdio.h>
#include <string.h>

#include "block/drafts.h"


/* "neckband 1 rib, elastic 1 elastic": each panel that is no mirror image, with what it is cut of */
static void told(const mus_pattern *panels, char *out, size_t size)
{
    size_t at = 0;
    out[0] = '\0';
    for (int32_t i = 0; i < mus_pattern_panel_count(panels); i++) {
        int32_t of, count;
        ck_assert_int_eq(mus_pattern_cut(panels, i, NULL, &of), MUS_OK);
        if (of != MUS_NONE) continue;
        const char *name = mus_pattern_panel_name(panels, i);
        at += (size_t)snprintf(out + at, size - at, "%s%s", at > 0 ? ", " : "", name);
        for (int32_t m = 0; m < MUS_MATERIAL_COUNT; m++) {
            ck_assert_int_eq(mus_pattern_material(panels, i, m, &count, NULL), MUS_OK);
            if (count > 0)
                at += (size_t)snprintf(out + at, size - at, " %d %s", (int)count, mus_material_name(m));
        }
    }
}


START_TEST(the_words_choose_the_pieces)
{
    static const char *const rows[][2] = {
        {"tshirt", "neckband 1 rib"},
        {"tank", "neckband 1 rib, armhole_band 2 rib"},
        {"bodice", ""},
        {"turtleneck", ""},
        {"blouse_jewel_short", "front_facing 1 main 1 interfacing, back_left_facing 2 main 2 interfacing"},
        {"shirt_sleeveless",
         "front_left_armhole_facing 2 main 2 interfacing, back_armhole_facing 2 main 2 interfacing, "
         "under_collar_leaf 1 main, button_stand 2 interfacing"},
        {"jeans", "fly_facing 1 main 1 interfacing, fly_shield 1 main, belt_loops 1 main, pocket 2 main, "
                  "pocket_facing_left 2 main, pocket_bag_left 4 lining"},
        {"oxford_shirt", "under_collar_leaf 1 main, sleeve_placket 2 main, button_stand 2 interfacing"},
        {"chinos", "fly_facing 1 main 1 interfacing, fly_shield 1 main, belt_loops 1 main, welt 2 main 2 interfacing, "
                   "welt_bag 4 lining, pocket_facing_left 2 main, pocket_bag_left 4 lining"},
        {"coat_stand", "flap 4 main 2 interfacing, welt 2 main 2 interfacing, welt_bag 4 lining, under_collar 1 main, "
                       "button_stand 2 interfacing"},
        {"wrap_skirt_mini", "tie_long 1 main, tie_short 1 main"},
        {"faced_trousers", "leg_front_left_waist_facing 2 main 2 interfacing, leg_back_left_waist_facing 2 main 2 "
                           "interfacing, fly_facing 1 main 1 interfacing, fly_shield 1 main"},
        {"joggers", "elastic 1 elastic"},
        {"halter_waist_hip", "front_facing 1 main 1 interfacing, front_armhole_facing 2 main 2 interfacing, "
                             "back_left_armhole_facing 2 main 2 interfacing, elastic 2 elastic"},
        {"pencil_skirt_knee", ""},
        {"hoodie", "kangaroo_pocket 1 main"},
        {"hoodie_zip", "kangaroo_pocket_left 2 main, button_stand 2 interfacing"},
    };
    mus_context *context = support_context();
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        char names[512];
        mus_pattern *pattern = drafts_pattern(context, rows[i][0], "W40");
        told(mus_pattern_cut_only(pattern), names, sizeof names);
        ck_assert_msg(strcmp(names, rows[i][1]) == 0, "%s: %s", rows[i][0], names);
        mus_pattern_destroy(pattern);
    }
    support_context_end(context);
}
END_TEST


static double length_of(const mus_pattern *pattern, int32_t panel, const char *label)
{
    double length = 0.0;
    for (int32_t i = 0; i < mus_pattern_edge_count(pattern); i++)
        if (mus_pattern_edge_panel(pattern, i) == panel && strcmp(mus_pattern_edge_label(pattern, i), label) == 0)
            length += mus_pattern_edge_length(pattern, i);
    return length;
}


/* strips that are folded along their middle have the line at both ends: the stand of buttons and a placket */
START_TEST(a_strip_that_is_halved_is_marked_along_its_middle)
{
    static const char *const names[] = {"button_stand", "sleeve_placket"};
    mus_context *context = support_context();
    mus_pattern *pattern = drafts_pattern(context, "oxford_shirt", "W40");
    const mus_pattern *made = mus_pattern_cut_only(pattern);
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        const int32_t strip = mus_pattern_find_panel(made, names[i]);
        const double high = 0.5 * length_of(made, strip, "end"), wide = length_of(made, strip, "low");
        int32_t count = 0;
        for (int32_t m = 0; m < mus_pattern_mark_count(made); m++) {
            int32_t panel, n;
            const char *name;
            const double *xy;
            ck_assert_int_eq(mus_pattern_mark(made, m, &panel, &name, &n, &xy), MUS_OK);
            if (panel != strip) continue;
            ck_assert_str_eq(name, "fold");
            ck_assert_int_eq(n, 2);
            ck_assert_double_eq_tol(xy[1], 0.5 * high, 1e-9);
            ck_assert_double_eq_tol(xy[3], 0.5 * high, 1e-9);
            ck_assert_double_eq_tol(fabs(xy[2] - xy[0]), wide / 3.0, 1e-9);
            count++;
        }
        ck_assert_int_eq(count, 2);
    }
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


/* a facing has the edges that it is sewn to, darts closed: the same lengths; it is 5 cm wide, its ends as much longer
 * as they lean, its area a strip's */
START_TEST(a_facing_has_the_edge_that_it_faces)
{
    static const char *const rows[][4] = {{"blouse_square_short", "front", "front_facing", "neck"},
                                          {"blouse_keyhole_short", "front", "front_facing", "neck"},
                                          {"blouse_jewel_raglan", "sleeve_left", "sleeve_left_facing", "neck"},
                                          {"faced_trousers", "leg_front_left", "leg_front_left_waist_facing", "waist"},
                                          {"faced_trousers", "leg_back_left", "leg_back_left_waist_facing", "waist"}};
    mus_context *context = support_context();
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        mus_pattern *pattern = drafts_pattern(context, rows[i][0], "W40");
        const mus_pattern *made = mus_pattern_cut_only(pattern);
        const int32_t facing = mus_pattern_find_panel(made, rows[i][2]);
        const double own = length_of(pattern, mus_pattern_find_panel(pattern, rows[i][1]), rows[i][3]);
        ck_assert_double_eq_tol(length_of(made, facing, rows[i][3]), own, 1e-4);
        double longest = 0.0, shortest = 1.0, inner = 0.0;
        for (int32_t e = 0; e < mus_pattern_edge_count(made); e++) {
            const double length = mus_pattern_edge_length(made, e);
            if (mus_pattern_edge_panel(made, e) != facing) continue;
            if (strncmp(mus_pattern_edge_name(made, e), "inner", 5) == 0) {
                inner += length;
            } else if (strcmp(mus_pattern_edge_label(made, e), rows[i][3]) != 0) {
                longest = fmax(longest, length);
                shortest = fmin(shortest, length);
            }
        }
        ck_assert_double_ge(shortest, 0.05 - 1e-6);
        ck_assert_double_lt(longest, 0.06);
        const double strip = 0.025 * (own + inner);
        ck_assert_double_eq_tol(mus_pattern_panel_area(made, facing), strip, 0.1 * strip);
        mus_pattern_destroy(pattern);
    }
    support_context_end(context);
}
END_TEST


/* where a facing takes a whole shoulder its parallel ends in corners: each is the end of an edge, so that a DXF, whose
 * turn points are corners, gives the edges back */
START_TEST(no_corner_is_inside_the_inner_edge_of_a_facing)
{
    static const char *const designs[] = {"blouse_boat_sleeveless", "princess_half_square_sleeveless",
                                          "halter_empire_crop"};
    mus_context *context = support_context();
    for (size_t i = 0; i < sizeof designs / sizeof *designs; i++) {
        mus_pattern *pattern = drafts_pattern(context, designs[i], "W40");
        const mus_pattern *made = mus_pattern_cut_only(pattern);
        int32_t parted = 0;
        for (int32_t e = 0; e < mus_pattern_edge_count(made); e++) {
            double xy[1200];
            int32_t n = 0;
            if (strncmp(mus_pattern_edge_name(made, e), "inner", 5) != 0) continue;
            parted += strcmp(mus_pattern_edge_name(made, e), "inner_2") == 0;
            ck_assert_int_eq(mus_pattern_edge_polyline(made, e, 1, xy, 600, &n), MUS_OK);
            for (int32_t k = 1; k + 1 < n; k++) {
                const double *p = xy + 2 * k, a = p[0] - p[-2], b = p[1] - p[-1], c = p[2] - p[0], d = p[3] - p[1];
                ck_assert_double_ge(a * c + b * d, (0.8660 - 1e-9) * hypot(a, b) * hypot(c, d));
            }
        }
        ck_assert_int_gt(parted, 0);
        mus_pattern_destroy(pattern);
    }
    support_context_end(context);
}
END_TEST


/* the edge that a panel of the cut_only pattern copies: same name, on the panel whose name with `ending` is its own */
static int32_t copied(const mus_pattern *pattern, const mus_pattern *made, int32_t edge)
{
    static const char *const endings[] = {"_armhole_facing", "_waist_facing", "_facing"};
    char name[128];
    const char *own = mus_pattern_panel_name(made, mus_pattern_edge_panel(made, edge));
    snprintf(name, sizeof name, "%s", strncmp(own, "under_", 6) == 0 ? own + 6 : own);
    char *two = strstr(name, "_facing_2");
    if (two != NULL) two[7] = '\0';
    for (size_t i = 0; i < sizeof endings / sizeof *endings; i++) {
        const size_t n = strlen(name), m = strlen(endings[i]);
        if (n <= m || strcmp(name + n - m, endings[i]) != 0) continue;
        name[n - m] = '\0';
        break;
    }
    const int32_t panel = mus_pattern_find_panel(pattern, name);
    return panel != MUS_NONE ? mus_pattern_find_edge(pattern, panel, mus_pattern_edge_name(made, edge)) : MUS_NONE;
}


/* number of notches of a kind on an edge, and the sum of their distances from its nearer end [m] */
static int32_t notches_of(const mus_pattern *pattern, int32_t edge, int32_t kind, double *from)
{
    int32_t count = 0;
    const double length = mus_pattern_edge_length(pattern, edge);
    *from = 0.0;
    for (int32_t i = 0; i < mus_pattern_notch_count(pattern); i++) {
        int32_t of, own;
        double s;
        ck_assert_int_eq(mus_pattern_notch(pattern, i, &of, &s, &own), MUS_OK);
        if (of != edge || own != kind) continue;
        *from += fmin(s, length - s);
        count++;
    }
    return count;
}


/* over all designs: what is sewn on has the notches of its edge; the ends of facings are sewn as their edges are */
START_TEST(what_is_sewn_on_has_the_notches_of_its_edge)
{
    mus_context *context = support_context();
    int32_t notched = 0, sewn = 0;
    for (int32_t d = 0; d < mus_design_count(); d++) {
        const char *size = (mus_design_groups(d) & MUS_GROUP_WOMEN) != 0 ? "W40" : "M50";
        mus_pattern *pattern = drafts_pattern(context, mus_design_name(d), size);
        const mus_pattern *made = mus_pattern_cut_only(pattern);
        for (int32_t e = 0; made != NULL && e < mus_pattern_edge_count(made); e++) {
            const char *label = mus_pattern_panel_label(made, mus_pattern_edge_panel(made, e));
            const int32_t of = copied(pattern, made, e);
            if (of == MUS_NONE || (strcmp(label, "facing") != 0 && strcmp(label, "layer") != 0)) continue;
            if (fabs(mus_pattern_edge_length(pattern, of) - mus_pattern_edge_length(made, e)) > 2e-4) continue;
            for (int32_t kind = MUS_NOTCH_SINGLE; kind <= MUS_NOTCH_TRIPLE; kind++) {
                double a, b;
                const int32_t count = notches_of(pattern, of, kind, &a);
                ck_assert_msg(notches_of(made, e, kind, &b) == count && fabs(a - b) < 1e-3 * (count + 1),
                              "%s: %s.%s", mus_design_name(d),
                              mus_pattern_panel_name(made, mus_pattern_edge_panel(made, e)),
                              mus_pattern_edge_name(made, e));
                notched += count;
            }
        }
        sewn += made != NULL ? mus_pattern_seam_count(made) : 0;
        mus_pattern_destroy(pattern);
    }
    ck_assert_int_gt(notched, 500);
    ck_assert_int_gt(sewn, 500);
    support_context_end(context);
}
END_TEST


/* the direction of an edge over 8 mm about arc length s [m] from its end at t = 0, or at 1 when `back` */
static double heading(const mus_pattern *pattern, int32_t edge, double s, bool back)
{
    const double length = mus_pattern_edge_length(pattern, edge);
    double t[2] = {(s - 0.004) / length, (s + 0.004) / length}, xy[4];
    for (int32_t k = 0; k < 2; k++) t[k] = back ? 1.0 - t[k] : t[k];
    ck_assert_int_eq(mus_pattern_edge_at(pattern, edge, 2, t, xy), MUS_OK);
    return atan2(xy[3] - xy[1], xy[2] - xy[0]);
}


/* most that the under-collar's edge turns more within 8 mm than the collar's, 5 cm from either end [rad] */
static double corner_of(const mus_pattern *pattern, int32_t of, const mus_pattern *made, int32_t edge)
{
    double most = 0.0;
    for (int32_t end = 0; end < 2; end++)
        for (double s = 0.005; s < 0.05; s += 0.001) {
            const double own = heading(made, edge, s + 0.008, end == 1) - heading(made, edge, s, end == 1);
            const double turn = heading(pattern, of, s + 0.008, end == 1) - heading(pattern, of, s, end == 1);
            most = fmax(most, fabs(remainder(own - turn, 2.0 * acos(-1.0))));
        }
    return most;
}


/* an under-collar has the neck of its collar, and an outer edge 3 mm inside, to which it comes without a corner: its
 * area less by that strip */
START_TEST(an_under_collar_is_drawn_in_at_its_outer_edge)
{
    static const char *const rows[][3] = {{"oxford_shirt", "collar_leaf", "under_collar_leaf"},
                                          {"blouse_peter_pan_short", "collar", "under_collar"},
                                          {"coat", "collar", "under_collar"},
                                          {"stand_blouse", "collar", "under_collar"},
                                          {"middy", "collar", "under_collar"}};
    mus_context *context = support_context();
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        mus_pattern *pattern = drafts_pattern(context, rows[i][0], "W40");
        const mus_pattern *made = mus_pattern_cut_only(pattern);
        const int32_t panel = mus_pattern_find_panel(pattern, rows[i][1]);
        const int32_t under = mus_pattern_find_panel(made, rows[i][2]);
        double outer = 0.0, inner = 0.0;
        for (int32_t e = 0; e < mus_pattern_edge_count(made); e++) {
            if (mus_pattern_edge_panel(made, e) != under) continue;
            const int32_t of = mus_pattern_find_edge(pattern, panel, mus_pattern_edge_name(made, e));
            const double length = mus_pattern_edge_length(pattern, of), own = mus_pattern_edge_length(made, e);
            if (mus_pattern_edge_seam(pattern, of) == MUS_NONE) outer += 0.5 * (length + own);
            else inner = fmax(inner, fabs(length - own));
            if (mus_pattern_edge_seam(pattern, of) != MUS_NONE || length < 0.07) continue;
            const double corner = corner_of(pattern, of, made, e) * 180.0 / acos(-1.0);
            ck_assert_msg(corner < 6.0, "%s: a corner of %.1f degrees", rows[i][0], corner);
        }
        ck_assert_msg(inner < 2e-4, "%s: the neck is off by %.2f mm", rows[i][0], 1e3 * inner);
        const double less = mus_pattern_panel_area(pattern, panel) - mus_pattern_panel_area(made, under);
        ck_assert_msg(fabs(less - 0.003 * (outer - 0.05)) < 0.06 * less, "%s: %.2f cm2 less of %.1f cm outer edge",
                      rows[i][0], 1e4 * less, 1e2 * outer);
        mus_pattern_destroy(pattern);
    }
    support_context_end(context);
}
END_TEST


/* the group of designs, MUS_GROUP_*, that a table size is of, by its letter */
static int32_t group_of(const char *size)
{
    return size[0] == 'W' ? MUS_GROUP_WOMEN : size[0] == 'M' ? MUS_GROUP_MEN : MUS_GROUP_CHILDREN;
}


/* no outline crosses itself, whether the points of a collar are drawn in by more or by less than its chords are long */
START_TEST(under_collars_can_be_cut_in_every_size)
{
    static const char *const names[] = {"shirt", "polo", "blouse_peter_pan_short", "coat", "stand_blouse", "middy"};
    mus_context *context = support_context();
    int32_t sound = 0;
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        for (int32_t k = 0; k < mus_tape_size_count(); k++) {
            const char *size = mus_tape_size_name(k);
            if ((mus_design_groups(mus_design_find(names[i])) & group_of(size)) == 0) continue;
            mus_pattern *pattern = drafts_pattern(context, names[i], size);
            mus_faults *faults = NULL;
            int32_t count = 0;
            ck_assert_int_eq(mus_pattern_check(mus_pattern_cut_only(pattern), &count, &faults), MUS_OK);
            for (int32_t f = 0; f < count; f++) {
                int32_t kind;
                ck_assert_int_eq(mus_faults_item(faults, f, &kind, NULL, NULL, NULL), MUS_OK);
                ck_assert_msg(kind != MUS_FAULT_CROSSING, "%s of %s: %s", names[i], size, mus_faults_text(faults, f));
            }
            sound++;
            mus_faults_destroy(faults);
            mus_pattern_destroy(pattern);
        }
    ck_assert_int_gt(sound, 100);
    support_context_end(context);
}
END_TEST


/* bag and facing of a front pocket have the waist of the leg to the same place, and the facing covers the opening */
START_TEST(a_front_pocket_fills_what_is_cut_away)
{
    static const char *const sizes[] = {"W40", "M50"};
    mus_context *context = support_context();
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        mus_pattern *pattern = drafts_pattern(context, "jeans", sizes[i]);
        const mus_pattern *made = mus_pattern_cut_only(pattern);
        const double waist = drafts_length(made, "pocket_facing_left", "waist");
        int32_t n = 0, panel;
        const double *xy = NULL;
        const char *name = "";
        for (int32_t m = 0; strcmp(name, "pocket opening") != 0; m++)
            ck_assert_int_eq(mus_pattern_mark(pattern, m, &panel, &name, &n, &xy), MUS_OK);
        ck_assert_double_eq_tol(drafts_length(made, "pocket_bag_left", "waist"), waist, 1e-9);
        ck_assert_double_eq_tol(drafts_length(made, "pocket_bag_right", "waist"), waist, 1e-9);
        ck_assert_double_gt(waist, 0.06);
        ck_assert_double_lt(waist, drafts_length(pattern, "leg_front_left", "w1"));
        ck_assert_double_gt(mus_pattern_panel_area(made, mus_pattern_find_panel(made, "pocket_bag_left")),
                            2.0 * mus_pattern_panel_area(made, mus_pattern_find_panel(made, "pocket_facing_left")));
        ck_assert_int_eq(n, 13);
        mus_pattern_destroy(pattern);
    }
    support_context_end(context);
}
END_TEST


/* the band of a T-shirt is 0.87 of its neckline; an elastic is 0.9 of its casing and laps 2 cm */
START_TEST(strips_have_the_lengths_of_their_edges)
{
    mus_context *context = support_context();
    mus_pattern *tshirt = drafts_pattern(context, "tshirt", "M50");
    mus_pattern *joggers = drafts_pattern(context, "joggers", "M50");
    double neck = 0.0, waist = 0.0;
    for (int32_t i = 0; i < 2; i++) neck += length_of(tshirt, i, "neck");
    const mus_pattern *rib = mus_pattern_cut_only(tshirt), *tape = mus_pattern_cut_only(joggers);
    ck_assert_double_eq_tol(mus_pattern_edge_length(rib, mus_pattern_find_edge(rib, 0, "low")), 0.87 * neck, 1e-9);
    waist = length_of(joggers, mus_pattern_find_panel(joggers, "band_front"), "waist") +
            length_of(joggers, mus_pattern_find_panel(joggers, "band_back"), "waist");
    ck_assert_double_eq_tol(mus_pattern_edge_length(tape, mus_pattern_find_edge(tape, 0, "low")), 0.9 * waist + 0.02,
                            1e-9);
    mus_pattern_destroy(tshirt);
    mus_pattern_destroy(joggers);
    support_context_end(context);
}
END_TEST


/* what is pulled on without an opening passes the hip: casing and garment of each woven design with a band of elastic;
 * the elastic itself is shorter than the waist that it holds to */
START_TEST(a_woven_casing_passes_the_hip)
{
    static const char *const sizes[] = {"W40", "W52", "M50", "C116"};
    mus_context *context = support_context();
    int32_t seen = 0;
    for (int32_t k = 0; k < 4 * mus_design_count(); k++) {
        const int32_t design = k / 4;
        const char *words = mus_design_words(design), *size = sizes[k % 4];
        const mus__measures measures = drafts_measures(context, size);
        mus_tape *tape = drafts_tape(context, size);
        mus_pattern *pattern = NULL;
        double casing = 0.0, garment = 0.0;
        if (strstr(words, "band=elastic") != NULL && strstr(words, "cloth=knit") == NULL &&
            mus_design_draft(context, design, tape, NULL, &pattern) == MUS_OK) {
            for (int32_t i = 0; i < mus_pattern_panel_count(pattern); i++) {
                const bool band = strncmp(mus_pattern_panel_name(pattern, i), "band_", 5) == 0;
                casing += band ? length_of(pattern, i, "waist") : 0.0;
                garment += band ? 0.0 : length_of(pattern, i, "band");
            }
            const double passes = measures.v[MUS_MEASURE_HIP] + 0.02;
            ck_assert_msg(casing > passes - 1e-4 && garment > passes - 1e-4, "%s %s: %g and %g over a hip of %g",
                          mus_design_name(design), size, casing, garment, passes - 0.02);
            const mus_pattern *made = mus_pattern_cut_only(pattern);
            const int32_t panel = mus_pattern_find_panel(made, "elastic");
            ck_assert_int_ne(panel, MUS_NONE);
            const double strip = drafts_length(made, "elastic", "low");
            ck_assert_double_eq_tol(strip, 0.9 * (measures.v[MUS_MEASURE_WAIST] + 0.02) + 0.02, 1e-3);
            seen++;
        }
        mus_pattern_destroy(pattern);
        mus_tape_destroy(tape);
    }
    ck_assert_int_gt(seen, 20);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_cut_only(void);


Suite *mus_suite_cut_only(void)
{
    Suite *suite = suite_create("cut_only");
    TCase *tcase = tcase_create("pieces");
    tcase_set_timeout(tcase, 120);
    tcase_add_test(tcase, the_words_choose_the_pieces);
    tcase_add_test(tcase, a_woven_casing_passes_the_hip);
    tcase_add_test(tcase, a_strip_that_is_halved_is_marked_along_its_middle);
    tcase_add_test(tcase, a_facing_has_the_edge_that_it_faces);
    tcase_add_test(tcase, no_corner_is_inside_the_inner_edge_of_a_facing);
    tcase_add_test(tcase, what_is_sewn_on_has_the_notches_of_its_edge);
    tcase_add_test(tcase, an_under_collar_is_drawn_in_at_its_outer_edge);
    tcase_add_test(tcase, under_collars_can_be_cut_in_every_size);
    tcase_add_test(tcase, a_front_pocket_fills_what_is_cut_away);
    tcase_add_test(tcase, strips_have_the_lengths_of_their_edges);
    suite_add_tcase(suite, tcase);
    return suite;
}
