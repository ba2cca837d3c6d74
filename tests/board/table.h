/*
 * table.h: what the tests of the cutting table (pattern/board.h) share: two patterns compared place by place of their
 * words, so that the order of edges and the way they are stored do not matter; and the state of a board failed with its
 * sentence.
 */
#ifndef MUS_TESTS_TABLE_H
#define MUS_TESTS_TABLE_H

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "board/board_cut.h"
#include "board/board_dart.h"
#include "board/board_patch_panel.h"
#include "board/board_pleat.h"
#include "board/board_smooth.h"
#include "board/board_spread.h"
#include "board/board_rigid_part.h"
#include "board/board_seam.h"
#include "geom/curve.h"
#include "muslin/topology.h"
#include "support.h"

/* the board is well, or the test fails with the sentence */
#define table_well(board) ck_assert_msg((board)->status == MUS_OK, "%s", mus_context_error((board)->context))


/* append a side that is one cubic (4 x 2) */
static inline int32_t table_cubic(mus__board *board, int32_t panel, const char *name, const char *label,
                                  const double *cubic)
{
    const int32_t kind = MUS_PIECE_CUBIC;
    return mus__board_side_add(board, panel, name, label, 1, &kind, 4, cubic);
}


/* move the sides and marks of a panel: turned by `angle` about `centre`, then shifted */
static inline void table_turn(mus__board *board, int32_t panel, const double *centre, double angle, const double *shift)
{
    const double c = cos(angle), s = sin(angle);
    const double map[6] = {c, -s, shift[0] + centre[0] - (c * centre[0] - s * centre[1]),
                           s, c,  shift[1] + centre[1] - (s * centre[0] + c * centre[1])};
    for (int32_t i = 0; i < board->nside; i++)
        if (board->side[i].panel == panel) mus__board_chain_move(&board->side[i].chain, map);
    for (int32_t i = 0; i < board->nmark; i++) {
        mus__board_chain points = {.nxy = board->mark[i].n, .xy = board->mark[i].xy};
        if (board->mark[i].panel == panel) mus__board_chain_move(&points, map);
    }
    double *grain = board->panel[panel].attr.grain;
    const double x = grain[0], y = grain[1];
    grain[0] = c * x - s * y, grain[1] = s * x + c * y;
}



/* the canonical forms are the same bytes */
static inline void table_same_form(const mus_pattern *a, const mus_pattern *b, const char *title)
{
    const mus_pattern *p[2] = {a, b};
    uint8_t *bytes[2];
    size_t count[2];
    mus_form_def def;
    mus_form_def_init(&def, sizeof def);
    def.mirror = 0;
    for (int32_t k = 0; k < 2; k++) {
        mus_status status = mus_pattern_form(p[k], &def, NULL, 0, &count[k], NULL);
        ck_assert_msg(status == MUS_OK, "%s: %s", title, mus_context_error(mus_pattern_context(a)));
        bytes[k] = malloc(count[k] + 1);
        ck_assert_int_eq(mus_pattern_form(p[k], &def, bytes[k], count[k], &count[k], NULL), MUS_OK);
    }
    ck_assert_msg(count[0] == count[1] && memcmp(bytes[0], bytes[1], count[0]) == 0, "%s: another form", title);
    free(bytes[0]);
    free(bytes[1]);
}


/* the notches of place k of panel i: how many, and the sums of kind, s and s^2 as the word walks */
static inline void table_notches(const mus_pattern *p, int32_t edge, int32_t turn, double *out)
{
    const double length = mus_pattern_edge_length(p, edge);
    memset(out, 0, 4 * sizeof *out);
    for (int32_t i = 0; i < mus_pattern_notch_count(p); i++) {
        int32_t on, kind;
        double s;
        ck_assert_int_eq(mus_pattern_notch(p, i, &on, &s, &kind), MUS_OK);
        if (on != edge) continue;
        if (turn < 0) s = length - s;
        out[0] += 1.0, out[1] += kind, out[2] += kind * s, out[3] += kind * s * s;
    }
}


/* the two words of panel i, place by place */
static inline void table_same_word(const mus_pattern *a, const mus_pattern *b, int32_t panel, const char *title)
{
    const mus_pattern *p[2] = {a, b};
    int32_t n[2];
    const int32_t *edges[2], *turns[2];
    for (int32_t k = 0; k < 2; k++)
        ck_assert_int_eq(mus_pattern_outline(p[k], panel, &n[k], &edges[k], &turns[k]), MUS_OK);
    ck_assert_msg(n[0] == n[1], "%s: panel %d has %d edges, then %d", title, (int)panel, (int)n[0], (int)n[1]);
    for (int32_t i = 0; i < n[0]; i++) {
        const int32_t x = edges[0][i], y = edges[1][i];
        double notch[2][4];
        ck_assert_str_eq(mus_pattern_edge_name(a, x), mus_pattern_edge_name(b, y));
        ck_assert_str_eq(mus_pattern_edge_label(a, x), mus_pattern_edge_label(b, y));
        ck_assert_double_eq_tol(mus_pattern_edge_length(a, x), mus_pattern_edge_length(b, y), 1e-12);
        const double allowance[2] = {mus_pattern_edge_allowance(a, x), mus_pattern_edge_allowance(b, y)};
        ck_assert(allowance[0] == allowance[1] || (isnan(allowance[0]) && isnan(allowance[1])));
        int32_t hold[2];
        double stay[2][3];
        for (int32_t k = 0; k < 2; k++) {
            ck_assert_int_eq(mus_pattern_edge_hold(p[k], edges[k][i], &hold[k], &stay[k][0]), MUS_OK);
            ck_assert_int_eq(mus_pattern_edge_elastic(p[k], edges[k][i], &stay[k][1], &stay[k][2]), MUS_OK);
        }
        ck_assert(hold[0] == hold[1] && memcmp(stay[0], stay[1], sizeof stay[0]) == 0);
        ck_assert_int_eq(mus_pattern_edge_seam(a, x) == MUS_NONE, mus_pattern_edge_seam(b, y) == MUS_NONE);
        for (int32_t k = 0; k < 2; k++) table_notches(p[k], edges[k][i], turns[k][i], notch[k]);
        for (int32_t k = 0; k < 4; k++) ck_assert_double_eq_tol(notch[0][k], notch[1][k], 1e-12);
        /* the same line, from the same end */
        double at[2][6], t[3] = {0.0, 0.3, 1.0}, back[3] = {1.0, 0.7, 0.0};
        ck_assert_int_eq(mus_pattern_edge_at(a, x, 3, turns[0][i] > 0 ? t : back, at[0]), MUS_OK);
        ck_assert_int_eq(mus_pattern_edge_at(b, y, 3, turns[1][i] > 0 ? t : back, at[1]), MUS_OK);
        for (int32_t k = 0; k < 6; k++) ck_assert_double_eq_tol(at[0][k], at[1][k], 1e-9);
    }
}


static inline void table_same_panel(const mus_pattern *a, const mus_pattern *b, int32_t panel, const char *title)
{
    const mus_pattern *p[2] = {a, b};
    int32_t cut[2][2];
    double grain[2][2];
    mus_placement place[2];
    for (int32_t k = 0; k < 2; k++) {
        ck_assert_int_eq(mus_pattern_cut(p[k], panel, &cut[k][0], &cut[k][1]), MUS_OK);
        ck_assert_int_eq(mus_pattern_grain(p[k], panel, grain[k]), MUS_OK);
        mus_placement_init(&place[k], sizeof place[k]);
        ck_assert_int_eq(mus_pattern_placement(p[k], panel, &place[k]), MUS_OK);
    }
    ck_assert_str_eq(mus_pattern_panel_name(a, panel), mus_pattern_panel_name(b, panel));
    ck_assert_str_eq(mus_pattern_panel_label(a, panel), mus_pattern_panel_label(b, panel));
    ck_assert_mem_eq(cut[0], cut[1], sizeof cut[0]);
    for (int32_t k = 0; k < 2; k++) ck_assert_double_eq_tol(grain[0][k], grain[1][k], 1e-12);
    ck_assert_mem_eq(&place[0], &place[1], sizeof place[0]);
    ck_assert_double_eq_tol(mus_pattern_panel_area(a, panel), mus_pattern_panel_area(b, panel), 1e-12);
    table_same_word(a, b, panel, title);
}


/* the same pattern, but for the order and direction of its edges and points */
static inline void table_same(const mus_pattern *a, const mus_pattern *b, const char *title)
{
    ck_assert_str_eq(mus_pattern_name(a), mus_pattern_name(b));
    ck_assert_int_eq(mus_pattern_panel_count(a), mus_pattern_panel_count(b));
    ck_assert_msg(mus_pattern_edge_count(a) == mus_pattern_edge_count(b), "%s: edges", title);
    ck_assert_msg(mus_pattern_seam_count(a) == mus_pattern_seam_count(b), "%s: seams", title);
    ck_assert_int_eq(mus_pattern_notch_count(a), mus_pattern_notch_count(b));
    ck_assert_int_eq(mus_pattern_mark_count(a), mus_pattern_mark_count(b));
    ck_assert_int_eq(mus_pattern_opening_count(a), mus_pattern_opening_count(b));
    for (int32_t i = 0; i < mus_pattern_panel_count(a); i++) table_same_panel(a, b, i, title);
    for (int32_t i = 0; i < mus_pattern_mark_count(a); i++) {
        int32_t panel[2], n[2];
        const char *name[2];
        const double *xy[2];
        ck_assert_int_eq(mus_pattern_mark(a, i, &panel[0], &name[0], &n[0], &xy[0]), MUS_OK);
        ck_assert_int_eq(mus_pattern_mark(b, i, &panel[1], &name[1], &n[1], &xy[1]), MUS_OK);
        ck_assert(panel[0] == panel[1] && n[0] == n[1] && strcmp(name[0], name[1]) == 0);
        for (int32_t k = 0; k < 2 * n[0]; k++) ck_assert_double_eq_tol(xy[0][k], xy[1][k], 1e-9);
    }
    for (int32_t i = 0; i < mus_pattern_opening_count(a); i++)
        ck_assert_str_eq(mus_pattern_opening(a, i), mus_pattern_opening(b, i));
    table_same_form(a, b, title);
}


/* a pattern laid on the table and written is the pattern that it was */
static inline void table_there_and_back(const mus_pattern *pattern, const char *title)
{
    mus__board board;
    mus_pattern *again;
    mus__board_read(&board, pattern);
    table_well(&board);
    mus__board_write(&board, &again);
    table_well(&board);
    table_same(pattern, again, title);
    mus__board_free(&board);
    mus_pattern_destroy(again);
}


/* signed area of all panels of a board, or of one */
static inline double table_area(const mus__board *board, int32_t panel)
{
    double area = 0.0;
    for (int32_t i = 0; i < board->nside; i++) {
        const mus__board_side *side = &board->side[i];
        if (side->panel == MUS_NONE || (panel != MUS_NONE && side->panel != panel)) continue;
        const double *p = side->chain.xy;
        for (int32_t k = 0; k < side->chain.npiece; k++) {
            area += mus__curve_area(side->chain.kinds[k], p);
            p += 2 * (mus__curve_points(side->chain.kinds[k]) - 1);
        }
    }
    return area;
}


/* rings are whole: links go both ways, ends meet bit for bit, lengths are those of the chains, seams and notches are on
 * sides that are there */
static inline void table_whole(const mus__board *board)
{
    table_well(board);
    for (int32_t i = 0; i < board->nside; i++) {
        const mus__board_side *side = &board->side[i];
        if (side->panel == MUS_NONE) continue;
        ck_assert(board->side[side->next].prev == i && board->side[side->next].panel == side->panel);
        ck_assert(board->side[side->prev].next == i);
        ck_assert_mem_eq(mus__board_end(board, i), mus__board_start(board, side->next), 2 * sizeof(double));
        ck_assert_double_eq_tol(side->length, mus__board_chain_length(&side->chain), 1e-12);
    }
    for (int32_t i = 0; i < board->npanel; i++)
        if (board->panel[i].first != MUS_NONE) ck_assert_int_eq(board->side[board->panel[i].first].panel, i);
    for (int32_t i = 0; i < board->nseam; i++) {
        const mus__board_seam *seam = &board->seam[i];
        if (seam->a == MUS_NONE) continue;
        ck_assert(board->side[seam->a].panel != MUS_NONE && board->side[seam->b].panel != MUS_NONE);
    }
    for (int32_t i = 0; i < board->nnotch; i++) {
        const mus__board_notch *notch = &board->notch[i];
        if (notch->side == MUS_NONE) continue;
        ck_assert(board->side[notch->side].panel != MUS_NONE);
        ck_assert(notch->s >= 0.0 && notch->s <= board->side[notch->side].length + 1e-12);
    }
}


/* vertices, edges, faces, Euler number and loops of what is on the board */
static inline void table_topology(mus__board *board, mus_topology *out)
{
    mus_pattern *pattern;
    mus__board_write(board, &pattern);
    table_well(board);
    mus_topology_init(out, sizeof *out);
    ck_assert_int_eq(mus_pattern_topology(pattern, out), MUS_OK);
    mus_pattern_destroy(pattern);
}


/* "front.side": a side by the names of its panel and its own */
static inline int32_t table_side(const mus__board *board, const char *title)
{
    char panel[64];
    const size_t n = strcspn(title, ".");
    memcpy(panel, title, n);
    panel[n] = '\0';
    const int32_t side = mus__board_find(board, mus__board_find_panel(board, panel), title + n + 1);
    ck_assert_msg(side != MUS_NONE, "no side %s", title);
    return side;
}

#endif
