/*
 * test_failing_allocations.c: every call from the tape to the draped garment with failing allocations.
 *
 * Each call is made with its first allocation failing, then its second, and so on until it succeeds; objects made
 * before it remain in use. At the end the garment is that of an undisturbed run, to the bit, and no memory is left
 * allocated.
 */
#include "muslin/muslin.h"
#include "support.h"

Suite *mus_suite_failing_allocations(void);

/* the objects of one run, from the tape to the drape */
typedef struct way {
    mus_context *context;
    mus_tape *tape;
    mus_body *body;
    mus_pattern *pattern;
    mus_cloth *cloth;
    mus_drape *drape;
    double *number; /* room for gaps and normals */
} way;

typedef mus_status (*way_step)(way *way);


static mus_status way_tape(way *w)
{
    return mus_tape_create(w->context, &w->tape);
}


static mus_status way_measures(way *w)
{
    mus_status status = mus_tape_set_size(w->tape, "W40");
    return status == MUS_OK ? mus_tape_complete(w->tape) : status;
}


static mus_status way_body(way *w)
{
    mus_body_def def;
    mus_body_def_init(&def, sizeof def);
    def.samples = 16;
    def.ring_spacing = 0.05;
    return mus_body_create(w->context, w->tape, &def, &w->body);
}


static mus_status way_draft(way *w)
{
    return mus_design_draft(w->context, mus_design_find("skirt"), w->tape, NULL, &w->pattern);
}


static mus_status way_check(way *w)
{
    int32_t count = -1;
    mus_topology topology;
    mus_topology_init(&topology, sizeof topology);
    mus_status status = mus_pattern_check(w->pattern, &count, NULL);
    if (status == MUS_OK) status = mus_pattern_topology(w->pattern, &topology);
    if (status == MUS_OK) ck_assert_int_eq(count, 0);
    return status;
}


static mus_status way_cloth(way *w)
{
    mus_cloth_def def;
    mus_cloth_def_init(&def, sizeof def);
    def.spacing = 0.05;
    return mus_cloth_create(w->context, w->pattern, &def, &w->cloth);
}


static mus_status way_drape(way *w)
{
    mus_drape_def def;
    mus_drape_def_init(&def, sizeof def);
    def.settle_residual = 10.0; /* a few looks at the state: rest is not what is asked here */
    return mus_drape_create(w->context, w->cloth, w->body, &def, &w->drape);
}


static mus_status way_place(way *w)
{
    return mus_drape_place(w->drape);
}


static mus_status way_sew(way *w)
{
    return mus_drape_sew(w->drape, NULL, NULL);
}


static mus_status way_walk(way *w)
{
    return mus_drape_step(w->drape, 20, 0.5 * mus_drape_step_bound(w->drape));
}


static mus_status way_settle(way *w)
{
    return mus_drape_settle(w->drape, NULL, NULL);
}


static mus_status way_report(way *w)
{
    mus_drape_report report;
    mus_drape_report_init(&report, sizeof report);
    mus_status status = mus_drape_report_get(w->drape, &report);
    if (status == MUS_OK) status = mus_drape_gaps(w->drape, w->number);
    if (status == MUS_OK) status = mus_drape_normals(w->drape, w->number);
    if (status == MUS_OK) ck_assert_int_eq(report.seams_closed, report.seams);
    return status;
}


static const struct {
    const char *name;
    way_step step;
    bool allocates;
} way_steps[] = {
    {"tape", way_tape, true},   {"measures", way_measures, true}, {"body", way_body, true},
    {"draft", way_draft, true}, {"check", way_check, true},       {"cloth", way_cloth, true},
    {"drape", way_drape, true}, {"place", way_place, false},      {"sew", way_sew, true},
    {"walk", way_walk, false},  {"settle", way_settle, true},    {"report", way_report, false},
};


/* one step with its n-th allocation failing for n = 0, 1, ... until it gets through; returns the failures */
static int32_t way_through(way *w, int32_t k, bool failing)
{
    for (int32_t n = 0;; n++) {
        const size_t bytes = mus_context_bytes(w->context);
        const int64_t asked = support_allocations();
        if (failing) support_fail_after(n, false);
        const mus_status status = way_steps[k].step(w);
        support_fail_never();
        if (status == MUS_OK) {
            if (!way_steps[k].allocates) ck_assert_int_eq(support_allocations(), asked);
            return n;
        }
        ck_assert_msg(failing && status == MUS_ERR_MEMORY, "%s, allocation %d: status %d (%s)", way_steps[k].name,
                      (int)n, (int)status, mus_context_error(w->context));
        ck_assert_msg(mus_context_bytes(w->context) == bytes, "%s, allocation %d: %zu bytes more are held",
                      way_steps[k].name, (int)n, mus_context_bytes(w->context) - bytes);
    }
}


/* the whole way; the hash at its end, and the failures met */
static uint64_t way_run(bool failing, int32_t *failures)
{
    static double number[300000];
    way w = {.context = support_context(), .number = number};
    *failures = 0;
    for (size_t k = 0; k < sizeof way_steps / sizeof *way_steps; k++) *failures += way_through(&w, (int32_t)k, failing);
    const uint64_t hash = mus_drape_hash(w.drape);
    mus_drape_destroy(w.drape);
    mus_cloth_destroy(w.cloth);
    mus_pattern_destroy(w.pattern);
    mus_body_destroy(w.body);
    mus_tape_destroy(w.tape);
    support_context_end(w.context);
    return hash;
}


START_TEST(each_allocation_on_the_way_may_fail_and_the_end_is_the_same)
{
    int32_t failures;
    const uint64_t undisturbed = way_run(false, &failures);
    ck_assert_int_eq(failures, 0);
    ck_assert_uint_eq(way_run(true, &failures), undisturbed);
    ck_assert_int_gt(failures, 100);
    ck_assert_int_eq(failures, support_refused());
}
END_TEST


Suite *mus_suite_failing_allocations(void)
{
    Suite *suite = suite_create("failing_allocations");
    TCase *tests = tcase_create("way");
    tcase_set_timeout(tests, 120);
    tcase_add_test(tests, each_allocation_on_the_way_may_fail_and_the_end_is_the_same);
    suite_add_tcase(suite, tests);
    return suite;
}
