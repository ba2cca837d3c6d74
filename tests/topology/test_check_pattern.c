/*
 * test_check_pattern.c: every fault is found, named and said in a sentence, and a sound garment has none.
 */
#include "muslin/topology.h"
#include "pattern/same.h"
#include "topology/garments.h"
#include "topology/gluing.h"


/* the faults of a check, at most 8 */
typedef struct faults {
    int32_t count, kind[8], panel[8], edge[8], seam[8];
    char text[8][1024];
} faults;


static faults check_of(const mus_pattern *pattern)
{
    faults f = {0};
    mus_faults *found;
    ck_assert_int_eq(mus_pattern_check(pattern, &f.count, &found), MUS_OK);
    ck_assert_int_eq(mus_faults_count(found), f.count);
    for (int32_t i = 0; i < f.count && i < 8; i++) {
        ck_assert_int_eq(mus_faults_item(found, i, &f.kind[i], &f.panel[i], &f.edge[i], &f.seam[i]), MUS_OK);
        snprintf(f.text[i], sizeof f.text[i], "%s", mus_faults_text(found, i));
        ck_assert_uint_gt(strlen(f.text[i]), 20);
    }
    mus_faults_destroy(found);
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
        int32_t panel, p[4], edges[4];
        double height = k == 0 ? 0.412 : 0.426, xy[8] = {0.0, 0.0, 0.3, 0.0, 0.3, height, 0.0, height};
        ck_assert_int_eq(mus_pattern_add_panel(pattern, k == 0 ? "front" : "back", &panel), MUS_OK);
        for (int32_t i = 0; i < 4; i++)
            ck_assert_int_eq(mus_pattern_add_point(pattern, panel, xy[2 * i], xy[2 * i + 1], &p[i]), MUS_OK);
        for (int32_t i = 0; i < 4; i++)
            ck_assert_int_eq(mus_pattern_add_edge(pattern, &(mus_edge_def){.size = sizeof(mus_edge_def),
                                                                           .name = i == 1 ? "side" : NULL,
                                                                           .start = p[i], .end = p[(i + 1) % 4]},
                                                  &edges[i]),
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
    int32_t panel, point[4], edge[4], along[4] = {1, 1, 1, 1};
    ck_assert_int_eq(mus_pattern_add_panel(p, "cuff", &panel), MUS_OK);
    faults f = check_of(p);
    ck_assert(f.count == 1 && f.kind[0] == MUS_FAULT_OPEN_OUTLINE && f.panel[0] == panel && f.edge[0] == MUS_NONE);
    ck_assert_str_eq(f.text[0], "panel cuff: it has no closed outline");

    /* a bow tie of 9 mm, its edges in no outline at first */
    double xy[8] = {0.0, 0.0, 0.009, 0.0, 0.0, 0.009, 0.009, 0.009};
    for (int32_t i = 0; i < 4; i++)
        ck_assert_int_eq(mus_pattern_add_point(p, panel, xy[2 * i], xy[2 * i + 1], &point[i]), MUS_OK);
    for (int32_t i = 0; i < 4; i++)
        ck_assert_int_eq(mus_pattern_add_edge(p, &(mus_edge_def){.size = sizeof(mus_edge_def), .start = point[i],
                                                                 .end = point[(i + 1) % 4]}, &edge[i]),
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


START_TEST(faults_outlive_the_pattern_that_they_were_found_in)
{
    mus_context *context = support_context();
    sample s = sample_make(context);
    int32_t panel, kind, count;
    mus_faults *found, *none;
    ck_assert_int_eq(mus_pattern_add_panel(s.pattern, "cuff", &panel), MUS_OK);
    ck_assert_int_eq(mus_pattern_check(s.pattern, NULL, &found), MUS_OK);

    /* a check leaves the pattern as it was, history included; without out it counts only */
    ck_assert_int_eq(mus_pattern_check(s.pattern, &count, NULL), MUS_OK);
    ck_assert_int_eq(count, 1);
    ck_assert_int_eq(mus_pattern_check(NULL, &count, &none), MUS_ERR_ARG);
    ck_assert_int_eq(count, 0);
    ck_assert_ptr_null(none);
    ck_assert_int_eq(mus_pattern_check(s.pattern, NULL, NULL), MUS_ERR_ARG);

    mus_pattern_destroy(s.pattern);
    ck_assert_int_eq(mus_faults_item(found, 0, &kind, NULL, NULL, NULL), MUS_OK);
    ck_assert_int_eq(kind, MUS_FAULT_OPEN_OUTLINE);
    ck_assert_ptr_nonnull(strstr(mus_faults_text(found, 0), "cuff"));
    ck_assert_int_eq(mus_faults_item(found, 1, &kind, NULL, NULL, NULL), MUS_ERR_ARG);
    ck_assert_str_eq(mus_context_error(context), "fault 1 is unknown, the check found 1");
    ck_assert_int_eq(kind, 0);
    ck_assert_ptr_null(mus_faults_text(found, 1));
    ck_assert_ptr_null(mus_faults_text(NULL, 0));
    ck_assert_int_eq(mus_faults_count(NULL), 0);
    ck_assert_int_eq(mus_faults_item(NULL, 0, NULL, NULL, NULL, NULL), MUS_ERR_ARG);
    mus_faults_destroy(found);
    mus_faults_destroy(NULL);
    support_context_end(context);
}
END_TEST


START_TEST(a_check_without_memory_gives_no_faults)
{
    mus_context *context = support_context();
    sample s = sample_make(context);
    ck_assert_int_eq(mus_pattern_add_panel(s.pattern, "cuff", NULL), MUS_OK);
    for (int64_t n = 0;; n++) {
        int32_t count = 5;
        mus_faults *found;
        support_fail_after(n, false);
        mus_status status = mus_pattern_check(s.pattern, &count, &found);
        support_fail_never();
        ck_assert_int_eq(count, mus_faults_count(found));
        ck_assert_int_eq(status == MUS_OK, found != NULL);
        mus_faults_destroy(found);
        if (status == MUS_OK) break;
        ck_assert_int_eq(status, MUS_ERR_MEMORY);
    }
    ck_assert_int_eq(check_of(s.pattern).count, 1);
    mus_pattern_destroy(s.pattern);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_check_pattern(void);


Suite *mus_suite_check_pattern(void)
{
    Suite *suite = suite_create("check_pattern");
    TCase *tcase = tcase_create("check");
    tcase_add_loop_test(tcase, sound_garments_have_no_fault_and_one_sided_ones_a_twisted_seam, 0, GARMENTS);
    tcase_add_test(tcase, the_twisted_seam_is_named_wherever_it_stands);
    tcase_add_test(tcase, sides_of_unequal_length_are_told_in_millimetres);
    tcase_add_test(tcase, ease_is_length_that_the_design_means);
    tcase_add_test(tcase, each_kind_of_fault_is_found_where_it_is);
    tcase_add_test(tcase, a_band_that_meets_itself_one_sidedly_is_named_by_its_edge);
    tcase_add_test(tcase, faults_outlive_the_pattern_that_they_were_found_in);
    tcase_add_test(tcase, a_check_without_memory_gives_no_faults);
    suite_add_tcase(suite, tcase);
    return suite;
}
