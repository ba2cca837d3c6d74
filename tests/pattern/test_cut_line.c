/*
 * test_cut_line.c: the cut line of a panel: darts folded shut, hems turned up, faults; and of named designs, that it
 * encloses the sew line and that its folds end on the bisectors of the darts.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "muslin/design.h"
#include "muslin/pattern.h"
#include "support.h"

static mus_context *context;
static mus_pattern *pattern;
static mus_cut_line *line;


static void setup(void)
{
    context = support_context();
    ck_assert_int_eq(mus_pattern_create(context, "sample", &pattern), MUS_OK);
}


static void teardown(void)
{
    mus_cut_line_destroy(line);
    line = NULL;
    mus_pattern_destroy(pattern);
    support_context_end(context);
}


/* a panel of straight edges between n points; edge i runs from point i and is named e0, e1 ..., or hem where hem[i] */
static int32_t polygon(int32_t n, const double *xy, const char *hems)
{
    int32_t panel, points[32], edges[32], ahead[32];
    ck_assert_int_eq(mus_pattern_add_panel(pattern, mus_pattern_panel_count(pattern) == 0 ? "panel" : "other", &panel),
                     MUS_OK);
    for (int32_t i = 0; i < n; i++)
        ck_assert_int_eq(mus_pattern_add_point(pattern, panel, xy[2 * i], xy[2 * i + 1], &points[i]), MUS_OK);
    for (int32_t i = 0; i < n; i++) {
        char name[16];
        mus_edge_def def;
        mus_edge_def_init(&def, sizeof def);
        snprintf(name, sizeof name, "%s%d", hems[i] == 'h' ? "hem" : "e", (int)i);
        def.name = name, def.start = points[i], def.end = points[(i + 1) % n];
        ck_assert_int_eq(mus_pattern_add_edge(pattern, &def, &edges[i]), MUS_OK);
        ahead[i] = 1;
    }
    ck_assert_int_eq(mus_pattern_set_outline(pattern, panel, n, edges, ahead), MUS_OK);
    return panel;
}


static void sew(int32_t a, int32_t b)
{
    mus_seam_def seam;
    mus_seam_def_init(&seam, sizeof seam);
    seam.edge_a = a, seam.edge_b = b;
    ck_assert_int_eq(mus_pattern_add_seam(pattern, &seam, NULL), MUS_OK);
}


static void cut(int32_t panel, double allowance)
{
    mus_cut_line_destroy(line);
    line = NULL;
    ck_assert_int_eq(mus_pattern_cut_line(pattern, panel, allowance, &line), MUS_OK);
}


/* the distance of p from the closed line, negative inside it [m] */
static double beyond(const double *p)
{
    double best = HUGE_VAL;
    bool in = false;
    for (int32_t l = 0; l < mus_cut_line_loop_count(line); l++) {
        int32_t n;
        const double *xy;
        ck_assert_int_eq(mus_cut_line_loop(line, l, &n, &xy), MUS_OK);
        for (int32_t i = 0; i < n; i++) {
            const double *a = xy + 2 * i, *b = xy + 2 * ((i + 1) % n);
            const double dx = b[0] - a[0], dy = b[1] - a[1];
            double t = ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / (dx * dx + dy * dy);
            t = t < 0.0 ? 0.0 : t > 1.0 ? 1.0 : t;
            best = fmin(best, hypot(p[0] - a[0] - t * dx, p[1] - a[1] - t * dy));
            if ((a[1] > p[1]) != (b[1] > p[1]) && p[0] < a[0] + dx * (p[1] - a[1]) / dy) in = !in;
        }
    }
    return in ? -best : best;
}


static void has_point(double x, double y)
{
    int32_t n;
    const double *xy;
    double best = HUGE_VAL;
    ck_assert_int_eq(mus_cut_line_loop(line, 0, &n, &xy), MUS_OK);
    for (int32_t i = 0; i < n; i++) best = fmin(best, hypot(xy[2 * i] - x, xy[2 * i + 1] - y));
    ck_assert_msg(best < 1e-6, "no corner at %g, %g: the nearest is %g away", x, y, best);
}


/* a skirt's half with a dart of 8 by 40 cm, symmetric about x = 0.2: the fold is known by hand */
static const double darted[] = {0.0, 0.0, 0.4, 0.0, 0.4, 0.6, 0.24, 0.6, 0.2, 0.2, 0.16, 0.6, 0.0, 0.6};


START_TEST(a_dart_is_capped_by_the_edge_that_it_is_folded_onto)
{
    const int32_t panel = polygon(7, darted, "-------");
    sew(3, 4);
    cut(panel, 0.01);
    ck_assert_int_eq(mus_cut_line_loop_count(line), 1);
    ck_assert_int_eq(mus_cut_line_dart_count(line), 1);

    /* pressed to the middle of the wearer, x = 0: the leg at x = 0.16. The fold meets the edge y = 0.6 beside it at
     * half the dart's angle, atan 0.1, from that leg: at the angle 2 atan 0.1 from the upright, so the peak is at the
     * distance 0.4 / cos(2 atan 0.1) from the point, straight up */
    double dart[8];
    const double peak = 0.2 + 0.4 / cos(2.0 * atan(0.1)), w = 0.01;
    ck_assert_int_eq(mus_cut_line_dart(line, 0, dart), MUS_OK);
    ck_assert_double_eq_tol(dart[6], 0.2, 1e-12);
    ck_assert_double_eq_tol(dart[7], peak, 1e-12);
    /* with its allowance it is where the edge y = 0.61 meets the fold */
    has_point(0.2, 0.2 + 0.41 / cos(2.0 * atan(0.1)));
    has_point(-w, -w);
    has_point(0.4 + w, 0.6 + w);

    /* both halves of the cap lie on the cut edge when the dart is folded */
    const double leg[2] = {-0.1 / sqrt(1.01), 1.0 / sqrt(1.01)};
    for (int32_t k = 1; k < 10; k++) {
        const double x = 0.02 * k / 10.0;
        double best = HUGE_VAL;
        for (int32_t s = 0; s < 4000; s++) {
            const double p[2] = {0.2 - x, 0.6 + 1e-5 * s};
            if (fabs(beyond(p)) > 2e-5) continue;
            const double rx = p[0] - 0.2, ry = p[1] - 0.2, along = rx * leg[0] + ry * leg[1];
            best = fmin(best, fabs(0.2 + 2.0 * along * leg[1] - ry - 0.61));
        }
        ck_assert_double_lt(best, 5e-5);
    }
    for (int32_t i = 0; i < 7; i++) ck_assert_double_lt(beyond(darted + 2 * i), -0.0099);
}
END_TEST


/* the edge beside the mouth turns up at x = 0.115: behind the fold, which meets y = 0.6 at 0.1192; its cut line turns
 * at 0.1212, before the fold, which meets y = 0.61 at 0.1172 */
static const double cornered[] = {0.0, 0.0, 0.4, 0.0, 0.4, 0.6, 0.24, 0.6, 0.2, 0.2, 0.16, 0.6, 0.115, 0.6, 0.04, 0.75,
                                  0.0, 0.75};
/* and down at x = 0.118: its cut line turns behind the fold */
static const double sloped[] = {0.0, 0.0, 0.4, 0.0, 0.4, 0.6, 0.24, 0.6, 0.2, 0.2, 0.16, 0.6, 0.118, 0.6, 0.04, 0.45,
                                0.0, 0.45};


START_TEST(a_cap_lies_on_the_cut_line_of_an_edge_with_a_corner_at_the_fold)
{
    const int32_t panel = polygon(9, _i == 0 ? cornered : sloped, "---------");
    const double leg[2] = {-0.1 / sqrt(1.01), 1.0 / sqrt(1.01)};
    sew(3, 4);
    cut(panel, 0.01);
    ck_assert_int_eq(mus_cut_line_loop_count(line), 1);
    for (int32_t k = 0; k < 10; k++) {
        int32_t found = 0;
        for (int32_t s = 0; s < 8000; s++) {
            const double p[2] = {0.2 - 0.004 * k, 0.6 + 1e-5 * s}, other[2] = {0.4 - p[0], p[1]};
            if (fabs(beyond(p)) > 1e-5) continue;
            const double rx = p[0] - 0.2, ry = p[1] - 0.2, along = rx * leg[0] + ry * leg[1];
            const double image[2] = {0.2 + 2.0 * along * leg[0] - rx, 0.2 + 2.0 * along * leg[1] - ry};
            ck_assert_double_lt(fabs(beyond(image)), 2e-5);
            ck_assert_double_lt(fabs(beyond(other)), 2e-5);
            found++;
        }
        ck_assert_int_gt(found, 0);
    }
}
END_TEST


START_TEST(a_cap_makes_no_loop_of_its_own)
{
    /* both halves of a cap end in one point, which once was a loop in a panel of each of these */
    static const char *const names[] = {"swing_jewel_sleeveless", "a_line_dress_raglan", "collar_dress_sleeveless"};
    mus_tape *tape;
    mus_pattern *own;
    ck_assert_int_eq(mus_tape_create(context, &tape), MUS_OK);
    ck_assert_int_eq(mus_tape_set_size(tape, "W40"), MUS_OK);
    ck_assert_int_eq(mus_design_draft(context, mus_design_find(names[_i]), tape, NULL, &own), MUS_OK);
    for (int32_t p = 0; p < mus_pattern_panel_count(own); p++) {
        int32_t n;
        mus_cut_line_destroy(line);
        ck_assert_int_eq(mus_pattern_cut_line(own, p, 0.01, &line), MUS_OK);
        ck_assert_int_eq(mus_cut_line_loop(line, 0, &n, NULL), MUS_OK);
        ck_assert_int_gt(n, 3);
    }
    mus_pattern_destroy(own);
    mus_tape_destroy(tape);
}
END_TEST


START_TEST(legs_with_an_allowance_of_their_own_are_cut_open)
{
    const int32_t panel = polygon(7, darted, "-------");
    sew(3, 4);
    for (int32_t i = 3; i < 5; i++) ck_assert_int_eq(mus_pattern_set_edge_allowance(pattern, i, 0.01), MUS_OK);
    cut(panel, 0.01);
    ck_assert_int_eq(mus_cut_line_dart_count(line), 0);
    ck_assert_double_gt(beyond((const double[]){0.2, 0.55}), 0.01);

    /* with an allowance of 0 they are a dart again, and that of the sheet does not count */
    for (int32_t i = 3; i < 5; i++) ck_assert_int_eq(mus_pattern_set_edge_allowance(pattern, i, 0.0), MUS_OK);
    cut(panel, 0.0);
    ck_assert_int_eq(mus_cut_line_dart_count(line), 1);
    ck_assert_double_lt(beyond((const double[]){0.2, 0.55}), -0.04);
}
END_TEST


START_TEST(a_dart_inside_the_panel_is_not_cut)
{
    /* a bridge from the upper left corner to a diamond of four legs, and back: the word passes the bridge both ways */
    static const double xy[] = {0.0, 0.0, 0.4, 0.0, 0.4, 0.6, 0.0, 0.6, 0.2, 0.5, 0.18, 0.3, 0.2, 0.1, 0.22, 0.3};
    int32_t panel, points[8], edges[9];
    ck_assert_int_eq(mus_pattern_add_panel(pattern, "panel", &panel), MUS_OK);
    for (int32_t i = 0; i < 8; i++)
        ck_assert_int_eq(mus_pattern_add_point(pattern, panel, xy[2 * i], xy[2 * i + 1], &points[i]), MUS_OK);
    static const int32_t ends[9][2] = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {3, 4}, {4, 7}, {7, 6}, {6, 5}, {5, 4}};
    for (int32_t i = 0; i < 9; i++) {
        mus_edge_def def;
        mus_edge_def_init(&def, sizeof def);
        def.start = points[ends[i][0]], def.end = points[ends[i][1]];
        ck_assert_int_eq(mus_pattern_add_edge(pattern, &def, &edges[i]), MUS_OK);
    }
    const int32_t word[] = {0, 1, 2, 4, 5, 6, 7, 8, 4, 3}, ahead[] = {1, 1, 1, 1, 1, 1, 1, 1, -1, 1};
    ck_assert_int_eq(mus_pattern_set_outline(pattern, panel, 10, word, ahead), MUS_OK);
    sew(5, 8);
    sew(6, 7);
    cut(panel, 0.01);
    int32_t n;
    ck_assert_int_eq(mus_cut_line_loop_count(line), 1);
    ck_assert_int_eq(mus_cut_line_dart_count(line), 0);
    ck_assert_int_eq(mus_cut_line_loop(line, 0, &n, NULL), MUS_OK);
    ck_assert_int_eq(n, 4);
    ck_assert_double_lt(beyond((const double[]){0.2, 0.3}), -0.2);
}
END_TEST


START_TEST(a_hem_turned_up_lies_on_the_cut_lines_of_its_sides)
{
    /* sides that lean in and out; the hem 30 mm, below */
    for (int32_t k = 0; k < 2; k++) {
        const double lean = k == 0 ? 0.06 : -0.06;
        const double xy[] = {-0.15, 0, 0.15, 0, 0.15 + lean, 0.4, -0.15 - lean, 0.4};
        mus_pattern_destroy(pattern);
        ck_assert_int_eq(mus_pattern_create(context, "sample", &pattern), MUS_OK);
        const int32_t panel = polygon(4, xy, "h---");
        ck_assert_int_eq(mus_pattern_set_edge_allowance(pattern, 0, 0.03), MUS_OK);
        cut(panel, 0.01);
        /* the cut line of a side leans by lean / 0.4 and lies 10 mm beyond the sew line */
        const double x = 0.01 * hypot(0.4, lean) / 0.4, slope = lean / 0.4;
        has_point(0.15 + x, 0.0);
        has_point(0.15 + x + 0.03 * slope, -0.03);
        has_point(-0.15 - x - 0.03 * slope, -0.03);
        int32_t n;
        ck_assert_int_eq(mus_cut_line_loop(line, 0, &n, NULL), MUS_OK);
        ck_assert_int_le(n, 8);
    }
}
END_TEST


START_TEST(a_curved_hem_turned_up_lies_on_the_cut_lines_of_its_sides)
{
    /* a sector of a ring: the sides are radii, so the turned hem ends on their cut lines, mirrored in the arc: a point
     * at the distance d outside the arc comes to lie on the same radius d inside it */
    int32_t panel, points[4], edges[4];
    const double radius = 0.9, turn = 0.5, inner = 0.3, ahead_x = sin(turn), ahead_y = cos(turn);
    const double xy[] = {-radius * ahead_x, -radius * ahead_y, radius * ahead_x, -radius * ahead_y,
                         inner * ahead_x, -inner * ahead_y, -inner * ahead_x, -inner * ahead_y};
    ck_assert_int_eq(mus_pattern_add_panel(pattern, "panel", &panel), MUS_OK);
    for (int32_t i = 0; i < 4; i++)
        ck_assert_int_eq(mus_pattern_add_point(pattern, panel, xy[2 * i], xy[2 * i + 1], &points[i]), MUS_OK);
    const int32_t arc = MUS_PIECE_ARC;
    const double middle[] = {0.0, -radius, 0.0, -inner};
    for (int32_t i = 0; i < 4; i++) {
        mus_edge_def def;
        mus_edge_def_init(&def, sizeof def);
        def.start = points[i], def.end = points[(i + 1) % 4];
        if (i % 2 == 0) def.npiece = 1, def.nxy = 1, def.kinds = &arc, def.xy = middle + i;
        ck_assert_int_eq(mus_pattern_add_edge(pattern, &def, &edges[i]), MUS_OK);
    }
    const int32_t directions[] = {1, 1, 1, 1};
    ck_assert_int_eq(mus_pattern_set_outline(pattern, panel, 4, edges, directions), MUS_OK);
    ck_assert_int_eq(mus_pattern_set_edge_label(pattern, edges[0], "hem"), MUS_OK);
    ck_assert_int_eq(mus_pattern_set_edge_allowance(pattern, edges[0], 0.04), MUS_OK);
    cut(panel, 0.01);

    int32_t n, ends = 0;
    const double *loop;
    ck_assert_int_eq(mus_cut_line_loop(line, 0, &n, &loop), MUS_OK);
    for (int32_t i = 0; i < n; i++) {
        const double *p = loop + 2 * i, r = hypot(p[0], p[1]), d = r - radius;
        const double side = fabs(atan2(p[0], -p[1]));
        if (d < 1e-4 || side < 0.95 * turn) continue;
        /* the mirror image, at the radius - d, is 10 mm beyond the side */
        const double beside = (radius - d) * sin(side - turn);
        if (beside > 0.009) ends++;
        ck_assert_double_lt(beside, 0.01 + 1e-5);
        if (d < 0.0399) ck_assert_double_eq_tol(beside, 0.01, 1e-5);
    }
    ck_assert_int_ge(ends, 4);
}
END_TEST


/* the left half of a front with a V, its centre at x = 0, and its mirror image: a stand of 45 mm, 7 mm at the neck */
START_TEST(the_end_of_a_stand_has_the_allowance_of_the_neck)
{
    const double v[] = {0, 0, 0.25, 0, 0.25, 0.6, 0.1, 0.6, 0, 0.4};
    const double mirrored[] = {0, 0, 0, 0.4, -0.1, 0.6, -0.25, 0.6, -0.25, 0};
    const int32_t left = polygon(5, v, "h----"), right = polygon(5, mirrored, "----h");
    mus_seam_def seam;
    mus_seam_def_init(&seam, sizeof seam);
    seam.edge_a = 4, seam.edge_b = 5, seam.closure = _i == 0 ? MUS_CLOSURE_BUTTONS : MUS_CLOSURE_ZIP;
    ck_assert_int_eq(mus_pattern_add_seam(pattern, &seam, NULL), MUS_OK);
    static const int32_t narrow[] = {3, 6}, wide[] = {4, 5};
    for (int32_t i = 0; i < 2; i++) {
        ck_assert_int_eq(mus_pattern_set_edge_allowance(pattern, narrow[i], 0.007), MUS_OK);
        ck_assert_int_eq(mus_pattern_set_edge_allowance(pattern, wide[i], 0.045), MUS_OK);
    }
    /* the cut line of the neck: 7 mm above the line y = 0.4 + 2 x of the sew line, 7 mm sqrt(5) above it upright */
    for (int32_t side = 0; side < 2; side++) {
        const double sign = side == 0 ? 1.0 : -1.0, up = 0.007 * sqrt(5.0);
        cut(side == 0 ? left : right, 0.01);
        if (_i == 1) {
            has_point(-sign * 0.045, 0.4); /* a zip ends where the seam does */
            continue;
        }
        has_point(-sign * 0.045, 0.407);
        has_point(sign * 0.5 * (0.407 - up - 0.4), 0.407);
    }
}
END_TEST


START_TEST(named_designs_are_enclosed_and_fold_on_the_bisector)
{
    /* `make paper` asks it of all named designs, on the printed paper */
    mus_tape *tape;
    int32_t darts = 0;
    ck_assert_int_eq(mus_tape_create(context, &tape), MUS_OK);
    ck_assert_int_eq(mus_tape_set_size(tape, "W40"), MUS_OK);
    for (int32_t d = 0; d < mus_design_count(); d += 48) {
        mus_pattern *own;
        ck_assert_int_eq(mus_design_draft(context, d, tape, NULL, &own), MUS_OK);
        for (int32_t p = 0; p < mus_pattern_panel_count(own); p++) {
            const int32_t *edges;
            int32_t n;
            mus_cut_line_destroy(line);
            ck_assert_int_eq(mus_pattern_cut_line(own, p, 0.01, &line), MUS_OK);
            ck_assert_int_eq(mus_pattern_outline(own, p, &n, &edges, NULL), MUS_OK);
            for (int32_t i = 0; i < n; i++) {
                double xy[10];
                const double at[] = {0.0, 0.25, 0.5, 0.75, 1.0};
                ck_assert_int_eq(mus_pattern_edge_at(own, edges[i], 5, at, xy), MUS_OK);
                for (int32_t k = 0; k < 5; k++) ck_assert_double_lt(beyond(xy + 2 * k), 3e-5);
            }
            darts += mus_cut_line_dart_count(line);
            for (int32_t i = 0; i < mus_cut_line_dart_count(line); i++) {
                double q[8];
                ck_assert_int_eq(mus_cut_line_dart(line, i, q), MUS_OK);
                /* the fold ends on the bisector, and further out than the mouth's middle would be without a cap */
                const double a = atan2(q[1] - q[3], q[0] - q[2]), b = atan2(q[5] - q[3], q[4] - q[2]);
                const double c = atan2(q[7] - q[3], q[6] - q[2]);
                ck_assert_double_eq_tol(cos(c - a), cos(c - b), 1e-9);
                ck_assert_double_lt(beyond(q + 6), 0.0);
            }
        }
        mus_pattern_destroy(own);
    }
    ck_assert_int_gt(darts, 20);
    mus_tape_destroy(tape);
}
END_TEST


START_TEST(faults_are_named)
{
    const int32_t panel = polygon(7, darted, "-------");
    int32_t empty;
    double out[8];
    ck_assert_int_eq(mus_pattern_add_panel(pattern, "empty", &empty), MUS_OK);
    ck_assert_int_eq(mus_pattern_cut_line(NULL, panel, 0.01, &line), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_cut_line(pattern, panel, 0.01, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_cut_line(pattern, panel, NAN, &line), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_cut_line(pattern, panel, 0.3, &line), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_cut_line(pattern, 9, 0.01, &line), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_cut_line(pattern, empty, 0.01, &line), MUS_ERR_PATTERN);
    ck_assert_ptr_null(line);
    cut(panel, 0.01);
    ck_assert_int_eq(mus_cut_line_loop(line, 1, NULL, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_cut_line_dart(line, 0, out), MUS_ERR_ARG);
    ck_assert_int_eq(mus_cut_line_loop_count(NULL) + mus_cut_line_dart_count(NULL), 0);
    mus_cut_line_destroy(NULL);

    sew(3, 4);
    ck_assert_int_eq(mus_pattern_set_edge_label(pattern, 0, "hem"), MUS_OK);
    int64_t n = 0;
    for (mus_status status = MUS_ERR_MEMORY; status != MUS_OK; n++) {
        const size_t before = mus_context_bytes(context);
        mus_cut_line *other;
        support_fail_after(n, false);
        status = mus_pattern_cut_line(pattern, panel, 0.01, &other);
        support_fail_never();
        if (status != MUS_OK) ck_assert_int_eq(status, MUS_ERR_MEMORY);
        mus_cut_line_destroy(other);
        ck_assert_uint_eq(mus_context_bytes(context), before);
    }
    ck_assert_int_gt(n, 8);
}
END_TEST


Suite *mus_suite_cut_line(void);
Suite *mus_suite_cut_line(void)
{
    Suite *suite = suite_create("cut_line");
    TCase *test = tcase_create("cut_line");
    tcase_add_checked_fixture(test, setup, teardown);
    tcase_add_test(test, a_dart_is_capped_by_the_edge_that_it_is_folded_onto);
    tcase_add_loop_test(test, a_cap_lies_on_the_cut_line_of_an_edge_with_a_corner_at_the_fold, 0, 2);
    tcase_add_loop_test(test, a_cap_makes_no_loop_of_its_own, 0, 3);
    tcase_add_test(test, legs_with_an_allowance_of_their_own_are_cut_open);
    tcase_add_test(test, a_dart_inside_the_panel_is_not_cut);
    tcase_add_test(test, a_hem_turned_up_lies_on_the_cut_lines_of_its_sides);
    tcase_add_test(test, a_curved_hem_turned_up_lies_on_the_cut_lines_of_its_sides);
    tcase_add_loop_test(test, the_end_of_a_stand_has_the_allowance_of_the_neck, 0, 2);
    tcase_add_test(test, named_designs_are_enclosed_and_fold_on_the_bisector);
    tcase_add_test(test, faults_are_named);
    suite_add_tcase(suite, test);
    return suite;
}
