/* test_layout.c: pieces on cloth: their outlines are the cut lines, a gap apart; fold, nap, stripes, grain are kept. */
#include <math.h>
#include <string.h>

#include "muslin/muslin.h"
#include "support.h"

Suite *mus_suite_layout(void);

static mus_context *context;
static mus_tape *tape;


static void setup(void)
{
    context = support_context();
    ck_assert_int_eq(mus_tape_create(context, &tape), MUS_OK);
    ck_assert_int_eq(mus_tape_set_size(tape, "W40"), MUS_OK);
    ck_assert_int_eq(mus_tape_complete(tape), MUS_OK);
}


static void teardown(void)
{
    mus_tape_destroy(tape);
    support_context_end(context);
}


static mus_pattern *drafted(const char *name)
{
    mus_pattern *pattern = NULL;
    ck_assert_int_eq(mus_design_draft(context, mus_design_find(name), tape, NULL, &pattern), MUS_OK);
    return pattern;
}


static mus_layout *laid(const mus_pattern *pattern, const mus_layout_def *def)
{
    mus_layout *layout = NULL;
    const mus_status status = mus_layout_create(context, pattern, def, &layout);
    ck_assert_msg(status == MUS_OK, "%s", mus_context_error(context));
    return layout;
}


static mus_layout_def quick(void)
{
    mus_layout_def def;
    mus_layout_def_init(&def, sizeof def);
    def.steps = 20000000;
    return def;
}


static mus_layout_piece piece_of(const mus_layout *layout, int32_t index)
{
    mus_layout_piece piece;
    mus_layout_piece_init(&piece, sizeof piece);
    ck_assert_int_eq(mus_layout_piece_get(layout, index, &piece), MUS_OK);
    return piece;
}


static double point_segment(const double *p, const double *a, const double *b)
{
    const double dx = b[0] - a[0], dy = b[1] - a[1], d = dx * dx + dy * dy;
    double t = d > 0.0 ? ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / d : 0.0;
    t = fmin(1.0, fmax(0.0, t));
    return hypot(p[0] - a[0] - t * dx, p[1] - a[1] - t * dy);
}


/* least distance of a corner of one outline to a side of the other */
static double distance(const mus_layout_piece *a, const mus_layout_piece *b)
{
    double best = HUGE_VAL;
    for (int32_t i = 0; i < a->n; i++)
        for (int32_t j = 0; j < b->n; j++)
            best = fmin(best, point_segment(a->xy + 2 * i, b->xy + 2 * j, b->xy + 2 * ((j + 1) % b->n)));
    return best;
}


static double area(int32_t n, const double *xy)
{
    double sum = 0.0;
    for (int32_t i = 0; i < n; i++) {
        const double *p = xy + 2 * i, *q = xy + 2 * ((i + 1) % n);
        sum += p[0] * q[1] - p[1] * q[0];
    }
    return 0.5 * fabs(sum);
}


/* is the point within the outline, by the angle that it goes round */
static bool holds(const mus_layout_piece *a, const double *p)
{
    double sum = 0.0;
    for (int32_t i = 0; i < a->n; i++) {
        const double *u = a->xy + 2 * i, *v = a->xy + 2 * ((i + 1) % a->n);
        const double x[2] = {u[0] - p[0], u[1] - p[1]}, y[2] = {v[0] - p[0], v[1] - p[1]};
        sum += atan2(x[0] * y[1] - x[1] * y[0], x[0] * y[0] + x[1] * y[1]);
    }
    return fabs(sum) > 3.0;
}


/* pieces lie within the cloth and are `gap` apart; utilisation and length are those of the outlines */
static void ensure_laid(const mus_layout *layout, const mus_layout_def *def)
{
    const double near = 1e-7;
    double length = 0.0, sum = 0.0;
    for (int32_t i = 0; i < mus_layout_piece_count(layout); i++) {
        const mus_layout_piece a = piece_of(layout, i);
        const bool folded = a.layers == 2 || a.on_fold;
        ck_assert(folded <= (def->fold != 0));
        ck_assert(!(a.turned && def->nap));
        sum += area(a.n, a.xy) * ((folded ? 2.0 : 1.0) - (a.spare ? 1.0 : 0.0));
        for (int32_t k = 0; k < a.n; k++) {
            const double x = a.xy[2 * k], y = a.xy[2 * k + 1];
            length = fmax(length, x);
            ck_assert(x > -near && y > -near && y < def->width * (folded ? 0.5 : 1.0) + near);
            ck_assert(folded ? x < mus_layout_folded(layout) + near : x > mus_layout_folded(layout) - near);
        }
        for (int32_t j = 0; j < i; j++) {
            const mus_layout_piece b = piece_of(layout, j);
            const double least = fmin(distance(&a, &b), distance(&b, &a));
            ck_assert_msg(least > def->gap - near, "%s and %s: %g m apart", a.name, b.name, least);
            ck_assert(!holds(&a, b.xy) && !holds(&b, a.xy));
        }
    }
    ck_assert(fabs(length - mus_layout_length(layout)) < near);
    ck_assert(fabs(sum / (length * def->width) - mus_layout_utilisation(layout)) < 1e-4);
}


/* how often each panel is cut, spares not counted, and how often of them turned over */
static void ensure_counts(const mus_layout *layout, const mus_pattern *pattern, int32_t material)
{
    int32_t cut[64] = {0}, over[64] = {0};
    for (int32_t i = 0; i < mus_layout_piece_count(layout); i++) {
        const mus_layout_piece piece = piece_of(layout, i);
        cut[piece.panel] += piece.layers - piece.spare;
        over[piece.panel] += piece.layers == 2 && !piece.spare ? 1 : piece.mirrored && !piece.spare;
    }
    const mus_pattern *more = mus_pattern_cut_only(pattern);
    const int32_t own = mus_pattern_panel_count(pattern), others = more ? mus_pattern_panel_count(more) : 0;
    for (int32_t k = 0; k < own + others; k++) {
        const mus_pattern *from = k < own ? pattern : more;
        const int32_t panel = k < own ? k : k - own;
        int32_t image, count, mirrored;
        ck_assert_int_eq(mus_pattern_cut(from, panel, NULL, &image), MUS_OK);
        ck_assert_int_eq(mus_pattern_material(from, panel, material, &count, &mirrored), MUS_OK);
        ck_assert_int_eq(cut[k], image == MUS_NONE ? count : 0);
        if (image == MUS_NONE && mirrored) ck_assert_int_eq(over[k], count / 2);
    }
}


static const char *const designs[] = {"jeans", "tshirt", "shirt", "skirt", "sheath"};


START_TEST(pieces_of_designs_are_all_there_a_gap_apart)
{
    mus_pattern *pattern = drafted(designs[_i]);
    for (int way = 0; way < 4; way++) {
        mus_layout_def def = quick();
        def.fold = way & 1, def.nap = way >> 1;
        def.gap = way == 3 ? 0.01 : 0.002;
        mus_layout *layout = laid(pattern, &def);
        ensure_laid(layout, &def);
        ensure_counts(layout, pattern, MUS_MATERIAL_MAIN);
        mus_layout_destroy(layout);
    }
    mus_pattern_destroy(pattern);
}
END_TEST


/* the outline is the public cut line, moved by turn and shift; half of it on the fold. The turn keeps lengths, and its
 * determinant tells what is turned over */
START_TEST(outlines_are_cut_lines_in_their_place)
{
    mus_pattern *pattern = drafted("shirt");
    const mus_pattern *more = mus_pattern_cut_only(pattern);
    mus_layout_def def = quick();
    for (def.fold = 0; def.fold < 2; def.fold++) {
        mus_layout *layout = laid(pattern, &def);
        for (int32_t i = 0; i < mus_layout_piece_count(layout); i++) {
            const mus_layout_piece piece = piece_of(layout, i);
            const int32_t own = mus_pattern_panel_count(pattern);
            mus_cut_line *line;
            const double *xy, *m = piece.turn;
            int32_t n, found = 0;
            ck_assert_int_eq(mus_pattern_cut_line(piece.panel < own ? pattern : more,
                                                  piece.panel < own ? piece.panel : piece.panel - own, def.allowance,
                                                  &line),
                             MUS_OK);
            ck_assert_int_eq(mus_cut_line_loop(line, 0, &n, &xy), MUS_OK);
            ck_assert(fabs(m[0] * m[0] + m[2] * m[2] - 1.0) < 1e-12 && fabs(m[0] * m[1] + m[2] * m[3]) < 1e-12);
            for (int32_t k = 0; k < n; k++) {
                const double p[2] = {m[0] * xy[2 * k] + m[1] * xy[2 * k + 1] + piece.shift[0],
                                     m[2] * xy[2 * k] + m[3] * xy[2 * k + 1] + piece.shift[1]};
                double best = HUGE_VAL;
                for (int32_t j = 0; j < piece.n; j++)
                    best = fmin(best, hypot(p[0] - piece.xy[2 * j], p[1] - piece.xy[2 * j + 1]));
                if (best < 1e-9)
                    found++;
                else
                    ck_assert(piece.on_fold && p[1] < 1e-9);
            }
            ck_assert_int_ge(found, piece.on_fold ? n / 3 : n);
            double grain[2];
            ck_assert_int_eq(mus_pattern_grain(piece.panel < own ? pattern : more,
                                               piece.panel < own ? piece.panel : piece.panel - own, grain),
                             MUS_OK);
            ck_assert(fabs(m[0] * grain[0] + m[1] * grain[1] - (piece.turned ? -1.0 : 1.0)) < 1e-9);
            mus_cut_line_destroy(line);
        }
        mus_layout_destroy(layout);
    }
    mus_pattern_destroy(pattern);
}
END_TEST


START_TEST(folded_cloth_has_halves_on_the_fold)
{
    mus_pattern *pattern = drafted("tshirt");
    mus_layout_def def = quick();
    def.fold = 1;
    mus_layout *layout = laid(pattern, &def);
    int32_t halves = 0;
    for (int32_t i = 0; i < mus_layout_piece_count(layout); i++) {
        const mus_layout_piece piece = piece_of(layout, i);
        double low = HUGE_VAL;
        for (int32_t k = 0; k < piece.n; k++) low = fmin(low, piece.xy[2 * k + 1]);
        if (piece.on_fold) ck_assert(fabs(low) < 1e-8);
        halves += piece.on_fold;
    }
    ck_assert_int_ge(halves, 2); /* front and back */
    mus_layout_destroy(layout);
    mus_pattern_destroy(pattern);
}
END_TEST


/* one trapezium without symmetry along the grain, cut once; with a pair beside it whose room it does not need */
static mus_pattern *single(double wide, int32_t count)
{
    const double corner[4][2] = {{0, 0}, {wide, 0}, {0.5 * wide, 0.3}, {0, 0.3}};
    mus_pattern *pattern;
    int32_t panel, point[4], edge[4], along[4] = {1, 1, 1, 1};
    ck_assert_int_eq(mus_pattern_create(context, "single", &pattern), MUS_OK);
    ck_assert_int_eq(mus_pattern_add_panel(pattern, "trapezium", &panel), MUS_OK);
    for (int i = 0; i < 4; i++)
        ck_assert_int_eq(mus_pattern_add_point(pattern, panel, corner[i][0], corner[i][1], &point[i]), MUS_OK);
    for (int i = 0; i < 4; i++) {
        mus_edge_def def;
        mus_edge_def_init(&def, sizeof def);
        def.start = point[i], def.end = point[(i + 1) % 4];
        ck_assert_int_eq(mus_pattern_add_edge(pattern, &def, &edge[i]), MUS_OK);
    }
    ck_assert_int_eq(mus_pattern_set_outline(pattern, panel, 4, edge, along), MUS_OK);
    ck_assert_int_eq(mus_pattern_set_cut(pattern, panel, count, MUS_NONE), MUS_OK);
    return pattern;
}


START_TEST(a_single_piece_is_cut_open_or_to_spare_whichever_is_shorter)
{
    for (int count = 1; count <= 4; count++) {
        mus_pattern *pattern = single(0.4, count);
        mus_layout_def def = quick();
        def.fold = 1, def.width = 1.4, def.nap = 1;
        mus_layout *layout = laid(pattern, &def);
        ensure_laid(layout, &def);
        /* 1 to 3 of 0.42 m lie abreast on opened cloth, as many as a folded one with spares has rows */
        ck_assert_int_eq(mus_layout_piece_count(layout), count);
        ck_assert(mus_layout_length(layout) < (count == 4 ? 0.66 : 0.34));
        mus_layout_destroy(layout);
        mus_pattern_destroy(pattern);
    }
}
END_TEST


START_TEST(a_piece_as_wide_as_the_cloth_fits)
{
    for (int fold = 0; fold < 2; fold++) {
        mus_pattern *pattern = single(1.38, 2);
        mus_layout_def def = quick();
        mus_cut_line *line;
        const double *xy;
        double low = HUGE_VAL, high = -HUGE_VAL;
        int32_t n;
        ck_assert_int_eq(mus_pattern_cut_line(pattern, 0, def.allowance, &line), MUS_OK);
        ck_assert_int_eq(mus_cut_line_loop(line, 0, &n, &xy), MUS_OK);
        for (int32_t k = 0; k < n; k++) {
            low = fmin(low, xy[2 * k]);
            high = fmax(high, xy[2 * k]);
        }
        mus_cut_line_destroy(line);
        def.fold = fold, def.width = high - low;
        mus_layout *layout = laid(pattern, &def);
        ensure_laid(layout, &def);
        ck_assert_int_eq(mus_layout_piece_count(layout), 2);
        mus_layout_destroy(layout);
        mus_pattern_destroy(pattern);
    }
}
END_TEST


START_TEST(a_piece_wider_than_the_cloth_is_refused_by_name)
{
    mus_pattern *pattern = single(1.5, 1);
    mus_layout *layout = NULL;
    for (int fold = 0; fold < 2; fold++) {
        mus_layout_def def = quick();
        def.fold = fold;
        ck_assert_int_eq(mus_layout_create(context, pattern, &def, &layout), MUS_ERR_ARG);
        ck_assert_ptr_null(layout);
        ck_assert_msg(strstr(mus_context_error(context), "trapezium is wider than the cloth of 1.4 m") != NULL, "%s",
                      mus_context_error(context));
    }
    mus_pattern_destroy(pattern);
}
END_TEST


START_TEST(hems_lie_on_stripes)
{
    mus_pattern *pattern = drafted("shirt");
    mus_layout_def def = quick();
    def.stripe = 0.05;
    for (def.fold = 0; def.fold < 2; def.fold++) {
        mus_layout *layout = laid(pattern, &def);
        ensure_laid(layout, &def);
        for (int32_t i = 0; i < mus_layout_piece_count(layout); i++) {
            const mus_layout_piece piece = piece_of(layout, i);
            double low = HUGE_VAL, high = -HUGE_VAL;
            for (int32_t k = 0; k < piece.n; k++) {
                low = fmin(low, piece.xy[2 * k]);
                high = fmax(high, piece.xy[2 * k]);
            }
            const double at = (piece.turned ? high : low) / def.stripe;
            ck_assert_msg(fabs(at - nearbyint(at)) < 1e-6, "%s: %g stripes", piece.name, at);
        }
        mus_layout_destroy(layout);
    }
    mus_pattern_destroy(pattern);
}
END_TEST


START_TEST(the_grain_stays_within_its_tolerance)
{
    mus_pattern *pattern = drafted("jeans");
    mus_layout_def def = quick();
    int32_t leaves = 0;
    def.tolerance = 0.03;
    mus_layout *layout = laid(pattern, &def);
    ensure_laid(layout, &def);
    for (int32_t i = 0; i < mus_layout_piece_count(layout); i++) {
        const mus_layout_piece piece = piece_of(layout, i);
        if (piece.panel >= mus_pattern_panel_count(pattern)) continue;
        double grain[2];
        ck_assert_int_eq(mus_pattern_grain(pattern, piece.panel, grain), MUS_OK);
        const double y = piece.turn[2] * grain[0] + piece.turn[3] * grain[1];
        ck_assert_msg(fabs(y) < sin(0.03) + 1e-9, "%s leaves the grain by %g", piece.name, y);
        leaves += fabs(y) > 1e-6;
    }
    ck_assert_int_gt(leaves, 0);
    mus_layout_destroy(layout);
    mus_pattern_destroy(pattern);
}
END_TEST


START_TEST(each_material_has_a_layout_of_its_own)
{
    mus_pattern *pattern = drafted("shirt");
    double area_of[MUS_MATERIAL_COUNT];
    for (int32_t material = 0; material < MUS_MATERIAL_COUNT; material++) {
        mus_layout_def def = quick();
        def.material = material;
        mus_layout *layout = laid(pattern, &def);
        ensure_counts(layout, pattern, material);
        if (mus_layout_piece_count(layout) > 0)
            ensure_laid(layout, &def);
        else
            ck_assert(mus_layout_length(layout) == 0.0 && mus_layout_utilisation(layout) == 0.0);
        area_of[material] = mus_layout_length(layout);
        mus_layout_destroy(layout);
    }
    ck_assert(area_of[MUS_MATERIAL_MAIN] > 0.5 && area_of[MUS_MATERIAL_INTERFACING] > 0.05);
    ck_assert(area_of[MUS_MATERIAL_RIB] == 0.0);
    mus_pattern_destroy(pattern);
}
END_TEST


/* a layout is the same bytes again, for any number of threads, and does not need the pattern */
START_TEST(a_layout_is_the_same_for_any_number_of_threads)
{
    mus_layout *layouts[3];
    for (int k = 0; k < 3; k++) {
        mus_pattern *pattern = drafted("skirt");
        mus_layout_def def = quick();
        def.steps = 2000000, def.runs = 3, def.threads = k + 1, def.fold = 1;
        layouts[k] = laid(pattern, &def);
        mus_pattern_destroy(pattern);
    }
    for (int k = 1; k < 3; k++)
        for (int32_t i = 0; i < mus_layout_piece_count(layouts[0]); i++) {
            const mus_layout_piece a = piece_of(layouts[0], i), b = piece_of(layouts[k], i);
            ck_assert_int_eq(memcmp(a.xy, b.xy, 2 * (size_t)a.n * sizeof *a.xy), 0);
            ck_assert_str_eq(a.name, b.name);
        }
    for (int k = 0; k < 3; k++) mus_layout_destroy(layouts[k]);
}
END_TEST


/* items: quarter turns are exact, clockwise outlines are taken, a gap of 0 is allowed */
START_TEST(items_lie_in_their_turns)
{
    static const double wide[8] = {0, 0, 0, 0.3, 2, 0.3, 2, 0};
    static const double turns[2] = {1.5707963267948966, 4.71238898038469};
    mus_layout_item item;
    mus_layout *layout;
    mus_layout_def def = quick();
    def.width = 2.5, def.gap = 0.0;
    mus_layout_item_init(&item, sizeof item);
    item.n = 4, item.xy = wide, item.count = 3, item.turns = turns, item.turn_count = 2;
    ck_assert_int_eq(mus_layout_create_items(context, 1, &item, &def, &layout), MUS_OK);
    ck_assert_int_eq(mus_layout_piece_count(layout), 3);
    ck_assert_msg(mus_layout_length(layout) >= 0.9 && mus_layout_length(layout) < 0.91, "%g",
                  mus_layout_length(layout));
    for (int32_t i = 0; i < 3; i++) {
        const mus_layout_piece piece = piece_of(layout, i);
        ck_assert(piece.turn[0] == 0.0 && fabs(piece.turn[2]) == 1.0 && piece.panel == 0 && *piece.name == '\0');
    }
    ensure_laid(layout, &def);
    mus_layout_destroy(layout);
    def.width = 1.9;
    ck_assert_int_eq(mus_layout_create_items(context, 1, &item, &def, &layout), MUS_ERR_ARG);
}
END_TEST


static int32_t count_calls(void *user, double done, double length)
{
    double *last = user;
    ck_assert(done >= *last && done <= 1.0 && length > 0.0);
    *last = done;
    return done > 0.4;
}


START_TEST(progress_rises_and_may_end_the_search)
{
    mus_pattern *pattern = drafted("jeans");
    mus_layout_def def = quick();
    double last = 0.0;
    def.steps = 1000000000, def.progress = count_calls, def.user = &last;
    mus_layout *layout = laid(pattern, &def);
    ensure_laid(layout, &def);
    ck_assert(last > 0.4 && last < 0.9 && mus_layout_steps(layout) < 900000000);
    mus_layout_destroy(layout);
    mus_pattern_destroy(pattern);
}
END_TEST


Suite *mus_suite_layout(void)
{
    Suite *suite = suite_create("layout");
    TCase *tests = tcase_create("layout");
    tcase_add_checked_fixture(tests, setup, teardown);
    tcase_set_timeout(tests, 120);
    tcase_add_loop_test(tests, pieces_of_designs_are_all_there_a_gap_apart, 0, 5);
    tcase_add_test(tests, outlines_are_cut_lines_in_their_place);
    tcase_add_test(tests, folded_cloth_has_halves_on_the_fold);
    tcase_add_test(tests, a_single_piece_is_cut_open_or_to_spare_whichever_is_shorter);
    tcase_add_test(tests, a_piece_as_wide_as_the_cloth_fits);
    tcase_add_test(tests, a_piece_wider_than_the_cloth_is_refused_by_name);
    tcase_add_test(tests, hems_lie_on_stripes);
    tcase_add_test(tests, the_grain_stays_within_its_tolerance);
    tcase_add_test(tests, each_material_has_a_layout_of_its_own);
    tcase_add_test(tests, a_layout_is_the_same_for_any_number_of_threads);
    tcase_add_test(tests, items_lie_in_their_turns);
    tcase_add_test(tests, progress_rises_and_may_end_the_search);
    suite_add_tcase(suite, tests);
    return suite;
}
