/*
 * catalogue_internal.h: an open catalogue, what it keeps of a pattern, and what the files of this folder share.
 *
 * The file: application_id "MUSC", user_version 1, and two tables; a form is kept once for all patterns that
 * have it, and stays when the last of them gets another
 *
 *     form (id INTEGER PRIMARY KEY, hash BLOB (16), form BLOB)                                      index on hash
 *     pattern (id INTEGER PRIMARY KEY, name TEXT UNIQUE, form INTEGER of form.id, traits BLOB)      index on form
 *
 * traits are numbers of 8 bytes, most significant first (IEEE 754), so a file is the same on every machine: the head
 * below, openings' lengths ascending [m], then area [m2], perimeter [m] and edges of each panel, ascending by area.
 */
#ifndef MUS_CATALOGUE_INTERNAL_H
#define MUS_CATALOGUE_INTERNAL_H

#include <sqlite3.h>
#include <stdbool.h>

#include "muslin/catalogue.h"

#define MUS__CATALOGUE_VERSION 1
#define MUS__CATALOGUE_ID 0x4d555343 /* "MUSC" */

/* head of the traits */
enum {
    MUS__TRAIT_PANELS,
    MUS__TRAIT_SEAMS,
    MUS__TRAIT_PIECES,
    MUS__TRAIT_EULER,
    MUS__TRAIT_OPENINGS,
    MUS__TRAIT_CLOTH, /* area of all panels [m2] */
    MUS__TRAIT_SEWN,  /* length of all seams [m] */
    MUS__TRAIT_HEAD
};

/* a row of the index in memory */
typedef struct mus__row {
    int64_t form; /* number of its form in the file */
    int32_t id, n;
    int64_t first; /* of its n traits in the pool */
} mus__row;

struct mus_catalogue {
    mus_context *context;
    sqlite3 *db;
    sqlite3_stmt *add, *add_form, *find_form;
    bool writable, begun;
    char *path, *name;

    /* index: all rows as they were at data version `seen` after `edits` changes of our own */
    mus__row *row;
    double *pool;
    int32_t nrow, row_room;
    int64_t npool, pool_room;
    int64_t seen, edits, seen_edits;
};

/* ---- catalogue.c ---- */

/* context's text with the path before it */
mus_status mus__catalogue_fail(const mus_catalogue *catalogue, mus_status status, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
/* what SQLite said last */
mus_status mus__catalogue_trouble(const mus_catalogue *catalogue);
/* the form of a pattern: a block to free with mus_context_alloc; hash (16). */
mus_status mus__catalogue_form(mus_context *context, const mus_pattern *pattern, uint8_t **form, size_t *n,
                               uint8_t *hash);
/* number of a form in the file, 0 when it has none such */
mus_status mus__catalogue_find_form(mus_catalogue *catalogue, const uint8_t *form, size_t n, const uint8_t *hash,
                                    int64_t *out);
/* grow *array of `size` byte elements to hold `need` */
mus_status mus__catalogue_reserve(mus_context *context, void *array, int64_t *room, int64_t need, size_t size);

/* ---- traits.c ---- */

/* traits of a pattern: a block to free with mus_context_alloc */
mus_status mus__traits_of(const mus_pattern *pattern, double **out, int32_t *n);
/* to bytes (8 n) and back */
void mus__traits_pack(const double *traits, int32_t n, uint8_t *bytes);
/* false when the bytes are no traits */
bool mus__traits_unpack(const uint8_t *bytes, size_t size, double *traits);
/* parts of the distance; stops once their sum is beyond `limit` and returns a number beyond it */
double mus__traits_distance(const double *a, const double *b, double limit, double *parts);

/* ---- part.c ---- */

/* does the form contain the part's form, either way round? A form that cannot be read contains nothing */
mus_status mus__part_inside(mus_context *context, const uint8_t *part, size_t part_size, const uint8_t *whole,
                            size_t whole_size, bool *inside);

#endif
