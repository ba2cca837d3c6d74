/*
 * test_shaping.c: shapes, necklines and closures of a top, on the half garment: darts, waist lengths, openings.
 *
 * Figures computed by hand: a bust dart rotated into the waist, the T-shirt, waist lines that meet.
 */
#include <stdio.h>

#include "board/board_notch.h"
#include "closure/closure.h"
#include "geom/vec.h"
#include "style/halves.h"

#define LENGTH_SAME 1e-9
#define JERSEY 1.15


/* Drafts a half from words; half_end() frees it and its tape. */
static mus_tape *half_make(mus_context *context, const char *size, const char *words, mus__half *half)
{
    mus__style style;
    mus_tape *tape = drafts_tape(context, size);
    const mus_status status = mus__style_read(context, words, &style);
    ck_assert_msg(status == MUS_OK, "%s: %s", words, mus_context_error(context));
    halves_begin(context, tape, &style, half);
    mus__top_draft(half);
    return tape;
}


static void half_end(mus__half *half, mus_tape *tape)
{
    mus__board_free(&half->board);
    mus_tape_destroy(tape);
}


static void half_good(mus_context *context, const mus__half *half, const char *words)
{
    ck_assert_msg(half->board.status == MUS_OK, "%s: %s", words, mus_context_error(context));
}


static int32_t side_of(const mus__half *half, const char *panel, const char *name)
{
    const int32_t side = mus__board_find(&half->board, mus__board_find_panel(&half->board, panel), name);
    ck_assert_msg(side != MUS_NONE, "no side %s of panel %s", name, panel);
    return side;
}


static double boundary_length(const mus__half *half, const char *panels, const char *label)
{
    int32_t sides[64];
    double length = 0.0;
    const int32_t n = mus__half_boundary(half, panels, label, sides, 64);
    ck_assert_int_le(n, 64);
    for (int32_t i = 0; i < n; i++) length += half->board.side[sides[i]].length;
    return length;
}


/* W40: the side dart of 12 degrees turned into the waist dart is one of 20.373 degrees with a mouth of 7.086 cm */
START_TEST(the_waist_takes_the_bust_dart)
{
    mus_context *context = support_context();
    mus__half half;
    mus_tape *tape = half_make(context, "W40", "dress shape=waist sleeve=short closure=back", &half);
    half_good(context, &half, "shape=waist");
    const double *a = mus__board_start(&half.board, side_of(&half, "front", "wd1"));
    const double *b = mus__board_end(&half.board, side_of(&half, "front", "wd2"));
    ck_assert_double_eq_tol(mus__dist2(a, b) / CM, 7.086, 0.011);
    const double middle[2] = {0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])};
    const double angle = 2.0 * atan(0.5 * mus__dist2(a, b) / mus__dist2(middle, half.bodice.front.bust));
    ck_assert_double_eq_tol(angle / MUS__DEGREE, 20.373, 0.02);
    half_end(&half, tape);
    support_context_end(context);
}
END_TEST


/* the waist of a dress is the waist girth plus its ease for every shape; that of a French dart, smoothed, slightly less
 */
START_TEST(waists_have_their_ease_in_every_shape)
{
    static const char *const sizes[] = {"W34", "W40", "W52"};
    mus_context *context = support_context();
    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++)
        for (int32_t shape = 0; shape < MUS__SHAPE_BOXY; shape++) {
            char words[96];
            mus__half half;
            snprintf(words, sizeof words, "dress closure=back shape=%s", mus__style_word(MUS__AXIS_SHAPE, shape));
            mus_tape *tape = half_make(context, sizes[i], words, &half);
            half_good(context, &half, words);
            const double waist = 2.0 * boundary_length(&half, "", "waist");
            const double want = half.measures.v[MUS_MEASURE_WAIST] + 4.0 * CM;
            const double tolerance = shape == MUS__SHAPE_FRENCH ? 0.2 * CM : LENGTH_SAME;
            ck_assert_msg(fabs(waist - want) <= tolerance, "%s: %s: waist %.3f cm, expected %.3f", sizes[i], words,
                          waist / CM, want / CM);
            ck_assert_double_eq_tol(half.waist_ease, waist - half.measures.v[MUS_MEASURE_WAIST], LENGTH_SAME);

            /* front and back meet at the side: the front is the wider by the balance */
            const double more = boundary_length(&half, "front", "waist") - boundary_length(&half, "back", "waist");
            ck_assert_double_eq_tol(more, 1.0 * CM, tolerance + LENGTH_SAME);
            half_end(&half, tape);
        }
    support_context_end(context);
}
END_TEST


/* a princess seam has no corner on either panel, and its ease is below 1.2 cm */
START_TEST(princess_seams_are_fair)
{
    static const char *const shapes[] = {"princess_shoulder", "princess_armhole"};
    static const char *const sizes[] = {"W34", "W40", "W52", "M50", "C116"};
    mus_context *context = support_context();
    for (size_t i = 0; i < 10; i++) {
        char words[96];
        mus__half half;
        snprintf(words, sizeof words, "dress closure=back shape=%s", shapes[i % 2]);
        mus_tape *tape = half_make(context, sizes[i / 2], words, &half);
        half_good(context, &half, words);
        static const char *const panels[] = {"front", "front_side", "back", "back_side"};
        for (int p = 0; p < 4; p++) {
            const int32_t side = side_of(&half, panels[p], "princess");
            const mus__board_chain *chain = &half.board.side[side].chain;
            ck_assert_int_eq(chain->npiece, 2);
            const double *q = chain->xy;
            const double u[2] = {q[6] - q[4], q[7] - q[5]}, v[2] = {q[8] - q[6], q[9] - q[7]};
            ck_assert_double_ge((u[0] * v[0] + u[1] * v[1]) / (hypot(u[0], u[1]) * hypot(v[0], v[1])), 1.0 - 1e-12);
            const mus__board_seam *seam = &half.board.seam[mus__board_seam_of(&half.board, side)];
            ck_assert_double_le(fabs(seam->ease), 1.2 * CM);
        }
        half_end(&half, tape);
    }
    support_context_end(context);
}
END_TEST


/* the head passes every neckline of a top without a closure */
START_TEST(heads_pass_what_does_not_open)
{
    static const char *const sizes[] = {"W34", "W52", "M50", "C56", "C116"};
    static const char *const necks[] = {"jewel", "scoop", "v", "deep_v", "square", "boat", "sweetheart"};
    mus_context *context = support_context();
    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++)
        for (size_t n = 0; n < 2 * sizeof necks / sizeof necks[0]; n++) {
            char words[96];
            mus__half half;
            snprintf(words, sizeof words, "top shape=boxy closure=none neck=%s cloth=%s", necks[n / 2],
                     n % 2 == 0 ? "woven" : "knit");
            mus_tape *tape = half_make(context, sizes[i], words, &half);
            half_good(context, &half, words);
            const double neck = 2.0 * boundary_length(&half, "", "neck") * (n % 2 == 0 ? 1.0 : JERSEY);
            ck_assert_msg(neck >= half.measures.v[MUS_MEASURE_HEAD] + 2.0 * CM - 1e-9, "%s: %s: neck %.1f cm", sizes[i],
                          words, neck / CM);
            ck_assert_double_gt(half.board.side[side_of(&half, "front", "sh")].length, 1.5 * CM);
            half_end(&half, tape);
        }
    support_context_end(context);
}
END_TEST


START_TEST(shapes_leave_out_darts_that_the_block_lacks)
{
    static const char *const shapes[] = {"waist", "shoulder_waist", "french", "neck_gathers", "cf_gathers"};
    mus_context *context = support_context();
    for (size_t i = 0; i < sizeof shapes / sizeof shapes[0]; i++) {
        char words[96];
        mus__half half;
        snprintf(words, sizeof words, "top closure=back shape=%s", shapes[i]);
        mus_tape *tape = half_make(context, "M50", words, &half);
        half_good(context, &half, words);
        ck_assert_int_eq(mus__board_find(&half.board, 0, "bd1"), MUS_NONE);
        half_end(&half, tape);
    }
    support_context_end(context);
}
END_TEST


/* a side zip has four notches, all on the left; buttons are on the centre line at equal distances, at most 8.5 cm */
START_TEST(closures_are_marked)
{
    mus_context *context = support_context();
    mus__half half;
    mus_tape *tape = half_make(context, "W40", "top closure=side neck=scoop", &half);
    mus__board_double(&half.board);
    mus__closure_finish(&half);
    mus__board_match_notches(&half.board);
    half_good(context, &half, "closure=side");
    int32_t triple = 0;
    for (int32_t i = 0; i < half.board.nnotch; i++) {
        const mus__board_notch *notch = &half.board.notch[i];
        if (notch->side == MUS_NONE || notch->kind != MUS_NOTCH_TRIPLE) continue;
        double at[2];
        mus__board_at(&half.board, notch->side, notch->s, at, NULL);
        const bool front = strncmp(half.board.panel[half.board.side[notch->side].panel].name, "front", 5) == 0;
        ck_assert(front ? at[0] > 0.0 : at[0] < 0.0);
        triple++;
    }
    ck_assert_int_eq(triple, 4);
    half_end(&half, tape);

    tape = half_make(context, "W40", "top closure=front", &half);
    half_good(context, &half, "closure=front");
    double last = NAN;
    int32_t buttons = 0;
    for (int32_t i = 0; i < half.board.nmark; i++) {
        const mus__board_mark *mark = &half.board.mark[i];
        if (mark->panel == MUS_NONE || strcmp(mark->name, "button") != 0) continue;
        ck_assert_double_eq_tol(mark->xy[0], 0.0, 1e-12);
        if (buttons++ > 0) ck_assert_double_le(last - mark->xy[1], 8.5 * CM + 1e-9);
        last = mark->xy[1];
    }
    ck_assert_int_ge(buttons, 6);
    ck_assert_int_eq(half.board.side[side_of(&half, "front", "cf")].centre, MUS__CENTRE_SEAM);
    ck_assert_int_eq(half.board.side[side_of(&half, "back", "cb")].centre, MUS__CENTRE_FOLD);
    half_end(&half, tape);
    support_context_end(context);
}
END_TEST


/* an allocation that fails gives an error and leaves no memory allocated */
START_TEST(failing_allocations_are_told)
{
    static const char *const words[] = {"dress closure=back shape=french neck=v", "top closure=back shape=neck_gathers",
                                        "top closure=back shape=princess_armhole neck=halter",
                                        "dress closure=back shape=empire", "top closure=front yoke=yoke"};
    for (int64_t n = 0;; n++) {
        mus_context *context = support_context();
        mus__half half;
        mus_pattern *pattern = NULL;
        mus__style style;
        ck_assert_int_eq(mus__style_read(context, words[_i], &style), MUS_OK);
        mus_tape *tape = drafts_tape(context, "W40");
        halves_begin(context, tape, &style, &half);
        support_fail_after(n, false);
        mus__top_draft(&half);
        mus__neck_band_attach(&half);
        mus__board_double(&half.board);
        mus__closure_finish(&half);
        mus__board_write(&half.board, &pattern);
        support_fail_never();
        const mus_status status = half.board.status;
        mus_pattern_destroy(pattern);
        half_end(&half, tape);
        support_context_end(context);
        if (status == MUS_OK) break;
        ck_assert_int_eq(status, MUS_ERR_MEMORY);
    }
}
END_TEST


Suite *mus_suite_shaping(void);

Suite *mus_suite_shaping(void)
{
    Suite *suite = suite_create("shaping");
    TCase *tc = tcase_create("shaping");
    tcase_set_timeout(tc, 120);
    tcase_add_test(tc, the_waist_takes_the_bust_dart);
    tcase_add_test(tc, waists_have_their_ease_in_every_shape);
    tcase_add_test(tc, princess_seams_are_fair);
    tcase_add_test(tc, heads_pass_what_does_not_open);
    tcase_add_test(tc, shapes_leave_out_darts_that_the_block_lacks);
    tcase_add_test(tc, closures_are_marked);
    tcase_add_loop_test(tc, failing_allocations_are_told, 0, 5);
    suite_add_tcase(suite, tc);
    return suite;
}
