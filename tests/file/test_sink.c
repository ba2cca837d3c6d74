/*
 * test_sink.c: an output file is whole or not at all, and nothing is left beside it.
 */
#define _POSIX_C_SOURCE 200809L
#include <dirent.h>
#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include "muslin/exchange.h"
#include "support.h"


/* files in the folder of the scratch files */
static int count_files(const char *path)
{
    char folder[512];
    snprintf(folder, sizeof folder, "%s", path);
    *strrchr(folder, '/') = '\0';
    DIR *open = opendir(folder);
    ck_assert_ptr_nonnull(open);
    int count = 0;
    for (const struct dirent *entry; (entry = readdir(open)) != NULL;) count += entry->d_name[0] != '.';
    closedir(open);
    return count;
}


static mus_tape *make_tape(mus_context *context)
{
    mus_tape *tape;
    ck_assert_int_eq(mus_tape_create(context, &tape), MUS_OK);
    ck_assert_int_eq(mus_tape_set(tape, MUS_MEASURE_BUST, 0.92, MUS_SOURCE_GIVEN), MUS_OK);
    return tape;
}


START_TEST(a_new_file_replaces_the_old_one_and_leaves_nothing_beside_it)
{
    mus_context *context = support_context();
    mus_tape *tape = make_tape(context);
    char path[512];
    support_spill(support_scratch("a.tape", path, sizeof path), "old and much longer than what comes next ......", 48);
    for (int i = 0; i < 3; i++) ck_assert_int_eq(mus_tape_write(tape, path), MUS_OK);
    char *text = support_slurp(path, NULL);
    ck_assert_str_eq(text, "# muslin tape\nbust 92 cm\n");
    free(text);
    ck_assert_int_eq(count_files(path), 1);

    /* the mode is that of any new file, not of a private one */
    struct stat info;
    mode_t mask = umask(0);
    umask(mask);
    ck_assert_int_eq(stat(path, &info), 0);
    ck_assert_uint_eq(info.st_mode & 0777, 0666 & ~mask);
    mus_tape_destroy(tape);
    support_context_end(context);
}
END_TEST


START_TEST(a_link_stays_a_link)
{
    mus_context *context = support_context();
    mus_tape *tape = make_tape(context);
    char path[512], link[512];
    support_spill(support_scratch("target.tape", path, sizeof path), "old", 3);
    ck_assert_int_eq(symlink("target.tape", support_scratch("link.tape", link, sizeof link)), 0);
    ck_assert_int_eq(mus_tape_write(tape, link), MUS_OK);
    struct stat info;
    ck_assert_int_eq(lstat(link, &info), 0);
    ck_assert(S_ISLNK(info.st_mode));
    char *text = support_slurp(path, NULL);
    ck_assert_str_eq(text, "# muslin tape\nbust 92 cm\n");
    free(text);
    ck_assert_int_eq(count_files(path), 2);
    mus_tape_destroy(tape);
    support_context_end(context);
}
END_TEST


START_TEST(an_output_that_cannot_be_written_is_named_and_leaves_nothing)
{
    mus_context *context = support_context();
    mus_tape *tape = make_tape(context);
    char path[512], there[512], folder[512];
    support_spill(support_scratch("there", there, sizeof there), "x", 1);

    /* no folder, a file for a folder, a folder for a file, a full device */
    ck_assert_int_eq(mus_tape_write(tape, support_scratch("none/a.tape", path, sizeof path)), MUS_ERR_FILE);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), "none/a.tape: cannot be written"));
    ck_assert_int_eq(mus_tape_write(tape, support_scratch("there/a.tape", path, sizeof path)), MUS_ERR_FILE);
    ck_assert_int_eq(mkdir(support_scratch("folder", folder, sizeof folder), 0777), 0);
    ck_assert_int_eq(mus_tape_write(tape, folder), MUS_ERR_FILE);
    if (access("/dev/full", W_OK) == 0) {
        ck_assert_int_eq(mus_tape_write(tape, "/dev/full"), MUS_ERR_FILE);
        ck_assert_ptr_nonnull(strstr(mus_context_error(context), strerror(ENOSPC)));
        struct stat info;
        ck_assert_int_eq(stat("/dev/full", &info), 0);
        ck_assert(S_ISCHR(info.st_mode));
    }
    ck_assert_int_eq(mus_tape_write(tape, ""), MUS_ERR_FILE);
    ck_assert_int_eq(mus_tape_write(tape, NULL), MUS_ERR_ARG);
    ck_assert_int_eq(count_files(there), 2);

    /* a name that leaves no room for a file beside it */
    char name[300];
    memset(name, 'a', sizeof name);
    memcpy(name + 250, ".tape", 6);
    ck_assert_int_eq(mus_tape_write(tape, support_scratch(name, path, sizeof path)), MUS_ERR_FILE);
    ck_assert_int_eq(count_files(there), 2);
    mus_tape_destroy(tape);
    support_context_end(context);
}
END_TEST


START_TEST(a_disk_that_fills_up_leaves_the_old_file_and_nothing_beside_it)
{
    /* a limit on the size of files stands in for the disk: the new file breaks off after 10 bytes */
    mus_context *context = support_context();
    mus_tape *tape = make_tape(context);
    char path[512];
    support_spill(support_scratch("full.tape", path, sizeof path), "old", 3);
    struct rlimit before;
    ck_assert_int_eq(getrlimit(RLIMIT_FSIZE, &before), 0);
    struct rlimit small = {10, before.rlim_max};
    signal(SIGXFSZ, SIG_IGN);
    ck_assert_int_eq(setrlimit(RLIMIT_FSIZE, &small), 0);
    mus_status status = mus_tape_write(tape, path);
    ck_assert_int_eq(setrlimit(RLIMIT_FSIZE, &before), 0);
    signal(SIGXFSZ, SIG_DFL);
    ck_assert_int_eq(status, MUS_ERR_FILE);
    ck_assert_ptr_nonnull(strstr(mus_context_error(context), strerror(EFBIG)));
    char *text = support_slurp(path, NULL);
    ck_assert_str_eq(text, "old");
    free(text);
    ck_assert_int_eq(count_files(path), 1);
    mus_tape_destroy(tape);
    support_context_end(context);
}
END_TEST


START_TEST(the_old_file_is_whole_when_memory_runs_out)
{
    char path[512];
    support_spill(support_scratch("old.tape", path, sizeof path), "old", 3);
    for (int64_t n = 0;; n++) {
        mus_context *context = support_context();
        mus_tape *tape = make_tape(context);
        support_fail_after(n, false);
        mus_status status = mus_tape_write(tape, path);
        support_fail_never();
        mus_tape_destroy(tape);
        support_context_end(context);
        if (status == MUS_OK) break;
        ck_assert_int_eq(status, MUS_ERR_MEMORY);
        char *text = support_slurp(path, NULL);
        ck_assert_str_eq(text, "old");
        free(text);
        ck_assert_int_eq(count_files(path), 1);
    }
}
END_TEST


START_TEST(files_left_by_a_killed_run_do_not_stand_in_the_way)
{
    mus_context *context = support_context();
    mus_tape *tape = make_tape(context);
    char path[512], left[512];
    support_spill(support_scratch("b.tape.part0", left, sizeof left), "left", 4);
    ck_assert_int_eq(mus_tape_write(tape, support_scratch("b.tape", path, sizeof path)), MUS_OK);
    char *text = support_slurp(left, NULL);
    ck_assert_str_eq(text, "left");
    free(text);
    ck_assert_int_eq(count_files(path), 2);
    mus_tape_destroy(tape);
    support_context_end(context);
}
END_TEST


START_TEST(a_dash_is_standard_output)
{
    mus_context *context = support_context();
    mus_tape *tape = make_tape(context);
    char path[512];
    support_scratch("out", path, sizeof path);
    fflush(stdout);
    int before = dup(1);
    FILE *file = fopen(path, "wb");
    ck_assert_int_eq(dup2(fileno(file), 1), 1);
    mus_status status = mus_tape_write(tape, "-");
    ck_assert_int_eq(dup2(before, 1), 1);
    close(before);
    fclose(file);
    ck_assert_int_eq(status, MUS_OK);
    char *text = support_slurp(path, NULL);
    ck_assert_str_eq(text, "# muslin tape\nbust 92 cm\n");
    free(text);
    mus_tape_destroy(tape);
    support_context_end(context);
}
END_TEST


Suite *mus_suite_sink(void);

Suite *mus_suite_sink(void)
{
    Suite *suite = suite_create("sink");
    TCase *tests = tcase_create("sink");
    tcase_add_test(tests, a_new_file_replaces_the_old_one_and_leaves_nothing_beside_it);
    tcase_add_test(tests, a_link_stays_a_link);
    tcase_add_test(tests, an_output_that_cannot_be_written_is_named_and_leaves_nothing);
    tcase_add_test(tests, a_disk_that_fills_up_leaves_the_old_file_and_nothing_beside_it);
    tcase_add_test(tests, the_old_file_is_whole_when_memory_runs_out);
    tcase_add_test(tests, files_left_by_a_killed_run_do_not_stand_in_the_way);
    tcase_add_test(tests, a_dash_is_standard_output);
    suite_add_tcase(suite, tests);
    return suite;
}
