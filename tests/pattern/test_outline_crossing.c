/*
 * test_outline_crossing.c: outlines that cross or touch themselves, by hand and against a plain test of all pairs of
 * sides.
 */
#include <math.h>

#include "muslin/topology.h"
#include "pattern/pattern_internal.h"
#include "pattern/same.h"

#define MOST 24


/* a panel of straight edges */
static mus_pattern *polygon_make(mus_context *context, int32_t n, const double *xy)
{
    mus_pattern *pattern;
    int32_t panel, point[MOST], edge[MOST], along[MOST];
    ck_assert_int_eq(mus_pattern_create(context, "polygon", &pattern), MUS_OK);
    ck_assert_int_eq(mus_pattern_add_panel(pattern, "p", &panel), MUS_OK);
    for (int32_t i = 0; i < n; i++)
        ck_assert_int_eq(mus_pattern_add_point(pattern, panel, xy[2 * i], xy[2 * i + 1], &point[i]), MUS_OK);
    for (int32_t i = 0; i < n; i++) {
        along[i] = 1;
        ck_assert_int_eq(mus_pattern_add_edge(pattern, &(mus_edge_def){.size = sizeof(mus_edge_def),
                                                                       .start = point[i],
                                                                       .end = point[(i + 1) % n]}, &edge[i]),
                         MUS_OK);
    }
    ck_assert_int_eq(mus_pattern_set_outline(pattern, panel, n, edge, along), MUS_OK);
    return pattern;
}


static bool polygon_crosses(mus_context *context, int32_t n, const double *xy, int32_t *a, int32_t *b)
{
    mus_pattern *pattern = polygon_make(context, n, xy);
    bool crosses;
    ck_assert_int_eq(mus__panel_crosses(pattern, 0, &crosses, a, b), MUS_OK);
    mus_pattern_destroy(pattern);
    return crosses;
}


START_TEST(polygons_by_hand)
{
    mus_context *context = support_context();
    int32_t a, b;
    double square[8] = {0, 0, 1, 0, 1, 1, 0, 1}, bow[8] = {0, 0, 1, 0, 0, 1, 1, 1};
    double touch[10] = {0, 0, 2, 0, 2, 2, 1, 0, 0, 2};       /* a corner on the first side */
    double pinch[12] = {0, 0, 1, 1, 2, 0, 2, 2, 1, 1, 0, 2}; /* two corners at one place */
    double spike[10] = {0, 0, 2, 0, 2, 1, 3, 1, 1, 1};       /* out and back over the same line */
    double flat[8] = {0, 0, 1, 0, 2, 0, 1, 1};               /* three corners on a line are no fault */
    ck_assert(!polygon_crosses(context, 4, square, &a, &b));
    ck_assert(polygon_crosses(context, 4, bow, &a, &b));
    ck_assert(a == 1 && b == 3);
    ck_assert(polygon_crosses(context, 5, touch, &a, &b));
    ck_assert(polygon_crosses(context, 6, pinch, &a, &b));
    ck_assert(polygon_crosses(context, 5, spike, &a, &b));
    ck_assert(!polygon_crosses(context, 4, flat, &a, &b));
    support_context_end(context);
}
END_TEST


/* all pairs of sides that are no neighbours */
static bool plain_crosses(int32_t n, const double *xy)
{
#define TURN(p, q, r) ((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]))
    for (int32_t i = 0; i < n; i++) {
        for (int32_t j = i + 2; j < n; j++) {
            if (i == 0 && j == n - 1) continue;
            const double *a = xy + 2 * i, *b = xy + 2 * (i + 1), *c = xy + 2 * j, *d = xy + 2 * ((j + 1) % n);
            if (TURN(a, b, c) * TURN(a, b, d) <= 0.0 && TURN(c, d, a) * TURN(c, d, b) <= 0.0) return true;
        }
    }
    return false;
#undef TURN
}


START_TEST(random_polygons_agree_with_a_test_of_all_pairs)
{
    mus_context *context = support_context();
    uint64_t state = 12;
    int32_t crossing = 0;
    for (int32_t round = 0; round < 3000; round++) {
        double xy[2 * MOST];
        int32_t n = 3 + (int32_t)(support_random(&state) % (round % 2 == 0 ? 5 : MOST - 3)), a, b;
        for (int32_t i = 0; i < n; i++) {
            /* half of them round a centre, with some radii so near to one another that they just cross or not */
            double angle = 6.28 * (i + support_uniform(&state, 0.0, round % 4 == 1 ? 2.0 : 1.0)) / n;
            double r = support_uniform(&state, 0.2, 1.0);
            xy[2 * i] = round % 2 == 0 ? support_uniform(&state, -1.0, 1.0) : r * cos(angle);
            xy[2 * i + 1] = round % 2 == 0 ? support_uniform(&state, -1.0, 1.0) : r * sin(angle);
        }
        bool expected = plain_crosses(n, xy);
        ck_assert_int_eq(polygon_crosses(context, n, xy, &a, &b), expected);
        crossing += expected;
    }
    ck_assert(crossing > 500 && crossing < 2500);
    support_context_end(context);
}
END_TEST


START_TEST(curves_cross_where_their_chords_do_not)
{
    /* two arcs over one chord, the ring sector of a circle skirt, is sound though its corners enclose nothing; an arc
     * that bulges through the other side is not */
    mus_context *context = support_context();
    for (int32_t deep = 0; deep < 2; deep++) {
        mus_pattern *pattern;
        int32_t panel, p[2], e[2], along[2] = {1, -1}, arc = MUS_PIECE_ARC, cubic = MUS_PIECE_CUBIC, a, b;
        double outer[2] = {0.5, -0.5}, inner[4] = {0.0, -0.2, 1.0, deep ? -1.5 : -0.2};
        bool crosses;
        ck_assert_int_eq(mus_pattern_create(context, "lens", &pattern), MUS_OK);
        ck_assert_int_eq(mus_pattern_add_panel(pattern, "p", &panel), MUS_OK);
        ck_assert_int_eq(mus_pattern_add_point(pattern, panel, 0.0, 0.0, &p[0]), MUS_OK);
        ck_assert_int_eq(mus_pattern_add_point(pattern, panel, 1.0, 0.0, &p[1]), MUS_OK);
        ck_assert_int_eq(mus_pattern_add_edge(pattern, &(mus_edge_def){.size = sizeof(mus_edge_def),
                                                                       .name = "outer", .start = p[0], .end = p[1],
                                                                       .npiece = 1, .kinds = &arc, .nxy = 1,
                                                                       .xy = outer}, &e[0]), MUS_OK);
        ck_assert_int_eq(mus_pattern_add_edge(pattern, &(mus_edge_def){.size = sizeof(mus_edge_def),
                                                                       .name = "inner", .start = p[0], .end = p[1],
                                                                       .npiece = 1, .kinds = &cubic, .nxy = 2,
                                                                       .xy = inner}, &e[1]), MUS_OK);
        ck_assert_int_eq(mus_pattern_set_outline(pattern, panel, 2, e, along), MUS_OK);
        ck_assert_int_eq(mus__panel_crosses(pattern, panel, &crosses, &a, &b), MUS_OK);
        ck_assert_int_eq(crosses, deep);
        mus_pattern_destroy(pattern);
    }
    support_context_end(context);
}
END_TEST


/* a square with a square hole, joined by a bridge from corner 0 to the hole's corner 4; `far` moves the hole */
static mus_pattern *hole_make(mus_context *context, double far)
{
    double xy[16] = {0, 0, 3, 0, 3, 3, 0, 3, 1, 1, 1, 2, 2, 2, 2, 1};
    mus_pattern *pattern;
    int32_t panel, point[8], e[9];
    ck_assert_int_eq(mus_pattern_create(context, "hole", &pattern), MUS_OK);
    ck_assert_int_eq(mus_pattern_add_panel(pattern, "p", &panel), MUS_OK);
    for (int32_t i = 0; i < 8; i++) {
        double move = i >= 4 ? far : 0.0;
        ck_assert_int_eq(mus_pattern_add_point(pattern, panel, xy[2 * i] + move, xy[2 * i + 1], &point[i]), MUS_OK);
    }
    for (int32_t i = 0; i < 8; i++) {
        int32_t next = i % 4 == 3 ? i - 3 : i + 1;
        ck_assert_int_eq(mus_pattern_add_edge(pattern, &(mus_edge_def){.size = sizeof(mus_edge_def),
                                                                       .start = point[i], .end = point[next]},
                                              &e[i]), MUS_OK);
    }
    ck_assert_int_eq(mus_pattern_add_edge(pattern, &(mus_edge_def){.size = sizeof(mus_edge_def), .name = "bridge",
                                                                   .start = point[0], .end = point[4]}, &e[8]), MUS_OK);
    int32_t word[10] = {e[0], e[1], e[2], e[3], e[8], e[4], e[5], e[6], e[7], e[8]};
    int32_t along[10] = {1, 1, 1, 1, 1, 1, 1, 1, 1, -1};
    ck_assert_int_eq(mus_pattern_set_outline(pattern, panel, 10, word, along), MUS_OK);
    return pattern;
}


START_TEST(a_hole_with_a_bridge_is_sound_until_it_meets_the_outline)
{
    mus_context *context = support_context();
    static const double far[5] = {0.0, 0.9, 1.0, 1.5, 5.0};
    for (int32_t i = 0; i < 5; i++) {
        mus_pattern *pattern = hole_make(context, far[i]);
        int32_t a, b;
        bool crosses;
        ck_assert_int_eq(mus__panel_crosses(pattern, 0, &crosses, &a, &b), MUS_OK);
        ck_assert_int_eq(crosses, i >= 2);
        if (i == 0) ck_assert_double_eq_tol(mus_pattern_panel_area(pattern, 0), 8.0, 1e-15);

        /* as a surface it is a ring */
        mus_topology t;
        mus_topology_init(&t, sizeof t);
        ck_assert_int_eq(mus_pattern_topology(pattern, &t), MUS_OK);
        ck_assert(t.vertices == 8 && t.edges == 9 && t.euler == 0 && t.loops == 2 && t.genus == 0 && t.manifold == 1);
        mus_pattern_destroy(pattern);
    }
    support_context_end(context);
}
END_TEST


Suite *mus_suite_outline_crossing(void);


Suite *mus_suite_outline_crossing(void)
{
    Suite *suite = suite_create("outline_crossing");
    TCase *tcase = tcase_create("crossing");
    tcase_set_timeout(tcase, 30);
    tcase_add_test(tcase, polygons_by_hand);
    tcase_add_test(tcase, random_polygons_agree_with_a_test_of_all_pairs);
    tcase_add_test(tcase, curves_cross_where_their_chords_do_not);
    tcase_add_test(tcase, a_hole_with_a_bridge_is_sound_until_it_meets_the_outline);
    suite_add_tcase(suite, tcase);
    return suite;
}
