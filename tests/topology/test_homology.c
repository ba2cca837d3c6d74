/*
 * test_homology.c: homology of every garment of the tables, of spaces whose torsion textbooks give, and its laws on
 * random gluings with any number of sheets.
 */
#include <stdlib.h>

#include "muslin/topology.h"
#include "topology/garments.h"
#include "topology/gluing.h"


static mus_homology homology_of(const mus_pattern *pattern, int32_t sewn, int32_t *torsion)
{
    mus_homology h;
    mus_homology_init(&h, sizeof h);
    ck_assert_int_eq(mus_pattern_homology(pattern, sewn, &h, torsion, torsion != NULL ? 8 : 0), MUS_OK);
    return h;
}


START_TEST(garments_have_the_homology_of_the_tables)
{
    const garment *g = &garments[_i];
    for (uint64_t seed = 0; seed < 4; seed++) {
        mus_context *context = support_context();
        mus_pattern *pattern = gluing_make(context, g->panels, g->seams, seed);
        mus_homology h = homology_of(pattern, 1, NULL);
        ck_assert_msg(h.cells[0] == g->vertices && h.cells[1] == g->edges && h.cells[2] == g->faces, "%s", g->name);
        ck_assert_msg(h.betti[0] == g->components && h.betti[1] == g->betti1 && h.betti[2] == g->betti2, "%s: %d %d %d",
                      g->name, (int)h.betti[0], (int)h.betti[1], (int)h.betti[2]);
        ck_assert(h.euler == g->euler && h.torsion == 0);

        /* before sewing: a disc for each panel, or an annulus where a bridge leads to a hole */
        mus_homology cut = homology_of(pattern, 0, NULL);
        int32_t holes = strchr(g->panels, '-') != NULL;
        ck_assert_int_eq(cut.betti[0], g->faces);
        ck_assert_int_eq(cut.betti[1], holes);
        ck_assert_int_eq(cut.betti[2], 0);
        mus_pattern_destroy(pattern);
        support_context_end(context);
    }
}
END_TEST


static const struct {
    const char *name, *panels, *seams;
    int32_t betti[3], ntorsion, torsion[4];
} spaces[] = {
    {"projective plane", "A: a b c d", "A.a A.c direct; A.b A.d direct", {1, 0, 0}, 1, {2}},
    {"Klein bottle", "A: a b c d", "A.a A.c; A.b A.d direct", {1, 1, 0}, 1, {2}},
    {"torus", "A: a b c d", "A.a A.c; A.b A.d", {1, 2, 1}, 0, {0}},
    {"dunce cap of three", "A: a b c", "A.a A.b direct; A.b A.c direct", {1, 0, 0}, 1, {3}},
    {"fours and sixes",
     "A: a b c d; B: a b c d e f",
     "A.a A.b direct; A.b A.c direct; A.c A.d direct; B.a B.b direct; B.b B.c direct; B.c B.d direct; B.d B.e "
     "direct; B.e B.f direct",
     {2, 0, 0},
     2,
     {2, 12}},
    {"book of three pages", "A: a b c; B: a b c; C: a b c", "A.a B.a; B.a C.a", {1, 0, 0}, 0, {0}},
    {"edge folded on itself", "A: a b c; B: a b c", "A.a B.a; A.a B.a direct", {1, 0, 0}, 0, {0}},
};


START_TEST(spaces_have_the_torsion_of_the_textbook)
{
    mus_context *context = support_context();
    mus_pattern *pattern = gluing_make(context, spaces[_i].panels, spaces[_i].seams, 0);
    int32_t torsion[8];
    mus_homology h = homology_of(pattern, 1, torsion);
    ck_assert_msg(memcmp(h.betti, spaces[_i].betti, sizeof h.betti) == 0, "%s: %d %d %d", spaces[_i].name,
                  (int)h.betti[0], (int)h.betti[1], (int)h.betti[2]);
    ck_assert_int_eq(h.torsion, spaces[_i].ntorsion);
    for (int32_t i = 0; i < h.torsion; i++) ck_assert_int_eq(torsion[i], spaces[_i].torsion[i]);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


/* random panels and seams; an edge may be in several, so any number of sheets may meet */
static mus_pattern *pattern_random(mus_context *context, uint64_t *state, bool surface)
{
    char panels[512] = "", seams[1024] = "";
    int32_t side[5], npanel = 1 + (int32_t)(support_random(state) % 5), used[40] = {0};
    for (int32_t p = 0; p < npanel; p++) {
        side[p] = 2 + (int32_t)(support_random(state) % 6);
        sprintf(panels + strlen(panels), "%sP%d:", p > 0 ? ";" : "", (int)p);
        for (int32_t i = 0; i < side[p]; i++) sprintf(panels + strlen(panels), " e%d", (int)i);
    }
    for (int32_t k = (int32_t)(support_random(state) % 12); k > 0; k--) {
        int32_t p = (int32_t)(support_random(state) % (uint64_t)npanel),
                q = (int32_t)(support_random(state) % (uint64_t)npanel);
        int32_t i = (int32_t)(support_random(state) % (uint64_t)side[p]),
                j = (int32_t)(support_random(state) % (uint64_t)side[q]);
        if ((p == q && i == j) || (surface && (used[8 * p + i] || used[8 * q + j]))) continue;
        used[8 * p + i] = used[8 * q + j] = 1;
        sprintf(seams + strlen(seams), "%sP%d.e%d P%d.e%d%s", seams[0] != '\0' ? ";" : "", (int)p, (int)i, (int)q,
                (int)j, support_random(state) % 3 == 0 ? " direct" : "");
    }
    return gluing_make(context, panels, seams, support_random(state));
}


static void check_operators(const mus_pattern *pattern, const mus_homology *h, int32_t sewn)
{
    /* d1 d2 = 0, every index within its cells, and the columns of d1 sum to nothing */
    static int32_t d[2][600][3], product[64][64], sum[64];
    int32_t n[2];
    for (int32_t k = 0; k < 2; k++) {
        ck_assert_int_eq(mus_pattern_boundary(pattern, sewn, k + 1, d[k][0], 600, &n[k]), MUS_OK);
        for (int32_t i = 0; i < n[k]; i++)
            ck_assert(d[k][i][0] >= 0 && d[k][i][0] < h->cells[k] && d[k][i][1] >= 0 && d[k][i][1] < h->cells[k + 1] &&
                      d[k][i][2] != 0);
    }
    memset(product, 0, sizeof product);
    memset(sum, 0, sizeof sum);
    for (int32_t i = 0; i < n[0]; i++) {
        sum[d[0][i][1]] += d[0][i][2];
        for (int32_t j = 0; j < n[1]; j++)
            if (d[0][i][1] == d[1][j][0]) product[d[0][i][0]][d[1][j][1]] += d[0][i][2] * d[1][j][2];
    }
    for (int32_t i = 0; i < 64; i++) {
        ck_assert_int_eq(sum[i], 0);
        for (int32_t j = 0; j < 64; j++) ck_assert_int_eq(product[i][j], 0);
    }
}


START_TEST(homology_of_random_gluings_keeps_its_laws)
{
    uint64_t state = 1895;
    int32_t twisted = 0, folded = 0;
    for (int32_t sample = 0; sample < 1500; sample++) {
        mus_context *context = support_context();
        mus_pattern *pattern = pattern_random(context, &state, sample % 2 == 0);
        mus_topology t;
        mus_topology_init(&t, sizeof t);
        ck_assert_int_eq(mus_pattern_topology(pattern, &t), MUS_OK);
        for (int32_t sewn = 0; sewn < 2; sewn++) {
            mus_homology h = homology_of(pattern, sewn, NULL);
            check_operators(pattern, &h, sewn);
            ck_assert_int_eq(h.betti[0] - h.betti[1] + h.betti[2], h.euler);
            ck_assert_int_eq(h.cells[0] - h.cells[1] + h.cells[2], h.euler);
            if (!sewn) continue;
            ck_assert_int_eq(h.euler, t.euler);
            ck_assert_int_eq(h.betti[0], t.components);
            folded += h.cells[0] != t.vertices;

            /* one piece that is a surface: b2 says closed and two-sided, torsion 2 closed and one-sided */
            if (t.components != 1 || !t.manifold) continue;
            ck_assert_int_eq(h.betti[2], t.loops == 0 && t.orientable);
            ck_assert_int_eq(h.torsion, t.loops == 0 && !t.orientable);
            twisted += h.torsion;
            if (t.orientable && t.loops > 0) ck_assert_int_eq(h.betti[1], 2 * t.genus + t.loops - 1);
        }
        mus_pattern_destroy(pattern);
        support_context_end(context);
    }
    ck_assert_int_eq(folded, 0);
    ck_assert_int_gt(twisted, 5);
}
END_TEST


START_TEST(homology_refuses_with_a_sentence)
{
    mus_context *context = support_context();
    mus_pattern *pattern = gluing_make(context, "F: hem a waist b", "F.a F.b", 0);
    mus_homology h = {.size = 8};
    int32_t n = 7, panel;
    ck_assert_int_eq(mus_pattern_homology(NULL, 1, &h, NULL, 0), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_homology(pattern, 1, NULL, NULL, 0), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_homology(pattern, 1, &h, NULL, 0), MUS_ERR_VERSION);
    ck_assert_int_eq(mus_pattern_homology(pattern, 1, &h, &n, -1), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_boundary(NULL, 1, 1, NULL, 0, &n), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_boundary(pattern, 1, 0, NULL, 0, &n), MUS_ERR_ARG);
    ck_assert_int_eq(n, 0);
    ck_assert_str_eq(mus_context_error(context), "boundary: dimension 0 is neither 1 nor 2");
    ck_assert_int_eq(mus_pattern_boundary(pattern, 1, 3, NULL, 0, &n), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_boundary(pattern, 1, 2, NULL, 0, &n), MUS_OK);
    ck_assert_int_eq(n, 2);
    ck_assert_int_eq(mus_pattern_add_panel(pattern, "sleeve", &panel), MUS_OK);
    mus_homology_init(&h, sizeof h);
    ck_assert_int_eq(mus_pattern_homology(pattern, 1, &h, NULL, 0), MUS_ERR_PATTERN);
    ck_assert_str_eq(mus_context_error(context), "panel sleeve has no outline");
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


START_TEST(failing_allocations_leave_nothing)
{
    for (int64_t n = 0;; n++) {
        mus_context *context = support_context();
        mus_pattern *pattern = gluing_make(context, "A: a b c d; B: a b c d", "A.a B.a; A.b B.b direct", 0);
        mus_homology h;
        mus_homology_init(&h, sizeof h);
        support_fail_after(n, false);
        mus_status status = mus_pattern_homology(pattern, 1, &h, NULL, 0);
        support_fail_never();
        mus_pattern_destroy(pattern);
        support_context_end(context);
        if (status == MUS_OK) break;
        ck_assert_int_eq(status, MUS_ERR_MEMORY);
    }
}
END_TEST


Suite *mus_suite_homology(void);


Suite *mus_suite_homology(void)
{
    Suite *suite = suite_create("homology");
    TCase *tcase = tcase_create("homology");
    tcase_set_timeout(tcase, 60);
    tcase_add_loop_test(tcase, garments_have_the_homology_of_the_tables, 0, GARMENTS);
    tcase_add_loop_test(tcase, spaces_have_the_torsion_of_the_textbook, 0, (int)(sizeof spaces / sizeof spaces[0]));
    tcase_add_test(tcase, homology_of_random_gluings_keeps_its_laws);
    tcase_add_test(tcase, homology_refuses_with_a_sentence);
    tcase_add_test(tcase, failing_allocations_leave_nothing);
    suite_add_tcase(suite, tcase);
    return suite;
}
