/* fuzz_batch.c: what `muslin dress --batch` reads: the list, and the part of a garment that an earlier run has left. */
#define _POSIX_C_SOURCE 200809L /* mkdtemp */
#include "fuzz.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "command/batch.h"

#define KEY UINT64_C(0x0123456789abcdef) /* that the seed part has */


/* a name stays in its folder, and is that of one garment */
static void check_names(const batch *b)
{
    for (int32_t i = 0; i < b->count; i++) {
        const batch_line *g = &b->line[i];
        fuzz_must((g->name[0] != '\0') == (g->fault[0] == '\0'), "a line has a name or a fault");
        fuzz_must(strchr(g->name, '/') == NULL && g->name[0] != '.', "a name stays in its folder");
        for (int32_t k = 0; k < i && g->name[0] != '\0'; k++)
            fuzz_must(strcmp(b->line[k].name, g->name) != 0, "a name is that of one garment");
    }
}


static void write_file(const char *path, const char *first, const uint8_t *bytes, size_t size)
{
    FILE *file = fopen(path, "wb");
    fuzz_must(file != NULL && fputs(first, file) >= 0 && fwrite(bytes, 1, size, file) == size && fclose(file) == 0,
              "a file is written");
}


void fuzz_batch(const uint8_t *bytes, size_t size)
{
    char folder[FUZZ_PATH], parts[FUZZ_PATH + 8], list[FUZZ_PATH + 8], path[FUZZ_PATH + 16];
    complaints said;
    batch b = {.part = size % 2 ? "1/2" : NULL, .program = 1};
    batch_line g = {.name = "part", .key = KEY};
    batch_part part;
    fuzz_path(folder);
    fuzz_must(mkdtemp(folder) != NULL, "a folder is made");
    snprintf(parts, sizeof parts, "%s/parts", folder);
    snprintf(list, sizeof list, "%s/list", folder);
    snprintf(path, sizeof path, "%s/part", parts);
    fuzz_must(mkdir(parts, 0777) == 0, "a folder is made");
    write_file(list, "--design skirt --size W40 --name first\n", bytes, size); /* so that the list is never empty */
    write_file(path, "", bytes, size);
    b.list = list;
    b.folder = folder;
    dress_init(&b.all);
    complaints_keep(&said);
    if (batch_read(&b) == EXIT_DONE) check_names(&b);
    complaints_keep(NULL);
    batch_free(&b);
    if (batch_part_read(&b, &g, &part)) {
        fuzz_must(strchr(part.result, '\n') == NULL && strchr(part.times, '\n') == NULL, "results have a line each");
        fuzz_must(strlen(part.status) < sizeof part.status, "a status is a word");
        free(part.result);
    }
    unlink(path);
    unlink(list);
    rmdir(parts);
    rmdir(folder);
}
