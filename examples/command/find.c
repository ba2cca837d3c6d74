/*
 * find.c: muslin catalogue, which adds patterns to a catalogue file, and muslin find, which searches one by how the
 * patterns are sewn.
 */
#include <stdio.h>
#include <string.h>

#include "commands.h"
#include "json.h"
#include "muslin/catalogue.h"
#include "scene.h"

/* patterns added by one transaction; chosen: each transaction waits once for the disk */
#define ADD_AT_ONCE 100
#define FIND_MOST 1000


/* Writes the name of a file without its folder, its extension and GarmentCode's suffix. */
static void plain_name(const char *path, char *out, size_t room)
{
    static const char *const ends[] = {".json", "_specification"};
    const char *slash = strrchr(path, '/');
    snprintf(out, room, "%s", slash != NULL ? slash + 1 : path);
    for (size_t i = 0; i < sizeof ends / sizeof ends[0]; i++) {
        const size_t n = strlen(out), m = strlen(ends[i]);
        if (n > m && strcmp(out + n - m, ends[i]) == 0) out[n - m] = '\0';
    }
}


/* Adds one file. When it cannot be read or added, prints a line; the other files are added. */
static int add_file(const scene *s, mus_catalogue *catalogue, const char *path)
{
    char name[1024];
    mus_pattern *pattern;
    plain_name(path, name, sizeof name);
    mus_status status = mus_pattern_read(s->context, path, &pattern);
    if (status == MUS_OK) status = mus_catalogue_add(catalogue, pattern, name, NULL);
    mus_pattern_destroy(pattern);
    return status == MUS_OK ? EXIT_DONE : scene_fail(s, status);
}


int command_catalogue(int argc, char **argv)
{
    if (argc >= 1 && (strcmp(argv[0], "--help") == 0 || strcmp(argv[0], "-h") == 0)) {
        printf("usage: muslin catalogue add CATALOGUE.db FILE...\n\nKeep patterns in a catalogue, each under the name "
               "of its file; one of that name is replaced.\n");
        return EXIT_DONE;
    }
    if (argc < 3 || strcmp(argv[0], "add") != 0)
        return complain(EXIT_INPUT, "catalogue", "expected: add CATALOGUE.db FILE...");

    scene s;
    mus_catalogue *catalogue = NULL;
    int code = scene_open(&s, "catalogue");
    if (code == EXIT_DONE) {
        const mus_status status = mus_catalogue_open(s.context, argv[1], MUS_CATALOGUE_WRITE, &catalogue);
        if (status != MUS_OK) code = scene_fail(&s, status);
    }
    for (int i = 2; i < argc && catalogue != NULL; i += ADD_AT_ONCE) {
        mus_status status = mus_catalogue_begin(catalogue);
        for (int k = i; k < argc && k < i + ADD_AT_ONCE && status == MUS_OK; k++) {
            const int one = add_file(&s, catalogue, argv[k]);
            if (code == EXIT_DONE) code = one;
        }
        if (status == MUS_OK) status = mus_catalogue_commit(catalogue);
        if (status == MUS_OK) continue;
        code = scene_fail(&s, status);
        break;
    }
    mus_catalogue_destroy(catalogue);
    scene_close(&s);
    return code;
}


/* The patterns found, the nearest first, and their distances. */
typedef struct finds {
    int32_t count, id[FIND_MOST], exact[FIND_MOST];
    double distance[FIND_MOST];
} finds;


static mus_status find_all(mus_catalogue *catalogue, const mus_pattern *pattern, bool part, int32_t most, finds *f)
{
    if (!part) return mus_catalogue_nearest(catalogue, pattern, most, f->id, f->distance, f->exact, &f->count);
    mus_status status = mus_catalogue_containing(catalogue, pattern, f->id, most, &f->count);
    if (f->count > most) f->count = most;
    for (int32_t i = 0; i < f->count && status == MUS_OK; i++) {
        double parts[MUS_DISTANCE_COUNT];
        status = mus_catalogue_explain(catalogue, pattern, f->id[i], parts, NULL, 0);
        for (int32_t k = 0; k < MUS_DISTANCE_COUNT && status == MUS_OK; k++) f->distance[i] += parts[k];
    }
    return status;
}


static mus_status find_print(mus_catalogue *catalogue, const mus_pattern *pattern, const finds *f, bool why,
                             bool as_json)
{
    json j = {0};
    mus_status status = MUS_OK;
    json_open(&j, NULL, '[');
    for (int32_t i = 0; i < f->count && status == MUS_OK; i++) {
        const char *name;
        char text[2048] = "";
        status = mus_catalogue_explain(catalogue, pattern, f->id[i], NULL, text, sizeof text);
        if (status == MUS_OK) status = mus_catalogue_name(catalogue, f->id[i], &name);
        if (status != MUS_OK) break;
        if (!as_json) print_line("%8.3f %s %s", f->distance[i], f->exact[i] ? "=" : " ", name);
        for (const char *line = text; why && !as_json && *line != '\0'; line += strcspn(line, "\n") + 1)
            printf("             %.*s\n", (int)strcspn(line, "\n"), line);
        json_open(&j, NULL, '{');
        json_text(&j, "name", name);
        json_number(&j, "distance", f->distance[i]);
        json_bool(&j, "exact", f->exact[i] != 0);
        if (why) json_text(&j, "why", text);
        json_close(&j, '}');
    }
    json_close(&j, ']');
    if (status == MUS_OK && as_json && !json_write(&j, "find", "-")) status = MUS_ERR_FILE;
    json_free(&j);
    return status;
}


int command_find(int argc, char **argv)
{
    const char *like = NULL, *in = NULL;
    bool part = false, why = false, as_json = false;
    double most = 10;
    const option options[] = {
        {"--like", OPTION_TEXT, &like, 0, 0, "PATTERN  a pattern: muslin .json or GarmentCode specification"},
        {"--in", OPTION_TEXT, &in, 0, 0, "CATALOGUE.db  the catalogue"},
        {"--count", OPTION_WHOLE, &most, 1, FIND_MOST, "N  largest number of results, default 10"},
        {"--part", OPTION_FLAG, &part, 0, 0, "find patterns that contain the given one"},
        {"--why", OPTION_FLAG, &why, 0, 0, "print the parts of the distance"},
        {"--json", OPTION_STDOUT, &as_json, 0, 0, "as JSON"},
        {NULL, OPTION_FLAG, NULL, 0, 0, NULL}};
    if (!args_read("find", "Find patterns of a catalogue by how they are sewn together.", options, argc, argv))
        return EXIT_INPUT;
    if (like == NULL || in == NULL)
        return complain(EXIT_INPUT, "find", "--like PATTERN and --in CATALOGUE.db are needed");

    scene s;
    static finds f;
    mus_catalogue *catalogue = NULL;
    const source from = {.pattern = like};
    int code = scene_open(&s, "find");
    if (code == EXIT_DONE) code = scene_pattern(&s, &from);
    if (code == EXIT_DONE) {
        mus_status status = mus_catalogue_open(s.context, in, MUS_CATALOGUE_READ, &catalogue);
        if (status == MUS_OK) status = find_all(catalogue, s.pattern, part, (int32_t)most, &f);
        if (status == MUS_OK) status = find_print(catalogue, s.pattern, &f, why, as_json);
        if (status != MUS_OK) code = scene_fail(&s, status);
    }
    mus_catalogue_destroy(catalogue);
    scene_close(&s);
    return code;
}
