/*
 * catalogue.c: open, fill and close a catalogue, a collection of patterns in one SQLite file.
 *
 * The files of this folder in the order of use: catalogue.c; traits.c (numbers that two patterns are compared by, and
 * their distance); search.c (the three searches); containment.c (is one pattern contained in another). The command
 * muslin and other programs call the room; nothing below it does.
 *
 * A file may come from anybody: it must have the schema below to the letter, its views and triggers are never run, and
 * a statement stops after as many operations as a file of its size can need (SQLite, Defense Against The Dark Arts,
 * 2023).
 *
 * SQLite gives the guarantees: a transaction is on disk when commit returns (rollback journal, synchronous=FULL), and
 * the next program that opens the file undoes a transaction whose program died. SQLite allocates its own memory, not
 * from the context.
 */
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "base/utf8.h"
#include "catalogue/catalogue_internal.h"
#include "muslin/topology.h"

#define PATH_BYTES 200 /* [bytes] of a path in a message; chosen: leaves 311 of the context's 511 for the sentence */
/* [ms] longest wait while another program writes; chosen: far above one commit, short enough for a person to wait */
#define BUSY_WAIT 5000
#define NAME_BYTES 1024 /* [bytes] of a pattern's name with its zero byte; chosen */
#define BLOB_BYTES (256 << 20) /* [bytes] longest form, traits or name; chosen: the bound of a pattern file */
#define SQL_BYTES 4096         /* [bytes] longest statement, also of the file's schema; chosen: ours have at most 500 */
/* operations of SQLite's machine: a statement may take LEAST, and one for each byte of the file, and EACH for each own
 * edit. A row of a pattern has at least 70 bytes and takes at most 12 operations; only a damaged file needs more */
#define OPERATIONS_LEAST 1000000
#define OPERATIONS_EACH 64
#define OPERATIONS_PERIOD 1000 /* operations from one count to the next */
#define FORM_BYTES 2048 /* [bytes] first capacity for a canonical form; chosen: most garments need one try */

/* the whole schema; SQLite keeps each statement as it was written, and they are here in the order of their names */
static const char catalogue_schema[] =
    "CREATE TABLE form (id INTEGER PRIMARY KEY, hash BLOB NOT NULL, form BLOB NOT NULL);"
    "CREATE INDEX form_hash ON form (hash);"
    "CREATE TABLE pattern (id INTEGER PRIMARY KEY, name TEXT NOT NULL UNIQUE, form INTEGER NOT NULL REFERENCES form "
    "(id), traits BLOB NOT NULL);"
    "CREATE INDEX pattern_form ON pattern (form);";


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
    if (code == SQLITE_INTERRUPT)
        return mus__catalogue_fail(catalogue, MUS_ERR_FORMAT, "more than %lld operations for %lld bytes: damaged",
                                   (long long)catalogue->operations_most, (long long)catalogue->file_bytes);
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


void mus__catalogue_allow(mus_catalogue *catalogue)
{
    sqlite3_file *file = NULL;
    sqlite3_int64 bytes = 0;
    if (sqlite3_file_control(catalogue->db, NULL, SQLITE_FCNTL_FILE_POINTER, &file) != SQLITE_OK || file == NULL ||
        file->pMethods == NULL || file->pMethods->xFileSize(file, &bytes) != SQLITE_OK)
        bytes = 0;
    catalogue->file_bytes = bytes;
    catalogue->operations = 0;
    catalogue->operations_most = OPERATIONS_LEAST + bytes + OPERATIONS_EACH * catalogue->edits;
}


/* SQLite calls it once a period; nonzero ends the statement with SQLITE_INTERRUPT */
static int catalogue_count_operations(void *user)
{
    mus_catalogue *catalogue = user;
    catalogue->operations += OPERATIONS_PERIOD;
    return catalogue->operations > catalogue->operations_most;
}


mus_status mus__catalogue_prepare(mus_catalogue *catalogue, const char *sql, unsigned flags, sqlite3_stmt **statement)
{
    mus__catalogue_allow(catalogue);
    if (*statement != NULL || sqlite3_prepare_v3(catalogue->db, sql, -1, flags, statement, NULL) == SQLITE_OK)
        return MUS_OK;
    return mus__catalogue_trouble(catalogue);
}


/* run SQL that returns no rows */
static mus_status catalogue_do(mus_catalogue *catalogue, const char *sql)
{
    mus__catalogue_allow(catalogue);
    return sqlite3_exec(catalogue->db, sql, NULL, NULL, NULL) == SQLITE_OK ? MUS_OK : mus__catalogue_trouble(catalogue);
}


/* run SQL and read the first number of its first row */
static mus_status catalogue_number(mus_catalogue *catalogue, const char *sql, int64_t *out)
{
    sqlite3_stmt *statement = NULL;
    mus_status status = mus__catalogue_prepare(catalogue, sql, 0, &statement);
    if (status == MUS_OK && sqlite3_step(statement) != SQLITE_ROW) status = mus__catalogue_trouble(catalogue);
    if (status == MUS_OK) *out = sqlite3_column_int64(statement, 0);
    sqlite3_finalize(statement);
    return status;
}


/* does the file have the schema of a catalogue and nothing else? What ANALYZE keeps (sqlite_stat1) is let be */
static mus_status catalogue_check_schema(mus_catalogue *catalogue)
{
    static const char sql[] = "SELECT group_concat(sql, ';') || ';' FROM (SELECT sql FROM sqlite_master WHERE sql IS "
                              "NOT NULL AND name NOT GLOB 'sqlite_stat*' ORDER BY name)";
    sqlite3_stmt *statement = NULL;
    mus_status status = mus__catalogue_prepare(catalogue, sql, 0, &statement);
    if (status == MUS_OK && sqlite3_step(statement) != SQLITE_ROW) status = mus__catalogue_trouble(catalogue);
    if (status == MUS_OK) {
        const char *schema = (const char *)sqlite3_column_text(statement, 0);
        if (schema == NULL || strcmp(schema, catalogue_schema) != 0)
            status = mus__catalogue_fail(catalogue, MUS_ERR_FORMAT, "the tables are not those of a catalogue");
    }
    sqlite3_finalize(statement);
    return status;
}


/* refuse what a hostile file could do: change its own schema, run views and triggers, hold values without a bound */
static mus_status catalogue_guard(mus_catalogue *catalogue)
{
    static const int option[][2] = {{SQLITE_DBCONFIG_DEFENSIVE, 1},
                                    {SQLITE_DBCONFIG_ENABLE_TRIGGER, 0},
#if defined(SQLITE_DBCONFIG_ENABLE_VIEW)
                                    {SQLITE_DBCONFIG_ENABLE_VIEW, 0},
#endif
#if defined(SQLITE_DBCONFIG_TRUSTED_SCHEMA)
                                    {SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0},
#endif
    };
    for (size_t i = 0; i < sizeof option / sizeof *option; i++)
        if (sqlite3_db_config(catalogue->db, option[i][0], option[i][1], (int *)NULL) != SQLITE_OK)
            return mus__catalogue_trouble(catalogue);
    sqlite3_limit(catalogue->db, SQLITE_LIMIT_LENGTH, BLOB_BYTES);
    sqlite3_limit(catalogue->db, SQLITE_LIMIT_SQL_LENGTH, SQL_BYTES);
    sqlite3_limit(catalogue->db, SQLITE_LIMIT_ATTACHED, 0);
    sqlite3_progress_handler(catalogue->db, OPERATIONS_PERIOD, catalogue_count_operations, catalogue);
    sqlite3_busy_timeout(catalogue->db, BUSY_WAIT);
    return catalogue_do(catalogue, "PRAGMA cell_size_check = ON; PRAGMA mmap_size = 0; PRAGMA synchronous = FULL; "
                                   "PRAGMA cache_size = -65536");
}


/* check the file in one transaction: an empty file becomes a catalogue, any other must be one of this version */
static mus_status catalogue_begin_file(mus_catalogue *catalogue)
{
    int64_t id = 0, version = 0, tables = 0;
    mus_status status = catalogue_do(catalogue, catalogue->writable ? "BEGIN IMMEDIATE" : "BEGIN");
    if (status != MUS_OK) return status;
    status = catalogue_number(catalogue, "PRAGMA application_id", &id);
    if (status == MUS_OK) status = catalogue_number(catalogue, "PRAGMA user_version", &version);
    if (status == MUS_OK) status = catalogue_number(catalogue, "SELECT sum(1) FROM sqlite_master", &tables);
    if (status == MUS_OK && id == 0 && tables == 0 && catalogue->writable) {
        status = catalogue_do(catalogue, catalogue_schema);
        if (status != MUS_OK) return status;
        return catalogue_do(catalogue, "PRAGMA application_id = 1297437507; PRAGMA user_version = 1; COMMIT");
    }
    if (status == MUS_OK && id == 0 && tables == 0) /* as a first addition leaves it that was stopped before its end */
        status = mus__catalogue_fail(catalogue, MUS_ERR_FORMAT, "an empty file: no pattern was added to it");
    if (status == MUS_OK && id != MUS__CATALOGUE_ID)
        status = mus__catalogue_fail(catalogue, MUS_ERR_FORMAT, "not a muslin catalogue");
    if (status == MUS_OK && version != MUS__CATALOGUE_VERSION)
        status = mus__catalogue_fail(catalogue, MUS_ERR_FORMAT,
                                     "version %lld, written by a newer muslin; this library reads version %d",
                                     (long long)version, MUS__CATALOGUE_VERSION);
    if (status == MUS_OK) status = catalogue_check_schema(catalogue);
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
    if (status == MUS_OK) status = catalogue_guard(own);
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


mus_status mus__catalogue_find_form(mus_catalogue *catalogue, const uint8_t *form, size_t n, const uint8_t *hash,
                                    int64_t *out)
{
    *out = 0;
    mus_status status = mus__catalogue_prepare(catalogue, "SELECT id, form FROM form WHERE hash = ?1",
                                               SQLITE_PREPARE_PERSISTENT, &catalogue->find_form);
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
        status = mus__catalogue_prepare(catalogue, "INSERT INTO form (hash, form) VALUES (?1, ?2)",
                                        SQLITE_PREPARE_PERSISTENT, &catalogue->add_form);
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
    mus_status status = mus__catalogue_prepare(catalogue, sql, SQLITE_PREPARE_PERSISTENT, &catalogue->add);
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
    if (name[mus__utf8_span(name)] != '\0')
        return mus__catalogue_fail(catalogue, MUS_ERR_ARG, "the name is not UTF-8 at byte %zu", mus__utf8_span(name));
    if (!catalogue->writable) return mus__catalogue_fail(catalogue, MUS_ERR_STATE, "open for reading");

    uint8_t *form = NULL, hash[16], *bytes = NULL;
    double *traits = NULL;
    int32_t n = 0, id = MUS_NONE;
    size_t size = 0;
    mus_status status = mus__catalogue_form(context, pattern, &form, &size, hash);
    if (status == MUS_OK) status = mus__traits_of(pattern, &traits, &n);
    if (status == MUS_OK && n > BLOB_BYTES / 8)
        status = mus__catalogue_fail(catalogue, MUS_ERR_LIMIT, "%s has %d traits, at most %d", name, (int)n,
                                     BLOB_BYTES / 8);
    if (status == MUS_OK && size > BLOB_BYTES)
        status = mus__catalogue_fail(catalogue, MUS_ERR_LIMIT, "the canonical form of %s has %zu bytes, at most %d",
                                     name, size, BLOB_BYTES);
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
    /* counting operations is no change of the catalogue; the copy of the pointer says so without a cast */
    mus_catalogue *own;
    memcpy(&own, &catalogue, sizeof own);
    /* count(*) is one operation, however many rows a damaged file seems to have */
    if (catalogue_number(own, "SELECT sum(1) FROM pattern", &count) != MUS_OK) return MUS_NONE;
    return (int32_t)count;
}


mus_status mus_catalogue_name(mus_catalogue *catalogue, int32_t id, const char **name)
{
    if (name != NULL) *name = NULL;
    if (catalogue == NULL) return MUS_ERR_ARG;
    if (name == NULL) return mus__catalogue_fail(catalogue, MUS_ERR_ARG, "name is NULL");
    sqlite3_stmt *statement = NULL;
    mus_status status = mus__catalogue_prepare(catalogue, "SELECT name FROM pattern WHERE id = ?1", 0, &statement);
    if (status != MUS_OK) return status;
    sqlite3_bind_int(statement, 1, id);
    const int code = sqlite3_step(statement);
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
