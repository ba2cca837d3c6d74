/*
 * test_bodice.c: the body of a top from words: every neckline with every length and closure in the sizes of a small, a
 * middle and a large woman, a man and a child: drafted, doubled, without fault, with the openings that are meant.
 */
#include "closure/closure.h"
#include "muslin/topology.h"
#include "study/people/ansur.h"
#include "style/halves.h"

static const char *const sizes[] = {"W34", "W40", "W52", "M50", "C116"};

#define SIZES ((int)(sizeof sizes / sizeof sizes[0]))
#define SEAM_MATCH (0.05 * CM) /* of plain seams */


/* eases [cm] of the seams that are meant to have one, by the name of either side; elsewhere none */
static const struct {
    const char *name;
    double most;
} eases[] = {{"princess", 1.2}, {"strip", 6.0}, {"low", 12.0}, {"empire", 4.0}, {"yoke", 4.1}};


static bool eased(const mus_pattern *pattern, const mus_seam_def *seam)
{
    const char *names[2] = {mus_pattern_edge_name(pattern, seam->edge_a), mus_pattern_edge_name(pattern, seam->edge_b)};
    for (size_t i = 0; i < sizeof eases / sizeof eases[0]; i++)
        for (int j = 0; j < 2; j++) {
            if (strncmp(names[j], eases[i].name, strlen(eases[i].name)) != 0) continue;
            return fabs(seam->ease) <= eases[i].most * CM;
        }
    return fabs(seam->ease) <= SEAM_MATCH;
}


/* one style on one tape: drafted, doubled, without a fault */
static void check_whole(mus_context *context, const char *who, const mus_tape *tape, const mus__style *style)
{
    char words[256];
    mus__half half;
    mus_pattern *pattern = NULL;
    int32_t faults = 0;
    const char *text = "";
    mus_faults *found;
    mus__style_spell(style, words, sizeof words);
    halves_begin(context, tape, style, &half);
    mus__top_draft(&half);
    mus__neck_band_attach(&half);
    halves_openings(&half);
    mus__board_double(&half.board);
    mus__closure_finish(&half);
    mus__board_write(&half.board, &pattern);
    ck_assert_msg(half.board.status == MUS_OK, "%s: %s: %s", who, words, mus_context_error(context));
    ck_assert_int_eq(mus_pattern_check(pattern, &faults, &found), MUS_OK);
    if (faults > 0) text = mus_faults_text(found, 0);
    ck_assert_msg(faults == 0, "%s: %s: %s", who, words, text);
    mus_faults_destroy(found);

    /* one piece with an outside, without a handle: characteristic 2 less the openings */
    mus_topology topology;
    mus_topology_init(&topology, sizeof topology);
    ck_assert_int_eq(mus_pattern_topology(pattern, &topology), MUS_OK);
    ck_assert_int_eq(topology.components, 1);
    ck_assert_int_eq(topology.loops, mus_pattern_opening_count(pattern));
    ck_assert_int_eq(topology.euler, 2 - topology.loops);

    /* a plain top has plain seams: nothing is eased away */
    for (int32_t s = 0; s < mus_pattern_seam_count(pattern); s++) {
        mus_seam_def seam;
        mus_seam_def_init(&seam, sizeof seam);
        ck_assert_int_eq(mus_pattern_seam(pattern, s, &seam), MUS_OK);
        ck_assert_msg(eased(pattern, &seam), "%s: %s: seam of %s has an ease of %.2f cm", who, words,
                      mus_pattern_edge_name(pattern, seam.edge_a), seam.ease / CM);
    }
    mus_pattern_destroy(pattern);
    mus__board_free(&half.board);
}


/* one style on one size; false when its words exclude one another */
static bool check_style(const char *size, const mus__style *style)
{
    mus_context *context = support_context();
    const bool allowed = mus__style_check(context, style) == MUS_OK;
    if (allowed) {
        mus_tape *tape = drafts_tape(context, size);
        check_whole(context, size, tape, style);
        mus_tape_destroy(tape);
    }
    support_context_end(context);
    return allowed;
}


START_TEST(every_neckline_drafts_in_every_length_and_closure)
{
    int checked = 0;
    for (int32_t neck = 0; neck <= MUS__NECK_STRAPLESS; neck++)
        for (int32_t closure = 0; closure <= MUS__CLOSURE_SIDE; closure++)
            for (int32_t length = 0; length <= MUS__TOP_LENGTH_TUNIC; length++)
                for (int32_t shape = 0; shape <= MUS__SHAPE_BOXY; shape++) {
                    mus__style style = {{0}};
                    style.option[MUS__AXIS_NECK] = neck;
                    style.option[MUS__AXIS_CLOSURE] = closure;
                    style.option[MUS__AXIS_TOP_LENGTH] = length;
                    style.option[MUS__AXIS_SHAPE] = shape;
                    const bool moves = shape != MUS__SHAPE_SIDE_WAIST && shape != MUS__SHAPE_EMPIRE &&
                                       shape != MUS__SHAPE_BOXY && shape != MUS__SHAPE_PRINCESS_SHOULDER &&
                                       shape != MUS__SHAPE_PRINCESS_ARMHOLE;
                    if (moves && sizes[_i][0] != 'W') continue;
                    style.option[MUS__AXIS_CLOTH] = closure == MUS__CLOSURE_NONE;
                    checked += check_style(sizes[_i], &style);
                }
    ck_assert_int_gt(checked, 200);
}
END_TEST


/* yokes, dresses and jumpsuits over the same necks and shapes */
START_TEST(yokes_and_dresses_draft_too)
{
    int checked = 0;
    for (int32_t neck = 0; neck <= MUS__NECK_STRAPLESS; neck++)
        for (int32_t shape = 0; shape <= MUS__SHAPE_BOXY; shape++)
            for (int32_t bits = 0; bits < 6; bits++) {
                mus__style style = {{0}};
                const bool darted = shape > MUS__SHAPE_SIDE_WAIST && shape < MUS__SHAPE_PRINCESS_SHOULDER;
                const bool gathers = shape == MUS__SHAPE_NECK_GATHERS || shape == MUS__SHAPE_CF_GATHERS;
                if ((darted || gathers) && sizes[_i][0] != 'W') continue;
                style.option[MUS__AXIS_NECK] = neck;
                style.option[MUS__AXIS_SHAPE] = shape;
                style.option[MUS__AXIS_CLOSURE] = bits % 2 == 0 ? MUS__CLOSURE_FRONT : MUS__CLOSURE_BACK;
                if (bits / 2 == 0) style.option[MUS__AXIS_YOKE] = MUS__YOKE_YOKE;
                if (bits / 2 == 1) style.option[MUS__AXIS_GARMENT] = MUS__GARMENT_DRESS;
                if (bits / 2 == 2) style.option[MUS__AXIS_GARMENT] = MUS__GARMENT_JUMPSUIT;
                checked += check_style(sizes[_i], &style);
            }
    ck_assert_int_gt(checked, 100);
}
END_TEST


/* real people: every 150th woman and man of the survey */
START_TEST(people_of_the_survey_have_tops)
{
    static const char *const words[] = {
        "top closure=back",
        "top shape=boxy cloth=knit neck=v",
        "top shape=boxy neck=boat top_length=tunic",
        "top closure=front yoke=yoke",
        "dress closure=back shape=princess_shoulder neck=square",
        "dress closure=side shape=princess_armhole neck=sweetheart",
        "top closure=back neck=halter shape=empire",
        "dress closure=back neck=strapless",
        "top closure=back neck=deep_v shape=waist",
        "top closure=back shape=neck_gathers top_length=crop",
        "dress closure=front shape=french neck=scoop",
        "top closure=back shape=cf_gathers",
    };
    char path[512];
    ansur table;
    if (support_data("anthropometry/ansur2_garment_cm.csv", path, sizeof path) == NULL) return;
    ck_assert(ansur_open(&table, path));
    mus_context *context = support_context();
    int32_t drafted = 0;
    for (int row = 0; row < table.rows; row += 150) {
        mus_tape *tape = ansur_tape(context, &table, row);
        if (tape == NULL || mus_tape_complete(tape) != MUS_OK) continue;
        for (size_t w = 0; w < sizeof words / sizeof words[0]; w++) {
            mus__style style;
            ck_assert_int_eq(mus__style_read(context, words[w], &style), MUS_OK);
            const int32_t shape = style.option[MUS__AXIS_SHAPE];
            const bool moves = shape == MUS__SHAPE_WAIST || shape == MUS__SHAPE_FRENCH ||
                               shape == MUS__SHAPE_NECK_GATHERS || shape == MUS__SHAPE_CF_GATHERS;
            if (moves && ansur_male(&table, row)) continue;
            check_whole(context, ansur_name(&table, row), tape, &style);
            drafted++;
        }
        mus_tape_destroy(tape);
    }
    ck_assert_int_gt(drafted, 150);
    support_context_end(context);
    ansur_close(&table);
}
END_TEST


START_TEST(a_rim_runs_over_darts_and_seams)
{
    mus_context *context = support_context();
    mus__style style;
    mus__half half;
    ck_assert_int_eq(mus__style_read(context, "dress closure=back", &style), MUS_OK);
    mus_tape *tape = drafts_tape(context, "W40");
    halves_begin(context, tape, &style, &half);
    mus__top_draft(&half);
    ck_assert_int_eq(half.board.status, MUS_OK);
    const mus__board *board = &half.board;

    /* the waist: from the centre front to the centre back, its darts closed W + 4 */
    int32_t sides[16];
    const int32_t n = mus__half_boundary(&half, "", "waist", sides, 16);
    double length = 0.0;
    ck_assert_int_eq(n, 4);
    for (int32_t i = 0; i < n; i++) length += board->side[sides[i]].length;
    ck_assert_double_eq_tol(2.0 * length, half.measures.v[MUS_MEASURE_WAIST] + 4.0 * CM, 1e-9);
    ck_assert_double_eq_tol(2.0 * length, half.measures.v[MUS_MEASURE_WAIST] + half.waist_ease, 1e-9);
    ck_assert_double_eq_tol(mus__board_start(board, sides[0])[0], 0.0, 1e-12);
    ck_assert_double_eq_tol(mus__board_end(board, sides[3])[0], 0.0, 1e-12);
    ck_assert_str_eq(board->panel[board->side[sides[0]].panel].name, "front");

    /* front alone; the armhole is a ring from the underarm of the front; room is kept */
    ck_assert_int_eq(mus__half_boundary(&half, "front", "waist", sides, 16), 2);
    ck_assert_int_eq(mus__half_boundary(&half, "", "armhole", sides, 1), 2);
    ck_assert_str_eq(board->panel[board->side[sides[0]].panel].name, "front");
    ck_assert_int_eq(mus__half_boundary(&half, "", "side", sides, 16), 0);
    ck_assert_int_eq(mus__half_boundary(&half, "", "neck", sides, 16), 2);
    ck_assert_str_eq(board->panel[board->side[sides[0]].panel].name, "back");
    mus__board_free(&half.board);
    mus_tape_destroy(tape);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_bodice(void);

Suite *mus_suite_bodice(void)
{
    Suite *suite = suite_create("bodice");
    TCase *tc = tcase_create("top");
    tcase_set_timeout(tc, 120);
    tcase_add_loop_test(tc, every_neckline_drafts_in_every_length_and_closure, 0, SIZES);
    tcase_add_loop_test(tc, yokes_and_dresses_draft_too, 0, SIZES);
    tcase_add_test(tc, people_of_the_survey_have_tops);
    tcase_add_test(tc, a_rim_runs_over_darts_and_seams);
    suite_add_tcase(suite, tc);
    return suite;
}
