/*
 * bench.c: make catalogue-bench: a catalogue of the GarmentCode specifications and of variants of them, 100,000 in all
 * or as many as asked: how long a search takes, and whether the same design on another body comes first.
 *
 *     build/bin/catalogue-bench DATA CATALOGUE.db [COUNT]
 *
 * Times are CPU time of this process, form and traits of the pattern that is looked for included.
 */
#define _POSIX_C_SOURCE 200809L

#include <time.h>

#include "catalogue/variants.h"
#include "muslin/catalogue.h"

#define QUERIES 400
#define TOGETHER 1000


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


/* variants until there are `count` patterns */
static mus_status fill(mus_context *context, mus_catalogue *catalogue, const variant_set *set, int32_t count,
                       uint64_t *state)
{
    mus_status status = MUS_OK;
    for (int32_t n = 0; n < count && status == MUS_OK; n++) {
        char name[160];
        if (n % TOGETHER == 0) status = mus_catalogue_begin(catalogue);
        const int32_t i = n < set->count ? n : (int32_t)(variant_random(state) % (uint64_t)set->count);
        const variant_edit edit = variant_any_edit(set->pattern[i], state);
        mus_pattern *variant = n < set->count ? NULL : variant_make(context, set->pattern[i], &edit);
        snprintf(name, sizeof name, n < set->count ? "%s" : "%s, variant %d", set->name[i], (int)n);
        if (status == MUS_OK)
            status = mus_catalogue_add(catalogue, variant != NULL ? variant : set->pattern[i], name, NULL);
        mus_pattern_destroy(variant);
        if (status == MUS_OK && (n % TOGETHER == TOGETHER - 1 || n == count - 1))
            status = mus_catalogue_commit(catalogue);
    }
    return status;
}


static mus_status search(mus_context *context, mus_catalogue *catalogue, const variant_set *set, uint64_t *state)
{
    static double exact[QUERIES], nearest[QUERIES], part[20];
    int32_t ids[10], n;
    double start = cpu();
    mus_status status = mus_catalogue_nearest(catalogue, set->pattern[0], 10, ids, NULL, NULL, &n);
    printf("%-28s %8.1f ms\n", "index read into memory", 1e3 * (cpu() - start));
    for (int32_t q = 0; q < QUERIES && status == MUS_OK; q++) {
        const int32_t i = (int32_t)(variant_random(state) % (uint64_t)set->count);
        const variant_edit edit = variant_any_edit(set->pattern[i], state);
        mus_pattern *variant = variant_make(context, set->pattern[i], &edit);
        const mus_pattern *one = variant != NULL ? variant : set->pattern[i];
        start = cpu();
        status = mus_catalogue_exact(catalogue, one, ids, 10, &n);
        exact[q] = cpu() - start;
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
    if (status == MUS_OK) status = fill(context, catalogue, &set, count, &state);
    if (status == MUS_OK)
        printf("%d patterns, %d of them specifications, added in %.1f s of CPU: %.2f ms each\n",
               (int)mus_catalogue_count(catalogue), (int)set.count, cpu() - start, 1e3 * (cpu() - start) / count);
    if (status == MUS_OK) status = search(context, catalogue, &set, &state);
    if (status == MUS_OK) status = leave_one_out(context, &set);
    if (status != MUS_OK) fprintf(stderr, "catalogue-bench: %s\n", mus_context_error(context));
    mus_catalogue_destroy(catalogue);
    variants_free(&set);
    mus_context_destroy(context);
    return status == MUS_OK ? 0 : 1;
}
