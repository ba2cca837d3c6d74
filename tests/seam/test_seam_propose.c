/*
 * test_seam_propose.c: seams proposed for a pattern without: a skirt, a seam that is there, no memory;
 * the surface that a sewing makes; parts of a garment told by names.
 */
#include <string.h>

#include "muslin/exchange.h"
#include "muslin/muslin.h"
#include "support.h"
#include "seam/seam_find.h"


static void add_trapezoid(mus_pattern *pattern, const char *name, double top, double bottom, double height)
{
    const double xy[8] = {-0.5 * bottom, 0.0, 0.5 * bottom, 0.0, 0.5 * top, height, -0.5 * top, height};
    int32_t panel, points[4], edges[4];
    const int32_t along[4] = {1, 1, 1, 1};
    ck_assert_int_eq(mus_pattern_add_panel(pattern, name, &panel), MUS_OK);
    for (int32_t i = 0; i < 4; i++)
        ck_assert_int_eq(mus_pattern_add_point(pattern, panel, xy[2 * i], xy[2 * i + 1], &points[i]), MUS_OK);
    for (int32_t i = 0; i < 4; i++) {
        mus_edge_def def;
        mus_edge_def_init(&def, sizeof def);
        def.start = points[i];
        def.end = points[(i + 1) % 4];
        ck_assert_int_eq(mus_pattern_add_edge(pattern, &def, &edges[i]), MUS_OK);
    }
    ck_assert_int_eq(mus_pattern_set_outline(pattern, panel, 4, edges, along), MUS_OK);
}


/* a skirt of front and back; edges 0 to 3 and 4 to 7 are hem, right side, waist, left side as seen */
static mus_pattern *skirt(mus_context *context)
{
    mus_pattern *pattern;
    ck_assert_int_eq(mus_pattern_create(context, "skirt", &pattern), MUS_OK);
    add_trapezoid(pattern, "front", 0.36, 0.52, 0.6);
    add_trapezoid(pattern, "back", 0.34, 0.50, 0.6);
    return pattern;
}


START_TEST(a_skirt_is_sewn_at_its_sides)
{
    mus_context *context = support_context();
    mus_pattern *pattern = skirt(context);
    int32_t edges[32], chosen[16], n = 0, sides = 0;
    double confidence[16];
    ck_assert_int_eq(mus_pattern_propose_seams(pattern, NULL, NULL, NULL, 0, &n), MUS_OK);
    ck_assert_int_le(n, 16);
    ck_assert_int_eq(mus_pattern_propose_seams(pattern, edges, chosen, confidence, 16, &n), MUS_OK);
    for (int32_t i = 0; i < n; i++) {
        ck_assert(confidence[i] >= 0.0 && confidence[i] <= 1.0);
        if (i > 0) ck_assert(chosen[i] < chosen[i - 1] || confidence[i] <= confidence[i - 1]);
        const int32_t a = edges[2 * i], b = edges[2 * i + 1];
        sides += chosen[i] && ((a == 1 && b == 7) || (a == 3 && b == 5));
    }
    ck_assert_int_eq(sides, 2);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


START_TEST(a_seam_that_is_there_is_kept)
{
    mus_context *context = support_context();
    mus_pattern *pattern = skirt(context);
    int32_t edges[32], n = 0;
    mus_seam_def def;
    mus_seam_def_init(&def, sizeof def);
    def.edge_a = 1;
    def.edge_b = 5; /* the wrong side */
    ck_assert_int_eq(mus_pattern_add_seam(pattern, &def, NULL), MUS_OK);
    ck_assert_int_eq(mus_pattern_propose_seams(pattern, edges, NULL, NULL, 16, &n), MUS_OK);
    ck_assert_int_le(n, 16);
    for (int32_t i = 0; i < 2 * n; i++) ck_assert(edges[i] != 1 && edges[i] != 5);
    ck_assert_int_eq(mus_pattern_propose_seams(NULL, edges, NULL, NULL, 16, &n), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_propose_seams(pattern, edges, NULL, NULL, -1, &n), MUS_ERR_ARG);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


/* two panels sewn at both sides are a tube: two openings of two corners a vertex, no handle */
START_TEST(the_surface_of_a_skirt_is_a_tube)
{
    mus_context *context = support_context();
    mus_pattern *pattern = skirt(context);
    int32_t scratch[64], mate[8] = {MUS_NONE, 7, MUS_NONE, 5, MUS_NONE, 3, MUS_NONE, 1};
    double whole[MUS__SEAM_WHOLES];
    mus__seam_facts facts;
    ck_assert_int_eq(mus__seam_read(pattern, &facts), MUS_OK);
    ck_assert_int_eq(facts.n, 8);
    ck_assert_int_le(MUS__SEAM_SCRATCH(&facts), 64);
    ck_assert_int_eq(facts.edges[1].mirror, 3);
    mus__seam_whole(&facts, mate, scratch, whole);
    ck_assert_double_eq(whole[MUS__SEAM_COMPONENTS], 0.0);
    ck_assert_double_eq(whole[MUS__SEAM_HANDLES], 0.0);
    ck_assert_double_eq(whole[MUS__SEAM_OPENINGS_2], 1.0);
    ck_assert_double_eq(whole[MUS__SEAM_SEALED], 0.0);
    ck_assert_double_eq(whole[MUS__SEAM_OPEN_2], 4.0);
    ck_assert_double_eq(whole[MUS__SEAM_UNEVEN], 0.0);
    /* hem and waist sewn too: a pillow, which is a sphere */
    mate[0] = 4, mate[4] = 0, mate[2] = 6, mate[6] = 2;
    mus__seam_whole(&facts, mate, scratch, whole);
    ck_assert_double_eq(whole[MUS__SEAM_OPENINGS_2], 0.0);
    ck_assert_double_eq(whole[MUS__SEAM_SEALED], 1.0);
    ck_assert_double_eq(whole[MUS__SEAM_HANDLES] + whole[MUS__SEAM_COMPONENTS], 0.0);
    ck_assert_double_eq(whole[MUS__SEAM_CLOSED_2], 4.0);
    mus__seam_free(&facts);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


/* the first word of the table that is in the name decides; a part of a word is none */
START_TEST(names_tell_the_parts_of_a_garment)
{
    static const struct {
        const char *name;
        int32_t role;
    } panels[] = {{"Sleeve_left", MUS__SEAM_ROLE_SLEEVE}, {"pant_l_cuff_b", MUS__SEAM_ROLE_LEG_CUFF},
                  {"front skirt 2", MUS__SEAM_ROLE_SKIRT}, {"left_ftorso", MUS__SEAM_ROLE_TORSO},
                  {"inside", MUS__SEAM_ROLE_NONE},         {"17", MUS__SEAM_ROLE_NONE},
                  {"cuff_right", MUS__SEAM_ROLE_CUFF},     {"sl_left_cuff_skirt_f", MUS__SEAM_ROLE_FLOUNCE},
                  {"pocket_left", MUS__SEAM_ROLE_POCKET}};
    const int32_t count = (int32_t)(sizeof panels / sizeof *panels);
    mus_context *context = support_context();
    mus_pattern *pattern;
    mus__seam_facts facts;
    ck_assert_int_eq(mus_pattern_create(context, "parts", &pattern), MUS_OK);
    for (int32_t i = 0; i < count; i++) add_trapezoid(pattern, panels[i].name, 0.3, 0.4, 0.5);
    ck_assert_int_eq(mus__seam_read(pattern, &facts), MUS_OK);
    for (int32_t i = 0; i < count; i++) ck_assert_int_eq(facts.panels[i].role, panels[i].role);
    mus__seam_free(&facts);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


/* a is sewn to b, c to d; where a goes to d at once, b goes to c: each panel keeps a partner for all its edges */
START_TEST(a_panel_takes_the_place_of_another_in_one_change)
{
    mus_context *context = support_context();
    mus_pattern *pattern;
    mus__seam_facts facts;
    int32_t mate[16];
    ck_assert_int_eq(mus_pattern_create(context, "four", &pattern), MUS_OK);
    for (int32_t p = 0; p < 4; p++) add_trapezoid(pattern, (const char *const[]){"a", "b", "c", "d"}[p], 0.3, 0.4, 0.5);
    ck_assert_int_eq(mus__seam_read(pattern, &facts), MUS_OK);
    for (int32_t p = 0; p < 4; p++)
        for (int32_t i = 0; i < 4; i++) mate[4 * p + i] = 4 * (p ^ 1) + (4 - i) % 4;
    const mus__seam_change change = {.a = 1, .b = 15, .join = true, .on = true, .over = true};
    ck_assert(mus__seam_change_apply(&facts, &change, mate));
    for (int32_t p = 0; p < 4; p++)
        for (int32_t i = 0; i < 4; i++) ck_assert_int_eq(mate[4 * p + i], 4 * (3 - p) + (4 - i) % 4);
    mus__seam_free(&facts);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


/* two sleeves of one shape: all edges are equal, and no seam goes from one to the other */
START_TEST(an_arm_is_not_sewn_to_the_other_side)
{
    mus_context *context = support_context();
    mus_pattern *pattern;
    int32_t edges[64], chosen[32], n = 0, owns = 0;
    ck_assert_int_eq(mus_pattern_create(context, "sleeves", &pattern), MUS_OK);
    add_trapezoid(pattern, "sleeve_left", 0.3, 0.2, 0.5);
    add_trapezoid(pattern, "sleeve_right", 0.3, 0.2, 0.5);
    ck_assert_int_eq(mus_pattern_propose_seams(pattern, edges, chosen, NULL, 32, &n), MUS_OK);
    ck_assert_int_le(n, 32);
    for (int32_t i = 0; i < n; i++) {
        if (chosen[i]) ck_assert_int_eq(edges[2 * i] / 4, edges[2 * i + 1] / 4);
        owns += chosen[i];
    }
    ck_assert_int_eq(owns, 2);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


START_TEST(a_failed_allocation_is_a_status)
{
    for (int64_t n = 0;; n++) {
        mus_context *context = support_context();
        mus_pattern *pattern = skirt(context);
        int32_t count = 0;
        support_fail_after(n, false);
        const mus_status status = mus_pattern_propose_seams(pattern, NULL, NULL, NULL, 0, &count);
        support_fail_never();
        mus_pattern_destroy(pattern);
        support_context_end(context);
        if (status == MUS_OK) break;
        ck_assert_int_eq(status, MUS_ERR_MEMORY);
    }
}
END_TEST


Suite *mus_suite_seam_propose(void);

Suite *mus_suite_seam_propose(void)
{
    Suite *suite = suite_create("seam_propose");
    TCase *tests = tcase_create("seam_propose");
    tcase_add_test(tests, a_skirt_is_sewn_at_its_sides);
    tcase_add_test(tests, a_seam_that_is_there_is_kept);
    tcase_add_test(tests, the_surface_of_a_skirt_is_a_tube);
    tcase_add_test(tests, names_tell_the_parts_of_a_garment);
    tcase_add_test(tests, a_panel_takes_the_place_of_another_in_one_change);
    tcase_add_test(tests, an_arm_is_not_sewn_to_the_other_side);
    tcase_add_test(tests, a_failed_allocation_is_a_status);
    suite_add_tcase(suite, tests);
    return suite;
}
