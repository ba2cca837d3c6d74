/*
 * test_memory_again.c: each allocation of a call fails in turn, and the same objects are used again after each failure:
 * the call then succeeds, and its result is that of objects that never lacked memory.
 */
#include <stdio.h>
#include <string.h>

#include "drape/scenes.h"
#include "muslin/design.h"
#include "muslin/edit.h"
#include "muslin/fit.h"
#include "muslin/pose.h"
#include "muslin/topology.h"

Suite *mus_suite_memory_again(void);

/* objects that live through all failures, and the result of the last call */
typedef struct wardrobe {
    mus_context *context;
    mus_tape *tape;
    mus_body *body;
    mus_pattern *pattern;
    mus_cloth *cloth;
    mus_drape *drape;
    uint64_t result;
} wardrobe;

typedef mus_status (*wardrobe_call)(wardrobe *w);


/* digest of the canonical form of a pattern, in *hash */
static mus_status form_of(const mus_pattern *pattern, uint64_t *hash)
{
    uint64_t half[2] = {0, 0};
    size_t n;
    const mus_status status = mus_pattern_form(pattern, NULL, NULL, 0, &n, half);
    *hash = half[0] ^ half[1];
    return status;
}


/* a drape that has not sewn yet: later it has the memory that sewing takes */
static void renew_drape(wardrobe *w)
{
    mus_drape_destroy(w->drape);
    w->drape = scene_drape(w->context, w->cloth, 32, 2);
}


static mus_status call_sew(wardrobe *w)
{
    mus_status status = mus_drape_place(w->drape);
    if (status == MUS_OK) status = mus_drape_sew(w->drape, NULL, NULL);
    if (status == MUS_OK) status = mus_drape_step(w->drape, 20, 0.5 * mus_drape_step_bound(w->drape));
    w->result = mus_drape_hash(w->drape);
    return status;
}


static mus_status call_cloth_and_drape(wardrobe *w)
{
    mus_cloth_def def;
    mus_cloth *cloth = NULL;
    mus_drape *drape = NULL;
    mus_drape_def how;
    mus_cloth_def_init(&def, sizeof def);
    mus_drape_def_init(&how, sizeof how);
    def.spacing = 0.04, how.self_contact = 1, how.threads = 2;
    mus_status status = mus_cloth_create(w->context, w->pattern, &def, &cloth);
    if (status == MUS_OK) status = mus_drape_create(w->context, cloth, NULL, &how, &drape);
    if (status == MUS_OK) status = mus_drape_place(drape);
    if (status == MUS_OK) status = mus_drape_step(drape, 2, 1e-5);
    w->result = mus_drape_hash(drape);
    mus_drape_destroy(drape);
    mus_cloth_destroy(cloth);
    return status;
}


/* an edit, and its undo where it was done */
static mus_status call_edits(wardrobe *w)
{
    uint64_t hash = 0;
    mus_status status = mus_pattern_mirror_panel(w->pattern, 0, "again", NULL);
    if (status == MUS_OK) status = mus_pattern_split_edge(w->pattern, 0, 0.01, "part", NULL);
    if (status == MUS_OK) status = form_of(w->pattern, &hash);
    while (mus_pattern_undo_count(w->pattern) > 0) ck_assert_int_eq(mus_pattern_undo(w->pattern), MUS_OK);
    w->result = hash + (uint64_t)mus_pattern_edge_count(w->pattern);
    return status;
}


static mus_status call_topology(wardrobe *w)
{
    mus_topology topology;
    mus_faults *faults = NULL;
    int32_t count = 0;
    mus_topology_init(&topology, sizeof topology);
    mus_status status = form_of(w->pattern, &w->result);
    if (status == MUS_OK) status = mus_pattern_topology(w->pattern, &topology);
    if (status == MUS_OK) status = mus_pattern_check(w->pattern, &count, &faults);
    mus_faults_destroy(faults);
    w->result += (uint64_t)count;
    return status;
}


static mus_status call_draft(wardrobe *w)
{
    mus_pattern *pattern = NULL;
    mus_status status = mus_design_draft(w->context, mus_design_find("skirt"), w->tape, NULL, &pattern);
    if (status == MUS_OK) status = form_of(pattern, &w->result);
    mus_pattern_destroy(pattern);
    return status;
}


static mus_status call_pose(wardrobe *w)
{
    mus_pose pose;
    mus_body *posed = NULL;
    mus_pose_init(&pose, sizeof pose);
    mus_status status = mus_body_rest_pose(w->body, &pose);
    if (status == MUS_OK) status = mus_body_pose(w->body, &pose, &posed);
    const double volume = status == MUS_OK ? mus_body_volume(posed) : 0.0;
    memcpy(&w->result, &volume, sizeof volume);
    mus_body_destroy(posed);
    return status;
}


static mus_status call_fit(wardrobe *w)
{
    mus_fit *fit = NULL;
    const mus_status status = mus_fit_create(w->drape, NULL, &fit);
    w->result = status == MUS_OK;
    mus_fit_destroy(fit);
    return status;
}


/* each n-th allocation fails, by turns with all that follow it; then the same call again, with memory */
static void fail_each(wardrobe *w, const char *name, wardrobe_call call, void (*renew)(wardrobe *w))
{
    int64_t n = 0;
    ck_assert_msg(call(w) == MUS_OK, "%s: %s", name, mus_context_error(w->context));
    const uint64_t want = w->result;
    for (;; n += SUPPORT_SLOW ? 3 : 1) {
        if (renew != NULL) renew(w);
        support_fail_after(n, n % 2 == 1);
        const mus_status status = call(w);
        support_fail_never();
        if (status == MUS_OK) {
            ck_assert_msg(w->result == want, "%s: another result where allocation %d fails", name, (int)n);
            break;
        }
        ck_assert_msg(status == MUS_ERR_MEMORY, "%s, allocation %d: status %d", name, (int)n, (int)status);
        ck_assert_msg(mus_context_error(w->context)[0] != '\0', "%s", name);
        ck_assert_msg(call(w) == MUS_OK, "%s after allocation %d: %s", name, (int)n, mus_context_error(w->context));
        ck_assert_msg(w->result == want, "%s: another result after allocation %d", name, (int)n);
    }
    ck_assert_msg(n > 0, "%s allocates nothing", name);
    printf("%s: %d allocations failed in turn\n", name, (int)n);
}


START_TEST(objects_serve_again_after_each_failure)
{
    static const struct {
        const char *name;
        wardrobe_call call;
        void (*renew)(wardrobe *w);
    } row[] = {{"sew", call_sew, renew_drape}, {"cloth and drape", call_cloth_and_drape, NULL},
               {"edits", call_edits, NULL},    {"topology", call_topology, NULL},
               {"draft", call_draft, NULL},    {"pose", call_pose, NULL},
               {"fit", call_fit, NULL}};
    wardrobe w = {.context = support_context()};
    w.pattern = scene_strips(w.context, 1.1);
    w.cloth = scene_cut(w.context, w.pattern, 0.01, 0.05);
    w.drape = scene_drape(w.context, w.cloth, 32, 2);
    ck_assert_int_eq(mus_tape_create(w.context, &w.tape), MUS_OK);
    ck_assert_int_eq(mus_tape_set_size(w.tape, "W40"), MUS_OK);
    ck_assert_int_eq(mus_tape_complete(w.tape), MUS_OK);
    ck_assert_int_eq(mus_body_create(w.context, w.tape, NULL, &w.body), MUS_OK);
    ck_assert_int_eq(mus_pattern_keep_history(w.pattern, 10), MUS_OK);
    for (size_t i = 0; i < sizeof row / sizeof *row; i++)
        if (_i == (int)i) fail_each(&w, row[i].name, row[i].call, row[i].renew);
    mus_drape_destroy(w.drape);
    mus_cloth_destroy(w.cloth);
    mus_pattern_destroy(w.pattern);
    mus_body_destroy(w.body);
    mus_tape_destroy(w.tape);
    support_context_end(w.context);
}
END_TEST


Suite *mus_suite_memory_again(void)
{
    Suite *suite = suite_create("memory_again");
    TCase *tests = tcase_create("memory_again");
    tcase_set_timeout(tests, 60);
    tcase_add_loop_test(tests, objects_serve_again_after_each_failure, 0, 7);
    suite_add_tcase(suite, tests);
    return suite;
}
