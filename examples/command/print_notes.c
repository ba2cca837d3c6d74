/*
 * print_notes.c: what the first page of muslin print tells of the garment: measures, fabric, cloth, notions.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "muslin/language.h"
#include "print_notes.h"

/* the measures that name a size of clothes: the primary and secondary dimensions of ISO 8559-2:2017 that a tape has */
static const char *const named[] = {"stature", "bust", "waist", "hip", "neck", "arm", "inleg"};

/* bytes of the line of the measures; chosen: twice the longest of the languages */
#define MEASURES_MOST 1024

/* A text that grows. */
typedef struct notes {
    char *text;
    size_t size;
    bool failed; /* there was no memory */
} notes;


static void notes_add(notes *out, const char *text, size_t size)
{
    char *more = realloc(out->text, out->size + size + 1);
    out->failed = out->failed || more == NULL;
    if (more == NULL) return;
    memcpy(more + out->size, text, size);
    out->text = more;
    out->text[out->size += size] = '\0';
}


/* Writes a row of the table with up to two texts in its places. */
static void fill(int32_t language, const char *key, const char *first, const char *second, char *out, size_t size)
{
    const char *row = mus_language_text(language, key);
    size_t at = 0;
    for (; row != NULL && *row != '\0' && at + 1 < size;) {
        const char *place = strncmp(row, "{0}", 3) == 0 ? first : strncmp(row, "{1}", 3) == 0 ? second : NULL;
        if (place == NULL) {
            out[at++] = *row++;
            continue;
        }
        const size_t n = strlen(place) < size - 1 - at ? strlen(place) : size - 1 - at;
        memcpy(out + at, place, n);
        at += n;
        row += 3;
    }
    out[at] = '\0';
}


/* Adds lengths by the names of their measures: a head, and one line. Those that are not above 0 are left out. */
static void add_lengths(notes *out, const char *key_of_head, const char *const *names, const double *values, size_t n,
                        int32_t language)
{
    char line[MEASURES_MOST] = "";
    size_t at = 0;
    for (size_t i = 0; i < n; i++) {
        char key[64], whole[24], tenth[4], length[48], item[256];
        if (!(values[i] > 0.0)) continue;
        const long tenths = lround(1e3 * values[i]);
        snprintf(whole, sizeof whole, "%ld", tenths / 10);
        snprintf(tenth, sizeof tenth, "%d", (int)(tenths % 10));
        fill(language, "length", whole, tenth, length, sizeof length);
        snprintf(key, sizeof key, "measure.%s", names[i]);
        const char *name = mus_language_text(language, key);
        fill(language, "list.colon", name != NULL ? name : names[i], length, item, sizeof item);
        const char *comma = at > 0 ? mus_language_text(language, "list.semicolon") : "";
        if (at + strlen(comma) + strlen(item) >= sizeof line) break;
        at += (size_t)snprintf(line + at, sizeof line - at, "%s%s", comma, item);
    }
    if (at == 0) return;
    const char *head = mus_language_text(language, key_of_head);
    if (out->size > 0) notes_add(out, "\n", 1);
    notes_add(out, head, strlen(head));
    notes_add(out, "\n", 1);
    notes_add(out, line, at);
    notes_add(out, "\n", 1);
}


/* Adds the measures of the tape, and the fabric that a named design is made for. */
static void add_measures(notes *out, const scene *s, const source *from, int32_t language)
{
    double value[sizeof named / sizeof *named];
    for (size_t i = 0; i < sizeof named / sizeof *named; i++)
        value[i] = mus_tape_value(s->tape, mus_measure_find(named[i]));
    add_lengths(out, "head.drafted", named, value, sizeof named / sizeof *named, language);
    char key[64], line[256];
    const char *fabric = from->design != NULL ? mus_design_fabric(mus_design_find(from->design)) : NULL;
    snprintf(key, sizeof key, "fabric.%s", fabric != NULL ? fabric : "");
    const char *name = mus_language_text(language, key);
    if (fabric == NULL || name == NULL) return;
    fill(language, "notes.made_for", name, "", line, sizeof line);
    notes_add(out, "\n", 1);
    notes_add(out, line, strlen(line));
    notes_add(out, "\n", 1);
}


/* Adds the paragraphs of the instructions that have one of two heads. */
static void add_paragraphs(notes *out, const char *instructions, int32_t language)
{
    const char *const heads[] = {mus_language_text(language, "head.cloth"),
                                 mus_language_text(language, "head.notions")};
    for (const char *at = strstr(instructions, "\n\n"); at != NULL;) {
        const char *from = at + 2, *end = strstr(from, "\n\n");
        const size_t head = strcspn(from, "\n"), size = end != NULL ? (size_t)(end - from) + 1 : strlen(from);
        for (size_t i = 0; i < sizeof heads / sizeof *heads; i++) {
            if (strlen(heads[i]) != head || strncmp(from, heads[i], head) != 0) continue;
            if (out->size > 0) notes_add(out, "\n", 1);
            notes_add(out, from, size);
        }
        at = end;
    }
}


mus_status print_notes(const scene *s, const source *from, int32_t language, char **out)
{
    notes all = {0};
    char *instructions = NULL;
    size_t size = 0;
    *out = NULL;
    if (s->tape != NULL && from->pattern == NULL) add_measures(&all, s, from, language);
    const mus_status status =
        mus_pattern_write_instructions_in_bytes(s->pattern, mus_language_tag(language), NULL, &instructions, &size);
    notes told = {0};
    if (status == MUS_OK) notes_add(&told, instructions, size);
    if (told.text != NULL) add_paragraphs(&all, told.text, language);
    mus_context_alloc(s->context, instructions, 0);
    free(told.text);
    *out = all.text;
    return status == MUS_OK && (all.failed || told.failed) ? MUS_ERR_MEMORY : status;
}
