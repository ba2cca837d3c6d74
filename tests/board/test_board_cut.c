/*
 * test_board_cut.c: a cut and a join are undone by one another; a thousand random cuts, splits, turns and joins keep
 * the area and add 2 points, 3 edges and 1 face to the quotient; joining takes them back.
 */
#include "topology/garments.h"
#include "topology/gluing.h"
#include "pattern/same.h"
#include "board/table.h"
#include "muslin/topology.h"


/* a straight cut */
static int32_t cut_straight(mus__board *board, int32_t from, int32_t to, const char *name)
{
    const int32_t kind = MUS_PIECE_LINE;
    double xy[4];
    memcpy(xy, mus__board_start(board, from), 2 * sizeof *xy);
    memcpy(xy + 2, mus__board_start(board, to), 2 * sizeof *xy);
    return mus__board_cut(board, from, to, &(mus__board_path){1, &kind, 2, xy}, name, "cut");
}


START_TEST(a_cut_and_a_join_are_nothing)
{
    mus_context *context = support_context();
    uint64_t random = 3;
    sample s = sample_make(context);
    for (int32_t round = 0; round < 200; round++) {
        mus__board board;
        mus_pattern *after;
        mus__board_read(&board, s.pattern);
        const int32_t panel = round % 2, from = board.panel[panel].first + (int32_t)(support_random(&random) % 4);
        const int32_t to = board.side[board.side[from].next].next;
        const double area = table_area(&board, panel);
        const double *p = mus__board_start(&board, from), *q = mus__board_start(&board, to);
        const double bend[2] = {support_uniform(&random, 0.1, 0.3), support_uniform(&random, 0.1, 0.3)};
        const double xy[8] = {p[0], p[1], bend[0], bend[1], bend[1], bend[0], q[0], q[1]};
        const int32_t kind = MUS_PIECE_CUBIC, nmark = board.nmark;
        const int32_t made = mus__board_cut(&board, from, to, &(mus__board_path){1, &kind, 4, xy}, "part", "cut");
        table_whole(&board);
        ck_assert_int_eq(nmark, board.nmark);
        ck_assert_double_eq_tol(table_area(&board, panel) + table_area(&board, made), area, 1e-15);
        const int32_t stays = mus__board_find(&board, panel, "cut"), goes = mus__board_find(&board, made, "cut");
        ck_assert_int_eq(mus__board_partner(&board, stays), goes);
        ck_assert(mus__board_chain_same(&board.side[stays].chain, &board.side[goes].chain, true));

        /* the part may have been moved meanwhile: joining brings it back. So may the rest: then all is moved */
        if (round % 3 > 0) table_turn(&board, made, bend, support_uniform(&random, -3.0, 3.0), p);
        mus__board_join(&board, stays);
        table_whole(&board);
        ck_assert_double_eq_tol(table_area(&board, panel), area, 1e-14);
        ck_assert_int_eq(mus__board_find_panel(&board, "part"), MUS_NONE);
        board.panel[panel].first = panel == 0 ? table_side(&board, "front.hem") : table_side(&board, "sleeve.hem");
        mus__board_write(&board, &after);
        table_well(&board);
        /* the two pieces to cut of the sleeve's twin sides are as they were: the sample has no twin */
        table_same(s.pattern, after, "joined");
        mus_pattern_destroy(after);
        mus__board_free(&board);
    }
    mus_pattern_destroy(s.pattern);
    support_context_end(context);
}
END_TEST


/* one random operation: what it should have changed of V, E, F */
static bool random_step(mus__board *board, uint64_t *random, int32_t *change)
{
    char name[32];
    const int32_t side = (int32_t)(support_random(random) % (uint64_t)board->nside);
    const double part = support_uniform(random, 0.1, 0.9);
    if (board->side[side].panel == MUS_NONE) return false;
    const int32_t panel = board->side[side].panel, what = (int32_t)(support_random(random) % 8);
    if (what < 2) {
        /* a vertex more on the edge */
        if (board->side[side].length < 0.01) return false;
        mus__board_split(board, side, part * board->side[side].length, NULL);
        change[0]++, change[1]++;
        return true;
    }
    if (what < 5) {
        /* an edge and a panel more */
        int32_t to = board->side[side].next;
        for (uint64_t n = 1 + support_random(random) % 4; n > 0; n--) to = board->side[to].next;
        const double *p = mus__board_start(board, side), *q = mus__board_start(board, to);
        if (to == side || hypot(p[0] - q[0], p[1] - q[1]) < 0.001) return false;
        snprintf(name, sizeof name, "part%d", (int)board->npanel);
        cut_straight(board, side, to, name);
        change[1]++, change[2]++;
        return true;
    }
    if (what < 7) {
        const double centre[2] = {support_uniform(random, -1.0, 1.0), support_uniform(random, -1.0, 1.0)};
        table_turn(board, panel, centre, support_uniform(random, -3.0, 3.0), centre);
        return true;
    }
    /* a cut undone, where it is one edge only */
    const int32_t seam = mus__board_seam_of(board, side), other = mus__board_partner(board, side);
    if (other == MUS_NONE || strncmp(board->side[side].name, "cut", 3) != 0) return false;
    if (strncmp(board->side[other].name, "cut", 3) != 0 || board->side[other].panel == panel) return false;
    if (board->seam[seam].direction != MUS_SEAM_REVERSED) return false;
    int32_t live = 0;
    for (int32_t i = 0; i < board->nside; i++) live += board->side[i].panel != MUS_NONE;
    mus__board_join(board, side);
    for (int32_t i = 0; i < board->nside; i++) live -= board->side[i].panel != MUS_NONE;
    /* n edges between the two panels go, with n - 1 vertices between them */
    change[0] -= live / 2 - 1, change[1] -= live / 2, change[2]--;
    return true;
}


START_TEST(random_cuts_splits_turns_and_joins_keep_area_and_topology)
{
    mus_context *context = support_context();
    uint64_t random = 2024;
    for (int32_t round = 0; round < 1000; round++) {
        const garment *row = &garments[(size_t)round % (sizeof garments / sizeof garments[0])];
        mus_pattern *pattern = gluing_make(context, row->panels, row->seams, (uint64_t)round);
        mus__board board;
        mus_topology before, after;
        mus__board_read(&board, pattern);
        const double area = table_area(&board, MUS_NONE);
        table_topology(&board, &before);
        int32_t change[3] = {0, 0, 0};
        for (int32_t step = 0; step < 20;) step += random_step(&board, &random, change);
        table_whole(&board);
        ck_assert_double_eq_tol(table_area(&board, MUS_NONE), area, 1e-9);
        table_topology(&board, &after);
        ck_assert_msg(after.vertices == before.vertices + change[0] && after.edges == before.edges + change[1] &&
                          after.faces == before.faces + change[2],
                      "%s: (%d, %d, %d) became (%d, %d, %d), expected + (%d, %d, %d)", row->name, (int)before.vertices,
                      (int)before.edges, (int)before.faces, (int)after.vertices, (int)after.edges, (int)after.faces,
                      (int)change[0], (int)change[1], (int)change[2]);
        ck_assert(after.euler == before.euler && after.loops == before.loops && after.genus == before.genus &&
                  after.components == before.components && after.orientable == before.orientable);
        mus__board_free(&board);
        mus_pattern_destroy(pattern);
    }
    support_context_end(context);
}
END_TEST


START_TEST(a_part_has_the_attributes_of_the_panel_that_it_was_cut_from)
{
    mus_context *context = support_context();
    sample s = sample_make(context);
    mus__board board;
    mus__board_read(&board, s.pattern);
    board.panel[0].attr.layer = 3, board.panel[0].attr.cut[MUS_MATERIAL_MAIN] = 2;
    const int32_t side = table_side(&board, "front.side");
    cut_straight(&board, side, board.side[board.side[side].next].next, "part");
    table_whole(&board);
    const int32_t made = mus__board_find_panel(&board, "part");
    ck_assert_int_eq(board.panel[made].attr.layer, 3);
    ck_assert_int_eq(board.panel[made].attr.cut[MUS_MATERIAL_MAIN], 2);
    ck_assert_str_eq(board.panel[made].attr.label, board.panel[0].attr.label);
    mus__board_free(&board);
    mus_pattern_destroy(s.pattern);
    support_context_end(context);
}
END_TEST


START_TEST(marks_go_to_the_part_that_they_lie_in)
{
    mus_context *context = support_context();
    sample s = sample_make(context);
    mus__board board;
    mus__board_read(&board, s.pattern);
    const int32_t sleeve = s.sleeve, first = board.panel[sleeve].first;
    const double drill[2][2] = {{0.3, 0.1}, {0.1, 0.3}};
    int32_t mark[2];
    for (int32_t i = 0; i < 2; i++) mark[i] = mus__board_mark_add(&board, sleeve, "d", 1, drill[i]);
    const int32_t made = cut_straight(&board, first, board.side[board.side[first].next].next, "low");
    ck_assert_int_eq(board.mark[mark[0]].panel, made);
    ck_assert_int_eq(board.mark[mark[1]].panel, sleeve);
    mus__board_free(&board);
    mus_pattern_destroy(s.pattern);
    support_context_end(context);
}
END_TEST


START_TEST(a_panel_that_is_cut_is_no_twin)
{
    mus_context *context = support_context();
    sample s = sample_make(context);
    mus__board board;
    mus__board_read(&board, s.pattern);
    const int32_t twin = mus__board_mirror(&board, s.sleeve, "other");
    ck_assert_int_eq(board.panel[s.sleeve].attr.cut[MUS_MATERIAL_MAIN], 4);
    ck_assert_int_eq(board.panel[twin].attr.cut[MUS_MATERIAL_MAIN], 2);
    const int32_t first = board.panel[s.sleeve].first;
    cut_straight(&board, first, board.side[board.side[first].next].next, "low");
    ck_assert(board.panel[s.sleeve].attr.cut[MUS_MATERIAL_MAIN] == 2 && board.panel[twin].mirror_of == MUS_NONE);
    mus__board_free(&board);
    mus_pattern_destroy(s.pattern);
    support_context_end(context);
}
END_TEST


START_TEST(what_cannot_be_cut_or_joined_is_refused)
{
    mus_context *context = support_context();
    sample s = sample_make(context);
    for (int32_t i = 0; i < 4; i++) {
        mus__board board;
        mus__board_read(&board, s.pattern);
        const int32_t side = table_side(&board, "front.side");
        switch (i) {
        case 0: cut_straight(&board, side, side, "part"); break;
        case 1: cut_straight(&board, side, table_side(&board, "sleeve.side"), "part"); break;
        case 2: cut_straight(&board, side, board.side[board.side[side].next].next, "sleeve"); break;
        default: mus__board_join(&board, table_side(&board, "front.hem")); break;
        }
        ck_assert_int_ne(board.status, MUS_OK);
        mus__board_free(&board);
    }

    /* sides that are not congruent: one is shorter */
    mus__board board;
    mus__board_read(&board, s.pattern);
    const int32_t side = table_side(&board, "front.side");
    mus__board_seam_drop(&board, side);
    mus__board_split(&board, side, 0.399, NULL);
    mus__board_seam_add(&board, side, table_side(&board, "sleeve.side"), MUS_SEAM_REVERSED, 0.0);
    mus__board_join(&board, side);
    ck_assert_int_eq(board.status, MUS_ERR_PATTERN);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "not congruent"));
    mus__board_free(&board);
    mus_pattern_destroy(s.pattern);
    support_context_end(context);
}
END_TEST


START_TEST(a_seam_in_parts_is_joined_whole)
{
    mus_context *context = support_context();
    sample s = sample_make(context);
    for (int32_t part = 0; part < 3; part++) {
        mus__board board;
        mus__board_read(&board, s.pattern);
        const double area = table_area(&board, MUS_NONE);
        int32_t side[3] = {table_side(&board, "front.side")};
        for (int32_t i = 0; i < 2; i++) side[i + 1] = mus__board_split(&board, side[i], 0.1, NULL);
        const int32_t nseam = board.nseam;
        ck_assert_int_eq(nseam, 4);
        mus__board_join(&board, side[part]);
        table_whole(&board);
        for (int32_t i = 0; i < 3; i++) ck_assert_int_eq(board.side[side[i]].panel, MUS_NONE);
        ck_assert_double_eq_tol(table_area(&board, 0), area, 1e-15);
        mus__board_free(&board);
    }
    mus_pattern_destroy(s.pattern);
    support_context_end(context);
}
END_TEST


START_TEST(cutting_without_memory_fails_and_leaves_nothing)
{
    for (int64_t n = 0;; n++) {
        mus_context *context = support_context();
        sample s = sample_make(context);
        mus__board board;
        support_fail_after(n, false);
        mus__board_read(&board, s.pattern);
        const int32_t first = board.status == MUS_OK ? board.panel[s.sleeve].first : 0;
        const int32_t to = board.status == MUS_OK ? board.side[board.side[first].next].next : 0;
        if (board.status == MUS_OK) cut_straight(&board, first, to, "low");
        mus__board_join(&board, board.status == MUS_OK ? mus__board_find(&board, s.sleeve, "cut") : 0);
        support_fail_never();
        const mus_status status = board.status;
        mus__board_free(&board);
        mus_pattern_destroy(s.pattern);
        support_context_end(context);
        if (status == MUS_OK) break;
        ck_assert_int_eq(status, MUS_ERR_MEMORY);
    }
}
END_TEST


Suite *mus_suite_board_cut(void);
Suite *mus_suite_board_cut(void)
{
    Suite *suite = suite_create("board_cut");
    TCase *tcase = tcase_create("board_cut");
    tcase_add_test(tcase, a_cut_and_a_join_are_nothing);
    tcase_add_test(tcase, random_cuts_splits_turns_and_joins_keep_area_and_topology);
    tcase_add_test(tcase, a_part_has_the_attributes_of_the_panel_that_it_was_cut_from);
    tcase_add_test(tcase, marks_go_to_the_part_that_they_lie_in);
    tcase_add_test(tcase, a_panel_that_is_cut_is_no_twin);
    tcase_add_test(tcase, what_cannot_be_cut_or_joined_is_refused);
    tcase_add_test(tcase, a_seam_in_parts_is_joined_whole);
    tcase_add_test(tcase, cutting_without_memory_fails_and_leaves_nothing);
    suite_add_tcase(suite, tcase);
    return suite;
}
