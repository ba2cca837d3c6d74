/*
 * test_freesewing.c: FreeSewing drafts: all 48 real ones against the lengths that FreeSewing itself took of them, read
 * from the file by another way (jansson, straight), and a small one written here against answers by hand.
 */
#include <dirent.h>
#include <jansson.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "muslin/exchange.h"
#include "muslin/topology.h"
#include "support.h"

Suite *mus_suite_freesewing(void);

/* half a front of 100 x 60 mm with a curved side, cut on the fold x = 0; a notch on the hem and one beside, a button */
#define PART(FOLD, SECOND)                                                                                            \
    "{\"format\":\"freesewing-dump-1\",\"design\":\"try\",\"units\":\"mm\",\"y_axis\":\"down\",\"parts\":["           \
    "{\"name\":\"try.front\",\"cuts\":[{\"material\":\"lining\",\"cut\":2},{\"material\":\"fabric\",\"cut\":1}],"      \
    "\"on_fold\":" FOLD ",\"grainline\":null,\"points\":{\"cf\":[0,0],\"hem\":[60,100],\"cfHem\":[0,100],"            \
    "\"neck\":[60,0]},\"snippets\":[{\"type\":\"notch\",\"at\":[30,100]},{\"type\":\"bnotch\",\"at\":[60,50]},"        \
    "{\"type\":\"button\",\"at\":[0,20]},{\"type\":\"logo\",\"at\":[5,5]}],"                                          \
    "\"paths\":{\"seam\":{\"class\":\"fabric\",\"hidden\":false,\"segments\":["                                       \
    "{\"type\":\"line\",\"from\":[0,0],\"to\":[0,100]}," SECOND                                                        \
    ",{\"type\":\"cubic\",\"from\":[60,100],\"cp1\":[60,70],\"cp2\":[60,30],\"to\":[60,0]},"                           \
    "{\"type\":\"line\",\"from\":[60,0],\"to\":[60,0]},{\"type\":\"line\",\"from\":[60,0],\"to\":[0,0]}]}}}]}"
#define FOLD_LINE "{\"from\":[0,10],\"to\":[0,90]}"
#define HEM "{\"type\":\"line\",\"from\":[0,100],\"to\":[60,100]}"


static mus_status read_draft(mus_context *context, const char *text, mus_pattern **out)
{
    char path[512];
    support_spill(support_scratch("draft.json", path, sizeof path), text, strlen(text));
    return mus_pattern_read(context, path, out);
}


START_TEST(a_half_is_unfolded_with_its_notches)
{
    mus_context *context = support_context();
    mus_pattern *pattern;
    const mus_status status = read_draft(context, PART(FOLD_LINE, HEM), &pattern);
    ck_assert_msg(status == MUS_OK, "%s", mus_context_error(context));
    ck_assert_str_eq(mus_pattern_name(pattern), "try");
    ck_assert_int_eq(mus_pattern_panel_count(pattern), 1);
    ck_assert_str_eq(mus_pattern_panel_name(pattern, 0), "try.front");
    ck_assert_str_eq(mus_pattern_panel_label(pattern, 0), "fabric");

    /* 120 x 100 mm: hem and top run across the fold, each one edge; counter-clockwise, y up */
    ck_assert_int_eq(mus_pattern_edge_count(pattern), 4);
    ck_assert_double_eq_tol(mus_pattern_panel_area(pattern, 0), 0.012, 1e-12);
    ck_assert_double_eq_tol(mus_pattern_panel_perimeter(pattern, 0), 0.44, 1e-12);
    int32_t n, edge, kind, count, mirror;
    double s, xy[2], half = 0.5, grain[2];
    const int32_t *edges;
    ck_assert_int_eq(mus_pattern_outline(pattern, 0, &n, &edges, NULL), MUS_OK);
    double twice = 0.0;
    for (int32_t i = 0; i < n; i++) {
        double ends[4];
        const double t[2] = {0.0, 1.0};
        ck_assert_int_eq(mus_pattern_edge_at(pattern, edges[i], 2, t, ends), MUS_OK);
        twice += ends[0] * ends[3] - ends[2] * ends[1];
    }
    ck_assert_double_eq_tol(twice, 0.024, 1e-12);
    const int32_t hem = mus_pattern_find_edge(pattern, 0, "hem_m-hem");
    ck_assert_int_ne(hem, MUS_NONE);
    ck_assert_int_ne(mus_pattern_find_edge(pattern, 0, "hem-neck"), MUS_NONE);
    ck_assert_int_ne(mus_pattern_find_edge(pattern, 0, "neck-neck_m"), MUS_NONE);
    ck_assert_int_eq(mus_pattern_edge_at(pattern, hem, 1, &half, xy), MUS_OK);
    ck_assert(fabs(xy[0]) < 1e-12 && fabs(xy[1] + 0.1) < 1e-12);

    /* four notches, single on the hem 3 cm off its middle, double half way up the sides; the button, on the fold */
    ck_assert_int_eq(mus_pattern_notch_count(pattern), 4);
    for (int32_t i = 0; i < 4; i++) {
        ck_assert_int_eq(mus_pattern_notch(pattern, i, &edge, &s, &kind), MUS_OK);
        ck_assert_int_eq(kind, edge == hem ? MUS_NOTCH_SINGLE : MUS_NOTCH_DOUBLE);
        const double length = mus_pattern_edge_length(pattern, edge), off = fabs(s - 0.5 * length);
        ck_assert_double_eq_tol(off, edge == hem ? 0.03 : 0.0, 1e-7);
    }
    ck_assert_int_eq(mus_pattern_mark_count(pattern), 1);
    ck_assert_int_eq(mus_pattern_grain(pattern, 0, grain), MUS_OK);
    ck_assert(grain[0] == 0.0 && grain[1] == 1.0);
    ck_assert_int_eq(mus_pattern_cut(pattern, 0, &count, &mirror), MUS_OK);
    ck_assert_int_eq(count, 1);
    int32_t faults;
    ck_assert_int_eq(mus_pattern_check(pattern, &faults, NULL), MUS_OK);
    ck_assert_int_eq(faults, 0);
    mus_pattern_destroy(pattern);
    support_context_end(context);
}
END_TEST


START_TEST(a_fault_is_named_with_its_place)
{
    static const struct {
        const char *text, *words;
    } bad[] = {
        {PART(FOLD_LINE, "{\"type\":\"line\",\"from\":[0,101],\"to\":[60,100]}"), "from where the outline was"},
        {PART("{\"from\":[20,0],\"to\":[20,9]}", HEM), "on_fold: expected a straight piece of the outline"},
        {PART("{\"from\":[0,0],\"to\":[0,0]}", HEM), "expected a fold line"},
        {PART(FOLD_LINE, "{\"type\":\"arc\",\"from\":[0,100],\"to\":[60,100]}"), "expected line or cubic"},
        {PART(FOLD_LINE, "{\"type\":\"line\",\"from\":[0,100],\"to\":[60,101]}"), "parts[0].paths.seam.segments[2]"},
        {"{\"format\":\"freesewing-dump-1\",\"units\":\"in\"}", "expected \"mm\""},
        {"{\"format\":\"freesewing-dump-1\",\"units\":\"mm\",\"y_axis\":\"down\",\"parts\":[]}", "at parts"},
    };
    mus_context *context = support_context();
    mus_pattern *pattern = NULL;
    const mus_status status = read_draft(context, bad[_i].text, &pattern);
    ck_assert_ptr_null(pattern);
    ck_assert_int_ne(status, MUS_OK);
    ck_assert_msg(strstr(mus_context_error(context), bad[_i].words) != NULL, "%s", mus_context_error(context));
    support_context_end(context);
}
END_TEST


/* ---- the real ones ---- */

static double place_of(const json_t *point, int i)
{
    return json_number_value(json_array_get(point, (size_t)i));
}


/* the outline of a part as the file names it, another way than the reader: its length [mm], how many segments, and the
 * longest line on the fold */
static double stored_length(const json_t *part, size_t *segments, double *fold)
{
    const json_t *paths = json_object_get(part, "paths"), *path = json_object_get(paths, "seam"), *one;
    const json_t *on = json_object_get(part, "on_fold");
    const char *key;
    size_t i;
    if (path == NULL) {
        json_object_foreach((json_t *)(uintptr_t)paths, key, one)
        {
            const char *words = json_string_value(json_object_get(one, "class"));
            const bool cloth = strstr(words, "fabric") != NULL || strstr(words, "lining") != NULL;
            const bool allowance = strncmp(words, "sa", 2) == 0 || strstr(words, " sa") != NULL;
            if (path == NULL && !json_is_true(json_object_get(one, "hidden")) && cloth && !allowance) path = one;
        }
    }
    ck_assert_ptr_nonnull(path);
    const json_t *list = json_object_get(path, "segments");
    *segments = json_array_size(list);
    *fold = 0.0;
    json_array_foreach(list, i, one)
    {
        const json_t *a = json_object_get(one, "from"), *b = json_object_get(one, "to");
        const json_t *f = json_object_get(on, "from"), *t = json_object_get(on, "to");
        if (json_is_null(on) || strcmp(json_string_value(json_object_get(one, "type")), "line") != 0) continue;
        const double fx = place_of(t, 0) - place_of(f, 0), fy = place_of(t, 1) - place_of(f, 1);
        const double off_a = (place_of(a, 0) - place_of(f, 0)) * fy - (place_of(a, 1) - place_of(f, 1)) * fx;
        const double off_b = (place_of(b, 0) - place_of(f, 0)) * fy - (place_of(b, 1) - place_of(f, 1)) * fx;
        if (fabs(off_a) > 0.01 * hypot(fx, fy) || fabs(off_b) > 0.01 * hypot(fx, fy)) continue;
        *fold = fmax(*fold, hypot(place_of(b, 0) - place_of(a, 0), place_of(b, 1) - place_of(a, 1)));
    }
    return json_number_value(json_object_get(path, "length"));
}


/* notches that a part has, in both halves where it is unfolded */
static int count_notches(const json_t *part, bool folded)
{
    const json_t *one, *f = json_object_get(json_object_get(part, "on_fold"), "from");
    size_t i;
    int count = 0;
    json_array_foreach(json_object_get(part, "snippets"), i, one)
    {
        const char *type = json_string_value(json_object_get(one, "type"));
        if (strcmp(type, "notch") != 0 && strcmp(type, "bnotch") != 0) continue;
        const double x = place_of(json_object_get(one, "at"), 0);
        count += folded && fabs(x - place_of(f, 0)) > 0.01 ? 2 : 1;
    }
    return count;
}


static void check_draft(mus_context *context, const char *path, int *parts, int *notches, int *kept, int *inside,
                        int *folds)
{
    json_t *file = json_load_file(path, 0, NULL);
    mus_pattern *pattern;
    const json_t *part;
    size_t i, segments;
    ck_assert_ptr_nonnull(file);
    const mus_status status = mus_pattern_read(context, path, &pattern);
    ck_assert_msg(status == MUS_OK, "%s", mus_context_error(context));
    json_array_foreach(json_object_get(file, "parts"), i, part)
    {
        double fold;
        const double length = stored_length(part, &segments, &fold);
        const bool folded = fold > 0.0;
        const double exact = 1e-3 * (folded ? 2.0 * (length - fold) : length);
        const double rounding = 1e-3 * 2e-4 * (double)segments;
        ck_assert_str_eq(mus_pattern_panel_name(pattern, (int32_t)i), json_string_value(json_object_get(part, "name")));
        ck_assert_double_eq_tol(mus_pattern_panel_perimeter(pattern, (int32_t)i), exact,
                                fmax(1e-5 * exact, rounding));
        *notches += count_notches(part, folded);
        *folds += folded;
        (*parts)++;
    }
    ck_assert_int_eq(mus_pattern_panel_count(pattern), (int32_t)i);
    *kept += mus_pattern_notch_count(pattern);
    for (int32_t m = 0; m < mus_pattern_mark_count(pattern); m++) {
        const char *name;
        ck_assert_int_eq(mus_pattern_mark(pattern, m, NULL, &name, NULL, NULL), MUS_OK);
        *inside += strcmp(name, "notch") == 0 || strcmp(name, "bnotch") == 0;
    }
    mus_pattern_destroy(pattern);
    json_decref(file);
}


START_TEST(real_drafts_have_the_lengths_that_freesewing_took)
{
    char folder[512], path[1024];
    if (support_data("freesewing", folder, sizeof folder) == NULL) return;
    DIR *list = opendir(folder);
    ck_assert_ptr_nonnull(list);
    mus_context *context = support_context();
    int files = 0, parts = 0, notches = 0, kept = 0, inside = 0, folds = 0;
    for (const struct dirent *entry = readdir(list); entry != NULL; entry = readdir(list)) {
        const char *end = strstr(entry->d_name, ".json");
        if (end == NULL || end[5] != '\0') continue;
        snprintf(path, sizeof path, "%s/%s", folder, entry->d_name);
        check_draft(context, path, &parts, &notches, &kept, &inside, &folds);
        files++;
    }
    closedir(list);
    ck_assert_int_eq(files, 48);
    ck_assert_int_ge(parts, 150);
    ck_assert_int_eq(folds, 70);
    printf("freesewing: %d files, %d parts, %d unfolded, %d of %d notches on their outlines\n", files, parts, folds,
           kept, notches);
    /* the rest are points inside: bust points, flaps of pockets, and what was on a fold that is gone */
    ck_assert_int_eq(kept + inside, notches);
    ck_assert_int_eq(inside, 36);
    support_context_end(context);
}
END_TEST


START_TEST(each_allocation_that_fails_is_a_status_and_no_leak)
{
    char path[512];
    const char *text = PART(FOLD_LINE, HEM);
    support_spill(support_scratch("fail.json", path, sizeof path), text, strlen(text));
    int64_t failed = 0;
    for (int64_t n = 0;; n++) {
        mus_context *context = support_context();
        mus_pattern *pattern = NULL;
        support_fail_after(n, false);
        const mus_status status = mus_pattern_read(context, path, &pattern);
        support_fail_never();
        mus_pattern_destroy(pattern);
        support_context_end(context);
        if (status == MUS_OK) break;
        ck_assert_int_eq(status, MUS_ERR_MEMORY);
        failed++;
    }
    ck_assert_int_ge(failed, 10);
}
END_TEST


Suite *mus_suite_freesewing(void)
{
    Suite *suite = suite_create("freesewing");
    TCase *tests = tcase_create("freesewing");
    tcase_add_test(tests, a_half_is_unfolded_with_its_notches);
    tcase_add_loop_test(tests, a_fault_is_named_with_its_place, 0, 7);
    tcase_add_test(tests, real_drafts_have_the_lengths_that_freesewing_took);
    tcase_add_test(tests, each_allocation_that_fails_is_a_status_and_no_leak);
    suite_add_tcase(suite, tests);
    return suite;
}
