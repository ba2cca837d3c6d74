/*
 * test_edit_random.c: a thousand random edits of drafted garments and of random panels: what each kind keeps, to 1e-9
 * (areas, lengths, angles, topology), that a refused edit changes no byte, and that undo gives every byte back.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "board/darts.h"
#include "muslin/topology.h"
#include "pattern/same.h"

enum {
    EDIT_ADD_DART,
    EDIT_ROTATE,
    EDIT_SHORTEN,
    EDIT_RELEASE,
    EDIT_SEPARATE,
    EDIT_JOIN,
    EDIT_SPREAD,
    EDIT_LENGTHEN,
    EDIT_MOVE,
    EDIT_SPLIT,
    EDIT_MERGE,
    EDIT_TRUE,
    EDIT_TO_SEAM,
    EDIT_FAIR,
    EDIT_KINDS
};

/* the figures of a pattern that edits keep or change by a known amount */
typedef struct summary {
    mus_topology topology;
    double area, angles, off; /* of all panels; of all darts; the worst that a seam is off by */
    int32_t notches, marks, seams;
} summary;


static summary summary_of(const mus_pattern *pattern)
{
    summary s = {.notches = mus_pattern_notch_count(pattern), .marks = mus_pattern_mark_count(pattern)};
    mus_topology_init(&s.topology, sizeof s.topology);
    ck_assert_int_eq(mus_pattern_topology(pattern, &s.topology), MUS_OK);
    for (int32_t i = 0; i < mus_pattern_panel_count(pattern); i++) s.area += mus_pattern_panel_area(pattern, i);
    s.seams = mus_pattern_seam_count(pattern);
    for (int32_t i = 0; i < s.seams; i++) {
        mus_seam_def def;
        mus_seam_walk walk;
        double angle;
        mus_seam_def_init(&def, sizeof def);
        mus_seam_walk_init(&walk, sizeof walk);
        ck_assert_int_eq(mus_pattern_seam(pattern, i, &def), MUS_OK);
        ck_assert_int_eq(mus_pattern_walk_seam(pattern, i, &walk), MUS_OK);
        s.off = fmax(s.off, fabs(walk.excess));
        if (mus_pattern_dart(pattern, def.edge_a, &angle, NULL, NULL) == MUS_OK) s.angles += angle;
    }
    return s;
}


/* an edge that is a leg of some dart, or any */
static int32_t some_leg(const mus_pattern *pattern, uint64_t *state)
{
    const uint64_t n = (uint64_t)mus_pattern_seam_count(pattern);
    for (int32_t k = 0; k < 20 && n > 0; k++) {
        mus_seam_def def;
        mus_seam_def_init(&def, sizeof def);
        mus_pattern_seam(pattern, (int32_t)(support_random(state) % n), &def);
        if (mus_pattern_dart(pattern, def.edge_a, NULL, NULL, NULL) == MUS_OK) return def.edge_a;
    }
    return 0;
}


/* do both legs of a dart reach as far, straight? Closed whole, others are trued by a little */
static bool leg_is_true(const mus_pattern *pattern, int32_t leg)
{
    const int32_t seam = mus_pattern_edge_seam(pattern, leg);
    mus_seam_def def;
    mus_seam_def_init(&def, sizeof def);
    if (seam == MUS_NONE || mus_pattern_seam(pattern, seam, &def) != MUS_OK) return false;
    int32_t a, b;
    const int32_t *kinds[2];
    mus_pattern_edge_pieces(pattern, def.edge_a, &a, &kinds[0], NULL, NULL);
    mus_pattern_edge_pieces(pattern, def.edge_b, &b, &kinds[1], NULL, NULL);
    const double more = mus_pattern_edge_length(pattern, def.edge_b) - mus_pattern_edge_length(pattern, def.edge_a);
    return a == 1 && b == 1 && kinds[0][0] == MUS_PIECE_LINE && kinds[1][0] == MUS_PIECE_LINE && fabs(more) < 1e-10;
}


/* some random edges of one panel */
static void some_edges(const mus_pattern *pattern, uint64_t *state, int32_t panel, int32_t *out, int32_t count)
{
    int32_t n;
    const int32_t *edges;
    mus_pattern_outline(pattern, panel, &n, &edges, NULL);
    for (int32_t i = 0; i < count; i++) out[i] = edges[support_random(state) % (uint64_t)n];
}


static double some_place(const mus_pattern *pattern, uint64_t *state, int32_t edge)
{
    return mus_pattern_edge_length(pattern, edge) * support_uniform(state, 0.1, 0.9);
}


/* one random edit of a kind; free says that a dart went to an edge that is no leg of another, which it would bend */
static mus_status edit_random(mus_pattern *pattern, uint64_t *state, int32_t kind, int32_t number, bool *free)
{
    const uint64_t npanel = (uint64_t)mus_pattern_panel_count(pattern);
    const int32_t panel = (int32_t)(support_random(state) % npanel), leg = some_leg(pattern, state);
    int32_t e[3], end, n, own[2];
    double at[2], s[2], other[2];
    char name[32];
    const int32_t *edges;
    snprintf(name, sizeof name, "panel%d", (int)number);
    some_edges(pattern, state,
               kind == EDIT_ROTATE || kind == EDIT_TO_SEAM ? mus_pattern_edge_panel(pattern, leg) : panel, e, 3);
    for (int32_t i = 0; i < 2; i++) s[i] = some_place(pattern, state, e[i]);
    const double half = 0.5;
    mus_pattern_edge_at(pattern, e[0], 1, &half, at);
    const uint64_t nseam = (uint64_t)mus_pattern_seam_count(pattern);
    const int32_t seam = nseam > 0 ? (int32_t)(support_random(state) % nseam) : 0;
    mus_seam_def def;
    mus_seam_def_init(&def, sizeof def);
    *free = mus_pattern_dart(pattern, e[0], NULL, NULL, NULL) != MUS_OK;
    switch (kind) {
    case EDIT_ADD_DART: {
        /* towards the middle of another edge, a third of the way */
        const double t = 0.5, part = support_uniform(state, 0.2, 0.5);
        mus_pattern_edge_at(pattern, e[1], 1, &t, other);
        for (int32_t k = 0; k < 2; k++) at[k] += part * (other[k] - at[k]);
        return mus_pattern_add_dart(pattern, e[0], t * mus_pattern_edge_length(pattern, e[0]),
                                    support_uniform(state, 0.002, 0.02), at, NULL);
    }
    case EDIT_ROTATE:
        return mus_pattern_rotate_dart(
            pattern, leg, e[0], s[0], e[1],
            leg_is_true(pattern, leg) && support_random(state) % 2 ? 1.0 : support_uniform(state, 0.2, 0.8), NULL);
    case EDIT_SHORTEN: return mus_pattern_shorten_dart(pattern, leg, support_uniform(state, 0.0, 0.01));
    case EDIT_RELEASE: return mus_pattern_release_dart(pattern, leg, NULL);
    case EDIT_SEPARATE:
        return mus_pattern_separate(pattern, &(mus_cut_def){.size = sizeof(mus_cut_def), .name = name,
                                                            .seam_name = name, .edge_a = e[0], .s_a = s[0],
                                                            .edge_b = e[1], .s_b = s[1]}, NULL, NULL);
    case EDIT_JOIN: return mus_pattern_join_panels(pattern, seam, NULL);
    case EDIT_SPREAD:
        return mus_pattern_spread(pattern, e[0], s[0], e[1], s[1], support_uniform(state, 0.0, 0.01),
                                  support_uniform(state, 0.0, 0.01));
    case EDIT_LENGTHEN: {
        const double along[2] = {support_uniform(state, -1.0, 1.0), support_uniform(state, -1.0, 1.0)};
        return mus_pattern_lengthen(pattern, panel, at, along, support_uniform(state, -0.01, 0.01));
    }
    case EDIT_MOVE:
        mus_pattern_edge_ends(pattern, e[0], &own[0], &end);
        mus_pattern_point(pattern, own[0], NULL, at);
        return mus_pattern_move_point(pattern, own[0], at[0] + support_uniform(state, -0.005, 0.005),
                                      at[1] + support_uniform(state, -0.005, 0.005));
    case EDIT_SPLIT: return mus_pattern_split_edge(pattern, e[0], s[0], NULL, NULL);
    case EDIT_MERGE:
        mus_pattern_outline(pattern, panel, &n, &edges, NULL);
        return mus_pattern_merge_edges(pattern, e[0], NULL);
    case EDIT_TRUE:
        mus_pattern_seam(pattern, seam, &def);
        return mus_pattern_true_seam(pattern, seam, def.edge_a, (int32_t)(support_random(state) % 2));
    case EDIT_TO_SEAM:
        return mus_pattern_dart_to_seam(pattern, &(mus_cut_def){.size = sizeof(mus_cut_def), .name = name,
                                                                .seam_name = name, .edge_a = leg, .edge_b = e[0],
                                                                .s_b = s[0]}, NULL, NULL);
    default: return mus_pattern_fair_edge(pattern, e[0], 0.004);
    }
}


/* Checks the figures after an edit that succeeded. */
static void edit_claims(int32_t kind, bool free, const summary *a, const summary *b)
{
    const mus_topology *x = &a->topology, *y = &b->topology;
    ck_assert_int_eq(y->euler, x->euler);
    ck_assert_int_eq(y->loops, x->loops);
    ck_assert_int_eq(y->components, x->components);
    ck_assert_int_eq(y->genus, x->genus);
    ck_assert_int_eq(y->orientable, x->orientable);
    ck_assert_int_eq(b->marks, a->marks);

    /* rigid: area, angles, seams as true as they were */
    const bool rigid = kind == EDIT_ROTATE || kind == EDIT_SEPARATE || kind == EDIT_JOIN || kind == EDIT_SPLIT ||
                       kind == EDIT_MERGE || kind == EDIT_TO_SEAM;
    if (rigid)
        ck_assert_msg(fabs(b->area - a->area) < 1e-9, "kind %d: area %.12g, then %.12g", (int)kind, a->area, b->area);
    if (kind == EDIT_ROTATE && free) ck_assert_double_eq_tol(b->angles, a->angles, 1e-9);
    if (rigid || kind == EDIT_SPREAD) ck_assert_double_le(b->off, 2.0 * a->off + 1e-9);
    if (kind == EDIT_ADD_DART) {
        ck_assert_int_eq(y->vertices - x->vertices, 2);
        ck_assert_int_eq(y->edges - x->edges, 2);
        ck_assert_int_eq(b->seams >= a->seams + 1, 1);
    }
    if (kind == EDIT_SEPARATE) {
        ck_assert_int_eq(y->faces - x->faces, 1);
        ck_assert_int_eq(y->edges - x->edges, 3);
        ck_assert_int_eq(y->vertices - x->vertices, 2);
    }
    if (kind == EDIT_JOIN) ck_assert_int_eq(y->faces - x->faces, -1);
    if (kind == EDIT_SPREAD) ck_assert_double_gt(b->area, a->area);
    if (kind == EDIT_SPREAD || kind == EDIT_SHORTEN || kind == EDIT_LENGTHEN || kind == EDIT_FAIR ||
        kind == EDIT_MOVE) {
        ck_assert_int_eq(y->vertices, x->vertices);
        ck_assert_int_eq(y->edges, x->edges);
        ck_assert_int_eq(b->notches, a->notches);
    }
}


static mus_pattern *some_pattern(mus_context *context, uint64_t *state, int32_t number)
{
    /* every other one is a named design, here and there from the list */
    if (number % 2 == 0) return drafts_pattern(context, mus_design_name(number / 2 * 31 % mus_design_count()), "W40");
    mus__board board;
    mus_pattern *pattern;
    mus__board_begin(&board, context, "random");
    const int32_t a = dart_panel_random(&board, state, "a", 5, 0.0, 0.0);
    const int32_t b = dart_panel_random(&board, state, "b", 4, 2.0, 0.0);
    for (int32_t k = 0; k < 2; k++) {
        const int32_t x = dart_nth(&board, a, k), y = dart_nth(&board, b, 3 - 2 * k);
        mus__board_seam_add(&board, x, y, MUS_SEAM_REVERSED, board.side[y].length - board.side[x].length);
    }
    mus__board_write(&board, &pattern);
    table_well(&board);
    mus__board_free(&board);
    return pattern;
}


START_TEST(a_thousand_random_edits_keep_what_they_keep_and_are_undone)
{
    mus_context *context = support_context();
    uint64_t state = 4711;
    int32_t done[EDIT_KINDS] = {0}, number = 0, all = 0;
    while (all < 1000) {
        mus_pattern *pattern = some_pattern(context, &state, number++), *first;
        ck_assert_int_eq(mus_pattern_keep_history(pattern, 40), MUS_OK);
        ck_assert_int_eq(mus_pattern_copy(pattern, &first), MUS_OK);
        ck_assert_int_eq(mus_pattern_add_dart(pattern, 0, 0.5 * mus_pattern_edge_length(pattern, 0), 1e9, NULL, NULL),
                         MUS_ERR_ARG);
        summary before = summary_of(pattern);
        for (int32_t k = 0; k < 40; k++) {
            mus_pattern *copy;
            bool free;
            ck_assert_int_eq(mus_pattern_copy(pattern, &copy), MUS_OK);
            const int32_t kind = (int32_t)(support_random(&state) % EDIT_KINDS),
                          steps = mus_pattern_undo_count(pattern);
            const mus_status status = edit_random(pattern, &state, kind, 100 * number + k, &free);
            if (status != MUS_OK) {
                ck_assert(status == MUS_ERR_ARG || status == MUS_ERR_PATTERN);
                same_pattern(pattern, copy);
                ck_assert_int_eq(mus_pattern_undo_count(pattern), steps);
            } else {
                const summary after = summary_of(pattern);
                edit_claims(kind, free, &before, &after);

                /* one in four is taken back at once, the rest at the end */
                if (support_random(&state) % 4 == 0) {
                    ck_assert_int_eq(mus_pattern_undo(pattern), MUS_OK);
                    same_pattern(pattern, copy);
                } else {
                    before = after;
                }
                done[kind]++, all++;
            }
            mus_pattern_destroy(copy);
        }
        while (mus_pattern_undo_count(pattern) > 0) ck_assert_int_eq(mus_pattern_undo(pattern), MUS_OK);
        same_pattern(pattern, first);
        mus_pattern_destroy(first);
        mus_pattern_destroy(pattern);
    }
    for (int32_t k = 0; k < EDIT_KINDS; k++) ck_assert_msg(done[k] >= 5, "kind %d: %d done", (int)k, (int)done[k]);
    support_context_end(context);
}
END_TEST


START_TEST(edits_survive_failing_memory)
{
    for (int32_t kind = 0; kind < EDIT_KINDS; kind++) {
        mus_context *context = support_context();
        uint64_t state = 12;
        mus_pattern *pattern = drafts_pattern(context, "bodice", "W40"), *copy;
        ck_assert_int_eq(mus_pattern_keep_history(pattern, 3), MUS_OK);
        ck_assert_int_eq(mus_pattern_copy(pattern, &copy), MUS_OK);
        for (int64_t n = 0;; n++) {
            uint64_t same = state + (uint64_t)kind;
            bool free;
            support_fail_after(n, false);
            const mus_status status = edit_random(pattern, &same, kind, 7, &free);
            support_fail_never();
            if (status != MUS_ERR_MEMORY) break;
            same_pattern(pattern, copy);
            ck_assert_int_eq(mus_pattern_undo_count(pattern), 0);
        }
        mus_pattern_destroy(copy);
        mus_pattern_destroy(pattern);
        support_context_end(context);
    }
}
END_TEST


Suite *mus_suite_edit_random(void);


Suite *mus_suite_edit_random(void)
{
    Suite *suite = suite_create("edit_random");
    TCase *tcase = tcase_create("edit_random");
    tcase_add_test(tcase, a_thousand_random_edits_keep_what_they_keep_and_are_undone);
    tcase_add_test(tcase, edits_survive_failing_memory);
    tcase_set_timeout(tcase, 120.0);
    suite_add_tcase(suite, tcase);
    return suite;
}
