/*
 * test_seam.c: seams: their def and its versions, what an edge knows of its seam, what is refused.
 */
#include <math.h>

#include "pattern/same.h"


START_TEST(a_seam_comes_back_as_it_was_given)
{
    mus_context *context = support_context();
    sample s = sample_make(context);
    mus_seam_def def, got;
    mus_seam_def_init(&def, sizeof def);
    ck_assert(def.edge_a == MUS_NONE && def.edge_b == MUS_NONE && def.direction == MUS_SEAM_REVERSED);
    ck_assert(def.ease == 0.0 && def.tolerance == 0.0005 && def.size == sizeof def);
    def.edge_a = s.edge[0], def.edge_b = s.edge[6], def.direction = MUS_SEAM_DIRECT, def.ease = -0.0125,
    def.tolerance = 0.0;
    int32_t seam;
    ck_assert_int_eq(mus_pattern_edge_seam(s.pattern, s.edge[0]), MUS_NONE);
    ck_assert_int_eq(mus_pattern_add_seam(s.pattern, &def, &seam), MUS_OK);
    mus_seam_def_init(&got, sizeof got);
    ck_assert_int_eq(mus_pattern_seam(s.pattern, seam, &got), MUS_OK);
    ck_assert(got.edge_a == def.edge_a && got.edge_b == def.edge_b && got.direction == def.direction);
    ck_assert(got.ease == def.ease && got.tolerance == def.tolerance && got.size == sizeof got);
    ck_assert_int_eq(mus_pattern_edge_seam(s.pattern, s.edge[0]), seam);
    ck_assert_int_eq(mus_pattern_edge_seam(s.pattern, s.edge[6]), seam);

    /* an edge in two seams tells the first */
    def.edge_b = s.edge[4];
    ck_assert_int_eq(mus_pattern_add_seam(s.pattern, &def, NULL), MUS_OK);
    ck_assert_int_eq(mus_pattern_edge_seam(s.pattern, s.edge[0]), seam);
    mus_pattern_destroy(s.pattern);
    support_context_end(context);
}
END_TEST


START_TEST(a_wrong_seam_is_refused_with_a_sentence)
{
    mus_context *context = support_context();
    sample s = sample_make(context);
    mus_pattern *before;
    ck_assert_int_eq(mus_pattern_copy(s.pattern, &before), MUS_OK);
    mus_seam_def good, def;
    mus_seam_def_init(&good, sizeof good);
    good.edge_a = s.edge[0], good.edge_b = s.edge[4];
    static const char *words[] = {"edge -1 is unknown", "edge 8 is unknown", "edge front.hem cannot be sewn to itself",
                                  "direction 2",        "ease of nan",       "tolerance of -0.1",
                                  "tolerance of inf",   "seam def: size"};
    for (int32_t i = 0; i < 8; i++) {
        int32_t out = 3;
        def = good;
        if (i == 0) def.edge_a = MUS_NONE;
        if (i == 1) def.edge_b = 8;
        if (i == 2) def.edge_b = def.edge_a;
        if (i == 3) def.direction = 2;
        if (i == 4) def.ease = fabs((double)NAN);
        if (i == 5) def.tolerance = -0.1;
        if (i == 6) def.tolerance = (double)INFINITY;
        if (i == 7) def.size = 12;
        ck_assert_int_eq(mus_pattern_add_seam(s.pattern, &def, &out), i == 7 ? MUS_ERR_VERSION : MUS_ERR_ARG);
        ck_assert_msg(strstr(mus_context_error(context), words[i]) != NULL, "'%s'", mus_context_error(context));
        ck_assert_int_eq(out, MUS_NONE);
        same_pattern(s.pattern, before);
    }
    ck_assert_int_eq(mus_pattern_add_seam(s.pattern, NULL, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_add_seam(NULL, &good, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_seam(s.pattern, 2, &def), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_seam(s.pattern, 0, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_pattern_seam(NULL, 0, &def), MUS_ERR_ARG);
    def.size = 4;
    ck_assert_int_eq(mus_pattern_seam(s.pattern, 0, &def), MUS_ERR_VERSION);
    mus_seam_def_init(NULL, sizeof def);
    mus_pattern_destroy(before);
    mus_pattern_destroy(s.pattern);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_seam(void);


Suite *mus_suite_seam(void)
{
    Suite *suite = suite_create("seam");
    TCase *tcase = tcase_create("seam");
    tcase_add_test(tcase, a_seam_comes_back_as_it_was_given);
    tcase_add_test(tcase, a_wrong_seam_is_refused_with_a_sentence);
    suite_add_tcase(suite, tcase);
    return suite;
}
