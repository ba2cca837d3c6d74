/* batch.h: many garments of a list, each dressed by a process of its own and kept as soon as it is finished. */
#ifndef MUSLIN_BATCH_H
#define MUSLIN_BATCH_H

#include <sys/types.h>

#include "dress.h"

#define BATCH_NAME 100 /* bytes of the name of a garment */

/* A garment of the list. */
typedef struct batch_line {
    int32_t number; /* of its line, from 1 */
    int32_t count;  /* of its words */
    char **word;    /* the options that its line names */
    char name[BATCH_NAME + 16]; /* of its files */
    char fault[700]; /* why the line cannot be read, "" when it can */
    uint64_t key;   /* of all that the result depends on: options, files, program */
    pid_t pid;      /* of its process, 0: none */
} batch_line;

typedef struct batch {
    const char *list, *folder;
    double jobs, limit; /* limit: CPU seconds of a garment, 0: none */
    bool png, glb, obj, quiet;
    dress all; /* what lines begin with */
    uint64_t program; /* its version and its bytes */
    int32_t count;
    batch_line *line;
    char *text, **words; /* what words lie in */
} batch;

/* muslin dress --batch. Returns an exit code. */
int batch_dress(int argc, char **argv);

/* ---- the list ---- */

/* Read the list: words, names and keys of its garments; a bad line has its fault. Returns an exit code. */
int batch_read(batch *b);
void batch_free(batch *b);

/* The options of a line on top of those that are given for all. Returns an exit code; `name` gets --name, or NULL. */
int batch_options(const batch *b, const batch_line *g, dress *d, const char **name);

/* FOLDER/NAME.ENDING; false when that is too long. */
bool batch_path(const batch *b, const char *name, const char *ending, char out[4096]);

/* ---- what is finished: DIR/parts/NAME, whole or not there ---- */

/* How long a part holds: for good; while the limit is the same; not at all. */
typedef enum batch_hold { BATCH_DONE, BATCH_LIMIT, BATCH_AGAIN } batch_hold;

typedef struct batch_part {
    batch_hold hold;
    double cpu;       /* seconds */
    char status[32];
    char *result, *times; /* JSON objects without a line end, in one block of malloc that `result` begins */
} batch_part;

/* Make the folders and take them for this process. Returns an exit code. */
int batch_open(batch *b);
/* Write the part; `result` and `times` are JSON objects on a line. Returns an exit code. */
int batch_part_write(const batch *b, const batch_line *g, const batch_part *part);
/* Read the part of this garment; false when there is none, or one of another garment. Free part->result. */
bool batch_part_read(const batch *b, const batch_line *g, batch_part *part);
/* Is the garment finished, with the files that are asked for? */
bool batch_part_done(const batch *b, const batch_line *g);
/* Write DIR/results.jsonl and DIR/times.jsonl from all parts, and tell the sum. Returns an exit code. */
int batch_results(const batch *b, int32_t kept);

#endif
