/*
 * test_dress.c: mus_dress() gives what the steps one by one give, tries another start where the first one fails, and
 * tells which starts it tried.
 */
#include <pthread.h>
#include <string.h>

#include "drape/scenes.h"
#include "drape/worn.h"

#define SPACING 0.04 /* [m] coarse: the tests ask which way was taken, not how the cloth lies */


typedef struct dressing {
    mus_dress_def def;
    mus_dress_report report;
    mus_reason reason;
    mus_cloth *cloth;
    mus_drape *drape;
} dressing;


static dressing dressing_start(void)
{
    dressing d;
    memset(&d, 0, sizeof d);
    mus_dress_def_init(&d.def, sizeof d.def);
    mus_dress_report_init(&d.report, sizeof d.report);
    mus_reason_init(&d.reason, sizeof d.reason);
    d.def.spacing = SPACING;
    return d;
}


static mus_status dressing_run(dressing *d, const worn *w)
{
    mus_drape_destroy(d->drape);
    mus_cloth_destroy(d->cloth);
    return mus_dress(w->context, w->pattern, w->body, &d->def, &d->report, &d->reason, &d->cloth, &d->drape);
}


static void dressing_end(dressing *d)
{
    mus_drape_destroy(d->drape);
    mus_cloth_destroy(d->cloth);
}


static worn skirt(void)
{
    worn w = worn_body("W40");
    worn_put_on_design(&w, "skirt", NULL);
    return w;
}


/* the front of the skirt begins in the middle of the body */
static worn skirt_in_the_body(void)
{
    worn w = skirt();
    scene_move(w.pattern, 0, 0.0, 0.9, 0.0);
    return w;
}


START_TEST(one_call_gives_the_state_of_the_steps_one_by_one)
{
    worn w = skirt();
    mus_drape_def def;
    mus_drape_def_init(&def, sizeof def);
    def.self_contact = _i;
    w.cloth = scene_cut(w.context, w.pattern, SPACING, 0.0);
    mus_fabric fabric;
    mus_fabric_init(&fabric, sizeof fabric);
    fabric.damping = 0.0;
    worn_place(&w, &def);
    ck_assert_int_eq(mus_drape_sew(w.drape, NULL, NULL), MUS_OK);
    ck_assert_int_eq(mus_drape_settle(w.drape, NULL, NULL), MUS_OK);

    dressing d = dressing_start();
    d.def.fabric = &fabric;
    d.def.self_contact = _i;
    ck_assert_int_eq(dressing_run(&d, &w), MUS_OK);
    ck_assert_uint_eq(mus_drape_hash(d.drape), mus_drape_hash(w.drape));
    ck_assert_int_eq(d.reason.kind, MUS_REASON_SETTLED);
    ck_assert_int_eq(d.report.starts, 1);
    ck_assert_int_eq(d.report.kept, 0);
    ck_assert_int_eq(d.report.found, 0);
    ck_assert_int_eq(d.report.start_place[0], MUS_DRESS_PLACE_PATTERN);
    ck_assert_int_eq(d.report.start_patient[0], 0);
    ck_assert_int_eq(d.report.start_end[0], MUS_REASON_SETTLED);
    ck_assert(d.report.start_seconds[0] > 0.0 && d.report.sew_seconds > 0.0 && d.report.settle_seconds > 0.0);

    /* the same by all options of the drape */
    d.def.drape = &def;
    d.def.self_contact = !_i;
    ck_assert_int_eq(dressing_run(&d, &w), MUS_OK);
    ck_assert_uint_eq(mus_drape_hash(d.drape), mus_drape_hash(w.drape));
    dressing_end(&d);
    worn_end(&w);
}
END_TEST


START_TEST(without_a_fabric_it_is_jersey_with_its_friction)
{
    worn w = skirt();
    dressing d = dressing_start();
    mus_fabric fabric;
    mus_fabric_init(&fabric, sizeof fabric);
    ck_assert_int_eq(dressing_run(&d, &w), MUS_OK);
    const uint64_t without = mus_drape_hash(d.drape);
    d.def.fabric = &fabric;
    ck_assert_int_eq(dressing_run(&d, &w), MUS_OK);
    ck_assert_uint_ne(mus_drape_hash(d.drape), without);
    ck_assert_int_eq(mus_fabric_find("jersey", &fabric), MUS_OK);
    ck_assert_int_eq(dressing_run(&d, &w), MUS_OK);
    ck_assert_uint_eq(mus_drape_hash(d.drape), without);
    dressing_end(&d);
    worn_end(&w);
}
END_TEST


START_TEST(a_start_in_the_body_is_left_for_the_found_one)
{
    worn w = skirt_in_the_body();
    dressing d = dressing_start();
    ck_assert_int_eq(dressing_run(&d, &w), MUS_OK);
    ck_assert_int_eq(d.report.found, 1);
    ck_assert_int_eq(d.report.starts, 2);
    ck_assert_int_eq(d.report.kept, 1);
    ck_assert_int_eq(d.report.start_end[0], MUS_REASON_START_TANGLED);
    ck_assert_int_eq(d.report.start_place[1], MUS_DRESS_PLACE_FOUND);
    ck_assert_int_eq(d.report.start_end[1], MUS_REASON_SETTLED);
    const uint64_t hash = mus_drape_hash(d.drape);

    /* asked for at once, it is the same; and the caller's pattern is as it was */
    d.def.place = MUS_DRESS_PLACE_FOUND;
    ck_assert_int_eq(dressing_run(&d, &w), MUS_OK);
    ck_assert_int_eq(d.report.starts, 1);
    ck_assert_int_eq(d.report.found, 1);
    ck_assert_uint_eq(mus_drape_hash(d.drape), hash);
    mus_placement place;
    mus_placement_init(&place, sizeof place);
    ck_assert_int_eq(mus_pattern_placement(w.pattern, 0, &place), MUS_OK);
    ck_assert(place.origin[1] == 0.9);
    dressing_end(&d);
    worn_end(&w);
}
END_TEST


START_TEST(without_another_start_a_bad_one_is_refused_with_its_reason)
{
    worn w = skirt_in_the_body();
    dressing d = dressing_start();
    if (_i == 0) d.def.retry = 0;
    if (_i == 1) d.def.place = MUS_DRESS_PLACE_PATTERN;
    ck_assert_int_eq(dressing_run(&d, &w), MUS_ERR_SEW);
    ck_assert_int_eq(d.report.starts, 1);
    ck_assert_int_eq(d.reason.kind, MUS_REASON_START_TANGLED);
    ck_assert_int_eq(d.reason.panel, 0);
    ck_assert_str_eq(mus_context_error(w.context), d.reason.text);
    ck_assert_ptr_nonnull(strstr(d.reason.text, "inside the body"));
    ck_assert_ptr_nonnull(d.cloth);
    ck_assert_ptr_nonnull(d.drape);
    dressing_end(&d);
    worn_end(&w);
}
END_TEST


START_TEST(a_pattern_without_a_placement_starts_where_one_is_found)
{
    worn w = skirt();
    mus_placement none;
    mus_placement_init(&none, sizeof none);
    for (int32_t p = 0; p < mus_pattern_panel_count(w.pattern); p++)
        ck_assert_int_eq(mus_pattern_set_placement(w.pattern, p, &none), MUS_OK);
    dressing d = dressing_start();
    ck_assert_int_eq(dressing_run(&d, &w), MUS_OK);
    ck_assert_int_eq(d.report.found, 1);
    ck_assert_int_eq(d.report.starts, 1);
    ck_assert_int_eq(d.report.start_place[0], MUS_DRESS_PLACE_FOUND);
    dressing_end(&d);
    worn_end(&w);
}
END_TEST


START_TEST(a_pattern_at_fault_gives_nothing_but_the_fault)
{
    worn w = worn_body("W40");
    int32_t edge[4];
    ck_assert_int_eq(mus_pattern_create(w.context, "strip", &w.pattern), MUS_OK);
    scene_rectangle(w.pattern, "strip", 0, 0, 0.3, 0.1, edge);
    scene_move(w.pattern, 0, 0.0, 1.0, 0.5);
    scene_sew(w.pattern, edge[0], edge[1], 0.0);
    dressing d = dressing_start();
    ck_assert_int_eq(dressing_run(&d, &w), MUS_ERR_PATTERN);
    ck_assert_ptr_null(d.cloth);
    ck_assert_ptr_null(d.drape);
    ck_assert_int_eq(d.reason.kind, MUS_REASON_BAD_INPUT);
    ck_assert_str_ne(d.reason.text, "");
    ck_assert_int_eq(d.report.starts, 1);
    dressing_end(&d);
    worn_end(&w);
}
END_TEST


/* a progress function that counts its calls, and what it answers */
typedef struct listener {
    int32_t calls, stop;
} listener;


static int32_t listen(void *user, const mus_progress *progress)
{
    listener *l = user;
    (void)progress;
    l->calls++;
    return l->stop;
}


/* dresses w until the run is stopped: one start was tried, and what there is of the garment is given with the reason */
static void run_until_stopped(dressing *d, const worn *w)
{
    ck_assert_int_eq(dressing_run(d, w), MUS_ERR_STOPPED);
    ck_assert_int_eq(d->report.starts, 1);
    ck_assert_ptr_nonnull(d->drape);
    ck_assert_int_eq(d->reason.kind, MUS_REASON_STOPPED);
    ck_assert_str_eq(d->reason.text, mus_context_error(w->context));
}


START_TEST(a_stopped_run_says_so_and_tries_no_more)
{
    worn w = skirt();
    dressing d = dressing_start();
    listener l = {.stop = 1};
    d.def.progress = listen, d.def.progress_user = &l;
    run_until_stopped(&d, &w);
    ck_assert_int_eq(l.calls, 1);
    dressing_end(&d);
    worn_end(&w);
}
END_TEST


/* a run that may take next to no time ends at the first look at the clock, with and without a progress function; one
 * that has an hour is the same as one without a limit */
START_TEST(a_run_over_its_time_says_so_and_tries_no_more)
{
    worn w = skirt();
    listener l = {0};
    for (int32_t k = 0; k < 2; k++) {
        dressing d = dressing_start();
        d.def.seconds_most = 1e-9;
        if (k > 0) d.def.progress = listen, d.def.progress_user = &l;
        run_until_stopped(&d, &w);
        ck_assert_str_eq(d.reason.text, "no end after 1e-09 s");
        dressing_end(&d);
    }
    ck_assert_int_eq(l.calls, 1);
    uint64_t hash[2];
    for (int32_t k = 0; k < 2; k++) {
        dressing d = dressing_start();
        d.def.seconds_most = k == 0 ? 0.0 : 3600.0;
        ck_assert_int_eq(dressing_run(&d, &w), MUS_OK);
        hash[k] = mus_drape_hash(d.drape);
        dressing_end(&d);
    }
    ck_assert_uint_eq(hash[0], hash[1]);
    static const double bad[] = {-1.0, NAN, INFINITY};
    for (int32_t k = 0; k < 3; k++) {
        dressing d = dressing_start();
        d.def.seconds_most = bad[k];
        ck_assert_int_eq(dressing_run(&d, &w), MUS_ERR_ARG);
        ck_assert_ptr_nonnull(strstr(mus_context_error(w.context), "seconds_most is"));
        dressing_end(&d);
    }
    worn_end(&w);
}
END_TEST


START_TEST(closures_are_left_open_in_a_copy)
{
    worn w = worn_body("W40");
    worn_put_on_design(&w, "shirt_dress", NULL);
    const int32_t seams = mus_pattern_seam_count(w.pattern);
    dressing d = dressing_start();
    ck_assert_int_eq(dressing_run(&d, &w), MUS_OK);
    const int32_t pairs = mus_cloth_pair_count(d.cloth);
    d.def.open_closures = 1;
    ck_assert_int_eq(dressing_run(&d, &w), MUS_OK);
    ck_assert_int_lt(mus_cloth_pair_count(d.cloth), pairs);
    ck_assert_int_eq(mus_pattern_seam_count(w.pattern), seams);
    d.def.open_closures = 0;
    ck_assert_int_eq(dressing_run(&d, &w), MUS_OK);
    ck_assert_int_eq(mus_cloth_pair_count(d.cloth), pairs);
    dressing_end(&d);
    worn_end(&w);
}
END_TEST


START_TEST(arguments_are_looked_at)
{
    worn w = skirt();
    dressing d = dressing_start();
    mus_drape *drape = NULL;
    ck_assert_int_eq(mus_dress(NULL, w.pattern, w.body, NULL, NULL, NULL, NULL, &drape), MUS_ERR_ARG);
    ck_assert_int_eq(mus_dress(w.context, NULL, w.body, NULL, NULL, NULL, NULL, &drape), MUS_ERR_ARG);
    ck_assert_int_eq(mus_dress(w.context, w.pattern, w.body, NULL, NULL, NULL, NULL, NULL), MUS_ERR_ARG);
    d.def.place = 3;
    ck_assert_int_eq(dressing_run(&d, &w), MUS_ERR_ARG);
    ck_assert_ptr_nonnull(strstr(mus_context_error(w.context), "place is 3"));
    d.def.place = MUS_DRESS_PLACE_BOTH;
    d.def.size = 4;
    ck_assert_int_eq(dressing_run(&d, &w), MUS_ERR_VERSION);
    d.def.size = sizeof d.def;
    d.report.size = 0;
    ck_assert_int_eq(dressing_run(&d, &w), MUS_ERR_VERSION);
    mus_dress_report_init(&d.report, sizeof d.report);
    d.reason.size = 0;
    ck_assert_int_eq(dressing_run(&d, &w), MUS_ERR_VERSION);
    ck_assert_ptr_null(d.drape);
    worn_end(&w);
}
END_TEST


START_TEST(without_memory_nothing_is_lost)
{
    for (int64_t n = 0, done = 0; !done; n += 1 + n / 4) {
        worn w = skirt_in_the_body();
        dressing d = dressing_start();
        d.def.spacing = 0.1;
        support_fail_after(n, false);
        const mus_status status = dressing_run(&d, &w);
        support_fail_never();
        if (status == MUS_OK)
            done = 1;
        else
            ck_assert(status == MUS_ERR_MEMORY || status == MUS_ERR_SEW);
        dressing_end(&d);
        worn_end(&w);
    }
}
END_TEST


typedef struct in_thread {
    const worn *w;
    dressing *d;
    mus_status status;
} in_thread;


static void *dress_in_thread(void *argument)
{
    in_thread *t = argument;
    t->status = dressing_run(t->d, t->w);
    return NULL;
}


/* muslin(3) promises it; contact in double has the largest local arrays */
START_TEST(a_call_takes_at_most_256_kib_of_stack)
{
    worn w = skirt();
    dressing d = dressing_start();
    pthread_attr_t attr;
    pthread_t thread;
    d.def.precision = 64;
    d.def.self_contact = 1;
    d.def.threads = 1 + _i;
    in_thread t = {&w, &d, MUS_ERR_STATE};
    ck_assert_int_eq(pthread_attr_init(&attr), 0);
    ck_assert_int_eq(pthread_attr_setstacksize(&attr, (SUPPORT_SLOW ? 8 : 1) * ((size_t)256 << 10)), 0);
    ck_assert_int_eq(pthread_create(&thread, &attr, dress_in_thread, &t), 0);
    ck_assert_int_eq(pthread_join(thread, NULL), 0);
    ck_assert_int_eq(t.status, MUS_OK);
    pthread_attr_destroy(&attr);
    dressing_end(&d);
    worn_end(&w);
}
END_TEST


Suite *mus_suite_dress(void);
Suite *mus_suite_dress(void)
{
    Suite *suite = suite_create("dress");
    TCase *tests = tcase_create("dress");
    tcase_set_timeout(tests, 60.0);
    tcase_add_loop_test(tests, one_call_gives_the_state_of_the_steps_one_by_one, 0, 2);
    tcase_add_test(tests, without_a_fabric_it_is_jersey_with_its_friction);
    tcase_add_test(tests, a_start_in_the_body_is_left_for_the_found_one);
    tcase_add_loop_test(tests, without_another_start_a_bad_one_is_refused_with_its_reason, 0, 2);
    tcase_add_test(tests, a_pattern_without_a_placement_starts_where_one_is_found);
    tcase_add_test(tests, a_pattern_at_fault_gives_nothing_but_the_fault);
    tcase_add_test(tests, a_stopped_run_says_so_and_tries_no_more);
    tcase_add_test(tests, a_run_over_its_time_says_so_and_tries_no_more);
    tcase_add_test(tests, closures_are_left_open_in_a_copy);
    tcase_add_test(tests, arguments_are_looked_at);
    tcase_add_test(tests, without_memory_nothing_is_lost);
    tcase_add_loop_test(tests, a_call_takes_at_most_256_kib_of_stack, 0, 2);
    suite_add_tcase(suite, tests);
    return suite;
}
