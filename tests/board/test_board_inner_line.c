/*
 * test_board_inner_line.c: lines inside a panel, as patches are sewn to: nothing is cut from them, and what is cut from
 * the corner that they hang from leaves each in the part that it lies in.
 */
#include "edit/edits.h"
#include "geom/polygon.h"
#include "muslin/topology.h"

enum { RIM = 4 };

/* sides and bottom of a pocket of 0.12 x 0.15 m, and two that are narrow: all hang from the upper left corner */
static const double pocket_line[8] = {0.14, 0.30, 0.14, 0.15, 0.26, 0.15, 0.26, 0.30};
static const double upper_line[8] = {0.10, 0.45, 0.10, 0.40, 0.20, 0.40, 0.20, 0.45};
static const double lower_line[8] = {0.02, 0.42, 0.02, 0.36, 0.05, 0.36, 0.05, 0.42};


/* a panel 0.4 m wide and 0.5 m long */
static mus_pattern *square(mus_context *context, int32_t *edge)
{
    static const double corner[RIM][2] = {{0.0, 0.0}, {0.4, 0.0}, {0.4, 0.5}, {0.0, 0.5}};
    static const char *const names[RIM] = {"hem", "right", "waist", "left"};
    const int32_t along[RIM] = {1, 1, 1, 1};
    mus_pattern *pattern;
    int32_t panel, point[RIM];
    ck_assert_int_eq(mus_pattern_create(context, "square", &pattern), MUS_OK);
    edit_well(mus_pattern_add_panel(pattern, "front", &panel));
    for (int i = 0; i < RIM; i++)
        edit_well(mus_pattern_add_point(pattern, panel, corner[i][0], corner[i][1], &point[i]));
    for (int i = 0; i < RIM; i++)
        edit_well(mus_pattern_add_edge(pattern, &(mus_edge_def){.size = sizeof(mus_edge_def), .name = names[i],
                                                                .start = point[i], .end = point[(i + 1) % RIM]},
                                       &edge[i]));
    edit_well(mus_pattern_set_outline(pattern, panel, RIM, edge, along));
    return pattern;
}


static void refused(mus_pattern *pattern, mus_status status, const char *what, uint64_t before)
{
    const char *text = mus_context_error(mus_pattern_context(pattern));
    ck_assert_msg(status == MUS_ERR_ARG && strstr(text, what) != NULL, "%d: %s, not %s", (int)status, text, what);
    ck_assert(edit_bytes(pattern) == before);
}


/* on both sides of the line is one cloth: whatever would open one of them */
START_TEST(nothing_is_cut_from_a_line_inside)
{
    mus_context *context = support_context();
    int32_t rim[RIM], leg;
    mus_pattern *pattern = square(context, rim);
    edit_well(mus_pattern_add_patch(pattern, 0, "pocket", 4, pocket_line, NULL));
    const double point[2] = {0.3, 0.1}, at[1] = {0.05}, depth[1] = {0.01}, s[2] = {0.2, 0.45};
    edit_well(mus_pattern_add_dart(pattern, edit_edge(pattern, "front", "right"), 0.25, 0.02, point, &leg));
    const int32_t keep = edit_edge(pattern, "front", "waist");
    const uint64_t before = edit_bytes(pattern);

    /* the bottom from the hem, the side from above the dart */
    for (int i = 0; i < 2; i++) {
        const int32_t in = edit_edge(pattern, "front", i == 0 ? "pocket_line_2" : "pocket_line_3");
        const int32_t out = edit_edge(pattern, "front", i == 0 ? "hem" : "right_2");
        const double far = i == 0 ? s[0] : s[1] - 0.26;
        const char *const what = i == 0 ? "pocket_line_2 is a line inside" : "pocket_line_3 is a line inside";
        refused(pattern, mus_pattern_spread(pattern, out, far, in, 0.06, 0.01, 0.0), what, before);
        refused(pattern, mus_pattern_spread(pattern, in, 0.06, out, far, 0.01, 0.0), what, before);
        refused(pattern, mus_pattern_spread(pattern, in, 0.0, out, far, 0.01, 0.0), "a line inside", before);
        refused(pattern, mus_pattern_pleat(pattern, out, far, in, 0.06, 0.01, 0.01), what, before);
        refused(pattern, mus_pattern_flare(pattern, out, in, 1, 0.01), what, before);
        refused(pattern, mus_pattern_lay_pleats(pattern, in, 1, at, depth), what, before);
        refused(pattern, mus_pattern_add_dart(pattern, in, 0.06, 0.01, point, NULL), what, before);
        refused(pattern, mus_pattern_rotate_dart(pattern, leg, in, 0.06, keep, 1.0, NULL), what, before);
        refused(pattern, mus_pattern_separate(pattern, &(mus_cut_def){.size = sizeof(mus_cut_def), .name = "a",
                                                                      .seam_name = "b", .edge_a = out, .s_a = far,
                                                                      .edge_b = in, .s_b = 0.0}, NULL, NULL),
                "a line inside", before);
        refused(pattern, mus_pattern_separate(pattern, &(mus_cut_def){.size = sizeof(mus_cut_def), .name = "a",
                                                                      .seam_name = "b", .edge_a = in, .s_a = 0.06,
                                                                      .edge_b = out, .s_b = far}, NULL, NULL),
                "a line inside", before);
        refused(pattern, mus_pattern_dart_to_seam(pattern, &(mus_cut_def){.size = sizeof(mus_cut_def), .name = "a",
                                                                          .seam_name = "b", .edge_a = leg,
                                                                          .edge_b = in, .s_b = 0.0}, NULL, NULL),
                "a line inside", before);
    }
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


/* does the middle of an edge inside lie within the rim of its panel, whose edges are lines? */
static bool lies_within(const mus_pattern *pattern, int32_t edge)
{
    int32_t edges[16], directions[16], n, start, end;
    double xy[32], middle[2];
    const double half = 0.5;
    edit_well(mus_pattern_rim(pattern, mus_pattern_edge_panel(pattern, edge), edges, directions, 16, &n));
    for (int32_t i = 0; i < n; i++) {
        mus_pattern_edge_ends(pattern, edges[i], &start, &end);
        mus_pattern_point(pattern, directions[i] > 0 ? start : end, NULL, xy + 2 * i);
    }
    edit_well(mus_pattern_edge_at(pattern, edge, 1, &half, middle));
    return mus__polygon_winding(n, xy, middle) != 0;
}


/* the lines that are inside do so, and the garment is what it was */
static void lines_lie_well(mus_pattern *pattern, const mus_topology *was, const char *how, int32_t k)
{
    static const char *const names[2] = {"upper_line_2", "lower_line_2"};
    const mus_topology t = edit_topology(pattern);
    ck_assert(t.euler == was->euler && t.components == was->components && t.orientable == was->orientable);
    for (int32_t i = 0; i < mus_pattern_edge_count(pattern); i++)
        for (int j = 0; j < 2; j++)
            if (strcmp(mus_pattern_edge_name(pattern, i), names[j]) == 0)
                ck_assert_msg(lies_within(pattern, i), "%s %d: %s lies outside", how, (int)k, names[j]);
}


/* from either edge of the corner that two patches hang from, to all round; patches put on in either order */
START_TEST(what_is_cut_from_its_corner_leaves_a_line_where_it_lies)
{
    static const double fractions[3] = {0.0, 0.04, 0.96};
    int32_t done[2] = {0}, between = 0;
    for (int32_t k = 0; k < 2 * 2 * 2 * RIM * 3; k++) {
        mus_context *context = support_context();
        int32_t rim[RIM];
        mus_pattern *pattern = square(context, rim);
        for (int i = 0; i < 2; i++) {
            const bool up = i == k % 2;
            edit_well(mus_pattern_add_patch(pattern, 0, up ? "upper" : "lower", 4, up ? upper_line : lower_line, NULL));
        }
        const mus_topology was = edit_topology(pattern);
        static const char *const names[RIM] = {"hem", "right", "waist", "left"};
        const bool slash = k / 2 % 2, end = k / 4 % 2;
        const int32_t from = edit_edge(pattern, "front", end ? "waist" : "left"),
                      to = edit_edge(pattern, "front", names[k / 8 % RIM]);
        const double s = end ? 0.4 : 0.0, u = fractions[k / 8 / RIM] * mus_pattern_edge_length(pattern, to);
        const mus_status status =
            slash ? mus_pattern_spread(pattern, from, s, to, u, 0.004, 0.004)
                  : mus_pattern_separate(pattern, &(mus_cut_def){.size = sizeof(mus_cut_def), .name = "new",
                                                                 .seam_name = "cut", .edge_a = from, .s_a = s,
                                                                 .edge_b = to, .s_b = u}, NULL, NULL);
        if (status == MUS_OK) {
            done[slash]++;
            lines_lie_well(pattern, &was, slash ? "slash" : "cut", k);
        } else {
            ck_assert_int_eq(status, MUS_ERR_ARG);
            between += slash && strstr(mus_context_error(context), "lies between") != NULL;
        }
        mus_pattern_destroy(pattern);
        support_context_end(context);
    }
    ck_assert_msg(done[0] >= 12 && done[1] >= 4 && between >= 8, "%d cuts, %d slashes, %d between", (int)done[0],
                  (int)done[1], (int)between);
}
END_TEST


Suite *mus_suite_board_inner_line(void);


Suite *mus_suite_board_inner_line(void)
{
    Suite *suite = suite_create("board_inner_line");
    TCase *tests = tcase_create("board_inner");
    tcase_add_test(tests, nothing_is_cut_from_a_line_inside);
    tcase_add_test(tests, what_is_cut_from_its_corner_leaves_a_line_where_it_lies);
    suite_add_tcase(suite, tests);
    return suite;
}
