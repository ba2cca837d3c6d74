/*
 * test_board_notch.c: a notch of one side goes to all sides that are sewn to it, at the same relative arc length and of
 * one kind; of two that lie too near each other one goes from all its sides.
 */
#include "board/board_notch.h"
#include "board/table.h"


/* a rectangle of w x 0.3 m; returns its lower side. Its upper side is the second after that */
static int32_t rectangle(mus__board *board, const char *name, double w)
{
    const double corner[5][2] = {{0.0, 0.0}, {w, 0.0}, {w, 0.3}, {0.0, 0.3}, {0.0, 0.0}};
    const int32_t panel = mus__board_panel_add(board, name, NULL);
    const int32_t low = mus__board_line_add(board, panel, "low", NULL, corner[0], corner[1]);
    for (int32_t i = 1; i < 4; i++) mus__board_line_add(board, panel, "rest", NULL, corner[i], corner[i + 1]);
    mus__board_panel_close(board, panel);
    return low;
}


/* the notch on a side at s of a kind: how many there are */
static int32_t count_at(const mus__board *board, int32_t side, double s, int32_t kind)
{
    int32_t n = 0;
    for (int32_t i = 0; i < board->nnotch; i++)
        n += board->notch[i].side == side && fabs(board->notch[i].s - s) < 1e-12 && board->notch[i].kind == kind;
    return n;
}


/* front 0.4 m, band 0.5 m reversed, facing 0.2 m direct on the band */
static void three_sheets(mus__board *board, mus_context *context, int32_t *side)
{
    mus__board_begin(board, context, "sheets");
    side[0] = rectangle(board, "front", 0.4);
    side[1] = rectangle(board, "band", 0.5);
    side[2] = rectangle(board, "facing", 0.2);
    mus__board_seam_add(board, side[0], side[1], MUS_SEAM_REVERSED, 0.1);
    mus__board_seam_add(board, side[2], side[1], MUS_SEAM_DIRECT, 0.3);
    table_well(board);
}


START_TEST(a_notch_goes_to_every_sheet_of_the_seam)
{
    mus_context *context = support_context();
    mus__board board;
    int32_t side[3];
    three_sheets(&board, context, side);
    mus__board_notch_seam(&board, side[0], 0.1, MUS_NOTCH_DOUBLE, 0.0);
    table_well(&board);
    ck_assert_int_eq(board.nnotch, 3);
    ck_assert_int_eq(count_at(&board, side[0], 0.1, MUS_NOTCH_DOUBLE), 1);
    ck_assert_int_eq(count_at(&board, side[1], 0.375, MUS_NOTCH_DOUBLE), 1);
    ck_assert_int_eq(count_at(&board, side[2], 0.15, MUS_NOTCH_DOUBLE), 1);

    /* a free side has it alone; an end is an end */
    mus__board_notch_seam(&board, board.side[side[0]].next, 0.1, MUS_NOTCH_SINGLE, 0.0);
    mus__board_notch_seam(&board, side[0], 0.4, MUS_NOTCH_SINGLE, 0.0);
    ck_assert_int_eq(board.nnotch, 7);
    ck_assert_int_eq(count_at(&board, side[1], 0.0, MUS_NOTCH_SINGLE), 1);
    mus__board_notch_seam(&board, side[0], 0.41, MUS_NOTCH_SINGLE, 0.0);
    ck_assert_int_eq(board.status, MUS_ERR_ARG);
    mus__board_free(&board);
    support_context_end(context);
}
END_TEST


/* given on one side each; what meets or lies within 12 mm on one outline, round a corner too, is one notch */
START_TEST(notches_are_matched_and_the_higher_kind_stays)
{
    mus_context *context = support_context();
    mus__board board;
    int32_t side[3];
    three_sheets(&board, context, side);
    mus__board_notch_add(&board, side[0], 0.1, MUS_NOTCH_SINGLE);
    mus__board_notch_add(&board, side[1], 0.375, MUS_NOTCH_SINGLE);  /* the place of the first */
    mus__board_notch_add(&board, side[2], 0.1, MUS_NOTCH_SINGLE);    /* 9 mm from a double one on itself */
    mus__board_notch_add(&board, side[1], 0.2275, MUS_NOTCH_DOUBLE);
    mus__board_notch_add(&board, board.side[side[2]].next, 0.008, MUS_NOTCH_TRIPLE); /* round the corner from */
    mus__board_notch_add(&board, side[2], 0.197, MUS_NOTCH_DOUBLE);                  /* this one, 11 mm */
    mus__board_match_notches(&board);
    table_well(&board);
    ck_assert_int_eq(board.nnotch, 7);
    ck_assert_int_eq(count_at(&board, side[0], 0.1, MUS_NOTCH_SINGLE), 1);
    ck_assert_int_eq(count_at(&board, side[1], 0.375, MUS_NOTCH_SINGLE), 1);
    ck_assert_int_eq(count_at(&board, side[2], 0.15, MUS_NOTCH_SINGLE), 1);
    ck_assert_int_eq(count_at(&board, side[0], 0.218, MUS_NOTCH_DOUBLE), 1);
    ck_assert_int_eq(count_at(&board, side[1], 0.2275, MUS_NOTCH_DOUBLE), 1);
    ck_assert_int_eq(count_at(&board, side[2], 0.091, MUS_NOTCH_DOUBLE), 1);
    ck_assert_int_eq(count_at(&board, board.side[side[2]].next, 0.008, MUS_NOTCH_TRIPLE), 1);

    /* matched once more, nothing moves */
    mus__board_match_notches(&board);
    ck_assert_int_eq(board.nnotch, 7);
    mus__board_free(&board);
    support_context_end(context);
}
END_TEST


START_TEST(each_allocation_that_fails_is_a_status_and_no_leak)
{
    for (int64_t n = 0;; n++) {
        mus_context *context = support_context();
        mus__board board;
        int32_t side[3];
        three_sheets(&board, context, side);
        mus__board_notch_add(&board, side[0], 0.1, MUS_NOTCH_SINGLE);
        support_fail_after(n, false);
        mus__board_match_notches(&board);
        support_fail_never();
        const mus_status status = board.status;
        mus__board_free(&board);
        support_context_end(context);
        if (status == MUS_OK) break;
        ck_assert_int_eq(status, MUS_ERR_MEMORY);
    }
}
END_TEST


/* a band of 0.7 m in two sides without a corner is sewn to a front of 0.4 m and a back of 0.3 m: the joint of these has
 * a notch on the band alone. It has none where the parts of the other edge go on as one, at a corner of the band, where
 * a side closes, and beside another notch */
START_TEST(a_joint_has_a_notch_on_the_long_edge_alone)
{
    mus_context *context = support_context();
    for (int32_t k = 0; k < 5; k++) {
        mus__board board;
        mus__board_begin(&board, context, "joint");
        const int32_t band = rectangle(&board, "band", 0.7), front = rectangle(&board, "front", k == 1 ? 0.7 : 0.4);
        const int32_t back = k == 1 ? MUS_NONE : rectangle(&board, "back", 0.3);
        if (k == 1) {
            mus__board_split(&board, front, 0.4, "low_2");
            mus__board_split(&board, band, 0.3, "low_2");
            mus__board_seam_add(&board, board.side[band].next, front, MUS_SEAM_REVERSED, 0.0);
            mus__board_seam_add(&board, band, board.side[front].next, MUS_SEAM_REVERSED, 0.0);
        } else {
            const int32_t parts[2] = {front, back}, corner = board.side[band].next;
            mus__board_sew(&board, 1, &band, k == 2 ? 1 : 2, parts);
            if (k == 2) mus__board_seam_add(&board, corner, back, MUS_SEAM_REVERSED, 0.0);
        }
        table_well(&board);
        if (k == 3) board.seam[mus__board_seam_of(&board, back)].closure = MUS_CLOSURE_ZIP;
        if (k == 4) mus__board_notch_seam(&board, back, 0.005, MUS_NOTCH_DOUBLE, 0.0);
        const int32_t before = board.nnotch;
        mus__board_notch_joints(&board);
        table_well(&board);
        ck_assert_int_eq(board.nnotch, before + (k == 0 ? 1 : 0));
        if (k == 0) ck_assert_int_eq(board.side[board.notch[before].side].panel, board.side[band].panel);
        if (k == 0) ck_assert_int_eq(count_at(&board, band, board.side[band].length, MUS_NOTCH_SINGLE), 1);
        mus__board_free(&board);
    }
    support_context_end(context);
}
END_TEST


Suite *mus_suite_board_notch(void);


Suite *mus_suite_board_notch(void)
{
    Suite *suite = suite_create("board_notch");
    TCase *tcase = tcase_create("board_notch");
    tcase_add_test(tcase, a_notch_goes_to_every_sheet_of_the_seam);
    tcase_add_test(tcase, notches_are_matched_and_the_higher_kind_stays);
    tcase_add_test(tcase, each_allocation_that_fails_is_a_status_and_no_leak);
    tcase_add_test(tcase, a_joint_has_a_notch_on_the_long_edge_alone);
    suite_add_tcase(suite, tcase);
    return suite;
}
