/*
 * test_pattern_json_read.c: muslin's own JSON: what was written comes back with every index and every bit, writing
 * again gives the same bytes, and what is refused says where.
 */
#define _POSIX_C_SOURCE 200809L
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "comma_locale.h"
#include "muslin/exchange.h"
#include "muslin/topology.h"
#include "support.h"


static mus_status read_text(mus_context *context, const char *text, mus_pattern **out)
{
    char path[512];
    support_spill(support_scratch("small.json", path, sizeof path), text, strlen(text));
    return mus_pattern_read(context, path, out);
}


/* a point half way along an arc from a to b: on the line that is as far from both */
static void arc_middle(const double *a, const double *b, double *out)
{
    out[0] = 0.5 * (a[0] + b[0]) - 0.3 * (b[1] - a[1]);
    out[1] = 0.5 * (a[1] + b[1]) + 0.3 * (b[0] - a[0]);
}


/* attributes of panels and edges: cut, labels, allowance, attachment, elastic, placement */
static void make_up(mus_pattern *pattern, uint64_t *seed, int32_t edges[3][4])
{
    ck_assert_int_eq(mus_pattern_set_cut(pattern, 0, 2, MUS_NONE), MUS_OK);
    ck_assert_int_eq(mus_pattern_set_cut(pattern, 1, 0, 2), MUS_OK);
    ck_assert_int_eq(mus_pattern_set_material(pattern, 1, MUS_MATERIAL_RIB, 1), MUS_OK);
    ck_assert_int_eq(mus_pattern_set_material(pattern, 2, MUS_MATERIAL_INTERFACING, (int32_t)(*seed % 5)), MUS_OK);
    ck_assert_int_eq(mus_pattern_set_panel_label(pattern, 1, "body"), MUS_OK);
    ck_assert_int_eq(mus_pattern_set_panel_sides(pattern, 1, (int32_t)(*seed % 16)), MUS_OK);
    ck_assert_int_eq(mus_pattern_set_edge_label(pattern, edges[1][1], "left_armhole"), MUS_OK);
    ck_assert_int_eq(mus_pattern_set_edge_allowance(pattern, edges[1][2], 0.015 / 7.0), MUS_OK);
    ck_assert_int_eq(mus_pattern_set_edge_hold(pattern, edges[0][0], MUS_HOLD_WAIST, -0.02 / 3.0) |
                         mus_pattern_set_edge_elastic(pattern, edges[0][0], 2.0 / 3.0, 70.0 / 3.0), MUS_OK);
    double angle = support_uniform(seed, -3, 3);
    mus_placement placement;
    mus_placement_init(&placement, sizeof placement);
    placement.origin[1] = 1.0 / 3.0;
    placement.rotation[0] = placement.rotation[8] = cos(angle);
    placement.rotation[2] = sin(angle);
    placement.rotation[6] = -sin(angle);
    placement.bend = -0.1 / 3.0;
    placement.bend_x = 0.7;
    ck_assert_int_eq(mus_pattern_set_placement(pattern, 1, &placement), MUS_OK);
}


/* a pattern with some of everything; points and edges of the panels are numbered in turns */
static mus_pattern *make_pattern(mus_context *context, uint64_t seed)
{
    mus_pattern *pattern;
    int32_t panels[3], points[3][4], edges[3][4], index;
    ck_assert_int_eq(mus_pattern_create(context, "Zo\xC3\xAB \"quoted\" \\ back\tslash", &pattern), MUS_OK);
    for (int p = 0; p < 3; p++) {
        char name[32];
        snprintf(name, sizeof name, "panel %d", p);
        ck_assert_int_eq(mus_pattern_add_panel(pattern, name, &panels[p]), MUS_OK);
        ck_assert_int_eq(
            mus_pattern_set_grain(pattern, p, support_uniform(&seed, -1, 1), support_uniform(&seed, -1, 1)), MUS_OK);
    }
    static const double corner[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    for (int k = 0; k < 4; k++)
        for (int p = 2; p >= 0; p--)
            ck_assert_int_eq(mus_pattern_add_point(pattern, panels[p], corner[k][0] + support_uniform(&seed, -.1, .1),
                                                   k == 0 && p == 0 ? -0.0 : corner[k][1] / 3.0, &points[p][k]),
                             MUS_OK);
    for (int k = 0; k < 4; k++)
        for (int p = 0; p < 3; p++) {
            /* panel 0: lines; 1: a curve of each kind; 2: a chain of all kinds, joints included */
            const int32_t kinds[4] = {MUS_PIECE_LINE, MUS_PIECE_ARC, MUS_PIECE_CUBIC, MUS_PIECE_QUADRATIC};
            static const int32_t controls[] = {0, 1, 2, 1};
            double xy[2 * 8];
            for (int i = 0; i < 16; i++) xy[i] = support_uniform(&seed, 2, 3) / 7.0;
            if (p == 2) arc_middle(xy, xy + 4, xy + 2);
            if (p == 1 && k == 1) {
                double ends[4];
                ck_assert_int_eq(mus_pattern_point(pattern, points[p][1], NULL, ends), MUS_OK);
                ck_assert_int_eq(mus_pattern_point(pattern, points[p][2], NULL, ends + 2), MUS_OK);
                arc_middle(ends, ends + 2, xy);
            }
            int32_t npiece = p == 2 ? 4 : 1, n = p == 0 ? 0 : p == 1 ? controls[kinds[k]] : 4 + 3;
            mus_status status =
                mus_pattern_add_edge(pattern, &(mus_edge_def){.size = sizeof(mus_edge_def),
                                                              .name = k == 2 ? "hem" : NULL, .start = points[p][k],
                                                              .end = points[p][(k + 1) % 4], .npiece = npiece,
                                                              .kinds = p == 1 ? &kinds[k] : kinds, .nxy = n,
                                                              .xy = n > 0 ? xy : NULL}, &edges[p][k]);
            ck_assert_msg(status == MUS_OK, "%s", mus_context_error(context));
        }
    for (int p = 0; p < 2; p++) {
        const int32_t backward[4] = {edges[p][3], edges[p][2], edges[p][1], edges[p][0]};
        const int32_t along[4] = {1, 1, 1, 1}, against[4] = {-1, -1, -1, -1};
        ck_assert_int_eq(mus_pattern_set_outline(pattern, p, 4, p == 0 ? edges[0] : backward, p == 0 ? along : against),
                         MUS_OK);
    }

    /* the third panel stays without outline; making up */
    make_up(pattern, &seed, edges);

    /* seams and marks */
    mus_seam_def seam;
    mus_seam_def_init(&seam, sizeof seam);
    for (int k = 0; k < 3; k++) {
        seam.edge_a = edges[0][k], seam.edge_b = edges[1 + k % 2][k];
        seam.direction = k % 2;
        seam.ease = support_uniform(&seed, -1, 1);
        seam.tolerance = k * 1e-3;
        ck_assert_int_eq(mus_pattern_add_seam(pattern, &seam, &index), MUS_OK);
        double length = mus_pattern_edge_length(pattern, edges[1][k]);
        ck_assert_int_eq(mus_pattern_add_notch(pattern, edges[1][k], length * (k / 2.0), k + 1, &index), MUS_OK);
    }
    const double line[6] = {0.1, 0.2, 1.0 / 3.0, 1e-300, -5e5, 0.3};
    ck_assert_int_eq(mus_pattern_add_mark(pattern, 2, "centre front", 3, line, &index), MUS_OK);
    ck_assert_int_eq(mus_pattern_add_mark(pattern, 0, "", 1, line, &index), MUS_OK);
    ck_assert_int_eq(mus_pattern_add_opening(pattern, "a \"quoted\" neck"), MUS_OK);
    mus_pattern *extra;
    ck_assert_int_eq(mus_pattern_create(context, "extra", &extra), MUS_OK);
    ck_assert_int_eq(mus_pattern_add_panel(extra, "facing", &index), MUS_OK);
    ck_assert_int_eq(mus_pattern_add_mark(extra, 0, "fold", 3, line, &index), MUS_OK);
    ck_assert_int_eq(mus_pattern_set_cut_only(pattern, extra), MUS_OK);
    mus_pattern_destroy(extra);
    return pattern;
}


#define SAME(a, b, n) ck_assert_int_eq(memcmp((a), (b), (n) * sizeof *(a)), 0)


static void assert_same_panels(const mus_pattern *a, const mus_pattern *b)
{
    ck_assert_int_eq(mus_pattern_panel_count(a), mus_pattern_panel_count(b));
    for (int32_t i = 0; i < mus_pattern_panel_count(a); i++) {
        double grain[2][2];
        int32_t cut[2], mirror[2], n[2];
        const int32_t *edges[2], *directions[2];
        mus_placement placement[2];
        const mus_pattern *both[2] = {a, b};
        for (int k = 0; k < 2; k++) {
            mus_placement_init(&placement[k], sizeof placement[k]);
            ck_assert_int_eq(mus_pattern_grain(both[k], i, grain[k]), MUS_OK);
            ck_assert_int_eq(mus_pattern_cut(both[k], i, &cut[k], &mirror[k]), MUS_OK);
            ck_assert_int_eq(mus_pattern_outline(both[k], i, &n[k], &edges[k], &directions[k]), MUS_OK);
            ck_assert_int_eq(mus_pattern_placement(both[k], i, &placement[k]), MUS_OK);
        }
        ck_assert_str_eq(mus_pattern_panel_name(a, i), mus_pattern_panel_name(b, i));
        ck_assert_str_eq(mus_pattern_panel_label(a, i), mus_pattern_panel_label(b, i));
        ck_assert_int_eq(mus_pattern_panel_sides(a, i, NULL), mus_pattern_panel_sides(b, i, NULL));
        SAME(grain[0], grain[1], 2);
        ck_assert_int_eq(cut[0], cut[1]);
        ck_assert_int_eq(mirror[0], mirror[1]);
        for (int32_t m = 0; m < MUS_MATERIAL_COUNT; m++) {
            for (int k = 0; k < 2; k++)
                ck_assert_int_eq(mus_pattern_material(both[k], i, m, &cut[k], &mirror[k]), MUS_OK);
            ck_assert(cut[0] == cut[1] && mirror[0] == mirror[1]);
        }
        ck_assert_int_eq(n[0], n[1]);
        if (n[0] > 0) SAME(edges[0], edges[1], (size_t)n[0]);
        if (n[0] > 0) SAME(directions[0], directions[1], (size_t)n[0]);
        SAME(&placement[0], &placement[1], 1);
    }
}


static void assert_same_edges(const mus_pattern *a, const mus_pattern *b)
{
    ck_assert_int_eq(mus_pattern_point_count(a), mus_pattern_point_count(b));
    for (int32_t i = 0; i < mus_pattern_point_count(a); i++) {
        int32_t panel[2];
        double xy[2][2];
        ck_assert_int_eq(mus_pattern_point(a, i, &panel[0], xy[0]), MUS_OK);
        ck_assert_int_eq(mus_pattern_point(b, i, &panel[1], xy[1]), MUS_OK);
        ck_assert_int_eq(panel[0], panel[1]);
        SAME(xy[0], xy[1], 2);
    }
    ck_assert_int_eq(mus_pattern_edge_count(a), mus_pattern_edge_count(b));
    for (int32_t i = 0; i < mus_pattern_edge_count(a); i++) {
        int32_t start[2], end[2], npiece[2], nxy[2];
        const int32_t *kinds[2];
        const double *xy[2];
        ck_assert_int_eq(mus_pattern_edge_ends(a, i, &start[0], &end[0]), MUS_OK);
        ck_assert_int_eq(mus_pattern_edge_ends(b, i, &start[1], &end[1]), MUS_OK);
        ck_assert_int_eq(mus_pattern_edge_pieces(a, i, &npiece[0], &kinds[0], &nxy[0], &xy[0]), MUS_OK);
        ck_assert_int_eq(mus_pattern_edge_pieces(b, i, &npiece[1], &kinds[1], &nxy[1], &xy[1]), MUS_OK);
        ck_assert_int_eq(start[0], start[1]);
        ck_assert_int_eq(end[0], end[1]);
        ck_assert_int_eq(npiece[0], npiece[1]);
        ck_assert_int_eq(nxy[0], nxy[1]);
        SAME(kinds[0], kinds[1], (size_t)npiece[0]);
        SAME(xy[0], xy[1], 2 * (size_t)nxy[0]);
        ck_assert_str_eq(mus_pattern_edge_name(a, i), mus_pattern_edge_name(b, i));
        ck_assert_str_eq(mus_pattern_edge_label(a, i), mus_pattern_edge_label(b, i));
        double allowance[2] = {mus_pattern_edge_allowance(a, i), mus_pattern_edge_allowance(b, i)};
        ck_assert(allowance[0] == allowance[1] || (isnan(allowance[0]) && isnan(allowance[1])));
        double stay[2][3];
        int32_t level[2];
        for (int k = 0; k < 2; k++) {
            ck_assert_int_eq(mus_pattern_edge_hold(k == 0 ? a : b, i, &level[k], &stay[k][0]), MUS_OK);
            ck_assert_int_eq(mus_pattern_edge_elastic(k == 0 ? a : b, i, &stay[k][1], &stay[k][2]), MUS_OK);
        }
        ck_assert_int_eq(level[0], level[1]);
        ck_assert_mem_eq(stay[0], stay[1], sizeof stay[0]);
    }
}


static void assert_same_making(const mus_pattern *a, const mus_pattern *b)
{
    ck_assert_int_eq(mus_pattern_seam_count(a), mus_pattern_seam_count(b));
    for (int32_t i = 0; i < mus_pattern_seam_count(a); i++) {
        mus_seam_def seam[2];
        mus_seam_def_init(&seam[0], sizeof seam[0]);
        mus_seam_def_init(&seam[1], sizeof seam[1]);
        ck_assert_int_eq(mus_pattern_seam(a, i, &seam[0]), MUS_OK);
        ck_assert_int_eq(mus_pattern_seam(b, i, &seam[1]), MUS_OK);
        ck_assert_int_eq(seam[0].edge_a, seam[1].edge_a);
        ck_assert_int_eq(seam[0].edge_b, seam[1].edge_b);
        ck_assert_int_eq(seam[0].direction, seam[1].direction);
        SAME(&seam[0].ease, &seam[1].ease, 1);
        SAME(&seam[0].tolerance, &seam[1].tolerance, 1);
    }
    ck_assert_int_eq(mus_pattern_notch_count(a), mus_pattern_notch_count(b));
    for (int32_t i = 0; i < mus_pattern_notch_count(a); i++) {
        int32_t edge[2], kind[2];
        double s[2];
        ck_assert_int_eq(mus_pattern_notch(a, i, &edge[0], &s[0], &kind[0]), MUS_OK);
        ck_assert_int_eq(mus_pattern_notch(b, i, &edge[1], &s[1], &kind[1]), MUS_OK);
        ck_assert_int_eq(edge[0], edge[1]);
        ck_assert_int_eq(kind[0], kind[1]);
        SAME(&s[0], &s[1], 1);
    }
    ck_assert_int_eq(mus_pattern_mark_count(a), mus_pattern_mark_count(b));
    ck_assert_int_eq(mus_pattern_opening_count(a), mus_pattern_opening_count(b));
    for (int32_t i = 0; i < mus_pattern_opening_count(a); i++)
        ck_assert_str_eq(mus_pattern_opening(a, i), mus_pattern_opening(b, i));
    for (int32_t i = 0; i < mus_pattern_mark_count(a); i++) {
        int32_t panel[2], n[2];
        const char *name[2];
        const double *xy[2];
        ck_assert_int_eq(mus_pattern_mark(a, i, &panel[0], &name[0], &n[0], &xy[0]), MUS_OK);
        ck_assert_int_eq(mus_pattern_mark(b, i, &panel[1], &name[1], &n[1], &xy[1]), MUS_OK);
        ck_assert_int_eq(panel[0], panel[1]);
        ck_assert_int_eq(n[0], n[1]);
        ck_assert_str_eq(name[0], name[1]);
        SAME(xy[0], xy[1], 2 * (size_t)n[0]);
    }
}


/* write, read, compare, write again: the same cells and the same bytes */
static void assert_round_trip(mus_context *context, const mus_pattern *pattern)
{
    char path[512], again[512];
    mus_pattern *back;
    mus_status status = mus_pattern_write(pattern, support_scratch("one.json", path, sizeof path));
    ck_assert_msg(status == MUS_OK, "%s", mus_context_error(context));
    status = mus_pattern_read(context, path, &back);
    ck_assert_msg(status == MUS_OK, "%s", mus_context_error(context));
    ck_assert_str_eq(mus_pattern_name(pattern), mus_pattern_name(back));
    assert_same_panels(pattern, back);
    assert_same_edges(pattern, back);
    assert_same_making(pattern, back);
    ck_assert_int_eq(mus_pattern_write(back, support_scratch("two.json", again, sizeof again)), MUS_OK);
    size_t sizes[2];
    char *texts[2] = {support_slurp(path, &sizes[0]), support_slurp(again, &sizes[1])};
    ck_assert_uint_eq(sizes[0], sizes[1]);
    SAME(texts[0], texts[1], sizes[0]);
    free(texts[0]);
    free(texts[1]);
    mus_pattern_destroy(back);
}


START_TEST(what_is_written_comes_back_bit_for_bit)
{
    mus_context *context = support_context();
    for (uint64_t seed = 0; seed < 100; seed++) {
        mus_pattern *pattern = make_pattern(context, seed);
        assert_round_trip(context, pattern);
        mus_pattern_destroy(pattern);
    }
    support_context_end(context);
}
END_TEST


START_TEST(an_empty_pattern_comes_back)
{
    mus_context *context = support_context();
    mus_pattern *pattern;
    ck_assert_int_eq(mus_pattern_create(context, "", &pattern), MUS_OK);
    assert_round_trip(context, pattern);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


START_TEST(real_patterns_come_back)
{
    static const char *const files[] = {"specs/d11_000_mean_all", "specs/d11_049_mean_female", "originals/shirt_mean",
                                        "originals/dress_pencil"};
    char relative[128], path[512];
    mus_context *context = support_context();
    for (int i = 0; i < 4; i++) {
        mus_pattern *pattern;
        snprintf(relative, sizeof relative, "garmentcode/%s_specification.json", files[i]);
        if (support_data(relative, path, sizeof path) == NULL) break;
        ck_assert_int_eq(mus_pattern_read(context, path, &pattern), MUS_OK);
        assert_round_trip(context, pattern);
        mus_pattern_destroy(pattern);
    }
    support_context_end(context);
}
END_TEST


START_TEST(a_comma_locale_changes_no_byte)
{
    mus_context *context = support_context();
    char path[512], again[512];
    mus_pattern *pattern = make_pattern(context, 7);
    ck_assert_int_eq(mus_pattern_write(pattern, support_scratch("point.json", path, sizeof path)), MUS_OK);
    if (comma_locale()) {
        assert_round_trip(context, pattern);
        ck_assert_int_eq(mus_pattern_write(pattern, support_scratch("comma.json", again, sizeof again)), MUS_OK);
        size_t sizes[2];
        char *texts[2] = {support_slurp(path, &sizes[0]), support_slurp(again, &sizes[1])};
        ck_assert_uint_eq(sizes[0], sizes[1]);
        SAME(texts[0], texts[1], sizes[0]);
        free(texts[0]);
        free(texts[1]);
    }
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


/* a square of one panel, as a person would write it from muslin_pattern(5) */
static const char small[] =
    "{\"muslin_pattern\": 1, \"unit\": \"m\", \"name\": \"square\",\n"
    "\"panels\": [{\"name\": \"front\", \"grain\": [0, 1], \"cut\": 1,\n"
    "\"placement\": {\"origin\": [0, 1, 0], \"rotation\": [1, 0, 0, 0, 1, 0, 0, 0, 1], \"bend\": 0, \"bend_x\": 0},\n"
    "\"outline\": [[0, 1], [1, 1], [2, 1], [3, 1]]}],\n"
    "\"points\": [{\"panel\": 0, \"at\": [0, 0]}, {\"panel\": 0, \"at\": [1, 0]}, {\"panel\": 0, \"at\": [1, 1]},\n"
    "{\"panel\": 0, \"at\": [0, 1]}],\n"
    "\"edges\": [{\"start\": 0, \"end\": 1, \"pieces\": [{\"kind\": \"line\"}]},\n"
    "{\"start\": 1, \"end\": 2, \"pieces\": [{\"kind\": \"line\"}]},\n"
    "{\"start\": 2, \"end\": 3, \"pieces\": [{\"kind\": \"line\"}]},\n"
    "{\"start\": 3, \"end\": 0, \"name\": \"fold\", \"pieces\": [{\"kind\": \"line\"}]}],\n"
    "\"seams\": [{\"a\": 1, \"b\": 3, \"direction\": \"reversed\", \"ease\": 0, \"tolerance\": 0.001}],\n"
    "\"notches\": [{\"edge\": 0, \"kind\": 1, \"s\": 0.5}],\n"
    "\"marks\": [{\"panel\": 0, \"name\": \"dart\", \"points\": [[0.5, 0.5]]}]}\n";

/* texts that are refused, and a part of the message */
static const struct {
    const char *from, *to;
    const char *words;
} damages[] = {
    {"\"muslin_pattern\": 1", "\"muslin_pattern\": 2", "at muslin_pattern: expected an integer in 1 .. 1, got 2"},
    {"\"unit\": \"m\"", "\"unit\": \"cm\"", "at unit: expected \"m\", got \"cm\""},
    {"\"name\": \"square\"", "\"name\": 4", "at name: expected a text, got an integer"},
    {"\"panels\": [", "\"panel\": [", "at panels: expected an array, got nothing"},
    {"\"name\": \"front\"", "\"name\": \"\"", "at panels[0]: "},
    {"\"grain\": [0, 1]", "\"grain\": [0, 0]", "at panels[0].grain: "},
    {"\"grain\": [0, 1]", "\"grain\": [0, NaN]", "small.json:2: expected JSON"},
    {"\"grain\": [0, 1]", "\"grain\": [0, 0,5]", "at panels[0].grain: expected an array of 2 to 2, got 3"},
    {"\"cut\": 1", "\"cut\": 1, \"sides\": \"left\"", "at panels[0].sides: expected an array, got a text"},
    {"\"cut\": 1", "\"cut\": 1, \"sides\": [\"top\"]", "at panels[0].sides[0]: expected front, back, left or right"},
    {"\"cut\": 1", "\"cut\": 1000000000", "at panels[0]: "},
    {"\"cut\": 1", "\"cut\": 1e9", "at panels[0].cut: expected an integer, got a number"},
    {"\"cut\": 1", "\"cut\": 99999999999999999999", "small.json:2: expected JSON"},
    {"\"cut\": 1", "\"cut\": 1, \"mirror_of\": 1", "at panels[0].mirror_of: expected an integer in 0 .. 0, got 1"},
    {"\"rotation\": [1,", "\"rotation\": [-1,", "at panels[0].placement: "},
    {"\"bend\": 0,", "\"bend\": true,", "at panels[0].placement.bend: expected a number, got a truth value"},
    {"[3, 1]", "[2, 1]", "at panels[0].outline: "},
    {"[3, 1]", "[3, 0]", "at panels[0].outline: "},
    {"[3, 1]", "[4, 1]", "at panels[0].outline[3][0]: expected an integer in 0 .. 3, got 4"},
    {"[3, 1]", "[1000000000, 1]", "at panels[0].outline[3][0]"},
    {"\"panel\": 0, \"at\"", "\"panel\": 1, \"at\"", "at points[0].panel: expected an integer in 0 .. 0, got 1"},
    {"\"at\": [1, 0]", "\"at\": [1, 1e400]", "small.json:5: expected JSON"},
    {"\"start\": 0, \"end\": 1", "\"start\": 0, \"end\": 9", "at edges[0].end: expected an integer in 0 .. 3, got 9"},
    {"\"start\": 0, \"end\": 1", "\"start\": 0, \"end\": 0", "at edges[0]: "},
    {"{\"kind\": \"line\"}", "{\"kind\": \"spline\"}", "at edges[0].pieces[0].kind: expected line, quadratic, cubic"},
    {"{\"kind\": \"line\"}", "{\"kind\": \"cubic\"}", "at edges[0].pieces[0].controls: expected an array, got nothing"},
    {"{\"kind\": \"line\"}", "{\"kind\": \"line\", \"controls\": [[0, 0]]}", "at edges[0].pieces[0].controls"},
    {"{\"kind\": \"line\"}", "{\"kind\": \"line\", \"end\": [0, 0]}", "at edges[0].pieces[0].end"},
    {"{\"kind\": \"line\"}", "", "at edges[0].pieces: expected an array of 1"},
    {"\"name\": \"fold\"", "\"allowance\": 7", "at edges[3]: "},
    {"\"name\": \"fold\"", "\"hold\": {\"at\": \"moon\", \"below\": 0}", "at edges[3].hold.at: expected a level"},
    {"\"name\": \"fold\"", "\"hold\": {\"at\": \"hip\"}", "at edges[3].hold.below: "},
    {"\"name\": \"fold\"", "\"hold\": {\"at\": \"hip\", \"below\": 2}", "at edges[3].hold: "},
    {"\"name\": \"fold\"", "\"elastic\": {\"ratio\": 2, \"stiffness\": 1}", "at edges[3].elastic: "},
    {"\"name\": \"fold\"", "\"elastic\": [1, 2]", "at edges[3].elastic: expected an object"},
    {"\"b\": 3", "\"b\": 1", "at seams[0]: "},
    {"\"reversed\"", "\"twisted\"", "at seams[0].direction: expected reversed or direct"},
    {"\"s\": 0.5", "\"s\": 1.5", "at notches[0]: "},
    {"\"edge\": 0", "\"edge\": -1", "at notches[0].edge"},
    {"\"points\": [[0.5, 0.5]]", "\"points\": []", "at marks[0].points: "},
    {"\"points\": [[0.5, 0.5]]", "\"points\": [[0.5]]", "at marks[0].points[0]: "},
    {"\"marks\"", "\"seams\"", "small.json:13: expected JSON: duplicate"},
};


START_TEST(a_fault_is_named_with_its_place)
{
    char text[4096];
    const char *at = strstr(small, damages[_i].from);
    ck_assert_ptr_nonnull(at);
    snprintf(text, sizeof text, "%.*s%s%s", (int)(at - small), small, damages[_i].to, at + strlen(damages[_i].from));
    mus_context *context = support_context();
    mus_pattern *pattern = (mus_pattern *)&context;
    mus_status status = read_text(context, text, &pattern);
    const char *error = mus_context_error(context);
    ck_assert_msg(status == MUS_ERR_FORMAT, "%d: %s", (int)status, error);
    ck_assert_ptr_null(pattern);
    ck_assert_msg(strstr(error, "small.json") != NULL, "%s", error);
    ck_assert_msg(strstr(error, damages[_i].words) != NULL, "no \"%s\" in: %s", damages[_i].words, error);
    support_context_end(context);
}
END_TEST


START_TEST(a_pattern_written_by_hand_is_read)
{
    mus_context *context = support_context();
    mus_pattern *pattern;
    mus_status status = read_text(context, small, &pattern);
    ck_assert_msg(status == MUS_OK, "%s", mus_context_error(context));
    ck_assert_double_eq_tol(mus_pattern_panel_area(pattern, 0), 1.0, 1e-12);
    ck_assert_int_eq(mus_pattern_find_edge(pattern, 0, "fold"), 3);
    assert_round_trip(context, pattern);
    mus_pattern_destroy(pattern);
    ck_assert_int_eq(read_text(context, "[1, 2]", &pattern), MUS_ERR_FORMAT);
    ck_assert_int_eq(read_text(context, "", &pattern), MUS_ERR_FORMAT);
    ck_assert_int_eq(mus_pattern_read(context, NULL, &pattern), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_read(NULL, "a.json", &pattern), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_read(context, "a.json", NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_write(NULL, "a.json"), MUS_ERR_ARG);
    support_context_end(context);
}
END_TEST


START_TEST(a_file_of_panels_without_end_is_refused_in_time)
{
    /* 20000 panels that are whole so far: the reader stops at its limit */
    static const char head[] = "{\"muslin_pattern\": 1, \"unit\": \"m\", \"name\": \"\", \"panels\": [";
    char *text = malloc(20000 * 48 + sizeof head + 2);
    ck_assert_ptr_nonnull(text);
    size_t at = (size_t)sprintf(text, "%s", head);
    for (int i = 0; i < 20000; i++)
        at += (size_t)sprintf(text + at, "%s{\"name\": \"p%d\", \"grain\": [0, 1]}", i > 0 ? "," : "", i);
    memcpy(text + at, "]}", 3);
    mus_context *context = support_context();
    mus_pattern *pattern;
    ck_assert_int_eq(read_text(context, text, &pattern), MUS_ERR_LIMIT);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "at panels[10000]: the limit is 10000 panels"));
    free(text);
    support_context_end(context);
}
END_TEST


START_TEST(the_example_of_the_manual_page_is_read)
{
    char *page = support_slurp("man/muslin_pattern.5", NULL);
    if (page == NULL) {
        printf("skipped: no man/muslin_pattern.5 here\n");
        return;
    }
    char *text = strstr(page, "{\"muslin_pattern\""), *end = strstr(text, ".Ed");
    ck_assert_ptr_nonnull(end);
    *end = '\0';
    mus_context *context = support_context();
    mus_pattern *pattern;
    int32_t faults;
    mus_status status = read_text(context, text, &pattern);
    ck_assert_msg(status == MUS_OK, "%s", mus_context_error(context));
    ck_assert_int_eq(mus_pattern_check(pattern, &faults, NULL), MUS_OK);
    ck_assert_int_eq(faults, 0);
    assert_round_trip(context, pattern);
    mus_pattern_destroy(pattern);
    free(page);
    support_context_end(context);
}
END_TEST


START_TEST(each_allocation_that_fails_is_a_status_and_no_leak)
{
    char path[512];
    support_spill(support_scratch("fail.json", path, sizeof path), small, strlen(small));
    int64_t failed = 0;
    for (int64_t n = 0;; n++) {
        mus_context *context = support_context();
        mus_pattern *pattern = NULL;
        support_fail_after(n, false);
        mus_status status = mus_pattern_read(context, path, &pattern);
        if (status == MUS_OK) status = mus_pattern_write(pattern, path);
        support_fail_never();
        mus_pattern_destroy(pattern);
        support_context_end(context);
        if (status == MUS_OK) break;
        ck_assert_int_eq(status, MUS_ERR_MEMORY);
        failed++;
    }
    ck_assert_int_ge(failed, 15);
}
END_TEST


Suite *mus_suite_pattern_json_read(void);

Suite *mus_suite_pattern_json_read(void)
{
    Suite *suite = suite_create("pattern_json_read");
    TCase *tests = tcase_create("pattern_json");
    tcase_set_timeout(tests, 60);
    tcase_add_test(tests, what_is_written_comes_back_bit_for_bit);
    tcase_add_test(tests, an_empty_pattern_comes_back);
    tcase_add_test(tests, real_patterns_come_back);
    tcase_add_test(tests, a_comma_locale_changes_no_byte);
    tcase_add_loop_test(tests, a_fault_is_named_with_its_place, 0, sizeof damages / sizeof damages[0]);
    tcase_add_test(tests, a_pattern_written_by_hand_is_read);
    tcase_add_test(tests, a_file_of_panels_without_end_is_refused_in_time);
    tcase_add_test(tests, the_example_of_the_manual_page_is_read);
    tcase_add_test(tests, each_allocation_that_fails_is_a_status_and_no_leak);
    suite_add_tcase(suite, tests);
    return suite;
}
