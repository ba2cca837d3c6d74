/* batch.h: many garments of a list, each dressed by a process of its own and kept as soon as it is finished. */
#ifndef MUSLIN_BATCH_H
#define MUSLIN_BATCH_H

#include <sys/types.h>

#include "dress.h"

#define BATCH_NAME 100 /* bytes of the name of a garment */

/* A garment of the list. */
typedef struct batch_line {
    int32_t number; /* number of its line in the list, from 1 */
    int32_t count;  /* number of words */
    char **word;    /* (count) words of the line: options and values */
    char name[BATCH_NAME + 16]; /* name of the garment's files */
    char fault[700]; /* why the line cannot be read; "" when it can */
    uint64_t key;   /* hash of all inputs of the result: options, files, program */
    pid_t pid;      /* its process; 0: none */
} batch_line;

typedef struct batch {
    const char *list, *folder, *part; /* part: "I/N", or NULL */
    double jobs, limit; /* processes at a time; CPU seconds for a garment, 0: no limit */
    bool png, glb, obj, quiet;
    dress all; /* options given beside --batch, which hold for every line */
    uint64_t program; /* hash of the program's version and bytes; 0: not known yet */
    int32_t count;
    batch_line *line;
    char *text, **words; /* text of the list; words of all lines */
} batch;

/* muslin dress --batch. Returns an exit code. */
int batch_dress(int argc, char **argv);

/* ---- the list ---- */

/* Reads the list, or each N-th garment from the I-th on of part "I/N": words, names and keys; a line that cannot be
 * read gets a fault. Returns an exit code. */
int batch_read(batch *b);
void batch_free(batch *b);

/* Reads the options of a line over those given for all lines. Returns an exit code; `name` gets --name, or NULL. */
int batch_options(const batch *b, const batch_line *g, dress *d, const char **name);

/* Writes FOLDER/NAME.ENDING to `out`; returns false when it is too long. */
bool batch_path(const batch *b, const char *name, const char *ending, char out[4096]);

/* ---- finished garments: DIR/parts/NAME ---- */

/* How long a part is valid: always; as long as the time limit is the same; until the next run. */
typedef enum batch_hold { BATCH_DONE, BATCH_LIMIT, BATCH_AGAIN } batch_hold;

typedef struct batch_part {
    batch_hold hold;
    double cpu;       /* seconds */
    char status[32];
    char *result, *times; /* JSON objects without a line end, in one block of malloc() that starts at `result` */
} batch_part;

/* Makes the folders and locks them for this process. Returns an exit code. */
int batch_open(batch *b);
/* Writes a part; `result` and `times` are JSON objects on one line each. Returns an exit code. */
int batch_part_write(const batch *b, const batch_line *g, const batch_part *part);
/* Reads the part of this garment; returns false when there is none with its key. The caller frees part->result. */
bool batch_part_read(const batch *b, const batch_line *g, batch_part *part);
/* Whether the garment is finished and all files asked for exist. */
bool batch_part_done(const batch *b, const batch_line *g);
/* Writes DIR/results.jsonl and DIR/times.jsonl from all parts, and prints the totals. Returns an exit code. */
int batch_results(const batch *b, int32_t kept);

#endif
