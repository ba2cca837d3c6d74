/*
 * test_check.c: every fault is found, named and said in a sentence, and a sound garment has none.
 */
#include <math.h>

#include "topology/garments.h"
#include "topology/gluing.h"
#include "pattern/same.h"
#include "muslin/topology.h"


/* the faults of a check, at most 8 */
typedef struct faults {
    int32_t count, kind[8], panel[8], edge[8], seam[8];
    const char *text[8];
} faults;


static faults check_of(mus_pattern *pattern)
{
    faults f = {0};
    ck_assert_int_eq(mus_pattern_check(pattern, &f.count), MUS_OK);
    for (int32_t i = 0; i < f.count && i < 8; i++) {
        ck_assert_int_eq(mus_pattern_fault(pattern, i, &f.kind[i], &f.panel[i], &f.edge[i], &f.seam[i], &f.text[i]),
                         MUS_OK);
        ck_assert_uint_gt(strlen(f.text[i]), 20);
    }
    return f;
}


START_TEST(sound_garments_have_no_fault_and_one_sided_ones_a_twisted_seam)
{
    /* n-gons of the table are drawn on a circle and their seams have a wide tolerance; the words with an edge passed
     * twice are no outlines that could be drawn so */
    const garment *g = &garments[_i];
    if (strchr(g->panels, '-') != NULL) return;
    mus_context *context = support_context();
    for (uint64_t seed = 0; seed < 4; seed++) {
        mus_pattern *pattern = gluing_make(context, g->panels, g->seams, seed);
        faults f = check_of(pattern);
        int32_t twisted = 0, twice = 0;
        for (int32_t i = 0; i < f.count && i < 8; i++) {
            twisted += f.kind[i] == MUS_FAULT_TWISTED_SEAM;
            twice += f.kind[i] == MUS_FAULT_SEWN_TWICE;
        }
        ck_assert_msg((twisted > 0) == !g->orientable, "%s: %d twisted", g->name, twisted);
        ck_assert_msg((twice > 0) == !g->manifold, "%s: %d sewn twice", g->name, twice);
        ck_assert_msg(f.count == twisted + twice, "%s: %s", g->name, f.text[0]);
        mus_pattern_destroy(pattern);
    }
    support_context_end(context);
}
END_TEST


START_TEST(the_twisted_seam_is_named_wherever_it_stands)
{
    /* a T-shirt body with one seam direct: that seam is at fault, in any order of the four */
    static const char *seams[4] = {"F.sideL B.sideL", "F.sideR B.sideR", "F.shL B.shL", "F.shR B.shR"};
    mus_context *context = support_context();
    for (int32_t wrong = 0; wrong < 4; wrong++) {
        char text[256] = "";
        for (int32_t i = 0; i < 4; i++)
            sprintf(text + strlen(text), "%s%s%s", i > 0 ? "; " : "", seams[i], i == wrong ? " direct" : "");
        mus_pattern *pattern = gluing_make(context,
                                           "F: hem sideL armL shL neck shR armR sideR;"
                                           "B: hem sideR armR shR neck shL armL sideL",
                                           text, 0);
        faults f = check_of(pattern);
        ck_assert_int_eq(f.count, 1);
        ck_assert_int_eq(f.kind[0], MUS_FAULT_TWISTED_SEAM);
        ck_assert_int_eq(f.seam[0], wrong);
        mus_pattern_destroy(pattern);
    }

    /* all four direct: the back is drawn from its other side, and nothing is twisted */
    mus_pattern *pattern = gluing_make(context,
                                       "F: hem sideL armL shL neck shR armR sideR;"
                                       "B: hem sideL armL shL neck shR armR sideR",
                                       "F.sideL B.sideL direct; F.sideR B.sideR direct; F.shL B.shL direct;"
                                       "F.shR B.shR direct",
                                       0);
    ck_assert_int_eq(check_of(pattern).count, 0);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


START_TEST(sides_of_unequal_length_are_told_in_millimetres)
{
    mus_context *context = support_context();
    mus_pattern *pattern;
    int32_t e[2], along[4] = {1, 1, 1, 1};
    ck_assert_int_eq(mus_pattern_create(context, "two", &pattern), MUS_OK);
    for (int32_t k = 0; k < 2; k++) {
        int32_t panel, p[4], edges[4], line = MUS_PIECE_LINE;
        double height = k == 0 ? 0.412 : 0.426, xy[8] = {0.0, 0.0, 0.3, 0.0, 0.3, height, 0.0, height};
        ck_assert_int_eq(mus_pattern_add_panel(pattern, k == 0 ? "front" : "back", &panel), MUS_OK);
        for (int32_t i = 0; i < 4; i++)
            ck_assert_int_eq(mus_pattern_add_point(pattern, panel, xy[2 * i], xy[2 * i + 1], &p[i]), MUS_OK);
        for (int32_t i = 0; i < 4; i++)
            ck_assert_int_eq(mus_pattern_add_edge(pattern, i == 1 ? "side" : NULL, p[i], p[(i + 1) % 4], 1, &line, 0,
                                                  NULL, &edges[i]),
                             MUS_OK);
        ck_assert_int_eq(mus_pattern_set_outline(pattern, panel, 4, edges, along), MUS_OK);
        e[k] = edges[1];
    }
    mus_seam_def def;
    mus_seam_def_init(&def, sizeof def);
    def.edge_a = e[0], def.edge_b = e[1];
    int32_t seam;
    ck_assert_int_eq(mus_pattern_add_seam(pattern, &def, &seam), MUS_OK);
    faults f = check_of(pattern);
    ck_assert_int_eq(f.count, 1);
    ck_assert(f.kind[0] == MUS_FAULT_SEAM_LENGTH && f.seam[0] == seam && f.edge[0] == e[0] && f.panel[0] == MUS_NONE);
    ck_assert_str_eq(f.text[0],
                     "seam 0: front.side 0.412 m and back.side 0.426 m differ by 14.0 mm, ease allows 0.5 mm");
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


START_TEST(ease_is_length_that_the_design_means)
{
    /* the neck of the sample is 3.5 mm longer or so than a straight one: try each ease against the rule */
    mus_context *context = support_context();
    sample s = sample_make(context);
    double more = mus_pattern_edge_length(s.pattern, s.edge[2]) - mus_pattern_edge_length(s.pattern, s.edge[6]);
    ck_assert_double_gt(more, 0.003);
    for (int32_t i = -3; i <= 3; i++) {
        mus_pattern *copy;
        mus_seam_def def;
        mus_seam_def_init(&def, sizeof def);
        def.edge_a = s.edge[6], def.edge_b = s.edge[2], def.tolerance = 0.001, def.ease = more + 0.0005 * i;
        ck_assert_int_eq(mus_pattern_copy(s.pattern, &copy), MUS_OK);
        ck_assert_int_eq(mus_pattern_add_seam(copy, &def, NULL), MUS_OK);
        faults f = check_of(copy);
        ck_assert_int_eq(f.count, i < -2 || i > 2);
        if (f.count > 0) ck_assert_ptr_nonnull(strstr(f.text[0], i > 0 ? "ease allows " : "mm, ease allows"));
        mus_pattern_destroy(copy);
    }
    mus_pattern_destroy(s.pattern);
    support_context_end(context);
}
END_TEST


START_TEST(each_kind_of_fault_is_found_where_it_is)
{
    mus_context *context = support_context();
    sample s = sample_make(context);
    mus_pattern *p = s.pattern;
    ck_assert_int_eq(check_of(p).count, 0);

    /* no outline */
    int32_t panel, point[4], edge[4], line = MUS_PIECE_LINE, along[4] = {1, 1, 1, 1};
    ck_assert_int_eq(mus_pattern_add_panel(p, "cuff", &panel), MUS_OK);
    faults f = check_of(p);
    ck_assert(f.count == 1 && f.kind[0] == MUS_FAULT_OPEN_OUTLINE && f.panel[0] == panel && f.edge[0] == MUS_NONE);
    ck_assert_str_eq(f.text[0], "panel cuff: it has no closed outline");

    /* a bow tie of 9 mm, its edges in no outline at first */
    double xy[8] = {0.0, 0.0, 0.009, 0.0, 0.0, 0.009, 0.009, 0.009};
    for (int32_t i = 0; i < 4; i++)
        ck_assert_int_eq(mus_pattern_add_point(p, panel, xy[2 * i], xy[2 * i + 1], &point[i]), MUS_OK);
    for (int32_t i = 0; i < 4; i++)
        ck_assert_int_eq(mus_pattern_add_edge(p, NULL, point[i], point[(i + 1) % 4], 1, &line, 0, NULL, &edge[i]),
                         MUS_OK);
    f = check_of(p);
    ck_assert(f.count == 5 && f.kind[4] == MUS_FAULT_LOOSE_EDGE && f.edge[4] == edge[3] && f.panel[4] == panel);
    ck_assert_str_eq(f.text[4], "edge cuff.edge_11: it is part of no outline");

    ck_assert_int_eq(mus_pattern_set_outline(p, panel, 4, edge, along), MUS_OK);
    f = check_of(p);
    ck_assert(f.count == 2 && f.kind[0] == MUS_FAULT_CROSSING && f.panel[0] == panel && f.edge[0] == edge[1]);
    ck_assert_str_eq(f.text[0],
                     "panel cuff: its outline crosses or touches itself: edges cuff.edge_9 and cuff.edge_11");
    ck_assert(f.kind[1] == MUS_FAULT_SMALL_PANEL && f.panel[1] == panel);
    ck_assert_str_eq(f.text[1], "panel cuff: its area is 0.000 cm2, pieces below 1 cm2 cannot be sewn");

    /* one edge in two seams: told once, with the first seam */
    mus_seam_def def;
    mus_seam_def_init(&def, sizeof def);
    def.edge_a = s.edge[0], def.edge_b = s.edge[1];
    ck_assert_int_eq(mus_pattern_add_seam(p, &def, NULL), MUS_OK);
    f = check_of(p);
    ck_assert(f.count == 3 && f.kind[2] == MUS_FAULT_SEWN_TWICE && f.edge[2] == s.edge[1] && f.seam[2] == s.seam[0]);
    ck_assert_str_eq(f.text[2], "edge front.side: it is in 2 seams, one is the most; the first is seam 0");
    mus_pattern_destroy(p);
    support_context_end(context);
}
END_TEST


START_TEST(a_band_that_meets_itself_one_sidedly_is_named_by_its_edge)
{
    /* the word a b a c passes a twice the same way: a Moebius band without a seam */
    mus_context *context = support_context();
    mus_pattern *pattern = gluing_make(context, "A: a b a c", "", 0);
    mus_topology t;
    mus_topology_init(&t, sizeof t);
    ck_assert_int_eq(mus_pattern_topology(pattern, &t), MUS_OK);
    ck_assert(t.euler == 0 && t.loops == 1 && t.orientable == 0 && t.manifold == 1);
    faults f = check_of(pattern);
    bool found = false;
    for (int32_t i = 0; i < f.count; i++)
        found = found || (f.kind[i] == MUS_FAULT_TWISTED_SEAM && f.seam[i] == MUS_NONE);
    ck_assert(found);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


START_TEST(faults_are_kept_until_the_next_edit)
{
    mus_context *context = support_context();
    sample s = sample_make(context);
    int32_t panel, kind, count;
    ck_assert_int_eq(mus_pattern_add_panel(s.pattern, "cuff", &panel), MUS_OK);
    ck_assert_int_eq(check_of(s.pattern).count, 1);
    ck_assert_int_eq(mus_pattern_fault(s.pattern, 0, &kind, NULL, NULL, NULL, NULL), MUS_OK);

    /* a refused edit is none */
    ck_assert_int_eq(mus_pattern_add_panel(s.pattern, "cuff", &panel), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_fault(s.pattern, 0, &kind, NULL, NULL, NULL, NULL), MUS_OK);
    ck_assert_int_eq(mus_pattern_set_name(s.pattern, "edited"), MUS_OK);
    ck_assert_int_eq(mus_pattern_fault(s.pattern, 0, &kind, NULL, NULL, NULL, NULL), MUS_ERR_ARG);
    ck_assert_str_eq(mus_context_error(context), "fault 0 is unknown, the last check found 0");
    ck_assert_int_eq(kind, 0);

    ck_assert_int_eq(mus_pattern_check(NULL, &count), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_check(s.pattern, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_fault(NULL, 0, NULL, NULL, NULL, NULL, NULL), MUS_ERR_ARG);
    mus_pattern_destroy(s.pattern);
    support_context_end(context);
}
END_TEST


START_TEST(a_check_without_memory_keeps_the_old_faults)
{
    mus_context *context = support_context();
    sample s = sample_make(context);
    ck_assert_int_eq(mus_pattern_add_panel(s.pattern, "cuff", NULL), MUS_OK);
    ck_assert_int_eq(check_of(s.pattern).count, 1);
    for (int64_t n = 0;; n++) {
        int32_t count = 5;
        support_fail_after(n, false);
        mus_status status = mus_pattern_check(s.pattern, &count);
        support_fail_never();
        if (status == MUS_OK) {
            ck_assert_int_eq(count, 1);
            break;
        }
        ck_assert_int_eq(status, MUS_ERR_MEMORY);
        ck_assert_int_eq(mus_pattern_fault(s.pattern, 0, NULL, NULL, NULL, NULL, NULL), MUS_OK);
    }
    mus_pattern_destroy(s.pattern);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_check(void);


Suite *mus_suite_check(void)
{
    Suite *suite = suite_create("check");
    TCase *tcase = tcase_create("check");
    tcase_add_loop_test(tcase, sound_garments_have_no_fault_and_one_sided_ones_a_twisted_seam, 0, GARMENTS);
    tcase_add_test(tcase, the_twisted_seam_is_named_wherever_it_stands);
    tcase_add_test(tcase, sides_of_unequal_length_are_told_in_millimetres);
    tcase_add_test(tcase, ease_is_length_that_the_design_means);
    tcase_add_test(tcase, each_kind_of_fault_is_found_where_it_is);
    tcase_add_test(tcase, a_band_that_meets_itself_one_sidedly_is_named_by_its_edge);
    tcase_add_test(tcase, faults_are_kept_until_the_next_edit);
    tcase_add_test(tcase, a_check_without_memory_keeps_the_old_faults);
    suite_add_tcase(suite, tcase);
    return suite;
}
