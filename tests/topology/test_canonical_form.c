/*
 * test_canonical_form.c: the canonical form of a pattern against a search for isomorphisms by hand: 10,000
 * relabellings keep it, and 10,000 single changes change it exactly when the search says that the patterns differ.
 *
 * The search knows nothing of flags, colours or walks: it glues edges by relabelling and tries every panel for every
 * panel at every rotation.
 */
#include <stdlib.h>

#include "muslin/topology.h"
#include "topology/garments.h"
#include "topology/gluing.h"

#define PANELS 6
#define SIDES 7
#define CELLS (PANELS * SIDES)
#define SEAMS 24

typedef struct complex {
    int32_t npanel, side[PANELS], nseam;
    int32_t panel_label[PANELS], edge_label[CELLS]; /* 0: none; side i of panel p is p * SIDES + i */
    int32_t seam[SEAMS][3];                         /* side, side, 1 when start meets start along the words */
} complex;


/* ---- random complexes and what is done to them ---- */

static int32_t below(uint64_t *state, int32_t n)
{
    return (int32_t)(support_random(state) % (uint64_t)n);
}


static int32_t any_side(const complex *c, uint64_t *state)
{
    int32_t p = below(state, c->npanel);
    return p * SIDES + below(state, c->side[p]);
}


static bool is_sewn(const complex *c, int32_t side)
{
    for (int32_t i = 0; i < c->nseam; i++)
        if (c->seam[i][0] == side || c->seam[i][1] == side) return true;
    return false;
}


static bool add_seam(complex *c, bool any, uint64_t *state)
{
    int32_t a = any_side(c, state), b = any_side(c, state);
    if (a == b || c->nseam >= SEAMS || (!any && (is_sewn(c, a) || is_sewn(c, b)))) return false;
    int32_t seam[3] = {a, b, below(state, 4) == 0};
    memcpy(c->seam[c->nseam++], seam, sizeof seam);
    return true;
}


/* `alike`: panels of the same number of sides, so that much symmetry is about; `sheets`: edges in several seams */
static complex complex_random(uint64_t *state, bool alike, bool sheets)
{
    complex c = {0};
    c.npanel = 1 + below(state, PANELS - 1);
    int32_t side = 2 + below(state, 4);
    for (int32_t p = 0; p < c.npanel; p++) {
        c.side[p] = alike ? side : 1 + below(state, SIDES - 1);
        c.panel_label[p] = below(state, 5) == 0;
        for (int32_t i = 0; i < c.side[p]; i++)
            c.edge_label[p * SIDES + i] = below(state, 8) == 0 ? 1 + below(state, 2) : 0;
    }
    for (int32_t k = below(state, 3 * c.npanel + 1); k > 0; k--) add_seam(&c, sheets && below(state, 3) == 0, state);
    return c;
}


/* side i of panel p becomes side to_side of panel to[p], each word shifted; seams in another order */
static complex complex_relabelled(const complex *c, uint64_t *state)
{
    complex r = {.npanel = c->npanel, .nseam = c->nseam};
    int32_t to[PANELS], shift[PANELS], order[SEAMS];
    for (int32_t p = 0; p < c->npanel; p++) to[p] = p, shift[p] = below(state, c->side[p]);
    for (int32_t i = 0; i < c->nseam; i++) order[i] = i;
    for (int32_t p = c->npanel - 1; p > 0; p--) {
        int32_t q = below(state, p + 1), keep = to[p];
        to[p] = to[q], to[q] = keep;
    }
    for (int32_t i = c->nseam - 1; i > 0; i--) {
        int32_t j = below(state, i + 1), keep = order[i];
        order[i] = order[j], order[j] = keep;
    }
    int32_t place[CELLS];
    for (int32_t p = 0; p < c->npanel; p++) {
        r.side[to[p]] = c->side[p];
        r.panel_label[to[p]] = c->panel_label[p];
        for (int32_t i = 0; i < c->side[p]; i++) {
            place[p * SIDES + i] = to[p] * SIDES + (i + shift[p]) % c->side[p];
            r.edge_label[place[p * SIDES + i]] = c->edge_label[p * SIDES + i];
        }
    }
    for (int32_t i = 0; i < c->nseam; i++) {
        const int32_t *s = c->seam[order[i]];
        int32_t first = below(state, 2), seam[3] = {place[s[first]], place[s[1 - first]], s[2]};
        memcpy(r.seam[i], seam, sizeof seam);
    }
    return r;
}


/* the word of one panel, or with MUS_NONE of all, is read from the other side */
static complex complex_turned(const complex *c, int32_t panel)
{
    complex r = *c;
    for (int32_t p = 0; p < c->npanel; p++) {
        if (panel != MUS_NONE && p != panel) continue;
        for (int32_t i = 0; i < c->side[p]; i++)
            r.edge_label[p * SIDES + i] = c->edge_label[p * SIDES + c->side[p] - 1 - i];
        for (int32_t k = 0; k < c->nseam; k++)
            for (int32_t j = 0; j < 2; j++) {
                if (c->seam[k][j] / SIDES != p) continue;
                r.seam[k][j] = p * SIDES + c->side[p] - 1 - c->seam[k][j] % SIDES;
                r.seam[k][2] = !r.seam[k][2];
            }
    }
    return r;
}


/* one change: a seam added, dropped, flipped or moved, a panel turned, a label given, two panels exchanged */
static complex complex_changed(const complex *c, bool sheets, uint64_t *state)
{
    complex r = *c;
    int32_t what = below(state, 7), k = c->nseam > 0 ? below(state, c->nseam) : 0;
    if (what == 0 || c->nseam == 0) {
        add_seam(&r, sheets, state);
    } else if (what == 1) {
        memcpy(r.seam[k], r.seam[--r.nseam], sizeof r.seam[k]);
    } else if (what == 2) {
        r.seam[k][2] = !r.seam[k][2];
    } else if (what == 3) {
        return complex_turned(c, below(state, c->npanel));
    } else if (what == 4) {
        int32_t side = any_side(&r, state);
        r.edge_label[side] = (r.edge_label[side] + 1) % 3;
    } else if (what == 5) {
        memcpy(r.seam[k], r.seam[--r.nseam], sizeof r.seam[k]);
        add_seam(&r, sheets, state);
    } else {
        int32_t side = any_side(&r, state);
        if (side != r.seam[k][1] && (sheets || !is_sewn(&r, side))) r.seam[k][0] = side;
    }
    return r;
}


/* ---- the search ---- */

typedef struct glued {
    int32_t root[CELLS], sign[CELLS];
    bool fold[CELLS]; /* by root */
} glued;


static glued glue(const complex *c)
{
    glued g;
    for (int32_t i = 0; i < CELLS; i++) g.root[i] = i, g.sign[i] = 1, g.fold[i] = false;
    for (int32_t k = 0; k < c->nseam; k++) {
        int32_t a = c->seam[k][0], b = c->seam[k][1], way = (c->seam[k][2] ? 1 : -1) * g.sign[a] * g.sign[b];
        int32_t from = g.root[b], to = g.root[a];
        if (from == to) {
            if (way < 0) g.fold[to] = true;
            continue;
        }
        g.fold[to] = g.fold[to] || g.fold[from];
        for (int32_t i = 0; i < CELLS; i++)
            if (g.root[i] == from) g.root[i] = to, g.sign[i] *= way;
    }
    return g;
}


typedef struct search {
    const complex *a, *b;
    glued ga, gb;
    int32_t image[CELLS], set[CELLS], nset;
    bool used[PANELS], mirror;
} search;


/* does side `x` of a fit its image beside all that were set before it? */
static bool fits(const search *s, int32_t x)
{
    int32_t y = s->image[x];
    if (s->a->edge_label[x] != s->b->edge_label[y]) return false;
    if (s->ga.fold[s->ga.root[x]] != s->gb.fold[s->gb.root[y]]) return false;
    for (int32_t i = 0; i < s->nset; i++) {
        int32_t u = s->set[i], v = s->image[u];
        bool same = s->ga.root[u] == s->ga.root[x];
        if (same != (s->gb.root[v] == s->gb.root[y])) return false;
        if (same && !s->ga.fold[s->ga.root[x]] && s->ga.sign[u] * s->ga.sign[x] != s->gb.sign[v] * s->gb.sign[y])
            return false;
    }
    return true;
}


static bool search_from(search *s, int32_t p)
{
    if (p == s->a->npanel) return true;
    int32_t n = s->a->side[p], before = s->nset;
    for (int32_t q = 0; q < s->b->npanel; q++) {
        if (s->used[q] || s->b->side[q] != n || s->b->panel_label[q] != s->a->panel_label[p]) continue;
        for (int32_t turn = 0; turn < n; turn++) {
            bool good = true;
            for (int32_t i = 0; i < n && good; i++) {
                int32_t j = s->mirror ? (turn + n - i) % n : (turn + i) % n;
                s->image[p * SIDES + i] = q * SIDES + j;
                good = fits(s, p * SIDES + i);
                s->set[s->nset++] = p * SIDES + i;
            }
            s->used[q] = true;
            if (good && search_from(s, p + 1)) return true;
            s->used[q] = false;
            s->nset = before;
        }
    }
    return false;
}


static bool same_complex(const complex *a, const complex *b, bool mirror)
{
    if (a->npanel != b->npanel) return false;
    for (int32_t way = 0; way < 1 + mirror; way++) {
        search s = {.a = a, .b = b, .ga = glue(a), .gb = glue(b), .mirror = way == 1};
        if (search_from(&s, 0)) return true;
    }
    return false;
}


/* ---- forms ---- */

typedef struct form {
    size_t n;
    uint8_t bytes[2048];
    uint64_t hash[2];
} form;


static form form_of(const mus_pattern *pattern, int32_t mirror, int32_t labels)
{
    form f;
    mus_form_def def;
    mus_form_def_init(&def, sizeof def);
    def.mirror = mirror, def.labels = labels;
    ck_assert_int_eq(mus_pattern_form(pattern, &def, f.bytes, sizeof f.bytes, &f.n, f.hash), MUS_OK);
    ck_assert_uint_le(f.n, sizeof f.bytes);
    return f;
}


/* equal forms have equal hashes and, among the few here, different ones different hashes */
static bool same_form(const form *a, const form *b)
{
    bool same = a->n == b->n && memcmp(a->bytes, b->bytes, a->n) == 0;
    ck_assert_int_eq(same, memcmp(a->hash, b->hash, sizeof a->hash) == 0);
    return same;
}


static mus_pattern *complex_pattern(mus_context *context, const complex *c, uint64_t seed)
{
    static const char *const labels[3] = {"", "hem", "neck"};
    char panels[512] = "", seams[1024] = "";
    for (int32_t p = 0; p < c->npanel; p++) {
        sprintf(panels + strlen(panels), "%sP%d:", p > 0 ? ";" : "", (int)p);
        for (int32_t i = 0; i < c->side[p]; i++) sprintf(panels + strlen(panels), " e%d", (int)i);
    }
    for (int32_t k = 0; k < c->nseam; k++) {
        const int32_t *s = c->seam[k];
        sprintf(seams + strlen(seams), "%sP%d.e%d P%d.e%d%s", k > 0 ? ";" : "", (int)(s[0] / SIDES),
                (int)(s[0] % SIDES), (int)(s[1] / SIDES), (int)(s[1] % SIDES), s[2] ? " direct" : "");
    }
    mus_pattern *pattern = gluing_make(context, panels, seams, seed);
    for (int32_t p = 0; p < c->npanel; p++) {
        if (c->panel_label[p]) ck_assert_int_eq(mus_pattern_set_panel_label(pattern, p, "body"), MUS_OK);
        for (int32_t i = 0; i < c->side[p]; i++) {
            char name[16];
            sprintf(name, "e%d", (int)i);
            ck_assert_int_eq(mus_pattern_set_edge_label(pattern, mus_pattern_find_edge(pattern, p, name),
                                                        labels[c->edge_label[p * SIDES + i]]),
                             MUS_OK);
        }
    }
    return pattern;
}


static form complex_form(const complex *c, int32_t mirror, uint64_t seed)
{
    mus_context *context = support_context();
    mus_pattern *pattern = complex_pattern(context, c, seed);
    form f = form_of(pattern, mirror, 1);
    mus_pattern_destroy(pattern);
    support_context_end(context);
    return f;
}


START_TEST(ten_thousand_relabellings_keep_the_form)
{
    uint64_t state = 1010;
    for (int32_t sample = 0; sample < 2500; sample++) {
        complex c = complex_random(&state, sample % 2 == 0, sample % 4 >= 2);
        form f[2] = {complex_form(&c, 0, 0), complex_form(&c, 1, 0)};
        for (int32_t i = 0; i < 4; i++) {
            complex r = complex_relabelled(&c, &state), turned = complex_turned(&r, MUS_NONE);
            form g = complex_form(&r, 0, support_random(&state)), h = complex_form(&turned, 1, support_random(&state));
            ck_assert(same_form(&f[0], &g));
            ck_assert(same_form(&f[1], &h));
        }
    }
}
END_TEST


START_TEST(ten_thousand_changes_change_the_form_exactly_when_the_patterns_differ)
{
    uint64_t state = 2020;
    int32_t same = 0, mirrored = 0;
    for (int32_t sample = 0; sample < 10000; sample++) {
        complex c = complex_random(&state, sample % 2 == 0, sample % 4 >= 2);
        complex changed = complex_changed(&c, sample % 4 >= 2, &state), r = complex_relabelled(&changed, &state);
        uint64_t seed = support_random(&state);
        bool expected[2] = {same_complex(&c, &r, false), same_complex(&c, &r, true)};
        for (int32_t mirror = 0; mirror < 2; mirror++) {
            form f = complex_form(&c, mirror, 0), g = complex_form(&r, mirror, seed);
            ck_assert_msg(same_form(&f, &g) == expected[mirror], "sample %d, mirror %d: the search says %d",
                          (int)sample, (int)mirror, (int)expected[mirror]);
        }
        same += expected[0];
        mirrored += expected[1] && !expected[0];
    }
    printf("form: of 10000 changes %d change nothing, %d make the mirror image\n", (int)same, (int)mirrored);
    ck_assert_int_gt(same, 300);
    ck_assert_int_lt(same, 5000);
    ck_assert_int_gt(mirrored, 20);
}
END_TEST


START_TEST(garments_of_the_tables_have_forms_of_their_own)
{
    /* rows of the two tables that are one garment: all else differs */
    mus_context *context = support_context();
    static form f[GARMENTS];
    for (int32_t i = 0; i < GARMENTS; i++) {
        mus_pattern *pattern = gluing_make(context, garments[i].panels, garments[i].seams, (uint64_t)i);
        f[i] = form_of(pattern, 1, 0);
        mus_pattern_destroy(pattern);
    }
    int32_t same = 0;
    for (int32_t i = 0; i < GARMENTS; i++)
        for (int32_t j = 0; j < i; j++) {
            if (!same_form(&f[i], &f[j])) continue;
            same++;
            ck_assert_msg(garments[i].euler == garments[j].euler && garments[i].faces == garments[j].faces, "%s = %s",
                          garments[i].name, garments[j].name);
        }
    /* hexagon of 1f and of fig. 8 with its sleeve, sleeve and circle skirt, tube, Moebius, skirt, trousers, T-shirt */
    printf("form: %d pairs of rows of the tables are one garment\n", (int)same);
    ck_assert_int_le(same, 12);
    support_context_end(context);
}
END_TEST


START_TEST(labels_and_mirroring_count_as_asked)
{
    mus_context *context = support_context();
    const char *seams = "A.a B.a; A.b B.d";
    mus_pattern *p = gluing_make(context, "A: a b c d e; B: a b c d", seams, 0);
    mus_pattern *q = gluing_make(context, "A: e d c b a; B: d c b a", seams, 0);
    for (int32_t i = 0; i < 2; i++) {
        ck_assert_int_eq(
            mus_pattern_set_edge_label(p, mus_pattern_find_edge(p, 0, i == 0 ? "c" : "d"), i == 0 ? "hem" : "neck"),
            MUS_OK);
        ck_assert_int_eq(
            mus_pattern_set_edge_label(q, mus_pattern_find_edge(q, 0, i == 0 ? "c" : "d"), i == 0 ? "hem" : "neck"),
            MUS_OK);
    }
    form plain[2] = {form_of(p, 0, 1), form_of(q, 0, 1)}, either[2] = {form_of(p, 1, 1), form_of(q, 1, 1)};
    ck_assert(!same_form(&plain[0], &plain[1]));
    ck_assert(same_form(&either[0], &either[1]));
    ck_assert_int_eq(mus_pattern_set_edge_label(q, 2, "cuff"), MUS_OK);
    form labelled[2] = {form_of(q, 1, 1), form_of(q, 1, 0)}, bare = form_of(p, 1, 0);
    ck_assert(!same_form(&labelled[0], &either[0]));
    ck_assert(same_form(&labelled[1], &bare));
    mus_pattern_destroy(p);
    mus_pattern_destroy(q);
    support_context_end(context);
}
END_TEST


START_TEST(many_alike_sheets_at_one_edge_are_no_maze)
{
    /* a book of n pages; pages sewn together in pairs; a skirt of 24 gores */
    mus_context *context = support_context();
    char panels[2048] = "", seams[2048] = "";
    for (int32_t n = 0; n < 12; n++) {
        sprintf(panels + strlen(panels), "%sP%d: a b c d", n > 0 ? ";" : "", (int)n);
        if (n > 0) sprintf(seams + strlen(seams), "%sP%d.a P%d.a", n > 1 ? ";" : "", (int)(n - 1), (int)n);
    }
    mus_pattern *book = gluing_make(context, panels, seams, 0);
    form f = form_of(book, 1, 1);
    ck_assert_uint_gt(f.n, 100);
    mus_pattern_destroy(book);
    for (int32_t n = 0; n < 12; n += 2)
        sprintf(seams + strlen(seams), ";P%d.b P%d.%s", (int)n, (int)n + 1, n % 4 == 0 ? "b" : "d");
    book = gluing_make(context, panels, seams, 0);
    f = form_of(book, 1, 1);
    mus_pattern *again = gluing_make(context, panels, seams, 99);
    form g = form_of(again, 1, 1);
    ck_assert(same_form(&f, &g));
    mus_pattern_destroy(book);
    mus_pattern_destroy(again);
    support_context_end(context);
}
END_TEST


START_TEST(pieces_do_not_run_together)
{
    /* four panels at one edge that is folded on itself, and two at each of two */
    mus_context *context = support_context();
    const char *panels = "A: a b; B: a b; C: a b; D: a b", *ends = "A.a B.a; A.a B.a direct; C.a D.a; C.a D.a direct";
    char seams[128];
    sprintf(seams, "%s; B.a C.a", ends);
    mus_pattern *two = gluing_make(context, panels, ends, 0), *one = gluing_make(context, panels, seams, 0);
    form f = form_of(two, 1, 1), g = form_of(one, 1, 1);
    ck_assert(!same_form(&f, &g));
    mus_pattern_destroy(one);
    mus_pattern_destroy(two);
    support_context_end(context);
}
END_TEST


START_TEST(forms_refuse_with_a_sentence_and_count_beyond_their_room)
{
    mus_context *context = support_context();
    mus_pattern *pattern = gluing_make(context, "F: hem a waist b", "F.a F.b", 0);
    size_t n = 7, more;
    uint64_t hash[2], again[2];
    uint8_t bytes[4] = {9, 9, 9, 9};
    ck_assert_int_eq(mus_pattern_form(NULL, NULL, NULL, 0, &n, hash), MUS_ERR_ARG);
    ck_assert(n == 0 && hash[0] == 0 && hash[1] == 0);
    ck_assert_int_eq(mus_pattern_form(pattern, NULL, NULL, 0, &n, hash), MUS_OK);
    ck_assert_int_eq(mus_pattern_form(pattern, NULL, bytes, 2, &more, again), MUS_OK);
    ck_assert(n == more && memcmp(hash, again, sizeof hash) == 0 && bytes[1] != 9 && bytes[2] == 9);
    ck_assert_int_eq(mus_pattern_form(pattern, NULL, NULL, 0, NULL, NULL), MUS_OK);
    mus_form_def def;
    mus_form_def_init(&def, sizeof def);
    def.size = 3;
    ck_assert_int_eq(mus_pattern_form(pattern, &def, NULL, 0, NULL, NULL), MUS_ERR_VERSION);
    int32_t panel;
    ck_assert_int_eq(mus_pattern_add_panel(pattern, "sleeve", &panel), MUS_OK);
    ck_assert_int_eq(mus_pattern_form(pattern, NULL, NULL, 0, &n, hash), MUS_ERR_PATTERN);
    ck_assert_str_eq(mus_context_error(context), "panel sleeve has no outline");
    mus_pattern_destroy(pattern);

    /* nothing at all has a form too */
    ck_assert_int_eq(mus_pattern_create(context, "", &pattern), MUS_OK);
    ck_assert_int_eq(mus_pattern_form(pattern, NULL, NULL, 0, &n, hash), MUS_OK);
    ck_assert_uint_gt(n, 0);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


START_TEST(failing_allocations_leave_nothing)
{
    for (int64_t n = 0;; n++) {
        mus_context *context = support_context();
        mus_pattern *pattern = gluing_make(context, "A: a b c; B: a b c; C: a b c", "A.a B.a; A.a C.a; A.b B.b", 0);
        support_fail_after(n, false);
        mus_status status = mus_pattern_form(pattern, NULL, NULL, 0, NULL, NULL);
        support_fail_never();
        mus_pattern_destroy(pattern);
        support_context_end(context);
        if (status == MUS_OK) break;
        ck_assert_int_eq(status, MUS_ERR_MEMORY);
    }
}
END_TEST


Suite *mus_suite_canonical_form(void);


Suite *mus_suite_canonical_form(void)
{
    Suite *suite = suite_create("canonical_form");
    TCase *tcase = tcase_create("canonical_form");
    tcase_set_timeout(tcase, 120);
    tcase_add_test(tcase, ten_thousand_relabellings_keep_the_form);
    tcase_add_test(tcase, ten_thousand_changes_change_the_form_exactly_when_the_patterns_differ);
    tcase_add_test(tcase, garments_of_the_tables_have_forms_of_their_own);
    tcase_add_test(tcase, labels_and_mirroring_count_as_asked);
    tcase_add_test(tcase, many_alike_sheets_at_one_edge_are_no_maze);
    tcase_add_test(tcase, pieces_do_not_run_together);
    tcase_add_test(tcase, forms_refuse_with_a_sentence_and_count_beyond_their_room);
    tcase_add_test(tcase, failing_allocations_leave_nothing);
    suite_add_tcase(suite, tcase);
    return suite;
}
