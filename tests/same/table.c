/*
 * table.c: the committed tables of digests: one row `name digest` a line, sorted by name; the first line names the
 * machine. See same.h.
 */
#include "same.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cairo.h>

#define LINE 256

/* The bytes of a PDF depend on cairo. Nothing else is known to matter: the libraries use IEEE 754 arithmetic and their
 * own functions alone, so compilers, levels, C libraries and processors give the same. */
void same_machine(char *text, size_t size) { snprintf(text, size, "# cairo %s", cairo_version_string()); }


static int by_name(const void *left, const void *right)
{
    const same_row *const *a = left, *const *b = right;
    return strcmp((*a)->name, (*b)->name);
}


/* the row of that name; one without a function when the list has none */
static same_row *row_named(same_list *list, const char *name)
{
    for (int32_t i = 0; i < list->count; i++)
        if (strcmp(list->row[i].name, name) == 0) return &list->row[i];
    return same_add(list, NULL, "%s", name);
}


int same_read(same_list *list, const char *path, const char *machine)
{
    char line[LINE], name[96], digest[24];
    FILE *file = fopen(path, "r");
    if (file == NULL) return 2;
    bool same = fgets(line, sizeof line, file) != NULL;
    line[strcspn(line, "\n")] = '\0';
    same = same && strcmp(line, machine) == 0;
    while (same && fgets(line, sizeof line, file) != NULL)
        if (sscanf(line, "%95s %23s", name, digest) == 2) {
            same_row *row = row_named(list, name);
            snprintf(row->kept, sizeof row->kept, "%s", digest);
        }
    fclose(file);
    return same ? 0 : 1;
}


static bool begins(const char *name, const char *group)
{
    return group != NULL && strncmp(name, group, strlen(group)) == 0;
}


bool same_write(const same_list *list, const char *path, const char *machine, const char *group, const char *but)
{
    const same_row **rows = malloc(sizeof *rows * (size_t)(list->count + 1));
    FILE *file = fopen(path, "w");
    int32_t n = 0;
    if (rows == NULL || file == NULL) return false;
    for (int32_t i = 0; i < list->count; i++) {
        const same_row *row = &list->row[i];
        if (row->make != NULL && (group == NULL || begins(row->name, group)) && !begins(row->name, but))
            rows[n++] = row;
    }
    qsort(rows, (size_t)n, sizeof *rows, by_name);
    fprintf(file, "%s\n", machine);
    for (int32_t i = 0; i < n; i++) {
        const char *digest = rows[i]->found[0] != '\0' ? rows[i]->found : rows[i]->kept;
        if (digest[0] != '\0') fprintf(file, "%s %s\n", rows[i]->name, digest);
    }
    free(rows);
    return fclose(file) == 0;
}
