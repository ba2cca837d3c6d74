/*
 * test_board_mirror.c: half garments doubled have the cells of the table of garments (topology/garments.h); mirroring
 * twice is nothing; a half unfolded is the whole.
 */
#include "topology/gluing.h"
#include "board/table.h"
#include "muslin/topology.h"

typedef struct half {
    const char *name, *panels, *seams, *centres; /* centre sides with f (fold), s (seam), o (open) */
    int32_t vertices, edges, faces, euler, loops;
} half;

/* the left halves of garments of the table topology/garments.h */
/* clang-format off */
static const half halves[] = {
    {"T-shirt", "F: hem side arm sh neck cf; B: hem cb neck sh arm side; S: hem underB capB capF underF",
     "F.side B.side; F.sh B.sh; F.arm S.capF; B.arm S.capB; S.underF S.underB", "F.cf f B.cb f",
     10, 16, 4, -2, 4},
    {"trousers", "F: waist crotch inseam hem out; B: waist out hem inseam crotch",
     "F.out B.out; F.inseam B.inseam", "F.crotch s B.crotch s",
     9, 14, 4, -1, 3},
    {"trousers, 1 dart per piece", "F: w1 d1 d2 w2 crotch inseam hem out; B: w1 d1 d2 w2 out hem inseam crotch",
     "F.out B.out; F.inseam B.inseam; F.d1 F.d2; B.d1 B.d2", "F.crotch s B.crotch s",
     17, 22, 4, -1, 3},
    {"trousers, fly open", "F: waist fly crotch inseam hem out; B: waist out hem inseam crotch",
     "F.out B.out; F.inseam B.inseam", "F.crotch s F.fly o B.crotch s",
     11, 16, 4, -1, 3},
    {"skirt, 2 panels", "F: hem side waist cf; B: hem cb waist side", "F.side B.side", "F.cf f B.cb f",
     4, 6, 2, 0, 2},
    {"skirt, 2 panels, 2 darts each", "F: hem side w1 a b w2 cf; B: hem cb w2 a b w1 side",
     "F.side B.side; F.a F.b; B.a B.b", "F.cf f B.cb f",
     12, 14, 2, 0, 2},
    {"circle skirt, 1 panel 1 seam", "A: waist cf hem cb", "", "A.cf f A.cb s",
     2, 3, 1, 0, 2},
    {"bodice with darts, closed",
     "F: cf w1 wd1 wd2 w2 side1 bd1 bd2 side2 arm sh neck; B: neck sh arm side2 side1 w2 wd2 wd1 w1 cb",
     "F.side1 B.side1; F.side2 B.side2; F.bd1 F.bd2; F.wd1 F.wd2; B.wd1 B.wd2; F.sh B.sh", "F.cf s B.cb s",
     24, 30, 4, -2, 4},
    {"bodice with darts, open front",
     "F: cf w1 wd1 wd2 w2 side1 bd1 bd2 side2 arm sh neck; B: neck sh arm side2 side1 w2 wd2 wd1 w1 cb",
     "F.side1 B.side1; F.side2 B.side2; F.bd1 F.bd2; F.wd1 F.wd2; B.wd1 B.wd2; F.sh B.sh", "F.cf o B.cb s",
     26, 31, 4, -1, 3},
    {"bodice no darts, closed", "F: cf w1 side arm sh neck; B: neck sh arm side w1 cb", "F.side B.side; F.sh B.sh",
     "F.cf s B.cb s",
     12, 18, 4, -2, 4},
    {"sleeveless dress (bodice+skirt)",
     "F: cf w1 wd1 wd2 w2 side1 bd1 bd2 side2 arm sh neck; B: neck sh arm side2 side1 w2 wd2 wd1 w1 cb; "
     "sF: hem side w2 a b w1 cf; sB: hem cb w1 a b w2 side",
     "F.side1 B.side1; F.side2 B.side2; F.bd1 F.bd2; F.wd1 F.wd2; B.wd1 B.wd2; F.sh B.sh; sF.side sB.side; "
     "sF.a sF.b; sB.a sB.b; F.w1 sF.w1; F.w2 sF.w2; B.w1 sB.w1; B.w2 sB.w2",
     "F.cf s B.cb s sF.cf f sB.cb f",
     30, 38, 6, -2, 4},
    {"sleeveless jumpsuit",
     "F: cf w1 wd1 wd2 w2 side1 bd1 bd2 side2 arm sh neck; B: neck sh arm side2 side1 w2 wd2 wd1 w1 cb; "
     "sF: w1 d1 d2 w2 crotch inseam hem out; sB: w1 d1 d2 w2 out hem inseam crotch",
     "F.side1 B.side1; F.side2 B.side2; F.bd1 F.bd2; F.wd1 F.wd2; B.wd1 B.wd2; F.sh B.sh; sF.out sB.out; "
     "sF.inseam sB.inseam; sF.d1 sF.d2; sB.d1 sB.d2; F.w2 sF.w1; F.w1 sF.w2; B.w1 sB.w1; B.w2 sB.w2",
     "F.cf s B.cb s sF.crotch s sB.crotch s",
     33, 44, 8, -3, 5},
    {"sleeveless top + hood", "F: cf w1 side arm sh neck; B: neck sh arm side w1 cb; H: nF nB crown face",
     "F.side B.side; F.sh B.sh; H.nF F.neck; H.nB B.neck", "F.cf s B.cb s H.crown s",
     13, 21, 6, -2, 4},
    {"raglan tee", "F: hem side rag neck cf; B: hem cb neck rag side; S: hem underB ragB neck ragF underF",
     "F.side B.side; F.rag S.ragF; B.rag S.ragB; S.underF S.underB", "F.cf f B.cb f",
     10, 16, 4, -2, 4},
    {"dolman tee", "F: hem side under cuff over neck cf; B: hem cb neck over cuff under side",
     "F.side B.side; F.under B.under; F.over B.over", "F.cf f B.cb f",
     10, 14, 2, -2, 4},
    /* a turtleneck with its seam behind: the table's seam is at the shoulder, this has a vertex and an edge more */
    {"T-shirt + turtleneck tube", "F: hem side arm sh neck cf; B: hem cb neck sh arm side; "
     "S: hem underB capB capF underF; T: fold n1 n2 e top",
     "F.side B.side; F.sh B.sh; F.arm S.capF; B.arm S.capB; S.underF S.underB; F.neck T.n1; B.neck T.n2",
     "F.cf f B.cb f T.fold f T.e s",
     12, 19, 5, -2, 4},
};
/* clang-format on */


/* a half garment on the board, its centre sides told */
static void half_read(mus_context *context, const half *row, uint64_t seed, mus__board *board)
{
    mus_pattern *pattern = gluing_make(context, row->panels, row->seams, seed);
    mus__board_read(board, pattern);
    table_well(board);
    mus_pattern_destroy(pattern);
    char title[64], kind[8];
    int used;
    for (const char *at = row->centres; sscanf(at, " %63s %7s%n", title, kind, &used) == 2; at += used)
        board->side[table_side(board, title)].centre = kind[0] == 'f'   ? MUS__CENTRE_FOLD
                                                       : kind[0] == 's' ? MUS__CENTRE_SEAM
                                                                        : MUS__CENTRE_OPEN;
}


START_TEST(doubled_halves_have_the_cells_of_whole_garments)
{
    mus_context *context = support_context();
    for (size_t i = 0; i < sizeof halves / sizeof halves[0]; i++) {
        const half *row = &halves[i];
        for (uint64_t seed = 0; seed < 3; seed++) {
            mus__board board;
            mus_topology t;
            half_read(context, row, seed, &board);
            const double area = table_area(&board, MUS_NONE);
            mus__board_double(&board);
            table_whole(&board);
            ck_assert_double_eq_tol(table_area(&board, MUS_NONE), 2.0 * area, 1e-12);
            table_topology(&board, &t);
            ck_assert_msg(t.vertices == row->vertices && t.edges == row->edges && t.faces == row->faces &&
                              t.euler == row->euler && t.loops == row->loops && t.orientable == 1 && t.manifold == 1 &&
                              t.genus == 0 && t.components == 1,
                          "%s: V %d E %d F %d chi %d loops %d genus %d", row->name, (int)t.vertices, (int)t.edges,
                          (int)t.faces, (int)t.euler, (int)t.loops, (int)t.genus);
            mus__board_free(&board);
        }
    }
    support_context_end(context);
}
END_TEST


/* a T-shirt's half in metres: front and back on the fold, a sleeve */
static void half_shirt(mus_context *context, mus__board *board)
{
    static const double f[][2] = {{0, -0.6}, {0.25, -0.6}, {0.25, 0}, {0.2, 0.22}, {0.08, 0.26}, {0, 0.18}};
    static const double arm[8] = {0.25, 0, 0.2, 0.02, 0.17, 0.1, 0.2, 0.22};
    static const double neck[8] = {0.08, 0.26, 0.075, 0.2, 0.04, 0.18, 0, 0.18};
    mus__board_begin(board, context, "shirt");
    const int32_t front = mus__board_panel_add(board, "front", "body");
    mus__board_line_add(board, front, "hem", "hem", f[0], f[1]);
    mus__board_line_add(board, front, "side", NULL, f[1], f[2]);
    table_cubic(board, front, "arm", "armhole", arm);
    mus__board_line_add(board, front, "sh", "shoulder", f[3], f[4]);
    table_cubic(board, front, "neck", "neck", neck);
    board->side[mus__board_line_add(board, front, "cf", "centre", f[5], f[0])].centre = MUS__CENTRE_FOLD;
    mus__board_panel_close(board, front);
    const int32_t sleeve = mus__board_panel_add(board, "sleeve", "arm");
    static const double s[][2] = {{-0.15, -0.15}, {0.15, -0.15}, {0.18, 0}, {0, 0.12}, {-0.18, 0}};
    static const char *const names[] = {"hem", "underB", "capB", "capF", "underF"};
    for (int32_t i = 0; i < 5; i++)
        mus__board_line_add(board, sleeve, names[i], i == 0 ? "cuff" : "", s[i], s[(i + 1) % 5]);
    mus__board_panel_close(board, sleeve);
    const int32_t a = table_side(board, "front.arm"), b = table_side(board, "sleeve.capF");
    mus__board_sew(board, 1, &a, 1, &b);
    const int32_t c = table_side(board, "sleeve.underF"), d = table_side(board, "sleeve.underB");
    mus__board_sew(board, 1, &c, 1, &d);
    table_whole(board);
}


START_TEST(what_a_half_carries_is_on_both_halves_of_the_whole)
{
    mus_context *context = support_context();
    mus__board board;
    half_shirt(context, &board);
    const double middle[4] = {0.0, -0.6, 0.0, 0.18}, pocket[2] = {0.1, 0.05};
    mus__board_mark_add(&board, 0, "centre front", 2, middle);
    mus__board_mark_add(&board, 0, "drill", 1, pocket);
    mus__board_notch_add(&board, table_side(&board, "front.arm"), 0.05, MUS_NOTCH_SINGLE);
    mus__board_notch_add(&board, table_side(&board, "front.hem"), 0.0, MUS_NOTCH_SINGLE);
    board.side[table_side(&board, "front.hem")].attr.allowance = 0.03;
    mus_placement *place = &board.panel[1].attr.placement;
    const double turn[9] = {0.6, -0.8, 0.0, 0.8, 0.6, 0.0, 0.0, 0.0, 1.0};
    memcpy(place->rotation, turn, sizeof turn);
    place->origin[0] = 0.3, place->bend = 0.1, place->bend_x = 0.02;
    mus__board_double(&board);
    table_whole(&board);

    /* names and lengths */
    ck_assert_int_eq(board.panel[0].first, table_side(&board, "front.hem"));
    const int32_t arm = table_side(&board, "front.arm"), arm_r = table_side(&board, "front.arm_r");
    const int32_t hem = table_side(&board, "front.hem"), neck = table_side(&board, "front.neck");
    ck_assert_int_eq(mus__board_find(&board, 0, "hem_r"), MUS_NONE);
    ck_assert_double_eq_tol(board.side[hem].length, 0.5, 1e-15);
    ck_assert_int_eq(board.side[hem].chain.npiece, 1);
    ck_assert_int_eq(board.side[neck].chain.npiece, 2);
    ck_assert(board.side[hem].attr.allowance == 0.03);
    ck_assert_str_eq(board.side[arm_r].attr.label, "armhole");
    ck_assert_str_eq(board.panel[1].name, "sleeve_left");
    ck_assert_str_eq(board.panel[2].name, "sleeve_right");
    ck_assert(board.panel[2].mirror_of == 1 && board.panel[1].attr.cut[MUS_MATERIAL_MAIN] == 2);
    ck_assert_int_eq(board.panel[2].attr.cut[MUS_MATERIAL_MAIN], 1);
    ck_assert_int_eq(mus__board_partner(&board, arm), table_side(&board, "sleeve_left.capF"));
    ck_assert_int_eq(mus__board_partner(&board, arm_r), table_side(&board, "sleeve_right.capF"));

    /* the notch at the fold is one; that of the armhole is on both sides, as far from the underarm */
    int32_t count[3] = {0, 0, 0};
    for (int32_t i = 0; i < board.nnotch; i++) {
        const mus__board_notch *notch = &board.notch[i];
        count[0] += notch->side == hem && fabs(notch->s - 0.25) < 1e-12;
        count[1] += notch->side == arm && notch->s == 0.05;
        count[2] += notch->side == arm_r && fabs(notch->s - (board.side[arm].length - 0.05)) < 1e-12;
    }
    ck_assert(count[0] == 1 && count[1] == 1 && count[2] == 1);
    int32_t marks = 0;
    for (int32_t i = 0; i < board.nmark; i++) marks += board.mark[i].panel != MUS_NONE;
    ck_assert_int_eq(marks, 3);

    /* points of the right sleeve stand in space as the mirror images of those of the left */
    const double p[3] = {0.02 + 0.1 * sin(0.8), 0.07, 0.1 * (cos(0.8) - 1.0)}, q[3] = {-p[0], p[1], p[2]};
    for (int32_t i = 0; i < 3; i++) {
        double x[2];
        for (int32_t k = 0; k < 2; k++) {
            const mus_placement *at = &board.panel[1 + k].attr.placement;
            const double *r = at->rotation + 3 * i, *v = k == 0 ? p : q;
            x[k] = at->origin[i] + r[0] * v[0] + r[1] * v[1] + r[2] * v[2];
        }
        ck_assert_double_eq_tol(x[0], i == 0 ? -x[1] : x[1], 1e-15);
    }
    ck_assert_double_eq(board.panel[2].attr.placement.bend_x, -0.02);
    mus__board_free(&board);
    support_context_end(context);
}
END_TEST


START_TEST(mirrored_twice_is_the_panel_itself)
{
    mus_context *context = support_context();
    mus__board board;
    mus_pattern *before, *after;
    half_shirt(context, &board);
    mus__board_notch_add(&board, table_side(&board, "front.arm"), 0.05, MUS_NOTCH_DOUBLE);
    mus__board_seam_drop(&board, table_side(&board, "front.arm"));
    mus__board_write(&board, &before);
    const int32_t names[2] = {0, 1};
    for (int32_t i = 0; i < 2; i++) {
        char own[MUS__NAME_BYTES];
        memcpy(own, board.panel[names[i]].name, sizeof own);
        const int32_t once = mus__board_mirror(&board, names[i], "once");
        ck_assert_int_eq(board.panel[once].mirror_of, names[i]);
        const int32_t twice = mus__board_mirror(&board, once, "twice");
        mus__board_remove_panel(&board, once);
        mus__board_remove_panel(&board, names[i]);
        memcpy(board.panel[twice].name, own, sizeof own);
        ck_assert_int_eq(board.panel[twice].attr.cut[MUS_MATERIAL_MAIN], 1);
    }
    table_whole(&board);
    mus__board_write(&board, &after);
    table_well(&board);
    table_same(before, after, "twice");
    mus_pattern_destroy(before);
    mus_pattern_destroy(after);
    mus__board_free(&board);
    support_context_end(context);
}
END_TEST


START_TEST(a_fold_may_lie_anywhere_but_must_be_straight_and_open)
{
    mus_context *context = support_context();
    mus__board board;
    const double centre[2] = {0.3, 0.1}, shift[2] = {0.05, -0.2};
    for (int32_t i = 0; i < 3; i++) {
        half_shirt(context, &board);
        table_turn(&board, 0, centre, 0.7 * i, shift);
        const double area = table_area(&board, 0);
        mus__board_unfold(&board, table_side(&board, "front.cf"));
        table_whole(&board);
        ck_assert_double_eq_tol(table_area(&board, 0), 2.0 * area, 1e-14);
        ck_assert_double_eq_tol(board.side[table_side(&board, "front.hem")].length, 0.5, 1e-14);
        ck_assert_int_eq(mus__board_partner(&board, table_side(&board, "front.arm_r")), MUS_NONE);
        mus__board_free(&board);
    }
    half_shirt(context, &board);
    mus__board_unfold(&board, table_side(&board, "front.neck"));
    ck_assert_int_eq(board.status, MUS_ERR_PATTERN);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "not straight"));
    mus__board_free(&board);
    half_shirt(context, &board);
    mus__board_unfold(&board, table_side(&board, "sleeve.underF"));
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "sewn"));
    mus__board_free(&board);
    support_context_end(context);
}
END_TEST


START_TEST(doubling_without_memory_fails_and_leaves_nothing)
{
    for (int64_t n = 0;; n++) {
        mus_context *context = support_context();
        mus__board board;
        mus_pattern *pattern;
        half_shirt(context, &board);
        support_fail_after(n, false);
        mus__board_double(&board);
        mus__board_write(&board, &pattern);
        support_fail_never();
        const mus_status status = board.status;
        ck_assert_int_eq(status == MUS_OK, pattern != NULL);
        mus_pattern_destroy(pattern);
        mus__board_free(&board);
        support_context_end(context);
        if (status == MUS_OK) break;
        ck_assert_int_eq(status, MUS_ERR_MEMORY);
    }
}
END_TEST


Suite *mus_suite_board_mirror(void);
Suite *mus_suite_board_mirror(void)
{
    Suite *suite = suite_create("board_mirror");
    TCase *tcase = tcase_create("board_mirror");
    tcase_add_test(tcase, doubled_halves_have_the_cells_of_whole_garments);
    tcase_add_test(tcase, what_a_half_carries_is_on_both_halves_of_the_whole);
    tcase_add_test(tcase, mirrored_twice_is_the_panel_itself);
    tcase_add_test(tcase, a_fold_may_lie_anywhere_but_must_be_straight_and_open);
    tcase_add_test(tcase, doubling_without_memory_fails_and_leaves_nothing);
    suite_add_tcase(suite, tcase);
    return suite;
}
