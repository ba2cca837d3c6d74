/*
 * test_piece_marks.c: what is drawn on a piece: seam line edge by edge, slits on the cut line, grain, marks, label.
 */
#include <math.h>

#include "print/page.h"
#include "print/sample_patterns.h"
#include "support.h"

static mus_context *context;
static mus_pattern *pattern;
static mus_sheet *sheet;


static void setup(void)
{
    mus_sheet_def def;
    context = support_context();
    pattern = sample_shirt(context);
    ck_assert_ptr_nonnull(pattern);
    mus_sheet_def_init(&def, sizeof def);
    def.person = "Ada";
    ck_assert_int_eq(mus_sheet_create(context, pattern, &def, &sheet), MUS_OK);
}


static void teardown(void)
{
    mus_sheet_destroy(sheet);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}


static double segment_distance(const double *p, const double *a, const double *b)
{
    double dx = b[0] - a[0], dy = b[1] - a[1], t = ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / (dx * dx + dy * dy);
    t = t < 0.0 ? 0.0 : t > 1.0 ? 1.0 : t;
    return hypot(p[0] - a[0] - t * dx, p[1] - a[1] - t * dy);
}


static double distance(int32_t n, const double *xy, const double *p)
{
    double best = HUGE_VAL;
    for (int32_t i = 0; i < n; i++) best = fmin(best, segment_distance(p, xy + 2 * i, xy + 2 * ((i + 1) % n)));
    return best;
}


/* paths of a piece in a layer with a pen */
static int32_t count(int32_t piece, mus__layer layer, mus__pen pen)
{
    int32_t n = 0;
    for (int32_t i = 0; i < sheet->drawing.npath; i++) {
        const mus__path *path = &sheet->drawing.paths[i];
        n += path->piece == piece && path->layer == layer && path->pen == pen;
    }
    return n;
}


START_TEST(each_edge_is_a_seam_path_of_its_own)
{
    for (int32_t i = 0; i < sheet->npiece; i++) {
        ck_assert_int_eq(count(i, MUS__LAYER_SEAM, MUS__PEN_SEAM), sheet->pieces[i].nside);
        ck_assert_int_eq(count(i, MUS__LAYER_CUT, MUS__PEN_CUT), 1);
    }
}
END_TEST


START_TEST(slits_start_on_the_cut_line_and_stop_before_the_seam)
{
    static const int32_t expected[] = {1 + 1 + 3, 2 + 2 + 3, 1 + 2, 0};
    for (int32_t i = 0; i < sheet->npiece; i++) {
        const mus__piece *piece = &sheet->pieces[i];
        int32_t slits = 0;
        for (int32_t k = 0; k < sheet->drawing.npath; k++) {
            const mus__path *path = &sheet->drawing.paths[k];
            if (path->piece != i || path->layer != MUS__LAYER_NOTCHES) continue;
            const double *xy = sheet->drawing.xy + path->at;
            for (int32_t m = 0; m < path->nop / 2; m++, xy += 4, slits++) {
                ck_assert_double_lt(distance(piece->cut.n, piece->cut.xy, xy), 1e-5);
                ck_assert_double_gt(distance(piece->nflat, piece->flat, xy + 2), 0.002 - 1e-5);
                double depth = hypot(xy[2] - xy[0], xy[3] - xy[1]);
                ck_assert_double_gt(depth, 0.004);
                ck_assert_double_lt(depth, 0.006);
                /* along the normal: the inner end is nearer to the seam line by the whole depth */
                double outer = distance(piece->nflat, piece->flat, xy);
                double inner = distance(piece->nflat, piece->flat, xy + 2);
                ck_assert_double_eq_tol(outer - inner, depth, 2e-5);
            }
        }
        ck_assert_int_eq(slits, expected[i]);
    }
}
END_TEST


START_TEST(a_notch_stands_at_its_arc_length)
{
    /* the middle of the hem of the front: three slits round x = 0 of the panel, 4 mm apart */
    const mus__piece *piece = &sheet->pieces[0];
    double middle[2], seen[3];
    int32_t n = 0;
    mus__piece_point(piece, (const double[2]){0, 0}, middle);
    for (int32_t k = 0; k < sheet->drawing.npath; k++) {
        const mus__path *path = &sheet->drawing.paths[k];
        if (path->piece != 0 || path->layer != MUS__LAYER_NOTCHES || path->nop != 6) continue;
        for (int32_t m = 0; m < 3; m++) seen[n++] = sheet->drawing.xy[path->at + 4 * m];
    }
    ck_assert_int_eq(n, 3);
    for (int32_t k = 0; k < 3; k++) ck_assert_double_eq_tol(seen[k], middle[0] + 0.004 * (k - 1), 1e-6);
}
END_TEST


/* at an end of its edge a double notch has both slits on the edge, 4 mm apart as elsewhere; on an edge of 3 mm both
 * stand at its ends */
START_TEST(a_notch_at_an_end_keeps_its_slits_apart)
{
    const double xy[] = {0, 0, 0.3, 0, 0.3, 0.2, 0.297, 0.2, 0, 0.2};
    mus_pattern *shape = sample_polygon(context, 5, xy);
    mus_sheet_def def;
    mus_sheet_def_init(&def, sizeof def);
    def.allowance = 0.01;
    ck_assert_int_eq(mus_pattern_add_notch(shape, 0, 0.3, MUS_NOTCH_DOUBLE, NULL), MUS_OK);
    ck_assert_int_eq(mus_pattern_add_notch(shape, 4, 0.0005, MUS_NOTCH_TRIPLE, NULL), MUS_OK);
    ck_assert_int_eq(mus_pattern_add_notch(shape, 2, 0.0, MUS_NOTCH_DOUBLE, NULL), MUS_OK);
    mus_sheet_destroy(sheet);
    ck_assert_int_eq(mus_sheet_create(context, shape, &def, &sheet), MUS_OK);
    const double apart[3] = {0.004, 0.008, 0.003};
    int32_t n = 0;
    for (int32_t k = 0; k < sheet->drawing.npath; k++) {
        const mus__path *path = &sheet->drawing.paths[k];
        if (path->layer != MUS__LAYER_NOTCHES) continue;
        const double *first = sheet->drawing.xy + path->at, *last = first + 2 * (path->nop - 2);
        ck_assert_double_eq_tol(hypot(last[0] - first[0], last[1] - first[1]), apart[n++], 1e-9);
    }
    ck_assert_int_eq(n, 3);
    mus_pattern_destroy(shape);
}
END_TEST


/* arc length along edge 0 of the lower side of a house's plan, of 2 edges of 15 cm, of each slit of a triple notch at
 * the end of edge 0 (k = 0) or the beginning of edge 1: past the end it goes on along edge 1 */
static void ends(double drop, int32_t k, double *out)
{
    const double xy[] = {0, drop, 0.15, 0, 0.3, drop, 0.3, 0.2, 0, 0.2}, edge = hypot(0.15, drop);
    double corner[2], first[2];
    mus_pattern *house = sample_polygon(context, 5, xy);
    ck_assert_int_eq(mus_pattern_add_notch(house, k, k == 0 ? edge : 0.0, MUS_NOTCH_TRIPLE, NULL), MUS_OK);
    mus_sheet_destroy(sheet);
    ck_assert_int_eq(mus_sheet_create(context, house, NULL, &sheet), MUS_OK);
    mus__piece_point(&sheet->pieces[0], xy + 2, corner);
    mus__piece_point(&sheet->pieces[0], xy, first);
    for (int32_t i = 0; i < sheet->drawing.npath; i++) {
        const mus__path *path = &sheet->drawing.paths[i];
        if (path->layer != MUS__LAYER_NOTCHES) continue;
        ck_assert_int_eq(path->nop, 6);
        ck_assert_int_eq(path->edge, k);
        /* the foot of each slit on the sew line: 1 cm further along its direction */
        for (int32_t m = 0; m < 3; m++) {
            const double *p = sheet->drawing.xy + path->at + 4 * m, d = hypot(p[2] - p[0], p[3] - p[1]);
            const double x = p[0] + 0.01 * (p[2] - p[0]) / d - corner[0],
                         y = p[1] + 0.01 * (p[3] - p[1]) / d - corner[1];
            out[m] = (x * (first[0] - corner[0]) > 0.0 ? -1.0 : 1.0) * hypot(x, y);
        }
    }
    mus_pattern_destroy(house);
}


/* a triple notch at the end of its edge has its middle slit there, where the outline turns by less than 15 degrees;
 * at a sharper corner all three stand on its own edge */
START_TEST(the_middle_slit_of_three_is_the_place)
{
    const double drops[] = {0.0, 0.0184, 0.0211, -0.0184};
    for (int32_t i = 0; i < 8; i++) {
        const double own = i % 4 != 2 ? 0.0 : i < 4 ? -0.004 : 0.004;
        double slits[3] = {NAN, NAN, NAN};
        ends(drops[i % 4], i / 4, slits);
        for (int32_t m = 0; m < 3; m++) ck_assert_double_eq_tol(slits[m], own + 0.004 * (m - 1), 4e-4);
    }
}
END_TEST


START_TEST(the_grain_line_is_upright_inside_and_long)
{
    for (int32_t i = 0; i < sheet->npiece; i++) {
        const mus__piece *piece = &sheet->pieces[i];
        ck_assert_int_eq(count(i, MUS__LAYER_GRAIN, MUS__PEN_GRAIN), 1);
        for (int32_t k = 0; k < sheet->drawing.npath; k++) {
            const mus__path *path = &sheet->drawing.paths[k];
            if (path->piece != i || path->pen != MUS__PEN_GRAIN) continue;
            ck_assert_double_eq(path->box[0], path->box[2]);
            ck_assert_double_ge(path->box[3] - path->box[1], (piece->box[3] - piece->box[1]) / 3.0);
            for (int32_t m = 0; m <= 20; m++) {
                const double p[2] = {path->box[0], path->box[1] + (path->box[3] - path->box[1]) * m / 20.0};
                ck_assert_double_gt(distance(piece->nflat, piece->flat, p), 0.003);
            }
        }
    }
}
END_TEST


START_TEST(labels_stand_inside_the_seam_line_clear_of_grain_and_marks)
{
    for (int32_t i = 0; i < sheet->npiece; i++) {
        const mus__piece *piece = &sheet->pieces[i];
        double box[4] = {HUGE_VAL, HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
        int32_t lines = 0;
        for (int32_t k = 0; k < sheet->drawing.npath; k++) {
            const mus__path *path = &sheet->drawing.paths[k];
            if (path->piece != i || path->layer != MUS__LAYER_LABEL) continue;
            for (int32_t m = 0; m < 2; m++) {
                box[m] = fmin(box[m], path->box[m]);
                box[2 + m] = fmax(box[2 + m], path->box[2 + m]);
            }
            lines++;
        }
        /* a line more where edges differ in their allowance */
        ck_assert(lines == 7 || lines == 8);
        for (int32_t k = 0; k < piece->nflat; k++)
            ck_assert(!mus__segment_meets(piece->flat + 2 * k, piece->flat + 2 * ((k + 1) % piece->nflat), box));
        for (int32_t k = 0; k < sheet->drawing.npath; k++) {
            const mus__path *path = &sheet->drawing.paths[k];
            if (path->piece != i || (path->layer != MUS__LAYER_GRAIN && path->layer != MUS__LAYER_MARKS)) continue;
            ck_assert(path->box[0] > box[2] || path->box[2] < box[0] || path->box[1] > box[3] || path->box[3] < box[1]);
        }
    }
}
END_TEST


/* the names of two lines that end in the right side of a square, and beside a line: on the second the name stays at its
 * middle; on the others it moves along them, or to their other side, until no line runs through it */
START_TEST(the_name_of_a_mark_keeps_clear_of_lines)
{
    const double xy[] = {0, 0, 0.3, 0, 0.3, 0.2, 0, 0.2};
    const double marks[3][4] = {{0.28, 0.15, 0.303, 0.15}, {0.1, 0.1, 0.13, 0.1}, {0.1, 0.05, 0.13, 0.05}};
    const double beside[4] = {0.02, 0.055, 0.28, 0.055};
    mus_pattern *square = sample_polygon(context, 4, xy);
    for (int32_t i = 0; i < 3; i++)
        ck_assert_int_eq(mus_pattern_add_mark(square, 0, "a long name", 2, marks[i], NULL), MUS_OK);
    ck_assert_int_eq(mus_pattern_add_mark(square, 0, "b", 2, beside, NULL), MUS_OK);
    mus_sheet_destroy(sheet);
    ck_assert_int_eq(mus_sheet_create(context, square, NULL, &sheet), MUS_OK);
    const mus__piece *piece = &sheet->pieces[0];
    const mus__path *names[3];
    double a[2], b[2];
    int32_t n = 0;
    for (int32_t i = 0; i < sheet->drawing.npath && n < 3; i++) {
        const mus__path *path = &sheet->drawing.paths[i];
        if (path->piece == 0 && path->layer == MUS__LAYER_MARKS && path->pen == MUS__PEN_TEXT) names[n++] = path;
    }
    ck_assert_int_eq(n, 3);
    for (int32_t i = 0; i < 3; i++) {
        for (int32_t k = 0; k < piece->nflat; k++)
            ck_assert(
                !mus__segment_meets(piece->flat + 2 * k, piece->flat + 2 * ((k + 1) % piece->nflat), names[i]->box));
        mus__piece_point(piece, beside, a);
        mus__piece_point(piece, beside + 2, b);
        ck_assert(!mus__segment_meets(a, b, names[i]->box));
        mus__piece_point(piece, marks[i], a);
        const double middle = 0.5 * (names[i]->box[0] + names[i]->box[2]) - a[0];
        if (i == 0)
            ck_assert_double_lt(middle, 0.5 * 0.023 - 0.003);
        else
            ck_assert_double_eq_tol(middle, 0.015, 1e-3);
        ck_assert_int_eq(names[i]->box[1] > a[1], i < 2);
    }
    mus_pattern_destroy(square);
}
END_TEST


START_TEST(without_allowance_cut_line_and_seam_line_are_one)
{
    mus_sheet_def def;
    mus_sheet_def_init(&def, sizeof def);
    def.allowance = 0.0;
    const double xy[] = {0, 0, 0.3, 0, 0.3, 0.2, 0, 0.2};
    mus_pattern *square = sample_polygon(context, 4, xy);
    int32_t id;
    ck_assert_int_eq(mus_pattern_add_notch(square, 0, 0.1, MUS_NOTCH_SINGLE, &id), MUS_OK);
    mus_sheet_destroy(sheet);
    ck_assert_int_eq(mus_sheet_create(context, square, &def, &sheet), MUS_OK);
    const double *box = sheet->drawing.paths[0].box, *own = sheet->pieces[0].box;
    for (int32_t k = 0; k < 4; k++) ck_assert_double_eq_tol(box[k], own[k], 1e-15);
    ck_assert_double_eq_tol(own[2] - own[0], 0.3, 1e-15);
    ck_assert_int_eq(count(0, MUS__LAYER_NOTCHES, MUS__PEN_NOTCH), 1);
    mus_pattern_destroy(square);
}
END_TEST


START_TEST(very_small_pieces_keep_a_label)
{
    const double xy[] = {0, 0, 0.02, 0, 0.02, 0.012, 0, 0.012};
    mus_pattern *patch = sample_polygon(context, 4, xy);
    mus_sheet_destroy(sheet);
    ck_assert_int_eq(mus_sheet_create(context, patch, NULL, &sheet), MUS_OK);
    ck_assert_int_ge(count(0, MUS__LAYER_LABEL, MUS__PEN_SMALL), 6);
    mus_pattern_destroy(patch);
}
END_TEST


Suite *mus_suite_piece_marks(void);
Suite *mus_suite_piece_marks(void)
{
    Suite *suite = suite_create("piece_marks");
    TCase *test = tcase_create("piece_marks");
    tcase_add_checked_fixture(test, setup, teardown);
    tcase_add_test(test, each_edge_is_a_seam_path_of_its_own);
    tcase_add_test(test, slits_start_on_the_cut_line_and_stop_before_the_seam);
    tcase_add_test(test, a_notch_stands_at_its_arc_length);
    tcase_add_test(test, a_notch_at_an_end_keeps_its_slits_apart);
    tcase_add_test(test, the_middle_slit_of_three_is_the_place);
    tcase_add_test(test, the_grain_line_is_upright_inside_and_long);
    tcase_add_test(test, labels_stand_inside_the_seam_line_clear_of_grain_and_marks);
    tcase_add_test(test, the_name_of_a_mark_keeps_clear_of_lines);
    tcase_add_test(test, without_allowance_cut_line_and_seam_line_are_one);
    tcase_add_test(test, very_small_pieces_keep_a_label);
    suite_add_tcase(suite, test);
    return suite;
}
