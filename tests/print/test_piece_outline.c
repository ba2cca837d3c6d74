/*
 * test_piece_outline.c: a panel as a piece: its spans are the pattern's curves, its grain is up, its right side lies
 * up.
 */
#include <math.h>

#include "print/page.h"
#include "print/sample_patterns.h"
#include "support.h"

static mus_context *context;
static mus_pattern *pattern;
static mus__piece piece;


static void setup(void)
{
    context = support_context();
    pattern = sample_shirt(context);
    ck_assert_ptr_nonnull(pattern);
}


static void teardown(void)
{
    mus__piece_free(context, &piece);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}


static void make(const mus_pattern *from, int32_t panel, double allowance)
{
    mus__piece_free(context, &piece);
    ck_assert_int_eq(mus__piece_make(context, from, panel, allowance, &piece), MUS_OK);
}


/* length of a side by fine chords, with Richardson's step to the limit */
static double side_length(int32_t side)
{
    double length[2] = {0, 0};
    for (int32_t round = 0; round < 2; round++) {
        int32_t chords = 400 << round;
        for (int32_t i = 0; i < piece.nspan; i++) {
            const mus__span *span = &piece.spans[i];
            double a[2], b[2];
            if (span->side != side) continue;
            mus__cubic_at(span->p, 0.0, a);
            for (int32_t k = 1; k <= chords; k++) {
                mus__cubic_at(span->p, (double)k / chords, b);
                length[round] += hypot(b[0] - a[0], b[1] - a[1]);
                a[0] = b[0];
                a[1] = b[1];
            }
        }
    }
    return (4.0 * length[1] - length[0]) / 3.0;
}


static double flat_area(void)
{
    double area = 0.0;
    for (int32_t i = 0; i < piece.nflat; i++) {
        const double *a = piece.flat + 2 * i, *b = piece.flat + 2 * ((i + 1) % piece.nflat);
        area += 0.5 * (a[0] * b[1] - a[1] * b[0]);
    }
    return area;
}


START_TEST(sides_are_as_long_as_the_edges)
{
    for (int32_t panel = 0; panel < mus_pattern_panel_count(pattern); panel++) {
        make(pattern, panel, 0.01);
        for (int32_t i = 0; i < piece.nside; i++)
            ck_assert_double_eq_tol(side_length(i), mus_pattern_edge_length(pattern, piece.sides[i].edge), 2e-7);
    }
}
END_TEST


START_TEST(spans_lie_on_the_edges)
{
    /* ends and inner points of each side against the pattern's own evaluation at equal arc length, to a micrometre */
    for (int32_t panel = 0; panel < mus_pattern_panel_count(pattern); panel++) {
        make(pattern, panel, 0.01);
        for (int32_t i = 0; i < piece.nside; i++) {
            for (int32_t k = 0; k <= 16; k++) {
                double xy[2], p[2], t = k / 16.0, nearest = HUGE_VAL;
                ck_assert_int_eq(mus_pattern_edge_at(pattern, piece.sides[i].edge, 1, &t, xy), MUS_OK);
                mus__piece_point(&piece, xy, p);
                for (int32_t s = 0; s < piece.nspan; s++) {
                    double a[2], b[2];
                    if (piece.spans[s].side != i) continue;
                    mus__cubic_at(piece.spans[s].p, 0.0, a);
                    for (int32_t m = 1; m <= 500; m++) {
                        mus__cubic_at(piece.spans[s].p, m / 500.0, b);
                        double dx = b[0] - a[0], dy = b[1] - a[1], dd = dx * dx + dy * dy;
                        double along = (p[0] - a[0]) * dx + (p[1] - a[1]) * dy;
                        double u = dd > 0.0 ? fmin(1.0, fmax(0.0, along / dd)) : 0.0;
                        nearest = fmin(nearest, hypot(p[0] - a[0] - u * dx, p[1] - a[1] - u * dy));
                        a[0] = b[0];
                        a[1] = b[1];
                    }
                }
                ck_assert_double_lt(nearest, 1e-6);
            }
        }
    }
}
END_TEST


START_TEST(an_arc_keeps_its_radius)
{
    /* three quarters of a circle of 0.5 m, and its closing chord: every point of the cubics within 1e-6 m of it */
    int32_t panel, a, b, edges[2], kind = MUS_PIECE_ARC;
    const double middle[2] = {-0.5 * sqrt(0.5), -0.5 * sqrt(0.5)};
    const int32_t directions[2] = {1, 1};
    ck_assert_int_eq(mus_pattern_add_panel(pattern, "disc", &panel), MUS_OK);
    mus_pattern_add_point(pattern, panel, 0.0, 0.5, &a);
    mus_pattern_add_point(pattern, panel, 0.5, 0.0, &b);
    ck_assert_int_eq(mus_pattern_add_edge(pattern, &(mus_edge_def){.size = sizeof(mus_edge_def), .start = a,
                                                                   .end = b, .npiece = 1, .kinds = &kind, .nxy = 1,
                                                                   .xy = middle}, &edges[0]), MUS_OK);
    ck_assert_int_eq(mus_pattern_add_edge(pattern, &(mus_edge_def){.size = sizeof(mus_edge_def), .start = b,
                                                                   .end = a}, &edges[1]), MUS_OK);
    ck_assert_int_eq(mus_pattern_set_outline(pattern, panel, 2, edges, directions), MUS_OK);
    make(pattern, panel, 0.0);
    double centre[2];
    mus__piece_point(&piece, (const double[2]){0, 0}, centre);
    for (int32_t i = 0; i < piece.nspan; i++) {
        if (piece.spans[i].side != 0) continue;
        for (int32_t k = 0; k <= 50; k++) {
            double p[2];
            mus__cubic_at(piece.spans[i].p, k / 50.0, p);
            ck_assert_double_eq_tol(hypot(p[0] - centre[0], p[1] - centre[1]), 0.5, 1e-6);
        }
    }
    ck_assert_double_eq_tol(flat_area(), 0.25 * (0.75 * MUS__PRINT_PI + 0.5), 1e-4);
}
END_TEST


START_TEST(the_grain_runs_up)
{
    int32_t rib = mus_pattern_find_panel(pattern, "neck_rib");
    make(pattern, rib, 0.01);
    ck_assert_double_eq_tol(piece.box[2], 0.07, 1e-7);
    ck_assert_double_eq_tol(piece.box[3], 0.44, 1e-7);

    const double slant[2] = {3, 4};
    ck_assert_int_eq(mus_pattern_set_grain(pattern, rib, slant[0], slant[1]), MUS_OK);
    make(pattern, rib, 0.01);
    double from[2], to[2];
    mus__piece_point(&piece, (const double[2]){0, 0}, from);
    mus__piece_point(&piece, slant, to);
    ck_assert_double_eq_tol(to[0], from[0], 1e-12);
    ck_assert_double_eq_tol(to[1], from[1] + 5.0, 1e-12);
}
END_TEST


START_TEST(a_clockwise_panel_is_turned_over)
{
    const double ccw[] = {0, 0, 0.3, 0, 0.1, 0.4}, cw[] = {0, 0, -0.3, 0, -0.1, 0.4};
    double area[2];
    for (int32_t k = 0; k < 2; k++) {
        mus_pattern *triangle = sample_polygon(context, 3, k == 0 ? ccw : cw);
        ck_assert_ptr_nonnull(triangle);
        make(triangle, 0, 0.0);
        area[k] = flat_area();
        /* both are the same piece of cloth, right side up */
        double low = HUGE_VAL;
        for (int32_t i = 0; i < 3; i++) low = fmin(low, hypot(piece.flat[2 * i] - 0.1, piece.flat[2 * i + 1] - 0.4));
        ck_assert_double_lt(low, 1e-12);
        mus_pattern_destroy(triangle);
    }
    ck_assert_double_eq_tol(area[0], 0.06, 1e-12);
    ck_assert_double_eq_tol(area[1], 0.06, 1e-12);
}
END_TEST


START_TEST(an_edge_against_the_outline_gives_the_same_piece)
{
    /* the square once with all edges along, once with two against */
    int32_t panel, p[4], e[4];
    const int32_t quadratic = MUS_PIECE_QUADRATIC, along[4] = {1, -1, 1, -1};
    const double bulge[2] = {0.35, 0.15};
    ck_assert_int_eq(mus_pattern_add_panel(pattern, "mixed", &panel), MUS_OK);
    mus_pattern_add_point(pattern, panel, 0.0, 0.0, &p[0]);
    mus_pattern_add_point(pattern, panel, 0.3, 0.0, &p[1]);
    mus_pattern_add_point(pattern, panel, 0.3, 0.3, &p[2]);
    mus_pattern_add_point(pattern, panel, 0.0, 0.3, &p[3]);
    mus_pattern_add_edge(pattern, &(mus_edge_def){.size = sizeof(mus_edge_def), .start = p[0], .end = p[1]}, &e[0]);
    ck_assert_int_eq(mus_pattern_add_edge(pattern, &(mus_edge_def){.size = sizeof(mus_edge_def), .start = p[2],
                                                                   .end = p[1], .npiece = 1, .kinds = &quadratic,
                                                                   .nxy = 1, .xy = bulge}, &e[1]), MUS_OK);
    mus_pattern_add_edge(pattern, &(mus_edge_def){.size = sizeof(mus_edge_def), .start = p[2], .end = p[3]}, &e[2]);
    mus_pattern_add_edge(pattern, &(mus_edge_def){.size = sizeof(mus_edge_def), .start = p[0], .end = p[3]}, &e[3]);
    ck_assert_int_eq(mus_pattern_set_outline(pattern, panel, 4, e, along), MUS_OK);
    make(pattern, panel, 0.01);
    for (int32_t i = 0; i < piece.nspan; i++) {
        const double *end = piece.spans[i].p + 6, *start = piece.spans[(i + 1) % piece.nspan].p;
        ck_assert_double_eq(end[0], start[0]);
        ck_assert_double_eq(end[1], start[1]);
    }
    /* square and two thirds of the bulge's box, 0.3 x 0.025 */
    ck_assert_double_eq_tol(flat_area(), 0.09 + 0.3 * 0.025 * 2.0 / 3.0, 1e-5);
}
END_TEST


START_TEST(copies_follow_the_mirrors)
{
    make(pattern, mus_pattern_find_panel(pattern, "sleeve_left"), 0.01);
    ck_assert(piece.mirrored);
    ck_assert_int_eq(mus__piece_copies(&piece), 2);
    make(pattern, mus_pattern_find_panel(pattern, "front"), 0.01);
    ck_assert(!piece.mirrored);
    ck_assert_int_eq(mus__piece_copies(&piece), 1);
}
END_TEST


Suite *mus_suite_piece_outline(void);
Suite *mus_suite_piece_outline(void)
{
    Suite *suite = suite_create("piece_outline");
    TCase *test = tcase_create("outline");
    tcase_add_checked_fixture(test, setup, teardown);
    tcase_add_test(test, sides_are_as_long_as_the_edges);
    tcase_add_test(test, spans_lie_on_the_edges);
    tcase_add_test(test, an_arc_keeps_its_radius);
    tcase_add_test(test, the_grain_runs_up);
    tcase_add_test(test, a_clockwise_panel_is_turned_over);
    tcase_add_test(test, an_edge_against_the_outline_gives_the_same_piece);
    tcase_add_test(test, copies_follow_the_mirrors);
    suite_add_tcase(suite, test);
    return suite;
}
