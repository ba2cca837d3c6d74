/*
 * test_board_dart_rotate.c: darts rotated on the cutting table: golden numbers of five pivots of a drafted front, and
 * what every pivot keeps: area, the sum of the angles at the point, lengths of all that is rigid, the ring, the
 * topology of the sewn panel.
 *
 * The golden numbers were computed by an independent drafting script in Python, with 4000 chords to a curve.
 */
#include <string.h>

#include "board/darts.h"
#include "muslin/topology.h"

#define DEGREE 0.017453292519943295


/* legs, in cm, angle in degrees, of the dart whose leg is given */
static void golden_dart(const mus__board *board, int32_t leg, double width, double angle, double length, const char *to)
{
    const int32_t back = board->side[leg].next;
    CK_GOLDEN("W40", to, mus__dist2(mus__board_start(board, leg), mus__board_end(board, back)), CM, width, 0.0011);
    CK_GOLDEN("W40", to, mus__board_dart_angle(board, leg), DEGREE, angle, 0.0011);
    CK_GOLDEN("W40", to, board->side[leg].length, CM, length, 0.0011);
    CK_GOLDEN("W40", to, board->side[back].length, CM, length, 0.0011);
}


START_TEST(pivots_have_the_golden_numbers)
{
    static const struct {
        const char *to;
        double width, angle, leg;
    } golden[5] = {{"shoulder", 5.180, 12.0, 24.779},
                   {"neck", 4.729, 12.0, 22.620},
                   {"armhole", 2.958, 12.0, 14.148},
                   {"waist", 7.086, 20.373, 20.034},
                   {"cf", 1.923, 12.0, 9.200}};
    mus_context *context = support_context();
    const mus__bodice bodice = drafts_bodice(context, "W40");
    mus__board board;
    mus__board_begin(&board, context, "front");
    const dart_front f = dart_front_draw(&board, &bodice.front);
    table_well(&board);
    const mus_topology before = dart_topology(&board);
    const int32_t sides = dart_count(&board, f.panel);
    CK_GOLDEN("W40", "area", mus__board_area(&board, f.panel), CM * CM, 871.910, 0.0011);

    const int32_t target[5] = {f.shoulder, f.neck, f.arm_low, f.waist_out, f.cf};
    const double down = bodice.front.centre[1] - bodice.front.bust[1];
    const double along[5] = {0.5, 0.5, 1.0, 0.0, down / board.side[f.cf].length};
    const int32_t keep = _i == 4 ? f.waist_in : f.cf;
    const double s = along[_i] * board.side[target[_i]].length;
    const int32_t leg = mus__board_dart_rotate(&board, f.bust_leg, target[_i], s, keep, 1.0);
    table_well(&board);
    golden_dart(&board, leg, golden[_i].width, golden[_i].angle, golden[_i].leg, golden[_i].to);
    CK_GOLDEN("W40", "area", mus__board_area(&board, f.panel), CM * CM, 871.910, 0.0011);
    dart_ring_whole(&board, f.panel);

    /* the side seam is one again and straight, and as long as the draft says that it is when the dart is closed */
    ck_assert_int_eq(board.side[f.side_high].panel, MUS_NONE);
    ck_assert_int_eq(board.side[f.side_low].chain.npiece, 1);
    ck_assert_double_eq_tol(board.side[f.side_low].length, bodice.front.side_length, 1e-12);

    /* into the waist dart there is a dart less; between two sides, none to be split */
    const mus_topology after = dart_topology(&board);
    const bool merged = _i == 3, joint = _i == 2;
    ck_assert_int_eq(dart_count(&board, f.panel), sides - (merged ? 3 : joint ? 1 : 0));
    dart_same_topology(&before, &after, merged ? -2 : joint ? -1 : 0, merged ? -2 : joint ? -1 : 0, 0);
    mus__board_free(&board);
    support_context_end(context);
}
END_TEST


/* sum of the angles of all darts of a panel */
static double dart_angles(const mus__board *board, int32_t panel)
{
    double sum = 0.0;
    for (int32_t i = 0; i < board->nside; i++)
        if (board->side[i].panel == panel) sum += mus__board_dart_angle(board, i);
    return sum;
}


/* a random pivot: what it is asked for, and what the panel was before */
typedef struct pivot {
    mus__board board;
    int32_t panel, leg, sides;
    double point[2], q[2], fraction, area, angle, total, lengths[64];
    mus_topology topology;
} pivot;


/* a panel of curved sides, two of them sewn to another panel, with a dart; false when the dart does not fit */
static bool pivot_make(pivot *v, mus_context *context, uint64_t *state)
{
    mus__board *board = &v->board;
    mus__board_begin(board, context, "random");
    const int32_t n = 3 + (int32_t)(support_random(state) % 6);
    const double x = support_uniform(state, -1.0, 1.0), y = support_uniform(state, -1.0, 1.0);
    v->panel = dart_panel_random(board, state, "a", n, x, y);
    const int32_t other = dart_panel_random(board, state, "b", 4, x + 2.0, y);
    for (int32_t k = 0; k < 2; k++)
        mus__board_seam_add(board, dart_nth(board, v->panel, k), dart_nth(board, other, 3 - 2 * k), MUS_SEAM_REVERSED,
                            0.0);
    for (int i = 0; i < 2; i++) v->point[i] = (i == 0 ? x : y) + support_uniform(state, -0.05, 0.05);
    const int32_t mouth = dart_nth(board, v->panel, (int32_t)(support_random(state) % (uint64_t)n));
    const double s = support_uniform(state, 0.4, 0.6) * board->side[mouth].length;
    v->leg = mus__board_dart_add(board, mouth, s, support_uniform(state, 0.01, 0.04), v->point);
    if (board->status == MUS_ERR_ARG) return false;
    table_well(board);
    mus__board_mark_add(board, v->panel, "point", 1, v->point);

    v->topology = dart_topology(board);
    v->area = mus__board_area(board, v->panel), v->angle = mus__board_dart_angle(board, v->leg);
    v->sides = board->nside, v->total = 0.0;
    for (int32_t i = 0; i < v->sides; i++) {
        v->lengths[i] = board->side[i].length;
        v->total += board->side[i].panel == v->panel ? v->lengths[i] : 0.0;
    }
    return true;
}


/* area, the sum of the angles, the mouth 2 |OQ| sin(t / 2), both legs, the point */
static void pivot_dart_claims(const pivot *v, int32_t made)
{
    const mus__board *board = &v->board;
    const int32_t back = board->side[made].next;
    const double leg = mus__dist2(v->q, v->point), turned = v->fraction * v->angle;
    ck_assert_double_eq_tol(mus__board_area(board, v->panel), v->area, 1e-12);
    ck_assert_double_eq_tol(dart_angles(board, v->panel), v->angle, 1e-12);
    ck_assert_double_eq_tol(mus__board_dart_angle(board, made), turned, 1e-12);
    ck_assert_double_eq_tol(mus__dist2(mus__board_start(board, made), mus__board_end(board, back)),
                            2.0 * leg * sin(0.5 * turned), 1e-12);
    ck_assert_double_eq_tol(board->side[made].length, leg, 1e-12);
    ck_assert_double_eq_tol(board->side[back].length, leg, 1e-12);
    ck_assert_mem_eq(mus__board_end(board, made), v->point, sizeof v->point);
    ck_assert_mem_eq(board->mark[0].xy, v->point, sizeof v->point);

    /* sides that were neither cut nor joined are as long as they were, to the bit; all together as well */
    double sum = 0.0;
    int32_t changed = 0;
    for (int32_t i = 0; i < board->nside; i++) sum += board->side[i].panel == v->panel ? board->side[i].length : 0.0;
    for (int32_t i = 0; i < v->sides; i++)
        changed += board->side[i].panel != MUS_NONE && board->side[i].length != v->lengths[i];
    ck_assert_double_eq_tol(sum, v->total + 2.0 * leg - (v->fraction == 1.0 ? 2.0 * v->lengths[v->leg] : 0.0), 1e-12);
    ck_assert_int_le(changed, 5);
}


START_TEST(random_pivots_keep_all_that_a_pivot_keeps)
{
    mus_context *context = support_context();
    uint64_t state = 77;
    int32_t done = 0, merged = 0;
    for (int32_t round = 0; round < 1000; round++) {
        pivot v;
        if (pivot_make(&v, context, &state)) {
            const uint64_t n = (uint64_t)dart_count(&v.board, v.panel);
            const int32_t target = dart_nth(&v.board, v.panel, (int32_t)(support_random(&state) % n));
            const int32_t keep = dart_nth(&v.board, v.panel, (int32_t)(support_random(&state) % n));
            const double s = support_uniform(&state, 0.05, 0.95) * v.board.side[target].length;
            v.fraction = support_random(&state) % 2 ? 1.0 : support_uniform(&state, 0.1, 0.9);
            mus__board_at(&v.board, target, s, v.q, NULL);
            const int32_t made = mus__board_dart_rotate(&v.board, v.leg, target, s, keep, v.fraction);
            if (v.board.status != MUS_ERR_ARG) {
                table_well(&v.board);
                dart_ring_whole(&v.board, v.panel);
                pivot_dart_claims(&v, made);

                /* whole, to a mouth that is one again, the quotient is what it was; in part there is a dart more */
                const mus_topology after = dart_topology(&v.board);
                const bool one = v.fraction == 1.0 && after.vertices == v.topology.vertices;
                const int32_t more = v.fraction < 1.0 ? 2 : one ? 0 : 1;
                dart_same_topology(&v.topology, &after, more, more, 0);
                done++, merged += one;
            }
        }
        mus__board_free(&v.board);
    }
    /* targets on the dart's own legs and lines that leave the panel are refused; mouths drawn as one become one */
    ck_assert_int_ge(done, 500);
    ck_assert_int_ge(merged, 150);
    support_context_end(context);
}
END_TEST


START_TEST(there_and_back_is_where_it_was)
{
    mus_context *context = support_context();
    const mus__bodice bodice = drafts_bodice(context, "W40");
    mus__board board, once;
    mus__board_begin(&board, context, "front");
    mus__board_begin(&once, context, "front");
    const dart_front f = dart_front_draw(&board, &bodice.front);
    dart_front_draw(&once, &bodice.front);
    const double s = board.side[f.side_low].length;
    const int32_t leg = mus__board_dart_rotate(&board, f.bust_leg, f.shoulder, 0.05, f.cf, 1.0);
    const int32_t again = mus__board_dart_rotate(&board, leg, f.side_low, s, f.cf, 1.0);
    table_well(&board);
    ck_assert_int_eq(dart_count(&board, f.panel), dart_count(&once, f.panel));
    ck_assert_str_eq(board.side[again].name, "side1_d1");
    for (int32_t k = 0; k < dart_count(&board, f.panel); k++) {
        const int32_t a = dart_nth(&board, f.panel, k), b = dart_nth(&once, f.panel, k);
        ck_assert_double_eq_tol(mus__dist2(mus__board_start(&board, a), mus__board_start(&once, b)), 0.0, 1e-12);
        ck_assert_double_eq_tol(board.side[a].length, once.side[b].length, 1e-12);
    }
    mus__board_free(&board);
    mus__board_free(&once);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_board_dart_rotate(void);


Suite *mus_suite_board_dart_rotate(void)
{
    Suite *suite = suite_create("board_dart_rotate");
    TCase *tcase = tcase_create("rotate");
    tcase_add_loop_test(tcase, pivots_have_the_golden_numbers, 0, 5);
    tcase_add_test(tcase, random_pivots_keep_all_that_a_pivot_keeps);
    tcase_add_test(tcase, there_and_back_is_where_it_was);
    suite_add_tcase(suite, tcase);
    return suite;
}
