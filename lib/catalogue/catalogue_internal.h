/*
 * catalogue_internal.h: an open catalogue, the traits of a pattern, and the functions that the files of this folder
 * share.
 *
 * The file has application_id "MUSC", user_version 1, and two tables. A canonical form is stored once for all patterns
 * that have it, and stays in the file when the last of them gets another form.
 *
 *     form (id INTEGER PRIMARY KEY, hash BLOB (16), form BLOB)                                      index on hash
 *     pattern (id INTEGER PRIMARY KEY, name TEXT UNIQUE, form INTEGER of form.id, traits BLOB)      index on form
 *
 * Traits are IEEE 754 numbers of 8 bytes, most significant byte first, so that a file is the same on every machine: the
 * head below; the lengths of the openings, ascending [m]; then area [m2], perimeter [m] and number of edges of each
 * panel, ascending by area.
 */
#ifndef MUS_CATALOGUE_INTERNAL_H
#define MUS_CATALOGUE_INTERNAL_H

#include <sqlite3.h>
#include <stdbool.h>

#include "muslin/catalogue.h"

#define MUS__CATALOGUE_VERSION 1     /* user_version of the files that are written, and the highest that is read */
#define MUS__CATALOGUE_ID 0x4d555343 /* application_id: "MUSC" */

/* head of the traits: index of each number */
enum {
    MUS__TRAIT_PANELS,   /* number of panels */
    MUS__TRAIT_SEAMS,    /* number of seams */
    MUS__TRAIT_PIECES,   /* number of components */
    MUS__TRAIT_EULER,    /* Euler characteristic of the sewn surface */
    MUS__TRAIT_OPENINGS, /* number of openings */
    MUS__TRAIT_CLOTH,    /* area of all panels [m2] */
    MUS__TRAIT_SEWN,     /* length of all seams [m] */
    MUS__TRAIT_HEAD      /* length of the head */
};

/* a pattern in the index in memory: its number, and its n traits */
typedef struct mus__row {
    int64_t form; /* number of its canonical form in the file */
    int32_t id, n;
    int64_t first; /* first of its traits in the pool */
} mus__row;

struct mus_catalogue {
    mus_context *context;
    sqlite3 *db;
    sqlite3_stmt *add, *add_form, *find_form;
    bool writable, begun;
    char *path, *name;
    int64_t file_bytes, operations, operations_most; /* the file's size; operations of the statement that runs */

    /* index: a row for each pattern, as of SQLite's data version `seen` and the own change number `seen_edits` */
    mus__row *row;
    double *pool;
    int32_t nrow, row_room;
    int64_t npool, pool_room;
    int64_t seen, edits, seen_edits;
};

/* ---- catalogue.c ---- */

/* make "path: sentence" the context's error text; returns `status` */
mus_status mus__catalogue_fail(const mus_catalogue *catalogue, mus_status status, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
/* make SQLite's last error the context's error text; returns the status that fits it */
mus_status mus__catalogue_trouble(const mus_catalogue *catalogue);
/* count the operations of the next statement from zero, and set their bound by the size of the file */
void mus__catalogue_allow(mus_catalogue *catalogue);
/* prepare a statement, unless *statement is one already, and allow it its operations */
mus_status mus__catalogue_prepare(mus_catalogue *catalogue, const char *sql, unsigned flags, sqlite3_stmt **statement);
/* canonical form of a pattern (n bytes; free it with mus_context_alloc) and its hash (16) */
mus_status mus__catalogue_form(mus_context *context, const mus_pattern *pattern, uint8_t **form, size_t *n,
                               uint8_t *hash);
/* number of a canonical form in the file; 0 when the file does not have it */
mus_status mus__catalogue_find_form(mus_catalogue *catalogue, const uint8_t *form, size_t n, const uint8_t *hash,
                                    int64_t *out);
/* grow *array, elements of `size` bytes with capacity *room, to hold `need` elements */
mus_status mus__catalogue_reserve(mus_context *context, void *array, int64_t *room, int64_t need, size_t size);

/* ---- traits.c ---- */

/* traits of a pattern: n numbers; free them with mus_context_alloc */
mus_status mus__traits_of(const mus_pattern *pattern, double **out, int32_t *n);
/* write n traits as 8 n bytes */
void mus__traits_pack(const double *traits, int32_t n, uint8_t *bytes);
/* read traits from bytes; false when the bytes are not valid traits */
bool mus__traits_unpack(const uint8_t *bytes, size_t size, double *traits);
/* distance of two patterns by their traits, and its parts; a distance above `limit` may be any number above it */
double mus__traits_distance(const double *a, const double *b, double limit, double *parts);

/* ---- containment.c ---- */

/* does a canonical form contain that of a part, also mirrored? A form that cannot be read contains nothing */
mus_status mus__part_inside(mus_context *context, const uint8_t *part, size_t part_size, const uint8_t *whole,
                            size_t whole_size, bool *inside);

#endif
