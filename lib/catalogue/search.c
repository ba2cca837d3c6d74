/*
 * search.c: the searches of a catalogue: the same patterns, the nearest patterns, patterns that contain a part.
 *
 * Exact: an SQLite index finds the hash, the canonical form confirms the match, and patterns are listed by the number
 * of their form. Nearest: the traits of all patterns are kept in memory and read again when the file has changed. They
 * are compared one pattern after another; a comparison stops when the partial distance exceeds the largest one
 * in the list of the nearest. Containing: the traits rule out patterns that have too few panels with the part's numbers
 * of edges; the forms of the others are read and searched.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "catalogue/catalogue_internal.h"


/* ---- the index ---- */

static mus_status search_row(mus_catalogue *catalogue, sqlite3_stmt *statement)
{
    const uint8_t *traits = sqlite3_column_blob(statement, 2);
    int size = sqlite3_column_bytes(statement, 2);
    int64_t room = catalogue->row_room;
    mus_status status = mus__catalogue_reserve(catalogue->context, &catalogue->row, &room, (int64_t)catalogue->nrow + 1,
                                               sizeof *catalogue->row);
    catalogue->row_room = (int32_t)room;
    if (status == MUS_OK)
        status = mus__catalogue_reserve(catalogue->context, &catalogue->pool, &catalogue->pool_room,
                                        catalogue->npool + size / 8 + 1, sizeof *catalogue->pool);
    if (status != MUS_OK) return status;
    mus__row *row = &catalogue->row[catalogue->nrow];
    row->id = sqlite3_column_int(statement, 0);
    row->form = sqlite3_column_int64(statement, 1);
    row->first = catalogue->npool;
    row->n = size / 8;
    if (traits == NULL || !mus__traits_unpack(traits, (size_t)size, catalogue->pool + catalogue->npool))
        return mus__catalogue_fail(catalogue, MUS_ERR_FORMAT, "the traits of pattern %d are damaged", (int)row->id);
    catalogue->npool += row->n;
    catalogue->nrow++;
    return MUS_OK;
}


/* read the index again when the file has changed since the last time */
static mus_status search_refresh(mus_catalogue *catalogue)
{
    sqlite3_stmt *statement = NULL;
    int64_t now = -1;
    mus_status status = mus__catalogue_prepare(catalogue, "PRAGMA data_version", 0, &statement);
    if (status == MUS_OK && sqlite3_step(statement) == SQLITE_ROW) now = sqlite3_column_int64(statement, 0);
    sqlite3_finalize(statement);
    statement = NULL;
    if (now < 0) return mus__catalogue_trouble(catalogue);
    if (now == catalogue->seen && catalogue->edits == catalogue->seen_edits) return MUS_OK;

    catalogue->nrow = 0;
    catalogue->npool = 0;
    catalogue->seen = -1;
    int code = SQLITE_OK;
    status = mus__catalogue_prepare(catalogue, "SELECT id, form, traits FROM pattern ORDER BY id", 0, &statement);
    while (status == MUS_OK && (code = sqlite3_step(statement)) == SQLITE_ROW)
        status = search_row(catalogue, statement);
    if (status == MUS_OK && code != SQLITE_DONE) status = mus__catalogue_trouble(catalogue);
    sqlite3_finalize(statement);
    if (status == MUS_OK) catalogue->seen = now, catalogue->seen_edits = catalogue->edits;
    return status;
}


/* get the form with a number; the bytes are borrowed from `statement`, which the caller finalizes */
static mus_status search_form(mus_catalogue *catalogue, int64_t number, sqlite3_stmt **statement,
                              const uint8_t **form, size_t *size)
{
    const mus_status status =
        mus__catalogue_prepare(catalogue, "SELECT form FROM form WHERE id = ?1", 0, statement);
    if (status != MUS_OK) return status;
    sqlite3_reset(*statement);
    sqlite3_bind_int64(*statement, 1, number);
    int code = sqlite3_step(*statement);
    if (code == SQLITE_DONE)
        return mus__catalogue_fail(catalogue, MUS_ERR_FORMAT, "form %lld is missing", (long long)number);
    if (code != SQLITE_ROW) return mus__catalogue_trouble(catalogue);
    *form = sqlite3_column_blob(*statement, 0);
    *size = (size_t)sqlite3_column_bytes(*statement, 0);
    return MUS_OK;
}


/* ---- exact ---- */

mus_status mus_catalogue_exact(mus_catalogue *catalogue, const mus_pattern *pattern, int32_t *ids, int32_t capacity,
                               int32_t *count)
{
    if (count != NULL) *count = 0;
    if (catalogue == NULL) return MUS_ERR_ARG;
    if (pattern == NULL || (ids != NULL && capacity < 0))
        return mus__catalogue_fail(catalogue, MUS_ERR_ARG, "exact: pattern is NULL, or capacity is %d", (int)capacity);
    uint8_t *form, hash[16];
    size_t size;
    int64_t number = 0;
    int32_t n = 0;
    mus_status status = mus__catalogue_form(catalogue->context, pattern, &form, &size, hash);
    if (status == MUS_OK) status = mus__catalogue_find_form(catalogue, form, size, hash, &number);
    mus_context_alloc(catalogue->context, form, 0);
    if (status != MUS_OK || number == 0) return status;

    sqlite3_stmt *statement = NULL;
    int code = SQLITE_OK;
    status = mus__catalogue_prepare(catalogue, "SELECT id FROM pattern WHERE form = ?1 ORDER BY id", 0, &statement);
    if (status != MUS_OK) return status;
    sqlite3_bind_int64(statement, 1, number);
    while ((code = sqlite3_step(statement)) == SQLITE_ROW) {
        if (ids != NULL && n < capacity) ids[n] = sqlite3_column_int(statement, 0);
        n++;
    }
    if (code != SQLITE_DONE) status = mus__catalogue_trouble(catalogue);
    sqlite3_finalize(statement);
    if (status == MUS_OK && count != NULL) *count = n;
    return status;
}


/* ---- nearest ---- */

/* find the `capacity` nearest rows of the index, nearest first; returns their number */
static int32_t search_scan(const mus_catalogue *catalogue, const double *traits, int32_t capacity, int32_t *rows,
                           double *distances)
{
    int32_t kept = 0;
    double limit = INFINITY, parts[MUS_DISTANCE_COUNT];
    for (int32_t i = 0; i < catalogue->nrow; i++) {
        double d = mus__traits_distance(traits, catalogue->pool + catalogue->row[i].first, limit, parts);
        if (kept == capacity && d >= limit) continue;
        int32_t at = kept < capacity ? kept++ : capacity - 1;
        for (; at > 0 && distances[at - 1] > d; at--) rows[at] = rows[at - 1], distances[at] = distances[at - 1];
        rows[at] = i, distances[at] = d;
        if (kept == capacity) limit = distances[capacity - 1];
    }
    return kept;
}


mus_status mus_catalogue_nearest(mus_catalogue *catalogue, const mus_pattern *pattern, int32_t capacity, int32_t *ids,
                                 double *distances, int32_t *exact, int32_t *count)
{
    if (count != NULL) *count = 0;
    if (catalogue == NULL) return MUS_ERR_ARG;
    if (pattern == NULL || ids == NULL || count == NULL || capacity < 1)
        return mus__catalogue_fail(catalogue, MUS_ERR_ARG, "nearest: pattern, ids or count is NULL, or capacity is %d",
                                   (int)capacity);
    mus_context *context = catalogue->context;
    uint8_t *form = NULL, hash[16];
    double *traits = NULL, *own = NULL;
    size_t size = 0;
    int64_t number = 0;
    int32_t n, kept = 0;
    mus_status status = search_refresh(catalogue);
    if (status == MUS_OK) status = mus__catalogue_form(context, pattern, &form, &size, hash);
    if (status == MUS_OK) status = mus__traits_of(pattern, &traits, &n);
    if (status == MUS_OK) {
        int32_t room = capacity < catalogue->nrow ? capacity : catalogue->nrow;
        own = mus_context_alloc(context, NULL, ((size_t)room + 1) * sizeof *own);
        if (own == NULL) status = mus_context_fail(context, MUS_ERR_MEMORY, "no memory for the nearest patterns");
        if (own != NULL && room > 0) kept = search_scan(catalogue, traits, room, ids, own);
    }

    /* rows of the index to numbers of patterns */
    if (status == MUS_OK) status = mus__catalogue_find_form(catalogue, form, size, hash, &number);
    for (int32_t i = 0; i < kept && status == MUS_OK; i++) {
        const mus__row *row = &catalogue->row[ids[i]];
        if (exact != NULL) exact[i] = row->form == number;
        if (distances != NULL) distances[i] = own[i];
        ids[i] = row->id;
    }
    mus_context_alloc(context, form, 0);
    mus_context_alloc(context, traits, 0);
    mus_context_alloc(context, own, 0);
    if (status == MUS_OK) *count = kept;
    return status;
}


/* ---- explain ---- */

/* format a number with two decimals and a decimal point, in every locale */
static const char *search_number(double value, char *out)
{
    const long long hundredths = fabs(value) < 1e15 ? (long long)floor(value * 100.0 + 0.5) : 0;
    if (fabs(value) < 1e15) snprintf(out, 32, "%lld.%02lld", hundredths / 100, hundredths % 100);
    else snprintf(out, 32, "%.0e", value); /* of a damaged file */
    return out;
}


/* append a line to `text`, cut to the capacity */
static void search_line(char *text, size_t capacity, const char *line)
{
    size_t used = strlen(text), more = strlen(line);
    if (used + 1 >= capacity) return;
    if (used + more + 1 > capacity) more = capacity - used - 1;
    memcpy(text + used, line, more);
    text[used + more] = '\0';
}


/* format the lengths of the first eight openings, ascending: "0.51 0.60 0.60 m" */
static void search_openings(const double *traits, char *out, size_t room)
{
    int32_t n = (int32_t)traits[MUS__TRAIT_OPENINGS];
    char number[32];
    size_t used = 0;
    out[0] = '\0';
    for (int32_t i = 0; i < n && i < 8; i++)
        used += (size_t)snprintf(out + used, room - used, "%s ", search_number(traits[MUS__TRAIT_HEAD + i], number));
    snprintf(out + used, room - used, "%s", n == 0 ? "none" : n > 8 ? "... m" : "m");
}


static void search_text(const double *a, const double *b, const double *parts, char *text, size_t capacity)
{
    static const char *const what[MUS_DISTANCE_COUNT] = {"panels",
                                                         "seams",
                                                         "components, Euler characteristic",
                                                         "openings",
                                                         "panels by size and edges; area",
                                                         "cloth and sewn length"};
    text[0] = '\0';
    for (int32_t k = 0; k < MUS_DISTANCE_COUNT; k++) {
        char line[640], n[4][32], own[2][240];
        if (parts[k] == 0.0) continue;
        if (k == MUS_DISTANCE_OPENINGS) {
            search_openings(a, own[0], sizeof own[0]);
            search_openings(b, own[1], sizeof own[1]);
        } else if (k == MUS_DISTANCE_PIECES || k == MUS_DISTANCE_SEAMS) {
            int32_t t = k == MUS_DISTANCE_PIECES ? MUS__TRAIT_PANELS : MUS__TRAIT_SEAMS;
            snprintf(own[0], sizeof own[0], "%.9g", a[t]);
            snprintf(own[1], sizeof own[1], "%.9g", b[t]);
        } else if (k == MUS_DISTANCE_SURFACE) {
            snprintf(own[0], sizeof own[0], "%.9g, %.9g", a[MUS__TRAIT_PIECES], a[MUS__TRAIT_EULER]);
            snprintf(own[1], sizeof own[1], "%.9g, %.9g", b[MUS__TRAIT_PIECES], b[MUS__TRAIT_EULER]);
        } else {
            const double *side[2] = {a, b};
            for (int32_t i = 0; i < 2; i++)
                snprintf(own[i], sizeof own[i], "%s m2, %s m", search_number(side[i][MUS__TRAIT_CLOTH], n[0]),
                         search_number(side[i][MUS__TRAIT_SEWN], n[1]));
        }
        snprintf(line, sizeof line, "%s %s: %s against %s\n", search_number(parts[k], n[2]), what[k], own[0], own[1]);
        search_line(text, capacity, line);
    }
}


mus_status mus_catalogue_explain(mus_catalogue *catalogue, const mus_pattern *pattern, int32_t id, double *parts,
                                 char *text, size_t capacity)
{
    if (catalogue == NULL) return MUS_ERR_ARG;
    if (pattern == NULL) return mus__catalogue_fail(catalogue, MUS_ERR_ARG, "explain: pattern is NULL");
    double *traits = NULL, own[MUS_DISTANCE_COUNT] = {0};
    int32_t n, i = 0;
    mus_status status = search_refresh(catalogue);
    if (status != MUS_OK) return status;
    while (i < catalogue->nrow && catalogue->row[i].id != id) i++;
    if (i == catalogue->nrow) return mus__catalogue_fail(catalogue, MUS_ERR_ARG, "pattern %d is unknown", (int)id);
    status = mus__traits_of(pattern, &traits, &n);
    if (status != MUS_OK) return status;
    const double *other = catalogue->pool + catalogue->row[i].first;
    mus__traits_distance(traits, other, INFINITY, own);
    if (parts != NULL) memcpy(parts, own, sizeof own);
    if (text != NULL && capacity > 0) search_text(traits, other, own, text, capacity);
    mus_context_alloc(catalogue->context, traits, 0);
    return MUS_OK;
}


/* ---- containing ---- */

/* does the whole have, for each number of edges, at least as many panels as the part? Both are traits */
static bool search_may_contain(const double *part, const double *whole)
{
    int32_t n = (int32_t)part[MUS__TRAIT_PANELS], m = (int32_t)whole[MUS__TRAIT_PANELS];
    const double *a = part + MUS__TRAIT_HEAD + (int32_t)part[MUS__TRAIT_OPENINGS] + 2;
    const double *b = whole + MUS__TRAIT_HEAD + (int32_t)whole[MUS__TRAIT_OPENINGS] + 2;
    for (int32_t i = 0; i < n; i++) {
        int32_t need = 0, have = 0;
        for (int32_t j = 0; j < n; j++) need += a[3 * j] == a[3 * i];
        for (int32_t j = 0; j < m; j++) have += b[3 * j] == a[3 * i];
        if (have < need) return false;
    }
    return true;
}


mus_status mus_catalogue_containing(mus_catalogue *catalogue, const mus_pattern *part, int32_t *ids, int32_t capacity,
                                    int32_t *count)
{
    if (count != NULL) *count = 0;
    if (catalogue == NULL) return MUS_ERR_ARG;
    if (part == NULL || (ids != NULL && capacity < 0))
        return mus__catalogue_fail(catalogue, MUS_ERR_ARG, "containing: part is NULL, or capacity is %d",
                                   (int)capacity);
    uint8_t *form = NULL, hash[16];
    double *traits = NULL;
    size_t size = 0;
    int32_t n, found = 0;
    sqlite3_stmt *statement = NULL;
    mus_status status = search_refresh(catalogue);
    if (status == MUS_OK) status = mus__catalogue_form(catalogue->context, part, &form, &size, hash);
    if (status == MUS_OK) status = mus__traits_of(part, &traits, &n);
    for (int32_t i = 0; i < catalogue->nrow && status == MUS_OK; i++) {
        const mus__row *row = &catalogue->row[i];
        const uint8_t *other = NULL;
        size_t other_size = 0;
        bool inside = false;
        if (!search_may_contain(traits, catalogue->pool + row->first)) continue;
        status = search_form(catalogue, row->form, &statement, &other, &other_size);
        if (status == MUS_OK) status = mus__part_inside(catalogue->context, form, size, other, other_size, &inside);
        if (status != MUS_OK || !inside) continue;
        if (ids != NULL && found < capacity) ids[found] = row->id;
        found++;
    }
    sqlite3_finalize(statement);
    mus_context_alloc(catalogue->context, form, 0);
    mus_context_alloc(catalogue->context, traits, 0);
    if (status == MUS_OK && count != NULL) *count = found;
    return status;
}
