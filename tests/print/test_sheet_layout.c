/*
 * test_sheet_layout.c: pages: together they show every line once at least, neighbours overlap by what was asked, empty
 * ones are left out, and the marks of two neighbours fall on each other.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "muslin/design.h"
#include "print/page.h"
#include "print/sample_patterns.h"
#include "support.h"

static mus_context *context;
static mus_pattern *pattern;
static mus_sheet *sheet;
static mus_sheet_def def;


static void setup(void)
{
    context = support_context();
    pattern = sample_shirt(context);
    ck_assert_ptr_nonnull(pattern);
    mus_sheet_def_init(&def, sizeof def);
}


static void teardown(void)
{
    mus_sheet_destroy(sheet);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}


static void make(const mus_pattern *from)
{
    mus_sheet_destroy(sheet);
    ck_assert_msg(mus_sheet_create(context, from, &def, &sheet) == MUS_OK, "%s", mus_context_error(context));
}


static bool shown(double x, double y)
{
    for (int32_t i = 0; i < sheet->ntile; i++) {
        double box[4];
        mus__tile_window(sheet, &sheet->tiles[i], box);
        if (x >= box[0] && x <= box[2] && y >= box[1] && y <= box[3]) return true;
    }
    return false;
}


/* every chord of every cut line, each millimetre */
static void assert_all_shown(void)
{
    for (int32_t i = 0; i < sheet->npiece; i++) {
        const mus__loops *cut = &sheet->pieces[i].cut;
        for (int32_t k = 0; k < cut->start[1]; k++) {
            const double *a = cut->xy + 2 * k, *b = cut->xy + 2 * ((k + 1) % cut->start[1]);
            int32_t n = 1 + (int32_t)(hypot(b[0] - a[0], b[1] - a[1]) * 1e3);
            for (int32_t m = 0; m <= n; m++)
                ck_assert(shown(a[0] + (b[0] - a[0]) * m / n, a[1] + (b[1] - a[1]) * m / n));
        }
    }
}


START_TEST(pages_show_every_cut_line_on_each_paper)
{
    for (def.paper = MUS_PAPER_A4; def.paper <= MUS_PAPER_ROLL; def.paper++) {
        for (int32_t k = 0; k < 3; k++) {
            def.margin = 0.006 + 0.003 * k;
            def.overlap = 0.008 * k;
            make(pattern);
            assert_all_shown();
        }
    }
}
END_TEST


START_TEST(neighbours_overlap_by_what_was_asked)
{
    def.overlap = 0.013;
    make(pattern);
    int32_t pairs = 0;
    for (int32_t i = 0; i < sheet->ntile; i++) {
        int32_t right = mus__tile_find(sheet, sheet->tiles[i].column + 1, sheet->tiles[i].row);
        int32_t below = mus__tile_find(sheet, sheet->tiles[i].column, sheet->tiles[i].row + 1);
        double own[4], other[4];
        mus__tile_window(sheet, &sheet->tiles[i], own);
        if (right != MUS_NONE) {
            mus__tile_window(sheet, &sheet->tiles[right], other);
            ck_assert_double_eq_tol(own[2] - other[0], 0.013, 1e-12);
            ck_assert_double_eq_tol(own[1], other[1], 1e-12);
            pairs++;
        }
        if (below != MUS_NONE) {
            mus__tile_window(sheet, &sheet->tiles[below], other);
            ck_assert_double_eq_tol(other[3] - own[1], 0.013, 1e-12);
            pairs++;
        }
    }
    ck_assert_int_gt(pairs, 10);
}
END_TEST


/* boxes of the filled black paths of a page, on the sheet */
static int32_t diamonds(int32_t tile, double (*out)[4])
{
    mus__drawing drawing;
    double window[4], margin = sheet->def.margin;
    int32_t n = 0;
    mus__draw_init(&drawing, context);
    mus__tile_draw(sheet, tile, &drawing);
    mus__tile_window(sheet, &sheet->tiles[tile], window);
    for (int32_t i = 0; i < drawing.npath; i++) {
        if (drawing.paths[i].pen != MUS__PEN_INK) continue;
        for (int32_t k = 0; k < 4; k++) out[n][k] = drawing.paths[i].box[k] + window[k % 2] - margin;
        n++;
    }
    mus__draw_free(&drawing);
    return n;
}


START_TEST(half_diamonds_meet_the_whole_ones_of_the_neighbour)
{
    def.overlap = 0.01;
    make(pattern);
    int32_t halves = 0, wholes = 0;
    for (int32_t i = 0; i < sheet->ntile; i++) {
        double own[4][4], other[4][4];
        int32_t n = diamonds(i, own);
        for (int32_t k = 0; k < n; k++) {
            double w = own[k][2] - own[k][0], h = own[k][3] - own[k][1];
            if (fabs(w - h) < 1e-9) {
                wholes++;
                continue;
            }
            /* a half: the page on its left or above has a whole one whose box holds it */
            bool met = false, level = w > h;
            int32_t before = mus__tile_find(sheet, sheet->tiles[i].column - !level, sheet->tiles[i].row - level);
            ck_assert_int_ne(before, MUS_NONE);
            int32_t m = diamonds(before, other);
            for (int32_t j = 0; j < m; j++)
                met = met || (own[k][0] > other[j][0] - 1e-9 && own[k][1] > other[j][1] - 1e-9 &&
                              own[k][2] < other[j][2] + 1e-9 && own[k][3] < other[j][3] + 1e-9);
            ck_assert(met);
            halves++;
        }
    }
    ck_assert_int_gt(halves, 10);
    ck_assert_int_eq(halves, wholes);
}
END_TEST


START_TEST(frame_on_frame_two_half_diamonds_make_a_whole)
{
    make(pattern);
    int32_t halves = 0;
    for (int32_t i = 0; i < sheet->ntile; i++) {
        double own[4][4], other[4][4];
        const int32_t n = diamonds(i, own);
        for (int32_t k = 0; k < n; k++) {
            /* exactly one page has the other half: the same box mirrored in the frame */
            int32_t met = 0;
            const bool level = own[k][2] - own[k][0] > own[k][3] - own[k][1];
            for (int32_t j = 0; j < sheet->ntile; j++) {
                const int32_t m = diamonds(j, other);
                for (int32_t q = 0; q < m && j != i; q++) {
                    const double *a = own[k], *b = other[q];
                    const int32_t across = level ? 0 : 1, along = 1 - across;
                    met += fabs(a[across] - b[across]) < 1e-9 && fabs(a[2 + across] - b[2 + across]) < 1e-9 &&
                           (fabs(a[along] - b[2 + along]) < 1e-9 || fabs(a[2 + along] - b[along]) < 1e-9);
                }
            }
            ck_assert_int_eq(met, 1);
            halves++;
        }
    }
    ck_assert_int_gt(halves, 10);
}
END_TEST


START_TEST(title_and_squares_lie_in_a_piece_that_leaves_no_other_place)
{
    /* a cloth that fills nine pages but for a border of 5 mm; that in its middle shows no line */
    const double xy[] = {0, 0, 0.54, 0, 0.54, 0.80, 0, 0.80};
    mus_pattern *cloth = sample_polygon(context, 4, xy);
    make(cloth);
    ck_assert_int_eq(sheet->ntile, 8);
    ck_assert(!sheet->cover);
    const double *at = sheet->squares;
    const double boxes[2][4] = {{at[0], at[1], at[0] + MUS__SQUARES, at[1] + MUS__SQUARES},
                                {sheet->legend[0], sheet->legend[1], sheet->legend[2], sheet->legend[3]}};
    for (int32_t k = 0; k < 2; k++) {
        ck_assert(mus__piece_holds(&sheet->pieces[0], boxes[k]));
        for (int32_t i = 0; i < sheet->drawing.npath; i++) {
            const mus__path *path = &sheet->drawing.paths[i];
            if (path->piece != 0 || path->layer < MUS__LAYER_GRAIN) continue;
            ck_assert(path->box[0] > boxes[k][2] || path->box[2] < boxes[k][0] || path->box[1] > boxes[k][3] ||
                      path->box[3] < boxes[k][1]);
        }
    }
    assert_all_shown();
    mus_pattern_destroy(cloth);
}
END_TEST


START_TEST(title_and_squares_lie_on_a_free_place_of_the_first_page)
{
    /* a slanting strip over a few pages leaves room beside it */
    const double xy[] = {0, 0, 0.05, 0, 0.35, 0.7, 0.3, 0.7};
    mus_pattern *strip = sample_polygon(context, 4, xy);
    def.notes = "Cloth\n- one\n\nNotions\n- two";
    make(strip);
    ck_assert(!sheet->cover);
    ck_assert(sheet->full);
    const double *at = sheet->squares;
    const double boxes[2][4] = {{at[0], at[1], at[0] + MUS__SQUARES, at[1] + MUS__SQUARES},
                                {sheet->legend[0], sheet->legend[1], sheet->legend[2], sheet->legend[3]}};
    for (int32_t k = 0; k < 2; k++) {
        int32_t pages = 0;
        for (int32_t i = 0; i < sheet->npiece; i++)
            ck_assert(!mus__piece_meets(&sheet->pieces[i], NULL, boxes[k], NULL));
        for (int32_t i = 0; i < sheet->ntile; i++) {
            double box[4];
            mus__tile_window(sheet, &sheet->tiles[i], box);
            pages += boxes[k][0] > box[0] && boxes[k][1] > box[1] && boxes[k][2] < box[2] && boxes[k][3] < box[3];
        }
        ck_assert_int_eq(pages, 1);
    }
    double first[4];
    mus__tile_window(sheet, &sheet->tiles[0], first);
    ck_assert(boxes[1][0] > first[0] && boxes[1][1] > first[1] && boxes[1][2] < first[2] && boxes[1][3] < first[3]);
    ck_assert(boxes[0][0] > boxes[1][2] || boxes[1][0] > boxes[0][2] || boxes[0][1] > boxes[1][3] ||
              boxes[1][1] > boxes[0][3]);
    ck_assert_int_eq(mus_sheet_page_count(sheet), sheet->ntile);
    mus_pattern_destroy(strip);
}
END_TEST


START_TEST(ten_pages_have_a_cover_of_their_own)
{
    /* cloths of nine pages and of twelve, whose middle ones are blank: with a line on each of these they have all */
    for (int32_t k = 0; k < 2; k++) {
        const double high = k == 0 ? 0.80 : 1.07, xy[] = {0, 0, 0.54, 0, 0.54, high, 0, high};
        const double line[] = {0.27, 0.2, 0.27, high - 0.2};
        mus_pattern *cloth = sample_polygon(context, 4, xy);
        ck_assert_int_eq(mus_pattern_add_mark(cloth, 0, "line", 2, line, NULL), MUS_OK);
        make(cloth);
        ck_assert_int_eq(sheet->ntile, k == 0 ? 9 : 12);
        ck_assert_int_eq(sheet->cover, k);
        ck_assert_int_eq(mus_sheet_page_count(sheet), sheet->ntile + k);
        mus_pattern_destroy(cloth);
    }
}
END_TEST


START_TEST(pages_without_cloth_are_left_out)
{
    /* a slanting strip 1.2 m long on a grid: the corners of the grid are empty, and no page left is */
    const double xy[] = {0, 0, 0.05, 0, 1.05, 1.2, 1, 1.2};
    mus_pattern *strip = sample_polygon(context, 4, xy);
    make(strip);
    ck_assert_int_lt(sheet->ntile, sheet->columns * sheet->rows / 2);
    assert_all_shown();
    for (int32_t i = 0; i < sheet->ntile; i++) {
        double box[4];
        mus__tile_window(sheet, &sheet->tiles[i], box);
        ck_assert(mus__piece_meets(&sheet->pieces[0], NULL, box, NULL));
    }
    mus_pattern_destroy(strip);
}
END_TEST


/* is a path a line that a page is needed for: no letters and no head of an arrow? */
static bool line_of(const mus__path *path)
{
    return path->layer != MUS__LAYER_LABEL && path->pen != MUS__PEN_INK;
}


/* each page has a line where no other page shows it */
static void assert_pages_own_a_line(void)
{
    for (int32_t i = 0; i < sheet->ntile; i++) {
        double box[4], other[4];
        bool own = false;
        mus__tile_window(sheet, &sheet->tiles[i], box);
        for (int32_t p = 0; p < sheet->drawing.npath && !own; p++) {
            const mus__path *path = &sheet->drawing.paths[p];
            const double *line = sheet->drawing.xy + path->at;
            for (int32_t k = 0; k + 1 < path->nop && !own && line_of(path); k++) {
                if (sheet->drawing.ops[path->op + k + 1] != 'l') continue;
                for (int32_t s = 0; s <= 1000 && !own; s++) {
                    const double x = line[2 * k] + 1e-3 * s * (line[2 * k + 2] - line[2 * k]);
                    const double y = line[2 * k + 1] + 1e-3 * s * (line[2 * k + 3] - line[2 * k + 1]);
                    own = x > box[0] && x < box[2] && y > box[1] && y < box[3];
                    for (int32_t j = 0; j < sheet->ntile && own; j++) {
                        mus__tile_window(sheet, &sheet->tiles[j], other);
                        own = j == i || x <= other[0] || x >= other[2] || y <= other[1] || y >= other[3];
                    }
                }
            }
        }
        ck_assert_msg(own, "page %d repeats what others show", (int)i);
    }
}


START_TEST(a_page_without_a_line_of_its_own_is_left_out)
{
    /* 1 m square: the pages inside hold no line at all */
    const double xy[] = {0, 0, 1, 0, 1, 1, 0, 1};
    mus_pattern *square = sample_polygon(context, 4, xy);
    make(square);
    ck_assert_int_lt(sheet->ntile, sheet->columns * sheet->rows);
    assert_all_shown();
    assert_pages_own_a_line();
    mus_pattern_destroy(square);
}
END_TEST


START_TEST(the_head_of_an_arrow_alone_needs_no_page)
{
    /* the grain line of its sleeve ends 3 mm over the edge of a page that holds nothing else */
    mus_tape *tape = NULL;
    mus_pattern *shirt = NULL;
    ck_assert_int_eq(mus_tape_create(context, &tape), MUS_OK);
    ck_assert_int_eq(mus_tape_set_size(tape, "M50"), MUS_OK);
    ck_assert_int_eq(mus_design_draft(context, mus_design_find("shirt_mandarin_long"), tape, NULL, &shirt), MUS_OK);
    def.fold = 1;
    make(shirt);
    assert_all_shown();
    assert_pages_own_a_line();
    mus_pattern_destroy(shirt);
    mus_tape_destroy(tape);
}
END_TEST


START_TEST(runs_of_sides_change_no_answer)
{
    make(pattern);
    int32_t met = 0, all = 0;
    for (int32_t i = 0; i < sheet->npiece; i++) {
        const mus__piece *piece = &sheet->pieces[i];
        const int32_t n = mus__piece_runs(piece, NULL);
        double *runs = malloc(4 * (size_t)n * sizeof *runs);
        ck_assert_ptr_nonnull(runs);
        ck_assert_int_eq(mus__piece_runs(piece, runs), n);
        for (int32_t k = 0; k < 400; k++, all++) {
            const double x = piece->box[0] + (piece->box[2] - piece->box[0]) * (k % 20 - 1) / 18.0;
            const double y = piece->box[1] + (piece->box[3] - piece->box[1]) * (double)(k / 20 - 1) / 18.0;
            const double wide = 0.001 * (1 + k % 7), box[4] = {x, y, x + wide, y + wide};
            double at[2] = {HUGE_VAL, HUGE_VAL};
            const bool meets = mus__piece_meets(piece, NULL, box, at);
            for (int32_t d = 0; d < 2 && meets; d++) ck_assert(at[d] >= box[d] - 1e-12 && at[d] <= box[2 + d] + 1e-12);
            ck_assert(mus__piece_meets(piece, runs, box, NULL) == meets);
            met += meets;
        }
        free(runs);
    }
    ck_assert_int_gt(met, all / 4);
    ck_assert_int_lt(met, all);
}
END_TEST


START_TEST(one_page_has_no_cover_and_its_own_squares)
{
    def.paper = MUS_PAPER_ROLL;
    make(pattern);
    ck_assert(!sheet->tiled);
    ck_assert_int_eq(mus_sheet_page_count(sheet), 1);
    double page[4];
    ck_assert_int_eq(mus_sheet_page(sheet, 0, page), MUS_OK);
    ck_assert_double_eq_tol(page[2], 0.914, 1e-4);
    ck_assert_double_lt(page[3], 5.08);
    const double *at = sheet->squares, box[4] = {at[0], at[1], at[0] + MUS__SQUARES, at[1] + MUS__SQUARES};
    for (int32_t i = 0; i < sheet->npiece; i++) ck_assert(!mus__piece_meets(&sheet->pieces[i], NULL, box, NULL));
    ck_assert(shown(box[0], box[1]) && shown(box[2], box[3]));
}
END_TEST


START_TEST(long_rolls_stay_below_the_limit_of_pdf)
{
    /* a train of 7 m and 0.8 m wide: two pages of the roll */
    const double xy[] = {0, 0, 0.8, 0, 0.8, 7, 0, 7};
    mus_pattern *train = sample_polygon(context, 4, xy);
    def.paper = MUS_PAPER_ROLL;
    make(train);
    ck_assert_int_eq(sheet->rows, 2);
    ck_assert_double_lt(sheet->page[1], 14400.0 * 0.0254 / 72.0);
    assert_all_shown();
    mus_pattern_destroy(train);
}
END_TEST


START_TEST(papers_are_whole_points)
{
    static const double millimetres[][2] = {{210, 297}, {215.9, 279.4}, {297, 420}, {841, 1189}};
    for (int32_t paper = 0; paper < 4; paper++) {
        double size[2];
        mus__paper_size(paper, size);
        for (int32_t k = 0; k < 2; k++) {
            double points = size[k] * 72.0 / 0.0254;
            ck_assert_double_eq_tol(points, round(points), 1e-9);
            ck_assert_double_eq_tol(1e3 * size[k], millimetres[paper][k], 0.2);
        }
    }
}
END_TEST


START_TEST(tiles_are_named_like_a_chess_board)
{
    char name[16];
    mus__tile_name(&(mus__tile){0, 0}, name, sizeof name);
    ck_assert_str_eq(name, "A1");
    mus__tile_name(&(mus__tile){11, 25}, name, sizeof name);
    ck_assert_str_eq(name, "Z12");
    mus__tile_name(&(mus__tile){0, 26}, name, sizeof name);
    ck_assert_str_eq(name, "AA1");
    mus__tile_name(&(mus__tile){2, 26 * 27}, name, sizeof name);
    ck_assert_str_eq(name, "AAA3");
}
END_TEST


Suite *mus_suite_sheet_layout(void);
Suite *mus_suite_sheet_layout(void)
{
    Suite *suite = suite_create("sheet_layout");
    TCase *test = tcase_create("tile");
    tcase_add_checked_fixture(test, setup, teardown);
    tcase_set_timeout(test, 60);
    tcase_add_test(test, pages_show_every_cut_line_on_each_paper);
    tcase_add_test(test, neighbours_overlap_by_what_was_asked);
    tcase_add_test(test, half_diamonds_meet_the_whole_ones_of_the_neighbour);
    tcase_add_test(test, frame_on_frame_two_half_diamonds_make_a_whole);
    tcase_add_test(test, title_and_squares_lie_on_a_free_place_of_the_first_page);
    tcase_add_test(test, ten_pages_have_a_cover_of_their_own);
    tcase_add_test(test, pages_without_cloth_are_left_out);
    tcase_add_test(test, a_page_without_a_line_of_its_own_is_left_out);
    tcase_add_test(test, the_head_of_an_arrow_alone_needs_no_page);
    tcase_add_test(test, runs_of_sides_change_no_answer);
    tcase_add_test(test, one_page_has_no_cover_and_its_own_squares);
    tcase_add_test(test, long_rolls_stay_below_the_limit_of_pdf);
    tcase_add_test(test, papers_are_whole_points);
    tcase_add_test(test, title_and_squares_lie_in_a_piece_that_leaves_no_other_place);
    tcase_add_test(test, tiles_are_named_like_a_chess_board);
    suite_add_tcase(suite, test);
    return suite;
}
