/*
 * test_mesh.c: a panel is covered exactly once by triangles that wind as its outline, with the weight of its area.
 */
#include "cut.h"
#include "muslin/topology.h"

#include "geom/polygon.h"


/* Euler characteristic of the welded mesh: classes of nodes less classes of edges plus triangles */
static int32_t find_root(int32_t *parent, int32_t i)
{
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
}


static int by_key(const void *a, const void *b)
{
    const uint64_t *p = a, *q = b;
    return (*p > *q) - (*p < *q);
}


static int32_t welded_euler(const mus_cloth *cloth)
{
    int32_t *parent = malloc((size_t)cloth->nnode * sizeof *parent), classes = 0, edges = 0;
    for (int32_t i = 0; i < cloth->nnode; i++) parent[i] = i;
    for (int32_t p = 0; p < cloth->npair; p++)
        parent[find_root(parent, cloth->pair[2 * p])] = find_root(parent, cloth->pair[2 * p + 1]);
    for (int32_t i = 0; i < cloth->nnode; i++) classes += find_root(parent, i) == i;

    uint64_t *key = malloc(3 * (size_t)cloth->ntriangle * sizeof *key);
    for (int32_t k = 0; k < 3 * cloth->ntriangle; k++) {
        int32_t a = find_root(parent, cloth->triangle[k]),
                b = find_root(parent, cloth->triangle[k / 3 * 3 + (k + 1) % 3]);
        key[k] = (uint64_t)(a < b ? a : b) << 32 | (uint64_t)(a < b ? b : a);
    }
    qsort(key, 3 * (size_t)cloth->ntriangle, sizeof *key, by_key);
    for (int32_t k = 0; k < 3 * cloth->ntriangle; k++) edges += k == 0 || key[k] != key[k - 1];
    free(parent);
    free(key);
    return classes - edges + cloth->ntriangle;
}


/* all that holds for every panel of every cloth */
static void check_panels(const mus_pattern *pattern, const mus_cloth *cloth)
{
    int32_t nodes = 0, triangles = 0, rows = 0;
    for (int32_t p = 0; p < cloth->npanel; p++) {
        int32_t range[4], n;
        const int32_t *border;
        ck_assert_int_eq(mus_cloth_panel_range(cloth, p, range), MUS_OK);
        ck_assert_int_eq(mus_cloth_panel_border(cloth, p, &n, &border), MUS_OK);
        ck_assert(range[0] == nodes && range[2] == triangles);
        nodes += range[1], triangles += range[3];
        ck_assert_int_eq(range[3], n - 2 + 2 * (range[1] - n));

        /* triangles: nodes of the panel, all of one winding, together the polygon of the border */
        double *xy = malloc(2 * (size_t)n * sizeof *xy), area = 0.0, mass = 0.0;
        for (int32_t i = 0; i < n; i++) memcpy(xy + 2 * i, cloth->rest + 2 * border[i], 2 * sizeof *xy);
        double whole = mus__polygon_area(n, xy);
        for (int32_t t = range[2]; t < triangles; t++) {
            double part = cut_area(cloth, t);
            area += part;
            ck_assert(part * whole > 0.0);
            for (int k = 0; k < 3; k++)
                ck_assert(cloth->triangle[3 * t + k] >= range[0] && cloth->triangle[3 * t + k] < nodes);
        }
        ck_assert_double_le(fabs(area - whole), 1e-12 * fabs(whole));
        free(xy);

        /* mass of the panel: weight times its true area */
        for (int32_t i = range[0]; i < nodes; i++) {
            ck_assert(cloth->mass[i] > 0.0 && cloth->node_panel[i] == p);
            mass += cloth->mass[i];
        }
        double weight = cloth->fabric.weight * mus_pattern_panel_area(pattern, p);
        ck_assert_double_le(fabs(mass - weight), 1e-12 * weight);

        /* lattice nodes first, in rows that cover each once */
        int32_t next = range[0];
        for (; rows < cloth->nrow && cloth->row[rows].first < nodes; rows++) {
            ck_assert_int_eq(cloth->row[rows].first, next);
            next += cloth->row[rows].count;
        }
        ck_assert_int_eq(next, range[0] + cloth->panel[p].lattice_count);
        for (int32_t i = 0; i < n; i++) ck_assert_int_eq(border[i], next + i);
    }
    ck_assert(nodes == mus_cloth_node_count(cloth) && triangles == mus_cloth_triangle_count(cloth));
}


static void check_topology(const mus_pattern *pattern, const mus_cloth *cloth)
{
    mus_topology topology;
    mus_topology_init(&topology, sizeof topology);
    ck_assert_int_eq(mus_pattern_topology(pattern, &topology), MUS_OK);
    ck_assert_int_eq(welded_euler(cloth), topology.euler);
}


START_TEST(a_skirt_is_covered_weighed_and_a_tube)
{
    mus_context *context = support_context();
    mus_pattern *pattern = cut_begin(context);
    cut_skirt(pattern);
    const double spacing[] = {0.004, 0.01, 0.015, 0.03, 0.08};
    for (int k = 0; k < 5; k++) {
        mus_cloth *cloth = cut_cloth(context, pattern, spacing[k], NULL);
        check_panels(pattern, cloth);
        check_topology(pattern, cloth);
        ck_assert_int_eq(welded_euler(cloth), 0);
        mus_cloth_destroy(cloth);
    }
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


START_TEST(a_sleeve_and_a_sewn_dart_keep_their_topology)
{
    mus_context *context = support_context();
    mus_pattern *pattern = cut_begin(context);
    int32_t edges[7];
    cut_sleeve(pattern, edges);
    mus_cloth *cloth = cut_cloth(context, pattern, 0.01, NULL);
    check_panels(pattern, cloth);
    ck_assert_int_eq(welded_euler(cloth), 0);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);

    /* the legs of a dart share their end: sewn, the panel is a disc still */
    pattern = cut_begin(context);
    const double dart[] = {0, 0, 0.2, 0, 0.2, 0.2, 0.11, 0.2, 0.1, 0.08, 0.09, 0.2, 0, 0.2};
    cut_panel(pattern, "dart", 7, dart, edges);
    cut_seam(pattern, edges[3], edges[4], MUS_SEAM_REVERSED);
    cloth = cut_cloth(context, pattern, 0.01, NULL);
    check_panels(pattern, cloth);
    check_topology(pattern, cloth);
    ck_assert_int_eq(welded_euler(cloth), 1);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


START_TEST(narrow_pieces_are_meshed_without_a_lattice)
{
    mus_context *context = support_context();
    const double widths[] = {0.004, 0.01, 0.013, 0.02, 0.03};
    for (int k = 0; k < 10; k++) {
        mus_pattern *pattern = cut_begin(context);
        double w = widths[k / 2], c = k % 2 ? 0.8 : 1.0, s = k % 2 ? 0.6 : 0.0;
        const double strap[] = {0, 0, 0.3 * c, 0.3 * s, 0.3 * c - w * s, 0.3 * s + w * c, -w * s, w * c};
        cut_panel(pattern, "strap", 4, strap, NULL);
        mus_cloth *cloth = cut_cloth(context, pattern, 0.01, NULL);
        check_panels(pattern, cloth);
        if (w < 0.015) ck_assert_int_eq(cloth->panel[0].lattice_count, 0);
        mus_cloth_destroy(cloth);
        mus_pattern_destroy(pattern);
    }

    /* a spacing far above the panel leaves the points of the outline */
    mus_pattern *pattern = cut_begin(context);
    const double small[] = {0, 0, 0.02, 0, 0, 0.02};
    cut_panel(pattern, "gusset", 3, small, NULL);
    mus_cloth *cloth = cut_cloth(context, pattern, 0.1, NULL);
    check_panels(pattern, cloth);
    ck_assert_int_eq(mus_cloth_node_count(cloth), 3);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


START_TEST(one_and_two_edges_make_a_panel)
{
    /* a disc of one closed edge (two arcs), and a lens of two arcs */
    mus_context *context = support_context();
    mus_pattern *pattern = cut_begin(context);
    int32_t panel, point, tip, edges[2], forward[2] = {1, 1}, arcs[2] = {MUS_PIECE_ARC, MUS_PIECE_ARC};
    const double disc[] = {0.06, 0.06, 0, 0.12, -0.06, 0.06}, low[] = {0.1, -0.03}, high[] = {0.1, 0.03};
    CUT(mus_pattern_add_panel(pattern, "disc", &panel));
    CUT(mus_pattern_add_point(pattern, panel, 0, 0, &point));
    CUT(mus_pattern_add_edge(pattern, &(mus_edge_def){.size = sizeof(mus_edge_def), .start = point, .end = point,
                                                      .npiece = 2, .kinds = arcs, .nxy = 3, .xy = disc}, edges));
    CUT(mus_pattern_set_outline(pattern, panel, 1, edges, forward));
    CUT(mus_pattern_add_panel(pattern, "lens", &panel));
    CUT(mus_pattern_add_point(pattern, panel, 0, 0, &point));
    CUT(mus_pattern_add_point(pattern, panel, 0.2, 0, &tip));
    CUT(mus_pattern_add_edge(pattern, &(mus_edge_def){.size = sizeof(mus_edge_def), .start = point, .end = tip,
                                                      .npiece = 1, .kinds = arcs, .nxy = 1, .xy = low}, &edges[0]));
    CUT(mus_pattern_add_edge(pattern, &(mus_edge_def){.size = sizeof(mus_edge_def), .start = tip, .end = point,
                                                      .npiece = 1, .kinds = arcs, .nxy = 1, .xy = high}, &edges[1]));
    CUT(mus_pattern_set_outline(pattern, panel, 2, edges, forward));
    const double spacing[] = {0.005, 0.02, 0.1};
    for (int k = 0; k < 3; k++) {
        mus_cloth *cloth = cut_cloth(context, pattern, spacing[k], NULL);
        check_panels(pattern, cloth);
        mus_cloth_destroy(cloth);
    }
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


START_TEST(a_clockwise_outline_turns_the_triangles)
{
    mus_context *context = support_context();
    mus_pattern *pattern = cut_begin(context);
    const double back[] = {0, 0, 0, 0.1, 0.1, 0.1, 0.1, 0};
    cut_panel(pattern, "back", 4, back, NULL);
    mus_cloth *cloth = cut_cloth(context, pattern, 0.01, NULL);
    check_panels(pattern, cloth);
    for (int32_t t = 0; t < cloth->ntriangle; t++) ck_assert(cut_area(cloth, t) < 0.0);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


START_TEST(the_grain_turns_the_lattice)
{
    mus_context *context = support_context();
    mus_pattern *pattern = cut_begin(context);
    int32_t panel = cut_rectangle(pattern, "bias", 0.2, 0.2, NULL);
    CUT(mus_pattern_set_grain(pattern, panel, 3.0, 4.0));
    mus_cloth *cloth = cut_cloth(context, pattern, 0.01, NULL);
    check_panels(pattern, cloth);
    int32_t warp = 0, weft = 0;
    for (int32_t r = 0; r < cloth->nrun; r++) {
        const double *a = cloth->rest + 2 * cloth->run[r].a, *b = cloth->rest + 2 * cloth->run[r].b;
        if (cloth->run[r].kind == MUS__SPRING_WARP)
            warp++, ck_assert(fabs(b[0] - a[0] - 0.006) < 1e-12 && fabs(b[1] - a[1] - 0.008) < 1e-12);
        if (cloth->run[r].kind == MUS__SPRING_WEFT)
            weft++, ck_assert(fabs(b[0] - a[0] - 0.008) < 1e-12 && fabs(b[1] - a[1] + 0.006) < 1e-12);
    }
    ck_assert(warp > 0 && weft > 0);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


START_TEST(border_nodes_stand_at_equal_arc_lengths)
{
    mus_context *context = support_context();
    mus_pattern *pattern = cut_begin(context);
    int32_t edges[5], n, at = 0;
    const int32_t *border;
    cut_sleeve(pattern, edges);
    mus_cloth *cloth = cut_cloth(context, pattern, 0.01, NULL);
    ck_assert_int_eq(mus_cloth_panel_border(cloth, 0, &n, &border), MUS_OK);
    for (int i = 0; i < 5; i++) {
        int32_t count = (int32_t)floor(mus_pattern_edge_length(pattern, edges[i]) / 0.01 + 0.5);
        for (int32_t k = 0; k <= count; k++, at++) {
            double t = (double)k / count, want[2];
            CUT(mus_pattern_edge_at(pattern, edges[i], 1, &t, want));
            const double *got = cloth->rest + 2 * border[at % n];
            ck_assert_double_le(hypot(got[0] - want[0], got[1] - want[1]), 1e-12);
        }
        at--;
    }
    ck_assert_int_eq(at, n);
    mus_cloth_destroy(cloth);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_mesh(void);
Suite *mus_suite_mesh(void)
{
    Suite *suite = suite_create("mesh");
    TCase *tests = tcase_create("mesh");
    tcase_set_timeout(tests, 30.0);
    tcase_add_test(tests, a_skirt_is_covered_weighed_and_a_tube);
    tcase_add_test(tests, a_sleeve_and_a_sewn_dart_keep_their_topology);
    tcase_add_test(tests, narrow_pieces_are_meshed_without_a_lattice);
    tcase_add_test(tests, one_and_two_edges_make_a_panel);
    tcase_add_test(tests, a_clockwise_outline_turns_the_triangles);
    tcase_add_test(tests, the_grain_turns_the_lattice);
    tcase_add_test(tests, border_nodes_stand_at_equal_arc_lengths);
    suite_add_tcase(suite, tests);
    return suite;
}
