/*
 * batch_part.c: the results of a batch: one part file for each garment, and the two files assembled from all parts.
 *
 * FOLDER/parts/NAME is the part of a garment, three lines:
 *
 *     1 KEY HOLD CPU STATUS      hold: done; again; or limit:S, which holds while the limit is S
 *     {"status": ...}            the same in each run
 *     {"cpu_s": ...}             time
 *
 * It is written to a temporary file, synced to the disk and renamed, so that after a kill -9 or a power cut a part is
 * complete or absent. FOLDER/results.jsonl has the second line of every part in the order of the list,
 * FOLDER/times.jsonl the third. A lock on FOLDER/parts keeps a second batch out; it ends with the process.
 */
#define _POSIX_C_SOURCE 200809L /* fcntl, fsync, fileno, mkdir */
#include "batch.h"

#include <errno.h>
#include <fcntl.h>
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define STATUSES_MOST 32


bool batch_path(const batch *b, const char *name, const char *ending, char out[4096])
{
    return snprintf(out, 4096, "%s/%s%s", b->folder, name, ending) < 4096;
}


/* ---- files that are complete or absent ---- */

typedef struct whole {
    FILE *file;
    char path[4096], beside[4096];
} whole;


/* Opens FOLDER/NAME for writing; `folder` is "parts/" or "". */
static bool whole_open(whole *w, const batch *b, const char *folder, const char *name)
{
    const char *at = b->folder;
    w->file = NULL;
    if (snprintf(w->path, sizeof w->path, "%s/%s%s", at, folder, name) >= (int)sizeof w->path) return false;
    if (snprintf(w->beside, sizeof w->beside, "%s/%s%s.new", at, folder, name) >= (int)sizeof w->beside) return false;
    w->file = fopen(w->beside, "wb");
    return w->file != NULL;
}


/* Syncs the file to the disk and renames it. */
static bool whole_close(whole *w, const batch *b, const char *folder)
{
    char path[4096];
    bool done = w->file != NULL && !ferror(w->file) && fflush(w->file) == 0 && fsync(fileno(w->file)) == 0;
    if (w->file != NULL && fclose(w->file) != 0) done = false;
    if (!done || rename(w->beside, w->path) != 0) return false;
    snprintf(path, sizeof path, "%s/%s", b->folder, folder);
    const int place = open(path, O_RDONLY);
    if (place >= 0) fsync(place), close(place);
    return true;
}


static void whole_drop(whole *w)
{
    if (w->file == NULL) return;
    fclose(w->file);
    remove(w->beside);
}


static int cannot_write(const whole *w)
{
    return complain(EXIT_FAILED, "dress", "%.3000s: cannot be written: %s", w->path, strerror(errno));
}


int batch_open(batch *b)
{
    char path[4096];
    struct flock lock = {.l_type = F_WRLCK, .l_whence = SEEK_SET};
    if (strlen(b->folder) > sizeof path - 256)
        return complain(EXIT_INPUT, "dress", "-o %.60s...: the name is too long", b->folder);
    if (mkdir(b->folder, 0777) != 0 && errno != EEXIST)
        return complain(EXIT_INPUT, "dress", "-o %s: %s", b->folder, strerror(errno));
    batch_path(b, "parts", "", path);
    if (mkdir(path, 0777) != 0 && errno != EEXIST)
        return complain(EXIT_INPUT, "dress", "%.3000s: %s", path, strerror(errno));

    /* the lock belongs to the process: it ends with it, and its children do not inherit it */
    batch_path(b, "parts/.lock", "", path);
    const int file = open(path, O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (file < 0) return complain(EXIT_INPUT, "dress", "%.3000s: cannot be written: %s", path, strerror(errno));
    if (fcntl(file, F_SETLK, &lock) != 0 && (errno == EACCES || errno == EAGAIN))
        return complain(EXIT_INPUT, "dress", "-o %s: another batch is at work there", b->folder);

    /* remove the results of an earlier list */
    batch_path(b, "results.jsonl", "", path);
    remove(path);
    batch_path(b, "times.jsonl", "", path);
    remove(path);
    return EXIT_DONE;
}


/* ---- parts ---- */

static void hold_word(const batch *b, batch_hold hold, char out[40])
{
    if (hold == BATCH_LIMIT) snprintf(out, 40, "limit:%.9g", b->limit);
    else snprintf(out, 40, "%s", hold == BATCH_DONE ? "done" : "again");
}


int batch_part_write(const batch *b, const batch_line *g, const batch_part *part)
{
    whole w;
    char hold[40];
    hold_word(b, part->hold, hold);
    if (whole_open(&w, b, "parts/", g->name))
        fprintf(w.file, "1 %016" PRIx64 " %s %.6f %s\n%s\n%s\n", g->key, hold, part->cpu, part->status, part->result,
                part->times);
    return whole_close(&w, b, "parts/") ? EXIT_DONE : cannot_write(&w);
}


/* Reads a small file into a text that ends with 0; NULL when it cannot be read. */
static char *read_whole(const char *path)
{
    struct stat there;
    FILE *file = fopen(path, "rb");
    char *text = NULL;
    if (file != NULL && fstat(fileno(file), &there) == 0 && S_ISREG(there.st_mode)) {
        const size_t bytes = (size_t)there.st_size;
        text = malloc(bytes + 1);
        if (text != NULL && fread(text, 1, bytes, file) == bytes) {
            text[bytes] = '\0';
        } else {
            free(text);
            text = NULL;
        }
    }
    if (file != NULL) fclose(file);
    return text;
}


bool batch_part_read(const batch *b, const batch_line *g, batch_part *part)
{
    char path[4096], folder[BATCH_NAME + 32], word[40], limit[40];
    uint64_t key = 0;
    int at = 0;
    memset(part, 0, sizeof *part);
    snprintf(folder, sizeof folder, "parts/%s", g->name);
    char *text = batch_path(b, folder, "", path) ? read_whole(path) : NULL;
    if (text == NULL) return false;

    /* three lines: the first of a fixed form, and no more than what ends with the third */
    char *second = strchr(text, '\n'), *third = second != NULL ? strchr(second + 1, '\n') : NULL;
    char *end = third != NULL ? strchr(third + 1, '\n') : NULL;
    bool good = end != NULL && end[1] == '\0';
    if (good) {
        *second = *third = *end = '\0';
        good = sscanf(text, "1 %16" SCNx64 " %39s %lf %n", &key, word, &part->cpu, &at) == 3 && key == g->key;
    }
    if (good) {
        hold_word(b, BATCH_LIMIT, limit);
        part->hold = strcmp(word, "done") == 0 ? BATCH_DONE : strcmp(word, limit) == 0 ? BATCH_LIMIT : BATCH_AGAIN;
        snprintf(part->status, sizeof part->status, "%.31s", text + at);
        memmove(text, second + 1, (size_t)(end - second));
        part->result = text;
        part->times = text + (third - second);
        return true;
    }
    free(text);
    return false;
}


bool batch_part_done(const batch *b, const batch_line *g)
{
    const struct {
        bool asked;
        const char *ending;
    } file[] = {{b->png, ".png"}, {b->glb, ".glb"}, {b->obj, ".obj"}};
    char path[4096];
    batch_part part;
    if (!batch_part_read(b, g, &part)) return false;
    bool done = part.hold != BATCH_AGAIN;
    /* a garment that was refused has no files */
    const bool made = strstr(part.result, "\"state_hash\"") != NULL;
    free(part.result);
    for (size_t i = 0; i < sizeof file / sizeof *file && made; i++)
        if (file[i].asked && (!batch_path(b, g->name, file[i].ending, path) || access(path, R_OK) != 0)) done = false;
    return done;
}


/* ---- all of it ---- */

/* how many ended how, in the order in which the list has them first */
typedef struct tally {
    int32_t kinds, count[STATUSES_MOST], again, dressed;
    char status[STATUSES_MOST][32];
    double *cpu; /* of those that were dressed */
} tally;


static void tally_add(tally *t, const char *status)
{
    int32_t k = 0;
    while (k < t->kinds && strcmp(t->status[k], status) != 0) k++;
    if (k == STATUSES_MOST) return;
    if (k == t->kinds) snprintf(t->status[t->kinds++], sizeof *t->status, "%.31s", status);
    t->count[k]++;
}


static int rising(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}


static void tell(const batch *b, tally *t, int32_t kept)
{
    const int32_t n = t->dressed;
    printf("%d garment%s: ", (int)b->count, b->count == 1 ? "" : "s");
    for (int32_t k = 0; k < t->kinds; k++)
        printf("%s%d %s", k == 0 ? "" : ", ", (int)t->count[k], t->status[k]);
    if (kept > 0) printf("; %d from before", (int)kept);
    qsort(t->cpu, (size_t)n, sizeof *t->cpu, rising);
    if (n > 0)
        printf("; CPU seconds: median %.2f, p95 %.2f", 0.5 * (t->cpu[(n - 1) / 2] + t->cpu[n / 2]),
               t->cpu[(int32_t)ceil(0.95 * n) - 1]);
    printf("\n");
}


/* a line in each file for one garment; false when its part is not there */
static bool write_line(const batch *b, const batch_line *g, FILE *results, FILE *times, tally *t)
{
    batch_part part;
    if (g->fault[0] != '\0') {
        json j = {0};
        json_open(&j, NULL, '{');
        json_int(&j, "line", g->number);
        json_text(&j, "status", "bad input");
        json_text(&j, "reason", g->fault);
        json_close(&j, '}');
        const bool told = !j.failed;
        if (told) fprintf(results, "%s\n", j.text);
        json_free(&j);
        tally_add(t, "bad input");
        return told;
    }
    if (!batch_part_read(b, g, &part)) return false;
    fprintf(results, "{\"line\": %d, \"name\": \"%s\", %s\n", (int)g->number, g->name, part.result + 1);
    fprintf(times, "{\"line\": %d, \"name\": \"%s\", %s\n", (int)g->number, g->name, part.times + 1);
    tally_add(t, part.status);
    if (strcmp(part.status, "bad input") != 0) t->cpu[t->dressed++] = part.cpu;
    t->again += part.hold == BATCH_AGAIN;
    free(part.result);
    return true;
}


int batch_results(const batch *b, int32_t kept)
{
    whole results, times;
    tally t = {0};
    t.cpu = malloc(((size_t)b->count + 1) * sizeof *t.cpu);
    if (t.cpu == NULL) return complain(EXIT_FAILED, "dress", "no memory for the results");
    const bool first = whole_open(&results, b, "", "results.jsonl"), second = whole_open(&times, b, "", "times.jsonl");
    int code = first && second ? EXIT_DONE : cannot_write(first ? &times : &results);
    for (int32_t i = 0; i < b->count && code == EXIT_DONE; i++)
        if (!write_line(b, &b->line[i], results.file, times.file, &t))
            code = complain(EXIT_FAILED, "dress", "%s/parts/%s: cannot be read", b->folder, b->line[i].name);
    if (code == EXIT_DONE) {
        const bool timed = whole_close(&times, b, ""), told = whole_close(&results, b, "");
        if (!timed || !told) code = cannot_write(timed ? &results : &times);
    } else {
        whole_drop(&results);
        whole_drop(&times);
    }
    if (code == EXIT_DONE) tell(b, &t, kept);
    free(t.cpu);
    if (code == EXIT_DONE && t.again > 0)
        code = complain(EXIT_FAILED, "dress", "%d of %d garments were not finished: results.jsonl has the reasons",
                        (int)t.again, (int)b->count);
    return code;
}
