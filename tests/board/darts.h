/*
 * darts.h: what the tests of darts and slashes share: the drafted front with both darts to the bust point, and random
 * panels with curved sides.
 */
#ifndef MUS_TESTS_DARTS_H
#define MUS_TESTS_DARTS_H

#include <stdio.h>

#include "block/drafts.h"
#include "geom/vec.h"
#include "board/table.h"
#include "muslin/topology.h"

/* the wearer's left front of the bodice block, counter-clockwise from the waist at the centre, unsewn but for its darts
 */
typedef struct dart_front {
    int32_t panel;
    int32_t waist_in, waist_leg, waist_out, side_low, bust_leg, side_high, arm_low, arm_high, shoulder, neck, cf;
} dart_front;


/* a side along a cubic from its end to its start */
static inline int32_t dart_cubic_back(mus__board *board, int32_t panel, const char *name, const double *cubic)
{
    double turned[8];
    for (int i = 0; i < 4; i++) turned[2 * i] = cubic[6 - 2 * i], turned[2 * i + 1] = cubic[7 - 2 * i];
    return table_cubic(board, panel, name, name, turned);
}


static inline dart_front dart_front_draw(mus__board *board, const mus__bodice_half *half)
{
    const double origin[2] = {0.0, 0.0}, *dart = half->dart[0];
    dart_front f = {.panel = mus__board_panel_add(board, "front", "body")};
    f.waist_in = mus__board_line_add(board, f.panel, "waist1", "waist", origin, dart);
    f.waist_leg = mus__board_line_add(board, f.panel, "wd1", "", dart, half->bust);
    const int32_t waist_back = mus__board_line_add(board, f.panel, "wd2", "", half->bust, dart + 4);
    f.waist_out = mus__board_line_add(board, f.panel, "waist2", "waist", dart + 4, half->side);
    f.side_low = mus__board_line_add(board, f.panel, "side1", "side", half->side, half->mouth + 2);
    f.bust_leg = mus__board_line_add(board, f.panel, "bd1", "", half->mouth + 2, half->bust);
    const int32_t bust_back = mus__board_line_add(board, f.panel, "bd2", "", half->bust, half->mouth);
    f.side_high = mus__board_line_add(board, f.panel, "side2", "side", half->mouth, half->under);
    f.arm_low = dart_cubic_back(board, f.panel, "arm1", half->arm_low);
    f.arm_high = dart_cubic_back(board, f.panel, "arm2", half->arm_high);
    f.shoulder = mus__board_line_add(board, f.panel, "shoulder", "shoulder", half->tip, half->snp);
    f.neck = dart_cubic_back(board, f.panel, "neck", half->neck);
    f.cf = mus__board_line_add(board, f.panel, "cf", "centre", half->centre, origin);
    mus__board_panel_close(board, f.panel);
    mus__board_seam_add(board, f.waist_leg, waist_back, MUS_SEAM_REVERSED, 0.0);
    mus__board_seam_add(board, f.bust_leg, bust_back, MUS_SEAM_REVERSED, 0.0);
    const double mark[4] = {0.01, half->centre[1] - 0.01, 0.01, 0.01};
    mus__board_mark_add(board, f.panel, "centre front", 2, mark);
    mus__board_mark_add(board, f.panel, "bust point", 1, half->bust);
    return f;
}


/* a panel of n sides round `centre`, lines and cubics, of which each is seen whole from the centre */
static inline int32_t dart_panel_random(mus__board *board, uint64_t *state, const char *name, int32_t n, double x,
                                        double y)
{
    const int32_t panel = mus__board_panel_add(board, name, "body");
    double corner[16][2];
    for (int32_t i = 0; i < n; i++) {
        const double a = 2.0 * MUS_PI * (i + support_uniform(state, -0.2, 0.2)) / n,
                     r = support_uniform(state, 0.2, 0.3);
        corner[i][0] = x + r * cos(a), corner[i][1] = y + r * sin(a);
    }
    for (int32_t i = 0; i < n; i++) {
        const double *p = corner[i], *q = corner[(i + 1) % n];
        char side[16];
        snprintf(side, sizeof side, "s%c", (char)('a' + i));
        const double u[2] = {q[0] - p[0], q[1] - p[1]},
                     h[2] = {support_uniform(state, -0.1, 0.1), support_uniform(state, -0.1, 0.1)};
        const double cubic[8] = {p[0],
                                 p[1],
                                 p[0] + u[0] / 3.0 - h[0] * u[1],
                                 p[1] + u[1] / 3.0 + h[0] * u[0],
                                 q[0] - u[0] / 3.0 - h[1] * u[1],
                                 q[1] - u[1] / 3.0 + h[1] * u[0],
                                 q[0],
                                 q[1]};
        if (support_random(state) % 3 == 0)
            mus__board_line_add(board, panel, side, "", p, q);
        else
            table_cubic(board, panel, side, "", cubic);
    }
    mus__board_panel_close(board, panel);
    return panel;
}


/* the k-th side of a panel from its first */
static inline int32_t dart_nth(const mus__board *board, int32_t panel, int32_t k)
{
    int32_t side = board->panel[panel].first;
    while (k-- > 0) side = board->side[side].next;
    return side;
}


static inline int32_t dart_count(const mus__board *board, int32_t panel)
{
    int32_t n = 0, first = board->panel[panel].first, side = first;
    do {
        n++;
        side = board->side[side].next;
    } while (side != first);
    return n;
}


/* the ring is closed: each side starts where the one before ends, bit for bit, and knows it */
static inline void dart_ring_whole(const mus__board *board, int32_t panel)
{
    const int32_t n = dart_count(board, panel);
    for (int32_t k = 0; k < n; k++) {
        const int32_t side = dart_nth(board, panel, k), next = board->side[side].next;
        ck_assert_int_eq(board->side[next].prev, side);
        ck_assert_int_eq(board->side[side].panel, panel);
        ck_assert_mem_eq(mus__board_end(board, side), mus__board_start(board, next), 2 * sizeof(double));
        ck_assert_double_eq_tol(board->side[side].length, mus__board_chain_length(&board->side[side].chain), 1e-12);
    }
}


/* the topology of a board once it is written */
static inline mus_topology dart_topology(mus__board *board)
{
    mus_pattern *pattern;
    mus_topology topology;
    mus__board_write(board, &pattern);
    table_well(board);
    mus_topology_init(&topology, sizeof topology);
    ck_assert_int_eq(mus_pattern_topology(pattern, &topology), MUS_OK);
    mus_pattern_destroy(pattern);
    return topology;
}


/* V, E, F and all that follows are those of `before`, plus dv, de, df */
static inline void dart_same_topology(const mus_topology *before, const mus_topology *after, int32_t dv, int32_t de,
                                      int32_t df)
{
    ck_assert_int_eq(after->vertices, before->vertices + dv);
    ck_assert_int_eq(after->edges, before->edges + de);
    ck_assert_int_eq(after->faces, before->faces + df);
    ck_assert_int_eq(after->loops, before->loops);
    ck_assert_int_eq(after->components, before->components);
    ck_assert(after->orientable == before->orientable && after->manifold == before->manifold);
    ck_assert_int_eq(after->genus, before->genus);
}

#endif
