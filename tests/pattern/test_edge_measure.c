/*
 * test_edge_measure.c: lengths, points at arc length, polylines, areas: closed forms, and laws on random chains.
 */
#include <math.h>

#include "pattern/same.h"

#define PI 3.14159265358979323846


/* a panel of one chain from a to b and a line back */
typedef struct chain {
    mus_pattern *pattern;
    int32_t panel, edge, back;
} chain;


static chain chain_make(mus_context *context, const double *a, const double *b, int32_t npiece, const int32_t *kinds,
                        int32_t nxy, const double *xy)
{
    chain c;
    int32_t p, q, along[2] = {1, 1};
    ck_assert_int_eq(mus_pattern_create(context, "chain", &c.pattern), MUS_OK);
    ck_assert_int_eq(mus_pattern_add_panel(c.pattern, "p", &c.panel), MUS_OK);
    ck_assert_int_eq(mus_pattern_add_point(c.pattern, c.panel, a[0], a[1], &p), MUS_OK);
    ck_assert_int_eq(mus_pattern_add_point(c.pattern, c.panel, b[0], b[1], &q), MUS_OK);
    const mus_edge_def curve = {.size = sizeof(mus_edge_def), .name = "curve", .start = p, .end = q, .npiece = npiece,
                                .kinds = kinds, .nxy = nxy, .xy = xy};
    ck_assert_int_eq(mus_pattern_add_edge(c.pattern, &curve, &c.edge), MUS_OK);
    ck_assert_int_eq(mus_pattern_add_edge(c.pattern, &(mus_edge_def){.size = sizeof(mus_edge_def), .name = "back",
                                                                     .start = q, .end = p}, &c.back), MUS_OK);
    int32_t edges[2] = {c.edge, c.back};
    ck_assert_int_eq(mus_pattern_set_outline(c.pattern, c.panel, 2, edges, along), MUS_OK);
    return c;
}


/* a random chain of 1 to 5 pieces of any kind, some decimetres across; the middle of an arc is as far from both ends */
static chain chain_random(mus_context *context, uint64_t *state)
{
    static const int32_t controls[4] = {0, 1, 2, 1};
    int32_t kinds[5], npiece = 1 + (int32_t)(support_random(state) % 5), n = 1;
    double xy[40];
    for (int32_t i = 0; i < 40; i++) xy[i] = support_uniform(state, -0.5, 0.5);
    for (int32_t i = 0; i < npiece; i++) {
        kinds[i] = (int32_t)(support_random(state) % 4);
        double *p = xy + 2 * (n - 1), bulge = support_uniform(state, -1.5, 1.5);
        n += controls[kinds[i]] + 1;
        if (kinds[i] != MUS_PIECE_ARC) continue;
        p[2] = 0.5 * (p[0] + p[4]) - bulge * (p[5] - p[1]);
        p[3] = 0.5 * (p[1] + p[5]) + bulge * (p[4] - p[0]);
    }
    return chain_make(context, xy, xy + 2 * (n - 1), npiece, kinds, n - 2, xy + 2);
}


static double chord_sum(int32_t n, const double *xy)
{
    double sum = 0.0;
    for (int32_t i = 1; i < n; i++) sum += hypot(xy[2 * i] - xy[2 * i - 2], xy[2 * i + 1] - xy[2 * i - 1]);
    return sum;
}


START_TEST(lengths_and_areas_of_circles_are_closed_forms)
{
    mus_context *context = support_context();
    uint64_t state = 3;
    for (int32_t i = 0; i < 200; i++) {
        /* an arc of `angle` round (cx, cy): length r angle, segment area r^2 (angle - sin angle) / 2 */
        double r = exp(support_uniform(&state, -4.0, 1.0)), angle = support_uniform(&state, 0.01, 6.27);
        double from = support_uniform(&state, 0.0, 6.28), cx = support_uniform(&state, -1.0, 1.0), p[3][2];
        for (int32_t k = 0; k < 3; k++) {
            p[k][0] = cx + r * cos(from + 0.5 * k * angle);
            p[k][1] = r * sin(from + 0.5 * k * angle);
        }
        int32_t kind = MUS_PIECE_ARC;
        chain c = chain_make(context, p[0], p[2], 1, &kind, 1, p[1]);
        ck_assert_double_eq_tol(mus_pattern_edge_length(c.pattern, c.edge), r * angle, 1e-9);
        double area = 0.5 * r * r * (angle - sin(angle));
        ck_assert_double_eq_tol(mus_pattern_panel_area(c.pattern, c.panel), area, 1e-9);
        mus_pattern_destroy(c.pattern);
    }
    support_context_end(context);
}
END_TEST


START_TEST(a_parabola_has_the_length_that_its_formula_says)
{
    /* y = x^2, 0..1 as a quadratic: length (2 sqrt 5 + asinh 2) / 4, area under the chord 1/6; the cubic of the same
     * curve (degree raised) measures the same */
    mus_context *context = support_context();
    double a[2] = {0.0, 0.0}, b[2] = {1.0, 1.0}, q[2] = {0.5, 0.0};
    double c4[4] = {1.0 / 3.0, 0.0, 2.0 / 3.0, 1.0 / 3.0}, exact = (2.0 * sqrt(5.0) + asinh(2.0)) / 4.0;
    int32_t quadratic = MUS_PIECE_QUADRATIC, cubic = MUS_PIECE_CUBIC;
    chain c = chain_make(context, a, b, 1, &quadratic, 1, q), d = chain_make(context, a, b, 1, &cubic, 2, c4);
    ck_assert_double_eq_tol(mus_pattern_edge_length(c.pattern, c.edge), exact, 1e-12);
    ck_assert_double_eq_tol(mus_pattern_edge_length(d.pattern, d.edge), exact, 1e-12);
    ck_assert_double_eq_tol(mus_pattern_panel_area(c.pattern, c.panel), 1.0 / 6.0, 1e-15);
    ck_assert_double_eq_tol(mus_pattern_panel_area(d.pattern, d.panel), 1.0 / 6.0, 1e-15);
    ck_assert_double_eq_tol(mus_pattern_panel_perimeter(c.pattern, c.panel), exact + sqrt(2.0), 1e-12);
    mus_pattern_destroy(c.pattern);
    mus_pattern_destroy(d.pattern);
    support_context_end(context);
}
END_TEST


START_TEST(points_at_equal_arc_length_are_equally_far_apart_along_the_edge)
{
    enum { N = 64, FINE = 16 };
    static double t[N * FINE + 1], at[2 * (N * FINE + 1)];
    mus_context *context = support_context();
    uint64_t state = 4;
    for (int32_t i = 0; i <= N * FINE; i++) t[i] = (double)i / (N * FINE);
    for (int32_t i = 0; i < 100; i++) {
        chain c = chain_random(context, &state);
        double length = mus_pattern_edge_length(c.pattern, c.edge), a[2], b[2];
        int32_t start, end;
        ck_assert_int_eq(mus_pattern_edge_at(c.pattern, c.edge, N * FINE + 1, t, at), MUS_OK);

        /* a chord is never longer than its arc, and nowhere do many of them lose anything but at corners and cusps */
        double sum = 0.0, longest = 0.0;
        for (int32_t k = 0; k < N * FINE; k++) {
            double chord = chord_sum(2, at + 2 * k);
            longest = fmax(longest, chord);
            sum += chord;
        }
        ck_assert_double_le(longest, length / (N * FINE) + 1e-12);
        ck_assert_double_ge(sum, length * (1.0 - 12.0 / (N * FINE)));

        /* the ends are the points themselves */
        ck_assert_int_eq(mus_pattern_edge_ends(c.pattern, c.edge, &start, &end), MUS_OK);
        ck_assert_int_eq(mus_pattern_point(c.pattern, start, NULL, a), MUS_OK);
        ck_assert_int_eq(mus_pattern_point(c.pattern, end, NULL, b), MUS_OK);
        ck_assert_mem_eq(at, a, sizeof a);
        ck_assert_mem_eq(at + (size_t)2 * N * FINE, b, sizeof b);
        mus_pattern_destroy(c.pattern);
    }
    support_context_end(context);
}
END_TEST


START_TEST(an_arc_length_is_found_in_the_piece_that_holds_it)
{
    /* a line of 3, a half circle of radius 1, a line of 2: by hand */
    mus_context *context = support_context();
    int32_t kinds[3] = {MUS_PIECE_LINE, MUS_PIECE_ARC, MUS_PIECE_LINE};
    double a[2] = {0.0, 0.0}, b[2] = {1.0, 2.0}, xy[6] = {3.0, 0.0, 4.0, 1.0, 3.0, 2.0}, total = 5.0 + PI, at[10];
    chain c = chain_make(context, a, b, 3, kinds, 3, xy);
    double t[5] = {1.5 / total, 3.0 / total, (3.0 + PI / 4.0) / total, (3.0 + PI / 2.0) / total, (4.0 + PI) / total};
    double exact[10] = {1.5, 0.0, 3.0, 0.0, 3.0 + sqrt(0.5), 1.0 - sqrt(0.5), 4.0, 1.0, 2.0, 2.0};
    ck_assert_double_eq_tol(mus_pattern_edge_length(c.pattern, c.edge), total, 1e-14);
    ck_assert_int_eq(mus_pattern_edge_at(c.pattern, c.edge, 5, t, at), MUS_OK);
    for (int32_t i = 0; i < 10; i++) ck_assert_double_eq_tol(at[i], exact[i], 1e-13);
    mus_pattern_destroy(c.pattern);
    support_context_end(context);
}
END_TEST


START_TEST(a_polyline_grows_to_the_length_from_below)
{
    static double xy[2 * (5 * 256 + 1)];
    mus_context *context = support_context();
    uint64_t state = 6;
    for (int32_t i = 0; i < 100; i++) {
        chain c = chain_random(context, &state);
        double length = mus_pattern_edge_length(c.pattern, c.edge), last = 0.0;
        int32_t n, npiece, nxy, curved = 0;
        const int32_t *kinds;
        const double *given;
        ck_assert_int_eq(mus_pattern_edge_pieces(c.pattern, c.edge, &npiece, &kinds, &nxy, &given), MUS_OK);
        for (int32_t k = 0; k < npiece; k++) curved += kinds[k] != MUS_PIECE_LINE;
        for (int32_t chords = 1; chords <= 256; chords *= 2) {
            ck_assert_int_eq(mus_pattern_edge_polyline(c.pattern, c.edge, chords, xy, 5 * 256 + 1, &n), MUS_OK);
            ck_assert_int_eq(n, 1 + npiece - curved + curved * chords);
            double sum = chord_sum(n, xy);
            ck_assert_double_ge(sum, last - 1e-12);
            ck_assert_double_le(sum, length + 1e-12);
            last = sum;
        }
        ck_assert_double_ge(last, length * (1.0 - 2e-3));
        ck_assert_mem_eq(xy, given, 2 * sizeof *xy);
        ck_assert_mem_eq(xy + 2 * (size_t)(n - 1), given + 2 * (size_t)(nxy - 1), 2 * sizeof *xy);
        mus_pattern_destroy(c.pattern);
    }
    support_context_end(context);
}
END_TEST


START_TEST(a_polyline_writes_what_there_is_room_for)
{
    mus_context *context = support_context();
    sample s = sample_make(context);
    double xy[20], whole[20];
    int32_t n;
    ck_assert_int_eq(mus_pattern_edge_polyline(s.pattern, s.edge[2], 4, NULL, 0, &n), MUS_OK);
    ck_assert_int_eq(n, 6);
    ck_assert_int_eq(mus_pattern_edge_polyline(s.pattern, s.edge[2], 4, whole, 10, NULL), MUS_OK);
    for (int32_t room = 0; room <= 6; room++) {
        for (int32_t i = 0; i < 20; i++) xy[i] = -7.0;
        ck_assert_int_eq(mus_pattern_edge_polyline(s.pattern, s.edge[2], 4, xy, room, &n), MUS_OK);
        ck_assert_int_eq(n, 6);
        if (room > 0) ck_assert_mem_eq(xy, whole, 2 * (size_t)room * sizeof *xy);
        ck_assert(xy[2 * room] == -7.0);
    }
    ck_assert_int_eq(mus_pattern_edge_polyline(s.pattern, s.edge[2], 0, xy, 10, &n), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_edge_polyline(s.pattern, s.edge[2], 4, xy, -1, &n), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_edge_polyline(s.pattern, 8, 4, xy, 10, &n), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_edge_polyline(NULL, 0, 4, xy, 10, &n), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_edge_polyline(s.pattern, s.edge[2], INT32_MAX, NULL, 0, &n), MUS_ERR_LIMIT);

    double t[3] = {0.5, 1.0 + 1e-15, (double)NAN};
    ck_assert_int_eq(mus_pattern_edge_at(s.pattern, 0, 2, t, xy), MUS_ERR_ARG);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "is outside 0 to 1"));
    ck_assert_int_eq(mus_pattern_edge_at(s.pattern, 0, 1, t + 2, xy), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_edge_at(s.pattern, 0, -1, t, xy), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_edge_at(s.pattern, 0, 1, NULL, xy), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_edge_at(s.pattern, 0, 1, t, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_edge_at(s.pattern, 8, 1, t, xy), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_edge_at(NULL, 0, 1, t, xy), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_edge_at(s.pattern, 0, 0, NULL, NULL), MUS_OK);
    mus_pattern_destroy(s.pattern);
    support_context_end(context);
}
END_TEST


START_TEST(area_is_that_of_the_fine_polygon_whichever_way_the_word_runs)
{
    enum { CHORDS = 4096 };
    static double xy[2 * (5 * CHORDS + 2)];
    mus_context *context = support_context();
    uint64_t state = 9;
    for (int32_t i = 0; i < 40; i++) {
        chain c = chain_random(context, &state);
        int32_t n, back[2] = {-1, -1}, turned[2] = {c.back, c.edge};
        ck_assert_int_eq(mus_pattern_edge_polyline(c.pattern, c.edge, CHORDS, xy, 5 * CHORDS + 1, &n), MUS_OK);
        double sum = 0.0;
        for (int32_t k = 0; k < n; k++) {
            const double *p = xy + 2 * k, *q = xy + 2 * ((k + 1) % n);
            sum += 0.5 * (p[0] * q[1] - p[1] * q[0]);
        }
        double area = mus_pattern_panel_area(c.pattern, c.panel);
        ck_assert_double_eq_tol(area, fabs(sum), 1e-4);
        ck_assert_double_ge(area, 0.0);
        ck_assert_int_eq(mus_pattern_set_outline(c.pattern, c.panel, 2, turned, back), MUS_OK);
        ck_assert_double_eq_tol(mus_pattern_panel_area(c.pattern, c.panel), area, 1e-15);
        double around = mus_pattern_edge_length(c.pattern, c.edge) + mus_pattern_edge_length(c.pattern, c.back);
        ck_assert_double_eq_tol(mus_pattern_panel_perimeter(c.pattern, c.panel), around, 1e-15);
        mus_pattern_destroy(c.pattern);
    }
    support_context_end(context);
}
END_TEST


Suite *mus_suite_edge_measure(void);


Suite *mus_suite_edge_measure(void)
{
    Suite *suite = suite_create("edge_measure");
    TCase *tcase = tcase_create("measure");
    tcase_set_timeout(tcase, 30);
    tcase_add_test(tcase, lengths_and_areas_of_circles_are_closed_forms);
    tcase_add_test(tcase, a_parabola_has_the_length_that_its_formula_says);
    tcase_add_test(tcase, points_at_equal_arc_length_are_equally_far_apart_along_the_edge);
    tcase_add_test(tcase, an_arc_length_is_found_in_the_piece_that_holds_it);
    tcase_add_test(tcase, a_polyline_grows_to_the_length_from_below);
    tcase_add_test(tcase, a_polyline_writes_what_there_is_room_for);
    tcase_add_test(tcase, area_is_that_of_the_fine_polygon_whichever_way_the_word_runs);
    suite_add_tcase(suite, tcase);
    return suite;
}
