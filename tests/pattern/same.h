/*
 * same.h: two patterns compared through the public getters, to the bit; and a pattern with a bit of everything.
 */
#ifndef MUS_TESTS_SAME_H
#define MUS_TESTS_SAME_H

#include <string.h>

#include "muslin/pattern.h"
#include "support.h"

/* front: a square of 0.4 m with a curved neck; sleeve: a square; two seams, two notches, two marks, a placement */
typedef struct sample {
    mus_pattern *pattern;
    int32_t front, sleeve, point[8], edge[8], seam[2];
} sample;


static inline sample sample_make(mus_context *context)
{
    sample s;
    ck_assert_int_eq(mus_pattern_create(context, "sample", &s.pattern), MUS_OK);
    ck_assert_int_eq(mus_pattern_add_panel(s.pattern, "front", &s.front), MUS_OK);
    ck_assert_int_eq(mus_pattern_add_panel(s.pattern, "sleeve", &s.sleeve), MUS_OK);
    static const char *names[4] = {"hem", "side", NULL, "centre"};
    for (int32_t i = 0; i < 8; i++) {
        double x = i % 4 == 1 || i % 4 == 2 ? 0.4 : 0.0, y = i % 4 >= 2 ? 0.4 : 0.0;
        ck_assert_int_eq(mus_pattern_add_point(s.pattern, i < 4 ? s.front : s.sleeve, x, y, &s.point[i]), MUS_OK);
    }
    for (int32_t i = 0; i < 8; i++) {
        int32_t kinds[2] = {MUS_PIECE_LINE, MUS_PIECE_CUBIC};
        double xy[6] = {0.3, 0.4, 0.2, 0.38, 0.1, 0.33};
        int32_t npiece = i == 2 ? 2 : 1, start = s.point[i], end = s.point[i % 4 == 3 ? i - 3 : i + 1];
        ck_assert_int_eq(
            mus_pattern_add_edge(s.pattern, &(mus_edge_def){.size = sizeof(mus_edge_def), .name = names[i % 4],
                                                            .start = start, .end = end, .npiece = npiece,
                                                            .kinds = kinds, .nxy = i == 2 ? 3 : 0, .xy = xy},
                                 &s.edge[i]),
            MUS_OK);
    }
    int32_t along[4] = {1, 1, 1, 1};
    ck_assert_int_eq(mus_pattern_set_outline(s.pattern, s.front, 4, s.edge, along), MUS_OK);
    ck_assert_int_eq(mus_pattern_set_outline(s.pattern, s.sleeve, 4, s.edge + 4, along), MUS_OK);
    ck_assert_int_eq(mus_pattern_set_edge_label(s.pattern, s.edge[0], "hem"), MUS_OK);
    ck_assert_int_eq(mus_pattern_set_edge_allowance(s.pattern, s.edge[0], 0.03), MUS_OK);
    ck_assert_int_eq(mus_pattern_set_edge_hold(s.pattern, s.edge[2], MUS_HOLD_NECK, 0.01), MUS_OK);
    ck_assert_int_eq(mus_pattern_set_edge_elastic(s.pattern, s.edge[2], 0.8, 20.0), MUS_OK);
    for (int32_t i = 0; i < 2; i++) {
        mus_seam_def def;
        mus_seam_def_init(&def, sizeof def);
        def.edge_a = s.edge[1 + 2 * i];
        def.edge_b = s.edge[5 + 2 * i];
        ck_assert_int_eq(mus_pattern_add_seam(s.pattern, &def, &s.seam[i]), MUS_OK);
        ck_assert_int_eq(mus_pattern_add_notch(s.pattern, s.edge[i], 0.1 + 0.1 * i, 1 + i, NULL), MUS_OK);
    }
    double line[4] = {0.2, 0.1, 0.2, 0.3};
    ck_assert_int_eq(mus_pattern_add_mark(s.pattern, s.front, "centre front", 2, line, NULL), MUS_OK);
    ck_assert_int_eq(mus_pattern_add_mark(s.pattern, s.sleeve, "drill", 1, line, NULL), MUS_OK);
    mus_placement placement;
    mus_placement_init(&placement, sizeof placement);
    placement.origin[2] = 0.25;
    placement.bend = -0.1;
    ck_assert_int_eq(mus_pattern_set_placement(s.pattern, s.front, &placement), MUS_OK);
    ck_assert_int_eq(mus_pattern_set_grain(s.pattern, s.sleeve, 3.0, 4.0), MUS_OK);
    ck_assert_int_eq(mus_pattern_set_cut(s.pattern, s.sleeve, 2, MUS_NONE), MUS_OK);
    ck_assert_int_eq(mus_pattern_set_material(s.pattern, s.sleeve, MUS_MATERIAL_LINING, 3), MUS_OK);
    ck_assert_int_eq(mus_pattern_set_panel_label(s.pattern, s.sleeve, "arm"), MUS_OK);
    return s;
}


static inline void same_panels(const mus_pattern *a, const mus_pattern *b)
{
    ck_assert_int_eq(mus_pattern_panel_count(a), mus_pattern_panel_count(b));
    for (int32_t i = 0; i < mus_pattern_panel_count(a); i++) {
        int32_t n[2], cut[2][2];
        const int32_t *edges[2], *directions[2];
        double grain[2][2];
        mus_placement place[2];
        const mus_pattern *p[2] = {a, b};
        for (int32_t k = 0; k < 2; k++) {
            ck_assert_int_eq(mus_pattern_outline(p[k], i, &n[k], &edges[k], &directions[k]), MUS_OK);
            ck_assert_int_eq(mus_pattern_cut(p[k], i, &cut[k][0], &cut[k][1]), MUS_OK);
            ck_assert_int_eq(mus_pattern_grain(p[k], i, grain[k]), MUS_OK);
            mus_placement_init(&place[k], sizeof place[k]);
            ck_assert_int_eq(mus_pattern_placement(p[k], i, &place[k]), MUS_OK);
        }
        ck_assert_str_eq(mus_pattern_panel_name(a, i), mus_pattern_panel_name(b, i));
        ck_assert_str_eq(mus_pattern_panel_label(a, i), mus_pattern_panel_label(b, i));
        ck_assert_int_eq(mus_pattern_panel_sides(a, i, NULL), mus_pattern_panel_sides(b, i, NULL));
        ck_assert_int_eq(n[0], n[1]);
        if (n[0] > 0) ck_assert_mem_eq(edges[0], edges[1], (size_t)n[0] * sizeof *edges[0]);
        if (n[0] > 0) ck_assert_mem_eq(directions[0], directions[1], (size_t)n[0] * sizeof *directions[0]);
        ck_assert_mem_eq(cut[0], cut[1], sizeof cut[0]);
        for (int32_t m = 0; m < MUS_MATERIAL_COUNT; m++) {
            for (int32_t k = 0; k < 2; k++)
                ck_assert_int_eq(mus_pattern_material(p[k], i, m, &cut[k][0], &cut[k][1]), MUS_OK);
            ck_assert_mem_eq(cut[0], cut[1], sizeof cut[0]);
        }
        ck_assert_mem_eq(grain[0], grain[1], sizeof grain[0]);
        ck_assert_mem_eq(&place[0], &place[1], sizeof place[0]);
    }
}


static inline void same_edges(const mus_pattern *a, const mus_pattern *b)
{
    ck_assert_int_eq(mus_pattern_edge_count(a), mus_pattern_edge_count(b));
    for (int32_t i = 0; i < mus_pattern_edge_count(a); i++) {
        int32_t start[2], end[2], npiece[2], nxy[2];
        const int32_t *kinds[2];
        const double *xy[2];
        const mus_pattern *p[2] = {a, b};
        for (int32_t k = 0; k < 2; k++) {
            ck_assert_int_eq(mus_pattern_edge_ends(p[k], i, &start[k], &end[k]), MUS_OK);
            ck_assert_int_eq(mus_pattern_edge_pieces(p[k], i, &npiece[k], &kinds[k], &nxy[k], &xy[k]), MUS_OK);
        }
        double allowance[2] = {mus_pattern_edge_allowance(a, i), mus_pattern_edge_allowance(b, i)};
        double below[2], elastic[2][2];
        int32_t level[2];
        for (int32_t k = 0; k < 2; k++) {
            ck_assert_int_eq(mus_pattern_edge_hold(p[k], i, &level[k], &below[k]), MUS_OK);
            ck_assert_int_eq(mus_pattern_edge_elastic(p[k], i, &elastic[k][0], &elastic[k][1]), MUS_OK);
        }
        ck_assert(level[0] == level[1] && below[0] == below[1]);
        ck_assert_mem_eq(elastic[0], elastic[1], sizeof elastic[0]);
        double length[2] = {mus_pattern_edge_length(a, i), mus_pattern_edge_length(b, i)};
        ck_assert(start[0] == start[1] && end[0] == end[1] && npiece[0] == npiece[1] && nxy[0] == nxy[1]);
        ck_assert_mem_eq(kinds[0], kinds[1], (size_t)npiece[0] * sizeof *kinds[0]);
        ck_assert_mem_eq(xy[0], xy[1], 2 * (size_t)nxy[0] * sizeof *xy[0]);
        ck_assert(allowance[0] == allowance[1] || (allowance[0] != allowance[0] && allowance[1] != allowance[1]));
        ck_assert(length[0] == length[1]);
        ck_assert_str_eq(mus_pattern_edge_name(a, i), mus_pattern_edge_name(b, i));
        ck_assert_str_eq(mus_pattern_edge_label(a, i), mus_pattern_edge_label(b, i));
        ck_assert_int_eq(mus_pattern_edge_panel(a, i), mus_pattern_edge_panel(b, i));
        ck_assert_int_eq(mus_pattern_edge_seam(a, i), mus_pattern_edge_seam(b, i));
    }
}


static inline void same_rest(const mus_pattern *a, const mus_pattern *b)
{
    ck_assert_int_eq(mus_pattern_point_count(a), mus_pattern_point_count(b));
    ck_assert_int_eq(mus_pattern_seam_count(a), mus_pattern_seam_count(b));
    ck_assert_int_eq(mus_pattern_notch_count(a), mus_pattern_notch_count(b));
    ck_assert_int_eq(mus_pattern_mark_count(a), mus_pattern_mark_count(b));
    ck_assert_int_eq(mus_pattern_opening_count(a), mus_pattern_opening_count(b));
    for (int32_t i = 0; i < mus_pattern_opening_count(a); i++)
        ck_assert_str_eq(mus_pattern_opening(a, i), mus_pattern_opening(b, i));
    const mus_pattern *p[2] = {a, b};
    for (int32_t i = 0; i < mus_pattern_point_count(a); i++) {
        int32_t panel[2];
        double xy[2][2];
        for (int32_t k = 0; k < 2; k++) ck_assert_int_eq(mus_pattern_point(p[k], i, &panel[k], xy[k]), MUS_OK);
        ck_assert_int_eq(panel[0], panel[1]);
        ck_assert_mem_eq(xy[0], xy[1], sizeof xy[0]);
    }
    for (int32_t i = 0; i < mus_pattern_seam_count(a); i++) {
        mus_seam_def def[2];
        for (int32_t k = 0; k < 2; k++) {
            mus_seam_def_init(&def[k], sizeof def[k]);
            ck_assert_int_eq(mus_pattern_seam(p[k], i, &def[k]), MUS_OK);
        }
        ck_assert(def[0].edge_a == def[1].edge_a && def[0].edge_b == def[1].edge_b);
        ck_assert(def[0].direction == def[1].direction && def[0].ease == def[1].ease);
        ck_assert(def[0].tolerance == def[1].tolerance);
    }
    for (int32_t i = 0; i < mus_pattern_notch_count(a); i++) {
        int32_t edge[2], kind[2];
        double s[2];
        for (int32_t k = 0; k < 2; k++) ck_assert_int_eq(mus_pattern_notch(p[k], i, &edge[k], &s[k], &kind[k]), MUS_OK);
        ck_assert(edge[0] == edge[1] && s[0] == s[1] && kind[0] == kind[1]);
    }
    for (int32_t i = 0; i < mus_pattern_mark_count(a); i++) {
        int32_t panel[2], n[2];
        const char *name[2];
        const double *xy[2];
        for (int32_t k = 0; k < 2; k++)
            ck_assert_int_eq(mus_pattern_mark(p[k], i, &panel[k], &name[k], &n[k], &xy[k]), MUS_OK);
        ck_assert(panel[0] == panel[1] && n[0] == n[1] && strcmp(name[0], name[1]) == 0);
        ck_assert_mem_eq(xy[0], xy[1], 2 * (size_t)n[0] * sizeof *xy[0]);
    }
}


static inline void same_pattern(const mus_pattern *a, const mus_pattern *b)
{
    ck_assert_str_eq(mus_pattern_name(a), mus_pattern_name(b));
    same_panels(a, b);
    same_edges(a, b);
    same_rest(a, b);
}

#endif
