/*
 * test_fuzz.c: every fuzz target on its seeds (tests/fuzz/seeds/NAME) and on damaged copies of them. A finding of
 * `make fuzz` becomes a seed, and is tested here from then on.
 */
#include "support.h"

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fuzz.h"

#define SEEDS 64
#define DAMAGED 3 /* copies of each seed, all targets below a second; MUSLIN_DAMAGED=n makes it n */

typedef struct target {
    const char *name;
    void (*run)(const uint8_t *, size_t);
} target;

#define ROW(name, what) {#name, fuzz_##name},
static const target targets[] = {FUZZ_TARGETS(ROW)};


static int by_name(const void *a, const void *b)
{
    return strcmp(*(char *const *)a, *(char *const *)b);
}


/* paths of the seeds, sorted; returns their number */
static int seeds_of(const char *name, char **path)
{
    char folder[128];
    int count = 0;
    snprintf(folder, sizeof folder, "tests/fuzz/seeds/%s", name);
    DIR *open = opendir(folder);
    for (const struct dirent *entry; open != NULL && (entry = readdir(open)) != NULL && count < SEEDS;) {
        if (entry->d_name[0] == '.') continue;
        path[count] = malloc(strlen(folder) + strlen(entry->d_name) + 2);
        sprintf(path[count++], "%s/%s", folder, entry->d_name);
    }
    if (open != NULL) closedir(open);
    qsort(path, (size_t)count, sizeof *path, by_name);
    return count;
}


START_TEST(holds_on_seeds_and_damaged_copies)
{
    const target *t = &targets[_i];
    char *path[SEEDS];
    const int count = seeds_of(t->name, path);
    const char *asked = getenv("MUSLIN_DAMAGED");
    const int copies = asked ? atoi(asked) : DAMAGED;
    uint64_t state = 25;
    if (count == 0) printf("skipped: %s has no seeds below the current folder\n", t->name);
    for (int i = 0; i < count; i++) {
        size_t size;
        char *bytes = support_slurp(path[i], &size);
        ck_assert_ptr_nonnull(bytes);
        t->run((const uint8_t *)bytes, size);
        for (int k = 0; k < copies && size > 0; k++) {
            if (k % 8 == 7) { /* the damage adds up for some copies, then begins anew */
                free(bytes);
                bytes = support_slurp(path[i], &size);
            }
            for (int n = 0; n < 3; n++) bytes[support_random(&state) % size] = (char)support_random(&state);
            t->run((const uint8_t *)bytes, k % 8 == 2 ? support_random(&state) % size : size);
        }
        free(bytes);
        free(path[i]);
    }
}
END_TEST


Suite *mus_suite_fuzz(void);
Suite *mus_suite_fuzz(void)
{
    Suite *suite = suite_create("fuzz");
    TCase *tcase = tcase_create("fuzz");
    tcase_set_timeout(tcase, 30.0); /* all of them take a second on a machine of their own */
    tcase_add_loop_test(tcase, holds_on_seeds_and_damaged_copies, 0, (int)(sizeof targets / sizeof targets[0]));
    suite_add_tcase(suite, tcase);
    return suite;
}
