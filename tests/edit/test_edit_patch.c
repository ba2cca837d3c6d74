/*
 * test_edit_patch.c: lines inside a panel and what is sewn to them, and layers of pleats: three and four sheets at an
 * edge, and nothing else changed.
 */
#include <math.h>
#include <string.h>

#include "edit/edits.h"
#include "muslin/topology.h"

/* sides and bottom of a pocket of 0.12 x 0.15 m */
static const double pocket_line[8] = {0.14, 0.30, 0.14, 0.15, 0.26, 0.15, 0.26, 0.30};


/* a tube of two panels 0.4 m wide and 0.5 m long, sewn at both sides, with its two openings declared */
static mus_pattern *tube(mus_context *context)
{
    mus_pattern *pattern;
    static const char *const names[4] = {"hem", "right", "waist", "left"};
    const int32_t along[4] = {1, 1, 1, 1};
    int32_t edge[2][4];
    ck_assert_int_eq(mus_pattern_create(context, "tube", &pattern), MUS_OK);
    for (int p = 0; p < 2; p++) {
        const double corner[4][2] = {{0.0, 0.0}, {0.4, 0.0}, {0.4, 0.5}, {0.0, 0.5}};
        int32_t panel, point[4];
        ck_assert_int_eq(mus_pattern_add_panel(pattern, p == 0 ? "front" : "back", &panel), MUS_OK);
        for (int i = 0; i < 4; i++)
            mus_pattern_add_point(pattern, panel, corner[i][0], corner[i][1], &point[i]);
        for (int i = 0; i < 4; i++) {
            mus_pattern_add_edge(pattern, &(mus_edge_def){.size = sizeof(mus_edge_def), .name = names[i],
                                                          .start = point[i], .end = point[(i + 1) % 4]},
                                 &edge[p][i]);
            if (i % 2 == 0) mus_pattern_set_edge_label(pattern, edge[p][i], names[i]);
        }
        ck_assert_int_eq(mus_pattern_set_outline(pattern, panel, 4, edge[p], along), MUS_OK);
    }
    for (int i = 1; i < 4; i += 2) {
        mus_seam_def seam;
        mus_seam_def_init(&seam, sizeof seam);
        seam.edge_a = edge[0][i], seam.edge_b = edge[1][4 - i];
        ck_assert_int_eq(mus_pattern_add_seam(pattern, &seam, NULL), MUS_OK);
    }
    mus_pattern_add_opening(pattern, "hem");
    mus_pattern_add_opening(pattern, "waist");
    return pattern;
}


static mus_homology homology_of(const mus_pattern *pattern)
{
    mus_homology h;
    mus_homology_init(&h, sizeof h);
    ck_assert_int_eq(mus_pattern_homology(pattern, 1, &h, NULL, 0), MUS_OK);
    return h;
}


/* tube: V 4, E 6, F 2. The patch adds 4 points of the line, a bridge, 3 edges of the line and the mouth, and a face:
 * chi = 8 - 11 + 3 = 0 still, one way round, three edges with three sheets */
START_TEST(a_patch_is_a_third_sheet_and_changes_nothing_else)
{
    mus_context *context = support_context();
    mus_pattern *pattern = tube(context);
    const double area = mus_pattern_panel_area(pattern, 0), round = mus_pattern_panel_perimeter(pattern, 0);
    int32_t patch, n, edges[16], directions[16];
    ck_assert_int_eq(edit_faults(pattern), 0);
    edit_well(mus_pattern_add_patch(pattern, 0, "pocket", 4, pocket_line, &patch));
    ck_assert_str_eq(mus_pattern_panel_name(pattern, patch), "pocket");
    ck_assert_msg(edit_faults(pattern) == 0, "%s", mus_context_error(context));

    const mus_topology t = edit_topology(pattern);
    const int32_t got[7] = {t.vertices, t.edges, t.faces, t.euler, t.components, t.loops, t.manifold};
    const int32_t want[7] = {8, 11, 3, 0, 1, MUS_NONE, 0};
    for (int i = 0; i < 7; i++) ck_assert_msg(got[i] == want[i], "%d is %d, not %d", i, (int)got[i], (int)want[i]);
    ck_assert_int_eq(t.orientable, 1);
    const mus_homology h = homology_of(pattern);
    ck_assert(h.betti[0] == 1 && h.betti[1] == 1 && h.betti[2] == 0 && h.torsion == 0);

    /* the cut line has not changed */
    ck_assert_double_eq_tol(mus_pattern_panel_area(pattern, 0), area, 1e-15);
    ck_assert_double_eq_tol(mus_pattern_panel_perimeter(pattern, 0), round, 1e-15);
    ck_assert_double_eq_tol(mus_pattern_panel_area(pattern, patch), 0.12 * 0.15, 1e-15);
    ck_assert_int_eq(mus_pattern_rim(pattern, 0, edges, directions, 16, &n), MUS_OK);
    ck_assert_int_eq(n, 4);
    for (int i = 0; i < n; i++) ck_assert_int_eq(directions[i], 1);
    ck_assert_int_eq(mus_pattern_rim(pattern, patch, NULL, NULL, 0, &n), MUS_OK);
    ck_assert_int_eq(n, 4);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


/* two pockets side by side, one of them drawn the other way round; copied, written and read */
START_TEST(patches_are_kept_by_files_copies_and_mirrors)
{
    mus_context *context = support_context();
    mus_pattern *pattern = tube(context), *read;
    const double other[8] = {0.36, 0.30, 0.36, 0.15, 0.28, 0.15, 0.28, 0.30};
    char path[512];
    int32_t made;
    edit_well(mus_pattern_add_patch(pattern, 0, "pocket", 4, pocket_line, NULL));
    edit_well(mus_pattern_add_patch(pattern, 0, "watch", 4, other, NULL));
    ck_assert_int_eq(edit_faults(pattern), 0);
    support_scratch("patch.json", path, sizeof path);
    edit_well(mus_pattern_write(pattern, path));
    ck_assert_int_eq(mus_pattern_read(context, path, &read), MUS_OK);
    same_pattern(pattern, read);
    mus_pattern_destroy(read);

    /* the mirror image of the panel has the lines too, and no more edges than they need */
    const int32_t edges = mus_pattern_edge_count(pattern);
    edit_well(mus_pattern_mirror_panel(pattern, 0, "image", &made));
    ck_assert_int_eq(mus_pattern_edge_count(pattern), edges + 4 + 2 * 4);
    ck_assert_double_eq_tol(mus_pattern_panel_perimeter(pattern, made), 1.8, 1e-12);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


/* faults of a garment are found when it has a pocket too */
START_TEST(a_patch_hides_no_fault)
{
    mus_context *context = support_context();
    mus_pattern *pattern = tube(context);
    mus_faults *faults;
    int32_t kind;
    edit_well(mus_pattern_add_patch(pattern, 0, "pocket", 4, pocket_line, NULL));
    mus_pattern_add_opening(pattern, "neck");
    edit_well(mus_pattern_check(pattern, NULL, &faults));
    ck_assert_int_eq(mus_faults_count(faults), 1);
    edit_well(mus_faults_item(faults, 0, &kind, NULL, NULL, NULL));
    ck_assert_int_eq(kind, MUS_FAULT_OPENING);
    ck_assert_ptr_nonnull(strstr(mus_faults_text(faults, 0), "neck"));
    mus_faults_destroy(faults);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


/* a pleat in a hem that is free: the hem is open as before; files keep what is laid */
START_TEST(pleats_change_no_opening)
{
    mus_context *context = support_context();
    mus_pattern *pattern = tube(context), *read;
    char path[512];
    const int32_t hem = edit_edge(pattern, "front", "hem");
    const double length = mus_pattern_edge_length(pattern, hem), at[1] = {0.4 * length}, depth[1] = {0.1 * length};
    ck_assert_int_eq(edit_faults(pattern), 0);
    edit_well(mus_pattern_lay_pleats(pattern, hem, 1, at, depth));
    ck_assert_int_eq(edit_faults(pattern), 0);
    ck_assert_int_eq(edit_topology(pattern).manifold, 0);
    support_scratch("pleat.json", path, sizeof path);
    edit_well(mus_pattern_write(pattern, path));
    ck_assert_int_eq(mus_pattern_read(context, path, &read), MUS_OK);
    same_pattern(pattern, read);
    mus_pattern_destroy(read);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


START_TEST(patches_that_cannot_be_sewn_are_refused)
{
    mus_context *context = support_context();
    mus_pattern *pattern = tube(context);
    const double outside[8] = {0.3, 0.3, 0.3, 0.1, 0.5, 0.1, 0.5, 0.3};
    const double crossed[8] = {0.1, 0.1, 0.3, 0.3, 0.3, 0.1, 0.1, 0.3};
    const double flat[6] = {0.1, 0.1, 0.2, 0.1, 0.3, 0.1}, nothing[6] = {0.1, (double)NAN, 0.2, 0.1, 0.3, 0.2};
    const double rim[6] = {0.1, 0.0005, 0.2, 0.1, 0.3, 0.2};
    const uint64_t before = edit_bytes(pattern);
    ck_assert_int_eq(mus_pattern_add_patch(pattern, 0, "pocket", 4, outside, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_add_patch(pattern, 0, "pocket", 4, crossed, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_add_patch(pattern, 0, "pocket", 3, flat, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_add_patch(pattern, 0, "pocket", 3, nothing, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_add_patch(pattern, 0, "pocket", 3, rim, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_add_patch(pattern, 0, "pocket", 2, pocket_line, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_add_patch(pattern, 0, "pocket", 4, NULL, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_add_patch(pattern, 0, "front", 4, pocket_line, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_add_patch(pattern, 0, NULL, 4, pocket_line, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_add_patch(pattern, 7, "pocket", 4, pocket_line, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_add_patch(NULL, 0, "pocket", 4, pocket_line, NULL), MUS_ERR_ARG);
    ck_assert(edit_bytes(pattern) == before);
    edit_well(mus_pattern_add_patch(pattern, 0, "pocket", 4, pocket_line, NULL));
    ck_assert_int_eq(mus_pattern_add_patch(pattern, 0, "second", 4, pocket_line, NULL), MUS_ERR_ARG);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


START_TEST(a_patch_without_memory_leaves_the_pattern)
{
    for (int64_t n = 0;; n++) {
        mus_context *context = support_context();
        mus_pattern *pattern = tube(context);
        support_fail_after(n, false);
        const mus_status status = mus_pattern_add_patch(pattern, 0, "pocket", 4, pocket_line, NULL);
        int32_t faults = 0;
        const mus_status checked = status == MUS_OK ? mus_pattern_check(pattern, &faults, NULL) : MUS_OK;
        support_fail_never();
        ck_assert_int_eq(mus_pattern_panel_count(pattern), status == MUS_OK ? 3 : 2);
        mus_pattern_destroy(pattern);
        support_context_end(context);
        if (status == MUS_OK && checked == MUS_OK) break;
        ck_assert(status == MUS_ERR_MEMORY || checked == MUS_ERR_MEMORY);
    }
}
END_TEST


Suite *mus_suite_edit_patch(void);


Suite *mus_suite_edit_patch(void)
{
    Suite *suite = suite_create("edit_patch");
    TCase *tests = tcase_create("patch");
    tcase_add_test(tests, a_patch_is_a_third_sheet_and_changes_nothing_else);
    tcase_add_test(tests, patches_are_kept_by_files_copies_and_mirrors);
    tcase_add_test(tests, a_patch_hides_no_fault);
    tcase_add_test(tests, pleats_change_no_opening);
    tcase_add_test(tests, patches_that_cannot_be_sewn_are_refused);
    tcase_add_test(tests, a_patch_without_memory_leaves_the_pattern);
    suite_add_tcase(suite, tests);
    return suite;
}
