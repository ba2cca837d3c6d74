/*
 * batch.c: muslin dress --batch: the garments of a list, N processes at a time.
 *
 * Each garment is dressed by a process of its own, by the same calls as muslin dress; a crash or a run over its time
 * limit becomes a result with its reason. The process itself writes the result as soon as it is known (batch_part.c),
 * so the batch can be killed at any moment; a later run over the same list dresses the garments that are not finished.
 * The results depend on the list and its files only, not on the number of processes or on interruptions.
 */
#define _DEFAULT_SOURCE /* wait4, setitimer */
#include "batch.h"

#include <errno.h>
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif


/* user and system time [s] of a process: of this one, or of another one's rusage */
static double cpu_seconds(const struct rusage *of)
{
    struct rusage own;
    if (of == NULL && getrusage(RUSAGE_SELF, &own) == 0) of = &own;
    if (of == NULL) return 0.0;
    return (double)(of->ru_utime.tv_sec + of->ru_stime.tv_sec) +
           1e-6 * (double)(of->ru_utime.tv_usec + of->ru_stime.tv_usec);
}


/* ---- one garment, in its process ---- */

/* the CPU time limit of one garment [s] */
typedef struct watch {
    double limit;
    bool late;
} watch;


/* the progress function of sewing and settling: nonzero stops the run */
static int32_t look_at_watch(void *user, const mus_progress *progress)
{
    watch *w = user;
    (void)progress;
    w->late = w->late || cpu_seconds(NULL) > w->limit;
    return w->late;
}


/* Limits this process: no core file; it ends with the batch; a hard time limit for work that the watch does not stop.
 */
static void bound_self(const batch *b, pid_t parent)
{
    const struct rlimit none = {0, 0};
    setrlimit(RLIMIT_CORE, &none);
    if (b->limit > 0.0) {
        struct itimerval end = {{0, 0}, {(time_t)ceil(1.5 * b->limit) + 5, 0}};
        signal(SIGPROF, SIG_DFL);
        setitimer(ITIMER_PROF, &end, NULL);
    }
#ifdef __linux__
    prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
    if (getppid() != parent) _exit(EXIT_FAILED);
}


/* Sets the paths of the output files from the garment's name; the texts are kept in `paths`. */
static void ask_files(const batch *b, const batch_line *g, dress *d, char paths[3][4096])
{
    d->quiet = true;
    if (b->png && batch_path(b, g->name, ".png", paths[0])) d->png = paths[0];
    if (b->glb && batch_path(b, g->name, ".glb", paths[1])) d->files[MUS_MESH_GLB] = paths[1];
    if (b->obj && batch_path(b, g->name, ".obj", paths[2])) d->files[MUS_MESH_OBJ] = paths[2];
}


/* Removes the files beside the output files that a killed process was writing; the folder is this batch's alone. */
static void remove_left(const batch *b, const batch_line *g)
{
    static const char *const endings[] = {".glb.part0", ".obj.part0", ".mtl.part0"};
    char path[4096];
    for (size_t i = 0; i < sizeof endings / sizeof *endings; i++)
        if (batch_path(b, g->name, endings[i], path)) remove(path);
}


/* Writes the members of a garment's result; `said` is the first complaint, which was kept from standard error. */
static void write_result(const dress *d, bool opened, const char *status, const char *said, json *j)
{
    json_open(j, NULL, '{');
    if (opened) {
        dress_describe(d, false, j);
        if (said[0] != '\0') json_text(j, "not_written", said);
    } else {
        json_text(j, "status", status);
        json_text(j, "reason", said);
        json_warnings(j);
    }
    json_close(j, '}');
}


/* Writes the result of a garment whose process wrote none: "out of time", "crashed". */
static void write_end(const char *status, const char *reason, json *j)
{
    json_open(j, NULL, '{');
    json_text(j, "status", status);
    json_text(j, "reason", reason);
    json_close(j, '}');
}


static void write_late(const batch *b, json *j)
{
    char reason[80];
    snprintf(reason, sizeof reason, "no end after %.9g CPU seconds", b->limit);
    write_end("out of time", reason, j);
}


/* Dresses the garment and writes its part. Returns an exit code. */
static int dress_line(const batch *b, const batch_line *g)
{
    complaints said;
    watch clock = {b->limit, false};
    char paths[3][4096];
    const char *name;
    dress *d = malloc(sizeof *d);
    if (d == NULL) return EXIT_FAILED;
    complaints_keep(&said);
    int code = batch_options(b, g, d, &name);
    ask_files(b, g, d, paths);
    remove_left(b, g);
    if (b->limit > 0.0) d->progress = look_at_watch, d->progress_user = &clock;
    if (code == EXIT_DONE) code = dress_open(d);
    const bool opened = code == EXIT_DONE;
    if (opened) code = dress_run(d);

    const bool late = b->limit > 0.0 && look_at_watch(&clock, NULL) != 0;
    const char *status = opened ? dress_status(d) : code == EXIT_INPUT ? "bad input" : "no memory";
    const bool whole = opened ? code == EXIT_DONE : code == EXIT_INPUT;
    batch_part part = {.hold = whole && strcmp(status, "no memory") != 0 ? BATCH_DONE : BATCH_AGAIN};
    json result = {0}, times = {0};
    if (late && part.hold == BATCH_DONE) {
        status = "out of time", part.hold = BATCH_LIMIT;
        write_late(b, &result);
    } else {
        write_result(d, opened, status, said.text, &result);
    }
    complaints_keep(NULL);
    part.cpu = cpu_seconds(NULL);
    json_open(&times, NULL, '{');
    json_number(&times, "cpu_s", part.cpu);
    if (opened) dress_seconds(d, &times);
    json_close(&times, '}');
    snprintf(part.status, sizeof part.status, "%s", status);
    part.result = result.text, part.times = times.text;
    code = result.failed || times.failed ? complain(EXIT_FAILED, "dress", "no memory for the report of %s", g->name)
                                         : batch_part_write(b, g, &part);
    json_free(&result);
    json_free(&times);
    if (d->s.context != NULL) dress_close(d);
    free(d);
    return code;
}


/* ---- all of them ---- */

static bool start_line(const batch *b, batch_line *g)
{
    const pid_t parent = getpid();
    fflush(NULL);
    g->pid = fork();
    if (g->pid == 0) {
        bound_self(b, parent);
        _exit(dress_line(b, g));
    }
    if (g->pid < 0) g->pid = 0;
    return g->pid != 0;
}


/* Ends a garment whose process has exited: writes the part of a process that did not. Returns an exit code. */
static int end_line(const batch *b, batch_line *g, int ended, const struct rusage *used)
{
    char reason[200];
    batch_part part = {.hold = BATCH_DONE, .cpu = cpu_seconds(used)};
    g->pid = 0;
    if (WIFEXITED(ended) && WEXITSTATUS(ended) == EXIT_DONE) return EXIT_DONE;

    /* a process that was killed from outside, or by the system for want of memory, is tried again by the next run */
    const int number = WIFSIGNALED(ended) ? WTERMSIG(ended) : 0;
    const bool late = number == SIGPROF;
    if (late) part.hold = BATCH_LIMIT;
    else if (number == SIGKILL || number == 0) part.hold = BATCH_AGAIN;
    if (number != 0) snprintf(reason, sizeof reason, "signal %d (%s)", number, strsignal(number));
    else snprintf(reason, sizeof reason, "ended with %d", WEXITSTATUS(ended));
    snprintf(part.status, sizeof part.status, "%s", late ? "out of time" : "crashed");

    json result = {0}, times = {0};
    if (late) write_late(b, &result);
    else write_end(part.status, reason, &result);
    json_open(&times, NULL, '{');
    json_number(&times, "cpu_s", part.cpu);
    json_close(&times, '}');
    part.result = result.text, part.times = times.text;
    const int code = result.failed || times.failed ? complain(EXIT_FAILED, "dress", "no memory for a report")
                                                   : batch_part_write(b, g, &part);
    json_free(&result);
    json_free(&times);
    return code;
}


/* Waits for one process to exit. Returns an exit code. */
static int await_line(batch *b)
{
    struct rusage used;
    int ended = 0;
    pid_t pid;
    do pid = wait4(-1, &ended, 0, &used);
    while (pid < 0 && errno == EINTR);
    if (pid < 0) return complain(EXIT_FAILED, "dress", "a process is lost: %s", strerror(errno));
    for (int32_t i = 0; i < b->count; i++)
        if (b->line[i].pid == pid) return end_line(b, &b->line[i], ended, &used);
    return EXIT_DONE;
}


static int run_lines(batch *b, int32_t *kept)
{
    const bool show = !b->quiet && isatty(STDERR_FILENO);
    int32_t next = 0, running = 0, code = EXIT_DONE;
    while ((next < b->count && code == EXIT_DONE) || running > 0) {
        batch_line *g = next < b->count && code == EXIT_DONE && running < (int32_t)b->jobs ? &b->line[next] : NULL;
        if (g != NULL && g->fault[0] != '\0') {
            next++;
        } else if (g != NULL && batch_part_done(b, g)) {
            next++, ++*kept;
        } else if (g != NULL && start_line(b, g)) {
            next++, running++;
        } else if (running == 0) {
            code = complain(EXIT_FAILED, "dress", "no process for %s: %s", g->name, strerror(errno));
        } else {
            const int ended = await_line(b);
            running--;
            if (code == EXIT_DONE) code = ended;
            if (show) fprintf(stderr, "\r%d of %d", (int)(next - running), (int)b->count);
        }
    }
    if (show) fputs("\r                    \r", stderr);
    return code;
}


static int read_options(batch *b, int argc, char **argv)
{
    const option own[] = {
        {"--batch", OPTION_TEXT, &b->list, 0, 0, "LIST  the garments, a line each: options; - for standard input"},
        {"-o", OPTION_TEXT, &b->folder, 0, 0, "DIR  for results.jsonl, times.jsonl, parts/"},
        {"--jobs", OPTION_WHOLE, &b->jobs, 1, 256, "N  processes, default 1; the results are the same"},
        {"--limit", OPTION_NUMBER, &b->limit, 0.001, 1e6, "S  CPU seconds that a garment may take, default no limit"},
        {"--png", OPTION_FLAG, &b->png, 0, 0, "a picture of each, DIR/NAME.png"},
        {"--glb", OPTION_FLAG, &b->glb, 0, 0, "body and garment of each as binary glTF 2.0, DIR/NAME.glb"},
        {"--obj", OPTION_FLAG, &b->obj, 0, 0, "body and garment of each as OBJ, DIR/NAME.obj"},
        {"--part", OPTION_TEXT, &b->part, 0, 0, "I/N  each N-th garment of the list, from the I-th on"},
        {"--quiet", OPTION_FLAG, &b->quiet, 0, 0, "no progress on the terminal"},
        {NULL, OPTION_FLAG, NULL, 0, 0, NULL}};
    option options[DRESS_OPTIONS + sizeof own / sizeof *own];
    b->jobs = 1.0;
    dress_init(&b->all);
    memcpy(options + dress_options(&b->all, options), own, sizeof own);
    if (!args_read("dress", "Dress the garments of a list. Options given here hold for lines without their own.",
                   options, argc, argv))
        return EXIT_INPUT;
    if (b->folder == NULL) return complain(EXIT_INPUT, "dress", "--batch %s: no folder is given: -o DIR", b->list);
    return dress_check("dress", &b->all);
}


int batch_dress(int argc, char **argv)
{
    batch b = {0};
    int32_t kept = 0;
    int code = read_options(&b, argc, argv);
    if (code == EXIT_DONE) code = batch_read(&b);
    if (code == EXIT_DONE) code = batch_open(&b);
    if (code == EXIT_DONE) code = run_lines(&b, &kept);
    if (code == EXIT_DONE) code = batch_results(&b, kept);
    batch_free(&b);
    return code;
}
