/*
 * test_join_garments.c: garments over one another are one pattern: all cells of both, the same lengths and topology of
 * each piece, layers that copies, edits and files keep; a join that fails changes nothing.
 */
#include "muslin/exchange.h"
#include "muslin/muslin.h"
#include "support.h"

Suite *mus_suite_join_garments(void);


static mus_pattern *draft(mus_context *context, const char *name)
{
    mus_tape *tape;
    mus_pattern *pattern;
    ck_assert_int_eq(mus_tape_create(context, &tape), MUS_OK);
    ck_assert_int_eq(mus_tape_set_size(tape, "W40"), MUS_OK);
    ck_assert_int_eq(mus_design_draft(context, mus_design_find(name), tape, NULL, &pattern), MUS_OK);
    mus_tape_destroy(tape);
    return pattern;
}


START_TEST(a_join_has_all_cells_of_both)
{
    mus_context *context = support_context();
    mus_pattern *inner = draft(context, "tshirt"), *outer = draft(context, "skirt_plain"), *all;
    ck_assert_int_eq(mus_pattern_copy(inner, &all), MUS_OK);
    ck_assert_int_eq(mus_pattern_join(all, outer, 2), MUS_OK);
    ck_assert_int_eq(mus_pattern_join(all, inner, 5), MUS_OK);
    const int32_t panels = mus_pattern_panel_count(inner), more = mus_pattern_panel_count(outer);
    const int32_t edges = mus_pattern_edge_count(inner), edges_more = mus_pattern_edge_count(outer);
    const int32_t seams = mus_pattern_seam_count(inner), seams_more = mus_pattern_seam_count(outer);
    ck_assert_int_eq(mus_pattern_panel_count(all), 2 * panels + more);
    ck_assert_int_eq(mus_pattern_edge_count(all), 2 * edges + edges_more);
    ck_assert_int_eq(mus_pattern_seam_count(all), 2 * seams + seams_more);
    ck_assert_int_eq(mus_pattern_notch_count(all),
                     2 * mus_pattern_notch_count(inner) + mus_pattern_notch_count(outer));
    ck_assert_int_eq(mus_pattern_mark_count(all), 2 * mus_pattern_mark_count(inner) + mus_pattern_mark_count(outer));
    for (int32_t p = 0; p < mus_pattern_panel_count(all); p++) {
        ck_assert_int_eq(mus_pattern_layer(all, p), p < panels ? 0 : p < panels + more ? 2 : 5);
        ck_assert_int_eq(mus_pattern_find_panel(all, mus_pattern_panel_name(all, p)), p);
    }
    for (int32_t e = 0; e < edges; e++) {
        const double length = mus_pattern_edge_length(inner, e);
        ck_assert_double_eq(mus_pattern_edge_length(all, e), length);
        ck_assert_double_eq(mus_pattern_edge_length(all, edges + edges_more + e), length);
    }
    mus_topology one, two, both;
    mus_topology_init(&one, sizeof one);
    mus_topology_init(&two, sizeof two);
    mus_topology_init(&both, sizeof both);
    ck_assert_int_eq(mus_pattern_topology(inner, &one), MUS_OK);
    ck_assert_int_eq(mus_pattern_topology(outer, &two), MUS_OK);
    ck_assert_int_eq(mus_pattern_topology(all, &both), MUS_OK);
    ck_assert_int_eq(both.components, 2 * one.components + two.components);
    ck_assert_int_eq(both.euler, 2 * one.euler + two.euler);
    ck_assert_int_eq(both.loops, 2 * one.loops + two.loops);
    mus_pattern_destroy(all);
    mus_pattern_destroy(outer);
    mus_pattern_destroy(inner);
    support_context_end(context);
}
END_TEST


START_TEST(files_copies_and_edits_keep_layers)
{
    mus_context *context = support_context();
    mus_pattern *all = draft(context, "tshirt"), *outer = draft(context, "skirt_plain"), *copy, *read;
    char path[256];
    ck_assert_int_eq(mus_pattern_join(all, outer, 3), MUS_OK);
    ck_assert_int_eq(mus_pattern_copy(all, &copy), MUS_OK);
    support_scratch("layer.json", path, sizeof path);
    ck_assert_int_eq(mus_pattern_write(copy, path), MUS_OK);
    ck_assert_int_eq(mus_pattern_read(context, path, &read), MUS_OK);
    ck_assert_int_eq(mus_pattern_split_edge(copy, 0, 0.5 * mus_pattern_edge_length(copy, 0), NULL, NULL), MUS_OK);
    for (int32_t p = 0; p < mus_pattern_panel_count(all); p++) {
        ck_assert_int_eq(mus_pattern_layer(read, p), mus_pattern_layer(all, p));
        ck_assert_int_eq(mus_pattern_layer(copy, p), mus_pattern_layer(all, p));
    }
    mus_pattern_destroy(read);
    mus_pattern_destroy(copy);
    mus_pattern_destroy(outer);
    mus_pattern_destroy(all);
    support_context_end(context);
}
END_TEST


/* a collar that lies on its garment does so in a garment over another */
START_TEST(a_garment_keeps_the_order_of_its_own_layers)
{
    mus_context *context = support_context();
    mus_pattern *coat = draft(context, "coat"), *all;
    const int32_t collar = mus_pattern_find_panel(coat, "collar");
    ck_assert_int_eq(mus_pattern_layer(coat, collar), 1);
    ck_assert_int_eq(mus_pattern_layer(coat, mus_pattern_find_panel(coat, "back")), 0);
    ck_assert_int_eq(mus_pattern_copy(coat, &all), MUS_OK);
    ck_assert_int_eq(mus_pattern_join(all, coat, 2), MUS_OK);
    const int32_t panels = mus_pattern_panel_count(coat);
    for (int32_t p = 0; p < panels; p++)
        ck_assert_int_eq(mus_pattern_layer(all, panels + p), 2 + mus_pattern_layer(coat, p));
    ck_assert_int_eq(mus_pattern_join(all, coat, MUS_LAYERS_MOST - 1), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_panel_count(all), 2 * panels);

    /* two of them at once come down together */
    mus_pattern *above;
    ck_assert_int_eq(mus_pattern_copy(coat, &above), MUS_OK);
    for (int32_t p = 0; p < panels; p++)
        ck_assert_int_eq(mus_pattern_set_layer(above, p, 7 + mus_pattern_layer(coat, p)), MUS_OK);
    ck_assert_int_eq(mus_pattern_join(all, above, 4), MUS_OK);
    ck_assert_int_eq(mus_pattern_layer(all, 2 * panels + collar), 5);
    mus_pattern_destroy(above);
    mus_pattern_destroy(all);
    mus_pattern_destroy(coat);
    support_context_end(context);
}
END_TEST


START_TEST(layers_outside_the_range_are_refused)
{
    mus_context *context = support_context();
    mus_pattern *all = draft(context, "skirt_plain");
    const int32_t panels = mus_pattern_panel_count(all);
    ck_assert_int_eq(mus_pattern_join(all, NULL, 1), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_join(NULL, all, 1), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_join(all, all, -1), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_join(all, all, MUS_LAYERS_MOST), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_set_layer(all, panels, 1), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_set_layer(all, 0, MUS_LAYERS_MOST), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_set_layer(NULL, 0, 1), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_layer(all, panels), MUS_NONE);
    ck_assert_int_eq(mus_pattern_layer(NULL, 0), MUS_NONE);
    ck_assert_int_eq(mus_pattern_panel_count(all), panels);
    ck_assert_int_eq(mus_pattern_set_layer(all, 0, MUS_LAYERS_MOST - 1), MUS_OK);
    ck_assert_int_eq(mus_pattern_layer(all, 0), MUS_LAYERS_MOST - 1);

    /* itself over itself, sixteen times: every name is its own */
    ck_assert_int_eq(mus_pattern_join(all, all, 1), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_set_layer(all, 0, 0), MUS_OK);
    for (int32_t k = 1; k < 6; k++) ck_assert_int_eq(mus_pattern_join(all, all, k), MUS_OK);
    ck_assert_int_eq(mus_pattern_panel_count(all), 32 * panels);
    for (int32_t p = 0; p < 32 * panels; p++)
        ck_assert_int_eq(mus_pattern_find_panel(all, mus_pattern_panel_name(all, p)), p);
    mus_pattern_destroy(all);
    support_context_end(context);
}
END_TEST


START_TEST(a_join_without_memory_changes_nothing)
{
    mus_context *context = support_context();
    mus_pattern *all = draft(context, "tshirt"), *outer = draft(context, "skirt_plain");
    const int32_t panels = mus_pattern_panel_count(all), edges = mus_pattern_edge_count(all);
    mus_status status = MUS_ERR_MEMORY;
    for (int64_t k = 0; status != MUS_OK; k++) {
        support_fail_after(k, false);
        status = mus_pattern_join(all, outer, 1);
        support_fail_never();
        if (status == MUS_OK) break;
        ck_assert_int_eq(status, MUS_ERR_MEMORY);
        ck_assert_int_eq(mus_pattern_panel_count(all), panels);
        ck_assert_int_eq(mus_pattern_edge_count(all), edges);
    }
    ck_assert_int_gt(mus_pattern_panel_count(all), panels);
    mus_pattern_destroy(outer);
    mus_pattern_destroy(all);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_join_garments(void)
{
    Suite *suite = suite_create("join_garments");
    TCase *tests = tcase_create("layer");
    tcase_add_test(tests, a_join_has_all_cells_of_both);
    tcase_add_test(tests, files_copies_and_edits_keep_layers);
    tcase_add_test(tests, a_garment_keeps_the_order_of_its_own_layers);
    tcase_add_test(tests, layers_outside_the_range_are_refused);
    tcase_add_test(tests, a_join_without_memory_changes_nothing);
    suite_add_tcase(suite, tests);
    return suite;
}
