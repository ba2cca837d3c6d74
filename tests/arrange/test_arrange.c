/*
 * test_arrange.c: starts that are found: partner edges face each other about as near as where the designs put them,
 * right sides are off the body, nothing begins in it, and the garment then sews.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "drape/scenes.h"
#include "muslin/exchange.h"

static const struct {
    const char *design, *size;
    double most;  /* of the mean distance of partners where the design puts them */
    int overlaps; /* nonzero: one front lies over the other, so that it is not symmetric */
} garments[] = {{"tshirt", "W40", 1.05, 0},
                {"oxford_shirt", "W40", 1.05, 1},
                {"blouse_jewel_raglan", "W40", 1.05, 0},
                {"hoodie", "M50", 1.3, 0},
                {"jeans", "M50", 1.5, 0},
                {"gored8_skirt_midi", "W40", 1.05, 0},
                {"strapless_french_waist", "W40", 1.05, 0},
                {"sheath", "W40", 1.05, 0},
                {"maxi_halter", "W46", 1.5, 0},
                {"child_half_short", "C116", 1.5, 0},
                {"boiler_suit", "M50", 1.5, 0},
                {"blouse_shawl_three_quarter", "W40", 1.05, 0},
                {"blouse_shawl_three_quarter", "C92", 1.05, 0}};
enum { GARMENTS = sizeof garments / sizeof *garments };

typedef struct start {
    mus_context *context;
    mus_body *body;
    mus_pattern *pattern;
    mus_cloth *cloth;
    mus_drape *drape;
} start;


static start start_draft(int i)
{
    start s = {.context = support_context()};
    mus_tape *tape;
    mus_body_def def;
    mus_body_def_init(&def, sizeof def);
    def.plain = 1;
    ck_assert_int_eq(mus_tape_create(s.context, &tape), MUS_OK);
    ck_assert_int_eq(mus_tape_set_size(tape, garments[i].size), MUS_OK);
    ck_assert_int_eq(mus_tape_complete(tape), MUS_OK);
    ck_assert_int_eq(mus_body_create(s.context, tape, &def, &s.body), MUS_OK);
    ck_assert_int_eq(mus_design_draft(s.context, mus_design_find(garments[i].design), tape, NULL, &s.pattern), MUS_OK);
    mus_tape_destroy(tape);
    return s;
}


/* forget where panels start */
static void start_strip(mus_pattern *pattern)
{
    mus_placement none;
    mus_placement_init(&none, sizeof none);
    for (int32_t p = 0; p < mus_pattern_panel_count(pattern); p++)
        ck_assert_int_eq(mus_pattern_set_placement(pattern, p, &none), MUS_OK);
}


/* cut and put there */
static void start_cut(start *s, double spacing)
{
    mus_drape_destroy(s->drape);
    mus_cloth_destroy(s->cloth);
    s->cloth = scene_cut(s->context, s->pattern, spacing, 0.0);
    ck_assert_int_eq(mus_drape_create(s->context, s->cloth, s->body, NULL, &s->drape), MUS_OK);
    ck_assert_int_eq(mus_drape_place(s->drape), MUS_OK);
}


static double start_gap(const start *s)
{
    const int32_t n = mus_cloth_pair_count(s->cloth);
    double *gap = malloc((size_t)n * sizeof *gap), sum = 0.0;
    ck_assert_int_eq(mus_drape_gaps(s->drape, gap), MUS_OK);
    for (int32_t i = 0; i < n; i++) sum += gap[i] / n;
    free(gap);
    return sum;
}


static void start_end(start *s)
{
    mus_drape_destroy(s->drape);
    mus_cloth_destroy(s->cloth);
    mus_pattern_destroy(s->pattern);
    mus_body_destroy(s->body);
    support_context_end(s->context);
}


/* Counts the nodes deeper than 5 mm in the body, and the triangles of trunk panels that face its middle. */
static void start_look(const start *s, int32_t *deep, int32_t *inward)
{
    const int32_t n = mus_drape_node_count(s->drape);
    const double *x = mus_drape_positions(s->drape);
    double *depth = malloc((size_t)n * sizeof *depth);
    ck_assert_int_eq(mus_drape_depth(s->drape, n, x, depth, NULL), MUS_OK);
    *deep = *inward = 0;
    for (int32_t i = 0; i < n; i++) *deep += depth[i] > 0.005;
    free(depth);
    for (int32_t t = 0; t < mus_cloth_triangle_count(s->cloth); t++) {
        const int32_t *v = mus_cloth_triangles(s->cloth) + 3 * (ptrdiff_t)t;
        const int32_t panel = mus_cloth_node_panels(s->cloth)[v[0]];
        const char *label = mus_pattern_panel_label(s->pattern, panel);
        if (strcmp(label, "arm") == 0 || strcmp(label, "hood") == 0) continue;
        const double *a = x + 3 * (ptrdiff_t)v[0], *b = x + 3 * (ptrdiff_t)v[1], *c = x + 3 * (ptrdiff_t)v[2];
        const double d[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]}, e[3] = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};
        const double nx = d[1] * e[2] - d[2] * e[1], nz = d[0] * e[1] - d[1] * e[0];
        *inward += nx * a[0] + nz * a[2] < 0.0;
    }
}


START_TEST(found_starts_are_as_good_as_those_of_the_designs)
{
    start s = start_draft(_i);
    int32_t deep, inward;
    start_cut(&s, 0.05);
    const double given = start_gap(&s);
    start_strip(s.pattern);
    ck_assert_int_eq(mus_arrange_pattern(s.pattern, s.body), MUS_OK);
    start_cut(&s, 0.05);
    const double found = start_gap(&s);
    start_look(&s, &deep, &inward);
    ck_assert_msg(found < garments[_i].most * given, "%s: partners are %.3f m apart, %.3f where it was put",
                  garments[_i].design, found, given);
    ck_assert_msg(deep <= mus_drape_node_count(s.drape) / 50, "%s: %d nodes in the body", garments[_i].design,
                  (int)deep);
    ck_assert_msg(inward <= mus_cloth_triangle_count(s.cloth) / 50, "%s: %d of %d triangles face inwards",
                  garments[_i].design, (int)inward, (int)mus_cloth_triangle_count(s.cloth));
    mus_reason reason;
    mus_reason_init(&reason, sizeof reason);
    ck_assert_int_eq(mus_drape_start(s.drape, &reason), MUS_OK);
    ck_assert_msg(reason.kind == MUS_REASON_NONE, "%s: %s", garments[_i].design, reason.text);
    start_end(&s);
}
END_TEST


/* where the ends and the middle of an edge start, out (3 x 3) [m] */
static void start_edge(const mus_pattern *pattern, int32_t panel, int32_t edge, double *out)
{
    const double t[3] = {0.0, 0.5, 1.0};
    double dot[6];
    mus_placement place;
    mus_placement_init(&place, sizeof place);
    ck_assert_int_eq(mus_pattern_placement(pattern, panel, &place), MUS_OK);
    ck_assert_int_eq(mus_pattern_edge_at(pattern, edge, 3, t, dot), MUS_OK);
    for (int32_t i = 0; i < 3; i++) {
        const double angle = place.bend != 0.0 ? (dot[2 * i] - place.bend_x) / place.bend : 0.0;
        const double x = place.bend != 0.0 ? place.bend_x + place.bend * sin(angle) : dot[2 * i];
        const double z = place.bend * (cos(angle) - 1.0);
        for (int32_t d = 0; d < 3; d++)
            out[3 * i + d] = place.origin[d] + place.rotation[3 * d] * x + place.rotation[3 * d + 1] * dot[2 * i + 1] +
                             place.rotation[3 * d + 2] * z;
    }
}


/* the ends and middles of all edges that start at places that the mirror image has too, to 10 um */
START_TEST(a_symmetric_garment_starts_symmetric)
{
    if (garments[_i].overlaps) return;
    start s = start_draft(_i);
    ck_assert_int_eq(mus_arrange_pattern(s.pattern, s.body), MUS_OK);
    const int32_t most = 3 * mus_pattern_edge_count(s.pattern);
    double *x = malloc(3 * (size_t)most * sizeof *x);
    int32_t n = 0;
    for (int32_t p = 0; p < mus_pattern_panel_count(s.pattern); p++) {
        int32_t edges;
        const int32_t *edge, *direction;
        ck_assert_int_eq(mus_pattern_outline(s.pattern, p, &edges, &edge, &direction), MUS_OK);
        for (int32_t i = 0; i < edges && n + 3 <= most; i++, n += 3) start_edge(s.pattern, p, edge[i], x + 3 * n);
    }
    for (int32_t i = 0; i < n; i++) {
        double least = 1.0;
        for (int32_t k = 0; k < n; k++)
            least = fmin(least,
                         hypot(hypot(x[3 * i] + x[3 * k], x[3 * i + 1] - x[3 * k + 1]), x[3 * i + 2] - x[3 * k + 2]));
        ck_assert_msg(least < 1e-5, "%s: %.3f mm from the mirror image", garments[_i].design, 1e3 * least);
    }
    free(x);
    start_end(&s);
}
END_TEST


/* a former placement has no effect: the same one is found again, bit for bit; it can be sewn */
START_TEST(a_found_start_is_found_again_and_sews)
{
    start s = start_draft(0);
    start_cut(&s, 0.04);
    ck_assert_int_eq(mus_arrange_pattern(s.pattern, s.body), MUS_OK);
    start_cut(&s, 0.04);
    const uint64_t once = mus_drape_hash(s.drape);
    start_strip(s.pattern);
    ck_assert_int_eq(mus_arrange_pattern(s.pattern, s.body), MUS_OK);
    start_cut(&s, 0.04);
    ck_assert(mus_drape_hash(s.drape) == once);
    ck_assert_int_eq(mus_drape_sew(s.drape, NULL, NULL), MUS_OK);
    ck_assert_int_eq(mus_drape_settle(s.drape, NULL, NULL), MUS_OK);
    start_end(&s);
}
END_TEST


/* six panels alike and without words, sewn to a ring: each beside the next, at the waist where they are held */
START_TEST(a_ring_of_panels_without_words_closes)
{
    start s = {.context = support_context()};
    int32_t edge[6][4];
    double waist[3];
    s.body = scene_body(s.context);
    ck_assert_int_eq(mus_body_landmark(s.body, MUS_LANDMARK_WAIST, waist), MUS_OK);
    ck_assert_int_eq(mus_pattern_create(s.context, "ring", &s.pattern), MUS_OK);
    for (int i = 0; i < 6; i++) {
        char name[16];
        snprintf(name, sizeof name, "p%d", i);
        scene_rectangle(s.pattern, name, 0.3 * i, -0.1 * i, 0.2, 0.4, edge[i]);
        ck_assert_int_eq(mus_pattern_set_edge_hold(s.pattern, edge[i][2], MUS_HOLD_WAIST, 0.0), MUS_OK);
    }
    for (int i = 0; i < 6; i++) scene_sew(s.pattern, edge[(i + 2) % 6][1], edge[(i + 3) % 6][3], 0.0);
    ck_assert_int_eq(mus_arrange_pattern(s.pattern, s.body), MUS_OK);
    start_cut(&s, 0.05);

    /* on a circle of 1.2 m and some room, sides are a tenth of what it is wider apart; its upper edge is level */
    ck_assert_double_lt(start_gap(&s), 0.06);
    const double *x = mus_drape_positions(s.drape);
    double top = 0.0;
    for (int32_t i = 0; i < mus_drape_node_count(s.drape); i++) top = fmax(top, x[3 * i + 1]);
    ck_assert_double_eq_tol(top, waist[1], 1e-6);
    start_end(&s);
}
END_TEST


/* the pattern read again from its JSON, in which each panel has a name of as many letters that tell nothing */
static mus_pattern *start_nameless(const start *s)
{
    char *text, quoted[160];
    size_t size;
    mus_pattern *out;
    ck_assert_int_eq(mus_pattern_write_bytes(s->pattern, &text, &size), MUS_OK);
    for (int32_t p = 0; p < mus_pattern_panel_count(s->pattern); p++) {
        snprintf(quoted, sizeof quoted, "{\"name\": \"%s\"", mus_pattern_panel_name(s->pattern, p));
        char *at = strstr(text, quoted) + 10;
        const size_t n = strlen(quoted) - 11;
        memset(at, 'x', n);
        at[0] = (char)('a' + p / 26), at[1] = (char)('a' + p % 26);
    }
    const mus_status status = mus_pattern_read_from(s->context, text, size, "nameless.json", &out);
    ck_assert_msg(status == MUS_OK, "%s", mus_context_error(s->context));
    mus_context_alloc(s->context, text, 0);
    ck_assert_int_eq(mus_pattern_find_panel(out, mus_pattern_panel_name(s->pattern, 0)), MUS_NONE);
    return out;
}


/* trousers with cuffs, a hood, a collar, sleeves with cuffs */
static const char *const specs[] = {"d11_023_m_smpl_average_A40", "d11_036_mean_female", "d11_046_mean_female"};
enum { SPECS = sizeof specs / sizeof *specs };

START_TEST(names_of_panels_decide_nothing)
{
    char relative[128], path[1024];
    snprintf(relative, sizeof relative, "garmentcode/specs/%s_specification.json", specs[_i]);
    if (support_data(relative, path, sizeof path) == NULL) return;
    start s = {.context = support_context()};
    s.body = scene_body(s.context);
    ck_assert_int_eq(mus_pattern_read(s.context, path, &s.pattern), MUS_OK);
    mus_pattern *named = s.pattern, *nameless = start_nameless(&s);
    uint64_t hash[2];
    for (int i = 0; i < 2; i++) {
        s.pattern = i == 0 ? named : nameless;
        ck_assert_int_eq(mus_arrange_pattern(s.pattern, s.body), MUS_OK);
        start_cut(&s, 0.05);
        (void)mus_drape_sew(s.drape, NULL, NULL);
        hash[i] = mus_drape_hash(s.drape);
    }
    ck_assert(hash[0] == hash[1]);
    s.pattern = named;
    mus_pattern_destroy(nameless);
    start_end(&s);
}
END_TEST


START_TEST(what_cannot_be_placed_is_refused)
{
    start s = start_draft(0);
    mus_placement before, after;
    mus_placement_init(&before, sizeof before);
    mus_placement_init(&after, sizeof after);
    ck_assert_int_eq(mus_pattern_placement(s.pattern, 0, &before), MUS_OK);
    ck_assert_int_eq(mus_arrange_pattern(NULL, s.body), MUS_ERR_ARG);
    ck_assert_int_eq(mus_arrange_pattern(s.pattern, NULL), MUS_ERR_ARG);

    /* a form has no levels */
    const double contour[12] = {0, 0, 0, 0.1, 0.1, 2, 0.5, 0, 0, 0.1, 0.1, 2};
    mus_limb limb;
    mus_body *form;
    mus_limb_init(&limb, sizeof limb);
    limb.contours = 2, limb.contour = contour, limb.pole[0] = -0.05, limb.pole[1] = 0.55;
    ck_assert_int_eq(mus_body_create_limbs(s.context, 1, &limb, NULL, &form), MUS_OK);
    ck_assert_int_eq(mus_arrange_pattern(s.pattern, form), MUS_ERR_BODY);
    ck_assert_ptr_nonnull(strstr(mus_context_error(s.context), "neck"));
    mus_body_destroy(form);

    for (int64_t n = 0;; n++) {
        support_fail_after(n, false);
        const mus_status status = mus_arrange_pattern(s.pattern, s.body);
        support_fail_never();
        if (status == MUS_OK) break;
        ck_assert_int_eq(status, MUS_ERR_MEMORY);
        ck_assert_int_eq(mus_pattern_placement(s.pattern, 0, &after), MUS_OK);
        ck_assert_int_eq(memcmp(&before, &after, sizeof before), 0);
        ck_assert_int_lt(n, 100);
    }

    int32_t panel;
    ck_assert_int_eq(mus_pattern_add_panel(s.pattern, "empty", &panel), MUS_OK);
    ck_assert_int_eq(mus_arrange_pattern(s.pattern, s.body), MUS_ERR_PATTERN);
    ck_assert_ptr_nonnull(strstr(mus_context_error(s.context), "empty"));
    start_end(&s);
}
END_TEST


Suite *mus_suite_arrange(void);


Suite *mus_suite_arrange(void)
{
    Suite *suite = suite_create("arrange");
    TCase *tests = tcase_create("arrange");
    tcase_set_timeout(tests, 60.0);
    tcase_add_loop_test(tests, found_starts_are_as_good_as_those_of_the_designs, 0, SUPPORT_SLOW ? 3 : GARMENTS);
    tcase_add_loop_test(tests, a_symmetric_garment_starts_symmetric, 0, SUPPORT_SLOW ? 3 : GARMENTS);
    tcase_add_test(tests, a_found_start_is_found_again_and_sews);
    tcase_add_test(tests, a_ring_of_panels_without_words_closes);
    tcase_add_loop_test(tests, names_of_panels_decide_nothing, 0, SUPPORT_SLOW ? 1 : SPECS);
    tcase_add_test(tests, what_cannot_be_placed_is_refused);
    suite_add_tcase(suite, tests);
    return suite;
}
