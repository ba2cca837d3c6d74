/*
 * main.c: the program of `make same`: makes all rows, and compares them with the committed tables.
 *
 *     build/bin/same ROOT DATA [write] [WORDS...]
 *
 * ROOT is the folder of the repository, DATA that of the real data. A row is made when its name contains every word.
 * `write` writes what was made into the tables; a row that failed is never written. Rows that need DATA are skipped
 * where it is not. Printed: each row that is not the table's, with both digests; CPU seconds; and as the last line
 * "N rows equal, N changed, N skipped". Exit 0 when none changed or failed, and, with one line that says so, on a
 * machine whose digests would be others; 1 when some did; 2 for bad input.
 */
#define _DEFAULT_SOURCE /* realpath, wait4 */
#include "same.h"

#include <dirent.h>
#include <inttypes.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#define MOST_JOBS 64
#define ROW_SECONDS 600 /* wall time after which a row is taken for hung: a slow one takes 3 s */
#define START_DIGEST UINT64_C(0xcbf29ce484222325)

/* a row that is being made */
typedef struct job {
    pid_t process;
    int from; /* the end of a pipe that the digest comes out of */
    same_row *row;
} job;

static const char *const tables[2] = {"tests/same/same.table", "tests/same/designs.table"};


/* ---- one row in a process of its own ---- */

static void folder_of(char *path, size_t size, const char *scratch, pid_t process)
{
    snprintf(path, size, "%s/%ld", scratch, (long)process);
}


/* in the child: the digest goes into the pipe */
static void make_row(const same_row *row, same_run *run, const char *scratch, int to)
{
    char folder[PATH_MAX], text[24];
    folder_of(folder, sizeof folder, scratch, getpid());
    if (mkdir(folder, 0700) != 0 || chdir(folder) != 0) exit(4);
    alarm(ROW_SECONDS);
    run->digest = START_DIGEST;
    same_must(run, mus_context_create(NULL, &run->context), "mus_context_create");
    row->make(run, row->what, row->index);
    const int length = snprintf(text, sizeof text, "%016" PRIx64, run->digest);
    if (write(to, text, (size_t)length) != length) exit(4);
    _exit(0);
}


static bool start(job *one, same_row *row, same_run *run, const char *scratch)
{
    int end[2];
    if (pipe(end) != 0) return false;
    fflush(NULL);
    *one = (job){.process = fork(), .from = end[0], .row = row};
    if (one->process == 0) make_row(row, run, scratch, end[1]);
    close(end[1]);
    return one->process > 0;
}


/* the folder of a row, with its files */
static void remove_folder(const char *path)
{
    char file[2 * PATH_MAX];
    DIR *folder = opendir(path);
    for (struct dirent *one; folder != NULL && (one = readdir(folder)) != NULL;) {
        snprintf(file, sizeof file, "%s/%s", path, one->d_name);
        if (one->d_name[0] != '.') unlink(file);
    }
    if (folder != NULL) closedir(folder);
    rmdir(path);
}


static double cpu_of(const struct rusage *used)
{
    return (double)(used->ru_utime.tv_sec + used->ru_stime.tv_sec) +
           1e-6 * (double)(used->ru_utime.tv_usec + used->ru_stime.tv_usec);
}


static void finish(job *one, int ended, const char *scratch)
{
    char path[PATH_MAX];
    const ssize_t got = read(one->from, one->row->found, 16);
    close(one->from);
    folder_of(path, sizeof path, scratch, one->process);
    remove_folder(path);
    if (WIFEXITED(ended) && WEXITSTATUS(ended) == 0 && got == 16) return;
    snprintf(one->row->found, sizeof one->row->found, "failed");
    fprintf(stderr, "%s: failed (%s %d)\n", one->row->name, WIFSIGNALED(ended) ? "signal" : "exit",
            WIFSIGNALED(ended) ? WTERMSIG(ended) : WEXITSTATUS(ended));
}


/* wait for any row to end; its place among the jobs is free again */
static void finish_one(job *jobs, int *running, const char *scratch)
{
    int ended = 0;
    struct rusage used;
    const pid_t process = wait4(-1, &ended, 0, &used);
    for (int i = 0; i < *running; i++)
        if (jobs[i].process == process) {
            jobs[i].row->seconds = cpu_of(&used);
            finish(&jobs[i], ended, scratch);
            jobs[i] = jobs[--*running];
            return;
        }
}


static bool is_asked(const same_row *row, char **words, int count)
{
    for (int i = 0; i < count; i++)
        if (strstr(row->name, words[i]) == NULL) return false;
    return true;
}


/* make what is asked, as many rows at once as there are cores; false when that cannot be */
static bool make_rows(same_list *list, same_run *run, char **words, int count)
{
    char scratch[] = "/tmp/muslin-same-XXXXXX";
    job jobs[MOST_JOBS];
    int running = 0;
    const long cores = sysconf(_SC_NPROCESSORS_ONLN), most = cores < 1 ? 1 : cores > MOST_JOBS ? MOST_JOBS : cores;
    if (mkdtemp(scratch) == NULL) return false;
    for (int32_t i = 0; i < list->count; i++) {
        same_row *row = &list->row[i];
        if (row->make == NULL || !is_asked(row, words, count)) continue;
        if (row->data && run->data == NULL) {
            snprintf(row->found, sizeof row->found, "skipped");
            continue;
        }
        while (running >= most) finish_one(jobs, &running, scratch);
        if (!start(&jobs[running], row, run, scratch)) return false;
        running++;
    }
    while (running > 0) finish_one(jobs, &running, scratch);
    return rmdir(scratch) == 0;
}


/* ---- all rows ---- */

static void add_groups(same_list *list)
{
    same_scenes(list);
    same_steps(list);
    same_moved(list);
    same_nets(list);
    same_drafts(list);
    same_sheets(list);
    same_readings(list);
    same_meshes(list);
    same_bodies(list);
    same_sewn(list);
    same_cuts(list);
}


/* Prints the CPU seconds of all rows, and the row that took most. */
static void print_seconds(const same_list *list)
{
    const same_row *slowest = NULL;
    double sum = 0.0;
    for (int32_t i = 0; i < list->count; i++) {
        const same_row *row = &list->row[i];
        sum += row->seconds;
        if (slowest == NULL || row->seconds > slowest->seconds) slowest = row;
    }
    if (slowest != NULL) printf("%.0f CPU seconds, %.1f of them %s\n", sum, slowest->seconds, slowest->name);
}


/* says what changed; the exit code */
static int compare(const same_list *list, char **words, int count)
{
    int equal = 0, changed = 0, skipped = 0;
    for (int32_t i = 0; i < list->count; i++) {
        const same_row *row = &list->row[i];
        if (!is_asked(row, words, count)) continue;
        if (strcmp(row->found, "skipped") == 0) skipped++;
        else if (strcmp(row->found, row->kept) == 0) equal++;
        else {
            changed++;
            printf("%s: %s in the table, now %s\n", row->name, row->kept[0] != '\0' ? row->kept : "nothing",
                   row->found[0] != '\0' ? row->found : "nothing");
        }
    }
    if (skipped > 0) printf("skipped: rows that need the real data: there is no folder of it\n");
    print_seconds(list);
    printf("%d rows equal, %d changed, %d skipped\n", equal, changed, skipped);
    if (equal + changed + skipped == 0) fprintf(stderr, "same: no row has these words in its name\n");
    return changed > 0 || equal + skipped == 0;
}


/* Writes the digests made to the tables; the digest of a row that failed or was skipped stays. */
static int write_tables(same_list *list, char paths[2][PATH_MAX], const char *machine)
{
    int made = 0, failed = 0;
    for (int32_t i = 0; i < list->count; i++) {
        same_row *row = &list->row[i];
        const bool digest = row->found[0] != '\0' && strcmp(row->found, "failed") != 0 &&
                            strcmp(row->found, "skipped") != 0;
        made += digest;
        failed += strcmp(row->found, "failed") == 0;
        if (!digest) row->found[0] = '\0';
    }
    const bool written = same_write(list, paths[0], machine, NULL, "designs/") &&
                         same_write(list, paths[1], machine, "designs/", NULL);
    printf("%d rows written, %d failed\n", written ? made : 0, failed);
    return !written || failed > 0;
}


int main(int argc, char **argv)
{
    static char root[PATH_MAX], data[PATH_MAX], figures[PATH_MAX + 16], paths[2][PATH_MAX], machine[LINE_MAX];
    same_list list = {0};
    same_run run = {.root = root, .figures = figures};
    if (argc < 3 || realpath(argv[1], root) == NULL || realpath(argv[0], figures) == NULL)
        return fprintf(stderr, "usage: same ROOT DATA [write] [WORDS...]\n"), 2;
    if (realpath(argv[2], data) != NULL) run.data = data;
    snprintf(strrchr(figures, '/'), 16, "/figures");
    const bool write = argc > 3 && strcmp(argv[3], "write") == 0;
    char **words = argv + 3 + write;
    const int count = argc - 3 - write;

    add_groups(&list);
    same_machine(machine, sizeof machine);
    for (int i = 0; i < 2; i++) {
        snprintf(paths[i], sizeof paths[i], "%.*s/%s", PATH_MAX - 64, root, tables[i]);
        const int state = same_read(&list, paths[i], machine);
        if (state != 1 || write) continue;
        printf("skipped: digests of pages hold for one cairo, and this is not that of %s (%s)\n", tables[i],
               machine + 2);
        return 0;
    }
    if (!make_rows(&list, &run, words, count)) return perror("same"), 2;
    return write ? write_tables(&list, paths, machine) : compare(&list, words, count);
}
