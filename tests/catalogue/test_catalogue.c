/*
 * test_catalogue.c: what was added is found again, what is no catalogue is refused, and a program that is killed in the
 * middle of its work loses nothing that was acknowledged.
 */
#if !defined(_XOPEN_SOURCE)
#define _XOPEN_SOURCE 700
#endif

#include <signal.h>
#include <sqlite3.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "muslin/catalogue.h"
#include "topology/garments.h"
#include "topology/gluing.h"

#define TOGETHER 10 /* additions in one transaction of the child that is killed */


static mus_catalogue *open_catalogue(mus_context *context, const char *path, int32_t mode)
{
    mus_catalogue *catalogue;
    mus_status status = mus_catalogue_open(context, path, mode, &catalogue);
    ck_assert_msg(status == MUS_OK, "%s", mus_context_error(context));
    return catalogue;
}


/* one statement on a file, past the library */
static void do_sql(const char *path, const char *sql)
{
    sqlite3 *db;
    ck_assert_int_eq(sqlite3_open(path, &db), SQLITE_OK);
    ck_assert_int_eq(sqlite3_exec(db, sql, NULL, NULL, NULL), SQLITE_OK);
    sqlite3_close(db);
}


static mus_pattern *garment_pattern(mus_context *context, int32_t row, uint64_t seed)
{
    return gluing_make(context, garments[row].panels, garments[row].seams, seed);
}


START_TEST(every_garment_of_the_tables_is_found_again)
{
    char path[1024];
    mus_context *context = support_context();
    mus_catalogue *catalogue = open_catalogue(context, support_scratch("a.db", path, sizeof path), MUS_CATALOGUE_WRITE);
    int32_t id[GARMENTS], found[GARMENTS], exact[GARMENTS], n;
    double distance[GARMENTS];
    ck_assert_int_eq(mus_catalogue_begin(catalogue), MUS_OK);
    for (int32_t i = 0; i < GARMENTS; i++) {
        mus_pattern *pattern = garment_pattern(context, i, 0);
        ck_assert_int_eq(mus_catalogue_add(catalogue, pattern, garments[i].name, &id[i]), MUS_OK);
        mus_pattern_destroy(pattern);
    }
    ck_assert_int_eq(mus_catalogue_commit(catalogue), MUS_OK);
    ck_assert_int_eq(mus_catalogue_count(catalogue), GARMENTS);
    mus_catalogue_destroy(catalogue);

    /* from the file, by a pattern whose edges are stored the other way round */
    catalogue = open_catalogue(context, path, MUS_CATALOGUE_READ);
    for (int32_t i = 0; i < GARMENTS; i++) {
        mus_pattern *pattern = garment_pattern(context, i, 7);
        bool there = false;
        ck_assert_int_eq(mus_catalogue_exact(catalogue, pattern, found, GARMENTS, &n), MUS_OK);
        for (int32_t k = 0; k < n; k++) there = there || found[k] == id[i];
        ck_assert_msg(there, "%s", garments[i].name);
        ck_assert_int_eq(mus_catalogue_nearest(catalogue, pattern, GARMENTS, found, distance, exact, &n), MUS_OK);
        ck_assert_int_eq(n, GARMENTS);
        ck_assert_double_le(distance[0], 1e-9);
        for (int32_t k = 0; k < n; k++) {
            const char *name;
            double parts[MUS_DISTANCE_COUNT], sum = 0.0;
            char text[2048];
            ck_assert(k == 0 || distance[k] >= distance[k - 1]);
            ck_assert_int_eq(mus_catalogue_name(catalogue, found[k], &name), MUS_OK);
            if (found[k] == id[i]) ck_assert_str_eq(name, garments[i].name);
            if (found[k] == id[i]) ck_assert(exact[k] && distance[k] < 1e-9);
            ck_assert_int_eq(mus_catalogue_explain(catalogue, pattern, found[k], parts, text, sizeof text), MUS_OK);
            for (int32_t p = 0; p < MUS_DISTANCE_COUNT; p++) sum += parts[p];
            ck_assert_double_eq_tol(sum, distance[k], 1e-9);
            ck_assert_int_eq(sum > 0.0, text[0] != '\0');
        }
        mus_pattern_destroy(pattern);
    }
    mus_catalogue_destroy(catalogue);
    support_context_end(context);
}
END_TEST


START_TEST(a_few_nearest_are_the_first_of_all)
{
    char path[1024];
    mus_context *context = support_context();
    mus_catalogue *catalogue = open_catalogue(context, support_scratch("a.db", path, sizeof path), MUS_CATALOGUE_WRITE);
    ck_assert_int_eq(mus_catalogue_begin(catalogue), MUS_OK);
    for (int32_t i = 0; i < GARMENTS; i++) {
        mus_pattern *pattern = garment_pattern(context, i, 0);
        ck_assert_int_eq(mus_catalogue_add(catalogue, pattern, garments[i].name, NULL), MUS_OK);
        mus_pattern_destroy(pattern);
    }
    for (int32_t i = 0; i < GARMENTS; i++) {
        int32_t all[GARMENTS], few[5], n;
        double distance[GARMENTS], own[5];
        mus_pattern *pattern = garment_pattern(context, i, 0);
        ck_assert_int_eq(mus_catalogue_nearest(catalogue, pattern, GARMENTS, all, distance, NULL, &n), MUS_OK);
        ck_assert_int_eq(mus_catalogue_nearest(catalogue, pattern, 5, few, own, NULL, &n), MUS_OK);
        ck_assert_int_eq(n, 5);
        ck_assert_mem_eq(all, few, sizeof few);
        ck_assert_mem_eq(distance, own, sizeof own);
        mus_pattern_destroy(pattern);
    }
    mus_catalogue_destroy(catalogue);
    support_context_end(context);
}
END_TEST


START_TEST(names_are_kept_once_and_transactions_all_or_none)
{
    char path[1024];
    mus_context *context = support_context();
    support_scratch("a.db", path, sizeof path);
    mus_catalogue *catalogue = open_catalogue(context, path, MUS_CATALOGUE_WRITE);
    mus_pattern *a = garment_pattern(context, 3, 0), *b = garment_pattern(context, 4, 0);
    int32_t first, again, n;
    ck_assert_int_eq(mus_catalogue_add(catalogue, a, "shirt", &first), MUS_OK);
    ck_assert_int_eq(mus_catalogue_add(catalogue, b, "shirt", &again), MUS_OK);
    ck_assert(first == again && mus_catalogue_count(catalogue) == 1);
    ck_assert_int_eq(mus_catalogue_exact(catalogue, a, NULL, 0, &n), MUS_OK);
    ck_assert_int_eq(n, 0);
    ck_assert_int_eq(mus_catalogue_exact(catalogue, b, NULL, 0, &n), MUS_OK);
    ck_assert_int_eq(n, 1);

    /* dropped, and dropped by closing */
    for (int32_t way = 0; way < 2; way++) {
        ck_assert_int_eq(mus_catalogue_begin(catalogue), MUS_OK);
        ck_assert_int_eq(mus_catalogue_begin(catalogue), MUS_ERR_STATE);
        ck_assert_int_eq(mus_catalogue_add(catalogue, a, "tube", NULL), MUS_OK);
        ck_assert_int_eq(mus_catalogue_nearest(catalogue, a, 1, &again, NULL, NULL, &n), MUS_OK);
        ck_assert(n == 1 && again != first);
        if (way == 0) ck_assert_int_eq(mus_catalogue_rollback(catalogue), MUS_OK);
        if (way == 1) mus_catalogue_destroy(catalogue);
        if (way == 1) catalogue = open_catalogue(context, path, MUS_CATALOGUE_WRITE);
        ck_assert_int_eq(mus_catalogue_count(catalogue), 1);
        ck_assert_int_eq(mus_catalogue_nearest(catalogue, a, 1, &again, NULL, NULL, &n), MUS_OK);
        ck_assert(n == 1 && again == first);
    }
    ck_assert_int_eq(mus_catalogue_commit(catalogue), MUS_ERR_STATE);
    ck_assert_int_eq(mus_catalogue_rollback(catalogue), MUS_ERR_STATE);

    /* a pattern added by another program is found by the next search */
    mus_catalogue *other = open_catalogue(context, path, MUS_CATALOGUE_WRITE);
    ck_assert_int_eq(mus_catalogue_add(other, a, "tube", NULL), MUS_OK);
    ck_assert_int_eq(mus_catalogue_nearest(catalogue, a, 1, &again, NULL, NULL, &n), MUS_OK);
    ck_assert(n == 1 && again != first);
    mus_catalogue_destroy(other);
    mus_catalogue_destroy(catalogue);
    mus_pattern_destroy(a);
    mus_pattern_destroy(b);
    support_context_end(context);
}
END_TEST


START_TEST(what_is_no_catalogue_or_of_a_newer_version_is_refused)
{
    char path[1024];
    mus_context *context = support_context();
    mus_catalogue *catalogue;
    support_scratch("a.db", path, sizeof path);
    ck_assert_int_eq(mus_catalogue_open(context, path, MUS_CATALOGUE_READ, &catalogue), MUS_ERR_FILE);
    ck_assert_ptr_null(catalogue);
    ck_assert(strstr(mus_context_error(context), "a.db: ") != NULL);
    ck_assert_int_eq(mus_catalogue_open(context, path, 2, &catalogue), MUS_ERR_ARG);
    ck_assert_int_eq(mus_catalogue_open(context, NULL, 0, &catalogue), MUS_ERR_ARG);
    ck_assert_int_eq(mus_catalogue_open(NULL, path, 0, &catalogue), MUS_ERR_ARG);
    ck_assert_int_eq(mus_catalogue_open(context, path, 0, NULL), MUS_ERR_ARG);

    /* what a first writer leaves that was killed before its first commit */
    support_spill(path, "", 0);
    ck_assert_int_eq(mus_catalogue_open(context, path, MUS_CATALOGUE_READ, &catalogue), MUS_ERR_FORMAT);
    ck_assert(strstr(mus_context_error(context), "a.db: an empty file: no pattern was added to it") != NULL);
    mus_catalogue_destroy(open_catalogue(context, path, MUS_CATALOGUE_WRITE));
    mus_catalogue_destroy(open_catalogue(context, path, MUS_CATALOGUE_READ));
    do_sql(path, "PRAGMA user_version = 2");
    for (int32_t mode = 0; mode < 2; mode++) {
        ck_assert_int_eq(mus_catalogue_open(context, path, mode, &catalogue), MUS_ERR_FORMAT);
        ck_assert(strstr(mus_context_error(context),
                         "a.db: version 2, written by a newer muslin; this library reads version 1") != NULL);
    }

    /* another program's database, and a file that is none */
    support_scratch("b.db", path, sizeof path);
    do_sql(path, "CREATE TABLE hats (size)");
    ck_assert_int_eq(mus_catalogue_open(context, path, MUS_CATALOGUE_WRITE, &catalogue), MUS_ERR_FORMAT);
    ck_assert(strstr(mus_context_error(context), "b.db: not a muslin catalogue") != NULL);
    support_scratch("c.db", path, sizeof path);
    char text[2000];
    memset(text, 'x', sizeof text);
    support_spill(path, text, sizeof text);
    ck_assert_int_eq(mus_catalogue_open(context, path, MUS_CATALOGUE_WRITE, &catalogue), MUS_ERR_FORMAT);
    support_context_end(context);
}
END_TEST


START_TEST(calls_out_of_turn_and_damaged_rows_are_refused)
{
    char path[1024];
    mus_context *context = support_context();
    support_scratch("a.db", path, sizeof path);
    mus_catalogue *catalogue = open_catalogue(context, path, MUS_CATALOGUE_WRITE);
    mus_pattern *a = garment_pattern(context, 3, 0);
    const char *name = "x";
    int32_t id = 5, n;
    ck_assert_int_eq(mus_catalogue_add(catalogue, NULL, "a", &id), MUS_ERR_ARG);
    ck_assert_int_eq(id, MUS_NONE);
    ck_assert_int_eq(mus_catalogue_add(catalogue, a, "", NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_catalogue_add(catalogue, a, NULL, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_catalogue_add(catalogue, a, "a\xed\xa0\x80", NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_catalogue_add(NULL, a, "a", NULL), MUS_ERR_ARG);
    ck_assert_int_eq(mus_catalogue_nearest(catalogue, a, 0, &id, NULL, NULL, &n), MUS_ERR_ARG);
    ck_assert_int_eq(mus_catalogue_nearest(catalogue, a, 3, &id, NULL, NULL, &n), MUS_OK);
    ck_assert_int_eq(n, 0);
    ck_assert_int_eq(mus_catalogue_name(catalogue, 1, &name), MUS_ERR_ARG);
    ck_assert_ptr_null(name);
    ck_assert_int_eq(mus_catalogue_explain(catalogue, a, 1, NULL, NULL, 0), MUS_ERR_ARG);
    ck_assert_int_eq(mus_catalogue_add(catalogue, a, "a", &id), MUS_OK);
    mus_catalogue_destroy(catalogue);

    catalogue = open_catalogue(context, path, MUS_CATALOGUE_READ);
    ck_assert_int_eq(mus_catalogue_add(catalogue, a, "b", NULL), MUS_ERR_STATE);
    ck_assert_int_eq(mus_catalogue_begin(catalogue), MUS_ERR_STATE);
    static const char *const harm[] = {
        "UPDATE pattern SET traits = x'0011'", "UPDATE pattern SET traits = zeroblob(80)",
        "UPDATE pattern SET traits = x'7ff8000000000000' || zeroblob(48)"};
    for (size_t i = 0; i < sizeof harm / sizeof harm[0]; i++) {
        do_sql(path, harm[i]);
        ck_assert_int_eq(mus_catalogue_nearest(catalogue, a, 1, &id, NULL, NULL, &n), MUS_ERR_FORMAT);
        ck_assert(strstr(mus_context_error(context), "the traits of pattern 1 are damaged") != NULL);
    }
    mus_catalogue_destroy(catalogue);
    mus_catalogue_destroy(NULL);
    mus_pattern_destroy(a);
    support_context_end(context);
}
END_TEST


/* a catalogue of one pattern whose table `pattern` names each page below its root sixty times: sixty rows, 60 x 60
 * rows, and so on for five floors. File format: sqlite.org/fileformat2.html, section 1.6 */
static void spill_repeating(const char *path)
{
    enum { PAGE = 4096, FANOUT = 60, FLOORS = 5 };
    size_t size;
    unsigned char *file = (unsigned char *)support_slurp(path, &size);
    unsigned char *more = calloc(1, size + FLOORS * PAGE);
    ck_assert_uint_eq(size % PAGE, 0);
    memcpy(more, file, size);
    const uint32_t pages = (uint32_t)(size / PAGE), root = 4; /* form, form_hash, pattern */
    memcpy(more + size, file + (root - 1) * PAGE, PAGE);      /* the leaf */
    for (uint32_t floor = 0; floor < FLOORS; floor++) {
        unsigned char *page = floor + 1 < FLOORS ? more + size + (floor + 1) * PAGE : more + (root - 1) * PAGE;
        const uint32_t child = pages + 1 + floor;
        memset(page, 0, PAGE);
        page[0] = 5, page[4] = FANOUT, page[5] = (PAGE - 8 * FANOUT) >> 8, page[6] = (PAGE - 8 * FANOUT) & 255;
        page[11] = (unsigned char)child;
        for (uint32_t i = 0; i < FANOUT; i++) {
            const uint32_t at = PAGE - 8 * (i + 1);
            page[12 + 2 * i] = (unsigned char)(at >> 8), page[13 + 2 * i] = at & 255;
            page[at + 3] = (unsigned char)child, page[at + 4] = 1;
        }
    }
    more[31] = (unsigned char)(pages + FLOORS);
    support_spill(path, more, size + FLOORS * PAGE);
    free(file);
    free(more);
}


START_TEST(a_hostile_file_runs_nothing_and_ends)
{
    char path[1024];
    mus_context *context = support_context();
    mus_catalogue *catalogue;
    mus_pattern *a = garment_pattern(context, 3, 0);
    int32_t id, n;

    /* a view in place of a table, whose rows do not end */
    support_scratch("view.db", path, sizeof path);
    do_sql(path, "CREATE TABLE form (id INTEGER PRIMARY KEY, hash BLOB NOT NULL, form BLOB NOT NULL);"
                 "CREATE VIEW pattern AS WITH RECURSIVE c(x) AS (SELECT 1 UNION ALL SELECT x + 1 FROM c) SELECT "
                 "x AS id, 'n' AS name, 1 AS form, zeroblob(8) AS traits FROM c;"
                 "PRAGMA application_id = 1297437507; PRAGMA user_version = 1");
    for (int32_t mode = 0; mode < 2; mode++) {
        ck_assert_int_eq(mus_catalogue_open(context, path, mode, &catalogue), MUS_ERR_FORMAT);
        ck_assert(strstr(mus_context_error(context), "the tables are not those of a catalogue") != NULL);
    }

    /* a trigger: refused at the door, not run when it comes while the file is open */
    support_scratch("trigger.db", path, sizeof path);
    catalogue = open_catalogue(context, path, MUS_CATALOGUE_WRITE);
    ck_assert_int_eq(mus_catalogue_add(catalogue, a, "a", &id), MUS_OK);
    do_sql(path, "CREATE TRIGGER t AFTER INSERT ON pattern BEGIN DELETE FROM form; DELETE FROM pattern; END");
    ck_assert_int_eq(mus_catalogue_add(catalogue, a, "b", &id), MUS_OK);
    ck_assert_int_eq(mus_catalogue_count(catalogue), 2);
    mus_catalogue_destroy(catalogue);
    ck_assert_int_eq(mus_catalogue_open(context, path, MUS_CATALOGUE_WRITE, &catalogue), MUS_ERR_FORMAT);
    do_sql(path, "DROP TRIGGER t; ANALYZE");
    mus_catalogue_destroy(open_catalogue(context, path, MUS_CATALOGUE_WRITE));

    /* a tree of pages that names its pages again and again */
    spill_repeating(path);
    catalogue = open_catalogue(context, path, MUS_CATALOGUE_READ);
    ck_assert_int_eq(mus_catalogue_nearest(catalogue, a, 1, &id, NULL, NULL, &n), MUS_ERR_FORMAT);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "operations for"));
    mus_catalogue_destroy(catalogue);
    mus_pattern_destroy(a);
    support_context_end(context);
}
END_TEST


/* adds without end, and tells through the pipe how many are committed */
static void add_until_killed(const char *path, int pipe_end)
{
    mus_context *context = support_context();
    mus_catalogue *catalogue;
    if (mus_catalogue_open(context, path, MUS_CATALOGUE_WRITE, &catalogue) != MUS_OK) _exit(1);
    int32_t start = mus_catalogue_count(catalogue);
    mus_pattern *pattern = garment_pattern(context, 4, 0);
    for (int32_t n = start;; n += TOGETHER) {
        char name[32];
        mus_catalogue_begin(catalogue);
        for (int32_t i = n; i < n + TOGETHER; i++) {
            snprintf(name, sizeof name, "pattern %d", (int)i);
            if (mus_catalogue_add(catalogue, pattern, name, NULL) != MUS_OK) _exit(1);
        }
        int32_t done = n + TOGETHER;
        if (mus_catalogue_commit(catalogue) != MUS_OK || write(pipe_end, &done, sizeof done) != sizeof done) _exit(1);
    }
}


START_TEST(a_program_killed_in_its_work_loses_nothing_acknowledged)
{
    char path[1024];
    support_scratch("a.db", path, sizeof path);
    mus_context *context = support_context();
    uint64_t state = 9;
    for (int32_t round = 0; round < 6; round++) {
        int ends[2];
        ck_assert_int_eq(pipe(ends), 0);
        pid_t child = fork();
        ck_assert_int_ge(child, 0);
        if (child == 0) add_until_killed(path, ends[1]);
        close(ends[1]);

        /* kill it some moments after it acknowledged a few: within one of its transactions as a rule */
        int32_t told = 0, one, stop = 1 + (int32_t)(support_random(&state) % 5);
        for (int32_t i = 0; i < stop && read(ends[0], &one, sizeof one) == sizeof one; i++) told = one;
        struct timespec moment = {0, (long)(support_random(&state) % 3000000)};
        nanosleep(&moment, NULL);
        ck_assert_int_eq(kill(child, SIGKILL), 0);
        ck_assert_int_eq(waitpid(child, NULL, 0), child);
        while (read(ends[0], &one, sizeof one) == sizeof one) told = one;
        close(ends[0]);
        ck_assert_int_gt(told, 0);

        /* all that was told is there, in whole transactions, and the file is sound; reading alone puts it right */
        mus_catalogue *catalogue = open_catalogue(context, path, MUS_CATALOGUE_READ);
        int32_t count = mus_catalogue_count(catalogue), n;
        ck_assert_msg(count >= told && count % TOGETHER == 0, "%d told, %d there", (int)told, (int)count);
        mus_pattern *pattern = garment_pattern(context, 4, 0);
        ck_assert_int_eq(mus_catalogue_exact(catalogue, pattern, NULL, 0, &n), MUS_OK);
        ck_assert_int_eq(n, count);
        mus_pattern_destroy(pattern);
        mus_catalogue_destroy(catalogue);
    }
    support_context_end(context);
}
END_TEST


START_TEST(failing_allocations_leave_nothing_and_no_half_row)
{
    char path[1024];
    for (int64_t n = 0;; n++) {
        mus_context *context = support_context();
        mus_catalogue *catalogue;
        int32_t found, id[3], before = 0;
        support_scratch("a.db", path, sizeof path);
        remove(path);
        mus_pattern *pattern = garment_pattern(context, 4, 0);
        support_fail_after(n, false);
        mus_status status = mus_catalogue_open(context, path, MUS_CATALOGUE_WRITE, &catalogue);
        if (status == MUS_OK) status = mus_catalogue_add(catalogue, pattern, "a", NULL);
        if (status == MUS_OK) before = 1;
        if (status == MUS_OK) status = mus_catalogue_nearest(catalogue, pattern, 3, id, NULL, NULL, &found);
        if (status == MUS_OK) status = mus_catalogue_containing(catalogue, pattern, id, 3, &found);
        support_fail_never();
        if (catalogue != NULL) ck_assert_int_eq(mus_catalogue_count(catalogue), before);
        mus_catalogue_destroy(catalogue);
        mus_pattern_destroy(pattern);
        support_context_end(context);
        if (status == MUS_OK) break;
        ck_assert_int_eq(status, MUS_ERR_MEMORY);
    }
}
END_TEST


Suite *mus_suite_catalogue(void);


Suite *mus_suite_catalogue(void)
{
    Suite *suite = suite_create("catalogue");
    TCase *tcase = tcase_create("catalogue");
    tcase_set_timeout(tcase, 120);
    tcase_add_test(tcase, every_garment_of_the_tables_is_found_again);
    tcase_add_test(tcase, a_few_nearest_are_the_first_of_all);
    tcase_add_test(tcase, names_are_kept_once_and_transactions_all_or_none);
    tcase_add_test(tcase, what_is_no_catalogue_or_of_a_newer_version_is_refused);
    tcase_add_test(tcase, calls_out_of_turn_and_damaged_rows_are_refused);
    tcase_add_test(tcase, a_hostile_file_runs_nothing_and_ends);
    tcase_add_test(tcase, a_program_killed_in_its_work_loses_nothing_acknowledged);
    tcase_add_test(tcase, failing_allocations_leave_nothing_and_no_half_row);
    suite_add_tcase(suite, tcase);
    return suite;
}
