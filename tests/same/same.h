/*
 * same.h: rows and digests of `make same`, the net that shows whether a change of the code moved a result.
 *
 * A row is a name and a digest of 64 bits. The digest takes in the results of some calls of the public headers: node
 * positions, counters, bytes of files, status numbers. Sentences and measured times are never taken in. Each row is
 * made in a process of its own (main.c), whose working folder is an empty one and which ends with the row: a row frees
 * only large objects that it makes in a loop, and a row that crashes is one row.
 *
 * Files: kit.c digests; main.c runs the rows; table.c compares them with the committed tables; scene.c dresses a body;
 * all other files list the rows of a group and make them.
 */
#ifndef MUS_TESTS_SAME_SAME_H
#define MUS_TESTS_SAME_SAME_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "muslin/catalogue.h"
#include "muslin/exchange.h"
#include "muslin/muslin.h"
#include "muslin/print.h"

/* ---- one row, while it is made ---- */

typedef struct same_run {
    mus_context *context;
    const char *root;    /* folder of the repository, an absolute path */
    const char *data;    /* folder of the real data, an absolute path; NULL without one */
    const char *figures; /* the program that tests/study/ports/figures.c makes */
    uint64_t digest;
} same_run;

/* add a result to the digest: bytes, an integer, a number, a text without its end (NULL: a mark of its own) */
void same_bytes(same_run *run, const void *bytes, size_t count);
void same_int(same_run *run, int64_t value);
void same_real(same_run *run, double value);
void same_text(same_run *run, const char *text);

/* add arrays; every NaN counts as the same number, since compilers differ in its sign */
void same_ints(same_run *run, const int32_t *values, int64_t count);
void same_reals(same_run *run, const double *values, int64_t count);

/* add the bytes of a file; the row fails when there is none */
void same_file(same_run *run, const char *path);

/* add a pattern as the bytes of its JSON file */
void same_pattern(same_run *run, const mus_pattern *pattern);

/* add the number of a status. Returns whether it is MUS_OK */
bool same_status(same_run *run, mus_status status);

/* end the row as failed unless the status is MUS_OK: `what` and the sentence of the context go to standard error */
void same_must(const same_run *run, mus_status status, const char *what);

/* the path of a file in the folder of the real data, or of the repository; the text lasts for the row */
const char *same_data(const same_run *run, const char *file);
const char *same_source(const same_run *run, const char *file);

/* a completed tape: of a table size ("W40") or of a file of the real data; of a file not completed with `raw` */
mus_tape *same_size(const same_run *run, const char *size);
mus_tape *same_tape(const same_run *run, const char *file, const char *row, bool raw);
mus_body *same_body(const same_run *run, const mus_tape *tape);

/* a named design, or words of one, drafted for a tape */
mus_pattern *same_draft(const same_run *run, const char *design, const mus_tape *tape);

/* ---- the list of rows ---- */

typedef struct same_row {
    char name[96]; /* GROUP/WHAT, no blanks */
    void (*make)(same_run *run, const void *what, int32_t index);
    const void *what;
    int32_t index;
    bool data;     /* needs the folder of the real data */
    double seconds; /* of CPU that it took */
    char found[24]; /* the digest, or what became of the row; "" while it was not made */
    char kept[24];  /* what the table has for it, "" for a row that it has not */
} same_row;

typedef struct same_list {
    same_row *row;
    int32_t count, room;
} same_list;

/* a new row at the end of the list, with this name and function; the rest is 0 */
same_row *same_add(same_list *list, void (*make)(same_run *run, const void *what, int32_t index), const char *format,
                   ...) __attribute__((format(printf, 3, 4)));

/* the groups: each adds its rows to the list */
void same_scenes(same_list *list);
void same_steps(same_list *list);
void same_moved(same_list *list);
void same_nets(same_list *list);
void same_drafts(same_list *list);
void same_sheets(same_list *list);
void same_readings(same_list *list);
void same_meshes(same_list *list);
void same_bodies(same_list *list);
void same_sewn(same_list *list);
void same_cuts(same_list *list);

/* ---- the tables ---- */

/* the first line of a table: what its digests depend on beside the code */
void same_machine(char *text, size_t size);

/* read a table into `kept` of its rows. A row of the table that the list has not is added, without a function. Returns
 * 0, or 1 when the table is of another machine, or 2 without a table */
int same_read(same_list *list, const char *path, const char *machine);

/* write the rows whose name begins with `group`, or with none of `but` when `group` is NULL, sorted by name. Returns
 * whether the file is written */
bool same_write(const same_list *list, const char *path, const char *machine, const char *group, const char *but);

#endif
