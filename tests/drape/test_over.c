/*
 * test_over.c: a skirt over a skirt, joined by the public calls: sewn from inside to outside without a crossing, the
 * outer one outside; folds that lie on folds rest; a sewing that fails for want of memory can be done again, and a fit
 * gives back what it took.
 */
#include <math.h>

#include "muslin/muslin.h"
#include "scenes.h"

Suite *mus_suite_over(void);

typedef struct worn {
    mus_context *context;
    mus_body *body;
    mus_cloth *cloth;
    mus_drape *drape;
} worn;


/* skirts of a design over one another on W40, coarse, not yet sewn */
static worn worn_make(const char *design, int32_t layers, double spacing)
{
    worn w = {.context = support_context()};
    mus_tape *tape;
    mus_pattern *all = NULL;
    mus_drape_def def;
    ck_assert_int_eq(mus_tape_create(w.context, &tape), MUS_OK);
    ck_assert_int_eq(mus_tape_set_size(tape, "W40"), MUS_OK);
    ck_assert_int_eq(mus_body_create(w.context, tape, NULL, &w.body), MUS_OK);
    for (int32_t k = 0; k < layers; k++) {
        mus_pattern *one;
        mus_draft_def draft;
        mus_draft_def_init(&draft, sizeof draft);
        draft.ease = 0.06 + 0.08 * k;
        ck_assert_int_eq(mus_design_draft(w.context, mus_design_find(design), tape, &draft, &one), MUS_OK);
        if (k == 0) all = one;
        else ck_assert_int_eq(mus_pattern_join(all, one, k), MUS_OK);
        if (k > 0) mus_pattern_destroy(one);
    }
    w.cloth = scene_cut(w.context, all, spacing, 0.0);
    mus_drape_def_init(&def, sizeof def);
    def.self_contact = 1;
    ck_assert_int_eq(mus_drape_create(w.context, w.cloth, w.body, &def, &w.drape), MUS_OK);
    ck_assert_int_eq(mus_drape_place(w.drape), MUS_OK);
    mus_pattern_destroy(all);
    mus_tape_destroy(tape);
    return w;
}


/* a shirt with long sleeves and a coat with such over it, which are closed where an arm and a sleeve are */
static worn worn_sleeves(double spacing)
{
    worn w = {.context = support_context()};
    mus_tape *tape;
    mus_pattern *all, *coat;
    mus_drape_def def;
    ck_assert_int_eq(mus_tape_create(w.context, &tape), MUS_OK);
    ck_assert_int_eq(mus_tape_set_size(tape, "W40"), MUS_OK);
    ck_assert_int_eq(mus_body_create(w.context, tape, NULL, &w.body), MUS_OK);
    ck_assert_int_eq(mus_design_draft_words(w.context, "top sleeve=long shape=boxy", tape, NULL, &all), MUS_OK);
    const char *words = "top neck=v sleeve=long shape=boxy ease=coat";
    ck_assert_int_eq(mus_design_draft_words(w.context, words, tape, NULL, &coat), MUS_OK);
    ck_assert_int_eq(mus_pattern_join(all, coat, 1), MUS_OK);
    w.cloth = scene_cut(w.context, all, spacing, 0.0);
    mus_drape_def_init(&def, sizeof def);
    def.self_contact = 1;
    ck_assert_int_eq(mus_drape_create(w.context, w.cloth, w.body, &def, &w.drape), MUS_OK);
    ck_assert_int_eq(mus_drape_place(w.drape), MUS_OK);
    mus_pattern_destroy(all);
    mus_pattern_destroy(coat);
    mus_tape_destroy(tape);
    return w;
}


static void worn_end(worn *w)
{
    mus_drape_destroy(w->drape);
    mus_cloth_destroy(w->cloth);
    mus_body_destroy(w->body);
    support_context_end(w->context);
}


/* the seams under the arms close round sleeves that are worn, and go through nothing (1104 crossings while the shirt
 * was let down first: its sleeves hung out of those that were still open) */
START_TEST(sleeves_close_over_sleeves)
{
    worn w = worn_sleeves(0.045);
    int64_t count = -1;
    ck_assert_msg(mus_drape_sew(w.drape, NULL, NULL) == MUS_OK, "%s", mus_context_error(w.context));
    ck_assert_int_eq(mus_drape_crossings(w.drape, 0, NULL, &count), MUS_OK);
    ck_assert_int_eq(count, 0);
    worn_end(&w);
}
END_TEST


/* the folds of a circle skirt lie on each other: it was in motion after 65,000 steps while nodes that a fold had
 * pressed in passing were made heavy for good, and rests after 10,000 */
START_TEST(folds_that_lie_on_folds_come_to_rest)
{
    worn w = worn_make("full_skirt_midi", 1, 0.04);
    int64_t count = -1;
    ck_assert_msg(mus_drape_sew(w.drape, NULL, NULL) == MUS_OK, "%s", mus_context_error(w.context));
    ck_assert_msg(mus_drape_settle(w.drape, NULL, NULL) == MUS_OK, "%s", mus_context_error(w.context));
    ck_assert_int_eq(mus_drape_crossings(w.drape, 0, NULL, &count), MUS_OK);
    ck_assert_int_eq(count, 0);
    mus_drape_report report;
    mus_drape_report_init(&report, sizeof report);
    ck_assert_int_eq(mus_drape_report_get(w.drape, &report), MUS_OK);
    ck_assert_int_gt(report.self_contacts, 0);
    ck_assert_int_lt(report.steps, 25000);
    worn_end(&w);
}
END_TEST


START_TEST(a_skirt_is_sewn_over_a_skirt)
{
    worn w = worn_make("skirt_plain", 2, 0.045);
    int64_t count = -1;
    ck_assert_msg(mus_drape_sew(w.drape, NULL, NULL) == MUS_OK, "%s", mus_context_error(w.context));
    ck_assert_int_eq(mus_drape_crossings(w.drape, 0, NULL, &count), MUS_OK);
    ck_assert_int_eq(count, 0);
    mus_drape_report report;
    mus_drape_report_init(&report, sizeof report);
    ck_assert_int_eq(mus_drape_report_get(w.drape, &report), MUS_OK);
    ck_assert_int_eq(report.seams_closed, report.seams);

    /* below the hip the outer hem is farther from the middle, on the mean */
    const int32_t n = mus_drape_node_count(w.drape), *panel = mus_cloth_node_panels(w.cloth);
    const int32_t first = mus_cloth_panel_count(w.cloth) / 2;
    const double *x = mus_drape_positions(w.drape);
    double far[2] = {0.0, 0.0};
    int32_t nodes[2] = {0, 0};
    for (int32_t i = 0; i < n; i++) {
        const int32_t outer = panel[i] >= first;
        far[outer] += hypot(x[3 * i], x[3 * i + 2]);
        nodes[outer]++;
    }
    ck_assert_double_gt(far[1] / nodes[1], far[0] / nodes[0] + 0.001);
    worn_end(&w);
}
END_TEST


START_TEST(a_fit_that_finds_no_memory_gives_all_back)
{
    worn w = worn_make("skirt_plain", 1, 0.06);
    mus_status status = MUS_ERR_MEMORY;
    for (int64_t k = 0; status != MUS_OK; k++) {
        mus_fit *fit;
        const size_t before = support_live_bytes();
        support_fail_after(k, false);
        status = mus_fit_create(w.drape, w.body, &fit);
        support_fail_never();
        if (status != MUS_OK) {
            ck_assert_int_eq(status, MUS_ERR_MEMORY);
            ck_assert_ptr_null(fit);
            ck_assert(support_live_bytes() == before);
        }
        mus_fit_destroy(fit);
    }
    worn_end(&w);
}
END_TEST


Suite *mus_suite_over(void)
{
    Suite *suite = suite_create("over");
    TCase *tests = tcase_create("over");
    tcase_set_timeout(tests, 120);
    if (!SUPPORT_SLOW) tcase_add_test(tests, sleeves_close_over_sleeves);
    tcase_add_test(tests, a_skirt_is_sewn_over_a_skirt);
    tcase_add_test(tests, a_fit_that_finds_no_memory_gives_all_back);
    if (!SUPPORT_SLOW) tcase_add_test(tests, folds_that_lie_on_folds_come_to_rest);
    suite_add_tcase(suite, tests);
    return suite;
}
