/*
 * test_topology.c: the surface that seams make, against two independent programs (garments.h), against a brute count on
 * a triangulation for 1000 random gluings, and under relabelling.
 */
#include <stdlib.h>

#include "muslin/topology.h"
#include "topology/garments.h"
#include "topology/gluing.h"

#define PANELS 6
#define SIDES 8
#define CELLS (PANELS * 4 * SIDES) /* cells of one kind of the triangulation */


static mus_topology topology_of(const mus_pattern *pattern)
{
    mus_topology t;
    mus_topology_init(&t, sizeof t);
    ck_assert_int_eq(mus_pattern_topology(pattern, &t), MUS_OK);
    return t;
}


START_TEST(garments_have_the_topology_that_two_other_programs_found)
{
    const garment *g = &garments[_i];
    for (uint64_t seed = 0; seed < 5; seed++) {
        mus_context *context = support_context();
        mus_pattern *pattern = gluing_make(context, g->panels, g->seams, seed);
        mus_topology t = topology_of(pattern);
        ck_assert_msg(t.vertices == g->vertices && t.edges == g->edges && t.faces == g->faces && t.euler == g->euler,
                      "%s: V E F chi %d %d %d %d, expected %d %d %d %d", g->name, t.vertices, t.edges, t.faces, t.euler,
                      g->vertices, g->edges, g->faces, g->euler);
        ck_assert_msg(t.components == g->components && t.loops == g->loops, "%s: %d pieces, %d loops", g->name,
                      t.components, t.loops);
        ck_assert_msg(t.orientable == g->orientable && t.manifold == g->manifold && t.genus == g->genus,
                      "%s: orientable %d manifold %d genus %d", g->name, t.orientable, t.manifold, t.genus);
        mus_pattern_destroy(pattern);
        support_context_end(context);
    }
}
END_TEST


START_TEST(loops_list_the_rim_edges_that_another_program_walked)
{
    const garment *g = &garments[_i];
    if (g->rims == NULL) return;
    mus_context *context = support_context();
    mus_pattern *pattern = gluing_make(context, g->panels, g->seams, 0);
    mus_topology t = topology_of(pattern);
    char text[2048] = "";
    int32_t edges[64], n;
    double length;
    for (int32_t loop = 0; loop < t.loops; loop++) {
        ck_assert_int_eq(mus_pattern_loop(pattern, loop, edges, 64, &n, &length), MUS_OK);
        double sum = 0.0;
        if (loop > 0) strcat(text, " | ");
        for (int32_t i = 0; i < n; i++) {
            sum += mus_pattern_edge_length(pattern, edges[i]);
            sprintf(text + strlen(text), "%s%s.%s", i > 0 ? " " : "",
                    mus_pattern_panel_name(pattern, mus_pattern_edge_panel(pattern, edges[i])),
                    mus_pattern_edge_name(pattern, edges[i]));
        }
        ck_assert_double_eq_tol(length, sum, 1e-14);
    }
    ck_assert_str_eq(text, g->rims);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


/* ---- random gluings ---- */

typedef struct gluing {
    int32_t npanel, side[PANELS], nseam;
    int32_t seam[PANELS * SIDES][5]; /* panel, side, panel, side, 1 when start meets start along the words */
} gluing;


static gluing gluing_random(uint64_t *state)
{
    gluing g = {0};
    int32_t all[PANELS * SIDES][2], n = 0;
    g.npanel = 1 + (int32_t)(support_random(state) % 5);
    for (int32_t p = 0; p < g.npanel; p++) {
        g.side[p] = 1 + (int32_t)(support_random(state) % (SIDES - 1));
        for (int32_t i = 0; i < g.side[p]; i++, n++) all[n][0] = p, all[n][1] = i;
    }
    for (int32_t i = n - 1; i > 0; i--) {
        int32_t j = (int32_t)(support_random(state) % (uint64_t)(i + 1)), keep[2] = {all[i][0], all[i][1]};
        all[i][0] = all[j][0], all[i][1] = all[j][1];
        all[j][0] = keep[0], all[j][1] = keep[1];
    }
    g.nseam = (int32_t)(support_random(state) % (uint64_t)(n / 2 + 1));
    bool twists = support_random(state) % 2 == 0;
    for (int32_t i = 0; i < g.nseam; i++) {
        int32_t *s = g.seam[i];
        s[0] = all[2 * i][0], s[1] = all[2 * i][1], s[2] = all[2 * i + 1][0], s[3] = all[2 * i + 1][1];
        s[4] = twists && support_random(state) % 3 == 0;
    }
    return g;
}


/* the same gluing with panels in another order, words begun elsewhere, sides of seams and seams exchanged */
static gluing gluing_relabelled(const gluing *g, uint64_t *state)
{
    gluing r = *g;
    int32_t to[PANELS], shift[PANELS];
    int32_t turn = (int32_t)(support_random(state) % (uint64_t)g->npanel);
    for (int32_t p = 0; p < g->npanel; p++) {
        to[p] = (g->npanel - 1 - p + turn) % g->npanel;
        shift[p] = (int32_t)(support_random(state) % (uint64_t)g->side[p]);
        r.side[to[p]] = g->side[p];
    }
    for (int32_t i = 0; i < g->nseam; i++) {
        const int32_t *s = g->seam[g->nseam - 1 - i];
        int32_t a = support_random(state) % 2 == 0 ? 0 : 2, b = 2 - a;
        int32_t seam[5] = {to[s[a]], (s[a + 1] + shift[s[a]]) % g->side[s[a]], to[s[b]],
                           (s[b + 1] + shift[s[b]]) % g->side[s[b]], s[4]};
        memcpy(r.seam[i], seam, sizeof seam);
    }
    return r;
}


static mus_pattern *gluing_pattern(mus_context *context, const gluing *g, uint64_t seed)
{
    char panels[1024] = "", seams[2048] = "";
    for (int32_t p = 0; p < g->npanel; p++) {
        sprintf(panels + strlen(panels), "%sP%d:", p > 0 ? ";" : "", (int)p);
        for (int32_t i = 0; i < g->side[p]; i++) sprintf(panels + strlen(panels), " e%d", (int)i);
    }
    for (int32_t i = 0; i < g->nseam; i++) {
        const int32_t *s = g->seam[i];
        sprintf(seams + strlen(seams), "%sP%d.e%d P%d.e%d%s", i > 0 ? ";" : "", (int)s[0], (int)s[1], (int)s[2],
                (int)s[3], s[4] ? " direct" : "");
    }
    return gluing_make(context, panels, seams, seed);
}


/* ---- the brute count ----
 * Each n-gon becomes 2n triangles round a centre; half i0 of side i runs from its corner to its middle, half i1 on to
 * the next corner. Cells: vertices centre, corners, middles; edges spokes and halves. Classes by relabelling. */

static int32_t at_corner(int32_t p, int32_t i)
{
    return p * (2 * SIDES + 1) + 1 + i;
}
static int32_t at_middle(int32_t p, int32_t i)
{
    return p * (2 * SIDES + 1) + 1 + SIDES + i;
}
static int32_t at_half(int32_t p, int32_t i, int32_t h)
{
    return (p * SIDES + i) * 2 + h;
}


static bool same(int32_t *label, int32_t a, int32_t b)
{
    int32_t low = label[a] < label[b] ? label[a] : label[b];
    bool changed = label[a] != label[b];
    label[a] = label[b] = low;
    return changed;
}


static int32_t classes(const int32_t *label, const bool *used, int32_t n)
{
    bool seen[CELLS] = {false};
    int32_t count = 0;
    for (int32_t i = 0; i < n; i++) {
        if (!used[i] || seen[label[i]]) continue;
        seen[label[i]] = true;
        count++;
    }
    return count;
}


typedef struct brute {
    int32_t vertex[CELLS], half[CELLS];
    bool vertex_used[CELLS], half_used[CELLS];
    int32_t from[CELLS], to[CELLS], panel[CELLS]; /* by half */
} brute;


static void brute_glue(const gluing *g, brute *b)
{
    memset(b, 0, sizeof *b);
    for (int32_t i = 0; i < CELLS; i++) b->vertex[i] = b->half[i] = i;
    for (int32_t p = 0; p < g->npanel; p++) {
        b->vertex_used[p * (2 * SIDES + 1)] = true;
        for (int32_t i = 0; i < g->side[p]; i++) {
            int32_t h0 = at_half(p, i, 0), h1 = at_half(p, i, 1), next = (i + 1) % g->side[p];
            b->vertex_used[at_corner(p, i)] = b->vertex_used[at_middle(p, i)] = true;
            b->half_used[h0] = b->half_used[h1] = true;
            b->from[h0] = at_corner(p, i), b->to[h0] = b->from[h1] = at_middle(p, i), b->to[h1] = at_corner(p, next);
            b->panel[h0] = b->panel[h1] = p;
        }
    }
    for (bool again = true; again;) {
        again = false;
        for (int32_t k = 0; k < g->nseam; k++) {
            const int32_t *s = g->seam[k];
            int32_t i2 = (s[1] + 1) % g->side[s[0]], j2 = (s[3] + 1) % g->side[s[2]];
            int32_t a0 = at_corner(s[0], s[1]), a1 = at_corner(s[0], i2);
            int32_t b0 = at_corner(s[2], s[3]), b1 = at_corner(s[2], j2);
            again |= same(b->vertex, at_middle(s[0], s[1]), at_middle(s[2], s[3]));
            again |= same(b->vertex, a0, s[4] ? b0 : b1);
            again |= same(b->vertex, a1, s[4] ? b1 : b0);
            again |= same(b->half, at_half(s[0], s[1], 0), at_half(s[2], s[3], s[4] ? 0 : 1));
            again |= same(b->half, at_half(s[0], s[1], 1), at_half(s[2], s[3], s[4] ? 1 : 0));
        }
    }
}


/* do halves i and j lie on one another? */
static bool brute_glued(const brute *b, int32_t i, int32_t j)
{
    return i != j && b->half_used[i] && b->half_used[j] && b->half[i] == b->half[j];
}


/* number of pieces; panel (PANELS) gets the lowest panel of each one's piece */
static int32_t brute_pieces(const gluing *g, const brute *b, int32_t *panel)
{
    bool used[CELLS] = {false};
    for (int32_t p = 0; p < g->npanel; p++) panel[p] = p, used[p] = true;
    for (bool again = true; again;) {
        again = false;
        for (int32_t i = 0; i < CELLS; i++) {
            for (int32_t j = 0; j < CELLS; j++) {
                if (brute_glued(b, i, j)) again |= same(panel, b->panel[i], b->panel[j]);
            }
        }
    }
    return classes(panel, used, g->npanel);
}


/* spread a side from the lowest panel of each piece: triangles agree when they pass the half they share in opposite
 * directions */
static bool brute_orientable(const gluing *g, const brute *b, const int32_t *panel)
{
    int32_t side[PANELS] = {0};
    bool fits = true;
    for (int32_t p = 0; p < g->npanel; p++) side[p] = panel[p] == p;
    for (bool again = true; again;) {
        again = false;
        for (int32_t i = 0; i < CELLS; i++) {
            for (int32_t j = 0; j < CELLS; j++) {
                if (!brute_glued(b, i, j)) continue;
                bool opposite = b->vertex[b->from[i]] == b->vertex[b->to[j]];
                int32_t *u = &side[b->panel[i]], *v = &side[b->panel[j]];
                if (*u == 0 && *v != 0) *u = opposite ? *v : -*v, again = true;
                if (*u != 0 && *v != 0 && *u != (opposite ? *v : -*v)) fits = false;
            }
        }
    }
    return fits;
}


/* rims: halves with one triangle, joined where they touch */
static int32_t brute_rims(const brute *b)
{
    int32_t rim[CELLS];
    bool open[CELLS];
    for (int32_t i = 0; i < CELLS; i++) {
        rim[i] = i;
        open[i] = b->half_used[i];
        for (int32_t j = 0; j < CELLS; j++) open[i] = open[i] && !brute_glued(b, i, j);
    }
    for (bool again = true; again;) {
        again = false;
        for (int32_t i = 0; i < CELLS; i++) {
            for (int32_t j = 0; j < CELLS && open[i]; j++) {
                const int32_t *v = b->vertex;
                bool touch =
                    v[b->to[i]] == v[b->to[j]] || v[b->from[i]] == v[b->to[j]] || v[b->from[i]] == v[b->from[j]];
                if (open[j] && touch) again |= same(rim, i, j);
            }
        }
    }
    return classes(rim, open, CELLS);
}


static void check_against_brute(const mus_pattern *pattern, const gluing *g)
{
    static brute b;
    brute_glue(g, &b);
    int32_t spokes = 0, panel[CELLS];
    for (int32_t p = 0; p < g->npanel; p++) spokes += 2 * g->side[p];
    int32_t pieces = brute_pieces(g, &b, panel), rims = brute_rims(&b);
    bool orientable = brute_orientable(g, &b, panel);
    int32_t triangles = spokes;
    int32_t euler = classes(b.vertex, b.vertex_used, CELLS) - spokes - classes(b.half, b.half_used, CELLS) + triangles;

    mus_topology t = topology_of(pattern);
    ck_assert_int_eq(t.euler, euler);
    ck_assert_int_eq(t.components, pieces);
    ck_assert_int_eq(t.orientable, orientable);
    ck_assert_int_eq(t.loops, rims);
    ck_assert_int_eq(t.manifold, 1);
    ck_assert_int_eq(t.edges, spokes / 2 - g->nseam);
    ck_assert_int_eq(t.faces, g->npanel);
    if (pieces == 1 && orientable) ck_assert_int_eq(2 - 2 * t.genus - rims, euler);
    if (pieces != 1 || !orientable) ck_assert_int_eq(t.genus, MUS_NONE);
}


START_TEST(random_gluings_agree_with_a_count_on_triangles_under_any_labels)
{
    uint64_t state = 20050711;
    for (int32_t sample = 0; sample < 1000; sample++) {
        mus_context *context = support_context();
        gluing g = gluing_random(&state);
        mus_pattern *pattern = gluing_pattern(context, &g, 0);
        check_against_brute(pattern, &g);

        gluing r = gluing_relabelled(&g, &state);
        mus_pattern *other = gluing_pattern(context, &r, support_random(&state));
        mus_topology t = topology_of(pattern), u = topology_of(other);
        ck_assert_mem_eq(&t, &u, sizeof t);
        mus_pattern_destroy(pattern);
        mus_pattern_destroy(other);
        support_context_end(context);
    }
}
END_TEST


START_TEST(every_rim_edge_is_in_one_loop_once)
{
    uint64_t state = 8;
    for (int32_t sample = 0; sample < 200; sample++) {
        mus_context *context = support_context();
        gluing g = gluing_random(&state);
        mus_pattern *pattern = gluing_pattern(context, &g, support_random(&state));
        int32_t seen[PANELS * SIDES] = {0}, edges[PANELS * SIDES], n, total = 0;
        for (int32_t loop = 0; loop < topology_of(pattern).loops; loop++) {
            ck_assert_int_eq(mus_pattern_loop(pattern, loop, edges, PANELS * SIDES, &n, NULL), MUS_OK);
            for (int32_t i = 0; i < n; i++) {
                ck_assert_int_eq(seen[edges[i]]++, 0);
                ck_assert_int_eq(mus_pattern_edge_seam(pattern, edges[i]), MUS_NONE);
            }
            total += n;
        }
        ck_assert_int_eq(total, mus_pattern_edge_count(pattern) - 2 * g.nseam);
        mus_pattern_destroy(pattern);
        support_context_end(context);
    }
}
END_TEST


START_TEST(turning_a_word_round_changes_nothing)
{
    /* the other side of one panel becomes its right side: same surface */
    uint64_t state = 77;
    for (int32_t sample = 0; sample < 200; sample++) {
        mus_context *context = support_context();
        gluing g = gluing_random(&state);
        mus_pattern *pattern = gluing_pattern(context, &g, 0);
        mus_topology before = topology_of(pattern);
        int32_t panel = (int32_t)(support_random(&state) % (uint64_t)g.npanel), n, word[SIDES], turn[SIDES];
        const int32_t *edges, *directions;
        ck_assert_int_eq(mus_pattern_outline(pattern, panel, &n, &edges, &directions), MUS_OK);
        for (int32_t i = 0; i < n; i++) word[i] = edges[n - 1 - i], turn[i] = -directions[n - 1 - i];
        ck_assert_int_eq(mus_pattern_set_outline(pattern, panel, n, word, turn), MUS_OK);
        mus_topology after = topology_of(pattern);
        ck_assert_mem_eq(&before, &after, sizeof before);
        mus_pattern_destroy(pattern);
        support_context_end(context);
    }
}
END_TEST


START_TEST(an_edge_dart_adds_two_points_and_two_edges)
{
    /* waist -> w1 d1 d2 w2 with d1 ~ d2: three edges more, one seam: (V, E, F) + (2, 2, 0); sewn and unsewn */
    const char *plain = "F: hem sideL waist sideR; B: hem sideR waist sideL",
               *sides = "F.sideL B.sideL; F.sideR B.sideR";
    const char *dart = "F: hem sideL w1 d1 d2 w2 sideR; B: hem sideR waist sideL";
    mus_context *context = support_context();
    mus_pattern *a = gluing_make(context, plain, sides, 0);
    mus_pattern *b = gluing_make(context, dart, "F.sideL B.sideL; F.sideR B.sideR; F.d1 F.d2", 0);
    mus_pattern *c = gluing_make(context, dart, sides, 0);
    mus_topology t = topology_of(a), u = topology_of(b), v = topology_of(c);
    ck_assert(t.vertices == 4 && t.edges == 6 && t.faces == 2 && t.euler == 0 && t.loops == 2);
    ck_assert(u.vertices == 6 && u.edges == 8 && u.faces == 2 && u.euler == 0 && u.loops == 2);
    ck_assert(v.vertices == 7 && v.edges == 9 && v.faces == 2 && v.euler == 0 && v.loops == 2);
    mus_pattern_destroy(a);
    mus_pattern_destroy(b);
    mus_pattern_destroy(c);
    support_context_end(context);
}
END_TEST


START_TEST(an_empty_pattern_is_the_empty_surface)
{
    mus_context *context = support_context();
    mus_pattern *pattern;
    ck_assert_int_eq(mus_pattern_create(context, "", &pattern), MUS_OK);
    mus_topology t = topology_of(pattern);
    ck_assert(t.vertices == 0 && t.edges == 0 && t.faces == 0 && t.euler == 0 && t.components == 0 && t.loops == 0);
    ck_assert(t.orientable == 1 && t.manifold == 1 && t.genus == MUS_NONE);
    ck_assert_int_eq(mus_pattern_loop(pattern, 0, NULL, 0, NULL, NULL), MUS_ERR_ARG);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


START_TEST(what_has_no_answer_is_refused_with_a_sentence)
{
    mus_context *context = support_context();
    mus_pattern *pattern = gluing_make(context, "F: hem a waist b", "F.a F.b", 0);
    mus_topology t = {.size = 8};
    int32_t n = 7, edges[4];
    ck_assert_int_eq(mus_pattern_topology(NULL, &t), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_topology(pattern, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_topology(pattern, &t), MUS_ERR_VERSION);
    ck_assert_int_eq(mus_pattern_loop(pattern, 2, NULL, 0, &n, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(n, 0);
    ck_assert_str_eq(mus_context_error(context), "loop 2 is unknown, the pattern has 2");
    ck_assert_int_eq(mus_pattern_loop(pattern, -1, NULL, 0, &n, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_loop(pattern, 0, edges, -1, &n, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_loop(NULL, 0, NULL, 0, &n, NULL), MUS_ERR_ARG);

    /* a loop in less room than it needs: what fits is written, the count is whole */
    edges[0] = edges[1] = -7;
    ck_assert_int_eq(mus_pattern_loop(pattern, 1, edges, 0, &n, NULL), MUS_OK);
    ck_assert_int_eq(n, 1);
    ck_assert_int_eq(edges[0], -7);

    int32_t panel;
    ck_assert_int_eq(mus_pattern_add_panel(pattern, "sleeve", &panel), MUS_OK);
    mus_topology_init(&t, sizeof t);
    ck_assert_int_eq(mus_pattern_topology(pattern, &t), MUS_ERR_PATTERN);
    ck_assert_str_eq(mus_context_error(context), "panel sleeve has no outline");
    ck_assert_int_eq(mus_pattern_loop(pattern, 0, NULL, 0, &n, NULL), MUS_ERR_PATTERN);
    mus_pattern_destroy(pattern);

    pattern = gluing_make(context, "A: a b c; B: a b c; C: a b c", "A.a B.a; B.a C.a", 0);
    ck_assert_int_eq(mus_pattern_loop(pattern, 0, NULL, 0, &n, NULL), MUS_ERR_PATTERN);
    ck_assert_str_eq(mus_context_error(context), "loop 0: more than two sheets meet at A.a");
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_topology(void);


Suite *mus_suite_topology(void)
{
    Suite *suite = suite_create("topology");
    TCase *tcase = tcase_create("topology");
    tcase_set_timeout(tcase, 60);
    tcase_add_loop_test(tcase, garments_have_the_topology_that_two_other_programs_found, 0, GARMENTS);
    tcase_add_loop_test(tcase, loops_list_the_rim_edges_that_another_program_walked, 0, GARMENTS);
    tcase_add_test(tcase, random_gluings_agree_with_a_count_on_triangles_under_any_labels);
    tcase_add_test(tcase, every_rim_edge_is_in_one_loop_once);
    tcase_add_test(tcase, turning_a_word_round_changes_nothing);
    tcase_add_test(tcase, an_edge_dart_adds_two_points_and_two_edges);
    tcase_add_test(tcase, an_empty_pattern_is_the_empty_surface);
    tcase_add_test(tcase, what_has_no_answer_is_refused_with_a_sentence);
    suite_add_tcase(suite, tcase);
    return suite;
}
