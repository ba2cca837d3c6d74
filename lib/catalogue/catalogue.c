/*
 * catalogue.c: open, fill and close a catalogue, a collection of patterns in one SQLite file.
 *
 * The files of this folder in the order of use: catalogue.c; traits.c (numbers that two patterns are compared by, and
 * their distance); search.c (the three searches); containment.c (is one pattern contained in another). The command
 * muslin and other programs call the room; nothing below it does.
 *
 * SQLite gives the guarantees: a transaction is on disk when commit returns (rollback journal, synchronous=FULL), and
 * the next program that opens the file undoes a transaction whose program died. SQLite allocates its own memory, not
 * from the context.
 */
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "catalogue/catalogue_internal.h"
#include "muslin/topology.h"

#define PATH_BYTES 200 /* [bytes] of a path in a message; chosen: leaves 311 of the context's 511 for the sentence */
/* [ms] longest wait while another program writes; chosen: far above one commit, short enough for a person to wait */
#define BUSY_WAIT 5000
#define NAME_BYTES 1024 /* [bytes] of a pattern's name with its zero byte; chosen */
#define FORM_BYTES 2048 /* [bytes] first capacity for a canonical form; chosen: most garments need one try */


mus_status mus__catalogue_fail(const mus_catalogue *catalogue, mus_status status, const char *format, ...)
{
    char text[512];
    int used = snprintf(text, sizeof text, "%.*s: ", PATH_BYTES, catalogue->path);
    va_list list;
    va_start(list, format);
    vsnprintf(text + used, sizeof text - (size_t)used, format, list);
    va_end(list);
    return mus_context_fail(catalogue->context, status, text);
}


mus_status mus__catalogue_trouble(const mus_catalogue *catalogue)
{
    int code = catalogue->db != NULL ? sqlite3_errcode(catalogue->db) : SQLITE_NOMEM;
    if (code == SQLITE_NOMEM) return mus__catalogue_fail(catalogue, MUS_ERR_MEMORY, "no memory for SQLite");
    mus_status status = code == SQLITE_NOTADB || code == SQLITE_CORRUPT ? MUS_ERR_FORMAT : MUS_ERR_FILE;
    return mus__catalogue_fail(catalogue, status, "%s", sqlite3_errmsg(catalogue->db));
}


mus_status mus__catalogue_reserve(mus_context *context, void *array, int64_t *room, int64_t need, size_t size)
{
    if (need <= *room) return MUS_OK;
    int64_t more = need > 2 * *room ? need : 2 * *room;
    void **slot = array, *bigger = mus_context_alloc(context, *slot, (size_t)more * size);
    if (bigger == NULL) return mus_context_fail(context, MUS_ERR_MEMORY, "no memory for the index of a catalogue");
    *slot = bigger;
    *room = more;
    return MUS_OK;
}


mus_status mus__catalogue_form(mus_context *context, const mus_pattern *pattern, uint8_t **form, size_t *n,
                               uint8_t *hash)
{
    uint64_t half[2];
    mus_status status = MUS_OK;
    *n = FORM_BYTES;
    *form = NULL;

    /* the first capacity holds the form of most garments; mus_pattern_form says what the second has to be */
    for (size_t room = 0; status == MUS_OK && room < *n;) {
        room = *n;
        uint8_t *bytes = mus_context_alloc(context, *form, room);
        if (bytes == NULL) {
            status = mus_context_fail(context, MUS_ERR_MEMORY, "no memory for the form of a pattern");
        } else {
            *form = bytes;
            status = mus_pattern_form(pattern, NULL, bytes, room, n, half);
        }
    }
    for (int32_t i = 0; i < 16 && status == MUS_OK; i++) hash[i] = (uint8_t)(half[i / 8] >> (56 - 8 * (i % 8)) & 255);
    return status;
}


/* run SQL that returns no rows */
static mus_status catalogue_do(const mus_catalogue *catalogue, const char *sql)
{
    return sqlite3_exec(catalogue->db, sql, NULL, NULL, NULL) == SQLITE_OK ? MUS_OK : mus__catalogue_trouble(catalogue);
}


/* run SQL and read the first number of its first row */
static mus_status catalogue_number(const mus_catalogue *catalogue, const char *sql, int64_t *out)
{
    sqlite3_stmt *statement = NULL;
    bool done = sqlite3_prepare_v2(catalogue->db, sql, -1, &statement, NULL) == SQLITE_OK &&
                sqlite3_step(statement) == SQLITE_ROW;
    if (done) *out = sqlite3_column_int64(statement, 0);
    mus_status status = done ? MUS_OK : mus__catalogue_trouble(catalogue);
    sqlite3_finalize(statement);
    return status;
}


/* check the file in one transaction: an empty file becomes a catalogue, any other must be one of this version */
static mus_status catalogue_begin_file(mus_catalogue *catalogue)
{
    int64_t id = 0, version = 0, tables = 0;
    mus_status status = catalogue_do(catalogue, catalogue->writable ? "BEGIN IMMEDIATE" : "BEGIN");
    if (status != MUS_OK) return status;
    status = catalogue_number(catalogue, "PRAGMA application_id", &id);
    if (status == MUS_OK) status = catalogue_number(catalogue, "PRAGMA user_version", &version);
    if (status == MUS_OK) status = catalogue_number(catalogue, "SELECT count(*) FROM sqlite_master", &tables);
    if (status == MUS_OK && id == 0 && tables == 0 && catalogue->writable)
        return catalogue_do(catalogue,
                            "CREATE TABLE form (id INTEGER PRIMARY KEY, hash BLOB NOT NULL, form BLOB NOT NULL);"
                            "CREATE INDEX form_hash ON form (hash);"
                            "CREATE TABLE pattern (id INTEGER PRIMARY KEY, name TEXT NOT NULL UNIQUE, form INTEGER NOT "
                            "NULL REFERENCES form (id), traits BLOB NOT NULL);"
                            "CREATE INDEX pattern_form ON pattern (form);"
                            "PRAGMA application_id = 1297437507; PRAGMA user_version = 1; COMMIT");
    if (status == MUS_OK && id != MUS__CATALOGUE_ID)
        status = mus__catalogue_fail(catalogue, MUS_ERR_FORMAT, "not a muslin catalogue");
    if (status == MUS_OK && version != MUS__CATALOGUE_VERSION)
        status = mus__catalogue_fail(catalogue, MUS_ERR_FORMAT,
                                     "version %lld, written by a newer muslin; this library reads version %d",
                                     (long long)version, MUS__CATALOGUE_VERSION);
    sqlite3_exec(catalogue->db, "ROLLBACK", NULL, NULL, NULL);
    return status;
}


mus_status mus_catalogue_open(mus_context *context, const char *path, int32_t mode, mus_catalogue **out)
{
    if (out != NULL) *out = NULL;
    if (context == NULL || path == NULL || out == NULL)
        return mus_context_fail(context, MUS_ERR_ARG, "mus_catalogue_open: context, path or out is NULL");
    if (mode != MUS_CATALOGUE_READ && mode != MUS_CATALOGUE_WRITE)
        return mus_context_fail(context, MUS_ERR_ARG, "mus_catalogue_open: the mode is neither READ nor WRITE");
    mus_catalogue *own = mus_context_alloc(context, NULL, sizeof *own);
    char *copy = own != NULL ? mus_context_alloc(context, NULL, strlen(path) + 1) : NULL;
    if (copy == NULL) {
        mus_context_alloc(context, own, 0);
        return mus_context_fail(context, MUS_ERR_MEMORY, "no memory for a catalogue");
    }
    own->context = context;
    own->path = memcpy(copy, path, strlen(path) + 1);
    own->writable = mode == MUS_CATALOGUE_WRITE;
    own->seen = -1;

    /* MUS_CATALOGUE_READ opens for writing too where the file permits it: SQLite undoes a dead program's transaction */
    int flags = SQLITE_OPEN_READWRITE | SQLITE_OPEN_NOMUTEX | (own->writable ? SQLITE_OPEN_CREATE : 0);
    mus_status status = MUS_OK;
    if (sqlite3_open_v2(path, &own->db, flags, NULL) != SQLITE_OK) status = mus__catalogue_trouble(own);
    if (status == MUS_OK) sqlite3_busy_timeout(own->db, BUSY_WAIT);
    if (status == MUS_OK) status = catalogue_do(own, "PRAGMA synchronous = FULL; PRAGMA cache_size = -65536");
    if (status == MUS_OK) status = catalogue_begin_file(own);
    if (status != MUS_OK) {
        mus_catalogue_destroy(own);
        return status;
    }
    *out = own;
    return MUS_OK;
}


void mus_catalogue_destroy(mus_catalogue *catalogue)
{
    if (catalogue == NULL) return;
    mus_context *context = catalogue->context;
    sqlite3_finalize(catalogue->add);
    sqlite3_finalize(catalogue->add_form);
    sqlite3_finalize(catalogue->find_form);
    sqlite3_close(catalogue->db);
    mus_context_alloc(context, catalogue->row, 0);
    mus_context_alloc(context, catalogue->pool, 0);
    mus_context_alloc(context, catalogue->name, 0);
    mus_context_alloc(context, catalogue->path, 0);
    mus_context_alloc(context, catalogue, 0);
}


/* prepare a statement on its first use; it is kept until the catalogue is closed */
static mus_status catalogue_statement(const mus_catalogue *catalogue, const char *sql, sqlite3_stmt **statement)
{
    if (*statement != NULL ||
        sqlite3_prepare_v3(catalogue->db, sql, -1, SQLITE_PREPARE_PERSISTENT, statement, NULL) == SQLITE_OK)
        return MUS_OK;
    return mus__catalogue_trouble(catalogue);
}


mus_status mus__catalogue_find_form(mus_catalogue *catalogue, const uint8_t *form, size_t n, const uint8_t *hash,
                                    int64_t *out)
{
    *out = 0;
    mus_status status =
        catalogue_statement(catalogue, "SELECT id, form FROM form WHERE hash = ?1", &catalogue->find_form);
    if (status != MUS_OK) return status;
    sqlite3_stmt *find = catalogue->find_form;
    sqlite3_bind_blob(find, 1, hash, 16, SQLITE_STATIC);
    int code;
    while ((code = sqlite3_step(find)) == SQLITE_ROW && *out == 0) {
        const uint8_t *other = sqlite3_column_blob(find, 1);
        if ((size_t)sqlite3_column_bytes(find, 1) == n && memcmp(other, form, n) == 0)
            *out = sqlite3_column_int64(find, 0);
    }
    if (code != SQLITE_DONE && code != SQLITE_ROW) status = mus__catalogue_trouble(catalogue);
    sqlite3_reset(find);
    sqlite3_clear_bindings(find);
    return status;
}


/* number of a form in the file; a form that is not there yet is added */
static mus_status catalogue_keep_form(mus_catalogue *catalogue, const uint8_t *form, size_t n, const uint8_t *hash,
                                      int64_t *out)
{
    mus_status status = mus__catalogue_find_form(catalogue, form, n, hash, out);
    if (status == MUS_OK && *out == 0)
        status = catalogue_statement(catalogue, "INSERT INTO form (hash, form) VALUES (?1, ?2)", &catalogue->add_form);
    if (status != MUS_OK || *out != 0) return status;
    sqlite3_stmt *add = catalogue->add_form;
    sqlite3_bind_blob(add, 1, hash, 16, SQLITE_STATIC);
    sqlite3_bind_blob(add, 2, form, (int)n, SQLITE_STATIC);
    if (sqlite3_step(add) != SQLITE_DONE) status = mus__catalogue_trouble(catalogue);
    if (status == MUS_OK) *out = sqlite3_last_insert_rowid(catalogue->db);
    sqlite3_reset(add);
    sqlite3_clear_bindings(add);
    return status;
}


static mus_status catalogue_put(mus_catalogue *catalogue, const char *name, int64_t form, const uint8_t *traits,
                                int32_t ntrait, int32_t *out)
{
    static const char sql[] = "INSERT INTO pattern (name, form, traits) VALUES (?1, ?2, ?3) ON CONFLICT (name) DO "
                              "UPDATE SET form = ?2, traits = ?3 RETURNING id";
    mus_status status = catalogue_statement(catalogue, sql, &catalogue->add);
    if (status != MUS_OK) return status;
    sqlite3_stmt *add = catalogue->add;
    sqlite3_bind_text(add, 1, name, -1, SQLITE_STATIC);
    sqlite3_bind_int64(add, 2, form);
    sqlite3_bind_blob(add, 3, traits, 8 * ntrait, SQLITE_STATIC);
    bool there = sqlite3_step(add) == SQLITE_ROW;
    if (there) *out = sqlite3_column_int(add, 0);
    if (!there || sqlite3_step(add) != SQLITE_DONE) status = mus__catalogue_trouble(catalogue);
    sqlite3_reset(add);
    sqlite3_clear_bindings(add);
    return status;
}


/* write form and pattern in one transaction, nested in the caller's when one is begun */
static mus_status catalogue_keep(mus_catalogue *catalogue, const char *name, const uint8_t *form, size_t n,
                                 const uint8_t *hash, const uint8_t *traits, int32_t ntrait, int32_t *out)
{
    int64_t number;
    mus_status status = catalogue_do(catalogue, catalogue->begun ? "SAVEPOINT one" : "BEGIN IMMEDIATE");
    if (status != MUS_OK) return status;
    status = catalogue_keep_form(catalogue, form, n, hash, &number);
    if (status == MUS_OK) status = catalogue_put(catalogue, name, number, traits, ntrait, out);
    if (status == MUS_OK) status = catalogue_do(catalogue, catalogue->begun ? "RELEASE one" : "COMMIT");
    if (status != MUS_OK)
        sqlite3_exec(catalogue->db, catalogue->begun ? "ROLLBACK TO one; RELEASE one" : "ROLLBACK", NULL, NULL, NULL);
    return status;
}


mus_status mus_catalogue_add(mus_catalogue *catalogue, const mus_pattern *pattern, const char *name, int32_t *out)
{
    if (out != NULL) *out = MUS_NONE;
    if (catalogue == NULL) return MUS_ERR_ARG;
    mus_context *context = catalogue->context;
    if (pattern == NULL || name == NULL || name[0] == '\0' || strlen(name) >= NAME_BYTES)
        return mus__catalogue_fail(catalogue, MUS_ERR_ARG, "pattern is NULL, or the name is empty or above %d bytes",
                                   NAME_BYTES - 1);
    if (!catalogue->writable) return mus__catalogue_fail(catalogue, MUS_ERR_STATE, "open for reading");

    uint8_t *form = NULL, hash[16], *bytes = NULL;
    double *traits = NULL;
    int32_t n = 0, id = MUS_NONE;
    size_t size = 0;
    mus_status status = mus__catalogue_form(context, pattern, &form, &size, hash);
    if (status == MUS_OK) status = mus__traits_of(pattern, &traits, &n);
    if (status == MUS_OK && (size > INT32_MAX || n > INT32_MAX / 8))
        status = mus__catalogue_fail(catalogue, MUS_ERR_LIMIT, "the canonical form of %s is above 2^31 bytes", name);
    if (status == MUS_OK) {
        bytes = mus_context_alloc(context, NULL, 8 * (size_t)n);
        if (bytes == NULL) status = mus_context_fail(context, MUS_ERR_MEMORY, "no memory for the traits of a pattern");
    }
    if (status == MUS_OK) {
        mus__traits_pack(traits, n, bytes);
        status = catalogue_keep(catalogue, name, form, size, hash, bytes, n, &id);
    }
    if (status == MUS_OK) {
        catalogue->edits++;
        if (out != NULL) *out = id;
    }
    mus_context_alloc(context, form, 0);
    mus_context_alloc(context, traits, 0);
    mus_context_alloc(context, bytes, 0);
    return status;
}


mus_status mus_catalogue_begin(mus_catalogue *catalogue)
{
    if (catalogue == NULL) return MUS_ERR_ARG;
    if (!catalogue->writable || catalogue->begun)
        return mus__catalogue_fail(catalogue, MUS_ERR_STATE, "%s",
                                   catalogue->begun ? "a transaction is begun already" : "open for reading");
    mus_status status = catalogue_do(catalogue, "BEGIN IMMEDIATE");
    catalogue->begun = status == MUS_OK;
    return status;
}


/* end the transaction by `sql`; after a failed commit it is still open, to be committed again or rolled back */
static mus_status catalogue_end(mus_catalogue *catalogue, const char *sql)
{
    if (catalogue == NULL) return MUS_ERR_ARG;
    if (!catalogue->begun) return mus__catalogue_fail(catalogue, MUS_ERR_STATE, "no transaction is begun");
    mus_status status = catalogue_do(catalogue, sql);
    if (status == MUS_OK) catalogue->begun = false;
    catalogue->edits++;
    return status;
}


mus_status mus_catalogue_commit(mus_catalogue *catalogue)
{
    return catalogue_end(catalogue, "COMMIT");
}


mus_status mus_catalogue_rollback(mus_catalogue *catalogue)
{
    return catalogue_end(catalogue, "ROLLBACK");
}


int32_t mus_catalogue_count(const mus_catalogue *catalogue)
{
    int64_t count;
    if (catalogue == NULL) return 0;
    if (catalogue_number(catalogue, "SELECT count(*) FROM pattern", &count) != MUS_OK) return MUS_NONE;
    return (int32_t)count;
}


mus_status mus_catalogue_name(mus_catalogue *catalogue, int32_t id, const char **name)
{
    if (name != NULL) *name = NULL;
    if (catalogue == NULL) return MUS_ERR_ARG;
    if (name == NULL) return mus__catalogue_fail(catalogue, MUS_ERR_ARG, "name is NULL");
    sqlite3_stmt *statement = NULL;
    mus_status status = MUS_OK;
    int code = sqlite3_prepare_v2(catalogue->db, "SELECT name FROM pattern WHERE id = ?1", -1, &statement, NULL);
    if (code == SQLITE_OK) sqlite3_bind_int(statement, 1, id);
    if (code == SQLITE_OK) code = sqlite3_step(statement);
    if (code == SQLITE_ROW) {
        const char *text = (const char *)sqlite3_column_text(statement, 0);
        size_t bytes = text != NULL ? strlen(text) + 1 : 1;
        char *copy = mus_context_alloc(catalogue->context, catalogue->name, bytes);
        if (copy != NULL) {
            catalogue->name = copy;
            memcpy(copy, text != NULL ? text : "", bytes);
            *name = copy;
        } else {
            status = mus__catalogue_fail(catalogue, MUS_ERR_MEMORY, "no memory for a name");
        }
    } else if (code == SQLITE_DONE) {
        status = mus__catalogue_fail(catalogue, MUS_ERR_ARG, "pattern %d is unknown", (int)id);
    } else {
        status = mus__catalogue_trouble(catalogue);
    }
    sqlite3_finalize(statement);
    return status;
}
