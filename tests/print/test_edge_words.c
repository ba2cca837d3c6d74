/*
 * test_edge_words.c: the words at the edges of a piece: where they stand, and which edges have none.
 */
#include <math.h>
#include <string.h>

#include "drawing/lettering.h"
#include "print/page.h"
#include "print/sample_patterns.h"
#include "support.h"

static mus_context *context;
static mus_pattern *pattern;
static mus_sheet *sheet;


static void setup(void)
{
    context = support_context();
    pattern = NULL;
    sheet = NULL;
}


static void teardown(void)
{
    mus_sheet_destroy(sheet);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}


/* number of texts of a drawing that are the word, and the last of them */
static int32_t find(const char *word, const mus__text **out)
{
    const mus__drawing *drawing = &sheet->drawing;
    int32_t n = 0;
    for (int32_t i = 0; i < drawing->ntext; i++) {
        const mus__text *text = &drawing->texts[i];
        if ((size_t)text->n != strlen(word) || memcmp(drawing->letters + text->at, word, strlen(word)) != 0) continue;
        if (out != NULL) *out = text;
        n++;
    }
    return n;
}


/* both ends of the base line of a text */
static void ends(const mus__text *text, const char *word, double *a, double *b)
{
    const double width = text->height * mus__lettering_width(sheet->lettering, word, false);
    a[0] = text->x, a[1] = text->y;
    b[0] = text->x + width * text->cosine, b[1] = text->y + width * text->sine;
}


/* distance [m] of a point from a side of a piece */
static double away(const mus__piece *piece, int32_t side, const double *p)
{
    double best = HUGE_VAL;
    for (int32_t i = 0; i < piece->nflat; i++) {
        if (piece->flat_side[i] != side) continue;
        const double *a = piece->flat + 2 * i, *b = piece->flat + 2 * ((i + 1) % piece->nflat);
        const double dx = b[0] - a[0], dy = b[1] - a[1];
        double t = ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / (dx * dx + dy * dy);
        t = fmax(0.0, fmin(1.0, t));
        best = fmin(best, hypot(p[0] - a[0] - t * dx, p[1] - a[1] - t * dy));
    }
    return best;
}


static void make(int32_t fold, const char *language)
{
    mus_sheet_def def;
    mus_sheet_def_init(&def, sizeof def);
    def.fold = fold;
    def.language = language;
    mus_sheet_destroy(sheet);
    ck_assert_int_eq(mus_sheet_create(context, pattern, &def, &sheet), MUS_OK);
}


/* a rectangle of 30 x 20 cm with words at its lower, right, upper and left edge; NULL: none */
static void rectangle(const char *low, const char *right, const char *up, const char *left)
{
    const double xy[] = {0, 0, 0.3, 0, 0.3, 0.2, 0, 0.2};
    const char *const words[] = {low, right, up, left};
    mus_pattern_destroy(pattern);
    pattern = sample_polygon(context, 4, xy);
    for (int32_t i = 0; i < 4; i++)
        if (words[i] != NULL) ck_assert_int_eq(mus_pattern_set_edge_label(pattern, i, words[i]), MUS_OK);
}


/* hem, both armholes and neck of front and back, of the sleeve its hem; sides and shoulders have no names */
START_TEST(words_run_along_their_edges_inside_the_sew_line)
{
    static const char *const words[] = {"hem", "neck", "armhole"};
    static const int32_t counts[] = {3, 2, 4}, sides[] = {0, 4, 2};
    pattern = sample_shirt(context);
    make(0, NULL);
    ck_assert_int_eq(find("edge", NULL), 0);
    for (int32_t w = 0; w < 3; w++) ck_assert_int_eq(find(words[w], NULL), counts[w]);
    for (int32_t w = 0, seen = 0; w < 3; w++, seen = 0) {
        for (int32_t i = 0; i < sheet->drawing.ntext; i++) {
            const mus__text *text = &sheet->drawing.texts[i];
            double a[2], b[2];
            if ((size_t)text->n != strlen(words[w]) ||
                memcmp(sheet->drawing.letters + text->at, words[w], (size_t)text->n) != 0)
                continue;
            ends(text, words[w], a, b);
            ck_assert_double_gt(text->cosine, -0.18);
            for (int32_t k = 0; k < 2; k++) {
                const mus__piece *piece = &sheet->pieces[k];
                if (!mus__piece_inside(piece, a[0], a[1])) continue;
                const double near = fmin(away(piece, sides[w], a), w == 2 ? away(piece, 6, a) : HUGE_VAL);
                const double far = fmin(away(piece, sides[w], b), w == 2 ? away(piece, 6, b) : HUGE_VAL);
                ck_assert(mus__piece_inside(piece, b[0], b[1]));
                ck_assert_double_gt(fmin(near, far), 0.0019);
                ck_assert_double_lt(fmax(near, far), 0.0056);
                seen++;
            }
        }
        ck_assert_int_eq(seen, w == 2 ? 4 : 2);
    }
}
END_TEST


/* a word is at the middle of its edge, reads upwards at the sides, and is in the language of the sheet */
START_TEST(words_stand_at_the_middle_and_read_from_below_or_the_right)
{
    const mus__text *text;
    double a[2], b[2];
    rectangle("hem", "side", "waist", "side");
    for (int32_t k = 0; k < 2; k++) {
        make(0, k == 0 ? NULL : "de");
        const mus__piece *piece = &sheet->pieces[0];
        const char *const hem = k == 0 ? "hem" : "Saum", *side = k == 0 ? "side" : "Seitennaht";
        ck_assert_int_eq(find(hem, &text), 1);
        ends(text, hem, a, b);
        ck_assert_double_eq_tol(0.5 * (a[0] + b[0]), 0.5 * (piece->box[0] + piece->box[2]), 1e-6);
        ck_assert_double_eq_tol(text->cosine, 1.0, 1e-12);
        ck_assert_int_eq(find(side, &text), 2);
        ck_assert_double_eq_tol(text->sine, 1.0, 1e-12);
    }
}
END_TEST


/* edges without a name, one too short for its word, one too curved, the legs of a dart */
START_TEST(edges_without_a_name_or_a_place_have_no_word)
{
    const double dart[] = {0, 0, 0.13, 0, 0.15, 0.1, 0.17, 0, 0.3, 0, 0.3, 0.2, 0, 0.2};
    int32_t panel, first;
    rectangle(NULL, NULL, NULL, NULL);
    make(0, NULL);
    for (int32_t i = 0; i < sheet->drawing.npath; i++) ck_assert(sheet->drawing.paths[i].layer != MUS__LAYER_MARKS);

    mus_pattern_destroy(pattern);
    ck_assert_int_eq(mus_pattern_create(context, "patch", &pattern), MUS_OK);
    const sample_step patch[] = {{0, 0, MUS_PIECE_LINE, {0}, "armhole", NAN},
                                 {0.014, 0, MUS_PIECE_LINE, {0}, NULL, NAN},
                                 {0.014, 0.1, MUS_PIECE_ARC, {0.007, 0.107}, "shoulder", NAN},
                                 {0, 0.1, MUS_PIECE_LINE, {0}, "side", NAN}};
    ck_assert(sample_add_piece(pattern, "patch", 4, patch, &panel, &first));
    make(0, NULL);
    ck_assert_int_eq(find("armhole", NULL), 0);
    ck_assert_int_eq(find("shoulder", NULL), 0);
    ck_assert_int_eq(find("side", NULL), 1);

    mus_pattern_destroy(pattern);
    pattern = sample_polygon(context, 7, dart);
    for (int32_t i = 0; i < 4; i++) ck_assert_int_eq(mus_pattern_set_edge_label(pattern, i, "waist"), MUS_OK);
    mus_seam_def def;
    mus_seam_def_init(&def, sizeof def);
    def.edge_a = 1, def.edge_b = 2, def.direction = MUS_SEAM_REVERSED;
    ck_assert_int_eq(mus_pattern_add_seam(pattern, &def, NULL), MUS_OK);
    make(0, NULL);
    ck_assert_int_eq(find("waist", NULL), 2);
}
END_TEST


/* edges of one word that go on straight have it once, at their middle; round a corner each has its own */
START_TEST(edges_of_one_word_have_it_once)
{
    const double xy[] = {0, 0, 0.1, 0, 0.2, 0, 0.3, 0, 0.3, 0.2, 0, 0.2};
    const mus__text *text;
    double a[2], b[2];
    pattern = sample_polygon(context, 6, xy);
    for (int32_t i = 0; i < 4; i++) ck_assert_int_eq(mus_pattern_set_edge_label(pattern, i, "band"), MUS_OK);
    make(0, NULL);
    ck_assert_int_eq(find("band", NULL), 2);
    mus_pattern_destroy(pattern);
    pattern = sample_polygon(context, 6, xy);
    for (int32_t i = 0; i < 3; i++) ck_assert_int_eq(mus_pattern_set_edge_label(pattern, i, "band"), MUS_OK);
    make(0, NULL);
    ck_assert_int_eq(find("band", &text), 1);
    ends(text, "band", a, b);
    ck_assert_double_eq_tol(0.5 * (a[0] + b[0]), 0.5 * (sheet->pieces[0].box[0] + sheet->pieces[0].box[2]), 1e-6);
}
END_TEST


/* of a half the words of its edges, and none on its fold; of several sizes one */
START_TEST(halves_and_sizes_have_a_word_once)
{
    static const char *const sizes[] = {"S", "M"};
    rectangle("hem", "side", "waist", "side");
    make(1, NULL);
    ck_assert(sheet->pieces[0].fold);
    ck_assert_int_eq(find("side", NULL), 1);
    ck_assert_int_eq(find("hem", NULL), 1);
    ck_assert_int_eq(find("waist", NULL), 1);
    const mus_pattern *const patterns[2] = {pattern, pattern};
    mus_sheet_destroy(sheet);
    ck_assert_int_eq(mus_sheet_create_sizes(context, 2, patterns, sizes, NULL, &sheet), MUS_OK);
    ck_assert_int_eq(find("side", NULL), 2);
    ck_assert_int_eq(find("hem", NULL), 1);
}
END_TEST


/* lines across and beside the middle of an edge: its word moves along the edge until none passes through it */
START_TEST(a_word_keeps_clear_of_lines_and_other_words)
{
    const double across[4] = {0.15, -0.005, 0.15, 0.03}, beside[4] = {0.1, 0.003, 0.2, 0.003};
    rectangle("hem", NULL, NULL, NULL);
    ck_assert_int_eq(mus_pattern_add_mark(pattern, 0, "a", 2, across, NULL), MUS_OK);
    ck_assert_int_eq(mus_pattern_add_mark(pattern, 0, "beside", 2, beside, NULL), MUS_OK);
    make(0, NULL);
    ck_assert_int_eq(find("hem", NULL), 1);
    const mus__drawing *drawing = &sheet->drawing;
    const mus__path *word = NULL;
    for (int32_t i = 0; i < drawing->npath; i++)
        if (drawing->paths[i].layer == MUS__LAYER_MARKS && drawing->paths[i].pen == MUS__PEN_TEXT)
            word = &drawing->paths[i];
    ck_assert_ptr_nonnull(word);
    for (int32_t i = 0; i < drawing->npath; i++) {
        const mus__path *path = &drawing->paths[i];
        if (path == word || path->piece == MUS_NONE) continue;
        ck_assert(!mus__path_meets(drawing, path, NULL, word->box));
    }
    double middle[2];
    mus__piece_point(&sheet->pieces[0], (const double[2]){0.15, 0.0}, middle);
    ck_assert_double_gt(fabs(0.5 * (word->box[0] + word->box[2]) - middle[0]), 0.05);
    ck_assert_double_lt(fabs(0.5 * (word->box[0] + word->box[2]) - middle[0]), 0.065);
}
END_TEST


/* whatever the height of a cloth, the word at its left edge is on one page, beside the page's name and its marks */
START_TEST(words_keep_clear_of_the_names_of_pages)
{
    for (int32_t i = 0; i < 12; i++) {
        const double high = 0.25 + 0.03 * i, xy[] = {0, 0, 0.15, 0, 0.15, high, 0, high};
        const mus__text *text = NULL;
        int32_t pages = 0;
        double a[2], b[2], window[4];
        mus_pattern_destroy(pattern);
        pattern = sample_polygon(context, 4, xy);
        ck_assert_int_eq(mus_pattern_set_edge_label(pattern, 3, "side"), MUS_OK);
        make(0, NULL);
        ck_assert_int_eq(find("side", &text), 1);
        ends(text, "side", a, b);
        const double box[4] = {fmin(a[0], b[0]), fmin(a[1], b[1]), fmax(a[0], b[0]), fmax(a[1], b[1])};
        for (int32_t t = 0; t < sheet->ntile; t++) {
            mus__tile_window(sheet, &sheet->tiles[t], window);
            if (box[0] < window[0] || box[1] < window[1] || box[2] > window[2] || box[3] > window[3]) continue;
            pages++;
            ck_assert(!mus__tile_marked(window, box));
        }
        ck_assert_int_eq(pages, 1);
    }
}
END_TEST


/* a free edge whose label is that of an edge with another allowance is called by its name, as the piece's label does */
START_TEST(free_edges_are_told_apart_as_on_the_label)
{
    int32_t panel, first;
    const sample_step hood[] = {{0, 0, MUS_PIECE_LINE, {0}, "neck", NAN},
                                {0.3, 0, MUS_PIECE_LINE, {0}, NULL, NAN},
                                {0.3, 0.2, MUS_PIECE_LINE, {0}, NULL, NAN},
                                {0, 0.2, MUS_PIECE_LINE, {0}, "face", 0.025}};
    ck_assert_int_eq(mus_pattern_create(context, "hood", &pattern), MUS_OK);
    ck_assert(sample_add_piece(pattern, "hood", 4, hood, &panel, &first));
    ck_assert_int_eq(mus_pattern_set_edge_label(pattern, first + 3, "neck"), MUS_OK);
    make(0, NULL);
    ck_assert_int_eq(find("neck", NULL), 1);
    ck_assert_int_eq(find("face", NULL), 1);
}
END_TEST


Suite *mus_suite_edge_words(void);
Suite *mus_suite_edge_words(void)
{
    Suite *suite = suite_create("edge_words");
    TCase *test = tcase_create("edge_words");
    tcase_add_checked_fixture(test, setup, teardown);
    tcase_add_test(test, words_run_along_their_edges_inside_the_sew_line);
    tcase_add_test(test, words_stand_at_the_middle_and_read_from_below_or_the_right);
    tcase_add_test(test, edges_without_a_name_or_a_place_have_no_word);
    tcase_add_test(test, edges_of_one_word_have_it_once);
    tcase_add_test(test, halves_and_sizes_have_a_word_once);
    tcase_add_test(test, a_word_keeps_clear_of_lines_and_other_words);
    tcase_add_test(test, words_keep_clear_of_the_names_of_pages);
    tcase_add_test(test, free_edges_are_told_apart_as_on_the_label);
    suite_add_tcase(suite, test);
    return suite;
}
