/*
 * catalogue-bench.c: time and quality of searches in a large catalogue, the study of `make catalogue-bench`.
 *
 * The catalogue holds the named designs in five sizes, the GarmentCode specifications and COUNT variants of them
 * (100,000 unless told). Measured: the CPU time of a search, and whether the same design on another body comes first.
 *
 *     build/bin/catalogue-bench DATA CATALOGUE.db [COUNT]
 *
 * The time of a search includes computing the canonical form and the traits of the pattern searched for.
 */
#define _POSIX_C_SOURCE 200809L

#include <stdbool.h>
#include <time.h>

#include "catalogue/variants.h"
#include "muslin/catalogue.h"
#include "muslin/design.h"
#include "muslin/tape.h"

#define QUERIES 400
#define TOGETHER 1000
#define SIZES 5


static double cpu(void)
{
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}


static int by_value(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return x < y ? -1 : x > y;
}


static void print_times(const char *what, double *seconds, int32_t n)
{
    qsort(seconds, (size_t)n, sizeof *seconds, by_value);
    printf("%-28s median %8.3f ms, 99 in 100 below %8.3f ms, slowest %8.3f ms (%d)\n", what, 1e3 * seconds[n / 2],
           1e3 * seconds[n * 99 / 100], 1e3 * seconds[n - 1], (int)n);
}


/* ---- named designs ---- */

/* a design in one of five sizes of its first group; NULL when it is refused */
static mus_pattern *draft(mus_context *context, int32_t design, int32_t size)
{
    static const char *const sizes[3][SIZES] = {{"W36", "W40", "W44", "W48", "W52"},
                                                {"M46", "M50", "M52", "M56", "M60"},
                                                {"C80", "C104", "C116", "C140", "C164"}};
    const int32_t groups = mus_design_groups(design);
    const int32_t group = groups & MUS_GROUP_WOMEN ? 0 : groups & MUS_GROUP_MEN ? 1 : 2;
    mus_tape *tape = NULL;
    mus_pattern *pattern = NULL;
    mus_status status = mus_tape_create(context, &tape);
    if (status == MUS_OK) status = mus_tape_set_size(tape, sizes[group][size]);
    if (status == MUS_OK) status = mus_design_draft(context, design, tape, NULL, &pattern);
    if (status != MUS_OK) printf("  %s of %s: %s\n", mus_design_name(design), sizes[group][size],
                                 mus_context_error(context));
    mus_tape_destroy(tape);
    return pattern;
}


/* all of them in all sizes; id (designs x SIZES) gets their numbers */
static mus_status fill_designs(mus_context *context, mus_catalogue *catalogue, int32_t *id)
{
    mus_status status = mus_catalogue_begin(catalogue);
    for (int32_t d = 0; d < mus_design_count() && status == MUS_OK; d++)
        for (int32_t k = 0; k < SIZES && status == MUS_OK; k++) {
            char name[160];
            mus_pattern *pattern = draft(context, d, k);
            id[SIZES * d + k] = MUS_NONE;
            snprintf(name, sizeof name, "%s, size %d", mus_design_name(d), (int)k);
            if (pattern != NULL) status = mus_catalogue_add(catalogue, pattern, name, &id[SIZES * d + k]);
            mus_pattern_destroy(pattern);
        }
    return status == MUS_OK ? mus_catalogue_commit(catalogue) : status;
}


/* each design in each size against all others: is the nearest the same design in another size? */
static mus_status leave_one_design_out(mus_context *context)
{
    const int32_t designs = mus_design_count();
    int32_t *id = malloc(sizeof *id * (size_t)(SIZES * designs)), first = 0, all = 0;
    mus_catalogue *catalogue = NULL;
    if (id == NULL) return MUS_ERR_MEMORY;
    mus_status status = mus_catalogue_open(context, ":memory:", MUS_CATALOGUE_WRITE, &catalogue);
    if (status == MUS_OK) status = fill_designs(context, catalogue, id);
    for (int32_t i = 0; i < SIZES * designs && status == MUS_OK; i++) {
        int32_t found[2], n;
        mus_pattern *pattern = draft(context, i / SIZES, i % SIZES);
        if (pattern == NULL) continue;
        status = mus_catalogue_nearest(catalogue, pattern, 2, found, NULL, NULL, &n);
        const int32_t other = found[0] == id[i] ? found[1] : found[0];
        for (int32_t k = 0; k < SIZES; k++) first += id[i / SIZES * SIZES + k] == other;
        all++;
        mus_pattern_destroy(pattern);
    }
    if (status == MUS_OK)
        printf("%-28s %d of %d, %.1f %%\n", "design in another size first", (int)first, (int)all, 100.0 * first / all);
    mus_catalogue_destroy(catalogue);
    free(id);
    return status;
}


/* ---- filling and searching ---- */

/* specifications, and `count` variants of them */
static mus_status fill(mus_context *context, mus_catalogue *catalogue, const variant_set *set, int32_t count,
                       uint64_t *state)
{
    mus_status status = MUS_OK;
    const int32_t all = set->count + count;
    for (int32_t n = 0; n < all && status == MUS_OK; n++) {
        char name[160];
        if (n % TOGETHER == 0) status = mus_catalogue_begin(catalogue);
        const int32_t i = n < set->count ? n : (int32_t)(variant_random(state) % (uint64_t)set->count);
        const variant_edit edit = variant_any_edit(set->pattern[i], state);
        mus_pattern *variant = n < set->count ? NULL : variant_make(context, set->pattern[i], &edit);
        snprintf(name, sizeof name, n < set->count ? "%s" : "%s, variant %d", set->name[i], (int)n);
        if (status == MUS_OK)
            status = mus_catalogue_add(catalogue, variant != NULL ? variant : set->pattern[i], name, NULL);
        mus_pattern_destroy(variant);
        if (status == MUS_OK && (n % TOGETHER == TOGETHER - 1 || n == all - 1))
            status = mus_catalogue_commit(catalogue);
    }
    return status;
}


static mus_status search(mus_context *context, mus_catalogue *catalogue, const variant_set *set, uint64_t *state)
{
    static double exact[QUERIES], nearest[QUERIES], part[20];
    int32_t found_exactly = 0;
    int32_t ids[10], n;
    double start = cpu();
    mus_status status = mus_catalogue_nearest(catalogue, set->pattern[0], 10, ids, NULL, NULL, &n);
    printf("%-28s %8.1f ms\n", "index read into memory", 1e3 * (cpu() - start));
    for (int32_t q = 0; q < QUERIES && status == MUS_OK; q++) {
        const int32_t i = (int32_t)(variant_random(state) % (uint64_t)set->count);
        const variant_edit edit = variant_any_edit(set->pattern[i], state);
        /* by turns a variant and a named design, which is there */
        const bool named = q % 2 == 1;
        mus_pattern *variant =
            named ? draft(context, (int32_t)(variant_random(state) % (uint64_t)mus_design_count()), q / 2 % SIZES)
                  : variant_make(context, set->pattern[i], &edit);
        const mus_pattern *one = variant != NULL ? variant : set->pattern[i];
        start = cpu();
        status = mus_catalogue_exact(catalogue, one, ids, 10, &n);
        exact[q] = cpu() - start;
        found_exactly += named && n > 0;
        start = cpu();
        if (status == MUS_OK) status = mus_catalogue_nearest(catalogue, one, 10, ids, NULL, NULL, &n);
        nearest[q] = cpu() - start;
        if (q < 20) {
            start = cpu();
            if (status == MUS_OK) status = mus_catalogue_containing(catalogue, one, NULL, 0, &n);
            part[q] = cpu() - start;
        }
        mus_pattern_destroy(variant);
    }
    if (status != MUS_OK) return status;
    printf("%-28s %d of %d\n", "designs found exactly", (int)found_exactly, QUERIES / 2);
    print_times("exact", exact, QUERIES);
    print_times("ten nearest", nearest, QUERIES);
    print_times("containing a whole garment", part, 20);
    return MUS_OK;
}


/* each specification against the others */
static mus_status leave_one_out(mus_context *context, const variant_set *set)
{
    mus_catalogue *catalogue;
    int32_t id[VARIANTS_MOST], siblings = 0, first = 0;
    mus_status status = mus_catalogue_open(context, ":memory:", MUS_CATALOGUE_WRITE, &catalogue);
    for (int32_t i = 0; i < set->count && status == MUS_OK; i++)
        status = mus_catalogue_add(catalogue, set->pattern[i], set->name[i], &id[i]);
    for (int32_t i = 0; i < set->count && status == MUS_OK; i++) {
        int32_t found[2], n, others = 0, good = 0;
        for (int32_t k = 0; k < set->count; k++) others += k != i && strcmp(set->design[k], set->design[i]) == 0;
        status = mus_catalogue_nearest(catalogue, set->pattern[i], 2, found, NULL, NULL, &n);
        const int32_t other = found[0] == id[i] ? found[1] : found[0];
        for (int32_t k = 0; k < set->count; k++)
            good += k != i && id[k] == other && strcmp(set->design[k], set->design[i]) == 0;
        siblings += others > 0;
        first += good;
        if (others > 0 && !good) printf("  its sibling is not first: %s\n", set->name[i]);
    }
    if (status == MUS_OK)
        printf("%-28s %d of %d, %.1f %%\n", "sibling first", (int)first, (int)siblings, 100.0 * first / siblings);
    mus_catalogue_destroy(catalogue);
    return status;
}


int main(int argc, char **argv)
{
    if (argc < 3) {
        fprintf(stderr, "usage: catalogue-bench DATA CATALOGUE.db [COUNT]\n");
        return 2;
    }
    static variant_set set;
    char folder[1024];
    mus_context *context;
    mus_catalogue *catalogue;
    uint64_t state = 20050711;
    const int32_t count = argc > 3 ? (int32_t)atol(argv[3]) : 100000;
    if (mus_context_create(NULL, &context) != MUS_OK) return 1;
    static const char *const folders[] = {"specs", "originals"};
    for (size_t i = 0; i < 2; i++) {
        snprintf(folder, sizeof folder, "%s/garmentcode/%s", argv[1], folders[i]);
        variants_read(context, folder, &set);
    }
    if (set.count == 0) {
        printf("skipped: no GarmentCode specifications in %s\n", argv[1]);
        return 0;
    }
    remove(argv[2]);
    mus_status status = mus_catalogue_open(context, argv[2], MUS_CATALOGUE_WRITE, &catalogue);
    double start = cpu();
    int32_t *id = malloc(sizeof *id * (size_t)(SIZES * mus_design_count()));
    if (status == MUS_OK) status = id != NULL ? fill_designs(context, catalogue, id) : MUS_ERR_MEMORY;
    free(id);
    const int32_t named = status == MUS_OK ? mus_catalogue_count(catalogue) : 0;
    if (status == MUS_OK) status = fill(context, catalogue, &set, count, &state);
    const int32_t all = status == MUS_OK ? mus_catalogue_count(catalogue) : 1;
    if (status == MUS_OK)
        printf("%d patterns, %d of them designs, %d specifications, added in %.1f s of CPU: %.2f ms each\n", (int)all,
               (int)named, (int)set.count, cpu() - start, 1e3 * (cpu() - start) / all);
    if (status == MUS_OK) status = search(context, catalogue, &set, &state);
    if (status == MUS_OK) status = leave_one_out(context, &set);
    if (status == MUS_OK) status = leave_one_design_out(context);
    if (status != MUS_OK) fprintf(stderr, "catalogue-bench: %s\n", mus_context_error(context));
    mus_catalogue_destroy(catalogue);
    variants_free(&set);
    mus_context_destroy(context);
    return status == MUS_OK ? 0 : 1;
}
