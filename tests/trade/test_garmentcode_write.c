/*
 * test_garmentcode_write.c: a pattern written as a GarmentCode specification and read again: areas, lengths, seams,
 * places; edges of several pieces are cut on both sides of a seam.
 */
#include <stdio.h>
#include <string.h>

#include "muslin/exchange.h"
#include "muslin/muslin.h"
#include "print/sample_patterns.h"
#include "support.h"


static mus_pattern *again_of(const mus_pattern *pattern)
{
    mus_context *context = mus_pattern_context(pattern);
    mus_pattern *again;
    char *bytes;
    size_t size;
    ck_assert_int_eq(mus_pattern_write_garmentcode_bytes(pattern, &bytes, &size), MUS_OK);
    const mus_status status = mus_pattern_read_from(context, bytes, size, "g.json", &again);
    ck_assert_msg(status == MUS_OK, "%s", mus_context_error(context));
    mus_context_alloc(context, bytes, 0);
    return again;
}


/* areas, perimeters and places of the panels are the same */
static void same_panels(const mus_pattern *pattern, const mus_pattern *again)
{
    ck_assert_int_eq(mus_pattern_panel_count(again), mus_pattern_panel_count(pattern));
    for (int32_t p = 0; p < mus_pattern_panel_count(pattern); p++) {
        mus_placement a, b;
        mus_placement_init(&a, sizeof a);
        mus_placement_init(&b, sizeof b);
        ck_assert_str_eq(mus_pattern_panel_name(again, p), mus_pattern_panel_name(pattern, p));
        ck_assert_double_eq_tol(mus_pattern_panel_area(again, p), mus_pattern_panel_area(pattern, p), 1e-9);
        ck_assert_double_eq_tol(mus_pattern_panel_perimeter(again, p), mus_pattern_panel_perimeter(pattern, p), 1e-8);
        ck_assert_int_eq(mus_pattern_placement(pattern, p, &a), MUS_OK);
        ck_assert_int_eq(mus_pattern_placement(again, p, &b), MUS_OK);
        for (int32_t i = 0; i < 3; i++) ck_assert_double_eq_tol(a.origin[i], b.origin[i], 1e-9);
        for (int32_t i = 0; i < 9; i++) ck_assert_double_eq_tol(a.rotation[i], b.rotation[i], 1e-9);
    }
}


START_TEST(specifications_come_back_edge_by_edge)
{
    static const char *const names[] = {"d11_002_mean_all", "d11_028_mean_all"};
    char relative[128], path[512];
    mus_context *context = support_context();
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        mus_pattern *pattern;
        snprintf(relative, sizeof relative, "garmentcode/specs/%s_specification.json", names[i]);
        if (support_data(relative, path, sizeof path) == NULL) continue;
        ck_assert_int_eq(mus_pattern_read(context, path, &pattern), MUS_OK);
        mus_pattern *again = again_of(pattern);
        same_panels(pattern, again);
        ck_assert_int_eq(mus_pattern_edge_count(again), mus_pattern_edge_count(pattern));
        ck_assert_int_eq(mus_pattern_seam_count(again), mus_pattern_seam_count(pattern));
        for (int32_t k = 0; k < mus_pattern_seam_count(again); k++) {
            mus_seam_def a, b;
            mus_seam_def_init(&a, sizeof a);
            mus_seam_def_init(&b, sizeof b);
            ck_assert_int_eq(mus_pattern_seam(pattern, k, &a), MUS_OK);
            ck_assert_int_eq(mus_pattern_seam(again, k, &b), MUS_OK);
            ck_assert(a.edge_a == b.edge_a && a.edge_b == b.edge_b && a.direction == b.direction);
        }
        mus_pattern_destroy(pattern);
        mus_pattern_destroy(again);
    }
    support_context_end(context);
}
END_TEST


START_TEST(designs_keep_shape_and_seams)
{
    static const char *const names[] = {"tshirt", "shirt", "trousers", "skirt"};
    mus_context *context = support_context();
    mus_tape *tape;
    ck_assert_int_eq(mus_tape_create(context, &tape), MUS_OK);
    ck_assert_int_eq(mus_tape_set_size(tape, "W40"), MUS_OK);
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        const int32_t design = mus_design_find(names[i]);
        mus_pattern *pattern;
        if (design == MUS_NONE || mus_design_draft(context, design, tape, NULL, &pattern) != MUS_OK) continue;
        mus_pattern *again = again_of(pattern);
        same_panels(pattern, again);
        ck_assert_int_ge(mus_pattern_edge_count(again), mus_pattern_edge_count(pattern));
        /* what is sewn has the same length */
        double sewn[2] = {0.0, 0.0};
        const mus_pattern *both[2] = {pattern, again};
        for (int32_t k = 0; k < 2; k++) {
            for (int32_t s = 0; s < mus_pattern_seam_count(both[k]); s++) {
                mus_seam_def seam;
                mus_seam_def_init(&seam, sizeof seam);
                ck_assert_int_eq(mus_pattern_seam(both[k], s, &seam), MUS_OK);
                if (!seam.laid)
                    sewn[k] += mus_pattern_edge_length(both[k], seam.edge_a) +
                               mus_pattern_edge_length(both[k], seam.edge_b);
            }
        }
        ck_assert_double_eq_tol(sewn[0], sewn[1], 1e-6);
        mus_pattern_destroy(pattern);
        mus_pattern_destroy(again);
    }
    mus_tape_destroy(tape);
    support_context_end(context);
}
END_TEST


START_TEST(edges_of_several_pieces_are_cut_where_the_other_has_a_joint)
{
    /* two squares; the seam's edges: a line then a cubic, and one line */
    mus_context *context = support_context();
    const double square[8] = {0, 0, 1, 0, 1, 1, 0, 1};
    const int32_t kinds[2] = {MUS_PIECE_LINE, MUS_PIECE_CUBIC};
    const double chain[6] = {1, 0.5, 1.0, 0.7, 1.0, 0.8};
    mus_pattern *pattern;
    ck_assert_int_eq(mus_pattern_create(context, "two", &pattern), MUS_OK);
    for (int32_t p = 0; p < 2; p++) {
        int32_t panel, point[4], edges[4], directions[4] = {1, 1, 1, 1};
        ck_assert_int_eq(mus_pattern_add_panel(pattern, p == 0 ? "a" : "b", &panel), MUS_OK);
        for (int32_t i = 0; i < 4; i++)
            ck_assert_int_eq(mus_pattern_add_point(pattern, panel, square[2 * i], square[2 * i + 1], &point[i]),
                             MUS_OK);
        for (int32_t i = 0; i < 4; i++) {
            mus_edge_def def;
            mus_edge_def_init(&def, sizeof def);
            def.start = point[i];
            def.end = point[(i + 1) % 4];
            if (p == 0 && i == 1) {
                def.npiece = 2;
                def.kinds = kinds;
                def.nxy = 3;
                def.xy = chain;
            }
            ck_assert_int_eq(mus_pattern_add_edge(pattern, &def, &edges[i]), MUS_OK);
        }
        ck_assert_int_eq(mus_pattern_set_outline(pattern, panel, 4, edges, directions), MUS_OK);
    }
    mus_seam_def seam;
    mus_seam_def_init(&seam, sizeof seam);
    seam.edge_a = 1;
    seam.edge_b = 7;
    ck_assert_int_eq(mus_pattern_add_seam(pattern, &seam, NULL), MUS_OK);
    mus_pattern *again = again_of(pattern);
    ck_assert_int_eq(mus_pattern_edge_count(again), 10);
    ck_assert_int_eq(mus_pattern_seam_count(again), 2);
    same_panels(pattern, again);
    for (int32_t s = 0; s < 2; s++) {
        ck_assert_int_eq(mus_pattern_seam(again, s, &seam), MUS_OK);
        ck_assert_double_eq_tol(mus_pattern_edge_length(again, seam.edge_a), 0.5, 1e-6);
        ck_assert_double_eq_tol(mus_pattern_edge_length(again, seam.edge_b), 0.5, 1e-6);
    }
    mus_pattern_destroy(again);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


START_TEST(no_memory_is_a_status)
{
    for (int64_t n = 0;; n++) {
        mus_context *context = support_context();
        mus_pattern *pattern = sample_shirt(context);
        char *bytes;
        size_t size;
        support_fail_after(n, false);
        const mus_status status = mus_pattern_write_garmentcode_bytes(pattern, &bytes, &size);
        support_fail_never();
        mus_context_alloc(context, bytes, 0);
        mus_pattern_destroy(pattern);
        support_context_end(context);
        if (status == MUS_OK) break;
        ck_assert_int_eq(status, MUS_ERR_MEMORY);
    }
}
END_TEST


Suite *mus_suite_garmentcode_write(void);

Suite *mus_suite_garmentcode_write(void)
{
    Suite *suite = suite_create("garmentcode_write");
    TCase *tests = tcase_create("garmentcode_write");
    tcase_add_test(tests, specifications_come_back_edge_by_edge);
    tcase_add_test(tests, designs_keep_shape_and_seams);
    tcase_add_test(tests, edges_of_several_pieces_are_cut_where_the_other_has_a_joint);
    tcase_add_test(tests, no_memory_is_a_status);
    suite_add_tcase(suite, tests);
    return suite;
}
