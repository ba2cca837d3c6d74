/*
 * test_edit_panel.c: panels separated, joined, filled out, mirrored, unfolded and faced by muslin/edit.h.
 */
#include "edit/edits.h"
#include "muslin/topology.h"


/* it lies on the panel, 5 mm behind it: the seam's two edges are that far apart in space */
static void facing_lies_behind(const mus_pattern *pattern, int32_t facing)
{
    mus_placement place[2];
    const int32_t of[2] = {mus_pattern_find_panel(pattern, "front_left"), facing};
    double world[2][3];
    for (int32_t i = 0; i < 2; i++) {
        mus_placement_init(&place[i], sizeof place[i]);
        ck_assert_int_eq(mus_pattern_placement(pattern, of[i], &place[i]), MUS_OK);
        double t = 0.3, p[2];
        const char *name = i == 0 ? "front_left" : "neck_facing";
        const double reversed = 1.0 - t;
        const mus_placement *c = &place[i];
        ck_assert_int_eq(mus_pattern_edge_at(pattern, edit_edge(pattern, name, "neck"), 1, i == 0 ? &t : &reversed, p),
                         MUS_OK);
        const double u = p[0] - c->bend_x, b = c->bend;
        const double v[3] = {b == 0.0 ? p[0] : c->bend_x + b * sin(u / b), p[1],
                             b == 0.0 ? 0.0 : b * (cos(u / b) - 1.0)};
        for (int32_t k = 0; k < 3; k++)
            world[i][k] = c->origin[k] + c->rotation[3 * k] * v[0] + c->rotation[3 * k + 1] * v[1] +
                          c->rotation[3 * k + 2] * v[2];
    }
    double apart = 0.0;
    for (int32_t k = 0; k < 3; k++) apart += (world[0][k] - world[1][k]) * (world[0][k] - world[1][k]);
    ck_assert_double_eq_tol(sqrt(apart), 0.005, 1e-9);
}


START_TEST(a_separation_adds_two_corners_three_edges_and_a_face)
{
    mus_context *context = support_context();
    mus_pattern *pattern = edit_skirt(context);
    const mus_topology before = edit_topology(pattern);
    const double area = edit_area(pattern);
    int32_t n, faults = edit_faults(pattern);
    const int32_t *edges, *turns;

    /* a yoke: from one side to the other, along a curve. The sides are divided in back as well, so the hem is the edge
     * from whose two neighbours the places are taken */
    const int32_t front = mus_pattern_find_panel(pattern, "skirt_front");
    ck_assert_int_ne(front, MUS_NONE);
    ck_assert_int_eq(mus_pattern_outline(pattern, front, &n, &edges, &turns), MUS_OK);
    int32_t k = 0;
    while (strcmp(mus_pattern_edge_label(pattern, edges[k]), "hem") != 0) k++;
    const int32_t a = edges[(k + 1) % n], b = edges[(k + n - 1) % n];
    double p[2], q[2], t = 0.5;
    ck_assert_int_eq(mus_pattern_edge_at(pattern, a, 1, &t, p), MUS_OK);
    ck_assert_int_eq(mus_pattern_edge_at(pattern, b, 1, &t, q), MUS_OK);
    const int32_t kind = MUS_PIECE_CUBIC;
    const double inner[4] = {0.7 * p[0] + 0.3 * q[0], p[1] - 0.03, 0.3 * p[0] + 0.7 * q[0], q[1] - 0.03};
    int32_t panel, seam;
    edit_well(mus_pattern_separate(pattern, &(mus_cut_def){.size = sizeof(mus_cut_def), .name = "yoke",
                                                           .seam_name = "yoke_seam", .edge_a = a,
                                                           .s_a = 0.5 * mus_pattern_edge_length(pattern, a),
                                                           .edge_b = b,
                                                           .s_b = 0.5 * mus_pattern_edge_length(pattern, b),
                                                           .npiece = 1, .kinds = &kind, .nxy = 2, .xy = inner},
                                   &panel, &seam));
    ck_assert_str_eq(mus_pattern_panel_name(pattern, panel), "yoke");
    mus_seam_def def;
    mus_seam_def_init(&def, sizeof def);
    ck_assert_int_eq(mus_pattern_seam(pattern, seam, &def), MUS_OK);
    ck_assert_str_eq(mus_pattern_edge_name(pattern, def.edge_a), "yoke_seam");
    ck_assert_str_eq(mus_pattern_edge_name(pattern, def.edge_b), "yoke_seam");
    ck_assert(mus_pattern_edge_length(pattern, def.edge_a) == mus_pattern_edge_length(pattern, def.edge_b));
    ck_assert_double_eq_tol(edit_area(pattern), area, 1e-12);
    ck_assert_int_eq(edit_faults(pattern), faults);

    /* splitting a panel and sewing it again adds (V, E, F) = (2, 3, 1) */
    mus_topology after = edit_topology(pattern);
    dart_same_topology(&before, &after, 2, 3, 1);

    /* joined again it is the panel that it was, but for the two corners in its sides */
    edit_well(mus_pattern_join_panels(pattern, seam, &panel));
    after = edit_topology(pattern);
    dart_same_topology(&before, &after, 2, 2, 0);
    ck_assert_double_eq_tol(edit_area(pattern), area, 1e-12);

    /* a line that leaves the panel is refused, and nothing is changed */
    const uint64_t bytes = edit_bytes(pattern);
    const int32_t hem = edit_edge(pattern, "skirt_back", "hem");
    double low[2];
    ck_assert_int_eq(mus_pattern_edge_at(pattern, hem, 1, &t, low), MUS_OK);
    const double out[4] = {0.1, -9.0, 0.2, -9.0};
    ck_assert_int_eq(mus_pattern_separate(pattern, &(mus_cut_def){.size = sizeof(mus_cut_def), .name = "x",
                                                                  .seam_name = "y", .edge_a = hem, .s_a = 0.05,
                                                                  .edge_b = hem, .s_b = 0.3, .npiece = 1,
                                                                  .kinds = &kind, .nxy = 2, .xy = out}, &panel,
                                          &seam),
                     MUS_ERR_ARG);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "the line lies outside it"));
    const double over[4] = {0.9, low[1] + 0.2, 0.9, low[1] + 0.3};
    ck_assert_int_eq(mus_pattern_separate(pattern, &(mus_cut_def){.size = sizeof(mus_cut_def), .name = "x",
                                                                  .seam_name = "y", .edge_a = hem, .s_a = 0.05,
                                                                  .edge_b = hem, .s_b = 0.3, .npiece = 1,
                                                                  .kinds = &kind, .nxy = 2, .xy = over}, &panel,
                                          &seam),
                     MUS_ERR_ARG);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "the line crosses its outline"));
    ck_assert_int_eq(panel, MUS_NONE);
    ck_assert_uint_eq(edit_bytes(pattern), bytes);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


START_TEST(fullness_goes_where_it_is_put)
{
    mus_context *context = support_context();
    mus_pattern *pattern = edit_skirt(context);
    const int32_t front = mus_pattern_find_panel(pattern, "skirt_front");
    const mus_topology before = edit_topology(pattern);
    const int32_t faults = edit_faults(pattern);
    ck_assert_int_eq(faults, 0);

    /* six slashes that open the hem by 24 cm; the waist is as long as it was, and nothing crosses */
    int32_t hem = edit_edge(pattern, "skirt_front", "hem"), waist = MUS_NONE;
    for (int32_t i = 0; i < mus_pattern_edge_count(pattern); i++)
        if (mus_pattern_edge_panel(pattern, i) == front && strcmp(mus_pattern_edge_label(pattern, i), "waist") == 0)
            waist = waist == MUS_NONE || mus_pattern_edge_length(pattern, i) > mus_pattern_edge_length(pattern, waist)
                        ? i
                        : waist;
    ck_assert_int_ne(waist, MUS_NONE);
    const double hem_length = mus_pattern_edge_length(pattern, hem);
    const double waist_length = mus_pattern_edge_length(pattern, waist);
    char name[128];
    snprintf(name, sizeof name, "%s", mus_pattern_edge_name(pattern, waist));
    edit_well(mus_pattern_flare(pattern, hem, waist, 6, 0.24));
    hem = edit_edge(pattern, "skirt_front", "hem"), waist = edit_edge(pattern, "skirt_front", name);
    ck_assert_double_eq_tol(mus_pattern_edge_length(pattern, hem), hem_length + 0.24, 6e-3);
    ck_assert_double_eq_tol(mus_pattern_edge_length(pattern, waist), waist_length, 1e-12);
    ck_assert_int_eq(edit_faults(pattern), faults);

    /* a knife pleat 3 cm deep at both ends: 6 cm of each edge, its lines drawn */
    const int32_t notches = mus_pattern_notch_count(pattern), marks = mus_pattern_mark_count(pattern);
    const double area = mus_pattern_panel_area(pattern, front), hem_now = mus_pattern_edge_length(pattern, hem);
    double p[2], q[2], t[2] = {0.5, 0.5};
    ck_assert_int_eq(mus_pattern_edge_at(pattern, hem, 1, &t[0], p), MUS_OK);
    ck_assert_int_eq(mus_pattern_edge_at(pattern, waist, 1, &t[1], q), MUS_OK);
    edit_well(mus_pattern_pleat(pattern, hem, 0.5 * hem_now, waist, 0.5 * waist_length, 0.03, 0.03));
    hem = edit_edge(pattern, "skirt_front", "hem"), waist = edit_edge(pattern, "skirt_front", name);
    ck_assert_double_eq_tol(mus_pattern_edge_length(pattern, hem), hem_now + 0.06, 1e-12);
    ck_assert_double_eq_tol(mus_pattern_edge_length(pattern, waist), waist_length + 0.06, 1e-12);
    ck_assert_double_eq_tol(mus_pattern_panel_area(pattern, front), area + 0.06 * mus__dist2(p, q), 1e-12);
    ck_assert_int_eq(mus_pattern_notch_count(pattern), notches + 4);
    ck_assert_int_eq(mus_pattern_mark_count(pattern), marks + 3);
    const double *xy;
    const char *mark;
    ck_assert_int_eq(mus_pattern_mark(pattern, marks + 1, NULL, &mark, NULL, &xy), MUS_OK);
    ck_assert_str_eq(mark, "fold");
    ck_assert_double_eq_tol(mus__dist2(xy, xy + 2), mus__dist2(p, q), 1e-12);

    /* lengthened by 5 cm on both panels the seams still match */
    const double along[2] = {-1.0, 0.0};
    double low[2];
    for (int32_t i = 0; i < 2; i++) {
        hem = edit_edge(pattern, i == 0 ? "skirt_front" : "skirt_back", "hem");
        ck_assert_int_eq(mus_pattern_edge_at(pattern, hem, 1, t, low), MUS_OK);
        low[1] += 0.15;
        edit_well(mus_pattern_lengthen(pattern, mus_pattern_edge_panel(pattern, hem), low, along, 0.05));
    }
    ck_assert_int_eq(edit_faults(pattern), faults);
    const mus_topology after = edit_topology(pattern);
    dart_same_topology(&before, &after, 0, 0, 0);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


START_TEST(a_panel_is_mirrored_unfolded_and_removed)
{
    mus_context *context = support_context();
    mus_pattern *pattern = drafts_pattern(context, "bodice", "W40");
    const int32_t panels = mus_pattern_panel_count(pattern);
    const double area = mus_pattern_panel_area(pattern, mus_pattern_find_panel(pattern, "front_left"));

    /* an image has the panel's area and its darts; twice mirrored it is the panel again, point by point */
    int32_t once, twice, n, m;
    edit_well(mus_pattern_mirror_panel(pattern, mus_pattern_find_panel(pattern, "front_left"), "once", &once));
    ck_assert_double_eq_tol(mus_pattern_panel_area(pattern, once), area, 1e-15);
    edit_well(mus_pattern_mirror_panel(pattern, once, "twice", &twice));
    const int32_t *edges, *turns;
    const int32_t own = mus_pattern_find_panel(pattern, "front_left");
    ck_assert_int_eq(mus_pattern_outline(pattern, own, &n, &edges, &turns), MUS_OK);
    ck_assert_int_eq(mus_pattern_outline(pattern, twice, &m, NULL, NULL), MUS_OK);
    ck_assert_int_eq(n, m);
    for (int32_t i = 0; i < n; i++) {
        const int32_t image = edit_edge(pattern, "twice", mus_pattern_edge_name(pattern, edges[i]));
        double t[2] = {0.0, 1.0}, p[4], q[4];
        ck_assert_int_eq(mus_pattern_edge_at(pattern, edges[i], 2, t, p), MUS_OK);
        ck_assert_int_eq(mus_pattern_edge_at(pattern, image, 2, t, q), MUS_OK);
        ck_assert((p[0] == q[0] && p[1] == q[1]) || (p[0] == q[2] && p[1] == q[3]));
    }
    edit_well(mus_pattern_remove_panel(pattern, twice));
    ck_assert_int_eq(mus_pattern_find_panel(pattern, "twice"), MUS_NONE);

    /* opened at the centre front it has twice the area, and both darts on both sides */
    edit_well(mus_pattern_unfold(pattern, edit_edge(pattern, "once", "cf")));
    ck_assert_double_eq_tol(mus_pattern_panel_area(pattern, mus_pattern_find_panel(pattern, "once")), 2.0 * area,
                            1e-12);
    edit_well(mus_pattern_remove_panel(pattern, mus_pattern_find_panel(pattern, "once")));
    ck_assert_int_eq(mus_pattern_panel_count(pattern), panels);

    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


START_TEST(a_facing_is_the_strip_along_an_edge)
{
    mus_context *context = support_context();
    mus_pattern *pattern = drafts_pattern(context, "bodice", "W40");
    const int32_t *edges, *turns;
    int32_t n;

    /* a neck facing 5 cm wide: its sewn edge is the neck, its ends the first 5 cm of shoulder and centre front; the
     * rim is now its inner edge, which has the label */
    const mus_topology before = edit_topology(pattern);
    const int32_t neck = edit_edge(pattern, "front_left", "neck");
    const double length = mus_pattern_edge_length(pattern, neck);
    int32_t facing;
    edit_well(mus_pattern_add_facing(pattern, neck, 0.05, "neck_facing", &facing));
    ck_assert_str_eq(mus_pattern_panel_name(pattern, facing), "neck_facing");
    ck_assert_double_eq_tol(mus_pattern_edge_length(pattern, edit_edge(pattern, "neck_facing", "neck")), length, 1e-12);
    ck_assert_int_eq(mus_pattern_outline(pattern, facing, &n, &edges, &turns), MUS_OK);
    ck_assert_int_eq(n, 4);
    double ends = 0.0;
    for (int32_t i = 0; i < n; i++) {
        const char *name = mus_pattern_edge_name(pattern, edges[i]);
        if (strncmp(name, "sh", 2) == 0 || strncmp(name, "cf", 2) == 0)
            ends += mus_pattern_edge_length(pattern, edges[i]);
    }
    ck_assert_double_eq_tol(ends, 0.1, 1e-12);
    const int32_t inner = edit_edge(pattern, "neck_facing", "inner");
    ck_assert_str_eq(mus_pattern_edge_label(pattern, inner), "neck");

    /* every place of it is 5 cm from the neck as it lies, but near the ends, where it turns to the edges beside */
    for (int32_t i = 2; i < 18; i++) {
        const double t = i / 20.0;
        double p[2], q[2], nearest = 1.0;
        ck_assert_int_eq(mus_pattern_edge_at(pattern, inner, 1, &t, p), MUS_OK);
        for (int32_t k = 0; k <= 2000; k++) {
            const double u = k / 2000.0;
            ck_assert_int_eq(mus_pattern_edge_at(pattern, edit_edge(pattern, "neck_facing", "neck"), 1, &u, q), MUS_OK);
            nearest = fmin(nearest, mus__dist2(p, q));
        }
        ck_assert_double_eq_tol(nearest, 0.05, 3e-3);
    }
    ck_assert_int_eq(edit_faults(pattern), 0);
    const mus_topology after = edit_topology(pattern);
    dart_same_topology(&before, &after, 2, 3, 1);

    facing_lies_behind(pattern, facing);

    ck_assert_int_eq(mus_pattern_add_facing(pattern, edit_edge(pattern, "front_left", "neck"), 0.05, "again", NULL),
                     MUS_ERR_ARG);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "it is sewn already"));
    ck_assert_int_eq(mus_pattern_add_facing(pattern, edit_edge(pattern, "back_left", "neck"), 0.5, "again", NULL),
                     MUS_ERR_ARG);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "a width of 0.5 m is outside"));
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_edit_panel(void);


Suite *mus_suite_edit_panel(void)
{
    Suite *suite = suite_create("edit_panel");
    TCase *tcase = tcase_create("edit_panel");
    tcase_add_test(tcase, a_separation_adds_two_corners_three_edges_and_a_face);
    tcase_add_test(tcase, fullness_goes_where_it_is_put);
    tcase_add_test(tcase, a_panel_is_mirrored_unfolded_and_removed);
    tcase_add_test(tcase, a_facing_is_the_strip_along_an_edge);
    suite_add_tcase(suite, tcase);
    return suite;
}
