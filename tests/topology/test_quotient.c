/*
 * test_quotient.c: what is no surface: three sheets at an edge, an edge folded on itself, a point that is a pinch.
 */
#include "muslin/topology.h"
#include "topology/gluing.h"
#include "topology/quotient.h"


static mus_topology quotient_topology(const mus_pattern *pattern)
{
    mus_topology t;
    mus_topology_init(&t, sizeof t);
    ck_assert_int_eq(mus_pattern_topology(pattern, &t), MUS_OK);
    return t;
}


START_TEST(a_seam_makes_one_class_of_two_sheets)
{
    mus_context *context = support_context();
    mus_pattern *pattern = gluing_make(context, "A: a b c d; B: a b c d", "A.b B.d; A.c B.a direct", 0);
    mus__quotient q;
    ck_assert_int_eq(mus__quotient_make(pattern, false, &q), MUS_OK);
    ck_assert_int_eq(q.nword, 8);
    ck_assert(q.root[7] == 1 && q.sheets[1] == 2 && q.sheet[2] == 1 && q.sheet[3] == 7);
    ck_assert(q.sign[7] == -1 && q.sign[4] == 1 && q.root[4] == 2);
    ck_assert(mus__quotient_same_side(&q, 1, 7) && !mus__quotient_same_side(&q, 2, 4));
    ck_assert(mus__quotient_next(&q, 3, 1) == 0 && mus__quotient_next(&q, 4, -1) == 7);
    ck_assert(!q.folded);
    mus__free(context, q.block);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


START_TEST(an_edge_sewn_both_ways_is_folded)
{
    /* a to b reversed and direct: each point of the edge meets its mirror image */
    mus_context *context = support_context();
    mus_pattern *pattern = gluing_make(context, "A: a b c d; B: a b c d", "A.b B.d; A.b B.d direct", 0);
    mus_topology t = quotient_topology(pattern);
    ck_assert(t.manifold == 0 && t.orientable == 0 && t.loops == MUS_NONE && t.genus == MUS_NONE);
    ck_assert_int_eq(mus_pattern_loop(pattern, 0, NULL, 0, NULL, NULL), MUS_ERR_PATTERN);
    mus_pattern_destroy(pattern);

    /* the same seam twice says nothing new */
    pattern = gluing_make(context, "A: a b c d; B: a b c d", "A.b B.d; B.d A.b", 0);
    t = quotient_topology(pattern);
    ck_assert(t.manifold == 1 && t.orientable == 1 && t.loops == 1 && t.genus == 0);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


START_TEST(a_point_passed_twice_is_a_pinch)
{
    /* two triangles that share one corner: a word of six edges over five points; cut to size it falls apart there */
    mus_context *context = support_context();
    mus_pattern *pattern;
    double xy[10] = {0.0, 0.0, 1.0, -1.0, 1.0, 1.0, -1.0, 1.0, -1.0, -1.0};
    int32_t panel, p[5], e[6], along[6] = {1, 1, 1, 1, 1, 1};
    static const int32_t ends[6][2] = {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {3, 4}, {4, 0}};
    ck_assert_int_eq(mus_pattern_create(context, "pinch", &pattern), MUS_OK);
    ck_assert_int_eq(mus_pattern_add_panel(pattern, "p", &panel), MUS_OK);
    for (int32_t i = 0; i < 5; i++)
        ck_assert_int_eq(mus_pattern_add_point(pattern, panel, xy[2 * i], xy[2 * i + 1], &p[i]), MUS_OK);
    for (int32_t i = 0; i < 6; i++)
        ck_assert_int_eq(mus_pattern_add_edge(pattern, &(mus_edge_def){.size = sizeof(mus_edge_def),
                                                                       .start = p[ends[i][0]],
                                                                       .end = p[ends[i][1]]}, &e[i]),
                         MUS_OK);
    ck_assert_int_eq(mus_pattern_set_outline(pattern, panel, 6, e, along), MUS_OK);
    mus_topology t = quotient_topology(pattern);
    ck_assert(t.vertices == 5 && t.edges == 6 && t.euler == 0 && t.loops == 1);
    ck_assert(t.manifold == 0 && t.genus == MUS_NONE);
    bool crosses;
    int32_t a, b;
    ck_assert_int_eq(mus__panel_crosses(pattern, panel, &crosses, &a, &b), MUS_OK);
    ck_assert(crosses);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


START_TEST(loose_edges_and_construction_points_are_no_cells_of_the_surface)
{
    mus_context *context = support_context();
    mus_pattern *pattern = gluing_make(context, "A: a b c d", "A.b A.d", 0);
    mus_topology before = quotient_topology(pattern);
    int32_t p, edge;
    ck_assert_int_eq(mus_pattern_add_point(pattern, 0, 5.0, 5.0, &p), MUS_OK);
    ck_assert_int_eq(mus_pattern_add_edge(pattern, &(mus_edge_def){.size = sizeof(mus_edge_def), .name = "help",
                                                                   .start = 0, .end = p}, &edge), MUS_OK);
    mus_topology after = quotient_topology(pattern);
    ck_assert_mem_eq(&before, &after, sizeof before);

    /* a seam to it joins nothing either */
    mus_seam_def def;
    mus_seam_def_init(&def, sizeof def);
    def.edge_a = edge, def.edge_b = 0;
    ck_assert_int_eq(mus_pattern_add_seam(pattern, &def, NULL), MUS_OK);
    after = quotient_topology(pattern);
    ck_assert(after.edges == before.edges && after.components == 1 && after.loops == before.loops);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_quotient(void);


Suite *mus_suite_quotient(void)
{
    Suite *suite = suite_create("quotient");
    TCase *tcase = tcase_create("quotient");
    tcase_add_test(tcase, a_seam_makes_one_class_of_two_sheets);
    tcase_add_test(tcase, an_edge_sewn_both_ways_is_folded);
    tcase_add_test(tcase, a_point_passed_twice_is_a_pinch);
    tcase_add_test(tcase, loose_edges_and_construction_points_are_no_cells_of_the_surface);
    suite_add_tcase(suite, tcase);
    return suite;
}
