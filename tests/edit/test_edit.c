/*
 * test_edit.c: darts, points and seams edited by muslin/edit.h, and undo, which gives back every byte: the written
 * file, the canonical form, and each cell.
 */
#include "edit/edits.h"
#include "muslin/topology.h"


/* back step by step, forward again, and back: each time all that it was */
static void edits_back_and_forth(mus_pattern *pattern, int32_t n, const uint64_t *bytes, mus_pattern *const *copies)
{
    for (int32_t round = 0; round < 2; round++) {
        for (int32_t i = n - 2; i >= 0; i--) {
            edit_well(mus_pattern_undo(pattern));
            ck_assert_uint_eq(edit_bytes(pattern), bytes[i]);
            same_pattern(pattern, copies[i]);
        }
        ck_assert_int_eq(mus_pattern_undo_count(pattern), 0);
        ck_assert_int_eq(mus_pattern_undo(pattern), MUS_ERR_ARG);
        ck_assert_str_eq(mus_context_error(mus_pattern_context(pattern)), "undo: there are 0 edits to undo");
        for (int32_t i = 1; i < n && round == 0; i++) {
            edit_well(mus_pattern_redo(pattern));
            ck_assert_uint_eq(edit_bytes(pattern), bytes[i]);
            same_pattern(pattern, copies[i]);
        }
        if (round == 0) ck_assert_int_eq(mus_pattern_redo(pattern), MUS_ERR_ARG);
    }
}


START_TEST(a_bodice_is_recut_edit_by_edit_and_undone)
{
    mus_context *context = support_context();
    mus_pattern *pattern = drafts_pattern(context, "bodice", "W40");
    edit_well(mus_pattern_keep_history(pattern, 20));
    const mus_topology before = edit_topology(pattern);
    const int32_t panel = mus_pattern_find_panel(pattern, "front_left");
    const double area = mus_pattern_panel_area(pattern, panel);
    ck_assert_int_eq(edit_faults(pattern), 0);
    uint64_t bytes[8];
    mus_pattern *copies[8];
    int32_t n = 0;
#define STEP()                                                                                                         \
    do {                                                                                                               \
        bytes[n] = edit_bytes(pattern);                                                                                \
        edit_well(mus_pattern_copy(pattern, &copies[n++]));                                                            \
    } while (0)

    /* the bust dart of the left front to the middle of the shoulder: the point of the draft is the sewn one, 2 cm off
     * the bust point, so it turns about that; the back shoulder is divided too */
    STEP();
    int32_t leg = edit_edge(pattern, "front_left", "bd1");
    const int32_t target = edit_edge(pattern, "front_left", "sh"), keep = edit_edge(pattern, "front_left", "cf");
    double angle, width, depth, again;
    edit_well(mus_pattern_dart(pattern, leg, &angle, &width, &depth));
    const double s = 0.5 * mus_pattern_edge_length(pattern, target);
    edit_well(mus_pattern_rotate_dart(pattern, leg, target, s, keep, 1.0, &leg));
    edit_well(mus_pattern_dart(pattern, leg, &again, &width, &depth));
    ck_assert_double_eq_tol(again, angle, 1e-12);
    ck_assert_double_eq_tol(width, 2.0 * depth * sin(0.5 * angle), 1e-12);
    ck_assert_double_eq_tol(mus_pattern_panel_area(pattern, panel), area, 1e-12);
    ck_assert_int_eq(edit_faults(pattern), 0);
    mus_topology after = edit_topology(pattern);
    ck_assert(after.euler == before.euler && after.loops == before.loops && after.genus == before.genus);

    /* a third of it on to the neck */
    STEP();
    const int32_t neck = edit_edge(pattern, "front_left", "neck");
    edit_well(mus_pattern_rotate_dart(pattern, leg, neck, 0.5 * mus_pattern_edge_length(pattern, neck),
                                      edit_edge(pattern, "front_left", "cf"), 1.0 / 3.0, &leg));
    edit_well(mus_pattern_dart(pattern, leg, &again, NULL, NULL));
    ck_assert_double_eq_tol(again, angle / 3.0, 1e-12);
    ck_assert_double_eq_tol(mus_pattern_panel_area(pattern, panel), area, 1e-12);

    /* both end at one point, which is no place to sew: shortened each, the panel crosses nothing any more */
    ck_assert_int_eq(edit_faults(pattern), 1);
    STEP();
    edit_well(mus_pattern_shorten_dart(pattern, leg, 0.02));
    ck_assert_int_eq(edit_faults(pattern), 0);

    /* that one is gathered: the neck is one edge again, longer by the mouth */
    STEP();
    double mouth;
    leg = edit_edge(pattern, "front_left", "neck_d2");
    edit_well(mus_pattern_dart(pattern, leg, NULL, &mouth, NULL));
    double length = mus_pattern_edge_length(pattern, edit_edge(pattern, "front_left", "neck"));
    int32_t whole;
    edit_well(mus_pattern_release_dart(pattern, leg, &whole));
    ck_assert_str_eq(mus_pattern_edge_name(pattern, whole), "neck");
    ck_assert_double_gt(mus_pattern_edge_length(pattern, whole), length + mouth);
    ck_assert_int_eq(edit_faults(pattern), 0);
    STEP();

    edits_back_and_forth(pattern, n, bytes, copies);

    /* a new edit clears the list of edits to redo */
    ck_assert_int_eq(mus_pattern_redo_count(pattern), n - 1);
    edit_well(mus_pattern_set_edge_label(pattern, 0, "other"));
    ck_assert_int_eq(mus_pattern_redo_count(pattern), 0);
    for (int32_t i = 0; i < n; i++) mus_pattern_destroy(copies[i]);
    mus_pattern_destroy(pattern);
    support_context_end(context);
#undef STEP
}
END_TEST


START_TEST(a_dart_is_split_into_three_and_merged_again)
{
    mus_context *context = support_context();
    mus_pattern *pattern = drafts_pattern(context, "bodice", "W40");
    double angle, each, area = edit_area(pattern);
    edit_well(mus_pattern_dart(pattern, edit_edge(pattern, "front_left", "bd2"), &angle, NULL, NULL));
    const mus_topology before = edit_topology(pattern);

    /* three points of the neck, asked for in any order */
    const int32_t neck = edit_edge(pattern, "front_left", "neck");
    const double length = mus_pattern_edge_length(pattern, neck);
    const int32_t targets[3] = {neck, neck, neck};
    const double s[3] = {0.5 * length, 0.25 * length, 0.75 * length}, fractions[3] = {0.5, 0.2, 0.3};
    int32_t legs[3];
    edit_well(mus_pattern_split_dart(pattern, edit_edge(pattern, "front_left", "bd1"), 3, targets, s, fractions,
                                     edit_edge(pattern, "front_left", "cf"), legs));
    for (int32_t i = 0; i < 3; i++) {
        edit_well(mus_pattern_dart(pattern, legs[i], &each, NULL, NULL));
        ck_assert_double_eq_tol(each, fractions[i] * angle, 1e-12);
    }
    ck_assert_double_eq_tol(edit_area(pattern), area, 1e-12);
    mus_topology after = edit_topology(pattern);
    dart_same_topology(&before, &after, 4, 4, 0);

    /* two of them into the third: it has the whole angle */
    int32_t one;
    edit_well(mus_pattern_merge_darts(pattern, legs[1], legs[0], edit_edge(pattern, "front_left", "cf"), &one));
    edit_well(mus_pattern_dart(pattern, one, &each, NULL, NULL));
    ck_assert_double_eq_tol(each, 0.7 * angle, 1e-12);
    int32_t other = MUS_NONE;
    for (int32_t i = 0; i < mus_pattern_edge_count(pattern); i++) {
        if (mus_pattern_edge_panel(pattern, i) != mus_pattern_edge_panel(pattern, one)) continue;
        if (mus_pattern_dart(pattern, i, &each, NULL, NULL) == MUS_OK && fabs(each - 0.3 * angle) < 1e-9) other = i;
    }
    edit_well(mus_pattern_merge_darts(pattern, other, one, edit_edge(pattern, "front_left", "cf"), &one));
    edit_well(mus_pattern_dart(pattern, one, &each, NULL, NULL));
    ck_assert_double_eq_tol(each, angle, 1e-12);
    ck_assert_double_eq_tol(edit_area(pattern), area, 1e-12);
    after = edit_topology(pattern);
    dart_same_topology(&before, &after, 0, 0, 0);

    /* and into a seam to the waist dart, whose point is elsewhere: the back, the front, and a side of the front */
    const int32_t waist = edit_edge(pattern, "front_left", "wd2");
    double t = 0.0, depth;
    edit_well(mus_pattern_dart(pattern, waist, NULL, NULL, &depth));
    int32_t panel, seam;
    edit_well(
        mus_pattern_dart_to_seam(pattern, &(mus_cut_def){.size = sizeof(mus_cut_def), .name = "front_side",
                                                         .seam_name = "princess", .edge_a = one, .edge_b = waist,
                                                         .s_b = t}, &panel, &seam));
    mus_seam_def def;
    mus_seam_def_init(&def, sizeof def);
    ck_assert_int_eq(mus_pattern_seam(pattern, seam, &def), MUS_OK);
    ck_assert_double_eq_tol(mus_pattern_edge_length(pattern, def.edge_a), mus_pattern_edge_length(pattern, def.edge_b),
                            1e-12);
    ck_assert_double_eq_tol(edit_area(pattern), area, 1e-12);
    ck_assert_int_eq(edit_faults(pattern), 0);
    after = edit_topology(pattern);
    ck_assert(after.euler == before.euler && after.loops == before.loops && after.faces == before.faces + 1);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


START_TEST(points_move_and_their_curves_with_them)
{
    mus_context *context = support_context();
    sample s = sample_make(context);
    mus_pattern *pattern = s.pattern;
    const int32_t *kinds, *edges, *turns;
    const double *xy;
    int32_t npiece, nxy, n;
    double at[2];
    ck_assert_int_eq(mus_pattern_keep_history(pattern, 2), MUS_OK);

    /* a corner: both edges that meet there end there, to the bit */
    for (int32_t round = 0; round < 3; round++) {
        ck_assert_int_eq(mus_pattern_outline(pattern, s.front, &n, &edges, &turns), MUS_OK);
        int32_t start, end;
        ck_assert_int_eq(mus_pattern_edge_ends(pattern, edges[round], &start, &end), MUS_OK);
        ck_assert_int_eq(mus_pattern_point(pattern, start, NULL, at), MUS_OK);
        const double x = at[0] + 0.01, y = at[1] - 0.007;
        edit_well(mus_pattern_move_point(pattern, start, x, y));
        bool found = false;
        for (int32_t i = 0; i < mus_pattern_point_count(pattern); i++) {
            ck_assert_int_eq(mus_pattern_point(pattern, i, NULL, at), MUS_OK);
            found = found || (at[0] == x && at[1] == y);
        }
        ck_assert(found);
    }

    /* of a history of two the third edit back is forgotten */
    ck_assert_int_eq(mus_pattern_undo_count(pattern), 2);

    /* inner points of every edge: controls, joints, middles of arcs, which stay in their middle */
    int32_t moved = 0;
    for (int32_t i = 0; i < mus_pattern_edge_count(pattern); i++) {
        ck_assert_int_eq(mus_pattern_edge_pieces(pattern, i, &npiece, &kinds, &nxy, &xy), MUS_OK);
        const int32_t points = nxy;
        for (int32_t k = 1; k + 1 < points; k++) {
            ck_assert_int_eq(mus_pattern_edge_pieces(pattern, i, &npiece, &kinds, &nxy, &xy), MUS_OK);
            const double x = xy[2 * k] + 0.004, y = xy[2 * k + 1] + 0.003;
            const bool arc = npiece == 1 && kinds[0] == MUS_PIECE_ARC;
            edit_well(mus_pattern_move_control(pattern, i, k, x, y));
            ck_assert_int_eq(mus_pattern_edge_pieces(pattern, i, &npiece, &kinds, &nxy, &xy), MUS_OK);
            ck_assert_int_eq(nxy, points);
            if (arc)
                ck_assert_double_eq_tol(mus__dist2(xy, xy + 2), mus__dist2(xy + 2, xy + 4), 1e-15);
            else
                ck_assert(xy[2 * k] == x && xy[2 * k + 1] == y);
            moved++;
        }
        ck_assert_int_eq(mus_pattern_move_control(pattern, i, 0, 0.0, 0.0), MUS_ERR_ARG);
        ck_assert_int_eq(mus_pattern_move_control(pattern, i, points - 1, 0.0, 0.0), MUS_ERR_ARG);
    }
    ck_assert_int_ge(moved, 3);

    /* drawn again as a line, divided, and one again */
    edit_well(mus_pattern_redraw_edge(pattern, 2, 0, NULL, 0, NULL));
    const double length = mus_pattern_edge_length(pattern, 2);
    int32_t second, first;
    edit_well(mus_pattern_split_edge(pattern, 2, 0.4 * length, "second", &second));
    ck_assert_str_eq(mus_pattern_edge_name(pattern, second), "second");
    ck_assert_int_eq(mus_pattern_outline(pattern, mus_pattern_edge_panel(pattern, second), &n, &edges, &turns), MUS_OK);
    int32_t k = 0;
    while (edges[(k + 1) % n] != second) k++;
    edit_well(mus_pattern_merge_edges(pattern, edges[k], &first));
    ck_assert_double_eq_tol(mus_pattern_edge_length(pattern, first), length, 1e-12);
    ck_assert_int_eq(mus_pattern_edge_pieces(pattern, first, &npiece, NULL, NULL, NULL), MUS_OK);
    ck_assert_int_eq(npiece, 1);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


START_TEST(a_seam_walks_true_and_is_trued)
{
    mus_context *context = support_context();
    mus_pattern *pattern = drafts_pattern(context, "bodice", "W40");
    mus_seam_walk walk;
    mus_seam_walk_init(&walk, sizeof walk);

    /* every seam of the draft is true; shoulders meet the neck in a smooth line: 90 + 90 degrees within 3 */
    for (int32_t i = 0; i < mus_pattern_seam_count(pattern); i++) {
        edit_well(mus_pattern_walk_seam(pattern, i, &walk));
        ck_assert_double_eq_tol(walk.excess, 0.0, 5e-4);
        ck_assert(walk.corner_start > 0.0 && walk.corner_end > 0.0);
    }
    int32_t shoulder = edit_edge(pattern, "front_left", "sh");
    int32_t seam = mus_pattern_edge_seam(pattern, shoulder);
    edit_well(mus_pattern_walk_seam(pattern, seam, &walk));
    const double corners[2] = {walk.corner_start, walk.corner_end};

    /* a shoulder drawn 2 cm too long is so; trued at its outer end it is as long as the other, and the armhole follows
     */
    int32_t start, end;
    double p[2], q[2];
    ck_assert_int_eq(mus_pattern_edge_ends(pattern, shoulder, &start, &end), MUS_OK);
    ck_assert_int_eq(mus_pattern_point(pattern, start, NULL, p), MUS_OK);
    ck_assert_int_eq(mus_pattern_point(pattern, end, NULL, q), MUS_OK);
    const double length = mus__dist2(p, q), more = 1.0 + 0.02 / length;
    edit_well(mus_pattern_move_point(pattern, start, q[0] + more * (p[0] - q[0]), q[1] + more * (p[1] - q[1])));
    shoulder = edit_edge(pattern, "front_left", "sh");
    seam = mus_pattern_edge_seam(pattern, shoulder);
    edit_well(mus_pattern_walk_seam(pattern, seam, &walk));
    ck_assert_double_eq_tol(fabs(walk.excess), 0.02, 1e-12);
    ck_assert_int_ge(edit_faults(pattern), 1);
    edit_well(mus_pattern_true_seam(pattern, seam, shoulder, 0));
    seam = mus_pattern_edge_seam(pattern, edit_edge(pattern, "front_left", "sh"));
    edit_well(mus_pattern_walk_seam(pattern, seam, &walk));
    ck_assert_double_eq_tol(walk.excess, 0.0, 1e-12);
    ck_assert_double_eq_tol(walk.corner_start, corners[0], 1e-9);
    ck_assert_double_eq_tol(walk.corner_end, corners[1], 1e-9);
    ck_assert_int_eq(edit_faults(pattern), 0);

    /* a curve too: the armhole's end is moved along its tangent until it is a given ease longer */
    mus_pattern *sleeve = drafts_pattern(context, "tshirt", "W40");
    const int32_t cap = edit_edge(sleeve, "sleeve_left", "capF");
    const int32_t sewn = mus_pattern_edge_seam(sleeve, cap);
    mus_pattern_edge_ends(sleeve, cap, &start, &end);
    ck_assert_int_eq(mus_pattern_point(sleeve, end, NULL, p), MUS_OK);
    ck_assert_int_eq(mus_pattern_move_point(sleeve, end, p[0] - 0.01, p[1] + 0.004), MUS_OK);
    ck_assert_int_eq(mus_pattern_true_seam(sleeve, sewn, edit_edge(sleeve, "sleeve_left", "capF"), 1), MUS_OK);
    ck_assert_int_eq(mus_pattern_walk_seam(sleeve, sewn, &walk), MUS_OK);
    ck_assert_double_eq_tol(walk.excess, 0.0, 1e-11);
    ck_assert_int_eq(mus_pattern_true_seam(sleeve, sewn, edit_edge(sleeve, "sleeve_left", "hem"), 1), MUS_ERR_ARG);
    mus_pattern_destroy(sleeve);

    edit_well(mus_pattern_remove_seam(pattern, seam));
    ck_assert_int_eq(mus_pattern_edge_seam(pattern, edit_edge(pattern, "front_left", "sh")), MUS_NONE);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


START_TEST(edges_merge_with_the_ease_of_both_seams_whichever_way_they_were_sewn)
{
    /* seam 1: the back is to be 1 cm longer; seam 2, said from the back: the front 2 cm longer. Together: 1 cm */
    mus_context *context = support_context();
    mus_pattern *pattern = edit_skirt(context);
    const int32_t side = edit_edge(pattern, "skirt_front", "side");
    int32_t part;
    edit_well(mus_pattern_split_edge(pattern, side, 0.3, "low", &part));
    mus_seam_def one, two;
    mus_seam_def_init(&one, sizeof one);
    mus_seam_def_init(&two, sizeof two);
    const int32_t seams[2] = {mus_pattern_edge_seam(pattern, edit_edge(pattern, "skirt_front", "side")),
                              mus_pattern_edge_seam(pattern, edit_edge(pattern, "skirt_front", "low"))};
    edit_well(mus_pattern_seam(pattern, seams[0], &one));
    edit_well(mus_pattern_seam(pattern, seams[1], &two));
    edit_well(mus_pattern_remove_seam(pattern, seams[0] > seams[1] ? seams[0] : seams[1]));
    edit_well(mus_pattern_remove_seam(pattern, seams[0] > seams[1] ? seams[1] : seams[0]));
    const bool front = mus_pattern_edge_panel(pattern, one.edge_a) == mus_pattern_find_panel(pattern, "skirt_front");
    const int32_t swap = two.edge_a;
    one.ease = front ? 0.01 : -0.01;
    two.edge_a = two.edge_b, two.edge_b = swap, two.ease = front ? 0.02 : -0.02;
    edit_well(mus_pattern_add_seam(pattern, &one, NULL));
    edit_well(mus_pattern_add_seam(pattern, &two, NULL));
    const int32_t *edges, panel = mus_pattern_find_panel(pattern, "skirt_front");
    int32_t n, k = 0, whole;
    edit_well(mus_pattern_outline(pattern, panel, &n, &edges, NULL));
    while (edges[(k + 1) % n] != edit_edge(pattern, "skirt_front", "low") &&
           edges[(k + 1) % n] != edit_edge(pattern, "skirt_front", "side"))
        k++;
    edit_well(mus_pattern_merge_edges(pattern, edges[(k + 1) % n], &whole));
    mus_seam_def def;
    mus_seam_def_init(&def, sizeof def);
    edit_well(mus_pattern_seam(pattern, mus_pattern_edge_seam(pattern, whole), &def));
    const bool still = mus_pattern_edge_panel(pattern, def.edge_a) == panel;
    ck_assert_double_eq_tol(def.ease, still ? -0.01 : 0.01, 1e-15);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


/* a notch put on the armhole of a blouse stands on the sleeve too, in the same place of the seam; undone, on neither */
START_TEST(a_notch_is_put_on_both_edges_of_a_seam)
{
    mus_context *context = support_context();
    mus_pattern *pattern = drafts_pattern(context, "tshirt", "W40");
    mus_seam_walk walk;
    mus_seam_walk_init(&walk, sizeof walk);
    const int32_t cap = edit_edge(pattern, "sleeve_left", "capF"), seam = mus_pattern_edge_seam(pattern, cap);
    const int32_t before = mus_pattern_notch_count(pattern);
    const double length = mus_pattern_edge_length(pattern, cap);
    edit_well(mus_pattern_keep_history(pattern, 4));
    ck_assert_int_eq(mus_pattern_notch_seam(pattern, cap, 1.1 * length, MUS_NOTCH_SINGLE), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_notch_seam(pattern, cap, 0.1 * length, 4), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_notch_seam(pattern, -1, 0.1 * length, MUS_NOTCH_SINGLE), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_notch_seam(NULL, cap, 0.1 * length, MUS_NOTCH_SINGLE), MUS_ERR_ARG);
    edit_well(mus_pattern_notch_seam(pattern, cap, 0.1 * length, MUS_NOTCH_SINGLE));
    ck_assert_int_eq(mus_pattern_notch_count(pattern), before + 2);
    edit_well(mus_pattern_walk_seam(pattern, seam, &walk));
    ck_assert_int_eq(walk.notches_a, 2);
    ck_assert_int_eq(walk.notches_b, 2);
    ck_assert_double_le(walk.notch_off, 1e-9);
    edit_well(mus_pattern_undo(pattern));
    ck_assert_int_eq(mus_pattern_notch_count(pattern), before);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_edit(void);


Suite *mus_suite_edit(void)
{
    Suite *suite = suite_create("edit");
    TCase *tcase = tcase_create("edit");
    tcase_add_test(tcase, a_bodice_is_recut_edit_by_edit_and_undone);
    tcase_add_test(tcase, a_dart_is_split_into_three_and_merged_again);
    tcase_add_test(tcase, points_move_and_their_curves_with_them);
    tcase_add_test(tcase, a_seam_walks_true_and_is_trued);
    tcase_add_test(tcase, a_notch_is_put_on_both_edges_of_a_seam);
    tcase_add_test(tcase, edges_merge_with_the_ease_of_both_seams_whichever_way_they_were_sewn);
    suite_add_tcase(suite, tcase);
    return suite;
}
