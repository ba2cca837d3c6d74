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
        {"blouse_jewel_short",
         "front_facing 1 main 1 interfacing, back_left_facing 2 main 2 interfacing"},
        {"shirt_sleeveless",
         "front_left_armhole_facing 2 main 2 interfacing, back_armhole_facing 2 main 2 interfacing, "
         "button_stand 2 interfacing"},
        {"jeans", "fly_facing 1 main 1 interfacing, fly_shield 1 main, belt_loops 1 main, pocket 2 main"},
        {"faced_trousers", "leg_front_left_waist_facing 2 main 2 interfacing, leg_back_left_waist_facing 2 main 2 "
                           "interfacing, fly_facing 1 main 1 interfacing, fly_shield 1 main"},
        {"joggers", "elastic 1 elastic"},
        {"halter_waist_hip", "front_facing 1 main 1 interfacing, front_armhole_facing 2 main 2 interfacing, "
                             "back_left_armhole_facing 2 main 2 interfacing, elastic 2 elastic"},
        {"pencil_skirt_knee", ""},
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


/* a facing has the edges that it is sewn to, darts closed: the same lengths; its ends are 5 cm, its area a strip's */
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
        const int32_t inner = mus_pattern_find_edge(made, facing, "inner");
        const double own = length_of(pattern, mus_pattern_find_panel(pattern, rows[i][1]), rows[i][3]);
        ck_assert_double_eq_tol(length_of(made, facing, rows[i][3]), own, 1e-4);
        double longest = 0.0;
        for (int32_t e = 0; e < mus_pattern_edge_count(made); e++)
            if (mus_pattern_edge_panel(made, e) == facing && e != inner &&
                strcmp(mus_pattern_edge_label(made, e), rows[i][3]) != 0)
                longest = fmax(longest, fabs(mus_pattern_edge_length(made, e) - 0.05));
        ck_assert_double_lt(longest, 1e-3);
        const double strip = 0.025 * (own + mus_pattern_edge_length(made, inner));
        ck_assert_double_eq_tol(mus_pattern_panel_area(made, facing), strip, 0.1 * strip);
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


Suite *mus_suite_cut_only(void);


Suite *mus_suite_cut_only(void)
{
    Suite *suite = suite_create("cut_only");
    TCase *tcase = tcase_create("pieces");
    tcase_add_test(tcase, the_words_choose_the_pieces);
    tcase_add_test(tcase, a_facing_has_the_edge_that_it_faces);
    tcase_add_test(tcase, strips_have_the_lengths_of_their_edges);
    suite_add_tcase(suite, tcase);
    return suite;
}
