/*
 * test_progress.c: the progress function of sew and settle: its period, the positions that it is told, how it stops a
 * run; and that a run does not depend on it.
 */
#include <math.h>
#include <string.h>

#include "scenes.h"
#include "worn.h"

typedef struct watcher {
    int32_t calls, coarse, stop_after;
    bool good;     /* all that was told made sense */
    double last;   /* progress of the last call */
    double sum;    /* of the positions of the last call */
} watcher;


static int32_t watch(void *user, const mus_progress *told)
{
    watcher *w = user;
    w->calls++;
    w->coarse += told->coarse != 0;
    w->good = w->good && told->size == sizeof *told && told->progress >= 0.0 && told->progress <= 1.0;
    w->good = w->good && (strcmp(told->phase, "sew") == 0 || strcmp(told->phase, "settle") == 0);
    w->sum = 0.0;
    for (int64_t i = 0; i < 3 * (int64_t)told->nodes; i++) w->sum += told->positions[i];
    w->good = w->good && isfinite(w->sum);
    for (int64_t i = 0; i < 3 * (int64_t)told->triangles; i++)
        w->good = w->good && told->triangle[i] >= 0 && told->triangle[i] < told->nodes;
    w->last = told->progress;
    return w->stop_after > 0 && w->calls >= w->stop_after;
}


/* a skirt on W40 that reports with a period [s] */
static worn skirt_start(double progress_seconds)
{
    worn w = worn_body("W40");
    mus_drape_def def;
    mus_drape_def_init(&def, sizeof def);
    ck_assert_double_eq(def.progress_seconds, 0.1);
    def.progress_seconds = progress_seconds;
    worn_put_on_design(&w, "skirt", NULL);
    w.cloth = scene_cut(w.context, w.pattern, 0.025, 0.0);
    worn_place(&w, &def);
    return w;
}


START_TEST(a_run_that_is_watched_ends_in_the_same_state)
{
    static const double periods[] = {0.0, 1e-9}; /* at each check, every few steps */
    worn plain = skirt_start(0.1), seen = skirt_start(periods[_i]);
    watcher w = {.good = true};
    ck_assert_int_eq(mus_drape_sew(plain.drape, NULL, NULL), MUS_OK);
    ck_assert_int_eq(mus_drape_settle(plain.drape, NULL, NULL), MUS_OK);
    ck_assert_int_eq(mus_drape_sew(seen.drape, watch, &w), MUS_OK);
    const int32_t sewing = w.calls;
    ck_assert_int_gt(sewing, 5);
    ck_assert_int_eq(mus_drape_settle(seen.drape, watch, &w), MUS_OK);
    ck_assert_int_gt(w.calls, sewing + 5);
    ck_assert_int_gt(w.coarse, 0);
    ck_assert(w.good);
    ck_assert_uint_eq(mus_drape_hash(seen.drape), mus_drape_hash(plain.drape));
    worn_end(&plain);
    worn_end(&seen);
}
END_TEST


/* the clock is looked at within a batch, which is 64 steps and more */
START_TEST(a_settle_stops_after_four_steps)
{
    worn w = skirt_start(1e-9);
    mus_drape_report before, after;
    watcher seen = {.good = true, .stop_after = 1};
    mus_drape_report_init(&before, sizeof before);
    mus_drape_report_init(&after, sizeof after);
    ck_assert_int_eq(mus_drape_sew(w.drape, NULL, NULL), MUS_OK);
    ck_assert_int_eq(mus_drape_settle(w.drape, NULL, NULL), MUS_OK);
    ck_assert_int_eq(mus_drape_report_get(w.drape, &before), MUS_OK);
    ck_assert_int_eq(mus_drape_settle(w.drape, watch, &seen), MUS_ERR_STOPPED);
    ck_assert_int_eq(seen.calls, 1);
    ck_assert_int_eq(mus_drape_report_get(w.drape, &after), MUS_OK);
    ck_assert_int_eq(after.steps - before.steps, 4);
    ck_assert_double_ge(after.residual, 0.0);
    ck_assert_int_eq(mus_drape_settle(w.drape, NULL, NULL), MUS_OK);
    worn_end(&w);
}
END_TEST


START_TEST(a_long_period_is_kept)
{
    worn w = skirt_start(1000.0);
    watcher seen = {.good = true};
    ck_assert_int_eq(mus_drape_sew(w.drape, watch, &seen), MUS_OK);
    ck_assert_int_eq(seen.calls, 1);
    worn_end(&w);
}
END_TEST


START_TEST(a_stopped_run_says_so_and_goes_on_when_called_again)
{
    worn w = skirt_start(0.0);
    mus_reason why;
    mus_reason_init(&why, sizeof why);
    watcher seen = {.good = true, .stop_after = 3};
    ck_assert_int_eq(mus_drape_sew(w.drape, watch, &seen), MUS_ERR_STOPPED);
    ck_assert_int_eq(seen.calls, 3);
    ck_assert_str_eq(mus_context_error(w.context), "sew: the progress function stopped the run");
    ck_assert_int_eq(mus_drape_reason(w.drape, &why), MUS_OK);
    ck_assert_int_eq(why.kind, MUS_REASON_STOPPED);
    ck_assert_str_eq(mus_reason_name(why.kind), "stopped");
    ck_assert_int_eq(mus_drape_sew(w.drape, NULL, NULL), MUS_OK);
    ck_assert_int_eq(mus_drape_settle(w.drape, watch, &seen), MUS_ERR_STOPPED);
    ck_assert_int_eq(mus_drape_settle(w.drape, NULL, NULL), MUS_OK);
    ck_assert_int_eq(mus_drape_reason(w.drape, &why), MUS_OK);
    ck_assert_int_eq(why.kind, MUS_REASON_SETTLED);
    worn_end(&w);
}
END_TEST


START_TEST(without_memory_for_positions_nothing_has_begun)
{
    worn w = skirt_start(0.0);
    watcher seen = {.good = true};
    const uint64_t hash = mus_drape_hash(w.drape);
    support_fail_after(0, false);
    ck_assert_int_eq(mus_drape_sew(w.drape, watch, &seen), MUS_ERR_MEMORY);
    support_fail_never();
    ck_assert_int_eq(seen.calls, 0);
    ck_assert_uint_eq(mus_drape_hash(w.drape), hash);
    worn_end(&w);
}
END_TEST


Suite *mus_suite_progress(void);
Suite *mus_suite_progress(void)
{
    Suite *suite = suite_create("progress");
    TCase *tests = tcase_create("progress");
    tcase_set_timeout(tests, 60.0);
    tcase_add_loop_test(tests, a_run_that_is_watched_ends_in_the_same_state, 0, 2);
    tcase_add_test(tests, a_settle_stops_after_four_steps);
    tcase_add_test(tests, a_long_period_is_kept);
    tcase_add_test(tests, a_stopped_run_says_so_and_goes_on_when_called_again);
    tcase_add_test(tests, without_memory_for_positions_nothing_has_begun);
    suite_add_tcase(suite, tests);
    return suite;
}
