/*
 * kit.c: digests, and what most rows begin with. See same.h.
 *
 * The digest is FNV-1a of 64 bits over bytes; integers and numbers count as their eight bytes, lowest first.
 */
#include "same.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define FNV_PRIME 0x100000001b3u

/* ends the process of a row */
static void row_fails(const char *what, const char *why)
{
    fprintf(stderr, "%s: %s\n", what, why);
    exit(3);
}


/* ---- digests ---- */

void same_bytes(same_run *run, const void *bytes, size_t count)
{
    const unsigned char *byte = bytes;
    uint64_t h = run->digest;
    for (size_t i = 0; i < count; i++) h = (h ^ byte[i]) * FNV_PRIME;
    run->digest = h;
}


static void same_word(same_run *run, uint64_t word)
{
    unsigned char byte[8];
    for (int i = 0; i < 8; i++) byte[i] = (unsigned char)(word >> (8 * i));
    same_bytes(run, byte, sizeof byte);
}


void same_int(same_run *run, int64_t value)
{
    same_word(run, (uint64_t)value);
}


void same_real(same_run *run, double value)
{
    uint64_t word = UINT64_C(0x7ff8000000000000);
    if (!isnan(value)) memcpy(&word, &value, sizeof word);
    same_word(run, word);
}


void same_text(same_run *run, const char *text)
{
    same_int(run, text != NULL ? (int64_t)strlen(text) : -1);
    if (text != NULL) same_bytes(run, text, strlen(text));
}


void same_ints(same_run *run, const int32_t *values, int64_t count)
{
    same_int(run, count);
    for (int64_t i = 0; i < count; i++) same_int(run, values[i]);
}


void same_reals(same_run *run, const double *values, int64_t count)
{
    same_int(run, count);
    for (int64_t i = 0; i < count; i++) same_real(run, values[i]);
}


void same_file(same_run *run, const char *path)
{
    char block[65536];
    size_t got;
    FILE *file = fopen(path, "rb");
    if (file == NULL) row_fails(path, "cannot be opened");
    while ((got = fread(block, 1, sizeof block, file)) > 0) same_bytes(run, block, got);
    if (ferror(file)) row_fails(path, "cannot be read");
    fclose(file);
}


void same_pattern(same_run *run, const mus_pattern *pattern)
{
    same_must(run, mus_pattern_write(pattern, "pattern.json"), "mus_pattern_write");
    same_file(run, "pattern.json");
}


bool same_status(same_run *run, mus_status status)
{
    same_int(run, status);
    return status == MUS_OK;
}


void same_must(const same_run *run, mus_status status, const char *what)
{
    char why[640];
    if (status == MUS_OK) return;
    snprintf(why, sizeof why, "%s: %s", mus_status_name(status), mus_context_error(run->context));
    row_fails(what, why);
}


/* ---- beginnings ---- */

static const char *joined(const char *folder, const char *file)
{
    const size_t room = strlen(folder) + strlen(file) + 2;
    char *path = malloc(room);
    if (path == NULL) row_fails(file, "no memory");
    else snprintf(path, room, "%s/%s", folder, file);
    return path;
}


const char *same_data(const same_run *run, const char *file)
{
    return joined(run->data, file);
}


const char *same_source(const same_run *run, const char *file)
{
    return joined(run->root, file);
}


mus_tape *same_size(const same_run *run, const char *size)
{
    mus_tape *tape = NULL;
    same_must(run, mus_tape_create(run->context, &tape), "mus_tape_create");
    same_must(run, mus_tape_set_size(tape, size), size);
    same_must(run, mus_tape_complete(tape), size);
    return tape;
}


mus_tape *same_tape(const same_run *run, const char *file, const char *row, bool raw)
{
    mus_tape *tape = NULL;
    same_must(run, mus_tape_read(run->context, same_data(run, file), row, &tape), file);
    if (!raw) same_must(run, mus_tape_complete(tape), file);
    return tape;
}


mus_body *same_body(const same_run *run, const mus_tape *tape)
{
    mus_body *body = NULL;
    same_must(run, mus_body_create(run->context, tape, NULL, &body), "mus_body_create");
    return body;
}


mus_pattern *same_draft(const same_run *run, const char *design, const mus_tape *tape)
{
    mus_pattern *pattern = NULL;
    const int32_t index = mus_design_find(design);
    const mus_status status = index != MUS_NONE
                                  ? mus_design_draft(run->context, index, tape, NULL, &pattern)
                                  : mus_design_draft_words(run->context, design, tape, NULL, &pattern);
    same_must(run, status, design);
    return pattern;
}


/* ---- the list ---- */

same_row *same_add(same_list *list, void (*make)(same_run *run, const void *what, int32_t index), const char *format,
                   ...)
{
    va_list values;
    if (list->count == list->room) {
        list->room = list->room > 0 ? 2 * list->room : 256;
        list->row = realloc(list->row, sizeof *list->row * (size_t)list->room);
        if (list->row == NULL) row_fails("rows", "no memory");
    }
    same_row *row = &list->row[list->count++];
    memset(row, 0, sizeof *row);
    row->make = make;
    va_start(values, format);
    vsnprintf(row->name, sizeof row->name, format, values);
    va_end(values);
    return row;
}
